#include "export/common/markup.h"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

#include "scene/model/surface_scope.h"

namespace saddle {
namespace {

/// The last one only where text is on one line.
constexpr std::array<std::pair<char, std::string_view>, 5> kEscapes = {
    {{'&', "&amp;"}, {'<', "&lt;"}, {'>', "&gt;"}, {'"', "&quot;"}, {'\n', "&#10;"}}};

std::string escaped(std::string_view text,
                    std::span<const decltype(kEscapes)::value_type> escapes) {
  std::string result;
  for (const char c : text) {
    const auto found = std::ranges::find(escapes, c, &decltype(kEscapes)::value_type::first);
    found == escapes.end() ? result += c : result += found->second;
  }
  return result;
}

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

constexpr const char* kGap = "   ";

/// Adds "name = formula" to a line; no formula: nothing.
void add_equation(std::string& line, const std::string& name, const std::string& formula) {
  if (formula.empty()) return;
  line += (line.empty() ? "" : kGap) + name + " = " + formula;
}

std::string definitions_as_text(const std::vector<Definition>& definitions) {
  std::string line;
  for (const Definition& definition : definitions) {
    add_equation(line, display_name(definition), definition.text);
  }
  return line;
}

std::string surface_as_text(const SurfaceSpec& spec) {
  std::string line;
  add_equation(line, "xyz", spec.xyz);
  for (std::size_t axis = 0; axis < 3 && spec.xyz.empty(); ++axis) {
    add_equation(line, std::string(1, "xyz"[axis]), coordinate_formula(spec, axis));
  }
  add_equation(line, spec.parameters[0], spec.u.min + " : " + spec.u.max);
  add_equation(line, spec.parameters[1], spec.v.min + " : " + spec.v.max);
  add_equation(line, "where", spec.where);
  const std::string own = definitions_as_text(spec.definitions);
  return line + (own.empty() ? "" : kGap) + own;
}

std::string curve_as_text(const CurveSpec& curve) {
  std::string line;
  add_equation(line, "xyz", curve.xyz);
  add_equation(line, "x", curve.x);
  add_equation(line, "y", curve.y);
  add_equation(line, "z", curve.z);
  add_equation(line, "u", curve.u);
  add_equation(line, "v", curve.v);
  add_equation(line, "s", curve.s.min + " : " + curve.s.max);
  return line;
}

}  // namespace

std::string escaped_markup(std::string_view text) {
  return escaped(text, std::span(kEscapes).first(kEscapes.size() - 1));
}

std::string escaped_line(std::string_view text) {
  return escaped(text, kEscapes);
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
  const auto add = [&text](std::string line) {
    if (!line.empty()) text += (text.empty() ? "" : "\n") + std::move(line);
  };
  for (const SurfaceSpec& spec : scene.surfaces) {
    if (!spec.is_stroke() && spec.visible) add(surface_as_text(spec));
  }
  for (const CurveSpec& curve : scene.curves) {
    if (curve.visible) add(curve_as_text(curve));
  }
  add(definitions_as_text(scene.definitions));
  return text;
}

}  // namespace saddle
