// SPDX-License-Identifier: GPL-3.0-or-later
// Lifting a tray with both hands. It stands on its rest while the hands relax; then it may be
// lifted, and held inside the band of height and tilt for hold_s. Off its rest it is dropped by a
// hand that lets go, or that stays at the limit of friction for kSlide_s: a hand has no place to
// slide to, so the time at the limit stands for the way. A drop is counted; the tray is back on its
// rest, where nothing moves it for fetch_s. After the time limit the next lift comes, and this one
// is censored.
#include "tasks/kinds/two_hands/bimanual_lift.hpp"

#include <algorithm>
#include <cmath>

#include "hand/columns.hpp"
#include "tasks/kinds/tools/of_kind.hpp"
#include "tasks/kinds/tools/read_object_keys.hpp"
#include "tasks/kinds/two_hands/hands_timeline.hpp"
#include "tasks/kinds/two_hands/lifted.hpp"
#include "tasks/pace.hpp"
#include "tasks/task.hpp"

namespace isograsp::tasks {

namespace {

constexpr double kSlide_s = 0.3;
constexpr int kMostLifts = 24;  // of a patient in a trial

class BimanualLift final : public Task {
 public:
  BimanualLift(const BimanualLiftSpec& spec, const TaskContext& context)
      : period_s_(context.period_s),
        height_m_(spec.height_m),
        band_{spec.position_tolerance_m, spec.angle_tolerance_rad},
        lifts_(spec.lifts),
        hold_frames_(frames_in(spec.hold_s, context.period_s)),
        limit_frames_(frames_in(spec.time_limit_s, context.period_s)),
        rest_frames_(frames_in(spec.rest_s, context.period_s)),
        fetch_frames_(frames_in(spec.fetch_s, context.period_s)),
        slide_frames_(frames_in(kSlide_s, context.period_s)),
        resting_(frames_in(spec.lead_in_s, context.period_s)) {
    blank_.references = context.two_hands;
    const auto pauses = static_cast<double>(lifts_ - 1);
    duration_s_ = spec.lead_in_s + lifts_ * spec.time_limit_s + pauses * spec.rest_s;
  }

  TaskView step(const TaskInput& input) noexcept override {
    const auto* const hands = std::get_if<TwoHandsInput>(&input);
    if (frame_ == 0 && hands != nullptr && hands->object != nullptr) rest_ = hands->object->X_WO;
    TaskView view;
    TwoHandsView both = blank_;
    MovedView& lift = both.moved.emplace();
    lift.band = band_;
    lift.rest_X_WO = lift.X_WT = rest_;
    lift.X_WT.p.y() += height_m_;
    if (hands != nullptr)
      for (const Hand hand : kBothHands)
        both.of[hand].force_N = force_of(hands->wrench_C[hand], {});
    view.task_time_s = static_cast<double>(frame_) * period_s_;
    view.duration_s = duration_s_;
    view.segment = segment_;
    view.target_count = lifts_;
    if (current_ == lifts_) {
      view.phase = Phase::done;
    } else if (resting_ > 0) {
      view.phase = Phase::lead_in;
      if (--resting_ == 0) ++segment_;
    } else {
      lift_it(hands, view, lift);
    }
    const bool works = !lift.on_rest || (view.phase == Phase::transport && !lift.fetched);
    view.cue = works ? Cue::move : Cue::relax;
    for (const Hand hand : kBothHands) both.of[hand].cue = view.cue;
    lift.drops = drops_;
    view.targets_reached = lifted_;
    view.special = both;
    ++frame_;
    return view;
  }

