// SPDX-License-Identifier: GPL-3.0-or-later
// Recorded channels of a trial over time, with what happened and a cursor. What was held is dotted,
// where samples are missing the curve is interrupted and a bar stands below.
#pragma once

#include <QWidget>
#include <vector>

#include "gui/trial_pages/opened_trial.hpp"
#include "gui/trial_pages/trial_curves.hpp"

class QCustomPlot;
class QCPItemStraightLine;

namespace isograsp::gui {

/// "F" for a fault, "P" for a pause: the letter at the mark of an event.
[[nodiscard]] QString mark_letter(const std::string& kind);
/// "fault", "pause" … in words.
[[nodiscard]] QString mark_words(const std::string& kind);

class TrialPlot final : public QWidget {
  Q_OBJECT

 public:
  explicit TrialPlot(QWidget* parent = nullptr);

  /// The stretch of time that is seen stays if the trial is the same one.
  void show_trial(const TrialReplay& replay, const std::vector<TrialCurve>& curves,
                  const std::vector<TrialMark>& marks);
  void show_whole();  ///< the whole trial from begin to end
  void set_cursor(double t_s);
  /// Twice as large, or half, around the cursor.
  void zoom(bool in);

 Q_SIGNALS:
  void sought(double t_s);   ///< the cursor is wanted there
  void stepped(int frames);  ///< … or this many samples further

 protected:
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;

 private:
  void add_curve(const TrialReplay& replay, const TrialCurve& curve);
  void add_missing(const TrialReplay& replay, const std::vector<TrialCurve>& curves);
  void add_stretches(const TrialReplay& replay);
  void add_marks(const std::vector<TrialMark>& marks);
  void seek_to(const QPoint& place);
  void show_stretch(double from_s, double to_s);

  QCustomPlot* plot_;
  QCPItemStraightLine* cursor_;
  double cursor_s_ = 0.0;
  double begin_s_ = 0.0;
  double end_s_ = 1.0;
};

}  // namespace isograsp::gui
