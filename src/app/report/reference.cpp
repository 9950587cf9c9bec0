#include "app/report/reference.h"

#include <algorithm>
#include <filesystem>
#include <ostream>
#include <utility>

#include "base/error.h"
#include "base/file.h"
#include "base/format.h"
#include "base/image_compare.h"
#include "base/image_png.h"

namespace saddle {
namespace {

std::string size_of(const Image& image) {
  return std::to_string(image.width) + "x" + std::to_string(image.height);
}

}  // namespace

bool is_input(const CommandLine& line, const std::string& path) {
  const auto is_same = [&](const std::string& input) {
    std::error_code ignored;  // what cannot be looked up is no such file
    return std::filesystem::equivalent(path, input, ignored);
  };
  return is_same(line.run.reference) || std::ranges::any_of(line.arguments(), is_same);
}

void remove_results_of_comparison(const CommandLine& line) {
  if (line.run.reference.empty()) return;
  for (const std::string& path : {difference_path(line.run.reference), line.run.report}) {
    std::error_code ignored;  // what cannot be removed is reported by the writing
    const bool is_file = std::filesystem::is_regular_file(path, ignored);
    if (is_file && !is_input(line, path)) std::filesystem::remove(path, ignored);
  }
}

std::string difference_path(const std::string& reference) {
  return reference.empty() ? "" : reference + ".diff.png";
}

ReferenceCheck::ReferenceCheck(std::string path, double threshold)
    : path_(std::move(path)), threshold_(threshold) {
  std::error_code ignored;  // what cannot be looked up is reported by the reading
  if (!std::filesystem::exists(path_, ignored)) {
    throw Error(Status::Input, "there is no file " + path_,
                {"--reference", path_, {0, path_.size()}},
                "the picture to compare with is a PNG file, which -o FILE.png writes");
  }
  reference_ = read_png(path_).image;
}

std::string ReferenceCheck::compare() const {
  const bool same_size = picture_.width == reference_.width && picture_.height == reference_.height;
  const ImageDifference difference = compare_images(picture_, reference_);
  if (same_size && difference.error <= threshold_) {
    return path_ + formatted(": difference %.3g, threshold %.3g", difference.error, threshold_);
  }
  const std::string diff_path = difference_path(path_);
  const Image picture = difference_image(picture_, reference_);
  write_file_whole(diff_path, [&picture](std::ostream& out) { write_png(out, picture); });
  const std::string how =
      same_size ? formatted("the difference is %.3g around pixel %d,%d, the threshold %.3g",
                            difference.error, difference.x, difference.y, threshold_)
                : "it has " + size_of(picture_) + " pixels, not " + size_of(reference_);
  throw Error(Status::Machine, "the picture differs from " + path_ + ": " + how, {},
              diff_path + " shows in red where");
}

}  // namespace saddle
