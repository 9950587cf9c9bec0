// The work that the program is at, and how far it is: for a progress bar.
#pragma once

#include <cstddef>
#include <string>

namespace saddle {

/// Some work of the first thread, while it lives; work within it is told, too. On other threads it
/// tells nothing: many are at the same work then.
class Activity {
 public:
  /// `what`: a literal, empty for work that needs no name. `all`: how many pieces of work there
  /// are, 0 if they are not counted.
  explicit Activity(const char* what, std::size_t all = 0);
  ~Activity();
  Activity(const Activity&) = delete;
  Activity& operator=(const Activity&) = delete;

  /// One more piece is done. From any thread.
  void advance();
  /// The share of the work, or of the piece at hand, that is done: 0 to 1. From any thread.
  void set_share(double share);
  /// Names the piece at hand.
  void set_detail(const std::string& text);

 private:
  int level_;  ///< -1: it is not told
};

/// set_share() of the innermost activity, for code that does not know which that is. Costs some
/// nanoseconds, and does nothing on other threads than the first.
void tell_share(double share);

/// "frame 3 of 120, meshing", and the share of all work that is done.
struct ActivityNow {
  std::string what;
  double share = 0;
};

ActivityNow current_activity();

}  // namespace saddle
