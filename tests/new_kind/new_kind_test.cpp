// SPDX-License-Identifier: GPL-3.0-or-later
// Adding a kind of task takes new files and one row of the table: pulses.patch does it, and this
// program is built with what it makes (see CMakeLists.txt). The contract of all kinds, compiled
// into it too, then holds for the new kind unasked.
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/csv.hpp"
#include "tasks/facts/measure_words.hpp"
#include "tasks/kinds/force/pulses.hpp"
#include "tasks/score.hpp"
#include "tests/support/patch_changes.hpp"
#include "tests/support/within.hpp"
#include "tests/tasks/kinds/force_play.hpp"

namespace isograsp::tasks::new_kind_test {
namespace {

TEST(NewKind, IsNewFilesAndOneRow) {
  test::expect_new_files_and_one_row(
      {ISOGRASP_SOURCE_DIR "/tests/new_kind/pulses.patch",
       "tasks/kinds/kinds.cpp",
       {"#include \"tasks/kinds/force/pulses.hpp\"", "    &PulsesSpec::kFacts,"},
       "tasks/CMakeLists.txt",
       3},  // spec, facts, and a task of the library
      ISOGRASP_PATCHED_TREE);
}

Result<TaskSpec> pulses(const std::string& keys) {
  return parse_task(
      "format = \"isograsp-task-1\"\nname = \"x\"\ninstruction = \"x\"\nkind = \"pulses\"\n" + keys,
      "x.toml");
}

TEST(NewKind, HasItsOwnKeys) {
  const auto spec = pulses("press_s = 0.5\nrepetitions = 3\n");
  ASSERT_TRUE(spec) << spec.error().message();
  EXPECT_EQ(&*spec->kind, &PulsesSpec::kFacts);
  EXPECT_EQ(spec->kind.as<PulsesSpec>().press_s, 0.5);
  EXPECT_EQ(spec->repetitions(), 3);
  EXPECT_WITHIN(spec->duration().worst_s, 4.5, 1e-9);
  EXPECT_TRUE(spec->needs_maximum());
  EXPECT_FALSE(pulses("press_s = 0\n"));
  EXPECT_FALSE(pulses("hold_s = 2\n")) << "a key of another kind";
  const auto unknown = parse_task(
      "format = \"isograsp-task-1\"\nname = \"x\"\ninstruction = \"x\"\nkind = \"jumps\"\n",
      "x.toml");
  ASSERT_FALSE(unknown);
  EXPECT_NE(unknown.error().message().find("pulses"), std::string::npos) << "the table is told";
}

TEST(NewKind, BecomesHarderAsItsSpecSays) {
  const auto spec = pulses(
      "[difficulty]\nfactor = \"level\"\neasiest = 0.5\nhardest = 2\nsuccess_measure = \"rmse\"\n"
      "success_at_least = 0\n");
  ASSERT_TRUE(spec) << spec.error().message();
  const auto hard = at_level(*spec, 1.0);
  ASSERT_TRUE(hard) << hard.error().message();
  EXPECT_DOUBLE_EQ(hard->largest_level(), 0.4);
}

TEST(NewKind, RunsAndIsScored) {
  const auto spec = pulses("");
  ASSERT_TRUE(spec) << spec.error().message();
  constexpr double kTooMuch_N = 1.0;
  const auto signals = test::play_force(*spec, [](const TaskView& view, double) {
    return test::grip_of(view.force().has_force_target ? view.force().target_force_N + kTooMuch_N
                                                       : 0.0);
  });
  const auto measures = score(*spec, signals);
  ASSERT_EQ(measures.size(), 2U);
  EXPECT_EQ(measures[0].name, "rmse");
  EXPECT_WITHIN(measures[0].value.value(), kTooMuch_N, 1e-9);
  const Place place = place_of(*spec, "rmse", "grip");
  EXPECT_EQ(place.prominence, Prominence::key);
}

}  // namespace
}  // namespace isograsp::tasks::new_kind_test
