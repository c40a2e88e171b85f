// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/open_two_platforms.hpp"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "core/files.hpp"
#include "device/sensors/force_device.hpp"
#include "session/simulated_person.hpp"
#include "session/two_platforms/two_platforms.hpp"
#include "virtual_patient/pair/pair_traits.hpp"

namespace isograsp::session {

namespace {

constexpr std::string_view kBetween = " + ";
constexpr std::string_view kPairTarget = "pair";
constexpr const char* kPairs = "patients/pairs";

std::string front() {
  return std::string(kTwoPlatformsScheme) + "://";
}

bool is_pair(const Uri& uri) {
  return uri.scheme == "sim" && uri.target == kPairTarget;
}

/// A name is that of a file of the library; anything with a folder or an ending is a path.
Result<std::string> file_of_pair(const Uri& uri, const std::string& library) {
  const auto found = uri.parameters.find("file");
  const auto names = simulated_pairs(library);
  std::string list;
  for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
  if (found == uri.parameters.end())
    return refused("no pair of hands is named"_text,
                   "write file=NAME, one of: %1; or file=PATH.toml"_text(list))
        .at(uri.text)
        .about("file");
  const std::string& name = found->second;
  if (name.find('/') != std::string::npos || name.ends_with(".toml")) return name;
  if (std::find(names.begin(), names.end(), name) == names.end())
    return refused("there is no pair '%1'"_text(name), "use one of: %1"_text(list))
        .at(uri.text)
        .about("file");
  return (std::filesystem::path(library) / kPairs / (name + ".toml")).string();
}

Result<std::unique_ptr<virtual_patient::VirtualPair>> open_pair(const Uri& uri,
                                                                const std::string& library) {
  const auto path = file_of_pair(uri, library);
  if (!path) return path.error();
  const auto text = read_text(*path);
  if (!text) return text.error();
  const auto pair = virtual_patient::parse_pair(*text, *path);
  if (!pair) return pair.error();
  OfHands<virtual_patient::PatientTraits> people;
  for (const Hand hand : kBothHands) {
    const auto person = Uri::parse("sim://" + pair->people[hand]);
    if (!person) return Error(person.error()).at(*path).about(std::string(name_of(hand)));
    const auto traits = simulated_traits(*person, library);
    if (!traits) return Error(traits.error()).at(*path).about(std::string(name_of(hand)));
    people[hand] = *traits;
  }
  constexpr double kLargestSeed = 9007199254740992.0;  // 2^53: every integer below is a double
  const auto seed = uri.number_or("seed", 1.0, 0.0, kLargestSeed);
  if (!seed) return seed.error();
  return std::make_unique<virtual_patient::VirtualPair>(pair->traits, people,
                                                        static_cast<std::uint64_t>(*seed));
}

}  // namespace

std::vector<std::string> simulated_pairs(const std::string& library) {
  return names_in(library, kPairs);
}

Result<std::string> two_platforms_uri(const OfHands<std::string>& uris) {
  for (const Hand hand : kBothHands)
    if (uris[hand].find(kBetween) != std::string::npos)
      return refused("the address of the %1 platform holds ' + '"_text(
                         Known{std::string(name_of(hand))}),
                     "write a space in it as %20"_text)
          .at(uris[hand]);
  if (uris.left == uris.right) {
    const auto uri = Uri::parse(uris.left);
    if (!uri) return uri.error();
    if (!is_pair(*uri))
      return refused("both hands are given one platform"_text,
                     "give each hand its own; on one bus the sensors of the two platforms need "
                     "other identifiers, in two configurations"_text)
          .at(uris.left);
  }
  return front() + uris.left + std::string(kBetween) + uris.right;
}

std::optional<OfHands<std::string>> two_platforms_in(std::string_view uri) {
  const std::string beginning = front();
  if (!uri.starts_with(beginning)) return std::nullopt;
  uri.remove_prefix(beginning.size());
  const auto between = uri.find(kBetween);
  if (between == std::string_view::npos) return std::nullopt;
  return OfHands<std::string>{std::string(uri.substr(0, between)),
                              std::string(uri.substr(between + kBetween.size()))};
}

Result<std::unique_ptr<Apparatus>> open_two_platforms(const ApparatusRequest& request) {
  const auto uris = two_platforms_in(request.uri.text);
  if (!uris)
    return refused("is no address of two platforms"_text, "write two-platforms://LEFT + RIGHT"_text)
        .at(request.uri.text);
  std::unique_ptr<virtual_patient::VirtualPair> pair;
  TwoPlatforms::Devices devices;
  for (const Hand hand : kBothHands) {
    const auto uri = Uri::parse((*uris)[hand]);
    if (!uri) return uri.error();
    if (uri->scheme == "sim" && (!is_pair(*uri) || uris->left != uris->right))
      return refused("two simulated hands are those of one person"_text,
                     "give both platforms the same sim://pair?file=NAME"_text)
          .at(uri->text);
    DeviceOptions options;
    std::string address = uri->text;
    if (is_pair(*uri)) {
      address += "&hand=" + std::string(name_of(hand));
      if (!pair) {
        auto opened = open_pair(*uri, request.library);
        if (!opened) return opened.error();
        pair = *std::move(opened);
      }
      options.source = &pair->source(hand);
    }
    auto device = open_device(address, options);
    if (!device) return device.error();
    if (const auto& mounted_for = (*device)->info().hand)
      if (auto same = check_hand(uri->text, name_of(*mounted_for), hand); !same)
        return same.error();
    devices[hand] = *std::move(device);
  }
  if (auto fit = TwoPlatforms::check(devices); !fit) return fit.error();
  return std::unique_ptr<Apparatus>(std::make_unique<TwoPlatforms>(
      std::move(devices), std::move(pair), request.display_delay_s, request.library));
}

}  // namespace isograsp::session
