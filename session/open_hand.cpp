// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/open_hand.hpp"

#include <utility>

#include "core/files.hpp"
#include "device/hand/hand_csv.hpp"
#include "session/library/library.hpp"
#include "session/tracked_hand/tracked_hand.hpp"

namespace isograsp::session {

namespace {

/// Axes and limits of every hand, and the size of one that was not measured.
Result<virtual_hand::HandModel> usual_hand(const ApparatusRequest& request) {
  const auto path = find_in_library(request.library, "hands", "default", request.uri.text);
  if (!path) return path.error();
  const auto text = read_text(*path);
  if (!text) return text.error();
  return virtual_hand::parse_hand(*text, *path);
}

Result<bool> size_of_other_in(const Uri& uri) {
  const std::string size = uri.text_or("size", "own");
  if (size != "own" && size != "other")
    return refused("'%1' says not whose size the hand has"_text(size),
                   "write size=own, or size=other for a hand that cannot open"_text)
        .at(uri.text)
        .about("size");
  return size == "other";
}

}  // namespace

bool is_recorded_hand(const Uri& uri) {
  return begins_like_hand_csv(uri.target);
}

Result<std::unique_ptr<Apparatus>> open_hand(const ApparatusRequest& request) {
  HandSetup setup;
  setup.side = request.hand;
  auto model = usual_hand(request);
  if (!model) return model.error();
  setup.model = *std::move(model);
  const auto of_other = size_of_other_in(request.uri);
  if (!of_other) return of_other.error();
  setup.size_of_other = *of_other;
  auto device = open_hand_device(request.uri, request.hand);
  if (!device) return device.error();
  return std::unique_ptr<Apparatus>(
      std::make_unique<TrackedHand>(*std::move(device), std::move(setup)));
}

}  // namespace isograsp::session
