// SPDX-License-Identifier: GPL-3.0-or-later
// Carrying with both hands. The object stands where it begins while the hands relax, at their own
// beginning; then it may be taken, is carried to its target, held there for hold_s and let go. Let
// go elsewhere it was dropped: that is counted, and after fetch_s it may be taken again where it
// began. Let go too early inside the tolerance it may be taken there. After the time limit the next
// carry comes, and this one is censored.
#include "tasks/kinds/two_hands/bimanual_pick_place.hpp"

#include <algorithm>
#include <utility>

#include "core/random.hpp"
#include "hand/columns.hpp"
#include "tasks/carry_forces.hpp"
#include "tasks/kinds/tools/of_kind.hpp"
#include "tasks/kinds/tools/read_object_keys.hpp"
#include "tasks/kinds/two_hands/hands_timeline.hpp"
#include "tasks/pace.hpp"
#include "tasks/task.hpp"

namespace isograsp::tasks {

namespace {

constexpr std::uint64_t kCarryOrderStream = 106;
/// A hand that moves its bubble presses beyond the edge: so many times its force.
constexpr double kBeyondEdge = 2.0;

/// The places of the targets, one after the other: every repetition has all of them.
std::vector<std::size_t> order_of_targets(const BimanualPickPlaceSpec& spec, std::uint64_t seed) {
  Random random(seed, kCarryOrderStream);
  std::vector<std::size_t> order;
  const std::size_t count = spec.targets.size();
  for (int repetition = 0; repetition < spec.repetitions; ++repetition) {
    const std::size_t first = order.size();
    for (std::size_t target = 0; target < count; ++target) order.push_back(target);
    for (std::size_t left = count; left > 1; --left) {
      const auto chosen = static_cast<std::size_t>(random.uniform() * static_cast<double>(left));
      std::swap(order[first + left - 1], order[first + chosen]);
    }
  }
  return order;
}

class BimanualPickPlace final : public Task {
 public:
  BimanualPickPlace(const BimanualPickPlaceSpec& spec, const TaskContext& context)
      : period_s_(context.period_s),
        tolerance_{spec.position_tolerance_m, spec.angle_tolerance_rad},
        drop_distance_m_(spec.drop_distance_m),
        hold_frames_(frames_in(spec.hold_s, context.period_s)),
        limit_frames_(frames_in(spec.time_limit_s, context.period_s)),
        rest_frames_(frames_in(spec.rest_s, context.period_s)),
        fetch_frames_(frames_in(spec.fetch_s, context.period_s)),
        resting_(frames_in(spec.lead_in_s, context.period_s)) {
    blank_.references = context.two_hands;
    for (const std::size_t target : order_of_targets(spec, context.seed))
      targets_W_.push_back(spec.targets[target].p_WT);
    const auto count = static_cast<double>(targets_W_.size());
    duration_s_ = spec.lead_in_s + count * spec.time_limit_s + (count - 1.0) * spec.rest_s;
  }

  TaskView step(const TaskInput& input) noexcept override {
    const auto* const hands = std::get_if<TwoHandsInput>(&input);
    if (frame_ == 0 && hands != nullptr && hands->object != nullptr) start_ = hands->object->X_WO;
    TaskView view;
    TwoHandsView both = blank_;
    MovedView& moved = both.moved.emplace();
    moved.band = tolerance_;
    moved.rest_X_WO = moved.X_WT = start_;
    if (hands != nullptr)
      for (const Hand hand : kBothHands)
        both.of[hand].force_N = force_of(hands->wrench_C[hand], {});
    view.task_time_s = static_cast<double>(frame_) * period_s_;
    view.duration_s = duration_s_;
    view.segment = segment_;
    view.target_count = static_cast<int>(targets_W_.size());
    if (current_ == targets_W_.size()) {
      view.phase = Phase::done;
    } else if (resting_ > 0) {
      view.phase = Phase::lead_in;
      moved.home = true;
      if (--resting_ == 0) ++segment_;
    } else {
      carry(hands, view, moved);
    }
    for (const Hand hand : kBothHands) both.of[hand].cue = view.cue;
    moved.drops = drops_;
    view.targets_reached = placed_;
    view.special = both;
    ++frame_;
    return view;
  }

