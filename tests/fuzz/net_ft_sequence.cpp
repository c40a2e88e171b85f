// SPDX-License-Identifier: GPL-3.0-or-later
// A Net F/T box whose datagrams are lost, repeated and held back by the input: what was lost is
// lost() - late(), what came twice is duplicate(), also where the numbers wrap.
#include "device/codec/net_ft_sequence.hpp"

#include <deque>

#include "tests/fuzz/support.hpp"

using namespace isograsp;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::uint32_t kLatest = 60;  // records; 63 may be held back
  fuzz::Numbers in(data, size);
  NetFtSequence sequence;
  NetFtRecord record;
  record.rdt_sequence = 1;
  if (in.byte() % 2 == 0)
    sequence.start(Timestamp(0));
  else
    record.rdt_sequence = in.number<std::uint32_t>();
  record.ft_sequence = in.number<std::uint32_t>();
  const std::uint32_t ft_step = 1 + in.byte() % 80U;  // measurements inside the box per record
  Timestamp now{0};
  std::deque<NetFtRecord> held;
  std::uint64_t lost = 0;
  std::uint64_t twice = 0;
  const auto push = [&](const NetFtRecord& what) {
    const auto place = sequence.push(what, now);
    fuzz::require(place == NetFtSequence::Place::in_order || place == NetFtSequence::Place::late ||
                      place == NetFtSequence::Place::duplicate,
                  "a box that only goes on has no other records");
  };
  push(record);
  while (!in.empty()) {
    const std::uint8_t fate = in.byte();
    now += std::chrono::milliseconds(10);
    ++record.rdt_sequence;
    record.ft_sequence += ft_step;
    const bool last = in.empty();
    switch (last ? 0 : fate % 6) {
      case 1: ++lost; break;
      case 2: held.push_back(record); break;
      case 3:
        push(record);
        push(record);
        ++twice;
        break;
      case 4:
        push(record);
        held.push_back(record);
        ++twice;
        break;
      case 5:
        push(record);
        if (!held.empty()) {
          push(held.back());
          held.pop_back();
        }
        break;
      default: push(record);
    }
    // Held back is held back for a while, not for ever.
    while (!held.empty() && (last || record.rdt_sequence - held.front().rdt_sequence >= kLatest)) {
      push(held.front());
      held.pop_front();
    }
  }
  fuzz::require(sequence.lost() - sequence.late() == lost, "what was lost is counted");
  fuzz::require(sequence.duplicate() == twice, "what came twice is counted");
  fuzz::require(sequence.restarts() == 0 && sequence.stalled() == 0, "nothing else happened");
  return 0;
}
