"""The tables of apply.py. A rule is (pattern, new, kinds, inside, outside): kinds are c code, s strings, m comments,
i includes, p prose of Markdown, d JSON, YAML and CSV. Rules run in their order."""

# Files, by path from the root. Also used for text: see TEXTS.
FILES = [
    (r"^renderer/image/octets\.", "renderer/image/bytes."),
    (r"^tests/unit/image/octets_test\.", "tests/unit/image/bytes_test."),
    (r"^renderer/strands/base_picture\.h$", "renderer/strands/backplate.h"),
    (r"^renderer/strands/choice\.", "renderer/strands/discrete_distribution."),
    (r"^renderer/passes/layers/layer_target\.", "renderer/passes/aovs/aov_target."),
    (r"^renderer/passes/layers/layers_pass\.", "renderer/passes/aovs/aovs_pass."),
    (r"^renderer/passes/layers/", "renderer/passes/aovs/"),
    (r"^renderer/shaders/layers\.glsl$", "renderer/shaders/aovs.glsl"),
    (r"^renderer/frame/draw_layers\.", "renderer/frame/draw_aovs."),
    (r"^renderer/frame/kept_views\.", "renderer/frame/view_cache."),
    (r"^renderer/visibility/layer_sets\.", "renderer/visibility/shell_lod."),
    (r"^server/fields/layer_stack\.", "server/fields/edit_layer_stack."),
    (r"^server/scene/refine\.", "server/scene/subdivide."),
    (r"^server/patches/refine_patches\.", "server/patches/subdivide_patches."),
    (r"^server/(\w+)/refine_patches\.", r"server/\1/subdivide_patches."),
    (r"^server/history/refinement_codec\.", "server/history/subdivision_codec."),
    (r"^clients/cli/refinement\.", "clients/cli/progressive."),
    (r"^docs/tools/(examples/)?layer(\.md|\.json|-\w+\.jpg)$", r"docs/tools/\1edit_layer\2"),
    (r"^docs/gallery/lamps-", "docs/gallery/lights-"),
    (r"^tests/bench/layers\.cpp$", "tests/bench/shell_lod.cpp"),
    (r"^tests/bench/refine_latency\.", "tests/bench/progressive_latency."),
    (r"^tests/end_to_end/test_base_picture\.", "tests/end_to_end/test_skin_texture."),
    (r"^tests/end_to_end/test_layers\.", "tests/end_to_end/test_edit_layers."),
    (r"^tests/end_to_end/test_refine\.", "tests/end_to_end/test_progressive."),
    (r"^tests/fuzz/corpus/base_picture\.", "tests/fuzz/corpus/skin_texture."),
    (r"^tests/gl/base_picture_test\.", "tests/gl/skin_texture_test."),
    (r"^tests/gl/kept_test\.", "tests/gl/view_cache_test."),
    (r"^tests/gl/layers_test\.", "tests/gl/aovs_test."),
    (r"^tests/unit/scene/base_picture_test\.", "tests/unit/scene/skin_texture_test."),
    (r"^tests/unit/scene/refine_test\.", "tests/unit/scene/subdivide_scene_test."),
    (r"^tests/unit/scene/scene_layers_test\.", "tests/unit/scene/scene_edit_layers_test."),
    (r"^tests/unit/upload/layer_sets_test\.", "tests/unit/upload/shell_lod_test."),
]

# Over whole texts: names of files in includes, in CMake and in links.
TEXTS = [
    (r"\brenderer/image/octets\b", "renderer/image/bytes"),
    (r"\brenderer/strands/base_picture\.h\b", "renderer/strands/backplate.h"),
    (r"\brenderer/strands/choice\b(?=\.|$|\s)", "renderer/strands/discrete_distribution"),
    (r"\bpasses/layers/layer_target\b", "passes/aovs/aov_target"),
    (r"\bpasses/layers/layers_pass\b", "passes/aovs/aovs_pass"),
    (r"\bpasses/layers\b", "passes/aovs"),
    (r"\brenderer_pass_layers\b", "renderer_pass_aovs"),
    (r"\badd_subdirectory\(layers\)", "add_subdirectory(aovs)", "csmpdi", r"^renderer/"),
    (r"(?<![\w_])layers\.glsl\b", "aovs.glsl"),
    (r"\bframe/draw_layers\b", "frame/draw_aovs"),
    (r"\bdraw_layers\.cpp\b", "draw_aovs.cpp"),
    (r"\bframe/kept_views\b", "frame/view_cache"),
    (r"\bkept_views\.(cpp|h)\b", r"view_cache.\1"),
    (r"\bvisibility/layer_sets\b", "visibility/shell_lod"),
    (r"\bupload/layer_sets\b", "upload/shell_lod"),
    (r"\bfields/layer_stack\b", "fields/edit_layer_stack"),
    (r"\bscene/refine\.(h|cpp)\b", r"scene/subdivide.\1"),
    (r"\brefine_patches\.(h|cpp)\b", r"subdivide_patches.\1"),
    (r"\brefinement_codec\.(h|cpp)\b", r"subdivision_codec.\1"),
    (r"\bclients/cli/refinement\b", "clients/cli/progressive"),
    (r"(?<=[(/\"'])layer\.md\b", "edit_layer.md"),
    (r"(?<=[(/\"'])layer(-before|-after)?\.jpg\b", r"edit_layer\1.jpg"),
    (r"\bexamples/layer\.json\b", "examples/edit_layer.json"),
    (r"\bgallery/lamps-", "gallery/lights-"),
    (r"\bbench_layers\b", "bench_shell_lod"),
    (r"\bbench_shell_lod layers\.cpp\b", "bench_shell_lod shell_lod.cpp"),
    (r"\bbench/layers\.cpp\b", "bench/shell_lod.cpp"),
    (r"\brefine_latency\b", "progressive_latency"),
    (r"\btest_base_picture\b(?=\.py|$)", "test_skin_texture"),
    (r"\bcorpus/base_picture\b", "corpus/skin_texture"),
]

GL = r"\.(glsl|frag|vert)$"
AOV_FOLDERS = (r"^(renderer/(frame|image|passes/aovs|strands|passes/draw)/|renderer/shaders/aovs|server/frames/|tests/gl/(aovs|traced|fins|paint|sorted)|"
               r"tests/unit/(strands|image)/|tests/extremes/|tests/bench/(traced|cost|measure|dial|methods|converged))")
