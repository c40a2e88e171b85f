// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/resume.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "session/protocol/protocol_run.hpp"
#include "storage/access/open_store.hpp"
#include "tests/support/every.hpp"
#include "tests/support/temporary_folder.hpp"

namespace isograsp::session::resume_test {
namespace {

const std::string kLibrary = std::string(ISOGRASP_SOURCE_DIR) + "/library";

const std::string kMixed =
    "format = \"isograsp-protocol-1\"\nname = \"Mixed\"\n"
    "[[step]]\nkind = \"instrument_zero\"\n"
    "[[step]]\nkind = \"task\"\ntasks = [\"a\", \"b\", \"c\"]\norder = \"random\"\nrepetitions = "
    "2\n"
    "agree_measure = \"maximum_force\"\nmost_repetitions = 4\nrest_s = 5\n"
    "[[step]]\nkind = \"pause\"\nduration_s = 9\n"
    "[[step]]\nkind = \"task\"\ntask = \"d\"\nrepetitions = 2\nrecurrence_s = 60\n";

constexpr std::uint64_t kSeed = 11;
constexpr std::size_t kRefusedTask = 1;  // "b"

struct Act {
  tasks::Agenda::Item item;
  bool trial = false;
  double ended_s = 0.0;
  double value = 0.0;
};

/// The whole protocol: task "b" is refused, attempts at "a" never agree.
std::vector<Act> whole(const tasks::ProtocolSpec& protocol) {
  std::vector<Act> acts;
  tasks::Agenda agenda(protocol, kSeed);
  double now_s = 0.0;
  while (const auto item = agenda.next()) {
    const bool task = protocol.steps[item->step].kind == tasks::ProtocolStep::Kind::task;
    const bool refused = task && protocol.steps[item->step].tasks[item->task] == "b";
    now_s = std::max(now_s, item->not_before_s) + 10.0;
    const double value = item->task == 0 ? std::pow(2.0, item->attempt) : 30.0;
    acts.push_back({*item, task && !refused, now_s, value});
    agenda.record({!refused, task ? std::optional(value) : std::nullopt, now_s});
  }
  return acts;
}

/// What the first `trials` of them leave in a database.
EarlierWork left_by(const std::vector<Act>& acts, std::size_t trials) {
  EarlierWork work;
  for (const Act& act : acts) {
    if (work.trials.size() == trials) break;
    if (!act.trial) continue;
    EarlierTrial trial;
    trial.record.place = {static_cast<int>(act.item.step), static_cast<int>(act.item.task)};
    Measure measure;
    measure.name = "maximum_force";
    measure.value = act.value;
    trial.measures = {measure};
    trial.ended_s = act.ended_s;
    work.trials.push_back(trial);
  }
  return work;
}

TEST(Resume, WhereverAProtocolIsInterruptedTheRestIsTheSame) {
  const auto protocol = tasks::parse_protocol(kMixed, "mixed.toml").value();
  const auto acts = whole(protocol);
  const auto trials = static_cast<std::size_t>(
      std::count_if(acts.begin(), acts.end(), [](const Act& act) { return act.trial; }));
  ASSERT_GT(trials, 6u);
  for (std::size_t cut = 0; cut <= trials; ++cut) {
    tasks::Agenda agenda(protocol, kSeed);
    tell(agenda, protocol, left_by(acts, cut));
    for (auto act = static_cast<std::size_t>(agenda.done()); act < acts.size(); ++act) {
      const auto item = agenda.next();
      ASSERT_TRUE(item.has_value()) << cut;
      EXPECT_EQ(item->step, acts[act].item.step) << cut << " " << act;
      EXPECT_EQ(item->task, acts[act].item.task) << cut << " " << act;
      EXPECT_EQ(item->attempt, acts[act].item.attempt) << cut << " " << act;
      EXPECT_EQ(item->not_before_s, acts[act].item.not_before_s) << cut << " " << act;
      const bool task = protocol.steps[item->step].kind == tasks::ProtocolStep::Kind::task;
      agenda.record({acts[act].trial || !task, task ? std::optional(acts[act].value) : std::nullopt,
                     acts[act].ended_s});
    }
    EXPECT_FALSE(agenda.next().has_value());
  }
}

TEST(Resume, AHelpedAttemptCountsButItsValueDoesNot) {
  const auto protocol = tasks::parse_protocol(
      "format = \"isograsp-protocol-1\"\nname = \"Two\"\n[[step]]\nkind = \"task\"\ntask = \"a\"\n"
      "repetitions = 2\nagree_measure = \"maximum_force\"\nmost_repetitions = 3\n",
      "two.toml");
  EarlierWork work;
  for (int attempt = 0; attempt < 2; ++attempt) {
    Measure measure;
    measure.name = "maximum_force";
    measure.value = 30.0;
    work.trials.push_back({});
    work.trials.back().record.place = storage::TrialPlace{};
    work.trials.back().measures = {measure};
  }
  for (const bool helped : {false, true}) {
    work.trials.back().record.helped = helped;
    tasks::Agenda agenda(*protocol, 1);
    tell(agenda, *protocol, work);
    EXPECT_EQ(agenda.next().has_value(), helped);
  }
}

TEST(Ratings, WorkStopsAtPainFourOrTwoMoreThanAtFirst) {
  const auto stops = [](std::vector<int> pains) {
    std::vector<storage::RatingRecord> ratings;
    for (const int pain : pains) ratings.emplace_back().pain = pain;
    return reason_to_stop(ratings).has_value();
  };
  EXPECT_FALSE(stops({}));
  EXPECT_FALSE(stops({3}));
  EXPECT_TRUE(stops({4}));
  EXPECT_FALSE(stops({0, 1}));
  EXPECT_TRUE(stops({0, 1, 2}));
  EXPECT_FALSE(stops({2, 3, 1}));
}

TEST(Ratings, WorkStopsAtAPainfulShoulderAsAtAPainfulHand) {
  const auto stops = [](std::vector<std::optional<int>> pains) {
    std::vector<storage::RatingRecord> ratings;
    for (const auto& pain : pains) ratings.emplace_back().shoulder_pain = pain;
    return reason_to_stop(ratings).has_value();
  };
  EXPECT_FALSE(stops({std::nullopt}));
  EXPECT_FALSE(stops({3}));
  EXPECT_TRUE(stops({4}));
  EXPECT_FALSE(stops({0, 1}));
  EXPECT_TRUE(stops({0, 1, 2}));
  EXPECT_FALSE(stops({std::nullopt, 3})) << "nothing is known of how it was at first";
}

/// A session that breaks off before the act with this number.
struct BreakOff {};

struct Clinic {
  test::TemporaryFolder folder;
  std::string database = folder.path("clinic.db");
  ReadyProtocol protocol =
      read_protocol(find_in_library(kLibrary, "protocols", "short").value(), kLibrary).value();

