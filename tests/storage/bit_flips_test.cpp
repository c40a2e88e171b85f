// SPDX-License-Identifier: GPL-3.0-or-later
// One bit of the whole file is another one: it is named, or nothing that can be read has changed.
#include <cstdlib>
#include <fstream>
#include <random>
#include <span>

#include "storage/person/identity.hpp"
#include "tests/storage/clinic_under_attack.hpp"
#include "tests/support/database_content.hpp"

namespace isograsp::storage::bit_flips_test {
namespace {

struct BitFlips : ClinicUnderAttack {
  /// So that much of the file is signals, as in a clinic's.
  void record_a_minute() const {
    constexpr int kSeconds = 60;
    const auto store = opened(path);
    SessionRecord session = example_session(1);
    session.id = must(store->begin_session(session, {}));
    TrialRecord trial = example_trial(session.id);
    trial.id = must(store->begin_trial(trial));
    for (int second = 0; second < kSeconds; ++second)
      must(store->append_blocks(trial.id, second,
                                example_rows(trial, 100, static_cast<unsigned>(second))));
    trial.status = TrialStatus::completed;
    must(store->end_trial(trial, {}));
    must(store->end_session(session.id));
  }
};
INSTANTIATE_TEST_SUITE_P(, BitFlips, testing::Bool(),
                         [](const auto& one) { return one.param ? "Protected" : "Unprotected"; });

/// Every row, and every signal to the bit. A Zstandard frame has bits that mean nothing: of packed
/// signals what they say is compared, not how they stand there.
std::string all_that_is_read(const std::string& path) {
  auto left_out = test::columns_without_seal();
  left_out.insert("signal_packs.float64_shuffled_zstd");
  std::string all = test::content_of_database(path, left_out);
  const auto store = opened(path, OpenMode::read_only);
  constexpr int kSessions = 100;
  for (const SessionRecord& session : must(store->recent_sessions(kSessions)))
    for (const TrialRecord& trial : must(store->trials(session.id))) {
      const Signals signals = must(store->signals(trial));
      for (std::size_t c = 0; c < signals.names().size(); ++c) {
        const auto column = signals.column(c);
        const auto bytes = std::as_bytes(std::span(column));
        all.append(reinterpret_cast<const char*>(bytes.data()), bytes.size());
      }
    }
  return all;
}

TEST_P(BitFlips, NoneOfThemChangesWithoutAWordWhatIsRead) {
  // scripts/test --long sets it.
  const int flips = std::getenv("ISOGRASP_LONG") != nullptr ? 10000 : 150;
  if (GetParam()) must(set_identity(*access, "P-1", {"Vera", "", ""}));
  record_a_minute();
  const std::string backup = folder.file("backup.db");  // one file, without a log
  must(opened(path, OpenMode::read_only)->backup(backup));
  const std::string good = bytes_of(backup);
  const std::string content = all_that_is_read(backup);
  ASSERT_GT(content.size(), 4u * 6000u * sizeof(double)) << "the signals of a minute are among it";
  const std::string copy = folder.file("flipped.db");
  std::mt19937_64 random(20261128);
  int named = 0;
  int silent = 0;
  for (int flip = 0; flip < flips; ++flip) {
    const std::size_t bit = random() % (8 * good.size());
    std::string bad = good;
    bad[bit / 8] = static_cast<char>(bad[bit / 8] ^ (1 << (bit % 8)));
    for (const char* beside : {"", "-wal", "-shm", "-journal"})
      std::filesystem::remove(copy + beside);
    std::ofstream(copy, std::ios::binary) << bad;
    const auto store = open_store(copy, OpenMode::read_only);
    const auto problems = store ? (*store)->check() : Result<std::vector<Text>>(store.error());
    if (!problems || !problems->empty()) {
      ++named;
    } else {
      ++silent;
      EXPECT_TRUE(all_that_is_read(copy) == content)
          << "silent: byte " << bit / 8 << ", bit " << bit % 8;
    }
  }
  RecordProperty("named", named);
  RecordProperty("silent", silent);
  // The others are where nothing is kept: most tables have a page of their own with few rows.
  EXPECT_GT(named, flips / 5);
}

}  // namespace
}  // namespace isograsp::storage::bit_flips_test
