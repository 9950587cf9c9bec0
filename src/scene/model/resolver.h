// One number of a scene after another: its expression becomes its value, which has its limits.
#pragma once

#include <optional>
#include <string>

#include "formula/graph.h"
#include "formula/scope.h"
#include "scene/model/scene.h"
#include "scene/model/values.h"

namespace saddle {

/// Names are what messages call a number ("surface 1: opacity"). All functions throw Error (Input):
/// anything wrong with the expression, a value that is not finite or outside of its limits.
class Resolver {
 public:
  /// Of the numbers of the scene, or of one of its surfaces, which sees definitions of its own. The
  /// scene stays where it is.
  explicit Resolver(const Scene& scene, const SurfaceSpec* own = nullptr)
      : scene_(scene), own_(own) {}
  explicit Resolver(Scene&&, const SurfaceSpec* = nullptr) = delete;
  Resolver(const Resolver&) = delete;
  Resolver& operator=(const Resolver&) = delete;

  /// The value of t in expressions; none: they may not use it.
  void set_time(std::optional<double> t) { t_ = t; }

  /// An expression has used t.
  bool has_used_time() const { return scope_ && scope_->has_used_time(); }

  void number(const std::string& name, Number& number, const Limits& limits);
  void vector(const std::string& name, Vector& v);
  /// A vector that is not 0.
  void direction(const std::string& name, Vector& v);
  /// The limits are those of red, green and blue; alpha is from 0 to 1.
  void color(const std::string& name, Color& c, const Limits& limits);

 private:
  /// Parsed for the first expression: most scenes have none.
  Scope& scope();

  const Scene& scene_;
  const SurfaceSpec* own_;
  Graph graph_;
  std::optional<Scope> scope_;
  std::optional<double> t_;
};

}  // namespace saddle
