// neighbour_passed.glsl: what a body of rough glass passes of the light that meets it: a ball, or two parallel faces.
// Frame    none: angles only.
// alpha    slope width of D (GGX), of both faces, in [0, 1]. ior: of the body over that around it, at least 1. c: cosine of
//          incidence.
// Returns  passedShare: the share that leaves where it first meets the far face, over that of smooth faces, (1 - F)². ballSigma,
//          paneSigma: its sigma in radians. ballDeflection: the angle by which a ball turns its mean towards its axis, over the sine
//          of incidence.
// Source   fitted to paths between two faces of GGX with separable Smith (tests/render/neighbours.cpp holds the share). The limit
//          of sigma for small alpha is paraxial optics: each facet turns light by (ior - 1) of its slope, and a ball's far face turns back
//          (ior - 2) / ior of what the first did. The far face is met at the angle at which the near one was left, in a ball as
//          between parallel faces, so that both pass the same share.
// Limits   alpha from .02 to 1, ior 1.1 to 2.4, cosines from .1, weighted by the cosine: share .04 rms, deflection .03 radians,
//          sigma 8 %. Worst .23, .12 and 37 %, at grazing angles and the ends of these ranges.
#include "bsdf/constants.glsl"

float passedShare(float alpha, float ior, float c) {
    float c2 = max(c * c, 0.01); // where the fit ends
    float lost = 1.716 * (ior * ior - 1.0) * alpha * alpha / (c2 * c2);
    float most = (0.937 + 1.451 * alpha * alpha) * ior; // of 1 / share - 1, at grazing angles
    return (most + lost) / (most + lost + lost * most);
}

float passedSigma(float alpha, float ior, float c, float perFacet) {
    float wide = max(c * c, 0.01) + alpha * (3.32 * (ior - 1.0) + 0.668 * alpha);
    return 1.138 * perFacet * alpha * inversesqrt(wide);
}

float ballSigma(float alpha, float ior, float c) {
    float back = (ior - 2.0) / ior;
    return passedSigma(alpha, ior, c, (ior - 1.0) * sqrt(1.0 + back * back));
}

float paneSigma(float alpha, float ior, float c) { return passedSigma(alpha, ior, c, (ior - 1.0) * 1.41421356); }

// Twice the angle by which a smooth face turns it, less what rough faces take off.
float ballDeflection(float alpha, float ior, float c) {
    float sinI = sqrt(max((1.0 - c) * (1.0 + c), 1e-4)); // below a hundredth of a radian the quotient is constant
    float cosI = sqrt(1.0 - sinI * sinI);
    float sinT = sinI / ior;
    float turned = asin(sinI * sqrt(1.0 - sinT * sinT) - cosI * sinT);
    float a2 = alpha * alpha;
    float rough = a2 * (1.067 + 9.607 * a2) / (cosI * cosI + 2.03 * a2 + LEAST_DIVISOR);
    return 2.0 * turned / (sinI * (1.0 + rough));
}
