#include "study/exact_image.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "base/parallel.h"
#include "study/dice.h"

namespace saddle {
namespace {

constexpr int kPerSide = 8;  ///< samples of a pixel
/// Rows of pixels that are drawn at a time: some megabytes.
constexpr int kBand = 8;
/// Triangles cover samples that are so little outside of them (in pixels): between cells of
/// different sizes are cracks, narrower than that.
constexpr double kCrack = 1e-3;
constexpr int kNewtonSteps = 4;
/// A step of Newton's method leads no farther than so many times the cell it starts in.
constexpr double kLongestStep = 2;

/// The nearest triangle at a sample.
struct Hit {
  float depth = std::numeric_limits<float>::infinity();
  std::uint32_t triangle = 0;
};

/// Light as the default shading of both sides has it: Phong, in eye coordinates.
/// Source: B. T. Phong, "Illumination for computer generated pictures", 1975.
dvec3 lit(const dvec3& position, const dvec3& normal, const dvec3& to_eye,
          const Material& material) {
  const auto rgb = [](const Color& c) { return dvec3(c.r, c.g, c.b); };
  dvec3 sum(0);
  for (const Light& light : default_lights()) {
    const dvec3 at = light.position;
    const dvec3 toward = glm::normalize(light.directional ? at : at - position);
    const double n_l = glm::dot(normal, toward);
    if (n_l <= 0) continue;
    const double r_v = glm::dot(2 * n_l * normal - toward, to_eye);
    sum += n_l * rgb(light.color) * rgb(material.diffuse);
    if (r_v > 0) {
      sum += std::pow(r_v, material.shininess) * rgb(light.color) * rgb(material.specular);
    }
  }
  return glm::min(sum, dvec3(1));
}

/// Draws a band of rows after the other.
class Painter {
 public:
  explicit Painter(const Subject& subject)
      : subject_(subject),
        projection_(subject),
        triangles_(dice(subject, projection_)),
        bands_(static_cast<std::size_t>((subject.height + kBand - 1) / kBand)) {
    for (std::size_t k = 0; k < triangles_.size(); ++k) {
      const auto& seen = triangles_[k].seen;
      if (!is_finite(seen[0]) || !is_finite(seen[1]) || !is_finite(seen[2])) continue;
      const auto [low, high] = std::minmax({seen[0].y, seen[1].y, seen[2].y});
      const int first = std::max(0, static_cast<int>(std::floor((low - kCrack) / kBand)));
      const int last = std::min(static_cast<int>(bands_.size()) - 1,
                                static_cast<int>(std::floor((high + kCrack) / kBand)));
      for (int band = first; band <= last; ++band) {
        bands_[static_cast<std::size_t>(band)].push_back(static_cast<std::uint32_t>(k));
      }
    }
  }

  ExactImage paint() {
    ExactImage image{subject_.width, subject_.height, {}};
    image.color.resize(static_cast<std::size_t>(image.width) * image.height);
    parallel_chunks(bands_.size(), 1, subject_.threads, [&](std::size_t begin, std::size_t end) {
      for (std::size_t band = begin; band < end; ++band) paint_band(static_cast<int>(band), image);
    });
    return image;
  }

 private:
  /// Samples of a band, rows from below.
  struct Band {
    int row = 0;  ///< of pixels, from below
    int width = 0;
    int height = 0;
    std::vector<Hit> hits;

    dvec2 place(int i, int j) const {
      return dvec2(i + 0.5, j + 0.5) / static_cast<double>(kPerSide) + dvec2(0, row);
    }
  };

