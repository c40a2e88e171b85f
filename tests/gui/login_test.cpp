// SPDX-License-Identifier: GPL-3.0-or-later
// A protected database in the windows: nobody sees anything before a login, the lock closes what
// was open, a PIN names the next person, names are read on request only.
#include <QComboBox>
#include <QDialog>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QShortcut>
#include <QStackedWidget>
#include <QTest>
#include <algorithm>

#include "gui/office_pages/login_page.hpp"
#include "gui/office_pages/reports_page.hpp"
#include "gui/record_pages/identity_card.hpp"
#include "gui/windows.hpp"
#include "operator.hpp"
#include "short_library.hpp"
#include "storage/access/accounts.hpp"
#include "storage/access/audit_log.hpp"
#include "storage/access/open_store.hpp"
#include "storage/person/consent.hpp"
#include "tests/support/temporary_folder.hpp"

namespace isograsp::gui::test::login_test {
namespace {

constexpr const char* kPassphrase = "a clinic by the sea";
constexpr const char* kPassword = "correct horse";
constexpr const char* kPin = "2580";

class LoginTest : public QtTest {
 protected:
  LoginTest() {
    {
      auto made =
          storage::Access::create(database_, storage::Secret(kPassphrase), &storage::kCheapKeyCost);
      EXPECT_TRUE(made.ok()) << made.error().message();
      storage::Access& access = *made->access;
      EXPECT_TRUE(storage::add_user(access, "Ada", storage::Role::therapist,
                                    storage::Secret(kPassword), storage::kCheapKeyCost)
                      .ok());
      EXPECT_TRUE(storage::add_user(access, "Rosa", storage::Role::researcher,
                                    storage::Secret(kPassword), storage::kCheapKeyCost)
                      .ok());
      EXPECT_TRUE(access.log_in("Ada", storage::Secret(kPassword)).ok());
      EXPECT_TRUE(storage::set_own_pin(access, storage::Secret(kPin)).ok());
      auto store = *storage::open_store(database_, storage::OpenMode::existing);
      EXPECT_TRUE(store->add_patient("P-0427").ok());
      EXPECT_TRUE(
          storage::set_identity(access, "P-0427", {"Maria Berger", "1950-03-05", "555 0100"}).ok());
    }
    windows_ =
        std::make_unique<Windows>(GuiConfig{database_, "", make_short_library(folder_), "test"});
    operator_ = std::make_unique<Operator>(*windows_);
    windows_->therapist().show();
    EXPECT_TRUE(wait_until([&] { return !windows_->staff().users().empty(); }));
  }

  [[nodiscard]] bool covered() {
    return windows_->therapist().findChild<LoginPage*>()->isVisible();
  }
  void log_in(const QString& who, const char* secret) {
    auto& list = operator_->find<QComboBox>("login_who");
    const int index = list.findText(who);
    ASSERT_GE(index, 0) << who.toStdString();
    list.setCurrentIndex(index);
    Q_EMIT list.activated(index);
    auto& field = operator_->find<QLineEdit>("login_secret");
    QTest::keyClicks(&field, secret);
    QTest::keyClick(&field, Qt::Key_Return);
    ASSERT_TRUE(wait_until([&] { return !windows_->staff().busy(); }));
  }
  /// Where a PIN would be enough.
  void log_in_with_password(const QString& who) {
    auto& list = operator_->find<QComboBox>("login_who");
    list.setCurrentIndex(list.findText(who));
    Q_EMIT list.activated(list.currentIndex());
    operator_->press("login_with_password");
    log_in(who, kPassword);
    ASSERT_FALSE(windows_->staff().closed())
        << operator_->find<QLabel>("login_problem").text().toStdString();
  }
  void keep(const char* name) { keep_picture(windows_->therapist(), name); }

