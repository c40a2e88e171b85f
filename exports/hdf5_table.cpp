// SPDX-License-Identifier: GPL-3.0-or-later
#include "exports/hdf5_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <unordered_set>

#include "core/csv.hpp"
#include "core/files.hpp"
#include "exports/hdf5_handle.hpp"

namespace isograsp::exports {

namespace {

constexpr hsize_t kBlockRows = kChunkRows;
constexpr const char* kColumns = "columns";

Error damaged(const std::string& path) {
  return refused("is no HDF5 file that can be read"_text, "write it again"_text).at(path);
}

herr_t refuse_link(const char*, const char*, const char*, const char*, unsigned*, hid_t, void*) {
  return -1;
}

/// A link to another file leads nowhere.
Owned own_links_only() {
  Owned properties(H5Pcreate(H5P_LINK_ACCESS), H5Pclose);
  checked(H5Pset_elink_cb(properties, refuse_link, nullptr), "a link");
  return properties;
}

/// Texts of any length, or of one length.
std::vector<std::string> texts_of(hid_t attribute) {
  const Owned type(H5Aget_type(attribute), H5Tclose);
  const Owned space(H5Aget_space(attribute), H5Sclose);
  const hssize_t count = checked(H5Sget_simple_extent_npoints(space), kColumns);
  if (H5Tget_class(type) != H5T_STRING || count > static_cast<hssize_t>(CsvReader::kMostColumns))
    return {};
  std::vector<std::string> texts;
  if (checked(H5Tis_variable_str(type), kColumns) > 0) {
    std::vector<char*> characters(static_cast<std::size_t>(count), nullptr);
    const Owned memory(H5Tcopy(type), H5Tclose);
    checked(H5Aread(attribute, memory, characters.data()), kColumns);
    for (const char* const text : characters) texts.emplace_back(text == nullptr ? "" : text);
    H5Dvlen_reclaim(memory, space, H5P_DEFAULT, characters.data());
    return texts;
  }
  const std::size_t length = H5Tget_size(type);
  std::string all(length * static_cast<std::size_t>(count), '\0');
  checked(H5Aread(attribute, type, all.data()), kColumns);
  for (std::size_t k = 0; k < static_cast<std::size_t>(count); ++k) {
    std::string text = all.substr(k * length, length);
    text.resize(std::min(text.find('\0'), text.size()));
    texts.push_back(std::move(text));
  }
  return texts;
}

/// One data set and the rows of it that are in memory.
class Block {
 public:
  Block(Owned data, std::vector<std::string> columns)
      : data_(std::move(data)), columns_(std::move(columns)) {
    const Owned space(H5Dget_space(data_), H5Sclose);
    if (H5Sget_simple_extent_ndims(space) == 2)
      checked(H5Sget_simple_extent_dims(space, size_.data(), nullptr), "a size");
    const Owned type(H5Dget_type(data_), H5Tclose);
    const H5T_class_t kind = H5Tget_class(type);
    const Owned properties(H5Dget_create_plist(data_), H5Pclose);
    is_table_ = (kind == H5T_FLOAT || kind == H5T_INTEGER) && size_[1] == columns_.size() &&
                H5Pget_external_count(properties) == 0 && H5Pget_layout(properties) != H5D_VIRTUAL;
    std::array<hsize_t, 2> chunk{};
    by_column_ = H5Pget_layout(properties) == H5D_CHUNKED &&
                 H5Pget_chunk(properties, 2, chunk.data()) == 2 && chunk[1] == 1;
  }

  [[nodiscard]] bool is_table() const noexcept { return is_table_; }
  [[nodiscard]] hsize_t rows() const noexcept { return size_[0]; }
  [[nodiscard]] std::span<const std::string> columns() const noexcept { return columns_; }

  /// Rows from `first` on.
  void read(hsize_t first) {
    values_.resize(kBlockRows * columns_.size());
    if (!by_column_) return read(first, 0, columns_.size(), values_);
    for (std::size_t c = 0; c < columns_.size(); ++c)
      read(first, c, 1, std::span(values_).subspan(c * kBlockRows));
  }
  void read_column(hsize_t first, std::size_t column, std::span<double> to) {
    read(first, column, 1, to);
  }
  [[nodiscard]] double value(std::size_t row, std::size_t column) const {
    return by_column_ ? values_[column * kBlockRows + row]
                      : values_[row * columns_.size() + column];
  }

 private:
  void read(hsize_t first, std::size_t column, std::size_t columns, std::span<double> to) {
    const hsize_t start[2] = {first, column};
    const hsize_t count[2] = {std::min(kBlockRows, rows() - first), columns};
    const Owned space(H5Dget_space(data_), H5Sclose);
    checked(H5Sselect_hyperslab(space, H5S_SELECT_SET, start, nullptr, count, nullptr), "a row");
    const Owned memory(H5Screate_simple(2, count, nullptr), H5Sclose);
    checked(H5Dread(data_, H5T_NATIVE_DOUBLE, memory, space, H5P_DEFAULT, to.data()), "a row");
  }

