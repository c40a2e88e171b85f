// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/facts/measure_words.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <optional>
#include <utility>

#include "hand/force_channel.hpp"
#include "tasks/questions/questionnaire.hpp"

namespace isograsp::tasks {

namespace {

/// Research measures answer questions about groups; a single patient's report leaves them out.
enum class Use : std::uint8_t { clinical, research };
/// censored: a trial without value took longer than the time waited.
enum class Time : std::uint8_t { whole, censored };

struct Entry {
  std::string_view name;
  Words title;
  Better better;
  Use use = Use::clinical;
  Time time = Time::whole;
  std::optional<Words> of_grip = std::nullopt;  ///< the title where the force is that of the grip
};
constexpr std::array kEntries{
    // How near to the target.
    Entry{"rmse", "Tracking error (RMS)"_text, Better::lower},
    Entry{"relative_rmse", "Tracking error, relative"_text, Better::lower},
    Entry{"mae", "Tracking error (mean)"_text, Better::lower},
    Entry{"constant_error", "Constant error"_text, Better::near_zero},
    Entry{"absolute_error", "Error of the force from memory"_text, Better::lower, Use::clinical,
          Time::whole, "Error of the grip from memory"_text},
    Entry{"variable_error", "Spread of the force from memory"_text, Better::lower, Use::clinical,
          Time::whole, "Spread of the grip from memory"_text},
    Entry{"time_in_range", "Time on target"_text, Better::higher},
    Entry{"corridor_rms", "Distance outside the corridor (RMS)"_text, Better::lower},
    Entry{"corridor_distance", "Distance outside the corridor (mean)"_text, Better::lower},
    Entry{"time_in_corridor", "Time in the corridor"_text, Better::higher},
    Entry{"lag", "Lag behind the target"_text, Better::near_zero},
    Entry{"lag_corrected", "Lag without the device's delay"_text, Better::near_zero},
    Entry{"gain", "Gain"_text, Better::unknown},
    Entry{"phase", "Phase of the answer"_text, Better::near_zero, Use::research},
    Entry{"phase_lag", "Lag from the phase"_text, Better::near_zero, Use::research},
    Entry{"pauses", "Pauses on the ramp"_text, Better::lower},
    Entry{"pause_length", "Mean length of a pause"_text, Better::lower},
    // How steady.
    Entry{"cv", "Unsteadiness (CV)"_text, Better::lower},
    Entry{"cv_noise_floor", "CV of the empty device"_text, Better::unknown},
    Entry{"force_sd", "Spread of the held force"_text, Better::lower, Use::clinical, Time::whole,
          "Spread of the held grip"_text},
    Entry{"fall", "Fall of the held force"_text, Better::near_zero, Use::clinical, Time::whole,
          "Fall of the held grip"_text},
    Entry{"sample_entropy", "Sample entropy"_text, Better::unknown, Use::research},
    Entry{"power_0.1_0.3_Hz", "Share of very slow wander, 0.1 to 0.3 Hz"_text, Better::unknown,
          Use::research},
    Entry{"power_0.5_0.8_Hz", "Share of slow correction, 0.5 to 0.8 Hz"_text, Better::unknown,
          Use::research},
    Entry{"power_2_8_Hz", "Share of tremor, 2 to 8 Hz"_text, Better::unknown, Use::research},
    Entry{"power_8_12_Hz", "Share of fast tremor, 8 to 12 Hz"_text, Better::unknown, Use::research},
    // How strong.
    Entry{"maximum_force", "Maximum force above rest"_text, Better::higher, Use::clinical,
          Time::whole, "Maximum grip above rest"_text},
    Entry{"maximum_force_total", "Maximum force, total"_text, Better::higher, Use::clinical,
          Time::whole, "Maximum grip, total"_text},
    Entry{"maximum_window_mean", "Maximum force, mean over a fixed window"_text, Better::higher,
          Use::clinical, Time::whole, "Maximum grip, mean over a fixed window"_text},
    Entry{"comfortable_force", "Comfortable force above rest"_text, Better::unknown, Use::clinical,
          Time::whole, "Comfortable grip above rest"_text},
    Entry{"comfortable_force_total", "Comfortable force, total"_text, Better::unknown,
          Use::clinical, Time::whole, "Comfortable grip, total"_text},
    Entry{"opening_force", "Opening force"_text, Better::higher, Use::clinical, Time::whole,
          "Opening grip"_text},
    Entry{"peak_force", "Peak force"_text, Better::unknown, Use::clinical, Time::whole,
          "Peak grip"_text},
    Entry{"mean_force", "Mean force"_text, Better::unknown, Use::clinical, Time::whole,
          "Mean grip"_text},
    Entry{"mean_grip", "Mean grip"_text, Better::unknown},
    Entry{"force_of_maximum", "Hardest effort, of the maximum force"_text, Better::unknown,
          Use::clinical, Time::whole, "Hardest effort, of the maximum grip"_text},
    Entry{"resting_force", "Resting force"_text, Better::near_zero, Use::clinical, Time::whole,
          "Resting grip"_text},
    Entry{"peak_rate", "Fastest rise of force"_text, Better::higher, Use::clinical, Time::whole,
          "Fastest rise of grip"_text},
    Entry{"early_rate", "Rise of force in the first 0.2 s"_text, Better::higher, Use::clinical,
          Time::whole, "Rise of grip in the first 0.2 s"_text},
    Entry{"fatigue_slope", "Fading of the force"_text, Better::near_zero, Use::clinical,
          Time::whole, "Fading of the grip"_text},
    Entry{"endurance", "Endurance"_text, Better::higher, Use::clinical, Time::censored},
    // How soon: a median over the cues, and how often the event came at all.
    Entry{"reaction_time", "Reaction time"_text, Better::lower, Use::clinical, Time::censored},
    Entry{"reaction_time_restricted", "Reaction time, misses at the limit"_text, Better::lower},
    Entry{"reaction_time_share", "Cues answered"_text, Better::higher},
    Entry{"reaction_time_corrected", "Reaction time without the device's delay"_text, Better::lower,
          Use::clinical, Time::censored},
    Entry{"anticipations", "Answers before the cue could be seen"_text, Better::lower},
    Entry{"t63", "Time to 63 % of the step"_text, Better::lower, Use::research, Time::censored},
    Entry{"t63_restricted", "Time to 63 % of the step, misses at the limit"_text, Better::lower,
          Use::research},
    Entry{"t63_share", "Steps that reached 63 %"_text, Better::higher, Use::research},
    Entry{"settling_time", "Settling time"_text, Better::lower, Use::clinical, Time::censored},
    Entry{"settling_time_restricted", "Settling time, misses at the limit"_text, Better::lower},
    Entry{"settling_time_share", "Steps that settled"_text, Better::higher},
    Entry{"rise_time", "Rise time, 10 to 90 %"_text, Better::lower},
    Entry{"overshoot", "Overshoot"_text, Better::lower},
    Entry{"release_initiation", "Time until letting go begins"_text, Better::lower, Use::clinical,
          Time::censored},
    Entry{"release_initiation_restricted", "Time until letting go begins, misses at the limit"_text,
          Better::lower},
    Entry{"release_initiation_share", "Cues to let go answered"_text, Better::higher},
    Entry{"release_initiation_corrected",
          "Time until letting go begins, without the device's delay"_text, Better::lower,
          Use::clinical, Time::censored},
    Entry{"release_time", "Release time"_text, Better::lower, Use::clinical, Time::censored},
    Entry{"release_time_restricted", "Release time, misses at the limit"_text, Better::lower},
    Entry{"release_time_share", "Releases completed"_text, Better::higher},
    Entry{"release_time_corrected", "Release time without the device's delay"_text, Better::lower,
          Use::clinical, Time::censored},
    Entry{"grips_missed", "Grips that were not made"_text, Better::lower},
    Entry{"residual_force", "Force left 5 s after the cue"_text, Better::lower},
    Entry{"fastest_release", "Fastest release"_text, Better::higher},
    // How well the digits act apart, and where they push.
    Entry{"individuation_index", "Three-digit individuation"_text, Better::higher},
    Entry{"individuation_slope", "Unasked force per force asked"_text, Better::lower, Use::research,
          Time::whole, "Unasked grip per force asked"_text},
    Entry{"enslaving", "Force of a digit that was not asked"_text, Better::near_zero},
    Entry{"enslaving_of_maximum", "The same of that digit's maximum"_text, Better::near_zero,
          Use::research},
    Entry{"rhythm", "Rhythm of the force"_text, Better::unknown, Use::clinical, Time::whole,
          "Rhythm of the grip"_text},
    Entry{"sharing", "Share of the force"_text, Better::unknown, Use::clinical, Time::whole,
          "Share of the grip"_text},
    Entry{"thumb_opposition", "Thumb against the fingers"_text, Better::unknown},
    Entry{"synergy_index", "Synergy of the fingers"_text, Better::unknown, Use::research},
    Entry{"synergy_index_z", "Synergy of the fingers (z)"_text, Better::unknown, Use::research},
    Entry{"variance_within", "Variance that leaves the sum alone"_text, Better::unknown,
          Use::research},
    Entry{"variance_across", "Variance that changes the sum"_text, Better::unknown, Use::research},
    Entry{"coflexion", "Unwanted flexion"_text, Better::lower},
    Entry{"direction_error", "Direction error"_text, Better::lower},
    Entry{"projection_ratio", "Useful share of the force"_text, Better::higher, Use::clinical,
          Time::whole, "Useful share of the grip"_text},
    Entry{"path_deviation", "Detour of the forces"_text, Better::lower, Use::clinical, Time::whole,
          "Detour of the grips"_text},
    Entry{"net_push", "Push of the arm"_text, Better::lower},
    Entry{"net_push_time", "Time with a push of more than 20 %"_text, Better::lower},
    // Handling an object.
    Entry{"targets_reached", "Targets reached"_text, Better::higher},
    Entry{"completion_time", "Time to reach"_text, Better::lower, Use::clinical, Time::censored},
    Entry{"median_completion_time", "Median time to reach"_text, Better::lower, Use::clinical,
          Time::censored},
    Entry{"restricted_mean_time", "Mean time, misses at the limit"_text, Better::lower},
    Entry{"hold_error_position", "Hold error, position"_text, Better::lower, Use::clinical,
          Time::censored},
    Entry{"hold_error_angle", "Hold error, angle"_text, Better::lower, Use::clinical,
          Time::censored},
    Entry{"hold_error_axis", "Hold error, main axis"_text, Better::lower, Use::clinical,
          Time::censored},
    Entry{"tilt_in_transport", "Tilt in transport"_text, Better::lower},
    Entry{"path_length", "Path length"_text, Better::unknown},
    Entry{"path_efficiency", "Directness of the path"_text, Better::higher},
    // Turning a real object with the arm.
    Entry{"movement_time", "Time of the movement"_text, Better::lower, Use::clinical,
          Time::censored},
    Entry{"recognition_time", "Time until the object turns"_text, Better::unknown, Use::research},
    Entry{"position_error", "Error of the place"_text, Better::lower, Use::clinical,
          Time::censored},
    Entry{"angle_error", "Error of the turn"_text, Better::lower, Use::clinical, Time::censored},
    Entry{"active_range", "Active range"_text, Better::higher},
    Entry{"least_angle", "Least angle"_text, Better::unknown},
    Entry{"largest_angle", "Largest angle"_text, Better::unknown},
    Entry{"rotation", "Turn"_text, Better::unknown, Use::research},
    Entry{"relative_rotation", "Share of its turn when the forearm has 63 %"_text, Better::unknown,
          Use::research},
    Entry{"rotation_t10", "Time to 10 % of its turn"_text, Better::unknown, Use::research},
    Entry{"rotation_t63", "Time to 63 % of its turn"_text, Better::unknown, Use::research},
    // Drinking from a glass.
    Entry{"total_movement_time", "Time of the whole movement"_text, Better::lower},
    Entry{"phase_time", "Time of the phase"_text, Better::unknown},
    Entry{"trunk_displacement", "Movement of the trunk"_text, Better::lower},
    Entry{"peak_velocity", "Largest speed of the hand"_text, Better::unknown, Use::research},
    Entry{"time_to_peak_velocity", "Time to the largest speed, of the phase"_text, Better::unknown,
          Use::research},
    Entry{"movement_units", "Movement units"_text, Better::unknown, Use::research},
    Entry{"reach", "Largest distance of hand and trunk"_text, Better::unknown, Use::research},
    Entry{"elbow_extension", "Largest angle of the elbow"_text, Better::unknown, Use::research},
    Entry{"elbow_extension_rate", "Fastest stretching of the elbow"_text, Better::unknown,
          Use::research},
    // Two hands that press together.
    Entry{"share_affected", "Share of the affected hand"_text, Better::unknown},
    Entry{"asymmetry", "Asymmetry of the hands"_text, Better::near_zero},
    Entry{"effort_share_affected", "Share of the effort, affected hand"_text, Better::unknown},
    Entry{"force_above_rest", "Mean force above rest"_text, Better::unknown},
    Entry{"bilateral_force", "Maximum force beside the other hand"_text, Better::higher},
    Entry{"bilateral_deficit", "Bilateral index (below 0: deficit)"_text, Better::unknown},
    Entry{"mirror_force", "Overflow into the hand at rest"_text, Better::unknown, Use::research},
    Entry{"hand_correlation", "Correlation of the hands"_text, Better::unknown, Use::research},
    Entry{"hand_lag", "Lag of the affected hand behind the other"_text, Better::near_zero,
          Use::research},
    Entry{"hand_lag_correlation", "Correlation of the hands at that lag"_text, Better::unknown,
          Use::research},
    Entry{"hand_synergy", "Synergy of the hands"_text, Better::unknown, Use::research},
    Entry{"cancelled_share", "Pushes that the hands take from each other"_text, Better::unknown,
          Use::research},
    // Two hands that lift an object.
    Entry{"object_tilt", "Tilt of the object"_text, Better::lower},
    Entry{"object_tilt_mean", "Side of the tilt (above 0: right end higher)"_text,
          Better::near_zero},
    Entry{"least_squeeze", "Least squeeze"_text, Better::unknown},
    Entry{"raise_above_rest", "Mean push up, above rest"_text, Better::unknown},
    Entry{"raise_share_affected", "Share of the raising, affected hand"_text, Better::unknown},
    Entry{"squeeze_above_rest", "Mean squeeze, above rest"_text, Better::unknown},
    Entry{"squeeze_share_affected", "Share of the squeeze, affected hand"_text, Better::unknown},
    Entry{"path_share_affected", "Share of the way, affected hand"_text, Better::unknown,
          Use::research},
    // A tracked hand: all of it research, a tracker is too coarse for a verdict.
    Entry{"largest_gap", "Largest gap of thumb and index finger"_text, Better::unknown,
          Use::research},
    Entry{"flexion_range", "Range of flexion"_text, Better::unknown, Use::research},
    Entry{"hand_openings", "Times the hand opened"_text, Better::unknown, Use::research},
    Entry{"hand_closings", "Times the hand closed"_text, Better::unknown, Use::research},
    Entry{"hand_opening_time", "Time until the hand is open"_text, Better::unknown, Use::research,
          Time::censored},
    Entry{"hand_opening_time_restricted", "Time until the hand is open, misses at the limit"_text,
          Better::unknown, Use::research},
    Entry{"hand_opening_time_share", "Openings made"_text, Better::unknown, Use::research},
    Entry{"hand_closing_time", "Time until the hand is closed"_text, Better::unknown, Use::research,
          Time::censored},
    Entry{"hand_closing_time_restricted", "Time until the hand is closed, misses at the limit"_text,
          Better::unknown, Use::research},
    Entry{"hand_closing_time_share", "Closings made"_text, Better::unknown, Use::research},
    Entry{"placements_completed", "Objects placed"_text, Better::unknown, Use::research},
    Entry{"placement_fails", "Virtual objects dropped"_text, Better::unknown, Use::research},
    Entry{"placements_not_scored", "Placements without the hand in sight"_text, Better::unknown,
          Use::research},
    Entry{"manipulation_time", "Time until the object is at its target"_text, Better::unknown,
          Use::research, Time::censored},
    Entry{"manipulation_time_restricted",
          "Time until the object is at its target, misses at the limit"_text, Better::unknown,
          Use::research},
    Entry{"manipulation_time_share", "Placements completed"_text, Better::unknown, Use::research},
    Entry{"placement_distance", "Distance from the target in the hold"_text, Better::unknown,
          Use::research},
    Entry{"placement_axis_angle", "Angle of the main axis in the hold"_text, Better::unknown,
          Use::research},
    Entry{"placement_angle", "Angle from the target in the hold"_text, Better::unknown,
          Use::research},
    Entry{"object_release_time", "Time until the hand has let go"_text, Better::unknown,
          Use::research, Time::censored},
    Entry{"object_release_time_restricted",
          "Time until the hand has let go, misses at the limit"_text, Better::unknown,
          Use::research},
    Entry{"object_release_time_share", "Objects let go"_text, Better::unknown, Use::research},
    Entry{"releases_helped", "Objects let go for the person"_text, Better::unknown, Use::research},
    Entry{"seen", "Time in sight of the cameras"_text, Better::unknown},
    Entry{"contact_time", "Time in contact"_text, Better::unknown},
    Entry{"slip", "Slip"_text, Better::lower},
    Entry{"drops", "Drops"_text, Better::lower},
    // A grip neither too weak nor too strong: the safety margin, and the used share of the
    // friction.
    Entry{"safety_margin", "Safety margin (virtual)"_text, Better::unknown},
    Entry{"friction_utilisation", "Friction used (virtual)"_text, Better::unknown},
    Entry{"grip_variation", "Variation of the grip"_text, Better::lower},
    Entry{"impulse", "Impulse of the grip"_text, Better::unknown},
    Entry{"lateral_correlation", "Sideways together"_text, Better::unknown, Use::research},
    Entry{"grip_load_correlation", "Coupling of grip and load (virtual)"_text, Better::higher},
    Entry{"grip_load_lag", "Lag of the grip behind the load"_text, Better::near_zero},
    Entry{"grip_load_slope", "Grip per load (virtual)"_text, Better::unknown},
    Entry{"sparc", "Smoothness (SPARC)"_text, Better::near_zero},
    Entry{"ldlj", "Smoothness (log dimensionless jerk)"_text, Better::near_zero, Use::research},
    Entry{"index_of_difficulty", "Index of difficulty"_text, Better::unknown, Use::research},
    Entry{"throughput", "Throughput"_text, Better::higher, Use::research},
};

/// Measures whose error is much the same for small and large values. Shares and indices are
/// bounded, or are logarithms already. Counts and shares of time are often 0: an error proportional
/// to the mean would vanish there, and 0 has no logarithm. Also all measures that are best near
/// zero and may be negative.
constexpr std::array<std::string_view, 16> kSteadyErrors{"seen",
                                                         "time_in_range",
                                                         "time_in_corridor",
                                                         "individuation_index",
                                                         "projection_ratio",
                                                         "path_efficiency",
                                                         "targets_reached",
                                                         "synergy_index",
                                                         "synergy_index_z",
                                                         "grip_load_correlation",
                                                         "pauses",
                                                         "anticipations",
                                                         "drops",
                                                         "net_push_time",
                                                         "slip",
                                                         "grips_missed"};

/// Differences of logarithms, correlations and shares with a sign: their scale does not end at
/// zero. A measure that is best near zero is judged by its distance from zero, whose scale does.
constexpr std::array<std::string_view, 11> kBelowZero{
    "least_angle",       "largest_angle",    "individuation_index",   "projection_ratio",
    "synergy_index",     "synergy_index_z",  "grip_load_correlation", "force_above_rest",
    "bilateral_deficit", "raise_above_rest", "squeeze_above_rest"};

/// Channels that need no word: the only one of their measure, or the one that is usual.
constexpr std::array<std::string_view, 16> kPlainChannels{
    "force",   "grip",      "platform", "digits", "position", "angle", "targets", "thumb_index",
    "contact", "transport", "object",   "task",   "trunk",    "total", "both",    ""};
/// Parts of a force target; turns of an object; links of an arm; phases of drinking.
constexpr std::pair<std::string_view, Words> kParts[] = {
    {"rx", ", turn about x"_text},
    {"ry", ", turn about y"_text},
    {"rz", ", turn about z"_text},
    {"force_rise", ", building up"_text},
    {"force_hold", ", holding"_text},
    {"force_fall", ", letting down"_text},
    {"force_rate", " of the force"_text},
    {"opening", ", opening"_text},
    {"left", ", left hand"_text},
    {"right", ", right hand"_text},
    {"forearm", ", forearm"_text},
    {"wrist", ", wrist"_text},
    {"fingers", ", fingers"_text},
    {"attitude", ", turn"_text},
    {"ring", ", ring finger"_text},
    {"little", ", little finger"_text},
    {"full", ", with help"_text},
    {"softer", ", with half the help"_text},
    {"off", ", without help"_text},
    {"full_eased", ", with help, eased"_text},
    {"softer_eased", ", with half the help, eased"_text},
    {"reaching", ", reaching"_text},
    {"forward_transport", ", bringing it to the mouth"_text},
    {"drinking", ", drinking"_text},
    {"back_transport", ", putting it back"_text},
    {"returning", ", returning"_text},
    {"reaching_forward", ", until drinking"_text},
    {"back_returning", ", after drinking"_text}};

Words digits_words(Digits digits) {
  switch (digits) {
    case Digits::grip: return "grip"_text;
    case Digits::grip_mean: return "mean of thumb and fingers"_text;
    case Digits::pinch: return "thumb and index"_text;
    case Digits::sum: return "all digits"_text;
    case Digits::thumb: return "thumb"_text;
    case Digits::index: return "index"_text;
    case Digits::middle: break;
  }
  return "middle"_text;
}

Text force_words(ForceChannel channel) {
  const Words digits = digits_words(channel.digits);
  if (channel.direction == Direction::plus_z) return ", %1"_text(digits);
  if (channel.direction == Direction::minus_z) return ", %1 opening"_text(digits);
  const std::string name = name_of(channel);  // "thumb_-x"
  return ", %1 toward %2"_text(digits, name.substr(name.size() - 2));
}

Text while_presses(Words other, Finger instructed) {
  switch (instructed) {
    case Finger::thumb: return ", %1 while thumb presses"_text(other);
    case Finger::index: return ", %1 while index presses"_text(other);
    case Finger::middle: break;
  }
  return ", %1 while middle presses"_text(other);
}

/// "force_25_percent", "force_5_N", "force_0.2_Hz"; nothing: it is no level.
std::optional<Text> level_words(std::string_view channel) {
  constexpr std::string_view kForce = "force_";
  const auto unit = channel.rfind('_');
  if (!channel.starts_with(kForce) || unit < kForce.size()) return std::nullopt;
  const Number level{std::string(channel.substr(kForce.size(), unit - kForce.size()))};
  const std::string_view of = channel.substr(unit + 1);
  if (of == "percent") return " at %1 %"_text(level);
  if (of == "N") return " at %1 N"_text(level);
  if (of == "Hz") return " at %1 Hz"_text(level);
  return std::nullopt;
}

std::optional<Words> finger_words(std::string_view name) {
  const auto finger = finger_from_name(name);
  return finger ? std::optional(digits_words(channel_of(*finger).digits)) : std::nullopt;
}

/// What stands behind the title: ", thumb", " at 25 %", " target 3".
Text channel_words(std::string_view measure, std::string_view channel) {
  // Of a record of two hands; elsewhere "sum" is that of the digits.
  if (measure == "rmse" && channel == "sum") return ", both hands together"_text;
  if (std::find(kPlainChannels.begin(), kPlainChannels.end(), channel) != kPlainChannels.end())
    return {};
  for (const auto& [part, words] : kParts)
    if (channel == part) return words;
  if (const auto force = force_channel_from_name(channel)) return force_words(*force);
  if (const auto level = level_words(channel)) return *level;
  constexpr std::string_view kTarget = "target_";
  if (channel.starts_with(kTarget))
    return " target %1"_text(Number{std::string(channel.substr(kTarget.size()))});
  constexpr std::string_view kTo = "_to_";
  if (const auto to = channel.find(kTo); to != std::string_view::npos) {
    const auto instructed = finger_from_name(channel.substr(0, to));
    const auto other = finger_words(channel.substr(to + kTo.size()));
    if (instructed && other) return while_presses(*other, *instructed);
  }
  if (const auto axis = channel.find('_'); axis != std::string_view::npos)  // "thumb_fz"
    if (const auto finger = finger_words(channel.substr(0, axis)))
      return ", %1 %2"_text(*finger, std::string(channel.substr(axis + 1)));
  std::string text(channel);
  std::replace(text.begin(), text.end(), '_', ' ');
  return ", %1"_text(text);
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
    words = {channel == "grip" ? found->of_grip.value_or(found->title) : found->title,
             found->better, found->use == Use::clinical, found->time == Time::censored};
  } else if (const auto asked = question_named(name)) {
    words.title = asked->question->title;
  } else {
    std::string own(name);
    std::replace(own.begin(), own.end(), '_', ' ');
    words.title = Known{std::move(own)};
  }
  words.error_grows =
      words.better != Better::near_zero && !name.ends_with("_share") &&
      std::find(kSteadyErrors.begin(), kSteadyErrors.end(), name) == kSteadyErrors.end();
  words.below_zero = std::find(kBelowZero.begin(), kBelowZero.end(), name) != kBelowZero.end();
  Text behind = channel_words(name, channel);
  if (!behind.empty() && name != "opening_force")  // the title of this measure is enough
    words.title = "%1%2"_text(std::move(words.title), std::move(behind));
  return words;
}

std::vector<std::string_view> worded_measures() {
  std::vector<std::string_view> names;
  for (const Entry& entry : kEntries) names.push_back(entry.name);
  return names;
}

PrintedUnit printed_unit(const std::string& unit) {
  if (unit == "rad") return {"°", 180.0 / std::numbers::pi};
  if (unit == "m") return {"mm", 1000.0};
  return {unit, 1.0};
}

Text unit_words(const std::string& printed_unit) {
  constexpr std::string_view kOf = "of ";
  if (printed_unit.starts_with(kOf)) return "of %1"_text(printed_unit.substr(kOf.size()));
  if (printed_unit == "blocks") return "blocks"_text;
  return printed_unit.empty() ? Text() : "%1"_text(printed_unit);
}

std::string format_value(double value, const std::string& unit) {
  return number(value * printed_unit(unit).factor, false);
}
std::string format_change(double value, const std::string& unit) {
  return number(value * printed_unit(unit).factor, true);
}

}  // namespace isograsp::tasks
