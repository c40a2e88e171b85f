// SPDX-License-Identifier: GPL-3.0-or-later
// The grasp map and what it says about a grasp: rank, singular values, force closure, opposition.
// Object axes, torque about the COM. SI units. Formulas: docs/grasp_model.md, "Grasp map". Not for
// the real-time path: Plan keeps the answers in a table.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "core/finger.hpp"
#include "grasp_model/scene.hpp"

namespace isograsp {

class Plan;

/// At most three soft contacts of four columns each.
using GraspMatrix = Eigen::Matrix<double, 6, Eigen::Dynamic, Eigen::RowMajor, 6, 12>;

/// Columns of one contact: what one unit of each transmitted force coordinate does to the object
/// (force [N], torque [N m] per N, or per N m for the torsion column).
[[nodiscard]] GraspMatrix contact_columns(const Contact& contact);
/// G of the contacts in the order given, columns side by side.
[[nodiscard]] GraspMatrix grasp_map(const std::vector<Contact>& contacts);
/// Names of the columns: "thumb_fx" … "middle_tz".
[[nodiscard]] std::vector<std::string> grasp_map_columns(const std::vector<Contact>& contacts);

/// Rows that count: Fx, Fy, Tz of a planar scene, else all six.
[[nodiscard]] std::vector<Eigen::Index> rows_of(const Scene& scene);

/// Lengths that make torques and forces comparable [m].
struct Scales {
  double length_m = 1.0;   ///< of torques
  double torsion_m = 1.0;  ///< of torsion columns
};
/// rms distance of the contacts from the COM (1 if 0); torsion_m / friction (1 without soft
/// contact).
[[nodiscard]] Scales default_scales(const std::vector<Contact>& contacts);

/// Singular values of the scaled rows, descending, one per row; below the rounding of the largest
/// they are 0. Criteria: least, product, least / largest.
struct Criteria {
  int rank = 0;
  std::vector<double> singular_values;
  double G_min = 0.0;
  double G_det = 0.0;
  double G_rat = 0.0;
};
[[nodiscard]] Criteria criteria(const std::vector<Contact>& contacts,
                                const std::vector<Eigen::Index>& rows, const Scales& scales);

/// The rows have full rank and the contacts can press, strictly inside their cones, without a
/// resulting wrench.
[[nodiscard]] bool force_closure(const std::vector<Contact>& contacts,
                                 const std::vector<Eigen::Index>& rows);
/// Two normals more than 120 degrees apart.
[[nodiscard]] bool opposition(const std::vector<Contact>& contacts);

/// Whether the fingers of `mask` (bit f = finger f) may move the object under the scene's rule.
[[nodiscard]] bool grasp_rule_holds(const Scene& scene, unsigned mask);

/// What the plan chose and why: pairs of a name (a JSON key) and a text.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> describe(const Plan& plan);

}  // namespace isograsp
