// SPDX-License-Identifier: GPL-3.0-or-later
// Every measure that a task can give is called by words, and research stays out of the report.
#include "reports/measure_words.hpp"

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include "core/signals.hpp"
#include "tasks/score.hpp"
#include "tasks/task.hpp"

namespace isograsp {
namespace {

template <class Kind>
TaskSpec spec_of(Kind kind) {
  TaskSpec spec;
  spec.kind = std::move(kind);
  return spec;
}

std::vector<TaskSpec> force_tasks() {
  MaximumSpec opening;
  opening.channel.direction = Direction::minus_z;
  MaximumSpec comfortable;
  comfortable.comfortable = true;
  ForceTrackingSpec trapezoid;
  trapezoid.waveform.shape = Waveform::Shape::trapezoid;
  ForceTrackingSpec several_sines;
  several_sines.waveform.shape = Waveform::Shape::multi_sine;
  several_sines.waveform.frequencies = {0.1, 0.3};
  GripReleaseSpec open;
  open.open = true;
  ForceDirectionSpec direction;
  direction.targets.resize(1);
  direction.targets[0].asked.fill(true);
  direction.targets[0].direction_C.fill(Vec3::UnitX());
  return {spec_of(RestSpec{}),
          spec_of(MaximumSpec{}),
          spec_of(opening),
          spec_of(comfortable),
          spec_of(DirectionalMaximaSpec{{Finger::thumb, Finger::index},
                                        {Direction::plus_x, Direction::minus_z}}),
          spec_of(ForceTrackingSpec{}),
          spec_of(trapezoid),
          spec_of(several_sines),
          spec_of(SteadinessSpec{}),
          spec_of(StepResponseSpec{}),
          spec_of(GripReleaseSpec{}),
          spec_of(open),
          spec_of(ForceSenseSpec{}),
          spec_of(FatigueSpec{}),
          spec_of(IndividuationSpec{}),
          spec_of(direction)};
}
std::vector<TaskSpec> object_tasks() {
  PoseTargetsSpec targets;
  targets.targets.resize(2);
  PoseTrackingSpec tracking;
  tracking.axes.resize(1);
  PickPlaceSpec pick_place;
  pick_place.items.resize(1);
  return {spec_of(targets), spec_of(tracking), spec_of(pick_place), spec_of(ObserveSpec{})};
}

std::vector<TaskSpec> recorded_tasks() {
  using Measures = RecordedSpec::Measures;
  std::vector<TaskSpec> tasks;
  for (const Measures measures :
       {Measures::corridor, Measures::maximum, Measures::tracking, Measures::finger_forces}) {
    RecordedSpec recorded;
    recorded.measures = measures;
    recorded.fingers = {"index", "ring"};
    tasks.push_back(spec_of(recorded));
  }
  return tasks;
}

/// A trial of a force task in which the hand lies still, with every column that tells its parts.
Signals still_hand(const TaskSpec& spec) {
  TaskContext context;
  context.period_s = 0.05;
  for (const Digits digits : {Digits::grip, Digits::thumb, Digits::index, Digits::middle})
    context.references.maximum_N[{digits, Direction::plus_z}] = 40.0;
  std::vector<std::string> names{"t_s",
                                 "phase",
                                 "segment",
                                 "cue",
                                 "channel_digits",
                                 "channel_direction",
                                 "target_force_N",
                                 "actual_force_N",
                                 "net_fx_N",
                                 "net_fy_N",
                                 "net_fz_N"};
  for (const Finger finger : kFingers)
    for (const char* axis : {"_fx_N", "_fy_N", "_fz_N"}) {
      names.push_back(std::string(name_of(finger)) + axis);
      names.push_back("target_" + std::string(name_of(finger)) + axis);
    }
  Signals signals(names);
  auto task = make_task(spec, context);
  if (!task) {
    ADD_FAILURE() << task.error().message();
    return signals;
  }
  for (int k = 0;; ++k) {
    const TaskView view = (*task)->step({});
    if (view.phase == Phase::done) return signals;
    std::vector<double> row{k * context.period_s,
                            static_cast<double>(view.phase),
                            static_cast<double>(view.segment),
                            static_cast<double>(view.cue),
                            static_cast<double>(view.channel.digits),
                            static_cast<double>(view.channel.direction),
                            view.has_force_target ? view.target_force_N : kNotMeasured,
                            view.actual_force_N,
                            0.0,
                            0.0,
                            0.0};
    for (const Finger finger : kFingers)
      for (const int axis : {0, 1, 2}) {
        const auto f = index_of(finger);
        row.push_back(0.0);
        row.push_back(view.digit_targets.shown[f] ? view.digit_targets.force_C[f][axis]
                                                  : kNotMeasured);
      }
    signals.append_row(row);
  }
}

struct Emitted {
  TaskSpec spec;
  std::vector<Measure> measures;
};
const std::vector<Emitted>& emitted() {
  static const std::vector<Emitted> all = [] {
    std::vector<Emitted> list;
    for (const TaskSpec& spec : force_tasks())
      list.push_back({spec, score(spec, still_hand(spec))});
    for (const TaskSpec& spec : recorded_tasks())
      list.push_back({spec, score(spec, Signals({"t_s"}))});
    for (const TaskSpec& spec : object_tasks())
      list.push_back({spec, score(spec, Signals({"t_s", "phase"}))});
    return list;
  }();
  return all;
}

/// Words made of nothing but the name.
std::string own_name(std::string name) {
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

TEST(MeasureWords, EveryMeasureOfEveryKindOfTaskHasWords) {
  std::set<std::size_t> kinds;
  std::set<std::string> names;
  for (const Emitted& task : emitted()) {
    kinds.insert(task.spec.kind.index());
    for (const Measure& measure : task.measures) {
      names.insert(measure.name);
      EXPECT_NE(words_for(measure.name, "").title, own_name(measure.name))
          << "kind " << task.spec.kind.index();
    }
  }
  EXPECT_EQ(kinds.size(), std::variant_size_v<decltype(TaskSpec::kind)>);
  for (const char* name :
       {"release_time_share", "power_2_8_Hz", "enslaving", "coflexion", "pauses", "direction_error",
        "early_rate", "opening_force", "endurance", "throughput", "median_completion_time"})
    EXPECT_TRUE(names.contains(name)) << name << " was not emitted, so nothing was proved of it";
}

TEST(MeasureWords, EveryMeasureWithoutATaskHasWords) {
  const auto measures =
      score_pairs(Signals({"t_s", "target_force_N", "actual_force_N", "actual_x_m", "actual_y_m"}));
  ASSERT_FALSE(measures.empty());
  for (const Measure& measure : measures)
    EXPECT_NE(words_for(measure.name, "").title, own_name(measure.name));
}

TEST(MeasureWords, NoTwoMeasuresOfATaskHaveTheSameTitle) {
  for (const Emitted& task : emitted()) {
    std::set<std::string> titles;
    for (const Measure& measure : task.measures) {
      const std::string title = words_for(measure.name, measure.channel).title;
      EXPECT_TRUE(titles.insert(title).second)
          << title << ", kind " << task.spec.kind.index() << ", channel " << measure.channel;
    }
  }
}

TEST(MeasureWords, NoResearchMeasureHasAPlaceInTheReport) {
  for (const Emitted& task : emitted())
    for (const Measure& measure : task.measures) {
      const Place place = place_of(task.spec, measure.name, measure.channel);
      EXPECT_TRUE(place.prominence == Prominence::none ||
                  words_for(measure.name, measure.channel).clinical)
          << measure.name;
    }
  for (const char* name : {"sample_entropy", "power_0.1_0.3_Hz", "throughput", "ldlj", "t63"})
    EXPECT_FALSE(words_for(name, "").clinical) << name;
  EXPECT_FALSE(words_for("a_measure_of_tomorrow", "").clinical);
}

TEST(MeasureWords, EveryForceTaskThatIsScoredShowsATrend) {
  for (const Emitted& task : emitted()) {
    if (task.measures.empty()) continue;
    bool shown = false;
    for (const Measure& measure : task.measures)
      shown = shown ||
              place_of(task.spec, measure.name, measure.channel).prominence != Prominence::none;
    EXPECT_TRUE(shown) << "kind " << task.spec.kind.index();
  }
}

TEST(MeasureWords, TimesThatMayBeLongerThanTheLimitAreCensored) {
  for (const char* name : {"reaction_time", "settling_time", "release_time", "endurance",
                           "release_initiation", "completion_time"})
    EXPECT_TRUE(words_for(name, "").censored) << name;
  // These have a value whatever happens: nothing is hidden in them.
  for (const char* name : {"release_time_share", "release_time_restricted", "residual_force"})
    EXPECT_FALSE(words_for(name, "").censored) << name;
}

TEST(MeasureWords, ReleasesCompletedAreReadBeforeTheirTime) {
  const TaskSpec spec = spec_of(GripReleaseSpec{});
  const Place share = place_of(spec, "release_time_share", "grip");
  const Place time = place_of(spec, "release_time", "grip");
  EXPECT_EQ(share.prominence, Prominence::key);
  EXPECT_EQ(time.prominence, Prominence::key);
  EXPECT_LT(share.rank, time.rank);
}

TEST(MeasureWords, ATitleSaysTheChannel) {
  const auto title = [](const char* name, const char* channel) {
    return words_for(name, channel).title;
  };
  EXPECT_EQ(title("maximum_force", "grip"), "Maximum grip above rest");
  EXPECT_EQ(title("maximum_force", "thumb"), "Maximum force above rest, thumb");
  EXPECT_EQ(title("maximum_force", "pinch"), "Maximum force above rest, thumb and index");
  EXPECT_EQ(title("maximum_force", "opening"), "Maximum force above rest, opening");
  EXPECT_EQ(title("maximum_force", "index_opening"), "Maximum force above rest, index opening");
  EXPECT_EQ(title("maximum_force", "thumb_-x"), "Maximum force above rest, thumb toward -x");
  EXPECT_EQ(title("opening_force", "opening"), "Opening force");
  EXPECT_EQ(title("cv", "force_25_percent"), "Unsteadiness (CV) at 25 %");
  EXPECT_EQ(title("cv", "force_2.5_N"), "Unsteadiness (CV) at 2.5 N");
  EXPECT_EQ(title("gain", "force_0.2_Hz"), "Gain at 0.2 Hz");
  EXPECT_EQ(title("gain", "force"), "Gain");
  EXPECT_EQ(title("rmse", "force_fall"), "Tracking error (RMS), letting down");
  EXPECT_EQ(title("enslaving", "thumb_to_index"),
            "Force of a digit that was not asked, index while thumb presses");
  EXPECT_EQ(title("completion_time", "target_5"), "Time to reach target 5");
  EXPECT_EQ(title("resting_force", "thumb_fz"), "Resting force, thumb fz");
  EXPECT_EQ(title("rmse", "x"), "Tracking error (RMS), x");
  EXPECT_EQ(title("rmse", "rz"), "Tracking error (RMS), turn about z");
}

}  // namespace
}  // namespace isograsp
