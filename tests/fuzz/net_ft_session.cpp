// SPDX-License-Identifier: GPL-3.0-or-later
// The conversation with a Net F/T box.
#include "device/protocol/net_ft_session.hpp"

#include "device/config/net_ft_sensor.hpp"
#include "device/emulator/emulated_net_ft.hpp"
#include "tests/fuzz/conversation.hpp"

using namespace isograsp;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::size_t kFinger = 2;
  static const DeviceConfig config = DeviceConfig::standard(kNetFtFamily);
  NetFtSession session(config, kFinger, NetFtBoxConfig());
  const auto sensor = make_emulated_net_ft(kFinger, config);
  fuzz::Numbers in(data, size);
  fuzz::Conversation(session, *sensor).run(in, [](fuzz::Numbers& numbers) {
    BusFrame frame;
    frame.id = kFinger;
    const auto bytes = numbers.bytes(numbers.byte() < 0xF0 ? kNetFtRecord : 8);
    frame.length = static_cast<std::uint8_t>(bytes.size());
    std::copy(bytes.begin(), bytes.end(), frame.data.begin());
    return frame;
  });
  return 0;
}
