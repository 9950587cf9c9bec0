// Any text as a scene file: it becomes a scene that is written and read back the same, or an Error
// with a place inside the text.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "base/error.h"
#include "scene/toml/scene_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace saddle;
  const std::string text(reinterpret_cast<const char*>(data), size);
  try {
    const std::string written = write_scene(read_scene({"scene.toml", text}));
    if (write_scene(read_scene({"again.toml", written})) != written) std::abort();
  } catch (const Error& error) {
    const Place& place = error.place();
    if (!place.where.starts_with("scene.toml:")) std::abort();  // what it writes must be right
    if (place.span.begin > place.span.end || place.span.end > text.size()) std::abort();
    format_error(error);
  }
  return 0;
}
