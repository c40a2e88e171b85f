// SPDX-License-Identifier: GPL-3.0-or-later
// The database as the windows use it: every call returns at once, the answer comes as a signal.
// GUI thread.
#pragma once

#include <QObject>
#include <QPointer>
#include <QString>
#include <functional>
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "gui/clinic/background.hpp"
#include "gui/clinic/export_work.hpp"
#include "gui/clinic/history.hpp"
#include "gui/clinic/report_work.hpp"
#include "storage/records/session_store.hpp"

namespace isograsp::gui {

class Clinic final : public QObject {
  Q_OBJECT

 public:
  explicit Clinic(std::string database, QObject* parent = nullptr);
  ~Clinic() override;  ///< cancels a report and an export; waits for the worker

  /// -> opened(), patients_changed() or open_failed(). `to_read`: by somebody who may not write.
  /// A database that is open already is opened again, for the user who is logged in now.
  void open(bool to_read = false);
  /// When all that was asked for before is done.
  void when_done(std::function<void()> then);
  void add_patient();  ///< with a generated code -> patients_changed(), patient_added()
  /// Takes back somebody who was added by mistake, of whom nothing is stored -> patients_changed(),
  /// or failed().
  void remove_patient(const std::string& code);
  /// -> history_changed() when the answer comes. Until then the old history of the same patient
  /// stays; for another patient it is emptied at once (-> history_changed(), too).
  void load_history(const std::string& code);
  [[nodiscard]] ReportWork& report() noexcept { return report_; }
  [[nodiscard]] ExportWork& research_export() noexcept { return export_; }
  /// Files are being written that people wait for.
  [[nodiscard]] bool writing() const noexcept { return report_.running() || export_.running(); }
  /// Any other work on the database: `read(SessionStore&)` on the worker, in order with all the
  /// rest, then `done(result)` here, unless `reader` is gone by then. False: the database is not
  /// open.
  template <class Read, class Done>
  bool read(QObject* reader, Read read, Done done) {
    if (!open_) return false;
    worker_.run([store = store_, read = std::move(read)]() mutable { return read(**store); },
                [reader = QPointer<QObject>(reader), done = std::move(done)](auto outcome) mutable {
                  if (reader) done(std::move(outcome));
                });
    return true;
  }

  [[nodiscard]] bool is_open() const noexcept { return open_; }
  [[nodiscard]] const std::string& database() const noexcept { return database_; }
  [[nodiscard]] const std::vector<storage::PatientRecord>& patients() const noexcept {
    return patients_;
  }
  /// Of the patient whose history was asked for last.
  [[nodiscard]] const std::vector<HistorySeries>& history() const noexcept { return history_; }
  [[nodiscard]] bool history_loading() const noexcept { return loads_under_way_ > 0; }

 Q_SIGNALS:
  void opened();
  void open_failed(const QString& why);
  void patients_changed();
  void patient_added(const QString& code);
  void history_changed();
  void failed(const QString& why);

 private:
  std::string database_;
  bool open_ = false;
  std::vector<storage::PatientRecord> patients_;
  std::string history_of_;  ///< code
  std::vector<HistorySeries> history_;
  int loads_under_way_ = 0;
  std::mt19937_64 entropy_;
  std::shared_ptr<std::unique_ptr<storage::SessionStore>> store_;  ///< used by the worker only
  ReportWork report_;
  ExportWork export_;
  Background worker_;  ///< last: its jobs end before anything else goes away
};

}  // namespace isograsp::gui
