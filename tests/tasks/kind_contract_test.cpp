// SPDX-License-Identifier: GPL-3.0-or-later
// What holds for every kind of task. The kinds are taken from the table, their tasks from the
// library: a new kind is held to it unasked.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/csv.hpp"
#include "hand/arm_columns.hpp"
#include "hand/hand_columns.hpp"
#include "tasks/facts/measure_words.hpp"
#include "tasks/score.hpp"
#include "tasks/task.hpp"
#include "tasks/waveform.hpp"
#include "tests/support/every.hpp"
#include "tests/tasks/kinds/hands_play.hpp"
#include "tests/tasks/reference_subject.hpp"

namespace isograsp::tasks::kind_contract_test {
namespace {

namespace fs = std::filesystem;

#ifdef ISOGRASP_PATCHED_TREE
const std::vector<std::string> kLibraries{ISOGRASP_SOURCE_DIR "/library",
                                          ISOGRASP_PATCHED_TREE "/library"};
#else
const std::vector<std::string> kLibraries{ISOGRASP_SOURCE_DIR "/library"};
#endif

bool is_live(const KindFacts& kind) {
  return kind.make != nullptr || kind.segments != nullptr;
}

/// Those whose points stand in a file of their own are left out: each kind has others.
std::vector<TaskSpec> shipped_tasks() {
  std::vector<TaskSpec> tasks;
  for (const std::string& library : kLibraries)
    for (const auto& entry : fs::directory_iterator(library + "/tasks")) {
      if (entry.path().extension() != ".toml") continue;
      const auto text = read_text(entry.path());
      if (!text) throw std::runtime_error(text.error().message());
      auto spec = parse_task(*text, entry.path());
      if (!spec) throw std::runtime_error(spec.error().message());
      if (const Waveform* wave = spec->waveform(); wave != nullptr && !wave->csv.empty()) continue;
      tasks.push_back(*std::move(spec));
    }
  return tasks;
}

/// Of a hand of which everything is known.
TaskContext known_hand() {
  TaskContext context;
  context.period_s = 0.02;
  context.references.resting_C.emplace();
  for (Wrench& wrench : *context.references.resting_C) wrench.force = wrench.torque = Vec3::Zero();
  for (int digits = 0; digits <= static_cast<int>(Digits::middle); ++digits)
    for (int direction = 0; direction < static_cast<int>(kDirectionCount); ++direction)
      for (auto* known : {&context.references.maximum_N, &context.references.comfortable_N,
                          &context.references.baseline_N})
        (*known)[{static_cast<Digits>(digits), static_cast<Direction>(direction)}] = 40.0;
  return context;
}

TEST(KindContract, EveryKindHasItsOwnNameAndPlace) {
  std::set<std::string_view> names;
  for (std::size_t i = 0; i < all_kinds().size(); ++i) {
    const KindFacts& kind = *all_kinds()[i];
    EXPECT_TRUE(names.insert(kind.name).second) << kind.name;
    EXPECT_EQ(order_of(kind), i);
    EXPECT_TRUE(kind.read != nullptr && kind.measures != nullptr) << kind.name;
    EXPECT_FALSE(kind.make != nullptr && kind.segments != nullptr) << kind.name << " runs twice";
    EXPECT_TRUE(kind.duration != nullptr || kind.segments != nullptr) << kind.name;
    EXPECT_EQ(kind.places.empty(), kind.research) << kind.name << ": in a patient's report";
  }
}

TEST(KindContract, EveryKindThatRunsHasATaskInTheLibrary) {
  std::set<std::string_view> shipped;
  for (const TaskSpec& spec : shipped_tasks()) shipped.insert(spec.kind->name);
  for (const KindFacts* kind : test::every(all_kinds()))
    EXPECT_EQ(shipped.contains(kind->name), is_live(*kind)) << kind->name;
}

/// A trial in which the hand lies still, to its end: not longer than the task tells.
Signals still_hand(const TaskSpec& spec) {
  const TaskContext context = known_hand();
  ObjectInput input;
  for (Wrench& wrench : input.wrench_C) wrench.force = wrench.torque = Vec3::Zero();
  Signals signals({"t_s", "phase", "segment", "cue", "channel_digits", "channel_direction",
                   "target_force_N", "actual_force_N"});
  auto task = make_task(spec, context);
  if (!task) throw std::runtime_error(task.error().message());
  constexpr double kRounding_s = 5.0;  // each of many parts ends with a whole frame
  const double most_s = spec.duration().worst_s + kRounding_s;
  for (int frame = 0; frame * context.period_s <= most_s; ++frame) {
    const TaskView view = (*task)->step(input);
    const std::vector<double> row{
        frame * context.period_s,
        static_cast<double>(view.phase),
        static_cast<double>(view.segment),
        static_cast<double>(view.cue),
        static_cast<double>(view.force().channel.digits),
        static_cast<double>(view.force().channel.direction),
        view.force().has_force_target ? view.force().target_force_N : std::nan(""),
        view.force().actual_force_N};
    signals.append_row(row);
    if (view.phase == Phase::done) return signals;
  }
  ADD_FAILURE() << spec.file << " does not end in " << most_s << " s";
  return signals;
}

/// A trial in which the arm stays in the initial posture and its object is seen.
Signals still_arm(const TaskSpec& spec) {
  TaskContext context = known_hand();
  if (spec.kind->postures != nullptr) context.arm = test::reference_subject(spec);
  const Pose here = context.arm ? test::initial_pose(*context.arm) : Pose{};
  const columns::OfSegment& object = columns::segment_pose[index_of(ArmSegment::object)];
  std::vector<std::string> names{columns::t_s, columns::phase, columns::target_index};
  for (const auto& axes : {object.position, columns::reference_position})
    for (const Column& column : axes) names.emplace_back(column);
  for (const auto& parts : {object.attitude, columns::reference_attitude})
    for (const Column& column : parts) names.emplace_back(column);
  Signals signals(names);
  auto task = make_task(spec, context);
  if (!task) throw std::runtime_error(task.error().message());
  constexpr double kRounding_s = 1.0;
  const double most_s = spec.duration().worst_s + kRounding_s;
  for (int frame = 0; frame * context.period_s <= most_s; ++frame) {
    const double t_s = frame * context.period_s;
    const TaskView view = (*task)->step(ArmInput{t_s, here});
    const ArmView& arm = view.arm();
    const Pose& shown = arm.reference_shown ? arm.X_WR : missing_pose();
    std::vector<double> row{t_s, static_cast<double>(view.phase),
                            static_cast<double>(view.target_index)};
    for (const Pose* pose : {&here, &shown})
      row.insert(row.end(), {pose->p.x(), pose->p.y(), pose->p.z()});
    for (const Pose* pose : {&here, &shown})
      row.insert(row.end(), {pose->q.w(), pose->q.x(), pose->q.y(), pose->q.z()});
    signals.append_row(row);
    if (view.phase == Phase::done) return signals;
  }
  ADD_FAILURE() << spec.file << " does not end in " << most_s << " s";
  return signals;
}

/// A trial in which a tracked hand is seen and does nothing.
Signals still_tracked_hand(const TaskSpec& spec) {
  TaskContext context = known_hand();
  auto task = make_task(spec, context);
  if (!task) throw std::runtime_error(task.error().message());
  HandInput input;
  input.seen = true;
  input.thumb_index_gap_m = 0.03;
  input.X_WO = Pose{};
  Signals signals({"t_s", "phase", "segment", "cue", "sample_flags", "placement",
                   std::string(columns::thumb_index_gap_m)});
  constexpr double kRounding_s = 5.0;
  const double most_s = spec.duration().worst_s + kRounding_s;
  for (int frame = 0; frame * context.period_s <= most_s; ++frame) {
    ++input.frames;
    const TaskView view = (*task)->step(input);
    signals.append_row(
        std::vector<double>{frame * context.period_s, static_cast<double>(view.phase),
                            static_cast<double>(view.segment), static_cast<double>(view.cue), 0.0,
                            static_cast<double>(view.hand().placement), input.thumb_index_gap_m});
    if (view.phase == Phase::done) return signals;
  }
  ADD_FAILURE() << spec.file << " does not end in " << most_s << " s";
  return signals;
}

/// A trial in which both hands lie still on their platforms.
Signals still_hands(const TaskSpec& spec) {
  constexpr double kPeriod_s = 0.02;
  constexpr double kRounding_s = 5.0;
  const Signals signals = test::play_hands(spec, test::known_hands(kPeriod_s));
  EXPECT_LE(signals.column(columns::t_s).back(), spec.duration().worst_s + kRounding_s)
      << spec.file;
  return signals;
}

TEST(KindContract, ATaskEndsWithinTheTimeThatItTellsAndHasMeasures) {
  int scored = 0;
  for (const TaskSpec& spec : test::every(shipped_tasks())) {
    const Duration duration = spec.duration();
    EXPECT_GT(duration.nominal_s, 0.0) << spec.file;
    EXPECT_LE(duration.nominal_s, duration.worst_s) << spec.file;
    const auto measures =
        score(spec, spec.apparatus() == "arm"             ? still_arm(spec)
                    : spec.apparatus() == "tracked_hand"  ? still_tracked_hand(spec)
                    : spec.apparatus() == "two_platforms" ? still_hands(spec)
                                                          : still_hand(spec));
    EXPECT_FALSE(measures.empty()) << spec.file;
    for (const Measure& measure : measures)
      EXPECT_TRUE(measure.value || !measure.reason.empty()) << spec.file << ": " << measure.name;
    ++scored;
  }
  EXPECT_GT(scored, 15) << "the library was not found";
}

TEST(KindContract, ATaskIsCopiedWithItsKind) {
  for (const TaskSpec& spec : test::every(shipped_tasks())) {
    const TaskSpec copy = spec;
    EXPECT_EQ(&*copy.kind, &*spec.kind);
    EXPECT_EQ(copy.duration().worst_s, spec.duration().worst_s) << spec.file;
    EXPECT_EQ(copy.scene(), spec.scene()) << spec.file;
  }
}

TEST(KindContract, WhatTheReportShowsHasWords) {
  test::AtLeast placed_measures(1);
  for (const KindFacts* kind : test::every(all_kinds()))
    for (const PlacedMeasure& placed : kind->places) {
      const auto known = worded_measures();
      EXPECT_NE(std::find(known.begin(), known.end(), placed.name), known.end())
          << kind->name << ": " << placed.name;
      EXPECT_NE(placed.prominence, Prominence::none) << kind->name << ": " << placed.name;
      ++placed_measures;
    }
}

}  // namespace
}  // namespace isograsp::tasks::kind_contract_test
