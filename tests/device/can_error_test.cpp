// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/bus/can_error.hpp"

#include <gtest/gtest.h>

namespace isograsp::can_error_test {
namespace {

// Class bits and controller bits as the kernel documents them (linux/can/error.h).
constexpr std::uint32_t kController = 0x4;
constexpr std::uint32_t kProtocol = 0x8;
constexpr std::uint32_t kBusOff = 0x40;
constexpr std::uint32_t kBusError = 0x80;
constexpr std::uint32_t kRestarted = 0x100;
constexpr std::uint32_t kCounters = 0x200;

CanErrorNews read(std::uint32_t classes, std::uint8_t controller) {
  BusFrame frame;
  frame.error = true;
  frame.id = classes;
  frame.length = 8;
  frame.data[1] = controller;
  return read_can_error(frame);
}

TEST(CanError, ReceiverAndTransmitterBitsSayTheSame) {
  for (const auto& [receiver, transmitter, event] :
       {std::tuple{0x04, 0x08, BusEvent::error_warning}, {0x10, 0x20, BusEvent::error_passive}})
    for (const int bits : {receiver, transmitter, receiver | transmitter})
      EXPECT_EQ(read(kController, static_cast<std::uint8_t>(bits)).state, event) << bits;
}

TEST(CanError, TheWorstStateOfAFrameIsTold) {
  for (int bits = 0; bits < 256; ++bits) {
    const auto controller = static_cast<std::uint8_t>(bits);
    EXPECT_EQ(read(kController | kBusOff | kRestarted, controller).state, BusEvent::bus_off);
    const auto state = read(kController, controller).state;
    if ((bits & 0x30) != 0)
      EXPECT_EQ(state, BusEvent::error_passive);
    else if ((bits & 0x0C) != 0)
      EXPECT_EQ(state, BusEvent::error_warning);
    else if ((bits & 0x40) != 0)
      EXPECT_EQ(state, BusEvent::error_active);
    else
      EXPECT_EQ(state, std::nullopt);
  }
}

TEST(CanError, AnOverflowIsToldBesideTheState) {
  for (int bits = 0; bits < 256; ++bits)
    EXPECT_EQ(read(kController, static_cast<std::uint8_t>(bits)).overflow, (bits & 0x03) != 0);
}

TEST(CanError, ControllerBitsCountOnlyInFramesOfThatClass) {
  for (const std::uint32_t classes : {kProtocol | kBusError, kRestarted, kBusOff}) {
    const CanErrorNews news = read(classes, 0xFF);
    EXPECT_FALSE(news.overflow);
    EXPECT_NE(news.state, BusEvent::error_passive);
  }
}

TEST(CanError, DisturbedFramesOnTheWireAreNoNews) {
  // Bit error, missing acknowledgement and lost arbitration, as the slcan driver and others send
  // them.
  for (const std::uint32_t classes : {0x88U, 0xA8U, 0x20U, 0x1U, 0x2U, 0x10U, kCounters})
    EXPECT_EQ(read(classes, 0).state, std::nullopt) << classes;
}

TEST(CanError, FramesOfTheSlcanDriver) {
  EXPECT_EQ(read(kController | kCounters, 0x04).state, BusEvent::error_warning);
  EXPECT_EQ(read(kController | kCounters, 0x10).state, BusEvent::error_passive);
  EXPECT_EQ(read(kController | kCounters, 0x40).state, BusEvent::error_active);
  EXPECT_EQ(read(kBusOff, 0).state, BusEvent::bus_off);
  EXPECT_EQ(read(kRestarted, 0).state, BusEvent::restarted);
  EXPECT_TRUE(read(kController | kProtocol | kBusError, 0x02).overflow);
}

}  // namespace
}  // namespace isograsp::can_error_test
