// SPDX-License-Identifier: GPL-3.0-or-later
// Placements one after the other: the object appears, is carried, held at its target, let go. The
// clock of a placement stands still while the hand is not seen. A placement of which too much was
// lost is asked once more, and in training so is one that failed three times, with more help or
// another object.
#include "tasks/kinds/hand/virtual_pick_place.hpp"

#include <algorithm>

#include "grasp_model/rotation.hpp"
#include "tasks/kinds/tools/of_kind.hpp"
#include "tasks/pace.hpp"
#include "tasks/read_keys.hpp"
#include "tasks/record.hpp"
#include "tasks/task.hpp"
#include "virtual_hand/study_plan.hpp"

namespace isograsp::tasks {

namespace {

using virtual_hand::AssistanceLevel;
using virtual_hand::SizeClass;

constexpr double kPlacementLeadIn_s = 2.0;
constexpr double kBetweenPlacements_s = 1.5;
constexpr double kFallsAway_s = 1.0;  // an object that was let go for the person is still shown
constexpr double kRadPerDegree = 0.017453292519943295;

/// More help, else a larger object of the same shape. Nothing: neither is there.
struct Eased {
  AssistanceLevel assistance;
  bool larger;
};
Eased eased(AssistanceLevel asked) noexcept {
  switch (asked) {
    case AssistanceLevel::off: return {AssistanceLevel::softer, false};
    case AssistanceLevel::softer: return {AssistanceLevel::full, false};
    case AssistanceLevel::full: break;
  }
  return {AssistanceLevel::full, true};
}
/// Small ones become slim: wider, and as a pinch. Others are no smaller than what a hand spans.
std::size_t larger_object(std::size_t object) noexcept {
  const auto& all = virtual_hand::study_objects();
  if (all[object].size != SizeClass::small) return object;
  for (std::size_t k = 0; k < all.size(); ++k)
    if (all[k].size == SizeClass::slim && all[k].shape.kind == all[object].shape.kind) return k;
  return object;
}

class VirtualPickPlace final : public Task {
 public:
  VirtualPickPlace(const VirtualPickPlaceSpec& spec, const TaskContext& context)
      : spec_(spec),
        period_s_(context.period_s),
        most_(std::min(context.placements_left, 2 * static_cast<int>(spec.items.size()))),
        wait_frames_(frames_in(kPlacementLeadIn_s, context.period_s)) {
    for (const auto& item : spec.items) queue_.push_back({item, false});
    queue_.reserve(2 * spec.items.size());
  }

  TaskView step(const TaskInput& input) noexcept override {
    const HandInput& hand = hand_of(input);
    TaskView view;
    HandView& of = view.special.emplace<HandView>();
    of.about_object = true;
    view.task_time_s = static_cast<double>(frame_++) * period_s_;
    view.duration_s = VirtualPickPlaceSpec::kTimeLimit_s * static_cast<double>(queue_.size());
    view.target_count = static_cast<int>(spec_.items.size());
    switch (stage_) {
      case Stage::between: wait(hand, view, of); break;
      case Stage::carrying:
      case Stage::letting_go:
      case Stage::falling: go_on(hand, view, of); break;
      case Stage::over: view.phase = Phase::done; break;
    }
    view.targets_reached = completed_;
    return view;
  }

 private:
  enum class Stage : std::uint8_t { between, carrying, letting_go, falling, over };
  struct Asked {
    VirtualPickPlaceSpec::Item item;
    bool again = false;
  };

  void wait(const HandInput& hand, TaskView& view, HandView& of) noexcept {
    view.phase = Phase::lead_in;
    view.cue = Cue::relax;
    if (next_ == queue_.size() || shown_ == most_) {
      stage_ = Stage::over;
      view.phase = Phase::done;
      return;
    }
    if (--wait_frames_ > 0) return;
    begin(hand);
    describe(of);
    of.placement = -1;  // its rows begin when it is there
    of.order = ObjectOrder::place;
  }

  void begin(const HandInput& hand) noexcept {
    const Asked& asked = queue_[next_];
    object_ = asked.item.object;
    assistance_ = spec_.assistance;
    if (eased_) {
      const Eased easier = eased(assistance_);
      assistance_ = easier.assistance;
      if (easier.larger) object_ = larger_object(object_);
    }
    const auto& target =
        virtual_hand::targets_of(virtual_hand::study_objects()[object_].size)[asked.item.target];
    X_WT_ = {target.p_W + Vec3(0.0, spec_.table_m, 0.0),
             so3::shortest(Vec3::UnitZ(), target.axis_W)};
    watch_ = virtual_hand::PlacementWatch(spec_.rule());
    seen_s_ = 0.0;
    frames_before_ = hand.frames;
    lost_before_ = hand.lost;
    free_s_.reset();
    helped_s_.reset();
    stage_ = Stage::carrying;
    ++shown_;
  }

