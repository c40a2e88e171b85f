// SPDX-License-Identifier: GPL-3.0-or-later
// Message: uint16 kind, uint16 bytes, body. A list: int32 count, from 4.1 on int32 bytes, items.
// Frame (7): int32 number; sets of markers (name, int32 n, n x 3 float); other markers (3 float);
// bodies (int32 id, 7 float; below 3.0 int32 n, n x (3 float, int32, float); float; from 2.6 on
// int16); skeletons (int32 id, bodies); from 4.1 on assets; labelled markers (int32 id, 3 float,
// float; from 2.6 on int16 flags, bit 0: not seen; from 3.0 on float); from 2.9 on force plates and
// from 2.11 on devices (int32 id, int32 channels, each int32 n, n float); int32 timecode, int32
// part; time [s] double, below 2.7 float; from 3.0 on 3 uint64; from 4.1 on 2 uint32; int16 flags,
// bit 1: models have changed.
#include "device/markers/natnet_codec.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "device/markers/byte_cursor.hpp"
#include "device/markers/marker_reader.hpp"

namespace isograsp {

namespace {

constexpr std::size_t kMessageHead = 4;
constexpr std::size_t kVec3 = 12;
constexpr std::uint16_t kOccluded = 1;
constexpr std::uint16_t kModelsChanged = 2;

}  // namespace

/// One frame into one row; what is missing in it stays NaN.
struct NatNetStream::FrameReader {
  const NatNetModels& models;
  NatNetLayout layout;
  std::span<Vec3> p_W;
  bool of_these_markers = true;  ///< sets are as large as their descriptions say

  /// Reads a list: as far as its bytes reach, where they are told, whatever its count says.
  template <class Read>
  void list(ByteCursor& in, std::size_t least, Read&& read) noexcept {
    const std::size_t count = in.number<std::uint32_t>();
    if (!layout.byte_counts) {
      if (count > in.left() / least) return fail(in);
      for (std::size_t k = 0; k < count && in.good(); ++k) read(in);
      return;
    }
    ByteCursor part = in.part(in.number<std::uint32_t>());
    const bool believable = count <= part.left() / least;
    for (std::size_t k = 0; part.left() >= least && !(believable && k == count); ++k) read(part);
    if (!part.good()) fail(in);
  }
  /// A list that holds nothing of interest.
  template <class Read>
  void pass_over(ByteCursor& in, std::size_t least, Read&& read) noexcept {
    if (!layout.byte_counts) return list(in, least, read);
    in.skip(4);
    in.skip(in.number<std::uint32_t>());
  }
  static void fail(ByteCursor& in) noexcept { in.skip(in.left() + 1); }

  void marker_set(ByteCursor& in) noexcept {
    const std::string_view name = in.text();
    const std::size_t count = in.count(kVec3);
    const auto set = std::find_if(models.sets.begin(), models.sets.end(),
                                  [&](const NatNetSet& one) { return one.name == name; });
    if (set == models.sets.end()) return in.skip(count * kVec3);
    of_these_markers = of_these_markers && set->count == count;
    for (std::size_t k = 0; k < count; ++k) {
      const Vec3 p = unseen_at_origin(in.vector());
      if (k < set->count) p_W[set->first + k] = p;
    }
  }
  void body(ByteCursor& in) const noexcept {
    constexpr std::size_t kMarker = kVec3 + 4 + 4;
    in.skip(4 + 7 * 4);
    if (layout.markers_in_bodies) in.skip(in.count(kMarker) * kMarker);
    in.skip(4);
    if (layout.flags) in.skip(2);
  }
  void skeleton(ByteCursor& in) const noexcept {
    in.skip(4);
    const std::size_t bodies = in.count(4);
    for (std::size_t k = 0; k < bodies && in.good(); ++k) body(in);
  }
  /// Tells of a marker whether it was seen: a set holds a computed position where it was not.
  void labelled(ByteCursor& in) noexcept {
    const auto id = in.number<std::uint32_t>();
    const Vec3 p = unseen_at_origin(in.vector());
    in.skip(4);
    const std::uint16_t flags = layout.flags ? in.number<std::uint16_t>() : std::uint16_t{0};
    if (layout.camera_ticks) in.skip(4);
    const std::uint32_t model = id >> 16, member = id & 0xFFFFU;
    if (!in.good() || model == 0 || member == 0) return;
    const auto set = std::find_if(models.sets.begin(), models.sets.end(),
                                  [&](const NatNetSet& one) { return one.model == model; });
    if (set == models.sets.end() || member > set->count) return;
    Vec3& place = p_W[set->first + member - 1];
    if ((flags & kOccluded) != 0)
      place = unseen_marker();
    else if (!place.allFinite())
      place = p;
  }
  static void channels(ByteCursor& in) noexcept {
    in.skip(4);
    const std::size_t count = in.count(4);
    for (std::size_t k = 0; k < count && in.good(); ++k) in.skip(in.count(4) * 4);
  }

