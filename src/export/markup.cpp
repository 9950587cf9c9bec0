#include "export/markup.h"

#include <algorithm>
#include <array>
#include <utility>

#include "scene/model/surface_scope.h"

namespace saddle {
namespace {

constexpr std::array<std::pair<char, std::string_view>, 4> kEscapes = {
    {{'&', "&amp;"}, {'<', "&lt;"}, {'>', "&gt;"}, {'"', "&quot;"}}};

std::string unescaped(std::string_view text) {
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    const auto* const found = std::ranges::find_if(
        kEscapes, [&](const auto& escape) { return text.substr(at).starts_with(escape.second); });
    const bool is_plain = found == kEscapes.end();
    result += is_plain ? text[at] : found->first;
    at += is_plain ? 1 : found->second.size();
  }
  return result;
}

}  // namespace

std::string escaped_markup(std::string_view text) {
  std::string result;
  for (const char c : text) {
    const auto* const found =
        std::ranges::find(kEscapes, c, &decltype(kEscapes)::value_type::first);
    found == kEscapes.end() ? result += c : result += found->second;
  }
  return result;
}

std::optional<std::string> text_between(std::string_view markup, std::string_view begins,
                                        std::string_view ends) {
  const std::size_t begin = markup.find(begins);
  if (begin == std::string_view::npos) return std::nullopt;
  const std::size_t from = begin + begins.size();
  const std::size_t end = markup.find(ends, from);
  if (end == std::string_view::npos) return std::nullopt;
  return unescaped(markup.substr(from, end - from));
}

std::string formulas_as_text(const Scene& scene) {
  std::string text;
  for (const SurfaceSpec& spec : scene.surfaces) {
    if (spec.is_stroke()) continue;
    std::string line;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::string formula = coordinate_formula(spec, axis);
      if (!formula.empty())
        line += std::string(line.empty() ? "" : "   ") + "xyz"[axis] + " = " + formula;
    }
    line += "   " + spec.parameters[0] + " = " + spec.u.min + " : " + spec.u.max + "   " +
            spec.parameters[1] + " = " + spec.v.min + " : " + spec.v.max;
    text += (text.empty() ? "" : "\n") + line;
  }
  return text;
}

}  // namespace saddle