 private:
  /// One frame of a lift.
  void lift_it(const TwoHandsInput* hands, TaskView& view, MovedView& lift) noexcept {
    view.phase = Phase::transport;
    view.target_index = current_;
    lift.target_shown = true;
    lift.on_rest = false;
    bool reached = false;
    if (fetching_ > 0) {
      --fetching_;
      lift.on_rest = lift.fetched = true;
    } else if (hands != nullptr && hands->object != nullptr) {
      reached = hold(*hands, view, lift);
      if (!reached && dropped(*hands)) {
        ++drops_;
        drop();
        lift.on_rest = lift.fetched = true;
      }
    }
    ++lift_frames_;
    if (!reached && lift_frames_ < limit_frames_) return;
    if (reached) ++lifted_;
    ++current_;
    lift_frames_ = 0;
    drop();
    fetching_ = 0;
    resting_ = rest_frames_;
    ++segment_;
    if (resting_ == 0) ++segment_;
  }

  /// True: it has been inside for as long as is asked.
  bool hold(const TwoHandsInput& hands, TaskView& view, const MovedView& lift) noexcept {
    const ObjectState& object = *hands.object;
    const bool inside = hands.touches.left && hands.touches.right &&
                        std::abs(object.X_WO.p.y() - lift.X_WT.p.y()) <= band_.position_m &&
                        std::abs(object.angle_rad) <= band_.angle_rad;
    inside_frames_ = inside ? inside_frames_ + 1 : 0;
    if (!inside) return false;
    view.phase = Phase::hold;
    const bool reached = inside_frames_ > hold_frames_;  // n + 1 samples span n periods
    view.hold_fraction =
        reached ? 1.0 : static_cast<double>(inside_frames_ - 1) / static_cast<double>(hold_frames_);
    return reached;
  }

  /// Off its rest a hand lets go or slides.
  bool dropped(const TwoHandsInput& hands) noexcept {
    const bool off = hands.object->X_WO.p.y() - rest_.p.y() > kOffRest_m;
    const bool was_off = off_rest_;
    off_rest_ = off;
    if (!off) {
      sliding_ = 0;
      return false;
    }
    sliding_ = hands.slips.left || hands.slips.right ? sliding_ + 1 : 0;
    const bool let_go = was_off && !(hands.touches.left && hands.touches.right);
    return let_go || sliding_ > slide_frames_;
  }

  /// It stands on its rest again.
  void drop() noexcept {
    fetching_ = fetch_frames_;
    inside_frames_ = sliding_ = 0;
    off_rest_ = false;
  }

