// SPDX-License-Identifier: GPL-3.0-or-later
// isograsp study: a group report of the clinic's patients (docs/statistics.md).
#include <cstdio>
#include <memory>

#include "app/commands.hpp"
#include "app/console.hpp"
#include "app/language.hpp"
#include "app/login_options.hpp"
#include "core/files.hpp"
#include "reports/paper/qt_application.hpp"
#include "reports/study/study_report.hpp"
#include "reports/study/study_writer.hpp"
#include "storage/access/audit_log.hpp"
#include "storage/access/open_store.hpp"
#include "storage/records/session_store.hpp"

namespace isograsp::app {

namespace {

struct StudyOptions {
  std::string database;
  std::string study;
  std::string out;
  bool json = false;
  LoginOptions login;
};

Result<void> check_out(const StudyOptions& options) {
  if (options.out.empty() && !options.json)
    return refused("nothing is asked for"_text, "give --out or --json"_text).about("--out");
  for (const char* ending : {".html", ".pdf", ".csv"})
    if (options.out.empty() || options.out.ends_with(ending)) return {};
  return refused("group reports are HTML, PDF or CSV files"_text,
                 "let the name end in .html, .pdf or .csv"_text)
      .at(options.out)
      .about("--out");
}

Result<void> write_study(const StudyOptions& options, const reports::Study& study) {
  const auto store = storage::open_store_to_read(options.database);
  if (!store) return store.error();
  ProgressBar bar("Study"_text);
  const auto data = reports::gather_study(**store, study, options.study,
                                          [&bar](double done, const Text& subject) {
                                            bar.show(done, subject);
                                            return true;
                                          });
  if (!data) return data.error();
  std::vector<reports::GroupAnalysis> analyses;
  for (const auto& group : data->groups) analyses.push_back(reports::analyse(study, group));
  if (options.out.ends_with(".csv")) {
    if (auto done = write_text(options.out, reports::study_csv(study, *data)); !done) return done;
  } else if (!options.out.empty()) {
    reports::ensure_qt_application();
    const auto report = reports::study_report(study, *data, analyses, spoken());
    const auto page =
        options.out.ends_with(".html") ? reports::study_html(report) : reports::study_pdf(report);
    if (auto done = write_text(options.out, page); !done) return done;
  }
  bar.show(1.0);
  if (options.json) print("%s", reports::study_json(study, *data, analyses).c_str());
  return {};
}

Result<void> run_study(const StudyOptions& options) {
  if (auto done = check_out(options); !done) return done;
  const auto text = read_text(options.study);
  if (!text) return text.error();
  const auto study = reports::parse_study(*text, options.study);
  if (!study) return study.error();
  if (auto done = check_different(options.study, options.out); !done) return done;
  if (auto done = check_different(options.database, options.out); !done) return done;
  const auto access = log_in(options.database, options.login);
  if (!access) return access.error();
  auto done = write_study(options, *study);
  auto logged = storage::log_act_of(options.database, access->get(), "study", "", done.ok(), "");
  return done ? logged : done;
}

}  // namespace

void add_study(CommandLine& line) {
  auto options = std::make_shared<StudyOptions>();
  Subcommand command = line.subcommand(
      "study", "Group report: conditions of a study compared within people, pseudonymous");
  command.option("--db", options->database, "Database of the clinic").required().type("FILE");
  command
      .option("--study", options->study,
              "What is compared: groups, factors, measure, analyses (isograsp-study-1)")
      .required()
      .type("FILE.toml");
  command
      .option("--out", options->out,
              "Report (FILE.html, FILE.pdf) or the values of all people (FILE.csv)")
      .type("FILE");
  command.flag("--json", options->json, "Print every figure as one JSON document");
  options->login.add_to(command);
  command.footer("Example:\n  isograsp study --db clinic.db --study weeks.toml --out weeks.pdf");
  command.runs([options] { return run_study(*options); });
}

}  // namespace isograsp::app
