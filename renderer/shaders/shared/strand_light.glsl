// The light that a fibre of the fur sends to the camera. The includer defines near_there, near_cell, near_mean,
// over_view and near_count, which describe single strands near the camera, and the frame's shading_model and
// light_count.

// Returns the weight of single strands at a position, [0, 1]: above 0 close to the camera, where the picture is less
// than near_no_view wide.
FUNCTION Real nearness(Vec3 position) {
  Real view = dot(position - Vec3(camera_position), Vec3(camera_forward)) * over_view;
  return 1.0f - smoothstep(float(near_full_view), float(near_no_view), view);
}

// Returns the strands that light crosses in near cells just before it reaches a fibre, less the mean of an entry, which
// other cells share.
FUNCTION Real near_strands(Vec3 position, Vec3 tangent, Vec3 to_light) {
  Vec3 at = position * (1.0f / near_cell);
  Real sum = Real(0.0f);
  for (int k = 0; k < near_cell_steps; ++k) sum += near_count(floor(at + to_light * (float(k) + 0.5f)));
  Real own = sum - float(near_cell_steps) * near_mean;
  return strands_crossed(own * float(1.0f / near_one), Real(1.0f), tangent, to_light);
}

// Returns the strands to a light: single strands near a fibre, and beyond the near cells those of the grid.
FUNCTION Real combined_strands(Index light, Fibre fibre, Vec3 to_light, Real near, Real crossed) {
  float path = near_cell * float(near_cell_steps);
  GridCells beyond = cells_off_skin(fibre.position + to_light * path, fibre.normal);
  Real single = near_strands(fibre.position, fibre.tangent, to_light);
  return mix(crossed, max(single + crossed_at(light, beyond).strands, 0.0f), near);
}

// `thin`: share of the coat that lies within a few cells of the grid, where the grid overestimates its thickness, [0,
// 1].
FUNCTION SentLight strand_light(Fibre fibre, Real thin, Vec3 ambient, bool unshadowed) {
  Vec3 stopped = stopped_by_strand(fibre.crossed, 1.0f);
  SentLight sum;
  sum.ambient =
      fibre.colour * ambient * ambient_share(fibre.height, fibre.above, stopped_by_strand(fibre.crossed, 0.6f));
  sum.direct = sum.unshadowed = Vec3(0.0f);
  FibreView view = view_of(fibre);
  FibreViewTerms view_terms;
  if (scatters_fibres(shading_model)) view_terms = fibre_view_terms(fibre);
  GridCells cells = cells_off_skin(fibre.position, fibre.normal);
  Real near = near_there ? nearness(fibre.position) : Real(0.0f);
  bool is_near = any_lane(near > 0.0f);
  for (Index i = 0; i < light_count; ++i) {
    Arriving light = light_at(i, fibre.position);
    Real facing = dot(fibre.normal, light.to_light), path = exit_path_length(fibre.height, facing);
    Crossing crossed = crossed_at(i, cells);
    if (is_near) crossed.strands = combined_strands(i, fibre, light.to_light, near, crossed.strands);
    Real known = strands_crossed(fibre.above, path, fibre.tangent, light.to_light);
    Real between = mix(crossed.strands, min(crossed.strands, known), thin);
    crossed.strands = strands_not_shared(fibre, view, light.to_light, path, between);
    Vec3 scattered = scatter(shading_model, fibre, view_terms, light.to_light);
    Vec3 sent = light.radiance * scattered * backlight_fade(shading_model, facing, frame.exponents.z);
    sum.direct += sent * transmittance_of(crossed, stopped);
    if (unshadowed) sum.unshadowed += sent;
  }
  return sum;
}
