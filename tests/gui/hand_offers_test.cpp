// SPDX-License-Identifier: GPL-3.0-or-later
// What a session with a tracked hand asks and offers beside its tasks: the size of the other hand
// for one that cannot open; effort, pain and shoulder pain after a bout.
#include <QCheckBox>
#include <QLabel>
#include <algorithm>

#include "operator.hpp"
#include "session/protocol/protocol_run.hpp"
#include "session/session.hpp"
#include "session/tracked_hand/entry_capture.hpp"
#include "short_library.hpp"
#include "storage/access/open_store.hpp"
#include "tests/support/must.hpp"
#include "tests/support/temporary_folder.hpp"

namespace isograsp::gui::test::hand_offers_test {
namespace {

using isograsp::test::must;

constexpr const char* kHandUri = "sim://hand?user=healthy&seed=7";

class HandOffers : public QtTest {
 protected:
  ~HandOffers() override {
    windows_.presenter().connecting().end_session();
    EXPECT_TRUE(wait_until([&] { return !windows_.presenter().state().busy(); }));
  }

  const SessionState& state() { return windows_.presenter().state(); }
  const FlowView& view() { return windows_.presenter().flow().view(); }
  bool is_there(const char* name) { return operator_.find<QWidget>(name).isVisible(); }
  QString label(const char* name) { return operator_.find<QLabel>(name).text(); }
  void choose(Hand hand) { windows_.presenter().choices().choose_hand(hand); }
  void prepare(Hand hand) {
    choose(hand);
    windows_.presenter().choices().choose_device(kHandUri);
    operator_.answer_screening();
  }
  void connect() {
    operator_.press("connect");
    ASSERT_TRUE(wait_until([&] { return view().may_zero; })) << view().sentence;
  }
  void do_entry_test() {
    operator_.press("entry_test");
    ASSERT_TRUE(wait_until([&] { return !view().may_zero; }));
    ASSERT_TRUE(wait_until([&] { return view().may_zero; })) << view().sentence;
  }
  std::unique_ptr<storage::SessionStore> store() {
    return must(storage::open_store(folder_.path("clinic.db"), storage::OpenMode::read_only));
  }

  TemporaryFolder folder_;
  std::string library_ = make_hand_library(folder_);
  Windows windows_{GuiConfig{folder_.path("clinic.db"), "", library_, "test"}};
  Operator operator_{windows_};
};

TEST_F(HandOffers, TheSizeOfTheOtherHandOnceThatWasMeasuredAndSayWhen) {
  windows_.show();
  operator_.add_patient();
  prepare(Hand::right);
  EXPECT_TRUE(wait_until([&] { return view().may_connect; }));
  EXPECT_FALSE(is_there("size_of_other")) << "there is none yet";

  // The other hand, on another day.
  session::SessionConfig config;
  config.database = folder_.path("clinic.db");
  config.patient_code = state().choices.patient;
  config.hand = Hand::left;
  config.device_uri = kHandUri;
  config.library = library_;
  config.virtual_time = true;
  config.started_utc = "2026-03-05T09:00:00Z";
  const auto protocol =
      must(session::read_protocol(library_ + "/protocols/hand_opens.toml", library_));
  const auto other = must(session::Session::open(config));
  must(session::run_protocol(*other, protocol, {}));
  other->close();

  prepare(Hand::left);
  EXPECT_TRUE(wait_until([&] { return view().may_connect; }));
  EXPECT_FALSE(is_there("size_of_other")) << "it is this hand that was measured";
  prepare(Hand::right);
  ASSERT_TRUE(wait_until([&] { return is_there("size_of_other"); }));
  EXPECT_TRUE(label("size_of_other_from").contains("2026-03-05"))
      << label("size_of_other_from").toStdString();
  EXPECT_FALSE(operator_.find<QCheckBox>("size_of_other").isChecked()) << "only if it is wanted";
  operator_.press("size_of_other");
  keep_picture(windows_.therapist(), "hand_size_offer");
  ASSERT_NO_FATAL_FAILURE(connect());
  EXPECT_TRUE(label("entry_size").contains("left hand, entry test of 2026-03-05"))
      << label("entry_size").toStdString();
  keep_picture(windows_.therapist(), "hand_size_of_other");
  ASSERT_NO_FATAL_FAILURE(do_entry_test());
  operator_.disconnect();
  EXPECT_FALSE(state().choices.today.size_of_other) << "asked anew in every session";

  const auto stored = store();
  const auto sessions = must(stored->recent_sessions(2));
  const auto right =
      std::ranges::find(sessions, std::optional(Hand::right), &storage::SessionRecord::hand);
  const auto left =
      std::ranges::find(sessions, std::optional(Hand::left), &storage::SessionRecord::hand);
  ASSERT_NE(right, sessions.end());
  ASSERT_NE(left, sessions.end());
  EXPECT_EQ(right->device_uri, std::string(kHandUri) + "&size=other");
  const auto own = must(stored->preparations(left->id));
  const auto taken = must(stored->preparations(right->id));
  ASSERT_EQ(own.size(), 1U);
  ASSERT_EQ(taken.size(), 1U);
  EXPECT_EQ(taken[0].mean, own[0].mean);
  EXPECT_EQ(taken[0].references.at(session::kSizeOfOtherHand), 1.0);
}

TEST_F(HandOffers, EffortPainAndShoulderPainAreAskedAfterABoutAndKeptWithThree) {
  windows_.show();
  operator_.add_patient();
  prepare(Hand::right);
  ASSERT_NO_FATAL_FAILURE(connect());
  ASSERT_NO_FATAL_FAILURE(do_entry_test());
  operator_.press("start");
  ASSERT_TRUE(wait_until([&] { return state().guide().over(); }, 120)) << view().sentence;
  EXPECT_TRUE(state().guide().rating_due());
  EXPECT_TRUE(is_there("shoulder_pain_0"));
  operator_.press("effort_3");
  operator_.press("pain_1");
  EXPECT_TRUE(label("rating_remark").contains("nothing is kept yet"))
      << label("rating_remark").toStdString();
  operator_.press("shoulder_pain_5");
  EXPECT_TRUE(label("rating_remark").contains("shoulder 5"))
      << label("rating_remark").toStdString();
  EXPECT_FALSE(state().guide().rating_due());
  EXPECT_NE(view().sentence.find("Shoulder pain 5"), std::string::npos) << view().sentence;
  operator_.press("shoulder_pain_2");
  EXPECT_EQ(view().sentence.find("stop the work"), std::string::npos) << view().sentence;
  keep_picture(windows_.therapist(), "hand_rated");
  operator_.disconnect();

  const auto stored = store();
  const auto session = must(stored->recent_sessions(1)).at(0);
  const auto ratings = must(stored->ratings(session.id));
  ASSERT_EQ(ratings.size(), 1U);
  EXPECT_EQ(ratings[0].effort, 3);
  EXPECT_EQ(ratings[0].pain, 1);
  EXPECT_EQ(ratings[0].shoulder_pain, 2) << "the correction counts";
  const auto answers = must(stored->answers(session.id));
  EXPECT_TRUE(std::ranges::any_of(answers, [](const storage::SessionAnswer& answer) {
    return answer.topic == "posture" && answer.item == "forearm_supported" && answer.value == "yes";
  })) << "that is the usual";
}

}  // namespace
}  // namespace isograsp::gui::test::hand_offers_test
