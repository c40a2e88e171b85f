// SPDX-License-Identifier: GPL-3.0-or-later
// Prints the figures of docs/storage.md: what recording and reading cost, how large the file gets,
// and what becomes of it when bits are flipped. 60 columns in four groups at 100 Hz, quantised as
// sensors do it; trials of five minutes. bench_storage [FOLDER]: where the file stands (a real
// disk).
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "storage/access/open_store.hpp"
#include "storage/file/file_stats.hpp"
#include "storage/records/session_store.hpp"
#include "tests/support/must.hpp"

namespace isograsp {

namespace {

using test::must;
constexpr int kSeconds = 300;
constexpr int kRate_Hz = 100;
constexpr int kTrials = 4;
constexpr std::size_t kColumns = 15;  // of each of the four groups

double wall_ms() {
  using namespace std::chrono;
  return duration<double, std::milli>(steady_clock::now().time_since_epoch()).count();
}
double processor_ms() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

struct Times {
  std::vector<double> wall;
  std::vector<double> processor;

  void of(const std::function<void()>& work) {
    const double before = wall_ms();
    const double own = processor_ms();
    work();
    processor.push_back(processor_ms() - own);
    wall.push_back(wall_ms() - before);
  }
  static double quantile(std::vector<double> all, double share) {
    std::sort(all.begin(), all.end());
    return all[static_cast<std::size_t>(share * static_cast<double>(all.size() - 1))];
  }
  void print(const char* what) const {
    std::printf("| %s | %.2f / %.2f / %.2f | %.2f |\n", what, quantile(wall, 0.5),
                quantile(wall, 0.99), quantile(wall, 1.0), quantile(processor, 0.5));
  }
};

/// Forces that wander, their counts, slow positions, and what the task says.
class Source {
 public:
  std::vector<std::vector<double>> second(int second) {
    std::vector<std::vector<double>> groups(4);
    for (int r = 0; r < kRate_Hz; ++r) {
      const double t_s = second + static_cast<double>(r) / kRate_Hz;
      for (std::size_t c = 0; c < kColumns; ++c) {
        drift_[c] = 0.98 * drift_[c] + 0.05 * normal_(random_);
        const double place = static_cast<double>(c);
        const double force_N = 5.0 + 3.0 * std::sin(t_s + place) + drift_[c];
        constexpr double kStep_N = 0.001;
        const double counts = std::round(force_N / kStep_N);
        groups[0].push_back(counts * kStep_N - 1.2345678 * place);  // after zero
        groups[1].push_back(counts);
        groups[2].push_back(0.05 * std::sin(0.1 * (place + 1.0) * t_s) + 1e-3 * drift_[c]);
        groups[3].push_back(c < 8 ? std::floor(t_s / 10.0) : c < 12 ? t_s : 1e-4 * drift_[c]);
      }
    }
    return groups;
  }

