// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/two_platforms/two_platforms_trial.hpp"

#include "hand/two_hands_columns.hpp"
#include "session/acquisition/json_object.hpp"
#include "session/platform/health_json.hpp"

namespace isograsp::session {

namespace {

constexpr double kBlank = tasks::kNotMeasured;

template <class Number>
double stored_number(Number value) {
  return static_cast<double>(value);
}

template <class Sink>
void put_hands_task(Sink& sink, const RowFrame& frame, const TwoPlatformsSnapshot& seen,
                    const TwoPlatformsTrial& trial) {
  const tasks::TwoHandsView& task = seen.special.two_hands();
  put_progress(sink, frame);
  std::uint8_t flags = 0;
  for (const Hand hand : kBothHands)
    for (const std::uint8_t finger : seen.of[hand].forces.flags) flags |= finger;
  sink.put(columns::sample_flags, stored_number(flags));
  sink.put(columns::segment, stored_number(frame.task.segment));
  sink.put(columns::cue, stored_number(frame.task.cue));
  sink.put(columns::target_sum_force_N, task.target_sum_N.value_or(kBlank));
  sink.put(columns::sum_force_N, seen.of.left.grip_N + seen.of.right.grip_N);
  sink.put(columns::sum_force_shown, stored_number(task.sum_shown));
  for (const Hand hand : kBothHands) {
    const tasks::HandAsked& asked = task.of[hand];
    sink.put(columns::target_hand_grip[hand], asked.target_N.value_or(kBlank));
    sink.put(columns::hand_grip[hand], seen.of[hand].grip_N);
    sink.put(columns::hand_cue[hand], stored_number(asked.cue));
    sink.put(columns::hand_force_shown[hand], stored_number(asked.force_shown));
  }
  for (const Hand hand : kBothHands) {
    const tasks::HandReferences& of = trial.references.of[hand];
    sink.put(columns::hand_resting_force_N[hand], of.resting_N.value_or(kBlank));
    sink.put(columns::hand_maximum_force_N[hand], of.maximum_N.value_or(kBlank));
  }
  const auto& affected = trial.references.affected;
  sink.put(columns::affected_hand, !affected ? kBlank : *affected == Hand::left ? 0.0 : 1.0);
  const auto& coupled = trial.references.coupled;
  sink.put(columns::platforms_coupled, coupled ? stored_number(*coupled) : kBlank);
  sink.put(columns::device_delay_s, trial.device_delay_s.value_or(kBlank));
  sink.put(columns::display_delay_s, trial.display_delay_s.value_or(kBlank));
}

template <class Sink>
void put_triple(Sink& sink, const columns::OfAxes& axes, const Vec3& value, bool known) {
  for (std::size_t a = 0; a < 3; ++a)
    sink.put(axes[a], known ? value[static_cast<Eigen::Index>(a)] : kBlank);
}

template <class Sink>
void put_hand_forces(Sink& sink, Hand hand, const PlatformSide& side) {
  for (std::size_t f = 0; f < kFingerCount; ++f) {
    const bool known = (side.forces.flags[f] & bit(SampleFlag::missing)) == 0;
    put_triple(sink, columns::hands_finger_force[hand][f], side.forces.wrench_C[f].force, known);
    put_triple(sink, columns::hands_finger_torque[hand][f], side.forces.wrench_C[f].torque, known);
  }
  for (std::size_t f = 0; f < kFingerCount; ++f)
    sink.put(columns::hands_finger_flags[hand][f], stored_number(side.forces.flags[f]));
  put_triple(sink, columns::hand_push[hand], side.push_W.value_or(Vec3::Zero()),
             side.push_W.has_value());
}

template <class Sink>
void put_hand_counts(Sink& sink, Hand hand, const FingerFrame& forces) {
  for (std::size_t f = 0; f < kFingerCount; ++f) {
    const RawCounts& counts = forces.raw_counts[f];
    for (std::size_t a = 0; a < 3; ++a)
      sink.put(columns::hands_raw_force[hand][f][a], stored_number(counts[a]));
    for (std::size_t a = 0; a < 3; ++a)
      sink.put(columns::hands_raw_torque[hand][f][a], stored_number(counts[3 + a]));
  }
}

template <class Sink>
void put_moved_task(Sink& sink, const RowFrame& frame, const ObjectState& object,
                    const tasks::MovedView& asked) {
  const bool target = asked.target_shown;
  put_triple(sink, columns::target_position, asked.X_WT.p, target);
  put_triple(sink, columns::actual_position, object.X_WO.p, true);
  sink.put(columns::target_angle_rad, target ? 0.0 : kBlank);  // level
  sink.put(columns::actual_angle_rad, object.angle_rad);
  sink.put(columns::target_index, stored_number(frame.task.target_index));
  sink.put(columns::targets_reached, stored_number(frame.task.targets_reached));
  sink.put(columns::drops, stored_number(asked.drops));
  sink.put(columns::on_rest, stored_number(asked.on_rest));
}

template <class Sink>
void put_quaternion(Sink& sink, const columns::OfComponents& components, const Quat& q,
                    bool known) {
  const std::array<double, 4> value{q.w(), q.x(), q.y(), q.z()};
  for (std::size_t i = 0; i < value.size(); ++i) sink.put(components[i], known ? value[i] : kBlank);
}

template <class Sink>
void put_moved(Sink& sink, const ObjectState& object, const tasks::MovedView& asked) {
  sink.begin("object");
  put_quaternion(sink, columns::actual_attitude, object.X_WO.q, true);
  put_quaternion(sink, columns::target_attitude, asked.X_WT.q, asked.target_shown);
  put_triple(sink, columns::object_velocity, object.v_WO_W, true);
  put_triple(sink, columns::object_angular_velocity, object.w_WO_W, true);
}

template <class Sink>
void put_carried(Sink& sink, const CarriedView& seen, const CarrySetup& setup) {
  for (const Hand hand : kBothHands) {
    const CarryingHand& of = seen.of[hand];
    put_triple(sink, columns::hand_point[hand], of.p_W, true);
    put_triple(sink, columns::hand_bubble[hand], of.bubble_W, true);
    sink.put(columns::hand_excess[hand], of.excess);
    sink.put(columns::hand_squeeze_N[hand], of.squeeze_N);
    sink.put(columns::hand_at_edge_N[hand], setup.of[hand].at_edge_N);
    sink.put(columns::hand_on_N[hand], setup.of[hand].on_N);
  }
  sink.put(columns::both_hold, stored_number(seen.held));
  sink.put(columns::joint_control, stored_number(seen.joint));
  sink.put(columns::clutch_held, stored_number(seen.clutch));
  sink.put(columns::left_share, setup.left_share);
}

template <class Sink>
void put_lifted(Sink& sink, const LiftedView& seen, const tasks::MovedView& asked,
                double strength) {
  const ObjectState& object = seen.object;
  const bool acts = !asked.on_rest;
  put_triple(sink, columns::object_force, acts ? seen.F_O_W.force : Vec3::Zero(), true);
  put_triple(sink, columns::object_torque, acts ? seen.F_O_W.torque : Vec3::Zero(), true);
  for (const Hand hand : kBothHands) {
    const LiftingHand& of = seen.of[hand];
    sink.put(columns::hand_squeeze_N[hand], of.squeeze_N);
    sink.put(columns::hand_contact[hand], stored_number(of.touches));
    sink.put(columns::hand_slip[hand], stored_number(of.slips));
    sink.put(columns::hand_utilisation[hand], of.utilisation);
    put_triple(sink, columns::hand_end[hand], object.X_WO.p + object.X_WO.q * of.end_O, true);
  }
  sink.put(columns::object_strength, strength);
}

template <class Sink>
void put_hands_row(Sink sink, const RowFrame& frame, const TwoPlatformsSnapshot& seen,
                   const TwoPlatformsTrial& trial) {
  const LiftedView lifted = seen.lifted.value_or(LiftedView());
  const tasks::MovedView asked = seen.special.two_hands().moved.value_or(tasks::MovedView());
  put_hands_task(sink, frame, seen, trial);
  const CarriedView carried = seen.carried.value_or(CarriedView());
  const ObjectState& object = trial.carried ? carried.object : lifted.object;
  if (trial.object || trial.carried) put_moved_task(sink, frame, object, asked);
  sink.begin("force");
  for (const Hand hand : kBothHands) put_hand_forces(sink, hand, seen.of[hand]);
  sink.begin("raw");
  for (const Hand hand : kBothHands) put_hand_counts(sink, hand, seen.of[hand].forces);
  if (trial.object || trial.carried) put_moved(sink, object, asked);
  if (trial.object) put_lifted(sink, lifted, asked, trial.object->strength());
  if (trial.carried) put_carried(sink, carried, trial.carried->setup());
  put_timing(sink, frame);
  sink.put(columns::skew_s, seen.skew_s.value_or(kBlank));
}

}  // namespace

std::vector<storage::SignalGroup> TwoPlatformsTrial::columns() const {
  std::vector<storage::SignalGroup> groups;
  put_hands_row(ColumnNames{groups}, {}, {}, *this);
  return groups;
}

void TwoPlatformsTrial::write(const RowFrame& frame, const TwoPlatformsSnapshot& seen,
                              TrialRow& row) const noexcept {
  put_hands_row(ColumnValues{row}, frame, seen, *this);
}

std::string TwoPlatformsTrial::health_json() const {
  JsonObject json;
  for (const Hand hand : kBothHands) json.add(name_of(hand), as_json(health[hand]));
  return json.text();
}

}  // namespace isograsp::session
