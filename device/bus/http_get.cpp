// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/bus/http_get.hpp"

#include <exception>
#include <utility>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>

namespace isograsp {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = boost::beast::http;

namespace {

constexpr std::uint64_t kLargestBody = std::uint64_t{256} * 1024;
constexpr std::uint16_t kUsualPort = 80;
constexpr unsigned kHttp11 = 11;

/// Runs one step to its end. The stream's expiry bounds it.
template <class Begin>
beast::error_code run_step(asio::io_context& io, Begin&& begin) {
  beast::error_code outcome;
  begin([&](beast::error_code failure, auto&&...) { outcome = failure; });
  io.run();
  io.restart();
  return outcome;
}

Text reason(const beast::error_code& failure) {
  if (failure == beast::error::timeout) return "it does not answer in time"_text;
  if (failure == asio::error::connection_refused) return "it refuses the connection"_text;
  return Known{failure.message()};
}

}  // namespace

Result<std::string> http_get(const Endpoint& server, const std::string& target, Timestamp limit) {
  const std::string host = server.port == kUsualPort ? server.address_text() : server.text();
  const auto not_answered = [&](Text what) {
    return failed(std::move(what),
                  "check the device's power, its network cable and its address"_text)
        .at("http://" + host + target);
  };
  try {
    asio::io_context io(1);
    beast::tcp_stream stream(io);
    stream.expires_after(limit);
    const asio::ip::tcp::endpoint peer(asio::ip::address_v4(server.address), server.port);
    auto failure = run_step(io, [&](auto done) { stream.async_connect(peer, done); });
    if (failure) return not_answered("the device cannot be reached: %1"_text(reason(failure)));

    http::request<http::empty_body> request(http::verb::get, target, kHttp11);
    request.set(http::field::host, host);
    request.set(http::field::connection, "close");
    failure = run_step(io, [&](auto done) { http::async_write(stream, request, done); });
    if (failure) return not_answered("the device cannot be asked: %1"_text(reason(failure)));

    beast::flat_buffer buffer;
    http::response_parser<http::string_body> response;
    response.body_limit(kLargestBody);
    failure = run_step(io, [&](auto done) { http::async_read(stream, buffer, response, done); });
    if (failure)
      return not_answered("the device's answer cannot be read: %1"_text(reason(failure)));
    if (response.get().result() != http::status::ok)
      return not_answered(
          "the device answers with HTTP status %1"_text(response.get().result_int()));
    return std::move(response.get().body());
  } catch (const std::exception& problem) {
    return not_answered("the device cannot be asked: %1"_text(problem.what()));
  }
}

}  // namespace isograsp
