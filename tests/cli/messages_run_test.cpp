// Messages of runs that end with the exit statuses 1 and 3: what the machine lacks, and formulas
// without anything to draw.
#include <fcntl.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <utility>

#include "base/run_limits.h"
#include "cli/messages.h"

namespace saddle {
namespace {

constexpr MessageRow kNothing[] = {
    {"z=0/0 -o a.ply", "the surface is undefined everywhere", "samples has finite x, y and z", ""},
    {"z=0/0 -o a.png", "the surface is undefined everywhere", "samples has finite x, y and z", ""},
    {"check z=0/0", "the surface is undefined everywhere", "samples has finite x, y and z", ""},
    {"z=if(u==0.5,1,0/0) u=0:1 -o a.ply", "the surface is defined at isolated samples only",
     "--samples takes more", ""},
    {"z=sqrt(0.01-(u-0.1)^2-(v-0.1)^2) --samples 3x3 -o a.ply",
     "the surface is defined only between the samples", "--samples takes more, and without it",
     "z=sqrt(0.01-(u-0.1)^2-(v-0.1)^2) -o a.ply"},
    {"x=u y=u z=0 -o a.ply", "the surface is a straight line",
     "the derivatives of x, y and z by v are 0 everywhere", "x=u y=v z=0 -o a.ply"},
    {"x=u y=u^2 z=0 -o a.ply", "the surface is a curve",
     "the derivatives of x, y and z by v are 0 everywhere", "x=u y=u^2 z=v -o a.ply"},
    {"x=1 y=1 z=1 -o a.ply", "the surface is a single point, (1, 1, 1)",
     "x, y and z are the same at all samples", "x=u y=v z=1 -o a.ply"},
    {"x=1e20*u y=v z=0 -o a.ply", "the surface is 1e+20 times as long along x as it is wide",
     "scale x down", "x=u y=v z=0 -o a.ply"},
    {"z=u*v u=0:1e-320 -o a.ply", "the surface is countless times as long along y as it is wide",
     "scale y down", "z=u*v u=0:1 -o a.ply"},
    {"z=u u=1e16:1e16+8 -o a.ply", "the range of u is too short for double precision",
     "u = 0 is where they are closest", "z=u u=0:8 -o a.ply"},
    {"x=1e308*u y=1e308*v z=u*v -o a.ply", "the surface has no finite extent",
     "(-1e+308, -1e+308, -1)", "x=1e30*u y=1e30*v z=1e30*u*v -o a.ply"},
    {"z=1e308*u -o a.ply", "the surface has no finite extent", "(-1, -1, -1e+308)",
     "z=1e3*u -o a.ply"},
    {"show --shader curve x=s", "no surface is drawn", "lines and dots have fixed shaders",
     "show --shader curve x=s --radius 0.1"},
    {"show --shader point 1,2,3", "no surface is drawn", "lines and dots have fixed shaders",
     "show --shader point 1,2,3 --radius 0.1"},
    {"torus --clip 5:6,5:6,5:6 -o a.ply",
     "nothing of the surface is in the box that it is clipped to", "--clip off shows all of it",
     "torus --clip off -o a.ply"},
    {"z=u where=u>7 -o a.ply", "where: no part of the surface is where this holds",
     "leave it out, or widen the ranges", "z=u where=u>7 u=0:9 -o a.ply"},
    {"curve x=s -o a.ply", ".ply has no lines and dots, and there is nothing else",
     "--radius makes a tube of a curve", "curve x=s --radius 0.1 -o a.ply"},
    {"point 1,2,3 -o a.ply", ".ply has no lines and dots, and there is nothing else",
     "a ball of a point", "point 1,2,3 --radius 0.1 -o a.ply"},
    {"curve x=sqrt(-1-s^2) -o a.png", "there is nothing to draw of 'curve'",
     "in all of its range of s", "curve x=sqrt(1+s^2) -s 9x9 -o a.png"},
    {"z=sqrt(u) + point u=-1 v=0 -o a.png", "the point 'point' is undefined",
     "x, y and z must be finite numbers", ""},
    {"z=sqrt(u) + point u=-1 v=0 --radius 0.1 -o a.ply", "the point 'point' is undefined",
     "x, y and z must be finite numbers", "z=sqrt(u) + point u=1 v=0 --radius 0.1 -o a.ply"},
};

TEST_F(Messages, OfNothingToDrawSayWhy) {
  expect_errors(kNothing, 3);
}

constexpr MessageRow kMachine[] = {
    // files
    {"torus -o none/a.png", "cannot write none/a.png: No such file or directory",
     "create its folder: mkdir -p none", ""},
    {"torus --report none/a.json -o a.toml", "cannot write none/a.json: No such file or directory",
     "create its folder: mkdir -p none", ""},
    {"chart torus -o none/a.svg", "cannot write none/a.svg: No such file or directory",
     "create its folder: mkdir -p none", ""},
    {"torus -o folder.png", "cannot write folder.png: Is a directory", "", ""},
    {"torus -s 9x9 -o /dev/full --format png", "cannot write /dev/full: No space left on device",
     "", ""},
    {"folder.png -o a.toml", "cannot read folder.png: Is a directory", "", ""},
    // comparison
    {"torus -s 64x48 --reference sphere.png",
     "the picture differs from sphere.png: the difference is ",
     "sphere.png.diff.png shows in red where", "sphere -s 64x48 --reference sphere.png"},
    {"sphere -s 32x48 --reference sphere.png",
     "the picture differs from sphere.png: it has 32x48 pixels, not 64x48", "shows in red where",
     ""},
    // the window
    {"torus", "no window can be opened: ", "saddle ... -o FILE.png draws without a display",
     "torus -s 9x9 -o a.png"},
    // OpenGL
    {"torus --renderer osmesa -s 9x9 -o a.png",
     "GALLIUM_DRIVER names a driver that OSMesa lacks: foo", "unset it, or set it to llvmpipe",
     "torus --renderer osmesa -s 9x9 -o a.png", "GALLIUM_DRIVER=foo"},
    {"torus --renderer osmesa -s 9x9 -o a.png", "OSMesa cannot make an OpenGL 3.3 core context",
     "unset GALLIUM_DRIVER and MESA_*", "", "MESA_GL_VERSION_OVERRIDE=2.1"},
    // ffmpeg
    {"z=u*t --frames 2 -s 16x16 -o a.mp4", "cannot run ffmpeg: No such file or directory",
     "install the package ffmpeg", "", "PATH=/nowhere"},
    {"z=u*t --frames 2 -s 16x16 -o a.mp4", "no temporary file /nowhere/saddle-",
     "set TMPDIR to a folder that can be written to", "", "TMPDIR=/nowhere"},
};

constexpr MessageRow kLimits[] = {
    {"chart torus --max-time 0.01 -o a.csv", "--max-time is over, and nothing is whole yet",
     "a larger --max-time allows more; a larger --tolerance or a smaller --size takes less", ""},
    {"torus --max-memory 64MB -s 99x99 -o a.png", "nothing here can draw: not enough memory",
     "--max-memory and ulimit -v say how much there may be", "torus -s 99x99 -o a.png"},
    {"z=u*t --frames 2 -s 16x16 -o a.mp4", "ffmpeg failed: it has written nothing", "", "",
     "PATH=bin"},
};

TEST_F(Messages, OfLimitsNameTheOneThatIsMet) {
  if (!system_refuses_memory()) GTEST_SKIP() << "a sanitizer takes more addresses than that";
  std::filesystem::create_directory(path("bin"));
  std::ofstream(path("bin/ffmpeg")) << "#!/bin/sh\nexec 0<&-\n/bin/sleep 1\n";
  std::filesystem::permissions(path("bin/ffmpeg"), std::filesystem::perms::owner_all);
  expect_errors(kLimits, 1);
}

/// Standard output on the other end of a terminal.
TEST_F(Messages, OfTerminalsKeepPicturesOffThem) {
  const int terminal = posix_openpt(O_RDWR | O_NOCTTY);
  ASSERT_GE(terminal, 0);
  ASSERT_EQ(grantpt(terminal), 0);
  ASSERT_EQ(unlockpt(terminal), 0);
  const std::string name = ptsname(terminal);
  for (const auto& [command, message] :
       {std::pair("torus -o - --format png", "pictures and meshes are not written to a terminal"),
        std::pair("chart torus -o - --format png", "pictures are not written to a terminal")}) {
    const Outcome run = run_saddle(words(command), folder_, name);
    EXPECT_EQ(run.status, 2) << run.err;
    EXPECT_TRUE(contains(run.err, message)) << run.err;
    EXPECT_TRUE(contains(run.err, "redirect standard output, or name a file")) << run.err;
  }
  close(terminal);
}

TEST_F(Messages, OfTheMachineSayWhatItLacks) {
  std::filesystem::create_directory(path("folder.png"));
  ASSERT_EQ(run("sphere -s 64x48 -o sphere.png").status, 0);
  expect_errors(kMachine, 1);
}

constexpr MessageRow kViewer[] = {
    {"torus --strict", "--strict: the viewer shows warnings and goes on",
     "it is for outputs, -o FILE.png, and for saddle check", "check torus --strict"},
    {"torus --renderer egl", "--renderer: the viewer draws with the OpenGL of its display",
     "it is for outputs: -o FILE.png", ""},
    {"z=u*t --frame-range 0:1", "--frame-range: the viewer plays all frames", "-o frame-%04d.png",
     "z=u*t --frame-range 0:1 -s 9x9 -o frame-%04d.png"},
    {"torus --watch", "--watch: there is no scene file to watch", "-o FILE.toml writes one",
     "torus -o a.toml"},
};

TEST_F(Messages, OfTheViewerComeBeforeItsWindow) {
  expect_errors(kViewer, 2);
}

constexpr MessageRow kStrict[] = {
    {"mobius --strict -o a.ply", "warning: mobius: the surface is one-sided",
     "--strict: a warning\nthe first: mobius: the surface is one-sided", "mobius -o a.ply"},
    {"z=1/u + mobius --strict -o a.ply", "warning: surface: the surface goes to infinity",
     "--strict: 3 warnings\nthe first: surface: the surface goes to infinity", ""},
};

TEST_F(Messages, OfStrictRunsCountTheWarnings) {
  expect_errors(kStrict, 2);
}

}  // namespace
}  // namespace saddle
