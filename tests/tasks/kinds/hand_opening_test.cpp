// SPDX-License-Identifier: GPL-3.0-or-later
// Opening and closing: what counts as an opening, and what a tracker's bad moments must not do.
#include "tasks/kinds/hand/hand_opening.hpp"

#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "hand/hand_columns.hpp"
#include "tasks/score.hpp"
#include "tests/support/every.hpp"
#include "tests/support/must.hpp"
#include "tests/support/no_alloc.hpp"
#include "tests/support/within.hpp"
#include "tests/tasks/specs.hpp"

namespace isograsp::tasks::hand_opening_test {
namespace {

constexpr double kStep_s = 0.01;
constexpr double kClosed_m = 0.02;
constexpr double kOpen_m = 0.10;

struct Frame {
  double gap_m = kClosed_m;
  double flexion_rad = 0.5;  ///< of each joint of each digit
  double flags = 0.0;
};
/// A frame at a time since the cue.
using Script = std::function<Frame(int repetition, bool opens, double since_s)>;

/// Opens and closes in half a second each, half a second after the cue.
Frame usual(int, bool opens, double since_s) {
  const double share = std::clamp((since_s - 0.5) / 0.5, 0.0, 1.0);
  const double open = opens ? share : 1.0 - share;
  return {kClosed_m + open * (kOpen_m - kClosed_m), 1.0 - 0.8 * open, 0.0};
}

/// A whole trial, by the task's own cues.
Signals played(const HandOpeningSpec& spec, const Script& script) {
  std::vector<std::string> names{columns::t_s,     columns::phase, columns::sample_flags,
                                 columns::segment, columns::cue,   columns::thumb_index_gap_m};
  for (const auto& digit : columns::flexion)
    for (const Column& joint : digit) names.emplace_back(joint);
  Signals signals(names);
  auto task = test::must(make_task(test::spec_of(spec), {}));
  double cue_s = 0.0;
  int segment = 0;
  for (int k = 0;; ++k) {
    const double t_s = k * kStep_s;
    const TaskView view = task->step(HandInput{});
    if (view.segment != segment) cue_s = t_s;
    segment = view.segment;
    const Frame frame = view.phase == Phase::active
                            ? script(view.target_index, view.cue == Cue::open, t_s - cue_s)
                            : Frame{};
    std::vector<double> row{t_s,
                            static_cast<double>(view.phase),
                            frame.flags,
                            static_cast<double>(view.segment),
                            static_cast<double>(view.cue),
                            frame.gap_m};
    for (std::size_t n = 0; n < 3 * kDigitCount; ++n) row.push_back(frame.flexion_rad);
    signals.append_row(row);
    if (view.phase == Phase::done) return signals;
  }
}

class Scored {
 public:
  Scored(const HandOpeningSpec& spec, const Script& script)
      : measures_(score(test::spec_of(spec), played(spec, script))) {}
  [[nodiscard]] const Measure& at(std::string_view name, std::string_view channel = "") const {
    for (const Measure& one : measures_)
      if (one.name == name && (channel.empty() || one.channel == channel)) return one;
    throw std::runtime_error("no measure " + std::string(name));
  }
  [[nodiscard]] double value(std::string_view name, std::string_view channel = "") const {
    return at(name, channel).value.value();
  }

 private:
  std::vector<Measure> measures_;
};

TEST(HandOpening, FiveOpeningsHaveTheirGapTheirTimesAndTheRangeOfEachDigit) {
  const HandOpeningSpec spec;
  const Scored scored(spec, usual);
  constexpr double kExact = 1e-9;
  EXPECT_WITHIN(scored.value("largest_gap"), kOpen_m, kExact);
  EXPECT_EQ(scored.value("hand_openings"), 5.0);
  EXPECT_EQ(scored.at("hand_openings").unit, "of 5");
  EXPECT_EQ(scored.value("hand_closings"), 5.0);
  // 90 % of the way: half a second of waiting and nine tenths of the movement, one row at most
  // later.
  EXPECT_NEAR(scored.value("hand_opening_time"), 0.95, 1.01 * kStep_s);
  EXPECT_NEAR(scored.value("hand_closing_time"), 0.95, 1.01 * kStep_s);
  EXPECT_EQ(scored.value("hand_opening_time_share"), 100.0);
  for (const std::string_view digit : kDigitNames)
    EXPECT_NEAR(scored.value("flexion_range", digit), 3 * 0.8, 1e-6) << digit;
}

TEST(HandOpening, OneWrongFrameIsNoOpening) {
  const HandOpeningSpec spec;
  const Script still = [](int, bool, double since_s) {
    Frame frame;
    if (std::abs(since_s - 2.0) < 0.5 * kStep_s) frame.gap_m = 0.2;
    return frame;
  };
  const Scored scored(spec, still);
  EXPECT_EQ(scored.value("largest_gap"), kClosed_m);
  EXPECT_EQ(scored.value("hand_openings"), 0.0);
}

TEST(HandOpening, AHandThatDoesNotOpenIsLongerThanTheLimitAndNoMeanOfTheOthers) {
  const HandOpeningSpec spec;
  const Script some = [](int repetition, bool opens, double since_s) {
    return repetition < 3 ? Frame{} : usual(repetition, opens, since_s);
  };
  const Scored scored(spec, some);
  EXPECT_EQ(scored.value("hand_openings"), 2.0);
  EXPECT_FALSE(scored.at("hand_opening_time").value) << "more than half did not open";
  EXPECT_EQ(scored.value("hand_opening_time_share"), 40.0);
  EXPECT_NEAR(scored.value("hand_opening_time_restricted"), (3 * spec.open_s + 2 * 0.95) / 5, 0.01);
}

TEST(HandOpening, HeldRowsAreLeftOutAndCounted) {
  const HandOpeningSpec spec;
  const Script held = [](int repetition, bool opens, double since_s) {
    Frame frame = usual(repetition, opens, since_s);
    if (since_s > 2.0 && since_s < 2.1) frame = {0.3, 3.0, 1.0};  // what stands in counts nowhere
    return frame;
  };
  const Scored scored(spec, held);
  EXPECT_WITHIN(scored.value("largest_gap"), kOpen_m, 1e-9);
  EXPECT_GT(scored.at("largest_gap").excluded, 0);
  EXPECT_NEAR(scored.value("flexion_range", "index"), 3 * 0.8, 1e-6);
}

TEST(HandOpening, AHandThatWasNeverSeenHasNoGapAndAReason) {
  const HandOpeningSpec spec;
  const Scored scored(spec, [](int, bool, double) { return Frame{0.1, 0.5, 2.0}; });
  EXPECT_FALSE(scored.at("largest_gap").value);
  EXPECT_FALSE(scored.at("largest_gap").reason.empty());
}

TEST(HandOpening, AStepTakesNoMemory) {
  auto task = test::must(make_task(test::spec_of(HandOpeningSpec{}), {}));
  const auto before = test::allocations();
  for (int k = 0; k < 5000; ++k) static_cast<void>(task->step(HandInput{}));
  EXPECT_EQ(test::allocations(), before);
}

TEST(HandOpening, AllItMeasuresIsOfResearch) {
  EXPECT_TRUE(HandOpeningSpec::kFacts.research);
  EXPECT_TRUE(HandOpeningSpec::kFacts.places.empty());
}

}  // namespace
}  // namespace isograsp::tasks::hand_opening_test
