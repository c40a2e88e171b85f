// SPDX-License-Identifier: GPL-3.0-or-later
// The therapist's window: the device's light and the bar with the one next thing above everything,
// the pages beside their list.
#pragma once

#include <QLabel>
#include <QMainWindow>
#include <QPushButton>
#include <QStackedWidget>
#include <functional>
#include <vector>

#include "gui/clinic/clinic.hpp"
#include "gui/clinic/settings.hpp"
#include "gui/clinic/staff.hpp"
#include "gui/presenter/session_presenter.hpp"
#include "gui/session_pages/state_light.hpp"

class QShortcut;

namespace isograsp::gui {

class IdentityCard;
class LibraryPage;
class LoginPage;
class NextBar;
class PatientPage;
class ProfilePanel;
class ReportsPage;
class SessionPage;
class StartPage;

class TherapistWindow final : public QMainWindow {
  Q_OBJECT

 public:
  TherapistWindow(Clinic& clinic, PersonFile& file, SessionPresenter& presenter,
                  SettingsFile& settings, Staff& staff, QWidget* parent = nullptr);

  enum class Page : std::uint8_t { start, patient, session, device, reports, library, settings };
  void show_page(Page page);
  [[nodiscard]] Page page() const;

  /// Shows the patient's screen, or why that is not possible.
  std::function<void()> show_patient_screen;
  /// Makes and opens a demonstration clinic in the place of this one.
  std::function<void()> open_demonstration;
  /// It could not be made: says why and offers it again.
  void demonstration_failed(const QString& why);
  /// Called when this window has closed.
  std::function<void()> on_closed;
  /// No work is running that needs this window: printing, making a demonstration clinic, closing.
  [[nodiscard]] bool may_be_replaced() const;
  /// Stores what was typed; another window takes its place.
  void leave();
  /// A sentence for a few seconds, e.g. why an act was refused.
  void say(const QString& words);

 protected:
  void closeEvent(QCloseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  QWidget* make_header();
  void choose_at(QWidget& place);
  void follow_page();
  void watch();
  QWidget* make_navigation();
  void make_pages();
  void name_tab(Page page, const QString& title);
  void add_page(Page page, const QString& title, QWidget* content);
  [[nodiscard]] QWidget* make_patient();
  void show_patient();
  void add_shortcuts();
  void write_report();
  void end_session();
  [[nodiscard]] bool printing() const;
  void refresh();
  void show_who_is_in();

  Clinic& clinic_;
  PersonFile& file_;
  SessionPresenter& presenter_;
  SettingsFile& settings_;
  Staff& staff_;
  NextBar* bar_;
  StateLight* device_light_;
  QLabel* device_words_;
  QLabel* simulated_;
  QPushButton* patient_screen_;
  QPushButton* lock_;
  QLabel* message_;
  QStackedWidget* cover_;  ///< the pages, or the login in their place
  QWidget* navigation_;
  QStackedWidget* pages_;
  StartPage* start_;
  SessionPage* session_;
  bool next_patient_ = false;  ///< comes when the session has ended
  PatientPage* course_;
  ProfilePanel* person_;
  IdentityCard* identity_;
  ReportsPage* reports_;
  std::vector<QPushButton*> tabs_;  ///< of the pages, in their order
  std::vector<QShortcut*> keys_;    ///< that do nothing while nobody is in
  bool closing_ = false;
};

}  // namespace isograsp::gui
