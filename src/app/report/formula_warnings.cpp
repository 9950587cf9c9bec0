#include "app/report/formula_warnings.h"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <optional>
#include <string_view>

#include "base/error.h"
#include "scene/model/prepare.h"
#include "scene/model/values.h"

namespace saddle {
namespace {

constexpr std::string_view kCall = "clamp(";

/// The arguments of a call whose bracket opens before `begin`; empty if it does not close.
std::vector<std::string> arguments_from(const std::string& text, std::size_t begin) {
  std::vector<std::string> arguments(1);
  int depth = 0;
  for (std::size_t i = begin; i < text.size(); ++i) {
    const char c = text[i];
    if (c == ')' && depth == 0) return arguments;
    depth += c == '(' ? 1 : c == ')' ? -1 : 0;
    if (c == ',' && depth == 0) {
      arguments.emplace_back();
    } else {
      arguments.back() += c;
    }
  }
  return {};
}

std::optional<double> constant_of(const Scene& scene, const std::string& text) {
  try {
    return finite_constant(scene, "clamp", text);
  } catch (const Error&) {
    return std::nullopt;  // it is no constant; what is wrong with it is told elsewhere
  }
}

void look_at(const Scene& scene, const std::string& name, const std::string& text,
             std::vector<std::string>& warnings) {
  for (std::size_t at = 0; (at = text.find(kCall, at)) != std::string::npos; at += kCall.size()) {
    const auto is_letter = [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; };
    if (at > 0 && is_letter(static_cast<unsigned char>(text[at - 1]))) continue;
    const std::vector<std::string> parts = arguments_from(text, at + kCall.size());
    if (parts.size() != 3) continue;
    const std::optional<double> low = constant_of(scene, parts[1]);
    const std::optional<double> high = constant_of(scene, parts[2]);
    if (!low || !high || *low <= *high) continue;
    const std::string call = "clamp(" + parts[0] + ",";
    warnings.push_back(name + ": " + call + parts[1] + "," + parts[2] + ") is " +
                       format_number(*high) + " everywhere: its bounds are reversed; write " +
                       call + parts[2] + "," + parts[1] + ")");
  }
}

}  // namespace

std::vector<std::string> reversed_clamps(const Scene& scene) {
  std::vector<std::string> warnings;
  const auto is_own = [](const Definition& d) { return d.name == "clamp"; };
  if (std::ranges::any_of(scene.definitions, is_own)) return warnings;
  for (const Definition& d : scene.definitions) look_at(scene, d.name, d.text, warnings);
  for (const SurfaceSpec& spec : scene.surfaces) {
    look_at(scene, "x", spec.x, warnings);
    look_at(scene, "y", spec.y, warnings);
    look_at(scene, "z", spec.z, warnings);
    look_at(scene, "where", spec.where, warnings);
    look_at(scene, "color", spec.color, warnings);
  }
  return warnings;
}

}  // namespace saddle
