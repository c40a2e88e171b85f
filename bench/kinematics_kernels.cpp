// SPDX-License-Identifier: GPL-3.0-or-later
// Google Benchmark kernels of kinematics: a rigid body of six markers and the whole chain of
// fifteen, beside Eigen's umeyama (a singular value decomposition) and Theobald's QCP (a quartic
// for the quaternion, as molecules are superposed; in gemmi) on the same rows. Each says how far
// its poses are from the true ones (root mean square, mm and degrees) with noise of 0.1, 0.5 and 2
// mm on every coordinate.
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <stdexcept>

#include <Eigen/Geometry>
#include <benchmark/benchmark.h>
#include <gemmi/qcp.hpp>
#include <sys/resource.h>

#include "core/files.hpp"
#include "core/random.hpp"
#include "device/markers/marker_csv.hpp"
#include "device/markers/marker_reader.hpp"
#include "kinematics/arm_frames.hpp"
#include "kinematics/tables/pose_csv.hpp"

namespace isograsp {

namespace {

constexpr std::size_t kRows = 512;
/// The object of tests/data/isotonic/kurillo15.toml.
const std::vector<Vec3> kBody{{0.03, 0.02, 0.04},   {-0.03, 0.02, 0.04},  {0.03, -0.02, 0.04},
                              {-0.03, 0.02, -0.04}, {0.03, -0.02, -0.04}, {-0.03, -0.02, -0.035}};

struct SeenBody {
  std::vector<Pose> X_WB;
  std::vector<std::vector<Vec3>> p_W;
};

/// Poses all over a metre, noise on each coordinate; `astray_m` off for one marker.
SeenBody seen_body(double noise_m, double astray_m) {
  Random random(1);
  SeenBody seen;
  for (std::size_t row = 0; row < kRows; ++row) {
    const auto one = [&random] { return 2.0 * random.uniform() - 1.0; };
    Pose X_WB;
    X_WB.p = {one(), one(), one()};
    X_WB.q = Quat(one() + 1.5, one(), one(), one()).normalized();
    std::vector<Vec3> p_W;
    for (const Vec3& p : kBody)
      p_W.push_back(X_WB.p + X_WB.q * p +
                    noise_m * Vec3(random.gaussian(), random.gaussian(), random.gaussian()));
    p_W[row % kBody.size()].x() += astray_m;
    seen.X_WB.push_back(X_WB);
    seen.p_W.push_back(std::move(p_W));
  }
  return seen;
}

/// Root mean square over the rows that have a pose.
void tell_error(benchmark::State& bench, const SeenBody& seen, const std::vector<Pose>& found) {
  double squares_m = 0.0, squares_rad = 0.0;
  int count = 0;
  for (std::size_t row = 0; row < kRows; ++row) {
    if (is_missing(found[row])) continue;
    squares_m += (found[row].p - seen.X_WB[row].p).squaredNorm();
    squares_rad += std::pow(angle_between(found[row].q, seen.X_WB[row].q), 2.0);
    ++count;
  }
  bench.counters["mm"] = 1e3 * std::sqrt(squares_m / count);
  bench.counters["deg"] = 180.0 / std::numbers::pi * std::sqrt(squares_rad / count);
  bench.counters["poses_%"] = 100.0 * count / kRows;
}

/// Limits as for a rigid object, but never below what the noise needs.
void rigid_body(benchmark::State& bench, double noise_m, double astray_m) {
  const RigidBody body(kBody, std::max(0.002, 3.0 * noise_m));
  const SeenBody seen = seen_body(noise_m, astray_m);
  std::vector<Pose> found(kRows);
  std::size_t row = 0;
  for (auto _ : bench) {
    found[row] = body.fit(seen.p_W[row]).X_WB;
    benchmark::DoNotOptimize(found[row]);
    row = (row + 1) % kRows;
  }
  for (row = 0; row < kRows; ++row) found[row] = body.fit(seen.p_W[row]).X_WB;
  tell_error(bench, seen, found);
}
BENCHMARK_CAPTURE(rigid_body, noise_100_um, 1e-4, 0.0);
BENCHMARK_CAPTURE(rigid_body, noise_500_um, 5e-4, 0.0);
BENCHMARK_CAPTURE(rigid_body, noise_2000_um, 2e-3, 0.0);
BENCHMARK_CAPTURE(rigid_body, noise_100_um_one_astray, 1e-4, 0.03);
BENCHMARK_CAPTURE(rigid_body, noise_500_um_one_astray, 5e-4, 0.03);
BENCHMARK_CAPTURE(rigid_body, noise_2000_um_one_astray, 2e-3, 0.03);

/// `pose_of` a row, made of the body and what is seen of it as the peer wants them.
template <class Points, class PoseOf>
void beside(benchmark::State& bench, double noise_m, double astray_m, Points points_of,
            PoseOf pose_of) {
  const SeenBody seen = seen_body(noise_m, astray_m);
  const auto body = points_of(kBody);
  std::vector<decltype(points_of(kBody))> rows;
  for (const auto& p_W : seen.p_W) rows.push_back(points_of(p_W));
  std::vector<Pose> found(kRows);
  std::size_t row = 0;
  for (auto _ : bench) {
    found[row] = pose_of(body, rows[row]);
    benchmark::DoNotOptimize(found[row]);
    row = (row + 1) % kRows;
  }
  for (row = 0; row < kRows; ++row) found[row] = pose_of(body, rows[row]);
  tell_error(bench, seen, found);
}

void eigen_umeyama(benchmark::State& bench, double noise_m, double astray_m) {
  using Points = Eigen::Matrix<double, 3, 6>;
  beside(
      bench, noise_m, astray_m,
      [](const std::vector<Vec3>& p) {
        Points points;
        for (Eigen::Index k = 0; k < 6; ++k) points.col(k) = p[static_cast<std::size_t>(k)];
        return points;
      },
      [](const Points& body, const Points& row) {
        const Eigen::Matrix4d X = Eigen::umeyama(body, row, false);
        return Pose{X.block<3, 1>(0, 3), Quat(Mat3(X.block<3, 3>(0, 0)))};
      });
}
BENCHMARK_CAPTURE(eigen_umeyama, noise_100_um, 1e-4, 0.0);
BENCHMARK_CAPTURE(eigen_umeyama, noise_500_um, 5e-4, 0.0);
BENCHMARK_CAPTURE(eigen_umeyama, noise_2000_um, 2e-3, 0.0);
BENCHMARK_CAPTURE(eigen_umeyama, noise_2000_um_one_astray, 2e-3, 0.03);

/// In millimetres: below some 1e-6 of a squared unit its quaternion counts as none.
void gemmi_qcp(benchmark::State& bench, double noise_m, double astray_m) {
  using Points = std::array<gemmi::Position, 6>;
  beside(
      bench, noise_m, astray_m,
      [](const std::vector<Vec3>& p) {
        Points points;
        for (std::size_t k = 0; k < 6; ++k)
          points[k] = gemmi::Position(1e3 * p[k].x(), 1e3 * p[k].y(), 1e3 * p[k].z());
        return points;
      },
      [](const Points& body, const Points& row) {
        const auto X = gemmi::superpose_positions(row.data(), body.data(), 6, nullptr).transform;
        Mat3 R;
        for (int i = 0; i < 3; ++i)
          for (int j = 0; j < 3; ++j) R(i, j) = X.mat[i][j];
        return Pose{{1e-3 * X.vec.x, 1e-3 * X.vec.y, 1e-3 * X.vec.z}, Quat(R)};
      });
}
BENCHMARK_CAPTURE(gemmi_qcp, noise_100_um, 1e-4, 0.0);
BENCHMARK_CAPTURE(gemmi_qcp, noise_500_um, 5e-4, 0.0);
BENCHMARK_CAPTURE(gemmi_qcp, noise_2000_um, 2e-3, 0.0);
BENCHMARK_CAPTURE(gemmi_qcp, noise_2000_um_one_astray, 2e-3, 0.03);

template <class T>
T value_or_throw(Result<T> result) {
  if (!result) throw std::runtime_error(result.error().message());
  return std::move(*result);
}

const std::vector<std::string> kMarkers{"B1", "B2", "B3", "EL", "F1", "F2", "W", "D1",
                                        "D2", "O1", "O2", "O3", "O4", "O5", "O6"};

Rig arm() {
  const std::string file = std::string(ISOGRASP_SOURCE_DIR) + "/tests/data/isotonic/kurillo15.toml";
  return value_or_throw(parse_rig(value_or_throw(read_text(file)), file));
}

/// Brace, elbow, forearm, back of the hand and object: the last one moves, the others are still.
std::vector<std::vector<Vec3>> rows_of_arm() {
  std::vector<std::vector<Vec3>> rows;
  for (const auto& seen : seen_body(1e-4, 0.0).p_W) {
    std::vector<Vec3> row{{0, 0, 0},       {0.1, 0, 0},       {0, 0.1, 0},
                          {0.05, 0.05, 0}, {0.05, 0.3, 0.02}, {0.05, 0.3, -0.02},
                          {0.05, 0.35, 0}, {0.08, 0.43, 0},   {0.02, 0.43, 0}};
    row.insert(row.end(), seen.begin(), seen.end());
    rows.push_back(std::move(row));
  }
  return rows;
}

void chain_of_fifteen_markers(benchmark::State& bench) {
  auto frames = value_or_throw(ArmFrames::compile(arm(), kMarkers));
  const auto rows = rows_of_arm();
  std::vector<FramePose> solved(frames.frames());
  std::size_t row = 0;
  for (auto _ : bench) {
    frames.solve(rows[row], solved);
    benchmark::DoNotOptimize(solved.data());
    row = (row + 1) % kRows;
  }
}
BENCHMARK(chain_of_fifteen_markers);

double resident_MB() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

/// What `isograsp markers poses` does with a table of one hour at 100 Hz.
void an_hour_of_markers_into_poses(benchmark::State& bench) {
  constexpr int kHour = 360'000;
  const std::filesystem::path folder = std::filesystem::temp_directory_path();
  const std::string in = folder / "isograsp_bench_markers.csv";
  const std::string out = folder / "isograsp_bench_poses.csv";
  const Rig rig = arm();
  const auto rows = rows_of_arm();
  {
    auto writer = value_or_throw(MarkerCsvWriter::create(in, kMarkers));
    for (int k = 0; k < kHour; ++k)
      writer.write(0.01 * k, rows[static_cast<std::size_t>(k) % kRows]);
    if (const auto done = writer.commit(); !done) throw std::runtime_error(done.error().message());
  }
  const double before_MB = resident_MB();
  for (auto _ : bench) {
    const auto reader = value_or_throw(open_markers(in));
    auto frames = value_or_throw(ArmFrames::compile(rig, reader->markers()));
    auto writer = value_or_throw(PoseWriter::create(out, rig, Hand::right));
    std::vector<Vec3> p_W(reader->markers().size());
    std::vector<FramePose> solved(frames.frames());
    for (double t_s = 0.0; value_or_throw(reader->next(t_s, p_W));) {
      frames.solve(p_W, solved);
      writer.write(t_s, solved);
    }
    if (const auto done = writer.commit(); !done) throw std::runtime_error(done.error().message());
  }
  bench.counters["more_MB"] = resident_MB() - before_MB;
  std::filesystem::remove(in);
  std::filesystem::remove(out);
}
BENCHMARK(an_hour_of_markers_into_poses)->Iterations(1);

}  // namespace

}  // namespace isograsp
