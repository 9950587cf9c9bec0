// Any bytes as a picture with a scene inside: a scene, or an Error. The checksums of chunks are
// made right first, or nothing but them would be tested.
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include <zlib.h>

#include "base/error.h"
#include "base/image_png.h"
#include "export/pictures/scene_png.h"
#include "scene/toml/scene_file.h"

namespace {

std::size_t number_at(const std::string& bytes, std::size_t at) {
  std::size_t number = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    number = number << 8 | static_cast<unsigned char>(bytes[at + i]);
  }
  return number;
}

/// A chunk: its length, its kind, its data and a checksum of both.
void repair_checksums(std::string& bytes) {
  constexpr std::size_t kSignature = 8;
  constexpr std::size_t kAround = 12;
  for (std::size_t at = kSignature; at + kAround <= bytes.size();) {
    const std::size_t length = number_at(bytes, at);
    if (length > bytes.size() - at - kAround) return;
    const auto* const data = reinterpret_cast<const unsigned char*>(bytes.data()) + at + 4;
    const unsigned long sum = crc32(0, data, static_cast<unsigned>(length + 4));
    for (std::size_t i = 0; i < 4; ++i) {
      bytes[at + 8 + length + i] = static_cast<char>(sum >> (24 - 8 * i) & 0xFF);
    }
    at += kAround + length;
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace saddle;
  std::string bytes(reinterpret_cast<const char*>(data), size);
  repair_checksums(bytes);
  try {
    const std::optional<std::string> text = scene_in_png(bytes, "a.png");
    if (text) read_scene({"a.png", *text});
  } catch (const Error& error) {
    format_error(error);
  }
  return 0;
}
