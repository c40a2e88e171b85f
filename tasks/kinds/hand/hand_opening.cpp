// SPDX-License-Identifier: GPL-3.0-or-later
// Opening and closing on cues of fixed length: parts of the trial are the lead-in (0), then one
// for each cue. All its measures are of research: no verdict rests on what a tracker sees.
#include "tasks/kinds/hand/hand_opening.hpp"

#include "hand/hand_columns.hpp"
#include "tasks/kinds/tools/of_kind.hpp"
#include "tasks/pace.hpp"
#include "tasks/read_keys.hpp"
#include "tasks/record.hpp"
#include "tasks/task.hpp"

namespace isograsp::tasks {

namespace {

class HandOpening final : public Task {
 public:
  HandOpening(const HandOpeningSpec& spec, const TaskContext& context)
      : period_s_(context.period_s),
        lead_in_(frames_in(spec.lead_in_s, context.period_s)),
        open_(frames_in(spec.open_s, context.period_s)),
        both_(open_ + frames_in(spec.close_s, context.period_s)),
        frames_(lead_in_ + spec.repetitions * both_),
        repetitions_(spec.repetitions) {}

  TaskView step(const TaskInput&) noexcept override {
    TaskView view;
    view.special.emplace<HandView>();
    view.task_time_s = static_cast<double>(frame_) * period_s_;
    view.duration_s = static_cast<double>(frames_) * period_s_;
    view.target_count = repetitions_;
    if (frame_ >= frames_) {
      view.phase = Phase::done;
      view.targets_reached = repetitions_;
      return view;
    }
    if (frame_ >= lead_in_) {
      const std::int64_t since = frame_ - lead_in_;
      const bool opens = since % both_ < open_;
      view.phase = Phase::active;
      view.cue = opens ? Cue::open : Cue::close;
      view.target_index = static_cast<int>(since / both_);
      view.targets_reached = view.target_index;
      view.segment = 2 * view.target_index + (opens ? 1 : 2);
    }
    ++frame_;
    return view;
  }

 private:
  double period_s_;
  std::int64_t lead_in_;
  std::int64_t open_;
  std::int64_t both_;  ///< opening and closing
  std::int64_t frames_;
  int repetitions_;
  std::int64_t frame_ = 0;
};

Result<std::unique_ptr<Task>> make_hand_opening(const HandOpeningSpec& spec,
                                                const TaskContext& context) {
  return std::unique_ptr<Task>(std::make_unique<HandOpening>(spec, context));
}

KindSpec read_hand_opening(TomlReader& reader) {
  constexpr int kMostRepetitions = 20;
  HandOpeningSpec spec;
  spec.lead_in_s = read_wait(reader, "lead_in_s", spec.lead_in_s);
  spec.repetitions = read_count(reader, "repetitions", spec.repetitions, kMostRepetitions);
  spec.open_s = read_duration(reader, "open_s", spec.open_s);
  spec.close_s = read_duration(reader, "close_s", spec.close_s);
  return spec;
}

Duration hand_opening_duration(const HandOpeningSpec& spec) {
  const double whole_s = spec.lead_in_s + spec.repetitions * (spec.open_s + spec.close_s);
  return {whole_s, whole_s};
}

int hand_opening_repetitions(const HandOpeningSpec& spec) {
  return spec.repetitions;
}

std::string hand_opening_curve(const HandOpeningSpec&) {
  return columns::thumb_index_gap_m;
}

}  // namespace

constinit const KindFacts HandOpeningSpec::kFacts{.name = "hand_opening",
                                                  .group = TaskGroup::fingers_and_directions,
                                                  .read = read_hand_opening,
                                                  .apparatus = "tracked_hand",
                                                  .duration = of_kind<hand_opening_duration>,
                                                  .curve = of_kind<hand_opening_curve>,
                                                  .repetitions = of_kind<hand_opening_repetitions>,
                                                  .make = of_kind<make_hand_opening>,
                                                  .measures = of_kind<score_hand_opening>,
                                                  .research = true};

}  // namespace isograsp::tasks
