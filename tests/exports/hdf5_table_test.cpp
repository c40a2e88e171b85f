// SPDX-License-Identifier: GPL-3.0-or-later
// Tables as HDF5: what is written is read back to the bit, tables that other programs write are
// read whatever their layout, and what is no table of this file is refused.
#include "exports/hdf5_table.hpp"

#include <array>
#include <bit>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>

#include <gtest/gtest.h>
#include <hdf5.h>

#include "core/random.hpp"
#include "tests/support/every.hpp"
#include "tests/support/must.hpp"
#include "tests/support/temporary_folder.hpp"

namespace isograsp::exports::hdf5_table_test {
namespace {

namespace fs = std::filesystem;
using test::must;
using Rows = std::vector<std::vector<double>>;
const std::vector<std::string> kNames{"t_s", "thumb_fx_N", "thumb_fy_N"};

Rows some_rows(std::size_t count) {
  Random random(1);
  Rows rows;
  for (std::size_t k = 0; k < count; ++k)
    rows.push_back({0.01 * static_cast<double>(k), random.gaussian(), random.gaussian()});
  return rows;
}

std::string write(const std::string& path, const Rows& rows,
                  const std::vector<std::string>& names = kNames) {
  const auto table = must(create_hdf5_table(path, names));
  for (const auto& row : rows) table->add(row);
  must(table->commit());
  return path;
}

Rows read(TableReader& table) {
  Rows rows;
  std::vector<double> row(table.columns().size());
  while (must(table.next(row))) rows.push_back(row);
  return rows;
}

std::string bytes_of(const std::string& path) {
  std::stringstream all;
  all << std::ifstream(path, std::ios::binary).rdbuf();
  return all.str();
}

void expect_same_bits(const Rows& got, const Rows& wanted) {
  ASSERT_EQ(got.size(), wanted.size());
  for (std::size_t k = 0; k < got.size(); ++k)
    for (std::size_t c = 0; c < got[k].size(); ++c)
      ASSERT_EQ(std::bit_cast<std::uint64_t>(got[k][c]), std::bit_cast<std::uint64_t>(wanted[k][c]))
          << "row " << k + 1 << ", column " << c + 1;
}

TEST(Hdf5Table, IsReadBackToTheBitWhateverItsLength) {
  const test::TemporaryFolder folder;
  for (const std::size_t count : {0u, 1u, 4095u, 4096u, 4097u, 9000u}) {
    Rows rows = some_rows(count);
    if (count > 3) {
      rows[1][1] = std::numeric_limits<double>::quiet_NaN();
      rows[2][1] = -0.0;
      rows[3][1] = std::numeric_limits<double>::denorm_min();
    }
    const auto table = must(open_hdf5_table(write(folder.path("t.h5"), rows)));
    EXPECT_EQ(table->columns(), kNames);
    expect_same_bits(read(*table), rows);
  }
}

TEST(Hdf5Table, ColumnsAloneAndRowsSayTheSame) {
  const test::TemporaryFolder folder;
  const Rows rows = some_rows(5000);
  const std::string path = write(folder.path("t.h5"), rows);
  for (std::size_t column = 0; column < kNames.size(); ++column) {
    const auto table = must(open_hdf5_table(path));
    double value = 0.0;
    for (const auto& row : rows) {
      ASSERT_TRUE(must(table->next(column, value)));
      ASSERT_EQ(value, row[column]);
    }
    EXPECT_FALSE(must(table->next(column, value)));
  }
  // One after the other, too.
  const auto table = must(open_hdf5_table(path));
  std::vector<double> row(kNames.size());
  for (std::size_t k = 0; k < rows.size(); ++k) {
    double value = 0.0;
    ASSERT_TRUE(must(k % 3 == 0 ? table->next(row) : table->next(k % 3, value)));
    ASSERT_EQ(k % 3 == 0 ? row[2] : value, rows[k][k % 3 == 0 ? 2 : k % 3]);
  }
}

TEST(Hdf5Table, TheSameNumbersGiveTheSameBytes) {
  const test::TemporaryFolder folder;
  const Rows rows = some_rows(5000);
  EXPECT_EQ(bytes_of(write(folder.path("a.h5"), rows)), bytes_of(write(folder.path("b.h5"), rows)));
}

TEST(Hdf5Table, AppearsWholeOrNotAtAll) {
  const test::TemporaryFolder folder;
  const std::string path = write(folder.path("t.h5"), some_rows(10));
  const std::string before = bytes_of(path);
  {
    const auto table = must(create_hdf5_table(path, kNames));
    for (const auto& row : some_rows(5000)) table->add(row);
  }
  EXPECT_EQ(bytes_of(path), before);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()), 1);
  EXPECT_FALSE(create_hdf5_table("/dev/full", kNames).ok());
}

