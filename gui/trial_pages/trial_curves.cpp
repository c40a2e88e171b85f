// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/trial_pages/trial_curves.hpp"

#include <QObject>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "gui/hand_pages/hand_words.hpp"
#include "gui/look/look.hpp"
#include "gui/trial_pages/arm_replay.hpp"
#include "gui/trial_pages/hand_replay.hpp"
#include "gui/words/words.hpp"
#include "hand/hand_columns.hpp"
#include "hand/two_hands_columns.hpp"

namespace isograsp::gui {

namespace {

/// Told apart with every kind of colour vision (Okabe and Ito), dark enough on white.
const std::array<QColor, 6> kCycle{look::kFingers[0],     look::kFingers[1],     look::kFingers[2],
                                   look::kOtherCurves[0], look::kOtherCurves[1], look::kText};

struct Unit {
  const char* ending;  ///< of the column's name
  const char* text;
  double factor;
};
constexpr double kDegrees = 180.0 / std::numbers::pi;
// Longer endings stand before those that they end in.
constexpr Unit kUnits[] = {{"_radps", "°/s", kDegrees},
                           {"_mps", "mm/s", 1000.0},
                           {"_counts", QT_TRANSLATE_NOOP("QObject", "counts"), 1.0},
                           {"_percent", "%", 1.0},
                           {"_rad", "°", kDegrees},
                           {"_Nm", "N mm", 1000.0},
                           {"_N", "N", 1.0},
                           {"_m", "mm", 1000.0},
                           {"_s", "s", 1.0}};

TrialCurve curve_of(const TrialReplay& replay, const std::string& column, const QString& name,
                    const QColor& colour) {
  TrialCurve curve;
  curve.column = replay.signals().find(column);
  curve.name = name;
  curve.colour = colour;
  curve.target = (column.starts_with(columns::kTarget) && column != columns::target_index &&
                  column != columns::target_shown) ||
                 column == columns::release_pull_N;
  for (const Unit& unit : kUnits) {
    if (!column.ends_with(unit.ending)) continue;
    curve.unit = QObject::tr(unit.text);
    curve.factor = unit.factor;
    break;
  }
  for (const Finger finger : kFingers)
    if (replay.has_fingers() && column.starts_with(name_of(finger)) &&
        (curve.unit == "N" || curve.unit == "N mm"))
      curve.finger = finger;
  curve.of_hand = column == columns::actual_force_N || column.starts_with("net_");
  return curve;
}

bool has_numbers(const TrialReplay& replay, const std::string& column) {
  for (const double value : replay.signals().column(column))
    if (std::isfinite(value)) return true;
  return false;
}

constexpr std::array<std::pair<CurveSet, ArmLink>, kArmLinkCount> kLinkSets{
    {{CurveSet::forearm, ArmLink::forearm},
     {CurveSet::wrist, ArmLink::wrist},
     {CurveSet::fingers, ArmLink::fingers}}};

}  // namespace

std::vector<CurveSet> sets_of(const TrialReplay& replay) {
  std::vector<CurveSet> sets;
  const bool hand = HandReplay::is_of_hand(replay);
  if (!ArmReplay::is_of_arm(replay) && !hand) sets.push_back(CurveSet::forces);
  if (has_numbers(replay, columns::release_pull_N)) sets.push_back(CurveSet::pulls);
  if (hand) sets.push_back(CurveSet::opening);
  for (const auto& [set, link] : kLinkSets)
    if (has_numbers(replay, columns::link_angle[index_of(link)][0])) sets.push_back(set);
  if (has_numbers(replay, columns::actual_position[0])) sets.push_back(CurveSet::position);
  if (has_numbers(replay, columns::actual_angle_rad)) sets.push_back(CurveSet::attitude);
  sets.push_back(CurveSet::chosen);
  return sets;
}

QString words_of(CurveSet set) {
  switch (set) {
    case CurveSet::forces: return QObject::tr("Forces and target");
    case CurveSet::forearm: return QObject::tr("Angles of the forearm");
    case CurveSet::wrist: return QObject::tr("Angles of the wrist");
    case CurveSet::fingers: return QObject::tr("Angles of the fingers");
    case CurveSet::pulls: return QObject::tr("Pull of the fingers on their ties");
    case CurveSet::opening: return QObject::tr("Opening of the hand");
    case CurveSet::position: return QObject::tr("Position of the object");
    case CurveSet::attitude: return QObject::tr("Angle of the object");
    case CurveSet::chosen: return QObject::tr("Any recorded channel …");
  }
  return {};
}

std::vector<TrialCurve> curves_of(const TrialReplay& replay, CurveSet set,
                                  const std::vector<std::string>& chosen) {
  std::vector<TrialCurve> curves;
  const auto add = [&](const std::string& column, const QString& name, const QColor& colour) {
    if (has_numbers(replay, column)) curves.push_back(curve_of(replay, column, name, colour));
  };
  switch (set) {
    case CurveSet::forces:
      for (const Finger finger : kFingers)
        add(columns::finger_force[index_of(finger)][2], finger_title(finger),
            look::kFingers[index_of(finger)]);
      add(columns::actual_force_N, QObject::tr("Task’s force"), look::kText);
      add(columns::target_force_N, QObject::tr("Target"), look::kText);
      add(columns::hand_grip.left, QObject::tr("Left hand"), kCycle[0]);
      add(columns::target_hand_grip.left, QObject::tr("Target of the left hand"), kCycle[0]);
      add(columns::hand_grip.right, QObject::tr("Right hand"), kCycle[1]);
      add(columns::target_hand_grip.right, QObject::tr("Target of the right hand"), kCycle[1]);
      add(columns::sum_force_N, QObject::tr("Both hands"), look::kText);
      add(columns::target_sum_force_N, QObject::tr("Target"), look::kText);
      break;
    case CurveSet::forearm:
    case CurveSet::wrist:
    case CurveSet::fingers:
      for (const auto& [of, link] : kLinkSets)
        for (std::size_t a = 0; of == set && a < 3; ++a)
          add(columns::link_angle[index_of(link)][a], QObject::tr("Angle %1").arg(a + 1),
              kCycle[a]);
      break;
    case CurveSet::pulls:
      for (std::size_t d = 0; d < kDigitCount; ++d)
        add(columns::pull_N[d], digit_title(static_cast<Digit>(d)), kCycle[d]);
      add(columns::release_pull_N, QObject::tr("lets go above"), look::kText);
      break;
    case CurveSet::opening:
      add(columns::thumb_index_gap_m, QObject::tr("Thumb to index"), kCycle[0]);
      break;
    case CurveSet::position:
      for (const std::size_t axis : {0U, 1U, 2U}) {
        const QString name = QString(QLatin1Char("xyz"[axis]));
        add(columns::actual_position[axis], name, kCycle[axis]);
        add(columns::target_position[axis], QObject::tr("target %1").arg(name), kCycle[axis]);
      }
      break;
    case CurveSet::attitude:
      add(columns::actual_angle_rad, QObject::tr("Angle"), kCycle[0]);
      add(columns::target_angle_rad, QObject::tr("Target"), kCycle[0]);
      break;
    case CurveSet::chosen:
      for (const auto& column : chosen)
        if (replay.signals().has(column))
          curves.push_back(curve_of(replay, column, QString::fromStdString(column),
                                    kCycle[curves.size() % kCycle.size()]));
      break;
  }
  return curves;
}

SampleQuality quality_of(const TrialReplay& replay, const TrialCurve& curve, std::size_t row) {
  if (curve.finger) return replay.quality(row, *curve.finger);
  return curve.of_hand ? replay.quality(row) : SampleQuality::measured;
}

QString reading(const TrialReplay& replay, const TrialCurve& curve, double t_s) {
  if (replay.rows() == 0 || !curve.column) return {};
  const std::size_t row = replay.row_at(t_s);
  const auto times = replay.signals().column(columns::t_s);
  const bool in_gap = replay.gap_after(row) && t_s - times[row] >= replay.period_s();
  const auto quality = quality_of(replay, curve, row);
  if (in_gap || quality == SampleQuality::missing) return QObject::tr("no sample");
  const double value = replay.signals().column(*curve.column)[row];
  if (!std::isfinite(value)) return QStringLiteral("–");
  const auto number = short_number(curve.factor * value);
  const auto text = curve.unit.isEmpty() ? number : QObject::tr("%1 %2").arg(number, curve.unit);
  return quality == SampleQuality::held ? QObject::tr("%1 held").arg(text) : text;
}

}  // namespace isograsp::gui
