// SPDX-License-Identifier: GPL-3.0-or-later
// What a group report says, before anybody decides how it looks: PDF and HTML are written from the
// same blocks; the numbers go into JSON, the values into CSV.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "reports/paper/page_furniture.hpp"
#include "reports/study/study_analysis.hpp"

namespace isograsp::reports {

struct StudyHeading {
  std::string text;
  bool large = false;
};
struct StudyParagraph {
  std::string text;
  bool quiet = false;
};
struct StudyTable {
  std::string caption;
  std::vector<std::string> heads;
  std::vector<std::vector<std::string>> rows;
  std::size_t words = 1;  ///< the first columns hold words, all others numbers
};
/// Box plots side by side, each value a dot. In the printed unit.
struct StudyPlot {
  std::string title;
  std::string description;                  ///< for people who do not see it
  std::string unit;                         ///< at the axis
  std::vector<std::string> names;           ///< of the conditions
  std::vector<std::vector<double>> values;  ///< [condition][subject], the same subjects each
  const Language* language = &kEnglish;     ///< of the numbers at the axes
};
using StudyBlock = std::variant<StudyHeading, StudyParagraph, StudyTable, StudyPlot>;

struct StudyReport {
  PageFurniture furniture;
  std::vector<StudyBlock> blocks;
};
/// @param analyses  one for each group of `data`
/// @param language  must outlive what is painted of the report
[[nodiscard]] StudyReport study_report(const Study& study, const StudyData& data,
                                       const std::vector<GroupAnalysis>& analyses,
                                       const Language& language = kEnglish);

/// Every figure, undefined ones as null with their reason.
[[nodiscard]] std::string study_json(const Study& study, const StudyData& data,
                                     const std::vector<GroupAnalysis>& analyses);
/// One row per subject and condition.
[[nodiscard]] std::string study_csv(const Study& study, const StudyData& data);

}  // namespace isograsp::reports