EDIT_FOLDERS = r"^(server/(fields|groom|scene|history|maps|http|import)/|tests/unit/(fields|scene|groom|history)/|tests/property/(groom|scene)/|docs/tools/|docs/(grooming|history|retarget|maps|recipes|service)\.md|clients/cli/|clients/recipes|tests/soak)"


def words():
    """Whole identifiers, the same in every file and region."""
    table = {}

    def add(text):
        for line in text.strip().splitlines():
            old, new = line.split()
            table[old] = new

    # AOVs
    add("""
FrameLayer Aov
LayerTarget AovTarget
LayersPass AovsPass
draw_layers draw_aovs
draw_layer draw_aov
write_layers write_aovs
write_eye_layers write_eye_aovs
add_layers add_aovs
layer_position aov_position
layer_normal aov_normal
layer_tangent aov_tangent
layer_albedo aov_albedo
layer_direct aov_direct
layer_light aov_light
LAYERS AOVS
layers_pass aovs_pass
layer_target aov_target
traced_layers traced_aovs
encode_layers encode_aovs
names_layers names_aovs
frame_layers aovs
layer_pixels aov_pixels
layers_of aovs_of
all_layers all_aovs
layer_names aov_names
places_in_layer places_of_aov
layer_at aov_at
layers_before aovs_before
""")
    # Shells
    add("""
shadow_layers shadow_shells
layer_depth shell_depth
layers_are_learnt shells_are_learnt
most_layers max_depth_complexity
full_layers full_shells
layer_maps shell_maps
layers_runs shell_lod_runs
send_layers send_images
layer_sets shell_lods
layer_set shell_lod
most_layer_sets max_shell_lods
layer_level shell_lod_level
LayerView ShellView
LayerMesh ShellMesh
LayerLists ShellLists
LayerVertex ShellVertex
LayerSets ShellLods
LayerMapsHoldTheOpticalDepthOfTheFur ShellMapsHoldTheOpticalDepthOfTheFur
LayerMapsAgreeWithTheEstimateOnAPlane ShellMapsAgreeWithTheEstimateOnAPlane
LayersLetThroughWhatTheirMapsSay ShellsTransmitWhatTheirMapsSay
LayersLetThrough ShellsTransmit
LayerCountKeepsTheOpacity ShellCountKeepsTheOpacity
MoreLayersComeCloser MoreShellsComeCloser
MoreLayersTowardsTheOutline MoreShellsTowardsTheSilhouette
FewerLayersWhereTheViewNeedsFewerKeepTheOpacity FewerShellsWhereTheViewNeedsFewerKeepTheOpacity
IsWhatLayersAreOnOneConvexPieceSeenHeadOn IsWhatShellsAreOnOneConvexPieceSeenHeadOn
LayersOfWhatIsNearLieOverThoseOfWhatIsFar ShellsOfWhatIsNearLieOverThoseOfWhatIsFar
LayersAndMixedTypesInOneFile AovsAndMixedTypesInOneFile
PlainColourGoesBeforeALayer PlainColourGoesBeforeAnAov
LayersTogetherHaveALimit AovsTogetherHaveALimit
LayersOfAPixelThatIsHalfCovered AovsOfAPixelThatIsHalfCovered
IsAtMostOneUnlessTheKnobIsLarger IsAtMostOneUnlessTheKnobIsLarger
""")
    # Edit layers
    add("""
LayerAction EditLayerAction
ChangeLayer ChangeEditLayer
LayerStack EditLayerStack
layer_stack edit_layer_stack
layer_actions edit_layer_actions
change_layers change_edit_layers
kept_in_layer stored_in_edit_layer
any_layer_has any_edit_layer_has
RefinedLayers SubdividedEditLayers
erase_layer erase_edit_layer
erases_layer erases_edit_layer
first_layer first_edit_layer
layer_weight edit_layer_weight
agree_with_layer agree_with_edit_layer
layer_change edit_layer_change
SceneLayersTest SceneEditLayersTest
test_layers_agree_with_a_pick test_aovs_agree_with_a_pick
test_a_layer_shows_by_its_weight test_an_edit_layer_shows_by_its_weight
test_the_client_shows_layers_and_warnings test_the_client_shows_edit_layers_and_warnings
""")
    # The two base pictures
    add("""
SetBasePicture SetSkinTexture
set_base_picture set_skin_texture
uploadBasePicture uploadSkinTexture
lay_base_picture lay_skin_texture
load_base_picture load_skin_texture
check_base_picture check_skin_texture
read_base_picture read_skin_texture
BasePictureTest SkinTextureTest
BasePicture Backplate
base_pictures backplate_images
BasePoint BackplatePixel
draw_base draw_backplate
read_base read_backplate
light_base light_backplate
base_at backplate_at
most_base_pixels max_backplate_pixels
ABasePictureOfAnything ABackplateOfAnything
""")
    # The two refines
    add("""
follow_refinement follow_progressive
Refinement ProgressivePicture
test_a_refinement_starts_again_where_it_was_dropped test_progressive_rendering_starts_again_where_it_was_dropped
test_grooming_goes_on_beside_a_refinement test_grooming_goes_on_beside_progressive_rendering
RefineIsASwitchOrHowToTrace ProgressiveIsASwitchOrHowToTrace
PassesOfARefinementRise PassesOfAProgressivePictureRise
ANewRevisionEndsARefinement ANewRevisionEndsAProgressivePicture
AnEndedRefinementIsForgottenWithItsRevision AnEndedProgressivePictureIsForgottenWithItsRevision
ARefinementThatNobodyAsksForIsDropped AProgressivePictureThatNobodyAsksForIsDropped
ARefinementThatNobodyAsksForGivesWay AProgressivePictureThatNobodyAsksForGivesWay
KeepsSoManyRefinements KeepsSoManyProgressivePictures
RefineTest SubdivideSceneTest
RefinedSurface SubdividedSurface
RefinedScene SubdividedScene
refine_model subdivide_model
refine_patches subdivide_patches
refine_mesh subdivide_mesh
encode_refinements encode_subdivisions
decode_refinements decode_subdivisions
refinement_codec subdivision_codec
refinements subdivisions
Refinements Subdivisions
AJournalFromBeforeRefinementsIsTakenOver AJournalFromBeforeSubdivisionsIsTakenOver
RefinementsAndFirstSettingsStayOverARestart SubdivisionsAndFirstSettingsStayOverARestart
ARestartRefinesAgain ARestartSubdividesAgain
is_refined has_better_picture
""")
    # Systems
    add("""
Errand Task
errand task
errands tasks
run_errand run_task
patience idle_timeout
manners busy_idle_timeout
patient_body_bytes max_drained_body_bytes
KeptViews ViewCache
KeptView CachedView
KeptFrames ViewCacheTest
forget_kept clear_view_cache
forget_shown clear_shown
least_wanted victim
kept_coats max_cached_coats
kept_frames window_frames
kept_scenes max_scenes
kept_answers max_cached_answers
kept_body_bytes max_cached_body_bytes
kept_maps shell_maps
KeptPicture StoredPicture
least_kept least_unmasked
OneCopyOfAModelIsKept OneCopyOfAModelIsCached
SeveralViewsAreKept SeveralViewsAreCached
SeveralScenesAreKept SeveralScenesAreCached
MapsAreKeptUntilFieldsOrLightChange MapsAreCachedUntilFieldsOrLightChange
kept_by_pale pale_transmittance
fur_kept fur_share
strands_kept strand_share
is_kept stays
always_kept never_cleared
""")
    # Least, most, rest
    add("""
least_squares_above_zero least_squares_above_zero
least_let_through min_transmittance
most_red reddest
most_looked_at max_looked_at
least_unmasked min_unmasked
at_rest at_default
all_at_rest all_at_default
any_above_rest any_above_default
rest_of default_of
to_rest to_default
kLeast kMin
of_most of_max
""")
    # Hair
    add("""
OddHairs Ticking
odd_hairs ticking
OddHairsHaveTheirShareAndColour TickingHasItsShareAndColour
""")
    # Places on strokes
    add("""
SurfacePlace SurfaceSample
PositionPlace PositionSample
ScreenPlace ScreenSample
""")
    # Orientation
    add("""
averted back_facing
draw_averted draw_back_facing
averted_shells back_facing_shells
furthest_averted furthest_back_facing
a_averted a_back_facing
b_averted b_back_facing
FarOnesComeFirstAndAvertedOnesBeforeThem FarOnesComeFirstAndBackFacingOnesBeforeThem
near_outline near_silhouette
outlined at_silhouette
""")
    # Lights
    add("""
LAMPS LIGHT_COUNT
FAR_LAMPS DISTANT_LIGHTS
LampDisc LightDisc
lamp_disc light_disc
lamp_from light_from
any_lamp any_light
lamp_on_skin light_on_skin
SumsUpAmbientLightAndLamps SumsUpAmbientLightAndLights
KeepsTheLightOfLampsApart KeepsDirectLightApart
NamesTheLampsAndWhetherAllAreFarAway NamesTheLightsAndWhetherAllAreFarAway
FarLampsAloneGiveTheSameLight DistantLightsAloneGiveTheSameLight
LampsFallWithTheSquareSpotsToTheirEdgeAndAreasByTheCosine LightsFallWithTheSquareSpotsToTheirEdgeAndAreasByTheCosine
PenumbrasAreTheShareOfTheLampThatRaysMiss PenumbrasAreTheShareOfTheLightThatRaysMiss
DirectIsWhatLampsBring DirectIsWhatLightsBring
IsFiniteUnderBlindingLamps IsFiniteUnderBlindingLights
LampsThatShineElsewhereCastNoShadow LightsThatShineElsewhereCastNoShadow
LampsAddUp LightsAddUp
""")
    # The viewpoint
    add("""
to_eye to_camera
to_eye_ to_camera_
to_eyes to_cameras
from_eye from_camera
cosine_to_eye cosine_to_camera
sine_eye sine_view
eye_sine view_sine
cosine_eye cosine_view
cos_theta_eye cos_theta_view
theta_eye theta_view
along_eye along_view
across_eye across_view
eye_facing view_facing
eye_angle view_angle
to_eye_strands to_camera_strands
""")
    table.pop("least_squares_above_zero")
    table.pop("IsAtMostOneUnlessTheKnobIsLarger")
    return table


