// SPDX-License-Identifier: GPL-3.0-or-later
#include "exports/research_export.hpp"

#include <filesystem>
#include <unordered_set>

#include "core/staging_folder.hpp"
#include "exports/export_list.hpp"

namespace isograsp::exports {

namespace {

namespace fs = std::filesystem;

Error not_written(const fs::filesystem_error& why, const std::string& folder) {
  return failed(Known{why.code().message()}, "check the disk and the permissions"_text)
      .at(folder)
      .about("--out");
}

/// Moves every file of `from` to the same place in `to`. Nothing is overwritten.
Result<void> publish(const fs::path& from, const fs::path& to) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(from))
    if (entry.is_regular_file()) files.push_back(fs::relative(entry.path(), from));
  for (const auto& file : files)
    if (fs::exists(fs::symlink_status(to / file)))
      return refused("exists already"_text, "choose an empty folder for --out"_text).at(to / file);
  std::size_t moved = 0;
  try {
    for (; moved < files.size(); ++moved) {
      fs::create_directories((to / files[moved]).parent_path());
      fs::rename(from / files[moved], to / files[moved]);
    }
  } catch (const fs::filesystem_error& why) {
    std::error_code ignored;
    for (std::size_t i = 0; i < moved; ++i) fs::remove(to / files[i], ignored);
    return not_written(why, to);
  }
  return {};
}

/// Writes everything into the staging folder. Returns the number of trials.
Result<std::size_t> write_all(storage::SessionStore& store, const ExportRequest& request,
                              ExportFormat format, const fs::path& staging, std::size_t total,
                              const Progress& progress, const Language& language) {
  const auto writer = make_export_writer(format, staging, language);
  std::size_t written = 0;
  const auto visited =
      for_each_trial(store, request, [&](const ExportSource& source) -> Result<void> {
        const double fraction = static_cast<double>(written) / static_cast<double>(total);
        if (!tell(progress, fraction, "%1"_text(source.patient->code))) return cancelled();
        const auto trial = load_trial(store, source);
        if (!trial) return trial.error();
        ++written;
        return writer->write(*trial);
      });
  if (!visited) return visited.error();
  if (const auto done = writer->finish(); !done) return done.error();
  if (const auto done = list_and_sign(staging, store.path()); !done) return done.error();
  if (!tell(progress, 1.0, {})) return cancelled();
  return written;
}

}  // namespace

Result<std::vector<std::string>> list_export(storage::SessionStore& store,
                                             const ExportRequest& request, ExportFormat format) {
  const auto writer = make_export_writer(format, {}, kEnglish);
  std::vector<std::string> files;
  std::unordered_set<std::string> listed;
  const auto visited = for_each_trial(store, request, [&](const ExportSource& source) {
    for (auto& file : writer->files_of(source.place))
      if (listed.insert(file).second) files.push_back(std::move(file));
    return Result<void>();
  });
  if (!visited) return visited.error();
  if (!files.empty()) files.insert(files.end(), {kExportList, kExportSignature});
  return files;
}

Result<std::size_t> write_export(storage::SessionStore& store, const ExportRequest& request,
                                 ExportFormat format, const std::string& folder,
                                 const Progress& progress, const Language& language) {
  std::size_t total = 0;
  const auto counted = for_each_trial(store, request, [&total](const ExportSource&) {
    ++total;
    return Result<void>();
  });
  if (!counted) return counted.error();
  if (total == 0)
    return refused("holds no such trial"_text,
                   "check --patient and --session (1 is the patient's first)"_text)
        .at(store.path());
  const fs::path out = folder;
  std::error_code failure;
  const bool made = fs::create_directories(out, failure);
  if (failure || !fs::is_directory(out))
    return refused("the folder cannot be made"_text, "choose another one"_text)
        .at(folder)
        .about("--out");
  const auto write_and_publish = [&]() -> Result<std::size_t> {
    const auto staging = StagingFolder::beside(folder);
    if (!staging) return Error(staging.error()).about("--out");
    const fs::path part = staging->file();
    auto written = write_all(store, request, format, part, total, progress, language);
    if (!written) return written;
    try {
      if (const auto done = publish(part, out); !done) return done.error();
    } catch (const fs::filesystem_error& why) {
      return not_written(why, folder);
    }
    return written;
  };
  auto written = write_and_publish();
  if (!written && made) fs::remove(out, failure);
  return written;
}

}  // namespace isograsp::exports
