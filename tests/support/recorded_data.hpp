// SPDX-License-Identifier: GPL-3.0-or-later
// Recordings that people made are not part of the project; tests that use them find them here and
// report themselves skipped where the folder is absent.
#pragma once

#include <cstdlib>
#include <string>

namespace isograsp::test {

[[nodiscard]] inline std::string recorded_data() {
  const char* chosen = std::getenv("ISOGRASP_RECORDED_DATA");
  return chosen != nullptr ? chosen : ISOGRASP_SOURCE_DIR "/../shared/data";
}

}  // namespace isograsp::test
