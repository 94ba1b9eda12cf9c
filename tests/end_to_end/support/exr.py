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
    """The header's attributes by OpenImageIO's names."""
    with opened(content) as picture:
        return {attribute.name: attribute.value for attribute in picture.spec().extra_attribs}


def read_exr(content):
    """Channels by name, rows x columns each."""
    with opened(content) as picture:
        pixels = picture.read_image(OpenImageIO.FLOAT)
        if pixels is None:
            raise ValueError(picture.geterror())
        return {name: pixels[:, :, k].astype(float) for k, name in enumerate(picture.spec().channelnames)}
