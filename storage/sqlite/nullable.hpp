// SPDX-License-Identifier: GPL-3.0-or-later
// Inside storage/sqlite/ only: values that SQL knows as NULL.
#pragma once

#include <optional>

#include <soci/soci-backend.h>

#include "storage/records/records.hpp"

namespace isograsp::storage {

/// Nothing is NULL.
struct NullableNumber {
  explicit NullableNumber(const std::optional<double>& from)
      : value(from.value_or(0.0)), present(from ? soci::i_ok : soci::i_null) {}
  double value;
  soci::indicator present;
};

}  // namespace isograsp::storage
