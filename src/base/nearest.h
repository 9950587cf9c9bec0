// "Did you mean ...?": the nearest of a list of names to a word that is not among them.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace saddle {

/// The candidate with the least Damerau-Levenshtein distance (optimal string alignment, case
/// ignored, a letter that `word` lacks counting half), if that is at most a third of the word's
/// length (at least 1) and leaves a letter in common; the first of equals.
/// Source: V. Levenshtein, "Binary codes capable of correcting deletions, insertions and
/// reversals", 1966; F. Damerau, "A technique for computer detection and correction of spelling
/// errors", 1964.
std::optional<std::string> nearest_name(std::string_view word,
                                        std::span<const std::string> candidates);

/// The candidates that a word may stand for: the nearest; without one, up to four that share a part
/// of at least three letters with it, as `klein-bottle` does with `klein`. Parts end at `-` and
/// `_`.
std::vector<std::string> similar_names(std::string_view word,
                                       std::span<const std::string> candidates);

/// "did you mean 'a'?", "did you mean 'a', 'b' or 'c'?"; empty for no names.
std::string did_you_mean(std::span<const std::string> names);

}  // namespace saddle
