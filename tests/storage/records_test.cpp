// SPDX-License-Identifier: GPL-3.0-or-later
// What goes in comes out, to the bit.
#include <algorithm>

#include "storage/access/open_store.hpp"
#include "tests/storage/examples.hpp"
#include "tests/support/every.hpp"

namespace isograsp::storage::records_test {
namespace {

struct Records : testing::Test {
  TemporaryFolder folder;
  std::string path = folder.file("clinic.db");
  std::unique_ptr<SessionStore> store = opened(path);

  void reopen() {
    store.reset();
    store = opened(path, OpenMode::existing);
  }
  RowId session() { return must(store->begin_session(example_session(patient()))); }
  RowId patient() { return must(store->add_patient("P-0427")).id; }
};

TEST_F(Records, SessionKeepsEveryField) {
  const auto patient_id = patient();
  SessionRecord written = example_session(patient_id);
  written.id = must(store->begin_session(written));
  must(store->end_session(written.id, "2026-03-01T10:30:00Z"));
  written.ended_utc = "2026-03-01T10:30:00Z";
  reopen();
  const auto all = must(store->sessions(patient_id));
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].uuid.size(), 36u);
  written.uuid = all[0].uuid;
  EXPECT_EQ(all[0], written);
}

TEST_F(Records, ASessionAndAPrimaryMeasureMayBeOfBothHands) {
  const auto patient_id = patient();
  SessionRecord both = example_session(patient_id);
  both.hand = std::nullopt;
  both.id = must(store->begin_session(both));
  TrialRecord trial = example_trial(both.id);
  trial.status = TrialStatus::completed;
  trial.id = must(store->begin_trial(trial));
  Measure peak;
  peak.name = "peak_force";
  peak.channel = "grip";
  peak.unit = "N";
  peak.value = 12.0;
  must(store->end_trial(trial, std::vector{peak}));
  must(store->add_primary_measure(
      patient_id, {0, trial.task_name, std::nullopt, "peak_force", "grip", "", "Therapist 7"}));
  reopen();
  EXPECT_EQ(must(store->sessions(patient_id)).at(0).hand, std::nullopt);
  EXPECT_EQ(must(store->progress(patient_id)).at(0).hand, std::nullopt);
  EXPECT_EQ(must(store->primary_measures(patient_id)).at(0).hand, std::nullopt);
}

TEST_F(Records, PreparationsOfAnyKindKeepEveryField) {
  const RowId session_id = session();
  PreparationRecord zero = example_preparation(session_id);
  zero.references = {{"change_N", 2.5}, {"drift_N", 0.25}};
  zero.change_confirmed = zero.drifted = true;
  zero.id = must(store->add_preparation(zero));
  PreparationRecord rest = example_preparation(session_id);
  rest.kind = "resting_force";
  rest.trial_id = must(store->begin_trial(example_trial(session_id)));
  rest.references = {{"duration_s", 10.0}, {"since_strapping_s", 61.25}};
  rest.samples = 1000;
  rest.id = must(store->add_preparation(rest));
  EXPECT_FALSE(store->add_preparation(rest).ok()) << "one of a kind of each trial";
  PreparationRecord size = example_preparation(session_id);
  size.kind = "hand_size";
  size.columns = {"palm_width_m"};
  size.mean = {0.081};
  size.sd = {0.002};
  size.operator_name = "";
  size.id = must(store->add_preparation(size));
  reopen();
  EXPECT_EQ(must(store->preparations(session_id)), (std::vector{zero, rest, size}));
}

TEST_F(Records, PreparationsComeBackToTheBit) {
  PreparationRecord written = example_preparation(session());
  written.mean = awkward_doubles();
  written.sd = written.mean;
  written.columns.clear();
  for (std::size_t i = 0; i < written.mean.size(); ++i)
    written.columns.push_back("column_" + std::to_string(i));
  must(store->add_preparation(written));
  reopen();
  const auto read = must(store->preparations(written.session_id)).at(0);
  ASSERT_EQ(read.mean.size(), written.mean.size());
  ASSERT_EQ(read.sd.size(), written.sd.size());
  for (std::size_t i = 0; i < written.mean.size(); ++i) {
    EXPECT_TRUE(same_bits(read.mean[i], written.mean[i])) << i;
    EXPECT_TRUE(same_bits(read.sd[i], written.sd[i])) << i;
  }
}

