// Messages about several objects of a command line, curves and points.
#include "cli/messages.h"

namespace saddle {
namespace {

constexpr MessageRow kRows[] = {
    {"z=p*q p=0:1 q=0:1 + curve p=s -o a.obj", "p: v is missing",
     "a place on a surface has u and v, here p and q",
     "z=p*q p=0:1 q=0:1 + curve p=s q=s -o a.obj"},
    {"z=p*q p=0:1 q=0:1 + curve p=s q=foo -o a.obj", "q: unknown name 'foo'", "foo=1 defines it",
     "z=p*q p=0:1 q=0:1 + curve p=s q=foo foo=1 -o a.obj"},
    // several objects
    {"torus + -o a.toml", "there is no object after the '+'", "saddle torus + z=u*v",
     "torus + z=u*v -o a.toml"},
    {"+ torus -o a.toml", "there is no object before the '+'", "saddle torus + z=u*v",
     "torus + z=u*v -o a.toml"},
    {"torus + --front red -o a.toml", "there is no object after the '+'", "saddle torus + z=u*v",
     "torus --front red -o a.toml"},
    {"z=a*u a=1 + z=a*v a=2 -o a.toml", "argument: two definitions of 'a': a=1 and a=2",
     "give one of them another name", "z=a*u a=1 + z=b*v b=2 -o a.toml"},
    {"z=u*t t=0:1 + z=v t=0:2 -o a.toml", "argument: two definitions of 't': t=0:1 and t=0:2",
     "leave one of them out", "z=u*t t=0:1 + z=v -o a.toml"},
    {"torus curve u=s v=s -o a.toml", "a curve beside a surface stands after a '+'",
     "torus + curve u=s", "torus + curve u=s v='2*s' s=0:tau -o a.toml"},
    {"z=u*v curve u=s v=s -o a.toml", "a curve beside a surface stands after a '+'",
     "torus + curve u=s", "z=u*v + curve u=s v=s -o a.toml"},
    {"torus point 1,2,3 -o a.toml", "a point beside a surface stands after a '+'",
     "torus + point 1,2,3", "torus + point 1,2,3 -o a.toml"},
    {"torus k=3 + sphere -o a.toml", "argument: torus has no 'k'", "known names: R r x y z u v t",
     "torus r=0.3 + sphere -o a.toml"},
    {"torus r=0.2 + z=u r=0.3 R=1 r=4 -o a.toml", "argument: 'r' is given twice",
     "leave one of them out", "torus r=0.2 + z=u*r r=4 -o a.toml"},
    {"u=0:1 + torus -o a.ply", "z has no formula", "z='sin(u)*cos(v)'",
     "u=0:1 'z=sin(u)*cos(v)' + torus -o a.toml"},
    {"torus --colormap magma + z=u --color u -o a.toml", "--colormap: there is nothing to colour",
     "--color z", "torus --colormap magma --color z + z=u --color u -o a.toml"},
    // curves and points
    {"curve u=s v=s -o a.toml", "u: there is no surface for u and v", "a surface stands before",
     "torus + curve u=s v=s -o a.toml"},
    {"torus + sphere --color red -o a.toml", "--color: this is a colour, not a formula",
     "--front red --back red", "torus + sphere --front red --back red -o a.toml"},
    {"torus + curve u=s -o a.toml", "u: v is missing", "has u and v",
     "torus + curve u=s v=0 -o a.toml"},
    {"curve x=3 -o a.toml", "the curve does not depend on s",
     "x='cos(s)' y='sin(s)' z='s/5' s=0:tau",
     "curve x='cos(s)' y='sin(s)' z='s/5' s=0:tau -o a.toml"},
    {"curve x=t t=0:1 -o a.toml", "the curve does not depend on s", "t is time", ""},
    {"torus + curve x=s u=s v=0 -o a.toml", "u: the curve has two places", "leave one of them out",
     "curve x=s -o a.toml"},
    {"curve xyz=(s,s,s) y=s -o a.toml", "xyz: xyz gives y, too", "leave xyz or y out",
     "curve xyz=(s,s,s) -o a.toml"},
    {"curve xyz=(s,s) -o a.toml", "xyz: xyz is a vector of 2", "write (a, b, c)",
     "curve xyz=(s,s,0) -o a.toml"},
    {"curve -o a.toml", "the curve has no place", "x='cos(s)'", ""},
    {"curve x=s u=0:1 -o a.toml", "u: a curve has a range of s", "write s=0:1",
     "curve x=s s=0:1 -o a.toml"},
    {"z=p*q p=0:1 q=0:1 + curve p=0:1 -o a.toml",
     "p: a curve has a range of s, and of t, but none of p", "write s=0:1",
     "z=p*q p=0:1 q=0:1 + curve p=s q=s s=0:1 -o a.toml"},
    {"curve x=s s=3 -o a.toml", "s: a range is MIN:MAX", "s=0:2*pi",
     "curve x=s s=0:2*pi -o a.toml"},
    {"curve x=s foo -o a.toml", "'foo' is no part of a curve", "curve x='cos(s)'", ""},
    {"curve x=s --front red -o a.toml", "--front: a curve takes no such option", "--color",
     "curve x=s --color red -o a.toml"},
    {"sphere --radius 0.1 -o a.toml", "--radius: there is no curve or point that takes it",
     "+ point 0,0,1 --radius 0.1", "sphere + point 0,0,1 --radius 0.1 -o a.toml"},
    {"sphere --radius 0.1 + point 1,2,3 -o a.toml", "--radius: there is no curve or point",
     "it stands behind one", "k=1 --radius 0.1 + sphere + point 1,2,k -o a.toml"},
    {"curve x=s --color z -o a.toml", "--color: unknown colour 'z'", "CSS colour name",
     "curve x=s --color tomato -o a.toml"},
    {"curve x=s --radius 0 -o a.toml", "--radius: must be more than 0", "", ""},
    {"point -o a.toml", "the point has no place", "point 1,2,3", "point 1,2,3 -o a.toml"},
    {"point 4,5 -o a.toml", "point: a place in space has three numbers, this one has 2",
     "for example point 1,2,3", "point 1,2,3 -o a.toml"},
    {"point x=1 -o a.toml", "x: the place of a point is one word", "point 1,2,3",
     "point 1,2,3 -o a.toml"},
    {"point u=0:1 v=2 -o a.toml", "u: a point has no ranges", "for example point u=1 v=2",
     "torus + point u=1 v=2 -o a.toml"},
    {"point 0/0,1,1 -o a.toml", "point 1: at: not a finite number", "it is undefined", ""},
    {"torus + curve u=s v=0 s=0:0 -o a.ply", "s: the range of s is empty", "s=0:2*pi",
     "torus + curve u=s v=0 s=0:2*pi -o a.ply"},
    {"point 1,2,3 4,5,6 -o a.toml", "'4,5,6' is no part of a point", "point u=1 v=2", ""},
};

TEST_F(Messages, OfTooManyObjectsAreThoseOfSceneFiles) {
  std::vector<std::string> many{"-o", "a.toml", "z=u"};
  for (int i = 0; i < 2000; ++i) many.insert(many.end(), {"+", "z=u"});
  const Outcome objects = saddle(many);
  EXPECT_TRUE(error_of(objects, 2).starts_with("saddle: 2001 surfaces are too many\n"))
      << objects.err;
  std::vector<std::string> longest{"-o", "a.toml", "z=u"};
  for (int i = 0; i < 40; ++i) {
    longest.insert(longest.end(),
                   {"+", "z=" + std::to_string(i) + "*sum(sin(n*u)*cos(n*v),n=1:9000)"});
  }
  const Outcome formulas = saddle(longest);
  EXPECT_TRUE(contains(error_of(formulas, 2), "the formulas of the scene are too long together"))
      << formulas.err;
}

TEST_F(Messages, OfObjectsNameAWayOutThatWorks) {
  expect_errors(kRows, 2);
}

}  // namespace
}  // namespace saddle
