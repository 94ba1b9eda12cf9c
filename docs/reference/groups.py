"""Groups of commands for the sidebar and the first page. A command that is in no group fails the build."""

GROUPS = {
    "Direction": ["comb", "blow", "attract", "interpolate", "flow", "smooth", "noise", "unify", "part", "whorl", "lift"],
    "Length and form": ["length", "trim", "clump", "curl"],
    "Fields and mask": ["paint", "mask", "map", "erase", "retarget"],
    "Scene": ["checkpoint", "edit_layer", "set_symmetry", "set_blowers", "set_attractors"],
    "Coat, body and light": ["set_coats", "set_coat", "set_look", "set_lights", "set_environment", "set_ground", "set_wind", "set_eyes", "set_curves", "set_skin",
                             "set_skin_texture"],
}
# What the words of the unit column mean, for the first page; units such as degrees need no explanation.
UNITS = {
    "sizes": "Fractions of the diagonal of the model's box.",
    "model units": "The model's own coordinates, right-handed with Y up.",
    "as `units`": "What the member `units` beside it says: sizes, the model's unit or pixels.",
    "share": "A number from 0, nothing, to 1, all.",
    "factor": "A number that another one is multiplied by.",
    "varies": "The meaning says it.",
}