 private:
  /// One frame of a carry.
  void carry(const TwoHandsInput* hands, TaskView& view, MovedView& moved) noexcept {
    view.phase = Phase::transport;
    view.target_index = static_cast<int>(current_);
    moved.target_shown = true;
    moved.X_WT = {targets_W_[current_], start_.q};
    moved.on_rest = false;
    bool placed = false;
    if (fetching_ > 0) {
      --fetching_;
      moved.on_rest = moved.fetched = true;
    } else if (hands != nullptr && hands->object != nullptr) {
      placed = advance(*hands, view, moved);
    }
    view.cue = moved.fetched ? Cue::relax : kept_ ? Cue::let_go : Cue::move;
    ++carry_frames_;
    if (!placed && carry_frames_ < limit_frames_) return;
    if (placed) ++placed_;
    ++current_;
    carry_frames_ = fetching_ = 0;
    forget();
    resting_ = rest_frames_;
    segment_ += resting_ > 0 ? 1 : 2;
  }

  /// True: it was let go at its target.
  bool advance(const TwoHandsInput& hands, TaskView& view, MovedView& moved) noexcept {
    const bool held = hands.touches.left && hands.touches.right;
    const bool inside = tolerance_.holds(moved.X_WT, hands.object->X_WO);
    if (inside) view.phase = Phase::hold;
    if (kept_ && inside && !held) return true;
    inside_frames_ = inside && held ? inside_frames_ + 1 : 0;
    // n + 1 samples span n periods; an object that is carried away again was not placed.
    kept_ = inside && (kept_ || inside_frames_ > hold_frames_);
    if (kept_)
      view.hold_fraction = 1.0;
    else if (inside_frames_ > 0)
      view.hold_fraction =
          static_cast<double>(inside_frames_ - 1) / static_cast<double>(hold_frames_);
    const bool away = (hands.object->X_WO.p - start_.p).norm() > drop_distance_m_;
    if (was_held_ && !held && away && !inside) {
      ++drops_;
      fetching_ = fetch_frames_;
      forget();
      moved.on_rest = moved.fetched = true;
      return false;
    }
    was_held_ = held || (was_held_ && away);
    return false;
  }

  void forget() noexcept {
    inside_frames_ = 0;
    kept_ = was_held_ = false;
  }

