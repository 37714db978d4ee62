// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/io/correspondence_archive.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <cstring>
#include <fstream>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <thread>
#include <tuple>

#include "framewise/geometry/so3.h"
#include "framewise/io/correspondence_archive_writer.h"
#include "framewise/io/hdf5_file.h"
#include "framewise/io/input_error.h"

namespace framewise {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

const double kNan = std::numeric_limits<double>::quiet_NaN();

template <typename T>
bool same_bits(const std::vector<T>& a, const std::vector<T>& b) {
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

bool same_bits(const Correspondences& a, const Correspondences& b) {
  return same_bits(a.pixels1, b.pixels1) && same_bits(a.pixels2, b.pixels2) && same_bits(a.x1, b.x1) &&
         same_bits(a.x2, b.x2) && same_bits(a.z1, b.z1) && same_bits(a.z2, b.z2) &&
         same_bits(a.sigma1, b.sigma1) && same_bits(a.sigma2, b.sigma2) &&
         same_bits(a.distance, b.distance) && a.has_depth == b.has_depth;
}

// Numbers with all their digits; some depths unknown.
Correspondences made_up(std::size_t size, double seed) {
  Correspondences shared;
  shared.has_depth = std::fmod(seed, 2) < 1;
  for (std::size_t i = 0; i < size; ++i) {
    const double a = std::sin(seed + 0.7 * static_cast<double>(i)), b = std::cos(3 * seed + a);
    shared.pixels1.emplace_back(300 + 200 * a, 200 + 100 * b);
    shared.pixels2.emplace_back(300 + 200 * b, 200 + 100 * a);
    shared.x1.push_back(Bearing(a, b, 2).normalized());
    shared.x2.push_back(Bearing(b, a, 2).normalized());
    shared.z1.push_back(i % 3 == 0 ? kNan : 2 + a);
    shared.z2.push_back(i % 5 == 0 ? kNan : 2 + b);
    shared.sigma1.push_back(1e-3 * (1 + a * a));
    shared.sigma2.push_back(1e-3 * (1 + b * b));
    shared.distance.push_back(static_cast<float>(50 * a));
  }
  return shared;
}

ArchiveProvenance some_provenance() {
  ArchiveProvenance provenance{"1.2.3", "desk", "tum", "0123456789abcdef", 2, {}, "camera.yaml", {}};
  provenance.calibration.camera = {CameraModel::kFisheye,    640, 480, 500.1, -500.2, 319.5, 239.5,
                                   {0.1, -0.2, 0.3, -0.4, 0}};
  provenance.calibration.depth_factor = 1000;
  provenance.options = {{"detector", "orb"}, {"features", "1000"}, {"nothing", ""}};
  return provenance;
}

// Three frames, the last of them also matched to the first; one pair shares nothing, one does not fit into
// a chunk.
class CorrespondenceArchiveTest : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::path(::testing::TempDir()) / (std::string("framewise_archive_") + test->name());
    fs::remove_all(folder_);
    fs::create_directories(folder_);
    file_ = folder_ / "a.h5";
  }
  void TearDown() override { fs::remove_all(folder_); }

  void add_everything(CorrespondenceArchiveWriter& writer) const {
    writer.add_frame({1305031790.645155, Pose{so3_exp({0.1, 0.2, 0.3}), {1, 2, 1.0 / 3}}});
    writer.add_pair(0, 1, first_);
    writer.add_frame({1305031790.7, std::nullopt});
    writer.add_pair(1, 2, empty_);
    writer.add_pair(0, 2, long_);
    writer.add_frame({1305031790.8, Pose()});
  }
  void write(const fs::path& file) const {
    CorrespondenceArchiveWriter writer(file, some_provenance());
    add_everything(writer);
    writer.finish();
  }

  static std::string bytes_of(const fs::path& file) {
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    return text.str();
  }
  void set_bytes(const std::string& bytes) const { std::ofstream(file_, std::ios::binary) << bytes; }

  // What reading says of the file: every pair is asked for.
  std::string complaint() const {
    try {
      const CorrespondenceArchive archive(file_);
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = i + 1; j < 3; ++j) archive.pair(i, j);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }

