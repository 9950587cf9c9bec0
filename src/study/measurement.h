// One measurement of a study: a point of the chart.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace saddle {

/// Times of a piece of work that was repeated, in milliseconds.
struct Timing {
  double median = 0;
  double low = 0;  ///< a quarter of the times are below, and a quarter above `high`
  double high = 0;
};

/// Called with the share of the work that is done, about, and what comes next.
using StudyProgress = std::function<void(double share, const std::string& what)>;

/// How far the work of one panel is: first the truth is found, then settings are measured.
class PanelProgress {
 public:
  /// The truth comes next. `settings`: as many are measured, at most.
  PanelProgress(const StudyProgress& progress, std::size_t settings);
  /// A setting comes next.
  void next(const std::string& method, const std::string& setting);

 private:
  const StudyProgress& progress_;
  double settings_;
  double begun_ = 0;
};

/// Does the work until the median is worth something, once at least, and a few seconds at most
/// unless a single time takes longer.
Timing time_repeatedly(const std::function<void()>& work);
/// The same; none if the work throws Error (Nothing): a coarse grid may miss all of the surface.
std::optional<Timing> time_unless_nothing(const std::function<void()>& work);

enum class StudyPanel { Evaluation, Normals, Mesh, Image };
const char* panel_name(StudyPanel panel);

/// One method at one setting.
struct Measurement {
  StudyPanel panel = StudyPanel::Evaluation;
  std::string method;
  std::string setting;
  Timing time;
  double error = 0;               ///< against the truth, not against itself
  std::string unit;               ///< of the error
  std::optional<double> promise;  ///< the error that the method claimed to stay within
  std::size_t triangles = 0;
  bool no_answer = false;  ///< somewhere the method had none; the error is the largest there is
  bool is_limit = false;   ///< no method, but what none can do better than
  bool is_choice = false;  ///< saddle itself does it this way unless it is told otherwise
  bool is_asked = false;   ///< the grid of --samples
  bool pareto = false;     ///< no other of its panel is both faster and more accurate

  bool kept_promise() const { return !promise || error <= *promise; }
};

/// Marks, panel by panel, what nothing else beats in both time and error.
void mark_pareto(std::vector<Measurement>& measurements);

}  // namespace saddle
