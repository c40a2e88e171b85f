// SPDX-License-Identifier: GPL-3.0-or-later
// For tests of reports on paper: Qt without a display, and one clinic for all cases of a suite.
#pragma once

#include <cstdlib>
#include <memory>

#include <gtest/gtest.h>

#include "reports/paper/qt_application.hpp"
#include "storage/access/open_store.hpp"
#include "tests/support/must.hpp"
#include "tests/support/temporary_folder.hpp"

namespace isograsp::test {

/// Qt draws without a display from here on.
inline void draw_without_a_display() {
  setenv("QT_QPA_PLATFORM", "offscreen", 1);
  reports::ensure_qt_application();
}

/// A suite calls open_clinic() in its SetUpTestSuite() and fills the store.
class PaperTest : public testing::Test {
 protected:
  static void open_clinic() {
    draw_without_a_display();
    folder_ = std::make_unique<TemporaryFolder>();
    store_ = must(storage::open_store(folder_->path("clinic.db"), storage::OpenMode::create));
  }
  static void TearDownTestSuite() {
    store_.reset();
    folder_.reset();
  }

  static inline std::unique_ptr<TemporaryFolder> folder_;
  static inline std::unique_ptr<storage::SessionStore> store_;
};

}  // namespace isograsp::test
