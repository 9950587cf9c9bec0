// Source: International Organization for Standardization, "Portable document format", ISO 32000-1,
// 2008. The image is the data of a PNG as it is: PDF knows PNG's filters as Predictor 15.
#include <cmath>
#include <ostream>
#include <sstream>
#include <vector>

#include "base/deflate.h"
#include "base/format.h"
#include "base/image_png.h"
#include "base/utf8.h"
#include "export/common/markup.h"
#include "export/figures/figure.h"
#include "export/page/page_meshes.h"
#include "render/shading/colormap_textures.h"
#include "scene/toml/scene_file.h"

namespace saddle {
namespace {

/// Points of print for a pixel: 96 pixels an inch, as browsers have it.
constexpr double kPoints = 0.75;
constexpr int kPdfPlaces = 6;
/// The stream that holds the scene says so; its length stands behind.
constexpr std::string_view kPdfSceneMark = "/SaddleScene true /Length ";

std::string pdf_number(double value) {
  const std::string text = rounded(value, kPdfPlaces);
  return text.find('e') == std::string::npos ? text : formatted("%.6f", value);
}

/// Places have y upward.
class PdfPath {
 public:
  explicit PdfPath(double height) : height_(height) {}

  std::string point(const dvec2& p) const {
    return pdf_number(kPoints * p.x) + " " + pdf_number(kPoints * (height_ - p.y)) + " ";
  }

  std::string lines(const FigureLines& lines) const {
    std::string code = color(lines.color) + " RG " + pdf_number(kPoints * lines.width) + " w\n";
    for (const auto& line : lines.lines) {
      for (std::size_t i = 0; i < line.size(); ++i) code += point(line[i]) + (i == 0 ? "m " : "l ");
      code += "S\n";
    }
    return code;
  }

  /// A parabola is a cubic whose control points are two thirds of the way to its own.
  std::string letters(const Figure& figure) const {
    if (figure.letters.empty()) return "";
    const std::string outlines = outlines_of(figure.letters);
    std::string code;
    if (figure.rim) {
      code += color(*figure.rim) + " RG " + pdf_number(kPoints * figure.rim_width) + " w\n" +
              outlines + "S\n";
    }
    return code + color(figure.ink) + " rg\n" + outlines + "f\n";
  }

 private:
  std::string outlines_of(const std::vector<OutlinePiece>& letters) const {
    std::string code;
    dvec2 last(0);
    for (const OutlinePiece& piece : letters) {
      if (piece.kind == OutlinePiece::Kind::Curve) {
        const dvec2 a = last + (piece.control - last) * (2.0 / 3);
        const dvec2 b = piece.to + (piece.control - piece.to) * (2.0 / 3);
        code += point(a) + point(b) + point(piece.to) + "c\n";
      } else {
        code += point(piece.to) + (piece.kind == OutlinePiece::Kind::Move ? "m\n" : "l\n");
      }
      last = piece.to;
    }
    return code;
  }

  static std::string color(const dvec3& c) {
    return pdf_number(c.r) + " " + pdf_number(c.g) + " " + pdf_number(c.b);
  }

  double height_;
};

/// Text as UTF-16, in hexadecimal digits.
std::string pdf_text(const std::string& text) {
  std::string digits = "<FEFF";
  const auto add = [&](unsigned unit) { digits += formatted("%04X", unit); };
  for (std::size_t at = 0; at < text.size();) {
    const Character letter = decode_utf8(text, at);
    at += letter.bytes;
    if (letter.code < 0x10000) {
      add(letter.code);
    } else {
      add(0xD800 + ((letter.code - 0x10000) >> 10));
      add(0xDC00 + ((letter.code - 0x10000) & 0x3FF));
    }
  }
  return digits + ">";
}

/// The pixels of a PNG of these, filtered and deflated.
std::string png_data(const Image& image) {
  std::ostringstream out;
  write_png(out, image);
  const std::string png = out.str();
  const auto number = [&](std::size_t at) {
    std::size_t value = 0;
    for (std::size_t k = 0; k < 4; ++k)
      value = value << 8 | static_cast<unsigned char>(png[at + k]);
    return value;
  };
  std::string data;
  constexpr std::size_t kSignature = 8;
  constexpr std::size_t kAround = 12;  // length, type and checksum of a chunk
  for (std::size_t at = kSignature; at + kAround <= png.size(); at += kAround + number(at)) {
    if (png.compare(at + 4, 4, "IDAT") == 0) data += png.substr(at + 8, number(at));
  }
  return data;
}

/// Nothing where all of it is opaque.
std::string alpha_of(const Image& image) {
  std::string alpha;
  bool is_opaque = true;
  for (std::size_t i = 3; i < image.rgba.size(); i += 4) {
    alpha += static_cast<char>(image.rgba[i]);
    is_opaque = is_opaque && image.rgba[i] == 255;
  }
  return is_opaque ? "" : alpha;
}

/// Objects in the order of their numbers, and the table of where they begin.
class PdfFile {
 public:
  void add(const std::string& object) {
    places_.push_back(text_.size());
    text_ += std::to_string(places_.size()) + " 0 obj\n" + object + "\nendobj\n";
  }
  void add_stream(const std::string& entries, const std::string& data) {
    add("<< " + entries + std::to_string(data.size()) + " >>\nstream\n" + data + "\nendstream");
  }
  /// With these entries of the trailer.
  std::string finish(const std::string& entries) {
    const std::size_t table = text_.size();
    text_ += "xref\n0 " + std::to_string(places_.size() + 1) + "\n0000000000 65535 f \n";
    for (const std::size_t place : places_) text_ += formatted("%010zu 00000 n \n", place);
    text_ += "trailer\n<< /Size " + std::to_string(places_.size() + 1) + entries +
             " >>\nstartxref\n" + std::to_string(table) + "\n%%EOF\n";
    return text_;
  }

