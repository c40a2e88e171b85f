// SPDX-License-Identifier: GPL-3.0-or-later
#include "exports/hdf5_file.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>

#include <hdf5.h>

#include "exports/hdf5_handle.hpp"

namespace isograsp::exports {

namespace {

static_assert(std::is_same_v<hid_t, std::int64_t>);

constexpr unsigned kDeflate = 4;  // a higher level takes twice as long and saves a percent

/// The two values as readers of HDF5 expect a truth value.
Owned bool_type() {
  Owned type(H5Tenum_create(H5T_NATIVE_INT8), H5Tclose);
  for (const std::int8_t value : {std::int8_t{0}, std::int8_t{1}})
    checked(H5Tenum_insert(type, value == 0 ? "FALSE" : "TRUE", &value), "a truth value");
  return type;
}

void write_dataset(hid_t owner, const std::string& name, hid_t type, hid_t space,
                   const void* values) {
  const Owned properties = timeless();
  const Owned data(
      H5Dcreate2(owner, name.c_str(), type, space, H5P_DEFAULT, properties, H5P_DEFAULT), H5Dclose);
  checked(H5Dwrite(data, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values), name.c_str());
}

/// A field of a row of a table.
struct Field {
  const char* name;
  std::size_t offset;
  hid_t type;
};

template <class Row>
void write_rows(hid_t owner, const std::string& name, const std::vector<Row>& rows,
                std::initializer_list<Field> fields) {
  const Owned type(H5Tcreate(H5T_COMPOUND, sizeof(Row)), H5Tclose);
  for (const auto& field : fields)
    checked(H5Tinsert(type, field.name, field.offset, field.type), name.c_str());
  write_dataset(owner, name, type, space_of(rows.size()), rows.data());
}

}  // namespace

Hdf5Node::Hdf5Node(Hdf5Node&& other) noexcept
    : id_(std::exchange(other.id_, -1)), kind_(std::exchange(other.kind_, Kind::none)) {}

Hdf5Node& Hdf5Node::operator=(Hdf5Node&& other) noexcept {
  std::swap(id_, other.id_);
  std::swap(kind_, other.kind_);
  return *this;
}

Hdf5Node::~Hdf5Node() {
  switch (kind_) {
    case Kind::none: break;
    case Kind::file: H5Fclose(id_); break;
    case Kind::group: H5Gclose(id_); break;
    case Kind::dataset: H5Dclose(id_); break;
  }
}

Hdf5Node Hdf5Node::create_file(const std::string& path) {
  tell_errors_by_exceptions();
  return {checked(H5Fcreate(path.c_str(), H5F_ACC_EXCL, H5P_DEFAULT, H5P_DEFAULT), path.c_str()),
          Kind::file};
}

void Hdf5Node::close_file() {
  checked(H5Fflush(id_, H5F_SCOPE_GLOBAL), "the end of the file");
  kind_ = Kind::none;
  checked(H5Fclose(id_), "the end of the file");
}

Hdf5Node Hdf5Node::make_group(const std::string& name) {
  return {
      checked(H5Gcreate2(id_, name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), name.c_str()),
      Kind::group};
}

void Hdf5Node::write_text(const std::string& name, const std::string& text) {
  const char* characters = text.c_str();
  write_dataset(id_, name, text_type(), scalar(), &characters);
}

Hdf5Node Hdf5Node::write_columns(const std::string& name,
                                 std::span<const std::span<const double>> columns) {
  const hsize_t rows = columns.empty() ? 0 : columns.front().size();
  const hsize_t size[2] = {rows, columns.size()};
  const Owned space(H5Screate_simple(2, size, nullptr), H5Sclose);
  const Owned properties = timeless();
  if (rows > 0) {
    const hsize_t chunk[2] = {std::min(rows, kChunkRows), 1};
    checked(H5Pset_chunk(properties, 2, chunk), name.c_str());
    checked(H5Pset_shuffle(properties), name.c_str());
    checked(H5Pset_deflate(properties, kDeflate), name.c_str());
    checked(H5Pset_fletcher32(properties), name.c_str());
  }
  Hdf5Node data(checked(H5Dcreate2(id_, name.c_str(), H5T_IEEE_F64LE, space, H5P_DEFAULT,
                                   properties, H5P_DEFAULT),
                        name.c_str()),
                Kind::dataset);
  const Owned memory = space_of(rows);
  for (hsize_t c = 0; c < size[1] && rows > 0; ++c) {
    const hsize_t start[2] = {0, c};
    const hsize_t count[2] = {rows, 1};
    checked(H5Sselect_hyperslab(space, H5S_SELECT_SET, start, nullptr, count, nullptr),
            name.c_str());
    checked(H5Dwrite(data.id_, H5T_NATIVE_DOUBLE, memory, space, H5P_DEFAULT, columns[c].data()),
            name.c_str());
  }
  return data;
}

void Hdf5Node::write_measures(const std::string& name, std::span<const Measure> measures) {
  struct Row {
    const char* name;
    const char* channel;
    double value;
    const char* unit;
    std::int32_t version;
    std::int64_t samples;
    std::int64_t excluded;
    const char* reason;
  };
  std::vector<Row> rows;
  for (const auto& one : measures)
    rows.push_back({one.name.c_str(), one.channel.c_str(),
                    one.value.value_or(std::numeric_limits<double>::quiet_NaN()), one.unit.c_str(),
                    one.version, one.samples, one.excluded, one.reason.c_str()});
  const Owned text = text_type();
  write_rows(id_, name, rows,
             {{"name", offsetof(Row, name), text},
              {"channel", offsetof(Row, channel), text},
              {"value", offsetof(Row, value), H5T_NATIVE_DOUBLE},
              {"unit", offsetof(Row, unit), text},
              {"version", offsetof(Row, version), H5T_NATIVE_INT32},
              {"samples", offsetof(Row, samples), H5T_NATIVE_INT64},
              {"excluded", offsetof(Row, excluded), H5T_NATIVE_INT64},
              {"reason", offsetof(Row, reason), text}});
}

void Hdf5Node::write_events(const std::string& name, std::span<const storage::EventRecord> events) {
  struct Row {
    double session_time_s;
    const char* kind;
    const char* text;
  };
  std::vector<Row> rows;
  for (const auto& event : events)
    rows.push_back({event.session_time_s, event.kind.c_str(), event.text.c_str()});
  const Owned text = text_type();
  write_rows(id_, name, rows,
             {{"session_time_s", offsetof(Row, session_time_s), H5T_NATIVE_DOUBLE},
              {"kind", offsetof(Row, kind), text},
              {"text", offsetof(Row, text), text}});
}

void Hdf5Node::set(const std::string& attribute, const ExportValue& value) {
  const Owned space = scalar();
  if (const auto* yes = std::get_if<bool>(&value)) {
    const std::int8_t number = *yes ? 1 : 0;
    write_attribute(id_, attribute, bool_type(), space, &number);
  } else if (const auto* whole = std::get_if<std::int64_t>(&value)) {
    write_attribute(id_, attribute, H5T_NATIVE_INT64, space, whole);
  } else if (const auto* seed = std::get_if<std::uint64_t>(&value)) {
    write_attribute(id_, attribute, H5T_NATIVE_UINT64, space, seed);
  } else if (const auto* number = std::get_if<double>(&value)) {
    write_attribute(id_, attribute, H5T_NATIVE_DOUBLE, space, number);
  } else if (const auto* text = std::get_if<std::string>(&value)) {
    const char* characters = text->c_str();
    write_attribute(id_, attribute, text_type(), space, &characters);
  }
}

void Hdf5Node::set(const std::string& attribute, const std::vector<std::string>& texts) {
  write_texts(id_, attribute, texts);
}

void Hdf5Node::set(std::span<const ExportFact> facts) {
  for (const auto& [name, value] : facts) set(name, value);
}

}  // namespace isograsp::exports
