// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/library/library_files.hpp"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <set>

#include "bimanual/read_hands.hpp"
#include "core/files.hpp"
#include "grasp_model/plan.hpp"
#include "gui/library/task_groups.hpp"
#include "kinematics/postures.hpp"
#include "session/library/library.hpp"
#include "tasks/waveform.hpp"

namespace isograsp::gui {

namespace {

namespace fs = std::filesystem;

/// The line [begin, end) of a top-level key; absent: both are where a new line belongs.
struct KeyLine {
  std::size_t begin = 0;
  std::size_t end = 0;  ///< behind the line break
  bool found = false;
};

bool is_key(std::string_view line, std::string_view key) {
  if (line.substr(0, key.size()) != key) return false;
  const auto rest = line.find_first_not_of(" \t", key.size());
  return rest != std::string_view::npos && line[rest] == '=';
}

KeyLine find_key(std::string_view text, std::string_view key) {
  KeyLine place;
  for (std::size_t begin = 0; begin < text.size();) {
    const auto line_break = text.find('\n', begin);
    const std::size_t end = line_break == std::string_view::npos ? text.size() : line_break + 1;
    const auto line = text.substr(begin, end - begin);
    if (line.front() == '[') break;  // tables: nothing of the top level follows
    if (is_key(line, key)) return {begin, end, true};
    if (is_key(line, "format")) place.begin = place.end = end;
    begin = end;
  }
  return place;
}

/// Behind the value of a line: spaces and a comment.
std::string_view comment_of(std::string_view line) {
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '\\' && quoted)
      ++i;
    else if (line[i] == '"')
      quoted = !quoted;
    else if (line[i] == '#' && !quoted) {
      while (i > 0 && (line[i - 1] == ' ' || line[i - 1] == '\t')) --i;
      const auto comment = line.substr(i);
      return comment.substr(0, comment.find_last_not_of("\r\n") + 1);
    }
  }
  return "";
}

std::string with_key(std::string_view text, std::string_view key, const std::string& value) {
  const auto line = find_key(text, key);
  std::string changed(text.substr(0, line.begin));
  if (!line.found && !changed.empty() && changed.back() != '\n') changed += '\n';
  changed += std::string(key) + " = " + value;
  if (line.found) changed += comment_of(text.substr(line.begin, line.end - line.begin));
  changed += '\n';
  changed += text.substr(line.end);
  return changed;
}

std::string quoted(const std::string& text) {
  std::string all = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') all += '\\';
    all += c;
  }
  return all + '"';
}

/// "Grip, sine (copy 2)" -> "Grip, sine"; "grip_sine_copy_2" -> "grip_sine".
std::string without_copy(const std::string& name, std::string_view opening,
                         std::string_view ending) {
  const auto at = name.rfind(opening);
  if (at == std::string::npos || at == 0 || !name.ends_with(ending)) return name;
  const auto from = at + opening.size();
  const auto number = name.substr(from, name.size() - ending.size() - from);
  const bool copy = std::all_of(number.begin(), number.end(), [](char c) {
    return c == ' ' || c == '_' || (c >= '0' && c <= '9');
  });
  return copy ? name.substr(0, at) : name;
}

/// The first of "base (copy)", "base (copy 2)" … that is not taken.
std::string free_name(const std::string& base, const std::set<std::string>& taken,
                      const std::string& opening, const char* separator, const char* ending) {
  std::string name = base + opening + ending;
  for (int n = 2; taken.contains(name); ++n)
    name = base + opening + separator + std::to_string(n) + ending;
  return name;
}

/// The first of "base", "base (2)", "base (3)" … that is not taken.
std::string free_number(const std::string& base, const std::set<std::string>& taken,
                        const char* opening, const char* ending) {
  std::string name = base;
  for (int n = 2; taken.contains(name); ++n) name = base + opening + std::to_string(n) + ending;
  return name;
}

/// The file of postures that a task names; empty: none.
std::string postures_of(const tasks::TaskSpec& spec) {
  return spec.kind->postures == nullptr ? std::string() : spec.kind->postures(spec.kind);
}

constexpr Words kWriteRemedy = "check the disk and the permissions of its folder"_text;

Result<void> make_own_folder(const fs::path& folder) {
  std::error_code failure;
  fs::create_directories(folder, failure);
  if (failure)
    return failed("the folder cannot be made: %1"_text(Known{failure.message()}), kWriteRemedy)
        .at(folder);
  return {};
}

