// SPDX-License-Identifier: GPL-3.0-or-later
#include "exports/export_writer.hpp"

#include <algorithm>

#include "core/files.hpp"

namespace isograsp::exports {

std::optional<ExportFormat> export_format_from_name(std::string_view name) noexcept {
  const auto found = std::find(kExportFormats.begin(), kExportFormats.end(), name);
  if (found == kExportFormats.end()) return {};
  return static_cast<ExportFormat>(found - kExportFormats.begin());
}

std::unique_ptr<ExportWriter> make_export_writer(ExportFormat format,
                                                 const std::filesystem::path& folder,
                                                 const Language& language) {
  switch (format) {
    case ExportFormat::csv: break;
    case ExportFormat::hdf5: return make_hdf5_writer(folder, language);
    case ExportFormat::bids: return make_bids_writer(folder, language);
    case ExportFormat::fhir: return make_fhir_writer(folder, language);
  }
  return make_csv_writer(folder, language);
}

Result<void> make_folder(const std::filesystem::path& folder) {
  std::error_code failure;
  std::filesystem::create_directories(folder, failure);
  if (!failure) return {};
  return failed("the folder cannot be made: %1"_text(Known{failure.message()}),
                "check its permissions"_text)
      .at(folder);
}

Result<void> write_below(const std::filesystem::path& path, std::string_view text) {
  if (const auto made = make_folder(path.parent_path()); !made) return made;
  return write_text(path, text);
}

}  // namespace isograsp::exports
