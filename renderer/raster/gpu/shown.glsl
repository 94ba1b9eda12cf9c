// Which RasterOutput a picture shows: light, unless a name that begins with SHOWN_ is defined.
#ifdef UNCOLOURED
const bool is_coloured = false;
#else
const bool is_coloured = true;  // the output is proportional to the colour of strands
#endif
