// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/open_hand.hpp"

#include <cmath>
#include <utility>

#include "device/hand/hand_csv.hpp"
#include "session/tracked_hand/hand_size.hpp"
#include "session/tracked_hand/tracked_hand.hpp"
#include "virtual_patient/hand/virtual_grasper.hpp"

namespace isograsp::session {

namespace {

constexpr const char* kSize = "size";

Result<bool> size_of_other_in(const Uri& uri) {
  const std::string size = uri.text_or(kSize, "own");
  if (size != "own" && size != "other")
    return refused("'%1' says not whose size the hand has"_text(size),
                   "write size=own, or size=other for a hand that cannot open"_text)
        .at(uri.text)
        .about(kSize);
  return size == "other";
}

/// Whose hand it is; null: nobody is simulated.
Result<std::unique_ptr<HandSource>> simulated_user(const ApparatusRequest& request,
                                                   const virtual_hand::HandModel& model) {
  std::unique_ptr<HandSource> user;
  const Uri& uri = request.uri;
  if (uri.scheme != "sim") return user;
  const std::string name = uri.text_or("user", "healthy");
  const auto traits = virtual_patient::grasp_traits(name);
  if (!traits) {
    std::string names;
    for (const std::string_view one : virtual_patient::grasper_names())
      names += (names.empty() ? "" : ", ") + std::string(one);
    return refused("there is no simulated user '%1'"_text(name), "use one of: %1"_text(names))
        .at(uri.text)
        .about("user");
  }
  constexpr double kLargestSeed = 9007199254740992.0;  // 2^53: every whole number below is exact
  const auto seed = uri.number_or("seed", 1.0, 0.0, kLargestSeed);
  if (!seed) return seed.error();
  if (*seed != std::floor(*seed))
    return refused("is not a whole number"_text, "write a whole number such as seed=7"_text)
        .at(uri.text)
        .about("seed");
  user = std::make_unique<virtual_patient::VirtualGrasper>(
      model, *traits, static_cast<std::uint64_t>(*seed), request.hand);
  return user;
}

}  // namespace

bool says_size(const std::string& uri) {
  const auto parsed = Uri::parse(uri);
  return parsed && parsed->parameters.contains(kSize);
}

std::string with_size_of_other(const std::string& uri) {
  return uri + (uri.find('?') == std::string::npos ? '?' : '&') + kSize + "=other";
}

bool is_recorded_hand(const Uri& uri) {
  return begins_like_hand_csv(uri.target);
}

Result<std::unique_ptr<Apparatus>> open_hand(const ApparatusRequest& request) {
  HandSetup setup;
  setup.side = request.hand;
  auto model = usual_hand(request.library, request.uri.text);
  if (!model) return model.error();
  setup.model = *std::move(model);
  const auto of_other = size_of_other_in(request.uri);
  if (!of_other) return of_other.error();
  setup.size_of_other = *of_other;
  auto person = simulated_user(request, setup.model);
  if (!person) return person.error();
  auto device = open_hand_device(request.uri, request.hand, person->get());
  if (!device) return device.error();
  return std::unique_ptr<Apparatus>(
      std::make_unique<TrackedHand>(*std::move(device), std::move(setup), *std::move(person)));
}

}  // namespace isograsp::session
