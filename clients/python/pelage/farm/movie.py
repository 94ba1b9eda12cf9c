"""Clips and contact sheets of frames."""

from __future__ import annotations

import glob
import math
import re
from typing import Dict, List, NamedTuple, Sequence

from .check import plan_for
from .errors import BAD_INPUT, FarmError
from .ffmpeg import convert, ending_of
from .frame_files import ShortFile, inspect

FRAMES_STEP = "name a folder of `pelage farm submit`, a job, or frames as out/fox.####.png"
# Filters that composite a frame over black, by file extension: PNG has straight alpha, EXR is premultiplied already.
OVER_BLACK = {".png": "format=rgba,premultiply=inplace=1,"}


class Clip(NamedTuple):
    """files: Paths by frame. missing: Planned frames without a complete file."""

    files: Dict[int, str]
    missing: List[int]
    fps: float


def clip_of(path: str) -> Clip:
    """Returns the frames of a folder, job or file pattern. Raises FarmError if there are none."""
    if "#" in path:
        found = Clip(files_like(path), [], 24)
    else:
        plan = plan_for(path)
        there = {frame.frame: frame.file for frame in plan.frames if is_whole(frame.file)}
        found = Clip(there, [frame.frame for frame in plan.frames if frame.frame not in there], plan.fps)
    if not found.files:
        raise FarmError(f"{path} has no frames", FRAMES_STEP, BAD_INPUT)
    return found


def is_whole(file: str) -> bool:
    try:
        inspect(file)
    except (OSError, ShortFile):
        return False
    return True


def files_like(pattern: str) -> Dict[int, str]:
    """Returns the files that match a pattern, by frame; # stands for digits."""
    name = re.escape(pattern).replace(re.escape("#"), "#")
    matcher = re.compile(re.sub("#+", r"(-?\\d+)", name))
    matches = (matcher.fullmatch(file) for file in glob.glob(re.sub("#+", "*", glob.escape(pattern))))
    return dict(sorted((int(match[1]), match[0]) for match in matches if match))


def make_movie(frames: Clip, output: str, fps: float, width: int) -> None:
    """Makes an MP4, WebP or GIF, by extension. fps: 0 for the job's. width: Pixels; 0 for the frames'. Raises FarmError."""
    files = list(frames.files.values())
    ending = ending_of(output)
    if ending not in MOVIES:
        raise FarmError(f"{output} is no kind of clip", f"name a file that ends in {', '.join(MOVIES)}", BAD_INPUT)
    chain = OVER_BLACK.get(ending_of(files[0]), "") + (f"scale={width}:-2:flags=area," if width else "")
    convert(files, fps or frames.fps, MOVIES[ending](chain), output)


def mp4_arguments(chain: str) -> List[str]:
    """Arguments for H.264 that every browser plays: even sides, 4:2:0, explicit colour space."""
    chain += "pad=ceil(iw/2)*2:ceil(ih/2)*2,scale=out_color_matrix=bt709:out_range=tv,format=yuv420p"
    colours = ["-colorspace", "bt709", "-color_primaries", "bt709", "-color_trc", "iec61966-2-1"]
    return ["-vf", chain, "-c:v", "libx264", "-crf", "18", *colours, "-movflags", "+faststart", "-f", "mp4"]


def webp_arguments(chain: str) -> List[str]:
    """Arguments for WebP. Below quality 92, plain backgrounds show ghosts of earlier frames."""
    codec = ["-c:v", "libwebp_anim", "-quality", "92", "-compression_level", "6"]
    return ["-vf", chain + "format=yuv420p", *codec, "-loop", "0", "-f", "webp"]


def gif_arguments(chain: str) -> List[str]:
    """Arguments for GIF with a palette computed from these frames."""
    palette = f"{chain}split[a][b];[a]palettegen=stats_mode=diff[p];[b][p]paletteuse=dither=bayer:bayer_scale=4"
    return ["-vf", palette, "-loop", "0", "-f", "gif"]


MOVIES = {".mp4": mp4_arguments, ".webp": webp_arguments, ".gif": gif_arguments}
SHEETS = {".png": ["-c:v", "png"], ".jpg": ["-c:v", "mjpeg", "-q:v", "3"], ".jpeg": ["-c:v", "mjpeg", "-q:v", "3"]}


def make_sheet(frames: Clip, output: str, count: int, columns: int, width: int) -> List[int]:
    """Makes a contact sheet and returns the frames that it shows. count: Number of pictures, evenly spaced; 0 for all.
    width: Width of each in pixels. Raises FarmError."""
    ending = ending_of(output)
    if ending not in SHEETS:
        raise FarmError(f"{output} is no kind of sheet", f"name a file that ends in {', '.join(SHEETS)}", BAD_INPUT)
    shown = spread(list(frames.files), count)
    columns = min(columns, len(shown))
    rows = math.ceil(len(shown) / columns)
    files = [frames.files[frame] for frame in shown]
    size = inspect(files[0])
    height = max(1, round(width * size.height / size.width))
    chain = OVER_BLACK.get(ending_of(files[0]), "") + f"scale={width}:{height}:flags=area,tile={columns}x{rows}:padding=2"
    convert(files, 24, ["-vf", chain, "-frames:v", "1", *SHEETS[ending], "-f", "image2", "-update", "1"], output)
    return shown


def spread(frames: Sequence[int], count: int) -> List[int]:
    """Returns `count` evenly spaced frames, starting with the first. Leaves out the last, so that loops do not repeat."""
    if not count or count >= len(frames):
        return list(frames)
    return [frames[index * len(frames) // count] for index in range(count)]
