// The kinds of values that options and scene keys have. A kind points at a value of its owner, and
// knows its text on the command line, its TOML and its limits.
//
//   parse    the command line's text into the value. Throws Error (Input) with the place in it
//   clear    back to the default that has no text
//   format   the text that parse() would take; empty where there is nothing to say
//   read     a TOML value into the value. Throws Error (Input) with the place in the file
//   write    as TOML; empty where there is nothing to say
//   resolve  expressions become numbers, within their limits
//
// A kind without read and write is for options alone, one without parse and format for keys alone.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <variant>

#include "scene/model/resolver.h"
#include "scene/model/scene.h"
#include "scene/options/color_kinds.h"
#include "scene/options/contour_kinds.h"
#include "scene/options/number_kinds.h"
#include "scene/options/size_kinds.h"
#include "scene/options/texture_kinds.h"
#include "scene/options/value_source.h"
#include "scene/options/word_kinds.h"

namespace saddle::kinds {

/// A value that need not be there: `kind` of what is in the optional.
template <typename Kind, typename Value>
struct Maybe {
  std::optional<Value>* value;
  Kind kind;  ///< its pointer is filled in

  void parse(const Given& given) const { change(&Kind::parse, given); }
  void clear() const { value->reset(); }
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

using Slot = std::variant<Flag, Text, Title, Labels, Texts, Formula, Ends, Times, Moment, Names,
                          Parameters, Real, Plain, Whole, Point, ViewDirection, ViewAngles, Stretch,
                          Paint, Side, ColormapName, ColorEndsOf, Contours, Choice, PictureSize,
                          GridLines, Cells, Length, ClipBox, Thick, Frames, TexturePictureOf,
                          TextureRepeat, Maybe<Real, Number>, Maybe<Point, Vector>,
                          Maybe<Whole, int>, Maybe<Plain, double>, Maybe<MemorySize, double>>;

}  // namespace saddle::kinds
