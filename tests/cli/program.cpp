#include "cli/program.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <utility>

#include "base/file.h"
#include "paths.h"
#include "wait_for_child.h"

namespace saddle {
namespace {

/// In the child: makes `stream` write to `path`.
void redirect(int stream, const std::string& path) {
  const int file = open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  if (file < 0 || dup2(file, stream) < 0) _exit(126);
  close(file);
}

}  // namespace

Outcome run_saddle(const std::vector<std::string>& arguments, const std::filesystem::path& folder,
                   const std::string& standard_output, const std::function<void()>& limit) {
  const TemporaryFolder captured;
  const std::string out =
      standard_output.empty() ? (captured.path() / "out").string() : standard_output;
  const std::string err = captured.path() / "err";
  std::vector<std::string> words = {program_path()};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);

  const pid_t child = fork();
  if (child == 0) {
    if (chdir(folder.c_str()) != 0) _exit(126);
    unsetenv("DISPLAY");  // no window opens
    unsetenv("WAYLAND_DISPLAY");
    redirect(STDOUT_FILENO, out);
    redirect(STDERR_FILENO, err);
    if (limit) limit();
    execv(argv[0], argv.data());
    _exit(127);
  }
  const int status = wait_for_child(child);
  Outcome run;
  run.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  run.out = standard_output.empty() ? read_file(out) : "";
  run.err = read_file(err);
  // For tests/style/messages.py, which lists the messages that no run tells.
  if (const char* const told = std::getenv("SADDLE_TOLD")) {
    std::ofstream(told, std::ios::app) << run.err << run.out;
  }
  return run;
}

Outcome ProgramTest::small(std::vector<std::string> arguments) {
  arguments.insert(arguments.end(), {"-s", "64x48", "--samples", "20x20"});
  return saddle(arguments);
}

nlohmann::json ProgramTest::report_of(std::vector<std::string> arguments) {
  arguments.insert(arguments.end(), {"--report", "-"});
  return nlohmann::json::parse(small(std::move(arguments)).out);
}

std::vector<std::string> ProgramTest::files() const {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder_)) {
    names.push_back(entry.path().filename());
  }
  std::ranges::sort(names);
  return names;
}

std::string error_of(const Outcome& run, int status) {
  EXPECT_EQ(run.status, status) << run.err;
  EXPECT_EQ(run.out, "");
  EXPECT_TRUE(run.err.starts_with("saddle: ")) << run.err;
  return run.err;
}

}  // namespace saddle
