// Numbers that shaders and C++ share. The build makes renderer/shaders/constants.h of them (cmake/shared_constants.py): a
// float is a double there, and one whose value ends in f a float. Lengths are in sizes.

// Blocks of uniforms.
const int frame_binding = 0;
const int pattern_binding = 1;
const int shadow_binding = 2;
const int scattering_binding = 3;
const int skin_binding = 5;
const int paint_binding = 6;
const int tuft_binding = 7;
const int raster_binding = 8;

// Storage buffers.
const int fragment_lists_storage = 1;
const int fragment_links_storage = 2;
const int fragment_colours_storage = 3;
const int raster_eyes_storage = 5;
const int raster_tissue_storage = 6;
const int raster_caustics_storage = 7;

// The same of the stages that rasterize strands: no two of one number in a stage, which has eight.
const int points_storage = 0;
const int sums_storage = 0;
const int skin_pixels_storage = 1;
const int vertices_storage = 2;
const int corners_storage = 3;
const int looks_storage = 4;
const int sky_storage = 1;
const int eye_pixels_storage = 1;
const int texels_storage = 6;
const int words_storage = 1;
const int plan_storage = 2;
const int strand_points_storage = 3;
const int lit_points_storage = 4;
const int crossed_storage = 5;
const int hidden_storage = 5;
const int near_storage = 6;
const int strand_knots_storage = 6;
const int field_storage = 6;
const int azimuthal_storage = 7;
const int knots_storage = 7;
const int triangles_storage = 7;
const int fur_groups_storage = 2;
const int fur_parts_storage = 3;
const int bends_storage = 4;
const int leans_storage = 5;
const int bent_storage = 6;
const int cell_sums_storage = 4;
const int body_sums_storage = 5;
const int within_storage = 6;
const int through_storage = 1;
const int columns_storage = 0;
const int max_strand_groups = 65536;   // of 64 strands of one part

// Textures.
const int shapes_unit = 0;
const int colours_unit = 1;
const int skin_images_unit = 2;
const int scattering_unit = 3;
const int shell_maps_unit = 4;
const int depth_maps_unit = 5;
const int width_maps_unit = 6;
const int pattern_unit = 8;
const int tuft_unit = 13;
const int clump_unit = 15;

const int max_lights = 8;
const int max_eyes = 8;
const int max_skin_regions = 64;

// The baked coat (renderer/coat/slices.h).
const int slice_count = 32;          // N0: shells that the depth was baked as
const int slice_texels = 512;        // a side of the finest level
const int slice_levels = 8;          // 512 ... 4
const float stored_depth = 6.0;      // optical depth (natural log) of a stored 255, before `depth_scale`
const float stored_light = 4.0;      // strands over a texel for which the stored light is 1/e
const float stored_slope = 0.06;     // sideways per height, in sizes, of a stored +-1
const float nominal_length = 0.03;   // of the fur that a tile is made for

// Shape of strands: what paint adds is what the coat's own settings would.
const float max_clump_gather = 0.8;      // of the way to the middle of a clump, at the tip
const float water_gathers = 0.85;    // of what is left of that way, where fur is soaked
const float max_curl = 0.5;          // radius of a curl over nominal_length

// Soaked fur over dry fur (renderer/coat/strand_tile.h): what is added to 1.
const float water_darkens = 0.8;     // exponent of colours
const float water_shines = 1.0;      // weight of highlights
const float water_sharpens = 2.0;    // exponent of highlights

// Light.
const float min_light_square = 1e-8;   // of the distance to a light
const float max_light_falloff = 1e8;   // 1 / distance^2
const int shadow_shells = 16;          // of a shadow map (GPU fur 3.1)
const float cast_bias = 0.006;         // depth that does not count as behind what casts a shadow

// ShadingModel of protocol/commands/look.h.
const int model_lengyel = 0;
const int model_kajiya = 1;
const int model_energy_conserving = 2;
const int model_scheuermann = 3;
const int model_kajiya_kay = 4;
const int model_marschner = 5;

// Rasterized strands (renderer/raster).
const int tile_side = 16;              // pixels
const int tile_pixels = 256;
const float near_distance = 1e-4f;     // along the view: what is nearer is not drawn
const int hiding_side = 4;             // pixels of the blocks by which skin hides strands
const int hidden_around = 8;           // pixels about a block that its number holds for
const float min_segment = 3.0f;        // pixels: knots nearer than that are left out
const float seen_depth = 4.0f;         // strands in front of what is left out as hidden
const float drawn_edge = 2.75f;        // pixels beside a strand that it is drawn over
const float max_packed = 0.5f;         // of the skin, that strands fill: more is as much, so that they stay within drawn_edge
const int deep_of = 8;                 // strands that one stands for where gaps alone show them
const float min_through = 0.01f;       // of a pixel's light: what is less lets nothing through
const float min_shown = 1e-3f;         // what shows less of a pixel shows nothing
const float over_black = 0.002f;       // added to colours, so that black can be divided by

// What they and the skin stand in each other's light by. How much of each length that a strand goes beyond its reach lies
// in the shadow of its other turns: found for curls that go six times as far as they reach
// (docs/notes/2026-11-28-light-of-strands.md).
const float curl_in_shadow = 0.3f;
const float density_one = 65536.0f;    // strand that covers a cell's face, in whole numbers
const int max_segment_steps = 4096;    // through cells, so that fur of any length ends
const float strand_spread = 0.08f;     // strands of one place differ in direction (light-inl.h)
const float skin_depth = 8.0f;         // optical depth of a whole face of skin
const int max_crossed_strands = 65535;
const int max_crossed_body = 32767;    // more are as many: nothing gets through
const float dark_body = 6.0f;          // depth of a body that light ends at
const int light_near_steps = 8;        // cells that are looked at one by one on the way to a light
const float solid_strands = 0.5f;      // in a cell, which the sky does not get through
const int sky_ways = 48;               // of the light of a place on the ground
const int lean_cells = 32;             // between the heights of a lean curve that are kept
const float crossed_one = 1024.0;      // strand that a light crosses, in whole numbers
const float near_step_most = 512.0f;   // of a step through a near cell, so that all of a cell can be added
const float near_one = 256.0;          // strand in a near cell
const int near_cell_steps = 8;              // near cells that are looked at on the way to a light
const int near_places = 8388608;       // for near cells; a few share one
const int near_of_x = 73856093;        // factors of their hash (Teschner et al. 2003)
const int near_of_y = 19349663;
const int near_of_z = 83492791;
const float near_whole_view = 0.1;     // sizes that the picture shows across: up to it single strands are looked for,
const float near_no_view = 0.2;        // from here on not
const int ground_light_taps = 8;       // over the disc of a wide light

// Eyes.
const float lid_radius = 1.07;       // over that of the ball
const int iris_map_width = 1024;     // around the axis; the left edge joins the right one
const int iris_map_height = 256;     // rows from the pupil to the limbus
const int iris_map_levels = 9;       // down to one row
const int caustic_texels = 48;       // across the iris, from one end of its radius to the other
const int caustic_angles = 20;       // of the light to the axis, from 0 to caustic_reach
const float caustic_reach = 2.0;     // radians

