#include "base/child.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <string_view>
#include <thread>

#include "base/error.h"

namespace saddle {
namespace {

/// A descriptor that is closed.
class Descriptor {
 public:
  explicit Descriptor(int number = -1) : number_(number) {}
  ~Descriptor() { close(); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int get() const { return number_; }
  void set(int number) { number_ = number; }
  void close() {
    if (number_ >= 0) ::close(number_);
    number_ = -1;
  }

 private:
  int number_;
};

struct Pipe {
  Descriptor out, in;
  Pipe() {
    std::array<int, 2> ends{};
    if (pipe2(ends.data(), O_CLOEXEC) != 0) {
      throw Error(Status::Machine, std::string("no pipe: ") + std::strerror(errno));
    }
    out.set(ends[0]);
    in.set(ends[1]);
  }
};

/// What to do to the descriptors of a new process.
class FileActions {
 public:
  FileActions() { posix_spawn_file_actions_init(&actions_); }
  ~FileActions() { posix_spawn_file_actions_destroy(&actions_); }
  FileActions(const FileActions&) = delete;
  FileActions& operator=(const FileActions&) = delete;
  posix_spawn_file_actions_t* get() { return &actions_; }

 private:
  posix_spawn_file_actions_t actions_;
};

void write_all(int to, std::string_view text) {
  while (!text.empty()) {
    const ssize_t count = write(to, text.data(), text.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return;  // it stopped reading: its exit status tells why
    text.remove_prefix(static_cast<std::size_t>(count));
  }
}

std::string read_all(int from) {
  std::string text;
  std::array<char, 4096> buffer{};
  for (;;) {
    const ssize_t count = read(from, buffer.data(), buffer.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return text;
    text.append(buffer.data(), static_cast<std::size_t>(count));
  }
}

/// The last line with anything on it.
std::string last_line(std::string text) {
  const std::size_t end = text.find_last_not_of(" \t\r\n");
  if (end == std::string::npos) return {};
  text.resize(end + 1);
  const std::size_t begin = text.find_last_of('\n');
  text = begin == std::string::npos ? text : text.substr(begin + 1);
  return text.substr(text.find_first_not_of(" \t"));
}

pid_t spawn(const std::vector<std::string>& command, const Pipe& input, const Pipe& errors,
            const std::string& package) {
  FileActions actions;
  posix_spawn_file_actions_adddup2(actions.get(), input.out.get(), STDIN_FILENO);
  posix_spawn_file_actions_adddup2(actions.get(), errors.in.get(), STDERR_FILENO);
  posix_spawn_file_actions_addopen(actions.get(), STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  std::vector<char*> arguments;
  for (const std::string& argument : command) {
    arguments.push_back(const_cast<char*>(argument.c_str()));
  }
  arguments.push_back(nullptr);
  pid_t child = 0;
  const int failed =
      posix_spawnp(&child, arguments[0], actions.get(), nullptr, arguments.data(), environ);
  if (failed != 0) {
    throw Error(Status::Machine, "cannot run " + command[0] + ": " + std::strerror(failed), {},
                "install the package " + package);
  }
  return child;
}

}  // namespace

void run_with_input(const std::vector<std::string>& command, const std::string& input,
                    const std::string& package) {
  Pipe to_child;
  Pipe from_child;
  const pid_t child = spawn(command, to_child, from_child, package);
  to_child.out.close();
  from_child.in.close();
  std::jthread writer([&] {  // beside reading: neither side waits for the other
    write_all(to_child.in.get(), input);
    to_child.in.close();
  });
  const std::string said = read_all(from_child.out.get());
  writer.join();
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return;
  const std::string reason = last_line(said);
  throw Error(Status::Machine, command[0] + " failed" + (reason.empty() ? "" : ": " + reason));
}

}  // namespace saddle
