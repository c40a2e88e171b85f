// SPDX-License-Identifier: GPL-3.0-or-later
// What limits a hand: shares of the other hand with their intervals; the compass of both hands.
#include "reports/findings/limits.hpp"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include <gtest/gtest.h>

#include "reports/findings/compass.hpp"
#include "reports/findings/patient_records.hpp"
#include "reports/findings/practice_dose.hpp"
#include "storage/access/open_store.hpp"
#include "tests/support/made_up.hpp"
#include "tests/support/must.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/within.hpp"
#include "tests/tasks/specs.hpp"

namespace isograsp::reports::limits_test {
namespace {

using test::library_task_text;
using test::must;

namespace fs = std::filesystem;
constexpr double kRounding = 1e-12;
constexpr double kNormal975 = 1.959964;

std::vector<ComponentDay> days(std::initializer_list<double> values) {
  std::vector<ComponentDay> all;
  for (const double value : values) all.push_back({static_cast<double>(all.size()), "", value});
  return all;
}

TEST(ShareOf, IsTheRatioWithAnIntervalOnLogarithms) {
  const auto one = share_of(days({4.0}), days({10.0}), Comparison::larger);
  EXPECT_WITHIN(one.share, 0.4, kRounding);
  const double half = kNormal975 * kLeastDaySd * std::sqrt(2.0);
  EXPECT_WITHIN(one.low, 0.4 * std::exp(-half), kRounding);
  EXPECT_WITHIN(one.high, 0.4 * std::exp(half), kRounding);
  EXPECT_WITHIN(share_of(days({4, 4, 4}), days({10}), Comparison::larger).high,
                0.4 * std::exp(kNormal975 * kLeastDaySd * std::sqrt(1.0 / 3.0 + 1.0)), kRounding)
      << "more days, a narrower interval";
}

TEST(ShareOf, TurnsTimesAndErrorsOver) {
  const auto time = share_of(days({4.0, 5.0}), days({1.0}), Comparison::smaller);
  const auto speed = share_of(days({1 / 4.0, 1 / 5.0}), days({1.0}), Comparison::larger);
  EXPECT_WITHIN(time.share, speed.share, kRounding);
  EXPECT_WITHIN(time.high, speed.high, kRounding);
  EXPECT_WITHIN(share_of(days({1.0}), days({2.0}), Comparison::logarithm).share, std::exp(-1.0),
                kRounding);
}

TEST(ShareOf, DaysThatDifferMoreWidenIt) {
  const auto calm = share_of(days({4.0, 4.1}), days({10}), Comparison::larger);
  const auto wild = share_of(days({2.0, 8.0}), days({10}), Comparison::larger);
  EXPECT_GT(wild.high / wild.low, 2.0 * calm.high / calm.low);
}

TEST(Training, EveryComponentLeadsToATaskOfTheLibrary) {
  std::set<std::string> names;
  for (const auto& entry :
       fs::directory_iterator(std::string(ISOGRASP_SOURCE_DIR) + "/library/tasks"))
    if (entry.path().extension() == ".toml")
      names.insert(test::library_task(entry.path().filename()).name);
  for (std::size_t i = 0; i < kComponentCount; ++i) {
    const auto component = static_cast<Component>(i);
    EXPECT_TRUE(names.contains(std::string(training_for(component))))
        << words_of(component).english();
  }
}

TEST(CompassPoints, OfALeftHandAreTheMirrorImageOfARight) {
  // Seen from the same side a force toward the thumb's side is +x of both hands; along the hand the
  // signs differ (docs/conventions.md).
  EXPECT_EQ(compass_point(Direction::plus_z, Finger::thumb, Hand::left), CompassPoint::closing);
  EXPECT_EQ(compass_point(Direction::minus_z, Finger::index, Hand::right), CompassPoint::opening);
  for (const Finger finger : kFingers) {
    std::set<CompassPoint> right;
    for (std::size_t d = 0; d < kDirectionCount; ++d)
      right.insert(compass_point(static_cast<Direction>(d), finger, Hand::right));
    EXPECT_EQ(right.size(), kCompassPoints) << "each direction has a point of its own";
    EXPECT_NE(compass_point(Direction::plus_y, finger, Hand::left),
              compass_point(Direction::plus_y, finger, Hand::right));
    EXPECT_EQ(compass_point(Direction::plus_y, finger, Hand::left),
              compass_point(Direction::minus_y, finger, Hand::right));
    EXPECT_EQ(compass_point(Direction::plus_x, finger, Hand::left), CompassPoint::radial);
  }
}

TEST(Repetitions, AreTheEffortsThatATaskAsksFor) {
  const auto of = [](const char* file) { return test::library_task(file).repetitions(); };
  EXPECT_EQ(of("resting_force.toml"), 0);
  EXPECT_EQ(of("maximum_grip.toml"), 1);
  EXPECT_EQ(of("directional_maxima.toml"), 18);
  EXPECT_EQ(of("let_go.toml"), 5);
  EXPECT_EQ(of("individuation.toml"), 9);
  EXPECT_EQ(of("two_target.toml"), 5);
  EXPECT_EQ(of("grip_sine.toml"), 6);  // 30 s of 0.2 Hz
}

class Limits : public testing::Test {
 protected:
  void SetUp() override {
    store_ = must(storage::open_store(folder_.path("clinic.db"), storage::OpenMode::scratch));
    patient_ = must(store_->add_patient("TK-1")).id;
    affected(storage::Side::left);
  }
  void affected(std::optional<storage::Side> side) {
    must(store_->set_profile(patient_, {side, {}, "", "", ""}));
  }
  Measure measure(const std::string& name, const std::string& channel, double value,
                  const std::string& unit) {
    Measure one;
    one.name = name;
    one.channel = channel;
    one.value = value;
    one.unit = unit;
    one.version = test::kMadeUpVersion;
    return one;
  }
  void session(const std::string& date, Hand hand,
               const std::vector<std::pair<std::string, std::vector<Measure>>>& trials,
               int seconds = 1) {
    storage::SessionRecord session;
    session.patient_id = patient_;
    session.started_utc = date + "T09:30:00Z";
    session.hand = hand;
    session.device_uri = "can://can0";
    const storage::RowId id = must(store_->begin_session(session));
    must(store_->add_rating({0, id, std::nullopt, 0.0, "", 6, 2}));
    int number = 0;
    for (const auto& [file, measures] : trials) {
      storage::TrialRecord trial;
      trial.session_id = id;
      trial.number = ++number;
      trial.task_text = library_task_text(file);
      trial.task_name = must(tasks::parse_task(trial.task_text, file)).name;
      trial.groups = {{"task", {"t_s", "actual_force_N"}}};
      trial.id = must(store_->begin_trial(trial));
      const std::vector<std::vector<double>> second(1, std::vector<double>(2 * 100, 1.0));
      for (int k = 0; k < seconds; ++k) must(store_->append_blocks(trial.id, k, second));
      trial.status = storage::TrialStatus::completed;
      must(store_->end_trial(trial, measures));
    }
  }
  /// Strength and opening of a hand.
  void maxima(const std::string& date, Hand hand, double grip_N, double opening_N) {
    session(date, hand,
            {{"maximum_grip.toml", {measure("maximum_force", "grip", grip_N, "N")}},
             {"maximum_opening.toml", {measure("maximum_force", "opening", opening_N, "N")}}});
  }
  LimitsOfHand limits(const std::vector<storage::TreatmentMark>& marks = {}) {
    return limits_of(must(read_patient(*store_, "TK-1")), marks);
  }
  static const ComponentResult& of(const LimitsOfHand& limits, Component component) {
    return limits.components.at(static_cast<std::size_t>(component));
  }

