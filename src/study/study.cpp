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

const char* method_of(Shading shading) {
  switch (shading) {
    case Shading::Vertex:
      return "per vertex";
    case Shading::Exact:
      return "exact normal";
    case Shading::Pixel:
    case Shading::Unlit:  // it is as fast, and there is no error of light
      break;
  }
  return "per pixel";
}

/// Marks the method and setting of each panel that saddle uses unless it is told otherwise. A study
/// that broke off before has none.
void mark_choices(const Subject& subject, std::vector<Measurement>& measurements) {
  const char* const shading = method_of(shading_of(subject.scene, subject.spec));
  Measurement* hoisted = nullptr;  // the last one has all threads
  for (Measurement& m : measurements) {
    if (m.panel == StudyPanel::Evaluation && m.method == "tape hoisted") hoisted = &m;
    const bool has_tolerance = m.setting == "0.5 px";
    m.is_choice =
        (m.panel == StudyPanel::Normals && m.method == "derivative with limits") ||
        (m.panel == StudyPanel::Mesh && m.method == "adaptive certified" && has_tolerance) ||
        (m.panel == StudyPanel::Image && m.method == shading && has_tolerance);
  }
  if (hoisted != nullptr) hoisted->is_choice = true;
}

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
  mark_choices(subject, all);
  return all;
}

}  // namespace saddle
