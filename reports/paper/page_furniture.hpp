// SPDX-License-Identifier: GPL-3.0-or-later
// Header, footer, watermark and facts around the content of a report, on every page or at its
// beginning. UTF-8.
#pragma once

#include <string>
#include <vector>

#include "reports/findings/report_text.hpp"

namespace isograsp::reports {

struct PageFurniture {
  std::string kind;         ///< "Progress report"
  std::string title;        ///< of this one: a patient's code, a study
  std::vector<Fact> facts;  ///< at most five
  std::string watermark;    ///< empty: none
  std::string footer;
  const Language* language = &kEnglish;  ///< that all of it is said in
};
/// A title of more characters than a patient's code has is set smaller.
inline constexpr std::size_t kLongTitle = 24;
[[nodiscard]] inline PageFurniture furniture_of(const ReportContent& content,
                                                const Language& language) {
  const Speaker say(language);
  return {say("Progress report"_text), content.code,         header_facts(content, language),
          say(watermark(content)),     say(footer(content)), &language};
}

}  // namespace isograsp::reports
