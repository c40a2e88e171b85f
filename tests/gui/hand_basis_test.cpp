// SPDX-License-Identifier: GPL-3.0-or-later
// Before a tracker whose camera looks at a person: on which lawful basis is seen and recorded in
// the windows, by a deliberate press, where the tracker is connected.
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QTableWidget>

#include "gui/hand_pages/basis_dialog.hpp"
#include "gui/words/profile_words.hpp"
#include "gui/words/texts.hpp"
#include "operator.hpp"
#include "short_library.hpp"
#include "storage/access/access.hpp"
#include "storage/access/audit_log.hpp"
#include "storage/access/open_store.hpp"
#include "storage/person/consent.hpp"
#include "tests/device/hands/hand_trackers.hpp"
#include "tests/support/must.hpp"
#include "tests/support/scripted_hand.hpp"
#include "tests/support/temporary_folder.hpp"

namespace isograsp::gui::test::hand_basis_test {
namespace {

using isograsp::test::must;

/// A hand that lies before a tracker.
HandPlay resting_hand() {
  constexpr double kRate_Hz = 100.0;
  constexpr int kSeconds = 4;
  const auto model = isograsp::test::usual_hand();
  std::vector<HandFrame> hands;
  for (int k = 0; k < kSeconds * static_cast<int>(kRate_Hz); ++k) {
    const double t_s = k / kRate_Hz;
    hands.push_back(isograsp::test::picture_of(model, isograsp::test::hand_posture(0.5, t_s)));
    hands.back().t_s = t_s;
  }
  HandPlay play = HandPlay::of(std::move(hands));
  play.repeat = true;
  return play;
}

class LawfulBasis : public QtTest {
 protected:
  LawfulBasis()
      : windows_(GuiConfig{folder_.path("clinic.db"), "", make_hand_library(folder_), "test"}),
        tracker_(isograsp::test::leap_tracker(resting_hand())) {
    windows_.show();
  }
  ~LawfulBasis() override {
    windows_.presenter().connecting().end_session();
    EXPECT_TRUE(wait_until([&] { return !windows_.presenter().state().busy(); }));
  }

  const SessionState& state() { return windows_.presenter().state(); }
  const FlowView& view() { return windows_.presenter().flow().view(); }
  std::string words() { return operator_.find<QLabel>("basis_words").text().toStdString(); }
  void prepare() {
    operator_.prepare_person();
    windows_.presenter().choices().choose_device("leap://" + tracker_->address().text());
    operator_.answer_screening();
  }
  void choose(const char* field, const char* word) {
    auto& box = operator_.find<QComboBox>(field);
    ASSERT_GE(box.findData(word), 0) << word;
    box.setCurrentIndex(box.findData(word));
  }
  void record(const char* purpose, const char* basis, const char* answer) {
    operator_.press("basis_open");
    choose("basis_purpose", purpose);
    choose("basis_basis", basis);
    choose("basis_state", answer);
    operator_.press("basis_record");
    ASSERT_TRUE(
        wait_until([&] { return windows_.therapist().findChild<BasisDialog*>() == nullptr; }));
  }
  void expect_refused() {
    operator_.press("connect");
    ASSERT_TRUE(wait_until([&] { return view().situation == Situation::session_failed; }))
        << view().sentence;
    EXPECT_FALSE(state().session_open());
  }
  std::vector<storage::Consent> stored() {
    return must(storage::consents(*must(storage::Access::open(folder_.path("clinic.db"))),
                                  state().choices.patient));
  }

