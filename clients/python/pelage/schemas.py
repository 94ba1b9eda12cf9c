"""Types of what is sent and answered, a TypedDict for each object of the contract. Made by generate.py.

Members that may be left out are those of classes with `total=False`. Lengths are in sizes, fractions of the diagonal of
the model's box, unless `units` says otherwise; positions are in the model's own coordinates.
"""

from __future__ import annotations

from typing import Any, Dict, Literal, Sequence, TypedDict, Union

Position = Sequence[float]
"""A point in the model's own coordinates, right-handed with Y up."""
Direction = Sequence[float]
"""A vector of any length in [1e-6, 1e6]; only where it points counts."""
Barycentric = Sequence[float]
"""Weights of the triangle's corners; their sum is within 0.001 of 1."""
Colour = Union[str, Sequence[float]]
"""A colour: sRGB as `#rrggbb`, or linear red, green and blue."""
PictureName = str
"""The name that the upload of a picture was answered with."""
FieldsHash = str
"""Hash of all fields: the same fur has the same hash."""
FurPatches = Literal["overlapping", "hard", "own_uvs"]
"""How the sample tile of fur is laid on the surface, once: patches with soft overlaps; the same with hard borders,
where nothing is drawn twice; or by the model's own texture coordinates, which of the built-in models torus, knot,
plane and cloth have.
"""
AutoView = Literal["front", "back", "left", "right", "top", "three_quarter"]
"""A camera that the server places. `front` looks from +Z, `left` from +X: it shows the animal's left. Each frames
the bare model, never the fur.
"""
Units = Literal["relative", "world"]
"""What lengths are in. relative: sizes, fractions of the diagonal of the model's box. world: the model's unit."""
Field = Literal[
    "direction", "length", "stretch", "density", "width", "curl", "clump", "wetness", "bare", "mask", "root_colour",
    "tip_colour", "stiffness"
]
"""A field on the surface. direction: where fur leans, its length is the inclination. length: sizes. density, bare
and mask: shares. width: of the coat's, at most 4. curl, clump and wetness: added to the coat's. root_colour and
tip_colour: linear colour and how much it covers.
"""
MapEncoding = Literal["automatic", "value", "uv_tangent", "fast_fur", "vector", "vertices"]
"""What the pixels hold. value: a number, or a colour and its cover. uv_tangent: direction along +u and +v in red
and green, .5 is 0. fast_fur: the same, with width in blue and density in alpha. vector: direction and length as
one vector of floats, along +u, +v and the normal. automatic: uv_tangent of direction, else value.
"""
Tier = Literal["draft", "interactive", "detailed", "reference"]
"""How well a frame is drawn. draft, interactive and detailed rasterize more and more of the strands that reference
traces.
"""
Aov = Literal[
    "beauty", "alpha", "depth", "position", "normal", "tangent", "albedo", "direct", "shadow", "sample_count",
    "strand", "root"
]
"""An AOV (arbitrary output variable) of a frame. All but beauty and alpha leave out the ground. Beauty, albedo and
direct are multiplied by alpha; position, normal, tangent and shadow are means over what covers the pixel. depth:
distance along the view of what first brings the opacity over half (skin, fur, eyes, hairs and curves), in the
model's unit; infinity where there is none. position: the model's own coordinates. normal: of the skin below, of an
eye's ball and cornea. tangent: of fur, hairs and curves, from root to tip; 0 on bare skin and eyes. direct: what
lights add, without the ambient part. shadow: share of that light that shadows leave, 1 where none comes and on
eyes, which take no shadow. sample_count: segments of strands that were blended in the pixel; of traced strands the
samples that were taken. strand: the one that covers most of the pixel: its number from 1 on, the same in all
frames of a revision with one coat; where on it, from 0 at its root to 1 at its tip; and 1 for the coat, 2 for
curves such as whiskers. 0 where skin, eyes or nothing shows more. root: where that strand stands, in the model's
own coordinates. Both of rasterized strands only.
"""
PickRequest = Union[Dict[str, Any]]
"""The place that is meant: what lies under a pixel of a view; or the first that a ray hits, the farthest along a
direction, or the nearest to a point.
"""


class Sample(TypedDict, total=False):
    """One place, as a position, a pixel of the stroke's view, or a triangle with barycentrics.

    position: A point on the skin, in the fur or anywhere else. 3 items (model units).
    screen: A pixel of the stroke's view: from the top left, y down, centres at .5. 2 items (pixels).
    triangle: Number of a triangle. 0 to 4294967295.
    barycentric: Weights of the triangle's corners; their sum is within 0.001 of 1. 3 items (share).
    pressure: Scales the brush's strength. 0 to 1 (share). Default 1.
    time: When the brush was there; never earlier than the sample before. 0 to 1000000 (seconds). Default 0.
    """

    position: Position
    screen: Sequence[float]
    triangle: int
    barycentric: Barycentric
    pressure: float
    time: float


class _StrokeRequired(TypedDict):
    samples: Sequence[Sample]


class Stroke(_StrokeRequired, total=False):
    """Where a brush goes, as samples in order. It can be sent in parts.

    id: Parts with one id join one undo step. Empty for a stroke sent whole. At most 200 bytes. Default "".
    part: Number of the part, from 0. 0 to 4294967295. Default 0.
    last: Whether no part comes after this one. Default true.
    view: Required by pixel samples; front faces are then judged against it.
    samples: Places that the brush passes, in order. 1 to 10000 items.
    """

    id: str
    part: int
    last: bool
    view: View


class _CombRequired(TypedDict):
    op: Literal["comb"]


class Comb(_CombRequired, total=False):
    """Turns fur the way the stroke moves; as a flood, to `direction` everywhere.

    stroke: Where a brush goes, as samples in order. It can be sent in parts.
    brush: How far and how strongly a tool reaches round a stroke.
    edit_layer: Edit layer that keeps what changes; the groom below all edit layers unless named. Default "".
    flood: Works everywhere in place of under a stroke. Default false.
    lean: Inclination that combing tends to: 0 upright, 1 lying. 0 to 1 (share). Default 0.7.
    keep_inclination: Turns the heading alone. Default false.
    direction: Where fur is turned to as a flood. Required by a flood, refused with a stroke. 3 items (any length).
    op: Name of the command.
    """

    stroke: Stroke
    brush: Brush
    edit_layer: str
    flood: bool
    lean: float
    keep_inclination: bool
    direction: Direction


class _BlowRequired(TypedDict):
    op: Literal["blow"]


class Blow(_BlowRequired, total=False):
    """Wind from a source, or from a blower that stays, inside a cone. A stroke restricts it to what its brush
    covers.

    stroke: Where a brush goes, as samples in order. It can be sent in parts.
    brush: How far and how strongly a tool reaches round a stroke.
    edit_layer: Edit layer that keeps what changes; the groom below all edit layers unless named. Default "".
    blower: Name of a blower of the scene, in place of all that follows. Default "".
    source: Where the wind comes from. 3 items (model units).
    direction: Where the wind blows, the axis of its cone. 3 items (any length). Default [0, -1, 0].
    cone_degrees: Half angle of the cone. 0 to 180 (degrees). Default 40.
    softness: Share of the cone over which its edge fades. 0 to 1 (share). Default 0.25.
    fall: Distance at which the wind has half its strength, in `units`; 0: it does not fall. 0 to 1e+27 (as `units`).
        Default 0.
    units: What lengths are in. relative: sizes, fractions of the diagonal of the model's box. world: the model's
        unit. Default "relative".
    strength: How much it changes: 0 does nothing, 1 all. 0 to 1 (share). Default 0.5.
    lean: Inclination that the wind tends to: 0 upright, 1 lying. 0 to 1 (share). Default 0.7.
    op: Name of the command.
    """

    stroke: Stroke
    brush: Brush
    edit_layer: str
    blower: str
    source: Position
    direction: Direction
    cone_degrees: float
    softness: float
    fall: float
    units: Units
    strength: float
    lean: float


class _AttractRequired(TypedDict):
    op: Literal["attract"]


class Attract(_AttractRequired, total=False):
    """A stick, or an attractor that stays, pulls fur to it and stretches it. A stroke restricts it to what its
    brush covers.

    stroke: Where a brush goes, as samples in order. It can be sent in parts.
    brush: How far and how strongly a tool reaches round a stroke.
    edit_layer: Edit layer that keeps what changes; the groom below all edit layers unless named. Default "".
    attractor: Name of an attractor of the scene, in place of all that follows. Default "".
    point: Where the stick is. 3 items (model units).
    radius: Distance beyond which nothing is pulled, in `units`; at most 1000000 sizes. 0 to 1e+27 (as `units`).
        Default 0.2.
    units: What lengths are in. relative: sizes, fractions of the diagonal of the model's box. world: the model's
        unit. Default "relative".
    strength: How much it changes: 0 does nothing, 1 all. 0 to 1 (share). Default 0.5.
    duration: How long the stick pulls. 0 to 10000 (seconds). Default 1.
    threshold: Stretch that fur takes without growing. 0 to 1000 (share). Default 0.3.
    max_stretch: Largest length over the length before any stretch. 1 to 100 (factor). Default 3.
    op: Name of the command.
    """

    stroke: Stroke
    brush: Brush
    edit_layer: str
    attractor: str
    point: Position
    radius: float
    units: Units
    strength: float
    duration: float
    threshold: float
    max_stretch: float


class _KeyRequired(TypedDict):
    position: Position


class Key(_KeyRequired, total=False):
    """What fur is like at one place: a direction, a length or both.

    position: Where the key lies; the nearest place on the surface is meant. 3 items (model units).
    direction: Where fur leans there. Without it the key says a length alone. 3 items (any length).
    inclination: How far fur leans there: 0 upright, 1 lying. It needs a direction and is 0.5 unless given. 0 to 1
        (share).
    length: Length of the fur there, in `units`; at most 10 sizes. 0 to 1e+27 (as `units`).
    """

    direction: Direction
    inclination: float
    length: float


class _TrimRequired(TypedDict):
    op: Literal["trim"]


class Trim(_TrimRequired, total=False):
    """Cuts fur by a plane, by a sphere or to a height over the skin, by the way that it leans. A flood cuts
    wholly, whatever the strength.

    stroke: Where a brush goes, as samples in order. It can be sent in parts.
    brush: How far and how strongly a tool reaches round a stroke.
    edit_layer: Edit layer that keeps what changes; the groom below all edit layers unless named. Default "".
    flood: Works everywhere in place of under a stroke. Default false.
    plane: Plane that fur is cut by.
    sphere: Sphere that fur is cut by.
    height: Height over the skin that fur is cut to, in `units`; at most 1000000 sizes. 0 to 1e+27 (as `units`).
    units: What lengths are in. relative: sizes, fractions of the diagonal of the model's box. world: the model's
        unit. Default "relative".
    op: Name of the command.
    """

    stroke: Stroke
    brush: Brush
    edit_layer: str
    flood: bool
    plane: TrimPlane
    sphere: TrimSphere
    height: float
    units: Units


class _EraseRequired(TypedDict):
    op: Literal["erase"]


class Erase(_EraseRequired, total=False):
    """Goes back to the first groom, or to a checkpoint or a revision of this scene; with a layer and neither of
    them, takes away what the layer adds. The mask stays unless it is named.

    stroke: Where a brush goes, as samples in order. It can be sent in parts.
    brush: How far and how strongly a tool reaches round a stroke.
    edit_layer: Edit layer that keeps what changes; the groom below all edit layers unless named. Default "".
    flood: Works everywhere in place of under a stroke. Default false.
    checkpoint: Name of the checkpoint to go back to. Empty: the first groom, or `revision`. Default "".
    revision: Revision of this model to go back to. 0 to 18446744073709551615.
    fields: Fields that go back; all but the mask when empty. 0 to 13 items. Default [].
    op: Name of the command.
    """

    stroke: Stroke
    brush: Brush
    edit_layer: str
    flood: bool
    checkpoint: str
    revision: int
    fields: Sequence[Field]


class _PaintRequired(TypedDict):
    op: Literal["paint"]


class Paint(_PaintRequired, total=False):
    """Paints a field; inverted it takes it back to its default.

    stroke: Where a brush goes, as samples in order. It can be sent in parts.
    brush: How far and how strongly a tool reaches round a stroke.
    edit_layer: Edit layer that keeps what changes; the groom below all edit layers unless named. Default "".
    flood: Works everywhere in place of under a stroke. Default false.
    field: Field that is painted. Not direction, length or stretch, which have tools of their own. Default "density".
    value: Value that the field tends to: at most 1, for width and stiffness 4. For a colour how much of the coat's
        own it covers. 0 to 4 (varies). Default 1.
    colour: Colour to paint; for root_colour and tip_colour only. Default "#ffffff".
    op: Name of the command.
    """

    stroke: Stroke
    brush: Brush
    edit_layer: str
    flood: bool
    field: Field
    value: float
    colour: Colour


class _MapRequired(TypedDict):
    picture: PictureName
    op: Literal["map"]


