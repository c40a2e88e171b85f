// SPDX-License-Identifier: GPL-3.0-or-later
// The reports of all patients: a file for each, whoever fails.
#include <filesystem>
#include <fstream>
#include <set>

#include <gtest/gtest.h>

#include "storage/access/open_store.hpp"
#include "storage/records/session_store.hpp"
#include "tests/support/command.hpp"

namespace isograsp::app::report_all_test {
namespace {

namespace fs = std::filesystem;
using test::isograsp;
using test::TemporaryFolder;

constexpr int kPatients = 5;

/// Patients without sessions: their reports say so.
std::string clinic(const TemporaryFolder& folder) {
  const auto store =
      storage::open_store(folder.path("clinic.db"), storage::OpenMode::create).value();
  for (int i = 1; i <= kPatients; ++i)
    EXPECT_TRUE(store->add_patient("TK-" + std::to_string(i)).ok());
  return folder.path("clinic.db");
}
std::set<std::string> files_in(const std::string& folder) {
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.is_regular_file()) names.insert(entry.path().filename());
  return names;
}

TEST(ReportAll, WritesAFileForEachPatientWithAnyNumberOfThreads) {
  const TemporaryFolder folder;
  const std::string db = clinic(folder);
  for (const char* how : {"--threads 1", "--threads 3 --format pdf"}) {
    const std::string out = folder.path(how[10] == '1' ? "one" : "three");
    const auto done = isograsp("report --db " + db + " --all --out " + out + " " + how);
    EXPECT_EQ(done.status, 0) << done.err;
    const std::string ending = how[10] == '1' ? ".html" : ".pdf";
    std::set<std::string> expected;
    for (int i = 1; i <= kPatients; ++i) expected.insert("TK-" + std::to_string(i) + ending);
    EXPECT_EQ(files_in(out), expected);
  }
}

TEST(ReportAll, OneThatCannotBeWrittenKeepsNoOtherFromBeingWritten) {
  const TemporaryFolder folder;
  const std::string db = clinic(folder);
  fs::create_directories(folder.path("out/TK-3.html/in the way"));
  const auto done = isograsp("report --db " + db + " --all --out " + folder.path("out"));
  EXPECT_NE(done.status, 0);
  EXPECT_NE(done.err.find("1 of 5 reports are missing"), std::string::npos) << done.err;
  EXPECT_NE(done.err.find("TK-3.html"), std::string::npos) << done.err;
  EXPECT_EQ(files_in(folder.path("out")),
            (std::set<std::string>{"TK-1.html", "TK-2.html", "TK-4.html", "TK-5.html"}));
}

TEST(ReportAll, OnePatientAndAllExcludeEachOther) {
  const TemporaryFolder folder;
  const std::string db = clinic(folder);
  for (const char* who : {"", " --all --patient TK-1"})
    EXPECT_EQ(isograsp("report --db " + db + " --out " + folder.path("r.html") + who).status, 2)
        << who;
  EXPECT_FALSE(fs::exists(folder.path("r.html")));
}

}  // namespace
}  // namespace isograsp::app::report_all_test
