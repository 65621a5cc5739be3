// Made by shaders/wgsl/make of 000ece65e691100da2ced0f32ae56dae75e166b345270237e368db41f73c6cde: do not edit.
struct Tilt {
    p: f32,
    z: f32,
}

struct Facet {
    wi: Tilt,
    wo: Tilt,
    h: Tilt,
    s: f32,
    wiDotM: f32,
    woDotM: f32,
    g: f32,
    exists: bool,
}

struct Polarized {
    s: f32,
    p: f32,
}

struct Twin3 {
    hi: vec3<f32>,
    lo: vec3<f32>,
}

struct Twin {
    hi: f32,
    lo: f32,
}

struct SignedTilt {
    p: f32,
    z: Twin,
}

struct ConductorTerms {
    a: f32,
    q2_: f32,
    numS: f32,
    denS: f32,
    numP: f32,
    denP: f32,
}

struct SplitEnergy {
    reflected: f32,
    transmitted: f32,
}

struct BsdfSurface {
    transmits: bool,
    distribution: i32,
    alpha: f32,
    eta: f32,
    n: f32,
    k: f32,
}

struct BsdfValues {
    d: f32,
    g: f32,
    gCorrelated: f32,
    fresnel: f32,
    transmitted: f32,
    f: f32,
    fCos: f32,
    fCorrelated: f32,
    pdfD: f32,
    pdfVisible: f32,
}

struct BsdfShape {
    d: f32,
    g: f32,
    v: f32,
    vCorrelated: f32,
}

struct CubeTexel {
    local: vec3<f32>,
    solidAngle: f32,
}

struct CubeRange {
    firstX: i32,
    lastX: i32,
    firstY: i32,
    lastY: i32,
}

struct StackLevels {
    even: f32,
    odd: f32,
    oddShare: f32,
}

struct LobeEnergy {
    albedo: f32,
    cos1_: f32,
    cos2_: f32,
    share1_: f32,
}

struct ReflectionLobe {
    direction: vec3<f32>,
    sigma: f32,
    weight: f32,
}

struct StretchedPart {
    n: vec3<f32>,
    alpha: f32,
    weight: f32,
}

struct LobeShare {
    share: f32,
    direction: vec3<f32>,
    sigma: f32,
    distance: f32,
    n: vec3<f32>,
}

struct ProxyLobe {
    direction: vec3<f32>,
    sigma: f32,
    albedo: f32,
}

struct InteriorView {
    clipFromWorld: mat4x4<f32>,
    worldFromClip: mat4x4<f32>,
    size: vec2<f32>,
    texelWidth: f32,
    texelDepth: vec2<f32>,
}

struct ExitRay {
    origin: vec4<f32>,
    direction: vec4<f32>,
}

struct ExitWay {
    tInside: f32,
    inside: f32,
    tOutside: f32,
    outside: f32,
}

struct SceneView {
    clipFromWorld: mat4x4<f32>,
    eye: vec3<f32>,
    size: vec2<f32>,
    focal: f32,
    reach: f32,
}

struct SceneIntersection {
    metres: f32,
    behind: f32,
    seen: bool,
}

struct FaceLayer {
    layer: i32,
    side: f32,
    number: f32,
}

struct BackFace {
    point: vec3<f32>,
    n: vec3<f32>,
    alpha: f32,
    number: f32,
    exists: bool,
}

struct PixelSteps {
    right: vec3<f32>,
    down: vec3<f32>,
}

struct ExitSurface {
    n: vec3<f32>,
    alpha: f32,
    eta: f32,
    turn: vec2<f32>,
}

struct InnerLobe {
    direction: vec3<f32>,
    sigma: f32,
    weight: f32,
}

struct Widening {
    shape: f32,
    shapeRays: f32,
    energyCore: f32,
    energyTail: f32,
}

struct ExitView {
    cosTheta: f32,
    alphaShape: f32,
    alphaEnergy: f32,
    own: f32,
    swing: f32,
}

struct ConvexBody {
    ior: f32,
    backAlpha: f32,
    thickness: f32,
    curvature: f32,
    attenuation: vec3<f32>,
}

struct ConvexExit {
    surface: ExitSurface,
    path: f32,
}

struct BackFaceExit {
    exit: ConvexExit,
    number: f32,
    found: bool,
}

struct ComposedLobe {
    direction: vec3<f32>,
    sigma: f32,
    weight: f32,
    inner: f32,
    carried: f32,
}

struct ComposedPair {
    core: ComposedLobe,
    rest: ComposedLobe,
}

struct InterfaceEnergy {
    transmitted: f32,
    reflected: f32,
}

struct InterfaceLobe {
    angle: f32,
    sigma: f32,
    weight: f32,
}

struct GlassFace {
    position: vec3<f32>,
    n: vec3<f32>,
    wo: vec3<f32>,
    alpha: f32,
    turn: f32,
}

struct FaceLobes {
    core: InterfaceLobe,
    tail: InterfaceLobe,
}

struct InternalScattering {
    passes: f32,
    back: f32,
}

struct InternalScatteringLoss {
    linear: f32,
    constant: f32,
    thin: f32,
    passes: f32,
}

struct Entering {
    core: InnerLobe,
    tail: InnerLobe,
    energy: f32,
}

struct Leaving {
    pair: ComposedPair,
    passed: f32,
}

struct WayOut {
    lobe: InnerLobe,
    exit: ConvexExit,
    point: vec3<f32>,
    found: bool,
}

struct WaysOut {
    core: WayOut,
    tail: WayOut,
}

struct LobeStratum {
    direction: vec3<f32>,
    aside: vec3<f32>,
    sigma: f32,
    inner: f32,
    carried: f32,
}

struct ThinWallEnergy {
    transmitted: f32,
    reflectedFirst: f32,
    reflectedLater: f32,
}

struct SecondBody {
    pair: ComposedPair,
    origin: vec3<f32>,
    inside: f32,
    passed: vec3<f32>,
    reflected: vec3<f32>,
}


const BSDF_PI: f32 = 3.1415927f;
const LEAST_DIVISOR: f32 = 0.000000000000000000000000000001f;
const LEAST_LENGTH: f32 = 0.000001f;
const LEAST_LENGTH2: f32 = 0.000000000001f;
const LEAST_WEIGHT: f32 = 0.000001f;
const LEAST_COSINE: f32 = 0.0001f;
const COAT_IOR: f32 = 1.5f;
const BSDF_SPLITTER: f32 = 4097f;
const BSDF_GGX: i32 = 0i;
const BSDF_BECKMANN: i32 = 1i;
const BSDF_PHONG: i32 = 2i;
const TONEMAP_CEILING: f32 = 65504f;
const HEAT_KERNEL_REACH: f32 = 3f;
const HEAT_KERNEL_KEPT: f32 = 0.949448f;
const ENERGY_TABLE_SIZE: i32 = 64i;
const LOBE_TABLE_SIZE: i32 = 32i;
const LOBE_TABLE_SLICES: i32 = 5i;
const STRETCHED_ACROSS: f32 = 0.55f;
const STRETCHED_ALONG: f32 = 0.03f;
const LEAST_LOBE: f32 = 0.01f;
const EXIT_NOWHERE: f32 = -2f;
const EXIT_FAR: f32 = 1000000000000000000000000000000f;
const EXIT_STEPS: i32 = 12i;
const SCENE_GUESSES: i32 = 4i;
const SCENE_STEPS: i32 = 12i;
const SCENE_SECANTS: i32 = 5i;
const BACK_FACES: i32 = 0i;
const SECOND_FRONTS: i32 = 1i;
const SECOND_BACKS: i32 = 2i;
const LEAST_SWING: f32 = 0.05f;
const LEAVES_NEXT: f32 = 0.65f;
const BACK_FACE_STEPS: i32 = 6i;
const INDEX_MATCHED: f32 = 0.0001f;
const COMPOSED_WIDEST: f32 = 0.3f;
const FACET_LEAST_COS: f32 = 0.2f;
const GIVEN_BACK: f32 = 0.7f;
const INTERFACE_ENERGY_COSINES: i32 = 65i;
const INTERFACE_ENERGY_ALPHAS: i32 = 32i;
const INTERFACE_LOBE_COSINES: i32 = 25i;
const INTERFACE_LOBE_ALPHAS: i32 = 16i;
const INTERFACE_SLICES: i32 = 13i;
const INTERFACE_GREATEST_ETA: f32 = 4f;
const SMOOTH_ALPHA: f32 = 0.001f;
const SCATTERED_SEEN: f32 = 0.25f;
const SCATTERED_LEAST: f32 = 0.01f;
const THIN_WALL_COSINES: i32 = 25i;
const THIN_WALL_ALPHAS: i32 = 16i;
const THIN_WALL_SLICES: i32 = 13i;
const REFLECTIONS_INSIDE: i32 = 3i;


fn tilt(v: vec3<f32>) -> Tilt {
    var v_1: vec3<f32>;
    var t: Tilt;

    v_1 = v;
    let _e11 = v_1;
    let _e13 = v_1;
    let _e16 = v_1;
    let _e18 = v_1;
    t.p = ((_e11.x * _e13.x) + (_e16.y * _e18.y));
    let _e23 = v_1;
    t.z = abs(_e23.z);
    let _e26 = t;
    return _e26;
}

fn tiltAbout(v_2: vec3<f32>, n: vec3<f32>) -> Tilt {
    var v_3: vec3<f32>;
    var n_1: vec3<f32>;
    var across: vec3<f32>;
    var t_1: Tilt;

    v_3 = v_2;
    n_1 = n;
    let _e11 = v_3;
    let _e12 = n_1;
    across = cross(_e11, _e12);
    let _e17 = across;
    let _e18 = across;
    t_1.p = dot(_e17, _e18);
    let _e21 = v_3;
    let _e22 = n_1;
    t_1.z = abs(dot(_e21, _e22));
    let _e25 = t_1;
    return _e25;
}

fn tiltCos(t_2: Tilt) -> f32 {
    var t_3: Tilt;
    var s: f32;
    var local: f32;

    t_3 = t_2;
    let _e9 = t_3;
    let _e11 = t_3;
    let _e13 = t_3;
    s = (_e9.p + (_e11.z * _e13.z));
    let _e18 = s;
    if (_e18 > 0f) {
        let _e21 = t_3;
        let _e23 = s;
        local = (_e21.z / sqrt(_e23));
    } else {
        local = 0f;
    }
    let _e28 = local;
    return _e28;
}

fn reflectionHalf(wi: vec3<f32>, wo: vec3<f32>) -> vec3<f32> {
    var wi_1: vec3<f32>;
    var wo_1: vec3<f32>;

    wi_1 = wi;
    wo_1 = wo;
    let _e11 = wi_1;
    let _e12 = wo_1;
    return (_e11 + _e12);
}

fn transmissionHalf(wi_2: vec3<f32>, wo_2: vec3<f32>, eta: f32) -> vec3<f32> {
    var wi_3: vec3<f32>;
    var wo_3: vec3<f32>;
    var eta_1: f32;

    wi_3 = wi_2;
    wo_3 = wo_2;
    eta_1 = eta;
    let _e13 = wi_3;
    let _e14 = wo_3;
    let _e16 = eta_1;
    let _e19 = wi_3;
    return ((_e13 + _e14) + ((_e16 - 1f) * _e19));
}

fn reflectionFacet(wi_4: vec3<f32>, wo_4: vec3<f32>, n_2: vec3<f32>, eta_2: f32) -> Facet {
    var wi_5: vec3<f32>;
    var wo_5: vec3<f32>;
    var n_3: vec3<f32>;
    var eta_3: f32;
    var h: vec3<f32>;
    var cosI: f32;
    var cosO: f32;
    var f: Facet;

    wi_5 = wi_4;
    wo_5 = wo_4;
    n_3 = n_2;
    eta_3 = eta_2;
    let _e15 = wi_5;
    let _e16 = wo_5;
    let _e17 = reflectionHalf(_e15, _e16);
    h = _e17;
    let _e19 = wi_5;
    let _e20 = n_3;
    cosI = dot(_e19, _e20);
    let _e23 = wo_5;
    let _e24 = n_3;
    cosO = dot(_e23, _e24);
    let _e29 = wi_5;
    let _e30 = n_3;
    let _e31 = tiltAbout(_e29, _e30);
    f.wi = _e31;
    let _e33 = wo_5;
    let _e34 = n_3;
    let _e35 = tiltAbout(_e33, _e34);
    f.wo = _e35;
    let _e37 = h;
    let _e38 = n_3;
    let _e39 = tiltAbout(_e37, _e38);
    f.h = _e39;
    let _e41 = h;
    let _e42 = h;
    f.s = dot(_e41, _e42);
    let _e46 = f;
    f.woDotM = min((0.5f * sqrt(_e46.s)), 1f);
    let _e53 = f;
    f.wiDotM = _e53.woDotM;
    let _e56 = eta_3;
    let _e59 = eta_3;
    let _e63 = f;
    let _e65 = f;
    f.g = sqrt(max((((_e56 - 1f) * (_e59 + 1f)) + (_e63.woDotM * _e65.woDotM)), 0f));
    let _e73 = cosI;
    let _e76 = cosO;
    let _e80 = cosI;
    let _e83 = cosO;
    let _e88 = f;
    f.exists = ((((_e73 > 0f) && (_e76 > 0f)) || ((_e80 < 0f) && (_e83 < 0f))) && (_e88.h.z > 0f));
    let _e94 = f;
    return _e94;
}

fn transmissionFacet(wi_6: vec3<f32>, wo_6: vec3<f32>, n_4: vec3<f32>, eta_4: f32) -> Facet {
    var wi_7: vec3<f32>;
    var wo_7: vec3<f32>;
    var n_5: vec3<f32>;
    var eta_5: f32;
    var h_1: vec3<f32>;
    var cosI_1: f32;
    var cosO_1: f32;
    var local_1: f32;
    var side: f32;
    var f_1: Facet;
    var hDotI: f32;
    var hDotO: f32;
    var possible: bool;
    var local_2: f32;
    var scale: f32;

    wi_7 = wi_6;
    wo_7 = wo_6;
    n_5 = n_4;
    eta_5 = eta_4;
    let _e15 = wi_7;
    let _e16 = wo_7;
    let _e17 = eta_5;
    let _e18 = transmissionHalf(_e15, _e16, _e17);
    h_1 = _e18;
    let _e20 = wi_7;
    let _e21 = n_5;
    cosI_1 = dot(_e20, _e21);
    let _e24 = wo_7;
    let _e25 = n_5;
    cosO_1 = dot(_e24, _e25);
    let _e28 = h_1;
    let _e29 = n_5;
    let _e31 = cosO_1;
    if ((dot(_e28, _e29) * _e31) < 0f) {
        local_1 = -1f;
    } else {
        local_1 = 1f;
    }
    let _e39 = local_1;
    side = _e39;
    let _e43 = wi_7;
    let _e44 = n_5;
    let _e45 = tiltAbout(_e43, _e44);
    f_1.wi = _e45;
    let _e47 = wo_7;
    let _e48 = n_5;
    let _e49 = tiltAbout(_e47, _e48);
    f_1.wo = _e49;
    let _e51 = h_1;
    let _e52 = n_5;
    let _e53 = tiltAbout(_e51, _e52);
    f_1.h = _e53;
    let _e55 = h_1;
    let _e56 = h_1;
    f_1.s = dot(_e55, _e56);
    let _e58 = side;
    let _e59 = h_1;
    let _e60 = wi_7;
    hDotI = (_e58 * dot(_e59, _e60));
    let _e64 = side;
    let _e65 = h_1;
    let _e66 = wo_7;
    hDotO = (_e64 * dot(_e65, _e66));
    let _e70 = cosI_1;
    let _e73 = cosO_1;
    let _e77 = cosI_1;
    let _e80 = cosO_1;
    let _e85 = eta_5;
    let _e89 = eta_5;
    possible = (((((_e70 > 0f) && (_e73 < 0f)) || ((_e77 < 0f) && (_e80 > 0f))) && (_e85 > 0f)) && (_e89 != 1f));
    let _e95 = possible;
    let _e96 = f_1;
    let _e102 = hDotI;
    let _e106 = hDotO;
    f_1.exists = (((_e95 && (_e96.h.z > 0f)) && (_e102 < 0f)) && (_e106 > 0f));
    let _e110 = f_1;
    if _e110.exists {
        let _e112 = f_1;
        local_2 = inverseSqrt(_e112.s);
    } else {
        local_2 = 0f;
    }
    let _e117 = local_2;
    scale = _e117;
    let _e120 = hDotI;
    let _e122 = scale;
    f_1.wiDotM = min((abs(_e120) * _e122), 1f);
    let _e127 = hDotO;
    let _e129 = scale;
    f_1.woDotM = min((abs(_e127) * _e129), 1f);
    let _e134 = eta_5;
    let _e135 = f_1;
    f_1.g = (_e134 * _e135.wiDotM);
    let _e138 = f_1;
    return _e138;
}

fn reflectionJacobian(f_2: Facet) -> f32 {
    var f_3: Facet;
    var local_3: f32;

    f_3 = f_2;
    let _e9 = f_3;
    if _e9.exists {
        let _e12 = f_3;
        local_3 = (0.25f / _e12.woDotM);
    } else {
        local_3 = 0f;
    }
    let _e17 = local_3;
    return _e17;
}

fn transmissionJacobian(f_4: Facet, eta_6: f32) -> f32 {
    var f_5: Facet;
    var eta_7: f32;
    var local_4: f32;

    f_5 = f_4;
    eta_7 = eta_6;
    let _e11 = f_5;
    if _e11.exists {
        let _e13 = eta_7;
        let _e14 = eta_7;
        let _e16 = f_5;
        let _e19 = f_5;
        local_4 = (((_e13 * _e14) * _e16.wiDotM) / _e19.s);
    } else {
        local_4 = 0f;
    }
    let _e24 = local_4;
    return _e24;
}

fn beckmannD(m: Tilt, alpha: f32) -> f32 {
    var m_1: Tilt;
    var alpha_1: f32;
    var width: f32;
    var width2_: f32;
    var t_4: f32;

    m_1 = m;
    alpha_1 = alpha;
    let _e11 = alpha_1;
    let _e12 = m_1;
    width = (_e11 * _e12.z);
    let _e16 = width;
    let _e17 = width;
    width2_ = (_e16 * _e17);
    let _e20 = m_1;
    let _e23 = width2_;
    if !((_e20.p < (2000f * _e23))) {
        return 0f;
    }
    let _e30 = m_1;
    let _e33 = width2_;
    let _e36 = alpha_1;
    let _e38 = m_1;
    let _e40 = m_1;
    let _e42 = m_1;
    let _e47 = width2_;
    t_4 = (((exp(((-0.5f * _e30.p) / _e33)) * _e36) * (_e38.p + (_e40.z * _e42.z))) / _e47);
    let _e50 = t_4;
    let _e51 = t_4;
    return ((_e50 * _e51) / BSDF_PI);
}

fn beckmannG1OverZ(w: Tilt, alpha_2: f32) -> f32 {
    var w_1: Tilt;
    var alpha_3: f32;
    var r: f32;
    var z: f32;
    var local_5: f32;

    w_1 = w;
    alpha_3 = alpha_2;
    let _e11 = alpha_3;
    let _e12 = w_1;
    r = (_e11 * sqrt(_e12.p));
    let _e17 = w_1;
    z = _e17.z;
    let _e20 = z;
    let _e22 = r;
    if (_e20 >= (1.6f * _e22)) {
        let _e25 = z;
        if (_e25 > 0f) {
            let _e29 = z;
            local_5 = (1f / _e29);
        } else {
            local_5 = 0f;
        }
        let _e33 = local_5;
        return _e33;
    }
    let _e35 = r;
    let _e38 = z;
    let _e41 = r;
    let _e42 = r;
    let _e45 = r;
    let _e47 = z;
    let _e51 = z;
    let _e53 = z;
    return (((3.535f * _e35) + (2.181f * _e38)) / (((_e41 * _e42) + ((2.276f * _e45) * _e47)) + ((2.577f * _e51) * _e53)));
}

fn beckmannG1(w_2: Tilt, alpha_4: f32) -> f32 {
    var w_3: Tilt;
    var alpha_5: f32;

    w_3 = w_2;
    alpha_5 = alpha_4;
    let _e11 = w_3;
    let _e12 = alpha_5;
    let _e13 = beckmannG1OverZ(_e11, _e12);
    let _e14 = w_3;
    return (_e13 * _e14.z);
}

fn beckmannG2(wi_8: Tilt, wo_8: Tilt, alpha_6: f32) -> f32 {
    var wi_9: Tilt;
    var wo_9: Tilt;
    var alpha_7: f32;

    wi_9 = wi_8;
    wo_9 = wo_8;
    alpha_7 = alpha_6;
    let _e13 = wi_9;
    let _e14 = alpha_7;
    let _e15 = beckmannG1(_e13, _e14);
    let _e16 = wo_9;
    let _e17 = alpha_7;
    let _e18 = beckmannG1(_e16, _e17);
    return (_e15 * _e18);
}

fn beckmannV(wi_10: Tilt, wo_10: Tilt, alpha_8: f32) -> f32 {
    var wi_11: Tilt;
    var wo_11: Tilt;
    var alpha_9: f32;

    wi_11 = wi_10;
    wo_11 = wo_10;
    alpha_9 = alpha_8;
    let _e14 = wi_11;
    let _e15 = alpha_9;
    let _e16 = beckmannG1OverZ(_e14, _e15);
    let _e18 = wo_11;
    let _e19 = alpha_9;
    let _e20 = beckmannG1OverZ(_e18, _e19);
    return ((0.25f * _e16) * _e20);
}

fn beckmannPdf(m_2: Tilt, alpha_10: f32) -> f32 {
    var m_3: Tilt;
    var alpha_11: f32;

    m_3 = m_2;
    alpha_11 = alpha_10;
    let _e11 = m_3;
    let _e12 = alpha_11;
    let _e13 = beckmannD(_e11, _e12);
    let _e14 = m_3;
    let _e15 = tiltCos(_e14);
    return (_e13 * _e15);
}

fn beckmannSample(alpha_12: f32, u: vec2<f32>) -> vec3<f32> {
    var alpha_13: f32;
    var u_1: vec2<f32>;
    var phi: f32;
    var slope: f32;

    alpha_13 = alpha_12;
    u_1 = u;
    let _e14 = u_1;
    phi = (6.2831855f * _e14.y);
    let _e18 = alpha_13;
    let _e20 = u_1;
    slope = (_e18 * sqrt(-(log((1f - _e20.x)))));
    let _e28 = slope;
    let _e29 = phi;
    let _e32 = slope;
    let _e33 = phi;
    return normalize(vec3<f32>((_e28 * cos(_e29)), (_e32 * sin(_e33)), 1f));
}

fn beckmannAPlus(a: f32) -> f32 {
    var a_1: f32;
    var a2_: f32;
    var term: f32 = 1f;
    var sum: f32 = 1f;
    var n_6: i32 = 1i;
    var k: f32 = 0f;
    var n_7: i32 = 30i;

    a_1 = a;
    let _e9 = a_1;
    if (_e9 < 2f) {
        {
            let _e12 = a_1;
            let _e13 = a_1;
            a2_ = (_e12 * _e13);
            loop {
                let _e22 = n_6;
                if !((_e22 < 30i)) {
                    break;
                }
                {
                    let _e29 = term;
                    let _e31 = a2_;
                    let _e34 = n_6;
                    term = (_e29 * ((2f * _e31) / f32(((2i * _e34) + 1i))));
                    let _e41 = sum;
                    let _e42 = term;
                    sum = (_e41 + _e42);
                }
                continuing {
                    let _e26 = n_6;
                    n_6 = (_e26 + 1i);
                }
            }
            let _e45 = a_1;
            let _e47 = a2_;
            let _e51 = a2_;
            let _e52 = sum;
            return ((0.5f * _e45) + ((exp(-(_e47)) * (0.5f + (_e51 * _e52))) / 1.7724539f));
        }
    }
    loop {
        let _e64 = n_7;
        if !((_e64 > 0i)) {
            break;
        }
        let _e72 = n_7;
        let _e75 = a_1;
        let _e76 = k;
        k = ((0.5f * f32(_e72)) / (_e75 + _e76));
        continuing {
            let _e68 = n_7;
            n_7 = (_e68 - 1i);
        }
    }
    let _e79 = a_1;
    let _e81 = a_1;
    let _e83 = a_1;
    let _e90 = k;
    let _e92 = a_1;
    let _e93 = k;
    return (_e79 + ((((0.5f * exp((-(_e81) * _e83))) / 1.7724539f) * _e90) / (_e92 + _e93)));
}

fn beckmannG1Exact(w_4: Tilt, alpha_14: f32) -> f32 {
    var w_5: Tilt;
    var alpha_15: f32;
    var r_1: f32;
    var local_6: f32;
    var a_2: f32;

    w_5 = w_4;
    alpha_15 = alpha_14;
    let _e11 = alpha_15;
    let _e12 = w_5;
    r_1 = (_e11 * sqrt(_e12.p));
    let _e17 = w_5;
    let _e20 = r_1;
    if (_e17.z >= (7f * _e20)) {
        let _e23 = w_5;
        if (_e23.z > 0f) {
            local_6 = 1f;
        } else {
            local_6 = 0f;
        }
        let _e30 = local_6;
        return _e30;
    }
    let _e31 = w_5;
    let _e33 = r_1;
    a_2 = (_e31.z / _e33);
    let _e36 = a_2;
    let _e37 = a_2;
    let _e38 = beckmannAPlus(_e37);
    return (_e36 / _e38);
}

fn beckmannLambdaExact(w_6: Tilt, alpha_16: f32) -> f32 {
    var w_7: Tilt;
    var alpha_17: f32;
    var g1_: f32;
    var local_7: f32;

    w_7 = w_6;
    alpha_17 = alpha_16;
    let _e11 = w_7;
    let _e12 = alpha_17;
    let _e13 = beckmannG1Exact(_e11, _e12);
    g1_ = _e13;
    let _e15 = g1_;
    if (_e15 > LEAST_DIVISOR) {
        let _e18 = g1_;
        local_7 = ((1f / _e18) - 1f);
    } else {
        local_7 = 1000000000000000000000000000000f;
    }
    let _e24 = local_7;
    return _e24;
}

fn fresnelG(c: f32, eta_8: f32) -> f32 {
    var c_1: f32;
    var eta_9: f32;

    c_1 = c;
    eta_9 = eta_8;
    let _e11 = eta_9;
    let _e14 = eta_9;
    let _e18 = c_1;
    let _e19 = c_1;
    return sqrt(max((((_e11 - 1f) * (_e14 + 1f)) + (_e18 * _e19)), 0f));
}

fn fresnelPolarized(c_2: f32, g: f32, eta_10: f32) -> Polarized {
    var c_3: f32;
    var g_1: f32;
    var eta_11: f32;
    var r_2: Polarized;
    var local_8: f32;
    var k_1: f32;
    var local_9: f32;
    var sin2_: f32;
    var across_1: f32;
    var along: f32;
    var rs: f32;
    var rp: f32;

    c_3 = c_2;
    g_1 = g;
    eta_11 = eta_10;
    let _e15 = eta_11;
    if (_e15 == 1f) {
        local_8 = 0f;
    } else {
        local_8 = 1f;
    }
    let _e21 = local_8;
    r_2.s = _e21;
    let _e23 = r_2;
    r_2.p = _e23.s;
    let _e25 = g_1;
    let _e28 = eta_11;
    if ((_e25 > 0f) && (_e28 > 0f)) {
        {
            let _e32 = eta_11;
            let _e35 = eta_11;
            k_1 = ((_e32 - 1f) * (_e35 + 1f));
            let _e40 = eta_11;
            if (_e40 < 1f) {
                let _e43 = eta_11;
                let _e44 = g_1;
                let _e46 = eta_11;
                let _e47 = g_1;
                local_9 = ((_e43 - _e44) * (_e46 + _e47));
            } else {
                let _e51 = c_3;
                let _e54 = c_3;
                local_9 = ((1f - _e51) * (1f + _e54));
            }
            let _e58 = local_9;
            sin2_ = _e58;
            let _e60 = c_3;
            let _e61 = g_1;
            across_1 = (_e60 + _e61);
            let _e64 = c_3;
            let _e65 = g_1;
            let _e67 = sin2_;
            let _e69 = c_3;
            let _e70 = g_1;
            let _e72 = sin2_;
            along = (((_e64 * _e65) - _e67) / ((_e69 * _e70) + _e72));
            let _e76 = k_1;
            let _e77 = across_1;
            let _e78 = across_1;
            rs = (_e76 / (_e77 * _e78));
            let _e82 = rs;
            let _e83 = along;
            rp = (_e82 * _e83);
            let _e87 = rs;
            let _e88 = rs;
            r_2.s = min((_e87 * _e88), 1f);
            let _e93 = rp;
            let _e94 = rp;
            r_2.p = min((_e93 * _e94), 1f);
        }
    }
    let _e98 = r_2;
    return _e98;
}

fn fresnelDielectric(c_4: f32, g_2: f32, eta_12: f32) -> f32 {
    var c_5: f32;
    var g_3: f32;
    var eta_13: f32;
    var r_3: Polarized;

    c_5 = c_4;
    g_3 = g_2;
    eta_13 = eta_12;
    let _e13 = c_5;
    let _e14 = g_3;
    let _e15 = eta_13;
    let _e16 = fresnelPolarized(_e13, _e14, _e15);
    r_3 = _e16;
    let _e19 = r_3;
    let _e21 = r_3;
    return (0.5f * (_e19.s + _e21.p));
}

fn fresnelTransmitted(c_6: f32, g_4: f32, eta_14: f32) -> f32 {
    var c_7: f32;
    var g_5: f32;
    var eta_15: f32;
    var eta2_: f32;
    var across_2: f32;
    var along_1: f32;

    c_7 = c_6;
    g_5 = g_4;
    eta_15 = eta_14;
    let _e13 = eta_15;
    if (_e13 == 1f) {
        return 1f;
    }
    let _e17 = g_5;
    let _e20 = eta_15;
    if !(((_e17 > 0f) && (_e20 > 0f))) {
        return 0f;
    }
    let _e26 = eta_15;
    let _e27 = eta_15;
    eta2_ = (_e26 * _e27);
    let _e30 = c_7;
    let _e31 = g_5;
    across_2 = (_e30 + _e31);
    let _e34 = eta2_;
    let _e35 = c_7;
    let _e37 = g_5;
    along_1 = ((_e34 * _e35) + _e37);
    let _e41 = c_7;
    let _e43 = g_5;
    let _e46 = across_2;
    let _e47 = across_2;
    let _e50 = eta2_;
    let _e51 = along_1;
    let _e52 = along_1;
    return min((((2f * _e41) * _e43) * ((1f / (_e46 * _e47)) + (_e50 / (_e51 * _e52)))), 1f);
}

fn fresnelDielectricAt(cosTheta: f32, eta_16: f32) -> f32 {
    var cosTheta_1: f32;
    var eta_17: f32;
    var c_8: f32;

    cosTheta_1 = cosTheta;
    eta_17 = eta_16;
    let _e11 = cosTheta_1;
    c_8 = clamp(abs(_e11), 0f, 1f);
    let _e17 = c_8;
    let _e18 = c_8;
    let _e19 = eta_17;
    let _e20 = fresnelG(_e18, _e19);
    let _e21 = eta_17;
    let _e22 = fresnelDielectric(_e17, _e20, _e21);
    return _e22;
}

fn fresnelTransmittedAt(cosTheta_2: f32, eta_18: f32) -> f32 {
    var cosTheta_3: f32;
    var eta_19: f32;
    var c_9: f32;

    cosTheta_3 = cosTheta_2;
    eta_19 = eta_18;
    let _e11 = cosTheta_3;
    c_9 = clamp(abs(_e11), 0f, 1f);
    let _e17 = c_9;
    let _e18 = c_9;
    let _e19 = eta_19;
    let _e20 = fresnelG(_e18, _e19);
    let _e21 = eta_19;
    let _e22 = fresnelTransmitted(_e17, _e20, _e21);
    return _e22;
}

fn fresnelPolarizedAt(cosTheta_4: f32, eta_20: f32) -> Polarized {
    var cosTheta_5: f32;
    var eta_21: f32;
    var c_10: f32;

    cosTheta_5 = cosTheta_4;
    eta_21 = eta_20;
    let _e11 = cosTheta_5;
    c_10 = clamp(abs(_e11), 0f, 1f);
    let _e17 = c_10;
    let _e18 = c_10;
    let _e19 = eta_21;
    let _e20 = fresnelG(_e18, _e19);
    let _e21 = eta_21;
    let _e22 = fresnelPolarized(_e17, _e20, _e21);
    return _e22;
}

fn fresnelNormalIncidence(eta_22: f32) -> f32 {
    var eta_23: f32;
    var r_4: f32;

    eta_23 = eta_22;
    let _e9 = eta_23;
    let _e12 = eta_23;
    r_4 = ((_e9 - 1f) / (_e12 + 1f));
    let _e17 = r_4;
    let _e18 = r_4;
    return (_e17 * _e18);
}

fn coatShare(strength: f32, cosTheta_6: f32) -> f32 {
    var strength_1: f32;
    var cosTheta_7: f32;

    strength_1 = strength;
    cosTheta_7 = cosTheta_6;
    let _e12 = strength_1;
    let _e13 = cosTheta_7;
    let _e14 = fresnelDielectricAt(_e13, COAT_IOR);
    return (_e12 * _e14);
}

fn coatPasses(strength_2: f32, cosTheta_8: f32) -> f32 {
    var strength_3: f32;
    var cosTheta_9: f32;

    strength_3 = strength_2;
    cosTheta_9 = cosTheta_8;
    let _e13 = strength_3;
    let _e15 = strength_3;
    let _e16 = cosTheta_9;
    let _e17 = fresnelTransmittedAt(_e16, COAT_IOR);
    return ((1f - _e13) + (_e15 * _e17));
}

fn twinRenormalize(hi: vec3<f32>, lo: vec3<f32>) -> Twin3 {
    var hi_1: vec3<f32>;
    var lo_1: vec3<f32>;
    var sum_1: vec3<f32>;
    var rest: vec3<f32>;
    var t_5: Twin3;

    hi_1 = hi;
    lo_1 = lo;
    let _e13 = hi_1;
    let _e14 = lo_1;
    sum_1 = (_e13 + _e14);
    let _e17 = lo_1;
    let _e18 = sum_1;
    let _e19 = hi_1;
    rest = (_e17 - (_e18 - _e19));
    let _e25 = sum_1;
    t_5.hi = _e25;
    let _e27 = rest;
    t_5.lo = _e27;
    let _e28 = t_5;
    return _e28;
}

fn twinSum(a_3: vec3<f32>, b: vec3<f32>) -> Twin3 {
    var a_4: vec3<f32>;
    var b_1: vec3<f32>;
    var sum_2: vec3<f32>;
    var bPart: vec3<f32>;
    var aPart: vec3<f32>;
    var rest_1: vec3<f32>;
    var t_6: Twin3;

    a_4 = a_3;
    b_1 = b;
    let _e13 = a_4;
    let _e14 = b_1;
    sum_2 = (_e13 + _e14);
    let _e17 = sum_2;
    let _e18 = a_4;
    bPart = (_e17 - _e18);
    let _e21 = sum_2;
    let _e22 = bPart;
    aPart = (_e21 - _e22);
    let _e25 = a_4;
    let _e26 = aPart;
    let _e28 = b_1;
    let _e29 = bPart;
    rest_1 = ((_e25 - _e26) + (_e28 - _e29));
    let _e35 = sum_2;
    t_6.hi = _e35;
    let _e37 = rest_1;
    t_6.lo = _e37;
    let _e38 = t_6;
    return _e38;
}

fn twinProduct(a_5: vec3<f32>, b_2: vec3<f32>) -> Twin3 {
    var a_6: vec3<f32>;
    var b_3: vec3<f32>;
    var product: vec3<f32>;
    var aBig: vec3<f32>;
    var bBig: vec3<f32>;
    var aHigh: vec3<f32>;
    var bHigh: vec3<f32>;
    var aLow: vec3<f32>;
    var bLow: vec3<f32>;
    var rest_2: vec3<f32>;
    var t_7: Twin3;

    a_6 = a_5;
    b_3 = b_2;
    let _e13 = a_6;
    let _e14 = b_3;
    product = (_e13 * _e14);
    let _e17 = a_6;
    aBig = (BSDF_SPLITTER * _e17);
    let _e20 = b_3;
    bBig = (BSDF_SPLITTER * _e20);
    let _e23 = aBig;
    let _e24 = aBig;
    let _e25 = a_6;
    aHigh = (_e23 - (_e24 - _e25));
    let _e29 = bBig;
    let _e30 = bBig;
    let _e31 = b_3;
    bHigh = (_e29 - (_e30 - _e31));
    let _e35 = a_6;
    let _e36 = aHigh;
    aLow = (_e35 - _e36);
    let _e39 = b_3;
    let _e40 = bHigh;
    bLow = (_e39 - _e40);
    let _e43 = aHigh;
    let _e44 = bHigh;
    let _e46 = product;
    let _e48 = aHigh;
    let _e49 = bLow;
    let _e52 = aLow;
    let _e53 = bHigh;
    let _e56 = aLow;
    let _e57 = bLow;
    rest_2 = (((((_e43 * _e44) - _e46) + (_e48 * _e49)) + (_e52 * _e53)) + (_e56 * _e57));
    let _e63 = product;
    t_7.hi = _e63;
    let _e65 = rest_2;
    t_7.lo = _e65;
    let _e66 = t_7;
    return _e66;
}

fn twinAdd(a_7: Twin3, b_4: Twin3) -> Twin3 {
    var a_8: Twin3;
    var b_5: Twin3;
    var sum_3: Twin3;
    var low: vec3<f32>;

    a_8 = a_7;
    b_5 = b_4;
    let _e13 = a_8;
    let _e15 = b_5;
    let _e17 = twinSum(_e13.hi, _e15.hi);
    sum_3 = _e17;
    let _e19 = sum_3;
    let _e21 = a_8;
    let _e23 = b_5;
    low = (_e19.lo + (_e21.lo + _e23.lo));
    let _e28 = sum_3;
    let _e30 = low;
    let _e31 = twinRenormalize(_e28.hi, _e30);
    return _e31;
}

fn twinMultiply(a_9: Twin3, b_6: Twin3) -> Twin3 {
    var a_10: Twin3;
    var b_7: Twin3;
    var product_1: Twin3;
    var low_1: vec3<f32>;

    a_10 = a_9;
    b_7 = b_6;
    let _e13 = a_10;
    let _e15 = b_7;
    let _e17 = twinProduct(_e13.hi, _e15.hi);
    product_1 = _e17;
    let _e19 = product_1;
    let _e21 = a_10;
    let _e23 = b_7;
    let _e26 = a_10;
    let _e28 = b_7;
    low_1 = (_e19.lo + ((_e21.hi * _e23.lo) + (_e26.lo * _e28.hi)));
    let _e34 = product_1;
    let _e36 = low_1;
    let _e37 = twinRenormalize(_e34.hi, _e36);
    return _e37;
}

fn twinNegate(a_11: Twin3) -> Twin3 {
    var a_12: Twin3;

    a_12 = a_11;
    let _e12 = a_12;
    a_12.hi = -(_e12.hi);
    let _e16 = a_12;
    a_12.lo = -(_e16.lo);
    let _e19 = a_12;
    return _e19;
}

fn twinSum_1(a_13: f32, b_8: f32) -> Twin {
    var a_14: f32;
    var b_9: f32;
    var sum_4: f32;
    var bPart_1: f32;
    var aPart_1: f32;
    var rest_3: f32;
    var t_8: Twin;

    a_14 = a_13;
    b_9 = b_8;
    let _e13 = a_14;
    let _e14 = b_9;
    sum_4 = (_e13 + _e14);
    let _e17 = sum_4;
    let _e18 = a_14;
    bPart_1 = (_e17 - _e18);
    let _e21 = sum_4;
    let _e22 = bPart_1;
    aPart_1 = (_e21 - _e22);
    let _e25 = a_14;
    let _e26 = aPart_1;
    let _e28 = b_9;
    let _e29 = bPart_1;
    rest_3 = ((_e25 - _e26) + (_e28 - _e29));
    let _e35 = sum_4;
    t_8.hi = _e35;
    let _e37 = rest_3;
    t_8.lo = _e37;
    let _e38 = t_8;
    return _e38;
}

fn twinTotal(a_15: Twin3) -> Twin {
    var a_16: Twin3;
    var xy: Twin;
    var xyz: Twin;
    var low_2: f32;

    a_16 = a_15;
    let _e11 = a_16;
    let _e14 = a_16;
    let _e17 = twinSum_1(_e11.hi.x, _e14.hi.y);
    xy = _e17;
    let _e19 = xy;
    let _e21 = a_16;
    let _e24 = twinSum_1(_e19.hi, _e21.hi.z);
    xyz = _e24;
    let _e26 = xy;
    let _e28 = xyz;
    let _e31 = a_16;
    let _e34 = a_16;
    let _e38 = a_16;
    low_2 = ((_e26.lo + _e28.lo) + ((_e31.lo.x + _e34.lo.y) + _e38.lo.z));
    let _e44 = xyz;
    let _e46 = low_2;
    let _e47 = twinSum_1(_e44.hi, _e46);
    return _e47;
}

fn twinDot(a_17: Twin3, b_10: Twin3) -> Twin {
    var a_18: Twin3;
    var b_11: Twin3;

    a_18 = a_17;
    b_11 = b_10;
    let _e13 = a_18;
    let _e14 = b_11;
    let _e15 = twinMultiply(_e13, _e14);
    let _e16 = twinTotal(_e15);
    return _e16;
}

fn twinTurn(a_19: Twin3) -> Twin3 {
    var a_20: Twin3;
    var t_9: Twin3;

    a_20 = a_19;
    let _e13 = a_20;
    let _e16 = a_20;
    let _e19 = a_20;
    t_9.hi = vec3<f32>(_e13.hi.y, _e16.hi.z, _e19.hi.x);
    let _e24 = a_20;
    let _e27 = a_20;
    let _e30 = a_20;
    t_9.lo = vec3<f32>(_e24.lo.y, _e27.lo.z, _e30.lo.x);
    let _e34 = t_9;
    return _e34;
}

fn twinCross(a_21: Twin3, b_12: Twin3) -> Twin3 {
    var a_22: Twin3;
    var b_13: Twin3;
    var product_2: Twin3;
    var other: Twin3;

    a_22 = a_21;
    b_13 = b_12;
    let _e13 = a_22;
    let _e14 = b_13;
    let _e15 = twinTurn(_e14);
    let _e16 = twinMultiply(_e13, _e15);
    product_2 = _e16;
    let _e18 = a_22;
    let _e19 = twinTurn(_e18);
    let _e20 = b_13;
    let _e21 = twinMultiply(_e19, _e20);
    other = _e21;
    let _e23 = product_2;
    let _e24 = other;
    let _e25 = twinNegate(_e24);
    let _e26 = twinAdd(_e23, _e25);
    let _e27 = twinTurn(_e26);
    return _e27;
}

fn twinOverSquare(p: Twin, z_1: Twin) -> f32 {
    var p_1: Twin;
    var z_2: Twin;
    var rough: f32;
    var square: Twin3;
    var back: Twin3;
    var low_3: f32;
    var lacks: f32;

    p_1 = p;
    z_2 = z_1;
    let _e13 = p_1;
    let _e15 = z_2;
    let _e17 = z_2;
    rough = (_e13.hi / (_e15.hi * _e17.hi));
    let _e22 = z_2;
    let _e25 = z_2;
    let _e28 = twinProduct(vec3(_e22.hi), vec3(_e25.hi));
    square = _e28;
    let _e30 = rough;
    let _e32 = square;
    let _e34 = twinProduct(vec3(_e30), _e32.hi);
    back = _e34;
    let _e36 = p_1;
    let _e38 = back;
    let _e42 = rough;
    let _e43 = square;
    let _e47 = z_2;
    let _e50 = z_2;
    low_3 = ((_e36.lo - _e38.lo.x) - (_e42 * (_e43.lo.x + ((2f * _e47.hi) * _e50.lo))));
    let _e57 = p_1;
    let _e59 = back;
    let _e63 = low_3;
    lacks = ((_e57.hi - _e59.hi.x) + _e63);
    let _e66 = rough;
    let _e67 = lacks;
    let _e68 = square;
    return (_e66 + (_e67 / _e68.hi.x));
}

fn twinNormalize(v_4: vec3<f32>) -> Twin3 {
    var v_5: vec3<f32>;
    var r_5: f32;
    var u_2: Twin3;
    var square_1: Twin;
    var x: f32;
    var stretch: f32;
    var low_4: vec3<f32>;

    v_5 = v_4;
    let _e11 = v_5;
    let _e12 = v_5;
    r_5 = inverseSqrt(dot(_e11, _e12));
    let _e16 = v_5;
    let _e17 = r_5;
    let _e19 = twinProduct(_e16, vec3(_e17));
    u_2 = _e19;
    let _e21 = u_2;
    let _e22 = u_2;
    let _e23 = twinDot(_e21, _e22);
    square_1 = _e23;
    let _e25 = square_1;
    let _e29 = square_1;
    x = ((_e25.hi - 1f) + _e29.lo);
    let _e33 = x;
    let _e35 = x;
    stretch = (_e33 * ((0.375f * _e35) - 0.5f));
    let _e41 = u_2;
    let _e43 = stretch;
    let _e44 = u_2;
    low_4 = (_e41.lo + (_e43 * _e44.hi));
    let _e49 = u_2;
    let _e51 = low_4;
    let _e52 = twinRenormalize(_e49.hi, _e51);
    return _e52;
}

fn preciseTilt(v_6: Twin3, n_8: Twin3) -> SignedTilt {
    var v_7: Twin3;
    var n_9: Twin3;
    var across_3: vec3<f32>;
    var t_10: SignedTilt;

    v_7 = v_6;
    n_9 = n_8;
    let _e13 = v_7;
    let _e14 = n_9;
    let _e15 = twinCross(_e13, _e14);
    across_3 = _e15.hi;
    let _e20 = across_3;
    let _e21 = across_3;
    t_10.p = dot(_e20, _e21);
    let _e24 = v_7;
    let _e25 = n_9;
    let _e26 = twinDot(_e24, _e25);
    t_10.z = _e26;
    let _e27 = t_10;
    return _e27;
}

fn unsignedTilt(signedTilt: SignedTilt) -> Tilt {
    var signedTilt_1: SignedTilt;
    var t_11: Tilt;

    signedTilt_1 = signedTilt;
    let _e13 = signedTilt_1;
    t_11.p = _e13.p;
    let _e16 = signedTilt_1;
    t_11.z = abs(_e16.z.hi);
    let _e20 = t_11;
    return _e20;
}

fn preciseSlope(h_2: Twin3, n_10: Twin3, z_3: Twin) -> Tilt {
    var h_3: Twin3;
    var n_11: Twin3;
    var z_4: Twin;
    var across_4: Twin3;
    var t_12: Tilt;

    h_3 = h_2;
    n_11 = n_10;
    z_4 = z_3;
    let _e15 = h_3;
    let _e16 = n_11;
    let _e17 = twinCross(_e15, _e16);
    across_4 = _e17;
    t_12.p = 0f;
    t_12.z = 0f;
    let _e24 = z_4;
    if (_e24.hi != 0f) {
        {
            let _e29 = across_4;
            let _e30 = across_4;
            let _e31 = twinDot(_e29, _e30);
            let _e32 = z_4;
            let _e33 = twinOverSquare(_e31, _e32);
            t_12.p = _e33;
            t_12.z = 1f;
        }
    }
    let _e36 = t_12;
    return _e36;
}

fn usable(v_8: vec3<f32>) -> bool {
    var v_9: vec3<f32>;

    v_9 = v_8;
    let _e11 = v_9;
    let _e12 = v_9;
    return (dot(_e11, _e12) > 0f);
}

fn noFacet() -> Facet {
    var f_6: Facet;

    f_6.wi.p = 0f;
    f_6.wi.z = 0f;
    let _e17 = f_6;
    f_6.wo = _e17.wi;
    let _e20 = f_6;
    f_6.h = _e20.wi;
    f_6.s = 0f;
    f_6.wiDotM = 0f;
    f_6.woDotM = 0f;
    f_6.g = 0f;
    f_6.exists = false;
    let _e32 = f_6;
    return _e32;
}

fn preciseReflectionFacet(wi_12: vec3<f32>, wo_12: vec3<f32>, n_12: vec3<f32>, eta_24: f32) -> Facet {
    var wi_13: vec3<f32>;
    var wo_13: vec3<f32>;
    var n_13: vec3<f32>;
    var eta_25: f32;
    var i: Twin3;
    var o: Twin3;
    var up: Twin3;
    var h_4: Twin3;
    var tiltI: SignedTilt;
    var tiltO: SignedTilt;
    var s_1: Twin;
    var f_7: Facet;
    var terms: Twin3;

    wi_13 = wi_12;
    wo_13 = wo_12;
    n_13 = n_12;
    eta_25 = eta_24;
    let _e17 = wi_13;
    let _e18 = usable(_e17);
    let _e19 = wo_13;
    let _e20 = usable(_e19);
    let _e22 = n_13;
    let _e23 = usable(_e22);
    if !(((_e18 && _e20) && _e23)) {
        let _e26 = noFacet();
        return _e26;
    }
    let _e27 = wi_13;
    let _e28 = twinNormalize(_e27);
    i = _e28;
    let _e30 = wo_13;
    let _e31 = twinNormalize(_e30);
    o = _e31;
    let _e33 = n_13;
    let _e34 = twinNormalize(_e33);
    up = _e34;
    let _e36 = i;
    let _e37 = o;
    let _e38 = twinAdd(_e36, _e37);
    h_4 = _e38;
    let _e40 = i;
    let _e41 = up;
    let _e42 = preciseTilt(_e40, _e41);
    tiltI = _e42;
    let _e44 = o;
    let _e45 = up;
    let _e46 = preciseTilt(_e44, _e45);
    tiltO = _e46;
    let _e48 = h_4;
    let _e49 = h_4;
    let _e50 = twinDot(_e48, _e49);
    s_1 = _e50;
    let _e54 = tiltI;
    let _e55 = unsignedTilt(_e54);
    f_7.wi = _e55;
    let _e57 = tiltO;
    let _e58 = unsignedTilt(_e57);
    f_7.wo = _e58;
    let _e60 = h_4;
    let _e61 = up;
    let _e62 = h_4;
    let _e63 = up;
    let _e64 = twinDot(_e62, _e63);
    let _e65 = preciseSlope(_e60, _e61, _e64);
    f_7.h = _e65;
    let _e67 = s_1;
    f_7.s = _e67.hi;
    let _e71 = s_1;
    f_7.woDotM = min((0.5f * sqrt(_e71.hi)), 1f);
    let _e78 = f_7;
    f_7.wiDotM = _e78.woDotM;
    let _e80 = eta_25;
    let _e84 = eta_25;
    let _e88 = twinProduct(vec3<f32>(_e80, 0f, 0f), vec3<f32>(_e84, 0f, 0f));
    terms = _e88;
    let _e91 = terms;
    let _e97 = s_1;
    terms.hi = vec3<f32>(_e91.hi.x, -1f, (0.25f * _e97.hi));
    let _e102 = terms;
    let _e107 = s_1;
    terms.lo = vec3<f32>(_e102.lo.x, 0f, (0.25f * _e107.lo));
    let _e112 = terms;
    let _e113 = twinTotal(_e112);
    f_7.g = sqrt(max(_e113.hi, 0f));
    let _e119 = tiltI;
    let _e124 = tiltO;
    let _e130 = tiltI;
    let _e135 = tiltO;
    let _e142 = f_7;
    f_7.exists = ((((_e119.z.hi > 0f) && (_e124.z.hi > 0f)) || ((_e130.z.hi < 0f) && (_e135.z.hi < 0f))) && (_e142.h.z > 0f));
    let _e148 = f_7;
    return _e148;
}

fn preciseTransmissionFacet(wi_14: vec3<f32>, wo_14: vec3<f32>, n_14: vec3<f32>, eta_26: f32) -> Facet {
    var wi_15: vec3<f32>;
    var wo_15: vec3<f32>;
    var n_15: vec3<f32>;
    var eta_27: f32;
    var i_1: Twin3;
    var o_1: Twin3;
    var up_1: Twin3;
    var factor: Twin3;
    var h_5: Twin3;
    var tiltI_1: SignedTilt;
    var tiltO_1: SignedTilt;
    var hDotN: Twin;
    var local_10: f32;
    var side_1: f32;
    var hDotI_1: f32;
    var hDotO_1: f32;
    var opposite: bool;
    var f_8: Facet;
    var local_11: f32;
    var scale_1: f32;

    wi_15 = wi_14;
    wo_15 = wo_14;
    n_15 = n_14;
    eta_27 = eta_26;
    let _e17 = wi_15;
    let _e18 = usable(_e17);
    let _e19 = wo_15;
    let _e20 = usable(_e19);
    let _e22 = n_15;
    let _e23 = usable(_e22);
    let _e25 = eta_27;
    let _e29 = eta_27;
    if !(((((_e18 && _e20) && _e23) && (_e25 > 0f)) && (_e29 != 1f))) {
        let _e34 = noFacet();
        return _e34;
    }
    let _e35 = wi_15;
    let _e36 = twinNormalize(_e35);
    i_1 = _e36;
    let _e38 = wo_15;
    let _e39 = twinNormalize(_e38);
    o_1 = _e39;
    let _e41 = n_15;
    let _e42 = twinNormalize(_e41);
    up_1 = _e42;
    let _e46 = eta_27;
    factor.hi = vec3(_e46);
    factor.lo = vec3(0f);
    let _e51 = o_1;
    let _e52 = i_1;
    let _e53 = factor;
    let _e54 = twinMultiply(_e52, _e53);
    let _e55 = twinAdd(_e51, _e54);
    h_5 = _e55;
    let _e57 = i_1;
    let _e58 = up_1;
    let _e59 = preciseTilt(_e57, _e58);
    tiltI_1 = _e59;
    let _e61 = o_1;
    let _e62 = up_1;
    let _e63 = preciseTilt(_e61, _e62);
    tiltO_1 = _e63;
    let _e65 = h_5;
    let _e66 = up_1;
    let _e67 = twinDot(_e65, _e66);
    hDotN = _e67;
    let _e69 = hDotN;
    let _e73 = tiltO_1;
    if ((_e69.hi < 0f) == (_e73.z.hi < 0f)) {
        local_10 = 1f;
    } else {
        local_10 = -1f;
    }
    let _e83 = local_10;
    side_1 = _e83;
    let _e85 = side_1;
    let _e86 = h_5;
    let _e87 = i_1;
    let _e88 = twinDot(_e86, _e87);
    hDotI_1 = (_e85 * _e88.hi);
    let _e92 = side_1;
    let _e93 = h_5;
    let _e94 = o_1;
    let _e95 = twinDot(_e93, _e94);
    hDotO_1 = (_e92 * _e95.hi);
    let _e99 = tiltI_1;
    let _e104 = tiltO_1;
    let _e110 = tiltI_1;
    let _e115 = tiltO_1;
    opposite = (((_e99.z.hi > 0f) && (_e104.z.hi < 0f)) || ((_e110.z.hi < 0f) && (_e115.z.hi > 0f)));
    let _e125 = tiltI_1;
    let _e126 = unsignedTilt(_e125);
    f_8.wi = _e126;
    let _e128 = tiltO_1;
    let _e129 = unsignedTilt(_e128);
    f_8.wo = _e129;
    let _e131 = h_5;
    let _e132 = up_1;
    let _e133 = hDotN;
    let _e134 = preciseSlope(_e131, _e132, _e133);
    f_8.h = _e134;
    let _e136 = h_5;
    let _e137 = h_5;
    let _e138 = twinDot(_e136, _e137);
    f_8.s = _e138.hi;
    let _e141 = opposite;
    let _e142 = f_8;
    let _e148 = hDotI_1;
    let _e152 = hDotO_1;
    f_8.exists = (((_e141 && (_e142.h.z > 0f)) && (_e148 < 0f)) && (_e152 > 0f));
    let _e156 = f_8;
    if _e156.exists {
        let _e158 = f_8;
        local_11 = inverseSqrt(_e158.s);
    } else {
        local_11 = 0f;
    }
    let _e163 = local_11;
    scale_1 = _e163;
    let _e166 = hDotI_1;
    let _e168 = scale_1;
    f_8.wiDotM = min((abs(_e166) * _e168), 1f);
    let _e173 = hDotO_1;
    let _e175 = scale_1;
    f_8.woDotM = min((abs(_e173) * _e175), 1f);
    let _e180 = eta_27;
    let _e181 = f_8;
    f_8.g = (_e180 * _e181.wiDotM);
    let _e184 = f_8;
    return _e184;
}

fn diffuseF(albedo: vec3<f32>, fresnel: f32) -> vec3<f32> {
    var albedo_1: vec3<f32>;
    var fresnel_1: f32;

    albedo_1 = albedo;
    fresnel_1 = fresnel;
    let _e13 = albedo_1;
    let _e15 = fresnel_1;
    return (_e13 * ((1f - _e15) / BSDF_PI));
}

fn diffuseFCos(albedo_2: vec3<f32>, fresnel_2: f32, cosI_2: f32) -> vec3<f32> {
    var albedo_3: vec3<f32>;
    var fresnel_3: f32;
    var cosI_3: f32;

    albedo_3 = albedo_2;
    fresnel_3 = fresnel_2;
    cosI_3 = cosI_2;
    let _e15 = albedo_3;
    let _e16 = fresnel_3;
    let _e17 = diffuseF(_e15, _e16);
    let _e18 = cosI_3;
    return (_e17 * _e18);
}

fn conductorTerms(c_11: f32, n_16: f32, k_2: f32) -> ConductorTerms {
    var c_12: f32;
    var n_17: f32;
    var k_3: f32;
    var sin2_1: f32;
    var contrast: f32;
    var re: f32;
    var nk: f32;
    var larger: f32;
    var local_12: f32;
    var smaller: f32;
    var local_13: f32;
    var a_23: f32;
    var local_14: f32;
    var b_14: f32;
    var local_15: f32;
    var aMinusC: f32;
    var bc: f32;
    var t_13: ConductorTerms;

    c_12 = c_11;
    n_17 = n_16;
    k_3 = k_2;
    let _e16 = c_12;
    let _e19 = c_12;
    sin2_1 = ((1f - _e16) * (1f + _e19));
    let _e23 = n_17;
    let _e26 = n_17;
    let _e30 = k_3;
    let _e31 = k_3;
    contrast = (((_e23 - 1f) * (_e26 + 1f)) - (_e30 * _e31));
    let _e35 = contrast;
    let _e36 = c_12;
    let _e37 = c_12;
    re = (_e35 + (_e36 * _e37));
    let _e41 = n_17;
    let _e42 = k_3;
    nk = (_e41 * _e42);
    let _e46 = re;
    let _e48 = re;
    let _e49 = re;
    let _e52 = nk;
    let _e54 = nk;
    larger = sqrt((0.5f * (abs(_e46) + sqrt(((_e48 * _e49) + ((4f * _e52) * _e54))))));
    let _e62 = larger;
    if (_e62 > 0f) {
        let _e65 = nk;
        let _e66 = larger;
        local_12 = (_e65 / _e66);
    } else {
        local_12 = 0f;
    }
    let _e70 = local_12;
    smaller = _e70;
    let _e72 = re;
    if (_e72 > 0f) {
        let _e75 = larger;
        local_13 = _e75;
    } else {
        let _e76 = smaller;
        local_13 = _e76;
    }
    let _e78 = local_13;
    a_23 = _e78;
    let _e80 = re;
    if (_e80 > 0f) {
        let _e83 = smaller;
        local_14 = _e83;
    } else {
        let _e84 = larger;
        local_14 = _e84;
    }
    let _e86 = local_14;
    b_14 = _e86;
    let _e88 = a_23;
    let _e89 = c_12;
    if ((_e88 + _e89) > 0f) {
        let _e93 = contrast;
        let _e94 = b_14;
        let _e95 = b_14;
        let _e98 = a_23;
        let _e99 = c_12;
        local_15 = ((_e93 + (_e94 * _e95)) / (_e98 + _e99));
    } else {
        local_15 = 0f;
    }
    let _e104 = local_15;
    aMinusC = _e104;
    let _e106 = b_14;
    let _e107 = c_12;
    bc = (_e106 * _e107);
    let _e112 = a_23;
    t_13.a = _e112;
    let _e114 = a_23;
    let _e115 = a_23;
    let _e117 = b_14;
    let _e118 = b_14;
    t_13.q2_ = ((_e114 * _e115) + (_e117 * _e118));
    let _e122 = aMinusC;
    let _e123 = aMinusC;
    let _e125 = b_14;
    let _e126 = b_14;
    t_13.numS = ((_e122 * _e123) + (_e125 * _e126));
    let _e130 = a_23;
    let _e131 = c_12;
    let _e133 = a_23;
    let _e134 = c_12;
    let _e137 = b_14;
    let _e138 = b_14;
    t_13.denS = (((_e130 + _e131) * (_e133 + _e134)) + (_e137 * _e138));
    let _e142 = a_23;
    let _e143 = c_12;
    let _e145 = sin2_1;
    let _e147 = a_23;
    let _e148 = c_12;
    let _e150 = sin2_1;
    let _e153 = bc;
    let _e154 = bc;
    t_13.numP = ((((_e142 * _e143) - _e145) * ((_e147 * _e148) - _e150)) + (_e153 * _e154));
    let _e158 = a_23;
    let _e159 = c_12;
    let _e161 = sin2_1;
    let _e163 = a_23;
    let _e164 = c_12;
    let _e166 = sin2_1;
    let _e169 = bc;
    let _e170 = bc;
    t_13.denP = ((((_e158 * _e159) + _e161) * ((_e163 * _e164) + _e166)) + (_e169 * _e170));
    let _e173 = t_13;
    return _e173;
}

fn fresnelConductor(cosTheta_10: f32, n_18: f32, k_4: f32) -> f32 {
    var cosTheta_11: f32;
    var n_19: f32;
    var k_5: f32;
    var c_13: f32;
    var t_14: ConductorTerms;
    var local_16: f32;
    var rs_1: f32;
    var local_17: f32;
    var rpOverRs: f32;

    cosTheta_11 = cosTheta_10;
    n_19 = n_18;
    k_5 = k_4;
    let _e15 = cosTheta_11;
    c_13 = clamp(abs(_e15), 0f, 1f);
    let _e21 = c_13;
    let _e22 = n_19;
    let _e25 = k_5;
    let _e28 = conductorTerms(_e21, max(_e22, 0f), max(_e25, 0f));
    t_14 = _e28;
    let _e30 = t_14;
    if (_e30.denS > 0f) {
        let _e34 = t_14;
        let _e36 = t_14;
        local_16 = (_e34.numS / _e36.denS);
    } else {
        local_16 = 1f;
    }
    let _e41 = local_16;
    rs_1 = _e41;
    let _e43 = t_14;
    if (_e43.denP > 0f) {
        let _e47 = t_14;
        let _e49 = t_14;
        local_17 = (_e47.numP / _e49.denP);
    } else {
        local_17 = 1f;
    }
    let _e54 = local_17;
    rpOverRs = _e54;
    let _e57 = rs_1;
    let _e60 = rpOverRs;
    return min(((0.5f * _e57) * (1f + _e60)), 1f);
}

fn fresnelAbsorbed(cosTheta_12: f32, n_20: f32, k_6: f32) -> f32 {
    var cosTheta_13: f32;
    var n_21: f32;
    var k_7: f32;
    var c_14: f32;
    var t_15: ConductorTerms;
    var sin2_2: f32;

    cosTheta_13 = cosTheta_12;
    n_21 = n_20;
    k_7 = k_6;
    let _e15 = cosTheta_13;
    c_14 = clamp(abs(_e15), 0f, 1f);
    let _e21 = c_14;
    let _e22 = n_21;
    let _e25 = k_7;
    let _e28 = conductorTerms(_e21, max(_e22, 0f), max(_e25, 0f));
    t_15 = _e28;
    let _e30 = t_15;
    let _e34 = t_15;
    if !(((_e30.denS > 0f) && (_e34.denP > 0f))) {
        return 0f;
    }
    let _e42 = c_14;
    let _e45 = c_14;
    sin2_2 = ((1f - _e42) * (1f + _e45));
    let _e50 = t_15;
    let _e53 = c_14;
    let _e55 = t_15;
    let _e59 = t_15;
    let _e61 = sin2_2;
    let _e63 = t_15;
    return min(((((2f * _e50.a) * _e53) / _e55.denS) * (1f + ((_e59.q2_ + _e61) / _e63.denP))), 1f);
}

fn fresnelConductorRgb(cosTheta_14: f32, n_22: vec3<f32>, k_8: vec3<f32>) -> vec3<f32> {
    var cosTheta_15: f32;
    var n_23: vec3<f32>;
    var k_9: vec3<f32>;

    cosTheta_15 = cosTheta_14;
    n_23 = n_22;
    k_9 = k_8;
    let _e15 = cosTheta_15;
    let _e16 = n_23;
    let _e18 = k_9;
    let _e20 = fresnelConductor(_e15, _e16.x, _e18.x);
    let _e21 = cosTheta_15;
    let _e22 = n_23;
    let _e24 = k_9;
    let _e26 = fresnelConductor(_e21, _e22.y, _e24.y);
    let _e27 = cosTheta_15;
    let _e28 = n_23;
    let _e30 = k_9;
    let _e32 = fresnelConductor(_e27, _e28.z, _e30.z);
    return vec3<f32>(_e20, _e26, _e32);
}

fn schlickWeight(cosTheta_16: f32) -> f32 {
    var cosTheta_17: f32;
    var m_4: f32;
    var m2_: f32;

    cosTheta_17 = cosTheta_16;
    let _e12 = cosTheta_17;
    m_4 = (1f - clamp(_e12, 0f, 1f));
    let _e18 = m_4;
    let _e19 = m_4;
    m2_ = (_e18 * _e19);
    let _e22 = m2_;
    let _e23 = m2_;
    let _e25 = m_4;
    return ((_e22 * _e23) * _e25);
}

fn fresnelSchlick(cosTheta_18: f32, f0_: f32) -> f32 {
    var cosTheta_19: f32;
    var f0_1: f32;

    cosTheta_19 = cosTheta_18;
    f0_1 = f0_;
    let _e13 = f0_1;
    let _e15 = f0_1;
    let _e17 = cosTheta_19;
    let _e18 = schlickWeight(_e17);
    return (_e13 + ((1f - _e15) * _e18));
}

fn fresnelSchlickRgb(cosTheta_20: f32, f0_2: vec3<f32>) -> vec3<f32> {
    var cosTheta_21: f32;
    var f0_3: vec3<f32>;

    cosTheta_21 = cosTheta_20;
    f0_3 = f0_2;
    let _e13 = f0_3;
    let _e16 = f0_3;
    let _e18 = cosTheta_21;
    let _e19 = schlickWeight(_e18);
    return (_e13 + ((vec3(1f) - _e16) * _e19));
}

fn ggxD(m_5: Tilt, alpha_18: f32) -> f32 {
    var m_6: Tilt;
    var alpha_19: f32;
    var width_1: f32;
    var spread: f32;
    var t_16: f32;

    m_6 = m_5;
    alpha_19 = alpha_18;
    let _e13 = alpha_19;
    let _e14 = m_6;
    width_1 = (_e13 * _e14.z);
    let _e18 = m_6;
    let _e20 = width_1;
    let _e21 = width_1;
    spread = (_e18.p + (_e20 * _e21));
    let _e25 = spread;
    let _e28 = alpha_19;
    if !(((_e25 > 0f) && (_e28 > 0f))) {
        return 0f;
    }
    let _e34 = alpha_19;
    let _e35 = m_6;
    let _e37 = m_6;
    let _e39 = m_6;
    let _e44 = spread;
    t_16 = ((_e34 * (_e35.p + (_e37.z * _e39.z))) / _e44);
    let _e47 = t_16;
    let _e48 = t_16;
    return ((_e47 * _e48) / BSDF_PI);
}

fn ggxRoot(w_8: Tilt, alpha_20: f32) -> f32 {
    var w_9: Tilt;
    var alpha_21: f32;

    w_9 = w_8;
    alpha_21 = alpha_20;
    let _e13 = w_9;
    let _e15 = w_9;
    let _e18 = alpha_21;
    let _e19 = alpha_21;
    let _e21 = w_9;
    return sqrt(((_e13.z * _e15.z) + ((_e18 * _e19) * _e21.p)));
}

fn ggxLambda(w_10: Tilt, alpha_22: f32) -> f32 {
    var w_11: Tilt;
    var alpha_23: f32;
    var slope_1: f32;
    var below: f32;
    var local_18: f32;

    w_11 = w_10;
    alpha_23 = alpha_22;
    let _e13 = alpha_23;
    let _e14 = alpha_23;
    let _e16 = w_11;
    slope_1 = ((_e13 * _e14) * _e16.p);
    let _e21 = w_11;
    let _e24 = w_11;
    let _e26 = w_11;
    let _e27 = alpha_23;
    let _e28 = ggxRoot(_e26, _e27);
    below = ((2f * _e21.z) * (_e24.z + _e28));
    let _e32 = slope_1;
    let _e34 = below;
    if (_e32 < (1000000000000000000000000000000f * _e34)) {
        let _e37 = slope_1;
        let _e38 = below;
        local_18 = (_e37 / _e38);
    } else {
        local_18 = 1000000000000000000000000000000f;
    }
    let _e42 = local_18;
    return _e42;
}

fn ggxG1(w_12: Tilt, alpha_24: f32) -> f32 {
    var w_13: Tilt;
    var alpha_25: f32;
    var sum_5: f32;
    var local_19: f32;

    w_13 = w_12;
    alpha_25 = alpha_24;
    let _e13 = w_13;
    let _e15 = w_13;
    let _e16 = alpha_25;
    let _e17 = ggxRoot(_e15, _e16);
    sum_5 = (_e13.z + _e17);
    let _e20 = sum_5;
    if (_e20 > 0f) {
        let _e24 = w_13;
        let _e27 = sum_5;
        local_19 = ((2f * _e24.z) / _e27);
    } else {
        local_19 = 0f;
    }
    let _e31 = local_19;
    return _e31;
}

fn ggxG2(wi_16: Tilt, wo_16: Tilt, alpha_26: f32) -> f32 {
    var wi_17: Tilt;
    var wo_17: Tilt;
    var alpha_27: f32;

    wi_17 = wi_16;
    wo_17 = wo_16;
    alpha_27 = alpha_26;
    let _e15 = wi_17;
    let _e16 = alpha_27;
    let _e17 = ggxG1(_e15, _e16);
    let _e18 = wo_17;
    let _e19 = alpha_27;
    let _e20 = ggxG1(_e18, _e19);
    return (_e17 * _e20);
}

fn ggxG2Correlated(wi_18: Tilt, wo_18: Tilt, alpha_28: f32) -> f32 {
    var wi_19: Tilt;
    var wo_19: Tilt;
    var alpha_29: f32;
    var sum_6: f32;
    var local_20: f32;

    wi_19 = wi_18;
    wo_19 = wo_18;
    alpha_29 = alpha_28;
    let _e15 = wi_19;
    let _e16 = alpha_29;
    let _e17 = ggxRoot(_e15, _e16);
    let _e18 = wo_19;
    let _e21 = wo_19;
    let _e22 = alpha_29;
    let _e23 = ggxRoot(_e21, _e22);
    let _e24 = wi_19;
    sum_6 = ((_e17 * _e18.z) + (_e23 * _e24.z));
    let _e29 = sum_6;
    if (_e29 > 0f) {
        let _e33 = wi_19;
        let _e36 = wo_19;
        let _e39 = sum_6;
        local_20 = (((2f * _e33.z) * _e36.z) / _e39);
    } else {
        local_20 = 0f;
    }
    let _e43 = local_20;
    return _e43;
}

fn ggxV(wi_20: Tilt, wo_20: Tilt, alpha_30: f32) -> f32 {
    var wi_21: Tilt;
    var wo_21: Tilt;
    var alpha_31: f32;
    var sum_7: f32;
    var local_21: f32;

    wi_21 = wi_20;
    wo_21 = wo_20;
    alpha_31 = alpha_30;
    let _e15 = wi_21;
    let _e17 = wi_21;
    let _e18 = alpha_31;
    let _e19 = ggxRoot(_e17, _e18);
    let _e21 = wo_21;
    let _e23 = wo_21;
    let _e24 = alpha_31;
    let _e25 = ggxRoot(_e23, _e24);
    sum_7 = ((_e15.z + _e19) * (_e21.z + _e25));
    let _e29 = sum_7;
    if (_e29 > 0.0000000000000000000000000000000000001f) {
        let _e33 = sum_7;
        local_21 = (1f / _e33);
    } else {
        local_21 = 0f;
    }
    let _e37 = local_21;
    return _e37;
}

fn ggxVCorrelated(wi_22: Tilt, wo_22: Tilt, alpha_32: f32) -> f32 {
    var wi_23: Tilt;
    var wo_23: Tilt;
    var alpha_33: f32;
    var sum_8: f32;
    var local_22: f32;

    wi_23 = wi_22;
    wo_23 = wo_22;
    alpha_33 = alpha_32;
    let _e15 = wi_23;
    let _e16 = alpha_33;
    let _e17 = ggxRoot(_e15, _e16);
    let _e18 = wo_23;
    let _e21 = wo_23;
    let _e22 = alpha_33;
    let _e23 = ggxRoot(_e21, _e22);
    let _e24 = wi_23;
    sum_8 = ((_e17 * _e18.z) + (_e23 * _e24.z));
    let _e29 = sum_8;
    if (_e29 > 0.0000000000000000000000000000000000001f) {
        let _e33 = sum_8;
        local_22 = (0.5f / _e33);
    } else {
        local_22 = 0f;
    }
    let _e37 = local_22;
    return _e37;
}

fn ggxPdf(m_7: Tilt, alpha_34: f32) -> f32 {
    var m_8: Tilt;
    var alpha_35: f32;

    m_8 = m_7;
    alpha_35 = alpha_34;
    let _e13 = m_8;
    let _e14 = alpha_35;
    let _e15 = ggxD(_e13, _e14);
    let _e16 = m_8;
    let _e17 = tiltCos(_e16);
    return (_e15 * _e17);
}

fn ggxPdfVisible(f_9: Facet, alpha_36: f32) -> f32 {
    var f_10: Facet;
    var alpha_37: f32;

    f_10 = f_9;
    alpha_37 = alpha_36;
    let _e13 = f_10;
    if !(_e13.exists) {
        return 0f;
    }
    let _e18 = f_10;
    let _e21 = f_10;
    let _e23 = alpha_37;
    let _e24 = ggxD(_e21.h, _e23);
    let _e26 = f_10;
    let _e29 = f_10;
    let _e31 = alpha_37;
    let _e32 = ggxRoot(_e29.wo, _e31);
    return (((2f * _e18.woDotM) * _e24) / (_e26.wo.z + _e32));
}

fn ggxSample(alpha_38: f32, u_3: vec2<f32>) -> vec3<f32> {
    var alpha_39: f32;
    var u_4: vec2<f32>;
    var phi_1: f32;
    var across_5: f32;

    alpha_39 = alpha_38;
    u_4 = u_3;
    let _e16 = u_4;
    phi_1 = (6.2831855f * _e16.y);
    let _e20 = alpha_39;
    let _e21 = u_4;
    across_5 = (_e20 * sqrt(_e21.x));
    let _e26 = across_5;
    let _e27 = phi_1;
    let _e30 = across_5;
    let _e31 = phi_1;
    let _e35 = u_4;
    return normalize(vec3<f32>((_e26 * cos(_e27)), (_e30 * sin(_e31)), sqrt(max((1f - _e35.x), 0f))));
}

fn ggxSampleVisible(wo_24: vec3<f32>, alpha_40: vec2<f32>, u_5: vec2<f32>) -> vec3<f32> {
    var wo_25: vec3<f32>;
    var alpha_41: vec2<f32>;
    var u_6: vec2<f32>;
    var seen: vec3<f32>;
    var phi_2: f32;
    var z_5: f32;
    var r_6: f32;
    var h_6: vec3<f32>;
    var m_9: vec3<f32>;
    var s_2: f32;
    var local_23: vec3<f32>;

    wo_25 = wo_24;
    alpha_41 = alpha_40;
    u_6 = u_5;
    let _e15 = alpha_41;
    let _e17 = wo_25;
    let _e20 = alpha_41;
    let _e22 = wo_25;
    let _e25 = wo_25;
    seen = normalize(vec3<f32>((_e15.x * _e17.x), (_e20.y * _e22.y), _e25.z));
    let _e33 = u_6;
    phi_2 = (6.2831855f * _e33.x);
    let _e38 = u_6;
    let _e42 = seen;
    let _e46 = seen;
    z_5 = (((1f - _e38.y) * (1f + _e42.z)) - _e46.z);
    let _e51 = z_5;
    let _e54 = z_5;
    r_6 = sqrt(clamp(((1f - _e51) * (1f + _e54)), 0f, 1f));
    let _e62 = r_6;
    let _e63 = phi_2;
    let _e66 = r_6;
    let _e67 = phi_2;
    let _e70 = z_5;
    let _e72 = seen;
    h_6 = (vec3<f32>((_e62 * cos(_e63)), (_e66 * sin(_e67)), _e70) + _e72);
    let _e75 = alpha_41;
    let _e77 = h_6;
    let _e80 = alpha_41;
    let _e82 = h_6;
    let _e85 = h_6;
    m_9 = vec3<f32>((_e75.x * _e77.x), (_e80.y * _e82.y), max(_e85.z, 0f));
    let _e91 = m_9;
    let _e92 = m_9;
    s_2 = dot(_e91, _e92);
    let _e95 = s_2;
    if (_e95 > 0f) {
        let _e98 = m_9;
        let _e99 = s_2;
        local_23 = (_e98 * inverseSqrt(_e99));
    } else {
        local_23 = vec3<f32>(0f, 0f, 1f);
    }
    let _e107 = local_23;
    return _e107;
}

fn ggxAnisoWidths(alpha_42: f32, strength_4: f32) -> vec2<f32> {
    var alpha_43: f32;
    var strength_5: f32;
    var across_6: f32;

    alpha_43 = alpha_42;
    strength_5 = strength_4;
    let _e13 = alpha_43;
    across_6 = max(_e13, 0.001f);
    let _e17 = across_6;
    let _e19 = across_6;
    let _e21 = strength_5;
    let _e23 = strength_5;
    let _e26 = across_6;
    return vec2<f32>((_e17 + (((1f - _e19) * _e21) * _e23)), _e26);
}

fn ggxAnisoD(h_7: vec3<f32>, alpha_44: vec2<f32>) -> f32 {
    var h_8: vec3<f32>;
    var alpha_45: vec2<f32>;
    var area: f32;
    var p_2: f32;
    var spread_1: f32;
    var t_17: f32;

    h_8 = h_7;
    alpha_45 = alpha_44;
    let _e13 = alpha_45;
    let _e15 = alpha_45;
    area = (_e13.x * _e15.y);
    let _e19 = alpha_45;
    let _e23 = alpha_45;
    if !(((_e19.x > 0f) && (_e23.y > 0f))) {
        return 0f;
    }
    let _e30 = h_8;
    let _e32 = h_8;
    let _e35 = alpha_45;
    let _e37 = alpha_45;
    let _e41 = h_8;
    let _e43 = h_8;
    let _e46 = alpha_45;
    let _e48 = alpha_45;
    p_2 = (((_e30.x * _e32.x) * (_e35.y / _e37.x)) + ((_e41.y * _e43.y) * (_e46.x / _e48.y)));
    let _e54 = p_2;
    let _e55 = area;
    let _e56 = h_8;
    let _e59 = h_8;
    spread_1 = (_e54 + ((_e55 * _e56.z) * _e59.z));
    let _e64 = spread_1;
    if !((_e64 > 0f)) {
        return 0f;
    }
    let _e69 = area;
    let _e71 = h_8;
    let _e72 = h_8;
    let _e75 = spread_1;
    t_17 = ((sqrt(_e69) * dot(_e71, _e72)) / _e75);
    let _e78 = t_17;
    let _e79 = t_17;
    return ((_e78 * _e79) / BSDF_PI);
}

fn ggxAnisoRoot(w_14: vec3<f32>, alpha_46: vec2<f32>) -> f32 {
    var w_15: vec3<f32>;
    var alpha_47: vec2<f32>;

    w_15 = w_14;
    alpha_47 = alpha_46;
    let _e13 = alpha_47;
    let _e15 = w_15;
    let _e18 = alpha_47;
    let _e20 = w_15;
    let _e23 = w_15;
    return length(vec3<f32>((_e13.x * _e15.x), (_e18.y * _e20.y), _e23.z));
}

fn ggxAnisoLambda(w_16: vec3<f32>, alpha_48: vec2<f32>) -> f32 {
    var w_17: vec3<f32>;
    var alpha_49: vec2<f32>;
    var z_6: f32;
    var x_1: f32;
    var y: f32;
    var slope_2: f32;
    var below_1: f32;
    var local_24: f32;

    w_17 = w_16;
    alpha_49 = alpha_48;
    let _e13 = w_17;
    z_6 = abs(_e13.z);
    let _e17 = alpha_49;
    let _e19 = w_17;
    x_1 = (_e17.x * _e19.x);
    let _e23 = alpha_49;
    let _e25 = w_17;
    y = (_e23.y * _e25.y);
    let _e29 = x_1;
    let _e30 = x_1;
    let _e32 = y;
    let _e33 = y;
    slope_2 = ((_e29 * _e30) + (_e32 * _e33));
    let _e38 = z_6;
    let _e40 = z_6;
    let _e41 = w_17;
    let _e42 = alpha_49;
    let _e43 = ggxAnisoRoot(_e41, _e42);
    below_1 = ((2f * _e38) * (_e40 + _e43));
    let _e47 = slope_2;
    let _e49 = below_1;
    if (_e47 < (1000000000000000000000000000000f * _e49)) {
        let _e52 = slope_2;
        let _e53 = below_1;
        local_24 = (_e52 / _e53);
    } else {
        local_24 = 1000000000000000000000000000000f;
    }
    let _e57 = local_24;
    return _e57;
}

fn ggxAnisoG1(w_18: vec3<f32>, alpha_50: vec2<f32>) -> f32 {
    var w_19: vec3<f32>;
    var alpha_51: vec2<f32>;
    var sum_9: f32;
    var local_25: f32;

    w_19 = w_18;
    alpha_51 = alpha_50;
    let _e13 = w_19;
    let _e16 = w_19;
    let _e17 = alpha_51;
    let _e18 = ggxAnisoRoot(_e16, _e17);
    sum_9 = (abs(_e13.z) + _e18);
    let _e21 = sum_9;
    if (_e21 > 0f) {
        let _e25 = w_19;
        let _e29 = sum_9;
        local_25 = ((2f * abs(_e25.z)) / _e29);
    } else {
        local_25 = 0f;
    }
    let _e33 = local_25;
    return _e33;
}

fn ggxAnisoG2(wi_24: vec3<f32>, wo_26: vec3<f32>, alpha_52: vec2<f32>) -> f32 {
    var wi_25: vec3<f32>;
    var wo_27: vec3<f32>;
    var alpha_53: vec2<f32>;

    wi_25 = wi_24;
    wo_27 = wo_26;
    alpha_53 = alpha_52;
    let _e15 = wi_25;
    let _e16 = alpha_53;
    let _e17 = ggxAnisoG1(_e15, _e16);
    let _e18 = wo_27;
    let _e19 = alpha_53;
    let _e20 = ggxAnisoG1(_e18, _e19);
    return (_e17 * _e20);
}

fn ggxAnisoV(wi_26: vec3<f32>, wo_28: vec3<f32>, alpha_54: vec2<f32>) -> f32 {
    var wi_27: vec3<f32>;
    var wo_29: vec3<f32>;
    var alpha_55: vec2<f32>;
    var sum_10: f32;
    var local_26: f32;

    wi_27 = wi_26;
    wo_29 = wo_28;
    alpha_55 = alpha_54;
    let _e15 = wi_27;
    let _e18 = wi_27;
    let _e19 = alpha_55;
    let _e20 = ggxAnisoRoot(_e18, _e19);
    let _e22 = wo_29;
    let _e25 = wo_29;
    let _e26 = alpha_55;
    let _e27 = ggxAnisoRoot(_e25, _e26);
    sum_10 = ((abs(_e15.z) + _e20) * (abs(_e22.z) + _e27));
    let _e31 = sum_10;
    if (_e31 > 0f) {
        let _e35 = sum_10;
        local_26 = (1f / _e35);
    } else {
        local_26 = 0f;
    }
    let _e39 = local_26;
    return _e39;
}

fn ggxAnisoVCorrelated(wi_28: vec3<f32>, wo_30: vec3<f32>, alpha_56: vec2<f32>) -> f32 {
    var wi_29: vec3<f32>;
    var wo_31: vec3<f32>;
    var alpha_57: vec2<f32>;
    var sum_11: f32;
    var local_27: f32;

    wi_29 = wi_28;
    wo_31 = wo_30;
    alpha_57 = alpha_56;
    let _e15 = wi_29;
    let _e16 = alpha_57;
    let _e17 = ggxAnisoRoot(_e15, _e16);
    let _e18 = wo_31;
    let _e22 = wo_31;
    let _e23 = alpha_57;
    let _e24 = ggxAnisoRoot(_e22, _e23);
    let _e25 = wi_29;
    sum_11 = ((_e17 * abs(_e18.z)) + (_e24 * abs(_e25.z)));
    let _e31 = sum_11;
    if (_e31 > 0f) {
        let _e35 = sum_11;
        local_27 = (0.5f / _e35);
    } else {
        local_27 = 0f;
    }
    let _e39 = local_27;
    return _e39;
}

fn ggxAnisoPdf(h_9: vec3<f32>, alpha_58: vec2<f32>) -> f32 {
    var h_10: vec3<f32>;
    var alpha_59: vec2<f32>;

    h_10 = h_9;
    alpha_59 = alpha_58;
    let _e13 = h_10;
    let _e14 = alpha_59;
    let _e15 = ggxAnisoD(_e13, _e14);
    let _e16 = h_10;
    let _e17 = tilt(_e16);
    let _e18 = tiltCos(_e17);
    return (_e15 * _e18);
}

fn ggxAnisoPdfVisible(f_11: Facet, h_11: vec3<f32>, wo_32: vec3<f32>, alpha_60: vec2<f32>) -> f32 {
    var f_12: Facet;
    var h_12: vec3<f32>;
    var wo_33: vec3<f32>;
    var alpha_61: vec2<f32>;

    f_12 = f_11;
    h_12 = h_11;
    wo_33 = wo_32;
    alpha_61 = alpha_60;
    let _e17 = f_12;
    if !(_e17.exists) {
        return 0f;
    }
    let _e22 = f_12;
    let _e25 = h_12;
    let _e26 = alpha_61;
    let _e27 = ggxAnisoD(_e25, _e26);
    let _e29 = wo_33;
    let _e32 = wo_33;
    let _e33 = alpha_61;
    let _e34 = ggxAnisoRoot(_e32, _e33);
    return (((2f * _e22.woDotM) * _e27) / (abs(_e29.z) + _e34));
}

fn ggxAnisoSample(alpha_62: vec2<f32>, u_7: vec2<f32>) -> vec3<f32> {
    var alpha_63: vec2<f32>;
    var u_8: vec2<f32>;
    var phi_3: f32;
    var across_7: f32;

    alpha_63 = alpha_62;
    u_8 = u_7;
    let _e16 = u_8;
    phi_3 = (6.2831855f * _e16.y);
    let _e20 = u_8;
    across_7 = sqrt(_e20.x);
    let _e24 = alpha_63;
    let _e26 = across_7;
    let _e28 = phi_3;
    let _e31 = alpha_63;
    let _e33 = across_7;
    let _e35 = phi_3;
    let _e39 = u_8;
    return normalize(vec3<f32>(((_e24.x * _e26) * cos(_e28)), ((_e31.y * _e33) * sin(_e35)), sqrt(max((1f - _e39.x), 0f))));
}

fn log1pPositive(x_2: f32) -> f32 {
    var x_3: f32;
    var t_18: f32;
    var whole: bool;
    var local_28: f32;
    var h_13: f32;
    var y_1: f32;
    var y2_: f32;
    var tail: f32;
    var local_29: f32;

    x_3 = x_2;
    let _e11 = x_3;
    if (_e11 > 1f) {
        let _e15 = x_3;
        return log((1f + _e15));
    }
    let _e18 = x_3;
    t_18 = max(_e18, 0f);
    let _e22 = t_18;
    whole = (_e22 <= 0.4f);
    let _e26 = whole;
    if _e26 {
        let _e27 = t_18;
        local_28 = _e27;
    } else {
        let _e28 = t_18;
        let _e31 = t_18;
        local_28 = (_e28 / (1f + sqrt((1f + _e31))));
    }
    let _e37 = local_28;
    h_13 = _e37;
    let _e39 = h_13;
    let _e41 = h_13;
    y_1 = (_e39 / (2f + _e41));
    let _e45 = y_1;
    let _e46 = y_1;
    y2_ = (_e45 * _e46);
    let _e52 = y2_;
    let _e56 = y2_;
    tail = (0.05882353f + (_e52 * (0.05263158f + (_e56 * 0.04761905f))));
    let _e68 = y2_;
    let _e72 = y2_;
    let _e76 = y2_;
    let _e77 = tail;
    tail = (0.09090909f + (_e68 * (0.07692308f + (_e72 * (0.06666667f + (_e76 * _e77))))));
    let _e87 = y2_;
    let _e91 = y2_;
    let _e95 = y2_;
    let _e96 = tail;
    tail = (0.2f + (_e87 * (0.14285715f + (_e91 * (0.11111111f + (_e95 * _e96))))));
    let _e103 = whole;
    if _e103 {
        local_29 = 2f;
    } else {
        local_29 = 4f;
    }
    let _e107 = local_29;
    let _e108 = y_1;
    let _e111 = y2_;
    let _e115 = y2_;
    let _e116 = tail;
    return ((_e107 * _e108) * (1f + (_e111 * (0.33333334f + (_e115 * _e116)))));
}

fn multipleScatteringF(eI: f32, eO: f32, eAvg: f32) -> f32 {
    var eI_1: f32;
    var eO_1: f32;
    var eAvg_1: f32;
    var lost: f32;
    var local_30: f32;

    eI_1 = eI;
    eO_1 = eO;
    eAvg_1 = eAvg;
    let _e16 = eAvg_1;
    lost = (1f - _e16);
    let _e19 = lost;
    if (_e19 > 0f) {
        let _e23 = eI_1;
        let _e26 = eO_1;
        let _e29 = lost;
        local_30 = (((1f - _e23) * (1f - _e26)) / (BSDF_PI * _e29));
    } else {
        local_30 = 0f;
    }
    let _e34 = local_30;
    return _e34;
}

fn multipleFresnel(f_13: f32, eAvg_2: f32) -> f32 {
    var f_14: f32;
    var eAvg_3: f32;
    var left: f32;
    var local_31: f32;

    f_14 = f_13;
    eAvg_3 = eAvg_2;
    let _e14 = f_14;
    let _e16 = eAvg_3;
    left = (1f - (_e14 * (1f - _e16)));
    let _e21 = left;
    if (_e21 > 0f) {
        let _e24 = f_14;
        let _e25 = f_14;
        let _e27 = eAvg_3;
        let _e29 = left;
        local_31 = (((_e24 * _e25) * _e27) / _e29);
    } else {
        local_31 = 0f;
    }
    let _e33 = local_31;
    return _e33;
}

fn multipleFresnelRgb(f_15: vec3<f32>, eAvg_4: f32) -> vec3<f32> {
    var f_16: vec3<f32>;
    var eAvg_5: f32;

    f_16 = f_15;
    eAvg_5 = eAvg_4;
    let _e13 = f_16;
    let _e15 = eAvg_5;
    let _e16 = multipleFresnel(_e13.x, _e15);
    let _e17 = f_16;
    let _e19 = eAvg_5;
    let _e20 = multipleFresnel(_e17.y, _e19);
    let _e21 = f_16;
    let _e23 = eAvg_5;
    let _e24 = multipleFresnel(_e21.z, _e23);
    return vec3<f32>(_e16, _e20, _e24);
}

fn multipleScatteringSplit(r1_: f32, t1_: f32, cosO_2: f32, alpha_64: f32, eta_28: f32) -> SplitEnergy {
    var r1_1: f32;
    var t1_1: f32;
    var cosO_3: f32;
    var alpha_65: f32;
    var eta_29: f32;
    var lost_1: f32;
    var local_32: f32;
    var outward: f32;
    var e: SplitEnergy;

    r1_1 = r1_;
    t1_1 = t1_;
    cosO_3 = cosO_2;
    alpha_65 = alpha_64;
    eta_29 = eta_28;
    let _e20 = r1_1;
    let _e22 = t1_1;
    lost_1 = max(((1f - _e20) - _e22), 0f);
    let _e27 = eta_29;
    if (_e27 < 1f) {
        let _e31 = eta_29;
        let _e32 = eta_29;
        let _e34 = cosO_3;
        let _e38 = alpha_65;
        local_32 = (1f - (((_e31 * _e32) * _e34) * (0.35f + (0.55f * min(_e38, 1f)))));
    } else {
        local_32 = 0f;
    }
    let _e47 = local_32;
    outward = _e47;
    let _e51 = r1_1;
    let _e52 = lost_1;
    let _e53 = outward;
    e.reflected = (_e51 + (_e52 * _e53));
    let _e58 = e;
    e.transmitted = (1f - _e58.reflected);
    let _e61 = e;
    return _e61;
}

fn phongExponent(alpha_66: f32) -> f32 {
    var alpha_67: f32;
    var a2_1: f32;

    alpha_67 = alpha_66;
    let _e11 = alpha_67;
    let _e12 = alpha_67;
    a2_1 = max((_e11 * _e12), 0.000000000000000001f);
    let _e19 = a2_1;
    let _e22 = a2_1;
    return max(((2f * (1f - _e19)) / _e22), 0f);
}

fn phongAlpha(exponent: f32) -> f32 {
    var exponent_1: f32;

    exponent_1 = exponent;
    let _e12 = exponent_1;
    return sqrt((2f / (max(_e12, 0f) + 2f)));
}

fn phongD(m_10: Tilt, exponent_2: f32) -> f32 {
    var m_11: Tilt;
    var exponent_3: f32;
    var z2_: f32;
    var tan2_: f32;

    m_11 = m_10;
    exponent_3 = exponent_2;
    let _e13 = m_11;
    let _e15 = m_11;
    z2_ = (_e13.z * _e15.z);
    let _e19 = z2_;
    if !((_e19 > 0f)) {
        return 0f;
    }
    let _e24 = m_11;
    let _e26 = z2_;
    tan2_ = min((_e24.p / _e26), 10000000000000000000000000000000000000f);
    let _e31 = exponent_3;
    let _e40 = exponent_3;
    let _e42 = tan2_;
    let _e43 = log1pPositive(_e42);
    return (((_e31 + 2f) / 6.2831855f) * exp(((-0.5f * _e40) * _e43)));
}

fn phongG1(w_20: Tilt, exponent_4: f32) -> f32 {
    var w_21: Tilt;
    var exponent_5: f32;

    w_21 = w_20;
    exponent_5 = exponent_4;
    let _e13 = w_21;
    let _e14 = exponent_5;
    let _e15 = phongAlpha(_e14);
    let _e16 = beckmannG1(_e13, _e15);
    return _e16;
}

fn phongG2(wi_30: Tilt, wo_34: Tilt, exponent_6: f32) -> f32 {
    var wi_31: Tilt;
    var wo_35: Tilt;
    var exponent_7: f32;

    wi_31 = wi_30;
    wo_35 = wo_34;
    exponent_7 = exponent_6;
    let _e15 = wi_31;
    let _e16 = wo_35;
    let _e17 = exponent_7;
    let _e18 = phongAlpha(_e17);
    let _e19 = beckmannG2(_e15, _e16, _e18);
    return _e19;
}

fn phongV(wi_32: Tilt, wo_36: Tilt, exponent_8: f32) -> f32 {
    var wi_33: Tilt;
    var wo_37: Tilt;
    var exponent_9: f32;

    wi_33 = wi_32;
    wo_37 = wo_36;
    exponent_9 = exponent_8;
    let _e15 = wi_33;
    let _e16 = wo_37;
    let _e17 = exponent_9;
    let _e18 = phongAlpha(_e17);
    let _e19 = beckmannV(_e15, _e16, _e18);
    return _e19;
}

fn phongPdf(m_12: Tilt, exponent_10: f32) -> f32 {
    var m_13: Tilt;
    var exponent_11: f32;

    m_13 = m_12;
    exponent_11 = exponent_10;
    let _e13 = m_13;
    let _e14 = exponent_11;
    let _e15 = phongD(_e13, _e14);
    let _e16 = m_13;
    let _e17 = tiltCos(_e16);
    return (_e15 * _e17);
}

fn phongSample(exponent_12: f32, u_9: vec2<f32>) -> vec3<f32> {
    var exponent_13: f32;
    var u_10: vec2<f32>;
    var phi_4: f32;
    var z_7: f32;
    var r_7: f32;

    exponent_13 = exponent_12;
    u_10 = u_9;
    let _e16 = u_10;
    phi_4 = (6.2831855f * _e16.y);
    let _e21 = u_10;
    let _e25 = exponent_13;
    z_7 = exp((log((1f - _e21.x)) / (_e25 + 2f)));
    let _e32 = z_7;
    let _e35 = z_7;
    r_7 = sqrt(max(((1f - _e32) * (1f + _e35)), 0f));
    let _e42 = r_7;
    let _e43 = phi_4;
    let _e46 = r_7;
    let _e47 = phi_4;
    let _e50 = z_7;
    return vec3<f32>((_e42 * cos(_e43)), (_e46 * sin(_e47)), _e50);
}

fn reflectionLobe(f_17: Facet, d: f32, v_10: f32) -> f32 {
    var f_18: Facet;
    var d_1: f32;
    var v_11: f32;
    var local_33: f32;

    f_18 = f_17;
    d_1 = d;
    v_11 = v_10;
    let _e15 = f_18;
    let _e17 = d_1;
    if (_e15.exists && (_e17 > 0f)) {
        let _e21 = d_1;
        let _e22 = v_11;
        local_33 = (_e21 * _e22);
    } else {
        local_33 = 0f;
    }
    let _e26 = local_33;
    return _e26;
}

fn reflectionF(f_19: Facet, d_2: f32, v_12: f32, eta_30: f32) -> f32 {
    var f_20: Facet;
    var d_3: f32;
    var v_13: f32;
    var eta_31: f32;

    f_20 = f_19;
    d_3 = d_2;
    v_13 = v_12;
    eta_31 = eta_30;
    let _e17 = f_20;
    let _e18 = d_3;
    let _e19 = v_13;
    let _e20 = f_20;
    let _e22 = f_20;
    let _e24 = eta_31;
    let _e25 = fresnelDielectric(_e20.woDotM, _e22.g, _e24);
    let _e27 = reflectionLobe(_e17, _e18, (_e19 * _e25));
    return _e27;
}

fn reflectionFCos(f_21: Facet, d_4: f32, v_14: f32, eta_32: f32) -> f32 {
    var f_22: Facet;
    var d_5: f32;
    var v_15: f32;
    var eta_33: f32;

    f_22 = f_21;
    d_5 = d_4;
    v_15 = v_14;
    eta_33 = eta_32;
    let _e17 = f_22;
    let _e18 = d_5;
    let _e19 = v_15;
    let _e20 = eta_33;
    let _e21 = reflectionF(_e17, _e18, _e19, _e20);
    let _e22 = f_22;
    return (_e21 * _e22.wi.z);
}

fn reflectionPdf(f_23: Facet, pdfM: f32) -> f32 {
    var f_24: Facet;
    var pdfM_1: f32;

    f_24 = f_23;
    pdfM_1 = pdfM;
    let _e13 = pdfM_1;
    let _e14 = f_24;
    let _e15 = reflectionJacobian(_e14);
    return (_e13 * _e15);
}

fn reflectAbout(wo_38: vec3<f32>, wm: vec3<f32>) -> vec3<f32> {
    var wo_39: vec3<f32>;
    var wm_1: vec3<f32>;

    wo_39 = wo_38;
    wm_1 = wm;
    let _e14 = wo_39;
    let _e15 = wm_1;
    let _e18 = wm_1;
    let _e20 = wo_39;
    return (((2f * dot(_e14, _e15)) * _e18) - _e20);
}

fn stirlingRest(x_4: f32) -> f32 {
    var x_5: f32;
    var r_8: f32;
    var r2_: f32;

    x_5 = x_4;
    let _e12 = x_5;
    r_8 = (1f / _e12);
    let _e15 = r_8;
    let _e16 = r_8;
    r2_ = (_e15 * _e16);
    let _e19 = r_8;
    let _e23 = r2_;
    let _e27 = r2_;
    let _e31 = r2_;
    let _e35 = r2_;
    return (_e19 * (0.083333336f - (_e23 * (0.0027777778f - (_e27 * (0.0007936508f - (_e31 * (0.0005952381f - (_e35 / 1188f)))))))));
}

fn smithG2Beta(lambdaI: f32, lambdaO: f32) -> f32 {
    var lambdaI_1: f32;
    var lambdaO_1: f32;
    var x_6: f32;
    var y_2: f32;
    var power: f32;
    var rest_4: f32;
    var root: f32;
    var product_3: f32;
    var k_10: i32 = 0i;

    lambdaI_1 = lambdaI;
    lambdaO_1 = lambdaO;
    let _e14 = lambdaI_1;
    x_6 = (7f + _e14);
    let _e18 = lambdaO_1;
    y_2 = (7f + _e18);
    let _e21 = x_6;
    let _e22 = y_2;
    let _e23 = x_6;
    let _e25 = log1pPositive((_e22 / _e23));
    let _e27 = y_2;
    let _e28 = x_6;
    let _e29 = y_2;
    let _e31 = log1pPositive((_e28 / _e29));
    power = ((_e21 * _e25) + (_e27 * _e31));
    let _e35 = x_6;
    let _e36 = stirlingRest(_e35);
    let _e37 = y_2;
    let _e38 = stirlingRest(_e37);
    let _e40 = x_6;
    let _e41 = y_2;
    let _e43 = stirlingRest((_e40 + _e41));
    rest_4 = ((_e36 + _e38) - _e43);
    let _e46 = power;
    root = exp((-(_e46) / 6f));
    let _e56 = x_6;
    let _e59 = y_2;
    let _e64 = rest_4;
    product_3 = (sqrt((6.2831855f * ((1f / _e56) + (1f / _e59)))) * exp(_e64));
    loop {
        let _e70 = k_10;
        if !((_e70 < 6i)) {
            break;
        }
        {
            let _e77 = x_6;
            x_6 = (_e77 - 1f);
            let _e80 = y_2;
            y_2 = (_e80 - 1f);
            let _e83 = product_3;
            let _e84 = x_6;
            let _e85 = y_2;
            let _e87 = x_6;
            let _e89 = root;
            let _e91 = x_6;
            let _e92 = y_2;
            let _e96 = y_2;
            product_3 = (_e83 * ((((_e84 + _e85) / _e87) * _e89) * (((_e91 + _e92) + 1f) / _e96)));
        }
        continuing {
            let _e74 = k_10;
            k_10 = (_e74 + 1i);
        }
    }
    let _e100 = product_3;
    return min(_e100, 1f);
}

fn ggxG2Beta(wi_34: Tilt, wo_40: Tilt, alpha_68: f32) -> f32 {
    var wi_35: Tilt;
    var wo_41: Tilt;
    var alpha_69: f32;

    wi_35 = wi_34;
    wo_41 = wo_40;
    alpha_69 = alpha_68;
    let _e15 = wi_35;
    let _e16 = alpha_69;
    let _e17 = ggxLambda(_e15, _e16);
    let _e18 = wo_41;
    let _e19 = alpha_69;
    let _e20 = ggxLambda(_e18, _e19);
    let _e21 = smithG2Beta(_e17, _e20);
    return _e21;
}

fn ggxVBeta(wi_36: Tilt, wo_42: Tilt, alpha_70: f32) -> f32 {
    var wi_37: Tilt;
    var wo_43: Tilt;
    var alpha_71: f32;
    var cosines: f32;
    var local_34: f32;

    wi_37 = wi_36;
    wo_43 = wo_42;
    alpha_71 = alpha_70;
    let _e16 = wi_37;
    let _e19 = wo_43;
    cosines = ((4f * _e16.z) * _e19.z);
    let _e23 = cosines;
    if (_e23 > 0f) {
        let _e26 = wi_37;
        let _e27 = wo_43;
        let _e28 = alpha_71;
        let _e29 = ggxG2Beta(_e26, _e27, _e28);
        let _e30 = cosines;
        local_34 = (_e29 / _e30);
    } else {
        local_34 = 0f;
    }
    let _e34 = local_34;
    return _e34;
}

fn filmBaseIor(f0_4: f32) -> f32 {
    var f0_5: f32;
    var r_9: f32;

    f0_5 = f0_4;
    let _e11 = f0_5;
    r_9 = sqrt(clamp(_e11, 0f, 0.9999f));
    let _e18 = r_9;
    let _e21 = r_9;
    return ((1f + _e18) / (1f - _e21));
}

fn filmAmplitudes(nearIor: f32, nearCos: f32, farIor: f32, farCos: f32) -> vec2<f32> {
    var nearIor_1: f32;
    var nearCos_1: f32;
    var farIor_1: f32;
    var farCos_1: f32;
    var across_8: f32;
    var within: f32;
    var local_35: f32;
    var local_36: f32;

    nearIor_1 = nearIor;
    nearCos_1 = nearCos;
    farIor_1 = farIor;
    farCos_1 = farCos;
    let _e17 = nearIor_1;
    let _e18 = nearCos_1;
    let _e20 = farIor_1;
    let _e21 = farCos_1;
    across_8 = ((_e17 * _e18) + (_e20 * _e21));
    let _e25 = farIor_1;
    let _e26 = nearCos_1;
    let _e28 = nearIor_1;
    let _e29 = farCos_1;
    within = ((_e25 * _e26) + (_e28 * _e29));
    let _e33 = across_8;
    if (_e33 > 0f) {
        let _e36 = nearIor_1;
        let _e37 = nearCos_1;
        let _e39 = farIor_1;
        let _e40 = farCos_1;
        let _e43 = across_8;
        local_35 = (((_e36 * _e37) - (_e39 * _e40)) / _e43);
    } else {
        local_35 = 0f;
    }
    let _e47 = local_35;
    let _e48 = within;
    if (_e48 > 0f) {
        let _e51 = farIor_1;
        let _e52 = nearCos_1;
        let _e54 = nearIor_1;
        let _e55 = farCos_1;
        let _e58 = within;
        local_36 = (((_e51 * _e52) - (_e54 * _e55)) / _e58);
    } else {
        local_36 = 0f;
    }
    let _e62 = local_36;
    return vec2<f32>(_e47, _e62);
}

fn filmCosines(opd: f32) -> vec3<f32> {
    var opd_1: f32;
    var k_11: f32;
    var k2_: f32;
    var x_7: f32;
    var y_3: f32;
    var z_8: f32;

    opd_1 = opd;
    let _e14 = opd_1;
    k_11 = (6.2831855f * _e14);
    let _e17 = k_11;
    let _e18 = k_11;
    k2_ = (_e17 * _e18);
    let _e23 = k_11;
    let _e29 = k2_;
    let _e35 = k_11;
    let _e41 = k2_;
    x_7 = (((0.8462f * cos((1681000f * _e23))) * exp((-4327800000f * _e29))) + ((0.1538f * cos((2239900f * _e35))) * exp((-4528200000f * _e41))));
    let _e48 = k_11;
    let _e53 = k2_;
    y_3 = (cos((1795300f * _e48)) * exp((-9304600000f * _e53)));
    let _e59 = k_11;
    let _e64 = k2_;
    z_8 = (cos((2208400f * _e59)) * exp((-6612100000f * _e64)));
    let _e70 = x_7;
    let _e73 = y_3;
    let _e77 = z_8;
    let _e82 = x_7;
    let _e85 = y_3;
    let _e89 = z_8;
    let _e93 = x_7;
    let _e96 = y_3;
    let _e100 = z_8;
    return vec3<f32>((((2.689655f * _e70) - (1.275862f * _e73)) - (0.413793f * _e77)), (((-1.022107f * _e82) + (1.978286f * _e85)) + (0.043821f * _e89)), (((0.061225f * _e93) - (0.22449f * _e96)) + (1.163265f * _e100)));
}

fn filmSeries(a_24: f32, b_15: f32, cosines_1: vec3<f32>) -> f32 {
    var a_25: f32;
    var b_16: f32;
    var cosines_2: vec3<f32>;
    var q: f32;
    var t_19: f32;

    a_25 = a_24;
    b_16 = b_15;
    cosines_2 = cosines_1;
    let _e15 = a_25;
    let _e17 = b_16;
    q = (-(_e15) * _e17);
    let _e21 = a_25;
    let _e22 = a_25;
    let _e26 = b_16;
    let _e27 = b_16;
    let _e32 = q;
    let _e33 = q;
    t_19 = (((1f - (_e21 * _e22)) * (1f - (_e26 * _e27))) / max((1f - (_e32 * _e33)), 0.000000001f));
    let _e41 = t_19;
    let _e44 = q;
    let _e46 = cosines_2;
    let _e48 = q;
    let _e49 = cosines_2;
    let _e51 = q;
    let _e52 = cosines_2;
    return (1f - (_e41 * (1f + ((2f * _e44) * (_e46.x + (_e48 * (_e49.y + (_e51 * _e52.z))))))));
}

fn filmChannel(first: vec2<f32>, sin2_3: f32, filmIor: f32, filmCos: f32, baseIor: f32, cosines_3: vec3<f32>) -> f32 {
    var first_1: vec2<f32>;
    var sin2_4: f32;
    var filmIor_1: f32;
    var filmCos_1: f32;
    var baseIor_1: f32;
    var cosines_4: vec3<f32>;
    var baseCos: f32;
    var second: vec2<f32>;

    first_1 = first;
    sin2_4 = sin2_3;
    filmIor_1 = filmIor;
    filmCos_1 = filmCos;
    baseIor_1 = baseIor;
    cosines_4 = cosines_3;
    let _e22 = sin2_4;
    let _e23 = baseIor_1;
    let _e24 = baseIor_1;
    baseCos = sqrt(max((1f - (_e22 / (_e23 * _e24))), 0f));
    let _e32 = filmIor_1;
    let _e33 = filmCos_1;
    let _e34 = baseIor_1;
    let _e35 = baseCos;
    let _e36 = filmAmplitudes(_e32, _e33, _e34, _e35);
    second = _e36;
    let _e39 = first_1;
    let _e41 = second;
    let _e43 = cosines_4;
    let _e44 = filmSeries(_e39.x, _e41.x, _e43);
    let _e45 = first_1;
    let _e47 = second;
    let _e49 = cosines_4;
    let _e50 = filmSeries(_e45.y, _e47.y, _e49);
    return clamp((0.5f * (_e44 + _e50)), 0f, 1f);
}

fn filmFresnel(cosTheta_22: f32, filmIor_2: f32, thickness: f32, baseIor_2: vec3<f32>) -> vec3<f32> {
    var cosTheta_23: f32;
    var filmIor_3: f32;
    var thickness_1: f32;
    var baseIor_3: vec3<f32>;
    var c_15: f32;
    var sin2_5: f32;
    var filmCos_2: f32;
    var first_2: vec2<f32>;
    var opd_2: f32;
    var one: vec3<f32>;
    var two: vec3<f32>;
    var three: vec3<f32>;

    cosTheta_23 = cosTheta_22;
    filmIor_3 = filmIor_2;
    thickness_1 = thickness;
    baseIor_3 = baseIor_2;
    let _e17 = cosTheta_23;
    c_15 = clamp(_e17, 0f, 1f);
    let _e22 = c_15;
    if !((_e22 > 0f)) {
        return vec3(1f);
    }
    let _e29 = c_15;
    let _e30 = c_15;
    sin2_5 = (1f - (_e29 * _e30));
    let _e35 = sin2_5;
    let _e36 = filmIor_3;
    let _e37 = filmIor_3;
    filmCos_2 = sqrt(max((1f - (_e35 / (_e36 * _e37))), 0f));
    let _e46 = c_15;
    let _e47 = filmIor_3;
    let _e48 = filmCos_2;
    let _e49 = filmAmplitudes(1f, _e46, _e47, _e48);
    first_2 = _e49;
    let _e52 = filmIor_3;
    let _e54 = thickness_1;
    let _e56 = filmCos_2;
    opd_2 = (((0.000000002f * _e52) * _e54) * _e56);
    let _e59 = opd_2;
    let _e60 = filmCosines(_e59);
    one = _e60;
    let _e63 = opd_2;
    let _e65 = filmCosines((2f * _e63));
    two = _e65;
    let _e68 = opd_2;
    let _e70 = filmCosines((3f * _e68));
    three = _e70;
    let _e72 = first_2;
    let _e73 = sin2_5;
    let _e74 = filmIor_3;
    let _e75 = filmCos_2;
    let _e76 = baseIor_3;
    let _e78 = one;
    let _e80 = two;
    let _e82 = three;
    let _e85 = filmChannel(_e72, _e73, _e74, _e75, _e76.x, vec3<f32>(_e78.x, _e80.x, _e82.x));
    let _e86 = first_2;
    let _e87 = sin2_5;
    let _e88 = filmIor_3;
    let _e89 = filmCos_2;
    let _e90 = baseIor_3;
    let _e92 = one;
    let _e94 = two;
    let _e96 = three;
    let _e99 = filmChannel(_e86, _e87, _e88, _e89, _e90.y, vec3<f32>(_e92.y, _e94.y, _e96.y));
    let _e100 = first_2;
    let _e101 = sin2_5;
    let _e102 = filmIor_3;
    let _e103 = filmCos_2;
    let _e104 = baseIor_3;
    let _e106 = one;
    let _e108 = two;
    let _e110 = three;
    let _e113 = filmChannel(_e100, _e101, _e102, _e103, _e104.z, vec3<f32>(_e106.z, _e108.z, _e110.z));
    return vec3<f32>(_e85, _e99, _e113);
}

fn transmissionScatter(f_25: Facet, d_6: f32, v_16: f32, eta_34: f32) -> f32 {
    var f_26: Facet;
    var d_7: f32;
    var v_17: f32;
    var eta_35: f32;
    var through: f32;

    f_26 = f_25;
    d_7 = d_6;
    v_17 = v_16;
    eta_35 = eta_34;
    let _e17 = f_26;
    let _e19 = d_7;
    if !((_e17.exists && (_e19 > 0f))) {
        return 0f;
    }
    let _e25 = f_26;
    let _e27 = f_26;
    let _e29 = eta_35;
    let _e30 = fresnelTransmitted(_e25.woDotM, _e27.g, _e29);
    through = _e30;
    let _e33 = eta_35;
    let _e35 = f_26;
    let _e38 = v_17;
    let _e40 = eta_35;
    let _e41 = f_26;
    let _e44 = f_26;
    let _e47 = d_7;
    let _e50 = through;
    return (((((4f * _e33) * _e35.wiDotM) * _e38) * (((_e40 * _e41.woDotM) / _e44.s) * _e47)) * _e50);
}

fn transmissionF(f_27: Facet, d_8: f32, v_18: f32, eta_36: f32) -> f32 {
    var f_28: Facet;
    var d_9: f32;
    var v_19: f32;
    var eta_37: f32;
    var scatter: f32;
    var local_37: f32;

    f_28 = f_27;
    d_9 = d_8;
    v_19 = v_18;
    eta_37 = eta_36;
    let _e17 = f_28;
    let _e18 = d_9;
    let _e19 = v_19;
    let _e20 = eta_37;
    let _e21 = transmissionScatter(_e17, _e18, _e19, _e20);
    scatter = _e21;
    let _e23 = f_28;
    if _e23.exists {
        let _e25 = scatter;
        let _e26 = eta_37;
        let _e27 = eta_37;
        local_37 = (_e25 / (_e26 * _e27));
    } else {
        local_37 = 0f;
    }
    let _e32 = local_37;
    return _e32;
}

fn transmissionFCos(f_29: Facet, d_10: f32, v_20: f32, eta_38: f32) -> f32 {
    var f_30: Facet;
    var d_11: f32;
    var v_21: f32;
    var eta_39: f32;

    f_30 = f_29;
    d_11 = d_10;
    v_21 = v_20;
    eta_39 = eta_38;
    let _e17 = f_30;
    let _e18 = d_11;
    let _e19 = v_21;
    let _e20 = eta_39;
    let _e21 = transmissionF(_e17, _e18, _e19, _e20);
    let _e22 = f_30;
    return (_e21 * _e22.wi.z);
}

fn transmissionPdf(f_31: Facet, pdfM_2: f32, eta_40: f32) -> f32 {
    var f_32: Facet;
    var pdfM_3: f32;
    var eta_41: f32;

    f_32 = f_31;
    pdfM_3 = pdfM_2;
    eta_41 = eta_40;
    let _e15 = pdfM_3;
    let _e16 = f_32;
    let _e17 = eta_41;
    let _e18 = transmissionJacobian(_e16, _e17);
    return (_e15 * _e18);
}

fn refractAbout(wo_44: vec3<f32>, wm_2: vec3<f32>, eta_42: f32) -> vec3<f32> {
    var wo_45: vec3<f32>;
    var wm_3: vec3<f32>;
    var eta_43: f32;
    var local_38: f32;
    var side_2: f32;
    var c_16: f32;
    var g_6: f32;
    var along_2: f32;

    wo_45 = wo_44;
    wm_3 = wm_2;
    eta_43 = eta_42;
    let _e15 = wo_45;
    let _e16 = wm_3;
    if (dot(_e15, _e16) < 0f) {
        local_38 = -1f;
    } else {
        local_38 = 1f;
    }
    let _e24 = local_38;
    side_2 = _e24;
    let _e26 = wo_45;
    let _e27 = wm_3;
    c_16 = abs(dot(_e26, _e27));
    let _e31 = c_16;
    let _e32 = eta_43;
    let _e33 = fresnelG(_e31, _e32);
    g_6 = _e33;
    let _e35 = eta_43;
    if (_e35 == 1f) {
        let _e38 = wo_45;
        return -(_e38);
    }
    let _e40 = g_6;
    let _e43 = eta_43;
    if !(((_e40 > 0f) && (_e43 > 0f))) {
        return vec3(0f);
    }
    let _e51 = eta_43;
    let _e54 = eta_43;
    let _e57 = c_16;
    let _e58 = g_6;
    along_2 = (((1f - _e51) * (1f + _e54)) / (_e57 + _e58));
    let _e62 = side_2;
    let _e63 = along_2;
    let _e65 = wm_3;
    let _e67 = wo_45;
    let _e69 = eta_43;
    return ((((_e62 * _e63) * _e65) - _e67) / vec3(_e69));
}

fn bsdfNoValues() -> BsdfValues {
    var r_10: BsdfValues;

    r_10.d = 0f;
    r_10.g = 0f;
    r_10.gCorrelated = 0f;
    r_10.fresnel = 0f;
    r_10.transmitted = 0f;
    r_10.f = 0f;
    r_10.fCos = 0f;
    r_10.fCorrelated = 0f;
    r_10.pdfD = 0f;
    r_10.pdfVisible = 0f;
    let _e33 = r_10;
    return _e33;
}

fn bsdfShape(f_33: Facet, distribution: i32, alpha_72: f32) -> BsdfShape {
    var f_34: Facet;
    var distribution_1: i32;
    var alpha_73: f32;
    var r_11: BsdfShape;

    f_34 = f_33;
    distribution_1 = distribution;
    alpha_73 = alpha_72;
    r_11.vCorrelated = 0f;
    let _e21 = distribution_1;
    if (_e21 == BSDF_GGX) {
        {
            let _e24 = f_34;
            let _e26 = alpha_73;
            let _e27 = ggxD(_e24.h, _e26);
            r_11.d = _e27;
            let _e29 = f_34;
            let _e31 = f_34;
            let _e33 = alpha_73;
            let _e34 = ggxG2(_e29.wi, _e31.wo, _e33);
            r_11.g = _e34;
            let _e36 = f_34;
            let _e38 = f_34;
            let _e40 = alpha_73;
            let _e41 = ggxV(_e36.wi, _e38.wo, _e40);
            r_11.v = _e41;
            let _e43 = f_34;
            let _e45 = f_34;
            let _e47 = alpha_73;
            let _e48 = ggxVCorrelated(_e43.wi, _e45.wo, _e47);
            r_11.vCorrelated = _e48;
        }
    } else {
        let _e49 = distribution_1;
        if (_e49 == BSDF_BECKMANN) {
            {
                let _e52 = f_34;
                let _e54 = alpha_73;
                let _e55 = beckmannD(_e52.h, _e54);
                r_11.d = _e55;
                let _e57 = f_34;
                let _e59 = f_34;
                let _e61 = alpha_73;
                let _e62 = beckmannG2(_e57.wi, _e59.wo, _e61);
                r_11.g = _e62;
                let _e64 = f_34;
                let _e66 = f_34;
                let _e68 = alpha_73;
                let _e69 = beckmannV(_e64.wi, _e66.wo, _e68);
                r_11.v = _e69;
            }
        } else {
            {
                let _e71 = f_34;
                let _e73 = alpha_73;
                let _e74 = phongD(_e71.h, _e73);
                r_11.d = _e74;
                let _e76 = f_34;
                let _e78 = f_34;
                let _e80 = alpha_73;
                let _e81 = phongG2(_e76.wi, _e78.wo, _e80);
                r_11.g = _e81;
                let _e83 = f_34;
                let _e85 = f_34;
                let _e87 = alpha_73;
                let _e88 = phongV(_e83.wi, _e85.wo, _e87);
                r_11.v = _e88;
            }
        }
    }
    let _e89 = r_11;
    return _e89;
}

fn bsdfValues(f_35: Facet, surface: BsdfSurface) -> BsdfValues {
    var f_36: Facet;
    var surface_1: BsdfSurface;
    var r_12: BsdfValues;
    var shape: BsdfShape;
    var ggx: bool;
    var metal: bool;
    var pdfM_4: f32;
    var local_39: f32;
    var pdfVisibleM: f32;
    var local_40: f32;
    var local_41: f32;
    var local_42: f32;

    f_36 = f_35;
    surface_1 = surface;
    let _e16 = bsdfNoValues();
    r_12 = _e16;
    let _e18 = f_36;
    if !(_e18.exists) {
        let _e21 = r_12;
        return _e21;
    }
    let _e22 = f_36;
    let _e23 = surface_1;
    let _e25 = surface_1;
    let _e27 = bsdfShape(_e22, _e23.distribution, _e25.alpha);
    shape = _e27;
    let _e29 = surface_1;
    ggx = (_e29.distribution == BSDF_GGX);
    let _e33 = surface_1;
    metal = (_e33.eta == 0f);
    let _e38 = shape;
    let _e40 = f_36;
    let _e42 = tiltCos(_e40.h);
    pdfM_4 = (_e38.d * _e42);
    let _e45 = ggx;
    if _e45 {
        let _e46 = f_36;
        let _e47 = surface_1;
        let _e49 = ggxPdfVisible(_e46, _e47.alpha);
        local_39 = _e49;
    } else {
        local_39 = 0f;
    }
    let _e52 = local_39;
    pdfVisibleM = _e52;
    let _e55 = shape;
    r_12.d = _e55.d;
    let _e58 = shape;
    r_12.g = _e58.g;
    let _e61 = ggx;
    if _e61 {
        let _e62 = f_36;
        let _e64 = f_36;
        let _e66 = surface_1;
        let _e68 = ggxG2Correlated(_e62.wi, _e64.wo, _e66.alpha);
        local_40 = _e68;
    } else {
        local_40 = 0f;
    }
    let _e71 = local_40;
    r_12.gCorrelated = _e71;
    let _e73 = metal;
    if _e73 {
        let _e74 = f_36;
        let _e76 = surface_1;
        let _e78 = surface_1;
        let _e80 = fresnelConductor(_e74.woDotM, _e76.n, _e78.k);
        local_41 = _e80;
    } else {
        let _e81 = f_36;
        let _e83 = f_36;
        let _e85 = surface_1;
        let _e87 = fresnelDielectric(_e81.woDotM, _e83.g, _e85.eta);
        local_41 = _e87;
    }
    let _e89 = local_41;
    r_12.fresnel = _e89;
    let _e91 = metal;
    if _e91 {
        let _e92 = f_36;
        let _e94 = surface_1;
        let _e96 = surface_1;
        let _e98 = fresnelAbsorbed(_e92.woDotM, _e94.n, _e96.k);
        local_42 = _e98;
    } else {
        let _e99 = f_36;
        let _e101 = f_36;
        let _e103 = surface_1;
        let _e105 = fresnelTransmitted(_e99.woDotM, _e101.g, _e103.eta);
        local_42 = _e105;
    }
    let _e107 = local_42;
    r_12.transmitted = _e107;
    let _e108 = surface_1;
    if _e108.transmits {
        {
            let _e111 = f_36;
            let _e112 = shape;
            let _e114 = shape;
            let _e116 = surface_1;
            let _e118 = transmissionScatter(_e111, _e112.d, _e114.v, _e116.eta);
            r_12.f = _e118;
            let _e120 = f_36;
            let _e121 = shape;
            let _e123 = shape;
            let _e125 = surface_1;
            let _e127 = transmissionScatter(_e120, _e121.d, _e123.vCorrelated, _e125.eta);
            r_12.fCorrelated = _e127;
            let _e129 = f_36;
            let _e130 = pdfM_4;
            let _e131 = surface_1;
            let _e133 = transmissionPdf(_e129, _e130, _e131.eta);
            r_12.pdfD = _e133;
            let _e135 = f_36;
            let _e136 = pdfVisibleM;
            let _e137 = surface_1;
            let _e139 = transmissionPdf(_e135, _e136, _e137.eta);
            r_12.pdfVisible = _e139;
        }
    } else {
        {
            let _e141 = f_36;
            let _e142 = shape;
            let _e144 = shape;
            let _e146 = r_12;
            let _e149 = reflectionLobe(_e141, _e142.d, (_e144.v * _e146.fresnel));
            r_12.f = _e149;
            let _e151 = f_36;
            let _e152 = shape;
            let _e154 = shape;
            let _e156 = r_12;
            let _e159 = reflectionLobe(_e151, _e152.d, (_e154.vCorrelated * _e156.fresnel));
            r_12.fCorrelated = _e159;
            let _e161 = f_36;
            let _e162 = pdfM_4;
            let _e163 = reflectionPdf(_e161, _e162);
            r_12.pdfD = _e163;
            let _e165 = f_36;
            let _e166 = pdfVisibleM;
            let _e167 = reflectionPdf(_e165, _e166);
            r_12.pdfVisible = _e167;
        }
    }
    let _e169 = r_12;
    let _e171 = f_36;
    r_12.fCos = (_e169.f * _e171.wi.z);
    let _e175 = r_12;
    return _e175;
}

fn bsdfFacet(wi_38: vec3<f32>, wo_46: vec3<f32>, n_24: vec3<f32>, surface_2: BsdfSurface) -> Facet {
    var wi_39: vec3<f32>;
    var wo_47: vec3<f32>;
    var n_25: vec3<f32>;
    var surface_3: BsdfSurface;

    wi_39 = wi_38;
    wo_47 = wo_46;
    n_25 = n_24;
    surface_3 = surface_2;
    let _e20 = surface_3;
    if _e20.transmits {
        let _e22 = wi_39;
        let _e23 = wo_47;
        let _e24 = n_25;
        let _e25 = surface_3;
        let _e27 = transmissionFacet(_e22, _e23, _e24, _e25.eta);
        return _e27;
    }
    let _e28 = wi_39;
    let _e29 = wo_47;
    let _e30 = n_25;
    let _e31 = surface_3;
    let _e33 = reflectionFacet(_e28, _e29, _e30, _e31.eta);
    return _e33;
}

fn bsdfFacetCompensated(wi_40: vec3<f32>, wo_48: vec3<f32>, n_26: vec3<f32>, surface_4: BsdfSurface) -> Facet {
    var wi_41: vec3<f32>;
    var wo_49: vec3<f32>;
    var n_27: vec3<f32>;
    var surface_5: BsdfSurface;

    wi_41 = wi_40;
    wo_49 = wo_48;
    n_27 = n_26;
    surface_5 = surface_4;
    let _e20 = surface_5;
    if _e20.transmits {
        let _e22 = wi_41;
        let _e23 = wo_49;
        let _e24 = n_27;
        let _e25 = surface_5;
        let _e27 = preciseTransmissionFacet(_e22, _e23, _e24, _e25.eta);
        return _e27;
    }
    let _e28 = wi_41;
    let _e29 = wo_49;
    let _e30 = n_27;
    let _e31 = surface_5;
    let _e33 = preciseReflectionFacet(_e28, _e29, _e30, _e31.eta);
    return _e33;
}

fn srgbFromLinear(linear: f32) -> f32 {
    var linear_1: f32;
    var v_22: f32;
    var local_43: f32;

    linear_1 = linear;
    let _e14 = linear_1;
    v_22 = clamp(_e14, 0f, 1f);
    let _e19 = v_22;
    if (_e19 <= 0.0031308f) {
        let _e23 = v_22;
        local_43 = (12.92f * _e23);
    } else {
        let _e26 = v_22;
        local_43 = ((1.055f * pow(_e26, 0.41666666f)) - 0.055f);
    }
    let _e35 = local_43;
    return _e35;
}

fn linearFromSrgb(encoded: f32) -> f32 {
    var encoded_1: f32;
    var v_23: f32;
    var local_44: f32;

    encoded_1 = encoded;
    let _e14 = encoded_1;
    v_23 = clamp(_e14, 0f, 1f);
    let _e19 = v_23;
    if (_e19 <= 0.04045f) {
        let _e22 = v_23;
        local_44 = (_e22 / 12.92f);
    } else {
        let _e25 = v_23;
        local_44 = pow(((_e25 + 0.055f) / 1.055f), 2.4f);
    }
    let _e33 = local_44;
    return _e33;
}

fn srgbFromLinearRgb(linear_2: vec3<f32>) -> vec3<f32> {
    var linear_3: vec3<f32>;

    linear_3 = linear_2;
    let _e14 = linear_3;
    let _e16 = srgbFromLinear(_e14.x);
    let _e17 = linear_3;
    let _e19 = srgbFromLinear(_e17.y);
    let _e20 = linear_3;
    let _e22 = srgbFromLinear(_e20.z);
    return vec3<f32>(_e16, _e19, _e22);
}

fn linearFromSrgbRgb(encoded_2: vec3<f32>) -> vec3<f32> {
    var encoded_3: vec3<f32>;

    encoded_3 = encoded_2;
    let _e14 = encoded_3;
    let _e16 = linearFromSrgb(_e14.x);
    let _e17 = encoded_3;
    let _e19 = linearFromSrgb(_e17.y);
    let _e20 = encoded_3;
    let _e22 = linearFromSrgb(_e20.z);
    return vec3<f32>(_e16, _e19, _e22);
}

fn tonemapInput(radiance: vec3<f32>) -> vec3<f32> {
    var radiance_1: vec3<f32>;

    radiance_1 = radiance;
    let _e15 = radiance_1;
    return clamp(_e15, vec3(0f), vec3(65504f));
}

fn tonemapMaxOf(c_17: vec3<f32>) -> f32 {
    var c_18: vec3<f32>;

    c_18 = c_17;
    let _e15 = c_18;
    let _e17 = c_18;
    let _e19 = c_18;
    return max(_e15.x, max(_e17.y, _e19.z));
}

fn tonemapNeutral(radiance_2: vec3<f32>) -> vec3<f32> {
    var radiance_3: vec3<f32>;
    var start: f32 = 0.76f;
    var desaturation: f32 = 0.15f;
    var c_19: vec3<f32>;
    var darkest: f32;
    var local_45: f32;
    var peak: f32;
    var room: f32;
    var compressed: f32;
    var keep: f32;

    radiance_3 = radiance_2;
    let _e21 = radiance_3;
    let _e22 = tonemapInput(_e21);
    c_19 = _e22;
    let _e24 = c_19;
    let _e26 = c_19;
    let _e28 = c_19;
    darkest = min(_e24.x, min(_e26.y, _e28.z));
    let _e33 = c_19;
    let _e34 = darkest;
    if (_e34 < 0.08f) {
        let _e37 = darkest;
        let _e39 = darkest;
        let _e41 = darkest;
        local_45 = (_e37 - ((6.25f * _e39) * _e41));
    } else {
        local_45 = 0.04f;
    }
    let _e46 = local_45;
    c_19 = (_e33 - vec3(_e46));
    let _e49 = c_19;
    let _e50 = tonemapMaxOf(_e49);
    peak = _e50;
    let _e52 = peak;
    let _e53 = start;
    if (_e52 < _e53) {
        let _e55 = c_19;
        return _e55;
    }
    let _e57 = start;
    room = (1f - _e57);
    let _e61 = room;
    let _e62 = room;
    let _e64 = peak;
    let _e65 = start;
    let _e67 = room;
    compressed = (1f - ((_e61 * _e62) / ((_e64 - _e65) + _e67)));
    let _e73 = desaturation;
    let _e74 = peak;
    let _e75 = compressed;
    keep = (1f / ((_e73 * (_e74 - _e75)) + 1f));
    let _e82 = compressed;
    let _e84 = c_19;
    let _e85 = compressed;
    let _e86 = peak;
    let _e89 = keep;
    return clamp(mix(vec3(_e82), (_e84 * (_e85 / _e86)), vec3(_e89)), vec3(0f), vec3(1f));
}

fn tonemapRows(r_13: vec3<f32>, g_7: vec3<f32>, b_17: vec3<f32>, c_20: vec3<f32>) -> vec3<f32> {
    var r_14: vec3<f32>;
    var g_8: vec3<f32>;
    var b_18: vec3<f32>;
    var c_21: vec3<f32>;

    r_14 = r_13;
    g_8 = g_7;
    b_18 = b_17;
    c_21 = c_20;
    let _e21 = r_14;
    let _e22 = c_21;
    let _e24 = g_8;
    let _e25 = c_21;
    let _e27 = b_18;
    let _e28 = c_21;
    return vec3<f32>(dot(_e21, _e22), dot(_e24, _e25), dot(_e27, _e28));
}

fn tonemapAces(radiance_4: vec3<f32>) -> vec3<f32> {
    var radiance_5: vec3<f32>;
    var c_22: vec3<f32>;

    radiance_5 = radiance_4;
    let _e27 = radiance_5;
    let _e28 = tonemapInput(_e27);
    let _e29 = tonemapRows(vec3<f32>(0.59719f, 0.35458f, 0.04823f), vec3<f32>(0.076f, 0.90834f, 0.01566f), vec3<f32>(0.0284f, 0.13383f, 0.83777f), _e28);
    c_22 = _e29;
    let _e31 = c_22;
    let _e32 = c_22;
    let _e40 = c_22;
    let _e42 = c_22;
    c_22 = (((_e31 * (_e32 + vec3(0.0245786f))) - vec3(0.000090537f)) / ((_e40 * ((0.983729f * _e42) + vec3(0.432951f))) + vec3(0.238081f)));
    let _e70 = c_22;
    let _e71 = tonemapRows(vec3<f32>(1.60475f, -0.53108f, -0.07367f), vec3<f32>(-0.10208f, 1.10813f, -0.00605f), vec3<f32>(-0.00327f, -0.07276f, 1.07602f), _e70);
    c_22 = _e71;
    let _e72 = c_22;
    return clamp(_e72, vec3(0f), vec3(1f));
}

fn tonemapAgxCurve(x_8: f32) -> f32 {
    var x_9: f32;
    var pivot: f32 = 0.6060606f;
    var local_46: f32;
    var power_1: f32;
    var local_47: f32;
    var width_2: f32;
    var scale_2: f32;

    x_9 = x_8;
    let _e19 = x_9;
    let _e20 = pivot;
    if (_e19 < _e20) {
        local_46 = 3f;
    } else {
        local_46 = 3.25f;
    }
    let _e25 = local_46;
    power_1 = _e25;
    let _e27 = x_9;
    let _e28 = pivot;
    if (_e27 < _e28) {
        let _e30 = pivot;
        local_47 = _e30;
    } else {
        let _e32 = pivot;
        local_47 = (1f - _e32);
    }
    let _e35 = local_47;
    width_2 = _e35;
    let _e38 = power_1;
    let _e40 = width_2;
    let _e41 = power_1;
    scale_2 = (pow(4f, _e38) - pow(_e40, -(_e41)));
    let _e48 = x_9;
    let _e49 = pivot;
    let _e53 = scale_2;
    let _e54 = x_9;
    let _e55 = pivot;
    let _e58 = power_1;
    let _e64 = power_1;
    return (0.5f + ((2f * (_e48 - _e49)) * pow((1f + (_e53 * pow(abs((_e54 - _e55)), _e58))), (-1f / _e64))));
}

fn tonemapAgx(radiance_6: vec3<f32>) -> vec3<f32> {
    var radiance_7: vec3<f32>;
    var blackStop: f32 = -12.473931f;
    var c_23: vec3<f32>;
    var stops: vec3<f32>;

    radiance_7 = radiance_6;
    let _e30 = radiance_7;
    let _e31 = tonemapInput(_e30);
    let _e32 = tonemapRows(vec3<f32>(0.84247905f, 0.0784336f, 0.079223745f), vec3<f32>(0.042328242f, 0.87846863f, 0.07916613f), vec3<f32>(0.042375654f, 0.0784336f, 0.879143f), _e31);
    c_23 = _e32;
    let _e34 = c_23;
    let _e35 = blackStop;
    let _e40 = blackStop;
    stops = ((log2(max(_e34, vec3(exp2(_e35)))) - vec3(_e40)) / vec3(16.5f));
    let _e47 = stops;
    stops = clamp(_e47, vec3(0f), vec3(1f));
    let _e53 = stops;
    let _e55 = tonemapAgxCurve(_e53.x);
    let _e56 = stops;
    let _e58 = tonemapAgxCurve(_e56.y);
    let _e59 = stops;
    let _e61 = tonemapAgxCurve(_e59.z);
    c_23 = vec3<f32>(_e55, _e58, _e61);
    let _e81 = c_23;
    let _e82 = tonemapRows(vec3<f32>(1.196879f, -0.09802088f, -0.09902974f), vec3<f32>(-0.052896854f, 1.1519032f, -0.098961174f), vec3<f32>(-0.052971635f, -0.09804345f, 1.1510737f), _e81);
    c_23 = _e82;
    let _e83 = c_23;
    return pow(clamp(_e83, vec3(0f), vec3(1f)), vec3(2.2f));
}

fn cubeDirection(face: i32, s_3: f32, t_20: f32) -> vec3<f32> {
    var face_1: i32;
    var s_4: f32;
    var t_21: f32;

    face_1 = face;
    s_4 = s_3;
    t_21 = t_20;
    let _e19 = face_1;
    if (_e19 == 0i) {
        let _e23 = t_21;
        let _e25 = s_4;
        return vec3<f32>(1f, -(_e23), -(_e25));
    }
    let _e28 = face_1;
    if (_e28 == 1i) {
        let _e33 = t_21;
        let _e35 = s_4;
        return vec3<f32>(-1f, -(_e33), _e35);
    }
    let _e37 = face_1;
    if (_e37 == 2i) {
        let _e40 = s_4;
        let _e42 = t_21;
        return vec3<f32>(_e40, 1f, _e42);
    }
    let _e44 = face_1;
    if (_e44 == 3i) {
        let _e47 = s_4;
        let _e50 = t_21;
        return vec3<f32>(_e47, -1f, -(_e50));
    }
    let _e53 = face_1;
    if (_e53 == 4i) {
        let _e56 = s_4;
        let _e57 = t_21;
        return vec3<f32>(_e56, -(_e57), 1f);
    }
    let _e61 = s_4;
    let _e63 = t_21;
    return vec3<f32>(-(_e61), -(_e63), -1f);
}

fn cubeCoordinate(index: i32, size: i32) -> f32 {
    var index_1: i32;
    var size_1: i32;

    index_1 = index;
    size_1 = size;
    let _e18 = index_1;
    let _e23 = size_1;
    return ((((2f * f32(_e18)) + 1f) / f32(_e23)) - 1f);
}

fn cubeTexelDirection(face_2: i32, x_10: i32, y_4: i32, size_2: i32) -> vec3<f32> {
    var face_3: i32;
    var x_11: i32;
    var y_5: i32;
    var size_3: i32;

    face_3 = face_2;
    x_11 = x_10;
    y_5 = y_4;
    size_3 = size_2;
    let _e21 = face_3;
    let _e22 = x_11;
    let _e23 = size_3;
    let _e24 = cubeCoordinate(_e22, _e23);
    let _e25 = y_5;
    let _e26 = size_3;
    let _e27 = cubeCoordinate(_e25, _e26);
    let _e28 = cubeDirection(_e21, _e24, _e27);
    return normalize(_e28);
}

fn cubeLocal(face_4: i32, d_12: vec3<f32>) -> vec3<f32> {
    var face_5: i32;
    var d_13: vec3<f32>;

    face_5 = face_4;
    d_13 = d_12;
    let _e17 = face_5;
    if (_e17 == 0i) {
        let _e20 = d_13;
        let _e23 = d_13;
        let _e26 = d_13;
        return vec3<f32>(-(_e20.z), -(_e23.y), _e26.x);
    }
    let _e29 = face_5;
    if (_e29 == 1i) {
        let _e32 = d_13;
        let _e34 = d_13;
        let _e37 = d_13;
        return vec3<f32>(_e32.z, -(_e34.y), -(_e37.x));
    }
    let _e41 = face_5;
    if (_e41 == 2i) {
        let _e44 = d_13;
        let _e46 = d_13;
        let _e48 = d_13;
        return vec3<f32>(_e44.x, _e46.z, _e48.y);
    }
    let _e51 = face_5;
    if (_e51 == 3i) {
        let _e54 = d_13;
        let _e56 = d_13;
        let _e59 = d_13;
        return vec3<f32>(_e54.x, -(_e56.z), -(_e59.y));
    }
    let _e63 = face_5;
    if (_e63 == 4i) {
        let _e66 = d_13;
        let _e68 = d_13;
        let _e71 = d_13;
        return vec3<f32>(_e66.x, -(_e68.y), _e71.z);
    }
    let _e74 = d_13;
    let _e77 = d_13;
    let _e80 = d_13;
    return vec3<f32>(-(_e74.x), -(_e77.y), -(_e80.z));
}

fn cubeTexel(x_12: i32, y_6: i32, size_4: i32) -> CubeTexel {
    var x_13: i32;
    var y_7: i32;
    var size_5: i32;
    var texel: CubeTexel;
    var z2_1: f32;
    var h2_: f32;

    x_13 = x_12;
    y_7 = y_6;
    size_5 = size_4;
    let _e21 = x_13;
    let _e22 = size_5;
    let _e23 = cubeCoordinate(_e21, _e22);
    let _e24 = y_7;
    let _e25 = size_5;
    let _e26 = cubeCoordinate(_e24, _e25);
    texel.local = normalize(vec3<f32>(_e23, _e26, 1f));
    let _e30 = texel;
    let _e33 = texel;
    z2_1 = (_e30.local.z * _e33.local.z);
    let _e39 = size_5;
    let _e40 = size_5;
    h2_ = (4f / f32((_e39 * _e40)));
    let _e46 = h2_;
    let _e47 = texel;
    let _e51 = z2_1;
    let _e54 = h2_;
    let _e59 = z2_1;
    let _e63 = z2_1;
    texel.solidAngle = (((_e46 * _e47.local.z) * _e51) * (1f + (((_e54 / 24f) * (9f - (15f * _e59))) * _e63)));
    let _e67 = texel;
    return _e67;
}

fn cubeTexelSolidAngle(x_14: i32, y_8: i32, size_6: i32) -> f32 {
    var x_15: i32;
    var y_9: i32;
    var size_7: i32;

    x_15 = x_14;
    y_9 = y_8;
    size_7 = size_6;
    let _e19 = x_15;
    let _e20 = y_9;
    let _e21 = size_7;
    let _e22 = cubeTexel(_e19, _e20, _e21);
    return _e22.solidAngle;
}

fn cubeCapInterval(along_3: f32, outward_1: f32, sinRadius: f32, size_8: i32) -> vec2<i32> {
    var along_4: f32;
    var outward_2: f32;
    var sinRadius_1: f32;
    var size_9: i32;
    var low_5: f32 = -1f;
    var high: f32 = 1f;
    var beside2_: f32;
    var beside: f32;
    var lowOut: f32;
    var highOut: f32;
    var scale_3: f32;
    var first_3: i32;
    var last: i32;

    along_4 = along_3;
    outward_2 = outward_1;
    sinRadius_1 = sinRadius;
    size_9 = size_8;
    let _e26 = along_4;
    let _e27 = along_4;
    let _e29 = outward_2;
    let _e30 = outward_2;
    let _e33 = sinRadius_1;
    let _e34 = sinRadius_1;
    beside2_ = (((_e26 * _e27) + (_e29 * _e30)) - (_e33 * _e34));
    let _e38 = beside2_;
    if (_e38 > 0f) {
        {
            let _e41 = beside2_;
            beside = sqrt(_e41);
            let _e44 = outward_2;
            let _e45 = beside;
            let _e47 = along_4;
            let _e48 = sinRadius_1;
            lowOut = ((_e44 * _e45) + (_e47 * _e48));
            let _e52 = outward_2;
            let _e53 = beside;
            let _e55 = along_4;
            let _e56 = sinRadius_1;
            highOut = ((_e52 * _e53) - (_e55 * _e56));
            let _e60 = lowOut;
            if (_e60 > 0f) {
                let _e63 = low_5;
                let _e64 = along_4;
                let _e65 = beside;
                let _e67 = outward_2;
                let _e68 = sinRadius_1;
                let _e71 = lowOut;
                low_5 = max(_e63, (((_e64 * _e65) - (_e67 * _e68)) / _e71));
            } else {
                let _e74 = along_4;
                if (_e74 >= 0f) {
                    low_5 = 2f;
                }
            }
            let _e78 = highOut;
            if (_e78 > 0f) {
                let _e81 = high;
                let _e82 = along_4;
                let _e83 = beside;
                let _e85 = outward_2;
                let _e86 = sinRadius_1;
                let _e89 = highOut;
                high = min(_e81, (((_e82 * _e83) + (_e85 * _e86)) / _e89));
            } else {
                let _e92 = along_4;
                if (_e92 <= 0f) {
                    high = -2f;
                }
            }
        }
    }
    let _e97 = low_5;
    let _e98 = high;
    if (_e97 > _e98) {
        return vec2<i32>(1i, 0i);
    }
    let _e104 = size_9;
    scale_3 = (0.5f * f32(_e104));
    let _e108 = scale_3;
    let _e109 = low_5;
    first_3 = i32(ceil(((_e108 * (_e109 + 1f)) - 0.5f)));
    let _e118 = scale_3;
    let _e119 = high;
    last = i32(floor(((_e118 * (_e119 + 1f)) - 0.5f)));
    let _e128 = first_3;
    let _e131 = last;
    let _e132 = size_9;
    return vec2<i32>(max(_e128, 0i), min(_e131, (_e132 - 1i)));
}

fn cubeCapFace(l: vec3<f32>, cosRadius: f32, sinRadius_2: f32, size_10: i32) -> CubeRange {
    var l_1: vec3<f32>;
    var cosRadius_1: f32;
    var sinRadius_3: f32;
    var size_11: i32;
    var range: CubeRange;
    var rangeX: vec2<i32>;
    var rangeY: vec2<i32>;

    l_1 = l;
    cosRadius_1 = cosRadius;
    sinRadius_3 = sinRadius_2;
    size_11 = size_10;
    range.firstX = 1i;
    range.lastX = 0i;
    range.firstY = 1i;
    range.lastY = 0i;
    let _e30 = l_1;
    let _e33 = cosRadius_1;
    let _e36 = sinRadius_3;
    if (_e30.z < ((0.57735f * _e33) - (0.8165f * _e36))) {
        let _e40 = range;
        return _e40;
    }
    let _e41 = l_1;
    let _e43 = l_1;
    let _e45 = sinRadius_3;
    let _e46 = size_11;
    let _e47 = cubeCapInterval(_e41.x, _e43.z, _e45, _e46);
    rangeX = _e47;
    let _e49 = l_1;
    let _e51 = l_1;
    let _e53 = sinRadius_3;
    let _e54 = size_11;
    let _e55 = cubeCapInterval(_e49.y, _e51.z, _e53, _e54);
    rangeY = _e55;
    let _e58 = rangeX;
    range.firstX = _e58.x;
    let _e61 = rangeX;
    range.lastX = _e61.y;
    let _e64 = rangeY;
    range.firstY = _e64.x;
    let _e67 = rangeY;
    range.lastY = _e67.y;
    let _e69 = range;
    return _e69;
}

fn cubeCapRow(l_2: vec3<f32>, cosRadius_2: f32, t_22: f32, size_12: i32) -> vec2<i32> {
    var l_3: vec3<f32>;
    var cosRadius_3: f32;
    var t_23: f32;
    var size_13: i32;
    var k_12: f32;
    var a_26: f32;
    var inside: f32;
    var middle: f32;
    var spread_2: f32;
    var scale_4: f32;
    var first_4: i32;
    var last_1: i32;

    l_3 = l_2;
    cosRadius_3 = cosRadius_2;
    t_23 = t_22;
    size_13 = size_12;
    let _e21 = l_3;
    let _e23 = t_23;
    let _e25 = l_3;
    k_12 = ((_e21.y * _e23) + _e25.z);
    let _e29 = cosRadius_3;
    let _e30 = cosRadius_3;
    let _e32 = l_3;
    let _e34 = l_3;
    a_26 = ((_e29 * _e30) - (_e32.x * _e34.x));
    let _e39 = k_12;
    let _e40 = k_12;
    let _e42 = a_26;
    let _e44 = t_23;
    let _e45 = t_23;
    inside = (((_e39 * _e40) - (_e42 * (1f + (_e44 * _e45)))) + 0.0000004f);
    let _e53 = a_26;
    if (_e53 <= 0f) {
        let _e57 = size_13;
        return vec2<i32>(0i, (_e57 - 1i));
    }
    let _e61 = inside;
    if (_e61 < 0f) {
        return vec2<i32>(1i, 0i);
    }
    let _e67 = l_3;
    let _e69 = k_12;
    middle = (_e67.x * _e69);
    let _e72 = cosRadius_3;
    let _e73 = inside;
    spread_2 = (_e72 * sqrt(_e73));
    let _e78 = size_13;
    scale_4 = (0.5f * f32(_e78));
    let _e82 = scale_4;
    let _e83 = middle;
    let _e84 = spread_2;
    let _e86 = a_26;
    first_4 = i32(ceil(((_e82 * (((_e83 - _e84) / _e86) + 1f)) - 0.5f)));
    let _e96 = scale_4;
    let _e97 = middle;
    let _e98 = spread_2;
    let _e100 = a_26;
    last_1 = i32(floor(((_e96 * (((_e97 + _e98) / _e100) + 1f)) - 0.5f)));
    let _e110 = first_4;
    let _e113 = last_1;
    let _e114 = size_13;
    return vec2<i32>(max(_e110, 0i), min(_e113, (_e114 - 1i)));
}

fn gaussianStackLevels(stack: vec4<f32>, sigma: f32) -> StackLevels {
    var stack_1: vec4<f32>;
    var sigma_1: f32;
    var variance: f32;
    var first_5: f32;
    var sharp: f32;
    var levels: StackLevels;
    var height: f32;
    var below_2: f32;
    var share: f32;
    var pair: f32;
    var belowIsEven: bool;
    var local_48: f32;
    var local_49: f32;

    stack_1 = stack;
    sigma_1 = sigma;
    let _e17 = sigma_1;
    let _e18 = sigma_1;
    variance = (_e17 * _e18);
    let _e21 = stack_1;
    let _e23 = stack_1;
    first_5 = (_e21.y * _e23.y);
    let _e27 = stack_1;
    let _e29 = stack_1;
    sharp = (_e27.x * _e29.x);
    let _e34 = variance;
    let _e35 = first_5;
    if (_e34 < _e35) {
        {
            let _e38 = variance;
            let _e39 = sharp;
            let _e41 = first_5;
            let _e42 = sharp;
            levels.even = clamp(((_e38 - _e39) / (_e41 - _e42)), 0f, 1f);
            levels.odd = 0f;
            levels.oddShare = 0f;
            let _e52 = levels;
            return _e52;
        }
    }
    let _e53 = variance;
    let _e54 = first_5;
    let _e57 = stack_1;
    height = min(log2((_e53 / _e54)), _e57.z);
    let _e61 = height;
    let _e63 = stack_1;
    below_2 = min(floor(_e61), (_e63.z - 1f));
    let _e69 = height;
    let _e70 = below_2;
    share = (exp2((_e69 - _e70)) - 1f);
    let _e77 = below_2;
    pair = floor(((0.5f * _e77) + 0.25f));
    let _e83 = below_2;
    let _e85 = pair;
    belowIsEven = ((_e83 - (2f * _e85)) < 0.5f);
    let _e92 = belowIsEven;
    if _e92 {
        let _e93 = pair;
        local_48 = (_e93 + 1f);
    } else {
        let _e96 = pair;
        local_48 = (_e96 + 2f);
    }
    let _e100 = local_48;
    levels.even = _e100;
    let _e102 = pair;
    levels.odd = _e102;
    let _e104 = belowIsEven;
    if _e104 {
        let _e105 = share;
        local_49 = _e105;
    } else {
        let _e107 = share;
        local_49 = (1f - _e107);
    }
    let _e110 = local_49;
    levels.oddShare = _e110;
    let _e111 = levels;
    return _e111;
}

fn environmentRotate(d_14: vec3<f32>, cosAngle: f32, sinAngle: f32) -> vec3<f32> {
    var d_15: vec3<f32>;
    var cosAngle_1: f32;
    var sinAngle_1: f32;

    d_15 = d_14;
    cosAngle_1 = cosAngle;
    sinAngle_1 = sinAngle;
    let _e19 = cosAngle_1;
    let _e20 = d_15;
    let _e23 = sinAngle_1;
    let _e24 = d_15;
    let _e28 = d_15;
    let _e30 = sinAngle_1;
    let _e31 = d_15;
    let _e34 = cosAngle_1;
    let _e35 = d_15;
    return vec3<f32>(((_e19 * _e20.x) - (_e23 * _e24.z)), _e28.y, ((_e30 * _e31.x) + (_e34 * _e35.z)));
}

fn heatKernel(chord2_: f32, inverseTwiceVariance: f32) -> f32 {
    var chord2_1: f32;
    var inverseTwiceVariance_1: f32;
    var theta2_: f32;

    chord2_1 = chord2_;
    inverseTwiceVariance_1 = inverseTwiceVariance;
    let _e19 = chord2_1;
    let _e21 = chord2_1;
    let _e25 = chord2_1;
    theta2_ = (_e19 * (1f + (_e21 * (0.083333336f + (_e25 * 0.011111111f)))));
    let _e35 = theta2_;
    let _e39 = inverseTwiceVariance_1;
    return exp((_e35 * (0.083333336f - _e39)));
}

fn blockCoordinate(x_16: f32, size_14: i32, block: i32, blocks: i32) -> f32 {
    var x_17: f32;
    var size_15: i32;
    var block_1: i32;
    var blocks_1: i32;
    var texel_1: f32;

    x_17 = x_16;
    size_15 = size_14;
    block_1 = block;
    blocks_1 = blocks;
    let _e23 = block_1;
    let _e24 = size_15;
    let _e27 = x_17;
    let _e31 = size_15;
    texel_1 = ((f32((_e23 * _e24)) + (clamp(_e27, 0f, 1f) * f32((_e31 - 1i)))) + 0.5f);
    let _e40 = texel_1;
    let _e41 = size_15;
    let _e42 = blocks_1;
    return (_e40 / f32((_e41 * _e42)));
}

fn tableCoordinate(x_18: f32, size_16: i32) -> f32 {
    var x_19: f32;
    var size_17: i32;

    x_19 = x_18;
    size_17 = size_16;
    let _e19 = x_19;
    let _e20 = size_17;
    let _e23 = blockCoordinate(_e19, _e20, 0i, 1i);
    return _e23;
}

fn energyCoordinate(cosTheta_24: f32, alpha_74: f32) -> vec2<f32> {
    var cosTheta_25: f32;
    var alpha_75: f32;

    cosTheta_25 = cosTheta_24;
    alpha_75 = alpha_74;
    let _e22 = cosTheta_25;
    let _e26 = tableCoordinate(sqrt(max(_e22, 0f)), ENERGY_TABLE_SIZE);
    let _e27 = alpha_75;
    let _e31 = tableCoordinate(sqrt(max(_e27, 0f)), ENERGY_TABLE_SIZE);
    return vec2<f32>(_e26, _e31);
}

fn lobeCoordinateOf(lobe: i32, lobes: i32, cosTheta_26: f32, alpha_76: f32, edge: f32) -> vec3<f32> {
    var lobe_1: i32;
    var lobes_1: i32;
    var cosTheta_27: f32;
    var alpha_77: f32;
    var edge_1: f32;

    lobe_1 = lobe;
    lobes_1 = lobes;
    cosTheta_27 = cosTheta_26;
    alpha_77 = alpha_76;
    edge_1 = edge;
    let _e28 = cosTheta_27;
    let _e32 = tableCoordinate(sqrt(max(_e28, 0f)), LOBE_TABLE_SIZE);
    let _e33 = alpha_77;
    let _e37 = lobe_1;
    let _e38 = lobes_1;
    let _e39 = blockCoordinate(sqrt(max(_e33, 0f)), LOBE_TABLE_SIZE, _e37, _e38);
    let _e40 = edge_1;
    let _e41 = tableCoordinate(_e40, LOBE_TABLE_SLICES);
    return vec3<f32>(_e32, _e39, _e41);
}

fn lobeCoordinate(cosTheta_28: f32, alpha_78: f32, edge_2: f32) -> vec3<f32> {
    var cosTheta_29: f32;
    var alpha_79: f32;
    var edge_3: f32;

    cosTheta_29 = cosTheta_28;
    alpha_79 = alpha_78;
    edge_3 = edge_2;
    let _e26 = cosTheta_29;
    let _e27 = alpha_79;
    let _e28 = edge_3;
    let _e29 = lobeCoordinateOf(0i, 1i, _e26, _e27, _e28);
    return _e29;
}

fn lobeEnergy(texel_2: vec4<f32>) -> LobeEnergy {
    var texel_3: vec4<f32>;
    var e_1: LobeEnergy;

    texel_3 = texel_2;
    let _e22 = texel_3;
    e_1.albedo = _e22.x;
    let _e25 = texel_3;
    e_1.cos1_ = _e25.y;
    let _e28 = texel_3;
    e_1.cos2_ = _e28.z;
    let _e31 = texel_3;
    e_1.share1_ = _e31.w;
    let _e33 = e_1;
    return _e33;
}

fn lobeMean(e_2: LobeEnergy, fAtCos1_: f32, fAtCos2_: f32) -> f32 {
    var e_3: LobeEnergy;
    var fAtCos1_1: f32;
    var fAtCos2_1: f32;

    e_3 = e_2;
    fAtCos1_1 = fAtCos1_;
    fAtCos2_1 = fAtCos2_;
    let _e24 = fAtCos2_1;
    let _e25 = fAtCos1_1;
    let _e26 = e_3;
    return mix(_e24, _e25, _e26.share1_);
}

fn lobeMeanRgb(e_4: LobeEnergy, fAtCos1_2: vec3<f32>, fAtCos2_2: vec3<f32>) -> vec3<f32> {
    var e_5: LobeEnergy;
    var fAtCos1_3: vec3<f32>;
    var fAtCos2_3: vec3<f32>;

    e_5 = e_4;
    fAtCos1_3 = fAtCos1_2;
    fAtCos2_3 = fAtCos2_2;
    let _e24 = fAtCos2_3;
    let _e25 = fAtCos1_3;
    let _e26 = e_5;
    return mix(_e24, _e25, vec3(_e26.share1_));
}

fn edgeShare(f0_6: f32, mean: f32) -> f32 {
    var f0_7: f32;
    var mean_1: f32;
    var local_50: f32;

    f0_7 = f0_6;
    mean_1 = mean;
    let _e22 = mean_1;
    if (_e22 > 0f) {
        let _e26 = f0_7;
        let _e27 = mean_1;
        local_50 = clamp((1f - (_e26 / _e27)), 0f, 1f);
    } else {
        local_50 = 0f;
    }
    let _e35 = local_50;
    return _e35;
}

fn lobeDirection(r_15: vec3<f32>, n_28: vec3<f32>, lean: f32) -> vec3<f32> {
    var r_16: vec3<f32>;
    var n_29: vec3<f32>;
    var lean_1: f32;

    r_16 = r_15;
    n_29 = n_28;
    lean_1 = lean;
    let _e24 = r_16;
    let _e25 = n_29;
    let _e26 = lean_1;
    return normalize(mix(_e24, _e25, vec3(_e26)));
}

fn diffuseAngles(cosTheta_30: f32) -> vec3<f32> {
    var cosTheta_31: f32;
    var c_24: f32;

    cosTheta_31 = cosTheta_30;
    let _e20 = cosTheta_31;
    c_24 = clamp(_e20, 0f, 1f);
    let _e26 = c_24;
    let _e31 = c_24;
    let _e37 = c_24;
    return vec3<f32>(((0.2791f * _e26) + 0.266f), ((0.1798f * _e31) + 0.6974f), (0.1224f * (1f - _e37)));
}

fn stretchedParts(alpha_80: vec2<f32>) -> i32 {
    var alpha_81: vec2<f32>;
    var ratio: f32;
    var local_51: i32;
    var local_52: i32;
    var local_53: i32;

    alpha_81 = alpha_80;
    let _e20 = alpha_81;
    let _e22 = alpha_81;
    ratio = (_e20.x / max(_e22.y, 0.001f));
    let _e28 = ratio;
    if (_e28 < 1.5f) {
        local_53 = 2i;
    } else {
        let _e32 = ratio;
        if (_e32 < 3f) {
            local_52 = 4i;
        } else {
            let _e36 = ratio;
            if (_e36 < 6f) {
                local_51 = 6i;
            } else {
                local_51 = 8i;
            }
            let _e42 = local_51;
            local_52 = _e42;
        }
        let _e44 = local_52;
        local_53 = _e44;
    }
    let _e46 = local_53;
    return _e46;
}

fn stretchedEnergyAlpha(wo_50: vec3<f32>, alpha_82: vec2<f32>) -> f32 {
    var wo_51: vec3<f32>;
    var alpha_83: vec2<f32>;
    var mean_2: f32;
    var apart: f32;
    var side_3: f32;

    wo_51 = wo_50;
    alpha_83 = alpha_82;
    let _e23 = alpha_83;
    let _e25 = alpha_83;
    let _e28 = alpha_83;
    let _e30 = alpha_83;
    mean_2 = (0.5f * ((_e23.x * _e25.x) + (_e28.y * _e30.y)));
    let _e36 = alpha_83;
    let _e38 = alpha_83;
    let _e41 = alpha_83;
    let _e43 = alpha_83;
    apart = ((_e36.x * _e38.x) - (_e41.y * _e43.y));
    let _e48 = wo_51;
    let _e50 = wo_51;
    let _e53 = wo_51;
    let _e55 = wo_51;
    side_3 = ((_e48.x * _e50.x) - (_e53.y * _e55.y));
    let _e60 = mean_2;
    let _e61 = apart;
    let _e62 = side_3;
    let _e66 = alpha_83;
    return sqrt((_e60 + ((_e61 * _e62) * (0.24f - (0.46f * _e66.x)))));
}

fn stretchedQuantile(s_5: f32) -> f32 {
    var s_6: f32;

    s_6 = s_5;
    let _e22 = s_6;
    let _e25 = s_6;
    let _e26 = s_6;
    return (0.5f + ((0.5f * _e22) * inverseSqrt((1f + (_e25 * _e26)))));
}

fn stretchedSlope(quantile: f32) -> f32 {
    var quantile_1: f32;
    var v_24: f32;

    quantile_1 = quantile;
    let _e21 = quantile_1;
    v_24 = clamp(((2f * _e21) - 1f), -0.9999f, 0.9999f);
    let _e30 = v_24;
    let _e32 = v_24;
    let _e33 = v_24;
    return (_e30 * inverseSqrt((1f - (_e32 * _e33))));
}

fn stretchedAcross(alpha_84: vec2<f32>) -> f32 {
    var alpha_85: vec2<f32>;
    var ratio_1: f32;

    alpha_85 = alpha_84;
    let _e22 = alpha_85;
    let _e24 = alpha_85;
    ratio_1 = (_e22.y / _e24.x);
    let _e29 = ratio_1;
    let _e30 = ratio_1;
    let _e32 = ratio_1;
    let _e35 = alpha_85;
    let _e38 = alpha_85;
    return ((mix(STRETCHED_ACROSS, 1f, ((_e29 * _e30) * _e32)) * _e35.y) * _e38.y);
}

fn stretchedPart(wo_52: vec3<f32>, alpha_86: vec2<f32>, k_13: i32, count: i32, shift: f32, sharpness: f32) -> StretchedPart {
    var wo_53: vec3<f32>;
    var alpha_87: vec2<f32>;
    var k_14: i32;
    var count_1: i32;
    var shift_1: f32;
    var sharpness_1: f32;
    var apart_1: f32;
    var z_9: f32;
    var root_1: f32;
    var low_6: f32;
    var high_1: f32;
    var spacing: f32;
    var s_7: f32;
    var slope_3: f32;
    var lean_2: f32;
    var part: StretchedPart;
    var across2_: f32;
    var along_5: f32;
    var c_25: f32;
    var wi_42: vec3<f32>;
    var visible: f32;

    wo_53 = wo_52;
    alpha_87 = alpha_86;
    k_14 = k_13;
    count_1 = count;
    shift_1 = shift;
    sharpness_1 = sharpness;
    let _e32 = alpha_87;
    let _e34 = alpha_87;
    let _e37 = alpha_87;
    let _e39 = alpha_87;
    apart_1 = sqrt(max(((_e32.x * _e34.x) - (_e37.y * _e39.y)), LEAST_LENGTH2));
    let _e46 = wo_53;
    z_9 = max(_e46.z, LEAST_COSINE);
    let _e50 = wo_53;
    let _e52 = wo_53;
    let _e55 = z_9;
    let _e56 = z_9;
    root_1 = sqrt(((_e50.x * _e52.x) + (_e55 * _e56)));
    let _e61 = root_1;
    let _e62 = wo_53;
    let _e66 = z_9;
    let _e67 = apart_1;
    let _e70 = stretchedQuantile((-((_e61 + _e62.x)) / (_e66 * _e67)));
    low_6 = _e70;
    let _e72 = root_1;
    let _e73 = wo_53;
    let _e76 = z_9;
    let _e77 = apart_1;
    let _e80 = stretchedQuantile(((_e72 - _e73.x) / (_e76 * _e77)));
    high_1 = _e80;
    let _e82 = high_1;
    let _e83 = low_6;
    let _e85 = count_1;
    spacing = ((_e82 - _e83) / f32(_e85));
    let _e89 = low_6;
    let _e90 = k_14;
    let _e94 = shift_1;
    let _e96 = spacing;
    let _e99 = stretchedSlope((_e89 + (((f32(_e90) + 0.5f) + _e94) * _e96)));
    s_7 = _e99;
    let _e101 = apart_1;
    let _e102 = s_7;
    slope_3 = (_e101 * _e102);
    let _e106 = slope_3;
    let _e107 = slope_3;
    lean_2 = (1f + (_e106 * _e107));
    let _e113 = slope_3;
    let _e118 = lean_2;
    part.n = (vec3<f32>(-(_e113), 0f, 1f) * inverseSqrt(_e118));
    let _e121 = alpha_87;
    let _e122 = stretchedAcross(_e121);
    let _e124 = slope_3;
    let _e125 = slope_3;
    let _e127 = alpha_87;
    let _e129 = alpha_87;
    let _e135 = lean_2;
    across2_ = ((_e122 * (1f + ((_e124 * _e125) / (_e127.x * _e129.x)))) / _e135);
    let _e138 = sharpness_1;
    let _e139 = apart_1;
    let _e144 = s_7;
    let _e145 = s_7;
    let _e150 = s_7;
    let _e151 = s_7;
    let _e156 = spacing;
    let _e158 = lean_2;
    along_5 = ((((((_e138 * _e139) * 2f) * (1f + (_e144 * _e145))) * sqrt((1f + (_e150 * _e151)))) * _e156) / _e158);
    let _e162 = across2_;
    let _e163 = along_5;
    let _e165 = along_5;
    part.alpha = min(sqrt((_e162 + ((STRETCHED_ALONG * _e163) * _e165))), 1f);
    let _e171 = wo_53;
    let _e172 = part;
    c_25 = dot(_e171, _e172.n);
    let _e177 = c_25;
    let _e179 = part;
    let _e182 = wo_53;
    wi_42 = (((2f * _e177) * _e179.n) - _e182);
    let _e186 = z_9;
    let _e187 = z_9;
    let _e188 = z_9;
    let _e190 = apart_1;
    let _e191 = apart_1;
    let _e193 = wo_53;
    let _e196 = wo_53;
    visible = (0.5f * (_e186 + sqrt(((_e187 * _e188) + (((_e190 * _e191) * _e193.x) * _e196.x)))));
    let _e205 = spacing;
    let _e206 = c_25;
    let _e210 = part;
    let _e213 = visible;
    let _e216 = wi_42;
    let _e217 = alpha_87;
    let _e218 = ggxAnisoG1(_e216, _e217);
    part.weight = (((_e205 * max(_e206, 0f)) / (_e210.n.z * _e213)) * _e218);
    let _e220 = part;
    return _e220;
}

fn capFormFactor(cosTheta_32: f32, sin2_6: f32) -> f32 {
    var cosTheta_33: f32;
    var sin2_7: f32;
    var within_1: f32;
    var c_26: f32;
    var sinTheta: f32;
    var cot: f32;
    var y_10: f32;
    var chord: f32;

    cosTheta_33 = cosTheta_32;
    sin2_7 = sin2_6;
    let _e24 = sin2_7;
    within_1 = min(_e24, 0.999f);
    let _e28 = cosTheta_33;
    c_26 = clamp(_e28, -1f, 1f);
    let _e34 = c_26;
    let _e35 = c_26;
    let _e37 = within_1;
    if ((_e34 * _e35) >= _e37) {
        let _e39 = within_1;
        let _e40 = c_26;
        return (_e39 * max(_e40, 0f));
    }
    let _e45 = c_26;
    let _e46 = c_26;
    sinTheta = sqrt((1f - (_e45 * _e46)));
    let _e52 = within_1;
    cot = sqrt(((1f / max(_e52, LEAST_LENGTH2)) - 1f));
    let _e59 = cot;
    let _e61 = c_26;
    let _e63 = sinTheta;
    y_10 = clamp(((-(_e59) * _e61) / _e63), -1f, 1f);
    let _e70 = sinTheta;
    let _e72 = y_10;
    let _e73 = y_10;
    chord = (_e70 * sqrt((1f - (_e72 * _e73))));
    let _e79 = c_26;
    let _e80 = y_10;
    let _e83 = cot;
    let _e84 = chord;
    let _e87 = within_1;
    let _e89 = chord;
    let _e90 = cot;
    return clamp((((((_e79 * acos(_e80)) - (_e83 * _e84)) * _e87) + atan((_e89 / _e90))) / 3.1415927f), 0f, 1f);
}

fn sphereFormFactor(centre: vec3<f32>, radius: f32, n_30: vec3<f32>) -> f32 {
    var centre_1: vec3<f32>;
    var radius_1: f32;
    var n_31: vec3<f32>;
    var range2_: f32;

    centre_1 = centre;
    radius_1 = radius;
    n_31 = n_30;
    let _e26 = centre_1;
    let _e27 = centre_1;
    range2_ = dot(_e26, _e27);
    let _e30 = range2_;
    if !((_e30 > 0f)) {
        return 0f;
    }
    let _e35 = centre_1;
    let _e36 = n_31;
    let _e38 = range2_;
    let _e41 = radius_1;
    let _e42 = radius_1;
    let _e44 = range2_;
    let _e46 = capFormFactor((dot(_e35, _e36) * inverseSqrt(_e38)), ((_e41 * _e42) / _e44));
    return _e46;
}

fn edgeVector(a_27: vec3<f32>, b_19: vec3<f32>) -> vec3<f32> {
    var a_28: vec3<f32>;
    var b_20: vec3<f32>;
    var across_9: vec3<f32>;
    var sine: f32;
    var local_54: vec3<f32>;

    a_28 = a_27;
    b_20 = b_19;
    let _e24 = a_28;
    let _e25 = b_20;
    across_9 = cross(_e24, _e25);
    let _e28 = across_9;
    sine = length(_e28);
    let _e31 = sine;
    if (_e31 > 0.0000001f) {
        let _e34 = across_9;
        let _e35 = sine;
        let _e36 = a_28;
        let _e37 = b_20;
        let _e40 = sine;
        local_54 = (_e34 * (atan2(_e35, dot(_e36, _e37)) / _e40));
    } else {
        let _e43 = across_9;
        local_54 = _e43;
    }
    let _e45 = local_54;
    return _e45;
}

fn rectangleVector(centre_2: vec3<f32>, u_11: vec3<f32>, v_25: vec3<f32>) -> vec3<f32> {
    var centre_3: vec3<f32>;
    var u_12: vec3<f32>;
    var v_26: vec3<f32>;
    var a_29: vec3<f32>;
    var b_21: vec3<f32>;
    var c_27: vec3<f32>;
    var d_16: vec3<f32>;
    var sum_12: vec3<f32>;
    var local_55: f32;
    var turned: f32;

    centre_3 = centre_2;
    u_12 = u_11;
    v_26 = v_25;
    let _e26 = centre_3;
    let _e27 = u_12;
    let _e29 = v_26;
    a_29 = normalize(((_e26 - _e27) - _e29));
    let _e33 = centre_3;
    let _e34 = u_12;
    let _e36 = v_26;
    b_21 = normalize(((_e33 + _e34) - _e36));
    let _e40 = centre_3;
    let _e41 = u_12;
    let _e43 = v_26;
    c_27 = normalize(((_e40 + _e41) + _e43));
    let _e47 = centre_3;
    let _e48 = u_12;
    let _e50 = v_26;
    d_16 = normalize(((_e47 - _e48) + _e50));
    let _e54 = a_29;
    let _e55 = b_21;
    let _e56 = edgeVector(_e54, _e55);
    let _e57 = b_21;
    let _e58 = c_27;
    let _e59 = edgeVector(_e57, _e58);
    let _e61 = c_27;
    let _e62 = d_16;
    let _e63 = edgeVector(_e61, _e62);
    let _e65 = d_16;
    let _e66 = a_29;
    let _e67 = edgeVector(_e65, _e66);
    sum_12 = (((_e56 + _e59) + _e63) + _e67);
    let _e70 = u_12;
    let _e71 = v_26;
    let _e73 = centre_3;
    if (dot(cross(_e70, _e71), _e73) < 0f) {
        local_55 = -1f;
    } else {
        local_55 = 1f;
    }
    let _e81 = local_55;
    turned = _e81;
    let _e83 = sum_12;
    let _e84 = turned;
    return (_e83 * (_e84 / 6.2831855f));
}

fn rectangleFormFactor(centre_4: vec3<f32>, u_13: vec3<f32>, v_27: vec3<f32>, n_32: vec3<f32>) -> f32 {
    var centre_5: vec3<f32>;
    var u_14: vec3<f32>;
    var v_28: vec3<f32>;
    var n_33: vec3<f32>;
    var f_37: vec3<f32>;
    var size_18: f32;
    var local_56: f32;

    centre_5 = centre_4;
    u_14 = u_13;
    v_28 = v_27;
    n_33 = n_32;
    let _e28 = centre_5;
    let _e29 = u_14;
    let _e30 = v_28;
    let _e31 = rectangleVector(_e28, _e29, _e30);
    f_37 = _e31;
    let _e33 = f_37;
    size_18 = length(_e33);
    let _e36 = size_18;
    if (_e36 > 0f) {
        let _e39 = f_37;
        let _e40 = n_33;
        let _e42 = size_18;
        let _e44 = size_18;
        let _e45 = capFormFactor((dot(_e39, _e40) / _e42), _e44);
        local_56 = _e45;
    } else {
        local_56 = 0f;
    }
    let _e48 = local_56;
    return _e48;
}

fn noShare(direction: vec3<f32>) -> LobeShare {
    var direction_1: vec3<f32>;
    var s_8: LobeShare;

    direction_1 = direction;
    s_8.share = 0f;
    let _e27 = direction_1;
    s_8.direction = _e27;
    s_8.sigma = 0f;
    s_8.distance = 0f;
    let _e33 = direction_1;
    s_8.n = -(_e33);
    let _e35 = s_8;
    return _e35;
}

fn lobeIntegral(x_20: f32) -> f32 {
    var x_21: f32;
    var t_24: f32;

    x_21 = x_20;
    let _e23 = x_21;
    t_24 = clamp(_e23, -6f, 6f);
    let _e31 = t_24;
    let _e35 = t_24;
    let _e37 = t_24;
    return (1f / (1f + exp((-(_e31) * (1.595769f + ((0.0715628f * _e35) * _e37))))));
}

fn sphereShare(centre_6: vec3<f32>, radius_2: f32, direction_2: vec3<f32>, sigma_2: f32) -> LobeShare {
    var centre_7: vec3<f32>;
    var radius_3: f32;
    var direction_3: vec3<f32>;
    var sigma_3: f32;
    var s_9: f32;
    var range_1: f32;
    var axis: vec3<f32>;
    var sinRho: f32;
    var rho: f32;
    var theta: f32;
    var found: LobeShare;
    var u2_: f32;
    var curved: f32;
    var reach: f32;
    var middle_1: f32;
    var beside_1: f32;
    var disc: f32;
    var off: f32;
    var towards: vec3<f32>;
    var side_4: f32;
    var across_10: f32;

    centre_7 = centre_6;
    radius_3 = radius_2;
    direction_3 = direction_2;
    sigma_3 = sigma_2;
    let _e29 = sigma_3;
    s_9 = clamp(_e29, LEAST_LOBE, 0.65f);
    let _e33 = centre_7;
    range_1 = length(_e33);
    let _e36 = range_1;
    let _e38 = radius_3;
    if !((_e36 > (0.8f * _e38))) {
        let _e42 = direction_3;
        let _e43 = noShare(_e42);
        return _e43;
    }
    let _e44 = centre_7;
    let _e45 = range_1;
    axis = (_e44 / vec3(_e45));
    let _e49 = radius_3;
    let _e50 = range_1;
    sinRho = clamp((_e49 / _e50), 0.000001f, 0.999f);
    let _e56 = sinRho;
    rho = asin(_e56);
    let _e61 = direction_3;
    let _e62 = axis;
    theta = (2f * asin(min((0.5f * length((_e61 - _e62))), 1f)));
    let _e71 = direction_3;
    let _e72 = noShare(_e71);
    found = _e72;
    let _e74 = theta;
    let _e75 = rho;
    let _e77 = s_9;
    if (_e74 > (_e75 + (4f * _e77))) {
        let _e81 = found;
        return _e81;
    }
    let _e82 = rho;
    let _e83 = rho;
    let _e85 = s_9;
    let _e86 = s_9;
    u2_ = ((_e82 * _e83) / (_e85 * _e86));
    let _e91 = rho;
    let _e94 = sinRho;
    let _e95 = sinRho;
    let _e100 = sinRho;
    curved = (((0.9f * _e91) * sqrt((1f - (_e94 * _e95)))) / _e100);
    let _e103 = rho;
    let _e104 = u2_;
    let _e107 = u2_;
    let _e110 = curved;
    let _e115 = s_9;
    reach = ((_e103 * sqrt(((_e104 + 1f) / ((_e107 + 1f) + _e110)))) / _e115);
    let _e119 = reach;
    let _e120 = lobeIntegral(_e119);
    middle_1 = max(((2f * _e120) - 1f), LEAST_WEIGHT);
    let _e126 = reach;
    let _e127 = theta;
    let _e128 = s_9;
    let _e131 = lobeIntegral((_e126 - (_e127 / _e128)));
    let _e132 = reach;
    let _e134 = theta;
    let _e135 = s_9;
    let _e138 = lobeIntegral((-(_e132) - (_e134 / _e135)));
    beside_1 = (_e131 - _e138);
    let _e145 = u2_;
    let _e149 = beside_1;
    let _e150 = middle_1;
    let _e158 = range_1;
    let _e159 = radius_3;
    found.share = (((1f - exp((-0.5f * _e145))) * clamp((_e149 / _e150), 0f, 1f)) * smoothstep(0.8f, 1f, (_e158 / _e159)));
    let _e164 = rho;
    let _e166 = rho;
    disc = ((0.25f * _e164) * _e166);
    let _e169 = theta;
    let _e170 = disc;
    let _e172 = disc;
    let _e173 = s_9;
    let _e174 = s_9;
    let _e179 = rho;
    off = min(((_e169 * _e170) / (_e172 + (_e173 * _e174))), (0.98f * _e179));
    let _e183 = direction_3;
    let _e184 = direction_3;
    let _e185 = axis;
    let _e187 = axis;
    towards = (_e183 - (dot(_e184, _e185) * _e187));
    let _e191 = towards;
    side_4 = length(_e191);
    let _e194 = side_4;
    if (_e194 > LEAST_LENGTH) {
        let _e197 = off;
        let _e199 = axis;
        let _e201 = off;
        let _e203 = side_4;
        let _e205 = towards;
        found.direction = ((cos(_e197) * _e199) + ((sin(_e201) / _e203) * _e205));
    }
    let _e208 = range_1;
    let _e209 = off;
    across_10 = (_e208 * sin(_e209));
    let _e214 = range_1;
    let _e215 = off;
    let _e218 = radius_3;
    let _e219 = radius_3;
    let _e221 = across_10;
    let _e222 = across_10;
    found.distance = max(((_e214 * cos(_e215)) - sqrt(max(((_e218 * _e219) - (_e221 * _e222)), 0f))), 0f);
    let _e232 = found;
    let _e234 = found;
    let _e237 = centre_7;
    found.n = normalize(((_e232.distance * _e234.direction) - _e237));
    let _e241 = s_9;
    let _e243 = rho;
    found.sigma = min(_e241, (0.5f * _e243));
    let _e246 = found;
    return _e246;
}

fn withinEdge(edge_4: vec3<f32>, direction_4: vec3<f32>, along_6: vec3<f32>, beside_2: vec3<f32>, below_3: f32, s_10: f32, n_34: vec3<f32>, horizon: f32) -> f32 {
    var edge_5: vec3<f32>;
    var direction_5: vec3<f32>;
    var along_7: vec3<f32>;
    var beside_3: vec3<f32>;
    var below_4: f32;
    var s_11: f32;
    var n_35: vec3<f32>;
    var horizon_1: f32;
    var inward: vec3<f32>;
    var width_3: vec2<f32>;
    var share_1: f32;

    edge_5 = edge_4;
    direction_5 = direction_4;
    along_7 = along_6;
    beside_3 = beside_2;
    below_4 = below_3;
    s_11 = s_10;
    n_35 = n_34;
    horizon_1 = horizon;
    let _e37 = edge_5;
    let _e38 = edge_5;
    let _e39 = edge_5;
    inward = (_e37 * inverseSqrt(max(dot(_e38, _e39), LEAST_DIVISOR)));
    let _e45 = below_4;
    let _e46 = inward;
    let _e47 = along_7;
    let _e50 = s_11;
    let _e51 = inward;
    let _e52 = beside_3;
    width_3 = vec2<f32>((_e45 * dot(_e46, _e47)), (_e50 * dot(_e51, _e52)));
    let _e57 = inward;
    let _e58 = direction_5;
    let _e60 = width_3;
    let _e67 = lobeIntegral((dot(_e57, _e58) / max(length(_e60), 0.0001f)));
    share_1 = _e67;
    let _e69 = share_1;
    let _e71 = horizon_1;
    let _e72 = inward;
    let _e73 = n_35;
    return min((_e69 / mix(1f, _e71, clamp(-(dot(_e72, _e73)), 0f, 1f))), 1f);
}

fn rectangleShare(centre_8: vec3<f32>, u_15: vec3<f32>, v_29: vec3<f32>, direction_6: vec3<f32>, sigma_4: f32) -> LobeShare {
    var centre_9: vec3<f32>;
    var u_16: vec3<f32>;
    var v_30: vec3<f32>;
    var direction_7: vec3<f32>;
    var sigma_5: f32;
    var s_12: f32;
    var found_1: LobeShare;
    var n_36: vec3<f32>;
    var local_57: f32;
    var facing: f32;
    var height_1: f32;
    var sinDown: f32;
    var z_10: f32;
    var below_5: f32;
    var shift_2: f32;
    var down: f32;
    var width_4: f32;
    var level: vec3<f32>;
    var local_58: vec3<f32>;
    var middle_2: vec3<f32>;
    var along_8: vec3<f32>;
    var beside_4: vec3<f32>;
    var horizon_2: f32;
    var a_30: vec3<f32>;
    var right: f32;
    var left_1: f32;
    var upper: f32;
    var lower: f32;
    var at: vec3<f32>;
    var met: vec3<f32>;

    centre_9 = centre_8;
    u_16 = u_15;
    v_30 = v_29;
    direction_7 = direction_6;
    sigma_5 = sigma_4;
    let _e31 = sigma_5;
    s_12 = clamp(_e31, LEAST_LOBE, 0.65f);
    let _e35 = direction_7;
    let _e36 = noShare(_e35);
    found_1 = _e36;
    let _e38 = u_16;
    let _e39 = v_30;
    n_36 = normalize(cross(_e38, _e39));
    let _e43 = n_36;
    let _e44 = centre_9;
    if (dot(_e43, _e44) > 0f) {
        local_57 = -1f;
    } else {
        local_57 = 1f;
    }
    let _e52 = local_57;
    facing = _e52;
    let _e54 = n_36;
    let _e55 = facing;
    n_36 = (_e54 * _e55);
    let _e57 = centre_9;
    let _e58 = n_36;
    height_1 = -(dot(_e57, _e58));
    let _e62 = direction_7;
    let _e63 = n_36;
    sinDown = clamp(-(dot(_e62, _e63)), -1f, 1f);
    let _e71 = sinDown;
    let _e73 = s_12;
    z_10 = (asin(_e71) / _e73);
    let _e76 = height_1;
    let _e78 = centre_9;
    let _e83 = z_10;
    if (!((_e76 > (0.00001f * length(_e78)))) || (_e83 < -4f)) {
        let _e88 = found_1;
        return _e88;
    }
    let _e89 = z_10;
    let _e90 = lobeIntegral(_e89);
    below_5 = _e90;
    let _e95 = z_10;
    let _e97 = z_10;
    let _e101 = below_5;
    shift_2 = ((0.3989423f * exp(((-0.5f * _e95) * _e97))) / _e101);
    let _e104 = sinDown;
    let _e106 = s_12;
    let _e107 = shift_2;
    down = clamp((asin(_e104) + (_e106 * _e107)), 0.02f, 1.5707963f);
    let _e114 = s_12;
    let _e116 = z_10;
    let _e117 = shift_2;
    let _e120 = shift_2;
    let _e121 = shift_2;
    width_4 = (_e114 * sqrt(max(((1f - (_e116 * _e117)) - (_e120 * _e121)), 0.05f)));
    let _e129 = direction_7;
    let _e130 = sinDown;
    let _e131 = n_36;
    level = (_e129 + (_e130 * _e131));
    let _e135 = level;
    let _e136 = level;
    if (dot(_e135, _e136) > 0.000000009999999f) {
        let _e142 = level;
        local_58 = normalize(_e142);
    } else {
        let _e144 = u_16;
        local_58 = normalize(_e144);
    }
    let _e147 = local_58;
    level = _e147;
    let _e148 = down;
    let _e150 = level;
    let _e152 = down;
    let _e154 = n_36;
    middle_2 = ((cos(_e148) * _e150) - (sin(_e152) * _e154));
    let _e158 = down;
    let _e161 = level;
    let _e163 = down;
    let _e165 = n_36;
    along_8 = ((-(sin(_e158)) * _e161) - (cos(_e163) * _e165));
    let _e169 = level;
    let _e170 = n_36;
    beside_4 = cross(_e169, _e170);
    let _e173 = down;
    let _e175 = width_4;
    let _e177 = lobeIntegral((sin(_e173) / _e175));
    horizon_2 = _e177;
    let _e179 = facing;
    let _e180 = u_16;
    a_30 = (_e179 * _e180);
    let _e183 = centre_9;
    let _e184 = u_16;
    let _e186 = facing;
    let _e187 = v_30;
    let _e191 = middle_2;
    let _e192 = along_8;
    let _e193 = beside_4;
    let _e194 = width_4;
    let _e195 = s_12;
    let _e196 = n_36;
    let _e197 = horizon_2;
    let _e198 = withinEdge(-(cross((_e183 + _e184), (_e186 * _e187))), _e191, _e192, _e193, _e194, _e195, _e196, _e197);
    right = _e198;
    let _e200 = centre_9;
    let _e201 = u_16;
    let _e203 = facing;
    let _e204 = v_30;
    let _e207 = middle_2;
    let _e208 = along_8;
    let _e209 = beside_4;
    let _e210 = width_4;
    let _e211 = s_12;
    let _e212 = n_36;
    let _e213 = horizon_2;
    let _e214 = withinEdge(cross((_e200 - _e201), (_e203 * _e204)), _e207, _e208, _e209, _e210, _e211, _e212, _e213);
    left_1 = _e214;
    let _e216 = centre_9;
    let _e217 = v_30;
    let _e219 = a_30;
    let _e221 = middle_2;
    let _e222 = along_8;
    let _e223 = beside_4;
    let _e224 = width_4;
    let _e225 = s_12;
    let _e226 = n_36;
    let _e227 = horizon_2;
    let _e228 = withinEdge(cross((_e216 + _e217), _e219), _e221, _e222, _e223, _e224, _e225, _e226, _e227);
    upper = _e228;
    let _e230 = centre_9;
    let _e231 = v_30;
    let _e233 = a_30;
    let _e236 = middle_2;
    let _e237 = along_8;
    let _e238 = beside_4;
    let _e239 = width_4;
    let _e240 = s_12;
    let _e241 = n_36;
    let _e242 = horizon_2;
    let _e243 = withinEdge(-(cross((_e230 - _e231), _e233)), _e236, _e237, _e238, _e239, _e240, _e241, _e242);
    lower = _e243;
    let _e246 = below_5;
    let _e247 = right;
    let _e248 = left_1;
    let _e255 = upper;
    let _e256 = lower;
    found_1.share = ((_e246 * max(((_e247 + _e248) - 1f), 0f)) * max(((_e255 + _e256) - 1f), 0f));
    let _e263 = height_1;
    let _e264 = down;
    let _e267 = middle_2;
    let _e269 = centre_9;
    at = (((_e263 / sin(_e264)) * _e267) - _e269);
    let _e272 = centre_9;
    let _e273 = at;
    let _e274 = u_16;
    let _e276 = u_16;
    let _e277 = u_16;
    let _e284 = u_16;
    let _e287 = at;
    let _e288 = v_30;
    let _e290 = v_30;
    let _e291 = v_30;
    let _e298 = v_30;
    met = ((_e272 + (clamp((dot(_e273, _e274) / dot(_e276, _e277)), -1f, 1f) * _e284)) + (clamp((dot(_e287, _e288) / dot(_e290, _e291)), -1f, 1f) * _e298));
    let _e303 = met;
    found_1.distance = length(_e303);
    let _e306 = met;
    let _e307 = found_1;
    found_1.direction = (_e306 / vec3(max(_e307.distance, LEAST_DIVISOR)));
    let _e313 = n_36;
    found_1.n = _e313;
    let _e315 = width_4;
    found_1.sigma = min(_e315, 0.4f);
    let _e318 = found_1;
    return _e318;
}

fn proxyLobe(wo_54: vec3<f32>, n_37: vec3<f32>, alpha_88: f32) -> ProxyLobe {
    var wo_55: vec3<f32>;
    var n_38: vec3<f32>;
    var alpha_89: f32;
    var c_28: f32;
    var mirror: vec3<f32>;
    var lobe_2: ProxyLobe;
    var narrow: f32;
    var normal: f32;
    var grazing: f32;
    var square_2: f32;
    var local_59: f32;
    var edge_6: f32;

    wo_55 = wo_54;
    n_38 = n_37;
    alpha_89 = alpha_88;
    let _e27 = wo_55;
    let _e28 = n_38;
    c_28 = clamp(dot(_e27, _e28), 0f, 1f);
    let _e35 = wo_55;
    let _e36 = n_38;
    let _e39 = n_38;
    let _e41 = wo_55;
    mirror = (((2f * dot(_e35, _e36)) * _e39) - _e41);
    let _e46 = mirror;
    let _e47 = n_38;
    let _e48 = alpha_89;
    let _e51 = c_28;
    let _e54 = alpha_89;
    lobe_2.direction = normalize(mix(_e46, _e47, vec3((_e48 * (1f + ((1f - _e51) * (1f - _e54)))))));
    let _e63 = alpha_89;
    narrow = (1.9f * _e63);
    let _e67 = narrow;
    let _e69 = narrow;
    let _e70 = narrow;
    lobe_2.sigma = (_e67 * inverseSqrt((1f + ((_e69 * _e70) / 0.5476f))));
    let _e80 = alpha_89;
    normal = (1f / (1f + (2.26f * pow(_e80, 2.3f))));
    let _e89 = alpha_89;
    grazing = (0.9f - (0.34f * _e89));
    let _e94 = alpha_89;
    let _e97 = alpha_89;
    square_2 = ((1f - _e94) * (1f - _e97));
    let _e101 = alpha_89;
    if (_e101 > 0f) {
        let _e105 = c_28;
        let _e109 = square_2;
        let _e111 = square_2;
        local_59 = pow((1f - _e105), (1.5f + ((4f * _e109) * _e111)));
    } else {
        local_59 = 0f;
    }
    let _e117 = local_59;
    edge_6 = _e117;
    let _e120 = normal;
    let _e121 = grazing;
    let _e122 = edge_6;
    lobe_2.albedo = mix(_e120, _e121, _e122);
    let _e124 = lobe_2;
    return _e124;
}

fn proxyFresnel(f0_8: vec3<f32>, f90_: f32, cosTheta_34: f32, alpha_90: f32) -> vec3<f32> {
    var f0_9: vec3<f32>;
    var f90_1: f32;
    var cosTheta_35: f32;
    var alpha_91: f32;
    var c_29: f32;
    var x_22: f32;
    var x2_: f32;

    f0_9 = f0_8;
    f90_1 = f90_;
    cosTheta_35 = cosTheta_34;
    alpha_91 = alpha_90;
    let _e29 = cosTheta_35;
    let _e34 = alpha_91;
    c_29 = mix(clamp(_e29, 0f, 1f), 0.65f, sqrt(_e34));
    let _e39 = c_29;
    x_22 = (1f - _e39);
    let _e42 = x_22;
    let _e43 = x_22;
    x2_ = (_e42 * _e43);
    let _e46 = f0_9;
    let _e47 = f90_1;
    let _e49 = f0_9;
    let _e51 = x2_;
    let _e52 = x2_;
    let _e54 = x_22;
    return (_e46 + ((vec3(_e47) - _e49) * ((_e51 * _e52) * _e54)));
}

fn signNotZero(x_23: f32) -> f32 {
    var x_24: f32;
    var local_60: f32;

    x_24 = x_23;
    let _e23 = x_24;
    if (_e23 < 0f) {
        local_60 = -1f;
    } else {
        local_60 = 1f;
    }
    let _e30 = local_60;
    return _e30;
}

fn octEncode(n_39: vec3<f32>) -> vec2<f32> {
    var n_40: vec3<f32>;
    var s_13: f32;
    var p_3: vec2<f32>;

    n_40 = n_39;
    let _e24 = n_40;
    let _e27 = n_40;
    let _e31 = n_40;
    s_13 = (1f / ((abs(_e24.x) + abs(_e27.y)) + abs(_e31.z)));
    let _e37 = n_40;
    let _e39 = s_13;
    let _e41 = n_40;
    let _e43 = s_13;
    p_3 = vec2<f32>((_e37.x * _e39), (_e41.y * _e43));
    let _e47 = n_40;
    if (_e47.z >= 0f) {
        let _e51 = p_3;
        return _e51;
    }
    let _e53 = p_3;
    let _e57 = p_3;
    let _e59 = signNotZero(_e57.x);
    let _e62 = p_3;
    let _e66 = p_3;
    let _e68 = signNotZero(_e66.y);
    return vec2<f32>(((1f - abs(_e53.y)) * _e59), ((1f - abs(_e62.x)) * _e68));
}

fn octDecode(p_4: vec2<f32>) -> vec3<f32> {
    var p_5: vec2<f32>;
    var z_11: f32;
    var fold: f32;

    p_5 = p_4;
    let _e24 = p_5;
    let _e28 = p_5;
    z_11 = ((1f - abs(_e24.x)) - abs(_e28.y));
    let _e33 = z_11;
    fold = max(-(_e33), 0f);
    let _e38 = p_5;
    let _e40 = fold;
    let _e41 = p_5;
    let _e43 = signNotZero(_e41.x);
    let _e46 = p_5;
    let _e48 = fold;
    let _e49 = p_5;
    let _e51 = signNotZero(_e49.y);
    let _e54 = z_11;
    return normalize(vec3<f32>((_e38.x - (_e40 * _e43)), (_e46.y - (_e48 * _e51)), _e54));
}

fn interiorView(clipFromWorld: mat4x4<f32>, worldFromClip: mat4x4<f32>, size_19: vec2<f32>) -> InteriorView {
    var clipFromWorld_1: mat4x4<f32>;
    var worldFromClip_1: mat4x4<f32>;
    var size_20: vec2<f32>;
    var view: InteriorView;
    var right_1: vec3<f32>;
    var depth: vec3<f32>;
    var w_22: vec3<f32>;
    var perspective: bool;
    var local_61: vec3<f32>;
    var v_31: vec3<f32>;

    clipFromWorld_1 = clipFromWorld;
    worldFromClip_1 = worldFromClip;
    size_20 = size_19;
    let _e29 = clipFromWorld_1;
    view.clipFromWorld = _e29;
    let _e31 = worldFromClip_1;
    view.worldFromClip = _e31;
    let _e33 = size_20;
    view.size = _e33;
    let _e38 = clipFromWorld_1[0][0];
    let _e43 = clipFromWorld_1[1][0];
    let _e48 = clipFromWorld_1[2][0];
    right_1 = vec3<f32>(_e38, _e43, _e48);
    let _e55 = clipFromWorld_1[0][2];
    let _e60 = clipFromWorld_1[1][2];
    let _e65 = clipFromWorld_1[2][2];
    depth = vec3<f32>(_e55, _e60, _e65);
    let _e72 = clipFromWorld_1[0][3];
    let _e77 = clipFromWorld_1[1][3];
    let _e82 = clipFromWorld_1[2][3];
    w_22 = vec3<f32>(_e72, _e77, _e82);
    let _e87 = size_20;
    let _e89 = right_1;
    view.texelWidth = (2f / (_e87.x * length(_e89)));
    let _e93 = w_22;
    let _e94 = w_22;
    perspective = (dot(_e93, _e94) > 0f);
    let _e99 = perspective;
    if _e99 {
        let _e100 = w_22;
        local_61 = normalize(_e100);
    } else {
        let _e102 = depth;
        local_61 = -(normalize(_e102));
    }
    let _e106 = local_61;
    v_31 = _e106;
    let _e109 = view;
    let _e111 = depth;
    let _e112 = v_31;
    let _e115 = w_22;
    let _e116 = v_31;
    view.texelDepth = (_e109.texelWidth * vec2<f32>(-(dot(_e111, _e112)), dot(_e115, _e116)));
    let _e120 = view;
    return _e120;
}

fn interiorTexelDepth(view_1: InteriorView, depth_1: f32) -> f32 {
    var view_2: InteriorView;
    var depth_2: f32;

    view_2 = view_1;
    depth_2 = depth_1;
    let _e25 = view_2;
    let _e28 = view_2;
    let _e31 = depth_2;
    return (_e25.texelDepth.x + (_e28.texelDepth.y * _e31));
}

fn interiorTexelWidth(view_3: InteriorView, w_23: f32) -> f32 {
    var view_4: InteriorView;
    var w_24: f32;

    view_4 = view_3;
    w_24 = w_23;
    let _e25 = view_4;
    let _e27 = w_24;
    return (_e25.texelWidth * _e27);
}

fn interiorWorld(view_5: InteriorView, at_1: vec2<f32>, depth_3: f32) -> vec3<f32> {
    var view_6: InteriorView;
    var at_2: vec2<f32>;
    var depth_4: f32;
    var clip: vec2<f32>;
    var p_6: vec4<f32>;

    view_6 = view_5;
    at_2 = at_1;
    depth_4 = depth_3;
    let _e28 = at_2;
    let _e31 = view_6;
    let _e39 = at_2;
    let _e42 = view_6;
    clip = vec2<f32>((((2f * _e28.x) / _e31.size.x) - 1f), (1f - ((2f * _e39.y) / _e42.size.y)));
    let _e49 = view_6;
    let _e51 = clip;
    let _e53 = clip;
    let _e55 = depth_4;
    p_6 = (_e49.worldFromClip * vec4<f32>(_e51.x, _e53.y, _e55, 1f));
    let _e60 = p_6;
    let _e62 = p_6;
    let _e64 = p_6;
    let _e67 = p_6;
    return (vec3<f32>(_e60.x, _e62.y, _e64.z) / vec3(_e67.w));
}

fn exitRay(view_7: InteriorView, origin: vec3<f32>, direction_8: vec3<f32>) -> ExitRay {
    var view_8: InteriorView;
    var origin_1: vec3<f32>;
    var direction_9: vec3<f32>;
    var o_2: vec4<f32>;
    var d_17: vec4<f32>;
    var h_14: vec2<f32>;
    var ray: ExitRay;

    view_8 = view_7;
    origin_1 = origin;
    direction_9 = direction_8;
    let _e30 = view_8;
    let _e32 = origin_1;
    o_2 = (_e30.clipFromWorld * vec4<f32>(_e32.x, _e32.y, _e32.z, 1f));
    let _e40 = view_8;
    let _e42 = direction_9;
    d_17 = (_e40.clipFromWorld * vec4<f32>(_e42.x, _e42.y, _e42.z, 0f));
    let _e51 = view_8;
    h_14 = (0.5f * _e51.size);
    let _e57 = h_14;
    let _e59 = o_2;
    let _e61 = o_2;
    let _e65 = h_14;
    let _e67 = o_2;
    let _e69 = o_2;
    let _e73 = o_2;
    let _e75 = o_2;
    ray.origin = vec4<f32>((_e57.x * (_e59.w + _e61.x)), (_e65.y * (_e67.w - _e69.y)), _e73.z, _e75.w);
    let _e79 = h_14;
    let _e81 = d_17;
    let _e83 = d_17;
    let _e87 = h_14;
    let _e89 = d_17;
    let _e91 = d_17;
    let _e95 = d_17;
    let _e97 = d_17;
    ray.direction = vec4<f32>((_e79.x * (_e81.w + _e83.x)), (_e87.y * (_e89.w - _e91.y)), _e95.z, _e97.w);
    let _e100 = ray;
    return _e100;
}

fn exitAt(ray_1: ExitRay, t_25: f32) -> vec4<f32> {
    var ray_2: ExitRay;
    var t_26: f32;
    var p_7: vec4<f32>;
    var s_14: f32;

    ray_2 = ray_1;
    t_26 = t_25;
    let _e28 = ray_2;
    let _e30 = t_26;
    let _e31 = ray_2;
    p_7 = (_e28.origin + (_e30 * _e31.direction));
    let _e37 = p_7;
    s_14 = (1f / _e37.w);
    let _e41 = p_7;
    let _e43 = s_14;
    let _e45 = p_7;
    let _e47 = s_14;
    let _e49 = p_7;
    let _e51 = s_14;
    let _e53 = p_7;
    return vec4<f32>((_e41.x * _e43), (_e45.y * _e47), (_e49.z * _e51), _e53.w);
}

fn exitOnPicture(view_9: InteriorView, at_3: vec4<f32>) -> bool {
    var view_10: InteriorView;
    var at_4: vec4<f32>;

    view_10 = view_9;
    at_4 = at_3;
    let _e28 = at_4;
    let _e32 = at_4;
    let _e37 = at_4;
    let _e42 = at_4;
    let _e44 = view_10;
    let _e49 = at_4;
    let _e51 = view_10;
    return (((((_e28.w > 0f) && (_e32.x >= 0f)) && (_e37.y >= 0f)) && (_e42.x < _e44.size.x)) && (_e49.y < _e51.size.y));
}

fn exitStretches(depths: vec4<f32>) -> vec4<f32> {
    var depths_1: vec4<f32>;

    depths_1 = depths;
    let _e26 = depths_1;
    let _e28 = depths_1;
    if (_e26.x < _e28.y) {
        let _e32 = depths_1;
        let _e34 = depths_1;
        let _e36 = depths_1;
        return vec4<f32>(2f, _e32.y, _e34.x, _e36.w);
    }
    let _e39 = depths_1;
    let _e41 = depths_1;
    let _e44 = depths_1;
    if ((_e39.z > _e41.y) && (_e44.w > 0f)) {
        let _e49 = depths_1;
        let _e51 = depths_1;
        return vec4<f32>(_e49.x, _e51.w, 0f, 0f);
    }
    let _e56 = depths_1;
    return _e56;
}

fn exitInside(stretches: vec4<f32>, depth_5: f32) -> vec2<f32> {
    var stretches_1: vec4<f32>;
    var depth_6: f32;
    var inside_1: vec2<f32> = vec2(-2f);

    stretches_1 = stretches;
    depth_6 = depth_5;
    let _e31 = stretches_1;
    if (_e31.y > 0f) {
        let _e36 = stretches_1;
        let _e38 = depth_6;
        let _e40 = depth_6;
        let _e41 = stretches_1;
        inside_1.x = min((_e36.x - _e38), (_e40 - _e41.y));
    }
    let _e45 = stretches_1;
    if (_e45.w > 0f) {
        let _e50 = stretches_1;
        let _e52 = depth_6;
        let _e54 = depth_6;
        let _e55 = stretches_1;
        inside_1.y = min((_e50.z - _e52), (_e54 - _e55.w));
    }
    let _e59 = inside_1;
    return _e59;
}

fn exitLearn(way: ExitWay, t_27: f32, w_25: f32, here: f32, margin: f32) -> ExitWay {
    var way_1: ExitWay;
    var t_28: f32;
    var w_26: f32;
    var here_1: f32;
    var margin_1: f32;
    var local_62: f32;

    way_1 = way;
    t_28 = t_27;
    w_26 = w_25;
    here_1 = here;
    margin_1 = margin;
    let _e34 = here_1;
    let _e35 = margin_1;
    if (_e34 > _e35) {
        {
            let _e38 = t_28;
            way_1.tInside = _e38;
            let _e40 = here_1;
            let _e41 = w_26;
            way_1.inside = (_e40 * _e41);
        }
    } else {
        let _e43 = here_1;
        let _e44 = margin_1;
        if (_e43 < -(_e44)) {
            {
                let _e48 = t_28;
                way_1.tOutside = _e48;
                let _e50 = here_1;
                if (_e50 > EXIT_NOWHERE) {
                    let _e52 = here_1;
                    let _e53 = w_26;
                    local_62 = (_e52 * _e53);
                } else {
                    local_62 = EXIT_NOWHERE;
                }
                let _e56 = local_62;
                way_1.outside = _e56;
            }
        }
    }
    let _e57 = way_1;
    return _e57;
}

fn exitSecant(way_2: ExitWay) -> f32 {
    var way_3: ExitWay;
    var local_63: f32;
    var share_2: f32;

    way_3 = way_2;
    let _e26 = way_3;
    if (_e26.outside > EXIT_NOWHERE) {
        let _e29 = way_3;
        let _e31 = way_3;
        let _e33 = way_3;
        local_63 = clamp((_e29.inside / (_e31.inside - _e33.outside)), 0.05f, 0.95f);
    } else {
        local_63 = 0.5f;
    }
    let _e42 = local_63;
    share_2 = _e42;
    let _e44 = way_3;
    let _e46 = way_3;
    let _e48 = share_2;
    return mix(_e44.tInside, _e46.tOutside, _e48);
}

fn exitSpacing(k_15: i32) -> f32 {
    var k_16: i32;
    var x_25: f32;
    var x3_: f32;

    k_16 = k_15;
    let _e27 = k_16;
    x_25 = (0.25f * f32(_e27));
    let _e31 = x_25;
    let _e32 = x_25;
    let _e34 = x_25;
    x3_ = ((_e31 * _e32) * _e34);
    let _e37 = x_25;
    let _e38 = x3_;
    let _e42 = x3_;
    let _e43 = x3_;
    return ((_e37 + (_e38 / 3f)) + ((_e42 * _e43) / 20f));
}

fn exitPlane(origin_2: vec3<f32>, direction_10: vec3<f32>, point: vec3<f32>, n_41: vec3<f32>) -> f32 {
    var origin_3: vec3<f32>;
    var direction_11: vec3<f32>;
    var point_1: vec3<f32>;
    var n_42: vec3<f32>;

    origin_3 = origin_2;
    direction_11 = direction_10;
    point_1 = point;
    n_42 = n_41;
    let _e32 = point_1;
    let _e33 = origin_3;
    let _e35 = n_42;
    let _e37 = direction_11;
    let _e38 = n_42;
    return (dot((_e32 - _e33), _e35) / dot(_e37, _e38));
}

fn exitSame(point_2: vec3<f32>, n_43: vec3<f32>, otherPoint: vec3<f32>, otherN: vec3<f32>) -> bool {
    var point_3: vec3<f32>;
    var n_44: vec3<f32>;
    var otherPoint_1: vec3<f32>;
    var otherN_1: vec3<f32>;
    var chord_1: vec3<f32>;

    point_3 = point_2;
    n_44 = n_43;
    otherPoint_1 = otherPoint;
    otherN_1 = otherN;
    let _e32 = otherPoint_1;
    let _e33 = point_3;
    chord_1 = (_e32 - _e33);
    let _e36 = n_44;
    let _e37 = otherN_1;
    let _e41 = chord_1;
    let _e42 = n_44;
    let _e46 = chord_1;
    return ((dot(_e36, _e37) > 0.7f) && (abs(dot(_e41, _e42)) <= (0.39f * length(_e46))));
}

fn exitCurvature(n_45: vec3<f32>, direction_12: vec3<f32>, stepX: vec3<f32>, turnX: vec3<f32>, stepY: vec3<f32>, turnY: vec3<f32>) -> vec2<f32> {
    var n_46: vec3<f32>;
    var direction_13: vec3<f32>;
    var stepX_1: vec3<f32>;
    var turnX_1: vec3<f32>;
    var stepY_1: vec3<f32>;
    var turnY_1: vec3<f32>;
    var area_1: f32;
    var turn: f32;
    var along_9: vec3<f32>;
    var t1_2: vec3<f32>;
    var t2_: vec3<f32>;
    var turn1_: vec3<f32>;
    var turn2_: vec3<f32>;
    var twist: f32;
    var curvature: vec2<f32>;
    var local_64: vec2<f32>;

    n_46 = n_45;
    direction_13 = direction_12;
    stepX_1 = stepX;
    turnX_1 = turnX;
    stepY_1 = stepY;
    turnY_1 = turnY;
    let _e36 = stepX_1;
    let _e37 = stepY_1;
    let _e39 = n_46;
    area_1 = dot(cross(_e36, _e37), _e39);
    let _e42 = turnX_1;
    let _e43 = turnX_1;
    let _e45 = turnY_1;
    let _e46 = turnY_1;
    turn = max(dot(_e42, _e43), dot(_e45, _e46));
    let _e50 = area_1;
    let _e53 = turn;
    if ((_e50 == 0f) || (_e53 > 0.0625f)) {
        return vec2(0f);
    }
    let _e59 = direction_13;
    let _e60 = direction_13;
    let _e61 = n_46;
    let _e63 = n_46;
    along_9 = (_e59 - (dot(_e60, _e61) * _e63));
    let _e67 = along_9;
    let _e68 = along_9;
    if (dot(_e67, _e68) < LEAST_LENGTH2) {
        let _e71 = stepX_1;
        let _e72 = stepX_1;
        let _e73 = n_46;
        let _e75 = n_46;
        along_9 = (_e71 - (dot(_e72, _e73) * _e75));
    }
    let _e78 = along_9;
    t1_2 = normalize(_e78);
    let _e81 = n_46;
    let _e82 = t1_2;
    t2_ = cross(_e81, _e82);
    let _e85 = stepY_1;
    let _e86 = t2_;
    let _e88 = turnX_1;
    let _e90 = stepX_1;
    let _e91 = t2_;
    let _e93 = turnY_1;
    let _e96 = area_1;
    turn1_ = (((dot(_e85, _e86) * _e88) - (dot(_e90, _e91) * _e93)) / vec3(_e96));
    let _e100 = stepX_1;
    let _e101 = t1_2;
    let _e103 = turnY_1;
    let _e105 = stepY_1;
    let _e106 = t1_2;
    let _e108 = turnX_1;
    let _e111 = area_1;
    turn2_ = (((dot(_e100, _e101) * _e103) - (dot(_e105, _e106) * _e108)) / vec3(_e111));
    let _e115 = turn1_;
    let _e116 = t2_;
    let _e118 = turn2_;
    let _e119 = t1_2;
    twist = abs((dot(_e115, _e116) - dot(_e118, _e119)));
    let _e124 = turn1_;
    let _e125 = t1_2;
    let _e127 = turn2_;
    let _e128 = t2_;
    curvature = vec2<f32>(dot(_e124, _e125), dot(_e127, _e128));
    let _e132 = twist;
    let _e133 = curvature;
    let _e136 = curvature;
    if (_e132 > (abs(_e133.x) + abs(_e136.y))) {
        local_64 = vec2(0f);
    } else {
        let _e143 = curvature;
        local_64 = _e143;
    }
    let _e145 = local_64;
    return _e145;
}

fn engineInterfaceEnergy(at_5: vec3<f32>) -> vec4<f32> {
    var at_6: vec3<f32>;

    at_6 = at_5;
    return vec4(0f);
}

fn engineInterfaceLobe(at_7: vec3<f32>) -> vec4<f32> {
    var at_8: vec3<f32>;

    at_8 = at_7;
    return vec4(0f);
}

fn engineReflectionLobe(at_9: vec3<f32>) -> vec4<f32> {
    var at_10: vec3<f32>;

    at_10 = at_9;
    return vec4(0f);
}

fn engineSceneColor(at_11: vec2<f32>, variance_1: f32) -> vec4<f32> {
    var at_12: vec2<f32>;
    var variance_2: f32;

    at_12 = at_11;
    variance_2 = variance_1;
    return vec4(0f);
}

fn engineSceneDepth(at_13: vec2<f32>) -> f32 {
    var at_14: vec2<f32>;

    at_14 = at_13;
    return 0f;
}

fn engineEnvironment(direction_14: vec3<f32>, sigma_6: f32) -> vec3<f32> {
    var direction_15: vec3<f32>;
    var sigma_7: f32;

    direction_15 = direction_14;
    sigma_7 = sigma_6;
    return vec3(0f);
}

fn scenePixel(clip_1: vec4<f32>, size_21: vec2<f32>) -> vec2<f32> {
    var clip_2: vec4<f32>;
    var size_22: vec2<f32>;

    clip_2 = clip_1;
    size_22 = size_21;
    let _e33 = clip_2;
    let _e36 = clip_2;
    let _e40 = size_22;
    let _e45 = clip_2;
    let _e48 = clip_2;
    let _e52 = size_22;
    return vec2<f32>(((0.5f + ((0.5f * _e33.x) / _e36.w)) * _e40.x), ((0.5f - ((0.5f * _e45.y) / _e48.w)) * _e52.y));
}

fn sceneGuess(origin_4: vec4<f32>, along_10: vec4<f32>, view_11: SceneView) -> SceneIntersection {
    var origin_5: vec4<f32>;
    var along_11: vec4<f32>;
    var view_12: SceneView;
    var met_1: SceneIntersection;
    var at_15: vec2<f32>;
    var k_17: i32 = 0i;
    var depth_7: f32;
    var sky: bool;
    var local_65: f32;
    var local_66: vec4<f32>;
    var there: vec4<f32>;
    var next: vec2<f32>;

    origin_5 = origin_4;
    along_11 = along_10;
    view_12 = view_11;
    met_1.seen = false;
    met_1.behind = 0f;
    met_1.metres = -1f;
    let _e41 = origin_5;
    let _e42 = view_12;
    let _e44 = scenePixel(_e41, _e42.size);
    at_15 = _e44;
    loop {
        let _e48 = k_17;
        let _e50 = met_1;
        if !(((_e48 < SCENE_GUESSES) && !(_e50.seen))) {
            break;
        }
        {
            let _e58 = at_15;
            let _e59 = engineSceneDepth(_e58);
            depth_7 = _e59;
            let _e61 = depth_7;
            sky = (_e61 > 100000000000000000000000000000f);
            let _e66 = sky;
            if _e66 {
                local_65 = -1f;
            } else {
                let _e69 = depth_7;
                let _e70 = origin_5;
                let _e73 = along_11;
                local_65 = ((_e69 - _e70.w) / _e73.w);
            }
            let _e77 = local_65;
            met_1.metres = _e77;
            let _e78 = along_11;
            let _e83 = sky;
            let _e85 = met_1;
            if (!((_e78.w > 0f)) || (!(_e83) && (_e85.metres < 0f))) {
                break;
            }
            let _e91 = sky;
            if _e91 {
                let _e92 = along_11;
                local_66 = _e92;
            } else {
                let _e93 = origin_5;
                let _e94 = met_1;
                let _e96 = along_11;
                local_66 = (_e93 + (_e94.metres * _e96));
            }
            let _e100 = local_66;
            there = _e100;
            let _e102 = there;
            let _e103 = view_12;
            let _e105 = scenePixel(_e102, _e103.size);
            next = _e105;
            let _e108 = k_17;
            let _e111 = next;
            let _e113 = at_15;
            let _e120 = next;
            let _e122 = at_15;
            met_1.seen = (((_e108 > 0i) && (abs((_e111.x - _e113.x)) < 1f)) && (abs((_e120.y - _e122.y)) < 1f));
            let _e129 = next;
            at_15 = _e129;
        }
        continuing {
            let _e55 = k_17;
            k_17 = (_e55 + 1i);
        }
    }
    let _e130 = met_1;
    return _e130;
}

fn sceneShown(origin_6: vec4<f32>, way_4: vec4<f32>) -> f32 {
    var origin_7: vec4<f32>;
    var way_5: vec4<f32>;
    var room_1: vec4<f32>;
    var loss: vec4<f32>;
    var cut: vec4<f32>;
    var end: f32;

    origin_7 = origin_6;
    way_5 = way_4;
    let _e31 = origin_7;
    let _e33 = origin_7;
    let _e36 = origin_7;
    let _e38 = origin_7;
    let _e41 = origin_7;
    let _e43 = origin_7;
    let _e46 = origin_7;
    let _e48 = origin_7;
    room_1 = max(vec4<f32>((_e31.w - _e33.x), (_e36.w + _e38.x), (_e41.w - _e43.y), (_e46.w + _e48.y)), vec4(0f));
    let _e56 = way_5;
    let _e58 = way_5;
    let _e61 = way_5;
    let _e64 = way_5;
    let _e67 = way_5;
    let _e69 = way_5;
    let _e72 = way_5;
    let _e75 = way_5;
    loss = vec4<f32>((_e56.x - _e58.w), (-(_e61.x) - _e64.w), (_e67.y - _e69.w), (-(_e72.y) - _e75.w));
    let _e80 = room_1;
    let _e81 = loss;
    let _e82 = room_1;
    cut = min((_e80 / max(max(_e81, _e82), vec4(0.000000000000000000000000000001f))), vec4(1f));
    let _e92 = cut;
    let _e94 = cut;
    let _e97 = cut;
    let _e99 = cut;
    end = min(min(_e92.x, _e94.y), min(_e97.z, _e99.w));
    let _e104 = end;
    let _e106 = origin_7;
    let _e109 = way_5;
    let _e113 = origin_7;
    return min(_e104, ((0.99f * _e106.w) / max(-(_e109.w), (0.99f * _e113.w))));
}

fn sceneMarch(origin_8: vec4<f32>, along_12: vec4<f32>, view_13: SceneView) -> SceneIntersection {
    var origin_9: vec4<f32>;
    var along_13: vec4<f32>;
    var view_14: SceneView;
    var way_6: vec4<f32>;
    var end_1: f32;
    var to: vec4<f32>;
    var a_31: vec3<f32>;
    var b_22: vec3<f32>;
    var met_2: SceneIntersection;
    var low_7: f32 = 0f;
    var heightLow: f32 = 0f;
    var high_2: f32 = 1f;
    var heightHigh: f32 = 0f;
    var crossed: bool = false;
    var depth_8: f32 = 0f;
    var k_18: i32 = 1i;
    var p_8: vec3<f32>;
    var beyond: f32;
    var bordered: bool;
    var local_67: f32;
    var gap: f32;
    var k_19: i32 = 0i;
    var local_68: f32;
    var share_3: f32;
    var u_17: f32;
    var p_9: vec3<f32>;
    var height_2: f32;
    var front: bool;
    var local_69: f32;
    var local_70: f32;
    var local_71: f32;
    var local_72: f32;
    var u_18: f32;
    var near: f32;
    var far: f32;
    var surface_6: bool;

    origin_9 = origin_8;
    along_13 = along_12;
    view_14 = view_13;
    let _e33 = view_14;
    let _e35 = along_13;
    way_6 = (_e33.reach * _e35);
    let _e38 = origin_9;
    let _e39 = way_6;
    let _e40 = sceneShown(_e38, _e39);
    end_1 = _e40;
    let _e42 = origin_9;
    let _e43 = end_1;
    let _e44 = way_6;
    to = (_e42 + (_e43 * _e44));
    let _e48 = origin_9;
    let _e50 = origin_9;
    let _e54 = origin_9;
    a_31 = (vec3<f32>(_e48.x, _e50.y, 1f) / vec3(_e54.w));
    let _e59 = to;
    let _e61 = to;
    let _e65 = to;
    b_22 = (vec3<f32>(_e59.x, _e61.y, 1f) / vec3(_e65.w));
    met_2.seen = false;
    met_2.behind = 0f;
    met_2.metres = -1f;
    loop {
        let _e92 = k_18;
        let _e94 = crossed;
        if !(((_e92 <= SCENE_STEPS) && !(_e94))) {
            break;
        }
        {
            let _e101 = k_18;
            high_2 = (f32(_e101) / 12f);
            let _e106 = a_31;
            let _e107 = b_22;
            let _e108 = high_2;
            p_8 = mix(_e106, _e107, vec3(_e108));
            let _e114 = p_8;
            let _e118 = view_14;
            let _e124 = p_8;
            let _e128 = view_14;
            let _e133 = engineSceneDepth(vec2<f32>(((0.5f + (0.5f * _e114.x)) * _e118.size.x), ((0.5f - (0.5f * _e124.y)) * _e128.size.y)));
            depth_8 = _e133;
            let _e134 = p_8;
            let _e137 = depth_8;
            heightHigh = (_e134.z - (1f / _e137));
            let _e140 = heightHigh;
            let _e143 = k_18;
            let _e146 = heightLow;
            crossed = ((_e140 < 0f) && ((_e143 == 1i) || (_e146 >= 0f)));
            let _e151 = crossed;
            if !(_e151) {
                {
                    let _e153 = high_2;
                    low_7 = _e153;
                    let _e154 = heightHigh;
                    heightLow = _e154;
                }
            }
        }
        continuing {
            let _e98 = k_18;
            k_18 = (_e98 + 1i);
        }
    }
    let _e155 = crossed;
    if !(_e155) {
        {
            let _e157 = depth_8;
            let _e158 = origin_9;
            let _e161 = along_13;
            beyond = ((_e157 - _e158.w) / _e161.w);
            let _e165 = end_1;
            let _e168 = depth_8;
            let _e172 = heightHigh;
            let _e176 = beyond;
            bordered = ((((_e165 < 1f) && (_e168 < 100000000000000000000000000000f)) && (_e172 >= 0f)) && (_e176 > 0f));
            let _e182 = bordered;
            if _e182 {
                let _e183 = beyond;
                local_67 = _e183;
            } else {
                local_67 = -1f;
            }
            let _e187 = local_67;
            met_2.metres = _e187;
            let _e189 = bordered;
            let _e190 = heightHigh;
            let _e193 = depth_8;
            let _e197 = along_13;
            met_2.seen = (_e189 || (((_e190 >= 0f) && (_e193 > 100000000000000000000000000000f)) && (_e197.w > 0f)));
            let _e203 = met_2;
            return _e203;
        }
    }
    let _e204 = heightLow;
    let _e205 = heightHigh;
    gap = max((_e204 - _e205), LEAST_DIVISOR);
    loop {
        let _e211 = k_19;
        if !((_e211 < SCENE_SECANTS)) {
            break;
        }
        {
            let _e217 = k_19;
            if ((_e217 % 2i) == 0i) {
                local_68 = 0.5f;
            } else {
                let _e223 = heightLow;
                let _e224 = heightLow;
                let _e225 = heightHigh;
                local_68 = (_e223 / max((_e224 - _e225), LEAST_DIVISOR));
            }
            let _e230 = local_68;
            share_3 = _e230;
            let _e232 = low_7;
            let _e233 = high_2;
            let _e234 = share_3;
            u_17 = mix(_e232, _e233, clamp(_e234, 0f, 1f));
            let _e240 = a_31;
            let _e241 = b_22;
            let _e242 = u_17;
            p_9 = mix(_e240, _e241, vec3(_e242));
            let _e248 = p_9;
            let _e252 = view_14;
            let _e258 = p_9;
            let _e262 = view_14;
            let _e267 = engineSceneDepth(vec2<f32>(((0.5f + (0.5f * _e248.x)) * _e252.size.x), ((0.5f - (0.5f * _e258.y)) * _e262.size.y)));
            depth_8 = _e267;
            let _e268 = p_9;
            let _e271 = depth_8;
            height_2 = (_e268.z - (1f / _e271));
            let _e275 = height_2;
            front = (_e275 >= 0f);
            let _e279 = front;
            if _e279 {
                let _e280 = u_17;
                local_69 = _e280;
            } else {
                let _e281 = low_7;
                local_69 = _e281;
            }
            let _e283 = local_69;
            low_7 = _e283;
            let _e284 = front;
            if _e284 {
                let _e285 = height_2;
                local_70 = _e285;
            } else {
                let _e286 = heightLow;
                local_70 = _e286;
            }
            let _e288 = local_70;
            heightLow = _e288;
            let _e289 = front;
            if _e289 {
                let _e290 = high_2;
                local_71 = _e290;
            } else {
                let _e291 = u_17;
                local_71 = _e291;
            }
            let _e293 = local_71;
            high_2 = _e293;
            let _e294 = front;
            if _e294 {
                let _e295 = heightHigh;
                local_72 = _e295;
            } else {
                let _e296 = height_2;
                local_72 = _e296;
            }
            let _e298 = local_72;
            heightHigh = _e298;
        }
        continuing {
            let _e214 = k_19;
            k_19 = (_e214 + 1i);
        }
    }
    let _e299 = low_7;
    let _e300 = high_2;
    let _e301 = heightLow;
    let _e302 = heightLow;
    let _e303 = heightHigh;
    u_18 = mix(_e299, _e300, (_e301 / max((_e302 - _e303), LEAST_DIVISOR)));
    let _e310 = u_18;
    let _e312 = origin_9;
    near = ((1f - _e310) / _e312.w);
    let _e316 = u_18;
    let _e317 = to;
    far = (_e316 / _e317.w);
    let _e322 = view_14;
    let _e324 = end_1;
    let _e326 = far;
    let _e328 = near;
    let _e329 = far;
    met_2.metres = (((_e322.reach * _e324) * _e326) / (_e328 + _e329));
    met_2.seen = true;
    let _e334 = heightLow;
    let _e335 = heightHigh;
    let _e338 = gap;
    let _e341 = gap;
    surface_6 = (((_e334 - _e335) < (0.5f * _e338)) || (_e341 < 0.000001f));
    let _e346 = surface_6;
    if !(_e346) {
        let _e350 = near;
        let _e351 = far;
        let _e355 = depth_8;
        met_2.behind = max(((1f / max((_e350 + _e351), LEAST_DIVISOR)) - _e355), 0f);
    }
    let _e359 = met_2;
    return _e359;
}

fn sceneIntersection(origin_10: vec3<f32>, direction_16: vec3<f32>, view_15: SceneView) -> SceneIntersection {
    var origin_11: vec3<f32>;
    var direction_17: vec3<f32>;
    var view_16: SceneView;
    var from_: vec4<f32>;
    var along_14: vec4<f32>;
    var met_3: SceneIntersection;

    origin_11 = origin_10;
    direction_17 = direction_16;
    view_16 = view_15;
    let _e33 = view_16;
    let _e35 = origin_11;
    from_ = (_e33.clipFromWorld * vec4<f32>(_e35.x, _e35.y, _e35.z, 1f));
    let _e43 = view_16;
    let _e45 = direction_17;
    along_14 = (_e43.clipFromWorld * vec4<f32>(_e45.x, _e45.y, _e45.z, 0f));
    let _e53 = from_;
    let _e54 = along_14;
    let _e55 = view_16;
    let _e56 = sceneGuess(_e53, _e54, _e55);
    met_3 = _e56;
    let _e58 = met_3;
    if !(_e58.seen) {
        let _e61 = from_;
        let _e62 = along_14;
        let _e63 = view_16;
        let _e64 = sceneMarch(_e61, _e62, _e63);
        met_3 = _e64;
    }
    let _e65 = met_3;
    return _e65;
}

fn engineFace(layer: i32, at_16: vec2<f32>) -> vec4<f32> {
    var layer_1: i32;
    var at_17: vec2<f32>;

    layer_1 = layer;
    at_17 = at_16;
    return vec4(0f);
}

fn pixelSteps(view_17: SceneView) -> PixelSteps {
    var view_18: SceneView;
    var forward: vec3<f32>;
    var x_26: vec3<f32>;
    var y_11: vec3<f32>;
    var steps: PixelSteps;

    view_18 = view_17;
    let _e37 = view_18.clipFromWorld[0][3];
    let _e43 = view_18.clipFromWorld[1][3];
    let _e49 = view_18.clipFromWorld[2][3];
    forward = vec3<f32>(_e37, _e43, _e49);
    let _e57 = view_18.clipFromWorld[0][0];
    let _e63 = view_18.clipFromWorld[1][0];
    let _e69 = view_18.clipFromWorld[2][0];
    x_26 = vec3<f32>(_e57, _e63, _e69);
    let _e77 = view_18.clipFromWorld[0][1];
    let _e83 = view_18.clipFromWorld[1][1];
    let _e89 = view_18.clipFromWorld[2][1];
    y_11 = vec3<f32>(_e77, _e83, _e89);
    let _e92 = x_26;
    let _e93 = x_26;
    let _e94 = forward;
    let _e96 = forward;
    x_26 = (_e92 - (dot(_e93, _e94) * _e96));
    let _e99 = y_11;
    let _e100 = y_11;
    let _e101 = forward;
    let _e103 = forward;
    y_11 = (_e99 - (dot(_e100, _e101) * _e103));
    let _e109 = view_18;
    let _e112 = x_26;
    let _e113 = x_26;
    let _e117 = x_26;
    steps.right = ((2f / (_e109.size.x * dot(_e112, _e113))) * _e117);
    let _e122 = view_18;
    let _e125 = y_11;
    let _e126 = y_11;
    let _e130 = y_11;
    steps.down = ((-2f / (_e122.size.y * dot(_e125, _e126))) * _e130);
    let _e132 = steps;
    return _e132;
}

fn backFaceAt(at_18: vec2<f32>, p_10: vec3<f32>, which: FaceLayer, steps_1: PixelSteps, view_19: SceneView) -> BackFace {
    var at_19: vec2<f32>;
    var p_11: vec3<f32>;
    var which_1: FaceLayer;
    var steps_2: PixelSteps;
    var view_20: SceneView;
    var texel_4: vec4<f32>;
    var off_1: vec2<f32>;
    var face_6: BackFace;
    var local_73: bool;

    at_19 = at_18;
    p_11 = p_10;
    which_1 = which;
    steps_2 = steps_1;
    view_20 = view_19;
    let _e40 = which_1;
    let _e42 = at_19;
    let _e43 = engineFace(_e40.layer, _e42);
    texel_4 = _e43;
    let _e45 = at_19;
    let _e50 = at_19;
    off_1 = ((floor(_e45) + vec2(0.5f)) - _e50);
    let _e55 = view_20;
    let _e57 = texel_4;
    let _e59 = p_11;
    let _e60 = off_1;
    let _e62 = steps_2;
    let _e66 = off_1;
    let _e68 = steps_2;
    face_6.point = (_e55.eye + (_e57.z * ((_e59 + (_e60.x * _e62.right)) + (_e66.y * _e68.down))));
    let _e75 = which_1;
    let _e77 = texel_4;
    let _e79 = texel_4;
    let _e82 = octDecode(vec2<f32>(_e77.x, _e79.y));
    face_6.n = (_e75.side * _e82);
    let _e86 = texel_4;
    face_6.alpha = (2f * fract(_e86.w));
    let _e91 = texel_4;
    face_6.number = floor(_e91.w);
    let _e95 = which_1;
    if (_e95.number < 0f) {
        let _e99 = face_6;
        local_73 = (_e99.number > 0f);
    } else {
        let _e103 = face_6;
        let _e105 = which_1;
        local_73 = (_e103.number == _e105.number);
    }
    let _e109 = local_73;
    face_6.exists = _e109;
    let _e110 = face_6;
    return _e110;
}

fn backFaceBeside(own: BackFace, at_20: vec2<f32>, p_12: vec3<f32>, which_2: FaceLayer, steps_3: PixelSteps, view_21: SceneView) -> BackFace {
    var own_1: BackFace;
    var at_21: vec2<f32>;
    var p_13: vec3<f32>;
    var which_3: FaceLayer;
    var steps_4: PixelSteps;
    var view_22: SceneView;
    var beside_5: BackFace;

    own_1 = own;
    at_21 = at_20;
    p_13 = p_12;
    which_3 = which_2;
    steps_4 = steps_3;
    view_22 = view_21;
    let _e42 = at_21;
    let _e43 = p_13;
    let _e44 = which_3;
    let _e45 = steps_4;
    let _e46 = view_22;
    let _e47 = backFaceAt(_e42, _e43, _e44, _e45, _e46);
    beside_5 = _e47;
    let _e49 = beside_5;
    let _e51 = own_1;
    let _e53 = own_1;
    let _e55 = beside_5;
    let _e57 = beside_5;
    let _e59 = exitSame(_e51.point, _e53.n, _e55.point, _e57.n);
    if (_e49.exists && _e59) {
        let _e61 = beside_5;
        return _e61;
    }
    let _e62 = own_1;
    return _e62;
}

fn wideningGgx(lobes_2: i32) -> Widening {
    var lobes_3: i32;
    var k_20: Widening;
    var local_74: f32;
    var local_75: f32;
    var local_76: f32;

    lobes_3 = lobes_2;
    let _e34 = lobes_3;
    if (_e34 > 1i) {
        local_74 = 0.7f;
    } else {
        local_74 = 0.6f;
    }
    let _e40 = local_74;
    k_20.shape = _e40;
    let _e42 = lobes_3;
    if (_e42 > 1i) {
        local_75 = 0.91f;
    } else {
        local_75 = 0.6f;
    }
    let _e48 = local_75;
    k_20.shapeRays = _e48;
    let _e50 = lobes_3;
    if (_e50 > 1i) {
        local_76 = 1.05f;
    } else {
        local_76 = 0.95f;
    }
    let _e56 = local_76;
    k_20.energyCore = _e56;
    k_20.energyTail = 0.85f;
    let _e59 = k_20;
    return _e59;
}

fn wideningBeckmann(lobes_4: i32) -> Widening {
    var lobes_5: i32;
    var k_21: Widening;
    var local_77: f32;
    var local_78: f32;
    var local_79: f32;

    lobes_5 = lobes_4;
    let _e34 = lobes_5;
    if (_e34 > 1i) {
        local_77 = 1f;
    } else {
        local_77 = 1.2f;
    }
    let _e40 = local_77;
    k_21.shape = _e40;
    let _e42 = lobes_5;
    if (_e42 > 1i) {
        local_78 = 1.3f;
    } else {
        local_78 = 1.2f;
    }
    let _e48 = local_78;
    k_21.shapeRays = _e48;
    let _e50 = lobes_5;
    if (_e50 > 1i) {
        local_79 = 1.3f;
    } else {
        local_79 = 1.5f;
    }
    let _e56 = local_79;
    k_21.energyCore = _e56;
    k_21.energyTail = 1.6f;
    let _e59 = k_21;
    return _e59;
}

fn exitTurn(cosTheta_36: f32, pathLength: f32, curvature_1: vec2<f32>) -> vec2<f32> {
    var cosTheta_37: f32;
    var pathLength_1: f32;
    var curvature_2: vec2<f32>;
    var turn_1: vec2<f32>;

    cosTheta_37 = cosTheta_36;
    pathLength_1 = pathLength;
    curvature_2 = curvature_1;
    let _e36 = pathLength_1;
    let _e37 = curvature_2;
    let _e40 = cosTheta_37;
    let _e43 = pathLength_1;
    let _e44 = curvature_2;
    turn_1 = vec2<f32>(((_e36 * _e37.x) / max(_e40, LEAST_LENGTH)), (_e43 * _e44.y));
    let _e49 = turn_1;
    return clamp(_e49, vec2(-8f), vec2(8f));
}

fn sphereTurn(cosTheta_38: f32) -> vec2<f32> {
    var cosTheta_39: f32;

    cosTheta_39 = cosTheta_38;
    let _e34 = cosTheta_39;
    return vec2<f32>(2f, (2f * _e34));
}

fn seeExit(inner: InnerLobe, core: bool, s_15: ExitSurface, k_22: Widening) -> ExitView {
    var inner_1: InnerLobe;
    var core_1: bool;
    var s_16: ExitSurface;
    var k_23: Widening;
    var v_32: ExitView;
    var local_80: f32;
    var alpha2_: f32;
    var spread_3: f32;
    var spread2_: f32;
    var rays2_: f32;
    var local_81: f32;
    var rays: f32;
    var shape_1: f32;
    var shape2_: f32;
    var local_82: f32;
    var energy: f32;
    var local_83: f32;

    inner_1 = inner;
    core_1 = core;
    s_16 = s_15;
    k_23 = k_22;
    let _e41 = inner_1;
    let _e43 = s_16;
    v_32.cosTheta = min(dot(_e41.direction, _e43.n), 1f);
    let _e50 = s_16;
    v_32.swing = (1f - _e50.turn.x);
    let _e55 = v_32;
    if (_e55.swing < 0f) {
        let _e59 = v_32;
        local_80 = min(_e59.swing, -0.05f);
    } else {
        let _e64 = v_32;
        local_80 = max(_e64.swing, LEAST_SWING);
    }
    let _e68 = local_80;
    v_32.swing = _e68;
    let _e69 = s_16;
    let _e71 = s_16;
    alpha2_ = (_e69.alpha * _e71.alpha);
    let _e75 = inner_1;
    let _e77 = v_32;
    spread_3 = (_e75.sigma * _e77.swing);
    let _e81 = spread_3;
    let _e82 = spread_3;
    spread2_ = (_e81 * _e82);
    let _e85 = k_23;
    let _e87 = k_23;
    let _e90 = spread2_;
    rays2_ = ((_e85.shape * _e87.shape) * _e90);
    let _e93 = rays2_;
    if (_e93 > 0f) {
        let _e96 = rays2_;
        let _e97 = alpha2_;
        let _e98 = rays2_;
        local_81 = (_e96 / (_e97 + _e98));
    } else {
        local_81 = 0f;
    }
    let _e103 = local_81;
    rays = _e103;
    let _e105 = k_23;
    let _e107 = k_23;
    let _e109 = rays;
    shape_1 = mix(_e105.shape, _e107.shapeRays, _e109);
    let _e112 = alpha2_;
    let _e113 = shape_1;
    let _e114 = shape_1;
    let _e116 = spread2_;
    shape2_ = (_e112 + ((_e113 * _e114) * _e116));
    let _e120 = core_1;
    if _e120 {
        let _e121 = k_23;
        local_82 = _e121.energyCore;
    } else {
        let _e123 = k_23;
        local_82 = _e123.energyTail;
    }
    let _e126 = local_82;
    energy = _e126;
    let _e129 = shape2_;
    v_32.alphaShape = min(sqrt(_e129), 1f);
    let _e134 = alpha2_;
    let _e135 = energy;
    let _e136 = energy;
    let _e138 = spread2_;
    v_32.alphaEnergy = min(sqrt((_e134 + ((_e135 * _e136) * _e138))), 1f);
    let _e145 = shape2_;
    if (_e145 > 0f) {
        let _e148 = alpha2_;
        let _e149 = shape2_;
        local_83 = (_e148 / _e149);
    } else {
        local_83 = 1f;
    }
    let _e153 = local_83;
    v_32.own = _e153;
    let _e154 = v_32;
    return _e154;
}

fn leavingNextAlpha(innerSigma: f32, alpha_92: f32, nextAlpha: f32) -> f32 {
    var innerSigma_1: f32;
    var alpha_93: f32;
    var nextAlpha_1: f32;
    var spread_4: f32;

    innerSigma_1 = innerSigma;
    alpha_93 = alpha_92;
    nextAlpha_1 = nextAlpha;
    let _e39 = innerSigma_1;
    spread_4 = (1.3f * _e39);
    let _e42 = nextAlpha_1;
    let _e43 = nextAlpha_1;
    let _e46 = alpha_93;
    let _e48 = alpha_93;
    let _e51 = spread_4;
    let _e52 = spread_4;
    return min(sqrt((((_e42 * _e43) + ((3f * _e46) * _e48)) + (_e51 * _e52))), 1f);
}

fn convexExit(n_47: vec3<f32>, direction_18: vec3<f32>, body: ConvexBody) -> ConvexExit {
    var n_48: vec3<f32>;
    var direction_19: vec3<f32>;
    var body_1: ConvexBody;
    var q_1: f32;
    var c_30: f32;
    var a_32: f32;
    var root_2: f32;
    var local_84: f32;
    var scaled: f32;
    var e_6: ConvexExit;
    var local_85: f32;
    var curvature_3: f32;

    n_48 = n_47;
    direction_19 = direction_18;
    body_1 = body;
    let _e38 = body_1;
    let _e40 = body_1;
    q_1 = clamp((_e38.thickness * _e40.curvature), 0f, 2f);
    let _e47 = n_48;
    let _e48 = direction_19;
    c_30 = max(-(dot(_e47, _e48)), 0.05f);
    let _e55 = q_1;
    let _e57 = c_30;
    a_32 = ((1f - _e55) * _e57);
    let _e60 = a_32;
    let _e61 = a_32;
    let _e63 = q_1;
    let _e65 = q_1;
    root_2 = sqrt(((_e60 * _e61) + (_e63 * (2f - _e65))));
    let _e71 = q_1;
    if (_e71 < 1f) {
        let _e75 = q_1;
        let _e77 = a_32;
        let _e78 = root_2;
        local_84 = ((2f - _e75) / (_e77 + _e78));
    } else {
        let _e81 = root_2;
        let _e82 = a_32;
        let _e84 = q_1;
        local_84 = ((_e81 - _e82) / _e84);
    }
    let _e87 = local_84;
    scaled = _e87;
    let _e91 = scaled;
    let _e92 = body_1;
    e_6.path = (_e91 * _e92.thickness);
    let _e97 = q_1;
    let _e100 = n_48;
    let _e102 = q_1;
    let _e103 = scaled;
    let _e105 = direction_19;
    e_6.surface.n = normalize((((_e97 - 1f) * _e100) + ((_e102 * _e103) * _e105)));
    let _e111 = body_1;
    e_6.surface.alpha = _e111.backAlpha;
    let _e116 = body_1;
    e_6.surface.eta = (1f / _e116.ior);
    let _e119 = body_1;
    if (_e119.thickness > 0f) {
        let _e123 = q_1;
        let _e124 = body_1;
        local_85 = (_e123 / _e124.thickness);
    } else {
        local_85 = 0f;
    }
    let _e129 = local_85;
    curvature_3 = _e129;
    let _e133 = direction_19;
    let _e134 = e_6;
    let _e138 = e_6;
    let _e140 = curvature_3;
    let _e142 = exitTurn(dot(_e133, _e134.surface.n), _e138.path, vec2(_e140));
    e_6.surface.turn = _e142;
    let _e143 = e_6;
    return _e143;
}

fn backFaceBetween(face_7: BackFace, at_22: vec2<f32>, hit: vec2<f32>, p_14: vec3<f32>, which_4: FaceLayer, origin_12: vec3<f32>, direction_20: vec3<f32>, steps_5: PixelSteps, view_23: SceneView) -> BackFaceExit {
    var face_8: BackFace;
    var at_23: vec2<f32>;
    var hit_1: vec2<f32>;
    var p_15: vec3<f32>;
    var which_5: FaceLayer;
    var origin_13: vec3<f32>;
    var direction_21: vec3<f32>;
    var steps_6: PixelSteps;
    var view_24: SceneView;
    var right_2: BackFace;
    var below_6: BackFace;
    var off_2: vec2<f32>;
    var found_2: BackFaceExit;
    var cosTheta_40: f32;
    var curvature_4: vec2<f32>;

    face_8 = face_7;
    at_23 = at_22;
    hit_1 = hit;
    p_15 = p_14;
    which_5 = which_4;
    origin_13 = origin_12;
    direction_21 = direction_20;
    steps_6 = steps_5;
    view_24 = view_23;
    let _e51 = face_8;
    let _e52 = at_23;
    let _e57 = p_15;
    let _e58 = steps_6;
    let _e61 = which_5;
    let _e62 = steps_6;
    let _e63 = view_24;
    let _e64 = backFaceBeside(_e51, (_e52 + vec2<f32>(1f, 0f)), (_e57 + _e58.right), _e61, _e62, _e63);
    right_2 = _e64;
    let _e66 = face_8;
    let _e67 = at_23;
    let _e72 = p_15;
    let _e73 = steps_6;
    let _e76 = which_5;
    let _e77 = steps_6;
    let _e78 = view_24;
    let _e79 = backFaceBeside(_e66, (_e67 + vec2<f32>(0f, 1f)), (_e72 + _e73.down), _e76, _e77, _e78);
    below_6 = _e79;
    let _e81 = hit_1;
    let _e82 = at_23;
    off_2 = ((_e81 - floor(_e82)) - vec2(0.5f));
    let _e93 = face_8;
    let _e95 = off_2;
    let _e97 = right_2;
    let _e99 = face_8;
    let _e104 = off_2;
    let _e106 = below_6;
    let _e108 = face_8;
    found_2.exit.surface.n = normalize(((_e93.n + (_e95.x * (_e97.n - _e99.n))) + (_e104.y * (_e106.n - _e108.n))));
    let _e117 = face_8;
    found_2.exit.surface.alpha = _e117.alpha;
    let _e121 = origin_13;
    let _e122 = direction_21;
    let _e123 = face_8;
    let _e125 = face_8;
    let _e127 = exitPlane(_e121, _e122, _e123.point, _e125.n);
    found_2.exit.path = _e127;
    let _e129 = face_8;
    found_2.number = _e129.number;
    let _e131 = direction_21;
    let _e132 = found_2;
    cosTheta_40 = dot(_e131, _e132.exit.surface.n);
    let _e138 = face_8;
    let _e140 = direction_21;
    let _e141 = right_2;
    let _e143 = face_8;
    let _e146 = right_2;
    let _e148 = face_8;
    let _e151 = below_6;
    let _e153 = face_8;
    let _e156 = below_6;
    let _e158 = face_8;
    let _e161 = exitCurvature(_e138.n, _e140, (_e141.point - _e143.point), (_e146.n - _e148.n), (_e151.point - _e153.point), (_e156.n - _e158.n));
    curvature_4 = _e161;
    let _e166 = cosTheta_40;
    let _e167 = found_2;
    let _e170 = curvature_4;
    let _e171 = exitTurn(_e166, _e167.exit.path, _e170);
    found_2.exit.surface.turn = _e171;
    let _e173 = cosTheta_40;
    found_2.found = (_e173 > 0f);
    let _e176 = found_2;
    return _e176;
}

fn noBackFace(direction_22: vec3<f32>, eta_44: f32) -> BackFaceExit {
    var direction_23: vec3<f32>;
    var eta_45: f32;
    var none: BackFaceExit;

    direction_23 = direction_22;
    eta_45 = eta_44;
    let _e41 = direction_23;
    none.exit.surface.n = _e41;
    none.exit.surface.alpha = 0f;
    none.exit.surface.turn = vec2(0f);
    let _e54 = eta_45;
    none.exit.surface.eta = _e54;
    none.exit.path = 0f;
    none.number = 0f;
    none.found = false;
    let _e62 = none;
    return _e62;
}

fn backFaceExit(origin_14: vec3<f32>, direction_24: vec3<f32>, first_6: f32, eta_46: f32, which_6: FaceLayer, view_25: SceneView) -> BackFaceExit {
    var origin_15: vec3<f32>;
    var direction_25: vec3<f32>;
    var first_7: f32;
    var eta_47: f32;
    var which_7: FaceLayer;
    var view_26: SceneView;
    var from_1: vec4<f32>;
    var along_15: vec4<f32>;
    var steps_7: PixelSteps;
    var inside_2: f32 = 0f;
    var t_29: f32;
    var face_9: BackFace;
    var at_24: vec2<f32> = vec2(0f);
    var hit_2: vec2<f32> = vec2(0f);
    var p_16: vec3<f32> = vec3(0f);
    var found_3: bool = false;
    var lost_2: bool = false;
    var k_24: i32 = 0i;
    var clip_3: vec4<f32>;
    var here_2: vec3<f32>;
    var met_4: f32;
    var meets: bool;
    var there_1: vec4<f32>;
    var moved: vec2<f32>;
    var local_86: f32;
    var missed: f32;
    var local_87: f32;
    var local_88: f32;
    var exit: BackFaceExit;

    origin_15 = origin_14;
    direction_25 = direction_24;
    first_7 = first_6;
    eta_47 = eta_46;
    which_7 = which_6;
    view_26 = view_25;
    let _e45 = view_26;
    let _e47 = origin_15;
    from_1 = (_e45.clipFromWorld * vec4<f32>(_e47.x, _e47.y, _e47.z, 1f));
    let _e55 = view_26;
    let _e57 = direction_25;
    along_15 = (_e55.clipFromWorld * vec4<f32>(_e57.x, _e57.y, _e57.z, 0f));
    let _e65 = view_26;
    let _e66 = pixelSteps(_e65);
    steps_7 = _e66;
    let _e70 = first_7;
    t_29 = _e70;
    loop {
        let _e88 = k_24;
        let _e90 = found_3;
        let _e93 = lost_2;
        if !((((_e88 < BACK_FACE_STEPS) && !(_e90)) && !(_e93))) {
            break;
        }
        {
            let _e100 = from_1;
            let _e101 = t_29;
            let _e102 = along_15;
            clip_3 = (_e100 + (_e101 * _e102));
            let _e106 = clip_3;
            let _e107 = view_26;
            let _e109 = scenePixel(_e106, _e107.size);
            at_24 = _e109;
            let _e110 = origin_15;
            let _e111 = t_29;
            let _e112 = direction_25;
            here_2 = (_e110 + (_e111 * _e112));
            let _e116 = here_2;
            let _e117 = view_26;
            let _e120 = clip_3;
            p_16 = ((_e116 - _e117.eye) / vec3(_e120.w));
            let _e124 = at_24;
            let _e125 = p_16;
            let _e126 = which_7;
            let _e127 = steps_7;
            let _e128 = view_26;
            let _e129 = backFaceAt(_e124, _e125, _e126, _e127, _e128);
            face_9 = _e129;
            let _e130 = origin_15;
            let _e131 = direction_25;
            let _e132 = face_9;
            let _e134 = face_9;
            let _e136 = exitPlane(_e130, _e131, _e132.point, _e134.n);
            met_4 = _e136;
            let _e138 = face_9;
            let _e140 = direction_25;
            let _e141 = face_9;
            let _e147 = met_4;
            meets = ((_e138.exists && (dot(_e140, _e141.n) > 0f)) && (_e147 > 0f));
            let _e152 = clip_3;
            let _e157 = k_24;
            let _e160 = face_9;
            lost_2 = (!((_e152.w > 0f)) || ((_e157 == 0i) && !(_e160.exists)));
            let _e165 = from_1;
            let _e166 = met_4;
            let _e167 = along_15;
            there_1 = (_e165 + (_e166 * _e167));
            let _e171 = there_1;
            let _e172 = view_26;
            let _e174 = scenePixel(_e171, _e172.size);
            hit_2 = _e174;
            let _e175 = hit_2;
            let _e176 = at_24;
            moved = (_e175 - _e176);
            let _e179 = lost_2;
            let _e181 = meets;
            let _e183 = there_1;
            let _e188 = moved;
            let _e189 = moved;
            found_3 = (((!(_e179) && _e181) && (_e183.w > 0f)) && (dot(_e188, _e189) < 0.5f));
            let _e194 = k_24;
            if (_e194 == 0i) {
                let _e197 = face_9;
                let _e199 = here_2;
                local_86 = length((_e197.point - _e199));
            } else {
                let _e203 = inside_2;
                let _e204 = t_29;
                local_86 = (0.5f * (_e203 + _e204));
            }
            let _e208 = local_86;
            missed = _e208;
            let _e210 = meets;
            if _e210 {
                let _e211 = t_29;
                local_87 = _e211;
            } else {
                let _e212 = inside_2;
                local_87 = _e212;
            }
            let _e214 = local_87;
            inside_2 = _e214;
            let _e215 = meets;
            if _e215 {
                let _e216 = met_4;
                local_88 = _e216;
            } else {
                let _e217 = missed;
                local_88 = _e217;
            }
            let _e219 = local_88;
            t_29 = _e219;
        }
        continuing {
            let _e97 = k_24;
            k_24 = (_e97 + 1i);
        }
    }
    let _e220 = found_3;
    if !(_e220) {
        let _e222 = direction_25;
        let _e223 = eta_47;
        let _e224 = noBackFace(_e222, _e223);
        return _e224;
    }
    let _e225 = face_9;
    let _e226 = at_24;
    let _e227 = hit_2;
    let _e228 = p_16;
    let _e229 = which_7;
    let _e230 = origin_15;
    let _e231 = direction_25;
    let _e232 = steps_7;
    let _e233 = view_26;
    let _e234 = backFaceBetween(_e225, _e226, _e227, _e228, _e229, _e230, _e231, _e232, _e233);
    exit = _e234;
    let _e239 = eta_47;
    exit.exit.surface.eta = _e239;
    let _e240 = exit;
    return _e240;
}

fn composeLobe(inner_2: InnerLobe, view_27: ExitView, s_17: ExitSurface, angle: f32, sigma_8: f32, weight: f32, energy_1: f32) -> ComposedLobe {
    var inner_3: InnerLobe;
    var view_28: ExitView;
    var s_18: ExitSurface;
    var angle_1: f32;
    var sigma_9: f32;
    var weight_1: f32;
    var energy_2: f32;
    var lobe_3: ComposedLobe;
    var ratio_2: f32;
    var along_16: vec3<f32>;
    var sinTheta_1: f32;
    var t_30: vec3<f32>;
    var d_18: vec2<f32>;
    var l_4: vec2<f32>;
    var local_89: f32;
    var h_15: vec2<f32>;
    var bend: f32;
    var ci: f32;
    var co: f32;
    var rays_1: f32;
    var turned_1: f32;
    var kept: f32;
    var seen_1: f32;
    var across_11: f32;
    var sigma2_: f32;
    var inPlane: f32;
    var outOfPlane: f32;
    var local_90: f32;
    var carriedInPlane: f32;

    inner_3 = inner_2;
    view_28 = view_27;
    s_18 = s_17;
    angle_1 = angle;
    sigma_9 = sigma_8;
    weight_1 = weight;
    energy_2 = energy_1;
    let _e53 = inner_3;
    lobe_3.direction = _e53.direction;
    let _e56 = inner_3;
    lobe_3.sigma = _e56.sigma;
    let _e59 = inner_3;
    lobe_3.inner = _e59.sigma;
    let _e62 = inner_3;
    lobe_3.carried = _e62.sigma;
    let _e65 = inner_3;
    let _e67 = weight_1;
    let _e69 = energy_2;
    lobe_3.weight = ((_e65.weight * _e67) * _e69);
    let _e71 = view_28;
    if !((_e71.cosTheta > 0f)) {
        lobe_3.weight = 0f;
    }
    let _e79 = s_18;
    ratio_2 = (1f / _e79.eta);
    let _e83 = view_28;
    let _e88 = ratio_2;
    if (!((_e83.cosTheta > 0f)) || (abs((_e88 - 1f)) < INDEX_MATCHED)) {
        let _e94 = lobe_3;
        return _e94;
    }
    let _e95 = inner_3;
    let _e97 = view_28;
    let _e99 = s_18;
    along_16 = (_e95.direction - (_e97.cosTheta * _e99.n));
    let _e104 = along_16;
    sinTheta_1 = length(_e104);
    let _e107 = along_16;
    let _e108 = sinTheta_1;
    t_30 = (_e107 / vec3(max(_e108, LEAST_DIVISOR)));
    let _e113 = sinTheta_1;
    let _e114 = view_28;
    d_18 = vec2<f32>(_e113, _e114.cosTheta);
    let _e118 = angle_1;
    let _e120 = angle_1;
    l_4 = vec2<f32>(sin(_e118), cos(_e120));
    let _e124 = ratio_2;
    let _e125 = d_18;
    let _e127 = l_4;
    let _e129 = ratio_2;
    if (_e129 < 1f) {
        local_89 = -1f;
    } else {
        local_89 = 1f;
    }
    let _e136 = local_89;
    h_15 = (((_e124 * _e125) - _e127) * _e136);
    let _e139 = h_15;
    bend = max(length(_e139), 0.00005f);
    let _e146 = d_18;
    let _e147 = h_15;
    let _e149 = bend;
    ci = (dot(_e146, _e147) / _e149);
    let _e152 = l_4;
    let _e153 = h_15;
    let _e155 = bend;
    co = max((dot(_e152, _e153) / _e155), FACET_LEAST_COS);
    let _e160 = view_28;
    rays_1 = (1f - _e160.own);
    let _e164 = angle_1;
    let _e165 = rays_1;
    let _e167 = view_28;
    let _e170 = h_15;
    let _e172 = h_15;
    turned_1 = clamp((_e164 - (((GIVEN_BACK * _e165) / _e167.swing) * atan2(_e170.x, abs(_e172.y)))), -1.5707964f, 1.5707964f);
    let _e188 = turned_1;
    let _e190 = t_30;
    let _e192 = turned_1;
    let _e194 = s_18;
    lobe_3.direction = normalize(((sin(_e188) * _e190) + (cos(_e192) * _e194.n)));
    let _e199 = view_28;
    let _e201 = rays_1;
    let _e203 = view_28;
    let _e207 = view_28;
    kept = (_e199.own - ((_e201 * (1f - _e203.swing)) / _e207.swing));
    let _e212 = sigma_9;
    let _e213 = co;
    let _e216 = ratio_2;
    let _e217 = ci;
    let _e219 = kept;
    let _e220 = co;
    let _e224 = bend;
    seen_1 = (((_e212 * inverseSqrt(_e213)) * ((_e216 * _e217) - (_e219 * _e220))) / _e224);
    let _e227 = ratio_2;
    let _e228 = co;
    let _e229 = ratio_2;
    let _e230 = ci;
    let _e233 = s_18;
    across_11 = (_e227 + ((_e228 - (_e229 * _e230)) * _e233.turn.y));
    let _e239 = inner_3;
    let _e241 = inner_3;
    sigma2_ = (_e239.sigma * _e241.sigma);
    let _e245 = seen_1;
    let _e246 = seen_1;
    let _e248 = view_28;
    let _e250 = sigma2_;
    inPlane = min(((_e245 * _e246) + (_e248.own * _e250)), 0.09f);
    let _e258 = view_28;
    let _e260 = sigma_9;
    let _e262 = sigma_9;
    let _e264 = co;
    let _e266 = across_11;
    let _e267 = across_11;
    let _e269 = sigma2_;
    outOfPlane = ((((_e258.own * _e260) * _e262) * _e264) + ((_e266 * _e267) * _e269));
    let _e274 = inPlane;
    let _e275 = outOfPlane;
    lobe_3.sigma = sqrt(sqrt((_e274 * _e275)));
    let _e279 = view_28;
    if (_e279.swing < 0f) {
        let _e283 = rays_1;
        local_90 = -(sqrt(_e283));
    } else {
        let _e286 = rays_1;
        local_90 = sqrt(_e286);
    }
    let _e289 = local_90;
    let _e290 = seen_1;
    let _e292 = view_28;
    let _e294 = inner_3;
    carriedInPlane = ((_e289 * _e290) + (_e292.own * _e294.sigma));
    let _e301 = carriedInPlane;
    let _e302 = across_11;
    let _e303 = inner_3;
    let _e308 = lobe_3;
    let _e311 = lobe_3;
    lobe_3.carried = clamp((0.5f * (_e301 + (_e302 * _e303.sigma))), -(_e308.sigma), _e311.sigma);
    let _e314 = lobe_3;
    return _e314;
}

fn mergeLobes(a_33: ComposedLobe, b_23: ComposedLobe) -> ComposedLobe {
    var a_34: ComposedLobe;
    var b_24: ComposedLobe;
    var weight_2: f32;
    var local_91: f32;
    var share_4: f32;
    var apart_2: vec3<f32>;
    var mean_3: vec3<f32>;
    var inner2_: f32;
    var both: f32;
    var lobe_4: ComposedLobe;
    var local_92: vec3<f32>;
    var local_93: f32;

    a_34 = a_33;
    b_24 = b_23;
    let _e41 = a_34;
    let _e43 = b_24;
    weight_2 = (_e41.weight + _e43.weight);
    let _e47 = weight_2;
    if (_e47 > 0f) {
        let _e50 = b_24;
        let _e52 = weight_2;
        local_91 = (_e50.weight / _e52);
    } else {
        local_91 = 0f;
    }
    let _e56 = local_91;
    share_4 = _e56;
    let _e58 = b_24;
    let _e60 = a_34;
    apart_2 = (_e58.direction - _e60.direction);
    let _e64 = a_34;
    let _e66 = share_4;
    let _e67 = apart_2;
    mean_3 = (_e64.direction + (_e66 * _e67));
    let _e71 = a_34;
    let _e73 = a_34;
    let _e76 = b_24;
    let _e78 = b_24;
    let _e81 = share_4;
    inner2_ = mix((_e71.inner * _e73.inner), (_e76.inner * _e78.inner), _e81);
    let _e84 = a_34;
    let _e86 = a_34;
    let _e89 = b_24;
    let _e91 = b_24;
    let _e94 = share_4;
    both = mix((_e84.inner * _e86.carried), (_e89.inner * _e91.carried), _e94);
    let _e99 = weight_2;
    lobe_4.weight = _e99;
    let _e101 = mean_3;
    let _e102 = mean_3;
    if (dot(_e101, _e102) > 0.000001f) {
        let _e106 = mean_3;
        local_92 = normalize(_e106);
    } else {
        let _e108 = a_34;
        local_92 = _e108.direction;
    }
    let _e111 = local_92;
    lobe_4.direction = _e111;
    let _e113 = a_34;
    let _e115 = a_34;
    let _e118 = b_24;
    let _e120 = b_24;
    let _e123 = share_4;
    let _e126 = share_4;
    let _e129 = share_4;
    let _e132 = apart_2;
    let _e133 = apart_2;
    lobe_4.sigma = sqrt((mix((_e113.sigma * _e115.sigma), (_e118.sigma * _e120.sigma), _e123) + (((0.5f * _e126) * (1f - _e129)) * dot(_e132, _e133))));
    let _e139 = inner2_;
    lobe_4.inner = sqrt(_e139);
    let _e142 = lobe_4;
    if (_e142.inner > 0f) {
        let _e146 = both;
        let _e147 = lobe_4;
        local_93 = (_e146 / _e147.inner);
    } else {
        local_93 = 0f;
    }
    let _e152 = local_93;
    lobe_4.carried = _e152;
    let _e153 = lobe_4;
    return _e153;
}

fn composedPair(core_2: ComposedLobe, tail_1: ComposedLobe, view_29: ExitView) -> ComposedPair {
    var core_3: ComposedLobe;
    var tail_2: ComposedLobe;
    var view_30: ExitView;
    var moved_1: f32;
    var pair_1: ComposedPair;

    core_3 = core_2;
    tail_2 = tail_1;
    view_30 = view_29;
    let _e44 = view_30;
    let _e47 = tail_2;
    moved_1 = ((1f - _e44.own) * _e47.weight);
    let _e53 = core_3;
    pair_1.core = _e53;
    let _e55 = tail_2;
    pair_1.rest = _e55;
    let _e58 = core_3;
    let _e60 = moved_1;
    pair_1.core.weight = (_e58.weight + _e60);
    let _e64 = tail_2;
    let _e66 = moved_1;
    pair_1.rest.weight = (_e64.weight - _e66);
    let _e68 = pair_1;
    return _e68;
}

fn mergePairs(core_4: ComposedPair, tail_3: ComposedPair) -> ComposedPair {
    var core_5: ComposedPair;
    var tail_4: ComposedPair;
    var pair_2: ComposedPair;

    core_5 = core_4;
    tail_4 = tail_3;
    let _e43 = core_5;
    pair_2.core = _e43.core;
    let _e46 = core_5;
    let _e48 = tail_4;
    let _e50 = mergeLobes(_e46.rest, _e48.core);
    let _e51 = tail_4;
    let _e53 = mergeLobes(_e50, _e51.rest);
    pair_2.rest = _e53;
    let _e54 = pair_2;
    return _e54;
}

fn interfaceCosineAxis(cosTheta_41: f32, eta_48: f32) -> f32 {
    var cosTheta_42: f32;
    var eta_49: f32;
    var c_31: f32;
    var critical: f32;
    var past: bool;
    var local_94: f32;
    var along_17: f32;
    var grazing_1: bool;
    var local_95: f32;
    var local_96: f32;
    var x_27: f32;
    var local_97: f32;
    var local_98: f32;

    cosTheta_42 = cosTheta_41;
    eta_49 = eta_48;
    let _e47 = cosTheta_42;
    c_31 = clamp(_e47, 0f, 1f);
    let _e52 = eta_49;
    if (_e52 >= 1f) {
        let _e55 = c_31;
        return sqrt(_e55);
    }
    let _e58 = eta_49;
    let _e61 = eta_49;
    critical = sqrt(((1f - _e58) * (1f + _e61)));
    let _e66 = c_31;
    let _e67 = critical;
    past = (_e66 < _e67);
    let _e70 = past;
    if _e70 {
        let _e71 = c_31;
        let _e72 = critical;
        local_94 = (_e71 / _e72);
    } else {
        let _e74 = c_31;
        let _e75 = critical;
        let _e78 = critical;
        local_94 = ((_e74 - _e75) / (1f - _e78));
    }
    let _e82 = local_94;
    along_17 = _e82;
    let _e84 = past;
    let _e85 = along_17;
    grazing_1 = (_e84 && (_e85 < 0.5f));
    let _e90 = past;
    if _e90 {
        let _e92 = grazing_1;
        if _e92 {
            let _e93 = along_17;
            local_95 = _e93;
        } else {
            let _e95 = along_17;
            local_95 = (1f - _e95);
        }
        let _e98 = local_95;
        local_96 = (0.125f * _e98);
    } else {
        let _e101 = along_17;
        local_96 = (0.25f * _e101);
    }
    let _e104 = local_96;
    x_27 = sqrt(_e104);
    let _e107 = grazing_1;
    if _e107 {
        let _e108 = x_27;
        local_98 = _e108;
    } else {
        let _e109 = past;
        if _e109 {
            let _e111 = x_27;
            local_97 = (0.5f - _e111);
        } else {
            let _e114 = x_27;
            local_97 = (0.5f + _e114);
        }
        let _e117 = local_97;
        local_98 = _e117;
    }
    let _e119 = local_98;
    return _e119;
}

fn interfaceCosineAt(x_28: f32, eta_50: f32) -> f32 {
    var x_29: f32;
    var eta_51: f32;
    var critical_1: f32;
    var away: f32;
    var local_99: f32;

    x_29 = x_28;
    eta_51 = eta_50;
    let _e47 = eta_51;
    if (_e47 >= 1f) {
        let _e50 = x_29;
        let _e51 = x_29;
        return (_e50 * _e51);
    }
    let _e54 = eta_51;
    let _e57 = eta_51;
    critical_1 = sqrt(((1f - _e54) * (1f + _e57)));
    let _e62 = x_29;
    away = (_e62 - 0.5f);
    let _e66 = away;
    if (_e66 >= 0f) {
        let _e69 = critical_1;
        let _e71 = away;
        let _e73 = away;
        let _e76 = critical_1;
        return (_e69 + (((4f * _e71) * _e73) * (1f - _e76)));
    }
    let _e80 = critical_1;
    let _e81 = x_29;
    if (_e81 < 0.25f) {
        let _e85 = x_29;
        let _e87 = x_29;
        local_99 = ((8f * _e85) * _e87);
    } else {
        let _e91 = away;
        let _e93 = away;
        local_99 = (1f - ((8f * _e91) * _e93));
    }
    let _e97 = local_99;
    return (_e80 * _e97);
}

fn interfaceEtaAxis(eta_52: f32) -> f32 {
    var eta_53: f32;
    var local_100: f32;
    var n_49: f32;

    eta_53 = eta_52;
    let _e45 = eta_53;
    if (_e45 < 1f) {
        let _e49 = eta_53;
        local_100 = (1f / max(_e49, 0.01f));
    } else {
        let _e53 = eta_53;
        local_100 = _e53;
    }
    let _e55 = local_100;
    n_49 = clamp(_e55, 1f, INTERFACE_GREATEST_ETA);
    let _e59 = n_49;
    let _e62 = n_49;
    return (((_e59 - 1f) / (_e62 + 1f)) * 1.6666666f);
}

fn interfaceEnergyCoordinate(cosTheta_43: f32, alpha_94: f32, eta_54: f32) -> vec3<f32> {
    var cosTheta_44: f32;
    var alpha_95: f32;
    var eta_55: f32;
    var local_101: i32;

    cosTheta_44 = cosTheta_43;
    alpha_95 = alpha_94;
    eta_55 = eta_54;
    let _e49 = cosTheta_44;
    let _e50 = eta_55;
    let _e51 = interfaceCosineAxis(_e49, _e50);
    let _e54 = blockCoordinate(_e51, INTERFACE_ENERGY_COSINES, 0i, 1i);
    let _e55 = alpha_95;
    let _e61 = blockCoordinate(sqrt(max(_e55, 0f)), INTERFACE_ENERGY_ALPHAS, 0i, 1i);
    let _e62 = eta_55;
    let _e63 = interfaceEtaAxis(_e62);
    let _e64 = eta_55;
    if (_e64 < 1f) {
        local_101 = 1i;
    } else {
        local_101 = 0i;
    }
    let _e70 = local_101;
    let _e72 = blockCoordinate(_e63, INTERFACE_SLICES, _e70, 2i);
    return vec3<f32>(_e54, _e61, _e72);
}

fn interfaceLobeCoordinate(lobe_5: i32, lobes_6: i32, cosTheta_45: f32, alpha_96: f32, eta_56: f32) -> vec3<f32> {
    var lobe_6: i32;
    var lobes_7: i32;
    var cosTheta_46: f32;
    var alpha_97: f32;
    var eta_57: f32;
    var local_102: i32;

    lobe_6 = lobe_5;
    lobes_7 = lobes_6;
    cosTheta_46 = cosTheta_45;
    alpha_97 = alpha_96;
    eta_57 = eta_56;
    let _e53 = cosTheta_46;
    let _e54 = eta_57;
    let _e55 = interfaceCosineAxis(_e53, _e54);
    let _e58 = blockCoordinate(_e55, INTERFACE_LOBE_COSINES, 0i, 1i);
    let _e59 = alpha_97;
    let _e63 = lobe_6;
    let _e64 = lobes_7;
    let _e65 = blockCoordinate(sqrt(max(_e59, 0f)), INTERFACE_LOBE_ALPHAS, _e63, _e64);
    let _e66 = eta_57;
    let _e67 = interfaceEtaAxis(_e66);
    let _e68 = eta_57;
    if (_e68 < 1f) {
        local_102 = 1i;
    } else {
        local_102 = 0i;
    }
    let _e74 = local_102;
    let _e76 = blockCoordinate(_e67, INTERFACE_SLICES, _e74, 2i);
    return vec3<f32>(_e58, _e65, _e76);
}

fn interfaceSnell(cosTheta_47: f32, eta_58: f32) -> f32 {
    var cosTheta_48: f32;
    var eta_59: f32;
    var c_32: f32;

    cosTheta_48 = cosTheta_47;
    eta_59 = eta_58;
    let _e47 = cosTheta_48;
    c_32 = clamp(_e47, 0f, 1f);
    let _e53 = c_32;
    let _e56 = c_32;
    let _e60 = c_32;
    let _e61 = eta_59;
    let _e62 = fresnelG(_e60, _e61);
    return atan2(sqrt(((1f - _e53) * (1f + _e56))), _e62);
}

fn interfaceWidth(cosTheta_49: f32, alpha_98: f32, eta_60: f32) -> f32 {
    var cosTheta_50: f32;
    var alpha_99: f32;
    var eta_61: f32;
    var g_9: f32;
    var critical_2: f32;
    var across_12: f32;
    var cosT: f32;
    var lean_3: f32;
    var width_5: f32;

    cosTheta_50 = cosTheta_49;
    alpha_99 = alpha_98;
    eta_61 = eta_60;
    let _e49 = cosTheta_50;
    let _e53 = eta_61;
    let _e54 = fresnelG(clamp(_e49, 0f, 1f), _e53);
    g_9 = _e54;
    let _e57 = eta_61;
    let _e60 = eta_61;
    critical_2 = sqrt(max(((1f - _e57) * (1f + _e60)), 0f));
    let _e67 = eta_61;
    let _e70 = eta_61;
    let _e75 = eta_61;
    let _e76 = g_9;
    let _e77 = cosTheta_50;
    let _e78 = critical_2;
    across_12 = (abs(((_e67 - 1f) * (_e70 + 1f))) / max((_e75 * (_e76 + max(_e77, _e78))), LEAST_DIVISOR));
    let _e85 = g_9;
    let _e86 = eta_61;
    cosT = (_e85 / _e86);
    let _e89 = alpha_99;
    let _e90 = critical_2;
    let _e91 = cosTheta_50;
    lean_3 = (_e89 + max((_e90 - _e91), 0f));
    let _e97 = lean_3;
    let _e98 = across_12;
    let _e100 = cosT;
    let _e101 = cosT;
    let _e103 = lean_3;
    width_5 = ((_e97 * _e98) * inverseSqrt(sqrt(((_e100 * _e101) + max(_e103, LEAST_LENGTH2)))));
    let _e110 = width_5;
    let _e113 = width_5;
    return (_e110 / (1f + (2f * _e113)));
}

fn interfaceEnergy(texel_5: vec4<f32>) -> InterfaceEnergy {
    var texel_6: vec4<f32>;
    var e_7: InterfaceEnergy;

    texel_6 = texel_5;
    let _e47 = texel_6;
    e_7.transmitted = _e47.x;
    let _e50 = texel_6;
    e_7.reflected = _e50.y;
    let _e52 = e_7;
    return _e52;
}

fn interfaceLobe(texel_7: vec4<f32>, cosTheta_51: f32, alpha_100: f32, eta_62: f32) -> InterfaceLobe {
    var texel_8: vec4<f32>;
    var cosTheta_52: f32;
    var alpha_101: f32;
    var eta_63: f32;
    var width_6: f32;
    var lobe_7: InterfaceLobe;

    texel_8 = texel_7;
    cosTheta_52 = cosTheta_51;
    alpha_101 = alpha_100;
    eta_63 = eta_62;
    let _e51 = cosTheta_52;
    let _e52 = alpha_101;
    let _e56 = eta_63;
    let _e57 = interfaceWidth(_e51, clamp(_e52, 0f, 1f), _e56);
    width_6 = _e57;
    let _e61 = cosTheta_52;
    let _e62 = eta_63;
    let _e63 = interfaceSnell(_e61, _e62);
    let _e64 = texel_8;
    let _e66 = width_6;
    lobe_7.angle = (_e63 + (_e64.x * _e66));
    let _e70 = texel_8;
    let _e72 = width_6;
    lobe_7.sigma = (_e70.y * _e72);
    let _e75 = texel_8;
    lobe_7.weight = _e75.z;
    let _e77 = lobe_7;
    return _e77;
}

fn interfaceLobeDirection(wo_56: vec3<f32>, n_50: vec3<f32>, angle_2: f32) -> vec3<f32> {
    var wo_57: vec3<f32>;
    var n_51: vec3<f32>;
    var angle_3: f32;
    var across_13: vec3<f32>;
    var local_103: vec3<f32>;

    wo_57 = wo_56;
    n_51 = n_50;
    angle_3 = angle_2;
    let _e49 = wo_57;
    let _e50 = n_51;
    let _e52 = n_51;
    let _e54 = wo_57;
    across_13 = ((dot(_e49, _e50) * _e52) - _e54);
    let _e57 = across_13;
    let _e58 = across_13;
    if !((dot(_e57, _e58) > LEAST_LENGTH2)) {
        let _e62 = n_51;
        let _e63 = n_51;
        if (abs(_e63.x) < 0.7f) {
            local_103 = vec3<f32>(1f, 0f, 0f);
        } else {
            local_103 = vec3<f32>(0f, 1f, 0f);
        }
        let _e77 = local_103;
        across_13 = cross(_e62, _e77);
    }
    let _e79 = angle_3;
    let _e81 = across_13;
    let _e84 = angle_3;
    let _e86 = n_51;
    return ((sin(_e79) * normalize(_e81)) - (cos(_e84) * _e86));
}

fn pyramidVariance(level_1: f32) -> f32 {
    var level_2: f32;
    var scale_5: f32;

    level_2 = level_1;
    let _e46 = level_2;
    scale_5 = exp2((2f * _e46));
    let _e51 = scale_5;
    let _e55 = scale_5;
    return ((0.25f * (_e51 - 1f)) + (_e55 / 6f));
}

fn pyramidLevel(variance_3: f32, lastLevel: f32) -> f32 {
    var variance_4: f32;
    var lastLevel_1: f32;
    var scale_6: f32;
    var exact: f32;
    var below_7: f32;
    var low_8: f32;
    var high_3: f32;

    variance_4 = variance_3;
    lastLevel_1 = lastLevel;
    let _e47 = variance_4;
    scale_6 = ((_e47 + 0.25f) / 0.4166667f);
    let _e58 = scale_6;
    exact = (0.5f * log2(max(_e58, 1f)));
    let _e64 = exact;
    let _e66 = lastLevel_1;
    below_7 = min(floor(_e64), _e66);
    let _e69 = below_7;
    let _e70 = pyramidVariance(_e69);
    low_8 = _e70;
    let _e72 = below_7;
    let _e75 = pyramidVariance((_e72 + 1f));
    high_3 = _e75;
    let _e77 = below_7;
    let _e78 = variance_4;
    let _e79 = low_8;
    let _e81 = high_3;
    let _e82 = low_8;
    let _e89 = lastLevel_1;
    return min((_e77 + clamp(((_e78 - _e79) / (_e81 - _e82)), 0f, 1f)), _e89);
}

fn normalIntegral(x_30: f32) -> f32 {
    var x_31: f32;

    x_31 = x_30;
    let _e49 = x_31;
    return (1f / (1f + exp((-1.702f * _e49))));
}

fn pyramidCoverage(at_25: vec2<f32>, size_23: vec2<f32>, sigma_10: f32) -> f32 {
    var at_26: vec2<f32>;
    var size_24: vec2<f32>;
    var sigma_11: f32;
    var inverse: f32;
    var x_32: f32;
    var y_12: f32;

    at_26 = at_25;
    size_24 = size_23;
    sigma_11 = sigma_10;
    let _e50 = sigma_11;
    inverse = (1f / max(_e50, 0.25f));
    let _e55 = size_24;
    let _e57 = at_26;
    let _e60 = inverse;
    let _e62 = normalIntegral(((_e55.x - _e57.x) * _e60));
    let _e63 = at_26;
    let _e66 = inverse;
    let _e68 = normalIntegral((-(_e63.x) * _e66));
    x_32 = (_e62 - _e68);
    let _e71 = size_24;
    let _e73 = at_26;
    let _e76 = inverse;
    let _e78 = normalIntegral(((_e71.y - _e73.y) * _e76));
    let _e79 = at_26;
    let _e82 = inverse;
    let _e84 = normalIntegral((-(_e79.y) * _e82));
    y_12 = (_e78 - _e84);
    let _e87 = x_32;
    let _e88 = y_12;
    return clamp((_e87 * _e88), 0f, 1f);
}

fn lobeVariance(sigma_12: f32, carried: f32, inner_4: f32, inside_3: f32, outside: f32) -> f32 {
    var sigma_13: f32;
    var carried_1: f32;
    var inner_5: f32;
    var inside_4: f32;
    var outside_1: f32;
    var offset: f32;
    var angle_4: f32;

    sigma_13 = sigma_12;
    carried_1 = carried;
    inner_5 = inner_4;
    inside_4 = inside_3;
    outside_1 = outside;
    let _e53 = inside_4;
    let _e54 = inner_5;
    offset = (_e53 * _e54);
    let _e57 = outside_1;
    let _e58 = sigma_13;
    angle_4 = (_e57 * _e58);
    let _e61 = angle_4;
    let _e62 = angle_4;
    let _e65 = offset;
    let _e67 = outside_1;
    let _e69 = carried_1;
    let _e70 = sigma_13;
    let _e74 = offset;
    let _e75 = offset;
    return (((_e61 * _e62) + (((2f * _e65) * _e67) * min(_e69, _e70))) + (_e74 * _e75));
}

fn pixelsPerRadian(focal: f32, cosine: f32) -> f32 {
    var focal_1: f32;
    var cosine_1: f32;

    focal_1 = focal;
    cosine_1 = cosine;
    let _e47 = focal_1;
    let _e48 = cosine_1;
    let _e49 = cosine_1;
    return (_e47 / (_e48 * sqrt(_e49)));
}

fn lobeRadiance(lobe_8: ComposedLobe, origin_16: vec3<f32>, inside_5: f32, met_5: SceneIntersection, view_31: SceneView) -> vec3<f32> {
    var lobe_9: ComposedLobe;
    var origin_17: vec3<f32>;
    var inside_6: f32;
    var met_6: SceneIntersection;
    var view_32: SceneView;
    var ends: bool;
    var local_104: vec3<f32>;
    var place: vec3<f32>;
    var local_105: f32;
    var clip_4: vec4<f32>;
    var share_5: f32 = 0f;
    var near_1: vec3<f32> = vec3(0f);
    var local_106: vec3<f32>;
    var fromEye: vec3<f32>;
    var range_2: f32;
    var metres: f32;
    var local_107: f32;
    var pixels: f32;
    var at_27: vec2<f32>;
    var outside_2: vec2<f32>;
    var far_1: f32;
    var local_108: f32;
    var shown: vec4<f32>;
    var local_109: vec3<f32>;
    var local_110: vec3<f32>;

    lobe_9 = lobe_8;
    origin_17 = origin_16;
    inside_6 = inside_5;
    met_6 = met_5;
    view_32 = view_31;
    let _e53 = met_6;
    ends = (_e53.metres >= 0f);
    let _e58 = ends;
    if _e58 {
        let _e59 = origin_17;
        let _e60 = met_6;
        let _e62 = lobe_9;
        local_104 = (_e59 + (_e60.metres * _e62.direction));
    } else {
        let _e66 = lobe_9;
        local_104 = _e66.direction;
    }
    let _e69 = local_104;
    place = _e69;
    let _e71 = view_32;
    let _e73 = place;
    let _e74 = ends;
    if _e74 {
        local_105 = 1f;
    } else {
        local_105 = 0f;
    }
    let _e78 = local_105;
    clip_4 = (_e71.clipFromWorld * vec4<f32>(_e73.x, _e73.y, _e73.z, _e78));
    let _e90 = met_6;
    let _e92 = clip_4;
    if (_e90.seen && (_e92.w > 0f)) {
        {
            let _e97 = ends;
            if _e97 {
                let _e98 = place;
                let _e99 = view_32;
                local_106 = (_e98 - _e99.eye);
            } else {
                let _e102 = lobe_9;
                local_106 = _e102.direction;
            }
            let _e105 = local_106;
            fromEye = _e105;
            let _e107 = fromEye;
            range_2 = length(_e107);
            let _e110 = lobe_9;
            let _e112 = lobe_9;
            let _e114 = lobe_9;
            let _e116 = inside_6;
            let _e117 = met_6;
            let _e119 = lobeVariance(_e110.sigma, _e112.carried, _e114.inner, _e116, _e117.metres);
            let _e120 = met_6;
            let _e122 = met_6;
            metres = sqrt((_e119 + (_e120.behind * _e122.behind)));
            let _e128 = ends;
            if _e128 {
                let _e129 = metres;
                let _e130 = range_2;
                local_107 = (_e129 / _e130);
            } else {
                let _e132 = lobe_9;
                local_107 = _e132.sigma;
            }
            let _e135 = local_107;
            let _e136 = view_32;
            let _e138 = clip_4;
            let _e140 = range_2;
            let _e144 = pixelsPerRadian(_e136.focal, min((_e138.w / _e140), 1f));
            pixels = (_e135 * _e144);
            let _e147 = clip_4;
            let _e148 = view_32;
            let _e150 = scenePixel(_e147, _e148.size);
            at_27 = _e150;
            let _e152 = at_27;
            let _e154 = at_27;
            let _e155 = view_32;
            outside_2 = max(max(-(_e152), (_e154 - _e155.size)), vec2(0f));
            let _e163 = outside_2;
            let _e164 = outside_2;
            far_1 = dot(_e163, _e164);
            let _e167 = ends;
            if _e167 {
                let _e170 = far_1;
                let _e172 = view_32;
                let _e175 = view_32;
                local_108 = exp(((-0.5f * _e170) / (_e172.size.y * _e175.size.y)));
            } else {
                let _e181 = at_27;
                let _e182 = view_32;
                let _e184 = pixels;
                let _e185 = pyramidCoverage(_e181, _e182.size, _e184);
                local_108 = _e185;
            }
            let _e187 = local_108;
            share_5 = _e187;
            let _e188 = share_5;
            if (_e188 > 0f) {
                {
                    let _e191 = at_27;
                    let _e192 = pixels;
                    let _e193 = pixels;
                    let _e195 = far_1;
                    let _e197 = engineSceneColor(_e191, ((_e192 * _e193) + _e195));
                    shown = _e197;
                    let _e199 = share_5;
                    let _e201 = shown;
                    share_5 = (_e199 * min((2f * _e201.w), 1f));
                    let _e207 = shown;
                    if (_e207.w > 0f) {
                        let _e211 = shown;
                        let _e213 = shown;
                        let _e215 = shown;
                        let _e218 = shown;
                        local_109 = (vec3<f32>(_e211.x, _e213.y, _e215.z) / vec3(_e218.w));
                    } else {
                        local_109 = vec3(0f);
                    }
                    let _e225 = local_109;
                    near_1 = _e225;
                }
            }
        }
    }
    let _e226 = share_5;
    if (_e226 >= 0.999f) {
        let _e229 = near_1;
        local_110 = _e229;
    } else {
        let _e230 = lobe_9;
        let _e232 = lobe_9;
        let _e234 = engineEnvironment(_e230.direction, _e232.sigma);
        let _e235 = near_1;
        let _e236 = share_5;
        local_110 = mix(_e234, _e235, vec3(_e236));
    }
    let _e240 = local_110;
    return _e240;
}

fn engineFaceEnergy(cosTheta_53: f32, alpha_102: f32, eta_64: f32) -> InterfaceEnergy {
    var cosTheta_54: f32;
    var alpha_103: f32;
    var eta_65: f32;
    var smoothly: InterfaceEnergy;

    cosTheta_54 = cosTheta_53;
    alpha_103 = alpha_102;
    eta_65 = eta_64;
    let _e50 = alpha_103;
    if (_e50 < SMOOTH_ALPHA) {
        {
            let _e54 = cosTheta_54;
            let _e55 = eta_65;
            let _e56 = fresnelTransmittedAt(_e54, _e55);
            smoothly.transmitted = _e56;
            let _e59 = smoothly;
            smoothly.reflected = (1f - _e59.transmitted);
            let _e62 = smoothly;
            return _e62;
        }
    }
    let _e63 = cosTheta_54;
    let _e64 = alpha_103;
    let _e65 = eta_65;
    let _e66 = interfaceEnergyCoordinate(_e63, _e64, _e65);
    let _e67 = engineInterfaceEnergy(_e66);
    let _e68 = interfaceEnergy(_e67);
    return _e68;
}

fn reflectGlass(face_10: GlassFace, ior: f32, view_33: SceneView) -> vec3<f32> {
    var face_11: GlassFace;
    var ior_1: f32;
    var view_34: SceneView;
    var cosTheta_55: f32;
    var energy_3: f32;
    var texel_9: vec4<f32> = vec4(0f);
    var lobe_10: ComposedLobe;
    var met_7: SceneIntersection;

    face_11 = face_10;
    ior_1 = ior;
    view_34 = view_33;
    let _e50 = face_11;
    let _e52 = face_11;
    cosTheta_55 = dot(_e50.wo, _e52.n);
    let _e56 = cosTheta_55;
    let _e57 = face_11;
    let _e59 = ior_1;
    let _e60 = engineFaceEnergy(_e56, _e57.alpha, _e59);
    energy_3 = _e60.reflected;
    let _e66 = face_11;
    if (_e66.alpha >= SMOOTH_ALPHA) {
        let _e69 = cosTheta_55;
        let _e70 = face_11;
        let _e72 = ior_1;
        let _e73 = fresnelNormalIncidence(_e72);
        let _e74 = energy_3;
        let _e75 = edgeShare(_e73, _e74);
        let _e76 = lobeCoordinate(_e69, _e70.alpha, _e75);
        let _e77 = engineReflectionLobe(_e76);
        texel_9 = _e77;
    }
    let _e81 = cosTheta_55;
    let _e83 = face_11;
    let _e86 = face_11;
    let _e89 = face_11;
    let _e91 = texel_9;
    let _e93 = lobeDirection((((2f * _e81) * _e83.n) - _e86.wo), _e89.n, _e91.x);
    lobe_10.direction = _e93;
    let _e95 = texel_9;
    let _e97 = texel_9;
    let _e100 = face_11;
    let _e103 = face_11;
    let _e107 = face_11;
    lobe_10.sigma = sqrt(((((_e95.y * _e97.y) * _e100.alpha) * _e103.alpha) + (4f * _e107.turn)));
    let _e113 = energy_3;
    lobe_10.weight = _e113;
    lobe_10.inner = 0f;
    lobe_10.carried = 0f;
    let _e118 = face_11;
    let _e120 = lobe_10;
    let _e122 = view_34;
    let _e123 = sceneIntersection(_e118.position, _e120.direction, _e122);
    met_7 = _e123;
    let _e125 = energy_3;
    let _e126 = lobe_10;
    let _e127 = face_11;
    let _e130 = met_7;
    let _e131 = view_34;
    let _e132 = lobeRadiance(_e126, _e127.position, 0f, _e130, _e131);
    return (_e125 * _e132);
}

fn engineFaceLobes(cosTheta_56: f32, alpha_104: f32, eta_66: f32) -> FaceLobes {
    var cosTheta_57: f32;
    var alpha_105: f32;
    var eta_67: f32;
    var core_6: vec4<f32> = vec4<f32>(0f, 0f, 1f, 0f);
    var tail_5: vec4<f32> = vec4(0f);
    var at_28: vec3<f32>;
    var lobes_8: FaceLobes;

    cosTheta_57 = cosTheta_56;
    alpha_105 = alpha_104;
    eta_67 = eta_66;
    let _e59 = alpha_105;
    if (_e59 >= SMOOTH_ALPHA) {
        {
            let _e63 = cosTheta_57;
            let _e64 = alpha_105;
            let _e65 = eta_67;
            let _e66 = interfaceLobeCoordinate(0i, 2i, _e63, _e64, _e65);
            at_28 = _e66;
            let _e68 = at_28;
            let _e69 = engineInterfaceLobe(_e68);
            core_6 = _e69;
            let _e70 = at_28;
            let _e76 = engineInterfaceLobe((_e70 + vec3<f32>(0f, 0.5f, 0f)));
            tail_5 = _e76;
        }
    }
    let _e79 = core_6;
    let _e80 = cosTheta_57;
    let _e81 = alpha_105;
    let _e82 = eta_67;
    let _e83 = interfaceLobe(_e79, _e80, _e81, _e82);
    lobes_8.core = _e83;
    let _e85 = tail_5;
    let _e86 = cosTheta_57;
    let _e87 = alpha_105;
    let _e88 = eta_67;
    let _e89 = interfaceLobe(_e85, _e86, _e87, _e88);
    lobes_8.tail = _e89;
    let _e90 = lobes_8;
    return _e90;
}

fn engineEnteringLobe(read_: InterfaceLobe, face_12: GlassFace, ior_2: f32, energy_4: f32) -> InnerLobe {
    var read_1: InterfaceLobe;
    var face_13: GlassFace;
    var ior_3: f32;
    var energy_5: f32;
    var inner_6: InnerLobe;
    var matched: bool;
    var local_111: vec3<f32>;
    var local_112: f32;
    var local_113: f32;

    read_1 = read_;
    face_13 = face_12;
    ior_3 = ior_2;
    energy_5 = energy_4;
    let _e53 = ior_3;
    matched = (abs((_e53 - 1f)) < INDEX_MATCHED);
    let _e60 = matched;
    if _e60 {
        let _e61 = face_13;
        local_111 = -(_e61.wo);
    } else {
        let _e64 = face_13;
        let _e66 = face_13;
        let _e68 = read_1;
        let _e70 = interfaceLobeDirection(_e64.wo, _e66.n, _e68.angle);
        local_111 = _e70;
    }
    let _e72 = local_111;
    inner_6.direction = _e72;
    let _e74 = matched;
    if _e74 {
        local_112 = 0f;
    } else {
        let _e76 = read_1;
        local_112 = _e76.sigma;
    }
    let _e79 = local_112;
    inner_6.sigma = _e79;
    let _e81 = read_1;
    let _e83 = matched;
    if _e83 {
        local_113 = 1f;
    } else {
        let _e85 = energy_5;
        local_113 = _e85;
    }
    let _e87 = local_113;
    inner_6.weight = (_e81.weight * _e87);
    let _e89 = inner_6;
    return _e89;
}

fn engineLeavingPair(inner_7: InnerLobe, core_7: bool, s_19: ExitSurface, k_25: Widening) -> ComposedPair {
    var inner_8: InnerLobe;
    var core_8: bool;
    var s_20: ExitSurface;
    var k_26: Widening;
    var view_35: ExitView;
    var cosTheta_58: f32;
    var local_114: f32;
    var energy_6: f32;
    var lobes_9: FaceLobes;
    var one_1: ComposedPair;

    inner_8 = inner_7;
    core_8 = core_7;
    s_20 = s_19;
    k_26 = k_25;
    let _e52 = inner_8;
    let _e53 = core_8;
    let _e54 = s_20;
    let _e55 = k_26;
    let _e56 = seeExit(_e52, _e53, _e54, _e55);
    view_35 = _e56;
    let _e58 = view_35;
    cosTheta_58 = max(_e58.cosTheta, 0f);
    let _e63 = s_20;
    if (abs((_e63.eta - 1f)) < INDEX_MATCHED) {
        local_114 = 1f;
    } else {
        let _e70 = cosTheta_58;
        let _e71 = view_35;
        let _e73 = s_20;
        let _e75 = engineFaceEnergy(_e70, _e71.alphaEnergy, _e73.eta);
        local_114 = _e75.transmitted;
    }
    let _e78 = local_114;
    energy_6 = _e78;
    let _e80 = cosTheta_58;
    let _e81 = view_35;
    let _e83 = s_20;
    let _e85 = engineFaceLobes(_e80, _e81.alphaShape, _e83.eta);
    lobes_9 = _e85;
    let _e87 = view_35;
    if (_e87.alphaShape < SMOOTH_ALPHA) {
        {
            let _e92 = inner_8;
            let _e93 = view_35;
            let _e94 = s_20;
            let _e95 = lobes_9;
            let _e98 = lobes_9;
            let _e102 = energy_6;
            let _e103 = composeLobe(_e92, _e93, _e94, _e95.core.angle, _e98.core.sigma, 1f, _e102);
            one_1.core = _e103;
            let _e105 = one_1;
            one_1.rest = _e105.core;
            one_1.rest.weight = 0f;
            let _e110 = one_1;
            return _e110;
        }
    }
    let _e111 = inner_8;
    let _e112 = view_35;
    let _e113 = s_20;
    let _e114 = lobes_9;
    let _e117 = lobes_9;
    let _e120 = lobes_9;
    let _e123 = energy_6;
    let _e124 = composeLobe(_e111, _e112, _e113, _e114.core.angle, _e117.core.sigma, _e120.core.weight, _e123);
    let _e125 = inner_8;
    let _e126 = view_35;
    let _e127 = s_20;
    let _e128 = lobes_9;
    let _e131 = lobes_9;
    let _e134 = lobes_9;
    let _e137 = energy_6;
    let _e138 = composeLobe(_e125, _e126, _e127, _e128.tail.angle, _e131.tail.sigma, _e134.tail.weight, _e137);
    let _e139 = view_35;
    let _e140 = composedPair(_e124, _e138, _e139);
    return _e140;
}

fn internalScatteringLossGgx() -> InternalScatteringLoss {
    var k_27: InternalScatteringLoss;

    k_27.linear = 0.635f;
    k_27.constant = 0.254f;
    k_27.thin = 1.078f;
    k_27.passes = 0.3f;
    let _e53 = k_27;
    return _e53;
}

fn internalScatteringLossBeckmann() -> InternalScatteringLoss {
    var k_28: InternalScatteringLoss;

    k_28.linear = 0.201f;
    k_28.constant = 1.555f;
    k_28.thin = 0.565f;
    k_28.passes = 0f;
    let _e53 = k_28;
    return _e53;
}

fn internalScatteringPasses(ior_4: f32) -> f32 {
    var ior_5: f32;
    var eta_68: f32;
    var passes: f32;
    var local_115: f32;

    ior_5 = ior_4;
    let _e46 = ior_5;
    let _e48 = ior_5;
    eta_68 = max(_e46, (1f / _e48));
    let _e54 = eta_68;
    let _e55 = fresnelTransmittedAt(0.355051f, _e54);
    let _e59 = eta_68;
    let _e60 = fresnelTransmittedAt(0.844949f, _e59);
    passes = ((0.363917f * _e55) + (0.636083f * _e60));
    let _e64 = ior_5;
    if (_e64 > 1f) {
        let _e67 = passes;
        let _e68 = ior_5;
        let _e69 = ior_5;
        local_115 = (_e67 / (_e68 * _e69));
    } else {
        let _e72 = passes;
        local_115 = _e72;
    }
    let _e74 = local_115;
    return _e74;
}

fn internalScatteringAt(alpha_106: f32, ior_6: f32, k_29: InternalScatteringLoss) -> InternalScattering {
    var alpha_107: f32;
    var ior_7: f32;
    var k_30: InternalScatteringLoss;
    var smoothly_1: f32;
    var alpha2_1: f32;
    var lost_3: f32;
    var w_27: InternalScattering;

    alpha_107 = alpha_106;
    ior_7 = ior_6;
    k_30 = k_29;
    let _e50 = ior_7;
    let _e51 = internalScatteringPasses(_e50);
    smoothly_1 = _e51;
    let _e53 = alpha_107;
    let _e54 = alpha_107;
    alpha2_1 = (_e53 * _e54);
    let _e57 = alpha2_1;
    let _e58 = alpha2_1;
    let _e59 = k_30;
    let _e61 = alpha_107;
    let _e64 = k_30;
    let _e69 = k_30;
    let _e71 = alpha_107;
    let _e73 = smoothly_1;
    lost_3 = ((_e57 / ((_e58 + (_e59.linear * _e61)) + _e64.constant)) * max((1f - ((_e69.thin * _e71) * max((_e73 - 0.4f), 0f))), 0f));
    let _e86 = smoothly_1;
    let _e88 = k_30;
    let _e90 = alpha2_1;
    w_27.passes = (_e86 * (1f - (_e88.passes * _e90)));
    let _e96 = w_27;
    let _e99 = lost_3;
    w_27.back = max(((1f - _e96.passes) - _e99), 0f);
    let _e103 = w_27;
    return _e103;
}

fn internalScatteringConcave(w_28: InternalScattering, again: f32) -> InternalScattering {
    var w_29: InternalScattering;
    var again_1: f32;
    var concave: InternalScattering;

    w_29 = w_28;
    again_1 = again;
    let _e51 = again_1;
    let _e53 = w_29;
    concave.passes = ((1f - _e51) * _e53.passes);
    let _e57 = w_29;
    let _e59 = again_1;
    let _e60 = w_29;
    concave.back = (_e57.back + (_e59 * _e60.passes));
    let _e64 = concave;
    return _e64;
}

fn internalScatteringEscapes(w_30: InternalScattering, way_7: vec3<f32>) -> vec3<f32> {
    var w_31: InternalScattering;
    var way_8: vec3<f32>;

    w_31 = w_30;
    way_8 = way_7;
    let _e48 = w_31;
    let _e50 = way_8;
    let _e54 = w_31;
    let _e56 = way_8;
    let _e59 = w_31;
    return ((_e48.passes * _e50) / max((vec3(1f) - (_e54.back * _e56)), vec3(_e59.passes)));
}

fn internallyReflected(face_14: GlassFace, body_2: ConvexBody, inner_9: InnerLobe, entered: f32, e_8: ConvexExit, passed: f32) -> vec3<f32> {
    var face_15: GlassFace;
    var body_3: ConvexBody;
    var inner_10: InnerLobe;
    var entered_1: f32;
    var e_9: ConvexExit;
    var passed_1: f32;
    var cosTheta_59: f32;
    var own_2: InterfaceEnergy;
    var w_32: InternalScattering;
    var way_9: vec3<f32>;
    var weight_3: vec3<f32>;
    var reflected: vec3<f32>;
    var q_2: f32;
    var near_2: vec3<f32>;
    var outward_3: vec3<f32>;
    var spread_5: f32;
    var local_116: vec3<f32>;
    var direction_26: vec3<f32>;

    face_15 = face_14;
    body_3 = body_2;
    inner_10 = inner_9;
    entered_1 = entered;
    e_9 = e_8;
    passed_1 = passed;
    let _e58 = inner_10;
    let _e60 = e_9;
    cosTheta_59 = max(dot(_e58.direction, _e60.surface.n), 0f);
    let _e67 = cosTheta_59;
    let _e68 = body_3;
    let _e70 = e_9;
    let _e73 = engineFaceEnergy(_e67, _e68.backAlpha, _e70.surface.eta);
    own_2 = _e73;
    let _e77 = passed_1;
    w_32.passes = _e77;
    let _e79 = own_2;
    let _e81 = own_2;
    let _e84 = passed_1;
    w_32.back = clamp(((_e79.transmitted + _e81.reflected) - _e84), 0f, 0.99f);
    let _e89 = e_9;
    let _e92 = body_3;
    way_9 = exp((-(_e89.path) * _e92.attenuation));
    let _e97 = entered_1;
    let _e99 = w_32;
    let _e102 = way_9;
    let _e104 = w_32;
    let _e105 = way_9;
    let _e106 = internalScatteringEscapes(_e104, _e105);
    weight_3 = ((((SCATTERED_SEEN * _e97) * _e99.back) * _e102) * _e106);
    let _e109 = weight_3;
    let _e111 = weight_3;
    let _e113 = weight_3;
    if (max(_e109.x, max(_e111.y, _e113.z)) < SCATTERED_LEAST) {
        return vec3(0f);
    }
    let _e120 = inner_10;
    let _e123 = cosTheta_59;
    let _e125 = e_9;
    reflected = (_e120.direction - ((2f * _e123) * _e125.surface.n));
    let _e131 = body_3;
    let _e133 = body_3;
    q_2 = clamp((_e131.thickness * _e133.curvature), 0f, 2f);
    let _e140 = face_15;
    let _e142 = e_9;
    let _e146 = cosTheta_59;
    let _e148 = reflected;
    let _e152 = q_2;
    near_2 = normalize(mix(_e140.n, (_e142.surface.n + ((2f * _e146) * _e148)), vec3((0.5f * _e152))));
    let _e158 = reflected;
    let _e160 = near_2;
    let _e162 = e_9;
    let _e165 = refractAbout(-(_e158), -(_e160), _e162.surface.eta);
    outward_3 = _e165;
    let _e167 = inner_10;
    let _e169 = inner_10;
    let _e173 = body_3;
    let _e176 = body_3;
    let _e181 = body_3;
    spread_5 = (sqrt(((_e167.sigma * _e169.sigma) + ((4f * _e173.backAlpha) * _e176.backAlpha))) * _e181.ior);
    let _e185 = outward_3;
    let _e186 = outward_3;
    if (dot(_e185, _e186) > 0f) {
        let _e190 = outward_3;
        local_116 = _e190;
    } else {
        let _e191 = near_2;
        local_116 = _e191;
    }
    let _e193 = local_116;
    direction_26 = _e193;
    let _e195 = weight_3;
    let _e196 = direction_26;
    let _e197 = spread_5;
    let _e200 = engineEnvironment(_e196, min(_e197, 0.606f));
    return (_e195 * _e200);
}

fn enterGlass(face_16: GlassFace, ior_8: f32) -> Entering {
    var face_17: GlassFace;
    var ior_9: f32;
    var e_10: Entering;
    var cosTheta_60: f32;
    var lobes_10: FaceLobes;

    face_17 = face_16;
    ior_9 = ior_8;
    let _e51 = face_17;
    let _e53 = face_17;
    cosTheta_60 = dot(_e51.wo, _e53.n);
    let _e58 = cosTheta_60;
    let _e59 = face_17;
    let _e61 = ior_9;
    let _e62 = engineFaceEnergy(_e58, _e59.alpha, _e61);
    e_10.energy = _e62.transmitted;
    let _e64 = cosTheta_60;
    let _e65 = face_17;
    let _e67 = ior_9;
    let _e68 = engineFaceLobes(_e64, _e65.alpha, _e67);
    lobes_10 = _e68;
    let _e71 = lobes_10;
    let _e73 = face_17;
    let _e74 = ior_9;
    let _e75 = e_10;
    let _e77 = engineEnteringLobe(_e71.core, _e73, _e74, _e75.energy);
    e_10.core = _e77;
    let _e79 = lobes_10;
    let _e81 = face_17;
    let _e82 = ior_9;
    let _e83 = e_10;
    let _e85 = engineEnteringLobe(_e79.tail, _e81, _e82, _e83.energy);
    e_10.tail = _e85;
    let _e86 = e_10;
    return _e86;
}

fn leaveGlass(face_18: GlassFace, body_4: ConvexBody, e_11: Entering, coreExit: ConvexExit, tailExit: ConvexExit, k_31: Widening) -> Leaving {
    var face_19: GlassFace;
    var body_5: ConvexBody;
    var e_12: Entering;
    var coreExit_1: ConvexExit;
    var tailExit_1: ConvexExit;
    var k_32: Widening;
    var leaving: Leaving;
    var local_117: f32;
    var bent: f32;

    face_19 = face_18;
    body_5 = body_4;
    e_12 = e_11;
    coreExit_1 = coreExit;
    tailExit_1 = tailExit;
    k_32 = k_31;
    let _e60 = e_12;
    let _e63 = coreExit_1;
    let _e65 = k_32;
    let _e66 = engineLeavingPair(_e60.core, true, _e63.surface, _e65);
    leaving.pair = _e66;
    let _e68 = e_12;
    if (_e68.core.weight > 0f) {
        let _e73 = leaving;
        let _e77 = leaving;
        let _e82 = e_12;
        local_117 = ((_e73.pair.core.weight + _e77.pair.rest.weight) / _e82.core.weight);
    } else {
        local_117 = 0f;
    }
    let _e88 = local_117;
    leaving.passed = _e88;
    let _e89 = e_12;
    if (_e89.tail.weight > 0f) {
        let _e95 = leaving;
        let _e97 = e_12;
        let _e100 = tailExit_1;
        let _e102 = k_32;
        let _e103 = engineLeavingPair(_e97.tail, false, _e100.surface, _e102);
        let _e104 = mergePairs(_e95.pair, _e103);
        leaving.pair = _e104;
    }
    let _e108 = body_5;
    bent = (2f * (1f - (1f / _e108.ior)));
    let _e117 = leaving;
    let _e121 = leaving;
    let _e126 = bent;
    let _e127 = bent;
    let _e129 = face_19;
    leaving.pair.core.sigma = sqrt(((_e117.pair.core.sigma * _e121.pair.core.sigma) + ((_e126 * _e127) * _e129.turn)));
    let _e134 = leaving;
    return _e134;
}

fn pairRadiance(pair_3: ComposedPair, origin_18: vec3<f32>, inside_7: f32, view_36: SceneView) -> vec3<f32> {
    var pair_4: ComposedPair;
    var origin_19: vec3<f32>;
    var inside_8: f32;
    var view_37: SceneView;
    var met_8: SceneIntersection;
    var sum_13: vec3<f32> = vec3(0f);
    var lobe_11: ComposedLobe;
    var which_8: i32 = 0i;

    pair_4 = pair_3;
    origin_19 = origin_18;
    inside_8 = inside_7;
    view_37 = view_36;
    let _e54 = origin_19;
    let _e55 = pair_4;
    let _e58 = view_37;
    let _e59 = sceneIntersection(_e54, _e55.core.direction, _e58);
    met_8 = _e59;
    let _e64 = pair_4;
    lobe_11 = _e64.core;
    loop {
        let _e69 = which_8;
        let _e72 = which_8;
        let _e75 = lobe_11;
        if !(((_e69 < 2i) && ((_e72 == 0i) || (_e75.weight > 0f)))) {
            break;
        }
        {
            let _e85 = sum_13;
            let _e86 = lobe_11;
            let _e88 = lobe_11;
            let _e89 = origin_19;
            let _e90 = inside_8;
            let _e91 = met_8;
            let _e92 = view_37;
            let _e93 = lobeRadiance(_e88, _e89, _e90, _e91, _e92);
            sum_13 = (_e85 + (_e86.weight * _e93));
            let _e96 = pair_4;
            lobe_11 = _e96.rest;
        }
        continuing {
            let _e82 = which_8;
            which_8 = (_e82 + 1i);
        }
    }
    let _e98 = sum_13;
    return _e98;
}

fn refractThrough(face_20: GlassFace, body_6: ConvexBody, e_13: Entering, origin_20: vec3<f32>, coreExit_2: ConvexExit, tailExit_2: ConvexExit, view_38: SceneView, k_33: Widening) -> vec3<f32> {
    var face_21: GlassFace;
    var body_7: ConvexBody;
    var e_14: Entering;
    var origin_21: vec3<f32>;
    var coreExit_3: ConvexExit;
    var tailExit_3: ConvexExit;
    var view_39: SceneView;
    var k_34: Widening;
    var left_2: Leaving;
    var sum_14: vec3<f32>;

    face_21 = face_20;
    body_7 = body_6;
    e_14 = e_13;
    origin_21 = origin_20;
    coreExit_3 = coreExit_2;
    tailExit_3 = tailExit_2;
    view_39 = view_38;
    k_34 = k_33;
    let _e62 = face_21;
    let _e63 = body_7;
    let _e64 = e_14;
    let _e65 = coreExit_3;
    let _e66 = tailExit_3;
    let _e67 = k_34;
    let _e68 = leaveGlass(_e62, _e63, _e64, _e65, _e66, _e67);
    left_2 = _e68;
    let _e70 = left_2;
    let _e72 = origin_21;
    let _e73 = coreExit_3;
    let _e75 = view_39;
    let _e76 = pairRadiance(_e70.pair, _e72, _e73.path, _e75);
    sum_14 = _e76;
    let _e78 = sum_14;
    let _e79 = coreExit_3;
    let _e82 = body_7;
    let _e87 = face_21;
    let _e88 = body_7;
    let _e89 = e_14;
    let _e91 = e_14;
    let _e93 = coreExit_3;
    let _e94 = left_2;
    let _e96 = internallyReflected(_e87, _e88, _e89.core, _e91.energy, _e93, _e94.passed);
    return ((_e78 * exp((-(_e79.path) * _e82.attenuation))) + _e96);
}

fn refractConvex(face_22: GlassFace, body_8: ConvexBody, view_40: SceneView, k_35: Widening) -> vec3<f32> {
    var face_23: GlassFace;
    var body_9: ConvexBody;
    var view_41: SceneView;
    var k_36: Widening;
    var e_15: Entering;
    var core_9: ConvexExit;
    var origin_22: vec3<f32>;

    face_23 = face_22;
    body_9 = body_8;
    view_41 = view_40;
    k_36 = k_35;
    let _e54 = face_23;
    let _e55 = body_9;
    let _e57 = enterGlass(_e54, _e55.ior);
    e_15 = _e57;
    let _e59 = face_23;
    let _e61 = e_15;
    let _e64 = body_9;
    let _e65 = convexExit(_e59.n, _e61.core.direction, _e64);
    core_9 = _e65;
    let _e67 = face_23;
    let _e69 = core_9;
    let _e71 = e_15;
    origin_22 = (_e67.position + (_e69.path * _e71.core.direction));
    let _e77 = face_23;
    let _e78 = body_9;
    let _e79 = e_15;
    let _e80 = origin_22;
    let _e81 = core_9;
    let _e82 = face_23;
    let _e84 = e_15;
    let _e87 = body_9;
    let _e88 = convexExit(_e82.n, _e84.tail.direction, _e87);
    let _e89 = view_41;
    let _e90 = k_36;
    let _e91 = refractThrough(_e77, _e78, _e79, _e80, _e81, _e88, _e89, _e90);
    return _e91;
}

fn wayOut(origin_23: vec3<f32>, lobe_12: InnerLobe, eta_69: f32, which_9: FaceLayer, reflections: i32, view_42: SceneView) -> WayOut {
    var origin_24: vec3<f32>;
    var lobe_13: InnerLobe;
    var eta_70: f32;
    var which_10: FaceLayer;
    var reflections_1: i32;
    var view_43: SceneView;
    var way_10: WayOut;
    var onward: InnerLobe;
    var first_8: f32 = 0f;
    var k_37: i32 = 0i;
    var seen_2: BackFaceExit;
    var before: f32;
    var cosTheta_61: f32;
    var alpha_108: f32;

    origin_24 = origin_23;
    lobe_13 = lobe_12;
    eta_70 = eta_69;
    which_10 = which_9;
    reflections_1 = reflections;
    view_43 = view_42;
    let _e60 = lobe_13;
    way_10.lobe = _e60;
    let _e62 = origin_24;
    way_10.point = _e62;
    let _e64 = lobe_13;
    let _e66 = eta_70;
    let _e67 = noBackFace(_e64.direction, _e66);
    way_10.exit = _e67.exit;
    way_10.found = false;
    let _e71 = lobe_13;
    onward = _e71;
    loop {
        let _e77 = k_37;
        let _e78 = reflections_1;
        if !((_e77 <= _e78)) {
            break;
        }
        {
            let _e84 = way_10;
            let _e86 = onward;
            let _e88 = first_8;
            let _e89 = eta_70;
            let _e90 = which_10;
            let _e91 = view_43;
            let _e92 = backFaceExit(_e84.point, _e86.direction, _e88, _e89, _e90, _e91);
            seen_2 = _e92;
            let _e94 = seen_2;
            if !(_e94.found) {
                break;
            }
            let _e97 = way_10;
            before = _e97.exit.path;
            let _e102 = onward;
            way_10.lobe = _e102;
            let _e104 = seen_2;
            way_10.exit = _e104.exit;
            let _e108 = before;
            let _e109 = seen_2;
            way_10.exit.path = (_e108 + _e109.exit.path);
            let _e114 = way_10;
            let _e116 = seen_2;
            let _e119 = onward;
            way_10.point = (_e114.point + (_e116.exit.path * _e119.direction));
            way_10.found = true;
            let _e125 = onward;
            let _e127 = seen_2;
            cosTheta_61 = dot(_e125.direction, _e127.exit.surface.n);
            let _e133 = k_37;
            let _e134 = reflections_1;
            let _e137 = cosTheta_61;
            let _e140 = cosTheta_61;
            let _e143 = eta_70;
            let _e144 = eta_70;
            if ((_e133 == _e134) || (((1f - _e137) * (1f + _e140)) < (_e143 * _e144))) {
                break;
            }
            let _e148 = seen_2;
            alpha_108 = _e148.exit.surface.alpha;
            let _e154 = onward;
            let _e157 = cosTheta_61;
            let _e159 = seen_2;
            onward.direction = (_e154.direction - ((2f * _e157) * _e159.exit.surface.n));
            let _e166 = onward;
            let _e168 = onward;
            let _e172 = alpha_108;
            let _e174 = alpha_108;
            onward.sigma = sqrt(((_e166.sigma * _e168.sigma) + ((4f * _e172) * _e174)));
            let _e179 = onward;
            let _e181 = cosTheta_61;
            let _e182 = alpha_108;
            let _e183 = eta_70;
            let _e184 = engineFaceEnergy(_e181, _e182, _e183);
            onward.weight = (_e179.weight * _e184.reflected);
            let _e188 = seen_2;
            first_8 = (0.5f * _e188.exit.path);
        }
        continuing {
            let _e81 = k_37;
            k_37 = (_e81 + 1i);
        }
    }
    let _e192 = way_10;
    return _e192;
}

fn convexWayOut(face_24: GlassFace, lobe_14: InnerLobe, body_10: ConvexBody) -> WayOut {
    var face_25: GlassFace;
    var lobe_15: InnerLobe;
    var body_11: ConvexBody;
    var way_11: WayOut;

    face_25 = face_24;
    lobe_15 = lobe_14;
    body_11 = body_10;
    let _e54 = lobe_15;
    way_11.lobe = _e54;
    let _e56 = face_25;
    let _e58 = lobe_15;
    let _e60 = body_11;
    let _e61 = convexExit(_e56.n, _e58.direction, _e60);
    way_11.exit = _e61;
    let _e63 = face_25;
    let _e65 = way_11;
    let _e68 = lobe_15;
    way_11.point = (_e63.position + (_e65.exit.path * _e68.direction));
    way_11.found = false;
    let _e74 = way_11;
    return _e74;
}

fn leavingFaces(layer_2: i32, number: f32) -> FaceLayer {
    var layer_3: i32;
    var number_1: f32;
    var which_11: FaceLayer;

    layer_3 = layer_2;
    number_1 = number;
    let _e52 = layer_3;
    which_11.layer = _e52;
    which_11.side = 1f;
    let _e56 = number_1;
    which_11.number = _e56;
    let _e57 = which_11;
    return _e57;
}

fn waysOut(face_26: GlassFace, body_12: ConvexBody, entered_2: Entering, last_2: i32, number_2: f32, reflections_2: i32, view_44: SceneView) -> WaysOut {
    var face_27: GlassFace;
    var body_13: ConvexBody;
    var entered_3: Entering;
    var last_3: i32;
    var number_3: f32;
    var reflections_3: i32;
    var view_45: SceneView;
    var ways: WaysOut;
    var layer_4: i32 = BACK_FACES;
    var seen_3: WayOut;
    var core_10: InnerLobe;
    var widened: f32;
    var local_118: f32;

    face_27 = face_26;
    body_13 = body_12;
    entered_3 = entered_2;
    last_3 = last_2;
    number_3 = number_2;
    reflections_3 = reflections_2;
    view_45 = view_44;
    let _e62 = face_27;
    let _e63 = entered_3;
    let _e65 = body_13;
    let _e66 = convexWayOut(_e62, _e63.core, _e65);
    ways.core = _e66;
    let _e68 = face_27;
    let _e69 = entered_3;
    let _e71 = body_13;
    let _e72 = convexWayOut(_e68, _e69.tail, _e71);
    ways.tail = _e72;
    loop {
        let _e74 = layer_4;
        let _e75 = last_3;
        let _e77 = ways;
        if !(((_e74 <= _e75) && !(_e77.core.found))) {
            break;
        }
        {
            let _e88 = face_27;
            let _e90 = entered_3;
            let _e93 = body_13;
            let _e96 = layer_4;
            let _e97 = number_3;
            let _e98 = leavingFaces(_e96, _e97);
            let _e99 = reflections_3;
            let _e100 = view_45;
            let _e101 = wayOut(_e88.position, _e90.core, (1f / _e93.ior), _e98, _e99, _e100);
            seen_3 = _e101;
            let _e103 = seen_3;
            if _e103.found {
                let _e106 = seen_3;
                ways.core = _e106;
            }
        }
        continuing {
            let _e83 = layer_4;
            layer_4 = (_e83 + 2i);
        }
    }
    let _e107 = ways;
    if _e107.core.found {
        {
            let _e110 = ways;
            core_10 = _e110.core.lobe;
            let _e115 = ways;
            ways.tail = _e115.core;
            let _e120 = entered_3;
            let _e123 = core_10;
            let _e126 = entered_3;
            ways.tail.lobe.direction = normalize(((_e120.tail.direction + _e123.direction) - _e126.core.direction));
            let _e131 = core_10;
            let _e133 = core_10;
            let _e136 = entered_3;
            let _e139 = entered_3;
            widened = ((_e131.sigma * _e133.sigma) - (_e136.core.sigma * _e139.core.sigma));
            let _e148 = entered_3;
            let _e151 = entered_3;
            let _e155 = widened;
            ways.tail.lobe.sigma = sqrt(((_e148.tail.sigma * _e151.tail.sigma) + max(_e155, 0f)));
            let _e163 = entered_3;
            if (_e163.core.weight > 0f) {
                let _e168 = entered_3;
                let _e171 = core_10;
                let _e174 = entered_3;
                local_118 = ((_e168.tail.weight * _e171.weight) / _e174.core.weight);
            } else {
                local_118 = 0f;
            }
            let _e180 = local_118;
            ways.tail.lobe.weight = _e180;
        }
    }
    let _e181 = ways;
    return _e181;
}

fn refractFrontBack(face_28: GlassFace, body_14: ConvexBody, number_4: f32, view_46: SceneView, k_38: Widening) -> vec3<f32> {
    var face_29: GlassFace;
    var body_15: ConvexBody;
    var number_5: f32;
    var view_47: SceneView;
    var k_39: Widening;
    var entered_4: Entering;
    var ways_1: WaysOut;

    face_29 = face_28;
    body_15 = body_14;
    number_5 = number_4;
    view_47 = view_46;
    k_39 = k_38;
    let _e56 = face_29;
    let _e57 = body_15;
    let _e59 = enterGlass(_e56, _e57.ior);
    entered_4 = _e59;
    let _e61 = face_29;
    let _e62 = body_15;
    let _e63 = entered_4;
    let _e64 = number_5;
    let _e66 = view_47;
    let _e67 = waysOut(_e61, _e62, _e63, BACK_FACES, _e64, 1i, _e66);
    ways_1 = _e67;
    let _e70 = ways_1;
    entered_4.core = _e70.core.lobe;
    let _e74 = ways_1;
    entered_4.tail = _e74.tail.lobe;
    let _e77 = face_29;
    let _e78 = body_15;
    let _e79 = entered_4;
    let _e80 = ways_1;
    let _e83 = ways_1;
    let _e86 = ways_1;
    let _e89 = view_47;
    let _e90 = k_39;
    let _e91 = refractThrough(_e77, _e78, _e79, _e80.core.point, _e83.core.exit, _e86.tail.exit, _e89, _e90);
    return _e91;
}

fn lobeSide(direction_27: vec3<f32>) -> vec3<f32> {
    var direction_28: vec3<f32>;
    var level_3: vec3<f32>;
    var s_21: f32;
    var local_119: vec3<f32>;

    direction_28 = direction_27;
    let _e48 = direction_28;
    let _e51 = direction_28;
    level_3 = vec3<f32>(_e48.z, 0f, -(_e51.x));
    let _e56 = level_3;
    let _e57 = level_3;
    s_21 = dot(_e56, _e57);
    let _e60 = s_21;
    if (_e60 > 0f) {
        let _e63 = level_3;
        let _e64 = s_21;
        local_119 = (_e63 * inverseSqrt(_e64));
    } else {
        local_119 = vec3<f32>(1f, 0f, 0f);
    }
    let _e72 = local_119;
    return _e72;
}

fn lobeStratum(direction_29: vec3<f32>, sigma_14: f32, inner_11: f32, carried_2: f32, part_1: vec3<f32>) -> LobeStratum {
    var direction_30: vec3<f32>;
    var sigma_15: f32;
    var inner_12: f32;
    var carried_3: f32;
    var part_2: vec3<f32>;
    var side_5: vec3<f32>;
    var off_3: vec3<f32>;
    var turn_2: f32;
    var p_17: LobeStratum;
    var local_120: f32;
    var local_121: f32;
    var together: f32;
    var rest_5: f32;
    var local_122: f32;

    direction_30 = direction_29;
    sigma_15 = sigma_14;
    inner_12 = inner_11;
    carried_3 = carried_2;
    part_2 = part_1;
    let _e56 = direction_30;
    let _e57 = lobeSide(_e56);
    side_5 = _e57;
    let _e59 = part_2;
    let _e61 = side_5;
    let _e63 = part_2;
    let _e65 = direction_30;
    let _e66 = side_5;
    off_3 = ((_e59.x * _e61) + (_e63.y * cross(_e65, _e66)));
    let _e71 = sigma_15;
    let _e72 = off_3;
    turn_2 = (_e71 * length(_e72));
    let _e78 = turn_2;
    let _e80 = direction_30;
    let _e82 = turn_2;
    if (_e82 > 0f) {
        let _e85 = turn_2;
        let _e87 = turn_2;
        local_120 = (sin(_e85) / _e87);
    } else {
        local_120 = 1f;
    }
    let _e91 = local_120;
    let _e92 = sigma_15;
    let _e94 = off_3;
    p_17.direction = ((cos(_e78) * _e80) + ((_e91 * _e92) * _e94));
    let _e98 = part_2;
    let _e100 = sigma_15;
    p_17.sigma = (_e98.z * _e100);
    let _e102 = sigma_15;
    if (_e102 > 0f) {
        let _e105 = carried_3;
        let _e106 = sigma_15;
        local_121 = clamp((_e105 / _e106), -1f, 1f);
    } else {
        local_121 = 0f;
    }
    let _e114 = local_121;
    together = _e114;
    let _e117 = together;
    let _e118 = inner_12;
    let _e120 = off_3;
    p_17.aside = ((_e117 * _e118) * _e120);
    let _e123 = together;
    let _e124 = together;
    let _e127 = part_2;
    let _e129 = part_2;
    rest_5 = sqrt(max((1f - ((_e123 * _e124) * (1f - (_e127.z * _e129.z)))), 0f));
    let _e140 = rest_5;
    let _e141 = inner_12;
    p_17.inner = (_e140 * _e141);
    let _e144 = rest_5;
    if (_e144 > 0f) {
        let _e147 = together;
        let _e148 = sigma_15;
        let _e150 = part_2;
        let _e153 = part_2;
        let _e156 = rest_5;
        local_122 = ((((_e147 * _e148) * _e150.z) * _e153.z) / _e156);
    } else {
        local_122 = 0f;
    }
    let _e160 = local_122;
    p_17.carried = _e160;
    let _e161 = p_17;
    return _e161;
}

fn thinWallCoordinate(lobe_16: i32, lobes_11: i32, cosTheta_62: f32, alpha_109: f32, eta_71: f32) -> vec3<f32> {
    var lobe_17: i32;
    var lobes_12: i32;
    var cosTheta_63: f32;
    var alpha_110: f32;
    var eta_72: f32;

    lobe_17 = lobe_16;
    lobes_12 = lobes_11;
    cosTheta_63 = cosTheta_62;
    alpha_110 = alpha_109;
    eta_72 = eta_71;
    let _e59 = cosTheta_63;
    let _e63 = tableCoordinate(sqrt(max(_e59, 0f)), THIN_WALL_COSINES);
    let _e64 = alpha_110;
    let _e68 = lobe_17;
    let _e69 = lobes_12;
    let _e70 = blockCoordinate(sqrt(max(_e64, 0f)), THIN_WALL_ALPHAS, _e68, _e69);
    let _e71 = eta_72;
    let _e72 = interfaceEtaAxis(_e71);
    let _e73 = tableCoordinate(_e72, THIN_WALL_SLICES);
    return vec3<f32>(_e63, _e70, _e73);
}

fn thinWallWidth(cosTheta_64: f32, alpha_111: f32, eta_73: f32) -> f32 {
    var cosTheta_65: f32;
    var alpha_112: f32;
    var eta_74: f32;
    var c_33: f32;
    var local_123: f32;
    var n_52: f32;
    var across_14: f32;
    var width_7: f32;

    cosTheta_65 = cosTheta_64;
    alpha_112 = alpha_111;
    eta_74 = eta_73;
    let _e55 = cosTheta_65;
    c_33 = clamp(_e55, 0f, 1f);
    let _e60 = eta_74;
    if (_e60 < 1f) {
        let _e64 = eta_74;
        local_123 = (1f / max(_e64, 0.01f));
    } else {
        let _e68 = eta_74;
        local_123 = _e68;
    }
    let _e70 = local_123;
    n_52 = _e70;
    let _e72 = n_52;
    let _e75 = n_52;
    let _e79 = c_33;
    let _e80 = n_52;
    let _e81 = fresnelG(_e79, _e80);
    let _e82 = c_33;
    across_14 = (((_e72 - 1f) * (_e75 + 1f)) / max((_e81 + _e82), LEAST_DIVISOR));
    let _e88 = alpha_112;
    let _e90 = across_14;
    let _e92 = c_33;
    let _e93 = c_33;
    let _e95 = alpha_112;
    width_7 = (((1.4142135f * _e88) * _e90) * inverseSqrt(sqrt(((_e92 * _e93) + max(_e95, LEAST_LENGTH2)))));
    let _e102 = width_7;
    let _e105 = width_7;
    return (_e102 / (1f + (2f * _e105)));
}

fn thinWallEnergy(texel_10: vec4<f32>) -> ThinWallEnergy {
    var texel_11: vec4<f32>;
    var e_16: ThinWallEnergy;

    texel_11 = texel_10;
    let _e53 = texel_11;
    e_16.transmitted = _e53.x;
    let _e56 = texel_11;
    e_16.reflectedFirst = _e56.y;
    let _e59 = texel_11;
    e_16.reflectedLater = _e59.z;
    let _e61 = e_16;
    return _e61;
}

fn thinWallLaterSpread(eta_75: f32) -> f32 {
    var eta_76: f32;
    var local_124: f32;
    var n_53: f32;

    eta_76 = eta_75;
    let _e51 = eta_76;
    if (_e51 < 1f) {
        let _e55 = eta_76;
        local_124 = (1f / max(_e55, 0.01f));
    } else {
        let _e59 = eta_76;
        local_124 = _e59;
    }
    let _e61 = local_124;
    n_53 = _e61;
    let _e63 = n_53;
    let _e64 = n_53;
    let _e67 = n_53;
    let _e71 = n_53;
    return sqrt(((_e63 * _e64) + ((0.5f * (_e67 - 1f)) * (_e71 - 1f))));
}

fn thinWallLobe(texel_12: vec4<f32>, cosTheta_66: f32, alpha_113: f32, eta_77: f32) -> InterfaceLobe {
    var texel_13: vec4<f32>;
    var cosTheta_67: f32;
    var alpha_114: f32;
    var eta_78: f32;
    var c_34: f32;
    var width_8: f32;
    var lobe_18: InterfaceLobe;

    texel_13 = texel_12;
    cosTheta_67 = cosTheta_66;
    alpha_114 = alpha_113;
    eta_78 = eta_77;
    let _e57 = cosTheta_67;
    c_34 = clamp(_e57, 0f, 1f);
    let _e62 = c_34;
    let _e63 = alpha_114;
    let _e67 = eta_78;
    let _e68 = thinWallWidth(_e62, clamp(_e63, 0f, 1f), _e67);
    width_8 = _e68;
    let _e73 = c_34;
    let _e76 = c_34;
    let _e80 = c_34;
    let _e82 = texel_13;
    let _e84 = width_8;
    lobe_18.angle = (atan2(sqrt(((1f - _e73) * (1f + _e76))), _e80) + (_e82.x * _e84));
    let _e88 = texel_13;
    let _e90 = width_8;
    lobe_18.sigma = (_e88.y * _e90);
    let _e93 = texel_13;
    lobe_18.weight = _e93.z;
    let _e95 = lobe_18;
    return _e95;
}

fn lobeOnward(lobe_19: ComposedLobe) -> InnerLobe {
    var lobe_20: ComposedLobe;
    var onward_1: InnerLobe;

    lobe_20 = lobe_19;
    let _e54 = lobe_20;
    onward_1.direction = _e54.direction;
    let _e57 = lobe_20;
    onward_1.sigma = _e57.sigma;
    let _e60 = lobe_20;
    onward_1.weight = _e60.weight;
    let _e62 = onward_1;
    return _e62;
}

fn throughSecondBody(pair_5: ComposedPair, origin_25: vec3<f32>, inside_9: f32, body_16: ConvexBody, view_48: SceneView, k_40: Widening) -> SecondBody {
    var pair_6: ComposedPair;
    var origin_26: vec3<f32>;
    var inside_10: f32;
    var body_17: ConvexBody;
    var view_49: SceneView;
    var k_41: Widening;
    var second_1: SecondBody;
    var fronts: FaceLayer;
    var front_1: BackFaceExit;
    var outer: InnerLobe;
    var entered_5: ComposedPair;
    var inner_13: InnerLobe;
    var point_4: vec3<f32>;
    var way_12: WayOut;
    var beyond_1: ComposedPair;
    var local_125: f32;
    var passed_2: f32;
    var aside: ComposedLobe;
    var cosTheta_68: f32;
    var alpha_115: f32;
    var weight_4: f32;
    var mirrored: vec3<f32>;

    pair_6 = pair_5;
    origin_26 = origin_25;
    inside_10 = inside_9;
    body_17 = body_16;
    view_49 = view_48;
    k_41 = k_40;
    let _e64 = pair_6;
    second_1.pair = _e64;
    let _e66 = origin_26;
    second_1.origin = _e66;
    let _e68 = inside_10;
    second_1.inside = _e68;
    second_1.passed = vec3(1f);
    second_1.reflected = vec3(0f);
    let _e77 = leavingFaces(SECOND_FRONTS, -1f);
    fronts = _e77;
    fronts.side = -1f;
    let _e82 = origin_26;
    let _e83 = pair_6;
    let _e87 = body_17;
    let _e89 = fronts;
    let _e90 = view_49;
    let _e91 = backFaceExit(_e82, _e83.core.direction, 0f, _e87.ior, _e89, _e90);
    front_1 = _e91;
    let _e93 = front_1;
    if !(_e93.found) {
        let _e96 = second_1;
        return _e96;
    }
    let _e97 = pair_6;
    let _e99 = lobeOnward(_e97.core);
    outer = _e99;
    let _e101 = outer;
    let _e103 = front_1;
    let _e106 = k_41;
    let _e107 = engineLeavingPair(_e101, true, _e103.exit.surface, _e106);
    entered_5 = _e107;
    let _e109 = entered_5;
    let _e111 = entered_5;
    let _e113 = mergeLobes(_e109.core, _e111.rest);
    let _e114 = lobeOnward(_e113);
    inner_13 = _e114;
    let _e116 = origin_26;
    let _e117 = front_1;
    let _e120 = outer;
    point_4 = (_e116 + (_e117.exit.path * _e120.direction));
    let _e125 = point_4;
    let _e126 = inner_13;
    let _e128 = body_17;
    let _e131 = front_1;
    let _e133 = leavingFaces(SECOND_BACKS, _e131.number);
    let _e134 = view_49;
    let _e135 = wayOut(_e125, _e126, (1f / _e128.ior), _e133, REFLECTIONS_INSIDE, _e134);
    way_12 = _e135;
    let _e137 = way_12;
    if !(_e137.found) {
        let _e140 = second_1;
        return _e140;
    }
    let _e141 = way_12;
    let _e144 = way_12;
    let _e147 = k_41;
    let _e148 = engineLeavingPair(_e141.lobe, true, _e144.exit.surface, _e147);
    beyond_1 = _e148;
    let _e151 = front_1;
    let _e154 = way_12;
    let _e157 = body_17;
    second_1.inside = (_e151.exit.path + (_e154.exit.path / _e157.ior));
    let _e163 = outer;
    beyond_1.core.inner = _e163.sigma;
    let _e167 = outer;
    beyond_1.rest.inner = _e167.sigma;
    let _e169 = outer;
    if (_e169.weight > 0f) {
        let _e173 = beyond_1;
        let _e176 = beyond_1;
        let _e180 = outer;
        local_125 = ((_e173.core.weight + _e176.rest.weight) / _e180.weight);
    } else {
        local_125 = 0f;
    }
    let _e185 = local_125;
    passed_2 = _e185;
    let _e187 = pair_6;
    aside = _e187.rest;
    let _e191 = pair_6;
    let _e194 = beyond_1;
    let _e198 = pair_6;
    aside.direction = normalize(((_e191.rest.direction + _e194.core.direction) - _e198.core.direction));
    let _e204 = aside;
    let _e206 = passed_2;
    aside.weight = (_e204.weight * _e206);
    let _e209 = beyond_1;
    let _e211 = aside;
    let _e212 = mergeLobes(_e209.rest, _e211);
    beyond_1.rest = _e212;
    let _e214 = beyond_1;
    second_1.pair = _e214;
    let _e216 = way_12;
    second_1.origin = _e216.point;
    let _e219 = way_12;
    let _e223 = body_17;
    second_1.passed = exp((-(_e219.exit.path) * _e223.attenuation));
    let _e227 = outer;
    let _e229 = front_1;
    cosTheta_68 = dot(_e227.direction, _e229.exit.surface.n);
    let _e235 = front_1;
    alpha_115 = _e235.exit.surface.alpha;
    let _e240 = pair_6;
    let _e243 = pair_6;
    let _e247 = cosTheta_68;
    let _e248 = alpha_115;
    let _e249 = body_17;
    let _e251 = engineFaceEnergy(_e247, _e248, _e249.ior);
    weight_4 = ((_e240.core.weight + _e243.rest.weight) * _e251.reflected);
    let _e255 = outer;
    let _e258 = cosTheta_68;
    let _e260 = front_1;
    mirrored = (_e255.direction - ((2f * _e258) * _e260.exit.surface.n));
    let _e268 = weight_4;
    let _e269 = mirrored;
    let _e270 = outer;
    let _e272 = outer;
    let _e276 = alpha_115;
    let _e278 = alpha_115;
    let _e284 = engineEnvironment(_e269, min(sqrt(((_e270.sigma * _e272.sigma) + ((4f * _e276) * _e278))), 0.606f));
    second_1.reflected = (_e268 * _e284);
    let _e286 = second_1;
    return _e286;
}

fn refractTwoPairs(face_30: GlassFace, body_18: ConvexBody, number_6: f32, view_50: SceneView, k_42: Widening) -> vec3<f32> {
    var face_31: GlassFace;
    var body_19: ConvexBody;
    var number_7: f32;
    var view_51: SceneView;
    var k_43: Widening;
    var entered_6: Entering;
    var ways_2: WaysOut;
    var exit_1: ConvexExit;
    var left_3: Leaving;
    var second_2: SecondBody;
    var sum_15: vec3<f32>;

    face_31 = face_30;
    body_19 = body_18;
    number_7 = number_6;
    view_51 = view_50;
    k_43 = k_42;
    let _e60 = face_31;
    let _e61 = body_19;
    let _e63 = enterGlass(_e60, _e61.ior);
    entered_6 = _e63;
    let _e65 = face_31;
    let _e66 = body_19;
    let _e67 = entered_6;
    let _e68 = number_7;
    let _e69 = view_51;
    let _e70 = waysOut(_e65, _e66, _e67, SECOND_BACKS, _e68, REFLECTIONS_INSIDE, _e69);
    ways_2 = _e70;
    let _e73 = ways_2;
    entered_6.core = _e73.core.lobe;
    let _e77 = ways_2;
    entered_6.tail = _e77.tail.lobe;
    let _e80 = ways_2;
    exit_1 = _e80.core.exit;
    let _e84 = face_31;
    let _e85 = body_19;
    let _e86 = entered_6;
    let _e87 = exit_1;
    let _e88 = ways_2;
    let _e91 = k_43;
    let _e92 = leaveGlass(_e84, _e85, _e86, _e87, _e88.tail.exit, _e91);
    left_3 = _e92;
    let _e94 = left_3;
    let _e96 = ways_2;
    let _e99 = exit_1;
    let _e101 = body_19;
    let _e102 = view_51;
    let _e103 = k_43;
    let _e104 = throughSecondBody(_e94.pair, _e96.core.point, _e99.path, _e101, _e102, _e103);
    second_2 = _e104;
    let _e106 = second_2;
    let _e108 = second_2;
    let _e110 = second_2;
    let _e112 = second_2;
    let _e114 = view_51;
    let _e115 = pairRadiance(_e108.pair, _e110.origin, _e112.inside, _e114);
    let _e117 = second_2;
    sum_15 = ((_e106.passed * _e115) + _e117.reflected);
    let _e121 = sum_15;
    let _e122 = exit_1;
    let _e125 = body_19;
    let _e130 = face_31;
    let _e131 = body_19;
    let _e132 = entered_6;
    let _e134 = entered_6;
    let _e136 = exit_1;
    let _e137 = left_3;
    let _e139 = internallyReflected(_e130, _e131, _e132.core, _e134.energy, _e136, _e137.passed);
    return ((_e121 * exp((-(_e122.path) * _e125.attenuation))) + _e139);
}
