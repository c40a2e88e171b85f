// SPDX-License-Identifier: GPL-3.0-or-later
// The files of a recording to trials.
#include <filesystem>
#include <map>
#include <regex>

#include "session/import/recorded_trials.hpp"

namespace isograsp::session {

namespace {

namespace fs = std::filesystem;

/// The pattern of file names; each key is a group.
std::regex regex_of(const std::string& pattern) {
  constexpr std::string_view kSpecial = ".^$|()[]*+?\\";
  std::string text;
  for (std::size_t at = 0; at < pattern.size(); ++at) {
    if (pattern[at] == '{') {
      text += "([A-Za-z0-9]+)";
      at = pattern.find('}', at);
      continue;
    }
    if (kSpecial.find(pattern[at]) != std::string_view::npos) text += '\\';
    text += pattern[at];
  }
  return std::regex(text);
}

using Files = std::map<std::string, KeyValues>;  ///< the keys in their names

Result<void> read_files(const RecordingSpec& spec, const fs::path& folder,
                        const std::string& library, const Files& files, RecordedTrials& trials) {
  if (spec.rig.empty()) {
    for (const auto& [name, values] : files)
      if (auto done = read_recorded_table(folder / name, values, spec, trials); !done) return done;
    return {};
  }
  const auto markers = RecordedMarkers::open(spec, library);
  if (!markers) return markers.error();
  for (const auto& [name, values] : files)
    if (auto done = markers->read(folder / name, values, trials); !done) return done;
  return {};
}

}  // namespace

Result<std::vector<RecordedTrial>> read_recording(const RecordingSpec& spec,
                                                  const std::string& folder,
                                                  const std::string& library) {
  const std::regex pattern = regex_of(spec.file);
  Files files;
  std::error_code failure;
  for (fs::directory_iterator at(folder, failure), end; !failure && at != end;
       at.increment(failure)) {
    const std::string name = at->path().filename();
    std::smatch match;
    if (!std::regex_match(name, match, pattern)) continue;
    KeyValues values;
    for (std::size_t k = 0; k < spec.file_keys.size(); ++k)
      values[spec.file_keys[k]] = match[k + 1].str();
    files[name] = std::move(values);
  }
  if (failure)
    return refused("cannot be listed: %1"_text(Known{failure.message()}),
                   "name the folder that holds the recording"_text)
        .at(folder)
        .about("--from");
  if (files.empty())
    return refused("holds no file %1"_text(spec.file),
                   "name the folder that holds the recording"_text)
        .at(folder)
        .about("--from");
  RecordedTrials found(spec);
  if (const auto read = read_files(spec, folder, library, files, found); !read) return read.error();
  auto trials = found.take();
  if (trials && trials->empty())
    return refused("holds no rows"_text, "give a file with data"_text)
        .at(fs::path(folder) / files.begin()->first);
  return trials;
}

}  // namespace isograsp::session
