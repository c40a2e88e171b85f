// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/open_arm.hpp"

#include <algorithm>
#include <utility>

#include "session/arm/marker_arm.hpp"
#include "virtual_patient/arm/virtual_arm.hpp"
#include "virtual_patient/arm/virtual_drinker.hpp"
#include "virtual_patient/traits.hpp"

namespace isograsp::session {

namespace {

/// A rig that fits the markers of the simulated arm.
constexpr const char* kSimulatedRig = "kurillo15_trunk";

/// The rig names no other markers than those of somebody who drinks.
bool is_of_drinking(const Rig& rig) {
  const auto names = virtual_patient::VirtualDrinker::names();
  const auto markers = markers_of(rig);
  return std::all_of(markers.begin(), markers.end(), [&](const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  });
}

/// Whose arm it is; null: nobody is simulated.
Result<std::unique_ptr<MarkerSource>> simulated_arm(const Uri& uri, const Rig& rig, Hand hand) {
  std::unique_ptr<MarkerSource> nobody;
  if (uri.scheme != "sim") return nobody;
  const std::string patient = uri.text_or("patient", "healthy");
  auto traits = virtual_patient::arm_traits(patient);
  if (!traits) {
    std::string names;
    for (const std::string_view name : virtual_patient::arm_names())
      names += (names.empty() ? "" : ", ") + std::string(name);
    return refused("there is no simulated arm '%1'"_text(patient), "use one of: %1"_text(names))
        .at(uri.text)
        .about("patient");
  }
  constexpr double kLargestSeed = 9007199254740992.0;  // 2^53: every whole number below is exact
  constexpr double kLatestDay = 10000.0;
  const auto seed = uri.number_or("seed", 1.0, 0.0, kLargestSeed);
  if (!seed) return seed.error();
  const auto recovery = uri.number_or("recovery", 0.0, 0.0, 1.0);
  if (!recovery) return recovery.error();
  const auto day = uri.number_or("day", 0.0, 0.0, kLatestDay);
  if (!day) return day.error();
  const auto person = static_cast<std::uint64_t>(*seed);
  const auto arm = virtual_patient::recovered(*traits, *recovery);
  std::optional<std::uint64_t> on_day;
  if (uri.parameters.contains("day")) on_day = static_cast<std::uint64_t>(*day);
  std::unique_ptr<MarkerSource> source;
  if (is_of_drinking(rig))
    source = std::make_unique<virtual_patient::VirtualDrinker>(arm, person, hand, on_day);
  else
    source = std::make_unique<virtual_patient::VirtualArm>(arm, person, hand, on_day);
  return source;
}

}  // namespace

Result<std::unique_ptr<Apparatus>> open_arm(const ApparatusRequest& request) {
  const Uri& uri = request.uri;
  auto rig = ArmRig::load(uri.text_or("rig", uri.scheme == "sim" ? kSimulatedRig : ""),
                          request.library, request.hand, uri.text);
  if (!rig) return rig.error();
  auto person = simulated_arm(uri, rig->rig, request.hand);
  if (!person) return person.error();
  auto device = open_marker_device(uri, person->get());
  if (!device) return device.error();
  return std::unique_ptr<Apparatus>(std::make_unique<MarkerArm>(
      *std::move(device), *std::move(rig), request.library, *std::move(person)));
}

}  // namespace isograsp::session
