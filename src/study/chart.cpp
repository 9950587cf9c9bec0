#include "study/chart.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <sstream>
#include <utility>
#include <vector>

#include "base/child.h"
#include "base/format.h"
#include "base/temporary.h"
#include "study/chart_labels.h"
#include "study/methods.h"

namespace saddle {
namespace {

// The picture in pixels: a head and a foot of text, and between them four panels.
constexpr double kWidth = 1200;
constexpr double kHeight = 960;
constexpr double kHead = 46;
constexpr double kFoot = 30;
constexpr double kLeft = 74;  // of each panel, around the plotted area
constexpr double kRight = 16;
constexpr double kTop = 30;
constexpr double kBottom = 48;
constexpr dvec2 kLetter = {7.4, 15};  // of a method's name; DejaVu Sans at 11 points
constexpr dvec2 kSmallLetter = {6.6, 12};

const std::vector<std::string> kGnuplot = {"gnuplot"};
constexpr const char* kGnuplotPackage = "gnuplot-nox";

/// The lines that promises are read from.
constexpr double kHalfPixel = 0.5;
constexpr double kFrame = 1000.0 / 60;  // milliseconds

/// Errors are drawn from the truth's own rounding up to more than any.
constexpr double kNoError = 1e-16;
constexpr double kLargestError = 1e12;

/// Okabe and Ito's colours for all kinds of colour vision, without the yellow, which is lost on
/// white.
struct Style {
  const char* color;
  int filled;  // gnuplot's point types
  int hollow;
};
constexpr std::array<Style, 7> kStyles = {{{"#0072B2", 7, 6},
                                           {"#D55E00", 5, 4},
                                           {"#009E73", 9, 8},
                                           {"#CC79A7", 13, 12},
                                           {"#56B4E9", 11, 10},
                                           {"#E69F00", 15, 14},
                                           {"#000000", 7, 6}}};

/// A text as gnuplot reads it between single quotes.
std::string quoted(const std::string& text) {
  std::string result = "'";
  for (const char c : text) {
    if (c == '\n') continue;
    result += c == '\'' ? "''" : std::string(1, c);
  }
  return result + "'";
}

double drawn_error(double error) {
  return std::clamp(error, kNoError, kLargestError);
}

const char* panel_title(StudyPanel panel) {
  static constexpr std::array kTitles = {"Evaluation: a grid of positions", "Normals on a grid",
                                         "Mesh", "Image"};
  return kTitles[static_cast<std::size_t>(panel)];
}

const char* error_title(StudyPanel panel) {
  static constexpr std::array kTitles = {
      "largest error, units in the last place", "largest error, degrees",
      "largest distance of mesh and surface, pixels", "RMS error, share of full scale"};
  return kTitles[static_cast<std::size_t>(panel)];
}

struct Curve {
  std::string method;
  std::vector<const Measurement*> points;
  bool is_limit() const { return points.front()->is_limit; }
};

std::vector<Curve> curves_of(std::span<const Measurement> measurements, StudyPanel panel) {
  std::vector<Curve> curves;
  for (const Measurement& m : measurements) {
    if (m.panel != panel) continue;
    const auto same = [&m](const Curve& curve) { return curve.method == m.method; };
    const auto found = std::ranges::find_if(curves, same);
    if (found == curves.end()) {
      curves.push_back({m.method, {&m}});
    } else {
      found->points.push_back(&m);
    }
  }
  return curves;
}

/// The decades that hold all of `values`, and a little room.
dvec2 log_range(const std::vector<double>& values) {
  constexpr double kRoom = 0.12;  // of the range, at each end
  constexpr double kLeastDecades = 2;
  const auto [low, high] = std::ranges::minmax(values);
  const double size = std::log10(high / low);
  const double room = std::max(kRoom * size, 0.5 * (kLeastDecades - size));
  return {low / std::pow(10, room), high * std::pow(10, room)};
}

/// One panel of the chart, as commands for gnuplot.
class PanelScript {
 public:
  PanelScript(std::span<const Measurement> measurements, StudyPanel panel)
      : panel_(panel), curves_(curves_of(measurements, panel)) {
    const int column = static_cast<int>(panel) % 2;
    const int row = static_cast<int>(panel) / 2;
    const dvec2 size = {kWidth / 2, (kHeight - kHead - kFoot) / 2};
    const dvec2 low = {column * size.x, kFoot + (1 - row) * size.y};
    area_ = {low + dvec2(kLeft, kBottom), low + size - dvec2(kRight, kTop)};
    if (!curves_.empty()) find_ranges();
  }

