#include "render/overlay/annotations.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <glm/common.hpp>
#include <glm/vec4.hpp>

#include "render/overlay/box_edges.h"
#include "scene/model/ticks.h"

namespace saddle {
namespace {

// Lengths in ems, the size of the letters.
constexpr double kTickLength = 0.45;
constexpr double kGap = 0.35;       // of tick and label, of labels and name
constexpr double kApart = 0.5;      // of labels on the same axis, at least
constexpr double kLabelGap = 0.25;  // of a point and its label
constexpr double kTitleSize = 1.25;
constexpr double kTitleGap = 0.8;  // above it
constexpr double kBarWidth = 1.1;
constexpr double kBarMargin = 1.2;    // beside a bar
constexpr double kBarNameGap = 0.75;  // half a label that stands at the bar's end, and some
constexpr double kOnBarEnd = 1e-6;    // a tick that is the end but for rounding
constexpr double kBarStep = 2.5;      // of a bar's ticks, at least

/// Letters are this share of the picture's height, or of three quarters of its width, and no
/// smaller than can be read.
constexpr double kLetters = 1.0 / 46;
constexpr double kNarrow = 0.75;
constexpr double kLeastLetters = 9;

constexpr double kBarHeight = 0.84;   // of the picture's
constexpr double kMostBarName = 0.3;  // of the picture's width
constexpr double kMostLabel = 0.2;    // of the picture's width
constexpr double kLeastRoom = 0.3;    // for the surfaces, of each side
constexpr int kMostTicks = 8;
/// Edges of fewer ems than this, seen almost along themselves, have no ticks.
constexpr double kLeastEdge = 2;

double letters_for(const dvec2& size) {
  return std::max(kLeastLetters, std::round(kLetters * std::min(size.y, kNarrow * size.x)));
}

class Annotator {
 public:
  Annotator(const Scene& scene, const FittedCamera& camera, const Bounds& box, const dvec2& size)
      : scene_(scene),
        box_(box),
        scale_(scene.scale.factors),
        size_(size),
        em_(letters_for(size)),
        edges_(camera, scene.camera.ortho, box, size, kLeastEdge * em_),
        writer_(size) {}

  Annotations take() {
    result_.texts = writer_.texts();
    result_.unknown = writer_.unknown();
    return std::move(result_);
  }

  void add_axes() {
    result_.edges = edges_.drawn();
    std::vector<Edge> edges;
    for (int axis = 0; axis < 3; ++axis) {
      if (const auto edge = edges_.with_ticks(axis)) edges.push_back(*edge);
    }
    for (const Edge& edge : edges) add_ticks(edge);
  }

  /// No text hides what a label is of.
  void keep_places_clear(std::span<const SpaceLabel> labels) {
    for (const SpaceLabel& label : labels) {
      writer_.keep_clear({label.at - dvec2(label.clear), label.at + dvec2(label.clear)});
    }
  }

  void add_label(const SpaceLabel& label) {
    const std::string text = one_line(label.text);
    const double slant = std::sqrt(0.5);
    const std::array<dvec2, 8> ways = {
        dvec2(slant, -slant), dvec2(1, 0),           dvec2(slant, slant), dvec2(0, -1),
        dvec2(0, 1),          dvec2(-slant, -slant), dvec2(-1, 0),        dvec2(-slant, slant)};
    const Rect place{label.at - dvec2(label.clear), label.at + dvec2(label.clear)};
    for (const dvec2& way : ways) {
      if (writer_.write(text, label.at + (label.clear + kLabelGap * em_) * way, way, em_)) return;
    }
    writer_.write_near(text, label.at + (label.clear + kLabelGap * em_) * ways[0], ways[0], em_,
                       place);
  }

  /// The title is drawn if the scene says so, and above axes if it is the scene's own.
  static bool has_title(const Scene& scene) {
    if (scene.title.empty()) return false;
    return scene.show_title || (scene.axes && scene.title != Scene{}.title);
  }

