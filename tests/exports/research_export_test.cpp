// SPDX-License-Identifier: GPL-3.0-or-later
// What leaves the clinic: every number to the last bit, every column described, nobody named; the
// files of every format as they were listed, or none.
#include "exports/research_export.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <filesystem>
#include <limits>
#include <set>
#include <sstream>

#include <gtest/gtest.h>
#include <hdf5.h>
#include <nlohmann/json.hpp>

#include "core/csv.hpp"
#include "exports/export_trial.hpp"
#include "exports/fhir_codes.hpp"
#include "hand/anatomical_axes.hpp"
#include "languages/languages.hpp"
#include "storage/access/open_store.hpp"
#include "storage/person/consent.hpp"
#include "tasks/facts/column_facts.hpp"
#include "tests/reports/demo_clinic.hpp"
#include "tests/reports/emitted_measures.hpp"
#include "tests/support/every.hpp"
#include "tests/support/files_below.hpp"
#include "tests/support/platform_columns.hpp"
#include "tests/support/temporary_folder.hpp"

namespace isograsp::exports::research_export_test {
namespace {

namespace fs = std::filesystem;
using test::files_below;

constexpr std::array<ExportFormat, 4> kAll{ExportFormat::csv, ExportFormat::hdf5,
                                           ExportFormat::bids, ExportFormat::fhir};

/// A clinic with one person of whom everything is told, and one trial with every odd number.
class ResearchExport : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = std::make_unique<test::TemporaryFolder>();
    store_ = *storage::open_store(folder_->path("clinic.db"), storage::OpenMode::create);
    test::DemoSession demo;
    demo.date = "2026-03-02";
    demo.with_faults = true;
    test::add_session(*store_, "TK-104", demo);
    add_odd_trial();
  }
  static void TearDownTestSuite() {
    store_.reset();
    folder_.reset();
  }

  /// NaN with a payload, both infinities, both zeros, the smallest and the largest number.
  static std::vector<double> odd_numbers() {
    using Limits = std::numeric_limits<double>;
    return {std::bit_cast<double>(std::uint64_t{0x7ff8dead0000beef}),
            Limits::infinity(),
            -Limits::infinity(),
            0.0,
            -0.0,
            Limits::denorm_min(),
            Limits::max(),
            -1.0 / 3.0};
  }

  static void add_odd_trial() {
    const auto patient = store_->find_patient("TK-104").value().value();
    storage::PatientProfile profile;
    profile.affected = storage::Side::left;
    profile.dominant = Hand::right;
    profile.onset_date = "2026-02-20";
    profile.notes = profile.goals = "secret";
    ASSERT_TRUE(store_->set_profile(patient.id, profile).ok());
    ASSERT_TRUE(store_->add_treatment_mark(patient.id, {0, "2026-03-03", "drug", "secret"}).ok());
    storage::SessionRecord session;
    session.patient_id = patient.id;
    session.started_utc = "2026-03-09T10:00:00Z";
    session.device_uri = "can://secret?protocol=rft";
    session.device_description = "three sensors";
    session.provenance = session.protocol_text = session.operator_name = "secret";
    session.sensors = {{"thumb", "secret"}, {"index", "secret"}, {"middle", "secret"}};
    session.seed = std::numeric_limits<std::uint64_t>::max();
    session.software_version = "0.1.0";
    const auto id = store_->begin_session(session).value();
    storage::PreparationRecord zero;
    zero.session_id = id;
    zero.kind = platform::kInstrumentZero;
    zero.columns = platform::six_axes_columns();
    zero.mean.assign(zero.columns.size(), 0.1);
    zero.sd.assign(zero.columns.size(), 1.0 / 3.0);
    zero.operator_name = "secret";
    zero.recorded_utc = "2026-03-09T10:00:01Z";
    storage::TrialRecord trial;
    trial.session_id = id;
    trial.preparations = {store_->add_preparation(zero).value()};
    trial.number = 1;
    trial.task_name = "Odd numbers";
    trial.task_text = "not a task file";
    trial.scene_text = "not a scene";
    trial.session_time_s = 3.5;
    trial.groups = {{"task", {"t_s", "phase"}}, {"force", {"odd_N", "thumb_flags"}}};
    trial.id = store_->begin_trial(trial).value();
    std::vector<std::vector<double>> rows(2);
    for (const double number : odd_numbers()) {
      rows[0].insert(rows[0].end(), {0.01 * static_cast<double>(rows[0].size() / 2), 1.0});
      rows[1].insert(rows[1].end(), {number, 0.0});
    }
    ASSERT_TRUE(store_->append_blocks(trial.id, 0, rows).ok());
    for (const char* kind : {"note", "fault"})
      ASSERT_TRUE(store_
                      ->add_event(id, {trial.id, 3.55, kind,
                                       kind == std::string("note") ? "secret" : "tab\there"})
                      .ok());
    trial.status = storage::TrialStatus::completed;
    const Measure absent{"cv", "force", {}, "%", 1, 0, 8, "no samples"};
    const Measure third{"rmse", "force", 1.0 / 3.0, "N", 2, 7, 1, ""};
    ASSERT_TRUE(store_->end_trial(trial, std::array{absent, third}).ok());
  }

