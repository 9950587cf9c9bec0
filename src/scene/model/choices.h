// Parameters that take one of a few named values.
#pragma once

#include <string>
#include <vector>

#include "scene/model/scene.h"

namespace saddle {

/// Makes the parameter one of its choices, 0 to N-1.
void set_choices(Slider& slider, std::vector<std::string> names);

/// "0 point, 1 spot, 2 sun"
std::string choices_text(const Slider& slider);

/// Replaces the text of a definition that is the name of one of its choices by that choice's
/// number. `known`: definitions that its formula may use. Throws Error (Input), with the names, for
/// a word that is neither.
void take_choice(const std::vector<Slider>& sliders, const std::vector<Definition>& known,
                 Definition& definition);

/// Throws Error (Input), with the names, unless `value` is the number of one of the choices.
void check_choice(const Slider& slider, const Number& value);

}  // namespace saddle
