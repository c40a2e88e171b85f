// SPDX-License-Identifier: GPL-3.0-or-later
// Tables of numbers as HDF5 (docs/file_formats.md, "Tables as HDF5"): float64, rows × columns,
// named by the attribute `columns`. Not for two threads at once, as the library itself.
#pragma once

#include <memory>
#include <span>
#include <string>

#include "core/tables/number_table.hpp"

namespace isograsp::exports {

/// Where tables stand in a file that says nothing else.
inline constexpr const char* kTablesPlace = "/signals";

/// `place`: a data set, or a group whose data sets with `columns` stand side by side. Errors name
/// the row in place of a line. What does not stand in the file itself is refused: data of other
/// files, filters that would have to be loaded.
[[nodiscard]] Result<std::unique_ptr<TableReader>> open_hdf5_table(
    const std::string& path, const std::string& place = kTablesPlace);

/// One data set, each column in chunks of its own, not packed: the same numbers give the same
/// bytes.
[[nodiscard]] Result<std::unique_ptr<TableWriter>> create_hdf5_table(
    const std::string& path, std::span<const std::string> columns);

}  // namespace isograsp::exports
