#include "server/fields/field_set.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cassert>
#include <cmath>
#include <limits>
#include <string>

#include "base/random.h"

namespace pelage {

namespace {

static_assert(sizeof(glm::vec2) == 2 * sizeof(float) && alignof(glm::vec2) == alignof(float));

std::uint64_t bits_of(float value) { return std::bit_cast<std::uint32_t>(value); }

/// Returns the value of every channel before anything has touched it.
float default_of(Sheet sheet, Field field) {
  if (sheet == visible_sheet) return shape_of(field).default_value;
  return sheet == base_sheet ? std::numeric_limits<float>::quiet_NaN() : 0.0f;
}

/// Adds the hash of a vertex's channels, two by two, to the sum, or subtracts it.
void add_hash(FieldsHash& sum, const FieldDelta::Part& part, std::uint32_t vertex, const float* channels, bool remove) {
  const int count = shape_of(part.field).channels;
  const float default_value = default_of(part.sheet, part.field);
  for (int c = 0; c < count; c += 2) {
    const float second = c + 1 < count ? channels[c + 1] : default_value;
    if (bits_of(channels[c]) == bits_of(default_value) && bits_of(second) == bits_of(default_value)) continue;
    const std::uint64_t key = (std::uint64_t{part.coat} << 48) | (std::uint64_t{part.sheet} << 40) |
                              (std::uint64_t{vertex} << 8) | (static_cast<std::uint64_t>(part.field) << 2) |
                              static_cast<std::uint64_t>(c);
    const std::uint64_t bits = bits_of(channels[c]) << 32 | bits_of(second);
    const std::uint64_t low = mix_bits(bits ^ mix_bits(key)), high = mix_bits(bits + mix_bits(~key));
    sum.low += remove ? 0 - low : low;
    sum.high += remove ? 0 - high : high;
  }
}

/// Flips the delta's bits in the channels.
void flip(float* channels, const std::uint32_t* flips, int count) {
  for (int c = 0; c < count; ++c)
    channels[c] = std::bit_cast<float>(std::bit_cast<std::uint32_t>(channels[c]) ^ flips[c]);
}

/// Returns whether the array of a part must always exist.
bool never_cleared(const FieldDelta::Part& part) {
  const Field field = part.field;
  return part.coat == 0 && part.sheet == visible_sheet && (field == Field::direction || field == Field::length);
}

bool all_at_default(const std::vector<float>& values, float default_value) {
  return std::all_of(values.begin(), values.end(),
                     [&](float value) { return bits_of(value) == bits_of(default_value); });
}

}  // namespace

glm::vec2 stored_direction(glm::dvec2 direction) {
  if (glm::dot(direction, direction) > 1) direction /= glm::length(direction);
  glm::vec2 rounded(direction);
  const glm::dvec2 wide(rounded);
  if (glm::dot(wide, wide) > 1) rounded = glm::vec2(direction * (1 - 2e-7));  // rounding must not exceed 1
  return rounded + 0.0f;
}

float stored_value(Field field, double value) {
  assert(!std::isnan(value));
  const FieldShape& shape = shape_of(field);
  return static_cast<float>(std::clamp(value, double{shape.min}, double{shape.max})) + 0.0f;
}

Groom stored_groom(glm::dvec2 direction, double length, double stretch) {
  return {stored_direction(direction), stored_value(Field::length, length), stored_value(Field::stretch, stretch)};
}

FieldSet::FieldSet(std::size_t vertices)
    : vertices_(vertices),
      upright_(std::make_shared<std::vector<float>>(2 * vertices, 0.0f)),
      bald_(std::make_shared<std::vector<float>>(vertices, 0.0f)),
      hash_{mix_bits(vertices), mix_bits(~std::uint64_t{vertices})} {
  select(0);
}

FieldSet::FieldSet(const FieldSet&) = default;
FieldSet::FieldSet(FieldSet&&) noexcept = default;
FieldSet& FieldSet::operator=(const FieldSet&) = default;
FieldSet& FieldSet::operator=(FieldSet&&) noexcept = default;
FieldSet::~FieldSet() = default;

void FieldSet::select(CoatId coat) {
  coat_ = coat;
  if (coat >= coats_.size()) coats_.resize(std::size_t{coat} + 1);
  Sheets& sheets = coats_[coat];
  if (sheets.empty()) sheets.resize(1);
  Array& direction = sheets[visible_sheet][static_cast<std::size_t>(Field::direction)];
  Array& length = sheets[visible_sheet][static_cast<std::size_t>(Field::length)];
  if (!direction) direction = upright_;
  if (!length) length = bald_;
}

FieldSet FieldSet::of_coat(CoatId coat) const {
  FieldSet other = *this;
  if (coat != coat_) other.select(coat);
  return other;
}

bool FieldSet::holds(CoatId coat) const {
  if (coat == 0) return true;
  if (coat >= coats_.size()) return false;
  const auto touched = [&](const Array& values) { return values && values != upright_ && values != bald_; };
  return std::ranges::any_of(coats_[coat], [&](const auto& sheet) { return std::ranges::any_of(sheet, touched); });
}

const std::vector<float>& FieldSet::array(Sheet sheet, Field field, CoatId coat) const {
  static const std::vector<float> none;
  if (coat >= coats_.size() || sheet >= coats_[coat].size()) return none;
  const Array& values = coats_[coat][sheet][static_cast<std::size_t>(field)];
  return values ? *values : none;
}

std::vector<float>& FieldSet::touched(Sheet sheet, Field field, CoatId coat) {
  if (coat >= coats_.size()) coats_.resize(std::size_t{coat} + 1);
  if (sheet >= coats_[coat].size()) coats_[coat].resize(std::size_t{sheet} + 1);
  Array& values = coats_[coat][sheet][static_cast<std::size_t>(field)];
  const auto channels = static_cast<std::size_t>(shape_of(field).channels);
  if (!values)
    values = std::make_shared<std::vector<float>>(vertices_ * channels, default_of(sheet, field));
  else if (values.use_count() > 1)
    values = std::make_shared<std::vector<float>>(*values);
  else
    std::atomic_thread_fence(std::memory_order_acquire);  // after the last read by another sharer
  return *values;
}

glm::vec4 FieldSet::value(Field field, std::uint32_t vertex) const { return on_sheet(visible_sheet, field, vertex); }

glm::vec4 FieldSet::on_sheet(Sheet sheet, Field field, std::uint32_t vertex) const {
  return read(sheet, field, owner(field), vertex);
}

glm::vec4 FieldSet::value_of(const FieldDelta::Part& part, std::uint32_t vertex) const {
  return read(part.sheet, part.field, part.coat, vertex);
}

glm::vec4 FieldSet::read(Sheet sheet, Field field, CoatId coat, std::uint32_t vertex) const {
  assert(vertex < vertices_);
  const int channels = shape_of(field).channels;
  const std::vector<float>& values = array(sheet, field, coat);
  if (values.empty()) {
    const float default_value = default_of(sheet, field);
    return {default_value, channels > 1 ? default_value : 0, channels > 2 ? default_value : 0,
            channels > 3 ? default_value : 0};
  }
  const float* stored = &values[vertex * static_cast<std::size_t>(channels)];
  return {stored[0], channels > 1 ? stored[1] : 0, channels > 2 ? stored[2] : 0, channels > 3 ? stored[3] : 0};
}

bool FieldSet::untouched(Sheet sheet, Field field) const { return array(sheet, field, owner(field)).empty(); }

float FieldSet::number(Field field, std::uint32_t vertex) const {
  assert(vertex < vertices_ && shape_of(field).channels == 1);
  const std::vector<float>& all = values(field);
  return all.empty() ? shape_of(field).default_value : all[vertex];
}

Groom FieldSet::at(std::uint32_t vertex) const {
  return {direction()[vertex], length()[vertex], number(Field::stretch, vertex)};
}

std::span<const glm::vec2> FieldSet::direction() const {
  return {reinterpret_cast<const glm::vec2*>(values(Field::direction).data()), vertices_};
}

std::span<const glm::vec4> FieldSet::colours(Field field) const {
  assert(shape_of(field).channels == 4);
  return {reinterpret_cast<const glm::vec4*>(values(field).data()), values(field).size() / 4};
}

void FieldSet::set(Field field, std::uint32_t vertex, glm::vec4 value) {
  assert(vertex < vertices_);
  const auto channels = static_cast<std::size_t>(shape_of(field).channels);
  float* stored = &touched(visible_sheet, field, owner(field))[vertex * channels];
  const FieldDelta::Part part{field, {}, {}, visible_sheet, owner(field)};
  add_hash(hash_, part, vertex, stored, true);
  for (std::size_t c = 0; c < channels; ++c) stored[c] = value[static_cast<int>(c)] + 0.0f;
  add_hash(hash_, part, vertex, stored, false);
}

void FieldSet::set(std::uint32_t vertex, const Groom& groom) {
  set(Field::direction, vertex, {groom.direction, 0, 0});
  set(Field::length, vertex, {groom.length, 0, 0, 0});
  if (groom.stretch != number(Field::stretch, vertex)) set(Field::stretch, vertex, {groom.stretch, 0, 0, 0});
}

FieldsHash FieldSet::hash_after(const FieldDelta& delta) const {
  FieldsHash hash = hash_;
  for (const FieldDelta::Part& part : delta.parts) {
    const int channels = shape_of(part.field).channels;
    const std::uint32_t* flips = part.flips.data();
    for (const std::uint32_t v : part.vertices) {
      glm::vec4 stored = value_of(part, v);
      add_hash(hash, part, v, &stored.x, true);
      flip(&stored.x, flips, channels);
      add_hash(hash, part, v, &stored.x, false);
      flips += channels;
    }
  }
  return hash;
}

bool FieldSet::accepts(const FieldDelta& delta) const {
  return std::all_of(delta.parts.begin(), delta.parts.end(),
                     [&](const FieldDelta::Part& part) { return part.vertices.back() < vertices_; });
}

void FieldSet::apply(const FieldDelta& delta) {
  assert(accepts(delta));
  for (const FieldDelta::Part& part : delta.parts) {
    const auto channels = static_cast<std::size_t>(shape_of(part.field).channels);
    std::vector<float>& values = touched(part.sheet, part.field, part.coat);
    const std::uint32_t* flips = part.flips.data();
    const float default_value = default_of(part.sheet, part.field);
    bool to_default = true;
    for (const std::uint32_t v : part.vertices) {
      float* stored = &values[v * channels];
      add_hash(hash_, part, v, stored, true);
      flip(stored, flips, static_cast<int>(channels));
      add_hash(hash_, part, v, stored, false);
      flips += channels;
      for (std::size_t c = 0; c < channels; ++c)
        to_default = to_default && bits_of(stored[c]) == bits_of(default_value);
    }
    // Frees a field that is back at its default everywhere, so that it takes no drawing time and no memory.
    if (to_default && !never_cleared(part) && all_at_default(values, default_value))
      coats_[part.coat][part.sheet][static_cast<std::size_t>(part.field)].reset();
  }
}

std::size_t FieldSet::bytes() const {
  std::size_t sum = 0;
  for (const Sheets& sheets : coats_) {
    for (const auto& sheet : sheets) {
      for (const Array& values : sheet) sum += values ? values->size() * sizeof(float) : 0;
    }
  }
  return sum;
}

static FieldDelta::Part difference(const FieldSet& from, const FieldSet& to, FieldDelta::Part part) {
  for (std::uint32_t v = 0; v < from.size(); ++v) put_change(part, v, from.value_of(part, v), to.value_of(part, v));
  return part;
}

FieldDelta difference(const FieldSet& from, const FieldSet& to) {
  assert(from.size() == to.size());
  FieldDelta delta;
  for (std::size_t s = 0; s < sheet_count; ++s) {
    for (std::size_t c = 0; c < std::max(from.coats(), to.coats()); ++c) {
      const FieldSet first = from.of_coat(static_cast<CoatId>(c)), second = to.of_coat(static_cast<CoatId>(c));
      for (std::size_t f = 0; f < field_count; ++f) {
        const auto sheet = static_cast<Sheet>(s);
        if (first.owner(field_at(f)) != c) continue;
        if (first.untouched(sheet, field_at(f)) && second.untouched(sheet, field_at(f))) continue;
        FieldDelta::Part part = difference(from, to, {field_at(f), {}, {}, sheet, static_cast<CoatId>(c)});
        if (!part.vertices.empty()) delta.parts.push_back(std::move(part));
      }
    }
  }
  return delta;
}

namespace {

/// Adds a part to a field's change, in which `mean_change` is still a sum.
void add_part(const FieldDelta::Part& part, const FieldSet& fields, FieldChange& change) {
  const int channels = shape_of(part.field).channels;
  const std::uint32_t* flips = part.flips.data();
  change.changed += part.vertices.size();
  for (const std::uint32_t v : part.vertices) {
    const glm::vec4 here = fields.value_of(part, v);
    double square = 0;
    for (int c = 0; c < channels; ++c) {
      const double there = std::bit_cast<float>(std::bit_cast<std::uint32_t>(here[c]) ^ flips[c]);
      square += (there - here[c]) * (there - here[c]);
    }
    flips += channels;
    change.mean_change += std::sqrt(square);
    change.max_change = std::max(change.max_change, std::sqrt(square));
  }
}

}  // namespace

std::vector<FieldChange> measure(const FieldDelta& delta, const FieldSet& fields) {
  std::array<FieldChange, field_count> by_field;
  for (const FieldDelta::Part& part : delta.parts) {
    if (part.sheet == visible_sheet) add_part(part, fields, by_field[static_cast<std::size_t>(part.field)]);
  }
  std::vector<FieldChange> changes;
  for (std::size_t f = 0; f < field_count; ++f) {
    if (by_field[f].changed == 0) continue;
    by_field[f].field = shape_of(field_at(f)).name;
    by_field[f].mean_change /= static_cast<double>(by_field[f].changed);
    changes.push_back(std::move(by_field[f]));
  }
  return changes;
}

}  // namespace pelage
