// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/clinic/person_file.hpp"

#include "gui/words/texts.hpp"

namespace isograsp::gui {

namespace {

Result<storage::RowId> patient_id(storage::SessionStore& store, const std::string& code) {
  const auto patient = store.find_patient(code);
  if (!patient) return patient.error();
  if (!*patient)
    return refused("there is no patient %1"_text(code), "choose one that is there"_text)
        .about("patient code");
  return (*patient)->id;
}

Result<PersonRecords> read_records(storage::SessionStore& store, storage::RowId patient) {
  auto profile = store.profile(patient);
  if (!profile) return profile.error();
  auto marks = store.treatment_marks(patient);
  if (!marks) return marks.error();
  auto scores = store.clinical_scores(patient);
  if (!scores) return scores.error();
  auto primaries = store.primary_measures(patient);
  if (!primaries) return primaries.error();
  auto stable = store.stable_periods(patient);
  if (!stable) return stable.error();
  return PersonRecords{*std::move(profile), *std::move(marks), *std::move(scores),
                       *std::move(primaries), *std::move(stable)};
}

}  // namespace

void PersonFile::load(const std::string& code) {
  if (!clinic_.is_open()) return;
  if (code != code_) {
    code_ = code;
    records_.reset();
    Q_EMIT changed();
  }
  if (code.empty()) return;
  change(code, [](storage::SessionStore&, storage::RowId) { return Result<void>{}; }, {});
}

void PersonFile::forget() {
  code_.clear();
  records_.reset();
  Q_EMIT changed();
}

void PersonFile::save(const std::string& code, const storage::PatientProfile& profile,
                      Stored then) {
  change(
      code,
      [profile](storage::SessionStore& store, storage::RowId patient) {
        return store.set_profile(patient, profile);
      },
      std::move(then));
}

void PersonFile::remove(const std::string& code, Remove how, storage::RowId entry, Stored then) {
  change(
      code,
      [how, entry](storage::SessionStore& store, storage::RowId) { return (store.*how)(entry); },
      std::move(then));
}

/// Does it on the worker and reads the records again.
void PersonFile::change(const std::string& code, Change change, Stored then) {
  struct Answer {
    bool stored;
    Result<PersonRecords> records;
  };
  clinic_.read(
      this,
      [code, change = std::move(change)](storage::SessionStore& store) -> Answer {
        const auto patient = patient_id(store, code);
        if (!patient) return {false, patient.error()};
        if (const auto done = change(store, *patient); !done) return {false, done.error()};
        return {true, read_records(store, *patient)};
      },
      [this, code, then = std::move(then)](Answer answer) {
        if (then) then(answer.stored);
        if (!answer.records) {
          Q_EMIT failed(QString::fromStdString(code), translated(answer.records.error()));
          return;
        }
        if (code != code_) return;  // somebody else is shown by now; it is stored
        records_ = *std::move(answer.records);
        Q_EMIT changed();
      });
}

}  // namespace isograsp::gui
