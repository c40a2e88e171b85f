// SPDX-License-Identifier: GPL-3.0-or-later
// isograsp simulate and grasp as a user calls them: the trajectory format, the rules of the holds,
// and bad input that must say where it is and leave no file.
#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/csv.hpp"
#include "tests/support/every.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/within.hpp"

namespace isograsp::app::simulate_test {
namespace {

struct Answer {
  int status = -1;
  std::string out;
  std::string err;
};

Answer run(const test::TemporaryFolder& folder, const std::string& arguments) {
  const std::string out = folder.path("stdout");
  const std::string err = folder.path("stderr");
  const std::string line =
      std::string(ISOGRASP_EXECUTABLE) + " " + arguments + " >" + out + " 2>" + err;
  const int status = std::system(line.c_str());
  const auto text = [](const std::string& path) {
    std::stringstream all;
    all << std::ifstream(path).rdbuf();
    return all.str();
  };
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, text(out), text(err)};
}

std::string scene(const std::string& more = "", const std::string& free = "\"x\"") {
  return R"(format = "isograsp-scene-1"
[object]
shape = "sphere"
size_m = [0.06]
mass_kg = 1
[dynamics]
free = [)" +
         free + R"(]
stiffness = [0, 0, 0, 0, 0, 0]
damping = [0, 0, 0, 0, 0, 0]
)" + more +
         R"(
[[contact]]
finger = "thumb"
position_m = [-0.03, 0, 0]
normal = [1, 0, 0]
tangent = [0, 1, 0]
model = "point"
friction = 0.5
)";
}

const std::string kHeader = "t_s,thumb_fx_N,thumb_fy_N,thumb_fz_N\n";

/// Runs simulate on these texts and reads the trajectory.
struct Trajectory {
  Answer answer;
  std::vector<std::string> columns;
  std::vector<std::vector<double>> rows;
  bool exists = false;
  [[nodiscard]] double at(std::size_t row, const std::string& name) const {
    for (std::size_t c = 0; c < columns.size(); ++c)
      if (columns[c] == name) return rows.at(row).at(c);
    ADD_FAILURE() << "no column " << name;
    return 0.0;
  }
};

Trajectory simulate(const std::string& scene_text, const std::string& forces_text,
                    const std::string& options = "") {
  const test::TemporaryFolder folder;
  const std::string out = folder.path("trajectory.csv");
  Trajectory result;
  result.answer =
      run(folder, "simulate --scene " + folder.write("scene.toml", scene_text) + " --forces " +
                      folder.write("forces.csv", forces_text) + " --out " + out + " " + options);
  result.exists = std::filesystem::exists(out) || std::filesystem::exists(out + ".part");
  if (auto csv = CsvReader::open(out); csv.ok()) {
    result.columns = csv->columns();
    std::vector<double> row(result.columns.size());
    for (auto more = csv->next(row); more.ok() && *more; more = csv->next(row))
      result.rows.push_back(row);
  }
  return result;
}

TEST(Simulate, WritesTheColumnsAndOneRowMoreThanTheForces) {
  const auto t = simulate(scene(), kHeader + "0,0,0,1\n0.01,0,0,2\n0.02,0,0,0\n");
  ASSERT_EQ(t.answer.status, 0) << t.answer.err;
  EXPECT_EQ(t.answer.err, "");
  const std::vector<std::string> columns{"t_s",
                                         "x_m",
                                         "y_m",
                                         "z_m",
                                         "qw",
                                         "qx",
                                         "qy",
                                         "qz",
                                         "vx_mps",
                                         "vy_mps",
                                         "vz_mps",
                                         "wx_radps",
                                         "wy_radps",
                                         "wz_radps",
                                         "fx_N",
                                         "fy_N",
                                         "fz_N",
                                         "tx_Nm",
                                         "ty_Nm",
                                         "tz_Nm",
                                         "thumb_contact",
                                         "index_contact",
                                         "middle_contact"};
  EXPECT_EQ(t.columns, columns);
  ASSERT_EQ(t.rows.size(), 4u);
  // m = 1 kg, no spring, no damper: x = F t^2 / 2.
  EXPECT_EQ(t.at(0, "x_m"), 0.0);
  EXPECT_EQ(t.at(0, "fx_N"), 1.0);
  EXPECT_EQ(t.at(0, "thumb_contact"), 1.0);
  EXPECT_WITHIN(t.at(1, "vx_mps"), 0.01, 1e-17);
  EXPECT_WITHIN(t.at(1, "x_m"), 0.5e-4, 1e-19);
  EXPECT_WITHIN(t.at(2, "vx_mps"), 0.03, 1e-17);
  EXPECT_EQ(t.at(2, "thumb_contact"), 0.0);
  EXPECT_EQ(t.at(2, "fx_N"), 0.0);
  // The last row holds as long as the one before; the extra row repeats its wrench.
  EXPECT_WITHIN(t.at(3, "t_s"), 0.03, 1e-17);
  EXPECT_WITHIN(t.at(3, "vx_mps"), 0.03, 1e-17);
  EXPECT_EQ(t.at(3, "fx_N"), 0.0);
}

