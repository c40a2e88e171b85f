// SPDX-License-Identifier: GPL-3.0-or-later
#include "virtual_patient/virtual_patient.hpp"

#include <algorithm>
#include <cmath>

#include "virtual_patient/force_skill.hpp"
#include "virtual_patient/motor.hpp"
#include "virtual_patient/object_skill.hpp"
#include "virtual_patient/visual_memory.hpp"

namespace isograsp::virtual_patient {

namespace {

constexpr double kRise_s = 1.0;      ///< "build up over one second"
constexpr double kHeldOver_s = 0.5;  ///< the force remembered is that of about this long

FingerForces nothing() noexcept {
  return {Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
}

}  // namespace

struct VirtualPatient::Mind {
  /// What the screen asks for; the channel counts only where the cue is about one.
  struct Instruction {
    Cue cue = Cue::hand_out;
    ForceChannel channel;
    bool operator==(const Instruction&) const = default;
  };

  Mind(const PatientTraits& person, std::uint64_t seed)
      : traits(person),
        random(seed, 100),
        attention(seed, 102),
        recall(seed, 104),
        motor(person, seed),
        following(person, seed) {}

  [[nodiscard]] static Instruction instruction(const Stimulus& picture) noexcept;
  void perceive(const Stimulus& picture, double t_s) noexcept;
  void notice(const Instruction& next, double t_s) noexcept;
  void act(double t_s) noexcept;
  void want(double t_s, double dt_s) noexcept;
  void remember(double dt_s) noexcept;
  void feel(const FingerWrenches& wrench_C, double dt_s) noexcept;
  [[nodiscard]] FingerForces recalled(ForceChannel channel) const noexcept;
  /// Towards `goal`, from what was wanted when this began.
  [[nodiscard]] FingerForces risen(const FingerForces& goal, double t_s) const noexcept;

  PatientTraits traits;
  Random random, attention, recall;  // separate, so that more draws of one never change another
  VisualMemory memory;
  Motor motor;
  ForceSkill following;
  std::optional<ObjectSkill> object;
  std::optional<CarrySkill> carrying;

  Instruction seen;                ///< perceived
  double seen_s = 0.0;             ///< when
  double wait_s = 0.0;             ///< from then to acting
  Instruction acting;              ///< being done
  double acting_s = 0.0;           ///< since when
  FingerForces begun = nothing();  ///< wanted at acting_s
  FingerForces goal = nothing();   ///< of squeeze, press and reproduce
  FingerForces wanted = nothing();
  double latest_s = 0.0;

  FingerForces held = nothing();  ///< the force felt last while following or pressing
  std::optional<ForceChannel> held_channel;
  LevelMemory level;

