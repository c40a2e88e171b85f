// SPDX-License-Identifier: GPL-3.0-or-later
// A trial of an arm that cameras saw, in every format: segments and markers are motion, forces are
// not spoken of, and the validator of BIDS has nothing against it.
#include <cmath>
#include <map>
#include <set>
#include <sstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/csv.hpp"
#include "storage/access/open_store.hpp"
#include "storage/records/session_store.hpp"
#include "tests/support/bids_validator.hpp"
#include "tests/support/command.hpp"
#include "tests/support/every.hpp"
#include "tests/support/files_below.hpp"
#include "tests/support/within.hpp"

namespace isograsp::app::motion_export_test {
namespace {

using Json = nlohmann::json;
using test::isograsp;
using test::TemporaryFolder;

const std::vector<std::string> kRoles{"brace", "elbow", "forearm", "dorsum", "object"};
constexpr int kRowsOfASecond = 100;
constexpr int kRows = 2 * kRowsOfASecond;

/// A forearm that turns by 1 rad about x within two seconds, with dorsum and object; the elbow is
/// out of sight in the first five rows, the marker F1 in the last one.
class MotionExport : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = std::make_unique<TemporaryFolder>();
    const auto store =
        storage::open_store(folder_->path("arm.db"), storage::OpenMode::create).value();
    storage::SessionRecord session;
    session.patient_id = store->add_patient("A-01").value().id;
    session.started_utc = "2026-05-04T09:00:00Z";
    session.hand = Hand::left;
    session.device_uri = "qtm://secret-host?rig=/home/secret/rig.toml";
    session.device_description = "cameras";
    session.recorded = true;
    session.rate_Hz = 100.0;
    session.references = {{"position_tolerance_m", 0.015}};
    session.software_version = "0.1.0";
    storage::TrialRecord trial;
    trial.session_id = store->begin_session(session).value();
    trial.number = 1;
    trial.task_name = "Turn the knob";
    trial.task_text = "not a task file";
    trial.references = {{"angle_tolerance_deg", 8.0}};
    trial.groups = {{"task", {"t_s", "phase"}}, {"arm", {}}, {"markers", {}}};
    for (const std::string& role : kRoles)
      for (const char* end : {"_x_m", "_y_m", "_z_m", "_qw", "_qx", "_qy", "_qz"})
        trial.groups[1].columns.push_back(role + end);
    for (const char* marker : {"F1", "=F2"})
      for (const char* end : {"_x_m", "_y_m", "_z_m"})
        trial.groups[2].columns.push_back(std::string(marker) + end);
    trial.id = store->begin_trial(trial).value();
    std::vector<std::vector<double>> rows(3);
    for (int k = 0; k < kRows; ++k) {
      if (k > 0 && k % kRowsOfASecond == 0) {
        ASSERT_TRUE(store->append_blocks(trial.id, k / kRowsOfASecond - 1, rows).ok());
        rows.assign(3, {});
      }
      rows[0].insert(rows[0].end(), {0.01 * k, 1.0});
      const double half = 0.5 * k / kRows;
      for (const std::string& role : kRoles) {
        const bool turns = role != "brace" && role != "elbow";
        std::vector<double> pose{0.1, 0.2, 0.01 * k, 1.0, 0.0, 0.0, 0.0};
        if (turns) pose[3] = std::cos(half);
        if (turns) pose[4] = std::sin(half);
        if (role == "elbow" && k < 5) pose.assign(7, std::nan(""));
        rows[1].insert(rows[1].end(), pose.begin(), pose.end());
      }
      const double seen = k + 1 == kRows ? std::nan("") : 1.0;
      rows[2].insert(rows[2].end(), {0.3 * seen, 0.4 * seen, 0.5 * seen, 1.0, 2.0, 3.0});
    }
    ASSERT_TRUE(store->append_blocks(trial.id, kRows / kRowsOfASecond - 1, rows).ok());
    trial.status = storage::TrialStatus::completed;
    ASSERT_TRUE(store->end_trial(trial, {}).ok());
  }
  static void TearDownTestSuite() { folder_.reset(); }

  static std::string exported(const std::string& format) {
    const std::string out = folder_->path(format);
    if (std::filesystem::exists(out)) return out;
    const auto done = isograsp("export --db " + folder_->path("arm.db") + " --format " + format +
                               " --out " + out);
    EXPECT_EQ(done.status, 0) << done.err;
    return out;
  }

  static inline std::unique_ptr<TemporaryFolder> folder_;
};

const std::string kBidsStem =
    "/sub-01/ses-01/motion/sub-01_ses-01_task-unknown_tracksys-cameras_run-01_";

TEST_F(MotionExport, TheValidatorOfBidsFindsNoError) {
  const auto sound = test::validate_bids(exported("bids"));
  const Json report = Json::parse(sound.out, nullptr, false);
  ASSERT_FALSE(report.is_discarded()) << sound.err;
  EXPECT_EQ(test::codes_of(report["issues"]["errors"]), "") << report["issues"]["errors"].dump(1);
  EXPECT_EQ(report["summary"]["dataTypes"], Json::array({"channels", "events", "motion"}));
}

