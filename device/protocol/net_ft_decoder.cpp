// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/protocol/net_ft_decoder.hpp"

#include <algorithm>

#include "device/codec/net_ft_box_config.hpp"
#include "device/config/net_ft_sensor.hpp"

namespace isograsp {

void NetFtDecoder::push(std::span<const std::uint8_t> datagram, Timestamp stamp,
                        std::vector<NetFtSample>& samples) {
  if (!holds_net_ft_records(datagram.size())) {
    ++(decode_net_ft_request(datagram) ? requests_ : foreign_);
    return;
  }
  for (; !datagram.empty(); datagram = datagram.subspan(kNetFtRecord)) {
    const auto record = decode_net_ft_record(datagram.first(kNetFtRecord));
    using Place = NetFtSequence::Place;
    const Place place = sequence_.push(*record, stamp);
    if (place == Place::duplicate || place == Place::impossible) continue;
    samples.push_back(
        {stamp, *record, wrench_of(record->raw, scale_), judge(*record, product_).valid()});
  }
}

std::optional<std::size_t> NetFtFingers::finger_of(const Endpoint& from) const noexcept {
  for (std::size_t f = 0; f < kFingerCount; ++f)
    if (box[f] && box[f]->address == from.address &&
        (box[f]->port == 0 || box[f]->port == from.port))
      return f;
  return std::nullopt;
}

Result<NetFtFingers> NetFtFingers::in_order(std::vector<Endpoint> senders, const std::string& log) {
  std::sort(senders.begin(), senders.end());
  senders.erase(std::unique(senders.begin(), senders.end()), senders.end());
  if (senders.empty())
    return refused("no datagram of this log holds records of a Net F/T box"_text,
                   "check that it is a log of this protocol"_text)
        .at(log);
  if (senders.size() > kFingerCount)
    return refused(
               "%1 boxes send records, the last is %2"_text(senders.size(), senders.back().text()),
               "say with --config which three are under the fingers"_text)
        .at(log);
  NetFtFingers fingers;
  std::copy(senders.begin(), senders.end(), fingers.box.begin());
  return fingers;
}

Result<NetFtFingers> NetFtFingers::of(const DeviceConfig& config) {
  NetFtFingers fingers;
  for (std::size_t f = 0; f < kFingerCount; ++f) {
    const std::string& host = config.sensors[f].as<NetFtSensor>().host;
    if (const auto address = NetFtAddress::parse(host)) {
      fingers.box[f] = address->records;
      if (host.find(':') == std::string::npos) fingers.box[f]->port = 0;
    }
    if (!fingers.box[f])
      return refused("the box of the %1 has the address '%2', which is not in numbers"_text(
                         kFingerNames[f], host),
                     "write it as 192.168.1.1"_text)
          .about("address");
  }
  return fingers;
}

}  // namespace isograsp
