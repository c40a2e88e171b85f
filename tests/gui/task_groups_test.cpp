// SPDX-License-Identifier: GPL-3.0-or-later
// The list of tasks: what counts as the maximum, and that people find a task among many.
#include "gui/library/task_groups.hpp"

#include <gtest/gtest.h>

#include "tasks/kinds/force/directional_maxima.hpp"
#include "tasks/kinds/force/fatigue.hpp"
#include "tasks/kinds/force/force_tracking.hpp"
#include "tasks/kinds/force/individuation.hpp"
#include "tasks/kinds/force/maximum.hpp"
#include "tasks/kinds/force/rest.hpp"
#include "tasks/kinds/force/steadiness.hpp"
#include "tasks/kinds/force/step_response.hpp"
#include "tasks/kinds/object/observe.hpp"
#include "tasks/kinds/object/pick_place.hpp"
#include "tasks/kinds/object/pose_targets.hpp"

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
  EXPECT_TRUE(is_grip_maximum(named("grip", maximum)));
  maximum.comfortable = true;
  EXPECT_FALSE(is_grip_maximum(named("comfortable", maximum)));
  maximum.comfortable = false;
  for (const ForceChannel channel :
       {ForceChannel{Digits::grip, Direction::minus_z}, ForceChannel{Digits::index},
        ForceChannel{Digits::grip_mean}, ForceChannel{Digits::thumb, Direction::plus_x}}) {
    maximum.channel = channel;
    EXPECT_FALSE(is_grip_maximum(named("one", maximum))) << name_of(channel);
  }
  EXPECT_FALSE(is_grip_maximum(named("maxima", tasks::DirectionalMaximaSpec{})));
}

TEST(TaskGroups, OneKindOfOneHandRestsAndOneOfBothAndOneIsFree) {
  int rest = 0;
  int free = 0;
  for (const tasks::KindFacts* kind : tasks::all_kinds()) {
    rest += kind->rests ? 1 : 0;
    free += kind->free ? 1 : 0;
  }
  EXPECT_EQ(rest, 2);
  EXPECT_EQ(free, 1);
  EXPECT_TRUE(is_rest(named("rest", tasks::RestSpec{})));
  EXPECT_TRUE(is_free_handling(named("free", tasks::ObserveSpec{})));
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
    headings += words_of(tasks[i].kind->group) != words_of(tasks[i - 1].kind->group) ? 1 : 0;
  EXPECT_EQ(headings, 3);
}

}  // namespace
}  // namespace isograsp::gui::task_groups_test
