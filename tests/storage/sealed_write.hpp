// SPDX-License-Identifier: GPL-3.0-or-later
// A row that a test writes as the program would: with its seal.
#pragma once

#include <string>

#include <soci/soci.h>

#include "storage/access/login.hpp"
#include "storage/file/database.hpp"
#include "tests/support/must.hpp"

namespace isograsp::storage {

inline void write_sealed(const std::string& path, const std::string& statement) {
  auto database = test::must(Database::open(path, OpenMode::existing));
  test::must(database.transact("testing"_text, [&] {
    (void)login_state_of(database);
    database.sql() << statement;
  }));
}

}  // namespace isograsp::storage