def wire():
    """Names of the contract, where a plain word needs its surroundings."""
    r = []
    ANY = "csmpd"
    # Order of fragments: layers -> shells. Before the AOVs.
    r += [(r'"layers"(\s*,\s*FragmentOrder::)layers\b', r'"shells"\1shells', "s")]
    r += [(r"\bFragmentOrder::layers\b", "FragmentOrder::shells", ANY)]
    r += [(r"(enum class FragmentOrder \{ )layers\b", r"\1shells", "c")]
    r += [(r'((?:\\"|")order(?:\\"|"):\s*(?:\\"|"))layers', r"\1shells", ANY)]
    r += [(r'(""order"":"")layers', r"\1shells", "d")]
    r += [(r"(\border: )layers\b", r"\1shells", "mp")]
    r += [(r"(order: \{enum: \[)layers(, sorted\], default: )layers", r"\1shells\2shells", "d")]
    r += [(r'`order=layers`', "`order=shells`", "p")]
    # Frame requests
    return r


def rules():
    out = list(wire())
    ANY = "csmpd"
    # --- the wire, by line -------------------------------------------------------------------------------------------
    C_WIRE = r"^(protocol|clients|server|tests)/.*\.(cpp|h)$"
    ANSWERS = r"^(protocol/(json|commands)/.*answers|clients/cli/print|tests/(soak|end_to_end|fuzz)|clients/cli/(steps|session|scene_actions))"
    # order in C++ tables is code + string: handled by whole-token neighbours below.
    out += [
        (r"^\"layers\"$", '"shells"', "s", r"^(clients/cli/trade/settings|renderer/passes/sorted/|tests/bench/dial)"),
        (r"^\"layers\"$", '"edit_layers"', "s", r"answers\.(cpp|h)$|^tests/end_to_end/(test_edit_layers|test_layers)|^tests/soak"),
        (r"\[\"layers\"\]", '["edit_layers"]', ANY, r"^tests/end_to_end/test_contract"),
        (r"^\"layers\"$", '"aovs"', "s", r"^(protocol/|clients/|tests/|docs/|server/|renderer/)", r"answers|names\.h"),
        (r"^\"layers\"$", '"shells"', "s", r"names\.h$"),
        (r'^"/layers(/\d+)?"$', r'"/aovs\1"', "s"),
        (r'^"--layers"$', '"--aovs"', "s"),
        (r'(\\?"|"")layers(\\?"|"")(?=\s*:)', r"\1aovs\2", "sdp"),
        (r"^\"layer\"$", '"edit_layer"', "s"),
        (r'^"/layer"$', '"/edit_layer"', "s"),
        (r'"layer"(?=\s*[:,}])', '"edit_layer"', "sdp"),
        (r'("op":\s*)"layer"', r'\1"edit_layer"', "sdp"),
        (r'\bone\("layer"', 'one("edit_layer"', "s"),
        (r"`--layers`", "`--aovs`", "p"), (r"--layers\b", "--aovs", ANY),
        (r"\blayer_count\b", "aov_shell_count", "csm", GL),
        (r"\blayer_count\b", "shell_count", ANY),
        (r"^(\s*)layers:(?= \{type: array, items: \{\$ref: \"#/components/schemas/EditLayer)", r"\1edit_layers:", "d"),
    ]
    # --- openapi.yaml ------------------------------------------------------------------------------------------------
    YAML = r"openapi\.yaml$"
    out += [
        (r"/base_picture\b", "/skin_texture", "d", YAML), (r"`base_picture`", "`skin_texture`", ANY),
        (r"(?m)^(    )Layer:$", r"\1ChangeEditLayer:", "d", YAML),
        (r"\bschemas/Layer\"", 'schemas/ChangeEditLayer"', "d", YAML),
        (r"(?m)^(          )layer: \"#", r'\1edit_layer: "#', "d", YAML),
        (r"\{const: layer\}", "{const: edit_layer}", "d", YAML),
        (r"(?m)^(        )layer: \{type: string", r"\1edit_layer: {type: string", "d", YAML),
        (r"(?m)^(        )layers: \{type: array, items: \{\$ref: \"#/components/schemas/EditLayer", r"\1edit_layers: {type: array, items: {$ref: \"#/components/schemas/EditLayer".replace('\\"', '"'), "d", YAML),
        (r"(undo_steps, redo_steps, )layers\]", r"\1edit_layers]", "d", YAML),
        (r"(?m)^(        )layers:$", r"\1aovs:", "d", YAML),
        (r"\{required: \[layers\]\}", "{required: [aovs]}", "d", YAML),
        (r"\bleast, most\]", "min, max]", "d", YAML), (r"least, most: not under, not over", "min, max: not under, not over", "d", YAML),
        (r"\bbest, least\]", "best, cheapest]", "d", YAML), (r"\bleast: even the cheapest", "cheapest: even the cheapest", "d", YAML),
        (r"(?m)^(        )refine:$", r"\1progressive:", "d", YAML),
        (r"\brefine: \{(not: \{)?const: false", lambda m: m.group().replace("refine", "progressive"), "d", YAML),
        (r"required: \[refine\]", "required: [progressive]", "d", YAML),
        (r"(?m)^(            )eye: (?=\{\$ref: \"#/components/schemas/Position)", r"\1position: ", "d", YAML),
        (r"required: \[eye, target\]", "required: [position, target]", "d", YAML),
        (r"\{name: eye, in: query", "{name: position, in: query", "d", YAML),
        (r"The eye differs from the target", "Its position differs from the target", ANY),
        (r"Layers of fur, where the view needs most", "Where the view needs most", "d", YAML),
        (r"adaptive: fewer layers where", "adaptive: fewer shells where", ANY),
        (r"Texture steps inside each layer", "Texture steps inside each slab", "d", YAML),
        (r"Layer-wise shadow maps", "Shadow maps of the shells", ANY),
        (r"layer-wise shadow maps", "shadow maps of the shells", ANY),
        (r"\bLayers of an EXR beside beauty", "AOVs of an EXR beside beauty", "d", YAML),
        (r"times layers at most", "times AOVs at most", "d", YAML),
        (r"\bLAYER\.(?=[XYR.])", "AOV.", ANY),
        (r"of the layers of an EXR are in beauty", "of the AOVs of an EXR are in beauty", ANY),
        (r"Of an EXR's layers it makes beauty and alpha; the others stay in the order of layers",
         "Of an EXR's AOVs it makes beauty and alpha; the others stay in the order of shells", ANY),
        (r"more a march through its layers", "more a march through its depth", ANY),
    ]
    out += [
        (r"\brefine\(", "subdivide_scene(", "cm", r"^(server/scene/|tests/unit/scene/(refine|subdivide))"),
        (r"\brefine\(", "improve(", "cm", r"^(server/frames/|tests/unit/scene/(trace|picture))"), (r"TraceQueue::refine\b", "TraceQueue::improve", "m"),
        (r"\brefined\b", "progressive", "cm", r"^(server/frames/picture_service\.h|tests/unit/(scene/trace_queue|protocol/trace)|tests/end_to_end/test_dial)"),
        (r"\brefined\(source", "subdivided(source", "c", r"^tests/unit/groom"), (r"another view is refined", "another view is traced", "p"),
        (r"\bAll kept views\b", "All cached views", ANY), (r"\bthat are turned away from the\b", "that are back-facing to the", ANY), (r"\bfaces that are turned away\b", "back-facing faces", ANY),
        (r"\blayer_of\b", "prefix_of", "c", r"^renderer/image/"), (r"\bthe layer at which the caustics\b", "the array index at which the caustics", "m"), (r"// first layer$", "// first array index", "m"),
        (r"\bmost_layers\b", "max_depth_complexity", ANY), (r"\bmost_layer_sets\b", "max_shell_lods", ANY), (r"\bSets that differ\b", "LODs that differ", "m", r"layer_sets|shell_lod"),
        (r"\blayer\(Aov|\blayer\(FrameLayer", "aov(FrameLayer", "c"), (r"\bFilm::layer\b", "Film::aov", ANY), (r"(tracer_?|film_?|report)(\.|->)layer\(", r"\1\2aov(", "c"),
    ]
    # --- refine ------------------------------------------------------------------------------------------------------
    PROGRESSIVE = r"^(protocol/|clients/|server/(frames|http)/|tests/(bench|end_to_end|unit/protocol|property/json|unit/scene/trace|unit/scene/picture|extremes|soak|fuzz|gl|golden|unit/strands)|docs/|README|deploy/)"
    SUBDIVIDE = r"^(server/(scene|patches|surface|history|fields|import|builtin)/|tests/(unit/(scene/subdivide|history|surface|fields|patches)|property))"
    NOT_SUB = r"docs/tools/|docs/(models|retarget)\.md|subdivide"
    out += [
        (r"--refine\b", "--progressive", ANY),
        (r'^"refine"$', '"progressive"', "s"), (r'(\\?")refine(\\?")(?=\s*:)', r"\1progressive\2", "sdp"),
        (r'^"/refine(/\w+)?"$', r'"/progressive\1"', "s"), (r"/refine\b(?=[\"/])", "/progressive", "s", r"^tests/"),
        (r"`refine`", "`progressive`", ANY),
        (r"(?<=, )refine=", "progressive=", "c", r"\.py$"), (r"\brefine=", "progressive=", "c", r"\.py$"),
        (r"\bstrands refine\b", "strands improve", ANY), (r"\bStrands refine\b", "Strands improve", ANY),
        (r"\bsubdivide refine\b", "subdivide", ANY),
        (r"\bfor a refinement\b", "for progressive rendering", ANY, PROGRESSIVE, NOT_SUB),
        (r"\brefine\b", "progressive", ANY, PROGRESSIVE, NOT_SUB),
        (r"\brefined\b", "better_picture", "c", r"^server/(frames|http)/", r"picture_service\.h"),
        (r"\b[Aa] refinement\b(?!s)", lambda m: m.group()[0] + " progressive picture", "ms", PROGRESSIVE, NOT_SUB),
        (r"\brefinements?\b", lambda m: "progressive picture" + ("s" if m.group().endswith("s") else ""), "ms", PROGRESSIVE, NOT_SUB),
        (r"\brefinement\b", "progressive rendering", "pd", PROGRESSIVE, NOT_SUB),
        (r"\brefinement\b", "progressive", "c", PROGRESSIVE, NOT_SUB),
        (r"\brefined\b", "progressive", "c", r"^tests/(end_to_end|unit/protocol|bench)"),
        (r"\brefined\b", "subdivided", ANY, SUBDIVIDE), (r"\brefines\b", "subdivides", ANY, SUBDIVIDE),
        (r"\brefine\b", "subdivide", ANY, SUBDIVIDE), (r"\brefining\b", "subdividing", ANY, SUBDIVIDE),
        (r"\brefinement\b", "subdivision", ANY, SUBDIVIDE), (r"\bRefined\b", "Subdivided", ANY, SUBDIVIDE),
    ]
    # --- the skin texture and the backplate --------------------------------------------------------------------------
    SKIN = r"^(server/|clients/|protocol/|tests/(end_to_end|unit/scene|property|fuzz|extremes|unit/history|unit/surface|unit/groom)|docs/(models|grooming|fur|service|maps|tools))"
    out += [
        (r"\bbase-picture\b", "skin-texture", ANY),
        (r"\bbase_picture_\b", "backplate_", "c", r"^server/frames/"),
        (r"\bbase_picture\b", "skin_texture", ANY, r"^server/frames/(fur_view|skin_view|difference_view)"),
        (r"\bbase_picture\b", "backplate", ANY, r"^(server/frames|renderer/|tests/(gl/traced|bench|unit/strands))"),
        (r"/base_picture\b", "/skin_texture", ANY),
        (r"\bbase_picture\b", "skin_texture", ANY),
        (r"\b([Bb])ase pictures?\b", lambda m: ("S" if m.group(1) == "B" else "s") + "kin texture" + ("s" if m.group().endswith("s") else ""), ANY, SKIN, r"^server/frames/|docs/strands"),
        (r"\b([Bb])ase pictures?\b", lambda m: ("B" if m.group(1) == "B" else "b") + "ackplate" + ("s" if m.group().endswith("s") else ""), ANY),
    ]
    # --- the camera --------------------------------------------------------------------------------------------------
    out += [
        (r"\b(camera_?|ear|CAMERA)(\.|->)eye\b", r"\1\2position", "c"),
        (r"\bplaced\.eye\b", "placed.position", "c", r"^server/groom/"),
        (r"\bresult\.eye\b", "result.position", "c", r"^protocol/json/"), (r"\bc\.eye\b", "c.position", "c", r"^protocol/"),
        (r"glm::dvec3 eye\{0, 0, 1\}", "glm::dvec3 position{0, 0, 1}", "c", r"^protocol/commands/camera\.h$"),
        (r"// differs from eye\b", "// differs from position", "m"),
        (r"glm::vec3 eye\{0, 0, 1\}, right", "glm::vec3 position{0, 0, 1}, right", "c", r"^renderer/input/"),
        (r"glm::dvec3 eye, right, up, forward", "glm::dvec3 position, right, up, forward", "c", r"^server/groom/"),
        (r'^"eye"$', '"position"', "s", r"^(protocol/json/(decode_parts|encode_parts|decode_query|members|camera|frame|decode|encode)|clients/cli/options|tests/unit/protocol/|protocol/schema)", r"decode_eye"),
        (r'^"--eye"$', '"--position"', "s"), (r"`--eye`", "`--position`", "p"), (r"--eye\b", "--position", "p"),
        (r'camera/eye\b', "camera/position", "sdp"),
        (r'(\\?")eye(\\?")(?=:\s*(\[|"$|\)"|" \+|\)))', r"\1position\2", "s", r"^tests/(extremes|unit|property|gl|bench)"),
        (r'"eye"(?=: \[)', '"position"', "sdp", r"\.(json|md|cpp|h)$", r"clients/recipes"),
        (r'"eye"(?=:\[)', '"position"', "d", r"fuzz/corpus"),
        (r'\\"eye\\"', r'\\"position\\"', "s", r"tests/bench"),
        (r'^"eye"$', '"position"', "s", r"^tests/(end_to_end/test_(bad_input|contract|depth|frames|maps|recipes|trace_extremes)|bench/(flicker|tiers))\.py$"),
        (r'axes\["eye"\]', 'axes["position"]', "c", r"peers"), (r'^"eye"$', '"position"', "s", r"tests/bench/peers/"),
        (r"eye differs from target", "position differs from target", "s"), (r"The eye is at the target", "The camera is at its target", "s"),
        (r"\b(block|frame|seen|light|view)\.eye\b", r"\1.viewpoint", "c", None or r"^(renderer|tests/(gl|bench))/", r"renderer/(strands|eye)/"),
        (r"\bvec4 eye(?=[;{,])", "vec4 viewpoint", "c", r"^renderer/(upload/frame_block|shaders/frame)"),
        (r"\bglm::vec3 eye\{0\}", "glm::vec3 viewpoint{0}", "c", r"^renderer/(upload|visibility)/"),
        (r"\beye\b", "viewpoint", "c", r"^renderer/(curves/|visibility/|upload/shadow_block|passes/curves/|passes/fins/)"),
        (r"\beye\b", "view", "c", r"^renderer/(shading/|shaders/scattering)"),
    ]
    # --- least and most ----------------------------------------------------------------------------------------------
    out += [
        (r"\bLengthMode::least\b", "LengthMode::min", ANY), (r"\bLengthMode::most\b", "LengthMode::max", ANY),
        (r"(enum class LengthMode \{[^}]*?)least, most", r"\1min, max", "c"),
        (r'^"least"$', '"min"', "s", r"^(protocol/json|tests/(property|unit|end_to_end|extremes))", r"quality|calibration"),
        (r'^"most"$', '"max"', "s", r"^(protocol/json|tests/(property|unit|end_to_end|extremes))"),
        (r'("mode": ?)"least"', r'\1"min"', "sdp"), (r'("mode": ?)"most"', r'\1"max"', "sdp"),
        (r"`least` and `most`", "`min` and `max`", "p"),
        (r"\bPlanEnd::least\b", "PlanEnd::cheapest", ANY),
        (r"(?m)^(\s+)least(?=\s*//|\s*\n?\s*$)", r"\1cheapest", "c", r"^protocol/commands/quality\.h$"),
        (r"(?<=[\w_])_at_rest\b", "_at_default", ANY),
        (r"\bleast\(options", "cheapest_by(options", "c", r"^renderer/quality/planner"), (r"\bleast\(const std::vector<Option>", "cheapest_by(const std::vector<Option>", "c", r"^renderer/quality/planner"),
        (r"\bmost\b", "max_value", "c", r"passes/eye/eye\.frag$"),
        (r"\bmost\b", "max_count", "c", r"overlay/count\.frag$"), (r'^"most"$', '"max_count"', "s", r"passes/overlay/"),
        (r"\bleast\b", "min_radius", "c", r"shaders/shadow\.glsl$"), (r"\bmost\b", "max_radius", "c", r"shaders/shadow\.glsl$"),
        (r"\bvoid Cost::least\b", "void Cost::lower_to", "c"), (r"\bvoid least\(const Cost", "void lower_to(const Cost", "c"),
        (r"\.least\((?=measure|other|\{)", ".lower_to(", "c", r"^tests/bench/"), (r"\bleast\b(?=\(costs| = \[\])", "lower", "c", r"^tests/bench/groom"),
        (r"(?<=[.>])least\(\)", "min()", "c"), (r"\bdouble least\(\)", "double min()", "c"),
        (r"\blargest\b", "max", "c", r"^clients/cli/trade/page/svg"), (r"\bspan\.largest\b", "span.max", "c"),
        (r"\bmost_(?=of_turn)", "max_", "c"), (r"\bleast_(?=of_)", "min_", "c"),
        (r"\bmost_(\w+)", r"max_\1", ANY), (r"\bleast_(?!squares|wanted)(\w+)", r"min_\1", ANY),
        (r"\bMOST_(\w+)", r"MAX_\1", ANY),
        (r"\bleast\b", "min", "c", r"\.(cpp|h)$", r"quality\.h$"), (r"\bmost\b", "max", "c", r"\.(cpp|h)$"),
        (r"\bleast\b", "minimum", "c", r"\.py$"), (r"\bmost\b", "maximum", "c", r"\.py$"),
        (r"\bmost_\b", "max_", "c"),
    ]
    # --- rest --------------------------------------------------------------------------------------------------------
    out += [
        (r"\b(shape|shape_of\(\w+(?:\.\w+)?\)|shape_of\(Field::\w+\))\.rest\b", r"\1.default_value", "c"),
        (r"\bfloat rest = 0;", "float default_value = 0;", "c", r"^protocol/commands/field\.h$"),
        (r"\blimits_\.rest\b", "limits_.settle_time", "c"), (r"\bmilliseconds rest\{", "milliseconds settle_time{", "c"),
        (r"\blimits\.rest\b", "limits.settle_time", "c"),
        (r"\brest\b", "default_value", "c", r"^server/fields/field_set\.cpp$|^renderer/(upload/paint_buffers|strands/root_fields)\.cpp$"),
        (r"\brest\b", "baseline", "c", r"^server/(groom/(erase|evaluate|tools|retarget)|scene/(batch|scene)\.)"),
        (r"\bextras\.rest\b", "extras.baseline", "c"), (r"\.rest = ", ".baseline = ", "c", r"^tests/(property|unit)/(groom|scene)"),
        (r"takes it back to rest\b", "takes it back to its default", ANY), (r"\b[Aa]t rest\b", "at its default", "m", r"^server/fields"),
    ]
    # --- lamps -------------------------------------------------------------------------------------------------------
    out += [
        (r"\blamps\b", "light_count", "c", r"passes/eye/eye\.frag$"),
        (r"\blamp\b", "asked_light", "cs", r"^tests/gl/lighting_(grid\.frag|test\.cpp)$"),
        (r"\blamp\b", "towards_light", "c", r"spherical_harmonics_test"),
        (r"\blamp\b", "lit_from", "c", r"^tests/gl/traced_test"), (r"\bplace_of_lamp\b", "light_position", "c"), (r"\bto_lamp\b", "to_light", "c", r"^tests/"),
        (r"\blamp\b", "source", "c", r"^renderer/strands/(trace_scene|paths)"),
        (r"\blamps\b", "all_lights", "c", r"^renderer/strands/paths"), (r"\bunshadowed_lamps\b", "unshadowed_lights", "c"), (r"\blamps_shine\b", "any_light_reaches", "c"),
        (r"(?i)\blight of lamps without the ambient part", "direct light, without the ambient part", ANY),
        (r"\bLight of lamps on\b", "Direct light on", ANY), (r"\blight of all lamps\b", "light of all lights", ANY),
        (r"\blamp light\b", "direct light", ANY), (r"\bthe lamps' light\b", "direct light", ANY),
        (r"(?<![cC])(?<![A-Za-z_])lamps\b", "lights", ANY), (r"(?<![cC])(?<![A-Za-z_])lamp\b", "light", ANY),
        (r"\bLamps\b", "Lights", ANY), (r"\bLamp\b", "Light", ANY), (r"\ba lights\b", "lights", ANY), (r"\bA light's and the\b", "A light's and the", ANY),
        (r"\bunshadowed_lamps\b", "unshadowed_lights", ANY),
    ]
    # --- octets ------------------------------------------------------------------------------------------------------
    out += [
        (r"(?<![A-Za-z/])octets(?![a-z])", "bytes", ANY), (r"(?<![A-Za-z/])octet(?!-stream|[a-z])", "byte", ANY), (r"Octets", "Bytes", ANY), (r"Octet(?!-stream|[a-z])", "Byte", ANY),
        (r"(?<=_)octets(?![a-z])", "bytes", ANY), (r"(?<=_)octet(?!-stream|[a-z])", "byte", ANY),
        (r"\ban byte\b", "a byte", ANY),
    ]
    # --- silhouettes -------------------------------------------------------------------------------------------------
    out += [
        (r"\boutlines\b", "silhouettes", ANY), (r"\bOutlines\b", "Silhouettes", ANY),
        (r"(?<![A-Za-z])outline(?![a-z])", "silhouette", ANY), (r"Outline(?![a-z])", "Silhouette", ANY),
        (r"(?<![A-Za-z])Outline(?![a-z])", "Silhouette", ANY), (r"\ban silhouette", "a silhouette", ANY),
    ]
    # --- orientation -------------------------------------------------------------------------------------------------
    out += [
        (r"\bturned away from the (eye|camera)\b", "back-facing", "msp"), (r"\bfaces count as turned away\b", "faces count as back-facing", "msdp"),
        (r"\bturned away\b", "back-facing", "msdp", r"^(renderer|protocol|docs|tests|server/frames)/"),
        (r"\bwhat is averted\b", "what is back-facing", "msdp"), (r"\baverted\b", "back-facing", "msdp"),
        (r"\btriangles that face the eye\b", "front-facing triangles", "msp"), (r"\bthat faces the eye\b", "that is front-facing", "msp"),
        (r"\bwhat faces the eye\b", "what is front-facing", "msp"), (r"\bRibbons that face the eye\b", "Ribbons that face the camera", "msp"),
        (r"\bfaces the eye\b", "is front-facing", "msp"), (r"\bface the eye\b", "are front-facing", "msp"),
        (r"\bfrom the eye inwards\b", "from the camera inwards", "msp"), (r"\bfurther from the eye\b", "further from the camera", "msp"),
        (r"\bfar from the eye\b", "far from the camera", "msp", r"^renderer/(?!passes/eye)"),
        (r"\b(sends?|scattered|sent|let through|lets through|goes|hit on a round strand) to the eye\b", r"\1 to the camera", "msp"),
        (r"\b([Cc])osine to the eye\b", r"\1osine to the camera", "msp"), (r"\bdistance to the eye\b", "distance to the camera", "msp"),
        (r"\bbetween light and eye\b", "between light and view", "msp"), (r"\bbetween eye and lights?\b", "between view and light", "msp"),
        (r"\bof N to the eye\b", "of N to the camera", "msp"), (r"\bOf N to the eye\b", "Of N to the camera", "msp"),
        (r"\bfrom behind the eye\b", "from behind the camera", "msp"),
    ]
    # --- estimates ---------------------------------------------------------------------------------------------------
    out += [
        (r"\btold from\b", "estimated from", "msdp", r"^(renderer/quality|server/|protocol/|docs/|tests/unit/quality|tests/bench|clients)"),
        (r"\btold by\b", "estimated by", "msdp", r"^(renderer/quality|server/(frames|calibration)|protocol/|docs/dial|tests/unit/quality|tests/bench)"),
        (r"\bWithoutAMeasurementErrorsAreToldFromTheView\b", "WithoutAMeasurementErrorsAreEstimatedFromTheView", ANY),
        (r"\bSafetyGrowsWithWhatIsNotToldByFeatures\b", "SafetyGrowsWithWhatFeaturesDoNotPredict", ANY),
    ]
    # --- whole identifiers -------------------------------------------------------------------------------------------
    for old, new in words().items():
        out.append((rf"\b{old}\b", new, ANY))
    # `maps` of the shells: the member of the renderer's cache.
    out += [
        (r"\bKept\b", "Cached", "c", r"^renderer/(image/png_encoder|passes/eye)"),
        (r"\bkept_\b", "cache_", "c", r"^renderer/(passes/eye|frame/(renderer|draw_aovs|draw_traced))"),
        (r"\bkept_\b", "shell_maps_", "c", r"^renderer/frame/shadow_maps"),
        (r"\bkept_\b", "fur_share_", "c", r"^renderer/upload/model_buffers"),
        (r"\bkept_\b", "shares_", "c", r"^server/groom/smooth"),
        (r"\bsize_t kept = 32", "size_t max_progressive = 32", "c", r"trace_queue\.h"), (r"\blimits_?\.kept\b", lambda m: m.group().replace("kept", "max_progressive"), "c"),
    ]
    # --- AOVs and shells: plain words by folder ----------------------------------------------------------------------
    SORTED = r"^(renderer/quality/|server/calibration/|tests/unit/quality/|tests/bench/(dial|calibrat))"
    out += [
        (r"\blayers\b", "shells", "c", SORTED), (r"\blayer\b", "shell", "c", SORTED),
        (r"\blayers\b", "shells", "cm", r"^server/frames/(frame_cost|frame_planner|error_probe)"),
        (r"\.layers\b", ".aovs", "c", r"^(protocol/json|clients/cli/(picture|trade)|server/http|tests/(unit/protocol|property/json))", r"answers"),
        (r"\bstd::vector<Aov> layers\b", "std::vector<Aov> aovs", "c"), (r"\bresult\.layers = layers\(", "result.aovs = aovs(", "c"),
        (r"\brequest\.layers\b", "request.aovs", "c"), (r"\bbefore\.layers\b", "before.aovs", "c", r"^tests/property/json"),
        (r"\bsummary\.layers\b", "summary.edit_layers", "c"), (r"\bstd::vector<EditLayer> layers = \{\};(?=)", "std::vector<EditLayer> edit_layers = {};", "c", r"^protocol/commands/answers\.h$"),
        (r"\.layers = layers\}", ".edit_layers = layers}", "c", r"answers"), (r"\.layers = ", ".edit_layers = ", "c", r"^server/scene/"),
        (r"\b(c|tool|command|tools|fur|comb|paint|trim|blow|attract|erase|length|each|change|smooth|noise|map|apply)(\.|->)layer\b", r"\1\2edit_layer", "c", r"^(protocol|server|tests|clients)/"),
        (r"\bstd::string layer = \{\};", "std::string edit_layer = {};", "c", r"^protocol/commands/(tools|map)"), (r"\.layer = ", ".edit_layer = ", "c"),
        (r"(?<=requires \{ )(\w+)\.layer\b", r"\1.edit_layer", "c"), (r"\blayer_of\b", "edit_layer_of", "c", r"^(protocol|server/scene|server/history|tests/unit/scene)/"),
        (r"\blayer_of\b", "program_of", "c", r"shell_shadow"), (r"\blayers_\b", "programs_", "c", r"shell_shadow"), (r"\blayer\b", "program", "c", r"shell_shadow_pass"),
        (r"\bLayer\b", "ShadowProgram", "c", r"shell_shadow"),
        (r"\blayer\b", "height_in_shells", "c", r"shaders/shadow\.glsl$"),
        (r"\blayer\b", "index", "c", r"passes/eye/eye\.frag$"), (r"\blayers\b", "count", "c", r"passes/eye/eye_pass\.cpp$"),
        (r"\blayers\b", "image_count", "c", r"renderer/upload/model_buffers"),
        (r"\blayers\b", "shells", "c", r"^renderer/frame/shadow_maps|^tests/gl/(shadow|lighting)"),
        (r"\blayers_\b", "aovs_", "c", AOV_FOLDERS), (r"\blayers\b", "aovs", "c", AOV_FOLDERS), (r"\blayer\b", "aov", "c", AOV_FOLDERS),
        (r"\blayers\b", "aovs", "c", r"^protocol/json/", r"answers"), (r"\blayer\b", "aov", "c", r"^protocol/json/(decode|encode|encode_parts)\."),
        (r"\blayer\b", "aov", "s", r"^server/frames/|^renderer/image"),
    ]
    # prose
    out += [
        (r"\bLAYER\b", "AOV", "ms"),
        (r"\blayers of (an|the|its) EXR\b", r"AOVs of \1 EXR", "msp"), (r"\bEXR layers\b", "AOVs of an EXR", "msp"),
        (r"\bOnly an EXR has layers\b", "Only an EXR has AOVs", "s"), (r"The layer is named twice\.", "The AOV is named twice.", "s"), (r"each layer once", "each AOV once", "s"),
        (r"The layers are too large together", "The AOVs are too large together", "s"), (r"drawn pixels x layers", "drawn pixels x AOVs", "s"), (r"fewer layers\b", "fewer AOVs", "s", r"^renderer/strands"),
        (r"(?<![Ee]dit )\blayers\b", "edit layers", "msp", r"^(server/(fields|groom|scene|history|maps)/|protocol/(commands/(edit_layer|tools|map|command|history)|base/limits)|tests/(unit/(fields|scene|groom|history)|property/(groom|scene))/|docs/(grooming|history|retarget|maps|recipes)\.md|docs/tools/)", None),
        (r"(?<![Ee]dit )(?<![-\w])\blayer\b(?![-])", "edit layer", "msp", r"^(server/(fields|groom|scene|history|maps)/|protocol/(commands/(edit_layer|tools|map|command|history)|base/limits|json/(decode_tools|tool_members))|tests/(unit/(fields|scene|groom|history)|property/(groom|scene))/)", None),
        (r"\ba edit layer\b", "an edit layer", "msp"), (r"\bA edit layer\b", "An edit layer", "msp"),
        (r"\bThe layers that are made\b", "The AOVs that are made", "m"),
        (r"\blayers\b", "AOVs", "m", r"^(renderer/(strands|image|passes/aovs|passes/eye/eye_pass|frame/(draw|renderer\.h))|server/frames/(frame_file|traced|scene_tracer))"),
        (r"\b(a|each|A|Each|The|the|one|One) layer\b", r"\1 AOV", "m", r"^(renderer/(strands|image|passes/aovs|frame/(draw|renderer\.h))|server/frames/(frame_file|traced|scene_tracer))"), (r"\ba AOV\b", "an AOV", ANY), (r"\bA AOV\b", "An AOV", ANY),
        (r"\blayers\b", "shells", "ms", r"^(renderer|clients/cli/trade|tests/(gl|bench|unit/(upload|coat|shading|strands|sorted)|golden)|protocol/commands/(frame|look|quality)|server/(frames|calibration))/?"),
        (r"\bLayers\b", "Shells", "m", r"^(renderer|tests/(gl|bench|unit/(upload|coat|shading|strands|sorted)))/"),
        (r"\blayer\b", "shell", "m", r"^(renderer/(?!passes/eye|upload/model_buffers)|tests/(gl|bench|unit/(upload|coat|shading|strands)))"),
    ]
    # --- holding light off -------------------------------------------------------------------------------------------
    out += [
        (r"\bholds off light\b", "blocks light", "msp"), (r"\bhold off light\b", "block light", "msp"),
    ]
    return [row if len(row) > 2 else (*row, ANY) for row in map(tuple, out)]
