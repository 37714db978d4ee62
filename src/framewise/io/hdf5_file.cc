// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/io/hdf5_file.h"

#include <algorithm>
#include <utility>

namespace framewise::hdf5 {
namespace {

// Some ten pairs of frames: what is kept in memory of a table while it is written or read.
constexpr hsize_t kChunkRows = 8192;
constexpr unsigned kCompressionLevel = 1;

// All that is opened here is closed here, so there is nothing to tidy up when the program ends; after a write
// that failed, the library's tidying up would crash (1.10).
std::mutex& library_mutex() {
  static std::mutex mutex;
  static const herr_t without_tidying_up = H5dont_atexit();
  static_cast<void>(without_tidying_up);
  return mutex;
}

void check(herr_t status, const std::string& what) {
  if (status < 0) throw Failure(what);
}

Handle property_list(hid_t kind) { return {H5Pcreate(kind), H5Pclose, "property list"}; }

// Objects would otherwise carry the time they were made at.
Handle property_list_without_times(hid_t kind) {
  Handle properties = property_list(kind);
  check(H5Pset_obj_track_times(properties.get(), false), "property list");
  return properties;
}

// Headers of this version carry checksums.
Handle file_access() {
  Handle access = property_list(H5P_FILE_ACCESS);
  check(H5Pset_libver_bounds(access.get(), H5F_LIBVER_V110, H5F_LIBVER_V110), "property list");
  return access;
}

hid_t in_memory(Number number) {
  switch (number) {
    case Number::kDouble:
      return H5T_NATIVE_DOUBLE;
    case Number::kFloat:
      return H5T_NATIVE_FLOAT;
    case Number::kUnsigned64:
      return H5T_NATIVE_UINT64;
    case Number::kUnsigned8:
      return H5T_NATIVE_UINT8;
  }
  return H5I_INVALID_HID;
}

hid_t in_file(Number number) {
  switch (number) {
    case Number::kDouble:
      return H5T_IEEE_F64LE;
    case Number::kFloat:
      return H5T_IEEE_F32LE;
    case Number::kUnsigned64:
      return H5T_STD_U64LE;
    case Number::kUnsigned8:
      return H5T_STD_U8LE;
  }
  return H5I_INVALID_HID;
}

Handle text_type(std::size_t size) {
  Handle type(H5Tcopy(H5T_C_S1), H5Tclose, "text type");
  check(H5Tset_size(type.get(), std::max<std::size_t>(size, 1)), "text type");
  check(H5Tset_strpad(type.get(), H5T_STR_NULLPAD), "text type");
  check(H5Tset_cset(type.get(), H5T_CSET_UTF8), "text type");
  return type;
}

Handle open_attribute(const Handle& object, const std::string& name) {
  return {H5Aopen(object.get(), name.c_str(), H5P_DEFAULT), H5Aclose, name};
}

Handle create_attribute(const Handle& object, const std::string& name, hid_t type, const Handle& space) {
  return {H5Acreate2(object.get(), name.c_str(), type, space.get(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose,
          name};
}

}  // namespace

Session::Session() : lock_(library_mutex()) {
  H5Eget_auto2(H5E_DEFAULT, &print_, &print_data_);
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

Session::~Session() { H5Eset_auto2(H5E_DEFAULT, print_, print_data_); }

Handle::Handle(hid_t id, herr_t (*close)(hid_t), const std::string& what) : id_(id), close_(close) {
  if (id < 0) throw Failure(what);
}

Handle::Handle(Handle&& other) noexcept
    : id_(std::exchange(other.id_, H5I_INVALID_HID)), close_(other.close_) {}

Handle& Handle::operator=(Handle&& other) noexcept {
  std::swap(id_, other.id_);
  std::swap(close_, other.close_);
  return *this;
}

Handle::~Handle() {
  if (id_ >= 0) close_(id_);
}

void Handle::close(const std::string& what) {
  if (id_ >= 0) check(close_(std::exchange(id_, H5I_INVALID_HID)), what);
}

Handle create_file(const std::filesystem::path& path) {
  const Handle creation = property_list_without_times(H5P_FILE_CREATE), access = file_access();
  return {H5Fcreate(path.c_str(), H5F_ACC_TRUNC, creation.get(), access.get()), H5Fclose, "file"};
}

Handle open_file(const std::filesystem::path& path) {
  return {H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose, "file"};
}

void flush(const Handle& file) { check(H5Fflush(file.get(), H5F_SCOPE_LOCAL), "file"); }

Handle create_group(const Handle& parent, const char* name) {
  const Handle creation = property_list_without_times(H5P_GROUP_CREATE);
  return {H5Gcreate2(parent.get(), name, H5P_DEFAULT, creation.get(), H5P_DEFAULT), H5Gclose, name};
}

Handle open_group(const Handle& parent, const char* name) {
  return {H5Gopen2(parent.get(), name, H5P_DEFAULT), H5Gclose, name};
}

void write_text(const Handle& object, const std::string& name, const std::string& text) {
  const Handle type = text_type(text.size()), space(H5Screate(H5S_SCALAR), H5Sclose, name);
  const Handle attribute = create_attribute(object, name, type.get(), space);
  check(H5Awrite(attribute.get(), type.get(), text.c_str()), name);
}

std::string read_text(const Handle& object, const std::string& name) {
  const Handle attribute = open_attribute(object, name);
  const Handle type(H5Aget_type(attribute.get()), H5Tclose, name);
  const Handle space(H5Aget_space(attribute.get()), H5Sclose, name);
  if (H5Tget_class(type.get()) != H5T_STRING || H5Tis_variable_str(type.get()) != 0 ||
      H5Sget_simple_extent_npoints(space.get()) != 1)
    throw Failure(name);
  std::string text(H5Tget_size(type.get()), '\0');
  check(H5Aread(attribute.get(), text_type(text.size()).get(), text.data()), name);
  text.resize(std::min(text.find('\0'), text.size()));
  return text;
}

std::vector<std::string> attribute_names(const Handle& object) {
  std::vector<std::string> names;
  const auto take = [](hid_t, const char* name, const H5A_info_t*, void* into) -> herr_t {
    static_cast<std::vector<std::string>*>(into)->emplace_back(name);
    return 0;
  };
  check(H5Aiterate2(object.get(), H5_INDEX_NAME, H5_ITER_INC, nullptr, take, &names), "attributes");
  return names;
}

void write_numbers(const Handle& object, const char* name, std::span<const double> numbers) {
  const hsize_t size = numbers.size();
  const Handle space(H5Screate_simple(1, &size, nullptr), H5Sclose, name);
  const Handle attribute = create_attribute(object, name, H5T_IEEE_F64LE, space);
  check(H5Awrite(attribute.get(), H5T_NATIVE_DOUBLE, numbers.data()), name);
}

std::vector<double> read_numbers(const Handle& object, const char* name, std::size_t expected) {
  const Handle attribute = open_attribute(object, name);
  const Handle space(H5Aget_space(attribute.get()), H5Sclose, name);
  if (H5Sget_simple_extent_npoints(space.get()) != static_cast<hssize_t>(expected)) throw Failure(name);
  std::vector<double> numbers(expected);
  check(H5Aread(attribute.get(), H5T_NATIVE_DOUBLE, numbers.data()), name);
  return numbers;
}

Table Table::create(const Handle& group, const char* name, Number number, std::size_t width) {
  const hsize_t none[2] = {0, width}, most[2] = {H5S_UNLIMITED, width}, chunk[2] = {kChunkRows, width};
  const Handle space(H5Screate_simple(2, none, most), H5Sclose, name);
  const Handle creation = property_list_without_times(H5P_DATASET_CREATE);
  check(H5Pset_chunk(creation.get(), 2, chunk), name);
  check(H5Pset_shuffle(creation.get()), name);
  check(H5Pset_deflate(creation.get(), kCompressionLevel), name);
  Table table;
  table.name_ = name;
  table.number_ = number;
  table.width_ = width;
  table.data_ = Handle(
      H5Dcreate2(group.get(), name, in_file(number), space.get(), H5P_DEFAULT, creation.get(), H5P_DEFAULT),
      H5Dclose, name);
  return table;
}

Table Table::open(const Handle& group, const char* name, Number number, std::size_t width) {
  Table table;
  table.name_ = name;
  table.number_ = number;
  table.width_ = width;
  table.data_ = Handle(H5Dopen2(group.get(), name, H5P_DEFAULT), H5Dclose, name);
  const Handle type(H5Dget_type(table.data_.get()), H5Tclose, name);
  const Handle space(H5Dget_space(table.data_.get()), H5Sclose, name);
  hsize_t size[2] = {0, 0};
  if (H5Tequal(type.get(), in_file(number)) <= 0 || H5Sget_simple_extent_ndims(space.get()) != 2 ||
      H5Sget_simple_extent_dims(space.get(), size, nullptr) != 2 || size[1] != width)
    throw Failure(name);
  table.rows_ = size[0];
  return table;
}

Handle Table::rows_of_file(std::size_t first, std::size_t count) const {
  Handle space(H5Dget_space(data_.get()), H5Sclose, name_);
  const hsize_t start[2] = {first, 0}, size[2] = {count, width_};
  check(H5Sselect_hyperslab(space.get(), H5S_SELECT_SET, start, nullptr, size, nullptr), name_);
  return space;
}

void Table::append(const void* rows, std::size_t count) {
  if (count == 0) return;
  const hsize_t size[2] = {rows_ + count, width_}, added[2] = {count, width_};
  check(H5Dset_extent(data_.get(), size), name_);
  const Handle memory(H5Screate_simple(2, added, nullptr), H5Sclose, name_);
  const Handle file = rows_of_file(rows_, count);
  check(H5Dwrite(data_.get(), in_memory(number_), memory.get(), file.get(), H5P_DEFAULT, rows), name_);
  rows_ += count;
}

void Table::read(std::size_t first, std::size_t count, void* rows) const {
  if (count == 0) return;
  const hsize_t size[2] = {count, width_};
  const Handle memory(H5Screate_simple(2, size, nullptr), H5Sclose, name_);
  const Handle file = rows_of_file(first, count);
  check(H5Dread(data_.get(), in_memory(number_), memory.get(), file.get(), H5P_DEFAULT, rows), name_);
}

}  // namespace framewise::hdf5
