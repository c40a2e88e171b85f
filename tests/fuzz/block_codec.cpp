// SPDX-License-Identifier: GPL-3.0-or-later
// Blocks of the database: anything is decoded or refused, and what was encoded comes back.
#include "storage/block_codec.hpp"

#include "tests/fuzz/support.hpp"

using namespace isograsp;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::Numbers in(data, size);
  const std::size_t rows = in.byte();
  const std::size_t columns = 1 + in.byte() % 16U;
  const bool encode = in.byte() % 2 != 0;
  std::vector<double> values;
  if (encode) {
    while (!in.empty()) values.push_back(std::bit_cast<double>(in.number<std::uint64_t>()));
    values.resize(rows * columns);
  } else {
    const auto rest = in.bytes(size);
    auto decoded = decode_block(fuzz::text_of(rest.data(), rest.size()), rows, columns);
    if (!decoded) return 0;
    values = std::move(*decoded);
    fuzz::require(values.size() == rows * columns, "a block has the size that was asked for");
  }
  const auto again = decode_block(encode_block(values, columns), rows, columns);
  fuzz::require(again && std::equal(values.begin(), values.end(), again->begin(), again->end(),
                                    fuzz::same_bits),
                "what was encoded comes back to the last bit");
  return 0;
}
