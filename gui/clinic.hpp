// SPDX-License-Identifier: GPL-3.0-or-later
// The database as the windows use it: every call returns at once, the answer comes as a signal.
// GUI thread.
#pragma once

#include <QObject>
#include <QString>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "gui/background.hpp"
#include "storage/session_store.hpp"

namespace isograsp {

class Clinic final : public QObject {
  Q_OBJECT

 public:
  explicit Clinic(std::string database, QObject* parent = nullptr);
  ~Clinic() override;

  void open();         ///< -> opened(), patients_changed() or open_failed()
  void add_patient();  ///< with a generated code -> patients_changed(), patient_added()
  void load_history(const std::string& code);  ///< -> history_loaded()
  /// Gathers on the worker; the pages are painted here, in some 20 ms each, as plots must be
  /// painted on the GUI thread -> report_written() or report_failed().
  void write_report(const std::string& code, const std::string& path);

  [[nodiscard]] bool is_open() const noexcept { return open_; }
  [[nodiscard]] const std::string& database() const noexcept { return database_; }
  [[nodiscard]] const std::vector<PatientRecord>& patients() const noexcept { return patients_; }
  /// Of the patient named by the last history_loaded().
  [[nodiscard]] const std::vector<MeasurePoint>& history() const noexcept { return history_; }

 Q_SIGNALS:
  void opened();
  void open_failed(const QString& why);
  void patients_changed();
  void patient_added(const QString& code);
  void history_loaded(const QString& code);
  void report_written(const QString& path);
  void report_failed(const QString& why);
  void failed(const QString& why);

 private:
  std::string database_;
  bool open_ = false;
  std::vector<PatientRecord> patients_;
  std::vector<MeasurePoint> history_;
  std::mt19937_64 entropy_;
  std::shared_ptr<std::unique_ptr<SessionStore>> store_;  ///< used by the worker only
  Background worker_;
};

}  // namespace isograsp
