"""Finds replaced words, so that they do not come back: each thing has one word. docs/notes/ and CHANGELOG.md describe the past and
may use any word.

usage: words.py ROOT
"""
import pathlib
import re
import subprocess
import sys

# Old word -> (new word, pattern of the old word, pattern of the paths to search). PARTS wraps each pattern, so that a part of an
# identifier counts as a word.
EVERYWHERE = r""
PARTS = r"(?<![A-Za-z]){}(?![a-z])"
REPLACED = {
    "lamp": ("light", r"[lL]amps?|LAMPS?", EVERYWHERE),
    "octet": ("byte", r"[oO]ctets?(?!-stream)", EVERYWHERE),
    "FrameLayer": ("Aov", r"FrameLayers?", EVERYWHERE),
    "layer_count": ("shell_count", r"layer_count", EVERYWHERE),
    "layer of shells": ("shell", r"layer_(sets?|level|depth|maps?)|Layer(Sets?|Mesh|View|Lists|Vertex)", EVERYWHERE),
    "layer in the renderer": ("shell, AOV or array index", r"layers?", r"^renderer/(coat|frame|image|quality|raster|shaders|shells|strands)/"),
    "base picture": ("skin texture or backplate", r"[bB]ase[ _-]?[pP]ictures?", EVERYWHERE),
    "refine": ("progressive or subdivide", r"[rR]efine(d|s|ments?|ment)?|[rR]efinements?|refining", EVERYWHERE),
    "patience": ("idle_timeout", r"patience|manners", EVERYWHERE),
    "errand": ("task", r"[eE]rrands?", EVERYWHERE),
    "kept view": ("cached view", r"[kK]ept[ _]?[vV]iews?|KeptFrames|KeptPicture", EVERYWHERE),
    "place on a stroke": ("SurfaceSample, PositionSample, ScreenSample", r"(Surface|Position|Screen)Place", EVERYWHERE),
    "outline": ("silhouette", r"[oO]utlines?", EVERYWHERE),
    "turned away": ("back-facing", r"turned away|averted", EVERYWHERE),
    "faces the eye": ("front-facing", r"faces? the eye", EVERYWHERE),
    "to the eye": ("to the camera", r"to_eye|camera(\.|/)eye", EVERYWHERE),
    "odd hairs": ("ticking", r"odd_hairs|OddHairs", EVERYWHERE),
    "most, least": ("max, min", r"(most|least)_(?!squares)\w+", EVERYWHERE),
    "at rest": ("at its default", r"rest_point", EVERYWHERE),
    "meet": ("intersect, hit", r"Met::\w+|world\.meet|met_environment", r"^(renderer/strands|tests/unit/strands)/"),
    "blocked": ("occluded", r"blocked", r"^renderer/strands/"),
    "carried": ("throughput", r"carried|goes_on", r"^renderer/strands/"),
    "density of a direction": ("pdf", r"environment_density|density\(to_light\)", r"^renderer/strands/"),
    "chances": ("discrete distribution", r"[cC]hances", r"^renderer/strands/"),
}
PATTERNS = {name: (new, re.compile(PARTS.format(f"(?:{pattern})")), re.compile(paths)) for name, (new, pattern, paths) in REPLACED.items()}
EXEMPT = re.compile(r"^(docs/notes/|CHANGELOG\.md$|tests/arch/words\.py$|server/history/schema_upgrades\.cpp$|tests/unit/history/journal_upgrade_test\.cpp$|docs/trade/.*\.html$)")
SEARCHED = re.compile(r"\.(cpp|h|glsl|frag|vert|comp|py|ts|tsx|mjs|sh|cmake|in|json|yaml|csv|md|txt)$")


def hits_in(path, text):
    """Returns (line, old word, new word) for each old word in a file; the file's path counts as line 0."""
    found = []
    for name, (new, pattern, paths) in PATTERNS.items():
        if not paths.search(path):
            continue
        if pattern.search(path):
            found.append((0, name, new))
        found += [(text.count("\n", 0, match.start()) + 1, name, new) for match in pattern.finditer(text)]
    return sorted(found)


def files(root):
    listed = subprocess.run(["git", "-C", root, "ls-files"], capture_output=True, text=True, check=True).stdout
    return [name for name in listed.splitlines()
            if SEARCHED.search(name) and not EXEMPT.search(name) and (pathlib.Path(root) / name).is_file()]


def main():
    found = [(name, *hit) for name in files(sys.argv[1])
             for hit in hits_in(name, (pathlib.Path(sys.argv[1]) / name).read_text(encoding="utf-8", errors="replace"))]
    for name, line, old, new in found:
        print(f"{name}:{line}: {old}; say {new}")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
