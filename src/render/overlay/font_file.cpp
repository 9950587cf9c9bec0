// The font's file as bytes of the program: the assembler copies it there, and nothing of it is read
// from disk before it is used.
#include <cstddef>

#include "render/overlay/font.h"

__asm__(
    ".section .rodata\n"
    ".global saddle_font_begin\n"
    ".global saddle_font_end\n"
    ".balign 16\n"
    "saddle_font_begin:\n"
    ".incbin \"" SADDLE_FONT
    "\"\n"
    "saddle_font_end:\n"
    ".byte 0\n"
    ".text\n");

extern "C" {
// The assembler's names.
extern const unsigned char saddle_font_begin[];  // NOLINT(readability-identifier-naming)
extern const unsigned char saddle_font_end[];    // NOLINT(readability-identifier-naming)
}

namespace saddle {

std::span<const unsigned char> font_file() {
  return {saddle_font_begin, static_cast<std::size_t>(saddle_font_end - saddle_font_begin)};
}

}  // namespace saddle