  void go_on(const HandInput& hand, TaskView& view, HandView& of) noexcept {
    const double t_s = seen_s_;
    view.target_index = static_cast<int>(next_);
    if (hand.seen) {
      seen_s_ += period_s_;  // as the score adds up its rows
      if (hand.let_go && !helped_s_)
        help(t_s, of);
      else if (stage_ == Stage::carrying)
        carry(hand, t_s, of);
      else
        let_go(hand, t_s, of);
    }
    const bool carried = stage_ == Stage::carrying;
    view.phase = !carried ? Phase::active : watch_.there_since_s() ? Phase::hold : Phase::transport;
    view.cue = carried ? Cue::move : watch_.done() ? Cue::let_go : Cue::relax;
    view.hold_fraction = carried ? watch_.hold_fraction(t_s) : watch_.done() ? 1.0 : 0.0;
    describe(of);
    if (ending_) end(hand, of);
  }

  void carry(const HandInput& hand, double t_s, HandView& of) noexcept {
    if (watch_.add({t_s, hand.held, hand.supported, hand.X_WO, X_WT_}))
      of.order = ObjectOrder::reset;
    if (watch_.done()) {
      stage_ = Stage::letting_go;
      done_s_ = t_s;
      of.order = ObjectOrder::release;
      return;
    }
    failed_ = spec_.eases && watch_.drops() >= VirtualPickPlaceSpec::kMostFails;
    ending_ = failed_ || t_s >= VirtualPickPlaceSpec::kTimeLimit_s;
  }

  void let_go(const HandInput& hand, double t_s, HandView& of) noexcept {
    if (stage_ == Stage::falling) {
      ending_ = t_s - *helped_s_ >= kFallsAway_s;
      return;
    }
    if (hand.touched)
      free_s_.reset();
    else if (!free_s_)
      free_s_ = t_s;
    ending_ = free_s_ && t_s - *free_s_ >= VirtualPickPlaceSpec::kFree_s;
    if (!ending_ && t_s - done_s_ >= VirtualPickPlaceSpec::kReleaseLimit_s) help(t_s, of);
  }

  /// The object is let go for the person: at the end of the time, or at the therapist's key.
  void help(double t_s, HandView& of) noexcept {
    helped_s_ = t_s;
    stage_ = Stage::falling;
    of.order = ObjectOrder::let_go;
  }

  void describe(HandView& of) const noexcept {
    of.object = static_cast<int>(object_);
    of.placement = shown_ - 1;
    of.assistance = assistance_;
    of.eased = eased_;
    of.fails = watch_.drops();
    of.target_shown = true;
    of.X_WT = X_WT_;
    of.at_target = watch_.there_since_s().has_value();
    of.let_go_asked = watch_.done();
    of.helped = helped_s_.has_value();
  }

  void end(const HandInput& hand, HandView& of) noexcept {
    ending_ = false;
    of.order = ObjectOrder::remove;
    virtual_hand::LostShare lost(hand.frames - frames_before_, hand.lost - lost_before_);
    if (lost.can_be_scored() && watch_.done()) ++completed_;
    eased_ = eased_ || failed_;
    const Asked asked = queue_[next_++];
    if ((failed_ || !lost.can_be_scored()) && !asked.again) queue_.push_back({asked.item, true});
    failed_ = false;
    stage_ = Stage::between;
    wait_frames_ =
        frames_in(shown_ % kMostOfBout == 0 ? kBetweenBouts_s : kBetweenPlacements_s, period_s_);
  }

  VirtualPickPlaceSpec spec_;
  double period_s_;
  int most_;  ///< placements of this trial
  std::int64_t wait_frames_;
  std::vector<Asked> queue_;  ///< has room for all that are asked again
  std::size_t next_ = 0;
  Stage stage_ = Stage::between;
  std::int64_t frame_ = 0;
  int shown_ = 0;
  int completed_ = 0;
  bool eased_ = false;

