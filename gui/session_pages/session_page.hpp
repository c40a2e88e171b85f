// SPDX-License-Identifier: GPL-3.0-or-later
// One session, left to right: prepare, watch, run. Once trials run, what was prepared is folded to
// a row above the curve, until it is asked for or something of it is to be done again.
#pragma once

#include <QGridLayout>
#include <QStackedWidget>
#include <QWidget>

#include "gui/clinic/clinic.hpp"
#include "gui/clinic/staff.hpp"
#include "gui/presenter/session_presenter.hpp"

namespace isograsp::gui {

class ClosingPanel;
class PreparePanel;

class SessionPage final : public QWidget {
  Q_OBJECT

 public:
  SessionPage(Clinic& clinic, SessionPresenter& presenter, SettingsFile& settings, Staff& staff,
              QWidget* parent = nullptr);

  [[nodiscard]] bool printing() const;

 Q_SIGNALS:
  void other_patient();
  void report_wanted();
  void end_wanted();                          ///< of the session; the next patient comes
  void sent(const QString& code, bool done);  ///< to the printer

 private:
  [[nodiscard]] QWidget* make_watch(Clinic& clinic, const SettingsFile& settings);
  [[nodiscard]] QWidget* make_run();
  [[nodiscard]] QWidget* make_closing(Clinic& clinic, QWidget* watch);
  void arrange();
  void refresh();
  void fold(bool folded);

  SessionPresenter& presenter_;
  bool in_a_row_;
  QGridLayout* grid_;
  PreparePanel* prepare_;
  ClosingPanel* closing_;
  QWidget* watch_;
  QWidget* run_;
  bool folded_ = false;
  bool asked_for_ = false;  ///< the steps are, by hand, while they would be folded
  bool in_trial_ = false;
};

}  // namespace isograsp::gui
