// Constants that shaders and C++ share. The build generates renderer/shaders/constants.h from them
// (cmake/shared_constants.py): a float is a double there, and one whose value ends in f a float. Lengths are in sizes.

// Uniform blocks.
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

// Storage buffers of the stages that rasterize strands. A stage has at most eight of them, and their numbers must
// differ within a stage.
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
const int max_strand_groups = 65536;   // a group is 64 strands of one part

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
const int slice_count = 32;          // slices of the baked tile (N0)
const int slice_texels = 512;        // along a side of the finest level
const int slice_levels = 8;          // 512 ... 4
const float stored_depth = 6.0;      // optical depth (natural log) of a stored 255, before `depth_scale`
const float stored_light = 4.0;      // strands over a texel for which the stored light is 1/e
const float stored_slope = 0.06;     // offset in sizes per unit of height s that is stored as +-1
const float nominal_length = 0.03;   // length of the fur that a tile is made for

// Shape of strands. Paint uses the same limits as the coat's own settings.
const float max_clump_gather = 0.8;      // share of the distance to the middle of a clump that a tip moves
const float water_gathers = 0.85;    // share of the rest of that distance that soaked fur moves
const float max_curl = 0.5;          // radius of a curl over nominal_length

// Soaked fur relative to dry fur (renderer/coat/strand_tile.h): the factor is 1 plus this.
const float water_darkens = 0.8;     // exponent of colours
const float water_shines = 1.0;      // weight of highlights
const float water_sharpens = 2.0;    // exponent of highlights

// Light.
const float min_light_square = 1e-8;   // lower bound of the squared distance to a light
const float max_light_falloff = 1e8;   // upper bound of 1 / distance^2
const int shadow_shells = 16;          // shells in a shadow map (GPU fur 3.1)
const float cast_bias = 0.006;         // depth below a shadow caster that does not count as behind it

// ShadingModel of protocol/commands/look.h.
const int model_lengyel = 0;
const int model_kajiya = 1;
const int model_energy_conserving = 2;
const int model_scheuermann = 3;
const int model_kajiya_kay = 4;
const int model_marschner = 5;

// Rasterized strands (renderer/raster).
const int tile_side = 16;              // side of a tile, pixels
const int tile_pixels = 256;
const float near_distance = 1e-4f;     // along the view direction; nearer things are not drawn
const int hiding_side = 4;             // side of the blocks by which skin hides strands, pixels
const int hiding_radius = 8;           // distance from a block up to which its value holds, pixels
const float min_segment = 3.0f;        // pixels; knots that are closer together are left out
const float seen_depth = 4.0f;         // a part behind this many strands is left out as hidden
const float drawn_margin = 2.75f;        // distance from a strand's edge up to which drawing touches pixels
const float max_packed = 0.5f;         // limit on the share of skin that strands fill; keeps them within drawn_margin
const int deep_strand_factor = 8;                 // one strand stands for this many where only gaps show them
const float min_transmittance = 0.01f;       // transmittance of a pixel at which blending stops
const float min_visible = 1e-3f;         // smaller visible shares of a pixel count as 0
const float black_offset = 0.002f;       // added to colours before a division, for black

// Shadows of rasterized strands and skin. curl_in_shadow: a curled strand is longer than it reaches; this share of the
// extra length lies in the shadow of its other turns. Measured for curls six times as long as they reach
// (docs/notes/2026-11-28-light-of-strands.md).
const float curl_in_shadow = 0.3f;
const float density_one = 65536.0f;    // fixed-point value of strands that cover a cell's face once
const int max_segment_steps = 4096;    // limit on the steps of a segment through cells
const float strand_spread = 0.08f;     // spread in direction of neighbouring strands (light-inl.h)
const float skin_depth = 8.0f;         // optical depth of a cell's face that skin covers
const int max_crossed_strands = 65535;
const int max_crossed_body = 32767;    // limits of the stored values; beyond them no light is transmitted
const float opaque_body_depth = 6.0f;          // optical depth of the body that counts as opaque
const int light_near_steps = 8;        // cells that are read one by one towards a light
const float solid_strands = 0.5f;      // coverage of a cell's face by strands from which it blocks the sky
const int sky_directions = 48;               // directions in which the sky over a position on the ground is sampled
const int lean_cells = 32;             // intervals between the stored heights of a lean curve
const float crossed_one = 1024.0;      // fixed-point value of one strand that a light crosses
const float max_near_step = 512.0f;   // limit on what one step adds to a near cell, so that its sum fits
const float near_one = 256.0;          // fixed-point value of one strand in a near cell
const int near_cell_steps = 8;              // near cells that are read towards a light
const int near_entries = 8388608;       // entries of the hash table of near cells; a few cells share one
const int near_of_x = 73856093;        // factors of their hash (Teschner et al. 2003)
const int near_of_y = 19349663;
const int near_of_z = 83492791;
const float near_full_view = 0.1;     // sizes; single strands count fully where the picture shows no more than this,
const float near_no_view = 0.2;        // sizes; and not at all from here on
const int ground_light_taps = 8;       // samples of the disc of a wide light

// Eyes.
const float lid_radius = 1.07;       // over the radius of the eyeball
const int iris_map_width = 1024;     // around the axis; the left edge joins the right one
const int iris_map_height = 256;     // rows from the pupil to the limbus
const int iris_map_levels = 9;       // down to one row
const int caustic_texels = 48;       // across the diameter of the iris
const int caustic_angles = 20;       // angles between light and axis, from 0 to caustic_reach
const float caustic_reach = 2.0;     // radians