  fs::path folder_, file_;
  Correspondences first_ = made_up(7, 0.3), empty_ = made_up(0, 1.2), long_ = made_up(8300, 0.9);
};

TEST_F(CorrespondenceArchiveTest, GivesBackEveryBit) {
  write(file_);
  const CorrespondenceArchive archive(file_);
  EXPECT_EQ(archive.num_pairs(), 3u);
  EXPECT_TRUE(same_bits(archive.pair(0, 1).value(), first_));
  EXPECT_TRUE(same_bits(archive.pair(1, 2).value(), empty_));
  EXPECT_TRUE(same_bits(archive.pair(0, 2).value(), long_));
  EXPECT_FALSE(archive.pair(1, 0).has_value());
  EXPECT_FALSE(archive.pair(2, 3).has_value());

  ASSERT_EQ(archive.frames().size(), 3u);
  EXPECT_EQ(archive.frames()[0].time, 1305031790.645155);
  const Pose truth{so3_exp({0.1, 0.2, 0.3}), {1, 2, 1.0 / 3}};
  EXPECT_EQ(archive.frames()[0].world_from_cam.value().matrix(), truth.matrix());
  EXPECT_FALSE(archive.frames()[1].world_from_cam.has_value());
}

TEST_F(CorrespondenceArchiveTest, SaysWhereItsMatchesComeFrom) {
  write(file_);
  const ArchiveProvenance expected = some_provenance(), found = CorrespondenceArchive(file_).provenance();
  EXPECT_EQ(found.framewise_version, expected.framewise_version);
  EXPECT_EQ(found.dataset_name, expected.dataset_name);
  EXPECT_EQ(found.dataset_format, expected.dataset_format);
  EXPECT_EQ(found.dataset_fingerprint, expected.dataset_fingerprint);
  EXPECT_EQ(found.frames_with_depth, expected.frames_with_depth);
  EXPECT_EQ(found.options, expected.options);
  EXPECT_EQ(found.calibration_source, expected.calibration_source);
  EXPECT_EQ(found.calibration.depth_factor, 1000);
  const Camera &a = found.calibration.camera, &b = expected.calibration.camera;
  EXPECT_EQ(a.model, b.model);
  EXPECT_EQ(std::tie(a.width, a.height, a.fx, a.fy, a.cx, a.cy, a.distortion),
            std::tie(b.width, b.height, b.fx, b.fy, b.cx, b.cy, b.distortion));
}

TEST_F(CorrespondenceArchiveTest, TheSameCallsGiveTheSameBytes) {
  write(file_);
  write(folder_ / "b.h5");
  EXPECT_EQ(bytes_of(file_), bytes_of(folder_ / "b.h5"));
}

TEST_F(CorrespondenceArchiveTest, ManyThreadsReadWhatOneReads) {
  write(file_);
  const CorrespondenceArchive archive(file_);
  std::atomic<int> right = 0;
  std::vector<std::thread> threads;
  for (int k = 0; k < 4; ++k)
    threads.emplace_back([&, k] {
      for (int repeat = 0; repeat < 20; ++repeat)
        right += k % 2 == 0 ? same_bits(archive.pair(0, 1).value(), first_)
                            : same_bits(archive.pair(0, 2).value(), long_);
    });
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(right, 80);
}

TEST_F(CorrespondenceArchiveTest, AWriterThatBreaksOffLeavesNothing) {
  write(file_);
  {
    CorrespondenceArchiveWriter writer(file_, some_provenance());
    add_everything(writer);
    EXPECT_FALSE(fs::exists(file_)) << "an older archive must not be taken for the new one";
  }
  EXPECT_TRUE(fs::is_empty(folder_));
}

TEST_F(CorrespondenceArchiveTest, AnUnfinishedArchiveSaysSo) {
  CorrespondenceArchiveWriter writer(file_, some_provenance());
  add_everything(writer);
  fs::copy_file(file_.string() + ".part", file_);  // as a killed process leaves it
  EXPECT_THAT(complaint(), HasSubstr("a.h5"));
}

