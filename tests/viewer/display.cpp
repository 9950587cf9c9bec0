#include "viewer/display.h"
#include "paths.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <thread>
#include <utility>

#include "base/file.h"
#include "wait_for_child.h"

namespace saddle {
namespace {

/// What takes longer than this does not happen. Nothing is timed: tests go on as soon as they can.
constexpr std::chrono::seconds kPatience{40};

/// How often something is looked at that is waited for.
constexpr std::chrono::milliseconds kLook{20};
/// Looks in which nothing moves before a picture has settled: the window rests for 120 ms before
/// it draws what has moved once more, finely.
constexpr int kRestingLooks = 10;

std::string contents(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

void redirect(int stream, const std::filesystem::path& path) {
  const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  if (file < 0 || dup2(file, stream) < 0) _exit(126);
}

/// Starts a program, with the child's own preparations before that.
pid_t start_program(std::vector<std::string> words, const std::function<void()>& prepare) {
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  const pid_t child = fork();
  if (child == 0) {
    prepare();
    execvp(argv[0], argv.data());
    _exit(127);
  }
  return child;
}

/// The exit status, 128 + the signal that ended it, or -1 while it runs.
int status_of(pid_t child) {
  int status = 0;
  if (waitpid(child, &status, WNOHANG) != child) return -1;
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

void end(pid_t child) {
  if (child <= 0) return;
  kill(child, SIGTERM);
  wait_for_child(child);
}

bool is_there(const std::string& program) {
  return std::system(("command -v " + program + " >/dev/null 2>&1").c_str()) == 0;
}

/// The 32 bits at a place of an X window dump, whose numbers have their highest byte first.
std::size_t dumped_number(const std::string& dump, std::size_t place) {
  std::size_t number = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    number = 256 * number + static_cast<unsigned char>(dump[4 * place + i]);
  }
  return number;
}

/// An X window dump with 32 bits per pixel: blue, green, red, nothing. Nothing if it is not whole.
Image image_of_dump(const std::string& dump) {
  constexpr std::size_t kHeader = 100;
  constexpr std::size_t kColor = 12;
  if (dump.size() < kHeader) return {};
  const std::size_t width = dumped_number(dump, 4);
  const std::size_t height = dumped_number(dump, 5);
  const std::size_t line = dumped_number(dump, 12);
  const std::size_t begin = dumped_number(dump, 0) + kColor * dumped_number(dump, 19);
  if (width == 0 || line < 4 * width || dump.size() < begin + line * height) return {};
  Image image(static_cast<int>(width), static_cast<int>(height));
  for (std::size_t y = 0; y < height; ++y) {
    const char* from = dump.data() + begin + y * line;
    std::uint8_t* to = image.rgba.data() + 4 * y * width;
    for (std::size_t x = 0; x < width; ++x, from += 4, to += 4) {
      for (int c = 0; c < 3; ++c) to[c] = static_cast<std::uint8_t>(from[2 - c]);
      to[3] = 255;
    }
  }
  return image;
}

/// Whether all threads of a process wait.
bool sleeps(pid_t process) {
  std::error_code error;
  const std::filesystem::path threads = "/proc/" + std::to_string(process) + "/task";
  for (std::filesystem::directory_iterator thread(threads, error), end; !error && thread != end;
       thread.increment(error)) {
    const std::string stat = contents(thread->path() / "stat");
    const std::size_t name_end = stat.rfind(") ");
    if (name_end != std::string::npos && stat[name_end + 2] != 'S') return false;
  }
  return true;
}

/// A part of a picture; nothing if it is not that large.
Image cut_out(const Image& image, int x, int y, int width, int height) {
  if (image.width < x + width || image.height < y + height) return {};
  Image part(width, height);
  for (int row = 0; row < height; ++row) {
    std::copy_n(image.pixel(x, y + row), 4 * width, part.pixel(0, row));
  }
  return part;
}

}  // namespace

void ViewerTest::SetUp() {
  for (const char* program : {"Xvfb", "xdotool", "xprop"}) {
    if (!is_there(program)) GTEST_SKIP() << "there is no " << program;
  }
  const std::filesystem::path number = path("display");
  server_ = start_program({"Xvfb", "-displayfd", "1", "-screen", "0", "1200x700x24", "-fbdir",
                           folder_, "-nocursor", "-nolisten", "tcp", "-noreset"},
                          [&] {
                            redirect(STDOUT_FILENO, number);
                            redirect(STDERR_FILENO, path("xvfb-log"));
                          });
  ASSERT_TRUE(eventually([&] { return contents(number).ends_with('\n'); })) << "no display";
  display_ = ":" + contents(number);
  display_.pop_back();
  setenv("XDG_STATE_HOME", path("state").c_str(), 1);  // work of other windows stays out
}

void ViewerTest::TearDown() {
  if (viewer_ > 0) end(viewer_);
  end_display();
}

void ViewerTest::end_display() {
  end(std::exchange(server_, 0));
}

void ViewerTest::start(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), program_path());
  viewer_ = start_program(arguments, [&] {
    setenv("DISPLAY", display_.c_str(), 1);
    unsetenv("WAYLAND_DISPLAY");
    if (chdir(folder_.c_str()) != 0) _exit(126);
    redirect(STDOUT_FILENO, path("out"));
    redirect(STDERR_FILENO, path("err"));
  });
}

