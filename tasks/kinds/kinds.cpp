// SPDX-License-Identifier: GPL-3.0-or-later
// The table of kinds of tasks: one row each. Whoever reads, runs, scores or shows a task knows its
// kind by this row and by nothing else.
#include <algorithm>
#include <array>

#include "tasks/kinds/arm/active_range.hpp"
#include "tasks/kinds/arm/drinking.hpp"
#include "tasks/kinds/arm/pose_following.hpp"
#include "tasks/kinds/arm/pose_matching.hpp"
#include "tasks/kinds/force/directional_maxima.hpp"
#include "tasks/kinds/force/fatigue.hpp"
#include "tasks/kinds/force/force_direction.hpp"
#include "tasks/kinds/force/force_sense.hpp"
#include "tasks/kinds/force/force_tracking.hpp"
#include "tasks/kinds/force/grip_release.hpp"
#include "tasks/kinds/force/individuation.hpp"
#include "tasks/kinds/force/maximum.hpp"
#include "tasks/kinds/force/recorded.hpp"
#include "tasks/kinds/force/rest.hpp"
#include "tasks/kinds/force/steadiness.hpp"
#include "tasks/kinds/force/step_response.hpp"
#include "tasks/kinds/hand/hand_opening.hpp"
#include "tasks/kinds/hand/virtual_pick_place.hpp"
#include "tasks/kinds/object/observe.hpp"
#include "tasks/kinds/object/pick_place.hpp"
#include "tasks/kinds/object/pose_targets.hpp"
#include "tasks/kinds/object/pose_tracking.hpp"
#include "tasks/kinds/two_hands/bilateral_maximum.hpp"
#include "tasks/kinds/two_hands/bilateral_rest.hpp"
#include "tasks/kinds/two_hands/bilateral_tracking.hpp"
#include "tasks/kinds/two_hands/bimanual_lift.hpp"
#include "tasks/kinds/two_hands/bimanual_pick_place.hpp"
#include "tasks/kinds/two_hands/mirror.hpp"

namespace isograsp::tasks {

namespace {

// One row each, in the order of an assessment: reports put tasks into it.
// clang-format off
constexpr std::array kKinds{
    &RestSpec::kFacts,
    &MaximumSpec::kFacts,
    &ForceTrackingSpec::kFacts,
    &PoseTargetsSpec::kFacts,
    &ObserveSpec::kFacts,
    &DirectionalMaximaSpec::kFacts,
    &SteadinessSpec::kFacts,
    &StepResponseSpec::kFacts,
    &GripReleaseSpec::kFacts,
    &ForceSenseSpec::kFacts,
    &FatigueSpec::kFacts,
    &IndividuationSpec::kFacts,
    &ForceDirectionSpec::kFacts,
    &PoseTrackingSpec::kFacts,
    &PickPlaceSpec::kFacts,
    &HandOpeningSpec::kFacts,
    &VirtualPickPlaceSpec::kFacts,
    &BilateralRestSpec::kFacts,
    &BilateralMaximumSpec::kFacts,
    &BilateralTrackingSpec::kFacts,
    &BimanualLiftSpec::kFacts,
    &BimanualPickPlaceSpec::kFacts,
    &MirrorSpec::kFacts,
    &ActiveRangeSpec::kFacts,
    &PoseMatchingSpec::kFacts,
    &PoseFollowingSpec::kFacts,
    &DrinkingSpec::kFacts,
    &RecordedSpec::kFacts,
};
// clang-format on

}  // namespace

std::span<const KindFacts* const> all_kinds() noexcept {
  return kKinds;
}

std::size_t order_of(const KindFacts& kind) noexcept {
  return static_cast<std::size_t>(std::find(kKinds.begin(), kKinds.end(), &kind) - kKinds.begin());
}

}  // namespace isograsp::tasks
