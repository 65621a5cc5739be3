// composition_fetch.glsl: reads the tables of one interface for composition.glsl.
// Frame    as composition.glsl; wo points to the viewer, n is the entry's normal on wo's side. Samplers linear, clamped.
// alpha    slope width in [0, 1]. eta = n_far / n_near of the face in question: glass 1.5 at the entry, 1 / 1.5 at the exit.
// Returns  fetchInnerTap: what the entry makes of wo. fetchExitEnergy: what one inner tap's light passes the exit with.
//          fetchComposedTap: one tap of the exit for one inner tap. fetchComposed, fetchComposedPair: the lobe outside as one
//          tap, as two. fetchReflectedInside: the light thrown back, power. fetchLeavesNext: of that, what leaves at the next face.
// Source   composition.glsl, interface_table.glsl.
// Limits   those of both. Fetches (energy + taps): one tap 2 + 2; two taps 3 + 6, of which the entry's are 1 + 2.
#ifndef GG_REFRACTION_COMPOSITION_FETCH_GLSL
#define GG_REFRACTION_COMPOSITION_FETCH_GLSL

#include "refraction/composition.glsl"
#include "refraction/interface_table_fetch.glsl"

// energy: fetchInterfaceEnergy(...).transmitted of the entry. An index-matched entry is not there: taps are what went in.
InnerTap fetchInnerTap(sampler3D lobeTable, int tap, int taps, vec3 wo, vec3 n, float alpha, float eta, float energy) {
  InnerTap inner;
  InterfaceTap read = fetchInterfaceTap(lobeTable, tap, taps, dot(wo, n), alpha, eta);
  bool matched = abs(eta - 1.0) < INDEX_MATCHED;
  inner.direction = matched ? -wo : interfaceTapDirection(wo, n, read.angle);
  inner.sigma = matched ? 0.0 : read.sigma;
  inner.weight = read.weight * (matched ? 1.0 : energy);
  return inner;
}

float fetchExitEnergy(sampler3D energyTable, ExitView view, ExitSurface s) {
  if (abs(s.eta - 1.0) < INDEX_MATCHED) return 1.0;
  return fetchInterfaceEnergy(energyTable, max(view.cosTheta, 0.0), view.alphaEnergy, s.eta).transmitted;
}

ComposedTap fetchComposedTap(sampler3D lobeTable, int tap, int taps, InnerTap inner, ExitView view, ExitSurface s,
                             float energy) {
  InterfaceTap read = fetchInterfaceTap(lobeTable, tap, taps, max(view.cosTheta, 0.0), view.alphaShape, s.eta);
  return composeTap(inner, view, s, read.angle, read.sigma, read.weight, energy);
}

// One tap through the exit that it meets, by the first of the table's `taps`, which stands for all.
ComposedTap fetchComposed(sampler3D energyTable, sampler3D lobeTable, int taps, InnerTap inner, ExitSurface s, Widening k) {
  ExitView view = seeExit(inner, true, s, k);
  float energy = fetchExitEnergy(energyTable, view, s);
  ComposedTap tap = fetchComposedTap(lobeTable, 0, taps, inner, view, s, energy);
  tap.weight = view.cosTheta > 0.0 ? inner.weight * energy : 0.0;
  return tap;
}

// One first tap, through the exit that it meets, with a table of two.
ComposedPair fetchExitPair(sampler3D energyTable, sampler3D lobeTable, InnerTap inner, bool core, ExitSurface s,
                           Widening k) {
  ExitView view = seeExit(inner, core, s, k);
  float energy = fetchExitEnergy(energyTable, view, s);
  return composedPair(fetchComposedTap(lobeTable, 0, 2, inner, view, s, energy),
                      fetchComposedTap(lobeTable, 1, 2, inner, view, s, energy), view);
}

// Two first taps, each with its own exit (the same one, for flat faces). Four taps unmerged are no better: tests/composition.
ComposedPair fetchComposedPair(sampler3D energyTable, sampler3D lobeTable, InnerTap core, ExitSurface coreExit,
                               InnerTap tail, ExitSurface tailExit, Widening k) {
  return mergePairs(fetchExitPair(energyTable, lobeTable, core, true, coreExit, k),
                    fetchExitPair(energyTable, lobeTable, tail, false, tailExit, k));
}

// A spread of rays changes what passes. What facets hide of what they scatter, and single scattering loses, is the face's own.
float keptByFace(InterfaceEnergy own) { return own.reflected + own.transmitted; }

float fetchReflectedInside(sampler3D energyTable, InnerTap inner, ExitView view, ExitSurface s) {
  if (!(view.cosTheta > 0.0) || abs(s.eta - 1.0) < INDEX_MATCHED) return 0.0;
  float kept = keptByFace(fetchInterfaceEnergy(energyTable, view.cosTheta, s.alpha, s.eta));
  return inner.weight * max(kept - fetchExitEnergy(energyTable, view, s), 0.0);
}

// next: where the mean reflected ray leaves, at the angle cosTheta.
float fetchLeavesNext(sampler3D energyTable, float reflected, InnerTap inner, ExitSurface s, float cosTheta,
                      float nextAlpha, float nextEta) {
  if (!(cosTheta > 0.0)) return 0.0;
  float alpha = leavingNextAlpha(inner.sigma, s.alpha, nextAlpha);
  return LEAVES_NEXT * reflected * fetchInterfaceEnergy(energyTable, cosTheta, alpha, nextEta).transmitted;
}

#endif
