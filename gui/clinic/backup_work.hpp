// SPDX-License-Identifier: GPL-3.0-or-later
// Daily backups: one checked copy of the database a day, made when the program starts or a new day
// begins. None is begun while a session is open; one that is being made then is finished. Own
// worker; GUI thread.
#pragma once

#include <QDate>
#include <QObject>
#include <QString>
#include <QTimer>
#include <string>

#include "gui/clinic/background.hpp"
#include "storage/care/backups.hpp"

namespace isograsp::gui {

class BackupWork final : public QObject {
  Q_OBJECT

 public:
  explicit BackupWork(const std::string& database, QObject* parent = nullptr);

  void begin();  ///< the database is open: looks now, then every quarter of an hour
  /// A session is open: a copy would disturb the disk.
  void hold(bool wait);
  /// Makes one if it is due and nothing holds it.
  void look();
  /// Why the newest one could not be made; empty: it could.
  [[nodiscard]] const QString& problem() const noexcept { return problem_; }

 Q_SIGNALS:
  void made(const QString& path);
  void failed(const QString& why);  ///< once a day for each reason

 private:
  storage::Backups backups_;
  bool held_ = false;
  bool running_ = false;
  QString problem_;
  QDate told_;  ///< the day of failed()
  QTimer again_;
  Background worker_;  ///< last: its job ends before anything else goes away
};

}  // namespace isograsp::gui
