#include "base/image_png.h"

#include <gtest/gtest.h>
#include <png.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <sstream>
#include <streambuf>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/png_pixels.h"

namespace saddle {
namespace {

namespace fs = std::filesystem;

/// A file that is removed at the end of a test.
class TestFile {
 public:
  explicit TestFile(const std::string& content)
      : path_(testing::TempDir() + "saddle-png-" + std::to_string(getpid()) + ".png") {
    std::ofstream(path_, std::ios::binary) << content;
  }
  ~TestFile() { fs::remove(path_); }
  TestFile(const TestFile&) = delete;
  TestFile& operator=(const TestFile&) = delete;
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

PngFile read_bytes(const std::string& content) {
  return read_png(TestFile(content).path());
}

std::string written(const Image& image, const PngText& text = {}) {
  std::ostringstream out;
  write_png(out, image, text);
  return out.str();
}

/// A picture in which no two neighbours are alike; alpha 255 unless `with_alpha`.
Image pattern(int width, int height, bool with_alpha) {
  Image image(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      std::uint8_t* p = image.pixel(x, y);
      p[0] = static_cast<std::uint8_t>(17 * x + y);
      p[1] = static_cast<std::uint8_t>(x * y);
      p[2] = static_cast<std::uint8_t>(255 - 5 * y);
      p[3] = static_cast<std::uint8_t>(with_alpha ? 3 * x + 7 * y : 255);
    }
  }
  return image;
}

/// Names of the chunks of a PNG in their order.
std::vector<std::string> chunk_names(const std::string& png) {
  std::vector<std::string> names;
  for (std::size_t at = 8; at + 12 <= png.size();) {
    std::size_t length = 0;
    for (int i = 0; i < 4; ++i) length = length << 8 | static_cast<std::uint8_t>(png[at + i]);
    names.push_back(png.substr(at + 4, 4));
    at += 12 + length;
  }
  return names;
}

/// The pixels as libpng's other interface reads them.
Image decode_independently(const std::string& png) {
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  EXPECT_NE(png_image_begin_read_from_memory(&header, png.data(), png.size()), 0);
  header.format = PNG_FORMAT_RGBA;
  Image image(static_cast<int>(header.width), static_cast<int>(header.height));
  EXPECT_NE(png_image_finish_read(&header, nullptr, image.rgba.data(), 0, nullptr), 0);
  return image;
}

enum ColorType : char { Rgb = 2, Rgba = 6 };

char color_type(const std::string& png) {
  return png.at(25);
}

TEST(WritePng, KeepsEveryPixelOfAnOpaquePictureAsRgb) {
  const Image image = pattern(37, 19, false);
  const std::string png = written(image);
  EXPECT_EQ(color_type(png), Rgb);
  const Image back = decode_independently(png);
  EXPECT_EQ(back.width, 37);
  EXPECT_EQ(back.height, 19);
  EXPECT_EQ(back.rgba, image.rgba);
}

TEST(WritePng, KeepsEveryPixelOfATransparentPictureAsRgba) {
  const Image image = pattern(19, 37, true);
  const std::string png = written(image);
  EXPECT_EQ(color_type(png), Rgba);
  EXPECT_EQ(decode_independently(png).rgba, image.rgba);
}

TEST(WritePng, UsesRgbaForOneTransparentPixel) {
  Image image = pattern(5, 5, false);
  image.pixel(4, 4)[3] = 254;
  EXPECT_EQ(color_type(written(image)), Rgba);
}

TEST(WritePng, PutsTextBeforeThePixelsAndNoTimeAnywhere) {
  const std::vector<std::string> expected = {"IHDR", "iTXt", "iTXt", "IDAT", "IEND"};
  EXPECT_EQ(chunk_names(written(pattern(4, 4, false), {{"Title", "t"}, {"saddle", "s"}})),
            expected);
}

TEST(WritePng, WritesTheSameBytesForTheSameInput) {
  const PngText text = {{"Title", "torus"}};
  EXPECT_EQ(written(pattern(50, 50, true), text), written(pattern(50, 50, true), text));
}

TEST(WritePng, PutsBandsTogetherToThePictureThatTheyCameFrom) {
  const int rows = static_cast<int>(kBandBytes / (3 * 100 + 1)) + 1;  // of a band
  const int wide = static_cast<int>(kBandBytes / 3) + 1;              // a row is a band
  struct Case {
    int width, height, bands;
  };
  for (const auto& [width, height, bands] :
       {Case{100, rows, 1}, Case{100, rows + 1, 2}, Case{100, 2 * rows, 2}, Case{3, 16384, 2},
        Case{100, 5 * rows - 1, 5}, Case{wide / 8, 9, 2}}) {
    const Image image = pattern(width, height, false);
    const std::string png = written(image);
    EXPECT_EQ(std::ranges::count(chunk_names(png), "IDAT"), bands) << width << "x" << height;
    EXPECT_EQ(decode_independently(png).rgba, image.rgba) << width << "x" << height;
    const Image with_alpha = pattern(width, height, true);
    EXPECT_EQ(decode_independently(written(with_alpha)).rgba, with_alpha.rgba);
  }
}

TEST(WritePng, WritesTheSameBytesWithAnyNumberOfThreads) {
  const Image image = pattern(640, 800, false);
  std::ostringstream one;
  std::ostringstream four;
  write_png(one, image, {}, 1);
  write_png(four, image, {}, 4);
  EXPECT_EQ(one.str(), four.str());
}

/// Takes a number of bytes, then fails.
class FullBuffer : public std::streambuf {
 public:
  explicit FullBuffer(int room) : room_(room) {}

