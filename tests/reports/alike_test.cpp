// SPDX-License-Identifier: GPL-3.0-or-later
// What is alike but for the last bits of computed numbers is alike: trials that are drawn as best
// and worst, conditions under which trials may be compared.
#include <cmath>
#include <filesystem>

#include <gtest/gtest.h>

#include "core/files.hpp"
#include "reports/findings/comparable.hpp"
#include "reports/findings/task_section.hpp"

namespace isograsp::reports::alike_test {
namespace {

double next(double value) {
  return std::nextafter(value, HUGE_VAL);
}

TEST(Extremes, TrialsThatAreAlikeButForTheLastBitAreNeitherBestNorWorst) {
  const auto file =
      std::filesystem::path(ISOGRASP_SOURCE_DIR) / "library" / "tasks" / "grip_sine.toml";
  const auto text = read_text(file);
  ASSERT_TRUE(text);
  storage::SessionRecord session;
  std::vector<StoredTrial> trials(4);
  std::vector<const StoredTrial*> all;
  for (auto& one : trials) {
    one.session_record = &session;
    one.trial.task_text = *text;
    one.trial.status = storage::TrialStatus::completed;
    Measure error;
    error.name = "relative_rmse";
    error.channel = "force";
    error.value = 12.0;
    one.measures.push_back(error);
    all.push_back(&one);
  }
  TaskSection section;
  section.spec = tasks::parse_task(*text, file).value();
  MeasureSeries series;
  series.name = "relative_rmse";
  series.channel = "force";
  series.key = true;
  section.series.push_back(series);
  trials[2].measures[0].value = next(12.0);
  EXPECT_EQ(extremes_of(section, all).best, nullptr);
  trials[0].measures[0].value = next(next(12.0));
  trials[3].measures[0].value = 13.0;
  EXPECT_EQ(extremes_of(section, all).best, &trials[0]) << "the oldest of the best";
  EXPECT_EQ(extremes_of(section, all).worst, &trials[3]);
}

TEST(Conditions, DifferByMoreThanTheLastBitOfADelay) {
  Conditions one;
  one.rate_Hz = 100.0;
  one.device_delay_s = 0.1 + 0.2;
  one.display_delay_s = 0.03;
  Conditions other = one;
  other.rate_Hz = next(100.0);
  other.device_delay_s = 0.3;
  other.display_delay_s = next(0.03);
  EXPECT_EQ(english(difference(one, other)), "");
  other.display_delay_s = 0.0301;
  EXPECT_EQ(english(difference(one, other)), "other delay of the display");
  other.display_delay_s.reset();
  EXPECT_EQ(english(difference(one, other)), "other delay of the display");
  other = one;
  other.device_delay_s = 0.301;
  EXPECT_EQ(english(difference(one, other)), "other filter delay of the device");
}

}  // namespace
}  // namespace isograsp::reports::alike_test
