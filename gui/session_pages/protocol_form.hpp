// SPDX-License-Identifier: GPL-3.0-or-later
// The work of a session: which protocol, how long it takes, its steps and where it stands.
#pragma once

#include <QComboBox>
#include <QFrame>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QWidget>
#include <optional>

#include "gui/presenter/session_presenter.hpp"

namespace isograsp::gui {

/// Chosen before connecting, with the steps that it will have.
class ProtocolForm final : public QWidget {
  Q_OBJECT

 public:
  explicit ProtocolForm(SessionPresenter& presenter, QWidget* parent = nullptr);

 private:
  void make_question();
  void fill_protocols();
  void refresh();
  void fill_steps();

  SessionPresenter& presenter_;
  QComboBox* protocols_;
  QLabel* duration_;
  QFrame* earlier_;
  QLabel* question_;
  QPushButton* go_on_;
  QPushButton* anew_;
  QListWidget* steps_;
  bool is_described_ = false;     ///< the duration that is shown is that of
  std::optional<int> described_;  ///< this protocol; nothing: of tasks chosen one by one
  ProtocolGuide preview_;         ///< its steps
  std::vector<ProtocolGuide::Row> shown_;
};

/// "about 11 min, at most 16 min"
[[nodiscard]] QString duration_words(const tasks::Duration& duration);

}  // namespace isograsp::gui
