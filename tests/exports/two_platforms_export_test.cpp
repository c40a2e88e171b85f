// SPDX-License-Identifier: GPL-3.0-or-later
// What a session on two platforms leaves in an export: the zero of each.
#include <array>
#include <filesystem>

#include <gtest/gtest.h>
#include <hdf5.h>
#include <nlohmann/json.hpp>

#include "core/files.hpp"
#include "exports/research_export.hpp"
#include "hand/platform_records.hpp"
#include "session/open_two_platforms.hpp"
#include "storage/access/open_store.hpp"
#include "tests/session/whole_session.hpp"
#include "tests/support/every.hpp"
#include "tests/support/must.hpp"
#include "tests/support/temporary_folder.hpp"

namespace isograsp::exports::two_platforms_export_test {
namespace {

TEST(TwoPlatformsExport, HasTheZeroOfEachPlatform) {
  const test::TemporaryFolder folder;
  const std::string library = std::string(ISOGRASP_SOURCE_DIR) + "/library";
  const std::string database = folder.path("clinic.db");
  const std::string pair = "sim://pair?file=paretic_left&seed=7";
  test::run_whole({database, "B-1", test::must(session::two_platforms_uri({pair, pair})),
                   library + "/protocols/two_hands_short.toml", library});
  const auto store = test::must(storage::open_store(database, storage::OpenMode::read_only));
  const auto session = test::must(store->recent_sessions(1)).at(0);
  const auto zeros = test::must(store->preparations(session.id)).at(0);
  const auto mean = platform::two_six_axes_of(zeros.columns, zeros.mean);
  const auto sd = platform::two_six_axes_of(zeros.columns, zeros.sd);
  ASSERT_TRUE(mean && sd);

  const std::string out = folder.path("csv");
  test::must(write_export(*store, {}, ExportFormat::csv, out));
  int trials = 0;
  for (const auto& file : std::filesystem::recursive_directory_iterator(out)) {
    if (!file.path().filename().string().starts_with("trial_") ||
        file.path().extension() != ".json")
      continue;
    ++trials;
    const auto json = nlohmann::json::parse(test::must(read_text(file.path().string())));
    const auto& zero = json.at("instrument_zero");
    EXPECT_FALSE(zero.contains("mean")) << "of which hand?";
    for (const Hand hand : kBothHands)
      for (std::size_t f = 0; f < kFingerCount; ++f)
        for (std::size_t axis = 0; axis < 6; ++axis) {
          const auto at = static_cast<Eigen::Index>(axis);
          const auto& of = zero.at(std::string(name_of(hand)));
          EXPECT_EQ(of.at("mean").at(std::string(kFingerNames[f])).at(axis).get<double>(),
                    (*mean)[hand][f][at]);
          EXPECT_EQ(of.at("sd").at(std::string(kFingerNames[f])).at(axis).get<double>(),
                    (*sd)[hand][f][at]);
        }
  }
  EXPECT_GT(trials, 0);

  const std::string hdf5 = folder.path("hdf5");
  test::must(write_export(*store, {}, ExportFormat::hdf5, hdf5));
  const hid_t file = H5Fopen((hdf5 + "/isograsp.h5").c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  ASSERT_GE(file, 0);
  for (const Hand hand : kBothHands) {
    const std::string place =
        "/patients/B-1/session-01/trial-01/instrument_zero/" + std::string(name_of(hand)) + "/mean";
    const hid_t data = H5Dopen2(file, place.c_str(), H5P_DEFAULT);
    ASSERT_GE(data, 0) << place;
    std::array<double, 6 * kFingerCount> values{};
    EXPECT_GE(H5Dread(data, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), 0);
    H5Dclose(data);
    for (std::size_t f = 0; f < kFingerCount; ++f)
      for (std::size_t axis = 0; axis < 6; ++axis)
        EXPECT_EQ(values[6 * f + axis], (*mean)[hand][f][static_cast<Eigen::Index>(axis)]);
  }
  H5Fclose(file);
}

}  // namespace
}  // namespace isograsp::exports::two_platforms_export_test
