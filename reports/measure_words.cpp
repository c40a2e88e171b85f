// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/measure_words.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <span>

namespace isograsp {

namespace {

struct Entry {
  std::string_view name;
  std::string_view title;
  Better better;
  bool censored = false;
};
constexpr std::array kEntries{
    Entry{"rmse", "Tracking error (RMS)", Better::lower},
    Entry{"relative_rmse", "Tracking error, relative", Better::lower},
    Entry{"mae", "Tracking error (mean)", Better::lower},
    Entry{"constant_error", "Constant error", Better::near_zero},
    Entry{"time_in_range", "Time on target", Better::higher},
    Entry{"lag", "Lag behind the target", Better::near_zero},
    Entry{"gain", "Gain", Better::unknown},
    Entry{"maximum_force", "Maximum grip above rest", Better::higher},
    Entry{"maximum_force_total", "Maximum grip, total", Better::higher},
    Entry{"peak_force", "Peak grip", Better::unknown},
    Entry{"resting_force", "Resting grip force", Better::near_zero},
    Entry{"targets_reached", "Targets reached", Better::higher},
    Entry{"completion_time", "Time to reach", Better::lower, true},
    Entry{"hold_error_position", "Hold error, position", Better::lower, true},
    Entry{"hold_error_angle", "Hold error, angle", Better::lower, true},
    Entry{"tilt_in_transport", "Tilt in transport", Better::lower},
    Entry{"path_length", "Path length", Better::unknown},
    Entry{"path_efficiency", "Directness of the path", Better::higher},
    Entry{"mean_grip", "Mean grip", Better::unknown},
    Entry{"contact_time", "Time in contact", Better::unknown},
    Entry{"slip", "Slip", Better::lower},
    Entry{"sparc", "Smoothness (SPARC)", Better::near_zero},
    Entry{"drops", "Drops", Better::lower},
};

struct Placed {
  std::string_view name;
  std::string_view channel;  ///< empty: any
  Prominence prominence;
};
constexpr Placed kRest[] = {{"resting_force", "grip", Prominence::trend}};
constexpr Placed kMaximum[] = {{"maximum_force", "", Prominence::key}};
constexpr Placed kTracking[] = {{"relative_rmse", "", Prominence::key},
                                {"time_in_range", "", Prominence::trend},
                                {"lag", "", Prominence::trend}};
constexpr Placed kPoses[] = {{"targets_reached", "", Prominence::key},
                             {"tilt_in_transport", "", Prominence::key},
                             {"path_efficiency", "", Prominence::trend}};
constexpr Placed kObserve[] = {{"mean_grip", "", Prominence::trend},
                               {"path_length", "", Prominence::trend},
                               {"contact_time", "", Prominence::trend}};

std::span<const Placed> places(const std::optional<TaskSpec>& spec) {
  if (!spec) return {};
  if (std::holds_alternative<RestSpec>(spec->kind)) return kRest;
  if (std::holds_alternative<MaximumSpec>(spec->kind)) return kMaximum;
  if (std::holds_alternative<ForceTrackingSpec>(spec->kind)) return kTracking;
  if (std::holds_alternative<PoseTargetsSpec>(spec->kind)) return kPoses;
  return kObserve;
}

std::string number(double value, bool with_sign) {
  const double size = std::abs(value);
  const int decimals = size == 0.0 ? 0 : size < 0.995 ? 3 : size < 9.995 ? 2 : size < 99.95 ? 1 : 0;
  char digits[48];
  std::snprintf(digits, sizeof digits, "%.*f", decimals, size);
  const bool is_zero = std::string_view(digits).find_first_not_of("0.") == std::string_view::npos;
  std::string text = digits;
  // Whole numbers are counts; decimals would promise a precision that they do not have.
  if (size == std::floor(size) && size < 1000.0) text = std::to_string(static_cast<int>(size));
  if (is_zero) return text;
  if (value < 0.0) return "\u2212" + text;
  return with_sign ? "+" + text : text;
}

}  // namespace

MeasureWords words_for(std::string_view name, std::string_view channel) {
  const auto* found = std::find_if(kEntries.begin(), kEntries.end(),
                                   [&](const Entry& entry) { return entry.name == name; });
  MeasureWords words;
  if (found != kEntries.end()) {
    words = {std::string(found->title), found->better, true, found->censored};
  } else {
    words.title = name;
    std::replace(words.title.begin(), words.title.end(), '_', ' ');
  }
  if (name == "completion_time" && channel.starts_with("target_"))
    words.title += " target " + std::string(channel.substr(std::string_view("target_").size()));
  return words;
}

std::string_view describe(Better better) noexcept {
  switch (better) {
    case Better::lower: return "lower is better";
    case Better::higher: return "higher is better";
    case Better::near_zero: return "nearer to zero is better";
    case Better::unknown: break;
  }
  return "";
}

PrintedUnit printed_unit(const std::string& unit) {
  if (unit == "rad") return {"°", 180.0 / std::numbers::pi};
  if (unit == "m") return {"mm", 1000.0};
  return {unit, 1.0};
}

std::string format_value(double value, const std::string& unit) {
  return number(value * printed_unit(unit).factor, false);
}
std::string format_change(double value, const std::string& unit) {
  return number(value * printed_unit(unit).factor, true);
}

Place place_of(const std::optional<TaskSpec>& spec, std::string_view name,
               std::string_view channel) {
  int rank = 0;
  for (const Placed& placed : places(spec)) {
    if (placed.name == name && (placed.channel.empty() || placed.channel == channel))
      return {placed.prominence, rank};
    ++rank;
  }
  return {};
}

}  // namespace isograsp
