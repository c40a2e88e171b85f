// SPDX-License-Identifier: GPL-3.0-or-later
// Layouts as in device/markers/natnet_codec.cpp and natnet_models.cpp, written here from the other
// end.
#include "device/emulator/emulated_natnet.hpp"

#include <bit>
#include <cmath>
#include <functional>
#include <string_view>

#include "device/markers/little_endian.hpp"

namespace isograsp {

namespace {

constexpr std::string_view kSet = "Markers";
constexpr std::uint32_t kModel = 7;  ///< of the body that has the name of the set
constexpr std::uint16_t kMarkedUnseen = 1;

class Message {
 public:
  Message(std::uint16_t kind, NatNetLayout layout) : layout_(layout) {
    add(kind);
    add<std::uint16_t>(0);
  }
  template <class Unsigned>
  void add(Unsigned value) {
    bytes_.resize(bytes_.size() + sizeof value);
    put_little_endian(std::span(bytes_), bytes_.size() - sizeof value, value);
  }
  void add_count(std::size_t value) { add(static_cast<std::uint32_t>(value)); }
  void add_single(double value) { add(std::bit_cast<std::uint32_t>(static_cast<float>(value))); }
  void add_double(double value) { add(std::bit_cast<std::uint64_t>(value)); }
  void add_singles(std::size_t count, double value) {
    for (std::size_t k = 0; k < count; ++k) add_single(value);
  }
  void add_vector(const Vec3& p) {
    for (const double c : p) add_single(c);
  }
  void add_text(std::string_view text) {
    bytes_.insert(bytes_.end(), text.begin(), text.end());
    bytes_.push_back(0);
  }
  /// A count, the size of what follows where the version tells it, and what follows.
  void add_list(std::size_t count, const std::function<void()>& items) {
    add_count(count);
    add_sized(items);
  }
  void add_sized(const std::function<void()>& content) {
    const std::size_t at = bytes_.size();
    if (layout_.byte_counts) add<std::uint32_t>(0);
    content();
    if (layout_.byte_counts)
      put_little_endian(std::span(bytes_), at, static_cast<std::uint32_t>(bytes_.size() - at - 4));
  }
  [[nodiscard]] const NatNetLayout& layout() const noexcept { return layout_; }
  std::vector<std::uint8_t> done() && {
    put_little_endian(std::span(bytes_), 2, static_cast<std::uint16_t>(bytes_.size() - 4));
    return std::move(bytes_);
  }

