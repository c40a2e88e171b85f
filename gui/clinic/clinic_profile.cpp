// SPDX-License-Identifier: GPL-3.0-or-later
// What is known of a person, as the windows use it: every change is stored, then read again.
#include "gui/clinic/clinic.hpp"
#include "gui/words/texts.hpp"

namespace isograsp::gui {

namespace {

Result<storage::RowId> patient_id(storage::SessionStore& store, const std::string& code) {
  const auto patient = store.find_patient(code);
  if (!patient) return patient.error();
  if (!*patient)
    return refused("there is no patient " + code, "choose one that is there").about("patient code");
  return (*patient)->id;
}

Result<PersonRecords> read_file(storage::SessionStore& store, storage::RowId patient) {
  PersonRecords file;
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

Result<void> without_value(const Result<storage::RowId>& added) {
  return added ? Result<void>{} : Result<void>{added.error()};
}

}  // namespace

/// Runs `change(store, patient)` and reads the file again.
template <class Change>
void Clinic::change_file(const std::string& code, Change change, Stored then) {
  if (!open_) return;
  struct Answer {
    bool stored;
    Result<PersonRecords> file;
  };
  worker_.run(
      [store = store_, code, change = std::move(change)]() -> Answer {
        const auto patient = patient_id(**store, code);
        if (!patient) return {false, patient.error()};
        if (const auto done = change(**store, *patient); !done) return {false, done.error()};
        return {true, read_file(**store, *patient)};
      },
      [this, code, then = std::move(then)](Answer answer) {
        if (then) then(answer.stored);
        if (!answer.file) {
          const auto why = shown(answer.file.error());
          Q_EMIT profile_failed(QString::fromStdString(code), why);
          Q_EMIT failed(why);
          return;
        }
        if (code != file_of_) return;  // somebody else is shown by now; it is stored
        file_ = *std::move(answer.file);
        Q_EMIT profile_changed();
      });
}

void Clinic::load_profile(const std::string& code) {
  if (!open_) return;
  if (code != file_of_) {
    file_of_ = code;
    file_.reset();
    Q_EMIT profile_changed();
  }
  if (code.empty()) return;
  change_file(code, [](storage::SessionStore&, storage::RowId) { return Result<void>{}; }, {});
}

void Clinic::forget_profile() {
  file_of_.clear();
  file_.reset();
  Q_EMIT profile_changed();
}

void Clinic::save_profile(const std::string& code, const storage::PatientProfile& profile,
                          Stored then) {
  change_file(
      code,
      [profile](storage::SessionStore& store, storage::RowId patient) {
        return store.set_profile(patient, profile);
      },
      std::move(then));
}

void Clinic::add_treatment_mark(const std::string& code, const storage::TreatmentMark& mark,
                                Stored then) {
  change_file(
      code,
      [mark](storage::SessionStore& store, storage::RowId patient) {
        return without_value(store.add_treatment_mark(patient, mark));
      },
      std::move(then));
}

void Clinic::remove_treatment_mark(const std::string& code, storage::RowId id, Stored then) {
  change_file(
      code,
      [id](storage::SessionStore& store, storage::RowId) {
        return store.remove_treatment_mark(id);
      },
      std::move(then));
}

void Clinic::add_clinical_score(const std::string& code, const storage::ClinicalScore& score,
                                Stored then) {
  change_file(
      code,
      [score](storage::SessionStore& store, storage::RowId patient) {
        return without_value(store.add_clinical_score(patient, score));
      },
      std::move(then));
}

void Clinic::remove_clinical_score(const std::string& code, storage::RowId id, Stored then) {
  change_file(
      code,
      [id](storage::SessionStore& store, storage::RowId) {
        return store.remove_clinical_score(id);
      },
      std::move(then));
}

void Clinic::add_primary_measure(const std::string& code, const storage::PrimaryMeasure& primary,
                                 Stored then) {
  change_file(
      code,
      [primary](storage::SessionStore& store, storage::RowId patient) {
        return without_value(store.add_primary_measure(patient, primary));
      },
      std::move(then));
}

void Clinic::remove_primary_measure(const std::string& code, storage::RowId id, Stored then) {
  change_file(
      code,
      [id](storage::SessionStore& store, storage::RowId) {
        return store.remove_primary_measure(id);
      },
      std::move(then));
}

void Clinic::add_stable_period(const std::string& code, const storage::StablePeriod& period,
                               Stored then) {
  change_file(
      code,
      [period](storage::SessionStore& store, storage::RowId patient) {
        return without_value(store.add_stable_period(patient, period));
      },
      std::move(then));
}

void Clinic::remove_stable_period(const std::string& code, storage::RowId id, Stored then) {
  change_file(
      code,
      [id](storage::SessionStore& store, storage::RowId) { return store.remove_stable_period(id); },
      std::move(then));
}

}  // namespace isograsp::gui
