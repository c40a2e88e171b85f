// SPDX-License-Identifier: GPL-3.0-or-later
// Faults that emulated cameras play on purpose.
#include "device/emulator/marker_fault.hpp"

#include "tests/device/cameras/marker_servers.hpp"
#include "tests/support/every.hpp"
#include "tests/support/temporary_folder.hpp"

namespace isograsp::marker_fault_test {
namespace {

using test::must;
using Kind = EmulatedMarkerFault::Kind;

TEST(MarkerFaultWords, AreRead) {
  const auto swap = must(EmulatedMarkerFault::parse("swap=A:B@5s"));
  EXPECT_EQ(swap.kind, Kind::swap);
  EXPECT_EQ(swap.marker, "A");
  EXPECT_EQ(swap.other, "B");
  EXPECT_EQ(swap.at_s, 5.0);
  EXPECT_TRUE(swap.acts_at(1e5)) << "from then on";
  const auto freeze = must(EmulatedMarkerFault::parse("freeze=A:200ms@10s"));
  EXPECT_FALSE(freeze.acts_at(9.99));
  EXPECT_TRUE(freeze.acts_at(10.1));
  EXPECT_FALSE(freeze.acts_at(10.2));
  EXPECT_EQ(must(EmulatedMarkerFault::parse("drop=0.25")).probability, 0.25);
  EXPECT_EQ(must(EmulatedMarkerFault::parse("merge=4")).count, 4);
  EXPECT_EQ(must(EmulatedMarkerFault::parse("silence@1s")).duration_s, 0.0);
  EXPECT_TRUE(must(EmulatedMarkerFault::parse("split")).of_connection());
}

TEST(MarkerFaultWords, ThatAreWrongNameTheRemedy) {
  for (const auto& [text, part] : test::every(std::vector<std::pair<std::string, std::string>>{
           {"explode", "there is no such fault"},
           {"drop=2", "'2' is not a probability"},
           {"drop", "is not a probability"},
           {"swap=A@5s", "the name of a marker is missing"},
           {"freeze=A@5s", "the duration is not a time"},
           {"freeze=A:xs@5s", "the duration is not a time"},
           {"freeze=A:2s", "the instant is missing"},
           {"close", "the instant is missing"},
           {"close@soon", "'soon' is not a time"},
           {"split@5s", "the fault has no instant"},
           {"merge=1", "is not within 2"},
           {"silence=1s:2s@3s", "'2s' is too much"}})) {
    const auto fault = EmulatedMarkerFault::parse(text);
    ASSERT_FALSE(fault) << text;
    EXPECT_NE(fault.error().message().find(part), std::string::npos) << fault.error().message();
    EXPECT_NE(fault.error().message().find("freeze=F1:2s@5s"), std::string::npos);
  }
}

/// What a scene shows of marker 0 and 2 in each picture.
std::vector<Vec3> shown(const std::string& fault, std::size_t marker, std::size_t rows = 10) {
  auto scene = test::scene(test::marker_play(rows), {fault});
  std::vector<Vec3> all;
  while (scene.next_s()) all.push_back(scene.take().p_W[marker]);
  return all;
}

TEST(MarkerScene, PlaysEachFaultInItsTime) {
  const MarkerPlay play = test::marker_play(10);
  const auto sent = [&](std::size_t row, std::size_t marker) { return play.p_W[3 * row + marker]; };
  const auto swapped = shown("swap=A:C:30ms@20ms", 0);
  EXPECT_EQ(swapped[1], sent(1, 0));
  EXPECT_EQ(swapped[2], sent(2, 2));
  EXPECT_EQ(swapped[5], sent(5, 0));
  const auto frozen = shown("freeze=A:30ms@20ms", 0);
  EXPECT_EQ(frozen[4], sent(1, 0));
  EXPECT_EQ(frozen[5], sent(5, 0));
  EXPECT_FALSE(shown("hide=A:30ms@20ms", 0)[2].allFinite());
  EXPECT_EQ(shown("phantom=A:30ms@20ms", 0)[2], Vec3(sent(2, 0) + Vec3(0.1, 0, 0)));
}

TEST(MarkerScene, CountsItsFramesLikeCameras) {
  auto scene = test::scene(test::marker_play(10), {"restart@50ms", "silence=20ms@20ms"});
  std::vector<std::uint32_t> frames;
  std::vector<bool> sent;
  while (scene.next_s()) {
    const MarkerPicture picture = scene.take();
    frames.push_back(picture.frame);
    sent.push_back(picture.sent);
  }
  EXPECT_EQ(frames, (std::vector<std::uint32_t>{1, 2, 3, 4, 5, 1, 2, 3, 4, 5}));
  EXPECT_EQ(sent,
            (std::vector<bool>{true, true, false, false, true, true, true, true, true, true}));
  EXPECT_EQ(scene.counters().silent, 2U);
  EXPECT_EQ(scene.counters().restarts, 1U);
}

TEST(MarkerScene, BeginsAgainOnlyIfItShall) {
  MarkerPlay play = test::marker_play(3);
  play.repeat = true;
  auto scene = test::scene(std::move(play));
  std::vector<std::uint32_t> frames;
  for (int k = 0; k < 7; ++k) frames.push_back(scene.take().frame);
  EXPECT_EQ(frames, (std::vector<std::uint32_t>{1, 2, 3, 4, 5, 6, 7}));
}

TEST(MarkerScene, RefusesFaultsOfMarkersThatAreNotThere) {
  const auto scene = MarkerScene::make(test::marker_play(3),
                                       {must(EmulatedMarkerFault::parse("hide=Q:1s@0s"))}, 1);
  ASSERT_FALSE(scene);
  EXPECT_NE(scene.error().message().find("has no marker 'Q'"), std::string::npos);
  const auto split = open_natnet_server({test::kThisComputer, 0},
                                        test::scene(test::marker_play(3), {"split"}), {});
  ASSERT_FALSE(split);
  EXPECT_NE(split.error().message().find("NatNet has no connection"), std::string::npos);
}

TEST(MarkerPlay, IsReadFromARecording) {
  const test::TemporaryFolder folder;
  const auto play = must(MarkerPlay::read(
      folder.write("m.csv", "t_s,A_x_m,A_y_m,A_z_m\n3,1,2,3\n3.02,,,\n3.04,4,5,6\n")));
  EXPECT_EQ(play.labels, (std::vector<std::string>{"A"}));
  EXPECT_EQ(play.t_s.front(), 0.0);
  EXPECT_EQ(play.period_s, 0.02);
  EXPECT_FALSE(play.p_W[1].allFinite());
  EXPECT_FALSE(MarkerPlay::read(folder.write("o.csv", "t_s,A_x_m,A_y_m,A_z_m\n3,1,2,3\n")));
}

}  // namespace
}  // namespace isograsp::marker_fault_test
