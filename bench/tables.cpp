// SPDX-License-Identifier: GPL-3.0-or-later
// bench_tables hour FORCES OUT…: the recording 60 times one after the other, as text or HDF5.
// bench_tables alone FORCES OUT: what `isograsp simulate` does but the motion: times, then rows are
// read, and a row of the trajectory is written for each, of numbers with all their digits.
#include <array>
#include <cstdio>
#include <stdexcept>

#include "core/csv.hpp"
#include "exports/hdf5_table.hpp"
#include "hand/finger_forces.hpp"
#include "tests/support/must.hpp"

namespace isograsp {

namespace {

using test::must;

bool is_hdf5(const std::string& path) {
  return path.ends_with(".h5");
}

Result<std::unique_ptr<TableReader>> open_any(const std::string& path) {
  return is_hdf5(path) ? exports::open_hdf5_table(path) : open_csv(path);
}

std::unique_ptr<TableWriter> create_any(const std::string& path,
                                        const std::vector<std::string>& columns) {
  return must(is_hdf5(path) ? exports::create_hdf5_table(path, columns)
                            : CsvWriter::create(path, columns));
}

void make_hour(const std::string& forces, const std::string& out) {
  constexpr int kMinutes = 60;
  const double step_s = must(read_time_grid(forces)).hold_s;
  std::vector<std::vector<double>> rows;
  const auto given = must(open_csv(forces));
  std::vector<double> row(given->columns().size());
  while (must(given->next(row))) rows.push_back(row);
  const std::size_t time = *given->find("t_s");
  const auto table = create_any(out, given->columns());
  std::size_t k = 0;
  for (int minute = 0; minute < kMinutes; ++minute)
    for (auto& repeated : rows) {
      repeated[time] = step_s * static_cast<double>(k++);
      table->add(repeated);
    }
  must(table->commit());
}

void read_and_write(const std::string& forces, const std::string& out) {
  static_cast<void>(must(read_time_grid([&] { return open_any(forces); })));
  auto reader = must(FingerForcesReader::open(must(open_any(forces))));
  constexpr std::size_t kColumns = 23;
  std::vector<std::string> names;
  for (std::size_t c = 0; c < kColumns; ++c) names.push_back("c" + std::to_string(c));
  const auto table = create_any(out, names);
  std::array<double, kColumns> numbers{};
  FingerForcesRow row;
  while (must(reader.next(row))) {
    numbers[0] = row.t_s;
    for (std::size_t c = 1; c < kColumns - kFingerCount; ++c)
      numbers[c] = row.wrench_C[c % kFingerCount].force[static_cast<Eigen::Index>(c / 3 % 3)] /
                   static_cast<double>(2 * c + 1);
    for (std::size_t f = 0; f < kFingerCount; ++f)
      numbers[kColumns - kFingerCount + f] = row.wrench_C[f].force.z() > 0.0 ? 1.0 : 0.0;
    table->add(numbers);
  }
  must(table->commit());
}

}  // namespace

}  // namespace isograsp

int main(int count, char** words) {
  try {
    if (count == 4 && std::string(words[1]) == "alone")
      isograsp::read_and_write(words[2], words[3]);
    else if (count > 3 && std::string(words[1]) == "hour")
      for (int k = 3; k < count; ++k) isograsp::make_hour(words[2], words[k]);
    else
      throw std::runtime_error("usage: bench_tables hour FORCES OUT… | alone FORCES OUT");
    return 0;
  } catch (const std::exception& why) {
    std::fprintf(stderr, "bench_tables: %s\n", why.what());
    return 1;
  }
}
