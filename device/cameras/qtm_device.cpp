// SPDX-License-Identifier: GPL-3.0-or-later
// Qualisys Track Manager over TCP: found, asked and read as it comes; a connection that was closed
// is made anew between two reads.
#include <array>
#include <exception>
#include <utility>

#include "device/bus/host.hpp"
#include "device/bus/tcp_link.hpp"
#include "device/cameras/live_pictures.hpp"
#include "device/cameras/marker_schemes.hpp"
#include "device/cameras/qtm_conversation.hpp"
#include "device/markers/marker_reader.hpp"
#include "device/markers/qtm_rt_codec.hpp"

namespace isograsp {

namespace {

constexpr std::uint16_t kStreamPort = 22223;  // little endian
constexpr std::size_t kStreamRoom = std::size_t{64} << 10;
constexpr int kMostPiecesPastDeadline = 16;
constexpr Timestamp kNewConnection = std::chrono::milliseconds(250);
constexpr Timestamp kConnecting = std::chrono::seconds(2);
constexpr double kMicrosecond_s = 1e-6;

class QtmDevice final : public MarkerDevice {
 public:
  QtmDevice(MarkerDeviceInfo info, HostAndPort host)
      : info_(std::move(info)), host_(std::move(host)), room_(kStreamRoom) {}

  [[nodiscard]] const MarkerDeviceInfo& info() const noexcept override { return info_; }
  [[nodiscard]] MarkerHealth health() const noexcept override;
  [[nodiscard]] Result<void> start(Clock& clock) override;
  [[nodiscard]] ReadStatus read(Timestamp deadline, MarkerSample& out) noexcept override;
  void stop() noexcept override {
    link_.close();
    connected_ = false;
    clock_ = nullptr;
  }

 private:
  /// Everything until frames come, with what they tell of the rate.
  [[nodiscard]] Result<void> greet(Clock& clock, PeriodEstimate& seen);
  [[nodiscard]] Error not_started() const;
  /// Takes the next packet that waits; what it says moves the conversation on.
  [[nodiscard]] QtmRtStream::Step take(Timestamp now, QtmRtStream::Row& row) noexcept;
  void speak() noexcept;
  /// Lets bytes in. Nothing: the connection is closed.
  [[nodiscard]] std::optional<std::size_t> let_in() noexcept;
  /// Keeps the connection: begins, asks, gives up.
  void serve(Timestamp now) noexcept;
  void disconnect(Timestamp now) noexcept;
  [[nodiscard]] Timestamp due() const noexcept;

