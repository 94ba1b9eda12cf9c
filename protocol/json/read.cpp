#include "protocol/json/read.h"

#include <algorithm>
#include <cmath>

#include "protocol/json/members_answers.h"
#include "protocol/json/members_calibration.h"
#include "protocol/json/members_frame.h"
#include "protocol/json/members_job.h"
#include "protocol/json/members_scene.h"
#include "protocol/json/members_settings.h"
#include "protocol/json/rules.h"

namespace pelage::json_parts {

namespace {

void get(const Value& value, Backdrop<false> out) {
  const nlohmann::json& tree = value.tree();
  out.kind = tree == "transparent" ? Background::transparent
             : tree == "studio"    ? Background::studio
                                   : Background::colour;
  if (out.kind == Background::colour) out.colour = value.colour();
}

/// Reads a tier's name, or knobs whose other members are those of the interactive tier.
void get(const Value& value, Knobs& out) {
  out = value.tree().is_object() ? read<Knobs>(value) : knobs_of(value.name_of(json_names::tiers));
}

void get(const Value& value, std::optional<Tracing>& out) {
  if (value.tree().is_object()) {
    out = read<Tracing>(value);
  } else if (value.boolean()) {
    out = Tracing{};
  }
}

SurfaceSample surface_sample(Object& object) {
  SurfaceSample sample;
  object.required("triangle",
                  [&](const Value& v) { sample.triangle = static_cast<std::uint32_t>(v.integer(uint32_range)); });
  object.required("barycentric", [&](const Value& v) {
    sample.barycentric = v.triple(share);
    const double sum = sample.barycentric.x + sample.barycentric.y + sample.barycentric.z;
    if (std::abs(sum - 1) > 1e-3) v.refuse("The barycentrics do not add up to 1.", "sum within 0.001 of 1");
  });
  return sample;
}

/// Fills a struct from the members of an object.
class MemberReader {
 public:
  static constexpr bool reads = false;  // the struct is written to
  explicit MemberReader(Object& object) : object_(object) {}

  void type(const char*, const char* = "") {}
  void answer(const char*, const char* = "") { all_required_ = true; }
  bool takes(bool condition) { return condition; }
  bool shows(bool) { return true; }  // rules say which members exclude each other
  bool has(const char* name, bool) { return object_.has(name); }