class Map(_MapRequired, total=False):
    """Puts a field in place of what a picture says at the vertices' texture coordinates, on seams the mean of what
    their islands say; or of what a list says of each vertex. The mask holds, unless it is the mask that is read.
    The commands of a batch read at most 8 different pictures.

    picture: The name that the upload of a picture was answered with.
    field: Field that is replaced. Default "length".
    encoding: What the pixels hold. value: a number, or a colour and its cover. uv_tangent: direction along +u and +v
        in red and green, .5 is 0. fast_fur: the same, with width in blue and density in alpha. vector: direction and
        length as one vector of floats, along +u, +v and the normal. automatic: uv_tangent of direction, else value.
        Default "automatic".
    scale: What 1 in the picture stands for, in the field's unit; of fast_fur the width, of vector the length. 1e-27
        to 1e+27 (as `units`). Default 1.
    units: Unit of a scale of lengths. relative: sizes; world: the model's unit. Default "relative".
    strength: How far the field goes to the picture's. 0 to 1 (share). Default 1.
    tile: UDIM tile that the picture is of, from 1001: only vertices that lie in it change. 0: the picture repeats,
        and all do. 0 to 9999. Default 0.
    edit_layer: Edit layer that keeps what changes; the groom below all edit layers unless named. Default "".
    op: Name of the command.
    """

    field: Field
    encoding: MapEncoding
    scale: float
    units: Units
    strength: float
    tile: int
    edit_layer: str


class _MapRequestRequired(TypedDict):
    field: Field


class MapRequest(_MapRequestRequired, total=False):
    """How a field is drawn as a picture.

    field: Field that is drawn or read.
    encoding: What the pixels hold. value: a number, or a colour and its cover. uv_tangent: direction along +u and +v
        in red and green, .5 is 0. fast_fur: the same, with width in blue and density in alpha. vector: direction and
        length as one vector of floats, along +u, +v and the normal. automatic: uv_tangent of direction, else value.
        Default "automatic".
    scale: What 1 in the picture stands for, in the field's unit; of fast_fur the width, of vector the length. Unless
        given the field's largest value for PNG, else 1. 1e-27 to 1e+27 (as `units`).
    units: Unit of a scale of lengths. Default "relative".
    format: Format of the file: 8 or 16 bits, an EXR of floats or halfs, or a NumPy array of floats: [size, size] or
        [size, size, channels], rows from the top; of `vertices` [vertices] or [vertices, channels], without size and
        dilate. Default "png16".
    size: Width and height. Above 4096 one map is made at a time. 1 to 8192 (pixels). Default 1024.
    dilate: How far islands grow over their seams. 0 to 64 (pixels). Default 8.
    tile: UDIM tile to draw, from 1001; 0: all of them over one another. 0 to 9999. Default 0.
    """

    encoding: MapEncoding
    scale: float
    units: Units
    format: Literal["png", "png16", "exr", "exr_half", "npy"]
    size: int
    dilate: int
    tile: int


class _MaskRequired(TypedDict):
    op: Literal["mask"]


class Mask(_MaskRequired, total=False):
    """Chooses where tools work: they change what the mask is 1 on, and nothing where it is 0. Brushes paint it
    with `paint`. Only select takes a shape, combine and value; only grow and shrink a distance; only smooth
    passes.

    action: What is done with the mask: select chooses, grow and shrink move its edge, smooth softens it, invert swaps
        it. Default "select".
    all: Everything. What select takes when no shape is given.
    vertices: Numbers of the vertices that are chosen. 1 to 100000 items.
    box: Chooses what lies in a box.
    sphere: Chooses what lies in a sphere.
    part: The connected part of the model that is nearest.
    picture: An uploaded picture, read at the vertices' texture coordinates. luminance: by Rec. 709's weights of the
        file's own numbers, no curve undone.
    combine: How the shape joins the mask that is there. With replace the rest gets 1 - value. Default "replace".
    value: Mask value of what is chosen. 0 to 1 (share). Default 1.
    distance: How far the edge moves along edges of the mesh, in `units`; at most 1000000 sizes. 0 to 1e+27 (as
        `units`). Default 0.02.
    passes: How often the mask is smoothed. 1 to 10000. Default 3.
    units: What lengths are in. relative: sizes, fractions of the diagonal of the model's box. world: the model's
        unit. Default "relative".
    op: Name of the command.
    """

    action: Literal["select", "grow", "shrink", "smooth", "invert"]
    all: MaskAll
    vertices: Sequence[int]
    box: MaskBox
    sphere: MaskSphere
    part: MaskPart
    picture: MaskPicture
    combine: Literal["replace", "add", "subtract", "intersect"]
    value: float
    distance: float
    passes: int
    units: Units


class _ChangeEditLayerRequired(TypedDict):
    name: str
    op: Literal["edit_layer"]


class ChangeEditLayer(_ChangeEditLayerRequired, total=False):
    """Makes, sets, moves, merges or removes an edit layer. What is seen is the groom below and, from the lowest
    layer up, weight times what each adds, held in each field's range. At most 14. Neither of what is merged may be
    muted; the layer that is merged into comes to weight 1.

    action: What is done with the edit layer. Default "add".
    name: Name of the edit layer.
    weight: How much the edit layer counts, for add and set; add takes 1 unless given. Below 0 it does the opposite of
        what was groomed. Tools change edit layers of at least .05 or at most -.05. -4 to 4 (factor).
    muted: Whether the edit layer is left out, for add and set.
    rename: The new name, for set. Default "".
    above: Edit layer that it comes to lie on, or "" for none. For add, where it lies on top unless given, and move,
        where it is required.
    op: Name of the command.
    """

    action: Literal["add", "set", "move", "merge_down", "remove"]
    weight: float
    muted: bool
    rename: str
    above: str


class Environment(TypedDict, total=False):
    """Light from all around: a gradient, or spherical harmonics. It scales the look's `ambient`; white everywhere
    is constant light.

    sky: Light from straight above. Default "#ffffff".
    horizon: Light from the horizon. Default "#ffffff".
    ground: Light from straight below. Default "#ffffff".
    harmonics: Nine spherical harmonics of red, green and blue, in place of the three colours. 9 items.
    turn_degrees: How far the harmonics are turned about +y, counter-clockwise seen from above. -360 to 360 (degrees).
        Default 0.
    intensity: Factor on its light. 0 to 100 (factor). Default 1.
    """

    sky: Colour
    horizon: Colour
    ground: Colour
    harmonics: Sequence[Sequence[float]]
    turn_degrees: float
    intensity: float


class _EyeRequired(TypedDict):
    position: Position
    radius: float


class Eye(_EyeRequired, total=False):
    """A ball with a bulging cornea. Lengths of its parts are in its radii. It takes a gaze or a point to look at.

    position: Centre of the ball. 3 items (model units).
    radius: Radius of the ball. 1e-06 to 1000000 (sizes).
    gaze: Direction in which the eye looks. 3 items (any length). Default [0, 0, 1].
    look_at: The point that it looks at; not its own position. 3 items (model units).
    iris: The eye's iris.
    pupil: The eye's pupil.
    lids: Skin around the eye. Without this block the eye has no lids.
    sclera: Colour of the white of the eye. Default [0.62, 0.54, 0.47].
    bulge: How far the cornea bulges: 0 not at all, 1 half a ball. 0 to 1 (share). Default 0.5.
    refraction: Refractive index of the cornea. 1 to 3 (refractive index). Default 1.376.
    wetness: How sharp the tear film reflects: 0 a broad sheen, 1 a mirror. 0 to 1 (share). Default 0.9.
    """

    gaze: Direction
    look_at: Position
    iris: Iris
    pupil: Pupil
    lids: Lids
    sclera: Colour
    bulge: float
    refraction: float
    wetness: float


class _PickFarthestRequired(TypedDict):
    direction: Direction


class PickFarthest(_PickFarthestRequired, total=False):
    """The place of the surface that lies farthest along a direction, of what lies in a box: the tip of an ear.

    direction: Direction along which the place lies farthest. 3 items (any length).
    min: Lowest corner of the box; the whole model unless given. 3 items (model units).
    max: Highest corner of the box. With `min`, and nowhere below it. 3 items (model units).
    """

    min: Position
    max: Position


class Knobs(TypedDict, total=False):
    """What a frame is drawn with. What is not given is as in the interactive tier.

    method: How fur is drawn. raster: the strands of the coat, or an even share of them, rasterized. strands: every
        strand of the coat, ray traced. shells: skin and fur alone in layers, by a GL; refused with 422 where the
        server has none. It draws no eyes, curves, ground, overlays, and of AOVs beauty and alpha. Default "raster".
    scale: Rendered size over asked size. Times width and height at most 8192; the tier detailed has 2. 0.25 to 2
        (factor). Default 1.
    eye_steps: Steps into the iris of each eye: 0 a flat disc, 1 refracted and seen at its depth, more: steps of ray
        marching through the iris. 0 to 64. Default 8.
    raster: The choice of strands that are rasterized; with method raster only.
    trace: How strands are traced; with method strands only.
    shells: How fur is drawn in layers; with method shells only.
    """

    method: Literal["raster", "strands", "shells"]
    scale: float
    eye_steps: int
    raster: Rasterizing
    trace: Tracing
    shells: Layering


class Tracing(TypedDict, total=False):
    """How strands are traced. The same picture comes from the same seed and the same count of passes. It ends at
    the first of `passes`, `noise` and `seconds`. Refused with 413 where the strands and the picture need more
    memory than the server gives them.

    passes: Largest count of passes. A pass adds a sample to each pixel that still needs some. 1 to 65536. Default 64.
    transport: How light goes through fur. transmittance: through the strands that it crosses, by their colour and
        count. paths: from strand to strand. Default "transmittance".
    scattering: What a strand scatters by: the look's shading, or energy_conserving whatever the look says. Paths
        scatter by energy_conserving and refuse `look`. Default "look".
    bounces: Largest count of bounces of a path; with `paths` only. 1 to 4096. Default 32.
    strands: Largest count of strands; fewer are drawn wider, so that they cover as much. 1 to 8000000. Default
        2000000.
    noise: Ends when the estimated mean error of a shown channel is below this, and leaves parts that are; 0 never. 0
        to 1 (share). Default 0.
    seconds: Ends after as many seconds; 0 never. 0 to 3600 (seconds). Default 0.
    shutter: How long the shutter is open, half before the frame's time and half after: fur that the wind moves is
        blurred. Strands go straight from where they are first to where they are last; 0 for none. 0 to 10 (seconds).
        Default 0.
    filter: Whether direction, depth and colour guide a filter over pictures of few passes. Default true.
    seed: Other seeds give other noise. 0 to 4294967295. Default 1.
    """

    passes: int
    transport: Literal["transmittance", "paths"]
    scattering: Literal["look", "energy_conserving"]
    bounces: int
    strands: int
    noise: float
    seconds: float
    shutter: float
    filter: bool
    seed: int


class FrameRequest(TypedDict, total=False):
    """A picture to draw. What is not given takes its default.

    width: Width of the picture. 1 to 8192 (pixels). Default 512.
    height: Height of the picture. 1 to 8192 (pixels). Default 512.
    crop: Part of the frame that is drawn alone. The picture has the part's size, and the pixels that the whole frame
        has there; an EXR's display window is the whole frame. `budget_ms` is of the whole frame.
    camera: Where the scene is seen from. Default {"auto": "three_quarter"}.
    quality: A tier, or single knobs. Default "interactive".
    budget_ms: Drawing time, in place of `quality`: takes the knobs whose drawing time keeps to the budget and whose
        error, as 95% of frames keep it, is estimated least; 95% of frames take at most 1.25 times it. Drawing time is
        the milliseconds that pass on this machine while the frame is drawn; waiting for other frames, reading and
        encoding are not in it, nor is growing strands after their coat or their model has changed. AOVs of an EXR
        beside beauty, and overlays, come on top. 1 to 600000 (milliseconds).
    max_error: Error, in place of `quality`: takes the cheapest knobs with at most this error in 95% of frames: mean
        FLIP where there is fur, against the same strands, traced. 1e-06 to 1 (mean FLIP).
    max_seconds: Refuses the frame where drawing is expected to take longer; a dry run says how long. 1 to 86400
        (seconds). Default 60.
    time: Time that the frame shows: the fur as the scene's wind has moved it by then. The scene's own time unless
        given. The same time gives the same picture, whatever was drawn before. -1000000 to 1000000 (seconds).
    background: What is behind the fur. `studio` is a soft gradient with darker corners. Default [0.56, 0.58, 0.61].
    exposure: How much brighter the picture is made. -20 to 20 (stops). Default 0.
    tone_map: How bright light is brought into the picture's range. Default "filmic".
    look: Look for this frame, in place of the scene's.
    view: Name of the viewer: of several frames asked for one view only the newest is drawn, the others get 409. At
        most 200 bytes. Default "".
    format: Format of the picture. png and png16: 8 and 16 bit sRGB. jpeg: without alpha. webp: lossy as jpeg, half as
        large, ten times slower to make, with alpha. exr: linear light without exposure, tone map and background,
        multiplied by alpha. npy: the pixels of png as a NumPy array of bytes [height, width, 4]. npy_linear: what an
        exr of floats holds as a NumPy array of floats [height, width, channels]. Default "png".
    lossy_quality: How much jpeg and webp keep of the picture, from 1 on; of these formats only. 0: as the frame's
        quality asks, 80 of a draft, 88 of an interactive frame, 94 beyond. 0 to 100. Default 0.
    exr_type: Type of the channels of an EXR. Depth, position, strand and root are always float. Default "half".
    aovs: AOVs (arbitrary output variables) that the file holds, for exr and npy_linear; `[beauty]` when absent. Drawn
        pixels times AOVs are at most 67108864. Channels: R, G, B, A of beauty; A of alpha; Z of depth; AOV.X, .Y, .Z
        of position, normal, tangent and root; AOV.R, .G, .B of albedo and direct; AOV.Y of shadow and sample_count;
        strand.id, .along and .coat. 1 to 12 items.
    overlay: Shows a field on the fur. Not in linear light. density, wetness and mask go from dark violet for 0 to
        yellow for 1. difference: how much the fields have changed since `overlay_from`, with the same colours: of the
        field that changed most, the change over what counts as much (direction and colours: 1; length: the longest
        fur; others: the field's range). Grey where nothing changed. bald and wire hide the frame: the skin in plain
        grey without its fur, to find places on it, and the same with the edges of its triangles. Default "none".
    progressive: Draws rasterized strands at once; all strands of the same revision are then traced while somebody
        waits for them with `after` and `after_pass`. true takes the defaults of Tracing. Pictures may skip passes;
        answers are to this same request, sent again. Name the `view`: what is traced is dropped as soon as the scene
        changes, the same view asks for something else, or nobody has asked for 30 seconds. Refused with 503 while 16
        pictures wait to be traced.
    overlay_from: Revision that the overlay `difference` compares what is drawn with: one of this model. Only with it.
        0 to 18446744073709551615.
    revision: Revision to draw the scene as: its model, fields and settings as they were; the present one when it is
        not given. Neither with `progressive` nor with `after`. 0 to 18446744073709551615.
    """

    width: int
    height: int
    crop: Crop
    camera: Camera
    quality: Union[Tier, Knobs]
    budget_ms: float
    max_error: float
    max_seconds: float
    time: float
    background: Union[Literal["transparent", "studio"], Colour]
    exposure: float
    tone_map: Literal["none", "filmic"]
    look: Look
    view: str
    format: Literal["png", "png16", "jpeg", "webp", "exr", "npy", "npy_linear"]
    lossy_quality: int
    exr_type: Literal["half", "float"]
    aovs: Sequence[Aov]
    overlay: Literal[
        "none", "direction", "strokes", "length", "density", "wetness", "mask", "difference", "bald", "wire"
    ]
    progressive: Union[bool, Tracing]
    overlay_from: int
    revision: int


