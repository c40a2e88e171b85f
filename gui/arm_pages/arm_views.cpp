// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/arm_pages/arm_views.hpp"

#include <QPainter>
#include <algorithm>
#include <array>
#include <cmath>

#include "gui/look/look.hpp"

namespace isograsp::gui {

namespace {

constexpr int kViews = 3;
constexpr double kViewGrid_m = 0.1;
constexpr double kLeastHalf_m = 0.2;
/// The picture moves when its middle is off by that share of it, and shrinks when so much is empty:
/// a picture that follows every step cannot be read.
constexpr double kOff = 0.3;
constexpr double kEmpty = 0.5;

/// A point on one of the views: to the right and up. Front: as the patient's screen; side: from the
/// right, what is away from the screen's viewer to the right; above: that up.
QPointF on_view(const Vec3& p_S, int view) {
  switch (view) {
    case 0: return {p_S.x(), p_S.y()};
    case 1: return {-p_S.z(), p_S.y()};
    default: return {p_S.x(), -p_S.z()};
  }
}

std::array<Vec3, 8> box_corners(const Vec3& size_m, const Pose& X_SO) {
  std::array<Vec3, 8> corners;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Vec3 sign((k & 1U) != 0 ? 0.5 : -0.5, (k & 2U) != 0 ? 0.5 : -0.5,
                    (k & 4U) != 0 ? 0.5 : -0.5);
    corners[k] = X_SO.p + X_SO.q * sign.cwiseProduct(size_m);
  }
  return corners;
}

}  // namespace

ArmViews::ArmViews(QWidget* parent) : QWidget(parent) {
  setObjectName("arm_views");
  setMinimumHeight(scaled(150));
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  describe(*this, tr("The arm from the front, from the side and from above"),
           tr("Markers, the chain from elbow to object, the object (full line) and its target "
              "(dashed); one square of the grid is 10 cm"));
}

void ArmViews::show_arm(const session::ArmSnapshot& now,
                        const std::shared_ptr<const ArmSpace>& space,
                        const std::optional<Pose>& axes_W) {
  const Vec3 centre_W = now.start_p_WO.allFinite()    ? now.start_p_WO
                        : now.last_X_WO.p.allFinite() ? now.last_X_WO.p
                                                      : Vec3(Vec3::Zero());
  Drawn drawn;
  for (std::size_t m = 0; m < now.marker_count; ++m)
    if (now.markers_W[m].allFinite())
      drawn.markers.push_back(space->marker(now.markers_W[m], centre_W));
  for (const ArmSegment segment : session::kArmChain) {
    const FramePose& pose = now.segment(segment);
    drawn.chain.push_back(has_pose(pose.state) ? std::optional(space->place(pose.X_W.p, centre_W))
                                               : std::nullopt);
  }
  drawn.size_m = space->box()->size_m;
  const FramePose& object = now.segment(ArmSegment::object);
  if (has_pose(object.state)) drawn.object = space->box_at(object.X_W, centre_W);
  const tasks::ArmView& task = now.special.arm();
  const bool in_trial = now.stage == session::Stage::trial || now.stage == session::Stage::paused;
  if (in_trial && task.reference_shown) drawn.target = space->box_at(task.X_WR, centre_W);
  drawn.matched = in_trial && task.matched;
  if (axes_W) drawn.axes = space->pose(*axes_W, centre_W);
  drawn_ = std::move(drawn);
  fit();
  update();
}

void ArmViews::show_nothing() {
  if (!drawn_) return;
  drawn_.reset();
  half_m_ = 0.0;
  update();
}

/// All that is drawn lies in the picture.
void ArmViews::fit() {
  std::vector<Vec3> all = drawn_->markers;
  for (const auto& p_S : drawn_->chain)
    if (p_S) all.push_back(*p_S);
  for (const auto& box : {drawn_->object, drawn_->target})
    if (box)
      for (const Vec3& corner : box_corners(drawn_->size_m, *box)) all.push_back(corner);
  if (all.empty()) return;
  Vec3 least = all.front();
  Vec3 most = least;
  for (const Vec3& p_S : all) {
    least = least.cwiseMin(p_S);
    most = most.cwiseMax(p_S);
  }
  const Vec3 middle = 0.5 * (least + most);
  const double half = std::max(kLeastHalf_m, 0.55 * (most - least).maxCoeff());
  const double reach = (middle - middle_m_).cwiseAbs().maxCoeff() + half;
  const bool fits = reach <= half_m_ && half >= kEmpty * half_m_ &&
                    (middle - middle_m_).cwiseAbs().maxCoeff() <= kOff * half_m_;
  if (fits) return;
  middle_m_ = middle;
  half_m_ = 1.15 * half;
}

