// SPDX-License-Identifier: GPL-3.0-or-later
// A drink as a trial: the same numbers as of a recording, whatever else happens in a session.
#include "tasks/kinds/arm/drinking.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "tasks/score.hpp"
#include "tests/support/drinking_motion.hpp"
#include "tests/support/every.hpp"
#include "tests/support/must.hpp"
#include "tests/tasks/specs.hpp"

namespace isograsp::tasks::drinking_test {
namespace {

using test::healthy_drinking;

constexpr double kLeadIn_s = 0.4;

/// Columns of a trial; of a part without positions none.
Signals trial(const DrinkingMarkers& markers, double paused_from_s = 1e3,
              double paused_to_s = 1e3) {
  const DrinkingSpec spec;
  const std::vector<Vec3>* const parts[] = {&markers.hand,  &markers.glass,    &markers.face,
                                            &markers.trunk, &markers.shoulder, &markers.elbow,
                                            &markers.wrist};
  std::vector<std::string> names{"t_s", "phase", "sample_flags"};
  for (std::size_t part = 0; part < kDrinkingPartCount; ++part)
    for (const char* axis : {"_x_m", "_y_m", "_z_m"})
      if (!parts[part]->empty()) names.push_back("marker_" + spec.markers[part] + axis);
  Signals signals(names);
  for (std::size_t k = 0; k < markers.t_s.size(); ++k) {
    const double t_s = markers.t_s[k];
    const Phase phase = t_s >= paused_from_s && t_s < paused_to_s ? Phase::paused
                        : t_s < kLeadIn_s                         ? Phase::lead_in
                                                                  : Phase::active;
    constexpr double kUnseenObject = 2.0;  // flags are about another object
    std::vector<double> row{t_s, static_cast<double>(phase), kUnseenObject};
    for (const auto* part : parts)
      if (!part->empty()) row.insert(row.end(), {(*part)[k].x(), (*part)[k].y(), (*part)[k].z()});
    signals.append_row(row);
  }
  return signals;
}
std::vector<Measure> scored(const Signals& signals) {
  return score(test::spec_of(DrinkingSpec{}), signals);
}
const Measure& measure(const std::vector<Measure>& all, std::string_view name,
                       std::string_view channel) {
  for (const Measure& one : all)
    if (one.name == name && one.channel == channel) return one;
  throw std::runtime_error("no measure " + std::string(name));
}

TEST(Drinking, ATrialHasTheBitsOfARecording) {
  const DrinkingMarkers markers = healthy_drinking();
  const auto measures = scored(trial(markers));
  const DrinkingTask task = drinking_task(markers);
  ASSERT_EQ(measures.size(), task.measures.size());
  for (std::size_t i = 0; i < measures.size(); ++i) {
    EXPECT_EQ(measures[i].name, task.measures[i].name);
    EXPECT_EQ(measures[i].channel, task.measures[i].channel);
    EXPECT_EQ(measures[i].unit, task.measures[i].unit);
    EXPECT_EQ(measures[i].value.value(), *task.measures[i].value) << measures[i].name;
    EXPECT_EQ(measures[i].samples, static_cast<std::int64_t>(markers.t_s.size()));
  }
}

TEST(Drinking, NothingCountsAfterTheEndOfTheTask) {
  const auto plain = scored(trial(healthy_drinking()));
  Signals longer = trial(healthy_drinking());
  const std::size_t columns = longer.names().size();
  for (int k = 1; k <= 50; ++k) {
    std::vector<double> row(columns, 5.0);  // far away, in phase 5
    row[0] = 7.0 + 0.01 * k;
    longer.append_row(row);
  }
  const auto measures = scored(longer);
  for (std::size_t i = 0; i < plain.size(); ++i) {
    EXPECT_EQ(measures[i].value, plain[i].value) << plain[i].name;
    EXPECT_EQ(measures[i].excluded, 0);
  }
}

TEST(Drinking, APauseIsAHole) {
  // While the hand carries the glass: the phases are known, its speed is not all the way.
  const auto measures = scored(trial(healthy_drinking(), 2.1, 2.3));
  EXPECT_TRUE(measure(measures, "total_movement_time", "task").value);
  EXPECT_EQ(measure(measures, "movement_units", "reaching_forward").reason, "gap");
  EXPECT_EQ(measure(measures, "total_movement_time", "task").excluded, 20);
}

TEST(Drinking, WhatTheRigDoesNotHaveIsNotMeasuredAndWhatIsNeededIsNamed) {
  DrinkingMarkers markers = healthy_drinking();
  markers.trunk.clear();
  markers.wrist.clear();
  const auto measures = scored(trial(markers));
  EXPECT_EQ(measure(measures, "trunk_displacement", "trunk").reason, "trunk not measured");
  EXPECT_EQ(measure(measures, "elbow_extension", "reaching").reason,
            "shoulder, elbow and wrist are needed");
  EXPECT_TRUE(measure(measures, "total_movement_time", "task").value);
  markers.face.clear();
  for (const Measure& one : test::every(scored(trial(markers)))) {
    EXPECT_FALSE(one.value);
    EXPECT_NE(one.reason.find("marker_FACE_x_m"), std::string::npos) << one.reason;
  }
}

TEST(Drinking, IsOverAfterItsTimeWhateverIsSeen) {
  DrinkingSpec spec;
  spec.lead_in_s = 1.0;
  spec.duration_s = 3.0;
  auto task = test::must(make_task(test::spec_of(spec), {}));
  int rows = 0;
  while (task->step(ArmInput{}).phase != Phase::done) ++rows;
  EXPECT_EQ(rows, 400);
}

TEST(Drinking, MarkersAreNamedByTheTaskAndTheFirstThreeAreNeeded) {
  const std::string head =
      "format = \"isograsp-task-1\"\nname = \"D\"\ninstruction = \"D.\"\nkind = \"drinking\"\n";
  const auto named =
      test::must(parse_task(head + "hand_marker = \"M3\"\ntrunk_marker = \"\"\n", "d.toml"));
  EXPECT_EQ(named.kind->markers(named.kind), (std::vector<std::string>{"M3", "GLASS", "FACE"}));
  const auto none = parse_task(head + "glass_marker = \"\"\n", "d.toml");
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().field, "glass_marker");
}

}  // namespace
}  // namespace isograsp::tasks::drinking_test
