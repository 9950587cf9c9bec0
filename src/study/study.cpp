#include "study/study.h"

#include <algorithm>
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

/// Adds a surface's measurement to those of others.
void add_to(Measurement& sum, const Measurement& other) {
  sum.time.median += other.time.median;
  sum.time.low += other.time.low;
  sum.time.high += other.time.high;
  sum.error = std::max(sum.error, other.error);
  if (sum.promise && other.promise) sum.promise = std::max(*sum.promise, *other.promise);
  sum.triangles += other.triangles;
  sum.no_answer = sum.no_answer || other.no_answer;
  sum.is_choice = sum.is_choice && other.is_choice;
  sum.pareto = false;
}

}  // namespace

std::vector<Measurement> together(const std::vector<std::vector<Measurement>>& surfaces) {
  std::vector<Measurement> all;
  for (const Measurement& first : surfaces.at(0)) {
    Measurement sum = first;
    const auto is_in = [&](const std::vector<Measurement>& other) {
      const auto found = std::ranges::find_if(other, [&](const Measurement& m) {
        return m.panel == first.panel && m.method == first.method && m.setting == first.setting;
      });
      if (found == other.end()) return false;
      add_to(sum, *found);
      return true;
    };
    if (std::all_of(surfaces.begin() + 1, surfaces.end(), is_in)) all.push_back(sum);
  }
  mark_pareto(all);
  return all;
}

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
