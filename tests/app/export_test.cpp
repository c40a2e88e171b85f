// SPDX-License-Identifier: GPL-3.0-or-later
// A real session in every format, opened by what other people wrote: h5py and h5dump, the validator
// of BIDS, the JSON schema of FHIR R4. They are installed by `scripts/setup --test`.
#include <cmath>
#include <cstring>
#include <map>
#include <regex>
#include <sstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/csv.hpp"
#include "hand/platform_records.hpp"
#include "storage/access/open_store.hpp"
#include "storage/records/session_store.hpp"
#include "tests/support/bids_validator.hpp"
#include "tests/support/command.hpp"
#include "tests/support/every.hpp"

namespace isograsp::app::export_test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using test::codes_of;
using test::isograsp;
using test::TemporaryFolder;
using test::validate_bids;

const std::string kValidators = ISOGRASP_SOURCE_DIR "/build/validators/";
const std::string kSupport = ISOGRASP_SOURCE_DIR "/tests/support/";
const std::string kPython = "/usr/bin/python3 ";  // the one that Debian's packages are for

/// One session of four tasks, with and without an object, in the database `db`.
class Export : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = std::make_unique<TemporaryFolder>();
    db_ = folder_->path("clinic.db");
    const auto run =
        isograsp("run --protocol-file " ISOGRASP_SOURCE_DIR
                 "/library/protocols/short.toml --device 'sim://healthy?seed=4' --db " +
                 db_ + " --fast --patient T-01");
    ASSERT_EQ(run.status, 0) << run.err;
  }
  static void TearDownTestSuite() { folder_.reset(); }

  static std::string exported(const std::string& format, const std::string& name) {
    const std::string out = folder_->path(name);
    const auto done = isograsp("export --db " + db_ + " --format " + format + " --out " + out);
    EXPECT_EQ(done.status, 0) << done.err;
    return out;
  }

  struct Stored {
    storage::TrialRecord trial;
    Signals signals;
    std::vector<Measure> measures;
  };
  static std::vector<Stored> stored(const std::string& db) {
    const auto store = storage::open_store(db, storage::OpenMode::read_only).value();
    std::vector<Stored> all;
    for (const auto& patient : store->patients().value())
      for (const auto& session : store->sessions(patient.id).value())
        for (const auto& trial : store->trials(session.id).value())
          all.push_back({trial, store->signals(trial).value(), store->measures(trial.id).value()});
    return all;
  }

  static inline std::unique_ptr<TemporaryFolder> folder_;
  static inline std::string db_;
};

/// The hexadecimal text of a number's eight bytes, as read_hdf5.py writes it.
std::string bytes_of(double value) {
  unsigned char bytes[sizeof value];
  std::memcpy(bytes, &value, sizeof value);
  std::string text;
  char two[3];
  for (const unsigned char byte : bytes) {
    std::snprintf(two, sizeof two, "%02x", byte);
    text += two;
  }
  return text;
}

/// The scene with the contact thresholds that the trial says it was moved with.
std::string scene_of(const storage::TrialRecord& trial) {
  std::string text = std::regex_replace(trial.scene_text, std::regex("threshold_N *=.*"), "");
  for (std::size_t f = 0; f < kFingerCount; ++f) {
    const auto threshold_N = storage::value_of(trial.references, platform::kThreshold_N[f]);
    const std::string finger = "finger = \"" + std::string(kFingerNames[f]) + "\"";
    const std::size_t at = text.find(finger);
    if (threshold_N && at != std::string::npos)
      text.insert(at + finger.size(), "\nthreshold_N = " + format_number(*threshold_N));
  }
  return text;
}

TEST_F(Export, AnExportedTrialMovesItsObjectAgainToTheBit) {
  const std::string file = exported("hdf5", "again") + "/isograsp.h5";
  test::AtLeast objects(1);
  for (int number = 1; const Stored& one : stored(db_)) {
    const std::string trial = "/patients/T-01/session-01/trial-0" + std::to_string(number++);
    if (one.trial.scene_text.empty()) continue;
    ++objects;
    const auto again = isograsp(
        "simulate --scene " + folder_->write("scene.toml", scene_of(one.trial)) + " --forces " +
        file + ":" + trial + "/signals --out " + folder_->path("again.csv"));
    ASSERT_EQ(again.status, 0) << again.err;
    const auto moved = read_signals(folder_->path("again.csv"));
    ASSERT_TRUE(moved.ok());
    ASSERT_EQ(moved->rows(), one.signals.rows() + 1);
    const std::map<std::string, std::string> columns{
        {"actual_x_m", "x_m"}, {"actual_y_m", "y_m"},   {"actual_z_m", "z_m"},
        {"actual_qw", "qw"},   {"actual_qz", "qz"},     {"vx_mps", "vx_mps"},
        {"fx_N", "fx_N"},      {"wz_radps", "wz_radps"}};
    for (const auto& [stored_as, written_as] : columns)
      for (std::size_t row = 0; row < one.signals.rows(); ++row)
        ASSERT_EQ(one.signals.column(stored_as)[row], moved->column(written_as)[row])
            << trial << ": " << stored_as << " of row " << row + 1;
  }
}

