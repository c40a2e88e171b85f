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
#include "gui/history.hpp"
#include "gui/report_work.hpp"
#include "storage/session_store.hpp"

namespace isograsp {

class Clinic final : public QObject {
  Q_OBJECT

 public:
  explicit Clinic(std::string database, QObject* parent = nullptr);
  ~Clinic() override;  ///< cancels a report; waits for the worker

  void open();         ///< -> opened(), patients_changed() or open_failed()
  void add_patient();  ///< with a generated code -> patients_changed(), patient_added()
  /// Until the answer comes, the history of another patient is empty and that of the same one is
  /// as it was -> history_changed(), twice for another patient.
  void load_history(const std::string& code);
  /// `answer(question(store))`: asked on the worker, answered here. Not before it is open.
  template <class Question, class Answer>
  void ask(Question question, Answer answer) {
    worker_.run([store = store_, question = std::move(question)] { return question(**store); },
                std::move(answer));
  }
  [[nodiscard]] ReportWork& report() noexcept { return report_; }

  [[nodiscard]] bool is_open() const noexcept { return open_; }
  [[nodiscard]] const std::string& database() const noexcept { return database_; }
  [[nodiscard]] const std::vector<PatientRecord>& patients() const noexcept { return patients_; }
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
  std::vector<PatientRecord> patients_;
  std::string history_of_;  ///< code
  std::vector<HistorySeries> history_;
  int loads_under_way_ = 0;
  std::mt19937_64 entropy_;
  std::shared_ptr<std::unique_ptr<SessionStore>> store_;  ///< used by the worker only
  ReportWork report_;
  Background worker_;  ///< last: its jobs end before anything else goes away
};

}  // namespace isograsp