  void paint_band(int number, ExactImage& image) const {
    Band band;
    band.row = number * kBand;
    band.width = subject_.width * kPerSide;
    band.height = std::min(kBand, subject_.height - band.row) * kPerSide;
    band.hits.resize(static_cast<std::size_t>(band.width) * band.height);
    for (const std::uint32_t k : bands_[static_cast<std::size_t>(number)]) cover(k, band);

    std::vector<dvec2> places;
    std::vector<std::uint32_t> of;
    std::vector<std::size_t> samples;
    for (int j = 0; j < band.height; ++j) {
      for (int i = 0; i < band.width; ++i) {
        const std::size_t sample = static_cast<std::size_t>(j) * band.width + i;
        if (std::isinf(band.hits[sample].depth)) continue;
        places.push_back(band.place(i, j));
        of.push_back(band.hits[sample].triangle);
        samples.push_back(sample);
      }
    }
    const std::vector<dvec3> colors = shade(places, of);
    for (std::size_t k = 0; k < samples.size(); ++k) {
      const int x = static_cast<int>(samples[k] % static_cast<std::size_t>(band.width)) / kPerSide;
      const int y =
          band.row + static_cast<int>(samples[k] / static_cast<std::size_t>(band.width)) / kPerSide;
      const auto pixel = static_cast<std::size_t>(image.height - 1 - y) * image.width + x;
      image.color[pixel] += colors[k] / static_cast<double>(kPerSide * kPerSide);
    }
  }

  /// Weights of a triangle's corners at a place; the smallest is negative outside.
  static dvec3 weights(const DicedTriangle& t, const dvec2& at) {
    const dvec2 a = dvec2(t.seen[0]);
    const dvec2 ab = dvec2(t.seen[1]) - a;
    const dvec2 ac = dvec2(t.seen[2]) - a;
    const dvec2 p = at - a;
    const double area = ab.x * ac.y - ab.y * ac.x;
    const double b = (p.x * ac.y - p.y * ac.x) / area;
    const double c = (ab.x * p.y - ab.y * p.x) / area;
    return {1 - b - c, b, c};
  }

  void cover(std::uint32_t k, Band& band) const {
    const DicedTriangle& t = triangles_[k];
    const dvec2 ab = dvec2(t.seen[1] - t.seen[0]);
    const dvec2 ac = dvec2(t.seen[2] - t.seen[0]);
    const double area = std::fabs(ab.x * ac.y - ab.y * ac.x);
    if (!(area > 0)) return;
    const double longest = std::max({glm::length(ab), glm::length(ac), glm::length(ac - ab)});
    const double slack = std::min(kCrack * longest / area, 0.5);
    const auto [low_x, high_x] = std::minmax({t.seen[0].x, t.seen[1].x, t.seen[2].x});
    const auto [low_y, high_y] = std::minmax({t.seen[0].y, t.seen[1].y, t.seen[2].y});
    const auto first = [](double x, double from) {
      return static_cast<int>(std::max(0.0, std::ceil((x - kCrack - from) * kPerSide - 0.5)));
    };
    const auto last = [](double x, double from, int count) {
      return static_cast<int>(
          std::min(count - 1.0, std::floor((x + kCrack - from) * kPerSide - 0.5)));
    };
    for (int j = first(low_y, band.row); j <= last(high_y, band.row, band.height); ++j) {
      for (int i = first(low_x, 0); i <= last(high_x, 0, band.width); ++i) {
        const dvec3 w = weights(t, band.place(i, j));
        if (std::min({w.x, w.y, w.z}) < -slack) continue;
        const double depth = w.x * t.seen[0].z + w.y * t.seen[1].z + w.z * t.seen[2].z;
        Hit& hit = band.hits[static_cast<std::size_t>(j) * band.width + i];
        if (static_cast<float>(depth) < hit.depth) hit = {static_cast<float>(depth), k};
      }
    }
  }

