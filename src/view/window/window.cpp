#include "view/window/window.h"

#include <algorithm>
#include <array>
#include <cfloat>
#include <cmath>
#include <filesystem>
#include <span>
#include <utility>

#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include "base/error.h"
#include "render/gl/gl.h"
#include "view/panel/colors.h"
#include "view/window/draw_lists.h"

namespace saddle {
namespace {

/// Two presses so near and so soon after each other are one double click.
constexpr double kDoubleClickSeconds = 0.4;
constexpr double kDoubleClickPixels = 4;

/// The panel's letters, in pixels of the user's.
constexpr float kFontSize = 15;
/// Where distributions put readable fonts with Greek letters and mathematical signs, for the panel
/// and for texts in columns; without any of them ImGui's own small one stands in.
constexpr std::array kFonts{
    "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
    "/usr/share/fonts/dejavu-sans-fonts/DejaVuSans.ttf",
    "/usr/share/fonts/TTF/DejaVuSans.ttf",
    "/usr/share/fonts/truetype/liberation/LiberationSans-Regular.ttf",
};
constexpr std::array kMonoFonts{
    "/usr/share/fonts/truetype/dejavu/DejaVuSansMono.ttf",
    "/usr/share/fonts/dejavu-sans-mono-fonts/DejaVuSansMono.ttf",
    "/usr/share/fonts/TTF/DejaVuSansMono.ttf",
    "/usr/share/fonts/truetype/liberation/LiberationMono-Regular.ttf",
};

void add_font(std::span<const char* const> paths, float size) {
  static constexpr std::array<ImWchar, 9> kLetters{0x20,   0xFF,   0x370,  0x3FF, 0x2010,
                                                   0x2044, 0x2200, 0x22FF, 0};
  ImFontAtlas& fonts = *ImGui::GetIO().Fonts;
  for (const char* path : paths) {
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(path, ignored)) continue;
    fonts.AddFontFromFileTTF(path, size, nullptr, kLetters.data());
    return;
  }
  ImFontConfig config;
  config.SizePixels = size;
  fonts.AddFontDefault(&config);
}

[[noreturn]] void fail(const std::string& what) {
  const char* reason = nullptr;
  glfwGetError(&reason);
  throw Error(Status::Machine, what + (reason != nullptr ? std::string(": ") + reason : ""));
}

Window& of(GLFWwindow* window) {
  return *static_cast<Window*>(glfwGetWindowUserPointer(window));
}

void ask_for_opengl() {
  glfwDefaultWindowHints();
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_DEPTH_BITS, 0);  // targets have their own
}

/// That of a window which is never shown.
class HiddenContext final : public Context {
 public:
  HiddenContext() {
    ask_for_opengl();
    glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
    window_ = glfwCreateWindow(1, 1, "off screen", nullptr, nullptr);
    if (window_ == nullptr) fail("no second OpenGL context can be made");
  }
  ~HiddenContext() override { glfwDestroyWindow(window_); }
  HiddenContext(const HiddenContext&) = delete;
  HiddenContext& operator=(const HiddenContext&) = delete;

  void enter() override {
    glfwMakeContextCurrent(window_);
    if (glfwGetCurrentContext() != window_) fail("the second OpenGL context cannot be used");
  }
  void leave() override { glfwMakeContextCurrent(nullptr); }
  std::string name() const override { return "window"; }

 private:
  GLFWwindow* window_;
};

/// No larger than the screen.
std::array<int, 2> fitting_size(int width, int height) {
  GLFWmonitor* const monitor = glfwGetPrimaryMonitor();
  if (monitor == nullptr) return {width, height};
  int x = 0;
  int y = 0;
  int most_width = 0;
  int most_height = 0;
  glfwGetMonitorWorkarea(monitor, &x, &y, &most_width, &most_height);
  if (most_width <= 0 || most_height <= 0) return {width, height};
  return {std::min(width, most_width), std::min(height, most_height)};
}

}  // namespace

Window::Window(const std::string& title, int width, int height) {
  if (glfwInit() != GLFW_TRUE) fail("no window can be opened");
  try {
    make_window(title, width, height);
    glfwMakeContextCurrent(window_);
    load_gl_functions(glfwGetProcAddress);
    glfwSwapInterval(1);
    listen();
    start_panel();
  } catch (...) {
    glfwTerminate();
    throw;
  }
}

Window::~Window() {
  ImGui_ImplOpenGL3_Shutdown();
  ImGui_ImplGlfw_Shutdown();
  ImGui::DestroyContext();
  glfwTerminate();
}

void Window::make_window(const std::string& title, int width, int height) {
  ask_for_opengl();
  glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
  glfwWindowHintString(GLFW_X11_CLASS_NAME, "saddle");  // nothing without the other name
  glfwWindowHintString(GLFW_X11_INSTANCE_NAME, "saddle");
  const auto [w, h] = fitting_size(width, height);
  window_ = glfwCreateWindow(w, h, title.c_str(), nullptr, nullptr);
  if (window_ == nullptr) fail("no window with OpenGL 3.3 can be opened");
  float x_scale = 1;
  float y_scale = 1;
  glfwGetWindowContentScale(window_, &x_scale, &y_scale);
  scale_ = std::max(1.0F, x_scale);
}