class _MapUploadRequired(TypedDict):
    field: Field


class MapUpload(_MapUploadRequired, total=False):
    """How a picture is read as a field.

    field: Field that is drawn or read.
    encoding: What the pixels hold. value: a number, or a colour and its cover. uv_tangent: direction along +u and +v
        in red and green, .5 is 0. fast_fur: the same, with width in blue and density in alpha. vector: direction and
        length as one vector of floats, along +u, +v and the normal. automatic: uv_tangent of direction, else value.
        Default "automatic".
    scale: What 1 in the picture stands for. With neither it nor `units`: what the file says of itself, else 1. 1e-27
        to 1e+27 (as `units`).
    units: Unit of a scale of lengths. Default "relative".
    strength: How far the field goes to the picture's. 0 to 1 (share). Default 1.
    tile: UDIM tile that the picture is of, from 1001: only vertices that lie in it change. 0: the picture repeats,
        and all do. 0 to 9999. Default 0.
    """

    encoding: MapEncoding
    scale: float
    units: Units
    strength: float
    tile: int


class MapAbout(TypedDict):
    """How to read a map.

    revision: Revision that was drawn. At least 0.
    field: Field that was drawn.
    encoding: What the pixels hold. value: a number, or a colour and its cover. uv_tangent: direction along +u and +v
        in red and green, .5 is 0. fast_fur: the same, with width in blue and density in alpha. vector: direction and
        length as one vector of floats, along +u, +v and the normal. automatic: uv_tangent of direction, else value.
    scale: What 1 in the picture stands for.
    units: What lengths are in. relative: sizes, fractions of the diagonal of the model's box. world: the model's
        unit.
    covered: Share of the pixels that lie in triangles. 0 to 1 (share).
    outside: Triangles with a part outside [0, 1], drawn where a picture that repeats shows them. At least 0.
    tiles: UDIM tiles that the model has texture coordinates in.
    """

    revision: int
    field: Field
    encoding: MapEncoding
    scale: float
    units: Units
    covered: float
    outside: int
    tiles: Sequence[int]


class _StoredPictureRequired(TypedDict):
    picture: PictureName
    width: int
    height: int
    bits: int


class StoredPicture(_StoredPictureRequired, total=False):
    """A picture that the server keeps.

    picture: Name of the picture, for commands.
    width: Width of the picture. 1 to 4096.
    height: Height of the picture. 1 to 4096.
    bits: Bits of a channel: 8, 16, or 32 for any float. 8 to 32.
    scale: What 1 in it stands for, where the file says so.
    """

    scale: float


class BuiltinModel(TypedDict, total=False):
    """A model that the server makes.

    builtin: Name of the model. Default "creature".
    triangles: About how many triangles it has. 2 to 1000000. Default 5000.
    """

    builtin: Literal["torus", "knot", "sphere", "plane", "cloth", "creature"]
    triangles: int


class FirstGroom(TypedDict, total=False):
    """The first fur, which flows from under the chin to the ends of limbs, ears and tail; on sheets from front to
    back.

    length: Length of the first fur. 0 to 10 (sizes). Default 0.03.
    inclination: How far fur leans: 0 upright, 1 lying. Where fur begins, ends and parts it stands up. 0 to 1 (share).
        Default 0.45.
    form: How lengths differ over the body. animal: shorter on face and paws, longer on chest and tail, estimated from
        where they lie in the model's box. Default "even".
    """

    length: float
    inclination: float
    form: Literal["even", "animal"]


class NewScene(TypedDict, total=False):
    """A scene to make. What is not given takes its default.

    name: Name of the scene: at most 200 bytes of UTF-8, no control characters. Default "scene".
    model: Built-in model that the scene begins with.
    fur: The first fur.
    fur_patches: How the sample tile of fur is laid on the surface, once: patches with soft overlaps; the same with
        hard borders, where nothing is drawn twice; or by the model's own texture coordinates, which of the built-in
        models torus, knot, plane and cloth have. Default "overlapping".
    """

    name: str
    model: BuiltinModel
    fur: FirstGroom
    fur_patches: FurPatches


class AutoCamera(TypedDict):
    """The contract's AutoCamera.

    auto: A camera that the server places. `front` looks from +Z, `left` from +X: it shows the animal's left. Each
        frames the bare model, never the fur.
    """

    auto: AutoView


class _PinholeCameraRequired(TypedDict):
    position: Position
    target: Position


class PinholeCamera(_PinholeCameraRequired, total=False):
    """The contract's PinholeCamera.

    position: Where the camera stands. 3 items (model units).
    target: Point that the camera looks at. 3 items (model units).
    up: Direction that is up in the picture. 3 items (any length). Default [0, 1, 0].
    fov_degrees: Vertical field of view. 1 to 150 (degrees). Default 35.
    """

    up: Direction
    fov_degrees: float


class View(TypedDict, total=False):
    """The frame that a pixel belongs to.

    camera: A view that the server frames, or a pinhole camera, whose position differs from its target and whose up is
        not along the view. Default {"auto": "three_quarter"}.
    width: Width of the picture. 1 to 8192 (pixels). Default 512.
    height: Height of the picture. 1 to 8192 (pixels). Default 512.
    """

    camera: Camera
    width: int
    height: int


class Brush(TypedDict, total=False):
    """How far and how strongly a tool reaches round a stroke.

    radius: Radius of a dab, in `units`; at most 1000000 sizes. 0 to 1e+27 (as `units`). Default 0.05.
    units: Unit of the radius. relative: sizes. world: the model's unit. pixels: pixels of the stroke's view, at the
        depth of each dab. Default "relative".
    falloff_shape: How the distance of a vertex from a dab is measured: through space, along the surface (it does not
        reach another part of the model that is only near in space), or in the picture of the stroke's view. Default
        "volume".
    reach: What the brush reaches: fur that itself comes within its radius, or skin within it, with the fur that
        stands there. fur goes with falloff_shape volume. Absent it is fur for samples in pixels, which then are
        places on the fur that is seen there, and skin for others.
    falloff: How the effect fades from the middle of a dab to its rim. Default "smooth".
    falloff_points: Weights from the middle to the rim, straight between them, in place of the named curve. 2 to 64
        items (share).
    strength: How much a dab changes: 0 nothing, 1 all. 0 to 1 (share). Default 0.8.
    spacing: Distance from dab to dab. A stroke takes at most 100000 dabs. 0.01 to 10 (radii). Default 0.25.
    pressure_to_radius: Share of the radius that a sample's pressure scales. 0 to 1 (share). Default 0.
    pressure_to_strength: Share of the strength that a sample's pressure scales. 0 to 1 (share). Default 1.
    front_faces_only: Leaves out faces that are back-facing for the camera of the stroke's view; without a view, those
        that face away from the surface's normal at the dab. Default true.
    cut_off_degrees: Angle to the front from which faces count as back-facing. 0 to 180 (degrees). Default 90.
    invert: Does the tool's opposite; refused where it has none. Default false.
    strand_from: Where the part of the strand that changes begins: 0 is the root, 1 the tip. It works on colours only:
        root_colour stands for the lower half, tip_colour for the upper. 0 to 1 (share). Default 0.
    strand_to: Where the part of the strand that changes ends; above strand_from. 0 to 1 (share). Default 1.
    """

    radius: float
    units: Literal["relative", "world", "pixels"]
    falloff_shape: Literal["volume", "surface", "screen"]
    reach: Literal["skin", "fur"]
    falloff: Literal["constant", "linear", "smooth", "sharp", "sphere"]
    falloff_points: Sequence[float]
    strength: float
    spacing: float
    pressure_to_radius: float
    pressure_to_strength: float
    front_faces_only: bool
    cut_off_degrees: float
    invert: bool
    strand_from: float
    strand_to: float


class _InterpolateRequired(TypedDict):
    keys: Sequence[Key]
    op: Literal["interpolate"]


class Interpolate(_InterpolateRequired, total=False):
    """Spreads keys over the surface with Gaussian weights of the distance. What no key reaches keeps its value.

    stroke: Where a brush goes, as samples in order. It can be sent in parts.
    brush: How far and how strongly a tool reaches round a stroke.
    edit_layer: Edit layer that keeps what changes; the groom below all edit layers unless named. Default "".
    keys: What fur is like at a few places. 1 to 1024 items.
    sigma: Width of the Gaussians, in `units`; at least 0.000001 and at most 1000000 sizes. 1e-27 to 1e+27 (as
        `units`). Default 0.2.
    units: What lengths are in. relative: sizes, fractions of the diagonal of the model's box. world: the model's
        unit. Default "relative".
    distance: How distances are measured. straight: through space. dijkstra: along edges, too long by some percent.
        heat: along the surface by the heat method, slower. Default "dijkstra".
    strength: How much it changes: 0 does nothing, 1 all. 0 to 1 (share). Default 1.
    op: Name of the command.
    """

    stroke: Stroke
    brush: Brush
    edit_layer: str
    sigma: float
    units: Units
    distance: Literal["straight", "dijkstra", "heat"]
    strength: float


class _FlowRequired(TypedDict):
    curves: Sequence[Sequence[Position]]
    op: Literal["flow"]


class Flow(_FlowRequired, total=False):
    """Lays the fur of the whole body along curves drawn on it, from the first point of each to the last.

    stroke: Where a brush goes, as samples in order. It can be sent in parts.
    brush: How far and how strongly a tool reaches round a stroke.
    edit_layer: Edit layer that keeps what changes; the groom below all edit layers unless named. Default "".
    curves: Curves on the model, each a list of points that fur follows from the first to the last. 1 to 64 items.
    sigma: Width of the Gaussians, in `units`; at least 0.000001 and at most 1000000 sizes. 1e-27 to 1e+27 (as
        `units`). Default 0.2.
    units: What lengths are in. relative: sizes, fractions of the diagonal of the model's box. world: the model's
        unit. Default "relative".
    distance: How distances are measured. straight: through space. dijkstra: along edges, too long by some percent.
        heat: along the surface by the heat method, slower. Default "dijkstra".
    inclination: How far fur leans: 0 upright, 1 lying. The fur keeps its own unless given. 0 to 1 (share).
    strength: How much it changes: 0 does nothing, 1 all. 0 to 1 (share). Default 1.
    op: Name of the command.
    """

    stroke: Stroke
    brush: Brush
    edit_layer: str
    sigma: float
    units: Units
    distance: Literal["straight", "dijkstra", "heat"]
    inclination: float
    strength: float


class _SmoothRequired(TypedDict):
    op: Literal["smooth"]


