// SPDX-License-Identifier: GPL-3.0-or-later
// A posture in pictures: the object as a patient sees it, in three dimensions where the display has
// OpenGL, and the arm from three sides.
#pragma once

#include <QLabel>
#include <optional>

#include "gui/arm_pages/arm_views.hpp"
#include "gui/library_pages/posture_scene.hpp"
#include "gui/look/card.hpp"
#include "gui/patient_screen/object_window.hpp"

namespace isograsp::gui {

class PostureView final : public Card {
  Q_OBJECT

 public:
  explicit PostureView(QWidget* parent = nullptr);

  /// The posture at `index`; the axes of the segment `axes` of the chain are drawn.
  /// @pre postures.chain == scene.chain()
  void show_posture(const PostureScene& scene, const Postures& postures, std::size_t index,
                    std::size_t axes);
  /// The arm from three sides takes the focus.
  [[nodiscard]] QWidget& sides() noexcept { return *arm_; }
  /// The object in three dimensions; null: no OpenGL, or not looked at yet.
  [[nodiscard]] ObjectWindow* solid() noexcept { return window_; }

 Q_SIGNALS:
  void key_pressed(int key, Qt::KeyboardModifiers modifiers);

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void show_solid();

  ArmViews* arm_;
  QLabel* solid_words_;
  ObjectWindow* window_ = nullptr;
  PatientPicture picture_;
};

}  // namespace isograsp::gui
