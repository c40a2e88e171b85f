// SPDX-License-Identifier: GPL-3.0-or-later
// Free handling, of an object or of whatever the apparatus is: an instruction for a fixed time.
#include "tasks/kinds/object/observe.hpp"

#include "hand/columns.hpp"
#include "tasks/kinds/tools/object_score.hpp"
#include "tasks/kinds/tools/of_kind.hpp"
#include "tasks/kinds/tools/read_object_keys.hpp"
#include "tasks/pace.hpp"
#include "tasks/task.hpp"

namespace isograsp::tasks {

namespace {

class Observe final : public Task {
 public:
  Observe(const ObserveSpec& spec, const TaskContext& context)
      : blank_(blank_force(context.references, {})),
        period_s_(context.period_s),
        frames_(frames_in(spec.duration_s, context.period_s)) {}

  TaskView step(const TaskInput& input) noexcept override {
    TaskView view;
    view.phase = frame_ < frames_ ? Phase::active : Phase::done;
    view.cue = frame_ < frames_ ? Cue::move : Cue::relax;
    view.task_time_s = static_cast<double>(frame_) * period_s_;
    view.duration_s = static_cast<double>(frames_) * period_s_;
    if (std::holds_alternative<ObjectInput>(input))
      view.special.emplace<ObjectView>().grip = with_force(blank_, input);
    else if (std::holds_alternative<ForceInput>(input))
      view.special = with_force(blank_, input);
    if (frame_ < frames_) ++frame_;
    return view;
  }

 private:
  ForceView blank_;
  double period_s_;
  std::int64_t frames_;
  std::int64_t frame_ = 0;
};

Result<std::unique_ptr<Task>> make_observe(const ObserveSpec& spec, const TaskContext& context) {
  return std::unique_ptr<Task>(std::make_unique<Observe>(spec, context));
}

KindSpec read_observe(TomlReader& reader) {
  ObserveSpec spec;
  if (reader.has("scene")) spec.scene = read_scene(reader);
  spec.duration_s = read_duration(reader, "duration_s", spec.duration_s);
  return spec;
}

Duration observe_duration(const ObserveSpec& spec) {
  return {spec.duration_s, spec.duration_s};
}

std::vector<Measure> score_observe(const ObserveSpec&, const Record& record) {
  const ObjectRecord object(record);
  const Section force = record.select({Phase::active}, {columns::actual_force_N});
  const Section motion = record.select_position(0, record.rows(), {Phase::active});
  Section contact = record.select({Phase::active}, object.contact_columns());
  if (contact.reason.empty()) contact.reason = object.no_contact_columns();
  double touching_s = 0.0;
  for (std::size_t k = 0; k < contact.rows.size(); ++k)
    if (object.touched(contact.rows[k])) touching_s += contact.weight_s[k];
  statistics::Computed most = "no samples"_text;
  for (const double force_N : force.values(columns::actual_force_N))
    if (!most.value || force_N > *most.value) most = force_N;
  return {object.mean_grip({Phase::active}), make_measure("peak_force", "grip", "N", force, most),
          path_length(motion), make_measure("contact_time", "contact", "s", contact, touching_s)};
}

constexpr PlacedMeasure kObservePlaces[] = {{"mean_grip", "", Prominence::trend},
                                            {"path_length", "", Prominence::trend},
                                            {"contact_time", "", Prominence::trend}};

}  // namespace

constinit const KindFacts ObserveSpec::kFacts{.name = "observe",
                                              .group = TaskGroup::object,
                                              .read = read_observe,
                                              .apparatus = "",
                                              .duration = of_kind<observe_duration>,
                                              .scene = own_scene<ObserveSpec>,
                                              .make = of_kind<make_observe>,
                                              .measures = of_kind<score_observe>,
                                              .places = kObservePlaces,
                                              .free = true};

}  // namespace isograsp::tasks