  template <class T>
  void number(MemberName name, T& out, Range range, const char* = "") {
    member(name, [&](const Value& v) { out = v.number(range); });
  }
  void number_or(const char* word, MemberName name, std::optional<double>& out, Range range, const char* = "") {
    member(name, [&](const Value& v) {
      const std::string quoted = "\"" + std::string(word) + "\"";
      if (v.tree().is_string() && v.tree() == word) return;
      if (!v.tree().is_number())
        return v.refuse("A number or " + quoted + " is expected.", std::string(word) + " | " + range.text());
      out = v.number(range);
    });
  }
  void numbers(MemberName name, std::vector<double>& out, Range range, Count count, const char* = "") {
    member(name, [&](const Value& list) {
      for (const Value& v : list.list(count.min, count.max)) out.push_back(v.number(range));
    });
  }
  void integers(MemberName name, std::vector<int>& out, Range range, Count count, const char* = "") {
    member(name, [&](const Value& list) {
      for (const Value& v : list.list(count.min, count.max)) out.push_back(static_cast<int>(v.integer(range)));
    });
  }
  void integer(MemberName name, int& out, Range range, const char* = "") {
    member(name, [&](const Value& v) { out = static_cast<int>(v.integer(range)); });
  }
  void seed(MemberName name, std::uint32_t& out, const char* = "") {
    member(name, [&](const Value& v) { out = static_cast<std::uint32_t>(v.integer(uint32_range)); });
  }
  template <class T>
  void counter(MemberName name, T& out, const char* = "") {
    member(name, [&](const Value& v) { out = v.counter(); });
  }
  template <class T>
  void boolean(MemberName name, T& out, const char* = "") {
    member(name, [&](const Value& v) { out = v.boolean(); });
  }
  template <class T>
  void text(MemberName name, T& out, const char* = "", std::size_t max_bytes = limits::name_bytes) {
    member(name, [&](const Value& v) { out = v.text(0, max_bytes); });
  }
  void texts(MemberName name, std::vector<std::string>& out, const char* = "") {
    member(name, [&](const Value& list) {
      for (const Value& v : list.list(0, any_count.max)) out.push_back(v.text(0, any_length));
    });
  }
  void label(MemberName name, std::string& out, const char* = "") {
    member(name, [&](const Value& v) { out = v.text(1, limits::name_bytes); });
  }
  void picture(MemberName name, std::string& out, const char* = "", const char* word_for_none = nullptr) {
    member(name, [&](const Value& v) {
      if (word_for_none && v.tree() == word_for_none) return;
      out = v.text(1, 32);
      if (!hash_of_hex(out))
        v.refuse("This names no picture.",
                 (word_for_none ? word_for_none + std::string(", or ") : "") + "32 hex digits in lower case");
    });
  }
  void hash(MemberName name, FieldsHash& out, const char* = "") {
    member(name, [&](const Value& v) {
      const std::optional<FieldsHash> hash = hash_of_hex(v.text(32, 32));
      if (hash) out = *hash;
      if (!hash) v.refuse("This is no hash.", "32 hex digits in lower case");
    });
  }
  /// Keeps any JSON, as text.
  void json(MemberName name, std::string& out, const char* = "") {
    member(name, [&](const Value& v) { out = v.tree().dump(); });
  }
  /// The same for JSON that is no object; the schema says so.
  void any(MemberName name, std::string& out, const char* words = "") { json(name, out, words); }
  /// Keeps a T as JSON text, for others to decode.
  template <class T>
  void document(MemberName name, std::string& out, const char* words = "") {
    json(name, out, words);
  }
  template <class T>
  void position(MemberName name, T& out, const char* = "") {
    member(name, [&](const Value& v) { out = v.triple(coordinate); });
  }
  template <glm::length_t N>
  void vector(MemberName name, glm::vec<N, double>& out, Range range, const char* = "") {
    member(name, [&](const Value& list) {
      const std::vector<Value> parts = list.list(N, N);
      for (std::size_t i = 0; i < parts.size(); ++i) out[static_cast<glm::length_t>(i)] = parts[i].number(range);
    });
  }
  void vectors(MemberName name, std::optional<SphericalHarmonics>& out, Range range, const char* = "") {
    member(name, [&](const Value& list) {
      const std::vector<Value> vectors = list.list(out.emplace().size(), out->size());
      for (std::size_t i = 0; i < vectors.size(); ++i) (*out)[i] = vectors[i].triple(range);
    });
  }
  void pixel(MemberName name, glm::dvec2& out, const View& view, const char* = "") {
    member(name, [&](const Value& list) {
      const std::vector<Value> parts = list.list(2, 2);
      if (parts.empty()) return;
      out = {parts[0].number({0, static_cast<double>(view.width)}),
             parts[1].number({0, static_cast<double>(view.height)})};
    });
  }
  template <class T>
  void direction(MemberName name, T& out, const char* = "") {
    member(name, [&](const Value& v) { out = v.direction(); });
  }
  void colour(MemberName name, glm::vec3& out, const char* = "") {
    member(name, [&](const Value& v) { out = v.colour(); });
  }
  template <class E, std::size_t N>
  void name(MemberName name, E& out, const std::array<json_names::Name<E>, N>& names, const char* = "") {
    member(name, [&](const Value& v) { out = v.name_of(names); });
  }
  template <class E, std::size_t N>
  void name(MemberName name, std::optional<E>& out, const std::array<json_names::Name<E>, N>& names, const char* = "") {
    member(name, [&](const Value& v) { out = v.name_of(names); });
  }
  template <class E, std::size_t N>
  void word(MemberName name, std::string& out, const std::array<json_names::Name<E>, N>& names, const char* = "") {
    member(name, [&](const Value& v) { out = v.word_of(texts_of(names)); });
  }
  /// Reads a list of names, each at most once; `noun` is what a message calls one of them.
  template <class E, std::size_t N>
  void names(MemberName name, std::vector<E>& out, const std::array<json_names::Name<E>, N>& names, std::size_t min,
             const std::string& noun, const char* = "") {
    member(name, [&](const Value& list) {
      out.clear();
      for (const Value& v : list.list(min, N)) {
        const E one = v.name_of(names);
        if (std::count(out.begin(), out.end(), one) > 0)
          v.refuse("The " + noun + " is named twice.", "each " + noun + " once");
        out.push_back(one);
      }
    });
  }
  template <class T>
  void object(MemberName name, T& out, const char* = "") {
    member(name, [&](const Value& v) { out = read<T>(v); });
  }
  template <class T>
  void object(MemberName name, std::optional<T>& out, const char* = "") {
    member(name, [&](const Value& v) { out = read<T>(v); });
  }
  template <class T>
  void objects(MemberName name, std::vector<T>& out, Count count, const char* = "") {
    member(name, [&](const Value& list) {
      out.clear();
      for (const Value& v : list.list(count.min, count.max)) out.push_back(read<T>(v));
    });
  }
  void curves(MemberName name, std::vector<std::vector<glm::dvec3>>& out, Count count, Count points, const char* = "") {
    member(name, [&](const Value& list) {
      for (const Value& v : list.list(count.min, count.max)) {
        std::vector<glm::dvec3>& curve = out.emplace_back();
        for (const Value& point : v.list(points.min, points.max)) curve.push_back(point.triple(coordinate));
      }
    });
  }
  template <class T, class Variant>
  void alternative(MemberName name, Variant& out, const char* = "") {
    member(name, [&](const Value& v) { out = read<T>(v), count_alternative(v); });
  }
  template <class Variant>
  void alternative(MemberName name, Variant& out, Range range, const char* = "") {
    member(name, [&](const Value& v) { out = v.number(range), count_alternative(v); });
  }
  template <class Variant>
  void vertices(MemberName name, Variant& out, const char* = "") {
    member(name, [&](const Value& list) {
      MaskVertices chosen;
      for (const Value& v : list.list(1, limits::mask_vertices))
        chosen.vertices.push_back(static_cast<std::uint32_t>(v.integer(uint32_range)));
      out = std::move(chosen), count_alternative(list);
    });
  }
  /// Reads a member with a JSON form of its own, by an overload of get().
  template <class T>
  void special(MemberName name, T&& out, const char* = "") {
    member(name, [&](const Value& v) { get(v, out); });
  }
  /// Reads the position of a sample: one of three forms, whose members belong to the sample itself.
  void sample_position(std::variant<PositionSample, ScreenSample, SurfaceSample>& out) {
    int forms = 0;
    member("position", [&](const Value& v) { out = PositionSample{v.triple(coordinate)}, ++forms; });
    member("screen", [&](const Value& v) { out = ScreenSample{v.pair(screen_coordinate)}, ++forms; });
    const bool triangle = object_.has("triangle"), barycentric = object_.has("barycentric");
    if (triangle || barycentric) out = surface_sample(object_), ++forms;
    if (forms != 1)
      object_.value().refuse("A sample needs exactly one form of position.",
                             "one of position | screen | triangle with barycentric");
  }

