#include "base/nearest.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

#include "base/utf8.h"

namespace saddle {
namespace {

/// The characters of a name, ASCII letters in lower case.
std::u32string folded(std::string_view text) {
  std::u32string result;
  for (std::size_t at = 0; at < text.size();) {
    const Character c = decode_utf8(text, at);
    result += c.code >= U'A' && c.code <= U'Z' ? c.code - U'A' + U'a' : c.code;
    at += c.bytes;
  }
  return result;
}

/// A letter that was left out is the commonest slip, and a short word hides many: it costs half.
constexpr std::size_t kLeftOut = 1;
constexpr std::size_t kOtherEdit = 2;

/// The least cost of insertions, deletions, substitutions and swaps of neighbours that turn `a`
/// into `b`, no part of the text edited twice.
std::size_t alignment_cost(const std::u32string& a, const std::u32string& b) {
  std::vector<std::size_t> two_above(b.size() + 1);
  std::vector<std::size_t> above(b.size() + 1);
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j * kLeftOut;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::swap(two_above, above);
    std::swap(above, row);
    row[0] = i * kOtherEdit;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t substituted = above[j - 1] + (a[i - 1] == b[j - 1] ? 0 : kOtherEdit);
      row[j] = std::min({substituted, above[j] + kOtherEdit, row[j - 1] + kLeftOut});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) row[j] = std::min(row[j], two_above[j - 2] + kOtherEdit);
    }
  }
  return row[b.size()];
}

/// Whether any letter of `a` is in `b`.
bool share_a_letter(const std::u32string& a, const std::u32string& b) {
  return a.find_first_of(b) != std::u32string::npos;
}

/// The parts of a name between `-` and `_`, but for the shortest, in lower case.
std::vector<std::string> parts_of(std::string_view name) {
  constexpr std::size_t kShortest = 3;
  std::vector<std::string> parts(1);
  for (const char c : name) {
    if (c == '-' || c == '_' || c == ' ') {
      parts.emplace_back();
    } else {
      parts.back() += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    }
  }
  std::erase_if(parts, [](const std::string& part) { return part.size() < kShortest; });
  return parts;
}

}  // namespace

std::vector<std::string> similar_names(std::string_view word,
                                       std::span<const std::string> candidates) {
  constexpr std::size_t kMost = 4;
  std::vector<std::string> result;
  const auto add = [&result](const std::string& name) {
    if (result.size() < kMost && std::ranges::find(result, name) == result.end()) {
      result.push_back(name);
    }
  };
  if (const auto nearest = nearest_name(word, candidates)) return {*nearest};
  constexpr std::size_t kLongest = 200;  // this is a text, and no name
  if (word.size() > kLongest) return {};
  std::vector<std::string> known;
  for (const std::string& candidate : candidates)
    std::ranges::copy(parts_of(candidate), std::back_inserter(known));
  for (const std::string& part : parts_of(word)) {
    const auto meant = nearest_name(part, known);
    for (const std::string& candidate : candidates) {
      const std::vector<std::string> parts = parts_of(candidate);
      if (meant && std::ranges::find(parts, *meant) != parts.end()) add(candidate);
    }
  }
  return result;
}

std::string did_you_mean(std::span<const std::string> names) {
  if (names.empty()) return "";
  std::string text = "did you mean ";
  for (std::size_t k = 0; k < names.size(); ++k) {
    text += (k == 0 ? "'" : k + 1 == names.size() ? " or '" : ", '") + names[k] + "'";
  }
  return text + "?";
}

std::optional<std::string> nearest_name(std::string_view word,
                                        std::span<const std::string> candidates) {
  const std::u32string wanted = folded(word);
  // A single letter is a name of its own: 'a' is not a misspelt 'tau'.
  const std::size_t limit =
      wanted.size() < 2 ? 0 : kOtherEdit * std::max<std::size_t>(wanted.size() / 3, 1);
  const std::string* best = nullptr;
  std::size_t least = limit + 1;
  for (const std::string& candidate : candidates) {
    const std::u32string name = folded(candidate);
    if (name.size() > wanted.size() + least) continue;  // as many letters left out at least
    if (wanted.size() > name.size() + least / kOtherEdit) continue;  // or as many too many
    const std::size_t cost = alignment_cost(wanted, name);
    // Nothing in common: 'q' is not a misspelt 'e'.
    if (cost < least && share_a_letter(wanted, name)) {
      least = cost;
      best = &candidate;
    }
  }
  return best == nullptr ? std::nullopt : std::optional(*best);
}

}  // namespace saddle
