"""Reads the EXR that frames come as, by OpenImageIO."""

import tempfile
from contextlib import contextmanager

import numpy
import OpenImageIO


@contextmanager
def opened(content):
    with tempfile.NamedTemporaryFile(suffix=".exr") as file:
        file.write(content)
        file.flush()
        picture = OpenImageIO.ImageInput.open(file.name)
        if picture is None:
            raise ValueError(OpenImageIO.geterror())
        yield picture
        picture.close()


def read_attributes(content):
    """The header's attributes by OpenImageIO's names, with the windows and the channels."""
    with opened(content) as picture:
        spec = picture.spec()
        return {"dataWindow": (spec.x, spec.y, spec.width, spec.height),
                "displayWindow": (spec.full_x, spec.full_y, spec.full_width, spec.full_height),
                "channels": [(name, str(spec.channelformat(k))) for k, name in enumerate(spec.channelnames)],
                **{attribute.name: attribute.value for attribute in spec.extra_attribs}}


def read_exr(content):
    """Channels by name, rows x columns each."""
    with opened(content) as picture:
        pixels = picture.read_image(OpenImageIO.FLOAT)
        if pixels is None:
            raise ValueError(picture.geterror())
        return {name: pixels[:, :, k].astype(float) for k, name in enumerate(picture.spec().channelnames)}
