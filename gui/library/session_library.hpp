// SPDX-License-Identifier: GPL-3.0-or-later
// What a session can be made of: tasks and protocols of the shipped and of the clinic's own
// library.
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "session/library/library.hpp"

namespace isograsp::gui {

/// Kinds of apparatus (session/acquisition/apparatus.hpp) that these windows tell apart.
inline constexpr std::string_view kArm = "arm";
inline constexpr std::string_view kPlatform = "platform";
inline constexpr std::string_view kTrackedHand = "tracked_hand";
inline constexpr std::string_view kTwoPlatforms = "two_platforms";

/// So long an arm is made familiar with its tasks on its first visit.
inline constexpr double kFirstVisit_s = 15.0 * 60.0;

struct SessionLibrary {
  std::vector<tasks::TaskSpec> tasks;             ///< in the order of the list
  std::vector<session::ReadyProtocol> protocols;  ///< shipped ones first, by file name
  std::vector<Text> problems;                     ///< files that cannot be used, in words
};

/// Reads all files; any thread. Where two files have the same name, the shipped one is used.
[[nodiscard]] SessionLibrary read_session_library(const std::string& shipped,
                                                  const std::string& own);

/// What can be done with an apparatus of that kind; empty, or another one that is not known here:
/// as with the platform.
[[nodiscard]] SessionLibrary for_apparatus(SessionLibrary all, std::string_view kind);

/// The place of the first task that fits; nothing: there is none.
template <class Fits>
[[nodiscard]] std::optional<int> first_task(const std::vector<tasks::TaskSpec>& tasks, Fits fits) {
  const auto found = std::find_if(tasks.begin(), tasks.end(), fits);
  if (found == tasks.end()) return std::nullopt;
  return static_cast<int>(found - tasks.begin());
}
/// The place of the element that was read from `file`; nothing: there is none.
[[nodiscard]] std::optional<int> place_of_file(const std::vector<tasks::TaskSpec>& tasks,
                                               const std::string& file);
[[nodiscard]] std::optional<int> place_of_file(const std::vector<session::ReadyProtocol>& protocols,
                                               const std::string& file);

/// The place of the first protocol that practises as long as a first visit needs; nothing: none
/// does.
[[nodiscard]] std::optional<int> first_visit_protocol(
    const std::vector<session::ReadyProtocol>& protocols);

}  // namespace isograsp::gui
