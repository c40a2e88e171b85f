// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/therapist_window.hpp"

#include <QCloseEvent>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QShortcut>
#include <QTimer>
#include <QVBoxLayout>

#include "gui/device_panel.hpp"
#include "gui/history_panel.hpp"
#include "gui/live_panel.hpp"
#include "gui/look.hpp"
#include "gui/patient_panel.hpp"
#include "gui/session_panel.hpp"

namespace isograsp {

TherapistWindow::TherapistWindow(Clinic& clinic, SessionPresenter& presenter, QWidget* parent)
    : QMainWindow(parent), clinic_(clinic), presenter_(presenter) {
  setWindowTitle(tr("IsoGrasp"));
  auto* page = new QWidget;
  page->setObjectName("page");
  auto* column = new QVBoxLayout(page);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(make_header());
  column->addWidget(make_body(), 1);
  setCentralWidget(page);
  resize(1280, 720);
  setMinimumSize(1100, 660);
  add_shortcuts();
  connect(&presenter_, &SessionPresenter::changed, this, &TherapistWindow::refresh);
  connect(&presenter_, &SessionPresenter::failed, this, &TherapistWindow::say);
  connect(&clinic_, &Clinic::failed, this, &TherapistWindow::say);
  const auto close_at_last = [this] {
    if (closing_) close();
  };
  connect(&presenter_, &SessionPresenter::settled, this, close_at_last);
  connect(&clinic_.report(), &ReportWork::written, this, close_at_last);
  connect(&clinic_.report(), &ReportWork::cancelled, this, close_at_last);
  // Whoever waits for a report wants to know that there is none.
  connect(&clinic_.report(), &ReportWork::failed, this, [this] { closing_ = false; });
  refresh();
  for (const auto& problem : presenter_.library_problems()) say(QString::fromStdString(problem));
}

QWidget* TherapistWindow::make_header() {
  auto* header = new QFrame;
  header->setObjectName("header");
  auto* wordmark = new QLabel(tr("IsoGrasp"));
  wordmark->setObjectName("wordmark");
  light_ = new StateLight(28);
  sentence_ = new QLabel;
  sentence_->setObjectName("sentence");
  sentence_->setWordWrap(true);
  sentence_->setToolTip(tr("The state of the session and the sensible next step"));
  simulated_ = new QLabel(tr("SIMULATED"));
  simulated_->setObjectName("simulated");
  simulated_->setToolTip(
      tr("Forces come from software or a file, not from a person at this device"));
  patient_screen_ = new QPushButton(tr("Patient screen"));
  patient_screen_->setObjectName("patient_screen");
  describe(*patient_screen_, tr("Patient screen"),
           tr("Show the patient's screen: full screen on a second display (F11)"));
  patient_screen_->setShortcut(Qt::Key_F11);
  connect(patient_screen_, &QPushButton::clicked, this, [this] {
    if (show_patient_screen) show_patient_screen();
  });
  steps_ = new StepStrip;
  message_ = new QLabel;
  message_->setObjectName("message");
  message_->setProperty("role", "quiet");
  message_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);

  auto* top = new QHBoxLayout;
  top->setSpacing(12);
  top->addWidget(wordmark);
  top->addSpacing(10);
  top->addWidget(light_);
  top->addWidget(sentence_, 1);
  top->addWidget(simulated_);
  top->addWidget(patient_screen_);
  auto* below = new QHBoxLayout;
  below->addWidget(steps_);
  below->addWidget(message_, 1);
  auto* column = new QVBoxLayout(header);
  column->setContentsMargins(16, 10, 16, 10);
  column->setSpacing(9);
  column->addLayout(top);
  column->addLayout(below);
  return header;
}

QWidget* TherapistWindow::make_body() {
  auto* body = new QWidget;
  auto* columns = new QHBoxLayout(body);
  columns->setContentsMargins(12, 12, 12, 12);
  columns->setSpacing(12);
  const auto add_column = [&](int stretch, int least_px, int most_px) {
    auto* holder = new QWidget;
    holder->setMinimumWidth(least_px);
    if (most_px > 0) holder->setMaximumWidth(most_px);
    auto* column = new QVBoxLayout(holder);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(12);
    columns->addWidget(holder, stretch);
    return column;
  };
  // Left to right is the way of a session: prepare, watch, run.
  auto* prepare = add_column(2, 250, 340);
  prepare->addWidget(new PatientPanel(clinic_, presenter_), 1);
  prepare->addWidget(new HandPanel(presenter_));
  prepare->addWidget(new DevicePanel(presenter_));
  auto* watch = add_column(5, 420, 0);
  watch->addWidget(new LivePanel(presenter_), 4);
  watch->addWidget(new HistoryPanel(clinic_, presenter_), 3);
  auto* run = add_column(2, 290, 420);
  run->addWidget(new TaskPanel(presenter_));
  run->addWidget(new ScorePanel(presenter_), 1);
  return body;
}

void TherapistWindow::add_shortcuts() {
  const auto add = [this](const QKeySequence& key, auto act) {
    connect(new QShortcut(key, this), &QShortcut::activated, this, act);
  };
  add(Qt::Key_F7, [this] { presenter_.show_how(); });
  add(Qt::Key_F8, [this] { presenter_.start(); });
  add(Qt::Key_F9, [this] { presenter_.start_pause_resume(); });
  add(Qt::Key_F10, [this] { presenter_.stop(); });
  add(QKeySequence::Find, [this] { findChild<QLineEdit*>("patient_search")->setFocus(); });
  add(QKeySequence("Ctrl+R"), [this] { findChild<QPushButton*>("report")->click(); });
  add(QKeySequence("Alt+V"), [this] { findChild<QWidget*>("history")->setFocus(); });
  add(QKeySequence::Quit, [this] { close(); });
}

void TherapistWindow::refresh() {
  const auto& view = presenter_.view();
  light_->show_mood(view.mood);
  sentence_->setText(QString::fromStdString(view.sentence));
  simulated_->setVisible(presenter_.simulated() || presenter_.recorded());
  simulated_->setText(presenter_.recorded() ? tr("RECORDED") : tr("SIMULATED"));
  steps_->show_steps(view.steps);
}

void TherapistWindow::say(const QString& words) {
  constexpr int kShown_ms = 12000;
  message_->setText(words);
  message_->setToolTip(words);
  QTimer::singleShot(kShown_ms, message_, [this, words] {
    if (message_->text() == words) message_->clear();
  });
}

void TherapistWindow::closeEvent(QCloseEvent* event) {
  presenter_.cancel_connecting();  // nothing has begun that could be lost
  if (!presenter_.busy() && !clinic_.report().running()) {
    event->accept();
    if (on_closed) on_closed();
    return;
  }
  // Session and report are written to their ends first; the window goes when that is done.
  event->ignore();
  closing_ = true;
  presenter_.end_session();
}

}  // namespace isograsp
