// Findings about a mesh: what a user would not expect of it, and what is not proved. Warnings are
// the sentences of those that would mislead if they were not told.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "mesh/model/mesh_report.h"
#include "surface/surface.h"

namespace saddle {

struct Finding {
  enum class Kind : std::uint8_t {
    Undefined,       ///< part of the domain has no surface
    Flat,            ///< triangles without area are left out
    OffTolerance,    ///< the mesh is off, or a limit stopped it before its tolerance
    NormalsTurn,     ///< normals turn faster than triangles show
    Pole,            ///< the surface goes to infinity
    Jump,            ///< the surface jumps
    NoLimit,         ///< each way to a point leads to another place
    Clipped,         ///< the mesh is cut along a box that saddle chose
    OneSided,        ///< the surface is not orientable
    Backwards,       ///< a range runs backwards
    NoNormal,        ///< singular points have no normal
    ColorUndefined,  ///< part of the surface has no colour
    ColorInfinite,   ///< the colour's range is cut
    ColorCoarse,     ///< triangles are too large for the colour
    ContoursNone,    ///< an expression has no level line
    ContoursOnArea,  ///< it has a level on a whole area
    ContoursCoarse,  ///< triangles are too large for its lines
    TooThick,        ///< a solid is thicker than its surface bends
    SolidCrosses,    ///< a solid goes through itself
    Unproved,        ///< a feature could hide between the samples
    Nothing,         ///< a frame of an animation has no surface
    NoLight,         ///< no light of the scene is on
    ConeLost,        ///< a spot light's cone falls between vertices that are lit
  };
  /// A box of parameters; a point if its ends are equal.
  struct Place {
    dvec2 low, high;
  };

  Kind kind;
  std::string text;    ///< one sentence, without the surface's name
  bool warns = false;  ///< it would mislead if it were not told
  std::optional<double> value = std::nullopt;
  std::string unit = {};  ///< of the value
  std::optional<Place> place = std::nullopt;
  /// The part of the domain; of the area for a colour; of the cone's light.
  std::optional<double> share = std::nullopt;
};

/// The kind in the report.
std::string name_of(Finding::Kind kind);

/// At most one finding of each kind, with its count; one of Unproved for each reason.
/// `shares_limits`: the limits of the mesh are a share of those of all surfaces.
std::vector<Finding> mesh_findings(const MeshResult& mesh, const Domain& domain,
                                   bool shares_limits = false);

/// The sentences of the findings that warn, each after the surface's name.
std::vector<std::string> warnings_of(const std::string& name, std::span<const Finding> findings);

/// Where the surface is defined: the box around the mesh's parameters, if it is smaller than the
/// domain, else only that it is in places.
std::string where_defined(const Mesh& mesh, const Domain& domain);

}  // namespace saddle
