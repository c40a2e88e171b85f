// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/trial_pages/replay_window.hpp"

#include <QPainter>
#include <utility>

#include "gui/look/look.hpp"

namespace isograsp::gui {

void ReplayWindow::show_trial(std::shared_ptr<const LoadedTrial> trial) {
  trial_ = std::move(trial);
  path_ = {};
  show_state({});
}

void ReplayWindow::show_state(const ReplayState& state) {
  const bool object = trial_ != nullptr && (trial_->arm || trial_->tracked || state.X_WO);
  show_picture(object ? picture_at(*trial_, state) : PatientPicture{});
}

void ReplayWindow::draw_path(const Project& project, QSize size_px) {
  path_ = QImage(size_px, QImage::Format_ARGB32_Premultiplied);
  path_.fill(Qt::transparent);
  QPainter painter(&path_);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(look::kAccent, 1.5));
  QPolygonF stretch;
  for (const auto& p : trial_->path) {
    if (p.allFinite()) {
      stretch << project(p);
      continue;
    }
    painter.drawPolyline(stretch);
    stretch.clear();
  }
  painter.drawPolyline(stretch);
}

void ReplayWindow::paint_over(QPainter& painter, const Project& project, QSize size_px) {
  if (path_.size() != size_px) draw_path(project, size_px);
  painter.drawImage(0, 0, path_);
}

}  // namespace isograsp::gui
