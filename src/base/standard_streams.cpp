#include "base/standard_streams.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <iostream>
#include <mutex>
#include <system_error>

#include "base/error.h"
#include "base/printable.h"

namespace saddle {
namespace {

/// To the line's begin, and away with what is on it.
constexpr const char* kClearLine = "\r\033[K";

/// A bar is drawn by a thread of its own.
std::mutex error_mutex;
bool is_status_shown = false;

void hide_status() {
  if (is_status_shown) std::cerr << kClearLine << std::flush;
  is_status_shown = false;
}

/// The reader has what it wanted, as in `saddle list | head -1`: the rest goes nowhere.
void drop_standard_output() {
  const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
  if (nowhere >= 0) dup2(nowhere, STDOUT_FILENO);
  std::cout.clear();
}

void write_lines(std::ostream& out, std::span<const std::string> lines) {
  for (const std::string& line : lines) out << printable(line) << '\n';
}

}  // namespace

void write_standard_output(const std::function<void(std::ostream&)>& write) {
  errno = 0;
  try {
    write(std::cout);
    std::cout.flush();
  } catch (...) {
    // The system's reason says more than a writer that found its stream broken.
    if (std::cout) throw;
  }
  const int code = errno;
  if (std::cout) return;
  if (code == EPIPE) return drop_standard_output();
  const std::string reason = code == 0 ? "" : ": " + std::generic_category().message(code);
  throw Error(Status::Machine, "cannot write to standard output" + reason);
}

void print(const std::string& text) {
  write_standard_output([&text](std::ostream& out) { out << text; });
}

void print_lines(std::span<const std::string> lines) {
  write_standard_output([lines](std::ostream& out) { write_lines(out, lines); });
}

void tell(std::span<const std::string> lines) {
  const std::lock_guard lock(error_mutex);
  hide_status();
  write_lines(std::cerr, lines);
}

void tell(const std::string& line) {
  tell(std::span(&line, 1));
}

void tell(const Error& error) {
  const std::lock_guard lock(error_mutex);
  hide_status();
  std::cerr << format_error(error);
}

void show_status(const std::string& line) {
  const std::lock_guard lock(error_mutex);
  std::cerr << kClearLine << printable(line) << std::flush;
  is_status_shown = true;
}

void clear_status() {
  const std::lock_guard lock(error_mutex);
  hide_status();
}

void flush_standard_streams() {
  std::cout.flush();
  std::cerr.flush();
}

bool standard_output_is_terminal() {
  return isatty(STDOUT_FILENO) != 0;
}

bool standard_error_is_terminal() {
  return isatty(STDERR_FILENO) != 0;
}

void guard_standard_streams() {
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);  // a file that may not grow is an error of writing, not an end
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    // Open for reading alone, so that writing to it still fails. open() takes the lowest free
    // number, which is this one.
    if (fcntl(stream, F_GETFD) == -1) (void)open("/dev/null", O_RDONLY);
  }
}

}  // namespace saddle
