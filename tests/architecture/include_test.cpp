// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the sources: who may include whom, and which headers stay out of headers
// (docs/rooms.txt).
#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/architecture/house.hpp"
#include "tests/support/every.hpp"

namespace isograsp::include_test {
namespace {

namespace fs = std::filesystem;
using namespace architecture;

// Libraries by the beginning of the include path.
const std::map<std::string, std::string> kLibraryOf{{"Eigen/", "Eigen"},
                                                    {"boost/lockfree/", "Boost.Lockfree"},
                                                    {"boost/asio", "Boost.Asio"},
                                                    {"boost/beast", "Boost.Beast"},
                                                    {"boost/math/", "Boost.Math"},
                                                    {"boost/uuid/", "Boost.UUID"},
                                                    {"boost/property_tree", "Boost.PropertyTree"},
                                                    {"toml++/", "toml++"},
                                                    {"comedilib", "comedi"},
                                                    {"glpk", "GLPK"},
                                                    {"libqhull", "Qhull"},
                                                    {"CLI/", "CLI11"},
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

/// A class of Qt's windows: its header stands in the folder QtWidgets.
bool is_widget(const std::string& included) {
  return fs::exists(fs::path(ISOGRASP_QT_HEADERS) / "QtWidgets" / included) ||
         included.starts_with("QtWidgets");
}

struct Include {
  std::string folder;
  std::string file;  ///< from the root of the project
  bool header = false;
  bool for_its_room = false;  ///< a header that says so
  int line = 0;
  std::string included;
  bool quoted = false;
};

/// Empty if the include is allowed, else why not.
std::string objection(const House& house, const Include& what) {
  const Folder& folder = house.folder(what.folder);
  const std::size_t room = folder.room_of(what.file);
  const std::string& here = folder.rooms[room].path;
  if (what.quoted) {
    if (what.included.find('/') == std::string::npos)
      return "write the path from the root of the project";
    const std::string from = what.included.substr(0, what.included.find('/'));
    if (folder.rooms[room].without.contains(from)) return here + " knows nothing of " + from;
    if (from != what.folder)
      return folder.uses.contains(from) ? "" : what.folder + " may not include " + from;
    const std::size_t there = folder.room_of(what.included);
    return there <= room ? "" : folder.rooms[there].path + " stands above " + here;
  }
  if (folder.rooms[room].without.contains("widgets") && is_widget(what.included))
    return here + " has no widgets";
  for (const auto& [prefix, library] : kLibraryOf) {
    if (what.included.rfind(prefix, 0) != 0) continue;
    if (library == "Qt" && folder.rooms[room].without.contains("Qt")) return here + " knows no Qt";
    if (folder.libraries.contains(library)) return "";
    if (folder.source_libraries.contains(library))
      return what.header && !what.for_its_room
                 ? library + " belongs into .cpp files of " + what.folder
                 : "";
    return what.folder + " may not use " + library;
  }
  return "";
}

/// A compiler reads it for long: in a header, every file that includes the header would pay for it.
bool is_heavy(const std::string& included) {
  static const std::regex kHeavy(
      R"re(CLI/.*|soci/soci\.h|nlohmann/json\.hpp|toml\+\+/.*|boost/(asio|beast).*|regex|Eigen/Dense|)re"
      R"re((QtWidgets/)?QtWidgets)re");
  return std::regex_match(included, kHeavy);
}

/// "Inside storage/sqlite/ only", from the head of a header; empty: it does not say so.
std::string only_inside(const Source& source) {
  static const std::regex kOnly(R"re(Inside ([a-z_/]+/) only)re");
  std::string head;
  for (const std::string& line : source.lines) {
    if (!line.starts_with("//")) break;
    head += line.substr(2);
  }
  std::smatch match;
  return source.is_header() && std::regex_search(head, match, kOnly) ? match[1].str() : "";
}

std::vector<Include> all_includes() {
  const std::regex include(R"re(^\s*#\s*include\s*([<"])([^>"]+)[>"])re");
  std::vector<Include> found;
  for (const Source& source : all_sources()) {
    const bool for_its_room = !only_inside(source).empty();
    int number = 0;
    for (const std::string& line : source.lines) {
      ++number;
      std::smatch match;
      if (std::regex_search(line, match, include))
        found.push_back({source.folder, source.file, source.is_header(), for_its_room, number,
                         match[2], match[1] == "\""});
    }
  }
  return found;
}

TEST(Includes, EveryRoomIncludesOnlyWhatTheMapAllows) {
  for (const Include& include : test::every(all_includes())) {
    const std::string why = objection(House::ours(), include);
    if (!why.empty()) ADD_FAILURE() << include.file << ":" << include.line << ": " << why;
  }
}

TEST(Includes, AHeaderThatIsForOnePlaceOnlyIsReadThereOnly) {
  std::map<std::string, std::string> only;  // header: where
  for (const Source& source : all_sources())
    if (const auto place = only_inside(source); !place.empty()) only[source.file] = place;
  EXPECT_GT(only.size(), 10U) << "no header says so: is this rule still of use?";
  for (const auto& [header, place] : test::every(only))
    EXPECT_TRUE(fs::is_directory(fs::path(ISOGRASP_SOURCE_DIR) / place)) << header << ": " << place;
  for (const Include& include : all_includes())
    if (const auto at = only.find(include.included);
        at != only.end() && !include.file.starts_with(at->second))
      ADD_FAILURE() << include.file << ":" << include.line << ": " << include.included << " is for "
                    << at->second << " only";
}

/// Headers that are for one place and that one .cpp alone reads: a template beside its use.
std::set<std::string> read_by_one_source() {
  std::map<std::string, int> readers;
  constexpr int kMany = 2;
  for (const Include& include : all_includes())
    readers[include.included] += include.header ? kMany : 1;
  std::set<std::string> found;
  for (const Include& include : all_includes())
    if (include.for_its_room && readers[include.file] == 1) found.insert(include.file);
  return found;
}

TEST(Includes, NoHeaderPassesAHeavyOneOn) {
  const auto alone = read_by_one_source();
  for (const Include& include : test::every(all_includes()))
    if (include.header && is_heavy(include.included) && !alone.contains(include.file))
      ADD_FAILURE() << include.file << ":" << include.line << ": <" << include.included
                    << "> is heavy: include it in .cpp files, declare here what is needed of it";
}

TEST(Includes, OneFileAloneReadsTheLibraryOfTheCommandLine) {
  constexpr const char* kAlone = "app/command_line.cpp";
  bool read = false;
  for (const Include& include : all_includes()) {
    if (!include.included.starts_with("CLI/")) continue;
    if (include.file == kAlone)
      read = true;
    else
      ADD_FAILURE() << include.file << ":" << include.line << ": <" << include.included
                    << "> belongs into " << kAlone << ": use app/command_line.hpp";
  }
  EXPECT_TRUE(read) << kAlone << " does not include it: is this rule still of use?";
}

/// All headers that `file` reads, itself too.
Names reached_from(const std::string& file) {
  std::multimap<std::string, std::string> reads;
  for (const Include& include : all_includes())
    if (include.quoted) reads.emplace(include.file, include.included);
  Names reached;
  std::vector<std::string> open{file};
  while (!open.empty()) {
    const std::string next = std::move(open.back());
    open.pop_back();
    if (!reached.insert(next).second) continue;
    const auto [first, last] = reads.equal_range(next);
    for (auto at = first; at != last; ++at) open.push_back(at->second);
  }
  return reached;
}

TEST(Includes, ThePatientsPictureIsDrawnFromTheStimulusThatASimulatedPersonGets) {
  for (const char* file : {"gui/picture/patient_picture.hpp", "gui/picture/patient_picture.cpp"}) {
    const Names reached = reached_from(file);
    EXPECT_TRUE(reached.contains("hand/stimulus.hpp")) << file;
    for (const std::string& header : reached)
      EXPECT_FALSE(header.starts_with("session/platform/")) << file << " reads " << header;
  }
  // Headers of tasks say what a task is; how the running one stands, the stimulus says.
  const std::regex kState(R"(\b(Moment|Snapshot|TaskProgress|TaskView|ForceView|ObjectView)\b)");
  int read = 0;
  for (const Source& source : all_sources())
    if (source.file.starts_with("gui/picture/patient_picture.")) {
      ++read;
      EXPECT_FALSE(std::regex_search(code_of(source.text()), kState)) << source.file;
    }
  EXPECT_EQ(read, 2);
}

TEST(Includes, TheRulesForbidWhatTheyShould) {
  const House house(
      "# a comment\n"
      "core: words\n"
      "  library: Eigen\n\n"
      "gui: windows\n"
      "  uses: core\n"
      "  library: Qt\n"
      "  source library: nlohmann\n"
      "  room words: texts; no widgets\n"
      "  room facts: what is true; no Qt\n"
      "  room sums: numbers alone; no Qt core\n"
      "  room .: the windows\n");
  const auto says = [&](const char* file, const char* included, bool quoted,
                        bool for_its_room = false) {
    const std::string name = file;
    return objection(house, {name.substr(0, name.find('/')), name, name.ends_with(".hpp"),
                             for_its_room, 1, included, quoted});
  };
  EXPECT_NE(says("core/time.cpp", "gui/windows.hpp", true), "") << "a folder above";
  EXPECT_NE(says("gui/windows.cpp", "windows.hpp", true), "") << "not from the root";
  EXPECT_NE(says("gui/words/texts.cpp", "gui/facts/true.hpp", true), "") << "a room above";
  EXPECT_NE(says("gui/words/texts.cpp", "gui/windows.hpp", true), "") << "the files above";
  EXPECT_NE(says("core/time.cpp", "QObject", false), "") << "a library of others";
  EXPECT_NE(says("gui/facts/true.cpp", "QString", false), "") << "no Qt";
  EXPECT_NE(says("gui/sums/sum.cpp", "core/time.hpp", true), "") << "a room without a folder";
  EXPECT_NE(says("gui/sums/sum.cpp", "QString", false), "") << "and without Qt";
  EXPECT_NE(says("gui/words/texts.cpp", "QWidget", false), "") << "no widgets";
  EXPECT_NE(says("gui/words/texts.cpp", "QtWidgets/QLabel", false), "") << "no widgets";
  EXPECT_NE(says("gui/words/texts.hpp", "nlohmann/json.hpp", false), "") << "in sources only";
  EXPECT_EQ(says("gui/words/texts.hpp", "nlohmann/json.hpp", false, true), "");
  EXPECT_EQ(says("gui/words/texts.cpp", "nlohmann/json.hpp", false), "");
  EXPECT_EQ(says("gui/words/texts.cpp", "QString", false), "");
  EXPECT_EQ(says("gui/windows.cpp", "QWidget", false), "");
  EXPECT_EQ(says("gui/windows.cpp", "gui/words/texts.hpp", true), "");
  EXPECT_EQ(says("gui/facts/true.cpp", "core/time.hpp", true), "");
  EXPECT_EQ(says("core/time.hpp", "Eigen/Core", false), "");
  EXPECT_EQ(says("core/time.hpp", "vector", false), "");
}

TEST(Includes, OfTheMapAreFoldersAndRoomsThatAreThere) {
  Names below;
  for (const Folder& folder : test::every(House::ours().folders())) {
    for (const Room& room : test::every(folder.rooms))
      EXPECT_TRUE(fs::is_directory(fs::path(ISOGRASP_SOURCE_DIR) / room.path)) << room.path;
    for (const std::string& used : folder.uses)
      EXPECT_TRUE(below.contains(used))
          << folder.name << " uses " << used << ", which is not below";
    below.insert(folder.name);
  }
}

TEST(Includes, HeavyAndLightHeadersAreToldApart) {
  for (const char* heavy : {"CLI/CLI.hpp", "soci/soci.h", "nlohmann/json.hpp", "toml++/toml.h",
                            "boost/asio.hpp", "boost/asio/io_context.hpp", "boost/beast/http.hpp",
                            "regex", "Eigen/Dense", "QtWidgets", "QtWidgets/QtWidgets"})
    EXPECT_TRUE(is_heavy(heavy)) << heavy;
  for (const char* light : {"nlohmann/json_fwd.hpp", "Eigen/Core", "QWidget", "QtWidgets/QWidget",
                            "regex.h", "core/csv.hpp"})
    EXPECT_FALSE(is_heavy(light)) << light;
}

TEST(Sources, EveryFileNamesItsLicence) {
  for (const Source& source : test::every(all_sources())) {
    ASSERT_FALSE(source.lines.empty()) << source.file;
    EXPECT_EQ(source.lines[0], "// SPDX-License-Identifier: GPL-3.0-or-later") << source.file;
  }
}

TEST(Sources, NoFolderHoldsMoreThanFortyFiles) {
  constexpr int kMost = 40;  // more is a hall, no room
  std::map<std::string, int> files;
  for (const Source& source : all_sources()) ++files[fs::path(source.file).parent_path()];
  for (const auto& [folder, count] : test::every(files)) EXPECT_LE(count, kMost) << folder;
}

}  // namespace
}  // namespace isograsp::include_test
