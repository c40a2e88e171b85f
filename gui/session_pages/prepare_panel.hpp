// SPDX-License-Identifier: GPL-3.0-or-later
// The left column of a session: its steps in order, the next one open; folded a row above the work.
#pragma once

#include <QBoxLayout>
#include <QPushButton>
#include <QWidget>
#include <array>
#include <functional>

#include "gui/clinic/settings.hpp"
#include "gui/clinic/staff.hpp"
#include "gui/presenter/session_presenter.hpp"
#include "gui/session_pages/step_section.hpp"

namespace isograsp::gui {

class PreparePanel final : public QWidget {
  Q_OBJECT

 public:
  PreparePanel(SessionPresenter& presenter, SettingsFile& settings, Staff& staff,
               QWidget* parent = nullptr);

  void fold(bool folded);
  [[nodiscard]] bool any_open() const;

 Q_SIGNALS:
  void other_patient();  ///< the therapist wants to choose one
  void head_pressed();   ///< of a step, which is about to be opened or closed
  void opened();         ///< one was opened or closed

 private:
  [[nodiscard]] QWidget* make_hand();
  [[nodiscard]] QWidget* make_screening();
  [[nodiscard]] QWidget* make_zero();
  [[nodiscard]] QString summary_of(Step step) const;
  [[nodiscard]] QString folded_words(Step step, const QString& summary) const;
  void name_sides();
  void refresh();

  void share_room();

  SessionPresenter& presenter_;
  QBoxLayout* row_;
  bool folded_ = false;
  QPushButton* left_;
  QPushButton* right_;
  QPushButton* both_;
  QPushButton* confirm_hand_;
  std::array<StepSection*, kStepCount> sections_{};
};

}  // namespace isograsp::gui
