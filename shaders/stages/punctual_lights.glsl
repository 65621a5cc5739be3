// punctual_lights.glsl: what a surface makes of light from points and directions.
// Needs    stages/reflectance.glsl, stages/neighbours.glsl.

vec3 punctualLight(Surface s) {
    vec3 sum = vec3(0.0);
    for (int i = 0; i < ofPixel(frame.counts.x); ++i) {
        Arrival a = arrivalFrom(lights[i], s.position);
        vec3 light = a.irradiance * materialFCos(s, a.wi);
        if (neighbourKinds != 0) {
            if (ofPixel(light.x + light.y + light.z) > 0.0)
                light *= passesNeighbours(s.position, a.wi, a.range, 0.0); // a point of light: as sharp as shares are
        }
        sum += light;
    }
    return sum;
}
