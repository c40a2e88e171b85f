// SPDX-License-Identifier: GPL-3.0-or-later
// Datagrams of a Net F/T box: words come back, and anything in any order is counted somewhere.
#include "device/codec/net_ft_codec.hpp"
#include "device/codec/net_ft_sequence.hpp"
#include "tests/fuzz/support.hpp"

using namespace isograsp;

namespace {

void require_round_trip(std::span<const std::uint8_t> bytes) {
  const auto record = decode_net_ft_record(bytes);
  fuzz::require(record.has_value() == (bytes.size() == kNetFtRecord), "a record has 36 bytes");
  if (record) {
    const BusFrame frame = encode_net_ft_record(1, *record);
    fuzz::require(
        std::equal(bytes.begin(), bytes.end(), frame.bytes().begin(), frame.bytes().end()),
        "a record is its bytes");
    for (const auto product : {NetFtProduct::net_box, NetFtProduct::axia}) {
      const auto verdict = judge(*record, product);
      fuzz::require(!flag_words(*record, product).empty() || (verdict.valid() && !verdict.overload),
                    "what is wrong with a record is named");
    }
    const Wrench wrench = wrench_of(record->raw, {});
    fuzz::require(wrench.force.allFinite() && wrench.torque.allFinite(), "counts are newtons");
  }
  if (const auto request = decode_net_ft_request(bytes)) {
    const BusFrame frame = encode_net_ft_request(1, *request);
    fuzz::require(decode_net_ft_request(frame.bytes()) == request, "a request comes back");
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::Numbers in(data, size);
  NetFtSequence sequence;
  Timestamp now{0};
  const bool begun = in.byte() % 2 == 0;
  if (begun) sequence.start(now);
  std::uint64_t duplicate = 0;
  std::uint64_t late = 0;
  std::uint64_t impossible = 0;
  std::uint64_t stalled = 0;
  std::uint64_t restarts = 0;
  while (!in.empty()) {
    const auto bytes = in.bytes(in.byte() >= 0xF0 ? in.byte() : kNetFtRecord);
    require_round_trip(bytes);
    const auto record = decode_net_ft_record(bytes);
    if (!record) continue;
    now += std::chrono::milliseconds(1);
    const auto place = sequence.push(*record, now);
    using Place = NetFtSequence::Place;
    duplicate += place == Place::duplicate ? 1 : 0;
    late += place == Place::late || place == Place::unplaced ? 1 : 0;
    impossible += place == Place::impossible ? 1 : 0;
    stalled += place == Place::stalled ? 1 : 0;
    restarts += place == Place::restarted ? 1 : 0;
    fuzz::require(begun || place != Place::stale, "records are stale only after a start");
  }
  fuzz::require(sequence.duplicate() == duplicate && sequence.late() == late &&
                    sequence.impossible() == impossible && sequence.stalled() == stalled &&
                    sequence.restarts() == restarts,
                "the counters are the sums of what was said");
  // At each beginning a second of records may be under way, and 64 between the two that confirm it.
  const double most = 1.02 * kNetFtFastest_Hz * (to_seconds(now) + 0.01) +
                      (kNetFtFastest_Hz + 64.0) * static_cast<double>(1 + restarts);
  fuzz::require(static_cast<double>(sequence.lost()) <= most, "what is lost agrees with the time");
  return 0;
}