  TwoHandsView blank_;
  double period_s_;
  double height_m_;
  PoseTolerance band_;
  int lifts_;
  std::int64_t hold_frames_;
  std::int64_t limit_frames_;
  std::int64_t rest_frames_;
  std::int64_t fetch_frames_;
  std::int64_t slide_frames_;
  double duration_s_ = 0.0;
  Pose rest_;  ///< where it stood at first
  std::int64_t frame_ = 0;
  std::int64_t resting_;            ///< frames until it may be lifted
  std::int64_t lift_frames_ = 0;    ///< of this lift
  std::int64_t inside_frames_ = 0;  ///< without a break
  std::int64_t sliding_ = 0;        ///< likewise
  std::int64_t fetching_ = 0;       ///< until it may be lifted again
  bool off_rest_ = false;
  int current_ = 0;
  int segment_ = 0;
  int lifted_ = 0;
  int drops_ = 0;
};

Result<std::unique_ptr<Task>> make_bimanual_lift(const BimanualLiftSpec& spec,
                                                 const TaskContext& context) {
  if (auto good = check_any_effort(context.references.allowed); !good) return good.error();
  const OfHands<HandReferences>& of = context.two_hands.of;
  if (auto good = check_maxima(of); !good) return good.error();
  AskedOfHand asked{spec.level * *context.two_hands.weaker_N()};
  // A step of either hand moves the object by itself.
  if (context.lift_N_m) asked.band_N = *context.lift_N_m * spec.position_tolerance_m;
  const AskedKeys keys{"level_fraction", "position_tolerance_m"};
  if (auto good = check_asked({asked, asked}, of, keys); !good) return good.error();
  return std::unique_ptr<Task>(std::make_unique<BimanualLift>(spec, context));
}

KindSpec read_bimanual_lift(TomlReader& reader) {
  constexpr double kLeastLevel = 0.02;
  constexpr double kMostLevel = 0.5;  // more is not asked of either of two hands
  BimanualLiftSpec spec;
  spec.scene = read_scene(reader);
  spec.level = read_within(reader, "level_fraction", kLeastLevel, kMostLevel, spec.level);
  spec.height_m = read_within(reader, "height_m", 2.0 * kOffRest_m, 1.0, spec.height_m);
  const PoseTolerance band =
      read_tolerance(reader, {spec.position_tolerance_m, spec.angle_tolerance_rad});
  spec.position_tolerance_m = band.position_m;
  spec.angle_tolerance_rad = band.angle_rad;
  if (spec.position_tolerance_m > spec.height_m - kOffRest_m)
    reader.fail("position_tolerance_m", "reaches down to the rest of the object"_text,
                "make it smaller, or height_m larger"_text);
  spec.lifts = read_count(reader, "lifts", spec.lifts, kMostLifts);
  spec.hold_s = read_duration(reader, "hold_s", spec.hold_s);
  spec.time_limit_s = read_duration(reader, "time_limit_s", spec.time_limit_s);
  if (spec.hold_s >= spec.time_limit_s)
    reader.fail("hold_s", "leaves no time within time_limit_s"_text, "make it shorter"_text);
  spec.lead_in_s = read_duration(reader, "lead_in_s", spec.lead_in_s);
  spec.rest_s = read_wait(reader, "rest_s", spec.rest_s);
  spec.fetch_s = read_wait(reader, "fetch_s", spec.fetch_s);
  return spec;
}

Duration bimanual_lift_duration(const BimanualLiftSpec& spec) {
  Duration duration = duration_of_targets(spec.time_limit_s, static_cast<std::size_t>(spec.lifts));
  const double still_s = spec.lead_in_s + spec.lifts * spec.rest_s;
  duration.nominal_s += still_s;
  duration.worst_s += still_s;
  return duration;
}

HandsLoad bimanual_lift_load(const BimanualLiftSpec& spec) {
  return {spec.level, spec.height_m};
}

PoseTolerance bimanual_lift_tolerance(const BimanualLiftSpec& spec) {
  return {spec.position_tolerance_m, spec.angle_tolerance_rad};
}

std::string bimanual_lift_curve(const BimanualLiftSpec&) {
  return columns::actual_position[1];
}

int bimanual_lift_count(const BimanualLiftSpec& spec) {
  return spec.lifts;
}

constexpr PlacedMeasure kBimanualLiftPlaces[] = {{"targets_reached", "", Prominence::key},
                                                 {"object_tilt", "", Prominence::key},
                                                 {"raise_share_affected", "", Prominence::key},
                                                 {"median_completion_time", "", Prominence::trend},
                                                 {columns::drops, "", Prominence::trend}};

}  // namespace

constinit const KindFacts BimanualLiftSpec::kFacts{.name = "bimanual_lift",
                                                   .group = TaskGroup::two_hands,
                                                   .read = read_bimanual_lift,
                                                   .apparatus = "two_platforms",
                                                   .duration = of_kind<bimanual_lift_duration>,
                                                   .scene = own_scene<BimanualLiftSpec>,
                                                   .tolerance = of_kind<bimanual_lift_tolerance>,
                                                   .hands_load = of_kind<bimanual_lift_load>,
                                                   .multiply = multiply<BimanualLiftSpec>,
                                                   .wardrobe = Wardrobe::lifted,
                                                   .curve = of_kind<bimanual_lift_curve>,
                                                   .repetitions = of_kind<bimanual_lift_count>,
                                                   .make = of_kind<make_bimanual_lift>,
                                                   .measures = of_kind<score_bimanual_lift>,
                                                   .places = kBimanualLiftPlaces};

}  // namespace isograsp::tasks
