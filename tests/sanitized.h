// Whether a sanitizer is compiled in: it has a heap of its own, and takes several times as long.
#pragma once

namespace saddle {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool kIsSanitized = true;
#else
inline constexpr bool kIsSanitized = false;
#endif

/// A process that is forked from one with threads does not run its signal handlers under the thread
/// sanitizer.
#if defined(__SANITIZE_THREAD__)
inline constexpr bool kForkHandlesSignals = false;
#else
inline constexpr bool kForkHandlesSignals = true;
#endif

}  // namespace saddle
