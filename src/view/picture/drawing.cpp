#include "view/picture/drawing.h"

#include <algorithm>
#include <utility>

#include "render/picture/light_findings.h"
#include "view/picture/marks.h"

namespace saddle {
namespace {

/// A moving picture is drawn more coarsely if it takes longer than this, and finer if that, with
/// four times the samples, is not to be expected. A key waits for it, and then for the panel: that
/// is less than 50 ms.
constexpr double kSlowMs = 25;
constexpr double kCoarsest = 0.125;

/// The first picture, of which nothing is known, has at most so many samples.
constexpr double kFirstSamples = 1e6;

/// Growth of a picture's area, from frame to frame, that makes it coarser.
constexpr double kMuchLarger = 1.5;

/// Parts of a picture that rests, in pixels each way. They are smaller if one takes longer than
/// this: a key waits for it; larger if all are quicker than that: each part takes all corners of
/// the mesh. The largest is no more than four times as slow below an empty row as expected.
constexpr int kSmallestPart = 128;
constexpr int kLargestPart = 256;
constexpr double kSlowPartMs = 16;
constexpr double kQuickPartMs = 6;

/// draw() has something to show after this time.
constexpr std::chrono::milliseconds kShowEvery{250};

/// Length of the normals shown, as a share of the surface's size.
constexpr double kNormalLength = 0.03;

double ms_of(Drawing::Clock::duration d) {
  return std::chrono::duration<double, std::milli>(d).count();
}

}  // namespace

Drawing::Drawing() : part_side_(kSmallestPart) {}

void Drawing::take_meshes(const Model& model) {
  const auto& meshes = model.meshes();
  Scene scene = model.last_good().scene;
  scene.picture.shading = model.scene().picture.shading;
  const bool exact = draws_parameters(scene);
  // Without meshes until all of them are there: uploading may throw.
  auto before = std::exchange(uploaded_, {});
  if (exact && !exact_) before.clear();
  exact_ = exact;
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    if (i < before.size() && before[i] == meshes[i]) continue;
    renderer_.set_surface(scene, i, meshes[i]->mesh);
  }
  is_new_ = is_new_ || before.empty();
  renderer_.keep_meshes(meshes.size());
  uploaded_ = meshes;
  make_marks(model);
  change();
}

/// Normals, if they are wanted.
void Drawing::make_marks(const Model& model) {
  has_marks_ = model.view().normals;
  renderer_.remove_marks();
  Mesh marks;
  if (has_marks_) {
    for (const Instance& instance : instances(model.last_good().scene)) {
      append_normal_marks(model.meshes()[instance.surface]->mesh, instance.to_world,
                          kNormalLength * model.surface_size(), marks);
    }
  }
  if (!marks.lines.empty()) renderer_.set_marks(marks);
}

void Drawing::change() {
  stage_ = Stage::Stale;
  moved_ = Clock::now();
  not_before_ = {};
}

void Drawing::change_with_meshes() {
  const bool is_late = stage_ == Stage::Stale;
  const auto before = not_before_;
  change();
  not_before_ = is_late ? before : moved_ + kMeshesSoon;
}

bool Drawing::is_due(Clock::time_point now) const {
  return stage_ != Stage::Done && now >= *due();
}

std::optional<Drawing::Clock::time_point> Drawing::due() const {
  if (stage_ == Stage::Done) return std::nullopt;
  if (stage_ == Stage::Stale) return not_before_;
  return stage_ == Stage::Coarse ? moved_ + kRest : Clock::time_point();
}

bool Drawing::draw(const Model& model) {
  const auto begin = Clock::now();
  if (!is_due(begin)) return false;
  if (!exact_ && draws_parameters(model.scene())) take_meshes(model);
  if (has_marks_ != model.view().normals) make_marks(model);
  if (uploaded_ != model.meshes()) {
    give_up();
    return false;
  }
  const bool is_stale = stage_ == Stage::Stale;
  if (is_stale) {
    draw_whole(model);
  } else {
    refine(model);
  }
  const auto end = Clock::now();
  spent_ += end - begin;
  if (!is_stale && stage_ != Stage::Done && end < shown_ + kShowEvery) return false;
  shown_ = end;
  return true;
}

