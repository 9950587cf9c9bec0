// The pixels of a PNG file, filtered and deflated: bands of rows, several at a time.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "base/image.h"

namespace saddle {

/// Least bytes of filtered pixels in a band. A band knows nothing of those before it: of bands this
/// long the file is no larger for that.
inline constexpr std::size_t kBandBytes = std::size_t{128} * 1024;

/// The contents of the IDAT chunks, in their order; together they are the zlib stream that the PNG
/// specification asks for. RGB if `opaque`, RGBA otherwise. `threads` as in parallel_chunks(); the
/// same bytes for any number of them.
std::vector<std::string> pack_pixels(const Image& image, bool opaque, unsigned threads);

}  // namespace saddle