TEST(Simulate, AnIrregularGridHoldsEachRowForItsOwnTime) {
  const auto t = simulate(scene(), kHeader + "0,0,0,1\n0.01,0,0,1\n0.05,0,0,1\n");
  ASSERT_EQ(t.answer.status, 0) << t.answer.err;
  EXPECT_WITHIN(t.at(1, "vx_mps"), 0.01, 1e-17);
  EXPECT_WITHIN(t.at(2, "vx_mps"), 0.05, 1e-16);
  EXPECT_WITHIN(t.at(3, "vx_mps"), 0.09, 1e-16);
  EXPECT_WITHIN(t.at(3, "t_s"), 0.09, 1e-16);
}

TEST(Simulate, EveryRowOfALongRecordingComesOutOnceAndInOrder) {
  std::string forces = kHeader;
  constexpr std::size_t kRows = 3000;  // several blocks, and not a whole number of them
  for (std::size_t i = 0; i < kRows; ++i)
    forces += std::to_string(i) + ",0,0," + std::to_string(i % 7) + "\n";
  const auto t = simulate(scene(), forces);
  ASSERT_EQ(t.rows.size(), kRows + 1) << t.answer.err;
  for (std::size_t i = 0; i < kRows; ++i) {
    ASSERT_EQ(t.at(i, "t_s"), static_cast<double>(i));
    ASSERT_EQ(t.at(i, "fx_N"), static_cast<double>(i % 7));
  }
  EXPECT_EQ(t.at(kRows, "t_s"), static_cast<double>(kRows));
}

/// Largest memory that the program held while it simulated `rows` rows [KiB].
long peak_memory_KiB(std::size_t rows) {
  const test::TemporaryFolder folder;
  // Written as it is made: what this process holds is the least that the system reports.
  std::ofstream(folder.path("forces.csv")) << kHeader;
  std::ofstream forces(folder.path("forces.csv"), std::ios::app);
  for (std::size_t i = 0; i < rows; ++i) forces << i << ",0.125,0.25,1.5\n";
  forces.close();
  std::vector<std::string> words{ISOGRASP_EXECUTABLE,
                                 "simulate",
                                 "--scene",
                                 folder.write("scene.toml", scene()),
                                 "--forces",
                                 folder.path("forces.csv"),
                                 "--out",
                                 folder.path("trajectory.csv")};
  std::vector<char*> arguments;
  for (auto& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  pid_t child = 0;
  int status = -1;
  rusage used{};
  EXPECT_EQ(posix_spawn(&child, ISOGRASP_EXECUTABLE, nullptr, nullptr, arguments.data(), environ),
            0);
  EXPECT_EQ(wait4(child, &status, 0, &used), child);
  EXPECT_EQ(status, 0);
  return used.ru_maxrss;
}

TEST(Simulate, MemoryDoesNotGrowWithTheRecording) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "sanitizers keep what is freed";
#endif
  // 150 000 rows of 20 numbers would be 24 MB, their text more.
  constexpr long kSlack_KiB = 4096;  // pages of the libraries that one run touches and one does not
  EXPECT_LE(peak_memory_KiB(150000), peak_memory_KiB(3000) + kSlack_KiB);
}

