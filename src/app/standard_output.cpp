#include "app/standard_output.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <iostream>
#include <system_error>

#include "base/error.h"

namespace saddle {

void write_standard_output(const std::function<void(std::ostream&)>& write) {
  errno = 0;
  write(std::cout);
  if (std::cout.flush()) return;
  const std::string reason = errno == 0 ? "" : ": " + std::generic_category().message(errno);
  throw Error(Status::Machine, "cannot write to standard output" + reason);
}

void print(const std::string& text) {
  write_standard_output([&text](std::ostream& out) { out << text; });
}

bool standard_output_is_terminal() {
  return isatty(STDOUT_FILENO) != 0;
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