void Window::listen() {
  glfwSetWindowUserPointer(window_, this);
  glfwSetMouseButtonCallback(window_, [](GLFWwindow* w, int button, int action, int mods) {
    Event event;
    event.kind = action == GLFW_PRESS ? Event::Kind::Press : Event::Kind::Release;
    event.button = button;
    event.shift = (mods & GLFW_MOD_SHIFT) != 0;
    event.mods = mods;
    of(w).receive_here(event);
  });
  glfwSetCursorPosCallback(window_, [](GLFWwindow* w, double x, double y) {
    int width = 1;
    int height = 1;
    glfwGetWindowSize(w, &width, &height);
    Event event;
    event.place =
        dvec2(x, y) * of(w).framebuffer_size() / dvec2(std::max(width, 1), std::max(height, 1));
    of(w).receive(event);
  });
  glfwSetScrollCallback(window_, [](GLFWwindow* w, double, double notches) {
    Event event;
    event.kind = Event::Kind::Scroll;
    event.notches = notches;
    of(w).receive_here(event);
  });
  glfwSetCursorEnterCallback(window_, [](GLFWwindow* w, int entered) {
    of(w).is_inside_ = entered == GLFW_TRUE;
    of(w).damaged_ = true;
  });
  glfwSetWindowFocusCallback(window_, [](GLFWwindow* w, int focused) {
    ImGui_ImplGlfw_WindowFocusCallback(w, focused);
    of(w).damaged_ = true;
  });
  glfwSetWindowRefreshCallback(window_, [](GLFWwindow* w) { of(w).damaged_ = true; });
  glfwSetFramebufferSizeCallback(window_, [](GLFWwindow* w, int, int) { of(w).damaged_ = true; });
  glfwSetDropCallback(window_, [](GLFWwindow* w, int count, const char** paths) {
    if (count < 1) return;
    Event event;
    event.kind = Event::Kind::Drop;
    event.key = paths[0];
    of(w).receive_here(event);
  });
  listen_to_keys();
}

void Window::listen_to_keys() {
  glfwSetCharCallback(window_, [](GLFWwindow* w, unsigned code) {
    Event event;
    event.kind = Event::Kind::Character;
    event.code = static_cast<int>(code);
    // A key that is held down types, but does nothing twice: it would save many files.
    const bool is_key = code > ' ' && code < 0x7F && !of(w).is_repeated_;
    if (is_key) event.key = static_cast<char>(code);
    of(w).receive_here(event);
  });
  glfwSetKeyCallback(window_, [](GLFWwindow* w, int key, int, int action, int mods) {
    Event event;
    event.kind = action == GLFW_RELEASE ? Event::Kind::KeyUp : Event::Kind::KeyDown;
    event.code = key;
    event.mods = mods;
    of(w).is_repeated_ = action == GLFW_REPEAT;
    if (action == GLFW_PRESS) event.key = name_of_key(key, mods);
    of(w).receive_here(event);
  });
}

void Window::start_panel() {
  IMGUI_CHECKVERSION();
  ImGui::CreateContext();
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;               // leaves no file behind
  io.KeyRepeatDelay = 1e9F;               // keys repeat by events
  io.ConfigInputTextCursorBlink = false;  // a frame is drawn when something happens
  const float size = std::round(kFontSize * static_cast<float>(scale_));
  add_font(kFonts, size);
  add_font(kMonoFonts, size);
  use_dark_colors();
  ImGui::GetStyle().ScaleAllSizes(static_cast<float>(scale_));
  ImGui_ImplGlfw_InitForOpenGL(window_, false);  // it hears from listen()
  ImGui_ImplOpenGL3_Init("#version 330 core");
}

void Window::receive_here(Event event) {
  event.place = pointer_;
  receive(std::move(event));
}

void Window::receive(Event event) {
  pointer_ = event.place;
  if (event.kind == Event::Kind::Move) is_inside_ = true;
  if (event.kind == Event::Kind::Press) {
    const double now = glfwGetTime();
    event.twice = event.button == 0 && now - last_press_time_ < kDoubleClickSeconds &&
                  glm::length(event.place - last_press_) < kDoubleClickPixels * scale_;
    last_press_time_ = event.twice ? -1 : now;
    last_press_ = event.place;
  }
  events_.push_back(std::move(event));
}

void Window::wait(std::optional<double> seconds) {
  if (!seconds) {
    glfwWaitEvents();
  } else if (*seconds > 0) {
    glfwWaitEventsTimeout(*seconds);
  } else {
    glfwPollEvents();
  }
}

void Window::wake() {
  glfwPostEmptyEvent();
}