TEST(Simulate, AGridThatIsRegularButForRoundingHasOneHold) {
  // 0.1 + 0.2 differs from 0.3 by an ulp: every hold is t_1 - t_0 all the same.
  std::string forces = kHeader;
  for (int i = 0; i < 40; ++i) forces += format_number(0.1 * i) + ",0,0,1\n";
  const auto t = simulate(scene(), forces);
  ASSERT_EQ(t.rows.size(), 41u) << t.answer.err;
  double v = 0.0;
  for (std::size_t i = 0; i < 41; ++i) {
    EXPECT_EQ(t.at(i, "vx_mps"), v);
    v += 0.1;
  }
}

TEST(Simulate, MissingSamplesAreBridgedFor50MsThenTheStateStandsStill) {
  std::string forces = kHeader + "0,0,0,1\n";
  for (int i = 1; i <= 8; ++i) forces += format_number(0.01 * i) + ",,,\n";
  forces += "0.09,0,0,1\n0.1,0,0,1\n";
  const auto t = simulate(scene(), forces);
  ASSERT_EQ(t.answer.status, 0) << t.answer.err;
  ASSERT_EQ(t.rows.size(), 12u);
  // One valid and five bridged holds accelerate; rows 6 to 9 show the same state.
  EXPECT_WITHIN(t.at(6, "vx_mps"), 0.06, 1e-15);
  for (const auto& column : test::every(t.columns)) {
    if (column == "t_s") continue;
    EXPECT_EQ(t.at(9, column), t.at(6, column)) << column;
  }
  EXPECT_WITHIN(t.at(11, "vx_mps"), 0.08, 1e-15);
  EXPECT_NE(t.answer.err.find("stood still in 3 of 11 holds"), std::string::npos) << t.answer.err;
}

TEST(Simulate, TheLeftHandsThumbPressesTheOtherWay) {
  const std::string forces = kHeader + "0,0,0,1\n0.01,0,0,1\n";
  EXPECT_EQ(simulate(scene(), forces).at(0, "fx_N"), 1.0);
  EXPECT_EQ(simulate(scene(), forces, "--hand left").at(0, "fx_N"), -1.0);
}

TEST(Simulate, ComparesBitForBitWithItself) {
  const std::string forces = kHeader + "0,0.1,0.2,1\n0.01,0,0.3,1\n0.02,0,0,2\n";
  const std::string free = "\"x\", \"y\", \"rx\", \"ry\", \"rz\"";
  EXPECT_EQ(simulate(scene("", free), forces).rows, simulate(scene("", free), forces).rows);
}

TEST(Simulate, SaysTheSameAsHdf5AsInText) {
  const test::TemporaryFolder folder;
  const std::string given =
      folder.write("scene.toml", scene("", "\"x\", \"y\", \"rx\", \"ry\", \"rz\""));
  std::string forces = kHeader;
  for (int k = 0; k < 5000; ++k) {  // more than a block, and a sample that is missing
    const std::string t_s = format_number(0.01 * k);
    forces += t_s + (k == 4200 ? ",,,\n" : ",0.1," + format_number(0.001 * (k % 300)) + ",1\n");
  }
  const auto simulated = [&](const std::string& from, const std::string& to) {
    const auto answer = run(
        folder, "simulate --scene " + given + " --forces " + from + " --out " + folder.path(to));
    EXPECT_EQ(answer.status, 0) << answer.err;
    std::stringstream all;
    all << std::ifstream(folder.path(to), std::ios::binary).rdbuf();
    return all.str();
  };
  const std::string text = simulated(folder.write("forces.csv", forces), "text.csv");
  const std::string make =
      "import h5py, numpy\n"
      "t = numpy.genfromtxt('" +
      folder.path("forces.csv") +
      "', delimiter=',', names=True)\n"
      "with h5py.File('" +
      folder.path("forces.h5") +
      "', 'w') as f:\n"
      "    d = f.create_dataset('signals/forces', data=numpy.column_stack([t[n] for n in "
      "t.dtype.names]))\n"
      "    d.attrs['columns'] = list(t.dtype.names)\n";
  ASSERT_EQ(std::system(("/usr/bin/python3 " + folder.write("make.py", make)).c_str()), 0)
      << "install what is missing: scripts/setup --test";
  EXPECT_EQ(simulated(folder.path("forces.h5"), "of_hdf5.csv"), text);
  EXPECT_EQ(simulated(folder.path("forces.h5") + ":/signals/forces", "of_a_place.csv"), text);
  const std::string columns = simulated(folder.path("forces.h5"), "a.h5");
  EXPECT_EQ(simulated(folder.path("forces.csv"), "b.h5"), columns);
  const auto refused = run(folder, "simulate --scene " + given + " --forces " +
                                       folder.path("a.h5") + " --out " + folder.path("c.h5"));
  EXPECT_EQ(refused.status, 2);
  EXPECT_NE(refused.err.find("a.h5: thumb_fx_N: the column is missing"), std::string::npos)
      << refused.err;
  EXPECT_FALSE(std::filesystem::exists(folder.path("c.h5")));
}

