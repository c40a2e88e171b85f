// SPDX-License-Identifier: GPL-3.0-or-later
// The conversation with an ATI NETCANOEM sensor.
#include "device/protocol/ati_session.hpp"

#include "device/config/ati_sensor.hpp"
#include "device/emulator/emulated_ati.hpp"
#include "tests/fuzz/conversation.hpp"

using namespace isograsp;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::size_t kFinger = 1;
  static const DeviceConfig config = DeviceConfig::standard(kAtiFamily);
  AtiSession session(config, kFinger);
  const auto sensor = make_emulated_ati(kFinger, config);
  fuzz::Numbers in(data, size);
  fuzz::Conversation(session, *sensor).run(in, [](fuzz::Numbers& numbers) {
    const std::uint32_t id = kAtiBases[kFinger] << 4 | (numbers.byte() & 0xF);
    return fuzz::take_frame(numbers, id, 8);
  });
  return 0;
}