  TemporaryFolder folder_;
  Windows windows_;
  Operator operator_{windows_};
  std::unique_ptr<isograsp::test::RunningTracker> tracker_;
};

TEST_F(LawfulBasis, IsAskedForByARefusalRecordedWhereTheTrackerIsAndThenItConnects) {
  prepare();
  EXPECT_TRUE(wait_until([&] { return words().find("no lawful basis") != std::string::npos; }))
      << words();
  ASSERT_NO_FATAL_FAILURE(expect_refused());
  EXPECT_NE(view().sentence.find("No lawful basis"), std::string::npos) << view().sentence;
  ASSERT_TRUE(view().fault.has_value());
  EXPECT_NE(view().fault->remedy.find("step Tracker"), std::string::npos) << view().fault->remedy;
  EXPECT_EQ(view().sentence.find("isograsp db"), std::string::npos) << "no command is needed";
  EXPECT_EQ(view().press, NextPress::basis) << "it is the one thing to press";
  keep_picture(windows_.therapist(), "hand_no_basis");

  operator_.press("basis_open");
  auto& dialog = *windows_.therapist().findChild<BasisDialog*>();
  for (const char* field : {"basis_purpose", "basis_basis", "basis_state"})
    EXPECT_FALSE(operator_.find<QComboBox>(field).currentData().isValid())
        << field << " is not filled in beforehand";
  const auto today = iso_text(local_today());
  EXPECT_EQ(operator_.find<QLineEdit>("basis_date").text(), translated_date(today));
  EXPECT_TRUE(operator_.find<QLineEdit>("basis_text").text().isEmpty());
  EXPECT_FALSE(operator_.find<QPushButton>("basis_record").isEnabled());
  choose("basis_purpose", "treatment");
  choose("basis_basis", "care");
  EXPECT_FALSE(operator_.find<QPushButton>("basis_record").isEnabled()) << "what was said?";
  choose("basis_state", "given");
  keep_picture(dialog, "hand_basis_dialog");
  operator_.press("basis_record");
  ASSERT_TRUE(wait_until([&] { return view().press == NextPress::connect; })) << view().sentence;
  EXPECT_NE(words().find("Treatment: given on " + today), std::string::npos) << words();
  keep_picture(windows_.therapist(), "hand_basis_given");

  operator_.press("connect");
  ASSERT_TRUE(wait_until([&] { return view().may_zero; })) << view().sentence;
  EXPECT_TRUE(operator_.find<QLabel>("camera_on").isVisible() ||
              wait_until([&] { return operator_.find<QLabel>("camera_on").isVisible(); }));
  const auto all = stored();
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all[0].purpose, "treatment");
  EXPECT_EQ(all[0].basis, "care");
  EXPECT_EQ(all[0].state, "given");
  EXPECT_EQ(all[0].on_date, today);
  const auto access = must(storage::Access::open(folder_.path("clinic.db")));
  const auto logged = must(storage::read_audit(*access, {"add consent", state().choices.patient}));
  ASSERT_EQ(logged.size(), 1U) << "as the command logs it";
  EXPECT_EQ(logged[0].detail, "treatment, care, given");
}

TEST_F(LawfulBasis, ThatWasWithdrawnIsShownAsSuchAndRefuses) {
  prepare();
  ASSERT_NO_FATAL_FAILURE(record("treatment", "consent", "given"));
  EXPECT_TRUE(wait_until([&] { return words().find("given") != std::string::npos; })) << words();
  ASSERT_NO_FATAL_FAILURE(record("treatment", "consent", "withdrawn"));
  EXPECT_TRUE(wait_until([&] {
    return words().find("✗ Treatment: withdrawn") != std::string::npos;
  })) << words();
  ASSERT_NO_FATAL_FAILURE(expect_refused());
  EXPECT_EQ(stored().size(), 2U) << "nothing that was recorded is changed";
  operator_.press("basis_open");
  auto& recorded = operator_.find<QTableWidget>("basis_recorded");
  ASSERT_TRUE(wait_until([&] { return recorded.rowCount() == 2; })) << "all of it can be read";
  keep_picture(*windows_.therapist().findChild<BasisDialog*>(), "hand_basis_withdrawn");
  operator_.press("basis_cancel");
}

TEST_F(LawfulBasis, OfAPurposeThatNeedsNoCameraOpensNone) {
  prepare();
  ASSERT_NO_FATAL_FAILURE(record("teaching", "consent", "given"));
  EXPECT_TRUE(wait_until([&] {
    return words().find("No camera may look") != std::string::npos &&
           words().find("✓ Teaching") != std::string::npos;
  })) << words();
  ASSERT_NO_FATAL_FAILURE(expect_refused());
}

TEST_F(LawfulBasis, OnADayThatIsNoneIsNotRecordedAndTheDialogSaysWhy) {
  prepare();
  operator_.press("basis_open");
  choose("basis_purpose", "treatment");
  choose("basis_basis", "care");
  choose("basis_state", "given");
  auto& remark = operator_.find<QLabel>("basis_remark");
  for (const char* day : {"", "2026-02-30", "2999-01-01"}) {
    operator_.find<QLineEdit>("basis_date").setText(day);
    remark.clear();
    operator_.press("basis_record");
    EXPECT_FALSE(remark.text().isEmpty()) << day;
  }
  EXPECT_TRUE(stored().empty());
  operator_.press("basis_cancel");
}

TEST_F(LawfulBasis, IsNotAskedOfASimulatedHand) {
  operator_.prepare_person();
  operator_.choose_device("sim://hand?user=healthy&seed=7");
  EXPECT_FALSE(operator_.find<QLabel>("basis_words").isVisible());
  EXPECT_FALSE(operator_.find<QPushButton>("basis_open").isVisible());
}

}  // namespace
}  // namespace isograsp::gui::test::hand_basis_test
