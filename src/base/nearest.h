// "Did you mean ...?": the nearest of a list of names to a word that is not among them.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace saddle {

/// The candidate with the least Damerau-Levenshtein distance (optimal string alignment, case
/// ignored, a letter that `word` lacks counting half), if that is at most a third of the word's
/// length (at least 1) and leaves a letter in common; the first of equals.
/// Source: V. Levenshtein, "Binary codes capable of correcting deletions, insertions and
/// reversals", 1966; F. Damerau, "A technique for computer detection and correction of spelling
/// errors", 1964.
std::optional<std::string> nearest_name(std::string_view word,
                                        std::span<const std::string> candidates);

}  // namespace saddle
