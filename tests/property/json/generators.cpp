#include "tests/property/json/generators.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "protocol/json/colour.h"
#include "protocol/json/encode.h"
#include "protocol/json/members_answers.h"
#include "protocol/json/members_frame.h"
#include "protocol/json/members_scene.h"
#include "protocol/json/members_settings.h"
#include "tests/property/json/agreement.h"

namespace pelage::testing {

/// Draws numbers of every magnitude within a range, including its ends.
double number(double low, double high) {
  low = std::max(low, -1e30), high = std::min(high, 1e30);  // stand-ins for open ends
  const auto bits = *rc::gen::inRange<std::uint64_t>(0, std::uint64_t{1} << 53);
  const int kind = *rc::gen::inRange(0, 4);
  if (kind == 0) return low;
  if (kind == 1) return high;
  const double share = static_cast<double>(bits) * 0x1p-53;
  if (kind == 2) return low + (high - low) * share;
  return std::clamp(std::ldexp(share, -*rc::gen::inRange(0, 1000)), low, high);
}

glm::dvec3 direction() { return {number(-1e5, 1e5), number(1e-3, 1e5), number(-1e5, 1e5)}; }

glm::vec3 colour() {
  if (*rc::gen::arbitrary<bool>()) {
    const auto level = [] { return static_cast<unsigned>(*rc::gen::inRange(0, 256)); };
    char text[8];
    std::snprintf(text, sizeof text, "#%02x%02x%02x", level(), level(), level());
    return *colour_of_text(text);
  }
  return {static_cast<float>(number(0, 1)), static_cast<float>(number(0, 1)), static_cast<float>(number(0, 1))};
}

Camera camera() {
  Camera result;
  result.automatic = one_of(AutoView::three_quarter);
  if (result.automatic != AutoView::none) return result;
  result.position = {number(-10, 10), number(-10, 10), number(1, 10)};
  result.target = {number(-10, 10), number(-1, 1), number(-10, 0)};
  result.up = {0, number(0.1, 9), 0};
  result.fov_degrees = number(1, 150);
  return result;
}

namespace {

using namespace json_parts;

bool coin() { return *rc::gen::arbitrary<bool>(); }

std::string any_word(int min) {
  return *rc::gen::container<std::string>(static_cast<std::size_t>(*rc::gen::inRange(min, 20)),
                                          rc::gen::inRange<char>(' ', '~'));
}

glm::dvec3 random_position() {
  const auto one = [] { return number(coordinate.low, coordinate.high); };
  return {one(), one(), one()};
}

/// Fills a struct with random members within their ranges; agree() then makes them go together.
class MemberMaker {
 public:
  static constexpr bool reads = false;

  void type(const char*, const char* = "") {}
  void answer(const char*, const char* = "") {}
  bool takes(bool condition) { return condition; }
  bool shows(bool condition) { return condition; }

