// SPDX-License-Identifier: GPL-3.0-or-later
// Pages of emulated boxes over real connections of the loopback interface.
#include "device/protocol/net_ft_setup.hpp"

#include <atomic>
#include <memory>
#include <thread>

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include "device/bus/http_get.hpp"
#include "device/config/net_ft_sensor.hpp"
#include "device/emulator/net_ft_server.hpp"

namespace isograsp::net_ft_setup_test {
namespace {

using namespace std::chrono_literals;

constexpr Timestamp kPatience = 10s;
constexpr std::uint32_t kLoopback = 0x7F000001;

/// Three boxes that serve their pages in a thread of their own.
class Boxes {
 public:
  explicit Boxes(NetFtBoxConfig config = good(),
                 std::function<bool(std::size_t, double)> set_rate = {}) {
    NetFtServerOptions options;
    for (std::uint32_t f = 0; f < kFingerCount; ++f)
      options.boxes[f] = {{kLoopback + f, 0}, {kLoopback + f, 0}, config};
    options.set_rate = std::move(set_rate);
    server = NetFtServer::open(options).value();
    EXPECT_TRUE(server->start(clock_));
    thread_ = std::thread([this] {
      ReceivedFrame in;
      while (!ended_) (void)server->receive(clock_.now() + 2ms, in);
    });
  }
  ~Boxes() {
    ended_ = true;
    thread_.join();
  }
  [[nodiscard]] static NetFtBoxConfig good() {
    NetFtBoxConfig config;
    config.product_name = "Emulated Net F/T";
    config.serial_number = "FT00001";
    config.rate_Hz = 100.0;
    return config;
  }
  [[nodiscard]] DeviceConfig device(double rate_Hz = 100.0) const {
    auto config = DeviceConfig::standard(kNetFtFamily);
    config.rate_Hz = rate_Hz;
    for (std::size_t f = 0; f < kFingerCount; ++f)
      config.sensors[f].connection =
          NetFtSensor{server->records(f).text() + ":" + std::to_string(server->pages(f).port)};
    return config;
  }

  std::unique_ptr<NetFtServer> server;

 private:
  SteadyClock clock_;
  std::atomic<bool> ended_{false};
  std::thread thread_;
};

TEST(HttpGet, FetchesAPage) {
  const Boxes boxes;
  const auto page = http_get(boxes.server->pages(1), "/netftapi2.xml", kPatience);
  ASSERT_TRUE(page) << page.error().message();
  EXPECT_EQ(*page, encode_net_ft_page(Boxes::good()));
}

TEST(HttpGet, ErrorsNameThePage) {
  const Boxes boxes;
  const auto missing = http_get(boxes.server->pages(0), "/other.xml", kPatience);
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().file, "http://" + boxes.server->pages(0).text() + "/other.xml");
  EXPECT_NE(english(missing.error().what).find("404"), std::string::npos);

