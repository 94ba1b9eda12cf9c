// pelage-compare: the program that `pelage compare` starts with the same command line. It is separate because the
// picture readers link some 250 libraries that take .15 s to load, and no other action of the client needs them.
#include <cstdio>

#include "clients/cli/compare/compare_pictures.h"

int main(int argc, char** argv) {
  const auto [exit_code, options] = pelage::parse_line(argc, argv);
  if (exit_code) return *exit_code;
  if (options.action == pelage::Action::compare) return pelage::compare_pictures(options);
  std::fputs("pelage-compare: only for `compare`; the rest is done by pelage\n", stderr);
  return pelage::wrong_use;
}