  std::string text() {
    if (curves_.empty()) return {};
    frame();
    labels();
    plot();
    return script_;
  }

 private:
  void find_ranges() {
    std::vector<double> times;
    std::vector<double> errors;
    for (const Curve& curve : curves_) {
      for (const Measurement* m : curve.points) {
        times.insert(times.end(), {m->time.low, m->time.high});
        errors.push_back(drawn_error(m->error));
      }
    }
    if (panel_ == StudyPanel::Mesh) errors.push_back(kHalfPixel);
    times_ = log_range(times);
    errors_ = log_range(errors);
  }

  dvec2 pixel(const Measurement& m) const {
    const auto share = [](double x, const dvec2& range) {
      return std::log(x / range.x) / std::log(range.y / range.x);
    };
    return area_.low + dvec2(share(m.time.median, times_), share(drawn_error(m.error), errors_)) *
                           (area_.high - area_.low);
  }

  void line(const std::string& text) { script_ += text + "\n"; }

  void label(const std::string& text, dvec2 at, int points, const char* color) {
    line(formatted("set label %s at screen %.5f,%.5f left noenhanced font ',%d' tc rgb '%s' front",
                   quoted(text).c_str(), at.x / kWidth, at.y / kHeight, points, color));
  }

  void frame() {
    line("unset label; unset arrow");
    line(formatted("set lmargin at screen %.5f; set rmargin at screen %.5f", area_.low.x / kWidth,
                   area_.high.x / kWidth));
    line(formatted("set bmargin at screen %.5f; set tmargin at screen %.5f", area_.low.y / kHeight,
                   area_.high.y / kHeight));
    line(formatted("set xrange [%.6g:%.6g]; set yrange [%.6g:%.6g]", times_.x, times_.y, errors_.x,
                   errors_.y));
    line(formatted("set title '%s' font ',13' offset 0,-0.5", panel_title(panel_)));
    line("set xlabel 'milliseconds' offset 0,0.4");
    line(formatted("set ylabel '%s' offset 0.8,0", error_title(panel_)));
  }

  void labels() {
    LabelPlacer placer(area_);
    std::vector<std::vector<dvec2>> paths;
    for (const Curve& curve : curves_) {
      std::vector<dvec2>& path = paths.emplace_back();
      for (const Measurement* m : curve.points) path.push_back(pixel(*m));
      placer.avoid_curve(path);
    }
    guides(placer);
    for (std::size_t k = 0; k < curves_.size(); ++k) {
      const dvec2 size = kLetter * dvec2(static_cast<double>(curves_[k].method.size()), 1);
      dvec2 at = placer.place(ends_first(paths[k]), size);
      at.y += 0.5 * kLetter.y;
      label(curves_[k].method, at, 11, color(k));
    }
    for (std::size_t k = 0; k < curves_.size(); ++k) {
      const auto& points = curves_[k].points;
      settings(*points.front(), placer, color(k));
      if (points.size() > 1) settings(*points.back(), placer, color(k));
      for (const Measurement* m : points) {
        if (m->is_asked && m != points.front() && m != points.back())
          settings(*m, placer, color(k));
      }
    }
  }

