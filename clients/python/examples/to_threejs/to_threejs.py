"""Takes a groom to a web page of three.js: as shells and as cards that any viewer of glTF shows, and as a mesh for a shader of the page.

    npm ci --ignore-scripts --prefix clients/web       # three.js and esbuild, those of the studio
    python3 clients/python/examples/to_threejs/to_threejs.py --output page

Writes page/index.html, which opens without a server: pictures, models and three.js are in it. `index.html#shells`,
`#cards` and `#shader` choose what is drawn; drag to turn. With --chromium it also takes a picture of each and lays them
beside our frame of the same camera in page/sheet.png. Needs Pillow, and node 18 or newer.
"""

from __future__ import annotations

import argparse
import json
import pathlib
import subprocess
import sys
from typing import List, Literal, Sequence

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))
import common  # noqa: E402
import pelage  # noqa: E402
from pelage.files import write_whole  # noqa: E402
from pelage.schemas import PinholeCamera  # noqa: E402

EXPORTS: Sequence[Literal["shells", "cards", "fields"]] = ("shells", "cards", "fields")
PICTURES = {"shells": "three.js, shells", "cards": "three.js, cards", "shader": "three.js, fields with our shader"}
HEADLESS = [
    "--headless", "--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
    "--hide-scrollbars", "--virtual-time-budget=60000",
]


def arguments() -> argparse.Namespace:
    parser = common.options(__doc__)
    common.model_options(parser)
    parser.add_argument("--output", type=pathlib.Path, default=pathlib.Path("page"), help="folder (default: page)")
    parser.add_argument(
        "--packages", type=pathlib.Path, default=common.REPOSITORY / "clients" / "web" / "node_modules",
        help="folder with three and esbuild (default: clients/web/node_modules)",
    )
    parser.add_argument(
        "--turn", type=float, default=35,
        help="degrees of the camera around the model, 90 at its left (default: 35)",
    )
    parser.add_argument("--size", type=int, default=400, help="pixels along the side of the pictures (default: 400)")
    parser.add_argument("--columns", type=int, default=len(PICTURES) + 1, help="pictures in a row of the sheet (default: all)")
    parser.add_argument("--chromium", help="the browser, to take pictures at once")
    return parser.parse_args()


def run(command: List[str], seconds: float) -> None:
    done = subprocess.run(command, capture_output=True, text=True, timeout=seconds)
    if done.returncode:
        raise OSError(f"{command[0]} failed:\n{(done.stdout + done.stderr)[-2000:]}")


def export(scene: pelage.Scene, camera: PinholeCamera, args: argparse.Namespace) -> None:
    for kind in EXPORTS:
        path = args.output / f"{kind}.glb"
        about = scene.export(path, format=kind)
        print(f"{path}: {about['triangles']} triangles, {about['bytes'] / 1e6:.1f} MB", flush=True)
    settings = scene.settings()
    lights = [light for light in settings["lights"] if light["kind"] == "directional"]
    content = {"camera": camera, "lights": lights, "ambient": settings["look"]["ambient"], "size": args.size}
    write_whole(args.output / "scene.json", json.dumps(content).encode())
    scene.save_frame(
        args.output / "pelage.png", camera=camera, quality=args.quality, width=args.size, height=args.size, tone_map="none"
    )


def take_pictures(args: argparse.Namespace) -> None:
    window = max(args.size, 500) + 200  # Chromium's windows are at least 500 wide, and the window frame needs room
    pictures = [("Pelage", common.load_image(args.output / "pelage.png"))]
    for kind, label in PICTURES.items():
        file, page = (args.output / name for name in (f"{kind}.png", "index.html"))
        run([args.chromium, *HEADLESS, f"--window-size={window},{window}", f"--screenshot={file.resolve()}",
             f"{page.resolve().as_uri()}#{kind}"], 300)
        common.save_image(file, common.load_image(file).crop((0, 0, args.size, args.size)))
        pictures.append((label, common.load_image(file)))
    common.save_image(args.output / "sheet.png", common.sheet(pictures, args.columns))
    print(args.output / "sheet.png")


def main() -> int:
    args = arguments()
    if not (args.packages / "three").is_dir():
        raise FileNotFoundError(f"there is no {args.packages / 'three'}; run npm ci --ignore-scripts --prefix clients/web")
    args.output.mkdir(parents=True, exist_ok=True)
    with common.server(args) as running, common.new_scene(running, args) as scene:
        export(scene, common.orbit(scene, args.turn, 0.25), args)
    run(["node", str(HERE / "build.mjs"), str(args.packages), str(args.output)], 120)
    print(args.output / "index.html")
    if args.chromium:
        take_pictures(args)
    return 0


if __name__ == "__main__":
    common.run(main)