  /// Its letters are larger than others if there is room for it so.
  void add_title() {
    const double most = size_.x - 2 * kTitleGap * em_;
    const std::string line = one_line(scene_.title);
    const double large = kTitleSize * em_;
    const double size = std::clamp(large * most / writer_.width(line, large), em_, large);
    const std::string title = writer_.shortened(line, most, size);
    writer_.write(title, {size_.x / 2, 0.5 * writer_.height(large) + kTitleGap * em_}, {0, 0},
                  size);
  }

  /// The height of the title with what is free above and below it.
  double title_zone() const { return writer_.height(kTitleSize * em_) + 2 * kTitleGap * em_; }

  /// Returns the x to the left of which there is room for the next one.
  double add_bar(const ColorScale& scale, double right) {
    const Ticks marks = ticks_of(scale);
    const double width = bar_zone(scale);
    const double left = right - width + kBarMargin * em_;
    const double height = kBarHeight * size_.y;
    const dvec2 corner(std::round(left), bar_top());
    const dvec2 extent(std::round(kBarWidth * em_), std::round(height));
    result_.bars.push_back({corner, extent, scale.colormap});
    writer_.keep_clear({corner, corner + extent});
    const dvec2 end = corner + extent;
    const std::array<dvec2, 4> outline = {corner, {end.x, corner.y}, end, {corner.x, end.y}};
    for (std::size_t k = 0; k < 4; ++k)
      result_.strokes.push_back({outline[k], outline[(k + 1) % 4]});
    const std::string name = bar_name(scale, marks);
    const double half = writer_.width(name, em_) / 2;
    const double middle =
        std::min(std::max(corner.x + extent.x / 2, half + kGap * em_), right - half - kGap * em_);
    const bool is_named =
        writer_.write_near(name, {middle, corner.y - kBarNameGap * em_}, {0, -1}, em_);
    for (const Tick& tick : bar_ticks(scale, marks)) {
      const double y = end.y - extent.y * place_on(scale, tick.value);
      result_.strokes.push_back({dvec2(end.x, y), dvec2(end.x + kTickLength * em_, y)});
      if (!is_named && !marks.note.empty()) continue;  // without it the numbers are wrong
      writer_.write(tick.text, {end.x + (kTickLength + kGap) * em_, y}, {1, 0}, em_);
    }
    return right - std::max(width, 2 * half + 2 * kGap * em_);
  }

  /// Where bars begin, and their names end, from the picture's upper side.
  double bar_top() const { return std::round((1 - kBarHeight) / 2 * size_.y + em_); }
  double below_bar_names() const { return bar_top() - kBarNameGap * em_; }

  /// The width of a bar with its numbers, at the picture's right side.
  double bar_zone(const ColorScale& scale) const {
    double widest = 0;
    for (const Tick& tick : bar_ticks(scale, ticks_of(scale))) {
      widest = std::max(widest, writer_.width(tick.text, em_));
    }
    return widest + (2 * kBarMargin + kBarWidth + kTickLength + kGap) * em_;
  }

  /// The room for ticks, labels and the axes' names: beside the box, and above and below it.
  dvec2 axes_margin() const {
    double widest = 0;
    for (int axis = 0; axis < 3; ++axis) {
      for (const Tick& tick : ticks_along(axis, kMostTicks).ticks) {
        widest = std::max(widest, writer_.width(tick.text, em_));
      }
    }
    const double before_name = kTickLength + 2 * kGap;
    double name = em_;
    for (int axis = 0; axis < 3; ++axis) {
      name = std::max(name, writer_.width(label_of(axis), em_));
    }
    return {widest + before_name * em_ + name,
            2 * writer_.height(em_) + (before_name + kGap) * em_};
  }