TEST_F(Export, H5pyReadsEveryNumberUnitAndText) {
  const auto out = exported("hdf5", "h5py");
  const auto read = test::run(kPython + kSupport + "read_hdf5.py " + out + "/isograsp.h5");
  ASSERT_EQ(read.status, 0) << read.err << "install what is missing: scripts/setup --test";
  const Json file = Json::parse(read.out);
  EXPECT_EQ(file["@"]["format"], "isograsp-hdf5-1");
  const Json& session = file["patients"]["T-01"]["session-01"];
  EXPECT_EQ(session["@"]["simulated"], true);
  EXPECT_EQ(session["@"]["rate_Hz"], bytes_of(100.0));
  int number = 0;
  for (const auto& [trial, signals, measures] : test::every(stored(db_))) {
    const Json& node = session["trial-0" + std::to_string(++number)];
    EXPECT_EQ(node["@"]["task"], trial.task_name);
    EXPECT_EQ(node["task"]["value"], trial.task_text);
    EXPECT_EQ(node.contains("scene"), !trial.scene_text.empty());
    for (const auto& group : test::every(trial.groups)) {
      const Json& data = node["signals"][group.name];
      EXPECT_EQ(data["@"]["columns"], group.columns);
      EXPECT_EQ(data["@"]["units"].size(), group.columns.size());
      EXPECT_EQ(data["filters"], Json({"gzip", true, true}));
      ASSERT_EQ(data["value"].size(), signals.rows());
      for (std::size_t row = 0; row < signals.rows(); ++row)
        for (std::size_t c = 0; c < group.columns.size(); ++c)
          ASSERT_EQ(data["value"][row][c], bytes_of(signals.column(group.columns[c])[row]))
              << group.columns[c];
    }
    EXPECT_TRUE(node["signals"].contains("anatomical"));
    ASSERT_EQ(node["measures"]["value"].size(), measures.size());
    test::AtLeast with_value(1);
    for (std::size_t m = 0; m < measures.size(); ++m) {
      const Json& row = node["measures"]["value"][m];
      EXPECT_EQ(row["name"], measures[m].name);
      EXPECT_EQ(row["version"], measures[m].version);
      if (measures[m].value) {
        EXPECT_EQ(row["value"], bytes_of(*measures[m].value));
        ++with_value;
      }
    }
  }
  EXPECT_EQ(number, 4);
}

TEST_F(Export, H5dumpShowsTheTree) {
  const auto out = exported("hdf5", "h5dump");
  const auto tree = test::run("h5dump -n 1 " + out + "/isograsp.h5");
  ASSERT_EQ(tree.status, 0) << tree.err << "install what is missing: scripts/setup --test";
  for (const char* line :
       {"/patients/T-01/session-01/trial-04/signals/object",
        "attribute  /patients/T-01/session-01/hand\n",
        "/patients/T-01/session-01/trial-02/measures", "/trial-01/resting_force/mean/units\n"})
    EXPECT_NE(tree.out.find(line), std::string::npos) << line << " in\n" << tree.out;
}

TEST_F(Export, TheValidatorOfBidsFindsNoError) {
  const auto out = exported("bids", "bids");
  const auto sound = validate_bids(out);
  const Json report = Json::parse(sound.out, nullptr, false);
  ASSERT_FALSE(report.is_discarded()) << sound.err;
  EXPECT_EQ(codes_of(report["issues"]["errors"]), "") << report["issues"]["errors"].dump(1);
  EXPECT_EQ(report["summary"]["dataTypes"], Json::array({"channels", "events", "motion"}));
  EXPECT_EQ(report["summary"]["subjects"], Json::array({"01"}));
  EXPECT_EQ(sound.status, 0);
}

