// SPDX-License-Identifier: GPL-3.0-or-later
// A research export in the background: its own worker and its own connection to the database, so
// that nothing waits for it. One at a time. GUI thread.
#pragma once

#include <QObject>
#include <QString>
#include <atomic>
#include <stop_token>
#include <string>

#include "exports/research_export.hpp"
#include "gui/clinic/background.hpp"

namespace isograsp::gui {

class ExportWork final : public QObject {
  Q_OBJECT

 public:
  explicit ExportWork(std::string database);
  ~ExportWork() override;  ///< as cancel(); waits for the worker

  /// Ignored while one is written.
  void start(const exports::ExportRequest& request, exports::ExportFormat format,
             const std::string& folder);
  /// Nothing appears, the folder is as it was.
  void cancel();
  /// Nothing is read or written while a trial needs the disk; the next step waits.
  void hold(bool wait);
  [[nodiscard]] bool running() const noexcept { return running_; }
  /// Whose data, a code; empty: all patients'.
  [[nodiscard]] const std::string& patient() const noexcept { return patient_; }

 Q_SIGNALS:
  void progress(double fraction, const QString& code);
  // Exactly one of these ends the work.
  void written(int trials, const QString& folder);
  void failed(const QString& why);
  void cancelled();

 private:
  std::string database_;
  std::string patient_;
  bool running_ = false;
  std::stop_source stop_;
  std::atomic<bool> held_ = false;
  Background worker_;  ///< last: its job ends before anything else goes away
};

/// "isograsp-export" in that folder, or "isograsp-export-2" … if there is one: nothing is
/// overwritten.
[[nodiscard]] std::string free_export_folder(const std::string& in);

}  // namespace isograsp::gui