  /// The lines of 0.5 pixels and of a frame of a film, where the panel has them.
  void guides(LabelPlacer& placer) {
    const bool has_frame = panel_ == StudyPanel::Mesh || panel_ == StudyPanel::Image;
    if (panel_ == StudyPanel::Mesh) {
      line(
          formatted("set arrow from graph 0,first %g to graph 1,first %g nohead dt 3 lc rgb "
                    "'#606060' back",
                    kHalfPixel, kHalfPixel));
      guide("0.5 pixels", {times_.x, kHalfPixel}, placer);
    }
    if (has_frame && times_.x < kFrame && kFrame < times_.y) {
      line(
          formatted("set arrow from first %g,graph 0 to first %g,graph 1 nohead dt 3 lc rgb "
                    "'#606060' back",
                    kFrame, kFrame));
      guide("16.7 ms", {kFrame, errors_.x}, placer);
    }
  }

  void guide(const std::string& text, dvec2 at, LabelPlacer& placer) {
    Measurement m;
    m.time.median = at.x;
    m.error = at.y;
    const dvec2 size = kSmallLetter * dvec2(static_cast<double>(text.size()), 1);
    dvec2 place = placer.place({pixel(m)}, size);
    place.y += 0.5 * kSmallLetter.y;
    label(text, place, 8, "#606060");
  }

  void settings(const Measurement& m, LabelPlacer& placer, const char* color) {
    const dvec2 size = kSmallLetter * dvec2(static_cast<double>(m.setting.size()), 1);
    dvec2 at = placer.place({pixel(m)}, size);
    at.y += 0.5 * kSmallLetter.y;
    label(m.setting, at, 8, color);
  }

  static std::vector<dvec2> ends_first(const std::vector<dvec2>& path) {
    std::vector<dvec2> anchors = {path.back(), path.front()};
    anchors.insert(anchors.end(), path.begin(), path.end());
    return anchors;
  }

  /// The colour of curve k: limits are grey, and take no colour from the others.
  const char* color(std::size_t k) const {
    return curves_[k].is_limit() ? "#606060" : style(k).color;
  }
  const Style& style(std::size_t k) const { return kStyles[k % kStyles.size()]; }

  void block(const std::string& name, const std::vector<const Measurement*>& points) {
    line("$" + name + " << EOD");
    for (const Measurement* m : points) {
      line(formatted("%.6g %.6g %.6g %.6g", m->time.median, drawn_error(m->error), m->time.low,
                     m->time.high));
    }
    line("EOD");
  }

  void plot() {
    std::vector<std::string> layers;
    std::vector<const Measurement*> front;
    for (const Curve& curve : curves_) {
      std::ranges::copy_if(curve.points, std::back_inserter(front),
                           [](const Measurement* m) { return m->pareto; });
    }
    std::ranges::sort(front, {}, [](const Measurement* m) { return m->time.median; });
    if (!front.empty()) {
      block("front", front);
      layers.emplace_back("$front using 1:2 with lines lw 9 lc rgb '#d0d0d0'");
      layers.emplace_back("$front using 1:2 with points pt 7 ps 2.4 lc rgb '#d0d0d0'");
    }
    for (std::size_t k = 0; k < curves_.size(); ++k) curve_layers(k, layers);
    marks("choices", &Measurement::is_choice, "pt 6 ps 2.6", layers);
    marks("asked", &Measurement::is_asked, "pt 4 ps 2.4", layers);
    std::string command = "plot ";
    for (std::size_t k = 0; k < layers.size(); ++k) {
      command += (k == 0 ? "" : ", \\\n     ") + layers[k];
    }
    line(command);
  }

  /// Draws a black mark around the measurements that a member tells.
  void marks(const std::string& name, bool Measurement::*is_marked, const char* point,
             std::vector<std::string>& layers) {
    std::vector<const Measurement*> marked;
    for (const Curve& curve : curves_) {
      std::ranges::copy_if(curve.points, std::back_inserter(marked),
                           [&](const Measurement* m) { return m->*is_marked; });
    }
    if (marked.empty()) return;
    block(name, marked);
    layers.push_back("$" + name + " using 1:2 with points " + point + " lw 2 lc rgb '#000000'");
  }

