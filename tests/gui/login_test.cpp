// SPDX-License-Identifier: GPL-3.0-or-later
// A protected database in the windows: nobody sees anything before a login, the lock closes what
// was open, a PIN names the next person, names are read on request only.
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QStackedWidget>
#include <QTest>

#include "gui/identity_card.hpp"
#include "gui/login_page.hpp"
#include "gui/windows.hpp"
#include "operator.hpp"
#include "short_library.hpp"
#include "storage/accounts.hpp"
#include "storage/audit_log.hpp"
#include "tests/support/temporary_folder.hpp"

namespace isograsp::test {
namespace {

constexpr const char* kPassphrase = "a clinic by the sea";
constexpr const char* kPassword = "correct horse";
constexpr const char* kPin = "2580";

class LoginTest : public QtTest {
 protected:
  LoginTest() {
    {
      auto made = Access::create(database_, Secret(kPassphrase), &kCheapKeyCost);
      EXPECT_TRUE(made.ok()) << made.error().message();
      Access& access = *made->access;
      EXPECT_TRUE(add_user(access, "Ada", Role::therapist, Secret(kPassword), kCheapKeyCost).ok());
      EXPECT_TRUE(
          add_user(access, "Rosa", Role::researcher, Secret(kPassword), kCheapKeyCost).ok());
      EXPECT_TRUE(access.log_in("Ada", Secret(kPassword)).ok());
      EXPECT_TRUE(set_own_pin(access, Secret(kPin)).ok());
      auto store = *SessionStore::open(database_, SessionStore::Open::existing);
      EXPECT_TRUE(store->add_patient("P-0427").ok());
      EXPECT_TRUE(set_identity(access, "P-0427", {"Maria Berger", "1950-03-05", "555 0100"}).ok());
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
  /// A picture of the window, where pictures are asked for.
  void keep(const char* name) {
    const auto folder = qEnvironmentVariable("ISOGRASP_TEST_PICTURES");
    if (folder.isEmpty()) return;
    QTest::qWait(300);
    windows_->therapist().grab().save(QStringLiteral("%1/%2.png").arg(folder, QLatin1String(name)));
  }

  TemporaryFolder folder_;
  std::string database_ = folder_.path("clinic.db");
  std::unique_ptr<Windows> windows_;
  std::unique_ptr<Operator> operator_;
};

TEST_F(LoginTest, NothingOpensBeforeSomebodyIsIn) {
  keep("login");
  EXPECT_TRUE(covered());
  EXPECT_FALSE(windows_->clinic().is_open());
  EXPECT_FALSE(operator_->find<QListWidget>("patient_list").isVisible());
  QTest::keyClick(&windows_->therapist(), Qt::Key_F, Qt::ControlModifier);
  EXPECT_FALSE(operator_->find<QLineEdit>("patient_search").isVisible());
  log_in("Ada", "wrong password");
  EXPECT_TRUE(windows_->staff().closed());
  EXPECT_FALSE(operator_->find<QLabel>("login_problem").text().isEmpty());
  EXPECT_TRUE(operator_->find<QLineEdit>("login_secret").text().isEmpty()) << "typed anew";
  log_in("Ada", kPassword);
  ASSERT_TRUE(wait_until([&] { return windows_->clinic().is_open(); }));
  EXPECT_EQ(windows_->staff().user(), "Ada");
  EXPECT_TRUE(operator_->find<QListWidget>("patient_list").isVisible());
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
  EXPECT_FALSE(list.item(0)->toolTip().contains("Maria Berger"));
}

TEST_F(LoginTest, AnIdentityIsReadOnRequestAndTheLogSaysByWhom) {
  log_in("Ada", kPassword);
  ASSERT_TRUE(wait_until([&] { return windows_->clinic().is_open(); }));
  windows_->presenter().choose_patient("P-0427");
  windows_->therapist().show_page(TherapistWindow::Page::patient);
  operator_->find<QTabWidget>("patient_tabs").setCurrentIndex(1);
  auto& name = operator_->find<QLineEdit>("identity_name");
  EXPECT_TRUE(name.text().isEmpty());
  operator_->press("identity_show");
  ASSERT_TRUE(wait_until([&] { return name.text() == "Maria Berger"; }));
  keep("identity");
  name.setText("Maria Berger-Novak");
  operator_->press("identity_store");
  Access& access = *windows_->staff().access();
  ASSERT_TRUE(wait_until([&] {
    const auto read = read_identity(access, "P-0427");
    return read.ok() && *read && (*read)->name == "Maria Berger-Novak";
  }));
  windows_->presenter().choose_patient("");
  EXPECT_TRUE(name.text().isEmpty()) << "nothing of one person stays for the next";
  ASSERT_TRUE(access.log_in_with_passphrase(Secret(kPassphrase)).ok());
  const auto entries = read_audit(access, {"read identity", "P-0427"});
  ASSERT_TRUE(entries.ok()) << entries.error().message();
  ASSERT_FALSE(entries->empty());
  EXPECT_EQ(entries->front().actor, "Ada");
}

TEST_F(LoginTest, AResearcherSeesNoIdentity) {
  log_in("Rosa", kPassword);
  ASSERT_TRUE(wait_until([&] { return windows_->clinic().is_open(); }));
  EXPECT_FALSE(operator_->find<QPushButton>("show_names").isVisible());
  windows_->presenter().choose_patient("P-0427");
  windows_->therapist().show_page(TherapistWindow::Page::patient);
  operator_->find<QTabWidget>("patient_tabs").setCurrentIndex(1);
  EXPECT_FALSE(operator_->find<QPushButton>("identity_show").isVisible());
}

TEST(Staff, LocksWhenNobodyTouchesAnythingButNeverInATrial) {
  const AccessPolicy policy{60, 10};
  EXPECT_FALSE(is_lock_due(policy, 59.0, false));
  EXPECT_TRUE(is_lock_due(policy, 61.0, false));
  EXPECT_FALSE(is_lock_due(policy, 3600.0, true));
}

}  // namespace
}  // namespace isograsp::test
