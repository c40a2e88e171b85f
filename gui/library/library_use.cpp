// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/library/library_use.hpp"

#include <algorithm>
#include <string_view>

#include "kinematics/pose_task.hpp"
#include "storage/crypto/content_hash.hpp"
#include "tasks/task_spec.hpp"

namespace isograsp::gui {

namespace {

/// Stored is the text of the file, perhaps followed by its curve and the level of the trial.
bool is_text_of(const std::string& stored, const std::string& file) {
  if (!stored.starts_with(file)) return false;
  const auto rest = std::string_view(stored).substr(file.size());
  return rest.empty() || rest.starts_with("\n[csv_data]\n") || rest.starts_with("\n[chosen]\n");
}

/// Stored is a task that was compiled from the postures of that file.
bool tells_hash_of(const std::string& scene, const std::string& postures) {
  const auto task = parse_pose_task(scene, "");
  return task && task->postures_hash == storage::uuid_of(postures);
}

void look_at(const storage::TrialRecord& trial, LibraryKind kind, const std::string& former,
             const std::string& text, const std::string& name, FileUse& use) {
  if (kind == LibraryKind::scenes) {
    use.used = use.used || trial.scene_text == former;
    return;
  }
  if (kind == LibraryKind::postures) {
    use.used = use.used || trial.scene_text == former || tells_hash_of(trial.scene_text, former);
    return;
  }
  use.used = use.used || is_text_of(trial.task_text, former);
  if (trial.task_name == name && !is_text_of(trial.task_text, text))
    use.newest_version = std::max(use.newest_version, trial.task_version);
}

}  // namespace

Result<FileUse> use_of(storage::SessionStore& store, LibraryKind kind, const std::string& former,
                       const std::string& text) {
  FileUse use;
  const auto name = name_in(text);
  const auto patients = store.patients();
  if (!patients) return patients.error();
  for (const auto& patient : *patients) {
    const auto sessions = store.sessions(patient.id);
    if (!sessions) return sessions.error();
    for (const auto& session : *sessions) {
      if (kind == LibraryKind::protocols) {
        use.used = use.used || session.protocol_text == former;
        continue;
      }
      const auto trials = store.trials(session.id);
      if (!trials) return trials.error();
      for (const auto& trial : *trials) look_at(trial, kind, former, text, name, use);
    }
  }
  return use;
}

void count_as_used(FileUse& use, LibraryKind kind, const std::string& former,
                   const std::string& text) {
  use.used = true;
  if (kind != LibraryKind::tasks || former == text || name_in(former) != name_in(text)) return;
  if (const auto spec = tasks::parse_task(former, ""))
    use.newest_version = std::max(use.newest_version, spec->version);
}

}  // namespace isograsp::gui
