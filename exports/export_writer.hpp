// SPDX-License-Identifier: GPL-3.0-or-later
// How an export is written: one writer for each format. Trials come one after another and only one
// is in memory. Formats: docs/file_formats.md, "Research export".
#pragma once

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.hpp"
#include "exports/export_trial.hpp"

namespace isograsp::exports {

enum class ExportFormat : std::uint8_t { csv, hdf5, bids, fhir };
inline constexpr std::array<std::string_view, 4> kExportFormats{"csv", "hdf5", "bids", "fhir"};
/// As `isograsp export --format` calls it.
[[nodiscard]] constexpr std::string_view name_of(ExportFormat format) noexcept {
  return kExportFormats[static_cast<std::size_t>(format)];
}
[[nodiscard]] std::optional<ExportFormat> export_format_from_name(std::string_view name) noexcept;

class ExportWriter {
 public:
  virtual ~ExportWriter() = default;
  /// The files below the folder that a trial needs, those that it shares with others included.
  [[nodiscard]] virtual std::vector<std::string> files_of(const ExportPlace& place) const = 0;
  /// Trials come by patient, session and number.
  [[nodiscard]] virtual Result<void> write(const ExportTrial& trial) = 0;
  /// After the last trial.
  [[nodiscard]] virtual Result<void> finish() = 0;
};

/// Writes below `folder`, which is made with the first file. Texts for people (descriptions,
/// displays) are in `language`, which must outlive the writer; columns, keys, codes and the
/// sentences of the database stay as they are. A writer that is destroyed without finish() leaves
/// what it wrote.
[[nodiscard]] std::unique_ptr<ExportWriter> make_export_writer(ExportFormat format,
                                                               const std::filesystem::path& folder,
                                                               const Language& language);

// For the writers.
[[nodiscard]] std::unique_ptr<ExportWriter> make_csv_writer(std::filesystem::path folder,
                                                            const Language& language);
[[nodiscard]] std::unique_ptr<ExportWriter> make_hdf5_writer(std::filesystem::path folder,
                                                             const Language& language);
[[nodiscard]] std::unique_ptr<ExportWriter> make_bids_writer(std::filesystem::path folder,
                                                             const Language& language);
[[nodiscard]] std::unique_ptr<ExportWriter> make_fhir_writer(std::filesystem::path folder,
                                                             const Language& language);
/// A text file with the folders above it.
[[nodiscard]] Result<void> write_below(const std::filesystem::path& path, std::string_view text);
[[nodiscard]] Result<void> make_folder(const std::filesystem::path& folder);

}  // namespace isograsp::exports
