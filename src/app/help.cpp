// The text of --help. Every option of app/cli.cpp has its line here, with unit and default.
#include "app/help.h"

namespace saddle {

namespace {

constexpr const char* kHelp =
    R"(saddle graphs parametric surfaces from formulas: x(u,v), y(u,v), z(u,v).

  saddle NAME=EXPRESSION... [options]                  graph formulas
  saddle SCENE.toml [NAME=EXPRESSION...] [options]     graph a scene file, or a picture's scene
  saddle GALLERY-NAME [NAME=EXPRESSION...] [options]   graph a built-in surface
  saddle check FORMULAS or GALLERY-NAME [options]      what is true of the surface, no picture
  saddle chart ...same arguments... -o FILE            speed against accuracy of the methods, for
                                                       this surface: .svg .png .csv
  saddle list [-v]                                     names of the built-in surfaces, described
  saddle show GALLERY-NAME [NAME=EXPRESSION...]        print one as a scene file

Assignments: x=, y= (default u and v) and z= are the surface; u=MIN:MAX and v=MIN:MAX its ranges
(default -1:1; the ends of v may depend on u); t=VALUE the moment, t=MIN:MAX the range of time of an
animation; NAME= a parameter; NAME(ARGUMENTS)= a helper function.

Examples:
  saddle z='sin(u)*cos(v)' u=-3:3 v=-3:3 -o waves.png
  saddle torus r=0.4 -o torus.ply -o torus.png
  saddle x='(2+cos(v))*cos(u)' y='(2+cos(v))*sin(u)' z='sin(v)' u=0:tau v=0:tau -o ring.png
  saddle z='sin(3*u+t)*cos(v)' t=0:tau -o waves.gif

Output (none: a window opens)
  -o, --output FILE     what to write, by extension: .png .ply, .toml (the scene), .gif .mp4 .webm
                        (all frames); frame-%04d.png, also .ply, is a file for each frame; may be
                        repeated; - is standard output, with --format
      --format EXT      png, ply, toml, gif, mp4 or webm: for - and names without an extension
  -s, --size WxH        picture size in pixels, up to 16384 each way (default 800x600)
      --reference FILE  compare the picture with a PNG; exit 1 and write FILE.diff.png if it differs
      --threshold E     largest error that passes: 1 - SSIM, 0 to 1 (default 0.04)
      --report FILE     the run's report as JSON; - is standard output
      --strict          warnings are failures: exit 2, and no output but the report
Camera
      --view X,Y,Z      direction from the target toward the eye (default 2,-3,1.5)
      --up X,Y,Z        direction that points up (default 0,0,1)
      --target X,Y,Z    point in the middle of the picture (default: centre of the bounding box)
      --distance D      of eye and target (default: the bounding sphere just fits)
      --fov DEG         vertical field of view, degrees, more than 0 and less than 180 (default 30)
      --ortho           orthographic, with the height that is seen at the target (default: off)
Look
      --background COLOR, --front COLOR, --back COLOR   (default black, #ffff80, #8080ff)
                        #rrggbb, #rrggbbaa, a CSS colour name or transparent
      --axes            a box with ticks, labels and the title (default: off)
      --color EXPR      by a number of u, v, x, y, z or curvature (gauss, mean), with a bar (off)
      --colormap NAME   viridis plasma inferno magma cividis turbo coolwarm gray (default viridis)
      --flip            swap front and back (the front is where r_u x r_v points)
      --opacity A       0 to 1; below 1 surfaces are see-through, their lines are not (default 1)
      --grid MxN        lines of constant u and of constant v, or off (default 16x16)
      --shading HOW     vertex (colours at corners, blended), pixel (normals, blended) or exact (the
                        normal of the formula at each pixel) (default pixel)
      --specular HOW    highlights: phong or blinn (default phong)
      --antialias N     samples per pixel and side, 1 to 16; 1 is off (default 2)
Mesh
      --tolerance T     largest distance of mesh and surface: 0.5px, or 1e-3 of the diagonal of the
                        bounding box (default: 0.5px for pictures, 1e-3 for meshes; the stricter)
      --normal-tolerance DEG  largest angle of interpolated and true normal, 0 to 180 (default 3)
      --max-triangles N stop refining there and say so (default 4000000; 1000000 if no --tolerance)
      --clip BOX        X0:X1,Y0:Y1,Z0:Z1, off, or auto: where the surface goes to infinity, the
                        box that most of it is in (default auto)
      --samples MxN     a uniform grid of M cells in u by N in v instead (default: off)
Time
      --t T             the moment, the value of t in formulas (default: the start of the range of
                        time, 0 without one)
      --frames N        of the animation; frame k of 0 to N-1 is at MIN+(MAX-MIN)*k/N (default 120;
                        t=MIN:MAX is 0:1 unless given)
      --fps F           frames per second, between 0.01 and 1000 (default 30)
      --frame-range A:B draw frames A to B alone, both included (default: all)
Computing
      --watch           in the viewer: redraw when the scene file changes
      --renderer NAME   osmesa or egl (default: the first that starts)
      --threads N       worker threads, 1 to 1024 (default: all)
  -q, --quiet           no warnings        -v, --verbose   say what was done and how long it took
  -h, --help            this text; --help functions lists the formula language,
                        --help keys the keys of the viewer
      --version         the version
)";

}  // namespace

std::string help_text() {
  return kHelp;
}

std::string version() {
  return SADDLE_VERSION;
}

std::string version_text() {
  return "saddle " + version() + "\n";
}

}  // namespace saddle
