// ZIP files: parts that are packed as they are written, and the parts of such a file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

namespace saddle {

/// Writes a ZIP file from its beginning to its end, also where the stream cannot go back. Parts are
/// deflated in blocks, several at a time: the same bytes for any number of threads. There are no
/// time stamps. Source: PKWARE, "APPNOTE.TXT - .ZIP file format specification", 6.3.10.
class ZipWriter {
 public:
  /// `threads` 0: all.
  ZipWriter(std::ostream& out, unsigned threads) : out_(out), threads_(threads) {}

  /// A part; `write` writes what it holds. Throws Error (Input) for one past 4 GiB.
  void add(const std::string& name, const std::function<void(std::ostream&)>& write);

  /// The directory of the parts, after the last one.
  void finish();

 private:
  struct Part {
    std::string name;
    std::uint32_t checksum;
    std::size_t packed;
    std::size_t bytes;
    std::size_t offset;
  };
  void put(const std::string& bytes);

  std::ostream& out_;
  unsigned threads_;
  std::vector<Part> parts_;
  std::size_t written_ = 0;
};

/// The first `most` bytes of a part of a ZIP file; nothing if it has no such part. Throws Error
/// (Input) for a file that is no ZIP or is damaged; messages call it `name`.
std::optional<std::string> part_of_zip(const std::string& bytes, const std::string& part,
                                       std::size_t most, const std::string& name);

}  // namespace saddle
