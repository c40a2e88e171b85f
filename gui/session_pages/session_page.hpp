// SPDX-License-Identifier: GPL-3.0-or-later
// One session, left to right: prepare, watch, run.
#pragma once

#include <QWidget>

#include "gui/clinic/clinic.hpp"
#include "gui/clinic/staff.hpp"
#include "gui/presenter/session_presenter.hpp"

namespace isograsp::gui {

class SessionPage final : public QWidget {
  Q_OBJECT

 public:
  SessionPage(SessionPresenter& presenter, const SettingsFile& settings, Staff& staff,
              QWidget* parent = nullptr);

 Q_SIGNALS:
  void other_patient();
  void report_wanted();
};

}  // namespace isograsp::gui
