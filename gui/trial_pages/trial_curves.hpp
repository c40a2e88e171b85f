// SPDX-License-Identifier: GPL-3.0-or-later
// Which recorded channels of a trial are drawn together, and what they are called.
#pragma once

#include <QColor>
#include <QString>
#include <optional>
#include <string>
#include <vector>

#include "gui/trial_pages/trial_replay.hpp"

namespace isograsp::gui {

/// What is seen first of a trial; `chosen`: any of the recorded channels.
enum class CurveSet : std::uint8_t {
  forces,
  forearm,  ///< angles of a link of an arm; so are the next two
  wrist,
  fingers,
  pulls,    ///< of the digits of a tracked hand on their ties, with what these hold
  opening,  ///< of thumb and index
  position,
  attitude,
  chosen
};

struct TrialCurve {
  std::optional<std::size_t> column;  ///< of the signals
  QString name;                       ///< "Thumb"
  QString unit;                       ///< as drawn: mm and degrees for people
  double factor = 1.0;
  QColor colour;
  bool target = false;           ///< drawn dashed
  std::optional<Finger> finger;  ///< whose flags tell what was measured
  bool of_hand = false;          ///< … or those of all fingers
};

/// The sets that this trial has something for.
[[nodiscard]] std::vector<CurveSet> sets_of(const TrialReplay& replay);
[[nodiscard]] QString words_of(CurveSet set);
/// `chosen`: columns by name, for CurveSet::chosen only.
[[nodiscard]] std::vector<TrialCurve> curves_of(const TrialReplay& replay, CurveSet set,
                                                const std::vector<std::string>& chosen = {});
/// Was this sample of the curve measured, held or missing?
[[nodiscard]] SampleQuality quality_of(const TrialReplay& replay, const TrialCurve& curve,
                                       std::size_t row);
/// "3.21 N", "3.21 N held", "no sample": at the row that is in force at this time.
[[nodiscard]] QString reading(const TrialReplay& replay, const TrialCurve& curve, double t_s);

}  // namespace isograsp::gui
