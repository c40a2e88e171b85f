// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/library/arm_rules.hpp"

#include <algorithm>
#include <optional>

#include "tasks/agenda.hpp"
#include "tasks/kinds/arm/pose_matching.hpp"

namespace isograsp::session {

namespace {

bool has_postures(const tasks::TaskSpec& task) {
  return task.kind->postures != nullptr;
}

/// Practice left out: familiarisation is paced by how it goes.
double worst_without_practice_s(tasks::ProtocolSpec protocol,
                                std::vector<std::vector<tasks::TaskSpec>> tasks) {
  for (std::size_t step = protocol.steps.size(); step-- > 0;) {
    if (!protocol.steps[step].practice) continue;
    protocol.steps.erase(protocol.steps.begin() + static_cast<std::ptrdiff_t>(step));
    tasks.erase(tasks.begin() + static_cast<std::ptrdiff_t>(step));
  }
  return tasks::duration_of(protocol, tasks).worst_s;
}

Result<void> check_rests(const tasks::ProtocolSpec& protocol,
                         const std::vector<std::vector<tasks::TaskSpec>>& tasks) {
  std::optional<double> rested_s;  // since the last step with postures; nothing: there was none
  for (std::size_t i = 0; i < protocol.steps.size(); ++i) {
    const tasks::ProtocolStep& step = protocol.steps[i];
    if (rested_s && step.kind == tasks::ProtocolStep::Kind::pause) *rested_s += step.duration_s;
    if (std::none_of(tasks[i].begin(), tasks[i].end(), has_postures)) continue;
    if (rested_s && *rested_s < kBetweenBlocks_s)
      return refused("lets the hand rest for %1 s only between two blocks of movements"_text(
                         shortest(*rested_s)),
                     "rest for %1 s or more"_text(shortest(kBetweenBlocks_s)))
          .at(protocol.file)
          .about("rest_s");
    int on_end = 0;  // movements of all trials, where they do not let the hand be put down
    for (const tasks::TaskSpec& task : tasks[i]) {
      if (!has_postures(task)) continue;
      if (task.repetitions() > kMostMovements)
        return refused("asks for %1 movements on end in '%2'"_text(task.repetitions(),
                                                                   Known{task.name}),
                       "at most %1, then rest; repeat the task"_text(kMostMovements))
            .at(protocol.file)
            .about("task");
      // In bouts the task comes as often as it takes: more than once.
      on_end += (step.bouts ? 1 + kMostMovements : step.repetitions) * task.repetitions();
      if (step.practice || step.adaptive) continue;
      if (auto assessed = check_assessment(task); !assessed) return assessed;
    }
    if (step.rest_s < kHandDown_s && on_end > kMostMovements)
      return refused("does not let the hand be put down after %1 movements"_text(kMostMovements),
                     "write rest_s = %1 or more"_text(shortest(kHandDown_s)))
          .at(protocol.file)
          .about("rest_s");
    rested_s = step.rest_s;
  }
  return {};
}

}  // namespace

Result<void> check_assessment(const tasks::TaskSpec& spec) {
  if (spec.difficulty && spec.difficulty->chosen) return {};
  const auto* const matching = spec.kind.get_if<tasks::PoseMatchingSpec>();
  if (matching == nullptr || matching->hold_s >= kLeastHold_s) return {};
  return refused("holds a reference for %1 s only, which is no assessment"_text(
                     shortest(matching->hold_s)),
                 "write hold_s = %1 or more, or do it as practice"_text(shortest(kLeastHold_s)))
      .at(spec.file)
      .about("hold_s");
}

Result<void> check_arm_rules(const tasks::ProtocolSpec& protocol,
                             const std::vector<std::vector<tasks::TaskSpec>>& tasks) {
  const bool of_arm = std::any_of(tasks.begin(), tasks.end(), [](const auto& of_step) {
    return std::any_of(of_step.begin(), of_step.end(), has_postures);
  });
  if (!of_arm) return {};
  if (auto rests = check_rests(protocol, tasks); !rests) return rests;
  constexpr double kMinute_s = 60.0;
  if (const double worst_s = worst_without_practice_s(protocol, tasks);
      worst_s > kLongestArmProtocol_s)
    return refused("takes an arm %1 minutes at worst, its practice left out"_text(
                       fixed(worst_s / kMinute_s, 1)),
                   "leave out steps or shorten time_limit_s: at most %1 minutes"_text(
                       shortest(kLongestArmProtocol_s / kMinute_s)))
        .at(protocol.file);
  return {};
}

}  // namespace isograsp::session