TEST_F(Records, APreparationHasAMeanAndASpreadOfEachColumn) {
  using Spoil = void (*)(PreparationRecord&);
  const std::vector<Spoil> all{
      [](PreparationRecord& one) { one.mean.pop_back(); },
      [](PreparationRecord& one) { one.sd.pop_back(); },
      [](PreparationRecord& one) { one.columns.pop_back(); },
      [](PreparationRecord& one) { one.kind = ""; },
      [](PreparationRecord& one) { one.references["drift_N"] = std::nan(""); },
      [](PreparationRecord& one) { one.trial_id = 7; }};
  const RowId session_id = session();
  for (const Spoil spoil : test::every(all)) {
    PreparationRecord one = example_preparation(session_id);
    spoil(one);
    EXPECT_FALSE(store->add_preparation(one).ok());
    EXPECT_TRUE(must(store->preparations(session_id)).empty()) << "all or nothing";
  }
}

TEST_F(Records, ATrialSaysHowWhatItRestsOnHasDriftedSince) {
  const RowId session_id = session();
  PreparationRecord zero = example_preparation(session_id);
  PreparationRecord size = example_preparation(session_id);
  size.kind = "hand_size";
  const RowId first = must(store->add_preparation(zero));
  const RowId of_hand = must(store->add_preparation(size));
  TrialRecord trial = example_trial(session_id, 1);
  trial.preparations = {first, of_hand};
  trial.status = TrialStatus::completed;
  trial.id = must(store->begin_trial(trial));
  must(store->end_trial(trial, {}));
  EXPECT_TRUE(must(store->trials(session_id))[0].drift.empty()) << "nothing followed";
  zero.references = {{"drift_N", 0.5}, {"change_N", 0.1}};
  zero.drifted = true;
  trial.preparations = {must(store->add_preparation(zero)), of_hand};
  trial.number = 2;
  trial.id = must(store->begin_trial(trial));
  must(store->end_trial(trial, {}));
  zero.references = {{"drift_N", 0.1}};
  zero.drifted = false;
  must(store->add_preparation(zero));
  const auto all = must(store->trials(session_id));
  EXPECT_EQ(all[0].drift, (References{{"drift_N", 0.5}})) << "of the zero that followed, no other";
  EXPECT_TRUE(all[0].drifted);
  EXPECT_EQ(all[1].drift, (References{{"drift_N", 0.1}}));
  EXPECT_FALSE(all[1].drifted);
}

TEST_F(Records, ACorrectedRatingIsOneRatingAndSaysWhatItWas) {
  const RowId session_id = session();
  const RowId id =
      must(store->add_rating({0, session_id, std::nullopt, 61.5, "2026-03-01T09:31:01Z", 8, 5}));
  must(store->correct_rating({id, session_id, std::nullopt, 64.0, "", 3, 5}));
  EXPECT_FALSE(store->correct_rating({id, session_id, std::nullopt, 65.0, "", 11, 5}).ok());
  EXPECT_FALSE(store->correct_rating({id + 1, session_id, 0, 65.0, "", 1, 1}).ok()) << "no such";
  reopen();
  const auto ratings = must(store->ratings(session_id));
  ASSERT_EQ(ratings.size(), 1u);
  EXPECT_EQ(ratings[0].effort, 3);
  EXPECT_EQ(ratings[0].pain, 5);
  EXPECT_EQ(ratings[0].session_time_s, 61.5) << "when it was asked";
  EXPECT_EQ(ratings[0].recorded_utc, "2026-03-01T09:31:01Z");
  const auto events = must(store->events(session_id));
  ASSERT_EQ(events.size(), 1u) << "a correction that was refused leaves none";
  EXPECT_EQ(events[0].kind, kCorrectionEvent);
  EXPECT_EQ(events[0].session_time_s, 64.0);
  EXPECT_EQ(events[0].text, "Rating corrected: effort 3, pain 5; before: effort 8, pain 5");
}

