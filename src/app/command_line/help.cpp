// The texts of --help. Lines about options and scene keys are made from scene/options/options.
#include "app/command_line/help.h"

#include <algorithm>
#include <array>
#include <utility>

#include "app/command_line/cli.h"
#include "base/error.h"
#include "base/nearest.h"
#include "export/formats/formats.h"
#include "formula/language.h"
#include "scene/options/lights.h"
#include "scene/options/options.h"
#include "view/model/actions.h"

namespace saddle {

namespace {

constexpr const char* kUsage =
    R"(saddle graphs parametric surfaces from formulas: x(u,v), y(u,v), z(u,v).

  saddle                                               open a window with the gallery in it
  saddle NAME=EXPRESSION... [options]                  graph formulas
  saddle SCENE.toml [NAME=EXPRESSION...] [options]     graph a scene file, or a picture's scene;
                                                       - is standard input
  saddle GALLERY-NAME [NAME=EXPRESSION...] [options]   graph a built-in surface
  saddle OBJECT + OBJECT ... [options]                 several objects in one scene
  saddle ... + curve x=... y=... z=... s=MIN:MAX       curves and points beside surfaces; with
  saddle ... + point X,Y,Z [--radius R] [--label TEXT] u=... v=... on the surface before them
  saddle check ...same arguments...                    what is true of the surface, no picture
  saddle chart ...same arguments... -o FILE            speed against accuracy of the methods, for
                                                       these surfaces: .svg .png .csv
  saddle list [-v]                                     names of the built-in surfaces, described
  saddle show GALLERY-NAME [NAME=EXPRESSION...]        print one as a scene file
  saddle show --shader ...the same arguments...        the GLSL that draws it

Assignments
  x= y= z= or xyz='(a,b,c)'  the surface; x is u and y is v by default
  u=MIN:MAX v=MIN:MAX        its ranges (default -1:1); the ends of v may depend on u. Other names
                             work, too: x=-3:3 y=-3:3, theta=0:pi phi=0:tau
  where=CONDITION            the part of the surface that is graphed
  t=VALUE or t=MIN:MAX       the moment, or the range of time of an animation
  NAME=EXPRESSION            a parameter, or a part that formulas share
  NAME(ARGUMENTS)=...        a helper function
Between the + of several objects, --front, --back, --color, --grid, --opacity and the like hold for
one object.

Examples:
  saddle z='sin(u)*cos(v)' u=-3:3 v=-3:3 -o waves.png
  saddle torus r=0.4 -o torus.ply -o torus.png
  saddle x='(2+cos(v))*cos(u)' y='(2+cos(v))*sin(u)' z='sin(v)' u=0:tau v=0:tau -o ring.png
  saddle torus r=0.4 + torus r=0.6 R=3 --front red + z='x^2+y^2' where='x^2+y^2<1' -o three.png
  saddle z='sin(3*u+t)*cos(v)' t=0:tau -o waves.gif
  saddle torus + curve u='2*s' v='3*s' s=0:tau --radius 0.05 + point u=0 v=0 --label P -o knot.png
)";

constexpr const char* kScene =
    R"text(A scene file is TOML. `saddle show torus` prints one; -o FILE.toml writes one. A number may be an
expression of the parameters and t in quotes. Here are all keys with their defaults; capitals stand
for values without a fixed default. `saddle --help KEY` explains a key, docs/SCENES.md has more.

  [params]     NAME = 1, or NAME = { value = 1, min = 0, max = 2, step = 0.5 } with a slider,
               or NAME = { value = 0, choices = ["sun", "lamp"] }: NAME=lamp and NAME=1 choose
  [functions]  "f(s)" = "exp(-s*s)"
               a [[surface]] may have both of its own: params = { NAME = 1 }
)text";

constexpr const char* kStatus =
    R"(0  done
1  the machine failed: a file cannot be written, no display, out of memory; or the picture differs
   from --reference
