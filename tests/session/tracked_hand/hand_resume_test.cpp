// SPDX-License-Identifier: GPL-3.0-or-later
// A tracked hand places at most so many objects in a session, however often that is broken off.
#include <gtest/gtest.h>

#include "hand/hand_columns.hpp"
#include "session/library/library.hpp"
#include "session/protocol/protocol_run.hpp"
#include "session/session.hpp"
#include "storage/access/open_store.hpp"
#include "tasks/task.hpp"
#include "tests/support/must.hpp"
#include "tests/support/temporary_folder.hpp"

namespace isograsp::session::hand_resume_test {
namespace {

using test::must;

const std::string kLibrary = std::string(ISOGRASP_SOURCE_DIR) + "/library";

/// Four trials of six placements: all that a hand may do.
constexpr const char* kAll = R"(format = "isograsp-protocol-1"
name = "All placements"
[[step]]
kind = "hand_entry"
[[step]]
kind = "task"
task = "virtual_place.toml"
repetitions = 4
rest_s = 60
)";

struct BrokenOff {};

/// Placements that each stored trial of each session begins, oldest first.
std::vector<int> placements_in(const std::string& database) {
  const auto store = must(storage::open_store(database, storage::OpenMode::read_only));
  std::vector<int> all;
  for (const auto& one : must(store->sessions(must(store->find_patient("P-1"))->id)))
    for (const auto& trial : must(store->trials(one.id))) {
      const auto signals = must(store->signals(trial));
      double last = -1.0;
      for (const double number : signals.column(columns::placement)) last = std::max(last, number);
      all.push_back(1 + static_cast<int>(last));
    }
  return all;
}

TEST(HandResume, PlacementsOfTheSessionThatBrokeOffCountTowardsTheMost) {
  const test::TemporaryFolder folder;
  SessionConfig config;
  config.database = folder.path("clinic.db");
  config.create_database = true;
  config.patient_code = "P-1";
  config.device_uri = "sim://hand?user=healthy&seed=3";
  config.library = kLibrary;
  const auto protocol = must(read_protocol(kAll, kLibrary + "/protocols/all.toml", kLibrary));
  config.protocol_name = protocol.spec.name;
  config.protocol_text = protocol.spec.text;
  config.virtual_time = true;
  config.clock_is_right = true;  // sessions in virtual time end ahead of every clock
  constexpr int kBreak = 3;      // behind the entry and two trials
  {
    const auto session = must(Session::open(config));
    try {
      static_cast<void>(run_protocol(*session, protocol, [](const ProtocolProgress& at) {
        if (at.step == kBreak) throw BrokenOff{};
      }));
    } catch (const BrokenOff&) {
    }
    session->close();
  }
  const auto before = placements_in(config.database);
  int begun = 0;
  for (const int placements : before) begun += placements;
  ASSERT_GT(begun, 6);
  ASSERT_LT(begun, tasks::kMostPlacements);

  config.resume = true;
  const auto session = must(Session::open(config));
  must(run_protocol(*session, protocol, {}));
  const auto task = must(load_task(must(find_in_library(kLibrary, "tasks", "virtual_place"))));
  for (;;) {  // until nothing is left
    const auto more = session->start_trial(task, false);
    if (!more) {
      EXPECT_NE(more.error().message().find("has placed 24 objects"), std::string::npos)
          << more.error().message();
      break;
    }
    for (bool ended = false; !ended;)
      for (const auto& news : session->wait_for_news()) ended = ended || news.trial.has_value();
  }
  session->close();
  int all = 0;
  for (const int placements : placements_in(config.database)) all += placements;
  EXPECT_EQ(all, tasks::kMostPlacements);
}

}  // namespace
}  // namespace isograsp::session::hand_resume_test
