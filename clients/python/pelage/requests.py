"""Requests that have many parameters, as methods. Made by generate.py."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any, Dict, Iterator, Literal, Optional, Sequence, Union

from .frame import FieldMap, Frame
from .options import Options
from .progress import ReportProgress
from .schemas import (
    Aov,
    AutoView,
    Camera,
    Colour,
    CommandAnswer,
    Crop,
    ExportAbout,
    Field,
    FrameCost,
    FurPatches,
    Knobs,
    Look,
    MapEncoding,
    Pick,
    SceneInfo,
    Tier,
    Tracing,
    Units,
)

if TYPE_CHECKING:
    import numpy
    from numpy.typing import NDArray

Path = Union[str, "os.PathLike[str]"]


class Requests:
    """Pictures, models and maps. A parameter that is left out is not sent, and takes its default.

    `members` of the methods that do the work have None for what is not to be sent.
    """

    def frame(
        self,
        *,
        width: Optional[int] = None,
        height: Optional[int] = None,
        crop: Optional[Crop] = None,
        camera: Optional[Union[AutoView, Camera]] = None,
        quality: Optional[Union[Tier, Knobs]] = None,
        budget_ms: Optional[float] = None,
        max_error: Optional[float] = None,
        max_seconds: Optional[float] = None,
        time: Optional[float] = None,
        background: Optional[Union[Literal["transparent", "studio"], Colour]] = None,
        exposure: Optional[float] = None,
        tone_map: Optional[Literal["none", "filmic"]] = None,
        look: Optional[Look] = None,
        view: Optional[str] = None,
        format: Optional[Literal["png", "png16", "jpeg", "webp", "exr", "npy", "npy_linear"]] = None,
        lossy_quality: Optional[int] = None,
        exr_type: Optional[Literal["half", "float"]] = None,
        aovs: Optional[Sequence[Aov]] = None,
        overlay: Optional[Literal[
            "none", "direction", "strokes", "length", "density", "wetness", "mask", "difference", "bald", "wire"
        ]] = None,
        overlay_from: Optional[int] = None,
        revision: Optional[int] = None,
        progress: Optional[ReportProgress] = None,
    ) -> Frame:
        """Draws the scene. `camera` is also taken as a word, such as "front".

        width: Width of the picture. 1 to 8192 (pixels). Default 512.
        height: Height of the picture. 1 to 8192 (pixels). Default 512.
        crop: Part of the frame that is drawn alone. The picture has the part's size, and the pixels that the whole
            frame has there; an EXR's display window is the whole frame. `budget_ms` is of the whole frame.
        camera: Where the scene is seen from. Default {"auto": "three_quarter"}.
        quality: A tier, or single knobs. Default "interactive".
        budget_ms: Drawing time, in place of `quality`: takes the knobs whose drawing time keeps to the budget and
            whose error, as 95% of frames keep it, is estimated least; 95% of frames take at most 1.25 times it.
            Drawing time is the milliseconds that pass on this machine while the frame is drawn; waiting for other
            frames, reading and encoding are not in it, nor is growing strands after their coat or their model has
            changed. AOVs of an EXR beside beauty, and overlays, come on top. 1 to 600000 (milliseconds).
        max_error: Error, in place of `quality`: takes the cheapest knobs with at most this error in 95% of frames:
            mean FLIP where there is fur, against the same strands, traced. 1e-06 to 1 (mean FLIP).
        max_seconds: Refuses the frame where drawing is expected to take longer; a dry run says how long. 1 to 86400
            (seconds). Default 60.
        time: Time that the frame shows: the fur as the scene's wind has moved it by then. The scene's own time unless
            given. The same time gives the same picture, whatever was drawn before. -1000000 to 1000000 (seconds).
        background: What is behind the fur. `studio` is a soft gradient with darker corners. Default [0.56, 0.58,
            0.61].
        exposure: How much brighter the picture is made. -20 to 20 (stops). Default 0.
        tone_map: How bright light is brought into the picture's range. Default "filmic".
        look: Look for this frame, in place of the scene's.
        view: Name of the viewer: of several frames asked for one view only the newest is drawn, the others get 409.
            At most 200 bytes. Default "".
        format: Format of the picture. png and png16: 8 and 16 bit sRGB. jpeg: without alpha. webp: lossy as jpeg,
            half as large, ten times slower to make, with alpha. exr: linear light without exposure, tone map and
            background, multiplied by alpha. npy: the pixels of png as a NumPy array of bytes [height, width, 4].
            npy_linear: what an exr of floats holds as a NumPy array of floats [height, width, channels]. Default
            "png".
        lossy_quality: How much jpeg and webp keep of the picture, from 1 on; of these formats only. 0: as the frame's
            quality asks, 80 of a draft, 88 of an interactive frame, 94 beyond. 0 to 100. Default 0.
        exr_type: Type of the channels of an EXR. Depth, position, strand and root are always float. Default "half".
        aovs: AOVs (arbitrary output variables) that the file holds, for exr and npy_linear; `[beauty]` when absent.
            Drawn pixels times AOVs are at most 67108864. Channels: R, G, B, A of beauty; A of alpha; Z of depth;
            AOV.X, .Y, .Z of position, normal, tangent and root; AOV.R, .G, .B of albedo and direct; AOV.Y of shadow
            and sample_count; strand.id, .along and .coat. 1 to 12 items.
        overlay: Shows a field on the fur. Not in linear light. density, wetness and mask go from dark violet for 0 to
            yellow for 1. difference: how much the fields have changed since `overlay_from`, with the same colours: of
            the field that changed most, the change over what counts as much (direction and colours: 1; length: the
            longest fur; others: the field's range). Grey where nothing changed. bald and wire hide the frame: the
            skin in plain grey without its fur, to find places on it, and the same with the edges of its triangles.
            Default "none".
        overlay_from: Revision that the overlay `difference` compares what is drawn with: one of this model. Only with
            it. 0 to 18446744073709551615.
        revision: Revision to draw the scene as: its model, fields and settings as they were; the present one when it
            is not given. Neither with `progressive` nor with `after`. 0 to 18446744073709551615.
        progress: Called about once a second, on another thread, with how far the frame is.
        """
        return self._frame(
            {
                "width": width, "height": height, "crop": crop, "camera": camera, "quality": quality,
                "budget_ms": budget_ms, "max_error": max_error, "max_seconds": max_seconds, "time": time,
                "background": background, "exposure": exposure, "tone_map": tone_map, "look": look, "view": view,
                "format": format, "lossy_quality": lossy_quality, "exr_type": exr_type, "aovs": aovs,
                "overlay": overlay, "overlay_from": overlay_from, "revision": revision,
            },
            progress,
        )

    def save_frame(
        self,
        path: Path,
        *,
        width: Optional[int] = None,
        height: Optional[int] = None,
        crop: Optional[Crop] = None,
        camera: Optional[Union[AutoView, Camera]] = None,
        quality: Optional[Union[Tier, Knobs]] = None,
        budget_ms: Optional[float] = None,
        max_error: Optional[float] = None,
        max_seconds: Optional[float] = None,
        time: Optional[float] = None,
        background: Optional[Union[Literal["transparent", "studio"], Colour]] = None,
        exposure: Optional[float] = None,
        tone_map: Optional[Literal["none", "filmic"]] = None,
        look: Optional[Look] = None,
        view: Optional[str] = None,
        format: Optional[Literal["png", "png16", "jpeg", "webp", "exr", "npy", "npy_linear"]] = None,
        lossy_quality: Optional[int] = None,
        exr_type: Optional[Literal["half", "float"]] = None,
        aovs: Optional[Sequence[Aov]] = None,
        overlay: Optional[Literal[
            "none", "direction", "strokes", "length", "density", "wetness", "mask", "difference", "bald", "wire"
        ]] = None,
        overlay_from: Optional[int] = None,
        revision: Optional[int] = None,
        progress: Optional[ReportProgress] = None,
    ) -> Frame:
        """Draws the scene to a file: .png, .jpg, .jpeg, .webp, .exr or .npy. Another ending raises ValueError
        before anything is drawn. The file appears whole or not at all.

        path: Where to; what is there is replaced.
        width: Width of the picture. 1 to 8192 (pixels). Default 512.
        height: Height of the picture. 1 to 8192 (pixels). Default 512.
        crop: Part of the frame that is drawn alone. The picture has the part's size, and the pixels that the whole
            frame has there; an EXR's display window is the whole frame. `budget_ms` is of the whole frame.
        camera: Where the scene is seen from. Default {"auto": "three_quarter"}.
        quality: A tier, or single knobs. Default "interactive".
        budget_ms: Drawing time, in place of `quality`: takes the knobs whose drawing time keeps to the budget and
            whose error, as 95% of frames keep it, is estimated least; 95% of frames take at most 1.25 times it.
            Drawing time is the milliseconds that pass on this machine while the frame is drawn; waiting for other
            frames, reading and encoding are not in it, nor is growing strands after their coat or their model has
            changed. AOVs of an EXR beside beauty, and overlays, come on top. 1 to 600000 (milliseconds).
        max_error: Error, in place of `quality`: takes the cheapest knobs with at most this error in 95% of frames:
            mean FLIP where there is fur, against the same strands, traced. 1e-06 to 1 (mean FLIP).
        max_seconds: Refuses the frame where drawing is expected to take longer; a dry run says how long. 1 to 86400
            (seconds). Default 60.
        time: Time that the frame shows: the fur as the scene's wind has moved it by then. The scene's own time unless
            given. The same time gives the same picture, whatever was drawn before. -1000000 to 1000000 (seconds).
        background: What is behind the fur. `studio` is a soft gradient with darker corners. Default [0.56, 0.58,
            0.61].
        exposure: How much brighter the picture is made. -20 to 20 (stops). Default 0.
        tone_map: How bright light is brought into the picture's range. Default "filmic".
        look: Look for this frame, in place of the scene's.
        view: Name of the viewer: of several frames asked for one view only the newest is drawn, the others get 409.
            At most 200 bytes. Default "".
        format: Format of the picture. png and png16: 8 and 16 bit sRGB. jpeg: without alpha. webp: lossy as jpeg,
            half as large, ten times slower to make, with alpha. exr: linear light without exposure, tone map and
            background, multiplied by alpha. npy: the pixels of png as a NumPy array of bytes [height, width, 4].
            npy_linear: what an exr of floats holds as a NumPy array of floats [height, width, channels]. Default
            "png".
        lossy_quality: How much jpeg and webp keep of the picture, from 1 on; of these formats only. 0: as the frame's
            quality asks, 80 of a draft, 88 of an interactive frame, 94 beyond. 0 to 100. Default 0.
        exr_type: Type of the channels of an EXR. Depth, position, strand and root are always float. Default "half".
        aovs: AOVs (arbitrary output variables) that the file holds, for exr and npy_linear; `[beauty]` when absent.
            Drawn pixels times AOVs are at most 67108864. Channels: R, G, B, A of beauty; A of alpha; Z of depth;
            AOV.X, .Y, .Z of position, normal, tangent and root; AOV.R, .G, .B of albedo and direct; AOV.Y of shadow
            and sample_count; strand.id, .along and .coat. 1 to 12 items.
        overlay: Shows a field on the fur. Not in linear light. density, wetness and mask go from dark violet for 0 to
            yellow for 1. difference: how much the fields have changed since `overlay_from`, with the same colours: of
            the field that changed most, the change over what counts as much (direction and colours: 1; length: the
            longest fur; others: the field's range). Grey where nothing changed. bald and wire hide the frame: the
            skin in plain grey without its fur, to find places on it, and the same with the edges of its triangles.
            Default "none".
        overlay_from: Revision that the overlay `difference` compares what is drawn with: one of this model. Only with
            it. 0 to 18446744073709551615.
        revision: Revision to draw the scene as: its model, fields and settings as they were; the present one when it
            is not given. Neither with `progressive` nor with `after`. 0 to 18446744073709551615.
        progress: Called about once a second, on another thread, with how far the frame is.
        """
        return self._save_frame(
            {
                "width": width, "height": height, "crop": crop, "camera": camera, "quality": quality,
                "budget_ms": budget_ms, "max_error": max_error, "max_seconds": max_seconds, "time": time,
                "background": background, "exposure": exposure, "tone_map": tone_map, "look": look, "view": view,
                "format": format, "lossy_quality": lossy_quality, "exr_type": exr_type, "aovs": aovs,
                "overlay": overlay, "overlay_from": overlay_from, "revision": revision,
            },
            path,
            progress,
        )

    def frame_cost(
        self,
        *,
        width: Optional[int] = None,
        height: Optional[int] = None,
        crop: Optional[Crop] = None,
        camera: Optional[Union[AutoView, Camera]] = None,
        quality: Optional[Union[Tier, Knobs]] = None,
        budget_ms: Optional[float] = None,
        max_error: Optional[float] = None,
        max_seconds: Optional[float] = None,
        time: Optional[float] = None,
        background: Optional[Union[Literal["transparent", "studio"], Colour]] = None,
        exposure: Optional[float] = None,
        tone_map: Optional[Literal["none", "filmic"]] = None,
        look: Optional[Look] = None,
        view: Optional[str] = None,
        format: Optional[Literal["png", "png16", "jpeg", "webp", "exr", "npy", "npy_linear"]] = None,
        lossy_quality: Optional[int] = None,
        exr_type: Optional[Literal["half", "float"]] = None,
        aovs: Optional[Sequence[Aov]] = None,
        overlay: Optional[Literal[
            "none", "direction", "strokes", "length", "density", "wetness", "mask", "difference", "bald", "wire"
        ]] = None,
        overlay_from: Optional[int] = None,
        revision: Optional[int] = None,
    ) -> FrameCost:
        """What drawing such a frame is expected to take; nothing is drawn.

        width: Width of the picture. 1 to 8192 (pixels). Default 512.
        height: Height of the picture. 1 to 8192 (pixels). Default 512.
        crop: Part of the frame that is drawn alone. The picture has the part's size, and the pixels that the whole
            frame has there; an EXR's display window is the whole frame. `budget_ms` is of the whole frame.
        camera: Where the scene is seen from. Default {"auto": "three_quarter"}.
        quality: A tier, or single knobs. Default "interactive".
        budget_ms: Drawing time, in place of `quality`: takes the knobs whose drawing time keeps to the budget and
            whose error, as 95% of frames keep it, is estimated least; 95% of frames take at most 1.25 times it.
            Drawing time is the milliseconds that pass on this machine while the frame is drawn; waiting for other
            frames, reading and encoding are not in it, nor is growing strands after their coat or their model has
            changed. AOVs of an EXR beside beauty, and overlays, come on top. 1 to 600000 (milliseconds).
        max_error: Error, in place of `quality`: takes the cheapest knobs with at most this error in 95% of frames:
            mean FLIP where there is fur, against the same strands, traced. 1e-06 to 1 (mean FLIP).
        max_seconds: Refuses the frame where drawing is expected to take longer; a dry run says how long. 1 to 86400
            (seconds). Default 60.
        time: Time that the frame shows: the fur as the scene's wind has moved it by then. The scene's own time unless
            given. The same time gives the same picture, whatever was drawn before. -1000000 to 1000000 (seconds).
        background: What is behind the fur. `studio` is a soft gradient with darker corners. Default [0.56, 0.58,
            0.61].
        exposure: How much brighter the picture is made. -20 to 20 (stops). Default 0.
        tone_map: How bright light is brought into the picture's range. Default "filmic".
        look: Look for this frame, in place of the scene's.
        view: Name of the viewer: of several frames asked for one view only the newest is drawn, the others get 409.
            At most 200 bytes. Default "".
        format: Format of the picture. png and png16: 8 and 16 bit sRGB. jpeg: without alpha. webp: lossy as jpeg,
            half as large, ten times slower to make, with alpha. exr: linear light without exposure, tone map and
            background, multiplied by alpha. npy: the pixels of png as a NumPy array of bytes [height, width, 4].
            npy_linear: what an exr of floats holds as a NumPy array of floats [height, width, channels]. Default
            "png".
        lossy_quality: How much jpeg and webp keep of the picture, from 1 on; of these formats only. 0: as the frame's
            quality asks, 80 of a draft, 88 of an interactive frame, 94 beyond. 0 to 100. Default 0.
        exr_type: Type of the channels of an EXR. Depth, position, strand and root are always float. Default "half".
        aovs: AOVs (arbitrary output variables) that the file holds, for exr and npy_linear; `[beauty]` when absent.
            Drawn pixels times AOVs are at most 67108864. Channels: R, G, B, A of beauty; A of alpha; Z of depth;
            AOV.X, .Y, .Z of position, normal, tangent and root; AOV.R, .G, .B of albedo and direct; AOV.Y of shadow
            and sample_count; strand.id, .along and .coat. 1 to 12 items.
        overlay: Shows a field on the fur. Not in linear light. density, wetness and mask go from dark violet for 0 to
            yellow for 1. difference: how much the fields have changed since `overlay_from`, with the same colours: of
            the field that changed most, the change over what counts as much (direction and colours: 1; length: the
            longest fur; others: the field's range). Grey where nothing changed. bald and wire hide the frame: the
            skin in plain grey without its fur, to find places on it, and the same with the edges of its triangles.
            Default "none".
        overlay_from: Revision that the overlay `difference` compares what is drawn with: one of this model. Only with
            it. 0 to 18446744073709551615.
        revision: Revision to draw the scene as: its model, fields and settings as they were; the present one when it
            is not given. Neither with `progressive` nor with `after`. 0 to 18446744073709551615.
        """
        return self._frame_cost(
            {
                "width": width, "height": height, "crop": crop, "camera": camera, "quality": quality,
                "budget_ms": budget_ms, "max_error": max_error, "max_seconds": max_seconds, "time": time,
                "background": background, "exposure": exposure, "tone_map": tone_map, "look": look, "view": view,
                "format": format, "lossy_quality": lossy_quality, "exr_type": exr_type, "aovs": aovs,
                "overlay": overlay, "overlay_from": overlay_from, "revision": revision,
            },
        )

    def frame_array(
        self,
        *,
        width: Optional[int] = None,
        height: Optional[int] = None,
        crop: Optional[Crop] = None,
        camera: Optional[Union[AutoView, Camera]] = None,
        quality: Optional[Union[Tier, Knobs]] = None,
        budget_ms: Optional[float] = None,
        max_error: Optional[float] = None,
        max_seconds: Optional[float] = None,
        time: Optional[float] = None,
        background: Optional[Union[Literal["transparent", "studio"], Colour]] = None,
        exposure: Optional[float] = None,
        tone_map: Optional[Literal["none", "filmic"]] = None,
        look: Optional[Look] = None,
        view: Optional[str] = None,
        aovs: Optional[Sequence[Aov]] = None,
        overlay: Optional[Literal[
            "none", "direction", "strokes", "length", "density", "wetness", "mask", "difference", "bald", "wire"
        ]] = None,
        overlay_from: Optional[int] = None,
        revision: Optional[int] = None,
        linear: bool = False,
        progress: Optional[ReportProgress] = None,
    ) -> NDArray[Any]:
        """Draws the scene to a NumPy array: [height, width, 4], uint8 sRGB, row 0 at the top. With `linear`
        float32 [height, width, channels]: linear light multiplied by alpha, the channels of `aovs` in their order.

        width: Width of the picture. 1 to 8192 (pixels). Default 512.
        height: Height of the picture. 1 to 8192 (pixels). Default 512.
        crop: Part of the frame that is drawn alone. The picture has the part's size, and the pixels that the whole
            frame has there; an EXR's display window is the whole frame. `budget_ms` is of the whole frame.
        camera: Where the scene is seen from. Default {"auto": "three_quarter"}.
        quality: A tier, or single knobs. Default "interactive".
        budget_ms: Drawing time, in place of `quality`: takes the knobs whose drawing time keeps to the budget and
            whose error, as 95% of frames keep it, is estimated least; 95% of frames take at most 1.25 times it.
            Drawing time is the milliseconds that pass on this machine while the frame is drawn; waiting for other
            frames, reading and encoding are not in it, nor is growing strands after their coat or their model has
            changed. AOVs of an EXR beside beauty, and overlays, come on top. 1 to 600000 (milliseconds).
        max_error: Error, in place of `quality`: takes the cheapest knobs with at most this error in 95% of frames:
            mean FLIP where there is fur, against the same strands, traced. 1e-06 to 1 (mean FLIP).
        max_seconds: Refuses the frame where drawing is expected to take longer; a dry run says how long. 1 to 86400
            (seconds). Default 60.
        time: Time that the frame shows: the fur as the scene's wind has moved it by then. The scene's own time unless
            given. The same time gives the same picture, whatever was drawn before. -1000000 to 1000000 (seconds).
        background: What is behind the fur. `studio` is a soft gradient with darker corners. Default [0.56, 0.58,
            0.61].
        exposure: How much brighter the picture is made. -20 to 20 (stops). Default 0.
        tone_map: How bright light is brought into the picture's range. Default "filmic".
        look: Look for this frame, in place of the scene's.
        view: Name of the viewer: of several frames asked for one view only the newest is drawn, the others get 409.
            At most 200 bytes. Default "".
        aovs: AOVs (arbitrary output variables) that the file holds, for exr and npy_linear; `[beauty]` when absent.
            Drawn pixels times AOVs are at most 67108864. Channels: R, G, B, A of beauty; A of alpha; Z of depth;
            AOV.X, .Y, .Z of position, normal, tangent and root; AOV.R, .G, .B of albedo and direct; AOV.Y of shadow
            and sample_count; strand.id, .along and .coat. 1 to 12 items.
        overlay: Shows a field on the fur. Not in linear light. density, wetness and mask go from dark violet for 0 to
            yellow for 1. difference: how much the fields have changed since `overlay_from`, with the same colours: of
            the field that changed most, the change over what counts as much (direction and colours: 1; length: the
            longest fur; others: the field's range). Grey where nothing changed. bald and wire hide the frame: the
            skin in plain grey without its fur, to find places on it, and the same with the edges of its triangles.
            Default "none".
        overlay_from: Revision that the overlay `difference` compares what is drawn with: one of this model. Only with
            it. 0 to 18446744073709551615.
        revision: Revision to draw the scene as: its model, fields and settings as they were; the present one when it
            is not given. Neither with `progressive` nor with `after`. 0 to 18446744073709551615.
        linear: Linear light, without exposure, tone map and background.
        progress: Called about once a second, on another thread, with how far the frame is.
        """
        return self._frame_array(
            {
                "width": width, "height": height, "crop": crop, "camera": camera, "quality": quality,
                "budget_ms": budget_ms, "max_error": max_error, "max_seconds": max_seconds, "time": time,
                "background": background, "exposure": exposure, "tone_map": tone_map, "look": look, "view": view,
                "aovs": aovs, "overlay": overlay, "overlay_from": overlay_from, "revision": revision,
            },
            linear,
            progress,
        )

    def live_frames(
        self,
        *,
        width: Optional[int] = None,
        height: Optional[int] = None,
        crop: Optional[Crop] = None,
        camera: Optional[Union[AutoView, Camera]] = None,
        quality: Optional[Union[Tier, Knobs]] = None,
        budget_ms: Optional[float] = None,
        max_error: Optional[float] = None,
        max_seconds: Optional[float] = None,
        time: Optional[float] = None,
        background: Optional[Union[Literal["transparent", "studio"], Colour]] = None,
        exposure: Optional[float] = None,
        tone_map: Optional[Literal["none", "filmic"]] = None,
        look: Optional[Look] = None,
        view: Optional[str] = None,
        format: Optional[Literal["png", "png16", "jpeg", "webp", "exr", "npy", "npy_linear"]] = None,
        lossy_quality: Optional[int] = None,
        exr_type: Optional[Literal["half", "float"]] = None,
        aovs: Optional[Sequence[Aov]] = None,
        overlay: Optional[Literal[
            "none", "direction", "strokes", "length", "density", "wetness", "mask", "difference", "bald", "wire"
        ]] = None,
        overlay_from: Optional[int] = None,
    ) -> Iterator[Frame]:
        """Frames without an end: one now, and one each time the scene has changed. A scene that is removed raises
        `NotFound`.

        width: Width of the picture. 1 to 8192 (pixels). Default 512.
        height: Height of the picture. 1 to 8192 (pixels). Default 512.
        crop: Part of the frame that is drawn alone. The picture has the part's size, and the pixels that the whole
            frame has there; an EXR's display window is the whole frame. `budget_ms` is of the whole frame.
        camera: Where the scene is seen from. Default {"auto": "three_quarter"}.
        quality: A tier, or single knobs. Default "interactive".
        budget_ms: Drawing time, in place of `quality`: takes the knobs whose drawing time keeps to the budget and
            whose error, as 95% of frames keep it, is estimated least; 95% of frames take at most 1.25 times it.
            Drawing time is the milliseconds that pass on this machine while the frame is drawn; waiting for other
            frames, reading and encoding are not in it, nor is growing strands after their coat or their model has
            changed. AOVs of an EXR beside beauty, and overlays, come on top. 1 to 600000 (milliseconds).
        max_error: Error, in place of `quality`: takes the cheapest knobs with at most this error in 95% of frames:
            mean FLIP where there is fur, against the same strands, traced. 1e-06 to 1 (mean FLIP).
        max_seconds: Refuses the frame where drawing is expected to take longer; a dry run says how long. 1 to 86400
            (seconds). Default 60.
        time: Time that the frame shows: the fur as the scene's wind has moved it by then. The scene's own time unless
            given. The same time gives the same picture, whatever was drawn before. -1000000 to 1000000 (seconds).
        background: What is behind the fur. `studio` is a soft gradient with darker corners. Default [0.56, 0.58,
            0.61].
        exposure: How much brighter the picture is made. -20 to 20 (stops). Default 0.
        tone_map: How bright light is brought into the picture's range. Default "filmic".
        look: Look for this frame, in place of the scene's.
        view: Name of the viewer: of several frames asked for one view only the newest is drawn, the others get 409.
            At most 200 bytes. Default "".
        format: Format of the picture. png and png16: 8 and 16 bit sRGB. jpeg: without alpha. webp: lossy as jpeg,
            half as large, ten times slower to make, with alpha. exr: linear light without exposure, tone map and
            background, multiplied by alpha. npy: the pixels of png as a NumPy array of bytes [height, width, 4].
            npy_linear: what an exr of floats holds as a NumPy array of floats [height, width, channels]. Default
            "png".
        lossy_quality: How much jpeg and webp keep of the picture, from 1 on; of these formats only. 0: as the frame's
            quality asks, 80 of a draft, 88 of an interactive frame, 94 beyond. 0 to 100. Default 0.
        exr_type: Type of the channels of an EXR. Depth, position, strand and root are always float. Default "half".
        aovs: AOVs (arbitrary output variables) that the file holds, for exr and npy_linear; `[beauty]` when absent.
            Drawn pixels times AOVs are at most 67108864. Channels: R, G, B, A of beauty; A of alpha; Z of depth;
            AOV.X, .Y, .Z of position, normal, tangent and root; AOV.R, .G, .B of albedo and direct; AOV.Y of shadow
            and sample_count; strand.id, .along and .coat. 1 to 12 items.
        overlay: Shows a field on the fur. Not in linear light. density, wetness and mask go from dark violet for 0 to
            yellow for 1. difference: how much the fields have changed since `overlay_from`, with the same colours: of
            the field that changed most, the change over what counts as much (direction and colours: 1; length: the
            longest fur; others: the field's range). Grey where nothing changed. bald and wire hide the frame: the
            skin in plain grey without its fur, to find places on it, and the same with the edges of its triangles.
            Default "none".
        overlay_from: Revision that the overlay `difference` compares what is drawn with: one of this model. Only with
            it. 0 to 18446744073709551615.
        """
        return self._live_frames(
            {
                "width": width, "height": height, "crop": crop, "camera": camera, "quality": quality,
                "budget_ms": budget_ms, "max_error": max_error, "max_seconds": max_seconds, "time": time,
                "background": background, "exposure": exposure, "tone_map": tone_map, "look": look, "view": view,
                "format": format, "lossy_quality": lossy_quality, "exr_type": exr_type, "aovs": aovs,
                "overlay": overlay, "overlay_from": overlay_from,
            },
        )

    def better_frames(
        self,
        *,
        width: Optional[int] = None,
        height: Optional[int] = None,
        crop: Optional[Crop] = None,
        camera: Optional[Union[AutoView, Camera]] = None,
        quality: Optional[Union[Tier, Knobs]] = None,
        budget_ms: Optional[float] = None,
        max_error: Optional[float] = None,
        max_seconds: Optional[float] = None,
        time: Optional[float] = None,
        background: Optional[Union[Literal["transparent", "studio"], Colour]] = None,
        exposure: Optional[float] = None,
        tone_map: Optional[Literal["none", "filmic"]] = None,
        look: Optional[Look] = None,
        view: Optional[str] = None,
        format: Optional[Literal["png", "png16", "jpeg", "webp", "exr", "npy", "npy_linear"]] = None,
        lossy_quality: Optional[int] = None,
        exr_type: Optional[Literal["half", "float"]] = None,
        aovs: Optional[Sequence[Aov]] = None,
        overlay: Optional[Literal[
            "none", "direction", "strokes", "length", "density", "wetness", "mask", "difference", "bald", "wire"
        ]] = None,
        progressive: Optional[Union[bool, Tracing]] = None,
        overlay_from: Optional[int] = None,
    ) -> Iterator[Frame]:
        """Better and better pictures: shells first, then traced strands. Ends with the last picture, whose
        `trace["end"]` says why it is the last. Where the scene changes meanwhile it begins again with shells.

        width: Width of the picture. 1 to 8192 (pixels). Default 512.
        height: Height of the picture. 1 to 8192 (pixels). Default 512.
        crop: Part of the frame that is drawn alone. The picture has the part's size, and the pixels that the whole
            frame has there; an EXR's display window is the whole frame. `budget_ms` is of the whole frame.
        camera: Where the scene is seen from. Default {"auto": "three_quarter"}.
        quality: A tier, or single knobs. Default "interactive".
        budget_ms: Drawing time, in place of `quality`: takes the knobs whose drawing time keeps to the budget and
            whose error, as 95% of frames keep it, is estimated least; 95% of frames take at most 1.25 times it.
            Drawing time is the milliseconds that pass on this machine while the frame is drawn; waiting for other
            frames, reading and encoding are not in it, nor is growing strands after their coat or their model has
            changed. AOVs of an EXR beside beauty, and overlays, come on top. 1 to 600000 (milliseconds).
        max_error: Error, in place of `quality`: takes the cheapest knobs with at most this error in 95% of frames:
            mean FLIP where there is fur, against the same strands, traced. 1e-06 to 1 (mean FLIP).
        max_seconds: Refuses the frame where drawing is expected to take longer; a dry run says how long. 1 to 86400
            (seconds). Default 60.
        time: Time that the frame shows: the fur as the scene's wind has moved it by then. The scene's own time unless
            given. The same time gives the same picture, whatever was drawn before. -1000000 to 1000000 (seconds).
        background: What is behind the fur. `studio` is a soft gradient with darker corners. Default [0.56, 0.58,
            0.61].
        exposure: How much brighter the picture is made. -20 to 20 (stops). Default 0.
        tone_map: How bright light is brought into the picture's range. Default "filmic".
        look: Look for this frame, in place of the scene's.
        view: Name of the viewer: of several frames asked for one view only the newest is drawn, the others get 409.
            At most 200 bytes. Default "".
        format: Format of the picture. png and png16: 8 and 16 bit sRGB. jpeg: without alpha. webp: lossy as jpeg,
            half as large, ten times slower to make, with alpha. exr: linear light without exposure, tone map and
            background, multiplied by alpha. npy: the pixels of png as a NumPy array of bytes [height, width, 4].
            npy_linear: what an exr of floats holds as a NumPy array of floats [height, width, channels]. Default
            "png".
        lossy_quality: How much jpeg and webp keep of the picture, from 1 on; of these formats only. 0: as the frame's
            quality asks, 80 of a draft, 88 of an interactive frame, 94 beyond. 0 to 100. Default 0.
        exr_type: Type of the channels of an EXR. Depth, position, strand and root are always float. Default "half".
        aovs: AOVs (arbitrary output variables) that the file holds, for exr and npy_linear; `[beauty]` when absent.
            Drawn pixels times AOVs are at most 67108864. Channels: R, G, B, A of beauty; A of alpha; Z of depth;
            AOV.X, .Y, .Z of position, normal, tangent and root; AOV.R, .G, .B of albedo and direct; AOV.Y of shadow
            and sample_count; strand.id, .along and .coat. 1 to 12 items.
        overlay: Shows a field on the fur. Not in linear light. density, wetness and mask go from dark violet for 0 to
            yellow for 1. difference: how much the fields have changed since `overlay_from`, with the same colours: of
            the field that changed most, the change over what counts as much (direction and colours: 1; length: the
            longest fur; others: the field's range). Grey where nothing changed. bald and wire hide the frame: the
            skin in plain grey without its fur, to find places on it, and the same with the edges of its triangles.
            Default "none".
        progressive: Draws rasterized strands at once; all strands of the same revision are then traced while somebody
            waits for them with `after` and `after_pass`. true takes the defaults of Tracing. Pictures may skip
            passes; answers are to this same request, sent again. Name the `view`: what is traced is dropped as soon
            as the scene changes, the same view asks for something else, or nobody has asked for 30 seconds. Refused
            with 503 while 16 pictures wait to be traced.
        overlay_from: Revision that the overlay `difference` compares what is drawn with: one of this model. Only with
            it. 0 to 18446744073709551615.
        """
        return self._better_frames(
            {
                "width": width, "height": height, "crop": crop, "camera": camera, "quality": quality,
                "budget_ms": budget_ms, "max_error": max_error, "max_seconds": max_seconds, "time": time,
                "background": background, "exposure": exposure, "tone_map": tone_map, "look": look, "view": view,
                "format": format, "lossy_quality": lossy_quality, "exr_type": exr_type, "aovs": aovs,
                "overlay": overlay, "progressive": progressive, "overlay_from": overlay_from,
            },
        )

    def load(
        self,
        path: Path,
        *,
        format: Optional[Literal["obj", "ply", "stl", "off", "gltf", "glb", "3ds", "zip"]] = None,
        up: Optional[Literal["x", "-x", "y", "-y", "z", "-z"]] = None,
        front: Optional[Literal["x", "-x", "y", "-y", "z", "-z"]] = None,
        pose: Optional[str] = None,
        crease_degrees: Optional[float] = None,
        flip: Optional[Sequence[int]] = None,
        two_sided: Optional[Sequence[int]] = None,
        length: Optional[float] = None,
        inclination: Optional[float] = None,
        form: Optional[Literal["even", "animal"]] = None,
        fur_patches: Optional[FurPatches] = None,
        discard: bool = False,
        if_match: Optional[int] = None,
        progress: Optional[ReportProgress] = None,
    ) -> SceneInfo:
        """Gives the scene a model from a file; its log starts empty. An OBJ's or a .gltf's files that it names go
        with it; one that is not there gives a UserWarning. Not repeated when the connection is lost on the way.

        path: Of the model. `format` follows from its ending unless given.
        format: Format of the file.
        up: The file's axis that points up. Unless given: z of stl, else y.
        front: The file's axis that the model faces, on another line than `up`. Unless given it follows from joints
            that are called left and right; without such -y where z is up, else z.
        pose: Moment of an animation of a glTF as NAME@SECONDS, at most 200 bytes: the model stands as it shows it
            then. Unless given it stands as the file has it. Default "".
        crease_degrees: An edge whose triangles' normals differ by more is seen as an edge, and skin and fur beside it
            are lit by their own side alone; 180: none is. 0 to 180 (degrees). Default 60.
        flip: Parts that are turned inside out, by the numbers that `doubtful_parts` of the answer gives. 0 to 1000
            items.
        two_sided: Parts of one layer that get a back, so that fur grows on both sides, by the numbers that `sheets`
            of the answer gives; the only part of a model is 1. 0 to 1000 items.
        length: Length of the first fur. 0 to 10 (sizes). Default 0.03.
        inclination: How far fur leans: 0 upright, 1 lying. Where fur begins, ends and parts it stands up. 0 to 1
            (share). Default 0.45.
        form: How lengths differ over the body. animal: shorter on face and paws, longer on chest and tail, estimated
            from where they lie in the model's box. Default "animal".
        fur_patches: How the sample tile of fur is laid on the surface, once: patches with soft overlaps; the same
            with hard borders, where nothing is drawn twice; or by the model's own texture coordinates, which of the
            built-in models torus, knot, plane and cloth have. Default "overlapping".
        discard: Loads it though the groom that the scene has is lost. Unless given `Conflict` is raised for such a
            scene; it says how many commands that is.
        if_match: A revision. At another one nothing is done, and `Conflict` is raised.
        progress: Called with how much of the file is sent.
        """
        return self._load(
            {
                "format": format, "up": up, "front": front, "pose": pose, "crease_degrees": crease_degrees,
                "flip": flip, "two_sided": two_sided, "length": length, "inclination": inclination, "form": form,
                "fur_patches": fur_patches,
            },
            path,
            discard,
            if_match,
            progress,
        )

    def upload_environment(
        self,
        picture: Union[bytes, Path],
        *,
        intensity: Optional[float] = None,
        turn_degrees: Optional[float] = None,
        author: Optional[str] = None,
        if_match: Optional[int] = None,
        progress: Optional[ReportProgress] = None,
    ) -> CommandAnswer:
        """Lights the scene from all around with an EXR or a Radiance HDR, as one undo step.

        picture: The bytes of a file, or its path.
        intensity: Factor on its light. 0 to 100 (factor). Default 1.
        turn_degrees: How far the harmonics are turned about +y, counter-clockwise seen from above. -360 to 360
            (degrees). Default 0.
        author: Who makes the change, for the log; at most 200 bytes of UTF-8.
        if_match: A revision. At another one nothing is done, and `Conflict` is raised.
        progress: Called with how much of the file is sent.
        """
        return self._upload_environment(
            {"intensity": intensity, "turn_degrees": turn_degrees},
            picture,
            author,
            if_match,
            progress,
        )

    def download_map(
        self,
        field: Field,
        *,
        encoding: Optional[MapEncoding] = None,
        scale: Optional[float] = None,
        units: Optional[Units] = None,
        format: Optional[Literal["png", "png16", "exr", "exr_half", "npy"]] = None,
        size: Optional[int] = None,
        dilate: Optional[int] = None,
        tile: Optional[int] = None,
    ) -> FieldMap:
        """A field as a square picture through the model's texture coordinates.

        field: The field.
        encoding: What the pixels hold. value: a number, or a colour and its cover. uv_tangent: direction along +u and
            +v in red and green, .5 is 0. fast_fur: the same, with width in blue and density in alpha. vector:
            direction and length as one vector of floats, along +u, +v and the normal. automatic: uv_tangent of
            direction, else value. Default "automatic".
        scale: What 1 in the picture stands for, in the field's unit; of fast_fur the width, of vector the length.
            Unless given the field's largest value for PNG, else 1. 1e-27 to 1e+27 (as `units`).
        units: Unit of a scale of lengths. Default "relative".
        format: Format of the file: 8 or 16 bits, an EXR of floats or halfs, or a NumPy array of floats: [size, size]
            or [size, size, channels], rows from the top; of `vertices` [vertices] or [vertices, channels], without
            size and dilate. Default "png16".
        size: Width and height. Above 4096 one map is made at a time. 1 to 8192 (pixels). Default 1024.
        dilate: How far islands grow over their seams. 0 to 64 (pixels). Default 8.
        tile: UDIM tile to draw, from 1001; 0: all of them over one another. 0 to 9999. Default 0.
        """
        return self._download_map(
            {
                "encoding": encoding, "scale": scale, "units": units, "format": format, "size": size,
                "dilate": dilate, "tile": tile,
            },
            field,
        )

    def upload_map(
        self,
        field: Field,
        picture: Union[bytes, Path],
        *,
        encoding: Optional[MapEncoding] = None,
        scale: Optional[float] = None,
        units: Optional[Units] = None,
        strength: Optional[float] = None,
        tile: Optional[int] = None,
        author: Optional[str] = None,
        if_match: Optional[int] = None,
        progress: Optional[ReportProgress] = None,
    ) -> CommandAnswer:
        """Reads a field from a picture through the model's texture coordinates, as one undo step.

        field: The field.
        picture: The bytes of a file, or its path.
        encoding: What the pixels hold. value: a number, or a colour and its cover. uv_tangent: direction along +u and
            +v in red and green, .5 is 0. fast_fur: the same, with width in blue and density in alpha. vector:
            direction and length as one vector of floats, along +u, +v and the normal. automatic: uv_tangent of
            direction, else value. Default "automatic".
        scale: What 1 in the picture stands for. With neither it nor `units`: what the file says of itself, else 1.
            1e-27 to 1e+27 (as `units`).
        units: Unit of a scale of lengths. Default "relative".
        strength: How far the field goes to the picture's. 0 to 1 (share). Default 1.
        tile: UDIM tile that the picture is of, from 1001: only vertices that lie in it change. 0: the picture
            repeats, and all do. 0 to 9999. Default 0.
        author: Who makes the change, for the log; at most 200 bytes of UTF-8.
        if_match: A revision. At another one nothing is done, and `Conflict` is raised.
        progress: Called with how much of the file is sent.
        """
        return self._upload_map(
            {"encoding": encoding, "scale": scale, "units": units, "strength": strength, "tile": tile},
            field,
            picture,
            author,
            if_match,
            progress,
        )

    def upload_guides(
        self,
        curves: Union[bytes, Path],
        *,
        format: Optional[Literal["usda", "hair", "json"]] = None,
        keys: Optional[int] = None,
        sigma: Optional[float] = None,
        strength: Optional[float] = None,
        author: Optional[str] = None,
        if_match: Optional[int] = None,
        progress: Optional[ReportProgress] = None,
    ) -> CommandAnswer:
        """Lets the fur follow guide curves in the model's coordinates, root first, as one undo step.

        curves: The bytes of a file, or its path. `format` follows from the path's ending unless given.
        format: Format of the file.
        keys: Curves that are used at most, chosen evenly by their order; fewer where the model has so many vertices
            that they would be too much work. 1 to 1024. Default 1024.
        sigma: Width of the Gaussians that spread them; from the distance between roots unless given. 1e-06 to 1000000
            (sizes).
        strength: 0 does nothing, 1 all. 0 to 1 (share). Default 1.
        author: Who makes the change, for the log; at most 200 bytes of UTF-8.
        if_match: A revision. At another one nothing is done, and `Conflict` is raised.
        progress: Called with how much of the file is sent.
        """
        return self._upload_guides(
            {"format": format, "keys": keys, "sigma": sigma, "strength": strength},
            curves,
            author,
            if_match,
            progress,
        )

    def map_array(
        self,
        field: Field,
        *,
        encoding: Optional[MapEncoding] = None,
        scale: Optional[float] = None,
        units: Optional[Units] = None,
        size: Optional[int] = None,
        dilate: Optional[int] = None,
        tile: Optional[int] = None,
    ) -> NDArray[numpy.float32]:
        """A field as a NumPy array through the model's texture coordinates: float32 [size, size], or [size, size,
        channels], row 0 at the top. Numbers are over the scale.

        field: The field.
        encoding: What the pixels hold. value: a number, or a colour and its cover. uv_tangent: direction along +u and
            +v in red and green, .5 is 0. fast_fur: the same, with width in blue and density in alpha. vector:
            direction and length as one vector of floats, along +u, +v and the normal. automatic: uv_tangent of
            direction, else value. Default "automatic".
        scale: What 1 in the picture stands for, in the field's unit; of fast_fur the width, of vector the length.
            Unless given the field's largest value for PNG, else 1. 1e-27 to 1e+27 (as `units`).
        units: Unit of a scale of lengths. Default "relative".
        size: Width and height. Above 4096 one map is made at a time. 1 to 8192 (pixels). Default 1024.
        dilate: How far islands grow over their seams. 0 to 64 (pixels). Default 8.
        tile: UDIM tile to draw, from 1001; 0: all of them over one another. 0 to 9999. Default 0.
        """
        return self._map_array(
            {"encoding": encoding, "scale": scale, "units": units, "size": size, "dilate": dilate, "tile": tile},
            field,
        )

    def export(
        self,
        path: Path,
        *,
        format: Optional[Literal["usda", "hair", "shells", "cards", "fields", "pelage"]] = None,
        every: Optional[int] = None,
        widen: Optional[bool] = None,
        curves: Optional[bool] = None,
        shells: Optional[int] = None,
        cards: Optional[int] = None,
    ) -> ExportAbout:
        """Writes the groom to a file in another program's format. The file appears whole or not at all.

        path: Where to; what is there is replaced. `format` follows from its ending unless given.
        format: What is written, as the operation says.
        every: Writes about one strand of so many, chosen by numbers of their own; above 1 they count as guides,
            unless they are widened. 1 to 1000000. Default 1.
        widen: Makes strands `every` times as wide, which keeps what they cover. Default false.
        curves: Whether whiskers, lashes and brows are in it. Default true.
        shells: Number of layers; of format `shells` only. 1 to 32. Default 16.
        cards: Number of cards of the finest level, about; of format `cards` only. 100 to 200000. Default 6000.
        """
        return self._export(
            {"format": format, "every": every, "widen": widen, "curves": curves, "shells": shells, "cards": cards},
            path,
        )

    def export_about(
        self,
        *,
        format: Literal["usda", "hair", "shells", "cards", "fields", "pelage"],
        every: Optional[int] = None,
        widen: Optional[bool] = None,
        curves: Optional[bool] = None,
        shells: Optional[int] = None,
        cards: Optional[int] = None,
    ) -> ExportAbout:
        """What such a file would hold; nothing is written.

        format: What is written, as the operation says.
        every: Writes about one strand of so many, chosen by numbers of their own; above 1 they count as guides,
            unless they are widened. 1 to 1000000. Default 1.
        widen: Makes strands `every` times as wide, which keeps what they cover. Default false.
        curves: Whether whiskers, lashes and brows are in it. Default true.
        shells: Number of layers; of format `shells` only. 1 to 32. Default 16.
        cards: Number of cards of the finest level, about; of format `cards` only. 100 to 200000. Default 6000.
        """
        return self._export_about(
            {"format": format, "every": every, "widen": widen, "curves": curves, "shells": shells, "cards": cards},
        )

    def pick(
        self,
        x: float,
        y: float,
        *,
        camera: Optional[Union[AutoView, Camera]] = None,
        width: Optional[int] = None,
        height: Optional[int] = None,
        reach: Literal["skin", "fur"] = "fur",
    ) -> Pick:
        """What lies under a pixel of a view: triangle, position, normal and what is painted there; `{"hit":
        False}` where no skin is. `strand` is the one that is seen there, if any.

        x: Pixels from the left; centres at .5.
        y: Pixels from the top; centres at .5.
        camera: A view that the server frames, or a pinhole camera, whose position differs from its target and whose
            up is not along the view. Default {"auto": "three_quarter"}.
        width: Width of the picture. 1 to 8192 (pixels). Default 512.
        height: Height of the picture. 1 to 8192 (pixels). Default 512.
        reach: skin: leaves the strand out, and answers at once.
        """
        return self._pick(
            {"camera": camera, "width": width, "height": height},
            x,
            y,
            reach,
        )

    def mesh(
        self,
        *,
        triangles: Optional[int] = None,
    ) -> bytes:
        """A light mesh of the model, as binary glTF.

        triangles: Largest count of triangles; more come where the model cannot be made simpler. 100 to 200000.
            Default 20000.
        """
        return self._mesh(
            {"triangles": triangles},
        )

    def subdivide(
        self,
        *,
        levels: Optional[int] = None,
        masked: Optional[bool] = None,
        if_match: Optional[int] = None,
    ) -> SceneInfo:
        """Splits the triangles of the field mesh; its undo log starts empty.

        levels: How often triangles are split. 1 to 8. Default 1.
        masked: Only triangles with a corner whose mask is above 0.5, and their neighbours so that no crack opens.
            Default false.
        if_match: A revision. At another one nothing is done, and `Conflict` is raised.
        """
        return self._subdivide(
            {"levels": levels, "masked": masked},
            if_match,
        )

    def _frame(
        self,
        members: Dict[str, Any],
        progress: Optional[ReportProgress],
    ) -> Frame:
        raise NotImplementedError

    def _save_frame(
        self,
        members: Dict[str, Any],
        path: Path,
        progress: Optional[ReportProgress],
    ) -> Frame:
        raise NotImplementedError

    def _frame_cost(
        self,
        members: Dict[str, Any],
    ) -> FrameCost:
        raise NotImplementedError

    def _frame_array(
        self,
        members: Dict[str, Any],
        linear: bool,
        progress: Optional[ReportProgress],
    ) -> NDArray[Any]:
        raise NotImplementedError

    def _live_frames(
        self,
        members: Dict[str, Any],
    ) -> Iterator[Frame]:
        raise NotImplementedError

    def _better_frames(
        self,
        members: Dict[str, Any],
    ) -> Iterator[Frame]:
        raise NotImplementedError

    def _load(
        self,
        members: Dict[str, Any],
        path: Path,
        discard: bool,
        if_match: Optional[int],
        progress: Optional[ReportProgress],
    ) -> SceneInfo:
        raise NotImplementedError

    def _upload_environment(
        self,
        members: Dict[str, Any],
        picture: Union[bytes, Path],
        author: Optional[str],
        if_match: Optional[int],
        progress: Optional[ReportProgress],
    ) -> CommandAnswer:
        raise NotImplementedError

    def _download_map(
        self,
        members: Dict[str, Any],
        field: Field,
    ) -> FieldMap:
        raise NotImplementedError

    def _upload_map(
        self,
        members: Dict[str, Any],
        field: Field,
        picture: Union[bytes, Path],
        author: Optional[str],
        if_match: Optional[int],
        progress: Optional[ReportProgress],
    ) -> CommandAnswer:
        raise NotImplementedError

    def _upload_guides(
        self,
        members: Dict[str, Any],
        curves: Union[bytes, Path],
        author: Optional[str],
        if_match: Optional[int],
        progress: Optional[ReportProgress],
    ) -> CommandAnswer:
        raise NotImplementedError

    def _map_array(
        self,
        members: Dict[str, Any],
        field: Field,
    ) -> NDArray[numpy.float32]:
        raise NotImplementedError

    def _export(
        self,
        members: Dict[str, Any],
        path: Path,
    ) -> ExportAbout:
        raise NotImplementedError

    def _export_about(
        self,
        members: Dict[str, Any],
    ) -> ExportAbout:
        raise NotImplementedError

    def _pick(
        self,
        members: Dict[str, Any],
        x: float,
        y: float,
        reach: Literal["skin", "fur"],
    ) -> Pick:
        raise NotImplementedError

    def _mesh(
        self,
        members: Dict[str, Any],
    ) -> bytes:
        raise NotImplementedError

    def _subdivide(
        self,
        members: Dict[str, Any],
        if_match: Optional[int],
    ) -> SceneInfo:
        raise NotImplementedError
