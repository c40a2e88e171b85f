// SPDX-License-Identifier: GPL-3.0-or-later
// Datagrams of a NatNet stream, each behind two bytes of its length: whatever they hold, a row is
// whole, and what comes twice means the same twice.
#include <cmath>
#include <vector>

#include "device/markers/natnet_codec.hpp"
#include "tests/fuzz/support.hpp"

using namespace isograsp;

namespace {

/// Numbers of all rows; missing ones as a number, so that they compare.
std::vector<double> rows_of(std::span<const std::uint8_t> bytes) {
  NatNetStream stream;
  NatNetStream::Row row;
  std::vector<double> numbers;
  fuzz::Numbers input(bytes.data(), bytes.size());
  while (!input.empty()) {
    const auto size = input.number<std::uint16_t>();
    if (stream.take(input.bytes(size), row) != NatNetStream::Step::row) continue;
    fuzz::require(row.p_W.size() == stream.labels().size(), "a row has all markers");
    fuzz::require(std::isfinite(row.stamp_s), "a row has a time");
    numbers.push_back(row.stamp_s);
    for (const Vec3& p : row.p_W) {
      fuzz::require(p.allFinite() || p.array().isNaN().all(), "a position is whole or missing");
      for (const double c : p) numbers.push_back(std::isnan(c) ? -1.0 : c);
    }
  }
  const NatNetCounts& counts = stream.counts();
  fuzz::require(
      counts.frames + counts.unlabelled + counts.damaged + counts.passed_over <= counts.datagrams,
      "every datagram counts once");
  return numbers;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::require(rows_of({data, size}) == rows_of({data, size}), "the same bytes, the same rows");
  return 0;
}
