// The rows of the table of options and scene keys, in the order in which scene files have their
// keys; those of a section of --help stand together.
#include <array>

#include "scene/options.h"

namespace saddle {
namespace {

constexpr int kMaxThreads = 1024;

Animation& animation(Scene& scene) {
  return scene.animation ? *scene.animation : scene.animation.emplace();
}

constexpr auto kRows = std::to_array<Option>({
    // --- output ---------------------------------------------------------------------------------
    {.name = "output",
     .letter = 'o',
     .value = "FILE",
     .section = Section::Output,
     .help = "what to write, by its extension; may be repeated; none: a window opens",
     .more = "Formats: {formats}.\nframe-%04d.png writes a file for each frame.\n- is standard "
             "output, with --format.",
     .commands = kGraphChart,
     .run = [](RunSettings& r) -> kinds::Slot { return kinds::Texts{&r.outputs}; }},
    {.name = "format",
     .value = "EXT",
     .section = Section::Output,
     .help = "{formats}: for -o - and names without an extension",
     .commands = kGraphChart,
     .needs = "output",
     .run = [](RunSettings& r) -> kinds::Slot { return kinds::Text{&r.format}; }},
    {.name = "reference",
     .value = "FILE",
     .section = Section::Output,
     .help = "compare the picture with a PNG; exit 1 and write FILE.diff.png if it differs",
     .commands = kGraph,
     .run = [](RunSettings& r) -> kinds::Slot { return kinds::Text{&r.reference}; }},
    {.name = "threshold",
     .value = "E",
     .section = Section::Output,
     .help = "largest difference from the reference that passes: 1 - SSIM, {limits}",
     .commands = kGraph,
     .needs = "reference",
     .run = [](RunSettings& r) -> kinds::Slot {
       return kinds::Plain{&r.threshold, kShare};
     }},
    {.name = "report",
     .value = "FILE",
     .section = Section::Output,
     .help = "the run's report as JSON; - is standard output",
     .commands = kGraphCheck,
     .run = [](RunSettings& r) -> kinds::Slot { return kinds::Text{&r.report}; }},
    {.name = "strict",
     .section = Section::Output,
     .help = "warnings are failures: exit 2, and no output but the report",
     .commands = kGraphCheck,
     .run = [](RunSettings& r) -> kinds::Slot { return kinds::Flag{&r.strict}; }},

    // --- camera ---------------------------------------------------------------------------------
    {.name = "view",
     .value = "X,Y,Z",
     .section = Section::Camera,
     .help = "direction from the target toward the eye",
     .table = Table::Camera,
     .scene = [](Scene& s) -> kinds::Slot {
       return kinds::Point{&s.camera.view, true};
     }},
    {.name = "up",
     .value = "X,Y,Z",
     .section = Section::Camera,
     .help = "direction that points up",
     .table = Table::Camera,
     .scene = [](Scene& s) -> kinds::Slot {
       return kinds::Point{&s.camera.up, true};
     }},
    {.name = "target",
     .value = "X,Y,Z",
     .section = Section::Camera,
     .help = "point in the middle of the picture",
     .usual = "centre of the bounding box",
     .table = Table::Camera,
     .scene = [](Scene& s) -> kinds::Slot {
       return kinds::Maybe<kinds::Point, Vector>{&s.camera.target, {}};
     }},
    {.name = "distance",
     .value = "D",
     .section = Section::Camera,
     .help = "from the target to the eye",
     .usual = "the bounding sphere just fits",
     .table = Table::Camera,
     .scene = [](Scene& s) -> kinds::Slot {
       return kinds::Maybe<kinds::Real, Number>{&s.camera.distance, {nullptr, kPositive}};
     }},
    {.name = "fov",
     .value = "DEG",
     .section = Section::Camera,
     .help = "vertical field of view in degrees, {limits}",
     .table = Table::Camera,
     .scene = [](Scene& s) -> kinds::Slot {
       return kinds::Real{&s.camera.fov, kFieldOfView};
     }},
    {.name = "ortho",
     .section = Section::Camera,
     .help = "orthographic, with the height that is seen at the target",
     .table = Table::Camera,
     .scene = [](Scene& s) -> kinds::Slot { return kinds::Flag{&s.camera.ortho}; }},

    // --- look -----------------------------------------------------------------------------------
    {.name = "title",
     .value = "TEXT",
     .help = "name of the scene: of the window, and above axes",
     .commands = kKeyOnly,
     .table = Table::Scene,
     .scene = [](Scene& s) -> kinds::Slot { return kinds::Text{&s.title}; }},
    {.name = "background",
     .value = "COLOR",
     .section = Section::Look,
     .help = "#rrggbb, #rrggbbaa, a CSS colour name or transparent",
     .usual = "black",
     .commands = kGraphCheck,
     .table = Table::Scene,
     .scene = [](Scene& s) -> kinds::Slot { return kinds::Paint{&s.background}; }},
    {.name = "axes",
     .section = Section::Look,
     .help = "a box with ticks, labels and the title",
     .commands = kGraphCheck,
     .table = Table::Scene,
     .scene = [](Scene& s) -> kinds::Slot { return kinds::Flag{&s.axes}; }},
    {.name = "size",
     .letter = 's',
     .value = "WxH",
     .section = Section::Look,
     .help = "picture size in pixels, up to 16384 each way",
     .table = Table::Scene,
     .scene = [](Scene& s) -> kinds::Slot { return kinds::PictureSize{&s.picture}; }},
    {.name = "antialias",
     .value = "N",
     .section = Section::Look,
     .help = "samples per pixel and side, {limits}; 1 is off",
     .table = Table::Scene,
     .scene = [](Scene& s) -> kinds::Slot {
       return kinds::Whole{&s.picture.antialias, 1, kMaxAntialias};
     }},
    {.name = "shading",
     .value = "HOW",
     .section = Section::Look,
     .help = "vertex, pixel, or exact: with the formula's normal at each pixel",
     .more = "vertex: lit at the mesh's vertices, colours interpolated.\npixel: lit at each pixel, "
             "normals interpolated.\nexact: lit at each pixel, with the normal of the formula.",
     .commands = kGraphCheck,
     .table = Table::Scene,
     .scene = [](Scene& s) -> kinds::Slot {
       return kinds::choice<Shading>(
           &s.picture.shading,
           {{"vertex", Shading::Vertex}, {"pixel", Shading::Pixel}, {"exact", Shading::Exact}});
     }},
    {.name = "specular",
     .value = "HOW",
     .section = Section::Look,
     .help = "highlights by the reflection vector, phong, or the half vector, blinn",
     .commands = kGraphCheck,
     .table = Table::Scene,
     .scene = [](Scene& s) -> kinds::Slot {
       return kinds::choice<Specular>(&s.picture.specular,
                                      {{"phong", Specular::Phong}, {"blinn", Specular::Blinn}});
     }},
    {.name = "name",
     .value = "TEXT",
     .help = "name of the surface in reports",
     .commands = kKeyOnly,
     .table = Table::Surface,
     .surface = [](SurfaceSpec& s) -> kinds::Slot {
       return kinds::Text{&s.name, "a name"};
     }},
    {.name = "x",
     .value = "FORMULA",
     .help = "of u and v",
     .commands = kKeyOnly,
     .table = Table::Surface,
     .surface = [](SurfaceSpec& s) -> kinds::Slot { return kinds::Formula{&s.x}; }},
    {.name = "y",
     .value = "FORMULA",
     .help = "of u and v",
     .commands = kKeyOnly,
     .table = Table::Surface,
     .surface = [](SurfaceSpec& s) -> kinds::Slot { return kinds::Formula{&s.y}; }},
    {.name = "z",
     .value = "FORMULA",
     .help = "of u and v; has no default",
     .commands = kKeyOnly,
     .table = Table::Surface,
     .surface = [](SurfaceSpec& s) -> kinds::Slot { return kinds::Formula{&s.z}; }},
    {.name = "u",
     .value = "[MIN, MAX]",
     .help = "range of u",
     .commands = kKeyOnly,
     .table = Table::Surface,
     .surface = [](SurfaceSpec& s) -> kinds::Slot { return kinds::Ends{&s.u}; }},
    {.name = "v",
     .value = "[MIN, MAX]",
     .help = "range of v; its ends may depend on u",
     .commands = kKeyOnly,
     .table = Table::Surface,
     .surface = [](SurfaceSpec& s) -> kinds::Slot { return kinds::Ends{&s.v}; }},
    {.name = "color",
     .value = "EXPR",
     .section = Section::Look,
     .help = "colour by an expression of u, v, x, y, z, gauss or mean (curvature), with a bar",
     .usual = "off",
     .commands = kGraphCheck,
     .table = Table::Surface,
     .surface = [](SurfaceSpec& s) -> kinds::Slot { return kinds::Formula{&s.color}; }},
    {.name = "colormap",
     .value = "NAME",
     .section = Section::Look,
     .help = "colours of --color: {choices}",
     .usual = "viridis",
     .commands = kGraphCheck,
     .table = Table::Surface,
     .surface = [](SurfaceSpec& s) -> kinds::Slot { return kinds::ColormapName{&s}; }},
    {.name = "grid",
     .value = "MxN",
     .section = Section::Look,
     .help = "M lines of constant u and N of constant v, or off",
     .commands = kGraphCheck,
     .table = Table::Surface,
     .surface = [](SurfaceSpec& s) -> kinds::Slot { return kinds::GridLines{&s}; }},
    {.name = "front",
     .value = "COLOR",
     .section = Section::Look,
     .help = "diffuse colour of the front, where r_u x r_v points",
     .commands = kGraphCheck,
     .table = Table::Surface,
     .surface = [](SurfaceSpec& s) -> kinds::Slot {
       return kinds::Side{&s.front, &kFrontMaterial};
     }},
    {.name = "back",
     .value = "COLOR",
     .section = Section::Look,
     .help = "diffuse colour of the back",
     .commands = kGraphCheck,
     .table = Table::Surface,
     .surface = [](SurfaceSpec& s) -> kinds::Slot {
       return kinds::Side{&s.back, &kBackMaterial};
     }},
    {.name = "flip",
     .section = Section::Look,
     .help = "swap front and back",
     .table = Table::Surface,
     .surface = [](SurfaceSpec& s) -> kinds::Slot {
       return kinds::Flag{&s.flip, true};
     }},
    {.name = "opacity",
     .value = "A",
     .section = Section::Look,
     .help = "{limits}; below 1 surfaces are see-through, their lines are not",
     .commands = kGraphCheck,
     .table = Table::Surface,
     .surface = [](SurfaceSpec& s) -> kinds::Slot {
       return kinds::Real{&s.opacity, kShare};
     }},
    {.name = "in",
     .value = "NODES",
     .help = "the node that moves it, or several: the same mesh drawn once for each",
     .commands = kKeyOnly,
     .table = Table::Surface,
     .surface = [](SurfaceSpec& s) -> kinds::Slot { return kinds::Names{&s.in}; }},

    // --- mesh -----------------------------------------------------------------------------------
    {.name = "tolerance",
     .value = "T",
     .section = Section::Mesh,
     .help = "largest distance from mesh to surface: 0.5px, or 1e-3 of the box's diagonal",
     .usual = "0.5px for pictures, 1e-3 for meshes",
     .more = "The box is the bounding box of what is drawn. A run that writes a picture and a mesh "
             "keeps the\nstricter of both defaults.",
     .commands = kGraphCheck,
     .table = Table::Scene,
     .scene = [](Scene& s) -> kinds::Slot { return kinds::Length{&s.mesh.tolerance}; }},
    {.name = "normal-tolerance",
     .value = "DEG",
     .section = Section::Mesh,
     .help = "largest angle from interpolated to true normal in degrees, {limits}",
     .table = Table::Scene,
     .scene = [](Scene& s) -> kinds::Slot {
       return kinds::Plain{&s.mesh.normal_tolerance, kHalfTurn};
     }},
    {.name = "max-triangles",
     .value = "N",
     .section = Section::Mesh,
     .help = "stop refining there and say so",
     .usual = "4000000; without --tolerance one per pixel, 1000000 at least",
     .table = Table::Scene,
     .scene = [](Scene& s) -> kinds::Slot {
       return kinds::Maybe<kinds::Whole, int>{&s.mesh.max_triangles, {nullptr, 2, kMaxTriangles}};
     }},
    {.name = "samples",
     .value = "MxN",
     .section = Section::Mesh,
     .help = "a uniform grid of M cells in u by N cells in v instead",
     .usual = "off",
     .commands = kGraphCheck,
     .table = Table::Scene,
     .scene = [](Scene& s) -> kinds::Slot { return kinds::Cells{&s.mesh.samples}; }},
    {.name = "clip",
     .value = "BOX",
     .section = Section::Mesh,
     .help = "X0:X1,Y0:Y1,Z0:Z1, off, or auto",
     .usual = "auto",
     .more = "auto: a surface that goes to infinity is clipped to the box that most of it is in.",
     .table = Table::Scene,
     .scene = [](Scene& s) -> kinds::Slot { return kinds::ClipBox{&s.clip}; }},

    // --- time -----------------------------------------------------------------------------------
    {.name = "t",
     .value = "T",
     .section = Section::Time,
     .help = "the moment, the value of t in formulas",
     .usual = "the start of the range of time, or 0",
     .table = Table::Scene,
     .scene = [](Scene& s) -> kinds::Slot { return kinds::Moment{&s}; }},
    {.name = "t",
     .value = "[FROM, TO]",
     .help = "range of time",
     .commands = kKeyOnly,
     .table = Table::Animation,
     .subject = "animation: t",
     .scene = [](Scene& s) -> kinds::Slot { return kinds::Times{&s}; }},
    {.name = "fps",
     .value = "F",
     .section = Section::Time,
     .help = "frames per second, {limits}",
     .commands = kGraph,
     .table = Table::Animation,
     .scene = [](Scene& s) -> kinds::Slot {
       return kinds::Real{&animation(s).fps, kFramesPerSecond};
     }},
    {.name = "frames",
     .value = "N",
     .section = Section::Time,
     .help = "of the animation; frame k of 0 to N-1 is at MIN+(MAX-MIN)*k/N of t=MIN:MAX",
     .commands = kGraph,
     .table = Table::Animation,
     .scene = [](Scene& s) -> kinds::Slot {
       return kinds::Whole{&animation(s).frames, 1, kMaxFrames};
     }},
    {.name = "frame-range",
     .value = "A:B",
     .section = Section::Time,
     .help = "draw frames A to B alone, both included",
     .usual = "all",
     .commands = kGraph,
     .run = [](RunSettings& r) -> kinds::Slot { return kinds::Frames{&r.frame_range}; }},

    // --- the run --------------------------------------------------------------------------------
    {.name = "watch",
     .help = "in the viewer: redraw when the scene file changes",
     .commands = kGraph,
     .run = [](RunSettings& r) -> kinds::Slot { return kinds::Flag{&r.watch}; }},
    {.name = "renderer",
     .value = "NAME",
     .help = "how OpenGL starts without a window: {choices}",
     .usual = "the first that starts",
     .run = [](RunSettings& r) -> kinds::Slot {
       return kinds::choice<Backend>(&r.renderer,
                                     {{"osmesa", Backend::Osmesa}, {"egl", Backend::Egl}});
     }},
    {.name = "threads",
     .value = "N",
     .help = "worker threads, {limits}",
     .usual = "all",
     .run = [](RunSettings& r) -> kinds::Slot {
       return kinds::Whole{&r.threads, 1, kMaxThreads};
     }},
    {.name = "quiet",
     .letter = 'q',
     .help = "no warnings",
     .run = [](RunSettings& r) -> kinds::Slot { return kinds::Flag{&r.quiet}; }},
    {.name = "verbose",
     .letter = 'v',
     .help = "say what was done and how long it took; describe each surface of the list",
     .commands = kGraphCheck | bit(Command::List),
     .excludes = "quiet",
     .run = [](RunSettings& r) -> kinds::Slot { return kinds::Flag{&r.verbose}; }},
    {.name = "help",
     .letter = 'h',
     .help = "this text; --help WORD: an option's name, functions, scene, status or keys",
     .commands = kAllCommands,
     .run = [](RunSettings& r) -> kinds::Slot { return kinds::Flag{&r.help}; }},
    {.name = "version",
     .help = "the version",
     .commands = kAllCommands,
     .run = [](RunSettings& r) -> kinds::Slot { return kinds::Flag{&r.version}; }},
});

}  // namespace

std::span<const Option> options() {
  return kRows;
}

}  // namespace saddle
