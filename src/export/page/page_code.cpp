#include "export/page/page_code.h"

#include <algorithm>

#include "export/page/page_shaders.h"
#include "formula/js.h"
#include "scene/model/instances.h"
#include "scene/model/prepare.h"
#include "scene/model/texture.h"
#include "scene/model/theme.h"
#include "scene/model/values.h"
#include "surface/forms.h"

namespace saddle {
namespace {

using PageParts = std::vector<std::string>;

std::string list(const PageParts& parts) {
  std::string text = "[";
  for (const std::string& part : parts) text += (text.size() > 1 ? "," : "") + part;
  return text + "]";
}

std::string vector_code(const dvec3& v) {
  return list(PageParts{js_number(v.x), js_number(v.y), js_number(v.z)});
}

std::string truth(bool value) {
  return value ? "true" : "false";
}

/// The name of a variable in the page's functions.
std::string variable_name(Symbol symbol) {
  return parameter_of(symbol == kSymbolT ? 0 : symbol - kFirstKeptSymbol + 1);
}

/// Numbers that may be expressions: their code is `n[0]`, `n[1]` ..., of an array that is computed
/// first.
class NumberCode {
 public:
  /// The numbers are the scene's, or one of its surfaces', which may have definitions of its own.
  explicit NumberCode(const Scene& scene, const SurfaceSpec* own = nullptr)
      : scope_(graph_, constant_names(scene, own), constant_view(scene, own)) {}

  std::string of(const Number& number) {
    if (number.text.empty()) return js_number(number.value);
    roots_.push_back(scope_.parse("number", number.text));
    return "n[" + std::to_string(roots_.size() - 1) + "]";
  }
  std::string of(const Vector& v) { return list({of(v.x), of(v.y), of(v.z)}); }
  std::string of(const Color& c) { return list({of(c.r), of(c.g), of(c.b)}); }

  /// Statements that fill the array `n`.
  std::string statements() {
    const auto values = scope_.constants();
    const JsCode code = print_js(graph_, roots_, [&](Symbol symbol) {
      const auto known = values.find(symbol);
      const bool is_value = known != values.end() && symbol < kFirstKeptSymbol;
      return is_value ? js_number(known->second) : variable_name(symbol);
    });
    return code.once + "const n=" + list(code.outputs) + ";\n";
  }

