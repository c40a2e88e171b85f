// SPDX-License-Identifier: GPL-3.0-or-later
// Live forces: a value and a bar per finger, the last seconds as curves, the health of the stream.
#pragma once

#include <QPushButton>
#include <array>

#include "gui/force_pages/channel_table.hpp"
#include "gui/look/card.hpp"
#include "gui/look/plot_view.hpp"
#include "gui/presenter/session_presenter.hpp"

namespace isograsp::gui {

/// One finger: swatch, name, value and a bar; signed, pulling goes left of the mark.
class FingerBar final : public QWidget {
  Q_OBJECT

 public:
  explicit FingerBar(Finger finger, QWidget* parent = nullptr);
  void show_force(double normal_N, double full_N, std::uint8_t flags, bool known);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  Finger finger_;
  double normal_N_ = 0.0;
  double full_N_ = 1.0;
  bool known_ = false;
  QString remark_;
};

class LivePanel final : public Card {
  Q_OBJECT

 public:
  LivePanel(SessionPresenter& presenter, const SettingsFile& settings, QWidget* parent = nullptr);

 private:
  void refresh();
  [[nodiscard]] double shown_maximum_N() const noexcept;

  SessionPresenter& presenter_;
  const SettingsFile& settings_;
  std::array<FingerBar*, kFingerCount> fingers_{};
  QLabel* grip_;
  LivePlot* plot_;
  QPushButton* all_;
  ChannelTable* channels_;
  QLabel* compensation_;
  QLabel* health_;
  int polls_ = 0;
};

}  // namespace isograsp::gui