TEST_F(Records, ShoulderPainIsKeptBesideItsRatingAndCorrectedWithIt) {
  const RowId session_id = session();
  RatingRecord rating{0, session_id, std::nullopt, 61.5, "2026-03-01T09:31:01Z", 8, 1, 3};
  rating.id = must(store->add_rating(rating));
  must(store->add_rating({0, session_id, std::nullopt, 90.0, "2026-03-01T09:31:30Z", 2, 0}));
  auto ratings = must(store->ratings(session_id));
  ASSERT_EQ(ratings.size(), 2u);
  EXPECT_EQ(ratings[0], rating);
  EXPECT_EQ(ratings[1].shoulder_pain, std::nullopt) << "it was not asked";

  RatingRecord meant = rating;
  meant.session_time_s = 64.0;
  meant.shoulder_pain = 5;
  must(store->correct_rating(meant));
  ratings = must(store->ratings(session_id));
  EXPECT_EQ(ratings[0].shoulder_pain, 5);
  EXPECT_EQ(ratings[0].session_time_s, 61.5) << "when it was asked";
  const auto events = must(store->events(session_id));
  ASSERT_EQ(events.size(), 2u) << "one number, and what it was";
  EXPECT_EQ(std::ranges::count(events, kShoulderPainEvent, &EventRecord::kind), 1);
  const auto note = std::ranges::find(events, kCorrectionEvent, &EventRecord::kind);
  ASSERT_NE(note, events.end());
  EXPECT_EQ(note->text,
            "Rating corrected: effort 8, pain 1, shoulder pain 5; before: effort 8, pain 1, "
            "shoulder pain 3");
  for (const int no_pain : {-1, 11}) {
    rating.session_time_s = 100.0;
    rating.shoulder_pain = no_pain;
    EXPECT_FALSE(store->add_rating(rating)) << no_pain;
  }
  EXPECT_EQ(must(store->ratings(session_id)).size(), 2u) << "both or neither";
}

TEST_F(Records, RatingsAndHelpComeBack) {
  const RowId session_id = session();
  TrialRecord trial = example_trial(session_id);
  trial.id = must(store->begin_trial(trial));
  EXPECT_FALSE(store->mark_helped(trial.id, true).ok()) << "it runs";
  trial.status = TrialStatus::completed;
  must(store->end_trial(trial, std::vector<Measure>{{"rmse", "force", 0.3, "N", 2, 1, 0, ""}}));
  must(store->mark_helped(trial.id, true));
  EXPECT_FALSE(store->mark_helped(trial.id + 1, true).ok()) << "there is none";
  must(store->add_rating({0, session_id, trial.id, 61.5, "2026-03-01T09:31:01Z", 10, 0}));
  must(store->add_rating({0, session_id, std::nullopt, 90.0, "2026-03-01T09:31:30Z", 0, 10}));
  EXPECT_FALSE(store->add_rating({0, session_id, std::nullopt, 91.0, "", 11, 0}).ok());
  EXPECT_FALSE(store->add_rating({0, session_id, std::nullopt, 91.0, "", 0, -1}).ok());
  reopen();
  EXPECT_TRUE(must(store->trials(session_id)).at(0).helped);
  EXPECT_TRUE(must(store->progress(must(store->patients()).at(0).id)).at(0).helped);
  const auto ratings = must(store->ratings(session_id));
  ASSERT_EQ(ratings.size(), 2u);
  EXPECT_EQ(ratings[0].trial_id, trial.id);
  EXPECT_EQ(ratings[0].session_time_s, 61.5);
  EXPECT_EQ(ratings[0].recorded_utc, "2026-03-01T09:31:01Z");
  EXPECT_EQ(ratings[0].effort, 10);
  EXPECT_FALSE(ratings[1].trial_id);
  EXPECT_EQ(ratings[1].pain, 10);
}