class Smooth(_SmoothRequired, total=False):
    """Blends each value with the mean of its neighbours, nearer ones counting more.

    stroke: Where a brush goes, as samples in order. It can be sent in parts.
    brush: How far and how strongly a tool reaches round a stroke.
    edit_layer: Edit layer that keeps what changes; the groom below all edit layers unless named. Default "".
    flood: Works everywhere in place of under a stroke. Default false.
    t: Share of the mean in each pass; up to 0.5 nothing oscillates. 0 to 1 (share). Default 0.5.
    passes: How often the values are blended. 1 to 10000. Default 3.
    keep_inclination: Smooths headings alone, so that no tuft rises where opposite directions meet. Default false.
    fields: Fields that are smoothed. 1 to 13 items. Default ["direction"].
    op: Name of the command.
    """

    stroke: Stroke
    brush: Brush
    edit_layer: str
    flood: bool
    t: float
    passes: int
    keep_inclination: bool
    fields: Sequence[Field]


class _NoiseRequired(TypedDict):
    op: Literal["noise"]


class Noise(_NoiseRequired, total=False):
    """Adds random numbers that are a pure function of the seed and the place; inverted it takes them off.

    stroke: Where a brush goes, as samples in order. It can be sent in parts.
    brush: How far and how strongly a tool reaches round a stroke.
    edit_layer: Edit layer that keeps what changes; the groom below all edit layers unless named. Default "".
    flood: Works everywhere in place of under a stroke. Default false.
    seed: Other seeds give other noise. 0 to 4294967295. Default 1.
    amount: How large the numbers are: for directions in inclinations; for length, stretch and width as a share of the
        value; for other fields in their own unit. 0 to 10 (varies). Default 0.2.
    feature_size: Size of the noise's features, in `units`. At 0 every vertex moves for itself. 0 to 1e+27 (as
        `units`). Default 0.
    units: What lengths are in. relative: sizes, fractions of the diagonal of the model's box. world: the model's
        unit. Default "relative".
    fields: Fields that noise is added to. 1 to 13 items. Default ["direction"].
    op: Name of the command.
    """

    stroke: Stroke
    brush: Brush
    edit_layer: str
    flood: bool
    seed: int
    amount: float
    feature_size: float
    units: Units
    fields: Sequence[Field]


class _UnifyRequired(TypedDict):
    op: Literal["unify"]


class Unify(_UnifyRequired, total=False):
    """Blends to a value, or to the mean under the brush.

    stroke: Where a brush goes, as samples in order. It can be sent in parts.
    brush: How far and how strongly a tool reaches round a stroke.
    edit_layer: Edit layer that keeps what changes; the groom below all edit layers unless named. Default "".
    flood: Works everywhere in place of under a stroke. Default false.
    direction: Where fur is turned to. 3 items (any length).
    inclination: How far fur leans: 0 upright, 1 lying. The fur keeps its own unless given. 0 to 1 (share).
    length: Length that fur tends to, in `units`; at most 10 sizes. The fur keeps its own unless given. 0 to 1e+27 (as
        `units`).
    units: What lengths are in. relative: sizes, fractions of the diagonal of the model's box. world: the model's
        unit. Default "relative".
    mean: Fields that go to their weighted mean under the brush. 0 to 13 items. Default [].
    weight: How far values go, on top of the brush's own strength. 0 to 1 (share). Default 0.5.
    op: Name of the command.
    """

    stroke: Stroke
    brush: Brush
    edit_layer: str
    flood: bool
    direction: Direction
    inclination: float
    length: float
    units: Units
    mean: Sequence[Field]
    weight: float


class _PartRequired(TypedDict):
    stroke: Stroke
    op: Literal["part"]


class Part(_PartRequired, total=False):
    """A line that fur leans away from on both sides; inverted fur leans to it.

    stroke: Where a brush goes, as samples in order. It can be sent in parts.
    brush: How far and how strongly a tool reaches round a stroke.
    edit_layer: Edit layer that keeps what changes; the groom below all edit layers unless named. Default "".
    lean: Inclination that the fur tends to: 0 upright, 1 lying. 0 to 1 (share). Default 0.7.
    op: Name of the command.
    """

    brush: Brush
    edit_layer: str
    lean: float


class _WhorlRequired(TypedDict):
    stroke: Stroke
    op: Literal["whorl"]


class Whorl(_WhorlRequired, total=False):
    """Turns fur round the nearest place of the stroke: a cowlick. Inverted it turns the other way.

    stroke: Where a brush goes, as samples in order. It can be sent in parts.
    brush: How far and how strongly a tool reaches round a stroke.
    edit_layer: Edit layer that keeps what changes; the groom below all edit layers unless named. Default "".
    turn_degrees: Way that fur turns, counter-clockwise seen from outside: at 0 it points out, at 90 it circles, at
        180 it points in. -180 to 180 (degrees). Default 70.
    lean: Inclination that the fur tends to: 0 upright, 1 lying. 0 to 1 (share). Default 0.8.
    op: Name of the command.
    """

    brush: Brush
    edit_layer: str
    turn_degrees: float
    lean: float


class _LengthRequired(TypedDict):
    op: Literal["length"]


class Length(_LengthRequired, total=False):
    """Changes how long fur is.

    stroke: Where a brush goes, as samples in order. It can be sent in parts.
    brush: How far and how strongly a tool reaches round a stroke.
    edit_layer: Edit layer that keeps what changes; the groom below all edit layers unless named. Default "".
    flood: Works everywhere in place of under a stroke. Default false.
    mode: How `value` changes the length. average: to the mean under the brush. jitter: by a random share. min, max:
        not under, not over. Default "set".
    value: A length in `units`, at most 10 sizes and below 0 for add only; a factor for scale, at most 1000000; a
        share for jitter, at most 1. -1e+27 to 1e+27 (varies). Default 0.03.
    units: What lengths are in. relative: sizes, fractions of the diagonal of the model's box. world: the model's
        unit. Default "relative".
    seed: Other seeds give other random shares; for jitter. 0 to 4294967295. Default 1.
    op: Name of the command.
    """

    stroke: Stroke
    brush: Brush
    edit_layer: str
    flood: bool
    mode: Literal["set", "add", "scale", "average", "jitter", "min", "max"]
    value: float
    units: Units
    seed: int


class _TrimPlaneRequired(TypedDict):
    point: Position


class TrimPlane(_TrimPlaneRequired, total=False):
    """A plane; fur ends where it crosses it.

    point: A point of the plane. 3 items (model units).
    normal: Direction to the side where no fur may be. 3 items (any length). Default [0, 1, 0].
    """

    normal: Direction


class _TrimSphereRequired(TypedDict):
    centre: Position


class TrimSphere(_TrimSphereRequired, total=False):
    """A sphere; fur ends where it crosses it.

    centre: Centre of the sphere. 3 items (model units).
    radius: Radius of the sphere, in `units`; at most 1000000 sizes. 0 to 1e+27 (as `units`). Default 0.
    keep_inside: Fur ends where it leaves the sphere; else where it enters it. Default true.
    """

    radius: float
    keep_inside: bool


class _LiftRequired(TypedDict):
    op: Literal["lift"]


class Lift(_LiftRequired, total=False):
    """Raises fur; inverted it lays it down. Fur that stands upright has no heading and stays.

    stroke: Where a brush goes, as samples in order. It can be sent in parts.
    brush: How far and how strongly a tool reaches round a stroke.
    edit_layer: Edit layer that keeps what changes; the groom below all edit layers unless named. Default "".
    flood: Works everywhere in place of under a stroke. Default false.
    op: Name of the command.
    """

    stroke: Stroke
    brush: Brush
    edit_layer: str
    flood: bool


class _ClumpRequired(TypedDict):
    stroke: Stroke
    op: Literal["clump"]


class Clump(_ClumpRequired, total=False):
    """Turns fur to the line of the stroke and gathers its tips; inverted it opens them.

    stroke: Where a brush goes, as samples in order. It can be sent in parts.
    brush: How far and how strongly a tool reaches round a stroke.
    edit_layer: Edit layer that keeps what changes; the groom below all edit layers unless named. Default "".
    gather: How far fur turns. 0 to 1 (share). Default 0.3.
    amount: Value that the field clump tends to. 0 to 1 (share). Default 0.6.
    op: Name of the command.
    """

    brush: Brush
    edit_layer: str
    gather: float
    amount: float


class _CurlRequired(TypedDict):
    op: Literal["curl"]


class Curl(_CurlRequired, total=False):
    """Curls fur and turns its heading; inverted it takes the curl out.

    stroke: Where a brush goes, as samples in order. It can be sent in parts.
    brush: How far and how strongly a tool reaches round a stroke.
    edit_layer: Edit layer that keeps what changes; the groom below all edit layers unless named. Default "".
    flood: Works everywhere in place of under a stroke. Default false.
    amount: Value that the field curl tends to. 0 to 1 (share). Default 0.6.
    turn_degrees: How far the heading turns, counter-clockwise seen from outside. -180 to 180 (degrees). Default 0.
    op: Name of the command.
    """

    stroke: Stroke
    brush: Brush
    edit_layer: str
    flood: bool
    amount: float
    turn_degrees: float


class MaskAll(TypedDict):
    """Everything; an empty object."""


class MaskBox(TypedDict):
    """A box along the model's axes.

    min: Corner with the smallest coordinates. 3 items (model units).
    max: Corner with the largest coordinates. 3 items (model units).
    """

    min: Position
    max: Position


class _MaskSphereRequired(TypedDict):
    centre: Position


class MaskSphere(_MaskSphereRequired, total=False):
    """A sphere whose edge may be soft.

    centre: Centre of the sphere. 3 items (model units).
    radius: Radius of the sphere, in `units`; at most 1000000 sizes. 0 to 1e+27 (as `units`). Default 0.1.
    softness: Share of the radius over which it fades. 0 to 1 (share). Default 0.
    """

    radius: float
    softness: float


class MaskPart(TypedDict):
    """The connected part of the model that is nearest.

    position: A point near the part. 3 items (model units).
    """

    position: Position


class _MaskPictureRequired(TypedDict):
    name: PictureName


class MaskPicture(_MaskPictureRequired, total=False):
    """An uploaded picture, read at the vertices' texture coordinates. luminance: by Rec. 709's weights of the
    file's own numbers, no curve undone.

    name: The name that the upload of a picture was answered with.
    channel: Channel of the picture that is read. Default "luminance".
    """

    channel: Literal["luminance", "red", "green", "blue", "alpha"]


class _RetargetRequired(TypedDict):
    scene: str
    op: Literal["retarget"]


class Retarget(_RetargetRequired, total=False):
    """Takes the fields of another scene, or of this one at another revision, from the nearest places of its
    surface. The mask holds.

    scene: Id of the source, on the same server.
    revision: Revision of the source's model; the present one unless given. 0 to 18446744073709551615.
    align: How the models are laid over each other. box: their boxes lie over each other, axis by axis, and lengths
        stay shares of the size. none: both have the same coordinates, and lengths stay what they are in the model's
        unit. Default "box".
    fields: Fields that are taken; all but the mask when empty. 0 to 13 items. Default [].
    strength: How much it changes: 0 does nothing, 1 all. 0 to 1 (share). Default 1.
    edit_layer: Edit layer that keeps what changes; the groom below all edit layers unless named. Default "".
    op: Name of the command.
    """

    revision: int
    align: Literal["box", "none"]
    fields: Sequence[Field]
    strength: float
    edit_layer: str


class _NamedBlowerRequired(TypedDict):
    name: str


class NamedBlower(_NamedBlowerRequired, total=False):
    """A wind that stays in the scene under a name.

    name: Name by which `blow` uses it.
    source: Where the wind comes from. 3 items (model units). Default [0, 0, 0].
    direction: Where the wind blows, the axis of its cone. 3 items (any length). Default [0, -1, 0].
    cone_degrees: Half angle of the cone. 0 to 180 (degrees). Default 40.
    softness: Share of the cone over which its edge fades. 0 to 1 (share). Default 0.25.
    fall: Distance at which the wind has half its strength, in `units`; 0: it does not fall. 0 to 1e+27 (as `units`).
        Default 0.
    units: What lengths are in. relative: sizes, fractions of the diagonal of the model's box. world: the model's
        unit. Default "relative".
    strength: How much it changes: 0 does nothing, 1 all. 0 to 1 (share). Default 0.5.
    lean: Inclination that the wind tends to: 0 upright, 1 lying. 0 to 1 (share). Default 0.7.
    """

    source: Position
    direction: Direction
    cone_degrees: float
    softness: float
    fall: float
    units: Units
    strength: float
    lean: float


class SetBlowers(TypedDict):
    """Places all winds that stay, for blow to use by their names, which differ.

    blowers: All winds that stay. 0 to 64 items.
    op: Name of the command.
    """

    blowers: Sequence[NamedBlower]
    op: Literal["set_blowers"]


class _NamedAttractorRequired(TypedDict):
    name: str


class NamedAttractor(_NamedAttractorRequired, total=False):
    """A stick that stays in the scene under a name.

    name: Name by which `attract` uses it.
    point: Where the stick is. 3 items (model units). Default [0, 0, 0].
    radius: Distance beyond which nothing is pulled, in `units`; at most 1000000 sizes. 0 to 1e+27 (as `units`).
        Default 0.2.
    units: What lengths are in. relative: sizes, fractions of the diagonal of the model's box. world: the model's
        unit. Default "relative".
    strength: How much it changes: 0 does nothing, 1 all. 0 to 1 (share). Default 0.5.
    duration: How long the stick pulls. 0 to 10000 (seconds). Default 1.
    threshold: Stretch that fur takes without growing. 0 to 1000 (share). Default 0.3.
    max_stretch: Largest length over the length before any stretch. 1 to 100 (factor). Default 3.
    """

    point: Position
    radius: float
    units: Units
    strength: float
    duration: float
    threshold: float
    max_stretch: float


