// SPDX-License-Identifier: GPL-3.0-or-later
// Converts CSV logs of any origin to a finger-forces file (docs/file_formats.md). A mapping file
// says which file and column is which finger and axis, with sign, unit and rate.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.hpp"
#include "hand/finger.hpp"

namespace isograsp {

/// One axis of a contact frame: a column of the log, or nothing (written as 0).
struct MappedAxis {
  std::string column;
  double sign = 1.0;
};

struct MappedFinger {
  Finger finger = Finger::thumb;
  std::string file;                ///< as the mapping names it
  std::array<MappedAxis, 6> axes;  ///< fx fy fz tx ty tz
  std::string force_unit;
  std::string torque_unit;
  double N_per_unit = 1.0;
  double Nm_per_unit = 1.0;
};

struct CsvMapping {
  std::string path;  ///< of the mapping file
  std::string name;
  std::string
      label;  ///< what must be said wherever the data are shown; first comment of the output
  std::vector<std::string> notes;
  std::optional<double> rate_Hz;  ///< row k is at k / rate; else there is a time column
  std::string time_column;
  std::string time_unit;
  double units_per_second = 1.0;
  std::vector<MappedFinger> fingers;
};

/// Reads and checks a mapping (format "isograsp-mapping-1"). `path` is used in errors and to find
/// the logs.
[[nodiscard]] Result<CsvMapping> parse_csv_mapping(std::string_view text, const std::string& path);

/// What was written.
struct ConvertedCsv {
  std::int64_t rows = 0;
  double first_s = 0.0;
  double last_s = 0.0;
  std::vector<std::string> comments;  ///< label, sources, everything the mapping states
};

/// Writes the finger-forces file, whole or not at all, in constant memory. Logs are looked for in
/// `folder`, or beside the mapping file if it is empty. A row of a finger whose fields are all
/// empty becomes a missing sample. Errors name file, line and column of the log.
[[nodiscard]] Result<ConvertedCsv> convert_csv(const CsvMapping& mapping, const std::string& folder,
                                               const std::string& out_path);

}  // namespace isograsp
