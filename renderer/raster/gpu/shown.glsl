// What a picture shows (RasterOutput): light, unless one of these is defined.
#if defined SHOWN_NORMAL || defined SHOWN_TANGENT || defined SHOWN_FIELD || defined SHOWN_SHADOW || defined SHOWN_PIECE || \
    defined SHOWN_DISTANCE || defined SHOWN_DEPTH || defined SHOWN_COUNT || defined SHOWN_STRAND
const bool is_coloured = false;  // goes as the colour of strands does
#else
const bool is_coloured = true;
#endif
