// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/presenter/window_apparatuses.hpp"

#include <vector>

namespace isograsp::gui {

namespace {

Result<std::unique_ptr<session::Apparatus>> refuse(const session::ApparatusRequest& request) {
  return refused("these windows do not show an arm seen by markers yet"_text,
                 "measure it with isograsp run, without windows"_text)
      .at(request.uri.text);
}

}  // namespace

std::span<const session::ApparatusRow> window_apparatuses() {
  static const std::vector<session::ApparatusRow> kRows = [] {
    const auto all = session::all_apparatuses();
    std::vector<session::ApparatusRow> rows(all.begin(), all.end());
    for (std::size_t i = 0; i + 1 < rows.size(); ++i) rows[i].open = refuse;  // the last: platform
    return rows;
  }();
  return kRows;
}

}  // namespace isograsp::gui
