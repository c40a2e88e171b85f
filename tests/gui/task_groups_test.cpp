// SPDX-License-Identifier: GPL-3.0-or-later
// The list of tasks: what counts as the maximum, and that people find a task among many.
#include "gui/library/task_groups.hpp"

#include <gtest/gtest.h>

namespace isograsp::gui::task_groups_test {
namespace {

template <class Kind>
tasks::TaskSpec named(const char* name, const Kind& kind) {
  tasks::TaskSpec spec;
  spec.name = name;
  spec.kind = kind;
  return spec;
}

TEST(TaskGroups, OnlyTheMaximumOfTheWholeGripIsTheMaximumOfTheSession) {
  tasks::MaximumSpec maximum;
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
  EXPECT_EQ(kind_of(named("rest", tasks::RestSpec{})), TaskKind::rest);
  EXPECT_EQ(kind_of(named("track", tasks::ForceTrackingSpec{})), TaskKind::force_tracking);
  EXPECT_EQ(kind_of(named("targets", tasks::PoseTargetsSpec{})), TaskKind::pose_targets);
  EXPECT_EQ(kind_of(named("free", tasks::ObserveSpec{})), TaskKind::observe);
  EXPECT_EQ(kind_of(named("maxima", tasks::DirectionalMaximaSpec{})), TaskKind::other);
  EXPECT_EQ(kind_of(named("pick", tasks::PickPlaceSpec{})), TaskKind::other);
}

TEST(TaskGroups, TheListStartsWithRestAndTheGripAndSortsNumbersAsNumbers) {
  tasks::MaximumSpec opening;
  opening.channel.direction = Direction::minus_z;
  std::vector<tasks::TaskSpec> tasks{named("Two targets", tasks::PoseTargetsSpec{}),
                                     named("hold 25 %", tasks::SteadinessSpec{}),
                                     named("Hold 5 %", tasks::SteadinessSpec{}),
                                     named("Fingers one by one", tasks::IndividuationSpec{}),
                                     named("A maximum, opening", opening),
                                     named("Maximum grip", tasks::MaximumSpec{}),
                                     named("Sine", tasks::ForceTrackingSpec{}),
                                     named("Resting force", tasks::RestSpec{})};
  sort_for_list(tasks);
  std::vector<std::string> names;
  for (const auto& task : tasks) names.push_back(task.name);
  EXPECT_EQ(names, (std::vector<std::string>{"Resting force", "Maximum grip", "A maximum, opening",
                                             "Sine", "Hold 5 %", "hold 25 %", "Fingers one by one",
                                             "Two targets"}));
}

TEST(TaskGroups, EveryGroupStandsTogetherUnderItsOwnHeading) {
  std::vector<tasks::TaskSpec> tasks;
  for (const char* name : {"b", "a", "c"}) {
    tasks.push_back(named(name, tasks::PickPlaceSpec{}));
    tasks.push_back(named(name, tasks::FatigueSpec{}));
    tasks.push_back(named(name, tasks::StepResponseSpec{}));
  }
  sort_for_list(tasks);
  int headings = 1;
  for (std::size_t i = 1; i < tasks.size(); ++i)
    headings += title_of(group_of(tasks[i])) != title_of(group_of(tasks[i - 1])) ? 1 : 0;
  EXPECT_EQ(headings, 3);
}

}  // namespace
}  // namespace isograsp::gui::task_groups_test
