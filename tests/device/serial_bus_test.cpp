// SPDX-License-Identifier: GPL-3.0-or-later
// On pseudo-terminals: what a USB adapter looks like from a program. Waiting times are only upper
// bounds.
#include <array>
#include <filesystem>
#include <memory>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <stdlib.h>
#include <termios.h>
#include <unistd.h>

#include "device/bus/bus.hpp"
#include "device/codec/rft_stream.hpp"
#include "tests/device/hex.hpp"
#include "tests/support/every.hpp"
#include "tests/support/no_alloc.hpp"
#include "tests/support/temporary_folder.hpp"

namespace isograsp::serial_bus_test {
namespace {

using namespace std::chrono_literals;
using test::Bytes;

constexpr Timestamp kPatience = 5s;  // for what comes at once

/// The sensor's end of a serial line.
class Line {
 public:
  Line() : end_(::posix_openpt(O_RDWR | O_NOCTTY)) {
    EXPECT_GE(end_, 0);
    EXPECT_EQ(::grantpt(end_), 0);
    EXPECT_EQ(::unlockpt(end_), 0);
    name_ = ::ptsname(end_);
  }
  ~Line() { ::close(end_); }
  Line(const Line&) = delete;
  Line& operator=(const Line&) = delete;

  [[nodiscard]] const std::string& name() const { return name_; }
  void send(std::span<const std::uint8_t> bytes) const {
    EXPECT_EQ(::write(end_, bytes.data(), bytes.size()), static_cast<ssize_t>(bytes.size()));
  }
  [[nodiscard]] Bytes receive(std::size_t length) const {
    Bytes bytes(length);
    std::size_t have = 0;
    while (have < length) {
      const auto n = ::read(end_, bytes.data() + have, length - have);
      if (n <= 0) break;
      have += static_cast<std::size_t>(n);
    }
    bytes.resize(have);
    return bytes;
  }
  [[nodiscard]] termios settings() const {
    termios found{};
    EXPECT_EQ(::tcgetattr(end_, &found), 0);
    return found;
  }

 private:
  int end_;
  std::string name_;
};

class SerialBus : public testing::Test {
 protected:
  SerialBus() {
    for (std::size_t f = 0; f < kFingerCount; ++f) plug(f);
    auto opened = open_serial({port(0), port(1), port(2)}, 460800);
    EXPECT_TRUE(opened) << opened.error().message();
    bus = *std::move(opened);
    EXPECT_TRUE(bus->start(clock));
  }
  [[nodiscard]] std::string port(std::size_t sensor) const {
    return folder.path("ttyUSB" + std::to_string(sensor));
  }
  void plug(std::size_t sensor) {
    lines[sensor] = std::make_unique<Line>();
    std::filesystem::create_symlink(lines[sensor]->name(), port(sensor));
  }
  void unplug(std::size_t sensor) {
    std::filesystem::remove(port(sensor));
    lines[sensor].reset();
  }
  BusEvent receive(ReceivedFrame& out) { return bus->receive(clock.now() + kPatience, out); }

