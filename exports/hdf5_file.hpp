// SPDX-License-Identifier: GPL-3.0-or-later
// The few things of HDF5 that an export needs, without its header: groups, attributes, texts,
// tables and columns of numbers. Same content, same bytes: no times are written. Throws Hdf5Error;
// not for two threads at once, as the library itself.
#pragma once

#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/measure.hpp"
#include "exports/export_trial.hpp"

namespace isograsp::exports {

struct Hdf5Error : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// An open file, group or dataset; closed with the object.
class Hdf5Node {
 public:
  enum class Kind : std::uint8_t { none, file, group, dataset };
  Hdf5Node() = default;
  Hdf5Node(std::int64_t id, Kind kind) : id_(id), kind_(kind) {}
  Hdf5Node(Hdf5Node&& other) noexcept;
  Hdf5Node& operator=(Hdf5Node&& other) noexcept;
  ~Hdf5Node();

  [[nodiscard]] static Hdf5Node create_file(const std::string& path);
  /// Closes a file, with an error if it cannot be written to its end.
  void close_file();
  [[nodiscard]] bool open() const noexcept { return kind_ != Kind::none; }

  // Of a file or group.
  [[nodiscard]] Hdf5Node make_group(const std::string& name);
  /// A text of any length.
  void write_text(const std::string& name, const std::string& text);
  /// Rows × columns of float64, each column in chunks of its own: byte shuffle, deflate,
  /// checksum. `columns[c]` all have the same length.
  [[nodiscard]] Hdf5Node write_columns(const std::string& name,
                                       std::span<const std::span<const double>> columns);
  /// name, channel, value (NaN: see reason), unit, version, samples, excluded, reason.
  void write_measures(const std::string& name, std::span<const Measure> measures);
  /// time_s, kind, text.
  void write_events(const std::string& name, std::span<const storage::EventRecord> events);

  // Of anything.
  void set(const std::string& attribute, const ExportValue& value);  ///< not known: no attribute
  void set(const std::string& attribute, const std::vector<std::string>& texts);
  void set(std::span<const ExportFact> facts);

 private:
  std::int64_t id_ = -1;
  Kind kind_ = Kind::none;
};

}  // namespace isograsp::exports
