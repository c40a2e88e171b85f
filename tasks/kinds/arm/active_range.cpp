// SPDX-License-Identifier: GPL-3.0-or-later
// Extremes of one angle of a link, and of its mean over 0.2 s (kinematics/range_of_motion.hpp).
// Rows that do not count are rows in which the angle is missing.
#include "tasks/kinds/arm/active_range.hpp"

#include <algorithm>
#include <cmath>

#include "kinematics/range_of_motion.hpp"
#include "tasks/kinds/tools/of_kind.hpp"
#include "tasks/pace.hpp"
#include "tasks/read_keys.hpp"
#include "tasks/record.hpp"
#include "tasks/task.hpp"

namespace isograsp::tasks {

namespace {

class ActiveRange final : public Task {
 public:
  ActiveRange(const ActiveRangeSpec& spec, const TaskContext& context)
      : asked_{spec.link, spec.angle},
        period_s_(context.period_s),
        lead_in_(frames_in(spec.lead_in_s, context.period_s)),
        frames_(lead_in_ + frames_in(spec.duration_s, context.period_s)) {}

  TaskView step(const TaskInput&) noexcept override {
    TaskView view;
    view.phase = frame_ < lead_in_  ? Phase::lead_in
                 : frame_ < frames_ ? Phase::active
                                    : Phase::done;
    view.cue = view.phase == Phase::active ? Cue::move : Cue::relax;
    view.task_time_s = static_cast<double>(frame_) * period_s_;
    view.duration_s = static_cast<double>(frames_) * period_s_;
    view.special.emplace<ArmView>().turn = asked_;
    if (frame_ < frames_) ++frame_;
    return view;
  }

 private:
  LinkAngle asked_;
  double period_s_;
  std::int64_t lead_in_;
  std::int64_t frames_;
  std::int64_t frame_ = 0;
};

Result<std::unique_ptr<Task>> make_active_range(const ActiveRangeSpec& spec,
                                                const TaskContext& context) {
  return std::unique_ptr<Task>(std::make_unique<ActiveRange>(spec, context));
}

KindSpec read_active_range(TomlReader& reader) {
  constexpr int kAngles = 3;
  ActiveRangeSpec spec;
  spec.link = static_cast<ArmLink>(reader.choice("link", {"forearm", "wrist", "fingers"}));
  spec.angle = read_count(reader, "angle", std::nullopt, kAngles);
  spec.lead_in_s = read_wait(reader, "lead_in_s", spec.lead_in_s);
  spec.duration_s = read_duration(reader, "duration_s", spec.duration_s);
  constexpr int kMostRepetitions = 100;
  spec.repetitions = read_count(reader, "repetitions", spec.repetitions, kMostRepetitions);
  return spec;
}

Duration active_range_duration(const ActiveRangeSpec& spec) {
  const double whole_s = spec.lead_in_s + spec.duration_s;
  return {whole_s, whole_s};
}

std::string active_range_column(const ActiveRangeSpec& spec) {
  return columns::link_angle[index_of(spec.link)][static_cast<std::size_t>(spec.angle - 1)];
}

int active_range_repetitions(const ActiveRangeSpec& spec) {
  return spec.repetitions;
}

std::vector<Measure> score_active_range(const ActiveRangeSpec& spec, const Record& record) {
  const std::string channel(kArmLinkNames[index_of(spec.link)]);
  const std::string column = active_range_column(spec);
  const Section section = record.select({Phase::active}, {column});
  std::vector<double> t_s;
  std::vector<double> angle_rad;
  if (section.reason.empty()) {
    const auto all_rad = record.signals().column(column);
    for (std::size_t row = 0; row < record.rows(); ++row) {
      if (record.phase(row) != Phase::active) continue;
      t_s.push_back(record.task_time_s(row));
      angle_rad.push_back(record.counts(row) ? all_rad[row] : std::nan(""));
    }
  }
  const Range range = range_of_motion(t_s, angle_rad);
  const Words never = "the angle was never seen for 0.2 s on end"_text;
  const auto value = [&](std::optional<double> rad) {
    return rad ? statistics::Computed(*rad) : statistics::Computed(never);
  };
  const bool held = range.min_held_rad && range.max_held_rad;
  return {make_measure("least_angle", channel, "rad", section, value(range.min_held_rad)),
          make_measure("largest_angle", channel, "rad", section, value(range.max_held_rad)),
          make_measure("active_range", channel, "rad", section,
                       held ? statistics::Computed(*range.max_held_rad - *range.min_held_rad)
                            : statistics::Computed(never))};
}

constexpr PlacedMeasure kActiveRangePlaces[] = {{"active_range", "", Prominence::key},
                                                {"least_angle", "", Prominence::trend},
                                                {"largest_angle", "", Prominence::trend}};

}  // namespace

constinit const KindFacts ActiveRangeSpec::kFacts{.name = "active_range",
                                                  .group = TaskGroup::arm,
                                                  .read = read_active_range,
                                                  .apparatus = "arm",
                                                  .duration = of_kind<active_range_duration>,
                                                  .curve = of_kind<active_range_column>,
                                                  .repetitions = of_kind<active_range_repetitions>,
                                                  .make = of_kind<make_active_range>,
                                                  .measures = of_kind<score_active_range>,
                                                  .places = kActiveRangePlaces};

}  // namespace isograsp::tasks
