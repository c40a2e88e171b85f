// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/signals.hpp"

#include <algorithm>
#include <cassert>

namespace isograsp {

Signals::Signals(std::vector<std::string> names)
    : names_(std::move(names)), columns_(names_.size()) {}

int Signals::find(std::string_view name) const noexcept {
  const auto at = std::find(names_.begin(), names_.end(), name);
  return at == names_.end() ? -1 : static_cast<int>(at - names_.begin());
}

std::span<const double> Signals::column(std::string_view name) const {
  const int index = find(name);
  if (index < 0) return {};
  return columns_[static_cast<std::size_t>(index)];
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
