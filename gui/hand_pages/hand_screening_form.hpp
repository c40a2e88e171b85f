// SPDX-License-Identifier: GPL-3.0-or-later
// The screening of a tracked hand on one screen: what applies, pain, whether the forearm lies on
// something, and the therapist's decision. Where nothing applies one press answers all.
#pragma once

#include <QCheckBox>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <QWidget>
#include <array>
#include <functional>

#include "gui/look/score_row.hpp"
#include "gui/presenter/session_presenter.hpp"

namespace isograsp::gui {

class HandScreeningForm final : public QWidget {
  Q_OBJECT

 public:
  explicit HandScreeningForm(SessionPresenter& presenter, QWidget* parent = nullptr);

 private:
  void make_hand_questions(QVBoxLayout& column);
  void make_hand_decision(QVBoxLayout& column);
  void refresh();
  /// Changes the answers; whatever changes is decided anew.
  void answer(const std::function<void(HandScreening&)>& change);

  SessionPresenter& presenter_;
  QPushButton* nothing_;
  std::array<QCheckBox*, kHandQuestionCount> questions_{};
  ScoreRow* pain_;
  QCheckBox* forearm_;
  QPushButton* moves_;
  QPushButton* rests_;
  QLabel* advice_;
};

}  // namespace isograsp::gui
