// SPDX-License-Identifier: GPL-3.0-or-later
// Why a virtual object is held and when it is let go, at one instant: each digit with the pull that
// would let it go, and the numbers that decide whether a grasp is helped, beside their limits. For
// the running trial and for a stored one.
#pragma once

#include <QLabel>
#include <QProgressBar>
#include <QWidget>
#include <array>
#include <optional>

#include "gui/rules/hand_live.hpp"

namespace isograsp::gui {

class GraspView final : public QWidget {
  Q_OBJECT

 public:
  enum class Form : std::uint8_t {
    wide,   ///< pulls as bars, too, and criteria by their meaning
    narrow  ///< beside a picture
  };
  /// Its parts are named `prefix` + digit_state_0, digit_pull_0 …, criterion_0 …, grasp_verdict.
  GraspView(const QString& prefix, Form form, QWidget* parent = nullptr);

  /// Nothing: no object is there.
  void show_grasp(const std::optional<GraspLive>& grasp);

 private:
  struct DigitRow {
    QLabel* state;
    QProgressBar* pull;  ///< null: narrow
    QLabel* pull_words;
  };
  struct CriterionRow {
    QLabel* value;
    QLabel* limit;
    QLabel* verdict;
  };
  QLayout* make_digits(const QString& prefix);
  QProgressBar* make_pull(const QString& name, const QString& digit);
  QLayout* make_criteria(const QString& prefix);
  void show_digits(const std::optional<GraspLive>& grasp);
  void show_criteria(const std::optional<GraspLive>& grasp);

  Form form_;
  std::array<DigitRow, kDigitCount> digits_{};
  std::array<CriterionRow, 3> criteria_{};
  QLabel* verdict_;
};

}  // namespace isograsp::gui