  test::TemporaryFolder folder;
  std::array<std::unique_ptr<Line>, kFingerCount> lines;
  SteadyClock clock;
  std::unique_ptr<Bus> bus;
  ReceivedFrame in;
};

TEST_F(SerialBus, EveryByteArrivesInOrderInSmallPieces) {
  std::mt19937_64 random(1);
  std::array<Bytes, kFingerCount> sent;
  std::array<Bytes, kFingerCount> received;
  for (int round = 0; round < 100; ++round) {
    std::size_t due = 0;
    for (std::size_t f = 0; f < kFingerCount; ++f) {
      Bytes piece(1 + random() % 60);
      for (auto& byte : piece) byte = static_cast<std::uint8_t>(random());  // also ^C, ^S, CR, 0
      lines[f]->send(piece);
      due += piece.size();
      sent[f].insert(sent[f].end(), piece.begin(), piece.end());
    }
    while (due > 0) {
      ASSERT_EQ(receive(in), BusEvent::frame);
      ASSERT_LE(in.frame.length, 16);
      ASSERT_LT(in.frame.id, kFingerCount);
      due -= in.frame.length;
      const auto bytes = in.frame.bytes();
      received[in.frame.id].insert(received[in.frame.id].end(), bytes.begin(), bytes.end());
    }
  }
  EXPECT_EQ(received, sent);
  EXPECT_EQ(bus->receive(clock.now(), in), BusEvent::timeout);
}

TEST_F(SerialBus, TheLineIsRawEightBitsWithoutParityAtItsRate) {
  const termios settings = lines[1]->settings();
  EXPECT_EQ(settings.c_cflag & CSIZE, static_cast<tcflag_t>(CS8));
  EXPECT_EQ(settings.c_cflag & (PARENB | CSTOPB | CRTSCTS), 0u);
  EXPECT_EQ(settings.c_lflag & (ICANON | ECHO | ISIG), 0u);
  EXPECT_EQ(settings.c_iflag & (IXON | IXOFF | ICRNL | ISTRIP), 0u);
  EXPECT_EQ(settings.c_oflag & OPOST, 0u);
  EXPECT_EQ(cfgetospeed(&settings), static_cast<speed_t>(B460800));
}

TEST_F(SerialBus, FramesLeaveThroughTheirPort) {
  for (std::uint32_t f = 0; f < kFingerCount; ++f) {
    const auto command = encode_stream_command(f, RftCommand::set_rate, {4});
    EXPECT_TRUE(bus->send(command));
    EXPECT_EQ(lines[f]->receive(command.length), test::bytes_of(command));
  }
}

TEST_F(SerialBus, PacketsOfThreeSensorsAreFoundWithTheTimeOfTheirLastByte) {
  std::array<RftStream, kFingerCount> streams;
  std::array<int, kFingerCount> found{};
  for (int n = 0; n < 200; ++n) {
    const Timestamp before = clock.now();
    for (std::uint32_t f = 0; f < kFingerCount; ++f)
      lines[f]->send(
          encode_stream_counts(f, {{n, -n, static_cast<int>(f), 0x55, 0x55AA, 0}, 0}).bytes());
    for (std::size_t due = kFingerCount; due > 0;) {
      ASSERT_EQ(receive(in), BusEvent::frame);
      const auto packet = streams[in.frame.id].push(in.frame.bytes(), in.stamp);
      if (!packet) continue;
      --due;
      const auto counts = decode_counts(*packet);
      EXPECT_EQ(counts.raw[0], n);
      EXPECT_EQ(counts.raw[2], static_cast<int>(in.frame.id));
      EXPECT_GE(packet->stamp, before);
      EXPECT_LE(packet->stamp, clock.now());
      ++found[in.frame.id];
    }
  }
  EXPECT_EQ(found, (std::array<int, kFingerCount>{200, 200, 200}));
  for (const auto& stream : test::every(streams)) EXPECT_EQ(stream.torn() + stream.foreign(), 0u);
}

TEST_F(SerialBus, AnUnpluggedAdapterIsToldOnceAndReopenedByItsName) {
  unplug(1);
  EXPECT_EQ(receive(in), BusEvent::interface_gone);
  lines[0]->send(test::hex("01 02"));
  ASSERT_EQ(receive(in), BusEvent::frame) << "the others go on";
  EXPECT_EQ(in.frame.id, 0u);
  EXPECT_TRUE(bus->send(encode_stream_command(1, RftCommand::stop))) << "given up, and counted";
  EXPECT_EQ(bus->counters().unsent, 1u);
  EXPECT_EQ(bus->receive(clock.now() + 300ms, in), BusEvent::timeout) << "told once";

  plug(1);  // another device file, the same name
  const auto command = encode_stream_command(1, RftCommand::serial_number);
  const Timestamp limit = clock.now() + kPatience;
  for (auto unsent = bus->counters().unsent; clock.now() < limit;) {
    (void)bus->receive(clock.now() + 10ms, in);
    (void)bus->send(command);
    if (bus->counters().unsent == std::exchange(unsent, bus->counters().unsent)) break;
  }
  EXPECT_EQ(lines[1]->receive(command.length), test::bytes_of(command));
  lines[1]->send(test::hex("55 AA"));
  ASSERT_EQ(receive(in), BusEvent::frame);
  EXPECT_EQ(in.frame.id, 1u);
  EXPECT_EQ(test::bytes_of(in.frame), test::hex("55 AA"));
}

TEST_F(SerialBus, DoesNotAllocate) {
  (void)bus->receive(clock.now() + 1ms, in);
  const auto packet = encode_stream_counts(0, {{1, 2, 3, 4, 5, 6}, 0});
  const auto before = test::allocations();
  std::size_t received = 0;
  for (int n = 0; n < 100; ++n) {
    (void)::usleep(10);
    lines[0]->send(packet.bytes());
    for (std::size_t bytes = 0; bytes < packet.length;) {
      if (bus->receive(clock.now() + kPatience, in) != BusEvent::frame) break;
      bytes += in.frame.length;
      received += in.frame.length;
    }
    (void)bus->receive(clock.now() + 1ms, in);
  }
  EXPECT_EQ(test::allocations(), before);
  EXPECT_EQ(received, 100u * packet.length);
}

TEST(SerialBusErrors, NameThePort) {
  const Line a;
  const Line b;
  const auto missing = open_serial({a.name(), "/dev/no-such-port", b.name()}, 115200);
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().field, "/dev/no-such-port");
  EXPECT_EQ(missing.error().code, Error::Code::bad_input);
  const auto twice = open_serial({a.name(), b.name(), a.name()}, 115200);
  ASSERT_FALSE(twice);
  EXPECT_EQ(twice.error().field, a.name());
  const Line c;
  EXPECT_FALSE(open_serial({a.name(), b.name(), c.name()}, 123)) << "no such rate";
  EXPECT_FALSE(open_serial({a.name(), b.name(), "/dev/null"}, 115200)) << "no serial port";
  const Line d;
  const auto bus = open_serial({a.name(), b.name(), d.name()}, 115200);
  ASSERT_TRUE(bus) << bus.error().message();
  ManualClock virtual_clock;
  EXPECT_FALSE((*bus)->start(virtual_clock));
}

}  // namespace
}  // namespace isograsp::serial_bus_test
