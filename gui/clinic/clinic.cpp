// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/clinic/clinic.hpp"

#include <algorithm>

#include "gui/clinic/patient_code.hpp"
#include "gui/words/texts.hpp"
#include "reports/findings/renewed.hpp"
#include "storage/access/open_store.hpp"

namespace isograsp::gui {

namespace {

QString words(const Error& error) {
  return translated(error);
}

Result<std::vector<HistorySeries>> read_history(storage::SessionStore& store,
                                                const std::string& code) {
  const auto patient = store.find_patient(code);
  if (!patient) return patient.error();
  if (!patient->has_value()) return std::vector<HistorySeries>{};
  const auto points = reports::renewed_progress(store, (*patient)->id);
  if (!points) return points.error();
  return sort_history(*points);
}

}  // namespace

Clinic::Clinic(std::string database, QObject* parent)
    : QObject(parent),
      database_(std::move(database)),
      entropy_(std::random_device{}()),
      store_(std::make_shared<std::unique_ptr<storage::SessionStore>>()),
      report_(store_, worker_),
      export_(database_) {}

Clinic::~Clinic() {
  report_.cancel();  // before the worker is waited for
}

void Clinic::open(bool to_read) {
  using Opened = Result<std::vector<storage::PatientRecord>>;
  worker_.run(
      [store = store_, path = database_,
       how = to_read ? storage::OpenMode::read_only : storage::OpenMode::create]() -> Opened {
        auto opened = storage::open_store(path, how);
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

void Clinic::when_done(std::function<void()> then) {
  worker_.run([] { return true; }, [then = std::move(then)](bool) { then(); });
}

void Clinic::add_patient() {
  if (!open_) return;
  using Added = Result<storage::PatientRecord>;
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

void Clinic::remove_patient(const std::string& code) {
  const auto patient = std::find_if(patients_.begin(), patients_.end(),
                                    [&](const auto& one) { return one.code == code; });
  if (!open_ || patient == patients_.end()) return;
  worker_.run([store = store_, id = patient->id] { return (*store)->remove_patient(id); },
              [this, code](const Result<void>& removed) {
                if (!removed) return Q_EMIT failed(words(removed.error()));
                std::erase_if(patients_, [&](const auto& one) { return one.code == code; });
                Q_EMIT patients_changed();
              });
}

void Clinic::load_history(const std::string& code) {
  if (!open_) return;
  if (code != history_of_) {
    history_of_ = code;
    history_.clear();
    Q_EMIT history_changed();
  }
  if (code.empty()) return;
  ++loads_under_way_;
  using Loaded = Result<std::vector<HistorySeries>>;
  worker_.run([store = store_, code]() -> Loaded { return read_history(**store, code); },
              [this, code](Loaded outcome) {
                --loads_under_way_;
                if (!outcome) {
                  Q_EMIT failed(words(outcome.error()));
                } else if (code == history_of_) {
                  history_ = *std::move(outcome);
                }
                Q_EMIT history_changed();
              });
}

}  // namespace isograsp::gui
