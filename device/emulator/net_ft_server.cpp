// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/emulator/net_ft_server.hpp"

#include <charconv>
#include <chrono>
#include <exception>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include <boost/asio/executor_work_guard.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/ip/udp.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>

#include "device/bus/kernel_stamp.hpp"

namespace isograsp {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = boost::beast::http;
using asio::ip::tcp;
using asio::ip::udp;

namespace {

constexpr std::chrono::seconds kLongestPageRequest{5};

/// What a box answers to the target of a GET.
using Answer = std::function<std::optional<std::string>(std::string_view target)>;

/// One connection: reads a request, answers, closes.
class PageVisit : public std::enable_shared_from_this<PageVisit> {
 public:
  PageVisit(tcp::socket socket, const Answer& answer)
      : stream_(std::move(socket)), answer_(answer) {}

  void begin() {
    stream_.expires_after(kLongestPageRequest);
    http::async_read(stream_, buffer_, request_,
                     [self = shared_from_this()](beast::error_code failure, std::size_t) {
                       if (!failure) self->reply();
                     });
  }

 private:
  void reply() {
    const auto target = request_.target();
    auto body = request_.method() == http::verb::get
                    ? answer_(std::string_view(target.data(), target.size()))
                    : std::nullopt;
    response_.version(request_.version());
    response_.result(body ? http::status::ok : http::status::not_found);
    response_.set(http::field::content_type, "text/xml");
    response_.keep_alive(false);
    response_.body() = body.value_or("");
    response_.prepare_payload();
    http::async_write(stream_, response_,
                      [self = shared_from_this()](beast::error_code, std::size_t) {
                        beast::error_code ignored;
                        self->stream_.socket().shutdown(tcp::socket::shutdown_both, ignored);
                      });
  }

  beast::tcp_stream stream_;
  const Answer& answer_;
  beast::flat_buffer buffer_;
  http::request<http::empty_body> request_;
  http::response<http::string_body> response_;
};

class OpenBoxes final : public NetFtServer {
 public:
  explicit OpenBoxes(NetFtServerOptions options) : options_(std::move(options)) {}

  /// What failed, with the address.
  std::optional<Error> open() {
    for (std::size_t f = 0; f < kFingerCount; ++f) {
      auto& box = options_.boxes[f];
      beast::error_code failure;
      const udp::endpoint records(asio::ip::address_v4(box.records.address), box.records.port);
      if (sockets_[f].open(udp::v4(), failure) || sockets_[f].non_blocking(true, failure) ||
          sockets_[f].bind(records, failure))
        return not_opened(box.records, failure);
      box.records.port = sockets_[f].local_endpoint().port();

      const tcp::endpoint pages(asio::ip::address_v4(box.pages.address), box.pages.port);
      auto& acceptor = acceptors_[f];
      if (acceptor.open(tcp::v4(), failure) ||
          acceptor.set_option(tcp::acceptor::reuse_address(true), failure) ||
          acceptor.bind(pages, failure) ||
          acceptor.listen(asio::socket_base::max_listen_connections, failure))
        return not_opened(box.pages, failure);
      box.pages.port = acceptor.local_endpoint().port();
      answers_[f] = [this, f](std::string_view target) { return answer(f, target); };
      accept(f);
      listen(f);
    }
    return std::nullopt;
  }

  Endpoint records(std::size_t finger) const override { return options_.boxes[finger].records; }
  Endpoint pages(std::size_t finger) const override { return options_.boxes[finger].pages; }

  Result<void> start(Clock& clock) override {
    if (clock.is_virtual())
      return refused("a real network does not run in virtual time"_text, "use the real clock"_text);
    clock_ = &clock;
    return {};
  }

  bool send(const BusFrame& frame) noexcept override {
    if (frame.id >= kFingerCount || !frame.is_standard())
      return true;  // a network has no such frames
    const auto& client = clients_[frame.id];
    beast::error_code failure;
    const auto bytes = frame.bytes();
    if (client)
      sockets_[frame.id].send_to(asio::buffer(bytes.data(), bytes.size()), *client, 0, failure);
    if (failure) ++counters_.unsent;
    return true;
  }