  void number(MemberName, double& out, Range range, const char* = "") { out = testing::number(range.low, range.high); }
  void number(MemberName, std::optional<double>& out, Range range, const char* = "") {
    if (coin()) out = testing::number(range.low, range.high);
  }
  void number_or(const char*, MemberName name, std::optional<double>& out, Range range, const char* = "") {
    number(name, out, range);
  }
  void numbers(MemberName, std::vector<double>& out, Range range, Count count, const char* = "") {
    out.assign(coin() ? count.min : 0, testing::number(range.low, range.high));
  }
  void integer(MemberName, int& out, Range range, const char* = "") {
    out = *rc::gen::inRange(static_cast<int>(range.low), static_cast<int>(range.high) + 1);
  }
  void integers(MemberName name, std::vector<int>& out, Range range, Count count, const char* = "") {
    out.resize(static_cast<std::size_t>(length(count)));
    for (int& value : out) integer(name, value, range);
  }
  void seed(MemberName, std::uint32_t& out, const char* = "") { out = *rc::gen::arbitrary<std::uint32_t>(); }
  void counter(MemberName, std::uint64_t& out, const char* = "") { out = *rc::gen::arbitrary<std::uint64_t>(); }
  void counter(MemberName, std::optional<std::uint64_t>& out, const char* = "") {
    if (coin()) out = *rc::gen::arbitrary<std::uint64_t>();
  }
  template <class T>
  void boolean(MemberName, T& out, const char* = "") {
    if (coin()) out = coin();
  }
  void text(MemberName, std::string& out, const char* = "", std::size_t = 0) { out = any_word(0); }
  void text(MemberName, std::optional<std::string>& out, const char* = "", std::size_t = 0) {
    if (coin()) out = any_word(0);
  }
  void texts(MemberName, std::vector<std::string>& out, const char* = "") {
    for (int size = length(any_count); size > 0; --size) out.push_back(any_word(0));
  }
  void label(MemberName, std::string& out, const char* = "") { out = any_word(1); }
  void picture(MemberName, std::string& out, const char* = "", const char* word_for_none = nullptr) {
    if (word_for_none && coin()) return;
    out = *rc::gen::container<std::string>(32, rc::gen::elementOf(std::string("0123456789abcdef")));
  }
  void hash(MemberName, FieldsHash& out, const char* = "") {
    out = {*rc::gen::arbitrary<std::uint64_t>(), *rc::gen::arbitrary<std::uint64_t>()};
  }
  void json(MemberName, std::string& out, const char* = "") {
    if (coin()) out = nlohmann::json::parse(encode(command())).dump();
  }
  void position(MemberName, glm::dvec3& out, const char* = "") { out = random_position(); }
  void position(MemberName, std::optional<glm::dvec3>& out, const char* = "") {
    if (coin()) out = random_position();
  }
  template <glm::length_t N>
  void vector(MemberName, glm::vec<N, double>& out, Range range, const char* = "") {
    for (glm::length_t i = 0; i < N; ++i) out[i] = testing::number(range.low, range.high);
  }
  void vectors(MemberName, std::optional<SphericalHarmonics>& out, Range range, const char* = "") {
    if (coin()) return;
    for (glm::dvec3& one : out.emplace()) vector("", one, range);
  }
  void pixel(MemberName, glm::dvec2& out, const View& view, const char* = "") {
    out = {testing::number(0, view.width), testing::number(0, view.height)};
  }
  void direction(MemberName, glm::dvec3& out, const char* = "") { out = testing::direction(); }
  void direction(MemberName, std::optional<glm::dvec3>& out, const char* = "") {
    if (coin()) out = testing::direction();
  }
  void colour(MemberName, glm::vec3& out, const char* = "") { out = testing::colour(); }
  template <class E, std::size_t N>
  void name(MemberName, E& out, const std::array<json_names::Name<E>, N>& names, const char* = "") {
    out = names[static_cast<std::size_t>(*rc::gen::inRange(0, static_cast<int>(N)))].value;
  }
  template <class E, std::size_t N>
  void name(MemberName name, std::optional<E>& out, const std::array<json_names::Name<E>, N>& names, const char* = "") {
    if (coin()) this->name(name, out.emplace(), names);
  }
  template <class E, std::size_t N>
  void word(MemberName, std::string& out, const std::array<json_names::Name<E>, N>& names, const char* = "") {
    out = names[static_cast<std::size_t>(*rc::gen::inRange(0, static_cast<int>(N)))].text;
  }
  template <class E, std::size_t N>
  void names(MemberName, std::vector<E>& out, const std::array<json_names::Name<E>, N>& names, std::size_t min,
             const char*, const char* = "") {
    out.clear();
    for (const auto& name : names) {
      if (coin()) out.push_back(name.value);
    }
    if (out.size() < min) out.push_back(names[1].value);
  }
  void object(MemberName, Camera& out, const char* = "") { out = camera(); }
  template <class T>
  void object(MemberName, T& out, const char* = "") {
    out = made<T>();
  }
  template <class T>
  void object(MemberName name, std::optional<T>& out, const char* = "") {
    if (name.presence == Presence::required || coin()) out = made<T>();
  }
  template <class T>
  void objects(MemberName, std::vector<T>& out, Count count, const char* = "") {
    out.clear();
    for (int size = length(count); size > 0; --size) out.push_back(made<T>());
  }
  void objects(MemberName, std::vector<Command>& out, Count count, const char* = "") {
    for (int size = length(count); size > 0; --size) out.push_back(command());
  }
  void curves(MemberName, std::vector<std::vector<glm::dvec3>>& out, Count, Count points, const char* = "") {
    out.assign(static_cast<std::size_t>(*rc::gen::inRange(1, 3)), {});
    for (std::vector<glm::dvec3>& curve : out) {
      for (int size = length(points); size > 0; --size) curve.push_back(random_position());
    }
  }
  template <class T, class Variant>
  void alternative(MemberName, Variant& out, const char* = "") {
    if (coin()) out = made<T>();
  }
  template <class Variant>
  void alternative(MemberName, Variant& out, Range range, const char* = "") {
    if (coin()) out = testing::number(range.low, range.high);
  }
  template <class Variant>
  void vertices(MemberName, Variant& out, const char* = "") {
    if (coin()) out = MaskVertices{{*rc::gen::arbitrary<std::uint32_t>(), 7}};
  }
  void special(MemberName, Knobs& out, const char* = "") { out = made<Knobs>(); }
  void special(MemberName, std::optional<Tracing>& out, const char* = "") { object("", out); }
  void special(MemberName, Backdrop<false> out, const char* = "") {
    out.kind = one_of(Background::studio), out.colour = testing::colour();
  }
  void sample_position(std::variant<PositionSample, ScreenSample, SurfaceSample>& out) {
    switch (*rc::gen::inRange(0, 3)) {
      case 0: out = PositionSample{random_position()}; break;
      case 1: out = ScreenSample{{testing::number(-1e6, 1e6), testing::number(-1e6, 1e6)}}; break;
      default: {
        const double a = testing::number(0, 1), b = testing::number(0, 1 - a);
        out = SurfaceSample{*rc::gen::arbitrary<std::uint32_t>(), {a, b, std::max(0.0, 1 - a - b)}};
      }
    }
  }

