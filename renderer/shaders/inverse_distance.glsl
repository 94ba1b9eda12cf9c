// One over the distance along the view, 0 for none: a triangle that is all but a line on the screen can have a w that is
// not a number.
float inverse_distance() { return gl_FragCoord.w > 0.0 ? gl_FragCoord.w : 0.0; }
