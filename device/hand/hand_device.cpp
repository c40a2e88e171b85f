// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/hand/hand_device.hpp"

#include <array>

#include "device/hand/hand_schemes.hpp"

namespace isograsp {

namespace {

constexpr std::size_t kHandFaults = 6;

struct HandScheme {
  std::string_view name;
  Result<std::unique_ptr<HandDevice>> (*open)(const Uri&, std::optional<Hand>);
};
constexpr std::array kHandSchemes{HandScheme{"leap", open_leap},
                                  HandScheme{"udp-hand", open_udp_hand},
                                  HandScheme{"replay", open_hand_replay}};

}  // namespace

std::string_view name_of(HandFault fault) noexcept {
  constexpr std::array<std::string_view, kHandFaults> kNames{
      "none", "connection_lost", "silence", "frozen", "other_hand", "damaged_samples"};
  return kNames[static_cast<std::size_t>(fault)];
}

Words words_of(HandFault fault) noexcept {
  constexpr std::array<Words, kHandFaults> kSentences{
      "The hand tracker works."_text,
      "The connection to the hand tracker is lost: check that its service is running."_text,
      "The hand tracker sends nothing: check its camera and its program."_text,
      "The hand tracker repeats one picture: start its program again."_text,
      "The tracker sees only the other hand, or takes this one for it: show this hand alone, palm down."_text,
      "Messages of the hand tracker are lost or damaged: check its program and the network."_text};
  return kSentences[static_cast<std::size_t>(fault)];
}

Result<std::unique_ptr<HandDevice>> open_hand_device(const Uri& uri, std::optional<Hand> side,
                                                     HandSource* person) {
  for (const HandScheme& scheme : kHandSchemes)
    if (uri.scheme == scheme.name) return scheme.open(uri, side);
  if (uri.scheme == "sim") return open_simulated_hand(uri, side, person);
  return refused("no tracker of hands is called %1://"_text(uri.scheme),
                 "use leap://HOST, udp-hand://HOST, replay://FILE.csv or sim://hand"_text)
      .at(uri.text);
}

}  // namespace isograsp
