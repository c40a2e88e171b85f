// SPDX-License-Identifier: GPL-3.0-or-later
#include "virtual_hand/grasp_criteria.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <initializer_list>

#include "grasp_model/grasp.hpp"
#include "virtual_hand/contact_maps.hpp"

namespace isograsp::virtual_hand {

namespace {

std::vector<Contact> as_scene_contacts(std::span<const DigitContact> contacts,
                                       const PadFriction& friction) {
  std::vector<Contact> all;
  for (const DigitContact& contact : contacts) {
    Contact one;
    one.p_OC = contact.p_OC;
    one.R_OC = contact.R_OC;
    one.model = ContactModel::soft;
    one.friction = friction.friction;
    one.torsion_m = friction.friction * friction.torsion_m();
    all.push_back(one);
  }
  return all;
}

MapScales scales_of(const ContactSet& set, double hand_scale_m,
                    const PadFriction& friction) noexcept {
  const bool turns = friction.friction > 0.0 && friction.patch_radius_m > 0.0;
  return {set.length_m(), turns ? friction.torsion_m() : 1.0, hand_scale_m};
}

/// Calls act(set) for every set of `size` of the contacts, in their order.
template <class Act>
void for_each_set(std::span<const ContactMaps> maps, std::size_t size, const Act& act) {
  for (std::size_t i = 0; i < maps.size(); ++i)
    for (std::size_t j = i + 1; j < maps.size(); ++j) {
      if (size == 2) {
        act(ContactSet{{&maps[i], &maps[j]}, 2});
        continue;
      }
      for (std::size_t k = j + 1; k < maps.size(); ++k)
        act(ContactSet{{&maps[i], &maps[j], &maps[k]}, 3});
    }
}

/// What a set of this size must exceed; a triple any H_min.
struct SetLimits {
  double G_min = 0.0;
  double H_min = 0.0;
  double H_det = 0.0;
};
SetLimits limits_of(const GraspLimits& limits, std::size_t size) noexcept {
  if (size == 2) return {limits.G_min_2, limits.H_min_2, limits.H_det_2};
  return {limits.G_min_3, 0.0, limits.H_det_3};
}

/// A set on its way through the limits of a session.
struct Candidate {
  ContactSet set;
  double G_min = 0.0;
  double H_min = 0.0;
  double H_det = 0.0;
  bool passes = false;
  [[nodiscard]] double product() const noexcept { return H_det * G_min; }
};

Candidate candidate_of(const ContactSet& set, double hand_scale_m, const PadFriction& friction,
                       const SetLimits& limits) noexcept {
  const SetFactors factors = factors_of(set, scales_of(set, hand_scale_m, friction));
  Candidate candidate{set, factors.G.least, 0.0, factors.H_det()};
  candidate.passes = candidate.G_min > limits.G_min && candidate.H_det > limits.H_det;
  if (set.count == 2 && candidate.G_min > 0.0) {
    candidate.H_min = six_values(factors.H).least;
    candidate.passes = candidate.passes && candidate.H_min > limits.H_min;
  }
  return candidate;
}

GraspChoice choice_of(const Candidate& candidate, bool feasible, const SetLimits& limits) noexcept {
  return {candidate.set.digits(), feasible,     candidate.G_min, candidate.H_min,
          candidate.H_det,        limits.G_min, limits.H_min,    limits.H_det};
}

}  // namespace

std::vector<Digit> digits_of(DigitSet set) {
  std::vector<Digit> digits;
  for (std::size_t d = 0; d < kDigitCount; ++d)
    if ((set >> d & 1U) != 0) digits.push_back(static_cast<Digit>(d));
  return digits;
}

std::string name_of(DigitSet set) {
  std::string name;
  for (const Digit digit : digits_of(set))
    name += (name.empty() ? "" : "+") + std::string(kDigitNames[index_of(digit)]);
  return name;
}

double hand_scale_m(const HandModel& hand) noexcept {
  const auto& lengths_m = hand.digit(Digit::index).lengths_m;
  return lengths_m[0] + lengths_m[1] + lengths_m[2];
}

GraspCriteria grasp_criteria(std::span<const DigitContact> contacts, const HandInSpace& hand,
                             const Pose& X_WO, double hand_scale_m, const PadFriction& friction) {
  std::array<ContactMaps, kDigitCount> maps;
  ContactSet set;
  for (const DigitContact& contact : contacts) {
    maps[set.count] = contact_maps(contact, hand, X_WO);
    set.contacts[set.count] = &maps[set.count];
    ++set.count;
  }
  GraspCriteria criteria;
  criteria.digits = set.digits();
  criteria.length_scale_m = set.length_m();
  const SetFactors scaled = factors_of(set, scales_of(set, hand_scale_m, friction));
  criteria.G = scaled.G;
  const std::vector<Eigen::Index> all_rows{0, 1, 2, 3, 4, 5};
  criteria.force_closure = force_closure(as_scene_contacts(contacts, friction), all_rows);
  if (criteria.G.least == 0.0) return criteria;
  criteria.H = six_values(scaled.H);
  const SetFactors raw = factors_of(set, {});
  criteria.G_raw = raw.G;
  criteria.H_raw = six_values(raw.H);
  return criteria;
}

std::vector<GraspCriteria> criteria_of_sets(std::span<const DigitContact> contacts,
                                            const HandInSpace& hand, const Pose& X_WO,
                                            double hand_scale_m, const PadFriction& friction) {
  std::vector<GraspCriteria> all;
  const auto add = [&](std::initializer_list<std::size_t> which) {
    std::vector<DigitContact> chosen;
    for (const std::size_t k : which) chosen.push_back(contacts[k]);
    all.push_back(grasp_criteria(chosen, hand, X_WO, hand_scale_m, friction));
  };
  const std::size_t n = contacts.size();
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 1; j < n; ++j) add({i, j});
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 1; j < n; ++j)
      for (std::size_t k = j + 1; k < n; ++k) add({i, j, k});
  return all;
}