 private:
  Graph graph_;
  Scope scope_;
  std::vector<NodeId> roots_;
};

/// -3: the eye's frame, -2: the world's, else a node.
int frame_number(const Scene& scene, const std::string& name) {
  if (name == "eye") return -3;
  const auto node = std::ranges::find(scene.nodes, name, &SceneNode::name);
  return node == scene.nodes.end() ? -2 : static_cast<int>(node - scene.nodes.begin());
}

std::string light_code(NumberCode& numbers, const Scene& scene, const Light& light) {
  const Attenuation& a = light.attenuation;
  const std::string attenuation =
      a.range ? vector_code(attenuation_of_range(*a.range))
              : list({numbers.of(a.constant), numbers.of(a.linear), numbers.of(a.quadratic)});
  std::string spot = "null";
  if (light.spot) {
    const Spot& s = *light.spot;
    spot = list({numbers.of(s.direction), numbers.of(s.cutoff),
                 numbers.of(s.inner.value_or(s.cutoff)), numbers.of(s.exponent)});
  }
  return "{frame:" + std::to_string(frame_number(scene, light.frame)) +
         ",directional:" + truth(light.directional) + ",position:" + numbers.of(light.position) +
         ",color:" + numbers.of(light.color) +
         ",highlight:" + numbers.of(light.specular.value_or(light.color)) +
         ",ambient:" + numbers.of(light.ambient) + ",attenuation:" + attenuation + ",spot:" + spot +
         ",enabled:" + numbers.of(light.enabled) + "}";
}

std::string node_code(NumberCode& numbers, const Scene& scene, const SceneNode& node) {
  PageParts steps;
  for (const Transform& step : node.transform) {
    const char* const kind = step.kind == Transform::Kind::Rotate  ? "'r'"
                             : step.kind == Transform::Kind::Scale ? "'s'"
                                                                   : "'t'";
    steps.push_back(list({kind, numbers.of(step.vector.x), numbers.of(step.vector.y),
                          numbers.of(step.vector.z), numbers.of(step.angle)}));
  }
  const int outer = node.in.empty() ? -1 : frame_number(scene, node.in);
  return "{in:" + std::to_string(outer) + ",steps:" + list(steps) + "}";
}

/// The numbers of the scene that are not its surfaces'.
std::string build_code(const PageScene& page) {
  const Scene& scene = page.scene;
  NumberCode numbers(scene);
  const Camera& camera = scene.camera;
  std::string code = "camera:{view:" + numbers.of(camera.view) + ",up:" + numbers.of(camera.up) +
                     ",fov:" + numbers.of(camera.fov) + ",zoom:" + numbers.of(camera.zoom) +
                     ",ortho:" + truth(camera.ortho) + ",turntable:" + truth(camera.turntable);
  if (camera.target) {
    const dvec3 scale(scene.scale.factors);
    const std::string target = numbers.of(*camera.target);
    code += ",target:" + target + ".map((x,k)=>x*" + vector_code(scale) + "[k])";
  }
  if (camera.distance) code += ",distance:" + numbers.of(*camera.distance);
  PageParts nodes;
  for (const SceneNode& node : scene.nodes) nodes.push_back(node_code(numbers, scene, node));
  PageParts lights;
  for (const Light& light : page_lights(scene)) lights.push_back(light_code(numbers, scene, light));
  code += "},nodes:" + list(nodes) + ",lights:" + list(lights);
  return "p=>{\n" + numbers.statements() + "return{" + code + "}}";
}

std::string material_code(NumberCode& numbers, const std::string& side, const Material& material) {
  return side + "_diffuse:" + numbers.of(material.diffuse) + "," + side +
         "_specular:" + numbers.of(material.specular) + "," + side +
         "_shininess:" + numbers.of(material.shininess) + "," + side +
         "_ambient:" + numbers.of(material.ambient.value_or(material.diffuse)) + "," + side +
         "_emission:" + numbers.of(material.emission);
}

/// The functions of a surface: its numbers, the ends of its ranges, and at (u, v) its position,
/// tangents, v, and the numbers of its colour and level lines.
std::string make_code(const Scene& scene, const SurfaceSpec& spec, NumberCode& numbers) {
  BoundSurface bound = bind_surface(scene, spec);
  std::vector<NodeId> outputs = tangent_outputs(tangents_of(bound.graph, bound.r));
  outputs.push_back(bound.v.value_or(bound.graph.variable(kSymbolV)));
  if (bound.color) outputs.push_back(*bound.color);
  outputs.insert(outputs.end(), bound.contours.begin(), bound.contours.end());
  const std::size_t count = outputs.size();
  outputs.insert(outputs.end(), bound.ends.begin(), bound.ends.end());
  const JsCode code = print_js(bound.graph, outputs, variable_name);
  std::string each = code.each;
  for (std::size_t i = 0; i < count; ++i) {
    each += "o[" + std::to_string(i) + "]=" + code.outputs[i] + ";";
  }
  const PageParts ends(code.outputs.begin() + static_cast<std::ptrdiff_t>(count),
                       code.outputs.end());
  const std::string once = code.once;
  return "p=>{\nconst n=(()=>{" + numbers.statements() + "return n})();\n" + once +
         "return{n,ends:" + list(ends) + ",at(u,v,o){" + each + "}}}";
}

std::string levels_code(const SurfaceSpec& spec) {
  PageParts all;
  for (const ContourSpec& contour : spec.contours) {
    PageParts levels;
    for (const Number& level : contour.levels) levels.push_back(js_number(level.value));
    all.push_back(list(levels));
  }
  return list(all);
}

std::string in_code(const Scene& scene, const SurfaceSpec& spec) {
  PageParts nodes;
  for (const std::string& name : spec.in) {
    nodes.push_back(std::to_string(frame_number(scene, name)));
  }
  return spec.in.empty() ? "[-1]" : list(nodes);
}

/// Where the surface's colours are on the scale that it shares.
std::string scale_code(const PageScene& page, const SurfaceSpec& spec, const Mesh& mesh) {
  const bool colored = !mesh.color.empty() && !spec.color.empty();
  if (!colored) return "colored:false,onScale:[1,0]";
  const ColorScale& scale = scale_of(spec, page.scales);
  const double first = place_on(scale, mesh.color_range.low);
  return "colored:true,scale:" + std::to_string(&scale - page.scales.data()) + ",onScale:" +
         list({js_number(place_on(scale, mesh.color_range.high) - first), js_number(first)}) +
         ",range:" + list({js_number(mesh.color_range.low), js_number(mesh.color_range.high)});
}

/// A surface's own texture: the number of its picture, or -1 for a chequerboard.
std::string texture_code(const PageScene& page, const SurfaceSpec& spec) {
  const Texture& texture = spec.texture;
  if (!texture) return "";
  const auto found = std::ranges::find(page.pictures, texture.picture.get(), &PagePicture::picture);
  const auto number = texture.picture ? found - page.pictures.begin() : -1;
  const char* const wrap = texture.wrap == Texture::Wrap::Repeat   ? "'REPEAT'"
                           : texture.wrap == Texture::Wrap::Mirror ? "'MIRRORED_REPEAT'"
                                                                   : "'CLAMP_TO_EDGE'";
  return ",texture:{picture:" + std::to_string(number) + ",wrap:" + wrap +
         ",smooth:" + truth(texture.filter == Texture::Filter::Smooth) +
         ",scale:" + vector_code(dvec3(texture_scale(spec), 1)) + ",dark:" + js_number(kDarkCell) +
         "}";
}

/// The scene whose formulas no slider moves: a page has no way to make solids.
Scene without_sliders(Scene scene) {
  scene.keeps_time = false;
  for (Definition& definition : scene.definitions) definition.kept.reset();
  return scene;
}

std::string surface_code(const PageScene& page, std::size_t index, std::size_t program) {
  const Mesh& mesh = page.meshes[index];
  const Scene scene = mesh.solid ? without_sliders(page.scene) : page.scene;
  const SurfaceSpec& spec = scene.surfaces[index];
  const PageMesh& packed = page.packed[index];
  NumberCode numbers(scene, spec.is_stroke() ? nullptr : &spec);
  std::string look = material_code(numbers, "front", spec.front) + "," +
                     material_code(numbers, "back", spec.back) +
                     ",opacity:" + numbers.of(spec.opacity) +
                     ",line_color:" + numbers.of(spec.line_color);
  if (!spec.contours.empty()) {
    look += ",levels:" + numbers.of(contour_color_of(spec, scene.theme)) +
            ",wider:" + js_number(kContourWidth);
  }
  if (spec.line_width) look += ",line_width:" + numbers.of(*spec.line_width);
  const std::size_t extra = 1 + (spec.color.empty() ? 0 : 1) + spec.contours.size();
  std::string code =
      "{name:" + js_string(spec.name) + ",make:" + make_code(scene, spec, numbers) +
      ",lookOf:n=>({" + look +
      "}),parameters:" + list({js_string(spec.parameters[0]), js_string(spec.parameters[1])}) +
      ",program:" + std::to_string(program) + ",extra:" + std::to_string(extra) +
      ",levels:" + levels_code(spec) + ",in:" + in_code(scene, spec) +
      ",stroke:" + truth(spec.is_stroke()) + ",dot:" + truth(spec.point.has_value()) +
      ",flip:" + truth(bind_surface(scene, spec).flip) + ",fixed:" + truth(packed.fixed) +
      ",unlit:" + truth(shading_of(scene, spec) == Shading::Unlit) +
      ",box:{low:" + vector_code(packed.box.low) + ",high:" + vector_code(packed.box.high) + "}," +
      scale_code(page, spec, mesh) + texture_code(page, spec);
  if (!spec.label.empty() && mesh.anchor) {
    code += ",label:" + js_string(spec.label) + ",anchor:" + vector_code(*mesh.anchor);
  }
  return code + "}";
}

std::string sliders_code(const PageScene& page, const std::string& code) {
  const Scene& scene = page.scene;
  const Animation film = scene.animation.value_or(Animation{});
  const auto row = [&](std::size_t index, const PageParameter& p) {
    const bool is_used = code.find(parameter_of(index)) != std::string::npos ||
                         (index == 0 && scene.camera.turntable && scene.animation);
    PageParts choices;
    for (const std::string& choice : p.choices) choices.push_back(js_string(choice));
    return list({js_string(p.name), js_number(p.value), js_number(p.min), js_number(p.max),
                 js_number(p.step), truth(!is_used), list(choices)});
  };
  PageParts rows = {row(0, {"t", scene.t, film.from, film.to, 0, {}})};
  for (std::size_t i = 0; i < page.parameters.size(); ++i) {
    rows.push_back(row(i + 1, page.parameters[i]));
  }
  return list(rows);
}

std::string scales_code(const std::vector<ColorScale>& scales) {
  PageParts all;
  for (const ColorScale& scale : scales) {
    const ColorRange& r = scale.range;
    all.push_back("{name:" + js_string(scale.formula) + ",range:" +
                  list({js_number(r.low), js_number(r.high), truth(r.below), truth(r.above)}) +
                  "}");
  }
  return list(all);
}

}  // namespace

std::string js_string(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      result += '\\';
      result += c;
    } else if (byte < 0x20 || c == '<' || c == '>' || byte == 0x7f) {
      constexpr std::string_view kDigits = "0123456789abcdef";
      result += "\\x";
      result += kDigits[byte / 16];
      result += kDigits[byte % 16];
    } else {
      result += c;
    }
  }
  return result + "\"";
}

