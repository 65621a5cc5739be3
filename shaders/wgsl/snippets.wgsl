// Made by shaders/wgsl/make of 55d141aa826672e1ce0f0a851e3ee405fd89e91d9c4e82a0c455db553feb8b11: do not edit.
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

struct BackFaceExit {
    exit: ConvexExit,
    number: f32,
    found: bool,
}

struct PixelSteps {
    right: vec3<f32>,
    down: vec3<f32>,
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

struct FaceLobes {
    core: InterfaceLobe,
    tail: InterfaceLobe,
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
const LEAST_SWING: f32 = 0.05f;
const LEAVES_NEXT: f32 = 0.65f;
const EXIT_NOWHERE: f32 = -2f;
const EXIT_FAR: f32 = 1000000000000000000000000000000f;
const EXIT_STEPS: i32 = 12i;
const SCENE_GUESSES: i32 = 4i;
const SCENE_STEPS: i32 = 12i;
const SCENE_SECANTS: i32 = 5i;
const BACK_FACES: i32 = 0i;
const SECOND_FRONTS: i32 = 1i;
const SECOND_BACKS: i32 = 2i;
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
    let _e6 = v_1;
    let _e8 = v_1;
    let _e11 = v_1;
    let _e13 = v_1;
    t.p = ((_e6.x * _e8.x) + (_e11.y * _e13.y));
    let _e18 = v_1;
    t.z = abs(_e18.z);
    let _e21 = t;
    return _e21;
}

fn tiltAbout(v_2: vec3<f32>, n: vec3<f32>) -> Tilt {
    var v_3: vec3<f32>;
    var n_1: vec3<f32>;
    var across: vec3<f32>;
    var t_1: Tilt;

    v_3 = v_2;
    n_1 = n;
    let _e6 = v_3;
    let _e7 = n_1;
    across = cross(_e6, _e7);
    let _e12 = across;
    let _e13 = across;
    t_1.p = dot(_e12, _e13);
    let _e16 = v_3;
    let _e17 = n_1;
    t_1.z = abs(dot(_e16, _e17));
    let _e20 = t_1;
    return _e20;
}

fn tiltCos(t_2: Tilt) -> f32 {
    var t_3: Tilt;
    var s: f32;
    var local: f32;

    t_3 = t_2;
    let _e4 = t_3;
    let _e6 = t_3;
    let _e8 = t_3;
    s = (_e4.p + (_e6.z * _e8.z));
    let _e13 = s;
    if (_e13 > 0f) {
        let _e16 = t_3;
        let _e18 = s;
        local = (_e16.z / sqrt(_e18));
    } else {
        local = 0f;
    }
    let _e23 = local;
    return _e23;
}

fn reflectionHalf(wi: vec3<f32>, wo: vec3<f32>) -> vec3<f32> {
    var wi_1: vec3<f32>;
    var wo_1: vec3<f32>;

    wi_1 = wi;
    wo_1 = wo;
    let _e6 = wi_1;
    let _e7 = wo_1;
    return (_e6 + _e7);
}

fn transmissionHalf(wi_2: vec3<f32>, wo_2: vec3<f32>, eta: f32) -> vec3<f32> {
    var wi_3: vec3<f32>;
    var wo_3: vec3<f32>;
    var eta_1: f32;

    wi_3 = wi_2;
    wo_3 = wo_2;
    eta_1 = eta;
    let _e8 = wi_3;
    let _e9 = wo_3;
    let _e11 = eta_1;
    let _e14 = wi_3;
    return ((_e8 + _e9) + ((_e11 - 1f) * _e14));
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
    let _e10 = wi_5;
    let _e11 = wo_5;
    let _e12 = reflectionHalf(_e10, _e11);
    h = _e12;
    let _e14 = wi_5;
    let _e15 = n_3;
    cosI = dot(_e14, _e15);
    let _e18 = wo_5;
    let _e19 = n_3;
    cosO = dot(_e18, _e19);
    let _e24 = wi_5;
    let _e25 = n_3;
    let _e26 = tiltAbout(_e24, _e25);
    f.wi = _e26;
    let _e28 = wo_5;
    let _e29 = n_3;
    let _e30 = tiltAbout(_e28, _e29);
    f.wo = _e30;
    let _e32 = h;
    let _e33 = n_3;
    let _e34 = tiltAbout(_e32, _e33);
    f.h = _e34;
    let _e36 = h;
    let _e37 = h;
    f.s = dot(_e36, _e37);
    let _e41 = f;
    f.woDotM = min((0.5f * sqrt(_e41.s)), 1f);
    let _e48 = f;
    f.wiDotM = _e48.woDotM;
    let _e51 = eta_3;
    let _e54 = eta_3;
    let _e58 = f;
    let _e60 = f;
    f.g = sqrt(max((((_e51 - 1f) * (_e54 + 1f)) + (_e58.woDotM * _e60.woDotM)), 0f));
    let _e68 = cosI;
    let _e71 = cosO;
    let _e75 = cosI;
    let _e78 = cosO;
    let _e83 = f;
    f.exists = ((((_e68 > 0f) && (_e71 > 0f)) || ((_e75 < 0f) && (_e78 < 0f))) && (_e83.h.z > 0f));
    let _e89 = f;
    return _e89;
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
    let _e10 = wi_7;
    let _e11 = wo_7;
    let _e12 = eta_5;
    let _e13 = transmissionHalf(_e10, _e11, _e12);
    h_1 = _e13;
    let _e15 = wi_7;
    let _e16 = n_5;
    cosI_1 = dot(_e15, _e16);
    let _e19 = wo_7;
    let _e20 = n_5;
    cosO_1 = dot(_e19, _e20);
    let _e23 = h_1;
    let _e24 = n_5;
    let _e26 = cosO_1;
    if ((dot(_e23, _e24) * _e26) < 0f) {
        local_1 = -1f;
    } else {
        local_1 = 1f;
    }
    let _e34 = local_1;
    side = _e34;
    let _e38 = wi_7;
    let _e39 = n_5;
    let _e40 = tiltAbout(_e38, _e39);
    f_1.wi = _e40;
    let _e42 = wo_7;
    let _e43 = n_5;
    let _e44 = tiltAbout(_e42, _e43);
    f_1.wo = _e44;
    let _e46 = h_1;
    let _e47 = n_5;
    let _e48 = tiltAbout(_e46, _e47);
    f_1.h = _e48;
    let _e50 = h_1;
    let _e51 = h_1;
    f_1.s = dot(_e50, _e51);
    let _e53 = side;
    let _e54 = h_1;
    let _e55 = wi_7;
    hDotI = (_e53 * dot(_e54, _e55));
    let _e59 = side;
    let _e60 = h_1;
    let _e61 = wo_7;
    hDotO = (_e59 * dot(_e60, _e61));
    let _e65 = cosI_1;
    let _e68 = cosO_1;
    let _e72 = cosI_1;
    let _e75 = cosO_1;
    let _e80 = eta_5;
    let _e84 = eta_5;
    possible = (((((_e65 > 0f) && (_e68 < 0f)) || ((_e72 < 0f) && (_e75 > 0f))) && (_e80 > 0f)) && (_e84 != 1f));
    let _e90 = possible;
    let _e91 = f_1;
    let _e97 = hDotI;
    let _e101 = hDotO;
    f_1.exists = (((_e90 && (_e91.h.z > 0f)) && (_e97 < 0f)) && (_e101 > 0f));
    let _e105 = f_1;
    if _e105.exists {
        let _e107 = f_1;
        local_2 = inverseSqrt(_e107.s);
    } else {
        local_2 = 0f;
    }
    let _e112 = local_2;
    scale = _e112;
    let _e115 = hDotI;
    let _e117 = scale;
    f_1.wiDotM = min((abs(_e115) * _e117), 1f);
    let _e122 = hDotO;
    let _e124 = scale;
    f_1.woDotM = min((abs(_e122) * _e124), 1f);
    let _e129 = eta_5;
    let _e130 = f_1;
    f_1.g = (_e129 * _e130.wiDotM);
    let _e133 = f_1;
    return _e133;
}

fn reflectionJacobian(f_2: Facet) -> f32 {
    var f_3: Facet;
    var local_3: f32;

    f_3 = f_2;
    let _e4 = f_3;
    if _e4.exists {
        let _e7 = f_3;
        local_3 = (0.25f / _e7.woDotM);
    } else {
        local_3 = 0f;
    }
    let _e12 = local_3;
    return _e12;
}

fn transmissionJacobian(f_4: Facet, eta_6: f32) -> f32 {
    var f_5: Facet;
    var eta_7: f32;
    var local_4: f32;

    f_5 = f_4;
    eta_7 = eta_6;
    let _e6 = f_5;
    if _e6.exists {
        let _e8 = eta_7;
        let _e9 = eta_7;
        let _e11 = f_5;
        let _e14 = f_5;
        local_4 = (((_e8 * _e9) * _e11.wiDotM) / _e14.s);
    } else {
        local_4 = 0f;
    }
    let _e19 = local_4;
    return _e19;
}

fn beckmannD(m: Tilt, alpha: f32) -> f32 {
    var m_1: Tilt;
    var alpha_1: f32;
    var width: f32;
    var width2_: f32;
    var t_4: f32;

    m_1 = m;
    alpha_1 = alpha;
    let _e6 = alpha_1;
    let _e7 = m_1;
    width = (_e6 * _e7.z);
    let _e11 = width;
    let _e12 = width;
    width2_ = (_e11 * _e12);
    let _e15 = m_1;
    let _e18 = width2_;
    if !((_e15.p < (2000f * _e18))) {
        return 0f;
    }
    let _e25 = m_1;
    let _e28 = width2_;
    let _e31 = alpha_1;
    let _e33 = m_1;
    let _e35 = m_1;
    let _e37 = m_1;
    let _e42 = width2_;
    t_4 = (((exp(((-0.5f * _e25.p) / _e28)) * _e31) * (_e33.p + (_e35.z * _e37.z))) / _e42);
    let _e45 = t_4;
    let _e46 = t_4;
    return ((_e45 * _e46) / BSDF_PI);
}

fn beckmannG1OverZ(w: Tilt, alpha_2: f32) -> f32 {
    var w_1: Tilt;
    var alpha_3: f32;
    var r: f32;
    var z: f32;
    var local_5: f32;

    w_1 = w;
    alpha_3 = alpha_2;
    let _e6 = alpha_3;
    let _e7 = w_1;
    r = (_e6 * sqrt(_e7.p));
    let _e12 = w_1;
    z = _e12.z;
    let _e15 = z;
    let _e17 = r;
    if (_e15 >= (1.6f * _e17)) {
        let _e20 = z;
        if (_e20 > 0f) {
            let _e24 = z;
            local_5 = (1f / _e24);
        } else {
            local_5 = 0f;
        }
        let _e28 = local_5;
        return _e28;
    }
    let _e30 = r;
    let _e33 = z;
    let _e36 = r;
    let _e37 = r;
    let _e40 = r;
    let _e42 = z;
    let _e46 = z;
    let _e48 = z;
    return (((3.535f * _e30) + (2.181f * _e33)) / (((_e36 * _e37) + ((2.276f * _e40) * _e42)) + ((2.577f * _e46) * _e48)));
}

fn beckmannG1(w_2: Tilt, alpha_4: f32) -> f32 {
    var w_3: Tilt;
    var alpha_5: f32;

    w_3 = w_2;
    alpha_5 = alpha_4;
    let _e6 = w_3;
    let _e7 = alpha_5;
    let _e8 = beckmannG1OverZ(_e6, _e7);
    let _e9 = w_3;
    return (_e8 * _e9.z);
}

fn beckmannG2(wi_8: Tilt, wo_8: Tilt, alpha_6: f32) -> f32 {
    var wi_9: Tilt;
    var wo_9: Tilt;
    var alpha_7: f32;

    wi_9 = wi_8;
    wo_9 = wo_8;
    alpha_7 = alpha_6;
    let _e8 = wi_9;
    let _e9 = alpha_7;
    let _e10 = beckmannG1(_e8, _e9);
    let _e11 = wo_9;
    let _e12 = alpha_7;
    let _e13 = beckmannG1(_e11, _e12);
    return (_e10 * _e13);
}

fn beckmannV(wi_10: Tilt, wo_10: Tilt, alpha_8: f32) -> f32 {
    var wi_11: Tilt;
    var wo_11: Tilt;
    var alpha_9: f32;

    wi_11 = wi_10;
    wo_11 = wo_10;
    alpha_9 = alpha_8;
    let _e9 = wi_11;
    let _e10 = alpha_9;
    let _e11 = beckmannG1OverZ(_e9, _e10);
    let _e13 = wo_11;
    let _e14 = alpha_9;
    let _e15 = beckmannG1OverZ(_e13, _e14);
    return ((0.25f * _e11) * _e15);
}

fn beckmannPdf(m_2: Tilt, alpha_10: f32) -> f32 {
    var m_3: Tilt;
    var alpha_11: f32;

    m_3 = m_2;
    alpha_11 = alpha_10;
    let _e6 = m_3;
    let _e7 = alpha_11;
    let _e8 = beckmannD(_e6, _e7);
    let _e9 = m_3;
    let _e10 = tiltCos(_e9);
    return (_e8 * _e10);
}

fn beckmannSample(alpha_12: f32, u: vec2<f32>) -> vec3<f32> {
    var alpha_13: f32;
    var u_1: vec2<f32>;
    var phi: f32;
    var slope: f32;

    alpha_13 = alpha_12;
    u_1 = u;
    let _e9 = u_1;
    phi = (6.2831855f * _e9.y);
    let _e13 = alpha_13;
    let _e15 = u_1;
    slope = (_e13 * sqrt(-(log((1f - _e15.x)))));
    let _e23 = slope;
    let _e24 = phi;
    let _e27 = slope;
    let _e28 = phi;
    return normalize(vec3<f32>((_e23 * cos(_e24)), (_e27 * sin(_e28)), 1f));
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
    let _e4 = a_1;
    if (_e4 < 2f) {
        {
            let _e7 = a_1;
            let _e8 = a_1;
            a2_ = (_e7 * _e8);
            loop {
                let _e17 = n_6;
                if !((_e17 < 30i)) {
                    break;
                }
                {
                    let _e24 = term;
                    let _e26 = a2_;
                    let _e29 = n_6;
                    term = (_e24 * ((2f * _e26) / f32(((2i * _e29) + 1i))));
                    let _e36 = sum;
                    let _e37 = term;
                    sum = (_e36 + _e37);
                }
                continuing {
                    let _e21 = n_6;
                    n_6 = (_e21 + 1i);
                }
            }
            let _e40 = a_1;
            let _e42 = a2_;
            let _e46 = a2_;
            let _e47 = sum;
            return ((0.5f * _e40) + ((exp(-(_e42)) * (0.5f + (_e46 * _e47))) / 1.7724539f));
        }
    }
    loop {
        let _e59 = n_7;
        if !((_e59 > 0i)) {
            break;
        }
        let _e67 = n_7;
        let _e70 = a_1;
        let _e71 = k;
        k = ((0.5f * f32(_e67)) / (_e70 + _e71));
        continuing {
            let _e63 = n_7;
            n_7 = (_e63 - 1i);
        }
    }
    let _e74 = a_1;
    let _e76 = a_1;
    let _e78 = a_1;
    let _e85 = k;
    let _e87 = a_1;
    let _e88 = k;
    return (_e74 + ((((0.5f * exp((-(_e76) * _e78))) / 1.7724539f) * _e85) / (_e87 + _e88)));
}

fn beckmannG1Exact(w_4: Tilt, alpha_14: f32) -> f32 {
    var w_5: Tilt;
    var alpha_15: f32;
    var r_1: f32;
    var local_6: f32;
    var a_2: f32;

    w_5 = w_4;
    alpha_15 = alpha_14;
    let _e6 = alpha_15;
    let _e7 = w_5;
    r_1 = (_e6 * sqrt(_e7.p));
    let _e12 = w_5;
    let _e15 = r_1;
    if (_e12.z >= (7f * _e15)) {
        let _e18 = w_5;
        if (_e18.z > 0f) {
            local_6 = 1f;
        } else {
            local_6 = 0f;
        }
        let _e25 = local_6;
        return _e25;
    }
    let _e26 = w_5;
    let _e28 = r_1;
    a_2 = (_e26.z / _e28);
    let _e31 = a_2;
    let _e32 = a_2;
    let _e33 = beckmannAPlus(_e32);
    return (_e31 / _e33);
}

fn beckmannLambdaExact(w_6: Tilt, alpha_16: f32) -> f32 {
    var w_7: Tilt;
    var alpha_17: f32;
    var g1_: f32;
    var local_7: f32;

    w_7 = w_6;
    alpha_17 = alpha_16;
    let _e6 = w_7;
    let _e7 = alpha_17;
    let _e8 = beckmannG1Exact(_e6, _e7);
    g1_ = _e8;
    let _e10 = g1_;
    if (_e10 > 0.000000000000000000000000000001f) {
        let _e14 = g1_;
        local_7 = ((1f / _e14) - 1f);
    } else {
        local_7 = 1000000000000000000000000000000f;
    }
    let _e20 = local_7;
    return _e20;
}

fn fresnelG(c: f32, eta_8: f32) -> f32 {
    var c_1: f32;
    var eta_9: f32;

    c_1 = c;
    eta_9 = eta_8;
    let _e6 = eta_9;
    let _e9 = eta_9;
    let _e13 = c_1;
    let _e14 = c_1;
    return sqrt(max((((_e6 - 1f) * (_e9 + 1f)) + (_e13 * _e14)), 0f));
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
    let _e10 = eta_11;
    if (_e10 == 1f) {
        local_8 = 0f;
    } else {
        local_8 = 1f;
    }
    let _e16 = local_8;
    r_2.s = _e16;
    let _e18 = r_2;
    r_2.p = _e18.s;
    let _e20 = g_1;
    let _e23 = eta_11;
    if ((_e20 > 0f) && (_e23 > 0f)) {
        {
            let _e27 = eta_11;
            let _e30 = eta_11;
            k_1 = ((_e27 - 1f) * (_e30 + 1f));
            let _e35 = eta_11;
            if (_e35 < 1f) {
                let _e38 = eta_11;
                let _e39 = g_1;
                let _e41 = eta_11;
                let _e42 = g_1;
                local_9 = ((_e38 - _e39) * (_e41 + _e42));
            } else {
                let _e46 = c_3;
                let _e49 = c_3;
                local_9 = ((1f - _e46) * (1f + _e49));
            }
            let _e53 = local_9;
            sin2_ = _e53;
            let _e55 = c_3;
            let _e56 = g_1;
            across_1 = (_e55 + _e56);
            let _e59 = c_3;
            let _e60 = g_1;
            let _e62 = sin2_;
            let _e64 = c_3;
            let _e65 = g_1;
            let _e67 = sin2_;
            along = (((_e59 * _e60) - _e62) / ((_e64 * _e65) + _e67));
            let _e71 = k_1;
            let _e72 = across_1;
            let _e73 = across_1;
            rs = (_e71 / (_e72 * _e73));
            let _e77 = rs;
            let _e78 = along;
            rp = (_e77 * _e78);
            let _e82 = rs;
            let _e83 = rs;
            r_2.s = min((_e82 * _e83), 1f);
            let _e88 = rp;
            let _e89 = rp;
            r_2.p = min((_e88 * _e89), 1f);
        }
    }
    let _e93 = r_2;
    return _e93;
}

fn fresnelDielectric(c_4: f32, g_2: f32, eta_12: f32) -> f32 {
    var c_5: f32;
    var g_3: f32;
    var eta_13: f32;
    var r_3: Polarized;

    c_5 = c_4;
    g_3 = g_2;
    eta_13 = eta_12;
    let _e8 = c_5;
    let _e9 = g_3;
    let _e10 = eta_13;
    let _e11 = fresnelPolarized(_e8, _e9, _e10);
    r_3 = _e11;
    let _e14 = r_3;
    let _e16 = r_3;
    return (0.5f * (_e14.s + _e16.p));
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
    let _e8 = eta_15;
    if (_e8 == 1f) {
        return 1f;
    }
    let _e12 = g_5;
    let _e15 = eta_15;
    if !(((_e12 > 0f) && (_e15 > 0f))) {
        return 0f;
    }
    let _e21 = eta_15;
    let _e22 = eta_15;
    eta2_ = (_e21 * _e22);
    let _e25 = c_7;
    let _e26 = g_5;
    across_2 = (_e25 + _e26);
    let _e29 = eta2_;
    let _e30 = c_7;
    let _e32 = g_5;
    along_1 = ((_e29 * _e30) + _e32);
    let _e36 = c_7;
    let _e38 = g_5;
    let _e41 = across_2;
    let _e42 = across_2;
    let _e45 = eta2_;
    let _e46 = along_1;
    let _e47 = along_1;
    return min((((2f * _e36) * _e38) * ((1f / (_e41 * _e42)) + (_e45 / (_e46 * _e47)))), 1f);
}

fn fresnelDielectricAt(cosTheta: f32, eta_16: f32) -> f32 {
    var cosTheta_1: f32;
    var eta_17: f32;
    var c_8: f32;

    cosTheta_1 = cosTheta;
    eta_17 = eta_16;
    let _e6 = cosTheta_1;
    c_8 = clamp(abs(_e6), 0f, 1f);
    let _e12 = c_8;
    let _e13 = c_8;
    let _e14 = eta_17;
    let _e15 = fresnelG(_e13, _e14);
    let _e16 = eta_17;
    let _e17 = fresnelDielectric(_e12, _e15, _e16);
    return _e17;
}

fn fresnelTransmittedAt(cosTheta_2: f32, eta_18: f32) -> f32 {
    var cosTheta_3: f32;
    var eta_19: f32;
    var c_9: f32;

    cosTheta_3 = cosTheta_2;
    eta_19 = eta_18;
    let _e6 = cosTheta_3;
    c_9 = clamp(abs(_e6), 0f, 1f);
    let _e12 = c_9;
    let _e13 = c_9;
    let _e14 = eta_19;
    let _e15 = fresnelG(_e13, _e14);
    let _e16 = eta_19;
    let _e17 = fresnelTransmitted(_e12, _e15, _e16);
    return _e17;
}

fn fresnelPolarizedAt(cosTheta_4: f32, eta_20: f32) -> Polarized {
    var cosTheta_5: f32;
    var eta_21: f32;
    var c_10: f32;

    cosTheta_5 = cosTheta_4;
    eta_21 = eta_20;
    let _e6 = cosTheta_5;
    c_10 = clamp(abs(_e6), 0f, 1f);
    let _e12 = c_10;
    let _e13 = c_10;
    let _e14 = eta_21;
    let _e15 = fresnelG(_e13, _e14);
    let _e16 = eta_21;
    let _e17 = fresnelPolarized(_e12, _e15, _e16);
    return _e17;
}

fn fresnelNormalIncidence(eta_22: f32) -> f32 {
    var eta_23: f32;
    var r_4: f32;

    eta_23 = eta_22;
    let _e4 = eta_23;
    let _e7 = eta_23;
    r_4 = ((_e4 - 1f) / (_e7 + 1f));
    let _e12 = r_4;
    let _e13 = r_4;
    return (_e12 * _e13);
}

fn coatShare(strength: f32, cosTheta_6: f32) -> f32 {
    var strength_1: f32;
    var cosTheta_7: f32;

    strength_1 = strength;
    cosTheta_7 = cosTheta_6;
    let _e7 = strength_1;
    let _e8 = cosTheta_7;
    let _e9 = fresnelDielectricAt(_e8, COAT_IOR);
    return (_e7 * _e9);
}

fn coatPasses(strength_2: f32, cosTheta_8: f32) -> f32 {
    var strength_3: f32;
    var cosTheta_9: f32;

    strength_3 = strength_2;
    cosTheta_9 = cosTheta_8;
    let _e8 = strength_3;
    let _e10 = strength_3;
    let _e11 = cosTheta_9;
    let _e12 = fresnelTransmittedAt(_e11, COAT_IOR);
    return ((1f - _e8) + (_e10 * _e12));
}

fn twinRenormalize(hi: vec3<f32>, lo: vec3<f32>) -> Twin3 {
    var hi_1: vec3<f32>;
    var lo_1: vec3<f32>;
    var sum_1: vec3<f32>;
    var rest: vec3<f32>;
    var t_5: Twin3;

    hi_1 = hi;
    lo_1 = lo;
    let _e8 = hi_1;
    let _e9 = lo_1;
    sum_1 = (_e8 + _e9);
    let _e12 = lo_1;
    let _e13 = sum_1;
    let _e14 = hi_1;
    rest = (_e12 - (_e13 - _e14));
    let _e20 = sum_1;
    t_5.hi = _e20;
    let _e22 = rest;
    t_5.lo = _e22;
    let _e23 = t_5;
    return _e23;
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
    let _e8 = a_4;
    let _e9 = b_1;
    sum_2 = (_e8 + _e9);
    let _e12 = sum_2;
    let _e13 = a_4;
    bPart = (_e12 - _e13);
    let _e16 = sum_2;
    let _e17 = bPart;
    aPart = (_e16 - _e17);
    let _e20 = a_4;
    let _e21 = aPart;
    let _e23 = b_1;
    let _e24 = bPart;
    rest_1 = ((_e20 - _e21) + (_e23 - _e24));
    let _e30 = sum_2;
    t_6.hi = _e30;
    let _e32 = rest_1;
    t_6.lo = _e32;
    let _e33 = t_6;
    return _e33;
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
    let _e8 = a_6;
    let _e9 = b_3;
    product = (_e8 * _e9);
    let _e12 = a_6;
    aBig = (BSDF_SPLITTER * _e12);
    let _e15 = b_3;
    bBig = (BSDF_SPLITTER * _e15);
    let _e18 = aBig;
    let _e19 = aBig;
    let _e20 = a_6;
    aHigh = (_e18 - (_e19 - _e20));
    let _e24 = bBig;
    let _e25 = bBig;
    let _e26 = b_3;
    bHigh = (_e24 - (_e25 - _e26));
    let _e30 = a_6;
    let _e31 = aHigh;
    aLow = (_e30 - _e31);
    let _e34 = b_3;
    let _e35 = bHigh;
    bLow = (_e34 - _e35);
    let _e38 = aHigh;
    let _e39 = bHigh;
    let _e41 = product;
    let _e43 = aHigh;
    let _e44 = bLow;
    let _e47 = aLow;
    let _e48 = bHigh;
    let _e51 = aLow;
    let _e52 = bLow;
    rest_2 = (((((_e38 * _e39) - _e41) + (_e43 * _e44)) + (_e47 * _e48)) + (_e51 * _e52));
    let _e58 = product;
    t_7.hi = _e58;
    let _e60 = rest_2;
    t_7.lo = _e60;
    let _e61 = t_7;
    return _e61;
}

fn twinAdd(a_7: Twin3, b_4: Twin3) -> Twin3 {
    var a_8: Twin3;
    var b_5: Twin3;
    var sum_3: Twin3;
    var low: vec3<f32>;

    a_8 = a_7;
    b_5 = b_4;
    let _e8 = a_8;
    let _e10 = b_5;
    let _e12 = twinSum(_e8.hi, _e10.hi);
    sum_3 = _e12;
    let _e14 = sum_3;
    let _e16 = a_8;
    let _e18 = b_5;
    low = (_e14.lo + (_e16.lo + _e18.lo));
    let _e23 = sum_3;
    let _e25 = low;
    let _e26 = twinRenormalize(_e23.hi, _e25);
    return _e26;
}

fn twinMultiply(a_9: Twin3, b_6: Twin3) -> Twin3 {
    var a_10: Twin3;
    var b_7: Twin3;
    var product_1: Twin3;
    var low_1: vec3<f32>;

    a_10 = a_9;
    b_7 = b_6;
    let _e8 = a_10;
    let _e10 = b_7;
    let _e12 = twinProduct(_e8.hi, _e10.hi);
    product_1 = _e12;
    let _e14 = product_1;
    let _e16 = a_10;
    let _e18 = b_7;
    let _e21 = a_10;
    let _e23 = b_7;
    low_1 = (_e14.lo + ((_e16.hi * _e18.lo) + (_e21.lo * _e23.hi)));
    let _e29 = product_1;
    let _e31 = low_1;
    let _e32 = twinRenormalize(_e29.hi, _e31);
    return _e32;
}

fn twinNegate(a_11: Twin3) -> Twin3 {
    var a_12: Twin3;

    a_12 = a_11;
    let _e7 = a_12;
    a_12.hi = -(_e7.hi);
    let _e11 = a_12;
    a_12.lo = -(_e11.lo);
    let _e14 = a_12;
    return _e14;
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
    let _e8 = a_14;
    let _e9 = b_9;
    sum_4 = (_e8 + _e9);
    let _e12 = sum_4;
    let _e13 = a_14;
    bPart_1 = (_e12 - _e13);
    let _e16 = sum_4;
    let _e17 = bPart_1;
    aPart_1 = (_e16 - _e17);
    let _e20 = a_14;
    let _e21 = aPart_1;
    let _e23 = b_9;
    let _e24 = bPart_1;
    rest_3 = ((_e20 - _e21) + (_e23 - _e24));
    let _e30 = sum_4;
    t_8.hi = _e30;
    let _e32 = rest_3;
    t_8.lo = _e32;
    let _e33 = t_8;
    return _e33;
}

fn twinTotal(a_15: Twin3) -> Twin {
    var a_16: Twin3;
    var xy: Twin;
    var xyz: Twin;
    var low_2: f32;

    a_16 = a_15;
    let _e6 = a_16;
    let _e9 = a_16;
    let _e12 = twinSum_1(_e6.hi.x, _e9.hi.y);
    xy = _e12;
    let _e14 = xy;
    let _e16 = a_16;
    let _e19 = twinSum_1(_e14.hi, _e16.hi.z);
    xyz = _e19;
    let _e21 = xy;
    let _e23 = xyz;
    let _e26 = a_16;
    let _e29 = a_16;
    let _e33 = a_16;
    low_2 = ((_e21.lo + _e23.lo) + ((_e26.lo.x + _e29.lo.y) + _e33.lo.z));
    let _e39 = xyz;
    let _e41 = low_2;
    let _e42 = twinSum_1(_e39.hi, _e41);
    return _e42;
}

fn twinDot(a_17: Twin3, b_10: Twin3) -> Twin {
    var a_18: Twin3;
    var b_11: Twin3;

    a_18 = a_17;
    b_11 = b_10;
    let _e8 = a_18;
    let _e9 = b_11;
    let _e10 = twinMultiply(_e8, _e9);
    let _e11 = twinTotal(_e10);
    return _e11;
}

fn twinTurn(a_19: Twin3) -> Twin3 {
    var a_20: Twin3;
    var t_9: Twin3;

    a_20 = a_19;
    let _e8 = a_20;
    let _e11 = a_20;
    let _e14 = a_20;
    t_9.hi = vec3<f32>(_e8.hi.y, _e11.hi.z, _e14.hi.x);
    let _e19 = a_20;
    let _e22 = a_20;
    let _e25 = a_20;
    t_9.lo = vec3<f32>(_e19.lo.y, _e22.lo.z, _e25.lo.x);
    let _e29 = t_9;
    return _e29;
}

fn twinCross(a_21: Twin3, b_12: Twin3) -> Twin3 {
    var a_22: Twin3;
    var b_13: Twin3;
    var product_2: Twin3;
    var other: Twin3;

    a_22 = a_21;
    b_13 = b_12;
    let _e8 = a_22;
    let _e9 = b_13;
    let _e10 = twinTurn(_e9);
    let _e11 = twinMultiply(_e8, _e10);
    product_2 = _e11;
    let _e13 = a_22;
    let _e14 = twinTurn(_e13);
    let _e15 = b_13;
    let _e16 = twinMultiply(_e14, _e15);
    other = _e16;
    let _e18 = product_2;
    let _e19 = other;
    let _e20 = twinNegate(_e19);
    let _e21 = twinAdd(_e18, _e20);
    let _e22 = twinTurn(_e21);
    return _e22;
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
    let _e8 = p_1;
    let _e10 = z_2;
    let _e12 = z_2;
    rough = (_e8.hi / (_e10.hi * _e12.hi));
    let _e17 = z_2;
    let _e20 = z_2;
    let _e23 = twinProduct(vec3(_e17.hi), vec3(_e20.hi));
    square = _e23;
    let _e25 = rough;
    let _e27 = square;
    let _e29 = twinProduct(vec3(_e25), _e27.hi);
    back = _e29;
    let _e31 = p_1;
    let _e33 = back;
    let _e37 = rough;
    let _e38 = square;
    let _e42 = z_2;
    let _e45 = z_2;
    low_3 = ((_e31.lo - _e33.lo.x) - (_e37 * (_e38.lo.x + ((2f * _e42.hi) * _e45.lo))));
    let _e52 = p_1;
    let _e54 = back;
    let _e58 = low_3;
    lacks = ((_e52.hi - _e54.hi.x) + _e58);
    let _e61 = rough;
    let _e62 = lacks;
    let _e63 = square;
    return (_e61 + (_e62 / _e63.hi.x));
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
    let _e6 = v_5;
    let _e7 = v_5;
    r_5 = inverseSqrt(dot(_e6, _e7));
    let _e11 = v_5;
    let _e12 = r_5;
    let _e14 = twinProduct(_e11, vec3(_e12));
    u_2 = _e14;
    let _e16 = u_2;
    let _e17 = u_2;
    let _e18 = twinDot(_e16, _e17);
    square_1 = _e18;
    let _e20 = square_1;
    let _e24 = square_1;
    x = ((_e20.hi - 1f) + _e24.lo);
    let _e28 = x;
    let _e30 = x;
    stretch = (_e28 * ((0.375f * _e30) - 0.5f));
    let _e36 = u_2;
    let _e38 = stretch;
    let _e39 = u_2;
    low_4 = (_e36.lo + (_e38 * _e39.hi));
    let _e44 = u_2;
    let _e46 = low_4;
    let _e47 = twinRenormalize(_e44.hi, _e46);
    return _e47;
}

fn preciseTilt(v_6: Twin3, n_8: Twin3) -> SignedTilt {
    var v_7: Twin3;
    var n_9: Twin3;
    var across_3: vec3<f32>;
    var t_10: SignedTilt;

    v_7 = v_6;
    n_9 = n_8;
    let _e8 = v_7;
    let _e9 = n_9;
    let _e10 = twinCross(_e8, _e9);
    across_3 = _e10.hi;
    let _e15 = across_3;
    let _e16 = across_3;
    t_10.p = dot(_e15, _e16);
    let _e19 = v_7;
    let _e20 = n_9;
    let _e21 = twinDot(_e19, _e20);
    t_10.z = _e21;
    let _e22 = t_10;
    return _e22;
}

fn unsignedTilt(signedTilt: SignedTilt) -> Tilt {
    var signedTilt_1: SignedTilt;
    var t_11: Tilt;

    signedTilt_1 = signedTilt;
    let _e8 = signedTilt_1;
    t_11.p = _e8.p;
    let _e11 = signedTilt_1;
    t_11.z = abs(_e11.z.hi);
    let _e15 = t_11;
    return _e15;
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
    let _e10 = h_3;
    let _e11 = n_11;
    let _e12 = twinCross(_e10, _e11);
    across_4 = _e12;
    t_12.p = 0f;
    t_12.z = 0f;
    let _e19 = z_4;
    if (_e19.hi != 0f) {
        {
            let _e24 = across_4;
            let _e25 = across_4;
            let _e26 = twinDot(_e24, _e25);
            let _e27 = z_4;
            let _e28 = twinOverSquare(_e26, _e27);
            t_12.p = _e28;
            t_12.z = 1f;
        }
    }
    let _e31 = t_12;
    return _e31;
}

fn usable(v_8: vec3<f32>) -> bool {
    var v_9: vec3<f32>;

    v_9 = v_8;
    let _e6 = v_9;
    let _e7 = v_9;
    return (dot(_e6, _e7) > 0f);
}

fn noFacet() -> Facet {
    var f_6: Facet;

    f_6.wi.p = 0f;
    f_6.wi.z = 0f;
    let _e12 = f_6;
    f_6.wo = _e12.wi;
    let _e15 = f_6;
    f_6.h = _e15.wi;
    f_6.s = 0f;
    f_6.wiDotM = 0f;
    f_6.woDotM = 0f;
    f_6.g = 0f;
    f_6.exists = false;
    let _e27 = f_6;
    return _e27;
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
    let _e12 = wi_13;
    let _e13 = usable(_e12);
    let _e14 = wo_13;
    let _e15 = usable(_e14);
    let _e17 = n_13;
    let _e18 = usable(_e17);
    if !(((_e13 && _e15) && _e18)) {
        let _e21 = noFacet();
        return _e21;
    }
    let _e22 = wi_13;
    let _e23 = twinNormalize(_e22);
    i = _e23;
    let _e25 = wo_13;
    let _e26 = twinNormalize(_e25);
    o = _e26;
    let _e28 = n_13;
    let _e29 = twinNormalize(_e28);
    up = _e29;
    let _e31 = i;
    let _e32 = o;
    let _e33 = twinAdd(_e31, _e32);
    h_4 = _e33;
    let _e35 = i;
    let _e36 = up;
    let _e37 = preciseTilt(_e35, _e36);
    tiltI = _e37;
    let _e39 = o;
    let _e40 = up;
    let _e41 = preciseTilt(_e39, _e40);
    tiltO = _e41;
    let _e43 = h_4;
    let _e44 = h_4;
    let _e45 = twinDot(_e43, _e44);
    s_1 = _e45;
    let _e49 = tiltI;
    let _e50 = unsignedTilt(_e49);
    f_7.wi = _e50;
    let _e52 = tiltO;
    let _e53 = unsignedTilt(_e52);
    f_7.wo = _e53;
    let _e55 = h_4;
    let _e56 = up;
    let _e57 = h_4;
    let _e58 = up;
    let _e59 = twinDot(_e57, _e58);
    let _e60 = preciseSlope(_e55, _e56, _e59);
    f_7.h = _e60;
    let _e62 = s_1;
    f_7.s = _e62.hi;
    let _e66 = s_1;
    f_7.woDotM = min((0.5f * sqrt(_e66.hi)), 1f);
    let _e73 = f_7;
    f_7.wiDotM = _e73.woDotM;
    let _e75 = eta_25;
    let _e79 = eta_25;
    let _e83 = twinProduct(vec3<f32>(_e75, 0f, 0f), vec3<f32>(_e79, 0f, 0f));
    terms = _e83;
    let _e86 = terms;
    let _e92 = s_1;
    terms.hi = vec3<f32>(_e86.hi.x, -1f, (0.25f * _e92.hi));
    let _e97 = terms;
    let _e102 = s_1;
    terms.lo = vec3<f32>(_e97.lo.x, 0f, (0.25f * _e102.lo));
    let _e107 = terms;
    let _e108 = twinTotal(_e107);
    f_7.g = sqrt(max(_e108.hi, 0f));
    let _e114 = tiltI;
    let _e119 = tiltO;
    let _e125 = tiltI;
    let _e130 = tiltO;
    let _e137 = f_7;
    f_7.exists = ((((_e114.z.hi > 0f) && (_e119.z.hi > 0f)) || ((_e125.z.hi < 0f) && (_e130.z.hi < 0f))) && (_e137.h.z > 0f));
    let _e143 = f_7;
    return _e143;
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
    let _e12 = wi_15;
    let _e13 = usable(_e12);
    let _e14 = wo_15;
    let _e15 = usable(_e14);
    let _e17 = n_15;
    let _e18 = usable(_e17);
    let _e20 = eta_27;
    let _e24 = eta_27;
    if !(((((_e13 && _e15) && _e18) && (_e20 > 0f)) && (_e24 != 1f))) {
        let _e29 = noFacet();
        return _e29;
    }
    let _e30 = wi_15;
    let _e31 = twinNormalize(_e30);
    i_1 = _e31;
    let _e33 = wo_15;
    let _e34 = twinNormalize(_e33);
    o_1 = _e34;
    let _e36 = n_15;
    let _e37 = twinNormalize(_e36);
    up_1 = _e37;
    let _e41 = eta_27;
    factor.hi = vec3(_e41);
    factor.lo = vec3(0f);
    let _e46 = o_1;
    let _e47 = i_1;
    let _e48 = factor;
    let _e49 = twinMultiply(_e47, _e48);
    let _e50 = twinAdd(_e46, _e49);
    h_5 = _e50;
    let _e52 = i_1;
    let _e53 = up_1;
    let _e54 = preciseTilt(_e52, _e53);
    tiltI_1 = _e54;
    let _e56 = o_1;
    let _e57 = up_1;
    let _e58 = preciseTilt(_e56, _e57);
    tiltO_1 = _e58;
    let _e60 = h_5;
    let _e61 = up_1;
    let _e62 = twinDot(_e60, _e61);
    hDotN = _e62;
    let _e64 = hDotN;
    let _e68 = tiltO_1;
    if ((_e64.hi < 0f) == (_e68.z.hi < 0f)) {
        local_10 = 1f;
    } else {
        local_10 = -1f;
    }
    let _e78 = local_10;
    side_1 = _e78;
    let _e80 = side_1;
    let _e81 = h_5;
    let _e82 = i_1;
    let _e83 = twinDot(_e81, _e82);
    hDotI_1 = (_e80 * _e83.hi);
    let _e87 = side_1;
    let _e88 = h_5;
    let _e89 = o_1;
    let _e90 = twinDot(_e88, _e89);
    hDotO_1 = (_e87 * _e90.hi);
    let _e94 = tiltI_1;
    let _e99 = tiltO_1;
    let _e105 = tiltI_1;
    let _e110 = tiltO_1;
    opposite = (((_e94.z.hi > 0f) && (_e99.z.hi < 0f)) || ((_e105.z.hi < 0f) && (_e110.z.hi > 0f)));
    let _e120 = tiltI_1;
    let _e121 = unsignedTilt(_e120);
    f_8.wi = _e121;
    let _e123 = tiltO_1;
    let _e124 = unsignedTilt(_e123);
    f_8.wo = _e124;
    let _e126 = h_5;
    let _e127 = up_1;
    let _e128 = hDotN;
    let _e129 = preciseSlope(_e126, _e127, _e128);
    f_8.h = _e129;
    let _e131 = h_5;
    let _e132 = h_5;
    let _e133 = twinDot(_e131, _e132);
    f_8.s = _e133.hi;
    let _e136 = opposite;
    let _e137 = f_8;
    let _e143 = hDotI_1;
    let _e147 = hDotO_1;
    f_8.exists = (((_e136 && (_e137.h.z > 0f)) && (_e143 < 0f)) && (_e147 > 0f));
    let _e151 = f_8;
    if _e151.exists {
        let _e153 = f_8;
        local_11 = inverseSqrt(_e153.s);
    } else {
        local_11 = 0f;
    }
    let _e158 = local_11;
    scale_1 = _e158;
    let _e161 = hDotI_1;
    let _e163 = scale_1;
    f_8.wiDotM = min((abs(_e161) * _e163), 1f);
    let _e168 = hDotO_1;
    let _e170 = scale_1;
    f_8.woDotM = min((abs(_e168) * _e170), 1f);
    let _e175 = eta_27;
    let _e176 = f_8;
    f_8.g = (_e175 * _e176.wiDotM);
    let _e179 = f_8;
    return _e179;
}

fn diffuseF(albedo: vec3<f32>, fresnel: f32) -> vec3<f32> {
    var albedo_1: vec3<f32>;
    var fresnel_1: f32;

    albedo_1 = albedo;
    fresnel_1 = fresnel;
    let _e8 = albedo_1;
    let _e10 = fresnel_1;
    return (_e8 * ((1f - _e10) / BSDF_PI));
}

fn diffuseFCos(albedo_2: vec3<f32>, fresnel_2: f32, cosI_2: f32) -> vec3<f32> {
    var albedo_3: vec3<f32>;
    var fresnel_3: f32;
    var cosI_3: f32;

    albedo_3 = albedo_2;
    fresnel_3 = fresnel_2;
    cosI_3 = cosI_2;
    let _e10 = albedo_3;
    let _e11 = fresnel_3;
    let _e12 = diffuseF(_e10, _e11);
    let _e13 = cosI_3;
    return (_e12 * _e13);
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
    let _e11 = c_12;
    let _e14 = c_12;
    sin2_1 = ((1f - _e11) * (1f + _e14));
    let _e18 = n_17;
    let _e21 = n_17;
    let _e25 = k_3;
    let _e26 = k_3;
    contrast = (((_e18 - 1f) * (_e21 + 1f)) - (_e25 * _e26));
    let _e30 = contrast;
    let _e31 = c_12;
    let _e32 = c_12;
    re = (_e30 + (_e31 * _e32));
    let _e36 = n_17;
    let _e37 = k_3;
    nk = (_e36 * _e37);
    let _e41 = re;
    let _e43 = re;
    let _e44 = re;
    let _e47 = nk;
    let _e49 = nk;
    larger = sqrt((0.5f * (abs(_e41) + sqrt(((_e43 * _e44) + ((4f * _e47) * _e49))))));
    let _e57 = larger;
    if (_e57 > 0f) {
        let _e60 = nk;
        let _e61 = larger;
        local_12 = (_e60 / _e61);
    } else {
        local_12 = 0f;
    }
    let _e65 = local_12;
    smaller = _e65;
    let _e67 = re;
    if (_e67 > 0f) {
        let _e70 = larger;
        local_13 = _e70;
    } else {
        let _e71 = smaller;
        local_13 = _e71;
    }
    let _e73 = local_13;
    a_23 = _e73;
    let _e75 = re;
    if (_e75 > 0f) {
        let _e78 = smaller;
        local_14 = _e78;
    } else {
        let _e79 = larger;
        local_14 = _e79;
    }
    let _e81 = local_14;
    b_14 = _e81;
    let _e83 = a_23;
    let _e84 = c_12;
    if ((_e83 + _e84) > 0f) {
        let _e88 = contrast;
        let _e89 = b_14;
        let _e90 = b_14;
        let _e93 = a_23;
        let _e94 = c_12;
        local_15 = ((_e88 + (_e89 * _e90)) / (_e93 + _e94));
    } else {
        local_15 = 0f;
    }
    let _e99 = local_15;
    aMinusC = _e99;
    let _e101 = b_14;
    let _e102 = c_12;
    bc = (_e101 * _e102);
    let _e107 = a_23;
    t_13.a = _e107;
    let _e109 = a_23;
    let _e110 = a_23;
    let _e112 = b_14;
    let _e113 = b_14;
    t_13.q2_ = ((_e109 * _e110) + (_e112 * _e113));
    let _e117 = aMinusC;
    let _e118 = aMinusC;
    let _e120 = b_14;
    let _e121 = b_14;
    t_13.numS = ((_e117 * _e118) + (_e120 * _e121));
    let _e125 = a_23;
    let _e126 = c_12;
    let _e128 = a_23;
    let _e129 = c_12;
    let _e132 = b_14;
    let _e133 = b_14;
    t_13.denS = (((_e125 + _e126) * (_e128 + _e129)) + (_e132 * _e133));
    let _e137 = a_23;
    let _e138 = c_12;
    let _e140 = sin2_1;
    let _e142 = a_23;
    let _e143 = c_12;
    let _e145 = sin2_1;
    let _e148 = bc;
    let _e149 = bc;
    t_13.numP = ((((_e137 * _e138) - _e140) * ((_e142 * _e143) - _e145)) + (_e148 * _e149));
    let _e153 = a_23;
    let _e154 = c_12;
    let _e156 = sin2_1;
    let _e158 = a_23;
    let _e159 = c_12;
    let _e161 = sin2_1;
    let _e164 = bc;
    let _e165 = bc;
    t_13.denP = ((((_e153 * _e154) + _e156) * ((_e158 * _e159) + _e161)) + (_e164 * _e165));
    let _e168 = t_13;
    return _e168;
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
    let _e10 = cosTheta_11;
    c_13 = clamp(abs(_e10), 0f, 1f);
    let _e16 = c_13;
    let _e17 = n_19;
    let _e20 = k_5;
    let _e23 = conductorTerms(_e16, max(_e17, 0f), max(_e20, 0f));
    t_14 = _e23;
    let _e25 = t_14;
    if (_e25.denS > 0f) {
        let _e29 = t_14;
        let _e31 = t_14;
        local_16 = (_e29.numS / _e31.denS);
    } else {
        local_16 = 1f;
    }
    let _e36 = local_16;
    rs_1 = _e36;
    let _e38 = t_14;
    if (_e38.denP > 0f) {
        let _e42 = t_14;
        let _e44 = t_14;
        local_17 = (_e42.numP / _e44.denP);
    } else {
        local_17 = 1f;
    }
    let _e49 = local_17;
    rpOverRs = _e49;
    let _e52 = rs_1;
    let _e55 = rpOverRs;
    return min(((0.5f * _e52) * (1f + _e55)), 1f);
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
    let _e10 = cosTheta_13;
    c_14 = clamp(abs(_e10), 0f, 1f);
    let _e16 = c_14;
    let _e17 = n_21;
    let _e20 = k_7;
    let _e23 = conductorTerms(_e16, max(_e17, 0f), max(_e20, 0f));
    t_15 = _e23;
    let _e25 = t_15;
    let _e29 = t_15;
    if !(((_e25.denS > 0f) && (_e29.denP > 0f))) {
        return 0f;
    }
    let _e37 = c_14;
    let _e40 = c_14;
    sin2_2 = ((1f - _e37) * (1f + _e40));
    let _e45 = t_15;
    let _e48 = c_14;
    let _e50 = t_15;
    let _e54 = t_15;
    let _e56 = sin2_2;
    let _e58 = t_15;
    return min(((((2f * _e45.a) * _e48) / _e50.denS) * (1f + ((_e54.q2_ + _e56) / _e58.denP))), 1f);
}

fn fresnelConductorRgb(cosTheta_14: f32, n_22: vec3<f32>, k_8: vec3<f32>) -> vec3<f32> {
    var cosTheta_15: f32;
    var n_23: vec3<f32>;
    var k_9: vec3<f32>;

    cosTheta_15 = cosTheta_14;
    n_23 = n_22;
    k_9 = k_8;
    let _e10 = cosTheta_15;
    let _e11 = n_23;
    let _e13 = k_9;
    let _e15 = fresnelConductor(_e10, _e11.x, _e13.x);
    let _e16 = cosTheta_15;
    let _e17 = n_23;
    let _e19 = k_9;
    let _e21 = fresnelConductor(_e16, _e17.y, _e19.y);
    let _e22 = cosTheta_15;
    let _e23 = n_23;
    let _e25 = k_9;
    let _e27 = fresnelConductor(_e22, _e23.z, _e25.z);
    return vec3<f32>(_e15, _e21, _e27);
}

fn schlickWeight(cosTheta_16: f32) -> f32 {
    var cosTheta_17: f32;
    var m_4: f32;
    var m2_: f32;

    cosTheta_17 = cosTheta_16;
    let _e7 = cosTheta_17;
    m_4 = (1f - clamp(_e7, 0f, 1f));
    let _e13 = m_4;
    let _e14 = m_4;
    m2_ = (_e13 * _e14);
    let _e17 = m2_;
    let _e18 = m2_;
    let _e20 = m_4;
    return ((_e17 * _e18) * _e20);
}

fn fresnelSchlick(cosTheta_18: f32, f0_: f32) -> f32 {
    var cosTheta_19: f32;
    var f0_1: f32;

    cosTheta_19 = cosTheta_18;
    f0_1 = f0_;
    let _e8 = f0_1;
    let _e10 = f0_1;
    let _e12 = cosTheta_19;
    let _e13 = schlickWeight(_e12);
    return (_e8 + ((1f - _e10) * _e13));
}

fn fresnelSchlickRgb(cosTheta_20: f32, f0_2: vec3<f32>) -> vec3<f32> {
    var cosTheta_21: f32;
    var f0_3: vec3<f32>;

    cosTheta_21 = cosTheta_20;
    f0_3 = f0_2;
    let _e8 = f0_3;
    let _e11 = f0_3;
    let _e13 = cosTheta_21;
    let _e14 = schlickWeight(_e13);
    return (_e8 + ((vec3(1f) - _e11) * _e14));
}

fn ggxD(m_5: Tilt, alpha_18: f32) -> f32 {
    var m_6: Tilt;
    var alpha_19: f32;
    var width_1: f32;
    var spread: f32;
    var t_16: f32;

    m_6 = m_5;
    alpha_19 = alpha_18;
    let _e8 = alpha_19;
    let _e9 = m_6;
    width_1 = (_e8 * _e9.z);
    let _e13 = m_6;
    let _e15 = width_1;
    let _e16 = width_1;
    spread = (_e13.p + (_e15 * _e16));
    let _e20 = spread;
    let _e23 = alpha_19;
    if !(((_e20 > 0f) && (_e23 > 0f))) {
        return 0f;
    }
    let _e29 = alpha_19;
    let _e30 = m_6;
    let _e32 = m_6;
    let _e34 = m_6;
    let _e39 = spread;
    t_16 = ((_e29 * (_e30.p + (_e32.z * _e34.z))) / _e39);
    let _e42 = t_16;
    let _e43 = t_16;
    return ((_e42 * _e43) / BSDF_PI);
}

fn ggxRoot(w_8: Tilt, alpha_20: f32) -> f32 {
    var w_9: Tilt;
    var alpha_21: f32;

    w_9 = w_8;
    alpha_21 = alpha_20;
    let _e8 = w_9;
    let _e10 = w_9;
    let _e13 = alpha_21;
    let _e14 = alpha_21;
    let _e16 = w_9;
    return sqrt(((_e8.z * _e10.z) + ((_e13 * _e14) * _e16.p)));
}

fn ggxLambda(w_10: Tilt, alpha_22: f32) -> f32 {
    var w_11: Tilt;
    var alpha_23: f32;
    var slope_1: f32;
    var below: f32;
    var local_18: f32;

    w_11 = w_10;
    alpha_23 = alpha_22;
    let _e8 = alpha_23;
    let _e9 = alpha_23;
    let _e11 = w_11;
    slope_1 = ((_e8 * _e9) * _e11.p);
    let _e16 = w_11;
    let _e19 = w_11;
    let _e21 = w_11;
    let _e22 = alpha_23;
    let _e23 = ggxRoot(_e21, _e22);
    below = ((2f * _e16.z) * (_e19.z + _e23));
    let _e27 = slope_1;
    let _e29 = below;
    if (_e27 < (1000000000000000000000000000000f * _e29)) {
        let _e32 = slope_1;
        let _e33 = below;
        local_18 = (_e32 / _e33);
    } else {
        local_18 = 1000000000000000000000000000000f;
    }
    let _e37 = local_18;
    return _e37;
}

fn ggxG1(w_12: Tilt, alpha_24: f32) -> f32 {
    var w_13: Tilt;
    var alpha_25: f32;
    var sum_5: f32;
    var local_19: f32;

    w_13 = w_12;
    alpha_25 = alpha_24;
    let _e8 = w_13;
    let _e10 = w_13;
    let _e11 = alpha_25;
    let _e12 = ggxRoot(_e10, _e11);
    sum_5 = (_e8.z + _e12);
    let _e15 = sum_5;
    if (_e15 > 0f) {
        let _e19 = w_13;
        let _e22 = sum_5;
        local_19 = ((2f * _e19.z) / _e22);
    } else {
        local_19 = 0f;
    }
    let _e26 = local_19;
    return _e26;
}

fn ggxG2(wi_16: Tilt, wo_16: Tilt, alpha_26: f32) -> f32 {
    var wi_17: Tilt;
    var wo_17: Tilt;
    var alpha_27: f32;

    wi_17 = wi_16;
    wo_17 = wo_16;
    alpha_27 = alpha_26;
    let _e10 = wi_17;
    let _e11 = alpha_27;
    let _e12 = ggxG1(_e10, _e11);
    let _e13 = wo_17;
    let _e14 = alpha_27;
    let _e15 = ggxG1(_e13, _e14);
    return (_e12 * _e15);
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
    let _e10 = wi_19;
    let _e11 = alpha_29;
    let _e12 = ggxRoot(_e10, _e11);
    let _e13 = wo_19;
    let _e16 = wo_19;
    let _e17 = alpha_29;
    let _e18 = ggxRoot(_e16, _e17);
    let _e19 = wi_19;
    sum_6 = ((_e12 * _e13.z) + (_e18 * _e19.z));
    let _e24 = sum_6;
    if (_e24 > 0f) {
        let _e28 = wi_19;
        let _e31 = wo_19;
        let _e34 = sum_6;
        local_20 = (((2f * _e28.z) * _e31.z) / _e34);
    } else {
        local_20 = 0f;
    }
    let _e38 = local_20;
    return _e38;
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
    let _e10 = wi_21;
    let _e12 = wi_21;
    let _e13 = alpha_31;
    let _e14 = ggxRoot(_e12, _e13);
    let _e16 = wo_21;
    let _e18 = wo_21;
    let _e19 = alpha_31;
    let _e20 = ggxRoot(_e18, _e19);
    sum_7 = ((_e10.z + _e14) * (_e16.z + _e20));
    let _e24 = sum_7;
    if (_e24 > 0.0000000000000000000000000000000000001f) {
        let _e28 = sum_7;
        local_21 = (1f / _e28);
    } else {
        local_21 = 0f;
    }
    let _e32 = local_21;
    return _e32;
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
    let _e10 = wi_23;
    let _e11 = alpha_33;
    let _e12 = ggxRoot(_e10, _e11);
    let _e13 = wo_23;
    let _e16 = wo_23;
    let _e17 = alpha_33;
    let _e18 = ggxRoot(_e16, _e17);
    let _e19 = wi_23;
    sum_8 = ((_e12 * _e13.z) + (_e18 * _e19.z));
    let _e24 = sum_8;
    if (_e24 > 0.0000000000000000000000000000000000001f) {
        let _e28 = sum_8;
        local_22 = (0.5f / _e28);
    } else {
        local_22 = 0f;
    }
    let _e32 = local_22;
    return _e32;
}

fn ggxPdf(m_7: Tilt, alpha_34: f32) -> f32 {
    var m_8: Tilt;
    var alpha_35: f32;

    m_8 = m_7;
    alpha_35 = alpha_34;
    let _e8 = m_8;
    let _e9 = alpha_35;
    let _e10 = ggxD(_e8, _e9);
    let _e11 = m_8;
    let _e12 = tiltCos(_e11);
    return (_e10 * _e12);
}

fn ggxPdfVisible(f_9: Facet, alpha_36: f32) -> f32 {
    var f_10: Facet;
    var alpha_37: f32;

    f_10 = f_9;
    alpha_37 = alpha_36;
    let _e8 = f_10;
    if !(_e8.exists) {
        return 0f;
    }
    let _e13 = f_10;
    let _e16 = f_10;
    let _e18 = alpha_37;
    let _e19 = ggxD(_e16.h, _e18);
    let _e21 = f_10;
    let _e24 = f_10;
    let _e26 = alpha_37;
    let _e27 = ggxRoot(_e24.wo, _e26);
    return (((2f * _e13.woDotM) * _e19) / (_e21.wo.z + _e27));
}

fn ggxSample(alpha_38: f32, u_3: vec2<f32>) -> vec3<f32> {
    var alpha_39: f32;
    var u_4: vec2<f32>;
    var phi_1: f32;
    var across_5: f32;

    alpha_39 = alpha_38;
    u_4 = u_3;
    let _e11 = u_4;
    phi_1 = (6.2831855f * _e11.y);
    let _e15 = alpha_39;
    let _e16 = u_4;
    across_5 = (_e15 * sqrt(_e16.x));
    let _e21 = across_5;
    let _e22 = phi_1;
    let _e25 = across_5;
    let _e26 = phi_1;
    let _e30 = u_4;
    return normalize(vec3<f32>((_e21 * cos(_e22)), (_e25 * sin(_e26)), sqrt(max((1f - _e30.x), 0f))));
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
    let _e10 = alpha_41;
    let _e12 = wo_25;
    let _e15 = alpha_41;
    let _e17 = wo_25;
    let _e20 = wo_25;
    seen = normalize(vec3<f32>((_e10.x * _e12.x), (_e15.y * _e17.y), _e20.z));
    let _e28 = u_6;
    phi_2 = (6.2831855f * _e28.x);
    let _e33 = u_6;
    let _e37 = seen;
    let _e41 = seen;
    z_5 = (((1f - _e33.y) * (1f + _e37.z)) - _e41.z);
    let _e46 = z_5;
    let _e49 = z_5;
    r_6 = sqrt(clamp(((1f - _e46) * (1f + _e49)), 0f, 1f));
    let _e57 = r_6;
    let _e58 = phi_2;
    let _e61 = r_6;
    let _e62 = phi_2;
    let _e65 = z_5;
    let _e67 = seen;
    h_6 = (vec3<f32>((_e57 * cos(_e58)), (_e61 * sin(_e62)), _e65) + _e67);
    let _e70 = alpha_41;
    let _e72 = h_6;
    let _e75 = alpha_41;
    let _e77 = h_6;
    let _e80 = h_6;
    m_9 = vec3<f32>((_e70.x * _e72.x), (_e75.y * _e77.y), max(_e80.z, 0f));
    let _e86 = m_9;
    let _e87 = m_9;
    s_2 = dot(_e86, _e87);
    let _e90 = s_2;
    if (_e90 > 0f) {
        let _e93 = m_9;
        let _e94 = s_2;
        local_23 = (_e93 * inverseSqrt(_e94));
    } else {
        local_23 = vec3<f32>(0f, 0f, 1f);
    }
    let _e102 = local_23;
    return _e102;
}

fn ggxAnisoWidths(alpha_42: f32, strength_4: f32) -> vec2<f32> {
    var alpha_43: f32;
    var strength_5: f32;
    var across_6: f32;

    alpha_43 = alpha_42;
    strength_5 = strength_4;
    let _e8 = alpha_43;
    across_6 = max(_e8, 0.001f);
    let _e12 = across_6;
    let _e14 = across_6;
    let _e16 = strength_5;
    let _e18 = strength_5;
    let _e21 = across_6;
    return vec2<f32>((_e12 + (((1f - _e14) * _e16) * _e18)), _e21);
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
    let _e8 = alpha_45;
    let _e10 = alpha_45;
    area = (_e8.x * _e10.y);
    let _e14 = alpha_45;
    let _e18 = alpha_45;
    if !(((_e14.x > 0f) && (_e18.y > 0f))) {
        return 0f;
    }
    let _e25 = h_8;
    let _e27 = h_8;
    let _e30 = alpha_45;
    let _e32 = alpha_45;
    let _e36 = h_8;
    let _e38 = h_8;
    let _e41 = alpha_45;
    let _e43 = alpha_45;
    p_2 = (((_e25.x * _e27.x) * (_e30.y / _e32.x)) + ((_e36.y * _e38.y) * (_e41.x / _e43.y)));
    let _e49 = p_2;
    let _e50 = area;
    let _e51 = h_8;
    let _e54 = h_8;
    spread_1 = (_e49 + ((_e50 * _e51.z) * _e54.z));
    let _e59 = spread_1;
    if !((_e59 > 0f)) {
        return 0f;
    }
    let _e64 = area;
    let _e66 = h_8;
    let _e67 = h_8;
    let _e70 = spread_1;
    t_17 = ((sqrt(_e64) * dot(_e66, _e67)) / _e70);
    let _e73 = t_17;
    let _e74 = t_17;
    return ((_e73 * _e74) / BSDF_PI);
}

fn ggxAnisoRoot(w_14: vec3<f32>, alpha_46: vec2<f32>) -> f32 {
    var w_15: vec3<f32>;
    var alpha_47: vec2<f32>;

    w_15 = w_14;
    alpha_47 = alpha_46;
    let _e8 = alpha_47;
    let _e10 = w_15;
    let _e13 = alpha_47;
    let _e15 = w_15;
    let _e18 = w_15;
    return length(vec3<f32>((_e8.x * _e10.x), (_e13.y * _e15.y), _e18.z));
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
    let _e8 = w_17;
    z_6 = abs(_e8.z);
    let _e12 = alpha_49;
    let _e14 = w_17;
    x_1 = (_e12.x * _e14.x);
    let _e18 = alpha_49;
    let _e20 = w_17;
    y = (_e18.y * _e20.y);
    let _e24 = x_1;
    let _e25 = x_1;
    let _e27 = y;
    let _e28 = y;
    slope_2 = ((_e24 * _e25) + (_e27 * _e28));
    let _e33 = z_6;
    let _e35 = z_6;
    let _e36 = w_17;
    let _e37 = alpha_49;
    let _e38 = ggxAnisoRoot(_e36, _e37);
    below_1 = ((2f * _e33) * (_e35 + _e38));
    let _e42 = slope_2;
    let _e44 = below_1;
    if (_e42 < (1000000000000000000000000000000f * _e44)) {
        let _e47 = slope_2;
        let _e48 = below_1;
        local_24 = (_e47 / _e48);
    } else {
        local_24 = 1000000000000000000000000000000f;
    }
    let _e52 = local_24;
    return _e52;
}

fn ggxAnisoG1(w_18: vec3<f32>, alpha_50: vec2<f32>) -> f32 {
    var w_19: vec3<f32>;
    var alpha_51: vec2<f32>;
    var sum_9: f32;
    var local_25: f32;

    w_19 = w_18;
    alpha_51 = alpha_50;
    let _e8 = w_19;
    let _e11 = w_19;
    let _e12 = alpha_51;
    let _e13 = ggxAnisoRoot(_e11, _e12);
    sum_9 = (abs(_e8.z) + _e13);
    let _e16 = sum_9;
    if (_e16 > 0f) {
        let _e20 = w_19;
        let _e24 = sum_9;
        local_25 = ((2f * abs(_e20.z)) / _e24);
    } else {
        local_25 = 0f;
    }
    let _e28 = local_25;
    return _e28;
}

fn ggxAnisoG2(wi_24: vec3<f32>, wo_26: vec3<f32>, alpha_52: vec2<f32>) -> f32 {
    var wi_25: vec3<f32>;
    var wo_27: vec3<f32>;
    var alpha_53: vec2<f32>;

    wi_25 = wi_24;
    wo_27 = wo_26;
    alpha_53 = alpha_52;
    let _e10 = wi_25;
    let _e11 = alpha_53;
    let _e12 = ggxAnisoG1(_e10, _e11);
    let _e13 = wo_27;
    let _e14 = alpha_53;
    let _e15 = ggxAnisoG1(_e13, _e14);
    return (_e12 * _e15);
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
    let _e10 = wi_27;
    let _e13 = wi_27;
    let _e14 = alpha_55;
    let _e15 = ggxAnisoRoot(_e13, _e14);
    let _e17 = wo_29;
    let _e20 = wo_29;
    let _e21 = alpha_55;
    let _e22 = ggxAnisoRoot(_e20, _e21);
    sum_10 = ((abs(_e10.z) + _e15) * (abs(_e17.z) + _e22));
    let _e26 = sum_10;
    if (_e26 > 0f) {
        let _e30 = sum_10;
        local_26 = (1f / _e30);
    } else {
        local_26 = 0f;
    }
    let _e34 = local_26;
    return _e34;
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
    let _e10 = wi_29;
    let _e11 = alpha_57;
    let _e12 = ggxAnisoRoot(_e10, _e11);
    let _e13 = wo_31;
    let _e17 = wo_31;
    let _e18 = alpha_57;
    let _e19 = ggxAnisoRoot(_e17, _e18);
    let _e20 = wi_29;
    sum_11 = ((_e12 * abs(_e13.z)) + (_e19 * abs(_e20.z)));
    let _e26 = sum_11;
    if (_e26 > 0f) {
        let _e30 = sum_11;
        local_27 = (0.5f / _e30);
    } else {
        local_27 = 0f;
    }
    let _e34 = local_27;
    return _e34;
}

fn ggxAnisoPdf(h_9: vec3<f32>, alpha_58: vec2<f32>) -> f32 {
    var h_10: vec3<f32>;
    var alpha_59: vec2<f32>;

    h_10 = h_9;
    alpha_59 = alpha_58;
    let _e8 = h_10;
    let _e9 = alpha_59;
    let _e10 = ggxAnisoD(_e8, _e9);
    let _e11 = h_10;
    let _e12 = tilt(_e11);
    let _e13 = tiltCos(_e12);
    return (_e10 * _e13);
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
    let _e12 = f_12;
    if !(_e12.exists) {
        return 0f;
    }
    let _e17 = f_12;
    let _e20 = h_12;
    let _e21 = alpha_61;
    let _e22 = ggxAnisoD(_e20, _e21);
    let _e24 = wo_33;
    let _e27 = wo_33;
    let _e28 = alpha_61;
    let _e29 = ggxAnisoRoot(_e27, _e28);
    return (((2f * _e17.woDotM) * _e22) / (abs(_e24.z) + _e29));
}

fn ggxAnisoSample(alpha_62: vec2<f32>, u_7: vec2<f32>) -> vec3<f32> {
    var alpha_63: vec2<f32>;
    var u_8: vec2<f32>;
    var phi_3: f32;
    var across_7: f32;

    alpha_63 = alpha_62;
    u_8 = u_7;
    let _e11 = u_8;
    phi_3 = (6.2831855f * _e11.y);
    let _e15 = u_8;
    across_7 = sqrt(_e15.x);
    let _e19 = alpha_63;
    let _e21 = across_7;
    let _e23 = phi_3;
    let _e26 = alpha_63;
    let _e28 = across_7;
    let _e30 = phi_3;
    let _e34 = u_8;
    return normalize(vec3<f32>(((_e19.x * _e21) * cos(_e23)), ((_e26.y * _e28) * sin(_e30)), sqrt(max((1f - _e34.x), 0f))));
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
    let _e6 = x_3;
    if (_e6 > 1f) {
        let _e10 = x_3;
        return log((1f + _e10));
    }
    let _e13 = x_3;
    t_18 = max(_e13, 0f);
    let _e17 = t_18;
    whole = (_e17 <= 0.4f);
    let _e21 = whole;
    if _e21 {
        let _e22 = t_18;
        local_28 = _e22;
    } else {
        let _e23 = t_18;
        let _e26 = t_18;
        local_28 = (_e23 / (1f + sqrt((1f + _e26))));
    }
    let _e32 = local_28;
    h_13 = _e32;
    let _e34 = h_13;
    let _e36 = h_13;
    y_1 = (_e34 / (2f + _e36));
    let _e40 = y_1;
    let _e41 = y_1;
    y2_ = (_e40 * _e41);
    let _e47 = y2_;
    let _e51 = y2_;
    tail = (0.05882353f + (_e47 * (0.05263158f + (_e51 * 0.04761905f))));
    let _e63 = y2_;
    let _e67 = y2_;
    let _e71 = y2_;
    let _e72 = tail;
    tail = (0.09090909f + (_e63 * (0.07692308f + (_e67 * (0.06666667f + (_e71 * _e72))))));
    let _e82 = y2_;
    let _e86 = y2_;
    let _e90 = y2_;
    let _e91 = tail;
    tail = (0.2f + (_e82 * (0.14285715f + (_e86 * (0.11111111f + (_e90 * _e91))))));
    let _e98 = whole;
    if _e98 {
        local_29 = 2f;
    } else {
        local_29 = 4f;
    }
    let _e102 = local_29;
    let _e103 = y_1;
    let _e106 = y2_;
    let _e110 = y2_;
    let _e111 = tail;
    return ((_e102 * _e103) * (1f + (_e106 * (0.33333334f + (_e110 * _e111)))));
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
    let _e11 = eAvg_1;
    lost = (1f - _e11);
    let _e14 = lost;
    if (_e14 > 0f) {
        let _e18 = eI_1;
        let _e21 = eO_1;
        let _e24 = lost;
        local_30 = (((1f - _e18) * (1f - _e21)) / (BSDF_PI * _e24));
    } else {
        local_30 = 0f;
    }
    let _e29 = local_30;
    return _e29;
}

fn multipleFresnel(f_13: f32, eAvg_2: f32) -> f32 {
    var f_14: f32;
    var eAvg_3: f32;
    var left: f32;
    var local_31: f32;

    f_14 = f_13;
    eAvg_3 = eAvg_2;
    let _e9 = f_14;
    let _e11 = eAvg_3;
    left = (1f - (_e9 * (1f - _e11)));
    let _e16 = left;
    if (_e16 > 0f) {
        let _e19 = f_14;
        let _e20 = f_14;
        let _e22 = eAvg_3;
        let _e24 = left;
        local_31 = (((_e19 * _e20) * _e22) / _e24);
    } else {
        local_31 = 0f;
    }
    let _e28 = local_31;
    return _e28;
}

fn multipleFresnelRgb(f_15: vec3<f32>, eAvg_4: f32) -> vec3<f32> {
    var f_16: vec3<f32>;
    var eAvg_5: f32;

    f_16 = f_15;
    eAvg_5 = eAvg_4;
    let _e8 = f_16;
    let _e10 = eAvg_5;
    let _e11 = multipleFresnel(_e8.x, _e10);
    let _e12 = f_16;
    let _e14 = eAvg_5;
    let _e15 = multipleFresnel(_e12.y, _e14);
    let _e16 = f_16;
    let _e18 = eAvg_5;
    let _e19 = multipleFresnel(_e16.z, _e18);
    return vec3<f32>(_e11, _e15, _e19);
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
    let _e15 = r1_1;
    let _e17 = t1_1;
    lost_1 = max(((1f - _e15) - _e17), 0f);
    let _e22 = eta_29;
    if (_e22 < 1f) {
        let _e26 = eta_29;
        let _e27 = eta_29;
        let _e29 = cosO_3;
        let _e33 = alpha_65;
        local_32 = (1f - (((_e26 * _e27) * _e29) * (0.35f + (0.55f * min(_e33, 1f)))));
    } else {
        local_32 = 0f;
    }
    let _e42 = local_32;
    outward = _e42;
    let _e46 = r1_1;
    let _e47 = lost_1;
    let _e48 = outward;
    e.reflected = (_e46 + (_e47 * _e48));
    let _e53 = e;
    e.transmitted = (1f - _e53.reflected);
    let _e56 = e;
    return _e56;
}

fn phongExponent(alpha_66: f32) -> f32 {
    var alpha_67: f32;
    var a2_1: f32;

    alpha_67 = alpha_66;
    let _e6 = alpha_67;
    let _e7 = alpha_67;
    a2_1 = max((_e6 * _e7), 0.000000000000000001f);
    let _e14 = a2_1;
    let _e17 = a2_1;
    return max(((2f * (1f - _e14)) / _e17), 0f);
}

fn phongAlpha(exponent: f32) -> f32 {
    var exponent_1: f32;

    exponent_1 = exponent;
    let _e7 = exponent_1;
    return sqrt((2f / (max(_e7, 0f) + 2f)));
}

fn phongD(m_10: Tilt, exponent_2: f32) -> f32 {
    var m_11: Tilt;
    var exponent_3: f32;
    var z2_: f32;
    var tan2_: f32;

    m_11 = m_10;
    exponent_3 = exponent_2;
    let _e8 = m_11;
    let _e10 = m_11;
    z2_ = (_e8.z * _e10.z);
    let _e14 = z2_;
    if !((_e14 > 0f)) {
        return 0f;
    }
    let _e19 = m_11;
    let _e21 = z2_;
    tan2_ = min((_e19.p / _e21), 10000000000000000000000000000000000000f);
    let _e26 = exponent_3;
    let _e35 = exponent_3;
    let _e37 = tan2_;
    let _e38 = log1pPositive(_e37);
    return (((_e26 + 2f) / 6.2831855f) * exp(((-0.5f * _e35) * _e38)));
}

fn phongG1(w_20: Tilt, exponent_4: f32) -> f32 {
    var w_21: Tilt;
    var exponent_5: f32;

    w_21 = w_20;
    exponent_5 = exponent_4;
    let _e8 = w_21;
    let _e9 = exponent_5;
    let _e10 = phongAlpha(_e9);
    let _e11 = beckmannG1(_e8, _e10);
    return _e11;
}

fn phongG2(wi_30: Tilt, wo_34: Tilt, exponent_6: f32) -> f32 {
    var wi_31: Tilt;
    var wo_35: Tilt;
    var exponent_7: f32;

    wi_31 = wi_30;
    wo_35 = wo_34;
    exponent_7 = exponent_6;
    let _e10 = wi_31;
    let _e11 = wo_35;
    let _e12 = exponent_7;
    let _e13 = phongAlpha(_e12);
    let _e14 = beckmannG2(_e10, _e11, _e13);
    return _e14;
}

fn phongV(wi_32: Tilt, wo_36: Tilt, exponent_8: f32) -> f32 {
    var wi_33: Tilt;
    var wo_37: Tilt;
    var exponent_9: f32;

    wi_33 = wi_32;
    wo_37 = wo_36;
    exponent_9 = exponent_8;
    let _e10 = wi_33;
    let _e11 = wo_37;
    let _e12 = exponent_9;
    let _e13 = phongAlpha(_e12);
    let _e14 = beckmannV(_e10, _e11, _e13);
    return _e14;
}

fn phongPdf(m_12: Tilt, exponent_10: f32) -> f32 {
    var m_13: Tilt;
    var exponent_11: f32;

    m_13 = m_12;
    exponent_11 = exponent_10;
    let _e8 = m_13;
    let _e9 = exponent_11;
    let _e10 = phongD(_e8, _e9);
    let _e11 = m_13;
    let _e12 = tiltCos(_e11);
    return (_e10 * _e12);
}

fn phongSample(exponent_12: f32, u_9: vec2<f32>) -> vec3<f32> {
    var exponent_13: f32;
    var u_10: vec2<f32>;
    var phi_4: f32;
    var z_7: f32;
    var r_7: f32;

    exponent_13 = exponent_12;
    u_10 = u_9;
    let _e11 = u_10;
    phi_4 = (6.2831855f * _e11.y);
    let _e16 = u_10;
    let _e20 = exponent_13;
    z_7 = exp((log((1f - _e16.x)) / (_e20 + 2f)));
    let _e27 = z_7;
    let _e30 = z_7;
    r_7 = sqrt(max(((1f - _e27) * (1f + _e30)), 0f));
    let _e37 = r_7;
    let _e38 = phi_4;
    let _e41 = r_7;
    let _e42 = phi_4;
    let _e45 = z_7;
    return vec3<f32>((_e37 * cos(_e38)), (_e41 * sin(_e42)), _e45);
}

fn reflectionLobe(f_17: Facet, d: f32, v_10: f32) -> f32 {
    var f_18: Facet;
    var d_1: f32;
    var v_11: f32;
    var local_33: f32;

    f_18 = f_17;
    d_1 = d;
    v_11 = v_10;
    let _e10 = f_18;
    let _e12 = d_1;
    if (_e10.exists && (_e12 > 0f)) {
        let _e16 = d_1;
        let _e17 = v_11;
        local_33 = (_e16 * _e17);
    } else {
        local_33 = 0f;
    }
    let _e21 = local_33;
    return _e21;
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
    let _e12 = f_20;
    let _e13 = d_3;
    let _e14 = v_13;
    let _e15 = f_20;
    let _e17 = f_20;
    let _e19 = eta_31;
    let _e20 = fresnelDielectric(_e15.woDotM, _e17.g, _e19);
    let _e22 = reflectionLobe(_e12, _e13, (_e14 * _e20));
    return _e22;
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
    let _e12 = f_22;
    let _e13 = d_5;
    let _e14 = v_15;
    let _e15 = eta_33;
    let _e16 = reflectionF(_e12, _e13, _e14, _e15);
    let _e17 = f_22;
    return (_e16 * _e17.wi.z);
}

fn reflectionPdf(f_23: Facet, pdfM: f32) -> f32 {
    var f_24: Facet;
    var pdfM_1: f32;

    f_24 = f_23;
    pdfM_1 = pdfM;
    let _e8 = pdfM_1;
    let _e9 = f_24;
    let _e10 = reflectionJacobian(_e9);
    return (_e8 * _e10);
}

fn reflectAbout(wo_38: vec3<f32>, wm: vec3<f32>) -> vec3<f32> {
    var wo_39: vec3<f32>;
    var wm_1: vec3<f32>;

    wo_39 = wo_38;
    wm_1 = wm;
    let _e9 = wo_39;
    let _e10 = wm_1;
    let _e13 = wm_1;
    let _e15 = wo_39;
    return (((2f * dot(_e9, _e10)) * _e13) - _e15);
}

fn stirlingRest(x_4: f32) -> f32 {
    var x_5: f32;
    var r_8: f32;
    var r2_: f32;

    x_5 = x_4;
    let _e7 = x_5;
    r_8 = (1f / _e7);
    let _e10 = r_8;
    let _e11 = r_8;
    r2_ = (_e10 * _e11);
    let _e14 = r_8;
    let _e18 = r2_;
    let _e22 = r2_;
    let _e26 = r2_;
    let _e30 = r2_;
    return (_e14 * (0.083333336f - (_e18 * (0.0027777778f - (_e22 * (0.0007936508f - (_e26 * (0.0005952381f - (_e30 / 1188f)))))))));
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
    let _e9 = lambdaI_1;
    x_6 = (7f + _e9);
    let _e13 = lambdaO_1;
    y_2 = (7f + _e13);
    let _e16 = x_6;
    let _e17 = y_2;
    let _e18 = x_6;
    let _e20 = log1pPositive((_e17 / _e18));
    let _e22 = y_2;
    let _e23 = x_6;
    let _e24 = y_2;
    let _e26 = log1pPositive((_e23 / _e24));
    power = ((_e16 * _e20) + (_e22 * _e26));
    let _e30 = x_6;
    let _e31 = stirlingRest(_e30);
    let _e32 = y_2;
    let _e33 = stirlingRest(_e32);
    let _e35 = x_6;
    let _e36 = y_2;
    let _e38 = stirlingRest((_e35 + _e36));
    rest_4 = ((_e31 + _e33) - _e38);
    let _e41 = power;
    root = exp((-(_e41) / 6f));
    let _e51 = x_6;
    let _e54 = y_2;
    let _e59 = rest_4;
    product_3 = (sqrt((6.2831855f * ((1f / _e51) + (1f / _e54)))) * exp(_e59));
    loop {
        let _e65 = k_10;
        if !((_e65 < 6i)) {
            break;
        }
        {
            let _e72 = x_6;
            x_6 = (_e72 - 1f);
            let _e75 = y_2;
            y_2 = (_e75 - 1f);
            let _e78 = product_3;
            let _e79 = x_6;
            let _e80 = y_2;
            let _e82 = x_6;
            let _e84 = root;
            let _e86 = x_6;
            let _e87 = y_2;
            let _e91 = y_2;
            product_3 = (_e78 * ((((_e79 + _e80) / _e82) * _e84) * (((_e86 + _e87) + 1f) / _e91)));
        }
        continuing {
            let _e69 = k_10;
            k_10 = (_e69 + 1i);
        }
    }
    let _e95 = product_3;
    return min(_e95, 1f);
}

fn ggxG2Beta(wi_34: Tilt, wo_40: Tilt, alpha_68: f32) -> f32 {
    var wi_35: Tilt;
    var wo_41: Tilt;
    var alpha_69: f32;

    wi_35 = wi_34;
    wo_41 = wo_40;
    alpha_69 = alpha_68;
    let _e10 = wi_35;
    let _e11 = alpha_69;
    let _e12 = ggxLambda(_e10, _e11);
    let _e13 = wo_41;
    let _e14 = alpha_69;
    let _e15 = ggxLambda(_e13, _e14);
    let _e16 = smithG2Beta(_e12, _e15);
    return _e16;
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
    let _e11 = wi_37;
    let _e14 = wo_43;
    cosines = ((4f * _e11.z) * _e14.z);
    let _e18 = cosines;
    if (_e18 > 0f) {
        let _e21 = wi_37;
        let _e22 = wo_43;
        let _e23 = alpha_71;
        let _e24 = ggxG2Beta(_e21, _e22, _e23);
        let _e25 = cosines;
        local_34 = (_e24 / _e25);
    } else {
        local_34 = 0f;
    }
    let _e29 = local_34;
    return _e29;
}

fn filmBaseIor(f0_4: f32) -> f32 {
    var f0_5: f32;
    var r_9: f32;

    f0_5 = f0_4;
    let _e6 = f0_5;
    r_9 = sqrt(clamp(_e6, 0f, 0.9999f));
    let _e13 = r_9;
    let _e16 = r_9;
    return ((1f + _e13) / (1f - _e16));
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
    let _e12 = nearIor_1;
    let _e13 = nearCos_1;
    let _e15 = farIor_1;
    let _e16 = farCos_1;
    across_8 = ((_e12 * _e13) + (_e15 * _e16));
    let _e20 = farIor_1;
    let _e21 = nearCos_1;
    let _e23 = nearIor_1;
    let _e24 = farCos_1;
    within = ((_e20 * _e21) + (_e23 * _e24));
    let _e28 = across_8;
    if (_e28 > 0f) {
        let _e31 = nearIor_1;
        let _e32 = nearCos_1;
        let _e34 = farIor_1;
        let _e35 = farCos_1;
        let _e38 = across_8;
        local_35 = (((_e31 * _e32) - (_e34 * _e35)) / _e38);
    } else {
        local_35 = 0f;
    }
    let _e42 = local_35;
    let _e43 = within;
    if (_e43 > 0f) {
        let _e46 = farIor_1;
        let _e47 = nearCos_1;
        let _e49 = nearIor_1;
        let _e50 = farCos_1;
        let _e53 = within;
        local_36 = (((_e46 * _e47) - (_e49 * _e50)) / _e53);
    } else {
        local_36 = 0f;
    }
    let _e57 = local_36;
    return vec2<f32>(_e42, _e57);
}

fn filmCosines(opd: f32) -> vec3<f32> {
    var opd_1: f32;
    var k_11: f32;
    var k2_: f32;
    var x_7: f32;
    var y_3: f32;
    var z_8: f32;

    opd_1 = opd;
    let _e9 = opd_1;
    k_11 = (6.2831855f * _e9);
    let _e12 = k_11;
    let _e13 = k_11;
    k2_ = (_e12 * _e13);
    let _e18 = k_11;
    let _e24 = k2_;
    let _e30 = k_11;
    let _e36 = k2_;
    x_7 = (((0.8462f * cos((1681000f * _e18))) * exp((-4327800000f * _e24))) + ((0.1538f * cos((2239900f * _e30))) * exp((-4528200000f * _e36))));
    let _e43 = k_11;
    let _e48 = k2_;
    y_3 = (cos((1795300f * _e43)) * exp((-9304600000f * _e48)));
    let _e54 = k_11;
    let _e59 = k2_;
    z_8 = (cos((2208400f * _e54)) * exp((-6612100000f * _e59)));
    let _e65 = x_7;
    let _e68 = y_3;
    let _e72 = z_8;
    let _e77 = x_7;
    let _e80 = y_3;
    let _e84 = z_8;
    let _e88 = x_7;
    let _e91 = y_3;
    let _e95 = z_8;
    return vec3<f32>((((2.689655f * _e65) - (1.275862f * _e68)) - (0.413793f * _e72)), (((-1.022107f * _e77) + (1.978286f * _e80)) + (0.043821f * _e84)), (((0.061225f * _e88) - (0.22449f * _e91)) + (1.163265f * _e95)));
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
    let _e10 = a_25;
    let _e12 = b_16;
    q = (-(_e10) * _e12);
    let _e16 = a_25;
    let _e17 = a_25;
    let _e21 = b_16;
    let _e22 = b_16;
    let _e27 = q;
    let _e28 = q;
    t_19 = (((1f - (_e16 * _e17)) * (1f - (_e21 * _e22))) / max((1f - (_e27 * _e28)), 0.000000001f));
    let _e36 = t_19;
    let _e39 = q;
    let _e41 = cosines_2;
    let _e43 = q;
    let _e44 = cosines_2;
    let _e46 = q;
    let _e47 = cosines_2;
    return (1f - (_e36 * (1f + ((2f * _e39) * (_e41.x + (_e43 * (_e44.y + (_e46 * _e47.z))))))));
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
    let _e17 = sin2_4;
    let _e18 = baseIor_1;
    let _e19 = baseIor_1;
    baseCos = sqrt(max((1f - (_e17 / (_e18 * _e19))), 0f));
    let _e27 = filmIor_1;
    let _e28 = filmCos_1;
    let _e29 = baseIor_1;
    let _e30 = baseCos;
    let _e31 = filmAmplitudes(_e27, _e28, _e29, _e30);
    second = _e31;
    let _e34 = first_1;
    let _e36 = second;
    let _e38 = cosines_4;
    let _e39 = filmSeries(_e34.x, _e36.x, _e38);
    let _e40 = first_1;
    let _e42 = second;
    let _e44 = cosines_4;
    let _e45 = filmSeries(_e40.y, _e42.y, _e44);
    return clamp((0.5f * (_e39 + _e45)), 0f, 1f);
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
    let _e12 = cosTheta_23;
    c_15 = clamp(_e12, 0f, 1f);
    let _e17 = c_15;
    if !((_e17 > 0f)) {
        return vec3(1f);
    }
    let _e24 = c_15;
    let _e25 = c_15;
    sin2_5 = (1f - (_e24 * _e25));
    let _e30 = sin2_5;
    let _e31 = filmIor_3;
    let _e32 = filmIor_3;
    filmCos_2 = sqrt(max((1f - (_e30 / (_e31 * _e32))), 0f));
    let _e41 = c_15;
    let _e42 = filmIor_3;
    let _e43 = filmCos_2;
    let _e44 = filmAmplitudes(1f, _e41, _e42, _e43);
    first_2 = _e44;
    let _e47 = filmIor_3;
    let _e49 = thickness_1;
    let _e51 = filmCos_2;
    opd_2 = (((0.000000002f * _e47) * _e49) * _e51);
    let _e54 = opd_2;
    let _e55 = filmCosines(_e54);
    one = _e55;
    let _e58 = opd_2;
    let _e60 = filmCosines((2f * _e58));
    two = _e60;
    let _e63 = opd_2;
    let _e65 = filmCosines((3f * _e63));
    three = _e65;
    let _e67 = first_2;
    let _e68 = sin2_5;
    let _e69 = filmIor_3;
    let _e70 = filmCos_2;
    let _e71 = baseIor_3;
    let _e73 = one;
    let _e75 = two;
    let _e77 = three;
    let _e80 = filmChannel(_e67, _e68, _e69, _e70, _e71.x, vec3<f32>(_e73.x, _e75.x, _e77.x));
    let _e81 = first_2;
    let _e82 = sin2_5;
    let _e83 = filmIor_3;
    let _e84 = filmCos_2;
    let _e85 = baseIor_3;
    let _e87 = one;
    let _e89 = two;
    let _e91 = three;
    let _e94 = filmChannel(_e81, _e82, _e83, _e84, _e85.y, vec3<f32>(_e87.y, _e89.y, _e91.y));
    let _e95 = first_2;
    let _e96 = sin2_5;
    let _e97 = filmIor_3;
    let _e98 = filmCos_2;
    let _e99 = baseIor_3;
    let _e101 = one;
    let _e103 = two;
    let _e105 = three;
    let _e108 = filmChannel(_e95, _e96, _e97, _e98, _e99.z, vec3<f32>(_e101.z, _e103.z, _e105.z));
    return vec3<f32>(_e80, _e94, _e108);
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
    let _e12 = f_26;
    let _e14 = d_7;
    if !((_e12.exists && (_e14 > 0f))) {
        return 0f;
    }
    let _e20 = f_26;
    let _e22 = f_26;
    let _e24 = eta_35;
    let _e25 = fresnelTransmitted(_e20.woDotM, _e22.g, _e24);
    through = _e25;
    let _e28 = eta_35;
    let _e30 = f_26;
    let _e33 = v_17;
    let _e35 = eta_35;
    let _e36 = f_26;
    let _e39 = f_26;
    let _e42 = d_7;
    let _e45 = through;
    return (((((4f * _e28) * _e30.wiDotM) * _e33) * (((_e35 * _e36.woDotM) / _e39.s) * _e42)) * _e45);
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
    let _e12 = f_28;
    let _e13 = d_9;
    let _e14 = v_19;
    let _e15 = eta_37;
    let _e16 = transmissionScatter(_e12, _e13, _e14, _e15);
    scatter = _e16;
    let _e18 = f_28;
    if _e18.exists {
        let _e20 = scatter;
        let _e21 = eta_37;
        let _e22 = eta_37;
        local_37 = (_e20 / (_e21 * _e22));
    } else {
        local_37 = 0f;
    }
    let _e27 = local_37;
    return _e27;
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
    let _e12 = f_30;
    let _e13 = d_11;
    let _e14 = v_21;
    let _e15 = eta_39;
    let _e16 = transmissionF(_e12, _e13, _e14, _e15);
    let _e17 = f_30;
    return (_e16 * _e17.wi.z);
}

fn transmissionPdf(f_31: Facet, pdfM_2: f32, eta_40: f32) -> f32 {
    var f_32: Facet;
    var pdfM_3: f32;
    var eta_41: f32;

    f_32 = f_31;
    pdfM_3 = pdfM_2;
    eta_41 = eta_40;
    let _e10 = pdfM_3;
    let _e11 = f_32;
    let _e12 = eta_41;
    let _e13 = transmissionJacobian(_e11, _e12);
    return (_e10 * _e13);
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
    let _e10 = wo_45;
    let _e11 = wm_3;
    if (dot(_e10, _e11) < 0f) {
        local_38 = -1f;
    } else {
        local_38 = 1f;
    }
    let _e19 = local_38;
    side_2 = _e19;
    let _e21 = wo_45;
    let _e22 = wm_3;
    c_16 = abs(dot(_e21, _e22));
    let _e26 = c_16;
    let _e27 = eta_43;
    let _e28 = fresnelG(_e26, _e27);
    g_6 = _e28;
    let _e30 = eta_43;
    if (_e30 == 1f) {
        let _e33 = wo_45;
        return -(_e33);
    }
    let _e35 = g_6;
    let _e38 = eta_43;
    if !(((_e35 > 0f) && (_e38 > 0f))) {
        return vec3(0f);
    }
    let _e46 = eta_43;
    let _e49 = eta_43;
    let _e52 = c_16;
    let _e53 = g_6;
    along_2 = (((1f - _e46) * (1f + _e49)) / (_e52 + _e53));
    let _e57 = side_2;
    let _e58 = along_2;
    let _e60 = wm_3;
    let _e62 = wo_45;
    let _e64 = eta_43;
    return ((((_e57 * _e58) * _e60) - _e62) / vec3(_e64));
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
    let _e28 = r_10;
    return _e28;
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
    let _e16 = distribution_1;
    if (_e16 == BSDF_GGX) {
        {
            let _e19 = f_34;
            let _e21 = alpha_73;
            let _e22 = ggxD(_e19.h, _e21);
            r_11.d = _e22;
            let _e24 = f_34;
            let _e26 = f_34;
            let _e28 = alpha_73;
            let _e29 = ggxG2(_e24.wi, _e26.wo, _e28);
            r_11.g = _e29;
            let _e31 = f_34;
            let _e33 = f_34;
            let _e35 = alpha_73;
            let _e36 = ggxV(_e31.wi, _e33.wo, _e35);
            r_11.v = _e36;
            let _e38 = f_34;
            let _e40 = f_34;
            let _e42 = alpha_73;
            let _e43 = ggxVCorrelated(_e38.wi, _e40.wo, _e42);
            r_11.vCorrelated = _e43;
        }
    } else {
        let _e44 = distribution_1;
        if (_e44 == BSDF_BECKMANN) {
            {
                let _e47 = f_34;
                let _e49 = alpha_73;
                let _e50 = beckmannD(_e47.h, _e49);
                r_11.d = _e50;
                let _e52 = f_34;
                let _e54 = f_34;
                let _e56 = alpha_73;
                let _e57 = beckmannG2(_e52.wi, _e54.wo, _e56);
                r_11.g = _e57;
                let _e59 = f_34;
                let _e61 = f_34;
                let _e63 = alpha_73;
                let _e64 = beckmannV(_e59.wi, _e61.wo, _e63);
                r_11.v = _e64;
            }
        } else {
            {
                let _e66 = f_34;
                let _e68 = alpha_73;
                let _e69 = phongD(_e66.h, _e68);
                r_11.d = _e69;
                let _e71 = f_34;
                let _e73 = f_34;
                let _e75 = alpha_73;
                let _e76 = phongG2(_e71.wi, _e73.wo, _e75);
                r_11.g = _e76;
                let _e78 = f_34;
                let _e80 = f_34;
                let _e82 = alpha_73;
                let _e83 = phongV(_e78.wi, _e80.wo, _e82);
                r_11.v = _e83;
            }
        }
    }
    let _e84 = r_11;
    return _e84;
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
    let _e11 = bsdfNoValues();
    r_12 = _e11;
    let _e13 = f_36;
    if !(_e13.exists) {
        let _e16 = r_12;
        return _e16;
    }
    let _e17 = f_36;
    let _e18 = surface_1;
    let _e20 = surface_1;
    let _e22 = bsdfShape(_e17, _e18.distribution, _e20.alpha);
    shape = _e22;
    let _e24 = surface_1;
    ggx = (_e24.distribution == BSDF_GGX);
    let _e28 = surface_1;
    metal = (_e28.eta == 0f);
    let _e33 = shape;
    let _e35 = f_36;
    let _e37 = tiltCos(_e35.h);
    pdfM_4 = (_e33.d * _e37);
    let _e40 = ggx;
    if _e40 {
        let _e41 = f_36;
        let _e42 = surface_1;
        let _e44 = ggxPdfVisible(_e41, _e42.alpha);
        local_39 = _e44;
    } else {
        local_39 = 0f;
    }
    let _e47 = local_39;
    pdfVisibleM = _e47;
    let _e50 = shape;
    r_12.d = _e50.d;
    let _e53 = shape;
    r_12.g = _e53.g;
    let _e56 = ggx;
    if _e56 {
        let _e57 = f_36;
        let _e59 = f_36;
        let _e61 = surface_1;
        let _e63 = ggxG2Correlated(_e57.wi, _e59.wo, _e61.alpha);
        local_40 = _e63;
    } else {
        local_40 = 0f;
    }
    let _e66 = local_40;
    r_12.gCorrelated = _e66;
    let _e68 = metal;
    if _e68 {
        let _e69 = f_36;
        let _e71 = surface_1;
        let _e73 = surface_1;
        let _e75 = fresnelConductor(_e69.woDotM, _e71.n, _e73.k);
        local_41 = _e75;
    } else {
        let _e76 = f_36;
        let _e78 = f_36;
        let _e80 = surface_1;
        let _e82 = fresnelDielectric(_e76.woDotM, _e78.g, _e80.eta);
        local_41 = _e82;
    }
    let _e84 = local_41;
    r_12.fresnel = _e84;
    let _e86 = metal;
    if _e86 {
        let _e87 = f_36;
        let _e89 = surface_1;
        let _e91 = surface_1;
        let _e93 = fresnelAbsorbed(_e87.woDotM, _e89.n, _e91.k);
        local_42 = _e93;
    } else {
        let _e94 = f_36;
        let _e96 = f_36;
        let _e98 = surface_1;
        let _e100 = fresnelTransmitted(_e94.woDotM, _e96.g, _e98.eta);
        local_42 = _e100;
    }
    let _e102 = local_42;
    r_12.transmitted = _e102;
    let _e103 = surface_1;
    if _e103.transmits {
        {
            let _e106 = f_36;
            let _e107 = shape;
            let _e109 = shape;
            let _e111 = surface_1;
            let _e113 = transmissionScatter(_e106, _e107.d, _e109.v, _e111.eta);
            r_12.f = _e113;
            let _e115 = f_36;
            let _e116 = shape;
            let _e118 = shape;
            let _e120 = surface_1;
            let _e122 = transmissionScatter(_e115, _e116.d, _e118.vCorrelated, _e120.eta);
            r_12.fCorrelated = _e122;
            let _e124 = f_36;
            let _e125 = pdfM_4;
            let _e126 = surface_1;
            let _e128 = transmissionPdf(_e124, _e125, _e126.eta);
            r_12.pdfD = _e128;
            let _e130 = f_36;
            let _e131 = pdfVisibleM;
            let _e132 = surface_1;
            let _e134 = transmissionPdf(_e130, _e131, _e132.eta);
            r_12.pdfVisible = _e134;
        }
    } else {
        {
            let _e136 = f_36;
            let _e137 = shape;
            let _e139 = shape;
            let _e141 = r_12;
            let _e144 = reflectionLobe(_e136, _e137.d, (_e139.v * _e141.fresnel));
            r_12.f = _e144;
            let _e146 = f_36;
            let _e147 = shape;
            let _e149 = shape;
            let _e151 = r_12;
            let _e154 = reflectionLobe(_e146, _e147.d, (_e149.vCorrelated * _e151.fresnel));
            r_12.fCorrelated = _e154;
            let _e156 = f_36;
            let _e157 = pdfM_4;
            let _e158 = reflectionPdf(_e156, _e157);
            r_12.pdfD = _e158;
            let _e160 = f_36;
            let _e161 = pdfVisibleM;
            let _e162 = reflectionPdf(_e160, _e161);
            r_12.pdfVisible = _e162;
        }
    }
    let _e164 = r_12;
    let _e166 = f_36;
    r_12.fCos = (_e164.f * _e166.wi.z);
    let _e170 = r_12;
    return _e170;
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
    let _e15 = surface_3;
    if _e15.transmits {
        let _e17 = wi_39;
        let _e18 = wo_47;
        let _e19 = n_25;
        let _e20 = surface_3;
        let _e22 = transmissionFacet(_e17, _e18, _e19, _e20.eta);
        return _e22;
    }
    let _e23 = wi_39;
    let _e24 = wo_47;
    let _e25 = n_25;
    let _e26 = surface_3;
    let _e28 = reflectionFacet(_e23, _e24, _e25, _e26.eta);
    return _e28;
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
    let _e15 = surface_5;
    if _e15.transmits {
        let _e17 = wi_41;
        let _e18 = wo_49;
        let _e19 = n_27;
        let _e20 = surface_5;
        let _e22 = preciseTransmissionFacet(_e17, _e18, _e19, _e20.eta);
        return _e22;
    }
    let _e23 = wi_41;
    let _e24 = wo_49;
    let _e25 = n_27;
    let _e26 = surface_5;
    let _e28 = preciseReflectionFacet(_e23, _e24, _e25, _e26.eta);
    return _e28;
}

fn srgbFromLinear(linear: f32) -> f32 {
    var linear_1: f32;
    var v_22: f32;
    var local_43: f32;

    linear_1 = linear;
    let _e9 = linear_1;
    v_22 = clamp(_e9, 0f, 1f);
    let _e14 = v_22;
    if (_e14 <= 0.0031308f) {
        let _e18 = v_22;
        local_43 = (12.92f * _e18);
    } else {
        let _e21 = v_22;
        local_43 = ((1.055f * pow(_e21, 0.41666666f)) - 0.055f);
    }
    let _e30 = local_43;
    return _e30;
}

fn linearFromSrgb(encoded: f32) -> f32 {
    var encoded_1: f32;
    var v_23: f32;
    var local_44: f32;

    encoded_1 = encoded;
    let _e9 = encoded_1;
    v_23 = clamp(_e9, 0f, 1f);
    let _e14 = v_23;
    if (_e14 <= 0.04045f) {
        let _e17 = v_23;
        local_44 = (_e17 / 12.92f);
    } else {
        let _e20 = v_23;
        local_44 = pow(((_e20 + 0.055f) / 1.055f), 2.4f);
    }
    let _e28 = local_44;
    return _e28;
}

fn srgbFromLinearRgb(linear_2: vec3<f32>) -> vec3<f32> {
    var linear_3: vec3<f32>;

    linear_3 = linear_2;
    let _e9 = linear_3;
    let _e11 = srgbFromLinear(_e9.x);
    let _e12 = linear_3;
    let _e14 = srgbFromLinear(_e12.y);
    let _e15 = linear_3;
    let _e17 = srgbFromLinear(_e15.z);
    return vec3<f32>(_e11, _e14, _e17);
}

fn linearFromSrgbRgb(encoded_2: vec3<f32>) -> vec3<f32> {
    var encoded_3: vec3<f32>;

    encoded_3 = encoded_2;
    let _e9 = encoded_3;
    let _e11 = linearFromSrgb(_e9.x);
    let _e12 = encoded_3;
    let _e14 = linearFromSrgb(_e12.y);
    let _e15 = encoded_3;
    let _e17 = linearFromSrgb(_e15.z);
    return vec3<f32>(_e11, _e14, _e17);
}

fn tonemapInput(radiance: vec3<f32>) -> vec3<f32> {
    var radiance_1: vec3<f32>;

    radiance_1 = radiance;
    let _e10 = radiance_1;
    return clamp(_e10, vec3(0f), vec3(65504f));
}

fn tonemapMaxOf(c_17: vec3<f32>) -> f32 {
    var c_18: vec3<f32>;

    c_18 = c_17;
    let _e10 = c_18;
    let _e12 = c_18;
    let _e14 = c_18;
    return max(_e10.x, max(_e12.y, _e14.z));
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
    let _e16 = radiance_3;
    let _e17 = tonemapInput(_e16);
    c_19 = _e17;
    let _e19 = c_19;
    let _e21 = c_19;
    let _e23 = c_19;
    darkest = min(_e19.x, min(_e21.y, _e23.z));
    let _e28 = c_19;
    let _e29 = darkest;
    if (_e29 < 0.08f) {
        let _e32 = darkest;
        let _e34 = darkest;
        let _e36 = darkest;
        local_45 = (_e32 - ((6.25f * _e34) * _e36));
    } else {
        local_45 = 0.04f;
    }
    let _e41 = local_45;
    c_19 = (_e28 - vec3(_e41));
    let _e44 = c_19;
    let _e45 = tonemapMaxOf(_e44);
    peak = _e45;
    let _e47 = peak;
    let _e48 = start;
    if (_e47 < _e48) {
        let _e50 = c_19;
        return _e50;
    }
    let _e52 = start;
    room = (1f - _e52);
    let _e56 = room;
    let _e57 = room;
    let _e59 = peak;
    let _e60 = start;
    let _e62 = room;
    compressed = (1f - ((_e56 * _e57) / ((_e59 - _e60) + _e62)));
    let _e68 = desaturation;
    let _e69 = peak;
    let _e70 = compressed;
    keep = (1f / ((_e68 * (_e69 - _e70)) + 1f));
    let _e77 = compressed;
    let _e79 = c_19;
    let _e80 = compressed;
    let _e81 = peak;
    let _e84 = keep;
    return clamp(mix(vec3(_e77), (_e79 * (_e80 / _e81)), vec3(_e84)), vec3(0f), vec3(1f));
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
    let _e16 = r_14;
    let _e17 = c_21;
    let _e19 = g_8;
    let _e20 = c_21;
    let _e22 = b_18;
    let _e23 = c_21;
    return vec3<f32>(dot(_e16, _e17), dot(_e19, _e20), dot(_e22, _e23));
}

fn tonemapAces(radiance_4: vec3<f32>) -> vec3<f32> {
    var radiance_5: vec3<f32>;
    var c_22: vec3<f32>;

    radiance_5 = radiance_4;
    let _e22 = radiance_5;
    let _e23 = tonemapInput(_e22);
    let _e24 = tonemapRows(vec3<f32>(0.59719f, 0.35458f, 0.04823f), vec3<f32>(0.076f, 0.90834f, 0.01566f), vec3<f32>(0.0284f, 0.13383f, 0.83777f), _e23);
    c_22 = _e24;
    let _e26 = c_22;
    let _e27 = c_22;
    let _e35 = c_22;
    let _e37 = c_22;
    c_22 = (((_e26 * (_e27 + vec3(0.0245786f))) - vec3(0.000090537f)) / ((_e35 * ((0.983729f * _e37) + vec3(0.432951f))) + vec3(0.238081f)));
    let _e65 = c_22;
    let _e66 = tonemapRows(vec3<f32>(1.60475f, -0.53108f, -0.07367f), vec3<f32>(-0.10208f, 1.10813f, -0.00605f), vec3<f32>(-0.00327f, -0.07276f, 1.07602f), _e65);
    c_22 = _e66;
    let _e67 = c_22;
    return clamp(_e67, vec3(0f), vec3(1f));
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
    let _e14 = x_9;
    let _e15 = pivot;
    if (_e14 < _e15) {
        local_46 = 3f;
    } else {
        local_46 = 3.25f;
    }
    let _e20 = local_46;
    power_1 = _e20;
    let _e22 = x_9;
    let _e23 = pivot;
    if (_e22 < _e23) {
        let _e25 = pivot;
        local_47 = _e25;
    } else {
        let _e27 = pivot;
        local_47 = (1f - _e27);
    }
    let _e30 = local_47;
    width_2 = _e30;
    let _e33 = power_1;
    let _e35 = width_2;
    let _e36 = power_1;
    scale_2 = (pow(4f, _e33) - pow(_e35, -(_e36)));
    let _e43 = x_9;
    let _e44 = pivot;
    let _e48 = scale_2;
    let _e49 = x_9;
    let _e50 = pivot;
    let _e53 = power_1;
    let _e59 = power_1;
    return (0.5f + ((2f * (_e43 - _e44)) * pow((1f + (_e48 * pow(abs((_e49 - _e50)), _e53))), (-1f / _e59))));
}

fn tonemapAgx(radiance_6: vec3<f32>) -> vec3<f32> {
    var radiance_7: vec3<f32>;
    var blackStop: f32 = -12.473931f;
    var c_23: vec3<f32>;
    var stops: vec3<f32>;

    radiance_7 = radiance_6;
    let _e25 = radiance_7;
    let _e26 = tonemapInput(_e25);
    let _e27 = tonemapRows(vec3<f32>(0.84247905f, 0.0784336f, 0.079223745f), vec3<f32>(0.042328242f, 0.87846863f, 0.07916613f), vec3<f32>(0.042375654f, 0.0784336f, 0.879143f), _e26);
    c_23 = _e27;
    let _e29 = c_23;
    let _e30 = blackStop;
    let _e35 = blackStop;
    stops = ((log2(max(_e29, vec3(exp2(_e30)))) - vec3(_e35)) / vec3(16.5f));
    let _e42 = stops;
    stops = clamp(_e42, vec3(0f), vec3(1f));
    let _e48 = stops;
    let _e50 = tonemapAgxCurve(_e48.x);
    let _e51 = stops;
    let _e53 = tonemapAgxCurve(_e51.y);
    let _e54 = stops;
    let _e56 = tonemapAgxCurve(_e54.z);
    c_23 = vec3<f32>(_e50, _e53, _e56);
    let _e76 = c_23;
    let _e77 = tonemapRows(vec3<f32>(1.196879f, -0.09802088f, -0.09902974f), vec3<f32>(-0.052896854f, 1.1519032f, -0.098961174f), vec3<f32>(-0.052971635f, -0.09804345f, 1.1510737f), _e76);
    c_23 = _e77;
    let _e78 = c_23;
    return pow(clamp(_e78, vec3(0f), vec3(1f)), vec3(2.2f));
}

fn cubeDirection(face: i32, s_3: f32, t_20: f32) -> vec3<f32> {
    var face_1: i32;
    var s_4: f32;
    var t_21: f32;

    face_1 = face;
    s_4 = s_3;
    t_21 = t_20;
    let _e14 = face_1;
    if (_e14 == 0i) {
        let _e18 = t_21;
        let _e20 = s_4;
        return vec3<f32>(1f, -(_e18), -(_e20));
    }
    let _e23 = face_1;
    if (_e23 == 1i) {
        let _e28 = t_21;
        let _e30 = s_4;
        return vec3<f32>(-1f, -(_e28), _e30);
    }
    let _e32 = face_1;
    if (_e32 == 2i) {
        let _e35 = s_4;
        let _e37 = t_21;
        return vec3<f32>(_e35, 1f, _e37);
    }
    let _e39 = face_1;
    if (_e39 == 3i) {
        let _e42 = s_4;
        let _e45 = t_21;
        return vec3<f32>(_e42, -1f, -(_e45));
    }
    let _e48 = face_1;
    if (_e48 == 4i) {
        let _e51 = s_4;
        let _e52 = t_21;
        return vec3<f32>(_e51, -(_e52), 1f);
    }
    let _e56 = s_4;
    let _e58 = t_21;
    return vec3<f32>(-(_e56), -(_e58), -1f);
}

fn cubeCoordinate(index: i32, size: i32) -> f32 {
    var index_1: i32;
    var size_1: i32;

    index_1 = index;
    size_1 = size;
    let _e13 = index_1;
    let _e18 = size_1;
    return ((((2f * f32(_e13)) + 1f) / f32(_e18)) - 1f);
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
    let _e16 = face_3;
    let _e17 = x_11;
    let _e18 = size_3;
    let _e19 = cubeCoordinate(_e17, _e18);
    let _e20 = y_5;
    let _e21 = size_3;
    let _e22 = cubeCoordinate(_e20, _e21);
    let _e23 = cubeDirection(_e16, _e19, _e22);
    return normalize(_e23);
}

fn cubeLocal(face_4: i32, d_12: vec3<f32>) -> vec3<f32> {
    var face_5: i32;
    var d_13: vec3<f32>;

    face_5 = face_4;
    d_13 = d_12;
    let _e12 = face_5;
    if (_e12 == 0i) {
        let _e15 = d_13;
        let _e18 = d_13;
        let _e21 = d_13;
        return vec3<f32>(-(_e15.z), -(_e18.y), _e21.x);
    }
    let _e24 = face_5;
    if (_e24 == 1i) {
        let _e27 = d_13;
        let _e29 = d_13;
        let _e32 = d_13;
        return vec3<f32>(_e27.z, -(_e29.y), -(_e32.x));
    }
    let _e36 = face_5;
    if (_e36 == 2i) {
        let _e39 = d_13;
        let _e41 = d_13;
        let _e43 = d_13;
        return vec3<f32>(_e39.x, _e41.z, _e43.y);
    }
    let _e46 = face_5;
    if (_e46 == 3i) {
        let _e49 = d_13;
        let _e51 = d_13;
        let _e54 = d_13;
        return vec3<f32>(_e49.x, -(_e51.z), -(_e54.y));
    }
    let _e58 = face_5;
    if (_e58 == 4i) {
        let _e61 = d_13;
        let _e63 = d_13;
        let _e66 = d_13;
        return vec3<f32>(_e61.x, -(_e63.y), _e66.z);
    }
    let _e69 = d_13;
    let _e72 = d_13;
    let _e75 = d_13;
    return vec3<f32>(-(_e69.x), -(_e72.y), -(_e75.z));
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
    let _e16 = x_13;
    let _e17 = size_5;
    let _e18 = cubeCoordinate(_e16, _e17);
    let _e19 = y_7;
    let _e20 = size_5;
    let _e21 = cubeCoordinate(_e19, _e20);
    texel.local = normalize(vec3<f32>(_e18, _e21, 1f));
    let _e25 = texel;
    let _e28 = texel;
    z2_1 = (_e25.local.z * _e28.local.z);
    let _e34 = size_5;
    let _e35 = size_5;
    h2_ = (4f / f32((_e34 * _e35)));
    let _e41 = h2_;
    let _e42 = texel;
    let _e46 = z2_1;
    let _e49 = h2_;
    let _e54 = z2_1;
    let _e58 = z2_1;
    texel.solidAngle = (((_e41 * _e42.local.z) * _e46) * (1f + (((_e49 / 24f) * (9f - (15f * _e54))) * _e58)));
    let _e62 = texel;
    return _e62;
}

fn cubeTexelSolidAngle(x_14: i32, y_8: i32, size_6: i32) -> f32 {
    var x_15: i32;
    var y_9: i32;
    var size_7: i32;

    x_15 = x_14;
    y_9 = y_8;
    size_7 = size_6;
    let _e14 = x_15;
    let _e15 = y_9;
    let _e16 = size_7;
    let _e17 = cubeTexel(_e14, _e15, _e16);
    return _e17.solidAngle;
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
    let _e21 = along_4;
    let _e22 = along_4;
    let _e24 = outward_2;
    let _e25 = outward_2;
    let _e28 = sinRadius_1;
    let _e29 = sinRadius_1;
    beside2_ = (((_e21 * _e22) + (_e24 * _e25)) - (_e28 * _e29));
    let _e33 = beside2_;
    if (_e33 > 0f) {
        {
            let _e36 = beside2_;
            beside = sqrt(_e36);
            let _e39 = outward_2;
            let _e40 = beside;
            let _e42 = along_4;
            let _e43 = sinRadius_1;
            lowOut = ((_e39 * _e40) + (_e42 * _e43));
            let _e47 = outward_2;
            let _e48 = beside;
            let _e50 = along_4;
            let _e51 = sinRadius_1;
            highOut = ((_e47 * _e48) - (_e50 * _e51));
            let _e55 = lowOut;
            if (_e55 > 0f) {
                let _e58 = low_5;
                let _e59 = along_4;
                let _e60 = beside;
                let _e62 = outward_2;
                let _e63 = sinRadius_1;
                let _e66 = lowOut;
                low_5 = max(_e58, (((_e59 * _e60) - (_e62 * _e63)) / _e66));
            } else {
                let _e69 = along_4;
                if (_e69 >= 0f) {
                    low_5 = 2f;
                }
            }
            let _e73 = highOut;
            if (_e73 > 0f) {
                let _e76 = high;
                let _e77 = along_4;
                let _e78 = beside;
                let _e80 = outward_2;
                let _e81 = sinRadius_1;
                let _e84 = highOut;
                high = min(_e76, (((_e77 * _e78) + (_e80 * _e81)) / _e84));
            } else {
                let _e87 = along_4;
                if (_e87 <= 0f) {
                    high = -2f;
                }
            }
        }
    }
    let _e92 = low_5;
    let _e93 = high;
    if (_e92 > _e93) {
        return vec2<i32>(1i, 0i);
    }
    let _e99 = size_9;
    scale_3 = (0.5f * f32(_e99));
    let _e103 = scale_3;
    let _e104 = low_5;
    first_3 = i32(ceil(((_e103 * (_e104 + 1f)) - 0.5f)));
    let _e113 = scale_3;
    let _e114 = high;
    last = i32(floor(((_e113 * (_e114 + 1f)) - 0.5f)));
    let _e123 = first_3;
    let _e126 = last;
    let _e127 = size_9;
    return vec2<i32>(max(_e123, 0i), min(_e126, (_e127 - 1i)));
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
    let _e25 = l_1;
    let _e28 = cosRadius_1;
    let _e31 = sinRadius_3;
    if (_e25.z < ((0.57735f * _e28) - (0.8165f * _e31))) {
        let _e35 = range;
        return _e35;
    }
    let _e36 = l_1;
    let _e38 = l_1;
    let _e40 = sinRadius_3;
    let _e41 = size_11;
    let _e42 = cubeCapInterval(_e36.x, _e38.z, _e40, _e41);
    rangeX = _e42;
    let _e44 = l_1;
    let _e46 = l_1;
    let _e48 = sinRadius_3;
    let _e49 = size_11;
    let _e50 = cubeCapInterval(_e44.y, _e46.z, _e48, _e49);
    rangeY = _e50;
    let _e53 = rangeX;
    range.firstX = _e53.x;
    let _e56 = rangeX;
    range.lastX = _e56.y;
    let _e59 = rangeY;
    range.firstY = _e59.x;
    let _e62 = rangeY;
    range.lastY = _e62.y;
    let _e64 = range;
    return _e64;
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
    let _e16 = l_3;
    let _e18 = t_23;
    let _e20 = l_3;
    k_12 = ((_e16.y * _e18) + _e20.z);
    let _e24 = cosRadius_3;
    let _e25 = cosRadius_3;
    let _e27 = l_3;
    let _e29 = l_3;
    a_26 = ((_e24 * _e25) - (_e27.x * _e29.x));
    let _e34 = k_12;
    let _e35 = k_12;
    let _e37 = a_26;
    let _e39 = t_23;
    let _e40 = t_23;
    inside = (((_e34 * _e35) - (_e37 * (1f + (_e39 * _e40)))) + 0.0000004f);
    let _e48 = a_26;
    if (_e48 <= 0f) {
        let _e52 = size_13;
        return vec2<i32>(0i, (_e52 - 1i));
    }
    let _e56 = inside;
    if (_e56 < 0f) {
        return vec2<i32>(1i, 0i);
    }
    let _e62 = l_3;
    let _e64 = k_12;
    middle = (_e62.x * _e64);
    let _e67 = cosRadius_3;
    let _e68 = inside;
    spread_2 = (_e67 * sqrt(_e68));
    let _e73 = size_13;
    scale_4 = (0.5f * f32(_e73));
    let _e77 = scale_4;
    let _e78 = middle;
    let _e79 = spread_2;
    let _e81 = a_26;
    first_4 = i32(ceil(((_e77 * (((_e78 - _e79) / _e81) + 1f)) - 0.5f)));
    let _e91 = scale_4;
    let _e92 = middle;
    let _e93 = spread_2;
    let _e95 = a_26;
    last_1 = i32(floor(((_e91 * (((_e92 + _e93) / _e95) + 1f)) - 0.5f)));
    let _e105 = first_4;
    let _e108 = last_1;
    let _e109 = size_13;
    return vec2<i32>(max(_e105, 0i), min(_e108, (_e109 - 1i)));
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
    let _e12 = sigma_1;
    let _e13 = sigma_1;
    variance = (_e12 * _e13);
    let _e16 = stack_1;
    let _e18 = stack_1;
    first_5 = (_e16.y * _e18.y);
    let _e22 = stack_1;
    let _e24 = stack_1;
    sharp = (_e22.x * _e24.x);
    let _e29 = variance;
    let _e30 = first_5;
    if (_e29 < _e30) {
        {
            let _e33 = variance;
            let _e34 = sharp;
            let _e36 = first_5;
            let _e37 = sharp;
            levels.even = clamp(((_e33 - _e34) / (_e36 - _e37)), 0f, 1f);
            levels.odd = 0f;
            levels.oddShare = 0f;
            let _e47 = levels;
            return _e47;
        }
    }
    let _e48 = variance;
    let _e49 = first_5;
    let _e52 = stack_1;
    height = min(log2((_e48 / _e49)), _e52.z);
    let _e56 = height;
    let _e58 = stack_1;
    below_2 = min(floor(_e56), (_e58.z - 1f));
    let _e64 = height;
    let _e65 = below_2;
    share = (exp2((_e64 - _e65)) - 1f);
    let _e72 = below_2;
    pair = floor(((0.5f * _e72) + 0.25f));
    let _e78 = below_2;
    let _e80 = pair;
    belowIsEven = ((_e78 - (2f * _e80)) < 0.5f);
    let _e87 = belowIsEven;
    if _e87 {
        let _e88 = pair;
        local_48 = (_e88 + 1f);
    } else {
        let _e91 = pair;
        local_48 = (_e91 + 2f);
    }
    let _e95 = local_48;
    levels.even = _e95;
    let _e97 = pair;
    levels.odd = _e97;
    let _e99 = belowIsEven;
    if _e99 {
        let _e100 = share;
        local_49 = _e100;
    } else {
        let _e102 = share;
        local_49 = (1f - _e102);
    }
    let _e105 = local_49;
    levels.oddShare = _e105;
    let _e106 = levels;
    return _e106;
}

fn environmentRotate(d_14: vec3<f32>, cosAngle: f32, sinAngle: f32) -> vec3<f32> {
    var d_15: vec3<f32>;
    var cosAngle_1: f32;
    var sinAngle_1: f32;

    d_15 = d_14;
    cosAngle_1 = cosAngle;
    sinAngle_1 = sinAngle;
    let _e14 = cosAngle_1;
    let _e15 = d_15;
    let _e18 = sinAngle_1;
    let _e19 = d_15;
    let _e23 = d_15;
    let _e25 = sinAngle_1;
    let _e26 = d_15;
    let _e29 = cosAngle_1;
    let _e30 = d_15;
    return vec3<f32>(((_e14 * _e15.x) - (_e18 * _e19.z)), _e23.y, ((_e25 * _e26.x) + (_e29 * _e30.z)));
}

fn heatKernel(chord2_: f32, inverseTwiceVariance: f32) -> f32 {
    var chord2_1: f32;
    var inverseTwiceVariance_1: f32;
    var theta2_: f32;

    chord2_1 = chord2_;
    inverseTwiceVariance_1 = inverseTwiceVariance;
    let _e14 = chord2_1;
    let _e16 = chord2_1;
    let _e20 = chord2_1;
    theta2_ = (_e14 * (1f + (_e16 * (0.083333336f + (_e20 * 0.011111111f)))));
    let _e30 = theta2_;
    let _e34 = inverseTwiceVariance_1;
    return exp((_e30 * (0.083333336f - _e34)));
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
    let _e18 = block_1;
    let _e19 = size_15;
    let _e22 = x_17;
    let _e26 = size_15;
    texel_1 = ((f32((_e18 * _e19)) + (clamp(_e22, 0f, 1f) * f32((_e26 - 1i)))) + 0.5f);
    let _e35 = texel_1;
    let _e36 = size_15;
    let _e37 = blocks_1;
    return (_e35 / f32((_e36 * _e37)));
}

fn tableCoordinate(x_18: f32, size_16: i32) -> f32 {
    var x_19: f32;
    var size_17: i32;

    x_19 = x_18;
    size_17 = size_16;
    let _e14 = x_19;
    let _e15 = size_17;
    let _e18 = blockCoordinate(_e14, _e15, 0i, 1i);
    return _e18;
}

fn energyCoordinate(cosTheta_24: f32, alpha_74: f32) -> vec2<f32> {
    var cosTheta_25: f32;
    var alpha_75: f32;

    cosTheta_25 = cosTheta_24;
    alpha_75 = alpha_74;
    let _e17 = cosTheta_25;
    let _e21 = tableCoordinate(sqrt(max(_e17, 0f)), ENERGY_TABLE_SIZE);
    let _e22 = alpha_75;
    let _e26 = tableCoordinate(sqrt(max(_e22, 0f)), ENERGY_TABLE_SIZE);
    return vec2<f32>(_e21, _e26);
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
    let _e23 = cosTheta_27;
    let _e27 = tableCoordinate(sqrt(max(_e23, 0f)), LOBE_TABLE_SIZE);
    let _e28 = alpha_77;
    let _e32 = lobe_1;
    let _e33 = lobes_1;
    let _e34 = blockCoordinate(sqrt(max(_e28, 0f)), LOBE_TABLE_SIZE, _e32, _e33);
    let _e35 = edge_1;
    let _e36 = tableCoordinate(_e35, LOBE_TABLE_SLICES);
    return vec3<f32>(_e27, _e34, _e36);
}

fn lobeCoordinate(cosTheta_28: f32, alpha_78: f32, edge_2: f32) -> vec3<f32> {
    var cosTheta_29: f32;
    var alpha_79: f32;
    var edge_3: f32;

    cosTheta_29 = cosTheta_28;
    alpha_79 = alpha_78;
    edge_3 = edge_2;
    let _e21 = cosTheta_29;
    let _e22 = alpha_79;
    let _e23 = edge_3;
    let _e24 = lobeCoordinateOf(0i, 1i, _e21, _e22, _e23);
    return _e24;
}

fn lobeEnergy(texel_2: vec4<f32>) -> LobeEnergy {
    var texel_3: vec4<f32>;
    var e_1: LobeEnergy;

    texel_3 = texel_2;
    let _e17 = texel_3;
    e_1.albedo = _e17.x;
    let _e20 = texel_3;
    e_1.cos1_ = _e20.y;
    let _e23 = texel_3;
    e_1.cos2_ = _e23.z;
    let _e26 = texel_3;
    e_1.share1_ = _e26.w;
    let _e28 = e_1;
    return _e28;
}

fn lobeMean(e_2: LobeEnergy, fAtCos1_: f32, fAtCos2_: f32) -> f32 {
    var e_3: LobeEnergy;
    var fAtCos1_1: f32;
    var fAtCos2_1: f32;

    e_3 = e_2;
    fAtCos1_1 = fAtCos1_;
    fAtCos2_1 = fAtCos2_;
    let _e19 = fAtCos2_1;
    let _e20 = fAtCos1_1;
    let _e21 = e_3;
    return mix(_e19, _e20, _e21.share1_);
}

fn lobeMeanRgb(e_4: LobeEnergy, fAtCos1_2: vec3<f32>, fAtCos2_2: vec3<f32>) -> vec3<f32> {
    var e_5: LobeEnergy;
    var fAtCos1_3: vec3<f32>;
    var fAtCos2_3: vec3<f32>;

    e_5 = e_4;
    fAtCos1_3 = fAtCos1_2;
    fAtCos2_3 = fAtCos2_2;
    let _e19 = fAtCos2_3;
    let _e20 = fAtCos1_3;
    let _e21 = e_5;
    return mix(_e19, _e20, vec3(_e21.share1_));
}

fn edgeShare(f0_6: f32, mean: f32) -> f32 {
    var f0_7: f32;
    var mean_1: f32;
    var local_50: f32;

    f0_7 = f0_6;
    mean_1 = mean;
    let _e17 = mean_1;
    if (_e17 > 0f) {
        let _e21 = f0_7;
        let _e22 = mean_1;
        local_50 = clamp((1f - (_e21 / _e22)), 0f, 1f);
    } else {
        local_50 = 0f;
    }
    let _e30 = local_50;
    return _e30;
}

fn lobeDirection(r_15: vec3<f32>, n_28: vec3<f32>, lean: f32) -> vec3<f32> {
    var r_16: vec3<f32>;
    var n_29: vec3<f32>;
    var lean_1: f32;

    r_16 = r_15;
    n_29 = n_28;
    lean_1 = lean;
    let _e19 = r_16;
    let _e20 = n_29;
    let _e21 = lean_1;
    return normalize(mix(_e19, _e20, vec3(_e21)));
}

fn diffuseAngles(cosTheta_30: f32) -> vec3<f32> {
    var cosTheta_31: f32;
    var c_24: f32;

    cosTheta_31 = cosTheta_30;
    let _e15 = cosTheta_31;
    c_24 = clamp(_e15, 0f, 1f);
    let _e21 = c_24;
    let _e26 = c_24;
    let _e32 = c_24;
    return vec3<f32>(((0.2791f * _e21) + 0.266f), ((0.1798f * _e26) + 0.6974f), (0.1224f * (1f - _e32)));
}

fn stretchedParts(alpha_80: vec2<f32>) -> i32 {
    var alpha_81: vec2<f32>;
    var ratio: f32;
    var local_51: i32;
    var local_52: i32;
    var local_53: i32;

    alpha_81 = alpha_80;
    let _e15 = alpha_81;
    let _e17 = alpha_81;
    ratio = (_e15.x / max(_e17.y, 0.001f));
    let _e23 = ratio;
    if (_e23 < 1.5f) {
        local_53 = 2i;
    } else {
        let _e27 = ratio;
        if (_e27 < 3f) {
            local_52 = 4i;
        } else {
            let _e31 = ratio;
            if (_e31 < 6f) {
                local_51 = 6i;
            } else {
                local_51 = 8i;
            }
            let _e37 = local_51;
            local_52 = _e37;
        }
        let _e39 = local_52;
        local_53 = _e39;
    }
    let _e41 = local_53;
    return _e41;
}

fn stretchedEnergyAlpha(alpha_82: vec2<f32>) -> f32 {
    var alpha_83: vec2<f32>;

    alpha_83 = alpha_82;
    let _e15 = alpha_83;
    let _e17 = alpha_83;
    return sqrt((_e15.x * _e17.y));
}

fn stretchedQuantile(s_5: f32) -> f32 {
    var s_6: f32;

    s_6 = s_5;
    let _e17 = s_6;
    let _e20 = s_6;
    let _e21 = s_6;
    return (0.5f + ((0.5f * _e17) * inverseSqrt((1f + (_e20 * _e21)))));
}

fn stretchedSlope(quantile: f32) -> f32 {
    var quantile_1: f32;
    var v_24: f32;

    quantile_1 = quantile;
    let _e16 = quantile_1;
    v_24 = clamp(((2f * _e16) - 1f), -0.9999f, 0.9999f);
    let _e25 = v_24;
    let _e27 = v_24;
    let _e28 = v_24;
    return (_e25 * inverseSqrt((1f - (_e27 * _e28))));
}

fn stretchedPart(wo_50: vec3<f32>, alpha_84: vec2<f32>, k_13: i32, count: i32, shift: f32, sharpness: f32) -> StretchedPart {
    var wo_51: vec3<f32>;
    var alpha_85: vec2<f32>;
    var k_14: i32;
    var count_1: i32;
    var shift_1: f32;
    var sharpness_1: f32;
    var apart: f32;
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

    wo_51 = wo_50;
    alpha_85 = alpha_84;
    k_14 = k_13;
    count_1 = count;
    shift_1 = shift;
    sharpness_1 = sharpness;
    let _e27 = alpha_85;
    let _e29 = alpha_85;
    let _e32 = alpha_85;
    let _e34 = alpha_85;
    apart = sqrt(max(((_e27.x * _e29.x) - (_e32.y * _e34.y)), 0.000000000001f));
    let _e42 = wo_51;
    z_9 = max(_e42.z, 0.0001f);
    let _e47 = wo_51;
    let _e49 = wo_51;
    let _e52 = z_9;
    let _e53 = z_9;
    root_1 = sqrt(((_e47.x * _e49.x) + (_e52 * _e53)));
    let _e58 = root_1;
    let _e59 = wo_51;
    let _e63 = z_9;
    let _e64 = apart;
    let _e67 = stretchedQuantile((-((_e58 + _e59.x)) / (_e63 * _e64)));
    low_6 = _e67;
    let _e69 = root_1;
    let _e70 = wo_51;
    let _e73 = z_9;
    let _e74 = apart;
    let _e77 = stretchedQuantile(((_e69 - _e70.x) / (_e73 * _e74)));
    high_1 = _e77;
    let _e79 = high_1;
    let _e80 = low_6;
    let _e82 = count_1;
    spacing = ((_e79 - _e80) / f32(_e82));
    let _e86 = low_6;
    let _e87 = k_14;
    let _e91 = shift_1;
    let _e93 = spacing;
    let _e96 = stretchedSlope((_e86 + (((f32(_e87) + 0.5f) + _e91) * _e93)));
    s_7 = _e96;
    let _e98 = apart;
    let _e99 = s_7;
    slope_3 = (_e98 * _e99);
    let _e103 = slope_3;
    let _e104 = slope_3;
    lean_2 = (1f + (_e103 * _e104));
    let _e110 = slope_3;
    let _e115 = lean_2;
    part.n = (vec3<f32>(-(_e110), 0f, 1f) * inverseSqrt(_e115));
    let _e118 = alpha_85;
    let _e121 = alpha_85;
    let _e125 = slope_3;
    let _e126 = slope_3;
    let _e128 = alpha_85;
    let _e130 = alpha_85;
    let _e136 = lean_2;
    across2_ = ((((STRETCHED_ACROSS * _e118.y) * _e121.y) * (1f + ((_e125 * _e126) / (_e128.x * _e130.x)))) / _e136);
    let _e139 = sharpness_1;
    let _e140 = apart;
    let _e145 = s_7;
    let _e146 = s_7;
    let _e151 = s_7;
    let _e152 = s_7;
    let _e157 = spacing;
    let _e159 = lean_2;
    along_5 = ((((((_e139 * _e140) * 2f) * (1f + (_e145 * _e146))) * sqrt((1f + (_e151 * _e152)))) * _e157) / _e159);
    let _e163 = across2_;
    let _e164 = along_5;
    let _e166 = along_5;
    part.alpha = min(sqrt((_e163 + ((STRETCHED_ALONG * _e164) * _e166))), 1f);
    let _e172 = wo_51;
    let _e173 = part;
    c_25 = dot(_e172, _e173.n);
    let _e178 = c_25;
    let _e180 = part;
    let _e183 = wo_51;
    wi_42 = (((2f * _e178) * _e180.n) - _e183);
    let _e187 = z_9;
    let _e188 = z_9;
    let _e189 = z_9;
    let _e191 = apart;
    let _e192 = apart;
    let _e194 = wo_51;
    let _e197 = wo_51;
    visible = (0.5f * (_e187 + sqrt(((_e188 * _e189) + (((_e191 * _e192) * _e194.x) * _e197.x)))));
    let _e206 = spacing;
    let _e207 = c_25;
    let _e211 = part;
    let _e214 = visible;
    let _e217 = wi_42;
    let _e218 = alpha_85;
    let _e219 = ggxAnisoG1(_e217, _e218);
    part.weight = (((_e206 * max(_e207, 0f)) / (_e211.n.z * _e214)) * _e219);
    let _e221 = part;
    return _e221;
}

fn stretchedAlbedo(wo_52: vec3<f32>, alpha_86: vec2<f32>) -> f32 {
    var wo_53: vec3<f32>;
    var alpha_87: vec2<f32>;
    var sum_12: f32 = 0f;
    var k_15: i32 = 0i;
    var part_1: StretchedPart;

    wo_53 = wo_52;
    alpha_87 = alpha_86;
    loop {
        let _e23 = k_15;
        if !((_e23 < 8i)) {
            break;
        }
        {
            let _e30 = wo_53;
            let _e31 = alpha_87;
            let _e32 = k_15;
            let _e36 = stretchedPart(_e30, _e31, _e32, 8i, 0f, 1f);
            part_1 = _e36;
            let _e38 = sum_12;
            let _e39 = part_1;
            sum_12 = (_e38 + _e39.weight);
        }
        continuing {
            let _e27 = k_15;
            k_15 = (_e27 + 1i);
        }
    }
    let _e42 = sum_12;
    return min(_e42, 1f);
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
    let _e19 = sin2_7;
    within_1 = min(_e19, 0.999f);
    let _e23 = cosTheta_33;
    c_26 = clamp(_e23, -1f, 1f);
    let _e29 = c_26;
    let _e30 = c_26;
    let _e32 = within_1;
    if ((_e29 * _e30) >= _e32) {
        let _e34 = within_1;
        let _e35 = c_26;
        return (_e34 * max(_e35, 0f));
    }
    let _e40 = c_26;
    let _e41 = c_26;
    sinTheta = sqrt((1f - (_e40 * _e41)));
    let _e47 = within_1;
    cot = sqrt(((1f / max(_e47, 0.000000000001f)) - 1f));
    let _e55 = cot;
    let _e57 = c_26;
    let _e59 = sinTheta;
    y_10 = clamp(((-(_e55) * _e57) / _e59), -1f, 1f);
    let _e66 = sinTheta;
    let _e68 = y_10;
    let _e69 = y_10;
    chord = (_e66 * sqrt((1f - (_e68 * _e69))));
    let _e75 = c_26;
    let _e76 = y_10;
    let _e79 = cot;
    let _e80 = chord;
    let _e83 = within_1;
    let _e85 = chord;
    let _e86 = cot;
    return clamp((((((_e75 * acos(_e76)) - (_e79 * _e80)) * _e83) + atan((_e85 / _e86))) / 3.1415927f), 0f, 1f);
}

fn sphereFormFactor(centre: vec3<f32>, radius: f32, n_30: vec3<f32>) -> f32 {
    var centre_1: vec3<f32>;
    var radius_1: f32;
    var n_31: vec3<f32>;
    var range2_: f32;

    centre_1 = centre;
    radius_1 = radius;
    n_31 = n_30;
    let _e21 = centre_1;
    let _e22 = centre_1;
    range2_ = dot(_e21, _e22);
    let _e25 = range2_;
    if !((_e25 > 0f)) {
        return 0f;
    }
    let _e30 = centre_1;
    let _e31 = n_31;
    let _e33 = range2_;
    let _e36 = radius_1;
    let _e37 = radius_1;
    let _e39 = range2_;
    let _e41 = capFormFactor((dot(_e30, _e31) * inverseSqrt(_e33)), ((_e36 * _e37) / _e39));
    return _e41;
}

fn edgeVector(a_27: vec3<f32>, b_19: vec3<f32>) -> vec3<f32> {
    var a_28: vec3<f32>;
    var b_20: vec3<f32>;
    var across_9: vec3<f32>;
    var sine: f32;
    var local_54: vec3<f32>;

    a_28 = a_27;
    b_20 = b_19;
    let _e19 = a_28;
    let _e20 = b_20;
    across_9 = cross(_e19, _e20);
    let _e23 = across_9;
    sine = length(_e23);
    let _e26 = sine;
    if (_e26 > 0.0000001f) {
        let _e29 = across_9;
        let _e30 = sine;
        let _e31 = a_28;
        let _e32 = b_20;
        let _e35 = sine;
        local_54 = (_e29 * (atan2(_e30, dot(_e31, _e32)) / _e35));
    } else {
        let _e38 = across_9;
        local_54 = _e38;
    }
    let _e40 = local_54;
    return _e40;
}

fn rectangleVector(centre_2: vec3<f32>, u_11: vec3<f32>, v_25: vec3<f32>) -> vec3<f32> {
    var centre_3: vec3<f32>;
    var u_12: vec3<f32>;
    var v_26: vec3<f32>;
    var a_29: vec3<f32>;
    var b_21: vec3<f32>;
    var c_27: vec3<f32>;
    var d_16: vec3<f32>;
    var sum_13: vec3<f32>;
    var local_55: f32;
    var turned: f32;

    centre_3 = centre_2;
    u_12 = u_11;
    v_26 = v_25;
    let _e21 = centre_3;
    let _e22 = u_12;
    let _e24 = v_26;
    a_29 = normalize(((_e21 - _e22) - _e24));
    let _e28 = centre_3;
    let _e29 = u_12;
    let _e31 = v_26;
    b_21 = normalize(((_e28 + _e29) - _e31));
    let _e35 = centre_3;
    let _e36 = u_12;
    let _e38 = v_26;
    c_27 = normalize(((_e35 + _e36) + _e38));
    let _e42 = centre_3;
    let _e43 = u_12;
    let _e45 = v_26;
    d_16 = normalize(((_e42 - _e43) + _e45));
    let _e49 = a_29;
    let _e50 = b_21;
    let _e51 = edgeVector(_e49, _e50);
    let _e52 = b_21;
    let _e53 = c_27;
    let _e54 = edgeVector(_e52, _e53);
    let _e56 = c_27;
    let _e57 = d_16;
    let _e58 = edgeVector(_e56, _e57);
    let _e60 = d_16;
    let _e61 = a_29;
    let _e62 = edgeVector(_e60, _e61);
    sum_13 = (((_e51 + _e54) + _e58) + _e62);
    let _e65 = u_12;
    let _e66 = v_26;
    let _e68 = centre_3;
    if (dot(cross(_e65, _e66), _e68) < 0f) {
        local_55 = -1f;
    } else {
        local_55 = 1f;
    }
    let _e76 = local_55;
    turned = _e76;
    let _e78 = sum_13;
    let _e79 = turned;
    return (_e78 * (_e79 / 6.2831855f));
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
    let _e23 = centre_5;
    let _e24 = u_14;
    let _e25 = v_28;
    let _e26 = rectangleVector(_e23, _e24, _e25);
    f_37 = _e26;
    let _e28 = f_37;
    size_18 = length(_e28);
    let _e31 = size_18;
    if (_e31 > 0f) {
        let _e34 = f_37;
        let _e35 = n_33;
        let _e37 = size_18;
        let _e39 = size_18;
        let _e40 = capFormFactor((dot(_e34, _e35) / _e37), _e39);
        local_56 = _e40;
    } else {
        local_56 = 0f;
    }
    let _e43 = local_56;
    return _e43;
}

fn noShare(direction: vec3<f32>) -> LobeShare {
    var direction_1: vec3<f32>;
    var s_8: LobeShare;

    direction_1 = direction;
    s_8.share = 0f;
    let _e22 = direction_1;
    s_8.direction = _e22;
    s_8.sigma = 0f;
    s_8.distance = 0f;
    let _e28 = direction_1;
    s_8.n = -(_e28);
    let _e30 = s_8;
    return _e30;
}

fn lobeIntegral(x_20: f32) -> f32 {
    var x_21: f32;
    var t_24: f32;

    x_21 = x_20;
    let _e18 = x_21;
    t_24 = clamp(_e18, -6f, 6f);
    let _e26 = t_24;
    let _e30 = t_24;
    let _e32 = t_24;
    return (1f / (1f + exp((-(_e26) * (1.595769f + ((0.0715628f * _e30) * _e32))))));
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
    var side_3: f32;
    var across_10: f32;

    centre_7 = centre_6;
    radius_3 = radius_2;
    direction_3 = direction_2;
    sigma_3 = sigma_2;
    let _e24 = sigma_3;
    s_9 = clamp(_e24, LEAST_LOBE, 0.65f);
    let _e28 = centre_7;
    range_1 = length(_e28);
    let _e31 = range_1;
    let _e33 = radius_3;
    if !((_e31 > (0.8f * _e33))) {
        let _e37 = direction_3;
        let _e38 = noShare(_e37);
        return _e38;
    }
    let _e39 = centre_7;
    let _e40 = range_1;
    axis = (_e39 / vec3(_e40));
    let _e44 = radius_3;
    let _e45 = range_1;
    sinRho = clamp((_e44 / _e45), 0.000001f, 0.999f);
    let _e51 = sinRho;
    rho = asin(_e51);
    let _e56 = direction_3;
    let _e57 = axis;
    theta = (2f * asin(min((0.5f * length((_e56 - _e57))), 1f)));
    let _e66 = direction_3;
    let _e67 = noShare(_e66);
    found = _e67;
    let _e69 = theta;
    let _e70 = rho;
    let _e72 = s_9;
    if (_e69 > (_e70 + (4f * _e72))) {
        let _e76 = found;
        return _e76;
    }
    let _e77 = rho;
    let _e78 = rho;
    let _e80 = s_9;
    let _e81 = s_9;
    u2_ = ((_e77 * _e78) / (_e80 * _e81));
    let _e86 = rho;
    let _e89 = sinRho;
    let _e90 = sinRho;
    let _e95 = sinRho;
    curved = (((0.9f * _e86) * sqrt((1f - (_e89 * _e90)))) / _e95);
    let _e98 = rho;
    let _e99 = u2_;
    let _e102 = u2_;
    let _e105 = curved;
    let _e110 = s_9;
    reach = ((_e98 * sqrt(((_e99 + 1f) / ((_e102 + 1f) + _e105)))) / _e110);
    let _e114 = reach;
    let _e115 = lobeIntegral(_e114);
    middle_1 = max(((2f * _e115) - 1f), 0.000001f);
    let _e122 = reach;
    let _e123 = theta;
    let _e124 = s_9;
    let _e127 = lobeIntegral((_e122 - (_e123 / _e124)));
    let _e128 = reach;
    let _e130 = theta;
    let _e131 = s_9;
    let _e134 = lobeIntegral((-(_e128) - (_e130 / _e131)));
    beside_1 = (_e127 - _e134);
    let _e141 = u2_;
    let _e145 = beside_1;
    let _e146 = middle_1;
    let _e154 = range_1;
    let _e155 = radius_3;
    found.share = (((1f - exp((-0.5f * _e141))) * clamp((_e145 / _e146), 0f, 1f)) * smoothstep(0.8f, 1f, (_e154 / _e155)));
    let _e160 = rho;
    let _e162 = rho;
    disc = ((0.25f * _e160) * _e162);
    let _e165 = theta;
    let _e166 = disc;
    let _e168 = disc;
    let _e169 = s_9;
    let _e170 = s_9;
    let _e175 = rho;
    off = min(((_e165 * _e166) / (_e168 + (_e169 * _e170))), (0.98f * _e175));
    let _e179 = direction_3;
    let _e180 = direction_3;
    let _e181 = axis;
    let _e183 = axis;
    towards = (_e179 - (dot(_e180, _e181) * _e183));
    let _e187 = towards;
    side_3 = length(_e187);
    let _e190 = side_3;
    if (_e190 > 0.000001f) {
        let _e194 = off;
        let _e196 = axis;
        let _e198 = off;
        let _e200 = side_3;
        let _e202 = towards;
        found.direction = ((cos(_e194) * _e196) + ((sin(_e198) / _e200) * _e202));
    }
    let _e205 = range_1;
    let _e206 = off;
    across_10 = (_e205 * sin(_e206));
    let _e211 = range_1;
    let _e212 = off;
    let _e215 = radius_3;
    let _e216 = radius_3;
    let _e218 = across_10;
    let _e219 = across_10;
    found.distance = max(((_e211 * cos(_e212)) - sqrt(max(((_e215 * _e216) - (_e218 * _e219)), 0f))), 0f);
    let _e229 = found;
    let _e231 = found;
    let _e234 = centre_7;
    found.n = normalize(((_e229.distance * _e231.direction) - _e234));
    let _e238 = s_9;
    let _e240 = rho;
    found.sigma = min(_e238, (0.5f * _e240));
    let _e243 = found;
    return _e243;
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
    let _e32 = edge_5;
    let _e33 = edge_5;
    let _e34 = edge_5;
    inward = (_e32 * inverseSqrt(max(dot(_e33, _e34), 0.000000000000000000000000000001f)));
    let _e41 = below_4;
    let _e42 = inward;
    let _e43 = along_7;
    let _e46 = s_11;
    let _e47 = inward;
    let _e48 = beside_3;
    width_3 = vec2<f32>((_e41 * dot(_e42, _e43)), (_e46 * dot(_e47, _e48)));
    let _e53 = inward;
    let _e54 = direction_5;
    let _e56 = width_3;
    let _e61 = lobeIntegral((dot(_e53, _e54) / max(length(_e56), 0.0001f)));
    share_1 = _e61;
    let _e63 = share_1;
    let _e65 = horizon_1;
    let _e66 = inward;
    let _e67 = n_35;
    return min((_e63 / mix(1f, _e65, clamp(-(dot(_e66, _e67)), 0f, 1f))), 1f);
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
    let _e26 = sigma_5;
    s_12 = clamp(_e26, LEAST_LOBE, 0.65f);
    let _e30 = direction_7;
    let _e31 = noShare(_e30);
    found_1 = _e31;
    let _e33 = u_16;
    let _e34 = v_30;
    n_36 = normalize(cross(_e33, _e34));
    let _e38 = n_36;
    let _e39 = centre_9;
    if (dot(_e38, _e39) > 0f) {
        local_57 = -1f;
    } else {
        local_57 = 1f;
    }
    let _e47 = local_57;
    facing = _e47;
    let _e49 = n_36;
    let _e50 = facing;
    n_36 = (_e49 * _e50);
    let _e52 = centre_9;
    let _e53 = n_36;
    height_1 = -(dot(_e52, _e53));
    let _e57 = direction_7;
    let _e58 = n_36;
    sinDown = clamp(-(dot(_e57, _e58)), -1f, 1f);
    let _e66 = sinDown;
    let _e68 = s_12;
    z_10 = (asin(_e66) / _e68);
    let _e71 = height_1;
    let _e73 = centre_9;
    let _e78 = z_10;
    if (!((_e71 > (0.00001f * length(_e73)))) || (_e78 < -4f)) {
        let _e83 = found_1;
        return _e83;
    }
    let _e84 = z_10;
    let _e85 = lobeIntegral(_e84);
    below_5 = _e85;
    let _e90 = z_10;
    let _e92 = z_10;
    let _e96 = below_5;
    shift_2 = ((0.3989423f * exp(((-0.5f * _e90) * _e92))) / _e96);
    let _e99 = sinDown;
    let _e101 = s_12;
    let _e102 = shift_2;
    down = clamp((asin(_e99) + (_e101 * _e102)), 0.02f, 1.5707963f);
    let _e109 = s_12;
    let _e111 = z_10;
    let _e112 = shift_2;
    let _e115 = shift_2;
    let _e116 = shift_2;
    width_4 = (_e109 * sqrt(max(((1f - (_e111 * _e112)) - (_e115 * _e116)), 0.05f)));
    let _e124 = direction_7;
    let _e125 = sinDown;
    let _e126 = n_36;
    level = (_e124 + (_e125 * _e126));
    let _e130 = level;
    let _e131 = level;
    if (dot(_e130, _e131) > 0.00000001f) {
        let _e135 = level;
        local_58 = normalize(_e135);
    } else {
        let _e137 = u_16;
        local_58 = normalize(_e137);
    }
    let _e140 = local_58;
    level = _e140;
    let _e141 = down;
    let _e143 = level;
    let _e145 = down;
    let _e147 = n_36;
    middle_2 = ((cos(_e141) * _e143) - (sin(_e145) * _e147));
    let _e151 = down;
    let _e154 = level;
    let _e156 = down;
    let _e158 = n_36;
    along_8 = ((-(sin(_e151)) * _e154) - (cos(_e156) * _e158));
    let _e162 = level;
    let _e163 = n_36;
    beside_4 = cross(_e162, _e163);
    let _e166 = down;
    let _e168 = width_4;
    let _e170 = lobeIntegral((sin(_e166) / _e168));
    horizon_2 = _e170;
    let _e172 = facing;
    let _e173 = u_16;
    a_30 = (_e172 * _e173);
    let _e176 = centre_9;
    let _e177 = u_16;
    let _e179 = facing;
    let _e180 = v_30;
    let _e184 = middle_2;
    let _e185 = along_8;
    let _e186 = beside_4;
    let _e187 = width_4;
    let _e188 = s_12;
    let _e189 = n_36;
    let _e190 = horizon_2;
    let _e191 = withinEdge(-(cross((_e176 + _e177), (_e179 * _e180))), _e184, _e185, _e186, _e187, _e188, _e189, _e190);
    right = _e191;
    let _e193 = centre_9;
    let _e194 = u_16;
    let _e196 = facing;
    let _e197 = v_30;
    let _e200 = middle_2;
    let _e201 = along_8;
    let _e202 = beside_4;
    let _e203 = width_4;
    let _e204 = s_12;
    let _e205 = n_36;
    let _e206 = horizon_2;
    let _e207 = withinEdge(cross((_e193 - _e194), (_e196 * _e197)), _e200, _e201, _e202, _e203, _e204, _e205, _e206);
    left_1 = _e207;
    let _e209 = centre_9;
    let _e210 = v_30;
    let _e212 = a_30;
    let _e214 = middle_2;
    let _e215 = along_8;
    let _e216 = beside_4;
    let _e217 = width_4;
    let _e218 = s_12;
    let _e219 = n_36;
    let _e220 = horizon_2;
    let _e221 = withinEdge(cross((_e209 + _e210), _e212), _e214, _e215, _e216, _e217, _e218, _e219, _e220);
    upper = _e221;
    let _e223 = centre_9;
    let _e224 = v_30;
    let _e226 = a_30;
    let _e229 = middle_2;
    let _e230 = along_8;
    let _e231 = beside_4;
    let _e232 = width_4;
    let _e233 = s_12;
    let _e234 = n_36;
    let _e235 = horizon_2;
    let _e236 = withinEdge(-(cross((_e223 - _e224), _e226)), _e229, _e230, _e231, _e232, _e233, _e234, _e235);
    lower = _e236;
    let _e239 = below_5;
    let _e240 = right;
    let _e241 = left_1;
    let _e248 = upper;
    let _e249 = lower;
    found_1.share = ((_e239 * max(((_e240 + _e241) - 1f), 0f)) * max(((_e248 + _e249) - 1f), 0f));
    let _e256 = height_1;
    let _e257 = down;
    let _e260 = middle_2;
    let _e262 = centre_9;
    at = (((_e256 / sin(_e257)) * _e260) - _e262);
    let _e265 = centre_9;
    let _e266 = at;
    let _e267 = u_16;
    let _e269 = u_16;
    let _e270 = u_16;
    let _e277 = u_16;
    let _e280 = at;
    let _e281 = v_30;
    let _e283 = v_30;
    let _e284 = v_30;
    let _e291 = v_30;
    met = ((_e265 + (clamp((dot(_e266, _e267) / dot(_e269, _e270)), -1f, 1f) * _e277)) + (clamp((dot(_e280, _e281) / dot(_e283, _e284)), -1f, 1f) * _e291));
    let _e296 = met;
    found_1.distance = length(_e296);
    let _e299 = met;
    let _e300 = found_1;
    found_1.direction = (_e299 / vec3(max(_e300.distance, 0.000000000000000000000000000001f)));
    let _e307 = n_36;
    found_1.n = _e307;
    let _e309 = width_4;
    found_1.sigma = min(_e309, 0.4f);
    let _e312 = found_1;
    return _e312;
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
    let _e22 = wo_55;
    let _e23 = n_38;
    c_28 = clamp(dot(_e22, _e23), 0f, 1f);
    let _e30 = wo_55;
    let _e31 = n_38;
    let _e34 = n_38;
    let _e36 = wo_55;
    mirror = (((2f * dot(_e30, _e31)) * _e34) - _e36);
    let _e41 = mirror;
    let _e42 = n_38;
    let _e43 = alpha_89;
    let _e46 = c_28;
    let _e49 = alpha_89;
    lobe_2.direction = normalize(mix(_e41, _e42, vec3((_e43 * (1f + ((1f - _e46) * (1f - _e49)))))));
    let _e58 = alpha_89;
    narrow = (1.9f * _e58);
    let _e62 = narrow;
    let _e64 = narrow;
    let _e65 = narrow;
    lobe_2.sigma = (_e62 * inverseSqrt((1f + ((_e64 * _e65) / 0.5476f))));
    let _e75 = alpha_89;
    normal = (1f / (1f + (2.26f * pow(_e75, 2.3f))));
    let _e84 = alpha_89;
    grazing = (0.9f - (0.34f * _e84));
    let _e89 = alpha_89;
    let _e92 = alpha_89;
    square_2 = ((1f - _e89) * (1f - _e92));
    let _e96 = alpha_89;
    if (_e96 > 0f) {
        let _e100 = c_28;
        let _e104 = square_2;
        let _e106 = square_2;
        local_59 = pow((1f - _e100), (1.5f + ((4f * _e104) * _e106)));
    } else {
        local_59 = 0f;
    }
    let _e112 = local_59;
    edge_6 = _e112;
    let _e115 = normal;
    let _e116 = grazing;
    let _e117 = edge_6;
    lobe_2.albedo = mix(_e115, _e116, _e117);
    let _e119 = lobe_2;
    return _e119;
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
    let _e24 = cosTheta_35;
    let _e29 = alpha_91;
    c_29 = mix(clamp(_e24, 0f, 1f), 0.65f, sqrt(_e29));
    let _e34 = c_29;
    x_22 = (1f - _e34);
    let _e37 = x_22;
    let _e38 = x_22;
    x2_ = (_e37 * _e38);
    let _e41 = f0_9;
    let _e42 = f90_1;
    let _e44 = f0_9;
    let _e46 = x2_;
    let _e47 = x2_;
    let _e49 = x_22;
    return (_e41 + ((vec3(_e42) - _e44) * ((_e46 * _e47) * _e49)));
}

fn wideningGgx(lobes_2: i32) -> Widening {
    var lobes_3: i32;
    var k_16: Widening;
    var local_60: f32;
    var local_61: f32;
    var local_62: f32;

    lobes_3 = lobes_2;
    let _e20 = lobes_3;
    if (_e20 > 1i) {
        local_60 = 0.7f;
    } else {
        local_60 = 0.6f;
    }
    let _e26 = local_60;
    k_16.shape = _e26;
    let _e28 = lobes_3;
    if (_e28 > 1i) {
        local_61 = 0.91f;
    } else {
        local_61 = 0.6f;
    }
    let _e34 = local_61;
    k_16.shapeRays = _e34;
    let _e36 = lobes_3;
    if (_e36 > 1i) {
        local_62 = 1.05f;
    } else {
        local_62 = 0.95f;
    }
    let _e42 = local_62;
    k_16.energyCore = _e42;
    k_16.energyTail = 0.85f;
    let _e45 = k_16;
    return _e45;
}

fn wideningBeckmann(lobes_4: i32) -> Widening {
    var lobes_5: i32;
    var k_17: Widening;
    var local_63: f32;
    var local_64: f32;
    var local_65: f32;

    lobes_5 = lobes_4;
    let _e20 = lobes_5;
    if (_e20 > 1i) {
        local_63 = 1f;
    } else {
        local_63 = 1.2f;
    }
    let _e26 = local_63;
    k_17.shape = _e26;
    let _e28 = lobes_5;
    if (_e28 > 1i) {
        local_64 = 1.3f;
    } else {
        local_64 = 1.2f;
    }
    let _e34 = local_64;
    k_17.shapeRays = _e34;
    let _e36 = lobes_5;
    if (_e36 > 1i) {
        local_65 = 1.3f;
    } else {
        local_65 = 1.5f;
    }
    let _e42 = local_65;
    k_17.energyCore = _e42;
    k_17.energyTail = 1.6f;
    let _e45 = k_17;
    return _e45;
}

fn exitTurn(cosTheta_36: f32, pathLength: f32, curvature: vec2<f32>) -> vec2<f32> {
    var cosTheta_37: f32;
    var pathLength_1: f32;
    var curvature_1: vec2<f32>;
    var turn: vec2<f32>;

    cosTheta_37 = cosTheta_36;
    pathLength_1 = pathLength;
    curvature_1 = curvature;
    let _e22 = pathLength_1;
    let _e23 = curvature_1;
    let _e26 = cosTheta_37;
    let _e30 = pathLength_1;
    let _e31 = curvature_1;
    turn = vec2<f32>(((_e22 * _e23.x) / max(_e26, 0.000001f)), (_e30 * _e31.y));
    let _e36 = turn;
    return clamp(_e36, vec2(-8f), vec2(8f));
}

fn sphereTurn(cosTheta_38: f32) -> vec2<f32> {
    var cosTheta_39: f32;

    cosTheta_39 = cosTheta_38;
    let _e20 = cosTheta_39;
    return vec2<f32>(2f, (2f * _e20));
}

fn seeExit(inner: InnerLobe, core: bool, s_13: ExitSurface, k_18: Widening) -> ExitView {
    var inner_1: InnerLobe;
    var core_1: bool;
    var s_14: ExitSurface;
    var k_19: Widening;
    var v_31: ExitView;
    var local_66: f32;
    var alpha2_: f32;
    var spread_3: f32;
    var spread2_: f32;
    var rays2_: f32;
    var local_67: f32;
    var rays: f32;
    var shape_1: f32;
    var shape2_: f32;
    var local_68: f32;
    var energy: f32;
    var local_69: f32;

    inner_1 = inner;
    core_1 = core;
    s_14 = s_13;
    k_19 = k_18;
    let _e27 = inner_1;
    let _e29 = s_14;
    v_31.cosTheta = min(dot(_e27.direction, _e29.n), 1f);
    let _e36 = s_14;
    v_31.swing = (1f - _e36.turn.x);
    let _e41 = v_31;
    if (_e41.swing < 0f) {
        let _e45 = v_31;
        local_66 = min(_e45.swing, -0.05f);
    } else {
        let _e50 = v_31;
        local_66 = max(_e50.swing, LEAST_SWING);
    }
    let _e54 = local_66;
    v_31.swing = _e54;
    let _e55 = s_14;
    let _e57 = s_14;
    alpha2_ = (_e55.alpha * _e57.alpha);
    let _e61 = inner_1;
    let _e63 = v_31;
    spread_3 = (_e61.sigma * _e63.swing);
    let _e67 = spread_3;
    let _e68 = spread_3;
    spread2_ = (_e67 * _e68);
    let _e71 = k_19;
    let _e73 = k_19;
    let _e76 = spread2_;
    rays2_ = ((_e71.shape * _e73.shape) * _e76);
    let _e79 = rays2_;
    if (_e79 > 0f) {
        let _e82 = rays2_;
        let _e83 = alpha2_;
        let _e84 = rays2_;
        local_67 = (_e82 / (_e83 + _e84));
    } else {
        local_67 = 0f;
    }
    let _e89 = local_67;
    rays = _e89;
    let _e91 = k_19;
    let _e93 = k_19;
    let _e95 = rays;
    shape_1 = mix(_e91.shape, _e93.shapeRays, _e95);
    let _e98 = alpha2_;
    let _e99 = shape_1;
    let _e100 = shape_1;
    let _e102 = spread2_;
    shape2_ = (_e98 + ((_e99 * _e100) * _e102));
    let _e106 = core_1;
    if _e106 {
        let _e107 = k_19;
        local_68 = _e107.energyCore;
    } else {
        let _e109 = k_19;
        local_68 = _e109.energyTail;
    }
    let _e112 = local_68;
    energy = _e112;
    let _e115 = shape2_;
    v_31.alphaShape = min(sqrt(_e115), 1f);
    let _e120 = alpha2_;
    let _e121 = energy;
    let _e122 = energy;
    let _e124 = spread2_;
    v_31.alphaEnergy = min(sqrt((_e120 + ((_e121 * _e122) * _e124))), 1f);
    let _e131 = shape2_;
    if (_e131 > 0f) {
        let _e134 = alpha2_;
        let _e135 = shape2_;
        local_69 = (_e134 / _e135);
    } else {
        local_69 = 1f;
    }
    let _e139 = local_69;
    v_31.own = _e139;
    let _e140 = v_31;
    return _e140;
}

fn leavingNextAlpha(innerSigma: f32, alpha_92: f32, nextAlpha: f32) -> f32 {
    var innerSigma_1: f32;
    var alpha_93: f32;
    var nextAlpha_1: f32;
    var spread_4: f32;

    innerSigma_1 = innerSigma;
    alpha_93 = alpha_92;
    nextAlpha_1 = nextAlpha;
    let _e25 = innerSigma_1;
    spread_4 = (1.3f * _e25);
    let _e28 = nextAlpha_1;
    let _e29 = nextAlpha_1;
    let _e32 = alpha_93;
    let _e34 = alpha_93;
    let _e37 = spread_4;
    let _e38 = spread_4;
    return min(sqrt((((_e28 * _e29) + ((3f * _e32) * _e34)) + (_e37 * _e38))), 1f);
}

fn convexExit(n_39: vec3<f32>, direction_8: vec3<f32>, body: ConvexBody) -> ConvexExit {
    var n_40: vec3<f32>;
    var direction_9: vec3<f32>;
    var body_1: ConvexBody;
    var q_1: f32;
    var c_30: f32;
    var a_31: f32;
    var root_2: f32;
    var local_70: f32;
    var scaled: f32;
    var e_6: ConvexExit;
    var local_71: f32;
    var curvature_2: f32;

    n_40 = n_39;
    direction_9 = direction_8;
    body_1 = body;
    let _e24 = body_1;
    let _e26 = body_1;
    q_1 = clamp((_e24.thickness * _e26.curvature), 0f, 2f);
    let _e33 = n_40;
    let _e34 = direction_9;
    c_30 = max(-(dot(_e33, _e34)), 0.05f);
    let _e41 = q_1;
    let _e43 = c_30;
    a_31 = ((1f - _e41) * _e43);
    let _e46 = a_31;
    let _e47 = a_31;
    let _e49 = q_1;
    let _e51 = q_1;
    root_2 = sqrt(((_e46 * _e47) + (_e49 * (2f - _e51))));
    let _e57 = q_1;
    if (_e57 < 1f) {
        let _e61 = q_1;
        let _e63 = a_31;
        let _e64 = root_2;
        local_70 = ((2f - _e61) / (_e63 + _e64));
    } else {
        let _e67 = root_2;
        let _e68 = a_31;
        let _e70 = q_1;
        local_70 = ((_e67 - _e68) / _e70);
    }
    let _e73 = local_70;
    scaled = _e73;
    let _e77 = scaled;
    let _e78 = body_1;
    e_6.path = (_e77 * _e78.thickness);
    let _e83 = q_1;
    let _e86 = n_40;
    let _e88 = q_1;
    let _e89 = scaled;
    let _e91 = direction_9;
    e_6.surface.n = normalize((((_e83 - 1f) * _e86) + ((_e88 * _e89) * _e91)));
    let _e97 = body_1;
    e_6.surface.alpha = _e97.backAlpha;
    let _e102 = body_1;
    e_6.surface.eta = (1f / _e102.ior);
    let _e105 = body_1;
    if (_e105.thickness > 0f) {
        let _e109 = q_1;
        let _e110 = body_1;
        local_71 = (_e109 / _e110.thickness);
    } else {
        local_71 = 0f;
    }
    let _e115 = local_71;
    curvature_2 = _e115;
    let _e119 = direction_9;
    let _e120 = e_6;
    let _e124 = e_6;
    let _e126 = curvature_2;
    let _e128 = exitTurn(dot(_e119, _e120.surface.n), _e124.path, vec2(_e126));
    e_6.surface.turn = _e128;
    let _e129 = e_6;
    return _e129;
}

fn signNotZero(x_23: f32) -> f32 {
    var x_24: f32;
    var local_72: f32;

    x_24 = x_23;
    let _e20 = x_24;
    if (_e20 < 0f) {
        local_72 = -1f;
    } else {
        local_72 = 1f;
    }
    let _e27 = local_72;
    return _e27;
}

fn octEncode(n_41: vec3<f32>) -> vec2<f32> {
    var n_42: vec3<f32>;
    var s_15: f32;
    var p_3: vec2<f32>;

    n_42 = n_41;
    let _e21 = n_42;
    let _e24 = n_42;
    let _e28 = n_42;
    s_15 = (1f / ((abs(_e21.x) + abs(_e24.y)) + abs(_e28.z)));
    let _e34 = n_42;
    let _e36 = s_15;
    let _e38 = n_42;
    let _e40 = s_15;
    p_3 = vec2<f32>((_e34.x * _e36), (_e38.y * _e40));
    let _e44 = n_42;
    if (_e44.z >= 0f) {
        let _e48 = p_3;
        return _e48;
    }
    let _e50 = p_3;
    let _e54 = p_3;
    let _e56 = signNotZero(_e54.x);
    let _e59 = p_3;
    let _e63 = p_3;
    let _e65 = signNotZero(_e63.y);
    return vec2<f32>(((1f - abs(_e50.y)) * _e56), ((1f - abs(_e59.x)) * _e65));
}

fn octDecode(p_4: vec2<f32>) -> vec3<f32> {
    var p_5: vec2<f32>;
    var z_11: f32;
    var fold: f32;

    p_5 = p_4;
    let _e21 = p_5;
    let _e25 = p_5;
    z_11 = ((1f - abs(_e21.x)) - abs(_e25.y));
    let _e30 = z_11;
    fold = max(-(_e30), 0f);
    let _e35 = p_5;
    let _e37 = fold;
    let _e38 = p_5;
    let _e40 = signNotZero(_e38.x);
    let _e43 = p_5;
    let _e45 = fold;
    let _e46 = p_5;
    let _e48 = signNotZero(_e46.y);
    let _e51 = z_11;
    return normalize(vec3<f32>((_e35.x - (_e37 * _e40)), (_e43.y - (_e45 * _e48)), _e51));
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
    var local_73: vec3<f32>;
    var v_32: vec3<f32>;

    clipFromWorld_1 = clipFromWorld;
    worldFromClip_1 = worldFromClip;
    size_20 = size_19;
    let _e26 = clipFromWorld_1;
    view.clipFromWorld = _e26;
    let _e28 = worldFromClip_1;
    view.worldFromClip = _e28;
    let _e30 = size_20;
    view.size = _e30;
    let _e35 = clipFromWorld_1[0][0];
    let _e40 = clipFromWorld_1[1][0];
    let _e45 = clipFromWorld_1[2][0];
    right_1 = vec3<f32>(_e35, _e40, _e45);
    let _e52 = clipFromWorld_1[0][2];
    let _e57 = clipFromWorld_1[1][2];
    let _e62 = clipFromWorld_1[2][2];
    depth = vec3<f32>(_e52, _e57, _e62);
    let _e69 = clipFromWorld_1[0][3];
    let _e74 = clipFromWorld_1[1][3];
    let _e79 = clipFromWorld_1[2][3];
    w_22 = vec3<f32>(_e69, _e74, _e79);
    let _e84 = size_20;
    let _e86 = right_1;
    view.texelWidth = (2f / (_e84.x * length(_e86)));
    let _e90 = w_22;
    let _e91 = w_22;
    perspective = (dot(_e90, _e91) > 0f);
    let _e96 = perspective;
    if _e96 {
        let _e97 = w_22;
        local_73 = normalize(_e97);
    } else {
        let _e99 = depth;
        local_73 = -(normalize(_e99));
    }
    let _e103 = local_73;
    v_32 = _e103;
    let _e106 = view;
    let _e108 = depth;
    let _e109 = v_32;
    let _e112 = w_22;
    let _e113 = v_32;
    view.texelDepth = (_e106.texelWidth * vec2<f32>(-(dot(_e108, _e109)), dot(_e112, _e113)));
    let _e117 = view;
    return _e117;
}

fn interiorTexelDepth(view_1: InteriorView, depth_1: f32) -> f32 {
    var view_2: InteriorView;
    var depth_2: f32;

    view_2 = view_1;
    depth_2 = depth_1;
    let _e22 = view_2;
    let _e25 = view_2;
    let _e28 = depth_2;
    return (_e22.texelDepth.x + (_e25.texelDepth.y * _e28));
}

fn interiorTexelWidth(view_3: InteriorView, w_23: f32) -> f32 {
    var view_4: InteriorView;
    var w_24: f32;

    view_4 = view_3;
    w_24 = w_23;
    let _e22 = view_4;
    let _e24 = w_24;
    return (_e22.texelWidth * _e24);
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
    let _e25 = at_2;
    let _e28 = view_6;
    let _e36 = at_2;
    let _e39 = view_6;
    clip = vec2<f32>((((2f * _e25.x) / _e28.size.x) - 1f), (1f - ((2f * _e36.y) / _e39.size.y)));
    let _e46 = view_6;
    let _e48 = clip;
    let _e50 = clip;
    let _e52 = depth_4;
    p_6 = (_e46.worldFromClip * vec4<f32>(_e48.x, _e50.y, _e52, 1f));
    let _e57 = p_6;
    let _e59 = p_6;
    let _e61 = p_6;
    let _e64 = p_6;
    return (vec3<f32>(_e57.x, _e59.y, _e61.z) / vec3(_e64.w));
}

fn exitRay(view_7: InteriorView, origin: vec3<f32>, direction_10: vec3<f32>) -> ExitRay {
    var view_8: InteriorView;
    var origin_1: vec3<f32>;
    var direction_11: vec3<f32>;
    var o_2: vec4<f32>;
    var d_17: vec4<f32>;
    var h_14: vec2<f32>;
    var ray: ExitRay;

    view_8 = view_7;
    origin_1 = origin;
    direction_11 = direction_10;
    let _e27 = view_8;
    let _e29 = origin_1;
    o_2 = (_e27.clipFromWorld * vec4<f32>(_e29.x, _e29.y, _e29.z, 1f));
    let _e37 = view_8;
    let _e39 = direction_11;
    d_17 = (_e37.clipFromWorld * vec4<f32>(_e39.x, _e39.y, _e39.z, 0f));
    let _e48 = view_8;
    h_14 = (0.5f * _e48.size);
    let _e54 = h_14;
    let _e56 = o_2;
    let _e58 = o_2;
    let _e62 = h_14;
    let _e64 = o_2;
    let _e66 = o_2;
    let _e70 = o_2;
    let _e72 = o_2;
    ray.origin = vec4<f32>((_e54.x * (_e56.w + _e58.x)), (_e62.y * (_e64.w - _e66.y)), _e70.z, _e72.w);
    let _e76 = h_14;
    let _e78 = d_17;
    let _e80 = d_17;
    let _e84 = h_14;
    let _e86 = d_17;
    let _e88 = d_17;
    let _e92 = d_17;
    let _e94 = d_17;
    ray.direction = vec4<f32>((_e76.x * (_e78.w + _e80.x)), (_e84.y * (_e86.w - _e88.y)), _e92.z, _e94.w);
    let _e97 = ray;
    return _e97;
}

fn exitAt(ray_1: ExitRay, t_25: f32) -> vec4<f32> {
    var ray_2: ExitRay;
    var t_26: f32;
    var p_7: vec4<f32>;
    var s_16: f32;

    ray_2 = ray_1;
    t_26 = t_25;
    let _e25 = ray_2;
    let _e27 = t_26;
    let _e28 = ray_2;
    p_7 = (_e25.origin + (_e27 * _e28.direction));
    let _e34 = p_7;
    s_16 = (1f / _e34.w);
    let _e38 = p_7;
    let _e40 = s_16;
    let _e42 = p_7;
    let _e44 = s_16;
    let _e46 = p_7;
    let _e48 = s_16;
    let _e50 = p_7;
    return vec4<f32>((_e38.x * _e40), (_e42.y * _e44), (_e46.z * _e48), _e50.w);
}

fn exitOnPicture(view_9: InteriorView, at_3: vec4<f32>) -> bool {
    var view_10: InteriorView;
    var at_4: vec4<f32>;

    view_10 = view_9;
    at_4 = at_3;
    let _e25 = at_4;
    let _e29 = at_4;
    let _e34 = at_4;
    let _e39 = at_4;
    let _e41 = view_10;
    let _e46 = at_4;
    let _e48 = view_10;
    return (((((_e25.w > 0f) && (_e29.x >= 0f)) && (_e34.y >= 0f)) && (_e39.x < _e41.size.x)) && (_e46.y < _e48.size.y));
}

fn exitStretches(depths: vec4<f32>) -> vec4<f32> {
    var depths_1: vec4<f32>;

    depths_1 = depths;
    let _e23 = depths_1;
    let _e25 = depths_1;
    if (_e23.x < _e25.y) {
        let _e29 = depths_1;
        let _e31 = depths_1;
        let _e33 = depths_1;
        return vec4<f32>(2f, _e29.y, _e31.x, _e33.w);
    }
    let _e36 = depths_1;
    let _e38 = depths_1;
    let _e41 = depths_1;
    if ((_e36.z > _e38.y) && (_e41.w > 0f)) {
        let _e46 = depths_1;
        let _e48 = depths_1;
        return vec4<f32>(_e46.x, _e48.w, 0f, 0f);
    }
    let _e53 = depths_1;
    return _e53;
}

fn exitInside(stretches: vec4<f32>, depth_5: f32) -> vec2<f32> {
    var stretches_1: vec4<f32>;
    var depth_6: f32;
    var inside_1: vec2<f32> = vec2(-2f);

    stretches_1 = stretches;
    depth_6 = depth_5;
    let _e28 = stretches_1;
    if (_e28.y > 0f) {
        let _e33 = stretches_1;
        let _e35 = depth_6;
        let _e37 = depth_6;
        let _e38 = stretches_1;
        inside_1.x = min((_e33.x - _e35), (_e37 - _e38.y));
    }
    let _e42 = stretches_1;
    if (_e42.w > 0f) {
        let _e47 = stretches_1;
        let _e49 = depth_6;
        let _e51 = depth_6;
        let _e52 = stretches_1;
        inside_1.y = min((_e47.z - _e49), (_e51 - _e52.w));
    }
    let _e56 = inside_1;
    return _e56;
}

fn exitLearn(way: ExitWay, t_27: f32, w_25: f32, here: f32, margin: f32) -> ExitWay {
    var way_1: ExitWay;
    var t_28: f32;
    var w_26: f32;
    var here_1: f32;
    var margin_1: f32;
    var local_74: f32;

    way_1 = way;
    t_28 = t_27;
    w_26 = w_25;
    here_1 = here;
    margin_1 = margin;
    let _e31 = here_1;
    let _e32 = margin_1;
    if (_e31 > _e32) {
        {
            let _e35 = t_28;
            way_1.tInside = _e35;
            let _e37 = here_1;
            let _e38 = w_26;
            way_1.inside = (_e37 * _e38);
        }
    } else {
        let _e40 = here_1;
        let _e41 = margin_1;
        if (_e40 < -(_e41)) {
            {
                let _e45 = t_28;
                way_1.tOutside = _e45;
                let _e47 = here_1;
                if (_e47 > EXIT_NOWHERE) {
                    let _e49 = here_1;
                    let _e50 = w_26;
                    local_74 = (_e49 * _e50);
                } else {
                    local_74 = EXIT_NOWHERE;
                }
                let _e53 = local_74;
                way_1.outside = _e53;
            }
        }
    }
    let _e54 = way_1;
    return _e54;
}

fn exitSecant(way_2: ExitWay) -> f32 {
    var way_3: ExitWay;
    var local_75: f32;
    var share_2: f32;

    way_3 = way_2;
    let _e23 = way_3;
    if (_e23.outside > EXIT_NOWHERE) {
        let _e26 = way_3;
        let _e28 = way_3;
        let _e30 = way_3;
        local_75 = clamp((_e26.inside / (_e28.inside - _e30.outside)), 0.05f, 0.95f);
    } else {
        local_75 = 0.5f;
    }
    let _e39 = local_75;
    share_2 = _e39;
    let _e41 = way_3;
    let _e43 = way_3;
    let _e45 = share_2;
    return mix(_e41.tInside, _e43.tOutside, _e45);
}

fn exitSpacing(k_20: i32) -> f32 {
    var k_21: i32;
    var x_25: f32;
    var x3_: f32;

    k_21 = k_20;
    let _e24 = k_21;
    x_25 = (0.25f * f32(_e24));
    let _e28 = x_25;
    let _e29 = x_25;
    let _e31 = x_25;
    x3_ = ((_e28 * _e29) * _e31);
    let _e34 = x_25;
    let _e35 = x3_;
    let _e39 = x3_;
    let _e40 = x3_;
    return ((_e34 + (_e35 / 3f)) + ((_e39 * _e40) / 20f));
}

fn exitPlane(origin_2: vec3<f32>, direction_12: vec3<f32>, point: vec3<f32>, n_43: vec3<f32>) -> f32 {
    var origin_3: vec3<f32>;
    var direction_13: vec3<f32>;
    var point_1: vec3<f32>;
    var n_44: vec3<f32>;

    origin_3 = origin_2;
    direction_13 = direction_12;
    point_1 = point;
    n_44 = n_43;
    let _e29 = point_1;
    let _e30 = origin_3;
    let _e32 = n_44;
    let _e34 = direction_13;
    let _e35 = n_44;
    return (dot((_e29 - _e30), _e32) / dot(_e34, _e35));
}

fn exitSame(point_2: vec3<f32>, n_45: vec3<f32>, otherPoint: vec3<f32>, otherN: vec3<f32>) -> bool {
    var point_3: vec3<f32>;
    var n_46: vec3<f32>;
    var otherPoint_1: vec3<f32>;
    var otherN_1: vec3<f32>;
    var chord_1: vec3<f32>;

    point_3 = point_2;
    n_46 = n_45;
    otherPoint_1 = otherPoint;
    otherN_1 = otherN;
    let _e29 = otherPoint_1;
    let _e30 = point_3;
    chord_1 = (_e29 - _e30);
    let _e33 = n_46;
    let _e34 = otherN_1;
    let _e38 = chord_1;
    let _e39 = n_46;
    let _e43 = chord_1;
    return ((dot(_e33, _e34) > 0.7f) && (abs(dot(_e38, _e39)) <= (0.39f * length(_e43))));
}

fn exitCurvature(n_47: vec3<f32>, direction_14: vec3<f32>, stepX: vec3<f32>, turnX: vec3<f32>, stepY: vec3<f32>, turnY: vec3<f32>) -> vec2<f32> {
    var n_48: vec3<f32>;
    var direction_15: vec3<f32>;
    var stepX_1: vec3<f32>;
    var turnX_1: vec3<f32>;
    var stepY_1: vec3<f32>;
    var turnY_1: vec3<f32>;
    var area_1: f32;
    var turn_1: f32;
    var along_9: vec3<f32>;
    var t1_2: vec3<f32>;
    var t2_: vec3<f32>;
    var turn1_: vec3<f32>;
    var turn2_: vec3<f32>;
    var twist: f32;
    var curvature_3: vec2<f32>;
    var local_76: vec2<f32>;

    n_48 = n_47;
    direction_15 = direction_14;
    stepX_1 = stepX;
    turnX_1 = turnX;
    stepY_1 = stepY;
    turnY_1 = turnY;
    let _e33 = stepX_1;
    let _e34 = stepY_1;
    let _e36 = n_48;
    area_1 = dot(cross(_e33, _e34), _e36);
    let _e39 = turnX_1;
    let _e40 = turnX_1;
    let _e42 = turnY_1;
    let _e43 = turnY_1;
    turn_1 = max(dot(_e39, _e40), dot(_e42, _e43));
    let _e47 = area_1;
    let _e50 = turn_1;
    if ((_e47 == 0f) || (_e50 > 0.0625f)) {
        return vec2(0f);
    }
    let _e56 = direction_15;
    let _e57 = direction_15;
    let _e58 = n_48;
    let _e60 = n_48;
    along_9 = (_e56 - (dot(_e57, _e58) * _e60));
    let _e64 = along_9;
    let _e65 = along_9;
    if (dot(_e64, _e65) < 0.000000000001f) {
        let _e69 = stepX_1;
        let _e70 = stepX_1;
        let _e71 = n_48;
        let _e73 = n_48;
        along_9 = (_e69 - (dot(_e70, _e71) * _e73));
    }
    let _e76 = along_9;
    t1_2 = normalize(_e76);
    let _e79 = n_48;
    let _e80 = t1_2;
    t2_ = cross(_e79, _e80);
    let _e83 = stepY_1;
    let _e84 = t2_;
    let _e86 = turnX_1;
    let _e88 = stepX_1;
    let _e89 = t2_;
    let _e91 = turnY_1;
    let _e94 = area_1;
    turn1_ = (((dot(_e83, _e84) * _e86) - (dot(_e88, _e89) * _e91)) / vec3(_e94));
    let _e98 = stepX_1;
    let _e99 = t1_2;
    let _e101 = turnY_1;
    let _e103 = stepY_1;
    let _e104 = t1_2;
    let _e106 = turnX_1;
    let _e109 = area_1;
    turn2_ = (((dot(_e98, _e99) * _e101) - (dot(_e103, _e104) * _e106)) / vec3(_e109));
    let _e113 = turn1_;
    let _e114 = t2_;
    let _e116 = turn2_;
    let _e117 = t1_2;
    twist = abs((dot(_e113, _e114) - dot(_e116, _e117)));
    let _e122 = turn1_;
    let _e123 = t1_2;
    let _e125 = turn2_;
    let _e126 = t2_;
    curvature_3 = vec2<f32>(dot(_e122, _e123), dot(_e125, _e126));
    let _e130 = twist;
    let _e131 = curvature_3;
    let _e134 = curvature_3;
    if (_e130 > (abs(_e131.x) + abs(_e134.y))) {
        local_76 = vec2(0f);
    } else {
        let _e141 = curvature_3;
        local_76 = _e141;
    }
    let _e143 = local_76;
    return _e143;
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

fn engineEnvironment(direction_16: vec3<f32>, sigma_6: f32) -> vec3<f32> {
    var direction_17: vec3<f32>;
    var sigma_7: f32;

    direction_17 = direction_16;
    sigma_7 = sigma_6;
    return vec3(0f);
}

fn scenePixel(clip_1: vec4<f32>, size_21: vec2<f32>) -> vec2<f32> {
    var clip_2: vec4<f32>;
    var size_22: vec2<f32>;

    clip_2 = clip_1;
    size_22 = size_21;
    let _e30 = clip_2;
    let _e33 = clip_2;
    let _e37 = size_22;
    let _e42 = clip_2;
    let _e45 = clip_2;
    let _e49 = size_22;
    return vec2<f32>(((0.5f + ((0.5f * _e30.x) / _e33.w)) * _e37.x), ((0.5f - ((0.5f * _e42.y) / _e45.w)) * _e49.y));
}

fn sceneGuess(origin_4: vec4<f32>, along_10: vec4<f32>, view_11: SceneView) -> SceneIntersection {
    var origin_5: vec4<f32>;
    var along_11: vec4<f32>;
    var view_12: SceneView;
    var met_1: SceneIntersection;
    var at_15: vec2<f32>;
    var k_22: i32 = 0i;
    var depth_7: f32;
    var sky: bool;
    var local_77: f32;
    var local_78: vec4<f32>;
    var there: vec4<f32>;
    var next: vec2<f32>;

    origin_5 = origin_4;
    along_11 = along_10;
    view_12 = view_11;
    met_1.seen = false;
    met_1.behind = 0f;
    met_1.metres = -1f;
    let _e38 = origin_5;
    let _e39 = view_12;
    let _e41 = scenePixel(_e38, _e39.size);
    at_15 = _e41;
    loop {
        let _e45 = k_22;
        let _e47 = met_1;
        if !(((_e45 < SCENE_GUESSES) && !(_e47.seen))) {
            break;
        }
        {
            let _e55 = at_15;
            let _e56 = engineSceneDepth(_e55);
            depth_7 = _e56;
            let _e58 = depth_7;
            sky = (_e58 > 100000000000000000000000000000f);
            let _e63 = sky;
            if _e63 {
                local_77 = -1f;
            } else {
                let _e66 = depth_7;
                let _e67 = origin_5;
                let _e70 = along_11;
                local_77 = ((_e66 - _e67.w) / _e70.w);
            }
            let _e74 = local_77;
            met_1.metres = _e74;
            let _e75 = along_11;
            let _e80 = sky;
            let _e82 = met_1;
            if (!((_e75.w > 0f)) || (!(_e80) && (_e82.metres < 0f))) {
                break;
            }
            let _e88 = sky;
            if _e88 {
                let _e89 = along_11;
                local_78 = _e89;
            } else {
                let _e90 = origin_5;
                let _e91 = met_1;
                let _e93 = along_11;
                local_78 = (_e90 + (_e91.metres * _e93));
            }
            let _e97 = local_78;
            there = _e97;
            let _e99 = there;
            let _e100 = view_12;
            let _e102 = scenePixel(_e99, _e100.size);
            next = _e102;
            let _e105 = k_22;
            let _e108 = next;
            let _e110 = at_15;
            let _e117 = next;
            let _e119 = at_15;
            met_1.seen = (((_e105 > 0i) && (abs((_e108.x - _e110.x)) < 1f)) && (abs((_e117.y - _e119.y)) < 1f));
            let _e126 = next;
            at_15 = _e126;
        }
        continuing {
            let _e52 = k_22;
            k_22 = (_e52 + 1i);
        }
    }
    let _e127 = met_1;
    return _e127;
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
    let _e28 = origin_7;
    let _e30 = origin_7;
    let _e33 = origin_7;
    let _e35 = origin_7;
    let _e38 = origin_7;
    let _e40 = origin_7;
    let _e43 = origin_7;
    let _e45 = origin_7;
    room_1 = max(vec4<f32>((_e28.w - _e30.x), (_e33.w + _e35.x), (_e38.w - _e40.y), (_e43.w + _e45.y)), vec4(0f));
    let _e53 = way_5;
    let _e55 = way_5;
    let _e58 = way_5;
    let _e61 = way_5;
    let _e64 = way_5;
    let _e66 = way_5;
    let _e69 = way_5;
    let _e72 = way_5;
    loss = vec4<f32>((_e53.x - _e55.w), (-(_e58.x) - _e61.w), (_e64.y - _e66.w), (-(_e69.y) - _e72.w));
    let _e77 = room_1;
    let _e78 = loss;
    let _e79 = room_1;
    cut = min((_e77 / max(max(_e78, _e79), vec4(0.000000000000000000000000000001f))), vec4(1f));
    let _e89 = cut;
    let _e91 = cut;
    let _e94 = cut;
    let _e96 = cut;
    end = min(min(_e89.x, _e91.y), min(_e94.z, _e96.w));
    let _e101 = end;
    let _e103 = origin_7;
    let _e106 = way_5;
    let _e110 = origin_7;
    return min(_e101, ((0.99f * _e103.w) / max(-(_e106.w), (0.99f * _e110.w))));
}

fn sceneMarch(origin_8: vec4<f32>, along_12: vec4<f32>, view_13: SceneView) -> SceneIntersection {
    var origin_9: vec4<f32>;
    var along_13: vec4<f32>;
    var view_14: SceneView;
    var way_6: vec4<f32>;
    var end_1: f32;
    var to: vec4<f32>;
    var a_32: vec3<f32>;
    var b_22: vec3<f32>;
    var met_2: SceneIntersection;
    var low_7: f32 = 0f;
    var heightLow: f32 = 0f;
    var high_2: f32 = 1f;
    var heightHigh: f32 = 0f;
    var crossed: bool = false;
    var depth_8: f32 = 0f;
    var k_23: i32 = 1i;
    var p_8: vec3<f32>;
    var beyond: f32;
    var bordered: bool;
    var local_79: f32;
    var gap: f32;
    var k_24: i32 = 0i;
    var local_80: f32;
    var share_3: f32;
    var u_17: f32;
    var p_9: vec3<f32>;
    var height_2: f32;
    var front: bool;
    var local_81: f32;
    var local_82: f32;
    var local_83: f32;
    var local_84: f32;
    var u_18: f32;
    var near: f32;
    var far: f32;
    var surface_6: bool;

    origin_9 = origin_8;
    along_13 = along_12;
    view_14 = view_13;
    let _e30 = view_14;
    let _e32 = along_13;
    way_6 = (_e30.reach * _e32);
    let _e35 = origin_9;
    let _e36 = way_6;
    let _e37 = sceneShown(_e35, _e36);
    end_1 = _e37;
    let _e39 = origin_9;
    let _e40 = end_1;
    let _e41 = way_6;
    to = (_e39 + (_e40 * _e41));
    let _e45 = origin_9;
    let _e47 = origin_9;
    let _e51 = origin_9;
    a_32 = (vec3<f32>(_e45.x, _e47.y, 1f) / vec3(_e51.w));
    let _e56 = to;
    let _e58 = to;
    let _e62 = to;
    b_22 = (vec3<f32>(_e56.x, _e58.y, 1f) / vec3(_e62.w));
    met_2.seen = false;
    met_2.behind = 0f;
    met_2.metres = -1f;
    loop {
        let _e89 = k_23;
        let _e91 = crossed;
        if !(((_e89 <= SCENE_STEPS) && !(_e91))) {
            break;
        }
        {
            let _e98 = k_23;
            high_2 = (f32(_e98) / 12f);
            let _e103 = a_32;
            let _e104 = b_22;
            let _e105 = high_2;
            p_8 = mix(_e103, _e104, vec3(_e105));
            let _e111 = p_8;
            let _e115 = view_14;
            let _e121 = p_8;
            let _e125 = view_14;
            let _e130 = engineSceneDepth(vec2<f32>(((0.5f + (0.5f * _e111.x)) * _e115.size.x), ((0.5f - (0.5f * _e121.y)) * _e125.size.y)));
            depth_8 = _e130;
            let _e131 = p_8;
            let _e134 = depth_8;
            heightHigh = (_e131.z - (1f / _e134));
            let _e137 = heightHigh;
            let _e140 = k_23;
            let _e143 = heightLow;
            crossed = ((_e137 < 0f) && ((_e140 == 1i) || (_e143 >= 0f)));
            let _e148 = crossed;
            if !(_e148) {
                {
                    let _e150 = high_2;
                    low_7 = _e150;
                    let _e151 = heightHigh;
                    heightLow = _e151;
                }
            }
        }
        continuing {
            let _e95 = k_23;
            k_23 = (_e95 + 1i);
        }
    }
    let _e152 = crossed;
    if !(_e152) {
        {
            let _e154 = depth_8;
            let _e155 = origin_9;
            let _e158 = along_13;
            beyond = ((_e154 - _e155.w) / _e158.w);
            let _e162 = end_1;
            let _e165 = depth_8;
            let _e169 = heightHigh;
            let _e173 = beyond;
            bordered = ((((_e162 < 1f) && (_e165 < 100000000000000000000000000000f)) && (_e169 >= 0f)) && (_e173 > 0f));
            let _e179 = bordered;
            if _e179 {
                let _e180 = beyond;
                local_79 = _e180;
            } else {
                local_79 = -1f;
            }
            let _e184 = local_79;
            met_2.metres = _e184;
            let _e186 = bordered;
            let _e187 = heightHigh;
            let _e190 = depth_8;
            let _e194 = along_13;
            met_2.seen = (_e186 || (((_e187 >= 0f) && (_e190 > 100000000000000000000000000000f)) && (_e194.w > 0f)));
            let _e200 = met_2;
            return _e200;
        }
    }
    let _e201 = heightLow;
    let _e202 = heightHigh;
    gap = max((_e201 - _e202), 0.000000000000000000000000000001f);
    loop {
        let _e209 = k_24;
        if !((_e209 < SCENE_SECANTS)) {
            break;
        }
        {
            let _e215 = k_24;
            if ((_e215 % 2i) == 0i) {
                local_80 = 0.5f;
            } else {
                let _e221 = heightLow;
                let _e222 = heightLow;
                let _e223 = heightHigh;
                local_80 = (_e221 / max((_e222 - _e223), 0.000000000000000000000000000001f));
            }
            let _e229 = local_80;
            share_3 = _e229;
            let _e231 = low_7;
            let _e232 = high_2;
            let _e233 = share_3;
            u_17 = mix(_e231, _e232, clamp(_e233, 0f, 1f));
            let _e239 = a_32;
            let _e240 = b_22;
            let _e241 = u_17;
            p_9 = mix(_e239, _e240, vec3(_e241));
            let _e247 = p_9;
            let _e251 = view_14;
            let _e257 = p_9;
            let _e261 = view_14;
            let _e266 = engineSceneDepth(vec2<f32>(((0.5f + (0.5f * _e247.x)) * _e251.size.x), ((0.5f - (0.5f * _e257.y)) * _e261.size.y)));
            depth_8 = _e266;
            let _e267 = p_9;
            let _e270 = depth_8;
            height_2 = (_e267.z - (1f / _e270));
            let _e274 = height_2;
            front = (_e274 >= 0f);
            let _e278 = front;
            if _e278 {
                let _e279 = u_17;
                local_81 = _e279;
            } else {
                let _e280 = low_7;
                local_81 = _e280;
            }
            let _e282 = local_81;
            low_7 = _e282;
            let _e283 = front;
            if _e283 {
                let _e284 = height_2;
                local_82 = _e284;
            } else {
                let _e285 = heightLow;
                local_82 = _e285;
            }
            let _e287 = local_82;
            heightLow = _e287;
            let _e288 = front;
            if _e288 {
                let _e289 = high_2;
                local_83 = _e289;
            } else {
                let _e290 = u_17;
                local_83 = _e290;
            }
            let _e292 = local_83;
            high_2 = _e292;
            let _e293 = front;
            if _e293 {
                let _e294 = heightHigh;
                local_84 = _e294;
            } else {
                let _e295 = height_2;
                local_84 = _e295;
            }
            let _e297 = local_84;
            heightHigh = _e297;
        }
        continuing {
            let _e212 = k_24;
            k_24 = (_e212 + 1i);
        }
    }
    let _e298 = low_7;
    let _e299 = high_2;
    let _e300 = heightLow;
    let _e301 = heightLow;
    let _e302 = heightHigh;
    u_18 = mix(_e298, _e299, (_e300 / max((_e301 - _e302), 0.000000000000000000000000000001f)));
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
        let _e356 = depth_8;
        met_2.behind = max(((1f / max((_e350 + _e351), 0.000000000000000000000000000001f)) - _e356), 0f);
    }
    let _e360 = met_2;
    return _e360;
}

fn sceneIntersection(origin_10: vec3<f32>, direction_18: vec3<f32>, view_15: SceneView) -> SceneIntersection {
    var origin_11: vec3<f32>;
    var direction_19: vec3<f32>;
    var view_16: SceneView;
    var from_: vec4<f32>;
    var along_14: vec4<f32>;
    var met_3: SceneIntersection;

    origin_11 = origin_10;
    direction_19 = direction_18;
    view_16 = view_15;
    let _e30 = view_16;
    let _e32 = origin_11;
    from_ = (_e30.clipFromWorld * vec4<f32>(_e32.x, _e32.y, _e32.z, 1f));
    let _e40 = view_16;
    let _e42 = direction_19;
    along_14 = (_e40.clipFromWorld * vec4<f32>(_e42.x, _e42.y, _e42.z, 0f));
    let _e50 = from_;
    let _e51 = along_14;
    let _e52 = view_16;
    let _e53 = sceneGuess(_e50, _e51, _e52);
    met_3 = _e53;
    let _e55 = met_3;
    if !(_e55.seen) {
        let _e58 = from_;
        let _e59 = along_14;
        let _e60 = view_16;
        let _e61 = sceneMarch(_e58, _e59, _e60);
        met_3 = _e61;
    }
    let _e62 = met_3;
    return _e62;
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
    let _e35 = view_18.clipFromWorld[0][3];
    let _e41 = view_18.clipFromWorld[1][3];
    let _e47 = view_18.clipFromWorld[2][3];
    forward = vec3<f32>(_e35, _e41, _e47);
    let _e55 = view_18.clipFromWorld[0][0];
    let _e61 = view_18.clipFromWorld[1][0];
    let _e67 = view_18.clipFromWorld[2][0];
    x_26 = vec3<f32>(_e55, _e61, _e67);
    let _e75 = view_18.clipFromWorld[0][1];
    let _e81 = view_18.clipFromWorld[1][1];
    let _e87 = view_18.clipFromWorld[2][1];
    y_11 = vec3<f32>(_e75, _e81, _e87);
    let _e90 = x_26;
    let _e91 = x_26;
    let _e92 = forward;
    let _e94 = forward;
    x_26 = (_e90 - (dot(_e91, _e92) * _e94));
    let _e97 = y_11;
    let _e98 = y_11;
    let _e99 = forward;
    let _e101 = forward;
    y_11 = (_e97 - (dot(_e98, _e99) * _e101));
    let _e107 = view_18;
    let _e110 = x_26;
    let _e111 = x_26;
    let _e115 = x_26;
    steps.right = ((2f / (_e107.size.x * dot(_e110, _e111))) * _e115);
    let _e120 = view_18;
    let _e123 = y_11;
    let _e124 = y_11;
    let _e128 = y_11;
    steps.down = ((-2f / (_e120.size.y * dot(_e123, _e124))) * _e128);
    let _e130 = steps;
    return _e130;
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
    var local_85: bool;

    at_19 = at_18;
    p_11 = p_10;
    which_1 = which;
    steps_2 = steps_1;
    view_20 = view_19;
    let _e38 = which_1;
    let _e40 = at_19;
    let _e41 = engineFace(_e38.layer, _e40);
    texel_4 = _e41;
    let _e43 = at_19;
    let _e48 = at_19;
    off_1 = ((floor(_e43) + vec2(0.5f)) - _e48);
    let _e53 = view_20;
    let _e55 = texel_4;
    let _e57 = p_11;
    let _e58 = off_1;
    let _e60 = steps_2;
    let _e64 = off_1;
    let _e66 = steps_2;
    face_6.point = (_e53.eye + (_e55.z * ((_e57 + (_e58.x * _e60.right)) + (_e64.y * _e66.down))));
    let _e73 = which_1;
    let _e75 = texel_4;
    let _e77 = texel_4;
    let _e80 = octDecode(vec2<f32>(_e75.x, _e77.y));
    face_6.n = (_e73.side * _e80);
    let _e84 = texel_4;
    face_6.alpha = (2f * fract(_e84.w));
    let _e89 = texel_4;
    face_6.number = floor(_e89.w);
    let _e93 = which_1;
    if (_e93.number < 0f) {
        let _e97 = face_6;
        local_85 = (_e97.number > 0f);
    } else {
        let _e101 = face_6;
        let _e103 = which_1;
        local_85 = (_e101.number == _e103.number);
    }
    let _e107 = local_85;
    face_6.exists = _e107;
    let _e108 = face_6;
    return _e108;
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
    let _e40 = at_21;
    let _e41 = p_13;
    let _e42 = which_3;
    let _e43 = steps_4;
    let _e44 = view_22;
    let _e45 = backFaceAt(_e40, _e41, _e42, _e43, _e44);
    beside_5 = _e45;
    let _e47 = beside_5;
    let _e49 = own_1;
    let _e51 = own_1;
    let _e53 = beside_5;
    let _e55 = beside_5;
    let _e57 = exitSame(_e49.point, _e51.n, _e53.point, _e55.n);
    if (_e47.exists && _e57) {
        let _e59 = beside_5;
        return _e59;
    }
    let _e60 = own_1;
    return _e60;
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
    let _e46 = face_8;
    let _e47 = at_23;
    let _e52 = p_15;
    let _e53 = steps_6;
    let _e56 = which_5;
    let _e57 = steps_6;
    let _e58 = view_24;
    let _e59 = backFaceBeside(_e46, (_e47 + vec2<f32>(1f, 0f)), (_e52 + _e53.right), _e56, _e57, _e58);
    right_2 = _e59;
    let _e61 = face_8;
    let _e62 = at_23;
    let _e67 = p_15;
    let _e68 = steps_6;
    let _e71 = which_5;
    let _e72 = steps_6;
    let _e73 = view_24;
    let _e74 = backFaceBeside(_e61, (_e62 + vec2<f32>(0f, 1f)), (_e67 + _e68.down), _e71, _e72, _e73);
    below_6 = _e74;
    let _e76 = hit_1;
    let _e77 = at_23;
    off_2 = ((_e76 - floor(_e77)) - vec2(0.5f));
    let _e88 = face_8;
    let _e90 = off_2;
    let _e92 = right_2;
    let _e94 = face_8;
    let _e99 = off_2;
    let _e101 = below_6;
    let _e103 = face_8;
    found_2.exit.surface.n = normalize(((_e88.n + (_e90.x * (_e92.n - _e94.n))) + (_e99.y * (_e101.n - _e103.n))));
    let _e112 = face_8;
    found_2.exit.surface.alpha = _e112.alpha;
    let _e116 = origin_13;
    let _e117 = direction_21;
    let _e118 = face_8;
    let _e120 = face_8;
    let _e122 = exitPlane(_e116, _e117, _e118.point, _e120.n);
    found_2.exit.path = _e122;
    let _e124 = face_8;
    found_2.number = _e124.number;
    let _e126 = direction_21;
    let _e127 = found_2;
    cosTheta_40 = dot(_e126, _e127.exit.surface.n);
    let _e133 = face_8;
    let _e135 = direction_21;
    let _e136 = right_2;
    let _e138 = face_8;
    let _e141 = right_2;
    let _e143 = face_8;
    let _e146 = below_6;
    let _e148 = face_8;
    let _e151 = below_6;
    let _e153 = face_8;
    let _e156 = exitCurvature(_e133.n, _e135, (_e136.point - _e138.point), (_e141.n - _e143.n), (_e146.point - _e148.point), (_e151.n - _e153.n));
    curvature_4 = _e156;
    let _e161 = cosTheta_40;
    let _e162 = found_2;
    let _e165 = curvature_4;
    let _e166 = exitTurn(_e161, _e162.exit.path, _e165);
    found_2.exit.surface.turn = _e166;
    let _e168 = cosTheta_40;
    found_2.found = (_e168 > 0f);
    let _e171 = found_2;
    return _e171;
}

fn noBackFace(direction_22: vec3<f32>, eta_44: f32) -> BackFaceExit {
    var direction_23: vec3<f32>;
    var eta_45: f32;
    var none: BackFaceExit;

    direction_23 = direction_22;
    eta_45 = eta_44;
    let _e36 = direction_23;
    none.exit.surface.n = _e36;
    none.exit.surface.alpha = 0f;
    none.exit.surface.turn = vec2(0f);
    let _e49 = eta_45;
    none.exit.surface.eta = _e49;
    none.exit.path = 0f;
    none.number = 0f;
    none.found = false;
    let _e57 = none;
    return _e57;
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
    var k_25: i32 = 0i;
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
    let _e40 = view_26;
    let _e42 = origin_15;
    from_1 = (_e40.clipFromWorld * vec4<f32>(_e42.x, _e42.y, _e42.z, 1f));
    let _e50 = view_26;
    let _e52 = direction_25;
    along_15 = (_e50.clipFromWorld * vec4<f32>(_e52.x, _e52.y, _e52.z, 0f));
    let _e60 = view_26;
    let _e61 = pixelSteps(_e60);
    steps_7 = _e61;
    let _e65 = first_7;
    t_29 = _e65;
    loop {
        let _e83 = k_25;
        let _e85 = found_3;
        let _e88 = lost_2;
        if !((((_e83 < BACK_FACE_STEPS) && !(_e85)) && !(_e88))) {
            break;
        }
        {
            let _e95 = from_1;
            let _e96 = t_29;
            let _e97 = along_15;
            clip_3 = (_e95 + (_e96 * _e97));
            let _e101 = clip_3;
            let _e102 = view_26;
            let _e104 = scenePixel(_e101, _e102.size);
            at_24 = _e104;
            let _e105 = origin_15;
            let _e106 = t_29;
            let _e107 = direction_25;
            here_2 = (_e105 + (_e106 * _e107));
            let _e111 = here_2;
            let _e112 = view_26;
            let _e115 = clip_3;
            p_16 = ((_e111 - _e112.eye) / vec3(_e115.w));
            let _e119 = at_24;
            let _e120 = p_16;
            let _e121 = which_7;
            let _e122 = steps_7;
            let _e123 = view_26;
            let _e124 = backFaceAt(_e119, _e120, _e121, _e122, _e123);
            face_9 = _e124;
            let _e125 = origin_15;
            let _e126 = direction_25;
            let _e127 = face_9;
            let _e129 = face_9;
            let _e131 = exitPlane(_e125, _e126, _e127.point, _e129.n);
            met_4 = _e131;
            let _e133 = face_9;
            let _e135 = direction_25;
            let _e136 = face_9;
            let _e142 = met_4;
            meets = ((_e133.exists && (dot(_e135, _e136.n) > 0f)) && (_e142 > 0f));
            let _e147 = clip_3;
            let _e152 = k_25;
            let _e155 = face_9;
            lost_2 = (!((_e147.w > 0f)) || ((_e152 == 0i) && !(_e155.exists)));
            let _e160 = from_1;
            let _e161 = met_4;
            let _e162 = along_15;
            there_1 = (_e160 + (_e161 * _e162));
            let _e166 = there_1;
            let _e167 = view_26;
            let _e169 = scenePixel(_e166, _e167.size);
            hit_2 = _e169;
            let _e170 = hit_2;
            let _e171 = at_24;
            moved = (_e170 - _e171);
            let _e174 = lost_2;
            let _e176 = meets;
            let _e178 = there_1;
            let _e183 = moved;
            let _e184 = moved;
            found_3 = (((!(_e174) && _e176) && (_e178.w > 0f)) && (dot(_e183, _e184) < 0.5f));
            let _e189 = k_25;
            if (_e189 == 0i) {
                let _e192 = face_9;
                let _e194 = here_2;
                local_86 = length((_e192.point - _e194));
            } else {
                let _e198 = inside_2;
                let _e199 = t_29;
                local_86 = (0.5f * (_e198 + _e199));
            }
            let _e203 = local_86;
            missed = _e203;
            let _e205 = meets;
            if _e205 {
                let _e206 = t_29;
                local_87 = _e206;
            } else {
                let _e207 = inside_2;
                local_87 = _e207;
            }
            let _e209 = local_87;
            inside_2 = _e209;
            let _e210 = meets;
            if _e210 {
                let _e211 = met_4;
                local_88 = _e211;
            } else {
                let _e212 = missed;
                local_88 = _e212;
            }
            let _e214 = local_88;
            t_29 = _e214;
        }
        continuing {
            let _e92 = k_25;
            k_25 = (_e92 + 1i);
        }
    }
    let _e215 = found_3;
    if !(_e215) {
        let _e217 = direction_25;
        let _e218 = eta_47;
        let _e219 = noBackFace(_e217, _e218);
        return _e219;
    }
    let _e220 = face_9;
    let _e221 = at_24;
    let _e222 = hit_2;
    let _e223 = p_16;
    let _e224 = which_7;
    let _e225 = origin_15;
    let _e226 = direction_25;
    let _e227 = steps_7;
    let _e228 = view_26;
    let _e229 = backFaceBetween(_e220, _e221, _e222, _e223, _e224, _e225, _e226, _e227, _e228);
    exit = _e229;
    let _e234 = eta_47;
    exit.exit.surface.eta = _e234;
    let _e235 = exit;
    return _e235;
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
    var ratio_1: f32;
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
    let _e48 = inner_3;
    lobe_3.direction = _e48.direction;
    let _e51 = inner_3;
    lobe_3.sigma = _e51.sigma;
    let _e54 = inner_3;
    lobe_3.inner = _e54.sigma;
    let _e57 = inner_3;
    lobe_3.carried = _e57.sigma;
    let _e60 = inner_3;
    let _e62 = weight_1;
    let _e64 = energy_2;
    lobe_3.weight = ((_e60.weight * _e62) * _e64);
    let _e66 = view_28;
    if !((_e66.cosTheta > 0f)) {
        lobe_3.weight = 0f;
    }
    let _e74 = s_18;
    ratio_1 = (1f / _e74.eta);
    let _e78 = view_28;
    let _e83 = ratio_1;
    if (!((_e78.cosTheta > 0f)) || (abs((_e83 - 1f)) < INDEX_MATCHED)) {
        let _e89 = lobe_3;
        return _e89;
    }
    let _e90 = inner_3;
    let _e92 = view_28;
    let _e94 = s_18;
    along_16 = (_e90.direction - (_e92.cosTheta * _e94.n));
    let _e99 = along_16;
    sinTheta_1 = length(_e99);
    let _e102 = along_16;
    let _e103 = sinTheta_1;
    t_30 = (_e102 / vec3(max(_e103, 0.000000000001f)));
    let _e109 = sinTheta_1;
    let _e110 = view_28;
    d_18 = vec2<f32>(_e109, _e110.cosTheta);
    let _e114 = angle_1;
    let _e116 = angle_1;
    l_4 = vec2<f32>(sin(_e114), cos(_e116));
    let _e120 = ratio_1;
    let _e121 = d_18;
    let _e123 = l_4;
    let _e125 = ratio_1;
    if (_e125 < 1f) {
        local_89 = -1f;
    } else {
        local_89 = 1f;
    }
    let _e132 = local_89;
    h_15 = (((_e120 * _e121) - _e123) * _e132);
    let _e135 = h_15;
    bend = max(length(_e135), 0.00005f);
    let _e142 = d_18;
    let _e143 = h_15;
    let _e145 = bend;
    ci = (dot(_e142, _e143) / _e145);
    let _e148 = l_4;
    let _e149 = h_15;
    let _e151 = bend;
    co = max((dot(_e148, _e149) / _e151), FACET_LEAST_COS);
    let _e156 = view_28;
    rays_1 = (1f - _e156.own);
    let _e160 = angle_1;
    let _e161 = rays_1;
    let _e163 = view_28;
    let _e166 = h_15;
    let _e168 = h_15;
    turned_1 = clamp((_e160 - (((GIVEN_BACK * _e161) / _e163.swing) * atan2(_e166.x, abs(_e168.y)))), -1.5707964f, 1.5707964f);
    let _e184 = turned_1;
    let _e186 = t_30;
    let _e188 = turned_1;
    let _e190 = s_18;
    lobe_3.direction = normalize(((sin(_e184) * _e186) + (cos(_e188) * _e190.n)));
    let _e195 = view_28;
    let _e197 = rays_1;
    let _e199 = view_28;
    let _e203 = view_28;
    kept = (_e195.own - ((_e197 * (1f - _e199.swing)) / _e203.swing));
    let _e208 = sigma_9;
    let _e209 = co;
    let _e212 = ratio_1;
    let _e213 = ci;
    let _e215 = kept;
    let _e216 = co;
    let _e220 = bend;
    seen_1 = (((_e208 * inverseSqrt(_e209)) * ((_e212 * _e213) - (_e215 * _e216))) / _e220);
    let _e223 = ratio_1;
    let _e224 = co;
    let _e225 = ratio_1;
    let _e226 = ci;
    let _e229 = s_18;
    across_11 = (_e223 + ((_e224 - (_e225 * _e226)) * _e229.turn.y));
    let _e235 = inner_3;
    let _e237 = inner_3;
    sigma2_ = (_e235.sigma * _e237.sigma);
    let _e241 = seen_1;
    let _e242 = seen_1;
    let _e244 = view_28;
    let _e246 = sigma2_;
    inPlane = min(((_e241 * _e242) + (_e244.own * _e246)), 0.09f);
    let _e254 = view_28;
    let _e256 = sigma_9;
    let _e258 = sigma_9;
    let _e260 = co;
    let _e262 = across_11;
    let _e263 = across_11;
    let _e265 = sigma2_;
    outOfPlane = ((((_e254.own * _e256) * _e258) * _e260) + ((_e262 * _e263) * _e265));
    let _e270 = inPlane;
    let _e271 = outOfPlane;
    lobe_3.sigma = sqrt(sqrt((_e270 * _e271)));
    let _e275 = view_28;
    if (_e275.swing < 0f) {
        let _e279 = rays_1;
        local_90 = -(sqrt(_e279));
    } else {
        let _e282 = rays_1;
        local_90 = sqrt(_e282);
    }
    let _e285 = local_90;
    let _e286 = seen_1;
    let _e288 = view_28;
    let _e290 = inner_3;
    carriedInPlane = ((_e285 * _e286) + (_e288.own * _e290.sigma));
    let _e297 = carriedInPlane;
    let _e298 = across_11;
    let _e299 = inner_3;
    let _e304 = lobe_3;
    let _e307 = lobe_3;
    lobe_3.carried = clamp((0.5f * (_e297 + (_e298 * _e299.sigma))), -(_e304.sigma), _e307.sigma);
    let _e310 = lobe_3;
    return _e310;
}

fn mergeLobes(a_33: ComposedLobe, b_23: ComposedLobe) -> ComposedLobe {
    var a_34: ComposedLobe;
    var b_24: ComposedLobe;
    var weight_2: f32;
    var local_91: f32;
    var share_4: f32;
    var apart_1: vec3<f32>;
    var mean_2: vec3<f32>;
    var inner2_: f32;
    var both: f32;
    var lobe_4: ComposedLobe;
    var local_92: vec3<f32>;
    var local_93: f32;

    a_34 = a_33;
    b_24 = b_23;
    let _e36 = a_34;
    let _e38 = b_24;
    weight_2 = (_e36.weight + _e38.weight);
    let _e42 = weight_2;
    if (_e42 > 0f) {
        let _e45 = b_24;
        let _e47 = weight_2;
        local_91 = (_e45.weight / _e47);
    } else {
        local_91 = 0f;
    }
    let _e51 = local_91;
    share_4 = _e51;
    let _e53 = b_24;
    let _e55 = a_34;
    apart_1 = (_e53.direction - _e55.direction);
    let _e59 = a_34;
    let _e61 = share_4;
    let _e62 = apart_1;
    mean_2 = (_e59.direction + (_e61 * _e62));
    let _e66 = a_34;
    let _e68 = a_34;
    let _e71 = b_24;
    let _e73 = b_24;
    let _e76 = share_4;
    inner2_ = mix((_e66.inner * _e68.inner), (_e71.inner * _e73.inner), _e76);
    let _e79 = a_34;
    let _e81 = a_34;
    let _e84 = b_24;
    let _e86 = b_24;
    let _e89 = share_4;
    both = mix((_e79.inner * _e81.carried), (_e84.inner * _e86.carried), _e89);
    let _e94 = weight_2;
    lobe_4.weight = _e94;
    let _e96 = mean_2;
    let _e97 = mean_2;
    if (dot(_e96, _e97) > 0.000001f) {
        let _e101 = mean_2;
        local_92 = normalize(_e101);
    } else {
        let _e103 = a_34;
        local_92 = _e103.direction;
    }
    let _e106 = local_92;
    lobe_4.direction = _e106;
    let _e108 = a_34;
    let _e110 = a_34;
    let _e113 = b_24;
    let _e115 = b_24;
    let _e118 = share_4;
    let _e121 = share_4;
    let _e124 = share_4;
    let _e127 = apart_1;
    let _e128 = apart_1;
    lobe_4.sigma = sqrt((mix((_e108.sigma * _e110.sigma), (_e113.sigma * _e115.sigma), _e118) + (((0.5f * _e121) * (1f - _e124)) * dot(_e127, _e128))));
    let _e134 = inner2_;
    lobe_4.inner = sqrt(_e134);
    let _e137 = lobe_4;
    if (_e137.inner > 0f) {
        let _e141 = both;
        let _e142 = lobe_4;
        local_93 = (_e141 / _e142.inner);
    } else {
        local_93 = 0f;
    }
    let _e147 = local_93;
    lobe_4.carried = _e147;
    let _e148 = lobe_4;
    return _e148;
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
    let _e39 = view_30;
    let _e42 = tail_2;
    moved_1 = ((1f - _e39.own) * _e42.weight);
    let _e48 = core_3;
    pair_1.core = _e48;
    let _e50 = tail_2;
    pair_1.rest = _e50;
    let _e53 = core_3;
    let _e55 = moved_1;
    pair_1.core.weight = (_e53.weight + _e55);
    let _e59 = tail_2;
    let _e61 = moved_1;
    pair_1.rest.weight = (_e59.weight - _e61);
    let _e63 = pair_1;
    return _e63;
}

fn mergePairs(core_4: ComposedPair, tail_3: ComposedPair) -> ComposedPair {
    var core_5: ComposedPair;
    var tail_4: ComposedPair;
    var pair_2: ComposedPair;

    core_5 = core_4;
    tail_4 = tail_3;
    let _e38 = core_5;
    pair_2.core = _e38.core;
    let _e41 = core_5;
    let _e43 = tail_4;
    let _e45 = mergeLobes(_e41.rest, _e43.core);
    let _e46 = tail_4;
    let _e48 = mergeLobes(_e45, _e46.rest);
    pair_2.rest = _e48;
    let _e49 = pair_2;
    return _e49;
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
    let _e42 = cosTheta_42;
    c_31 = clamp(_e42, 0f, 1f);
    let _e47 = eta_49;
    if (_e47 >= 1f) {
        let _e50 = c_31;
        return sqrt(_e50);
    }
    let _e53 = eta_49;
    let _e56 = eta_49;
    critical = sqrt(((1f - _e53) * (1f + _e56)));
    let _e61 = c_31;
    let _e62 = critical;
    past = (_e61 < _e62);
    let _e65 = past;
    if _e65 {
        let _e66 = c_31;
        let _e67 = critical;
        local_94 = (_e66 / _e67);
    } else {
        let _e69 = c_31;
        let _e70 = critical;
        let _e73 = critical;
        local_94 = ((_e69 - _e70) / (1f - _e73));
    }
    let _e77 = local_94;
    along_17 = _e77;
    let _e79 = past;
    let _e80 = along_17;
    grazing_1 = (_e79 && (_e80 < 0.5f));
    let _e85 = past;
    if _e85 {
        let _e87 = grazing_1;
        if _e87 {
            let _e88 = along_17;
            local_95 = _e88;
        } else {
            let _e90 = along_17;
            local_95 = (1f - _e90);
        }
        let _e93 = local_95;
        local_96 = (0.125f * _e93);
    } else {
        let _e96 = along_17;
        local_96 = (0.25f * _e96);
    }
    let _e99 = local_96;
    x_27 = sqrt(_e99);
    let _e102 = grazing_1;
    if _e102 {
        let _e103 = x_27;
        local_98 = _e103;
    } else {
        let _e104 = past;
        if _e104 {
            let _e106 = x_27;
            local_97 = (0.5f - _e106);
        } else {
            let _e109 = x_27;
            local_97 = (0.5f + _e109);
        }
        let _e112 = local_97;
        local_98 = _e112;
    }
    let _e114 = local_98;
    return _e114;
}

fn interfaceCosineAt(x_28: f32, eta_50: f32) -> f32 {
    var x_29: f32;
    var eta_51: f32;
    var critical_1: f32;
    var away: f32;
    var local_99: f32;

    x_29 = x_28;
    eta_51 = eta_50;
    let _e42 = eta_51;
    if (_e42 >= 1f) {
        let _e45 = x_29;
        let _e46 = x_29;
        return (_e45 * _e46);
    }
    let _e49 = eta_51;
    let _e52 = eta_51;
    critical_1 = sqrt(((1f - _e49) * (1f + _e52)));
    let _e57 = x_29;
    away = (_e57 - 0.5f);
    let _e61 = away;
    if (_e61 >= 0f) {
        let _e64 = critical_1;
        let _e66 = away;
        let _e68 = away;
        let _e71 = critical_1;
        return (_e64 + (((4f * _e66) * _e68) * (1f - _e71)));
    }
    let _e75 = critical_1;
    let _e76 = x_29;
    if (_e76 < 0.25f) {
        let _e80 = x_29;
        let _e82 = x_29;
        local_99 = ((8f * _e80) * _e82);
    } else {
        let _e86 = away;
        let _e88 = away;
        local_99 = (1f - ((8f * _e86) * _e88));
    }
    let _e92 = local_99;
    return (_e75 * _e92);
}

fn interfaceEtaAxis(eta_52: f32) -> f32 {
    var eta_53: f32;
    var local_100: f32;
    var n_49: f32;

    eta_53 = eta_52;
    let _e40 = eta_53;
    if (_e40 < 1f) {
        let _e44 = eta_53;
        local_100 = (1f / max(_e44, 0.01f));
    } else {
        let _e48 = eta_53;
        local_100 = _e48;
    }
    let _e50 = local_100;
    n_49 = clamp(_e50, 1f, INTERFACE_GREATEST_ETA);
    let _e54 = n_49;
    let _e57 = n_49;
    return (((_e54 - 1f) / (_e57 + 1f)) * 1.6666666f);
}

fn interfaceEnergyCoordinate(cosTheta_43: f32, alpha_94: f32, eta_54: f32) -> vec3<f32> {
    var cosTheta_44: f32;
    var alpha_95: f32;
    var eta_55: f32;
    var local_101: i32;

    cosTheta_44 = cosTheta_43;
    alpha_95 = alpha_94;
    eta_55 = eta_54;
    let _e44 = cosTheta_44;
    let _e45 = eta_55;
    let _e46 = interfaceCosineAxis(_e44, _e45);
    let _e49 = blockCoordinate(_e46, INTERFACE_ENERGY_COSINES, 0i, 1i);
    let _e50 = alpha_95;
    let _e56 = blockCoordinate(sqrt(max(_e50, 0f)), INTERFACE_ENERGY_ALPHAS, 0i, 1i);
    let _e57 = eta_55;
    let _e58 = interfaceEtaAxis(_e57);
    let _e59 = eta_55;
    if (_e59 < 1f) {
        local_101 = 1i;
    } else {
        local_101 = 0i;
    }
    let _e65 = local_101;
    let _e67 = blockCoordinate(_e58, INTERFACE_SLICES, _e65, 2i);
    return vec3<f32>(_e49, _e56, _e67);
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
    let _e48 = cosTheta_46;
    let _e49 = eta_57;
    let _e50 = interfaceCosineAxis(_e48, _e49);
    let _e53 = blockCoordinate(_e50, INTERFACE_LOBE_COSINES, 0i, 1i);
    let _e54 = alpha_97;
    let _e58 = lobe_6;
    let _e59 = lobes_7;
    let _e60 = blockCoordinate(sqrt(max(_e54, 0f)), INTERFACE_LOBE_ALPHAS, _e58, _e59);
    let _e61 = eta_57;
    let _e62 = interfaceEtaAxis(_e61);
    let _e63 = eta_57;
    if (_e63 < 1f) {
        local_102 = 1i;
    } else {
        local_102 = 0i;
    }
    let _e69 = local_102;
    let _e71 = blockCoordinate(_e62, INTERFACE_SLICES, _e69, 2i);
    return vec3<f32>(_e53, _e60, _e71);
}

fn interfaceSnell(cosTheta_47: f32, eta_58: f32) -> f32 {
    var cosTheta_48: f32;
    var eta_59: f32;
    var c_32: f32;

    cosTheta_48 = cosTheta_47;
    eta_59 = eta_58;
    let _e42 = cosTheta_48;
    c_32 = clamp(_e42, 0f, 1f);
    let _e48 = c_32;
    let _e51 = c_32;
    let _e55 = c_32;
    let _e56 = eta_59;
    let _e57 = fresnelG(_e55, _e56);
    return atan2(sqrt(((1f - _e48) * (1f + _e51))), _e57);
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
    let _e44 = cosTheta_50;
    let _e48 = eta_61;
    let _e49 = fresnelG(clamp(_e44, 0f, 1f), _e48);
    g_9 = _e49;
    let _e52 = eta_61;
    let _e55 = eta_61;
    critical_2 = sqrt(max(((1f - _e52) * (1f + _e55)), 0f));
    let _e62 = eta_61;
    let _e65 = eta_61;
    let _e70 = eta_61;
    let _e71 = g_9;
    let _e72 = cosTheta_50;
    let _e73 = critical_2;
    across_12 = (abs(((_e62 - 1f) * (_e65 + 1f))) / max((_e70 * (_e71 + max(_e72, _e73))), 0.000000000000000000000000000001f));
    let _e81 = g_9;
    let _e82 = eta_61;
    cosT = (_e81 / _e82);
    let _e85 = alpha_99;
    let _e86 = critical_2;
    let _e87 = cosTheta_50;
    lean_3 = (_e85 + max((_e86 - _e87), 0f));
    let _e93 = lean_3;
    let _e94 = across_12;
    let _e96 = cosT;
    let _e97 = cosT;
    let _e99 = lean_3;
    width_5 = ((_e93 * _e94) * inverseSqrt(sqrt(((_e96 * _e97) + max(_e99, 0.000000000001f)))));
    let _e107 = width_5;
    let _e110 = width_5;
    return (_e107 / (1f + (2f * _e110)));
}

fn interfaceEnergy(texel_5: vec4<f32>) -> InterfaceEnergy {
    var texel_6: vec4<f32>;
    var e_7: InterfaceEnergy;

    texel_6 = texel_5;
    let _e42 = texel_6;
    e_7.transmitted = _e42.x;
    let _e45 = texel_6;
    e_7.reflected = _e45.y;
    let _e47 = e_7;
    return _e47;
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
    let _e46 = cosTheta_52;
    let _e47 = alpha_101;
    let _e51 = eta_63;
    let _e52 = interfaceWidth(_e46, clamp(_e47, 0f, 1f), _e51);
    width_6 = _e52;
    let _e56 = cosTheta_52;
    let _e57 = eta_63;
    let _e58 = interfaceSnell(_e56, _e57);
    let _e59 = texel_8;
    let _e61 = width_6;
    lobe_7.angle = (_e58 + (_e59.x * _e61));
    let _e65 = texel_8;
    let _e67 = width_6;
    lobe_7.sigma = (_e65.y * _e67);
    let _e70 = texel_8;
    lobe_7.weight = _e70.z;
    let _e72 = lobe_7;
    return _e72;
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
    let _e44 = wo_57;
    let _e45 = n_51;
    let _e47 = n_51;
    let _e49 = wo_57;
    across_13 = ((dot(_e44, _e45) * _e47) - _e49);
    let _e52 = across_13;
    let _e53 = across_13;
    if !((dot(_e52, _e53) > 0.000000000001f)) {
        let _e58 = n_51;
        let _e59 = n_51;
        if (abs(_e59.x) < 0.7f) {
            local_103 = vec3<f32>(1f, 0f, 0f);
        } else {
            local_103 = vec3<f32>(0f, 1f, 0f);
        }
        let _e73 = local_103;
        across_13 = cross(_e58, _e73);
    }
    let _e75 = angle_3;
    let _e77 = across_13;
    let _e80 = angle_3;
    let _e82 = n_51;
    return ((sin(_e75) * normalize(_e77)) - (cos(_e80) * _e82));
}

fn pyramidVariance(level_1: f32) -> f32 {
    var level_2: f32;
    var scale_5: f32;

    level_2 = level_1;
    let _e41 = level_2;
    scale_5 = exp2((2f * _e41));
    let _e46 = scale_5;
    let _e50 = scale_5;
    return ((0.25f * (_e46 - 1f)) + (_e50 / 6f));
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
    let _e42 = variance_4;
    scale_6 = ((_e42 + 0.25f) / 0.4166667f);
    let _e53 = scale_6;
    exact = (0.5f * log2(max(_e53, 1f)));
    let _e59 = exact;
    let _e61 = lastLevel_1;
    below_7 = min(floor(_e59), _e61);
    let _e64 = below_7;
    let _e65 = pyramidVariance(_e64);
    low_8 = _e65;
    let _e67 = below_7;
    let _e70 = pyramidVariance((_e67 + 1f));
    high_3 = _e70;
    let _e72 = below_7;
    let _e73 = variance_4;
    let _e74 = low_8;
    let _e76 = high_3;
    let _e77 = low_8;
    let _e84 = lastLevel_1;
    return min((_e72 + clamp(((_e73 - _e74) / (_e76 - _e77)), 0f, 1f)), _e84);
}

fn normalIntegral(x_30: f32) -> f32 {
    var x_31: f32;

    x_31 = x_30;
    let _e44 = x_31;
    return (1f / (1f + exp((-1.702f * _e44))));
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
    let _e45 = sigma_11;
    inverse = (1f / max(_e45, 0.25f));
    let _e50 = size_24;
    let _e52 = at_26;
    let _e55 = inverse;
    let _e57 = normalIntegral(((_e50.x - _e52.x) * _e55));
    let _e58 = at_26;
    let _e61 = inverse;
    let _e63 = normalIntegral((-(_e58.x) * _e61));
    x_32 = (_e57 - _e63);
    let _e66 = size_24;
    let _e68 = at_26;
    let _e71 = inverse;
    let _e73 = normalIntegral(((_e66.y - _e68.y) * _e71));
    let _e74 = at_26;
    let _e77 = inverse;
    let _e79 = normalIntegral((-(_e74.y) * _e77));
    y_12 = (_e73 - _e79);
    let _e82 = x_32;
    let _e83 = y_12;
    return clamp((_e82 * _e83), 0f, 1f);
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
    let _e48 = inside_4;
    let _e49 = inner_5;
    offset = (_e48 * _e49);
    let _e52 = outside_1;
    let _e53 = sigma_13;
    angle_4 = (_e52 * _e53);
    let _e56 = angle_4;
    let _e57 = angle_4;
    let _e60 = offset;
    let _e62 = outside_1;
    let _e64 = carried_1;
    let _e65 = sigma_13;
    let _e69 = offset;
    let _e70 = offset;
    return (((_e56 * _e57) + (((2f * _e60) * _e62) * min(_e64, _e65))) + (_e69 * _e70));
}

fn pixelsPerRadian(focal: f32, cosine: f32) -> f32 {
    var focal_1: f32;
    var cosine_1: f32;

    focal_1 = focal;
    cosine_1 = cosine;
    let _e42 = focal_1;
    let _e43 = cosine_1;
    let _e44 = cosine_1;
    return (_e42 / (_e43 * sqrt(_e44)));
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
    let _e48 = met_6;
    ends = (_e48.metres >= 0f);
    let _e53 = ends;
    if _e53 {
        let _e54 = origin_17;
        let _e55 = met_6;
        let _e57 = lobe_9;
        local_104 = (_e54 + (_e55.metres * _e57.direction));
    } else {
        let _e61 = lobe_9;
        local_104 = _e61.direction;
    }
    let _e64 = local_104;
    place = _e64;
    let _e66 = view_32;
    let _e68 = place;
    let _e69 = ends;
    if _e69 {
        local_105 = 1f;
    } else {
        local_105 = 0f;
    }
    let _e73 = local_105;
    clip_4 = (_e66.clipFromWorld * vec4<f32>(_e68.x, _e68.y, _e68.z, _e73));
    let _e85 = met_6;
    let _e87 = clip_4;
    if (_e85.seen && (_e87.w > 0f)) {
        {
            let _e92 = ends;
            if _e92 {
                let _e93 = place;
                let _e94 = view_32;
                local_106 = (_e93 - _e94.eye);
            } else {
                let _e97 = lobe_9;
                local_106 = _e97.direction;
            }
            let _e100 = local_106;
            fromEye = _e100;
            let _e102 = fromEye;
            range_2 = length(_e102);
            let _e105 = lobe_9;
            let _e107 = lobe_9;
            let _e109 = lobe_9;
            let _e111 = inside_6;
            let _e112 = met_6;
            let _e114 = lobeVariance(_e105.sigma, _e107.carried, _e109.inner, _e111, _e112.metres);
            let _e115 = met_6;
            let _e117 = met_6;
            metres = sqrt((_e114 + (_e115.behind * _e117.behind)));
            let _e123 = ends;
            if _e123 {
                let _e124 = metres;
                let _e125 = range_2;
                local_107 = (_e124 / _e125);
            } else {
                let _e127 = lobe_9;
                local_107 = _e127.sigma;
            }
            let _e130 = local_107;
            let _e131 = view_32;
            let _e133 = clip_4;
            let _e135 = range_2;
            let _e139 = pixelsPerRadian(_e131.focal, min((_e133.w / _e135), 1f));
            pixels = (_e130 * _e139);
            let _e142 = clip_4;
            let _e143 = view_32;
            let _e145 = scenePixel(_e142, _e143.size);
            at_27 = _e145;
            let _e147 = at_27;
            let _e149 = at_27;
            let _e150 = view_32;
            outside_2 = max(max(-(_e147), (_e149 - _e150.size)), vec2(0f));
            let _e158 = outside_2;
            let _e159 = outside_2;
            far_1 = dot(_e158, _e159);
            let _e162 = ends;
            if _e162 {
                let _e165 = far_1;
                let _e167 = view_32;
                let _e170 = view_32;
                local_108 = exp(((-0.5f * _e165) / (_e167.size.y * _e170.size.y)));
            } else {
                let _e176 = at_27;
                let _e177 = view_32;
                let _e179 = pixels;
                let _e180 = pyramidCoverage(_e176, _e177.size, _e179);
                local_108 = _e180;
            }
            let _e182 = local_108;
            share_5 = _e182;
            let _e183 = share_5;
            if (_e183 > 0f) {
                {
                    let _e186 = at_27;
                    let _e187 = pixels;
                    let _e188 = pixels;
                    let _e190 = far_1;
                    let _e192 = engineSceneColor(_e186, ((_e187 * _e188) + _e190));
                    shown = _e192;
                    let _e194 = share_5;
                    let _e196 = shown;
                    share_5 = (_e194 * min((2f * _e196.w), 1f));
                    let _e202 = shown;
                    if (_e202.w > 0f) {
                        let _e206 = shown;
                        let _e208 = shown;
                        let _e210 = shown;
                        let _e213 = shown;
                        local_109 = (vec3<f32>(_e206.x, _e208.y, _e210.z) / vec3(_e213.w));
                    } else {
                        local_109 = vec3(0f);
                    }
                    let _e220 = local_109;
                    near_1 = _e220;
                }
            }
        }
    }
    let _e221 = share_5;
    if (_e221 >= 0.999f) {
        let _e224 = near_1;
        local_110 = _e224;
    } else {
        let _e225 = lobe_9;
        let _e227 = lobe_9;
        let _e229 = engineEnvironment(_e225.direction, _e227.sigma);
        let _e230 = near_1;
        let _e231 = share_5;
        local_110 = mix(_e229, _e230, vec3(_e231));
    }
    let _e235 = local_110;
    return _e235;
}

fn engineFaceEnergy(cosTheta_53: f32, alpha_102: f32, eta_64: f32) -> InterfaceEnergy {
    var cosTheta_54: f32;
    var alpha_103: f32;
    var eta_65: f32;
    var smoothly: InterfaceEnergy;

    cosTheta_54 = cosTheta_53;
    alpha_103 = alpha_102;
    eta_65 = eta_64;
    let _e45 = alpha_103;
    if (_e45 < SMOOTH_ALPHA) {
        {
            let _e49 = cosTheta_54;
            let _e50 = eta_65;
            let _e51 = fresnelTransmittedAt(_e49, _e50);
            smoothly.transmitted = _e51;
            let _e54 = smoothly;
            smoothly.reflected = (1f - _e54.transmitted);
            let _e57 = smoothly;
            return _e57;
        }
    }
    let _e58 = cosTheta_54;
    let _e59 = alpha_103;
    let _e60 = eta_65;
    let _e61 = interfaceEnergyCoordinate(_e58, _e59, _e60);
    let _e62 = engineInterfaceEnergy(_e61);
    let _e63 = interfaceEnergy(_e62);
    return _e63;
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
    let _e45 = face_11;
    let _e47 = face_11;
    cosTheta_55 = dot(_e45.wo, _e47.n);
    let _e51 = cosTheta_55;
    let _e52 = face_11;
    let _e54 = ior_1;
    let _e55 = engineFaceEnergy(_e51, _e52.alpha, _e54);
    energy_3 = _e55.reflected;
    let _e61 = face_11;
    if (_e61.alpha >= SMOOTH_ALPHA) {
        let _e64 = cosTheta_55;
        let _e65 = face_11;
        let _e67 = ior_1;
        let _e68 = fresnelNormalIncidence(_e67);
        let _e69 = energy_3;
        let _e70 = edgeShare(_e68, _e69);
        let _e71 = lobeCoordinate(_e64, _e65.alpha, _e70);
        let _e72 = engineReflectionLobe(_e71);
        texel_9 = _e72;
    }
    let _e76 = cosTheta_55;
    let _e78 = face_11;
    let _e81 = face_11;
    let _e84 = face_11;
    let _e86 = texel_9;
    let _e88 = lobeDirection((((2f * _e76) * _e78.n) - _e81.wo), _e84.n, _e86.x);
    lobe_10.direction = _e88;
    let _e90 = texel_9;
    let _e92 = texel_9;
    let _e95 = face_11;
    let _e98 = face_11;
    let _e102 = face_11;
    lobe_10.sigma = sqrt(((((_e90.y * _e92.y) * _e95.alpha) * _e98.alpha) + (4f * _e102.turn)));
    let _e108 = energy_3;
    lobe_10.weight = _e108;
    lobe_10.inner = 0f;
    lobe_10.carried = 0f;
    let _e113 = face_11;
    let _e115 = lobe_10;
    let _e117 = view_34;
    let _e118 = sceneIntersection(_e113.position, _e115.direction, _e117);
    met_7 = _e118;
    let _e120 = energy_3;
    let _e121 = lobe_10;
    let _e122 = face_11;
    let _e125 = met_7;
    let _e126 = view_34;
    let _e127 = lobeRadiance(_e121, _e122.position, 0f, _e125, _e126);
    return (_e120 * _e127);
}

fn internalScatteringLossGgx() -> InternalScatteringLoss {
    var k_26: InternalScatteringLoss;

    k_26.linear = 0.635f;
    k_26.constant = 0.254f;
    k_26.thin = 1.078f;
    k_26.passes = 0.3f;
    let _e48 = k_26;
    return _e48;
}

fn internalScatteringLossBeckmann() -> InternalScatteringLoss {
    var k_27: InternalScatteringLoss;

    k_27.linear = 0.201f;
    k_27.constant = 1.555f;
    k_27.thin = 0.565f;
    k_27.passes = 0f;
    let _e48 = k_27;
    return _e48;
}

fn internalScatteringPasses(ior_2: f32) -> f32 {
    var ior_3: f32;
    var eta_66: f32;
    var passes: f32;
    var local_111: f32;

    ior_3 = ior_2;
    let _e41 = ior_3;
    let _e43 = ior_3;
    eta_66 = max(_e41, (1f / _e43));
    let _e49 = eta_66;
    let _e50 = fresnelTransmittedAt(0.355051f, _e49);
    let _e54 = eta_66;
    let _e55 = fresnelTransmittedAt(0.844949f, _e54);
    passes = ((0.363917f * _e50) + (0.636083f * _e55));
    let _e59 = ior_3;
    if (_e59 > 1f) {
        let _e62 = passes;
        let _e63 = ior_3;
        let _e64 = ior_3;
        local_111 = (_e62 / (_e63 * _e64));
    } else {
        let _e67 = passes;
        local_111 = _e67;
    }
    let _e69 = local_111;
    return _e69;
}

fn internalScatteringAt(alpha_104: f32, ior_4: f32, k_28: InternalScatteringLoss) -> InternalScattering {
    var alpha_105: f32;
    var ior_5: f32;
    var k_29: InternalScatteringLoss;
    var smoothly_1: f32;
    var alpha2_1: f32;
    var lost_3: f32;
    var w_27: InternalScattering;

    alpha_105 = alpha_104;
    ior_5 = ior_4;
    k_29 = k_28;
    let _e45 = ior_5;
    let _e46 = internalScatteringPasses(_e45);
    smoothly_1 = _e46;
    let _e48 = alpha_105;
    let _e49 = alpha_105;
    alpha2_1 = (_e48 * _e49);
    let _e52 = alpha2_1;
    let _e53 = alpha2_1;
    let _e54 = k_29;
    let _e56 = alpha_105;
    let _e59 = k_29;
    let _e64 = k_29;
    let _e66 = alpha_105;
    let _e68 = smoothly_1;
    lost_3 = ((_e52 / ((_e53 + (_e54.linear * _e56)) + _e59.constant)) * max((1f - ((_e64.thin * _e66) * max((_e68 - 0.4f), 0f))), 0f));
    let _e81 = smoothly_1;
    let _e83 = k_29;
    let _e85 = alpha2_1;
    w_27.passes = (_e81 * (1f - (_e83.passes * _e85)));
    let _e91 = w_27;
    let _e94 = lost_3;
    w_27.back = max(((1f - _e91.passes) - _e94), 0f);
    let _e98 = w_27;
    return _e98;
}

fn internalScatteringConcave(w_28: InternalScattering, again: f32) -> InternalScattering {
    var w_29: InternalScattering;
    var again_1: f32;
    var concave: InternalScattering;

    w_29 = w_28;
    again_1 = again;
    let _e46 = again_1;
    let _e48 = w_29;
    concave.passes = ((1f - _e46) * _e48.passes);
    let _e52 = w_29;
    let _e54 = again_1;
    let _e55 = w_29;
    concave.back = (_e52.back + (_e54 * _e55.passes));
    let _e59 = concave;
    return _e59;
}

fn internalScatteringEscapes(w_30: InternalScattering, way_7: vec3<f32>) -> vec3<f32> {
    var w_31: InternalScattering;
    var way_8: vec3<f32>;

    w_31 = w_30;
    way_8 = way_7;
    let _e43 = w_31;
    let _e45 = way_8;
    let _e49 = w_31;
    let _e51 = way_8;
    let _e54 = w_31;
    return ((_e43.passes * _e45) / max((vec3(1f) - (_e49.back * _e51)), vec3(_e54.passes)));
}

fn engineFaceLobes(cosTheta_56: f32, alpha_106: f32, eta_67: f32) -> FaceLobes {
    var cosTheta_57: f32;
    var alpha_107: f32;
    var eta_68: f32;
    var core_6: vec4<f32> = vec4<f32>(0f, 0f, 1f, 0f);
    var tail_5: vec4<f32> = vec4(0f);
    var at_28: vec3<f32>;
    var lobes_8: FaceLobes;

    cosTheta_57 = cosTheta_56;
    alpha_107 = alpha_106;
    eta_68 = eta_67;
    let _e54 = alpha_107;
    if (_e54 >= SMOOTH_ALPHA) {
        {
            let _e58 = cosTheta_57;
            let _e59 = alpha_107;
            let _e60 = eta_68;
            let _e61 = interfaceLobeCoordinate(0i, 2i, _e58, _e59, _e60);
            at_28 = _e61;
            let _e63 = at_28;
            let _e64 = engineInterfaceLobe(_e63);
            core_6 = _e64;
            let _e65 = at_28;
            let _e71 = engineInterfaceLobe((_e65 + vec3<f32>(0f, 0.5f, 0f)));
            tail_5 = _e71;
        }
    }
    let _e74 = core_6;
    let _e75 = cosTheta_57;
    let _e76 = alpha_107;
    let _e77 = eta_68;
    let _e78 = interfaceLobe(_e74, _e75, _e76, _e77);
    lobes_8.core = _e78;
    let _e80 = tail_5;
    let _e81 = cosTheta_57;
    let _e82 = alpha_107;
    let _e83 = eta_68;
    let _e84 = interfaceLobe(_e80, _e81, _e82, _e83);
    lobes_8.tail = _e84;
    let _e85 = lobes_8;
    return _e85;
}

fn engineEnteringLobe(read_: InterfaceLobe, face_12: GlassFace, ior_6: f32, energy_4: f32) -> InnerLobe {
    var read_1: InterfaceLobe;
    var face_13: GlassFace;
    var ior_7: f32;
    var energy_5: f32;
    var inner_6: InnerLobe;
    var matched: bool;
    var local_112: vec3<f32>;
    var local_113: f32;
    var local_114: f32;

    read_1 = read_;
    face_13 = face_12;
    ior_7 = ior_6;
    energy_5 = energy_4;
    let _e48 = ior_7;
    matched = (abs((_e48 - 1f)) < INDEX_MATCHED);
    let _e55 = matched;
    if _e55 {
        let _e56 = face_13;
        local_112 = -(_e56.wo);
    } else {
        let _e59 = face_13;
        let _e61 = face_13;
        let _e63 = read_1;
        let _e65 = interfaceLobeDirection(_e59.wo, _e61.n, _e63.angle);
        local_112 = _e65;
    }
    let _e67 = local_112;
    inner_6.direction = _e67;
    let _e69 = matched;
    if _e69 {
        local_113 = 0f;
    } else {
        let _e71 = read_1;
        local_113 = _e71.sigma;
    }
    let _e74 = local_113;
    inner_6.sigma = _e74;
    let _e76 = read_1;
    let _e78 = matched;
    if _e78 {
        local_114 = 1f;
    } else {
        let _e80 = energy_5;
        local_114 = _e80;
    }
    let _e82 = local_114;
    inner_6.weight = (_e76.weight * _e82);
    let _e84 = inner_6;
    return _e84;
}

fn engineLeavingPair(inner_7: InnerLobe, core_7: bool, s_19: ExitSurface, k_30: Widening) -> ComposedPair {
    var inner_8: InnerLobe;
    var core_8: bool;
    var s_20: ExitSurface;
    var k_31: Widening;
    var view_35: ExitView;
    var cosTheta_58: f32;
    var local_115: f32;
    var energy_6: f32;
    var lobes_9: FaceLobes;
    var one_1: ComposedPair;

    inner_8 = inner_7;
    core_8 = core_7;
    s_20 = s_19;
    k_31 = k_30;
    let _e47 = inner_8;
    let _e48 = core_8;
    let _e49 = s_20;
    let _e50 = k_31;
    let _e51 = seeExit(_e47, _e48, _e49, _e50);
    view_35 = _e51;
    let _e53 = view_35;
    cosTheta_58 = max(_e53.cosTheta, 0f);
    let _e58 = s_20;
    if (abs((_e58.eta - 1f)) < INDEX_MATCHED) {
        local_115 = 1f;
    } else {
        let _e65 = cosTheta_58;
        let _e66 = view_35;
        let _e68 = s_20;
        let _e70 = engineFaceEnergy(_e65, _e66.alphaEnergy, _e68.eta);
        local_115 = _e70.transmitted;
    }
    let _e73 = local_115;
    energy_6 = _e73;
    let _e75 = cosTheta_58;
    let _e76 = view_35;
    let _e78 = s_20;
    let _e80 = engineFaceLobes(_e75, _e76.alphaShape, _e78.eta);
    lobes_9 = _e80;
    let _e82 = view_35;
    if (_e82.alphaShape < SMOOTH_ALPHA) {
        {
            let _e87 = inner_8;
            let _e88 = view_35;
            let _e89 = s_20;
            let _e90 = lobes_9;
            let _e93 = lobes_9;
            let _e97 = energy_6;
            let _e98 = composeLobe(_e87, _e88, _e89, _e90.core.angle, _e93.core.sigma, 1f, _e97);
            one_1.core = _e98;
            let _e100 = one_1;
            one_1.rest = _e100.core;
            one_1.rest.weight = 0f;
            let _e105 = one_1;
            return _e105;
        }
    }
    let _e106 = inner_8;
    let _e107 = view_35;
    let _e108 = s_20;
    let _e109 = lobes_9;
    let _e112 = lobes_9;
    let _e115 = lobes_9;
    let _e118 = energy_6;
    let _e119 = composeLobe(_e106, _e107, _e108, _e109.core.angle, _e112.core.sigma, _e115.core.weight, _e118);
    let _e120 = inner_8;
    let _e121 = view_35;
    let _e122 = s_20;
    let _e123 = lobes_9;
    let _e126 = lobes_9;
    let _e129 = lobes_9;
    let _e132 = energy_6;
    let _e133 = composeLobe(_e120, _e121, _e122, _e123.tail.angle, _e126.tail.sigma, _e129.tail.weight, _e132);
    let _e134 = view_35;
    let _e135 = composedPair(_e119, _e133, _e134);
    return _e135;
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
    let _e53 = inner_10;
    let _e55 = e_9;
    cosTheta_59 = max(dot(_e53.direction, _e55.surface.n), 0f);
    let _e62 = cosTheta_59;
    let _e63 = body_3;
    let _e65 = e_9;
    let _e68 = engineFaceEnergy(_e62, _e63.backAlpha, _e65.surface.eta);
    own_2 = _e68;
    let _e72 = passed_1;
    w_32.passes = _e72;
    let _e74 = own_2;
    let _e76 = own_2;
    let _e79 = passed_1;
    w_32.back = clamp(((_e74.transmitted + _e76.reflected) - _e79), 0f, 0.99f);
    let _e84 = e_9;
    let _e87 = body_3;
    way_9 = exp((-(_e84.path) * _e87.attenuation));
    let _e92 = entered_1;
    let _e94 = w_32;
    let _e97 = way_9;
    let _e99 = w_32;
    let _e100 = way_9;
    let _e101 = internalScatteringEscapes(_e99, _e100);
    weight_3 = ((((SCATTERED_SEEN * _e92) * _e94.back) * _e97) * _e101);
    let _e104 = weight_3;
    let _e106 = weight_3;
    let _e108 = weight_3;
    if (max(_e104.x, max(_e106.y, _e108.z)) < SCATTERED_LEAST) {
        return vec3(0f);
    }
    let _e115 = inner_10;
    let _e118 = cosTheta_59;
    let _e120 = e_9;
    reflected = (_e115.direction - ((2f * _e118) * _e120.surface.n));
    let _e126 = body_3;
    let _e128 = body_3;
    q_2 = clamp((_e126.thickness * _e128.curvature), 0f, 2f);
    let _e135 = face_15;
    let _e137 = e_9;
    let _e141 = cosTheta_59;
    let _e143 = reflected;
    let _e147 = q_2;
    near_2 = normalize(mix(_e135.n, (_e137.surface.n + ((2f * _e141) * _e143)), vec3((0.5f * _e147))));
    let _e153 = reflected;
    let _e155 = near_2;
    let _e157 = e_9;
    let _e160 = refractAbout(-(_e153), -(_e155), _e157.surface.eta);
    outward_3 = _e160;
    let _e162 = inner_10;
    let _e164 = inner_10;
    let _e168 = body_3;
    let _e171 = body_3;
    let _e176 = body_3;
    spread_5 = (sqrt(((_e162.sigma * _e164.sigma) + ((4f * _e168.backAlpha) * _e171.backAlpha))) * _e176.ior);
    let _e180 = outward_3;
    let _e181 = outward_3;
    if (dot(_e180, _e181) > 0f) {
        let _e185 = outward_3;
        local_116 = _e185;
    } else {
        let _e186 = near_2;
        local_116 = _e186;
    }
    let _e188 = local_116;
    direction_26 = _e188;
    let _e190 = weight_3;
    let _e191 = direction_26;
    let _e192 = spread_5;
    let _e195 = engineEnvironment(_e191, min(_e192, 0.606f));
    return (_e190 * _e195);
}

fn enterGlass(face_16: GlassFace, ior_8: f32) -> Entering {
    var face_17: GlassFace;
    var ior_9: f32;
    var e_10: Entering;
    var cosTheta_60: f32;
    var lobes_10: FaceLobes;

    face_17 = face_16;
    ior_9 = ior_8;
    let _e46 = face_17;
    let _e48 = face_17;
    cosTheta_60 = dot(_e46.wo, _e48.n);
    let _e53 = cosTheta_60;
    let _e54 = face_17;
    let _e56 = ior_9;
    let _e57 = engineFaceEnergy(_e53, _e54.alpha, _e56);
    e_10.energy = _e57.transmitted;
    let _e59 = cosTheta_60;
    let _e60 = face_17;
    let _e62 = ior_9;
    let _e63 = engineFaceLobes(_e59, _e60.alpha, _e62);
    lobes_10 = _e63;
    let _e66 = lobes_10;
    let _e68 = face_17;
    let _e69 = ior_9;
    let _e70 = e_10;
    let _e72 = engineEnteringLobe(_e66.core, _e68, _e69, _e70.energy);
    e_10.core = _e72;
    let _e74 = lobes_10;
    let _e76 = face_17;
    let _e77 = ior_9;
    let _e78 = e_10;
    let _e80 = engineEnteringLobe(_e74.tail, _e76, _e77, _e78.energy);
    e_10.tail = _e80;
    let _e81 = e_10;
    return _e81;
}

fn leaveGlass(face_18: GlassFace, body_4: ConvexBody, e_11: Entering, coreExit: ConvexExit, tailExit: ConvexExit, k_32: Widening) -> Leaving {
    var face_19: GlassFace;
    var body_5: ConvexBody;
    var e_12: Entering;
    var coreExit_1: ConvexExit;
    var tailExit_1: ConvexExit;
    var k_33: Widening;
    var leaving: Leaving;
    var local_117: f32;
    var bent: f32;

    face_19 = face_18;
    body_5 = body_4;
    e_12 = e_11;
    coreExit_1 = coreExit;
    tailExit_1 = tailExit;
    k_33 = k_32;
    let _e55 = e_12;
    let _e58 = coreExit_1;
    let _e60 = k_33;
    let _e61 = engineLeavingPair(_e55.core, true, _e58.surface, _e60);
    leaving.pair = _e61;
    let _e63 = e_12;
    if (_e63.core.weight > 0f) {
        let _e68 = leaving;
        let _e72 = leaving;
        let _e77 = e_12;
        local_117 = ((_e68.pair.core.weight + _e72.pair.rest.weight) / _e77.core.weight);
    } else {
        local_117 = 0f;
    }
    let _e83 = local_117;
    leaving.passed = _e83;
    let _e84 = e_12;
    if (_e84.tail.weight > 0f) {
        let _e90 = leaving;
        let _e92 = e_12;
        let _e95 = tailExit_1;
        let _e97 = k_33;
        let _e98 = engineLeavingPair(_e92.tail, false, _e95.surface, _e97);
        let _e99 = mergePairs(_e90.pair, _e98);
        leaving.pair = _e99;
    }
    let _e103 = body_5;
    bent = (2f * (1f - (1f / _e103.ior)));
    let _e112 = leaving;
    let _e116 = leaving;
    let _e121 = bent;
    let _e122 = bent;
    let _e124 = face_19;
    leaving.pair.core.sigma = sqrt(((_e112.pair.core.sigma * _e116.pair.core.sigma) + ((_e121 * _e122) * _e124.turn)));
    let _e129 = leaving;
    return _e129;
}

fn pairRadiance(pair_3: ComposedPair, origin_18: vec3<f32>, inside_7: f32, view_36: SceneView) -> vec3<f32> {
    var pair_4: ComposedPair;
    var origin_19: vec3<f32>;
    var inside_8: f32;
    var view_37: SceneView;
    var met_8: SceneIntersection;
    var sum_14: vec3<f32> = vec3(0f);
    var lobe_11: ComposedLobe;
    var which_8: i32 = 0i;

    pair_4 = pair_3;
    origin_19 = origin_18;
    inside_8 = inside_7;
    view_37 = view_36;
    let _e49 = origin_19;
    let _e50 = pair_4;
    let _e53 = view_37;
    let _e54 = sceneIntersection(_e49, _e50.core.direction, _e53);
    met_8 = _e54;
    let _e59 = pair_4;
    lobe_11 = _e59.core;
    loop {
        let _e64 = which_8;
        let _e67 = which_8;
        let _e70 = lobe_11;
        if !(((_e64 < 2i) && ((_e67 == 0i) || (_e70.weight > 0f)))) {
            break;
        }
        {
            let _e80 = sum_14;
            let _e81 = lobe_11;
            let _e83 = lobe_11;
            let _e84 = origin_19;
            let _e85 = inside_8;
            let _e86 = met_8;
            let _e87 = view_37;
            let _e88 = lobeRadiance(_e83, _e84, _e85, _e86, _e87);
            sum_14 = (_e80 + (_e81.weight * _e88));
            let _e91 = pair_4;
            lobe_11 = _e91.rest;
        }
        continuing {
            let _e77 = which_8;
            which_8 = (_e77 + 1i);
        }
    }
    let _e93 = sum_14;
    return _e93;
}

fn refractThrough(face_20: GlassFace, body_6: ConvexBody, e_13: Entering, origin_20: vec3<f32>, coreExit_2: ConvexExit, tailExit_2: ConvexExit, view_38: SceneView, k_34: Widening) -> vec3<f32> {
    var face_21: GlassFace;
    var body_7: ConvexBody;
    var e_14: Entering;
    var origin_21: vec3<f32>;
    var coreExit_3: ConvexExit;
    var tailExit_3: ConvexExit;
    var view_39: SceneView;
    var k_35: Widening;
    var left_2: Leaving;
    var sum_15: vec3<f32>;

    face_21 = face_20;
    body_7 = body_6;
    e_14 = e_13;
    origin_21 = origin_20;
    coreExit_3 = coreExit_2;
    tailExit_3 = tailExit_2;
    view_39 = view_38;
    k_35 = k_34;
    let _e57 = face_21;
    let _e58 = body_7;
    let _e59 = e_14;
    let _e60 = coreExit_3;
    let _e61 = tailExit_3;
    let _e62 = k_35;
    let _e63 = leaveGlass(_e57, _e58, _e59, _e60, _e61, _e62);
    left_2 = _e63;
    let _e65 = left_2;
    let _e67 = origin_21;
    let _e68 = coreExit_3;
    let _e70 = view_39;
    let _e71 = pairRadiance(_e65.pair, _e67, _e68.path, _e70);
    sum_15 = _e71;
    let _e73 = sum_15;
    let _e74 = coreExit_3;
    let _e77 = body_7;
    let _e82 = face_21;
    let _e83 = body_7;
    let _e84 = e_14;
    let _e86 = e_14;
    let _e88 = coreExit_3;
    let _e89 = left_2;
    let _e91 = internallyReflected(_e82, _e83, _e84.core, _e86.energy, _e88, _e89.passed);
    return ((_e73 * exp((-(_e74.path) * _e77.attenuation))) + _e91);
}

fn refractConvex(face_22: GlassFace, body_8: ConvexBody, view_40: SceneView, k_36: Widening) -> vec3<f32> {
    var face_23: GlassFace;
    var body_9: ConvexBody;
    var view_41: SceneView;
    var k_37: Widening;
    var e_15: Entering;
    var core_9: ConvexExit;
    var origin_22: vec3<f32>;

    face_23 = face_22;
    body_9 = body_8;
    view_41 = view_40;
    k_37 = k_36;
    let _e49 = face_23;
    let _e50 = body_9;
    let _e52 = enterGlass(_e49, _e50.ior);
    e_15 = _e52;
    let _e54 = face_23;
    let _e56 = e_15;
    let _e59 = body_9;
    let _e60 = convexExit(_e54.n, _e56.core.direction, _e59);
    core_9 = _e60;
    let _e62 = face_23;
    let _e64 = core_9;
    let _e66 = e_15;
    origin_22 = (_e62.position + (_e64.path * _e66.core.direction));
    let _e72 = face_23;
    let _e73 = body_9;
    let _e74 = e_15;
    let _e75 = origin_22;
    let _e76 = core_9;
    let _e77 = face_23;
    let _e79 = e_15;
    let _e82 = body_9;
    let _e83 = convexExit(_e77.n, _e79.tail.direction, _e82);
    let _e84 = view_41;
    let _e85 = k_37;
    let _e86 = refractThrough(_e72, _e73, _e74, _e75, _e76, _e83, _e84, _e85);
    return _e86;
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
    var k_38: i32 = 0i;
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
    let _e55 = lobe_13;
    way_10.lobe = _e55;
    let _e57 = origin_24;
    way_10.point = _e57;
    let _e59 = lobe_13;
    let _e61 = eta_70;
    let _e62 = noBackFace(_e59.direction, _e61);
    way_10.exit = _e62.exit;
    way_10.found = false;
    let _e66 = lobe_13;
    onward = _e66;
    loop {
        let _e72 = k_38;
        let _e73 = reflections_1;
        if !((_e72 <= _e73)) {
            break;
        }
        {
            let _e79 = way_10;
            let _e81 = onward;
            let _e83 = first_8;
            let _e84 = eta_70;
            let _e85 = which_10;
            let _e86 = view_43;
            let _e87 = backFaceExit(_e79.point, _e81.direction, _e83, _e84, _e85, _e86);
            seen_2 = _e87;
            let _e89 = seen_2;
            if !(_e89.found) {
                break;
            }
            let _e92 = way_10;
            before = _e92.exit.path;
            let _e97 = onward;
            way_10.lobe = _e97;
            let _e99 = seen_2;
            way_10.exit = _e99.exit;
            let _e103 = before;
            let _e104 = seen_2;
            way_10.exit.path = (_e103 + _e104.exit.path);
            let _e109 = way_10;
            let _e111 = seen_2;
            let _e114 = onward;
            way_10.point = (_e109.point + (_e111.exit.path * _e114.direction));
            way_10.found = true;
            let _e120 = onward;
            let _e122 = seen_2;
            cosTheta_61 = dot(_e120.direction, _e122.exit.surface.n);
            let _e128 = k_38;
            let _e129 = reflections_1;
            let _e132 = cosTheta_61;
            let _e135 = cosTheta_61;
            let _e138 = eta_70;
            let _e139 = eta_70;
            if ((_e128 == _e129) || (((1f - _e132) * (1f + _e135)) < (_e138 * _e139))) {
                break;
            }
            let _e143 = seen_2;
            alpha_108 = _e143.exit.surface.alpha;
            let _e149 = onward;
            let _e152 = cosTheta_61;
            let _e154 = seen_2;
            onward.direction = (_e149.direction - ((2f * _e152) * _e154.exit.surface.n));
            let _e161 = onward;
            let _e163 = onward;
            let _e167 = alpha_108;
            let _e169 = alpha_108;
            onward.sigma = sqrt(((_e161.sigma * _e163.sigma) + ((4f * _e167) * _e169)));
            let _e174 = onward;
            let _e176 = cosTheta_61;
            let _e177 = alpha_108;
            let _e178 = eta_70;
            let _e179 = engineFaceEnergy(_e176, _e177, _e178);
            onward.weight = (_e174.weight * _e179.reflected);
            let _e183 = seen_2;
            first_8 = (0.5f * _e183.exit.path);
        }
        continuing {
            let _e76 = k_38;
            k_38 = (_e76 + 1i);
        }
    }
    let _e187 = way_10;
    return _e187;
}

fn convexWayOut(face_24: GlassFace, lobe_14: InnerLobe, body_10: ConvexBody) -> WayOut {
    var face_25: GlassFace;
    var lobe_15: InnerLobe;
    var body_11: ConvexBody;
    var way_11: WayOut;

    face_25 = face_24;
    lobe_15 = lobe_14;
    body_11 = body_10;
    let _e49 = lobe_15;
    way_11.lobe = _e49;
    let _e51 = face_25;
    let _e53 = lobe_15;
    let _e55 = body_11;
    let _e56 = convexExit(_e51.n, _e53.direction, _e55);
    way_11.exit = _e56;
    let _e58 = face_25;
    let _e60 = way_11;
    let _e63 = lobe_15;
    way_11.point = (_e58.position + (_e60.exit.path * _e63.direction));
    way_11.found = false;
    let _e69 = way_11;
    return _e69;
}

fn leavingFaces(layer_2: i32, number: f32) -> FaceLayer {
    var layer_3: i32;
    var number_1: f32;
    var which_11: FaceLayer;

    layer_3 = layer_2;
    number_1 = number;
    let _e47 = layer_3;
    which_11.layer = _e47;
    which_11.side = 1f;
    let _e51 = number_1;
    which_11.number = _e51;
    let _e52 = which_11;
    return _e52;
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
    let _e57 = face_27;
    let _e58 = entered_3;
    let _e60 = body_13;
    let _e61 = convexWayOut(_e57, _e58.core, _e60);
    ways.core = _e61;
    let _e63 = face_27;
    let _e64 = entered_3;
    let _e66 = body_13;
    let _e67 = convexWayOut(_e63, _e64.tail, _e66);
    ways.tail = _e67;
    loop {
        let _e69 = layer_4;
        let _e70 = last_3;
        let _e72 = ways;
        if !(((_e69 <= _e70) && !(_e72.core.found))) {
            break;
        }
        {
            let _e83 = face_27;
            let _e85 = entered_3;
            let _e88 = body_13;
            let _e91 = layer_4;
            let _e92 = number_3;
            let _e93 = leavingFaces(_e91, _e92);
            let _e94 = reflections_3;
            let _e95 = view_45;
            let _e96 = wayOut(_e83.position, _e85.core, (1f / _e88.ior), _e93, _e94, _e95);
            seen_3 = _e96;
            let _e98 = seen_3;
            if _e98.found {
                let _e101 = seen_3;
                ways.core = _e101;
            }
        }
        continuing {
            let _e78 = layer_4;
            layer_4 = (_e78 + 2i);
        }
    }
    let _e102 = ways;
    if _e102.core.found {
        {
            let _e105 = ways;
            core_10 = _e105.core.lobe;
            let _e110 = ways;
            ways.tail = _e110.core;
            let _e115 = entered_3;
            let _e118 = core_10;
            let _e121 = entered_3;
            ways.tail.lobe.direction = normalize(((_e115.tail.direction + _e118.direction) - _e121.core.direction));
            let _e126 = core_10;
            let _e128 = core_10;
            let _e131 = entered_3;
            let _e134 = entered_3;
            widened = ((_e126.sigma * _e128.sigma) - (_e131.core.sigma * _e134.core.sigma));
            let _e143 = entered_3;
            let _e146 = entered_3;
            let _e150 = widened;
            ways.tail.lobe.sigma = sqrt(((_e143.tail.sigma * _e146.tail.sigma) + max(_e150, 0f)));
            let _e158 = entered_3;
            if (_e158.core.weight > 0f) {
                let _e163 = entered_3;
                let _e166 = core_10;
                let _e169 = entered_3;
                local_118 = ((_e163.tail.weight * _e166.weight) / _e169.core.weight);
            } else {
                local_118 = 0f;
            }
            let _e175 = local_118;
            ways.tail.lobe.weight = _e175;
        }
    }
    let _e176 = ways;
    return _e176;
}

fn refractFrontBack(face_28: GlassFace, body_14: ConvexBody, number_4: f32, view_46: SceneView, k_39: Widening) -> vec3<f32> {
    var face_29: GlassFace;
    var body_15: ConvexBody;
    var number_5: f32;
    var view_47: SceneView;
    var k_40: Widening;
    var entered_4: Entering;
    var ways_1: WaysOut;

    face_29 = face_28;
    body_15 = body_14;
    number_5 = number_4;
    view_47 = view_46;
    k_40 = k_39;
    let _e51 = face_29;
    let _e52 = body_15;
    let _e54 = enterGlass(_e51, _e52.ior);
    entered_4 = _e54;
    let _e56 = face_29;
    let _e57 = body_15;
    let _e58 = entered_4;
    let _e59 = number_5;
    let _e61 = view_47;
    let _e62 = waysOut(_e56, _e57, _e58, BACK_FACES, _e59, 1i, _e61);
    ways_1 = _e62;
    let _e65 = ways_1;
    entered_4.core = _e65.core.lobe;
    let _e69 = ways_1;
    entered_4.tail = _e69.tail.lobe;
    let _e72 = face_29;
    let _e73 = body_15;
    let _e74 = entered_4;
    let _e75 = ways_1;
    let _e78 = ways_1;
    let _e81 = ways_1;
    let _e84 = view_47;
    let _e85 = k_40;
    let _e86 = refractThrough(_e72, _e73, _e74, _e75.core.point, _e78.core.exit, _e81.tail.exit, _e84, _e85);
    return _e86;
}

fn lobeSide(direction_27: vec3<f32>) -> vec3<f32> {
    var direction_28: vec3<f32>;
    var level_3: vec3<f32>;
    var s_21: f32;
    var local_119: vec3<f32>;

    direction_28 = direction_27;
    let _e43 = direction_28;
    let _e46 = direction_28;
    level_3 = vec3<f32>(_e43.z, 0f, -(_e46.x));
    let _e51 = level_3;
    let _e52 = level_3;
    s_21 = dot(_e51, _e52);
    let _e55 = s_21;
    if (_e55 > 0f) {
        let _e58 = level_3;
        let _e59 = s_21;
        local_119 = (_e58 * inverseSqrt(_e59));
    } else {
        local_119 = vec3<f32>(1f, 0f, 0f);
    }
    let _e67 = local_119;
    return _e67;
}

fn lobeStratum(direction_29: vec3<f32>, sigma_14: f32, inner_11: f32, carried_2: f32, part_2: vec3<f32>) -> LobeStratum {
    var direction_30: vec3<f32>;
    var sigma_15: f32;
    var inner_12: f32;
    var carried_3: f32;
    var part_3: vec3<f32>;
    var side_4: vec3<f32>;
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
    part_3 = part_2;
    let _e51 = direction_30;
    let _e52 = lobeSide(_e51);
    side_4 = _e52;
    let _e54 = part_3;
    let _e56 = side_4;
    let _e58 = part_3;
    let _e60 = direction_30;
    let _e61 = side_4;
    off_3 = ((_e54.x * _e56) + (_e58.y * cross(_e60, _e61)));
    let _e66 = sigma_15;
    let _e67 = off_3;
    turn_2 = (_e66 * length(_e67));
    let _e73 = turn_2;
    let _e75 = direction_30;
    let _e77 = turn_2;
    if (_e77 > 0f) {
        let _e80 = turn_2;
        let _e82 = turn_2;
        local_120 = (sin(_e80) / _e82);
    } else {
        local_120 = 1f;
    }
    let _e86 = local_120;
    let _e87 = sigma_15;
    let _e89 = off_3;
    p_17.direction = ((cos(_e73) * _e75) + ((_e86 * _e87) * _e89));
    let _e93 = part_3;
    let _e95 = sigma_15;
    p_17.sigma = (_e93.z * _e95);
    let _e97 = sigma_15;
    if (_e97 > 0f) {
        let _e100 = carried_3;
        let _e101 = sigma_15;
        local_121 = clamp((_e100 / _e101), -1f, 1f);
    } else {
        local_121 = 0f;
    }
    let _e109 = local_121;
    together = _e109;
    let _e112 = together;
    let _e113 = inner_12;
    let _e115 = off_3;
    p_17.aside = ((_e112 * _e113) * _e115);
    let _e118 = together;
    let _e119 = together;
    let _e122 = part_3;
    let _e124 = part_3;
    rest_5 = sqrt(max((1f - ((_e118 * _e119) * (1f - (_e122.z * _e124.z)))), 0f));
    let _e135 = rest_5;
    let _e136 = inner_12;
    p_17.inner = (_e135 * _e136);
    let _e139 = rest_5;
    if (_e139 > 0f) {
        let _e142 = together;
        let _e143 = sigma_15;
        let _e145 = part_3;
        let _e148 = part_3;
        let _e151 = rest_5;
        local_122 = ((((_e142 * _e143) * _e145.z) * _e148.z) / _e151);
    } else {
        local_122 = 0f;
    }
    let _e155 = local_122;
    p_17.carried = _e155;
    let _e156 = p_17;
    return _e156;
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
    let _e54 = cosTheta_63;
    let _e58 = tableCoordinate(sqrt(max(_e54, 0f)), THIN_WALL_COSINES);
    let _e59 = alpha_110;
    let _e63 = lobe_17;
    let _e64 = lobes_12;
    let _e65 = blockCoordinate(sqrt(max(_e59, 0f)), THIN_WALL_ALPHAS, _e63, _e64);
    let _e66 = eta_72;
    let _e67 = interfaceEtaAxis(_e66);
    let _e68 = tableCoordinate(_e67, THIN_WALL_SLICES);
    return vec3<f32>(_e58, _e65, _e68);
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
    let _e50 = cosTheta_65;
    c_33 = clamp(_e50, 0f, 1f);
    let _e55 = eta_74;
    if (_e55 < 1f) {
        let _e59 = eta_74;
        local_123 = (1f / max(_e59, 0.01f));
    } else {
        let _e63 = eta_74;
        local_123 = _e63;
    }
    let _e65 = local_123;
    n_52 = _e65;
    let _e67 = n_52;
    let _e70 = n_52;
    let _e74 = c_33;
    let _e75 = n_52;
    let _e76 = fresnelG(_e74, _e75);
    let _e77 = c_33;
    across_14 = (((_e67 - 1f) * (_e70 + 1f)) / max((_e76 + _e77), 0.000000000000000000000000000001f));
    let _e84 = alpha_112;
    let _e86 = across_14;
    let _e88 = c_33;
    let _e89 = c_33;
    let _e91 = alpha_112;
    width_7 = (((1.4142135f * _e84) * _e86) * inverseSqrt(sqrt(((_e88 * _e89) + max(_e91, 0.000000000001f)))));
    let _e99 = width_7;
    let _e102 = width_7;
    return (_e99 / (1f + (2f * _e102)));
}

fn thinWallEnergy(texel_10: vec4<f32>) -> ThinWallEnergy {
    var texel_11: vec4<f32>;
    var e_16: ThinWallEnergy;

    texel_11 = texel_10;
    let _e48 = texel_11;
    e_16.transmitted = _e48.x;
    let _e51 = texel_11;
    e_16.reflectedFirst = _e51.y;
    let _e54 = texel_11;
    e_16.reflectedLater = _e54.z;
    let _e56 = e_16;
    return _e56;
}

fn thinWallLaterSpread(eta_75: f32) -> f32 {
    var eta_76: f32;
    var local_124: f32;
    var n_53: f32;

    eta_76 = eta_75;
    let _e46 = eta_76;
    if (_e46 < 1f) {
        let _e50 = eta_76;
        local_124 = (1f / max(_e50, 0.01f));
    } else {
        let _e54 = eta_76;
        local_124 = _e54;
    }
    let _e56 = local_124;
    n_53 = _e56;
    let _e58 = n_53;
    let _e59 = n_53;
    let _e62 = n_53;
    let _e66 = n_53;
    return sqrt(((_e58 * _e59) + ((0.5f * (_e62 - 1f)) * (_e66 - 1f))));
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
    let _e52 = cosTheta_67;
    c_34 = clamp(_e52, 0f, 1f);
    let _e57 = c_34;
    let _e58 = alpha_114;
    let _e62 = eta_78;
    let _e63 = thinWallWidth(_e57, clamp(_e58, 0f, 1f), _e62);
    width_8 = _e63;
    let _e68 = c_34;
    let _e71 = c_34;
    let _e75 = c_34;
    let _e77 = texel_13;
    let _e79 = width_8;
    lobe_18.angle = (atan2(sqrt(((1f - _e68) * (1f + _e71))), _e75) + (_e77.x * _e79));
    let _e83 = texel_13;
    let _e85 = width_8;
    lobe_18.sigma = (_e83.y * _e85);
    let _e88 = texel_13;
    lobe_18.weight = _e88.z;
    let _e90 = lobe_18;
    return _e90;
}

fn lobeOnward(lobe_19: ComposedLobe) -> InnerLobe {
    var lobe_20: ComposedLobe;
    var onward_1: InnerLobe;

    lobe_20 = lobe_19;
    let _e49 = lobe_20;
    onward_1.direction = _e49.direction;
    let _e52 = lobe_20;
    onward_1.sigma = _e52.sigma;
    let _e55 = lobe_20;
    onward_1.weight = _e55.weight;
    let _e57 = onward_1;
    return _e57;
}

fn throughSecondBody(pair_5: ComposedPair, origin_25: vec3<f32>, inside_9: f32, body_16: ConvexBody, view_48: SceneView, k_41: Widening) -> SecondBody {
    var pair_6: ComposedPair;
    var origin_26: vec3<f32>;
    var inside_10: f32;
    var body_17: ConvexBody;
    var view_49: SceneView;
    var k_42: Widening;
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
    k_42 = k_41;
    let _e59 = pair_6;
    second_1.pair = _e59;
    let _e61 = origin_26;
    second_1.origin = _e61;
    let _e63 = inside_10;
    second_1.inside = _e63;
    second_1.passed = vec3(1f);
    second_1.reflected = vec3(0f);
    let _e72 = leavingFaces(SECOND_FRONTS, -1f);
    fronts = _e72;
    fronts.side = -1f;
    let _e77 = origin_26;
    let _e78 = pair_6;
    let _e82 = body_17;
    let _e84 = fronts;
    let _e85 = view_49;
    let _e86 = backFaceExit(_e77, _e78.core.direction, 0f, _e82.ior, _e84, _e85);
    front_1 = _e86;
    let _e88 = front_1;
    if !(_e88.found) {
        let _e91 = second_1;
        return _e91;
    }
    let _e92 = pair_6;
    let _e94 = lobeOnward(_e92.core);
    outer = _e94;
    let _e96 = outer;
    let _e98 = front_1;
    let _e101 = k_42;
    let _e102 = engineLeavingPair(_e96, true, _e98.exit.surface, _e101);
    entered_5 = _e102;
    let _e104 = entered_5;
    let _e106 = entered_5;
    let _e108 = mergeLobes(_e104.core, _e106.rest);
    let _e109 = lobeOnward(_e108);
    inner_13 = _e109;
    let _e111 = origin_26;
    let _e112 = front_1;
    let _e115 = outer;
    point_4 = (_e111 + (_e112.exit.path * _e115.direction));
    let _e120 = point_4;
    let _e121 = inner_13;
    let _e123 = body_17;
    let _e126 = front_1;
    let _e128 = leavingFaces(SECOND_BACKS, _e126.number);
    let _e129 = view_49;
    let _e130 = wayOut(_e120, _e121, (1f / _e123.ior), _e128, REFLECTIONS_INSIDE, _e129);
    way_12 = _e130;
    let _e132 = way_12;
    if !(_e132.found) {
        let _e135 = second_1;
        return _e135;
    }
    let _e136 = way_12;
    let _e139 = way_12;
    let _e142 = k_42;
    let _e143 = engineLeavingPair(_e136.lobe, true, _e139.exit.surface, _e142);
    beyond_1 = _e143;
    let _e146 = front_1;
    let _e149 = way_12;
    let _e152 = body_17;
    second_1.inside = (_e146.exit.path + (_e149.exit.path / _e152.ior));
    let _e158 = outer;
    beyond_1.core.inner = _e158.sigma;
    let _e162 = outer;
    beyond_1.rest.inner = _e162.sigma;
    let _e164 = outer;
    if (_e164.weight > 0f) {
        let _e168 = beyond_1;
        let _e171 = beyond_1;
        let _e175 = outer;
        local_125 = ((_e168.core.weight + _e171.rest.weight) / _e175.weight);
    } else {
        local_125 = 0f;
    }
    let _e180 = local_125;
    passed_2 = _e180;
    let _e182 = pair_6;
    aside = _e182.rest;
    let _e186 = pair_6;
    let _e189 = beyond_1;
    let _e193 = pair_6;
    aside.direction = normalize(((_e186.rest.direction + _e189.core.direction) - _e193.core.direction));
    let _e199 = aside;
    let _e201 = passed_2;
    aside.weight = (_e199.weight * _e201);
    let _e204 = beyond_1;
    let _e206 = aside;
    let _e207 = mergeLobes(_e204.rest, _e206);
    beyond_1.rest = _e207;
    let _e209 = beyond_1;
    second_1.pair = _e209;
    let _e211 = way_12;
    second_1.origin = _e211.point;
    let _e214 = way_12;
    let _e218 = body_17;
    second_1.passed = exp((-(_e214.exit.path) * _e218.attenuation));
    let _e222 = outer;
    let _e224 = front_1;
    cosTheta_68 = dot(_e222.direction, _e224.exit.surface.n);
    let _e230 = front_1;
    alpha_115 = _e230.exit.surface.alpha;
    let _e235 = pair_6;
    let _e238 = pair_6;
    let _e242 = cosTheta_68;
    let _e243 = alpha_115;
    let _e244 = body_17;
    let _e246 = engineFaceEnergy(_e242, _e243, _e244.ior);
    weight_4 = ((_e235.core.weight + _e238.rest.weight) * _e246.reflected);
    let _e250 = outer;
    let _e253 = cosTheta_68;
    let _e255 = front_1;
    mirrored = (_e250.direction - ((2f * _e253) * _e255.exit.surface.n));
    let _e263 = weight_4;
    let _e264 = mirrored;
    let _e265 = outer;
    let _e267 = outer;
    let _e271 = alpha_115;
    let _e273 = alpha_115;
    let _e279 = engineEnvironment(_e264, min(sqrt(((_e265.sigma * _e267.sigma) + ((4f * _e271) * _e273))), 0.606f));
    second_1.reflected = (_e263 * _e279);
    let _e281 = second_1;
    return _e281;
}

fn refractTwoPairs(face_30: GlassFace, body_18: ConvexBody, number_6: f32, view_50: SceneView, k_43: Widening) -> vec3<f32> {
    var face_31: GlassFace;
    var body_19: ConvexBody;
    var number_7: f32;
    var view_51: SceneView;
    var k_44: Widening;
    var entered_6: Entering;
    var ways_2: WaysOut;
    var exit_1: ConvexExit;
    var left_3: Leaving;
    var second_2: SecondBody;
    var sum_16: vec3<f32>;

    face_31 = face_30;
    body_19 = body_18;
    number_7 = number_6;
    view_51 = view_50;
    k_44 = k_43;
    let _e55 = face_31;
    let _e56 = body_19;
    let _e58 = enterGlass(_e55, _e56.ior);
    entered_6 = _e58;
    let _e60 = face_31;
    let _e61 = body_19;
    let _e62 = entered_6;
    let _e63 = number_7;
    let _e64 = view_51;
    let _e65 = waysOut(_e60, _e61, _e62, SECOND_BACKS, _e63, REFLECTIONS_INSIDE, _e64);
    ways_2 = _e65;
    let _e68 = ways_2;
    entered_6.core = _e68.core.lobe;
    let _e72 = ways_2;
    entered_6.tail = _e72.tail.lobe;
    let _e75 = ways_2;
    exit_1 = _e75.core.exit;
    let _e79 = face_31;
    let _e80 = body_19;
    let _e81 = entered_6;
    let _e82 = exit_1;
    let _e83 = ways_2;
    let _e86 = k_44;
    let _e87 = leaveGlass(_e79, _e80, _e81, _e82, _e83.tail.exit, _e86);
    left_3 = _e87;
    let _e89 = left_3;
    let _e91 = ways_2;
    let _e94 = exit_1;
    let _e96 = body_19;
    let _e97 = view_51;
    let _e98 = k_44;
    let _e99 = throughSecondBody(_e89.pair, _e91.core.point, _e94.path, _e96, _e97, _e98);
    second_2 = _e99;
    let _e101 = second_2;
    let _e103 = second_2;
    let _e105 = second_2;
    let _e107 = second_2;
    let _e109 = view_51;
    let _e110 = pairRadiance(_e103.pair, _e105.origin, _e107.inside, _e109);
    let _e112 = second_2;
    sum_16 = ((_e101.passed * _e110) + _e112.reflected);
    let _e116 = sum_16;
    let _e117 = exit_1;
    let _e120 = body_19;
    let _e125 = face_31;
    let _e126 = body_19;
    let _e127 = entered_6;
    let _e129 = entered_6;
    let _e131 = exit_1;
    let _e132 = left_3;
    let _e134 = internallyReflected(_e125, _e126, _e127.core, _e129.energy, _e131, _e132.passed);
    return ((_e116 * exp((-(_e117.path) * _e120.attenuation))) + _e134);
}
