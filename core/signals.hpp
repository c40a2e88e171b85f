// SPDX-License-Identifier: GPL-3.0-or-later
// Named columns of numbers on one time axis: a trial as it is stored, exported, scored and plotted.
// A column's name carries its unit ("target_force_N"); NaN stands for a missing value.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace isograsp {

/// Where `name` stands in `names`; nothing: nowhere.
[[nodiscard]] std::optional<std::size_t> index_of(std::span<const std::string> names,
                                                  std::string_view name) noexcept;

class Signals {
 public:
  Signals() = default;
  explicit Signals(std::vector<std::string> names);

  [[nodiscard]] const std::vector<std::string>& names() const noexcept { return names_; }
  [[nodiscard]] std::size_t rows() const noexcept {
    return columns_.empty() ? 0 : columns_.front().size();
  }
  /// Index of a column; nothing: there is none of this name.
  [[nodiscard]] std::optional<std::size_t> find(std::string_view name) const noexcept;
  [[nodiscard]] bool has(std::string_view name) const noexcept { return find(name).has_value(); }
  [[nodiscard]] std::span<const double> column(std::size_t index) const { return columns_[index]; }
  /// An empty span if there is no such column.
  [[nodiscard]] std::span<const double> column(std::string_view name) const;

  /// @pre row.size() == names().size()
  void append_row(std::span<const double> row);
  /// Adds a column. @pre there are no columns yet, or values.size() == rows()
  void add_column(std::string name, std::vector<double> values);

 private:
  std::vector<std::string> names_;
  std::vector<std::vector<double>> columns_;
};

}  // namespace isograsp
