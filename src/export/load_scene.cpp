#include "export/load_scene.h"

#include <optional>
#include <string>

#include "base/error.h"
#include "base/file.h"
#include "export/formats.h"
#include "scene/toml/scene_file.h"

namespace saddle {

bool has_scene_extension(const std::filesystem::path& path) {
  const Format* const format = find_format(extension_of(path));
  return format != nullptr && format->carries_scene();
}

Scene load_scene(const std::filesystem::path& path) {
  std::error_code ignored;  // what cannot be looked up is reported by the reading
  if (!std::filesystem::exists(path, ignored)) {
    throw Error(Status::Input, "there is no file " + path.string(), {},
                "saddle list names the surfaces of the gallery");
  }
  const Format* const format = find_format(extension_of(path));
  if (format != nullptr && format->scene_in != nullptr) {
    const std::optional<std::string> text = format->scene_in(path);
    if (text) return read_scene({path.string(), *text});
    throw Error(Status::Input, path.string() + " holds no scene", {},
                "pictures that saddle has made do, unless another program saved them again");
  }
  if (std::filesystem::file_size(path, ignored) > kMaxTomlBytes) {
    throw Error(Status::Input, path.string() + " is larger than 4 MiB", {}, "is this a scene?");
  }
  return read_scene({path.string(), read_file(path)});
}

}  // namespace saddle
