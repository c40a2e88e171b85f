// SPDX-License-Identifier: GPL-3.0-or-later
// --realtime of the subcommands that read a device.
#pragma once

#include <string>

#include "app/command_line.hpp"
#include "session/acquisition/realtime.hpp"

namespace isograsp::app {

class RealtimeOption {
 public:
  void add_to(Subcommand command) {
    command.option("--realtime", name_, "SCHED_FIFO and locked memory: off, prefer or require")
        .one_of({"off", "prefer", "require"})
        .shows_default();
  }
  [[nodiscard]] session::Realtime wish() const { return *session::realtime_from_name(name_); }

 private:
  std::string name_ = "prefer";
};

}  // namespace isograsp::app
