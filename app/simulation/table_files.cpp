// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/simulation/table_files.hpp"

#include "core/csv.hpp"
#include "exports/hdf5_table.hpp"

namespace isograsp::app {

namespace {
constexpr std::string_view kHdf5 = ".h5";
}

Result<std::unique_ptr<TableReader>> open_table(const std::string& name) {
  if (name.ends_with(kHdf5)) return exports::open_hdf5_table(name);
  const std::size_t colon = name.rfind(std::string(kHdf5) + ":/");
  if (colon == std::string::npos) return open_csv(name);
  const std::size_t end = colon + kHdf5.size();
  return exports::open_hdf5_table(name.substr(0, end), name.substr(end + 1));
}

Result<NumberRows> NumberRows::create(const std::string& path,
                                      std::span<const std::string> columns) {
  auto table = path.ends_with(kHdf5) ? exports::create_hdf5_table(path, columns)
                                     : CsvWriter::create(path, columns);
  if (!table) return table.error();
  return NumberRows(*std::move(table));
}

void add_three(std::vector<std::string>& columns, const std::string& before,
               const std::string& after) {
  for (const char axis : {'x', 'y', 'z'}) columns.push_back(before + axis + after);
}

}  // namespace isograsp::app
