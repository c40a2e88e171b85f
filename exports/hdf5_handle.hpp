// SPDX-License-Identifier: GPL-3.0-or-later
// What the HDF5 library gives and wants back. Inside exports/ only.
#pragma once

#include <span>
#include <string>
#include <utility>
#include <vector>

#include <hdf5.h>

#include "exports/hdf5_file.hpp"

namespace isograsp::exports {

/// Of a column: 32 KiB, of the size that the chunk cache is made for.
inline constexpr hsize_t kChunkRows = 4096;

/// Ids and codes that the library gives are negative if it failed.
template <class Id>
Id checked(Id id, const char* what) {
  if (id < 0) throw Hdf5Error(std::string(what) + " cannot be read or written");
  return id;
}

/// Anything of the library that has to be given back.
class Owned {
 public:
  Owned(hid_t id, herr_t (*close)(hid_t)) : id_(checked(id, "a part of the file")), close_(close) {}
  Owned(Owned&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
  Owned& operator=(Owned&& other) noexcept {
    std::swap(id_, other.id_);
    std::swap(close_, other.close_);
    return *this;
  }
  ~Owned() {
    if (id_ >= 0) close_(id_);
  }
  operator hid_t() const noexcept { return id_; }
  [[nodiscard]] hid_t release() noexcept { return std::exchange(id_, -1); }

 private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

/// The library prints nothing.
inline void tell_errors_by_exceptions() {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

inline Owned text_type() {
  Owned type(H5Tcopy(H5T_C_S1), H5Tclose);
  checked(H5Tset_size(type, H5T_VARIABLE), "a text");
  checked(H5Tset_cset(type, H5T_CSET_UTF8), "a text");
  return type;
}

inline Owned space_of(std::size_t count) {
  const hsize_t size = count;
  return {H5Screate_simple(1, &size, nullptr), H5Sclose};
}

inline Owned scalar() {
  return {H5Screate(H5S_SCALAR), H5Sclose};
}

/// Dataset properties without time stamps.
inline Owned timeless() {
  Owned properties(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  checked(H5Pset_obj_track_times(properties, false), "a dataset");
  return properties;
}

inline void write_attribute(hid_t owner, const std::string& name, hid_t type, hid_t space,
                            const void* value) {
  const Owned attribute(H5Acreate2(owner, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT),
                        H5Aclose);
  checked(H5Awrite(attribute, type, value), name.c_str());
}

inline void write_texts(hid_t owner, const std::string& attribute,
                        std::span<const std::string> texts) {
  std::vector<const char*> characters;
  for (const auto& text : texts) characters.push_back(text.c_str());
  write_attribute(owner, attribute, text_type(), space_of(texts.size()), characters.data());
}

}  // namespace isograsp::exports