class SetAttractors(TypedDict):
    """Places all sticks that stay, for attract to use by their names, which differ.

    attractors: All sticks that stay. 0 to 64 items.
    op: Name of the command.
    """

    attractors: Sequence[NamedAttractor]
    op: Literal["set_attractors"]


class Plane(TypedDict, total=False):
    """A plane that mirrors.

    point: A point of the plane. 3 items (model units). Default [0, 0, 0].
    normal: Direction that the plane faces. 3 items (any length). Default [1, 0, 0].
    """

    point: Position
    normal: Direction


class _SymmetryRequired(TypedDict):
    planes: Sequence[Plane]


class Symmetry(_SymmetryRequired, total=False):
    """Mirror planes, all their combinations, and a rotation about an axis by equal steps.

    planes: Planes that mirror. 0 to 3 items.
    axis_point: A point of the axis of rotation. 3 items (model units). Default [0, 0, 0].
    axis: Direction of the axis of rotation. 3 items (any length). Default [0, 1, 0].
    count: Number of equal steps in a whole turn; 1 is no rotation. 1 to 16. Default 1.
    """

    axis_point: Position
    axis: Direction
    count: int


class SetSymmetry(TypedDict):
    """From now on each tool with a place works on all its images too, as one undo step. Places on the surface are
    mirrored to the nearest ones, so a roughly symmetric model will do. Floods have no images.

    symmetry: The new symmetry; with `planes` empty and `count` 1 there is none.
    op: Name of the command.
    """

    symmetry: Symmetry
    op: Literal["set_symmetry"]


class _CheckpointRequired(TypedDict):
    name: str
    op: Literal["checkpoint"]


class Checkpoint(_CheckpointRequired, total=False):
    """Gives this revision a name, or an earlier one; a name that is known moves.

    name: Name of the checkpoint.
    revision: Revision that gets the name; the one that this command makes unless given. 0 to 18446744073709551615.
    op: Name of the command.
    """

    revision: int


class RampStop(TypedDict):
    """A colour at a height of the strand.

    at: Height on the strand: 0 root, 1 tip. It rises from stop to stop. 0 to 1 (share).
    colour: Colour of the strand there.
    """

    at: float
    colour: Colour


class Undercoat(TypedDict, total=False):
    """Short, fine strands under the others.

    share: Share of the strands that belong to it. 0 to 1 (share). Default 0.
    length: Length over the overcoat's. 0.02 to 1 (factor). Default 0.5.
    width: Width over the overcoat's. 0.05 to 4 (factor). Default 0.6.
    lightness: Factor on the ramp's colour. 0 to 4 (factor). Default 1.
    tint: How far `colour` replaces the ramp's. 0 to 1 (share). Default 0.
    colour: Colour that `tint` mixes in. Default [0.5, 0.5, 0.5].
    """

    share: float
    length: float
    width: float
    lightness: float
    tint: float
    colour: Colour


class Ticking(TypedDict, total=False):
    """Single hairs that have a colour of their own.

    share: Share of the strands that have it. 0 to 1 (share). Default 0.
    colour: Colour of these hairs. Default [0.85, 0.85, 0.85].
    """

    share: float
    colour: Colour


class Tufts(TypedDict, total=False):
    """Clumps larger than the tile, gathered about places on the body, so that the fur does not repeat and has form
    at a distance. Each finer scale is .45 of the one before.

    gather: How far tips go to the middle of their tuft. 0 to 1 (share). Default 0.
    size: Mean distance of the largest tufts. 0.01 to 1 (sizes). Default 0.05.
    scales: How many scales of tufts there are. 1 to 3. Default 2.
    seed: Other seeds give other tufts. 0 to 4294967295. Default 1.
    """

    gather: float
    size: float
    scales: int
    seed: int


class Pattern(TypedDict, total=False):
    """Markings by where a root is, with y up and the nose at +z; no UVs are needed.

    kind: Kind of the markings. Default "none".
    scale: Distance from one marking to the next. 0.005 to 2 (sizes). Default 0.07.
    coverage: Share of the surface that is marked. For countershading how far up it reaches. 0 to 1 (share). Default
        0.5.
    contrast: How far markings replace the coat's colour. 0 to 1 (share). Default 1.
    softness: Width of a marking's edge over the marking's. 0 to 1 (share). Default 0.15.
    warp: How far noise bends the markings, in distances from one to the next. 0 to 2 (markings). Default 0.5.
    legs: How far stripes turn to rings on legs and haunches, and rosettes fill there. 0 to 1 (share). Default 1.
    inner: How far inner_colour is seen: in rosettes, as second patches, between stripes. 0 to 1 (share). Default 0.
    belly: How far the underside takes belly_colour and loses its markings. 0 to 1 (share). Default 0.
    axis: Direction in which stripes follow each other. 3 items (any length). Default [0, 0, 1].
    colour: Colour of the markings. Default [0.012, 0.01, 0.009].
    inner_colour: Colour inside rosettes, of second patches and between stripes. Default [0.22, 0.1, 0.035].
    belly_colour: Colour of the belly. Default [0.75, 0.7, 0.62].
    seed: Other seeds give other markings. 0 to 4294967295. Default 1.
    """

    kind: Literal["none", "stripes", "spots", "rosettes", "tabby", "patches", "countershading"]
    scale: float
    coverage: float
    contrast: float
    softness: float
    warp: float
    legs: float
    inner: float
    belly: float
    axis: Direction
    colour: Colour
    inner_colour: Colour
    belly_colour: Colour
    seed: int


class Variation(TypedDict, total=False):
    """How much colour and form change slowly over the body.

    lightness: How much lightness changes; at 1 from half to twice. 0 to 1 (share). Default 0.
    hue: How much hue changes; at 1 from a third towards blue to a third towards red. 0 to 1 (share). Default 0.
    length: How much length changes; at 1 from none to twice. 0 to 1 (share). Default 0.
    lean: How much the inclination changes; at 1 over its whole range. 0 to 1 (share). Default 0.
    size: Distance from one swell to the next. 0.005 to 2 (sizes). Default 0.12.
    """

    lightness: float
    hue: float
    length: float
    lean: float
    size: float


class Coat(TypedDict, total=False):
    """How the strands of the sample tile are made. What is not given takes its default.

    count: Strands in the tile. 1 to 100000. Default 9000.
    tile: Side of the tile. 0.01 to 1 (sizes). Default 0.12.
    width_root: Width of a strand at its root. 0 to 0.05 (sizes). Default 0.0011.
    width_tip: Width of a strand at its tip. 0 to 0.05 (sizes). Default 0.00028.
    bend: How far a strand bows to a side. 0 to 2 (strand lengths). Default 0.25.
    curl: Radius of the strand's helix. 0 to 0.5 (strand lengths). Default 0.
    curl_turns: Turns of the helix from root to tip. 0 to 20 (turns). Default 3.
    curl_together: How far the strands of a clump curl as one lock. 0 to 1 (share). Default 0.
    wave: Amplitude of a sine in one plane. 0 to 0.5 (strand lengths). Default 0.
    wave_turns: Waves from root to tip. 0 to 20 (waves). Default 3.
    mess: How far each strand goes and bows its own way. 0 to 1 (share). Default 0.
    clump: How far tips gather to the middle of their clump. 0 to 1 (share). Default 0.4.
    clump_size: Mean distance of clumps. 0.001 to 0.5 (sizes). Default 0.01.
    fine_clump: How far strands gather to locks inside their clump. 0 to 1 (share). Default 0.
    fine_clump_size: Mean distance of the locks inside a clump. 0.001 to 0.5 (sizes). Default 0.004.
    lodge: How far patches of strands are pressed to one side. 0 to 1 (share). Default 0.
    lodge_size: Mean distance of the pressed patches. 0.001 to 0.5 (sizes). Default 0.04.
    wetness: How wet the coat is: tighter clumps, darker (absorption up to 1.8 times) and shinier fur (highlight up to
        twice as strong). 0 to 1 (share). Default 0.
    length_spread: Share of the length that is random. 0 to 1 (share). Default 0.3.
    warmth_spread: Change of hue from strand to strand, to red and to blue, at the same lightness: 1 is up to twice
        the one over the other. 0 to 1 (share). Default 0.
    colour_spread: Change of lightness from strand to strand. 0 to 1 (share). Default 0.12.
    root_share: Angle at the root over angle at the tip: 0 plush, .6 sleek. 0 to 1 (share). Default 0.3.
    lean_curve: How a strand bends as it leans: in an arc, or most at the root, as y = K sqrt(x). Default "arc".
    ramp: Colour along the strand. 1 to 4 items.
    undercoat: Short, fine strands under the others.
    guard_hairs: Single hairs over the whole model that stand out of the fur, up to 1.25 times as long. 0 to 100000.
        Default 0.
    ticking: Single hairs that have a colour of their own.
    tufts: Clumps larger than the tile, gathered about places on the body, so that the fur does not repeat and has
        form at a distance. Each finer scale is .45 of the one before.
    pattern: Markings by where a root is, with y up and the nose at +z; no UVs are needed.
    variation: How much colour and form change slowly over the body.
    seed: Other seeds give other strands. 0 to 4294967295. Default 1.
    """

    count: int
    tile: float
    width_root: float
    width_tip: float
    bend: float
    curl: float
    curl_turns: float
    curl_together: float
    wave: float
    wave_turns: float
    mess: float
    clump: float
    clump_size: float
    fine_clump: float
    fine_clump_size: float
    lodge: float
    lodge_size: float
    wetness: float
    length_spread: float
    warmth_spread: float
    colour_spread: float
    root_share: float
    lean_curve: Literal["arc", "root"]
    ramp: Sequence[RampStop]
    undercoat: Undercoat
    guard_hairs: int
    ticking: Ticking
    tufts: Tufts
    pattern: Pattern
    variation: Variation
    seed: int


class SetCoat(TypedDict):
    """Sets how the strands of the fur are made: their form, colours and markings.

    coat: The new coat.
    op: Name of the command.
    """

    coat: Coat
    op: Literal["set_coat"]


class Fibre(TypedDict, total=False):
    """How fibres scatter light in the shading models energy_conserving, marschner and scheuermann.

    longitudinal_roughness: Roughness along the strand, beta_m. Used by energy_conserving. 0 to 1 (share). Default
        0.3.
    azimuthal_roughness: Roughness around the strand, beta_n. Used by energy_conserving. 0 to 1 (share). Default 0.3.
    cuticle_tilt: Tilt of the cuticle, which turns reflected light to the root. -15 to 15 (degrees). Default 2.
    refractive_index: Refractive index of the strand. Used by energy_conserving and marschner. 1 to 3 (refractive
        index). Default 1.55.
    absorption: What the absorption is worked out from. Default "colour".
    eumelanin: Concentration of eumelanin, which makes brown and black. Used with absorption melanin. 0 to 10000
        (concentration). Default 0.3.
    pheomelanin: Concentration of pheomelanin, which makes red. Used with absorption melanin. 0 to 10000
        (concentration). Default 0.
    highlight_width: Width of the highlight. Used by marschner. 0 to 90 (degrees). Default 7.5.
    caustic_width: Spread of transmitted light around the strand. Used by marschner. 1 to 60 (degrees). Default 10.
    primary_shift: Shift of the white highlight; above 0 it is nearer the tip. Used by scheuermann. -2 to 2
        (tangents). Default 0.1.
    secondary_shift: Shift of the coloured highlight. Used by scheuermann. -2 to 2 (tangents). Default -0.15.
    shift_spread: How much the shifts differ from strand to strand. Used by scheuermann. 0 to 2 (tangents). Default
        0.1.
    secondary_specular: Strength of the coloured highlight. Used by scheuermann. 0 to 4 (factor). Default 0.3.
    secondary_exponent: Sharpness of the coloured highlight. Used by scheuermann. 0 to 1000000 (exponent). Default 12.
    """

    longitudinal_roughness: float
    azimuthal_roughness: float
    cuticle_tilt: float
    refractive_index: float
    absorption: Literal["colour", "melanin"]
    eumelanin: float
    pheomelanin: float
    highlight_width: float
    caustic_width: float
    primary_shift: float
    secondary_shift: float
    shift_spread: float
    secondary_specular: float
    secondary_exponent: float


