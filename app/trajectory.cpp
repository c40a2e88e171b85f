// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/trajectory.hpp"

#include <array>

#include "app/console.hpp"

namespace isograsp::app {

namespace {

constexpr std::string_view kStateHeader =
    "t_s,x_m,y_m,z_m,qw,qx,qy,qz,vx_mps,vy_mps,vz_mps,wx_radps,wy_radps,wz_radps,"
    "fx_N,fy_N,fz_N,tx_Nm,ty_Nm,tz_Nm";
constexpr std::size_t kNumbers = 20;

}  // namespace

TrajectoryWriter::TrajectoryWriter(FileWriter file, std::span<const std::string> contacts)
    : file_(std::move(file)) {
  std::string head(kStateHeader);
  for (const std::string& name : contacts) head += "," + name;
  file_.write(head + "\n");
}

void TrajectoryWriter::add(double t_s, const ObjectState& state, const Wrench& F_O_W,
                           std::span<const bool> touching) {
  const Vec3& p = state.X_WO.p;
  const Quat& q = state.X_WO.q;
  const Vec3& v = state.v_WO_W;
  const Vec3& w = state.w_WO_W;
  const Vec3& f = F_O_W.force;
  const Vec3& tau = F_O_W.torque;
  const std::array<double, kNumbers> numbers{t_s,   p.x(), p.y(), p.z(),   q.w(),   q.x(),  q.y(),
                                             q.z(), v.x(), v.y(), v.z(),   w.x(),   w.y(),  w.z(),
                                             f.x(), f.y(), f.z(), tau.x(), tau.y(), tau.z()};
  const std::size_t longest_row = kNumbers * (kLongestNumber + 1) + 2 * touching.size();
  if (block_.size() - used_ < longest_row) flush();
  char* at = block_.data() + used_;
  for (const double number : numbers) {
    at = print_number(at, number);
    *at++ = ',';
  }
  for (const bool touches : touching) {
    *at++ = touches ? '1' : '0';
    *at++ = ',';
  }
  at[-1] = '\n';
  used_ = static_cast<std::size_t>(at - block_.data());
}

Result<void> TrajectoryWriter::commit() {
  flush();
  return file_.commit();
}

void TrajectoryWriter::flush() {
  file_.write({block_.data(), used_});
  used_ = 0;
}

void HoldCount::print_notes() const {
  if (frozen > 0)
    print_note("the state stood still in %1 of %2 holds: no valid sample for over 50 ms"_text(
        frozen, all));
  if (inexact > 0)
    print_note(
        "%1 of %2 holds were too stiff for the stated tolerance; the trajectory is finite there "
        "but not exact"_text(inexact, all));
}

}  // namespace isograsp::app
