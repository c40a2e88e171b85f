// SPDX-License-Identifier: GPL-3.0-or-later
// Rows of the lead-in and of the task, whatever is seen in them; those of a pause are missing.
#include "tasks/kinds/arm/drinking.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include "hand/arm_columns.hpp"
#include "kinematics/measures/drinking.hpp"
#include "tasks/kinds/tools/of_kind.hpp"
#include "tasks/pace.hpp"
#include "tasks/read_keys.hpp"
#include "tasks/reasons/reasons.hpp"
#include "tasks/record.hpp"
#include "tasks/task.hpp"

namespace isograsp::tasks {

namespace {

constexpr std::array<std::string_view, kDrinkingPartCount> kDrinkingPartNames{
    "hand", "glass", "face", "trunk", "shoulder", "elbow", "wrist"};

class DrinkingRun final : public Task {
 public:
  DrinkingRun(const DrinkingSpec& spec, const TaskContext& context)
      : period_s_(context.period_s),
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
    view.special.emplace<ArmView>();
    if (frame_ < frames_) ++frame_;
    return view;
  }

 private:
  double period_s_;
  std::int64_t lead_in_;
  std::int64_t frames_;
  std::int64_t frame_ = 0;
};

Result<std::unique_ptr<Task>> make_drinking(const DrinkingSpec& spec, const TaskContext& context) {
  return std::unique_ptr<Task>(std::make_unique<DrinkingRun>(spec, context));
}

KindSpec read_drinking(TomlReader& reader) {
  DrinkingSpec spec;
  for (std::size_t part = 0; part < kDrinkingPartCount; ++part) {
    const std::string key = std::string(kDrinkingPartNames[part]) + "_marker";
    std::string& name = spec.markers[part];
    name = reader.text(key, name);
    if (name.empty() && part < kNeededDrinkingParts)
      reader.fail(key, "names no marker"_text, "write the name that the rig gives it"_text);
  }
  spec.lead_in_s = read_wait(reader, "lead_in_s", spec.lead_in_s);
  spec.duration_s = read_duration(reader, "duration_s", spec.duration_s);
  return spec;
}

Duration drinking_duration(const DrinkingSpec& spec) {
  const double whole_s = spec.lead_in_s + spec.duration_s;
  return {whole_s, whole_s};
}

std::vector<std::string> drinking_markers(const DrinkingSpec& spec) {
  return {spec.markers.begin(), spec.markers.begin() + kNeededDrinkingParts};
}

/// The columns of a marker, x y z.
std::array<std::string, 3> columns_of_marker(const std::string& name) {
  std::array<std::string, 3> columns;
  for (std::size_t axis = 0; axis < 3; ++axis)
    columns[axis] =
        std::string(columns::kMarker) + name + "_" + std::string(columns::kXyz[axis]) + "_m";
  return columns;
}

/// Positions of a marker in these rows; none, if nothing was recorded of it.
std::vector<Vec3> positions_of(const Record& record, const std::string& name,
                               const std::vector<std::size_t>& rows) {
  std::array<std::span<const double>, 3> p;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    p[axis] = record.signals().column(columns_of_marker(name)[axis]);
    if (p[axis].empty()) return {};
  }
  std::vector<Vec3> positions;
  for (const std::size_t row : rows) {
    const Vec3 here = record.paused(row) ? missing_pose().p : Vec3(p[0][row], p[1][row], p[2][row]);
    positions.push_back(is_missing(here) ? missing_pose().p : here);
  }
  return positions;
}

/// Rows before the first of phase `done`; those that count are not paused and show what is needed.
Section drinking_rows(const DrinkingSpec& spec, const Record& record,
                      std::vector<std::size_t>& rows) {
  Section section;
  std::vector<std::string> needed;
  for (std::size_t part = 0; part < kNeededDrinkingParts; ++part)
    for (std::string& column : columns_of_marker(spec.markers[part])) {
      if (!record.signals().has(column)) {
        section.reason = kColumnMissing(column);
        return section;
      }
      needed.push_back(std::move(column));
    }
  while (rows.size() < record.rows() && record.phase(rows.size()) != Phase::done)
    rows.push_back(rows.size());
  for (const std::size_t row : rows) {
    const bool counts = !record.paused(row) &&
                        std::none_of(needed.begin(), needed.end(), [&](const std::string& column) {
                          return std::isnan(record.signals().column(column)[row]);
                        });
    if (counts)
      section.rows.push_back(row);
    else
      ++section.excluded;
  }
  if (Text why = record.unusable(section, needed); !why.empty()) {
    section = {};
    section.reason = std::move(why);
  }
  return section;
}

std::vector<Measure> score_drinking(const DrinkingSpec& spec, const Record& record) {
  std::vector<std::size_t> rows;
  const Section section = drinking_rows(spec, record, rows);
  DrinkingMarkers markers;
  const std::array<std::vector<Vec3>*, kDrinkingPartCount> parts{
      &markers.hand,     &markers.glass, &markers.face, &markers.trunk,
      &markers.shoulder, &markers.elbow, &markers.wrist};
  if (section.reason.empty() && !section.rows.empty()) {
    const auto t_s = record.signals().column(columns::t_s);
    for (const std::size_t row : rows) markers.t_s.push_back(t_s[row]);
    for (std::size_t part = 0; part < kDrinkingPartCount; ++part)
      if (!spec.markers[part].empty())
        *parts[part] = positions_of(record, spec.markers[part], rows);
  }
  std::vector<Measure> all;
  for (const Measure& one : drinking_task(markers).measures)
    all.push_back(make_measure(one.name, one.channel, one.unit, section,
                               one.value ? statistics::Computed(*one.value)
                                         : statistics::Computed(reason_words(one.reason))));
  return all;
}

constexpr PlacedMeasure kDrinkingPlaces[] = {{"total_movement_time", "", Prominence::key},
                                             {"trunk_displacement", "", Prominence::key},
                                             {"phase_time", "", Prominence::trend}};

}  // namespace

constinit const KindFacts DrinkingSpec::kFacts{.name = "drinking",
                                               .group = TaskGroup::arm,
                                               .read = read_drinking,
                                               .apparatus = "arm",
                                               .duration = of_kind<drinking_duration>,
                                               .markers = of_kind<drinking_markers>,
                                               .make = of_kind<make_drinking>,
                                               .measures = of_kind<score_drinking>,
                                               .places = kDrinkingPlaces,
                                               .unseen_goes_on = true};

}  // namespace isograsp::tasks
