// SPDX-License-Identifier: GPL-3.0-or-later
// A session without a window, for `isograsp run` and `isograsp demo`.
#pragma once

#include <atomic>
#include <optional>
#include <string>
#include <vector>

#include "core/measure.hpp"
#include "core/result.hpp"
#include "hand/hands.hpp"
#include "session/acquisition/realtime.hpp"

namespace isograsp::app {

/// What the patient says at the end, 0 to 10 each.
struct Rating {
  int effort = 0;
  int pain = 0;
};

struct RunOptions {
  std::string protocol_file;
  std::string protocol_text;  ///< in place of what stands in the file; empty: as it stands there
  int broken_off_in = -1;     ///< step of the protocol in which the session ends; negative: in none
  std::string task_file;      ///< this task alone in place of a protocol
  std::string device;
  std::string database;
  bool scratch = false;  ///< the database is removed again by the caller: nothing is synced
  std::string patient;
  std::string device_left;  ///< of both hands at once, each on a platform …
  std::string device_right;
  std::string affected;  ///< side, where the database does not say it; empty: it does, or nobody
  std::string hand;      ///< of one device; empty: the right one, or both on two platforms
  bool fast = false;
  bool resume = false;      ///< go on with the protocol of the patient's last session
  bool quiet = false;       ///< no progress bar and no scores
  std::string started_utc;  ///< empty: now
  std::string operator_name;
  bool serviced = false;  ///< the operator confirms that the device was serviced or remounted
  std::string allowed;    ///< outcome of the screening for this hand; empty: not asked
  std::optional<double> ceiling_N;            ///< no target may exceed it
  OfHands<std::optional<double>> ceilings_N;  ///< of both hands
  std::vector<std::string> passive;  ///< of an arm, as typed: "forearm_a3=-40:60" [degrees]
  std::optional<Rating> rating;      ///< nothing: not asked
  session::Realtime realtime = session::Realtime::prefer;
  const std::atomic<bool>* stop = nullptr;  ///< ends the session when somebody sets it
  bool clock_is_right = false;              ///< though it is behind the newest session of the file
};

/// Runs the protocol, records it and prints the scores.
[[nodiscard]] Result<void> run_session(const RunOptions& options);
/// Of `--hand`.
[[nodiscard]] Result<Hand> hand_option(const std::string& text);
/// One line on standard output.
void print_measure(const Measure& measure);

}  // namespace isograsp::app