 private:
  /// The text of an axis, shortened to the room for it.
  std::string label_of(int axis) const {
    const std::string& label = scene_.labels[static_cast<std::size_t>(axis)];
    return writer_.shortened(one_line(label), kMostLabel * size_.x, em_);
  }

  // --- axes --------------------------------------------------------------------------------------

  /// A tick in the picture.
  struct Mark {
    dvec2 at;
    std::string text;
  };

  /// The box is stretched as the picture is, the numbers of ticks are not.
  Ticks ticks_along(int axis, int count) const {
    return ticks(box_.low[axis] / scale_[axis], box_.high[axis] / scale_[axis], count);
  }

  std::vector<Mark> marks_on(const Edge& edge, const Ticks& all) const {
    std::vector<Mark> marks;
    for (const Tick& tick : all.ticks) {
      dvec3 place = edge.begin;
      place[edge.axis] = tick.value * scale_[edge.axis];
      if (const auto at = edges_.pixel_of(place)) marks.push_back({*at, tick.text});
    }
    return marks;
  }

  Rect label_rect(const Edge& edge, const Mark& mark, double apart) const {
    const dvec2 at = mark.at + (kTickLength + kGap) * em_ * edge.out;
    Rect rect = writer_.rect_beside(mark.text, at, edge.out, em_);
    rect.low -= dvec2(apart, 0);
    return rect;
  }

  bool have_room(const Edge& edge, const std::vector<Mark>& marks) const {
    for (std::size_t i = 1; i < marks.size(); ++i) {
      const Rect rect = label_rect(edge, marks[i], kApart * em_);
      if (rect.overlaps(label_rect(edge, marks[i - 1], kApart * em_))) return false;
    }
    return true;
  }

  void add_ticks(const Edge& edge) {
    int count = kMostTicks;
    Ticks chosen = ticks_along(edge.axis, count);
    std::vector<Mark> marks = marks_on(edge, chosen);
    while (!have_room(edge, marks) && --count > 0) {
      chosen = ticks_along(edge.axis, count);
      marks = marks_on(edge, chosen);
    }
    double reach = 0;  // of the labels, outward
    for (const Mark& mark : marks) {
      const dvec2 half = 0.5 * dvec2(writer_.width(mark.text, em_), writer_.height(em_));
      reach = std::max(reach, 2 * glm::dot(glm::abs(edge.out), half));
    }
    std::string name = label_of(edge.axis);
    if (!chosen.note.empty()) name += (name.empty() ? "(" : " (") + chosen.note + ")";
    const dvec2 at = (edge.from + edge.to) / 2.0;
    const dvec2 beside = at + ((kTickLength + 2 * kGap) * em_ + reach) * edge.out;
    const bool is_letter = chosen.note.empty() && writer_.width(name, em_) <= em_;
    const bool is_written = is_letter
                                ? writer_.write(name, beside, edge.out, em_)
                                : writer_.write_near(name, beside, edge.out, em_, edges_.outline());
    if (!is_written && !chosen.note.empty()) return;  // without it the numbers are wrong
    for (const Mark& mark : marks) {
      result_.strokes.push_back({mark.at, mark.at + kTickLength * em_ * edge.out});
      writer_.write(mark.text, mark.at + (kTickLength + kGap) * em_ * edge.out, edge.out, em_);
    }
  }

  // --- bars --------------------------------------------------------------------------------------

  Ticks ticks_of(const ColorScale& scale) const {
    const auto count = static_cast<int>(kBarHeight * size_.y / (kBarStep * em_));
    return ticks(scale.range.low, scale.range.high, std::clamp(count, 1, kMostTicks));
  }

