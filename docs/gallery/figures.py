"""Figures of the gallery. Each of their pictures is a model, its fur, commands and a frame request."""

import json
import pathlib

LOOKS = pathlib.Path(__file__).resolve().parents[2] / "clients" / "looks"

STUDIO = [{"op": "set_ground", "ground": {"visible": True}},
          {"op": "set_environment", "environment": {"sky": [1, 1, 1], "horizon": [0.8, 0.82, 0.85],
                                                    "ground": [0.5, 0.48, 0.45], "intensity": 1.2}}]
# A warm key from above, a cool fill from the front and a little rim, as in the reference pictures.
REFERENCE_LIGHT = [
    {"op": "set_environment", "environment": {"sky": [1, 1, 1], "horizon": [0.8, 0.82, 0.85], "ground": [0.45, 0.44, 0.43],
                                              "intensity": 0.9}},
    {"op": "set_lights", "lights": [
        {"direction": [0.2, -0.9, 0.35], "colour": [1, 0.96, 0.9], "intensity": 1.7, "cast_shadow": "penumbra"},
        {"direction": [-0.7, -0.3, -0.6], "colour": [0.85, 0.92, 1], "intensity": 0.45, "cast_shadow": "penumbra"},
        {"direction": [0.6, -0.4, 0.5], "colour": [1, 0.98, 0.95], "intensity": 0.25, "cast_shadow": "penumbra"}]}]
ONE_LIGHT = {"direction": [-0.5, -0.8, -0.45], "intensity": 1.7}


def builtin(name, triangles=5000):
    return {"builtin": name, "triangles": triangles}


def glmark(name):
    options = {"horse": "3ds", "cat": "3ds", "bunny": "obj"}
    turned = {"horse": {"up": "y", "front": "z"}, "cat": {"up": "y", "front": "z"}, "bunny": {}}
    return {"file": f"/usr/share/glmark2/models/{name}.{options[name]}", "options": {"format": options[name], **turned[name]}}


def fur(length, inclination):
    return {"length": length, "inclination": inclination}


SHARED = pathlib.Path(__file__).resolve().parents[3] / "shared" / "meshes"


def shared(name, **options):
    return {"file": str(SHARED / name), "options": {"format": name.split(".")[-1], **options}}


def shells(**settings):
    """The quality of a frame drawn as shells, the method of the papers, which needs a GL."""
    return {"method": "shells", "scale": 1.5, "shells": {"count": 24, **settings}}


MAPS = {"shadow_maps": True, "shadow_resolution": 1024}


def picture(title, model, *steps, fur_of=None, quality="detailed", camera=None, **frame):
    request = {"quality": quality, **({"camera": camera} if camera else {}), **frame}
    return {"title": title, "model": model, "fur": fur_of or {}, "steps": [s for s in steps if s], "frame": request}


def coat(**settings):
    return {"op": "set_coat", "coat": settings}


def look(**settings):
    return {"op": "set_look", "look": settings}


def lights(*members):
    return {"op": "set_lights", "lights": list(members)}


def look_file(name):
    return json.loads((LOOKS / f"{name}.json").read_text(encoding="utf-8"))


def studio(*commands):
    return {"commands": [*STUDIO, *commands]}


def eye(position, target, fov=35):
    return {"position": position, "target": target, "fov_degrees": fov}


TORUS, KNOT = builtin("torus", 2000), builtin("knot", 2880)
CREATURE = builtin("creature", 20000)
PLANE = builtin("plane", 400)
CLOSE = eye([0.0, 0.55, 0.75], [0.0, 0.0, 0.0], 25)
FACE = eye([-0.75, 1.1, 1.9], [0.0, 0.86, 0.42], 19)
BACK = eye([-2.3, 1.5, 0.2], [0.0, 0.72, -0.3], 26)
PULL = {"op": "attract", "point": [-0.15, 1.1, -0.25], "radius": 0.35, "strength": 1, "duration": 10, "threshold": 0}
EAR = eye([-0.35, 2.3, 1.9], [0.05, 0.9, 0.12], 17)