struct Bad {
  std::string scene;
  std::string forces;
  std::string place;  ///< must stand in the message
};

TEST(Simulate, BadInputIsOneLineThatNamesThePlaceAndLeavesNoFile) {
  const std::string good = kHeader + "0,0,0,1\n0.01,0,0,1\n";
  const std::vector<Bad> cases{
      {scene(), "t_s,thumb_fx_N,thumb_fy_N\n0,0,0\n1,0,0\n", "forces.csv:1: thumb_fz_N: "},
      {scene(), "thumb_fx_N,thumb_fy_N,thumb_fz_N\n0,0,0\n0,0,0\n", "forces.csv:1: t_s: "},
      {scene(), "t_s,index_fx_N,index_fy_N,index_fz_N\n0,0,0,0\n1,0,0,0\n",
       "forces.csv:1: thumb_fx_N: "},
      {scene(), kHeader + "0,0,0,1\n0.01,nan,0,1\n", "forces.csv:3: thumb_fx_N: "},
      {scene(), kHeader + "0,0,0,1\n0.01,0,inf,1\n", "forces.csv:3: thumb_fy_N: "},
      {scene(), kHeader + "0,0,0,1\n0.01,0,0,1.2x\n", "forces.csv:3: thumb_fz_N: "},
      {scene(), kHeader + "0,0,0,1\n0.01,0,0,1\n0.005,0,0,1\n", "forces.csv:4: t_s: "},
      {scene(), kHeader + "0,0,0,1\n0,0,0,1\n", "forces.csv:3: t_s: "},
      {scene(), kHeader + "0,0,0,1\n0.01,0,0\n", "forces.csv:3: thumb_fz_N: "},
      {scene(), kHeader + "0,0,0,1\n0.01,0,,1\n", "forces.csv:3: thumb_fy_N: "},
      {scene(), kHeader + "0,0,0,1\n", "forces.csv:2: "},
      {scene(), "", "forces.csv: "},
      {scene("colour = 1\n"), good, "scene.toml:10: dynamics.colour: "},
      {scene("gravity_m_s2 = [0, nan, 0]\n"), good, "scene.toml:10: dynamics.gravity_m_s2: "},
      {scene("[initial]\nvelocity_m_s = [0, 1, 0]\n"), good,
       "scene.toml:11: initial.velocity_m_s: "},
      {scene("", "\"rx\", \"ry\""), good, "scene.toml: dynamics.free: "},
      {"format = \"isograsp-scene-1\"\nname = 3 4\n", good, "scene.toml:2: "},
      {"format = \"isograsp-task-1\"\n", good, "scene.toml:1: format: "},
  };
  for (const auto& bad : cases) {
    const auto t = simulate(bad.scene, bad.forces);
    EXPECT_EQ(t.answer.status, 2) << bad.place;
    EXPECT_TRUE(t.answer.err.starts_with("isograsp: error: ")) << t.answer.err;
    EXPECT_NE(t.answer.err.find(bad.place), std::string::npos) << bad.place << '\n' << t.answer.err;
    EXPECT_NE(t.answer.err.find("; "), std::string::npos) << t.answer.err;  // the remedy
    EXPECT_EQ(std::count(t.answer.err.begin(), t.answer.err.end(), '\n'), 1) << t.answer.err;
    EXPECT_FALSE(t.exists) << bad.place;
  }
}