2  the input is wrong: usage, formula, scene file; or a warning with --strict
3  there is nothing to draw: the surface is undefined everywhere, or has no finite extent
A signal ends saddle with 128 and its number: Ctrl-C with 130. An output file appears whole or not
at all, and an interrupted run leaves no file behind. A reader that closes the pipe early, as in
saddle list | head -1, is no failure.
)";

/// Columns of a terminal, and where the second column of --help begins.
constexpr std::size_t kWidth = 100;
constexpr std::size_t kIndent = 24;

constexpr std::array<std::pair<Section, const char*>, 6> kSections = {{
    {Section::Output, "Output"},
    {Section::Camera, "Camera"},
    {Section::Look, "Look"},
    {Section::Mesh, "Mesh"},
    {Section::Time, "Time"},
    {Section::Run, "The run"},
}};

/// `left`, and `text` beside it in lines of up to kWidth columns.
std::string entry(const std::string& left, const std::string& text) {
  std::string result = left;
  result.resize(std::max(left.size() + 2, kIndent), ' ');
  std::size_t column = result.size();
  std::size_t begin = 0;
  while (begin < text.size()) {
    const std::size_t end = std::min(text.find(' ', begin), text.size());
    const std::size_t length = end - begin;
    if (begin > 0 && column + 1 + length > kWidth) {
      result += '\n' + std::string(kIndent, ' ');
      column = kIndent;
    } else if (begin > 0) {
      result += ' ';
      ++column;
    }
    result.append(text, begin, length);
    column += length;
    begin = end + 1;
  }
  return result + '\n';
}

std::string with_default(const std::string& text, const std::string& standard) {
  return standard.empty() ? text : text + " (default " + standard + ")";
}

/// With the formats that there are, too.
std::string with_formats(std::string_view text, const Option& option) {
  constexpr std::string_view kMark = "{formats}";
  std::string result = expanded(text, option);
  const std::size_t at = result.find(kMark);
  if (at != std::string::npos) result.replace(at, kMark.size(), format_list());
  return result;
}

std::string names_of(const Option& option) {
  const std::string letter = option.letter == 0 ? "    " : std::string("-") + option.letter + ", ";
  const std::string value = option.is_flag() ? "" : " " + std::string(option.value);
  return "  " + letter + dashed(option) + value;
}

std::string options_text() {
  std::string text = kUsage;
  for (const auto& [section, heading] : kSections) {
    text += std::string("\n") + heading + '\n';
    for (const Option& option : options()) {
      if (!option.is_option() || option.section != section) continue;
      text += entry(names_of(option),
                    with_default(with_formats(option.help, option), default_text(option)));
    }
  }
  return text;
}

const char* table_name(Table table) {
  switch (table) {
    case Table::None:
      return "";
    case Table::Scene:
      return "at the top of the file";
    case Table::Surface:
      return "[[surface]]";
    case Table::Stroke:
      return "[[curve]] and [[point]]";
    case Table::Curve:
      return "[[curve]]";
    case Table::Point:
      return "[[point]]";
    case Table::Camera:
      return "[camera]";
    case Table::Animation:
      return "[animation]";
  }
  return "";
}

/// `grid = [16, 16]`, a key with its default; in capitals without a fixed one.
std::string key_text(const Option& option) {
  std::string value = default_toml(option);
  const std::string standard = default_text(option);
  const bool is_word = standard != "off" && standard.find(' ') == std::string::npos;
  if (value.empty() && !standard.empty() && is_word) value = '"' + standard + '"';
  if (value.empty() || value == "\"\"") value = std::string(option.value);
  if (value == "X,Y,Z") value = "[X, Y, Z]";
  if (value == "MxN") value = "[M, N]";
  if (value == "FORMULA" || value == "EXPR" || value == "NODES") value = '"' + value + '"';
  return std::string(option.name) + " = " + value;
}