std::string ViewerTest::title() const {
  const std::string file = path("title");
  const std::string command = "DISPLAY=" + display_ +
                              " xdotool search --class saddle getwindowname > " + file +
                              " 2>/dev/null";
  return std::system(command.c_str()) == 0 ? contents(file) : "";
}

void ViewerTest::open(std::vector<std::string> arguments) {
  start(std::move(arguments));
  ASSERT_TRUE(eventually([&] { return yellow_pixels(picture()) > 1000; }))
      << "no surface is shown; " << standard_error();
  settled_picture();
}

int ViewerTest::status() {
  int result = -1;
  eventually([&] {
    result = status_of(viewer_);
    return result != -1;
  });
  if (result != -1) viewer_ = 0;
  return result;
}

int ViewerTest::run(const std::vector<std::string>& arguments, const std::string& display) {
  std::vector<std::string> words{program_path()};
  words.insert(words.end(), arguments.begin(), arguments.end());
  const pid_t child = start_program(words, [&] {
    display.empty() ? unsetenv("DISPLAY") : setenv("DISPLAY", display.c_str(), 1);
    unsetenv("WAYLAND_DISPLAY");
    if (chdir(folder_.c_str()) != 0) _exit(126);
    redirect(STDOUT_FILENO, path("out"));
    redirect(STDERR_FILENO, path("err"));
  });
  int result = -1;
  eventually([&] { return (result = status_of(child)) != -1; });
  return result;
}

void ViewerTest::set_dots_per_inch(int dots) const {
  const std::string command =
      "DISPLAY=" + display_ +
      " xprop -root -f RESOURCE_MANAGER 8s -set RESOURCE_MANAGER 'Xft.dpi: " +
      std::to_string(dots) + "'";
  ASSERT_EQ(std::system(command.c_str()), 0) << command;
}

void ViewerTest::act(const std::string& words) const {
  const std::string command = "DISPLAY=" + display_ + " xdotool " + words;
  ASSERT_EQ(std::system(command.c_str()), 0) << command;
}

void ViewerTest::click(int x, int y, const std::string& options) {
  act("mousemove " + std::to_string(kPanelWidth + x) + " " + std::to_string(y) + " click " +
      options + " 1");
}

void ViewerTest::drag(int button, int x0, int y0, int x1, int y1) {
  const auto at = [](int x, int y) {
    return " mousemove " + std::to_string(kPanelWidth + x) + " " + std::to_string(y);
  };
  const std::string held = std::to_string(button);
  act(at(x0, y0) + " mousedown " + held + at((x0 + x1) / 2, (y0 + y1) / 2) + at(x1, y1) +
      " mouseup " + held);
}

void ViewerTest::enter_field(int row) const {
  constexpr int kFirst = 65;  // the middle of the first field, and how far they are apart
  constexpr int kApart = 25;
  act("mousemove 200 " + std::to_string(kFirst + row * kApart) + " click 1 key End");
}

void ViewerTest::enter_new_definition() const {
  act("mousemove 200 232 click 1");
}

Image ViewerTest::screenshot() const {
  return image_of_dump(read_file(path("Xvfb_screen0")));
}

Image ViewerTest::error_strip() const {
  constexpr int kTop = 460;
  return cut_out(screenshot(), 0, kTop, kPanelWidth, 600 - kTop);
}

Image ViewerTest::picture() const {
  return cut_out(screenshot(), kPanelWidth, 0, 800, 600);
}

bool ViewerTest::eventually(const std::function<bool()>& condition) {
  const auto end = std::chrono::steady_clock::now() + kPatience;
  while (!condition()) {
    if (std::chrono::steady_clock::now() > end) return false;
    std::this_thread::sleep_for(kLook);
  }
  return true;
}

Image ViewerTest::settled_picture() const {
  Image last = picture();
  int same = 0;
  eventually([&] {
    Image now = picture();
    const bool rests = sleeps(viewer_) && sleeps(server_) && now.rgba == last.rgba;
    same = rests ? same + 1 : 0;
    last = std::move(now);
    return same >= kRestingLooks;
  });
  return last;
}

std::string ViewerTest::standard_output() const {
  return contents(path("out"));
}

std::string ViewerTest::standard_error() const {
  return contents(path("err"));
}

void ViewerHere::SetUp() {
  ViewerTest::SetUp();
  if (IsSkipped()) return;
  setenv("DISPLAY", display().c_str(), 1);
  unsetenv("WAYLAND_DISPLAY");
  before_ = std::filesystem::current_path();
  std::filesystem::current_path(folder_);
}

void ViewerHere::TearDown() {
  if (!before_.empty()) std::filesystem::current_path(before_);
  ViewerTest::TearDown();
}

int yellow_pixels(const Image& image) {
  int count = 0;
  for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
    const std::uint8_t* p = image.rgba.data() + i;
    count += p[0] > 90 && p[1] > 90 && 2 * p[2] < p[0] + p[1] - 40 ? 1 : 0;
  }
  return count;
}

}  // namespace saddle
