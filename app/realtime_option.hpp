// SPDX-License-Identifier: GPL-3.0-or-later
// --realtime of the subcommands that read a device.
#pragma once

#include <string>

#include <CLI/CLI.hpp>

#include "session/realtime.hpp"

namespace isograsp {

class RealtimeOption {
 public:
  void add_to(CLI::App& command) {
    command.add_option("--realtime", name_, "SCHED_FIFO and locked memory: off, prefer or require")
        ->check(CLI::IsMember({"off", "prefer", "require"}))
        ->capture_default_str();
  }
  [[nodiscard]] Realtime wish() const { return *realtime_from_name(name_); }

 private:
  std::string name_ = "prefer";
};

}  // namespace isograsp
