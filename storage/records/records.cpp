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

}  // namespace isograsp::storage
