// SPDX-License-Identifier: GPL-3.0-or-later
// What is known of a person beside the sessions: every change is stored, then read again. Every
// call returns at once; the answer is changed(), or failed(): then nothing of it is stored. Before
// the database is open, calls are ignored. GUI thread.
#pragma once

#include <QObject>
#include <QString>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "gui/clinic/clinic.hpp"
#include "storage/records/session_store.hpp"

namespace isograsp::gui {

struct PersonRecords {
  storage::PatientProfile profile;
  std::vector<storage::TreatmentMark> marks;   ///< by date
  std::vector<storage::ClinicalScore> scores;  ///< by date
  std::vector<storage::PrimaryMeasure> primaries;
  std::vector<storage::StablePeriod> stable;  ///< by date
};

class PersonFile final : public QObject {
  Q_OBJECT

 public:
  /// The clinic must outlive it.
  explicit PersonFile(Clinic& clinic, QObject* parent = nullptr)
      : QObject(parent), clinic_(clinic) {}

  /// Until the answer comes, the records of another patient are absent. No code: of nobody.
  void load(const std::string& code);
  /// Forgets what was read: it was decrypted for a user who is no longer logged in -> changed().
  void forget();
  /// Called before the signals; tells whether the change is stored.
  using Stored = std::function<void(bool)>;
  void save(const std::string& code, const storage::PatientProfile& profile, Stored then = {});
  /// A function of the store that adds such an entry of a patient, or takes one away.
  template <class Entry>
  using Add = Result<storage::RowId> (storage::SessionStore::*)(storage::RowId patient,
                                                                const Entry&);
  using Remove = Result<void> (storage::SessionStore::*)(storage::RowId entry);
  template <class Entry>
  void add(const std::string& code, Add<Entry> how, const Entry& entry, Stored then = {}) {
    change(
        code,
        [how, entry](storage::SessionStore& store, storage::RowId patient) {
          const auto added = (store.*how)(patient, entry);
          return added ? Result<void>{} : Result<void>{added.error()};
        },
        std::move(then));
  }
  void remove(const std::string& code, Remove how, storage::RowId entry, Stored then = {});

  /// Whose records were loaded last.
  [[nodiscard]] const std::string& code() const noexcept { return code_; }
  /// Nothing: not read yet.
  [[nodiscard]] const std::optional<PersonRecords>& records() const noexcept { return records_; }

 Q_SIGNALS:
  void changed();
  /// Of the patient of that code: not read or not stored.
  void failed(const QString& code, const QString& why);

 private:
  using Change = std::function<Result<void>(storage::SessionStore&, storage::RowId patient)>;
  void change(const std::string& code, Change change, Stored then);

  Clinic& clinic_;
  std::string code_;
  std::optional<PersonRecords> records_;
};

}  // namespace isograsp::gui
