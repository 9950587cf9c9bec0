// Warnings of command lines that are right.
#include "cli/messages.h"

namespace saddle {
namespace {

constexpr MessageRow kWarnings[] = {
    {"z=u k=3", "k is defined, but nothing that is drawn depends on it", "", ""},
    {"z=a*u a=2 + z=v b=3", "b is defined, but nothing that is drawn depends on it", "", ""},
    {"z=1/x x=-1:1 y=0:1", "surface: the surface goes to infinity and is cut there: x = 0, y = 0:1",
     "", ""},
    {"z=sqrt(x) x=-1:1 where=y<0", "surface: 25 % of the domain is undefined and left out inside",
     "", ""},
    {"z=1/u", "surface: the surface goes to infinity and is cut there: u = 0, v = -1:1", "", ""},
    {"z=1/u", "surface: clipped to z = ", "--clip off shows all of it", "z=1/u --clip off"},
    {"z=sign(u)", "surface: the surface jumps and is cut there: u = 0, v = -1:1", "", ""},
    {"z=atan2(v,u)", "surface: the surface has no limit at u = 0, v = 0", "", ""},
    {"z=sqrt(u)",
     "surface: 50 % of the domain is undefined and left out, at least outside of u = ", "", ""},
    {"mobius", "mobius: the surface is one-sided: front and back meet along a line", "", ""},
    {"z=u u=1:0", "surface: a range runs backwards, which swaps front and back", "", ""},
    {"sphere --max-triangles 100", "sphere: the limit of triangles stopped refinement",
     "--max-triangles allows more", "sphere --max-triangles 100000"},
    {"curve x=s y=1/s s=-1:1 --radius 0.1",
     "curve: the curve goes to infinity and is cut there: s = 0", "", ""},
    {"curve x=s y=1/s s=-1:1 --radius 0.1", "curve: clipped to the box that most of it is in",
     "--clip off shows all", "curve x=s y=1/s s=-1:1 --radius 0.1 --clip off"},
    {"curve x=s y=sign(s) s=-1:1 --radius 0.1", "curve: the curve jumps and is cut there: s = 0",
     "", ""},
    {"curve x=s y=sqrt(s) s=-1:1 --radius 0.1", "curve: undefined over 50 % of the range of s", "",
     ""},
    {"sphere + point 1,2,3", "a.ply: .ply has no lines and dots: point is left out", "--radius",
     "sphere + point 1,2,3 --radius 0.1"},
    {"z=u^2+v^2 --contours z=7", "surface: the contours of z: none at 7; it runs from 0 to 2", "",
     ""},
    {"z=1 --contours z", "surface: the contours of z: it is 1 on a whole area, which has no line",
     "", ""},
    {"z=u --contours sqrt(u-2)",
     "surface: the contours of sqrt(u-2): no level; it is nowhere a finite number", "", ""},
    {"z=sin(1e5*u)", "surface: the surface oscillates faster than its tolerance shows, as at u = ",
     "smaller ranges show more", "z=sin(1e5*u) u=0:1e-4 v=0:1e-4"},
    {"x=u+1e15 y=v z=u*v", "surface: the mesh is off by at least ",
     "its coordinates are so large that doubles round them", "x=u y=v z=u*v"},
    {"z=u^2 --normal-tolerance 0.001 --max-triangles 5000",
     "surface: normals turn faster than its triangles show, by up to ",
     "--max-triangles allows more", ""},
    {"z=u --color u/0", "surface: the colour is undefined on 100 % of the surface, which is grey",
     "", ""},
    {"z=u --color 1/u", "surface: the colour goes to infinity; its range is cut to ", "", ""},
};

TEST_F(Messages, WarnOfWhatWouldMislead) {
  for (const MessageRow& row : kWarnings) {
    const Outcome outcome = run(std::string(row.command) + " -o a.ply");
    EXPECT_EQ(outcome.status, 0) << row.command;
    EXPECT_TRUE(contains(outcome.err, std::string("saddle: warning: ") + row.message))
        << row.command << "\n"
        << outcome.err;
    EXPECT_TRUE(contains(outcome.err, row.hint)) << row.command << "\n" << outcome.err;
    if (std::string_view(row.instead).empty()) continue;
    EXPECT_FALSE(contains(run(std::string(row.instead) + " -o a.ply").err, row.message))
        << row.instead;
  }
}

}  // namespace
}  // namespace saddle
