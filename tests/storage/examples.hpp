// SPDX-License-Identifier: GPL-3.0-or-later
// Records and files that several storage tests use.
#pragma once

#include <bit>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <unistd.h>

#include "storage/access/open_store.hpp"
#include "storage/records/session_store.hpp"
#include "tests/support/must.hpp"

namespace isograsp::storage {

/// A folder of its own for one test, removed afterwards.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "isograsp-XXXXXX").string();
    path_ = mkdtemp(pattern.data());
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  [[nodiscard]] std::string file(const std::string& name) const { return path_ + "/" + name; }
  [[nodiscard]] const std::string& path() const { return path_; }
  [[nodiscard]] std::vector<std::string> listing() const {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(path_))
      names.push_back(entry.path().filename());
    std::sort(names.begin(), names.end());
    return names;
  }

 private:
  std::string path_;
};

inline std::string bytes_of(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

using test::must;

inline std::unique_ptr<SessionStore> opened(const std::string& path,
                                            OpenMode how = OpenMode::create) {
  return must(open_store(path, how));
}

inline bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

/// Doubles that text, float32 or SQL columns would change.
inline std::vector<double> awkward_doubles() {
  return {-0.0,
          0.0,
          5e-324,
          -2.2250738585072009e-308,
          std::numeric_limits<double>::max(),
          std::numeric_limits<double>::infinity(),
          0.1 + 0.2,
          std::bit_cast<double>(std::uint64_t{0x7FF8'0000'0000'BEEF}),   // NaN with a payload
          std::bit_cast<double>(std::uint64_t{0xFFF0'0000'0000'0001})};  // signalling NaN
}

inline SessionRecord example_session(RowId patient) {
  SessionRecord session;
  session.patient_id = patient;
  session.started_utc = "2026-03-01T09:30:00Z";
  session.hand = Hand::left;
  session.device_uri = "sim://paretic?seed=7";
  session.device_description = "simulated sensors";
  session.simulated = true;
  session.recorded = true;
  session.provenance = "line one\nline two: 'quoted' \"so\" — ž";
  session.protocol_name = "Short";
  session.protocol_text = "format = \"isograsp-protocol-1\"\n";
  session.rate_Hz = 100.0;
  session.device_delay_s = 0.0248;
  session.software_version = "0.1.0";
  session.cpu_features = "avx2 fma";
  session.seed = std::numeric_limits<std::uint64_t>::max();
  session.sensors = {{"thumb", "A 1"}, {"index", ""}, {"left camera", "C-3"}, {"fourth", "4"}};
  session.operator_name = "Therapist 7";
  session.realtime = "SCHED_FIFO 40, memory locked";
  session.allowed = "comfortable";
  session.references = {{"ceiling_N", 25.5}};
  session.calibration = "thumb: N or N m per count 0.01 0.01 0.01 0.0001 0.0001 0.0001\n";
  return session;
}

inline TrialRecord example_trial(RowId session, int number = 1) {
  TrialRecord trial;
  trial.session_id = session;
  trial.number = number;
  trial.task_name = "Grip force, sine";
  trial.task_version = 3;
  trial.task_text = "format = \"isograsp-task-1\"\n# ; DROP TABLE trials;\n";
  trial.scene_text = "format = \"isograsp-scene-1\"\n";
  trial.practice = true;
  trial.session_time_s = 12.345;
  trial.references = {{"maximum_force_N", 31.7}, {"resting_force_N", -0.0}, {"reach_m", 5e-324}};
  trial.seed = std::numeric_limits<std::uint64_t>::max() - 1;
  trial.place = TrialPlace{3, 1};
  trial.groups = {{"force", {"t_s", "thumb_fz_N", "index_fz_N"}}, {"raw", {"thumb_fz_counts"}}};
  return trial;
}

/// Of two columns; `mean` is that of the first.
inline PreparationRecord example_preparation(RowId session, double mean = 1.0) {
  PreparationRecord preparation;
  preparation.session_id = session;
  preparation.kind = "instrument_zero";
  preparation.session_time_s = 3.25;
  preparation.recorded_utc = "2026-03-01T09:30:03Z";
  preparation.operator_name = "Therapist 7";
  preparation.columns = {"thumb_fz_N", "wrist_x_m"};
  preparation.mean = {mean, 0.1 + 0.2};
  preparation.sd = {0.1, 5e-324};
  return preparation;
}

/// One block per group of `trial`: `rows` rows of seeded noise.
inline std::vector<std::vector<double>> example_rows(const TrialRecord& trial, std::size_t rows,
                                                     unsigned seed) {
  std::mt19937_64 random(seed);
  std::vector<std::vector<double>> blocks;
  for (const auto& group : trial.groups) {
    auto& block = blocks.emplace_back();
    for (std::size_t i = 0; i < rows * group.columns.size(); ++i)
      block.push_back(static_cast<double>(random() % 20000) * 0.01 - 100.0);
  }
  return blocks;
}

}  // namespace isograsp::storage
