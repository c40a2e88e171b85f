// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/acquisition/apparatus.hpp"

namespace isograsp::session {

Result<void> check_apparatus(std::string_view needed, const ApparatusInfo& info) {
  if (needed.empty() || needed == info.kind) return {};
  return refused("the tasks need another device (%1) than %2 (%3)"_text(needed, info.description,
                                                                        info.kind),
                 "choose a device for these tasks, or tasks for this device"_text)
      .about("device");
}

}  // namespace isograsp::session
