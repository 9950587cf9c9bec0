#include "export/page/page_text.h"

#include <gtest/gtest.h>

namespace saddle {
namespace {

TEST(PageText, LosesSpacesAndEndsOfLinesThatSeparateNothing) {
  EXPECT_EQ(squeezed("const a = b + - c;\nlet d = { e, f };\n"), "const a=b+ -c;let d={e,f};");
  EXPECT_EQ(squeezed("return a - 1\nb()\n"), "return a-1\nb()\n");
  EXPECT_EQ(squeezed(".a b { margin: 0 1em; }\n"), ".a b{margin:0 1em;}\n");
}

TEST(PageText, KeepsWhatStandsInQuotes) {
  EXPECT_EQ(squeezed("f('a = \\' ;', \"b : c\");"), "f('a = \\' ;',\"b : c\");");
  EXPECT_EQ(squeezed("`a = ${ b.map(c => `${c} = { d }`) } ; e`"),
            "`a = ${b.map(c=>`${c} = { d }`)} ; e`");
}

TEST(PageText, KeepsLinesOfThePreprocessor) {
  EXPECT_EQ(squeezed("float a;\n#define B (1 + 2)\nint c = B;\n"),
            "float a;\n#define B (1 + 2)\nint c=B;");
}

TEST(PageText, LosesCommentsButNoAddresses) {
  EXPECT_EQ(without_comments("  // all\n  a;  // rest\n\nb = 'x//y';\n"), "a;\nb = 'x//y';\n");
}

}  // namespace
}  // namespace saddle
