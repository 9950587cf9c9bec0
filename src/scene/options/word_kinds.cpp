#include "scene/options/word_kinds.h"

#include <string>

#include "base/error.h"
#include "formula/lexer.h"
#include "scene/model/assignments.h"
#include "scene/model/values.h"
#include "scene/toml/toml_writer.h"

namespace saddle::kinds {

void Flag::parse(const Given& /*given*/) const {
  *value = toggles ? !*value : true;
}

std::string Flag::format() const {
  return *value ? "true" : "";
}

void Flag::read(const InFile& in) const {
  *value = in.reader.boolean(in.subject, in.value);
}

std::string Flag::write() const {
  return *value ? "true" : "false";
}

void Text::parse(const Given& given) const {
  *value = given.text;
}

void Text::read(const InFile& in) const {
  *value = in.reader.text(in.subject, in.value, wanted);
}

std::string Text::write() const {
  return toml_string(*value);
}

void Title::parse(const Given& given) const {
  scene->title = given.text;
  scene->show_title = true;
}

void Title::read(const InFile& in) const {
  scene->title = in.reader.text(in.subject, in.value, "text in quotes");
}

std::string Title::write() const {
  return toml_string(scene->title);
}

void Labels::parse(const Given& given) const {
  const std::size_t first = given.text.find(',');
  const std::size_t second = first == std::string::npos ? first : given.text.find(',', first + 1);
  const std::size_t third = second == std::string::npos ? second : given.text.find(',', second + 1);
  if (second == std::string::npos || third != std::string::npos) {
    throw Error(Status::Input, "three texts are wanted, with commas between them",
                {given.option, given.text, {0, given.text.size()}},
                "for example --labels x,y,height; a scene file can have commas in them");
  }
  *value = {given.text.substr(0, first), given.text.substr(first + 1, second - first - 1),
            given.text.substr(second + 1)};
}

std::string Labels::format() const {
  return (*value)[0] + "," + (*value)[1] + "," + (*value)[2];
}

void Labels::read(const InFile& in) const {
  constexpr const char* kWanted = "three texts, such as [\"x\", \"y\", \"height\"]";
  const auto& [reader, subject, array] = in;
  if (array.kind != TomlValue::Kind::Array || array.items.size() != value->size()) {
    throw reader.source().wrong_type(subject, array, kWanted);
  }
  for (std::size_t k = 0; k < value->size(); ++k) {
    (*value)[k] = reader.text(subject, array.items[k], kWanted);
  }
}

std::string Labels::write() const {
  return toml_names({value->begin(), value->end()});
}

void Texts::parse(const Given& given) const {
  value->push_back(given.text);
}

void Formula::parse(const Given& given) const {
  *value = given.text == "off" ? std::string() : given.text;
}

void Formula::read(const InFile& in) const {
  *value = in.reader.formula(in.subject, in.value);
}

std::string Formula::write() const {
  return toml_string(*value);
}

void Names::read(const InFile& in) const {
  constexpr const char* kWanted = "a name, or an array of names";
  value->clear();
  if (in.value.kind != TomlValue::Kind::Array) {
    value->push_back(in.reader.text(in.subject, in.value, kWanted));
    return;
  }
  if (in.value.items.empty()) {
    throw in.reader.source().error(in.subject, "there is no node in it", in.value.span,
                                   "leave it out, and the surface is in the world");
  }
  for (const TomlValue& item : in.value.items) {
    value->push_back(in.reader.text(in.subject, item, kWanted));
  }
}

std::string Names::write() const {
  return value->empty() ? "" : toml_names(*value);
}

void Parameters::read(const InFile& in) const {
  constexpr const char* kWanted = "two names, such as [\"theta\", \"phi\"]";
  if (in.value.kind != TomlValue::Kind::Array || in.value.items.size() != 2) {
    throw in.reader.source().wrong_type(in.subject, in.value, kWanted);
  }
  for (std::size_t k = 0; k < 2; ++k) {
    const TomlValue& item = in.value.items[k];
    (*value)[k] = meant_name(in.reader.text(in.subject, item, kWanted));
    const std::string fault = fault_of_parameter((*value)[k]);
    if (fault.empty()) continue;
    throw in.reader.source().error(in.subject, fault, item.span, "choose another name");
  }
  if ((*value)[0] != (*value)[1]) return;
  throw in.reader.source().error(in.subject, "both parameters are called '" + (*value)[0] + "'",
                                 in.value.span, "give each its own name");
}

std::string Parameters::write() const {
  return "[" + toml_string((*value)[0]) + ", " + toml_string((*value)[1]) + "]";
}

void Choice::parse(const Given& given) const {
  set(parse_choice(given.option, given.text, words));
}

void Choice::read(const InFile& in) const {
  std::string wanted;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) wanted += i + 1 < words.size() ? ", " : " or ";
    wanted += toml_string(words[i]);
  }
  const std::string text = in.reader.text(in.subject, in.value, wanted.c_str());
  in.reader.in_place([&] { set(parse_choice(in.subject, text, words)); });
}

bool Choice::clear() const {
  if (unset) unset();
  return unset != nullptr;
}

std::string Choice::format() const {
  const std::optional<std::size_t> place = get();
  return place ? words[*place] : "";
}

std::string Choice::write() const {
  const std::string word = format();
  return word.empty() ? "" : toml_string(word);
}

}  // namespace saddle::kinds
