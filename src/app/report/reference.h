// Pictures that must not change: --reference.
#pragma once

#include <string>

#include "base/image.h"

namespace saddle {

/// A reference and the picture of a run that is compared with it.
class ReferenceCheck {
 public:
  /// Reads the reference that `path` names. Throws Error as read_png() does.
  ReferenceCheck(std::string path, double threshold);

  void take(const Image& picture) { picture_ = picture; }

  /// After take(): throws Error (Machine) with the figures, after writing a picture of the
  /// difference to `path`.diff.png, if the error is more than `threshold`. Returns the figures as a
  /// sentence otherwise.
  std::string compare() const;

 private:
  std::string path_;
  double threshold_;
  Image reference_;
  Image picture_;
};

}  // namespace saddle