TEST(Simulate, FilesThatAreNotThereAreNamed) {
  const test::TemporaryFolder folder;
  const auto s = folder.write("scene.toml", scene());
  const auto f = folder.write("forces.csv", kHeader + "0,0,0,1\n0.01,0,0,1\n");
  const auto absent =
      run(folder, "simulate --scene " + s + " --forces /nowhere.csv --out " + folder.path("o"));
  EXPECT_EQ(absent.status, 2);
  EXPECT_NE(absent.err.find("/nowhere.csv: "), std::string::npos) << absent.err;
  const auto unwritable =
      run(folder, "simulate --scene " + s + " --forces " + f + " --out /nowhere/o.csv");
  EXPECT_NE(unwritable.status, 0);
  EXPECT_NE(unwritable.err.find("/nowhere/o.csv: "), std::string::npos) << unwritable.err;
  EXPECT_EQ(run(folder, "simulate --scene " + s).status, 2);
  EXPECT_EQ(run(folder, "simulate --scene " + s + " --forces " + f + " --out x --hand both").status,
            2);
  EXPECT_NE(run(folder, "simulate --help").out.find("Example"), std::string::npos);
}

TEST(GraspCommand, PrintsOneDocumentWithTheAgreedFields) {
  const test::TemporaryFolder folder;
  const std::string path = std::string(ISOGRASP_SOURCE_DIR) + "/library/scenes/planar_block.toml";
  const auto answer = run(folder, "grasp --scene " + path + " --length-scale 0.03 --json");
  ASSERT_EQ(answer.status, 0) << answer.err;
  const auto document = nlohmann::json::parse(answer.out);
  EXPECT_EQ(document["scene"], "planar block");
  EXPECT_EQ(document["rows"], (std::vector<std::string>{"Fx", "Fy", "Tz"}));
  EXPECT_EQ(document["columns"].size(), 9u);
  EXPECT_EQ(document["columns"][0], "thumb_fx");
  ASSERT_EQ(document["G"].size(), 6u);
  EXPECT_EQ(document["G"][5][0], -0.0325);
  EXPECT_EQ(document["length_scale_m"], 0.03);
  EXPECT_EQ(document["torsion_scale_m"], 1.0);
  ASSERT_EQ(document["subsets"].size(), 7u);
  const auto& all = document["subsets"][6];
  EXPECT_EQ(all["fingers"], (std::vector<std::string>{"thumb", "index", "middle"}));
  EXPECT_EQ(all["rank"], 3);
  // golden/grasp_results.csv: device_block_3, PCWF, FxFyTz
  EXPECT_WITHIN(all["singular_values"][0].get<double>(), 2.1450108564519962613, 1e-14);
  EXPECT_WITHIN(all["G_det"].get<double>(), 5.5938954822794706247, 1e-13);
  EXPECT_WITHIN(all["G_rat"].get<double>(), 7.019314979915723726e-1, 1e-14);
  EXPECT_EQ(all["G_min"], all["singular_values"][2]);
  EXPECT_EQ(all["force_closure"], true);
  EXPECT_EQ(all["opposition"], true);
  EXPECT_GT(document["plan"]["cost_ns_per_frame"].get<double>(), 0.0);
}

TEST(GraspCommand, ShowsATableAndRefusesBadScales) {
  const test::TemporaryFolder folder;
  const std::string path = std::string(ISOGRASP_SOURCE_DIR) + "/library/scenes/free_block.toml";
  const auto table = run(folder, "grasp --scene " + path);
  EXPECT_EQ(table.status, 0);
  EXPECT_NE(table.out.find("Dormand-Prince"), std::string::npos);
  EXPECT_NE(table.out.find("ns per frame"), std::string::npos);
  const auto bad = run(folder, "grasp --scene " + path + " --length-scale -1");
  EXPECT_EQ(bad.status, 2);
  EXPECT_NE(bad.err.find("--length-scale"), std::string::npos) << bad.err;
}

}  // namespace
}  // namespace isograsp::app::simulate_test
