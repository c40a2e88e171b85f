// SPDX-License-Identifier: GPL-3.0-or-later
// An arm from three sides beside each other, in true size on a grid of 10 cm: markers, the chain
// from the elbow to the object, the object and its target. Axes are those of the screens
// (gui/picture/arm_space.hpp), which the rig says.
#pragma once

#include <QWidget>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "gui/picture/arm_space.hpp"
#include "session/arm/arm_snapshot.hpp"

class QPainter;

namespace isograsp::gui {

class ArmViews final : public QWidget {
  Q_OBJECT

 public:
  explicit ArmViews(QWidget* parent = nullptr);
  /// `axes_W`: x, y and z of a frame are drawn at its origin.
  void show_arm(const session::ArmSnapshot& now, const std::shared_ptr<const ArmSpace>& space,
                const std::optional<Pose>& axes_W = std::nullopt);
  void show_nothing();

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  /// What is drawn, on the axes of the screens [m].
  struct Drawn {
    std::vector<Vec3> markers;
    std::vector<std::optional<Vec3>> chain;  ///< nothing: not seen
    std::optional<Pose> object;
    std::optional<Pose> target;
    std::optional<Pose> axes;
    Vec3 size_m = Vec3::Zero();  ///< of the object
    bool matched = false;
  };
  void fit();
  void paint_view(QPainter& painter, const QRectF& area, int view) const;
  void paint_axes(QPainter& painter, const std::function<QPointF(const Vec3&)>& at) const;

  std::optional<Drawn> drawn_;
  Vec3 middle_m_ = Vec3::Zero();  ///< of all three views; moves only when it has to
  double half_m_ = 0.0;           ///< from the middle to the edge; 0: not known yet
};

}  // namespace isograsp::gui