 private:
  template <class Read>
  void member(MemberName name, Read read) {
    if (is_required(name, all_required_)) return object_.required(name.text, read);
    object_.optional(name.text, read);
  }
  void count_alternative(const Value& value) {
    if (++alternatives_ > 1) value.refuse("There is another shape beside this one.", "one shape");
  }

  Object& object_;
  bool all_required_ = false;  // of an answer: all members except sparse and bare ones
  int alternatives_ = 0;
};

using CommandReader = Command (*)(Object&);

struct NamedReader {
  std::string_view name;
  CommandReader read;
};

template <class Tool>
Command read_command(Object& object) {
  MemberReader reader(object);
  Tool tool;
  members(reader, tool);
  Command command(std::move(tool));
  check_command(object.value(), command);
  return command;
}

template <class... Tools>
std::vector<NamedReader> list_readers(std::variant<Tools...>*) {
  return {{op_of(Command(Tools{})), read_command<Tools>}...};
}

const std::vector<NamedReader>& command_readers() {
  static const std::vector<NamedReader> readers = list_readers(static_cast<Command*>(nullptr));
  return readers;
}

}  // namespace

template <>
Command read<Command>(const Value& value) {
  Object object(value);
  CommandReader read_one = nullptr;
  object.required("op", [&](const Value& v) {
    std::vector<std::string_view> known;
    for (const NamedReader& reader : command_readers()) known.push_back(reader.name);
    const std::string word = v.word_of(known);
    for (const NamedReader& reader : command_readers()) {
      if (reader.name == word) read_one = reader.read;
    }
  });
  if (!read_one || !value.ok()) return {};
  Command result = read_one(object);
  object.finish();
  return result;
}

template <class T>
T read(const Value& value) {
  Object object(value);
  MemberReader reader(object);
  T result{};
  members(reader, result);
  object.finish();
  set_dependent_defaults(value, result);
  check(value, result);
  return result;
}

template NewScene read(const Value&);
template FrameRequest read(const Value&);
template RenderJob read(const Value&);
template Tracing read(const Value&);
template PickRequest read(const Value&);
template RecipeRequest read(const Value&);
template StepsBody read(const Value&);
template RevisionBody read(const Value&);
template Revisions read(const Value&);
template AtRevision read(const Value&);
template Subdivide read(const Value&);
template TurnModel read(const Value&);
template SceneName read(const Value&);
template BranchRequest read(const Value&);
template AmendRequest read(const Value&);
template Batch read(const Value&);
template ImportOptions read(const Value&);
template EnvironmentUpload read(const Value&);
template MeshRequest read(const Value&);
template ExportRequest read(const Value&);
template MapRequest read(const Value&);
template MapUpload read(const Value&);
template GuideUpload read(const Value&);
template Calibration read(const Value&);
template SceneSummary read(const Value&);
template SceneList read(const Value&);
template CommandAnswer read(const Value&);
template Comparison read(const Value&);
template SettingsAnswer read(const Value&);
template Log read(const Value&);
template SceneEvent read(const Value&);
template ChangeEvent read(const Value&);
template PickAnswer read(const Value&);
template RecipeAnswer read(const Value&);
template MapAnswer read(const Value&);
template PictureAnswer read(const Value&);
template FrameEstimate read(const Value&);
template FrameCost read(const Value&);
template ExportAnswer read(const Value&);
template FrameProgressList read(const Value&);
template FrameCounters read(const Value&);
template TraceReport read(const Value&);
template Problem read(const Value&);

}  // namespace pelage::json_parts