  SessionConfig config(bool resume) const {
    SessionConfig c;
    c.database = database;
    c.create_database = true;
    c.patient_code = "TEST-01";
    c.device_uri = "sim://mild?seed=7";
    c.library = kLibrary;
    c.protocol_name = protocol.spec.name;
    c.protocol_text = protocol.spec.text;
    c.virtual_time = true;
    c.resume = resume;
    return c;
  }
  void run_until(int act) const {
    auto session = Session::open(config(false)).value();
    try {
      (void)run_protocol(*session, protocol, [&](const ProtocolProgress& at) {
        if (at.step == act) throw BreakOff{};
      });
    } catch (const BreakOff&) {
    }
  }
  std::vector<storage::SessionRecord> sessions() const {
    auto store = storage::open_store_to_read(database).value();
    return store->sessions(store->find_patient("TEST-01").value()->id).value();
  }
  std::vector<storage::TrialRecord> trials(storage::RowId session) const {
    return storage::open_store_to_read(database).value()->trials(session).value();
  }
};

TEST(Resume, ASessionGoesOnWithNewZeroAndRestAndTheMaximumThatWasMeasured) {
  const Clinic clinic;
  clinic.run_until(3);  // zero, rest and maximum are done
  auto session = Session::open(clinic.config(true)).value();
  EXPECT_GT(session->known().references.maximum({}), 5.0) << "measured before the break";
  const auto result = run_protocol(*session, clinic.protocol, {});
  ASSERT_TRUE(result.ok()) << result.error().message();
  session->close();

  const auto sessions = clinic.sessions();
  ASSERT_EQ(sessions.size(), 2u);
  EXPECT_EQ(sessions[1].resumes_id, sessions[0].id);
  const auto before = clinic.trials(sessions[0].id);
  const auto after = clinic.trials(sessions[1].id);
  ASSERT_EQ(before.size(), 2u);
  ASSERT_EQ(after.size(), 3u);
  EXPECT_EQ(after[0].task_name, before[0].task_name) << "the resting force, once more";
  EXPECT_FALSE(after[0].place.has_value());
  EXPECT_EQ(after[1].place, (storage::TrialPlace{3, 0}));
  EXPECT_EQ(after[2].place, (storage::TrialPlace{4, 0}));
  EXPECT_EQ(storage::value_of(after[1].references, "maximum_force_N"),
            session->known().maximum_force_N());
  EXPECT_NE(after[0].preparations, before[0].preparations);
  for (const auto& a : test::every(after))
    for (const auto& b : test::every(before)) EXPECT_NE(a.seed, b.seed);

  const auto over = Session::open(clinic.config(true));
  ASSERT_FALSE(over.ok());
  EXPECT_NE(english(over.error().what).find("finished its protocol"), std::string::npos);
  EXPECT_EQ(clinic.sessions().size(), 2u) << "a refusal leaves no trace";
}

TEST(Resume, AResumedSessionThatBreaksOffIsResumedToo) {
  const Clinic clinic;
  clinic.run_until(2);
  {
    auto session = Session::open(clinic.config(true)).value();
    try {
      (void)run_protocol(*session, clinic.protocol, [](const ProtocolProgress& at) {
        if (at.step == 4) throw BreakOff{};
      });
    } catch (const BreakOff&) {
    }
  }
  auto session = Session::open(clinic.config(true)).value();
  EXPECT_EQ(session->known().earlier.trials.size(), 3u);
  const auto result = run_protocol(*session, clinic.protocol, {});
  ASSERT_TRUE(result.ok()) << result.error().message();
  EXPECT_EQ(result->trials.size(), 2u) << "rest and the last task";
}

TEST(Resume, WhatTheScreeningForbadeStaysForbiddenUnlessItIsAskedAgain) {
  const Clinic clinic;
  auto first = clinic.config(false);
  first.allowed = tasks::Effort::comfortable;
  first.ceiling_N = 7.5;
  Session::open(first).value()->close();
  const auto held = Session::open(clinic.config(true)).value();
  EXPECT_EQ(held->known().references.allowed, tasks::Effort::comfortable);
  EXPECT_EQ(held->known().references.ceiling_N, 7.5);
  EXPECT_EQ(held->known().record.allowed, "comfortable");
  held->close();
  auto asked = clinic.config(true);
  asked.allowed = tasks::Effort::none;
  const auto again = Session::open(asked).value();
  EXPECT_EQ(again->known().references.allowed, tasks::Effort::none);
  EXPECT_EQ(again->known().references.ceiling_N, 7.5);
}

TEST(Resume, IsRefusedForAnotherProtocolHandOrDay) {
  Clinic clinic;
  EXPECT_FALSE(Session::open(clinic.config(true)).ok()) << "there is no session yet";
  clinic.run_until(3);
  const auto refused = [&](const SessionConfig& config, const char* why) {
    const auto session = Session::open(config);
    ASSERT_FALSE(session.ok()) << why;
    EXPECT_NE(english(session.error().what).find(why), std::string::npos)
        << session.error().message();
  };
  auto config = clinic.config(true);
  config.hand = Hand::left;
  refused(config, "this hand has had no session yet");
  config = clinic.config(true);
  config.protocol_text += "# changed\n";
  refused(config, "another version of this one");
  config = clinic.config(true);
  config.started_utc = "2199-01-01T00:00:00Z";
  refused(config, "more than four hours ago");
}

TrialOutcome wait_for_trial(Session& session) {
  for (;;)
    for (const auto& news : session.wait_for_news())
      if (news.trial) return *news.trial;
}

/// Zero, rest and one maximum, by hand.
TrialOutcome maximum_in(Session& session, bool helped_while_it_runs) {
  const auto task = [](const char* name) {
    return load_task(find_in_library(kLibrary, "tasks", name).value()).value();
  };
  EXPECT_TRUE(session.start_zero({true, false, 1.0}).ok());
  (void)session.wait_for_news();
  EXPECT_TRUE(session.start_trial(task("resting_force"), false).ok());
  (void)wait_for_trial(session);
  EXPECT_TRUE(session.start_trial(task("maximum_grip"), false).ok());
  if (helped_while_it_runs) session.mark_helped();
  return wait_for_trial(session);
}

TEST(Helped, NothingFollowsFromAHelpedTrialAndTheMarkIsStored) {
  for (const bool while_it_runs : {true, false}) {
    const Clinic clinic;
    auto session = Session::open(clinic.config(false)).value();
    const auto outcome = maximum_in(*session, while_it_runs);
    EXPECT_EQ(outcome.trial.helped, while_it_runs);
    if (!while_it_runs) {
      EXPECT_GT(session->known().maximum_force_N(), 5.0);
      session->mark_helped();
    }
    EXPECT_FALSE(session->known().maximum_force_N().has_value());
    session->mark_helped(false);
    EXPECT_GT(session->known().maximum_force_N(), 5.0) << "the mark was taken away";
    session->mark_helped();
    EXPECT_FALSE(session->rate(3, 1).has_value());
    EXPECT_TRUE(session->rate(6, 7).has_value());
    EXPECT_FALSE(session->rate(6, 2, std::nullopt, Session::Said::corrected).has_value())
        << "as if it had been said at once";
    EXPECT_TRUE(session->rate(6, 4, std::nullopt, Session::Said::corrected).has_value());
    session->close();
    const storage::RowId id = clinic.sessions().at(0).id;
    EXPECT_FALSE(clinic.trials(id).at(0).helped);
    EXPECT_TRUE(clinic.trials(id).at(1).helped);
    const auto ratings = storage::open_store_to_read(clinic.database).value()->ratings(id).value();
    ASSERT_EQ(ratings.size(), 2u);
    EXPECT_EQ(ratings[1].effort, 6);
    EXPECT_EQ(ratings[1].pain, 4);
    EXPECT_EQ(ratings[1].trial_id, outcome.trial.id);
  }
}

}  // namespace
}  // namespace isograsp::session::resume_test
