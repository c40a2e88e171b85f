// SPDX-License-Identifier: GPL-3.0-or-later
// Motive (OptiTrack) over UDP: one port speaks with its computer, another hears the frames; where
// it sends them straight to who asked (unicast), they come to the first. Who asked must say every
// second that he is still there.
#include <array>
#include <utility>

#include "device/bus/host.hpp"
#include "device/bus/udp_port.hpp"
#include "device/cameras/live_pictures.hpp"
#include "device/cameras/marker_schemes.hpp"
#include "device/markers/marker_reader.hpp"
#include "device/markers/natnet_codec.hpp"

namespace isograsp {

namespace {

constexpr std::uint16_t kCommandPort = 1510;
constexpr std::uint16_t kDataPort = 1511;
constexpr std::uint32_t kUsualGroup = 0xEFFF2A63;  // 239.255.42.99
constexpr std::size_t kLargestDatagram = std::size_t{64} << 10;
constexpr int kMostDatagramsPastDeadline = 16;
constexpr Timestamp kAsk = std::chrono::milliseconds(500);  ///< until there is an answer
constexpr Timestamp kStillHere = std::chrono::seconds(1);

/// Where frames may come from.
struct NatNetWays {
  HostAndPort host;
  std::uint32_t local = 0;             ///< address of this computer; 0: any
  std::optional<std::uint32_t> group;  ///< that of the URI
};

class NatNetDevice final : public MarkerDevice {
 public:
  NatNetDevice(MarkerDeviceInfo info, NatNetWays ways)
      : info_(std::move(info)), ways_(std::move(ways)), room_(kLargestDatagram) {}

  [[nodiscard]] const MarkerDeviceInfo& info() const noexcept override { return info_; }
  [[nodiscard]] MarkerHealth health() const noexcept override;
  [[nodiscard]] Result<void> start(Clock& clock) override;
  [[nodiscard]] ReadStatus read(Timestamp deadline, MarkerSample& out) noexcept override;
  void stop() noexcept override {
    commands_.close();
    frames_.close();
    clock_ = nullptr;
  }

 private:
  using Step = NatNetStream::Step;
  /// Who it is, its markers, its rate, and frames.
  [[nodiscard]] Result<void> greet(Clock& clock, PeriodEstimate& seen);
  /// Asks until `answer` comes, at most until `end`. Errors: a version that is not known.
  [[nodiscard]] Result<bool> ask_for(Step answer, std::uint16_t kind, Clock& clock, Timestamp end);
  [[nodiscard]] Result<void> hear_frames();
  /// The next datagram of these cameras; false: none waits.
  [[nodiscard]] bool take(Timestamp now, NatNetStream::Row& row, Step& step) noexcept;
  [[nodiscard]] bool placed(const NatNetStream::Row& row, Timestamp now,
                            MarkerSample& out) noexcept;
  void ask(std::uint16_t kind, std::string_view text = "") noexcept;
  void serve(Timestamp now) noexcept;
  [[nodiscard]] bool answers(Timestamp now) const noexcept {
    return now - last_answer_ <= kAskAgain;
  }

