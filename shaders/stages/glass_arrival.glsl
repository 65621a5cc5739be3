// glass_arrival.glsl: the data between passes over a solid: where light reaches a face from inside (stages/glass_inside.glsl).
// Layout   per pixel, floats of 32 bits, as places and normals of a smooth face are seen enlarged behind it:
//          point      xyz world, metres; w alpha of the face, -1 - alpha where it is totally reflected
//          face       xy its outward normal (octEncode); zw ExitSurface.turn
//          ray        xy direction it came by (octEncode); z sigma, radians; w energy
//          way        x metres run in all, 0 where there is nothing; y of these in the last segment; z energy that passed on the
//          way The first arrival has point and face alone: its ray is the entering one, its way straight.
// Needs    stages/glass_inside.glsl.

struct PackedArrival {
    vec4 point;
    vec4 face;
    vec4 ray;
    vec4 way;
};

PackedArrival packArrival(InnerArrival a, float passedBetween) {
    PackedArrival p;
    p.point = vec4(a.point, a.face.alpha);
    p.face = vec4(octEncode(a.face.n), a.face.turn);
    p.ray = vec4(octEncode(a.ray.direction), a.ray.sigma, a.ray.weight);
    p.way = vec4(a.run, a.segment, passedBetween, 0.0);
    return p;
}

ExitSurface unpackFace(vec4 point, vec4 face, float invIor) {
    ExitSurface s;
    s.n = octDecode(face.xy);
    s.alpha = point.w < 0.0 ? -1.0 - point.w : point.w;
    s.eta = invIor;
    s.turn = face.zw;
    return s;
}

layout(binding = 32) uniform sampler2D firstPoint;
layout(binding = 33) uniform sampler2D firstFace;
layout(binding = 34) uniform sampler2D lastPoint;
layout(binding = 35) uniform sampler2D lastFace;
layout(binding = 36) uniform sampler2D lastRay;
layout(binding = 37) uniform sampler2D lastWay;

InnerArrival readFirstArrival(Surface s, InnerLobe core, float entered, float invIor) {
    vec4 point = texelFetch(firstPoint, ivec2(gl_FragCoord.xy), 0);
    InnerArrival a;
    a.ray = core;
    a.ray.weight = entered;
    a.face = unpackFace(point, texelFetch(firstFace, ivec2(gl_FragCoord.xy), 0), invIor);
    a.point = point.xyz;
    a.run = distance(a.point, s.position);
    a.segment = a.run;
    return a;
}

// run 0: there is none.
InnerArrival readLastArrival(float invIor) {
    ivec2 at = ivec2(gl_FragCoord.xy);
    vec4 point = texelFetch(lastPoint, at, 0);
    vec4 ray = texelFetch(lastRay, at, 0);
    vec4 way = texelFetch(lastWay, at, 0);
    InnerArrival a;
    a.ray.direction = octDecode(ray.xy);
    a.ray.sigma = ray.z;
    a.ray.weight = ray.w;
    a.face = unpackFace(point, texelFetch(lastFace, at, 0), invIor);
    a.point = point.xyz;
    a.run = way.x;
    a.segment = way.y;
    return a;
}

// The way to the last face.
InnerPath readPath(Surface s, float ior) {
    float entered = faceEnergy(dot(s.n, s.wo), s.alpha, ior).transmitted;
    InnerPath p;
    p.first = readFirstArrival(s, enteringLobe(0, s, ior, entered), entered, 1.0 / ior);
    p.last = readLastArrival(1.0 / ior);
    p.reflectedInside = p.last.run > 0.0;
    p.passedBetween = texelFetch(lastWay, ivec2(gl_FragCoord.xy), 0).z;
    if (!p.reflectedInside) p.last = p.first;
    return p;
}
