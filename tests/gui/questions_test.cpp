// SPDX-License-Identifier: GPL-3.0-or-later
// Questions of a task in the therapist's window: asked when a trial is over, kept with it, and
// nothing begins by itself before they are answered.
#include <algorithm>
#include <fstream>

#include "core/files.hpp"
#include "operator.hpp"
#include "short_library.hpp"
#include "storage/access/open_store.hpp"
#include "storage/records/trial_answers.hpp"
#include "tests/support/temporary_folder.hpp"

namespace isograsp::gui::test::questions_test {
namespace {

/// Asks about the resting force.
std::string library_that_asks(const TemporaryFolder& folder) {
  const std::string library = make_short_library(folder);
  const std::string file = library + "/tasks/resting_force.toml";
  const auto text = read_text(file);
  std::ofstream(file) << "questionnaire = \"virtual_grasp\"\n" << *text;
  return library;
}

class Questions : public QtTest {
 protected:
  Questions() {
    windows_.therapist().show();
    EXPECT_TRUE(wait_until([&] { return windows_.clinic().is_open(); }));
  }
  ~Questions() override {
    windows_.presenter().connecting().end_session();
    EXPECT_TRUE(wait_until([&] { return !windows_.presenter().state().busy(); }));
  }

  [[nodiscard]] const TrialQuestions& questions() {
    return windows_.presenter().state().rating().questions;
  }
  [[nodiscard]] bool pressed(const char* name) const {
    return operator_.find<QAbstractButton>(name).isChecked();
  }

  TemporaryFolder folder_;
  Windows windows_{
      settling_soon({folder_.path("clinic.db"), "", library_that_asks(folder_), "test"})};
  Operator operator_{windows_};
};

TEST_F(Questions, AreAskedAboutATrialKeptWithItAndTheLastAnswerCounts) {
  operator_.prepare("sim://healthy?seed=7");
  operator_.strap_in();
  EXPECT_EQ(questions().asked, nullptr);
  operator_.run_task();
  ASSERT_NE(questions().asked, nullptr);
  EXPECT_TRUE(questions().due());
  operator_.press("question_naturalness_7");
  EXPECT_TRUE(pressed("question_naturalness_7"));
  EXPECT_TRUE(questions().due());
  operator_.press("question_efficiency_none");
  EXPECT_TRUE(pressed("question_efficiency_none"));
  EXPECT_FALSE(questions().due());
  operator_.press("question_naturalness_4");
  EXPECT_FALSE(pressed("question_naturalness_7"));
  keep_pictures_of_both_sizes(windows_.therapist(), "questions");

  operator_.press("repeat");
  ASSERT_TRUE(
      wait_until([&] { return windows_.presenter().state().snapshot().trial_number == 2; }));
  EXPECT_EQ(questions().asked, nullptr) << "a trial that runs has not been lived through";
  operator_.finish_task();
  EXPECT_TRUE(questions().due());
  EXPECT_FALSE(pressed("question_naturalness_4"));
  EXPECT_FALSE(pressed("question_efficiency_none"));
  operator_.disconnect();

  auto store = storage::open_store(folder_.path("clinic.db"), storage::OpenMode::read_only);
  ASSERT_TRUE(store.ok());
  const auto session = (*store)->recent_sessions(1)->front();
  const auto trials = *(*store)->trials(session.id);
  ASSERT_EQ(trials.size(), 2U);
  const auto events = *(*store)->events(session.id);
  EXPECT_EQ(storage::answers_of(trials[0].id, events),
            (storage::TrialAnswers{{"virtual_grasp.naturalness", 4},
                                   {"virtual_grasp.efficiency", std::nullopt}}));
  EXPECT_TRUE(storage::answers_of(trials[1].id, events).empty()) << "they were not answered";
  const auto findings = (*store)->check();
  ASSERT_TRUE(findings.ok());
  for (const Text& finding : *findings) ADD_FAILURE() << english(finding);
}

TEST_F(Questions, HoldBackWhatWouldBeginByItselfUntilAllIsSaid) {
  auto& presenter = windows_.presenter();
  operator_.prepare_person();
  const auto& protocols = presenter.state().library.protocols;
  const auto found = std::ranges::find_if(
      protocols, [](const auto& one) { return one.spec.name == "First session"; });
  ASSERT_NE(found, protocols.end());
  presenter.choices().choose_protocol(static_cast<int>(found - protocols.begin()));
  operator_.choose_device("sim://healthy?seed=7");
  operator_.press("connect");
  operator_.set_zero();
  operator_.press("strapped");
  ASSERT_TRUE(wait_until([&] { return questions().due(); }, 120));
  operator_.press("question_naturalness_7");
  const double now_s = presenter.state().snapshot().session_time_s;
  const double begins_s = now_s + presenter.state().guide().start_in_s(now_s) + 1.0;
  ASSERT_TRUE(
      wait_until([&] { return presenter.state().snapshot().session_time_s > begins_s; }, 120));
  EXPECT_FALSE(presenter.flow().view().may_stop)
      << "it has begun: " << presenter.flow().view().sentence;
  EXPECT_TRUE(presenter.flow().view().may_begin) << "who wants may go on";
  operator_.press("question_efficiency_5");
  ASSERT_TRUE(wait_until([&] { return presenter.flow().view().may_stop; }))
      << presenter.flow().view().sentence;
}

}  // namespace
}  // namespace isograsp::gui::test::questions_test
