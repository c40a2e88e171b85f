// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the sources: who may include whom (docs/architecture.md).
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>

#include <gtest/gtest.h>

namespace isograsp {
namespace {

namespace fs = std::filesystem;
using Names = std::set<std::string>;

struct Rule {
  Names folders;           ///< own folder is always allowed
  Names libraries;         ///< in headers and sources
  Names source_libraries;  ///< in .cpp only
};

// Libraries by the beginning of the include path.
const std::map<std::string, std::string> kLibraryOf{{"Eigen/", "Eigen"},
                                                    {"boost/lockfree/", "Boost.Lockfree"},
                                                    {"boost/asio", "Boost.Asio"},
                                                    {"boost/beast", "Boost.Beast"},
                                                    {"boost/math/", "Boost.Math"},
                                                    {"boost/property_tree", "Boost.PropertyTree"},
                                                    {"toml++/", "toml++"},
                                                    {"comedilib", "comedi"},
                                                    {"glpk", "GLPK"},
                                                    {"libqhull", "Qhull"},
                                                    {"CLI/", "CLI11"},
                                                    {"spdlog/", "spdlog"},
                                                    {"nlohmann/", "nlohmann"},
                                                    {"soci", "SOCI"},
                                                    {"zstd", "zstd"},
                                                    {"sodium", "libsodium"},
                                                    {"sqlite3", "SQLite"},
                                                    {"linux/can", "SocketCAN"},
                                                    {"hdf5", "HDF5"},
                                                    {"Q", "Qt"},
                                                    {"qcustomplot", "QCustomPlot"},
                                                    {"Inventor/", "Coin"},
                                                    {"GL/", "OpenGL"}};

const Names kAll{"core",    "device",  "grasp_model", "virtual_patient", "tasks", "storage",
                 "session", "reports", "gui"};
const Names kEigen{"Eigen"};
const std::map<std::string, Rule> kRules{
    {"core", {{}, {"Eigen", "Boost.Lockfree"}, {"toml++"}}},
    {"device",
     {{"core"}, kEigen, {"Boost.Asio", "Boost.Beast", "Boost.PropertyTree", "SocketCAN", "comedi"}}},
    {"grasp_model", {{"core"}, kEigen, {"GLPK", "Qhull"}}},
    {"virtual_patient", {{"core", "grasp_model"}, kEigen, {}}},
    {"tasks", {{"core", "grasp_model"}, kEigen, {"Boost.Math"}}},
    {"storage", {{"core"}, kEigen, {"SOCI", "zstd", "SQLite", "libsodium"}}},
    {"session",
     {{"core", "device", "grasp_model", "virtual_patient", "tasks", "storage"}, kEigen, {}}},
    {"reports", {{"core", "tasks", "storage"}, {"Eigen", "Qt", "QCustomPlot"}, {"Boost.Math", "nlohmann", "HDF5"}}},
    {"gui", {kAll, {"Eigen", "Qt", "QCustomPlot", "Coin", "OpenGL"}, {}}},
    {"app", {kAll, {"Eigen", "Qt", "CLI11", "spdlog", "nlohmann"}, {}}}};

/// Empty if the include is allowed, else why not.
std::string objection(const std::string& folder, const Rule& rule, const std::string& included,
                      bool quoted, bool header) {
  if (quoted) {
    const std::string from = included.substr(0, included.find('/'));
    if (included.find('/') == std::string::npos)
      return "write the path from the root of the project";
    if (from == folder || rule.folders.contains(from)) return "";
    return folder + " may not include " + from;
  }
  for (const auto& [prefix, library] : kLibraryOf) {
    if (included.rfind(prefix, 0) != 0) continue;
    if (rule.libraries.contains(library)) return "";
    if (rule.source_libraries.contains(library))
      return header ? library + " belongs into .cpp files of " + folder : "";
    return folder + " may not use " + library;
  }
  return "";
}

TEST(Includes, EveryFolderIncludesOnlyWhatTheMapAllows) {
  const std::regex include(R"re(^\s*#\s*include\s*([<"])([^>"]+)[>"])re");
  std::size_t lines_seen = 0;
  for (const auto& [folder, rule] : kRules) {
    for (const auto& entry :
         fs::recursive_directory_iterator(fs::path(ISOGRASP_SOURCE_DIR) / folder)) {
      const std::string extension = entry.path().extension();
      if (extension != ".hpp" && extension != ".cpp") continue;
      std::ifstream in(entry.path());
      std::string line;
      for (int number = 1; std::getline(in, line); ++number) {
        std::smatch match;
        if (!std::regex_search(line, match, include)) continue;
        ++lines_seen;
        const std::string why =
            objection(folder, rule, match[2], match[1] == "\"", extension == ".hpp");
        if (!why.empty()) ADD_FAILURE() << entry.path().string() << ":" << number << ": " << why;
      }
    }
  }
  EXPECT_GT(lines_seen, 200u) << "the sources were not found";
}

TEST(Includes, TheRulesForbidWhatTheyShould) {
  EXPECT_NE(objection("core", kRules.at("core"), "device/uri.hpp", true, true), "");
  EXPECT_NE(objection("grasp_model", kRules.at("grasp_model"), "toml++/toml.h", false, false), "");
  EXPECT_NE(objection("grasp_model", kRules.at("grasp_model"), "glpk.h", false, true), "");
  EXPECT_NE(objection("device", kRules.at("device"), "boost/asio.hpp", false, true), "");
  EXPECT_EQ(objection("device", kRules.at("device"), "boost/asio.hpp", false, false), "");
  EXPECT_NE(objection("device", kRules.at("device"), "comedilib.h", false, true), "");
  EXPECT_NE(objection("session", kRules.at("session"), "comedilib.h", false, false), "");
  EXPECT_NE(objection("session", kRules.at("session"), "QObject", false, false), "");
  EXPECT_NE(objection("storage", kRules.at("storage"), "tasks/score.hpp", true, false), "");
}

TEST(Sources, EveryFileNamesItsLicence) {
  for (const auto& [folder, rule] : kRules)
    for (const auto& entry :
         fs::recursive_directory_iterator(fs::path(ISOGRASP_SOURCE_DIR) / folder)) {
      const std::string extension = entry.path().extension();
      if (extension != ".hpp" && extension != ".cpp") continue;
      std::ifstream in(entry.path());
      std::string line;
      std::getline(in, line);
      EXPECT_EQ(line, "// SPDX-License-Identifier: GPL-3.0-or-later") << entry.path().string();
    }
}

}  // namespace
}  // namespace isograsp
