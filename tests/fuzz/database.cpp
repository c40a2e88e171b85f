// SPDX-License-Identifier: GPL-3.0-or-later
// A database with bytes changed anywhere: it is read or refused, and signals whose hash is the one
// that was stored are the ones that were stored.
#include <filesystem>
#include <fstream>
#include <iterator>

#include "storage/access/open_store.hpp"
#include "storage/records/session_store.hpp"
#include "tests/fuzz/support.hpp"
#include "tests/support/must.hpp"
#include "tests/support/temporary_folder.hpp"

using namespace isograsp;

namespace {

using test::must;

constexpr std::size_t kRows = 20;

double value_at(std::size_t column, std::size_t row) {
  return 0.01 * static_cast<double>(row) - static_cast<double>(column);
}

/// One trial that is packed and one that is in blocks of a second.
struct Sound {
  test::TemporaryFolder folder;
  std::string path = folder.path("clinic.db");
  std::string bytes;
  std::string hash;

  Sound() {
    {
      const auto store = must(storage::open_store(path, storage::OpenMode::create));
      storage::SessionRecord session;
      session.patient_id = must(store->add_patient("P-1")).id;
      session.rate_Hz = static_cast<double>(kRows);
      session.sensors = {{"thumb", "A-1"}, {"camera", ""}};
      session.references = {{"ceiling_N", 30.0}};
      const storage::RowId session_id = must(store->begin_session(session));
      storage::PreparationRecord zero;
      zero.session_id = session_id;
      zero.kind = "instrument_zero";
      zero.columns = {"thumb_fz_N", "index_fz_N"};
      zero.mean = {0.1, 0.2};
      zero.sd = {0.01, 0.02};
      zero.references = {{"drift_N", 0.5}};
      const storage::RowId zero_id = must(store->add_preparation(zero));
      for (int number = 1; number <= 2; ++number) {
        storage::TrialRecord trial;
        trial.session_id = session_id;
        trial.references = {{"maximum_force_N", 20.0}};
        trial.preparations = {zero_id};
        trial.number = number;
        trial.task_name = "fuzz";
        trial.groups = {{"force", {"t_s", "thumb_fz_N"}}, {"raw", {"thumb_fz_counts"}}};
        trial.id = must(store->begin_trial(trial));
        std::vector<std::vector<double>> rows(2);
        for (std::size_t r = 0; r < kRows; ++r) {
          rows[0].insert(rows[0].end(), {value_at(0, r), value_at(1, r)});
          rows[1].push_back(value_at(2, r));
        }
        fuzz::require(store->append_blocks(trial.id, 0, rows).ok(), "the sound file can be made");
        if (number == 2) break;
        trial.status = storage::TrialStatus::completed;
        fuzz::require(store->end_trial(trial, {}).ok(), "the sound file can be made");
        hash = must(store->trials(session_id)).at(0).signals_hash;
      }
    }
    std::ifstream in(path, std::ios::binary);
    bytes.assign(std::istreambuf_iterator<char>(in), {});
  }
};

void read(storage::SessionStore& store, const std::string& hash) {
  static_cast<void>(store.check().ok());
  const auto patients = store.patients();
  if (!patients) return;
  for (const storage::PatientRecord& patient : *patients) {
    static_cast<void>(store.progress(patient.id).ok());
    const auto sessions = store.sessions(patient.id);
    if (!sessions) continue;
    for (const storage::SessionRecord& session : *sessions) {
      static_cast<void>(store.events(session.id).ok());
      static_cast<void>(store.preparations(session.id).ok());
      const auto trials = store.trials(session.id);
      if (!trials) continue;
      for (const storage::TrialRecord& trial : *trials) {
        const auto signals = store.signals(trial);
        if (!signals || trial.signals_hash != hash || signals->rows() != kRows ||
            signals->names().size() != 3)
          continue;
        for (std::size_t c = 0; c < 3; ++c)
          for (std::size_t r = 0; r < kRows; ++r)
            fuzz::require(fuzz::same_bits(signals->column(c)[r], value_at(c, r)),
                          "what has the hash of the signals is the signals");
      }
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const Sound sound;
  fuzz::Numbers in(data, size);
  std::string bytes = sound.bytes;
  while (!in.empty()) {
    std::size_t at = in.number<std::uint32_t>();
    const std::size_t count = 1 + in.byte() % 8U;
    for (const std::uint8_t byte : in.bytes(count))
      bytes[at++ % bytes.size()] = static_cast<char>(byte);
  }
  {
    std::ofstream out(sound.path, std::ios::binary | std::ios::trunc);
    out << bytes;
  }
  const auto store = storage::open_store(sound.path, storage::OpenMode::read_only);
  if (store)
    read(**store, sound.hash);
  else
    fuzz::require(!store.error().what.empty() && !store.error().remedy.empty(),
                  "an error says what and what to do");
  std::error_code ignored;
  for (const char* suffix : {"-wal", "-shm"}) std::filesystem::remove(sound.path + suffix, ignored);
  return 0;
}
