#include "export/formats/losses.h"

#include <algorithm>
#include <cstddef>

#include "base/error.h"
#include "base/format.h"
#include "export/meshes/placed_meshes.h"
#include "scene/model/theme.h"

namespace saddle {
namespace {

/// Digits of the rounding in a warning.
constexpr int kToldDigits = 2;

/// The thickness that a warning proposes, as a share of the diagonal: walls that look thin and
/// hold.
constexpr double kHintedThickness = 0.02;

/// More triangles than this are slow in a browser: without a graphics card, a torus of twice as
/// many took Chromium nine seconds on two busy cores.
constexpr std::size_t kMostOnPages = 500'000;

/// "a", "a and b", "a, b and c".
std::string listed(const std::vector<std::string>& words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) {
    text += i == 0 ? "" : i + 1 == words.size() ? " and " : ", ";
    text += words[i];
  }
  return text;
}

std::string counted(std::size_t count, const std::string& noun) {
  return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

bool same_color(const Color& a, const Color& b) {
  return a.r == b.r.value && a.g == b.g.value && a.b == b.b.value;
}

/// A part of a scene that formats may have no room for.
struct Feature {
  bool Holds::*held;
  const char* name;
  bool (*is_there)(const Scene& scene, const ExportedMesh& placed);
  bool Holds::*held_of_solids = held;
};

/// Colours that a scene has without being asked are no loss; grid lines are not, either.
constexpr Feature kFeatures[] = {
    {&Holds::front, "the colour of --front",
     [](const Scene& scene, const ExportedMesh& placed) {
       return !placed.scale && !placed.spec->is_stroke() &&
              !same_color(placed.spec->front.diffuse, look_of(scene.theme).front.diffuse);
     }},
    {&Holds::back, "the colour of --back",
     [](const Scene& scene, const ExportedMesh& placed) {
       return !placed.scale && !placed.spec->is_stroke() &&
              !same_color(placed.spec->back.diffuse, look_of(scene.theme).back.diffuse);
     },
     &Holds::front},
    {&Holds::numbers, "the colours of --color",
     [](const Scene&, const ExportedMesh& placed) { return placed.scale.has_value(); }},
    {&Holds::texture, "the texture",
     [](const Scene&, const ExportedMesh& placed) { return bool(placed.spec->texture); }},
    {&Holds::opacity, "--opacity",
     [](const Scene&, const ExportedMesh& placed) { return placed.spec->opacity < 1; }},
    {&Holds::lines, "the level lines of --contours",
     [](const Scene&, const ExportedMesh& placed) { return !placed.mesh->contours.lines.empty(); }},
};

/// ".obj and .glb", the formats of meshes with room for all of these features.
std::string formats_with(const std::vector<const Feature*>& features) {
  std::vector<std::string> names;
  for (const Format& format : formats()) {
    if (format.kind != Format::Kind::Mesh) continue;
    const auto holds = [&](const Feature* feature) { return format.holds.*(feature->held); };
    if (std::ranges::all_of(features, holds)) names.push_back("." + std::string(format.extension));
  }
  return listed(names);
}

class LossFinder {
 public:
  LossFinder(const Format& format, const MeshContent& content)
      : format_(format), content_(content), meshes_(placed_meshes(content)) {
    std::erase_if(meshes_, [&](const ExportedMesh& placed) {
      return placed.is_line && !format.holds.strokes;
    });
  }

  std::vector<Loss> find() {
    add_lines();
    add_features();
    if (!format_.holds.open) add_open();
    add_rounding();
    if (format_.flattened != nullptr) {
      if (const std::size_t count = format_.flattened(meshes_); count > 0) {
        add(Loss::Kind::Flattened,
            counted(count, "triangle") + " that rounding to floats flattens: left out");
      }
    }
    if (content_.scene.mesh.print_size && format_.unit == 0) {
      add(Loss::Kind::Units, "the file keeps the scene's units, --print-size is not for it");
    }
    return std::move(losses_);
  }

 private:
  void add(Loss::Kind kind, std::string text) { losses_.push_back({kind, std::move(text)}); }

  void add_lines() {
    if (format_.holds.strokes) return;
    const Scene& scene = content_.scene;
    std::vector<std::string> names;
    for (std::size_t i = 0; i < scene.surfaces.size(); ++i) {
      if (is_line(scene, content_.meshes, i)) names.push_back(scene.surfaces[i].name);
    }
    if (names.empty()) return;
    const std::string has = "." + std::string(format_.extension) + " has no lines and dots";
    const std::string way = "--radius makes a tube of a curve and a ball of a point";
    if (names.size() == scene.surfaces.size()) {
      throw Error(Status::Nothing, has + ", and there is nothing else", {}, way);
    }
    add(Loss::Kind::Lines,
        has + ": " + listed(names) + (names.size() == 1 ? " is" : " are") + " left out; " + way);
  }

  void add_features() {
    std::vector<const Feature*> missing;
    std::vector<std::string> names;
    for (const Feature& feature : kFeatures) {
      const auto is_lost = [&](const ExportedMesh& placed) {
        const bool is_held =
            format_.holds.*(placed.mesh->solid ? feature.held_of_solids : feature.held);
        return !is_held && feature.is_there(content_.scene, placed);
      };
      if (std::ranges::none_of(meshes_, is_lost)) continue;
      missing.push_back(&feature);
      names.emplace_back(feature.name);
    }
    if (missing.empty()) return;
    const std::string others = formats_with(missing);
    const bool one = names.size() == 1 && missing[0]->held != &Holds::numbers &&
                     missing[0]->held != &Holds::lines;
    add(Loss::Kind::LeftOut, listed(names) + (one ? " is" : " are") + " left out" +
                                 (others.empty() ? "" : "; " + others + " can hold all of it"));
  }

  void add_open() {
    Topology all;
    for (const ExportedMesh& placed : meshes_) {
      const Topology& one = content_.shells[placed.surface].topology;
      all.open_edges += one.open_edges;
      all.shared_edges += one.shared_edges;
      all.orientable = all.orientable && one.orientable;
    }
    std::vector<std::string> reasons;
    if (all.open_edges > 0) reasons.push_back(counted(all.open_edges, "open edge"));
    if (all.shared_edges > 0) {
      reasons.push_back(counted(all.shared_edges, "edge") + " of more than two triangles");
    }
    if (!all.orientable) reasons.emplace_back("a one-sided surface");
    if (reasons.empty()) return;
    const double thickness =
        kHintedThickness * bounds_of(meshes_, false).diagonal() / content_.factor;
    add(Loss::Kind::Open, "no solid that can be printed: " + listed(reasons) + "; --thickness " +
                              rounded(thickness, 1) + " makes one");
  }

  void add_rounding() {
    if (format_.holds.doubles) return;
    const double rounding = float_rounding(meshes_);
    if (!(rounding > kFloatRounding)) return;
    add(Loss::Kind::Rounded, "positions are rounded by up to " + rounded(rounding, kToldDigits) +
                                 " of the diagonal; .ply and .obj have doubles");
  }

  const Format& format_;
  const MeshContent& content_;
  std::vector<ExportedMesh> meshes_;
  std::vector<Loss> losses_;
};

}  // namespace

std::vector<Loss> losses_of(const Format& format, const MeshContent& content) {
  return LossFinder(format, content).find();
}

std::vector<Loss> losses_of(const Format& format, const PageContent& content) {
  if (!format.takes_sliders) return {};  // a figure has an image of them
  std::size_t triangles = 0;
  for (const Mesh& mesh : content.meshes) triangles += mesh.triangles.size();
  if (triangles <= kMostOnPages) return {};
  return {{Loss::Kind::Heavy, std::to_string(triangles) +
                                  " triangles, which browsers may take seconds to show; a larger "
                                  "--tolerance needs fewer"}};
}

double factor_of(const Format& format, const MeshContent& content) {
  const std::optional<Number>& size = content.scene.mesh.print_size;
  if (!size || format.unit == 0) return 1;
  MeshContent own = content;
  own.factor = 1;
  own.y_up = false;
  const Bounds bounds = bounds_of(placed_meshes(own), format.holds.strokes);
  const double longest = bounds.empty() ? 0 : largest_of(bounds.size());
  return longest > 0 ? size->value / format.unit / longest : 1;
}

}  // namespace saddle
