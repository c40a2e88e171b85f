// SPDX-License-Identifier: GPL-3.0-or-later
// The grasp map and what it says about a grasp: rank, singular values, force closure, opposition.
// Object axes, torque about the COM. SI units. Formulas: docs/grasp_model.md, "Grasp map". Not for
// the real-time path: Plan keeps the answers in a table.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "core/result.hpp"
#include "grasp_model/scene.hpp"
#include "hand/finger.hpp"

namespace isograsp {

/// Any number of contacts; a scene has at most three.
using GraspMatrix = Eigen::Matrix<double, 6, Eigen::Dynamic, Eigen::RowMajor>;

/// Columns of one contact: what one unit of each transmitted force coordinate does to the object
/// (force [N], torque [N m] per N, or per N m for torsion columns). fz of a frictionless contact;
/// fx fy fz of a point, tz too of a soft one; fx fy fz tx ty tz of a bonded one.
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

/// The given rows of diag(1,1,1,1/L,1/L,1/L) G diag(1 | l for torsion columns).
[[nodiscard]] Eigen::MatrixXd scaled_grasp_map(const std::vector<Contact>& contacts,
                                               const std::vector<Eigen::Index>& rows,
                                               const Scales& scales);

/// Singular values of a map, descending, one per row; below the rounding of the largest they are
/// 0. Criteria: least, product, least / largest.
struct Criteria {
  int rank = 0;
  std::vector<double> singular_values;
  double G_min = 0.0;
  double G_det = 0.0;
  double G_rat = 0.0;
};
[[nodiscard]] Criteria criteria(const Eigen::MatrixXd& map);
/// Those of the scaled grasp map.
[[nodiscard]] Criteria criteria(const std::vector<Contact>& contacts,
                                const std::vector<Eigen::Index>& rows, const Scales& scales);

/// The rows have full rank and the contacts can press, strictly inside their cones, without a
/// resulting wrench. Exact where an exact test exists, else by cuts. Friction below 1e-9 counts as
/// none.
[[nodiscard]] bool force_closure(const std::vector<Contact>& contacts,
                                 const std::vector<Eigen::Index>& rows);
/// Without linearisation; for planar rows with up to three contacts, two soft contacts, three
/// points and any other contacts whose cones are wedges. No value: there is no exact test.
[[nodiscard]] std::optional<bool> exact_force_closure(const std::vector<Contact>& contacts,
                                                      const std::vector<Eigen::Index>& rows);
/// By linear programs that close in on the round cones. If the grasp is nearer to the threshold
/// than 1e-8 of the total normal force, the answer is no.
[[nodiscard]] bool force_closure_by_cuts(const std::vector<Contact>& contacts,
                                         const std::vector<Eigen::Index>& rows);

/// Ferrari-Canny quality (L1): the largest wrench that every direction of the columns' convex hull
/// reaches, 0 if the hull does not hold the origin inside. One column per primitive wrench, torques
/// in the scale of the forces. Fails only if the hull cannot be computed.
[[nodiscard]] Result<double> epsilon_quality(const Eigen::MatrixXd& wrenches);

/// Two normals more than 120 degrees apart.
[[nodiscard]] bool opposition(const std::vector<Contact>& contacts);

/// Whether these contacts, while they touch, may move the object under the scene's rule.
[[nodiscard]] bool grasp_rule_holds(const Scene& scene, const std::vector<Contact>& touching);
/// Whether the fingers of `mask` (bit f = finger f) may move the object under the scene's rule.
[[nodiscard]] bool grasp_rule_holds(const Scene& scene, unsigned mask);

}  // namespace isograsp
