// SPDX-License-Identifier: GPL-3.0-or-later
// Recordings of markers that others made become patients and trials of an arm, through a rig.
#include <cmath>
#include <filesystem>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/csv.hpp"
#include "core/files.hpp"
#include "storage/access/open_store.hpp"
#include "storage/records/session_store.hpp"
#include "tests/support/command.hpp"
#include "tests/support/every.hpp"
#include "tests/support/recorded_data.hpp"
#include "tests/support/within.hpp"

namespace isograsp::app::import_markers_test {
namespace {

namespace fs = std::filesystem;
using test::isograsp;
using test::TemporaryFolder;

const std::string kData = ISOGRASP_SOURCE_DIR "/tests/data/isotonic/";
/// Poses in a file are unit quaternions again when they are read: the last bit of an angle.
constexpr double kFileRounding_rad = 1e-12;

std::string recording(const std::string& file, const std::string& rig,
                      const std::string& hand = "right") {
  return "format = \"isograsp-recording-1\"\nname = \"Two arms\"\nlabel = \"made up for a test\"\n"
         "source = \"nowhere\"\nlicence = \"none needed\"\ndevice = \"cameras\"\nfile = \"" +
         file + "\"\nrig = \"" + rig + "\"\npatient_prefix = \"ARM\"\npatient = \"who\"\n" +
         "trial = [\"take\"]\n" + (hand.empty() ? "" : "hand = \"" + hand + "\"\n") +
         R"(task = '''
format = "isograsp-task-1"
name = "Bending the wrist"
instruction = "Bend."
kind = "active_range"
link = "wrist"
angle = 1
duration_s = 3
'''
)";
}
test::CommandResult import(const TemporaryFolder& folder, const std::string& text) {
  folder.write("r.toml", text);
  return isograsp("import --recording " + folder.path("r.toml") + " --from " + folder.path() +
                  " --db " + folder.path("c.db"));
}
/// The markers of one synthetic session as a file of a folder.
void put_markers(const TemporaryFolder& folder, const std::string& name) {
  const auto made =
      isograsp("markers convert " + kData + "session_a_markers.csv --out " + folder.path(name));
  ASSERT_EQ(made.status, 0) << made.err;
}
void put_rig(const TemporaryFolder& folder) {
  fs::copy_file(kData + "kurillo15.toml", folder.path("rig.toml"));
}
double value_of(const std::vector<Measure>& measures, const std::string& name) {
  for (const Measure& measure : measures)
    if (measure.name == name && measure.value) return *measure.value;
  return std::nan("");
}
/// The measures of the only trial of the person `code`.
std::vector<Measure> measures_of(const TemporaryFolder& folder, const std::string& code) {
  const auto store = storage::open_store(folder.path("c.db"), storage::OpenMode::read_only).value();
  const auto patient = store->find_patient(code).value();
  const auto sessions = store->sessions(patient->id).value();
  const auto trials = store->trials(sessions.at(0).id).value();
  return store->measures(trials.at(0).id).value();
}
/// What `markers rom` says of the first angle of the wrist.
nlohmann::json range_of(const TemporaryFolder& folder, const std::string& markers) {
  const std::string rig = folder.path("rig.toml");
  const std::string poses = folder.path("poses.csv");
  EXPECT_EQ(
      isograsp("markers poses --rig " + rig + " --in " + folder.path(markers) + " --out " + poses)
          .status,
      0);
  const auto rom = isograsp("markers rom --rig " + rig + " --poses " + poses + " --json");
  EXPECT_EQ(rom.status, 0) << rom.err;
  const auto rows = nlohmann::json::parse(rom.out).at("rom");
  for (const auto& row : rows)
    if (row.at("link") == "FD" && row.at("angle") == 1) return row;
  return {};
}

TEST(ImportMarkers, AFolderOfC3DFilesBecomesPatientsWithTheRangesThatRomComputes) {
  const TemporaryFolder folder;
  put_rig(folder);
  put_markers(folder, "P1_a.c3d");
  put_markers(folder, "P2_a.c3d");
  const auto done = import(folder, recording("P{who}_{take}.c3d", "rig"));
  ASSERT_EQ(done.status, 0) << done.err;
  EXPECT_NE(done.out.find("2 patients, 2 sessions, 2 trials"), std::string::npos) << done.out;
  const auto range = range_of(folder, "P1_a.c3d");
  const auto measures = measures_of(folder, "ARM-01");
  EXPECT_WITHIN(value_of(measures, "least_angle"), range.at("min_held_rad").get<double>(),
                kFileRounding_rad);
  EXPECT_WITHIN(value_of(measures, "largest_angle"), range.at("max_held_rad").get<double>(),
                kFileRounding_rad);
  const auto verified = isograsp("db verify " + folder.path("c.db"));
  EXPECT_EQ(verified.status, 0) << verified.out << verified.err;
  const auto report = isograsp("report --db " + folder.path("c.db") + " --patient ARM-01 --out " +
                               folder.path("r.html"));
  ASSERT_EQ(report.status, 0) << report.err;
  EXPECT_NE(read_text(folder.path("r.html")).value().find("made up for a test"), std::string::npos);
}

TEST(ImportMarkers, TheRigAndEverySignalOfTheArmAreStoredAsASessionStoresThem) {
  const TemporaryFolder folder;
  put_rig(folder);
  put_markers(folder, "P1_a.csv");
  ASSERT_EQ(import(folder, recording("P{who}_{take}.csv", "rig")).status, 0);
  const auto store = storage::open_store(folder.path("c.db"), storage::OpenMode::read_only).value();
  const auto patient = store->find_patient("ARM-01").value();
  const auto session = store->sessions(patient->id).value().at(0);
  EXPECT_TRUE(session.recorded);
  EXPECT_EQ(session.calibration, read_text(kData + "kurillo15.toml").value());
  EXPECT_NE(session.provenance.find("by rig rig"), std::string::npos) << session.provenance;
  const auto trial = store->trials(session.id).value().at(0);
  const auto signals = store->signals(trial).value();
  const auto given = read_signals(folder.path("P1_a.csv")).value();
  ASSERT_EQ(signals.rows(), given.rows());
  for (const std::string name : {"marker_EL_x_m", "object_x_m", "wrist_a1_rad", "dorsum_state"})
    EXPECT_TRUE(signals.has(name)) << name;
  for (std::size_t row = 0; row < given.rows(); ++row) {
    const double seen_m = given.column("EL_x_m")[row];
    const double stored_m = signals.column("marker_EL_x_m")[row];
    ASSERT_TRUE(seen_m == stored_m || (std::isnan(seen_m) && std::isnan(stored_m))) << row;
  }
}

TEST(ImportMarkers, ALeftArmHasTheRangesOfItsReflection) {
  const TemporaryFolder right;
  const TemporaryFolder left;
  put_rig(right);
  put_rig(left);
  put_markers(right, "P1_a.csv");
  // The same recording with every x turned around; clusters of the rig are reflected by the
  // program, so the left rig must hold what cameras see of it, too.
  const auto given = read_signals(right.path("P1_a.csv")).value();
  std::string text;
  for (const std::string& name : given.names()) text += (text.empty() ? "" : ",") + name;
  text += "\n";
  for (std::size_t row = 0; row < given.rows(); ++row) {
    for (std::size_t c = 0; c < given.names().size(); ++c) {
      const double value = given.column(c)[row];
      const bool x = given.names()[c].ends_with("_x_m");
      text += (c == 0 ? "" : ",") + (std::isnan(value) ? "" : format_number(x ? -value : value));
    }
    text += "\n";
  }
  left.write("P1_a.csv", text);
  std::string rig = read_text(left.path("rig.toml")).value();
  const std::string begin = "template_m = [";
  const auto at = rig.find(begin);
  ASSERT_NE(at, std::string::npos);
  const auto end = rig.find('\n', at);
  std::string mirrored;
  for (std::size_t i = at + begin.size(); i < end; ++i) {
    mirrored += rig[i];
    if (rig[i] == '[') mirrored += rig[i + 1] == '-' ? (++i, "") : "-";
  }
  rig.replace(at + begin.size(), end - at - begin.size(), mirrored);
  left.write("rig.toml", rig);
  ASSERT_EQ(import(right, recording("P{who}_{take}.csv", "rig")).status, 0);
  const auto done = import(left, recording("P{who}_{take}.csv", "rig", "left"));
  ASSERT_EQ(done.status, 0) << done.err;
  const auto of_right = measures_of(right, "ARM-01");
  const auto of_left = measures_of(left, "ARM-01");
  for (const char* name : {"least_angle", "largest_angle", "active_range"})
    EXPECT_EQ(value_of(of_left, name), value_of(of_right, name)) << name;
}

TEST(ImportMarkers, WhatDoesNotFitIsNamedAndNothingIsWritten) {
  const auto changed = [](const std::string& from, const std::string& to) {
    std::string text = recording("P{who}_{take}.csv", "rig");
    text.replace(text.find(from), from.size(), to);
    return text;
  };
  for (const auto& [text, message] :
       {std::pair<std::string, std::string>{recording("P{who}_{take}.csv", "rig", ""),
                                            "hand: is missing"},
        {changed("\"take\"", "\"time\""), "trial: 'time' is no key of `file`"},
        {changed("rig = \"rig\"", "rig = \"nowhere\""), "nowhere"},
        {changed("rig = \"rig\"", "rig = \"rig\"\nseparator = \"comma\""), "separator"},
        {changed("kind = \"active_range\"\nlink = \"wrist\"\nangle = 1\n",
                 "kind = \"recorded\"\nmeasures = \"corridor\"\n"),
         "is not one of an arm"},
        {changed("P{who}_{take}.csv", "broken{who}_{take}.c3d"), "broken1_a.c3d"},
        {changed("P{who}_{take}.csv", "other{who}_{take}.csv"), "other1_a.csv"}}) {
    const TemporaryFolder folder;
    put_rig(folder);
    put_markers(folder, "P1_a.csv");
    put_markers(folder, "P1_b.csv");
    put_markers(folder, "broken1_a.c3d");
    const auto whole = fs::file_size(folder.path("broken1_a.c3d"));
    fs::resize_file(folder.path("broken1_a.c3d"), whole / 2);
    folder.write("other1_a.csv", "t_s,X_x_m,X_y_m,X_z_m\n0,1,2,3\n0.01,1,2,3\n");
    const auto done = import(folder, text);
    EXPECT_EQ(done.status, 2) << message;
    EXPECT_NE(done.err.find(message), std::string::npos) << done.err;
    EXPECT_FALSE(fs::exists(folder.path("c.db"))) << message;
  }
}

TEST(ImportMarkers, OfAPersonWhoLiftsABoxTheRangesAreThoseOfTheIndependentOracle) {
  const std::string data = test::recorded_data() + "/isotonic/";
  if (!fs::exists(data + "box_lift.csv")) GTEST_SKIP() << "the recordings are not there";
  const TemporaryFolder folder;
  fs::copy_file(data + "box_lift.csv", folder.path("P1_lift.csv"));
  folder.write("rig.toml", read_text(data + "box_lift_rig.toml").value() +
                               "\n[score]\nforearm = \"EF\"\nsync = \"DO\"\nobject = \"object\"\n");
  const auto done = import(folder, recording("P{who}_{take}.csv", "rig"));
  ASSERT_EQ(done.status, 0) << done.err;
  const auto measures = measures_of(folder, "ARM-01");
  constexpr double kOracle_rad = 1e-9;  // its numbers have 16 digits; it filters nothing
  test::AtLeast compared(1);
  const auto expected =
      nlohmann::json::parse(read_text(data + "box_lift_rom_expected.json").value());
  for (const auto& row : expected) {
    if (row.at("link") != "FD" || row.at("angle") != 1) continue;
    EXPECT_WITHIN(value_of(measures, "least_angle"), row.at("min_held").get<double>(), kOracle_rad);
    EXPECT_WITHIN(value_of(measures, "largest_angle"), row.at("max_held").get<double>(),
                  kOracle_rad);
    ++compared;
  }
}

}  // namespace
}  // namespace isograsp::app::import_markers_test
