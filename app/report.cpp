// SPDX-License-Identifier: GPL-3.0-or-later
// isograsp report: the progress of one patient as PDF or HTML.
#include "app/report.hpp"

#include <algorithm>
#include <memory>
#include <thread>

#include "app/commands.hpp"
#include "app/console.hpp"
#include "app/language.hpp"
#include "app/login_options.hpp"
#include "app/report_all.hpp"
#include "reports/findings/progress_report.hpp"
#include "reports/paper/qt_application.hpp"
#include "reports/paper/report_writer.hpp"
#include "storage/access/audit_log.hpp"
#include "storage/access/open_store.hpp"
#include "storage/records/session_store.hpp"

namespace isograsp::app {

Result<void> write_report(const std::string& database, const std::string& patient,
                          const std::string& path) {
  const bool as_pdf = path.ends_with(".pdf");
  if (!as_pdf && !path.ends_with(".html"))
    return refused("reports are PDF or HTML files"_text, "let the name end in .pdf or .html"_text)
        .at(path)
        .about("--out");
  auto store = storage::open_store_to_read(database);
  if (!store) return store.error();
  ProgressBar bar("Report"_text);
  constexpr double kGathered = 0.4;  // share of the time, roughly
  auto content = reports::gather_progress(**store, patient, [&](double done, const Text& words) {
    bar.show(kGathered * done, words);
    return true;
  });
  if (!content) return content.error();
  reports::ensure_qt_application();
  const auto writer = reports::make_report_writer(*std::move(content), path, spoken());
  auto written = reports::write_all(*writer, path, [&](double done, const Text& words) {
    bar.show(kGathered + (1.0 - kGathered) * done, words);
    return true;
  });
  if (written) bar.show(1.0);
  return written;
}

namespace {

struct Options {
  std::string database;
  std::string patient;
  bool all = false;
  std::string out;
  std::string format = "html";
  int threads = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  LoginOptions login;
};

Result<void> run(const Options& options) {
  auto access = log_in(options.database, options.login);
  if (!access) return access.error();
  Result<void> done;
  std::shared_ptr<const void> login;
  if (options.all) {
    // The writing processes share no connection, but they share the login.
    if (*access) login = (*access)->keep_login();
    access->reset();
    done = write_all_reports({options.database, options.out, options.format, options.threads});
  } else {
    done = write_report(options.database, options.patient, options.out);
  }
  const bool pdf = options.all ? options.format == "pdf" : options.out.ends_with(".pdf");
  auto logged = storage::log_act_of(options.database, access->get(), "report", options.patient,
                                    done.ok(), pdf ? "pdf" : "html");
  return done ? logged : done;
}

}  // namespace

void add_report(CommandLine& line) {
  auto options = std::make_shared<Options>();
  Subcommand command =
      line.subcommand("report", "Write the progress report of a patient, or of all");
  command.option("--db", options->database, "Database of the clinic").required().type("FILE");
  OptionGroup who = command.exactly_one("who");
  who.option("--patient", options->patient, "Code of the patient").type("CODE");
  const Option all = who.flag("--all", options->all, "One report for each patient");
  command
      .option("--out", options->out,
              "Report to write: FILE.pdf or FILE.html; with --all the folder")
      .required()
      .type("FILE");
  command.option("--format", options->format, "With --all: html or pdf")
      .one_of({"html", "pdf"})
      .needs(all)
      .shows_default();
  command.option("--threads", options->threads, "With --all: how many write at the same time")
      .range(1, 64)
      .needs(all)
      .shows_default();
  options->login.add_to(command);
  command.footer(
      "Examples:\n  isograsp report --db clinic.db --patient TK-104 --out TK-104.pdf\n"
      "  isograsp report --db clinic.db --all --out reports --format pdf");
  command.runs([options] { return run(*options); });
}

}  // namespace isograsp::app