 private:
  std::mt19937_64 random_{7};
  std::normal_distribution<double> normal_;
  std::vector<double> drift_ = std::vector<double>(kColumns, 0.0);
};

storage::TrialRecord described(storage::RowId session, int number) {
  storage::TrialRecord trial;
  trial.session_id = session;
  trial.number = number;
  trial.task_name = "bench";
  for (const char* name : {"force", "raw", "object", "task"}) {
    storage::SignalGroup group{name, {}};
    for (std::size_t c = 0; c < kColumns; ++c) group.columns.push_back(name + std::to_string(c));
    trial.groups.push_back(group);
  }
  return trial;
}

void record(const std::string& path) {
  Times seconds;
  Times close;
  const auto store = must(storage::open_store(path, storage::OpenMode::create));
  storage::SessionRecord session;
  session.patient_id = must(store->add_patient("BENCH-1")).id;
  session.rate_Hz = kRate_Hz;
  const storage::RowId id = must(store->begin_session(session));
  Source source;
  for (int number = 1; number <= kTrials; ++number) {
    storage::TrialRecord trial = described(id, number);
    trial.id = must(store->begin_trial(trial));
    for (int second = 0; second < kSeconds; ++second) {
      const auto rows = source.second(second);
      seconds.of([&] { must(store->append_blocks(trial.id, second, rows)); });
    }
    trial.status = storage::TrialStatus::completed;
    close.of([&] { must(store->end_trial(trial, {})); });
  }
  seconds.print("storing one second (four blocks, one synced transaction)");
  close.print("closing a five-minute trial, with packing");
}

void read(const std::string& path) {
  const auto store = must(storage::open_store(path, storage::OpenMode::read_only));
  Times opening;
  constexpr int kRounds = 20;
  const auto trials = must(store->trials(1));
  for (int round = 0; round < kRounds; ++round)
    for (const storage::TrialRecord& trial : trials)
      opening.of([&] { must(store->signals(trial)); });
  opening.print("opening a five-minute trial, every hash checked");
}

void query(const std::string& path) {
  {
    const auto store = must(storage::open_store(path, storage::OpenMode::scratch));
    const storage::RowId patient = must(store->add_patient("BENCH-1")).id;
    constexpr int kSessions = 200;
    constexpr int kMeasures = 20;
    for (int s = 0; s < kSessions; ++s) {
      storage::SessionRecord session;
      session.patient_id = patient;
      const storage::RowId id = must(store->begin_session(session));
      storage::TrialRecord trial = described(id, 1);
      trial.id = must(store->begin_trial(trial));
      trial.status = storage::TrialStatus::completed;
      std::vector<Measure> measures(kMeasures);
      for (std::size_t m = 0; m < measures.size(); ++m) {
        measures[m].name = "measure" + std::to_string(m);
        measures[m].value = 0.1 * static_cast<double>(m + 1);
      }
      must(store->end_trial(trial, measures));
    }
  }
  const auto store = must(storage::open_store(path, storage::OpenMode::read_only));
  Times asking;
  for (int round = 0; round < 50; ++round) asking.of([&] { must(store->progress(1)); });
  asking.print("progress of 200 sessions, 4,000 measures");
}

/// One bit of the file after the other, chosen by chance.
void flip_bits(const std::string& path, const std::string& copy) {
  std::ifstream in(path, std::ios::binary);
  const std::string whole(std::istreambuf_iterator<char>(in), {});
  const auto store = must(storage::open_store(path, storage::OpenMode::read_only));
  std::vector<Signals> sound;
  for (const auto& trial : must(store->trials(1))) sound.push_back(must(store->signals(trial)));
  constexpr int kFlips = 200;
  std::mt19937_64 random(20260303);
  int refused = 0;
  int others_read = 0;
  int harmless = 0;
  int other_values = 0;
  std::filesystem::copy_file(path, copy);
  for (int flip = 0; flip < kFlips; ++flip) {
    const auto bit = random() % (8 * whole.size());
    const auto put = [&](char byte) {
      std::fstream file(copy, std::ios::in | std::ios::out | std::ios::binary);
      file.seekp(static_cast<std::streamoff>(bit / 8));
      file.put(byte);
    };
    put(static_cast<char>(whole[bit / 8] ^ (1 << (bit % 8))));
    int broken = 0;
    bool same = true;
    const auto damaged = storage::open_store(copy, storage::OpenMode::read_only);
    const auto trials = damaged ? (*damaged)->trials(1)
                                : Result<std::vector<storage::TrialRecord>>(damaged.error());
    if (trials)
      for (std::size_t t = 0; t < sound.size(); ++t) {
        const auto signals = t < trials->size()
                                 ? (*damaged)->signals((*trials)[t])
                                 : Result<Signals>(failed("the trial is missing"_text, {}));
        if (!signals)
          ++broken;
        else
          for (std::size_t c = 0; c < signals->names().size(); ++c)
            same = same && std::ranges::equal(signals->column(c), sound[t].column(c));
      }
    put(whole[bit / 8]);
    if (!same) ++other_values;
    if (!trials || broken > 0)
      ++refused;
    else
      ++harmless;
    if (trials && broken == 1) ++others_read;
  }
  std::printf("\n| flips of one bit anywhere in the file | %d |\n|---|---|\n", kFlips);
  std::printf("| noticed on reading, with their place | %d |\n", refused);
  std::printf("| of these: all other trials still read | %d |\n", others_read);
  std::printf("| in free space or where no signal is | %d |\n", harmless);
  std::printf("| gave other values | %d |\n", other_values);
}

void run(const std::string& folder) {
  const std::string path = folder + "/bench.db";
  std::printf("| what | wall: median / 99 %% / longest [ms] | processor [ms] |\n|---|---|---|\n");
  record(path);
  read(path);
  query(folder + "/progress.db");
  const auto stats = must(storage::file_stats(path));
  std::printf("\n| per minute of trial | |\n|---|---|\n");
  std::printf("| signals | %.2f MB |\n",
              60e-6 * static_cast<double>(stats.signal_bytes) / stats.recorded_s);
  std::printf("| whole file without free space | %.2f MB |\n", 1e-6 * stats.bytes_per_minute());
  std::printf("| the same as float64 | %.2f MB |\n",
              60e-6 * 8.0 * static_cast<double>(stats.values) / stats.recorded_s);
  flip_bits(path, folder + "/flipped.db");
}

}  // namespace

}  // namespace isograsp

int main(int argc, char** argv) {
  std::setvbuf(stdout, nullptr, _IOLBF, 0);
  std::string folder = (std::filesystem::path(argc > 1 ? argv[1] : ".") / "bench-XXXXXX").string();
  if (mkdtemp(folder.data()) == nullptr) return 1;
  int status = 0;
  try {
    isograsp::run(folder);
  } catch (const std::exception& why) {
    std::fprintf(stderr, "bench_storage: %s\n", why.what());
    status = 1;
  }
  std::error_code ignored;
  std::filesystem::remove_all(folder, ignored);
  return status;
}
