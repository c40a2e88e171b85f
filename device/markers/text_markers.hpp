// SPDX-License-Identifier: GPL-3.0-or-later
// Recordings of markers as text with tabs: TRC (OpenSim, Motion Analysis) and tables of Qualisys
// (TSV). Not seen: empty fields, "nan", or the exact origin.
#pragma once

#include <memory>
#include <string>

#include "device/markers/marker_reader.hpp"

namespace isograsp {

/// Times and units are those of the file.
[[nodiscard]] Result<std::unique_ptr<MarkerReader>> open_trc(const std::string& path);
/// In mm; times are those of the file, else k / FREQUENCY.
[[nodiscard]] Result<std::unique_ptr<MarkerReader>> open_qualisys_tsv(const std::string& path);

}  // namespace isograsp
