// SPDX-License-Identifier: GPL-3.0-or-later
// A stream of Qualisys Track Manager: where it is cut does not count, and what comes out is whole.
#include <cmath>
#include <vector>

#include "device/markers/qtm_rt_codec.hpp"
#include "tests/fuzz/support.hpp"

using namespace isograsp;

namespace {

/// Numbers of all rows; missing ones as a number, so that they compare.
std::vector<double> rows_of(std::span<const std::uint8_t> bytes, std::size_t piece, bool& good) {
  QtmRtStream stream;
  std::vector<double> numbers;
  good = true;
  for (std::size_t at = 0; good && at < bytes.size(); at += piece)
    good = stream
               .take(bytes.subspan(at, std::min(piece, bytes.size() - at)),
                     [&](const QtmRtStream::Row& row) {
                       fuzz::require(row.p_W.size() == stream.labels().size(),
                                     "a row has all markers");
                       numbers.push_back(static_cast<double>(row.stamp_us));
                       for (const Vec3& p : row.p_W)
                         for (const double c : p) numbers.push_back(std::isnan(c) ? -1.0 : c);
                     })
               .ok();
  return numbers;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::size_t kPiece = 7;
  bool whole = false, cut = false;
  const auto one = rows_of({data, size}, std::max<std::size_t>(size, 1), whole);
  const auto other = rows_of({data, size}, kPiece, cut);
  fuzz::require(whole == cut && one == other, "where the stream is cut does not count");
  return 0;
}