  BusEvent receive(Timestamp deadline, ReceivedFrame& out) noexcept override {
    try {
      while (true) {
        io_.poll();
        if (read_one(out)) return BusEvent::frame;
        if (clock_->now() >= deadline) return BusEvent::timeout;
        io_.run_one_until(std::chrono::steady_clock::time_point(deadline));
      }
    } catch (const std::exception&) {  // of one visitor to the pages, e.g. without memory
      ++counters_.error_frames;
      return BusEvent::timeout;
    }
  }

  BusCounters counters() const noexcept override { return counters_; }

 private:
  static Error not_opened(const Endpoint& where, const beast::error_code& failure) {
    return failed("an emulated box cannot listen here: %1"_text(Known{failure.message()}),
                  "use another address or port, or end the program that has it"_text)
        .about(where.text());
  }

  void accept(std::size_t finger) {
    acceptors_[finger].async_accept([this, finger](beast::error_code failure, tcp::socket socket) {
      if (failure == asio::error::operation_aborted) return;
      if (!failure) std::make_shared<PageVisit>(std::move(socket), answers_[finger])->begin();
      accept(finger);
    });
  }

  /// Only wakes receive(), which then reads.
  void listen(std::size_t finger) {
    sockets_[finger].async_wait(udp::socket::wait_read, [this, finger](beast::error_code failure) {
      if (failure == asio::error::operation_aborted) return;
      has_news_[finger] = true;
    });
  }

  bool read_one(ReceivedFrame& out) {
    for (std::size_t f = 0; f < kFingerCount; ++f) {
      while (has_news_[f]) {
        std::array<std::uint8_t, 256> bytes;
        udp::endpoint from;
        beast::error_code failure;
        const auto length = sockets_[f].receive_from(asio::buffer(bytes), from, 0, failure);
        if (failure == asio::error::would_block) {
          has_news_[f] = false;
          listen(f);
          break;
        }
        if (failure) continue;  // an earlier record was refused: nobody listens
        clients_[f] = from;
        out = {};
        out.frame.id = static_cast<std::uint32_t>(f);
        out.frame.length = static_cast<std::uint8_t>(std::min<std::size_t>(length, 255));
        std::copy_n(bytes.begin(), out.frame.bytes().size(), out.frame.data.begin());
        out.stamp = clock_->now();
        out.wall_time = read_clock(CLOCK_REALTIME);
        return true;
      }
    }
    return false;
  }

  std::optional<std::string> answer(std::size_t finger, std::string_view target) {
    constexpr std::string_view kRate = "/comm.cgi?comrdtrate=";
    NetFtBoxConfig& config = options_.boxes[finger].config;
    if (target == "/netftapi2.xml") return encode_net_ft_page(config);
    if (!target.starts_with(kRate) || !options_.set_rate) return std::nullopt;
    target.remove_prefix(kRate.size());
    double rate_Hz = 0.0;
    const auto [end, failure] =
        std::from_chars(target.data(), target.data() + target.size(), rate_Hz);
    if (failure != std::errc() || end != target.data() + target.size()) return std::nullopt;
    if (!options_.set_rate(finger, rate_Hz)) return std::nullopt;
    config.rate_Hz = rate_Hz;
    return "";
  }

  NetFtServerOptions options_;
  Clock* clock_ = nullptr;
  BusCounters counters_;
  std::array<Answer, kFingerCount> answers_;
  std::array<bool, kFingerCount> has_news_{};
  std::array<std::optional<udp::endpoint>, kFingerCount> clients_;
  asio::io_context io_{1};
  asio::executor_work_guard<asio::io_context::executor_type> work_{io_.get_executor()};
  std::array<udp::socket, kFingerCount> sockets_{udp::socket(io_), udp::socket(io_),
                                                 udp::socket(io_)};
  std::array<tcp::acceptor, kFingerCount> acceptors_{tcp::acceptor(io_), tcp::acceptor(io_),
                                                     tcp::acceptor(io_)};
};

}  // namespace

Result<std::unique_ptr<NetFtServer>> NetFtServer::open(NetFtServerOptions options) {
  try {
    auto boxes = std::make_unique<OpenBoxes>(std::move(options));
    if (const auto failure = boxes->open()) return *failure;
    return std::unique_ptr<NetFtServer>(std::move(boxes));
  } catch (const std::exception& problem) {
    return failed("the emulated boxes cannot be opened: %1"_text(problem.what()),
                  "close other programs and try again"_text);
  }
}

}  // namespace isograsp
