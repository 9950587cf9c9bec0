// Time that goes by in a model: t, parameters that play, meshes that are due.
#include <algorithm>
#include <cmath>

#include "view/model/model.h"

namespace saddle {
namespace {

/// While t plays there are at most so many steps a second: that of most displays.
constexpr std::chrono::microseconds kStep{16'667};

/// How often it is told how long a mesh takes.
constexpr std::chrono::milliseconds kTellAgain{500};

/// Seconds of a parameter that plays, there and back.
constexpr double kToAndFro = 6;

/// The share of it at which the other end is reached.
constexpr double kThere = 0.5;

}  // namespace

void Model::pass(Clock::time_point now) {
  if (refine_at_ && now >= *refine_at_) request_meshes(Manner::Full);
  if (!view_.playing && !played_) {
    last_tick_.reset();
    return;
  }
  if (last_tick_ && now - *last_tick_ < kStep) return;
  const double passed = last_tick_ ? std::chrono::duration<double>(now - *last_tick_).count() : 0;
  last_tick_ = now;
  if (view_.playing && passed > 0) advance_time(passed);
  if (played_) advance_played(passed);
}

void Model::advance_time(double seconds) {
  const Animation animation = scene_.animation.value_or(Animation{});
  const double length = animation.to - animation.from;
  const double rate = length * animation.fps / animation.frames;  // of the animation's film
  const double t = scene_.t - animation.from + view_.speed * rate * seconds;
  move_to(animation.from + t - std::floor(t / length) * length);
}

void Model::play(const std::optional<ParameterPlace>& parameter) {
  played_ = parameter;
  const Definition* const definition = parameter ? find_definition(scene_, *parameter) : nullptr;
  const auto value = definition != nullptr ? plain_number(*definition) : std::nullopt;
  if (!value) return played_.reset();
  record("", true);
  const Slider ends = slider_in(scene_, *parameter);
  phase_ = std::clamp((*value - ends.min) / (ends.max - ends.min), 0.0, 1.0) / 2;
  if (view_.manner != PlayManner::ToAndFro && phase_ >= kThere) phase_ = 0;
}

/// Goes on in the manner of the view; the share of the way from end to end.
double Model::advance_phase(double share) {
  phase_ += share;
  if (view_.manner == PlayManner::Once) {
    phase_ = std::min(phase_, kThere);
    return phase_ / kThere;
  }
  const double round = view_.manner == PlayManner::Again ? kThere : 1;
  phase_ -= round * std::floor(phase_ / round);
  return phase_ <= kThere ? phase_ / kThere : (1 - phase_) / kThere;
}

void Model::advance_played(double seconds) {
  Definition* const definition = find_definition(scene_, *played_);
  if (definition == nullptr || !plain_number(*definition)) return played_.reset();
  const Slider ends = slider_in(scene_, *played_);
  const double place = advance_phase(view_.speed * seconds / kToAndFro);
  definition->text = rounded_text(ends.min + place * (ends.max - ends.min), ends, kPlayedSteps);
  request_meshes(keeps_up() ? Manner::InTurn : Manner::PreviewFirst);
  if (view_.manner == PlayManner::Once && phase_ >= kThere) played_.reset();
}

std::optional<Model::Clock::time_point> Model::next_pass() const {
  if (view_.playing || played_) return last_tick_ ? *last_tick_ + kStep : Clock::now();
  if (refine_at_ || !is_meshing()) return refine_at_;
  return Clock::now() + kTellAgain;
}

void Model::set_time(double t) {
  record("t", false);
  move_to(t);
}

void Model::move_to(double t) {
  scene_.t = t;
  request_meshes(view_.playing && keeps_up() ? Manner::InTurn : Manner::PreviewFirst);
}

std::optional<double> Model::meshing_seconds() const {
  const double seconds = std::chrono::duration<double>(Clock::now() - requested_).count();
  if (!is_meshing() || seconds < 1) return std::nullopt;
  return seconds;
}

}  // namespace saddle
