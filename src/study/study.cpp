#include "study/study.h"

#include <array>
#include <iterator>

#include "study/methods.h"

namespace saddle {
namespace {

struct Part {
  Panel panel;
  double start;  ///< share of the time that is over when it begins, about
  std::vector<Measurement> (*measure)(const Subject&);
};

constexpr std::array kParts = {
    Part{Panel::Evaluation, 0, measure_evaluation}, Part{Panel::Normals, 0.1, measure_normals},
    Part{Panel::Mesh, 0.2, measure_meshes}, Part{Panel::Image, 0.6, measure_images}};

}  // namespace

std::vector<Measurement> study(const Subject& subject, const StudyProgress& progress) {
  std::vector<Measurement> all;
  for (const Part& part : kParts) {
    progress(part.start, panel_name(part.panel));
    std::ranges::move(part.measure(subject), std::back_inserter(all));
  }
  mark_pareto(all);
  return all;
}

}  // namespace saddle
