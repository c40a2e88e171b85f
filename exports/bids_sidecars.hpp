// SPDX-License-Identifier: GPL-3.0-or-later
// Files beside the tables of a BIDS data set, in the language of the export: JSON that says what
// the columns are, and the text that people read first.
#pragma once

#include <string>
#include <string_view>

#include "core/text.hpp"

namespace isograsp::exports {

/// `tracked`: of what cameras saw, else of forces.
[[nodiscard]] std::string bids_channels_sidecar(bool tracked, const Language& language);
[[nodiscard]] std::string bids_participants_sidecar(const Language& language);
[[nodiscard]] std::string bids_sessions_sidecar(const Language& language);
[[nodiscard]] std::string bids_scans_sidecar(const Language& language);
/// dataset_description.json; `type`: "raw" or "derivative".
[[nodiscard]] std::string bids_description(std::string_view type, const Language& language);
[[nodiscard]] std::string bids_readme(const Language& language);

}  // namespace isograsp::exports
