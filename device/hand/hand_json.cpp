// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/hand/hand_json.hpp"

#include <algorithm>
#include <bitset>
#include <cmath>
#include <limits>

#include <nlohmann/json.hpp>

namespace isograsp {

namespace {

constexpr double kFarthestJoint_m = 100.0;
constexpr double kLatestTime_s = 1e12;  // seconds since 1970 in a script that uses them: 2e9

using Seen = std::bitset<kHandJointCount>;

/// Whether a joint is one that a model of 21 points does not have.
bool is_extra(std::size_t joint) noexcept {
  if (joint == kPalmJoint) return true;
  for (const Digit digit : {Digit::index, Digit::middle, Digit::ring, Digit::little})
    if (joint == metacarpal_joint_of(digit)) return true;
  return false;
}

/// False: it is neither a place nor null.
bool read_place(const nlohmann::json& value, Vec3& p) {
  if (value.is_null()) return true;
  if (!value.is_array() || value.size() != 3) return false;
  for (std::size_t a = 0; a < 3; ++a) {
    if (value[a].is_null()) return p.fill(std::numeric_limits<double>::quiet_NaN()), true;
    if (!value[a].is_number()) return false;
    p[static_cast<Eigen::Index>(a)] = value[a].get<double>();
  }
  return p.cwiseAbs().maxCoeff() <= kFarthestJoint_m;
}

/// False: they are not 21, 26 or none.
bool read_joints(const nlohmann::json& joints, HandFrame& frame) {
  Seen seen;
  for (const auto& [name, value] : joints.items()) {
    const auto known = std::find(kHandJointNames.begin(), kHandJointNames.end(), name);
    if (known == kHandJointNames.end()) return false;
    const auto joint = static_cast<std::size_t>(known - kHandJointNames.begin());
    if (!read_place(value, frame.joints[joint])) return false;
    seen.set(joint);
  }
  frame.tracked = seen.any();
  if (seen.none() || seen.all()) return true;
  for (std::size_t joint = 0; joint < kHandJointCount; ++joint)
    if (seen[joint] == is_extra(joint)) return false;
  return true;
}

}  // namespace

std::optional<HandFrame> parse_hand_json(std::string_view message) {
  if (message.size() > kLongestHandJson) return std::nullopt;
  const auto json = nlohmann::json::parse(message, nullptr, false);
  if (!json.is_object()) return std::nullopt;
  const auto time = json.find("t_s");
  const auto side = json.find("hand");
  const auto joints = json.find("joints");
  if (time == json.end() || !time->is_number() || side == json.end() || !side->is_string() ||
      joints == json.end() || !joints->is_object())
    return std::nullopt;
  HandFrame frame;
  frame.joints.fill(Vec3::Constant(std::numeric_limits<double>::quiet_NaN()));
  frame.t_s = time->get<double>();
  if (!(std::abs(frame.t_s) <= kLatestTime_s)) return std::nullopt;
  const auto hand = hand_from_name(side->get_ref<const std::string&>());
  if (!hand || !read_joints(*joints, frame)) return std::nullopt;
  frame.side = *hand;
  frame.confidence = frame.tracked ? 1.0 : 0.0;
  if (const auto told = json.find("confidence"); told != json.end()) {
    if (!told->is_number()) return std::nullopt;
    frame.confidence = told->get<double>();
    if (!(frame.confidence >= 0.0 && frame.confidence <= 1.0)) return std::nullopt;
  }
  return frame;
}

std::string hand_json(const HandFrame& frame) {
  auto joints = nlohmann::ordered_json::object();
  bool extra = false;
  for (std::size_t joint = 0; joint < kHandJointCount; ++joint)
    extra = extra || (is_extra(joint) && frame.joints[joint].allFinite());
  for (std::size_t joint = 0; joint < kHandJointCount; ++joint) {
    if (!frame.tracked || (is_extra(joint) && !extra)) continue;
    const Vec3& p = frame.joints[joint];
    auto& place = joints[std::string(kHandJointNames[joint])];  // null: not given
    if (p.allFinite()) place = {p.x(), p.y(), p.z()};
  }
  return nlohmann::ordered_json{{"t_s", frame.t_s},
                                {"hand", name_of(frame.side)},
                                {"confidence", frame.confidence},
                                {"joints", std::move(joints)}}
      .dump();
}

}  // namespace isograsp
