// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/windows.hpp"

#include <QApplication>
#include <QKeyEvent>
#include <QLineEdit>
#include <QScreen>
#include <QTimer>
#include <utility>

#include "gui/look/look.hpp"

namespace isograsp::gui {

namespace {

constexpr int kAskAgain_ms = 200;

/// Copies text that was typed and not sent yet into the same fields of the new window.
void carry_typed(const QWidget& from, const QWidget& to) {
  for (const auto* old : from.findChildren<QLineEdit*>()) {
    if (!old->isModified() || old->objectName().startsWith("qt_")) continue;
    if (old->objectName().startsWith("identity_")) continue;  // closed in the other one
    if (auto* field = to.findChild<QLineEdit*>(old->objectName())) {
      field->setText(old->text());
      field->setModified(true);
    }
  }
}

/// The pedal of hands that are points on the screen: it is held, whichever window has the keys.
class ClutchPedal final : public QObject {
 public:
  explicit ClutchPedal(SessionPresenter& presenter) : presenter_(presenter) {
    qApp->installEventFilter(this);
  }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    const bool pressed = event->type() == QEvent::KeyPress;
    if (!pressed && event->type() != QEvent::KeyRelease) return false;
    const auto& key = *static_cast<QKeyEvent*>(event);
    if (key.key() != Qt::Key_F6) return QObject::eventFilter(watched, event);
    if (!key.isAutoRepeat()) presenter_.trials().hold_clutch(pressed);
    return true;
  }

 private:
  SessionPresenter& presenter_;
};

}  // namespace

Windows::Windows(const GuiConfig& config)
    : settings_(QString::fromStdString(config.settings)),
      applied_(settings_.now()),
      staff_(config.database),
      clinic_(config.database),
      person_file_(clinic_),
      backups_(config.database),
      look_only_(config.look_only),
      presenter_(config, clinic_, person_file_, settings_),
      clutch_pedal_(std::make_unique<ClutchPedal>(presenter_)) {
  speak(applied_.language);
  dress(*qApp, applied_.font_percent);
  make_therapist();
  for (const auto& problem : settings_.problems()) therapist_->say(problem);
  // After the control that changed them has done its work: it may be in the window that goes.
  QObject::connect(&settings_, &SettingsFile::changed, &presenter_,
                   [this] { QTimer::singleShot(0, &presenter_, [this] { apply_settings(); }); });
  QObject::connect(&settings_, &SettingsFile::failed, &presenter_,
                   [this](const QString& why) { therapist_->say(why); });
  watch_staff();
  log_what_leaves();
  staff_.open();
}

Windows::~Windows() = default;

void Windows::watch_staff() {
  staff_.set_trial_runs([this] { return presenter_.flow().under_way(); });
  staff_.set_after_storing(
      [this](std::function<void()> then) { clinic_.when_done(std::move(then)); });
  QObject::connect(&staff_, &Staff::changed, &presenter_, [this] { follow_staff(); });
  QObject::connect(&staff_, &Staff::opened, &clinic_, [this] {
    reads_only_ = look_only_ || !staff_.allows(storage::Right::write_records);
    clinic_.open(*reads_only_);
  });
  QObject::connect(&clinic_, &Clinic::opened, &backups_, [this] {
    if (!look_only_) backups_.begin();
  });
  QObject::connect(&presenter_.flow(), &SessionFlow::changed, &backups_,
                   [this] { backups_.hold(presenter_.state().busy()); });
  QObject::connect(&backups_, &BackupWork::failed, &presenter_,
                   [this](const QString& why) { therapist_->say(why); });
}

/// Another user has other rights and another size of letters.
void Windows::follow_staff() {
  presenter_.choices().name_operator(staff_.user());
  const bool was_closed = std::exchange(closed_, staff_.closed());
  if (closed_) return person_file_.forget();
  // A user who comes back has not seen earlier messages.
  if (was_closed && !backups_.problem().isEmpty()) therapist_->say(backups_.problem());
  if (!reads_only_ || staff_.busy()) return;
  const bool reads_only = look_only_ || !staff_.allows(storage::Right::write_records);
  if (std::exchange(reads_only_, reads_only) != reads_only) clinic_.open(reads_only);
  if (clinic_.is_open() && person_file_.code() != presenter_.state().choices.patient)
    person_file_.load(presenter_.state().choices.patient);
}

/// What leaves the database is written into its audit log, as are changes of it.
void Windows::log_what_leaves() {
  ReportWork& report = clinic_.report();
  const auto log_report = [this](bool done) {
    staff_.log("report", clinic_.report().code(), done);
  };
  QObject::connect(&report, &ReportWork::written, &staff_, [log_report] { log_report(true); });
  QObject::connect(&report, &ReportWork::failed, &staff_, [log_report] { log_report(false); });
  ExportWork& research = clinic_.research_export();
  const auto log_export = [this](bool done) {
    staff_.log("export", clinic_.research_export().patient(), done);
  };
  QObject::connect(&research, &ExportWork::written, &staff_, [log_export] { log_export(true); });
  QObject::connect(&research, &ExportWork::failed, &staff_, [log_export] { log_export(false); });
  // A backup that was made logs itself.
  QObject::connect(&backups_, &BackupWork::failed, &staff_,
                   [this] { staff_.log("backup", "", false); });
}

void Windows::make_therapist() {
  therapist_ =
      std::make_unique<TherapistWindow>(clinic_, person_file_, presenter_, settings_, staff_);
  therapist_->show_patient_screen = [this] { show_patient_screen(); };
  therapist_->open_demonstration = [this] {
    if (open_demonstration) open_demonstration();
  };
  therapist_->on_closed = [this] {
    if (patient_ != nullptr) patient_->close();
  };
}

/// Every control has words and letters of its own, so the window is made anew, at the same page and
/// place.
void Windows::apply_settings() {
  const Settings& now = settings_.now();
  const bool anew = now.language != applied_.language || now.font_percent != applied_.font_percent;
  if (anew && !therapist_->may_be_replaced()) {
    QTimer::singleShot(kAskAgain_ms, &presenter_, [this] { apply_settings(); });
    return;
  }
  applied_ = now;
  if (!anew) return;
  speak(now.language);
  dress(*qApp, now.font_percent);
  const auto page = therapist_->page();
  const QRect place = therapist_->geometry();
  const auto state = therapist_->windowState();
  const bool visible = therapist_->isVisible();
  therapist_->leave();
  // Until the other one is seen: with its last window the program would end.
  const auto former = std::move(therapist_);
  make_therapist();
  carry_typed(*former, *therapist_);
  clinic_.load_history(presenter_.state().choices.patient);  // titles of measures stand in it
  therapist_->setGeometry(place);
  therapist_->show_page(page);
  therapist_->setWindowState(state);
  therapist_->setVisible(visible);
}

void Windows::show() {
  therapist_->show();
  // A second display is there for the patient.
  if (QGuiApplication::screens().size() > 1) show_patient_screen();
}

void Windows::show_patient_screen() {
  if (patient_ == nullptr) {
    if (const auto why = why_no_opengl(); !why.empty()) {
      therapist_->say(QString::fromStdString(why));
      return;
    }
    patient_ = std::make_unique<PatientWindow>(presenter_, settings_);
    patient_->show_for_patient();
    return;
  }
  if (!patient_->isVisible())
    patient_->show_for_patient();
  else
    patient_->toggle_full_screen();
}

}  // namespace isograsp::gui