  double hurting_s = 0.0;
  bool given_up = false;  ///< in pain, until the next instruction
  int missed_cues = 0;
  int pain_stops = 0;
};

VirtualPatient::Mind::Instruction VirtualPatient::Mind::instruction(
    const Stimulus& picture) noexcept {
  switch (picture.cue) {
    case Cue::squeeze:
    case Cue::press:
    case Cue::follow:
    case Cue::reproduce: return {picture.cue, picture.channel};
    case Cue::hand_out:
    case Cue::relax:
    case Cue::let_go:
    case Cue::move:
    case Cue::open:
    case Cue::close: break;
  }
  return {picture.cue, {}};
}

void VirtualPatient::Mind::perceive(const Stimulus& picture, double t_s) noexcept {
  if (const Instruction next = instruction(picture); next != seen) notice(next, t_s);
  if (seen.cue == Cue::follow) following.perceive(picture, t_s);
  if (object) object->perceive(picture, t_s);
  if (carrying) carrying->perceive(picture, t_s);
}

void VirtualPatient::Mind::notice(const Instruction& next, double t_s) noexcept {
  seen = next;
  seen_s = t_s;
  const double usual_s = next.cue == Cue::let_go ? traits.let_go_reaction_s : traits.reaction_s;
  wait_s = usual_s * (1.0 + traits.reaction_cv * std::abs(attention.gaussian()));
  // Somebody else takes the hand out: that is never missed.
  double lapse_s = 0.0;
  if (attention.uniform() < traits.missed_cue_probability && next.cue != Cue::hand_out) {
    ++missed_cues;
    lapse_s = traits.lapse_s;
  }
  wait_s += lapse_s;
  if (next.cue == Cue::follow) following.begin(next.channel, lapse_s);
}

void VirtualPatient::Mind::act(double t_s) noexcept {
  acting = seen;
  acting_s = t_s;
  begun = wanted;
  hurting_s = 0.0;
  given_up = false;
  // No two efforts are equally hard.
  const double largest_N = largest_force_N(traits, acting.channel);
  switch (acting.cue) {
    case Cue::squeeze:
      goal = shared(acting.channel, traits.effort * largest_N *
                                        (1.0 - traits.force_cv * std::abs(random.gaussian())));
      break;
    case Cue::press:
      goal = shared(acting.channel, traits.comfortable_share * largest_N *
                                        (1.0 + traits.force_cv * random.gaussian()));
      held_channel.reset();
      break;
    case Cue::reproduce:
      goal = recalled(acting.channel);
      level.begin(traits, recall);
      break;
    case Cue::follow: held_channel.reset(); break;
    case Cue::move:
      if (object) object->begin(t_s);
      if (carrying) carrying->begin(t_s);
      break;
    case Cue::hand_out:
    case Cue::relax:
    case Cue::let_go:
    case Cue::open:
    case Cue::close: break;
  }
}

FingerForces VirtualPatient::Mind::recalled(ForceChannel channel) const noexcept {
  if (!held_channel) return nothing();
  if (*held_channel == channel) return held;
  // Remembered with other digits or in another direction: the same number of newtons.
  FingerWrenches felt;
  for (std::size_t f = 0; f < kFingerCount; ++f) felt[f].force = held[f];
  return shared(channel, force_of(felt, *held_channel));
}

FingerForces VirtualPatient::Mind::risen(const FingerForces& goal_C, double t_s) const noexcept {
  const double share = least_jerk((t_s - acting_s) / kRise_s);
  FingerForces forces;
  for (std::size_t f = 0; f < kFingerCount; ++f)
    forces[f] = begun[f] + share * (goal_C[f] - begun[f]);
  return forces;
}

void VirtualPatient::Mind::want(double t_s, double dt_s) noexcept {
  switch (given_up ? Cue::relax : acting.cue) {
    case Cue::hand_out: wanted = nothing(); break;
    case Cue::relax:
    case Cue::let_go:
    case Cue::open:  // of a hand that is seen: nobody presses
    case Cue::close:
      for (Vec3& force : wanted) force *= std::exp(-dt_s / traits.release_s);
      break;
    case Cue::squeeze: wanted = risen(goal, t_s); break;
    case Cue::press:
      wanted = risen(goal, t_s);
      remember(dt_s);
      break;
    case Cue::reproduce: {
      FingerForces now = goal;
      for (Vec3& force : now) force *= level.share(t_s - acting_s - kRise_s, true);
      wanted = risen(now, t_s);
      break;
    }
    case Cue::follow:
      wanted = following.wanted(t_s);
      remember(dt_s);
      break;
    case Cue::move:
      wanted = object ? object->wanted(t_s) : carrying ? carrying->wanted(t_s) : nothing();
      break;
  }
}

void VirtualPatient::Mind::remember(double dt_s) noexcept {
  if (!held_channel) {
    held_channel = acting.channel;
    held = wanted;
  }
  const double fresh = 1.0 - std::exp(-dt_s / kHeldOver_s);
  for (std::size_t f = 0; f < kFingerCount; ++f) held[f] += fresh * (wanted[f] - held[f]);
}

void VirtualPatient::Mind::feel(const FingerWrenches& wrench_C, double dt_s) noexcept {
  bool hurts = false;
  for (const Wrench& wrench : wrench_C)
    hurts |= strength_used(traits, wrench.force) > traits.pain_at;
  hurting_s = hurts ? hurting_s + dt_s : 0.0;
  if (!hurts || given_up || hurting_s < traits.pain_after_s) return;
  given_up = true;
  ++pain_stops;
}

VirtualPatient::VirtualPatient(const PatientTraits& traits, std::uint64_t seed)
    : mind_(std::make_unique<Mind>(traits, seed)) {}

VirtualPatient::~VirtualPatient() = default;

int VirtualPatient::missed_cues() const noexcept {
  return mind_->missed_cues;
}

int VirtualPatient::pain_stops() const noexcept {
  return mind_->pain_stops;
}

void VirtualPatient::meet_object(const std::optional<Scene>& scene) {
  mind_->object.reset();
  if (scene) mind_->object.emplace(mind_->traits, *scene);
}

void VirtualPatient::meet_point(const std::optional<CarryKnown>& known) noexcept {
  mind_->carrying.reset();
  if (known) mind_->carrying.emplace(mind_->traits, *known);
}

const CarrySkill* VirtualPatient::carrying() const noexcept {
  return mind_->carrying ? &*mind_->carrying : nullptr;
}

void VirtualPatient::see(const Stimulus& stimulus) noexcept {
  if (!mind_->memory.see(stimulus)) return;
  // Time began again: so does the person's sense of it.
  mind_->seen_s = mind_->acting_s = mind_->latest_s = stimulus.t_s;
}

FingerWrenches VirtualPatient::press(double t_s) noexcept {
  Mind& mind = *mind_;
  const double dt_s = std::max(0.0, t_s - mind.latest_s);
  mind.latest_s = t_s;
  while (const Stimulus* picture = mind.memory.next(t_s - mind.traits.visual_delay_s))
    mind.perceive(*picture, t_s);
  if (mind.acting != mind.seen && t_s >= mind.seen_s + mind.wait_s) mind.act(t_s);
  mind.want(t_s, dt_s);
  if (mind.acting.cue == Cue::hand_out) {
    mind.motor.take_away(dt_s);
    return {};
  }
  const FingerWrenches wrench_C = mind.motor.step(mind.wanted, dt_s);
  mind.feel(wrench_C, dt_s);
  return wrench_C;
}

}  // namespace isograsp::virtual_patient
