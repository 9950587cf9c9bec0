#include "view/model/sliders.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "scene/model/values.h"

namespace saddle {

std::vector<Definition>& definitions_of(Scene& scene, std::optional<std::size_t> surface) {
  return surface ? scene.surfaces[*surface].definitions : scene.definitions;
}

std::vector<Slider>& sliders_of(Scene& scene, std::optional<std::size_t> surface) {
  return surface ? scene.surfaces[*surface].sliders : scene.sliders;
}

Definition* find_definition(Scene& scene, const ParameterPlace& place) {
  if (place.surface && *place.surface >= scene.surfaces.size()) return nullptr;
  auto& all = definitions_of(scene, place.surface);
  const auto found = std::ranges::find(all, place.name, &Definition::name);
  return found == all.end() ? nullptr : &*found;
}

std::optional<double> plain_number(const Definition& definition) {
  const std::string& text = definition.text;
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool is_plain = error == std::errc() && end == text.data() + text.size();
  if (definition.is_function || !is_plain || !std::isfinite(value)) return std::nullopt;
  return value;
}

Slider slider_of(const Scene& scene, const ParameterPlace& place, double value) {
  const auto& all = place.surface ? scene.surfaces[*place.surface].sliders : scene.sliders;
  const auto found = std::ranges::find(all, place.name, &Slider::name);
  if (found != all.end()) return *found;
  // While the value changes, the ends stay: a power of two at least twice as far as it.
  const double reach = value == 0 ? 1 : std::exp2(std::ceil(std::log2(std::abs(value))) + 1);
  return {place.name, value < 0 ? -reach : 0, reach};
}

Slider& slider_in(Scene& scene, const ParameterPlace& place) {
  auto& all = sliders_of(scene, place.surface);
  const auto found = std::ranges::find(all, place.name, &Slider::name);
  if (found != all.end()) return *found;
  const Definition* const definition = find_definition(scene, place);
  const double value = definition == nullptr ? 1 : plain_number(*definition).value_or(1);
  all.push_back(slider_of(scene, place, value));
  return all.back();
}

double step_between(double low, double high, double steps) {
  const double wanted = std::abs(high - low) / steps;
  if (!(wanted > 0) || !std::isfinite(wanted)) return 0;
  const double power = std::pow(10, std::floor(std::log10(wanted)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    // A hair more than a step is that step: quotients are rounded.
    if (wanted <= factor * power * (1 + 1e-9)) return factor * power;
  }
  return 10 * power;
}

std::string rounded_text(double value, const Slider& ends, double steps) {
  if (ends.step > 0) {
    const double whole = std::round((value - ends.min) / ends.step);
    return format_number(std::min(ends.min + whole * ends.step, double(ends.max)));
  }
  const double step = step_between(ends.min, ends.max, steps);
  if (step == 0) return format_number(value);
  for (const double end : {double(ends.min), double(ends.max)}) {
    if (std::abs(value - end) < step / 2) return format_number(end);
  }
  const double rounded = std::round(value / step) * step;
  // As many decimals as the step has, which drops what rounding has left.
  const double digits = std::max(0.0, -std::floor(std::log10(step)));
  const double scale = std::pow(10, digits);
  return format_number(std::round(rounded * scale) / scale);
}

}  // namespace saddle
