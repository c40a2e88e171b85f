// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/tracked_hand/hand_trial.hpp"

#include "hand/hand_columns.hpp"
#include "session/acquisition/json_object.hpp"
#include "session/tracked_hand/hand_sight.hpp"

namespace isograsp::session {

namespace {

constexpr double kUnknown = tasks::kNotMeasured;

template <class Number>
double as_value(Number value) {
  return static_cast<double>(value);
}

template <class Sink>
void put_hand_task(Sink& sink, const RowFrame& frame, const HandSnapshot& seen, bool object) {
  put_progress(sink, frame);
  sink.put(columns::sample_flags, as_value(hand_flags(seen.hand)));
  sink.put(columns::pause_cause, as_value(seen.pause_cause));
  sink.put(columns::cue, as_value(frame.task.cue));
  sink.put(columns::segment, as_value(frame.task.segment));
  sink.put(columns::target_index, as_value(frame.task.target_index));
  if (!object) return;
  const tasks::HandView& task = seen.special.hand();
  sink.put(columns::placement, as_value(task.placement));
  sink.put(columns::study_object, as_value(task.object));
  sink.put(columns::assistance, as_value(task.assistance));
  sink.put(columns::eased, as_value(task.eased));
  sink.put(columns::placement_fails, as_value(task.fails));
  sink.put(columns::let_go_asked, as_value(task.let_go_asked));
  sink.put(columns::object_helped, as_value(task.helped));
}

template <class Sink>
void put_hand(Sink& sink, const HandSnapshot& seen) {
  sink.begin("hand");
  sink.put(columns::confidence, seen.hand.known ? seen.hand.frame.confidence : 0.0);
  sink.put(columns::unseen_s, seen.hand.unseen_s);
  put_pose(sink, columns::palm_position, columns::palm_attitude,
           seen.pose ? seen.pose->pose.X_WP : missing_pose());
  sink.put(columns::thumb_index_gap_m, seen.thumb_index_gap_m);
  for (std::size_t d = 0; d < kDigitCount; ++d) {
    const auto angle = [&](std::size_t k) {
      return seen.pose ? seen.pose->pose.angles[d][k] : kUnknown;
    };
    sink.put(columns::abduction[d], angle(0));
    for (std::size_t k = 0; k < 3; ++k) sink.put(columns::flexion[d][k], angle(k + 1));
  }
  sink.put(columns::fit_residual_m, seen.pose ? seen.pose->residual_m : kUnknown);
}

template <class Sink>
void put_joints(Sink& sink, const HandSnapshot& seen) {
  sink.begin("joints");
  for (std::size_t j = 0; j < kHandJointCount; ++j)
    put_position(sink, columns::hand_joint[j], seen.hand.frame.joints[j]);
}

template <class Sink>
void put_virtual_object(Sink& sink, const HandSnapshot& seen) {
  const hand_world::GraspState& grasp = seen.grasp;
  sink.begin("object");
  const Pose missing = missing_pose();
  put_pose(sink, columns::actual_position, columns::actual_attitude,
           grasp.object_there ? grasp.object.X_WO : missing);
  const tasks::HandView& task = seen.special.hand();
  put_pose(sink, columns::target_position, columns::target_attitude,
           task.target_shown ? task.X_WT : missing);
  sink.put(columns::object_held, as_value(grasp.held));
  sink.put(columns::object_touched, as_value(touches(grasp)));
  sink.put(columns::object_supported, as_value(grasp.supported));
}

/// Why the assistance held, and why it let go.
template <class Sink>
void put_grasp(Sink& sink, const HandSnapshot& seen) {
  const hand_world::GraspState& grasp = seen.grasp;
  sink.begin("grasp");
  for (std::size_t d = 0; d < kDigitCount; ++d) {
    const hand_world::DigitGrasp& digit = grasp.digits[d];
    sink.put(columns::grasp_state[d], as_value(digit.state));
    sink.put(columns::pull_N[d], digit.pull_N);
    sink.put(columns::touch_N[d], digit.normal_N);
    sink.put(columns::gap_m[d], digit.gap_m);
  }
  sink.put(columns::release_pull_N, seen.release_N);
  sink.put(columns::grasp_digits, as_value(grasp.choice.digits));
  sink.put(columns::grasp_feasible, as_value(grasp.choice.feasible));
  sink.put(columns::grasp_G_min, grasp.choice.G_min);
  sink.put(columns::grasp_H_min, grasp.choice.H_min);
  sink.put(columns::grasp_H_det, grasp.choice.H_det);
  sink.put(columns::grasp_G_min_limit, grasp.choice.G_min_limit);
  sink.put(columns::grasp_H_min_limit, grasp.choice.H_min_limit);
  sink.put(columns::grasp_H_det_limit, grasp.choice.H_det_limit);
  sink.put(columns::tracked_gap_m, grasp.tracked_gap_m);
  sink.put(columns::solver_sweeps, as_value(grasp.solver.sweeps));
  sink.put(columns::solver_residual_mps, grasp.solver.residual_m_s);
  sink.begin("virtual_hand");
  put_pose(sink, columns::virtual_palm_position, columns::virtual_palm_attitude,
           grasp.hand_there ? grasp.hand.X_WP : missing_pose());
  for (std::size_t d = 0; d < kDigitCount; ++d)
    for (std::size_t k = 0; k < virtual_hand::kAngleCount; ++k)
      sink.put(columns::virtual_angle[d][k], grasp.hand_there ? grasp.hand.angles[d][k] : kUnknown);
}

template <class Sink>
void put_hand_row(Sink sink, const RowFrame& frame, const HandSnapshot& seen,
                  const HandTrial& trial) {
  put_hand_task(sink, frame, seen, trial.objects != nullptr);
  put_hand(sink, seen);
  if (trial.keeps_joints) put_joints(sink, seen);
  if (trial.objects) {
    put_virtual_object(sink, seen);
    put_grasp(sink, seen);
  }
  put_timing(sink, frame);
}

}  // namespace

VirtualObjects::VirtualObjects(const virtual_hand::HandModel& hand, double period_s, double table_m)
    : grasp(hand, period_s) {
  for (std::size_t k = 0; k < virtual_hand::kStudyObjects; ++k) {
    const virtual_hand::StudyObject& object = virtual_hand::study_objects()[k];
    objects[k] = hand_world::grasp_object(object);
    places[k] = hand_world::start_place(object, table_m, 0.0, 0.0);
  }
}

void VirtualObjects::obey(const tasks::HandView& task) noexcept {
  const auto object = static_cast<std::size_t>(task.object);
  switch (task.order) {
    case tasks::ObjectOrder::none: break;
    case tasks::ObjectOrder::place:
      grasp.place(objects[object], places[object], task.assistance);
      break;
    case tasks::ObjectOrder::reset: grasp.reset(); break;
    case tasks::ObjectOrder::release: grasp.release(); break;
    case tasks::ObjectOrder::let_go: grasp.let_go(); break;
    case tasks::ObjectOrder::remove: grasp.clear(); break;
  }
}

std::vector<storage::SignalGroup> HandTrial::columns() const {
  std::vector<storage::SignalGroup> groups;
  put_hand_row(ColumnNames{groups}, {}, {}, *this);
  return groups;
}

void HandTrial::write(const RowFrame& frame, const HandSnapshot& seen,
                      TrialRow& row) const noexcept {
  put_hand_row(ColumnValues{row}, frame, seen, *this);
}

std::string HandTrial::health_json() const {
  const HandCounters& of = health.counters;
  JsonObject counters;
  counters.add("frames", of.frames);
  counters.add("rows", of.rows);
  counters.add("untracked", of.untracked);
  counters.add("incomplete", of.incomplete);
  counters.add("other_side", of.other_side);
  counters.add("lost", of.lost);
  counters.add("late", of.late);
  counters.add("malformed", of.malformed);
  counters.add("foreign", of.foreign);
  counters.add("clock_steps", of.clock_steps);
  counters.add("restarts", of.restarts);
  counters.add("overrun", of.overrun);
  JsonObject whole;
  whole.add("state", quoted(name_of(health.state)));
  whole.add("fault", quoted(name_of(health.fault)));
  whole.add("tracker", counters.text());
  return whole.text();
}

}  // namespace isograsp::session
