#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "pliant/base/errors.h"
#include "pliant/base/number_text.h"
#include "pliant/io/obj.h"
#include "pliant/io/text_file.h"

namespace pliant {
namespace {

/// More kinds of statement than any program writes: the file is something else.
constexpr std::size_t kMaxIgnoredStatements = 40;
constexpr std::string_view kBlanks = " \t\r";
constexpr std::string_view kUtf8Mark = "\xEF\xBB\xBF";

/// Takes the next word off the front of `text`; empty at its end.
std::string_view take_word(std::string_view& text) {
  text.remove_prefix(std::min(text.find_first_not_of(kBlanks), text.size()));
  const std::string_view word = text.substr(0, text.find_first_of(kBlanks));
  text.remove_prefix(word.size());
  return word;
}

/// The lines of a text without comments; lines that end in a backslash are joined to the next.
class LineReader {
 public:
  explicit LineReader(std::string_view text) : rest_(text) {
    if (rest_.starts_with(kUtf8Mark)) rest_.remove_prefix(kUtf8Mark.size());
  }

  bool next() {
    if (rest_.empty()) return false;
    line_number_ += lines_taken_;
    lines_taken_ = 0;
    line_ = take_line();
    if (!line_.ends_with('\\')) return true;
    joined_.clear();
    while (line_.ends_with('\\')) {
      joined_ += line_.substr(0, line_.size() - 1);
      joined_ += ' ';
      line_ = take_line();
    }
    joined_ += line_;
    line_ = joined_;
    return true;
  }

  std::string_view line() const { return line_; }
  /// Where the line begins, counted from 1.
  int number() const { return line_number_; }

 private:
  std::string_view take_line() {
    const std::size_t end = std::min(rest_.find('\n'), rest_.size());
    std::string_view line = rest_.substr(0, end);
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    ++lines_taken_;
    line = line.substr(0, line.find('#'));
    return line.substr(0, line.find_last_not_of(kBlanks) + 1);
  }

  std::string_view rest_;
  std::string_view line_;
  std::string joined_;
  int line_number_ = 1;
  int lines_taken_ = 0;
};

class ObjParser {
 public:
  ObjParser(std::string_view text, const std::string& file) : lines_(text), file_(file) {}

  ObjMesh parse() && {
    while (lines_.next()) {
      std::string_view rest = lines_.line();
      const std::string_view statement = take_word(rest);
      if (statement == "v") {
        add_position(rest);
      } else if (statement == "vt") {
        add_texture_point(rest);
      } else if (statement == "f") {
        add_face(rest);
      } else if (statement == "p") {
        add_points(rest);
      } else if (statement == "g") {
        begin_group(rest);
      } else if (!statement.empty()) {
        ignore(statement);
      }
    }
    if (mesh_.positions.empty()) {
      throw InputError({file_}, "there are no vertices", "an OBJ file, with lines \"v X Y Z\"");
    }
    check_corners();
    finish_groups();
    return std::move(mesh_);
  }

 private:
  static constexpr int kNone = -1;

  void add_position(std::string_view rest) {
    check_count(mesh_.positions.size());
    mesh_.positions.push_back({number(rest), number(rest), number(rest)});
    mesh_.vertex_lines.push_back(lines_.number());
    // A weight, a colour or both.
    for (int i = 0; i < 4 && !rest.empty(); ++i) number(rest);
    check_end(rest);
  }

  void add_texture_point(std::string_view rest) {
    check_count(mesh_.texture_points.size());
    // A texture along a line has one coordinate.
    const double u = number(rest);
    mesh_.texture_points.push_back({u, rest.empty() ? 0.0 : number(rest)});
    if (!rest.empty()) number(rest);
    check_end(rest);
  }

  void add_face(std::string_view rest) {
    const std::size_t begin = mesh_.faces.corners.size();
    while (!rest.empty()) add_corner(take_word(rest));
    const std::size_t count = mesh_.faces.corners.size() - begin;
    if (count < 3) fail(fmt::format("the face has {} corners", count), "three or more");
    check_count(mesh_.faces.corners.size());
    mesh_.faces.ends.push_back(mesh_.faces.corners.size());
    mesh_.face_lines.push_back(lines_.number());
    add_to_groups(mesh_.faces[mesh_.faces.size() - 1]);
  }

  void add_points(std::string_view rest) {
    std::vector<int> points;
    while (!rest.empty()) {
      const std::string_view word = take_word(rest);
      points.push_back(index(word, mesh_.positions.size(), word));
      if (points.back() < std::ssize(mesh_.positions)) continue;
      fail(fmt::format("there is no vertex {} yet", quoted_value(word)), "vertices given before");
    }
    add_to_groups(points);
  }

