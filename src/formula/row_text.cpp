#include "formula/row_text.h"

namespace saddle {
namespace {

bool is_word(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

}  // namespace

std::string with_arguments(std::string_view text, const std::array<std::string, 3>& arguments) {
  std::string result;
  for (std::size_t begin = 0; begin < text.size();) {
    std::size_t end = begin;
    while (end < text.size() && is_word(text[end])) ++end;
    const std::string_view word = text.substr(begin, end - begin);
    if (word == "a" || word == "b" || word == "c") {
      result += arguments[word[0] - 'a'];
    } else {
      result += word;
    }
    if (end < text.size()) result += text[end++];
    begin = end;
  }
  return result;
}

}  // namespace saddle