  TwoHandsView blank_;
  double period_s_;
  PoseTolerance tolerance_;
  double drop_distance_m_;
  std::int64_t hold_frames_;
  std::int64_t limit_frames_;
  std::int64_t rest_frames_;
  std::int64_t fetch_frames_;
  std::vector<Vec3> targets_W_;
  double duration_s_ = 0.0;
  Pose start_;  ///< where it stood at first
  std::int64_t frame_ = 0;
  std::int64_t resting_;            ///< frames until it may be taken
  std::int64_t carry_frames_ = 0;   ///< of this carry
  std::int64_t inside_frames_ = 0;  ///< without a break
  std::int64_t fetching_ = 0;       ///< until it may be taken again
  bool kept_ = false;               ///< long enough at its target: it may be let go
  bool was_held_ = false;
  std::size_t current_ = 0;
  int segment_ = 0;
  int placed_ = 0;
  int drops_ = 0;
};

Result<void> check_dose(const BimanualPickPlaceSpec& spec, const TaskContext& context) {
  if (!context.two_hands.affected || spec.carries() <= context.carries_left) return {};
  return refused(
             "asks for %1 carries, a patient is asked for %2 in a session, of which %3 are left"_text(
                 spec.carries(), kMostCarries, std::max(0, context.carries_left)),
             "choose a task with fewer repetitions; more are a study of healthy volunteers"_text)
      .about("repetitions");
}

/// The affected hand may be given more of the way, or less, in training; then little is asked of
/// it.
Result<void> check_weight(const BimanualPickPlaceSpec& spec, const TwoHandsReferences& hands) {
  constexpr double kLightest = 0.2, kHeaviest = 0.8;
  constexpr double kMostOfAffected = 0.3;
  constexpr double kOfProduct = 1e-9;  // of a product
  if (spec.affected_share == 0.5) return {};
  if (!(spec.affected_share >= kLightest - kOfProduct &&
        spec.affected_share <= kHeaviest + kOfProduct))
    return refused("gives the affected hand a weight of %1, not 0.2 to 0.8"_text(
                       fixed(spec.affected_share, 2)),
                   "write easiest and hardest from 0.4 to 1.6: they multiply 0.5"_text)
        .about("difficulty");
  if (!hands.affected)
    return refused("it is not known which side is affected"_text,
                   "say it in the person's record, or leave the weight of the hands out"_text)
        .about("difficulty");
  const HandReferences& of = hands.of[*hands.affected];
  const double asked_N = kBeyondEdge * carry_forces(of, spec.edge_fraction).at_edge_N;
  if (asked_N > kMostOfAffected * *of.maximum_N * (1.0 + kOfProduct))
    return refused("asks the affected hand for %1 N, more than 30 % of its maximum of %2 N"_text(
                       fixed(asked_N, 1), fixed(*of.maximum_N, 1)),
                   "write a smaller edge_fraction where hands have other weights"_text)
        .about("edge_fraction");
  return {};
}

Result<std::unique_ptr<Task>> make_bimanual_pick_place(const BimanualPickPlaceSpec& spec,
                                                       const TaskContext& context) {
  if (auto good = check_any_effort(context.references.allowed); !good) return good.error();
  const OfHands<HandReferences>& of = context.two_hands.of;
  if (auto good = check_maxima(of); !good) return good.error();
  if (auto good = check_dose(spec, context); !good) return good.error();
  if (auto good = check_weight(spec, context.two_hands); !good) return good.error();
  OfHands<AskedOfHand> asked;
  for (const Hand hand : kBothHands)
    asked[hand].force_N = kBeyondEdge * carry_forces(of[hand], spec.edge_fraction).at_edge_N;
  if (auto good = check_asked(asked, of, {"edge_fraction", "edge_fraction"}); !good)
    return good.error();
  return std::unique_ptr<Task>(std::make_unique<BimanualPickPlace>(spec, context));
}

KindSpec read_bimanual_pick_place(TomlReader& reader) {
  constexpr double kLeastEdge = 0.02;
  constexpr double kMostEdge = 0.25;  // twice as much moves the bubble
  constexpr int kMostRepetitions = 11;
  constexpr std::size_t kMostTargets = 8;
  BimanualPickPlaceSpec spec;
  spec.scene = read_scene(reader);
  spec.technique = static_cast<BimanualPickPlaceSpec::Technique>(
      reader.choice("technique", {"clutch", "bubble", "clutch_pinch", "bubble_pinch"},
                    static_cast<std::size_t>(spec.technique)));
  spec.edge_fraction =
      read_within(reader, "edge_fraction", kLeastEdge, kMostEdge, spec.edge_fraction);
  const PoseTolerance tolerance =
      read_tolerance(reader, {spec.position_tolerance_m, spec.angle_tolerance_rad});
  spec.position_tolerance_m = tolerance.position_m;
  spec.angle_tolerance_rad = tolerance.angle_rad;
  spec.repetitions = read_count(reader, "repetitions", spec.repetitions, kMostRepetitions);
  spec.hold_s = read_duration(reader, "hold_s", spec.hold_s);
  spec.time_limit_s = read_duration(reader, "time_limit_s", spec.time_limit_s);
  spec.drop_distance_m = read_within(reader, "drop_distance_m", 1e-4, 1.0, spec.drop_distance_m);
  spec.lead_in_s = read_duration(reader, "lead_in_s", spec.lead_in_s);
  spec.rest_s = read_wait(reader, "rest_s", spec.rest_s);
  spec.fetch_s = read_wait(reader, "fetch_s", spec.fetch_s);
  for (TomlReader& table : reader.tables("target")) spec.targets.push_back({table.vec3("to_m")});
  if (spec.targets.empty() || spec.targets.size() > kMostTargets)
    reader.fail("target", "is not there, or there are more than 8"_text,
                "write one [[target]] for each place"_text);
  if (spec.hold_s >= spec.time_limit_s)
    reader.fail("hold_s", "leaves no time within time_limit_s"_text, "make it shorter"_text);
  return spec;
}

Duration bimanual_pick_place_duration(const BimanualPickPlaceSpec& spec) {
  Duration duration =
      duration_of_targets(spec.time_limit_s, static_cast<std::size_t>(spec.carries()));
  const double still_s = spec.lead_in_s + spec.carries() * spec.rest_s;
  duration.nominal_s += still_s;
  duration.worst_s += still_s;
  return duration;
}

HandsCarry bimanual_pick_place_carry(const BimanualPickPlaceSpec& spec) {
  using Technique = BimanualPickPlaceSpec::Technique;
  HandsCarry carry;
  carry.clutch = spec.technique == Technique::clutch || spec.technique == Technique::clutch_pinch;
  carry.pinch =
      spec.technique == Technique::clutch_pinch || spec.technique == Technique::bubble_pinch;
  carry.edge_fraction = spec.edge_fraction;
  carry.affected_share = spec.affected_share;
  return carry;
}

std::vector<TargetPlace> bimanual_pick_place_places(const BimanualPickPlaceSpec& spec) {
  std::vector<TargetPlace> places;
  for (const auto& target : spec.targets) places.push_back({std::nullopt, target.p_WT, 0.0, true});
  return places;
}

PoseTolerance bimanual_pick_place_tolerance(const BimanualPickPlaceSpec& spec) {
  return {spec.position_tolerance_m, spec.angle_tolerance_rad};
}

std::string bimanual_pick_place_curve(const BimanualPickPlaceSpec&) {
  return columns::actual_position[1];
}

int bimanual_pick_place_count(const BimanualPickPlaceSpec& spec) {
  return spec.carries();
}

constexpr PlacedMeasure kBimanualPickPlacePlaces[] = {
    {"targets_reached", "", Prominence::key},
    {"median_completion_time", "", Prominence::key},
    {"restricted_mean_time", "", Prominence::trend},
    {columns::drops, "", Prominence::trend}};

}  // namespace

constinit const KindFacts BimanualPickPlaceSpec::kFacts{
    .name = "bimanual_pick_place",
    .group = TaskGroup::two_hands,
    .read = read_bimanual_pick_place,
    .apparatus = "two_platforms",
    .duration = of_kind<bimanual_pick_place_duration>,
    .scene = own_scene<BimanualPickPlaceSpec>,
    .targets = of_kind<bimanual_pick_place_places>,
    .tolerance = of_kind<bimanual_pick_place_tolerance>,
    .hands_carry = of_kind<bimanual_pick_place_carry>,
    .multiply = multiply<BimanualPickPlaceSpec>,
    .wardrobe = Wardrobe::carried,
    .curve = of_kind<bimanual_pick_place_curve>,
    .repetitions = of_kind<bimanual_pick_place_count>,
    .make = of_kind<make_bimanual_pick_place>,
    .measures = of_kind<score_bimanual_pick_place>,
    .places = kBimanualPickPlacePlaces,
    .carries = true};

}  // namespace isograsp::tasks
