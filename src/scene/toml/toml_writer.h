// Values of a Scene as TOML. Source: T. Preston-Werner and others, "TOML v1.0.0", 2021.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "scene/model/scene.h"

namespace saddle {

/// A basic string with everything escaped that TOML requires to be escaped.
std::string toml_string(std::string_view text);

/// A number, or its expression in quotes; with a point where TOML would see an integer of more than
/// 64 bits.
std::string toml_number(const Number& number);

std::string toml_numbers(const std::vector<Number>& numbers);

std::string toml_vector(const Vector& vector);

/// A string where eight bits per channel hold the colour, numbers where they don't.
std::string toml_color(const Color& color);

/// A key, in quotes where it has other letters than those of ASCII.
std::string toml_key(const std::string& name);

/// One name alone, several as an array.
std::string toml_names(const std::vector<std::string>& names);

/// A number of the formula language is one of TOML, too: with digits on both sides of a point and
/// no leading zeros.
bool is_toml_number(std::string_view text);

/// An inline table.
class InlineTable {
 public:
  void add(const std::string& key, const std::string& value) {
    inside_ += (inside_.empty() ? "" : ", ") + key + " = " + value;
  }
  bool empty() const { return inside_.empty(); }
  std::string text() const { return "{ " + inside_ + " }"; }

 private:
  std::string inside_;
};

}  // namespace saddle
