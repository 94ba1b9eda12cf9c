#include <charconv>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <map>
#include <string>

#include "server/guide_files/read_guides.h"
#include "server/guide_files/usda_tokens.h"

namespace pelage {

namespace {

constexpr int deepest = 256;  // nesting of prims
constexpr double min_metres = 1e-9, max_metres = 1e9;

/// The data of a prim that determine its curves.
struct Prim {
  bool has_curves = false;  // BasisCurves
  glm::dmat4 parent{1};
  std::map<std::string, std::vector<double>, std::less<>> operations;  // numbers, by "xformOp:..."
  std::vector<std::string> order;
  std::vector<double> points, counts;
};

bool is_word(const UsdaToken& token, std::string_view word) {
  return token.kind == UsdaToken::Kind::word && token.text == word;
}

/// Returns the kind of an operation: "rotateXYZ" for "xformOp:rotateXYZ:pivot".
std::string_view kind_of(std::string_view name) {
  name.remove_prefix(std::min(name.find(':') + 1, name.size()));
  return name.substr(0, name.find(':'));
}

glm::dmat4 turn_of(std::string_view axes, const double* degrees) {
  glm::dmat4 turn(1);
  for (std::size_t i = 0; i < axes.size(); ++i) {  // the first axis is applied first
    glm::dvec3 axis(0);
    axis[axes[i] - 'X'] = 1;
    const double angle = degrees[axes.size() == 1 ? 0 : static_cast<std::size_t>(axes[i] - 'X')];
    turn = glm::rotate(glm::dmat4(1), glm::radians(angle), axis) * turn;
  }
  return turn;
}

/// Returns the matrix of one operation. USD's matrices apply to row vectors, so that their rows are columns here.
Result<glm::dmat4> matrix_of(std::string_view name, const std::vector<double>& numbers) {
  const std::string_view kind = kind_of(name);
  const auto vector = [&] { return glm::dvec3(numbers[0], numbers[1], numbers[2]); };
  if (kind == "translate" && numbers.size() == 3) return glm::translate(glm::dmat4(1), vector());
  if (kind == "scale" && numbers.size() == 3) return glm::scale(glm::dmat4(1), vector());
  if (kind == "transform" && numbers.size() == 16) {
    glm::dmat4 matrix;
    for (int i = 0; i < 16; ++i) matrix[i / 4][i % 4] = numbers[static_cast<std::size_t>(i)];
    return matrix;
  }
  const std::string_view axes = kind.starts_with("rotate") ? kind.substr(6) : std::string_view();
  const bool turns = !axes.empty() && axes.find_first_not_of("XYZ") == std::string_view::npos;
  if (turns && numbers.size() == axes.size() && (axes.size() == 1 || axes.size() == 3))
    return turn_of(axes, numbers.data());
  return broken_guides("its operation " + std::string(name) + " is not known here; bake it into the points.");
}

class UsdaReader {
 public:
  explicit UsdaReader(std::string_view text) : tokens_(text) {}

  Result<GuideFile> read() {
    if (tokens_.peek().is('('))
      if (Status status = read_metadata(); !status.ok()) return status;
    Prim root;
    if (Status status = read_body(root, 0); !status.ok()) return status;
    file_.curves = std::move(curves_);
    return std::move(file_);
  }

 private:
  /// Reads the file's up axis and unit, and skips other metadata.
  Status read_metadata() {
    tokens_.take();
    std::string name;
    for (UsdaToken token = tokens_.take(); !token.is(')'); token = tokens_.take()) {
      if (token.kind == UsdaToken::Kind::end) return broken_guides("it is cut off.");
      if (token.kind == UsdaToken::Kind::word) name = token.text;
      if (!token.is('=')) continue;
      Status status;
      if (name == "upAxis")
        status = read_up();
      else if (name == "metersPerUnit")
        status = read_metres();
      else
        tokens_.skip_value();
      if (!status.ok()) return status;
    }
    return {};
  }

  Status read_up() {
    const std::string_view axis = tokens_.take().text;
    if (axis != "Y" && axis != "Z") return broken_guides("its upAxis is neither Y nor Z.");
    file_.up = axis == "Z" ? Axis::plus_z : Axis::plus_y;
    return {};
  }

  Status read_metres() {
    std::vector<double> numbers;
    if (Status status = read_numbers(numbers); !status.ok()) return status;
    if (numbers.size() != 1 || !(numbers[0] >= min_metres && numbers[0] <= max_metres))
      return broken_guides("its metersPerUnit is not within 1e-9 to 1e9.");
    file_.metres = numbers[0];
    return {};
  }

