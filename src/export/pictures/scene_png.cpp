#include "export/pictures/scene_png.h"

#include "base/image_png.h"
#include "scene/toml/scene_file.h"

namespace saddle {
namespace {

/// The keyword of the text chunk that holds the scene.
constexpr const char* kSceneKeyword = "saddle-scene";

}  // namespace

void write_scene_png(std::ostream& out, const PictureContent& content) {
  write_png(out, content.image, {{kSceneKeyword, write_scene(content.scene)}}, content.threads);
}

std::optional<std::string> scene_in_png(const std::string& bytes, const std::string& name) {
  // Pixels need not be decoded where no chunk has the keyword, which is never compressed.
  if (is_png(bytes) && bytes.find(kSceneKeyword) == std::string::npos) return std::nullopt;
  const PngText text = decode_png(bytes, name).text;
  const auto found = text.find(kSceneKeyword);
  if (found == text.end()) return std::nullopt;
  return found->second;
}

}  // namespace saddle
