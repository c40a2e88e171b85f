// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/library/hand_rules.hpp"

#include <optional>

#include "tasks/kinds/hand/virtual_pick_place.hpp"
#include "tasks/task.hpp"

namespace isograsp::session {

namespace {

/// Placements of one trial of each task of a step.
int placements_of(const std::vector<tasks::TaskSpec>& tasks) {
  int count = 0;
  for (const tasks::TaskSpec& task : tasks)
    if (task.kind.is<tasks::VirtualPickPlaceSpec>()) count += task.repetitions();
  return count;
}

Error no_rest(const tasks::ProtocolSpec& protocol) {
  return refused("lets the hand rest for less than %1 s between two bouts of placements"_text(
                     shortest(tasks::kBetweenBouts_s)),
                 "write rest_s = %1 or more"_text(shortest(tasks::kBetweenBouts_s)))
      .at(protocol.file)
      .about("rest_s");
}

}  // namespace

Result<void> check_hand_assessment(const tasks::TaskSpec& spec) {
  if (spec.difficulty && spec.difficulty->chosen) return {};
  const auto* const placing = spec.kind.get_if<tasks::VirtualPickPlaceSpec>();
  if (placing == nullptr) return {};
  if (placing->assistance == virtual_hand::AssistanceLevel::off && !placing->eases) return {};
  return refused("helps the hand, which is training and no assessment"_text,
                 "write assistance = \"off\" and eases = false, or do it as practice"_text)
      .at(spec.file)
      .about("assistance");
}

Result<void> check_hand_rules(const tasks::ProtocolSpec& protocol,
                              const std::vector<std::vector<tasks::TaskSpec>>& tasks) {
  bool entered = false;
  int placements = 0;
  std::optional<double> rested_s;  // since the last bout; nothing: there was none
  for (std::size_t i = 0; i < protocol.steps.size(); ++i) {
    const tasks::ProtocolStep& step = protocol.steps[i];
    entered = entered || step.kind == tasks::ProtocolStep::Kind::hand_entry;
    if (rested_s && step.kind == tasks::ProtocolStep::Kind::pause) *rested_s += step.duration_s;
    const int of_step = placements_of(tasks[i]);
    if (of_step == 0) continue;
    if (!entered)
      return refused("asks for placements before the entry test of the hand"_text,
                     "put a step of the kind hand_entry before it"_text)
          .at(protocol.file)
          .about("kind");
    if (rested_s && *rested_s < tasks::kBetweenBouts_s) return no_rest(protocol);
    const bool several = step.repetitions > 1 || tasks[i].size() > 1;
    if (several && step.rest_s < tasks::kBetweenBouts_s) return no_rest(protocol);
    placements += step.repetitions * of_step;
    rested_s = step.rest_s;
    if (step.practice || step.adaptive) continue;
    for (const tasks::TaskSpec& task : tasks[i])
      if (auto assessed = check_hand_assessment(task); !assessed) return assessed;
  }
  if (placements > tasks::kMostPlacements)
    return refused("asks a hand for %1 placements"_text(placements),
                   "at most %1 in a session"_text(tasks::kMostPlacements))
        .at(protocol.file)
        .about("repetitions");
  return {};
}

}  // namespace isograsp::session
