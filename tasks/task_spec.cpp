// SPDX-License-Identifier: GPL-3.0-or-later
// Task files: TOML in, TaskSpec out. Degrees in the file, radians inside.
#include "tasks/task_spec.hpp"

#include <algorithm>
#include <cmath>

#include "core/csv.hpp"
#include "core/toml_reader.hpp"
#include "tasks/kinds/read_kinds.hpp"
#include "tasks/kinds/segments.hpp"

namespace isograsp::tasks {

namespace {

/// Frame period of the estimate of durations: fine enough for a clock on a wall.
constexpr double kEstimatePeriod_s = 0.1;
/// Objects are brought to their targets in half the time allowed, as a rule.
constexpr double kUsualShare = 0.5;

template <class Kind>
double duration_of(const Kind& kind, Pace::Waits waits) {
  Pace pace(kEstimatePeriod_s, 0, waits);
  Timeline timeline{segments_of(
      kind, [](ForceChannel) { return 1.0; }, pace)};
  return static_cast<double>(timeline.frames()) * kEstimatePeriod_s;
}

template <class Kind>
Duration estimate(const Kind& kind) {
  return {duration_of(kind, Pace::Waits::mean), duration_of(kind, Pace::Waits::longest)};
}
Duration estimate(const RestSpec& kind) {
  return {kind.duration_s, kind.duration_s};
}
Duration estimate(const MaximumSpec& kind) {
  return {kind.lead_in_s + kind.squeeze_s, kind.lead_in_s + kind.squeeze_s};
}
Duration estimate(const ForceTrackingSpec& kind) {
  return {kind.lead_in_s + kind.duration_s, kind.lead_in_s + kind.duration_s};
}
Duration estimate(const PoseTrackingSpec& kind) {
  return {kind.lead_in_s + kind.duration_s, kind.lead_in_s + kind.duration_s};
}
Duration estimate(const ObserveSpec& kind) {
  return {kind.duration_s, kind.duration_s};
}
Duration estimate(const RecordedSpec& kind) {
  return {kind.duration_s, kind.duration_s};
}
Duration estimate(const PoseTargetsSpec& kind) {
  const double worst_s = kind.time_limit_s * static_cast<double>(kind.targets.size());
  return {kUsualShare * worst_s, worst_s};
}
Duration estimate(const PickPlaceSpec& kind) {
  const double worst_s = kind.time_limit_s * static_cast<double>(kind.items.size());
  return {kUsualShare * worst_s, worst_s};
}

double largest(const std::vector<double>& levels) {
  double most = 0.0;
  for (const double level : levels) most = std::max(most, std::abs(level));
  return most;
}

}  // namespace

std::string TaskSpec::scene() const {
  return std::visit(
      [](const auto& task) -> std::string {
        if constexpr (requires { task.scene; })
          return task.scene;
        else
          return "";
      },
      kind);
}

Duration TaskSpec::duration() const {
  return std::visit([](const auto& task) { return estimate(task); }, kind);
}

const Aim* TaskSpec::aim() const {
  return std::visit(
      [](const auto& task) -> const Aim* {
        if constexpr (requires { task.aim; })
          return &task.aim;
        else
          return nullptr;
      },
      kind);
}

double TaskSpec::largest_level() const {
  return std::visit(
      [](const auto& task) -> double {
        if constexpr (requires {
                        task.most;
                        task.least;
                      })
          return std::max(std::abs(task.most), std::abs(task.least));
        else if constexpr (requires { task.levels; })
          return largest(task.levels);
        else if constexpr (requires { task.to; })
          return std::max(largest(task.to), std::abs(task.from));
        else if constexpr (requires { task.level; })
          return std::abs(task.level);
        else
          return 0.0;
      },
      kind);
}

std::vector<ForceChannel> TaskSpec::channels_needed(Scale scale) const {
  const Aim* const shown = aim();
  if (shown == nullptr || shown->scale != scale) return {};
  std::vector<ForceChannel> channels;
  if (const auto* digits = std::get_if<IndividuationSpec>(&kind)) {
    for (const Finger digit : digits->digits) channels.push_back(channel_of(digit));
  } else if (const auto* directions = std::get_if<ForceDirectionSpec>(&kind)) {
    for (const Finger digit : kFingers)
      if (std::any_of(directions->targets.begin(), directions->targets.end(),
                      [&](const auto& target) { return target.asked[index_of(digit)]; }))
        channels.push_back(channel_of(digit));
  } else {
    channels.push_back(shown->channel);
  }
  return channels;
}

namespace {

decltype(TaskSpec::kind) read_kind(TomlReader& reader) {
  switch (reader.choice(
      "kind", {"rest", "maximum", "force_tracking", "pose_targets", "observe", "directional_maxima",
               "steadiness", "step_response", "grip_release", "force_sense", "fatigue",
               "individuation", "force_direction", "pose_tracking", "pick_place", "recorded"})) {
    case 0: return read_rest(reader);
    case 1: return read_maximum(reader);
    case 2: return read_force_tracking(reader);
    case 3: return read_pose_targets(reader);
    case 4: return read_observe(reader);
    case 5: return read_directional_maxima(reader);
    case 6: return read_steadiness(reader);
    case 7: return read_step_response(reader);
    case 8: return read_grip_release(reader);
    case 9: return read_force_sense(reader);
    case 10: return read_fatigue(reader);
    case 11: return read_individuation(reader);
    case 12: return read_force_direction(reader);
    case 13: return read_pose_tracking(reader);
    case 14: return read_pick_place(reader);
    default: return read_recorded(reader);
  }
}

/// False: this kind of task has nothing to multiply.
bool multiply(decltype(TaskSpec::kind)& kind, Difficulty::Factor factor, double by) {
  using Factor = Difficulty::Factor;
  return std::visit(
      [&](auto& task) {
        if constexpr (requires { task.position_tolerance_m; }) {
          if (factor == Factor::tolerance) {
            task.position_tolerance_m *= by;
            task.angle_tolerance_rad *= by;
            return true;
          }
        }
        if constexpr (requires { task.targets.front().p_WT; }) {
          if (factor == Factor::distance) {
            for (auto& target : task.targets) target.p_WT *= by;
            return true;
          }
        }
        if constexpr (requires { task.waveform; }) {
          if (factor == Factor::frequency) {
            task.waveform.frequency_Hz *= by;
            return true;
          }
        }
        if constexpr (requires {
                        task.most;
                        task.least;
                      }) {
          if (factor == Factor::level) {
            task.most *= by;
            task.least *= by;
            return true;
          }
        } else if constexpr (requires { task.level; }) {
          if (factor == Factor::level) {
            task.level *= by;
            return true;
          }
        }
        return false;
      },
      kind);
}

void read_difficulty(TomlReader& reader, TaskSpec& spec) {
  if (!reader.has("difficulty")) return;
  constexpr double kLeastFactor = 0.05;
  constexpr double kMostFactor = 20.0;
  TomlReader table = reader.table("difficulty");
  Difficulty difficulty;
  difficulty.factor = static_cast<Difficulty::Factor>(
      table.choice("factor", {"tolerance", "distance", "frequency", "level"}));
  difficulty.easiest = read_within(table, "easiest", kLeastFactor, kMostFactor);
  difficulty.hardest = read_within(table, "hardest", kLeastFactor, kMostFactor);
  difficulty.start = read_within(table, "start", 0.0, 1.0, difficulty.start);
  difficulty.measure = table.text("success_measure");
  difficulty.at_least = table.number("success_at_least");
  double by = 1.0;
  if (reader.has("chosen")) {
    TomlReader chosen = reader.table("chosen");
    difficulty.chosen = read_within(chosen, "level", 0.0, 1.0);
    by = std::lerp(difficulty.easiest, difficulty.hardest, *difficulty.chosen);
  }
  if (!multiply(spec.kind, difficulty.factor, by))
    table.fail("factor", "is nothing that this kind of task has", "choose another factor");
  const Aim* aim = spec.aim();
  if (aim != nullptr && aim->scale != Scale::newton && spec.largest_level() > 1.0)
    table.fail("hardest", "asks for more than the whole force", "write a smaller factor");
  spec.difficulty = std::move(difficulty);
}

}  // namespace

Result<TaskSpec> at_level(const TaskSpec& spec, double level) {
  return parse_task(spec.text + "\n[chosen]\nlevel = " + format_number(level) + "\n", spec.file);
}

Result<TaskSpec> parse_task(std::string_view text, const std::string& file) {
  auto reader = TomlReader::parse(text, file, "isograsp-task-1");
  if (!reader) return reader.error();
  TaskSpec spec;
  spec.file = file;
  spec.text = std::string(text);
  spec.name = reader->text("name");
  spec.instruction = reader->text("instruction");
  constexpr int kMostVersion = 1'000'000;
  spec.version = read_count(*reader, "version", 1, kMostVersion);
  spec.kind = read_kind(*reader);
  read_difficulty(*reader, spec);
  constexpr double kLongestTask_s = 7200.0;  // a trial is kept in memory while it is scored
  if (spec.duration().worst_s > kLongestTask_s)
    reader->fail("", "takes longer than two hours", "make it shorter, or repeat it less often");
  if (auto done = reader->finish(); !done) return done.error();
  return spec;
}

}  // namespace isograsp::tasks
