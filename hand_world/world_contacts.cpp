// SPDX-License-Identifier: GPL-3.0-or-later
// Which contacts a step has: geometry in the middle of the step, as it would be if nothing pulled;
// gaps are taken back to its begin.
#include <algorithm>
#include <array>

#include "hand_world/world.hpp"

namespace isograsp::hand_world {

using virtual_hand::Capsule;
using virtual_hand::capsule_contact;
using virtual_hand::CapsuleContact;
using virtual_hand::ObjectShape;

namespace {

/// Radius of the capsules around the metacarpals.
constexpr double kMetacarpal_m = 0.011;

/// The surfaces are farther apart than this, roughly.
double rough_gap(const Capsule& capsule, const ObjectShape& shape) noexcept {
  const Vec3 middle = 0.5 * (capsule.a + capsule.b);
  const double reach = 0.5 * (capsule.b - capsule.a).norm() + capsule.radius_m;
  return (middle.cwiseAbs() - shape.half_m).cwiseMax(0.0).norm() - reach;
}

Mat3 contact_axes(const Vec3& normal) noexcept {
  Mat3 axes;
  const Vec3 tangent = normal.unitOrthogonal();
  axes << normal, tangent, normal.cross(tangent);
  return axes;
}

}  // namespace

double PadLaw::bias_m_s(double gap_m, double step_s) noexcept {
  if (gap_m > 0.0) return gap_m / step_s;
  return std::max(kGiving_1_s * gap_m, -kMost_m_s);
}

ContactBlock& World::add_contact(std::size_t slot, const Vec3& p_W, const Vec3& normal_W,
                                 const Pose& X_WO) noexcept {
  frames_[solver_.size()] = {slot, p_W, contact_axes(normal_W)};
  const Mat3& R_WC = frames_[solver_.size()].R_WC;
  ContactBlock& block = solver_.add();
  const Vec3 arm_W = p_W - X_WO.p;
  const Mat3 R_OW = X_WO.q.conjugate().toRotationMatrix();
  for (Eigen::Index row = 0; row < 3; ++row) {
    const Vec3 axis = R_WC.col(row);
    block.rows.hub.block<1, 3>(row, kObjectPart) = axis.transpose();
    block.rows.hub.block<1, 3>(row, kObjectPart + 3) = (R_OW * arm_W.cross(axis)).transpose();
  }
  block.rows.hub.block<1, 3>(3, kObjectPart + 3) = (R_OW * normal_W).transpose();
  if (const Memory& was = memory_[slot]; was.there) {
    const Vec3 force = R_WC.transpose() * was.tangential_W;
    block.force = {was.normal_N, force.y(), force.z(), was.torque};
    block.slip_angle = was.slip_angle;
  }
  return block;
}

void World::add_hand_rows(ContactBlock& block, std::size_t part, const Vec3& p_W) const noexcept {
  const bool link = part < kLinks;
  const int digit = link ? static_cast<int>(part / kLinkCount) : HandBody::kPalm;
  const HandBody::PointRows rows = hand_->rows_of(digit, part % kLinkCount, p_W);
  const Mat3& R_WC = frames_[solver_.size() - 1].R_WC;
  block.rows.hub.block<3, 6>(0, kPalmPart) -= R_WC.transpose() * rows.palm;
  block.rows.hub.block<1, 3>(3, kPalmPart + 3) -= R_WC.col(0).transpose();
  if (!link) return;
  block.rows.leaf = digit;
  block.rows.on_leaf.topRows<3>() = -(R_WC.transpose() * rows.rates);
  block.rows.on_leaf.row(3) = -(R_WC.col(0).transpose() * rows.axes);
}

void World::find_hand_contacts(const Pose& X_WO, const ArrowVector& now, double step_s) noexcept {
  const virtual_hand::HandInSpace& hand = hand_->middle();
  const ObjectShape& shape = object_.body().shape;
  const Quat q_OW = X_WO.q.conjugate();
  for (DigitTouch& touch : touches_) {
    touch.contact = false;
    touch.normal_N = 0.0;
    touch.gap_m = kMargin_m;
  }
  if (through_) return;
  std::array<Near, kHandParts> near;
  std::size_t count = 0;
  const auto look = [&](std::size_t part, const Vec3& a_W, const Vec3& b_W, double radius_m) {
    const Capsule capsule{q_OW * (a_W - X_WO.p), q_OW * (b_W - X_WO.p), radius_m};
    if (rough_gap(capsule, shape) > kMargin_m) return;
    const CapsuleContact contact = capsule_contact(capsule, shape);
    if (contact.distance_m > kMargin_m) return;
    near[count++] = {part, contact.distance_m, X_WO.p + X_WO.q * contact.point,
                     X_WO.q * contact.normal};
  };
  for (std::size_t d = 0; d < kDigitCount; ++d) {
    const virtual_hand::DigitPose& digit = hand.digits[d];
    const auto& radii_m = hand_->model().digits[d].radii_m;
    if (silent_s_[d] <= 0.0)
      for (std::size_t k = 0; k < kLinkCount; ++k)
        look(d * kLinkCount + k, digit.joints[k], digit.joints[k + 1], radii_m[k]);
    if (d > 0) look(kLinks + d - 1, hand.metacarpals[d], digit.joints[0], kMetacarpal_m);
  }
  if (count > kHandContacts) {  // the deepest ones, in the order of their numbers
    const auto end = near.begin() + static_cast<std::ptrdiff_t>(count);
    const auto kept = near.begin() + static_cast<std::ptrdiff_t>(kHandContacts);
    std::nth_element(near.begin(), kept, end, [](const Near& a, const Near& b) {
      return a.gap_m != b.gap_m ? a.gap_m < b.gap_m : a.part < b.part;
    });
    std::sort(near.begin(), kept, [](const Near& a, const Near& b) { return a.part < b.part; });
    count = kHandContacts;
  }
  for (std::size_t k = 0; k < count; ++k) {
    const Near& at = near[k];
    ContactBlock& block = add_contact(at.part, at.p_W, at.normal_W, X_WO);
    add_hand_rows(block, at.part, at.p_W);
    const double gap_m = at.gap_m - 0.5 * step_s * block.rows.times(now)[0];
    block.bias_m_s = PadLaw::bias_m_s(gap_m, step_s);
    block.softness = PadLaw::kSoftness_m_N_s;
    block.friction = rules_.pad.friction;
    block.radius_m = rules_.pad.patch_radius_m;
    if (at.part >= kLinks) continue;
    DigitTouch& touch = touches_[at.part / kLinkCount];
    touch.gap_m = std::min(touch.gap_m, gap_m);
  }
}

void World::find_ground_contacts(const Pose& X_WO, const ArrowVector& now, double step_s) noexcept {
  const SupportPoints support = support_points(object_.body().shape, X_WO);
  const std::size_t first = solver_.size();
  Vec3 weighed_W = Vec3::Zero();
  Vec3 sum_W = Vec3::Zero();
  double weight_N = 0.0;
  for (std::size_t k = 0; k < support.count; ++k) {
    const SupportPoint& point = support.points[k];
    const double mid_gap_m = point.p_W.y() - ground_->height_below(point.p_W);
    if (mid_gap_m > kMargin_m) continue;
    const std::size_t slot = kHandParts + static_cast<std::size_t>(point.number);
    ContactBlock& block = add_contact(slot, point.p_W, Vec3::UnitY(), X_WO);
    block.law = support.base ? ContactBlock::Law::rest : ContactBlock::Law::touch;
    block.bias_m_s = PadLaw::bias_m_s(mid_gap_m - 0.5 * step_s * block.rows.times(now)[0], step_s);
    block.softness = PadLaw::kSoftness_m_N_s;
    block.friction = rules_.ground_friction;
    sum_W += point.p_W;
    weighed_W += block.force[0] * point.p_W;
    weight_N += block.force[0];
  }
  const std::size_t last = solver_.size();
  if (!support.base || first == last) return;
  // A base rubs as a disk about where its pressure was in the last step.
  const auto& shape = object_.body().shape;
  const Vec3 middle_W = sum_W / static_cast<double>(last - first);
  const Vec3 pressed_W = weight_N > 0.0 ? Vec3(weighed_W / weight_N) : middle_W;
  const double half_z = (X_WO.q * Vec3::UnitZ()).y() > 0.0 ? -shape.half_m.z() : shape.half_m.z();
  const Vec3 centre_W = X_WO.p + X_WO.q * Vec3(0.0, 0.0, half_z);
  ContactBlock& base = add_contact(kBase, pressed_W, Vec3::UnitY(), X_WO);
  base.law = ContactBlock::Law::base;
  base.rows.hub.row(0).setZero();
  base.force[0] = 0.0;
  base.friction = rules_.ground_friction;
  base.radius_m = std::max(0.0, shape.half_m.x() - (pressed_W - centre_W).norm());
  base.first = first;
  base.last = last;
}

void World::press_pads(const Pose& X_WO) noexcept {
  for (std::size_t k = 0; k < pad_count_; ++k) {
    const FixedPad& pad = pads_[k];
    ContactBlock& block = add_contact(kBase + 1 + k, pad.p_W, pad.normal_W, X_WO);
    block.law = ContactBlock::Law::press;
    block.given_N = pad.force_N;
    block.force[0] = pad.force_N;
    block.friction = rules_.pad.friction;
    block.radius_m = rules_.pad.patch_radius_m;
  }
}

void World::remember(const Pose& X_WO) noexcept {
  for (Memory& memory : memory_) memory.there = false;
  supported_ = false;
  const Quat q_OW = X_WO.q.conjugate();
  for (std::size_t i = 0; i < solver_.size(); ++i) {
    const ContactBlock& block = solver_.blocks()[i];
    const Frame& frame = frames_[i];
    memory_[frame.slot] = {true, block.force[0],
                           frame.R_WC.col(1) * block.force[1] + frame.R_WC.col(2) * block.force[2],
                           block.force[3], block.slip_angle};
    if (frame.slot >= kHandParts && frame.slot < kBase) supported_ = true;
    if (!(block.force[0] > 0.0)) continue;
    if (frame.slot >= kLinks) continue;
    const std::size_t d = frame.slot / kLinkCount;
    const std::size_t link = frame.slot % kLinkCount;
    DigitTouch& touch = touches_[d];
    // Links come from the palm on: of equal forces the more distal one counts.
    if (touch.contact && block.force[0] < touch.normal_N) continue;
    touched_[d] = true;
    touch.contact = true;
    touch.normal_N = block.force[0];
    const virtual_hand::DigitPose& digit = hand_->middle().digits[d];
    touch.at = {link, digit.links[link].conjugate() * (frame.p_W - digit.joints[link]),
                q_OW * (frame.p_W - X_WO.p), q_OW * frame.R_WC.col(0), q_OW * digit.links[link]};
  }
}

}  // namespace isograsp::hand_world
