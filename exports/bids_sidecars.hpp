// SPDX-License-Identifier: GPL-3.0-or-later
// What stands beside the tables of a BIDS data set and says what their columns are: JSON, and the
// text that people read first.
#pragma once

#include <string>
#include <string_view>

namespace isograsp::exports {

[[nodiscard]] std::string bids_channels_sidecar();
[[nodiscard]] std::string bids_participants_sidecar();
[[nodiscard]] std::string bids_sessions_sidecar();
[[nodiscard]] std::string bids_scans_sidecar();
/// dataset_description.json; `type`: "raw" or "derivative".
[[nodiscard]] std::string bids_description(std::string_view type);
[[nodiscard]] std::string bids_readme();

}  // namespace isograsp::exports
