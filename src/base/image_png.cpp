#include "base/image_png.h"

#include <png.h>

#include <algorithm>
#include <array>
#include <csetjmp>
#include <cstdio>
#include <cstring>
#include <memory>
#include <ostream>
#include <string_view>
#include <utility>
#include <vector>

#include "base/error.h"
#include "base/file.h"
#include "base/png_pixels.h"

// libpng is C and reports an error by a longjmp, over whose frames no C++ object with a destructor
// may lie and no exception may pass. So encode() and decode_...() below, which call setjmp, and
// the callbacks hold plain values only; what owns memory is in their callers' frames.

namespace saddle {
namespace {

// Bounds for files from elsewhere.
constexpr png_uint_32 kLargestSide = 16384;  ///< also the largest picture that we write
constexpr png_uint_32 kMostTextChunks = 128;
constexpr png_alloc_size_t kLargestChunk = 4 << 20;  ///< bytes of a text chunk, unpacked
/// Deflate packs no more than 258 bytes into 2 bits. A header that promises more pixels than the
/// file could hold is refused before memory is spent on them.
constexpr std::size_t kLargestExpansion = 1032;

/// The message of libpng's last error.
using Message = std::array<char, 200>;

[[noreturn]] void on_error(png_structp png, png_const_charp text) {
  auto& message = *static_cast<Message*>(png_get_error_ptr(png));
  std::snprintf(message.data(), message.size(), "%s", text);
  png_longjmp(png, 1);
}

void on_warning(png_structp, png_const_charp) {}

// ---- Writing ----

struct PngWriter {
  Message message{};
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &message, on_error, on_warning);
  png_infop info = png == nullptr ? nullptr : png_create_info_struct(png);

  PngWriter() = default;
  ~PngWriter() { png_destroy_write_struct(&png, &info); }
  PngWriter(const PngWriter&) = delete;
  PngWriter& operator=(const PngWriter&) = delete;
};

/// True if the stream took the bytes; its exceptions end here.
bool put(std::ostream& out, const png_byte* data, std::size_t size) noexcept {
  try {
    out.write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
    return out.good();
  } catch (...) {
    return false;
  }
}

void on_write(png_structp png, png_bytep data, std::size_t size) {
  auto& out = *static_cast<std::ostream*>(png_get_io_ptr(png));
  if (!put(out, data, size)) png_error(png, "the stream does not take the data");
}

void on_flush(png_structp) {}

constexpr std::array<png_byte, 5> kPixelChunk{'I', 'D', 'A', 'T'};
constexpr std::array<png_byte, 5> kEndChunk{'I', 'E', 'N', 'D'};

/// The contents of the file, in their order.
struct Contents {
  const Image& image;
  bool opaque;
  std::vector<png_text> text;
  std::vector<std::string> pixels;
};

/// False if libpng found an error, which is then in the writer's message.
bool encode(const PngWriter& writer, Contents& contents) {
  const png_structp png = writer.png;
  const png_infop info = writer.info;
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  const Image& image = contents.image;
  png_set_user_limits(png, kLargestSide, kLargestSide);
  png_set_IHDR(png, info, static_cast<png_uint_32>(image.width),
               static_cast<png_uint_32>(image.height), 8,
               contents.opaque ? PNG_COLOR_TYPE_RGB : PNG_COLOR_TYPE_RGBA, PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_set_text(png, info, contents.text.data(), static_cast<int>(contents.text.size()));
  png_write_info(png, info);
  for (const std::string& part : contents.pixels) {
    png_write_chunk(png, kPixelChunk.data(), reinterpret_cast<png_const_bytep>(part.data()),
                    part.size());
  }
  png_write_chunk(png, kEndChunk.data(), nullptr, 0);
  return true;
}

/// libpng's view of the text, which must outlive it. libpng does not write to it, whatever its
/// types say.
std::vector<png_text> text_chunks(const PngText& text) {
  std::vector<png_text> chunks;
  for (const auto& [key, value] : text) {
    png_text chunk{};
    chunk.compression = PNG_ITXT_COMPRESSION_NONE;
    chunk.key = const_cast<char*>(key.c_str());
    chunk.text = const_cast<char*>(value.c_str());
    chunk.itxt_length = value.size();
    chunks.push_back(chunk);
  }
  return chunks;
}

// ---- Reading ----

struct Reader {
  std::string_view rest;  ///< of the file
  std::size_t file_bytes;
  Message message{};
  png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &message, on_error, on_warning);
  png_infop info = png == nullptr ? nullptr : png_create_info_struct(png);

  explicit Reader(std::string_view file) : rest(file), file_bytes(file.size()) {}
  ~Reader() { png_destroy_read_struct(&png, &info, nullptr); }
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;
};

void on_read(png_structp png, png_bytep data, std::size_t size) {
  auto& reader = *static_cast<Reader*>(png_get_io_ptr(png));
  if (size > reader.rest.size()) png_error(png, "the file ends too early");
  std::memcpy(data, reader.rest.data(), size);
  reader.rest.remove_prefix(size);
}

/// Reads up to the pixels and asks libpng for RGBA. The size comes back in `width` and `height`.
bool decode_header(Reader& reader, png_uint_32& width, png_uint_32& height) {
  const png_structp png = reader.png;
  const png_infop info = reader.info;
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  png_set_read_fn(png, &reader, on_read);
  png_set_user_limits(png, kLargestSide, kLargestSide);
  // A text that has changed by accident is no other text.
  png_set_crc_action(png, PNG_CRC_DEFAULT, PNG_CRC_ERROR_QUIT);
  png_set_chunk_cache_max(png, kMostTextChunks);
  png_set_chunk_malloc_max(png, kLargestChunk);
  png_read_info(png, info);
  width = png_get_image_width(png, info);
  height = png_get_image_height(png, info);
  if (png_get_rowbytes(png, info) * height / kLargestExpansion > reader.file_bytes) {
    png_error(png, "the file is too short for its pixels");
  }
  png_set_expand(png);    // palettes to RGB, few bits to 8, a transparent colour to alpha
  png_set_scale_16(png);  // rounds, where png_set_strip_16 would cut
  png_set_gray_to_rgb(png);
  png_set_add_alpha(png, 0xFF, PNG_FILLER_AFTER);
  png_set_interlace_handling(png);
  png_read_update_info(png, info);
  return true;
}

bool decode_pixels(const Reader& reader, std::vector<png_bytep>& rows) {
  if (setjmp(png_jmpbuf(reader.png)) != 0) return false;
  png_read_image(reader.png, rows.data());
  png_read_end(reader.png, reader.info);
  return true;
}

std::string utf8_from_latin1(std::string_view latin1) {
  std::string utf8;
  for (const char c : latin1) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x80) {
      utf8 += c;
    } else {
      utf8 += static_cast<char>(0xC0u | byte >> 6);
      utf8 += static_cast<char>(0x80u | (byte & 0x3Fu));
    }
  }
  return utf8;
}

