// SPDX-License-Identifier: GPL-3.0-or-later
// Force closure. Internal forces f = N z, G N = 0; each cone is |g_t| <= slope g_n in coordinates g
// of its contact. Formulas: docs/grasp_model.md, "Force closure".
#include <algorithm>
#include <cmath>
#include <memory>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/QR>
#include <glpk.h>

#include "grasp_model/grasp.hpp"

namespace isograsp {

namespace {

/// Friction, torsion (per arm) and tilt below this have no effect that a double could show.
constexpr double kNegligible = 1e-9;
/// Friction above this is a cone of 90 degrees less 1e-6 rad.
constexpr double kLargestFriction = 1e6;

/// A contact in coordinates that are well scaled for any friction: tangents and torsion divided by
/// min(mu, 1), then mu f_n >= |f_t| reads max(mu, 1) g_n >= |g_t|.
struct Cone {
  Eigen::MatrixXd columns;  ///< rows of the scaled map by coordinates; the last one presses
  double slope = 1.0;
  bool limited = true;  ///< false: any force in these columns
  Eigen::MatrixXd N;    ///< its rows of the null space
};

/// The contact without limits that are negligible or too large for a double.
Contact effective(Contact contact, double length_m) {
  if (contact.model == ContactModel::bonded) return contact;
  contact.friction = std::min(contact.friction, kLargestFriction);
  if (contact.model == ContactModel::soft && contact.torsion_m < kNegligible * length_m)
    contact.model = ContactModel::point;
  if (contact.friction < kNegligible) contact.model = ContactModel::frictionless;
  return contact;
}

/// Lengths that make this contact's columns of the order of 1.
Scales scales_of(const Contact& contact, double length_m) {
  switch (contact.model) {
    case ContactModel::soft: return {length_m, contact.torsion_m / contact.friction};
    case ContactModel::bonded: return {length_m, length_m};
    default: return {length_m, 1.0};
  }
}

Cone spatial_cone(const Contact& contact, const std::vector<Eigen::Index>& rows, double length_m) {
  const Eigen::MatrixXd W = scaled_grasp_map({contact}, rows, scales_of(contact, length_m));
  if (contact.model == ContactModel::bonded) return {W, 1.0, false, {}};
  if (contact.model == ContactModel::frictionless) return {W, 1.0, true, {}};
  Cone cone{W, std::max(contact.friction, 1.0), true, {}};
  cone.columns.leftCols(2) *= std::min(contact.friction, 1.0);
  if (contact.model == ContactModel::soft) {
    cone.columns.col(2) = W.col(3) * std::min(contact.friction, 1.0);
    cone.columns.col(3) = W.col(2);
  }
  return cone;
}

/// The shadow of the cone in the plane of x and y, with rows Fx, Fy, Tz: a wedge whose half-angle
/// has the tangent mu / sqrt(1 - n_z^2 (1 + mu^2)), or the whole plane if the cone holds the z
/// axis. A frictionless contact along z drops out.
std::optional<Cone> planar_cone(const Contact& contact, double length_m) {
  const Vec3 p = contact.p_OC;
  const Vec3 n = contact.R_OC.col(2);
  const auto column = [&](double x, double y) {
    return Vec3(x, y, (p.x() * y - p.y() * x) / length_m);
  };
  if (contact.model == ContactModel::frictionless) {
    if (std::hypot(n.x(), n.y()) < kNegligible) return std::nullopt;
    return Cone{column(n.x(), n.y()), 1.0, true, {}};
  }
  Cone cone{Eigen::MatrixXd(3, 2), 1.0, true, {}};
  const double mu = contact.friction;
  const double inside = 1.0 - n.z() * n.z() * (1.0 + mu * mu);
  if (inside <= 0.0) {
    cone.columns << column(1, 0), column(0, 1);
    cone.limited = false;
    return cone;
  }
  const double shadow = std::min(mu / std::sqrt(inside), kLargestFriction);
  const double length = std::hypot(n.x(), n.y());
  cone.columns << std::min(shadow, 1.0) * column(-n.y() / length, n.x() / length),
      column(n.x() / length, n.y() / length);
  cone.slope = std::max(shadow, 1.0);
  return cone;
}

/// The cones with their rows of the null space of all columns. No value: the rows lack rank.
struct Internal {
  std::vector<Cone> cones;
  Eigen::Index dimension = 0;
};

std::optional<Internal> internal_forces(const std::vector<Contact>& contacts,
                                        const std::vector<Eigen::Index>& rows, bool in_plane) {
  const double length_m = default_scales(contacts).length_m;
  std::vector<Contact> acting;
  acting.reserve(contacts.size());
  for (const auto& contact : contacts) acting.push_back(effective(contact, length_m));
  // Rank of the map as it is, each torsion column in the scale of its own contact.
  Internal internal;
  Eigen::Index columns = 0;
  const auto size = static_cast<Eigen::Index>(rows.size());
  Eigen::MatrixXd map(size, 0);
  const auto append = [](Eigen::MatrixXd& to, const Eigen::MatrixXd& more) {
    to.conservativeResize(Eigen::NoChange, to.cols() + more.cols());
    to.rightCols(more.cols()) = more;
  };
  for (const auto& contact : acting)
    append(map, scaled_grasp_map({contact}, rows, scales_of(contact, length_m)));
  if (criteria(map).rank < static_cast<int>(rows.size())) return std::nullopt;

  Eigen::MatrixXd scaled(size, 0);
  for (const auto& contact : acting) {
    auto cone = in_plane ? planar_cone(contact, length_m)
                         : std::optional(spatial_cone(contact, rows, length_m));
    if (!cone) continue;
    append(scaled, cone->columns);
    columns += cone->columns.cols();
    internal.cones.push_back(std::move(*cone));
  }
  internal.dimension = columns - size;
  const Eigen::MatrixXd Q =
      Eigen::HouseholderQR<Eigen::MatrixXd>(scaled.transpose()).householderQ();
  Eigen::Index row = 0;
  for (auto& cone : internal.cones) {
    cone.N = Q.block(row, size, cone.columns.cols(), internal.dimension);
    row += cone.columns.cols();
  }
  return internal;
}

/// Whether some x in three dimensions has A x > 0 in every row. If so, the sum of the extreme rays
/// of A x >= 0 is such an x; each of these rays is normal to two rows.
bool has_interior(std::vector<Vec3> A) {
  constexpr double kStrict = 1e-12;  // of unit vectors; well above the rounding of a sum of rays
  // Along a direction that is normal to all rows, x is free: one more row makes it go forward.
  Eigen::Matrix<double, Eigen::Dynamic, 3> rows(static_cast<Eigen::Index>(A.size()) + 1, 3);
  rows.row(0).setZero();
  for (std::size_t i = 0; i < A.size(); ++i)
    rows.row(static_cast<Eigen::Index>(i) + 1) = A[i].transpose();
  Eigen::FullPivLU<Eigen::MatrixXd> lu(rows);
  lu.setThreshold(kNegligible);
  if (lu.rank() < 3) {
    const Eigen::MatrixXd unseen = lu.kernel();
    for (Eigen::Index i = 0; i < unseen.cols(); ++i) A.emplace_back(unseen.col(i).normalized());
  }

  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 0; i < A.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      Vec3 ray = A[i].cross(A[j]);
      const double length = ray.norm();
      if (length == 0.0) continue;
      ray /= length;
      const double rounding = kStrict / length;  // nearly parallel rows: their normal is inexact
      for (const double sign : {-1.0, 1.0})
        if (std::all_of(A.begin(), A.end(),
                        [&](const Vec3& row) { return sign * row.dot(ray) >= -rounding; }))
          sum += sign * ray;
    }
  return sum.norm() > kStrict && std::all_of(A.begin(), A.end(), [&](const Vec3& row) {
           return row.dot(sum) > kStrict * sum.norm();
         });
}

/// A cone that the internal forces see as a wedge, as its two half-spaces: one of at most one
/// tangent, or one whose force depends on at most two internal forces. Then the form
/// q(z) = slope^2 g_n^2 - |g_t|^2 has one positive and one negative direction. None if the cone
/// holds no internal force inside.
std::vector<Vec3> wedge(const Cone& cone) {
  constexpr double kThin = 1e-7;  // half-angle; above the root of what rounding leaves of q
  if (cone.N.cols() == 0) return {};
  const Eigen::Index last = cone.N.rows() - 1;
  Eigen::VectorXd along = cone.slope * cone.N.row(last);
  Eigen::VectorXd across = Eigen::VectorXd::Zero(along.size());
  if (last == 1) across = cone.N.row(0);
  if (last > 1) {
    Eigen::VectorXd signs = Eigen::VectorXd::Constant(cone.N.rows(), -1.0);
    signs[last] = cone.slope * cone.slope;
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> form(cone.N.transpose() *
                                                              signs.asDiagonal() * cone.N);
    const Eigen::Index most = along.size() - 1;
    const double inward = along.dot(form.eigenvectors().col(most));
    along = std::copysign(std::sqrt(std::max(0.0, form.eigenvalues()[most])), inward) *
            form.eigenvectors().col(most);
    across = std::sqrt(std::max(0.0, -form.eigenvalues()[0])) * form.eigenvectors().col(0);
    if (along.norm() <= kThin * across.norm()) return {};
  }
  std::vector<Vec3> sides;
  for (const double sign : {-1.0, 1.0}) {
    Vec3 side = Vec3::Zero();
    side.head(along.size()) = along + sign * across;
    if (side.norm() < kNegligible) return {};
    sides.push_back(side.normalized());
  }
  return sides;
}

/// Every cone is a wedge (`wedge`) in at most three internal forces.
bool wedges_have_interior(const Internal& internal) {
  std::vector<Vec3> A;
  for (const auto& cone : internal.cones) {
    if (!cone.limited) continue;
    const auto sides = wedge(cone);
    if (sides.empty()) return false;
    A.insert(A.end(), sides.begin(), sides.end());
  }
  return has_interior(std::move(A));
}

/// Maximises the depth t of the cones, slope (g_n - t) >= |g_t| with all g_n adding up to 1, by
/// linear programs over half-spaces that hold the cones; the solution shows where the next
/// half-space has to touch. Its own depth bounds t from below, the program from above.
class CuttingPlanes {
 public:
  explicit CuttingPlanes(const Internal& internal) : internal_(internal) {
    glp_set_obj_dir(program_.get(), GLP_MAX);
    glp_add_cols(program_.get(), depth_column());
    for (int column = 1; column <= depth_column(); ++column)
      glp_set_col_bnds(program_.get(), column, GLP_FR, 0.0, 0.0);
    glp_set_obj_coef(program_.get(), depth_column(), 1.0);
  }

