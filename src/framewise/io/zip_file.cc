// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/io/zip_file.h"

#include <zip.h>

#include <memory>

#include "framewise/io/input_error.h"

namespace framewise {
namespace {

using Archive = std::unique_ptr<zip_t, decltype(&zip_discard)>;

[[noreturn]] void refuse(const std::filesystem::path& path, const std::string& why, const char* option) {
  throw InputError(path, 0, "", "a file that cannot be written (" + why + ")",
                   std::string("a zip file to write (") + option + ")");
}

Archive open_archive(const std::filesystem::path& path, const char* option) {
  if (std::filesystem::is_directory(path)) refuse(path, "it is a folder", option);
  int code = 0;
  zip_t* archive = zip_open(path.c_str(), ZIP_CREATE | ZIP_TRUNCATE, &code);
  if (archive == nullptr) {
    zip_error_t error;
    zip_error_init_with_code(&error, code);
    const std::string why = zip_error_strerror(&error);
    zip_error_fini(&error);
    refuse(path, why, option);
  }
  return {archive, &zip_discard};
}

bool add(zip_t* archive, const ZipEntry& entry) {
  constexpr zip_uint16_t first_day = 1 << 5 | 1;  // year 1980 + 0, month 1, day 1
  zip_source_t* source = zip_source_buffer(archive, entry.content.data(), entry.content.size(), 0);
  if (source == nullptr) return false;
  const zip_int64_t index = zip_file_add(archive, entry.name.c_str(), source, ZIP_FL_ENC_UTF_8);
  if (index < 0) {
    zip_source_free(source);
    return false;
  }
  const auto place = static_cast<zip_uint64_t>(index);
  return zip_set_file_compression(archive, place, ZIP_CM_STORE, 0) == 0 &&
         zip_file_set_dostime(archive, place, 0, first_day, 0) == 0;
}

}  // namespace

void write_zip(const std::filesystem::path& path, const std::vector<ZipEntry>& entries, const char* option) {
  Archive archive = open_archive(path, option);
  for (const ZipEntry& entry : entries)
    if (!add(archive.get(), entry)) refuse(path, zip_strerror(archive.get()), option);
  if (zip_close(archive.get()) != 0) refuse(path, zip_strerror(archive.get()), option);
  archive.release();  // closed is freed
}

}  // namespace framewise
