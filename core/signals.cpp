// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/signals.hpp"

#include <algorithm>
#include <cassert>

namespace isograsp {

std::optional<std::size_t> index_of(std::span<const std::string> names,
                                    std::string_view name) noexcept {
  const auto at = std::find(names.begin(), names.end(), name);
  if (at == names.end()) return std::nullopt;
  return static_cast<std::size_t>(at - names.begin());
}

Signals::Signals(std::vector<std::string> names)
    : names_(std::move(names)), columns_(names_.size()) {}

std::optional<std::size_t> Signals::find(std::string_view name) const noexcept {
  return index_of(names_, name);
}

std::span<const double> Signals::column(std::string_view name) const {
  const auto index = find(name);
  if (!index) return {};
  return columns_[*index];
}

void Signals::append_row(std::span<const double> row) {
  assert(row.size() == columns_.size());
  for (std::size_t i = 0; i < row.size(); ++i) columns_[i].push_back(row[i]);
}

void Signals::add_column(std::string name, std::vector<double> values) {
  assert(columns_.empty() || values.size() == rows());
  names_.push_back(std::move(name));
  columns_.push_back(std::move(values));
}

}  // namespace isograsp