  static std::string exported(ExportFormat format, const std::string& name) {
    const auto out = folder_->path(name);
    const auto done = write_export(*store_, {}, format, out);
    EXPECT_TRUE(done.ok()) << done.error().message();
    return out;
  }

  static inline std::unique_ptr<test::TemporaryFolder> folder_;
  static inline std::unique_ptr<storage::SessionStore> store_;
};

TEST_F(ResearchExport, EveryFormatWritesExactlyTheFilesThatWereListed) {
  for (const ExportFormat format : kAll) {
    auto listed = list_export(*store_, {}, format).value();
    std::sort(listed.begin(), listed.end());
    const auto out = exported(format, "listed_" + std::string(name_of(format)));
    EXPECT_EQ(files_below(out), listed) << name_of(format);
    for (const auto& file : test::every(listed))
      EXPECT_EQ(file.find("104"), std::string::npos) << "no code in the name of a file";
    const auto again = write_export(*store_, {}, format, out);
    EXPECT_FALSE(again.ok()) << "nothing is overwritten";
    EXPECT_EQ(files_below(out), listed) << "and nothing is added";
  }
}

/// Every key of a document, and every value that machines read.
void collect(const nlohmann::json& json, std::set<std::string>& keys,
             std::set<std::string>& codes) {
  for (const auto& [key, value] : json.items()) {
    if (json.is_object()) keys.insert(key);
    if (key == "code" && value.is_string()) codes.insert(value.get<std::string>());
    if (value.is_structured()) collect(value, keys, codes);
  }
}

