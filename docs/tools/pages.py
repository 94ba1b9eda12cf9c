"""Content of the pages of the tools: a title, text, the schemas whose members are listed, and a camera."""

SIDE = ["--position=-1.45,0.75,-0.02", "--target=0,0.5,-0.02"]
ABOVE = ["--position=-0.35,1.75,-0.95", "--target=0,0.5,-0.1"]
SPINE = ["--position=0,1.95,-0.5", "--target=0,0.5,-0.03"]


def page(title, words, *schemas, camera=SIDE, builtin="creature", source=None, picture=None):
    """`source` is the recipe of another scene, whose id the example takes as its variable `source`; `picture` is a file
    of docs/tools/examples that the recipe names and that has to be uploaded before it."""
    return {"title": title, "words": words, "schemas": schemas, "camera": camera, "builtin": builtin, "source": source,
            "picture": picture}


PAGES = {
    "comb": page("Comb", """
Turns fur in the direction in which the brush moves. The stroke is cut into dabs, one for each spacing x radius of its length, so neither the
sampling rate of a pointer nor the parts that a stroke was sent in matter. A dab of weight *w* moves the direction *V* to
*V + w (lean t - V)*, where *t* is its motion in the tangent plane and *w = 1 - (1 - strength x falloff x pressure)^(step /
radius)*. `keep_inclination` turns the heading alone. As a flood it combs the whole model along `direction`. Inverted it combs
in the opposite direction.""", "Comb"),
    "blow": page("Blow", """
Wind from a point. Inside the cone fur turns away from the source; the edge of the cone is soft, and with `fall` the wind
loses strength with the distance *d* as *1 / (1 + (d / fall)^2)*. A stroke restricts it to what its brush covers. Inverted it
sucks. A wind that stays has a name: see [named winds and sticks](named_winds.md).""", "Blow"),
    "attract": page("Attract", """
A stick that pulls fur to it (fur modelling 5.2). The part of the pull across the strand turns it, the part along it builds up
in the field `stretch` over `duration`; what goes over `threshold` lengthens the strand, up to `max_stretch` times its length
before any stretch. Beyond `radius` nothing is pulled. Inverted it pushes away.""", "Attract"),
    "interpolate": page("Interpolate", """
Keys say what fur is like at a few positions, and Gaussian weights of the distance along the surface spread them (fur modelling
5.1). A key holds a direction, a length or both. What no key reaches keeps its value. Below: fur that stands up at the
shoulder, lies forward and short on the flank, and hangs down at the haunch.""", "Interpolate", "Key"),
    "flow": page("Flow", """
Lays the fur of the whole body along curves that are drawn on it, from the first point of each to the last. Each vertex takes
the directions of the curves near it, with Gaussian weights of the distance along the surface. The quickest first
groom: one curve from the nose to the tail, one down each leg.""", "Flow"),
    "smooth": page("Smooth", """
Blends each value with the mean of its neighbours, nearer ones counting more: *V' = (1 - t) V + t sum w V_j*, for `passes`
times. `keep_inclination` smooths headings alone, so that no tuft rises between opposite directions. Below: 100 passes over
fur that noise has tangled.""", "Smooth"),
    "noise": page("Noise", """
Adds random numbers that are a pure function of the seed and of the position. With a `feature_size` neighbours move together and
locks form; without one every vertex moves for itself. Directions are changed in inclinations, length and width by a share of
their value, other fields by the amount itself.""", "Noise"),
    "unify": page("Unify", """
Blends what is under the brush to one value, or with `mean` to the mean of what is there. Below: tangled fur, made to hang
straight down in the middle of the flank.""", "Unify"),
    "part": page("Part", """
The stroke is a line, and fur leans away from it on both sides. Inverted fur leans to it, and a crest stands.""", "Part",
                 camera=ABOVE),
    "whorl": page("Whorl", """
Turns fur round the nearest point of the stroke. One sample makes a whorl, the cowlick of a forehead or a hip; a line makes
two currents that pass each other. `turn_degrees` is the angle from outwards, counter-clockwise seen from outside: at 0 fur
points out, at 90 it circles, at 180 it points in. Inverted it turns in the opposite direction. Below: a whorl on the flank.""", "Whorl"),
    "length": page("Length", """
Sets, adds, scales, averages, jitters or bounds the length of fur. Lengths are shares of the model's size, or its own unit
with `units`. Inverted it subtracts, and divides in place of scaling.""", "Length"),
    "trim": page("Trim", """
Cuts fur where the curve of a strand, as it leans, intersects a plane or a sphere, or at a height over the skin. Below: long
fur on the flank, cut to a height of 0.012 sizes. Nothing grows: fur that ends before the cut stays as it is.""", "Trim", "TrimPlane", "TrimSphere"),
    "lift": page("Lift", """
Raises fur that lies; inverted it lays it down. It keeps the heading: fur that stands upright has none and stays.""", "Lift"),
    "erase": page("Erase", """
Takes fields back to the first groom, to a [checkpoint](checkpoint.md) or to a revision of this model, as far as the brush
reaches; with an [edit layer](edit_layer.md) and neither of them, takes away what the layer adds. The mask stays unless it is named. Below: tangled fur, taken back to the first groom on the flank.""", "Erase"),
    "clump": page("Clump", """
Turns fur to the line of the stroke and raises the field `clump`, which gathers tips to locks. Inverted it opens them.
Below: five strokes down the flank.""", "Clump"),
    "curl": page("Curl", """
Raises the field `curl` and turns the heading by `turn_degrees`, counter-clockwise seen from outside. Inverted it takes the
curl out and turns back.""", "Curl"),
    "paint": page("Paint", """
Paints a field: density, width, curl, clump, wetness, stiffness in the wind, bare, mask, or the colour of roots or tips, which covers the coat's own
by `value`. Inverted it takes the field back to its default. Below, from the shoulder to the haunch: a wet patch, a dark spot, and a
thin patch.""", "Paint"),
    "mask": page("Mask", """
The mask says how much every tool may change: all where it is 1, nothing where it is 0. It starts at 1 everywhere. Select
takes everything, vertices, a box, a sphere, a connected part or an uploaded picture ([maps](../maps.md)), and combines it with
the mask that is there; grow, shrink, smooth and invert change it; [paint](paint.md) brushes it. Below: a band of the body is
chosen, its edge smoothed, and the fur made three times as long; `{"op": "mask"}` ends with everything chosen.""", "Mask",
                 "MaskBox", "MaskSphere", "MaskPart", "MaskMaterial", "MaskPicture"),
    "map": page("Map", """
Reads a field from an uploaded picture through the model's own texture coordinates. `PUT .../maps/{field}` and `pelage map put`
upload a picture and run this command, and `pelage map get` writes one; [maps](../maps.md) has the files and their encodings. The
log names the picture by its pixels, and the server keeps it as long as the log does. Below: a checked picture makes the fur
of a ring long and short.""", "Map", camera=["--camera", "three_quarter"], builtin="torus", picture="map.png"),
    "symmetry": page("Symmetry", """
From `set_symmetry` on each tool with a position works on all images of it too, as one undo step: mirrored in up to three planes
and their combinations, or turned about an axis. Positions on the surface are mirrored to the nearest ones, so a roughly
symmetric model will do. Where images overlap, each counts by what it changes there: a stroke on the plane does what it does
without. Floods have no images. A brush with a `symmetry` of its own takes that in place of the scene's, so that a client can
mirror strokes without a step for it. Below: two trims on one side, seen from above.""", "SetSymmetry",
                     "Symmetry", "Plane", camera=SPINE),
    "named_winds": page("Named winds and sticks", """
A wind or a stick that stays in the scene under a name. `blow` and `attract` name it and then use its settings, as often as
wanted and under any brush; `set_blowers` and `set_attractors` replace the whole list, and are in the log like any command.
Below: a wind from below that brushes over the shoulder, and a stick over the haunch.""", "SetBlowers", "NamedBlower",
                        "SetAttractors", "NamedAttractor"),
    "checkpoint": page("Checkpoint", """
Gives a revision a name, for [erase](erase.md) to go back to. A name that is known moves. Below: fur is brushed and the
revision named, then noise tangles it, and a brush takes the flank back to what was named. A dry run of a whole recipe cannot
go back to a checkpoint that the recipe itself makes.""", "Checkpoint"),
    "edit_layer": page("Edit layers", """
An edit layer keeps changes apart from the groom below. A tool that names its `edit_layer` works on what is seen, and the layer
takes what makes the rest add up to that. What is seen is the groom and, from the lowest layer up, weight times what each
adds, held in each field's range, so the order of edit layers matters only where a range ends. The mask lies outside of edit layers.
`set` weighs (half, twice, the opposite), mutes and renames, `move` reorders, `merge_down` merges into the layer below or the
groom (what is seen stays, but where a range ended between the two), `remove` takes a layer away, [erase](erase.md) with a layer takes away what it adds under the brush. Below: a ruff,
combing and spots in three edit layers; after, the ruff at weight -.6, the combing at -1 and the spots at one half.""", "ChangeEditLayer"),
    "retarget": page("Retarget", """
Takes the fields of another scene's model, or of this one at an earlier revision, from the nearest points of its surface, as
[retarget](../retarget.md) says. It is one undo step; the revision that was taken is in the log. Below: plain fur takes the
groom of `clients/recipes/creature.json`, which stands in another scene.""", "Retarget", source="creature"),
}

# Recipes of clients/recipes and the models that they are for; those with a file need the shared models.
GROOMS = {
    "creature": {"camera": ["--camera", "three_quarter"]},
    "koala": {"file": "koala.ply", "options": [], "camera": ["--camera", "three_quarter"]},
    "spot": {"file": "spot.obj", "options": ["--front=-z"], "camera": ["--camera", "three_quarter"]},
}
