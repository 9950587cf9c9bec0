// PNG files, through libpng.
#pragma once

#include <cstdint>
#include <filesystem>
#include <iosfwd>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "base/image.h"

namespace saddle {

/// Text chunks: keyword (1 to 79 Latin-1 characters) to UTF-8 text.
using PngText = std::map<std::string, std::string>;

/// Writes `image` as PNG: RGB where every pixel is opaque, RGBA otherwise. `text` goes into iTXt
/// chunks before the pixels. The same bytes for the same input: no time stamp. Pixels are packed on
/// up to `threads` threads (0: all of the machine's).
void write_png(std::ostream& out, const Image& image, const PngText& text = {},
               unsigned threads = 0);

struct PngFile {
  Image image;
  PngText text;
};

/// Reads any PNG as 8-bit RGBA, with its text chunks. Throws Error: Machine if the file cannot be
/// opened, Input if it is no PNG or is damaged.
PngFile read_png(const std::filesystem::path& path);

/// The bytes are those of a PNG file, damaged or not.
bool is_png(std::string_view bytes);

/// The same of a file's bytes; messages call it `name`.
PngFile decode_png(const std::string& bytes, const std::string& name);

/// Pixels across and down, as the begin of a PNG file's bytes says.
struct PngSize {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
};

/// Nothing for bytes that end before it.
std::optional<PngSize> size_of_png(std::string_view bytes);

}  // namespace saddle
