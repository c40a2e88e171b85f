// SPDX-License-Identifier: GPL-3.0-or-later
#include "virtual_hand/grasp_criteria.hpp"

#include <algorithm>
#include <bit>
#include <limits>

#include <Eigen/SVD>

#include "grasp_model/grasp.hpp"

namespace isograsp::virtual_hand {

namespace {

/// Force coordinates of a soft contact: fx, fy, fz, tz.
constexpr Eigen::Index kCoordinates = 4;

SixValues six_values(const Eigen::VectorXd& singular) {
  SixValues six;
  six.product = 1.0;
  for (std::size_t k = 0; k < 6; ++k) {
    six.values[k] = singular[static_cast<Eigen::Index>(k)];
    six.product *= six.values[k];
  }
  six.least = six.values[5];
  return six;
}

/// Rank by the rounding of the largest singular value: a map of fewer contacts than it needs has a
/// last one that is rounding, and no inverse.
bool full_rank(const SixValues& six, Eigen::Index columns) {
  const double rounding = 6.0 * std::numeric_limits<double>::epsilon() * six.values[0] *
                          static_cast<double>(std::max<Eigen::Index>(6, columns));
  return six.values[5] > rounding;
}

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

/// Rates of the digits' angles (four of each) to velocities of the contact points, in contact axes:
/// three of translation, one of turning about the normal. The palm does not count: it moves any
/// object.
Eigen::MatrixXd contact_jacobian(std::span<const DigitContact> contacts, const HandInSpace& hand,
                                 const Pose& X_WO) {
  const auto n = static_cast<Eigen::Index>(contacts.size());
  Eigen::MatrixXd J = Eigen::MatrixXd::Zero(kCoordinates * n, kCoordinates * n);
  for (Eigen::Index k = 0; k < n; ++k) {
    const DigitContact& contact = contacts[static_cast<std::size_t>(k)];
    const Mat3 R_CW = (X_WO.q.toRotationMatrix() * contact.R_OC).transpose();
    const PointJacobian of_point =
        point_jacobian(hand, contact.digit, contact.link, X_WO.p + X_WO.q * contact.p_OC);
    const auto angles = of_point.middleCols<static_cast<int>(kAngleCount)>(
        static_cast<Eigen::Index>(6 + index_of(contact.digit) * kAngleCount));
    auto block = J.block<4, 4>(kCoordinates * k, kCoordinates * k);
    block.topRows<3>() = R_CW * angles.topRows<3>();
    block.row(3) = R_CW.row(2) * angles.bottomRows<3>();
  }
  return J;
}

const std::vector<Eigen::Index> kAllRows{0, 1, 2, 3, 4, 5};
constexpr unsigned kThin = Eigen::ComputeThinU | Eigen::ComputeThinV;
using SvdOfMap = Eigen::JacobiSVD<Eigen::MatrixXd>;

/// What the criteria of one set are made of.
struct GraspMaps {
  GraspMaps(std::span<const DigitContact> contacts, const HandInSpace& hand, const Pose& X_WO,
            const PadFriction& friction)
      : soft(as_scene_contacts(contacts, friction)), J(contact_jacobian(contacts, hand, X_WO)) {
    for (const DigitContact& contact : contacts) digits |= 1U << index_of(contact.digit);
  }
  DigitSet digits = 0;
  std::vector<Contact> soft;
  Eigen::MatrixXd J;
};

SixValues values_of(const Eigen::MatrixXd& map) {
  return six_values(SvdOfMap(map).singularValues());
}
/// (G^T)^+ J by the factors of G^T = U S V^T: V S^-1 U^T J.
Eigen::MatrixXd moved_by(const SvdOfMap& svd, const Eigen::MatrixXd& J_h) {
  return svd.matrixV() * svd.singularValues().cwiseInverse().asDiagonal() *
         svd.matrixU().transpose() * J_h;
}

/// Of scaled maps; force closure and raw values are left out.
GraspCriteria scaled_criteria(const GraspMaps& maps, double hand_scale_m) {
  GraspCriteria criteria;
  criteria.digits = maps.digits;
  const Scales scales = default_scales(maps.soft);
  criteria.length_scale_m = scales.length_m;
  const Eigen::MatrixXd G_scaled = scaled_grasp_map(maps.soft, kAllRows, scales);
  Eigen::VectorXd unit = Eigen::VectorXd::Ones(maps.J.rows());
  for (Eigen::Index k = 3; k < unit.size(); k += kCoordinates) unit[k] = scales.torsion_m;
  const SvdOfMap scaled(G_scaled.transpose(), kThin);
  criteria.G = six_values(scaled.singularValues());
  if (!full_rank(criteria.G, G_scaled.cols())) {
    criteria.G.least = criteria.G.product = 0.0;
    return criteria;
  }
  criteria.H = values_of(moved_by(scaled, unit.asDiagonal() * maps.J / hand_scale_m));
  return criteria;
}

/// Calls act(contacts of the set) for every pair, then every triple.
template <class Act>
void for_each_set(std::span<const DigitContact> contacts, const Act& act) {
  const std::size_t n = contacts.size();
  std::vector<DigitContact> chosen;
  const auto pass = [&](std::initializer_list<std::size_t> which) {
    chosen.clear();
    for (const std::size_t k : which) chosen.push_back(contacts[k]);
    act(std::span<const DigitContact>(chosen));
  };
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 1; j < n; ++j) pass({i, j});
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 1; j < n; ++j)
      for (std::size_t k = j + 1; k < n; ++k) pass({i, j, k});
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
  const GraspMaps maps(contacts, hand, X_WO, friction);
  GraspCriteria criteria = scaled_criteria(maps, hand_scale_m);
  criteria.force_closure = force_closure(maps.soft, kAllRows);
  if (criteria.G.least == 0.0) return criteria;
  const SvdOfMap raw(grasp_map(maps.soft).transpose(), kThin);
  criteria.G_raw = six_values(raw.singularValues());
  criteria.H_raw = values_of(moved_by(raw, maps.J));
  return criteria;
}

