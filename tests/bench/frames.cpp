// What the viewer takes, on the display that there is: ./dev bench viewer.
#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <span>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#include "app/commands/view.h"
#include "base/error.h"
#include "scene/model/gallery.h"
#include "view/window/viewer.h"

namespace {

using namespace saddle;
using Clock = std::chrono::steady_clock;

double ms(Clock::duration d) {
  return std::chrono::duration<double, std::milli>(d).count();
}

ViewerSetup setup_of(const std::vector<std::string>& arguments) {
  std::vector<const char*> words{"saddle"};
  for (const std::string& argument : arguments) words.push_back(argument.c_str());
  CommandLine line;
  parse_command_line(static_cast<int>(words.size()), words.data(), line);
  return viewer_setup(line);
}

void rest(Viewer& viewer) {
  while (!viewer.is_at_rest()) viewer.step();
}

/// From before the window to a picture of the surface, its first mesh and its last one.
void first_picture() {
  const auto begin = Clock::now();
  Viewer viewer(setup_of({"torus"}));
  while (viewer.model().meshes().empty()) viewer.step();
  const double first = ms(Clock::now() - begin);
  rest(viewer);
  std::printf("torus: first picture after %.0f ms\n", first);
}

/// While a hand turns a torus of 2 n^2 triangles.
void turning(int n) {
  constexpr int kFrames = 100;
  const std::string cells = std::to_string(n);
  Viewer viewer(setup_of({"torus", "--samples", cells + "x" + cells}));
  rest(viewer);
  Event event;
  event.place = {700, 300};
  viewer.receive(event);
  event.kind = Event::Kind::Press;
  viewer.receive(event);
  while (viewer.has_events()) viewer.step();
  const Spent before = viewer.spent();
  event.kind = Event::Kind::Move;
  for (int i = 0; i < kFrames; ++i) {
    event.place = {700 + 200 * std::sin(0.1 * i), 300 + 100 * std::cos(0.1 * i)};
    viewer.receive(event);
    viewer.step();
  }
  const Spent after = viewer.spent();
  const double busy = ms(after.busy - before.busy);
  const double gl = ms(after.drawing - before.drawing + after.showing - before.showing);
  std::printf("%d triangles: %.1f ms a frame, of that %.1f %% outside of OpenGL\n", 2 * n * n,
              busy / kFrames, 100 * (busy - gl) / busy);
}

/// Processor time of this process, whatever else the machine does.
double processor_ms() {
  rusage used{};
  getrusage(RUSAGE_SELF, &used);
  const auto of = [](const timeval& t) {
    return 1e3 * static_cast<double>(t.tv_sec) + 1e-3 * static_cast<double>(t.tv_usec);
  };
  return of(used.ru_utime) + of(used.ru_stime);
}

/// The longest time from a key to the frame that answers it. It comes at the worst moment: just as
/// a step begins, which it waits for. A key would end the sleep of a step, so that does not count.
class KeyWait {
 public:
  /// A step, and then a key if it is its turn.
  void step(Viewer& viewer) {
    constexpr int kStepsToKey = 3;
    const auto busy = viewer.spent().busy;
    const double processor = processor_ms();
    viewer.step();
    if (++steps_ % kStepsToKey != 0) return;
    Event tab;
    tab.kind = Event::Kind::KeyDown;
    constexpr int kKeyTab = 258;
    tab.code = kKeyTab;
    tab.key = "Tab";
    tab.place = {1, 1};
    viewer.receive(tab);
    const std::size_t frames = viewer.spent().frames;
    while (viewer.spent().frames == frames) viewer.step();
    longest_ = std::max(longest_, ms(viewer.spent().busy - busy));
    most_work_ = std::max(most_work_, processor_ms() - processor);
  }
  std::string told() const {
    std::array<char, 80> text{};
    std::snprintf(text.data(), text.size(), "%.0f ms (%.0f ms of processors)", longest_,
                  most_work_);
    return text.data();
  }

