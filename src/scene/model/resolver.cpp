#include "scene/model/resolver.h"

#include <cmath>

#include "base/error.h"
#include "scene/model/prepare.h"

namespace saddle {
namespace {

/// The value of an expression in words.
std::string value_text(double value) {
  if (std::isnan(value)) return "undefined";
  return std::isinf(value) ? "infinite" : format_number(value);
}

}  // namespace

void Resolver::number(const std::string& name, Number& number, const Limits& limits) {
  if (!number.text.empty()) number.value = scope().constant(name, number.text, {}, t_);
  if (std::isfinite(number.value) && limits.contain(number.value)) return;
  const std::string text = expression_of(number);
  const Place place{name, text, {0, text.size()}};
  const std::string is = number.text.empty() ? "" : "it is " + value_text(number.value);
  if (!std::isfinite(number.value)) {
    throw Error(Status::Input, "not a finite number", place, is);
  }
  throw Error(Status::Input, "must be " + describe(limits), place, is);
}

void Resolver::vector(const std::string& name, Vector& v) {
  number(name, v.x, kAny);
  number(name, v.y, kAny);
  number(name, v.z, kAny);
}

void Resolver::direction(const std::string& name, Vector& v) {
  vector(name, v);
  if (dvec3(v) != dvec3(0)) return;
  throw Error(Status::Input, "a direction needs a length", {name, {}, {}},
              "one of its three numbers must not be 0");
}

void Resolver::color(const std::string& name, Color& c, const Limits& limits) {
  number(name, c.r, limits);
  number(name, c.g, limits);
  number(name, c.b, limits);
  number(name, c.a, kShare);
}

Scope& Resolver::scope() {
  if (!scope_) scope_.emplace(graph_, constant_names(scene_, own_), constant_view(scene_, own_));
  return *scope_;
}

}  // namespace saddle
