// Source: World Wide Web Consortium, "Scalable vector graphics (SVG) 1.1", 2011.
#include <cmath>
#include <ostream>
#include <sstream>

#include "base/base64.h"
#include "base/format.h"
#include "base/image_png.h"
#include "export/common/markup.h"
#include "export/figures/figure.h"
#include "scene/model/colormap.h"
#include "scene/toml/scene_file.h"

namespace saddle {
namespace {

/// Digits of lengths in pixels: hundredths of the largest picture's.
constexpr int kPlaces = 7;
constexpr int kBarStops = 64;
constexpr std::string_view kSvgSceneBegins = "<metadata id=\"saddle-scene\">";
constexpr std::string_view kSvgSceneEnds = "</metadata>";

std::string svg_number(double value) {
  return rounded(value, kPlaces);
}

std::string svg_point(const dvec2& p) {
  return svg_number(p.x) + " " + svg_number(p.y);
}

std::string svg_color(const dvec3& color) {
  std::string text = "#";
  for (int k = 0; k < 3; ++k) {
    text += formatted("%02x",
                      static_cast<int>(std::lround(255 * std::fmin(1, std::fmax(0, color[k])))));
  }
  return text;
}

std::string path_of(const FigureLines& lines) {
  std::string path;
  for (const auto& line : lines.lines) {
    for (std::size_t i = 0; i < line.size(); ++i) path += (i == 0 ? "M" : "L") + svg_point(line[i]);
  }
  return path;
}

std::string path_of(const std::vector<OutlinePiece>& letters) {
  std::string path;
  for (const OutlinePiece& piece : letters) {
    if (piece.kind == OutlinePiece::Kind::Move) path += (path.empty() ? "M" : "ZM");
    if (piece.kind == OutlinePiece::Kind::Line) path += "L";
    if (piece.kind == OutlinePiece::Kind::Curve) path += "Q" + svg_point(piece.control) + " ";
    path += svg_point(piece.to);
  }
  return path + "Z";
}

/// A gradient between the colormap's places.
std::string svg_bar(const ColorBar& bar, const std::string& name) {
  std::string text = "<linearGradient id=\"" + name + "\" x1=\"0\" y1=\"1\" x2=\"0\" y2=\"0\">";
  for (int i = 0; i <= kBarStops; ++i) {
    const double place = static_cast<double>(i) / kBarStops;
    text += "<stop offset=\"" + rounded(place, kPlaces) + "\" stop-color=\"" +
            svg_color(colormap_at(bar.colormap, place)) + "\"/>";
  }
  return text + "</linearGradient>\n<rect x=\"" + svg_number(bar.upper_left.x) + "\" y=\"" +
         svg_number(bar.upper_left.y) + "\" width=\"" + svg_number(bar.size.x) + "\" height=\"" +
         svg_number(bar.size.y) + "\" fill=\"url(#" + name + ")\"/>\n";
}

}  // namespace

void write_svg(std::ostream& out, const PageContent& content) {
  const Figure figure = make_figure(content);
  const std::string width = svg_number(figure.size.x);
  const std::string height = svg_number(figure.size.y);
  std::ostringstream png;
  write_png(png, figure.image);
  out << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
         "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" "
         "width=\""
      << width << "\" height=\"" << height << "\" viewBox=\"0 0 " << width << " " << height
      << "\">\n<title>" << escaped_markup(content.scene.title) << "</title>\n<desc>"
      << escaped_markup(formulas_as_text(content.scene)) << "</desc>\n"
      << kSvgSceneBegins << escaped_markup(write_scene(content.scene)) << kSvgSceneEnds
      << "\n<image width=\"" << width << "\" height=\"" << height
      << "\" xlink:href=\"data:image/png;base64," << base64_of(png.str()) << "\"/>\n";
  for (std::size_t i = 0; i < figure.bars.size(); ++i) {
    out << svg_bar(figure.bars[i], "bar" + std::to_string(i));
  }
  for (const FigureLines& lines : figure.lines) {
    out << "<path fill=\"none\" stroke=\"" << svg_color(lines.color) << "\" stroke-width=\""
        << svg_number(lines.width) << "\" stroke-linecap=\"round\" stroke-linejoin=\"round\" d=\""
        << path_of(lines) << "\"/>\n";
  }
  if (!figure.letters.empty()) {
    const std::string letters = path_of(figure.letters);
    if (figure.rim) {
      out << "<path fill=\"none\" stroke=\"" << svg_color(*figure.rim) << "\" stroke-width=\""
          << svg_number(figure.rim_width) << "\" stroke-linejoin=\"round\" d=\"" << letters
          << "\"/>\n";
    }
    out << "<path fill=\"" << svg_color(figure.ink) << "\" d=\"" << letters << "\"/>\n";
  }
  out << "</svg>\n";
}

std::optional<std::string> scene_in_svg(const std::string& bytes, const std::string&) {
  return text_between(bytes, kSvgSceneBegins, kSvgSceneEnds);
}

}  // namespace saddle
