// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/library_pages/patch_sketch.hpp"

#include <QStringList>
#include <algorithm>
#include <cmath>

#include "gui/look/look.hpp"

namespace isograsp::gui {

namespace {

constexpr int kPanelsAcross = 3;
constexpr int kPanel_px = 132;
constexpr int kPadTitle_px = 20;
constexpr int kFoot_px = 24;  ///< scale and legend
constexpr double kMark_px = 2.6;
constexpr double kAround = 1.3;  ///< of the pad's reach, that is seen
constexpr double kScale_m = 0.005;

/// Where a ray ended before the pad did: a square at an edge, a triangle where friction ends, a
/// diamond at the border of a surface.
void draw_mark(QPainter& painter, RayStop stop, const QPointF& at) {
  const auto corner = [&](double x, double y) { return at + kMark_px * QPointF(x, y); };
  QPolygonF mark;
  switch (stop) {
    case RayStop::length: return;
    case RayStop::edge:
      mark << corner(-1, -1) << corner(1, -1) << corner(1, 1) << corner(-1, 1);
      break;
    case RayStop::cone: mark << corner(0, -1.3) << corner(1.2, 1) << corner(-1.2, 1); break;
    case RayStop::boundary:
      mark << corner(0, -1.4) << corner(1.4, 0) << corner(0, 1.4) << corner(-1.4, 0);
      break;
  }
  painter.setPen(Qt::NoPen);
  painter.setBrush(look::kFault);
  painter.drawPolygon(mark);
}

}  // namespace

PatchSketch::PatchSketch(QWidget* parent) : QWidget(parent) {}

void PatchSketch::show_patches(const std::vector<LibraryPreview::Patch>& patches) {
  patches_ = patches;
  const int rows = (static_cast<int>(patches.size()) + kPanelsAcross - 1) / kPanelsAcross;
  setFixedHeight(rows * scaled(kPanel_px) + scaled(kFoot_px));
  QStringList titles;
  for (const auto& patch : patches) titles << patch.title;
  setAccessibleName(tr("What the pads cover of the object: %1").arg(titles.join(", ")));
  setToolTip(
      tr("Each as the pad looks at the object, tangent up; dashed: the whole pad; filled: what it "
         "covers; cross: the middle of that; red: where a ray ends before the pad does"));
  update();
}

QRectF PatchSketch::panel(int index) const {
  const int across = std::min(kPanelsAcross, static_cast<int>(patches_.size()));
  const double width_px = static_cast<double>(width()) / across;
  return {(index % kPanelsAcross) * width_px,
          static_cast<double>((index / kPanelsAcross) * scaled(kPanel_px)), width_px,
          static_cast<double>(scaled(kPanel_px))};
}

/// The same for all, so that pads can be compared.
double PatchSketch::px_per_m() const {
  double reach_m = 1e-3;
  for (const auto& patch : patches_)
    for (const QPointF& p : patch.pad)
      reach_m = std::max({reach_m, std::abs(p.x()), std::abs(p.y())});
  const double room_px =
      std::min(panel(0).width() - scaled(8), static_cast<double>(scaled(kPanel_px - kPadTitle_px)));
  return room_px / (2.0 * kAround * reach_m);
}

void PatchSketch::paintEvent(QPaintEvent*) {
  if (patches_.empty()) return;
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  for (std::size_t i = 0; i < patches_.size(); ++i)
    draw_patch(painter, patches_[i], panel(static_cast<int>(i)));
  draw_foot(painter);
}

void PatchSketch::draw_patch(QPainter& painter, const LibraryPreview::Patch& patch,
                             const QRectF& panel) const {
  painter.setPen(look::kText);
  painter.drawText(
      QRectF(panel.left(), panel.top(), panel.width(), scaled(kPadTitle_px)), Qt::AlignCenter,
      fontMetrics().elidedText(patch.title, Qt::ElideRight, static_cast<int>(panel.width())));
  const QRectF area = panel.adjusted(scaled(4), scaled(kPadTitle_px), -scaled(4), -scaled(2));
  const Place on{area.center(), px_per_m()};
  painter.save();
  painter.setClipRect(area);
  painter.setBrush(look::kTrack);
  painter.setPen(QPen(look::kText, 1.4));
  painter.drawPolygon(on.shape(patch.object));
  QColor covered = look::kPaleAccent;
  covered.setAlpha(150);
  painter.setBrush(covered);
  painter.setPen(QPen(look::kAccent, 1.6));
  painter.drawPolygon(on.shape(patch.outline));
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(look::kQuietText, 1.2, Qt::DashLine));
  painter.drawPolygon(on.shape(patch.pad));
  for (std::size_t k = 0; k < patch.stops.size(); ++k)
    draw_mark(painter, patch.stops[k], on.at(patch.outline[static_cast<int>(k)]));
  const QPointF middle = on.at(patch.centroid);
  const double arm_px = scaled(5);
  painter.setPen(QPen(look::kAccent, 2.0));
  painter.drawLine(middle - QPointF(arm_px, 0), middle + QPointF(arm_px, 0));
  painter.drawLine(middle - QPointF(0, arm_px), middle + QPointF(0, arm_px));
  painter.restore();
}

/// The scale, and what the marks that are there mean.
void PatchSketch::draw_foot(QPainter& painter) const {
  const double base_px = height() - scaled(8);
  painter.setPen(QPen(look::kQuietText, 1.5));
  const double bar_px = px_per_m() * kScale_m;
  painter.drawLine(QPointF(12, base_px), QPointF(12 + bar_px, base_px));
  const double text_px = base_px + fontMetrics().ascent() / 2.0 - 1.0;
  double x_px = 12 + bar_px + scaled(6);
  const auto put = [&](const QString& words) {
    painter.setPen(look::kQuietText);
    painter.drawText(QPointF(x_px, text_px), words);
    x_px += fontMetrics().horizontalAdvance(words) + scaled(14);
  };
  put(tr("%1 mm").arg(1e3 * kScale_m));
  for (const auto& [stop, words] :
       {std::pair{RayStop::edge, tr("edge")}, std::pair{RayStop::cone, tr("friction ends")},
        std::pair{RayStop::boundary, tr("surface ends")}}) {
    const bool there = std::any_of(patches_.begin(), patches_.end(), [&](const auto& patch) {
      return std::find(patch.stops.begin(), patch.stops.end(), stop) != patch.stops.end();
    });
    if (!there) continue;
    draw_mark(painter, stop, QPointF(x_px + kMark_px, base_px));
    x_px += 2.0 * kMark_px + scaled(5);
    put(words);
  }
}

}  // namespace isograsp::gui
