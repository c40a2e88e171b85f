// SPDX-License-Identifier: GPL-3.0-or-later
// Blocks of the database: anything is decoded or refused, and what was encoded comes back.
#include "storage/sqlite/block_codec.hpp"

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
    std::vector<std::vector<double>> decoded(columns);
    if (!storage::decode_block(fuzz::as_text(rest.data(), rest.size()), rows, decoded)) return 0;
    for (std::size_t i = 0; i < rows * columns; ++i)
      values.push_back(decoded[i % columns].at(i / columns));
  }
  std::vector<std::vector<double>> again(columns);
  fuzz::require(storage::decode_block(storage::encode_block(values, columns), rows, again),
                "a block is whole");
  for (std::size_t i = 0; i < values.size(); ++i)
    fuzz::require(fuzz::same_bits(values[i], again[i % columns].at(i / columns)),
                  "what was encoded comes back to the last bit");
  return 0;
}
