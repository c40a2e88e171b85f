// SPDX-License-Identifier: GPL-3.0-or-later
// One whole session in virtual time, with a fixed seed and the shipped library: every bit of its
// signals and measures is the same wherever and however the program was built. The C library
// computes sines and powers otherwise where a processor lacks FMA; no bit of this session comes
// from there (GLIBC_TUNABLES=glibc.cpu.hwcaps=-AVX2,-FMA gives the same hash), so there is one for
// all.
#include <bit>
#include <cmath>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include "session/protocol/protocol_run.hpp"
#include "session/session.hpp"
#include "storage/access/open_store.hpp"
#include "storage/crypto/content_hash.hpp"
#include "tests/session/whole_session.hpp"
#include "tests/support/every.hpp"
#include "tests/support/temporary_folder.hpp"

namespace isograsp::session::constant_hash_test {
namespace {

const std::string kLibrary = ISOGRASP_SOURCE_DIR "/library";

/// Numbers count with every bit; a NaN is a NaN, whatever stands in its other bits.
void add(std::string& bytes, double value) {
  const auto bits = std::isnan(value) ? 0x7FF8000000000000U : std::bit_cast<std::uint64_t>(value);
  bytes += std::to_string(bits) + ",";
}

/// Of all trials: the task, each column with its name and values, each measure with its value.
std::string hash_of(storage::SessionStore& store, const std::string& patient_code) {
  const auto patient = store.find_patient(patient_code).value().value();
  std::string bytes;
  for (const auto& session : test::every(store.sessions(patient.id).value()))
    for (const auto& trial : test::every(store.trials(session.id).value())) {
      bytes += trial.task_name + "\n";
      const auto signals = store.signals(trial).value();
      for (const std::string& name : test::every(signals.names())) {
        bytes += name + ":";
        for (const double value : test::every(signals.column(name))) add(bytes, value);
      }
      for (const auto& measure : store.measures(trial.id).value()) {
        bytes += measure.name + " " + measure.channel + ":";
        add(bytes, measure.value.value_or(std::nan("")));
      }
    }
  std::string hex;
  for (const auto byte : storage::content_hash(bytes)) {
    constexpr std::string_view kDigits = "0123456789abcdef";
    hex += kDigits[static_cast<std::size_t>(byte) >> 4];
    hex += kDigits[static_cast<std::size_t>(byte) & 15];
  }
  return hex;
}

TEST(ConstantHash, OfSignalsAndMeasuresOfOneWholeSession) {
  const test::TemporaryFolder folder;
  const test::WholeSession whole{folder.path("clinic.db"), "HASH-01",
                                 "sim://paretic?seed=21&drop=0.001",
                                 kLibrary + "/protocols/demonstration.toml"};
  (void)run_whole(whole);
  const auto store = storage::open_store(whole.database, storage::OpenMode::read_only).value();
  EXPECT_EQ(hash_of(*store, whole.patient_code),
            "5070151268bf1a1bacaa89c76939d46def9d81abdc9885343bd7f8c0a2a15ade")
      << "a bit of a signal or measure is another one. If that is meant (a task, a measure or the "
         "simulated person changed), raise the version of what changed, say so in CHANGELOG.md and "
         "write the new hash here; else look for what changed it: tests/session, tests/tasks, "
         "scripts/compare_builds";
}

}  // namespace
}  // namespace isograsp::session::constant_hash_test
