// refractive.glsl: a surface of glass: reflection and transmission.
// Frame    world, metres.
// Needs    interface/{frame,instance,lights,material}.glsl, stages/material_features.glsl, the inputs of opaque.vert.
// Returns  refractiveColor: radiance, premultiplied by the coverage in w. base: surfaceBaseColor().
#include "stages/glass_material.glsl"
#include "stages/thin_wall.glsl"
#include "stages/glass_far_face.glsl"
#include "stages/glass_partly_clear.glsl"
#include "stages/importance_glass.glsl"

// Whether the viewer is outside of the solid.
bool fromOutside() { return !seenFromWithin || gl_FrontFacing; }

vec4 refractiveColor(vec4 base) {
    // Alpha applies to light from outside; from within the solid counts as there.
    float coverage = alphaMode == 2 && fromOutside() ? base.w : 1.0;
    Surface s = readSurface(base);
    // The base colour tints light that crosses a solid once: its square root at each face.
    bool twice = fromOutside();
    FarFace near;
    near.tint = sqrt(s.baseColor);
    near.clear = transmission == 2 ? throughShare(s) : 1.0;
    vec3 entry = throughShare(s) * near.tint * s.facets;
    float leaves = 1.0; // the coat, of what is reflected under it
    if (twice) {
        leaves = coatLeaves(s);
        entry *= layersPass(s);
    } else {
        // From within the interface is bare.
        s.filmShare = 0.0;
        near.tint = vec3(1.0);
        near.clear = 1.0;
    }
    vec3 tint = entry * near.tint; // where the faces are alike
    float clear = near.clear;
    vec3 radiance = leaves * s.emissive;
    if (hasCoat && twice) radiance += method == 0 ? coatRadiance(s) : coatOverGlass(s, tint * clear);
    float ior = glassIor();
    MirrorLobes mirror = noMirror(s);
    if (hasEnvironment) {
        EnvironmentLight light = environmentLobe(s);
        light.weight *= leaves * s.mirrors;
        light.diffuse *= leaves;
        mirror = mirrorLobes(s, light);
        radiance += light.diffuse;
    }
    if (indexIsOne) {
        radiance += tint * clear * throughNothing() + farMirror(mirror);
        if (clear < 1.0) radiance += tint * (1.0 - clear) * baseWithin(s.baseColor, clear, ior) * wideRadiance(s.n);
    } else if (method == 0) {
        radiance += tint * throughStandard(s, ior) + farMirror(mirror);
    } else {
        // Dispersion: each channel has its own IOR and lobes.
        int ways = disperses ? 3 : 1;
        for (int k = 0; k < ways; ++k) {
            vec3 mask = vec3(1.0);
            if (disperses) mask = vec3(k == 0 ? 1.0 : 0.0, k == 1 ? 1.0 : 0.0, k == 2 ? 1.0 : 0.0);
            float own = disperses ? dispersedIor(ior, material.transmission.z, k) : ior;
            GlassLobes lobes;
            MirrorLobes reflected = mirror;
            if (transmission == 1) {
                ThinWall wall = throughThinWall(s, own);
                lobes = wall.through;
                reflected = withReflectedLater(mirror, tint * wall.reflectedLater, own);
            } else if (twice) {
                lobes = throughTwoFaces(s, own);
            } else {
                lobes = outOfSolid(s, own);
            }
            lobes.core.lobe.turn = turnOverPixel(lobes.core.lobe.direction);
            lobes.rest.lobe.turn = lobes.core.lobe.turn;
            lobes.reflectedInside.lobe.turn = turnOverPixel(lobes.reflectedInside.lobe.direction);
            FarFace first = near;
            FarFace last = near;
            if (facesDiffer && twice) {
                first = farFaceAt(lobes.core.lobe.origin, near);
                last = farFaceAt(lobes.reflectedInside.lobe.origin, near);
            }
            if (facesDiffer || clear < 1.0)
                radiance += mask * tint * baseSeenWithin(lobes, near, first, last, own) * wideRadiance(s.n);
            lobes = throughFarFaces(lobes, entry, first, last);
            if (method >= 100 && twice && !(lobes.within >= 0.0)) {
                radiance += mask * entry * first.tint * first.clear * sampledGlass(s, own, lobes, method - 100);
                lobes.core.weight = vec3(0.0);
            }
            radiance += mask * glassRadiance(lobes, reflected);
        }
    }
    if (hasLights) radiance += leaves * s.mirrors * punctualLight(s);
    return vec4(radiance * coverage, coverage);
}
