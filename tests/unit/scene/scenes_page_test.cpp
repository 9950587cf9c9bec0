// docs/SCENES.md has each key that the reader of scene files knows, and no other; its examples are
// read, and its defaults change nothing.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <sstream>

#include "base/error.h"
#include "base/file.h"
#include "paths.h"
#include "scene/options/lights.h"
#include "scene/options/options.h"
#include "scene/toml/scene_file.h"

namespace saddle {
namespace {

using Names = std::vector<std::string>;

/// A row of the page's tables of keys.
struct PageRow {
  std::string heading, key, standard, example;
};

/// What stands in backquotes from the first on; empty if there is more.
std::string code(const std::string& cell) {
  const std::size_t begin = cell.find('`');
  const std::size_t end = cell.rfind('`');
  const bool is_all = begin == 1 && end + 2 == cell.size();
  return is_all && std::ranges::count(cell, '`') == 2 ? cell.substr(2, end - 2) : "";
}

std::vector<PageRow> page_rows() {
  std::istringstream page(read_file(source_folder() + "/docs/SCENES.md"));
  std::vector<PageRow> rows;
  std::string heading;
  for (std::string line; std::getline(page, line);) {
    if (line.starts_with("## ")) heading = line.substr(3);
    if (!line.starts_with("| `")) continue;
    Names cells;
    std::istringstream in(line.substr(1));
    for (std::string cell; std::getline(in, cell, '|');) cells.push_back(cell);
    if (cells.size() == 6)
      rows.push_back({heading, code(cells[0]), code(cells[3]), code(cells[4])});
  }
  return rows;
}

Names keys_under(const std::string& heading) {
  Names keys;
  for (const PageRow& row : page_rows()) {
    if (row.heading == heading) keys.push_back(row.key);
  }
  return keys;
}

/// A scene in which one line of a table is what is tested.
std::string scene_with(const std::string& heading, const std::string& line) {
  const std::string surface = "[[surface]]\nz = \"u+v\"\n";
  const std::string node = "[[node]]\nname = \"wheel\"\n[[node]]\nname = \"car\"\n";
  if (heading == "Top of the file") return line + "\n" + surface;
  if (heading == "[[surface]]") {
    const bool is_place = line.starts_with("z =") || line.starts_with("xyz =");
    const std::string z = is_place ? "" : "z = \"x+y\"\n";
    const bool is_colored = !line.starts_with("color =") && !line.starts_with("texture =");
    const std::string color = is_colored ? "color = \"z\"\n" : "";
    return "[[surface]]\n" + z + color + line + "\n" + node;
  }
  if (heading == "[[curve]]" || heading == "[[point]]") {
    const bool is_on = line.starts_with("on ") || line.starts_with("u ") || line.starts_with("v ");
    const std::string in_space = heading == "[[curve]]" ? "x = \"s\"\n" : "at = [0, 0, 0]\n";
    const bool is_own = line.starts_with(in_space.substr(0, 2)) || line.starts_with("xyz ");
    const std::string u = line.starts_with("u ") ? "" : "u = \"0.5\"\n";
    const std::string v = line.starts_with("v ")   ? ""
                          : heading == "[[curve]]" ? "v = \"s\"\n"
                                                   : "v = 0\n";
    return surface + node + heading + "\n" + (is_on ? u + v : is_own ? "" : in_space) + line + "\n";
  }
  if (heading == "Materials") return surface + "front = { " + line + " }\n";
  if (heading == "Spot lights") return surface + "[[light]]\nspot = { " + line + " }\n";
  const bool has_name = line.starts_with("name =");
  const std::string name = heading == "[[node]]" && !has_name ? "name = \"axle\"\n" : "";
  return surface + (heading == "[[node]]" && !has_name ? node : "") + heading + "\n" + name + line +
         "\n";
}

std::string written(const std::string& scene) {
  return write_scene(read_scene({"page", scene}));
}

TEST(ScenesPage, HasTheKeysOfTheReader) {
  EXPECT_EQ(keys_under("Top of the file"), keys_of(Table::Scene));
  EXPECT_EQ(keys_under("[[surface]]"), keys_of(Table::Surface));
  const auto stroke_keys = [](Table own) {
    Names keys = keys_of(Table::Stroke);
    std::ranges::copy(keys_of(own), std::back_inserter(keys));
    return keys;
  };
  EXPECT_EQ(keys_under("[[curve]]"), stroke_keys(Table::Curve));
  EXPECT_EQ(keys_under("[[point]]"), stroke_keys(Table::Point));
  EXPECT_EQ(keys_under("[camera]"), keys_of(Table::Camera));
  EXPECT_EQ(keys_under("[animation]"), keys_of(Table::Animation));
  EXPECT_EQ(keys_under("[[light]]"), light_keys());
  EXPECT_EQ(keys_under("Spot lights"), spot_keys());
}

/// The reader's own list of the keys of tables that have no rows in C++.
TEST(ScenesPage, HasTheKeysThatTheReaderTells) {
  const std::map<std::string, std::string> tables = {
      {"[[node]]", scene_with("[[node]]", "nokey = 1")},
      {"Materials", scene_with("Materials", "nokey = 1")}};
  for (const auto& [heading, scene] : tables) {
    std::string known = "known keys:";
    for (const std::string& key : keys_under(heading)) known += " " + key;
    try {
      written(scene);
      ADD_FAILURE() << heading;
    } catch (const Error& error) {
      EXPECT_TRUE(error.hint().starts_with(known)) << heading << ": " << error.hint();
    }
  }
}

TEST(ScenesPage, HasExamplesThatAreRead) {
  for (const PageRow& row : page_rows()) {
    ASSERT_FALSE(row.example.empty()) << row.heading << " " << row.key;
    try {
      written(scene_with(row.heading, row.example));
    } catch (const Error& error) {
      ADD_FAILURE() << row.heading << " " << row.example << ": " << format_error(error);
    }
  }
}

TEST(ScenesPage, HasDefaultsThatChangeNothing) {
  for (const PageRow& row : page_rows()) {
    const bool is_key = row.standard == "color";  // of diffuse and specular light
    if (row.standard.empty() || is_key) continue;
    const std::string line = row.key + " = " + row.standard;
    try {
      EXPECT_EQ(written(scene_with(row.heading, line)), written(scene_with(row.heading, "")))
          << row.heading << " " << line;
    } catch (const Error& error) {
      ADD_FAILURE() << row.heading << " " << line << ": " << format_error(error);
    }
  }
}

}  // namespace
}  // namespace saddle
