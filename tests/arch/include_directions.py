"""Checks the directions of includes against docs/architecture.md: each folder may include only the folders that are listed for it.

usage: include_directions.py ROOT
"""
import pathlib
import re
import sys

# folder -> folders that it may include, besides itself. Longest match wins.
ALLOWED = {
    "base": [],
    "protocol/commands": ["base"],
    "protocol/json": ["base", "protocol/commands"],
    "protocol/recipes": ["base", "protocol/commands", "protocol/json"],
    "protocol/openapi": ["base", "protocol/commands", "protocol/json"],
    "server/process": [],
    "server/surface": ["base", "protocol/commands"],
    "server/patches": ["base", "protocol/commands", "server/surface"],
    "server/builtin": ["base", "protocol/commands", "server/surface"],
    "server/import": ["base", "protocol/commands", "server/surface"],
    "server/import_worker": ["base", "protocol/commands", "protocol/json", "server/surface", "server/import",
                             "server/guide_files", "server/history", "renderer/image", "renderer/light", "renderer/picture_files"],
    "server/fields": ["base", "protocol/commands", "server/surface"],
    "server/groom": ["base", "protocol/commands", "server/surface", "server/patches", "server/import", "server/fields",
                     "server/maps"],
    "server/motion": ["base", "protocol/commands", "server/fields"],
    "server/guide_files": ["base", "protocol/commands", "protocol/json"],
    "server/guides": ["base", "protocol/commands", "server/surface"],
    "server/maps": ["base", "protocol/commands", "server/surface", "server/import", "server/fields"],
    "server/history": ["base", "protocol/commands", "protocol/json", "server/surface", "server/patches",
                       "server/fields"],
    "server/scene": ["base", "protocol/commands", "protocol/json", "server/surface", "server/patches",
                     "server/builtin", "server/import", "server/fields", "server/groom", "server/history",
                     "server/guides", "server/maps",
                     "renderer/coat", "renderer/image", "renderer/input", "renderer/picture_files"],
    "server/frames": ["base", "protocol/commands", "protocol/json", "server/surface", "server/patches",
                      "server/builtin", "server/fields", "server/import", "server/groom", "server/history", "server/motion", "server/scene", "renderer"],
    "server/export": ["base", "protocol/commands", "server/surface", "server/patches", "server/fields", "server/groom", "server/history", "server/scene",
                      "server/frames", "renderer/coat", "renderer/image", "renderer/input", "renderer/shaders", "renderer/strands"],
    "server/batch": ["base", "protocol", "server/process", "server/surface", "server/groom", "server/history", "server/import", "server/motion", "server/scene", "server/frames",
                     "server/export", "renderer/image", "renderer/picture_files", "renderer/pattern", "renderer/gl/context"],
    "server/http": ["base", "protocol", "server/log", "server/export", "server/scene", "server/frames", "server/import", "server/surface", "server/history"],
    "server/http/transport": ["base"],
    "server/log": ["base", "protocol/json"],
    "server": ["base", "protocol", "server", "renderer/gl/context", "renderer/picture_files"],
    "renderer": ["base", "protocol/commands", "renderer"],
    "renderer/input": ["base", "protocol/commands"],
    "renderer/coat": ["base", "protocol/commands", "renderer/shaders"],
    "renderer/pattern": ["base", "protocol/commands", "renderer/coat"],
    "renderer/shading": ["base", "protocol/commands", "renderer/shaders"],
    "renderer/eye": ["base", "protocol/commands", "renderer/shaders", "renderer/input", "renderer/shading"],
    "renderer/curves": ["base", "protocol/commands", "renderer/input"],
    "renderer/overlay": ["base", "protocol/commands", "renderer/input", "renderer/image", "renderer/upload"],
    "renderer/skin": ["base", "protocol/commands", "renderer/input"],
    "renderer/strands": ["base", "protocol/commands", "renderer/shaders", "renderer/input", "renderer/coat", "renderer/curves",
                         "renderer/image", "renderer/light", "renderer/optics", "renderer/pattern", "renderer/shading", "renderer/skin"],
    "renderer/upload": ["base", "protocol/commands", "renderer/coat", "renderer/gl", "renderer/input", "renderer/light", "renderer/pattern",
                        "renderer/shaders", "renderer/shading", "renderer/skin"],
    "renderer/shells": ["base", "protocol/commands", "renderer/coat", "renderer/gl", "renderer/image", "renderer/input", "renderer/pattern",
                        "renderer/shaders", "renderer/shells", "renderer/upload"],
    "renderer/raster/gpu": ["base", "renderer/finish", "renderer/gl", "renderer/image", "renderer/raster", "renderer/shaders", "renderer/strands"],
    "renderer/raster": ["base", "renderer/shaders", "renderer/input", "renderer/coat", "renderer/image", "renderer/optics", "renderer/strands", "renderer/upload"],
    "renderer/image": ["base"],
    "renderer/picture_files": ["base", "renderer/image"],
    "renderer/picture_files/library": ["base", "renderer/image", "renderer/picture_files"],
    "renderer/light": ["base", "protocol/commands"],
    "renderer/compare": ["base", "protocol/commands", "renderer/image"],
    "renderer/quality": ["base", "protocol/commands", "renderer/coat", "renderer/input"],
    "renderer/optics": ["base", "renderer/eye", "renderer/input", "renderer/shaders", "renderer/shading", "renderer/pattern", "renderer/upload"],
    "renderer/finish": ["base", "protocol/commands", "renderer/image", "renderer/input", "renderer/optics", "renderer/shaders"],
    "renderer/gl": ["base", "renderer/gl"],
    "clients": ["base", "protocol", "clients"],
    "clients/cli/http": ["base"],
    "clients/cli/pack": ["base", "protocol"],
    "clients/cli/recipe": ["base", "protocol"],
    "clients/cli/help": [],
    "clients/cli/terminal": ["base", "protocol"],
    "clients/cli/compare": ["base", "protocol", "clients/cli", "renderer/image", "renderer/picture_files", "renderer/compare"],
}
# header of an external library -> folders that may include it
ONLY_IN = {
    r"httplib\.h": ["server/http", "clients/cli/http"],
    r"nlohmann/.*": ["protocol/json", "protocol/recipes", "clients/cli/recipe", "server/export"],
    r"CLI/.*": ["server", "clients/cli/line", "clients/cli/help"],
    r"spdlog/.*": ["server/log"],
    r"zip\.h": ["server/import_worker", "clients/cli/pack"],
    r"OpenImageIO/.*": ["renderer/picture_files/library"],
    r"(EGL|GL)/.*": ["renderer/gl"],
    r"embree3/.*": ["server/surface", "renderer/strands"],
    r"hwy/.*": ["renderer/optics", "renderer/raster", "renderer/finish"],
    r"Eigen/.*": ["server/surface", "server/patches", "server/groom"],
    r"meshoptimizer\.h": ["server/export"],
    r"sqlite3\.h": ["server/history"],
    r"(tbb|oneapi)/.*": ["base"],
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


def main():
    root = pathlib.Path(sys.argv[1])
    found, count = [], 0
    for top in ("base", "protocol", "server", "renderer", "clients"):
        for path in sorted((root / top).rglob("*")):
            if path.suffix in (".h", ".cpp") and "node_modules" not in path.parts:
                found += problems(path.relative_to(root).as_posix(), path.read_text(encoding="utf-8"))
                count += 1
    print(f"{count} files")
    if found or not count:
        sys.exit("\n".join(found) or "no files found")


main()
