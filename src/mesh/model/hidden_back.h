// Whether the back of a surface can be seen from outside.
#pragma once

#include "mesh/model/mesh.h"

namespace saddle {

/// It is proved that nobody outside of the mesh sees its back: it is closed, and winds around no
/// point a negative number of times. For on the way from outside, around which it winds 0 times, a
/// back would lead to a place around which it winds -1 times.
///
/// The proof shrinks the surface to a point or a curve: to the middle of its box, or each stretch
/// of it between two lines of constant u, or of constant v, to the middle of that. The tetrahedra
/// that its triangles sweep add up to the winding number, as a point or a curve has none; if all of
/// them are the right way out, it is not negative. So star-shaped surfaces pass, and tubes around a
/// curve. Others may hide their backs too: false means unknown. Source: the prism operator of
/// homology; A. Hatcher, "Algebraic Topology", 2002, section 2.1.
bool hides_its_back(const Mesh& mesh);

}  // namespace saddle