/// A heading, and two entries in each line.
std::string in_columns(const std::string& heading, const std::vector<std::string>& entries) {
  constexpr std::size_t kColumn = 48;
  std::string text = "\n" + heading + '\n';
  std::string line;
  for (const std::string& entry : entries) {
    const bool fits = line.size() <= kColumn && entry.size() + kColumn <= kWidth;
    if (!line.empty() && !fits) {
      text += line + '\n';
      line.clear();
    }
    if (!line.empty()) line.resize(kColumn, ' ');
    line += "  " + entry;
  }
  return text + line + '\n';
}

std::string scene_text() {
  std::string text = kScene;
  for (const Table table : {Table::Scene, Table::Surface, Table::Camera, Table::Animation}) {
    std::vector<std::string> entries;
    for (const Option& option : options()) {
      if (option.table == table) entries.push_back(key_text(option));
    }
    text += in_columns(table_name(table), entries);
  }
  const auto listed = [](const std::vector<std::string>& keys) {
    std::string names;
    for (const std::string& key : keys) names += (names.empty() ? "" : ", ") + key;
    return names;
  };
  text += "\n[[curve]] and [[point]]\n" + entry("  keys", listed(keys_of(Table::Stroke)));
  text += entry("  of curve", listed(keys_of(Table::Curve)));
  text += entry("  of point", listed(keys_of(Table::Point)));
  text += "\n[[light]]\n" + entry("  keys", listed(light_keys()));
  text += entry("  of spot", listed(spot_keys()));
  text += "\n[[node]]\n" + entry("  keys", "name, in, transform");
  return text;
}

std::string option_text(const Option& option) {
  const std::string names = names_of(option).substr(2 + (option.letter == 0 ? 4 : 0));
  const std::string key = std::string(option.name) + " = " + std::string(option.value);
  std::string text =
      (option.is_option() ? names : key) + "\n  " + with_formats(option.help, option) + '\n';
  if (!option.more.empty()) text += with_formats(option.more, option) + '\n';
  if (option.object) text += "Beside one of several objects: of that object.\n";
  std::string words;
  for (const std::string& word : choices(option)) words += " " + word;
  if (!words.empty() && option.help.find("{choices}") == std::string_view::npos) {
    text += "Values:" + words + '\n';
  }
  const std::string standard = default_text(option);
  if (!standard.empty()) text += "Default: " + standard + '\n';
  if (option.table != Table::None) {
    text += "Scene files: " + std::string(option.name) + ", " + table_name(option.table) + '\n';
  }
  return text;
}

std::string topic_text(const std::string& topic) {
  if (topic == "functions") return language_help();
  if (topic == "scene") return scene_text();
  if (topic == "status") return kStatus;
  if (topic == "keys") return key_help();
  if (topic == "formats") return format_table();
  const std::string name = topic.substr(std::min(topic.find_first_not_of('-'), topic.size()));
  const Option* const option = name.size() == 1 && find_option(name[0]) != nullptr
                                   ? find_option(name[0])
                                   : find_option(name);
  if (option != nullptr) return option_text(*option);
  if (find_verb(topic) != nullptr) return options_text();
  const auto key = std::ranges::find(options(), topic, &Option::name);
  if (key != options().end()) return option_text(*key);
  if (topic == "light" || topic == "node" || topic == "params") return scene_text();
  std::vector<std::string> known = {"functions", "formats", "scene", "status", "keys"};
  for (const Option& other : options()) {
    if (other.is_option()) known.emplace_back(other.name);
  }
  const std::string meant = did_you_mean(similar_names(name, known));
  throw Error(Status::Input, "there is no help on '" + topic + "'", {},
              (meant.empty() ? "" : meant + " ") +
                  "saddle --help lists the options; other topics are functions, formats, scene, "
                  "status and keys");
}

}  // namespace

std::string help_text(const std::vector<std::string>& topics) {
  if (topics.empty()) return options_text();
  std::string text;
  for (const std::string& topic : topics) text += (text.empty() ? "" : "\n") + topic_text(topic);
  return text;
}

std::string version() {
  return SADDLE_VERSION;
}

std::string version_text() {
  return "saddle " + version() + "\n";
}

}  // namespace saddle
