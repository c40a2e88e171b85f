// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the tests: none waits for a fixed time before it asserts. On a busy machine it would be too
// short, on an idle one it is lost: a loop that ends with a condition waits as long as it takes.
#include <map>
#include <regex>
#include <string>

#include <gtest/gtest.h>

#include "tests/architecture/house.hpp"
#include "tests/support/every.hpp"

namespace isograsp::waiting_test {
namespace {

using namespace architecture;

/// How many waits of a fixed time a file may have, and why.
struct FixedWaits {
  int count;
  const char* reason;
};

const std::map<std::string, FixedWaits>& fixed_waits() {
  static const std::map<std::string, FixedWaits> kWaits{
      {"tests/gui/screenshots.cpp", {23, "makes pictures of what moves; asserts nothing of them"}},
      {"tests/gui/patient_page_test.cpp", {1, "that a replay stands shows only in time"}},
      {"tests/gui/report_work_test.cpp", {1, "that nothing arrives any more shows only in time"}},
      {"tests/gui/fault_test.cpp", {2, "the disk is looked at in the background, unseen"}},
      {"tests/storage/kill_test.cpp", {3, "a process is ended at a random moment"}},
      {"tests/storage/newer_measures_test.cpp", {1, "a process is ended at a random moment"}},
      {"tests/storage/writer.cpp", {1, "records ten times a second; asserts nothing"}},
      {"tests/device/udp_bus_test.cpp",
       {3, "a computer that is busy elsewhere; arrivals while the other side waits"}}};
  return kWaits;
}

/// True for a line that waits, unless it is all that a loop with a condition does: on the same line
/// or the line before.
bool waits_for_a_fixed_time(const std::string& before, const std::string& line) {
  static const std::regex kWait(R"(\b(qWait|qSleep|sleep_for|usleep|nanosleep|sleep)\s*\()");
  static const std::regex kLoop(R"(\b(while|for)\s*\(|\bif \(.*\) return )");
  return std::regex_search(line, kWait) && !std::regex_search(line, kLoop) &&
         !std::regex_search(before, kLoop);
}

TEST(Waiting, IsForAConditionOrListedWithItsReason) {
  std::map<std::string, int> found;
  for (const Source& source : test::every(all_tests())) {
    if (source.file == "tests/architecture/waiting_test.cpp") continue;
    std::string before;
    for (const std::string& line : source.lines) {
      if (waits_for_a_fixed_time(before, line)) ++found[source.file];
      before = line;
    }
  }
  for (const auto& [file, count] : test::every(found)) {
    const auto listed = fixed_waits().find(file);
    EXPECT_EQ(count, listed == fixed_waits().end() ? 0 : listed->second.count)
        << file << ": wait until something is so (wait_until, laid_out)";
  }
  for (const auto& [file, waits] : test::every(fixed_waits()))
    EXPECT_TRUE(found.contains(file)) << file << " waits no more: take it from the list";
}

TEST(Waiting, OfAFixedTimeIsToldFromThatForACondition) {
  EXPECT_TRUE(waits_for_a_fixed_time("", "  QTest::qWait(100);"));
  EXPECT_TRUE(waits_for_a_fixed_time("", "  std::this_thread::sleep_for(20ms);  // busy"));
  EXPECT_FALSE(waits_for_a_fixed_time("", "  while (!done()) std::this_thread::sleep_for(20ms);"));
  EXPECT_FALSE(waits_for_a_fixed_time("  while (!done())", "    QTest::qWait(10);"));
  EXPECT_FALSE(waits_for_a_fixed_time("", "  EXPECT_FALSE(patient_traits(\"sleepy\"));"));
}

}  // namespace
}  // namespace isograsp::waiting_test