bool Drawing::show(int width, int height, int left, Clock::time_point end) {
  buffer_.begin_frame(width, height, left);
  for (const PixelRect& part : canvas_.take_changes(left, height)) buffer_.damage(part);
  return buffer_.fill(canvas_, end);
}

int Drawing::finest(const Model& model) const {
  return std::min(2, model.scene().picture.antialias);
}

/// At once, with as many samples as there is time for.
void Drawing::draw_whole(const Model& model) {
  const PictureSettings& picture = model.scene().picture;
  const double most = finest(model);
  if (per_side_ == 0) {
    per_side_ = 1;
    while (per_side_ * per_side_ * picture.width * picture.height > kFirstSamples) per_side_ /= 2;
  }
  // A larger window does not get more samples before it is known how long they take.
  const double pixels = double(picture.width) * picture.height;
  while (pixels_ > 0 && pixels > kMuchLarger * pixels_ && per_side_ > kCoarsest) {
    per_side_ /= 2;
    pixels_ *= 4;
  }
  pixels_ = pixels;
  const double per_side = std::min(per_side_, most);
  const Scene scene = model.drawn_scene();
  const FittedCamera camera = model.grip().fitted;
  Look look = model.look();
  const auto begin = Clock::now();
  const auto is_slow = [begin] { return ms_of(Clock::now() - begin) > kSlowMs / 2; };
  if (per_side < most) look.interruption = {is_slow, true};
  canvas_.draw(renderer_, {scene, camera, look}, picture.width, picture.height, per_side,
               finest(model));
  const double passed = ms_of(Clock::now() - begin);
  stage_ = per_side < most ? Stage::Coarse : Stage::Done;
  cursor_ = {};
  ++figures_.frames;
  figures_.warnings = renderer_.warnings();
  if (const auto dark = no_light(model.scene())) figures_.warnings.push_back(warning_of(*dark));
  if (std::exchange(is_new_, false)) return;
  figures_.moving_ms = passed;
  adapt(passed);
}

void Drawing::adapt(double milliseconds) {
  while (milliseconds > kSlowMs && per_side_ > kCoarsest) {
    per_side_ /= 2;
    milliseconds /= 4;
  }
  if (4 * milliseconds < kSlowMs && per_side_ < 2) per_side_ *= 2;
}

/// Some parts of the picture, from the top, with all of their samples. The turn begins when the
/// scene is there: one that takes a whole turn to copy would never get on.
bool Drawing::refine(const Model& model) {
  const PictureSettings& picture = model.scene().picture;
  const Scene scene = model.drawn_scene();
  const FittedCamera camera = model.grip().fitted;
  Look look = model.look();
  const auto end = Clock::now() + kTurn;
  const auto is_over = [end] { return Clock::now() > end; };
  stage_ = Stage::Refining;
  while (cursor_.y < picture.height) {
    const auto start = Clock::now();
    if (start > end) return false;
    const PixelRect part = next_part(picture);
    look.interruption = {is_over, false, cursor_.is_begun};
    cursor_.is_begun = !canvas_.draw_part(renderer_, {scene, camera, look}, part);
    cursor_.slowest_ms = std::max(cursor_.slowest_ms, ms_of(Clock::now() - start));
    if (!cursor_.is_begun) advance(part, picture);
  }
  canvas_.finish();
  stage_ = Stage::Done;
  ++figures_.frames;
  return true;
}

PixelRect Drawing::next_part(const PictureSettings& picture) const {
  return {cursor_.x, cursor_.y, std::min(part_side_, picture.width - cursor_.x),
          std::min(part_side_, picture.height - cursor_.y)};
}

/// All parts of a row have one size.
void Drawing::advance(const PixelRect& part, const PictureSettings& picture) {
  cursor_.x += part.width;
  if (cursor_.x < picture.width) return;
  const double slowest = cursor_.slowest_ms;
  cursor_ = {.y = cursor_.y + part_side_};
  if (slowest > kSlowPartMs) part_side_ = std::max(part_side_ / 2, kSmallestPart);
  if (slowest < kQuickPartMs) part_side_ = std::min(part_side_ * 2, kLargestPart);
}

}  // namespace saddle
