// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/codec/net_ft_box_config.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <sstream>
#include <utility>

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>

#include "core/csv.hpp"

namespace isograsp {

namespace {

constexpr std::uint16_t kHttpPort = 80;

using Tree = boost::property_tree::ptree;

constexpr std::size_t kLargestPage = 256 * 1024;  // bytes; a box sends four thousand
constexpr std::ptrdiff_t kMostTags = 2000;        // keeps the parser's recursion small
constexpr std::size_t kLongestText = 128;
constexpr Words kRemedy = "open the box's web page and check its configuration"_text;

constexpr double kPound_N = 4.4482216152605;
constexpr double kKilopond_N = 9.80665;
struct BoxUnit {
  std::string_view name;
  double size;
};
constexpr std::array<BoxUnit, 6> kForceUnits{{{"N", 1.0},
                                              {"kN", 1000.0},
                                              {"lbf", kPound_N},
                                              {"klbf", 1000.0 * kPound_N},
                                              {"kgf", kKilopond_N},
                                              {"gf", 0.001 * kKilopond_N}}};
constexpr std::array<BoxUnit, 11> kTorqueUnits{{{"Nm", 1.0},
                                                {"N-m", 1.0},
                                                {"Nmm", 0.001},
                                                {"N-mm", 0.001},
                                                {"kNm", 1000.0},
                                                {"kN-m", 1000.0},
                                                {"lbf-in", 0.0254 * kPound_N},
                                                {"lbf-ft", 0.3048 * kPound_N},
                                                {"kgf-cm", 0.01 * kKilopond_N},
                                                {"kgfcm", 0.01 * kKilopond_N},
                                                {"kg-cm", 0.01 * kKilopond_N}}};

template <std::size_t kCount>
std::optional<double> size_of(const std::array<BoxUnit, kCount>& units,
                              std::string_view name) noexcept {
  const auto found = std::find_if(units.begin(), units.end(),
                                  [&](const BoxUnit& unit) { return unit.name == name; });
  if (found == units.end()) return std::nullopt;
  return found->size;
}

std::string_view trimmed(std::string_view text) noexcept {
  constexpr std::string_view kBlank = " \t\r\n";
  text.remove_prefix(std::min(text.find_first_not_of(kBlank), text.size()));
  const auto last = text.find_last_not_of(kBlank);
  return last == std::string_view::npos ? std::string_view() : text.substr(0, last + 1);
}

bool parse_quantity(std::string_view text, double& value) noexcept {
  const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
  return failure == std::errc() && end == text.data() + text.size() && std::isfinite(value);
}

/// Six numbers with semicolons, commas or blanks between them.
std::optional<Vec6> parse_six(std::string_view text) noexcept {
  constexpr std::string_view kBetween = ";, ";
  Vec6 values;
  for (int i = 0; i < 6; ++i) {
    text.remove_prefix(std::min(text.find_first_not_of(kBetween), text.size()));
    const auto word = text.substr(0, text.find_first_of(kBetween));
    if (!parse_quantity(word, values[i])) return std::nullopt;
    text.remove_prefix(word.size());
  }
  return trimmed(text).empty() ? std::optional(values) : std::nullopt;
}

bool says_axia(std::string name) {
  std::transform(name.begin(), name.end(), name.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  return name.find("axia") != std::string::npos;
}

/// The elements below the root of one page.
class Page {
 public:
  Page(const Tree& root, std::string where) : root_(root), where_(std::move(where)) {}

  /// nullopt: no such element.
  [[nodiscard]] Result<std::optional<std::string>> text(const char* name) const {
    const auto count = root_.count(name);
    if (count == 0) return std::optional<std::string>();
    if (count > 1)
      return refused("the box's page has this element twice"_text, kRemedy).at(where_).about(name);
    const Tree& element = root_.find(name)->second;
    const auto value = trimmed(element.data());
    if (!element.empty() || value.size() > kLongestText)
      return refused("the box's page has more than a short text here"_text, kRemedy)
          .at(where_)
          .about(name);
    return std::optional<std::string>(value);
  }
  [[nodiscard]] Result<double> positive(const char* name) const {
    const auto found = text(name);
    if (!found) return found.error();
    if (!*found)
      return refused("the box's page does not have this element"_text, kRemedy)
          .at(where_)
          .about(name);
    double value = 0.0;
    if (!parse_quantity(**found, value) || value <= 0.0)
      return refused("'%1' is not a positive number"_text(**found), kRemedy).at(where_).about(name);
    return value;
  }
  template <class SizeOf>
  [[nodiscard]] Result<double> unit(const char* name, SizeOf size_of_name) const {
    const auto found = text(name);
    if (!found) return found.error();
    if (!*found)
      return refused("the box's page does not have this element"_text, kRemedy)
          .at(where_)
          .about(name);
    const auto size = size_of_name(**found);
    if (!size)
      return refused("'%1' is not a unit that is known here"_text(**found), kRemedy)
          .at(where_)
          .about(name);
    return *size;
  }
  /// 0 if there is no such element.
  [[nodiscard]] Result<double> number_or_zero(const char* name) const {
    const auto found = text(name);
    if (!found) return found.error();
    double value = 0.0;
    if (*found && (!parse_quantity(**found, value) || value < 0.0))
      return refused("'%1' is not a number that makes sense here"_text(**found), kRemedy)
          .at(where_)
          .about(name);
    return value;
  }
  [[nodiscard]] Result<std::optional<Vec6>> six(const char* name) const {
    const auto found = text(name);
    if (!found) return found.error();
    if (!*found) return std::optional<Vec6>();
    const auto values = parse_six(**found);
    if (!values)
      return refused("'%1' is not six numbers"_text(**found), kRemedy).at(where_).about(name);
    return values;
  }

 private:
  const Tree& root_;
  std::string where_;
};

Result<NetFtBoxConfig> read(const Page& page) {
  NetFtBoxConfig config;
  for (auto [name, member] : {std::pair("prodname", &NetFtBoxConfig::product_name),
                              std::pair("cfgcalsn", &NetFtBoxConfig::serial_number)}) {
    auto text = page.text(name);
    if (!text) return text.error();
    config.*member = text->value_or("");
  }
  if (says_axia(config.product_name)) config.product = NetFtProduct::axia;

  for (auto [name, member] : {std::pair("cfgcpf", &NetFtScale::counts_per_unit_force),
                              std::pair("cfgcpt", &NetFtScale::counts_per_unit_torque)}) {
    const auto value = page.positive(name);
    if (!value) return value.error();
    config.scale.*member = *value;
  }
  const auto force = page.unit("scfgfu", net_ft_force_unit_N);
  if (!force) return force.error();
  const auto torque = page.unit("scfgtu", net_ft_torque_unit_Nm);
  if (!torque) return torque.error();
  config.scale.unit_force_N = *force;
  config.scale.unit_torque_Nm = *torque;

  // Firmware of some Axia spells it with two m.
  for (const char* name : {"comrdtrate", "commrdtrate"}) {
    const auto rate = page.number_or_zero(name);
    if (!rate) return rate.error();
    if (*rate > 0.0) config.rate_Hz = *rate;
  }
  if (config.product == NetFtProduct::net_box) {
    const auto code = page.text("setuserfilter");
    if (!code) return code.error();
    double number = 0.0;
    if (*code && parse_quantity(**code, number) &&
        (number == 0.0 ||
         (number > 0.0 && number < 100.0 && net_ft_filter_Hz(static_cast<unsigned>(number)) > 0.0)))
      config.filter_Hz = net_ft_filter_Hz(static_cast<unsigned>(number));
  }
  const auto transformation = page.six("cfgtfx");
  if (!transformation) return transformation.error();
  config.transformed = *transformation && !(*transformation)->isZero(0.0);
  const auto range = page.six("cfgmr");
  if (!range) return range.error();
  if (*range && (**range).minCoeff() > 0.0) {
    config.range = **range;
    config.range->head<3>() *= config.scale.unit_force_N;
    config.range->tail<3>() *= config.scale.unit_torque_Nm;
  }
  return config;
}

}  // namespace

std::optional<NetFtAddress> NetFtAddress::parse(std::string_view text) noexcept {
  const auto first = text.find(':');
  const auto address = parse_ipv4(text.substr(0, first));
  if (!address) return std::nullopt;
  NetFtAddress found{{*address, kNetFtPort}, {*address, kHttpPort}};
  if (first == std::string_view::npos) return found;
  text.remove_prefix(first + 1);
  const auto second = text.find(':');
  const auto records = parse_port(text.substr(0, second));
  if (!records) return std::nullopt;
  found.records.port = *records;
  if (second == std::string_view::npos) return found;
  const auto pages = parse_port(text.substr(second + 1));
  if (!pages) return std::nullopt;
  found.pages.port = *pages;
  return found;
}

Result<NetFtBoxConfig> NetFtBoxConfig::parse(std::string_view xml, const std::string& where) {
  if (xml.size() > kLargestPage || std::count(xml.begin(), xml.end(), '<') > kMostTags)
    return refused("this is no page of a Net F/T box: it is too large"_text, kRemedy).at(where);
  Tree tree;
  try {
    std::istringstream in{std::string(xml)};
    boost::property_tree::read_xml(in, tree);
  } catch (const boost::property_tree::xml_parser_error& problem) {
    // The error has no line: the parser counts lines in text that it has already changed.
    return refused("this is no XML: %1"_text(problem.message()), kRemedy).at(where);
  }
  if (tree.size() != 1)
    return refused("this is no page of a Net F/T box: it has not one root element"_text, kRemedy)
        .at(where);
  return read(Page(tree.front().second, where));
}

std::string encode_net_ft_page(const NetFtBoxConfig& config) {
  std::string text = "<?xml version=\"1.0\"?>\n<netft>\n";
  const auto add = [&](const char* name, const std::string& value) {
    text += std::string("<") + name + ">" + value + "</" + name + ">\n";
  };
  const auto number = [](double value) {
    std::string digits;
    append_number(digits, value);
    return digits;
  };
  add("runstat", "0x00000000");
  if (!config.product_name.empty()) add("prodname", config.product_name);
  if (!config.serial_number.empty()) add("cfgcalsn", config.serial_number);
  add("scfgfu", "N");
  add("scfgtu", "Nm");
  add("cfgcpf", number(config.scale.counts_per_unit_force / config.scale.unit_force_N));
  add("cfgcpt", number(config.scale.counts_per_unit_torque / config.scale.unit_torque_Nm));
  add("cfgtfx", "0;0;0;0;0;0");
  if (config.range) {
    std::string ratings;
    for (int axis = 0; axis < 6; ++axis)
      ratings += (axis == 0 ? "" : ";") + number((*config.range)[axis]);
    add("cfgmr", ratings);
  }
  if (config.filter_Hz)
    add("setuserfilter", std::to_string(net_ft_filter_code(*config.filter_Hz).value_or(0)));
  add("comrdtrate", number(config.rate_Hz.value_or(0.0)));
  add("comrdtbsiz", "1");
  return text + "</netft>\n";
}

std::optional<double> net_ft_force_unit_N(std::string_view name) noexcept {
  return size_of(kForceUnits, name);
}

std::optional<double> net_ft_torque_unit_Nm(std::string_view name) noexcept {
  return size_of(kTorqueUnits, name);
}

}  // namespace isograsp
