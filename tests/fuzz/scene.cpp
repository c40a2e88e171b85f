// SPDX-License-Identifier: GPL-3.0-or-later
// Scene files: what is accepted is a body that can move, for both hands.
#include "grasp_model/scene.hpp"

#include "tests/fuzz/support.hpp"

using namespace isograsp;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr double kRounding = 1e-9;  // a rotation is a few products of numbers up to 1
  const auto text = fuzz::as_text(data, size);
  const auto scene = parse_scene(text, "scene.toml");
  if (!scene) {
    fuzz::require_helpful(scene.error(), text);
    return 0;
  }
  for (std::size_t dof = 0; dof < 6; ++dof) {
    const auto axis = static_cast<Eigen::Index>(dof);
    const double inertia = dof < 3 ? scene->mass_kg : scene->inertia_kg_m2[axis % 3];
    fuzz::require(inertia >= 0.0 && (!scene->free[dof] || inertia + scene->damping[axis] > 0.0),
                  "what can move has inertia or damping");
  }
  fuzz::require(scene->stiffness.allFinite() && (scene->stiffness.array() >= 0.0).all() &&
                    scene->damping.allFinite() && (scene->damping.array() >= 0.0).all(),
                "springs and dampers make no energy");
  for (const auto& R : {scene->R_WK, scene->R_WD})
    fuzz::require((R * R.transpose()).isIdentity(kRounding), "axes are perpendicular");
  const Scene left = for_hand(*scene, Hand::left);
  const Scene back = for_hand(left, Hand::left);
  for (std::size_t i = 0; i < scene->contacts.size(); ++i) {
    const Contact& contact = scene->contacts[i];
    fuzz::require(
        (contact.R_OC * contact.R_OC.transpose()).isIdentity(kRounding) &&
            (left.contacts[i].R_OC * left.contacts[i].R_OC.transpose()).isIdentity(kRounding),
        "a contact has a frame");
    fuzz::require(back.contacts[i].p_OC == contact.p_OC, "turning the device twice is nothing");
  }
  return 0;
}
