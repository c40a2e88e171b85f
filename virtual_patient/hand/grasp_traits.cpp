// SPDX-License-Identifier: GPL-3.0-or-later
#include "virtual_patient/hand/grasp_traits.hpp"

#include <array>

namespace isograsp::virtual_patient {

namespace {

using Grasper = GraspTraits;

// The ranges find mistakes (millimetres for metres), not unusual people.
constexpr std::array kGraspFields{
    GraspTraitField{"visual_delay_s", &Grasper::visual_delay_s, 0.02, 0.9},
    GraspTraitField{"reaction_s", &Grasper::reaction_s, 0.05, 5.0},
    GraspTraitField{"sight_m", &Grasper::sight_m, 0.0, 0.05},
    GraspTraitField{"sight_rad", &Grasper::sight_rad, 0.0, 0.5},
    GraspTraitField{"aim_m", &Grasper::aim_m, 0.0, 0.1},
    GraspTraitField{"aim_rad", &Grasper::aim_rad, 0.0, 1.0},
    GraspTraitField{"reach_s", &Grasper::reach_s, 0.2, 20.0},
    GraspTraitField{"place_m", &Grasper::place_m, 0.0, 0.05},
    GraspTraitField{"close_s", &Grasper::close_s, 0.1, 10.0},
    GraspTraitField{"open_s", &Grasper::open_s, 0.1, 20.0},
    GraspTraitField{"squeeze_m", &Grasper::squeeze_m, 0.0, 0.03},
    GraspTraitField{"harder_m", &Grasper::harder_m, 0.0, 0.01},
    GraspTraitField{"squeeze_sd_m", &Grasper::squeeze_sd_m, 0.0, 0.01},
    GraspTraitField{"opening_m", &Grasper::opening_m, 0.0, 0.2},
    GraspTraitField{"spare_m", &Grasper::spare_m, 0.0, 0.1},
    GraspTraitField{"tracker_delay_s", &Grasper::tracker_delay_s, 0.0, 0.5},
    GraspTraitField{"tracker_m", &Grasper::tracker_m, 0.0, 0.02},
    GraspTraitField{"wander_m", &Grasper::wander_m, 0.0, 0.05},
    GraspTraitField{"wander_Hz", &Grasper::wander_Hz, 0.01, 20.0},
    GraspTraitField{"lost_share", &Grasper::lost_share, 0.0, 0.9},
    GraspTraitField{"lost_least_s", &Grasper::lost_least_s, 0.0, 10.0},
    GraspTraitField{"lost_most_s", &Grasper::lost_most_s, 0.0, 10.0},
    GraspTraitField{"size_error", &Grasper::size_error, 0.0, 0.3},
};

constexpr std::array<std::string_view, 2> kGrasperNames{"healthy", "paretic"};

}  // namespace

std::span<const GraspTraitField> grasp_trait_fields() noexcept {
  return kGraspFields;
}

std::span<const std::string_view> grasper_names() noexcept {
  return kGrasperNames;
}

std::optional<GraspTraits> grasp_traits(std::string_view name) noexcept {
  GraspTraits traits;
  if (name == "healthy") return traits;
  if (name != "paretic") return std::nullopt;
  // Seen and decided later, moved more slowly and less exactly, unsteady, opens late and little.
  traits.visual_delay_s = 0.25;
  traits.reaction_s = 0.5;
  traits.aim_m = 0.006;
  traits.aim_rad = 0.1;
  traits.reach_s = 1.8;
  traits.place_m = 0.005;
  traits.close_s = 0.9;
  traits.open_s = 1.2;
  traits.squeeze_sd_m = 0.002;
  traits.opening_m = 0.105;
  traits.spare_m = 0.025;
  traits.wander_m = 0.006;
  return traits;
}

}  // namespace isograsp::virtual_patient
