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
    {"x=exp(50*u) y=exp(50*v) z=u",
     "surface: 152 of 450 triangles have no area in double precision and are left out", "", ""},
    {"x=u y=u*1e-9*v z=v*1e-16+u",
     "surface: 1 singular point has no normal (the first at u = 0, v = -1): the faces' are drawn "
     "there",
     "", ""},
    {"x=u y=(u^2-0.25)*1e-9*v z=v*1e-16+u",
     "surface: 2 singular points have no normal (the first at u = -0.5, v = -1)", "", ""},
    {"z=if(sin(1e3*u*v)>0.99,1,0) --max-triangles 20000",
     "surface: the limit of work stopped refinement, the mesh is off by at least ",
     "smaller ranges show more, --max-triangles allows more work", ""},
    {"z=sin(1e4*u*v) --max-triangles 400",
     "surface: the limit of triangles stopped refinement, the mesh is off by at least ",
     "--max-triangles allows more, the tolerance needs ", ""},
    {"z=u^2 --color sin(300*u*v) --max-triangles 2000",
     "surface: the limit of triangles stopped refinement for the colour, which is blurred",
     "--max-triangles allows more", ""},
    {"z=u^2 --contours sin(300*u*v) --max-triangles 2000",
     "surface: the contours of sin(300*u*v) may lack parts: the limit of triangles stopped the "
     "search",
     "--max-triangles allows more", ""},
};

/// What a format leaves out. A row names its own file.
constexpr MessageRow kLosses[] = {
    {"torus --front red -o a.stl", "a.stl: the colour of --front is left out",
     ".obj, .glb and .3mf can hold all of it", "torus --front red -o a.obj"},
    {"torus --back red -o a.stl", "a.stl: the colour of --back is left out",
     ".glb and .3mf can hold all of it", "torus --back red -o a.glb"},
    {"torus --color z -o a.stl", "a.stl: the colours of --color are left out",
     ".ply, .obj, .glb and .3mf can hold all of it", "torus --color z -o a.ply"},
    {"torus --contours z -o a.stl", "a.stl: the level lines of --contours are left out",
     ".obj and .glb can hold all of it", "torus --contours z -o a.obj"},
    {"torus --print-size 80 -o a.ply",
     "a.ply: the file keeps the scene's units, --print-size is not for it", "",
     "torus --print-size 80 -o a.stl"},
    {"x=u+1e6 y=v z=u*v --samples 200x200 -o a.stl", "a.stl: positions are rounded by up to ",
     "of the diagonal; .ply and .obj have doubles", "x=u+1e6 y=v z=u*v --samples 200x200 -o a.ply"},
    {"x=u+1e6 y=v z=u*v --samples 200x200 -o a.stl", "a.stl: 336 triangles that rounding to floats",
     "flattens: left out", "x=u+1e6 y=v z=u*v --samples 200x200 -o a.ply"},
    {"mobius -o a.stl", "a.stl: no solid that can be printed: ",
     " open edges and a one-sided surface; --thickness 0.08 makes one",
     "mobius --thickness 0.08 -o a.stl"},
};

class Warnings : public Messages {
 protected:
  /// Each command ends with 0 and its warning; what the hint says has none. `ending`: of commands.
  void expect_warnings(std::span<const MessageRow> rows, const std::string& ending) {
    for (const MessageRow& row : rows) {
      const Outcome outcome = run(row.command + ending);
      EXPECT_EQ(outcome.status, 0) << row.command;
      EXPECT_TRUE(contains(outcome.err, std::string("saddle: warning: ") + row.message))
          << row.command << "\n"
          << outcome.err;
      EXPECT_TRUE(contains(outcome.err, row.hint)) << row.command << "\n" << outcome.err;
      if (std::string_view(row.instead).empty()) continue;
      const Outcome instead = run(row.instead + ending);
      EXPECT_EQ(instead.status, 0) << row.instead << "\n" << instead.err;
      EXPECT_FALSE(contains(instead.err, row.message)) << row.instead;
    }
  }
};

TEST_F(Warnings, AreOfWhatWouldMislead) {
  expect_warnings(kWarnings, " -o a.ply");
}

/// A report tells of gaps in the proof that need no warning.
TEST_F(Warnings, AreFewerThanTheFindingsOfTheReport) {
  const Outcome outcome = run("z=gamma(5*u) -o a.ply --report -");
  EXPECT_EQ(outcome.status, 0);
  EXPECT_TRUE(contains(outcome.out, "of the domain is not proved, as at u = ")) << outcome.out;
  EXPECT_FALSE(contains(outcome.err, "not proved")) << outcome.err;
}

/// A counterexample against a leaf with hanging vertices is measured from the triangles that the
/// leaf has. It is told only where halving does not mend it.
TEST_F(Warnings, AreNotOfErrorsThatHalvingMends) {
  const Outcome outcome = run("bourke-harmonic -o a.ply");
  EXPECT_EQ(outcome.status, 0);
  EXPECT_FALSE(contains(outcome.err, "the mesh is off")) << outcome.err;
}

TEST_F(Warnings, AreOfWhatFormatsLeaveOut) {
  expect_warnings(kLosses, "");
}

}  // namespace
}  // namespace saddle
