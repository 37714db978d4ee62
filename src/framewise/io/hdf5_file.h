// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hdf5.h>

#include <cstddef>
#include <filesystem>
#include <mutex>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

// What the room needs of the HDF5 C library: handles that close themselves, small attributes, growing tables.
// Files made here hold no time stamps and no native types: the same calls give the same bytes.
namespace framewise::hdf5 {

// A call of the library failed; says what was tried.
struct Failure : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// The library keeps global state and prints its errors: while a Session lives, this thread has the library to
// itself and nothing is printed. Every function below needs one.
class Session {
 public:
  Session();
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

 private:
  std::lock_guard<std::mutex> lock_;
  H5E_auto2_t print_ = nullptr;
  void* print_data_ = nullptr;
};

// An open object of the library; closed when it goes.
class Handle {
 public:
  Handle() = default;
  // Throws Failure saying `what` where the id is none.
  Handle(hid_t id, herr_t (*close)(hid_t), const std::string& what);
  Handle(Handle&& other) noexcept;
  Handle& operator=(Handle&& other) noexcept;
  ~Handle();

  hid_t get() const { return id_; }
  // Throws Failure where closing fails, as writing what was kept back may.
  void close(const std::string& what);

 private:
  hid_t id_ = H5I_INVALID_HID;
  herr_t (*close_)(hid_t) = nullptr;
};

Handle create_file(const std::filesystem::path& path);
Handle open_file(const std::filesystem::path& path);  // to read
void flush(const Handle& file);
Handle create_group(const Handle& parent, const char* name);
Handle open_group(const Handle& parent, const char* name);

void write_text(const Handle& object, const std::string& name, const std::string& text);
std::string read_text(const Handle& object, const std::string& name);
std::vector<std::string> attribute_names(const Handle& object);  // in alphabetical order
void write_numbers(const Handle& object, const char* name, std::span<const double> numbers);
std::vector<double> read_numbers(const Handle& object, const char* name, std::size_t expected);

enum class Number { kDouble, kFloat, kUnsigned64, kUnsigned8 };

// Rows of `width` numbers of one kind, rows x width; grows at its end. Compressed without loss, so that a
// changed byte is found when it is read.
class Table {
 public:
  Table() = default;
  static Table create(const Handle& group, const char* name, Number number, std::size_t width);
  static Table open(const Handle& group, const char* name, Number number, std::size_t width);

  std::size_t rows() const { return rows_; }
  void append(const void* rows, std::size_t count);
  void read(std::size_t first, std::size_t count, void* rows) const;

 private:
  Handle rows_of_file(std::size_t first, std::size_t count) const;

  std::string name_;
  Handle data_;
  Number number_ = Number::kDouble;
  std::size_t width_ = 0, rows_ = 0;
};

}  // namespace framewise::hdf5
