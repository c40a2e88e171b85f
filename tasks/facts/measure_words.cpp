// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/facts/measure_words.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <utility>

#include "hand/force_channel.hpp"

namespace isograsp::tasks {

namespace {

/// Research measures answer questions about groups; a single patient's report leaves them out.
enum class Use : std::uint8_t { clinical, research };
/// A trial without value took longer than was waited.
enum class Time : std::uint8_t { whole, censored };

struct Entry {
  std::string_view name;
  std::string_view title;  ///< "force" reads "grip" where the grip is meant
  Better better;
  Use use = Use::clinical;
  Time time = Time::whole;
};
constexpr std::array kEntries{
    // How near to the target.
    Entry{"rmse", "Tracking error (RMS)", Better::lower},
    Entry{"relative_rmse", "Tracking error, relative", Better::lower},
    Entry{"mae", "Tracking error (mean)", Better::lower},
    Entry{"constant_error", "Constant error", Better::near_zero},
    Entry{"absolute_error", "Error of the force from memory", Better::lower},
    Entry{"variable_error", "Spread of the force from memory", Better::lower},
    Entry{"time_in_range", "Time on target", Better::higher},
    Entry{"corridor_rms", "Distance outside the corridor (RMS)", Better::lower},
    Entry{"corridor_distance", "Distance outside the corridor (mean)", Better::lower},
    Entry{"time_in_corridor", "Time in the corridor", Better::higher},
    Entry{"lag", "Lag behind the target", Better::near_zero},
    Entry{"lag_corrected", "Lag without the device's delay", Better::near_zero},
    Entry{"gain", "Gain", Better::unknown},
    Entry{"phase", "Phase of the answer", Better::near_zero, Use::research},
    Entry{"phase_lag", "Lag from the phase", Better::near_zero, Use::research},
    Entry{"pauses", "Pauses on the ramp", Better::lower},
    Entry{"pause_length", "Mean length of a pause", Better::lower},
    // How steady.
    Entry{"cv", "Unsteadiness (CV)", Better::lower},
    Entry{"cv_noise_floor", "CV of the empty device", Better::unknown},
    Entry{"force_sd", "Spread of the held force", Better::lower},
    Entry{"fall", "Fall of the held force", Better::near_zero},
    Entry{"sample_entropy", "Sample entropy", Better::unknown, Use::research},
    Entry{"power_0.1_0.3_Hz", "Share of very slow wander, 0.1 to 0.3 Hz", Better::unknown,
          Use::research},
    Entry{"power_0.5_0.8_Hz", "Share of slow correction, 0.5 to 0.8 Hz", Better::unknown,
          Use::research},
    Entry{"power_2_8_Hz", "Share of tremor, 2 to 8 Hz", Better::unknown, Use::research},
    Entry{"power_8_12_Hz", "Share of fast tremor, 8 to 12 Hz", Better::unknown, Use::research},
    // How strong.
    Entry{"maximum_force", "Maximum force above rest", Better::higher},
    Entry{"maximum_force_total", "Maximum force, total", Better::higher},
    Entry{"maximum_window_mean", "Maximum force, mean over a fixed window", Better::higher},
    Entry{"comfortable_force", "Comfortable force above rest", Better::unknown},
    Entry{"comfortable_force_total", "Comfortable force, total", Better::unknown},
    Entry{"opening_force", "Opening force", Better::higher},
    Entry{"peak_force", "Peak force", Better::unknown},
    Entry{"mean_force", "Mean force", Better::unknown},
    Entry{"mean_grip", "Mean grip", Better::unknown},
    Entry{"force_of_maximum", "Hardest effort, of the maximum force", Better::unknown},
    Entry{"resting_force", "Resting force", Better::near_zero},
    Entry{"peak_rate", "Fastest rise of force", Better::higher},
    Entry{"early_rate", "Rise of force in the first 0.2 s", Better::higher},
    Entry{"fatigue_slope", "Fading of the force", Better::near_zero},
    Entry{"endurance", "Endurance", Better::higher, Use::clinical, Time::censored},
    // How soon. A median over the cues, and how often it came at all.
    Entry{"reaction_time", "Reaction time", Better::lower, Use::clinical, Time::censored},
    Entry{"reaction_time_restricted", "Reaction time, misses at the limit", Better::lower},
    Entry{"reaction_time_share", "Cues answered", Better::higher},
    Entry{"reaction_time_corrected", "Reaction time without the device's delay", Better::lower,
          Use::clinical, Time::censored},
    Entry{"anticipations", "Answers before the cue could be seen", Better::lower},
    Entry{"t63", "Time to 63 % of the step", Better::lower, Use::research, Time::censored},
    Entry{"t63_restricted", "Time to 63 % of the step, misses at the limit", Better::lower,
          Use::research},
    Entry{"t63_share", "Steps that reached 63 %", Better::higher, Use::research},
    Entry{"settling_time", "Settling time", Better::lower, Use::clinical, Time::censored},
    Entry{"settling_time_restricted", "Settling time, misses at the limit", Better::lower},
    Entry{"settling_time_share", "Steps that settled", Better::higher},
    Entry{"rise_time", "Rise time, 10 to 90 %", Better::lower},
    Entry{"overshoot", "Overshoot", Better::lower},
    Entry{"release_initiation", "Time until letting go begins", Better::lower, Use::clinical,
          Time::censored},
    Entry{"release_initiation_restricted", "Time until letting go begins, misses at the limit",
          Better::lower},
    Entry{"release_initiation_share", "Cues to let go answered", Better::higher},
    Entry{"release_initiation_corrected",
          "Time until letting go begins, without the device's delay", Better::lower, Use::clinical,
          Time::censored},
    Entry{"release_time", "Release time", Better::lower, Use::clinical, Time::censored},
    Entry{"release_time_restricted", "Release time, misses at the limit", Better::lower},
    Entry{"release_time_share", "Releases completed", Better::higher},
    Entry{"release_time_corrected", "Release time without the device's delay", Better::lower,
          Use::clinical, Time::censored},
    Entry{"grips_missed", "Grips that were not made", Better::lower},
    Entry{"residual_force", "Force left 5 s after the cue", Better::lower},
    Entry{"fastest_release", "Fastest release", Better::higher},
    // How well the digits act apart, and where they push.
    Entry{"individuation_index", "Three-digit individuation", Better::higher},
    Entry{"individuation_slope", "Unasked force per force asked", Better::lower, Use::research},
    Entry{"enslaving", "Force of a digit that was not asked", Better::near_zero},
    Entry{"enslaving_of_maximum", "The same of that digit's maximum", Better::near_zero,
          Use::research},
    Entry{"rhythm", "Rhythm of the force", Better::unknown},
    Entry{"sharing", "Share of the force", Better::unknown},
    Entry{"thumb_opposition", "Thumb against the fingers", Better::unknown},
    Entry{"synergy_index", "Synergy of the fingers", Better::unknown, Use::research},
    Entry{"synergy_index_z", "Synergy of the fingers (z)", Better::unknown, Use::research},
    Entry{"variance_within", "Variance that leaves the sum alone", Better::unknown, Use::research},
    Entry{"variance_across", "Variance that changes the sum", Better::unknown, Use::research},
    Entry{"coflexion", "Unwanted flexion", Better::lower},
    Entry{"direction_error", "Direction error", Better::lower},
    Entry{"projection_ratio", "Useful share of the force", Better::higher},
    Entry{"path_deviation", "Detour of the forces", Better::lower},
    Entry{"net_push", "Push of the arm", Better::lower},
    Entry{"net_push_time", "Time with a push of more than 20 %", Better::lower},
    // Handling an object.
    Entry{"targets_reached", "Targets reached", Better::higher},
    Entry{"completion_time", "Time to reach", Better::lower, Use::clinical, Time::censored},
    Entry{"median_completion_time", "Median time to reach", Better::lower, Use::clinical,
          Time::censored},
    Entry{"restricted_mean_time", "Mean time, misses at the limit", Better::lower},
    Entry{"hold_error_position", "Hold error, position", Better::lower, Use::clinical,
          Time::censored},
    Entry{"hold_error_angle", "Hold error, angle", Better::lower, Use::clinical, Time::censored},
    Entry{"hold_error_axis", "Hold error, main axis", Better::lower, Use::clinical, Time::censored},
    Entry{"tilt_in_transport", "Tilt in transport", Better::lower},
    Entry{"path_length", "Path length", Better::unknown},
    Entry{"path_efficiency", "Directness of the path", Better::higher},
    Entry{"contact_time", "Time in contact", Better::unknown},
    Entry{"slip", "Slip", Better::lower},
    Entry{"drops", "Drops", Better::lower},
    // Neither too little nor too much: the safety margin, and what of the friction was used.
    Entry{"safety_margin", "Safety margin (virtual)", Better::unknown},
    Entry{"friction_utilisation", "Friction used (virtual)", Better::unknown},
    Entry{"grip_variation", "Variation of the grip", Better::lower},
    Entry{"impulse", "Impulse of the grip", Better::unknown},
    Entry{"lateral_correlation", "Sideways together", Better::unknown, Use::research},
    Entry{"grip_load_correlation", "Coupling of grip and load (virtual)", Better::higher},
    Entry{"grip_load_lag", "Lag of the grip behind the load", Better::near_zero},
    Entry{"grip_load_slope", "Grip per load (virtual)", Better::unknown},
    Entry{"sparc", "Smoothness (SPARC)", Better::near_zero},
    Entry{"ldlj", "Smoothness (log dimensionless jerk)", Better::near_zero, Use::research},
    Entry{"index_of_difficulty", "Index of difficulty", Better::unknown, Use::research},
    Entry{"throughput", "Throughput", Better::higher, Use::research},
};

/// Shares and indices: bounded, or logarithms already; their error is much the same wherever they
/// stand. Counts and shares of time that are often 0: an error that were a share of the mean would
/// vanish there, and 0 has no logarithm. Also all that is best near zero, and may be negative.
constexpr std::array<std::string_view, 15> kSteadyErrors{
    "time_in_range",         "time_in_corridor",
    "individuation_index",   "projection_ratio",
    "path_efficiency",       "targets_reached",
    "synergy_index",         "synergy_index_z",
    "grip_load_correlation", "pauses",
    "anticipations",         "drops",
    "net_push_time",         "slip",
    "grips_missed"};

/// Differences of logarithms, correlations, shares with a sign: zero is no end of their scale. What
/// is best near zero is judged by its distance, which has one.
constexpr std::array<std::string_view, 5> kBelowZero{"individuation_index", "projection_ratio",
                                                     "synergy_index", "synergy_index_z",
                                                     "grip_load_correlation"};

/// Channels that need no word: the only one of their measure, or the one that is usual.
constexpr std::array<std::string_view, 10> kPlainChannels{
    "force", "grip",    "platform", "digits",    "position",
    "angle", "targets", "contact",  "transport", ""};
/// Parts of a force target; turns of an object.
constexpr std::pair<std::string_view, std::string_view> kParts[] = {
    {"rx", ", turn about x"},        {"ry", ", turn about y"},    {"rz", ", turn about z"},
    {"force_rise", ", building up"}, {"force_hold", ", holding"}, {"force_fall", ", letting down"},
    {"force_rate", " of the force"}};

std::string digits_words(Digits digits) {
  switch (digits) {
    case Digits::grip: return "grip";
    case Digits::grip_mean: return "mean of thumb and fingers";
    case Digits::pinch: return "thumb and index";
    case Digits::sum: return "all digits";
    case Digits::thumb: return "thumb";
    case Digits::index: return "index";
    case Digits::middle: return "middle";
  }
  return "";
}

std::string force_words(ForceChannel channel) {
  const std::string digits = digits_words(channel.digits);
  if (channel.direction == Direction::plus_z) return digits;
  if (channel.direction == Direction::minus_z)
    return channel.digits == Digits::grip ? "opening" : digits + " opening";
  const std::string name = name_of(channel);  // "thumb_-x"
  return digits + " toward " + name.substr(name.size() - 2);
}

/// What stands behind the title: ", thumb", " at 25 %", " target 3".
std::string channel_words(std::string_view channel) {
  if (std::find(kPlainChannels.begin(), kPlainChannels.end(), channel) != kPlainChannels.end())
    return "";
  for (const auto& [part, words] : kParts)
    if (channel == part) return std::string(words);
  if (const auto force = force_channel_from_name(channel)) return ", " + force_words(*force);
  std::string text(channel);
  std::replace(text.begin(), text.end(), '_', ' ');
  if (const auto to = text.find(" to "); to != std::string::npos)  // instructed, other digit
    return ", " + text.substr(to + 4) + " while " + text.substr(0, to) + " presses";
  if (text.starts_with("force ")) {  // "force_25_percent", "force_5_N", "force_0.2_Hz"
    text = text.substr(std::string_view("force ").size());
    if (const auto percent = text.find("percent"); percent != std::string::npos)
      text.replace(percent, std::string::npos, "%");
    return " at " + text;
  }
  return text.starts_with("target ") ? " " + text : ", " + text;
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

MeasureWords words_of(std::string_view name, std::string_view channel) {
  const auto* found = std::find_if(kEntries.begin(), kEntries.end(),
                                   [&](const Entry& entry) { return entry.name == name; });
  MeasureWords words;
  if (found != kEntries.end()) {
    words = {std::string(found->title), found->better, found->use == Use::clinical,
             found->time == Time::censored};
  } else {
    words.title = name;
    std::replace(words.title.begin(), words.title.end(), '_', ' ');
  }
  words.error_grows =
      words.better != Better::near_zero && !name.ends_with("_share") &&
      std::find(kSteadyErrors.begin(), kSteadyErrors.end(), name) == kSteadyErrors.end();
  words.below_zero = std::find(kBelowZero.begin(), kBelowZero.end(), name) != kBelowZero.end();
  constexpr std::string_view kForce = "force";
  const auto force = words.title.find(kForce);
  if (channel == "grip" && force != std::string::npos)
    words.title.replace(force, kForce.size(), "grip");
  if (name != "opening_force") words.title += channel_words(channel);  // its name says it all
  return words;
}

std::vector<std::string_view> worded_measures() {
  std::vector<std::string_view> names;
  for (const Entry& entry : kEntries) names.push_back(entry.name);
  return names;
}

std::string_view words_of(Better better) noexcept {
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

}  // namespace isograsp::tasks
