// Fields for the keys of scene files, made from the table of options.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "scene/options/options.h"
#include "view/panel/desk.h"

namespace saddle {

/// The value of a row in a scene; nullptr-like rows are not asked for.
using SlotIn = std::function<kinds::Slot(Scene&)>;

/// A field for one key: a box to tick, words to choose from, or a text, which is taken as soon as
/// it is a value. `owner` tells it from the same key of other objects.
void option_field(Desk& desk, const Option& option, const std::string& owner,
                  const SlotIn& slot_in);

/// Fields for all keys of the scene file's top that are not shown elsewhere, of the camera, a
/// surface, a curve and a point.
void scene_fields(Desk& desk);
void camera_fields(Desk& desk);
void surface_fields(Desk& desk, std::size_t index);
void curve_fields(Desk& desk, std::size_t index);
void point_fields(Desk& desk, std::size_t index);

}  // namespace saddle
