// SPDX-License-Identifier: GPL-3.0-or-later
// The therapist's page of one patient: sessions and trials, main measures over the sessions, any
// two sessions compared, any trial opened and replayed. It only reads.
#pragma once

#include <QButtonGroup>
#include <QLabel>
#include <QStackedWidget>
#include <QWidget>
#include <atomic>
#include <memory>
#include <string>

#include "gui/clinic/clinic.hpp"
#include "gui/record_pages/comparison_panel.hpp"
#include "gui/record_pages/course_panel.hpp"
#include "gui/record_pages/trend_grid.hpp"
#include "gui/trial_pages/trial_view.hpp"

namespace isograsp::gui {

class PatientPage final : public QWidget {
  Q_OBJECT

 public:
  enum class View : std::uint8_t { trends, comparison, trial };

  /// `library`: folder of the shipped one.
  PatientPage(Clinic& clinic, std::string library, QWidget* parent = nullptr);

  /// Reads what is stored, also if the patient is the one that is shown; an empty code: nobody.
  void show_patient(const std::string& code);
  void show_view(View view);  ///< and give it the focus
  /// Indices into PatientCourse::sessions and CourseSession::trials.
  void open_trial(int session_index, int trial_index);

  [[nodiscard]] bool loading() const noexcept { return loading_course_ || loading_trial_; }
  [[nodiscard]] const PatientCourse* course() const noexcept { return course_.get(); }
  [[nodiscard]] TrendGrid& trend_grid() noexcept { return *trends_; }

 Q_SIGNALS:
  void loaded();        ///< what show_patient() asked for is there, or the reason why it is not
  void trial_loaded();  ///< the same of open_trial()

 private:
  QWidget* make_head();
  void switch_to(View view);
  void load();
  void tell();

  Clinic& clinic_;
  std::string library_;
  std::string code_;
  std::shared_ptr<const PatientCourse> course_;
  bool loading_course_ = false;
  bool loading_trial_ = false;
  QString problem_;
  /// Only the newest request is read: someone who goes through the trials does not wait for each.
  std::shared_ptr<std::atomic<int>> wanted_course_ = std::make_shared<std::atomic<int>>(0);
  std::shared_ptr<std::atomic<int>> wanted_trial_ = std::make_shared<std::atomic<int>>(0);
  QLabel* title_;
  QLabel* summary_;
  QButtonGroup* choice_;
  CoursePanel* sessions_;
  QStackedWidget* views_;
  TrendGrid* trends_;
  ComparisonPanel* comparison_;
  TrialView* trial_;
};

}  // namespace isograsp::gui
