"""What the examples share: options, a scene, recipes, progress and pictures of several frames.

Examples use the package beside them, so that they run from the repository without an installation. Everything that lays
pictures side by side needs Pillow (`pip install pillow`, or python3-pil of Debian).
"""

from __future__ import annotations

import argparse
import contextlib
import io
import math
import os
import pathlib
import subprocess
import sys
from typing import Any, Callable, Dict, Iterator, List, Optional, Sequence, Tuple, cast

from PIL import Image, ImageDraw, ImageFont

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
import pelage  # noqa: E402
from pelage.files import write_whole  # noqa: E402
from pelage.schemas import BuiltinModel, PinholeCamera  # noqa: E402

REPOSITORY = pathlib.Path(__file__).resolve().parents[3]
LOOKS = REPOSITORY / "clients" / "looks"
BUILTIN = ("torus", "knot", "sphere", "plane", "cloth", "creature")
MODELS = (".obj", ".ply", ".stl", ".off", ".gltf", ".glb", ".3ds", ".zip")
BACKGROUND = (197, 200, 206)  # same as a frame's background, so that a sheet looks like one picture
TEXT = (40, 42, 46)
UNTIL_LOADED: BuiltinModel = {"builtin": "plane", "triangles": 2}  # the model of a scene into which a file is loaded; the default takes seconds
LABEL = 22  # pixels below each picture of a sheet


