// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/clinic/backup_work.hpp"

#include <ctime>
#include <optional>
#include <utility>

#include "gui/words/texts.hpp"

namespace isograsp::gui {

namespace {
constexpr int kLookEvery_ms = 15 * 60 * 1000;
constexpr int kAfterStart_ms = 20 * 1000;  // so that the window appears first
}  // namespace

BackupWork::BackupWork(const std::string& database, QObject* parent)
    : QObject(parent), backups_(database) {
  again_.setSingleShot(true);
  connect(&again_, &QTimer::timeout, this, &BackupWork::look);
}

void BackupWork::begin() {
  again_.start(kAfterStart_ms);
}

void BackupWork::hold(bool wait) {
  if (std::exchange(held_, wait) && !wait && again_.isActive()) again_.start(kAfterStart_ms);
}

void BackupWork::look() {
  again_.start(kLookEvery_ms);
  if (held_ || std::exchange(running_, true)) return;
  using Made = Result<std::optional<storage::Backups::Made>>;
  worker_.run([backups = backups_]() -> Made { return backups.make_if_due(std::time(nullptr)); },
              [this](const Made& outcome) {
                running_ = false;
                if (!outcome) {
                  const auto why =
                      tr("No backup could be made: %1").arg(translated(outcome.error()));
                  const QDate today = QDate::currentDate();
                  const bool told = std::exchange(told_, today) == today;
                  if (std::exchange(problem_, why) != why || !told) Q_EMIT failed(why);
                  return;
                }
                problem_.clear();  // nothing is due: there is one, whoever made it
                if (*outcome) Q_EMIT made(QString::fromStdString((*outcome)->backup.path));
              });
}

}  // namespace isograsp::gui