TEST_F(ResearchExport, PeopleReadItInTheirLanguageAndMachinesAsInEnglish) {
  const auto written = [](ExportFormat format, const std::string& language) {
    const auto out = folder_->path("in_" + language + "_" + std::string(name_of(format)));
    EXPECT_TRUE(write_export(*store_, {}, format, out, {}, languages::language(language)).ok());
    return out;
  };
  const std::string bundle = "/patient_1/session_1_bundle.json";
  const std::string codes = "/codesystem.json";
  const auto english = written(ExportFormat::fhir, "en");
  const auto german = written(ExportFormat::fhir, "de");
  for (const std::string& file : {bundle, codes}) {
    const std::string text = test::read_file(german + file);
    std::set<std::string> keys[2];
    std::set<std::string> values[2];
    collect(nlohmann::json::parse(test::read_file(english + file)), keys[0], values[0]);
    collect(nlohmann::json::parse(text), keys[1], values[1]);
    EXPECT_TRUE(keys[1].erase("language") == 1) << file;
    EXPECT_EQ(keys[1], keys[0]) << file;
    EXPECT_EQ(values[1], values[0]) << file;
    EXPECT_NE(text.find("\"Nummer der Sitzung\""), std::string::npos) << file;
    EXPECT_EQ(text.find("\"Number of the session\""), std::string::npos) << file;
    EXPECT_NE(text.find("\"Zeit seit Beginn des Versuchs\""), std::string::npos) << file;
  }
  const auto columns = [](const std::string& folder, std::size_t first, std::size_t count) {
    std::string kept;
    for (const auto& file : files_below(folder)) {
      if (!file.ends_with("_channels.tsv")) continue;
      std::istringstream lines(test::read_file(folder + "/" + file));
      for (std::string line; std::getline(lines, line);) {
        std::istringstream fields(line);
        std::string field;
        for (std::size_t i = 0; std::getline(fields, field, '\t'); ++i)
          if (i >= first && i < first + count) kept += field + "\n";
      }
    }
    return kept;
  };
  const auto bids = written(ExportFormat::bids, "fr");
  const auto plain = written(ExportFormat::bids, "en");
  constexpr std::size_t kDescription = 7;
  EXPECT_EQ(files_below(bids), files_below(plain));
  EXPECT_EQ(columns(bids, 0, kDescription), columns(plain, 0, kDescription));
  EXPECT_NE(columns(bids, kDescription, 1).find("Temps depuis le début de l’essai"),
            std::string::npos);
  EXPECT_NE(test::read_file(bids + "/participants.json").find("Côté atteint"), std::string::npos);
}

TEST_F(ResearchExport, WhoIsNotReleasedIsLeftOutCountedAndRefusedByName) {
  test::TemporaryFolder folder;
  const auto store = storage::open_store(folder.path("c.db"), storage::OpenMode::scratch).value();
  for (const char* code : {"P-1", "P-2"}) {
    storage::SessionRecord session;
    session.patient_id = store->add_patient(code).value().id;
    storage::TrialRecord trial;
    trial.session_id = store->begin_session(session).value();
    trial.number = 1;
    trial.task_name = "Maximum grip";
    trial.groups = {{"task", {"t_s"}}};
    trial.id = store->begin_trial(trial).value();
    trial.status = storage::TrialStatus::completed;
    ASSERT_TRUE(store->end_trial(trial, {}).ok());
  }
  const auto trials = [&] {
    int count = 0;
    EXPECT_TRUE(for_each_trial(*store, {}, [&](const ExportSource& source) {
                  ++count;
                  EXPECT_EQ(source.place.patient, source.patient->code == "P-1" ? 1 : 2);
                  return Result<void>();
                }).ok());
    return count;
  };
  EXPECT_EQ(trials(), 2);
  const auto access = storage::Access::open(folder.path("c.db")).value();
  ASSERT_TRUE(storage::add_consent(*access, "P-1",
                                   {0, "2026-04-02", "research", "consent", "refused", "", "", ""})
                  .ok());
  EXPECT_EQ(trials(), 1);
  EXPECT_EQ(count_not_released(*store, {}).value(), 1u);
  EXPECT_EQ(count_not_released(*store, {"P-2"}).value(), 0u);
  const auto named = list_export(*store, {"P-1"}, ExportFormat::csv);
  ASSERT_FALSE(named.ok());
  EXPECT_NE(named.error().message().find("not released for research"), std::string::npos);
}

TEST_F(ResearchExport, AnExportThatCannotBePublishedWholeLeavesNothing) {
  const auto out = folder_->path("blocked");
  fs::create_directories(out);
  // Stands where a folder of the export has to be, behind files that can be moved.
  ASSERT_TRUE(write_text(out + "/patient_1", "in the way").ok());
  const auto done = write_export(*store_, {}, ExportFormat::csv, out);
  ASSERT_FALSE(done.ok());
  EXPECT_EQ(files_below(out), std::vector<std::string>{"patient_1"});
}

