// SPDX-License-Identifier: GPL-3.0-or-later
// Names of what a platform for three fingers stores before and with its trials.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "hand/columns.hpp"
#include "hand/hands.hpp"

namespace isograsp {

using SixAxes = std::array<Vec6, kFingerCount>;  ///< per finger, contact frame [N, N m]

namespace platform {

// Kinds of preparation.
inline constexpr const char* kInstrumentZero = "instrument_zero";  ///< device empty
inline constexpr const char* kRestingForce = "resting_force";      ///< hand in, relaxed
/// Of two platforms, both empty.
inline constexpr const char* kTwoInstrumentZeros = "two_instrument_zeros";

// References of a session, of a trial and of a preparation.
inline constexpr const char* kCeiling_N = "ceiling_N";  ///< no target exceeds it
inline constexpr OfHands<const char*> kCeilings_N{"left_ceiling_N",
                                                  "right_ceiling_N"};  ///< of both hands
inline constexpr std::string_view kMaximumForce_N = columns::maximum_force_N;
inline constexpr std::string_view kRestingForce_N = columns::resting_force_N;
inline constexpr const char* kVisualGain_deg_per_N = "visual_gain_deg_per_N";
/// Of the object's contacts with each finger.
inline constexpr std::array<const char*, kFingerCount> kThreshold_N{
    "thumb_threshold_N", "index_threshold_N", "middle_threshold_N"};
/// Largest force component by which a zero differs from the last one of the same device, in
/// whichever session, and from the one before it in this session.
inline constexpr const char* kChange_N = "change_N";
inline constexpr const char* kDrift_N = "drift_N";
inline constexpr const char* kDuration_s = "duration_s";
inline constexpr const char* kSinceStrapping_s = "since_strapping_s";

/// thumb_fx_N … middle_tz_Nm.
[[nodiscard]] std::vector<std::string> six_axes_columns();
/// In the order of these columns.
[[nodiscard]] std::vector<double> as_row(const SixAxes& wrenches);
/// Nothing: the columns are others.
[[nodiscard]] std::optional<SixAxes> six_axes_of(std::span<const std::string> columns,
                                                 std::span<const double> row);

/// Of two platforms: left_thumb_fx_N … right_middle_tz_Nm.
[[nodiscard]] std::vector<std::string> two_six_axes_columns();
/// Nothing: the columns are others.
[[nodiscard]] std::optional<OfHands<SixAxes>> two_six_axes_of(std::span<const std::string> columns,
                                                              std::span<const double> row);

}  // namespace platform
}  // namespace isograsp
