// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <chrono>
#include <deque>
#include <exception>
#include <list>
#include <string>
#include <utility>

#include <boost/asio/executor_work_guard.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>

#include "device/emulator/play_timer.hpp"
#include "device/hand/emulated_leap.hpp"
#include "device/hand/hand_server.hpp"

namespace isograsp {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = boost::beast::http;
namespace websocket = boost::beast::websocket;
using asio::ip::tcp;

namespace {

constexpr const char* kServedPath = "/v6.json";
constexpr std::size_t kMostUnreadMessages = 2000;  // of a client that does not read
constexpr std::size_t kLongestWish = 4096;         // that a client says
constexpr std::size_t kFragment = 64;              // bytes, of a message that is split
constexpr std::uint64_t kMessagesPerPing = 25;

/// One connection. Handlers hold it as long as they wait.
struct LeapVisit : std::enable_shared_from_this<LeapVisit> {
  explicit LeapVisit(tcp::socket accepted) : socket(std::move(accepted)) {}

  websocket::stream<tcp::socket> socket;
  beast::flat_buffer buffer;
  http::request<http::empty_body> request;
  std::deque<std::string> unsent;
  std::uint64_t said = 0;
  bool streaming = false;
  bool writing = false;
  bool pinging = false;
  bool leaving = false;  ///< closed as soon as all is sent
  bool gone = false;
};
using LeapVisitPtr = std::shared_ptr<LeapVisit>;

class LeapServer final : public HandServer {
 public:
  explicit LeapServer(HandScene scene) : timer_(std::move(scene)) {
    for (const auto& fault : timer_.scene().faults()) {
      if (fault.kind == EmulatedHandFault::Kind::split) split_ = true;
      if (fault.kind == EmulatedHandFault::Kind::close) timer_.close_at(fault.at_s);
    }
  }

  [[nodiscard]] Result<void> open(const Endpoint& on) {
    boost::system::error_code failure;
    const tcp::endpoint at(asio::ip::address_v4(on.address), on.port);
    if (acceptor_.open(tcp::v4(), failure) ||
        acceptor_.set_option(tcp::acceptor::reuse_address(true), failure) ||
        acceptor_.bind(at, failure) ||
        acceptor_.listen(asio::socket_base::max_listen_connections, failure))
      return failed("an emulated tracker cannot listen here: %1"_text(Known{failure.message()}),
                    "use another address or port, or end the program that has it"_text)
          .about(on.text());
    address_ = {on.address, acceptor_.local_endpoint().port()};
    accept();
    return {};
  }

  [[nodiscard]] Endpoint address() const override { return address_; }
  [[nodiscard]] bool over() const override { return timer_.over() && visits_.empty(); }
  [[nodiscard]] const HandScene& scene() const override { return timer_.scene(); }
  [[nodiscard]] const HandServerCounters& counters() const override { return counters_; }

  void serve(Clock& clock, Timestamp until) override {
    clock_ = &clock;
    for (;;) {
      io_.poll();
      const Timestamp now = clock.now();
      if (timer_.closes(now)) {
        counters_.closed += visits_.size();
        for (const LeapVisitPtr& visit : visits_) visit->gone = true;
      }
      while (timer_.due() <= now) show(timer_.scene().take());
      if (timer_.over()) take_leave();
      visits_.remove_if([](const LeapVisitPtr& visit) {
        if (visit->gone) hang_up(*visit);  // ends what still waits
        return visit->gone;
      });
      if (now >= until || over()) return;
      const Timestamp next = std::min({until, timer_.due(), timer_.closing()});
      io_.run_one_until(std::chrono::steady_clock::time_point(next));
    }
  }

