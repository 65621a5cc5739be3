// One pass over a picture.
GG_BLOCK(1) GgPass {
  vec4 ggPass; // each pass says what
  vec4 ggFrom;
};
GG_SAMPLER(2) sampler2D ggSource;