  [[nodiscard]] bool deeper_than(double enough) {
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(internal_.dimension);
    for (const auto& cone : internal_.cones)
      if (cone.limited) sum += cone.N.bottomRows(1).transpose();
    if (sum.norm() < kNegligible) return false;  // one presses only if another pulls
    add_row(sum, 0.0, GLP_FX, 1.0);
    for (const auto& cone : internal_.cones)
      for (Eigen::Index i = 0; i < cone.N.rows(); ++i)  // the last: g_n >= t
        for (const double sign : {-1.0, 1.0})
          add_half_space(cone, sign * Eigen::VectorXd::Unit(cone.N.rows(), i));

    constexpr int kMostRounds = 200;  // each halves the angle between cuts; 20 are usual
    for (int round = 0; round < kMostRounds; ++round) {
      const auto above = solve();
      if (!above || *above <= enough) return false;
      const Eigen::VectorXd z = internal_forces();
      double below = *above;
      for (const auto& cone : internal_.cones) {
        if (!cone.limited) continue;
        const Eigen::VectorXd g = cone.N * z;
        const Eigen::VectorXd tangential = g.head(g.size() - 1);
        const double length = tangential.norm();
        below = std::min(below, g[g.size() - 1] - length / cone.slope);
        if (length == 0.0) continue;
        Eigen::VectorXd direction = Eigen::VectorXd::Zero(g.size());
        direction.head(g.size() - 1) = tangential / length;
        add_half_space(cone, direction);
      }
      if (below > enough) return true;
    }
    return false;
  }

