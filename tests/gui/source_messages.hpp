// SPDX-License-Identifier: GPL-3.0-or-later
// Messages read from the source: what the layers below say when something fails.
#pragma once

#include <set>
#include <string>
#include <string_view>

namespace isograsp::gui {

/// What is wrong and what to do about it, wherever this C++ source makes an error of it. What
/// stands between the fixed words is %1, %2 …: "is %1, not a table".
[[nodiscard]] std::set<std::string> messages_in(std::string_view code);

}  // namespace isograsp::gui
