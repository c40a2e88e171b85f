// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/hand/leap_json.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include <nlohmann/json.hpp>

namespace isograsp {

namespace {

using Json = nlohmann::json;

constexpr double kMillimetre = 1e-3;
constexpr double kMicrosecond = 1e-6;
/// From the middle of the palm to the wrist, where the service does not tell it.
constexpr double kPalmToWrist_m = 0.045;
/// Farther away no camera of a desk sees a hand.
constexpr double kFarthest_mm = 1e5;

const Vec3 kNotGiven = Vec3::Constant(std::numeric_limits<double>::quiet_NaN());

/// Three numbers under a key; not given: NaN.
Vec3 three_of(const Json& object, const char* key) {
  const auto found = object.find(key);
  if (found == object.end() || !found->is_array() || found->size() != 3) return kNotGiven;
  Vec3 values;
  for (std::size_t a = 0; a < 3; ++a) {
    const Json& value = (*found)[a];
    if (!value.is_number()) return kNotGiven;
    values[static_cast<Eigen::Index>(a)] = value.get<double>();
  }
  return values.cwiseAbs().maxCoeff() <= kFarthest_mm ? values : kNotGiven;
}
Vec3 place_of(const Json& object, const char* key) {
  return kMillimetre * three_of(object, key);
}
std::optional<std::int64_t> whole_of(const Json& object, const char* key) {
  const auto found = object.find(key);
  if (found == object.end() || !found->is_number_integer()) return std::nullopt;
  if (found->is_number_unsigned() &&
      found->get<std::uint64_t>() > std::uint64_t{std::numeric_limits<std::int64_t>::max()})
    return std::nullopt;
  return found->get<std::int64_t>();
}

void read_digit(const Json& pointable, HandFrame& frame) {
  constexpr std::int64_t kDigits = 10;  // the last digit of an id is the finger
  auto type = whole_of(pointable, "type");
  if (!type) {
    const auto id = whole_of(pointable, "id");
    if (id) type = *id % kDigits;
  }
  if (!type || *type < 0 || *type >= static_cast<std::int64_t>(kDigitCount)) return;
  const auto digit = static_cast<Digit>(*type);
  Vec3 tip = place_of(pointable, "btipPosition");
  if (!tip.allFinite()) tip = place_of(pointable, "tipPosition");
  if (digit != Digit::thumb)
    frame.joints[metacarpal_joint_of(digit)] = place_of(pointable, "carpPosition");
  frame.joints[joint_of(digit, 0)] = place_of(pointable, "mcpPosition");
  frame.joints[joint_of(digit, 1)] = place_of(pointable, "pipPosition");
  frame.joints[joint_of(digit, 2)] = place_of(pointable, "dipPosition");
  frame.joints[joint_of(digit, 3)] = tip;
}

Vec3 wrist_of(const Json& hand, const HandFrame& frame) {
  if (const Vec3 wrist = place_of(hand, "wrist"); wrist.allFinite()) return wrist;
  Vec3 sum = Vec3::Zero();
  for (std::size_t d = 1; d < kDigitCount; ++d)
    sum += frame.joints[metacarpal_joint_of(static_cast<Digit>(d))];
  if (sum.allFinite()) return sum / static_cast<double>(kDigitCount - 1);
  const Vec3 direction = three_of(hand, "direction");
  if (!(direction.norm() > 0.0)) return kNotGiven;
  return frame.joints[kPalmJoint] - kPalmToWrist_m * direction.normalized();
}

std::optional<HandFrame> read_hand(const Json& hand, const Json& pointables) {
  const auto id = whole_of(hand, "id");
  const auto type = hand.find("type");
  if (!id || type == hand.end() || !type->is_string()) return std::nullopt;
  const auto side = hand_from_name(type->get_ref<const std::string&>());
  if (!side) return std::nullopt;
  HandFrame frame;
  frame.side = *side;
  frame.tracked = true;
  frame.joints.fill(kNotGiven);
  if (const auto told = hand.find("confidence"); told != hand.end() && told->is_number())
    frame.confidence = std::clamp(told->get<double>(), 0.0, 1.0);
  frame.joints[kPalmJoint] = place_of(hand, "palmPosition");
  for (const Json& pointable : pointables)
    if (pointable.is_object() && whole_of(pointable, "handId") == id) read_digit(pointable, frame);
  frame.joints[kWristJoint] = wrist_of(hand, frame);
  return frame;
}

HandFrame not_tracked(Hand side) {
  HandFrame frame;
  frame.side = side;
  frame.confidence = 0.0;
  frame.joints.fill(kNotGiven);
  return frame;
}

}  // namespace

auto LeapDecoder::take(std::string_view message, std::vector<HandFrame>& hands) -> Kind {
  hands.clear();
  if (message.size() > kLongestMessage) return Kind::damaged;
  const Json json = Json::parse(message, nullptr, false);
  if (!json.is_object()) return Kind::damaged;
  if (!json.contains("timestamp")) {
    if (const auto told = json.find("serviceVersion"); told != json.end() && told->is_string())
      service_ = told->get<std::string>();
    return Kind::notice;
  }
  const auto time_us = whole_of(json, "timestamp");
  const auto found = json.find("hands");
  const auto pointed = json.find("pointables");
  if (!time_us || *time_us < 0 || found == json.end() || !found->is_array()) return Kind::damaged;
  if (first_us_ && *time_us <= last_us_) {
    late_s_ = kMicrosecond * static_cast<double>(last_us_ - *time_us);
    return Kind::late;
  }
  if (!first_us_) first_us_ = *time_us;
  last_us_ = *time_us;
  static const Json kNone = Json::array();
  const Json& pointables = pointed != json.end() && pointed->is_array() ? *pointed : kNone;
  std::array<bool, 2> here{};
  for (const Json& one : *found) {
    if (!one.is_object()) continue;
    auto hand = read_hand(one, pointables);
    if (!hand || std::exchange(here[static_cast<std::size_t>(hand->side)], true)) continue;
    hands.push_back(*hand);
  }
  for (const Hand side : {Hand::right, Hand::left}) {
    const auto s = static_cast<std::size_t>(side);
    if (known_[s] && !here[s]) hands.push_back(not_tracked(side));
    known_[s] = known_[s] || here[s];
  }
  for (HandFrame& hand : hands) hand.t_s = time_s();
  return Kind::frame;
}

double LeapDecoder::time_s() const noexcept {
  return first_us_ ? static_cast<double>(last_us_ - *first_us_) * kMicrosecond : 0.0;
}

}  // namespace isograsp
