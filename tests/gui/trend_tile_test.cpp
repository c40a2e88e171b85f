// SPDX-License-Identifier: GPL-3.0-or-later
// What tells two measures apart is never cut off.
#include "gui/record_pages/trend_tile.hpp"

#include <array>

#include "gui/words/words.hpp"
#include "qt_test.hpp"
#include "spoken.hpp"
#include "tests/support/every_language.hpp"

namespace isograsp::gui::test::trend_tile_test {
namespace {

class TrendTiles : public QtTest, public ::testing::WithParamInterface<const char*> {};
INSTANTIATE_TEST_SUITE_P(, TrendTiles, ::testing::ValuesIn(test::every_language()),
                         test::code_of_language);

QImage tile_of(const char* measure, const char* channel, Hand hand = Hand::right) {
  MeasureTrend trend;
  trend.title = measure_title({measure, channel, 12.3, "N", 1, 1, 0, ""});
  trend.task = QStringLiteral("SIMULATED · Maximum force of one digit, as hard as possible · ") +
               hand_words(hand);
  trend.last = "12.3 N";
  TrendTile tile(trend);
  tile.resize(tile.minimumSizeHint().expandedTo(tile.minimumSize()));
  return tile.grab().toImage();
}

TEST_P(TrendTiles, OfTwoFingersLookDifferent) {
  const Spoken spoken(GetParam());
  for (const char* measure : {"maximum_force", "comfortable_force", "maximum_window_mean"}) {
    constexpr std::array kChannels{"thumb", "index", "middle", "thumb_-z", "index_-z", "middle_-z"};
    for (std::size_t a = 0; a < kChannels.size(); ++a)
      for (std::size_t b = a + 1; b < kChannels.size(); ++b)
        EXPECT_NE(tile_of(measure, kChannels[a]), tile_of(measure, kChannels[b]))
            << measure << " " << kChannels[a] << " " << kChannels[b];
  }
}

TEST_P(TrendTiles, OfTwoHandsLookDifferent) {
  const Spoken spoken(GetParam());
  EXPECT_NE(tile_of("maximum_force", "thumb", Hand::left),
            tile_of("maximum_force", "thumb", Hand::right));
}

TEST_P(TrendTiles, OfOneMeasureLookTheSame) {
  const Spoken spoken(GetParam());
  EXPECT_EQ(tile_of("maximum_force", "thumb"), tile_of("maximum_force", "thumb"));
}

}  // namespace
}  // namespace isograsp::gui::test::trend_tile_test
