// The page holds its script and its meshes deflated. A short script unpacks the long one; both, and
// the style, are allowed by their hashes, and nothing else is.
#include "export/page/page.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <ostream>
#include <set>
#include <sstream>
#include <string_view>

#include "base/base64.h"
#include "base/deflate.h"
#include "base/error.h"
#include "base/image_png.h"
#include "base/nearest.h"
#include "base/sha256.h"
#include "export/common/markup.h"
#include "export/page/page_code.h"
#include "export/page/page_description.h"
#include "export/page/page_solids.h"
#include "export/page/page_sources.h"
#include "export/page/page_text.h"
#include "render/gl/gpu_mesh.h"
#include "render/picture/picture_in_tiles.h"
#include "scene/model/instances.h"
#include "scene/toml/scene_file.h"

namespace saddle {
namespace {

/// Corners are baked that formulas have elsewhere by this share of the mesh's tolerance.
constexpr double kBakedShare = 0.25;
constexpr double kScreenHeight = 1080;

constexpr std::string_view kSceneBegins = "<template class=\"saddle-scene\">";
constexpr std::string_view kSceneEnds = "</template>";

/// In the order in which they need each other.
constexpr std::array kScripts = {"vectors.js",  "payload.js", "mesh.js", "camera.js",
                                 "lights.js",   "gl.js",      "flat.js", "overlay.js",
                                 "controls.js", "main.js"};

/// JavaScript and CSS need no semicolon before a brace; no file of the page has one in quotes
/// there.
std::string short_source(std::string_view source) {
  std::string text = squeezed(without_comments(source));
  for (std::size_t at = 0; (at = text.find(";}", at)) != std::string::npos;) text.erase(at, 1);
  return text;
}

std::string source_of(const char* name) {
  return short_source(page_source(name));
}

/// The functions of functions.js that the code calls, and those that they call.
std::string functions_for(const std::string& code) {
  const std::string source(page_source("functions.js"));
  std::string all;
  std::set<std::string> known;
  bool has_grown = true;
  while (has_grown) {
    has_grown = false;
    constexpr std::string_view kBegins = "\nfunction ";
    for (std::size_t at = 0; (at = source.find(kBegins, at)) != std::string::npos; ++at) {
      const std::size_t begin = at + kBegins.size();
      const std::string name = source.substr(begin, source.find('(', begin) - begin);
      const bool is_called = (code + all).find(name + "(") != std::string::npos;
      if (!is_called || !known.insert(name).second) continue;
      all += source.substr(at, source.find("\n}\n", at) + 3 - at);  // its own brace is not indented
      has_grown = true;
    }
  }
  return short_source(all);
}

std::string hash_of(const std::string& text) {
  const auto hash = sha256(text);
  return "'sha256-" + base64_of({reinterpret_cast<const char*>(hash.data()), hash.size()}) + "'";
}

std::optional<double> number_in(const std::string& text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

/// Chooses the parameters that have sliders, and keeps them in the formulas.
class Sliders {
 public:
  Sliders(PageScene& page, const std::string& wanted) : page_(page) {
    std::istringstream words(wanted);
    for (std::string word; std::getline(words, word, ',');) wanted_.push_back(word);
    Scene& scene = page_.scene;
    const auto is_solid = [](const Mesh& mesh) { return mesh.solid.has_value(); };
    if (std::ranges::all_of(page_.meshes, is_solid)) hold(scene.definitions);
    keep(scene.definitions, scene.sliders, "");
    for (std::size_t i = 0; i < scene.surfaces.size(); ++i) {
      SurfaceSpec& spec = scene.surfaces[i];
      if (page_.meshes[i].solid) {
        hold(spec.definitions);
      } else {
        keep(spec.definitions, spec.sliders, " (" + spec.name + ")");
      }
    }
    check();
    if (is("off")) return;
    scene.keeps_time = is("all") || is_wanted("t");
  }

 private:
  bool is(const char* word) const { return wanted_.size() == 1 && wanted_[0] == word; }
  bool is_wanted(const std::string& name) const {
    return is("all") || std::ranges::find(wanted_, name) != wanted_.end();
  }

  void hold(const std::vector<Definition>& definitions) {
    for (const Definition& definition : definitions) still_.insert(definition.name);
  }

  void keep(std::vector<Definition>& definitions, const std::vector<Slider>& sliders,
            const std::string& owner) {
    for (Definition& definition : definitions) {
      const auto value = definition.is_function ? std::nullopt : number_in(definition.text);
      if (!value) continue;
      names_.push_back(definition.name);
      if (!is_wanted(definition.name)) continue;
      const auto slider = std::ranges::find(sliders, definition.name, &Slider::name);
      // Without ends of its own, to twice the value on both sides of 0, as in the viewer.
      const double reach = std::max(1.0, 2 * std::abs(*value));
      PageParameter parameter{definition.name + owner, *value, -reach, reach, 0, {}};
      if (slider != sliders.end()) {
        parameter.min = slider->min;
        parameter.max = slider->max;
        parameter.step = slider->step;
        parameter.choices = slider->choices;
      }
      definition.kept = kFirstKeptSymbol + static_cast<Symbol>(page_.parameters.size());
      page_.parameters.push_back(std::move(parameter));
    }
  }

  void check() const {
    if (is("all") || is("off")) return;
    for (const std::string& word : wanted_) {
      if (still_.contains(word)) {
        throw Error(Status::Input, "solids follow no sliders, and '" + word + "' is of one",
                    {"--sliders", word, {0, word.size()}}, "--thickness off, or --sliders all");
      }
      if (word == "t" || std::ranges::find(names_, word) != names_.end()) continue;
      std::vector<std::string> known = names_;
      known.insert(known.end(), {"t", "all", "off"});
      std::string hint = "known:";
      for (const std::string& name : known) hint += " " + name;
      const auto nearest = nearest_name(word, known);
      throw Error(Status::Input, "no parameter is called '" + word + "'",
                  {"--sliders", word, {0, word.size()}},
                  hint + (nearest ? "; did you mean '" + *nearest + "'?" : ""));
    }
  }

  PageScene& page_;
  std::vector<std::string> wanted_;
  std::vector<std::string> names_;
  std::set<std::string> still_;  ///< parameters of solids
};

void add_picture(const TexturePicture* picture, PageScene& page) {
  if (picture == nullptr) return;
  if (std::ranges::find(page.pictures, picture, &PagePicture::picture) != page.pictures.end()) {
    return;
  }
  Image image = opaque(picture->image);
  for (int y = 0; y < image.height / 2; ++y) {
    std::swap_ranges(image.pixel(0, y), image.pixel(0, y + 1),
                     image.pixel(0, image.height - 1 - y));
  }
  std::ostringstream png;
  write_png(png, image);
  page.pictures.push_back({picture, std::move(png).str()});
}

/// The scripts that only pages with such surfaces need.
std::string scripts_for(const PageScene& page) {
  const auto has = [&](auto property) {
    return std::ranges::any_of(page.scene.surfaces, property);
  };
  std::string all;
  if (has([](const SurfaceSpec& spec) { return bool(spec.texture); })) {
    all += source_of("textures.js");
  }
  if (has([](const SurfaceSpec& spec) { return !spec.contours.empty(); })) {
    all += source_of("contours.js");
  }
  if (std::ranges::any_of(page.packed, &PageMesh::fixed)) all += source_of("tubes.js");
  return all;
}

/// `parts`, `packed`: keep what the page refers to.
PageScene page_scene(const PageContent& content, std::vector<Mesh>& parts,
                     std::vector<PageMesh>& packed) {
  PageScene page;
  page.scene = content.seen;
  page.meshes = content.meshes;
  const Scene& scene = page.scene;
  const dvec2 size(scene.picture.width, scene.picture.height);
  page.camera = fit_to_meshes(scene, content.meshes, size);
  std::vector<std::optional<ColorRange>> ranges;
  for (const Mesh& mesh : content.meshes) ranges.push_back(color_range_of(mesh));
  page.scales = color_scales(scene, ranges);
  split_solids(page, parts);
  for (const SurfaceSpec& spec : page.scene.surfaces) add_picture(spec.texture.picture.get(), page);
  Bounds bounds;
  std::vector<double> stretch(scene.surfaces.size(), 1);
  for (const Instance& instance : instances(scene)) {
    bounds.add(transformed(page.meshes[instance.surface].bounds, instance.to_world));
    double& most = stretch[instance.surface];
    most = std::max(most, largest_stretch(instance.to_world));
  }
  page.centre = (bounds.low + bounds.high) / 2.0;
  page.unit = model_frame(bounds).size;
  const double height = scene.picture.height;
  const double pixel = 2 * page.camera.half_height / height;
  const double within = kBakedShare * page_pixels_off(height) * pixel;
  for (std::size_t i = 0; i < scene.surfaces.size(); ++i) {
    packed.push_back(page_mesh(scene, scene.surfaces[i], page.meshes[i], within / stretch[i]));
    packed.back().fixed |= page.meshes[i].solid.has_value();
  }
  page.packed = packed;
  return page;
}

/// Unpacks the script. Inserted as text it is allowed by its hash.
constexpr const char* kLoader =
    "(async root=>{const find=name=>root.querySelector('.saddle-'+name);"
    "try{const script=document.createElement('script');"
    "script.textContent=await new Response(new "
    "Blob([Uint8Array.from(atob(find('code').textContent),c=>c.charCodeAt(0))])"
    ".stream().pipeThrough(new DecompressionStream('deflate'))).text();"
    "root.append(script)}"
    "catch{find('note').textContent='This page needs a browser of 2023 or later.'}"
    "})(document.currentScript.parentElement)";

std::string body_of(const PageContent& content, const std::string& script,
                    const std::string& meshes, const std::string& style) {
  const std::string formula = formulas_as_text(content.scene);
  const std::string title = escaped_line(content.scene.title);
  const std::string tag = content.fragment ? "div" : "main";
  std::string text =
      "<" + tag + " class=\"saddle\"" + (content.fragment ? " data-fragment" : "") + ">\n";
  if (content.fragment) text += "<style>" + style + "</style>\n";
  text += (content.fragment ? "" : "<h1>" + title + "</h1>\n") +
          ("<p class=\"saddle-formula\">" + escaped_line(formula) + "</p>\n") +
          "<div class=\"saddle-view\"><canvas class=\"saddle-canvas\" role=\"img\" tabindex=\"0\" "
          "aria-label=\"" +
          title + ": " + escaped_line(formula + ". " + description_of(content)) +
          "\"></canvas><canvas class=\"saddle-over\" aria-hidden=\"true\"></canvas></div>\n"
          "<p class=\"saddle-place\" aria-live=\"polite\"></p>\n"
          "<p class=\"saddle-note\"><noscript>This page needs JavaScript.</noscript></p>\n"
          "<div class=\"saddle-panel\"></div>\n";
  text += std::string(kSceneBegins) + escaped_line(write_scene(content.scene)) +
          std::string(kSceneEnds) + "\n";
  text += "<script type=\"text/plain\" class=\"saddle-meshes\">" + base64_of(zlib_stream(meshes)) +
          "</script>\n<script type=\"text/plain\" class=\"saddle-code\">" +
          base64_of(zlib_stream(script)) + "</script>\n<script>" + kLoader + "</script>\n";
  return text + "</" + tag + ">\n";
}

}  // namespace

void write_page(std::ostream& out, const PageContent& content) {
  std::vector<PageMesh> packed;
  std::vector<Mesh> parts;
  PageScene page = page_scene(content, parts, packed);
  const Sliders sliders(page, content.sliders);
  std::string meshes;
  for (const PageMesh& mesh : packed) meshes += mesh.bytes;
  for (const ColorScale& scale : page.scales) meshes += colormap_bytes(scale.colormap);
  for (const PagePicture& picture : page.pictures) meshes += picture.png;
  std::string script = squeezed(page_scene_code(page));
  script = functions_for(script) + script;
  script += scripts_for(page);
  for (const char* const name : kScripts) script += source_of(name);
  // In sloppy code the block's functions would be those of the page around a fragment, too.
  script = "'use strict';\n{\n" + script + "}\n";
  const std::string style = source_of("page.css");
  const std::string body = body_of(content, script, meshes, style);
  if (content.fragment) {
    out << body;
    return;
  }
  out << "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
         "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; base-uri "
         "'none'; form-action 'none'; script-src "
      << hash_of(kLoader) << " " << hash_of(script) << "; style-src " << hash_of(style)
      << "\">\n<meta name=\"viewport\" content=\"width=device-width,initial-scale=1\">\n<title>"
      << escaped_line(content.scene.title) << "</title>\n<style>" << style
      << "</style>\n</head>\n<body>\n"
      << body << "</body>\n</html>\n";
}

double page_pixels_off(double height) {
  return 0.5 * std::min(1.0, height / kScreenHeight);
}

std::optional<std::string> scene_in_page(const std::string& bytes, const std::string&) {
  return text_between(bytes, kSceneBegins, kSceneEnds);
}

}  // namespace saddle