 private:
  [[nodiscard]] int depth_column() const { return static_cast<int>(internal_.dimension) + 1; }

  void add_row(const Eigen::VectorXd& of_z, double of_depth, int kind, double bound) {
    constexpr double kRounding = 1e-15;  // of a null space of unit vectors
    std::vector<int> columns(1);
    std::vector<double> values(1);  // the library counts from 1
    for (Eigen::Index i = 0; i < of_z.size(); ++i) {
      if (std::abs(of_z[i]) < kRounding) continue;
      columns.push_back(static_cast<int>(i) + 1);
      values.push_back(of_z[i]);
    }
    columns.push_back(depth_column());
    values.push_back(of_depth);
    const int row = glp_add_rows(program_.get(), 1);
    glp_set_row_bnds(program_.get(), row, kind, bound, 0.0);
    glp_set_mat_row(program_.get(), row, static_cast<int>(columns.size()) - 1, columns.data(),
                    values.data());
  }

  /// g_n - t >= direction . g / slope, of the tangential part of a unit vector.
  void add_half_space(const Cone& cone, Eigen::VectorXd direction) {
    if (!cone.limited) return;
    direction[direction.size() - 1] = 0.0;
    const Eigen::VectorXd row =
        cone.N.bottomRows(1).transpose() - cone.N.transpose() * direction / cone.slope;
    add_row(row, -1.0, GLP_LO, 0.0);
  }