/// The text chunks; of a keyword that occurs twice the first.
PngText read_text(const Reader& reader) {
  png_textp chunks = nullptr;
  int count = 0;
  png_get_text(reader.png, reader.info, &chunks, &count);
  PngText text;
  for (int i = 0; i < count; ++i) {
    const png_text& chunk = chunks[i];
    const bool is_utf8 = chunk.compression >= PNG_ITXT_COMPRESSION_NONE;
    const std::string_view value(chunk.text, is_utf8 ? chunk.itxt_length : chunk.text_length);
    text.emplace(chunk.key, is_utf8 ? std::string(value) : utf8_from_latin1(value));
  }
  return text;
}

[[noreturn]] void fail_damaged(const std::string& name, std::string_view reason) {
  throw Error(Status::Input, name + " is a damaged PNG file: " + std::string(reason));
}

}  // namespace

void write_png(std::ostream& out, const Image& image, const PngText& text, unsigned threads) {
  PngWriter writer;
  if (writer.info == nullptr) throw Error(Status::Machine, "libpng cannot be started");
  const bool opaque = is_opaque(image);
  Contents contents{image, opaque, text_chunks(text), pack_pixels(image, opaque, threads)};
  png_set_write_fn(writer.png, &out, on_write, on_flush);
  if (!encode(writer, contents)) {
    throw Error(Status::Machine, "cannot write the PNG: " + std::string(writer.message.data()));
  }
}

PngFile read_png(const std::filesystem::path& path) {
  return decode_png(read_file(path), path.string());
}

bool is_png(std::string_view bytes) {
  return bytes.starts_with("\x89PNG\r\n\x1A\n");
}

std::optional<PngSize> size_of_png(std::string_view bytes) {
  constexpr std::size_t kWidthAt =
      16;  // behind the signature, and the first chunk's length and name
  constexpr std::size_t kHeightAt = 20;
  if (!is_png(bytes) || bytes.size() < kHeightAt + 4) return std::nullopt;
  const auto number_at = [&](std::size_t at) {
    return png_get_uint_32(reinterpret_cast<png_const_bytep>(bytes.data() + at));
  };
  return PngSize{number_at(kWidthAt), number_at(kHeightAt)};
}

namespace {

/// Throws Error (Input) for a picture that libpng would call invalid for its size.
void check_sides(std::string_view bytes, const std::string& name) {
  const std::optional<PngSize> size = size_of_png(bytes);
  if (!size || (size->width <= kLargestSide && size->height <= kLargestSide)) return;
  throw Error(Status::Input, name + " is " + std::to_string(size->width) + "x" +
                                 std::to_string(size->height) + " pixels; at most " +
                                 std::to_string(kLargestSide) + " each way are read");
}

/// Throws Error (Input) for a chunk that claims more bytes than the file has: libpng clears memory
/// for all of them before it reads the first.
void check_chunks(std::string_view bytes, const std::string& name) {
  constexpr std::size_t kSignature = 8;
  constexpr std::size_t kBeforeData = 8;  // length and name
  constexpr std::size_t kAfterData = 4;   // the checksum
  std::string_view rest = bytes.substr(kSignature);
  while (rest.size() >= kBeforeData && rest.substr(4, 4) != std::string_view("IEND")) {
    const std::size_t length = png_get_uint_32(reinterpret_cast<png_const_bytep>(rest.data()));
    if (length > rest.size() - kBeforeData) fail_damaged(name, "the file ends too early");
    rest.remove_prefix(std::min(rest.size(), kBeforeData + length + kAfterData));
  }
}

}  // namespace

PngFile decode_png(const std::string& bytes, const std::string& name) {
  if (!is_png(bytes)) throw Error(Status::Input, name + " is not a PNG file");
  check_sides(bytes, name);
  check_chunks(bytes, name);
  Reader reader(bytes);
  if (reader.info == nullptr) throw Error(Status::Machine, "libpng cannot be started");
  png_uint_32 width = 0;
  png_uint_32 height = 0;
  if (!decode_header(reader, width, height)) fail_damaged(name, reader.message.data());
  PngFile result{Image(static_cast<int>(width), static_cast<int>(height)), {}};
  std::vector<png_bytep> rows(height);
  for (png_uint_32 y = 0; y < height; ++y) rows[y] = result.image.pixel(0, static_cast<int>(y));
  if (!decode_pixels(reader, rows)) fail_damaged(name, reader.message.data());
  result.text = read_text(reader);
  return result;
}

}  // namespace saddle
