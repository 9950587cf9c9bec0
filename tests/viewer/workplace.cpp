#include "viewer/workplace.h"

#include <gtest/gtest.h>

#include <chrono>
#include <fstream>
#include <stop_token>
#include <thread>
#include <utility>

#include "paths.h"
#include "scene/model/gallery.h"

namespace saddle {
namespace {

/// Until a viewer counts as hung. A formula of a megabyte takes half a minute under a sanitizer.
constexpr std::chrono::minutes kPatience{2};

/// GLFW's.
constexpr int kModControl = 2;

}  // namespace

ViewerSetup Workplace::setup_of(Scene scene) {
  ViewerSetup setup;
  setup.scene = std::move(scene);
  setup.scene.picture.width = 500;
  setup.scene.picture.height = 400;
  setup.threads = 1;
  setup.program = program_path();
  return setup;
}

Scene Workplace::entry(const char* name) {
  return gallery_scene(*find_gallery_entry(name));
}

bool Workplace::until(Viewer& viewer, const std::function<bool()>& is_so) {
  const std::jthread waker([](const std::stop_token& end) {
    while (!end.stop_requested()) {
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
      Window::wake();
    }
  });
  const auto end = std::chrono::steady_clock::now() + kPatience;
  while (!is_so()) {
    if (std::chrono::steady_clock::now() > end || viewer.is_to_end()) return false;
    viewer.step();
  }
  return true;
}

bool Workplace::rests(Viewer& viewer) {
  return until(viewer, [&] { return viewer.is_at_rest(); });
}

void Workplace::receive_key(Viewer& viewer, const std::string& name, int code) {
  for (const auto kind : {Event::Kind::KeyDown, Event::Kind::KeyUp}) {
    Event event;
    event.kind = kind;
    event.place = {700, 300};
    event.code = code;
    if (name.starts_with("Ctrl-")) {
      event.code = name.back();
      event.mods = kModControl;
    }
    if (kind == Event::Kind::KeyDown) event.key = name;
    viewer.receive(event);
  }
}

void Workplace::key(Viewer& viewer, const std::string& name, int code) {
  receive_key(viewer, name, code);
  settle(viewer);
}

void Workplace::receive_text(Viewer& viewer, const std::string& text) {
  for (const char c : text) {
    Event event;
    event.kind = Event::Kind::Character;
    event.place = {700, 300};
    event.code = c;
    event.key = c;
    viewer.receive(event);
  }
}

void Workplace::type(Viewer& viewer, const std::string& text) {
  receive_text(viewer, text);
  settle(viewer);
}

void Workplace::settle(Viewer& viewer) {
  while (viewer.has_events()) viewer.step();
  viewer.step();
}

void Workplace::drop(Viewer& viewer, const std::string& file) {
  Event event;
  event.kind = Event::Kind::Drop;
  event.place = {700, 300};
  event.key = file;
  viewer.receive(event);
  while (viewer.has_events()) viewer.step();
}

void Workplace::choose(Viewer& viewer, const std::string& list, const std::string& words) {
  receive_key(viewer, list);
  receive_text(viewer, words);
  receive_key(viewer, "Return", kReturn);
  settle(viewer);
}

void Workplace::press_at(Viewer& viewer, const dvec2& place) {
  for (const auto kind : {Event::Kind::Move, Event::Kind::Press, Event::Kind::Release}) {
    Event event;
    event.kind = kind;
    event.place = place;
    viewer.receive(event);
  }
  while (viewer.has_events()) viewer.step();
}

void Workplace::leave_work(const std::string& typed) {
  open({"z=u*v"});
  enter_field(2);
  act("type '" + typed + "'");
  settled_picture();
  act("key ctrl+q");
  ASSERT_EQ(status(), 0);
}

std::string Workplace::work_brought_back(Viewer& viewer) {
  EXPECT_TRUE(rests(viewer));
  choose(viewer, "Ctrl-P", "unsaved");
  const Scene& scene = viewer.model().scene();
  return scene.surfaces.size() == 1 ? scene.surfaces[0].z : "nothing";
}

void Workplace::write(const std::string& name, const std::string& text) const {
  std::ofstream(path(name)) << text;
}

}  // namespace saddle
