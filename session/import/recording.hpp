// SPDX-License-Identifier: GPL-3.0-or-later
// Recordings that others made, as a recording file says them (docs/file_formats.md): which files
// and columns are whose trial, in which units, under which licence. Tables of forces and positions,
// or recordings of markers on an arm, which a rig makes segments and links of.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.hpp"
#include "core/signals.hpp"
#include "hand/finger.hpp"
#include "tasks/task_spec.hpp"

namespace isograsp::session {

/// One stored column, from one or several of the file.
struct RecordedColumn {
  enum class Combine : std::uint8_t { none, sum, magnitude };
  std::string name;  ///< with its SI unit: "actual_force_N"
  std::vector<std::string> from;
  Combine combine = Combine::none;
  std::string unit;     ///< that the numbers really have
  double factor = 1.0;  ///< SI units per unit
};

struct RecordingSpec {
  enum class Separator : std::uint8_t { comma, tab, space };
  std::string path;  ///< of the recording file …
  std::string text;  ///< … and the file itself
  std::string name;
  std::string label;  ///< what must be said wherever the data are shown
  std::string source;
  std::string licence;
  std::string device;  ///< what measured
  std::vector<std::string> notes;
  std::string unit_reason;   ///< why units are not those that the files state
  std::optional<Hand> hand;  ///< nothing: not known
  std::string rig;  ///< of files with markers: its name or file; empty: the files are tables

  /// Names of the files; {key} stands for letters and digits.
  std::string file;
  std::vector<std::string> file_keys;  ///< the keys in it
  Separator separator = Separator::comma;
  std::vector<std::string> file_columns;  ///< of files without a header; empty: there is one
  /// Of the rows; with a column of times: about; of markers 0: their files tell the times.
  double rate_Hz = 0.0;
  std::string time_column;  ///< [s]; empty: row k is at k / rate_Hz

  // Keys are those of the file's name or columns of the file.
  std::string patient_prefix;
  std::string patient_key;              ///< a number from 1 on; empty: one patient
  std::string session_key;              ///< empty: one session
  std::vector<std::string> sessions;    ///< values of session_key in the order of time
  std::vector<std::string> trial_keys;  ///< empty: a trial is all there is in a session
  std::vector<RecordedColumn> columns;  ///< of tables
  std::string task;                     ///< task file of the trials; {key} stands for its value
};

/// Reads and checks a recording file (format "isograsp-recording-1"). `path` is used in errors.
[[nodiscard]] Result<RecordingSpec> parse_recording(std::string_view text, const std::string& path);

struct RecordedTrial {
  std::string patient_code;  ///< generated: EDRAKI-01
  std::size_t session = 0;   ///< of the patient, in the order of time
  std::string session_name;  ///< value of session_key; may be empty
  std::string file;          ///< without folder
  tasks::TaskSpec task;
  Signals signals;          ///< t_s and the columns
  std::string calibration;  ///< the rig as it was; empty: of forces
  std::string scene_text;   ///< empty: no object
  bool simulated = false;   ///< the file says that no person pressed or moved
};

/// All trials in the files of `folder`, by patient and session, each in the order of the files.
/// A rig that is no file beside the recording file is looked for in `library`. Errors name file,
/// line and column.
[[nodiscard]] Result<std::vector<RecordedTrial>> read_recording(const RecordingSpec& spec,
                                                                const std::string& folder,
                                                                const std::string& library);

/// One line each: everything the files themselves do not say.
[[nodiscard]] std::vector<std::string> provenance_of(const RecordingSpec& spec);

}  // namespace isograsp::session