  test::TemporaryFolder folder_;
  std::unique_ptr<storage::SessionStore> store_;
  storage::RowId patient_ = 0;
};

TEST_F(Limits, TheComponentFarthestBelowTheOtherHandLimitsMost) {
  maxima("2026-03-02", Hand::right, 30.0, 20.0);
  maxima("2026-03-03", Hand::left, 27.0, 4.0);
  const auto all = limits();
  EXPECT_EQ(all.hand, Hand::left);
  EXPECT_TRUE(all.other_hand);
  ASSERT_NE(main_limit(all), nullptr);
  EXPECT_EQ(main_limit(all)->component, Component::opening);
  EXPECT_WITHIN(main_limit(all)->share->share, 0.2, kRounding);
  EXPECT_EQ(english(main_limit(all)->reference_basis), "right hand, 1 day");
  EXPECT_EQ(of(all, Component::strength).standing, Standing::not_clear);
  EXPECT_EQ(of(all, Component::release).standing, Standing::cannot_be_said);
  EXPECT_EQ(english(of(all, Component::release).reason), "not assessed");
}

TEST_F(Limits, AHandWithoutForceIsBelowAndNothingIsDividedByNothing) {
  maxima("2026-03-02", Hand::right, 30.0, 0.0);
  maxima("2026-03-03", Hand::left, -0.2, -0.1);
  maxima("2026-03-04", Hand::left, 0.4, 0.0);
  const auto all = limits();
  const auto& strength = of(all, Component::strength);
  EXPECT_WITHIN(*strength.value, 0.1, kRounding) << "mean of -0.2 and 0.4";
  EXPECT_EQ(strength.standing, Standing::below);
  EXPECT_WITHIN(strength.share->share, std::sqrt(0.1 * 0.4) / 30.0, kRounding);
  EXPECT_WITHIN(of(all, Component::opening).share->share, 1.0, kRounding);
}

TEST_F(Limits, TheValueThatIsPrintedIsTheMeanOfTheTrialsAndOnlyTheShareHasAFloor) {
  const auto trial = [&](double force_N) {
    return std::pair{std::string("maximum_grip.toml"),
                     std::vector{measure("maximum_force", "grip", force_N, "N")}};
  };
  session("2026-03-02", Hand::right, {trial(30.0)});
  session("2026-03-03", Hand::left, {trial(-3.96), trial(2.58)});
  const auto all = limits();
  const auto& strength = of(all, Component::strength);
  EXPECT_WITHIN(*strength.value, -0.69, kRounding);
  EXPECT_WITHIN(strength.share->share, 0.1 / 30.0, kRounding) << "less cannot be told from none";
}

TEST_F(Limits, BeforeAndAfterATreatmentStandMeansAsTheyAre) {
  maxima("2026-03-02", Hand::left, -2.0, 4.0);
  maxima("2026-03-20", Hand::left, 14.0, 4.0);
  const std::vector<storage::TreatmentMark> marks{{1, "2026-03-10", "botulinum_toxin", ""}};
  const auto text = english(of(limits(marks), Component::strength).treatment);
  EXPECT_NE(text.find("\u22122 before, 14 now"), std::string::npos) << text;
}

TEST_F(Limits, WhatTheHandDidLongAgoIsNotWhatLimitsItNow) {
  maxima("2025-01-02", Hand::right, 30.0, 20.0);
  maxima("2025-01-03", Hand::left, 27.0, 4.0);
  EXPECT_NE(main_limit(limits()), nullptr);
  session("2026-03-02", Hand::left,
          {{"maximum_pinch.toml", {measure("maximum_force", "pinch", 10.0, "N")}}});
  const auto all = limits();
  EXPECT_EQ(english(of(all, Component::opening).reason), "not assessed");
  EXPECT_EQ(of(all, Component::strength).task, "Maximum pinch force");
  maxima("2026-03-03", Hand::left, 27.0, 4.0);
  EXPECT_FALSE(of(limits(), Component::opening).share)
      << "the other hand was measured more than a year ago";
}

TEST_F(Limits, AMeanOverOtherDigitsOrAnotherVersionIsNotComparedWith) {
  const auto openings = [&](const std::string& date, Hand hand, std::vector<Measure> measures) {
    session(date, hand, {{"directional_maxima.toml", std::move(measures)}});
  };
  const Measure thumb = measure("maximum_force", "thumb_opening", 9.0, "N");
  const Measure index = measure("maximum_force", "index_opening", 3.0, "N");
  openings("2026-03-01", Hand::right, {thumb, index});
  openings("2026-03-02", Hand::left, {index});
  EXPECT_FALSE(of(limits(), Component::opening).share);
  openings("2026-03-03", Hand::right, {index});
  EXPECT_WITHIN(of(limits(), Component::opening).share->share, 1.0, kRounding);
  Measure newer = index;
  newer.version = test::kMadeUpVersion + 1;
  openings("2026-03-04", Hand::left, {newer});
  EXPECT_FALSE(of(limits(), Component::opening).share);
}

TEST_F(Limits, AnOverlappingIntervalIsNotToldApart) {
  maxima("2026-03-02", Hand::right, 30.0, 20.0);
  maxima("2026-03-03", Hand::left, 7.0, 4.0);
  const auto all = limits();
  const auto others = beside(all, *main_limit(all));
  ASSERT_EQ(others.size(), 1u);
  EXPECT_EQ(others[0]->component, Component::strength);
}

TEST_F(Limits, WithoutTheOtherHandItIsTheOwnBestAndWithFewDaysNothing) {
  for (const auto& [date, grip_N] :
       {std::pair{"2026-01-02", 20.0}, {"2026-01-05", 10.0}, {"2026-03-02", 6.0}})
    maxima(date, Hand::left, grip_N, 3.0);
  const auto all = limits();
  const auto& strength = of(all, Component::strength);
  EXPECT_WITHIN(*strength.reference, 20.0, kRounding);
  EXPECT_WITHIN(strength.share->share, 0.3, kRounding);
  EXPECT_EQ(english(strength.reference_basis), "own best day, 2\u00a0Jan\u00a02026");
  // A day that was as good but for the last bit is not the best one for it.
  maxima("2026-01-07", Hand::left, std::nextafter(20.0, 99.0), 3.0);
  EXPECT_EQ(english(of(limits(), Component::strength).reference_basis),
            "own best day, 2\u00a0Jan\u00a02026");
  affected(std::nullopt);
  EXPECT_FALSE(limits().other_hand);
  EXPECT_TRUE(of(limits(), Component::strength).share.has_value());
}

TEST_F(Limits, OtherParametersOfTheOtherHandAreNotComparedWith) {
  maxima("2026-03-03", Hand::left, 27.0, 4.0);
  session("2026-03-02", Hand::right,
          {{"maximum_pinch.toml", {measure("maximum_force", "pinch", 30.0, "N")}}});
  const auto all = limits();
  const auto& strength = of(all, Component::strength);
  EXPECT_FALSE(strength.share.has_value());
  EXPECT_EQ(english(strength.reason), "the right hand has not done this task");
}

TEST_F(Limits, TheNewestTreatmentBetweenAssessmentsStandsBeside) {
  maxima("2026-03-02", Hand::left, 10.0, 4.0);
  maxima("2026-03-20", Hand::left, 14.0, 4.0);
  const std::vector<storage::TreatmentMark> marks{{1, "2026-03-10", "botulinum_toxin", ""},
                                                  {2, "2026-03-25", "orthosis", ""}};
  EXPECT_EQ(english(of(limits(marks), Component::strength).treatment),
            "10\u00a0Mar\u00a02026, botulinum toxin: 10 before, 14 now");
}

TEST_F(Limits, AProfileOfTheCompassHoldsForcesRestAndErrorsInTheAxesOfTheHand) {
  session("2026-03-02", Hand::left,
          {{"resting_force.toml", {measure("resting_force", "index_fz", 1.5, "N")}},
           {"directional_maxima.toml",
            {measure("maximum_force", "index", 9.0, "N"),
             measure("maximum_force", "index_opening", 2.0, "N"),
             measure("coflexion", "index_opening", 40.0, "%"),
             measure("maximum_force", "index_+y", 3.0, "N"),
             measure("direction_error", "index_+y", 0.3, "rad")}}});
  const auto all = compasses_of(must(read_patient(*store_, "TK-1")));
  ASSERT_EQ(all.size(), 1u);
  const auto& index = all[0].digits[index_of(Finger::index)];
  const auto at = [](CompassPoint point) { return static_cast<std::size_t>(point); };
  EXPECT_EQ(index.force_N[at(CompassPoint::closing)], 9.0);
  EXPECT_EQ(index.force_N[at(CompassPoint::opening)], 2.0);
  const auto y = at(compass_point(Direction::plus_y, Finger::index, Hand::left));
  EXPECT_EQ(index.force_N[y], 3.0);
  EXPECT_EQ(index.error_rad[y], 0.3);
  EXPECT_EQ(index.coflexion_percent, 40.0);
  EXPECT_EQ(index.resting_N, 1.5);
  EXPECT_EQ(compass_range(all), 10.0);
}

TEST_F(Limits, TheSameDayOfTheNextWeekIsTheNextWeekThoughAnHourEarlier) {
  session("2026-03-02", Hand::left, {{"let_go.toml", {}}});
  storage::SessionRecord early;
  early.patient_id = patient_;
  early.started_utc = "2026-03-09T08:30:00Z";
  early.device_uri = "can://can0";
  must(store_->begin_session(early));
  const auto dose = must(dose_of(*store_, must(read_patient(*store_, "TK-1"))));
  ASSERT_EQ(dose.weeks.size(), 2u);
  EXPECT_EQ(dose.weeks[1].sessions, 1);
}

TEST_F(Limits, TheDoseHasTheMostShoulderPainOfAWeekWhereItWasAsked) {
  storage::SessionRecord bout;
  bout.patient_id = patient_;
  bout.started_utc = "2026-03-09T08:30:00Z";
  bout.device_uri = "leap://127.0.0.1";
  const auto id = must(store_->begin_session(bout));
  for (const int pain : {1, 3, 2})
    must(
        store_->add_rating({0, id, std::nullopt, 60.0 * pain, "2026-03-09T08:31:00Z", 4, 0, pain}));
  bout.started_utc = "2026-03-16T08:30:00Z";
  must(store_->add_rating(
      {0, must(store_->begin_session(bout)), std::nullopt, 60.0, "2026-03-16T08:31:00Z", 4, 0}));
  const auto dose = must(dose_of(*store_, must(read_patient(*store_, "TK-1"))));
  ASSERT_EQ(dose.weeks.size(), 2u);
  EXPECT_EQ(dose.weeks[0].most_shoulder_pain, 3);
  EXPECT_EQ(dose.weeks[1].most_shoulder_pain, std::nullopt);
}

TEST_F(Limits, TheDoseCountsWeeksWithoutGapsMinutesRepetitionsAndPain) {
  session("2026-03-02", Hand::left, {{"let_go.toml", {}}, {"maximum_grip.toml", {}}}, 30);
  session("2026-03-18", Hand::left, {{"let_go.toml", {}}}, 60);
  const auto dose = must(dose_of(*store_, must(read_patient(*store_, "TK-1"))));
  ASSERT_EQ(dose.weeks.size(), 3u);
  EXPECT_EQ(dose.weeks[0].repetitions, 6);
  EXPECT_DOUBLE_EQ(dose.weeks[0].active_s, 60.0);
  EXPECT_EQ(dose.weeks[0].most_pain, 2);
  EXPECT_EQ(dose.weeks[1].sessions, 0);
  EXPECT_FALSE(dose.weeks[1].most_pain.has_value());
  EXPECT_DOUBLE_EQ(dose.weeks[2].active_s, 60.0);
  EXPECT_EQ(dose.days, 2);
  EXPECT_EQ(dose.repetitions, 11);
}

}  // namespace
}  // namespace isograsp::reports::limits_test
