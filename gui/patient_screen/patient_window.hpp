// SPDX-License-Identifier: GPL-3.0-or-later
// The patient's screen: one window of OpenGL, alone on the second display or full screen by F11.
#pragma once

#include <QImage>
#include <QOpenGLWindow>
#include <memory>
#include <string>

#include "gui/patient_screen/hand_scene.hpp"
#include "gui/patient_screen/object_scene.hpp"
#include "gui/patient_screen/speaker.hpp"
#include "gui/picture/soundtrack.hpp"
#include "gui/presenter/session_presenter.hpp"

namespace isograsp::gui {

/// Why this computer cannot show the patient's screen, in words; empty: it can. Also chooses the
/// smoothing of edges: none where a processor has to draw everything. Call before the first window.
[[nodiscard]] std::string why_no_opengl();

class PatientWindow final : public QOpenGLWindow {
  Q_OBJECT

 public:
  PatientWindow(SessionPresenter& presenter, const SettingsFile& settings);
  ~PatientWindow() override;

  /// Full screen on the display that is set, or on the second one; a window that F11 enlarges where
  /// there is only one.
  void show_for_patient();
  void toggle_full_screen();
  /// Pictures drawn since the start, and the mean time that drawing one took [s].
  struct Rate {
    long long pictures = 0;
    double mean_s = 0.0;
  };
  [[nodiscard]] Rate rate() const noexcept;

 protected:
  void initializeGL() override;
  void paintGL() override;
  void keyPressEvent(QKeyEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  void sound();
  void say_once(const QString& why);
  /// What is solid of the picture. @pre picture.page is Page::object or Page::hand
  void draw_scene(const PatientPicture& picture, const QRect& content);
  /// What stands around it and over it.
  void draw_object(const PatientPicture& picture, const QRect& content, QPainter& painter);
  void draw_footer(const PatientPicture& picture, const QRectF& area, QPainter& painter);
  [[nodiscard]] QSize device_size() const;
  /// Where everything stands, device pixels from the upper left.
  [[nodiscard]] QRect content() const;
  /// Of that part; 0: the display does not tell.
  [[nodiscard]] double content_height_m() const;

  SessionPresenter& presenter_;
  const SettingsFile& settings_;
  PatientPicture shown_;  ///< drawn last
  Soundtrack soundtrack_;
  Speaker speaker_;
  QStringList told_;  ///< reasons why there is no sound that the therapist was told already
  std::unique_ptr<ObjectScene> scene_;
  std::unique_ptr<HandScene> hand_scene_;
  QImage page_;  ///< pages without an object are painted here: smooth edges without a GPU
  QImage banner_;
  QString banner_key_;
  QImage footer_;
  QString footer_key_;
  QImage check_;
  QImage ring_;
  QImage tick_;
  long long pictures_ = 0;
  double drawing_s_ = 0.0;
};

}  // namespace isograsp::gui
