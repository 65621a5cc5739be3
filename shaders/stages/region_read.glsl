// region_read.glsl: reads what region_surface.glsl declares.
// Needs    stages/glass_inside.glsl, stages/region_surface.glsl.

layout(binding = 31) uniform sampler2D hidingDepth; // of what is opaque and of glass that was drawn before and may hide this

// False where the solid is not, or stands behind something: what is there stays. The depth test has left out most of that.
bool readRegion() {
    ivec2 at = picturePixel();
    uvec4 texel = texelFetch(interior, ivec3(at, 0), 0);
    InteriorSurface s = interiorSurface(interiorCamera(), texel, at);
    inPosition = s.point;
    inNormal = s.n;
    layerAlpha = unpackHalf2x16(texel.z).x;
    return texel.w == objectId() && uintBitsToFloat(texel.x) >= texelFetch(hidingDepth, at, 0).x;
}
