// The places that values of options and scene keys come from.
#pragma once

#include <string>

#include "scene/model/scene.h"
#include "scene/toml/toml_reader.h"

namespace saddle::kinds {

/// An option on the command line.
struct Given {
  const Scene* scene;                    ///< that it changes; null if it is not known yet
  const std::string& option;             ///< "--size"
  const std::string& text;               ///< its value
  const SurfaceSpec* surface = nullptr;  ///< that it changes; null: none or several
};

/// Where a value stands in a scene file.
struct InFile {
  TomlReader& reader;
  const std::string& subject;  ///< what messages call it
  const TomlValue& value;
};

/// A TOML value that says what the option's text would.
template <typename Parse>
auto read_option(const InFile& in, const char* wanted, Parse parse) {
  const std::string text = in.reader.option(in.subject, in.value, wanted);
  return in.reader.in_place([&] { return parse(in.subject, text); });
}

}  // namespace saddle::kinds