 private:
  int steps_ = 0;
  double longest_ = 0;
  double most_work_ = 0;
};

/// While a hand turns something in a window of this size, and then lets it rest.
void waiting(const std::string& what, int width, int height) {
  constexpr int kFrames = 12;
  constexpr int kPanel = 320;
  Viewer viewer(
      setup_of({what, "-s", std::to_string(width - kPanel) + "x" + std::to_string(height)}));
  rest(viewer);
  Event event;
  event.place = {width / 2, height / 2};
  event.kind = Event::Kind::Press;
  viewer.receive(event);
  while (viewer.has_events()) viewer.step();
  event.kind = Event::Kind::Move;
  const auto turn = [&](int frames, const auto& step) {
    const std::size_t before = viewer.spent().frames;
    while (viewer.spent().frames < before + frames) {
      event.place.x += 10;
      viewer.receive(event);
      step();
    }
  };
  const auto begin = Clock::now();
  const double processor = processor_ms();
  turn(kFrames, [&] { viewer.step(); });
  const double turned = ms(Clock::now() - begin);
  const double turning_work = processor_ms() - processor;
  KeyWait turning;
  turn(kFrames, [&] { turning.step(viewer); });
  const auto let_go = Clock::now();
  rest(viewer);
  const double rested = ms(Clock::now() - let_go);
  KeyWait resting;
  turn(1, [&] { viewer.step(); });
  while (!viewer.is_at_rest()) resting.step(viewer);
  std::printf(
      "%s in %dx%d: turns %.1f times a second (%.0f ms of processors each), rests after %.0f ms; "
      "a key waits at most %s while it turns, %s until it rests\n",
      what.c_str(), width, height, 1000 * kFrames / turned, turning_work / kFrames, rested,
      turning.told().c_str(), resting.told().c_str());
}

void press(Viewer& viewer, int code) {
  for (const auto kind : {Event::Kind::KeyDown, Event::Kind::KeyUp}) {
    Event event;
    event.kind = kind;
    event.place = {200, 116};
    event.code = code;
    viewer.receive(event);
    while (viewer.has_events()) viewer.step();
  }
}

void type(Viewer& viewer, char letter) {
  Event event;
  event.kind = Event::Kind::Character;
  event.place = {200, 116};
  event.code = letter;
  viewer.receive(event);
}

/// Types to the end of the first surface's formula z.
void enter_formula(Viewer& viewer, const std::string& text) {
  Event event;
  event.place = {200, 116};
  viewer.receive(event);
  for (const auto kind : {Event::Kind::Press, Event::Kind::Release}) {
    event.kind = kind;
    viewer.receive(event);
    viewer.step();
  }
  constexpr int kKeyEnd = 269;
  press(viewer, kKeyEnd);
  for (const char letter : text) type(viewer, letter);
}

/// From the last letter of a formula to the picture of its first mesh, without OpenGL's part.
double edit(const std::string& name) {
  Viewer viewer(setup_of({name}));
  rest(viewer);
  enter_formula(viewer, "+");
  rest(viewer);
  const auto shown = viewer.model().meshes();
  const Spent before = viewer.spent();
  const auto begin = Clock::now();
  type(viewer, '0');
  while (viewer.model().meshes() == shown) {
    viewer.step();
    if (Clock::now() - begin > std::chrono::seconds(20)) return NAN;
  }
  const Spent after = viewer.spent();
  return ms(Clock::now() - begin - (after.drawing - before.drawing) -
            (after.showing - before.showing));
}

void edits() {
  std::vector<double> times;
  for (const GalleryEntry& entry : gallery()) {
    const double time = edit(std::string(entry.name));
    if (std::isnan(time)) {
      std::printf("%s: no picture\n", std::string(entry.name).c_str());
    } else {
      times.push_back(time);
    }
  }
  std::ranges::sort(times);
  std::printf(
      "an edit to its first picture, without OpenGL: median %.1f ms, 9 of 10 within %.1f ms"
      " (%zu surfaces)\n",
      times[times.size() / 2], times[times.size() * 9 / 10], times.size());
}

double median(std::vector<double> all) {
  std::ranges::sort(all);
  return all[all.size() / 2];
}

/// From letters of a formula to their pictures on the screen, with OpenGL's part.
void letters() {
  constexpr int kLetters = 24;
  Viewer viewer(setup_of({"torus", "-s", "996x770"}));
  rest(viewer);
  enter_formula(viewer, "+0.");
  rest(viewer);
  std::vector<double> times;
  std::vector<double> work;
  for (int i = 0; i < kLetters; ++i) {
    const auto shown = viewer.model().meshes();
    const std::size_t pictures = viewer.drawing().figures().frames;
    const auto begin = Clock::now();
    const double processor = processor_ms();
    type(viewer, static_cast<char>('1' + i % 9));
    while (viewer.model().meshes() == shown || viewer.drawing().figures().frames == pictures) {
      viewer.step();
    }
    times.push_back(ms(Clock::now() - begin));
    work.push_back(processor_ms() - processor);
    rest(viewer);
  }
  std::printf("torus in 996x770: a letter to its picture: median %.1f ms (%.1f ms of processors)\n",
              median(times), median(work));
}

/// From before the window to all pictures of the start page.
void start_page() {
  const auto begin = Clock::now();
  ViewerSetup setup;
  setup.start = true;
  setup.scene.picture.width = 900;
  setup.scene.picture.height = 680;
  Viewer viewer(std::move(setup));
  viewer.step();
  const double first = ms(Clock::now() - begin);
  rest(viewer);
  std::printf("start page: there after %.0f ms, with all %zu pictures after %.0f ms\n", first,
              gallery().size(), ms(Clock::now() - begin));
}

void at_rest() {
  static constexpr std::chrono::seconds kLong{5};
  Viewer viewer(setup_of({"torus"}));
  while (!viewer.is_tidy()) viewer.step();
  const double before = processor_ms();
  const std::jthread alarm([] {
    std::this_thread::sleep_for(kLong);
    Window::wake();
  });
  viewer.step();
  std::printf("at rest: %.2f %% of a core\n", 100 * (processor_ms() - before) / ms(kLong));
}

/// The name of a measurement, for the command line.
struct Measurement {
  const char* name;
  void (*run)();
};

void frames() {
  turning(100);
  turning(316);
}

void waits() {
  const std::string see_through = std::string(SADDLE_SOURCE_DIR) + "/examples/see-through.toml";
  for (const std::string& what : {std::string("torus"), see_through}) {
    waiting(what, 1920, 1050);
    waiting(what, 3840, 2160);
  }
}

constexpr std::array kMeasurements{
    Measurement{"first", first_picture}, Measurement{"frames", frames},
    Measurement{"waits", waits},         Measurement{"rest", at_rest},
    Measurement{"start", start_page},    Measurement{"letters", letters},
    Measurement{"edits", edits}};

}  // namespace

/// Does those that are named, or all.
int main(int count, char** words) {
  std::setvbuf(stdout, nullptr, _IOLBF, BUFSIZ);
  const std::span<char*> names(words + 1, words + count);
  try {
    for (const auto& [name, run] : kMeasurements) {
      if (names.empty() || std::ranges::count(names, std::string_view(name)) > 0) run();
    }
  } catch (const Error& error) {
    std::fputs(format_error(error).c_str(), stderr);
    return 1;
  }
}
