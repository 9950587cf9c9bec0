// The table of actions: what menus, keys and lists are made from.
#include "view/model/actions.h"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <string>

namespace saddle {
namespace {

TEST(Actions, HaveKeysOfTheirOwn) {
  std::set<std::string> keys;
  for (const ActionRow& row : action_table()) {
    if (*row.key == 0) continue;
    EXPECT_TRUE(keys.insert(row.key).second) << row.key;
    EXPECT_EQ(find_key(row.key), &row);
  }
  EXPECT_EQ(find_key(""), nullptr);
  EXPECT_EQ(find_key("q"), nullptr) << "no letter quits";
}

TEST(Actions, AreInOneMenuEach) {
  std::map<Action, int> menus;
  for (const ActionRow& row : action_table()) menus[row.action] += row.menu != Menu::None ? 1 : 0;
  for (const auto& [action, count] : menus) {
    EXPECT_EQ(count, action == Action::Dismiss ? 0 : 1) << row_of(action).name;
  }
  EXPECT_EQ(menus.size(), static_cast<std::size_t>(Action::Dismiss) + 1);
}

TEST(Actions, AreInTheHelpWithTheirKeys) {
  const std::string help = key_help();
  for (const ActionRow& row : action_table()) {
    if (*row.key == 0) continue;
    EXPECT_NE(help.find(row.help), std::string::npos) << row.name;
  }
  EXPECT_NE(help.find("Double click"), std::string::npos);
}

}  // namespace
}  // namespace saddle