TEST_F(Records, TheLastZeroIsThatOfTheSameSensorsWhicheverSessionItWasIn) {
  const RowId patient = must(store->add_patient("P-9")).id;
  const auto sensors = [](const std::vector<std::string>& serials) {
    std::vector<SensorRecord> all;
    for (const std::string& serial : serials) all.push_back({"one", serial});
    return all;
  };
  const auto add = [&](const std::vector<std::string>& serials, const std::string& uri,
                       bool simulated, double value) {
    SessionRecord s = example_session(patient);
    s.recorded = false;
    s.simulated = simulated;
    s.sensors = sensors(serials);
    s.device_uri = uri;
    const RowId session_id = must(store->begin_session(s));
    must(store->add_preparation(example_preparation(session_id, value)));
    PreparationRecord other = example_preparation(session_id, -value);
    other.kind = "hand_size";
    must(store->add_preparation(other));
    return s;
  };
  const auto found = [&](const SessionRecord& s) {
    const auto zero = must(store->last_preparation(s, "instrument_zero"));
    return zero ? std::optional(zero->mean[0]) : std::nullopt;
  };
  const auto a = add({"1", "2", "3"}, "can://can0", false, 1.0);
  const auto a_elsewhere = add({"1", "2", "3"}, "can://can1", false, 2.0);
  const auto b = add({"1", "2", "4"}, "can://can0", false, 3.0);
  const auto simulated = add({"1", "2", "3"}, "can://can0", true, 4.0);
  const auto silent = add({"", "", ""}, "can://can0", false, 5.0);
  const auto silent_elsewhere = add({"", "", ""}, "can://can1", false, 6.0);
  EXPECT_EQ(found(a), 2.0) << "the newest of these sensors, on whichever bus";
  EXPECT_EQ(found(a_elsewhere), 2.0);
  EXPECT_EQ(found(b), 3.0);
  EXPECT_EQ(found(simulated), 4.0);
  EXPECT_EQ(found(silent), 5.0) << "sensors that do not tell: the same address";
  EXPECT_EQ(found(silent_elsewhere), 6.0);
  SessionRecord other = b;
  other.sensors = sensors({"7", "8", "9"});
  EXPECT_FALSE(found(other).has_value());
}

TEST_F(Records, TrialAndItsMeasuresKeepEveryField) {
  const RowId session_id = session();
  TrialRecord written = example_trial(session_id, 4);
  written.preparations = {must(store->add_preparation(example_preparation(session_id))),
                          must(store->add_preparation(example_preparation(session_id)))};
  written.id = must(store->begin_trial(written));
  must(store->append_blocks(written.id, 0, example_rows(written, 100, 1)));
  must(store->append_blocks(written.id, 1, example_rows(written, 37, 2)));
  TrialRecord end = written;
  end.status = TrialStatus::completed;
  end.dropped = 5;
  end.worst_lateness_s = 1.25e-3;
  end.worst_compute_s = 4e-5;
  end.health_json = R"({"frames": 137})";
  end.timing_json = R"({"period": {}})";
  end.display_age_s = 0.0417;
  end.references["visual_gain_deg_per_N"] = 0.25;
  end.viewing_distance_m = 0.65;
  const std::vector<Measure> measures{{"rmse", "force", 0.1 + 0.2, "N", 2, 100, 37, ""},
                                      {"lag", "force", -0.0, "s", 1, 137, 0, ""},
                                      {"least", "force", 5e-324, "", 1, 1, 0, ""},
                                      {"cv", "force", {}, "%", 1, 0, 137, "all samples missing"}};
  must(store->end_trial(end, measures));
  reopen();

  const auto all = must(store->trials(session_id));
  ASSERT_EQ(all.size(), 1u);
  const auto& read = all[0];
  EXPECT_EQ(read.uuid.size(), 36u);
  EXPECT_EQ(read.signals_hash.size(), 64u);
  end.uuid = read.uuid;
  end.signals_hash = read.signals_hash;
  end.samples = 137;
  EXPECT_EQ(read, end);
  EXPECT_TRUE(same_bits(read.references.at("resting_force_N"), -0.0));

  const auto stored = must(store->measures(written.id));
  ASSERT_EQ(stored.size(), measures.size());
  ASSERT_FALSE(stored.empty());
  for (std::size_t i = 0; i < stored.size(); ++i) {
    EXPECT_EQ(stored[i].name, measures[i].name);
    EXPECT_EQ(stored[i].channel, measures[i].channel);
    ASSERT_EQ(stored[i].value.has_value(), measures[i].value.has_value());
    if (stored[i].value) {
      EXPECT_TRUE(same_bits(*stored[i].value, *measures[i].value));
    }
    EXPECT_EQ(stored[i].unit, measures[i].unit);
    EXPECT_EQ(stored[i].version, measures[i].version);
    EXPECT_EQ(stored[i].samples, measures[i].samples);
    EXPECT_EQ(stored[i].excluded, measures[i].excluded);
    EXPECT_EQ(stored[i].reason, measures[i].reason);
  }
}

