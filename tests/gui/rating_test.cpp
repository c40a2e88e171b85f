// SPDX-License-Identifier: GPL-3.0-or-later
// Effort and pain in the therapist's window: what was answered is shown, can be corrected, and ends
// with the session.
#include <algorithm>

#include "operator.hpp"
#include "short_library.hpp"
#include "storage/access/open_store.hpp"
#include "tests/support/temporary_folder.hpp"

namespace isograsp::gui::test::rating_test {
namespace {

class Rating : public QtTest {
 protected:
  Rating() {
    windows_.therapist().show();
    EXPECT_TRUE(wait_until([&] { return windows_.clinic().is_open(); }));
    operator_.prepare("sim://healthy?seed=7");
    operator_.strap_in();
    operator_.run_task();
  }
  ~Rating() override {
    windows_.presenter().connecting().end_session();
    EXPECT_TRUE(wait_until([&] { return !windows_.presenter().state().busy(); }));
  }

  [[nodiscard]] bool chosen(const char* number) const {
    return operator_.find<QAbstractButton>(number).isChecked();
  }
  [[nodiscard]] std::string remark() const {
    auto& label = operator_.find<QLabel>("rating_remark");
    return label.isVisible() ? label.text().toStdString() : "";
  }
  struct Stored {
    std::vector<storage::RatingRecord> ratings;
    std::vector<std::string> notes;
  };
  /// After the end of the session.
  [[nodiscard]] Stored stored() const {
    operator_.disconnect();
    auto store = storage::open_store(folder_.path("clinic.db"), storage::OpenMode::read_only);
    const auto session = (*store)->recent_sessions(1)->front();
    Stored all{*(*store)->ratings(session.id), {}};
    for (const auto& event : *(*store)->events(session.id))
      if (event.kind == storage::kCorrectionEvent) all.notes.push_back(event.text);
    return all;
  }

  TemporaryFolder folder_;
  Windows windows_{
      settling_soon({folder_.path("clinic.db"), "", make_short_library(folder_), "test"})};
  Operator operator_{windows_};
};

TEST_F(Rating, OneAnswerOfTwoIsNotKeptAndTheWindowSaysSo) {
  operator_.press("effort_4");
  EXPECT_NE(remark().find("nothing is kept yet"), std::string::npos) << remark();
  EXPECT_TRUE(stored().ratings.empty());
}

TEST_F(Rating, WhatWasAnsweredStaysInSightAndAnotherPressCorrectsIt) {
  auto& presenter = windows_.presenter();
  operator_.press("effort_4");
  operator_.press("pain_5");
  EXPECT_TRUE(chosen("effort_4"));
  EXPECT_TRUE(chosen("pain_5"));
  EXPECT_NE(remark().find("effort 4, pain 5"), std::string::npos) << remark();
  EXPECT_NE(presenter.flow().view().sentence.find("stop the work"), std::string::npos)
      << presenter.flow().view().sentence;
  operator_.press("pain_1");
  EXPECT_FALSE(chosen("pain_5"));
  EXPECT_NE(remark().find("effort 4, pain 1"), std::string::npos) << remark();
  EXPECT_EQ(presenter.flow().view().sentence.find("stop the work"), std::string::npos)
      << presenter.flow().view().sentence;
  const auto all = stored();
  ASSERT_EQ(all.ratings.size(), 1U) << "a correction is no second answer";
  EXPECT_EQ(all.ratings[0].effort, 4);
  EXPECT_EQ(all.ratings[0].pain, 1);
  ASSERT_EQ(all.notes.size(), 1U) << "nor is the first answer lost";
  EXPECT_EQ(all.notes[0], "Rating corrected: effort 4, pain 1; before: effort 4, pain 5");
}

TEST_F(Rating, ANewTrialAsksAnewAndTheLastAnswerCanStillBeCorrected) {
  operator_.press("effort_4");
  operator_.press("pain_5");
  operator_.press("repeat");
  ASSERT_TRUE(
      wait_until([&] { return windows_.presenter().state().snapshot().trial_number == 2; }));
  operator_.finish_task();
  EXPECT_FALSE(chosen("effort_4"));
  EXPECT_FALSE(chosen("pain_5"));
  operator_.press("effort_6");
  operator_.press("pain_0");
  EXPECT_TRUE(operator_.find<QAbstractButton>("rating_correct").isHidden()) << "it is in sight";
  operator_.press("repeat");
  ASSERT_TRUE(
      wait_until([&] { return windows_.presenter().state().snapshot().trial_number == 3; }));
  operator_.press("rating_correct");  // also while it runs
  EXPECT_TRUE(chosen("effort_6"));
  operator_.press("effort_3");
  operator_.finish_task();
  const auto all = stored();
  ASSERT_EQ(all.ratings.size(), 2U);
  EXPECT_EQ(all.ratings[0].pain, 5) << "the one before stays as it is";
  EXPECT_EQ(all.ratings[1].effort, 3);
  EXPECT_EQ(all.ratings[1].pain, 0);
}

TEST_F(Rating, EndsWithItsSessionAndNothingOfASessionIsShownToTheNextPatient) {
  auto& presenter = windows_.presenter();
  operator_.press("effort_4");
  operator_.press("pain_1");
  operator_.press("helped");
  ASSERT_TRUE(presenter.state().rating().last);
  ASSERT_TRUE(presenter.state().helped());
  ASSERT_FALSE(presenter.state().traces().forces.points().empty());
  ASSERT_FALSE(presenter.state().rest_words().empty());
  operator_.disconnect();
  EXPECT_FALSE(presenter.state().rating().last);
  EXPECT_FALSE(presenter.state().helped());
  EXPECT_TRUE(presenter.state().rest_words().empty());
  EXPECT_TRUE(presenter.state().traces().last_trial) << "its result may still be looked at";
  operator_.add_patient();
  EXPECT_FALSE(presenter.state().traces().last_trial);
  EXPECT_TRUE(presenter.state().live_score().empty());
  EXPECT_TRUE(presenter.state().traces().forces.points().empty());
}

}  // namespace
}  // namespace isograsp::gui::test::rating_test
