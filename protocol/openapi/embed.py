"""Turns openapi.yaml into a C++ source that holds it as JSON: embed.py INPUT.yaml OUTPUT.cpp"""

import json
import sys

import yaml

PIECE = 8000  # compilers bound the length of one string literal


def main(source, target):
    with open(source, encoding="utf-8") as file:
        text = json.dumps(yaml.safe_load(file), ensure_ascii=True, separators=(",", ":"))
    pieces = [text[i:i + PIECE] for i in range(0, len(text), PIECE)]
    lines = [f'    R"json~({piece})json~"' for piece in pieces]
    with open(target, "w", encoding="utf-8") as file:
        file.write('#include "protocol/openapi/openapi.h"\n\n#include <string>\n\nnamespace pelage {\n\n')
        file.write("namespace {\n\nconstexpr std::string_view pieces[] = {\n" + ",\n".join(lines) + "};\n\n")
        file.write("}  // namespace\n\nstd::string_view openapi_json() {\n  static const std::string text = [] {\n")
        file.write("    std::string joined;\n    for (const std::string_view piece : pieces) joined += piece;\n")
        file.write("    return joined;\n  }();\n  return text;\n}\n\n}  // namespace pelage\n")


if __name__ == "__main__":
    main(*sys.argv[1:])