TEST_F(Records, SignalsComeBackToTheBitInTheOrderOfTheGroups) {
  TrialRecord trial = example_trial(session());
  trial.id = must(store->begin_trial(trial));
  const auto awkward = awkward_doubles();
  std::vector<std::vector<std::vector<double>>> seconds;
  for (int second = 0; second < 3; ++second) {
    auto rows = example_rows(trial, second < 2 ? 100 : 42, static_cast<unsigned>(second));
    std::copy(awkward.begin(), awkward.end(), rows[0].begin() + 30);
    std::copy(awkward.begin(), awkward.end(), rows[1].begin() + 3);
    must(store->append_blocks(trial.id, second, rows));
    seconds.push_back(rows);
  }
  trial.status = TrialStatus::completed;
  must(store->end_trial(trial, {}));
  reopen();
  const auto record = must(store->trials(trial.session_id))[0];
  EXPECT_EQ(record.samples, 242);
  const Signals signals = must(store->signals(record));
  EXPECT_EQ(signals.names(),
            (std::vector<std::string>{"t_s", "thumb_fz_N", "index_fz_N", "thumb_fz_counts"}));
  std::size_t row = 0;
  for (const auto& rows : test::every(seconds))
    for (std::size_t r = 0; r < rows[1].size(); ++r, ++row) {
      for (std::size_t c = 0; c < 3; ++c)
        EXPECT_TRUE(same_bits(signals.column(c)[row], rows[0][3 * r + c])) << row << " " << c;
      EXPECT_TRUE(same_bits(signals.column(3)[row], rows[1][r])) << row;
    }
  EXPECT_EQ(signals.rows(), row);
}

TEST_F(Records, EventsBelongToASessionOrToOneOfItsTrials) {
  TrialRecord trial = example_trial(session());
  trial.id = must(store->begin_trial(trial));
  must(store->add_event(trial.session_id, {std::nullopt, 1.5, "note", "'; DROP TABLE events; --"}));
  must(store->add_event(trial.session_id, {trial.id, 2.5, "fault", "no sample for 60 ms"}));
  EXPECT_FALSE(store->add_event(trial.session_id, {trial.id + 1, 3.0, "fault", ""}).ok());
  EXPECT_FALSE(store->add_event(trial.session_id + 1, {0, 3.0, "note", ""}).ok());
  const auto events = must(store->events(trial.session_id));
  ASSERT_EQ(events.size(), 2u);
  EXPECT_FALSE(events[0].trial_id);
  EXPECT_EQ(events[0].session_time_s, 1.5);
  EXPECT_EQ(events[0].text, "'; DROP TABLE events; --");
  EXPECT_EQ(events[1].trial_id, trial.id);
  EXPECT_EQ(events[1].kind, "fault");
}

