#include <gtest/gtest.h>

#include <span>

#include "server/fields/field_set.h"
#include "server/history/codec.h"

namespace pelage {
namespace {

// Journals store these numbers of fields.
static_assert(static_cast<int>(Field::direction) == 0 && static_cast<int>(Field::density) == 3 &&
              static_cast<int>(Field::mask) == 9 && static_cast<int>(Field::tip_colour) == 11 &&
              static_cast<int>(Field::stiffness) == 12);

TEST(DeltaCodec, RoundTripsAndRefusesDamage) {
  FieldDelta delta{{{Field::direction, {0, 1, 130, 70'000, 4'000'000'000u}, {1, 2, 3, 4, 5, 6, 7, 8, 9, 0xffffffff}},
                    {Field::tip_colour, {7}, {0, 0, 0, 1}}}};
  const std::string bytes = encode_delta(delta);
  const auto decoded = decode_delta(std::as_bytes(std::span(bytes)));
  ASSERT_TRUE(decoded.ok());
  EXPECT_EQ(*decoded, delta);
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    EXPECT_FALSE(decode_delta(std::as_bytes(std::span(bytes.data(), size))).ok()) << size;
  }
  const std::string longer = bytes + "x";
  EXPECT_FALSE(decode_delta(std::as_bytes(std::span(longer))).ok());
  const std::string huge = "\xff\xff\xff\xff\xff\xff\xff\xff\x7f";
  EXPECT_FALSE(decode_delta(std::as_bytes(std::span(huge))).ok());
  const FieldDelta backwards{{delta.parts[1], delta.parts[0]}};
  const std::string disordered = encode_delta(backwards);
  EXPECT_FALSE(decode_delta(std::as_bytes(std::span(disordered))).ok());
  const std::string none = encode_delta({});
  EXPECT_TRUE(decode_delta(std::as_bytes(std::span(none)))->empty());
}

}  // namespace
}  // namespace pelage