 private:
  // The second line tells that the file is no text.
  // LaTeX warns of versions above 1.5. Transparency and embedded files need 1.4.
  std::string text_ = "%PDF-1.4\n%\xE2\xE3\xCF\xD3\n";
  std::vector<std::size_t> places_;
};

}  // namespace

void write_pdf(std::ostream& out, const PageContent& content) {
  const Figure figure = make_figure(content);
  const std::string width = pdf_number(kPoints * figure.size.x);
  const std::string height = pdf_number(kPoints * figure.size.y);
  const PdfPath path(figure.size.y);
  const std::string alpha = alpha_of(figure.image);
  std::string code = "q " + width + " 0 0 " + height + " 0 0 cm /Image Do Q\n1 J 1 j\n";
  std::string shadings;
  std::size_t next = alpha.empty() ? 9 : 10;
  for (std::size_t i = 0; i < figure.bars.size(); ++i) {
    const ColorBar& bar = figure.bars[i];
    const dvec2 lower_left = bar.upper_left + dvec2(0, bar.size.y);
    code += "q " + path.point(lower_left) + pdf_number(kPoints * bar.size.x) + " " +
            pdf_number(kPoints * bar.size.y) + " re W n /Bar" + std::to_string(i) + " sh Q\n";
    shadings += "/Bar" + std::to_string(i) + " << /ShadingType 2 /ColorSpace /DeviceRGB /Coords [" +
                path.point(lower_left) + path.point(bar.upper_left) + "] /Function " +
                std::to_string(next++) + " 0 R /Extend [true true] >> ";
  }
  for (const FigureLines& lines : figure.lines) code += path.lines(lines);
  code += path.letters(figure);

  const std::string columns = std::to_string(figure.image.width);
  const std::string size = "/Width " + columns + " /Height " + std::to_string(figure.image.height) +
                           " /BitsPerComponent 8 ";
  PdfFile file;
  file.add(
      "<< /Type /Catalog /Pages 2 0 R /Names << /EmbeddedFiles << /Names [(scene.toml) 6 0 R] "
      ">> >> >>");
  file.add("<< /Type /Pages /Kids [3 0 R] /Count 1 >>");
  file.add("<< /Type /Page /Parent 2 0 R /MediaBox [0 0 " + width + " " + height +
           "] /Contents 4 0 R /Resources << /XObject << /Image 5 0 R >> /Shading << " + shadings +
           ">> >> /Group << /S "
           "/Transparency /CS /DeviceRGB >> >>");
  file.add_stream("/Filter /FlateDecode /Length ", zlib_stream(code));
  file.add_stream(
      "/Type /XObject /Subtype /Image /ColorSpace /DeviceRGB " + size +
          (alpha.empty() ? "" : "/SMask 9 0 R ") +
          "/Interpolate true /Filter /FlateDecode /DecodeParms << /Predictor 15 /Colors "
          "3 /BitsPerComponent 8 /Columns " +
          columns + " >> /Length ",
      png_data(opaque(figure.image)));
  file.add("<< /Type /Filespec /F (scene.toml) /EF << /F 7 0 R >> >>");
  file.add_stream("/Type /EmbeddedFile /Subtype /application#2Ftoml " + std::string(kPdfSceneMark),
                  write_scene(content.scene));
  file.add("<< /Title " + pdf_text(content.scene.title) + " /Subject " +
           pdf_text(formulas_as_text(content.scene)) + " /Creator (saddle) >>");
  if (!alpha.empty()) {
    file.add_stream("/Type /XObject /Subtype /Image /ColorSpace /DeviceGray " + size +
                        "/Filter /FlateDecode /Length ",
                    zlib_stream(alpha));
  }
  for (const ColorBar& bar : figure.bars) {
    file.add_stream("/FunctionType 0 /Domain [0 1] /Range [0 1 0 1 0 1] /Size [" +
                        std::to_string(kColormapTexels) + "] /BitsPerSample 8 /Length ",
                    colormap_bytes(bar.colormap));
  }
  out << file.finish(" /Root 1 0 R /Info 8 0 R");
}

std::optional<std::string> scene_in_pdf(const std::string& bytes, const std::string&) {
  constexpr std::string_view kStream = "stream\n";
  const std::size_t mark = bytes.find(kPdfSceneMark);
  if (mark == std::string::npos) return std::nullopt;
  const std::size_t digits = mark + kPdfSceneMark.size();
  const std::size_t stream = bytes.find(kStream, digits);
  if (stream == std::string::npos) return std::nullopt;
  const std::size_t length = std::strtoull(bytes.c_str() + digits, nullptr, 10);
  return bytes.substr(stream + kStream.size(), length);
}

}  // namespace saddle
