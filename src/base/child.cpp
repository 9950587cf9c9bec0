#include "base/child.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <string_view>
#include <system_error>

#include "base/descriptor.h"
#include "base/error.h"

namespace saddle {
namespace {

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

/// Changes to the descriptors of a new process.
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

/// Bytes of a program's words that are kept, the last ones.
constexpr std::size_t kMostWords = 4096;

/// Reads to the end, into `words`. Allocates nothing: it must not fail on a thread of its own.
void keep_last_words(int from, std::string& words) noexcept {
  std::array<char, kMostWords> buffer{};
  for (;;) {
    const ssize_t count = read(from, buffer.data(), buffer.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return;
    const auto size = static_cast<std::size_t>(count);
    const std::size_t total = words.size() + size;
    if (total > kMostWords) words.erase(0, total - kMostWords);
    words.append(buffer.data(), size);
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

pid_t spawn(const std::vector<std::string>& command, const std::string& package, int input,
            int errors, std::span<const int> files) {
  FileActions actions;
  posix_spawn_file_actions_adddup2(actions.get(), input, STDIN_FILENO);
  posix_spawn_file_actions_adddup2(actions.get(), errors, STDERR_FILENO);
  posix_spawn_file_actions_addopen(actions.get(), STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  // Onto itself: it is not closed at exec() then.
  for (const int file : files) posix_spawn_file_actions_adddup2(actions.get(), file, file);
  std::vector<char*> arguments;
  arguments.reserve(command.size() + 1);
  for (const std::string& argument : command) {
    arguments.push_back(const_cast<char*>(argument.c_str()));
  }
  arguments.push_back(nullptr);
  pid_t child = 0;
  const int failed =
      posix_spawnp(&child, arguments[0], actions.get(), nullptr, arguments.data(), environ);
  if (failed != 0) {
    throw Error(Status::Machine, "cannot run " + command[0] + ": " + std::strerror(failed), {},
                failed == ENOENT ? "install the package " + package : "");
  }
  return child;
}

}  // namespace

struct Child::Pipes {
  Pipe to_child;
  Pipe from_child;
};

Child::Child(const std::vector<std::string>& command, const std::string& package,
             std::span<const int> files)
    : name_(command[0]), pipes_(std::make_unique<Pipes>()) {
  process_ =
      spawn(command, package, pipes_->to_child.out.number(), pipes_->from_child.in.number(), files);
  pipes_->to_child.out.close_now();
  pipes_->from_child.in.close_now();
  said_.reserve(kMostWords);
  try {
    listener_ = std::jthread([this] { keep_last_words(pipes_->from_child.out.number(), said_); });
  } catch (const std::system_error&) {
    end();
    throw;
  }
}

Child::~Child() {
  if (process_ >= 0) end();
}

void Child::end() {
  kill(process_, SIGKILL);
  wait();
}

bool Child::feed(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t count = write(pipes_->to_child.in.number(), bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;  // its exit status tells why
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
  return true;
}

/// Its exit status, as waitpid() has it.
int Child::wait() {
  pipes_->to_child.in.close_now();
  if (listener_.joinable()) listener_.join();
  siginfo_t ignored{};
  while (waitid(P_PID, static_cast<id_t>(process_), &ignored, WEXITED | WNOWAIT) < 0 &&
         errno == EINTR) {
  }
  const std::lock_guard lock(mutex_);
  int status = 0;
  while (waitpid(process_, &status, 0) < 0 && errno == EINTR) {
  }
  process_ = -1;
  return status;
}

void Child::interrupt() {
  const std::lock_guard lock(mutex_);
  if (process_ >= 0) kill(process_, SIGKILL);
}

void Child::finish() {
  const int status = wait();
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return;
  std::string reason = last_line(said_);
  if (reason.empty() && WIFSIGNALED(status)) {
    reason = std::string("it was ended: ") + strsignal(WTERMSIG(status));
  }
  throw Error(Status::Machine, name_ + " failed" + (reason.empty() ? "" : ": " + reason));
}

void run_with_input(const std::vector<std::string>& command, const std::string& input,
                    const std::string& package) {
  Child child(command, package);
  child.feed(input);
  child.finish();
}

}  // namespace saddle