  /// The points of the surface on the rays through `places`, from where their triangles say.
  std::vector<SurfacePoint> meet(const std::vector<dvec2>& places,
                                 const std::vector<std::uint32_t>& of) const {
    std::vector<dvec2> uv;
    for (std::size_t k = 0; k < places.size(); ++k) {
      const DicedTriangle& t = triangles_[of[k]];
      const dvec3 w = weights(t, places[k]);
      uv.push_back(w.x * t.uv[0] + w.y * t.uv[1] + w.z * t.uv[2]);
    }
    std::vector<SurfacePoint> best = evaluate(subject_.surface, uv, 1);
    std::vector<double> off(uv.size());
    for (std::size_t k = 0; k < uv.size(); ++k) {
      off[k] = glm::distance(projection_(best[k]).at, places[k]);
    }
    std::vector<dvec2> tries(uv.size());
    for (int step = 0; step < kNewtonSteps; ++step) {
      for (std::size_t k = 0; k < uv.size(); ++k)
        tries[k] = newton(uv[k], best[k], places[k], of[k]);
      const std::vector<SurfacePoint> there = evaluate(subject_.surface, tries, 1);
      for (std::size_t k = 0; k < uv.size(); ++k) {
        const double now = glm::distance(projection_(there[k]).at, places[k]);
        if (!(now < off[k]) && std::isfinite(off[k])) continue;
        off[k] = now;
        best[k] = there[k];
        uv[k] = tries[k];
      }
    }
    return best;
  }

  dvec2 newton(const dvec2& uv, const SurfacePoint& p, const dvec2& place, std::uint32_t of) const {
    const Projection::Seen seen = projection_(p);
    const dvec2 gap = place - seen.at;
    const double determinant = seen.by_u.x * seen.by_v.y - seen.by_u.y * seen.by_v.x;
    const dvec2 step = dvec2(gap.x * seen.by_v.y - gap.y * seen.by_v.x,
                             seen.by_u.x * gap.y - seen.by_u.y * gap.x) /
                       determinant;
    const DicedTriangle& t = triangles_[of];
    const dvec2 size = glm::max(glm::abs(t.uv[1] - t.uv[0]), glm::abs(t.uv[2] - t.uv[0]));
    const bool small =
        std::fabs(step.x) <= kLongestStep * size.x && std::fabs(step.y) <= kLongestStep * size.y;
    return small ? uv + step : uv;  // also NaN
  }

  std::vector<dvec3> shade(const std::vector<dvec2>& places,
                           const std::vector<std::uint32_t>& of) const {
    const std::vector<SurfacePoint> points = meet(places, of);
    const glm::dmat4& to_eye = subject_.camera.world_to_eye;
    std::vector<dvec3> colors;
    colors.reserve(points.size());
    for (const SurfacePoint& p : points) {
      const dvec3 position = dvec3(to_eye * glm::dvec4(p.position, 1));
      dvec3 normal = glm::dmat3(to_eye) * glm::normalize(glm::cross(p.r_u, p.r_v));
      if (subject_.surface.flip) normal = -normal;
      const dvec3 view = subject_.scene.camera.ortho ? dvec3(0, 0, 1) : glm::normalize(-position);
      const bool front = glm::dot(normal, view) >= 0;
      const Material& material = front ? kFrontMaterial : kBackMaterial;
      const dvec3 color = lit(position, front ? normal : -normal, view, material);
      colors.push_back(is_finite(color) ? color : dvec3(0));  // a sample on a singular point
    }
    return colors;
  }

  const Subject& subject_;
  Projection projection_;
  std::vector<DicedTriangle> triangles_;
  std::vector<std::vector<std::uint32_t>> bands_;  ///< the triangles of each
};

}  // namespace

ExactImage draw_exactly(const Subject& subject) {
  return Painter(subject).paint();
}

double rms_error(const Image& image, const ExactImage& exact) {
  double sum = 0;
  for (int y = 0; y < exact.height; ++y) {
    for (int x = 0; x < exact.width; ++x) {
      const dvec3& color = exact.color[static_cast<std::size_t>(y) * exact.width + x];
      for (int c = 0; c < 3; ++c) {
        const double off = image.pixel(x, y)[c] / 255.0 - color[c];
        sum += off * off;
      }
    }
  }
  return std::sqrt(sum / (3.0 * exact.width * exact.height));
}

}  // namespace saddle
