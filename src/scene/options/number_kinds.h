// Numbers as values of options and scene keys: alone, as points, as ranges, as moments.
#pragma once

#include <optional>
#include <string>

#include "scene/model/resolver.h"
#include "scene/model/scene.h"
#include "scene/options/run_settings.h"
#include "scene/options/value_source.h"

namespace saddle::kinds {

/// The number that a part of the text is, or an expression that resolve() of the scene will make
/// one. Throws Error (Input) at once for an error in it if the scene is known.
Number parse_expression(const Given& given, Span part);

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

/// X,Y,Z of a length other than 0.
inline Point direction(Vector* value) {
  return {value, true};
}

/// The direction toward the eye: X,Y,Z or a name.
struct ViewDirection : Point {
  explicit ViewDirection(Vector* view) : Point{view, true} {}

  void parse(const Given& given) const;
  void read(const InFile& in) const;
};

/// The same by two angles in degrees: AZIMUTH,ELEVATION. It is kept, and written, as a direction.
struct ViewAngles {
  Vector* value;

  void parse(const Given& given) const;
  void read(const InFile& in) const;
};

/// auto, equal, or X,Y,Z: factors of the axes, more than 0.
struct Stretch {
  AxisScale* value;

  void parse(const Given& given) const;
  void clear() const { *value = {}; }
  std::string format() const;  ///< nothing for auto
  void read(const InFile& in) const;
  std::string write() const;
  void resolve(Resolver& resolver, const std::string& name) const;
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

/// A:B of an animation.
struct Frames {
  std::optional<FrameRange>* value;

  void parse(const Given& given) const;
};

}  // namespace saddle::kinds