PAINTED_CREATURE = builtin("creature", 40000)
FLANK = eye([-2.3, 1.35, 0.75], [0.0, 0.6, -0.1], 27)
NEAR = eye([0.0, 0.42, 0.5], [0.0, 0.0, 0.02], 24)


def dabbed(field, value, radius, *pixels, falloff="smooth", **settings):
    """One stroke of paint over pixels of the picture from the camera FLANK."""
    return {"op": "paint", "field": field, "value": value, **settings,
            "brush": {"radius": radius, "strength": 1, "falloff": falloff, "falloff_shape": "surface"},
            "stroke": {"view": {"camera": FLANK, "width": 420, "height": 420},
                       "samples": [{"screen": list(pixel), "time": i} for i, pixel in enumerate(pixels)]}}


def half(field, value):
    return {"op": "paint", "field": field, "value": value, "brush": {"radius": 0.36, "strength": 1, "falloff": "constant"},
            "stroke": {"samples": [{"position": [0.5, 0, z], "time": z + 1} for z in (-1, 1)]}}


SPOTS = [dabbed(field, 1, radius, position, colour=colour)
         for position, radius in (((150, 215), 0.045), ((185, 240), 0.05), ((195, 205), 0.03), ((230, 215), 0.05), ((160, 255), 0.035),
                               ((258, 240), 0.04), ((275, 205), 0.04))
         for field, colour in (("root_colour", "#241a14"), ("tip_colour", "#3a2417"))]
PATCHES = [dabbed("density", 0.04, 0.07, (140, 290), (165, 300), falloff="sphere"), dabbed("bare", 1, 0.1, (222, 268), falloff="sphere"),
           dabbed("wetness", 1, 0.09, (300, 170), (320, 240))]


