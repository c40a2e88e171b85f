// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/path_view.hpp"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "gui/look.hpp"

namespace isograsp {

namespace {
constexpr double kEdge_px = 10.0;
constexpr double kTitle_px = 20.0;
const QColor kTargetColour{0x8A, 0x55, 0x00};
const QColor kPathColour{0x3D, 0x7A, 0xB8};

/// Corners of the box around the object, in object axes.
std::array<Vec3, 8> corners_of(const Scene& scene) {
  Vec3 half = 0.5 * scene.size_m;
  if (scene.shape == Shape::cylinder)
    half = 0.5 * Vec3(scene.size_m[0], scene.size_m[0], scene.size_m[1]);
  if (scene.shape == Shape::sphere) half.setConstant(0.5 * scene.size_m[0]);
  std::array<Vec3, 8> corners;
  for (std::size_t i = 0; i < corners.size(); ++i)
    corners[i] = half.cwiseProduct(
        Vec3((i & 1) != 0 ? 1.0 : -1.0, (i & 2) != 0 ? 1.0 : -1.0, (i & 4) != 0 ? 1.0 : -1.0));
  return corners;
}
}  // namespace

PathView::PathView(QWidget* parent) : QWidget(parent) {
  setMinimumHeight(120);
}

void PathView::show_trial(std::shared_ptr<const LoadedTrial> trial) {
  trial_ = std::move(trial);
  state_ = {};
  least_m_.setConstant(std::numeric_limits<double>::infinity());
  most_m_ = -least_m_;
  const auto take = [this](const Vec3& p) {
    if (!p.allFinite()) return;
    least_m_ = least_m_.cwiseMin(p);
    most_m_ = most_m_.cwiseMax(p);
  };
  for (const auto& p : trial_->path) take(p);
  const auto& signals = trial_->replay.signals();
  const auto xs = signals.column("target_x_m");
  const auto ys = signals.column("target_y_m");
  const auto zs = signals.column("target_z_m");
  for (std::size_t row = 0; row < std::min(xs.size(), ys.size()); ++row)
    take(Vec3(xs[row], ys[row], zs.empty() ? 0.0 : zs[row]));
  constexpr double kUnknownObject_m = 0.04;
  const double reach =
      trial_->scene ? 0.5 * trial_->scene->size_m.maxCoeff() : 0.5 * kUnknownObject_m;
  least_m_.array() -= reach;
  most_m_.array() += reach;
  update();
}

void PathView::show_state(const ReplayState& state) {
  state_ = state;
  update();
}

void PathView::paint_view(QPainter& painter, const QRectF& area, int across_axis,
                          double scale) const {
  painter.save();
  painter.setClipRect(area);
  const Vec3 centre = 0.5 * (least_m_ + most_m_);
  // Seen from the right, what is nearer to the patient is at the left.
  const double sign = across_axis == 0 ? 1.0 : -1.0;
  const auto place = [&](const Vec3& p) {
    return QPointF(area.center().x() + sign * scale * (p[across_axis] - centre[across_axis]),
                   area.center().y() - scale * (p.y() - centre.y()));
  };
  QPainterPath path;
  bool begins = true;
  for (const auto& p : trial_->path) {
    if (!p.allFinite())
      begins = true;
    else if (std::exchange(begins, false))
      path.moveTo(place(p));
    else
      path.lineTo(place(p));
  }
  painter.setPen(QPen(kPathColour, 1.3));
  painter.setBrush(Qt::NoBrush);
  painter.drawPath(path);
  const auto outline = [&](const Pose& pose, const QPen& pen, const QColor& fill) {
    painter.setPen(pen);
    painter.setBrush(fill);
    if (!trial_->scene) {
      painter.drawEllipse(place(pose.p_WO), 6.0, 6.0);
      return;
    }
    if (trial_->scene->shape == Shape::sphere) {
      const double radius_px = 0.5 * scale * trial_->scene->size_m[0];
      painter.drawEllipse(place(pose.p_WO), radius_px, radius_px);
      return;
    }
    const auto corners = corners_of(*trial_->scene);
    // A face is an axis that stays and the four corners around it.
    for (const std::size_t axis : {0U, 1U, 2U})
      for (const std::size_t end : {0U, 1U}) {
        const std::size_t u = 1U << ((axis + 1) % 3);
        const std::size_t v = 1U << ((axis + 2) % 3);
        const std::size_t base = end << axis;
        QPolygonF face;
        for (const std::size_t corner : {base, base + u, base + u + v, base + v})
          face << place(pose.p_WO + pose.q_WO * corners[corner]);
        painter.drawPolygon(face);
      }
  };
  if (state_.target)
    outline(*state_.target, QPen(kTargetColour, 1.5, Qt::DashLine), Qt::transparent);
  if (state_.object) outline(*state_.object, QPen(look::kText, 1.2), QColor(0x33, 0x6B, 0xA8, 40));
  if (state_.object && trial_->scene)
    for (const auto& contact : trial_->scene->contacts) {
      const auto f = index_of(contact.finger);
      painter.setPen(QPen(look::kFingers[f], 1.5));
      painter.setBrush(state_.fingers[f].touching ? look::kFingers[f] : QColor(Qt::white));
      painter.drawEllipse(place(state_.object->p_WO + state_.object->q_WO * contact.p_OC), 4.0,
                          4.0);
    }
  painter.restore();
}

void PathView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(look::kLine, 1));
  painter.setBrush(QColor(0xFA, 0xFB, 0xFC));
  painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 6, 6);
  if (trial_ == nullptr || trial_->path.empty()) return;
  const Vec3 size = most_m_ - least_m_;
  const double height_px = height() - 2 * kEdge_px - kTitle_px;
  const double width_px = width() - 3 * kEdge_px;
  // One scale for both views: a millimetre is as long in each.
  const double scale = std::min(height_px / size.y(), width_px / (size.x() + size.z()));
  const double front_px = width_px * size.x() / (size.x() + size.z());
  const QRectF front(kEdge_px, kEdge_px + kTitle_px, front_px, height_px);
  const QRectF side(front.right() + kEdge_px, front.top(), width_px - front_px, height_px);
  painter.setPen(look::kQuietText);
  const auto title = [&](const QRectF& view, const QString& text) {
    painter.drawText(QRectF(view.left(), 4, view.width(), kTitle_px), Qt::AlignCenter, text);
  };
  title(front, tr("From the front"));
  title(side, tr("From the right"));
  paint_view(painter, front, 0, scale);
  paint_view(painter, side, 2, scale);
}

}  // namespace isograsp
