// SPDX-License-Identifier: GPL-3.0-or-later
// The list of all files of an export with their hashes, signed by the clinic: what was altered,
// added or is missing since is named. Format: docs/file_formats.md, "Signatures".
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/result.hpp"

namespace isograsp::exports {

/// Stands in the folder of the export, as `sha256sum -c` reads it.
inline constexpr const char* kExportList = "SHA256SUMS";
inline constexpr const char* kExportSignature = "SHA256SUMS.sig";

/// Lists what is below `folder` and signs the list with the key of `database`. Without a key there
/// is no signature.
[[nodiscard]] Result<void> list_and_sign(const std::string& folder, const std::string& database);

struct ExportProof {
  std::size_t files = 0;       ///< of the list
  std::string key;             ///< public key of the signature; empty: the list is not signed
  std::vector<Text> problems;  ///< files that were altered, added or are missing; none: as it was
};
/// `key`: the public key of the clinic; empty: any. Reads nothing but what is found below `folder`,
/// whatever the list says, and follows no link. Errors: bad_input, if `folder` is none; failed, if
/// there is no list or its signature does not prove.
[[nodiscard]] Result<ExportProof> prove_export(const std::string& folder,
                                               const std::string& key = "");

}  // namespace isograsp::exports