  template <class T>
  static T made() {
    T value{};
    MemberMaker maker;
    members(maker, value);
    agree(value);
    return value;
  }

 private:
  static int length(Count count) {
    const auto min = static_cast<int>(count.min), max = static_cast<int>(std::min<std::size_t>(count.max, 4));
    return *rc::gen::inRange(min, std::max(min, max) + 1);
  }
};

template <class... Commands>
Command random_command(std::variant<Commands...>*) {
  static constexpr Command (*makers[])() = {[]() -> Command { return MemberMaker::made<Commands>(); }...};
  return makers[static_cast<std::size_t>(*rc::gen::inRange(0, static_cast<int>(std::size(makers))))]();
}

}  // namespace

Stroke random_stroke() { return MemberMaker::made<Stroke>(); }
NewScene new_scene() { return MemberMaker::made<NewScene>(); }
FrameRequest frame_request() { return MemberMaker::made<FrameRequest>(); }
BranchRequest branch_request() { return MemberMaker::made<BranchRequest>(); }
AmendRequest amend_request() { return MemberMaker::made<AmendRequest>(); }
Command set_coat() { return MemberMaker::made<SetCoat>(); }
Command set_environment() { return MemberMaker::made<SetEnvironment>(); }
Command set_skin_texture() { return MemberMaker::made<SetSkinTexture>(); }
Command command() { return random_command(static_cast<Command*>(nullptr)); }

template <class T>
T answer() {
  return MemberMaker::made<T>();
}
template SceneSummary answer();
template SceneList answer();
template CommandAnswer answer();
template Comparison answer();
template SettingsAnswer answer();
template Log answer();
template SceneEvent answer();
template ChangeEvent answer();
template PickAnswer answer();
template MapAnswer answer();
template PictureAnswer answer();
template FrameEstimate answer();
template FrameCost answer();
template ExportAnswer answer();
template FrameProgressList answer();
template FrameCounters answer();
template TraceReport answer();
template Problem answer();

}  // namespace pelage::testing
