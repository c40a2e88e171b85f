// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/library/task_groups.hpp"

#include <QCoreApplication>
#include <algorithm>
#include <cctype>
#include <string>

namespace isograsp::gui {

bool is_rest(const tasks::TaskSpec& spec) {
  return spec.kind->rests;
}

bool is_grip_maximum(const tasks::TaskSpec& spec) {
  const auto measured = spec.channels_measured(tasks::Scale::of_maximum);
  return std::find(measured.begin(), measured.end(), ForceChannel{}) != measured.end();
}

bool is_free_handling(const tasks::TaskSpec& spec) {
  return spec.kind->free;
}

Words words_of(TaskGroup group) noexcept {
  switch (group) {
    case TaskGroup::rest_and_maximum: return "Rest and maximum"_text;
    case TaskGroup::follow: return "Follow a force"_text;
    case TaskGroup::hold_and_let_go: return "Hold and let go"_text;
    case TaskGroup::fingers_and_directions: return "Single fingers, directions"_text;
    case TaskGroup::object: return "Move an object"_text;
    case TaskGroup::two_hands: return "Two hands"_text;
    case TaskGroup::arm: return "Move the arm"_text;
  }
  return ""_text;
}

namespace {

/// Before all others of the group: what every session begins with.
int rank_of(const tasks::TaskSpec& spec) {
  return is_rest(spec) ? 0 : is_grip_maximum(spec) ? 1 : 2;
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
                     if (a.kind->group != b.kind->group) return a.kind->group < b.kind->group;
                     if (rank_of(a) != rank_of(b)) return rank_of(a) < rank_of(b);
                     return reading_order(a.name) < reading_order(b.name);
                   });
}

}  // namespace isograsp::gui
