// SPDX-License-Identifier: GPL-3.0-or-later
// Packet: int32 size of all of it, int32 type (0 error, 1 command, 2 XML, 3 data, …). Data: int64
// time [us], uint32 frame, uint32 components; component: uint32 size of all of it, uint32 type (1
// 3D, 9 3D with residual, …). 3D: uint32 markers, int16 drop rate, int16 out of sync, then x, y, z
// [mm] (and the residual) as float32; NaN: not seen.
#include "device/markers/qtm_rt_codec.hpp"

#include <cmath>
#include <limits>
#include <sstream>

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>

#include "device/markers/little_endian.hpp"
#include "device/markers/marker_reader.hpp"

namespace isograsp {

namespace {

constexpr std::size_t kPacketHead = 8;
constexpr std::uint32_t kXml = 2;
constexpr std::uint32_t kData = 3;
constexpr std::size_t kDataHead = 16;
constexpr std::size_t kComponentHead = 8;
constexpr std::uint32_t k3d = 1;
constexpr std::uint32_t k3dWithResidual = 9;

}  // namespace

Result<void> QtmRtStream::take(std::span<const std::uint8_t> bytes,
                               const std::function<void(const Row&)>& row) {
  waiting_.insert(waiting_.end(), bytes.begin(), bytes.end());
  std::size_t at = 0;
  while (waiting_.size() - at >= kPacketHead) {
    const std::size_t size = little_endian<std::uint32_t>(waiting_, at);
    if (size < kPacketHead || size > kLargestPacket)
      return refused("no packet begins where one should (%1 bytes)"_text(size),
                     "check that it is a stream of QTM, little endian"_text);
    if (waiting_.size() - at < size) break;
    if (auto done = packet(std::span(waiting_).subspan(at, size), row); !done) return done;
    at += size;
  }
  waiting_.erase(waiting_.begin(), waiting_.begin() + static_cast<std::ptrdiff_t>(at));
  return {};
}

Result<void> QtmRtStream::packet(std::span<const std::uint8_t> bytes,
                                 const std::function<void(const Row&)>& row) {
  ++counts_.packets;
  switch (little_endian<std::uint32_t>(bytes, 4)) {
    case kXml: return parameters(bytes.subspan(kPacketHead));
    case kData: data(bytes.subspan(kPacketHead), row); return {};
    default: ++counts_.passed_over; return {};
  }
}

Result<void> QtmRtStream::parameters(std::span<const std::uint8_t> xml) {
  std::string text(xml.begin(), xml.end());
  text.resize(std::min(text.size(), text.find('\0')));
  boost::property_tree::ptree tree;
  try {
    std::istringstream in(text);
    boost::property_tree::read_xml(in, tree);
  } catch (const boost::property_tree::xml_parser_error& problem) {
    return refused("the parameters of QTM are broken: %1"_text(Known{problem.message()}),
                   "record the stream again"_text);
  }
  std::vector<std::string> labels;
  for (const auto& [root, content] : tree) {
    const auto points = content.get_child_optional("The_3D");
    if (!points) continue;
    for (const auto& [key, label] : *points)
      if (key == "Label") labels.emplace_back(without_subject(label.get<std::string>("Name", "")));
  }
  if (labels.empty()) return {};
  if (!labels_.empty() && labels != labels_)
    return refused("the labels change within the stream"_text,
                   "record each set of markers by itself"_text);
  labels_ = std::move(labels);
  p_W_.resize(labels_.size());
  return {};
}

bool QtmRtStream::markers(std::span<const std::uint8_t> component, std::size_t floats) {
  constexpr std::size_t kMarkersHead = 8;
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

void QtmRtStream::data(std::span<const std::uint8_t> bytes,
                       const std::function<void(const Row&)>& row) {
  if (bytes.size() < kDataHead) {
    ++counts_.passed_over;
    return;
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
    if (labels_.empty() || !markers(component, type == k3d ? 3 : 4)) {
      ++counts_.unlabelled;
      return;
    }
    if (last_frame_ && frame <= *last_frame_) {
      ++counts_.repeated;
      return;
    }
    last_frame_ = frame;
    ++counts_.frames;
    row({stamp_us, frame, p_W_});
    return;
  }
}

}  // namespace isograsp
