"""Types of what is sent and answered, a TypedDict for each object of the contract. Made by generate.py.

Members that may be left out are those of classes with `total=False`. Lengths are in sizes, fractions of the diagonal of
the model's box, unless `units` says otherwise; positions are in the model's own coordinates.
"""

from __future__ import annotations

from typing import Any, Dict, Literal, Sequence, TypedDict, Union

Position = Sequence[float]
Direction = Sequence[float]
"""Any length in [1e-6, 1e6]; only where it points counts."""
Barycentric = Sequence[float]
"""Weights of the triangle's corners; their sum is within 0.001 of 1."""
Colour = Union[str, Sequence[float]]
"""sRGB as `#rrggbb`, or linear red, green and blue."""
PictureName = str
"""The name that the upload of a picture was answered with."""
FieldsHash = str
FurPatches = Literal["overlapping", "hard", "own_uvs"]
"""How the sample tile of fur is laid on the surface, once: patches with soft overlaps; the same with hard borders,
where nothing is drawn twice; or by the model's own texture coordinates, which of the built-in models torus, knot,
plane and cloth have.
"""
AutoView = Literal["front", "back", "left", "right", "top", "three_quarter"]
"""`front` looks from +Z, `left` from +X: it shows the animal's left. Each frames the bare model, never the fur."""
Units = Literal["relative", "world"]
"""relative: sizes; world: the model's unit."""
Field = Literal[
    "direction", "length", "stretch", "density", "width", "curl", "clump", "wetness", "bare", "mask", "root_colour",
    "tip_colour"
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
"""draft, interactive and detailed are shells; reference traces strands."""
Aov = Literal[
    "beauty", "alpha", "depth", "position", "normal", "tangent", "albedo", "direct", "shadow", "shell_count"
]
"""All but beauty and alpha leave out the ground, and are drawn with one sample for each drawn pixel. Beauty,
albedo and direct are multiplied by alpha; position, normal, tangent and shadow are means over what covers the
pixel. depth: distance along the view of what first brings the opacity over half (skin, fur, eyes, hairs and
curves), in the model's unit; infinity where there is none. position: the model's own coordinates. normal: of the
skin below, of an eye's ball and cornea. tangent: of fur, hairs and curves, from root to tip; 0 on bare skin and
eyes. direct: what lights add, without the ambient part. shadow: share of that light that shadows leave, 1 where
none comes and on eyes, which take no shadow. shell_count: shells drawn at the pixel; hairs and curves are none.
"""
PickRequest = Union[Dict[str, Any]]
"""Which place is meant: what lies under a pixel of a view; or the first that a ray hits, the farthest along a
direction, or the nearest to a point.
"""


class Sample(TypedDict, total=False):
    """One place, as a position, a pixel of the stroke's view, or a triangle with barycentrics.

    position: In the model's unit; within 1000000 sizes of the model's centre. 3 items.
    screen: Pixels from the top left, y down, centres at .5. 2 items.
    triangle: 0 to 4294967295.
    barycentric: Weights of the triangle's corners; their sum is within 0.001 of 1. 3 items.
    pressure: Scales the brush's strength. 0 to 1. Default 1.
    time: Seconds, not falling along the stroke. 0 to 1000000. Default 0.
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
    """The contract's Stroke.

    id: Parts with one id join one undo step. Empty for a stroke sent whole. At most 200 bytes. Default "".
    part: Number of the part, from 0. 0 to 4294967295. Default 0.
    last: Whether no part comes after this one. Default true.
    view: Required by pixel samples; front faces are then judged against it.
    samples: One place, as a position, a pixel of the stroke's view, or a triangle with barycentrics. 1 to 10000
        items.
    """

    id: str
    part: int
    last: bool
    view: View


class _CombRequired(TypedDict):
    op: Literal["comb"]


class Comb(_CombRequired, total=False):
    """Turns fur the way the stroke moves; as a flood, to `direction` everywhere.

    edit_layer: Edit layer that keeps what changes; the groom below all edit layers unless named. Default "".
    flood: Everywhere in place of a stroke. Default false.
    lean: Inclination that combing tends to: 0 upright, 1 lying. 0 to 1. Default 0.7.
    keep_inclination: Turn the heading alone. Default false.
    direction: Any length in [1e-6, 1e6]; only where it points counts. 3 items.
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

    edit_layer: Edit layer that keeps what changes; the groom below all edit layers unless named. Default "".
    blower: Name of a blower of the scene, in place of all that follows. Default "".
    source: In the model's unit; within 1000000 sizes of the model's centre. 3 items.
    direction: Any length in [1e-6, 1e6]; only where it points counts. 3 items. Default [0, -1, 0].
    cone_degrees: Half angle of the cone, degrees. 0 to 180. Default 40.
    softness: Share of the cone over which its edge fades. 0 to 1. Default 0.25.
    fall: Distance at which the wind has half its strength, in `units`; 0: it does not fall. 0 to 1e+27. Default 0.
    units: relative: sizes; world: the model's unit. Default "relative".
    strength: 0 does nothing, 1 all. 0 to 1. Default 0.5.
    lean: Inclination that the wind tends to: 0 upright, 1 lying. 0 to 1. Default 0.7.
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

    edit_layer: Edit layer that keeps what changes; the groom below all edit layers unless named. Default "".
    attractor: Name of an attractor of the scene, in place of all that follows. Default "".
    point: In the model's unit; within 1000000 sizes of the model's centre. 3 items.
    radius: In `units`; at most 1000000 sizes. 0 to 1e+27. Default 0.2.
    units: relative: sizes; world: the model's unit. Default "relative".
    strength: 0 does nothing, 1 all. 0 to 1. Default 0.5.
    duration: Seconds of pulling. 0 to 10000. Default 1.
    threshold: Stretch that fur takes without growing. 0 to 1000. Default 0.3.
    max_stretch: Largest length over the length before any stretch. 1 to 100. Default 3.
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

    position: The nearest place on the surface is meant. 3 items.
    direction: Any length in [1e-6, 1e6]; only where it points counts. 3 items.
    inclination: 0.5 unless given, where there is a direction. 0 to 1.
    length: In `units`; at most 10 sizes. 0 to 1e+27.
    """

    direction: Direction
    inclination: float
    length: float


class _TrimRequired(TypedDict):
    op: Literal["trim"]


class Trim(_TrimRequired, total=False):
    """Cuts fur by a plane, by a sphere or to a height over the skin, by the way that it leans. A flood cuts
    wholly, whatever the strength.

    edit_layer: Edit layer that keeps what changes; the groom below all edit layers unless named. Default "".
    flood: Everywhere in place of a stroke. Default false.
    height: In `units`; at most 1000000 sizes. 0 to 1e+27.
    units: relative: sizes; world: the model's unit. Default "relative".
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

    edit_layer: Edit layer that keeps what changes; the groom below all edit layers unless named. Default "".
    flood: Everywhere in place of a stroke. Default false.
    checkpoint: Default "".
    revision: Of this model. 0 to 18446744073709551615.
    fields: All but the mask when empty. 0 to 12 items. Default [].
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

    edit_layer: Edit layer that keeps what changes; the groom below all edit layers unless named. Default "".
    flood: Everywhere in place of a stroke. Default false.
    field: Not direction, length or stretch, which have tools of their own. Default "density".
    value: At most 1, of width 4. Of a colour how much it covers. 0 to 4. Default 1.
    colour: Of root_colour and tip_colour only. Default "#ffffff".
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
    field: A field on the surface. direction: where fur leans, its length is the inclination. length: sizes. density,
        bare and mask: shares. width: of the coat's, at most 4. curl, clump and wetness: added to the coat's.
        root_colour and tip_colour: linear colour and how much it covers. Default "length".
    encoding: What the pixels hold. value: a number, or a colour and its cover. uv_tangent: direction along +u and +v
        in red and green, .5 is 0. fast_fur: the same, with width in blue and density in alpha. vector: direction and
        length as one vector of floats, along +u, +v and the normal. automatic: uv_tangent of direction, else value.
        Default "automatic".
    scale: What 1 in the picture stands for, in the field's unit; of fast_fur the width, of vector the length. 1e-27
        to 1e+27. Default 1.
    units: Of a scale of lengths. relative: sizes; world: the model's unit. Default "relative".
    strength: How far the field goes to the picture's. 0 to 1. Default 1.
    tile: UDIM tile that the picture is of, from 1001: only vertices that lie in it change. 0: the picture repeats,
        and all do. 0 to 9999. Default 0.
    edit_layer: Edit layer that keeps what changes; the groom below all edit layers unless named. Default "".
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
    """The contract's MapRequest.

    field: A field on the surface. direction: where fur leans, its length is the inclination. length: sizes. density,
        bare and mask: shares. width: of the coat's, at most 4. curl, clump and wetness: added to the coat's.
        root_colour and tip_colour: linear colour and how much it covers.
    encoding: What the pixels hold. value: a number, or a colour and its cover. uv_tangent: direction along +u and +v
        in red and green, .5 is 0. fast_fur: the same, with width in blue and density in alpha. vector: direction and
        length as one vector of floats, along +u, +v and the normal. automatic: uv_tangent of direction, else value.
        Default "automatic".
    scale: What 1 in the picture stands for, in the field's unit; of fast_fur the width, of vector the length. Unless
        given the field's largest value for PNG, else 1. 1e-27 to 1e+27.
    units: Of a scale of lengths. Default "relative".
    format: 8 or 16 bits, an EXR of floats or halfs, or a NumPy array of floats: [size, size] or [size, size,
        channels], rows from the top; of `vertices` [vertices] or [vertices, channels], without size and dilate.
        Default "png16".
    size: Pixels of a side. Above 4096 one map is made at a time. 1 to 8192. Default 1024.
    dilate: Pixels by which islands grow over their seams. 0 to 64. Default 8.
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

    action: Default "select".
    all: Everything. What select takes when no shape is given.
    vertices: 1 to 100000 items.
    part: The connected part of the model that is nearest.
    picture: An uploaded picture, read at the vertices' texture coordinates. luminance: by Rec. 709's weights of the
        file's own numbers, no curve undone.
    combine: With what the mask is. With replace the rest gets 1 - value. Default "replace".
    value: What the chosen get. 0 to 1. Default 1.
    distance: Along edges, in `units`; at most 1000000 sizes. 0 to 1e+27. Default 0.02.
    passes: 1 to 10000. Default 3.
    units: relative: sizes; world: the model's unit. Default "relative".
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

    action: Default "add".
    weight: Of add, 1 unless given, and set. Below 0 the opposite of what was groomed. Tools change edit layers of at
        least .05 or at most -.05. -4 to 4.
    muted: Of add and set.
    rename: Of set: the new name. Default "".
    above: Of add, else on top, and move, where it is required: the layer that it comes to lie on, or "" for none.
    """

    action: Literal["add", "set", "move", "merge_down", "remove"]
    weight: float
    muted: bool
    rename: str
    above: str


class Environment(TypedDict, total=False):
    """Light from all around: a gradient, or spherical harmonics. It scales the look's `ambient`; white everywhere
    is constant light.

    sky: From straight above. Default "#ffffff".
    horizon: sRGB as `#rrggbb`, or linear red, green and blue. Default "#ffffff".
    ground: From straight below. Default "#ffffff".
    harmonics: In place of the three colours. 9 items.
    turn_degrees: About +y, counter-clockwise seen from above; of harmonics. -360 to 360. Default 0.
    intensity: Factor on its light. 0 to 100. Default 1.
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

    position: Of the ball's centre. 3 items.
    radius: Sizes. 1e-06 to 1000000.
    gaze: Where it looks. 3 items. Default [0, 0, 1].
    look_at: The point that it looks at; not its own position. 3 items.
    lids: Skin around the eye that leaves an almond open, and shades what lies under it. Angles are seen from the
        eye's centre. Without this block the eye has no lids.
    sclera: The white of the eye. Default [0.62, 0.54, 0.47].
    bulge: Of the cornea: 0 none, 1 half a ball. 0 to 1. Default 0.5.
    refraction: Refractive index of the cornea. 1 to 3. Default 1.376.
    wetness: How sharp the tear film reflects: 0 a broad sheen, 1 a mirror. 0 to 1. Default 0.9.
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

    direction: Any length in [1e-6, 1e6]; only where it points counts. 3 items.
    min: Lowest corner of the box; the whole model unless given. 3 items.
    max: Highest corner of the box. With `min`, and nowhere below it. 3 items.
    """

    min: Position
    max: Position


class Knobs(TypedDict, total=False):
    """What is not given is as in the interactive tier.

    method: strands: every strand of the coat, ray traced; of the other knobs it takes `trace`, `eye_steps` and
        `guard_hairs`. Default "shells".
    shells: Where the view needs most. 1 to 1024. Default 16.
    steps: Texture steps inside each slab. 1 to 16. Default 2.
    scale: Rendered size over asked size. Times width and height at most 8192; the tier detailed has 2. 0.25 to 2.
        Default 1.
    min_radius: Rendered pixels of the ball about the model's box: where a scale below 1 gives fewer, the scale is
        larger, up to 1, so that what is small on the picture keeps its form. The answer's knobs have the scale that
        came of it; the tier draft has 120. 0 to 8192. Default 0.
    self_shadow: Default true.
    shadow_maps: Whether shadows that lights ask for are drawn from maps. Default false.
    shadow_resolution: Texels along the side of a shadow map. 1 to 4096. Default 512.
    shell_policy: adaptive: fewer shells where fur is seen from above or is small on the picture. Default "uniform".
    order: Of blending fur. `sorted` keeps all fragments of a pixel and sorts them by depth: exact and slow, for
        pictures to compare with. It takes at most 1073741824 drawn pixels x shells. Of an EXR's AOVs it makes beauty
        and alpha; the others stay in the order of shells. Default "shells".
    eye_steps: Steps into the iris of each eye: 0 a flat disc, 1 refracted and seen at its depth, more: steps of ray
        marching through the iris. 0 to 64. Default 8.
    guard_hairs: Single hairs over the whole model, up to 1.25 times as long as the fur. Shells draw those near
        silhouettes; of strands about as many stand so. 0 to 100000. Default 0.
    trace: Of method strands.
    """

    method: Literal["shells", "strands"]
    shells: int
    steps: int
    scale: float
    min_radius: int
    self_shadow: bool
    shadow_maps: bool
    shadow_resolution: int
    shell_policy: Literal["uniform", "adaptive"]
    order: Literal["shells", "sorted"]
    eye_steps: int
    guard_hairs: int
    trace: Tracing


class Tracing(TypedDict, total=False):
    """How strands are traced. The same picture comes from the same seed and the same count of passes. It ends at
    the first of `passes`, `noise` and `seconds`. Refused with 413 where the strands and the picture need more
    memory than the server gives them.

    passes: At most. A pass adds a sample to each pixel that still needs some. 1 to 65536. Default 64.
    transport: transmittance: light comes through the strands that it crosses by their colour and count. paths: light
        goes from strand to strand. Default "transmittance".
    scattering: What a strand scatters by: the look's shading, or energy_conserving whatever the look says. Paths
        scatter by energy_conserving and refuse `look`. Default "look".
    bounces: Of a path at most; with `paths` only. 1 to 4096. Default 32.
    strands: At most; fewer are drawn wider, so that they cover as much. 1 to 8000000. Default 2000000.
    noise: Ends when the estimated mean error of a shown channel is below, and leaves parts that are; 0 never. 0 to 1.
        Default 0.
    seconds: Ends after as many; 0 never. 0 to 3600. Default 0.
    filter: Direction, depth and colour guide a filter over pictures of few passes. Default true.
    seed: 0 to 4294967295. Default 1.
    """

    passes: int
    transport: Literal["transmittance", "paths"]
    scattering: Literal["look", "energy_conserving"]
    bounces: int
    strands: int
    noise: float
    seconds: float
    filter: bool
    seed: int


class FrameRequest(TypedDict, total=False):
    """The contract's FrameRequest.

    width: Pixels. 1 to 8192. Default 512.
    height: Pixels. 1 to 8192. Default 512.
    camera: A view that the server frames, or a pinhole camera, whose position differs from its target and whose up is
        not along the view. Default {"auto": "three_quarter"}.
    quality: Default "interactive".
    budget_ms: In place of `quality`: the knobs whose drawing time keeps to the budget and whose error, as 95% of
        frames keep it, is estimated least; 95% of frames take at most 1.25 times it. Drawing time is the milliseconds
        that pass on this machine while the frame is drawn; waiting for other frames, reading and encoding are not in
        it. AOVs of an EXR beside beauty, overlays and the making of shadow maps come on top. 1 to 600000.
    max_error: In place of `quality`: the cheapest knobs with at most this error in 95% of frames: mean FLIP where
        there is fur, against the same fur in many sorted shells. 1e-06 to 1.
    max_seconds: Refused where drawing shells is expected to take longer; a dry run says how long. 1 to 86400. Default
        60.
    background: `studio` is a soft gradient with darker corners. Default [0.56, 0.58, 0.61].
    exposure: Stops. -20 to 20. Default 0.
    tone_map: Default "filmic".
    look: In place of the scene's, for this frame.
    view: Name of the viewer: of several frames asked for one view only the newest is drawn, the others get 409. At
        most 200 bytes. Default "".
    format: png and png16: 8 and 16 bit sRGB. jpeg: without alpha. exr: linear light without exposure, tone map and
        background, multiplied by alpha. npy: the pixels of png as a NumPy array of bytes [height, width, 4].
        npy_linear: what an exr of floats holds as a NumPy array of floats [height, width, channels]. Default "png".
    jpeg_quality: 1 to 100. Default 90.
    exr_type: Depth and position are always float. Default "half".
    aovs: Of exr and npy_linear; `[beauty]` when absent. Drawn pixels times AOVs at most 67108864. Channels: R, G, B,
        A of beauty; A of alpha; Z of depth; AOV.X, .Y, .Z of position, normal and tangent; AOV.R, .G, .B of albedo
        and direct; AOV.Y of shadow and shell_count. 1 to 10 items.
    overlay: A field of the skin, or the count of shells, over the frame. Not in linear light. density, wetness and
        mask go from dark violet for 0 to yellow for 1. difference: how much the fields have changed since
        `overlay_from`, with the same colours: of the field that changed most, the change over what counts as much
        (direction and colours: 1; length: the longest fur; others: the field's range). Grey where nothing changed.
        light_depth, light_occlusion and shadow_width hide the frame: maps of the first light that casts a shadow, as
        it sees the model, in grey. light_depth: how near the skin is to the light. light_occlusion: white where skin
        that faces the light lies deeper than what the light sees. shadow_width: the same, reduced and enlarged again.
        Refused where the knob shadow_maps is off, no light casts a shadow, or that light stands too near the model
        for one map. bald and wire hide the frame too: the skin in plain grey without its fur, to find places on it,
        and the same with the edges of its triangles. Default "none".
    progressive: Shells at once; strands of the same revision are then traced while somebody waits for them with
        `after` and `after_pass`. true takes the defaults of Tracing. Pictures may skip passes; answers are to this
        same request, sent again. Name the `view`: what is traced is dropped as soon as the scene changes, the same
        view asks for something else, or nobody has asked for 30 seconds. Refused with 503 while 16 pictures wait to
        be traced.
    overlay_from: The revision that the overlay `difference` compares what is drawn with: one of this model. Only with
        it. 0 to 18446744073709551615.
    revision: Draws the scene as it was at this revision of its model, fields and settings; the present one when it is
        not given. Neither with `progressive` nor with `after`. 0 to 18446744073709551615.
    """

    width: int
    height: int
    camera: Camera
    quality: Union[Tier, Knobs]
    budget_ms: float
    max_error: float
    max_seconds: float
    background: Union[Literal["transparent", "studio"], Colour]
    exposure: float
    tone_map: Literal["none", "filmic"]
    look: Look
    view: str
    format: Literal["png", "png16", "jpeg", "exr", "npy", "npy_linear"]
    jpeg_quality: int
    exr_type: Literal["half", "float"]
    aovs: Sequence[Aov]
    overlay: Literal[
        "none", "direction", "strokes", "length", "density", "wetness", "mask", "shell_count", "light_depth",
        "light_occlusion", "shadow_width", "difference", "bald", "wire"
    ]
    progressive: Union[bool, Tracing]
    overlay_from: int
    revision: int


class _MapUploadRequired(TypedDict):
    field: Field


class MapUpload(_MapUploadRequired, total=False):
    """The contract's MapUpload.

    field: A field on the surface. direction: where fur leans, its length is the inclination. length: sizes. density,
        bare and mask: shares. width: of the coat's, at most 4. curl, clump and wetness: added to the coat's.
        root_colour and tip_colour: linear colour and how much it covers.
    encoding: What the pixels hold. value: a number, or a colour and its cover. uv_tangent: direction along +u and +v
        in red and green, .5 is 0. fast_fur: the same, with width in blue and density in alpha. vector: direction and
        length as one vector of floats, along +u, +v and the normal. automatic: uv_tangent of direction, else value.
        Default "automatic".
    scale: What 1 in the picture stands for. With neither it nor `units`: what the file says of itself, else 1. 1e-27
        to 1e+27.
    units: Of a scale of lengths. Default "relative".
    strength: How far the field goes to the picture's. 0 to 1. Default 1.
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

    revision: At least 0.
    field: A field on the surface. direction: where fur leans, its length is the inclination. length: sizes. density,
        bare and mask: shares. width: of the coat's, at most 4. curl, clump and wetness: added to the coat's.
        root_colour and tip_colour: linear colour and how much it covers.
    encoding: What the pixels hold. value: a number, or a colour and its cover. uv_tangent: direction along +u and +v
        in red and green, .5 is 0. fast_fur: the same, with width in blue and density in alpha. vector: direction and
        length as one vector of floats, along +u, +v and the normal. automatic: uv_tangent of direction, else value.
    scale: What 1 in the picture stands for.
    units: relative: sizes; world: the model's unit.
    covered: Share of the pixels that lie in triangles. 0 to 1.
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
    """The contract's StoredPicture.

    picture: The name that the upload of a picture was answered with.
    width: 1 to 4096.
    height: 1 to 4096.
    bits: Of a channel: 8, 16, or 32 for any float. 8 to 32.
    scale: What 1 in it stands for, where the file says so.
    """

    scale: float


class BuiltinModel(TypedDict, total=False):
    """The contract's BuiltinModel.

    builtin: Default "creature".
    triangles: Triangles that are wished for. 2 to 1000000. Default 5000.
    """

    builtin: Literal["torus", "knot", "sphere", "plane", "cloth", "creature"]
    triangles: int


class FirstGroom(TypedDict, total=False):
    """The first fur, which flows from under the chin to the ends of limbs, ears and tail; on sheets from front to
    back.

    length: Sizes. 0 to 10. Default 0.03.
    inclination: 0 upright, 1 lying. Where fur begins, ends and parts it stands up. 0 to 1. Default 0.45.
    form: animal: shorter on face and paws, longer on chest and tail, estimated from where they lie in the model's
        box. Default "even".
    """

    length: float
    inclination: float
    form: Literal["even", "animal"]


class NewScene(TypedDict, total=False):
    """The contract's NewScene.

    name: At most 200 bytes of UTF-8, no control characters. Default "scene".
    fur: The first fur, which flows from under the chin to the ends of limbs, ears and tail; on sheets from front to
        back.
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

    auto: `front` looks from +Z, `left` from +X: it shows the animal's left. Each frames the bare model, never the
        fur.
    """

    auto: AutoView


class _PinholeCameraRequired(TypedDict):
    position: Position
    target: Position


class PinholeCamera(_PinholeCameraRequired, total=False):
    """The contract's PinholeCamera.

    position: In the model's unit; within 1000000 sizes of the model's centre. 3 items.
    target: In the model's unit; within 1000000 sizes of the model's centre. 3 items.
    up: Any length in [1e-6, 1e6]; only where it points counts. 3 items. Default [0, 1, 0].
    fov_degrees: Vertical field of view, degrees. 1 to 150. Default 35.
    """

    up: Direction
    fov_degrees: float


class View(TypedDict, total=False):
    """The frame that a pixel belongs to.

    camera: A view that the server frames, or a pinhole camera, whose position differs from its target and whose up is
        not along the view. Default {"auto": "three_quarter"}.
    width: Pixels. 1 to 8192. Default 512.
    height: Pixels. 1 to 8192. Default 512.
    """

    camera: Camera
    width: int
    height: int


class Brush(TypedDict, total=False):
    """The contract's Brush.

    radius: In `units`; at most 1000000 sizes. 0 to 1e+27. Default 0.05.
    units: relative: a fraction of the model's size. pixels: of the stroke's view, at the depth of each dab. Default
        "relative".
    falloff_shape: How far a vertex is from a dab: through space, along the surface (it does not reach another part of
        the model that is only near in space), or in the picture of the stroke's view. Default "volume".
    falloff: Default "smooth".
    falloff_points: Weights from the middle to the rim, straight between them, in place of the named curve. 2 to 64
        items.
    strength: 0 does nothing, 1 all. 0 to 1. Default 0.8.
    spacing: From dab to dab, in radii. A stroke takes at most 100000 dabs. 0.01 to 10. Default 0.25.
    pressure_to_radius: Share of the radius that a sample's pressure scales. 0 to 1. Default 0.
    pressure_to_strength: Share of the strength that a sample's pressure scales. 0 to 1. Default 1.
    front_faces_only: Default true.
    cut_off_degrees: Angle to the front from which faces count as back-facing. 0 to 180. Default 90.
    invert: The tool's opposite; refused where it has none. Default false.
    strand_from: From the root, 0, to the tip, 1: the part of the strand that changes. Of colours only: root_colour
        stands for the lower half, tip_colour for the upper. 0 to 1. Default 0.
    strand_to: Above strand_from. 0 to 1. Default 1.
    """

    radius: float
    units: Literal["relative", "world", "pixels"]
    falloff_shape: Literal["volume", "surface", "screen"]
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

    edit_layer: Edit layer that keeps what changes; the groom below all edit layers unless named. Default "".
    keys: What fur is like at one place: a direction, a length or both. 1 to 1024 items.
    sigma: Width of the Gaussians, in `units`; at least 0.000001 and at most 1000000 sizes. 1e-27 to 1e+27. Default
        0.2.
    units: relative: sizes; world: the model's unit. Default "relative".
    distance: straight: through space. dijkstra: along edges, too long by some percent. heat: along the surface by the
        heat method, slower. Default "dijkstra".
    strength: 0 does nothing, 1 all. 0 to 1. Default 1.
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

    edit_layer: Edit layer that keeps what changes; the groom below all edit layers unless named. Default "".
    curves: 1 to 64 items.
    sigma: Width of the Gaussians, in `units`; at least 0.000001 and at most 1000000 sizes. 1e-27 to 1e+27. Default
        0.2.
    units: relative: sizes; world: the model's unit. Default "relative".
    distance: straight: through space. dijkstra: along edges, too long by some percent. heat: along the surface by the
        heat method, slower. Default "dijkstra".
    inclination: The fur keeps its own unless given. 0 to 1.
    strength: 0 does nothing, 1 all. 0 to 1. Default 1.
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

    edit_layer: Edit layer that keeps what changes; the groom below all edit layers unless named. Default "".
    flood: Everywhere in place of a stroke. Default false.
    t: Share of the mean in each pass; up to 0.5 nothing oscillates. 0 to 1. Default 0.5.
    passes: 1 to 10000. Default 3.
    keep_inclination: Smooth headings alone, so that no tuft rises where opposite directions meet. Default false.
    fields: A field on the surface. direction: where fur leans, its length is the inclination. length: sizes. density,
        bare and mask: shares. width: of the coat's, at most 4. curl, clump and wetness: added to the coat's.
        root_colour and tip_colour: linear colour and how much it covers. 1 to 12 items. Default ["direction"].
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

    edit_layer: Edit layer that keeps what changes; the groom below all edit layers unless named. Default "".
    flood: Everywhere in place of a stroke. Default false.
    seed: 0 to 4294967295. Default 1.
    amount: Of directions in inclinations; of length, stretch and width a share of the value; of other fields added. 0
        to 10. Default 0.2.
    feature_size: Of the noise, in `units`; 0: every vertex for itself. 0 to 1e+27. Default 0.
    units: relative: sizes; world: the model's unit. Default "relative".
    fields: A field on the surface. direction: where fur leans, its length is the inclination. length: sizes. density,
        bare and mask: shares. width: of the coat's, at most 4. curl, clump and wetness: added to the coat's.
        root_colour and tip_colour: linear colour and how much it covers. 1 to 12 items. Default ["direction"].
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

    edit_layer: Edit layer that keeps what changes; the groom below all edit layers unless named. Default "".
    flood: Everywhere in place of a stroke. Default false.
    direction: Any length in [1e-6, 1e6]; only where it points counts. 3 items.
    inclination: The fur keeps its own unless given. 0 to 1.
    length: In `units`; at most 10 sizes. 0 to 1e+27.
    units: relative: sizes; world: the model's unit. Default "relative".
    mean: Fields that go to their weighted mean. 0 to 12 items. Default [].
    weight: Beside the brush's own strength. 0 to 1. Default 0.5.
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

    edit_layer: Edit layer that keeps what changes; the groom below all edit layers unless named. Default "".
    lean: Inclination that the fur tends to: 0 upright, 1 lying. 0 to 1. Default 0.7.
    """

    brush: Brush
    edit_layer: str
    lean: float


class _WhorlRequired(TypedDict):
    stroke: Stroke
    op: Literal["whorl"]


class Whorl(_WhorlRequired, total=False):
    """Turns fur round the nearest place of the stroke: a cowlick. Inverted it turns the other way.

    edit_layer: Edit layer that keeps what changes; the groom below all edit layers unless named. Default "".
    turn_degrees: From outwards, counter-clockwise seen from outside: 0 points out, 90 circles, 180 points in. -180 to
        180. Default 70.
    lean: Inclination that the fur tends to: 0 upright, 1 lying. 0 to 1. Default 0.8.
    """

    brush: Brush
    edit_layer: str
    turn_degrees: float
    lean: float


class _LengthRequired(TypedDict):
    op: Literal["length"]


class Length(_LengthRequired, total=False):
    """Changes how long fur is.

    edit_layer: Edit layer that keeps what changes; the groom below all edit layers unless named. Default "".
    flood: Everywhere in place of a stroke. Default false.
    mode: average: to the mean under the brush. jitter: by a random share. min, max: not under, not over. Default
        "set".
    value: A length in `units`, at most 10 sizes and below 0 for add only; a factor for scale, at most 1000000; a
        share for jitter, at most 1. -1e+27 to 1e+27. Default 0.03.
    units: relative: sizes; world: the model's unit. Default "relative".
    seed: 0 to 4294967295. Default 1.
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
    """The contract's TrimPlane.

    point: In the model's unit; within 1000000 sizes of the model's centre. 3 items.
    normal: To the side where no fur may be. 3 items. Default [0, 1, 0].
    """

    normal: Direction


class _TrimSphereRequired(TypedDict):
    centre: Position


class TrimSphere(_TrimSphereRequired, total=False):
    """The contract's TrimSphere.

    centre: In the model's unit; within 1000000 sizes of the model's centre. 3 items.
    radius: In `units`; at most 1000000 sizes. 0 to 1e+27. Default 0.
    keep_inside: Fur ends where it leaves the sphere; else where it enters it. Default true.
    """

    radius: float
    keep_inside: bool


class _LiftRequired(TypedDict):
    op: Literal["lift"]


class Lift(_LiftRequired, total=False):
    """Raises fur; inverted it lays it down. Fur that stands upright has no heading and stays.

    edit_layer: Edit layer that keeps what changes; the groom below all edit layers unless named. Default "".
    flood: Everywhere in place of a stroke. Default false.
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

    edit_layer: Edit layer that keeps what changes; the groom below all edit layers unless named. Default "".
    gather: How far fur turns. 0 to 1. Default 0.3.
    amount: What the field clump tends to. 0 to 1. Default 0.6.
    """

    brush: Brush
    edit_layer: str
    gather: float
    amount: float


class _CurlRequired(TypedDict):
    op: Literal["curl"]


class Curl(_CurlRequired, total=False):
    """Curls fur and turns its heading; inverted it takes the curl out.

    edit_layer: Edit layer that keeps what changes; the groom below all edit layers unless named. Default "".
    flood: Everywhere in place of a stroke. Default false.
    amount: What the field curl tends to. 0 to 1. Default 0.6.
    turn_degrees: Counter-clockwise seen from outside. -180 to 180. Default 0.
    """

    stroke: Stroke
    brush: Brush
    edit_layer: str
    flood: bool
    amount: float
    turn_degrees: float


class MaskAll(TypedDict):
    """The contract's MaskAll."""


class MaskBox(TypedDict):
    """The contract's MaskBox.

    min: In the model's unit; within 1000000 sizes of the model's centre. 3 items.
    max: In the model's unit; within 1000000 sizes of the model's centre. 3 items.
    """

    min: Position
    max: Position


class _MaskSphereRequired(TypedDict):
    centre: Position


class MaskSphere(_MaskSphereRequired, total=False):
    """The contract's MaskSphere.

    centre: In the model's unit; within 1000000 sizes of the model's centre. 3 items.
    radius: In `units`; at most 1000000 sizes. 0 to 1e+27. Default 0.1.
    softness: Share of the radius over which it fades. 0 to 1. Default 0.
    """

    radius: float
    softness: float


class MaskPart(TypedDict):
    """The connected part of the model that is nearest.

    position: In the model's unit; within 1000000 sizes of the model's centre. 3 items.
    """

    position: Position


class _MaskPictureRequired(TypedDict):
    name: PictureName


class MaskPicture(_MaskPictureRequired, total=False):
    """An uploaded picture, read at the vertices' texture coordinates. luminance: by Rec. 709's weights of the
    file's own numbers, no curve undone.

    name: The name that the upload of a picture was answered with.
    channel: Default "luminance".
    """

    channel: Literal["luminance", "red", "green", "blue", "alpha"]


class _RetargetRequired(TypedDict):
    scene: str
    op: Literal["retarget"]


class Retarget(_RetargetRequired, total=False):
    """Takes the fields of another scene, or of this one at another revision, from the nearest places of its
    surface. The mask holds.

    scene: Id of the source, on the same server.
    revision: Of the source's model; the present one unless given. 0 to 18446744073709551615.
    align: box: the models' boxes lie over each other, axis by axis, and lengths stay shares of the size; none: both
        have the same coordinates, and lengths stay what they are in the model's unit. Default "box".
    fields: All but the mask when empty. 0 to 12 items. Default [].
    strength: 0 to 1. Default 1.
    edit_layer: Edit layer that keeps what changes; the groom below all edit layers unless named. Default "".
    """

    revision: int
    align: Literal["box", "none"]
    fields: Sequence[Field]
    strength: float
    edit_layer: str


class _NamedBlowerRequired(TypedDict):
    name: str


class NamedBlower(_NamedBlowerRequired, total=False):
    """The contract's NamedBlower.

    source: In the model's unit; within 1000000 sizes of the model's centre. 3 items. Default [0, 0, 0].
    direction: Any length in [1e-6, 1e6]; only where it points counts. 3 items. Default [0, -1, 0].
    cone_degrees: Half angle of the cone, degrees. 0 to 180. Default 40.
    softness: Share of the cone over which its edge fades. 0 to 1. Default 0.25.
    fall: Distance at which the wind has half its strength, in `units`; 0: it does not fall. 0 to 1e+27. Default 0.
    units: relative: sizes; world: the model's unit. Default "relative".
    strength: 0 does nothing, 1 all. 0 to 1. Default 0.5.
    lean: Inclination that the wind tends to: 0 upright, 1 lying. 0 to 1. Default 0.7.
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

    blowers: 0 to 64 items.
    """

    blowers: Sequence[NamedBlower]
    op: Literal["set_blowers"]


class _NamedAttractorRequired(TypedDict):
    name: str


class NamedAttractor(_NamedAttractorRequired, total=False):
    """The contract's NamedAttractor.

    point: In the model's unit; within 1000000 sizes of the model's centre. 3 items. Default [0, 0, 0].
    radius: In `units`; at most 1000000 sizes. 0 to 1e+27. Default 0.2.
    units: relative: sizes; world: the model's unit. Default "relative".
    strength: 0 does nothing, 1 all. 0 to 1. Default 0.5.
    duration: Seconds of pulling. 0 to 10000. Default 1.
    threshold: Stretch that fur takes without growing. 0 to 1000. Default 0.3.
    max_stretch: Largest length over the length before any stretch. 1 to 100. Default 3.
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

    attractors: 0 to 64 items.
    """

    attractors: Sequence[NamedAttractor]
    op: Literal["set_attractors"]


class Plane(TypedDict, total=False):
    """The contract's Plane.

    point: In the model's unit; within 1000000 sizes of the model's centre. 3 items. Default [0, 0, 0].
    normal: Any length in [1e-6, 1e6]; only where it points counts. 3 items. Default [1, 0, 0].
    """

    point: Position
    normal: Direction


class _SymmetryRequired(TypedDict):
    planes: Sequence[Plane]


class Symmetry(_SymmetryRequired, total=False):
    """Mirror planes, all their combinations, and a rotation about an axis by equal steps.

    planes: 0 to 3 items.
    axis_point: In the model's unit; within 1000000 sizes of the model's centre. 3 items. Default [0, 0, 0].
    axis: Any length in [1e-6, 1e6]; only where it points counts. 3 items. Default [0, 1, 0].
    count: Of equal steps in a whole turn; 1 is no rotation. 1 to 16. Default 1.
    """

    axis_point: Position
    axis: Direction
    count: int


class SetSymmetry(TypedDict):
    """From now on each tool with a place works on all its images too, as one undo step. Places on the surface are
    mirrored to the nearest ones, so a roughly symmetric model will do. Floods have no images.

    symmetry: Mirror planes, all their combinations, and a rotation about an axis by equal steps.
    """

    symmetry: Symmetry
    op: Literal["set_symmetry"]


class _CheckpointRequired(TypedDict):
    name: str
    op: Literal["checkpoint"]


class Checkpoint(_CheckpointRequired, total=False):
    """Gives this revision a name, or an earlier one; a name that is known moves.

    revision: The one that this command makes unless given. 0 to 18446744073709551615.
    """

    revision: int


class RampStop(TypedDict):
    """The contract's RampStop.

    at: 0 root, 1 tip; rises from stop to stop. 0 to 1.
    colour: sRGB as `#rrggbb`, or linear red, green and blue.
    """

    at: float
    colour: Colour


class Undercoat(TypedDict, total=False):
    """Short, fine strands under the others.

    share: Of the strands. 0 to 1. Default 0.
    length: Over the overcoat's. 0.02 to 1. Default 0.5.
    width: Over the overcoat's. 0.05 to 4. Default 0.6.
    lightness: Factor on the ramp's colour. 0 to 4. Default 1.
    tint: How far `colour` replaces the ramp's. 0 to 1. Default 0.
    colour: sRGB as `#rrggbb`, or linear red, green and blue. Default [0.5, 0.5, 0.5].
    """

    share: float
    length: float
    width: float
    lightness: float
    tint: float
    colour: Colour


class Ticking(TypedDict, total=False):
    """Ticking: hairs of one colour of their own.

    share: Of the strands. 0 to 1. Default 0.
    colour: sRGB as `#rrggbb`, or linear red, green and blue. Default [0.85, 0.85, 0.85].
    """

    share: float
    colour: Colour


class Tufts(TypedDict, total=False):
    """Clumps larger than the tile, gathered about places on the body, so that the fur does not repeat and has form
    at a distance. Each finer scale is .45 of the one before.

    gather: How far tips go to the middle of their tuft. 0 to 1. Default 0.
    size: Mean distance of the largest tufts, sizes. 0.01 to 1. Default 0.05.
    scales: 1 to 3. Default 2.
    seed: 0 to 4294967295. Default 1.
    """

    gather: float
    size: float
    scales: int
    seed: int


class Pattern(TypedDict, total=False):
    """Markings by where a root is, with y up and the nose at +z; no UVs are needed.

    kind: Default "none".
    scale: From one marking to the next, sizes. 0.005 to 2. Default 0.07.
    coverage: Share of the surface that is marked; countershading: how far up it reaches. 0 to 1. Default 0.5.
    contrast: How far markings replace the coat's colour. 0 to 1. Default 1.
    softness: Width of a marking's edge over the marking's. 0 to 1. Default 0.15.
    warp: How far noise bends the markings, in distances from one to the next. 0 to 2. Default 0.5.
    legs: How far stripes turn to rings on legs and haunches, and rosettes fill there. 0 to 1. Default 1.
    inner: How far inner_colour is seen: in rosettes, as second patches, between stripes. 0 to 1. Default 0.
    belly: How far the underside takes belly_colour and loses its markings. 0 to 1. Default 0.
    axis: Along which stripes follow each other. 3 items. Default [0, 0, 1].
    colour: sRGB as `#rrggbb`, or linear red, green and blue. Default [0.012, 0.01, 0.009].
    inner_colour: sRGB as `#rrggbb`, or linear red, green and blue. Default [0.22, 0.1, 0.035].
    belly_colour: sRGB as `#rrggbb`, or linear red, green and blue. Default [0.75, 0.7, 0.62].
    seed: 0 to 4294967295. Default 1.
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

    lightness: 1: from half to twice. 0 to 1. Default 0.
    hue: 1: from a third towards blue to a third towards red. 0 to 1. Default 0.
    length: 1: from none to twice. 0 to 1. Default 0.
    lean: 1: the whole range of the inclination. 0 to 1. Default 0.
    size: From one swell to the next, sizes. 0.005 to 2. Default 0.12.
    """

    lightness: float
    hue: float
    length: float
    lean: float
    size: float


class Coat(TypedDict, total=False):
    """How the strands of the sample tile are made. What is not given takes its default.

    count: Strands in the tile. 1 to 100000. Default 9000.
    tile: Side of the tile, sizes. 0.01 to 1. Default 0.12.
    width_root: Sizes. 0 to 0.05. Default 0.0011.
    width_tip: Sizes. 0 to 0.05. Default 0.00028.
    bend: How far a strand bows to a side, in strand lengths. 0 to 2. Default 0.25.
    curl: Radius of the strand's helix, in strand lengths. 0 to 0.5. Default 0.
    curl_turns: Turns of the helix from root to tip. 0 to 20. Default 3.
    curl_together: How far the strands of a clump curl as one lock. 0 to 1. Default 0.
    wave: Amplitude of a sine in one plane, in strand lengths. 0 to 0.5. Default 0.
    wave_turns: Waves from root to tip. 0 to 20. Default 3.
    mess: How far each strand goes and bows its own way. 0 to 1. Default 0.
    clump: How far tips gather to the middle of their clump. 0 to 1. Default 0.4.
    clump_size: Mean distance of clumps, sizes. 0.001 to 0.5. Default 0.01.
    fine_clump: How far strands gather to locks inside their clump. 0 to 1. Default 0.
    fine_clump_size: Mean distance of these locks, sizes. 0.001 to 0.5. Default 0.004.
    lodge: How far patches of strands are pressed to one side. 0 to 1. Default 0.
    lodge_size: Mean distance of these patches, sizes. 0.001 to 0.5. Default 0.04.
    wetness: Tighter clumps, darker (absorption up to 1.8 times) and shinier fur (highlight up to twice as strong). 0
        to 1. Default 0.
    length_spread: Share of the length that is random. 0 to 1. Default 0.3.
    warmth_spread: Change of hue from strand to strand, to red and to blue, at the same lightness: 1 is up to twice
        the one over the other. 0 to 1. Default 0.
    colour_spread: Change of lightness from strand to strand. 0 to 1. Default 0.12.
    root_share: Angle at the root over angle at the tip: 0 plush, .6 sleek. 0 to 1. Default 0.3.
    lean_curve: arc, or root: y = K sqrt(x). Default "arc".
    ramp: Colour along the strand. 1 to 4 items.
    undercoat: Short, fine strands under the others.
    ticking: Ticking: hairs of one colour of their own.
    tufts: Clumps larger than the tile, gathered about places on the body, so that the fur does not repeat and has
        form at a distance. Each finer scale is .45 of the one before.
    pattern: Markings by where a root is, with y up and the nose at +z; no UVs are needed.
    variation: How much colour and form change slowly over the body.
    seed: 0 to 4294967295. Default 1.
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
    ticking: Ticking
    tufts: Tufts
    pattern: Pattern
    variation: Variation
    seed: int


class SetCoat(TypedDict):
    """The contract's SetCoat.

    coat: How the strands of the sample tile are made. What is not given takes its default.
    """

    coat: Coat
    op: Literal["set_coat"]


class Fibre(TypedDict, total=False):
    """Fibres as the models energy_conserving, marschner and scheuermann take them.

    longitudinal_roughness: beta_m; energy_conserving. 0 to 1. Default 0.3.
    azimuthal_roughness: beta_n; energy_conserving. 0 to 1. Default 0.3.
    cuticle_tilt: Degrees; turns reflected light to the root. -15 to 15. Default 2.
    refractive_index: 1 to 3. Default 1.55.
    absorption: What the absorption is worked out from. Default "colour".
    eumelanin: Brown and black. 0 to 10000. Default 0.3.
    pheomelanin: Red. 0 to 10000. Default 0.
    highlight_width: Degrees; marschner. 0 to 90. Default 7.5.
    caustic_width: Degrees; marschner. 1 to 60. Default 10.
    primary_shift: Above 0: highlight nearer the tip; scheuermann. -2 to 2. Default 0.1.
    secondary_shift: scheuermann. -2 to 2. Default -0.15.
    shift_spread: From strand to strand; scheuermann. 0 to 2. Default 0.1.
    secondary_specular: Of the coloured lobe; scheuermann. 0 to 4. Default 0.3.
    secondary_exponent: scheuermann. 0 to 1000000. Default 12.
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
    fibre: Fibres as the models energy_conserving, marschner and scheuermann take them.
    colour_source: model: its texture or vertex colours; coat: the ramp; automatic: the model's where it has colours.
        Default "automatic".
    ambient: 0 to 4. Default 0.38.
    diffuse: 0 to 4. Default 0.8.
    specular: 0 to 4. Default 0.25.
    diffuse_exponent: 0 to 1000000. Default 1.2.
    specular_exponent: 0 to 1000000. Default 40.
    back_attenuation: 0.001 to 1. Default 0.5.
    ambient_floor: Ambient light that reaches the roots. 0 to 1. Default 0.3.
    self_shadow: Scales the optical depth to the light. 0 to 4. Default 1.
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
    """The contract's SetLook.

    look: How fur is shaded. What is not given takes its default.
    """

    look: Look
    op: Literal["set_look"]


class Light(TypedDict, total=False):
    """The contract's Light.

    kind: area: a rectangle that shines along `direction` by the cosine, as bright from afar as a point light. Shells
        see it from its middle. Default "directional".
    direction: Where a directional, spot or area light goes. 3 items. Default [0, -1, 0].
    position: Of a point, spot or area light. 3 items. Default [0, 0, 0].
    colour: sRGB as `#rrggbb`, or linear red, green and blue. Default "#ffffff".
    intensity: 1 gives white; a point light's is measured at a distance of one size. 0 to 100000000. Default 1.
    cone_degrees: Half angle of a spot light. 0.1 to 90. Default 30.
    cone_softness: Share of the cone over which a spot light fades. 0 to 1. Default 0.25.
    angle_degrees: Half angle that a directional light spans, for traced strands and a `penumbra`. 0 to 90. Default 3.
    radius: Of the ball that a point or spot light is, sizes, for traced strands and a `penumbra`. 0 to 10. Default
        0.05.
    width: Of an area light, sizes; level. 0.001 to 100. Default 0.5.
    height: Of an area light, sizes. 0.001 to 100. Default 0.5.
    self_shadow_maps: Shadow maps of the shells in place of the estimate, in frames with `shadow_maps`. Default false.
    cast_shadow: Shadow of one part of the body on another, in frames with `shadow_maps`: with a sharp edge, with one
        that `shadow_scale` widens, or blurred by the light's size, nearest to traced strands. Default "none".
    shadow_scale: Larger makes the edge of a `soft` cast shadow narrower. 0 to 1000. Default 10.
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
    """The contract's SetLights.

    lights: 0 to 8 items.
    """

    lights: Sequence[Light]
    op: Literal["set_lights"]


class SetEnvironment(TypedDict):
    """The contract's SetEnvironment.

    environment: Light from all around: a gradient, or spherical harmonics. It scales the look's `ambient`; white
        everywhere is constant light.
    """

    environment: Environment
    op: Literal["set_environment"]


class Ground(TypedDict, total=False):
    """A level ground that catches shadow. It darkens the background and shows nothing else.

    visible: Default false.
    height: The model's y; its lowest point when absent. -1e+27 to 1e+27.
    shadow: How dark cast shadows get on it, in frames with `shadow_maps`. 0 to 1. Default 0.7.
    contact: How dark it gets under the model. 0 to 1. Default 0.7.
    """

    visible: bool
    height: float
    shadow: float
    contact: float


class SetGround(TypedDict):
    """The contract's SetGround.

    ground: A level ground that catches shadow. It darkens the background and shows nothing else.
    """

    ground: Ground
    op: Literal["set_ground"]


class Iris(TypedDict, total=False):
    """The contract's Iris.

    colour: Tints the grey fibres. Default [0.42, 0.115, 0.014].
    inner_colour: Around the pupil. Default [0.8, 0.36, 0.055].
    size: Radius of the disc, in radii of the eye. 0.1 to 0.95. Default 0.78.
    depth: Of the disc below the cornea's rim, in radii of the eye. 0 to 0.5. Default 0.12.
    relief: Height of the fibres, in radii of the eye; held at the depth. 0 to 0.2. Default 0.06.
    limbal_ring: Darkness of the ring around the iris. 0 to 1. Default 0.75.
    turn_degrees: Of the fibres around the axis, degrees. -360 to 360. Default 0.
    """

    colour: Colour
    inner_colour: Colour
    size: float
    depth: float
    relief: float
    limbal_ring: float
    turn_degrees: float


class Pupil(TypedDict, total=False):
    """The contract's Pupil.

    shape: Default "round".
    size: Share of the iris: 0 closed, 1 all of it. `automatic` answers the light. Default "automatic".
    """

    shape: Literal["round", "slit"]
    size: Union[float, Literal["automatic"]]


class Lids(TypedDict, total=False):
    """Skin around the eye that leaves an almond open, and shades what lies under it. Angles are seen from the
    eye's centre. Without this block the eye has no lids.

    facing: Middle of the opening; where the eye looks when it is not given. 3 items.
    width_degrees: From the middle to a corner. 1 to 90. Default 64.
    upper_degrees: From the middle up to the upper lid. -90 to 90. Default 42.
    lower_degrees: From the middle down to the lower lid. -90 to 90. Default 32.
    tilt_degrees: Counter-clockwise, seen from the front. -180 to 180. Default 0.
    colour: sRGB as `#rrggbb`, or linear red, green and blue. Default [0.018, 0.013, 0.011].
    """

    facing: Direction
    width_degrees: float
    upper_degrees: float
    lower_degrees: float
    tilt_degrees: float
    colour: Colour


class SetEyes(TypedDict):
    """Places all eyes of the scene; an empty list takes them away. A new creature has two.

    eyes: A ball with a bulging cornea. Lengths of its parts are in its radii. It takes a gaze or a point to look at.
        0 to 8 items.
    """

    eyes: Sequence[Eye]
    op: Literal["set_eyes"]


class _CurveGroupRequired(TypedDict):
    curves: Sequence[Sequence[Position]]


class CurveGroup(_CurveGroupRequired, total=False):
    """Curves of one kind. Guides are drawn as they are given, and between each two that follow each other more are
    filled in. They take the look's shading model, cast no shadow, and of the AOVs of an EXR are in beauty and
    alpha alone.

    curves: Guides: the points that a smooth curve passes through, root first. 1 to 4096 items.
    width_root: Sizes. 0 to 0.1. Default 0.0008.
    width_tip: Sizes. 0 to 0.1. Default 0.0001.
    root_colour: sRGB as `#rrggbb`, or linear red, green and blue. Default [0.55, 0.5, 0.44].
    tip_colour: sRGB as `#rrggbb`, or linear red, green and blue. Default [0.8, 0.77, 0.72].
    fill: Curves between each two guides that follow each other. 0 to 4095. Default 0.
    spread: How far filled curves stray: at 1 half of their length, 30 degrees, and half of the way to the next curve.
        0 to 1. Default 0.
    seed: 0 to 4294967295. Default 1.
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

    groups: Curves of one kind. Guides are drawn as they are given, and between each two that follow each other more
        are filled in. They take the look's shading model, cast no shadow, and of the AOVs of an EXR are in beauty and
        alpha alone. 0 to 16 items.
    """

    groups: Sequence[CurveGroup]
    op: Literal["set_curves"]


class _SkinFacingRequired(TypedDict):
    direction: Direction


class SkinFacing(_SkinFacingRequired, total=False):
    """Only skin whose normal lies near a direction belongs to the region. Without this block all of it does.

    direction: Any length in [1e-6, 1e6]; only where it points counts. 3 items.
    angle_degrees: From the direction, where the region is whole. 0 to 180. Default 70.
    fade_degrees: Over which it ends beyond that. 0 to 180. Default 25.
    """

    angle_degrees: float
    fade_degrees: float


class SkinBumps(TypedDict, total=False):
    """Leathery relief: cells with creases between them.

    height: Sizes. 0 to 0.1. Default 0.0004.
    size: Of a cell, sizes. 0.0001 to 1. Default 0.004.
    """

    height: float
    size: float


class _SkinRegionRequired(TypedDict):
    centre: Position
    radii: Sequence[float]


class SkinRegion(_SkinRegionRequired, total=False):
    """An ellipsoid: skin inside it has no fur and a look of its own. Where regions meet, the later lies over the
    earlier.

    centre: In the model's unit; within 1000000 sizes of the model's centre. 3 items.
    radii: Sizes. The third lies along the axis, the first is level, the second is upright where the axis is level. 3
        items.
    axis: Of the third radius. 3 items. Default [0, 0, 1].
    turn_degrees: Around the axis, counter-clockwise as seen from its tip. -180 to 180. Default 0.
    softness: How far outside the region fur takes to reach its whole length, in the region's radii. The colour ends
        within half of that. 0 to 10. Default 0.5.
    facing: Only skin whose normal lies near a direction belongs to the region. Without this block all of it does.
    colour: sRGB as `#rrggbb`, or linear red, green and blue. Default [0.36, 0.17, 0.13].
    shine: Reflectance: 0 none, 0.5 that of skin, 1 twice that. 0 to 1. Default 0.5.
    roughness: Width of the highlight. 0.02 to 1. Default 0.5.
    wetness: A clear film: darker, with a sharp highlight. 0 to 1. Default 0.
    scatter: How far light wraps around, red the furthest. 0 to 1. Default 0.5.
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

    regions: An ellipsoid: skin inside it has no fur and a look of its own. Where regions meet, the later lies over
        the earlier. 0 to 64 items.
    """

    regions: Sequence[SkinRegion]
    op: Literal["set_skin"]


class SetSkinTexture(TypedDict):
    """Lays a picture on the model by its texture coordinates, in place of all colours of its own. `picture` is the
    name that the log has after an upload to `skin_texture`, made from the pixels alone; a picture that no scene of
    this server has used is refused. `own` takes it off again.
    """

    picture: Union[Literal["own"], PictureName]
    op: Literal["set_skin_texture"]


class CommandBatch(TypedDict):
    """The contract's CommandBatch.

    commands: 1 to 1000 items.
    """

    commands: Sequence[Command]


class AmendRequest(TypedDict):
    """The contract's AmendRequest.

    revision: That made, joined or replayed the step, as in the log, or the number of the step. 0 to
        18446744073709551615.
    commands: What takes its place; strokes are whole. None leaves the step out. 0 to 1000 items.
    """

    revision: int
    commands: Sequence[Command]


class BranchRequest(TypedDict, total=False):
    """The contract's BranchRequest.

    name: At most 200 bytes of UTF-8, no control characters. Default "branch".
    revision: One of this model; the present one when it is not given. 0 to 18446744073709551615.
    """

    name: str
    revision: int


class Steps(TypedDict, total=False):
    """The contract's Steps.

    steps: 1 to 1000000. Default 1.
    """

    steps: int


class RevisionBody(TypedDict):
    """The contract's RevisionBody.

    revision: 0 to 18446744073709551615.
    """

    revision: int


class Subdivide(TypedDict, total=False):
    """The contract's Subdivide.

    levels: How often triangles are split. 1 to 8. Default 1.
    masked: Only triangles with a corner whose mask is above 0.5, and their neighbours so that no crack opens. Default
        false.
    """

    levels: int
    masked: bool


class PickRay(TypedDict):
    """The first place of the surface that it hits, from either side.

    origin: In the model's unit; within 1000000 sizes of the model's centre. 3 items.
    direction: Any length in [1e-6, 1e6]; only where it points counts. 3 items.
    """

    origin: Position
    direction: Direction


class _ImportOptionsRequired(TypedDict):
    format: Literal["obj", "ply", "stl", "off", "gltf", "glb", "3ds", "zip"]


class ImportOptions(_ImportOptionsRequired, total=False):
    """The contract's ImportOptions.

    up: The file's axis that points up. Unless given: z of stl, else y.
    front: The file's axis that the model faces, on another line than `up`. Unless given it follows from joints that
        are called left and right; without such -y where z is up, else z.
    pose: NAME@SECONDS of an animation of a glTF, at most 200 bytes: the model stands as it shows it then. Unless
        given it stands as the file has it. Default "".
    crease_degrees: An edge whose triangles' normals differ by more is seen as an edge, and skin and fur beside it are
        lit by their own side alone; 180: none is. 0 to 180. Default 60.
    flip: Parts that are turned inside out, by the numbers that `doubtful_parts` of the answer gives. 0 to 1000 items.
    two_sided: Parts of one layer that get a back, so that fur grows on both sides, by the numbers that `sheets` of
        the answer gives; the only part of a model is 1. 0 to 1000 items.
    length: Sizes. 0 to 10. Default 0.03.
    inclination: 0 upright, 1 lying. Where fur begins, ends and parts it stands up. 0 to 1. Default 0.45.
    form: animal: shorter on face and paws, longer on chest and tail, estimated from where they lie in the model's
        box. Default "animal".
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
    """The contract's EnvironmentUpload.

    intensity: Factor on its light. 0 to 100. Default 1.
    turn_degrees: About +y, counter-clockwise seen from above; of harmonics. -360 to 360. Default 0.
    """

    intensity: float
    turn_degrees: float


Revisions = TypedDict("Revisions", {"from": int, "to": int})


class AtRevision(TypedDict, total=False):
    """The contract's AtRevision.

    revision: One of this model; the present one when it is not given. 0 to 18446744073709551615.
    """

    revision: int


class MeshRequest(TypedDict, total=False):
    """The contract's MeshRequest.

    triangles: At most so many, but where the model cannot be made simpler. 100 to 200000. Default 20000.
    """

    triangles: int


class _GuideUploadRequired(TypedDict):
    format: Literal["usda", "hair", "json"]


class GuideUpload(_GuideUploadRequired, total=False):
    """The contract's GuideUpload.

    keys: Curves that are used at most, chosen evenly by their order; fewer where the model has so many vertices that
        they would be too much work. 1 to 1024. Default 1024.
    sigma: Width of the Gaussians that spread them, sizes; from the distance between roots unless given. 1e-06 to
        1000000.
    strength: 0 does nothing, 1 all. 0 to 1. Default 1.
    """

    keys: int
    sigma: float
    strength: float


class _ExportRequestRequired(TypedDict):
    format: Literal["usda", "hair", "shells", "cards", "fields", "pelage"]


class ExportRequest(_ExportRequestRequired, total=False):
    """The contract's ExportRequest.

    every: About one strand of so many, chosen by numbers of their own; above 1 they count as guides, unless they are
        widened. 1 to 1000000. Default 1.
    widen: Makes strands `every` times as wide, which keeps what they cover. Default false.
    curves: With whiskers, lashes and brows. Default true.
    shells: Layers of `shells`. 1 to 32. Default 16.
    cards: Of the finest level of `cards`, about. 100 to 200000. Default 6000.
    """

    every: int
    widen: bool
    curves: bool
    shells: int
    cards: int


class ExportAbout(TypedDict):
    """What an exported file holds.

    revision: At least 0.
    strands: With whiskers, lashes and brows; 0 of a GLB. At least 0.
    points: Of all strands. At least 0.
    triangles: Of a GLB: of the skin and of all layers, or of the finest level of cards. At least 0.
    cards: Of the finest level. At least 0.
    bytes: Of the file. At least 0.
    """

    revision: int
    format: Literal["usda", "hair", "shells", "cards", "fields", "pelage"]
    strands: int
    points: int
    triangles: int
    cards: int
    bytes: int


class Bounds(TypedDict):
    """The contract's Bounds.

    min: In the model's unit; within 1000000 sizes of the model's centre. 3 items.
    max: In the model's unit; within 1000000 sizes of the model's centre. 3 items.
    """

    min: Position
    max: Position


class _RepairRequired(TypedDict):
    code: str
    count: int


class Repair(_RepairRequired, total=False):
    """The contract's Repair.

    count: At least 0.
    names: Of what was left out, the first few.
    """

    names: Sequence[str]


class NumberedPart(TypedDict):
    """The contract's NumberedPart.

    part: Its number, from 1, as `flip` and `two_sided` take it. 1 to 2000000.
    triangles: At least 0.
    centre: Of its box. 3 items.
    """

    part: int
    triangles: int
    centre: Position


class EditLayer(TypedDict):
    """The contract's EditLayer.

    weight: -4 to 4.
    """

    name: str
    weight: float
    muted: bool


class SceneInfo(TypedDict):
    """The contract's SceneInfo.

    revision: At least 0.
    model: A built-in's name, or a format.
    model_id: Equal as long as the mesh is: clients may keep what they know of the mesh under it. Uploads and
        subdivisions change it; a restart may.
    fur_patches: How the sample tile of fur is laid on the surface, once: patches with soft overlaps; the same with
        hard borders, where nothing is drawn twice; or by the model's own texture coordinates, which of the built-in
        models torus, knot, plane and cloth have.
    source_vertices: At least 0.
    source_faces: At least 0.
    vertices: Welded on equal positions. At least 0.
    triangles: At least 0.
    parts: Connected parts. At least 0.
    size: Diagonal of the box, the model's unit.
    up: The file's axis that was taken for up.
    front: The file's axis that was taken for forward.
    pose: NAME@SECONDS of the animation that it stands in; empty as the file has it.
    animations: Names of those that the file has.
    repairs: What was mended, and what was left out.
    doubtful_parts: Open parts that may be inside out: what little they enclose says so. `flip` turns one.
    sheets: Of several parts those of one layer: open, and enclosing next to nothing. They are bare behind;
        `two_sided` gives one a back.
    undo_steps: At least 0.
    redo_steps: At least 0.
    edit_layers: Edit layers, from the lowest. 0 to 14 items.
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


class SceneList(TypedDict):
    """The contract's SceneList.

    scenes: 0 to 64 items.
    """

    scenes: Sequence[SceneInfo]


class FieldChange(TypedDict):
    """The contract's FieldChange.

    field: A field on the surface. direction: where fur leans, its length is the inclination. length: sizes. density,
        bare and mask: shares. width: of the coat's, at most 4. curl, clump and wetness: added to the coat's.
        root_colour and tip_colour: linear colour and how much it covers.
    changed: Vertices of which a bit changed. At least 0.
    mean_change: Over them, in the field's unit; of several channels the length of the difference. At least 0.
    max_change: At least 0.
    """

    field: Field
    changed: int
    mean_change: float
    max_change: float


class CommandResult(TypedDict):
    """The contract's CommandResult.

    touched: Vertices of which a bit changed. At least 0.
    mean_change: Of the first field that changed, over its changed vertices, in its unit. At least 0.
    max_change: At least 0.
    clamped: Vertices at which a value was held at its limit. At least 0.
    milliseconds: At least 0.
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
    """The contract's CommandAnswer.

    revision: At least 0.
    """

    revision: int
    fields_hash: FieldsHash
    results: Sequence[CommandResult]


Comparison = TypedDict("Comparison", {"from": int, "to": int, "touched": int, "fields": Sequence[FieldChange]})


class FoldCount(TypedDict):
    """The contract's FoldCount.

    revision: At least 0.
    triangles: At least 0.
    folded: At least 0.
    """

    revision: int
    triangles: int
    folded: int


class NamedRevision(TypedDict):
    """The contract's NamedRevision.

    revision: At least 0.
    """

    name: str
    revision: int


class Settings(TypedDict):
    """What a scene holds beside its fields and its log. Each member is as the command that sets it takes it, with
    all defaults; a member that is optional there is absent where it is not set.

    revision: Whose settings these are. At least 0.
    coat: Set by set_coat.
    look: Set by set_look.
    lights: Set by set_lights. 0 to 8 items.
    environment: Set by set_environment.
    ground: Set by set_ground.
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
    """The contract's LogEntry.

    revision: At least 0.
    kind: `join` and `replay` belong to the undo step of the entry before.
    step: Number of the step whose commands these are: the revision that made it first. An `amend` leaves it to the
        step that it changes and to those that it replays. 0 of undo, redo and revert. At least 0.
    touched: At least 0.
    in_effect: Whether its commands are among those that lead to the present: they can be amended.
    author: The `Pelage-Author` of the request that made it; empty where none was named.
    commands: The commands as they were resolved.
    """

    commands: Union[Dict[str, Any], Sequence[Any]]


class Log(TypedDict):
    """The contract's Log."""

    entries: Sequence[LogEntry]


class SceneEvent(TypedDict):
    """What a scene is when its news begin and when its mesh is another.

    revision: At least 0.
    first_revision: At which the model came; the log has those after it. At least 0.
    undo_steps: At least 0.
    redo_steps: At least 0.
    model_id: As in `Scene`.
    """

    revision: int
    first_revision: int
    undo_steps: int
    redo_steps: int
    model_id: str


class ChangeEvent(TypedDict):
    """One line of the log without its commands.

    revision: At least 0.
    kind: `join` and `replay` belong to the undo step of the entry before.
    argument: Of `undo` and `redo` the steps, of `revert` the revision that it goes back to; else 0. At least 0.
    author: As in `LogEntry`.
    ops: `op` of its commands, each once.
    touched: At least 0.
    undo_steps: That could be undone after it. At least 0.
    redo_steps: At least 0.
    """

    revision: int
    kind: Literal["do", "join", "undo", "redo", "revert", "replay"]
    argument: int
    author: str
    ops: Sequence[str]
    touched: int
    undo_steps: int
    redo_steps: int


class PickMiss(TypedDict):
    """The contract's PickMiss."""

    hit: Literal[False]


class PickHit(TypedDict):
    """The contract's PickHit.

    triangle: 0 to 4294967295.
    barycentric: Weights of the triangle's corners. 3 items.
    position: In the model's unit; within 1000000 sizes of the model's centre. 3 items.
    normal: 3 items.
    direction: Where the fur leans, a unit vector; 0 when it stands upright. 3 items.
    inclination: 0 upright, 1 lying. 0 to 1.000001.
    length: Sizes. At least 0.
    stretch: At least 0.
    painted: What is painted at a place. A colour is linear red, green and blue, and how much of the coat's colour it
        covers.
    """

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


class PaintedValues(TypedDict):
    """What is painted at a place. A colour is linear red, green and blue, and how much of the coat's colour it
    covers.

    density: Share of the coat's strands. 0 to 1.000001.
    width: Of the coat's strand widths. 0 to 4.000001.
    curl: Added to the coat's own. 0 to 1.000001.
    clump: Added to the coat's own. 0 to 1.000001.
    wetness: Added to the coat's own. 0 to 1.000001.
    bare: 1 where skin shows. 0 to 1.000001.
    mask: How much tools may change: 1 all, 0 nothing. 0 to 1.000001.
    root_colour: 4 items.
    tip_colour: 4 items.
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


class _ProblemDocumentRequired(TypedDict):
    type: str
    title: str
    status: int
    detail: str


class ProblemDocument(_ProblemDocumentRequired, total=False):
    """RFC 9457.

    type: `urn:pelage:problem:` and a name, or `about:blank` where the status says it all.
    status: 400 to 599.
    pointer: JSON pointer of the bad field; empty for the whole body.
    limit: The limit that was broken.
    nearest: The nearest known name to an unknown one.
    """

    pointer: str
    limit: str
    nearest: str


class FrameEstimate(TypedDict):
    """The contract's FrameEstimate.

    error: Mean FLIP where there is fur, against the reference: that of half of the frames. 0 to 1.
    error_safety: 95% of frames have at most `error` times it. At least 1.
    reference: The same fur and light in 1024 or fewer sorted shells.
    cost_ms: Drawing time, as of `budget_ms`, before the frame was drawn. At least 0.
    cost_safety: 95% of frames cost at most `cost_ms` times it. At least 1.
    correction: Measured over predicted cost of this scene's frames so far, which `cost_ms` has in it. It moves in
        steps, and only when it is off by more than 8%.
    end: Why the frame has its knobs. asked: the request named them. budget: better ones cost too much. error: the
        cheapest that keep the error. best: nothing better is known. cheapest: even the cheapest are over the budget.
    calibration: Name of what costs are estimated by; `defaults` until `pelage calibrate` has measured the machine.
    """

    error: float
    error_safety: float
    reference: Literal["sorted_shells"]
    cost_ms: float
    cost_safety: float
    correction: float
    end: Literal["asked", "budget", "error", "best", "cheapest"]
    calibration: str


class FrameCounters(TypedDict):
    """The contract's FrameCounters.

    passes: Programs put to use, one after another. At least 0.
    draws: Draw calls. At least 0.
    textures: Textures bound. At least 0.
    bytes: Sent to what draws for the frame, changes of fields included. At least 0.
    fragments: Runs of fragment shaders, but for the pass that writes the picture's pixels; samples that were drawn
        where the GL does not count runs. At least 0.
    objects: Buffers, textures, targets and programs that were made. At least 0.
    allocated: Bytes of storage that was asked for, without mip levels. At least 0.
    redrawn: Share of the picture that was drawn. Below 1 after a stroke, where the frame before showed the same view:
        the rest is kept. The picture has the same bits as if all of it had been drawn. 0 to 1.
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
    """The contract's TraceReport.

    passes: In this picture; 0 for shells. 0 to 65536.
    samples: Mean of a pixel. At least 0.
    noise: Estimated mean error of a shown channel. 0 to 1.
    strands: At least 0.
    end: Why it ended; none while it goes on.
    grow_ms: Growing and indexing strands. At least 0.
    trace_ms: At least 0.
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

    seconds: Half of such frames are done by then. At least 0.
    safety: 95% of such frames are done after `seconds` times it. At least 1.
    """

    seconds: float
    safety: float


class FrameProgress(TypedDict):
    """The contract's FrameProgress.

    view: Of its request.
    width: Pixels. 1 to 8192.
    height: Pixels. 1 to 8192.
    share: Of the expected drawing time that has passed, at most 0.99; 0 while it waits. 0 to 1.
    seconds: Since it was asked for. At least 0.
    expected_seconds: That drawing it takes. At least 0.
    """

    view: str
    width: int
    height: int
    share: float
    seconds: float
    expected_seconds: float


class FrameProgressList(TypedDict):
    """The contract's FrameProgressList.

    frames: In the order that they were asked for.
    """

    frames: Sequence[FrameProgress]


Camera = Union[AutoCamera, PinholeCamera]
Command = Union[
    Comb, Blow, Attract, Interpolate, Flow, Smooth, Noise, Unify, Part, Whorl, Length, Trim, Lift, Erase, Clump, Curl,
    Paint, Mask, Map, Retarget, SetBlowers, SetAttractors, SetSymmetry, Checkpoint, ChangeEditLayer, SetCoat, SetLook,
    SetLights, SetEnvironment, SetGround, SetEyes, SetCurves, SetSkin, SetSkinTexture
]
Pick = Union[PickMiss, PickHit]
