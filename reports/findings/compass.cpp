// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/findings/compass.hpp"

#include <algorithm>
#include <cmath>

#include "hand/anatomical_axes.hpp"
#include "reports/findings/comparable.hpp"
#include "reports/findings/patient_records.hpp"

namespace isograsp::reports {

namespace {

std::optional<Finger> finger_of(std::string_view name) {
  for (const Finger finger : kFingers)
    if (name_of(finger) == name) return finger;
  return std::nullopt;
}

bool has_all_directions(const storage::TrialRecord& trial) {
  const auto spec = tasks::parse_task(trial.task_text, trial.task_name);
  return spec && spec->kind->all_directions;
}

void take(const Measure& measure, Hand hand, Compass& compass) {
  const auto channel = force_channel_from_name(measure.channel);
  const auto finger = channel ? single_digit(*channel) : std::nullopt;
  if (!finger || !measure.value) return;
  CompassDigit& digit = compass.digits[index_of(*finger)];
  const auto point = static_cast<std::size_t>(compass_point(channel->direction, *finger, hand));
  if (measure.name == "maximum_force") digit.force_N[point] = measure.value;
  if (measure.name == "direction_error") digit.error_rad[point] = measure.value;
  if (measure.name == "coflexion") digit.coflexion_percent = measure.value;
}

/// What the digits pressed at rest in the same session.
void add_rest(const PatientRecords& records, const StoredTrial& profile, Compass& compass) {
  for (const auto& trial : records.trials) {
    if (trial.session != profile.session || !counts(trial.trial)) continue;
    for (const auto& measure : trial.measures) {
      constexpr std::string_view kNormal = "_fz";
      if (measure.name != "resting_force" || !measure.channel.ends_with(kNormal)) continue;
      const auto digit = finger_of(
          std::string_view(measure.channel).substr(0, measure.channel.size() - kNormal.size()));
      if (digit && measure.value) compass.digits[index_of(*digit)].resting_N = measure.value;
    }
  }
}

}  // namespace

Words words_of(CompassPoint point) noexcept {
  static constexpr std::array<Words, kCompassPoints> kWords{
      "closing"_text, "opening"_text, "radial"_text, "ulnar"_text, "distal"_text, "proximal"_text};
  return kWords[static_cast<std::size_t>(point)];
}

CompassPoint compass_point(Direction direction, Finger finger, Hand hand) noexcept {
  const Vec3 force = anatomical(axis_of(direction), finger, hand);
  Eigen::Index axis = 0;
  force.cwiseAbs().maxCoeff(&axis);
  return static_cast<CompassPoint>(2 * axis + (force[axis] < 0.0 ? 1 : 0));
}

std::vector<Compass> compasses_of(const PatientRecords& records) {
  std::vector<Compass> all;
  for (const Hand hand : {Hand::right, Hand::left}) {
    const auto newest =
        std::find_if(records.trials.rbegin(), records.trials.rend(), [&](const StoredTrial& one) {
          return one.session_record->hand == hand && counts(one.trial) &&
                 has_all_directions(one.trial);
        });
    if (newest == records.trials.rend()) continue;
    Compass& compass = all.emplace_back();
    compass.hand = hand;
    compass.session = newest->session;
    for (const auto& measure : newest->measures) take(measure, hand, compass);
    add_rest(records, *newest, compass);
  }
  return all;
}

double compass_range(const std::vector<Compass>& compasses) {
  double most_N = 1.0;
  for (const auto& compass : compasses)
    for (const auto& digit : compass.digits) {
      for (const auto& force : digit.force_N) most_N = std::max(most_N, force.value_or(0.0));
      most_N = std::max(most_N, std::abs(digit.resting_N.value_or(0.0)));
    }
  const double decade = std::pow(10.0, std::floor(std::log10(most_N)));
  for (const double step : {1.0, 2.0, 4.0, 6.0, 8.0})
    if (step * decade >= most_N) return step * decade;
  return 10.0 * decade;
}

}  // namespace isograsp::reports
