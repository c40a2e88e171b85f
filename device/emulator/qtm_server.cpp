// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <chrono>
#include <exception>
#include <list>
#include <utility>

#include <boost/asio/buffer.hpp>
#include <boost/asio/executor_work_guard.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>

#include "device/emulator/emulated_qtm.hpp"
#include "device/emulator/marker_server.hpp"
#include "device/emulator/play_timer.hpp"

namespace isograsp {

namespace asio = boost::asio;
using asio::ip::tcp;

namespace {

using MarkerKind = EmulatedMarkerFault::Kind;
constexpr std::size_t kMostUnread = std::size_t{4} << 20;  // of a client that does not read

/// One connection.
struct Visit {
  explicit Visit(tcp::socket accepted) : socket(std::move(accepted)) {}

  tcp::socket socket;
  EmulatedQtmClient client;
  std::array<std::uint8_t, 1024> room{};
  std::vector<std::uint8_t> unsent;
  std::vector<std::uint8_t> merged;  ///< pictures that wait for others
  int merged_pictures = 0;
  bool gone = false;
};

class QtmServer final : public MarkerServer {
 public:
  explicit QtmServer(MarkerScene scene) : timer_(std::move(scene)) {
    for (const auto& fault : timer_.scene().faults()) {
      if (fault.kind == MarkerKind::split) split_ = true;
      if (fault.kind == MarkerKind::merge) merge_ = fault.count;
      if (fault.kind == MarkerKind::close) timer_.close_at(fault.at_s);
    }
  }

  [[nodiscard]] Result<void> open(const Endpoint& on) {
    boost::system::error_code failure;
    const tcp::endpoint at(asio::ip::address_v4(on.address), on.port);
    if (acceptor_.open(tcp::v4(), failure) ||
        acceptor_.set_option(tcp::acceptor::reuse_address(true), failure) ||
        acceptor_.bind(at, failure) ||
        acceptor_.listen(asio::socket_base::max_listen_connections, failure))
      return failed("emulated cameras cannot listen here: %1"_text(Known{failure.message()}),
                    "use another address or port, or end the program that has it"_text)
          .about(on.text());
    address_ = {on.address, acceptor_.local_endpoint().port()};
    accept();
    return {};
  }

  [[nodiscard]] Endpoint address() const override { return address_; }
  [[nodiscard]] bool over() const override { return timer_.over(); }
  [[nodiscard]] const MarkerScene& scene() const override { return timer_.scene(); }
  [[nodiscard]] const MarkerServerCounters& counters() const override { return counters_; }

  void serve(Clock& clock, Timestamp until) override {
    clock_ = &clock;
    for (;;) {
      io_.poll();
      const Timestamp now = clock.now();
      if (timer_.closes(now)) {
        counters_.closed += visits_.size();
        visits_.clear();
      }
      while (timer_.due() <= now) show(timer_.scene().take());
      visits_.remove_if([](const Visit& visit) { return visit.gone; });
      if (now >= until) return;
      const Timestamp next = std::min({until, timer_.due(), timer_.closing()});
      io_.run_one_until(std::chrono::steady_clock::time_point(next));
    }
  }

 private:
  void accept() {
    acceptor_.async_accept([this](boost::system::error_code failure, tcp::socket socket) {
      if (failure == asio::error::operation_aborted) return;
      if (!failure) welcome(std::move(socket));
      accept();
    });
  }
  void welcome(tcp::socket socket) {
    boost::system::error_code ignored;
    socket.set_option(tcp::no_delay(true), ignored);
    socket.non_blocking(true, ignored);
    ++counters_.clients;
    Visit& visit = visits_.emplace_back(std::move(socket));
    send(visit, EmulatedQtmClient::greeting());
    listen(visit);
  }
  void listen(Visit& visit) {
    visit.socket.async_read_some(
        asio::buffer(visit.room),
        [this, &visit](boost::system::error_code failure, std::size_t size) {
          if (failure == asio::error::operation_aborted) return;
          if (failure) {
            visit.gone = true;
            return;
          }
          hear(visit, std::span(visit.room).first(size));
        });
  }
  void hear(Visit& visit, std::span<const std::uint8_t> bytes) {
    const Timestamp now = clock_->now();
    const auto answers = visit.client.answer(bytes, timer_.scene().labels(timer_.play_s(now)),
                                             timer_.scene().rate_Hz());
    if (!answers) {
      visit.gone = true;
      return;
    }
    send(visit, *answers);
    if (visit.client.streaming()) timer_.begin(now);
    listen(visit);
  }

  void show(const MarkerPicture& picture) {
    if (!picture.sent) return;
    for (Visit& visit : visits_) {
      if (!visit.client.streaming() || visit.gone) continue;
      ++counters_.sent;
      const auto packet = visit.client.frame(picture);
      visit.merged.insert(visit.merged.end(), packet.begin(), packet.end());
      if (++visit.merged_pictures < merge_) continue;
      send(visit, visit.merged);
      visit.merged.clear();
      visit.merged_pictures = 0;
    }
  }

  /// What the system does not take at once waits for the next time.
  void send(Visit& visit, std::span<const std::uint8_t> bytes) {
    visit.unsent.insert(visit.unsent.end(), bytes.begin(), bytes.end());
    std::size_t sent = 0;
    while (sent < visit.unsent.size()) {
      const std::size_t size = split_ ? 1 : visit.unsent.size() - sent;
      boost::system::error_code failure;
      sent += visit.socket.send(asio::buffer(visit.unsent.data() + sent, size), 0, failure);
      if (failure == asio::error::would_block) break;
      if (failure) {
        visit.gone = true;
        break;
      }
    }
    visit.unsent.erase(visit.unsent.begin(),
                       visit.unsent.begin() + static_cast<std::ptrdiff_t>(sent));
    if (visit.unsent.size() > kMostUnread) visit.gone = true;
  }

  PlayTimer<MarkerScene> timer_;
  bool split_ = false;
  int merge_ = 1;
  Endpoint address_;
  MarkerServerCounters counters_;
  Clock* clock_ = nullptr;
  asio::io_context io_{1};
  asio::executor_work_guard<asio::io_context::executor_type> work_{io_.get_executor()};
  tcp::acceptor acceptor_{io_};
  std::list<Visit> visits_;
};

}  // namespace

Result<std::unique_ptr<MarkerServer>> open_qtm_server(const Endpoint& on, MarkerScene scene) {
  try {
    auto server = std::make_unique<QtmServer>(std::move(scene));
    if (auto opened = server->open(on); !opened) return opened.error();
    return std::unique_ptr<MarkerServer>(std::move(server));
  } catch (const std::exception& problem) {
    return failed("emulated cameras cannot listen here: %1"_text(Known{problem.what()}),
                  "close other programs and try again"_text)
        .about(on.text());
  }
}

}  // namespace isograsp
