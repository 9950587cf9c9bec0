// Any bytes as a mesh, page or figure that carries a scene: a scene, or an Error. SADDLE_CARRIER is
// the extension of the format; each has a program of its own.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <string>

#include "base/error.h"
#include "export/formats/formats.h"
#include "scene/toml/scene_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace saddle;
  static const Format* const format = find_format(SADDLE_CARRIER);
  if (format == nullptr || format->scene_in == nullptr) std::abort();
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  const std::string name = "a." SADDLE_CARRIER;
  try {
    const std::optional<std::string> text = format->scene_in(bytes, name);
    if (text) read_scene({name, *text});
  } catch (const Error& error) {
    format_error(error);
  }
  return 0;
}