def options(text: Optional[str]) -> argparse.ArgumentParser:
    """Returns a parser with the options of all examples. text: The docstring of the program."""
    parser = argparse.ArgumentParser(description=text, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument(
        "--server",
        help="address of a running server (default: a private one, which ends with the program)",
    )
    parser.add_argument("--quality", default="interactive", choices=("draft", "interactive", "detailed"))
    return parser


def model_options(parser: argparse.ArgumentParser) -> None:
    """Adds the options for a model and its groom that `new_scene` uses."""
    parser.add_argument("--model", default="creature", help=f"a file, or one of {', '.join(BUILTIN)} (default: creature)")
    parser.add_argument("--triangles", type=int, default=5000, help="of a built-in model (default: 5000)")
    parser.add_argument("--front", help="the axis of the file that the model faces, such as -z")
    parser.add_argument("--groom", type=pathlib.Path, help="a recipe or commands, as `pelage run` takes them")


@contextlib.contextmanager
def server(args: argparse.Namespace) -> Iterator[pelage.Server]:
    with pelage.Server(args.server) if args.server else pelage.local() as running:
        yield running


@contextlib.contextmanager
def empty_scene(running: pelage.Server, name: str, model: BuiltinModel = UNTIL_LOADED) -> Iterator[pelage.Scene]:
    """Creates a scene and removes it at the end of the block, so that nothing is left on a shared server."""
    scene = running.create(name, model=model)
    try:
        yield scene
    finally:
        scene.remove()


@contextlib.contextmanager
def new_scene(running: pelage.Server, args: argparse.Namespace) -> Iterator[pelage.Scene]:
    """Creates a scene with the model and the groom of the options; removes it at the end of the block."""
    is_builtin = args.model in BUILTIN
    model = cast(BuiltinModel, {"builtin": args.model, "triangles": args.triangles}) if is_builtin else UNTIL_LOADED
    with empty_scene(running, pathlib.Path(args.model).stem, model) as scene:
        if not is_builtin:
            scene.load(args.model, front=args.front, progress=pelage.print_progress)
        if args.groom:
            run_groom(running, scene, args.groom)
        yield scene


def run_groom(running: pelage.Server, scene: pelage.Scene, groom: pathlib.Path) -> None:
    """Runs a recipe or commands with the client `pelage`, which fills in variables and positions."""
    if not groom.is_file():
        raise FileNotFoundError(f"there is no groom {groom}")
    done = subprocess.run(
        [client_program(), "--server", running.address, "run", scene.id, str(groom)], capture_output=True, text=True
    )
    if done.returncode:
        raise pelage.PelageError(done.stderr.strip() or f"pelage ended with {done.returncode}")
    scene.info()  # learns the revision that the client has created


def client_program() -> str:
    """Returns `pelage` beside PELAGE_SERVER_PROGRAM if that is set, else the one on the PATH."""
    beside = os.environ.get("PELAGE_SERVER_PROGRAM")
    return str(pathlib.Path(beside).with_name("pelage")) if beside else "pelage"


def orbit(scene: pelage.Scene, degrees: float, height: float = 0.15, fov: float = 30.0) -> PinholeCamera:
    """Returns a camera on a circle around the model that sees all of it.

    degrees: Azimuth from the model's front, counter-clockwise seen from above.
    height: Height of the camera above the model's centre, as a fraction of its distance.
    """
    bounds = scene.info()["bounds"]
    centre = [(low + high) / 2 for low, high in zip(bounds["min"], bounds["max"])]
    extent = [high - low for low, high in zip(bounds["min"], bounds["max"])]
    # A turning model needs its ground diagonal as width; the factor leaves room for fur outside the box.
    widest = max(math.hypot(extent[0], extent[2]), extent[1]) * 1.12
    distance = widest / 2 / math.tan(math.radians(fov / 2))
    angle = math.radians(degrees)
    away = [math.sin(angle), height, math.cos(angle)]
    position = [middle + distance * step for middle, step in zip(centre, away)]
    return {"position": position, "target": centre, "up": [0, 1, 0], "fov_degrees": fov}


def report(done: int, of: int, text: str) -> None:
    """Shows a line of progress on standard error; results go to standard output."""
    pelage.print_progress(pelage.Progress(done / of, f"{text} ({done} of {of})"))


def picture(frame: pelage.Frame) -> Image.Image:
    return Image.open(io.BytesIO(frame.bytes)).convert("RGB")


def load_image(path: pathlib.Path) -> Image.Image:
    """Loads a picture and composites it over the background."""
    image = Image.open(path).convert("RGBA")
    return Image.alpha_composite(Image.new("RGBA", image.size, BACKGROUND), image).convert("RGB")


def sheet(pictures: Sequence[Tuple[str, Image.Image]], columns: int = 0) -> Image.Image:
    """Arranges pictures of the same size in rows, each with its label below. columns: By default about as many as rows."""
    columns = min(columns or math.ceil(math.sqrt(len(pictures))), len(pictures))
    width, height = pictures[0][1].size
    rows = math.ceil(len(pictures) / columns)
    whole = Image.new("RGB", (columns * width, rows * (height + LABEL)), BACKGROUND)
    draw = ImageDraw.Draw(whole)
    for index, (label, one) in enumerate(pictures):
        left, top = index % columns * width, index // columns * (height + LABEL)
        whole.paste(one, (left, top))
        box = draw.textbbox((0, 0), label, font=font())
        draw.text((left + (width - box[2]) // 2, top + height + 2), label, TEXT, font=font())
    return whole


def font() -> "ImageFont.FreeTypeFont | ImageFont.ImageFont":
    """Returns a smooth font if one is installed, else Pillow's own, which is small."""
    try:
        return ImageFont.truetype("DejaVuSans.ttf", 14)
    except OSError:
        return ImageFont.load_default()


def save_image(path: pathlib.Path, image: Image.Image, more: Sequence[Image.Image] = (), milliseconds: int = 0) -> None:
    """Writes a picture, which appears whole or not at all. more, milliseconds: The further pictures of an animation."""
    kind = Image.registered_extensions().get(path.suffix.lower())
    if kind is None:
        raise ValueError(f"{path}: the ending stands for no picture")
    animation: Dict[str, Any] = {"save_all": True, "append_images": list(more), "duration": milliseconds, "loop": 0} if more else {}
    content = io.BytesIO()
    image.save(content, format=kind, quality=90, **animation)
    path.parent.mkdir(parents=True, exist_ok=True)
    write_whole(path, content.getvalue())


def run(main: Callable[[], int]) -> None:
    """Exits with the code that `main` returns, or with an error message and 1."""
    try:
        sys.exit(main())
    except (pelage.PelageError, OSError, ValueError) as error:
        sys.exit(f"{pathlib.Path(sys.argv[0]).name}: {error}")


def files_in(folder: pathlib.Path, endings: Sequence[str]) -> List[pathlib.Path]:
    """Returns the files with one of the extensions, sorted by name. Raises ValueError if there are none."""
    found = sorted(path for path in folder.iterdir() if path.suffix.lower() in endings)
    if not found:
        raise ValueError(f"{folder} has no file that ends with one of {', '.join(endings)}")
    return found
