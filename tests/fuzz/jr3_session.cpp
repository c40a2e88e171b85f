// SPDX-License-Identifier: GPL-3.0-or-later
// The conversation with a JR3 sensor behind its CAN adaptor.
#include "device/protocol/jr3_session.hpp"

#include "device/config/jr3_sensor.hpp"
#include "device/emulator/emulated_jr3.hpp"
#include "tests/fuzz/conversation.hpp"

using namespace isograsp;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::size_t kFinger = 0;  // the one that sends the synchronisation
  static const DeviceConfig config = DeviceConfig::standard(kJr3Family);
  Jr3Session session(config, kFinger);
  const auto sensor = make_emulated_jr3(kFinger, config);
  fuzz::Numbers in(data, size);
  fuzz::Conversation(session, *sensor).run(in, [](fuzz::Numbers& numbers) {
    const std::uint32_t id = (numbers.byte() & 0xFU) << 7 | kJr3Nodes[kFinger];
    return fuzz::take_frame(numbers, id, 8);
  });
  return 0;
}