class Look(TypedDict, total=False):
    """How fur is shaded. What is not given takes its default.

    shading: How fibres scatter light. Default "energy_conserving".
    fibre: How fibres scatter light in the shading models energy_conserving, marschner and scheuermann.
    colour_source: Where the colour of fur comes from. model: its texture or vertex colours. coat: the ramp.
        automatic: the model's where it has colours. Default "automatic".
    ambient: Strength of the light from all around. 0 to 4 (factor). Default 0.38.
    diffuse: Strength of diffuse light. 0 to 4 (factor). Default 0.8.
    specular: Strength of the highlight. 0 to 4 (factor). Default 0.25.
    diffuse_exponent: How fast diffuse light falls as the light turns to the strand's own line. 0 to 1000000
        (exponent). Default 1.2.
    specular_exponent: Sharpness of the highlight. 0 to 1000000 (exponent). Default 40.
    back_attenuation: How far behind the skin a light may stand before its light is gone, as the sine of the angle.
        Used by lengyel, kajiya and kajiya_kay. 0.001 to 1 (share). Default 0.5.
    ambient_floor: Share of the ambient light that reaches the roots. 0 to 1 (share). Default 0.3.
    self_shadow: Factor on the optical depth from fur to the light. 0 to 4 (factor). Default 1.
    skin: Colour under the fur where the model has none. Default [0.1, 0.065, 0.05].
    """

    shading: Literal["lengyel", "kajiya", "energy_conserving", "scheuermann", "kajiya_kay", "marschner"]
    fibre: Fibre
    colour_source: Literal["automatic", "model", "coat"]
    ambient: float
    diffuse: float
    specular: float
    diffuse_exponent: float
    specular_exponent: float
    back_attenuation: float
    ambient_floor: float
    self_shadow: float
    skin: Colour


class SetLook(TypedDict):
    """Sets how fur is shaded.

    look: The new look.
    op: Name of the command.
    """

    look: Look
    op: Literal["set_look"]


class Light(TypedDict, total=False):
    """A light of the scene.

    kind: Kind of the light. area: a rectangle that shines along `direction` by the cosine, as bright from afar as a
        point light. Shells see it from its middle. Default "directional".
    direction: Where a directional, spot or area light goes. 3 items (any length). Default [0, -1, 0].
    position: Where a point, spot or area light stands. 3 items (model units). Default [0, 0, 0].
    colour: Colour of the light. Default "#ffffff".
    intensity: Brightness; 1 gives white. A point light's is measured at a distance of one size. 0 to 100000000
        (factor). Default 1.
    cone_degrees: Half angle of a spot light. 0.1 to 90 (degrees). Default 30.
    cone_softness: Share of the cone over which a spot light fades. 0 to 1 (share). Default 0.25.
    angle_degrees: Half angle that a directional light spans: wider lights cast softer shadows. 0 to 90 (degrees).
        Default 3.
    radius: Radius of the ball that a point or spot light is: larger ones cast softer shadows. 0 to 10 (sizes).
        Default 0.05.
    width: Width of an area light; its sides along it are level. 0.001 to 100 (sizes). Default 0.5.
    height: Height of an area light. 0.001 to 100 (sizes). Default 0.5.
    self_shadow_maps: Draws shadow maps of the shells in place of the estimate. Only method shells with `shadow_maps`
        reads it. Default false.
    cast_shadow: Shadow of one part of the body on another, with a sharp edge, with one that `shadow_scale` widens, or
        blurred by the light's size. Only method shells with `shadow_maps` reads it: strands take every light's
        shadow. Default "none".
    shadow_scale: Larger makes the edge of a `soft` cast shadow narrower. 0 to 1000 (factor). Default 10.
    """

    kind: Literal["directional", "point", "spot", "area"]
    direction: Direction
    position: Position
    colour: Colour
    intensity: float
    cone_degrees: float
    cone_softness: float
    angle_degrees: float
    radius: float
    width: float
    height: float
    self_shadow_maps: bool
    cast_shadow: Literal["none", "hard", "soft", "penumbra"]
    shadow_scale: float


class SetLights(TypedDict):
    """Places all lights of the scene; an empty list leaves the light from all around alone.

    lights: All lights of the scene. 0 to 8 items.
    op: Name of the command.
    """

    lights: Sequence[Light]
    op: Literal["set_lights"]


class SetEnvironment(TypedDict):
    """Sets the light from all around.

    environment: The new light from all around.
    op: Name of the command.
    """

    environment: Environment
    op: Literal["set_environment"]


class Ground(TypedDict, total=False):
    """A level ground that catches shadow. It darkens the background and shows nothing else.

    visible: Whether there is a ground. Default false.
    height: Height of the ground, the model's y; its lowest point when absent. -1e+27 to 1e+27 (model units).
    shadow: How dark cast shadows get on it. 0 to 1 (share). Default 0.7.
    contact: How dark it gets under the model. 0 to 1 (share). Default 0.7.
    """

    visible: bool
    height: float
    shadow: float
    contact: float


class SetGround(TypedDict):
    """Sets a ground that catches shadow.

    ground: The new ground.
    op: Name of the command.
    """

    ground: Ground
    op: Literal["set_ground"]


class Iris(TypedDict, total=False):
    """The coloured disc of an eye.

    colour: Colour that tints the grey fibres. Default [0.42, 0.115, 0.014].
    inner_colour: Colour around the pupil. Default [0.8, 0.36, 0.055].
    size: Radius of the disc. 0.1 to 0.95 (radii of the eye). Default 0.78.
    depth: Depth of the disc below the cornea's rim. 0 to 0.5 (radii of the eye). Default 0.12.
    relief: Height of the fibres; held at the depth. 0 to 0.2 (radii of the eye). Default 0.06.
    limbal_ring: Darkness of the ring around the iris. 0 to 1 (share). Default 0.75.
    turn_degrees: How far the fibres are turned around the axis. -360 to 360 (degrees). Default 0.
    """

    colour: Colour
    inner_colour: Colour
    size: float
    depth: float
    relief: float
    limbal_ring: float
    turn_degrees: float


class Pupil(TypedDict, total=False):
    """The opening of an iris.

    shape: Form of the opening. Default "round".
    size: Size as a share of the iris: 0 closed, 1 all of it. `automatic` answers the light. Default "automatic".
    """

    shape: Literal["round", "slit"]
    size: Union[float, Literal["automatic"]]


class Lids(TypedDict, total=False):
    """Skin around the eye that leaves an almond open, and shades what lies under it. Angles are seen from the
    eye's centre. Without this block the eye has no lids.

    facing: Middle of the opening; where the eye looks when it is not given. 3 items (any length).
    width_degrees: Angle from the middle of the opening to a corner. 1 to 90 (degrees). Default 64.
    upper_degrees: Angle from the middle of the opening up to the upper lid. -90 to 90 (degrees). Default 42.
    lower_degrees: Angle from the middle of the opening down to the lower lid. -90 to 90 (degrees). Default 32.
    tilt_degrees: How far the opening is turned, counter-clockwise seen from the front. -180 to 180 (degrees). Default
        0.
    colour: Colour of the lids. Default [0.018, 0.013, 0.011].
    """

    facing: Direction
    width_degrees: float
    upper_degrees: float
    lower_degrees: float
    tilt_degrees: float
    colour: Colour


class SetEyes(TypedDict):
    """Places all eyes of the scene; an empty list takes them away. A new creature has two.

    eyes: All eyes of the scene. 0 to 8 items.
    op: Name of the command.
    """

    eyes: Sequence[Eye]
    op: Literal["set_eyes"]


class _CurveGroupRequired(TypedDict):
    curves: Sequence[Sequence[Position]]


class CurveGroup(_CurveGroupRequired, total=False):
    """Curves of one kind. Guides are drawn as they are given, and between each two that follow each other more are
    filled in. They take the look's shading model, and cast shadows where strands are traced.

    curves: Guides: the points that a smooth curve passes through, root first. 1 to 4096 items.
    width_root: Width of a curve at its root. 0 to 0.1 (sizes). Default 0.0008.
    width_tip: Width of a curve at its tip. 0 to 0.1 (sizes). Default 0.0001.
    root_colour: Colour at the root. Default [0.55, 0.5, 0.44].
    tip_colour: Colour at the tip. Default [0.8, 0.77, 0.72].
    fill: Curves between each two guides that follow each other. 0 to 4095. Default 0.
    spread: How far filled curves stray: at 1 half of their length, 30 degrees, and half of the way to the next curve.
        0 to 1 (share). Default 0.
    seed: Other seeds let filled curves stray another way. 0 to 4294967295. Default 1.
    """

    width_root: float
    width_tip: float
    root_colour: Colour
    tip_colour: Colour
    fill: int
    spread: float
    seed: int


class SetCurves(TypedDict):
    """Places all whiskers, lashes and brows of the scene; an empty list takes them away. At most 4096 curves in
    all, filled ones too. A new creature has some.

    groups: All groups of curves of the scene. 0 to 16 items.
    op: Name of the command.
    """

    groups: Sequence[CurveGroup]
    op: Literal["set_curves"]


class _SkinFacingRequired(TypedDict):
    direction: Direction


class SkinFacing(_SkinFacingRequired, total=False):
    """Only skin whose normal lies near a direction belongs to the region. Without this block all of it does.

    direction: Direction that the skin faces. 3 items (any length).
    angle_degrees: Angle from the direction within which the region is whole. 0 to 180 (degrees). Default 70.
    fade_degrees: Angle beyond that over which the region ends. 0 to 180 (degrees). Default 25.
    """

    angle_degrees: float
    fade_degrees: float


class SkinBumps(TypedDict, total=False):
    """Leathery relief: cells with creases between them.

    height: Height of the relief. 0 to 0.1 (sizes). Default 0.0004.
    size: Size of a cell. 0.0001 to 1 (sizes). Default 0.004.
    """

    height: float
    size: float


class _SkinRegionRequired(TypedDict):
    centre: Position
    radii: Sequence[float]


class SkinRegion(_SkinRegionRequired, total=False):
    """An ellipsoid: skin inside it has no fur and a look of its own. Where regions meet, the later lies over the
    earlier.

    centre: Centre of the ellipsoid. 3 items (model units).
    radii: The three radii. The third lies along the axis, the first is level, the second is upright where the axis is
        level. 3 items (sizes).
    axis: Direction of the third radius. 3 items (any length). Default [0, 0, 1].
    turn_degrees: How far the ellipsoid is turned around the axis, counter-clockwise as seen from its tip. -180 to 180
        (degrees). Default 0.
    softness: How far outside the region fur takes to reach its whole length. The colour ends within half of that. 0
        to 10 (radii of the region). Default 0.5.
    facing: Keeps the region to skin that faces one way. Without this block all skin inside it belongs to the region.
    colour: Colour of the skin. Default [0.36, 0.17, 0.13].
    shine: Reflectance: 0 none, 0.5 that of skin, 1 twice that. 0 to 1 (share). Default 0.5.
    roughness: Width of the highlight. 0.02 to 1 (share). Default 0.5.
    wetness: A clear film: darker, with a sharp highlight. 0 to 1 (share). Default 0.
    scatter: How far light wraps around, red the furthest. 0 to 1 (share). Default 0.5.
    bumps: Leathery relief: cells with creases between them.
    """

    axis: Direction
    turn_degrees: float
    softness: float
    facing: SkinFacing
    colour: Colour
    shine: float
    roughness: float
    wetness: float
    scatter: float
    bumps: SkinBumps


class SetSkin(TypedDict):
    """Places all regions of bare skin; an empty list takes them away. A new creature has a nose, lips, ears and
    pads.

    regions: All regions of bare skin. 0 to 64 items.
    op: Name of the command.
    """

    regions: Sequence[SkinRegion]
    op: Literal["set_skin"]


class SetSkinTexture(TypedDict):
    """Lays a picture on the model by its texture coordinates, in place of all colours of its own. `picture` is the
    name that the log has after an upload to `skin_texture`, made from the pixels alone; a picture that no scene of
    this server has used is refused. `own` takes it off again.

    picture: Name of an uploaded picture, or `own` for the model's own colours.
    op: Name of the command.
    """

    picture: Union[Literal["own"], PictureName]
    op: Literal["set_skin_texture"]


class Wind(TypedDict, total=False):
    """A wind over the whole scene, which moves the lean of its fur and never its length. At speed 0 nothing moves.
    Fur .03 sizes long with a stiffness of 1 leans half over in a wind of one size per second; longer fur leans
    further and sways slower, as does fur whose field `stiffness` is lower.

    speed: Speed of the mean wind, and of the gusts that travel with it; 0 for none. 0 to 1000000 (sizes per second).
        Default 0.
    direction: Where the wind goes. 3 items (any length). Default [1, 0, 0].
    gusts: How much its speed rises and falls. 0 to 10 (share). Default 0.5.
    turbulence: How much it turns and flickers, of its speed. 0 to 10 (share). Default 0.35.
    turbulence_scale: Size of its largest eddies; gusts are four to sixteen times as long. 0.001 to 1000 (sizes).
        Default 0.25.
    seed: Other seeds give other gusts and eddies. 0 to 4294967295. Default 1.
    frequency: How fast fur .03 sizes long sways. 0.01 to 100 (hertz). Default 2.
    damping: How soon swaying ends: 1 comes back without swinging over, less swings on. 0.01 to 10 (ratio). Default
        0.2.
    time: Time of the scene, which a frame shows unless it asks for another. -1000000 to 1000000 (seconds). Default 0.
    """

    speed: float
    direction: Direction
    gusts: float
    turbulence: float
    turbulence_scale: float
    seed: int
    frequency: float
    damping: float
    time: float


