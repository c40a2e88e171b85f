// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/config/platform.hpp"

namespace isograsp {

namespace {

Support support(const Vec3& p_PC, const Vec3& normal, const Vec3& tangent) {
  Support out;
  out.p_PC = p_PC;
  out.R_PC << tangent, normal.cross(tangent), normal;
  return out;
}

}  // namespace

Platform::Platform()
    : supports{support({-0.0325, 0.0, 0.0}, Vec3::UnitX(), Vec3::UnitY()),
               support({0.0325, 0.0125, 0.0}, -Vec3::UnitX(), Vec3::UnitY()),
               support({0.0325, -0.0125, 0.0}, -Vec3::UnitX(), Vec3::UnitY())} {}

Wrench net_wrench(const Platform& platform, const FingerWrenches& wrench_C) noexcept {
  Wrench sum;
  for (std::size_t f = 0; f < kFingerCount; ++f) {
    const Support& support = platform.supports[f];
    const Vec3 force_P = support.R_PC * wrench_C[f].force;
    sum.force += force_P;
    sum.torque += support.R_PC * wrench_C[f].torque + support.p_PC.cross(force_P);
  }
  return sum;
}

std::optional<Eigen::Vector2d> centre_of_pressure(const Wrench& wrench_C) noexcept {
  const double press_N = wrench_C.force.z();
  if (!(press_N > kLeastForceForPlace_N)) return std::nullopt;
  return Eigen::Vector2d(-wrench_C.torque.y() / press_N, wrench_C.torque.x() / press_N);
}

}  // namespace isograsp
