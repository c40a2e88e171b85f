// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/codec/net_ft_box_config.hpp"

#include <string>

#include <gtest/gtest.h>

namespace isograsp::net_ft_box_config_test {
namespace {

const std::string kPage = R"(<?xml version="1.0"?>
<netft>
<runstat>0x00000000</runstat><runrate>7000</runrate>
<prodname>ATI Net F/T</prodname>
<cfgnam>clinic</cfgnam><cfgcalsel>0</cfgcalsel><cfgcalsn>FT27462</cfgcalsn>
<scfgfu>N</scfgfu><scfgtu>Nm</scfgtu>
<cfgtfx>0;0;0.000;0;0;0</cfgtfx>
<cfgcpf>1000000</cfgcpf><cfgcpt>2000000</cfgcpt>
<cfgmr>330;330;990;30;30;30</cfgmr>
<setuserfilter>5</setuserfilter>
<comrdte>Enabled</comrdte><comrdtrate>100</comrdtrate><comrdtbsiz>1</comrdtbsiz>
</netft>)";

std::string with(const std::string& element, const std::string& value) {
  std::string page = kPage;
  const auto begin = page.find("<" + element + ">") + element.size() + 2;
  return page.replace(begin, page.find("</" + element, begin) - begin, value);
}
std::string without(const std::string& element) {
  std::string page = kPage;
  const auto begin = page.find("<" + element + ">");
  const auto end = page.find("</" + element + ">") + element.size() + 3;
  return page.erase(begin, end - begin);
}
Result<NetFtBoxConfig> parse(const std::string& page) {
  return NetFtBoxConfig::parse(page, "http://192.168.1.1/netftapi2.xml");
}

TEST(NetFtBoxConfig, ReadsWhatTheBoxSays) {
  const auto config = parse(kPage);
  ASSERT_TRUE(config) << config.error().message();
  EXPECT_EQ(config->product, NetFtProduct::net_box);
  EXPECT_EQ(config->product_name, "ATI Net F/T");
  EXPECT_EQ(config->serial_number, "FT27462");
  EXPECT_EQ(config->scale.counts_per_unit_force, 1e6);
  EXPECT_EQ(config->scale.counts_per_unit_torque, 2e6);
  EXPECT_EQ(config->scale.unit_force_N, 1.0);
  EXPECT_EQ(config->scale.unit_torque_Nm, 1.0);
  EXPECT_EQ(config->rate_Hz, 100.0);
  EXPECT_EQ(config->filter_Hz, 35.0);
  EXPECT_FALSE(config->transformed);
  ASSERT_TRUE(config->range.has_value());
  EXPECT_EQ((*config->range)[2], 990.0);
}

TEST(NetFtBoxConfig, ChoosesTheStatusMapByTheProduct) {
  EXPECT_EQ(parse(with("prodname", "Ethernet Axia"))->product, NetFtProduct::axia);
  EXPECT_EQ(parse(with("prodname", "FTN-AXIA80"))->product, NetFtProduct::axia);
  EXPECT_EQ(parse(with("prodname", "Axia"))->filter_Hz, std::nullopt)
      << "an Axia numbers its filters otherwise";
  EXPECT_EQ(parse(without("prodname"))->product, NetFtProduct::net_box);
  EXPECT_EQ(parse(without("prodname"))->product_name, "");
}

TEST(NetFtBoxConfig, KnowsTheUnitsOfTheManual) {
  EXPECT_EQ(net_ft_force_unit_N("N"), 1.0);
  EXPECT_EQ(net_ft_force_unit_N("kN"), 1000.0);
  EXPECT_EQ(net_ft_force_unit_N("lbf"), 4.4482216152605);
  EXPECT_DOUBLE_EQ(net_ft_force_unit_N("klbf").value(), 4448.2216152605);
  EXPECT_EQ(net_ft_force_unit_N("kgf"), 9.80665);
  EXPECT_DOUBLE_EQ(net_ft_force_unit_N("gf").value(), 0.00980665);
  EXPECT_EQ(net_ft_torque_unit_Nm("Nm"), 1.0);
  EXPECT_EQ(net_ft_torque_unit_Nm("N-m"), 1.0);
  EXPECT_EQ(net_ft_torque_unit_Nm("Nmm"), 0.001);
  EXPECT_EQ(net_ft_torque_unit_Nm("kNm"), 1000.0);
  EXPECT_DOUBLE_EQ(net_ft_torque_unit_Nm("lbf-in").value(), 0.1129848290276167);
  EXPECT_DOUBLE_EQ(net_ft_torque_unit_Nm("lbf-ft").value(), 1.3558179483314004);
  EXPECT_DOUBLE_EQ(net_ft_torque_unit_Nm("kgf-cm").value(), 0.0980665);
  EXPECT_EQ(net_ft_force_unit_N("newton"), std::nullopt);
  EXPECT_EQ(net_ft_torque_unit_Nm("N"), std::nullopt);
  const auto pounds = parse(with("scfgfu", " lbf "));
  EXPECT_EQ(pounds->scale.unit_force_N, 4.4482216152605);
  EXPECT_DOUBLE_EQ((*pounds->range)[0], 330 * 4.4482216152605);
}

TEST(NetFtBoxConfig, TellsThatTheBoxTurnsItsForces) {
  EXPECT_TRUE(parse(with("cfgtfx", "0;0;132.710;0;0;0"))->transformed);
  EXPECT_TRUE(parse(with("cfgtfx", "0, 0, 0, 0, 0, -90"))->transformed);
  EXPECT_FALSE(parse(without("cfgtfx"))->transformed);
}

TEST(NetFtBoxConfig, ErrorsNameThePageAndTheElement) {
  for (const char* element : {"cfgcpf", "cfgcpt", "scfgfu", "scfgtu"}) {
    for (const auto& page :
         {without(element), with(element, ""), with(element, "x"), with(element, "<a>1</a>"),
          with(element, std::string(200, '1')),
          with("cfgnam", "</cfgnam><" + std::string(element) + ">1</" + element + "><cfgnam>")}) {
      const auto config = parse(page);
      ASSERT_FALSE(config) << page;
      EXPECT_EQ(config.error().field, element);
      EXPECT_EQ(config.error().file, "http://192.168.1.1/netftapi2.xml");
      EXPECT_FALSE(config.error().remedy.empty());
    }
  }
  for (const char* number : {"0", "-1", "nan", "inf", "1e999", "1 000", "1,5", "0x10", "+1"})
    EXPECT_FALSE(parse(with("cfgcpf", number))) << number;
  EXPECT_FALSE(parse(with("cfgtfx", "0;0;0;0;0")));
  EXPECT_FALSE(parse(with("cfgtfx", "0;0;0;0;0;0;0")));
  EXPECT_FALSE(parse(with("comrdtrate", "fast")));
}

TEST(NetFtBoxConfig, RefusesWhatIsNoPage) {
  for (const std::string& text :
       {std::string(), std::string("not XML"), std::string("<netft>"), std::string("<a/><b/>"),
        std::string("<netft><cfgcpf></netft>"), kPage.substr(0, 200), std::string(300'000, ' '),
        std::string("<html><body>404</body></html>"), std::string(1, '\0') + kPage})
    EXPECT_FALSE(parse(text)) << text.substr(0, 40);
  std::string deep;
  for (int i = 0; i < 50'000; ++i) deep += "<a>";
  EXPECT_FALSE(parse(deep));
}

TEST(NetFtBoxConfig, ThePageOfAnEmulatedBoxReadsBack) {
  NetFtBoxConfig config;
  config.product_name = "Emulated Net F/T";
  config.serial_number = "EMUL-1";
  config.scale.counts_per_unit_force = 1e6;
  config.scale.counts_per_unit_torque = 123456.0;
  config.rate_Hz = 500.0;
  config.filter_Hz = 73.0;
  config.range = (Vec6() << 1, 2, 3, 0.5, 0.25, 0.125).finished();
  const auto read = parse(encode_net_ft_page(config));
  ASSERT_TRUE(read) << read.error().message();
  EXPECT_EQ(read->product_name, config.product_name);
  EXPECT_EQ(read->serial_number, config.serial_number);
  EXPECT_EQ(read->scale.counts_per_unit_torque, 123456.0);
  EXPECT_EQ(read->rate_Hz, 500.0);
  EXPECT_EQ(read->filter_Hz, 73.0);
  EXPECT_EQ(read->range, config.range);
}

TEST(NetFtAddress, ReadsHostAndPorts) {
  const auto plain = NetFtAddress::parse("192.168.1.1");
  ASSERT_TRUE(plain.has_value());
  EXPECT_EQ(plain->records.text(), "192.168.1.1:49152");
  EXPECT_EQ(plain->pages.text(), "192.168.1.1:80");
  EXPECT_EQ(NetFtAddress::parse("10.0.0.1:5000")->records.text(), "10.0.0.1:5000");
  const auto both = NetFtAddress::parse("127.0.0.2:49152:8080");
  ASSERT_TRUE(both.has_value());
  EXPECT_EQ(both->records.text(), "127.0.0.2:49152");
  EXPECT_EQ(both->pages.text(), "127.0.0.2:8080");
  for (const char* text :
       {"", "box", "1.2.3", "1.2.3.4:", "1.2.3.4:0", "1.2.3.4:1:", "1.2.3.4:1:2:3", "1.2.3.4.5",
        "1.2.3.256", "01.2.3.4", "1.2.3.4:65536", " 1.2.3.4"})
    EXPECT_FALSE(NetFtAddress::parse(text)) << text;
}

}  // namespace
}  // namespace isograsp::net_ft_box_config_test
