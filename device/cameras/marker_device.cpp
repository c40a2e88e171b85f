// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/cameras/marker_device.hpp"

#include <array>

#include "device/cameras/marker_schemes.hpp"

namespace isograsp {

namespace {

constexpr std::size_t kFaults = 5;

/// Which scheme of a URI is opened by whom.
struct Scheme {
  std::string_view name;
  Result<std::unique_ptr<MarkerDevice>> (*open)(const Uri&, MarkerSource*);
};
constexpr std::array kSchemes{Scheme{"qtm", open_qtm}, Scheme{"natnet", open_natnet},
                              Scheme{"replay", open_marker_replay},
                              Scheme{"sim", open_simulated_markers}};

}  // namespace

std::string_view name_of(MarkerFault fault) noexcept {
  constexpr std::array<std::string_view, kFaults> kNames{"none", "connection_lost", "silence",
                                                         "wrong_labels", "damaged_samples"};
  return kNames[static_cast<std::size_t>(fault)];
}

Words words_of(MarkerFault fault) noexcept {
  constexpr std::array<Words, kFaults> kSentences{
      "The cameras work."_text,
      "The connection to the cameras is lost: check their computer and the network cable."_text,
      "The cameras send nothing: check that they are measuring."_text,
      "The cameras send other markers than before: load the measurement that belongs here."_text,
      "Pictures of the cameras are lost on the way: check the network."_text};
  return kSentences[static_cast<std::size_t>(fault)];
}

Result<std::unique_ptr<MarkerDevice>> open_marker_device(const Uri& uri, MarkerSource* source) {
  for (const Scheme& scheme : kSchemes)
    if (uri.scheme == scheme.name) return scheme.open(uri, source);
  return refused("no cameras are called %1://"_text(uri.scheme),
                 "use qtm://HOST, natnet://HOST, replay://FILE or sim://arm"_text)
      .at(uri.text);
}

}  // namespace isograsp
