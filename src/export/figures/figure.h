// A scene as a figure for a paper: what is shaded as an image, lines and letters as lines and
// letters. The frame is the picture's.
#pragma once

#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "base/image.h"
#include "base/vec.h"
#include "export/common/content.h"
#include "render/overlay/annotations.h"
#include "render/overlay/font.h"

namespace saddle {

/// Lines of one look, in pixels from the upper left.
struct FigureLines {
  std::vector<std::vector<dvec2>> lines;
  dvec3 color{0, 0, 0};
  double width = 1;  ///< pixels
};

struct Figure {
  dvec2 size{0, 0};  ///< pixels
  Image image;       ///< of all of it, in finer pixels
  std::vector<FigureLines> lines;
  std::vector<ColorBar> bars;
  std::vector<OutlinePiece> letters;
  dvec3 ink{0, 0, 0};
  std::optional<dvec3> rim;  ///< colour around the letters
  double rim_width = 0;      ///< pixels, to both sides of their outline together
};

/// Throws Error as render() does.
Figure make_figure(const PageContent& content);

/// A tenth of a pixel, the distance that hidden parts of lines may be off by.
double figure_pixels_off(double height);

/// Write the figure with its scene inside.
void write_svg(std::ostream& out, const PageContent& content);
void write_pdf(std::ostream& out, const PageContent& content);

/// The scene file in such a file; nothing if it holds none.
std::optional<std::string> scene_in_svg(const std::string& bytes, const std::string& name);
std::optional<std::string> scene_in_pdf(const std::string& bytes, const std::string& name);

}  // namespace saddle
