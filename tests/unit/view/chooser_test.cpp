// The search of lists, and the words of the panel.
#include "view/panel/chooser.h"

#include <gtest/gtest.h>

#include "view/panel/widgets.h"

namespace saddle {
namespace {

std::vector<std::string> found(const std::string& query) {
  std::vector<Choice> choices;
  choices.push_back({"Save picture", "s   save a PNG"});
  choices.push_back({"Reload", "r   read the picture again"});
  choices.push_back({"Picture", "p"});
  std::vector<std::string> names;
  for (const Choice& choice : matching(choices, query)) names.push_back(choice.name);
  return names;
}

TEST(Chooser, FindsAllWordsAnywhereAndPutsBeginningsFirst) {
  using Names = std::vector<std::string>;
  EXPECT_EQ(found(""), (Names{"Save picture", "Reload", "Picture"}));
  EXPECT_EQ(found("PICT"), (Names{"Picture", "Save picture", "Reload"}));
  EXPECT_EQ(found("png save"), Names{"Save picture"});
  EXPECT_EQ(found("torus"), Names{});
}

TEST(Panel, NamesItsOwnFieldsInPlaceOfOptions) {
  EXPECT_EQ(for_panel("clipped to a box; --clip off draws all of it"),
            "clipped to a box; clip off draws all of it");
  EXPECT_EQ(for_panel("u--v and 3--4"), "u--v and 3--4");
}

}  // namespace
}  // namespace saddle
