// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/paper/page_furniture.hpp"

namespace isograsp::reports {

PageFurniture furniture_of(const ReportContent& content) {
  return {"Progress report", content.code, header_facts(content), watermark(content),
          footer(content)};
}

}  // namespace isograsp::reports
