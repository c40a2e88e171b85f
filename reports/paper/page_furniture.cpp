// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/paper/page_furniture.hpp"

namespace isograsp::reports {

PageFurniture furniture_of(const ReportContent& content, const Language& language) {
  const Speaker say(language);
  return {say("Progress report"_text), content.code,         header_facts(content, language),
          say(watermark(content)),     say(footer(content)), &language};
}

}  // namespace isograsp::reports
