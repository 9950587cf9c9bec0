#include "export/figures/figure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <glm/common.hpp>

#include "export/figures/visible_lines.h"
#include "render/picture/picture.h"
#include "render/picture/picture_in_tiles.h"
#include "scene/model/color_scale.h"
#include "scene/model/instances.h"
#include "scene/model/strokes.h"
#include "scene/model/theme.h"

namespace saddle {
namespace {

/// Pixels of the image for one of the picture's, each way: print shows more than a screen.
constexpr int kFiner = 2;
/// Curves and dots are nearer to the eye than what they lie on by so many half widths and pixels,
/// level lines by these pixels: as pictures have them.
constexpr double kHalfWidthsNearer = 2;
constexpr double kPixelsNearer = 2;
constexpr double kContourNearer = 1;
/// The box is less conspicuous than its labels.
constexpr double kBoxInk = 0.3;

void check_size(const Scene& scene) {
  const int most = kMaxPixels / kFiner;
  if (scene.picture.width <= most && scene.picture.height <= most) return;
  throw Error(Status::Input, "a figure has at most " + std::to_string(most) + " pixels each way",
              {"--size", {}, {}}, "its lines and letters are as sharp in a smaller one");
}

class FigureMaker {
 public:
  explicit FigureMaker(const PageContent& content)
      : scene_(content.seen),
        meshes_(content.meshes),
        size_(scene_.picture.width, scene_.picture.height),
        camera_(fit_to_meshes(scene_, meshes_, size_)),
        depths_(camera_, size_) {
    for (const Instance& instance : instances(scene_)) {
      const Mesh mesh = transformed(meshes_[instance.surface], instance.to_world);
      bounds_.add(mesh.bounds);
      if (scene_.surfaces[instance.surface].opacity < 1) continue;
      for (const Triangle& t : mesh.triangles) {
        depths_.add({mesh.position[t[0]], mesh.position[t[1]], mesh.position[t[2]]});
      }
    }
    if (scene_.box) bounds_.add(*scene_.box);
  }

  Figure make(const PageContent& content) {
    Figure figure;
    figure.size = size_;
    figure.ink = ink_of(scene_);
    figure.rim = rim_of_letters(scene_);
    PictureSettings finer = scene_.picture;
    finer.width *= kFiner;
    finer.height *= kFiner;
    figure.image = render_surfaces(scene_, meshes_, camera_, finer, content.renderer);
    for (const Instance& instance : instances(scene_)) add_lines(figure, instance);
    annotate_figure(figure);
    return figure;
  }

 private:
  std::vector<dvec3> places(const Instance& instance, const std::vector<std::uint32_t>& chain,
                            const auto& positions) const {
    std::vector<dvec3> result;
    result.reserve(chain.size());
    for (const std::uint32_t i : chain) {
      result.emplace_back(instance.to_world * glm::dvec4(positions[i], 1));
    }
    return result;
  }

  void add_chain(FigureLines& lines, std::vector<dvec3> chain, double pixels_nearer) {
    if (chain.size() == 1) chain.push_back(chain[0]);  // a dot
    auto parts = depths_.visible(chain, 2 * pixels_nearer / size_.y);
    std::ranges::move(parts, std::back_inserter(lines.lines));
  }

  void add_lines(Figure& figure, const Instance& instance) {
    const SurfaceSpec& spec = scene_.surfaces[instance.surface];
    const Mesh& mesh = meshes_[instance.surface];
    FigureLines lines{
        {}, {spec.line_color.r, spec.line_color.g, spec.line_color.b}, line_width_of(spec, size_)};
    const bool is_line = spec.is_stroke() && mesh.triangles.empty();
    if (spec.is_stroke() && !is_line) return;
    const double nearer = is_line ? kHalfWidthsNearer * lines.width / 2 + kPixelsNearer : 0;
    for (const auto& chain : mesh.lines) {
      add_chain(lines, places(instance, chain, mesh.position), nearer);
    }
    if (!lines.lines.empty()) figure.lines.push_back(std::move(lines));
    const Color& color = contour_color_of(spec, scene_.theme);
    FigureLines contours{{}, {color.r, color.g, color.b}, contour_width_of(spec, size_)};
    for (const auto& chain : mesh.contours.lines) {
      add_chain(contours, places(instance, chain, mesh.contours.position), kContourNearer);
    }
    if (!contours.lines.empty()) figure.lines.push_back(std::move(contours));
  }

  std::vector<SpaceLabel> labels() const {
    std::vector<SpaceLabel> result;
    for (const Instance& instance : instances(scene_)) {
      const SurfaceSpec& spec = scene_.surfaces[instance.surface];
      const auto& anchor = meshes_[instance.surface].anchor;
      if (spec.label.empty() || !anchor) continue;
      const auto at = pixel_of(camera_, dvec3(instance.to_world * glm::dvec4(*anchor, 1)), size_);
      if (at) result.push_back({spec.label, *at, line_width_of(spec, size_) / 2});
    }
    return result;
  }

  void annotate_figure(Figure& figure) {
    std::vector<std::optional<ColorRange>> ranges;
    for (const Mesh& mesh : meshes_) ranges.push_back(color_range_of(mesh));
    const std::vector<ColorScale> scales = color_scales(scene_, ranges);
    const Annotations all = annotate(scene_, camera_, bounds_, scales, size_, labels());
    figure.bars = all.bars;
    const double width = fit_line_width(size_);
    FigureLines box{{}, glm::mix(dvec3(0.5), figure.ink, kBoxInk), width};
    for (const auto& [a, b] : all.edges) add_chain(box, {a, b}, 0);
    FigureLines strokes{{}, figure.ink, width};
    for (const auto& [a, b] : all.strokes) strokes.lines.push_back({a, b});
    for (FigureLines* const lines : {&box, &strokes}) {
      if (!lines->lines.empty()) figure.lines.push_back(std::move(*lines));
    }
    const Font font;
    for (const WrittenText& text : all.texts) {
      figure.rim_width = std::max(figure.rim_width, 2 * kLetterRim * text.size);
      const dvec2 extent(std::ceil(font.width(text.text, text.size)) + 1,
                         std::ceil(font.height(text.size)));
      for (OutlinePiece piece : font.outlines(text.text, text.size)) {
        piece.to += text.middle - 0.5 * extent;
        piece.control += text.middle - 0.5 * extent;
        figure.letters.push_back(piece);
      }
    }
  }

  const Scene& scene_;
  std::span<const Mesh> meshes_;
  dvec2 size_;
  FittedCamera camera_;
  PictureDepths depths_;
  Bounds bounds_;
};

}  // namespace

double figure_pixels_off(double) {
  return 0.1;
}

Figure make_figure(const PageContent& content) {
  check_size(content.seen);
  return FigureMaker(content).make(content);
}

}  // namespace saddle
