// SPDX-License-Identifier: GPL-3.0-or-later
// What is said at the end of a session: today against last time, whether it was valid, what comes
// next. In words, from what the report says of the same person.
#pragma once

#include <QString>
#include <QStringList>
#include <optional>
#include <vector>

#include "reports/findings/report_content.hpp"

namespace isograsp::gui {

/// One measure of today's session.
struct ClosingRow {
  QString measure;  ///< "Grip force, sine: tracking error, relative"
  QString today;    ///< mean of its trials
  QString before;   ///< in the session before; empty: there is none to compare with
  QString verdict;  ///< of a primary measure; empty: it is none
};

struct Closing {
  static constexpr std::size_t kMostRows = 4;

  std::vector<ClosingRow> rows;  ///< at most kMostRows, primary measures first
  QStringList doubts;            ///< what limits what today's values mean; empty: nothing does
  QString next;                  ///< what to train; empty: that cannot be said
};

/// Of the newest session in the content, of this hand (nothing: of both).
[[nodiscard]] Closing closing_of(const reports::ReportContent& content, std::optional<Hand> hand);

}  // namespace isograsp::gui
