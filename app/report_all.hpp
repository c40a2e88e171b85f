// SPDX-License-Identifier: GPL-3.0-or-later
// The progress reports of all patients of a clinic, for `isograsp report --all`.
#pragma once

#include <string>

#include "core/result.hpp"

namespace isograsp::app {

struct ReportAllOptions {
  std::string database;
  std::string folder;           ///< is made if absent; files of the same name are replaced
  std::string format = "html";  ///< "html" or "pdf"
  int threads = 1;
};
/// One file CODE.FORMAT for each patient, each whole or not at all. Plots belong to the main thread
/// of a process, so each worker is a process of its own; it takes the next patient that is left.
/// Errors: the first that was met; the other reports are written all the same, and the error says
/// how many are missing. @pre this process has made no thread and no QApplication yet
[[nodiscard]] Result<void> write_all_reports(const ReportAllOptions& options);

}  // namespace isograsp::app