TEST_F(Records, ProgressGivesEveryMeasureOldestSessionFirst) {
  const RowId patient_id = patient();
  const RowId other = must(store->add_patient("P-0999")).id;
  for (const auto& [who, day, value] :
       {std::tuple{patient_id, "2026-03-02", 2.0}, std::tuple{patient_id, "2026-03-01", 1.0},
        std::tuple{other, "2026-03-01", 9.0}}) {
    SessionRecord session = example_session(who);
    session.started_utc = std::string(day) + "T09:00:00Z";
    TrialRecord trial = example_trial(must(store->begin_session(session)));
    trial.id = must(store->begin_trial(trial));
    trial.status = TrialStatus::completed;
    const std::vector<Measure> measures{{"rmse", "force", value, "N", 1, 10, 0, ""}};
    must(store->end_trial(trial, measures));
  }
  const auto points = must(store->progress(patient_id));
  ASSERT_EQ(points.size(), 2u);
  EXPECT_EQ(*points[0].measure.value, 1.0);
  EXPECT_EQ(*points[1].measure.value, 2.0);
  EXPECT_EQ(points[0].started_utc, "2026-03-01T09:00:00Z");
  EXPECT_EQ(points[0].hand, Hand::left);
  EXPECT_TRUE(points[0].practice);
  EXPECT_TRUE(points[0].simulated);
  EXPECT_EQ(points[0].task_name, "Grip force, sine");
  EXPECT_EQ(points[0].task_version, 3);
}

TEST_F(Records, RecentSessionsAreThoseOfAllPatientsNewestFirst) {
  const RowId one = patient();
  const RowId other = must(store->add_patient("P-0999")).id;
  std::vector<RowId> ids;
  for (const auto& [who, day] : {std::pair{one, "2026-03-02"}, std::pair{other, "2026-03-04"},
                                 std::pair{one, "2026-03-01"}, std::pair{one, "2026-03-04"}}) {
    SessionRecord session = example_session(who);
    session.started_utc = std::string(day) + "T09:00:00Z";
    ids.push_back(must(store->begin_session(session)));
  }
  const auto found = [&](int most) {
    std::vector<RowId> list;
    for (const auto& session : must(store->recent_sessions(most))) list.push_back(session.id);
    return list;
  };
  EXPECT_EQ(found(3), (std::vector<RowId>{ids[3], ids[1], ids[0]}));
  EXPECT_EQ(found(9), (std::vector<RowId>{ids[3], ids[1], ids[0], ids[2]}));
  EXPECT_TRUE(found(0).empty());
  EXPECT_TRUE(found(-1).empty()) << "not all of them";
  EXPECT_EQ(must(store->recent_sessions(1)).at(0).patient_id, one);
}

TEST_F(Records, AnswersComeBackInTheirOrder) {
  const std::vector<SessionAnswer> first{{"screening", "clearance", "yes"},
                                         {"screening", "pain", "2"}};
  const RowId id = must(store->begin_session(example_session(patient()), first));
  must(store->add_answers(
      id, std::vector<SessionAnswer>{{"posture", "elbow_deg", "90"}, {"screening", "pain", "3"}}));
  reopen();
  const auto all = must(store->answers(id));
  ASSERT_EQ(all.size(), 4u);
  EXPECT_EQ(all[0], first[0]);
  EXPECT_EQ(all[1], first[1]);
  EXPECT_EQ(all[2], (SessionAnswer{"posture", "elbow_deg", "90"}));
  EXPECT_EQ(all[3].value, "3") << "what was answered before is kept";
}

TEST_F(Records, ASessionWhoseAnswersAreRefusedIsNotBegun) {
  const RowId who = patient();
  const auto refused = store->begin_session(
      example_session(who), std::vector<SessionAnswer>{{"screening", "pain", "2"}, {"", "x", "1"}});
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().field, "topic");
  EXPECT_TRUE(must(store->sessions(who)).empty());
  const RowId id = must(store->begin_session(example_session(who)));
  EXPECT_FALSE(
      store->add_answers(id, std::vector<SessionAnswer>{{"posture", "seat", ""}, {"x", "", ""}})
          .ok());
  EXPECT_TRUE(must(store->answers(id)).empty()) << "all or none";
  EXPECT_FALSE(store->add_answers(id + 1, std::vector<SessionAnswer>{{"x", "y", ""}}).ok());
}

