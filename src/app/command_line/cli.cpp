// The command line by the table of options.
#include "app/command_line/cli.h"

#include <algorithm>
#include <array>
#include <optional>

#include "base/error.h"
#include "base/nearest.h"

namespace saddle {
namespace {

constexpr const char* kList = "saddle --help lists the options";

constexpr auto kVerbs = std::to_array<Verb>({
    {"check", Command::Check,
     "it writes no pictures and no meshes, but a report: --report FILE; --t T sets the moment"},
    {"chart", Command::Chart, "it compares all methods: saddle chart ... -o FILE.svg"},
    {"list", Command::List, "saddle list, or saddle list --verbose"},
    {"show", Command::Show,
     "it takes assignments and options of the scene; saddle show --shader NAME"},
});

/// `--size WxH`
std::string with_value(const Option& option) {
  return dashed(option) + " " + std::string(option.value);
}

std::string form(const Option& option) {
  return "write " + with_value(option) + "; saddle --help " + std::string(option.name) +
         " explains it";
}

/// Throws Error (Input) with the nearest option.
[[noreturn]] void refuse_unknown(const std::string& name) {
  if (name.find_first_of("0123456789.") == 1) {
    throw Error(Status::Input, "unknown option '" + name + "'", {},
                "the numbers of a value have commas between, and no spaces: --view 1,-2,2");
  }
  std::vector<std::string> names;
  for (const Option& option : options()) {
    if (option.is_option()) names.push_back(dashed(option));
  }
  const auto nearest = nearest_name(name, names);
  throw Error(Status::Input, "unknown option '" + name + "'", {},
              (nearest ? "did you mean '" + *nearest + "'? " : "") + kList);
}

/// The topics of `--help TOPIC...`, `--help=TOPIC` and `-h TOPIC...`; none: the first argument is
/// something else.
std::optional<std::vector<std::string>> help_topics(int argc, const char* const* argv) {
  const std::string first = argc > 1 ? argv[1] : "";
  const bool has_topic = first.starts_with("--help=");
  if (first != "--help" && first != "-h" && !has_topic) return std::nullopt;
  std::vector<std::string> topics(argv + 2, argv + argc);
  if (has_topic) topics.insert(topics.begin(), first.substr(first.find('=') + 1));
  return topics;
}

/// Sorts arguments into options with their values, and what is no option.
class Splitter {
 public:
  Splitter(int argc, const char* const* argv, CommandLine& line)
      : rest_(argv + std::min(argc, 1), argv + argc), line_(line) {}

  /// After an error it goes on behind the mistake.
  void split() {
    bool only_arguments = false;
    while (!is_done()) {
      const std::string argument = rest_[at_++];
      const bool is_no_option =
          only_arguments || argument.size() < 2 || argument[0] != '-' || is_place(argument);
      if (argument == "+") {
        line_.segments.emplace_back();
      } else if (is_no_option) {
        line_.segments.back().arguments.push_back(argument);
      } else if (argument == "--") {
        only_arguments = true;
      } else if (argument[1] == '-') {
        split_name(argument);
      } else {
        split_letters(argument);
      }
    }
  }

  bool is_done() const { return at_ == rest_.size(); }

 private:
  /// The word after `point` is three numbers, of which the first may have a minus.
  bool is_place(const std::string& word) const {
    const std::vector<std::string>& before = line_.segments.back().arguments;
    return before == std::vector<std::string>{"point"} && !word.starts_with("--") &&
           word.find(',') != std::string::npos;
  }

  /// `--name`, `--name=VALUE`
  void split_name(const std::string& argument) {
    const std::size_t equals = argument.find('=');
    const std::string name = argument.substr(0, equals);
    const Option* const option = find_option(std::string_view(name).substr(2));
    if (option == nullptr) refuse_unknown(name);
    if (equals == std::string::npos) {
      take(*option, std::nullopt);
    } else if (option->is_flag()) {
      throw Error(Status::Input, "takes no value", {name, argument.substr(equals + 1), {}},
                  "write " + name + " alone");
    } else {
      take(*option, argument.substr(equals + 1));
    }
  }

  /// `-s VALUE`, `-sVALUE`, `-qh`
  void split_letters(const std::string& argument) {
    if (find_option(std::string_view(argument).substr(1)) != nullptr) refuse_unknown(argument);
    for (std::size_t i = 1; i < argument.size(); ++i) {
      const Option* const option = find_option(argument[i]);
      if (option == nullptr) refuse_unknown(argument);
      if (!option->is_flag() && argument.substr(i + 1).starts_with('=')) {
        const std::string value = argument.substr(i + 2);
        throw Error(Status::Input, "-" + argument.substr(i, 1) + " takes its value without a '='",
                    {},
                    "write " + argument.substr(0, i + 1) + " " + value + " or " + dashed(*option) +
                        "=" + value);
      }
      const bool ends = option->is_flag() || i + 1 == argument.size();
      take(*option, ends ? std::nullopt : std::optional(argument.substr(i + 1)));
      if (!ends) return;
    }
  }

  /// `value`: it stands in the same argument; else the next one is it.
  void take(const Option& option, std::optional<std::string> value) {
    if (!value && !option.is_flag()) {
      if (at_ == rest_.size() || names_option(rest_[at_])) {
        throw Error(Status::Input, "the value is missing", {dashed(option), "", {}}, form(option));
      }
      value = rest_[at_++];
    }
    if (value && value->empty()) {  // a shell's variable that is not set should not go unnoticed
      throw Error(Status::Input, "the value is empty", {dashed(option), "", {}}, form(option));
    }
    auto& given = option.object ? line_.segments.back().given : line_.given;
    if (!option.repeats) std::erase_if(given, [&](const auto& g) { return g.option == &option; });
    given.push_back({&option, value.value_or("")});
  }

