// composition_fetch.glsl: reads the tables of one interface for composition.glsl.
// Frame    as composition.glsl; wo points to the viewer, n is the entry's normal on wo's side. Samplers linear, clamped.
// alpha    slope width in [0, 1]. eta = n_far / n_near of the face in question: glass 1.5 at the entry, 1 / 1.5 at the exit.
// Returns  fetchInnerLobe: what the entry makes of wo. fetchExitEnergy: what one inner lobe's light passes the exit with.
//          fetchComposedLobe: one lobe of the exit for one inner lobe. fetchComposed, fetchComposedPair: the lobe outside as one
//          lobe, as two. fetchReflectedInside: the power reflected inside. fetchLeavesNext: of that, what leaves at the next face.
// Source   composition.glsl, interface_table.glsl.
// Limits   those of both. Fetches (energy + lobes): one lobe 2 + 2; two lobes 3 + 6, of which the entry's are 1 + 2.
#ifndef GG_REFRACTION_COMPOSITION_FETCH_GLSL
#define GG_REFRACTION_COMPOSITION_FETCH_GLSL

#include "refraction/composition.glsl"
#include "refraction/interface_table_fetch.glsl"

// energy: fetchInterfaceEnergy(...).transmitted of the entry. An index-matched entry is not there: lobes are what went in.
InnerLobe fetchInnerLobe(sampler3D lobeTable, int lobe, int lobes, vec3 wo, vec3 n, float alpha, float eta, float energy) {
  InnerLobe inner;
  InterfaceLobe read = fetchInterfaceLobe(lobeTable, lobe, lobes, dot(wo, n), alpha, eta);
  bool matched = abs(eta - 1.0) < INDEX_MATCHED;
  inner.direction = matched ? -wo : interfaceLobeDirection(wo, n, read.angle);
  inner.sigma = matched ? 0.0 : read.sigma;
  inner.weight = read.weight * (matched ? 1.0 : energy);
  return inner;
}

float fetchExitEnergy(sampler3D energyTable, ExitView view, ExitSurface s) {
  if (abs(s.eta - 1.0) < INDEX_MATCHED) return 1.0;
  return fetchInterfaceEnergy(energyTable, max(view.cosTheta, 0.0), view.alphaEnergy, s.eta).transmitted;
}

ComposedLobe fetchComposedLobe(sampler3D lobeTable, int lobe, int lobes, InnerLobe inner, ExitView view, ExitSurface s,
                             float energy) {
  InterfaceLobe read = fetchInterfaceLobe(lobeTable, lobe, lobes, max(view.cosTheta, 0.0), view.alphaShape, s.eta);
  return composeLobe(inner, view, s, read.angle, read.sigma, read.weight, energy);
}

// One lobe through the exit that it meets, by the first of the table's `lobes`, which stands for all.
ComposedLobe fetchComposed(sampler3D energyTable, sampler3D lobeTable, int lobes, InnerLobe inner, ExitSurface s, Widening k) {
  ExitView view = seeExit(inner, true, s, k);
  float energy = fetchExitEnergy(energyTable, view, s);
  ComposedLobe lobe = fetchComposedLobe(lobeTable, 0, lobes, inner, view, s, energy);
  lobe.weight = view.cosTheta > 0.0 ? inner.weight * energy : 0.0;
  return lobe;
}

// One first lobe, through the exit that it meets, with a table of two.
ComposedPair fetchExitPair(sampler3D energyTable, sampler3D lobeTable, InnerLobe inner, bool core, ExitSurface s,
                           Widening k) {
  ExitView view = seeExit(inner, core, s, k);
  float energy = fetchExitEnergy(energyTable, view, s);
  return composedPair(fetchComposedLobe(lobeTable, 0, 2, inner, view, s, energy),
                      fetchComposedLobe(lobeTable, 1, 2, inner, view, s, energy), view);
}

// Two first lobes, each with its own exit (the same one, for flat faces). Four lobes unmerged are no better: tests/composition.
ComposedPair fetchComposedPair(sampler3D energyTable, sampler3D lobeTable, InnerLobe core, ExitSurface coreExit,
                               InnerLobe tail, ExitSurface tailExit, Widening k) {
  return mergePairs(fetchExitPair(energyTable, lobeTable, core, true, coreExit, k),
                    fetchExitPair(energyTable, lobeTable, tail, false, tailExit, k));
}

// A spread of rays changes what passes. What facets hide of what they scatter, and single scattering loses, is the face's own.
float keptByFace(InterfaceEnergy own) { return own.reflected + own.transmitted; }

float fetchReflectedInside(sampler3D energyTable, InnerLobe inner, ExitView view, ExitSurface s) {
  if (!(view.cosTheta > 0.0) || abs(s.eta - 1.0) < INDEX_MATCHED) return 0.0;
  float kept = keptByFace(fetchInterfaceEnergy(energyTable, view.cosTheta, s.alpha, s.eta));
  return inner.weight * max(kept - fetchExitEnergy(energyTable, view, s), 0.0);
}

// next: where the mean reflected ray leaves, at the angle cosTheta.
float fetchLeavesNext(sampler3D energyTable, float reflected, InnerLobe inner, ExitSurface s, float cosTheta,
                      float nextAlpha, float nextEta) {
  if (!(cosTheta > 0.0)) return 0.0;
  float alpha = leavingNextAlpha(inner.sigma, s.alpha, nextAlpha);
  return LEAVES_NEXT * reflected * fetchInterfaceEnergy(energyTable, cosTheta, alpha, nextEta).transmitted;
}

#endif
