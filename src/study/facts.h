// Facts about a surface beyond its mesh, for `saddle check`.
#pragma once

#include <string>
#include <vector>

#include "mesh/model/mesh.h"
#include "mesh/model/mesh_report.h"
#include "mesh/model/topology.h"
#include "study/measures.h"
#include "surface/defined_share.h"

namespace saddle {

/// A singular point and the limits of the unit normal there, from the sides that have one: one
/// limit if they agree, none if no side has one.
struct SingularPlace {
  dvec2 uv;
  dvec3 position;
  std::vector<dvec3> normals;
  bool is_alone = false;  ///< as in the mesh's report
};

/// Whether a surface is closed. A closed mesh does not show it of the surface.
enum class Closed { No, Unknown, Yes };

struct Facts {
  Domain domain;
  std::string where;    ///< the condition, as it was written
  std::string range_v;  ///< as it was written, where its ends depend on u
  DefinedShare defined;
  Topology topology;
  bool turns_over = false;  ///< Parts::turn_over()
  Measures measures;
  std::vector<SingularPlace> singular;  ///< those of the mesh's report
  std::vector<double> singular_u, singular_v;
  Closed closed = Closed::No;
};

/// For a surface of second order and its mesh, all of it or what is left in a box. `share`: of the
/// work that does not grow with the mesh, less for one of many surfaces.
Facts gather_facts(const Surface& surface, const Mesh& mesh, const MeshReport& report,
                   bool is_clipped, unsigned threads, double share = 1);

}  // namespace saddle
