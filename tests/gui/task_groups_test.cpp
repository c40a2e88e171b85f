// SPDX-License-Identifier: GPL-3.0-or-later
// The list of tasks: what counts as the maximum, and that people find a task among many.
#include "gui/library/task_groups.hpp"

#include <gtest/gtest.h>

namespace isograsp::task_groups_test {
namespace {

template <class Kind>
TaskSpec named(const char* name, const Kind& kind) {
  TaskSpec spec;
  spec.name = name;
  spec.kind = kind;
  return spec;
}

TEST(TaskGroups, OnlyTheMaximumOfTheWholeGripIsTheMaximumOfTheSession) {
  MaximumSpec maximum;
  EXPECT_EQ(kind_of(named("grip", maximum)), TaskKind::maximum);
  maximum.comfortable = true;
  EXPECT_EQ(kind_of(named("comfortable", maximum)), TaskKind::other);
  maximum.comfortable = false;
  for (const ForceChannel channel :
       {ForceChannel{Digits::grip, Direction::minus_z}, ForceChannel{Digits::index},
        ForceChannel{Digits::grip_mean}, ForceChannel{Digits::thumb, Direction::plus_x}}) {
    maximum.channel = channel;
    EXPECT_EQ(kind_of(named("one", maximum)), TaskKind::other) << name_of(channel);
  }
}

TEST(TaskGroups, KindsBeyondTheFlowAreOthersWhateverTheirPlaceInTheFileFormat) {
  EXPECT_EQ(kind_of(named("rest", RestSpec{})), TaskKind::rest);
  EXPECT_EQ(kind_of(named("track", ForceTrackingSpec{})), TaskKind::force_tracking);
  EXPECT_EQ(kind_of(named("targets", PoseTargetsSpec{})), TaskKind::pose_targets);
  EXPECT_EQ(kind_of(named("free", ObserveSpec{})), TaskKind::observe);
  EXPECT_EQ(kind_of(named("maxima", DirectionalMaximaSpec{})), TaskKind::other);
  EXPECT_EQ(kind_of(named("pick", PickPlaceSpec{})), TaskKind::other);
}

TEST(TaskGroups, TheListStartsWithRestAndTheGripAndSortsNumbersAsNumbers) {
  MaximumSpec opening;
  opening.channel.direction = Direction::minus_z;
  std::vector<TaskSpec> tasks{
      named("Two targets", PoseTargetsSpec{}), named("hold 25 %", SteadinessSpec{}),
      named("Hold 5 %", SteadinessSpec{}),     named("Fingers one by one", IndividuationSpec{}),
      named("A maximum, opening", opening),    named("Maximum grip", MaximumSpec{}),
      named("Sine", ForceTrackingSpec{}),      named("Resting force", RestSpec{})};
  sort_for_list(tasks);
  std::vector<std::string> names;
  for (const auto& task : tasks) names.push_back(task.name);
  EXPECT_EQ(names, (std::vector<std::string>{"Resting force", "Maximum grip", "A maximum, opening",
                                             "Sine", "Hold 5 %", "hold 25 %", "Fingers one by one",
                                             "Two targets"}));
}

TEST(TaskGroups, EveryGroupStandsTogetherUnderItsOwnHeading) {
  std::vector<TaskSpec> tasks;
  for (const char* name : {"b", "a", "c"}) {
    tasks.push_back(named(name, PickPlaceSpec{}));
    tasks.push_back(named(name, FatigueSpec{}));
    tasks.push_back(named(name, StepResponseSpec{}));
  }
  sort_for_list(tasks);
  int headings = 1;
  for (std::size_t i = 1; i < tasks.size(); ++i)
    headings += title_of(group_of(tasks[i])) != title_of(group_of(tasks[i - 1])) ? 1 : 0;
  EXPECT_EQ(headings, 3);
}

}  // namespace
}  // namespace isograsp::task_groups_test
