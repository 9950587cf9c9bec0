#include "export/zip.h"

#include <algorithm>
#include <limits>
#include <ostream>
#include <span>
#include <streambuf>
#include <string_view>

#include "base/deflate.h"
#include "base/error.h"
#include "base/parallel.h"

namespace saddle {
namespace {

constexpr std::uint32_t kPartMark = 0x04034b50;
constexpr std::uint32_t kSizesMark = 0x08074b50;
constexpr std::uint32_t kDirectoryMark = 0x02014b50;
constexpr std::uint32_t kEndMark = 0x06054b50;
constexpr std::size_t kPartHeader = 30;
constexpr std::size_t kDirectoryHeader = 46;
constexpr std::size_t kEnd = 22;
constexpr int kVersion = 20;     // deflate
constexpr int kSizesFollow = 8;  // flag: checksum and sizes are behind the part
constexpr int kUtf8 = 1 << 11;   // flag: so are names
constexpr int kDeflate = 8;
/// 1 January 1980, the earliest that there is.
constexpr int kDate = 1 << 5 | 1;

constexpr std::size_t kBlock = std::size_t{1} << 20;
/// Blocks that are packed at a time: 16 MiB are in memory, and their packed bytes.
constexpr std::size_t kBlocks = 16;

std::string little_endian(std::size_t number, int bytes) {
  std::string text;
  for (int i = 0; i < bytes; ++i) text += static_cast<char>(number >> 8 * i & 0xFF);
  return text;
}

std::size_t number_at(std::string_view bytes, std::size_t at, std::size_t count) {
  std::size_t number = 0;
  for (std::size_t i = count; i-- > 0;) {
    number = number << 8 | static_cast<std::uint8_t>(bytes[at + i]);
  }
  return number;
}

/// Packs what is written to it.
class PackingBuffer : public std::streambuf {
 public:
  PackingBuffer(std::function<void(const std::string&)> put, unsigned threads)
      : put_(std::move(put)), threads_(threads), bytes_(kDeflateReach + kBlocks * kBlock) {
    expect(0);
  }

  void finish() { pack(true); }
  std::size_t size() const { return size_; }
  std::uint32_t checksum() const { return checksum_; }

 protected:
  int_type overflow(int_type c) override {
    pack(false);
    if (!traits_type::eq_int_type(c, traits_type::eof())) sputc(traits_type::to_char_type(c));
    return traits_type::not_eof(c);
  }

 private:
  /// Room for new bytes, behind `known` ones of before.
  void expect(std::size_t known) {
    known_ = known;
    setp(bytes_.data() + known, bytes_.data() + bytes_.size());
  }

  void pack(bool last) {
    const std::span<const std::uint8_t> all(reinterpret_cast<const std::uint8_t*>(bytes_.data()),
                                            static_cast<std::size_t>(pptr() - bytes_.data()));
    const auto fresh = all.subspan(known_);
    const std::size_t count = std::max<std::size_t>(1, (fresh.size() + kBlock - 1) / kBlock);
    std::vector<std::string> packed(count);
    parallel_chunks(count, 1, threads_, [&](std::size_t begin, std::size_t) {
      const std::size_t at = begin * kBlock;
      const auto block = fresh.subspan(at, std::min(kBlock, fresh.size() - at));
      packed[begin] = deflated(block, last && begin + 1 == count, all.first(known_ + at));
    });
    for (const std::string& block : packed) put_(block);
    checksum_ = crc_of(fresh, checksum_);
    size_ += fresh.size();
    const auto kept = all.last(std::min(all.size(), kDeflateReach));
    std::copy(kept.begin(), kept.end(), bytes_.begin());
    expect(kept.size());
  }

