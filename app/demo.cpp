// SPDX-License-Identifier: GPL-3.0-or-later
// isograsp demo: the whole way on simulated patients, in a database of its own.
#include <algorithm>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <memory>
#include <thread>

#include <CLI/CLI.hpp>

#include "app/clinic.hpp"
#include "app/commands.hpp"
#include "app/console.hpp"
#include "app/paths.hpp"
#include "app/report.hpp"
#include "app/run.hpp"
#include "core/time.hpp"

namespace isograsp {

namespace {

namespace fs = std::filesystem;

constexpr int kPatients = 3;
constexpr int kSessions = 4;
constexpr int kDaysBetween = 7;

std::string utc_days_ago(int days) {
  constexpr std::time_t kSecondsPerDay = 86400;
  return utc_text(std::time(nullptr) - days * kSecondsPerDay);
}

/// A new, empty file under the folder of the default database; an older demonstration is replaced.
std::string fresh_database(const std::string& name) {
  const fs::path path = fs::path(default_database()).parent_path() / name;
  for (const char* suffix : {"", "-wal", "-shm", "-lock"}) {
    std::error_code ignored;
    fs::remove(path.string() + suffix, ignored);
  }
  return path;
}

/// Patients who recover at different speeds: session s of patient p.
std::string device_of(int patient, int session) {
  const double recovery = (0.1 + 0.08 * patient) * (session + 1);
  return "sim://paretic?seed=" + std::to_string(100 * patient + session) +
         "&recovery=" + std::to_string(std::min(recovery, 1.0));
}

}  // namespace

Result<std::string> make_small_clinic() {
  RunOptions options;
  options.protocol_file = library_folder() + "/protocols/short.toml";
  options.database = fresh_database("demonstration.db");
  options.fast = true;
  options.quiet = true;
  ProgressBar bar("Making the demonstration clinic");
  int made = 0;
  for (int patient = 0; patient < kPatients; ++patient) {
    options.patient = "DEMO-0" + std::to_string(patient + 1);
    for (int session = 0; session < kSessions; ++session) {
      bar.show(static_cast<double>(made++) / (kPatients * kSessions), options.patient);
      options.device = device_of(patient, session);
      options.started_utc = utc_days_ago(kDaysBetween * (kSessions - session));
      if (auto done = run_session(options); !done) return done.error();
    }
  }
  return options.database;
}

namespace {

Result<void> headless() {
  RunOptions options;
  options.protocol_file = library_folder() + "/protocols/demonstration.toml";
  options.database = fresh_database("demonstration-session.db");
  options.patient = "DEMO-01";
  options.device = "sim://healthy?seed=7";
  options.fast = true;
  if (auto done = run_session(options); !done) return done;
  const std::string pdf = fs::path(options.database).replace_extension(".pdf");
  if (auto done = write_report(options.database, options.patient, pdf); !done) return done;
  std::printf("\nDatabase: %s\nReport:   %s\n", options.database.c_str(), pdf.c_str());
  return {};
}

Result<void> with_window() {
  const auto database = make_small_clinic();
  if (!database) return database.error();
  return run_gui(*database, "sim://healthy?seed=7");
}

struct DemoOptions {
  bool headless = false;
  std::string clinic;
  int threads = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
};

Result<void> run_demo(const DemoOptions& options) {
  if (!options.clinic.empty()) return make_clinic(options.clinic, options.threads);
  return options.headless ? headless() : with_window();
}

}  // namespace

void add_demo(CLI::App& app, Action& action) {
  auto options = std::make_shared<DemoOptions>();
  auto* command = app.add_subcommand(
      "demo", "The application on a demonstration clinic, or one whole session without a window");
  command->add_flag("--headless", options->headless,
                    "One complete simulated session, its scores and its report");
  command->add_option("--clinic", options->clinic,
                      "Make a clinic of 12 simulated patients with 20 training sessions each in "
                      "this new file");
  command->add_option("--threads", options->threads, "For --clinic; the result is the same")
      ->check(CLI::Range(1, 64))
      ->capture_default_str();
  command->footer("Examples:\n  isograsp demo --headless\n  isograsp demo --clinic clinic.db");
  command->callback([options, &action] { action = [options] { return run_demo(*options); }; });
}

}  // namespace isograsp
