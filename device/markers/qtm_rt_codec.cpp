// SPDX-License-Identifier: GPL-3.0-or-later
// Packet: int32 size of all of it, int32 type (0 error, 1 command, 2 XML, 3 data, …). Data: int64
// time [us], uint32 frame, uint32 components; component: uint32 size of all of it, uint32 type (1
// 3D, 9 3D with residual, …). 3D: uint32 markers, int16 drop rate, int16 out of sync, then x, y, z
// [mm] (and the residual) as float32; NaN: not seen.
#include "device/markers/qtm_rt_codec.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <sstream>

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>

#include "device/markers/little_endian.hpp"
#include "device/markers/marker_reader.hpp"

namespace isograsp {

namespace {

constexpr std::size_t kPacketHead = 8;
constexpr std::uint32_t kError = 0;
constexpr std::uint32_t kCommand = 1;
constexpr std::uint32_t kXml = 2;
constexpr std::uint32_t kData = 3;
constexpr std::size_t kDataHead = 16;
constexpr std::size_t kComponentHead = 8;
constexpr std::size_t kMarkersHead = 8;
constexpr std::uint32_t k3d = 1;
constexpr std::uint32_t k3dWithResidual = 9;

std::string_view text_in(std::span<const std::uint8_t> bytes) noexcept {
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  return text.substr(0, text.find('\0'));
}

/// Elements within elements, at most so many: the parser works by recursion. QTM needs six.
constexpr int kDeepestXml = 64;

/// Passes over markup from `at` on, up to behind `end`; to the end of the text if that is not
/// there.
std::size_t behind(std::string_view xml, std::size_t at, std::string_view end) noexcept {
  const auto found = xml.find(end, at);
  return found == std::string_view::npos ? xml.size() : found + end.size();
}

/// Whether elements are nested deeper than kDeepestXml. Quotes in tags, comments and text that is
/// no markup are passed over as a parser does.
bool is_nested_too_deeply(std::string_view xml) noexcept {
  int depth = 0;
  for (std::size_t at = xml.find('<'); at < xml.size(); at = xml.find('<', at)) {
    const std::string_view rest = xml.substr(at);
    if (rest.starts_with("<!--")) {
      at = behind(xml, at, "-->");
    } else if (rest.starts_with("<![CDATA[")) {
      at = behind(xml, at, "]]>");
    } else if (rest.starts_with("<?")) {
      at = behind(xml, at, "?>");
    } else if (rest.starts_with("<!") || rest.starts_with("</")) {
      if (rest[1] == '/') --depth;
      at = behind(xml, at, ">");
    } else {
      if (++depth > kDeepestXml) return true;
      char quote = 0;
      for (++at; at < xml.size() && (quote != 0 || xml[at] != '>'); ++at) {
        if (quote != 0 ? xml[at] == quote : xml[at] == '"' || xml[at] == '\'')
          quote = quote != 0 ? char{0} : xml[at];
      }
      if (at < xml.size() && xml[at - 1] == '/') --depth;
    }
  }
  return false;
}

/// What the XML of the parameters says of the markers.
struct Parameters {
  std::vector<std::string> labels;
  std::optional<double> rate_Hz;
};
Parameters parameters_in(std::string_view xml) {
  boost::property_tree::ptree tree;
  std::istringstream in{std::string(xml)};
  boost::property_tree::read_xml(in, tree);
  Parameters found;
  for (const auto& [root, content] : tree) {
    const double rate_Hz = content.get<double>("General.Frequency", 0.0);
    if (rate_Hz > 0.0 && std::isfinite(rate_Hz)) found.rate_Hz = rate_Hz;
    const auto points = content.get_child_optional("The_3D");
    if (!points) continue;
    for (const auto& [key, label] : *points)
      if (key == "Label")
        found.labels.emplace_back(without_subject(label.get<std::string>("Name", "")));
  }
  return found;
}

}  // namespace

void QtmRtStream::add(std::span<const std::uint8_t> bytes) {
  if (at_ == waiting_.size()) {
    waiting_.clear();
    at_ = 0;
  } else if (waiting_.size() + bytes.size() > waiting_.capacity()) {
    waiting_.erase(waiting_.begin(), waiting_.begin() + static_cast<std::ptrdiff_t>(at_));
    at_ = 0;
  }
  waiting_.insert(waiting_.end(), bytes.begin(), bytes.end());
}

QtmRtStream::Step QtmRtStream::next(Row& row) noexcept {
  if (trouble_ == Trouble::boundary || trouble_ == Trouble::xml) return Step::lost;
  while (waiting_.size() - at_ >= kPacketHead) {
    const std::size_t size = little_endian<std::uint32_t>(waiting_, at_);
    if (size < kPacketHead || size > kLargestPacket) {
      wrong_size_ = size;
      return lose(Trouble::boundary);
    }
    if (waiting_.size() - at_ < size) break;
    const auto bytes = std::span<const std::uint8_t>(waiting_).subspan(at_, size);
    at_ += size;
    ++counts_.packets;
    if (const auto step = packet(bytes, row)) return *step;
  }
  return Step::more;
}

std::optional<QtmRtStream::Step> QtmRtStream::packet(std::span<const std::uint8_t> bytes,
                                                     Row& row) {
  const auto body = bytes.subspan(kPacketHead);
  switch (little_endian<std::uint32_t>(bytes, 4)) {
    case kError: message_ = text_in(body); return Step::refusal;
    case kCommand: message_ = text_in(body); return Step::message;
    case kXml: return parameters(body);
    case kData:
      if (data(body, row)) return Step::row;
      return std::nullopt;
    default: ++counts_.passed_over; return std::nullopt;
  }
}

QtmRtStream::Step QtmRtStream::parameters(std::span<const std::uint8_t> xml) {
  if (!told_.empty() && std::equal(xml.begin(), xml.end(), told_.begin(), told_.end())) {
    foreign_ = false;
    return Step::labels;
  }
  try {
    const std::string_view text = text_in(xml);
    if (is_nested_too_deeply(text)) {
      xml_problem_ = "elements are nested too deeply";
      return lose(Trouble::xml);
    }
    Parameters found = parameters_in(text);
    if (found.labels.empty()) {
      if (!rate_Hz_) rate_Hz_ = found.rate_Hz;
      return Step::no_labels;
    }
    foreign_ = !labels_.empty() && found.labels != labels_;
    if (foreign_) {
      trouble_ = Trouble::labels;
      return Step::other_labels;
    }
    labels_ = std::move(found.labels);
    rate_Hz_ = found.rate_Hz;
    told_.assign(xml.begin(), xml.end());
    p_W_.resize(labels_.size());
    // Room for what arrives at once while frames of these markers come.
    constexpr std::size_t kAtOnce = std::size_t{256} << 10;
    constexpr std::size_t kLargestMarker = 16;
    waiting_.reserve(2 * (kAtOnce + labels_.size() * kLargestMarker));
    return Step::labels;
  } catch (const boost::property_tree::xml_parser_error& problem) {
    xml_problem_ = problem.message();
  } catch (const std::exception& problem) {  // no memory
    xml_problem_ = problem.what();
  }
  return lose(Trouble::xml);
}

bool QtmRtStream::markers(std::span<const std::uint8_t> component, std::size_t floats) noexcept {
  constexpr double kMillimetre = 1e-3;
  if (component.size() < kMarkersHead) return false;
  const std::size_t count = little_endian<std::uint32_t>(component, 0);
  if (count != labels_.size() || (component.size() - kMarkersHead) / (4 * floats) < count)
    return false;
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t at = kMarkersHead + k * 4 * floats;
    const auto number = [&](std::size_t i) {
      return static_cast<double>(little_endian_float(component, at + 4 * i));
    };
    const bool lost = floats == 4 && number(3) < 0.0;
    p_W_[k] = lost ? unseen_marker()
                   : unseen_at_origin(kMillimetre * Vec3(number(0), number(1), number(2)));
  }
  return true;
}

