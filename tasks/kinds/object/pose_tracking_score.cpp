// SPDX-License-Identifier: GPL-3.0-or-later
// Measures of pose tracking: every driven degree of freedom by itself, and object and target as
// wholes. Lead-ins and pauses are not scored.
// Angle about the axis of a degree of freedom, of an attitude q, and its continuation from row to
// row:
//   angle = 2 atan2(q_axis, q_w)
//   angle_k = angle_(k - 1) + remainder(angle_k - angle_(k - 1), 2 pi)
// The object's angle begins in the turn that is nearest to the target's. Of the whole:
//   rmse = sqrt(sum w e^2 / sum w),  e: distance, or angle, between object and target
#include <cmath>
#include <numbers>

#include "core/csv.hpp"
#include "grasp_model/scene.hpp"
#include "hand/columns.hpp"
#include "tasks/kinds/object/pose_tracking.hpp"
#include "tasks/kinds/tools/object_score.hpp"
#include "tasks/measures/delay.hpp"
#include "tasks/measures/error.hpp"
#include "tasks/measures/known_delay.hpp"
#include "tasks/measures/sine.hpp"

namespace isograsp::tasks {

namespace {

constexpr std::initializer_list<Phase> kScored = {Phase::active};

/// Target and object in one degree of freedom.
struct Followed {
  Section section;
  std::vector<double> target;
  std::vector<double> actual;
};

/// Angles [rad] become continuous: a step of more than half a turn went the other way.
void unwrap(std::vector<double>& angles) {
  for (std::size_t k = 1; k < angles.size(); ++k)
    angles[k] = angles[k - 1] + std::remainder(angles[k] - angles[k - 1], 2.0 * std::numbers::pi);
}

class TrackingScore {
 public:
  TrackingScore(const PoseTrackingSpec& spec, const Record& record)
      : spec_(spec), record_(record), object_(record) {}

  [[nodiscard]] std::vector<Measure> measures() const {
    std::vector<Measure> all;
    for (const auto& axis : spec_.axes) add_axis(all, axis);
    add_whole(all);
    const Section motion = record_.select_position(0, record_.rows(), kScored);
    all.push_back(path_length(motion));
    const Section force = record_.select(kScored, {columns::actual_force_N});
    const Smoothness of_motion = object_.smoothness_of_motion(motion);
    const Smoothness of_grip = object_.smoothness_of_grip(force);
    all.push_back(make_measure("sparc", "position", "", motion, of_motion.sparc));
    all.push_back(make_measure("sparc", "force_rate", "", force, of_grip.sparc));
    all.push_back(make_measure("ldlj", "position", "", motion, of_motion.ldlj));
    all.push_back(make_measure("ldlj", "force_rate", "", force, of_grip.ldlj));
    all.push_back(object_.slip(kScored));
    all.push_back(object_.mean_grip(kScored));
    add_grasp(all, record_, kScored);
    return all;
  }

 private:
  [[nodiscard]] Followed followed(int dof) const {
    Followed result;
    if (dof < 3) {
      const Column& target = columns::target_position[static_cast<std::size_t>(dof)];
      const Column& actual = columns::actual_position[static_cast<std::size_t>(dof)];
      result.section = record_.select(kScored, {target, actual});
      if (!result.section.reason.empty()) return result;
      result.target = result.section.values(target);
      result.actual = result.section.values(actual);
      return result;
    }
    result.section = object_.select_attitudes(0, record_.rows(), kScored);
    // The target turns about this axis alone, so the object's angle is taken about this axis, too.
    const auto angle = [axis = dof - 3](const Quat& q) {
      return 2.0 * std::atan2(q.vec()[axis], q.w());
    };
    for (const std::size_t row : result.section.rows) {
      result.target.push_back(angle(object_.target_attitude(row)));
      result.actual.push_back(angle(object_.attitude(row)));
    }
    unwrap(result.target);
    unwrap(result.actual);
    if (result.actual.empty()) return result;
    const double turns =
        std::round((result.target.front() - result.actual.front()) / (2.0 * std::numbers::pi));
    for (double& value : result.actual) value += 2.0 * std::numbers::pi * turns;
    return result;
  }

  void add_axis(std::vector<Measure>& all, const PoseTrackingSpec::Axis& axis) const {
    const auto [section, target, actual] = followed(axis.axis);
    const std::string channel(kDofNames[static_cast<std::size_t>(axis.axis)]);
    const char* const unit = axis.axis < 3 ? "m" : "rad";
    const auto& weight_s = section.weight_s;
    const auto add = [&, &rows = section](const char* name, const std::string& of, const char* in,
                                          const statistics::Computed& computed) {
      all.push_back(make_measure(name, of, in, rows, computed));
    };
    add("rmse", channel, unit, rmse(target, actual, weight_s));
    add("mae", channel, unit, mae(target, actual, weight_s));
    add("constant_error", channel, unit, constant_error(target, actual, weight_s));
    const statistics::Computed late = target.size() < 2
                                          ? statistics::Computed("fewer than two samples"_text)
                                          : lag(statistics::on_uniform_grid(section.t_s, target),
                                                statistics::on_uniform_grid(section.t_s, actual));
    add("lag", channel, "s", late);
    add("lag_corrected", channel, "s", without_delay(late, record_.known_delay_s()).corrected_s);
    const bool sines = axis.waveform.shape == Waveform::Shape::sine ||
                       axis.waveform.shape == Waveform::Shape::multi_sine;
    if (!sines) return;
    const std::vector<double> frequencies = axis.waveform.shape == Waveform::Shape::sine
                                                ? std::vector{axis.waveform.frequency_Hz}
                                                : axis.waveform.frequencies;
    for (const SineAnswer& answer : sine_answers(section.t_s, target, actual, frequencies)) {
      const std::string of = frequencies.size() == 1
                                 ? channel
                                 : channel + "_" + format_number(answer.frequency_Hz) + "_Hz";
      add("gain", of, "", answer.gain);
      add("phase", of, "rad", answer.phase_rad);
      add("phase_lag", of, "s", answer.lag_s);
    }
  }

  /// The distance, and the angle, between the object and the target as they are on the screen: also
  /// in degrees of freedom that the target does not move in.
  void add_whole(std::vector<Measure>& all) const {
    const auto add = [&](const char* channel, const char* unit, const Section& section,
                         const std::vector<double>& error) {
      const std::vector<double> none(error.size(), 0.0);
      all.push_back(
          make_measure("rmse", channel, unit, section, rmse(none, error, section.weight_s)));
    };
    const Section position = object_.select_positions(0, record_.rows(), kScored);
    std::vector<double> error;
    for (const std::size_t row : position.rows) error.push_back(object_.distance(row));
    add("position", "m", position, error);
    const Section attitude = object_.select_attitudes(0, record_.rows(), kScored);
    error.clear();
    for (const std::size_t row : attitude.rows) error.push_back(object_.angle(row));
    add("attitude", "rad", attitude, error);
  }

  const PoseTrackingSpec& spec_;
  const Record& record_;
  ObjectRecord object_;
};

}  // namespace

std::vector<Measure> score_pose_tracking(const PoseTrackingSpec& spec, const Record& record) {
  return TrackingScore(spec, record).measures();
}

}  // namespace isograsp::tasks
