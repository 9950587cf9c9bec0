#include "viewer/random_hand.h"

#include "view/model/actions.h"

namespace saddle {
namespace {

/// GLFW's numbers for keys that fields understand.
constexpr int kKeyA = 65;
constexpr int kKeyEscape = 256;
constexpr int kKeyReturn = 257;
constexpr int kKeyBackspace = 259;
constexpr int kKeyControl = 341;
constexpr int kModControl = 2;

}  // namespace

void RandomHand::act() {
  switch (below(12)) {
    case 0:
    case 1:
      return drag();
    case 2:
    case 3:
      return scroll();
    case 4:
      return click(anywhere(), 2);
    case 5:
      return click({20.0 + below(260), 20.0 + below(560)}, 1);  // into the panel
    case 6:
    case 7:
      return enter_formula();
    case 8:
      return type(formula_(2));
    case 9:
      return move(anywhere());
    default:
      return press_key();
  }
}

void RandomHand::rest() {
  for (int which = 0; which < 3; ++which) button(Event::Kind::Release, which);
  for (int i = 0; i < 3; ++i) {  // lists, help, the start page
    for (const bool down : {true, false}) key(kKeyEscape, 0, down);
  }
  click({700, 300}, 1);
  while (viewer_.has_events()) viewer_.step();
  if (viewer_.model().view().playing || viewer_.model().played()) press_key_named("Space");
  if (viewer_.model().view().normals) press_key_named("n");
}

void RandomHand::press_key_named(const std::string& name) {
  Event event = at_pointer(name.size() == 1 ? Event::Kind::Character : Event::Kind::KeyDown);
  event.key = name;
  event.code = name.size() == 1 ? name[0] : 0;
  viewer_.receive(event);
}

int RandomHand::below(int end) {
  return static_cast<int>(end * random_unit(seed_++));
}

dvec2 RandomHand::anywhere() {
  return {double(below(1080)), double(below(600))};
}

Event RandomHand::at_pointer(Event::Kind kind) const {
  Event event;
  event.kind = kind;
  event.place = pointer_;
  return event;
}

void RandomHand::move(const dvec2& place) {
  pointer_ = place;
  viewer_.receive(at_pointer(Event::Kind::Move));
}

void RandomHand::button(Event::Kind kind, int button, bool shift) {
  Event event = at_pointer(kind);
  event.button = button;
  event.shift = shift;
  viewer_.receive(event);
}

void RandomHand::click(const dvec2& place, int times) {
  move(place);
  for (int i = 0; i < times; ++i) {
    button(Event::Kind::Press, 0);
    button(Event::Kind::Release, 0);
  }
}

void RandomHand::drag() {
  const int which = below(3);
  move(anywhere());
  button(Event::Kind::Press, which, below(4) == 0);
  for (int i = below(6); i >= 0; --i) {
    move(anywhere());
    if (below(8) == 0) press_key();
    viewer_.step();
  }
  if (below(20) != 0) button(Event::Kind::Release, which);
}

void RandomHand::scroll() {
  move(anywhere());
  for (int i = below(4); i >= 0; --i) {
    Event event = at_pointer(Event::Kind::Scroll);
    event.notches = 4 * random_unit(seed_++) - 2;
    viewer_.receive(event);
  }
}

void RandomHand::key(int code, int mods, bool down) {
  Event event = at_pointer(down ? Event::Kind::KeyDown : Event::Kind::KeyUp);
  event.code = code;
  event.mods = mods;
  if (down && code == kKeyEscape) event.key = "Escape";
  if (down && code == kKeyReturn) event.key = "Return";
  viewer_.receive(event);
}

void RandomHand::type(const std::string& text) {
  for (const char c : text) press_key_named(std::string(1, c));
}

void RandomHand::enter_formula() {
  click({200, 65.0 + 25 * below(6)}, 1);
  key(kKeyControl, kModControl, true);
  key(kKeyA, kModControl, true);
  key(kKeyA, kModControl, false);
  key(kKeyControl, 0, false);
  type(formula_(below(3)));
  if (below(3) == 0) {
    key(kKeyBackspace, 0, true);
    key(kKeyBackspace, 0, false);
  }
}

void RandomHand::press_key() {
  const auto table = action_table();
  const ActionRow& row = table[below(static_cast<int>(table.size()))];
  if (row.action == Action::Quit) return;
  if (*row.key != 0 && below(4) != 0) return press_key_named(row.key);
  if (row.menu == Menu::None) return;
  press_key_named("Ctrl-P");
  settle();
  type(row.name);
  settle();
  for (const bool down : {true, false}) key(kKeyReturn, 0, down);
  settle();
}

void RandomHand::settle() {
  while (viewer_.has_events()) viewer_.step();
  viewer_.step();
}

}  // namespace saddle
