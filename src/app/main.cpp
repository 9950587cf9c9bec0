// The program: a command line becomes a command, an Error an exit status.
#include <cstdint>
#include <cstdlib>

#include "app/command_line/cli.h"
#include "app/command_line/help.h"
#include "app/commands/commands.h"
#include "app/report/reference.h"
#include "app/run/as_typed.h"
#include "app/run/outputs.h"
#include "base/error.h"
#include "base/heap.h"
#include "base/run_limits.h"
#include "base/standard_streams.h"
#include "base/temporary.h"

namespace {

void run(const saddle::CommandLine& line, saddle::Clock::time_point start) {
  using saddle::Command;
  if (line.run.help) return saddle::print(saddle::help_text(line.help_topics));
  if (line.run.version) return saddle::print(saddle::version_text());
  switch (line.command) {
    case Command::Graph:
      return saddle::wants_viewer(line) ? saddle::run_view(line) : saddle::run_graph(line, start);
    case Command::Check:
      return saddle::run_check(line, start);
    case Command::Chart:
      return saddle::run_chart(line);
    case Command::List:
      return saddle::run_list(line);
    case Command::Show:
      return saddle::run_show(line);
  }
}

int fail(const saddle::Error& error) {
  saddle::tell(error);
  return static_cast<int>(error.status());
}

/// The whole program: its exit status.
int run_program(int argc, char** argv) {
  const auto start = saddle::Clock::now();
  saddle::use_huge_pages();
  saddle::reserve_stack();
  saddle::guard_standard_streams();
  saddle::remove_temporaries_on_signals();
  saddle::CommandLine line;
  try {
    saddle::parse_command_line(argc, argv, line);
    if (line.run.max_time) saddle::limit_time(*line.run.max_time);
    saddle::limit_memory(line.run.max_memory ? static_cast<std::uint64_t>(*line.run.max_memory)
                                             : saddle::usual_memory_limit());
  } catch (...) {
    const saddle::Error error = saddle::caught_error();
    saddle::remove_results_of_comparison(line);
    return fail(error);
  }
  try {
    run(line, start);
    return 0;
  } catch (...) {
    return fail(saddle::as_typed(saddle::caught_error(), line));
  }
}

}  // namespace

int main(int argc, char** argv) {
  const int status = run_program(argc, argv);
  saddle::flush_standard_streams();
  // Everything is written; taking the shader compiler's memory apart would cost some milliseconds.
  std::quick_exit(status);
}