 private:
  NatNetLayout layout_;
  std::vector<std::uint8_t> bytes_;
};

/// A body as frames hold it.
void add_body(Message& message, std::uint32_t id) {
  message.add(id);
  message.add_singles(6, 0.5);
  message.add_single(1.0);
  if (message.layout().markers_in_bodies) {
    message.add_count(2);
    message.add_singles(6, 0.25);
    message.add_count(1);
    message.add_count(2);
    message.add_singles(2, 0.01);
  }
  message.add_single(0.0);
  if (message.layout().flags) message.add<std::uint16_t>(1);
}

/// A body as it is described.
void add_body_description(Message& message, std::string_view name, std::uint32_t id,
                          const std::vector<std::string>& labels) {
  message.add_text(name);
  message.add(id);
  message.add<std::uint32_t>(0xFFFFFFFFU);
  message.add_singles(3, 0.0);
  if (message.layout().markers_in_bodies) return;
  message.add_count(labels.size());
  message.add_singles(3 * labels.size(), 0.1);
  for (std::size_t k = 0; k < labels.size(); ++k) message.add_count(0);
  if (message.layout().marker_names)
    for (const std::string& label : labels) message.add_text(label);
}

void add_analogue(Message& message) {
  message.add_list(1, [&] {
    message.add<std::uint32_t>(1);
    message.add_count(2);
    for (int channel = 0; channel < 2; ++channel) {
      message.add_count(3);
      message.add_singles(3, 1.5);
    }
  });
}

/// In place of a position: nothing was seen.
Vec3 wire_position(const Vec3& p) {
  return p.allFinite() ? p : Vec3(Vec3::Zero());
}

}  // namespace

std::vector<std::uint8_t> EmulatedNatNet::answer(std::span<const std::uint8_t> request,
                                                 const std::vector<std::string>& labels,
                                                 double rate_Hz, bool& stays) const {
  stays = false;
  if (request.size() < 4) return {};
  const auto body = request.subspan(4);
  const std::string_view text(reinterpret_cast<const char*>(body.data()), body.size());
  switch (little_endian<std::uint16_t>(request, 0)) {
    case NatNetMessage::kConnect: stays = true; return server();
    case NatNetMessage::kKeepAlive: stays = true; return {};
    case NatNetMessage::kAskModels: return models(labels);
    case NatNetMessage::kRequest: {
      if (!text.starts_with("FrameRate")) return {};
      Message message(NatNetMessage::kResponse, NatNetLayout(options_.version));
      message.add_single(rate_Hz);
      return std::move(message).done();
    }
    default: return {};
  }
}

std::vector<std::uint8_t> EmulatedNatNet::server() const {
  constexpr std::size_t kName = 256;
  Message message(NatNetMessage::kServer, NatNetLayout(options_.version));
  std::string name = "IsoGrasp";
  name.resize(kName - 1, '\0');
  message.add_text(name);
  for (const int part : {3, 0, 0, 0, options_.version.major, options_.version.minor, 0, 0})
    message.add(static_cast<std::uint8_t>(part));
  if (options_.version.at_least(3, 0)) {
    message.add<std::uint64_t>(10'000'000);
    message.add(options_.data_port);
    message.add<std::uint8_t>(options_.group != 0 ? 1 : 0);
    for (unsigned shift = 32; shift > 0; shift -= 8)
      message.add(static_cast<std::uint8_t>(options_.group >> (shift - 8)));
  }
  return std::move(message).done();
}

std::vector<std::uint8_t> EmulatedNatNet::models(const std::vector<std::string>& labels) const {
  Message message(NatNetMessage::kModels, NatNetLayout(options_.version));
  const auto add = [&](std::uint32_t kind, const std::function<void()>& content) {
    message.add(kind);
    message.add_sized(content);
  };
  const auto add_set = [&](std::string_view name) {
    add(0, [&] {
      message.add_text(name);
      message.add_count(labels.size());
      for (const std::string& label : labels) message.add_text(label);
    });
  };
  const NatNetLayout& layout = message.layout();
  message.add_count(layout.assets ? 6 : layout.camera_ticks ? 5 : 4);
  add_set("all");
  add_set(kSet);
  add(1, [&] { add_body_description(message, kSet, kModel, labels); });
  add(2, [&] {
    message.add_text("Skeleton");
    message.add<std::uint32_t>(2);
    message.add_count(1);
    add_body_description(message, "Hip", 1, {"HipTop"});
  });
  if (layout.camera_ticks)
    add(5, [&] {
      message.add_text("Camera 1");
      message.add_singles(7, 0.5);
    });
  if (layout.assets)
    add(6, [&] {
      message.add_text("Asset");
      message.add<std::uint32_t>(1);
      message.add<std::uint32_t>(9);
      message.add_count(1);
      add_body_description(message, "Bone", 1, {});
      message.add_count(0);
    });
  return std::move(message).done();
}

std::vector<std::uint8_t> EmulatedNatNet::frame(const MarkerPicture& picture) const {
  Message message(NatNetMessage::kFrame, NatNetLayout(options_.version));
  const NatNetLayout& layout = message.layout();
  message.add(picture.frame);
  message.add_list(2, [&] {
    for (const std::string_view name : {std::string_view("all"), kSet}) {
      message.add_text(name);
      message.add_count(picture.p_W.size());
      for (const Vec3& p : picture.p_W) message.add_vector(wire_position(p));
    }
  });
  message.add_list(1, [&] { message.add_singles(3, 0.75); });
  message.add_list(1, [&] { add_body(message, kModel); });
  message.add_list(1, [&] {
    message.add<std::uint32_t>(2);
    message.add_count(1);
    add_body(message, 1);
  });
  if (layout.assets)
    message.add_list(1, [&] {
      message.add<std::uint32_t>(9);
      message.add_count(1);
      add_body(message, 1);
      message.add_count(1);
      message.add<std::uint32_t>(1);
      message.add_singles(4, 0.5);
      message.add<std::uint16_t>(0);
      message.add_single(0.0);
    });
  message.add_list(picture.p_W.size(), [&] {
    for (std::size_t k = 0; k < picture.p_W.size(); ++k) {
      message.add(kModel << 16 | static_cast<std::uint32_t>(k + 1));
      message.add_vector(wire_position(picture.p_W[k]));
      message.add_single(0.014);
      if (layout.flags) message.add(picture.p_W[k].allFinite() ? std::uint16_t{0} : kMarkedUnseen);
      if (layout.camera_ticks) message.add_single(0.0002);
    }
  });
  if (layout.force_plates) add_analogue(message);
  if (layout.devices) add_analogue(message);
  message.add<std::uint32_t>(0);
  message.add<std::uint32_t>(0);
  if (layout.double_stamps)
    message.add_double(picture.stamp_s);
  else
    message.add_single(picture.stamp_s);
  if (layout.camera_ticks)
    for (int k = 0; k < 3; ++k)
      message.add(static_cast<std::uint64_t>(std::llround(1e7 * picture.stamp_s)));
  if (layout.precise_stamps) {
    message.add<std::uint32_t>(0);
    message.add<std::uint32_t>(0);
  }
  message.add<std::uint16_t>(0);
  message.add<std::uint32_t>(0);  // the end
  return std::move(message).done();
}

}  // namespace isograsp
