// SPDX-License-Identifier: GPL-3.0-or-later
#include "virtual_patient/virtual_patient.hpp"

#include <algorithm>
#include <cmath>

#include "virtual_patient/grip_skill.hpp"
#include "virtual_patient/motor.hpp"
#include "virtual_patient/object_skill.hpp"
#include "virtual_patient/visual_memory.hpp"

namespace isograsp {

namespace {

constexpr double kSqueezeRise_s = 1.0;

/// A grip of g: the thumb against both fingers.
FingerForces grip_of(double grip_N) noexcept {
  return {Vec3(0, 0, grip_N), Vec3(0, 0, 0.5 * grip_N), Vec3(0, 0, 0.5 * grip_N)};
}

}  // namespace

std::optional<PatientTraits> patient_traits(std::string_view name) {
  PatientTraits traits;
  if (name == "healthy") {
    traits.resting_force_N = 0.1;
    return traits;
  }
  if (name != "paretic") return std::nullopt;
  traits.visual_delay_s = 0.28;
  traits.reaction_s = 0.45;
  traits.movement_s = 3.5;
  traits.maximum_force_N = 12.0;
  traits.enslaving = 0.30;
  traits.muscle_lag_s = 0.08;
  traits.force_cv = 0.05;
  traits.tremor_fraction = 0.015;
  traits.tremor_Hz = 6.0;
  traits.resting_force_N = 0.3;
  traits.release_s = 0.6;
  traits.prediction = 0.4;
  return traits;
}

PatientTraits recovered(const PatientTraits& traits, double fraction) {
  const PatientTraits healthy = *patient_traits("healthy");
  PatientTraits on_the_way = traits;
  for (const auto trait :
       {&PatientTraits::visual_delay_s, &PatientTraits::reaction_s, &PatientTraits::movement_s,
        &PatientTraits::maximum_force_N, &PatientTraits::enslaving, &PatientTraits::muscle_lag_s,
        &PatientTraits::force_cv, &PatientTraits::tremor_fraction, &PatientTraits::tremor_Hz,
        &PatientTraits::resting_force_N, &PatientTraits::release_s, &PatientTraits::prediction})
    on_the_way.*trait += fraction * (healthy.*trait - traits.*trait);
  return on_the_way;
}

struct VirtualPatient::Mind {
  Mind(const PatientTraits& person, std::uint64_t seed)
      : traits(person), random(seed, 100), motor(person, seed), grip(person) {
    wanted.fill(Vec3::Zero());
  }

  void perceive(const Stimulus& picture, double t_s) noexcept;
  void act(Cue cue, double t_s) noexcept;
  void want(double t_s, double dt_s) noexcept;

  PatientTraits traits;
  Random random;
  VisualMemory memory;
  Motor motor;
  GripSkill grip;
  std::optional<ObjectSkill> object;

  Cue seen_cue = Cue::hand_out;  ///< perceived
  double seen_cue_s = 0.0;       ///< when
  Cue acting = Cue::hand_out;    ///< being done, one reaction time later
  double acting_s = 0.0;         ///< since when
  double effort_N = 0.0;         ///< of this squeeze
  FingerForces wanted;
  double latest_s = 0.0;
};

void VirtualPatient::Mind::perceive(const Stimulus& picture, double t_s) noexcept {
  if (picture.cue != seen_cue) {
    seen_cue = picture.cue;
    seen_cue_s = t_s;
    if (seen_cue == Cue::follow) grip.begin();
  }
  if (seen_cue == Cue::follow) grip.perceive(picture);
  if (object) object->perceive(picture, t_s);
}

void VirtualPatient::Mind::act(Cue cue, double t_s) noexcept {
  acting = cue;
  acting_s = t_s;
  // No two squeezes are equally hard.
  if (cue == Cue::squeeze)
    effort_N = traits.maximum_force_N * (1.0 - traits.force_cv * std::abs(random.gaussian()));
  if (cue == Cue::move && object) object->begin(t_s);
}

void VirtualPatient::Mind::want(double t_s, double dt_s) noexcept {
  switch (acting) {
    case Cue::hand_out: wanted.fill(Vec3::Zero()); break;
    case Cue::relax:
    case Cue::press:
    case Cue::reproduce:
    case Cue::let_go:
      for (Vec3& force : wanted) force *= std::exp(-dt_s / traits.release_s);
      break;
    case Cue::squeeze: {
      const double u = std::clamp((t_s - acting_s) / kSqueezeRise_s, 0.0, 1.0);
      wanted = grip_of(effort_N * u * u * u * (10.0 + u * (6.0 * u - 15.0)));
      break;
    }
    case Cue::follow: wanted = grip_of(grip.wanted_N()); break;
    case Cue::move:
      if (object)
        wanted = object->wanted(t_s);
      else
        wanted.fill(Vec3::Zero());
      break;
  }
}

VirtualPatient::VirtualPatient(const PatientTraits& traits, std::uint64_t seed)
    : mind_(std::make_unique<Mind>(traits, seed)) {}

VirtualPatient::~VirtualPatient() = default;

void VirtualPatient::meet_object(const std::optional<Scene>& scene) {
  mind_->object.reset();
  if (scene) mind_->object.emplace(mind_->traits, *scene);
}

void VirtualPatient::see(const Stimulus& stimulus) noexcept {
  if (!mind_->memory.see(stimulus)) return;
  // Time began again: so does the person's sense of it.
  mind_->seen_cue_s = mind_->acting_s = mind_->latest_s = stimulus.t_s;
}

FingerWrenches VirtualPatient::press(double t_s) noexcept {
  Mind& mind = *mind_;
  const double dt_s = std::max(0.0, t_s - mind.latest_s);
  mind.latest_s = t_s;
  while (const Stimulus* picture = mind.memory.next(t_s - mind.traits.visual_delay_s))
    mind.perceive(*picture, t_s);
  if (mind.acting != mind.seen_cue && t_s >= mind.seen_cue_s + mind.traits.reaction_s)
    mind.act(mind.seen_cue, t_s);
  mind.want(t_s, dt_s);
  if (mind.acting != Cue::hand_out) return mind.motor.step(mind.wanted, dt_s);
  mind.motor.take_away();
  return {};
}

}  // namespace isograsp
