// A hand that does anything at all with a viewer: events that are made up.
#pragma once

#include <cstdint>
#include <string>

#include "base/random.h"
#include "base/vec.h"
#include "random_formula.h"
#include "view/window/viewer.h"

namespace saddle {

/// Makes up what a person might do, and more.
class RandomHand {
 public:
  RandomHand(Viewer& viewer, std::uint64_t seed)
      : viewer_(viewer), formula_(seed), seed_(seed << 32U) {}

  /// One deed, which may be several events.
  void act();

  /// Lets go, leaves fields and lists, stops t, and takes away what is no part of the scene.
  void rest();

  void press_key_named(const std::string& name);

 private:
  int below(int end);
  dvec2 anywhere();
  Event at_pointer(Event::Kind kind) const;
  void move(const dvec2& place);
  void button(Event::Kind kind, int button, bool shift = false);
  void click(const dvec2& place, int times);
  void drag();
  void scroll();
  void key(int code, int mods, bool down);
  void type(const std::string& text);
  /// In place of what is in one of the fields at the top.
  void enter_formula();
  /// Any but those that end the program. Those without a key are found by their names.
  void press_key();
  void settle();

  Viewer& viewer_;
  testing::RandomFormula formula_;
  std::uint64_t seed_;
  dvec2 pointer_{0, 0};
};

}  // namespace saddle
