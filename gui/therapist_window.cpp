// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/therapist_window.hpp"

#include <QApplication>
#include <QButtonGroup>
#include <QCloseEvent>
#include <QDialog>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLineEdit>
#include <QScrollArea>
#include <QShortcut>
#include <QTabBar>
#include <QTabWidget>
#include <QTimer>
#include <QToolButton>
#include <QVBoxLayout>
#include <utility>

#include "gui/library_pages/library_page.hpp"
#include "gui/look/look.hpp"
#include "gui/office_pages/login_page.hpp"
#include "gui/office_pages/reports_page.hpp"
#include "gui/office_pages/settings_page.hpp"
#include "gui/record_pages/identity_card.hpp"
#include "gui/record_pages/patient_page.hpp"
#include "gui/record_pages/profile_panel.hpp"
#include "gui/session_pages/device_page.hpp"
#include "gui/session_pages/fault_card.hpp"
#include "gui/session_pages/next_bar.hpp"
#include "gui/session_pages/session_page.hpp"
#include "gui/session_pages/step_section.hpp"
#include "gui/start_pages/start_page.hpp"
#include "gui/words/texts.hpp"

namespace isograsp::gui {

TherapistWindow::TherapistWindow(Clinic& clinic, PersonFile& file, SessionPresenter& presenter,
                                 SettingsFile& settings, Staff& staff, QWidget* parent)
    : QMainWindow(parent),
      clinic_(clinic),
      file_(file),
      presenter_(presenter),
      settings_(settings),
      staff_(staff) {
  setWindowTitle(tr("IsoGrasp"));
  auto* page = new QWidget;
  page->setObjectName("page");
  auto* column = new QVBoxLayout(page);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(make_header());
  bar_ = new NextBar(presenter_);
  connect(bar_, &NextBar::chooses, this, [this](QWidget* place) { choose_at(*place); });
  column->addWidget(bar_);
  auto* fault = new FaultCard(presenter_);
  bar_->put_first(*fault);
  column->addWidget(fault);
  auto* body = new QHBoxLayout;
  body->setSpacing(0);
  body->addWidget(make_navigation());
  pages_ = new QStackedWidget;
  pages_->setObjectName("pages");
  body->addWidget(pages_, 1);
  column->addLayout(body, 1);
  make_pages();
  cover_ = new QStackedWidget;
  cover_->addWidget(page);
  cover_->addWidget(new LoginPage(staff_));
  setCentralWidget(cover_);
  resize(1280, 720);
  setMinimumSize(1100, 660);
  add_shortcuts();
  watch();
  show_page(Page::start);
  refresh();
  const auto say_problems = [this] {
    for (const auto& problem : presenter_.state().library.problems) say(translated(problem));
  };
  connect(&presenter_.flow(), &SessionFlow::library_changed, this, say_problems);
  say_problems();
  connect(&staff_, &Staff::changed, this, &TherapistWindow::show_who_is_in);
  connect(&staff_, &Staff::locking, person_, &ProfilePanel::store_now);
  connect(&staff_, &Staff::refused, this, &TherapistWindow::say);
  connect(&staff_, &Staff::noticed, this, &TherapistWindow::say);
  show_who_is_in();
}

/// Connects what is shown, and closing a window that waits until its work is done.
void TherapistWindow::watch() {
  connect(&presenter_.flow(), &SessionFlow::changed, this, &TherapistWindow::refresh);
  connect(&presenter_.flow(), &SessionFlow::failed, this, &TherapistWindow::say);
  connect(&clinic_, &Clinic::failed, this, &TherapistWindow::say);
  connect(&file_, &PersonFile::failed, this,
          [this](const QString&, const QString& why) { say(why); });
  const auto close_at_last = [this] {
    if (closing_) close();
  };
  // Someone who waits for files, or for a session to be stored, is told that there are none.
  const auto stay = [this] { closing_ = false; };
  connect(&presenter_.flow(), &SessionFlow::settled, this, [this, close_at_last, stay] {
    if (presenter_.state().connection.lost) stay();
    if (std::exchange(next_patient_, false) && !presenter_.state().busy() &&
        !presenter_.state().connection.lost) {
      presenter_.choices().choose_patient({});
      show_page(Page::start);
    }
    close_at_last();
  });
  connect(&clinic_.report(), &ReportWork::written, this, close_at_last);
  connect(&clinic_.report(), &ReportWork::cancelled, this, close_at_last);
  connect(&clinic_.report(), &ReportWork::failed, this, stay);
  connect(&clinic_.research_export(), &ExportWork::written, this, close_at_last);
  connect(&clinic_.research_export(), &ExportWork::cancelled, this, close_at_last);
  connect(&clinic_.research_export(), &ExportWork::failed, this, stay);
  connect(reports_, &ReportsPage::printed, this, close_at_last);
  const auto log_print = [this](const QString& code, bool done) {
    staff_.log("print", code.toStdString(), done);
  };
  connect(reports_, &ReportsPage::sent, &staff_, log_print);
  connect(session_, &SessionPage::sent, &staff_, log_print);
  connect(session_, &SessionPage::sent, this, close_at_last);
}

QWidget* TherapistWindow::make_header() {
  auto* header = new QFrame;
  header->setObjectName("header");
  auto* wordmark = new QLabel(tr("IsoGrasp"));
  wordmark->setObjectName("wordmark");
  simulated_ = new QLabel(tr("SIMULATED"));
  simulated_->setObjectName("simulated");
  simulated_->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
  simulated_->setToolTip(
      tr("What is measured comes from software or a file, not from a person here"));
  patient_screen_ = new QPushButton(tr("Patient screen"));
  patient_screen_->setObjectName("patient_screen");
  describe(*patient_screen_, tr("Patient screen"),
           tr("Show the patient's screen: full screen on a second display (F11)"));
  patient_screen_->setShortcut(Qt::Key_F11);
  connect(patient_screen_, &QPushButton::clicked, this, [this] {
    if (show_patient_screen) show_patient_screen();
  });
  lock_ = new QPushButton;
  lock_->setObjectName("lock");
  lock_->setShortcut(Qt::Key_F12);
  connect(lock_, &QPushButton::clicked, &staff_, &Staff::lock);
  device_light_ = new StateLight(20);
  device_words_ = new QLabel;
  device_words_->setObjectName("device_words");
  device_words_->setProperty("role", "quiet");
  device_words_->setMaximumWidth(scaled(260));
  message_ = new QLabel;
  message_->setObjectName("message");
  message_->setWordWrap(true);
  message_->hide();
  auto* top = new QHBoxLayout;
  top->setSpacing(12);
  top->addWidget(wordmark);
  top->addStretch(1);
  top->addWidget(device_light_);
  top->addWidget(device_words_);
  top->addWidget(simulated_);
  top->addWidget(patient_screen_);
  top->addWidget(lock_);
  auto* column = new QVBoxLayout(header);
  column->setContentsMargins(16, 6, 16, 6);
  column->setSpacing(6);
  column->addLayout(top);
  column->addWidget(message_);
  return header;
}

QWidget* TherapistWindow::make_navigation() {
  navigation_ = new QFrame;
  navigation_->setObjectName("navigation");
  navigation_->setFixedWidth(scaled(104));
  auto* column = new QVBoxLayout(navigation_);
  column->setContentsMargins(8, 12, 8, 12);
  column->setSpacing(4);
  column->addStretch(1);
  return navigation_;
}

void TherapistWindow::add_page(Page page, const QString& title, QWidget* content) {
  auto* tab = new QPushButton;
  const int number = static_cast<int>(page) + 1;
  tab->setObjectName(QStringLiteral("page_%1").arg(number));
  tab->setProperty("tab", true);
  tab->setCheckable(true);
  tab->setMinimumHeight(scaled(40));
  auto* column = static_cast<QVBoxLayout*>(navigation_->layout());
  column->insertWidget(column->count() - 1, tab);
  tabs_.push_back(tab);
  name_tab(page, title);
  // Large letters need more room than a small display has.
  auto* scroll = new QScrollArea;
  scroll->setWidget(content);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setFocusPolicy(Qt::NoFocus);
  scroll->viewport()->setAutoFillBackground(false);
  content->setAutoFillBackground(false);
  pages_->addWidget(scroll);
  connect(tab, &QPushButton::clicked, this, [this, page] { show_page(page); });
}

void TherapistWindow::name_tab(Page page, const QString& title) {
  QPushButton& tab = *tabs_[static_cast<std::size_t>(page)];
  if (tab.text() == title) return;
  const int number = static_cast<int>(page) + 1;
  tab.setText(title);
  tab.setShortcut(QKeySequence(Qt::CTRL | (Qt::Key_0 + number)));  // a new text takes it away
  describe(tab, title, tr("%1 (Ctrl+%2)").arg(title).arg(number));
}

void TherapistWindow::make_pages() {
  start_ = new StartPage(clinic_, presenter_, staff_);
  add_page(Page::start, tr("Start"), start_);
  add_page(Page::patient, tr("Patient"), make_patient());
  session_ = new SessionPage(clinic_, presenter_, settings_, staff_);
  add_page(Page::session, tr("Session"), session_);
  add_page(Page::device, tr("Device"), new DevicePage(presenter_));
  reports_ = new ReportsPage(clinic_, presenter_);
  add_page(Page::reports, tr("Reports"), reports_);
  add_page(Page::library, tr("Library"), new LibraryPage(clinic_, presenter_));
  add_page(Page::settings, tr("Settings"), new SettingsPage(settings_, staff_));
  connect(start_, &StartPage::begin_session, this, [this] { show_page(Page::session); });
  connect(start_, &StartPage::go_to_session, this, [this] { show_page(Page::session); });
  connect(start_, &StartPage::renewed, this, [this] { bar_->refresh(); });
  connect(start_, &StartPage::open_patient, this, [this] { show_page(Page::patient); });
  connect(start_, &StartPage::demonstration_wanted, this, [this] {
    if (open_demonstration) open_demonstration();
  });
  connect(session_, &SessionPage::other_patient, this, [this] { show_page(Page::start); });
  connect(session_, &SessionPage::report_wanted, this, &TherapistWindow::write_report);
  connect(session_, &SessionPage::end_wanted, this, &TherapistWindow::end_session);
}

QWidget* TherapistWindow::make_patient() {
  course_ = new PatientPage(clinic_, presenter_.state().config.library);
  person_ = new ProfilePanel(clinic_, file_);
  auto* tabs = new QTabWidget;
  tabs->setObjectName("patient_tabs");
  tabs->setDocumentMode(true);
  tabs->addTab(course_, tr("Course"));
  identity_ = new IdentityCard(staff_);
  auto* person = new QWidget;
  auto* column = new QVBoxLayout(person);
  column->setContentsMargins(8, 4, 8, 0);
  column->setSpacing(4);
  column->addWidget(identity_);
  column->addWidget(person_, 1);
  tabs->addTab(person, tr("Person"));
  for (QWidget* widget : {static_cast<QWidget*>(tabs), static_cast<QWidget*>(tabs->tabBar())})
    describe(*widget, tr("Course or person"),
             tr("What was measured, or what is known of the person (Tab, arrow keys)"));
  connect(&presenter_.flow(), &SessionFlow::trial_ended, this, &TherapistWindow::show_patient);
  connect(&presenter_.flow(), &SessionFlow::settled, this, &TherapistWindow::show_patient);
  return tabs;
}

/// Reads the patient anew, if the page is looked at.
void TherapistWindow::show_patient() {
  if (page() != Page::patient) return;
  course_->show_patient(presenter_.state().choices.patient);
  person_->show_patient(presenter_.state().choices.patient);
  identity_->show_patient(presenter_.state().choices.patient);
}

void TherapistWindow::show_page(Page page) {
  if (this->page() == Page::patient) person_->store_now();
  pages_->setCurrentIndex(static_cast<int>(page));
  for (std::size_t i = 0; i < tabs_.size(); ++i)
    tabs_[i]->setChecked(i == static_cast<std::size_t>(page));
  show_patient();
  follow_page();
}

/// What is next on the start page comes first while it is looked at and has anything.
void TherapistWindow::follow_page() {
  const bool begins = page() == Page::start && marked_next(*start_) != nullptr;
  bar_->follow(begins ? static_cast<QWidget&>(*start_) : *session_);
}

/// Leads to something that has to be chosen.
void TherapistWindow::choose_at(QWidget& place) {
  show_page(start_->isAncestorOf(&place) ? Page::start : Page::session);
  for (QWidget* part = place.parentWidget(); part != nullptr; part = part->parentWidget())
    if (auto* section = qobject_cast<StepSection*>(part)) section->open(true);
  place.setFocus();
}

TherapistWindow::Page TherapistWindow::page() const {
  return static_cast<Page>(pages_->currentIndex());
}

void TherapistWindow::add_shortcuts() {
  const auto add = [this](const QKeySequence& key, auto act) {
    keys_.push_back(new QShortcut(key, this));
    keys_.back()->setAutoRepeat(false);  // a key that is held presses once
    connect(keys_.back(), &QShortcut::activated, this, act);
  };
  add(Qt::Key_F7, [this] { presenter_.tasks().show_how(); });
  add(Qt::Key_F8, [this] { bar_->press(); });
  add(Qt::Key_F9, [this] { presenter_.trials().start_pause_resume(); });
  add(Qt::Key_F10, [this] {
    presenter_.trials().stop();
    presenter_.protocol().stand_by();
  });
  keys_.pop_back();  // a trial can be stopped even while the windows are locked
  add(QKeySequence::Find, [this] {
    show_page(Page::start);
    findChild<QLineEdit*>("patient_search")->setFocus();
  });
  add(QKeySequence("Ctrl+-"), [this] { presenter_.tasks().adjust_difficulty(-1); });
  add(QKeySequence("Ctrl++"), [this] { presenter_.tasks().adjust_difficulty(+1); });
  add(QKeySequence("Ctrl+K"), [this] { presenter_.protocol().skip(); });
  add(QKeySequence("Ctrl+Shift+R"), [this] { presenter_.trials().repeat(); });
  add(QKeySequence("Ctrl+M"), [this] {
    if (!presenter_.state().session_open()) return;
    presenter_.remarks().note("Mark");
    say(tr("Marked."));
  });
  add(QKeySequence("Ctrl+N"), [this] {
    show_page(Page::session);
    findChild<QLineEdit*>("note")->setFocus();
  });
  add(QKeySequence("Ctrl+R"), [this] { write_report(); });
  add(QKeySequence::Quit, [this] { close(); });
}

/// Whoever comes next finds the start page, and nobody chosen.
void TherapistWindow::end_session() {
  next_patient_ = true;
  presenter_.connecting().disconnect_device();
}

void TherapistWindow::write_report() {
  show_page(Page::reports);
  findChild<QTabWidget*>("report_tabs")->setCurrentIndex(0);
  findChild<QPushButton*>("report")->click();
}

/// A button that has the focus is pressed by Enter as well as by the space bar; where nothing has
/// it that could be pressed, chosen or typed into, Enter does what is next.
void TherapistWindow::keyPressEvent(QKeyEvent* event) {
  const bool enter = (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) &&
                     (event->modifiers() & ~Qt::KeypadModifier) == Qt::NoModifier;
  if (!enter || event->isAutoRepeat() || staff_.closed()) return QMainWindow::keyPressEvent(event);
  QWidget* focus = focusWidget();
  if (qobject_cast<QPushButton*>(focus) != nullptr || qobject_cast<QToolButton*>(focus) != nullptr)
    return static_cast<QAbstractButton*>(focus)->click();
  if (focus == nullptr || focus->focusPolicy() == Qt::NoFocus || !focus->isVisible())
    return bar_->press();
  QMainWindow::keyPressEvent(event);
}

void TherapistWindow::refresh() {
  const auto& view = presenter_.flow().view();
  identity_->show_patient(presenter_.state().choices.patient);  // never that of the one before
  follow_page();
  simulated_->setVisible(presenter_.state().simulated() || presenter_.state().recorded());
  simulated_->setText(presenter_.state().recorded() ? tr("RECORDED") : tr("SIMULATED"));
  device_light_->show_mood(view.device_mood);
  const auto words = QString::fromStdString(view.device_words);
  device_words_->setText(device_words_->fontMetrics().elidedText(words, Qt::ElideRight,
                                                                 device_words_->maximumWidth()));
  device_words_->setToolTip(words);
  device_words_->setAccessibleName((view.start_posture ? tr("Cameras: %1")
                                    : view.hand_entry  ? tr("Tracker: %1")
                                                       : tr("Device: %1"))
                                       .arg(words));
  name_tab(Page::device, view.start_posture ? tr("Cameras")
                         : view.hand_entry  ? tr("Tracker")
                                            : tr("Device"));
}

/// While nobody is in, the login stands in the place of everything else, and no key but that which
/// stops a trial does anything.
void TherapistWindow::show_who_is_in() {
  const auto name = QString::fromStdString(staff_.user());
  lock_->setVisible(staff_.is_protected());
  lock_->setText(name.isEmpty() ? tr("Lock") : tr("Lock (%1)").arg(name));
  describe(*lock_, lock_->text(), tr("Closes the window's pages until somebody logs in (F12)"));
  for (auto* key : keys_) key->setEnabled(!staff_.closed());
  cover_->setCurrentIndex(staff_.closed() ? 1 : 0);
  if (!staff_.closed()) return show_patient();
  person_->forget();
  course_->show_patient("");
  reports_->forget();
  // A dialog stands above the cover.
  for (auto* window : QApplication::topLevelWidgets())
    if (auto* dialog = qobject_cast<QDialog*>(window); dialog != nullptr && dialog->isVisible())
      dialog->reject();
}

void TherapistWindow::say(const QString& words) {
  constexpr int kShown_ms = 12000;
  message_->setText(words);
  message_->show();
  QTimer::singleShot(kShown_ms, message_, [this, words] {
    if (message_->text() != words) return;
    message_->clear();
    message_->hide();
  });
}

void TherapistWindow::demonstration_failed(const QString& why) {
  start_->offer_demonstration(false);
  say(why);
}

bool TherapistWindow::printing() const {
  return reports_->printing() || session_->printing();
}

bool TherapistWindow::may_be_replaced() const {
  return !closing_ && !printing() && !start_->making_demonstration();
}

void TherapistWindow::leave() {
  person_->store_now();
}

void TherapistWindow::closeEvent(QCloseEvent* event) {
  person_->store_now();
  presenter_.connecting().cancel();  // nothing has begun that could be lost
  if (!presenter_.state().busy() && !clinic_.writing() && !printing()) {
    event->accept();
    if (on_closed) on_closed();
    return;
  }
  // Session and files are written to their ends first; the window goes when that is done.
  event->ignore();
  closing_ = true;
  presenter_.connecting().end_session();
}

}  // namespace isograsp::gui
