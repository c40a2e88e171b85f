// SPDX-License-Identifier: GPL-3.0-or-later
// Assistance of a grasp: fingertips of a feasible grasp are tied to the object by springs and
// dampers, and come loose when the person pulls (Delrieu et al., phases P1 E1 P2 E2; what they
// leave open is decided in docs/virtual_hand.md). Pure, without allocation: real-time safe. SI
// units.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "virtual_hand/grasp_criteria.hpp"

namespace isograsp::virtual_hand {

/// What ties one contact: two digits carry the object under gravity and `acceleration`, and the
/// springs give by `deflection`.
struct TieDesign {
  double mass_kg = 0.0;
  int digits = 2;
  double deflection_m = 0.002;
  double damping_ratio = 1.0;
  double gravity_m_s2 = 9.81;
  double acceleration_m_s2 = 5.0;
  double patch_radius_m = 0.005;
};
struct TieGains {
  double stiffness_N_m = 0.0;    ///< k = m (g + a) / (n delta)
  double damping_N_s_m = 0.0;    ///< c = 2 zeta sqrt(k m / n)
  double torsion_N_m_rad = 0.0;  ///< about the stored normal: k (2 R / 3)^2
  double release_N = 0.0;        ///< 1.5 m (g + a): the object never shakes itself loose
};
[[nodiscard]] TieGains tie_gains(const TieDesign& design) noexcept;

enum class DigitState : std::uint8_t {
  free,      ///< does not touch
  contact,   ///< touches
  attached,  ///< tied to the object
  blocked    ///< was let go, and is not tied again at once
};
inline constexpr std::array<std::string_view, 4> kDigitStateNames{"free", "contact", "attached",
                                                                  "blocked"};

/// What one row of a session says.
struct AssistanceRow {
  double t_s = 0.0;
  bool tracked = true;
  DigitSet feasible = 0;  ///< the best feasible grasp; 0: there is none
  struct OfDigit {
    bool contact = false;
    double pull_N = 0.0;  ///< effort of its spring as it leaves; 0: it touches
    double gap_m = 0.0;   ///< from the object
  };
  std::array<OfDigit, kDigitCount> digits;
};

class Assistance {
 public:
  static constexpr double kReleaseGap_m = 0.002;  ///< a blocked digit so far away is free again …
  static constexpr double kBlocked_s = 0.5;       ///< … and in any case after this time
  static constexpr double kPull_s = 0.03;         ///< above the release effort for so long
  static constexpr double kPullAtOnce = 2.0;      ///< times the release effort
  static constexpr double kStanding_s = 0.02;     ///< of the same feasible grasp before it is tied
  static constexpr double kTimeSlack_s = 1e-9;    ///< differences of times are rounded

  explicit Assistance(double release_N) noexcept : release_N_(release_N) {}

  /// One row, in the order of time.
  void step(const AssistanceRow& row) noexcept;
  [[nodiscard]] const std::array<DigitState, kDigitCount>& states() const noexcept {
    return states_;
  }
  /// All that are tied are blocked from now on: what is left of a grasp is none any more.
  void let_go(double t_s) noexcept;
  /// Another effort lets go from the next row on [N].
  void set_release(double release_N) noexcept { release_N_ = release_N; }

 private:
  using Since = std::optional<double>;
  [[nodiscard]] static bool lasts(const Since& since, double t_s, double span_s) noexcept;
  void forget() noexcept;
  void touch(const AssistanceRow& row) noexcept;
  void release(const AssistanceRow& row) noexcept;
  void tie(const AssistanceRow& row) noexcept;
  void block(std::size_t digit, double t_s) noexcept;

  double release_N_;
  std::array<DigitState, kDigitCount> states_{};
  std::array<Since, kDigitCount> pulled_;
  std::array<Since, kDigitCount> blocked_;
  DigitSet standing_ = 0;
  Since stands_;
};

}  // namespace isograsp::virtual_hand
