// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/trial_pages/recorded_values.hpp"

#include "hand/hand_columns.hpp"

namespace isograsp::gui {

PosePlaces find_pose(const Signals& signals, const columns::OfAxes& position,
                     const columns::OfComponents& attitude) {
  PosePlaces places;
  for (std::size_t i = 0; i < position.size(); ++i) places.position[i] = signals.find(position[i]);
  for (std::size_t i = 0; i < attitude.size(); ++i) places.attitude[i] = signals.find(attitude[i]);
  return places;
}

double value_at(const Signals& signals, Place column, std::size_t row) {
  return column ? signals.column(*column)[row] : kMissing;
}

Vec3 vector_at(const Signals& signals, const std::array<Place, 3>& places, std::size_t row) {
  return {value_at(signals, places[0], row), value_at(signals, places[1], row),
          value_at(signals, places[2], row)};
}

Pose pose_at(const Signals& signals, const PosePlaces& places, std::size_t row) {
  const Vec3 p = vector_at(signals, places.position, row);
  Eigen::Vector4d q;
  for (std::size_t i = 0; i < places.attitude.size(); ++i)
    q[static_cast<Eigen::Index>(i)] = value_at(signals, places.attitude[i], row);
  if (!p.allFinite() || !q.allFinite() || !(q.norm() > 0.0)) return missing_pose();
  return {p, Quat(q[0], q[1], q[2], q[3]).normalized()};
}

ChoicePlaces find_choice(const Signals& signals) {
  const std::array<const Column*, 6> kCriteria{
      &columns::grasp_G_min,       &columns::grasp_H_min,       &columns::grasp_H_det,
      &columns::grasp_G_min_limit, &columns::grasp_H_min_limit, &columns::grasp_H_det_limit};
  ChoicePlaces places;
  places.digits = signals.find(columns::grasp_digits);
  places.feasible = signals.find(columns::grasp_feasible);
  for (std::size_t k = 0; k < places.criteria.size(); ++k)
    places.criteria[k] = signals.find(*kCriteria[k]);
  return places;
}

virtual_hand::GraspChoice choice_at(const Signals& signals, const ChoicePlaces& places,
                                    std::size_t row) {
  constexpr double kSets = 1 << kDigitCount;
  virtual_hand::GraspChoice choice;
  const double digits = value_at(signals, places.digits, row);
  if (!(digits > 0.0 && digits < kSets)) return choice;
  choice.digits = static_cast<virtual_hand::DigitSet>(digits);
  choice.feasible = value_at(signals, places.feasible, row) > 0.0;
  const std::array<double*, 6> into{&choice.G_min,       &choice.H_min,       &choice.H_det,
                                    &choice.G_min_limit, &choice.H_min_limit, &choice.H_det_limit};
  for (std::size_t k = 0; k < into.size(); ++k)
    *into[k] = value_at(signals, places.criteria[k], row);
  return choice;
}

}  // namespace isograsp::gui
