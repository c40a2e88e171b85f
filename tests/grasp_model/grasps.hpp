// SPDX-License-Identifier: GPL-3.0-or-later
// Grasps for the tests of grasp map and closure: the golden ones, and random ones.
#pragma once

#include <array>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "grasp_model/grasp.hpp"
#include "tests/grasp_model/support.hpp"

namespace isograsp::test {

inline const std::map<std::string, ContactModel> kModels{{"FL", ContactModel::frictionless},
                                                         {"PCWF", ContactModel::point},
                                                         {"SF", ContactModel::soft},
                                                         {"FULL", ContactModel::bonded}};
inline const std::vector<Eigen::Index> kAllRows{0, 1, 2, 3, 4, 5};
inline const std::vector<Eigen::Index> kPlanarRows{0, 1, 5};

/// A contact that presses along `normal`, with any tangent.
inline Contact contact_at(const Vec3& p_OC, const Vec3& normal, ContactModel model, double friction,
                          double torsion_m = 0.0) {
  Contact contact;
  contact.p_OC = p_OC;
  const Vec3 z = normal.normalized();
  contact.R_OC << z.unitOrthogonal(), z.cross(z.unitOrthogonal()), z;
  contact.model = model;
  contact.friction = friction;
  contact.torsion_m = torsion_m;
  return contact;
}

struct GoldenGrasp {
  std::vector<Contact> contacts;
  std::vector<double> force_coordinates;
};

/// By "case type".
inline std::map<std::string, GoldenGrasp> golden_grasps() {
  std::map<std::string, GoldenGrasp> cases;
  for (const auto& row : golden("grasp_contacts.csv")) {
    Contact contact;
    contact.finger = kFingers[static_cast<std::size_t>(row["i"]) % kFingerCount];
    contact.p_OC = row.vec3("px_m", "py_m", "pz_m");
    contact.R_OC = Quat(row["qw"], row["qx"], row["qy"], row["qz"]).normalized().toRotationMatrix();
    contact.model = kModels.at(row.text("type"));
    auto& one = cases[row.text("case") + " " + row.text("type")];
    one.contacts.push_back(contact);
    const Eigen::Index coordinates = contact_columns(contact).cols();
    for (Eigen::Index i = 0; i < coordinates; ++i)
      one.force_coordinates.push_back(row["f" + std::to_string(i)]);
  }
  return cases;
}

/// Random contacts, the same on every machine.
class RandomGrasps {
 public:
  explicit RandomGrasps(std::uint64_t seed) : bits_(seed) {}

  double uniform(double least, double most) {
    return least + (most - least) * (static_cast<double>(bits_() >> 11) * 0x1p-53);
  }
  Vec3 direction() {
    while (true) {
      const Vec3 v(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1));
      if (v.norm() < 1.0 && v.norm() > 0.1) return v.normalized();
    }
  }
  Mat3 rotation() { return frame(direction()); }
  /// A frame about this normal.
  Mat3 frame(const Vec3& normal) {
    const Vec3 x = Eigen::AngleAxisd(uniform(-3.14, 3.14), normal) * normal.unitOrthogonal();
    Mat3 R;
    R << x, normal.cross(x), normal;
    return R;
  }
  /// On a ball of 30 mm, pressing more or less towards its middle; in the plane of x and y or not.
  Contact contact(ContactModel model, bool in_plane = false) {
    Contact contact;
    contact.model = model;
    contact.p_OC = 0.03 * direction();
    Vec3 normal = (0.7 * direction() - contact.p_OC.normalized()).normalized();
    if (in_plane) normal = Vec3(normal.x(), normal.y(), 0.0).normalized();
    contact.R_OC = frame(normal);
    if (in_plane) contact.R_OC.row(2).tail<1>().setZero();
    contact.friction = std::exp(uniform(-2.5, 1.0));
    contact.torsion_m = 0.006 * contact.friction;
    return contact;
  }
  std::vector<Contact> grasp(const std::vector<ContactModel>& models, bool in_plane = false) {
    std::vector<Contact> contacts;
    for (const auto model : models) contacts.push_back(contact(model, in_plane));
    return contacts;
  }

 private:
  std::mt19937_64 bits_;
};

/// The same contacts with friction (and torsion) times a factor.
inline std::vector<Contact> with_friction(std::vector<Contact> contacts, double factor) {
  for (auto& contact : contacts) {
    contact.friction *= factor;
    contact.torsion_m *= factor;
  }
  return contacts;
}

}  // namespace isograsp::test
