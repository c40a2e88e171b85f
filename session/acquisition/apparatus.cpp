// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/acquisition/apparatus.hpp"

namespace isograsp::session {

Result<void> check_apparatus(std::string_view needed, const ApparatusInfo& info) {
  if (needed.empty() || needed == info.kind) return {};
  return refused("the tasks need another device (" + std::string(needed) + ") than " +
                     info.description + " (" + std::string(info.kind) + ")",
                 "choose a device for these tasks, or tasks for this device")
      .about("device");
}

}  // namespace isograsp::session
