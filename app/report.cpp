// SPDX-License-Identifier: GPL-3.0-or-later
// isograsp report: the progress of one patient as PDF or HTML.
#include "app/report.hpp"

#include <memory>

#include <CLI/CLI.hpp>

#include "app/commands.hpp"
#include "app/console.hpp"
#include "reports/progress_report.hpp"
#include "reports/qt_application.hpp"
#include "reports/report_writer.hpp"
#include "storage/session_store.hpp"

namespace isograsp {

Result<void> write_report(const std::string& database, const std::string& patient,
                          const std::string& path) {
  const bool as_pdf = path.ends_with(".pdf");
  if (!as_pdf && !path.ends_with(".html"))
    return Error{Error::Code::bad_input,
                 "reports are PDF or HTML files",
                 "let the name end in .pdf or .html",
                 path,
                 0,
                 "--out"};
  auto store = SessionStore::open_to_read(database);
  if (!store) return store.error();
  ProgressBar bar("Report");
  constexpr double kGathered = 0.4;  // share of the time, roughly
  auto content = gather_progress(**store, patient, [&](double done, const std::string& words) {
    bar.show(kGathered * done, words);
    return true;
  });
  if (!content) return content.error();
  ensure_qt_application();
  const auto writer = make_report_writer(*std::move(content), path);
  auto written = write_all(*writer, path, [&](double done, const std::string& words) {
    bar.show(kGathered + (1.0 - kGathered) * done, words);
    return true;
  });
  if (written) bar.show(1.0);
  return written;
}

void add_report(CLI::App& app, Action& action) {
  struct Options {
    std::string database;
    std::string patient;
    std::string out;
  };
  auto options = std::make_shared<Options>();
  auto* command = app.add_subcommand("report", "Write the progress report of a patient");
  command->add_option("--db", options->database, "Database of the clinic")
      ->required()
      ->type_name("FILE");
  command->add_option("--patient", options->patient, "Code of the patient")
      ->required()
      ->type_name("CODE");
  command->add_option("--out", options->out, "Report to write: FILE.pdf or FILE.html")
      ->required()
      ->type_name("FILE");
  command->footer("Example:\n  isograsp report --db clinic.db --patient TK-104 --out TK-104.pdf");
  command->callback([options, &action] {
    action = [options] { return write_report(options->database, options->patient, options->out); };
  });
}

}  // namespace isograsp
