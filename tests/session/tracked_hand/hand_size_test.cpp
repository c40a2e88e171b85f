// SPDX-License-Identifier: GPL-3.0-or-later
// Whose entry test gives the size of a hand that cannot open.
#include "session/tracked_hand/hand_size.hpp"

#include <gtest/gtest.h>

#include "session/tracked_hand/entry_capture.hpp"
#include "storage/access/open_store.hpp"
#include "tests/support/must.hpp"
#include "tests/support/scripted_hand.hpp"
#include "tests/support/temporary_folder.hpp"

namespace isograsp::session::hand_size_test {
namespace {

using test::must;

struct Kind {
  bool simulated = false;
  bool recorded = false;
  double size_of_other = 0.0;
};

class OtherHand : public testing::Test {
 protected:
  /// An entry test that passed, of a hand of this length.
  void entered(const char* day, Hand hand, double length_m, const Kind& kind = {}) {
    storage::SessionRecord session;
    session.patient_id = patient_;
    session.started_utc = std::string(day) + "T09:00:00Z";
    session.hand = hand;
    session.device_uri = "leap://127.0.0.1";
    session.simulated = kind.simulated;
    session.recorded = kind.recorded;
    virtual_hand::HandModel model = test::usual_hand(hand);
    model.length_m = length_m;
    storage::PreparationRecord entry;
    entry.session_id = must(store_->begin_session(session));
    entry.kind = kHandEntry;
    add_hand_size(model, entry);
    entry.references.emplace(kSizeOfOtherHand, kind.size_of_other);
    must(store_->add_preparation(entry));
  }
  std::optional<MeasuredHand> of_other(Hand side, bool simulated = false) {
    return must(other_hand_measured(*store_, patient_, side, simulated));
  }
  double length_m(const MeasuredHand& hand) {
    return must(hand_of_size(hand.entry, test::usual_hand(), Hand::right)).length_m;
  }

  test::TemporaryFolder folder_;
  std::unique_ptr<storage::SessionStore> store_ =
      must(storage::open_store(folder_.path("clinic.db"), storage::OpenMode::create));
  storage::RowId patient_ = must(store_->add_patient("P-1")).id;
};

TEST_F(OtherHand, IsThatOfItsNewestEntryTestAndSaysOfWhichDay) {
  EXPECT_FALSE(of_other(Hand::right));
  entered("2026-03-05", Hand::left, 0.18);
  entered("2026-03-12", Hand::left, 0.19);
  entered("2026-03-19", Hand::right, 0.20);
  const auto found = of_other(Hand::right);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->on_date, "2026-03-12");
  EXPECT_EQ(length_m(*found), 0.19);
  EXPECT_EQ(of_other(Hand::left)->on_date, "2026-03-19");
}

TEST_F(OtherHand, IsNeverASimulatedNorARecordedHandNorOneThatHadItsSizeFromThisOne) {
  entered("2026-03-05", Hand::left, 0.18);
  entered("2026-03-06", Hand::left, 0.21, {.simulated = true});
  entered("2026-03-07", Hand::left, 0.22, {.recorded = true});
  entered("2026-03-08", Hand::left, 0.23, {.size_of_other = 1.0});
  const auto found = of_other(Hand::right);
  ASSERT_TRUE(found);
  EXPECT_EQ(length_m(*found), 0.18);
  EXPECT_EQ(of_other(Hand::right, true)->on_date, "2026-03-06") << "of simulated hands it is";
}

}  // namespace
}  // namespace isograsp::session::hand_size_test
