// SPDX-License-Identifier: GPL-3.0-or-later
// The screening on one screen: what applies, pain, and the therapist's decision. Where nothing
// applies one press answers all. Of one hand that works, or of one of both.
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
  /// `of`: of which of both hands, whose form is shown by who owns it; nothing: one hand works.
  explicit ScreeningForm(SessionPresenter& presenter, std::optional<Hand> of = std::nullopt,
                         QWidget* parent = nullptr);
  void show_form(bool shown);

 private:
  void make_questions(QVBoxLayout& column);
  void make_decision(QVBoxLayout& column);
  void make_limit(QVBoxLayout& column);
  void refresh();
  void answer(Screening answers);
  [[nodiscard]] QString name_of_part(const QString& part) const;
  [[nodiscard]] const Screening& answers() const;

  SessionPresenter& presenter_;
  std::optional<Hand> of_;
  QPushButton* nothing_;
  std::array<QCheckBox*, kCautionCount> cautions_{};
  ScoreRow* pain_;
  std::array<QPushButton*, 3> efforts_{};  ///< by Effort
  QCheckBox* limited_;
  QSpinBox* ceiling_;
  QLabel* advice_;
};

}  // namespace isograsp::gui