 private:
  /// Calls `next` if a step of a visit came to its end; else the visit is over.
  template <class Next>
  static auto step(LeapVisitPtr visit, Next next) {
    return [visit, next](beast::error_code failure, auto&&...) {
      if (failure)
        visit->gone = true;
      else
        next();
    };
  }
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
    ++counters_.clients;
    auto visit = std::make_shared<LeapVisit>(std::move(socket));
    visits_.push_back(visit);
    http::async_read(visit->socket.next_layer(), visit->buffer, visit->request,
                     step(visit, [this, visit] { agree(visit); }));
  }
  void agree(const LeapVisitPtr& visit) {
    if (visit->request.target() != kServedPath || !websocket::is_upgrade(visit->request)) {
      visit->gone = true;
      return;
    }
    visit->buffer.clear();
    visit->socket.read_message_max(kLongestWish);
    if (split_) {
      visit->socket.auto_fragment(true);
      visit->socket.write_buffer_bytes(kFragment);
    }
    visit->socket.text(true);
    visit->socket.async_accept(visit->request, step(visit, [this, visit] {
                                 say(visit, leap_greeting());
                                 say(visit, leap_device_event());
                                 listen(visit);
                               }));
  }
  void listen(const LeapVisitPtr& visit) {
    visit->socket.async_read(visit->buffer, step(visit, [this, visit] {
                               const auto message = beast::buffers_to_string(visit->buffer.data());
                               visit->buffer.clear();
                               if (asks_for_frames(message)) {
                                 visit->streaming = true;
                                 timer_.begin(clock_->now());
                               }
                               listen(visit);
                             }));
  }

  void show(const HandPicture& picture) {
    if (!picture.sent) return;
    std::string message = leap_frame(picture, timer_.scene().rate_Hz());
    if (picture.cut) message = cut_off(std::move(message));
    for (const LeapVisitPtr& visit : visits_) {
      if (!visit->streaming || visit->gone) continue;
      ++counters_.sent;
      say(visit, message);
    }
  }
  void say(const LeapVisitPtr& visit, std::string message) {
    visit->unsent.push_back(std::move(message));
    if (visit->unsent.size() > kMostUnreadMessages) visit->gone = true;
    write(visit);
    if (++visit->said % kMessagesPerPing != 0 || visit->pinging || visit->gone) return;
    visit->pinging = true;
    visit->socket.async_ping("isograsp", step(visit, [visit] { visit->pinging = false; }));
  }
  void write(const LeapVisitPtr& visit) {
    if (visit->writing || visit->gone) return;
    if (visit->unsent.empty()) {
      if (visit->leaving) close(visit);
      return;
    }
    visit->writing = true;
    visit->socket.async_write(asio::buffer(visit->unsent.front()), step(visit, [this, visit] {
                                visit->unsent.pop_front();
                                visit->writing = false;
                                write(visit);
                              }));
  }
  void take_leave() {
    for (const LeapVisitPtr& visit : visits_) {
      if (std::exchange(visit->leaving, true)) continue;
      if (!visit->socket.is_open())
        visit->gone = true;
      else
        write(visit);
    }
  }
  void close(const LeapVisitPtr& visit) {
    visit->writing = true;
    visit->socket.async_close(websocket::close_code::normal,
                              step(visit, [visit] { visit->gone = true; }));
  }

  static void hang_up(LeapVisit& visit) {
    boost::system::error_code ignored;
    visit.socket.next_layer().close(ignored);
  }

  PlayTimer<HandScene> timer_;
  bool split_ = false;
  Endpoint address_;
  HandServerCounters counters_;
  Clock* clock_ = nullptr;
  asio::io_context io_{1};
  asio::executor_work_guard<asio::io_context::executor_type> work_{io_.get_executor()};
  tcp::acceptor acceptor_{io_};
  std::list<LeapVisitPtr> visits_;
};

}  // namespace

Result<std::unique_ptr<HandServer>> open_leap_server(const Endpoint& on, HandScene scene) {
  try {
    auto server = std::make_unique<LeapServer>(std::move(scene));
    if (auto opened = server->open(on); !opened) return opened.error();
    return std::unique_ptr<HandServer>(std::move(server));
  } catch (const std::exception& problem) {
    return failed("an emulated tracker cannot listen here: %1"_text(Known{problem.what()}),
                  "close other programs and try again"_text)
        .about(on.text());
  }
}

}  // namespace isograsp
