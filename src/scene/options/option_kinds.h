// The kinds of values that options and scene keys have. A kind points at a value of its owner, and
// knows its text on the command line, its TOML and its limits.
//
//   parse    the command line's text into the value. Throws Error (Input) with the place in it
//   format   the text that parse() would take; empty where there is nothing to say
//   read     a TOML value into the value. Throws Error (Input) with the place in the file
//   write    as TOML; empty where there is nothing to say
//   resolve  expressions become numbers, within their limits
//
// A kind without read and write is for options alone, one without parse and format for keys alone.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "scene/model/resolver.h"
#include "scene/model/scene.h"
#include "scene/model/values.h"
#include "scene/options/run_settings.h"
#include "scene/toml/toml_reader.h"

namespace saddle::kinds {

/// An option on the command line.
struct Given {
  const Scene& scene;         ///< that it changes
  const std::string& option;  ///< "--size"
  const std::string& text;    ///< its value
};

/// Where a value stands in a scene file.
struct InFile {
  TomlReader& reader;
  const std::string& subject;  ///< what messages call it
  const TomlValue& value;
};

/// true or false; an option without a value.
struct Flag {
  bool* value;
  bool toggles = false;  ///< the option swaps what the scene has

  void parse(const Given& given) const;
  std::string format() const;
  void read(const InFile& in) const;
  std::string write() const;
};

/// A text.
struct Text {
  std::string* value;
  const char* wanted = "text in quotes";

  void parse(const Given& given) const;
  std::string format() const { return *value; }
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

/// [MIN, MAX]: the range of u or v.
struct Ends {
  Range* value;

  void read(const InFile& in) const;
  std::string write() const;
};

/// [FROM, TO]: the range of time.
struct Times {
  Scene* scene;

  void read(const InFile& in) const;
  std::string write() const;
  void resolve(Resolver& resolver, const std::string& name) const;
};

/// The moment that is drawn.
struct Moment {
  Scene* scene;

  void parse(const Given& given) const;
  std::string format() const;  ///< nothing at the start of the range of time
  void read(const InFile& in) const;
  std::string write() const;
};

/// Names of nodes.
struct Names {
  std::vector<std::string>* value;

  void read(const InFile& in) const;
  std::string write() const;
};

/// A number, or an expression of the parameters and t. No value: an `optional` that has none.
struct Real {
  Number* value;
  Limits limits;

  void parse(const Given& given) const;
  std::string format() const;
  void read(const InFile& in) const;
  std::string write() const;
  void resolve(Resolver& resolver, const std::string& name) const;
};

/// A number that no expression can be.
struct Plain {
  double* value;
  Limits limits;

  void parse(const Given& given) const;
  std::string format() const;
  void read(const InFile& in) const;
  std::string write() const;
};

/// A whole number from `low` to `high`.
struct Whole {
  int* value;
  int low;
  int high;

  void parse(const Given& given) const;
  std::string format() const;
  void read(const InFile& in) const;
  std::string write() const;
};

/// X,Y,Z.
struct Point {
  Vector* value;
  bool direction = false;  ///< it has a length other than 0

  void parse(const Given& given) const;
  std::string format() const;
  void read(const InFile& in) const;
  std::string write() const;
  void resolve(Resolver& resolver, const std::string& name) const;
};

/// A colour that may be see-through.
struct Paint {
  Color* value;

  void parse(const Given& given) const;
  std::string format() const;
  void read(const InFile& in) const;
  std::string write() const;
  void resolve(Resolver& resolver, const std::string& name) const;
};

/// The material of one side. The option is its diffuse colour.
struct Side {
  Material* value;
  const Material* standard;  ///< values equal to these are not written

  void parse(const Given& given) const;
  std::string format() const;
  void read(const InFile& in) const;
  std::string write() const;
  void resolve(Resolver& resolver, const std::string& name) const;
};

/// The name of a colormap, of a surface that has something to colour.
struct ColormapName {
  SurfaceSpec* surface;

  void parse(const Given& given) const;
  std::string format() const;  ///< nothing for the default
  void read(const InFile& in) const;
  std::string write() const;
};

/// One of a few words.
struct Choice {
  std::vector<std::string> words;
  std::function<std::optional<std::size_t>()> get;  ///< none: a value without a word
  std::function<void(std::size_t)> set;

  void parse(const Given& given) const;
  std::string format() const;
  void read(const InFile& in) const;
  std::string write() const;
};

/// A choice of an enum's values, each with its word.
template <typename Enum>
Choice choice(Enum* value, const std::vector<std::pair<const char*, Enum>>& words) {
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
  return result;
}

/// WxH: the size of a picture.
struct PictureSize {
  PictureSettings* value;

  void parse(const Given& given) const;
  std::string format() const;
  void read(const InFile& in) const;
  std::string write() const;
};

/// MxN lines, or off.
struct GridLines {
  SurfaceSpec* surface;

  void parse(const Given& given) const;
  std::string format() const;
  void read(const InFile& in) const;
  std::string write() const;
};

/// MxN cells.
struct Cells {
  std::optional<GridSize>* value;

  void parse(const Given& given) const;
  std::string format() const;
  void read(const InFile& in) const;
  std::string write() const;
};

/// 0.5px, or a share of the bounding box's diagonal.
struct Length {
  std::optional<ToleranceValue>* value;

  void parse(const Given& given) const;
  std::string format() const;
  void read(const InFile& in) const;
  std::string write() const;
};

/// X0:X1,Y0:Y1,Z0:Z1, auto or off.
struct ClipBox {
  Clip* value;

  void parse(const Given& given) const;
  std::string format() const;  ///< nothing for auto
  void read(const InFile& in) const;
  std::string write() const;
};

/// A:B of an animation.
struct Frames {
  std::optional<FrameRange>* value;

  void parse(const Given& given) const;
};

/// A value that need not be there: `kind` of what is in the optional.
template <typename Kind, typename Value>
struct Maybe {
  std::optional<Value>* value;
  Kind kind;  ///< its pointer is filled in

  void parse(const Given& given) const { change(&Kind::parse, given); }
  std::string format() const { return *value ? inside(**value).format() : ""; }
  void read(const InFile& in) const { change(&Kind::read, in); }
  std::string write() const { return *value ? inside(**value).write() : ""; }
  void resolve(Resolver& resolver, const std::string& name) const {
    if constexpr (requires { kind.resolve(resolver, name); }) {
      if (*value) inside(**value).resolve(resolver, name);
    }
  }

 private:
  Kind inside(Value& target) const {
    Kind result = kind;
    result.value = &target;
    return result;
  }
  template <typename From>
  void change(void (Kind::*how)(const From&) const, const From& from) const {
    Value fresh{};
    (inside(fresh).*how)(from);
    *value = std::move(fresh);
  }
};

using Slot =
    std::variant<Flag, Text, Texts, Formula, Ends, Times, Moment, Names, Real, Plain, Whole, Point,
                 Paint, Side, ColormapName, Choice, PictureSize, GridLines, Cells, Length, ClipBox,
                 Frames, Maybe<Real, Number>, Maybe<Point, Vector>, Maybe<Whole, int>>;

}  // namespace saddle::kinds
