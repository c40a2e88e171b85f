// SPDX-License-Identifier: GPL-3.0-or-later
// A look is drawn and nothing else: the same training in any look is stored in the same bytes.
#include <cstring>
#include <fstream>

#include <gtest/gtest.h>

#include "storage/access/open_store.hpp"
#include "tasks/looks/look.hpp"
#include "tests/session/whole_session.hpp"
#include "tests/support/every.hpp"
#include "tests/support/temporary_folder.hpp"

namespace isograsp::session::looks_test {
namespace {

struct Stored {
  std::vector<storage::TrialRecord> trials;
  std::vector<Signals> signals;
  std::vector<std::vector<Measure>> measures;
};

/// `training` names the task and its look.
Stored trained(const std::string& device, const std::string& training) {
  const test::TemporaryFolder folder;
  const std::string protocol = folder.path("training.toml");
  std::ofstream(protocol) << "format = \"isograsp-protocol-1\"\nname = \"Training\"\n"
                             "[[step]]\nkind = \"instrument_zero\"\n"
                             "[[step]]\nkind = \"task\"\ntask = \"resting_force.toml\"\n"
                             "[[step]]\nkind = \"task\"\ntask = \"maximum_grip.toml\"\n"
                             "[[step]]\nkind = \"task\"\nadaptive = true\n" +
                                 training;
  (void)test::run_whole({folder.path("clinic.db"), "TEST-01", device, protocol});
  const auto store =
      storage::open_store(folder.path("clinic.db"), storage::OpenMode::read_only).value();
  Stored stored;
  const auto patient = store->find_patient("TEST-01").value().value();
  stored.trials = store->trials(store->sessions(patient.id).value().at(0).id).value();
  for (const auto& trial : stored.trials) {
    stored.signals.push_back(store->signals(trial).value());
    stored.measures.push_back(store->measures(trial.id).value());
  }
  return stored;
}

void expect_same(const Stored& a, const Stored& b) {
  ASSERT_EQ(a.trials.size(), b.trials.size());
  for (std::size_t i = 0; i < a.trials.size(); ++i) {
    EXPECT_EQ(a.trials[i].signals_hash, b.trials[i].signals_hash);
    ASSERT_EQ(a.signals[i].names(), b.signals[i].names());
    for (const auto& name : test::every(a.signals[i].names())) {
      const auto one = a.signals[i].column(name);
      const auto other = b.signals[i].column(name);
      ASSERT_EQ(one.size(), other.size());
      EXPECT_EQ(std::memcmp(one.data(), other.data(), one.size_bytes()), 0) << name;
    }
    ASSERT_EQ(a.measures[i].size(), b.measures[i].size());
    for (std::size_t m = 0; m < a.measures[i].size(); ++m) {
      EXPECT_EQ(a.measures[i][m].name, b.measures[i][m].name);
      EXPECT_EQ(a.measures[i][m].value, b.measures[i][m].value) << a.measures[i][m].name;
    }
  }
}

TEST(Looks, TheSameTrainingInAnyLookIsStoredInTheSameBytes) {
  for (const auto& [task, of] : {std::pair{"grip_sine_training", tasks::Wardrobe::curve},
                                 std::pair{"two_target_training", tasks::Wardrobe::object}}) {
    const std::string step = std::string("task = \"") + task + ".toml\"\n";
    const Stored plain = trained("sim://mild?seed=7", step + "look = \"plain\"\n");
    EXPECT_EQ(plain.trials.back().task_text.find("look ="), std::string::npos);
    int looks = 0;
    for (const tasks::LookFacts& look : test::every(tasks::all_looks())) {
      if (look.look == tasks::Look::plain || !tasks::fits(look.look, of)) continue;
      ++looks;
      const std::string line = "look = \"" + std::string(look.name) + "\"\n";
      const Stored dressed = trained("sim://mild?seed=7", step + line);
      EXPECT_NE(dressed.trials.back().task_text.find(line), std::string::npos)
          << "the look is stored with the trial";
      expect_same(plain, dressed);
    }
    EXPECT_GE(looks, 2);
  }
}

TEST(Looks, OfAnotherKindAreRefusedBeforeASessionBegins) {
  const test::TemporaryFolder folder;
  const std::string protocol = folder.path("training.toml");
  std::ofstream(protocol) << "format = \"isograsp-protocol-1\"\nname = \"Training\"\n"
                             "[[step]]\nkind = \"task\"\ntask = \"two_target_training.toml\"\n"
                             "adaptive = true\nlook = \"river\"\n";
  const auto read = read_protocol(protocol, std::string(ISOGRASP_SOURCE_DIR) + "/library");
  ASSERT_FALSE(read);
  EXPECT_NE(read.error().message().find("step[1].look: the look 'river' does not fit"),
            std::string::npos)
      << read.error().message();
}

}  // namespace
}  // namespace isograsp::session::looks_test