 protected:
  int_type overflow(int_type c) override { return room_-- > 0 ? c : traits_type::eof(); }

 private:
  int room_;
};

TEST(WritePng, FailsWhereverTheStreamFails) {
  const Image image = pattern(8, 8, false);
  const int size = static_cast<int>(written(image).size());
  for (int room = 0; room < size; ++room) {
    for (const bool throwing : {false, true}) {
      FullBuffer buffer(room);
      std::ostream out(&buffer);
      if (throwing) out.exceptions(std::ios::badbit);
      try {
        write_png(out, image);
        ADD_FAILURE() << "no error with room for " << room << " bytes";
      } catch (const Error& error) {
        EXPECT_EQ(error.status(), Status::Machine);
      }
    }
  }
}

TEST(WritePng, FailsForWhatIsNoKeyword) {
  EXPECT_THROW(written(pattern(2, 2, false), {{"", "text"}}), Error);
}

TEST(ReadPng, ReturnsPixelsAndTextAsTheyWereWritten) {
  const PngText text = {{"Title", "T\u03C0 \u2212 \u6F22"}, {"saddle", std::string(100'000, 'x')}};
  for (const bool with_alpha : {false, true}) {
    const Image image = pattern(37, 19, with_alpha);
    const PngFile file = read_bytes(written(image, text));
    EXPECT_EQ(file.image.width, 37);
    EXPECT_EQ(file.image.height, 19);
    EXPECT_EQ(file.image.rgba, image.rgba);
    EXPECT_EQ(file.text, text);
  }
}

/// A PNG of the given kind, written straight through libpng. `prepare` adds chunks.
struct Kind {
  int color_type;
  int bits;
  int interlace = PNG_INTERLACE_NONE;
};
using Prepare = std::function<void(png_structp, png_infop)>;

std::string foreign_png(const Kind& kind, std::vector<std::vector<png_byte>> rows, int width,
                        const Prepare& prepare = {}) {
  std::string bytes;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  const auto append = [](png_structp p, png_bytep data, std::size_t size) {
    static_cast<std::string*>(png_get_io_ptr(p))->append(reinterpret_cast<char*>(data), size);
  };
  png_set_write_fn(png, &bytes, append, [](png_structp) {});
  png_set_IHDR(png, info, static_cast<png_uint_32>(width), static_cast<png_uint_32>(rows.size()),
               kind.bits, kind.color_type, kind.interlace, PNG_COMPRESSION_TYPE_DEFAULT,
               PNG_FILTER_TYPE_DEFAULT);
  if (prepare) prepare(png, info);
  png_write_info(png, info);
  std::vector<png_bytep> pointers;
  for (auto& row : rows) pointers.push_back(row.data());
  png_write_image(png, pointers.data());
  png_write_end(png, info);
  png_destroy_write_struct(&png, &info);
  return bytes;
}

using Bytes = std::vector<std::uint8_t>;

TEST(SizeOfPng, IsKnownBeforeThePixels) {
  std::ostringstream out;
  write_png(out, Image(300, 7));
  const std::string bytes = out.str();
  const auto size = size_of_png(std::string_view(bytes).substr(0, 24));
  ASSERT_TRUE(size);
  EXPECT_EQ(size->width, 300U);
  EXPECT_EQ(size->height, 7U);
  EXPECT_FALSE(size_of_png(std::string_view(bytes).substr(0, 23)));
  EXPECT_FALSE(size_of_png("no picture, but long enough for one"));
}

TEST(ReadPng, ReadsGreyOfOneBit) {
  const std::string png = foreign_png({PNG_COLOR_TYPE_GRAY, 1}, {{0x40}}, 2);
  EXPECT_EQ(read_bytes(png).image.rgba, (Bytes{0, 0, 0, 255, 255, 255, 255, 255}));
}

TEST(ReadPng, ReadsGreyWithAlpha) {
  const std::string png = foreign_png({PNG_COLOR_TYPE_GRAY_ALPHA, 8}, {{9, 100}}, 1);
  EXPECT_EQ(read_bytes(png).image.rgba, (Bytes{9, 9, 9, 100}));
}

TEST(ReadPng, RoundsSixteenBitsToEight) {
  // 255 of 65535 is nearest to 1 of 255, and 65279 to 254.
  const std::string png =
      foreign_png({PNG_COLOR_TYPE_RGB, 16}, {{0x00, 0xFF, 0xFE, 0xFF, 0xFF, 0xFF}}, 1);
  EXPECT_EQ(read_bytes(png).image.rgba, (Bytes{1, 254, 255, 255}));
}

TEST(ReadPng, ReadsPalettesWithTransparentColors) {
  const std::string png =
      foreign_png({PNG_COLOR_TYPE_PALETTE, 2}, {{0x10}}, 2, [](png_structp p, png_infop info) {
        const png_color colors[] = {{1, 2, 3}, {4, 5, 6}};
        const png_byte alpha[] = {70};
        png_set_PLTE(p, info, colors, 2);
        png_set_tRNS(p, info, alpha, 1, nullptr);
      });
  EXPECT_EQ(read_bytes(png).image.rgba, (Bytes{1, 2, 3, 70, 4, 5, 6, 255}));
}

TEST(ReadPng, ReadsInterlacedPictures) {
  const Image image = pattern(11, 9, true);
  std::vector<Bytes> rows;
  for (int y = 0; y < 9; ++y) rows.emplace_back(image.pixel(0, y), image.pixel(0, y) + 4 * 11);
  const std::string png = foreign_png({PNG_COLOR_TYPE_RGBA, 8, PNG_INTERLACE_ADAM7}, rows, 11);
  EXPECT_EQ(read_bytes(png).image.rgba, image.rgba);
}

TEST(ReadPng, ReadsEveryKindOfTextAndTheFirstOfTwins) {
  const auto add = [](png_structp p, png_infop info, int compression, const char* key,
                      std::string value) {
    std::string keyword = key;
    png_text chunk{};
    chunk.compression = compression;
    chunk.key = keyword.data();
    chunk.text = value.data();
    png_set_text(p, info, &chunk, 1);
  };
  const std::string png =
      foreign_png({PNG_COLOR_TYPE_GRAY, 8}, {{0}}, 1, [&](png_structp p, png_infop info) {
        add(p, info, PNG_TEXT_COMPRESSION_NONE, "plain", "caf\xE9");
        add(p, info, PNG_TEXT_COMPRESSION_zTXt, "packed", "\xB2");
        add(p, info, PNG_ITXT_COMPRESSION_zTXt, "unicode", "\u03C0");
        add(p, info, PNG_ITXT_COMPRESSION_NONE, "unicode", "second");
      });
  const PngText expected = {{"plain", "caf\u00E9"}, {"packed", "\u00B2"}, {"unicode", "\u03C0"}};
  EXPECT_EQ(read_bytes(png).text, expected);
}

Status status_of_reading(const fs::path& path) {
  try {
    read_png(path);
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find(path.string()), std::string::npos) << error.what();
    return error.status();
  }
  return Status::Done;
}

TEST(ReadPng, TellsAMissingFileFromOneThatIsNoPng) {
  EXPECT_EQ(status_of_reading(testing::TempDir() + "saddle-no-such-file.png"), Status::Machine);
  EXPECT_EQ(status_of_reading(testing::TempDir()), Status::Machine);
  EXPECT_EQ(status_of_reading(TestFile("").path()), Status::Input);
  EXPECT_EQ(status_of_reading(TestFile("title = \"Torus\"\n").path()), Status::Input);
}

TEST(ReadPng, RefusesAFileThatWasCutOffAnywhere) {
  const std::string png = written(pattern(9, 9, true), {{"saddle", "text"}});
  for (std::size_t size = 0; size < png.size(); ++size) {
    EXPECT_EQ(status_of_reading(TestFile(png.substr(0, size)).path()), Status::Input) << size;
  }
}

TEST(ReadPng, TakesNoMemoryForAChunkThatIsNotThere) {
  // A text of 1.9 GB, in a file of some hundred bytes.
  std::string png = written(pattern(9, 9, true), {{"saddle", "text"}});
  const std::size_t name = png.find("iTXt");
  ASSERT_NE(name, std::string::npos);
  png.replace(name - 4, 4, std::string("\x70\0\0\0", 4));
  const auto most_kilobytes = [] {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss;
  };
  const long before = most_kilobytes();
  EXPECT_EQ(status_of_reading(TestFile(png).path()), Status::Input);
  EXPECT_LT(most_kilobytes() - before, 500'000);
}

TEST(ReadPng, NeverCrashesOnAFileWithAWrongByte) {
  const std::string png = written(pattern(9, 9, true), {{"saddle", "text"}});
  for (std::size_t at = 0; at < png.size(); ++at) {
    for (const int change : {1, 0x80, 0xFF}) {
      std::string damaged = png;
      damaged[at] = static_cast<char>(damaged[at] ^ change);
      const Status status = status_of_reading(TestFile(damaged).path());
      EXPECT_TRUE(status == Status::Input || status == Status::Done) << at;
    }
  }
}

TEST(ReadPng, RefusesPixelsThatAreDamaged) {
  std::string png = written(pattern(9, 9, true));
  png[png.find("IDAT") + 12] ^= 1;  // the checksum no longer fits
  EXPECT_EQ(status_of_reading(TestFile(png).path()), Status::Input);
}

/// A header that promises `side` x `side` pixels, with a checksum that fits, and a few bytes.
std::string promise(png_uint_32 side) {
  std::string bytes;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  const auto append = [](png_structp p, png_bytep data, std::size_t size) {
    static_cast<std::string*>(png_get_io_ptr(p))->append(reinterpret_cast<char*>(data), size);
  };
  png_set_write_fn(png, &bytes, append, [](png_structp) {});
  png_set_IHDR(png, info, side, side, 8, PNG_COLOR_TYPE_RGBA, PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_write_info(png, info);
  png_destroy_write_struct(&png, &info);
  const std::string small = written(pattern(2, 2, true));
  return bytes + small.substr(small.find("IDAT") - 4);
}

std::string message_of_reading(const std::string& content) {
  try {
    read_bytes(content);
  } catch (const Error& error) {
    return error.what();
  }
  return {};
}

TEST(ReadPng, RefusesAHeaderThatPromisesMoreThanTheFileCanHold) {
  EXPECT_NE(message_of_reading(promise(16384)).find("too short for its pixels"), std::string::npos);
}

TEST(ReadPng, RefusesPicturesWiderThanTheProgramWrites) {
  EXPECT_EQ(status_of_reading(TestFile(promise(16385)).path()), Status::Input);
  EXPECT_EQ(message_of_reading(promise(16385)).find("too short"), std::string::npos);
}

TEST(ReadPng, ReadsAsMuchAsDeflateCanPack) {
  // The emptiest picture there is: the bound on the expansion must not refuse it.
  Image image(2000, 2000);
  const PngFile file =
      read_bytes(foreign_png({PNG_COLOR_TYPE_RGBA, 8}, std::vector<Bytes>(2000, Bytes(4 * 2000)),
                             2000, [](png_structp p, png_infop) {
                               png_set_compression_level(p, 9);
                               png_set_filter(p, 0, PNG_FILTER_NONE);
                             }));
  EXPECT_TRUE(file.image.rgba == image.rgba);
}

}  // namespace
}  // namespace saddle