/// A file of another program; ids are closed with it.
class Other {
 public:
  explicit Other(const std::string& path) {
    const hid_t access = H5Pcreate(H5P_FILE_ACCESS);
    H5Pset_fclose_degree(access, H5F_CLOSE_STRONG);
    file_ = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access);
    H5Gcreate2(file_, "signals", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
  }
  ~Other() { H5Fclose(file_); }
  [[nodiscard]] hid_t id() const { return file_; }

  /// Its numbers stay what the library makes of none: zero, if they are not given.
  hid_t table(const char* name, std::vector<hsize_t> size, hid_t type, hid_t properties,
              const std::vector<std::string>& columns, const void* numbers = nullptr) {
    const hid_t space = H5Screate_simple(static_cast<int>(size.size()), size.data(), nullptr);
    const hid_t data = H5Dcreate2(file_, name, type, space, H5P_DEFAULT, properties, H5P_DEFAULT);
    if (numbers != nullptr)
      H5Dwrite(data, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers);
    // Texts of one length, as some programs write them.
    constexpr std::size_t kLength = 12;
    const hid_t text = H5Tcopy(H5T_C_S1);
    H5Tset_size(text, kLength);
    std::string all;
    for (std::string name_of : columns) {
      name_of.resize(kLength);
      all += name_of;
    }
    const hsize_t count = columns.size();
    const hid_t attribute = H5Acreate2(data, "columns", text, H5Screate_simple(1, &count, nullptr),
                                       H5P_DEFAULT, H5P_DEFAULT);
    H5Awrite(attribute, text, all.data());
    return data;
  }

 private:
  hid_t file_;
};

TEST(Hdf5Table, OfAnotherProgramIsReadWhateverItsLayout) {
  const test::TemporaryFolder folder;
  const hsize_t rows = 5000;
  std::vector<double> numbers;
  Rows wanted;
  for (hsize_t k = 0; k < rows; ++k) {
    wanted.push_back({static_cast<double>(k), static_cast<double>(k % 7), -1.0});
    numbers.insert(numbers.end(), wanted.back().begin(), wanted.back().end());
  }
  struct Layout {
    hid_t type;
    std::vector<hsize_t> chunk;  ///< none: one piece
    bool packed;
  };
  const std::vector<Layout> layouts{
      {H5T_IEEE_F64LE, {}, false},      {H5T_IEEE_F32BE, {}, false},
      {H5T_STD_I32LE, {}, false},       {H5T_IEEE_F64LE, {64, 3}, true},
      {H5T_IEEE_F64LE, {100, 1}, true}, {H5T_IEEE_F64LE, {7, 2}, false}};
  for (std::size_t k = 0; const Layout& layout : test::every(layouts)) {
    const std::string path = folder.path("other.h5");
    {
      Other other(path);
      const hid_t properties = H5Pcreate(H5P_DATASET_CREATE);
      if (!layout.chunk.empty()) H5Pset_chunk(properties, 2, layout.chunk.data());
      if (layout.packed) H5Pset_deflate(properties, 4);
      other.table("signals/x", {rows, 3}, layout.type, properties, kNames, numbers.data());
    }
    SCOPED_TRACE("layout " + std::to_string(++k));
    const auto table = must(open_hdf5_table(path));
    EXPECT_EQ(table->columns(), kNames);
    expect_same_bits(read(*table), wanted);
    expect_same_bits(read(*must(open_hdf5_table(path, "signals/x"))), wanted);
  }
}

