// SPDX-License-Identifier: GPL-3.0-or-later
// Wavefront OBJ in, a connected surface out.
#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <unordered_map>
#include <utility>

#include "core/csv.hpp"
#include "grasp_model/patch/mesh_surface.hpp"

namespace isograsp {

namespace {

constexpr std::size_t kMostVertices = 2'000'000;

/// The words of a line, by blanks and tabs; what follows '#' is a comment.
class LineWords {
 public:
  explicit LineWords(std::string_view line) : rest_(line.substr(0, line.find('#'))) {}
  /// Empty: there is none any more.
  std::string_view next() noexcept {
    const std::size_t begin = std::min(rest_.find_first_not_of(kBlanks), rest_.size());
    const std::size_t end = std::min(rest_.find_first_of(kBlanks, begin), rest_.size());
    const std::string_view word = rest_.substr(begin, end - begin);
    rest_.remove_prefix(end);
    return word;
  }

 private:
  static constexpr const char* kBlanks = " \t\r";
  std::string_view rest_;
};

/// Places of vertices, each once.
class Places {
 public:
  std::uint32_t number_of(const Vec3& p) {
    const Key key{p.x(), p.y(), p.z()};
    const auto [at, is_new] = known_.try_emplace(key, static_cast<std::uint32_t>(all_.size()));
    if (is_new) all_.push_back(p);
    return at->second;
  }
  std::vector<Vec3> take() { return std::move(all_); }
  [[nodiscard]] const Vec3& at(std::uint32_t number) const { return all_[number]; }

 private:
  using Key = std::tuple<double, double, double>;
  std::map<Key, std::uint32_t> known_;
  std::vector<Vec3> all_;
};

Error bad_line(const std::string& file, int line, Text what, Text remedy) {
  return refused(std::move(what), std::move(remedy)).at(file, line);
}

}  // namespace

Result<MeshSurface> MeshSurface::parse(std::string_view obj, const std::string& file) {
  Places places;
  std::vector<std::uint32_t> numbers;  // of the vertices in the file
  std::vector<Triangle> triangles;
  std::vector<int> lines;
  int line = 0;
  for (std::size_t begin = 0; begin < obj.size();) {
    const std::size_t end = std::min(obj.find('\n', begin), obj.size());
    LineWords words(obj.substr(begin, end - begin));
    begin = end + 1;
    ++line;
    const std::string_view what = words.next();
    if (what == "v") {
      Vec3 p;
      for (double& place_m : p)
        if (!parse_number(words.next(), place_m) || !std::isfinite(place_m))
          return bad_line(file, line, "a vertex needs three numbers"_text, "correct the line"_text);
      if (numbers.size() == kMostVertices)
        return bad_line(file, line, "there are more than %1 vertices"_text(kMostVertices),
                        "use a coarser mesh"_text);
      numbers.push_back(places.number_of(p));
    } else if (what == "f") {
      std::vector<std::uint32_t> corners;
      for (std::string_view word = words.next(); !word.empty(); word = words.next()) {
        double number = 0.0;
        const auto count = static_cast<double>(numbers.size());
        const bool is_number = parse_number(word.substr(0, word.find('/')), number);
        if (is_number && number < 0.0) number += count + 1.0;
        if (!is_number || number != std::floor(number) || !(number >= 1.0 && number <= count))
          return bad_line(file, line,
                          "'%1' is no vertex of the lines before"_text(std::string(word)),
                          "write numbers from 1 on"_text);
        corners.push_back(numbers[static_cast<std::size_t>(number) - 1]);
      }
      if (corners.size() < 3)
        return bad_line(file, line, "a face needs three vertices"_text, "correct the line"_text);
      for (std::size_t k = 2; k < corners.size(); ++k) {
        Triangle triangle{{corners[0], corners[k - 1], corners[k]}, {kNone, kNone, kNone}, {}};
        const Vec3& a = places.at(triangle.vertices[0]);
        const Vec3 outward =
            (places.at(triangle.vertices[1]) - a).cross(places.at(triangle.vertices[2]) - a);
        const auto& of = triangle.vertices;
        if (of[0] == of[1] || of[1] == of[2] || of[2] == of[0]) continue;  // its sides are one edge
        if (!(outward.norm() > 0.0))
          return bad_line(file, line, "a face has no area"_text, "leave it out of the mesh"_text);
        triangle.inward = -outward.normalized();
        triangles.push_back(triangle);
        lines.push_back(line);
        if (triangles.size() > kMostTriangles)
          return bad_line(file, line, "there are more than %1 triangles"_text(kMostTriangles),
                          "use a coarser mesh"_text);
      }
    }
  }
  if (triangles.empty())
    return refused("has no triangle"_text, "give a Wavefront OBJ file with lines v and f"_text)
        .at(file);
  return connect(places.take(), std::move(triangles), lines, file);
}

Result<MeshSurface> MeshSurface::connect(std::vector<Vec3> vertices,
                                         std::vector<Triangle> triangles,
                                         const std::vector<int>& lines, const std::string& file) {
  // An edge runs once in either direction, if at all.
  std::unordered_map<std::uint64_t, std::pair<std::uint32_t, std::uint32_t>> edges;
  const auto key = [](std::uint32_t from, std::uint32_t to) {
    return static_cast<std::uint64_t>(from) << 32 | to;
  };
  for (std::uint32_t t = 0; t < triangles.size(); ++t)
    for (std::uint32_t edge = 0; edge < 3; ++edge) {
      const auto& of = triangles[t].vertices;
      if (!edges.try_emplace(key(of[edge], of[(edge + 1) % 3]), t, edge).second)
        return bad_line(file, lines[t], "runs along an edge the same way as another face"_text,
                        "turn the face round, or leave out what is there twice"_text);
    }
  for (Triangle& triangle : triangles)
    for (std::size_t edge = 0; edge < 3; ++edge) {
      const auto beyond =
          edges.find(key(triangle.vertices[(edge + 1) % 3], triangle.vertices[edge]));
      if (beyond != edges.end()) triangle.beside[edge] = beyond->second.first;
    }
  MeshSurface mesh;
  mesh.vertices_ = std::move(vertices);
  mesh.triangles_ = std::move(triangles);
  return mesh;
}

}  // namespace isograsp
