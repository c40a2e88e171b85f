// SPDX-License-Identifier: GPL-3.0-or-later
// The screening of an arm on one screen: what applies, what the arm can do, pain, the passive range
// of its joints, and the therapist's decision. Where nothing applies one press answers all.
#pragma once

#include <QCheckBox>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>
#include <QWidget>
#include <array>
#include <functional>

#include "gui/look/score_row.hpp"
#include "gui/presenter/session_presenter.hpp"

namespace isograsp::gui {

class ArmScreeningForm final : public QWidget {
  Q_OBJECT

 public:
  explicit ArmScreeningForm(SessionPresenter& presenter, QWidget* parent = nullptr);

 private:
  /// One joint: whether its range was measured, and how far it goes to either side.
  struct JointRow {
    QCheckBox* measured;
    QSpinBox* negative;
    QSpinBox* positive;
  };
  void make_questions(QVBoxLayout& column);
  void make_ranges(QVBoxLayout& column);
  void make_decision(QVBoxLayout& column);
  void refresh();
  /// Changes the answers; whatever changes is decided anew.
  void answer(const std::function<void(ArmScreening&)>& change);

  SessionPresenter& presenter_;
  QPushButton* nothing_;
  std::array<QCheckBox*, kArmQuestionCount> questions_{};
  ScoreRow* pain_;
  std::array<JointRow, kPassiveJointCount> joints_{};
  std::array<QPushButton*, 3> ranges_{};  ///< by Effort
  QLabel* advice_;
};

}  // namespace isograsp::gui
