// Prints the schemas of requests and answers; the build puts them into the contract.
#include <cstdio>

#include "protocol/json/schema.h"

int main() { return std::puts(pelage::schemas().dump().c_str()) < 0; }
