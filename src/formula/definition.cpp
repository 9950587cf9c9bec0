#include "formula/definition.h"

#include <set>
#include <utility>

#include "formula/language.h"
#include "formula/parser.h"

namespace saddle {

std::string display_name(const Definition& definition) {
  if (!definition.is_function) return definition.name;
  std::string text = definition.name + "(";
  for (const std::string& argument : definition.arguments) {
    if (text.back() != '(') text += ", ";
    text += argument;
  }
  return text + ")";
}

FormulaText formula_of(const Definition& definition) {
  return {display_name(definition), definition.text, {0, definition.text.size()}};
}

Error name_error(const Definition& definition, std::string message, std::string hint) {
  return formula_of(definition).error(std::move(message), {0, 0}, std::move(hint));
}

void check_names(const Definition& definition) {
  const std::string& name = definition.name;
  if (name == "u" || name == "v" || name == "t") {
    throw name_error(definition, "'" + name + "' cannot be defined",
                     "u, v and t are what formulas depend on; choose another name");
  }
  const BuiltIn* const built_in = find_built_in(name);
  if (built_in != nullptr && !can_be_hidden(*built_in)) {
    throw name_error(definition, "'" + name + "' is a function of the language",
                     "choose another name");
  }
  std::set<std::string_view> arguments;
  for (const std::string& argument : definition.arguments) {
    if (arguments.insert(argument).second) continue;
    throw name_error(definition, "two arguments are called '" + argument + "'",
                     "give each its own name");
  }
}

bool is_coordinate(std::string_view name) {
  return name == "x" || name == "y" || name == "z" || name == "xyz";
}

void check_type(const Value& value, const Definition& definition) {
  const FormulaText formula = formula_of(definition);
  if (definition.name != "xyz") {
    require_real(value, formula);
  } else if (value.type != Type::Vector3) {
    throw TypeError(formula.error("xyz is " + std::string(name_of(value.type)), formula.part,
                                  "write (a, b, c)"));
  }
}

bool has_diff(const Definition& definition) {
  return names_in(definition.text).contains("diff");
}

}  // namespace saddle
