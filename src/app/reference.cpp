#include "app/reference.h"

#include <ostream>

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

std::string check_against_reference(const Image& image, const Image& reference,
                                    const std::string& path, double threshold) {
  const ImageDifference difference = compare_images(image, reference);
  const std::string text = figures(difference, threshold);
  const bool same_size = image.width == reference.width && image.height == reference.height;
  if (same_size && difference.error <= threshold) return path + ": " + text;
  const std::string diff_path = path + ".diff.png";
  const Image picture = difference_image(image, reference);
  write_file_whole(diff_path, [&picture](std::ostream& out) { write_png(out, picture); });
  std::string message = "the picture differs from " + path + ": " + text;
  if (!same_size) {
    message += ", sizes " + size_of(image) + " and " + size_of(reference);
  }
  throw Error(Status::Machine, message, {}, "see " + diff_path);
}

}  // namespace saddle
