// Fields for numbers of a scene, which may be expressions of the parameters and t.
#pragma once

#include <functional>
#include <string>

#include "view/panel/desk.h"

namespace saddle {

/// A number or an expression. `what` as in Model::edit().
void number_field(Desk& desk, const std::string& label, const std::string& what,
                  const std::function<Number&(Scene&)>& number_in);

/// Three of them in a row.
void vector_field(Desk& desk, const std::string& label, const std::string& what,
                  const std::function<Vector&(Scene&)>& vector_in);

}  // namespace saddle
