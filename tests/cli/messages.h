// Messages as tables: a row for each, as a person would provoke it, and what they would type next.
#pragma once

#include <cstdlib>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cli/program.h"

namespace saddle {

/// A command line, how its message begins, a part of the hint, and a command that works.
struct MessageRow {
  const char* command;  ///< words with spaces between; one with spaces stands in single quotes
  const char* message;
  const char* hint;
  const char* instead;           ///< what the hint says, done; empty: nothing to try
  const char* environment = "";  ///< NAME=VALUE for the command alone
};

class Messages : public ProgramTest {
 protected:
  static std::vector<std::string> words(const std::string& command) {
    std::vector<std::string> result;
    std::string word;
    bool quoted = false;
    for (const char c : command + " ") {
      if (c == '\'') {
        quoted = !quoted;
      } else if (c == ' ' && !quoted) {
        if (!word.empty()) result.push_back(word);
        word.clear();
      } else {
        word += c;
      }
    }
    return result;
  }

  Outcome run(const std::string& command, const std::string& environment = "") {
    return run_saddle(words(command), folder_, "", [&] {
      const std::size_t equals = environment.find('=');
      if (equals == std::string::npos) return;
      setenv(environment.substr(0, equals).c_str(), environment.substr(equals + 1).c_str(), 1);
    });
  }

  /// Each command ends with the status and its message; what the hint says ends with 0.
  void expect_errors(std::span<const MessageRow> rows, int status) {
    for (const MessageRow& row : rows) {
      const std::string text = error_of(run(row.command, row.environment), status);
      EXPECT_TRUE(text.starts_with(std::string("saddle: ") + row.message)) << row.command << "\n"
                                                                           << text;
      EXPECT_TRUE(contains(text, row.hint)) << row.command << "\n" << text;
      EXPECT_TRUE(std::string_view(row.hint).empty() || text.find('\n') + 1 < text.size()) << text;
      if (std::string_view(row.instead).empty()) continue;
      const Outcome instead = run(row.instead);
      EXPECT_EQ(instead.status, 0) << row.command << " | " << row.instead << "\n" << instead.err;
    }
  }
};

}  // namespace saddle