  /// The optimum; no value if the library fails numerically. Then the answer is no, the safe one
  /// (never in 100,000 grasps with friction from 1e-9 to 1e20).
  [[nodiscard]] std::optional<double> solve() {
    constexpr double kTolerance = 1e-9;    // a tenth of the depth that is asked for
    constexpr int kMostIterations = 1000;  // some tens are usual; more is a cycle
    glp_smcp options;
    glp_init_smcp(&options);
    options.msg_lev = GLP_MSG_OFF;
    options.tol_bnd = options.tol_dj = kTolerance;
    options.it_lim = kMostIterations;
    // After a cut the old basis is still dual feasible. If that way cycles, start anew.
    for (const int method : {GLP_DUALP, GLP_PRIMAL}) {
      options.meth = method;
      glp_simplex(program_.get(), &options);
      if (glp_get_status(program_.get()) == GLP_OPT) return glp_get_obj_val(program_.get());
      glp_adv_basis(program_.get(), 0);
    }
    glp_exact(program_.get(), &options);  // rational numbers: slow, but without rounding
    if (glp_get_status(program_.get()) == GLP_OPT) return glp_get_obj_val(program_.get());
    return std::nullopt;
  }

  [[nodiscard]] Eigen::VectorXd internal_forces() const {
    Eigen::VectorXd z(internal_.dimension);
    for (Eigen::Index i = 0; i < z.size(); ++i)
      z[i] = glp_get_col_prim(program_.get(), static_cast<int>(i) + 1);
    return z;
  }

  /// The library keeps an environment for each thread, which prints. It is silent during the life
  /// of this object. An environment that this object has opened is closed with it; one of the
  /// caller stays.
  struct Environment {
    bool opened = glp_init_env() == 0;
    int printed = glp_term_out(GLP_OFF);
    Environment() = default;
    Environment(const Environment&) = delete;
    Environment& operator=(const Environment&) = delete;
    ~Environment() {
      glp_term_out(printed);
      if (opened) glp_free_env();
    }
  };
  Environment environment_;
  std::unique_ptr<glp_prob, decltype(&glp_delete_prob)> program_{glp_create_prob(),
                                                                 &glp_delete_prob};
  const Internal& internal_;
};

bool planar(const std::vector<Eigen::Index>& rows) {
  return rows == std::vector<Eigen::Index>{0, 1, 5};
}

}  // namespace

std::optional<bool> exact_force_closure(const std::vector<Contact>& contacts,
                                        const std::vector<Eigen::Index>& rows) {
  // Torsion about a normal in the plane has no part in Fx, Fy, Tz.
  const bool in_plane =
      planar(rows) && std::all_of(contacts.begin(), contacts.end(), [](const Contact& contact) {
        return contact.model == ContactModel::frictionless ||
               contact.model == ContactModel::point ||
               (contact.model == ContactModel::soft && std::abs(contact.R_OC(2, 2)) < kNegligible);
      });
  const auto internal = internal_forces(contacts, rows, in_plane);
  if (!internal) return false;
  if (internal->dimension <= 2 || (in_plane && internal->dimension == 3))
    return wedges_have_interior(*internal);
  // Three points push along the edges of their triangle: each force depends on two edges.
  if (internal->dimension == 3 && internal->cones.size() == 3 &&
      std::all_of(internal->cones.begin(), internal->cones.end(),
                  [](const Cone& cone) { return cone.columns.cols() == 3 && cone.limited; }))
    return wedges_have_interior(*internal);
  return std::nullopt;
}

bool force_closure_by_cuts(const std::vector<Contact>& contacts,
                           const std::vector<Eigen::Index>& rows) {
  constexpr double kInside = 1e-8;  // of the total normal force
  const auto internal = internal_forces(contacts, rows, false);
  if (!internal) return false;
  if (std::none_of(internal->cones.begin(), internal->cones.end(),
                   [](const Cone& cone) { return cone.limited; }))
    return true;
  return internal->dimension > 0 && CuttingPlanes(*internal).deeper_than(kInside);
}

bool force_closure(const std::vector<Contact>& contacts, const std::vector<Eigen::Index>& rows) {
  const auto exact = exact_force_closure(contacts, rows);
  return exact ? *exact : force_closure_by_cuts(contacts, rows);
}

}  // namespace isograsp
