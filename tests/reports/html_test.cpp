// SPDX-License-Identifier: GPL-3.0-or-later
// An HTML report is opened by people who trust it: whatever the database says stays text.
#include <cstdlib>

#include <gtest/gtest.h>

#include "reports/findings/progress_report.hpp"
#include "reports/findings/report_text.hpp"
#include "reports/paper/html_parts.hpp"
#include "reports/paper/html_writer.hpp"
#include "storage/access/open_store.hpp"
#include "tests/reports/demo_clinic.hpp"
#include "tests/reports/paper_test.hpp"
#include "tests/support/temporary_folder.hpp"

namespace isograsp::reports::html_test {
namespace {

constexpr const char* kHostile = "</style><script>alert(1)</script><img src=x onerror=alert(2)>";

struct Html : testing::Test {
  void SetUp() override { test::draw_without_a_display(); }
  static void expect_only_text(const std::string& html) {
    EXPECT_EQ(html.find("<script"), std::string::npos);
    EXPECT_EQ(html.find("<img"), std::string::npos);
    EXPECT_NE(html.find("&lt;script&gt;alert(1)"), std::string::npos) << "it is shown";
  }
};

TEST_F(Html, AReportForbidsTheBrowserToLoadOrRunAnything) {
  const std::string head = html_head({}).toStdString();
  const auto policy = head.find(
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src "
      "'unsafe-inline'; img-src data:; base-uri 'none'; form-action 'none'\">");
  ASSERT_NE(policy, std::string::npos) << head.substr(0, 600);
  EXPECT_LT(policy, head.find("<title>")) << "before anything that it governs";
  EXPECT_LT(policy, head.find("<style>"));
}

// Seen in a browser of 390 pixels: a caption beside blocks was one letter wide, and a name of two
// lines that had been taken out of the flow stood on the next cell.
TEST_F(Html, OnAPhoneTheNamesAndTheCaptionOfATableTakeTheirRoom) {
  const std::string style = html_head({}).toStdString();
  const auto narrow = style.find("@media (max-width: 640px)");
  ASSERT_NE(narrow, std::string::npos);
  const std::string phone = style.substr(narrow, style.find("@media print") - narrow);
  EXPECT_NE(phone.find(".cards caption"), std::string::npos) << phone;
  const auto name = phone.find("[data-head]::before");
  ASSERT_NE(name, std::string::npos);
  EXPECT_EQ(phone.find("position: absolute", name), std::string::npos) << phone;
}

TEST_F(Html, NamesFromTheDatabaseStayText) {
  PageFurniture furniture;
  furniture.kind = furniture.title = furniture.watermark = furniture.footer = kHostile;
  furniture.facts.push_back({kHostile, kHostile});
  expect_only_text((html_head(furniture) + html_end(furniture)).toStdString());
}

TEST_F(Html, AWholeReportOfHostileNamesNeedsNothingThatThePolicyForbids) {
  const test::TemporaryFolder folder;
  auto store = storage::open_store(folder.path("clinic.db"), storage::OpenMode::create);
  ASSERT_TRUE(store);
  test::add_course(**store, "P-1", false);
  auto content = gather_progress(**store, "P-1");
  ASSERT_TRUE(content);
  ASSERT_FALSE(content->sections.empty());
  for (auto& section : content->sections) {
    section.task = kHostile;
    section.notes.emplace_back("%1"_text(kHostile));
    for (auto& series : section.series) series.name = kHostile;
  }
  for (auto& session : content->sessions) session.device = kHostile;
  const auto path = folder.path("r.html");
  ASSERT_TRUE(write_html(*content, path));
  const std::string html = test::read_file(path);
  expect_only_text(html);
  EXPECT_NE(html.find("<svg"), std::string::npos);
  for (const char* outside : {"src=\"http", "url(http", "<link", "<iframe", "<object", "<base",
                              "@import", "xlink:href=\"http", "<form", "<script"})
    EXPECT_EQ(html.find(outside), std::string::npos) << outside;
}

}  // namespace
}  // namespace isograsp::reports::html_test
