// SPDX-License-Identifier: GPL-3.0-or-later
// The conversation with an RFT sensor on CAN.
#include "device/protocol/rft_session.hpp"

#include "device/config/rft_sensor.hpp"
#include "device/emulator/emulated_rft.hpp"
#include "tests/fuzz/conversation.hpp"

using namespace isograsp;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::size_t kFinger = 1;
  static const DeviceConfig config = DeviceConfig::standard(kRftFamily);
  const RftIds ids = config.sensors[kFinger].as<RftSensor>().ids;
  RftSession::Settings settings;
  settings.on_bus = ids;
  RftSession session(settings);
  const auto sensor = make_emulated_rft(kFinger, config);
  fuzz::Numbers in(data, size);
  fuzz::Conversation(session, *sensor).run(in, [&](fuzz::Numbers& numbers) {
    return fuzz::take_frame(numbers, numbers.byte() % 2 == 0 ? ids.first : ids.second, 8);
  });
  return 0;
}
