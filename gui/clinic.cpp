// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/clinic.hpp"

#include "gui/patient_code.hpp"
#include "reports/html_writer.hpp"
#include "reports/pdf_writer.hpp"
#include "reports/progress_report.hpp"

namespace isograsp {

namespace {

QString words(const Error& error) {
  return QString::fromStdString(error.message());
}

Result<std::vector<MeasurePoint>> read_history(SessionStore& store, const std::string& code) {
  auto patient = store.find_patient(code);
  if (!patient) return patient.error();
  if (!patient->has_value()) return std::vector<MeasurePoint>{};
  return store.progress((*patient)->id);
}

}  // namespace

Clinic::Clinic(std::string database, QObject* parent)
    : QObject(parent),
      database_(std::move(database)),
      entropy_(std::random_device{}()),
      store_(std::make_shared<std::unique_ptr<SessionStore>>()) {}

Clinic::~Clinic() = default;

void Clinic::open() {
  using Opened = Result<std::vector<PatientRecord>>;
  worker_.run(
      [store = store_, path = database_]() -> Opened {
        auto opened = SessionStore::open(path, SessionStore::Open::create);
        if (!opened) return opened.error();
        *store = *std::move(opened);
        return (*store)->patients();
      },
      [this](Opened outcome) {
        if (!outcome) {
          Q_EMIT open_failed(words(outcome.error()));
          return;
        }
        open_ = true;
        patients_ = *std::move(outcome);
        Q_EMIT opened();
        Q_EMIT patients_changed();
      });
}

void Clinic::add_patient() {
  if (!open_) return;
  using Added = Result<PatientRecord>;
  worker_.run(
      [store = store_, code = generate_patient_code(patients_, entropy_)]() -> Added {
        return (*store)->add_patient(code);
      },
      [this](Added outcome) {
        if (!outcome) {
          Q_EMIT failed(words(outcome.error()));
          return;
        }
        patients_.push_back(*outcome);
        Q_EMIT patients_changed();
        Q_EMIT patient_added(QString::fromStdString(outcome->code));
      });
}

void Clinic::load_history(const std::string& code) {
  if (!open_) return;
  using Loaded = Result<std::vector<MeasurePoint>>;
  worker_.run([store = store_, code]() -> Loaded { return read_history(**store, code); },
              [this, code](Loaded outcome) {
                if (!outcome) {
                  Q_EMIT failed(words(outcome.error()));
                  return;
                }
                history_ = *std::move(outcome);
                Q_EMIT history_loaded(QString::fromStdString(code));
              });
}

void Clinic::write_report(const std::string& code, const std::string& path) {
  if (!open_) return;
  using Gathered = Result<ReportContent>;
  worker_.run([store = store_, code]() -> Gathered { return gather_progress(**store, code); },
              [this, path](const Gathered& content) {
                if (!content) {
                  Q_EMIT report_failed(words(content.error()));
                  return;
                }
                const bool page = path.ends_with(".html");
                const auto written = page ? write_html(*content, path) : write_pdf(*content, path);
                if (written)
                  Q_EMIT report_written(QString::fromStdString(path));
                else
                  Q_EMIT report_failed(words(written.error()));
              });
}

}  // namespace isograsp