class SetWind(TypedDict):
    """Sets the wind that moves the fur, and the time of the scene.

    wind: The new wind.
    op: Name of the command.
    """

    wind: Wind
    op: Literal["set_wind"]


class CommandBatch(TypedDict):
    """Several commands as one undo step, all or nothing.

    commands: Commands that run one after another. 1 to 1000 items.
    """

    commands: Sequence[Command]


class AmendRequest(TypedDict):
    """Other commands for an earlier step.

    revision: Revision that made, joined or replayed the step, as in the log, or the number of the step. 0 to
        18446744073709551615.
    commands: Commands that take its place; strokes are whole. An empty list leaves the step out. 0 to 1000 items.
    """

    revision: int
    commands: Sequence[Command]


class BranchRequest(TypedDict, total=False):
    """Where another scene begins.

    name: Name of the new scene: at most 200 bytes of UTF-8, no control characters. Default "branch".
    revision: Revision that it begins as, one of this model; the present one when it is not given. 0 to
        18446744073709551615.
    """

    name: str
    revision: int


class Steps(TypedDict, total=False):
    """How many steps of the undo log.

    steps: How many steps. 1 to 1000000. Default 1.
    """

    steps: int


class RevisionBody(TypedDict):
    """A revision of the scene.

    revision: Revision to go back to. 0 to 18446744073709551615.
    """

    revision: int


class Subdivide(TypedDict, total=False):
    """How a model is made finer.

    levels: How often triangles are split. 1 to 8. Default 1.
    masked: Only triangles with a corner whose mask is above 0.5, and their neighbours so that no crack opens. Default
        false.
    """

    levels: int
    masked: bool


class _CropRequired(TypedDict):
    width: int
    height: int


class Crop(_CropRequired, total=False):
    """A part of a frame.

    left: Where the part begins, from the frame's left. 0 to 8191 (pixels). Default 0.
    top: Where the part begins, from the frame's top. 0 to 8191 (pixels). Default 0.
    width: Width of the part, which ends inside the frame. 1 to 8192 (pixels).
    height: Height of the part, which ends inside the frame. 1 to 8192 (pixels).
    """

    left: int
    top: int


class Rasterizing(TypedDict, total=False):
    """The choice of strands that are rasterized, and how they are lit.

    strands: Strands that are kept of those that stand on a pixel of skin seen from above; the kept ones are as much
        wider, up to 1.5 pixels (of less than .67 up to 2), so that they cover as much. 1000 keeps all. Of a coat of
        more than 2000000 strands as many are drawn. Up to .5 a quarter of the coat grows where no more of it is kept.
        0.01 to 1000 (strands). Default 1.4.
    light_of: Neighbouring strands that share the light of one of them. More is faster and smoother. 1 to 8. Default
        4.
    """

    strands: float
    light_of: int


class Layering(TypedDict, total=False):
    """How fur is drawn in layers, as the papers on GPU fur have it.

    count: Number of shells where the view needs most. 1 to 1024. Default 16.
    policy: How shells are chosen. adaptive: fewer where fur is seen from above or is small on the picture. Default
        "uniform".
    self_shadow: Whether fur shades itself. Default true.
    shadow_maps: Whether shadows that lights ask for are drawn from maps. Default false.
    shadow_resolution: Texels along the side of a shadow map. 1 to 4096 (texels). Default 512.
    order: Order in which fur is blended. four_pass: the skin, the depth of dense fur, fur that faces away, fur that
        faces the camera. `sorted` keeps all fragments of a pixel and sorts them by depth: exact and slow, for
        pictures to compare with. It takes at most 1073741824 drawn pixels x shells. Default "four_pass".
    """

    count: int
    policy: Literal["uniform", "adaptive"]
    self_shadow: bool
    shadow_maps: bool
    shadow_resolution: int
    order: Literal["four_pass", "sorted"]


class PickRay(TypedDict):
    """A ray; the first place of the surface that it hits, from either side, is meant.

    origin: Point that it begins at. 3 items (model units).
    direction: Direction that it goes in. 3 items (any length).
    """

    origin: Position
    direction: Direction


class _ImportOptionsRequired(TypedDict):
    format: Literal["obj", "ply", "stl", "off", "gltf", "glb", "3ds", "zip"]


class ImportOptions(_ImportOptionsRequired, total=False):
    """How a model file is read.

    format: Format of the file.
    up: The file's axis that points up. Unless given: z of stl, else y.
    front: The file's axis that the model faces, on another line than `up`. Unless given it follows from joints that
        are called left and right; without such -y where z is up, else z.
    pose: Moment of an animation of a glTF as NAME@SECONDS, at most 200 bytes: the model stands as it shows it then.
        Unless given it stands as the file has it. Default "".
    crease_degrees: An edge whose triangles' normals differ by more is seen as an edge, and skin and fur beside it are
        lit by their own side alone; 180: none is. 0 to 180 (degrees). Default 60.
    flip: Parts that are turned inside out, by the numbers that `doubtful_parts` of the answer gives. 0 to 1000 items.
    two_sided: Parts of one layer that get a back, so that fur grows on both sides, by the numbers that `sheets` of
        the answer gives; the only part of a model is 1. 0 to 1000 items.
    length: Length of the first fur. 0 to 10 (sizes). Default 0.03.
    inclination: How far fur leans: 0 upright, 1 lying. Where fur begins, ends and parts it stands up. 0 to 1 (share).
        Default 0.45.
    form: How lengths differ over the body. animal: shorter on face and paws, longer on chest and tail, estimated from
        where they lie in the model's box. Default "animal".
    fur_patches: How the sample tile of fur is laid on the surface, once: patches with soft overlaps; the same with
        hard borders, where nothing is drawn twice; or by the model's own texture coordinates, which of the built-in
        models torus, knot, plane and cloth have. Default "overlapping".
    """

    up: Literal["x", "-x", "y", "-y", "z", "-z"]
    front: Literal["x", "-x", "y", "-y", "z", "-z"]
    pose: str
    crease_degrees: float
    flip: Sequence[int]
    two_sided: Sequence[int]
    length: float
    inclination: float
    form: Literal["even", "animal"]
    fur_patches: FurPatches


class EnvironmentUpload(TypedDict, total=False):
    """How a picture lights the scene.

    intensity: Factor on its light. 0 to 100 (factor). Default 1.
    turn_degrees: How far the harmonics are turned about +y, counter-clockwise seen from above. -360 to 360 (degrees).
        Default 0.
    """

    intensity: float
    turn_degrees: float


Revisions = TypedDict("Revisions", {"from": int, "to": int})


class AtRevision(TypedDict, total=False):
    """A revision of the scene.

    revision: Revision to look at, one of this model; the present one when it is not given. 0 to 18446744073709551615.
    """

    revision: int


class MeshRequest(TypedDict, total=False):
    """How fine a mesh is wanted.

    triangles: Largest count of triangles; more come where the model cannot be made simpler. 100 to 200000. Default
        20000.
    """

    triangles: int


class _GuideUploadRequired(TypedDict):
    format: Literal["usda", "hair", "json"]


class GuideUpload(_GuideUploadRequired, total=False):
    """How guide curves are read, and how far fur follows them.

    format: Format of the file.
    keys: Curves that are used at most, chosen evenly by their order; fewer where the model has so many vertices that
        they would be too much work. 1 to 1024. Default 1024.
    sigma: Width of the Gaussians that spread them; from the distance between roots unless given. 1e-06 to 1000000
        (sizes).
    strength: 0 does nothing, 1 all. 0 to 1 (share). Default 1.
    """

    keys: int
    sigma: float
    strength: float


class _ExportRequestRequired(TypedDict):
    format: Literal["usda", "hair", "shells", "cards", "fields", "pelage"]


class ExportRequest(_ExportRequestRequired, total=False):
    """What is exported, and how much of it.

    format: What is written, as the operation says.
    every: Writes about one strand of so many, chosen by numbers of their own; above 1 they count as guides, unless
        they are widened. 1 to 1000000. Default 1.
    widen: Makes strands `every` times as wide, which keeps what they cover. Default false.
    curves: Whether whiskers, lashes and brows are in it. Default true.
    shells: Number of layers; of format `shells` only. 1 to 32. Default 16.
    cards: Number of cards of the finest level, about; of format `cards` only. 100 to 200000. Default 6000.
    """

    every: int
    widen: bool
    curves: bool
    shells: int
    cards: int


class ExportAbout(TypedDict):
    """What an exported file holds.

    revision: Revision that is exported. At least 0.
    format: Format of the file.
    strands: Number of strands, whiskers, lashes and brows; 0 of a GLB. At least 0.
    points: Number of points of all strands. At least 0.
    triangles: Number of triangles of a GLB: skin and all layers, or the skin and the finest level of cards. At least
        0.
    cards: Number of cards of the finest level. At least 0.
    bytes: Size of the file. At least 0.
    """

    revision: int
    format: Literal["usda", "hair", "shells", "cards", "fields", "pelage"]
    strands: int
    points: int
    triangles: int
    cards: int
    bytes: int


class Bounds(TypedDict):
    """A box along the model's axes.

    min: Corner with the smallest coordinates. 3 items (model units).
    max: Corner with the largest coordinates. 3 items (model units).
    """

    min: Position
    max: Position


class _RepairRequired(TypedDict):
    code: str
    count: int


class Repair(_RepairRequired, total=False):
    """Something that was mended or left out of a file.

    code: What was mended or left out, in a word.
    count: How often. At least 0.
    names: Names of the first few that were left out.
    """

    names: Sequence[str]


class NumberedPart(TypedDict):
    """A connected part of the model that the load says something about.

    part: Number of the part, from 1, as `flip` and `two_sided` take it. 1 to 2000000.
    triangles: Number of its triangles. At least 0.
    centre: Centre of its box. 3 items (model units).
    """

    part: int
    triangles: int
    centre: Position


class EditLayer(TypedDict):
    """An edit layer of the scene.

    name: Name of the edit layer.
    weight: How much it counts. -4 to 4 (factor).
    muted: Whether it is left out.
    """

    name: str
    weight: float
    muted: bool


class SceneInfo(TypedDict):
    """A scene: its model, and where its log stands.

    id: Id of the scene, for addresses.
    name: Name of the scene.
    revision: Number of the newest entry of its log. At least 0.
    model: Name of a built-in model, or the format of the file.
    model_id: Equal as long as the mesh is: clients may keep what they know of the mesh under it. Uploads and
        subdivisions change it; a restart may.
    fur_patches: How the sample tile of fur is laid on the surface, once: patches with soft overlaps; the same with
        hard borders, where nothing is drawn twice; or by the model's own texture coordinates, which of the built-in
        models torus, knot, plane and cloth have.
    source_vertices: Number of vertices in the file. At least 0.
    source_faces: Number of faces in the file. At least 0.
    vertices: Number of vertices, welded on equal positions. At least 0.
    triangles: Number of triangles. At least 0.
    parts: Number of connected parts. At least 0.
    size: Diagonal of the box, the model's unit.
    bounds: Box of the model.
    up: The file's axis that was taken for up.
    front: The file's axis that was taken for forward.
    pose: Moment of the animation that it stands in, as NAME@SECONDS; empty as the file has it.
    animations: Names of the animations that the file has.
    repairs: What was mended, and what was left out.
    doubtful_parts: Open parts that may be inside out: what little they enclose says so. `flip` turns one.
    sheets: Parts of one layer, of a model with several: open, and enclosing next to nothing. They are bare behind;
        `two_sided` gives one a back.
    fields_hash: Hash of all fields: the same fur has the same hash.
    undo_steps: Steps that can be undone. At least 0.
    redo_steps: Steps that can be redone. At least 0.
    edit_layers: Edit layers, from the lowest. 0 to 14 items.
    damage: What is damaged of its journal; empty for nothing. Such a scene is as it was before the damage and refuses
        changes (409); it can be looked at, exported and branched, unless its model is what is damaged.
    """

    id: str
    name: str
    revision: int
    model: str
    model_id: str
    fur_patches: FurPatches
    source_vertices: int
    source_faces: int
    vertices: int
    triangles: int
    parts: int
    size: float
    bounds: Bounds
    up: Literal["x", "-x", "y", "-y", "z", "-z"]
    front: Literal["x", "-x", "y", "-y", "z", "-z"]
    pose: str
    animations: Sequence[str]
    repairs: Sequence[Repair]
    doubtful_parts: Sequence[NumberedPart]
    sheets: Sequence[NumberedPart]
    fields_hash: FieldsHash
    undo_steps: int
    redo_steps: int
    edit_layers: Sequence[EditLayer]
    damage: str


class SceneList(TypedDict):
    """The scenes of the server.

    scenes: All scenes. 0 to 64 items.
    """

    scenes: Sequence[SceneInfo]


class FieldChange(TypedDict):
    """How much a field changed.

    field: Field that changed.
    changed: Number of vertices of which a bit changed. At least 0.
    mean_change: Mean change over these vertices, in the field's unit; of several channels the length of the
        difference. At least 0 (the field's unit).
    max_change: Largest change, in the field's unit. At least 0 (the field's unit).
    """

    field: Field
    changed: int
    mean_change: float
    max_change: float


