// SPDX-License-Identifier: GPL-3.0-or-later
// A box of 60 g between two or three fingertips, 5 mm beside its middle: pressed with 2 N, lifted
// by 10 cm, held for ten seconds. What every engine does, and what is told of it. x: across, y: up.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <string>
#include <vector>

#include <Eigen/Geometry>

namespace isograsp::bench {

inline constexpr double kPi = 3.14159265358979323846;  // Simbody takes no C++20
inline constexpr double kBoxMass_kg = 0.06, kBoxHalf_y_m = 0.02, kBoxHalf_z_m = 0.05;
inline constexpr double kBeside_m = 0.005;  ///< the middle of the box from the grip, along z
inline constexpr double kPress_N = 2.0;     ///< of the thumb; the others share it
inline constexpr double kFriction = 0.8, kTorsion_m = 2.0 / 3.0 * 0.005;
inline constexpr double kStep_s = 0.001, kGravity_m_s2 = 9.81;
inline constexpr double kWeightless_s = 0.4;  ///< until all press
inline constexpr double kLiftEnd_s = 1.5, kHeight_m = 0.1, kHoldBegin_s = 3.0, kEnd_s = 13.0;
inline constexpr double kLost_m = 0.02;  ///< gone so far, it is not held any more

/// Share of gravity that acts, and height and speed of the grip.
inline double weight_at(double t_s) {
  return std::clamp(t_s / kWeightless_s - 1.0, 0.0, 1.0);
}
inline double lift_share(double t_s) {
  const double begin_s = 2.0 * kWeightless_s;
  return std::clamp((t_s - begin_s) / (kLiftEnd_s - begin_s), 0.0, 1.0);
}
inline double height_at(double t_s) {
  return 0.5 * kHeight_m * (1.0 - std::cos(kPi * lift_share(t_s)));
}
inline double rise_at(double t_s) {
  const double share = lift_share(t_s);
  if (share <= 0.0 || share >= 1.0) return 0.0;
  return 0.5 * kHeight_m * kPi / (kLiftEnd_s - 2.0 * kWeightless_s) * std::sin(kPi * share);
}

// A fingertip of an engine that has no hand: a sphere that does not turn, pushed across by a force
// and led along the others by spring and damper.
inline constexpr double kTip_m = 0.008, kTipMass_kg = 0.02, kTipHalf_m = 0.02;
inline constexpr double kLead_N_m = 1500.0, kLead_N_s_m = 11.0, kAcross_N_s_m = 4.0;
struct Tip {
  double side = 1.0;  ///< of the box
  double z_m = 0.0;
  double press_N = 0.0;
};
inline std::vector<Tip> tips_of(int digits) {
  if (digits == 2) return {{-1.0, 0.0, kPress_N}, {1.0, 0.0, kPress_N}};
  return {{-1.0, 0.0, kPress_N}, {1.0, 0.01, 0.5 * kPress_N}, {1.0, -0.01, 0.5 * kPress_N}};
}
/// Of the tip that is at p (y = 0: where it began) and moves with v.
inline Eigen::Vector3d tip_force(const Tip& tip, const Eigen::Vector3d& p, const Eigen::Vector3d& v,
                                 double t_s) {
  return {-tip.side * tip.press_N - kAcross_N_s_m * v.x(),
          kLead_N_m * (height_at(t_s) - p.y()) + kLead_N_s_m * (rise_at(t_s) - v.y()),
          kLead_N_m * (tip.z_m - p.z()) - kLead_N_s_m * v.z()};
}

/// Processor time [ns].
inline double processor_ns() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return 1e9 * static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec);
}

/// How the hold went: where the first tip is in the box at its begin and at its end.
class Hold {
 public:
  void look(double t_s, const Eigen::Vector3d& tip_O, const Eigen::Quaterniond& q_WO) {
    now_ = {tip_O, q_WO};
    if (t_s < kHoldBegin_s) then_ = now_;
  }
  void timed(double ns) { total_ns_ += ns; }
  /// Name, digits, processor time of a second [ms], slip [m], turn [rad], depth of the deepest [m].
  void print(const std::string& name, int digits, double depth_m) const {
    Eigen::Vector3d slip_m = now_.p - then_.p;
    slip_m.x() = 0.0;
    std::printf("%s\t%d\t%.4g\t", name.c_str(), digits, 1e-6 * total_ns_ / kEnd_s);
    if (slip_m.norm() > kLost_m || !std::isfinite(slip_m.norm()))
      std::printf("dropped\tdropped\tdropped\n");
    else
      std::printf("%.3g\t%.3g\t%.3g\n", slip_m.norm(), now_.q.angularDistance(then_.q), depth_m);
  }

 private:
  struct Place {
    Eigen::Vector3d p = Eigen::Vector3d::Zero();
    Eigen::Quaterniond q = Eigen::Quaterniond::Identity();
  };
  Place then_, now_;
  double total_ns_ = 0.0;
};

}  // namespace isograsp::bench