TEST_F(ResearchExport, NoFormatTellsWhoWhenOrWhere) {
  for (const ExportFormat format : kAll) {
    const auto out = exported(format, "private_" + std::string(name_of(format)));
    bool code_seen = false;
    for (const auto& file : test::every(files_below(out))) {
      const auto text = read_text(out + "/" + file).value();
      for (const char* word : {"secret", "2026-0", "09:30", "10:00:0"})
        EXPECT_EQ(text.find(word), std::string::npos) << file << " holds " << word;
      code_seen = code_seen || text.find("TK-104") != std::string::npos;
    }
    EXPECT_TRUE(code_seen) << name_of(format) << ": else nothing was looked at";
  }
}

TEST_F(ResearchExport, AnExportThatIsCancelledLeavesNothingWhateverItsFormat) {
  for (const ExportFormat format : kAll)
    for (const int after : {0, 1, 5}) {
      const auto out = folder_->path("cancelled");
      int asked = 0;
      EXPECT_FALSE(write_export(*store_, {}, format, out, [&](double, const auto&) {
                     return asked++ < after;
                   }).ok());
      EXPECT_FALSE(fs::exists(out)) << name_of(format) << " after " << after;
    }
}

TEST_F(ResearchExport, Hdf5HoldsEverySignalToTheLastBit) {
  const auto out = exported(ExportFormat::hdf5, "bits");
  const hid_t file = H5Fopen((out + "/isograsp.h5").c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  ASSERT_GE(file, 0);
  std::size_t compared = 0;
  const auto patient = store_->find_patient("TK-104").value().value();
  int session_number = 0;
  for (const auto& session : test::every(store_->sessions(patient.id).value())) {
    ++session_number;
    for (const auto& trial : test::every(store_->trials(session.id).value())) {
      const auto signals = store_->signals(trial).value();
      std::size_t next = 0;
      for (const auto& group : test::every(trial.groups)) {
        char place[128];
        std::snprintf(place, sizeof place, "/patients/TK-104/session-%02d/trial-%02d/signals/",
                      session_number, trial.number);
        const hid_t data = H5Dopen2(file, (place + group.name).c_str(), H5P_DEFAULT);
        ASSERT_GE(data, 0) << place << group.name;
        const std::size_t width = group.columns.size();
        std::vector<double> values(signals.rows() * width);
        ASSERT_GE(H5Dread(data, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()),
                  0);
        H5Dclose(data);
        for (std::size_t c = 0; c < width; ++c, ++next)
          for (std::size_t row = 0; row < signals.rows(); ++row, ++compared)
            ASSERT_EQ(std::bit_cast<std::uint64_t>(values[row * width + c]),
                      std::bit_cast<std::uint64_t>(signals.column(next)[row]))
                << place << group.columns[c] << " row " << row;
      }
    }
  }
  H5Fclose(file);
  EXPECT_GT(compared, 10000u);
}

TEST_F(ResearchExport, SameDatabaseSameBytes) {
  for (const ExportFormat format : {ExportFormat::csv, ExportFormat::hdf5, ExportFormat::bids}) {
    const auto first = exported(format, "first_" + std::string(name_of(format)));
    const auto second = exported(format, "second_" + std::string(name_of(format)));
    for (const auto& file : test::every(files_below(first)))
      EXPECT_EQ(read_text(first + "/" + file).value(), read_text(second + "/" + file).value())
          << file;
  }
}

TEST_F(ResearchExport, FhirSaysWhatIsNoNumber) {
  const auto out = exported(ExportFormat::fhir, "odd_fhir");
  const auto text = read_text(out + "/patient_1/session_2_bundle.json").value();
  EXPECT_NE(text.find("\"data\":\"E U L 0 -0 5e-324 1.7976931348623157e+308 -0.3333333333333333\""),
            std::string::npos);
  EXPECT_NE(text.find("\"text\":\"no samples\""), std::string::npos);
  EXPECT_NE(text.find("\"value\":0.3333333333333333,\"unit\":\"N\""), std::string::npos);
}

TEST_F(ResearchExport, BidsHasOneLineForAnEventAndWordsForWhatIsMissing) {
  const auto out = exported(ExportFormat::bids, "odd_bids");
  const std::string stem =
      out + "/sub-01/ses-02/motion/sub-01_ses-02_task-unknown_tracksys-isograsp_run-01_";
  const auto motion = read_text(stem + "motion.tsv").value();
  EXPECT_TRUE(motion.starts_with("0\t1\tn/a\t0\n0.01\t1\tn/a\t0\n")) << motion;
  EXPECT_NE(motion.find("0.07\t1\t-0.3333333333333333\t0\n"), std::string::npos) << motion;
  const auto events = read_text(stem + "events.tsv").value();
  EXPECT_NE(events.find("\tn/a\tfault\ttab here\n"), std::string::npos) << events;
  EXPECT_NE(events.find("0\t0.08\tphase_active\tn/a\n"), std::string::npos) << events;
  const auto participants = read_text(out + "/participants.tsv").value();
  EXPECT_NE(participants.find("sub-01\tTK-104\tleft\tright\t-10\n"), std::string::npos)
      << participants;
}

TEST(TrialAsJson, AMeasureThatIsNoNumberIsNullAndSaysWhy) {
  ExportTrial trial;
  for (const double value : {1e308, std::numeric_limits<double>::infinity()}) {
    Measure measure;
    measure.name = "rmse";
    measure.value = value;
    trial.measures.push_back(measure);
  }
  const auto json = nlohmann::json::parse(trial_as_json(trial, 0));
  EXPECT_EQ(json["measures"][0]["value"], 1e308);
  EXPECT_FALSE(json["measures"][0].contains("reason"));
  EXPECT_TRUE(json["measures"][1]["value"].is_null());
  EXPECT_EQ(json["measures"][1]["reason"], "not a finite number");
}

TEST(ColumnFacts, EveryColumnOfATrialIsDescribedWithItsUnit) {
  auto names = test::platform_columns(false);
  for (auto& name : test::platform_columns(true)) names.push_back(std::move(name));
  for (const Finger finger : kFingers)
    for (const HandAxis axis : kHandAxes) names.push_back(anatomical_column(finger, axis));
  for (const auto& name : test::every(names)) {
    const auto facts = tasks::describe_column(name);
    EXPECT_TRUE(facts.known) << name;
    EXPECT_TRUE(ucum_code(facts.unit)) << name;
    if (facts.axes.empty()) continue;
    EXPECT_TRUE(std::any_of(kColumnAxes.begin(), kColumnAxes.end(), [&](const auto& axes) {
      return axes.first == facts.axes;
    })) << name;
  }
  EXPECT_FALSE(tasks::describe_column("corridor_error_N").known);
  EXPECT_EQ(tasks::describe_column("corridor_error_N").unit, "N");
}

TEST(TaskKinds, AreCalledAsInTaskFiles) {
  std::set<std::string_view> seen;
  for (const auto& spec : test::every(test::library_tasks())) {
    const std::string line = "kind = \"" + std::string(spec.kind->name) + "\"";
    EXPECT_NE(spec.text.find(line), std::string::npos) << spec.file << " has no " << line;
    seen.insert(spec.kind->name);
  }
  EXPECT_EQ(seen.size() + 1, tasks::all_kinds().size()) << "all but recorded";
}

TEST(FhirCodes, EveryMeasureHasAUnitOfUcum) {
  std::size_t measures = 0;
  for (const auto& [spec, list] : test::every(test::emitted()))
    for (const auto& measure : test::every(list)) {
      ++measures;
      EXPECT_TRUE(ucum_code(measure.unit)) << measure.name << ": " << measure.unit;
      EXPECT_EQ(fhir_code(measure).find(' '), std::string::npos) << measure.name;
    }
  EXPECT_GT(measures, 100u);
}

}  // namespace
}  // namespace isograsp::exports::research_export_test
