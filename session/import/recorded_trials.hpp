// SPDX-License-Identifier: GPL-3.0-or-later
// What is read of a recording, sorted to the people, sessions and trials that it belongs to.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "session/arm/arm_rig.hpp"
#include "session/import/recording.hpp"

namespace isograsp::session {

/// Values of the keys that a recording file names.
using KeyValues = std::map<std::string, std::string>;

/// Where a value stands, for errors.
struct RecordedPlace {
  std::string path;
  std::optional<int> line;  ///< nothing: the name of the file tells it
};

class RecordedTrials {
 public:
  explicit RecordedTrials(const RecordingSpec& spec) : spec_(spec) {}

  /// The trial with these values of the keys; a new one, without columns, where there is none. It
  /// stands there until the next call.
  [[nodiscard]] Result<RecordedTrial*> trial_of(const KeyValues& values, const RecordedPlace& at);
  /// All of them, by patient and session, in the order of appearance. Errors: too few rows.
  [[nodiscard]] Result<std::vector<RecordedTrial>> take();

 private:
  struct Order {
    int patient = 1;
    std::size_t session = 0;
    std::size_t appearance = 0;
    auto operator<=>(const Order&) const = default;
  };
  struct Found {
    Order order;
    RecordedTrial trial;
  };
  [[nodiscard]] Result<Found> new_trial(const KeyValues& values, const RecordedPlace& at) const;

  const RecordingSpec& spec_;
  std::vector<Found> found_;
  std::map<KeyValues, std::size_t> index_;  ///< in found_
  KeyValues last_values_;
  std::size_t last_ = static_cast<std::size_t>(-1);
};

/// Reads one table into its trials. Errors name file, line and column.
[[nodiscard]] Result<void> read_recorded_table(const std::filesystem::path& path,
                                               const KeyValues& of_file, const RecordingSpec& spec,
                                               RecordedTrials& trials);

/// Reads one file of markers, a trial, through the rig: arm and markers as a session records them.
class RecordedMarkers {
 public:
  /// Reads the rig of the recording file.
  [[nodiscard]] static Result<RecordedMarkers> open(const RecordingSpec& spec,
                                                    const std::string& library);
  [[nodiscard]] Result<void> read(const std::filesystem::path& path, const KeyValues& of_file,
                                  RecordedTrials& trials) const;

 private:
  explicit RecordedMarkers(ArmRig rig) : rig_(std::move(rig)) {}
  ArmRig rig_;
};

}  // namespace isograsp::session