  /// Reads the content of a prim, including its closing brace.
  Status read_body(Prim& prim, int depth) {
    if (depth > deepest) return broken_guides("its prims lie too deep.");
    std::string name;
    for (UsdaToken token = tokens_.take(); !token.is('}'); token = tokens_.take()) {
      if (token.kind == UsdaToken::Kind::end && depth > 0) return broken_guides("it is cut off.");
      if (token.kind == UsdaToken::Kind::end) break;
      Status status;
      if (is_word(token, "def") || is_word(token, "over") || is_word(token, "class")) {
        status = read_prim(prim, depth);
      } else if (token.is('=')) {
        status = read_value(prim, name);
      } else if (token.is('(') || token.is('[') || token.is('{')) {
        tokens_.skip_group();
      } else if (token.kind == UsdaToken::Kind::word) {
        name = token.text;
      }
      if (!status.ok()) return status;
    }
    return prim.has_curves ? add_curves(prim) : Status();
  }

  Status read_prim(Prim& parent, int depth) {
    Prim prim;
    UsdaToken token = tokens_.take();
    if (token.kind == UsdaToken::Kind::word) prim.has_curves = token.text == "BasisCurves", token = tokens_.take();
    if (token.kind != UsdaToken::Kind::text) return broken_guides("a prim of it has no name.");
    if (tokens_.peek().is('(')) tokens_.take(), tokens_.skip_group();
    if (!tokens_.take().is('{'))
      return broken_guides("the prim \"" + std::string(token.text.substr(0, 100)) + "\" has no body.");
    const Result<glm::dmat4> transform = transform_of(parent);
    if (!transform) return transform.status();
    prim.parent = *transform;
    return read_body(prim, depth + 1);
  }

  Status read_value(Prim& prim, const std::string& name) {
    if (name == "points.timeSamples") return broken_guides("its points change over time; export one frame.");
    if (name == "points") return read_numbers(prim.points);
    if (name == "curveVertexCounts") return read_numbers(prim.counts);
    if (name == "xformOpOrder") return read_order(prim.order);
    if (name.starts_with("xformOp:") && name.find('.') == std::string::npos) return read_numbers(prim.operations[name]);
    tokens_.skip_value();
    return {};
  }

  /// Reads all numbers of a value, however they are grouped.
  Status read_numbers(std::vector<double>& numbers) {
    numbers.clear();
    int depth = 0;
    do {
      const UsdaToken token = tokens_.take();
      if (token.kind == UsdaToken::Kind::end) return broken_guides("it is cut off.");
      if (token.is('(') || token.is('[')) ++depth;
      if (token.is(')') || token.is(']')) --depth;
      if (token.kind != UsdaToken::Kind::word) continue;
      double number = 0;
      const auto [end, error] = std::from_chars(token.text.data(), token.text.data() + token.text.size(), number);
      if (error != std::errc() || end != token.text.data() + token.text.size())
        return broken_guides("\"" + std::string(token.text.substr(0, 100)) + "\" is no number.");
      numbers.push_back(number);
    } while (depth > 0);
    return {};
  }

  Status read_order(std::vector<std::string>& order) {
    order.clear();
    if (!tokens_.take().is('[')) return broken_guides("its xformOpOrder is no list.");
    for (UsdaToken token = tokens_.take(); !token.is(']'); token = tokens_.take()) {
      if (token.kind == UsdaToken::Kind::end) return broken_guides("it is cut off.");
      if (token.kind == UsdaToken::Kind::text) order.emplace_back(token.text);
    }
    return {};
  }

  /// Returns the matrix from the prim's own coordinates to the file's. The last operation is applied first.
  static Result<glm::dmat4> transform_of(const Prim& prim) {
    glm::dmat4 transform = prim.parent;
    for (std::string_view name : prim.order) {
      if (name == "!resetXformStack!") {
        transform = glm::dmat4(1);
        continue;
      }
      constexpr std::string_view inverted = "!invert!";
      const bool inverse = name.starts_with(inverted);
      if (inverse) name.remove_prefix(inverted.size());
      const auto numbers = prim.operations.find(name);
      if (numbers == prim.operations.end()) return broken_guides("its " + std::string(name) + " has no value.");
      const Result<glm::dmat4> matrix = matrix_of(name, numbers->second);
      if (!matrix) return matrix;
      transform *= inverse ? glm::inverse(*matrix) : *matrix;
    }
    return transform;
  }

  Status add_curves(const Prim& prim) {
    const Result<glm::dmat4> transform = transform_of(prim);
    if (!transform) return transform.status();
    std::size_t next = 0;
    for (const double count : prim.counts) {
      const double left = static_cast<double>(prim.points.size() / 3 - next);
      if (!(count >= 1 && count <= left) || count != std::floor(count))
        return broken_guides("its curveVertexCounts and points do not fit.");
      GuideCurve& curve = curves_.emplace_back();
      for (std::size_t k = 0; k < static_cast<std::size_t>(count); ++k, ++next) {
        const double* p = &prim.points[3 * next];
        curve.emplace_back(glm::dvec3(*transform * glm::dvec4(p[0], p[1], p[2], 1)));
      }
    }
    return {};
  }

  UsdaTokens tokens_;
  GuideFile file_;
  std::vector<GuideCurve> curves_;
};

}  // namespace

Result<GuideFile> read_usda_curves(std::string_view text) {
  if (!text.starts_with("#usda")) return broken_guides("it does not begin with #usda; usdcat writes USD as text.");
  return UsdaReader(text).read();
}

}  // namespace pelage