bool closes(std::span<const DigitContact> contacts, const PadFriction& friction) noexcept {
  std::array<ContactMaps, kDigitCount> maps;
  ContactSet set;
  for (const DigitContact& contact : contacts) {
    maps[set.count] = contact_maps(contact);
    set.contacts[set.count] = &maps[set.count];
    ++set.count;
  }
  return closes(set, friction);
}

GraspChoice feasible_grasp(std::span<const DigitContact> contacts, const HandInSpace& hand,
                           const Pose& X_WO, double hand_scale_m, const PadFriction& friction,
                           const GraspLimits& limits) noexcept {
  constexpr std::size_t kMostSets = 10;  // of two or three of five
  std::array<ContactMaps, kDigitCount> maps;
  for (std::size_t k = 0; k < contacts.size(); ++k) maps[k] = contact_maps(contacts[k], hand, X_WO);
  const std::span<const ContactMaps> touching(maps.data(), contacts.size());
  std::optional<Candidate> most;
  for (const std::size_t size : {3U, 2U}) {
    const SetLimits exceed = limits_of(limits, size);
    std::array<Candidate, kMostSets> sets;
    std::size_t count = 0;
    for_each_set(touching, size, [&](const ContactSet& set) {
      sets[count++] = candidate_of(set, hand_scale_m, friction, exceed);
    });
    const auto end = sets.begin() + static_cast<std::ptrdiff_t>(count);
    const auto better = [](const Candidate& a, const Candidate& b) {
      return a.passes != b.passes ? b.passes : a.product() < b.product();
    };
    // Force closure costs the most: it is asked of the best set, then of the next.
    for (auto best = std::max_element(sets.begin(), end, better); best != end && best->passes;
         best = std::max_element(sets.begin(), end, better)) {
      if (!limits.closure || closes(best->set, friction)) return choice_of(*best, true, exceed);
      best->passes = false;
    }
    for (auto set = sets.begin(); set != end; ++set)
      if (!most || set->product() > most->product()) most = *set;
  }
  if (!most) return {};
  return choice_of(*most, false, limits_of(limits, most->set.count));
}

std::optional<BestGrasp> best_grasp(std::span<const GraspCriteria> sets,
                                    const GraspLimits& limits) {
  const auto best_of = [&](int size, const auto& passes) {
    std::optional<BestGrasp> best;
    for (const GraspCriteria& set : sets) {
      if (std::popcount(set.digits) != size || !passes(set)) continue;
      if (limits.closure && !set.force_closure) continue;
      const double product = set.H.product * set.G.least;
      if (!best || product > best->product) best = {set.digits, product};
    }
    return best;
  };
  const auto three = best_of(3, [&](const GraspCriteria& set) {
    return set.G.least > limits.G_min_3 && set.H.product > limits.H_det_3;
  });
  if (three) return three;
  return best_of(2, [&](const GraspCriteria& set) {
    return set.G.least > limits.G_min_2 && set.H.least > limits.H_min_2 &&
           set.H.product > limits.H_det_2;
  });
}

}  // namespace isograsp::virtual_hand