Result<void> check_scene(const std::string& text, const std::string& path) {
  const auto scene = parse_scene(text, path);
  if (!scene) return scene.error();
  if (const auto plan = Plan::compile(*scene, kLibraryHold_s); !plan) return plan.error();
  return {};
}

Result<void> check_hands_scene(const std::string& text, const std::string& path) {
  const auto scene = bimanual::parse_hands_scene(text, path);
  if (!scene) return scene.error();
  if (scene->coupling == bimanual::Coupling::none) return {};
  const auto pressed =
      bimanual::PressedByHands::compile(scene->object, scene->contacts, kLibraryHold_s);
  if (!pressed) return pressed.error();
  return {};
}

}  // namespace

std::string_view folder_of(LibraryKind kind) noexcept {
  switch (kind) {
    case LibraryKind::tasks: return "tasks";
    case LibraryKind::scenes: return "scenes";
    case LibraryKind::protocols: return "protocols";
    case LibraryKind::postures: break;
  }
  return "postures";
}

std::string name_in(std::string_view text) {
  const auto line = find_key(text, "name");
  if (!line.found) return "";
  const auto words = text.substr(line.begin, line.end - line.begin);
  const auto first = words.find('"');
  if (first == std::string_view::npos) return "";
  std::string name;
  for (std::size_t i = first + 1; i < words.size() && words[i] != '"'; ++i) {
    if (words[i] == '\\' && i + 1 < words.size()) ++i;
    name += words[i];
  }
  return name;
}

std::string with_name(std::string_view text, const std::string& name) {
  return with_key(text, "name", quoted(name));
}

std::string with_version(std::string_view text, int version) {
  return with_key(text, "version", std::to_string(version));
}

LibraryFiles::LibraryFiles(std::string shipped, std::string own)
    : shipped_(std::move(shipped)), own_(std::move(own)) {}

std::vector<LibraryEntry> LibraryFiles::files_in(LibraryKind kind, bool own) const {
  std::vector<LibraryEntry> entries;
  std::error_code absent;
  for (const auto& file :
       fs::directory_iterator(fs::path(own ? own_ : shipped_) / folder_of(kind), absent)) {
    if (file.path().extension() != ".toml") continue;
    LibraryEntry entry{kind, file.path(), file.path().stem(), "", own, false, false};
    if (const auto text = read_text(entry.path)) {
      if (auto name = name_in(*text); !name.empty()) entry.name = std::move(name);
      if (kind == LibraryKind::tasks) {
        const auto spec = session::read_task(*text, entry.path);
        if (spec && !own) entry.group = words_of(spec->kind->group).english();
      }
      entry.sound = check(kind, *text, entry.path).ok();
    }
    entry.draft = own && draft(entry).has_value();
    entries.push_back(std::move(entry));
  }
  return entries;
}

std::vector<LibraryEntry> LibraryFiles::list(LibraryKind kind) const {
  auto entries = files_in(kind, true);
  const auto shipped = files_in(kind, false);
  entries.insert(entries.end(), shipped.begin(), shipped.end());
  const auto rank = [](const LibraryEntry& entry) {
    if (entry.own) return -1;
    for (int group = 0; group <= static_cast<int>(TaskGroup::arm); ++group)
      if (entry.group == words_of(static_cast<TaskGroup>(group)).english()) return group;
    return 0;
  };
  std::stable_sort(entries.begin(), entries.end(), [&](const auto& a, const auto& b) {
    if (rank(a) != rank(b)) return rank(a) < rank(b);
    return reading_order(a.name) < reading_order(b.name);
  });
  return entries;
}

Result<std::string> LibraryFiles::read(const LibraryEntry& entry) const {
  return read_text(entry.path);
}