  Owned data_;
  std::vector<std::string> columns_;
  std::array<hsize_t, 2> size_{};
  bool is_table_ = false;
  bool by_column_ = false;  ///< how it stands in the file, and so here
  std::vector<double> values_;
};

/// Of an object that has columns.
std::optional<Block> block_of(Owned object) {
  if (H5Iget_type(object) != H5I_DATASET || H5Aexists(object, kColumns) <= 0) return std::nullopt;
  const Owned attribute(H5Aopen(object, kColumns, H5P_DEFAULT), H5Aclose);
  auto names = texts_of(attribute);
  return Block(std::move(object), std::move(names));
}

/// Names of what stands in a group itself.
std::vector<std::string> members_of(hid_t group) {
  std::vector<std::string> names;
  const auto note = [](hid_t, const char* name, const H5L_info_t* link, void* to) -> herr_t {
    if (link->type == H5L_TYPE_HARD) static_cast<std::vector<std::string>*>(to)->emplace_back(name);
    return 0;
  };
  checked(H5Literate(group, H5_INDEX_NAME, H5_ITER_INC, nullptr, note, &names), "a group");
  return names;
}

class Hdf5TableReader final : public TableReader {
 public:
  Hdf5TableReader(Owned file, std::string name) : file_(std::move(file)), name_(std::move(name)) {}

  Result<void> find_blocks(const std::string& place) {
    const Owned links = own_links_only();
    Owned object(H5Oopen(file_, place.c_str(), links), H5Oclose);
    if (H5Iget_type(object) == H5I_GROUP) {
      for (const std::string& member : members_of(object))
        if (auto block = block_of({H5Oopen(object, member.c_str(), links), H5Oclose}))
          blocks_.push_back(*std::move(block));
    } else if (auto block = block_of(std::move(object))) {
      blocks_.push_back(*std::move(block));
    }
    if (blocks_.empty())
      return refused("holds no table there: a data set with the attribute 'columns'"_text,
                     "name the place of one behind the file, as in forces.h5:/signals"_text)
          .at(name_);
    std::unordered_set<std::string> seen;
    for (const Block& block : blocks_) {
      if (!block.is_table())
        return refused(
                   "has a data set that is no table: rows × columns of numbers in this file, a "
                   "name for each column"_text,
                   "write it again"_text)
            .at(name_);
      if (block.rows() != blocks_.front().rows())
        return error_here(block.columns().empty() ? "" : block.columns().front(),
                          "has another number of rows than the columns beside it"_text,
                          "name the place of one data set"_text);
      for (const std::string& column : block.columns()) {
        if (!seen.insert(column).second)
          return error_here(column, "the column appears twice"_text, "keep one of them"_text);
        columns_.push_back(column);
      }
    }
    return {};
  }

  const std::vector<std::string>& columns() const noexcept override { return columns_; }
  const std::vector<std::string>& comments() const noexcept override { return comments_; }

  Result<bool> next(std::span<double> row) override {
    return guarded([&](hsize_t first, hsize_t in_block) -> Result<bool> {
      if (in_memory_ != first)
        for (Block& block : blocks_) block.read(first);
      in_memory_ = first;
      ++row_;
      std::size_t at = 0;
      for (const Block& block : blocks_)
        for (std::size_t c = 0; c < block.columns().size(); ++c)
          if (row[at++] = block.value(in_block, c); std::isinf(row[at - 1]))
            return infinite(at - 1);
      return true;
    });
  }

  Result<bool> next(std::size_t column, double& value) override {
    return guarded([&](hsize_t first, hsize_t in_block) -> Result<bool> {
      if (column_in_memory_ != std::pair(column, first)) read_column(first, column);
      column_in_memory_ = {column, first};
      ++row_;
      value = of_column_[in_block];
      if (std::isinf(value)) return infinite(column);
      return true;
    });
  }

  Error error_here(std::string field, Text what, Text remedy) const override {
    const auto row = row_ > 0 ? std::optional(static_cast<int>(row_)) : std::nullopt;
    return refused(std::move(what), std::move(remedy)).at(name_, row, std::move(field));
  }

 private:
  template <class Read>
  Result<bool> guarded(Read&& read) {
    if (row_ == blocks_.front().rows()) return false;
    try {
      return read(row_ - row_ % kBlockRows, row_ % kBlockRows);
    } catch (const Hdf5Error&) {
      return damaged(name_);
    }
  }

  void read_column(hsize_t first, std::size_t column) {
    of_column_.resize(kBlockRows);
    for (Block& block : blocks_) {
      if (column < block.columns().size()) return block.read_column(first, column, of_column_);
      column -= block.columns().size();
    }
  }

  [[nodiscard]] Error infinite(std::size_t column) const {
    return error_here(columns_[column], "is not finite"_text,
                      "write NaN where there is no value"_text);
  }

  Owned file_;
  std::string name_;
  std::vector<Block> blocks_;
  std::vector<std::string> columns_;
  std::vector<std::string> comments_;
  std::optional<hsize_t> in_memory_;  ///< first row of the blocks
  std::vector<double> of_column_;
  std::optional<std::pair<std::size_t, hsize_t>> column_in_memory_;
  hsize_t row_ = 0;  ///< read last, 1-based
};

}  // namespace

Result<std::unique_ptr<TableReader>> open_hdf5_table(const std::string& path,
                                                     const std::string& place) {
  if (const auto plain = InputFile::open(path); !plain) return plain.error();
  tell_errors_by_exceptions();
  H5PLset_loading_state(0);  // filters of others are programs
  try {
    Owned file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
    if (const Owned links = own_links_only(); H5Oexists_by_name(file, place.c_str(), links) <= 0)
      return refused("has nothing at the place '%1'"_text(Known{place}), "look with h5ls -r"_text)
          .at(path);
    auto reader = std::make_unique<Hdf5TableReader>(std::move(file), path);
    if (const auto found = reader->find_blocks(place); !found) return found.error();
    return std::unique_ptr<TableReader>(std::move(reader));
  } catch (const Hdf5Error&) {
    return damaged(path);
  }
}

}  // namespace isograsp::exports