TEST(Hdf5Table, DataSetsOfAGroupStandSideBySide) {
  const test::TemporaryFolder folder;
  const std::string path = folder.path("two.h5");
  {
    Other other(path);
    const double times[] = {0.0, 1.0};
    const double forces[] = {1.0, 2.0, 3.0, 4.0};
    other.table("signals/time", {2, 1}, H5T_IEEE_F64LE, H5P_DEFAULT, {"t_s"}, times);
    other.table("signals/force", {2, 2}, H5T_IEEE_F64LE, H5P_DEFAULT, {"a", "b"}, forces);
    H5Gcreate2(other.id(), "signals/more", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
  }
  const auto table = must(open_hdf5_table(path));
  EXPECT_EQ(table->columns(), (std::vector<std::string>{"a", "b", "t_s"}));
  EXPECT_EQ(read(*table), (Rows{{1.0, 2.0, 0.0}, {3.0, 4.0, 1.0}}));
}

TEST(Hdf5Table, WhatIsNoTableOfThisFileIsRefusedInOneSentence) {
  const test::TemporaryFolder folder;
  const std::string path = folder.path("bad.h5");
  write(folder.path("elsewhere.h5"), some_rows(2));
  folder.write("raw", std::string(1000, 'x'));
  struct Bad {
    const char* what;
    void (*make)(Other&, const std::string& folder);
    const char* said;
  };
  const std::vector<Bad> cases{
      {"nothing", [](Other&, const std::string&) {}, "holds no table there"},
      {"a name too few",
       [](Other& o, const std::string&) {
         o.table("signals/x", {2, 2}, H5T_IEEE_F64LE, H5P_DEFAULT, {"t_s"});
       },
       "is no table"},
      {"one dimension",
       [](Other& o, const std::string&) {
         o.table("signals/x", {2}, H5T_IEEE_F64LE, H5P_DEFAULT, {"t_s"});
       },
       "is no table"},
      {"texts",
       [](Other& o, const std::string&) {
         o.table("signals/x", {2, 1}, H5T_C_S1, H5P_DEFAULT, {"t_s"});
       },
       "is no table"},
      {"a column twice",
       [](Other& o, const std::string&) {
         o.table("signals/x", {2, 1}, H5T_IEEE_F64LE, H5P_DEFAULT, {"t_s"});
         o.table("signals/y", {2, 1}, H5T_IEEE_F64LE, H5P_DEFAULT, {"t_s"});
       },
       "t_s: the column appears twice"},
      {"other rows",
       [](Other& o, const std::string&) {
         o.table("signals/x", {2, 1}, H5T_IEEE_F64LE, H5P_DEFAULT, {"t_s"});
         o.table("signals/y", {3, 1}, H5T_IEEE_F64LE, H5P_DEFAULT, {"a"});
       },
       "a: has another number of rows"},
      {"a link to another file",
       [](Other& o, const std::string& where) {
         H5Lcreate_external((where + "/elsewhere.h5").c_str(), "/signals/table", o.id(),
                            "signals/x", H5P_DEFAULT, H5P_DEFAULT);
       },
       "holds no table there"},
      {"bytes of another file",
       [](Other& o, const std::string& where) {
         const hid_t properties = H5Pcreate(H5P_DATASET_CREATE);
         H5Pset_external(properties, (where + "/raw").c_str(), 0, 16);
         o.table("signals/x", {2, 1}, H5T_IEEE_F64LE, properties, {"t_s"});
       },
       "is no table"}};
  for (const Bad& bad : test::every(cases)) {
    {
      Other other(path);
      bad.make(other, folder.path());
    }
    SCOPED_TRACE(bad.what);
    const auto table = open_hdf5_table(path);
    ASSERT_FALSE(table.ok());
    EXPECT_NE(table.error().message().find(bad.said), std::string::npos) << table.error().message();
    EXPECT_NE(table.error().message().find("bad.h5"), std::string::npos);
  }
  for (const char* place : {"/nowhere", "/signals/x/y", ""})
    EXPECT_FALSE(open_hdf5_table(folder.path("elsewhere.h5"), place).ok()) << place;
  EXPECT_FALSE(open_hdf5_table(folder.path("raw")).ok());
  EXPECT_FALSE(open_hdf5_table(folder.path()).ok());
}

TEST(Hdf5Table, AnInfiniteNumberIsNamedWithItsRow) {
  const test::TemporaryFolder folder;
  Rows rows = some_rows(5000);
  rows[4500][2] = std::numeric_limits<double>::infinity();
  const auto table = must(open_hdf5_table(write(folder.path("t.h5"), rows)));
  std::vector<double> row(kNames.size());
  for (std::size_t k = 0; k < 4500; ++k) ASSERT_TRUE(must(table->next(row)));
  const auto refused = table->next(row);
  ASSERT_FALSE(refused.ok());
  EXPECT_NE(refused.error().message().find("t.h5:4501: thumb_fy_N: is not finite"),
            std::string::npos)
      << refused.error().message();
}

TEST(Hdf5Table, AFileThatWasCutOffIsRefused) {
  const test::TemporaryFolder folder;
  const std::string sound = bytes_of(write(folder.path("t.h5"), some_rows(20)));
  for (std::size_t bytes = 0; bytes < sound.size(); bytes += 97)
    EXPECT_FALSE(open_hdf5_table(folder.write("cut.h5", sound.substr(0, bytes))).ok()) << bytes;
}

}  // namespace
}  // namespace isograsp::exports::hdf5_table_test