TEST_F(Export, TheValidatorOfBidsWouldFindOne) {
  const auto out = exported("bids", "bids_broken");
  test::AtLeast emptied(1);
  for (const auto& entry : test::every(fs::recursive_directory_iterator(out)))
    if (entry.path().string().ends_with("run-02_motion.json")) {
      ASSERT_TRUE(write_text(entry.path(), "{}").ok());
      ++emptied;
    }
  const auto broken = validate_bids(out);
  EXPECT_NE(broken.status, 0);
  const Json report = Json::parse(broken.out, nullptr, false);
  ASSERT_FALSE(report.is_discarded()) << broken.err;
  EXPECT_GT(report["issues"]["errors"].size(), 0u);
}

/// Cells of a line.
std::vector<std::string> cells(const std::string& line) {
  std::vector<std::string> all;
  std::istringstream in(line);
  for (std::string cell; std::getline(in, cell, '\t');) all.push_back(cell);
  return all;
}

TEST_F(Export, BidsChannelsNameTheColumnsAndTheNumbersComeBack) {
  const auto out = exported("bids", "bids_numbers");
  const auto last = stored(db_).back();
  const std::string stem =
      out + "/sub-01/ses-01/motion/sub-01_ses-01_task-posetargets_tracksys-isograsp_run-04_";
  std::istringstream channels(read_text(stem + "channels.tsv").value());
  std::istringstream motion(read_text(stem + "motion.tsv").value());
  std::string line;
  std::getline(channels, line);
  std::vector<std::string> names;
  std::map<std::string, std::string> type;
  while (std::getline(channels, line)) {
    const auto cell = cells(line);
    ASSERT_EQ(cell.size(), 8u) << line;
    names.push_back(cell[0]);
    type[cell[0]] = cell[1] + " " + cell[2] + " " + cell[3] + " " + cell[4];
  }
  EXPECT_EQ(type["t_s"], "n/a LATENCY n/a s");
  EXPECT_EQ(type["actual_x_m"], "x POS object m");
  EXPECT_EQ(type["target_qw"], "quat_w ORNT target n/a");
  EXPECT_EQ(type["vy_mps"], "y VEL object m/s");
  EXPECT_EQ(type["thumb_fz_N"], "z MISC thumb N");
  std::size_t rows = 0;
  for (; std::getline(motion, line); ++rows) {
    const auto cell = cells(line);
    ASSERT_EQ(cell.size(), names.size());
    for (std::size_t c = 0; c < names.size(); ++c) {
      const auto column = last.signals.column(names[c]);
      if (column.empty()) continue;  // the axes of the hand are not stored
      double value = 0.0;
      if (std::isfinite(column[rows])) {
        ASSERT_TRUE(parse_number(cell[c], value)) << cell[c];
        ASSERT_EQ(value, names[c] == "t_s" ? column[rows] - column[0] : column[rows]) << names[c];
      } else {
        ASSERT_EQ(cell[c], "n/a") << names[c];
      }
    }
  }
  EXPECT_EQ(rows, last.signals.rows());
}

test::CommandResult validate_fhir(const std::string& out) {
  const std::string schema = kValidators + "fhir-json-schema-validator/fhir.schema.json";
  EXPECT_TRUE(fs::exists(schema)) << "install it: scripts/setup --test";
  return test::run(kPython + kSupport + "validate_fhir.py " + schema + " " + out +
                   "/codesystem.json " + out + "/patient_1/session_1_bundle.json");
}

TEST_F(Export, TheSchemaOfFhirFindsNoErrorAndTheNumbersComeBack) {
  const auto out = exported("fhir", "fhir");
  const auto sound = validate_fhir(out);
  EXPECT_EQ(sound.status, 0) << sound.out << sound.err;
  const Json bundle = Json::parse(read_text(out + "/patient_1/session_1_bundle.json").value());
  const auto trials = stored(db_);
  const auto& entries = bundle["entry"];
  ASSERT_EQ(entries.size(), 2 + 2 * trials.size());
  EXPECT_EQ(entries[0]["resource"].size(), 2u) << "of the patient the code and nothing else";
  for (std::size_t t = 0; t < trials.size(); ++t) {
    std::map<std::string, Json> component;
    for (const auto place : {2 + 2 * t, 3 + 2 * t})
      for (const auto& one : entries[place]["resource"]["component"])
        component[one["code"]["coding"][0]["code"]] = one;
    for (const auto& measure : test::every(trials[t].measures)) {
      const Json& one = component[measure.name + ":" + measure.channel];
      if (measure.value) {
        EXPECT_EQ(one["valueQuantity"]["value"], *measure.value) << measure.name;
      } else {
        EXPECT_EQ(one["dataAbsentReason"]["text"], measure.reason) << measure.name;
      }
    }
    for (const auto& name : test::every(trials[t].signals.names())) {
      const Json& sampled = component["signal:" + name]["valueSampledData"];
      EXPECT_EQ(sampled["period"], 10.0);
      std::istringstream data(sampled["data"].get<std::string>());
      std::string text;
      for (const double stored : test::every(trials[t].signals.column(name))) {
        ASSERT_TRUE(data >> text) << name;
        double value = 0.0;
        if (std::isnan(stored)) {
          ASSERT_EQ(text, "E") << name;
        } else {
          ASSERT_TRUE(parse_number(text, value)) << text;
          ASSERT_EQ(value, stored) << name;
        }
      }
      EXPECT_FALSE(data >> text);
    }
  }
}