  /// What follows belongs to the groups that the line names; to none where it names none.
  void begin_group(std::string_view rest) {
    groups_.clear();
    while (!rest.empty()) groups_.push_back(&mesh_.groups[std::string(take_word(rest))]);
  }

  void add_to_groups(std::span<const int> vertices) {
    for (std::vector<int>* group : groups_) {
      group->insert(group->end(), vertices.begin(), vertices.end());
    }
  }

  void finish_groups() {
    for (auto& [name, vertices] : mesh_.groups) {
      std::sort(vertices.begin(), vertices.end());
      vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    }
  }

  void add_corner(std::string_view word) {
    std::array<std::string_view, 3> parts;
    std::size_t count = 0;
    for (std::string_view left = word; count < parts.size(); ++count) {
      const std::size_t slash = left.find('/');
      parts[count] = left.substr(0, slash);
      if (slash == std::string_view::npos) break;
      left.remove_prefix(slash + 1);
    }
    if (count == parts.size()) fail_corner(word);
    mesh_.faces.corners.push_back(index(parts[0], mesh_.positions.size(), word));
    mesh_.texture_corners.push_back(
        parts[1].empty() ? kNone : index(parts[1], mesh_.texture_points.size(), word));
    if (!parts[2].empty() && !parse_integer(parts[2])) fail_corner(word);
    has_texture_ = has_texture_ || !parts[1].empty();
  }

  /// A number counted from 1, or backwards from -1, as one counted from 0. Whether there is such a
  /// vertex is known at the end of the file.
  int index(std::string_view text, std::size_t count, std::string_view word) const {
    const std::optional<long> number = parse_integer(text);
    if (!number || *number == 0 || *number > std::numeric_limits<int>::max()) fail_corner(word);
    if (*number > 0) return static_cast<int>(*number - 1);
    const long from_end = static_cast<long>(count) + *number;
    if (from_end < 0) {
      fail(fmt::format("{} counts back beyond the first of {}", quoted_value(word), count),
           "a number that was given before");
    }
    return static_cast<int>(from_end);
  }

  void check_corners() {
    if (!has_texture_) mesh_.texture_corners.clear();
    std::size_t corner = 0;
    for (std::size_t face = 0; face < mesh_.faces.size(); ++face) {
      for (; corner < mesh_.faces.ends[face]; ++corner) {
        check_index(face, "vertex", mesh_.faces.corners[corner], mesh_.positions.size());
        if (!has_texture_) continue;
        check_index(face, "texture point", mesh_.texture_corners[corner],
                    mesh_.texture_points.size());
      }
    }
  }

  void check_index(std::size_t face, const char* what, int index, std::size_t count) const {
    if (index < static_cast<std::int64_t>(count)) return;
    throw InputError({file_, mesh_.face_lines[face]},
                     fmt::format("there is no {} {}", what, index + 1L),
                     fmt::format("numbers from 1 to {}", count));
  }

  void ignore(std::string_view statement) {
    ++mesh_.ignored[one_line(statement, 32)];
    if (mesh_.ignored.size() > kMaxIgnoredStatements) {
      fail("the file is no OBJ file (it has too many unknown statements)", "v, vt, f, ...");
    }
  }

  double number(std::string_view& rest) const {
    const std::string_view word = take_word(rest);
    const std::optional<double> value = parse_number(word);
    if (!value) fail(quoted_value(word) + " is not a finite number", "a coordinate");
    rest.remove_prefix(std::min(rest.find_first_not_of(kBlanks), rest.size()));
    return *value;
  }

  void check_count(std::size_t count) const {
    if (count >= static_cast<std::size_t>(std::numeric_limits<int>::max())) {
      fail("the mesh is too large", "fewer than 2^31 of each kind");
    }
  }

  void check_end(std::string_view rest) const {
    if (rest.empty()) return;
    fail("the line has too many numbers, from " + quoted_value(rest), "nothing behind them");
  }

  [[noreturn]] void fail_corner(std::string_view word) const {
    fail("a corner " + quoted_value(word), "V, V/VT, V//VN or V/VT/VN, counted from 1");
  }

  [[noreturn]] void fail(const std::string& problem, const std::string& expected) const {
    throw InputError({file_, lines_.number()}, problem, expected);
  }

  LineReader lines_;
  const std::string& file_;
  ObjMesh mesh_;
  std::vector<std::vector<int>*> groups_;  // of what follows
  bool has_texture_ = false;
};

}  // namespace

ObjMesh parse_obj(std::string_view text, const std::string& file) {
  return ObjParser(text, file).parse();
}

ObjMesh read_obj(const std::filesystem::path& path) {
  return parse_obj(read_text_file(path, kMaxMeshFileSize), path.string());
}

}  // namespace pliant
