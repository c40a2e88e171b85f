// SPDX-License-Identifier: GPL-3.0-or-later
// What the kernel says about one CAN interface. False if there is no such interface.
#pragma once

#include <string>

namespace isograsp {

[[nodiscard]] bool is_switched_on(const std::string& interface) noexcept;
/// Its controller has gone bus-off and was not restarted.
[[nodiscard]] bool is_off_the_bus(const std::string& interface);

}  // namespace isograsp