  /// False: the frame is damaged.
  bool read(ByteCursor& in, Row& row) noexcept {
    row.frame = static_cast<std::int32_t>(in.number<std::uint32_t>());
    list(in, 5, [this](ByteCursor& part) { marker_set(part); });
    pass_over(in, kVec3, [](ByteCursor& part) { part.skip(kVec3); });
    pass_over(in, 4 + 7 * 4, [this](ByteCursor& part) { body(part); });
    pass_over(in, 8, [this](ByteCursor& part) { skeleton(part); });
    if (layout.assets) pass_over(in, 8, [](ByteCursor&) {});
    list(in, 4 + kVec3 + 4, [this](ByteCursor& part) { labelled(part); });
    if (layout.force_plates) pass_over(in, 8, channels);
    if (layout.devices) pass_over(in, 8, channels);
    in.skip(2 * 4);
    row.stamp_s = layout.double_stamps ? in.real() : in.single();
    if (layout.camera_ticks) in.skip(3 * 8);
    if (layout.precise_stamps) in.skip(2 * 4);
    row.models_changed = (in.number<std::uint16_t>() & kModelsChanged) != 0;
    return in.good() && std::isfinite(row.stamp_s);
  }
};

NatNetStream::Step NatNetStream::take(std::span<const std::uint8_t> datagram, Row& row) noexcept {
  ++counts_.datagrams;
  ByteCursor in(datagram);
  const auto kind = in.number<std::uint16_t>();
  const auto size = in.number<std::uint16_t>();
  if (!in.good() || size > in.left()) {
    ++counts_.damaged;
    return Step::nothing;
  }
  return message(kind, datagram.subspan(kMessageHead, size), row);
}

NatNetStream::Step NatNetStream::message(std::uint16_t kind, std::span<const std::uint8_t> body,
                                         Row& row) {
  switch (kind) {
    case NatNetMessage::kServer: return server(body);
    case NatNetMessage::kModels: return models(body);
    case NatNetMessage::kResponse: return response(body);
    case NatNetMessage::kFrame: return frame(body, row);
    default: ++counts_.passed_over; return Step::nothing;
  }
}

/// char[256] name, uint8[4] its version, uint8[4] that of the stream; from 3.0 on uint64 ticks a
/// second, uint16 port of frames, uint8 multicast, uint8[4] its group.
NatNetStream::Step NatNetStream::server(std::span<const std::uint8_t> body) noexcept {
  constexpr std::size_t kVersionAt = 256 + 4;
  ByteCursor in(body);
  in.skip(kVersionAt);
  NatNetVersion version;
  version.major = in.number<std::uint8_t>();
  version.minor = in.number<std::uint8_t>();
  in.skip(2);
  if (!in.good()) {
    ++counts_.damaged;
    return Step::nothing;
  }
  if (version_ && *version_ != version) told_.clear();  // the same bytes mean something else
  version_ = version;
  if (!version.known()) return Step::unknown_version;
  in.skip(8);
  const auto port = in.number<std::uint16_t>();
  const auto by_multicast = in.number<std::uint8_t>();
  std::uint32_t group = 0;
  for (int k = 0; k < 4; ++k) group = group << 8 | in.number<std::uint8_t>();
  if (in.good() && version.at_least(3, 0)) {
    if (port != 0) data_port_ = port;
    if (by_multicast != 0 && group != 0) multicast_ = group;
  }
  return Step::server;
}

NatNetStream::Step NatNetStream::models(std::span<const std::uint8_t> body) {
  if (!version_ || !version_->known()) {
    ++counts_.passed_over;
    return Step::nothing;
  }
  if (!told_.empty() && std::equal(body.begin(), body.end(), told_.begin(), told_.end())) {
    foreign_ = false;
    return Step::labels;
  }
  try {
    auto found = parse_natnet_models(body, *version_);
    if (!found) {
      ++counts_.damaged;
      return Step::nothing;
    }
    if (found->labels.empty()) return Step::nothing;
    foreign_ = !models_.labels.empty() && found->labels != models_.labels;
    if (foreign_) return Step::other_labels;
    models_ = *std::move(found);
    told_.assign(body.begin(), body.end());
    p_W_.resize(models_.labels.size());
    return Step::labels;
  } catch (const std::exception&) {  // no memory
    ++counts_.damaged;
    return Step::nothing;
  }
}

/// The only request with an answer is that for the rate: a float.
NatNetStream::Step NatNetStream::response(std::span<const std::uint8_t> body) noexcept {
  constexpr double kFastest_Hz = 10'000.0;
  ByteCursor in(body);
  const double rate_Hz = in.single();
  if (!in.good() || !(rate_Hz >= 1.0 && rate_Hz <= kFastest_Hz)) {
    ++counts_.passed_over;
    return Step::nothing;
  }
  rate_Hz_ = rate_Hz;
  return Step::rate;
}

NatNetStream::Step NatNetStream::frame(std::span<const std::uint8_t> body, Row& row) noexcept {
  if (!version_ || !version_->known() || models_.labels.empty() || foreign_) {
    ++counts_.unlabelled;
    return Step::nothing;
  }
  std::fill(p_W_.begin(), p_W_.end(), unseen_marker());
  FrameReader reader{models_, NatNetLayout(*version_), p_W_};
  ByteCursor in(body);
  if (!reader.read(in, row)) {
    ++counts_.damaged;
    return Step::nothing;
  }
  if (!reader.of_these_markers) {
    ++counts_.unlabelled;
    return Step::nothing;
  }
  row.p_W = p_W_;
  ++counts_.frames;
  return Step::row;
}

void NatNetStream::restart() noexcept {
  foreign_ = false;
}

std::size_t encode_natnet_request(std::uint16_t kind, std::string_view text,
                                  std::span<std::uint8_t> out) noexcept {
  // A greeting is as long as what a server says of itself, with the stream's version behind it (0:
  // the server's own).
  const std::size_t body =
      kind == NatNetMessage::kConnect ? kLongestNatNetRequest - kMessageHead : text.size() + 1;
  std::fill_n(out.begin(), kMessageHead + body, std::uint8_t{0});
  put_little_endian(out, 0, kind);
  put_little_endian(out, 2, static_cast<std::uint16_t>(body));
  std::memcpy(out.data() + kMessageHead, text.data(), text.size());
  return kMessageHead + body;
}

}  // namespace isograsp
