// Solids on pages.
#pragma once

#include <vector>

#include "export/page_code.h"

namespace saddle {

/// Makes surfaces of their own of the parts of solids, each with one material on both sides. Their
/// meshes have Mesh::solid still; the first one has the lines and the label. `meshes`: empty; keeps
/// what page.meshes is afterwards.
void split_solids(PageScene& page, std::vector<Mesh>& meshes);

}  // namespace saddle
