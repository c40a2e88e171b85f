// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/library_pages/library_preview.hpp"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>
#include <filesystem>

#include "bimanual/read_hands.hpp"
#include "core/files.hpp"
#include "grasp_model/scene.hpp"
#include "gui/library_pages/scene_preview.hpp"
#include "gui/words/texts.hpp"
#include "gui/words/words.hpp"
#include "kinematics/postures.hpp"
#include "session/library/library.hpp"
#include "tasks/timeline.hpp"
#include "tasks/waveform.hpp"

namespace isograsp::gui {

namespace {

struct PreviewTexts {
  Q_DECLARE_TR_FUNCTIONS(LibraryPreview)
};

constexpr double kPeriod_s = 0.02;  ///< of the curve: fine enough for 600 pixels
constexpr double kWhole_percent = 100.0;

QString duration_words_of(const tasks::Duration& duration) {
  if (duration.worst_s - duration.nominal_s < 1.0) return time_words(duration.nominal_s);
  return PreviewTexts::tr("%1, at most %2")
      .arg(time_words(duration.nominal_s), time_words(duration.worst_s));
}

/// One unit of every scale is set to 100 N, so that newtons can be read as percent.
tasks::TaskContext sample_context(const tasks::TaskSpec& spec) {
  tasks::TaskContext context;
  context.period_s = kPeriod_s;
  auto& references = context.references;
  const bool fixed_load = spec.aim() != nullptr && spec.aim()->scale == tasks::Scale::of_baseline;
  for (std::size_t d = 0; d < kDigitsCount; ++d)
    for (std::size_t k = 0; k < kDirectionCount; ++k) {
      const ForceChannel channel{static_cast<Digits>(d), static_cast<Direction>(k)};
      references.maximum_N[channel] = fixed_load ? 100.0 * kWhole_percent : kWhole_percent;
      references.comfortable_N[channel] = kWhole_percent;
      references.baseline_N[channel] = kWhole_percent;
    }
  return context;
}

QString axis_of(tasks::Scale scale) {
  switch (scale) {
    case tasks::Scale::newton: return PreviewTexts::tr("Target (N)");
    case tasks::Scale::of_maximum: return PreviewTexts::tr("Target (% of the maximum)");
    case tasks::Scale::of_comfortable:
      return PreviewTexts::tr("Target (% of the comfortable force)");
    case tasks::Scale::of_baseline: break;
  }
  return PreviewTexts::tr("Target (% of the baseline)");
}

std::optional<LibraryPreview::Curve> force_curve(const tasks::TaskSpec& spec) {
  const tasks::Aim* aim = spec.aim();
  if (aim == nullptr) return std::nullopt;
  const auto timeline = tasks::timeline_of(spec, sample_context(spec));
  if (!timeline) return std::nullopt;
  LibraryPreview::Curve curve{axis_of(aim->scale), kPeriod_s, {}, {}};
  for (const tasks::Segment& segment : timeline->segments)
    for (std::int64_t k = 0; k < segment.frames; ++k) {
      const auto& targets = segment.target_N;
      const auto place = targets.size() == 1 ? std::size_t{0} : static_cast<std::size_t>(k);
      curve.values.push_back(targets.empty() ? tasks::kNotMeasured : targets[place]);
      curve.hidden.push_back(!segment.target_shown);
    }
  const bool any = std::any_of(curve.values.begin(), curve.values.end(),
                               [](double value) { return !std::isnan(value); });
  return any ? std::optional(curve) : std::nullopt;
}

/// The first axis of a target that moves.
std::optional<LibraryPreview::Curve> pose_curve(const tasks::TaskSpec& spec) {
  const auto axis = spec.course(kPeriod_s);
  if (!axis) return std::nullopt;
  const bool turns = axis->axis >= 3;
  const double factor = turns ? 180.0 / M_PI : 1000.0;
  LibraryPreview::Curve curve{PreviewTexts::tr("%1 of the target (%2)")
                                  .arg(qt(kDofNames[static_cast<std::size_t>(axis->axis)]),
                                       turns ? QStringLiteral("°") : QStringLiteral("mm")),
                              kPeriod_s,
                              {},
                              {}};
  for (const double value : axis->values) curve.values.push_back(factor * value);
  curve.hidden.assign(curve.values.size(), false);
  return curve;
}

void add_targets(const tasks::TaskSpec& spec, LibraryPreview::Sketch& sketch) {
  for (const auto& target : spec.targets()) {
    if (target.p_WO) sketch.targets.push_back({{target.p_WO->x(), target.p_WO->y()}, 0.0, true});
    sketch.targets.push_back({{target.p_WT.x(), target.p_WT.y()}, target.angle_rad, false});
  }
}

/// What must have been measured in the session before.
QString needed_by(const tasks::TaskSpec& spec) {
  QStringList needed;
  for (const auto& [scale, words] :
       {std::pair{tasks::Scale::of_maximum, PreviewTexts::tr("maximum: %1")},
        std::pair{tasks::Scale::of_comfortable, PreviewTexts::tr("comfortable force: %1")},
        std::pair{tasks::Scale::of_baseline, PreviewTexts::tr("baseline: %1")}}) {
    QStringList channels;
    for (const ForceChannel channel : spec.channels_needed(scale))
      channels << QString::fromStdString(name_of(channel));
    if (!channels.isEmpty()) needed << words.arg(channels.join(QStringLiteral(", ")));
  }
  return needed.join(QStringLiteral("; "));
}

LibraryPreview of_task(const tasks::TaskSpec& spec, const std::string& shipped) {
  LibraryPreview preview;
  preview.title = QString::fromStdString(spec.name);
  auto& facts = preview.facts;
  facts.push_back(
      {PreviewTexts::tr("The patient reads"), QString::fromStdString(spec.instruction)});
  facts.push_back({PreviewTexts::tr("Version"), QString::number(spec.version)});
  facts.push_back({PreviewTexts::tr("Takes"), duration_words_of(spec.duration())});
  if (const auto needed = needed_by(spec); !needed.isEmpty())
    facts.push_back({PreviewTexts::tr("Measured before"), needed});
  if (spec.difficulty)
    facts.push_back(
        {PreviewTexts::tr("Difficulty"),
         PreviewTexts::tr("may be chosen or follow success: for training, not assessment")});
  preview.curve = force_curve(spec);
  if (const auto curve = pose_curve(spec)) preview.curve = curve;
  if (spec.scene().empty()) return preview;
  const auto path = session::find_in_library(shipped, "scenes", spec.scene(), spec.file);
  const auto text = path ? read_text(*path) : Result<std::string>(path.error());
  if (!text) return preview;
  if (bimanual::has_hands(*text)) {
    const LibraryPreview object = preview_of_scene(*text, *path);
    if (!object.sketch) return preview;
    facts.push_back({PreviewTexts::tr("Object"), object.title});
    preview.sketch = object.sketch;
  } else {
    const auto scene = parse_scene(*text, *path);
    if (!scene) return preview;
    facts.push_back({PreviewTexts::tr("Object"), QString::fromStdString(scene->name)});
    preview.sketch = sketch_of(*scene);
  }
  add_targets(spec, *preview.sketch);
  if (const auto count =
          std::count_if(preview.sketch->targets.begin(), preview.sketch->targets.end(),
                        [](const auto& target) { return !target.start; });
      count > 0)
    facts.push_back({PreviewTexts::tr("Targets"), QString::number(count)});
  return preview;
}

QString words_of(const tasks::ProtocolStep& step, const std::vector<tasks::TaskSpec>& tasks) {
  switch (step.kind) {
    case tasks::ProtocolStep::Kind::instrument_zero: return PreviewTexts::tr("Instrument zero");
    case tasks::ProtocolStep::Kind::start_posture: return PreviewTexts::tr("Start posture");
    case tasks::ProtocolStep::Kind::hand_entry: return PreviewTexts::tr("Entry test of the hand");
    case tasks::ProtocolStep::Kind::pause: return PreviewTexts::tr("Pause");
    case tasks::ProtocolStep::Kind::task: break;
  }
  QStringList names;
  for (const auto& task : tasks) names << QString::fromStdString(task.name);
  auto words = names.join(QStringLiteral(", "));
  const bool repeats = step.repetitions > 1 || step.agreement;
  if (step.agreement)
    words = PreviewTexts::tr("%1 (%2 to %3 times)")
                .arg(words)
                .arg(step.repetitions)
                .arg(std::max(step.repetitions, step.agreement->most_repetitions));
  else if (repeats)
    words = PreviewTexts::tr("%1 (%n time(s))", "", step.repetitions).arg(words);
  if (step.practice) words = PreviewTexts::tr("%1, practice").arg(words);
  return words;
}

LibraryPreview of_protocol(const session::ReadyProtocol& protocol) {
  LibraryPreview preview;
  preview.title = QString::fromStdString(protocol.spec.name);
  // Each step counts what the protocol takes longer with it: the sum is that of the whole.
  tasks::ProtocolSpec part;
  std::vector<std::vector<tasks::TaskSpec>> tasks;
  tasks::Duration before;
  for (std::size_t i = 0; i < protocol.spec.steps.size(); ++i) {
    part.steps.push_back(protocol.spec.steps[i]);
    tasks.push_back(protocol.tasks[i]);
    const tasks::Duration with = tasks::duration_of(part, tasks);
    preview.steps.push_back({words_of(protocol.spec.steps[i], protocol.tasks[i]),
                             {with.nominal_s - before.nominal_s, with.worst_s - before.worst_s}});
    before = with;
  }
  preview.facts.push_back({PreviewTexts::tr("Takes"), duration_words_of(protocol.duration())});
  preview.facts.push_back(
      {PreviewTexts::tr("Steps"), QString::number(static_cast<int>(protocol.spec.steps.size()))});
  return preview;
}

LibraryPreview of_postures(const Postures& postures, const std::string& path) {
  LibraryPreview preview;
  preview.title = QString::fromStdString(postures.name);
  auto& facts = preview.facts;
  facts.push_back(
      {PreviewTexts::tr("Postures"), QString::number(static_cast<int>(postures.postures.size()))});
  facts.push_back({PreviewTexts::tr("Arm"), postures.hand == Hand::left
                                                ? PreviewTexts::tr("left, mirrored")
                                                : PreviewTexts::tr("right")});
  facts.push_back({PreviewTexts::tr("An own task names them"),
                   QStringLiteral("postures = \"%1\"")
                       .arg(QString::fromStdString(std::filesystem::path(path).stem().string()))});
  return preview;
}

}  // namespace

QString time_words(double duration_s) {
  constexpr int kMinute_s = 60;
  const int seconds = static_cast<int>(std::ceil(duration_s - 1e-9));
  if (seconds < 2 * kMinute_s) return PreviewTexts::tr("%1 s").arg(seconds);
  return PreviewTexts::tr("%1 min %2 s").arg(seconds / kMinute_s).arg(seconds % kMinute_s);
}

LibraryPreview preview_of(LibraryKind kind, const std::string& text, const std::string& path,
                          const std::string& shipped) {
  if (kind == LibraryKind::tasks) {
    const auto spec = session::read_task(text, path);
    return spec ? of_task(*spec, shipped) : LibraryPreview{};
  }
  if (kind == LibraryKind::protocols) {
    const auto protocol = session::read_protocol(text, path, shipped);
    return protocol ? of_protocol(*protocol) : LibraryPreview{};
  }
  if (kind == LibraryKind::postures) {
    const auto postures = parse_postures(text, path);
    return postures ? of_postures(*postures, path) : LibraryPreview{};
  }
  return preview_of_scene(text, path);
}

}  // namespace isograsp::gui
