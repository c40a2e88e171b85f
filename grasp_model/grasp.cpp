// SPDX-License-Identifier: GPL-3.0-or-later
// F_O = G f. A column of G: (d, p_OC x d) of a force along d at p_OC, (0, d) of a torque about d.
#include "grasp_model/grasp.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/SVD>

namespace isograsp {

namespace {

Eigen::Index columns_of(ContactModel model) {
  switch (model) {
    case ContactModel::frictionless: return 1;
    case ContactModel::point: return 3;
    case ContactModel::soft: return 4;
    case ContactModel::bonded: return 6;
  }
  return 0;
}

}  // namespace

GraspMatrix contact_columns(const Contact& contact) {
  GraspMatrix W(6, columns_of(contact.model));
  const auto set_force = [&](Eigen::Index column, const Vec3& direction) {
    W.col(column) << direction, contact.p_OC.cross(direction);
  };
  if (contact.model == ContactModel::frictionless) {
    set_force(0, contact.R_OC.col(2));
    return W;
  }
  for (Eigen::Index axis = 0; axis < 3; ++axis) set_force(axis, contact.R_OC.col(axis));
  if (contact.model == ContactModel::soft) W.col(3) << Vec3::Zero(), contact.R_OC.col(2);
  if (contact.model == ContactModel::bonded) W.rightCols<3>() << Mat3::Zero(), contact.R_OC;
  return W;
}

GraspMatrix grasp_map(const std::vector<Contact>& contacts) {
  Eigen::Index columns = 0;
  for (const auto& contact : contacts) columns += columns_of(contact.model);
  GraspMatrix G(6, columns);
  columns = 0;
  for (const auto& contact : contacts) {
    const auto width = columns_of(contact.model);
    G.middleCols(columns, width) = contact_columns(contact);
    columns += width;
  }
  return G;
}

std::vector<std::string> grasp_map_columns(const std::vector<Contact>& contacts) {
  std::vector<std::string> names;
  for (const auto& contact : contacts) {
    const std::string finger(name_of(contact.finger));
    if (contact.model == ContactModel::frictionless) {
      names.push_back(finger + "_fz");
      continue;
    }
    for (const char* axis : {"_fx", "_fy", "_fz"}) names.push_back(finger + axis);
    if (contact.model == ContactModel::bonded)
      for (const char* axis : {"_tx", "_ty"}) names.push_back(finger + axis);
    if (columns_of(contact.model) > 3) names.push_back(finger + "_tz");
  }
  return names;
}

std::vector<Eigen::Index> rows_of(const Scene& scene) {
  if (!scene.free[2] && !scene.free[3] && !scene.free[4]) return {0, 1, 5};
  return {0, 1, 2, 3, 4, 5};
}

Scales default_scales(const std::vector<Contact>& contacts) {
  Scales scales;
  double squares = 0.0;
  for (const auto& contact : contacts) squares += contact.p_OC.squaredNorm();
  if (squares > 0.0) scales.length_m = std::sqrt(squares / static_cast<double>(contacts.size()));
  for (const auto& contact : contacts) {
    if (contact.model != ContactModel::soft || contact.friction == 0.0 || contact.torsion_m == 0.0)
      continue;
    scales.torsion_m = contact.torsion_m / contact.friction;
    break;
  }
  return scales;
}

Eigen::MatrixXd scaled_grasp_map(const std::vector<Contact>& contacts,
                                 const std::vector<Eigen::Index>& rows, const Scales& scales) {
  const GraspMatrix G = grasp_map(contacts);
  Eigen::MatrixXd scaled(static_cast<Eigen::Index>(rows.size()), G.cols());
  for (std::size_t r = 0; r < rows.size(); ++r)
    scaled.row(static_cast<Eigen::Index>(r)) =
        G.row(rows[r]) / (rows[r] < 3 ? 1.0 : scales.length_m);
  Eigen::Index column = 0;
  for (const auto& contact : contacts) {
    const auto width = columns_of(contact.model);
    if (width > 3) scaled.middleCols(column + 3, width - 3) *= scales.torsion_m;
    column += width;
  }
  return scaled;
}

Criteria criteria(const Eigen::MatrixXd& map) {
  constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
  Criteria result;
  result.singular_values.assign(static_cast<std::size_t>(map.rows()), 0.0);
  if (map.size() == 0) return result;
  // In long double: a double decomposition costs up to 2 eps of the largest value.
  using Extended = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;
  const Eigen::VectorXd values =
      Eigen::JacobiSVD<Extended>(map.cast<long double>()).singularValues().cast<double>();
  const double zero =
      6.0 * kEpsilon * values[0] * static_cast<double>(std::max<Eigen::Index>(6, map.cols()));
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    if (values[i] <= zero) break;
    result.singular_values[static_cast<std::size_t>(i)] = values[i];
    ++result.rank;
  }
  result.G_min = result.singular_values.back();
  result.G_det = 1.0;
  for (const double value : result.singular_values) result.G_det *= value;
  const double largest = result.singular_values.front();
  result.G_rat = largest > 0.0 ? result.G_min / largest : 0.0;
  return result;
}

Criteria criteria(const std::vector<Contact>& contacts, const std::vector<Eigen::Index>& rows,
                  const Scales& scales) {
  return criteria(scaled_grasp_map(contacts, rows, scales));
}

bool opposition(const std::vector<Contact>& contacts) {
  constexpr double kCosine = -0.5;  // of 120 degrees
  for (std::size_t i = 0; i < contacts.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (contacts[i].R_OC.col(2).dot(contacts[j].R_OC.col(2)) < kCosine) return true;
  return false;
}

bool grasp_rule_holds(const Scene& scene, const std::vector<Contact>& touching) {
  switch (scene.grasp_rule) {
    case GraspRule::any: return true;
    case GraspRule::opposition: return opposition(touching);
    case GraspRule::closure: break;
  }
  return force_closure(touching, rows_of(scene));
}

bool grasp_rule_holds(const Scene& scene, unsigned mask) {
  std::vector<Contact> touching;
  for (const auto& contact : scene.contacts)
    if ((mask >> index_of(contact.finger) & 1u) != 0) touching.push_back(contact);
  return grasp_rule_holds(scene, touching);
}

}  // namespace isograsp
