// SPDX-License-Identifier: GPL-3.0-or-later
#include "hand/columns.hpp"

#include <map>

#include "hand/arm_columns.hpp"
#include "hand/hand_columns.hpp"
#include "hand/two_hands_columns.hpp"

namespace isograsp::columns {

namespace {

class ByName {
 public:
  template <class... Columns>
  explicit ByName(const Columns&... columns) {
    (add(columns), ...);
  }
  [[nodiscard]] const Column* find(std::string_view name) const {
    const auto found = columns_.find(name);
    return found == columns_.end() ? nullptr : found->second;
  }

 private:
  void add(const OfSegment& segment) {
    add(segment.position);
    add(segment.attitude);
    add(segment.residual_m);
    add(segment.state);
  }
  void add(const Column& column) { columns_.emplace(column, &column); }
  template <class Some, std::size_t kCount>
  void add(const std::array<Some, kCount>& columns) {
    for (const auto& some : columns) add(some);
  }
  template <class Some>
  void add(const OfHands<Some>& columns) {
    for (const Hand hand : kBothHands) add(columns[hand]);
  }
  std::map<std::string_view, const Column*> columns_;
};

}  // namespace

const Column* find(std::string_view name) {
  static const ByName kAll(
      t_s, task_time_s, phase, sample_flags, target_force_N, actual_force_N, resting_force_N,
      maximum_force_N, noise_sd_N, resolution_N, device_delay_s, display_delay_s, segment, cue,
      channel_digits, channel_direction, force_shown, target_shown, target_index, targets_reached,
      drops, target_force, finger_force, finger_torque, finger_flags, net_force, net_torque,
      net_push_percent, hand_force, raw_force, raw_torque, target_position, actual_position,
      target_attitude, actual_attitude, target_angle_rad, actual_angle_rad, object_velocity,
      object_angular_velocity, object_force, object_torque, contact, slip, utilisation,
      model_error_rad, model_inexact, segment_pose, link_angle, reference_position,
      reference_attitude, matched, pause_cause, confidence, unseen_s, palm_position, palm_attitude,
      thumb_index_gap_m, abduction, flexion, fit_residual_m, hand_joint, placement, study_object,
      assistance, eased, placement_fails, let_go_asked, object_helped, object_held, object_touched,
      object_supported, grasp_state, pull_N, touch_N, gap_m, release_pull_N, grasp_digits,
      grasp_feasible, grasp_G_min, grasp_H_min, grasp_H_det, grasp_G_min_limit, grasp_H_min_limit,
      grasp_H_det_limit, tracked_gap_m, solver_sweeps, solver_residual_mps, virtual_palm_position,
      virtual_palm_attitude, virtual_angle, hand_grip, target_hand_grip, hand_cue, hand_force_shown,
      hand_resting_force_N, hand_maximum_force_N, sum_force_N, target_sum_force_N, sum_force_shown,
      affected_hand, platforms_coupled, skew_s, hands_finger_force, hands_finger_torque,
      hands_finger_flags, hand_push, hand_squeeze_N, hand_contact, hand_slip, hand_utilisation,
      hand_end, on_rest, object_strength, hand_point, hand_bubble, hand_excess, hand_at_edge_N,
      hand_on_N, both_hold, joint_control, clutch_held, left_share, hands_raw_force,
      hands_raw_torque, lateness_s, compute_s);
  return kAll.find(name);
}

}  // namespace isograsp::columns
