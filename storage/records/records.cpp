// SPDX-License-Identifier: GPL-3.0-or-later
#include "storage/records/records.hpp"

namespace isograsp::storage {

std::string_view name_of(TrialStatus status) noexcept {
  switch (status) {
    case TrialStatus::running: return "running";
    case TrialStatus::completed: return "completed";
    case TrialStatus::aborted: return "aborted";
    case TrialStatus::interrupted: return "interrupted";
  }
  return "";
}

std::optional<double> value_of(const References& references, std::string_view name) {
  const auto found = references.find(name);
  return found == references.end() ? std::nullopt : std::optional(found->second);
}

void set_value(References& references, std::string_view name, std::optional<double> value) {
  if (value)
    references.insert_or_assign(std::string(name), *value);
  else if (const auto found = references.find(name); found != references.end())
    references.erase(found);
}

}  // namespace isograsp::storage
