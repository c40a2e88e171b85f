// SPDX-License-Identifier: GPL-3.0-or-later
// The day of the clinic on the start page: who stands first, what a card says, who is found, and
// the session that somebody has left open.
#include "gui/clinic/day.hpp"

#include <QDateTime>
#include <QLineEdit>
#include <ctime>

#include "core/time.hpp"
#include "operator.hpp"
#include "session/protocol/protocol_run.hpp"
#include "short_library.hpp"
#include "storage/access/audit_log.hpp"
#include "storage/access/open_store.hpp"
#include "tests/reports/demo_clinic.hpp"
#include "tests/support/must.hpp"
#include "tests/support/temporary_folder.hpp"

namespace isograsp::gui::test::day_test {
namespace {

using isograsp::test::must;
using isograsp::test::TemporaryFolder;

constexpr int kDay_s = 24 * 3600;
const std::string kLibrary = ISOGRASP_SOURCE_DIR "/library";

std::string days_ago(int days) {
  return utc_text(std::time(nullptr) - days * kDay_s);
}

storage::PatientRecord person(storage::RowId id, const std::string& created_utc) {
  storage::PatientRecord patient;
  patient.id = id;
  patient.code = "P-" + std::to_string(id);
  patient.created_utc = created_utc;
  return patient;
}

storage::SessionRecord session_of(storage::RowId patient, const std::string& started_utc) {
  storage::SessionRecord session;
  session.patient_id = patient;
  session.started_utc = started_utc;
  return session;
}

TEST(OrderOfTheDay, WhoIsHereComesBeforeWhoUsuallyComesAndBeforeAllOthers) {
  const std::vector<storage::PatientRecord> patients{
      person(1, days_ago(50)), person(2, days_ago(50)), person(3, days_ago(50)),
      person(4, days_ago(0)),  person(5, days_ago(50)), person(6, days_ago(50))};
  const std::vector<storage::SessionRecord> sessions{
      session_of(3, days_ago(0)), session_of(2, days_ago(3)),  session_of(6, days_ago(6)),
      session_of(2, days_ago(7)), session_of(5, days_ago(14)), session_of(1, days_ago(21))};
  const auto day = in_order_of_day(patients, sessions, QDate::currentDate());
  std::string order;
  for (const auto& one : day) order += std::to_string(one.patient.id);
  EXPECT_EQ(order, "432561") << "two are here; two come on this day of the week; the rest as seen";
  EXPECT_EQ(day[0].visit, Visit::here);
  EXPECT_EQ(day[2].visit, Visit::usual);
  EXPECT_EQ(day[2].last->started_utc, days_ago(3)) << "the newest of two";
  EXPECT_EQ(day[4].visit, Visit::none) << "six days ago was another day of the week";
  EXPECT_EQ(day[5].visit, Visit::none) << "three weeks are too long ago";
}

TEST(CardOfTheDay, TellsTheFirstPrimaryMeasureWithItsValues) {
  const TemporaryFolder folder;
  const auto store = must(storage::open_store(folder.path("a.db"), storage::OpenMode::create));
  isograsp::test::add_course(*store, "P-1", false);
  const auto patient = *must(store->find_patient("P-1"));
  const auto before = must(read_day_card(*store, patient, days_ago(0)));
  EXPECT_EQ(before.sessions, 6);
  EXPECT_FALSE(before.primary.has_value()) << "none is chosen";
  storage::PrimaryMeasure primary;
  primary.task_name = "Maximum grip force";
  primary.measure = "maximum_force";
  primary.channel = "grip";
  primary.chosen_by = "Ada";
  ASSERT_TRUE(store->add_primary_measure(patient.id, primary).ok());
  const auto card = must(read_day_card(*store, patient, days_ago(0)));
  ASSERT_TRUE(card.primary.has_value());
  EXPECT_GE(card.primary->values.size(), 3U);
  EXPECT_TRUE(card.primary->verdict.has_value());
  EXPECT_EQ(card.unfinished_since_utc, "") << "that was months ago";
}

TEST(CardOfTheDay, TellsSinceWhenAProtocolIsUnfinished) {
  const TemporaryFolder folder;
  const auto protocol = must(session::read_protocol(
      must(session::find_in_library(kLibrary, "protocols", "short")), kLibrary));
  struct BreakOff {};
  constexpr std::time_t kEarlier_s = 40 * 60;
  session::SessionConfig config;
  config.database = folder.path("clinic.db");
  config.create_database = true;
  config.patient_code = "P-1";
  config.device_uri = "sim://mild?seed=7";
  config.library = kLibrary;
  config.protocol_name = protocol.spec.name;
  config.protocol_text = protocol.spec.text;
  config.virtual_time = true;
  config.started_utc = utc_text(std::time(nullptr) - kEarlier_s);
  try {
    const auto session = must(session::Session::open(config));
    (void)session::run_protocol(*session, protocol, [](const session::ProtocolProgress& at) {
      if (at.step == 3) throw BreakOff{};
    });
  } catch (const BreakOff&) {
  }
  const auto store = must(storage::open_store_to_read(config.database));
  const auto patient = *must(store->find_patient("P-1"));
  EXPECT_EQ(must(read_day_card(*store, patient, days_ago(0))).unfinished_since_utc,
            config.started_utc);
  EXPECT_EQ(must(read_day_card(*store, patient, utc_text(std::time(nullptr) + kDay_s)))
                .unfinished_since_utc,
            "")
      << "nobody goes on with it a day later";
}

class StartPageTest : public QtTest {
 protected:
  StartPageTest() {
    auto store = must(storage::open_store(folder_.path("clinic.db"), storage::OpenMode::create));
    for (const char* code : {"P-1", "P-2"}) (void)must(store->add_patient(code, days_ago(30)));
    const auto botulinum = storage::TreatmentMark{0, "2026-03-05", "botulinum_toxin", "flexors"};
    (void)must(store->add_treatment_mark(must(store->find_patient("P-2"))->id, botulinum));
    auto session = session_of(must(store->find_patient("P-1"))->id, days_ago(7));
    session.protocol_name = "Short demonstration";
    session.device_uri = "sim://healthy";
    (void)must(store->begin_session(session));
    store.reset();
    windows_.emplace(GuiConfig{folder_.path("clinic.db"), "sim://healthy?seed=7",
                               make_short_library(folder_), "test"});
    windows_->therapist().show();
    operator_.emplace(*windows_);
    EXPECT_TRUE(wait_until([&] { return cards().count() == 2; }));
  }
  [[nodiscard]] QListWidget& cards() const { return operator_->find<QListWidget>("patient_list"); }

