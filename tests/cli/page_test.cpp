// Pages and figures: what is written, what is read back, and what is refused.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "base/file.h"
#include "cli/program.h"

namespace saddle {
namespace {

class GraphPage : public ProgramTest {
 protected:
  std::string text(const std::string& name) const { return read_file(path(name)); }
};

TEST_F(GraphPage, IsOneFileThatNamesNoOther) {
  EXPECT_EQ(small({"torus", "-o", "a.html"}).status, 0);
  const std::string page = text("a.html");
  EXPECT_FALSE(contains(page, "http://") || contains(page, "https://") || contains(page, "src="));
  EXPECT_TRUE(contains(page, "default-src 'none'"));
}

TEST_F(GraphPage, IsTheSameOnAnyNumberOfThreads) {
  for (const char* threads : {"1", "3"}) {
    EXPECT_EQ(small({"boy", "--threads", threads, "-o", std::string(threads) + ".html"}).status, 0);
  }
  EXPECT_EQ(text("1.html"), text("3.html"));
}

TEST_F(GraphPage, AndFiguresOpenAgain) {
  EXPECT_EQ(small({"torus", "r=0.5", "--title", "\"<&>\" ü", "-o", "a.html", "-o", "a.svg", "-o",
                   "a.pdf", "-o", "a.png"})
                .status,
            0);
  const auto scene = [this](const std::string& name) {
    return saddle({name, "-o", "-", "--format", "toml"}).out;
  };
  EXPECT_TRUE(contains(scene("a.png"), "r = 0.5"));
  for (const char* name : {"a.html", "a.svg", "a.pdf"}) EXPECT_EQ(scene(name), scene("a.png"));
}

TEST_F(GraphPage, WithoutASceneIsRefused) {
  write_file_whole(path("a.html").string(), [](std::ostream& out) { out << "<p>"; });
  EXPECT_TRUE(contains(error_of(saddle({"a.html", "-o", "a.png"}), 2), "a.html holds no scene"));
}

TEST_F(GraphPage, EscapesWhatWouldEndAScript) {
  EXPECT_EQ(
      small({"z=u*v", "--title", "</script><script>alert(1)</script>", "-o", "a.html"}).status, 0);
  EXPECT_FALSE(contains(text("a.html"), "alert(1)<"));
}

TEST_F(GraphPage, ThatIsHeavyForBrowsersIsWarnedOf) {
  const std::string told = error_of(saddle({"z=u*v", "--samples", "510x510", "-o", "a.html"}), 0);
  EXPECT_TRUE(contains(told, "a.html: 520200 triangles")) << told;
  EXPECT_TRUE(contains(told, "--tolerance")) << told;
  EXPECT_EQ(saddle({"z=u*v", "-o", "a.html"}).err, "");
}

TEST_F(GraphPage, FragmentHasNoBody) {
  EXPECT_EQ(small({"torus", "--fragment", "-o", "a.html"}).status, 0);
  EXPECT_TRUE(text("a.html").starts_with("<div class=\"saddle\" data-fragment>"));
  EXPECT_FALSE(contains(text("a.html"), "<body"));
  EXPECT_FALSE(contains(text("a.html"), "\n\n")) << "in Markdown HTML ends at an empty line";
}

TEST_F(GraphPage, IsAsFineAsALargeScreenAndFiguresAsFineAsPrint) {
  const auto tolerance = [this](const std::string& name) {
    return nlohmann::json::parse(
               saddle({"torus", "-o", name, "--report", "-"}).out)["surfaces"][0]["tolerance"]
        .get<double>();
  };
  const double picture = tolerance("a.png");
  EXPECT_NEAR(tolerance("a.html") / picture, 600.0 / 1080, 0.01);
  EXPECT_NEAR(tolerance("a.pdf") / picture, 0.2, 0.01);
}

TEST_F(GraphPage, TellsReadersWhoDoNotSeeItWhatItShows) {
  EXPECT_EQ(
      small({"xyz=(cos(u),sin(u),k*v)", "u=0:tau", "k=2", "+", "mobius", "-o", "a.html"}).status,
      0);
  const std::string page = text("a.html");
  EXPECT_TRUE(contains(page, "xyz = (cos(u),sin(u),k*v)   u = 0 : tau   v = -1 : 1")) << page;
  EXPECT_TRUE(contains(page, "surface with 2 boundaries: x from -1 to 1")) << page;
  EXPECT_TRUE(contains(page, "one-sided surface with one boundary")) << page;
  EXPECT_TRUE(contains(page, "k = 2")) << page;
}

TEST_F(GraphPage, SlidersAreThoseOfItsParameters) {
  const std::string said =
      error_of(small({"z=foo*u", "foo=2", "--sliders", "fo", "-o", "a.html"}), 2);
  EXPECT_TRUE(contains(said, "no parameter is called 'fo'")) << said;
  EXPECT_TRUE(contains(said, "did you mean 'foo'?")) << said;
  EXPECT_FALSE(exists("a.html"));
  EXPECT_EQ(small({"z=foo*u", "foo=2", "--sliders", "foo", "-o", "a.html"}).status, 0);
  EXPECT_TRUE(contains(error_of(small({"torus", "--sliders", "off", "-o", "a.png"}), 2),
                       "no output is a page"));
}

}  // namespace
}  // namespace saddle