std::vector<Event> Window::take_events() {
  std::vector<Event> taken;
  while (!events_.empty() && fits_into_frame(events_.front(), taken)) {
    taken.push_back(std::move(events_.front()));
    events_.pop_front();
  }
  return taken;
}

void Window::tell_panel(const Event& event) {
  shown_pointer_ = event.place;
  switch (event.kind) {
    case Event::Kind::Press:
    case Event::Kind::Release: {
      const auto button = static_cast<std::size_t>(event.button);
      if (button >= shown_buttons_.size()) return;
      shown_buttons_[button] = event.kind == Event::Kind::Press;
      return;
    }
    case Event::Kind::Scroll:
      return ImGui_ImplGlfw_ScrollCallback(window_, 0, event.notches);
    case Event::Kind::Character:
      return ImGui_ImplGlfw_CharCallback(window_, static_cast<unsigned>(event.code));
    case Event::Kind::KeyDown:
    case Event::Kind::KeyUp: {
      const int action = event.kind == Event::Kind::KeyDown ? GLFW_PRESS : GLFW_RELEASE;
      // A key that repeats is pressed again, as often as the keyboard says.
      const bool is_known = event.code >= 0 && event.code <= GLFW_KEY_LAST;
      if (is_known && is_editing_press(event)) ImGui::GetIO().KeysDownDuration[event.code] = -1;
      return ImGui_ImplGlfw_KeyCallback(window_, event.code, 0, action, event.mods);
    }
    case Event::Kind::Move:
    case Event::Kind::Drop:
      return;
  }
}

bool Window::take_close_request() {
  const bool asked = glfwWindowShouldClose(window_) == GLFW_TRUE;
  glfwSetWindowShouldClose(window_, GLFW_FALSE);
  return asked;
}

bool Window::take_damage() {
  return std::exchange(damaged_, false);
}

dvec2 Window::framebuffer_size() const {
  int width = 0;
  int height = 0;
  glfwGetFramebufferSize(window_, &width, &height);
  return {width, height};
}

std::unique_ptr<Context> Window::make_context() {
  return std::make_unique<HiddenContext>();
}

void Window::set_title(const std::string& title) {
  glfwSetWindowTitle(window_, title.c_str());
}

void Window::toggle_full_screen() {
  auto& [x, y, width, height] = windowed_;
  if (glfwGetWindowMonitor(window_) != nullptr) {
    return glfwSetWindowMonitor(window_, nullptr, x, y, width, height, GLFW_DONT_CARE);
  }
  GLFWmonitor* const monitor = glfwGetPrimaryMonitor();
  const GLFWvidmode* const mode = monitor != nullptr ? glfwGetVideoMode(monitor) : nullptr;
  if (mode == nullptr) return;
  glfwGetWindowPos(window_, &x, &y);
  glfwGetWindowSize(window_, &width, &height);
  glfwSetWindowMonitor(window_, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
}

void Window::set_clipboard(const std::string& text) {
  glfwSetClipboardString(window_, text.c_str());
}

void Window::set_light(bool is_light) {
  if (is_light == std::exchange(is_light_, is_light)) return;
  is_light ? use_light_colors() : use_dark_colors();
  ImGui::GetStyle().FrameBorderSize = is_light ? std::round(static_cast<float>(scale_)) : 0;
}

void Window::begin_panel() {
  ImGui_ImplOpenGL3_NewFrame();
  ImGui_ImplGlfw_NewFrame();
  // The panel's unit is the pixel, whatever GLFW's is; and what it has been told, not what GLFW
  // knows by now, is where the pointer is and what it holds.
  ImGuiIO& io = ImGui::GetIO();
  const dvec2 size = framebuffer_size();
  io.DisplaySize = {static_cast<float>(size.x), static_cast<float>(size.y)};
  io.DisplayFramebufferScale = {1, 1};
  const bool is_held = std::ranges::find(shown_buttons_, true) != shown_buttons_.end();
  io.MousePos = {-FLT_MAX, -FLT_MAX};  // nowhere
  if (is_inside_ || is_held) {
    io.MousePos = {static_cast<float>(shown_pointer_.x), static_cast<float>(shown_pointer_.y)};
  }
  std::ranges::copy(shown_buttons_, io.MouseDown);
  ImGui::NewFrame();
}

bool Window::is_panel_new() {
  ImGui::Render();
  std::string panel = bytes_of(*ImGui::GetDrawData());
  const bool is_new = panel != drawn_panel_;
  drawn_panel_ = std::move(panel);
  return is_new;
}

std::vector<PixelRect> Window::end_panel() {
  ImDrawData& drawn = *ImGui::GetDrawData();
  glBindFramebuffer(GL_FRAMEBUFFER, 0);  // what was drawn last may have been in another one
  ImGui_ImplOpenGL3_RenderDrawData(&drawn);
  return boxes_of(drawn);
}

void Window::swap() {
  glfwSwapBuffers(window_);
}

}  // namespace saddle