  /// A bar's ticks. An end beyond which there are numbers, in its colour, says so, and comes first.
  std::vector<Tick> bar_ticks(const ColorScale& scale, const Ticks& marks) const {
    const double apart = em_ / (kBarHeight * size_.y) * (scale.range.high - scale.range.low);
    std::vector<Tick> inner = marks.ticks;
    std::vector<Tick> all;
    const auto mark_end = [&](double end, const char* sign) {
      Tick mark{end, ""};
      if (marks.note.empty()) mark.text = ticks(end, end, 1).ticks[0].text;
      std::erase_if(inner, [&](const Tick& tick) {
        if (std::abs(tick.value - end) <= kOnBarEnd * apart) mark.text = tick.text;
        return std::abs(tick.value - end) < apart;
      });
      mark.text = sign + mark.text;
      all.push_back(std::move(mark));
    };
    if (scale.range.below) mark_end(scale.range.low, "\u2264 ");
    if (scale.range.above) mark_end(scale.range.high, "\u2265 ");
    all.insert(all.end(), inner.begin(), inner.end());
    return all;
  }

  /// The formula, shortened to the room for it, and in full the offset and power of ten that the
  /// ticks leave out.
  std::string bar_name(const ColorScale& scale, const Ticks& marks) const {
    const std::string note = marks.note.empty() ? "" : " (" + marks.note + ")";
    const double most = std::max(kMostBarName * size_.x, 6 * em_) - writer_.width(note, em_);
    return writer_.shortened(one_line(scale.formula), std::max(most, em_), em_) + note;
  }

  const Scene& scene_;
  const Bounds& box_;
  dvec3 scale_;  ///< of the picture along the axes
  dvec2 size_;
  double em_;
  BoxEdges edges_;
  LabelWriter writer_;
  Annotations result_;
};

}  // namespace

Annotations annotate(const Scene& scene, const FittedCamera& camera, const Bounds& box,
                     std::span<const ColorScale> scales, const dvec2& size,
                     std::span<const SpaceLabel> labels) {
  const bool is_titled = Annotator::has_title(scene);
  if (!scene.axes && !is_titled && scales.empty() && labels.empty()) return {};
  Annotator annotator(scene, camera, box, size);
  annotator.keep_places_clear(labels);
  for (const SpaceLabel& label : labels) annotator.add_label(label);
  double right = size.x;
  for (const ColorScale& scale : scales) right = annotator.add_bar(scale, right);
  if (is_titled) annotator.add_title();
  if (scene.axes && !box.empty()) annotator.add_axes();
  return annotator.take();
}

namespace {

Room room_for_annotations(const Scene& scene, const Bounds& box, std::span<const ColorScale> scales,
                          const dvec2& size) {
  Room room;
  if (!scene.axes && !scene.show_title && scales.empty()) return room;
  const Annotator annotator(scene, {}, box, size);
  double left = kPictureMargin * size.x;
  double right = left;
  double above = 0;
  if (!scales.empty()) {
    right = kPictureMargin / 2 * size.x;
    for (const ColorScale& scale : scales) right += annotator.bar_zone(scale);
    above = annotator.below_bar_names();  // names are wider than their bars
  }
  if (scene.axes && !box.empty()) {
    const dvec2 axes = annotator.axes_margin();
    left = std::max(left, axes.x);
    // Long labels are at the left.
    right = scales.empty() ? left : right + axes.x / 2;
    above = std::max(above, axes.y);
  }
  if (scene.show_title && Annotator::has_title(scene)) {
    above = std::max(above, annotator.title_zone());
  }
  room.across = std::max(1 - (left + right) / size.x, kLeastRoom);
  room.down = std::clamp(1 - 2 * above / size.y, kLeastRoom, room.down);
  const double most = 1 - room.across;
  room.middle = std::clamp((left - right) / size.x, -most, most);
  return room;
}

}  // namespace

ViewPyramid pyramid_beside_annotations(const Scene& scene, const Camera& camera, const Bounds& box,
                                       std::span<const ColorScale> scales, const dvec2& size) {
  ViewPyramid seen(camera, size.x / size.y, box.centre(),
                   room_for_annotations(scene, box, scales, size));
  if (scene.axes && !box.empty()) seen.add(box);
  return seen;
}

}  // namespace saddle
