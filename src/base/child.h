// Other programs that do a part of the work: gnuplot, ffmpeg.
#pragma once

#include <sys/types.h>

#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

namespace saddle {

/// A program that is at work, fed through a pipe. Its standard output is thrown away; the end of
/// its standard error is kept for the message of an error. SIGPIPE must be ignored.
class Child {
 public:
  /// Runs `command` (the program, looked up in PATH, and its arguments). It inherits the
  /// descriptors `files`, which it can open as /dev/fd/NUMBER. Throws Error (Machine) if the
  /// program is missing, with the `package` that has it.
  Child(const std::vector<std::string>& command, const std::string& package,
        std::span<const int> files = {});
  /// Ends it, unless it has been waited for.
  ~Child();
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  /// Hands it these bytes, waiting until it takes them; false: it reads no more.
  bool feed(std::string_view bytes);

  /// The end of its input, then waits for its own. Throws Error (Machine) with the last line of
  /// what it said if it fails. Called once.
  void finish();

  /// Kills it, from any thread, while another one feeds it or waits in finish().
  void interrupt();

  /// The end of its standard error, at most some thousand bytes. After finish().
  const std::string& words() const { return said_; }

 private:
  struct Pipes;

  void end();
  int wait();

  std::string name_;
  std::unique_ptr<Pipes> pipes_;
  std::string said_;
  std::mutex mutex_;       ///< of `process_`, whose number is another's once it was waited for
  pid_t process_ = -1;     ///< -1: waited for
  std::jthread listener_;  ///< beside feeding: neither side waits for the other
};

/// Runs `command` as a Child does, hands it `input` and waits. Throws Error (Machine) as Child
/// does.
void run_with_input(const std::vector<std::string>& command, const std::string& input,
                    const std::string& package);

}  // namespace saddle
