// Any bytes as a texture inside of a scene's text: a picture that is written back as it was, or an
// Error. The first byte chooses whether the text of the picture is damaged as well.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "base/base64.h"
#include "base/error.h"
#include "fuzz/png_bytes.h"
#include "scene/model/texture.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace saddle;
  if (size == 0) return 0;
  std::string bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
  repair_png_checksums(bytes);
  std::string name = "data:image/png;base64," + base64_of(bytes);
  const bool is_damaged = data[0] != 0;
  if (is_damaged) name[data[0] % name.size()] = static_cast<char>(data[0]);
  try {
    const Texture texture = read_scene_texture("--texture", name, "nowhere");
    if (!is_damaged && texture_text(texture) != name) std::abort();
  } catch (const Error& error) {
    format_error(error);
  }
  return 0;
}
