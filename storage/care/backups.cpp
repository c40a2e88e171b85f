// SPDX-License-Identifier: GPL-3.0-or-later
#include "storage/care/backups.hpp"

#include <algorithm>
#include <filesystem>
#include <functional>
#include <set>

#include "core/time.hpp"
#include "storage/access/open_store.hpp"
#include "storage/access/signing.hpp"
#include "storage/records/session_store.hpp"

namespace isograsp::storage {

namespace fs = std::filesystem;

namespace {

constexpr std::time_t kDay_s = 86400;
constexpr std::size_t kHourEnd = 13;    // 2026-03-05T09:30:00Z without its colons is a file name
constexpr std::size_t kMinuteEnd = 15;  // … in the name

std::string name_of_backup(std::time_t time) {
  std::string name = utc_text(time);
  std::erase(name, ':');
  return name + ".db";
}

/// The time in the name of a backup; nothing: another file.
std::optional<std::string> utc_of_name(const std::string& name) {
  constexpr std::size_t kLength = 21;  // 2026-03-05T093000Z.db
  if (name.size() != kLength || name.substr(kLength - 3) != ".db") return {};
  const std::string utc = name.substr(0, kHourEnd) + ":" + name.substr(kHourEnd, 2) + ":" +
                          name.substr(kMinuteEnd, kLength - 3 - kMinuteEnd);
  if (!time_of_utc(utc)) return {};
  return utc;
}

std::time_t day_of(std::time_t time) {
  return time / kDay_s;
}
/// Monday to Sunday; the first of January 1970 was a Thursday.
std::time_t week_of(std::time_t time) {
  return (day_of(time) + 3) / 7;
}
std::time_t month_of(std::time_t time) {
  std::tm parts{};
  gmtime_r(&time, &parts);
  return 12 * parts.tm_year + parts.tm_mon;
}

}  // namespace

std::vector<bool> kept_by(const BackupRotation& rotation, const std::vector<std::time_t>& backups) {
  std::vector<bool> kept(backups.size(), false);
  const auto keep = [&](int most, const std::function<std::time_t(std::time_t)>& period_of) {
    std::set<std::time_t> seen;
    for (std::size_t i = 0; i < backups.size() && static_cast<int>(seen.size()) < most; ++i)
      if (seen.insert(period_of(backups[i])).second) kept[i] = true;
  };
  keep(rotation.days, day_of);
  keep(rotation.weeks, week_of);
  keep(rotation.months, month_of);
  return kept;
}

Backups::Backups(const std::string& database, BackupRotation rotation)
    : database_(database), folder_(database + ".backups"), rotation_(rotation) {}

Result<std::vector<BackupFile>> Backups::list() const {
  std::vector<BackupFile> all;
  std::error_code failure;
  if (!fs::exists(folder_, failure)) return all;
  for (fs::directory_iterator entry(folder_, failure), end; !failure && entry != end;
       entry.increment(failure))
    if (const auto utc = utc_of_name(entry->path().filename().string()))
      all.push_back({entry->path().string(), *utc});
  if (failure)
    return failed("cannot be read: %1"_text(Known{failure.message()}), "check its permissions"_text)
        .at(folder_);
  std::sort(all.begin(), all.end(),
            [](const auto& a, const auto& b) { return a.made_utc > b.made_utc; });
  return all;
}

Result<bool> Backups::due(std::time_t now) const {
  const auto all = list();
  if (!all) return all.error();
  return std::none_of(all->begin(), all->end(), [now](const BackupFile& one) {
    return day_of(*time_of_utc(one.made_utc)) == day_of(now);
  });
}

Result<Backups::Made> Backups::make(std::time_t now) const {
  std::error_code failure;
  fs::create_directory(folder_, failure);
  if (failure)
    return failed("cannot be made: %1"_text(Known{failure.message()}),
                  "make the folder writable"_text)
        .at(folder_);
  Made made;
  made.backup = {folder_ + "/" + name_of_backup(now), utc_text(now)};
  {
    const auto store = open_store(database_, OpenMode::read_only);
    if (!store) return store.error();
    if (const auto copied = (*store)->backup(made.backup.path); !copied) return copied.error();
  }
  const auto all = list();
  if (!all) return all.error();
  std::vector<std::time_t> times;
  for (const BackupFile& one : *all) times.push_back(*time_of_utc(one.made_utc));
  const auto kept = kept_by(rotation_, times);
  for (std::size_t i = 0; i < all->size(); ++i) {
    const std::string& path = (*all)[i].path;
    if (kept[i] || path == made.backup.path) continue;
    if (!fs::remove(path, failure))
      return failed("the new backup is made, but this old one cannot be removed"_text,
                    "check the permissions of the folder"_text)
          .at(path);
    fs::remove(signature_file_of(path), failure);
    made.removed.push_back(path);
  }
  return made;
}

Result<std::optional<Backups::Made>> Backups::make_if_due(std::time_t now) const {
  const auto is_due = due(now);
  if (!is_due) return is_due.error();
  if (!*is_due) return std::optional<Made>();
  auto made = make(now);
  if (!made) return made.error();
  return std::optional(*std::move(made));
}

}  // namespace isograsp::storage
