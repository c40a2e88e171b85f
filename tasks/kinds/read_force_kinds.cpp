// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>

#include "core/csv.hpp"
#include "tasks/kinds/read_kinds.hpp"
#include "tasks/waveform.hpp"

namespace isograsp::tasks {

double read_within(TomlReader& reader, std::string_view key, double least, double most,
                   std::optional<double> fallback) {
  const double value = reader.number(key, fallback);
  if (reader.has(key) && !(value >= least && value <= most))
    reader.fail(key, format_number(value) + " is out of range",
                "write a number from " + format_number(least) + " to " + format_number(most));
  return value;
}

double read_duration(TomlReader& reader, std::string_view key, double fallback) {
  const double value = read_within(reader, key, 0.0, kLongestPart_s, fallback);
  if (reader.has(key) && value == 0.0)
    reader.fail(key, "0 is out of range", "write a number above 0");
  return value;
}

double read_wait(TomlReader& reader, std::string_view key, double fallback) {
  return read_within(reader, key, 0.0, kLongestPart_s, fallback);
}

int read_count(TomlReader& reader, std::string_view key, int fallback, int most) {
  const auto count = reader.integer(key, fallback);
  if (count >= 1 && count <= most) return static_cast<int>(count);
  reader.fail(key, std::to_string(count) + " is out of range",
              "write a whole number from 1 to " + std::to_string(most));
  return 1;
}

namespace {

constexpr double kLeast_Hz = 0.001;
constexpr double kMost_Hz = 5.0;  ///< beyond what a hand can follow
constexpr int kMostRepetitions = 100;
constexpr int kMostForms = 100;
constexpr std::size_t kMostLevels = 50;
constexpr double kMostLevel_N = 300.0;  ///< range of the largest sensors

ForceChannel read_channel(TomlReader& reader) {
  const std::string name = reader.text("channel", "grip");
  if (const auto channel = force_channel_from_name(name)) return *channel;
  reader.fail("channel", "'" + name + "' is not a force",
              "write grip, grip_mean, pinch, sum, thumb, index, middle, opening, "
              "index_opening or e.g. thumb_-x");
  return {};
}

Aim read_aim(TomlReader& reader, bool with_channel = true) {
  constexpr double kMostBand = 0.5;
  constexpr double kMostPreview_s = 60.0;
  constexpr double kMostGain_deg = 90.0;
  Aim aim;
  if (with_channel) aim.channel = read_channel(reader);
  aim.scale = static_cast<Scale>(
      reader.choice("scale", {"newton", "maximum", "comfortable", "baseline"}, 1));
  aim.band_fraction = read_within(reader, "band_fraction", 0.01, kMostBand, aim.band_fraction);
  aim.force_shown = reader.boolean("force_shown", true);
  aim.preview_s = read_within(reader, "preview_s", 0.0, kMostPreview_s, 0.0);
  const char* gain = aim.scale == Scale::newton ? "gain_deg_per_N" : "gain_deg_per_unit";
  if (reader.has(gain)) aim.gain_deg = read_within(reader, gain, 0.001, kMostGain_deg);
  aim.viewing_distance_m =
      read_within(reader, "viewing_distance_m", 0.2, 5.0, aim.viewing_distance_m);
  return aim;
}

/// "least" is read as least_N or least_fraction, as the scale demands. Opening levels are positive
/// in an opening channel; a signed channel takes negative ones.
double read_level(TomlReader& reader, const Aim& aim, const std::string& name, double fallback) {
  const bool newton = aim.scale == Scale::newton;
  const double most = newton ? kMostLevel_N : 1.0;
  if (newton) return read_within(reader, name + "_N", -most, most);
  return read_within(reader, name + "_fraction", -most, most, fallback);
}

std::vector<double> read_levels(TomlReader& reader, const Aim& aim, const std::string& name,
                                std::vector<double> fallback) {
  const bool newton = aim.scale == Scale::newton;
  const std::string key = name + (newton ? "_N" : "_fractions");
  if (!newton && !reader.has(key)) return fallback;
  auto levels = reader.numbers(key, 1, kMostLevels);
  const double most = newton ? kMostLevel_N : 1.0;
  for (const double level : levels)
    if (!(std::abs(level) <= most))
      reader.fail(key, format_number(level) + " is out of range",
                  "write numbers up to " + format_number(most));
  return levels;
}

std::vector<Finger> read_digits(TomlReader& reader, std::string_view key) {
  if (!reader.has(key)) return {kFingers.begin(), kFingers.end()};
  std::vector<Finger> digits;
  for (const std::string& name : reader.texts(key)) {
    if (const auto finger = finger_from_name(name))
      digits.push_back(*finger);
    else
      reader.fail(key, "'" + name + "' is not a digit", "write thumb, index or middle");
  }
  if (digits.empty()) reader.fail(key, "is empty", "name at least one digit");
  return digits;
}

void read_waits(TomlReader& reader, double& least_s, double& most_s) {
  least_s = read_wait(reader, "least_wait_s", least_s);
  most_s = read_wait(reader, "most_wait_s", most_s);
  if (most_s < least_s) reader.fail("most_wait_s", "is below least_wait_s", "write a longer time");
}

void read_csv_data(TomlReader& reader, Waveform& waveform) {
  waveform.csv = reader.text("csv");
  if (!reader.has("csv_data")) return;  // put there when the task is loaded
  TomlReader data = reader.table("csv_data");
  constexpr std::size_t kMostPoints = 100'000;
  waveform.t_s = data.numbers("t_s", 2, kMostPoints);
  waveform.values = data.numbers("target", 2, kMostPoints);
  if (waveform.t_s.size() != waveform.values.size())
    return data.fail("target", "has another length than t_s", "write one value per time");
  for (std::size_t k = 1; k < waveform.t_s.size(); ++k)
    if (!(waveform.t_s[k] > waveform.t_s[k - 1]))
      return data.fail("t_s", "does not increase", "sort the times");
  for (const double value : waveform.values)
    if (!(value >= 0.0 && value <= 1.0))
      return data.fail("target", format_number(value) + " is out of range",
                       "scale the target to 0 … 1");
}

}  // namespace

Waveform read_waveform(TomlReader& reader, double duration_s) {
  using Wave = Waveform::Shape;
  Waveform waveform;
  waveform.shape =
      static_cast<Wave>(reader.choice("waveform",
                                      {"constant", "ramp", "trapezoid", "triangle", "sine",
                                       "swept_sine", "rectangle", "multi_sine", "random", "csv"},
                                      static_cast<std::size_t>(Wave::sine)));
  switch (waveform.shape) {
    case Wave::constant: break;
    case Wave::trapezoid:
      waveform.hold_s = read_wait(reader, "hold_s", waveform.hold_s);
      waveform.fall_s = read_duration(reader, "fall_s", waveform.fall_s);
      [[fallthrough]];
    case Wave::ramp: waveform.rise_s = read_duration(reader, "rise_s", waveform.rise_s); break;
    case Wave::swept_sine:
      waveform.last_frequency_Hz =
          read_within(reader, "last_frequency_Hz", kLeast_Hz, kMost_Hz, waveform.last_frequency_Hz);
      [[fallthrough]];
    case Wave::triangle:
    case Wave::sine:
    case Wave::rectangle:
      waveform.frequency_Hz =
          read_within(reader, "frequency_Hz", kLeast_Hz, kMost_Hz, waveform.frequency_Hz);
      break;
    case Wave::multi_sine:
      waveform.frequencies = reader.numbers("frequencies_Hz", 1, 20);
      for (const double frequency : waveform.frequencies)
        if (!(frequency >= kLeast_Hz && frequency <= kMost_Hz))
          reader.fail("frequencies_Hz", format_number(frequency) + " is out of range",
                      "write frequencies up to 5 Hz");
      break;
    case Wave::random:
      waveform.bandwidth_Hz =
          read_within(reader, "bandwidth_Hz", kLeast_Hz, kMost_Hz, waveform.bandwidth_Hz);
      if (waveform.bandwidth_Hz * duration_s > kMostSines)
        reader.fail("bandwidth_Hz", "gives too many lines for this duration",
                    "keep bandwidth times duration below " + format_number(kMostSines));
      if (waveform.bandwidth_Hz * duration_s < 1.0)
        reader.fail("bandwidth_Hz", "is below one cycle in this duration",
                    "raise it, or make the target longer");
      break;
    case Wave::csv: read_csv_data(reader, waveform); break;
  }
  const bool seeded = waveform.shape == Wave::multi_sine || waveform.shape == Wave::random;
  if (seeded && reader.has("seed")) {
    const auto seed = reader.integer("seed");
    if (seed < 0) reader.fail("seed", "is negative", "write 0 or more");
    waveform.seed = static_cast<std::uint64_t>(seed);
  }
  return waveform;
}

RestSpec read_rest(TomlReader& reader) {
  RestSpec spec;
  spec.duration_s = read_duration(reader, "duration_s", spec.duration_s);
  return spec;
}

MaximumSpec read_maximum(TomlReader& reader) {
  MaximumSpec spec;
  spec.channel = read_channel(reader);
  spec.comfortable = reader.choice("effort", {"maximum", "comfortable"}, 0) == 1;
  spec.lead_in_s = read_wait(reader, "lead_in_s", spec.lead_in_s);
  spec.squeeze_s = read_duration(reader, "squeeze_s", spec.squeeze_s);
  spec.window_s = read_duration(reader, "window_s", spec.window_s);
  spec.force_shown = reader.boolean("force_shown", true);
  if (spec.window_s > spec.squeeze_s)
    reader.fail("window_s", "is longer than squeeze_s", "make it shorter");
  return spec;
}

DirectionalMaximaSpec read_directional_maxima(TomlReader& reader) {
  constexpr std::array<std::string_view, kDirectionCount> kNames{"+x", "-x", "+y",
                                                                 "-y", "+z", "-z"};
  DirectionalMaximaSpec spec;
  spec.digits = read_digits(reader, "digits");
  for (const std::string& name : reader.texts("directions")) {
    const auto found = std::find(kNames.begin(), kNames.end(), name);
    if (found == kNames.end())
      reader.fail("directions", "'" + name + "' is not a direction", "write +x, -x, … -z");
    else
      spec.directions.push_back(static_cast<Direction>(found - kNames.begin()));
  }
  spec.lead_in_s = read_wait(reader, "lead_in_s", spec.lead_in_s);
  spec.push_s = read_duration(reader, "push_s", spec.push_s);
  spec.rest_s = read_wait(reader, "rest_s", spec.rest_s);
  spec.window_s = read_duration(reader, "window_s", spec.window_s);
  if (spec.window_s > spec.push_s)
    reader.fail("window_s", "is longer than push_s", "make it shorter");
  if (spec.directions.empty()) reader.fail("directions", "is empty", "name at least one direction");
  return spec;
}

ForceTrackingSpec read_force_tracking(TomlReader& reader) {
  ForceTrackingSpec spec;
  spec.aim = read_aim(reader);
  spec.least = read_level(reader, spec.aim, "least", spec.least);
  spec.most = read_level(reader, spec.aim, "most", spec.most);
  if (spec.most <= spec.least)
    reader.fail(spec.aim.scale == Scale::newton ? "most_N" : "most_fraction",
                "is not above the least level", "write a larger number");
  spec.lead_in_s = read_wait(reader, "lead_in_s", spec.lead_in_s);
  spec.duration_s = read_duration(reader, "duration_s", spec.duration_s);
  spec.waveform = read_waveform(reader, spec.duration_s);
  // Axes of a pose would meet in another path: those are no parallel forms.
  using Wave = Waveform::Shape;
  if (spec.waveform.shape == Wave::sine || spec.waveform.shape == Wave::triangle)
    spec.waveform.forms = read_count(reader, "forms", spec.waveform.forms, kMostForms);
  return spec;
}

SteadinessSpec read_steadiness(TomlReader& reader) {
  SteadinessSpec spec;
  spec.aim = read_aim(reader);
  spec.levels = read_levels(reader, spec.aim, "levels", spec.levels);
  spec.rise_s = read_wait(reader, "rise_s", spec.rise_s);
  spec.settle_s = read_wait(reader, "settle_s", spec.settle_s);
  spec.hold_s = read_duration(reader, "hold_s", spec.hold_s);
  spec.rest_s = read_wait(reader, "rest_s", spec.rest_s);
  return spec;
}

StepResponseSpec read_step_response(TomlReader& reader) {
  StepResponseSpec spec;
  spec.aim = read_aim(reader);
  spec.from = read_level(reader, spec.aim, "from", spec.from);
  spec.to = read_levels(reader, spec.aim, "to", spec.to);
  read_waits(reader, spec.least_wait_s, spec.most_wait_s);
  spec.hold_s = read_duration(reader, "hold_s", spec.hold_s);
  spec.repetitions = read_count(reader, "repetitions", spec.repetitions, kMostRepetitions);
  for (const double to : spec.to)
    if (to == spec.from)
      reader.fail(spec.aim.scale == Scale::newton ? "to_N" : "to_fractions",
                  "has the level that the step begins at", "write another level");
  return spec;
}

GripReleaseSpec read_grip_release(TomlReader& reader) {
  GripReleaseSpec spec;
  spec.aim = read_aim(reader);
  spec.level = read_level(reader, spec.aim, "level", spec.level);
  spec.rise_s = read_wait(reader, "rise_s", spec.rise_s);
  read_waits(reader, spec.least_wait_s, spec.most_wait_s);
  spec.after_s = read_duration(reader, "after_s", spec.after_s);
  spec.open = reader.boolean("open", false);
  spec.repetitions = read_count(reader, "repetitions", spec.repetitions, kMostRepetitions);
  if (spec.aim.channel.direction != Direction::plus_z)
    reader.fail("channel", "is not a closing force", "only what is held can be let go");
  return spec;
}

ForceSenseSpec read_force_sense(TomlReader& reader) {
  ForceSenseSpec spec;
  spec.aim = read_aim(reader);
  spec.level = read_level(reader, spec.aim, "level", spec.level);
  spec.learn_s = read_duration(reader, "learn_s", spec.learn_s);
  spec.pause_s = read_wait(reader, "pause_s", spec.pause_s);
  spec.reproduce_s = read_duration(reader, "reproduce_s", spec.reproduce_s);
  spec.window_s = read_duration(reader, "window_s", spec.window_s);
  spec.repetitions = read_count(reader, "repetitions", spec.repetitions, kMostRepetitions);
  if (spec.window_s > spec.reproduce_s)
    reader.fail("window_s", "is longer than reproduce_s", "make it shorter");
  return spec;
}

FatigueSpec read_fatigue(TomlReader& reader) {
  FatigueSpec spec;
  spec.aim = read_aim(reader);
  spec.level = read_level(reader, spec.aim, "level", spec.level);
  spec.rise_s = read_wait(reader, "rise_s", spec.rise_s);
  spec.hold_s = read_duration(reader, "hold_s", spec.hold_s);
  return spec;
}

IndividuationSpec read_individuation(TomlReader& reader) {
  IndividuationSpec spec;
  spec.aim = read_aim(reader, false);
  spec.digits = read_digits(reader, "digits");
  spec.levels = read_levels(reader, spec.aim, "levels", spec.levels);
  spec.rest_s = read_duration(reader, "rest_s", spec.rest_s);
  spec.rise_s = read_wait(reader, "rise_s", spec.rise_s);
  spec.hold_s = read_duration(reader, "hold_s", spec.hold_s);
  spec.repetitions = read_count(reader, "repetitions", spec.repetitions, kMostRepetitions);
  return spec;
}

ForceDirectionSpec read_force_direction(TomlReader& reader) {
  ForceDirectionSpec spec;
  spec.aim = read_aim(reader, false);
  spec.rise_s = read_wait(reader, "rise_s", spec.rise_s);
  spec.hold_s = read_duration(reader, "hold_s", spec.hold_s);
  spec.rest_s = read_wait(reader, "rest_s", spec.rest_s);
  spec.repetitions = read_count(reader, "repetitions", spec.repetitions, kMostRepetitions);
  for (TomlReader& table : reader.tables("target")) {
    ForceDirectionTarget target;
    target.level = read_level(table, spec.aim, "level", target.level);
    for (const Finger digit : kFingers) {
      const std::string key = std::string(name_of(digit)) + "_direction";
      if (!table.has(key)) continue;
      const Vec3 direction = table.vec3(key);
      if (!(direction.norm() > 0.0)) table.fail(key, "has no length", "write e.g. [0, 0, 1]");
      target.asked[index_of(digit)] = true;
      target.direction_C[index_of(digit)] = direction.stableNormalized();
    }
    if (!target.asked[0] && !target.asked[1] && !target.asked[2])
      table.fail("", "asks no digit", "add e.g. thumb_direction = [0, 0, 1]");
    spec.targets.push_back(target);
  }
  if (spec.targets.empty()) reader.fail("target", "is missing", "add at least one [[target]]");
  return spec;
}

}  // namespace isograsp::tasks
