// Any bytes as a picture with a scene inside: a scene, or an Error. The checksums of chunks are
// made right first, or nothing but them would be tested.
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "base/error.h"
#include "export/pictures/scene_png.h"
#include "fuzz/png_bytes.h"
#include "scene/toml/scene_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace saddle;
  std::string bytes(reinterpret_cast<const char*>(data), size);
  repair_png_checksums(bytes);
  try {
    const std::optional<std::string> text = scene_in_png(bytes, "a.png");
    if (text) read_scene({"a.png", *text});
  } catch (const Error& error) {
    format_error(error);
  }
  return 0;
}
