"""Checks the directions of includes against docs/architecture.md: every folder lists what it may see.

usage: include_directions.py ROOT | --self-test
"""
import pathlib
import re
import sys

# folder -> folders that it may include, besides itself. Longest match wins.
ALLOWED = {
    "protocol/base": [],
    "protocol/commands": ["protocol/base"],
    "protocol/json": ["protocol/base", "protocol/commands"],
    "protocol/openapi": ["protocol/base", "protocol/commands", "protocol/json"],
    "server/process": [],
    "server/surface": ["protocol/base", "protocol/commands"],
    "server/patches": ["protocol/base", "protocol/commands", "server/surface"],
    "server/builtin": ["protocol/base", "protocol/commands", "server/surface"],
    "server/import": ["protocol/base", "protocol/commands", "server/surface"],
    "server/import_worker": ["protocol/base", "protocol/commands", "protocol/json", "server/surface", "server/import",
                             "server/guide_files", "server/history", "renderer/image", "renderer/light", "renderer/picture_files"],
    "server/fields": ["protocol/base", "protocol/commands", "server/surface"],
    "server/first_groom": ["protocol/base", "protocol/commands", "server/surface", "server/fields", "server/groom"],
    "server/groom": ["protocol/base", "protocol/commands", "server/surface", "server/patches", "server/import", "server/fields",
                     "server/maps"],
    "server/motion": ["protocol/base", "protocol/commands", "server/fields"],
    "server/guide_files": ["protocol/base", "protocol/commands", "protocol/json"],
    "server/guides": ["protocol/base", "protocol/commands", "server/surface"],
    "server/maps": ["protocol/base", "protocol/commands", "server/surface", "server/import", "server/fields"],
    "server/history": ["protocol/base", "protocol/commands", "protocol/json", "server/surface", "server/patches",
                       "server/fields"],
    "server/scene": ["protocol/base", "protocol/commands", "protocol/json", "server/surface", "server/patches",
                     "server/builtin", "server/import", "server/fields", "server/first_groom", "server/groom", "server/history",
                     "server/guides", "server/maps",
                     "renderer/coat", "renderer/image", "renderer/input", "renderer/picture_files"],
    "server/frames": ["protocol/base", "protocol/commands", "protocol/json", "server/surface", "server/patches",
                      "server/fields", "server/groom", "server/history", "server/motion", "server/scene", "renderer"],
    "server/export": ["protocol/base", "protocol/commands", "server/surface", "server/patches", "server/fields", "server/groom", "server/history", "server/scene",
                      "server/frames", "server/glb", "renderer/coat", "renderer/image", "renderer/input", "renderer/shaders", "renderer/strands"],
    "server/proxy_mesh": ["protocol/base", "protocol/commands", "server/surface", "server/glb"],
    "server/glb": ["protocol/base"],
    "server/studio": [],
    "server/batch": ["protocol", "server/process", "server/surface", "server/groom", "server/history", "server/import", "server/motion", "server/scene", "server/frames",
                     "server/export", "renderer/image", "renderer/picture_files", "renderer/pattern", "renderer/gl/context"],
    "server/calibration": ["protocol/base", "protocol/commands", "server/surface", "server/patches", "server/builtin", "server/fields", "server/first_groom", "server/scene",
                           "server/frames", "renderer"],
    "server/http": ["protocol", "server/log", "server/export", "server/scene", "server/frames", "server/proxy_mesh", "server/studio", "server/import", "server/surface", "server/history"],
    "server/http/transport": ["protocol/base"],
    "server/log": ["protocol/base", "protocol/json"],
    "server": ["protocol", "server", "renderer/gl/context", "renderer/picture_files"],
    "renderer": ["protocol/base", "protocol/commands", "renderer"],
    "renderer/input": ["protocol/base", "protocol/commands"],
    "renderer/coat": ["protocol/base", "protocol/commands", "renderer/shaders"],
    "renderer/pattern": ["protocol/base", "protocol/commands", "renderer/coat"],
    "renderer/shading": ["protocol/base", "protocol/commands", "renderer/shaders"],
    "renderer/eye": ["protocol/base", "protocol/commands", "renderer/shaders", "renderer/input", "renderer/shading"],
    "renderer/curves": ["protocol/base", "protocol/commands", "renderer/input"],
    "renderer/overlay": ["protocol/base", "protocol/commands", "renderer/input", "renderer/image", "renderer/upload"],
    "renderer/skin": ["protocol/base", "protocol/commands", "renderer/input"],
    "renderer/strands": ["protocol/base", "protocol/commands", "renderer/shaders", "renderer/input", "renderer/coat", "renderer/curves",
                         "renderer/image", "renderer/light", "renderer/optics", "renderer/pattern", "renderer/shading", "renderer/skin"],
    "renderer/upload": ["protocol/base", "protocol/commands", "renderer/coat", "renderer/gl", "renderer/input", "renderer/light", "renderer/pattern",
                        "renderer/shaders", "renderer/shading", "renderer/skin"],
    "renderer/shells": ["protocol/base", "protocol/commands", "renderer/coat", "renderer/gl", "renderer/image", "renderer/input", "renderer/pattern",
                        "renderer/shaders", "renderer/shells", "renderer/upload"],
    "renderer/raster/gpu": ["protocol/base", "renderer/finish", "renderer/gl", "renderer/image", "renderer/raster", "renderer/shaders", "renderer/strands"],
    "renderer/raster": ["protocol/base", "renderer/shaders", "renderer/input", "renderer/coat", "renderer/image", "renderer/optics", "renderer/strands", "renderer/upload"],
    "renderer/image": ["protocol/base"],
    "renderer/picture_files": ["protocol/base", "renderer/image"],
    "renderer/picture_files/library": ["protocol/base", "renderer/image", "renderer/picture_files"],
    "renderer/light": ["protocol/base", "protocol/commands"],
    "renderer/compare": ["protocol/base", "protocol/commands", "renderer/image"],
    "renderer/quality": ["protocol/base", "protocol/commands", "renderer/coat", "renderer/input"],
    "renderer/optics": ["protocol/base", "renderer/eye", "renderer/input", "renderer/shaders", "renderer/shading", "renderer/pattern", "renderer/upload"],
    "renderer/finish": ["protocol/base", "protocol/commands", "renderer/image", "renderer/input", "renderer/optics", "renderer/shaders"],
    "renderer/gl": ["protocol/base", "renderer/gl"],
    "clients": ["protocol", "clients"],
    "clients/cli/http": ["protocol/base"],
    "clients/cli/pack": ["protocol"],
    "clients/cli/recipe": ["protocol"],
    "clients/cli/help": [],
    "clients/cli/terminal": ["protocol"],
    "clients/cli/compare": ["protocol", "clients/cli", "renderer/image", "renderer/picture_files", "renderer/compare"],
}
# outside library -> folders that may include it
ONLY_IN = {
    r"httplib\.h": ["server/http", "clients/cli/http"],
    r"nlohmann/.*": ["protocol/json", "clients/cli/recipe"],
    r"CLI/.*": ["server", "clients/cli/line", "clients/cli/help"],
    r"spdlog/.*": ["server/log"],
    r"zip\.h": ["server/import_worker", "clients/cli/pack"],
    r"OpenImageIO/.*": ["renderer/picture_files/library"],
    r"(EGL|GL)/.*": ["renderer/gl"],
    r"embree3/.*": ["server/surface", "renderer/strands"],
    r"hwy/.*": ["renderer/optics", "renderer/raster", "renderer/finish"],
    r"Eigen/.*": ["server/surface", "server/patches", "server/first_groom"],
    r"meshoptimizer\.h": ["server/proxy_mesh"],
    r"sqlite3\.h": ["server/history"],
    r"(tbb|oneapi)/.*": ["protocol/base"],
    r"assimp/.*|tiny_obj_loader\.h|seccomp\.h": ["server/import_worker"],
}


