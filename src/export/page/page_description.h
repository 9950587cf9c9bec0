// A page in sentences, for readers who do not see it.
#pragma once

#include <string>

#include "export/common/content.h"

namespace saddle {

/// "A closed surface: x from -3 to 3, y from -3 to 3, z from -1 to 1." A sentence for each surface,
/// of the first few, by its name where there are several. As the meshes have it.
std::string description_of(const PageContent& content);

}  // namespace saddle
