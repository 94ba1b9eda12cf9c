#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>

#include "base/limits.h"
#include "clients/cli/actions/actions.h"
#include "clients/cli/recipe/places.h"
#include "clients/cli/terminal/files.h"
#include "clients/cli/terminal/print.h"
#include "protocol/json/decode.h"
#include "protocol/json/encode.h"

namespace pelage {

namespace {

/// Parses "1,2,3" as exactly `count` numbers. `flag` is the option's name without its dashes, for the error.
Result<std::vector<double>> parse_numbers(const std::string& text, std::size_t count, const std::string& flag) {
  std::vector<double> numbers;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    double number = 0;
    const auto [stop, error] = std::from_chars(text.data() + begin, text.data() + end, number);
    if (error != std::errc() || stop != text.data() + end) break;
    numbers.push_back(number);
    begin = end + 1;
    if (end == text.size() && numbers.size() == count) return numbers;
  }
  return failure(Code::invalid, fmt::format("\"{}\" is not {} numbers with commas.", text, count), "/" + flag,
                 fmt::format("{} numbers", count));
}

glm::dvec3 triple_of(const std::vector<double>& numbers, std::size_t first) {
  return {numbers[first], numbers[first + 1], numbers[first + 2]};
}

/// Converts between positions on the command line, model coordinates and fractions of the bounding box, [0, 1], and
/// formats them as recipes do. Command-line positions are model coordinates with `world`, else fractions.
class PositionConverter {
 public:
  PositionConverter(const Bounds& box, bool world) : box_(box), world_(world) {}

  glm::dvec3 position(glm::dvec3 given) const { return world_ ? given : box_.min + given * extent(); }
  glm::dvec3 shares(glm::dvec3 position) const {
    const glm::dvec3 offset = position - box_.min, box_size = extent();
    const auto share = [&](int k) { return box_size[k] > 0 ? std::round(1e6 * offset[k] / box_size[k]) / 1e6 : 0.0; };
    return {share(0), share(1), share(2)};
  }
  /// Formats a position in model coordinates as {"at": [x, y, z]}, in fractions of the box.
  std::string at(glm::dvec3 position) const { return "{\"at\": " + list(shares(position)) + "}"; }
  static std::string list(glm::dvec3 v) { return fmt::format("[{}, {}, {}]", v.x + 0, v.y + 0, v.z + 0); }  // no -0

 private:
  glm::dvec3 extent() const { return box_.max - box_.min; }