Result<void> LibraryFiles::check(LibraryKind kind, const std::string& text,
                                 const std::string& path) const {
  switch (kind) {
    case LibraryKind::tasks: {
      const auto spec = session::read_task(text, path);
      if (!spec) return spec.error();
      if (!spec->scene().empty())
        if (auto scene = session::find_in_library(shipped_, "scenes", spec->scene(), path);
            !scene) {
          auto error = scene.error();
          error.field = "scene";
          return error;
        }
      if (const auto postures = postures_of(*spec); !postures.empty())
        if (auto there = session::find_in_library(shipped_, "postures", postures, path); !there)
          return Error(there.error()).about("postures");
      return {};
    }
    case LibraryKind::scenes:
      return bimanual::has_hands(text) ? check_hands_scene(text, path) : check_scene(text, path);
    case LibraryKind::postures: {
      const auto postures = parse_postures(text, path);
      if (!postures) return postures.error();
      return {};
    }
    case LibraryKind::protocols: break;
  }
  const auto protocol = session::read_protocol(text, path, shipped_);
  if (!protocol) return protocol.error();
  return {};
}

Result<void> LibraryFiles::check_name(LibraryKind kind, const std::string& text,
                                      const std::string& path) const {
  const auto name = name_in(text);
  const auto line = find_key(text, "name");
  const int number = 1 + static_cast<int>(std::count(
                             text.begin(), text.begin() + static_cast<long>(line.begin), '\n'));
  if (name.empty())
    return refused("is missing"_text, "write a name, for people"_text).at(path, number, "name");
  for (const auto& folder : {own_, shipped_}) {
    std::error_code absent;
    for (const auto& file : fs::directory_iterator(fs::path(folder) / folder_of(kind), absent)) {
      std::error_code ignored;
      if (file.path().extension() != ".toml" || fs::equivalent(file.path(), path, ignored))
        continue;
      const auto other = read_text(file.path());
      if (other && name_in(*other) == name)
        return refused("is the name of %1"_text(file.path().filename().string()),
                       "choose another one"_text)
            .at(path, number, "name");
    }
  }
  return {};
}

LibraryFiles::Taken LibraryFiles::taken(LibraryKind kind) const {
  Taken all;
  for (const auto& other : list(kind)) {
    all.names.insert(other.name);
    all.stems.insert(fs::path(other.path).stem());
  }
  std::error_code
      absent;  // an unsaved text of a file that is gone would become that of the new one
  for (const auto& draft :
       fs::directory_iterator(fs::path(own_) / "drafts" / folder_of(kind), absent))
    all.stems.insert(draft.path().stem());
  return all;
}

Result<LibraryEntry> LibraryFiles::add(LibraryKind kind, const std::string& stem,
                                       const std::string& text) const {
  const auto [names, stems] = taken(kind);
  LibraryEntry entry{kind, "", free_number(name_in(text), names, " (", ")"), "", true};
  const auto folder = fs::path(own_) / folder_of(kind);
  entry.path = folder / (free_number(stem, stems, "_", "") + ".toml");
  const auto named = with_name(text, entry.name);
  if (auto good = check(kind, named, entry.path); !good) return good.error();
  if (auto made = make_own_folder(folder); !made) return made.error();
  if (auto written = write_text(entry.path, named); !written) return written.error();
  return entry;
}

Result<LibraryEntry> LibraryFiles::duplicate(const LibraryEntry& entry,
                                             const std::string& text) const {
  const auto [names, stems] = taken(entry.kind);
  LibraryEntry copy = entry;
  const auto name = name_in(text);
  copy.name = free_name(without_copy(name.empty() ? entry.name : name, " (copy", ")"), names,
                        " (copy", " ", ")");
  copy.own = true;
  copy.draft = false;
  copy.group.clear();
  const auto folder = fs::path(own_) / folder_of(entry.kind);
  const auto stem =
      free_name(without_copy(fs::path(entry.path).stem(), "_copy", ""), stems, "_copy", "_", "");
  copy.path = folder / (stem + ".toml");
  if (auto made = make_own_folder(folder); !made) return made.error();
  auto changed = with_name(text, copy.name);
  if (entry.kind == LibraryKind::tasks && find_key(changed, "version").found)
    changed = with_version(changed, 1);
  if (auto written = write_text(copy.path, changed); !written) return written.error();
  if (const auto spec = tasks::parse_task(text, entry.path);
      entry.kind == LibraryKind::tasks && spec)
    if (const tasks::Waveform* wave = spec->waveform(); wave != nullptr && !wave->csv.empty()) {
      std::error_code failure;
      fs::copy_file(fs::path(entry.path).parent_path() / wave->csv, folder / wave->csv,
                    fs::copy_options::skip_existing, failure);
    }
  copy.sound = check(copy.kind, changed, copy.path).ok();
  return copy;
}

