// The one table of options and scene keys; its rows are in option_table.cpp. The command line,
// --help, hints, scene files in both directions, `resolve()` and the command that a scene is as
// text all read it.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scene/options/option_kinds.h"

namespace saddle {

/// Headings of --help, in its order.
enum class Section { Output, Camera, Look, Mesh, Time, Run };

/// Where a key stands in a scene file. Stroke: curves and points have it.
enum class Table { None, Scene, Surface, Stroke, Curve, Point, Camera, Animation };

/// The command that the first word of a command line names.
enum class Command { Graph, Check, Chart, List, Show };

/// Commands that take an option, as bits.
constexpr unsigned bit(Command command) {
  return 1U << static_cast<unsigned>(command);
}
inline constexpr unsigned kKeyOnly = 0;  ///< the row is a key of scene files alone
inline constexpr unsigned kGraph = bit(Command::Graph);
inline constexpr unsigned kGraphCheck = kGraph | bit(Command::Check);
inline constexpr unsigned kGraphChart = kGraph | bit(Command::Chart);
inline constexpr unsigned kSurfaceCommands = kGraphCheck | kGraphChart;
inline constexpr unsigned kAllCommands = kSurfaceCommands | bit(Command::List) | bit(Command::Show);

/// A row. In `help` and `more`, --help fills in {choices}, {limits} and {formats}. Exactly one of
/// `scene`, `surface`, `stroke`, `curve`, `point` and `run` is there: whose value it is; an option
/// of surfaces may be one of curves and points, too. It is for each of them in the scene.
struct Option {
  std::string_view name;           ///< without "--"; also the key
  char letter = 0;                 ///< of "-s"; 0: none
  std::string_view value = {};     ///< "WxH"; of an option: empty for a flag
  Section section = Section::Run;  ///< of --help
  std::string_view help = {};      ///< one line, without the default; may have marks, see below
  std::string_view usual = {};  ///< default in words; empty: the value that its owner begins with
  std::string_view more = {};   ///< what --help NAME adds
  unsigned commands = kSurfaceCommands;  ///< that take it
  bool repeats = false;                  ///< each time it is given counts, not only the last
  bool object = false;                   ///< of the object it stands with, not of the scene
  std::string_view needs = {};           ///< an option without which it would do nothing
  std::string_view excludes = {};        ///< an option that says the opposite
  Table table = Table::None;             ///< of the scene file
  std::string_view subject = {};         ///< what messages call the key; empty: its name
  kinds::Slot (*scene)(Scene&) = nullptr;
  kinds::Slot (*surface)(SurfaceSpec&) = nullptr;
  kinds::Slot (*stroke)(StrokeSpec&) = nullptr;
  kinds::Slot (*curve)(CurveSpec&) = nullptr;
  kinds::Slot (*point)(PointSpec&) = nullptr;
  kinds::Slot (*run)(RunSettings&) = nullptr;

  bool is_option() const { return commands != kKeyOnly; }
  bool is_flag() const { return value.empty(); }
};

/// Rows in the order in which scene files have their keys, those of a section together.
std::span<const Option> options();

/// nullptr if no option has the name, without "--", or the letter.
const Option* find_option(std::string_view name);
const Option* find_option(char letter);

/// "--size", for messages.
std::string dashed(const Option& option);

/// The default as text, "" if there is none to tell.
std::string default_text(const Option& option);

/// The default as scene files have it; empty without one.
std::string default_toml(const Option& option);

/// The limits of an option that takes a number, "more than 0" or "1 to 16"; "" for others.
std::string limits_text(const Option& option);

/// The words of a choice.
std::vector<std::string> choices(const Option& option);

/// The line about an option, with its words and limits in place of {choices} and {limits}.
std::string help_of(const Option& option);

/// A text about an option, in the same way.
std::string expanded(std::string_view text, const Option& option);

/// The keys of a table of scene files that are rows.
std::vector<std::string> keys_of(Table table);

/// The keys of a surface: its ranges have the names of its parameters.
std::vector<std::string> keys_of(const SurfaceSpec& surface);

/// Throws Error (Input) for a value that is wrong whatever the scene has.
void check_value(const Option& option, const std::string& text);

/// Changes what an option of the scene or its surfaces is about. Throws Error (Input).
void apply_option(const Option& option, const std::string& text, Scene& scene);

/// An object's option is about its curves and points. `beside_surfaces`: they stand with surfaces,
/// whose colour is a formula.
bool is_of_strokes(const Option& option, bool beside_surfaces);

/// Changes what an object's option is about, for one surface, curve or point of the scene: in place
/// of what the scene says, if that has the option, too. Throws Error (Input).
void apply_option(const Option& option, const std::string& text, const Scene& scene,
                  SurfaceSpec& surface);
void apply_option(const Option& option, const std::string& text, const Scene& scene,
                  StrokeSpec& stroke);

/// Sets the place of a point, X,Y,Z. Throws Error (Input).
void set_place(const std::string& text, PointSpec& point);

/// Changes what an option of the run is about. Throws Error (Input).
void apply_option(const Option& option, const std::string& text, RunSettings& run);

/// Reads those keys of a TOML table that are rows; `prefix` completes what messages call them.
/// Throws Error (Input).
void read_keys(Table table, TomlReader& reader, const std::string& prefix, const TomlValue& value,
               Scene& scene);
void read_keys(TomlReader& reader, const std::string& prefix, const TomlValue& value,
               SurfaceSpec& surface);
void read_keys(TomlReader& reader, const std::string& prefix, const TomlValue& value,
               CurveSpec& curve);
void read_keys(TomlReader& reader, const std::string& prefix, const TomlValue& value,
               PointSpec& point);

/// Lines `key = value` for what differs from the defaults, which are the theme's.
std::string write_keys(Table table, const Scene& scene);
std::string write_keys(const SurfaceSpec& surface, Theme theme);
std::string write_keys(const CurveSpec& curve);
std::string write_keys(const PointSpec& point);

/// Expressions become numbers. Throws Error (Input).
void resolve_keys(Resolver& resolver, Table table, Scene& scene);
void resolve_keys(Resolver& resolver, const std::string& prefix, SurfaceSpec& surface);
void resolve_keys(Resolver& resolver, const std::string& prefix, CurveSpec& curve);
void resolve_keys(Resolver& resolver, const std::string& prefix, PointSpec& point);

/// An option with the text that sets it to the value of a scene of one surface.
struct Setting {
  const Option* option;
  std::string text;
};

/// The options that make of a scene with the same formulas and definitions this one, as far as
/// options can.
std::vector<Setting> settings_of(const Scene& scene);

}  // namespace saddle
