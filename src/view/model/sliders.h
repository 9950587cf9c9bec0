// Parameters as sliders: where they are in a scene, their ends and their round steps.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "scene/model/scene.h"

namespace saddle {

/// A definition of the scene, or of one of its surfaces.
struct ParameterPlace {
  std::optional<std::size_t> surface;
  std::string name;

  bool operator==(const ParameterPlace&) const = default;
};

std::vector<Definition>& definitions_of(Scene& scene, std::optional<std::size_t> surface);
std::vector<Slider>& sliders_of(Scene& scene, std::optional<std::size_t> surface);

/// nullptr: it is gone.
Definition* find_definition(Scene& scene, const ParameterPlace& place);

/// The number that a definition is, if it is one and nothing else.
std::optional<double> plain_number(const Definition& definition);

/// The slider that the scene has for a parameter, or one around its value: from 0 to twice it.
Slider slider_of(const Scene& scene, const ParameterPlace& place, double value);
/// That slider as one of the scene's, which gets it if it has none.
Slider& slider_in(Scene& scene, const ParameterPlace& place);

/// Steps of a slider from end to end, about: one for each pixel or two; and of one that plays.
inline constexpr double kDraggedSteps = 100;
inline constexpr double kPlayedSteps = 2000;

/// 1, 2 or 5 times a power of ten, the way from end to end in about so many steps.
double step_between(double low, double high, double steps);

/// The nearest number of whole steps, with no more digits than the step has; an end if that is
/// nearer. A slider with steps of its own keeps to them.
std::string rounded_text(double value, const Slider& ends, double steps);

}  // namespace saddle
