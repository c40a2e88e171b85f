// SPDX-License-Identifier: GPL-3.0-or-later
// isograsp report: the progress of one patient as PDF or HTML.
#include "app/report.hpp"

#include <memory>

#include <CLI/CLI.hpp>

#include "app/commands.hpp"
#include "reports/html_writer.hpp"
#include "reports/pdf_writer.hpp"
#include "reports/progress_report.hpp"
#include "reports/qt_application.hpp"
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
  const auto content = gather_progress(**store, patient);
  if (!content) return content.error();
  ensure_qt_application();
  return as_pdf ? write_pdf(*content, path) : write_html(*content, path);
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
