// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/config/uri.hpp"

#include <gtest/gtest.h>

namespace isograsp::uri_test {
namespace {

TEST(Uri, SplitsSchemeTargetAndParameters) {
  const auto uri = Uri::parse("can://can0?protocol=rft&config=a%20b%26c.toml");
  ASSERT_TRUE(uri.ok());
  EXPECT_EQ(uri->scheme, "can");
  EXPECT_EQ(uri->target, "can0");
  EXPECT_EQ(uri->text_or("protocol", ""), "rft");
  EXPECT_EQ(uri->text_or("config", ""), "a b&c.toml");
  EXPECT_EQ(uri->text_or("rate", "100"), "100");
}

TEST(Uri, KeepsAbsoluteAndRelativePaths) {
  EXPECT_EQ(Uri::parse("replay:///tmp/x.csv?speed=1")->target, "/tmp/x.csv");
  EXPECT_EQ(Uri::parse("replay://folder/x.csv")->target, "folder/x.csv");
}

TEST(Uri, RefusesWhatIsNotAUri) {
  for (const char* text :
       {"", "can0", "can:can0", "://x", "Can Bus://x", "can://a?", "can://a?b", "can://a?=b",
        "can://a?b=1&b=2", "can://a?b=1&", "can://%4", "can://%zz", "can://a?b=%"})
    EXPECT_FALSE(Uri::parse(text).ok()) << text;
}

TEST(Uri, NamesTheUnknownParameterAndThoseThatExist) {
  const auto known = Uri::parse("can://can0?protcol=rft")->require_known({"protocol", "rate"});
  ASSERT_FALSE(known.ok());
  EXPECT_EQ(known.error().message(),
            "can://can0?protcol=rft: protcol: unknown parameter of can://; use protocol, rate");
  EXPECT_TRUE(Uri::parse("can://can0?rate=1")->require_known({"protocol", "rate"}).ok());
}

TEST(Uri, ReadsNumbersWithinTheirLimitsOnly) {
  const auto uri = Uri::parse("sim://healthy?a=7&b=x&c=1e3&d=nan");
  EXPECT_EQ(uri->number_or("a", 0, 0, 10).value(), 7.0);
  EXPECT_EQ(uri->number_or("absent", 2.5, 0, 10).value(), 2.5);
  EXPECT_FALSE(uri->number_or("b", 0, 0, 10).ok());
  EXPECT_FALSE(uri->number_or("c", 0, 0, 10).ok());
  EXPECT_FALSE(uri->number_or("d", 0, 0, 10).ok());
}

}  // namespace
}  // namespace isograsp::uri_test
