#include "base/nearest.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace saddle {
namespace {

using Names = std::vector<std::string>;
constexpr auto kNone = std::nullopt;

TEST(NearestName, FindsAMistypedLetterALeftOutOneAndOneTooMany) {
  const Names names = {"cos", "floor", "sin"};
  EXPECT_EQ(nearest_name("sim", names), "sin");
  EXPECT_EQ(nearest_name("flor", names), "floor");
  EXPECT_EQ(nearest_name("floorr", names), "floor");
}

TEST(NearestName, CountsASwapOfNeighboursAsOneEdit) {
  // Two substitutions would be past the limit for three letters.
  EXPECT_EQ(nearest_name("sni", Names{"sin"}), "sin");
  EXPECT_EQ(nearest_name("sni", Names{"sna", "sin"}), "sna") << "and as no less than one";
}

TEST(NearestName, EditsNoPartOfTheTextTwice) {
  // "ca" to "abc" costs as much as two substitutions by optimal string alignment; without its
  // restriction it would be a swap and a letter left out, which is less.
  EXPECT_EQ(nearest_name("cawxyz", Names{"cawxYY", "abcwxyz"}), "cawxYY");
}

TEST(NearestName, CountsALetterThatWasLeftOutHalf) {
  EXPECT_EQ(nearest_name("foo", Names{"cot", "mod", "floor", "log"}), "floor");
  EXPECT_EQ(nearest_name("foo", Names{"folder"}), kNone);
}

TEST(NearestName, IsNoneOfATextOfAMegabyteWithoutLookingAtAllOfIt) {
  // Letter by letter these would be compared for an hour.
  const Names names = {"sin", std::string(300'000, 'a')};
  EXPECT_EQ(nearest_name(std::string(1'000'000, 'a'), names), kNone);
  std::string words;
  for (int i = 0; i < 100; ++i) words += "sinus-";
  EXPECT_TRUE(similar_names(words, names).empty());
}

TEST(NearestName, IgnoresCase) {
  EXPECT_EQ(nearest_name("SIN", Names{"cos", "sin"}), "sin");
  EXPECT_EQ(nearest_name("catmul", Names{"Catmull"}), "Catmull");
  EXPECT_EQ(nearest_name("AZ", Names{"bz", "ab", "az"}), "az") << "all letters, from A to Z";
}

TEST(NearestName, CountsWhatIsLeftOutOrTooMuchAtTheStart) {
  EXPECT_EQ(nearest_name("orus", Names{"xtorus"}), "xtorus");
  EXPECT_EQ(nearest_name("orus", Names{"xyzorus"}), kNone);
  EXPECT_EQ(nearest_name("xxtorus", Names{"torus"}), "torus");
  EXPECT_EQ(nearest_name("xxxxtorus", Names{"torus"}), kNone);
}

TEST(NearestName, AllowsAThirdOfTheWord) {
  EXPECT_EQ(nearest_name("abcdef", Names{"abcdXY"}), "abcdXY");
  EXPECT_EQ(nearest_name("abcdef", Names{"abcXYZ"}), kNone);
  EXPECT_EQ(nearest_name("abcde", Names{"abcXY"}), kNone);
  EXPECT_EQ(nearest_name("ab", Names{"aX"}), "aX");
}

TEST(NearestName, LeavesSingleLettersAlone) {
  EXPECT_EQ(nearest_name("a", Names{"tau", "at", "b"}), kNone);
  EXPECT_EQ(nearest_name("r", Names{"re", "R"}), "R");
}

TEST(NearestName, PrefersTheLeastDistanceThenTheFirst) {
  EXPECT_EQ(nearest_name("abcdef", Names{"abcdXX", "abcdeX", "abcdeY"}), "abcdeX");
}

TEST(NearestName, CountsCharactersAndNotBytes) {
  EXPECT_EQ(nearest_name("\u03B1\u03B2\u03B3", Names{"\u03B1\u03B2\u03B4"}), "\u03B1\u03B2\u03B4");
  // Six bytes would allow two edits, three characters allow one.
  EXPECT_EQ(nearest_name("\u03B1\u03B2\u03B3", Names{"\u03B1\u03B4\u03B5"}), kNone);
}

TEST(SimilarNames, ShareAPart) {
  const Names names = {"torus", "horn-torus", "klein-figure8", "klein-bottle", "mobius", "sphere"};
  EXPECT_EQ(similar_names("klein", names), (Names{"klein-figure8", "klein-bottle"}));
  EXPECT_EQ(similar_names("Kliein-surface", names), (Names{"klein-figure8", "klein-bottle"}));
  EXPECT_EQ(similar_names("mobius_strip", names), Names{"mobius"});
  EXPECT_EQ(similar_names("torus-knot", names), (Names{"torus", "horn-torus"}));
  EXPECT_EQ(similar_names("tours", names), Names{"torus"}) << "the nearest alone";
  EXPECT_EQ(similar_names("plane", names), Names{});
  EXPECT_EQ(similar_names("box-surface", Names{"my-box"}), Names{"my-box"});
  EXPECT_EQ(similar_names("a-surface", Names{"a-plane"}), Names{}) << "a short part says nothing";
  const Names five = {"klein-amber", "klein-brown", "klein-coral", "klein-drab", "klein-ebony"};
  EXPECT_EQ(similar_names("klein", five), Names(five.begin(), five.begin() + 4));
  const Names cases = {"AZURE-tile", "azure-tube"};
  EXPECT_EQ(similar_names("azure-surface", cases), cases) << "all letters, from A to Z";
  EXPECT_EQ(did_you_mean(Names{}), "");
  EXPECT_EQ(did_you_mean(Names{"a", "b", "c"}), "did you mean 'a', 'b' or 'c'?");
}

TEST(NearestName, SuggestsNothingThatHasNoLetterInCommon) {
  EXPECT_EQ(nearest_name("q", Names{"e", "u"}), kNone);
  EXPECT_EQ(nearest_name("", Names{"e"}), kNone);
  EXPECT_EQ(nearest_name("q", Names{}), kNone);
}

}  // namespace
}  // namespace saddle
