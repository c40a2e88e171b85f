// SPDX-License-Identifier: GPL-3.0-or-later
// The therapist's window: the state in one sentence and the device's light above everything, the
// pages beside their list.
#pragma once

#include <QLabel>
#include <QMainWindow>
#include <QPushButton>
#include <QStackedWidget>
#include <functional>
#include <vector>

#include "gui/clinic.hpp"
#include "gui/session_presenter.hpp"
#include "gui/state_light.hpp"

namespace isograsp {

class PatientPage;
class ProfilePanel;

class TherapistWindow final : public QMainWindow {
  Q_OBJECT

 public:
  TherapistWindow(Clinic& clinic, SessionPresenter& presenter, QWidget* parent = nullptr);

  enum class Page : std::uint8_t { start, patient, session, device, reports };
  void show_page(Page page);
  [[nodiscard]] Page page() const;

  /// Shows the patient's screen, or why that is not possible.
  std::function<void()> show_patient_screen;
  /// Makes and opens a demonstration clinic in the place of this one.
  std::function<void()> open_demonstration;
  /// Called when this window has closed.
  std::function<void()> on_closed;
  /// A sentence for a few seconds, e.g. why an act was refused.
  void say(const QString& words);

 protected:
  void closeEvent(QCloseEvent* event) override;

 private:
  QWidget* make_header();
  QWidget* make_navigation();
  void make_pages();
  void add_page(Page page, const QString& title, QWidget* content);
  [[nodiscard]] QWidget* make_patient();
  void show_patient();
  void add_shortcuts();
  void refresh();

  Clinic& clinic_;
  SessionPresenter& presenter_;
  StateLight* light_;
  QLabel* sentence_;
  StateLight* device_light_;
  QLabel* device_words_;
  QLabel* simulated_;
  QPushButton* patient_screen_;
  QLabel* message_;
  QWidget* navigation_;
  QStackedWidget* pages_;
  PatientPage* course_;
  ProfilePanel* person_;
  std::vector<QPushButton*> tabs_;  ///< of the pages, in their order
  bool closing_ = false;
};

}  // namespace isograsp
