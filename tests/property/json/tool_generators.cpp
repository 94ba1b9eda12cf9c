// Random commands of the grooming kernel: a visitor of the same lists of members that decoding and encoding visit.
#include <algorithm>

#include "protocol/json/tool_members.h"
#include "tests/property/json/generators.h"

namespace pelage::testing {

namespace {

using json_parts::coordinate;
using json_parts::members;

bool coin() { return *rc::gen::arbitrary<bool>(); }

std::string word(int least) {
  return *rc::gen::container<std::string>(static_cast<std::size_t>(*rc::gen::inRange(least, 20)),
                                          rc::gen::inRange<char>(' ', '~'));
}

glm::dvec3 place() {
  const auto one = [] { return number(coordinate.low, coordinate.high); };
  return {one(), one(), one()};
}

class MemberMaker {
 public:
  static constexpr bool reads = false;

  void stroke(std::optional<Stroke>& out) {
    if (coin()) out = random_stroke();
  }
  void brush(Brush& out) { out = random_brush(); }
  void boolean(std::string_view, bool& out) { out = coin(); }
  void boolean(std::string_view, std::optional<bool>& out) {
    if (coin()) out = coin();
  }
  void number(std::string_view, double& out, Range range) { out = testing::number(range.low, range.high); }
  void number(std::string_view, std::optional<double>& out, Range range) {
    if (coin()) out = testing::number(range.low, range.high);
  }
  void integer(std::string_view, int& out, Range range) {
    out = *rc::gen::inRange(static_cast<int>(range.low), static_cast<int>(range.high) + 1);
  }
  void seed(std::string_view, std::uint32_t& out) { out = *rc::gen::arbitrary<std::uint32_t>(); }
  void counter(std::string_view, std::optional<std::uint64_t>& out) {
    if (coin()) out = *rc::gen::arbitrary<std::uint64_t>();
  }
  void text(std::string_view, std::string& out) { out = word(0); }
  void text(std::string_view, std::optional<std::string>& out) {
    if (coin()) out = word(0);
  }
  void required_text(std::string_view, std::string& out) { out = word(1); }
  void picture(std::string_view, std::string& out) {
    out = *rc::gen::container<std::string>(32, rc::gen::elementOf(std::string("0123456789abcdef")));
  }
  void position(std::string_view, glm::dvec3& out) { out = place(); }
  void required_position(std::string_view, glm::dvec3& out) { out = place(); }
  void direction(std::string_view, glm::dvec3& out) { out = testing::direction(); }
  void direction(std::string_view, std::optional<glm::dvec3>& out) {
    if (coin()) out = testing::direction();
  }
  void colour(std::string_view, glm::vec3& out) { out = testing::colour(); }
  template <class E, std::size_t N>
  void name(std::string_view, E& out, const std::array<json_names::Name<E>, N>& names) {
    out = names[static_cast<std::size_t>(*rc::gen::inRange(0, static_cast<int>(N)))].value;
  }
  void field(std::string_view, Field& out) { out = one_of(Field::tip_colour); }
  void fields(std::string_view, std::vector<Field>& out, std::size_t least) {
    out.clear();
    for (std::size_t f = 0; f < field_count; ++f) {
      if (coin()) out.push_back(field_at(f));
    }
    if (out.size() < least) out.push_back(Field::length);
  }
  template <class T>
  void object(std::string_view, T& out) {
    members(*this, out);
  }
  template <class T>
  void objects(std::string_view, std::vector<T>& out, Count count) {
    const int size = *rc::gen::inRange(static_cast<int>(count.least), static_cast<int>(std::min<std::size_t>(count.most, 4)));
    for (int i = 0; i < size; ++i) {
      MemberMaker maker;
      members(maker, out.emplace_back());
    }
  }
  void curves(std::string_view, std::vector<std::vector<glm::dvec3>>& out, Count, Count points) {
    for (int i = *rc::gen::inRange(1, 3); i > 0; --i) {
      for (std::size_t k = 0; k < points.least; ++k) {
        if (k == 0) out.emplace_back();
        out.back().push_back(place());
      }
    }
  }
  template <class T, class Variant>
  void alternative(std::string_view, Variant& out) {
    if (coin()) return;
    T value;
    members(*this, value);
    out = value;
  }
  template <class Variant>
  void alternative(std::string_view, Variant& out, Range range) {
    if (coin()) out = testing::number(range.low, range.high);
  }
  template <class Variant>
  void vertices(std::string_view, Variant& out) {
    if (coin()) out = MaskVertices{{*rc::gen::arbitrary<std::uint32_t>(), 7}};
  }
};

// What members alone do not say: which of them go together.
template <class Tool>
void agree(Tool&) {}
void agree(Comb& comb) {
  comb.direction.reset();
  if (comb.flood) comb.direction = direction();
}
void agree(Interpolate& command) {
  for (Key& key : command.keys) {
    if (!key.direction) key.inclination.reset();
    if (!key.direction && !key.length) key.length = 0.5;
  }
}
void agree(Unify& unify) {
  const auto drop = [&](Field field) { std::erase(unify.mean, field); };
  if (unify.direction || unify.inclination) drop(Field::direction);
  if (unify.length) drop(Field::length);
  if (!unify.direction && !unify.inclination && !unify.length && unify.mean.empty()) unify.inclination = 0.5;
}
void agree(Part& part) { part.stroke = random_stroke(); }
void agree(Clump& clump) { clump.stroke = random_stroke(); }
void agree(Length& length) {
  if (length.mode != LengthMode::add) length.value = std::abs(length.value);
  if (length.mode == LengthMode::jitter) length.value = number(0, 1);
}
void agree(Erase& erase) {
  if (!erase.checkpoint.empty()) erase.revision.reset();
}
void agree(Paint& paint) {
  paint.field = field_at(static_cast<std::size_t>(*rc::gen::inRange(3, static_cast<int>(field_count))));
  paint.value = number(0, shape_of(paint.field).most);
  if (shape_of(paint.field).channels == 1) paint.colour = glm::vec3(1);
}
void agree(ChangeMask& mask) {
  if (auto* box = std::get_if<MaskBox>(&mask.shape)) box->max = glm::max(box->min, box->max);
}
void agree(ApplyMap& map) {
  if (!fits(map.field, map.encoding)) map.encoding = MapEncoding::automatic;
}
template <class T>
void rename(std::vector<T>& named) {
  for (std::size_t k = 0; k < named.size(); ++k) named[k].name = std::to_string(k);
}
void agree(SetBlowers& command) { rename(command.blowers); }
void agree(SetAttractors& command) { rename(command.attractors); }

void agree(ChangeLayer& layer) {
  if (layer.action == LayerAction::set && !layer.weight && !layer.muted && layer.rename.empty()) layer.muted = true;
  if (layer.action == LayerAction::move && !layer.above) layer.above = "";
  if (layer.above == layer.name) layer.above = "";
}

// Some tools have no opposite, and only colours differ from root to tip.
template <class Tool>
void agree_with_brush(Tool& tool) {
  constexpr bool no_opposite = std::is_same_v<Tool, Smooth> || std::is_same_v<Tool, Unify> || std::is_same_v<Tool, Erase> ||
                               std::is_same_v<Tool, Trim> || std::is_same_v<Tool, Interpolate> ||
                               std::is_same_v<Tool, Flow>;
  if constexpr (no_opposite) tool.brush.invert = false;
  if constexpr (std::is_same_v<Tool, Paint>) {
    if (shape_of(tool.field).channels == 4) return;
  }
  tool.brush.strand_from = 0, tool.brush.strand_to = 1;
}

// The mask lies outside of all layers.
template <class Tool>
void agree_with_layer(Tool& tool) {
  bool mask = false;
  const auto has = [](const std::vector<Field>& fields) {
    return std::count(fields.begin(), fields.end(), Field::mask) > 0;
  };
  if constexpr (requires { tool.field; }) mask = tool.field == Field::mask;
  if constexpr (requires { tool.fields; }) mask = has(tool.fields);
  if constexpr (requires { tool.mean; }) mask = has(tool.mean);
  if (mask) tool.layer.clear();
}

template <class Tool>
Command random_tool() {
  Tool tool;
  MemberMaker maker;
  members(maker, tool);
  if constexpr (requires { tool.flood; }) {
    tool.stroke.reset();
    if (!tool.flood) tool.stroke = random_stroke();
  }
  agree(tool);
  if constexpr (requires { tool.brush; }) agree_with_brush(tool);
  if constexpr (requires { tool.layer; }) agree_with_layer(tool);
  return tool;
}

template <class... Tools>
std::vector<Command (*)()> list_makers(std::variant<Tools...>*) {
  std::vector<Command (*)()> makers;
  const auto add = [&]<class Tool>(Tool*) {
    if constexpr (json_parts::ListedTool<Tool>) makers.push_back(random_tool<Tool>);
  };
  (add(static_cast<Tools*>(nullptr)), ...);
  return makers;
}

}  // namespace

Command tool() {
  static const std::vector<Command (*)()> makers = list_makers(static_cast<Command*>(nullptr));
  return makers[static_cast<std::size_t>(*rc::gen::inRange(0, static_cast<int>(makers.size())))]();
}

}  // namespace pelage::testing
