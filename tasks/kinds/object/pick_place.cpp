// SPDX-License-Identifier: GPL-3.0-or-later
// Pick, place and release: an object appears, is touched, carried to its target, held there for a
// while and let go. An object that was picked up and is away from its place and its target without
// a touch was dropped: the drop is counted, and the object appears again where it began. An object
// that was let go too early inside the tolerance may be grasped again; the time of holding begins
// anew. After the time limit the next object comes, and this one is censored.
#include "tasks/kinds/object/pick_place.hpp"

#include <algorithm>
#include <vector>

#include "hand/columns.hpp"
#include "tasks/kinds/tools/of_kind.hpp"
#include "tasks/kinds/tools/read_object_keys.hpp"
#include "tasks/pace.hpp"
#include "tasks/task.hpp"

namespace isograsp::tasks {

namespace {

class PickPlace final : public Task {
 public:
  PickPlace(const PickPlaceSpec& spec, const TaskContext& context)
      : blank_(blank_force(context.references, {})),
        period_s_(context.period_s),
        tolerance_{spec.position_tolerance_m, spec.angle_tolerance_rad},
        drop_distance_m_(spec.drop_distance_m),
        hold_frames_(frames_in(spec.hold_s, context.period_s)),
        limit_frames_(frames_in(spec.time_limit_s, context.period_s)) {
    for (const auto& item : spec.items)
      items_.push_back({Pose{item.p_WO, Quat::Identity()},
                        Pose{item.p_WT, Quat(Eigen::AngleAxisd(item.angle_rad, Vec3::UnitZ()))}});
  }

  TaskView step(const TaskInput& input) noexcept override {
    TaskView view;
    auto& object = view.special.emplace<ObjectView>();
    object.grip = with_force(blank_, input);
    view.task_time_s = static_cast<double>(frame_) * period_s_;
    view.duration_s =
        static_cast<double>(limit_frames_) * static_cast<double>(items_.size()) * period_s_;
    view.target_count = static_cast<int>(items_.size());
    view.targets_reached = placed_;
    object.drops = drops_;
    if (current_ == items_.size()) {
      view.phase = Phase::done;
      view.cue = Cue::relax;
      return view;
    }
    const Item& item = items_[current_];
    view.target_index = static_cast<int>(current_);
    object.pose_target_shown = true;
    object.X_WT = item.X_WT;
    const bool done = advance(object_of(input), item, view);
    view.cue = held_ ? Cue::let_go : Cue::move;
    object.drops = drops_;
    ++frame_;
    if (done || ++item_frames_ >= limit_frames_) next(view, done);
    return view;
  }

 private:
  struct Item {
    Pose X_WO, X_WT;
  };

  /// True: the object was let go at its target.
  bool advance(const ObjectInput& input, const Item& item, TaskView& view) noexcept {
    view.phase = Phase::transport;
    if (item_frames_ == 0) {
      place(item, view);
      return false;
    }
    const bool touched = std::any_of(input.contact.begin(), input.contact.end(),
                                     [](bool contact) { return contact; });
    const bool inside = input.object != nullptr && tolerance_.holds(item.X_WT, input.object->X_WO);
    if (inside) view.phase = Phase::hold;
    if (held_ && inside && !touched) return true;
    inside_frames_ = inside && touched ? inside_frames_ + 1 : 0;
    // n + 1 samples span n periods; an object that is carried away again was not placed.
    held_ = inside && (held_ || inside_frames_ > hold_frames_);
    if (held_)
      view.hold_fraction = 1.0;
    else if (inside_frames_ > 0)
      view.hold_fraction =
          static_cast<double>(inside_frames_ - 1) / static_cast<double>(hold_frames_);
    const bool away = input.object != nullptr && !inside &&
                      (input.object->X_WO.p - item.X_WO.p).norm() > drop_distance_m_;
    picked_up_ = picked_up_ || touched;
    if (picked_up_ && !touched && away) drop(item, view);
    return false;
  }

