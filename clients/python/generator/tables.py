"""The methods that are not commands, and the operation of the contract that each one uses."""

from typing import NamedTuple

OPTIONS = {
    "author": "        author: Optional[str] = None,",
    "dry_run": "        dry_run: bool = False,",
    "if_match": "        if_match: Optional[int] = None,",
}

AUTHOR = ("author", "Optional[str]", "None", "Who makes the change, for the log; at most 200 bytes of UTF-8.")
DISCARD = ("discard", "bool", "False",
           "Begins with a first groom of its own; the groom that the scene has is lost. Unless given a groomed scene keeps "
           "it, as `carried` in what is returned says; the scene as it was stays beside it.")
IF_MATCH = ("if_match", "Optional[int]", "None", "A revision. At another one nothing is done, and `Conflict` is raised.")
PROGRESS = ("progress", "Optional[ReportProgress]", "None",
            "Called about once a second, on another thread, with how far the frame is.")
UPLOADED = ("progress", "Optional[ReportProgress]", "None", "Called with how much of the file is sent.")
PICTURE = ("picture", "Union[bytes, Path]", None, "The bytes of a file, or its path.")
PATH = ("path", "Path", None)


class Request(NamedTuple):
    """A method whose parameters are members of a schema.

    without: Members of the schema that are no parameters.
    optional: Members that the schema requires but the method can find itself.
    parameters: Additional parameters: name, type, default (None: none, and positional) and description.
    """

    name: str
    schema: str
    returns: str
    summary: str
    without: tuple = ()
    optional: tuple = ()
    parameters: tuple = ()


REQUESTS = (
    Request("frame", "FrameRequest", "Frame",
            "Draws the scene. `camera` is also taken as a word, such as \"front\".", ("progressive",),
            parameters=(PROGRESS,)),
    Request("save_frame", "FrameRequest", "Frame",
            "Draws the scene to a file: .png, .jpg, .jpeg, .webp, .exr or .npy. Another ending raises ValueError before anything "
            "is drawn. The file appears whole or not at all.", ("progressive",),
            parameters=((*PATH, "Where to; what is there is replaced."), PROGRESS)),
    Request("frame_cost", "FrameRequest", "FrameCost",
            "What drawing such a frame is expected to take; nothing is drawn.", ("progressive",)),
    Request("frame_array", "FrameRequest", "NDArray[Any]",
            "Draws the scene to a NumPy array: [height, width, 4], uint8 sRGB, row 0 at the top. With `linear` float32 "
            "[height, width, channels]: linear light multiplied by alpha, the channels of `aovs` in their order.",
            ("progressive", "format", "lossy_quality", "exr_type"),
            parameters=(("linear", "bool", "False", "Linear light, without exposure, tone map and background."), PROGRESS)),
    Request("live_frames", "FrameRequest", "Iterator[Frame]",
            "Frames without an end: one now, and one each time the scene has changed. A scene that is removed raises "
            "`NotFound`.", ("progressive", "revision")),
    Request("better_frames", "FrameRequest", "Iterator[Frame]",
            "Better and better pictures: shells first, then traced strands. Ends with the last picture, whose "
            "`trace[\"end\"]` says why it is the last. Where the scene changes meanwhile it begins again with shells.",
            ("revision",)),
    Request("load", "ImportOptions", "SceneInfo",
            "Gives the scene a model from a file; its log starts empty. An OBJ's or a .gltf's files that it names go with "
            "it; one that is not there gives a UserWarning. Not repeated when the connection is lost on the way.",
            optional=("format",),
            parameters=((*PATH, "Of the model. `format` follows from its ending unless given."), DISCARD, IF_MATCH, UPLOADED)),
    Request("upload_environment", "EnvironmentUpload", "CommandAnswer",
            "Lights the scene from all around with an EXR or a Radiance HDR, as one undo step.",
            parameters=(PICTURE, AUTHOR, IF_MATCH, UPLOADED)),
    Request("download_map", "MapRequest", "FieldMap",
            "A field as a square picture through the model's texture coordinates.", ("field",),
            parameters=(("field", "Field", None, "The field."),)),
    Request("upload_map", "MapUpload", "CommandAnswer",
            "Reads a field from a picture through the model's texture coordinates, as one undo step.", ("field",),
            parameters=(("field", "Field", None, "The field."), PICTURE, AUTHOR, IF_MATCH, UPLOADED)),
    Request("upload_guides", "GuideUpload", "CommandAnswer",
            "Lets the fur follow guide curves in the model's coordinates, root first, as one undo step.",
            optional=("format",),
            parameters=(("curves", "Union[bytes, Path]", None,
                         "The bytes of a file, or its path. `format` follows from the path's ending unless given."),
                        AUTHOR, IF_MATCH, UPLOADED)),
    Request("map_array", "MapRequest", "NDArray[numpy.float32]",
            "A field as a NumPy array through the model's texture coordinates: float32 [size, size], or "
            "[size, size, channels], row 0 at the top. Numbers are over the scale.", ("field", "format"), parameters=(("field", "Field", None, "The field."),)),
    Request("export", "ExportRequest", "ExportAbout",
            "Writes the groom to a file in another program's format. The file appears whole or not at all.",
            optional=("format",),
            parameters=((*PATH, "Where to; what is there is replaced. `format` follows from its ending unless given."),)),
    Request("export_about", "ExportRequest", "ExportAbout", "What such a file would hold; nothing is written."),
    Request("pick", "View", "Pick",
            "What lies under a pixel of a view: triangle, position, normal and what is painted there; `{\"hit\": False}` "
            "where no skin is. `strand` is the one that is seen there, if any.",
            parameters=(("x", "float", None, "Pixels from the left; centres at .5."),
                        ("y", "float", None, "Pixels from the top; centres at .5."),
                        ("reach", 'Literal["skin", "fur"]', '"fur"', "skin: leaves the strand out, and answers at once."))),
    Request("mesh", "MeshRequest", "bytes", "A light mesh of the model, as binary glTF."),
    Request("subdivide", "Subdivide", "SceneInfo",
            "Splits the triangles of the field mesh; its undo log starts empty.", parameters=(IF_MATCH,)),
    Request("turn", "TurnModel", "SceneInfo",
            "Turns the model to stand another way, with its fur; its undo log starts empty.", parameters=(IF_MATCH,)),
)
