// SPDX-License-Identifier: GPL-3.0-or-later
// A panel of a report as a section of HTML.
#pragma once

#include <QString>

#include "reports/paper/panel.hpp"

namespace isograsp::reports {

[[nodiscard]] QString html_section(const Panel& panel);

}  // namespace isograsp::reports