  const Bounds& box_;
  bool world_;
};

/// A pick request, and the same request as the JSON of a recipe's `pick`.
struct PickQuery {
  PickRequest request;
  std::string in_recipe;
};

Result<PickQuery> pixel_query(const Options& options) {
  const auto view = decode_frame_query(options.frame);
  if (!view) return view.status();
  const PickRequest request{.view = {view->camera, view->width, view->height}, .pixel = {*options.x, *options.y}};
  return PickQuery{request, encode(request)};
}

Result<PickQuery> ray_query(const Options& options, const PositionConverter& converter) {
  const auto numbers = parse_numbers(options.ray, 6, "ray");
  if (!numbers) return numbers.status();
  const PickRay ray{converter.position(triple_of(*numbers, 0)), triple_of(*numbers, 3)};
  return PickQuery{{.ray = ray},
                   fmt::format(R"({{"ray": {{"origin": {}, "direction": {}}}}})", converter.at(ray.origin),
                               PositionConverter::list(ray.direction))};
}

Result<PickQuery> nearest_query(const Options& options, const PositionConverter& converter) {
  const auto numbers = parse_numbers(options.nearest, 3, "nearest");
  if (!numbers) return numbers.status();
  const glm::dvec3 position = converter.position(triple_of(*numbers, 0));
  return PickQuery{{.nearest = position}, "{\"nearest\": " + converter.at(position) + "}"};
}

Result<PickQuery> farthest_query(const Options& options, const PositionConverter& converter) {
  const auto direction = parse_numbers(options.farthest, 3, "farthest");
  if (!direction) return direction.status();
  PickFarthest farthest{.direction = triple_of(*direction, 0)};
  std::string box;
  if (!options.box.empty()) {
    const auto corners = parse_numbers(options.box, 6, "box");
    if (!corners) return corners.status();
    farthest.min = converter.position(triple_of(*corners, 0));
    farthest.max = converter.position(triple_of(*corners, 3));
    box = fmt::format(R"(, "min": {}, "max": {})", converter.at(*farthest.min), converter.at(*farthest.max));
  }
  return PickQuery{
      {.farthest = farthest},
      fmt::format(R"({{"farthest": {{"direction": {}{}}}}})", PositionConverter::list(farthest.direction), box)};
}

Result<PickQuery> query_of(const Options& options, const PositionConverter& converter) {
  if (!options.ray.empty()) return ray_query(options, converter);
  if (!options.nearest.empty()) return nearest_query(options, converter);
  if (!options.farthest.empty()) return farthest_query(options, converter);
  return pixel_query(options);
}

/// Prints the position in each form that commands and recipes take.
void print_forms(const Options& options, const PickAnswer& answer, const PositionConverter& converter,
                 const PickQuery& query) {
  const std::string name = options.place_name.empty() ? "place" : options.place_name;
  fmt::print("in a recipe {}\n", converter.at(answer.position));
  fmt::print("  this model  {}\n", PositionConverter::list(answer.position));
  fmt::print("  a sample    {{\"triangle\": {}, \"barycentric\": {}}}\n", answer.triangle,
             PositionConverter::list(answer.barycentric));
  fmt::print("  a step      {{\"pick\": {}, \"as\": {}}}\n", query.in_recipe, json_text(name));
}

/// Adds the place to the JSON file given by --places.
Status save_place(const Options& options, glm::dvec3 shares) {
  const auto before = std::filesystem::exists(options.places) ? read_file(options.places, limits::recipe_bytes)
                                                              : Result<std::string>(std::string());
  if (!before) return before.status();
  const auto after = with_place(*before, options.place_name, {shares.x, shares.y, shares.z});
  if (!after) {
    Status refused = after.status();
    refused.message.insert(0, options.places + ": ");
    return refused;
  }
  return write_file(options.places, *after);
}

Result<Bounds> box_of(Session& session, const std::string& path) {
  const auto answer = Session::accepted(session.connection().get(path));
  const auto summary = answer ? decode_answer<SceneSummary>(answer->body) : Result<SceneSummary>(answer.status());
  return summary ? Result<Bounds>(summary->report.bounds) : summary.status();
}

Result<HttpAnswer> send_pick(Session& session, const std::string& path, const PickQuery& query) {
  const std::string body = encode(query.request);
  if (const auto checked = decode_pick(body); !checked) return checked.status();
  return Session::accepted(session.connection().post_json(path + "/pick", body));
}

}  // namespace

ExitCode pick_position(Session& session) {
  const Options& options = session.options();
  if (const auto checked = query_of(options, {{}, true}); !checked) return report(checked.status());
  const auto path = session.scene_path();
  if (!path) return report(path.status());
  const auto box = box_of(session, *path);
  if (!box) return report(box.status());
  const PositionConverter converter(*box, options.world);
  const auto query = query_of(options, converter);
  const auto answer = query ? send_pick(session, *path, *query) : Result<HttpAnswer>(query.status());
  if (!answer) return report(answer.status());
  const auto pick = decode_answer<PickAnswer>(answer->body);
  if (!pick) return report(pick.status());
  if (options.json) fmt::print("{}\n", answer->body);
  if (!options.json && pick->strand) print(*pick->strand);
  if (!pick->hit) {
    if (!options.json) fmt::print("{}\n", pick->strand ? "no skin there" : "nothing there");
    return options.places.empty() ? done : report(failure(Code::invalid, "There is no place to store."));
  }
  if (!options.json) print(*pick), print_forms(options, *pick, converter, *query);
  if (options.places.empty()) return done;
  const Status saved = save_place(options, converter.shares(pick->position));
  return saved.ok() ? done : report(saved);
}

}  // namespace pelage
