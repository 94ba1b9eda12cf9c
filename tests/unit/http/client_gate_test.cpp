#include "server/http/client_gate.h"

#include <gtest/gtest.h>

namespace pelage {
namespace {

TEST(ClientGate, OneClientLeavesPlacesForOthers) {
  ClientGate gate(4, 2);
  const auto first = gate.enter("a"), second = gate.enter("a"), third = gate.enter("a"), other = gate.enter("b");
  EXPECT_TRUE(first && second);
  EXPECT_FALSE(third);
  EXPECT_TRUE(other);
}

TEST(ClientGate, AllClientsTogetherAreBounded) {
  ClientGate gate(3, 2);
  const auto a = gate.enter("a"), b = gate.enter("b"), c = gate.enter("c");
  EXPECT_TRUE(a && b && c);
  EXPECT_FALSE(gate.enter("d"));
}

TEST(ClientGate, APlaceThatIsLeftIsFree) {
  ClientGate gate(2, 1);
  for (int k = 0; k < 5; ++k) {
    const auto one = gate.enter("a");
    EXPECT_TRUE(one);
    EXPECT_FALSE(gate.enter("a"));
  }
  EXPECT_TRUE(gate.enter("b") && gate.enter("a"));
}

TEST(ClientGate, ClientsBehindOneAddressAreToldApartByAuthor) {
  httplib::Request ann, ben, nobody;
  ann.remote_addr = ben.remote_addr = nobody.remote_addr = "127.0.0.1";
  ann.headers.emplace("Pelage-Author", "Ann");
  ben.headers.emplace("Pelage-Author", "Ben");
  EXPECT_NE(client_of(ann), client_of(ben));
  EXPECT_NE(client_of(ann), client_of(nobody));
  EXPECT_EQ(client_of(ann), client_of(ann));
}

}  // namespace
}  // namespace pelage
