// SPDX-License-Identifier: GPL-3.0-or-later
// Small logic behind the windows: codes, devices, force history, series, words.
#include "gui/words/words.hpp"

#include <cmath>
#include <filesystem>
#include <set>

#include <gtest/gtest.h>

#include "device/config/uri.hpp"
#include "gui/clinic/history.hpp"
#include "gui/clinic/patient_code.hpp"
#include "gui/device_pages/device_list.hpp"
#include "gui/look/force_history.hpp"
#include "storage/records/patient_code.hpp"
#include "tests/support/every.hpp"
#include "tests/support/temporary_folder.hpp"

namespace isograsp::gui::words_test {
namespace {

TEST(PatientCode, IsAcceptedByTheDatabaseAndNeverTakenTwice) {
  std::mt19937_64 entropy(1);
  std::vector<storage::PatientRecord> taken;
  std::set<std::string> codes;
  for (int i = 0; i < 500; ++i) {
    storage::PatientRecord patient;
    patient.code = generate_patient_code(taken, entropy);
    EXPECT_TRUE(storage::check_patient_code(patient.code).ok()) << patient.code;
    EXPECT_TRUE(codes.insert(patient.code).second);
    EXPECT_EQ(patient.code.find_first_of("01OI", 2), std::string::npos) << patient.code;
    taken.push_back(patient);
  }
}

TEST(DeviceList, FindsCanInterfacesAndNothingElse) {
  test::TemporaryFolder folder;
  for (const auto& [name, type] :
       {std::pair{"can1", "280\n"}, {"can0", "280\n"}, {"eth0", "1\n"}, {"lo", "772\n"}}) {
    std::filesystem::create_directory(folder.path(name));
    folder.write(std::string(name) + "/type", type);
  }
  const auto choices = list_devices("", {}, folder.path());
  ASSERT_GE(choices.size(), 2U);
  EXPECT_EQ(choices[0].uri, "can://can0?protocol=rft");
  EXPECT_EQ(choices[1].uri, "can://can1?protocol=rft");
  for (const auto& choice : test::every(choices))
    EXPECT_EQ(choice.uri.find("eth0"), std::string::npos);
}

TEST(DeviceList, ThePresetStandsFirstAndOnlyOnce) {
  const auto known = list_devices("sim://paretic?seed=7", {}, "/nonexistent");
  EXPECT_EQ(known[0].uri, "sim://paretic?seed=7");
  EXPECT_EQ(known.size(), list_devices("", {}, "/nonexistent").size());
  const auto other = list_devices("sim://healthy?seed=9", {}, "/nonexistent");
  EXPECT_EQ(other[0].uri, "sim://healthy?seed=9");
}

TEST(DeviceList, ARecordingsPathSurvivesTheUri) {
  for (const std::string path : {"/tmp/a b.csv", "/tmp/100%?.csv"}) {
    const auto uri = Uri::parse(recording_uri(path));
    ASSERT_TRUE(uri.ok()) << path;
    EXPECT_EQ(uri->target, path);
    EXPECT_EQ(uri->scheme, "replay");
  }
}

session::Snapshot frame_at(double t_s, double force_N) {
  session::Snapshot snapshot;
  snapshot.frames = 1 + static_cast<std::int64_t>(t_s * 100.0);
  snapshot.session_time_s = t_s;
  snapshot.forces.wrench_C[0].force.z() = force_N;
  return snapshot;
}

TEST(ShortNumber, OfWhatRoundsToZeroHasNoMinus) {
  EXPECT_EQ(short_number(-0.0049), "0.00");
  EXPECT_EQ(short_number(-0.0), "0.00");
  EXPECT_EQ(short_number(-0.0051), QString(QChar(0x2212)) + "0.01");
}

TEST(ForceHistory, ForgetsWhatIsOlderThanItsLength) {
  ForceHistory history(2.0);
  for (int i = 0; i <= 1000; ++i) history.add(frame_at(0.01 * i, 1.0));
  EXPECT_GE(history.points().front().t_s, 8.0 - 1e-9);
  EXPECT_EQ(history.points().back().t_s, 10.0);
}

TEST(ForceHistory, TakesAFrameOnceAndBeginsAnewWithAnotherSession) {
  ForceHistory history;
  history.add(frame_at(1.0, 1.0));
  history.add(frame_at(1.0, 1.0));
  EXPECT_EQ(history.points().size(), 1U);
  history.add(frame_at(0.5, 1.0));
  EXPECT_EQ(history.points().size(), 1U);
  EXPECT_EQ(history.points().front().t_s, 0.5);
}

TEST(ForceHistory, AMissingSampleIsAGapNotAZero) {
  ForceHistory history;
  auto snapshot = frame_at(1.0, 0.0);
  snapshot.forces.flags[0] = bit(SampleFlag::missing);
  history.add(snapshot);
  EXPECT_TRUE(std::isnan(history.points().back().normal_N[0]));
  EXPECT_FALSE(std::isnan(history.points().back().normal_N[1]));
}

TEST(ForceHistory, TheRangeHoldsEveryForce) {
  for (const double force : {-80.0, -1.0, 0.0, 0.3, 4.99, 5.0, 47.0, 300.0}) {
    ForceHistory history;
    history.add(frame_at(1.0, force));
    const auto range = history.range();
    EXPECT_LE(range.least_N, force);
    EXPECT_GE(range.most_N, force);
    EXPECT_LT(range.least_N, 0.0);
  }
}

storage::MeasurePoint point(storage::RowId trial, const char* task, const char* name, Hand hand,
                            bool simulated) {
  storage::MeasurePoint made;
  made.trial_id = trial;
  made.task_name = task;
  made.hand = hand;
  made.simulated = simulated;
  made.measure.name = name;
  made.measure.value = 1.0;
  return made;
}

TEST(History, NeverMixesHandsTasksOrSimulatedTrials) {
  const auto series = sort_history(
      {point(1, "Sine", "rmse", Hand::right, false), point(2, "Sine", "rmse", Hand::left, false),
       point(3, "Sine", "rmse", Hand::right, true), point(4, "Step", "rmse", Hand::right, false),
       point(5, "Sine", "rmse", Hand::right, false)});
  ASSERT_EQ(series.size(), 4U);
  for (const auto& one : test::every(series))
    for (const auto& entry : test::every(one.points)) {
      EXPECT_EQ(entry.hand, one.points[0].hand);
      EXPECT_EQ(entry.task_name, one.points[0].task_name);
      EXPECT_EQ(entry.simulated, one.points[0].simulated);
    }
}

TEST(History, TheNewestTaskStandsFirst) {
  const auto series = sort_history({point(1, "Sine", "rmse", Hand::right, false),
                                    point(2, "Maximum", "maximum_force", Hand::right, false),
                                    point(3, "Sine", "rmse", Hand::right, false)});
  ASSERT_EQ(series.size(), 2U);
  EXPECT_EQ(series[0].points[0].task_name, "Sine");
}

TEST(History, LastTimeIsTheNewestComparableTrialOfAnEarlierSession) {
  const auto in_session = [](storage::RowId session, storage::RowId trial, double value) {
    auto made = point(trial, "Sine", "rmse", Hand::right, false);
    made.session_id = session;
    made.measure.value = value;
    return made;
  };
  std::vector points{in_session(1, 1, 1.0), in_session(2, 2, 2.0), in_session(2, 3, 3.0),
                     in_session(2, 4, 4.0), in_session(2, 5, 5.0), in_session(3, 6, 6.0)};
  points[3].practice = true;
  points[4].helped = true;
  const auto series = sort_history(points);
  const Measure rmse = points[0].measure;
  const auto value = [&](const TrialLike& like) {
    const auto* before = last_time(series, like, rmse);
    return before == nullptr ? std::nullopt : before->measure.value;
  };
  TrialLike like{3, "Sine", 1, Hand::right, false};
  EXPECT_EQ(value(like), 3.0) << "neither practice nor help, nor today";
  like.session_id = 2;
  EXPECT_EQ(value(like), 1.0);
  like.session_id = 1;
  EXPECT_EQ(value(like), std::nullopt) << "the first time";
  for (const TrialLike& other :
       {TrialLike{3, "Sine", 2, Hand::right, false}, TrialLike{3, "Sine", 1, Hand::left, false},
        TrialLike{3, "Sine", 1, Hand::right, true}, TrialLike{3, "Step", 1, Hand::right, false}})
    EXPECT_EQ(value(other), std::nullopt) << "another version, hand, source or task";
}

TEST(Words, AMeasureWithoutValueSaysWhy) {
  Measure measure;
  measure.name = "lag";
  measure.reason = "the force does not follow the target";
  EXPECT_EQ(measure_value(measure), "–");
  EXPECT_EQ(measure_remark(measure).toStdString(), measure.reason);
}

TEST(Words, LostSamplesAreCountedOverAllSensors) {
  session::Snapshot snapshot = frame_at(1.0, 0.0);
  snapshot.health.sensors[0].lost = 2;
  snapshot.health.sensors[2].lost = 3;
  snapshot.health.bus.kernel_drops = 4;
  EXPECT_TRUE(health_line(snapshot, 0.0).contains("lost 9")) << "two, three and the kernel's four";
}

}  // namespace
}  // namespace isograsp::gui::words_test