TEST_F(MotionExport, BidsCallsSegmentsAndMarkersMotionAndCountsWhatIsTracked) {
  const std::string stem = exported("bids") + kBidsStem;
  std::istringstream channels(test::read_file(stem + "channels.tsv"));
  std::map<std::string, std::string> type;
  std::string line;
  std::getline(channels, line);
  while (std::getline(channels, line)) {
    std::vector<std::string> cells;
    std::istringstream in(line);
    for (std::string cell; std::getline(in, cell, '\t');) cells.push_back(cell);
    ASSERT_EQ(cells.size(), 8U) << line;
    type[cells[0]] = cells[1] + " " + cells[2] + " " + cells[3] + " " + cells[4] + " " + cells[5];
  }
  EXPECT_EQ(type["t_s"], "n/a LATENCY n/a s n/a");
  EXPECT_EQ(type["forearm_x_m"], "x POS forearm m cameras");
  EXPECT_EQ(type["forearm_qw"], "quat_w ORNT forearm n/a cameras");
  EXPECT_EQ(type["F1_z_m"], "z POS F1 m cameras");
  EXPECT_EQ(type["'=F2_x_m"], "x POS '=F2 m cameras") << "no formula";
  EXPECT_EQ(type["elbow_forearm_x_rad"], "x JNTANG elbow_forearm rad link");
  EXPECT_EQ(type.size(), 2U + 5 * 7 + 2 * 3 + 3 * 3);
  const Json motion = Json::parse(test::read_file(stem + "motion.json"));
  EXPECT_EQ(motion["TrackedPointsCount"], 7);
  EXPECT_EQ(motion["POSChannelCount"], 5 * 3 + 2 * 3);
  EXPECT_EQ(motion["ORNTChannelCount"], 5 * 4);
  EXPECT_EQ(motion["JNTANGChannelCount"], 3 * 3);
  EXPECT_EQ(motion["MotionChannelCount"], 21 + 20 + 9);
  EXPECT_EQ(motion["ManufacturersModelName"], "Recorded markers");
  const Json frames = Json::parse(test::read_file(stem + "channels.json"));
  EXPECT_TRUE(frames["reference_frame"]["Levels"].contains("cameras"));
  EXPECT_TRUE(frames["reference_frame"]["Levels"].contains("link"));
}

TEST_F(MotionExport, ATableHasPosesMarkersAndHowFarEachLinkHasTurned) {
  const std::string stem = exported("csv") + "/patient_1/session_1/trial_1";
  const auto signals = read_signals(stem + "_signals.csv").value();
  ASSERT_EQ(signals.rows(), static_cast<std::size_t>(kRows));
  const auto turned = signals.column("elbow_forearm_x_rad");
  const auto still = signals.column("forearm_dorsum_x_rad");
  ASSERT_EQ(turned.size(), signals.rows());
  constexpr double kExact_rad = 1e-12;
  for (std::size_t row = 0; row < signals.rows(); ++row) {
    ASSERT_EQ(std::isnan(turned[row]), row < 5) << row;
    ASSERT_WITHIN(still[row], 0.0, kExact_rad);
    if (row < 5) continue;
    ASSERT_WITHIN(turned[row], static_cast<double>(row - 5) / kRows, kExact_rad)
        << "from the first row that has both";
  }
  EXPECT_TRUE(std::isnan(signals.column("F1_x_m").back()));
  const Json sidecar = Json::parse(test::read_file(stem + ".json"));
  std::map<std::string, Json> column;
  for (const Json& one : test::every(sidecar["columns"])) column[one["name"]] = one;
  EXPECT_EQ(column["dorsum_qy"]["group"], "arm");
  EXPECT_EQ(column["dorsum_qy"]["axes"], "cameras");
  EXPECT_EQ(column["dorsum_qy"]["description"], "Attitude of the segment dorsum, quaternion y");
  EXPECT_EQ(column["F1_y_m"]["description"], "Position of the marker F1 along y");
  EXPECT_EQ(column["dorsum_object_z_rad"]["group"], "angles");
  EXPECT_EQ(sidecar["trial"]["angle_tolerance_deg"], 8.0) << "what it was given, by name";
  EXPECT_EQ(sidecar["session"]["position_tolerance_m"], 0.015);
  EXPECT_EQ(sidecar["session"]["device"], "Recorded markers");
  test::AtLeast facts(10);
  for (const char* of : {"session", "trial"})
    for (const auto& [name, value] : sidecar[of].items()) {
      EXPECT_FALSE(name.ends_with("_N")) << name << ": an arm has no forces";
      ++facts;
    }
}

TEST_F(MotionExport, H5pyReadsGroupsOfSegmentsMarkersAndAngles) {
  const auto read =
      test::run("/usr/bin/python3 " ISOGRASP_SOURCE_DIR "/tests/support/read_hdf5.py " +
                exported("hdf5") + "/isograsp.h5");
  ASSERT_EQ(read.status, 0) << read.err << "install what is missing: scripts/setup --test";
  const Json trial = Json::parse(read.out)["patients"]["A-01"]["session-01"]["trial-01"];
  const Json& arm = trial["signals"]["arm"];
  EXPECT_EQ(arm["@"]["columns"].size(), 35U);
  EXPECT_EQ(arm["@"]["axes"][3], "cameras");
  EXPECT_EQ(arm["@"]["units"][0], "m");
  EXPECT_EQ(arm["value"].size(), static_cast<std::size_t>(kRows));
  EXPECT_EQ(trial["signals"]["markers"]["@"]["columns"][3], "=F2_x_m");
  EXPECT_EQ(trial["signals"]["angles"]["@"]["units"][0], "rad");
}

TEST_F(MotionExport, NoFormatTellsWhereTheCamerasAre) {
  for (const char* format : {"csv", "bids", "fhir", "hdf5"}) {
    const std::string out = exported(format);
    for (const auto& file : test::every(test::files_below(out))) {
      const std::string text = test::read_file(out + "/" + file);
      EXPECT_EQ(text.find("secret"), std::string::npos) << file;
      EXPECT_EQ(text.find("2026-05"), std::string::npos) << file;
    }
  }
}

}  // namespace
}  // namespace isograsp::app::motion_export_test
