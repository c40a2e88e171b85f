// SPDX-License-Identifier: GPL-3.0-or-later
// The platform of each hand, chosen from what is present.
#pragma once

#include <QListWidget>
#include <QWidget>

#include "gui/clinic/settings.hpp"
#include "gui/presenter/session_presenter.hpp"

namespace isograsp::gui {

class PlatformsForm final : public QWidget {
  Q_OBJECT

 public:
  PlatformsForm(SessionPresenter& presenter, const SettingsFile& settings,
                QWidget* parent = nullptr);

 private:
  void fill();
  void refresh();

  SessionPresenter& presenter_;
  const SettingsFile& settings_;
  OfHands<QListWidget*> lists_;
  OfHands<std::string> filled_;  ///< with what was chosen before standing first
};

}  // namespace isograsp::gui
