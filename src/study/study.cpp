#include "study/study.h"

#include <array>
#include <iterator>

#include "study/methods.h"

namespace saddle {
namespace {

struct Part {
  StudyPanel panel;
  double start;  ///< share of the time that is over when it begins, about
  std::vector<Measurement> (*measure)(const Subject&, const StudyProgress&);
};

constexpr std::array kParts = {Part{StudyPanel::Evaluation, 0, measure_evaluation},
                               Part{StudyPanel::Normals, 0.03, measure_normals},
                               Part{StudyPanel::Mesh, 0.06, measure_meshes},
                               Part{StudyPanel::Image, 0.45, measure_images}};

}  // namespace

std::vector<Measurement> study(const Subject& subject, const StudyProgress& progress) {
  std::vector<Measurement> all;
  for (std::size_t i = 0; i < kParts.size(); ++i) {
    const Part& part = kParts[i];
    const double end = i + 1 < kParts.size() ? kParts[i + 1].start : 1;
    const auto in_part = [&](double share, const std::string& what) {
      progress(part.start + share * (end - part.start), panel_name(part.panel) + (": " + what));
    };
    std::ranges::move(part.measure(subject, in_part), std::back_inserter(all));
  }
  mark_pareto(all);
  return all;
}

}  // namespace saddle
