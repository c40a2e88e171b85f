// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/library/task_groups.hpp"

#include <QCoreApplication>
#include <algorithm>
#include <cctype>
#include <string>

namespace isograsp::gui {

TaskKind kind_of(const tasks::TaskSpec& spec) {
  if (std::holds_alternative<tasks::RestSpec>(spec.kind)) return TaskKind::rest;
  if (const auto* maximum = std::get_if<tasks::MaximumSpec>(&spec.kind))
    return maximum->channel == ForceChannel{} && !maximum->comfortable ? TaskKind::maximum
                                                                       : TaskKind::other;
  if (std::holds_alternative<tasks::ForceTrackingSpec>(spec.kind)) return TaskKind::force_tracking;
  if (std::holds_alternative<tasks::PoseTargetsSpec>(spec.kind)) return TaskKind::pose_targets;
  if (std::holds_alternative<tasks::ObserveSpec>(spec.kind)) return TaskKind::observe;
  return TaskKind::other;
}

TaskGroup group_of(const tasks::TaskSpec& spec) {
  struct Group {
    TaskGroup operator()(const tasks::RestSpec&) const { return TaskGroup::rest_and_maximum; }
    TaskGroup operator()(const tasks::MaximumSpec&) const { return TaskGroup::rest_and_maximum; }
    TaskGroup operator()(const tasks::DirectionalMaximaSpec&) const {
      return TaskGroup::rest_and_maximum;
    }
    TaskGroup operator()(const tasks::ForceTrackingSpec&) const { return TaskGroup::follow; }
    TaskGroup operator()(const tasks::StepResponseSpec&) const { return TaskGroup::follow; }
    TaskGroup operator()(const tasks::SteadinessSpec&) const { return TaskGroup::hold_and_let_go; }
    TaskGroup operator()(const tasks::FatigueSpec&) const { return TaskGroup::hold_and_let_go; }
    TaskGroup operator()(const tasks::ForceSenseSpec&) const { return TaskGroup::hold_and_let_go; }
    TaskGroup operator()(const tasks::GripReleaseSpec&) const { return TaskGroup::hold_and_let_go; }
    TaskGroup operator()(const tasks::IndividuationSpec&) const {
      return TaskGroup::fingers_and_directions;
    }
    TaskGroup operator()(const tasks::ForceDirectionSpec&) const {
      return TaskGroup::fingers_and_directions;
    }
    TaskGroup operator()(const tasks::PoseTargetsSpec&) const { return TaskGroup::object; }
    TaskGroup operator()(const tasks::PoseTrackingSpec&) const { return TaskGroup::object; }
    TaskGroup operator()(const tasks::PickPlaceSpec&) const { return TaskGroup::object; }
    TaskGroup operator()(const tasks::ObserveSpec&) const { return TaskGroup::object; }
    TaskGroup operator()(const tasks::RecordedSpec&) const { return TaskGroup::follow; }
  };
  return std::visit(Group{}, spec.kind);
}

std::string_view title_of(TaskGroup group) noexcept {
  switch (group) {
    case TaskGroup::rest_and_maximum: return QT_TRANSLATE_NOOP("Texts", "Rest and maximum");
    case TaskGroup::follow: return QT_TRANSLATE_NOOP("Texts", "Follow a force");
    case TaskGroup::hold_and_let_go: return QT_TRANSLATE_NOOP("Texts", "Hold and let go");
    case TaskGroup::fingers_and_directions:
      return QT_TRANSLATE_NOOP("Texts", "Single fingers, directions");
    case TaskGroup::object: return QT_TRANSLATE_NOOP("Texts", "Move an object");
  }
  return "";
}

namespace {

/// Before all others of the group: what every session begins with.
int rank_of(const tasks::TaskSpec& spec) {
  const TaskKind kind = kind_of(spec);
  return kind == TaskKind::rest ? 0 : kind == TaskKind::maximum ? 1 : 2;
}

}  // namespace

/// Small letters, and numbers filled with zeros: then the order of the text is that of the numbers.
std::string reading_order(const std::string& name) {
  constexpr std::size_t kDigits = 6;
  std::string key, number;
  const auto put_number = [&] {
    if (number.empty()) return;
    if (number.size() < kDigits) key.append(kDigits - number.size(), '0');
    key += number;
    number.clear();
  };
  for (const char letter : name) {
    const auto c = static_cast<unsigned char>(letter);
    if (std::isdigit(c) != 0) {
      number += letter;
      continue;
    }
    put_number();
    key += static_cast<char>(std::tolower(c));
  }
  put_number();
  return key;
}

void sort_for_list(std::vector<tasks::TaskSpec>& tasks) {
  std::stable_sort(tasks.begin(), tasks.end(),
                   [](const tasks::TaskSpec& a, const tasks::TaskSpec& b) {
                     if (group_of(a) != group_of(b)) return group_of(a) < group_of(b);
                     if (rank_of(a) != rank_of(b)) return rank_of(a) < rank_of(b);
                     return reading_order(a.name) < reading_order(b.name);
                   });
}

}  // namespace isograsp::gui
