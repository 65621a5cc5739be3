// glass_cells.glsl: cells between four fragments of the passes at a lower rate, `apart` pixels from each other.
// Frame    pixels from the top left corner; the fragment (i, j) is that of the pixel apart (i, j) + apart / 2
//          (stages/region_pixel.glsl). The cell (i, j) lies between the fragments (i - 1, j - 1) and (i, j).

layout(constant_id = 55) const int apart = 4;

const float CELL_LEAST_COS = 0.95; // between normals of one cell

ivec2 cellOf(ivec2 pixel) { return (pixel + apart / 2) / apart; }

ivec2 pixelOfFragment(ivec2 fragment) { return fragment * apart + apart / 2; }
