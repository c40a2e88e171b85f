// SPDX-License-Identifier: GPL-3.0-or-later
// The device in a session: choosing and connecting it, its zero with the hand out.
#pragma once

#include <QFrame>
#include <QLabel>
#include <QListWidget>
#include <QProgressBar>
#include <QPushButton>
#include <QWidget>

#include "gui/clinic/settings.hpp"
#include "gui/clinic/staff.hpp"
#include "gui/presenter/session_presenter.hpp"

namespace isograsp::gui {

/// What is present now, simulated patients, recordings.
class ConnectForm final : public QWidget {
  Q_OBJECT

 public:
  ConnectForm(SessionPresenter& presenter, SettingsFile& settings, Staff& staff,
              QWidget* parent = nullptr);

 private:
  void fill(const std::string& preset);
  void choose(int row);
  void choose_recording();
  void choose_cameras();
  void add_device();
  void forget_device();
  void refresh();

  SessionPresenter& presenter_;
  SettingsFile& settings_;
  QListWidget* devices_;
  QPushButton* forget_;  ///< what was added
  QPushButton* connect_;
  QProgressBar* progress_;
};

/// The empty device becomes zero: one press that says that it is empty.
class ZeroForm final : public QWidget {
  Q_OBJECT

 public:
  explicit ZeroForm(SessionPresenter& presenter, QWidget* parent = nullptr);

 private:
  void refresh();
  void refresh_progress();

  SessionPresenter& presenter_;
  QPushButton* zero_;
  QLabel* empty_;
  QPushButton* changed_;
  QProgressBar* progress_;
};

}  // namespace isograsp::gui
