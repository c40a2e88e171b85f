// SPDX-License-Identifier: GPL-3.0-or-later
// Parts of a report that are the same on paper and on the web: a heading, sentences, plots side by
// side, a table, all of it said in the language. What they say is decided once (summary_panels.cpp,
// both_hands_panels.cpp, patient_page.cpp), how they look by the two writers.
#pragma once

#include <QSizeF>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "reports/findings/report_content.hpp"
#include "reports/findings/wording.hpp"

namespace isograsp::reports {

class PlotView;

struct PanelPlot {
  std::string title;        ///< above the plot
  std::string description;  ///< for people who do not see it
  double share = 1.0;       ///< of the width
  double height = 100.0;    ///< [points]
  std::function<PlotView(QSizeF size, double unit)> make;
};
struct PanelTable {
  std::string caption;  ///< for people who do not see where it stands
  std::vector<std::string> heads;
  std::vector<double> shares;  ///< of the width, one for each column
  std::vector<std::vector<std::string>> rows;
};
struct Panel {
  std::string heading;
  std::vector<std::string> lines;
  std::vector<PanelPlot> plots;
  std::optional<PanelTable> table;
  std::vector<std::string> notes;   ///< small
  std::vector<std::string> blanks;  ///< to be filled in by hand: a word under each line
  bool large_print = false;         ///< a page of its own, for the patient
  bool own_page = false;            ///< begins a page
  bool of_task = false;             ///< stands below a task: a smaller heading
};

/// Goals, what limits this hand: before the last measurement is judged. The content and the
/// language must outlive the panels.
[[nodiscard]] std::vector<Panel> panels_above(const ReportContent& content,
                                              const Language& language);
/// The compass and the dose: before the tasks.
[[nodiscard]] std::vector<Panel> panels_between(const ReportContent& content,
                                                const Language& language);
/// Signature and the page for the patient: the end.
[[nodiscard]] std::vector<Panel> panels_below(const ReportContent& content,
                                              const Language& language);

/// The page of both hands: sharing and lag, lifting and carrying. Empty: they never worked
/// together.
[[nodiscard]] std::vector<Panel> both_hands_panels(const ReportContent& content,
                                                   const Language& language);

/// Below a task with postures: each posture as a row, how the links shared the movements of the
/// last trial. Nothing: another kind of task. The section and the language must outlive it.
[[nodiscard]] std::optional<Panel> postures_panel(const TaskSection& section,
                                                  const Language& language);

/// The page for the patient: plain words, large letters, one picture.
[[nodiscard]] Panel patient_page(const ReportContent& content, const Language& language);

/// Minutes of each week as bars. Needs a QApplication.
[[nodiscard]] PlotView dose_plot(const PracticeDose& dose, bool large, QSizeF size, double unit,
                                 const Language& language);

}  // namespace isograsp::reports
