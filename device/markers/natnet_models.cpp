// SPDX-License-Identifier: GPL-3.0-or-later
// Body: int32 descriptions; each: int32 kind, from 4.1 on int32 bytes, then by kind
//   0 set of markers  name, int32 n, n names
//   1 body            name, int32 id, int32 parent, 3 float; from 3.0 on int32 n, n x 3 float,
//                     n int32; from 4.0 on n names
//   2 skeleton        name, int32 id, int32 n, n bodies
//   3 force plate     int32 id, text, 2 + 3 + 144 + 12 float, 2 int32, int32 n, n texts
//   4 device          int32 id, 2 texts, 2 int32, int32 n, n texts
//   5 camera          text, 3 + 4 float
//   6 asset (4.1)     name, int32 kind, int32 id, int32 n, n bodies, int32 n, n x (name, int32 id,
//                     3 float, float, int16)
#include "device/markers/natnet_models.hpp"

#include <algorithm>
#include <map>

#include "device/markers/byte_cursor.hpp"
#include "device/markers/marker_reader.hpp"

namespace isograsp {

namespace {

constexpr std::string_view kAllMarkers = "all";
constexpr std::size_t kMostModels = 1024;

/// A model as it is described; markers without names: as many empty ones.
struct Described {
  std::string name;
  std::optional<std::uint32_t> id;
  std::vector<std::string> markers;
};

class DescriptionReader {
 public:
  DescriptionReader(std::span<const std::uint8_t> body, NatNetVersion version) noexcept
      : all_(body), layout_(version) {}

  bool read() {
    const std::size_t count = all_.count(sizeof(std::uint32_t));
    if (count > kMostModels) return false;
    for (std::size_t k = 0; k < count && all_.good(); ++k) {
      const auto kind = all_.number<std::uint32_t>();
      if (layout_.byte_counts) {
        ByteCursor part = all_.part(all_.number<std::uint32_t>());
        description(kind, part);  // what is unknown in it is passed over
      } else if (!description(kind, all_)) {
        return false;
      }
    }
    return all_.good() && markers_ <= MarkerReader::kMostMarkers;
  }

  std::vector<Described> sets;
  std::vector<Described> models;

 private:
  bool description(std::uint32_t kind, ByteCursor& in) {
    switch (kind) {
      case 0: sets.push_back(marker_set(in)); break;
      case 1: models.push_back(body(in)); break;
      case 2: models.push_back(skeleton(in)); break;
      case 3:
        in.skip(4);
        in.text();
        in.skip((2 + 3 + 144 + 12) * 4);
        channels(in);
        break;
      case 4:
        in.skip(4);
        in.text();
        in.text();
        channels(in);
        break;
      case 5:
        in.text();
        in.skip(7 * 4);
        break;
      case 6:
        if (!layout_.assets) return false;
        models.push_back(asset(in));
        break;
      default: return false;
    }
    return in.good();
  }

  void count_marker() noexcept { ++markers_; }

  Described marker_set(ByteCursor& in) {
    Described set;
    set.name = in.text();
    const std::size_t count = in.count(1);
    for (std::size_t k = 0; k < count && in.good() && markers_ <= MarkerReader::kMostMarkers; ++k) {
      set.markers.emplace_back(without_subject(in.text()));
      count_marker();
    }
    return set;
  }
  Described body(ByteCursor& in) {
    constexpr std::size_t kMarker = 16;  // position and number
    Described model;
    model.name = in.text();
    model.id = in.number<std::uint32_t>();
    in.skip(4 + 12);
    if (layout_.markers_in_bodies) return model;
    const std::size_t count = in.count(kMarker);
    in.skip(count * kMarker);
    for (std::size_t k = 0; k < count && in.good() && markers_ <= MarkerReader::kMostMarkers; ++k) {
      model.markers.emplace_back(layout_.marker_names ? without_subject(in.text()) : "");
      count_marker();
    }
    return model;
  }
  /// The markers of a skeleton stand in the set of its name.
  Described skeleton(ByteCursor& in) {
    Described model;
    model.name = in.text();
    model.id = in.number<std::uint32_t>();
    bodies(in);
    return model;
  }
  void bodies(ByteCursor& in) {
    const std::size_t count = in.count(4);
    for (std::size_t k = 0; k < count && in.good(); ++k) {
      const std::size_t before = markers_;
      body(in);
      markers_ = before;
    }
  }
  Described asset(ByteCursor& in) {
    Described model;
    model.name = in.text();
    in.skip(4);
    model.id = in.number<std::uint32_t>();
    bodies(in);
    const std::size_t count = in.count(4);
    for (std::size_t k = 0; k < count && in.good() && markers_ <= MarkerReader::kMostMarkers; ++k) {
      model.markers.emplace_back(without_subject(in.text()));
      in.skip(4 + 12 + 4 + 2);
      count_marker();
    }
    return model;
  }
  static void channels(ByteCursor& in) {
    in.skip(2 * 4);
    const std::size_t count = in.count(1);
    for (std::size_t k = 0; k < count && in.good(); ++k) in.text();
  }

  ByteCursor all_;
  NatNetLayout layout_;
  std::size_t markers_ = 0;
};

const Described* named(const std::vector<Described>& all, std::string_view name) {
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Described& one) { return one.name == name; });
  return found == all.end() ? nullptr : &*found;
}

}  // namespace

std::optional<NatNetModels> parse_natnet_models(std::span<const std::uint8_t> body,
                                                NatNetVersion version) {
  DescriptionReader reader(body, version);
  if (!reader.read()) return std::nullopt;
  std::vector<Described> all;
  for (Described& set : reader.sets) {
    if (set.name == kAllMarkers || set.markers.empty()) continue;
    if (const Described* model = named(reader.models, set.name)) set.id = model->id;
    all.push_back(std::move(set));
  }
  for (Described& model : reader.models)
    if (!model.markers.empty() && named(all, model.name) == nullptr)
      all.push_back(std::move(model));
  if (all.empty())
    if (const Described* set = named(reader.sets, kAllMarkers)) all.push_back(*set);

  std::map<std::string, int> uses;
  for (const Described& one : all)
    for (const std::string& marker : one.markers) ++uses[marker];
  NatNetModels models;
  for (const Described& one : all) {
    models.sets.push_back({one.name, models.labels.size(), one.markers.size(), one.id});
    for (std::size_t k = 0; k < one.markers.size(); ++k) {
      const std::string& marker = one.markers[k];
      if (marker.empty())
        models.labels.push_back(one.name + "_" + std::to_string(k + 1));
      else
        models.labels.push_back(uses[marker] > 1 ? one.name + "_" + marker : marker);
    }
  }
  if (models.labels.size() > MarkerReader::kMostMarkers) return std::nullopt;
  return models;
}

}  // namespace isograsp