  void curve_layers(std::size_t k, std::vector<std::string>& layers) {
    const Curve& curve = curves_[k];
    const std::string name = "curve" + std::to_string(k);
    block(name, curve.points);
    if (curve.is_limit()) {
      layers.push_back("$" + name + " using 1:2 with lines lw 2 dt 2 lc rgb '#606060'");
      return;
    }
    const std::string color = std::string(" lc rgb '") + style(k).color + "'";
    layers.push_back("$" + name + " using 1:2 with lines lw 1.5" + color);
    layers.push_back("$" + name + " using 1:2:3:4 with xerrorbars pt -1 lw 1" + color);
    for (const bool kept : {true, false}) {
      std::vector<const Measurement*> points;
      std::ranges::copy_if(curve.points, std::back_inserter(points), [kept](const Measurement* m) {
        return (m->kept_promise() && !m->no_answer) == kept;
      });
      if (points.empty()) continue;
      const std::string part = name + (kept ? "kept" : "missed");
      block(part, points);
      layers.push_back("$" + part + " using 1:2 with points ps 1.1 lw 1.6 pt " +
                       std::to_string(kept ? style(k).filled : style(k).hollow) + color);
    }
  }

  StudyPanel panel_;
  std::vector<Curve> curves_;
  Rectangle area_;
  dvec2 times_{1, 1};
  dvec2 errors_{1, 1};
  std::string script_;
};

std::string make_script(std::span<const Measurement> measurements, const std::string& title,
                        ChartFormat format, const std::string& output) {
  std::string script = "set terminal ";
  script += format == ChartFormat::Svg ? "svg background '#ffffff'" : "pngcairo";
  script += formatted(" size %g,%g font 'DejaVu Sans,11'", kWidth, kHeight);
  script += "\nset output " + quoted(output) + "\nset encoding utf8\nset multiplot\n";
  script += formatted("set label 1 %s at screen 0.5,%.5f center noenhanced font ',15'\n",
                      quoted(title).c_str(), 1 - 0.5 * kHead / kHeight);
  script += formatted(
      "set label 2 'thick grey: nothing is both faster and more accurate     hollow: a promise "
      "missed, or no answer     ring: saddle by itself     square: --samples     bars: middle half "
      "of the times' at screen 0.5,%.5f center font "
      "',10' tc rgb '#404040'\n",
      0.5 * kFoot / kHeight);
  script +=
      "set logscale xy; unset key; set tics nomirror; set border 3\n"
      "set format x '%g'; set format y '10^{%L}'; set mxtics 10; set mytics 10\n"
      "set grid xtics ytics lt 1 lw 0.5 lc rgb '#e4e4e4' back\n";
  // Labels of the head and foot are drawn with the first panel.
  bool first = true;
  for (const StudyPanel panel :
       {StudyPanel::Evaluation, StudyPanel::Normals, StudyPanel::Mesh, StudyPanel::Image}) {
    std::string text = PanelScript(measurements, panel).text();
    if (text.empty()) continue;
    if (first) text.replace(0, text.find('\n') + 1, "");
    first = false;
    script += text;
  }
  return script + "unset multiplot\nset output\n";
}

}  // namespace

void write_csv(std::ostream& out, std::span<const Measurement> measurements) {
  out << "panel,method,setting,milliseconds,error,unit,promise,triangles,pareto\n";
  for (const Measurement& m : measurements) {
    out << panel_name(m.panel) << ',' << m.method << ',' << m.setting << ','
        << formatted("%.6g,%.6g,", m.time.median, m.error) << m.unit << ','
        << (m.promise ? formatted("%.6g", *m.promise) : "") << ','
        << (m.triangles > 0 ? std::to_string(m.triangles) : "") << ',' << (m.pareto ? 1 : 0)
        << '\n';
  }
}

void check_gnuplot() {
  run_with_input(kGnuplot, "exit\n", kGnuplotPackage);
}

std::string draw_chart(std::span<const Measurement> measurements, const std::string& title,
                       ChartFormat format) {
  const UnnamedFile file;
  Child gnuplot(kGnuplot, kGnuplotPackage, std::array{file.descriptor()});
  gnuplot.feed(make_script(measurements, title, format, file.path()));
  file.check_written("gnuplot", [&] { gnuplot.finish(); });
  std::ostringstream text;
  file.copy_to(text);
  return std::move(text).str();
}

}  // namespace saddle