bool QtmRtStream::data(std::span<const std::uint8_t> bytes, Row& row) noexcept {
  if (bytes.size() < kDataHead) {
    ++counts_.passed_over;
    return false;
  }
  const auto stamp_us = static_cast<std::int64_t>(little_endian<std::uint64_t>(bytes, 0));
  const auto frame = little_endian<std::uint32_t>(bytes, 8);
  const auto components = little_endian<std::uint32_t>(bytes, 12);
  std::size_t at = kDataHead;
  for (std::uint32_t c = 0; c < components && bytes.size() - at >= kComponentHead; ++c) {
    const std::size_t size = little_endian<std::uint32_t>(bytes, at);
    if (size < kComponentHead || size > bytes.size() - at) break;
    const auto type = little_endian<std::uint32_t>(bytes, at + 4);
    const auto component = bytes.subspan(at + kComponentHead, size - kComponentHead);
    at += size;
    if (type != k3d && type != k3dWithResidual) {
      ++counts_.passed_over;
      continue;
    }
    if (labels_.empty() || foreign_ || !markers(component, type == k3d ? 3 : 4)) {
      ++counts_.unlabelled;
      return false;
    }
    row = {stamp_us, frame, p_W_};
    return true;
  }
  return false;
}

bool QtmRtStream::is_new(std::uint32_t frame) noexcept {
  if (last_frame_ && frame <= *last_frame_) {
    ++counts_.repeated;
    return false;
  }
  last_frame_ = frame;
  ++counts_.frames;
  return true;
}

QtmRtStream::Step QtmRtStream::lose(Trouble trouble) noexcept {
  trouble_ = trouble;
  return Step::lost;
}

Error QtmRtStream::problem() const {
  switch (trouble_) {
    case Trouble::xml:
      return refused("the parameters of QTM are broken: %1"_text(Known{xml_problem_}),
                     "record the stream again"_text);
    case Trouble::labels:
      return refused("the labels change within the stream"_text,
                     "record each set of markers by itself"_text);
    default:
      return refused("no packet begins where one should (%1 bytes)"_text(wrong_size_),
                     "check that it is a stream of QTM, little endian"_text);
  }
}

void QtmRtStream::restart() noexcept {
  waiting_.clear();
  at_ = 0;
  message_ = {};
  last_frame_.reset();
  trouble_ = Trouble::none;
  foreign_ = false;
}

std::size_t encode_qtm_rt_command(std::string_view command, std::span<std::uint8_t> out) noexcept {
  const std::size_t size = kPacketHead + command.size() + 1;
  put_little_endian(out, 0, static_cast<std::uint32_t>(size));
  put_little_endian(out, 4, kCommand);
  std::memcpy(out.data() + kPacketHead, command.data(), command.size());
  out[size - 1] = 0;
  return size;
}

}  // namespace isograsp
