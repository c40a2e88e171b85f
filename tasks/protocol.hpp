// SPDX-License-Identifier: GPL-3.0-or-later
// What a session consists of, as a protocol file says it (docs/file_formats.md).
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.hpp"
#include "tasks/task_spec.hpp"

namespace isograsp::tasks {

/// In which order the repetitions of several tasks come.
enum class Order : std::uint8_t {
  ordered,      ///< all of the first, then all of the second …
  interleaved,  ///< one of each, then again one of each
  random        ///< shuffled, the same way for the same seed
};

/// Attempts are repeated until they agree.
struct Agreement {
  double percent = 10.0;  ///< largest difference that counts as agreement, of the larger value
  std::string measure;    ///< that must agree, e.g. "maximum_force"
  int most_repetitions = 4;
};

/// Work in bouts, such as familiarisation: attempts go on until they have taken their time.
struct Bouts {
  double work_s = 0.0;  ///< all attempts at a task together, on its clock
  double bout_s = 0.0;  ///< after so much work the hand rests …
  double rest_s = 0.0;  ///< … for so long
};

/// One step of a protocol.
struct ProtocolStep {
  enum class Kind : std::uint8_t {
    instrument_zero,  ///< device empty
    task,
    pause,          ///< nothing is asked
    start_posture,  ///< the arm is held still: references are adapted to its size
    hand_entry      ///< the tracked hand at rest, then opened and closed
  };
  /// Something is measured before the work, of which the apparatus knows what.
  [[nodiscard]] bool prepares() const noexcept {
    return kind == Kind::instrument_zero || kind == Kind::start_posture || kind == Kind::hand_entry;
  }
  Kind kind = Kind::task;
  std::vector<std::string> tasks;  ///< file names of the tasks, without folder
  Order order = Order::ordered;
  int repetitions = 1;  ///< of each task
  /// Assessment: the best two must agree. Practice: the last two must.
  std::optional<Agreement> agreement;
  std::optional<Bouts> bouts;  ///< never beside an agreement
  bool practice = false;       ///< recorded, but no assessment
  bool adaptive = false;       ///< training: difficulty follows success
  std::optional<Look> look;    ///< of that training; nothing: as the task says
  double rest_s = 0.0;         ///< pause after each repetition
  double recurrence_s = 0.0;   ///< the same task begins at the earliest this long after its end
  double duration_s = 0.0;     ///< of a pause
};

struct ProtocolSpec {
  std::string name;
  std::vector<ProtocolStep> steps;
  std::string file;
  std::string text;
};
[[nodiscard]] Result<ProtocolSpec> parse_protocol(std::string_view text, const std::string& file);

}  // namespace isograsp::tasks
