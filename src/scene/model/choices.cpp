#include "scene/model/choices.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/error.h"
#include "base/nearest.h"
#include "formula/lexer.h"
#include "scene/model/values.h"

namespace saddle {
namespace {

Error no_choice(const Slider& slider, const std::string& text, const std::string& message,
                const std::string& more = {}) {
  return {Status::Input,
          message,
          {slider.name, text, {0, text.size()}},
          "choices: " + choices_text(slider) + more};
}

}  // namespace

void set_choices(Slider& slider, std::vector<std::string> names) {
  slider.min = 0;
  slider.max = static_cast<double>(names.size()) - 1;
  slider.step = 1;
  slider.choices = std::move(names);
}

std::string choices_text(const Slider& slider) {
  std::string text;
  for (std::size_t i = 0; i < slider.choices.size(); ++i) {
    text += (i > 0 ? ", " : "") + std::to_string(i) + " " + slider.choices[i];
  }
  return text;
}

void take_choice(const std::vector<Slider>& sliders, const std::vector<Definition>& known,
                 Definition& definition) {
  const auto slider = std::ranges::find(sliders, definition.name, &Slider::name);
  if (definition.is_function || slider == sliders.end() || slider->choices.empty()) return;
  const std::string word = definition.text;
  const auto choice = std::ranges::find(slider->choices, word);
  if (choice != slider->choices.end()) {
    definition.text = std::to_string(choice - slider->choices.begin());
    return;
  }
  const bool is_known = std::ranges::find(known, word, &Definition::name) != known.end();
  if (!is_name(word) || is_known || word == "t") return;
  const auto nearest = nearest_name(word, slider->choices);
  throw no_choice(*slider, word, "there is no choice '" + word + "'",
                  nearest ? "; did you mean '" + *nearest + "'?" : "");
}

void check_choice(const Slider& slider, const Number& value) {
  const double count = static_cast<double>(slider.choices.size());
  if (value >= 0 && value < count && std::floor(value) == value) return;
  throw no_choice(slider, expression_of(value), "there is no choice " + format_number(value));
}

}  // namespace saddle
