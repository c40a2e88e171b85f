// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/trial_pages/object_path_view.hpp"

#include <QPainter>
#include <algorithm>
#include <cmath>

#include "gui/look/look.hpp"
#include "hand/columns.hpp"

namespace isograsp::gui {

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

ObjectPathView::ObjectPathView(QWidget* parent) : QWidget(parent) {
  setMinimumHeight(scaled(120));
}

void ObjectPathView::show_trial(std::shared_ptr<const LoadedTrial> trial) {
  trial_ = std::move(trial);
  state_ = {};
  backdrop_ = {};
  least_m_.setConstant(std::numeric_limits<double>::infinity());
  most_m_ = -least_m_;
  const auto take = [this](const Vec3& p) {
    if (!p.allFinite()) return;
    least_m_ = least_m_.cwiseMin(p);
    most_m_ = most_m_.cwiseMax(p);
  };
  for (const auto& p : trial_->path) take(p);
  const auto& signals = trial_->replay.signals();
  const auto xs = signals.column(columns::target_position[0]);
  const auto ys = signals.column(columns::target_position[1]);
  const auto zs = signals.column(columns::target_position[2]);
  for (std::size_t row = 0; row < std::min(xs.size(), ys.size()); ++row)
    take(Vec3(xs[row], ys[row], zs.empty() ? 0.0 : zs[row]));
  constexpr double kUnknownObject_m = 0.04;
  const double reach =
      trial_->scene ? 0.5 * trial_->scene->size_m.maxCoeff() : 0.5 * kUnknownObject_m;
  least_m_.array() -= reach;
  most_m_.array() += reach;
  update();
}

void ObjectPathView::show_state(const ReplayState& state) {
  state_ = state;
  update();
}

std::array<ObjectPathView::View, 2> ObjectPathView::views() const {
  const Vec3 size = most_m_ - least_m_;
  const double height_px = height() - 2 * kEdge_px - kTitle_px;
  const double width_px = width() - 3 * kEdge_px;
  // One scale for both: a millimetre is as long in each.
  const double scale = std::min(height_px / size.y(), width_px / (size.x() + size.z()));
  const double front_px = width_px * size.x() / (size.x() + size.z());
  const QRectF front(kEdge_px, kEdge_px + kTitle_px, front_px, height_px);
  const QRectF side(front.right() + kEdge_px, front.top(), width_px - front_px, height_px);
  return {View{front, 0, scale}, View{side, 2, scale}};
}

QPointF ObjectPathView::place(const View& view, const Vec3& p_W) const {
  const Vec3 from_centre = p_W - 0.5 * (least_m_ + most_m_);
  // Seen from the right, what is nearer to the patient is at the left.
  const double sign = view.across == 0 ? 1.0 : -1.0;
  return view.area.center() +
         view.px_per_m * QPointF(sign * from_centre[view.across], -from_centre.y());
}

void ObjectPathView::paint_backdrop() {
  backdrop_ = QPixmap(size() * devicePixelRatio());
  backdrop_.setDevicePixelRatio(devicePixelRatio());
  backdrop_.fill(look::kCard);
  QPainter painter(&backdrop_);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setFont(font());
  painter.setPen(QPen(look::kLine, 1));
  painter.setBrush(look::kPathGround);
  painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 6, 6);
  if (trial_ == nullptr || trial_->path.empty()) return;
  painter.setBrush(Qt::NoBrush);
  for (const View& view : views()) {
    painter.setPen(look::kQuietText);
    painter.drawText(QRectF(view.area.left(), 4, view.area.width(), kTitle_px), Qt::AlignCenter,
                     view.across == 0 ? tr("From the front") : tr("From the right"));
    QPolygonF stretch;
    painter.setPen(QPen(kPathColour, 1.3));
    for (const auto& p : trial_->path) {
      if (p.allFinite()) {
        stretch << place(view, p);
        continue;
      }
      painter.drawPolyline(stretch);
      stretch.clear();
    }
    painter.drawPolyline(stretch);
  }
}

void ObjectPathView::paint_outline(QPainter& painter, const View& view, const Pose& pose) const {
  if (!trial_->scene) {
    painter.drawEllipse(place(view, pose.p), 6.0, 6.0);
    return;
  }
  if (trial_->scene->shape == Shape::sphere) {
    const double radius_px = 0.5 * view.px_per_m * trial_->scene->size_m[0];
    painter.drawEllipse(place(view, pose.p), radius_px, radius_px);
    return;
  }
  const auto corners = corners_of(*trial_->scene);
  // A face is an axis that stays and the four corners around it.
  for (const std::size_t axis : {0U, 1U, 2U})
    for (const std::size_t end : {0U, 1U}) {
      const std::size_t u = std::size_t{1} << ((axis + 1) % 3);
      const std::size_t v = std::size_t{1} << ((axis + 2) % 3);
      const std::size_t base = end << axis;
      QPolygonF face;
      for (const std::size_t corner : {base, base + u, base + u + v, base + v})
        face << place(view, pose.p + pose.q * corners[corner]);
      painter.drawPolygon(face);
    }
}

void ObjectPathView::paint_object(QPainter& painter, const View& view) const {
  if (state_.X_WT) {
    painter.setPen(QPen(kTargetColour, 1.5, Qt::DashLine));
    painter.setBrush(Qt::NoBrush);
    paint_outline(painter, view, *state_.X_WT);
  }
  if (!state_.X_WO) return;
  painter.setPen(QPen(look::kText, 1.2));
  painter.setBrush(look::kObject);
  paint_outline(painter, view, *state_.X_WO);
  if (!trial_->scene) return;
  for (const auto& contact : trial_->scene->contacts) {
    const auto f = index_of(contact.finger);
    if (state_.fingers[f].quality == SampleQuality::missing && trial_->replay.has_fingers())
      continue;
    painter.setPen(QPen(look::kFingers[f], 1.5));
    painter.setBrush(state_.fingers[f].touching ? look::kFingers[f] : QColor(Qt::white));
    painter.drawEllipse(place(view, state_.X_WO->p + state_.X_WO->q * contact.p_OC), 4.0, 4.0);
  }
}

void ObjectPathView::paintEvent(QPaintEvent*) {
  if (backdrop_.size() != size() * devicePixelRatio()) paint_backdrop();
  QPainter painter(this);
  painter.drawPixmap(0, 0, backdrop_);
  if (trial_ == nullptr || trial_->path.empty()) return;
  painter.setRenderHint(QPainter::Antialiasing);
  for (const View& view : views()) {
    painter.setClipRect(view.area);
    paint_object(painter, view);
  }
}

}  // namespace isograsp::gui
