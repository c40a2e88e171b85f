// SPDX-License-Identifier: GPL-3.0-or-later
// Layouts as in device/markers/qtm_rt_codec.cpp, written here from the other end.
#include "device/emulator/emulated_qtm.hpp"

#include <bit>
#include <cmath>
#include <limits>

#include "core/csv.hpp"
#include "device/markers/little_endian.hpp"

namespace isograsp {

namespace {

constexpr std::uint32_t kToldError = 0, kToldCommand = 1, kToldXml = 2, kToldData = 3;
constexpr std::uint32_t kPoints3d = 1, kPoints3dResidual = 9;
constexpr std::size_t kPacketBegin = 8;
constexpr std::size_t kLongestCommand = 4096;
constexpr float kResidual_mm = 0.25F;

class Packet {
 public:
  explicit Packet(std::uint32_t type) {
    add<std::uint32_t>(0);
    add(type);
  }
  template <class Unsigned>
  void add(Unsigned value) {
    bytes_.resize(bytes_.size() + sizeof value);
    put_little_endian(std::span(bytes_), bytes_.size() - sizeof value, value);
  }
  void add(float value) { add(std::bit_cast<std::uint32_t>(value)); }
  void add_text(std::string_view text) {
    bytes_.insert(bytes_.end(), text.begin(), text.end());
    bytes_.push_back(0);
  }
  std::vector<std::uint8_t> done() && {
    put_little_endian(std::span(bytes_), 0, static_cast<std::uint32_t>(bytes_.size()));
    return std::move(bytes_);
  }

 private:
  std::vector<std::uint8_t> bytes_;
};

std::vector<std::uint8_t> told(std::uint32_t type, std::string_view text) {
  Packet packet(type);
  packet.add_text(text);
  return std::move(packet).done();
}

std::string xml_text(std::string_view text) {
  std::string safe;
  for (const char c : text) {
    if (c == '<')
      safe += "&lt;";
    else if (c == '&')
      safe += "&amp;";
    else
      safe += c;
  }
  return safe;
}

std::string parameters(std::string_view asked, const std::vector<std::string>& labels,
                       double rate_Hz) {
  std::string xml = "<QTM_Parameters_Ver_1.23>";
  if (asked.find("General") != std::string_view::npos)
    xml += "<General><Frequency>" + format_number(rate_Hz) + "</Frequency></General>";
  if (asked.find("3D") != std::string_view::npos) {
    xml += "<The_3D><AxisUpwards>+Z</AxisUpwards><Labels>" + std::to_string(labels.size()) +
           "</Labels>";
    for (const std::string& label : labels)
      xml += "<Label><Name>" + xml_text(label) + "</Name><RGBColor>65280</RGBColor></Label>";
    xml += "</The_3D>";
  }
  return xml + "</QTM_Parameters_Ver_1.23>";
}

}  // namespace

std::vector<std::uint8_t> EmulatedQtmClient::greeting() {
  return told(kToldCommand, "QTM RT Interface connected");
}

std::optional<std::vector<std::uint8_t>> EmulatedQtmClient::answer(
    std::span<const std::uint8_t> bytes, const std::vector<std::string>& labels, double rate_Hz) {
  waiting_.insert(waiting_.end(), bytes.begin(), bytes.end());
  std::vector<std::uint8_t> answers;
  std::size_t at = 0;
  while (waiting_.size() - at >= kPacketBegin) {
    const std::size_t size = little_endian<std::uint32_t>(waiting_, at);
    if (size < kPacketBegin || size > kLongestCommand) return std::nullopt;
    if (waiting_.size() - at < size) break;
    if (little_endian<std::uint32_t>(waiting_, at + 4) == kToldCommand) {
      const std::string_view text(
          reinterpret_cast<const char*>(waiting_.data()) + at + kPacketBegin, size - kPacketBegin);
      const auto said = command(text.substr(0, text.find('\0')), labels, rate_Hz);
      answers.insert(answers.end(), said.begin(), said.end());
    }
    at += size;
  }
  waiting_.erase(waiting_.begin(), waiting_.begin() + static_cast<std::ptrdiff_t>(at));
  return answers;
}

std::vector<std::uint8_t> EmulatedQtmClient::command(std::string_view text,
                                                     const std::vector<std::string>& labels,
                                                     double rate_Hz) {
  constexpr std::string_view kVersion = "Version ", kParameters = "GetParameters ",
                             kStream = "StreamFrames ";
  if (text.starts_with(kVersion)) {
    const auto wanted = text.substr(kVersion.size());
    if (!wanted.starts_with("1.")) return told(kToldError, "Version NOT supported");
    return told(kToldCommand, "Version set to " + std::string(wanted));
  }
  if (text.starts_with(kParameters)) {
    if (text.find("3D") == std::string_view::npos && text.find("General") == std::string_view::npos)
      return told(kToldError, "Parse error");
    return told(kToldXml, parameters(text.substr(kParameters.size()), labels, rate_Hz));
  }
  if (text == "StreamFrames Stop") {
    streaming_ = false;
    return {};
  }
  if (text.starts_with(kStream)) {
    if (!text.starts_with("StreamFrames AllFrames 3D")) return told(kToldError, "Parse error");
    streaming_ = true;
    with_residual_ = text.find("3DRes") != std::string_view::npos;
    return {};
  }
  return told(kToldError, "Parse error");
}

std::vector<std::uint8_t> EmulatedQtmClient::frame(const MarkerPicture& picture) const {
  constexpr double kMicroseconds = 1e6, kMillimetres = 1e3;
  const std::size_t marker = with_residual_ ? 16 : 12;
  Packet packet(kToldData);
  packet.add(static_cast<std::uint64_t>(std::llround(kMicroseconds * picture.stamp_s)));
  packet.add(picture.frame);
  packet.add<std::uint32_t>(1);
  packet.add(static_cast<std::uint32_t>(kPacketBegin + 8 + marker * picture.p_W.size()));
  packet.add(with_residual_ ? kPoints3dResidual : kPoints3d);
  packet.add(static_cast<std::uint32_t>(picture.p_W.size()));
  packet.add<std::uint32_t>(0);  // drop rate and pictures out of step
  for (const Vec3& p : picture.p_W) {
    for (const double c : p) packet.add(static_cast<float>(kMillimetres * c));
    if (with_residual_)
      packet.add(p.allFinite() ? kResidual_mm : std::numeric_limits<float>::quiet_NaN());
  }
  return std::move(packet).done();
}

}  // namespace isograsp
