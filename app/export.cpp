// SPDX-License-Identifier: GPL-3.0-or-later
// isograsp export: trials as files for research (exports/research_export.hpp).
#include <cstdio>
#include <cstdlib>
#include <memory>

#include <nlohmann/json.hpp>

#include "app/commands.hpp"
#include "app/console.hpp"
#include "app/language.hpp"
#include "app/login_options.hpp"
#include "exports/research_export.hpp"
#include "storage/access/audit_log.hpp"
#include "storage/access/open_store.hpp"
#include "storage/access/signing.hpp"

namespace isograsp::app {

namespace {

struct ExportOptions {
  std::string database;
  std::string patient;
  int session = 0;  ///< 0: all
  std::string format = "csv";
  std::string out;
  bool json = false;
  LoginOptions login;
};

Result<void> run_export(const ExportOptions& options) {
  const auto format = exports::export_format_from_name(options.format);
  if (!format)
    return refused("'%1' is not an export format"_text(options.format),
                   "available are: csv, hdf5, bids, fhir"_text)
        .about("--format");
  if (options.out.empty())
    return refused("no folder is given"_text, "name one"_text).about("--out");
  const auto access = log_in(options.database, options.login);
  if (!access) return access.error();
  const auto store = storage::open_store_to_read(options.database);
  if (!store) return store.error();
  exports::ExportRequest request{options.patient};
  if (options.session != 0) {
    request.first_session = options.session;
    request.last_session = options.session;
  }
  const auto left_out = exports::count_not_released(**store, request);
  if (!left_out) return left_out.error();
  ProgressBar bar("Exporting"_text);
  const auto written = exports::write_export(
      **store, request, *format, options.out,
      [&](double done, const Text& code) {
        bar.show(done, code);
        return true;
      },
      spoken());
  const auto logged = storage::log_act_of(options.database, access->get(), "export",
                                          options.patient, written.ok(), options.format);
  if (!written) return written.error();
  if (!logged) return logged.error();
  Lines text = *written == 1 ? "1 trial written to %1"_text(options.out)
                             : "%1 trials written to %2"_text(*written, options.out);
  if (*left_out == 1)
    text.add("left out: 1 patient who is not released for research"_text);
  else if (*left_out > 1)
    text.add("left out: %1 patients who are not released for research"_text(*left_out));
  const auto key = storage::public_key_of(options.database);
  const bool is_signed = key && !key->empty();
  if (is_signed)
    text.add("signed with the key %1"_text(*key));
  else
    text.add("not signed: no key could be made beside the database"_text);
  const nlohmann::ordered_json json{{"out", options.out},
                                    {"trials", *written},
                                    {"patients_not_released", *left_out},
                                    {"key", is_signed ? *key : std::string()}};
  if (options.json)
    print_json(json);
  else
    print_lines(text);
  return {};
}

}  // namespace

void add_export(CommandLine& line) {
  auto options = std::make_shared<ExportOptions>();
  Subcommand command = line.subcommand("export", "Research export: pseudonymous, no dates");
  command.option("--db", options->database, "Database file").required();
  command.option("--patient", options->patient, "Patient code; without it all patients");
  command.option("--session", options->session, "Session number of the patient, from 1")
      .check([](const std::string& text) {
        return std::atoi(text.c_str()) >= 1 ? "" : "'" + text + "' is no whole number from 1";
      });
  command.option("--format", options->format, "csv, hdf5, bids or fhir").shows_default();
  command.option("--out", options->out, "Folder; made if it does not exist").required();
  command.flag("--json", options->json, "Print one JSON document");
  options->login.add_to(command);
  command.footer(
      "Example:\n  isograsp export --db clinic.db --patient P-0427 --format csv --out study");
  command.runs([options] { return run_export(*options); });
}

}  // namespace isograsp::app
