// SPDX-License-Identifier: GPL-3.0-or-later
// isograsp import: recordings that others made into the database, as patients and trials.
#include "session/import.hpp"

#include <cstdio>
#include <filesystem>
#include <memory>

#include <CLI/CLI.hpp>

#include "app/commands.hpp"
#include "app/console.hpp"
#include "app/paths.hpp"
#include "core/csv.hpp"

namespace isograsp {

namespace {

struct ImportOptions {
  std::string recording;
  std::string folder;
  std::string database;
};

/// A path, or the bare name of a recording file that comes with the program.
std::string recording_path(const std::string& name) {
  const auto shipped = std::filesystem::path(library_folder()) / "recordings" / (name + ".toml");
  std::error_code ignored;
  if (!std::filesystem::exists(name, ignored) && std::filesystem::exists(shipped, ignored))
    return shipped;
  return name;
}

Result<void> run_import(const ImportOptions& options) {
  const std::string path = recording_path(options.recording);
  const auto text = read_text(path);
  if (!text) return text.error();
  const auto spec = parse_recording(*text, path);
  if (!spec) return spec.error();
  // All of it is read before anything is written.
  const auto trials = read_recording(*spec, options.folder);
  if (!trials) return trials.error();
  const auto store = SessionStore::open(options.database, SessionStore::Open::create);
  if (!store) return store.error();
  ProgressBar bar("Import");
  const auto imported = store_recording(*spec, *trials, **store, ISOGRASP_VERSION, [&](int done) {
    bar.show(static_cast<double>(done) / static_cast<double>(trials->size()),
             (*trials)[static_cast<std::size_t>(done) - 1].patient_code);
  });
  bar.end();
  if (!imported) return imported.error();
  std::printf("%s: %d patients, %d sessions, %d trials, %lld samples\n", spec->name.c_str(),
              imported->patients, imported->sessions, imported->trials,
              static_cast<long long>(imported->samples));
  std::string codes;
  for (const RecordedTrial& trial : *trials)
    if (!codes.ends_with(trial.patient_code))
      codes += (codes.empty() ? "" : ", ") + trial.patient_code;
  std::printf("  %s\n", codes.c_str());
  for (const auto& line : provenance_of(*spec)) std::printf("  %s\n", line.c_str());
  return {};
}

}  // namespace

void add_import(CLI::App& app, Action& action) {
  auto options = std::make_shared<ImportOptions>();
  CLI::App* command =
      app.add_subcommand("import", "Recordings that others made, as patients and trials");
  command
      ->add_option("--recording", options->recording,
                   "Recording file (TOML), or the name of one in library/recordings")
      ->required();
  command->add_option("--from", options->folder, "Folder of the recording")->required();
  command->add_option("--db", options->database, "Database; made if it does not exist")->required();
  command->footer(
      "Example:\n  isograsp import --recording maximum_push --from recordings --db clinic.db");
  command->callback([options, &action] { action = [options] { return run_import(*options); }; });
}

}  // namespace isograsp
