#include "export/formats/load_scene.h"

#include <optional>
#include <string>

#include "base/error.h"
#include "base/file.h"
#include "export/formats/formats.h"
#include "scene/toml/scene_file.h"

namespace saddle {

bool has_scene_extension(const std::filesystem::path& path) {
  const Format* const format = find_format(extension_of(path));
  return format != nullptr && format->carries_scene();
}

namespace {

/// The scene in a file's bytes; messages call the file `name`.
Scene scene_of(const std::string& bytes, const std::string& name, const Format* format,
               const std::optional<Theme>& theme) {
  if (format != nullptr && format->scene_in != nullptr) {
    const std::optional<std::string> text = format->scene_in(bytes, name);
    if (text) return read_scene({name, *text}, theme);
    throw Error(Status::Input, name + " holds no scene", {},
                "a file keeps its scene until another program saves it");
  }
  if (format != nullptr && !format->carries_scene()) {
    throw Error(Status::Input, name + " holds no scene", {},
                "." + std::string(format->extension) +
                    " has no room for one; these have: " + scene_extension_list());
  }
  if (bytes.size() > kMaxTomlBytes) {
    throw Error(Status::Input, name + " is larger than 4 MiB", {},
                "a scene file is shorter; saddle show torus prints one");
  }
  return read_scene({name, bytes}, theme);
}

}  // namespace

Scene load_scene(const std::filesystem::path& path, const std::optional<Theme>& theme) {
  std::error_code ignored;  // what cannot be looked up is reported by the reading
  if (!std::filesystem::exists(path, ignored)) {
    throw Error(Status::Input, "there is no file " + path.string(), {},
                "saddle list names the surfaces of the gallery");
  }
  return scene_of(read_file(path), path.string(), find_format(extension_of(path)), theme);
}

Scene load_standard_input(const std::optional<Theme>& theme) {
  const std::string bytes = read_standard_input();
  const std::string name = "standard input";
  if (bytes.empty()) {
    throw Error(Status::Input, name + " is empty", {},
                "for example saddle show torus | saddle - -o torus.png");
  }
  return scene_of(bytes, name, format_of_bytes(bytes), theme);
}

}  // namespace saddle
