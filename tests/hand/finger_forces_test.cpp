// SPDX-License-Identifier: GPL-3.0-or-later
#include "hand/finger_forces.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "core/csv.hpp"
#include "tests/support/temporary_folder.hpp"

namespace isograsp::finger_forces_test {
namespace {

using test::TemporaryFolder;

TEST(FingerForces, ColumnsAreFoundByNameAndMissingTorqueIsZero) {
  const TemporaryFolder folder;
  const auto path =
      folder.write("f.csv", "thumb_fz_N,t_s,thumb_fx_N,thumb_fy_N\n3,0,1,2\n,0.01,,\n");
  auto reader = FingerForcesReader::open(path, {true, false, false});
  ASSERT_TRUE(reader) << reader.error().message();
  FingerForcesRow row;
  ASSERT_TRUE(*reader->next(row));
  EXPECT_EQ(row.wrench_C[0].force, Vec3(1, 2, 3));
  EXPECT_EQ(row.wrench_C[0].torque, Vec3(0, 0, 0));
  EXPECT_TRUE(row.present[0]);
  EXPECT_FALSE(row.present[1]);
  ASSERT_TRUE(*reader->next(row));
  EXPECT_FALSE(row.present[0]);
  EXPECT_FALSE(*reader->next(row));
}

TEST(FingerForces, RefusesHalfEmptySamplesAbsentFingersAndMisspeltColumns) {
  const TemporaryFolder folder;
  FingerForcesRow row;
  auto half = FingerForcesReader::open(
      folder.write("h.csv", "t_s,thumb_fx_N,thumb_fy_N,thumb_fz_N\n0,1,2,3\n0.01,1,,3\n"));
  ASSERT_TRUE(half);
  ASSERT_TRUE(half->next(row));
  const auto second = half->next(row);
  ASSERT_FALSE(second);
  EXPECT_NE(second.error().message().find(":3: thumb_fy_N: the field is empty"), std::string::npos);

  const auto absent = FingerForcesReader::open(folder.path("h.csv"), {true, true, false});
  ASSERT_FALSE(absent);
  EXPECT_NE(absent.error().message().find("index_fx_N: the column is missing"), std::string::npos);

  const auto misspelt = FingerForcesReader::open(
      folder.write("m.csv", "t_s,thumb_fx_N,thumb_fy_N,thumb_fz_N,thumb_tz_Nmm\n0,1,2,3,4\n"));
  ASSERT_FALSE(misspelt);
  EXPECT_NE(misspelt.error().message().find("thumb_tz_Nmm: unknown column"), std::string::npos);
}

TEST(FingerForces, WhatElseATrialHasOfAFingerMayStandBesideAndIsNotRead) {
  const TemporaryFolder folder;
  auto reader =
      FingerForcesReader::open(folder.write("a.csv",
                                            "t_s,thumb_flexion_N,thumb_fx_N,thumb_distal_N,thumb_"
                                            "fy_N,thumb_fz_N,thumb_flags,thumb_fx_counts\n"
                                            "0,9,1,9,2,3,9,9\n"));
  ASSERT_TRUE(reader) << reader.error().message();
  FingerForcesRow row;
  ASSERT_TRUE(*reader->next(row));
  EXPECT_EQ(row.wrench_C[0].force, Vec3(1, 2, 3));
}

TEST(FingerForces, AGridWithinFourUlpIsRegularAndAJitteredOneIsNot) {
  const TemporaryFolder folder;
  std::string regular = "t_s\n";
  for (int k = 0; k < 6000; ++k) regular += format_number(k * 0.01) + "\n";
  const auto grid = read_time_grid(folder.write("r.csv", regular));
  ASSERT_TRUE(grid) << grid.error().message();
  EXPECT_TRUE(grid->regular);
  EXPECT_EQ(grid->hold_s, 0.01);
  EXPECT_FALSE(read_time_grid(folder.write("j.csv", "t_s\n0\n0.01\n0.0200001\n"))->regular);
  EXPECT_FALSE(read_time_grid(folder.write("one.csv", "t_s\n0\n")));
}

TEST(FingerForces, OfTwoFaultsTheFirstInTheFileIsNamed) {
  const TemporaryFolder folder;
  const auto grid =
      read_time_grid(folder.write("t.csv", "t_s,thumb_fx_N\n0,0\n0.01,x\n0.02,0\n0.02,0\n"));
  ASSERT_FALSE(grid);
  EXPECT_NE(grid.error().message().find(":3: thumb_fx_N: 'x' is not"), std::string::npos)
      << grid.error().message();
}

TEST(FingerForces, AWrittenRowReadsBackTheSame) {
  const TemporaryFolder folder;
  FingerForcesRow row;
  row.t_s = 0.1;
  row.wrench_C[1] = {Vec3(0.1, -0.2, 1.0 / 3.0), Vec3(1e-3, 0, -2e-3)};
  row.present = {false, true, false};
  std::string text;
  for (const auto& name : finger_forces_columns()) text += (text.empty() ? "" : ",") + name;
  text += "\n";
  append_finger_forces(text, row);
  auto reader = FingerForcesReader::open(folder.write("w.csv", text));
  ASSERT_TRUE(reader) << reader.error().message();
  FingerForcesRow read;
  ASSERT_TRUE(*reader->next(read));
  EXPECT_EQ(read.present, row.present);
  EXPECT_EQ(read.wrench_C[1].force, row.wrench_C[1].force);
  EXPECT_EQ(read.wrench_C[1].torque, row.wrench_C[1].torque);
}

/// Had it waited for a pipe that never answers, so would this.
TEST(FingerForces, APipeIsRefusedAtOnce) {
  const TemporaryFolder folder;
  const auto pipe = folder.path("pipe");
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  for (const Error& error :
       {read_time_grid(pipe).error(), FingerForcesReader::open(pipe).error()}) {
    EXPECT_EQ(error.file, pipe);
    EXPECT_NE(english(error.what).find("is not a file"), std::string::npos) << error.message();
  }
}

}  // namespace
}  // namespace isograsp::finger_forces_test