  std::function<void(const std::string&)> put_;
  unsigned threads_;
  std::vector<char> bytes_;  // those of before that blocks may refer to, then new ones
  std::size_t known_ = 0;
  std::size_t size_ = 0;
  std::uint32_t checksum_ = 0;
};

/// The same fields of a part's own header and of its row in the directory.
std::string common_fields(std::uint32_t checksum, std::size_t packed, std::size_t bytes,
                          std::size_t name) {
  return little_endian(kVersion, 2) + little_endian(kSizesFollow | kUtf8, 2) +
         little_endian(kDeflate, 2) + little_endian(0, 2) + little_endian(kDate, 2) +
         little_endian(checksum, 4) + little_endian(packed, 4) + little_endian(bytes, 4) +
         little_endian(name, 2) + little_endian(0, 2);
}

[[noreturn]] void fail_size() {
  throw Error(Status::Input, "the mesh is larger than the 4 GiB of a part of a 3MF file", {},
              "a coarser tolerance gives fewer triangles");
}

void check_size(std::size_t bytes) {
  if (bytes > std::numeric_limits<std::uint32_t>::max()) fail_size();
}

/// Where the directory's end is in a ZIP file.
std::size_t end_of(const std::string& bytes, const std::string& name) {
  const std::size_t at = bytes.rfind(little_endian(kEndMark, 4));
  if (at == std::string::npos || at + kEnd > bytes.size()) {
    throw Error(Status::Input, name + " is not a 3MF file, or is damaged");
  }
  return at;
}

}  // namespace

void ZipWriter::put(const std::string& bytes) {
  out_.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  written_ += bytes.size();
}

void ZipWriter::add(const std::string& name, const std::function<void(std::ostream&)>& write) {
  Part part{name, 0, 0, 0, written_};
  put(little_endian(kPartMark, 4) + common_fields(0, 0, 0, name.size()) + name);
  const std::size_t begin = written_;
  PackingBuffer buffer([this](const std::string& bytes) { put(bytes); }, threads_);
  std::ostream stream(&buffer);
  // The stream passes on exceptions of the buffer.
  stream.exceptions(std::ios::badbit);
  write(stream);
  buffer.finish();
  part.checksum = buffer.checksum();
  part.packed = written_ - begin;
  part.bytes = buffer.size();
  check_size(part.bytes);
  check_size(written_);
  put(little_endian(kSizesMark, 4) + little_endian(part.checksum, 4) +
      little_endian(part.packed, 4) + little_endian(part.bytes, 4));
  parts_.push_back(part);
}

void ZipWriter::finish() {
  const std::size_t begin = written_;
  for (const Part& part : parts_) {
    put(little_endian(kDirectoryMark, 4) + little_endian(kVersion, 2) +
        common_fields(part.checksum, part.packed, part.bytes, part.name.size()) +
        little_endian(0, 6) + little_endian(0, 4) + little_endian(part.offset, 4) + part.name);
  }
  const std::size_t directory = written_ - begin;
  check_size(written_);
  put(little_endian(kEndMark, 4) + little_endian(0, 4) + little_endian(parts_.size(), 2) +
      little_endian(parts_.size(), 2) + little_endian(directory, 4) + little_endian(begin, 4) +
      little_endian(0, 2));
}

std::optional<std::string> part_of_zip(const std::string& bytes, const std::string& part,
                                       std::size_t most, const std::string& name) {
  const std::size_t end = end_of(bytes, name);
  const auto damaged = [&] { return Error(Status::Input, name + " is damaged"); };
  std::size_t at = number_at(bytes, end + 16, 4);
  for (std::size_t i = number_at(bytes, end + 10, 2); i-- > 0;) {
    if (at + kDirectoryHeader > bytes.size()) throw damaged();
    const std::size_t packed = number_at(bytes, at + 20, 4);
    const std::size_t name_bytes = number_at(bytes, at + 28, 2);
    const std::size_t more = number_at(bytes, at + 30, 2) + number_at(bytes, at + 32, 2);
    const std::size_t offset = number_at(bytes, at + 42, 4);
    const std::size_t method = number_at(bytes, at + 10, 2);
    const bool is_part = bytes.compare(at + kDirectoryHeader, name_bytes, part) == 0;
    at += kDirectoryHeader + name_bytes + more;
    if (!is_part) continue;
    if (offset + kPartHeader > bytes.size()) throw damaged();
    const std::size_t begin =
        offset + kPartHeader + number_at(bytes, offset + 26, 2) + number_at(bytes, offset + 28, 2);
    if (begin > bytes.size()) throw damaged();
    const std::string_view held = std::string_view(bytes).substr(begin, packed);
    if (method == 0) return std::string(held.substr(0, most));
    return inflated(held, most, name);
  }
  return std::nullopt;
}

}  // namespace saddle
