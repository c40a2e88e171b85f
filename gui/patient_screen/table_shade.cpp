// SPDX-License-Identifier: GPL-3.0-or-later
// Whatever casts a shadow is convex and stands here by its support function in the plane: how far
// it reaches in each of some directions. The distance of a point from it is the largest excess.
#include "gui/patient_screen/table_shade.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace isograsp::gui {

namespace {

constexpr std::size_t kWays = 24;
/// Strongest shadow, of what lies on the table, and the height at which e times less is left [m].
constexpr double kDarkest = 0.52;
constexpr double kFades_m = 0.11;
/// Width of the soft edge at the table, and what it gains per metre of height.
constexpr double kEdge_m = 0.006;
constexpr double kSofterShade = 0.32;

struct Caster {
  std::array<double, kWays> reach_m{};  ///< support function
  double height_m = 0.0;                ///< of its lowest point above the area
};

const std::array<Eigen::Vector2d, kWays>& ways() {
  static const auto kAll = [] {
    std::array<Eigen::Vector2d, kWays> all;
    for (std::size_t k = 0; k < kWays; ++k) {
      const double angle = 2.0 * std::numbers::pi * static_cast<double>(k) / kWays;
      all[k] = {std::cos(angle), std::sin(angle)};
    }
    return all;
  }();
  return kAll;
}

Caster capsule_caster(const Vec3& a, const Vec3& b, double radius_m, double table_m) {
  Caster caster;
  for (std::size_t k = 0; k < kWays; ++k) {
    const Eigen::Vector2d& way = ways()[k];
    caster.reach_m[k] =
        std::max(way.x() * a.x() + way.y() * a.z(), way.x() * b.x() + way.y() * b.z()) + radius_m;
  }
  caster.height_m = std::min(a.y(), b.y()) - radius_m - table_m;
  return caster;
}

/// How far a body reaches from its centre in a direction of the world.
double reach_of(const virtual_hand::ObjectShape& shape, const Quat& q_WO, const Vec3& way_W) {
  const Vec3 way = (q_WO.conjugate() * way_W).cwiseAbs();
  if (shape.kind == virtual_hand::ObjectShape::Kind::box) return way.dot(shape.half_m);
  return std::hypot(way.x(), way.y()) * shape.half_m.x() + way.z() * shape.half_m.z();
}

Caster object_caster(const HandPicture& picture, double table_m) {
  Caster caster;
  const Vec3& p = picture.X_WO.p;
  for (std::size_t k = 0; k < kWays; ++k) {
    const Eigen::Vector2d& way = ways()[k];
    caster.reach_m[k] = way.x() * p.x() + way.y() * p.z() +
                        reach_of(*picture.object, picture.X_WO.q, Vec3(way.x(), 0.0, way.y()));
  }
  caster.height_m = p.y() - reach_of(*picture.object, picture.X_WO.q, Vec3::UnitY()) - table_m;
  return caster;
}

std::vector<Caster> casters_of(const HandPicture& picture, double table_m) {
  constexpr double kPalm_m = 0.011;
  std::vector<Caster> all;
  if (picture.object) all.push_back(object_caster(picture, table_m));
  if (!picture.hand) return all;
  for (std::size_t d = 0; d < kDigitCount; ++d) {
    const auto& joints = picture.hand->digits[d].joints;
    if (d != index_of(Digit::thumb))
      all.push_back(capsule_caster(picture.hand->metacarpals[d], joints[0], kPalm_m, table_m));
    for (std::size_t k = 0; k < virtual_hand::kLinkCount; ++k)
      all.push_back(capsule_caster(joints[k], joints[k + 1], picture.radii_m[d][k], table_m));
  }
  return all;
}

class Shading {
 public:
  explicit Shading(const ShadeArea& area)
      : area_(area), dark_(static_cast<std::size_t>(area.columns) * area.rows, 0.0F) {}

  void add(const Caster& caster) {
    if (caster.height_m < -kEdge_m) return;  // it is below
    const double height_m = std::max(0.0, caster.height_m);
    const double darkest = kDarkest * std::exp(-height_m / kFades_m);
    const double soft_m = kEdge_m + kSofterShade * height_m;
    // Directions 0, a quarter, a half and three quarters are +x, +z, -x, -z.
    const int first_x = column(-caster.reach_m[kWays / 2] - soft_m);
    const int last_x = column(caster.reach_m[0] + soft_m) + 1;
    const int first_z = row(caster.reach_m[kWays / 4] + soft_m);
    const int last_z = row(-caster.reach_m[3 * kWays / 4] - soft_m) + 1;
    for (int r = std::max(0, first_z); r <= std::min(area_.rows - 1, last_z); ++r)
      for (int c = std::max(0, first_x); c <= std::min(area_.columns - 1, last_x); ++c) {
        const double x = area_.left_m + (c + 0.5) * area_.width_m / area_.columns;
        const double z = area_.front_m - (r + 0.5) * area_.depth_m / area_.rows;
        double excess_m = -soft_m;
        for (std::size_t k = 0; k < kWays; ++k)
          excess_m = std::max(excess_m, ways()[k].x() * x + ways()[k].y() * z - caster.reach_m[k]);
        // From all of it inside to nothing outside, without a corner.
        const double share = std::clamp(0.5 * (1.0 - excess_m / soft_m), 0.0, 1.0);
        float& dark = dark_[static_cast<std::size_t>(r) * area_.columns + c];
        dark = std::max(dark, static_cast<float>(darkest * share * share * (3.0 - 2.0 * share)));
      }
  }
  [[nodiscard]] std::vector<std::uint8_t> brightness() const {
    constexpr float kBright = 255.0F;
    std::vector<std::uint8_t> all(dark_.size());
    std::transform(dark_.begin(), dark_.end(), all.begin(), [](float dark) {
      return static_cast<std::uint8_t>(std::lround(kBright * (1.0F - dark)));
    });
    return all;
  }

 private:
  [[nodiscard]] int column(double x_m) const {
    return static_cast<int>(std::floor((x_m - area_.left_m) / area_.width_m * area_.columns));
  }
  [[nodiscard]] int row(double z_m) const {
    return static_cast<int>(std::floor((area_.front_m - z_m) / area_.depth_m * area_.rows));
  }

  ShadeArea area_;
  std::vector<float> dark_;
};

}  // namespace

std::vector<std::uint8_t> table_shade(const HandPicture& picture, const ShadeArea& area) {
  Shading shading(area);
  for (const Caster& caster : casters_of(picture, area.height_m)) shading.add(caster);
  return shading.brightness();
}

}  // namespace isograsp::gui