  // Of the placement.
  std::size_t object_ = 0;
  AssistanceLevel assistance_ = AssistanceLevel::off;
  Pose X_WT_;
  virtual_hand::PlacementWatch watch_;
  double seen_s_ = 0.0;  ///< time of the placement in which the hand was seen
  std::int64_t frames_before_ = 0;
  std::int64_t lost_before_ = 0;
  double done_s_ = 0.0;
  std::optional<double> free_s_;
  std::optional<double> helped_s_;  ///< when it was let go for the person
  bool failed_ = false;
  bool ending_ = false;
};

Result<std::unique_ptr<Task>> make_virtual_pick_place(const VirtualPickPlaceSpec& spec,
                                                      const TaskContext& context) {
  if (context.placements_left <= 0)
    return failed("this hand has placed %1 objects in this session"_text(kMostPlacements),
                  "go on another day"_text)
        .about("placement");
  return std::unique_ptr<Task>(std::make_unique<VirtualPickPlace>(spec, context));
}

/// Nearer targets are nearer by 10 mm and 5 degrees a level; level 3 is that of the study.
void set_tolerance(VirtualPickPlaceSpec& spec, double times) {
  constexpr double kDistance_m = 0.01;
  constexpr double kAngle_deg = 10.0;
  constexpr double kAngleStep_deg = 5.0;
  spec.position_tolerance_m = kDistance_m * times;
  spec.angle_tolerance_rad = kRadPerDegree * (kAngle_deg + kAngleStep_deg * times);
}

std::size_t read_object(TomlReader& table) {
  std::array<std::string_view, virtual_hand::kStudyObjects> names;
  for (std::size_t k = 0; k < names.size(); ++k) names[k] = virtual_hand::study_objects()[k].name;
  return table.choice("object", names);
}

KindSpec read_virtual_pick_place(TomlReader& reader) {
  constexpr int kLevels = 3;
  constexpr double kMostTable_m = 0.5;
  VirtualPickPlaceSpec spec;
  spec.assistance = static_cast<AssistanceLevel>(
      reader.choice("assistance", virtual_hand::kAssistanceLevelNames));
  spec.eases = reader.boolean("eases", false);
  set_tolerance(spec, kLevels + 1 - read_count(reader, "level", kLevels, kLevels));
  spec.table_m = read_within(reader, "table_m", 0.0, kMostTable_m, spec.table_m);
  int left = 0;
  for (TomlReader& table : reader.tables("placement")) {
    VirtualPickPlaceSpec::Item item;
    item.object = read_object(table);
    constexpr int kTargets = static_cast<int>(virtual_hand::kTargetsOfSize);
    item.target = static_cast<std::size_t>(read_count(table, "target", std::nullopt, kTargets) - 1);
    left += item.target < virtual_hand::kTargetsOfSize / 2 ? 1 : 0;
    spec.items.push_back(item);
  }
  const int count = static_cast<int>(spec.items.size());
  if (count == 0)
    reader.fail("placement", "is missing"_text, "add at least one [[placement]]"_text);
  if (count > kMostOfBout)
    reader.fail("placement", "asks for more than %1 placements on end"_text(kMostOfBout),
                "make two tasks, with a rest between them"_text);
  if (left != 0 && left != count && 2 * left != count)
    reader.fail("placement", "has more targets on one side than on the other"_text,
                "have as many targets 1 to 3 (left) as 4 to 6 (right), or all on one side"_text);
  return spec;
}

Duration virtual_pick_place_duration(const VirtualPickPlaceSpec& spec) {
  constexpr double kUsual_s = 15.0;
  const auto count = static_cast<double>(spec.items.size());
  const double each_s = VirtualPickPlaceSpec::kTimeLimit_s + VirtualPickPlaceSpec::kReleaseLimit_s +
                        kFallsAway_s + kBetweenPlacements_s;
  // Each may be asked once more; after a bout the hand rests.
  const double bouts = 1.0 + 2.0 * count / kMostOfBout;
  return {kPlacementLeadIn_s + count * kUsual_s,
          kPlacementLeadIn_s + 2.0 * count * each_s + bouts * kBetweenBouts_s};
}

int virtual_pick_place_count(const VirtualPickPlaceSpec& spec) {
  return static_cast<int>(spec.items.size());
}

bool multiply_tolerance(KindSpec& kind, Difficulty::Factor factor, double by) {
  if (factor != Difficulty::Factor::tolerance) return false;
  set_tolerance(kind.as<VirtualPickPlaceSpec>(), by);
  return true;
}

}  // namespace

virtual_hand::PlacementRule VirtualPickPlaceSpec::rule() const noexcept {
  virtual_hand::PlacementRule rule;
  rule.distance_m = position_tolerance_m;
  rule.angle_rad = angle_tolerance_rad;
  return rule;
}

constinit const KindFacts VirtualPickPlaceSpec::kFacts{
    .name = "virtual_pick_place",
    .group = TaskGroup::object,
    .read = read_virtual_pick_place,
    .apparatus = "tracked_hand",
    .duration = of_kind<virtual_pick_place_duration>,
    .multiply = multiply_tolerance,
    .wardrobe = Wardrobe::placed,
    .repetitions = of_kind<virtual_pick_place_count>,
    .make = of_kind<make_virtual_pick_place>,
    .measures = of_kind<score_virtual_pick_place>,
    .research = true,
    .carries = true};

}  // namespace isograsp::tasks
