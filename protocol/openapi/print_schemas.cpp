// Prints the schemas of the requests; the build puts them into the contract.
#include <cstdio>

#include "protocol/json/schema.h"

int main() { return std::puts(pelage::request_schemas().dump().c_str()) < 0; }
