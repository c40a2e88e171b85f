// SPDX-License-Identifier: GPL-3.0-or-later
// storage_writer FILE [SECONDS [TRIALS [PAUSE_MS]]]: records one trial of so many seconds after the
// other, without pause or with one after each second, and says on standard output what the store
// has confirmed. The tests end it without warning. Exit status 3: the store refused, as said.
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <thread>

#include <unistd.h>

#include "storage/access/open_store.hpp"
#include "storage/records/session_store.hpp"

namespace {

/// One write, so that a line is there whole or not at all.
void say(const std::string& line) {
  const std::string text = line + "\n";
  if (write(STDOUT_FILENO, text.data(), text.size()) < 0) std::exit(4);
}

[[noreturn]] void give_up(const isograsp::Error& error) {
  say("error " + error.message());
  std::exit(3);
}

void record(isograsp::storage::SessionStore& store, isograsp::storage::RowId session_id, int number,
            int seconds, int pause_ms) {
  using namespace isograsp::storage;
  TrialRecord trial;
  trial.session_id = session_id;
  trial.number = number;
  trial.task_name = "kill test";
  trial.groups = {{"force", {}}, {"raw", {}}};
  constexpr std::size_t kColumns = 30;
  for (auto& group : trial.groups)
    for (std::size_t c = 0; c < kColumns; ++c)
      group.columns.push_back(group.name + std::to_string(c) + "_N");
  const auto trial_id = store.begin_trial(trial);
  if (!trial_id) give_up(trial_id.error());
  say("trial " + std::to_string(session_id));
  for (int second = 0; second < seconds; ++second) {
    // Value = place in the trial, so that the test can tell every sample.
    std::vector<std::vector<double>> rows(2);
    for (auto& block : rows)
      for (std::size_t i = 0; i < 100 * kColumns; ++i)
        block.push_back(static_cast<double>(second) * 100.0 * kColumns + static_cast<double>(i));
    if (const auto done = store.append_blocks(*trial_id, second, rows); !done)
      give_up(done.error());
    say("second " + std::to_string(second));
    if (const auto done = store.add_event(session_id, {*trial_id, 1.0 * second, "note", "x"});
        !done)
      give_up(done.error());
    say("event " + std::to_string(second));
    std::this_thread::sleep_for(std::chrono::milliseconds(pause_ms));
  }
  trial.id = *trial_id;
  trial.status = TrialStatus::completed;
  if (const auto done = store.end_trial(trial, {}); !done) give_up(done.error());
}

}  // namespace

int main(int argc, char** argv) {
  using namespace isograsp::storage;
  if (argc < 2) return 2;
  const int seconds = argc > 2 ? std::atoi(argv[2]) : 1 << 20;
  const int trials = argc > 3 ? std::atoi(argv[3]) : 1;
  const int pause_ms = argc > 4 ? std::atoi(argv[4]) : 0;
  auto opened = open_store(argv[1], OpenMode::create);
  if (!opened) give_up(opened.error());
  SessionStore& store = **opened;
  auto patient = store.find_patient("P-1");
  if (!patient) give_up(patient.error());
  RowId patient_id = 0;
  if (*patient) {
    patient_id = (*patient)->id;
  } else {
    const auto added = store.add_patient("P-1");
    if (!added) give_up(added.error());
    patient_id = added->id;
  }
  SessionRecord session;
  session.patient_id = patient_id;
  const auto session_id = store.begin_session(session);
  if (!session_id) give_up(session_id.error());
  for (int number = 1; number <= trials; ++number) {
    record(store, *session_id, number, seconds, pause_ms);
    say("closed " + std::to_string(number));
  }
  say("done");
  return 0;
}