  MarkerDeviceInfo info_;
  HostAndPort host_;
  Endpoint server_;
  std::vector<std::uint8_t> room_;
  TcpLink link_;
  QtmRtStream stream_;
  QtmConversation conversation_;
  LivePictures pictures_;
  std::uint64_t unlabelled_before_ = 0;  ///< in the stream's counts, at start()
  std::uint64_t damaged_ = 0;
  bool connected_ = false;
  bool restarted_ = false;  ///< the connection is a new one that has sent nothing yet
  bool wrong_labels_ = false;
  Clock* clock_ = nullptr;  ///< null: stopped
  Timestamp act_at_{0};     ///< connect again, give up connecting, or ask again
  bool was_started_ = false;
};

MarkerHealth QtmDevice::health() const noexcept {
  MarkerHealth health;
  health.counters = pictures_.counters;
  if (clock_ == nullptr) {
    health.state = was_started_ ? DeviceState::configured : DeviceState::absent;
    return health;
  }
  health.jitter_s = pictures_.grid.jitter_s();
  PictureWatch::set(health, !connected_     ? MarkerFault::connection_lost
                            : wrong_labels_ ? MarkerFault::wrong_labels
                                            : pictures_.watch.fault(clock_->now()));
  return health;
}

Result<void> QtmDevice::start(Clock& clock) {
  stop();
  if (auto real = require_real_time(clock, info_.uri); !real) return real;
  const auto server = find_host(host_);
  if (!server) return Error(server.error()).at(info_.uri);
  server_ = *server;
  stream_ = {};
  conversation_ = {};
  wrong_labels_ = false;
  damaged_ = 0;
  PeriodEstimate seen;
  if (auto done = greet(clock, seen); !done) {
    link_.close();
    return Error(done.error()).at(info_.uri);
  }
  if (auto good = check_labels(stream_.labels(), info_.uri); !good) {
    link_.close();
    return good;
  }
  info_.labels = stream_.labels();
  info_.period_s = period_of(seen, stream_.rate_Hz());
  unlabelled_before_ = stream_.counts().unlabelled;
  pictures_.begin(clock.now(), info_.period_s);
  clock_ = &clock;
  connected_ = was_started_ = true;
  restarted_ = false;
  act_at_ = clock.now() + kAskAgain;
  return {};
}

Result<void> QtmDevice::greet(Clock& clock, PeriodEstimate& seen) {
  const auto nobody = [&] {
    return failed("nobody answers at %1"_text(server_.text()),
                  "start Qualisys Track Manager, check its address and the firewall"_text);
  };
  const Timestamp begin = clock.now();
  link_.connect(server_);
  while (link_.state() == TcpLink::State::connecting) {
    const Timestamp now = clock.now();
    if (now - begin >= kMarkerPatience) return nobody();
    link_.wait(begin + kMarkerPatience - now);
  }
  if (link_.state() == TcpLink::State::closed) return nobody();
  conversation_.begin(clock.now());
  for (;;) {
    const Timestamp now = clock.now();
    QtmRtStream::Row row;
    QtmRtStream::Step step = QtmRtStream::Step::more;
    while ((step = take(now, row)) != QtmRtStream::Step::more) {
      if (step == QtmRtStream::Step::lost) return not_started();
      if (step != QtmRtStream::Step::row) continue;
      seen.add(row.frame, static_cast<double>(row.stamp_us) * kMicrosecond_s);
      if (seen.frames() >= kLooks) return {};
    }
    conversation_.look(now);
    speak();
    if (conversation_.failure() != QtmConversation::Failure::none) return not_started();
    if (now - begin >= kMarkerPatience)
      return conversation_.streaming() ? Result<void>() : not_started();
    const auto got = let_in();
    if (!got)
      return failed(
          "the connection was closed while the cameras were asked"_text,
          "check that it is Qualisys Track Manager, and that it takes another client"_text);
    if (*got == 0) link_.wait(std::min(conversation_.due(), begin + kMarkerPatience) - now);
  }
}

Error QtmDevice::not_started() const {
  using Failure = QtmConversation::Failure;
  const auto with_words = [&](Words what) -> Text {
    if (conversation_.refusal().empty()) return what;
    return "%1: it says '%2'"_text(Text(what), conversation_.refusal());
  };
  switch (conversation_.failure()) {
    case Failure::not_qtm:
      return failed("what answers is not Qualisys Track Manager"_text,
                    "give its address and the port of its real-time stream, little endian"_text);
    case Failure::version:
      return failed(with_words("QTM speaks no known version of its real-time stream"_text),
                    "update Qualisys Track Manager"_text);
    case Failure::no_labels:
      return failed(with_words("QTM has no labelled markers"_text),
                    "load a project with labels and an AIM model"_text);
    case Failure::no_frames:
      return failed(with_words("QTM sends no pictures"_text),
                    "start a measurement, or the preview"_text);
    default:
      return failed("Qualisys Track Manager does not answer at %1"_text(server_.text()),
                    "check that it is running, its address and the firewall"_text);
  }
}

QtmRtStream::Step QtmDevice::take(Timestamp now, QtmRtStream::Row& row) noexcept {
  const auto step = stream_.next(row);
  if (step == QtmRtStream::Step::labels) wrong_labels_ = false;
  if (step == QtmRtStream::Step::other_labels) wrong_labels_ = true;
  conversation_.hear(step, stream_.message(), now);
  speak();
  return step;
}

void QtmDevice::speak() noexcept {
  const auto command = conversation_.say();
  if (command.empty()) return;
  std::array<std::uint8_t, 64> bytes{};
  link_.send(std::span(bytes).first(encode_qtm_rt_command(command, bytes)));
}

std::optional<std::size_t> QtmDevice::let_in() noexcept {
  const auto got = link_.receive(room_);
  if (!got || *got == 0) return got;
  try {
    stream_.add(std::span(room_).first(*got));
  } catch (const std::exception&) {  // no memory for a packet of that size
    link_.close();
    return std::nullopt;
  }
  return got;
}

ReadStatus QtmDevice::read(Timestamp deadline, MarkerSample& out) noexcept {
  if (clock_ == nullptr) return ReadStatus::finished;
  for (int pieces = 0;; ++pieces) {
    const Timestamp now = clock_->now();
    QtmRtStream::Row row;
    QtmRtStream::Step step = QtmRtStream::Step::more;
    while ((step = take(now, row)) != QtmRtStream::Step::more) {
      if (step == QtmRtStream::Step::lost) {
        ++damaged_;
        disconnect(now);
        break;
      }
      if (step != QtmRtStream::Step::row) continue;
      act_at_ = now + kAskAgain;
      if (std::exchange(restarted_, false)) ++pictures_.counters.restarts;
      if (pictures_.place(row.frame, static_cast<double>(row.stamp_us) * kMicrosecond_s, now,
                          row.p_W, out))
        return ReadStatus::sample;
    }
    pictures_.count(stream_.counts().unlabelled - unlabelled_before_, damaged_, now);
    serve(now);
    const auto got = let_in();
    if (!got && connected_) disconnect(now);
    if (now >= deadline && (!got || *got == 0 || pieces >= kMostPiecesPastDeadline))
      return ReadStatus::timeout;
    if (!got || *got == 0) link_.wait(std::min(deadline, due()) - now);
  }
}

void QtmDevice::serve(Timestamp now) noexcept {
  switch (link_.state()) {
    case TcpLink::State::closed:
      connected_ = false;
      if (now < act_at_) return;
      link_.connect(server_);
      act_at_ = now + kConnecting;
      return;
    case TcpLink::State::connecting:
      if (now >= act_at_) disconnect(now);
      return;
    case TcpLink::State::open:
      if (!connected_) {
        connected_ = restarted_ = true;
        stream_.restart();
        conversation_.begin(now);
        act_at_ = now + kMarkerPatience;
      }
      conversation_.look(now);
      if (now >= act_at_) {
        conversation_.ask_again(now);
        act_at_ = now + kAskAgain;
      }
      speak();
  }
}

void QtmDevice::disconnect(Timestamp now) noexcept {
  link_.close();
  stream_.restart();
  connected_ = false;
  act_at_ = now + kNewConnection;
}

Timestamp QtmDevice::due() const noexcept {
  return std::min(act_at_, conversation_.due());
}

}  // namespace

Result<std::unique_ptr<MarkerDevice>> open_qtm(const Uri& uri, MarkerSource*) {
  if (auto known = uri.require_known({"rig"}); !known) return known.error();
  auto host = parse_host(uri.target, kStreamPort);
  if (!host)
    return refused("'%1' is no computer with a port"_text(uri.target),
                   "write qtm://192.168.0.7 or qtm://192.168.0.7:22223"_text)
        .at(uri.text);
  MarkerDeviceInfo info;
  info.uri = uri.text;
  info.description = "Qualisys at %1"_text(host->host);
  info.provenance = {"live: " + uri.text};
  return std::unique_ptr<MarkerDevice>(
      std::make_unique<QtmDevice>(std::move(info), *std::move(host)));
}

}  // namespace isograsp
