// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/platform/prepare_trial.hpp"

#include "core/files.hpp"
#include "hand/platform_records.hpp"
#include "session/library/library.hpp"
#include "session/platform/contact_threshold.hpp"

namespace isograsp::session {

Result<TrialScene> read_trial_scene(
    const tasks::TaskSpec& spec, Hand hand,
    const std::array<std::optional<double>, kFingerCount>& threshold_N,
    const std::string& library) {
  TrialScene read;
  if (spec.scene().empty()) return read;
  const auto path = find_in_library(library, "scenes", spec.scene(), spec.file);
  if (!path) return path.error();
  auto text = read_text(*path);
  if (!text) return text.error();
  auto scene = parse_scene(*text, *path);
  if (!scene) return scene.error();
  read.scene = with_thresholds(for_hand(*std::move(scene), hand), threshold_N);
  read.text = *std::move(text);
  return read;
}

Result<std::unique_ptr<PlatformTrial>> prepare_trial(const tasks::TaskSpec& spec,
                                                     const tasks::TaskContext& context,
                                                     const TrialScene& scene) {
  auto setup = std::make_unique<PlatformTrial>();
  setup->spec = spec;
  storage::TrialRecord& record = setup->record;
  if (scene.scene) {
    auto plan = Plan::compile(*scene.scene, context.period_s);
    if (!plan) return plan.error();
    setup->plan = std::move(*plan);
    const auto threshold_N = thresholds_of(*scene.scene);
    for (std::size_t f = 0; f < kFingerCount; ++f)
      storage::set_value(record.references, platform::kThreshold_N[f], threshold_N[f]);
    record.scene_text = scene.text;
  }
  auto task = tasks::make_task(spec, context);
  if (!task) return task.error();
  setup->task = std::move(*task);
  record.task_name = spec.name;
  record.task_version = spec.version;
  record.task_text = spec.text;
  record.seed = context.seed;
  return setup;
}

}  // namespace isograsp::session