class CommandResult(TypedDict):
    """What one command did.

    op: The command's `op`.
    touched: Number of vertices of which a bit changed. At least 0.
    mean_change: Mean change of the first field that changed, over its changed vertices, in its unit. At least 0 (the
        field's unit).
    max_change: Largest change of that field, in its unit. At least 0 (the field's unit).
    clamped: Number of vertices at which a value was held at its limit. At least 0.
    milliseconds: Time that it took. At least 0 (milliseconds).
    fields: Fields that changed.
    warnings: What was done as asked but is hardly meant, such as a brush finer than the mesh.
    """

    op: str
    touched: int
    mean_change: float
    max_change: float
    clamped: int
    milliseconds: float
    fields: Sequence[FieldChange]
    warnings: Sequence[str]


class CommandAnswer(TypedDict):
    """What commands did, and the revision that they made.

    revision: Revision of the scene afterwards. At least 0.
    fields_hash: Hash of all fields: the same fur has the same hash.
    results: A result for each command, in order.
    """

    revision: int
    fields_hash: FieldsHash
    results: Sequence[CommandResult]


Comparison = TypedDict("Comparison", {"from": int, "to": int, "touched": int, "fields": Sequence[FieldChange]})


class NamedRevision(TypedDict):
    """A revision that has a name.

    name: Name of the checkpoint.
    revision: Revision that has the name. At least 0.
    """

    name: str
    revision: int


class Settings(TypedDict):
    """What a scene holds beside its fields and its log. Each member is as the command that sets it takes it, with
    all defaults; a member that is optional there is absent where it is not set.

    revision: Revision whose settings these are. At least 0.
    coat: Set by set_coat.
    look: Set by set_look.
    lights: Set by set_lights. 0 to 8 items.
    environment: Set by set_environment.
    ground: Set by set_ground.
    wind: Set by set_wind.
    eyes: Set by set_eyes. 0 to 8 items.
    curves: Set by set_curves as `groups`. 0 to 16 items.
    skin: Set by set_skin as `regions`. 0 to 64 items.
    skin_texture: Set by set_skin_texture as `picture`.
    blowers: Set by set_blowers. 0 to 64 items.
    attractors: Set by set_attractors. 0 to 64 items.
    symmetry: Set by set_symmetry.
    checkpoints: Made by checkpoint.
    edit_layers: Changed by edit_layer, from the lowest. 0 to 14 items.
    """

    revision: int
    coat: Coat
    look: Look
    lights: Sequence[Light]
    environment: Environment
    ground: Ground
    wind: Wind
    eyes: Sequence[Eye]
    curves: Sequence[CurveGroup]
    skin: Sequence[SkinRegion]
    skin_texture: Union[Literal["own"], PictureName]
    blowers: Sequence[NamedBlower]
    attractors: Sequence[NamedAttractor]
    symmetry: Symmetry
    checkpoints: Sequence[NamedRevision]
    edit_layers: Sequence[EditLayer]


class _LogEntryRequired(TypedDict):
    revision: int
    kind: Literal["do", "join", "undo", "redo", "revert", "replay"]
    step: int
    touched: int
    in_effect: bool
    author: str


class LogEntry(_LogEntryRequired, total=False):
    """One entry of the log.

    revision: Revision that it made. At least 0.
    kind: What the entry is. `join` and `replay` belong to the undo step of the entry before.
    step: Number of the step whose commands these are: the revision that made it first. An `amend` leaves it to the
        step that it changes and to those that it replays. 0 of undo, redo and revert. At least 0.
    touched: Number of vertices that it changed. At least 0.
    in_effect: Whether its commands are among those that lead to the present: they can be amended.
    author: Name from the `Pelage-Author` of the request that made it; empty where none was named.
    commands: The commands as they were resolved.
    """

    commands: Union[Dict[str, Any], Sequence[Any]]


class Log(TypedDict):
    """The log since the model came.

    entries: Entries, the oldest first.
    """

    entries: Sequence[LogEntry]


class SceneEvent(TypedDict):
    """What a scene is when its news begin and when its mesh is another.

    revision: Revision of the scene. At least 0.
    first_revision: Revision at which the model came; the log has those after it. At least 0.
    undo_steps: Steps that can be undone. At least 0.
    redo_steps: Steps that can be redone. At least 0.
    model_id: Name of the mesh, the same as in `Scene`.
    """

    revision: int
    first_revision: int
    undo_steps: int
    redo_steps: int
    model_id: str


class ChangeEvent(TypedDict):
    """One line of the log without its commands.

    revision: Revision that the change made. At least 0.
    kind: What the change is. `join` and `replay` belong to the undo step of the entry before.
    argument: Steps of `undo` and `redo`; the revision that `revert` goes back to; else 0. At least 0.
    author: Who made it, the same as in `LogEntry`.
    ops: The `op` of its commands, each once.
    touched: Number of vertices that it changed. At least 0.
    undo_steps: Steps that can be undone after it. At least 0.
    redo_steps: Steps that can be redone after it. At least 0.
    """

    revision: int
    kind: Literal["do", "join", "undo", "redo", "revert", "replay"]
    argument: int
    author: str
    ops: Sequence[str]
    touched: int
    undo_steps: int
    redo_steps: int


class PickedStrand(TypedDict):
    """The strand that covers most of a pixel.

    id: Its number, as the AOV strand has it. 1 to 16777216.
    kind: Whether it is of the coat or a curve, such as a whisker.
    along: Where on it the pixel lies: 0 at its root, 1 at its tip. 0 to 1 (share).
    root: Where it stands. 3 items (model units).
    """

    id: int
    kind: Literal["coat", "curve"]
    along: float
    root: Position


class _PickMissRequired(TypedDict):
    hit: Literal[False]


class PickMiss(_PickMissRequired, total=False):
    """The contract's PickMiss.

    hit: Whether the model lies under the pixel.
    strand: The strand that is seen there, beside the model too; absent where skin or nothing shows more.
    """

    strand: PickedStrand


class _PickHitRequired(TypedDict):
    hit: Literal[True]
    triangle: int
    barycentric: Sequence[float]
    position: Position
    normal: Sequence[float]
    direction: Sequence[float]
    inclination: float
    length: float
    stretch: float
    painted: PaintedValues


class PickHit(_PickHitRequired, total=False):
    """The contract's PickHit.

    hit: Whether the model lies under the pixel.
    strand: The strand that is seen there, beside the model too; absent where skin or nothing shows more.
    triangle: Number of the triangle. 0 to 4294967295.
    barycentric: Weights of the triangle's corners. 3 items (share).
    position: Where the model was hit. 3 items (model units).
    normal: Normal of the skin, a unit vector. 3 items (unit vector).
    direction: Where the fur leans, a unit vector; 0 when it stands upright. 3 items (unit vector).
    inclination: How far the fur leans: 0 upright, 1 lying. 0 to 1.000001 (share).
    length: Length of the fur. At least 0 (sizes).
    stretch: What the field stretch holds. At least 0 (share).
    painted: What is painted at a place. A colour is linear red, green and blue, and how much of the coat's colour it
        covers.
    """

    strand: PickedStrand


class PaintedValues(TypedDict):
    """What is painted at a place. A colour is linear red, green and blue, and how much of the coat's colour it
    covers.

    density: Share of the coat's strands that grow. 0 to 1.000001 (the field's unit).
    width: Factor on the coat's strand widths. 0 to 4.000001 (the field's unit).
    curl: Curl, added to the coat's own. 0 to 1.000001 (the field's unit).
    clump: Clumping, added to the coat's own. 0 to 1.000001 (the field's unit).
    wetness: Wetness, added to the coat's own. 0 to 1.000001 (the field's unit).
    bare: 1 where skin shows. 0 to 1.000001 (the field's unit).
    mask: How much tools may change: 1 all, 0 nothing. 0 to 1.000001 (the field's unit).
    root_colour: Colour at the roots, and how much it covers. 4 items (the field's unit).
    tip_colour: Colour at the tips, and how much it covers. 4 items (the field's unit).
    stiffness: Factor on how stiff fur is in the wind. 0 to 4.000001 (the field's unit).
    """

    density: float
    width: float
    curl: float
    clump: float
    wetness: float
    bare: float
    mask: float
    root_colour: Sequence[float]
    tip_colour: Sequence[float]
    stiffness: float


class _ProblemDocumentRequired(TypedDict):
    type: str
    title: str
    status: int
    detail: str


class ProblemDocument(_ProblemDocumentRequired, total=False):
    """A refusal, as RFC 9457 has it.

    type: Name of the kind of problem: `urn:pelage:problem:` and a name, or `about:blank` where the status says it
        all.
    title: What went wrong, the same for all problems of the type.
    status: Status of the answer. 400 to 599.
    detail: What went wrong this time.
    pointer: JSON pointer of the bad field; empty for the whole body.
    limit: Limit that was broken.
    nearest: Nearest known name to an unknown one.
    """

    pointer: str
    limit: str
    nearest: str


class FrameEstimate(TypedDict):
    """How far a frame is estimated to be from the truth, and what it was estimated to cost.

    error: Mean FLIP where there is fur, against the reference: half of the frames have at most this. 0 to 1 (mean
        FLIP).
    error_safety: 95% of frames have at most `error` times it. At least 1 (factor).
    reference: What errors are measured against: the same strands, traced.
    cost_ms: Drawing time, as of `budget_ms`, before the frame was drawn. At least 0 (milliseconds).
    cost_safety: 95% of frames cost at most `cost_ms` times it. At least 1 (factor).
    correction: Measured over predicted cost of this scene's frames so far, which `cost_ms` has in it. It moves in
        steps, and only when it is off by more than 8%.
    end: Why the frame has its knobs. asked: the request named them. budget: better ones cost too much. error: the
        cheapest that keep the error. best: nothing better is known. cheapest: even the cheapest are over the budget.
    calibration: Name of what costs are estimated by; `defaults` until `pelage calibrate` has measured the machine.
    """

    error: float
    error_safety: float
    reference: Literal["traced_strands"]
    cost_ms: float
    cost_safety: float
    correction: float
    end: Literal["asked", "budget", "error", "best", "cheapest"]
    calibration: str


class FrameCounters(TypedDict):
    """What a frame asked of what draws it.

    passes: Programs put to use, one after another. At least 0.
    draws: Draw calls. At least 0.
    textures: Textures bound. At least 0.
    bytes: Bytes sent to what draws for the frame, changes of fields included. At least 0.
    fragments: Runs of fragment shaders, but for the pass that writes the picture's pixels; samples that were drawn
        where the GL does not count runs. At least 0.
    objects: Buffers, textures, targets and programs that were made. At least 0.
    allocated: Bytes of storage that was asked for, without mip levels. At least 0.
    redrawn: Share of the picture that was drawn. It is below 1 after a stroke, where the frame before showed the same
        view: the rest is kept. The picture has the same bits as if all of it had been drawn. 0 to 1 (share).
    """

    passes: int
    draws: int
    textures: int
    bytes: int
    fragments: int
    objects: int
    allocated: int
    redrawn: float


class TraceReport(TypedDict):
    """How far a traced picture is.

    passes: Passes in this picture; 0 where nothing is traced. 0 to 65536.
    samples: Samples of a pixel, on average. At least 0 (samples).
    noise: Estimated mean error of a shown channel. 0 to 1 (share).
    strands: Number of strands. At least 0.
    end: Why tracing ended; none while it goes on.
    grow_ms: Time for growing and indexing strands. At least 0 (milliseconds).
    trace_ms: Time for tracing. At least 0 (milliseconds).
    """

    passes: int
    samples: float
    noise: float
    strands: int
    end: Literal["none", "passes", "noise", "seconds"]
    grow_ms: float
    trace_ms: float


class FrameCost(TypedDict):
    """What drawing a frame is expected to take; waiting for others and encoding come on top.

    seconds: Time by which half of such frames are done. At least 0 (seconds).
    safety: Factor on `seconds`: 95% of such frames are done by then. At least 1 (factor).
    """

    seconds: float
    safety: float


class FrameProgress(TypedDict):
    """A frame that is drawn now or waits to be.

    view: Name of the viewer, from its request.
    width: Width of the picture. 1 to 8192 (pixels).
    height: Height of the picture. 1 to 8192 (pixels).
    share: Share of the expected drawing time that has passed, at most 0.99; 0 while it waits. 0 to 1 (share).
    seconds: Time since it was asked for. At least 0 (seconds).
    expected_seconds: Time that drawing it is expected to take. At least 0 (seconds).
    """

    view: str
    width: int
    height: int
    share: float
    seconds: float
    expected_seconds: float


class FrameProgressList(TypedDict):
    """Frames that are drawn now or wait to be.

    frames: Frames, in the order that they were asked for.
    """

    frames: Sequence[FrameProgress]


Camera = Union[AutoCamera, PinholeCamera]
Command = Union[
    Comb, Blow, Attract, Interpolate, Flow, Smooth, Noise, Unify, Part, Whorl, Length, Trim, Lift, Erase, Clump, Curl,
    Paint, Mask, Map, Retarget, SetBlowers, SetAttractors, SetSymmetry, Checkpoint, ChangeEditLayer, SetCoat, SetLook,
    SetLights, SetEnvironment, SetGround, SetEyes, SetCurves, SetSkin, SetSkinTexture, SetWind
]
Pick = Union[PickMiss, PickHit]
