// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
// Every format: a recording is written as its files are, and read back as what it was.
#include "framewise/io/dataset.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "framewise/image/depth_rays.h"
#include "framewise/io/axes.h"
#include "framewise/io/input_error.h"
#include "framewise/io/recordings_for_tests.h"
#include "framewise/io/trajectory_files.h"

namespace framewise {
namespace {

using testing::HasSubstr;
using DatasetTest = RecordingTest;

class TumLayout : public RecordingTest {
 protected:
  // Folders rgb and depth, named by stamps; lists where asked for.
  void write_images(double factor, bool lists) const {
    std::string rgb, depth;
    for (int i = 0; i < kFrames; ++i) {
      const std::string stamp = fmt::format("{:.6f}", 100 + i / 30.0);
      write("rgb/" + stamp + ".png", color_image(i));
      write("depth/" + stamp + ".png", raw_depth(i, factor));
      rgb += stamp + " rgb/" + stamp + ".png\n";
      depth += stamp + " depth/" + stamp + ".png\n";
    }
    if (!lists) return;
    write("rgb.txt", "# color images\n" + rgb);
    write("depth.txt", depth);
  }
  std::string truth(bool numbers = false) const {
    std::string text;
    for (int i = 0; i < kFrames; ++i) {
      const double time = numbers ? i : 100 + i / 30.0;
      text += tum_line(numbers ? time : std::stod(fmt::format("{:.6f}", time)), true_pose(i)) + "\n";
    }
    return text;
  }
};

TEST_F(TumLayout, TumIsToldByItsLists) {
  write_images(5000, true);
  write("groundtruth.txt", truth());
  write("camera.yaml", small_camera_yaml());
  const Dataset dataset = open_dataset(folder_, {});
  expect_recording(dataset, {"tum", 100});
  EXPECT_EQ(dataset.recognised_by, "it has rgb.txt");
  EXPECT_EQ(dataset.truth_source, "groundtruth.txt");
}

TEST_F(TumLayout, TumNeedsNoListsWhereNamesAreStamps) {
  write_images(5000, false);
  write("groundtruth.txt", truth());
  write("camera.yaml", small_camera_yaml());
  expect_recording(open_dataset(folder_, {}), {"tum", 100});
}

TEST_F(TumLayout, PutkkIsToldByItsNameAndCountsMillimetres) {
  write_images(1000, true);
  write("groundtruth.txt", truth());
  write("camera.yaml", small_camera_yaml());
  const auto named = root_ / "putkk_Dataset_1_Kin_1";
  std::filesystem::rename(folder_, named);
  expect_recording(open_dataset(named, {}), {"putkk", 100});
}

TEST_F(TumLayout, PutkksCamerasAreToldByNameOrSize) {
  const auto calibration_of = [&](const std::string& name, cv::Size size) {
    folder_ = root_ / name;
    write("rgb/1.5.png", cv::Mat(size, CV_8U, cv::Scalar(9)));
    return open_dataset(folder_, {}).calibration_source;
  };
  EXPECT_EQ(calibration_of("putkk_Dataset_1_Kin_1", {64, 48}), "putkk-kinect1");
  EXPECT_EQ(calibration_of("putkk_Dataset_1_Kin_2", {64, 48}), "putkk-kinect2");
  EXPECT_EQ(calibration_of("PUTKK_a", {1920, 1080}), "putkk-kinect2");
  EXPECT_EQ(calibration_of("PUTKK_b", {640, 480}), "putkk-kinect1");
}

TEST_F(TumLayout, IclNuimsNumbersAreFramesAndItsAxesAreMirrored) {
  std::string pairs;
  for (int i = 0; i < kFrames; ++i) {
    write(fmt::format("rgb/{}.png", i), color_image(i));
    write(fmt::format("depth/{}.png", i), raw_depth(i, 5000));
    pairs += fmt::format("{0} depth/{0}.png {0} rgb/{0}.png\n", i);
  }
  write("associations.txt", pairs);
  std::string poses;
  for (int i = 0; i < kFrames; ++i) poses += tum_line(i, mirrored_in_y(true_pose(i))) + "\n";
  write("livingRoom0.gt.freiburg", poses);
  write("camera.yaml", small_camera_yaml());
  const Dataset dataset = open_dataset(folder_, {});
  expect_recording(dataset, {"icl-nuim"});
  EXPECT_THAT(dataset.recognised_by, HasSubstr("livingRoom0.gt.freiburg"));
  // A camera that keeps the renderer's fy keeps its axes.
  write("camera.yaml", "width: 24\nheight: 18\nfx: 20\nfy: -21\ncx: 11.5\ncy: 8.5\n");
  expect_same_pose(open_dataset(folder_, {}).truth.world_from_cam[1], mirrored_in_y(true_pose(1)));
  EXPECT_DOUBLE_EQ(known_calibration("icl-nuim")->camera.fy, 480);
}

class SevenScenesLayout : public RecordingTest {
 protected:
  void write_frames(const Pose& cam_from_depth_cam) const {
    for (int i = 0; i < kFrames; ++i) {
      const std::string frame = fmt::format("frame-{:06}.", i);
      write(frame + "color.png", color_image(i));
      write(frame + "depth.png", raw_depth(i, 1000));
      write(frame + "pose.txt", matrix_rows(true_pose(i) * cam_from_depth_cam, 4, "\n"));
    }
  }
};

TEST_F(SevenScenesLayout, IsReadInMillimetres) {
  write_frames({});
  cv::Mat raw = raw_depth(1, 1000);
  raw.at<std::uint16_t>(4, 3) = 65535;  // unknown as well
  write("frame-000001.depth.png", raw);
  write("camera.yaml", small_camera_yaml());
  DatasetOptions options;
  options.depth_max = 100;
  const Dataset dataset = open_dataset(folder_, options);
  expect_recording(dataset, {"7-scenes"});
  EXPECT_EQ(dataset.recognised_by, "it has frame-000000.color.png");
}

TEST_F(SevenScenesLayout, ColourIsNotReadWhereDepthAloneIsAskedFor) {
  write_frames({});
  write("frame-000001.color.png", std::string("no image"));
  write("camera.yaml", small_camera_yaml());
  const Dataset dataset = open_dataset(folder_, {});
  EXPECT_THROW(load_frame(dataset, 1), InputError);
  const Frame frame = load_depth(dataset, 1);
  EXPECT_TRUE(frame.gray.empty());
  EXPECT_EQ(frame.depth.cols, kWidth);
  EXPECT_EQ(frame.time, dataset.frames[1].time);
}

TEST_F(SevenScenesLayout, DepthIsMovedIntoTheColourImageAndTheTruthToItsCamera) {
  // Colour and depth of one size but the depth camera 1/16 m to the right: at 1 m and fx 16 a pixel.
  const Pose cam_from_depth_cam{Eigen::Matrix3d::Identity(), {0.0625, 0, 0}};
  write_frames(cam_from_depth_cam);
  cv::Mat wall(kHeight, kWidth, CV_16U, cv::Scalar(1000));
  wall.at<std::uint16_t>(5, 7) = 0;
  write("frame-000000.depth.png", wall);
  const std::string camera = "width: 24\nheight: 18\nfx: 16\nfy: 16\ncx: 11.5\ncy: 8.5\n";
  write("camera.yaml", camera +
                           "depth_camera: {width: 24, height: 18, fx: 16, fy: 16, cx: 11.5, cy: 8.5,\n"
                           "  camera_from_depth_camera: [1, 0, 0, 0.0625, 0, 1, 0, 0, 0, 0, 1, 0]}\n");
  const Dataset dataset = open_dataset(folder_, {});
  for (int i = 0; i < kFrames; ++i)
    expect_same_pose(dataset.truth.world_from_cam[static_cast<std::size_t>(i)], true_pose(i));
  const cv::Mat depth = load_frame(dataset, 0).depth;
  EXPECT_TRUE(std::isnan(depth.at<float>(5, 0)));  // left of what the depth camera saw
  EXPECT_TRUE(std::isnan(depth.at<float>(5, 8)));
  EXPECT_EQ(depth.at<float>(5, 7), 1);

  DatasetOptions as_it_is;
  as_it_is.register_depth = false;
  const Dataset plain = open_dataset(folder_, as_it_is);
  EXPECT_TRUE(std::isnan(load_frame(plain, 0).depth.at<float>(5, 7)));
  expect_same_pose(plain.truth.world_from_cam[2], true_pose(2) * cam_from_depth_cam);
}

TEST_F(SevenScenesLayout, TheFittedColourCameraIsKnown) {
  const CameraFile fitted = *known_calibration("7-scenes");
  // data's formula: u = 525 (X - 0.025) / Z + 321, v = 525 Y / Z + 237, (X, Y, Z) in the depth camera.
  const Eigen::Vector3d X(0.3, -0.2, 2);
  const auto pixel = fitted.camera.project(fitted.depth_camera->cam_from_depth_cam * X);
  EXPECT_LT((*pixel - Eigen::Vector2d(525 * (0.3 - 0.025) / 2 + 321, 525 * -0.2 / 2 + 237)).norm(), 1e-12);
  EXPECT_LT((*fitted.depth_camera->camera.project({0.3, -0.2, 2}) - Eigen::Vector2d(407.75, 181.5)).norm(),
            1e-12);
}

TEST_F(SevenScenesLayout, FramesMayLackDepthAndPoses) {
  write_frames({});
  write("camera.yaml", small_camera_yaml());
  std::filesystem::remove(folder_ / "frame-000001.depth.png");
  std::filesystem::remove(folder_ / "frame-000000.pose.txt");
  write("frame-000002.pose.txt", "-inf -inf -inf -inf\n-inf -inf -inf -inf\n-inf -inf -inf -inf\n0 0 0 1\n");
  const Dataset dataset = open_dataset(folder_, {});
  EXPECT_EQ(dataset.frames_with_depth, 2u);
  EXPECT_EQ(dataset.truth.size(), 1u);
}

TEST_F(SevenScenesLayout, SaysWhatIsWrong) {
  write_frames({});
  write("camera.yaml", small_camera_yaml());
  write("frame-000001.pose.txt", "1 0 0 0\n0 1 0 0\n0 0 2 0\n0 0 0 1\n");
  EXPECT_THAT(refusal(), HasSubstr("frame-000001.pose.txt: rotation: found"));
  write("frame-000001.pose.txt", "1 0 0\n0 1 0 0\n0 0 2 0\n0 0 0 1\n");
  EXPECT_THAT(refusal(), HasSubstr("frame-000001.pose.txt:1: columns: found 3, expected 4"));
  std::filesystem::remove(folder_ / "camera.yaml");
  write_frames({});
  EXPECT_THAT(refusal(), HasSubstr("24 x 18, expected 640 x 480 as in the calibration (7-scenes)"));
}

class KittiLayout : public RecordingTest {
 protected:
  void write_sequence(const std::string& images) const {
    std::string poses, times;
    for (int i = 0; i < kFrames; ++i) {
      write(fmt::format("{}/{:06}.png", images, i), color_image(i));
      poses += matrix_rows(true_pose(i), 3, " ");
      times += fmt::format("{:e}\n", 0.1 * i);
    }
    write("poses.txt", poses);
    write("times.txt", times);
    write("calib.txt", "P0: 20 0 11.5 0 0 20 8.5 0 0 0 1 0\nP2: 20 0 11.5 10.23 0 20 8.5 4.17 0 0 1 0.02\n");
  }
};

TEST_F(KittiLayout, IsReadWithItsCalibrationTimesAndPoses) {
  write_sequence("image_0");
  const Dataset dataset = open_dataset(folder_, {});
  expect_recording(dataset, {"kitti", 0, 0.1, true, false});
  EXPECT_EQ(dataset.calibration.camera.fx, 20);
  EXPECT_EQ(dataset.calibration.camera.width, kWidth);
  EXPECT_EQ(dataset.calibration_source, "calib.txt, P0");
}

TEST_F(KittiLayout, PosesMayLieApart) {
  folder_ = root_ / "sequences" / "03";
  write_sequence("image_0");
  std::filesystem::create_directories(root_ / "poses");
  std::filesystem::rename(folder_ / "poses.txt", root_ / "poses" / "03.txt");
  const Dataset dataset = open_dataset(folder_ / "", {});
  expect_recording(dataset, {"kitti", 0, 0.1, true, false});
  EXPECT_EQ(dataset.truth_source, "03.txt");
}

TEST_F(KittiLayout, TheColourCameraStandsBesideTheGrayOne) {
  write_sequence("image_2");
  const Dataset dataset = open_dataset(folder_, {});
  // P2 = K [I | t] with t = (0.5, 0.2, 0.02): camera 2 sees camera 0's centre there.
  for (int i = 0; i < kFrames; ++i)
    EXPECT_LT((dataset.truth.world_from_cam[static_cast<std::size_t>(i)] * Eigen::Vector3d(0.5, 0.2, 0.02) -
               true_pose(i).t)
                  .norm(),
              1e-9);
}

TEST_F(KittiLayout, DepthBesideTheImagesIsIn256thsOfAMetre) {
  write_sequence("image_0");
  for (int i = 0; i < kFrames; ++i) write(fmt::format("depth/{:06}.png", i), raw_depth(i, 256));
  expect_recording(open_dataset(folder_, {}), {"kitti", 0, 0.1});
}

TEST_F(KittiLayout, DepthAloneIsToldByItsPath) {
  folder_ = root_ / "proj_depth" / "groundtruth" / "image_02";
  for (int i = 0; i < kFrames; ++i) write(fmt::format("{:010}.png", i + 5), raw_depth(i, 256));
  write("camera.yaml", small_camera_yaml());
  expect_recording(open_dataset(folder_, {}), {"kitti-depth", 0, 0.1, false, true, false});
}

TEST_F(KittiLayout, SaysWhatIsWrong) {
  write_sequence("image_0");
  write("times.txt", "0\n0.1\n");
  EXPECT_THAT(refusal(), HasSubstr("times.txt: stamps: found 2, expected 3"));
  write_sequence("image_0");
  write("poses.txt", matrix_rows(true_pose(0), 3, " "));
  EXPECT_THAT(refusal(), HasSubstr("poses.txt: poses: found 1, expected 3"));
  write("calib.txt", "P0: 20 0 11.5\n");
  EXPECT_THAT(refusal(), HasSubstr("calib.txt:1: P0: found 3 numbers, expected 12"));
  write("calib.txt", "P1: 1\n");
  EXPECT_THAT(refusal(), HasSubstr("calib.txt: P0: found nothing"));
}

class EurocLayout : public RecordingTest {
 protected:
  // A camera that looks along the body's x, 0.1 m to its left.
  Pose body_from_cam() const {
    Pose pose;
    pose.R << 0, 0, 1, -1, 0, 0, 0, -1, 0;
    pose.t = {0, 0.1, 0};
    return pose;
  }
  std::string sensor_yaml(const Pose& body_from_sensor) const {
    std::string data = matrix_rows(body_from_sensor, 4, " ");
    for (char& c : data)
      if (c == ' ') c = ',';
    data.pop_back();
    return "%YAML:1.0\n#comment\nsensor_type: camera\nT_BS:\n  cols: 4\n  rows: 4\n  data: [" + data + "]\n";
  }
  void write_recording() const {
    std::string images = "#timestamp [ns],filename\r\n", poses = "#timestamp, p_RS_R_x [m], ...\n",
                rates = "#timestamp [ns],w_RS_S_x [rad s^-1],...\n";
    for (int i = 0; i < kFrames; ++i) {
      const long stamp = 1403636579763555584 + 50000000L * i;
      write(fmt::format("mav0/cam0/data/{}.png", stamp), color_image(i));
      images += fmt::format("{0},{0}.png\r\n", stamp);
      const Pose body = true_pose(i) * body_from_cam().inverse();
      const Eigen::Quaterniond q = body.quaternion();
      poses += fmt::format("{},{},{},{},{},{},{},{},0,0,0\n", stamp, body.t.x(), body.t.y(), body.t.z(),
                           q.w(), q.x(), q.y(), q.z());
      rates += fmt::format("{},0.1,0.2,0.3,9,0,0\n", stamp);
    }
    write("mav0/cam0/data.csv", images);
    write("mav0/state_groundtruth_estimate0/data.csv", poses);
    write("mav0/imu0/data.csv", rates);
    write("mav0/imu0/sensor.yaml", sensor_yaml({}));
    write("mav0/cam0/sensor.yaml",
          sensor_yaml(body_from_cam()) +
              "resolution: [24, 18]\ncamera_model: pinhole\nintrinsics: [20, 21, 11.5, 8.5] #fu, fv, cu, cv\n"
              "distortion_model: radial-tangential\ndistortion_coefficients: [0.1, 0.01, 0, 0]\n");
  }
};

TEST_F(EurocLayout, PosesOfTheBodyBecomePosesOfTheCamera) {
  write_recording();
  const Dataset dataset = open_dataset(folder_, {});
  expect_recording(dataset, {"euroc", 1403636579.763555584, 0.05, true, false});
  EXPECT_EQ(dataset.calibration.camera.distortion[0], 0.1);
  EXPECT_EQ(dataset.calibration.camera.fy, 21);
  EXPECT_EQ(dataset.recognised_by, "it has mav0/cam0/data.csv");
  EXPECT_EQ(open_dataset(folder_ / "mav0", {}).truth.size(), 3u);
}

TEST_F(EurocLayout, TheGyroscopeTurnsInTheCamerasAxes) {
  write_recording();
  const Dataset dataset = open_dataset(folder_, {});
  ASSERT_EQ(dataset.gyroscope.size(), 3u);
  // Body rates (0.1, 0.2, 0.3) about x forward, y left, z up are (-0.2, -0.3, 0.1) about right, down,
  // forward.
  EXPECT_LT((dataset.gyroscope.cam_from_gyro * dataset.gyroscope.rates[0] - Eigen::Vector3d(-0.2, -0.3, 0.1))
                .norm(),
            1e-12);
}

TEST_F(EurocLayout, SaysWhatIsWrong) {
  write_recording();
  write("mav0/cam0/data.csv", "#t\n1403636579763555584\n");
  EXPECT_THAT(refusal(), HasSubstr("data.csv:2: found '1403636579763555584', expected nanoseconds,file"));
  write("mav0/cam0/data.csv", "#t\n");
  EXPECT_THAT(refusal(), HasSubstr("data.csv: found an empty list"));
  write("mav0/cam0/data.csv", "1403636579763555584,no.png\n");
  EXPECT_THAT(refusal(), HasSubstr("data.csv:1: found 'no.png', expected a file that exists"));
}

TEST_F(DatasetTest, AFolderOfImagesIsInNaturalOrder) {
  for (int i = 0; i < kFrames; ++i) write(fmt::format("img{}.png", 9 + i), color_image(i));
  write("camera.yaml", small_camera_yaml());
  DatasetOptions options;
  options.fps = 20;
  expect_recording(open_dataset(folder_, options), {"images", 0, 0.05, true, false, false});
  EXPECT_THAT(open_dataset(folder_, {}).times_source, HasSubstr("30 frames a second, assumed"));
  write("times.txt", "5\n5.5\n6\n");
  expect_recording(open_dataset(folder_, options), {"images", 5, 0.5, true, false, false});
}

TEST_F(DatasetTest, ACameraFileIsAskedForWhereNoneIsKnown) {
  write("a.png", color_image(0));
  EXPECT_THAT(refusal(), HasSubstr("expected a camera file: --camera FILE"));
  DatasetOptions options;
  options.needs_camera = false;
  const Dataset dataset = open_dataset(folder_, options);
  EXPECT_FALSE(dataset.has_camera());
  EXPECT_EQ(load_frame(dataset, 0).gray.cols, kWidth);
}

TEST_F(DatasetTest, RangeImagesBecomeDepthAlongTheAxis) {
  const cv::Mat full = raw_depth(0, 1000);
  const DepthRays rays(small_camera(), DepthType::kRange);
  for (int i = 0; i < kFrames; ++i) {
    cv::Mat raw(kHeight, kWidth, CV_16U);
    for (int v = 0; v < kHeight; ++v)
      for (int u = 0; u < kWidth; ++u)
        raw.at<std::uint16_t>(v, u) = static_cast<std::uint16_t>(
            std::lround(true_depth(i, u, v) / rays.z_per_range.at<float>(v, u) / 20 * 65535));
    write(fmt::format("depth_image_scene{:04}.png", i + 1), raw);
  }
  write("camera.yaml", small_camera_yaml());
  EXPECT_THAT(refusal(), HasSubstr("16-bit numbers of no known unit, expected --depth-factor"));
  DatasetOptions options;
  options.depth_type = "range";
  options.depth_max = 20;
  expect_recording(open_dataset(folder_, options), {"depth", 0, 1.0 / 30, false, true, false});
}

TEST_F(DatasetTest, DepthInFloatsIsMetres) {
  for (int i = 0; i < kFrames; ++i) {
    cv::Mat metres;
    raw_depth(i, 1000).convertTo(metres, CV_32F, 1e-3);
    metres.at<float>(4, 3) = 1e10f;  // how renderers write what is nowhere
    write(fmt::format("{}.tiff", i), metres);
  }
  write("camera.yaml", small_camera_yaml());
  expect_recording(open_dataset(folder_, {}), {"depth", 0, 1.0 / 30, false, true, false});
}

TEST_F(DatasetTest, BlendersFramesAreNumbered) {
  std::string path = "frame,x,y,z,qw,qx,qy,qz\n";
  const Eigen::Matrix3d flip = Eigen::Vector3d(1, -1, -1).asDiagonal();
  for (int i = 0; i < kFrames; ++i) {
    write(fmt::format("rgb/render{:04}.png", i + 10), color_image(i));
    write(fmt::format("depth/Image{:04}.png", i + 10), raw_depth(i, 5000));
    const Eigen::Quaterniond q(Eigen::Matrix3d(true_pose(i).R * flip));
    const Eigen::Vector3d& t = true_pose(i).t;
    path += fmt::format("{},{},{},{},{},{},{},{}\n", i + 10, t.x(), t.y(), t.z(), q.w(), q.x(), q.y(), q.z());
  }
  write("camera_path.csv", path);
  write("camera.yaml", small_camera_yaml() + "depth_factor: 5000\n");
  expect_recording(open_dataset(folder_, {}), {"blender", 0, 1.0 / 24});
  std::filesystem::rename(folder_ / "depth", folder_ / "range");
  EXPECT_EQ(open_dataset(folder_, {}).calibration.depth_type, DepthType::kRange);
}

TEST_F(DatasetTest, HololensPosesAreRowsOfSixteenNumbers) {
  std::string poses;
  for (int i = 0; i < kFrames; ++i) {
    write(fmt::format("color/{}.png", i), color_image(i));
    write(fmt::format("depth/{}.png", i), raw_depth(i, 1000));
    poses += matrix_rows(true_pose(i), 4, " ");
  }
  write("poses.txt", poses);
  write("camera.yaml", small_camera_yaml());
  expect_recording(open_dataset(folder_, {}), {"hololens"});

  write(
      "poses.txt",
      "1 0 0 0 0 1 0 0 0 0 1 0 5 6 7 1\n1 0 0 0 0 1 0 0 0 0 1 0 5 6 7 1\n1 0 0 0 0 1 0 0 0 0 1 0 5 6 7 1\n");
  EXPECT_THAT(refusal(), HasSubstr("poses.txt:1: last row: found 5 6 7 1, expected 0 0 0 1"));
  write("poses.txt", matrix_rows(true_pose(0), 4, " "));
  EXPECT_THAT(refusal(), HasSubstr("poses.txt: poses: found 1, expected 3"));
}

TEST_F(DatasetTest, TheFormatCanBeChosen) {
  for (int i = 0; i < kFrames; ++i) write(fmt::format("{}.png", i), raw_depth(i, 256));
  write("camera.yaml", small_camera_yaml());
  DatasetOptions options;
  options.format = "kitti-depth";
  const Dataset dataset = open_dataset(folder_, options);
  expect_recording(dataset, {"kitti-depth", 0, 0.1, false, true, false});
  EXPECT_THAT(dataset.recognised_by, HasSubstr("--format"));
  options.format = "kinect";
  EXPECT_THAT(refusal(options), HasSubstr("format: found 'kinect', expected one of euroc, kitti"));
}

TEST_F(DatasetTest, EachFormatRefusesAFolderThatIsEmptyOrMissing) {
  EXPECT_THAT(refusal(), HasSubstr("found no data set of a known format, expected one of: euroc (mav0"));
  for (const std::string& format : dataset_formats()) {
    DatasetOptions options;
    options.format = format;
    EXPECT_THAT(refusal(options), HasSubstr(folder_.string())) << format;
  }
  std::filesystem::remove(folder_);
  for (const std::string& format : dataset_formats()) {
    DatasetOptions options;
    options.format = format;
    EXPECT_THAT(refusal(options), HasSubstr(folder_.string())) << format;
  }
  EXPECT_THAT(refusal(), HasSubstr("found no folder or file"));
}

TEST_F(DatasetTest, TheSameRecordingHasTheSameFingerprintAndAnotherOneAnother) {
  for (int i = 0; i < kFrames; ++i) write(fmt::format("{}.png", i), color_image(i));
  write("camera.yaml", small_camera_yaml());
  const std::string first = open_dataset(folder_, {}).fingerprint;
  EXPECT_EQ(open_dataset(folder_ / "", {}).fingerprint, first);
  write("1.png", cv::Mat(kHeight, kWidth, CV_8U, cv::Scalar(0)));
  EXPECT_NE(open_dataset(folder_, {}).fingerprint, first);
}

}  // namespace
}  // namespace framewise
