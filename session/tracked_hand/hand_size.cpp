// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/tracked_hand/hand_size.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

#include "core/files.hpp"
#include "session/library/library.hpp"
#include "session/tracked_hand/entry_capture.hpp"

namespace isograsp::session {

namespace {

/// Calls `each(name, number)` for everything that is the size of a hand.
template <class Model, class Each>
void for_each_length(Model& hand, Each each) {
  each("hand_length_m", hand.length_m);
  each("hand_breadth_m", hand.breadth_m);
  constexpr std::array<const char*, 3> kAxes{"_x_m", "_y_m", "_z_m"};
  for (std::size_t d = 0; d < kDigitCount; ++d) {
    const std::string digit(kDigitNames[d]);
    auto& of = hand.digits[d];
    for (std::size_t a = 0; a < kAxes.size(); ++a) {
      const auto axis = static_cast<Eigen::Index>(a);
      each(digit + "_metacarpal" + kAxes[a], of.metacarpal_m[axis]);
      each(digit + "_base" + kAxes[a], of.base_m[axis]);
    }
    for (std::size_t k = 0; k < virtual_hand::kLinkCount; ++k) {
      each(digit + "_link" + std::to_string(k + 1) + "_m", of.lengths_m[k]);
      each(digit + "_radius" + std::to_string(k + 1) + "_m", of.radii_m[k]);
    }
  }
}

}  // namespace

Result<virtual_hand::HandModel> usual_hand(const std::string& library,
                                           const std::string& asked_by) {
  const auto path = find_in_library(library, "hands", "default", asked_by);
  if (!path) return path.error();
  const auto text = read_text(*path);
  if (!text) return text.error();
  return virtual_hand::parse_hand(*text, *path);
}

void add_hand_size(const virtual_hand::HandModel& hand, storage::PreparationRecord& record) {
  for_each_length(hand, [&record](const std::string& name, double value) {
    record.columns.push_back(name);
    record.mean.push_back(value);
    record.sd.push_back(std::nan(""));
  });
}

Result<virtual_hand::HandModel> hand_of_size(const storage::PreparationRecord& record,
                                             const virtual_hand::HandModel& model, Hand side) {
  virtual_hand::HandModel hand = model;
  hand.side = side;
  std::string missing;
  for_each_length(hand, [&](const std::string& name, double& value) {
    const auto column = std::find(record.columns.begin(), record.columns.end(), name);
    const auto k = static_cast<std::size_t>(column - record.columns.begin());
    if (k < record.mean.size())
      value = record.mean[k];
    else if (missing.empty())
      missing = name;
  });
  if (!missing.empty())
    return refused("the stored size of a hand has no %1"_text(missing),
                   "measure the hand again"_text)
        .about("size");
  return hand;
}

Result<std::optional<MeasuredHand>> other_hand_measured(storage::SessionStore& store,
                                                        storage::RowId patient, Hand side,
                                                        bool simulated) {
  const auto sessions = store.sessions(patient);
  if (!sessions) return sessions.error();
  constexpr std::size_t kDay = std::string_view("2026-03-05").size();
  std::optional<MeasuredHand> newest;
  for (const storage::SessionRecord& session : *sessions) {
    if (!session.hand || *session.hand == side) continue;
    if (session.simulated != simulated || session.recorded) continue;
    const auto all = store.preparations(session.id);
    if (!all) return all.error();
    for (const storage::PreparationRecord& one : *all)
      if (one.kind == kHandEntry && storage::value_of(one.references, kSizeOfOtherHand) == 0.0)
        newest = {one, session.started_utc.substr(0, kDay)};
  }
  return newest;
}

}  // namespace isograsp::session
