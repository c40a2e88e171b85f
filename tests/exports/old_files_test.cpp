// SPDX-License-Identifier: GPL-3.0-or-later
// What an export says of a session stays what it was, whichever format its file has.
// tests/data/format_7_session.db was made by the last program that wrote format 7,
// format_7_session_csv.txt has the BLAKE2b-256 of the files that it exported from it.
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include <gtest/gtest.h>

#include "exports/export_list.hpp"
#include "exports/research_export.hpp"
#include "storage/access/open_store.hpp"
#include "storage/care/migration.hpp"
#include "storage/crypto/content_hash.hpp"
#include "tests/support/every.hpp"
#include "tests/support/files_below.hpp"
#include "tests/support/temporary_folder.hpp"

namespace isograsp::exports::old_files_test {
namespace {

namespace fs = std::filesystem;
using Hashes = std::map<std::string, std::string>;  ///< by name of the file

Hashes exported(const std::string& database, ExportFormat format, const std::string& folder) {
  const auto store = storage::open_store_to_read(database).value();
  EXPECT_TRUE(write_export(*store, {}, format, folder).ok());
  Hashes hashes;
  for (const auto& file : test::files_below(folder)) {
    // They follow from the other files, and from what a bundle of FHIR draws.
    if (file == kExportList || file == kExportSignature) continue;
    std::ifstream in(folder + "/" + file, std::ios::binary);
    std::string bytes{std::istreambuf_iterator<char>(in), {}};
    // Numbers that a bundle of FHIR gives its parts are drawn each time.
    constexpr std::string_view kDrawn = "urn:uuid:";
    if (format == ExportFormat::fhir)
      for (auto at = bytes.find(kDrawn); at != std::string::npos; at = bytes.find(kDrawn))
        bytes.replace(at, kDrawn.size() + 36, "drawn");
    std::ostringstream hex;
    for (const std::uint8_t byte : storage::content_hash(bytes)) {
      constexpr const char* kDigits = "0123456789abcdef";
      hex << kDigits[byte / 16] << kDigits[byte % 16];
    }
    hashes[file] = hex.str();
  }
  return hashes;
}

TEST(OldFiles, AreExportedAsByTheProgramThatMadeThemBeforeAndAfterMigration) {
  const std::string data = ISOGRASP_SOURCE_DIR "/tests/data/";
  Hashes before;
  std::ifstream list(data + "format_7_session_csv.txt");
  for (std::string hash, file; list >> hash >> file;) before[file] = hash;
  ASSERT_EQ(before.size(), 23u);
  test::TemporaryFolder folder;
  const std::string path = folder.path("clinic.db");
  fs::copy_file(data + "format_7_session.db", path);
  std::map<std::string, Hashes> as_it_is;
  for (const ExportFormat format :
       {ExportFormat::csv, ExportFormat::hdf5, ExportFormat::bids, ExportFormat::fhir})
    as_it_is[std::string(name_of(format))] =
        exported(path, format, folder.path("old_" + std::string(name_of(format))));
  EXPECT_EQ(as_it_is["csv"], before);
  ASSERT_TRUE(storage::migrate_database(path).ok());
  for (const ExportFormat format :
       {ExportFormat::csv, ExportFormat::hdf5, ExportFormat::bids, ExportFormat::fhir})
    EXPECT_EQ(exported(path, format, folder.path("new_" + std::string(name_of(format)))),
              as_it_is[std::string(name_of(format))])
        << name_of(format);
}

}  // namespace
}  // namespace isograsp::exports::old_files_test
