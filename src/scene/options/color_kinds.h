// Colours, materials and colormaps as values of options and scene keys.
#pragma once

#include <string>

#include "scene/model/resolver.h"
#include "scene/model/scene.h"
#include "scene/options/value_source.h"

namespace saddle::kinds {

/// A colour that may be see-through, unless `opaque`.
struct Paint {
  Color* value;
  bool opaque = false;

  void parse(const Given& given) const;
  std::string format() const;
  void read(const InFile& in) const;
  std::string write() const;
  void resolve(Resolver& resolver, const std::string& name) const;
};

/// The material of one side. The option is its diffuse colour.
struct Side {
  Material* value;

  void parse(const Given& given) const;
  std::string format() const;
  void read(const InFile& in) const;
  /// The parts that differ from another side.
  std::string write_beside(const Side& standard) const;
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

}  // namespace saddle::kinds