  void drop(const Item& item, TaskView& view) noexcept {
    ++drops_;
    place(item, view);
  }
  void place(const Item& item, TaskView& view) noexcept {
    auto& object = std::get<ObjectView>(view.special);
    object.object_placed = true;
    object.placed_X_WO = item.X_WO;
    held_ = picked_up_ = false;
    inside_frames_ = 0;
  }
  void next(TaskView& view, bool placed) noexcept {
    if (placed) view.targets_reached = ++placed_;
    ++current_;
    item_frames_ = 0;
  }

  ForceView blank_;
  double period_s_;
  PoseTolerance tolerance_;
  double drop_distance_m_;
  std::int64_t hold_frames_;
  std::int64_t limit_frames_;
  std::vector<Item> items_;
  std::size_t current_ = 0;
  std::int64_t frame_ = 0;
  std::int64_t item_frames_ = 0;    ///< since this object appeared
  std::int64_t inside_frames_ = 0;  ///< uninterrupted
  bool picked_up_ = false;          ///< touched since it appeared
  bool held_ = false;               ///< long enough inside the tolerance: it may be let go
  int placed_ = 0;
  int drops_ = 0;
};

Result<std::unique_ptr<Task>> make_pick_place(const PickPlaceSpec& spec,
                                              const TaskContext& context) {
  return std::unique_ptr<Task>(std::make_unique<PickPlace>(spec, context));
}

KindSpec read_pick_place(TomlReader& reader) {
  PickPlaceSpec spec;
  spec.scene = read_scene(reader);
  const PoseTolerance tolerance =
      read_tolerance(reader, {spec.position_tolerance_m, spec.angle_tolerance_rad});
  spec.position_tolerance_m = tolerance.position_m;
  spec.angle_tolerance_rad = tolerance.angle_rad;
  spec.hold_s = read_wait(reader, "hold_s", spec.hold_s);
  spec.time_limit_s = read_duration(reader, "time_limit_s", spec.time_limit_s);
  spec.drop_distance_m = read_within(reader, "drop_distance_m", 1e-4, 1.0, spec.drop_distance_m);
  for (TomlReader& table : reader.tables("item")) {
    PickPlaceSpec::Item item;
    item.p_WO = table.vec3("from_m", Vec3::Zero());
    item.p_WT = table.vec3("to_m");
    item.angle_rad =
        kRadPerDeg * read_within(table, "angle_deg", -kMostAngle_deg, kMostAngle_deg, 0.0);
    spec.items.push_back(item);
  }
  if (spec.items.empty()) reader.fail("item", "is missing"_text, "add at least one [[item]]"_text);
  if (spec.hold_s >= spec.time_limit_s)
    reader.fail("hold_s", "leaves no time within time_limit_s"_text, "make it shorter"_text);
  return spec;
}

Duration pick_place_duration(const PickPlaceSpec& spec) {
  return duration_of_targets(spec.time_limit_s, spec.items.size());
}

std::vector<TargetPlace> pick_place_places(const PickPlaceSpec& spec) {
  std::vector<TargetPlace> places;
  for (const auto& item : spec.items)
    places.push_back({item.p_WO, item.p_WT, item.angle_rad, true});
  return places;
}

PoseTolerance pick_place_tolerance(const PickPlaceSpec& spec) {
  return {spec.position_tolerance_m, spec.angle_tolerance_rad};
}

int pick_place_count(const PickPlaceSpec& spec) {
  return static_cast<int>(spec.items.size());
}

constexpr PlacedMeasure kPickPlacePlaces[] = {{"targets_reached", "", Prominence::key},
                                              {"median_completion_time", "", Prominence::key},
                                              {columns::drops, "", Prominence::trend}};

}  // namespace

constinit const KindFacts PickPlaceSpec::kFacts{.name = "pick_place",
                                                .group = TaskGroup::object,
                                                .read = read_pick_place,
                                                .duration = of_kind<pick_place_duration>,
                                                .scene = own_scene<PickPlaceSpec>,
                                                .targets = of_kind<pick_place_places>,
                                                .tolerance = of_kind<pick_place_tolerance>,
                                                .multiply = multiply<PickPlaceSpec>,
                                                .wardrobe = Wardrobe::object,
                                                .repetitions = of_kind<pick_place_count>,
                                                .make = of_kind<make_pick_place>,
                                                .measures = of_kind<score_pick_place>,
                                                .places = kPickPlacePlaces,
                                                .carries = true};

}  // namespace isograsp::tasks
