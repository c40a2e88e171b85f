// SPDX-License-Identifier: GPL-3.0-or-later
// Mappings of foreign logs, and the conversion itself: the input is a mapping, a NUL and a log that
// stands for all of its files.
#include "device/recording/csv_mapping.hpp"

#include <cmath>

#include "hand/finger_forces.hpp"
#include "tests/fuzz/support.hpp"
#include "tests/support/temporary_folder.hpp"

using namespace isograsp;

namespace {

void require_sound(const CsvMapping& mapping) {
  fuzz::require(!mapping.fingers.empty() && mapping.fingers.size() <= kFingerCount,
                "a mapping has one to three fingers");
  for (const auto& finger : mapping.fingers) {
    fuzz::require(std::isfinite(finger.N_per_unit) && finger.N_per_unit != 0.0, "force has a unit");
    fuzz::require(std::isfinite(finger.Nm_per_unit) && finger.Nm_per_unit != 0.0,
                  "torque has a unit");
    fuzz::require(!finger.axes[2].column.empty(), "the pressing force is measured");
  }
  fuzz::require(mapping.rate_Hz ? *mapping.rate_Hz > 0.0 : !mapping.time_unit.empty(),
                "rows have a time");
}

void require_readable(const std::string& path, std::int64_t count) {
  auto reader = FingerForcesReader::open(path);
  fuzz::require(reader.ok(), "what was converted is a finger-forces file");
  FingerForcesRow row;
  for (std::int64_t r = 0; r < count; ++r) {
    const auto more = reader->next(row);
    fuzz::require(more.ok() && *more, "every converted row can be read");
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::MemoryFile log;
  static const test::TemporaryFolder folder;
  const auto input = fuzz::as_text(data, size);
  const auto border = input.find('\0');
  const auto text = input.substr(0, border);
  auto mapping = parse_csv_mapping(text, "mapping.toml");
  if (!mapping) {
    fuzz::require_helpful(mapping.error(), text);
    return 0;
  }
  require_sound(*mapping);
  if (border == std::string_view::npos) return 0;
  const auto table = input.substr(border + 1);
  log.write(table);
  for (auto& finger : mapping->fingers) finger.file = log.path();
  const auto path = folder.path("converted.csv");
  const auto converted = convert_csv(*mapping, "", path);
  if (converted)
    require_readable(path, converted->rows);
  else
    fuzz::require_helpful(converted.error(), table);
  return 0;
}
