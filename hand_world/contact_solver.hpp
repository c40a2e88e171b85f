// SPDX-License-Identifier: GPL-3.0-or-later
// Forces of all contacts at the end of a step: block Gauss-Seidel, each contact a block of normal
// force, two tangential forces and torque about the normal, with the exact friction of a disk
// (docs/virtual_hand.md, "Contacts"). The same contacts in the same order give the same bits.
// Real-time safe. SI units.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "hand_world/arrow.hpp"

namespace isograsp::hand_world {

/// One contact. Rows: velocity of the object against the other body along the normal (into the
/// object), two tangents, and turning about the normal.
struct ContactBlock {
  enum class Law : std::uint8_t {
    touch,  ///< normal force and friction
    press,  ///< the normal force is given, friction answers
    rest,   ///< normal force without friction
    base    ///< friction of the sum of the normal forces of the blocks first … last - 1
  };
  Law law = Law::touch;
  ArrowRows rows;
  double bias_m_s = 0.0;  ///< of the normal velocity: how fast the gap may close or must open
  double softness = 0.0;  ///< of the pad [m/(N s)]
  double friction = 0.0;  ///< mu
  double radius_m = 0.0;  ///< of the disk that rubs
  double given_N = 0.0;   ///< of `press`
  std::size_t first = 0;  ///< of `base`
  std::size_t last = 0;
  /// Normal force, tangential forces [N], torque about the normal [N m]. In: where to begin.
  Eigen::Vector4d force = Eigen::Vector4d::Zero();
  double slip_angle = 0.5;  ///< of the friction; in: a guess
};

struct SolverReport {
  int sweeps = 0;
  double residual_m_s = 0.0;  ///< by which the last sweep still changed the velocity of a contact
};

class ContactSolver {
 public:
  static constexpr std::size_t kMost = 28;      ///< contacts
  static constexpr int kSweeps = 50;            ///< at most
  static constexpr double kSettled_m_s = 1e-6;  ///< a sweep that changes less is the last; the
                                                ///< next step goes on from there

  void clear() noexcept { count_ = 0; }
  [[nodiscard]] std::size_t size() const noexcept { return count_; }
  /// A new block. @pre size() < kMost
  ContactBlock& add() noexcept { return blocks_[count_++] = ContactBlock{}; }
  [[nodiscard]] std::span<const ContactBlock> blocks() const noexcept {
    return {blocks_.data(), count_};
  }
  [[nodiscard]] std::span<ContactBlock> blocks() noexcept { return {blocks_.data(), count_}; }

  /// Finds the forces. `free`: velocities at the end of the step without contacts.
  SolverReport solve(const FactoredArrow& matrix, const ArrowVector& free, double step_s) noexcept;
  /// Adds the pull of all contacts on the coordinates.
  void add_forces(ArrowVector& to) const noexcept;

 private:
  struct Local {
    Eigen::Vector4d velocity;  ///< with all forces as they are
    Eigen::Matrix4d sticks;    ///< inverse of compliance and softness
    double per_force = 0.0;    ///< majorant of the friction's own compliance, isotropic
    double per_torque = 0.0;
  };
  void prepare(std::size_t i) noexcept;
  [[nodiscard]] double normal_load(const ContactBlock& block) const noexcept;
  [[nodiscard]] Eigen::Vector4d solve_block(std::size_t i, const Eigen::Vector4d& without) noexcept;
  void rub(std::size_t i, double load_N, const Eigen::Vector4d& without,
           Eigen::Vector4d& force) noexcept;

  std::size_t count_ = 0;
  std::array<ContactBlock, kMost> blocks_;
  std::array<Local, kMost> locals_;
  std::array<FactoredArrow::Reduced, kMost> reduced_;
  /// Velocity of contact i for each newton of contact j.
  std::array<std::array<Eigen::Matrix4d, kMost>, kMost> compliance_;
};

}  // namespace isograsp::hand_world
