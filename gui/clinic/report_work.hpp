// SPDX-License-Identifier: GPL-3.0-or-later
// Writes a report while the windows stay usable: the worker gathers and saves, the GUI thread
// paints in steps of some milliseconds between its other events. One report at a time. GUI thread.
#pragma once

#include <QObject>
#include <QString>
#include <QTimer>
#include <memory>
#include <stop_token>
#include <string>

#include "gui/clinic/background.hpp"
#include "reports/findings/progress_report.hpp"
#include "reports/paper/report_writer.hpp"
#include "storage/records/session_store.hpp"

namespace isograsp::gui {

class ReportWork final : public QObject {
  Q_OBJECT

 public:
  /// The store is touched on `worker` only.
  ReportWork(std::shared_ptr<std::unique_ptr<storage::SessionStore>> store, Background& worker);
  ~ReportWork() override;  ///< as cancel()

  /// PDF, or HTML if `path` ends in ".html". Ignored while a report is being written.
  void start(const std::string& code, const std::string& path,
             const reports::ReportScope& scope = {});
  /// Nothing is written, a file that was there stays. Too late once the file is being saved.
  void cancel();
  /// No painting while a trial needs an even picture; gathering goes on.
  void hold(bool wait);

  [[nodiscard]] bool running() const noexcept { return stage_ != Stage::idle; }
  [[nodiscard]] bool may_cancel() const noexcept { return running() && stage_ != Stage::saving; }
  [[nodiscard]] const std::string& code() const noexcept { return code_; }

 Q_SIGNALS:
  /// `fraction` 0 … 1 only grows; `words`: "page 3 of 7".
  void progress(double fraction, const QString& words);
  // Exactly one of these ends the work.
  void written(const QString& path);
  void failed(const QString& why);
  void cancelled();

 private:
  enum class Stage : std::uint8_t { idle, gathering, painting, saving };

  void paint_next();
  void save();
  void end();

  std::shared_ptr<std::unique_ptr<storage::SessionStore>> store_;
  Background& worker_;
  Stage stage_ = Stage::idle;
  bool held_ = false;
  std::string code_;
  std::string path_;
  std::stop_source stop_;
  std::unique_ptr<reports::ReportWriter> writer_;
  QTimer between_events_;
};

}  // namespace isograsp::gui