  MarkerDeviceInfo info_;
  NatNetWays ways_;
  Endpoint server_;
  std::uint32_t source_ = 0;  ///< address that frames come from; 0: none has come
  std::vector<std::uint8_t> room_;
  UdpPort commands_;
  UdpPort frames_;
  NatNetStream stream_;
  LivePictures pictures_;
  std::uint64_t unlabelled_before_ = 0;
  std::uint64_t damaged_before_ = 0;
  bool wrong_labels_ = false;
  bool lost_ = false;  ///< its computer has not answered for long
  bool was_started_ = false;
  Clock* clock_ = nullptr;  ///< null: stopped
  Timestamp last_answer_{0};
  Timestamp act_at_{0};
  Timestamp models_at_{0};  ///< not asked for again before
};

MarkerHealth NatNetDevice::health() const noexcept {
  MarkerHealth health;
  health.counters = pictures_.counters;
  if (clock_ == nullptr) {
    health.state = was_started_ ? DeviceState::configured : DeviceState::absent;
    return health;
  }
  health.jitter_s = pictures_.grid.jitter_s();
  const Timestamp now = clock_->now();
  const bool gone = pictures_.watch.silent(now) && !answers(now);
  PictureWatch::set(health, gone            ? MarkerFault::connection_lost
                            : wrong_labels_ ? MarkerFault::wrong_labels
                                            : pictures_.watch.fault(now));
  return health;
}

Result<void> NatNetDevice::start(Clock& clock) {
  stop();
  if (auto real = require_real_time(clock, info_.uri); !real) return real;
  const auto server = find_host(ways_.host);
  if (!server) return Error(server.error()).at(info_.uri);
  server_ = *server;
  source_ = 0;
  stream_ = {};
  wrong_labels_ = lost_ = false;
  PeriodEstimate seen;
  auto greeted = greet(clock, seen);
  if (greeted) greeted = check_labels(stream_.labels(), info_.uri);
  if (!greeted) {
    stop();
    return Error(greeted.error()).at(info_.uri);
  }
  info_.labels = stream_.labels();
  info_.period_s = period_of(seen, stream_.rate_Hz());
  unlabelled_before_ = stream_.counts().unlabelled;
  damaged_before_ = stream_.counts().damaged;
  const Timestamp now = clock.now();
  pictures_.begin(now, info_.period_s);
  clock_ = &clock;
  was_started_ = true;
  last_answer_ = act_at_ = models_at_ = now;
  return {};
}

Result<void> NatNetDevice::greet(Clock& clock, PeriodEstimate& seen) {
  if (auto opened = commands_.open({ways_.local, 0}, false); !opened) return opened;
  const Timestamp end = clock.now() + kMarkerPatience;
  const auto who = ask_for(Step::server, NatNetMessage::kConnect, clock, end);
  if (!who) return who.error();
  if (!*who)
    return failed("nobody answers at %1"_text(server_.text()),
                  "start Motive with streaming on, check its address and the firewall"_text);
  if (auto opened = hear_frames(); !opened) return opened;
  const auto models = ask_for(Step::labels, NatNetMessage::kAskModels, clock, end);
  if (!models) return models.error();
  if (!*models)
    return failed("Motive has no labelled markers"_text,
                  "make marker sets or rigid bodies, and stream them"_text);
  ask(NatNetMessage::kRequest, "FrameRate");
  while (seen.frames() < kLooks) {
    const Timestamp now = clock.now();
    NatNetStream::Row row;
    Step step = Step::nothing;
    while (take(now, row, step))
      if (step == Step::row) seen.add(row.frame, row.stamp_s);
    if (now >= end) break;
    UdpPort::wait(commands_, frames_, end - now);
  }
  if (stream_.counts().frames == 0)
    return failed(
        "Motive sends no pictures here"_text,
        "let it stream live, give the address of this computer as local=, or choose unicast"_text);
  return {};
}

Result<bool> NatNetDevice::ask_for(Step answer, std::uint16_t kind, Clock& clock, Timestamp end) {
  Timestamp ask_at = clock.now();
  for (;;) {
    const Timestamp now = clock.now();
    NatNetStream::Row row;
    Step step = Step::nothing;
    while (take(now, row, step)) {
      if (step == answer) return true;
      if (step == Step::unknown_version)
        return failed("the stream is NatNet %1, which is not known"_text(stream_.version()->text()),
                      "let Motive stream version 2.5 to 4.1"_text);
    }
    if (now >= end) return false;
    if (now >= ask_at) {
      ask(kind);
      ask_at = now + kAsk;
    }
    UdpPort::wait(commands_, frames_, std::min(ask_at, end) - now);
  }
}

/// Frames that are sent straight to us come without it, so that only a group must be heard.
Result<void> NatNetDevice::hear_frames() {
  const bool by_group = ways_.group || stream_.multicast() ||
                        !stream_.version()->at_least(3, 0);  // below 3.0 nobody says
  auto opened = frames_.open({0, stream_.data_port().value_or(kDataPort)}, true);
  if (opened && by_group)
    opened =
        frames_.join(ways_.group.value_or(stream_.multicast().value_or(kUsualGroup)), ways_.local);
  if (opened || !by_group) return {};
  frames_.close();
  return opened;
}

bool NatNetDevice::take(Timestamp now, NatNetStream::Row& row, Step& step) noexcept {
  Endpoint from;
  for (UdpPort* port : {&frames_, &commands_}) {
    if (!port->is_open()) continue;
    const auto size = port->receive(room_, from);
    if (!size) continue;
    step = Step::nothing;
    const bool of_server = from.address == server_.address;
    // Its computer may send to a group from another of its addresses: the first one that does.
    if (!of_server && (port != &frames_ || (source_ != 0 && from.address != source_))) return true;
    if (*size > room_.size()) return true;
    if (of_server) last_answer_ = now;
    step = stream_.take(std::span(room_).first(*size), row);
    if (step == Step::row && !of_server) source_ = from.address;
    if (step == Step::labels) wrong_labels_ = false;
    if (step == Step::other_labels) wrong_labels_ = true;
    return true;
  }
  return false;
}

void NatNetDevice::ask(std::uint16_t kind, std::string_view text) noexcept {
  std::array<std::uint8_t, kLongestNatNetRequest> bytes{};
  const std::size_t size = encode_natnet_request(kind, text, bytes);
  commands_.send(server_, std::span(bytes).first(size));
}

ReadStatus NatNetDevice::read(Timestamp deadline, MarkerSample& out) noexcept {
  if (clock_ == nullptr) return ReadStatus::finished;
  for (int datagrams = 0;; ++datagrams) {
    const Timestamp now = clock_->now();
    serve(now);
    NatNetStream::Row row;
    Step step = Step::nothing;
    const bool any = take(now, row, step);
    pictures_.count(stream_.counts().unlabelled - unlabelled_before_,
                    stream_.counts().damaged - damaged_before_, now);
    if (any && step == Step::row && placed(row, now, out)) return ReadStatus::sample;
    if (now >= deadline && (!any || datagrams >= kMostDatagramsPastDeadline))
      return ReadStatus::timeout;
    if (!any) UdpPort::wait(commands_, frames_, std::min(deadline, act_at_) - now);
  }
}

bool NatNetDevice::placed(const NatNetStream::Row& row, Timestamp now, MarkerSample& out) noexcept {
  if (row.models_changed && now >= models_at_) {
    ask(NatNetMessage::kAskModels);
    models_at_ = now + kAsk;
  }
  if (!pictures_.place(row.frame, row.stamp_s, now, row.p_W, out)) return false;
  if (std::exchange(lost_, false)) ++pictures_.counters.restarts;
  return true;
}

void NatNetDevice::serve(Timestamp now) noexcept {
  if (now < act_at_) return;
  act_at_ = now + kStillHere;
  ask(NatNetMessage::kKeepAlive);
  if (!pictures_.watch.silent(now)) return;
  // It may have been started anew, with other markers and another version.
  if (!answers(now)) lost_ = true;
  ask(NatNetMessage::kConnect);
  ask(NatNetMessage::kAskModels);
}

}  // namespace

Result<std::unique_ptr<MarkerDevice>> open_natnet(const Uri& uri, MarkerSource*) {
  if (auto known = uri.require_known({"rig", "local", "multicast"}); !known) return known.error();
  auto host = parse_host(uri.target, kCommandPort);
  if (!host)
    return refused("'%1' is no computer with a port"_text(uri.target),
                   "write natnet://192.168.0.7"_text)
        .at(uri.text);
  NatNetWays ways{*std::move(host), 0, std::nullopt};
  const auto address = [&](const char* key) -> Result<std::optional<std::uint32_t>> {
    if (!uri.parameters.contains(key)) return std::optional<std::uint32_t>();
    const std::string text = uri.text_or(key, "");
    const auto found = parse_ipv4(text);
    if (!found)
      return refused("'%1' is no address in numbers"_text(text), "write it as 192.168.0.7"_text)
          .at(uri.text)
          .about(key);
    return found;
  };
  const auto local = address("local");
  if (!local) return local.error();
  ways.local = local->value_or(0);
  const auto group = address("multicast");
  if (!group) return group.error();
  constexpr std::uint32_t kGroups = 0xE, kGroupShift = 28;  // 224.0.0.0/4
  if (*group && **group >> kGroupShift != kGroups)
    return refused("'%1' is no multicast group"_text(Endpoint{**group, 0}.address_text()),
                   "give one from 224.0.0.0 to 239.255.255.255"_text)
        .at(uri.text)
        .about("multicast");
  ways.group = *group;
  MarkerDeviceInfo info;
  info.uri = uri.text;
  info.description = "OptiTrack at %1"_text(ways.host.host);
  info.provenance = {"live: " + uri.text};
  return std::unique_ptr<MarkerDevice>(
      std::make_unique<NatNetDevice>(std::move(info), std::move(ways)));
}

}  // namespace isograsp