TEST_F(CorrespondenceArchiveTest, RefusesAFileThatIsCutShort) {
  write(file_);
  const std::string whole = bytes_of(file_);
  for (std::size_t size = 0; size < whole.size(); size += 1 + whole.size() / 61) {
    set_bytes(whole.substr(0, size));
    EXPECT_THAT(complaint(), HasSubstr("a.h5")) << size << " of " << whole.size() << " bytes";
  }
  set_bytes(whole.substr(0, whole.size() - 1));
  EXPECT_THAT(complaint(), HasSubstr("a.h5"));
}

TEST_F(CorrespondenceArchiveTest, NeverTakesChangedBytesForOthers) {
  write(file_);
  const std::string whole = bytes_of(file_);
  int found = 0, tried = 0;
  for (std::size_t at = 3; at < whole.size(); at += 1 + whole.size() / 79, ++tried) {
    std::string changed = whole;
    changed[at] = static_cast<char>(changed[at] ^ 0x24);
    set_bytes(changed);
    const std::string said = complaint();
    found += !said.empty();
    if (!said.empty()) continue;
    // A byte that nobody reads: then all that is read is right.
    const CorrespondenceArchive archive(file_);
    EXPECT_TRUE(same_bits(archive.pair(0, 1).value(), first_)) << at;
    EXPECT_TRUE(same_bits(archive.pair(0, 2).value(), long_)) << at;
  }
  EXPECT_GT(found, tried / 2);
}

TEST_F(CorrespondenceArchiveTest, RefusesForeignFiles) {
  EXPECT_THAT(complaint(), HasSubstr("no HDF5 file")) << "a file that is not there";
  set_bytes("time x y z\n");
  EXPECT_THAT(complaint(), HasSubstr("no HDF5 file"));
  set_bytes("");
  EXPECT_THAT(complaint(), HasSubstr("no HDF5 file"));
  {
    const hdf5::Session session;
    const hdf5::Handle foreign = hdf5::create_file(file_);
    hdf5::write_text(foreign, "title", "something else");
  }
  EXPECT_THAT(complaint(), HasSubstr("format: found nothing"));
  {
    const hdf5::Session session;
    const hdf5::Handle foreign = hdf5::create_file(file_);
    hdf5::write_text(foreign, "format", "framewise correspondences");
    hdf5::write_text(foreign, "format_version", "99");
  }
  EXPECT_THAT(complaint(), HasSubstr("format_version: found '99'"));
}

TEST_F(CorrespondenceArchiveTest, RefusesPairsThatMakeNoRecording) {
  const auto archive_of = [&](std::size_t frames, std::size_t index1, std::size_t index2) {
    CorrespondenceArchiveWriter writer(file_, some_provenance());
    for (std::size_t i = 0; i < frames; ++i) writer.add_frame({static_cast<double>(i), std::nullopt});
    writer.add_pair(index1, index2, first_);
    writer.finish();
    return complaint();
  };
  EXPECT_EQ(archive_of(2, 0, 1), "");
  EXPECT_THAT(archive_of(2, 0, 2), HasSubstr("pairs/frames"));
  EXPECT_THAT(archive_of(2, 1, 0), HasSubstr("pairs/frames"));
  EXPECT_THAT(archive_of(3, 0, 1), HasSubstr("neighbours"));
}

TEST_F(CorrespondenceArchiveTest, WritesOverNoFileOfAnotherKind) {
  set_bytes("time x y z\n");
  EXPECT_THROW(CorrespondenceArchiveWriter(file_, some_provenance()), InputError);
  EXPECT_EQ(bytes_of(file_), "time x y z\n");
  EXPECT_THROW(CorrespondenceArchiveWriter(folder_, some_provenance()), InputError);
  EXPECT_THROW(CorrespondenceArchiveWriter(folder_ / "no" / "a.h5", some_provenance()), InputError);
}

TEST_F(CorrespondenceArchiveTest, RefusesCorrespondencesOfTwoLengths) {
  CorrespondenceArchiveWriter writer(file_, some_provenance());
  Correspondences ragged = first_;
  ragged.z2.pop_back();
  EXPECT_THROW(writer.add_pair(0, 1, ragged), std::invalid_argument);
}

}  // namespace
}  // namespace framewise