std::string page_scene_code(const PageScene& page) {
  const Scene& scene = page.scene;
  const PageShaders shaders = page_shaders(page);
  std::string code = "build:" + build_code(page);
  PageParts surfaces;
  for (std::size_t i = 0; i < scene.surfaces.size(); ++i) {
    surfaces.push_back(surface_code(page, i, shaders.of_surface[i]));
  }
  code += ",\nsurfaces:" + list(surfaces);
  PageParts programs;
  for (const ShaderText& text : shaders.programs) {
    programs.push_back(list({js_string(text.vertex), js_string(text.fragment)}));
  }
  PageParts pictures;  // their bytes
  for (const PagePicture& picture : page.pictures) {
    pictures.push_back(std::to_string(picture.png.size()));
  }
  const bool is_titled =
      !scene.title.empty() && (scene.show_title || (scene.axes && scene.title != Scene{}.title));
  const Color& b = scene.background;
  code +=
      ",\nprograms:" + list(programs) + ",\nsliders:" + sliders_code(page, code) +
      ",scales:" + scales_code(page.scales) + ",title:" + js_string(scene.title) +
      ",titled:" + truth(is_titled) + ",axes:" + truth(scene.axes) + ",labels:" +
      list({js_string(scene.labels[0]), js_string(scene.labels[1]), js_string(scene.labels[2])}) +
      ",ink:" + vector_code(ink_of(scene)) + ",grey:" + truth(shaders.grey) +
      ",background:" + list({js_number(b.r), js_number(b.g), js_number(b.b), js_number(b.a)}) +
      ",root:" + vector_code(dvec3(scene.scale.factors)) + ",unit:" + js_number(page.unit) +
      ",centre:" + vector_code(page.centre) + ",target:" + vector_code(page.camera.target) +
      ",distance:" + js_number(page.camera.distance) + ",middle:" + js_number(page.camera.middle) +
      ",width:" + std::to_string(scene.picture.width) +
      ",height:" + std::to_string(scene.picture.height) + ",dot:" +
      js_number(line_width_of(
          [] {
            SurfaceSpec point;
            point.point = 0;
            return point;
          }(),
          {0, 0})) +
      ",plays:" + truth(scene.animation.has_value());
  if (!pictures.empty()) code += ",pictures:" + list(pictures);
  if (scene.animation) {
    code += ",time:" + list({js_number(scene.t), js_number(scene.animation->from),
                             js_number(scene.animation->to)});
  }
  if (scene.box)
    code += ",box:" + list({vector_code(scene.box->low), vector_code(scene.box->high)});
  return "const scene={" + code + "};\n";
}

}  // namespace saddle
