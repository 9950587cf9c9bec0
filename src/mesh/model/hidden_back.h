// Whether the back of a surface can be seen from outside.
#pragma once

#include "mesh/model/mesh.h"

namespace saddle {

/// True: proved that no back is visible from outside. The mesh is closed, and its winding number is
/// negative nowhere: a ray from outside, where the number is 0, that meets a back first would enter
/// a region of winding number -1.
///
/// The proof shrinks the surface to a point, the middle of its box, or to a curve: each stretch
/// between two lines of constant u, or of constant v, to the middle of its box. A point and a curve
/// have no winding number, so that the tetrahedra that the triangles sweep add up to the surface's.
/// It is not negative if all tetrahedra are oriented outward, as for star-shaped surfaces and for
/// tubes around a curve. False means unknown. Source: the prism operator of homology; A. Hatcher,
/// "Algebraic Topology", 2002, section 2.1.
bool hides_its_back(const Mesh& mesh);

}  // namespace saddle
