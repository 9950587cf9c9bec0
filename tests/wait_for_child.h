// The end of a process that a test started.
#pragma once

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>

#include <chrono>
#include <thread>

namespace saddle {

/// How the child ended, as waitpid() has it. One that runs for five minutes hangs: it is killed,
/// and the test fails.
inline int wait_for_child(pid_t child) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point end = Clock::now() + std::chrono::minutes(5);
  int status = -1;
  while (waitpid(child, &status, WNOHANG) == 0) {
    if (Clock::now() > end) {
      ADD_FAILURE() << "process " << child << " does not end and is killed";
      kill(child, SIGKILL);
      waitpid(child, &status, 0);
      break;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return status;
}

}  // namespace saddle
