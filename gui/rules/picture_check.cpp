// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/rules/picture_check.hpp"

#include <algorithm>
#include <cmath>

namespace isograsp::gui {

namespace {

constexpr std::array<std::string_view, PictureCheck::kWays> kWayNames{"right", "up", "away"};
/// An object rests that stays within so far for so long.
constexpr double kRestsWithin_m = 0.01;
constexpr double kRestsFor_s = 0.5;

Vec3 direction_on_screen(PictureCheck::Way way) {
  switch (way) {
    case PictureCheck::Way::right: return Vec3::UnitX();
    case PictureCheck::Way::up: return Vec3::UnitY();
    case PictureCheck::Way::away: break;
  }
  return -Vec3::UnitZ();
}

}  // namespace

std::string_view name_of(PictureCheck::Way way) noexcept {
  return kWayNames[static_cast<std::size_t>(way)];
}

void PictureCheck::begin() {
  next_ = 0;
  off_rad_ = {};
  from_S_.reset();
  rests_S_.reset();
}

void PictureCheck::stop() {
  next_ = kWays;
}

std::optional<PictureCheck::Way> PictureCheck::asked() const noexcept {
  if (!running() || !from_S_) return std::nullopt;
  return static_cast<Way>(next_);
}

bool PictureCheck::good() const noexcept {
  return std::all_of(off_rad_.begin(), off_rad_.end(),
                     [](const auto& off) { return off && *off <= kMostOff_rad; });
}

bool PictureCheck::add(const std::optional<Vec3>& p_S, double time_s) {
  if (!running() || !p_S) return false;
  if (!from_S_) {
    if (!rests_S_ || (*p_S - *rests_S_).norm() > kRestsWithin_m) {
      rests_S_ = p_S;
      since_s_ = time_s;
    }
    if (time_s - since_s_ < kRestsFor_s) return false;
    from_S_ = rests_S_;
    return true;
  }
  const Vec3 gone_S = *p_S - *from_S_;
  const double way_m = gone_S.norm();
  if (way_m < kLeastWay_m) return false;
  const double along = gone_S.dot(direction_on_screen(static_cast<Way>(next_))) / way_m;
  const double off_rad = std::acos(std::clamp(along, -1.0, 1.0));
  if (off_rad > kMostOff_rad && way_m < kMostWay_m) return false;  // it may still turn
  off_rad_[next_++] = off_rad;
  from_S_.reset();
  rests_S_.reset();
  return true;
}

}  // namespace isograsp::gui