Result<LibraryFiles::Saved> LibraryFiles::save(const LibraryEntry& entry, const std::string& former,
                                               const std::string& text, const FileUse& use) const {
  if (!entry.own)
    return refused("is shipped and stays as it is"_text, "duplicate it first"_text).at(entry.path);
  if (auto good = check(entry.kind, text, entry.path); !good) return good.error();
  if (auto good = check_name(entry.kind, text, entry.path); !good) return good.error();
  const auto there = read_text(entry.path);
  if (!there) return there.error();
  if (*there != former)
    return failed("another program has changed this file meanwhile"_text,
                  "duplicate your text, then Revert shows what stands there"_text)
        .at(entry.path);
  Saved saved{text, 0, false, ""};
  if (entry.kind == LibraryKind::tasks) {
    const auto spec = tasks::parse_task(text, entry.path);
    if (!spec) return spec.error();
    saved.version = spec->version;
    if (use.newest_version >= spec->version) {
      saved.version = use.newest_version + 1;
      saved.raised = true;
      saved.text = with_version(text, saved.version);
      const auto raised = tasks::parse_task(saved.text, entry.path);
      if (!raised || raised->version != saved.version)
        return refused("trials were recorded with this version"_text,
                       "write version = %1"_text(saved.version))
            .at(entry.path)
            .about("version");
    }
  }
  if (use.used && saved.text != former) {
    auto kept = put_away(entry, "history", true);
    if (!kept) return kept.error();
    saved.kept = *std::move(kept);
  }
  if (auto written = write_text(entry.path, saved.text); !written) return written.error();
  drop_draft(entry);
  return saved;
}

/// Copies or moves the file to OWN/WHERE/KIND/NAME-1.toml, or the next number that is free.
Result<std::string> LibraryFiles::put_away(const LibraryEntry& entry, const char* where,
                                           bool copy) const {
  const auto folder = fs::path(own_) / where / folder_of(entry.kind);
  if (auto made = make_own_folder(folder); !made) return made.error();
  const auto stem = fs::path(entry.path).stem().string();
  fs::path place;
  int n = 0;
  do place = folder / (stem + "-" + std::to_string(++n) + ".toml");
  while (fs::exists(place));
  std::error_code failure;
  if (copy)
    fs::copy_file(entry.path, place, failure);
  else
    fs::rename(entry.path, place, failure);
  if (failure)
    return failed("the file cannot be put away: %1"_text(Known{failure.message()}), kWriteRemedy)
        .at(entry.path);
  return place.string();
}

Result<std::string> LibraryFiles::remove(const LibraryEntry& entry) const {
  if (!entry.own) return refused("is shipped and stays as it is"_text, {}).at(entry.path);
  return put_away(entry, "removed", false);
}

Result<void> LibraryFiles::bring_back(const std::string& removed, const LibraryEntry& entry) const {
  std::error_code failure;
  if (fs::exists(entry.path, failure))
    return failed("another file has this name now"_text,
                  "rename that one, or take this one from %1"_text(removed))
        .at(entry.path);
  fs::rename(removed, entry.path, failure);
  if (failure)
    return failed("the file cannot be brought back: %1"_text(Known{failure.message()}),
                  kWriteRemedy)
        .at(entry.path);
  return {};
}

std::string LibraryFiles::draft_path(const LibraryEntry& entry) const {
  return fs::path(own_) / "drafts" / folder_of(entry.kind) / fs::path(entry.path).filename();
}

Result<void> LibraryFiles::keep_draft(const LibraryEntry& entry, const std::string& text) const {
  const fs::path path = draft_path(entry);
  if (auto made = make_own_folder(path.parent_path()); !made) return made;
  return write_text(path, text);
}

std::optional<std::string> LibraryFiles::draft(const LibraryEntry& entry) const {
  const auto path = draft_path(entry);
  std::error_code ignored;
  if (!entry.own || !fs::is_regular_file(path, ignored)) return std::nullopt;
  auto text = read_text(path);
  return text ? std::optional(*std::move(text)) : std::nullopt;
}

void LibraryFiles::drop_draft(const LibraryEntry& entry) const {
  std::error_code ignored;
  fs::remove(draft_path(entry), ignored);
}

}  // namespace isograsp::gui
