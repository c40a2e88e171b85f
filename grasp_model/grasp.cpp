// SPDX-License-Identifier: GPL-3.0-or-later
#include "grasp_model/grasp.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/SVD>

namespace isograsp {

namespace {

Eigen::Index columns_of(ContactModel model) {
  return model == ContactModel::frictionless ? 1 : model == ContactModel::point ? 3 : 4;
}

/// Scaled rows of G: torque rows by 1 / length, the torsion column of contact i by torsion[i].
Eigen::MatrixXd scaled_rows(const std::vector<Contact>& contacts,
                            const std::vector<Eigen::Index>& rows, double length_m,
                            const std::vector<double>& torsion_m) {
  const GraspMatrix G = grasp_map(contacts);
  Eigen::MatrixXd scaled(static_cast<Eigen::Index>(rows.size()), G.cols());
  for (std::size_t r = 0; r < rows.size(); ++r)
    scaled.row(static_cast<Eigen::Index>(r)) = G.row(rows[r]) / (rows[r] < 3 ? 1.0 : length_m);
  Eigen::Index column = 0;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    column += columns_of(contacts[i].model);
    if (contacts[i].model == ContactModel::soft) scaled.col(column - 1) *= torsion_m[i];
  }
  return scaled;
}

/// Singular values below this are rounding.
double zero_below(const Eigen::VectorXd& singular_values, Eigen::Index columns) {
  constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
  const double largest = singular_values.size() == 0 ? 0.0 : singular_values[0];
  return 6.0 * kEpsilon * largest * static_cast<double>(std::max<Eigen::Index>(6, columns));
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
    if (contact.model == ContactModel::soft) names.push_back(finger + "_tz");
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

Criteria criteria(const std::vector<Contact>& contacts, const std::vector<Eigen::Index>& rows,
                  const Scales& scales) {
  const Eigen::MatrixXd G = scaled_rows(contacts, rows, scales.length_m,
                                        std::vector<double>(contacts.size(), scales.torsion_m));
  Criteria result;
  result.singular_values.assign(rows.size(), 0.0);
  if (G.cols() == 0) return result;
  const Eigen::VectorXd values = Eigen::JacobiSVD<Eigen::MatrixXd>(G).singularValues();
  const double zero = zero_below(values, G.cols());
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

namespace {

/// Contacts as second-order cones: mu f_z >= |(f_x, f_y, scaled t_z)|; f_z >= 0 without friction.
struct Cone {
  Eigen::Index first = 0;  ///< column of its first force coordinate
  Eigen::Index tangents = 0;
  Eigen::Index normal = 0;
  double slope = 1.0;  ///< mu; 1 without friction
};

/// The greatest t for which f = f0 + N z has every cone by t inside: mu f_z - t >= |f_t|. Stops
/// early when t > enough. Newton on the logarithmic barrier, from a strictly feasible start.
double deepest(const std::vector<Cone>& cones, const Eigen::VectorXd& f0, const Eigen::MatrixXd& N,
               double enough) {
  const Eigen::Index unknowns = N.cols() + 1;  // z, t
  // Each cone's (slack, tangents) is affine in the unknowns.
  std::vector<Eigen::MatrixXd> slope;
  std::vector<Eigen::VectorXd> start;
  double t0 = std::numeric_limits<double>::infinity();
  for (const auto& cone : cones) {
    Eigen::MatrixXd B = Eigen::MatrixXd::Zero(1 + cone.tangents, unknowns);
    Eigen::VectorXd b(1 + cone.tangents);
    B.row(0).head(N.cols()) = cone.slope * N.row(cone.normal);
    B(0, N.cols()) = -1.0;
    b[0] = cone.slope * f0[cone.normal];
    Eigen::Index row = 1;
    for (Eigen::Index i = 0; i <= cone.tangents; ++i) {
      if (cone.first + i == cone.normal) continue;
      B.row(row).head(N.cols()) = N.row(cone.first + i);
      b[row++] = f0[cone.first + i];
    }
    t0 = std::min(t0, b[0] - b.tail(cone.tangents).norm());
    slope.push_back(std::move(B));
    start.push_back(std::move(b));
  }
  if (N.cols() == 0) return t0;
  Eigen::VectorXd y = Eigen::VectorXd::Zero(unknowns);
  y[N.cols()] = t0 - 1.0;

  const auto cost = [&](const Eigen::VectorXd& at, double weight) {
    double value = -weight * at[N.cols()];
    for (std::size_t i = 0; i < cones.size(); ++i) {
      const Eigen::VectorXd w = slope[i] * at + start[i];
      const double tangential = w.tail(w.size() - 1).norm();
      if (!(w[0] > tangential)) return std::numeric_limits<double>::infinity();
      value -= std::log(w[0] - tangential) + std::log(w[0] + tangential);
    }
    return value;
  };
  constexpr double kLastWeight = 1e10;  // leaves t short of its optimum by 2 cones / weight
  for (double weight = 1.0; weight <= kLastWeight; weight *= 5.0) {
    for (int iteration = 0; iteration < 50; ++iteration) {
      Eigen::VectorXd gradient = Eigen::VectorXd::Zero(unknowns);
      Eigen::MatrixXd hessian = Eigen::MatrixXd::Zero(unknowns, unknowns);
      gradient[N.cols()] = -weight;
      for (std::size_t i = 0; i < cones.size(); ++i) {
        Eigen::VectorXd w = slope[i] * y + start[i];
        const double tangential = w.tail(w.size() - 1).norm();
        const double depth = (w[0] - tangential) * (w[0] + tangential);
        w.tail(w.size() - 1) *= -1.0;
        Eigen::MatrixXd H = 4.0 / (depth * depth) * w * w.transpose();
        H.diagonal().array() += 2.0 / depth;
        H(0, 0) -= 4.0 / depth;
        gradient -= 2.0 / depth * slope[i].transpose() * w;
        hessian += slope[i].transpose() * H * slope[i];
      }
      const Eigen::VectorXd direction = -hessian.ldlt().solve(gradient);
      const double decrement = -gradient.dot(direction);
      if (!(decrement > 1e-10)) break;
      const double here = cost(y, weight);
      double length = 1.0;
      while (length > 1e-12 &&
             !(cost(y + length * direction, weight) < here - 1e-4 * length * decrement))
        length *= 0.5;
      if (length <= 1e-12) break;
      y += length * direction;
    }
    if (y[N.cols()] > enough) break;
  }
  return y[N.cols()];
}

/// The contact as its friction lets it act: without friction there is nothing tangential.
Contact effective(Contact contact) {
  if (contact.model == ContactModel::soft && contact.torsion_m == 0.0)
    contact.model = ContactModel::point;
  if (contact.friction == 0.0) contact.model = ContactModel::frictionless;
  return contact;
}

}  // namespace

bool force_closure(const std::vector<Contact>& contacts, const std::vector<Eigen::Index>& rows) {
  std::vector<Contact> acting;
  std::vector<double> torsion_m;
  std::vector<Cone> cones;
  Eigen::Index column = 0;
  for (const auto& contact : contacts) {
    acting.push_back(effective(contact));
    const ContactModel model = acting.back().model;
    torsion_m.push_back(model == ContactModel::soft ? contact.torsion_m / contact.friction : 1.0);
    const auto width = columns_of(model);
    cones.push_back(
        {column, width - 1, width == 1 ? column : column + 2, width == 1 ? 1.0 : contact.friction});
    column += width;
  }
  if (acting.empty()) return false;
  const Eigen::MatrixXd G = scaled_rows(acting, rows, default_scales(acting).length_m, torsion_m);
  const Eigen::VectorXd values = Eigen::JacobiSVD<Eigen::MatrixXd>(G).singularValues();
  if (values.size() < G.rows() || values[G.rows() - 1] <= zero_below(values, G.cols()))
    return false;

  // Internal forces with a total normal force of 1: G f = 0, sum f_z = 1.
  Eigen::MatrixXd A(G.rows() + 1, G.cols());
  A.topRows(G.rows()) = G;
  A.row(G.rows()).setZero();
  for (const auto& cone : cones) A(G.rows(), cone.normal) = 1.0;
  Eigen::VectorXd one = Eigen::VectorXd::Unit(G.rows() + 1, G.rows());
  Eigen::JacobiSVD<Eigen::MatrixXd> svd(A, Eigen::ComputeFullU | Eigen::ComputeFullV);
  constexpr double kConsistent = 1e-9;
  svd.setThreshold(kConsistent);
  const Eigen::VectorXd f0 = svd.solve(one);
  if ((A * f0 - one).norm() > kConsistent) return false;
  const Eigen::MatrixXd N = svd.matrixV().rightCols(G.cols() - svd.rank());
  constexpr double kInside = 1e-8;  // of the total normal force; above the barrier's own error
  return deepest(cones, f0, N, kInside) > kInside;
}

bool opposition(const std::vector<Contact>& contacts) {
  constexpr double kCosine = -0.5;  // of 120 degrees
  for (std::size_t i = 0; i < contacts.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (contacts[i].R_OC.col(2).dot(contacts[j].R_OC.col(2)) < kCosine) return true;
  return false;
}

bool grasp_rule_holds(const Scene& scene, unsigned mask) {
  if (scene.grasp_rule == GraspRule::any) return true;
  std::vector<Contact> touching;
  for (const auto& contact : scene.contacts)
    if ((mask >> index_of(contact.finger) & 1u) != 0) touching.push_back(contact);
  return scene.grasp_rule == GraspRule::opposition ? opposition(touching)
                                                   : force_closure(touching, rows_of(scene));
}

}  // namespace isograsp
