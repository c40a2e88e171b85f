// SPDX-License-Identifier: GPL-3.0-or-later
// What is known about a stored trial: its measures, what happened in it, task, zero, health.
#pragma once

#include <QTableWidget>

#include "gui/trial_pages/loaded_trial.hpp"

namespace isograsp::gui {

/// "12.34".
[[nodiscard]] QString seconds_text(double t_s);

class TrialAbout final : public QTableWidget {
  Q_OBJECT

 public:
  explicit TrialAbout(QWidget* parent = nullptr);
  void show_trial(const LoadedTrial& trial);

 Q_SIGNALS:
  void sought(double t_s);  ///< an event was chosen: its time

 private:
  int add(const QString& what, const QString& value, bool bold, const QString& tip = {});
  void add_heading(const QString& text);
  void add_measures(const LoadedTrial& trial, const QString& title, bool drawn);
  void add_marks(const std::vector<TrialMark>& marks);
  void add_story(const std::vector<GraspEvent>& story);
};

}  // namespace isograsp::gui
