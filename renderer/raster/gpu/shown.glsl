// What a picture shows (RasterOutput): light, unless a name that begins with SHOWN_ is defined.
#ifdef UNCOLOURED
const bool is_coloured = false;
#else
const bool is_coloured = true;  // it goes as the colour of strands does
#endif