TEST_F(Records, PatientsAreFoundByTheirCodeInAnyCapitalsAndNeverTwice) {
  must(store->add_patient("P-0427"));
  EXPECT_TRUE(must(store->find_patient("P-0427")).has_value());
  EXPECT_EQ(must(store->find_patient("p-0427")).value().code, "P-0427");
  EXPECT_FALSE(must(store->find_patient("' OR '1'='1")).has_value());
  const auto again = store->add_patient("p-0427");
  ASSERT_FALSE(again.ok());
  EXPECT_NE(again.error().message().find("P-0427 exists already"), std::string::npos);
  EXPECT_FALSE(store->add_patient("x'); DROP TABLE patients;--1").ok());
  EXPECT_EQ(must(store->patients()).size(), 1u);
}

TEST_F(Records, BlocksOutOfOrderOrUnevenAreRefusedAndNothingIsStored) {
  TrialRecord trial = example_trial(session());
  trial.id = must(store->begin_trial(trial));
  EXPECT_FALSE(store->append_blocks(trial.id, 1, example_rows(trial, 100, 1)).ok());
  EXPECT_FALSE(store->append_blocks(trial.id + 1, 0, example_rows(trial, 100, 1)).ok());
  auto uneven = example_rows(trial, 100, 1);
  uneven[1].pop_back();
  EXPECT_FALSE(store->append_blocks(trial.id, 0, uneven).ok());
  EXPECT_FALSE(store->append_blocks(trial.id, 0, example_rows(trial, 101, 1)).ok());
  EXPECT_EQ(must(store->trials(trial.session_id))[0].samples, 0);
  must(store->append_blocks(trial.id, 0, example_rows(trial, 100, 1)));
  must(store->append_blocks(trial.id, 1, example_rows(trial, 99, 1)));
  EXPECT_FALSE(store->append_blocks(trial.id, 2, example_rows(trial, 100, 1)).ok())
      << "after a second that was not full";
  EXPECT_EQ(must(store->trials(trial.session_id))[0].samples, 199);
}

TEST_F(Records, WrongReferencesAndRepeatedNumbersAreRefused) {
  SessionRecord orphan = example_session(99);
  EXPECT_FALSE(store->begin_session(orphan).ok());
  EXPECT_FALSE(store->begin_trial(example_trial(99)).ok());
  EXPECT_FALSE(store->end_session(99).ok());
  TrialRecord trial = example_trial(session());
  trial.id = must(store->begin_trial(trial));
  EXPECT_FALSE(store->begin_trial(example_trial(trial.session_id, 2)).ok()) << "one is running";
  trial.status = TrialStatus::aborted;
  must(store->end_trial(trial, {}));
  EXPECT_FALSE(store->begin_trial(example_trial(trial.session_id, 1)).ok()) << "number 1 again";
}

TEST_F(Records, NaNIsNoMeasureAndTheTrialStaysOpen) {
  TrialRecord trial = example_trial(session());
  trial.id = must(store->begin_trial(trial));
  trial.status = TrialStatus::completed;
  const std::vector<Measure> wrong{{"rmse", "force", std::nan(""), "N", 1, 0, 0, ""}};
  EXPECT_FALSE(store->end_trial(trial, wrong).ok());
  EXPECT_EQ(must(store->trials(trial.session_id))[0].status, TrialStatus::running);
  must(store->end_trial(trial, {}));
}

/// All that the store can tell about a patient, times of day aside.
std::string dump(SessionStore& store) {
  std::string text;
  const auto add = [&text](double value) {
    text += std::to_string(std::bit_cast<std::uint64_t>(value)) + " ";
  };
  for (const auto& patient : must(store.patients())) {
    text += patient.code + "\n";
    for (const auto& session : must(store.sessions(patient.id)))
      for (const auto& trial : must(store.trials(session.id))) {
        text += trial.task_text;
        const auto signals = must(store.signals(trial));
        for (std::size_t c = 0; c < signals.names().size(); ++c)
          for (const double value : signals.column(c)) add(value);
        for (const auto& measure : must(store.measures(trial.id))) add(measure.value.value_or(-1));
      }
  }
  return text;
}