std::vector<GraspCriteria> criteria_of_sets(std::span<const DigitContact> contacts,
                                            const HandInSpace& hand, const Pose& X_WO,
                                            double hand_scale_m, const PadFriction& friction) {
  std::vector<GraspCriteria> all;
  for_each_set(contacts, [&](std::span<const DigitContact> set) {
    all.push_back(grasp_criteria(set, hand, X_WO, hand_scale_m, friction));
  });
  return all;
}

GraspChoice feasible_grasp(std::span<const DigitContact> contacts, const HandInSpace& hand,
                           const Pose& X_WO, double hand_scale_m, const PadFriction& friction,
                           const GraspLimits& limits) noexcept {
  std::vector<GraspCriteria> sets;
  std::vector<std::vector<Contact>> pads;
  for_each_set(contacts, [&](std::span<const DigitContact> set) {
    GraspMaps maps(set, hand, X_WO, friction);
    sets.push_back(scaled_criteria(maps, hand_scale_m));
    pads.push_back(std::move(maps.soft));
  });
  const auto as_choice = [&](const GraspCriteria& set, bool feasible) {
    const bool three = std::popcount(set.digits) == 3;
    return GraspChoice{set.digits,
                       feasible,
                       set.G.least,
                       set.H.least,
                       set.H.product,
                       three ? limits.G_min_3 : limits.G_min_2,
                       three ? 0.0 : limits.H_min_2,
                       three ? limits.H_det_3 : limits.H_det_2};
  };
  if (sets.empty()) return {};
  const GraspCriteria most = *std::max_element(
      sets.begin(), sets.end(), [](const GraspCriteria& a, const GraspCriteria& b) {
        return a.H.product * a.G.least < b.H.product * b.G.least;
      });
  // Force closure costs the most: it is asked of the best set, then of the next.
  GraspLimits algebra = limits;
  algebra.closure = false;
  for (;;) {
    const auto best = best_grasp(sets, algebra);
    if (!best) return as_choice(most, false);
    const auto at = std::find_if(sets.begin(), sets.end(), [&](const GraspCriteria& set) {
      return set.digits == best->digits;
    });
    const auto k = at - sets.begin();
    if (!limits.closure || force_closure(pads[static_cast<std::size_t>(k)], kAllRows))
      return as_choice(*at, true);
    sets.erase(at);
    pads.erase(pads.begin() + k);
  }
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
