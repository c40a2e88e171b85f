// SPDX-License-Identifier: GPL-3.0-or-later
// The whole way of a tracked hand as a user goes it: tracker (in software, on a real port), lawful
// basis, session, database, scores, report, exports.
#include <filesystem>

#include <gtest/gtest.h>

#include "core/files.hpp"
#include "tests/support/background_command.hpp"
#include "tests/support/command.hpp"
#include "tests/support/every.hpp"
#include "tests/support/files_below.hpp"
#include "tests/support/free_port.hpp"
#include "tests/support/hand_recording.hpp"
#include "tests/support/must.hpp"
#include "tests/support/temporary_folder.hpp"

namespace isograsp::app::tracked_hand_test {
namespace {

using test::isograsp;
using test::TemporaryFolder;

/// One opening and one closing, of two seconds each.
std::string short_opening(const TemporaryFolder& folder) {
  static_cast<void>(folder.write(
      "opening.toml",
      "format = \"isograsp-task-1\"\nname = \"Short opening\"\ninstruction = \"Open.\"\nkind = "
      "\"hand_opening\"\nlead_in_s = 0.2\nrepetitions = 1\nopen_s = 2.5\nclose_s = 2.5\n"));
  return folder.write("opening_protocol.toml",
                      "format = \"isograsp-protocol-1\"\nname = \"Short\"\n[[step]]\nkind = "
                      "\"task\"\ntask = \"opening.toml\"\n");
}

void expect_verified(const std::string& database) {
  const auto verified = isograsp("db verify " + database);
  EXPECT_EQ(verified.status, 0) << verified.out << verified.err;
  EXPECT_NE(verified.out.find("largest relative difference 0"), std::string::npos) << verified.out;
}

TEST(TrackedHandApp, ALeapTrackerGoesFromLawfulBasisToReportAndExports) {
  const TemporaryFolder folder;
  const std::string recording = test::write_hand_recording(folder.path("hand.csv"), 12.0, 0.0);
  const std::string at = "127.0.0.1:" + std::to_string(test::free_port());
  const std::string database = folder.path("clinic.db");
  const std::string run = "run --device 'leap://" + at + "?delay_ms=12' --protocol-file " +
                          short_opening(folder) + " --db " + database + " --patient H-1";
  const test::BackgroundCommand tracker("\"" ISOGRASP_EXECUTABLE "\" hand emulate --stream " +
                                        recording + " --listen " + at);
  // Without a lawful basis the camera is not opened and nothing is written.
  const auto refused = isograsp(run);
  EXPECT_EQ(refused.status, 2) << refused.err;
  EXPECT_NE(refused.err.find("consent"), std::string::npos) << refused.err;
  EXPECT_FALSE(std::filesystem::exists(database));

  ASSERT_EQ(isograsp("db init " + database).status, 0);
  const auto basis = isograsp("db consent add " + database +
                              " --patient H-1 --new --purpose treatment --basis care --state "
                              "given --date 2026-03-05");
  ASSERT_EQ(basis.status, 0) << basis.err;
  test::CommandResult done;
  ASSERT_TRUE(tracker.wait_until([&] {
    done = isograsp(run);
    return done.status == 0;
  })) << done.err
      << tracker.err();
  tracker.wait_for_end();
  EXPECT_NE(done.out.find("largest_gap"), std::string::npos) << done.out;
  expect_verified(database);

  const auto report =
      isograsp("report --patient H-1 --db " + database + " --out " + folder.path("r.html"));
  ASSERT_EQ(report.status, 0) << report.err;
  const std::string page = test::must(read_text(folder.path("r.html")));
  for (const char* not_said : {"grip force", "Instrument zero", "What limits this hand", "improved",
                               "Largest gap of thumb"})
    EXPECT_EQ(page.find(not_said), std::string::npos)
        << not_said << ": no measure of a tracked hand stands in a patient's report";
  for (const char* format : {"csv", "hdf5", "bids", "fhir"}) {
    const auto exported = isograsp("export --db " + database + " --format " + format + " --out " +
                                   folder.path(format));
    EXPECT_EQ(exported.status, 0) << format << exported.err;
  }
  // Nobody has agreed to research: angles leave, joints do not.
  const std::string table =
      test::must(read_text(folder.path("csv") + "/patient_1/session_1/trial_1_signals.csv"));
  const std::string header = table.substr(0, table.find('\n'));
  EXPECT_NE(header.find("index_flexion1_rad"), std::string::npos) << header;
  EXPECT_EQ(header.find("index_tip_x_m"), std::string::npos) << header;
}

TEST(TrackedHandApp, ARecordingIsPlayedAsItWas) {
  const TemporaryFolder folder;
  const std::string recording = test::write_hand_recording(folder.path("hand.csv"), 10.0, 0.0);
  const auto done = isograsp("run --device 'replay://" + recording + "?speed=0' --protocol-file " +
                             short_opening(folder) + " --db " + folder.path("clinic.db") +
                             " --patient H-1 --fast");
  ASSERT_EQ(done.status, 0) << done.err;
  EXPECT_NE(done.out.find("hand_openings"), std::string::npos) << done.out;
  expect_verified(folder.path("clinic.db"));
}

TEST(TrackedHandApp, ASimulatedUserPlacesObjectsInVirtualTime) {
  const TemporaryFolder folder;
  const std::string database = folder.path("clinic.db");
  const std::string protocol = folder.write(
      "first.toml",
      "format = \"isograsp-protocol-1\"\nname = \"First\"\n[[step]]\nkind = \"hand_entry\"\n"
      "[[step]]\nkind = \"task\"\ntask = \"virtual_place_first.toml\"\npractice = true\n");
  const auto done = isograsp("run --device 'sim://hand?user=healthy&seed=3' --protocol-file " +
                             protocol + " --db " + database + " --patient H-1 --fast");
  ASSERT_EQ(done.status, 0) << done.err;
  EXPECT_NE(done.out.find("placements_completed (full)"), std::string::npos) << done.out;
  expect_verified(database);
  // Nobody's joints are those of a person in software.
  const auto exported =
      isograsp("export --db " + database + " --format csv --out " + folder.path("csv"));
  ASSERT_EQ(exported.status, 0) << exported.err;
  const std::string table =
      test::must(read_text(folder.path("csv") + "/patient_1/session_1/trial_1_signals.csv"));
  EXPECT_NE(table.substr(0, table.find('\n')).find("index_tip_x_m"), std::string::npos);
  const auto other =
      isograsp("run --device sim://hand?user=nobody --protocol-file " ISOGRASP_SOURCE_DIR
               "/library/protocols/hand_opens.toml --db " +
               folder.path("other.db") + " --patient H-1 --fast");
  EXPECT_EQ(other.status, 2);
  EXPECT_NE(other.err.find("healthy"), std::string::npos) << other.err;
}

TEST(TrackedHandApp, ADeviceForOtherTasksIsRefusedBeforeAnythingIsWritten) {
  const TemporaryFolder folder;
  const auto done = isograsp("run --device sim://healthy --protocol-file " + short_opening(folder) +
                             " --db " + folder.path("clinic.db") + " --patient H-1 --fast");
  EXPECT_EQ(done.status, 2);
  EXPECT_FALSE(std::filesystem::exists(folder.path("clinic.db")));
}

}  // namespace
}  // namespace isograsp::app::tracked_hand_test