TEST_F(Records, AClockThatIsSetBackLosesNothingAndSessionsAreReadByTheirTime) {
  const RowId patient_id = patient();
  std::vector<RowId> made;
  for (const char* start : {"2026-03-02T09:00:00Z", "2026-03-01T09:00:00Z"}) {
    SessionRecord record = example_session(patient_id);
    record.started_utc = start;
    const RowId id = must(store->begin_session(record));
    made.push_back(id);
    TrialRecord trial = example_trial(id);
    trial.preparations = {must(store->add_preparation(example_preparation(id)))};
    trial.id = must(store->begin_trial(trial));
    must(store->append_blocks(trial.id, 0, example_rows(trial, 100, 1)));
    trial.status = TrialStatus::completed;
    must(store->end_trial(trial, std::vector<Measure>{{"rmse", "force", 0.1, "N", 1, 10, 0, ""}}));
    must(store->end_session(id, "2026-02-01T09:00:00Z"));  // before it began
  }
  reopen();
  const auto sessions = must(store->sessions(patient_id));
  ASSERT_EQ(sessions.size(), 2u);
  EXPECT_EQ(sessions[0].id, made[1]);
  const auto points = must(store->progress(patient_id));
  ASSERT_EQ(points.size(), 2u);
  EXPECT_EQ(points[0].session_id, made[1]) << "the same order as that of the sessions";
  for (const auto& session : test::every(sessions)) {
    const auto trials = must(store->trials(session.id));
    ASSERT_EQ(trials.size(), 1u);
    EXPECT_EQ(must(store->signals(trials[0])).rows(), 100u);
    EXPECT_EQ(must(store->preparations(session.id)).size(), 1u);
  }
  EXPECT_EQ(must(store->check()), std::vector<Text>{});
}

TEST(Determinism, SameCallsMakeTheSameContent) {
  TemporaryFolder folder;
  std::string dumps[2];
  for (int run = 0; run < 2; ++run) {
    auto store = opened(folder.file("run" + std::to_string(run) + ".db"));
    const auto patient = must(store->add_patient("P-1"));
    TrialRecord trial = example_trial(must(store->begin_session(example_session(patient.id))));
    trial.id = must(store->begin_trial(trial));
    for (int s = 0; s < 3; ++s)
      must(store->append_blocks(trial.id, s, example_rows(trial, 100, static_cast<unsigned>(s))));
    trial.status = TrialStatus::completed;
    const std::vector<Measure> measures{{"rmse", "force", 0.1, "N", 1, 10, 0, ""}};
    must(store->end_trial(trial, measures));
    dumps[run] = dump(*store);
  }
  EXPECT_EQ(dumps[0], dumps[1]);
  EXPECT_GT(dumps[0].size(), 1000u);
}

TEST(Uuids, OfAScratchFileAreTheSameEachTimeAndOfAnyOtherNever) {
  TemporaryFolder folder;
  const auto uuids = [&](const std::string& name, OpenMode how) {
    const auto store = opened(folder.file(name), how);
    const auto patient = must(store->add_patient("P-1", "2026-01-02T10:00:00Z"));
    const RowId session = must(store->begin_session(example_session(patient.id)));
    must(store->begin_session(example_session(patient.id)));  // at the same moment
    TrialRecord trial = example_trial(session);
    trial.id = must(store->begin_trial(trial));
    return std::vector<std::string>{patient.uuid, must(store->sessions(patient.id)).at(0).uuid,
                                    must(store->trials(session)).at(0).uuid};
  };
  const auto once = uuids("a.db", OpenMode::scratch);
  EXPECT_EQ(uuids("b.db", OpenMode::scratch), once);
  const auto real = uuids("c.db", OpenMode::create);
  const auto again = uuids("d.db", OpenMode::create);
  for (std::size_t i = 0; i < real.size(); ++i) EXPECT_NE(real[i], again[i]);
}

}  // namespace
}  // namespace isograsp::storage::records_test
