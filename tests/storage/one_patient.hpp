// SPDX-License-Identifier: GPL-3.0-or-later
// A file with one patient, for tests of what is known of a person.
#pragma once

#include "storage/access/open_store.hpp"
#include "tests/storage/examples.hpp"

namespace isograsp::storage {

struct OnePatient : testing::Test {
  TemporaryFolder folder;
  std::string path = folder.file("clinic.db");
  std::unique_ptr<SessionStore> store = opened(path);
  RowId patient = must(store->add_patient("P-0427")).id;

  void reopen() {
    store.reset();
    store = opened(path, OpenMode::existing);
  }
};

}  // namespace isograsp::storage
