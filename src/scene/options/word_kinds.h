// Words as values of options and scene keys: yes or no, texts, formulas, names, choices.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "scene/options/value_source.h"

namespace saddle::kinds {

/// true or false; an option without a value.
struct Flag {
  bool* value;
  bool toggles = false;  ///< the option swaps what the scene has

  void parse(const Given& given) const;
  std::string format() const;
  void read(const InFile& in) const;
  std::string write() const;
};

/// An option that swaps what the scene has.
inline Flag toggle(bool* value) {
  return {value, true};
}

/// A text.
struct Text {
  std::string* value;
  const char* wanted = "text in quotes";

  void parse(const Given& given) const;
  std::string format() const { return *value; }
  void read(const InFile& in) const;
  std::string write() const;
};

/// The scene's title. The option also has it drawn.
struct Title {
  Scene* scene;

  void parse(const Given& given) const;
  std::string format() const { return scene->show_title ? scene->title : ""; }
  void read(const InFile& in) const;
  std::string write() const;
};

/// X,Y,Z: texts of the axes.
struct Labels {
  std::array<std::string, 3>* value;

  void parse(const Given& given) const;
  std::string format() const;
  void read(const InFile& in) const;
  std::string write() const;
};

/// Each time the option is given it adds one.
struct Texts {
  std::vector<std::string>* value;

  void parse(const Given& given) const;
};

/// An expression of u and v.
struct Formula {
  std::string* value;

  void parse(const Given& given) const;  ///< "off": none
  std::string format() const { return *value; }
  void read(const InFile& in) const;
  std::string write() const;
};

/// Names of nodes.
struct Names {
  std::vector<std::string>* value;

  void read(const InFile& in) const;
  std::string write() const;
};

/// The names of a surface's two parameters.
struct Parameters {
  ParameterNames* value;

  void read(const InFile& in) const;
  std::string write() const;
};

/// One of a few words.
struct Choice {
  std::vector<std::string> words;
  std::function<std::optional<std::size_t>()> get;  ///< none: a value without a word
  std::function<void(std::size_t)> set;
  std::function<void()> unset = {};  ///< back to no word; none where there is always one

  bool clear() const;

  void parse(const Given& given) const;
  std::string format() const;
  void read(const InFile& in) const;
  std::string write() const;
};

/// A choice of an enum's values, each with its word. `Value`: Enum, or an optional one.
template <typename Value, typename Enum>
Choice choice(Value* value, const std::vector<std::pair<const char*, Enum>>& words) {
  Choice result;
  std::vector<Enum> values;
  for (const auto& [word, each] : words) {
    result.words.emplace_back(word);
    values.push_back(each);
  }
  result.get = [value, values]() -> std::optional<std::size_t> {
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (values[i] == *value) return i;
    }
    return std::nullopt;
  };
  result.set = [value, values](std::size_t i) { *value = values[i]; };
  if constexpr (std::is_same_v<Value, std::optional<Enum>>) {
    result.unset = [value] { value->reset(); };
  }
  return result;
}

}  // namespace saddle::kinds
