// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/open_apparatus.hpp"

#include <algorithm>
#include <array>

#include "device/sensors/force_device.hpp"
#include "session/arm/marker_arm.hpp"
#include "session/open_arm.hpp"
#include "session/open_hand.hpp"
#include "session/open_two_platforms.hpp"
#include "session/platform/force_platform.hpp"
#include "session/simulated_person.hpp"
#include "session/tracked_hand/tracked_hand.hpp"
#include "session/two_platforms/two_platforms.hpp"

namespace isograsp::session {

namespace {

/// sim:// of whatever name, replay://, and all sensors behind buses and cards.
Result<std::unique_ptr<Apparatus>> open_platform(const ApparatusRequest& request) {
  auto person = simulated_person(request.uri, request.library);
  if (!person) return person.error();
  DeviceOptions options;
  options.source = person->get();
  auto device = open_device(request.uri.text, options);
  if (!device) return device.error();
  if (const auto& mounted_for = (*device)->info().hand)
    if (auto same = check_hand(request.uri.text, name_of(*mounted_for), request.hand); !same)
      return same.error();
  return std::unique_ptr<Apparatus>(std::make_unique<ForcePlatform>(
      *std::move(device), *std::move(person),
      PlatformOptions{request.hand, request.library, request.display_delay_s}));
}

constexpr std::array<ApparatusRow, 10> kRows{
    {{kTwoPlatformsScheme, "", "", open_two_platforms, TwoPlatforms::kKind},
     {"qtm", "", "", open_arm, MarkerArm::kKind},
     {"natnet", "", "", open_arm, MarkerArm::kKind},
     {"sim", "arm", "", open_arm, MarkerArm::kKind},
     {"replay", "", "rig", open_arm, MarkerArm::kKind},
     {"leap", "", "", open_hand, TrackedHand::kKind},
     {"udp-hand", "", "", open_hand, TrackedHand::kKind},
     {"sim", "hand", "", open_hand, TrackedHand::kKind},
     {"replay", "", "", open_hand, TrackedHand::kKind, is_recorded_hand},
     {"", "", "", open_platform, ForcePlatform::kKind}}};

const ApparatusRow& row_for(const Uri& uri, std::span<const ApparatusRow> rows) {
  return *std::find_if(rows.begin(), rows.end(), [&](const ApparatusRow& one) {
    return (one.scheme.empty() || one.scheme == uri.scheme) &&
           (one.target.empty() || one.target == uri.target) &&
           (one.parameter.empty() || uri.parameters.contains(std::string(one.parameter))) &&
           (one.fits == nullptr || one.fits(uri));
  });
}

}  // namespace

std::span<const ApparatusRow> all_apparatuses() noexcept {
  return kRows;
}

Result<Uri> parse_address(const std::string& text) {
  if (!two_platforms_in(text)) return Uri::parse(text);
  Uri both;
  both.text = text;
  both.scheme = kTwoPlatformsScheme;
  return both;
}

Result<std::unique_ptr<Apparatus>> open_apparatus(const ApparatusRequest& request,
                                                  std::span<const ApparatusRow> rows) {
  return row_for(request.uri, rows).open(request);
}

std::string_view kind_of_apparatus(const std::string& uri, std::span<const ApparatusRow> rows) {
  const auto parsed = parse_address(uri);
  return parsed ? row_for(*parsed, rows).kind : std::string_view();
}

Result<void> check_hand(const std::string& device_uri, std::string_view mounted_for, Hand hand) {
  if (mounted_for == name_of(hand)) return {};
  return refused(
             "the device is set up for the %1 hand, the session for the %2"_text(
                 Known{std::string(mounted_for)}, Known{std::string(name_of(hand))}),
             "turn the platform and choose the configuration for that hand, or choose the %1 hand"_text(
                 Known{std::string(mounted_for)}))
      .at(device_uri)
      .about("hand");
}

}  // namespace isograsp::session