  TemporaryFolder folder_;
  std::string database_ = folder_.path("clinic.db");
  std::unique_ptr<Windows> windows_;
  std::unique_ptr<Operator> operator_;
};

TEST_F(LoginTest, WhatTheLoginFoundIsSaidAndStandsOnThePageOfTheSettings) {
  log_in("Rosa", kPassword);
  EXPECT_FALSE(operator_->find<QLabel>("message").text().contains("no file -audit"));
  windows_->staff().lock();
  std::filesystem::remove(database_ + "-audit");
  log_in_with_password("Ada");
  EXPECT_TRUE(operator_->find<QLabel>("message").text().contains("no file -audit"));
  windows_->therapist().show_page(TherapistWindow::Page::settings);
  const auto& found = operator_->find<QLabel>("records_found");
  EXPECT_TRUE(found.isVisible());
  EXPECT_TRUE(found.text().contains("no file -audit")) << found.text().toStdString();
  EXPECT_TRUE(operator_->find<QLabel>("records_limits").text().contains("older copy"));
  keep_pictures_of_both_sizes(windows_->therapist(), "settings_protected");
  windows_->staff().lock();
  log_in_with_password("Ada");
  EXPECT_FALSE(found.isVisible()) << "the login has made it anew";
}

TEST_F(LoginTest, NothingOpensBeforeSomebodyIsIn) {
  keep("login");
  EXPECT_TRUE(covered());
  EXPECT_FALSE(windows_->clinic().is_open());
  EXPECT_FALSE(operator_->find<QListWidget>("patient_list").isVisible());
  const auto works = [&](const QKeySequence& key) {
    for (const auto* shortcut : windows_->therapist().findChildren<QShortcut*>())
      if (shortcut->key() == key) return shortcut->isEnabled();
    ADD_FAILURE() << "no shortcut is " << key.toString().toStdString();
    return false;
  };
  EXPECT_FALSE(works(QKeySequence::Find));
  EXPECT_TRUE(works(QKeySequence(Qt::Key_F10))) << "stopping is never locked away";
  log_in("Ada", "wrong password");
  EXPECT_TRUE(windows_->staff().closed());
  EXPECT_FALSE(operator_->find<QLabel>("login_problem").text().isEmpty());
  EXPECT_TRUE(operator_->find<QLineEdit>("login_secret").text().isEmpty()) << "typed anew";
  log_in("Ada", kPassword);
  ASSERT_TRUE(wait_until([&] { return windows_->clinic().is_open(); }));
  EXPECT_EQ(windows_->staff().user(), "Ada");
  EXPECT_TRUE(operator_->find<QListWidget>("patient_list").isVisible());
  EXPECT_TRUE(works(QKeySequence::Find));
}

TEST_F(LoginTest, TheLockClosesWhatWasOpenAndAPinOpensItAgain) {
  log_in("Ada", kPassword);
  ASSERT_TRUE(wait_until([&] { return windows_->clinic().is_open(); }));
  operator_->press("show_names");
  auto& list = operator_->find<QListWidget>("patient_list");
  ASSERT_TRUE(wait_until(
      [&] { return list.count() == 1 && list.item(0)->toolTip().contains("Maria Berger"); }));
  keep("names");
  QTest::keyClicks(&operator_->find<QLineEdit>("patient_search"), "berg");
  EXPECT_EQ(list.count(), 1) << "found by name";
  operator_->press("lock");
  EXPECT_TRUE(windows_->staff().locked());
  EXPECT_FALSE(list.isVisible());
  EXPECT_TRUE(windows_->staff().names().empty()) << "not kept behind the lock";
  keep("locked");
  log_in("Ada", kPin);
  EXPECT_FALSE(windows_->staff().closed())
      << operator_->find<QLabel>("login_problem").text().toStdString();
  EXPECT_TRUE(list.isVisible());
  ASSERT_TRUE(wait_until([&] { return list.count() == 1; }));
  EXPECT_FALSE(list.item(0)->toolTip().contains("Maria Berger"));
}

TEST_F(LoginTest, AnIdentityIsReadOnRequestAndTheLogSaysByWhom) {
  log_in("Ada", kPassword);
  ASSERT_TRUE(wait_until([&] { return windows_->clinic().is_open(); }));
  windows_->presenter().choices().choose_patient("P-0427");
  windows_->therapist().show_page(TherapistWindow::Page::patient);
  operator_->find<QTabWidget>("patient_tabs").setCurrentIndex(1);
  auto& name = operator_->find<QLineEdit>("identity_name");
  EXPECT_TRUE(name.text().isEmpty());
  operator_->press("identity_show");
  ASSERT_TRUE(wait_until([&] { return name.text() == "Maria Berger"; }));
  keep("identity");
  name.setText("Maria Berger-Novak");
  operator_->press("identity_store");
  const auto* card = windows_->therapist().findChild<IdentityCard*>();
  ASSERT_TRUE(wait_until([&] {
    const auto labels = card->findChildren<QLabel*>();
    return std::any_of(labels.begin(), labels.end(),
                       [](const QLabel* label) { return label->text() == "Kept."; });
  }));
  windows_->presenter().choices().choose_patient("");
  EXPECT_TRUE(name.text().isEmpty()) << "nothing of one person stays for the next";
  storage::Access& access = *windows_->staff().access();
  ASSERT_TRUE(access.log_in_with_passphrase(storage::Secret(kPassphrase)).ok());
  for (const char* act : {"read identity", "change identity"}) {
    const auto entries = storage::read_audit(access, {act, "P-0427"});
    ASSERT_TRUE(entries.ok()) << entries.error().message();
    ASSERT_FALSE(entries->empty()) << act;
    EXPECT_EQ(entries->back().actor, "Ada");
  }
  EXPECT_EQ((**storage::read_identity(access, "P-0427")).name, "Maria Berger-Novak");
}

TEST_F(LoginTest, ALawfulBasisIsRecordedUnderTheNameOfWhoeverIsIn) {
  log_in("Ada", kPassword);
  ASSERT_TRUE(wait_until([&] { return windows_->clinic().is_open(); }));
  windows_->presenter().choices().choose_patient("P-0427");
  windows_->therapist().show_page(TherapistWindow::Page::session);
  operator_->press("hand_right");
  operator_->answer_screening();
  windows_->presenter().choices().choose_device("leap://127.0.0.1");
  operator_->answer_screening();
  operator_->press("basis_open");
  for (const auto& [field, word] : {std::pair("basis_purpose", "treatment"),
                                    {"basis_basis", "consent"},
                                    {"basis_state", "given"}}) {
    auto& box = operator_->find<QComboBox>(field);
    box.setCurrentIndex(box.findData(word));
  }
  operator_->find<QLineEdit>("basis_text").setText("form 3");
  operator_->press("basis_record");
  auto& words = operator_->find<QLabel>("basis_words");
  ASSERT_TRUE(wait_until([&] { return words.text().contains("recorded by Ada"); }))
      << words.text().toStdString();
  storage::Access& access = *windows_->staff().access();
  const auto recorded = storage::consents(access, "P-0427");
  ASSERT_TRUE(recorded.ok()) << recorded.error().message();
  ASSERT_EQ(recorded->size(), 1U);
  EXPECT_EQ(recorded->front().recorded_by, "Ada");
  EXPECT_EQ(recorded->front().text, "form 3");
  ASSERT_TRUE(access.log_in_with_passphrase(storage::Secret(kPassphrase)).ok());
  const auto entries = storage::read_audit(access, {"add consent", "P-0427"});
  ASSERT_TRUE(entries.ok()) << entries.error().message();
  ASSERT_EQ(entries->size(), 1U);
  EXPECT_EQ(entries->back().actor, "Ada");
}

TEST_F(LoginTest, AResearcherSeesNoIdentity) {
  log_in("Rosa", kPassword);
  ASSERT_TRUE(wait_until([&] { return windows_->clinic().is_open(); }));
  EXPECT_FALSE(operator_->find<QPushButton>("show_names").isVisible());
  windows_->presenter().choices().choose_patient("P-0427");
  windows_->therapist().show_page(TherapistWindow::Page::patient);
  operator_->find<QTabWidget>("patient_tabs").setCurrentIndex(1);
  EXPECT_FALSE(operator_->find<QPushButton>("identity_show").isVisible());
}

TEST_F(LoginTest, NothingThatWasDecryptedStaysForTheNextPerson) {
  log_in("Ada", kPassword);
  ASSERT_TRUE(wait_until([&] { return windows_->clinic().is_open(); }));
  windows_->presenter().choices().choose_patient("P-0427");
  windows_->therapist().show_page(TherapistWindow::Page::patient);
  auto& goals = operator_->find<QPlainTextEdit>("goals");
  ASSERT_TRUE(wait_until([&] { return goals.isEnabled(); }));
  const QString secret = "to play the piano again";
  goals.setPlainText(secret);
  const auto refused = [&] { return operator_->find<QLabel>("message").text(); };
  operator_->press("lock");  // with the text typed, not stored
  EXPECT_TRUE(goals.toPlainText().isEmpty());
  EXPECT_FALSE(windows_->person_file().records().has_value());
  ASSERT_TRUE(wait_until([&] { return windows_->staff().access()->is_locked(); }));
  EXPECT_EQ(refused(), "");
  log_in("Rosa", kPassword);
  ASSERT_TRUE(wait_until([&] { return windows_->person_file().code() == "P-0427"; }));
  ASSERT_TRUE(wait_until([&] { return windows_->person_file().records().has_value(); }));
  EXPECT_NE(goals.toPlainText(), secret) << "a researcher";
  operator_->press("lock");
  log_in_with_password("Ada");
  EXPECT_TRUE(wait_until([&] { return goals.toPlainText() == secret; }))
      << "what was typed is kept";
  EXPECT_EQ(refused(), "");
}

TEST_F(LoginTest, TheDatabaseIsOpenWithTheRightsOfWhoeverIsIn) {
  log_in("Rosa", kPassword);
  ASSERT_TRUE(wait_until([&] { return windows_->clinic().is_open(); }));
  operator_->press("lock");
  log_in_with_password("Ada");
  windows_->clinic().add_patient();
  EXPECT_TRUE(wait_until([&] { return windows_->clinic().patients().size() == 2; }))
      << operator_->find<QLabel>("message").text().toStdString();
}

TEST_F(LoginTest, ADialogClosesWithTheLock) {
  log_in("Ada", kPassword);
  ASSERT_TRUE(wait_until([&] { return windows_->clinic().is_open(); }));
  QDialog dialog(&windows_->therapist());
  dialog.open();
  operator_->press("lock");
  EXPECT_FALSE(dialog.isVisible());
  EXPECT_EQ(dialog.result(), QDialog::Rejected);
}

TEST_F(LoginTest, AWrongPasswordIsToldAtTheLoginAloneWithoutAPath) {
  log_in("Ada", "wrong password");
  EXPECT_EQ(operator_->find<QLabel>("login_problem").text(),
            "name or password is wrong; try again");
  EXPECT_EQ(operator_->find<QLabel>("message").text(), "");
}

TEST_F(LoginTest, TheListKeepsWhoWasChosenAndElseShowsWhoWasIn) {
  auto& list = operator_->find<QComboBox>("login_who");
  log_in("Rosa", "wrong password");
  EXPECT_EQ(list.currentText(), "Rosa");
  log_in("Rosa", kPassword);
  ASSERT_TRUE(wait_until([&] { return windows_->clinic().is_open(); }));
  operator_->press("lock");
  EXPECT_EQ(list.currentText(), "Rosa");
  log_in_with_password("Ada");
  operator_->press("lock");
  EXPECT_EQ(list.currentText(), "Ada");
}

TEST_F(LoginTest, TheContactKeepsItsLines) {
  log_in("Ada", kPassword);
  ASSERT_TRUE(wait_until([&] { return windows_->clinic().is_open(); }));
  storage::Access& access = *windows_->staff().access();
  const std::string contact = "555 0100\nmaria@example.org";
  ASSERT_TRUE(
      storage::set_identity(access, "P-0427", {"Maria Berger", "1950-03-05", contact}).ok());
  windows_->presenter().choices().choose_patient("P-0427");
  windows_->therapist().show_page(TherapistWindow::Page::patient);
  operator_->find<QTabWidget>("patient_tabs").setCurrentIndex(1);
  operator_->press("identity_show");
  auto& name = operator_->find<QLineEdit>("identity_name");
  ASSERT_TRUE(wait_until([&] { return name.text() == "Maria Berger"; }));
  name.setText("Maria Novak");
  operator_->press("identity_store");
  ASSERT_TRUE(wait_until([&] {
    const auto read = storage::read_identity(access, "P-0427");
    return read.ok() && *read && (*read)->name == "Maria Novak";
  }));
  EXPECT_EQ((**storage::read_identity(access, "P-0427")).contact, contact);
}

TEST_F(LoginTest, APrintedReportAndABackupStandInTheAuditLog) {
  log_in("Ada", kPassword);
  ASSERT_TRUE(wait_until([&] { return windows_->clinic().is_open(); }));
  auto* reports = windows_->therapist().findChild<ReportsPage*>();
  Q_EMIT reports->sent("P-0427", true);
  storage::Access& access = *windows_->staff().access();
  ASSERT_TRUE(access.log_in_with_passphrase(storage::Secret(kPassphrase)).ok());
  const auto logged = [&](const char* act) {
    const auto entries = storage::read_audit(access, {act, ""});
    return entries.ok() && !entries->empty();
  };
  EXPECT_TRUE(wait_until([&] { return logged("print"); }));
}

TEST_F(LoginTest, WhoeverClosesTheWindowsIsLoggedOut) {
  log_in("Ada", kPassword);
  operator_.reset();
  windows_.reset();
  auto access = *storage::Access::open(database_);
  EXPECT_FALSE(access->user());
  ASSERT_TRUE(access->log_in_with_passphrase(storage::Secret(kPassphrase)).ok());
  const auto entries = storage::read_audit(*access, {"log out", ""});
  ASSERT_TRUE(entries.ok()) << entries.error().message();
  ASSERT_FALSE(entries->empty());
  EXPECT_EQ(entries->back().actor, "Ada");
}

/// Somebody at this station, in the time of the test.
class StaffTest : public QtTest {
 protected:
  StaffTest() {
    auto made =
        storage::Access::create(database_, storage::Secret(kPassphrase), &storage::kCheapKeyCost);
    EXPECT_TRUE(made.ok()) << made.error().message();
    EXPECT_TRUE(storage::add_user(*made->access, "Ada", storage::Role::therapist,
                                  storage::Secret(kPassword), storage::kCheapKeyCost)
                    .ok());
    EXPECT_TRUE(storage::set_policy(*made->access, {kLockAfter_s, 10}).ok());
    made->access.reset();
    staff_ = std::make_unique<Staff>(database_, &clock_);
    staff_->open();
    EXPECT_TRUE(wait_until([&] { return !staff_->busy(); }));
    QString password = kPassword;
    staff_->log_in(Staff::Key::password, "Ada", password);
    EXPECT_TRUE(wait_until([&] { return !staff_->busy(); }));
    EXPECT_FALSE(staff_->closed());
  }
  void wait(double seconds) {
    clock_.wait_until(clock_.now() + from_seconds(seconds));
    staff_->lock_if_due();
  }

