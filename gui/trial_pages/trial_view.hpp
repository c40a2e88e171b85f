// SPDX-License-Identifier: GPL-3.0-or-later
// One stored trial: its signals, the object and its path, a replay at any speed, and all that is
// known about it.
#pragma once

#include <QComboBox>
#include <QElapsedTimer>
#include <QListWidget>
#include <QPushButton>
#include <QSlider>
#include <QStackedWidget>
#include <QTimer>
#include <memory>

#include "gui/arm_pages/arm_views.hpp"
#include "gui/hand_pages/grasp_view.hpp"
#include "gui/look/card.hpp"
#include "gui/patient_screen/page_picture.hpp"
#include "gui/trial_pages/loaded_trial.hpp"
#include "gui/trial_pages/object_path_view.hpp"
#include "gui/trial_pages/replay_window.hpp"
#include "gui/trial_pages/trial_about.hpp"
#include "gui/trial_pages/trial_plot.hpp"

namespace isograsp::gui {

class TrialView final : public Card {
  Q_OBJECT

 public:
  explicit TrialView(QWidget* parent = nullptr);

  void show_loading(const QString& what);   ///< until show_trial() or show_problem()
  void show_problem(const QString& words);  ///< instead of a trial
  void show_trial(std::shared_ptr<const LoadedTrial> trial);
  void take_focus();
  [[nodiscard]] const Playback& playback() const noexcept { return playback_; }

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  QWidget* make_pictures();
  QWidget* make_about();
  QWidget* make_controls();
  void connect_all();
  void fill_channels();
  void show_object();
  void draw_curves();
  void toggle();
  void seek(double t_s);
  void advance();
  void show_time();
  void choose_speed(int index);
  [[nodiscard]] bool act_on(int key);
  [[nodiscard]] CurveSet set() const;

  std::shared_ptr<const LoadedTrial> trial_;
  Playback playback_;
  std::vector<TrialCurve> curves_;
  QTimer timer_;
  QElapsedTimer since_;

  QLabel* subtitle_;
  QLabel* warning_;
  QComboBox* set_;
  QWidget* body_;
  QStackedWidget* object_;  ///< 3D picture, flat path, or the page of two hands
  ObjectPathView* flat_;
  PagePicture* page_;               ///< what was shown to two hands
  ReplayWindow* window_ = nullptr;  ///< made when there is OpenGL and an object; of its container
  QWidget* container_ = nullptr;    ///< of `window_`
  ArmViews* arm_;     ///< an arm from three sides, beside the picture that its person saw
  GraspView* grasp_;  ///< of a tracked hand: what holds, above what is known of the trial
  QLabel* why_flat_;
  TrialPlot* plot_;
  QLabel* reading_;
  QStackedWidget* side_;
  TrialAbout* about_;
  QListWidget* channels_;
  QPushButton* play_;
  QSlider* slider_;
  QLabel* time_;
  QComboBox* speed_;
};

}  // namespace isograsp::gui
