// Deflate, the compression of PNG and ZIP files, through zlib: pieces that are packed by
// themselves, so that several threads can pack a stream.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace saddle {

/// A piece knows at most so many bytes before it: the reach of deflate.
inline constexpr std::size_t kDeflateReach = std::size_t{1} << 15;

/// A raw deflate stream of the bytes: up to its end if they are the `last` ones, else up to a byte
/// boundary, so that pieces follow each other. `before`: what the stream holds before them, of
/// which the last kDeflateReach bytes count. zlib's least effort, level 1.
std::string deflated(std::span<const std::uint8_t> bytes, bool last,
                     std::span<const std::uint8_t> before = {});

/// The bytes that a raw deflate stream holds, at most `most` of them. Throws Error (Input) for a
/// damaged stream; messages call it `name`.
std::string inflated(std::string_view stream, std::size_t most, const std::string& name);

/// The checksum of ZIP files, CRC-32, of the bytes after those whose checksum is `before`.
std::uint32_t crc_of(std::span<const std::uint8_t> bytes, std::uint32_t before = 0);

}  // namespace saddle
