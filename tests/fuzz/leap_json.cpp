// SPDX-License-Identifier: GPL-3.0-or-later
// Messages of a hand tracker: whatever comes, a hand has joints that are numbers or not given, and
// times that increase.
#include "device/hand/leap_json.hpp"

#include <cmath>

#include "tests/fuzz/support.hpp"

using namespace isograsp;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  LeapDecoder decoder;
  std::vector<HandFrame> hands;
  double last_s = -1.0;
  std::string_view rest(reinterpret_cast<const char*>(data), size);
  while (!rest.empty()) {
    const auto end = std::min(rest.find('\n'), rest.size());
    const auto kind = decoder.take(rest.substr(0, end), hands);
    rest.remove_prefix(std::min(end + 1, rest.size()));
    fuzz::require(kind == LeapDecoder::Kind::frame || hands.empty(), "only a frame shows hands");
    fuzz::require(hands.size() <= 2, "a person has two hands");
    for (const HandFrame& hand : hands) {
      fuzz::require(hand.t_s > last_s && std::isfinite(hand.t_s), "time increases");
      fuzz::require(hand.confidence >= 0.0 && hand.confidence <= 1.0, "confidence is a share");
      for (const Vec3& joint : hand.joints)
        fuzz::require(joint.allFinite() || joint.array().isNaN().all(),
                      "a joint is whole or not there");
    }
    if (!hands.empty()) last_s = hands.front().t_s;
  }
  return 0;
}
