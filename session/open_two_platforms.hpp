// SPDX-License-Identifier: GPL-3.0-or-later
// Two platforms, one for each hand, as one address: two-platforms://LEFT + RIGHT, both of them
// addresses of devices of force sensors, or twice the same sim://pair.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "hand/hands.hpp"
#include "session/open_apparatus.hpp"

namespace isograsp::session {

inline constexpr std::string_view kTwoPlatformsScheme = "two-platforms";

/// The address of both. Refused: one address twice, which would be one platform for two hands, but
/// for sim://pair; one that holds " + ".
[[nodiscard]] Result<std::string> two_platforms_uri(const OfHands<std::string>& uris);
/// The address of each; nothing: it is no address of two platforms.
[[nodiscard]] std::optional<OfHands<std::string>> two_platforms_in(std::string_view uri);

[[nodiscard]] Result<std::unique_ptr<Apparatus>> open_two_platforms(
    const ApparatusRequest& request);

/// Names of the pairs of a library (LIBRARY/patients/pairs/NAME.toml), sorted.
[[nodiscard]] std::vector<std::string> simulated_pairs(const std::string& library);

}  // namespace isograsp::session