void ArmViews::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  constexpr double kApart_px = 6.0;
  const auto cell = [this](int columns, int rows) {
    return QSizeF((width() - (columns - 1) * kApart_px) / columns,
                  (height() - (rows - 1) * kApart_px) / rows);
  };
  const auto shorter_side = [](const QSizeF& size) {
    return std::min(size.width(), size.height());
  };
  // In a row, or two above one: where the arm is larger.
  const int columns = shorter_side(cell(2, 2)) > shorter_side(cell(kViews, 1)) ? 2 : kViews;
  const QSizeF size = cell(columns, columns == kViews ? 1 : 2);
  for (int view = 0; view < kViews; ++view) {
    const QPointF corner((view % columns) * (size.width() + kApart_px),
                         (view / columns) * (size.height() + kApart_px));
    paint_view(painter, QRectF(corner, size), view);
  }
}

/// Letters tell them apart, too; an axis that points at the viewer is its letter alone.
void ArmViews::paint_axes(QPainter& painter, const std::function<QPointF(const Vec3&)>& at) const {
  constexpr double kAxis_m = 0.07;
  constexpr double kLetter = 1.3;  // of its length from the origin
  const std::array<QString, 3> letters{QStringLiteral("x"), QStringLiteral("y"),
                                       QStringLiteral("z")};
  const QPointF origin = at(drawn_->axes->p);
  for (std::size_t axis = 0; axis < letters.size(); ++axis) {
    const Vec3 along = drawn_->axes->q * Vec3::Unit(static_cast<Eigen::Index>(axis)) * kAxis_m;
    painter.setPen(QPen(look::kFingers[axis], 2.0, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(origin, at(drawn_->axes->p + along));
    painter.drawText(
        QRectF(at(drawn_->axes->p + kLetter * along) - QPointF(10, 10), QSizeF(20, 20)),
        Qt::AlignCenter, letters[axis]);
  }
}

void ArmViews::paint_view(QPainter& painter, const QRectF& area, int view) const {
  const std::array<QString, kViews> titles{tr("Front"), tr("Side"), tr("Above")};
  painter.save();
  painter.setClipRect(area);
  painter.fillRect(area, look::kPathGround);
  if (drawn_ && half_m_ > 0.0) {
    const double px_per_m = 0.5 * std::min(area.width(), area.height()) / half_m_;
    const QPointF middle = on_view(middle_m_, view);
    const auto at = [&](const Vec3& p_S) {
      const QPointF p = on_view(p_S, view) - middle;
      return area.center() + QPointF(px_per_m * p.x(), -px_per_m * p.y());
    };
    painter.setPen(QPen(look::kGrid, 1.0));
    const double step_px = px_per_m * kViewGrid_m;
    const QPointF zero = area.center() + QPointF(-px_per_m * middle.x(), px_per_m * middle.y());
    for (double x = zero.x() - step_px * std::ceil((zero.x() - area.left()) / step_px);
         x <= area.right(); x += step_px)
      painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
    for (double y = zero.y() - step_px * std::ceil((zero.y() - area.top()) / step_px);
         y <= area.bottom(); y += step_px)
      painter.drawLine(QPointF(area.left(), y), QPointF(area.right(), y));
    const auto draw_box = [&](const Pose& X_SO, const QPen& pen) {
      painter.setPen(pen);
      const auto corners = box_corners(drawn_->size_m, X_SO);
      for (std::size_t a = 0; a < corners.size(); ++a)
        for (const std::size_t bit : {1U, 2U, 4U})
          if ((a & bit) == 0) painter.drawLine(at(corners[a]), at(corners[a | bit]));
    };
    painter.setPen(QPen(look::kText, 3.0, Qt::SolidLine, Qt::RoundCap));
    for (std::size_t k = 0; k + 1 < drawn_->chain.size(); ++k)
      if (drawn_->chain[k] && drawn_->chain[k + 1])
        painter.drawLine(at(*drawn_->chain[k]), at(*drawn_->chain[k + 1]));
    painter.setPen(Qt::NoPen);
    painter.setBrush(look::kQuietText);
    for (const Vec3& marker : drawn_->markers) painter.drawEllipse(at(marker), 2.6, 2.6);
    if (drawn_->target) draw_box(*drawn_->target, QPen(look::kFingers[1], 1.6, Qt::DashLine));
    if (drawn_->object)
      draw_box(*drawn_->object, QPen(drawn_->matched ? look::kReady : look::kAccent, 1.8));
    if (drawn_->axes) paint_axes(painter, at);
  }
  painter.setPen(look::kQuietText);
  painter.drawText(area.adjusted(6, 3, -6, -3), Qt::AlignLeft | Qt::AlignTop,
                   titles[static_cast<std::size_t>(view)]);
  painter.setPen(QPen(look::kLine, 1.0));
  painter.setBrush(Qt::NoBrush);
  painter.drawRect(area.adjusted(0.5, 0.5, -0.5, -0.5));
  painter.restore();
}

}  // namespace isograsp::gui
