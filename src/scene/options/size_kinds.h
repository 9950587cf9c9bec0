// Sizes as values of options and scene keys: of pictures, grids, distances, boxes.
#pragma once

#include <optional>
#include <string>

#include "scene/model/resolver.h"
#include "scene/model/scene.h"
#include "scene/options/value_source.h"

namespace saddle::kinds {

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
  std::optional<GridSize>* value;

  void parse(const Given& given) const;
  void clear() const { value->reset(); }
  std::string format() const;
  void read(const InFile& in) const;
  std::string write() const;
};

/// Bytes with a unit: 2GB, 500MB, 1.5GiB.
struct MemorySize {
  double* value;

  void parse(const Given& given) const;
  std::string format() const;
  void read(const InFile& in) const;
  std::string write() const;
};

/// MxN cells.
struct Cells {
  std::optional<GridSize>* value;

  void parse(const Given& given) const;
  void clear() const { value->reset(); }
  std::string format() const;
  void read(const InFile& in) const;
  std::string write() const;
};

/// 0.5px, or a share of the bounding box's diagonal.
struct Length {
  std::optional<ToleranceValue>* value;

  void parse(const Given& given) const;
  void clear() const { value->reset(); }
  std::string format() const;
  void read(const InFile& in) const;
  std::string write() const;
};

/// X0:X1,Y0:Y1,Z0:Z1, auto or off.
struct ClipBox {
  Clip* value;

  void parse(const Given& given) const;
  void clear() const { *value = {}; }
  std::string format() const;  ///< nothing for auto
  void read(const InFile& in) const;
  std::string write() const;
};

/// T, T,front or T,back: a number or an expression, in units or as 2mm; or off.
struct Thick {
  std::optional<Thickness>* value;

  void parse(const Given& given) const;
  std::string format() const;
  void read(const InFile& in) const;
  std::string write() const;
  void resolve(Resolver& resolver, const std::string& name) const;
};

}  // namespace saddle::kinds
