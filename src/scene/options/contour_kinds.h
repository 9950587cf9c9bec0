// Level lines and the ends of a colour bar as values of options and scene keys.
#pragma once

#include <string>
#include <vector>

#include "scene/model/resolver.h"
#include "scene/model/scene.h"
#include "scene/options/value_source.h"

namespace saddle::kinds {

/// A:B or symmetric: the ends of the colour bar of a surface that has something to colour.
struct ColorEndsOf {
  SurfaceSpec* surface;

  void parse(const Given& given) const;  ///< "off": all that is drawn
  void clear() const { surface->color_ends.reset(); }
  std::string format() const;  ///< nothing for the default
  void read(const InFile& in) const;
  std::string write() const;
  void resolve(Resolver& resolver, const std::string& name) const;
};

/// EXPR or EXPR=A,B,...: each time the option is given it adds one. Levels of an expression that is
/// there already join its own; without levels it gets round ones.
struct Contours {
  std::vector<ContourSpec>* value;

  void parse(const Given& given) const;  ///< "off": none
  void clear() const { value->clear(); }
  std::vector<std::string> texts() const;
  void read(const InFile& in) const;
  std::string write() const;
  void resolve(Resolver& resolver, const std::string& name) const;
};

}  // namespace saddle::kinds
