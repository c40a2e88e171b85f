// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <bit>
#include <optional>

#include "core/files.hpp"
#include "exports/hdf5_handle.hpp"
#include "exports/hdf5_table.hpp"

namespace isograsp::exports {

namespace {

static_assert(std::endian::native == std::endian::little, "chunks are written as they are");

class Hdf5TableWriter final : public TableWriter {
 public:
  Hdf5TableWriter(std::string path, FileWriter writer, std::span<const std::string> columns)
      : columns_(columns.size()), path_(std::move(path)), writer_(std::move(writer)) {
    values_.resize(columns_ * kChunkRows);
    Owned access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
    // The writer holds the lock.
    checked(H5Pset_file_locking(access, false, true), "the file");
    file_.emplace(H5Fcreate(writer_.name_for_library().c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access),
                  H5Fclose);
    const char* const format = "isograsp-table-1";
    write_attribute(*file_, "format", text_type(), scalar(), &format);
    const Owned group(H5Gcreate2(*file_, kTablesPlace, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                      H5Gclose);
    const hsize_t size[2] = {0, columns_};
    const hsize_t most[2] = {H5S_UNLIMITED, columns_};
    const hsize_t chunk[2] = {kChunkRows, 1};
    const Owned space(H5Screate_simple(2, size, most), H5Sclose);
    const Owned properties = timeless();
    checked(H5Pset_chunk(properties, 2, chunk), "a chunk");
    data_.emplace(
        H5Dcreate2(group, "table", H5T_IEEE_F64LE, space, H5P_DEFAULT, properties, H5P_DEFAULT),
        H5Dclose);
    write_texts(*data_, "columns", columns);
  }

  void add(std::span<const double> row) override {
    for (std::size_t c = 0; c < columns_; ++c) values_[c * kChunkRows + waiting_] = row[c];
    if (++waiting_ == kChunkRows) flush();
  }

  Result<void> commit() override {
    flush();
    try {
      data_.reset();
      checked(H5Fflush(*file_, H5F_SCOPE_GLOBAL), "the end of the file");
      checked(H5Fclose(file_->release()), "the end of the file");
    } catch (const Hdf5Error&) {
      good_ = false;
    }
    file_.reset();
    if (!good_)
      return failed("could not be written completely"_text,
                    "free some disk space and check the permissions of the folder"_text)
          .at(path_);
    return writer_.commit();
  }

 private:
  void flush() {
    if (waiting_ == 0 || !good_) return;
    try {
      const hsize_t size[2] = {rows_ + waiting_, columns_};
      checked(H5Dset_extent(*data_, size), "a size");
      for (std::size_t c = 0; c < columns_; ++c) {
        double* const chunk = values_.data() + c * kChunkRows;
        std::fill(chunk + waiting_, chunk + kChunkRows, 0.0);
        const hsize_t at[2] = {rows_, c};
        checked(H5Dwrite_chunk(*data_, H5P_DEFAULT, 0, at, kChunkRows * sizeof(double), chunk),
                "a chunk");
      }
    } catch (const Hdf5Error&) {
      good_ = false;
    }
    rows_ += waiting_;
    waiting_ = 0;
  }

  std::size_t columns_;
  std::string path_;
  FileWriter writer_;
  std::optional<Owned> file_;
  std::optional<Owned> data_;
  std::vector<double> values_;  ///< of a block, a column behind the other
  hsize_t rows_ = 0;            ///< in the file
  hsize_t waiting_ = 0;
  bool good_ = true;
};

}  // namespace

Result<std::unique_ptr<TableWriter>> create_hdf5_table(const std::string& path,
                                                       std::span<const std::string> columns) {
  auto writer = FileWriter::create(path);
  if (!writer) return writer.error();
  // The library (1.10) loses memory where a file cannot be written, and needs one to go back in.
  if (writer->name_for_library().empty()) return cannot_open(path, Purpose::writing);
  tell_errors_by_exceptions();
  try {
    return std::unique_ptr<TableWriter>(
        std::make_unique<Hdf5TableWriter>(path, *std::move(writer), columns));
  } catch (const Hdf5Error&) {
    return cannot_open(path, Purpose::writing);
  }
}

}  // namespace isograsp::exports
