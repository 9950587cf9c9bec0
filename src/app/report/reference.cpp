#include "app/report/reference.h"

#include <ostream>
#include <utility>

#include "base/error.h"
#include "base/file.h"
#include "base/format.h"
#include "base/image_compare.h"
#include "base/image_png.h"

namespace saddle {
namespace {

std::string figures(const ImageDifference& difference, double threshold) {
  return formatted("error %.4g (threshold %.4g), largest difference %.4g, mean %.4g, SSIM %.4g",
                   difference.error, threshold, difference.largest, difference.mean,
                   difference.ssim);
}

std::string size_of(const Image& image) {
  return std::to_string(image.width) + "x" + std::to_string(image.height);
}

}  // namespace

ReferenceCheck::ReferenceCheck(std::string path, double threshold)
    : path_(std::move(path)), threshold_(threshold), reference_(read_png(path_).image) {}

std::string ReferenceCheck::compare() const {
  const ImageDifference difference = compare_images(picture_, reference_);
  const std::string text = figures(difference, threshold_);
  const bool same_size = picture_.width == reference_.width && picture_.height == reference_.height;
  if (same_size && difference.error <= threshold_) return path_ + ": " + text;
  const std::string diff_path = path_ + ".diff.png";
  const Image picture = difference_image(picture_, reference_);
  write_file_whole(diff_path, [&picture](std::ostream& out) { write_png(out, picture); });
  std::string message = "the picture differs from " + path_ + ": " + text;
  if (!same_size) {
    message += ", sizes " + size_of(picture_) + " and " + size_of(reference_);
  }
  throw Error(Status::Machine, message, {}, "see " + diff_path);
}

}  // namespace saddle