def inside(folder, parent):
    return folder == parent or folder.startswith(parent + "/")


def rule_for(folder):
    return max((f for f in ALLOWED if inside(folder, f)), key=len, default=None)


def problems(path, text):
    folder = str(pathlib.PurePosixPath(path).parent)
    rule = rule_for(folder)
    if rule is None:
        return [f"{path}: no rule for this folder"]
    found = []
    for included in re.findall(r'^\s*#include\s+"([^"]+)"', text, re.M):
        target = str(pathlib.PurePosixPath(included).parent)
        if not any(inside(target, allowed) for allowed in [rule, *ALLOWED[rule]]):
            found.append(f"{path} may not include {included}")
    for included in re.findall(r"^\s*#include\s+<([^>]+)>", text, re.M):
        for pattern, homes in ONLY_IN.items():
            if re.fullmatch(pattern, included) and not any(inside(folder, home) for home in homes):
                found.append(f"{path} may not include <{included}>")
    return found


def self_test():
    assert problems("renderer/coat/a.cpp", '#include "server/scene/scene.h"')
    assert problems("server/groom/a.cpp", '#include "server/scene/scene.h"')
    assert problems("server/groom/a.cpp", "#include <GL/gl.h>")
    assert problems("server/scene/a.cpp", "#include <nlohmann/json.hpp>")
    assert problems("clients/cli/a.cpp", '#include "renderer/compare/compare.h"')
    assert problems("clients/cli/compare/a.cpp", '#include "renderer/frame/renderer.h"')
    assert not problems("clients/cli/compare/a.cpp", '#include "renderer/compare/compare.h"')
    assert not problems("server/groom/a.cpp", '#include "server/fields/field_set.h"\n#include <vector>')
    print("the checker finds what it should")


def main():
    if sys.argv[1] == "--self-test":
        return self_test()
    root = pathlib.Path(sys.argv[1])
    found, count = [], 0
    for top in ("protocol", "server", "renderer", "clients"):
        for path in sorted((root / top).rglob("*")):
            if path.suffix in (".h", ".cpp") and "node_modules" not in path.parts:
                found += problems(path.relative_to(root).as_posix(), path.read_text(encoding="utf-8"))
                count += 1
    print(f"{count} files")
    if found or not count:
        sys.exit("\n".join(found) or "no files found")


main()