  TemporaryFolder folder_;
  std::optional<Windows> windows_;
  std::optional<Operator> operator_;
};

TEST_F(StartPageTest, ACardSaysWhyTheDayExpectsSomebodyAndWhatComesNext) {
  ASSERT_TRUE(wait_until([&] { return cards().item(1)->toolTip().contains("first session"); }));
  EXPECT_EQ(cards().item(0)->text(), "P-1");
  EXPECT_TRUE(cards().item(0)->toolTip().contains("USUAL DAY"));
  EXPECT_TRUE(cards().item(0)->toolTip().contains("Next: Short demonstration"))
      << cards().item(0)->toolTip().toStdString();
}

TEST_F(StartPageTest, TheChosenPersonStandsBesideTheCardsWhereThereIsRoom) {
  auto& person = operator_->find<QWidget>("chosen_person");
  EXPECT_FALSE(person.isVisible()) << "1280 pixels have no room";
  windows_->therapist().resize(1920, 1080);
  ASSERT_TRUE(wait_until([&] { return person.isVisible(); }));
  cards().setCurrentRow(0);
  const auto says = [&](const QString& words) {
    for (const auto* label : person.findChildren<QLabel*>())
      if (label->text().contains(words)) return true;
    return false;
  };
  EXPECT_TRUE(wait_until([&] { return says("Short demonstration"); }));
  EXPECT_TRUE(says("P-1"));
  keep_picture(windows_->therapist(), "start_1920");
  cards().setCurrentRow(1);
  EXPECT_TRUE(wait_until([&] { return says("No session yet"); }));
  EXPECT_FALSE(says("P-1")) << "nothing of somebody else stays";
}

TEST_F(StartPageTest, AWindowThatIsMadeAnewShowsTheDayToo) {
  const auto* const before = &windows_->therapist();
  Settings settings = windows_->settings().now();
  settings.language = "de";
  windows_->settings().change(settings);
  ASSERT_TRUE(wait_until([&] { return &windows_->therapist() != before; }));
  EXPECT_TRUE(wait_until([&] { return cards().count() == 2; }));
  settings.language = "en";
  windows_->settings().change(settings);
  ASSERT_TRUE(wait_until([&] { return cards().count() == 2; }));
}

TEST_F(StartPageTest, PeopleAreFoundByTreatmentAndProtocol) {
  auto& search = operator_->find<QLineEdit>("patient_search");
  search.setText("botulinum");
  EXPECT_TRUE(wait_until([&] { return cards().count() == 1 && cards().item(0)->text() == "P-2"; }));
  search.setText("demonstration");
  EXPECT_TRUE(wait_until([&] { return cards().count() == 1 && cards().item(0)->text() == "P-1"; }));
  search.setText({});
  EXPECT_EQ(cards().count(), 2);
}

TEST_F(StartPageTest, WhoWasAddedByMistakeIsTakenBackAndTheLogSaysSo) {
  operator_->press("add_patient");
  ASSERT_TRUE(wait_until([&] { return cards().count() == 3; }));
  windows_->therapist().show_page(TherapistWindow::Page::start);
  const auto code = QString::fromStdString(windows_->presenter().state().choices.patient);
  operator_->press(qPrintable(QStringLiteral("remove_") + code));
  ASSERT_TRUE(wait_until([&] { return cards().count() == 2; }));
  EXPECT_EQ(windows_->presenter().state().choices.patient, "");
  EXPECT_FALSE(operator_->find<QPushButton>("remove_P-1").isVisible()) << "there is a session";
  const auto access = must(storage::Access::open(folder_.path("clinic.db")));
  EXPECT_EQ(must(storage::read_audit(*access, {"remove patient", code.toStdString()})).size(), 1U);
}

TEST_F(StartPageTest, BeginOnACardIsTheOnePressToASession) {
  operator_->press("begin_P-2");
  EXPECT_EQ(windows_->presenter().state().choices.patient, "P-2");
  EXPECT_EQ(windows_->therapist().page(), TherapistWindow::Page::session);
  EXPECT_FALSE(windows_->presenter().state().choices.today.hand) << "nothing is chosen beforehand";
}

TEST_F(StartPageTest, WhoeverComesNextEndsASessionThatWasLeftOpenWithOnePress) {
  operator_->prepare("sim://healthy?seed=7");
  windows_->therapist().show_page(TherapistWindow::Page::start);
  EXPECT_TRUE(operator_->find<QLabel>("open_session").text().contains("right hand"));
  EXPECT_FALSE(cards().isVisible()) << "no other patient while a session is open";
  operator_->press("end_open_session");
  ASSERT_TRUE(wait_until([&] { return !windows_->presenter().state().busy(); }));
  EXPECT_FALSE(operator_->find<QLabel>("open_session").isVisible());
  EXPECT_TRUE(cards().isVisible() && cards().isEnabled());
}

}  // namespace
}  // namespace isograsp::gui::test::day_test
