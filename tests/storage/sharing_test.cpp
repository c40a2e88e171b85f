// SPDX-License-Identifier: GPL-3.0-or-later
// Several programs on one file.
#include "storage/access/open_store.hpp"
#include "tests/storage/examples.hpp"
#include "tests/storage/writer_process.hpp"

namespace isograsp::storage::sharing_test {
namespace {

TEST(Sharing, ARecordingProgramIsNotInterruptedByAnotherThatOpensTheFile) {
  TemporaryFolder folder;
  const std::string path = folder.file("clinic.db");
  // Ten times as fast as a session, which stores once a second. Without any pause it is luck
  // whether another program ever finds the file unlocked.
  WriterProcess writer(path, "1000000", 0, "1", "100");
  ASSERT_TRUE(writer.wait_for("second 3"));
  const auto store = opened(path, OpenMode::existing);
  const auto patient = must(store->find_patient("P-1"));
  const auto session = must(store->sessions(patient->id)).back();
  EXPECT_EQ(must(store->trials(session.id))[0].status, TrialStatus::running);
  // Both write; neither loses anything.
  for (int i = 0; i < 20; ++i) must(store->add_patient("Q-" + std::to_string(i)));
  const std::string said = writer.kill_and_read();
  EXPECT_EQ(said.find("error"), std::string::npos) << said;
  EXPECT_EQ(must(store->trials(session.id))[0].status, TrialStatus::running)
      << "only opening the file repairs it";
  const auto next = opened(path, OpenMode::existing);
  EXPECT_EQ(must(next->trials(session.id))[0].status, TrialStatus::interrupted);
}

TEST(Sharing, AnOpenStoreThatDoesNotRecordDoesNotPreventTheRepair) {
  TemporaryFolder folder;
  const std::string path = folder.file("clinic.db");
  const auto idle = opened(path);
  {
    WriterProcess writer(path);
    ASSERT_TRUE(writer.wait_for("second 0"));
    writer.kill_and_read();
  }
  const auto store = opened(path, OpenMode::existing);
  const auto patient = must(store->find_patient("P-1"));
  const auto session = must(store->sessions(patient->id)).back();
  EXPECT_EQ(must(store->trials(session.id))[0].status, TrialStatus::interrupted);
}

TEST(Sharing, AStoreClosedWhileRecordingLeavesAnInterruptedTrial) {
  TemporaryFolder folder;
  const std::string path = folder.file("clinic.db");
  TrialRecord trial;
  {
    const auto store = opened(path);
    const auto patient = must(store->add_patient("P-1"));
    trial = example_trial(must(store->begin_session(example_session(patient.id))));
    trial.id = must(store->begin_trial(trial));
    must(store->append_blocks(trial.id, 0, example_rows(trial, 100, 1)));
  }
  const auto before = opened(path, OpenMode::read_only);
  EXPECT_EQ(must(before->trials(trial.session_id))[0].status, TrialStatus::running);
  const auto store = opened(path, OpenMode::existing);
  const auto after = must(store->trials(trial.session_id))[0];
  EXPECT_EQ(after.status, TrialStatus::interrupted);
  EXPECT_EQ(after.samples, 100);
}

}  // namespace
}  // namespace isograsp::storage::sharing_test
