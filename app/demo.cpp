// SPDX-License-Identifier: GPL-3.0-or-later
// isograsp demo: everything from force to report on simulated patients, in a database of its own.
#include <algorithm>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <memory>
#include <thread>

#include "app/clinic.hpp"
#include "app/commands.hpp"
#include "app/console.hpp"
#include "app/paths.hpp"
#include "app/report.hpp"
#include "app/run.hpp"
#include "core/time.hpp"

namespace isograsp::app {

namespace {

namespace fs = std::filesystem;

constexpr const char* kFirstPatient = "DEMO-01";

std::string now_utc() {
  return utc_text(std::time(nullptr));
}
int all_threads() {
  return static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
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

Result<std::string> make_clinic_named(const std::string& name, const std::string& at_utc) {
  const std::string database = fresh_database(name);
  if (auto made = make_clinic(database, small_clinic(at_utc), all_threads()); !made)
    return made.error();
  return database;
}

}  // namespace

Result<std::string> make_small_clinic() {
  return make_clinic_named("demonstration.db", now_utc());
}

namespace {

/// Makes a clinic, and in it today's session of a patient who has come for two months.
Result<void> headless() {
  const std::string now = now_utc();
  const auto database = make_clinic_named("demonstration-session.db", now);
  if (!database) return database.error();
  RunOptions options = options_of(demo_visit_of_today(now), kFirstPatient);
  options.database = *database;
  if (auto done = run_session(options); !done) return done;
  const std::string pdf = fs::path(*database).replace_extension(".pdf");
  if (auto done = write_report(*database, options.patient, pdf); !done) return done;
  print("\n");
  print_line("Database: %1"_text(*database));
  print_line("Report:   %1"_text(pdf));
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
  std::string at_utc;
  bool small = false;
  int threads = all_threads();
};

Result<void> run_demo(const DemoOptions& options) {
  if (!options.at_utc.empty() && !time_of_utc(options.at_utc))
    return refused("'%1' is no time"_text(options.at_utc), "write it as 2026-03-05T09:30:00Z"_text)
        .about("--at");
  const std::string at = options.at_utc.empty() ? now_utc() : options.at_utc;
  if (!options.clinic.empty())
    return make_clinic(options.clinic, options.small ? small_clinic(at) : large_clinic(at),
                       options.threads);
  return options.headless ? headless() : with_window();
}

}  // namespace

void add_demo(CommandLine& line) {
  auto options = std::make_shared<DemoOptions>();
  Subcommand command = line.subcommand(
      "demo", "The application on a demonstration clinic, or one whole session without a window");
  command.flag("--headless", options->headless,
               "One complete simulated session, its scores and its report");
  command.option("--clinic", options->clinic,
                 "Make a clinic in this new file: four simulated patients, 12 with 20 "
                 "training sessions each, stable and healthy people");
  command.flag("--small", options->small,
               "For --clinic: without those in training, as the window opens it");
  command
      .option("--at", options->at_utc,
              "For --clinic: when it stands, as 2026-03-05T09:30:00Z (default: now); the same "
              "time gives the same file")
      .type("UTC");
  command.option("--threads", options->threads, "For --clinic; the result is the same")
      .range(1, 64)
      .shows_default();
  command.footer("Examples:\n  isograsp demo --headless\n  isograsp demo --clinic clinic.db");
  command.runs([options] { return run_demo(*options); });
}

}  // namespace isograsp::app