TEST_F(Export, TheSchemaOfFhirWouldFindAnErrorAndSoWouldTheLinks) {
  for (const auto& [from, to] :
       {std::pair<std::string, std::string>{"\"status\":\"final\"", "\"status\":\"done\""},
        {"\"valueSampledData\":{\"origin\"", "\"valueSampledData\":{\"zero\""},
        {"\"subject\":{\"reference\":\"urn:uuid:", "\"subject\":{\"reference\":\"urn:uuid:0"},
        {"\"code\":\"signals\"", "\"code\":\"sounds\""}}) {
    const auto out = exported("fhir", "fhir_broken");
    const std::string path = out + "/patient_1/session_1_bundle.json";
    std::string text = read_text(path).value();
    ASSERT_NE(text.find(from), std::string::npos) << from;
    text.replace(text.find(from), from.size(), to);
    ASSERT_TRUE(write_text(path, text).ok());
    EXPECT_EQ(validate_fhir(out).status, 1) << to;
    fs::remove_all(out);
  }
}

TEST_F(Export, TheSidecarOfATableSaysWhatEveryColumnIs) {
  const auto out = exported("csv", "sidecar");
  for (const char* trial : {"1", "2", "3", "4"}) {
    const std::string stem = out + "/patient_1/session_1/trial_" + trial;
    const Json sidecar = Json::parse(read_text(stem + ".json").value());
    const auto names = read_signals(stem + "_signals.csv").value().names();
    ASSERT_EQ(sidecar["columns"].size(), names.size());
    test::AtLeast with_axes(1);
    for (std::size_t c = 0; c < names.size(); ++c) {
      const Json& column = sidecar["columns"][c];
      EXPECT_EQ(column["name"], names[c]);
      EXPECT_GT(column["description"].get<std::string>().size(), 3u) << names[c];
      if (column.contains("axes")) {
        EXPECT_TRUE(sidecar["axes"].contains(column["axes"].get<std::string>())) << names[c];
        ++with_axes;
      }
    }
  }
}

TEST_F(Export, ATableComesBackWithTheSameMeasuresToTheLastBit) {
  const auto out = exported("csv", "round_trip");
  const std::string db = folder_->path("second.db");
  const auto first = stored(db_);
  for (std::size_t t = 0; t < first.size(); ++t) {
    const std::string stem = out + "/patient_1/session_1/trial_" + std::to_string(t + 1);
    const std::string scene =
        first[t].trial.scene_text.empty() ? "" : " --scene " + stem + "_scene.toml";
    const auto done = isograsp("import --signals " + stem + "_signals.csv --task " + stem +
                               "_task.toml" + scene + " --patient T-02 --db " + db);
    ASSERT_EQ(done.status, 0) << done.err;
  }
  const auto second = stored(db);
  ASSERT_EQ(second.size(), first.size());
  for (std::size_t t = 0; t < first.size(); ++t) {
    EXPECT_EQ(second[t].trial.task_text, first[t].trial.task_text);
    EXPECT_EQ(second[t].trial.scene_text, first[t].trial.scene_text);
    for (const auto& name : test::every(first[t].signals.names())) {
      const auto before = first[t].signals.column(name);
      const auto after = second[t].signals.column(name);
      ASSERT_EQ(after.size(), before.size()) << name;
      for (std::size_t row = 0; row < before.size(); ++row)
        ASSERT_TRUE(after[row] == before[row] ||
                    (std::isnan(after[row]) && !std::isfinite(before[row])))
            << name;
    }
    ASSERT_EQ(second[t].measures.size(), first[t].measures.size());
    for (std::size_t m = 0; m < first[t].measures.size(); ++m) {
      EXPECT_EQ(second[t].measures[m].name, first[t].measures[m].name);
      EXPECT_EQ(second[t].measures[m].value, first[t].measures[m].value)
          << first[t].measures[m].name;
    }
  }
  EXPECT_EQ(isograsp("db verify " + db).status, 0);
  EXPECT_EQ(isograsp("db check " + db).status, 0);
}

}  // namespace
}  // namespace isograsp::app::export_test
