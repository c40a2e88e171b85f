// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/hand/emulated_leap.hpp"

#include <cmath>

#include <nlohmann/json.hpp>

namespace isograsp {

namespace {

using LeapJson = nlohmann::ordered_json;

constexpr double kMetre_mm = 1e3;
constexpr double kSecond_us = 1e6;
/// How long the service has run when the play begins [s]: its clock may be set back by a fault.
constexpr double kUptime_s = 1e4;

/// Null: not given.
LeapJson leap_place(const Vec3& p) {
  if (!p.allFinite()) return nullptr;
  return {kMetre_mm * p.x(), kMetre_mm * p.y(), kMetre_mm * p.z()};
}

LeapJson leap_finger(const HandFrame& hand, Digit digit, int hand_id) {
  const auto d = static_cast<int>(index_of(digit));
  constexpr int kDigitsOfId = 10;
  LeapJson finger{{"id", kDigitsOfId * hand_id + d}, {"handId", hand_id}, {"type", d}};
  if (digit != Digit::thumb)
    finger["carpPosition"] = leap_place(hand.joints[metacarpal_joint_of(digit)]);
  constexpr const char* kEnds[]{"mcpPosition", "pipPosition", "dipPosition", "btipPosition"};
  for (std::size_t end = 0; end < 4; ++end)
    finger[kEnds[end]] = leap_place(hand.joints[joint_of(digit, end)]);
  return finger;
}

}  // namespace

std::string leap_greeting() {
  return R"({"serviceVersion":"emulated","version":6})";
}
std::string leap_device_event() {
  return R"({"event":{"type":"deviceEvent","state":{"attached":true,"streaming":true}}})";
}

std::string leap_frame(const HandPicture& picture, double rate_Hz) {
  auto hands = LeapJson::array();
  auto pointables = LeapJson::array();
  for (const HandFrame& hand : picture.hands) {
    if (!hand.tracked) continue;
    const int id = 1 + static_cast<int>(hand.side);
    hands.push_back({{"id", id},
                     {"type", name_of(hand.side)},
                     {"confidence", hand.confidence},
                     {"palmPosition", leap_place(hand.joints[kPalmJoint])},
                     {"wrist", leap_place(hand.joints[kWristJoint])}});
    for (const Digit digit :
         {Digit::thumb, Digit::index, Digit::middle, Digit::ring, Digit::little})
      pointables.push_back(leap_finger(hand, digit, id));
  }
  return LeapJson{{"id", picture.frame},
                  {"timestamp", std::llround(kSecond_us * (kUptime_s + picture.stamp_s))},
                  {"currentFrameRate", rate_Hz},
                  {"hands", std::move(hands)},
                  {"pointables", std::move(pointables)}}
      .dump();
}

bool asks_for_frames(std::string_view message) {
  const auto json = LeapJson::parse(message, nullptr, false);
  if (!json.is_object()) return false;
  const auto wish = json.find("background");
  return wish != json.end() && wish->is_boolean() && wish->get<bool>();
}

}  // namespace isograsp
