#include "server/http/accept_encoding.h"

#include <gtest/gtest.h>

namespace pelage {
namespace {

constexpr auto identity = ContentCoding::identity, gzip = ContentCoding::gzip, brotli = ContentCoding::brotli;

std::optional<ContentCoding> of_both(std::string_view accepted) { return choose_encoding(accepted, true, true); }

TEST(AcceptEncoding, BrotliThenGzipAmongEquals) {
  EXPECT_EQ(of_both("gzip, deflate, br, zstd"), brotli);
  EXPECT_EQ(of_both("gzip, deflate"), gzip);
  EXPECT_EQ(of_both("*"), brotli);
  EXPECT_EQ(of_both("br;q=1.0,gzip;q=1.000,identity"), brotli);
}

TEST(AcceptEncoding, NothingSaidIsIdentity) {
  for (const char* text : {"", " ", ",", "deflate", "zstd;q=1", "identity"}) EXPECT_EQ(of_both(text), identity) << text;
}

TEST(AcceptEncoding, WeightsDecide) {
  EXPECT_EQ(of_both("br;q=0.5, gzip;q=0.8"), gzip);
  EXPECT_EQ(of_both("br;q=0.5, gzip;q=0.8, identity;q=0.9"), identity);
  EXPECT_EQ(of_both("gzip;q=0.001"), gzip) << "identity is only taken where nothing else is there";
  EXPECT_EQ(of_both("gzip;q=0.3, *;q=0.2"), gzip);
  EXPECT_EQ(of_both("gzip;q=0.3, *;q=0.4"), brotli);
}

TEST(AcceptEncoding, AWeightOfZeroRefuses) {
  EXPECT_EQ(of_both("br;q=0, gzip;q=0.000"), identity);
  EXPECT_EQ(of_both("br;q=0, *"), gzip);
  EXPECT_EQ(of_both("*;q=0, gzip"), gzip);
  EXPECT_EQ(of_both("*;q=0, identity;q=0.1"), identity);
  EXPECT_EQ(of_both("*;q=0"), std::nullopt);
  EXPECT_EQ(of_both("identity;q=0"), std::nullopt);
  EXPECT_EQ(of_both("identity;q=0, br;q=0.1"), brotli);
}

TEST(AcceptEncoding, ChoosesOnlyAvailableCodings) {
  EXPECT_EQ(choose_encoding("br, gzip", true, false), gzip);
  EXPECT_EQ(choose_encoding("br, gzip", false, true), brotli);
  EXPECT_EQ(choose_encoding("br, gzip;q=0.5", false, false), identity);
  EXPECT_EQ(choose_encoding("*", false, false), identity);
  EXPECT_EQ(choose_encoding("br, identity;q=0", true, false), std::nullopt);
}

TEST(AcceptEncoding, CaseAndSpacesDoNotCountAndWhatCannotBeReadIsPassedOver) {
  EXPECT_EQ(of_both(" BR ; Q=0.5 ,\tGZip "), gzip);
  EXPECT_EQ(of_both("x-gzip"), gzip);
  for (const char* bad : {"br;q=2", "br;q=-1", "br;q=", "br;q=x", "br;level=3", "br;q=nan", "b r"}) {
    EXPECT_EQ(of_both(std::string(bad) + ", gzip;q=0.1"), gzip) << bad;
  }
}

}  // namespace
}  // namespace pelage
