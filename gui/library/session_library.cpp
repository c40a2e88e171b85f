// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/library/session_library.hpp"

#include <algorithm>
#include <filesystem>
#include <set>

#include "gui/library/task_groups.hpp"

namespace isograsp::gui {

namespace {

namespace fs = std::filesystem;

std::vector<std::string> files_in(const fs::path& folder) {
  std::vector<std::string> files;
  std::error_code unreadable;
  for (const auto& entry : fs::directory_iterator(folder, unreadable))
    if (entry.path().extension() == ".toml") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

template <class All, class FileOf>
std::optional<int> place(const All& all, const std::string& file, FileOf file_of) {
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const auto& one) { return file_of(one) == file; });
  if (found == all.end()) return std::nullopt;
  return static_cast<int>(found - all.begin());
}

}  // namespace

SessionLibrary read_session_library(const std::string& shipped, const std::string& own) {
  SessionLibrary library;
  std::set<std::string> task_names;
  std::set<std::string> protocol_names;
  const auto is_free = [&](std::set<std::string>& names, const std::string& name,
                           const std::string& file) {
    if (names.insert(name).second) return true;
    library.problems.push_back(
        words_of(refused("'%1' is the name of another file"_text(name), "choose another one"_text)
                     .at(file, std::nullopt, "name")));
    return false;
  };
  for (const auto& folder : {shipped, own}) {
    for (const auto& file : files_in(fs::path(folder) / "tasks")) {
      auto spec = session::load_task(file);
      if (!spec)
        library.problems.push_back(words_of(spec.error()));
      else if (is_free(task_names, spec->name, file))
        library.tasks.push_back(*std::move(spec));
    }
    for (const auto& file : files_in(fs::path(folder) / "protocols")) {
      auto protocol = session::read_protocol(file, shipped);
      if (!protocol)
        library.problems.push_back(words_of(protocol.error()));
      else if (is_free(protocol_names, protocol->spec.name, file))
        library.protocols.push_back(*std::move(protocol));
    }
  }
  if (library.tasks.empty()) library.problems.push_back("No tasks in %1/tasks."_text(shipped));
  sort_for_list(library.tasks);
  return library;
}

SessionLibrary for_apparatus(SessionLibrary all, std::string_view kind) {
  const std::string_view there =
      kind == kArm || kind == kTrackedHand || kind == kTwoPlatforms ? kind : kPlatform;
  const auto is_of_another = [there](const auto& one) {
    const auto needed = one.apparatus();
    return !needed.empty() && needed != there;
  };
  std::erase_if(all.tasks, is_of_another);
  std::erase_if(all.protocols, is_of_another);
  return all;
}

std::optional<int> place_of_file(const std::vector<tasks::TaskSpec>& tasks,
                                 const std::string& file) {
  return place(tasks, file, [](const tasks::TaskSpec& task) { return task.file; });
}

std::optional<int> place_of_file(const std::vector<session::ReadyProtocol>& protocols,
                                 const std::string& file) {
  return place(protocols, file,
               [](const session::ReadyProtocol& protocol) { return protocol.spec.file; });
}

std::optional<int> first_visit_protocol(const std::vector<session::ReadyProtocol>& protocols) {
  const auto makes_familiar = [](const tasks::ProtocolStep& step) {
    return step.practice && step.bouts && step.bouts->work_s >= kFirstVisit_s;
  };
  const auto found = std::find_if(protocols.begin(), protocols.end(), [&](const auto& protocol) {
    return std::ranges::any_of(protocol.spec.steps, makes_familiar);
  });
  if (found == protocols.end()) return std::nullopt;
  return static_cast<int>(found - protocols.begin());
}

}  // namespace isograsp::gui