  const Endpoint nobody = [] {
    return Boxes().server->pages(0);  // closed again
  }();
  const auto refused = http_get(nobody, "/netftapi2.xml", kPatience);
  ASSERT_FALSE(refused);
  EXPECT_NE(english(refused.error().what).find("refuses"), std::string::npos)
      << english(refused.error().what);
}

TEST(HttpGet, DoesNotWaitForADeviceThatSaysNothing) {
  const int silent = ::socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(kLoopback);
  socklen_t size = sizeof address;
  ASSERT_EQ(::bind(silent, reinterpret_cast<sockaddr*>(&address), size), 0);
  ASSERT_EQ(::listen(silent, 1), 0);
  ASSERT_EQ(::getsockname(silent, reinterpret_cast<sockaddr*>(&address), &size), 0);
  const auto page = http_get({kLoopback, ntohs(address.sin_port)}, "/netftapi2.xml", 50ms);
  ASSERT_FALSE(page);
  EXPECT_NE(english(page.error().what).find("in time"), std::string::npos)
      << english(page.error().what);
  ::close(silent);
}

TEST(NetFtSetup, AsksTheBox) {
  const Boxes boxes;
  for (std::size_t f = 0; f < kFingerCount; ++f) {
    const auto said = set_up_net_ft_box(boxes.device(), f, kPatience);
    ASSERT_TRUE(said) << said.error().message();
    EXPECT_EQ(said->serial_number, "FT00001");
    EXPECT_EQ(said->rate_Hz, 100.0);
  }
}

TEST(NetFtSetup, SetsTheRate) {
  std::vector<double> asked;
  const Boxes boxes(Boxes::good(), [&](std::size_t finger, double rate_Hz) {
    EXPECT_EQ(finger, 2u);
    asked.push_back(rate_Hz);
    return true;
  });
  const auto said = set_up_net_ft_box(boxes.device(500.0), 2, kPatience);
  ASSERT_TRUE(said) << said.error().message();
  EXPECT_EQ(said->rate_Hz, 500.0);
  EXPECT_EQ(asked, std::vector<double>{500.0});
}

TEST(NetFtSetup, TakesTheRateThatTheBoxMadeOfIt) {
  auto config = Boxes::good();
  config.rate_Hz = 1000.0 / 3.0;
  const Boxes boxes(config);
  EXPECT_TRUE(set_up_net_ft_box(boxes.device(333.0), 0, kPatience));
}

TEST(NetFtSetup, RefusesABoxThatKeepsItsRate) {
  const Boxes boxes;
  const auto said = set_up_net_ft_box(boxes.device(500.0), 0, kPatience);
  ASSERT_FALSE(said);
  EXPECT_NE(english(said.error().what).find("thumb"), std::string::npos);
}

TEST(NetFtSetup, RefusesTheWrongSensorInPlainWords) {
  const Boxes boxes;
  auto config = boxes.device();
  config.sensors[1].serial_number = "FT27462";
  EXPECT_TRUE(set_up_net_ft_box(config, 0, kPatience));
  const auto said = set_up_net_ft_box(config, 1, kPatience);
  ASSERT_FALSE(said);
  EXPECT_EQ(english(said.error().what),
            "the index's sensor has the serial number 'FT00001', but the configuration says "
            "'FT27462'");
  EXPECT_EQ(english(said.error().remedy), "connect the right sensor or correct serial_number");
}

TEST(NetFtSetup, NamesTheFingerOfABoxThatIsNotThere) {
  auto config = Boxes().device();  // closed again
  const auto said = set_up_net_ft_box(config, 2, kPatience);
  ASSERT_FALSE(said);
  EXPECT_NE(english(said.error().what).find("the middle's sensor"), std::string::npos);
  config.sensors[2].connection = NetFtSensor{"box.clinic"};
  const auto named = set_up_net_ft_box(config, 2, kPatience);
  ASSERT_FALSE(named);
  EXPECT_EQ(named.error().code, Error::Code::bad_input);
}

TEST(NetFtServer, TakesRequestsAndSendsRecordsToWhoAsked) {
  NetFtServerOptions options;
  for (std::uint32_t f = 0; f < kFingerCount; ++f)
    options.boxes[f] = {{kLoopback + f, 0}, {kLoopback + f, 0}, Boxes::good()};
  const auto server = NetFtServer::open(options).value();
  SteadyClock clock;
  ASSERT_TRUE(server->start(clock));
  const auto client =
      open_udp({server->records(0).text(), server->records(1).text(), server->records(2).text()})
          .value();
  ASSERT_TRUE(client->start(clock));
  ReceivedFrame in;
  for (std::uint32_t f = 0; f < kFingerCount; ++f) {
    const auto request = encode_net_ft_request(f, {NetFtCommand::start, 0});
    ASSERT_TRUE(client->send(request));
    ASSERT_EQ(server->receive(clock.now() + kPatience, in), BusEvent::frame);
    EXPECT_EQ(in.frame, request);
    const auto record = encode_net_ft_record(f, {1, 7, 0, {1, 2, 3, 4, 5, 6}});
    EXPECT_TRUE(server->send(record));
    ASSERT_EQ(client->receive(clock.now() + kPatience, in), BusEvent::frame);
    EXPECT_EQ(in.frame, record);
  }
  options.boxes[1].records = server->records(1);
  const auto second = NetFtServer::open(options);
  ASSERT_FALSE(second) << "the address is in use";
  EXPECT_EQ(second.error().field, server->records(1).text());
}

}  // namespace
}  // namespace isograsp::net_ft_setup_test