  /// `--name`, and `-o` or `-s`; not `-v`, which may be an expression.
  static bool names_option(const std::string& argument) {
    if (argument.size() == 2 && argument[0] == '-') {
      const Option* const option = find_option(argument[1]);
      return option != nullptr && !option->is_flag();
    }
    return argument.starts_with("--") &&
           find_option(std::string_view(argument).substr(2)) != nullptr;
  }

  std::vector<std::string> rest_;
  std::size_t at_ = 0;
  CommandLine& line_;
};

/// An option that the command does not take is refused.
void check_command(const CommandLine& line, const Option& option) {
  if ((option.commands & bit(line.command)) != 0) return;
  const bool changes_scene = option.scene || option.surface || option.stroke;
  if (line.command == Command::Show && changes_scene) return;
  const auto verb = std::ranges::find(kVerbs, line.command, &Verb::command);
  const bool has_verb = verb != kVerbs.end();
  throw Error(Status::Input,
              "saddle " + (has_verb ? std::string(verb->name) + " " : "") + "takes no option " +
                  dashed(option),
              {}, has_verb ? std::string(verb->hint) : kList);
}

/// Options that would do nothing, or that another one excludes, are refused. `given`: all that hold
/// for one object.
void check_given_options(const CommandLine& line, const std::vector<GivenOption>& given) {
  const auto is_given = [&](std::string_view name) {
    return std::ranges::any_of(given, [&](const auto& g) { return g.option->name == name; });
  };
  for (const auto& [option, text] : given) check_command(line, *option);
  for (const auto& [option, text] : given) {
    if (!option->needs.empty() && !is_given(option->needs)) {
      throw Error(Status::Input, "does nothing without --" + std::string(option->needs),
                  {dashed(*option), "", {}}, "add " + with_value(*find_option(option->needs)));
    }
    if (!option->excludes.empty() && is_given(option->excludes)) {
      throw Error(Status::Input, "cannot stand beside --" + std::string(option->excludes),
                  {dashed(*option), "", {}}, "leave one of them out");
    }
  }
}

/// The scene's options with the first segment's, and with each other segment's.
void check_given_options(const CommandLine& line) {
  for (const Segment& segment : line.segments) {
    std::vector<GivenOption> given = line.given;
    given.insert(given.end(), segment.given.begin(), segment.given.end());
    check_given_options(line, given);
  }
}

/// Throws Error (Input) for a `+` without an object on both of its sides.
void check_segments(const CommandLine& line) {
  for (std::size_t i = 0; i < line.segments.size(); ++i) {
    const Segment& segment = line.segments[i];
    if (!segment.arguments.empty() || line.segments.size() == 1) continue;
    if (i == 0 && !segment.given.empty()) continue;
    std::string place = i == 0 ? "before the '+'" : "after the '+'";
    if (line.segments.size() > 2) place += " number " + std::to_string(std::max<std::size_t>(i, 1));
    throw Error(Status::Input, "there is no object " + place, {},
                {"for example saddle torus + z=u*v -o both.png",
                 "a formula with spaces is written in quotes: z='u + v'"});
  }
}

/// Reference and report, which are known wherever something else is wrong.
void set_paths(CommandLine& line) {
  for (const auto& [option, text] : line.given) {
    if (option->name == "reference" || option->name == "report") {
      apply_option(*option, text, line.run);
    }
  }
}

}  // namespace

const Verb* find_verb(std::string_view name) {
  const auto found = std::ranges::find(kVerbs, name, &Verb::name);
  return found == kVerbs.end() ? nullptr : &*found;
}

const Option* CommandLine::last_given(const std::vector<std::string_view>& names) const {
  const Option* last = nullptr;
  const auto look = [&](const std::vector<GivenOption>& some) {
    for (const auto& [option, text] : some) {
      if (std::ranges::find(names, option->name) != names.end()) last = option;
    }
  };
  look(given);
  for (const Segment& segment : segments) look(segment.given);
  return last;
}

std::vector<std::string> CommandLine::arguments() const {
  std::vector<std::string> all;
  for (const Segment& segment : segments) {
    all.insert(all.end(), segment.arguments.begin(), segment.arguments.end());
  }
  return all;
}

void parse_command_line(int argc, const char* const* argv, CommandLine& line) {
  if (auto topics = help_topics(argc, argv)) {
    line.run.help = true;
    line.help_topics = std::move(*topics);
    return;
  }
  Splitter splitter(argc, argv, line);
  std::optional<Error> mistake;
  while (!splitter.is_done()) {
    try {
      splitter.split();
    } catch (const Error& error) {
      if (!mistake) mistake = error;
    }
  }
  set_paths(line);
  if (mistake) throw Error(*mistake);
  if (argc > 1) {
    if (const Verb* const verb = find_verb(argv[1])) {
      line.command = verb->command;
      line.segments[0].arguments.erase(line.segments[0].arguments.begin());
    }
  }
  for (const Segment& segment : line.segments) {
    for (const auto& [option, text] : segment.given) check_value(*option, text);
  }
  for (const auto& [option, text] : line.given) {
    check_value(*option, text);
    apply_option(*option, text, line.run);
  }
  if (line.run.help || line.run.version) return;
  check_given_options(line);
  if (line.command != Command::List) check_segments(line);
}

}  // namespace saddle
