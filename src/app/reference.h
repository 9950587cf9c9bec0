// Pictures that must not change: --reference.
#pragma once

#include <string>

#include "base/image.h"

namespace saddle {

/// Compares the picture with the reference that `path` names. Throws Error (Machine) with the
/// figures, after writing a picture of the difference to `path`.diff.png, if the error is more than
/// `threshold`. Returns the figures as a sentence otherwise.
std::string check_against_reference(const Image& image, const Image& reference,
                                    const std::string& path, double threshold);

}  // namespace saddle