  static constexpr int kLockAfter_s = 60;
  TemporaryFolder folder_;
  std::string database_ = folder_.path("clinic.db");
  ManualClock clock_;
  std::unique_ptr<Staff> staff_;
};

TEST_F(StaffTest, LocksWhenNobodyHasTouchedAnything) {
  wait(kLockAfter_s - 1);
  EXPECT_FALSE(staff_->locked());
  wait(2);
  EXPECT_TRUE(staff_->locked());
}

TEST_F(StaffTest, IsPutOffByWhateverAHandDoes) {
  QObject anything;
  for (const auto type : {QEvent::KeyPress, QEvent::ShortcutOverride, QEvent::MouseButtonPress,
                          QEvent::MouseMove, QEvent::TouchBegin, QEvent::TouchUpdate}) {
    wait(kLockAfter_s - 1);
    QEvent event(type);
    QCoreApplication::sendEvent(&anything, &event);
  }
  EXPECT_FALSE(staff_->locked());
  QEvent paint(QEvent::Paint);
  wait(kLockAfter_s - 1);
  QCoreApplication::sendEvent(&anything, &paint);
  wait(2);
  EXPECT_TRUE(staff_->locked());
}

TEST_F(StaffTest, DoesNotLockInATrialNorAtOnceBehindIt) {
  bool runs = true;
  staff_->set_trial_runs([&] { return runs; });
  wait(10.0 * kLockAfter_s);
  EXPECT_FALSE(staff_->locked());
  runs = false;
  wait(kLockAfter_s - 1);
  EXPECT_FALSE(staff_->locked()) << "the time begins anew";
  wait(2);
  EXPECT_TRUE(staff_->locked());
}

TEST_F(StaffTest, TheLockWaitsForWhatIsBeingStoredButTheLoginDoesNotPassIt) {
  std::function<void()> stored;
  staff_->set_after_storing([&](std::function<void()> then) { stored = std::move(then); });
  staff_->lock();
  EXPECT_TRUE(staff_->closed());
  EXPECT_FALSE(staff_->access()->is_locked());
  QString wrong = "wrong password";
  staff_->log_in(Staff::Key::password, "Ada", wrong);
  ASSERT_TRUE(wait_until([&] { return !staff_->busy(); }));
  EXPECT_TRUE(staff_->access()->is_locked());
  EXPECT_TRUE(staff_->closed());
  stored();
  QString password = kPassword;
  staff_->log_in(Staff::Key::password, "Ada", password);
  ASSERT_TRUE(wait_until([&] { return !staff_->busy(); }));
  EXPECT_FALSE(staff_->access()->is_locked());
  EXPECT_FALSE(staff_->closed());
}

}  // namespace
}  // namespace isograsp::gui::test::login_test
