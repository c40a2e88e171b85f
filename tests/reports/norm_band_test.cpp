// SPDX-License-Identifier: GPL-3.0-or-later
// Means of healthy people, whatever their size.
#include "reports/findings/norm_band.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "reports/findings/comparable.hpp"
#include "tests/support/every.hpp"

namespace isograsp::reports::norm_band_test {
namespace {

TEST(NormBand, OfValuesNearTheLargestNumberIsMadeOfTheirMeans) {
  constexpr double kHuge = 1.7e308;
  storage::SessionRecord session;
  session.patient_id = 1;
  session.started_utc = "2026-03-02T09:30:00Z";
  session.rate_Hz = 100.0;
  StoredTrial like;
  like.session_record = &session;
  storage::PatientProfile profile;
  profile.sex = storage::Sex::female;
  profile.dominant = Hand::right;
  profile.birth_year = 1961;
  std::vector<storage::PooledValue> healthy;
  for (storage::RowId person = 2; person < 24; ++person)
    for (const double share : {1.0, 0.9}) {
      storage::PooledValue one;
      one.patient_id = person;
      one.started_utc = session.started_utc;
      one.dominant = Hand::right;
      one.sex = storage::Sex::female;
      one.birth_year = 1961;
      one.rate_Hz = session.rate_Hz;
      one.value = kHuge * share;
      healthy.push_back(one);
    }
  const auto band = norm_band(healthy, like, profile, false);
  ASSERT_TRUE(band && band->low && band->high);
  for (const double value : test::every(band->values)) EXPECT_DOUBLE_EQ(value, 0.95 * kHuge);
  EXPECT_DOUBLE_EQ(*band->low, 0.95 * kHuge);
}

}  // namespace
}  // namespace isograsp::reports::norm_band_test
