// SPDX-License-Identifier: GPL-3.0-or-later
// How the patient sits and is strapped: asked in every session, of both hands for each of them,
// offered as last time. Pure.
#pragma once

#include <QString>
#include <array>
#include <string>
#include <vector>

#include "hand/hands.hpp"
#include "storage/records/profile.hpp"

namespace isograsp::gui {

enum class PostureItem : std::uint8_t {
  seat,
  elbow,  ///< angle [deg]
  forearm,
  wrist,
  orthosis,
  supports,  ///< marks on the platform, as written there
  straps     ///< marks on the straps
};
inline constexpr std::size_t kPostureItems = 7;
inline constexpr std::array<PostureItem, kPostureItems> kPostureOrder{
    PostureItem::seat,     PostureItem::elbow,    PostureItem::forearm, PostureItem::wrist,
    PostureItem::orthosis, PostureItem::supports, PostureItem::straps};

/// As stored.
[[nodiscard]] const char* name_of(PostureItem item) noexcept;
[[nodiscard]] QString words_of(PostureItem item);
/// What may be chosen, as stored; empty: marks that are written down.
[[nodiscard]] const std::vector<const char*>& choices_of(PostureItem item);
/// A stored value in words.
[[nodiscard]] QString words_of(PostureItem item, const std::string& value);

struct SittingPosture {
  std::array<std::string, kPostureItems> values;  ///< empty: not said

  [[nodiscard]] const std::string& of(PostureItem item) const {
    return values[static_cast<std::size_t>(item)];
  }
  std::string& of(PostureItem item) { return values[static_cast<std::size_t>(item)]; }
  [[nodiscard]] bool said() const { return *this != SittingPosture{}; }
  friend bool operator==(const SittingPosture&, const SittingPosture&) = default;
};

/// As stored with the session; what was not said is left out.
[[nodiscard]] std::vector<storage::SessionAnswer> stored(const SittingPosture& posture);
[[nodiscard]] SittingPosture posture_in(const std::vector<storage::SessionAnswer>& answers);
/// Of both hands at once: the person has one seat, all else is of each hand (`left_elbow_deg`).
[[nodiscard]] std::vector<storage::SessionAnswer> stored(const OfHands<SittingPosture>& postures);
[[nodiscard]] OfHands<SittingPosture> postures_in(
    const std::vector<storage::SessionAnswer>& answers);
/// "elbow 90° instead of 110°, wrist …"; empty: the same, or nothing to compare with.
[[nodiscard]] QString deviations(const SittingPosture& now, const SittingPosture& last);

}  // namespace isograsp::gui
