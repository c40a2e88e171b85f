// SPDX-License-Identifier: GPL-3.0-or-later
// A device is asked before anybody relies on it: real datagrams of emulated boxes, a hand in
// software, and what is not there.
#include "session/ask_device.hpp"

#include <memory>

#include <gtest/gtest.h>

#include "tests/device/net_ft_boxes.hpp"
#include "tests/support/must.hpp"

namespace isograsp::session::ask_device_test {
namespace {

using test::Boxes;
using test::must;

const std::string kLibrary = ISOGRASP_SOURCE_DIR "/library";
constexpr int kLeastLooks = 80;  // in a second at 100 Hz, on a busy computer

EmulatorOptions boxes_with(const std::string& fault) {
  EmulatorOptions options;
  options.config = DeviceConfig::standard(kNetFtFamily);
  if (!fault.empty()) options.faults.push_back(*Fault::parse(fault));
  return options;
}

std::string uri_of(const Boxes& boxes) {
  return "udp://" + boxes.full_address(0) + "," + boxes.full_address(1) + "," +
         boxes.full_address(2) + "?protocol=net-ft";
}

TEST(AskDevice, BoxesInTheNetworkTellWhoTheyAreAndThatTheyWork) {
  const Boxes boxes(boxes_with(""));
  const auto answer = must(ask_device(uri_of(boxes), kLibrary));
  EXPECT_EQ(answer.kind, "platform");
  EXPECT_EQ(answer.sensors.size(), kFingerCount);
  EXPECT_GE(answer.frames, kLeastLooks);
  EXPECT_LT(answer.with_gap, answer.frames / 2);
  EXPECT_DOUBLE_EQ(answer.rate_Hz, 100.0);
  const auto again = ask_device(uri_of(boxes), kLibrary);
  EXPECT_TRUE(again.ok()) << "it was let go";
}

TEST(AskDevice, ASensorThatIsSilentIsNotTakenForOneThatWorks) {
  const Boxes boxes(boxes_with("silence=index:60s@0s"));
  const auto answer = ask_device(uri_of(boxes), kLibrary);
  if (answer) {
    EXPECT_FALSE(answer->good());
    EXPECT_GT(answer->frames, 0);
  } else {
    EXPECT_FALSE(answer.error().message().empty());
  }
}

TEST(AskDevice, AHandInSoftwareWorksForWhicheverHandItIs) {
  for (const char* uri : {"sim://healthy?seed=7&hand=left", "sim://healthy?seed=7&hand=right"}) {
    const auto answer = must(ask_device(uri, kLibrary));
    EXPECT_TRUE(answer.good()) << uri;
    EXPECT_GE(answer.frames, kLeastLooks) << uri;
  }
}

TEST(AskDevice, WhatIsNotThereIsSaidAsASessionWouldSayIt) {
  const auto missing = ask_device("can://nothere0?protocol=rft", kLibrary);
  ASSERT_FALSE(missing.ok());
  EXPECT_NE(missing.error().message().find("nothere0"), std::string::npos);
  EXPECT_FALSE(missing.error().remedy.empty());
}

TEST(AskDevice, WhoCancelsIsNotToldThatItWorks) {
  const auto stop = std::make_unique<std::stop_source>();
  stop->request_stop();
  EXPECT_FALSE(ask_device("sim://healthy?seed=7", kLibrary, stop->get_token()).ok());
}

}  // namespace
}  // namespace isograsp::session::ask_device_test
