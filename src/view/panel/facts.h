// Facts that the panel tells: of a picked point, of the meshes, of what to beware of.
#pragma once

#include "view/model/model.h"
#include "view/picture/drawing.h"

namespace saddle {

void show_picked(const Model& model);

/// Triangles, errors, times; and how long a mesh has been in the making.
void show_figures(const Model& model, const Figures& figures);

/// The warnings of the meshes and the picture.
void show_warnings(const Model& model, const Figures& figures);

}  // namespace saddle