FIGURES = [
    {"name": "per_pixel", "title": "Light at the vertices, light in each pixel (GPU fur, figure 1)",
     "text": "With shells, `lengyel`, the paper's baseline, lights only vertices, so its strands have no shaded side.",
     "pictures": [picture(name, TORUS, look(shading=name), fur_of=fur(0.05, 0.5), quality=shells())
                  for name in ("lengyel", "kajiya")]},
    {"name": "lodged", "title": "Lodged fur, and a pattern (GPU fur, figure 2)",
     "text": "`lodge` presses patches of strands to one side. The zebra's stripes need no texture coordinates.",
     "pictures": [picture("lodged", TORUS, coat(lodge=0.5), fur_of=fur(0.05, 0.4)),
                  picture("zebra", glmark("horse"), look_file("zebra"), studio(), fur_of=fur(0.012, 0.85))]},
    {"name": "single_hairs", "title": "Shadows of single hairs (GPU fur, figure 6)",
     "text": "Sparse fur on a plane. The shadow maps of the shells hold each strand.",
     "pictures": [picture(title, PLANE, coat(count=250, clump=0, width_root=0.002, width_tip=0.001, tile=0.2),
                          look(ambient=0.3, skin=[0.75, 0.7, 0.62]), lights({**ONE_LIGHT, "self_shadow_maps": maps}),
                          fur_of=fur(0.05, 0.35), camera=CLOSE, quality=shells(shadow_maps=maps, shadow_resolution=2048))
                  for title, maps in (("without", False), ("with shadow maps", True))]},
    {"name": "self_shadow", "title": "Self-shadow (GPU fur, figure 7)",
     "text": "In shells: none, the estimate `self_shadow`, and `shadow_maps`.",
     "pictures": [picture(title, KNOT, lights({**ONE_LIGHT, "self_shadow_maps": maps}), fur_of=fur(0.03, 0.5),
                          quality=shells(self_shadow=shadow, **(MAPS if maps else {})))
                  for title, shadow, maps in (("none", False, False), ("estimate", True, False), ("maps", True, True))]},
    {"name": "cast_shadow", "title": "Shadow of the body on itself (GPU fur, figure 8)",
     "text": "In shells: `cast_shadow` of a light 8 degrees wide. `soft` is the paper's shadow width; `penumbra` is closest "
             "to traced strands.",
     "pictures": [picture(kind, KNOT, lights({**ONE_LIGHT, "direction": [-0.1, -1, -0.2], "angle_degrees": 8, "cast_shadow": kind}),
                          fur_of=fur(0.015, 0.6), quality=shells(**MAPS)) for kind in ("none", "hard", "soft", "penumbra")]},
    {"name": "curves", "title": "Two lean curves (fur modelling, 5.1)",
     "text": "The arc, and y = K sqrt(x), whose tail keeps rising when the lean is strong.",
     "pictures": [picture(f"{curve}, inclination {lean}", TORUS, coat(lean_curve=curve, root_share=0.0),
                          fur_of=fur(0.08, lean))
                  for lean in (0.35, 0.95) for curve in ("arc", "root")]},
    {"name": "fields", "title": "Fields over the picture",
     "text": "Overlays: direction as hue, direction as short lines, length.",
     "pictures": [picture(title, CREATURE, studio(), overlay=overlay)
                  for title, overlay in (("direction", "direction"), ("short lines", "strokes"), ("length", "length"))]},
    {"name": "attract", "title": "A stick that pulls (fur modelling)",
     "text": "[attract](tools/attract.md) for ten seconds, as fur and as short lines. Fur turns to the stick and grows, up to "
             "three times.",
     "pictures": [picture(f"{title}, {kind}", CREATURE, studio(), tool, camera=BACK, overlay=overlay)
                  for kind, overlay in (("fur", "none"), ("short lines", "strokes"))
                  for title, tool in (("before", None), ("after", PULL))]},
    {"name": "difference", "title": "What a step has changed",
     "text": "The overlay `difference` ([history](history.md)): grey where nothing has changed, yellow where most has.",
     "pictures": [picture(title, CREATURE, studio(), tool, camera=BACK, **overlay)
                  for title, tool, overlay in (("before", None, {}), ("after", PULL, {}),
                                               ("difference", PULL, {"overlay": "difference", "overlay_from": 1}))]},
    {"name": "painted", "title": "Painted fields",
     "text": "Spots in two colours, a thinned, a bare and a wet patch, painted with [paint](tools/paint.md); two overlays; and "
             "four fields in close-up, each on half of a plane.",
     "pictures": [*(picture(title, PAINTED_CREATURE, studio(*commands), camera=FLANK, overlay=overlay)
                    for title, commands, overlay in (("before", [], "none"), ("spots", SPOTS, "none"),
                                                     ("thinned, bare and wet", [*SPOTS, *PATCHES], "none"),
                                                     ("density", [*SPOTS, *PATCHES], "density"), ("wetness", [*SPOTS, *PATCHES], "wetness"))),
                  *(picture(title, builtin("plane", 8000), studio(), half(field, value), fur_of=fur(0.035, 0.45), camera=NEAR)
                    for title, field, value in (("half the strands", "density", 0.5), ("wet", "wetness", 1), ("clump", "clump", 0.8),
                                                ("curl", "curl", 0.06)))]},
    {"name": "stages", "title": "From shells to fur",
     "text": "The method `shells`: more shells give firmer fur. `adaptive` takes only as many as each position needs.",
     "pictures": [picture(title, CREATURE, studio(), quality=shells(count=count, policy=policy))
                  for title, count, policy in (("4 shells", 4, "uniform"), ("8 shells", 8, "uniform"), ("16 shells", 16, "uniform"),
                                               ("adaptive, up to 32", 32, "adaptive"))]},
    {"name": "tufts", "title": "Tufts",
     "text": "Clumps larger than the tile, anchored on the body.",
     "pictures": [picture(title, CREATURE, coat(tufts={"gather": gather, "size": size}), studio())
                  for title, gather, size in (("none", 0, 0.05), ("gather .4", 0.4, 0.05), ("gather 1, small", 1, 0.04))]},
    {"name": "forms", "title": "Forms of fur",
     "text": "One coat on one sphere, a [setting](fur.md#coat) at a time.",
     "pictures": [picture(name, builtin("sphere", 3000), coat(**settings), fur_of=fur(0.05, 0.45),
                          camera=eye([0.9, 1.4, 3.4], [0.25, 0.35, 0.5], 22))
                  for name, settings in (("straight", {"bend": 0, "clump": 0}), ("bent", {"bend": 1.2, "clump": 0}),
                                         ("wavy", {"wave": 0.08, "wave_turns": 3}),
                                         ("curly", {"curl": 0.12, "curl_turns": 4, "curl_together": 0.8}),
                                         ("messy", {"mess": 0.8, "clump": 0.1}), ("clumped", {"clump": 0.95, "clump_size": 0.02}),
                                         ("wet", {"wetness": 1, "clump": 0.8, "fine_clump": 0.8}), ("lodged", {"lodge": 0.5}),
                                         ("undercoat", {"undercoat": {"share": 0.6, "length": 0.45, "tint": 0.8,
                                                                      "colour": [0.7, 0.62, 0.5]}}))]},
    {"name": "looks", "title": "Looks to start from",
     "text": "The files of `clients/looks`.",
     "pictures": [picture(name.replace("_", " "), model, look_file(name), studio(), fur_of=fur(length, lean))
                  for name, model, length, lean in (("shorthair_cat", glmark("cat"), 0.018, 0.75),
                                                    ("rabbit", glmark("bunny"), 0.035, 0.5), ("fox", CREATURE, 0.042, 0.72),
                                                    ("sheep", CREATURE, 0.035, 0.2), ("wet_dog", CREATURE, 0.04, 0.75),
                                                    ("bear", CREATURE, 0.055, 0.6), ("zebra", glmark("horse"), 0.012, 0.85),
                                                    ("leopard", glmark("cat"), 0.016, 0.8),
                                                    ("toy_plush", glmark("bunny"), 0.022, 0.3))]},
    {"name": "shading", "title": "Shading models",
     "text": "`shading` of `set_look`.",
     "pictures": [picture(name, CREATURE, look(shading=name), studio())
                  for name in ("lengyel", "kajiya", "kajiya_kay", "scheuermann", "marschner", "energy_conserving")]},
    {"name": "eye", "title": "The eye",
     "text": "Cornea, iris, lids ([eyes](eyes.md)); bare skin, whiskers and lashes around it.",
     "pictures": [picture("face", CREATURE, studio(), camera=FACE)]},
    {"name": "special", "title": "Hard cases",
     "text": "A sleek horse, white fur lit from behind, an agouti fox, an ear in front of the flank, a parting.",
     "pictures": [picture("sleek horse", glmark("horse"),
                          coat(root_share=0.6, clump=0.2, clump_size=0.008,
                               ramp=[{"at": 0, "colour": "#4a2c1a"}, {"at": 0.6, "colour": "#8a5530"}, {"at": 1, "colour": "#a8703f"}]),
                          look(shading="energy_conserving"), studio(), fur_of=fur(0.012, 0.9)),
                  picture("white, lit from behind", glmark("bunny"), look_file("rabbit"),
                          studio(lights({"direction": [0.2, -0.35, 0.9], "intensity": 2.2}, {"direction": [-0.5, -0.6, -0.5], "intensity": 0.35})),
                          fur_of=fur(0.045, 0.45), background="#30343a"),
                  picture("agouti fox", CREATURE,
                          coat(ramp=[{"at": 0, "colour": "#4a4038"}, {"at": 0.45, "colour": "#8f5a2c"}, {"at": 0.75, "colour": "#e0b070"},
                                     {"at": 1, "colour": "#2a1a10"}], ticking={"share": 0.1, "colour": [0.8, 0.78, 0.72]}),
                          look(colour_source="coat"), studio(), fur_of=fur(0.042, 0.7)),
                  picture("ear in front of the flank", CREATURE, studio(), camera=EAR),
                  picture("parting", builtin("plane", 4000),
                          {"commands": [{"op": "comb", "brush": {"radius": 0.4, "strength": 1, "falloff": "constant"}, "lean": 0.8,
                                         "stroke": {"samples": [{"position": [side * 0.36, 0, z], "time": 0}, {"position": [side * 0.75, 0, z], "time": 1}]}}
                                        for side in (-1, 1) for z in (-0.4, 0, 0.4)]},
                          fur_of=fur(0.03, 0.3), camera=eye([0.05, 0.35, 0.75], [0, 0, 0.05], 30))]},
    {"name": "animals", "title": "Four animals",
     "text": "Four coats with the settings and light of reference pictures.",
     "pictures": [picture(f"{title}, {tier}", model, look(colour_source="coat", **shade), studio(*REFERENCE_LIGHT),
                          coat(length_spread=0.3, fine_clump_size=0.008, width_root=0.00044, width_tip=0.00015, **settings),
                          fur_of={**fur(length, lean), "form": "even"}, quality=tier)
                  for title, model, length, lean, settings, shade in (
                      ("plush", shared("koala_low.obj"), 0.042, 0.42,
                       {"count": 5700, "root_share": 0.15, "clump": 0.45, "clump_size": 0.02, "fine_clump": 0.6, "curl": 0.02,
                        "ramp": [{"at": 0, "colour": [0.30, 0.29, 0.28]}, {"at": 0.5, "colour": [0.50, 0.48, 0.46]}, {"at": 1, "colour": [0.72, 0.70, 0.67]}]},
                       {"specular": 0.1}),
                      ("agouti", shared("cat.obj", front="-x"), 0.036, 0.72,
                       {"count": 10500, "root_share": 0.45, "clump": 0.25, "clump_size": 0.02, "fine_clump": 0.4,
                        "ramp": [{"at": 0, "colour": [0.18, 0.12, 0.09]}, {"at": 0.5, "colour": [0.62, 0.24, 0.05]}, {"at": 1, "colour": [0.30, 0.12, 0.04]}]},
                       {"specular": 0.15, "diffuse": 0.65}),
                      ("sleek", shared("spot.obj", front="-z"), 0.018, 0.92,
                       {"count": 8400, "root_share": 0.6, "clump": 0.12, "clump_size": 0.025, "fine_clump": 0.35,
                        "ramp": [{"at": 0, "colour": [0.10, 0.045, 0.02]}, {"at": 0.5, "colour": [0.22, 0.09, 0.035]}, {"at": 1, "colour": [0.28, 0.13, 0.06]}]},
                       {"specular": 0.12}),
                      ("white", shared("koala_low.obj"), 0.042, 0.6,
                       {"count": 6900, "root_share": 0.4, "clump": 0.4, "clump_size": 0.02, "fine_clump": 0.6,
                        "ramp": [{"at": 0, "colour": [0.75, 0.72, 0.68]}, {"at": 0.5, "colour": [0.85, 0.83, 0.80]}, {"at": 1, "colour": [0.92, 0.91, 0.90]}]},
                       {"specular": 0.1}))
                  for tier in ("interactive", "detailed")]},
    {"name": "recipes", "title": "Four portraits",
     "text": "[Recipes](recipes.md#four-portraits) as traced strands: fur laid to the ends of limbs and ears, eyes, bare skin, "
             "markings.",
     "pictures": [picture(name.replace("_", " "), shared(model, **options), {"recipe": name}, quality="reference", background="studio")
                  for name, model, options in (("koala_plush", "koala_low.obj", {}), ("cat_fox", "cat.obj", {"front": "-x"}),
                                               ("spot_sleek", "spot.obj", {"front": "-z"}), ("koala_white", "koala_low.obj", {}))]},
    {"name": "methods", "title": "Shells beside strands",
     "text": "Six grooms in three qualities. [Strands](strands.md) explains the differences.",
     "pictures": [picture(f"{title}, {tier}", model, *steps, studio(), fur_of=fur(length, lean), quality=tier)
                  for title, model, length, lean, steps in (
                      ("creature", CREATURE, 0.03, 0.45, []),
                      ("wet", CREATURE, 0.035, 0.5, [look_file("wet_dog")]),
                      ("curly", builtin("creature", 12000), 0.03, 0.3, [look_file("sheep")]),
                      ("long", builtin("torus", 4000), 0.08, 0.65, [coat(clump=0.6, clump_size=0.02, root_share=0.4)]),
                      ("zebra", glmark("horse"), 0.012, 0.85, [look_file("zebra")]),
                      ("white", builtin("sphere", 4000), 0.04, 0.5,
                       [coat(ramp=[{"at": 0, "colour": [0.8, 0.78, 0.75]}, {"at": 1, "colour": [0.95, 0.94, 0.93]}])]))
                  for tier in ("interactive", "detailed", "reference")]},
    {"name": "close_strands", "title": "Close up",
     "text": "A twentieth of the body in two qualities.",
     "pictures": [picture(f"{title}, {tier}", CREATURE, studio(), camera=camera, quality=tier)
                  for title, camera in (("face", FACE), ("flank", eye([-1.6, 0.9, 0.6], [-0.2, 0.65, -0.1], 14)))
                  for tier in ("detailed", "reference")]},
    {"name": "transport", "title": "Light through fur",
     "text": "`transmittance` fades light with each strand that it crosses; `paths` follow it over up to 32 bounces.",
     "pictures": [picture(f"{title}, {transport}", builtin("sphere", 4000), coat(ramp=[{"at": 0, "colour": colour}], colour_spread=0.05), studio(),
                          fur_of=fur(0.05, 0.5), quality={"method": "strands", "trace": {"transport": transport, "passes": 48,
                                                                                        **({"bounces": 32} if transport == "paths" else {})}})
                  for title, colour in (("white", [0.85, 0.83, 0.8]), ("red", [0.5, 0.16, 0.05]), ("black", [0.02, 0.02, 0.022]))
                  for transport in ("transmittance", "paths")]},
    {"name": "lights", "title": "Lights with a size",
     "text": "A directional light of half angle 0 and 15 degrees, and a rectangle near the body, on traced strands.",
     "pictures": [picture(title, TORUS, lights(light), studio(), fur_of=fur(0.05, 0.5), quality="reference")
                  for title, light in (("0 degrees", {**ONE_LIGHT, "angle_degrees": 0}), ("15 degrees", {**ONE_LIGHT, "angle_degrees": 15}),
                                      ("rectangle", {"kind": "area", "position": [0.4, 0.9, 0.9], "direction": [-0.3, -0.7, -0.7],
                                                     "width": 0.6, "height": 0.6, "intensity": 0.5}))]},
    {"name": "passes", "title": "A progressive rendering, pass by pass",
     "text": "Pictures of fewer than 64 passes are filtered, except the last one here.",
     "pictures": [picture(title, CREATURE, studio(), quality={"method": "strands", "trace": trace})
                  for title, trace in (*((f"{n} passes", {"passes": n}) for n in (1, 4, 16, 64, 128)),
                                       ("16 passes, not filtered", {"passes": 16, "filter": False}))]},
]

# The sections of the page, each with the names of its figures.
SECTIONS = [("Animals", ["looks", "recipes", "animals", "special", "eye"]),
            ("Coats", ["forms", "tufts", "lodged"]),
            ("Grooming", ["painted", "attract", "fields", "difference"]),
            ("Light and shading", ["shading", "self_shadow", "cast_shadow", "single_hairs", "lights"]),
            ("Quality", ["stages", "methods", "close_strands", "passes", "transport"]),
            ("Figures of the papers", ["per_pixel", "curves"])]
