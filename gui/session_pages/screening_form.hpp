// SPDX-License-Identifier: GPL-3.0-or-later
// The screening on one screen: what applies, pain, and the therapist's decision. Where nothing
// applies one press answers all.
#pragma once

#include <QCheckBox>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>
#include <QWidget>
#include <array>

#include "gui/look/score_row.hpp"
#include "gui/presenter/session_presenter.hpp"

namespace isograsp::gui {

class ScreeningForm final : public QWidget {
  Q_OBJECT

 public:
  explicit ScreeningForm(SessionPresenter& presenter, QWidget* parent = nullptr);

 private:
  void make_questions(QVBoxLayout& column);
  void make_decision(QVBoxLayout& column);
  void make_limit(QVBoxLayout& column);
  void refresh();
  void answer(Screening answers);

  SessionPresenter& presenter_;
  QPushButton* nothing_;
  std::array<QCheckBox*, kCautionCount> cautions_{};
  ScoreRow* pain_;
  std::array<QPushButton*, 3> efforts_{};  ///< by Effort
  QCheckBox* limited_;
  QSpinBox* ceiling_;
  QLabel* advice_;
};

}  // namespace isograsp::gui
