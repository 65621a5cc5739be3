// Made by shaders/wgsl/make of 2a0a0cd316f6214c1cc944068f2aa98cee454b56f45fc8a8b1889b2740626adb: do not edit.
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

struct Polarized {
    s: f32,
    p: f32,
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

struct LobeTap {
    direction: vec3<f32>,
    sigma: f32,
    weight: f32,
}

struct ExitSurface {
    n: vec3<f32>,
    alpha: f32,
    eta: f32,
    turn: vec2<f32>,
}

struct InnerTap {
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

struct SceneMeeting {
    metres: f32,
    seen: bool,
}

struct BackFace {
    point: vec3<f32>,
    n: vec3<f32>,
    alpha: f32,
    exists: bool,
}

struct BackFaceExit {
    exit: ConvexExit,
    found: bool,
}

struct BeamPart {
    direction: vec3<f32>,
    aside: vec3<f32>,
    sigma: f32,
    inner: f32,
    carried: f32,
}

struct ComposedTap {
    direction: vec3<f32>,
    sigma: f32,
    weight: f32,
    inner: f32,
    carried: f32,
}

struct ComposedPair {
    core: ComposedTap,
    rest: ComposedTap,
}

struct InterfaceEnergy {
    transmitted: f32,
    reflected: f32,
}

struct InterfaceTap {
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

struct Wandering {
    passes: f32,
    back: f32,
}

struct WanderingLoss {
    linear: f32,
    constant: f32,
    thin: f32,
    passes: f32,
}

struct Entering {
    core: InnerTap,
    tail: InnerTap,
    energy: f32,
}

struct WayOut {
    tap: InnerTap,
    exit: ConvexExit,
    point: vec3<f32>,
    found: bool,
}

struct ThinWallEnergy {
    transmitted: f32,
    reflectedFirst: f32,
    reflectedLater: f32,
}


const BSDF_PI: f32 = 3.1415927f;
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
const LEAST_SWING: f32 = 0.05f;
const LEAVES_NEXT: f32 = 0.65f;
const EXIT_NOWHERE: f32 = -2f;
const EXIT_FAR: f32 = 1000000000000000000000000000000f;
const EXIT_STEPS: i32 = 12i;
const SCENE_GUESSES: i32 = 4i;
const SCENE_STEPS: i32 = 12i;
const SCENE_SECANTS: i32 = 5i;
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
const THIN_WALL_COSINES: i32 = 25i;
const THIN_WALL_ALPHAS: i32 = 16i;
const THIN_WALL_SLICES: i32 = 13i;


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

fn twinRenormalize(hi: vec3<f32>, lo: vec3<f32>) -> Twin3 {
    var hi_1: vec3<f32>;
    var lo_1: vec3<f32>;
    var sum_1: vec3<f32>;
    var rest: vec3<f32>;
    var t_5: Twin3;

    hi_1 = hi;
    lo_1 = lo;
    let _e7 = hi_1;
    let _e8 = lo_1;
    sum_1 = (_e7 + _e8);
    let _e11 = lo_1;
    let _e12 = sum_1;
    let _e13 = hi_1;
    rest = (_e11 - (_e12 - _e13));
    let _e19 = sum_1;
    t_5.hi = _e19;
    let _e21 = rest;
    t_5.lo = _e21;
    let _e22 = t_5;
    return _e22;
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
    let _e7 = a_4;
    let _e8 = b_1;
    sum_2 = (_e7 + _e8);
    let _e11 = sum_2;
    let _e12 = a_4;
    bPart = (_e11 - _e12);
    let _e15 = sum_2;
    let _e16 = bPart;
    aPart = (_e15 - _e16);
    let _e19 = a_4;
    let _e20 = aPart;
    let _e22 = b_1;
    let _e23 = bPart;
    rest_1 = ((_e19 - _e20) + (_e22 - _e23));
    let _e29 = sum_2;
    t_6.hi = _e29;
    let _e31 = rest_1;
    t_6.lo = _e31;
    let _e32 = t_6;
    return _e32;
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
    let _e7 = a_6;
    let _e8 = b_3;
    product = (_e7 * _e8);
    let _e11 = a_6;
    aBig = (BSDF_SPLITTER * _e11);
    let _e14 = b_3;
    bBig = (BSDF_SPLITTER * _e14);
    let _e17 = aBig;
    let _e18 = aBig;
    let _e19 = a_6;
    aHigh = (_e17 - (_e18 - _e19));
    let _e23 = bBig;
    let _e24 = bBig;
    let _e25 = b_3;
    bHigh = (_e23 - (_e24 - _e25));
    let _e29 = a_6;
    let _e30 = aHigh;
    aLow = (_e29 - _e30);
    let _e33 = b_3;
    let _e34 = bHigh;
    bLow = (_e33 - _e34);
    let _e37 = aHigh;
    let _e38 = bHigh;
    let _e40 = product;
    let _e42 = aHigh;
    let _e43 = bLow;
    let _e46 = aLow;
    let _e47 = bHigh;
    let _e50 = aLow;
    let _e51 = bLow;
    rest_2 = (((((_e37 * _e38) - _e40) + (_e42 * _e43)) + (_e46 * _e47)) + (_e50 * _e51));
    let _e57 = product;
    t_7.hi = _e57;
    let _e59 = rest_2;
    t_7.lo = _e59;
    let _e60 = t_7;
    return _e60;
}

fn twinAdd(a_7: Twin3, b_4: Twin3) -> Twin3 {
    var a_8: Twin3;
    var b_5: Twin3;
    var sum_3: Twin3;
    var low: vec3<f32>;

    a_8 = a_7;
    b_5 = b_4;
    let _e7 = a_8;
    let _e9 = b_5;
    let _e11 = twinSum(_e7.hi, _e9.hi);
    sum_3 = _e11;
    let _e13 = sum_3;
    let _e15 = a_8;
    let _e17 = b_5;
    low = (_e13.lo + (_e15.lo + _e17.lo));
    let _e22 = sum_3;
    let _e24 = low;
    let _e25 = twinRenormalize(_e22.hi, _e24);
    return _e25;
}

fn twinMultiply(a_9: Twin3, b_6: Twin3) -> Twin3 {
    var a_10: Twin3;
    var b_7: Twin3;
    var product_1: Twin3;
    var low_1: vec3<f32>;

    a_10 = a_9;
    b_7 = b_6;
    let _e7 = a_10;
    let _e9 = b_7;
    let _e11 = twinProduct(_e7.hi, _e9.hi);
    product_1 = _e11;
    let _e13 = product_1;
    let _e15 = a_10;
    let _e17 = b_7;
    let _e20 = a_10;
    let _e22 = b_7;
    low_1 = (_e13.lo + ((_e15.hi * _e17.lo) + (_e20.lo * _e22.hi)));
    let _e28 = product_1;
    let _e30 = low_1;
    let _e31 = twinRenormalize(_e28.hi, _e30);
    return _e31;
}

fn twinNegate(a_11: Twin3) -> Twin3 {
    var a_12: Twin3;

    a_12 = a_11;
    let _e6 = a_12;
    a_12.hi = -(_e6.hi);
    let _e10 = a_12;
    a_12.lo = -(_e10.lo);
    let _e13 = a_12;
    return _e13;
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
    let _e7 = a_14;
    let _e8 = b_9;
    sum_4 = (_e7 + _e8);
    let _e11 = sum_4;
    let _e12 = a_14;
    bPart_1 = (_e11 - _e12);
    let _e15 = sum_4;
    let _e16 = bPart_1;
    aPart_1 = (_e15 - _e16);
    let _e19 = a_14;
    let _e20 = aPart_1;
    let _e22 = b_9;
    let _e23 = bPart_1;
    rest_3 = ((_e19 - _e20) + (_e22 - _e23));
    let _e29 = sum_4;
    t_8.hi = _e29;
    let _e31 = rest_3;
    t_8.lo = _e31;
    let _e32 = t_8;
    return _e32;
}

fn twinTotal(a_15: Twin3) -> Twin {
    var a_16: Twin3;
    var xy: Twin;
    var xyz: Twin;
    var low_2: f32;

    a_16 = a_15;
    let _e5 = a_16;
    let _e8 = a_16;
    let _e11 = twinSum_1(_e5.hi.x, _e8.hi.y);
    xy = _e11;
    let _e13 = xy;
    let _e15 = a_16;
    let _e18 = twinSum_1(_e13.hi, _e15.hi.z);
    xyz = _e18;
    let _e20 = xy;
    let _e22 = xyz;
    let _e25 = a_16;
    let _e28 = a_16;
    let _e32 = a_16;
    low_2 = ((_e20.lo + _e22.lo) + ((_e25.lo.x + _e28.lo.y) + _e32.lo.z));
    let _e38 = xyz;
    let _e40 = low_2;
    let _e41 = twinSum_1(_e38.hi, _e40);
    return _e41;
}

fn twinDot(a_17: Twin3, b_10: Twin3) -> Twin {
    var a_18: Twin3;
    var b_11: Twin3;

    a_18 = a_17;
    b_11 = b_10;
    let _e7 = a_18;
    let _e8 = b_11;
    let _e9 = twinMultiply(_e7, _e8);
    let _e10 = twinTotal(_e9);
    return _e10;
}

fn twinTurn(a_19: Twin3) -> Twin3 {
    var a_20: Twin3;
    var t_9: Twin3;

    a_20 = a_19;
    let _e7 = a_20;
    let _e10 = a_20;
    let _e13 = a_20;
    t_9.hi = vec3<f32>(_e7.hi.y, _e10.hi.z, _e13.hi.x);
    let _e18 = a_20;
    let _e21 = a_20;
    let _e24 = a_20;
    t_9.lo = vec3<f32>(_e18.lo.y, _e21.lo.z, _e24.lo.x);
    let _e28 = t_9;
    return _e28;
}

fn twinCross(a_21: Twin3, b_12: Twin3) -> Twin3 {
    var a_22: Twin3;
    var b_13: Twin3;
    var product_2: Twin3;
    var other: Twin3;

    a_22 = a_21;
    b_13 = b_12;
    let _e7 = a_22;
    let _e8 = b_13;
    let _e9 = twinTurn(_e8);
    let _e10 = twinMultiply(_e7, _e9);
    product_2 = _e10;
    let _e12 = a_22;
    let _e13 = twinTurn(_e12);
    let _e14 = b_13;
    let _e15 = twinMultiply(_e13, _e14);
    other = _e15;
    let _e17 = product_2;
    let _e18 = other;
    let _e19 = twinNegate(_e18);
    let _e20 = twinAdd(_e17, _e19);
    let _e21 = twinTurn(_e20);
    return _e21;
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
    let _e7 = p_1;
    let _e9 = z_2;
    let _e11 = z_2;
    rough = (_e7.hi / (_e9.hi * _e11.hi));
    let _e16 = z_2;
    let _e19 = z_2;
    let _e22 = twinProduct(vec3(_e16.hi), vec3(_e19.hi));
    square = _e22;
    let _e24 = rough;
    let _e26 = square;
    let _e28 = twinProduct(vec3(_e24), _e26.hi);
    back = _e28;
    let _e30 = p_1;
    let _e32 = back;
    let _e36 = rough;
    let _e37 = square;
    let _e41 = z_2;
    let _e44 = z_2;
    low_3 = ((_e30.lo - _e32.lo.x) - (_e36 * (_e37.lo.x + ((2f * _e41.hi) * _e44.lo))));
    let _e51 = p_1;
    let _e53 = back;
    let _e57 = low_3;
    lacks = ((_e51.hi - _e53.hi.x) + _e57);
    let _e60 = rough;
    let _e61 = lacks;
    let _e62 = square;
    return (_e60 + (_e61 / _e62.hi.x));
}

fn twinNormalize(v_4: vec3<f32>) -> Twin3 {
    var v_5: vec3<f32>;
    var r_2: f32;
    var u_2: Twin3;
    var square_1: Twin;
    var x: f32;
    var stretch: f32;
    var low_4: vec3<f32>;

    v_5 = v_4;
    let _e5 = v_5;
    let _e6 = v_5;
    r_2 = inverseSqrt(dot(_e5, _e6));
    let _e10 = v_5;
    let _e11 = r_2;
    let _e13 = twinProduct(_e10, vec3(_e11));
    u_2 = _e13;
    let _e15 = u_2;
    let _e16 = u_2;
    let _e17 = twinDot(_e15, _e16);
    square_1 = _e17;
    let _e19 = square_1;
    let _e23 = square_1;
    x = ((_e19.hi - 1f) + _e23.lo);
    let _e27 = x;
    let _e29 = x;
    stretch = (_e27 * ((0.375f * _e29) - 0.5f));
    let _e35 = u_2;
    let _e37 = stretch;
    let _e38 = u_2;
    low_4 = (_e35.lo + (_e37 * _e38.hi));
    let _e43 = u_2;
    let _e45 = low_4;
    let _e46 = twinRenormalize(_e43.hi, _e45);
    return _e46;
}

fn preciseTilt(v_6: Twin3, n_8: Twin3) -> SignedTilt {
    var v_7: Twin3;
    var n_9: Twin3;
    var across_1: vec3<f32>;
    var t_10: SignedTilt;

    v_7 = v_6;
    n_9 = n_8;
    let _e7 = v_7;
    let _e8 = n_9;
    let _e9 = twinCross(_e7, _e8);
    across_1 = _e9.hi;
    let _e14 = across_1;
    let _e15 = across_1;
    t_10.p = dot(_e14, _e15);
    let _e18 = v_7;
    let _e19 = n_9;
    let _e20 = twinDot(_e18, _e19);
    t_10.z = _e20;
    let _e21 = t_10;
    return _e21;
}

fn unsignedTilt(signedTilt: SignedTilt) -> Tilt {
    var signedTilt_1: SignedTilt;
    var t_11: Tilt;

    signedTilt_1 = signedTilt;
    let _e7 = signedTilt_1;
    t_11.p = _e7.p;
    let _e10 = signedTilt_1;
    t_11.z = abs(_e10.z.hi);
    let _e14 = t_11;
    return _e14;
}

fn preciseSlope(h_2: Twin3, n_10: Twin3, z_3: Twin) -> Tilt {
    var h_3: Twin3;
    var n_11: Twin3;
    var z_4: Twin;
    var across_2: Twin3;
    var t_12: Tilt;

    h_3 = h_2;
    n_11 = n_10;
    z_4 = z_3;
    let _e9 = h_3;
    let _e10 = n_11;
    let _e11 = twinCross(_e9, _e10);
    across_2 = _e11;
    t_12.p = 0f;
    t_12.z = 0f;
    let _e18 = z_4;
    if (_e18.hi != 0f) {
        {
            let _e23 = across_2;
            let _e24 = across_2;
            let _e25 = twinDot(_e23, _e24);
            let _e26 = z_4;
            let _e27 = twinOverSquare(_e25, _e26);
            t_12.p = _e27;
            t_12.z = 1f;
        }
    }
    let _e30 = t_12;
    return _e30;
}

fn usable(v_8: vec3<f32>) -> bool {
    var v_9: vec3<f32>;

    v_9 = v_8;
    let _e5 = v_9;
    let _e6 = v_9;
    return (dot(_e5, _e6) > 0f);
}

fn noFacet() -> Facet {
    var f_6: Facet;

    f_6.wi.p = 0f;
    f_6.wi.z = 0f;
    let _e11 = f_6;
    f_6.wo = _e11.wi;
    let _e14 = f_6;
    f_6.h = _e14.wi;
    f_6.s = 0f;
    f_6.wiDotM = 0f;
    f_6.woDotM = 0f;
    f_6.g = 0f;
    f_6.exists = false;
    let _e26 = f_6;
    return _e26;
}

fn preciseReflectionFacet(wi_12: vec3<f32>, wo_12: vec3<f32>, n_12: vec3<f32>, eta_8: f32) -> Facet {
    var wi_13: vec3<f32>;
    var wo_13: vec3<f32>;
    var n_13: vec3<f32>;
    var eta_9: f32;
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
    eta_9 = eta_8;
    let _e11 = wi_13;
    let _e12 = usable(_e11);
    let _e13 = wo_13;
    let _e14 = usable(_e13);
    let _e16 = n_13;
    let _e17 = usable(_e16);
    if !(((_e12 && _e14) && _e17)) {
        let _e20 = noFacet();
        return _e20;
    }
    let _e21 = wi_13;
    let _e22 = twinNormalize(_e21);
    i = _e22;
    let _e24 = wo_13;
    let _e25 = twinNormalize(_e24);
    o = _e25;
    let _e27 = n_13;
    let _e28 = twinNormalize(_e27);
    up = _e28;
    let _e30 = i;
    let _e31 = o;
    let _e32 = twinAdd(_e30, _e31);
    h_4 = _e32;
    let _e34 = i;
    let _e35 = up;
    let _e36 = preciseTilt(_e34, _e35);
    tiltI = _e36;
    let _e38 = o;
    let _e39 = up;
    let _e40 = preciseTilt(_e38, _e39);
    tiltO = _e40;
    let _e42 = h_4;
    let _e43 = h_4;
    let _e44 = twinDot(_e42, _e43);
    s_1 = _e44;
    let _e48 = tiltI;
    let _e49 = unsignedTilt(_e48);
    f_7.wi = _e49;
    let _e51 = tiltO;
    let _e52 = unsignedTilt(_e51);
    f_7.wo = _e52;
    let _e54 = h_4;
    let _e55 = up;
    let _e56 = h_4;
    let _e57 = up;
    let _e58 = twinDot(_e56, _e57);
    let _e59 = preciseSlope(_e54, _e55, _e58);
    f_7.h = _e59;
    let _e61 = s_1;
    f_7.s = _e61.hi;
    let _e65 = s_1;
    f_7.woDotM = min((0.5f * sqrt(_e65.hi)), 1f);
    let _e72 = f_7;
    f_7.wiDotM = _e72.woDotM;
    let _e74 = eta_9;
    let _e78 = eta_9;
    let _e82 = twinProduct(vec3<f32>(_e74, 0f, 0f), vec3<f32>(_e78, 0f, 0f));
    terms = _e82;
    let _e85 = terms;
    let _e91 = s_1;
    terms.hi = vec3<f32>(_e85.hi.x, -1f, (0.25f * _e91.hi));
    let _e96 = terms;
    let _e101 = s_1;
    terms.lo = vec3<f32>(_e96.lo.x, 0f, (0.25f * _e101.lo));
    let _e106 = terms;
    let _e107 = twinTotal(_e106);
    f_7.g = sqrt(max(_e107.hi, 0f));
    let _e113 = tiltI;
    let _e118 = tiltO;
    let _e124 = tiltI;
    let _e129 = tiltO;
    let _e136 = f_7;
    f_7.exists = ((((_e113.z.hi > 0f) && (_e118.z.hi > 0f)) || ((_e124.z.hi < 0f) && (_e129.z.hi < 0f))) && (_e136.h.z > 0f));
    let _e142 = f_7;
    return _e142;
}

fn preciseTransmissionFacet(wi_14: vec3<f32>, wo_14: vec3<f32>, n_14: vec3<f32>, eta_10: f32) -> Facet {
    var wi_15: vec3<f32>;
    var wo_15: vec3<f32>;
    var n_15: vec3<f32>;
    var eta_11: f32;
    var i_1: Twin3;
    var o_1: Twin3;
    var up_1: Twin3;
    var factor: Twin3;
    var h_5: Twin3;
    var tiltI_1: SignedTilt;
    var tiltO_1: SignedTilt;
    var hDotN: Twin;
    var local_8: f32;
    var side_1: f32;
    var hDotI_1: f32;
    var hDotO_1: f32;
    var opposite: bool;
    var f_8: Facet;
    var local_9: f32;
    var scale_1: f32;

    wi_15 = wi_14;
    wo_15 = wo_14;
    n_15 = n_14;
    eta_11 = eta_10;
    let _e11 = wi_15;
    let _e12 = usable(_e11);
    let _e13 = wo_15;
    let _e14 = usable(_e13);
    let _e16 = n_15;
    let _e17 = usable(_e16);
    let _e19 = eta_11;
    let _e23 = eta_11;
    if !(((((_e12 && _e14) && _e17) && (_e19 > 0f)) && (_e23 != 1f))) {
        let _e28 = noFacet();
        return _e28;
    }
    let _e29 = wi_15;
    let _e30 = twinNormalize(_e29);
    i_1 = _e30;
    let _e32 = wo_15;
    let _e33 = twinNormalize(_e32);
    o_1 = _e33;
    let _e35 = n_15;
    let _e36 = twinNormalize(_e35);
    up_1 = _e36;
    let _e40 = eta_11;
    factor.hi = vec3(_e40);
    factor.lo = vec3(0f);
    let _e45 = o_1;
    let _e46 = i_1;
    let _e47 = factor;
    let _e48 = twinMultiply(_e46, _e47);
    let _e49 = twinAdd(_e45, _e48);
    h_5 = _e49;
    let _e51 = i_1;
    let _e52 = up_1;
    let _e53 = preciseTilt(_e51, _e52);
    tiltI_1 = _e53;
    let _e55 = o_1;
    let _e56 = up_1;
    let _e57 = preciseTilt(_e55, _e56);
    tiltO_1 = _e57;
    let _e59 = h_5;
    let _e60 = up_1;
    let _e61 = twinDot(_e59, _e60);
    hDotN = _e61;
    let _e63 = hDotN;
    let _e67 = tiltO_1;
    if ((_e63.hi < 0f) == (_e67.z.hi < 0f)) {
        local_8 = 1f;
    } else {
        local_8 = -1f;
    }
    let _e77 = local_8;
    side_1 = _e77;
    let _e79 = side_1;
    let _e80 = h_5;
    let _e81 = i_1;
    let _e82 = twinDot(_e80, _e81);
    hDotI_1 = (_e79 * _e82.hi);
    let _e86 = side_1;
    let _e87 = h_5;
    let _e88 = o_1;
    let _e89 = twinDot(_e87, _e88);
    hDotO_1 = (_e86 * _e89.hi);
    let _e93 = tiltI_1;
    let _e98 = tiltO_1;
    let _e104 = tiltI_1;
    let _e109 = tiltO_1;
    opposite = (((_e93.z.hi > 0f) && (_e98.z.hi < 0f)) || ((_e104.z.hi < 0f) && (_e109.z.hi > 0f)));
    let _e119 = tiltI_1;
    let _e120 = unsignedTilt(_e119);
    f_8.wi = _e120;
    let _e122 = tiltO_1;
    let _e123 = unsignedTilt(_e122);
    f_8.wo = _e123;
    let _e125 = h_5;
    let _e126 = up_1;
    let _e127 = hDotN;
    let _e128 = preciseSlope(_e125, _e126, _e127);
    f_8.h = _e128;
    let _e130 = h_5;
    let _e131 = h_5;
    let _e132 = twinDot(_e130, _e131);
    f_8.s = _e132.hi;
    let _e135 = opposite;
    let _e136 = f_8;
    let _e142 = hDotI_1;
    let _e146 = hDotO_1;
    f_8.exists = (((_e135 && (_e136.h.z > 0f)) && (_e142 < 0f)) && (_e146 > 0f));
    let _e150 = f_8;
    if _e150.exists {
        let _e152 = f_8;
        local_9 = inverseSqrt(_e152.s);
    } else {
        local_9 = 0f;
    }
    let _e157 = local_9;
    scale_1 = _e157;
    let _e160 = hDotI_1;
    let _e162 = scale_1;
    f_8.wiDotM = min((abs(_e160) * _e162), 1f);
    let _e167 = hDotO_1;
    let _e169 = scale_1;
    f_8.woDotM = min((abs(_e167) * _e169), 1f);
    let _e174 = eta_11;
    let _e175 = f_8;
    f_8.g = (_e174 * _e175.wiDotM);
    let _e178 = f_8;
    return _e178;
}

fn diffuseF(albedo: vec3<f32>, fresnel: f32) -> vec3<f32> {
    var albedo_1: vec3<f32>;
    var fresnel_1: f32;

    albedo_1 = albedo;
    fresnel_1 = fresnel;
    let _e7 = albedo_1;
    let _e9 = fresnel_1;
    return (_e7 * ((1f - _e9) / BSDF_PI));
}

fn diffuseFCos(albedo_2: vec3<f32>, fresnel_2: f32, cosI_2: f32) -> vec3<f32> {
    var albedo_3: vec3<f32>;
    var fresnel_3: f32;
    var cosI_3: f32;

    albedo_3 = albedo_2;
    fresnel_3 = fresnel_2;
    cosI_3 = cosI_2;
    let _e9 = albedo_3;
    let _e10 = fresnel_3;
    let _e11 = diffuseF(_e9, _e10);
    let _e12 = cosI_3;
    return (_e11 * _e12);
}

fn conductorTerms(c: f32, n_16: f32, k_1: f32) -> ConductorTerms {
    var c_1: f32;
    var n_17: f32;
    var k_2: f32;
    var sin2_: f32;
    var contrast: f32;
    var re: f32;
    var nk: f32;
    var larger: f32;
    var local_10: f32;
    var smaller: f32;
    var local_11: f32;
    var a_23: f32;
    var local_12: f32;
    var b_14: f32;
    var local_13: f32;
    var aMinusC: f32;
    var bc: f32;
    var t_13: ConductorTerms;

    c_1 = c;
    n_17 = n_16;
    k_2 = k_1;
    let _e10 = c_1;
    let _e13 = c_1;
    sin2_ = ((1f - _e10) * (1f + _e13));
    let _e17 = n_17;
    let _e20 = n_17;
    let _e24 = k_2;
    let _e25 = k_2;
    contrast = (((_e17 - 1f) * (_e20 + 1f)) - (_e24 * _e25));
    let _e29 = contrast;
    let _e30 = c_1;
    let _e31 = c_1;
    re = (_e29 + (_e30 * _e31));
    let _e35 = n_17;
    let _e36 = k_2;
    nk = (_e35 * _e36);
    let _e40 = re;
    let _e42 = re;
    let _e43 = re;
    let _e46 = nk;
    let _e48 = nk;
    larger = sqrt((0.5f * (abs(_e40) + sqrt(((_e42 * _e43) + ((4f * _e46) * _e48))))));
    let _e56 = larger;
    if (_e56 > 0f) {
        let _e59 = nk;
        let _e60 = larger;
        local_10 = (_e59 / _e60);
    } else {
        local_10 = 0f;
    }
    let _e64 = local_10;
    smaller = _e64;
    let _e66 = re;
    if (_e66 > 0f) {
        let _e69 = larger;
        local_11 = _e69;
    } else {
        let _e70 = smaller;
        local_11 = _e70;
    }
    let _e72 = local_11;
    a_23 = _e72;
    let _e74 = re;
    if (_e74 > 0f) {
        let _e77 = smaller;
        local_12 = _e77;
    } else {
        let _e78 = larger;
        local_12 = _e78;
    }
    let _e80 = local_12;
    b_14 = _e80;
    let _e82 = a_23;
    let _e83 = c_1;
    if ((_e82 + _e83) > 0f) {
        let _e87 = contrast;
        let _e88 = b_14;
        let _e89 = b_14;
        let _e92 = a_23;
        let _e93 = c_1;
        local_13 = ((_e87 + (_e88 * _e89)) / (_e92 + _e93));
    } else {
        local_13 = 0f;
    }
    let _e98 = local_13;
    aMinusC = _e98;
    let _e100 = b_14;
    let _e101 = c_1;
    bc = (_e100 * _e101);
    let _e106 = a_23;
    t_13.a = _e106;
    let _e108 = a_23;
    let _e109 = a_23;
    let _e111 = b_14;
    let _e112 = b_14;
    t_13.q2_ = ((_e108 * _e109) + (_e111 * _e112));
    let _e116 = aMinusC;
    let _e117 = aMinusC;
    let _e119 = b_14;
    let _e120 = b_14;
    t_13.numS = ((_e116 * _e117) + (_e119 * _e120));
    let _e124 = a_23;
    let _e125 = c_1;
    let _e127 = a_23;
    let _e128 = c_1;
    let _e131 = b_14;
    let _e132 = b_14;
    t_13.denS = (((_e124 + _e125) * (_e127 + _e128)) + (_e131 * _e132));
    let _e136 = a_23;
    let _e137 = c_1;
    let _e139 = sin2_;
    let _e141 = a_23;
    let _e142 = c_1;
    let _e144 = sin2_;
    let _e147 = bc;
    let _e148 = bc;
    t_13.numP = ((((_e136 * _e137) - _e139) * ((_e141 * _e142) - _e144)) + (_e147 * _e148));
    let _e152 = a_23;
    let _e153 = c_1;
    let _e155 = sin2_;
    let _e157 = a_23;
    let _e158 = c_1;
    let _e160 = sin2_;
    let _e163 = bc;
    let _e164 = bc;
    t_13.denP = ((((_e152 * _e153) + _e155) * ((_e157 * _e158) + _e160)) + (_e163 * _e164));
    let _e167 = t_13;
    return _e167;
}

fn fresnelConductor(cosTheta: f32, n_18: f32, k_3: f32) -> f32 {
    var cosTheta_1: f32;
    var n_19: f32;
    var k_4: f32;
    var c_2: f32;
    var t_14: ConductorTerms;
    var local_14: f32;
    var rs: f32;
    var local_15: f32;
    var rpOverRs: f32;

    cosTheta_1 = cosTheta;
    n_19 = n_18;
    k_4 = k_3;
    let _e9 = cosTheta_1;
    c_2 = clamp(abs(_e9), 0f, 1f);
    let _e15 = c_2;
    let _e16 = n_19;
    let _e19 = k_4;
    let _e22 = conductorTerms(_e15, max(_e16, 0f), max(_e19, 0f));
    t_14 = _e22;
    let _e24 = t_14;
    if (_e24.denS > 0f) {
        let _e28 = t_14;
        let _e30 = t_14;
        local_14 = (_e28.numS / _e30.denS);
    } else {
        local_14 = 1f;
    }
    let _e35 = local_14;
    rs = _e35;
    let _e37 = t_14;
    if (_e37.denP > 0f) {
        let _e41 = t_14;
        let _e43 = t_14;
        local_15 = (_e41.numP / _e43.denP);
    } else {
        local_15 = 1f;
    }
    let _e48 = local_15;
    rpOverRs = _e48;
    let _e51 = rs;
    let _e54 = rpOverRs;
    return min(((0.5f * _e51) * (1f + _e54)), 1f);
}

fn fresnelAbsorbed(cosTheta_2: f32, n_20: f32, k_5: f32) -> f32 {
    var cosTheta_3: f32;
    var n_21: f32;
    var k_6: f32;
    var c_3: f32;
    var t_15: ConductorTerms;
    var sin2_1: f32;

    cosTheta_3 = cosTheta_2;
    n_21 = n_20;
    k_6 = k_5;
    let _e9 = cosTheta_3;
    c_3 = clamp(abs(_e9), 0f, 1f);
    let _e15 = c_3;
    let _e16 = n_21;
    let _e19 = k_6;
    let _e22 = conductorTerms(_e15, max(_e16, 0f), max(_e19, 0f));
    t_15 = _e22;
    let _e24 = t_15;
    let _e28 = t_15;
    if !(((_e24.denS > 0f) && (_e28.denP > 0f))) {
        return 0f;
    }
    let _e36 = c_3;
    let _e39 = c_3;
    sin2_1 = ((1f - _e36) * (1f + _e39));
    let _e44 = t_15;
    let _e47 = c_3;
    let _e49 = t_15;
    let _e53 = t_15;
    let _e55 = sin2_1;
    let _e57 = t_15;
    return min(((((2f * _e44.a) * _e47) / _e49.denS) * (1f + ((_e53.q2_ + _e55) / _e57.denP))), 1f);
}

fn fresnelConductorRgb(cosTheta_4: f32, n_22: vec3<f32>, k_7: vec3<f32>) -> vec3<f32> {
    var cosTheta_5: f32;
    var n_23: vec3<f32>;
    var k_8: vec3<f32>;

    cosTheta_5 = cosTheta_4;
    n_23 = n_22;
    k_8 = k_7;
    let _e9 = cosTheta_5;
    let _e10 = n_23;
    let _e12 = k_8;
    let _e14 = fresnelConductor(_e9, _e10.x, _e12.x);
    let _e15 = cosTheta_5;
    let _e16 = n_23;
    let _e18 = k_8;
    let _e20 = fresnelConductor(_e15, _e16.y, _e18.y);
    let _e21 = cosTheta_5;
    let _e22 = n_23;
    let _e24 = k_8;
    let _e26 = fresnelConductor(_e21, _e22.z, _e24.z);
    return vec3<f32>(_e14, _e20, _e26);
}

fn fresnelG(c_4: f32, eta_12: f32) -> f32 {
    var c_5: f32;
    var eta_13: f32;

    c_5 = c_4;
    eta_13 = eta_12;
    let _e7 = eta_13;
    let _e10 = eta_13;
    let _e14 = c_5;
    let _e15 = c_5;
    return sqrt(max((((_e7 - 1f) * (_e10 + 1f)) + (_e14 * _e15)), 0f));
}

fn fresnelPolarized(c_6: f32, g: f32, eta_14: f32) -> Polarized {
    var c_7: f32;
    var g_1: f32;
    var eta_15: f32;
    var r_3: Polarized;
    var local_16: f32;
    var k_9: f32;
    var local_17: f32;
    var sin2_2: f32;
    var across_3: f32;
    var along: f32;
    var rs_1: f32;
    var rp: f32;

    c_7 = c_6;
    g_1 = g;
    eta_15 = eta_14;
    let _e11 = eta_15;
    if (_e11 == 1f) {
        local_16 = 0f;
    } else {
        local_16 = 1f;
    }
    let _e17 = local_16;
    r_3.s = _e17;
    let _e19 = r_3;
    r_3.p = _e19.s;
    let _e21 = g_1;
    let _e24 = eta_15;
    if ((_e21 > 0f) && (_e24 > 0f)) {
        {
            let _e28 = eta_15;
            let _e31 = eta_15;
            k_9 = ((_e28 - 1f) * (_e31 + 1f));
            let _e36 = eta_15;
            if (_e36 < 1f) {
                let _e39 = eta_15;
                let _e40 = g_1;
                let _e42 = eta_15;
                let _e43 = g_1;
                local_17 = ((_e39 - _e40) * (_e42 + _e43));
            } else {
                let _e47 = c_7;
                let _e50 = c_7;
                local_17 = ((1f - _e47) * (1f + _e50));
            }
            let _e54 = local_17;
            sin2_2 = _e54;
            let _e56 = c_7;
            let _e57 = g_1;
            across_3 = (_e56 + _e57);
            let _e60 = c_7;
            let _e61 = g_1;
            let _e63 = sin2_2;
            let _e65 = c_7;
            let _e66 = g_1;
            let _e68 = sin2_2;
            along = (((_e60 * _e61) - _e63) / ((_e65 * _e66) + _e68));
            let _e72 = k_9;
            let _e73 = across_3;
            let _e74 = across_3;
            rs_1 = (_e72 / (_e73 * _e74));
            let _e78 = rs_1;
            let _e79 = along;
            rp = (_e78 * _e79);
            let _e83 = rs_1;
            let _e84 = rs_1;
            r_3.s = min((_e83 * _e84), 1f);
            let _e89 = rp;
            let _e90 = rp;
            r_3.p = min((_e89 * _e90), 1f);
        }
    }
    let _e94 = r_3;
    return _e94;
}

fn fresnelDielectric(c_8: f32, g_2: f32, eta_16: f32) -> f32 {
    var c_9: f32;
    var g_3: f32;
    var eta_17: f32;
    var r_4: Polarized;

    c_9 = c_8;
    g_3 = g_2;
    eta_17 = eta_16;
    let _e9 = c_9;
    let _e10 = g_3;
    let _e11 = eta_17;
    let _e12 = fresnelPolarized(_e9, _e10, _e11);
    r_4 = _e12;
    let _e15 = r_4;
    let _e17 = r_4;
    return (0.5f * (_e15.s + _e17.p));
}

fn fresnelTransmitted(c_10: f32, g_4: f32, eta_18: f32) -> f32 {
    var c_11: f32;
    var g_5: f32;
    var eta_19: f32;
    var eta2_: f32;
    var across_4: f32;
    var along_1: f32;

    c_11 = c_10;
    g_5 = g_4;
    eta_19 = eta_18;
    let _e9 = eta_19;
    if (_e9 == 1f) {
        return 1f;
    }
    let _e13 = g_5;
    let _e16 = eta_19;
    if !(((_e13 > 0f) && (_e16 > 0f))) {
        return 0f;
    }
    let _e22 = eta_19;
    let _e23 = eta_19;
    eta2_ = (_e22 * _e23);
    let _e26 = c_11;
    let _e27 = g_5;
    across_4 = (_e26 + _e27);
    let _e30 = eta2_;
    let _e31 = c_11;
    let _e33 = g_5;
    along_1 = ((_e30 * _e31) + _e33);
    let _e37 = c_11;
    let _e39 = g_5;
    let _e42 = across_4;
    let _e43 = across_4;
    let _e46 = eta2_;
    let _e47 = along_1;
    let _e48 = along_1;
    return min((((2f * _e37) * _e39) * ((1f / (_e42 * _e43)) + (_e46 / (_e47 * _e48)))), 1f);
}

fn fresnelDielectricAt(cosTheta_6: f32, eta_20: f32) -> f32 {
    var cosTheta_7: f32;
    var eta_21: f32;
    var c_12: f32;

    cosTheta_7 = cosTheta_6;
    eta_21 = eta_20;
    let _e7 = cosTheta_7;
    c_12 = clamp(abs(_e7), 0f, 1f);
    let _e13 = c_12;
    let _e14 = c_12;
    let _e15 = eta_21;
    let _e16 = fresnelG(_e14, _e15);
    let _e17 = eta_21;
    let _e18 = fresnelDielectric(_e13, _e16, _e17);
    return _e18;
}

fn fresnelTransmittedAt(cosTheta_8: f32, eta_22: f32) -> f32 {
    var cosTheta_9: f32;
    var eta_23: f32;
    var c_13: f32;

    cosTheta_9 = cosTheta_8;
    eta_23 = eta_22;
    let _e7 = cosTheta_9;
    c_13 = clamp(abs(_e7), 0f, 1f);
    let _e13 = c_13;
    let _e14 = c_13;
    let _e15 = eta_23;
    let _e16 = fresnelG(_e14, _e15);
    let _e17 = eta_23;
    let _e18 = fresnelTransmitted(_e13, _e16, _e17);
    return _e18;
}

fn fresnelPolarizedAt(cosTheta_10: f32, eta_24: f32) -> Polarized {
    var cosTheta_11: f32;
    var eta_25: f32;
    var c_14: f32;

    cosTheta_11 = cosTheta_10;
    eta_25 = eta_24;
    let _e7 = cosTheta_11;
    c_14 = clamp(abs(_e7), 0f, 1f);
    let _e13 = c_14;
    let _e14 = c_14;
    let _e15 = eta_25;
    let _e16 = fresnelG(_e14, _e15);
    let _e17 = eta_25;
    let _e18 = fresnelPolarized(_e13, _e16, _e17);
    return _e18;
}

fn fresnelNormalIncidence(eta_26: f32) -> f32 {
    var eta_27: f32;
    var r_5: f32;

    eta_27 = eta_26;
    let _e5 = eta_27;
    let _e8 = eta_27;
    r_5 = ((_e5 - 1f) / (_e8 + 1f));
    let _e13 = r_5;
    let _e14 = r_5;
    return (_e13 * _e14);
}

fn schlickWeight(cosTheta_12: f32) -> f32 {
    var cosTheta_13: f32;
    var m_4: f32;
    var m2_: f32;

    cosTheta_13 = cosTheta_12;
    let _e6 = cosTheta_13;
    m_4 = (1f - clamp(_e6, 0f, 1f));
    let _e12 = m_4;
    let _e13 = m_4;
    m2_ = (_e12 * _e13);
    let _e16 = m2_;
    let _e17 = m2_;
    let _e19 = m_4;
    return ((_e16 * _e17) * _e19);
}

fn fresnelSchlick(cosTheta_14: f32, f0_: f32) -> f32 {
    var cosTheta_15: f32;
    var f0_1: f32;

    cosTheta_15 = cosTheta_14;
    f0_1 = f0_;
    let _e7 = f0_1;
    let _e9 = f0_1;
    let _e11 = cosTheta_15;
    let _e12 = schlickWeight(_e11);
    return (_e7 + ((1f - _e9) * _e12));
}

fn fresnelSchlickRgb(cosTheta_16: f32, f0_2: vec3<f32>) -> vec3<f32> {
    var cosTheta_17: f32;
    var f0_3: vec3<f32>;

    cosTheta_17 = cosTheta_16;
    f0_3 = f0_2;
    let _e7 = f0_3;
    let _e10 = f0_3;
    let _e12 = cosTheta_17;
    let _e13 = schlickWeight(_e12);
    return (_e7 + ((vec3(1f) - _e10) * _e13));
}

fn ggxD(m_5: Tilt, alpha_18: f32) -> f32 {
    var m_6: Tilt;
    var alpha_19: f32;
    var width_1: f32;
    var spread: f32;
    var t_16: f32;

    m_6 = m_5;
    alpha_19 = alpha_18;
    let _e7 = alpha_19;
    let _e8 = m_6;
    width_1 = (_e7 * _e8.z);
    let _e12 = m_6;
    let _e14 = width_1;
    let _e15 = width_1;
    spread = (_e12.p + (_e14 * _e15));
    let _e19 = spread;
    let _e22 = alpha_19;
    if !(((_e19 > 0f) && (_e22 > 0f))) {
        return 0f;
    }
    let _e28 = alpha_19;
    let _e29 = m_6;
    let _e31 = m_6;
    let _e33 = m_6;
    let _e38 = spread;
    t_16 = ((_e28 * (_e29.p + (_e31.z * _e33.z))) / _e38);
    let _e41 = t_16;
    let _e42 = t_16;
    return ((_e41 * _e42) / BSDF_PI);
}

fn ggxRoot(w_8: Tilt, alpha_20: f32) -> f32 {
    var w_9: Tilt;
    var alpha_21: f32;

    w_9 = w_8;
    alpha_21 = alpha_20;
    let _e7 = w_9;
    let _e9 = w_9;
    let _e12 = alpha_21;
    let _e13 = alpha_21;
    let _e15 = w_9;
    return sqrt(((_e7.z * _e9.z) + ((_e12 * _e13) * _e15.p)));
}

fn ggxLambda(w_10: Tilt, alpha_22: f32) -> f32 {
    var w_11: Tilt;
    var alpha_23: f32;
    var slope_1: f32;
    var below: f32;
    var local_18: f32;

    w_11 = w_10;
    alpha_23 = alpha_22;
    let _e7 = alpha_23;
    let _e8 = alpha_23;
    let _e10 = w_11;
    slope_1 = ((_e7 * _e8) * _e10.p);
    let _e15 = w_11;
    let _e18 = w_11;
    let _e20 = w_11;
    let _e21 = alpha_23;
    let _e22 = ggxRoot(_e20, _e21);
    below = ((2f * _e15.z) * (_e18.z + _e22));
    let _e26 = slope_1;
    let _e28 = below;
    if (_e26 < (1000000000000000000000000000000f * _e28)) {
        let _e31 = slope_1;
        let _e32 = below;
        local_18 = (_e31 / _e32);
    } else {
        local_18 = 1000000000000000000000000000000f;
    }
    let _e36 = local_18;
    return _e36;
}

fn ggxG1(w_12: Tilt, alpha_24: f32) -> f32 {
    var w_13: Tilt;
    var alpha_25: f32;
    var sum_5: f32;
    var local_19: f32;

    w_13 = w_12;
    alpha_25 = alpha_24;
    let _e7 = w_13;
    let _e9 = w_13;
    let _e10 = alpha_25;
    let _e11 = ggxRoot(_e9, _e10);
    sum_5 = (_e7.z + _e11);
    let _e14 = sum_5;
    if (_e14 > 0f) {
        let _e18 = w_13;
        let _e21 = sum_5;
        local_19 = ((2f * _e18.z) / _e21);
    } else {
        local_19 = 0f;
    }
    let _e25 = local_19;
    return _e25;
}

fn ggxG2(wi_16: Tilt, wo_16: Tilt, alpha_26: f32) -> f32 {
    var wi_17: Tilt;
    var wo_17: Tilt;
    var alpha_27: f32;

    wi_17 = wi_16;
    wo_17 = wo_16;
    alpha_27 = alpha_26;
    let _e9 = wi_17;
    let _e10 = alpha_27;
    let _e11 = ggxG1(_e9, _e10);
    let _e12 = wo_17;
    let _e13 = alpha_27;
    let _e14 = ggxG1(_e12, _e13);
    return (_e11 * _e14);
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
    let _e9 = wi_19;
    let _e10 = alpha_29;
    let _e11 = ggxRoot(_e9, _e10);
    let _e12 = wo_19;
    let _e15 = wo_19;
    let _e16 = alpha_29;
    let _e17 = ggxRoot(_e15, _e16);
    let _e18 = wi_19;
    sum_6 = ((_e11 * _e12.z) + (_e17 * _e18.z));
    let _e23 = sum_6;
    if (_e23 > 0f) {
        let _e27 = wi_19;
        let _e30 = wo_19;
        let _e33 = sum_6;
        local_20 = (((2f * _e27.z) * _e30.z) / _e33);
    } else {
        local_20 = 0f;
    }
    let _e37 = local_20;
    return _e37;
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
    let _e9 = wi_21;
    let _e11 = wi_21;
    let _e12 = alpha_31;
    let _e13 = ggxRoot(_e11, _e12);
    let _e15 = wo_21;
    let _e17 = wo_21;
    let _e18 = alpha_31;
    let _e19 = ggxRoot(_e17, _e18);
    sum_7 = ((_e9.z + _e13) * (_e15.z + _e19));
    let _e23 = sum_7;
    if (_e23 > 0.0000000000000000000000000000000000001f) {
        let _e27 = sum_7;
        local_21 = (1f / _e27);
    } else {
        local_21 = 0f;
    }
    let _e31 = local_21;
    return _e31;
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
    let _e9 = wi_23;
    let _e10 = alpha_33;
    let _e11 = ggxRoot(_e9, _e10);
    let _e12 = wo_23;
    let _e15 = wo_23;
    let _e16 = alpha_33;
    let _e17 = ggxRoot(_e15, _e16);
    let _e18 = wi_23;
    sum_8 = ((_e11 * _e12.z) + (_e17 * _e18.z));
    let _e23 = sum_8;
    if (_e23 > 0.0000000000000000000000000000000000001f) {
        let _e27 = sum_8;
        local_22 = (0.5f / _e27);
    } else {
        local_22 = 0f;
    }
    let _e31 = local_22;
    return _e31;
}

fn ggxPdf(m_7: Tilt, alpha_34: f32) -> f32 {
    var m_8: Tilt;
    var alpha_35: f32;

    m_8 = m_7;
    alpha_35 = alpha_34;
    let _e7 = m_8;
    let _e8 = alpha_35;
    let _e9 = ggxD(_e7, _e8);
    let _e10 = m_8;
    let _e11 = tiltCos(_e10);
    return (_e9 * _e11);
}

fn ggxPdfVisible(f_9: Facet, alpha_36: f32) -> f32 {
    var f_10: Facet;
    var alpha_37: f32;

    f_10 = f_9;
    alpha_37 = alpha_36;
    let _e7 = f_10;
    if !(_e7.exists) {
        return 0f;
    }
    let _e12 = f_10;
    let _e15 = f_10;
    let _e17 = alpha_37;
    let _e18 = ggxD(_e15.h, _e17);
    let _e20 = f_10;
    let _e23 = f_10;
    let _e25 = alpha_37;
    let _e26 = ggxRoot(_e23.wo, _e25);
    return (((2f * _e12.woDotM) * _e18) / (_e20.wo.z + _e26));
}

fn ggxSample(alpha_38: f32, u_3: vec2<f32>) -> vec3<f32> {
    var alpha_39: f32;
    var u_4: vec2<f32>;
    var phi_1: f32;
    var across_5: f32;

    alpha_39 = alpha_38;
    u_4 = u_3;
    let _e10 = u_4;
    phi_1 = (6.2831855f * _e10.y);
    let _e14 = alpha_39;
    let _e15 = u_4;
    across_5 = (_e14 * sqrt(_e15.x));
    let _e20 = across_5;
    let _e21 = phi_1;
    let _e24 = across_5;
    let _e25 = phi_1;
    let _e29 = u_4;
    return normalize(vec3<f32>((_e20 * cos(_e21)), (_e24 * sin(_e25)), sqrt(max((1f - _e29.x), 0f))));
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
    let _e9 = alpha_41;
    let _e11 = wo_25;
    let _e14 = alpha_41;
    let _e16 = wo_25;
    let _e19 = wo_25;
    seen = normalize(vec3<f32>((_e9.x * _e11.x), (_e14.y * _e16.y), _e19.z));
    let _e27 = u_6;
    phi_2 = (6.2831855f * _e27.x);
    let _e32 = u_6;
    let _e36 = seen;
    let _e40 = seen;
    z_5 = (((1f - _e32.y) * (1f + _e36.z)) - _e40.z);
    let _e45 = z_5;
    let _e48 = z_5;
    r_6 = sqrt(clamp(((1f - _e45) * (1f + _e48)), 0f, 1f));
    let _e56 = r_6;
    let _e57 = phi_2;
    let _e60 = r_6;
    let _e61 = phi_2;
    let _e64 = z_5;
    let _e66 = seen;
    h_6 = (vec3<f32>((_e56 * cos(_e57)), (_e60 * sin(_e61)), _e64) + _e66);
    let _e69 = alpha_41;
    let _e71 = h_6;
    let _e74 = alpha_41;
    let _e76 = h_6;
    let _e79 = h_6;
    m_9 = vec3<f32>((_e69.x * _e71.x), (_e74.y * _e76.y), max(_e79.z, 0f));
    let _e85 = m_9;
    let _e86 = m_9;
    s_2 = dot(_e85, _e86);
    let _e89 = s_2;
    if (_e89 > 0f) {
        let _e92 = m_9;
        let _e93 = s_2;
        local_23 = (_e92 * inverseSqrt(_e93));
    } else {
        local_23 = vec3<f32>(0f, 0f, 1f);
    }
    let _e101 = local_23;
    return _e101;
}

fn ggxAnisoD(h_7: vec3<f32>, alpha_42: vec2<f32>) -> f32 {
    var h_8: vec3<f32>;
    var alpha_43: vec2<f32>;
    var area: f32;
    var p_2: f32;
    var spread_1: f32;
    var t_17: f32;

    h_8 = h_7;
    alpha_43 = alpha_42;
    let _e7 = alpha_43;
    let _e9 = alpha_43;
    area = (_e7.x * _e9.y);
    let _e13 = alpha_43;
    let _e17 = alpha_43;
    if !(((_e13.x > 0f) && (_e17.y > 0f))) {
        return 0f;
    }
    let _e24 = h_8;
    let _e26 = h_8;
    let _e29 = alpha_43;
    let _e31 = alpha_43;
    let _e35 = h_8;
    let _e37 = h_8;
    let _e40 = alpha_43;
    let _e42 = alpha_43;
    p_2 = (((_e24.x * _e26.x) * (_e29.y / _e31.x)) + ((_e35.y * _e37.y) * (_e40.x / _e42.y)));
    let _e48 = p_2;
    let _e49 = area;
    let _e50 = h_8;
    let _e53 = h_8;
    spread_1 = (_e48 + ((_e49 * _e50.z) * _e53.z));
    let _e58 = spread_1;
    if !((_e58 > 0f)) {
        return 0f;
    }
    let _e63 = area;
    let _e65 = h_8;
    let _e66 = h_8;
    let _e69 = spread_1;
    t_17 = ((sqrt(_e63) * dot(_e65, _e66)) / _e69);
    let _e72 = t_17;
    let _e73 = t_17;
    return ((_e72 * _e73) / BSDF_PI);
}

fn ggxAnisoRoot(w_14: vec3<f32>, alpha_44: vec2<f32>) -> f32 {
    var w_15: vec3<f32>;
    var alpha_45: vec2<f32>;

    w_15 = w_14;
    alpha_45 = alpha_44;
    let _e7 = alpha_45;
    let _e9 = w_15;
    let _e12 = alpha_45;
    let _e14 = w_15;
    let _e17 = w_15;
    return length(vec3<f32>((_e7.x * _e9.x), (_e12.y * _e14.y), _e17.z));
}

fn ggxAnisoLambda(w_16: vec3<f32>, alpha_46: vec2<f32>) -> f32 {
    var w_17: vec3<f32>;
    var alpha_47: vec2<f32>;
    var z_6: f32;
    var x_1: f32;
    var y: f32;
    var slope_2: f32;
    var below_1: f32;
    var local_24: f32;

    w_17 = w_16;
    alpha_47 = alpha_46;
    let _e7 = w_17;
    z_6 = abs(_e7.z);
    let _e11 = alpha_47;
    let _e13 = w_17;
    x_1 = (_e11.x * _e13.x);
    let _e17 = alpha_47;
    let _e19 = w_17;
    y = (_e17.y * _e19.y);
    let _e23 = x_1;
    let _e24 = x_1;
    let _e26 = y;
    let _e27 = y;
    slope_2 = ((_e23 * _e24) + (_e26 * _e27));
    let _e32 = z_6;
    let _e34 = z_6;
    let _e35 = w_17;
    let _e36 = alpha_47;
    let _e37 = ggxAnisoRoot(_e35, _e36);
    below_1 = ((2f * _e32) * (_e34 + _e37));
    let _e41 = slope_2;
    let _e43 = below_1;
    if (_e41 < (1000000000000000000000000000000f * _e43)) {
        let _e46 = slope_2;
        let _e47 = below_1;
        local_24 = (_e46 / _e47);
    } else {
        local_24 = 1000000000000000000000000000000f;
    }
    let _e51 = local_24;
    return _e51;
}

fn ggxAnisoG1(w_18: vec3<f32>, alpha_48: vec2<f32>) -> f32 {
    var w_19: vec3<f32>;
    var alpha_49: vec2<f32>;
    var sum_9: f32;
    var local_25: f32;

    w_19 = w_18;
    alpha_49 = alpha_48;
    let _e7 = w_19;
    let _e10 = w_19;
    let _e11 = alpha_49;
    let _e12 = ggxAnisoRoot(_e10, _e11);
    sum_9 = (abs(_e7.z) + _e12);
    let _e15 = sum_9;
    if (_e15 > 0f) {
        let _e19 = w_19;
        let _e23 = sum_9;
        local_25 = ((2f * abs(_e19.z)) / _e23);
    } else {
        local_25 = 0f;
    }
    let _e27 = local_25;
    return _e27;
}

fn ggxAnisoG2(wi_24: vec3<f32>, wo_26: vec3<f32>, alpha_50: vec2<f32>) -> f32 {
    var wi_25: vec3<f32>;
    var wo_27: vec3<f32>;
    var alpha_51: vec2<f32>;

    wi_25 = wi_24;
    wo_27 = wo_26;
    alpha_51 = alpha_50;
    let _e9 = wi_25;
    let _e10 = alpha_51;
    let _e11 = ggxAnisoG1(_e9, _e10);
    let _e12 = wo_27;
    let _e13 = alpha_51;
    let _e14 = ggxAnisoG1(_e12, _e13);
    return (_e11 * _e14);
}

fn ggxAnisoV(wi_26: vec3<f32>, wo_28: vec3<f32>, alpha_52: vec2<f32>) -> f32 {
    var wi_27: vec3<f32>;
    var wo_29: vec3<f32>;
    var alpha_53: vec2<f32>;
    var sum_10: f32;
    var local_26: f32;

    wi_27 = wi_26;
    wo_29 = wo_28;
    alpha_53 = alpha_52;
    let _e9 = wi_27;
    let _e12 = wi_27;
    let _e13 = alpha_53;
    let _e14 = ggxAnisoRoot(_e12, _e13);
    let _e16 = wo_29;
    let _e19 = wo_29;
    let _e20 = alpha_53;
    let _e21 = ggxAnisoRoot(_e19, _e20);
    sum_10 = ((abs(_e9.z) + _e14) * (abs(_e16.z) + _e21));
    let _e25 = sum_10;
    if (_e25 > 0f) {
        let _e29 = sum_10;
        local_26 = (1f / _e29);
    } else {
        local_26 = 0f;
    }
    let _e33 = local_26;
    return _e33;
}

fn ggxAnisoVCorrelated(wi_28: vec3<f32>, wo_30: vec3<f32>, alpha_54: vec2<f32>) -> f32 {
    var wi_29: vec3<f32>;
    var wo_31: vec3<f32>;
    var alpha_55: vec2<f32>;
    var sum_11: f32;
    var local_27: f32;

    wi_29 = wi_28;
    wo_31 = wo_30;
    alpha_55 = alpha_54;
    let _e9 = wi_29;
    let _e10 = alpha_55;
    let _e11 = ggxAnisoRoot(_e9, _e10);
    let _e12 = wo_31;
    let _e16 = wo_31;
    let _e17 = alpha_55;
    let _e18 = ggxAnisoRoot(_e16, _e17);
    let _e19 = wi_29;
    sum_11 = ((_e11 * abs(_e12.z)) + (_e18 * abs(_e19.z)));
    let _e25 = sum_11;
    if (_e25 > 0f) {
        let _e29 = sum_11;
        local_27 = (0.5f / _e29);
    } else {
        local_27 = 0f;
    }
    let _e33 = local_27;
    return _e33;
}

fn ggxAnisoPdf(h_9: vec3<f32>, alpha_56: vec2<f32>) -> f32 {
    var h_10: vec3<f32>;
    var alpha_57: vec2<f32>;

    h_10 = h_9;
    alpha_57 = alpha_56;
    let _e7 = h_10;
    let _e8 = alpha_57;
    let _e9 = ggxAnisoD(_e7, _e8);
    let _e10 = h_10;
    let _e11 = tilt(_e10);
    let _e12 = tiltCos(_e11);
    return (_e9 * _e12);
}

fn ggxAnisoPdfVisible(f_11: Facet, h_11: vec3<f32>, wo_32: vec3<f32>, alpha_58: vec2<f32>) -> f32 {
    var f_12: Facet;
    var h_12: vec3<f32>;
    var wo_33: vec3<f32>;
    var alpha_59: vec2<f32>;

    f_12 = f_11;
    h_12 = h_11;
    wo_33 = wo_32;
    alpha_59 = alpha_58;
    let _e11 = f_12;
    if !(_e11.exists) {
        return 0f;
    }
    let _e16 = f_12;
    let _e19 = h_12;
    let _e20 = alpha_59;
    let _e21 = ggxAnisoD(_e19, _e20);
    let _e23 = wo_33;
    let _e26 = wo_33;
    let _e27 = alpha_59;
    let _e28 = ggxAnisoRoot(_e26, _e27);
    return (((2f * _e16.woDotM) * _e21) / (abs(_e23.z) + _e28));
}

fn ggxAnisoSample(alpha_60: vec2<f32>, u_7: vec2<f32>) -> vec3<f32> {
    var alpha_61: vec2<f32>;
    var u_8: vec2<f32>;
    var phi_3: f32;
    var across_6: f32;

    alpha_61 = alpha_60;
    u_8 = u_7;
    let _e10 = u_8;
    phi_3 = (6.2831855f * _e10.y);
    let _e14 = u_8;
    across_6 = sqrt(_e14.x);
    let _e18 = alpha_61;
    let _e20 = across_6;
    let _e22 = phi_3;
    let _e25 = alpha_61;
    let _e27 = across_6;
    let _e29 = phi_3;
    let _e33 = u_8;
    return normalize(vec3<f32>(((_e18.x * _e20) * cos(_e22)), ((_e25.y * _e27) * sin(_e29)), sqrt(max((1f - _e33.x), 0f))));
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
    let _e5 = x_3;
    if (_e5 > 1f) {
        let _e9 = x_3;
        return log((1f + _e9));
    }
    let _e12 = x_3;
    t_18 = max(_e12, 0f);
    let _e16 = t_18;
    whole = (_e16 <= 0.4f);
    let _e20 = whole;
    if _e20 {
        let _e21 = t_18;
        local_28 = _e21;
    } else {
        let _e22 = t_18;
        let _e25 = t_18;
        local_28 = (_e22 / (1f + sqrt((1f + _e25))));
    }
    let _e31 = local_28;
    h_13 = _e31;
    let _e33 = h_13;
    let _e35 = h_13;
    y_1 = (_e33 / (2f + _e35));
    let _e39 = y_1;
    let _e40 = y_1;
    y2_ = (_e39 * _e40);
    let _e46 = y2_;
    let _e50 = y2_;
    tail = (0.05882353f + (_e46 * (0.05263158f + (_e50 * 0.04761905f))));
    let _e62 = y2_;
    let _e66 = y2_;
    let _e70 = y2_;
    let _e71 = tail;
    tail = (0.09090909f + (_e62 * (0.07692308f + (_e66 * (0.06666667f + (_e70 * _e71))))));
    let _e81 = y2_;
    let _e85 = y2_;
    let _e89 = y2_;
    let _e90 = tail;
    tail = (0.2f + (_e81 * (0.14285715f + (_e85 * (0.11111111f + (_e89 * _e90))))));
    let _e97 = whole;
    if _e97 {
        local_29 = 2f;
    } else {
        local_29 = 4f;
    }
    let _e101 = local_29;
    let _e102 = y_1;
    let _e105 = y2_;
    let _e109 = y2_;
    let _e110 = tail;
    return ((_e101 * _e102) * (1f + (_e105 * (0.33333334f + (_e109 * _e110)))));
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
    let _e10 = eAvg_1;
    lost = (1f - _e10);
    let _e13 = lost;
    if (_e13 > 0f) {
        let _e17 = eI_1;
        let _e20 = eO_1;
        let _e23 = lost;
        local_30 = (((1f - _e17) * (1f - _e20)) / (BSDF_PI * _e23));
    } else {
        local_30 = 0f;
    }
    let _e28 = local_30;
    return _e28;
}

fn multipleFresnel(f_13: f32, eAvg_2: f32) -> f32 {
    var f_14: f32;
    var eAvg_3: f32;
    var left: f32;
    var local_31: f32;

    f_14 = f_13;
    eAvg_3 = eAvg_2;
    let _e8 = f_14;
    let _e10 = eAvg_3;
    left = (1f - (_e8 * (1f - _e10)));
    let _e15 = left;
    if (_e15 > 0f) {
        let _e18 = f_14;
        let _e19 = f_14;
        let _e21 = eAvg_3;
        let _e23 = left;
        local_31 = (((_e18 * _e19) * _e21) / _e23);
    } else {
        local_31 = 0f;
    }
    let _e27 = local_31;
    return _e27;
}

fn multipleFresnelRgb(f_15: vec3<f32>, eAvg_4: f32) -> vec3<f32> {
    var f_16: vec3<f32>;
    var eAvg_5: f32;

    f_16 = f_15;
    eAvg_5 = eAvg_4;
    let _e7 = f_16;
    let _e9 = eAvg_5;
    let _e10 = multipleFresnel(_e7.x, _e9);
    let _e11 = f_16;
    let _e13 = eAvg_5;
    let _e14 = multipleFresnel(_e11.y, _e13);
    let _e15 = f_16;
    let _e17 = eAvg_5;
    let _e18 = multipleFresnel(_e15.z, _e17);
    return vec3<f32>(_e10, _e14, _e18);
}

fn multipleScatteringSplit(r1_: f32, t1_: f32, cosO_2: f32, alpha_62: f32, eta_28: f32) -> SplitEnergy {
    var r1_1: f32;
    var t1_1: f32;
    var cosO_3: f32;
    var alpha_63: f32;
    var eta_29: f32;
    var lost_1: f32;
    var local_32: f32;
    var outward: f32;
    var e: SplitEnergy;

    r1_1 = r1_;
    t1_1 = t1_;
    cosO_3 = cosO_2;
    alpha_63 = alpha_62;
    eta_29 = eta_28;
    let _e14 = r1_1;
    let _e16 = t1_1;
    lost_1 = max(((1f - _e14) - _e16), 0f);
    let _e21 = eta_29;
    if (_e21 < 1f) {
        let _e25 = eta_29;
        let _e26 = eta_29;
        let _e28 = cosO_3;
        let _e32 = alpha_63;
        local_32 = (1f - (((_e25 * _e26) * _e28) * (0.35f + (0.55f * min(_e32, 1f)))));
    } else {
        local_32 = 0f;
    }
    let _e41 = local_32;
    outward = _e41;
    let _e45 = r1_1;
    let _e46 = lost_1;
    let _e47 = outward;
    e.reflected = (_e45 + (_e46 * _e47));
    let _e52 = e;
    e.transmitted = (1f - _e52.reflected);
    let _e55 = e;
    return _e55;
}

fn phongExponent(alpha_64: f32) -> f32 {
    var alpha_65: f32;
    var a2_1: f32;

    alpha_65 = alpha_64;
    let _e5 = alpha_65;
    let _e6 = alpha_65;
    a2_1 = max((_e5 * _e6), 0.000000000000000001f);
    let _e13 = a2_1;
    let _e16 = a2_1;
    return max(((2f * (1f - _e13)) / _e16), 0f);
}

fn phongAlpha(exponent: f32) -> f32 {
    var exponent_1: f32;

    exponent_1 = exponent;
    let _e6 = exponent_1;
    return sqrt((2f / (max(_e6, 0f) + 2f)));
}

fn phongD(m_10: Tilt, exponent_2: f32) -> f32 {
    var m_11: Tilt;
    var exponent_3: f32;
    var z2_: f32;
    var tan2_: f32;

    m_11 = m_10;
    exponent_3 = exponent_2;
    let _e7 = m_11;
    let _e9 = m_11;
    z2_ = (_e7.z * _e9.z);
    let _e13 = z2_;
    if !((_e13 > 0f)) {
        return 0f;
    }
    let _e18 = m_11;
    let _e20 = z2_;
    tan2_ = min((_e18.p / _e20), 10000000000000000000000000000000000000f);
    let _e25 = exponent_3;
    let _e34 = exponent_3;
    let _e36 = tan2_;
    let _e37 = log1pPositive(_e36);
    return (((_e25 + 2f) / 6.2831855f) * exp(((-0.5f * _e34) * _e37)));
}

fn phongG1(w_20: Tilt, exponent_4: f32) -> f32 {
    var w_21: Tilt;
    var exponent_5: f32;

    w_21 = w_20;
    exponent_5 = exponent_4;
    let _e7 = w_21;
    let _e8 = exponent_5;
    let _e9 = phongAlpha(_e8);
    let _e10 = beckmannG1(_e7, _e9);
    return _e10;
}

fn phongG2(wi_30: Tilt, wo_34: Tilt, exponent_6: f32) -> f32 {
    var wi_31: Tilt;
    var wo_35: Tilt;
    var exponent_7: f32;

    wi_31 = wi_30;
    wo_35 = wo_34;
    exponent_7 = exponent_6;
    let _e9 = wi_31;
    let _e10 = wo_35;
    let _e11 = exponent_7;
    let _e12 = phongAlpha(_e11);
    let _e13 = beckmannG2(_e9, _e10, _e12);
    return _e13;
}

fn phongV(wi_32: Tilt, wo_36: Tilt, exponent_8: f32) -> f32 {
    var wi_33: Tilt;
    var wo_37: Tilt;
    var exponent_9: f32;

    wi_33 = wi_32;
    wo_37 = wo_36;
    exponent_9 = exponent_8;
    let _e9 = wi_33;
    let _e10 = wo_37;
    let _e11 = exponent_9;
    let _e12 = phongAlpha(_e11);
    let _e13 = beckmannV(_e9, _e10, _e12);
    return _e13;
}

fn phongPdf(m_12: Tilt, exponent_10: f32) -> f32 {
    var m_13: Tilt;
    var exponent_11: f32;

    m_13 = m_12;
    exponent_11 = exponent_10;
    let _e7 = m_13;
    let _e8 = exponent_11;
    let _e9 = phongD(_e7, _e8);
    let _e10 = m_13;
    let _e11 = tiltCos(_e10);
    return (_e9 * _e11);
}

fn phongSample(exponent_12: f32, u_9: vec2<f32>) -> vec3<f32> {
    var exponent_13: f32;
    var u_10: vec2<f32>;
    var phi_4: f32;
    var z_7: f32;
    var r_7: f32;

    exponent_13 = exponent_12;
    u_10 = u_9;
    let _e10 = u_10;
    phi_4 = (6.2831855f * _e10.y);
    let _e15 = u_10;
    let _e19 = exponent_13;
    z_7 = exp((log((1f - _e15.x)) / (_e19 + 2f)));
    let _e26 = z_7;
    let _e29 = z_7;
    r_7 = sqrt(max(((1f - _e26) * (1f + _e29)), 0f));
    let _e36 = r_7;
    let _e37 = phi_4;
    let _e40 = r_7;
    let _e41 = phi_4;
    let _e44 = z_7;
    return vec3<f32>((_e36 * cos(_e37)), (_e40 * sin(_e41)), _e44);
}

fn reflectionLobe(f_17: Facet, d: f32, v_10: f32) -> f32 {
    var f_18: Facet;
    var d_1: f32;
    var v_11: f32;
    var local_33: f32;

    f_18 = f_17;
    d_1 = d;
    v_11 = v_10;
    let _e9 = f_18;
    let _e11 = d_1;
    if (_e9.exists && (_e11 > 0f)) {
        let _e15 = d_1;
        let _e16 = v_11;
        local_33 = (_e15 * _e16);
    } else {
        local_33 = 0f;
    }
    let _e20 = local_33;
    return _e20;
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
    let _e11 = f_20;
    let _e12 = d_3;
    let _e13 = v_13;
    let _e14 = f_20;
    let _e16 = f_20;
    let _e18 = eta_31;
    let _e19 = fresnelDielectric(_e14.woDotM, _e16.g, _e18);
    let _e21 = reflectionLobe(_e11, _e12, (_e13 * _e19));
    return _e21;
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
    let _e11 = f_22;
    let _e12 = d_5;
    let _e13 = v_15;
    let _e14 = eta_33;
    let _e15 = reflectionF(_e11, _e12, _e13, _e14);
    let _e16 = f_22;
    return (_e15 * _e16.wi.z);
}

fn reflectionPdf(f_23: Facet, pdfM: f32) -> f32 {
    var f_24: Facet;
    var pdfM_1: f32;

    f_24 = f_23;
    pdfM_1 = pdfM;
    let _e7 = pdfM_1;
    let _e8 = f_24;
    let _e9 = reflectionJacobian(_e8);
    return (_e7 * _e9);
}

fn reflectAbout(wo_38: vec3<f32>, wm: vec3<f32>) -> vec3<f32> {
    var wo_39: vec3<f32>;
    var wm_1: vec3<f32>;

    wo_39 = wo_38;
    wm_1 = wm;
    let _e8 = wo_39;
    let _e9 = wm_1;
    let _e12 = wm_1;
    let _e14 = wo_39;
    return (((2f * dot(_e8, _e9)) * _e12) - _e14);
}

fn stirlingRest(x_4: f32) -> f32 {
    var x_5: f32;
    var r_8: f32;
    var r2_: f32;

    x_5 = x_4;
    let _e6 = x_5;
    r_8 = (1f / _e6);
    let _e9 = r_8;
    let _e10 = r_8;
    r2_ = (_e9 * _e10);
    let _e13 = r_8;
    let _e17 = r2_;
    let _e21 = r2_;
    let _e25 = r2_;
    let _e29 = r2_;
    return (_e13 * (0.083333336f - (_e17 * (0.0027777778f - (_e21 * (0.0007936508f - (_e25 * (0.0005952381f - (_e29 / 1188f)))))))));
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
    let _e8 = lambdaI_1;
    x_6 = (7f + _e8);
    let _e12 = lambdaO_1;
    y_2 = (7f + _e12);
    let _e15 = x_6;
    let _e16 = y_2;
    let _e17 = x_6;
    let _e19 = log1pPositive((_e16 / _e17));
    let _e21 = y_2;
    let _e22 = x_6;
    let _e23 = y_2;
    let _e25 = log1pPositive((_e22 / _e23));
    power = ((_e15 * _e19) + (_e21 * _e25));
    let _e29 = x_6;
    let _e30 = stirlingRest(_e29);
    let _e31 = y_2;
    let _e32 = stirlingRest(_e31);
    let _e34 = x_6;
    let _e35 = y_2;
    let _e37 = stirlingRest((_e34 + _e35));
    rest_4 = ((_e30 + _e32) - _e37);
    let _e40 = power;
    root = exp((-(_e40) / 6f));
    let _e50 = x_6;
    let _e53 = y_2;
    let _e58 = rest_4;
    product_3 = (sqrt((6.2831855f * ((1f / _e50) + (1f / _e53)))) * exp(_e58));
    loop {
        let _e64 = k_10;
        if !((_e64 < 6i)) {
            break;
        }
        {
            let _e71 = x_6;
            x_6 = (_e71 - 1f);
            let _e74 = y_2;
            y_2 = (_e74 - 1f);
            let _e77 = product_3;
            let _e78 = x_6;
            let _e79 = y_2;
            let _e81 = x_6;
            let _e83 = root;
            let _e85 = x_6;
            let _e86 = y_2;
            let _e90 = y_2;
            product_3 = (_e77 * ((((_e78 + _e79) / _e81) * _e83) * (((_e85 + _e86) + 1f) / _e90)));
        }
        continuing {
            let _e68 = k_10;
            k_10 = (_e68 + 1i);
        }
    }
    let _e94 = product_3;
    return min(_e94, 1f);
}

fn ggxG2Beta(wi_34: Tilt, wo_40: Tilt, alpha_66: f32) -> f32 {
    var wi_35: Tilt;
    var wo_41: Tilt;
    var alpha_67: f32;

    wi_35 = wi_34;
    wo_41 = wo_40;
    alpha_67 = alpha_66;
    let _e9 = wi_35;
    let _e10 = alpha_67;
    let _e11 = ggxLambda(_e9, _e10);
    let _e12 = wo_41;
    let _e13 = alpha_67;
    let _e14 = ggxLambda(_e12, _e13);
    let _e15 = smithG2Beta(_e11, _e14);
    return _e15;
}

fn ggxVBeta(wi_36: Tilt, wo_42: Tilt, alpha_68: f32) -> f32 {
    var wi_37: Tilt;
    var wo_43: Tilt;
    var alpha_69: f32;
    var cosines: f32;
    var local_34: f32;

    wi_37 = wi_36;
    wo_43 = wo_42;
    alpha_69 = alpha_68;
    let _e10 = wi_37;
    let _e13 = wo_43;
    cosines = ((4f * _e10.z) * _e13.z);
    let _e17 = cosines;
    if (_e17 > 0f) {
        let _e20 = wi_37;
        let _e21 = wo_43;
        let _e22 = alpha_69;
        let _e23 = ggxG2Beta(_e20, _e21, _e22);
        let _e24 = cosines;
        local_34 = (_e23 / _e24);
    } else {
        local_34 = 0f;
    }
    let _e28 = local_34;
    return _e28;
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
    let _e11 = f_26;
    let _e13 = d_7;
    if !((_e11.exists && (_e13 > 0f))) {
        return 0f;
    }
    let _e19 = f_26;
    let _e21 = f_26;
    let _e23 = eta_35;
    let _e24 = fresnelTransmitted(_e19.woDotM, _e21.g, _e23);
    through = _e24;
    let _e27 = eta_35;
    let _e29 = f_26;
    let _e32 = v_17;
    let _e34 = eta_35;
    let _e35 = f_26;
    let _e38 = f_26;
    let _e41 = d_7;
    let _e44 = through;
    return (((((4f * _e27) * _e29.wiDotM) * _e32) * (((_e34 * _e35.woDotM) / _e38.s) * _e41)) * _e44);
}

fn transmissionF(f_27: Facet, d_8: f32, v_18: f32, eta_36: f32) -> f32 {
    var f_28: Facet;
    var d_9: f32;
    var v_19: f32;
    var eta_37: f32;
    var scatter: f32;
    var local_35: f32;

    f_28 = f_27;
    d_9 = d_8;
    v_19 = v_18;
    eta_37 = eta_36;
    let _e11 = f_28;
    let _e12 = d_9;
    let _e13 = v_19;
    let _e14 = eta_37;
    let _e15 = transmissionScatter(_e11, _e12, _e13, _e14);
    scatter = _e15;
    let _e17 = f_28;
    if _e17.exists {
        let _e19 = scatter;
        let _e20 = eta_37;
        let _e21 = eta_37;
        local_35 = (_e19 / (_e20 * _e21));
    } else {
        local_35 = 0f;
    }
    let _e26 = local_35;
    return _e26;
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
    let _e11 = f_30;
    let _e12 = d_11;
    let _e13 = v_21;
    let _e14 = eta_39;
    let _e15 = transmissionF(_e11, _e12, _e13, _e14);
    let _e16 = f_30;
    return (_e15 * _e16.wi.z);
}

fn transmissionPdf(f_31: Facet, pdfM_2: f32, eta_40: f32) -> f32 {
    var f_32: Facet;
    var pdfM_3: f32;
    var eta_41: f32;

    f_32 = f_31;
    pdfM_3 = pdfM_2;
    eta_41 = eta_40;
    let _e9 = pdfM_3;
    let _e10 = f_32;
    let _e11 = eta_41;
    let _e12 = transmissionJacobian(_e10, _e11);
    return (_e9 * _e12);
}

fn refractAbout(wo_44: vec3<f32>, wm_2: vec3<f32>, eta_42: f32) -> vec3<f32> {
    var wo_45: vec3<f32>;
    var wm_3: vec3<f32>;
    var eta_43: f32;
    var local_36: f32;
    var side_2: f32;
    var c_15: f32;
    var g_6: f32;
    var along_2: f32;

    wo_45 = wo_44;
    wm_3 = wm_2;
    eta_43 = eta_42;
    let _e9 = wo_45;
    let _e10 = wm_3;
    if (dot(_e9, _e10) < 0f) {
        local_36 = -1f;
    } else {
        local_36 = 1f;
    }
    let _e18 = local_36;
    side_2 = _e18;
    let _e20 = wo_45;
    let _e21 = wm_3;
    c_15 = abs(dot(_e20, _e21));
    let _e25 = c_15;
    let _e26 = eta_43;
    let _e27 = fresnelG(_e25, _e26);
    g_6 = _e27;
    let _e29 = eta_43;
    if (_e29 == 1f) {
        let _e32 = wo_45;
        return -(_e32);
    }
    let _e34 = g_6;
    let _e37 = eta_43;
    if !(((_e34 > 0f) && (_e37 > 0f))) {
        return vec3(0f);
    }
    let _e45 = eta_43;
    let _e48 = eta_43;
    let _e51 = c_15;
    let _e52 = g_6;
    along_2 = (((1f - _e45) * (1f + _e48)) / (_e51 + _e52));
    let _e56 = side_2;
    let _e57 = along_2;
    let _e59 = wm_3;
    let _e61 = wo_45;
    let _e63 = eta_43;
    return ((((_e56 * _e57) * _e59) - _e61) / vec3(_e63));
}

fn bsdfNoValues() -> BsdfValues {
    var r_9: BsdfValues;

    r_9.d = 0f;
    r_9.g = 0f;
    r_9.gCorrelated = 0f;
    r_9.fresnel = 0f;
    r_9.transmitted = 0f;
    r_9.f = 0f;
    r_9.fCos = 0f;
    r_9.fCorrelated = 0f;
    r_9.pdfD = 0f;
    r_9.pdfVisible = 0f;
    let _e27 = r_9;
    return _e27;
}

fn bsdfShape(f_33: Facet, distribution: i32, alpha_70: f32) -> BsdfShape {
    var f_34: Facet;
    var distribution_1: i32;
    var alpha_71: f32;
    var r_10: BsdfShape;

    f_34 = f_33;
    distribution_1 = distribution;
    alpha_71 = alpha_70;
    r_10.vCorrelated = 0f;
    let _e15 = distribution_1;
    if (_e15 == BSDF_GGX) {
        {
            let _e18 = f_34;
            let _e20 = alpha_71;
            let _e21 = ggxD(_e18.h, _e20);
            r_10.d = _e21;
            let _e23 = f_34;
            let _e25 = f_34;
            let _e27 = alpha_71;
            let _e28 = ggxG2(_e23.wi, _e25.wo, _e27);
            r_10.g = _e28;
            let _e30 = f_34;
            let _e32 = f_34;
            let _e34 = alpha_71;
            let _e35 = ggxV(_e30.wi, _e32.wo, _e34);
            r_10.v = _e35;
            let _e37 = f_34;
            let _e39 = f_34;
            let _e41 = alpha_71;
            let _e42 = ggxVCorrelated(_e37.wi, _e39.wo, _e41);
            r_10.vCorrelated = _e42;
        }
    } else {
        let _e43 = distribution_1;
        if (_e43 == BSDF_BECKMANN) {
            {
                let _e46 = f_34;
                let _e48 = alpha_71;
                let _e49 = beckmannD(_e46.h, _e48);
                r_10.d = _e49;
                let _e51 = f_34;
                let _e53 = f_34;
                let _e55 = alpha_71;
                let _e56 = beckmannG2(_e51.wi, _e53.wo, _e55);
                r_10.g = _e56;
                let _e58 = f_34;
                let _e60 = f_34;
                let _e62 = alpha_71;
                let _e63 = beckmannV(_e58.wi, _e60.wo, _e62);
                r_10.v = _e63;
            }
        } else {
            {
                let _e65 = f_34;
                let _e67 = alpha_71;
                let _e68 = phongD(_e65.h, _e67);
                r_10.d = _e68;
                let _e70 = f_34;
                let _e72 = f_34;
                let _e74 = alpha_71;
                let _e75 = phongG2(_e70.wi, _e72.wo, _e74);
                r_10.g = _e75;
                let _e77 = f_34;
                let _e79 = f_34;
                let _e81 = alpha_71;
                let _e82 = phongV(_e77.wi, _e79.wo, _e81);
                r_10.v = _e82;
            }
        }
    }
    let _e83 = r_10;
    return _e83;
}

fn bsdfValues(f_35: Facet, surface: BsdfSurface) -> BsdfValues {
    var f_36: Facet;
    var surface_1: BsdfSurface;
    var r_11: BsdfValues;
    var shape: BsdfShape;
    var ggx: bool;
    var metal: bool;
    var pdfM_4: f32;
    var local_37: f32;
    var pdfVisibleM: f32;
    var local_38: f32;
    var local_39: f32;
    var local_40: f32;

    f_36 = f_35;
    surface_1 = surface;
    let _e10 = bsdfNoValues();
    r_11 = _e10;
    let _e12 = f_36;
    if !(_e12.exists) {
        let _e15 = r_11;
        return _e15;
    }
    let _e16 = f_36;
    let _e17 = surface_1;
    let _e19 = surface_1;
    let _e21 = bsdfShape(_e16, _e17.distribution, _e19.alpha);
    shape = _e21;
    let _e23 = surface_1;
    ggx = (_e23.distribution == BSDF_GGX);
    let _e27 = surface_1;
    metal = (_e27.eta == 0f);
    let _e32 = shape;
    let _e34 = f_36;
    let _e36 = tiltCos(_e34.h);
    pdfM_4 = (_e32.d * _e36);
    let _e39 = ggx;
    if _e39 {
        let _e40 = f_36;
        let _e41 = surface_1;
        let _e43 = ggxPdfVisible(_e40, _e41.alpha);
        local_37 = _e43;
    } else {
        local_37 = 0f;
    }
    let _e46 = local_37;
    pdfVisibleM = _e46;
    let _e49 = shape;
    r_11.d = _e49.d;
    let _e52 = shape;
    r_11.g = _e52.g;
    let _e55 = ggx;
    if _e55 {
        let _e56 = f_36;
        let _e58 = f_36;
        let _e60 = surface_1;
        let _e62 = ggxG2Correlated(_e56.wi, _e58.wo, _e60.alpha);
        local_38 = _e62;
    } else {
        local_38 = 0f;
    }
    let _e65 = local_38;
    r_11.gCorrelated = _e65;
    let _e67 = metal;
    if _e67 {
        let _e68 = f_36;
        let _e70 = surface_1;
        let _e72 = surface_1;
        let _e74 = fresnelConductor(_e68.woDotM, _e70.n, _e72.k);
        local_39 = _e74;
    } else {
        let _e75 = f_36;
        let _e77 = f_36;
        let _e79 = surface_1;
        let _e81 = fresnelDielectric(_e75.woDotM, _e77.g, _e79.eta);
        local_39 = _e81;
    }
    let _e83 = local_39;
    r_11.fresnel = _e83;
    let _e85 = metal;
    if _e85 {
        let _e86 = f_36;
        let _e88 = surface_1;
        let _e90 = surface_1;
        let _e92 = fresnelAbsorbed(_e86.woDotM, _e88.n, _e90.k);
        local_40 = _e92;
    } else {
        let _e93 = f_36;
        let _e95 = f_36;
        let _e97 = surface_1;
        let _e99 = fresnelTransmitted(_e93.woDotM, _e95.g, _e97.eta);
        local_40 = _e99;
    }
    let _e101 = local_40;
    r_11.transmitted = _e101;
    let _e102 = surface_1;
    if _e102.transmits {
        {
            let _e105 = f_36;
            let _e106 = shape;
            let _e108 = shape;
            let _e110 = surface_1;
            let _e112 = transmissionScatter(_e105, _e106.d, _e108.v, _e110.eta);
            r_11.f = _e112;
            let _e114 = f_36;
            let _e115 = shape;
            let _e117 = shape;
            let _e119 = surface_1;
            let _e121 = transmissionScatter(_e114, _e115.d, _e117.vCorrelated, _e119.eta);
            r_11.fCorrelated = _e121;
            let _e123 = f_36;
            let _e124 = pdfM_4;
            let _e125 = surface_1;
            let _e127 = transmissionPdf(_e123, _e124, _e125.eta);
            r_11.pdfD = _e127;
            let _e129 = f_36;
            let _e130 = pdfVisibleM;
            let _e131 = surface_1;
            let _e133 = transmissionPdf(_e129, _e130, _e131.eta);
            r_11.pdfVisible = _e133;
        }
    } else {
        {
            let _e135 = f_36;
            let _e136 = shape;
            let _e138 = shape;
            let _e140 = r_11;
            let _e143 = reflectionLobe(_e135, _e136.d, (_e138.v * _e140.fresnel));
            r_11.f = _e143;
            let _e145 = f_36;
            let _e146 = shape;
            let _e148 = shape;
            let _e150 = r_11;
            let _e153 = reflectionLobe(_e145, _e146.d, (_e148.vCorrelated * _e150.fresnel));
            r_11.fCorrelated = _e153;
            let _e155 = f_36;
            let _e156 = pdfM_4;
            let _e157 = reflectionPdf(_e155, _e156);
            r_11.pdfD = _e157;
            let _e159 = f_36;
            let _e160 = pdfVisibleM;
            let _e161 = reflectionPdf(_e159, _e160);
            r_11.pdfVisible = _e161;
        }
    }
    let _e163 = r_11;
    let _e165 = f_36;
    r_11.fCos = (_e163.f * _e165.wi.z);
    let _e169 = r_11;
    return _e169;
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
    let _e14 = surface_3;
    if _e14.transmits {
        let _e16 = wi_39;
        let _e17 = wo_47;
        let _e18 = n_25;
        let _e19 = surface_3;
        let _e21 = transmissionFacet(_e16, _e17, _e18, _e19.eta);
        return _e21;
    }
    let _e22 = wi_39;
    let _e23 = wo_47;
    let _e24 = n_25;
    let _e25 = surface_3;
    let _e27 = reflectionFacet(_e22, _e23, _e24, _e25.eta);
    return _e27;
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
    let _e14 = surface_5;
    if _e14.transmits {
        let _e16 = wi_41;
        let _e17 = wo_49;
        let _e18 = n_27;
        let _e19 = surface_5;
        let _e21 = preciseTransmissionFacet(_e16, _e17, _e18, _e19.eta);
        return _e21;
    }
    let _e22 = wi_41;
    let _e23 = wo_49;
    let _e24 = n_27;
    let _e25 = surface_5;
    let _e27 = preciseReflectionFacet(_e22, _e23, _e24, _e25.eta);
    return _e27;
}

fn srgbFromLinear(linear: f32) -> f32 {
    var linear_1: f32;
    var v_22: f32;
    var local_41: f32;

    linear_1 = linear;
    let _e8 = linear_1;
    v_22 = clamp(_e8, 0f, 1f);
    let _e13 = v_22;
    if (_e13 <= 0.0031308f) {
        let _e17 = v_22;
        local_41 = (12.92f * _e17);
    } else {
        let _e20 = v_22;
        local_41 = ((1.055f * pow(_e20, 0.41666666f)) - 0.055f);
    }
    let _e29 = local_41;
    return _e29;
}

fn linearFromSrgb(encoded: f32) -> f32 {
    var encoded_1: f32;
    var v_23: f32;
    var local_42: f32;

    encoded_1 = encoded;
    let _e8 = encoded_1;
    v_23 = clamp(_e8, 0f, 1f);
    let _e13 = v_23;
    if (_e13 <= 0.04045f) {
        let _e16 = v_23;
        local_42 = (_e16 / 12.92f);
    } else {
        let _e19 = v_23;
        local_42 = pow(((_e19 + 0.055f) / 1.055f), 2.4f);
    }
    let _e27 = local_42;
    return _e27;
}

fn srgbFromLinearRgb(linear_2: vec3<f32>) -> vec3<f32> {
    var linear_3: vec3<f32>;

    linear_3 = linear_2;
    let _e8 = linear_3;
    let _e10 = srgbFromLinear(_e8.x);
    let _e11 = linear_3;
    let _e13 = srgbFromLinear(_e11.y);
    let _e14 = linear_3;
    let _e16 = srgbFromLinear(_e14.z);
    return vec3<f32>(_e10, _e13, _e16);
}

fn linearFromSrgbRgb(encoded_2: vec3<f32>) -> vec3<f32> {
    var encoded_3: vec3<f32>;

    encoded_3 = encoded_2;
    let _e8 = encoded_3;
    let _e10 = linearFromSrgb(_e8.x);
    let _e11 = encoded_3;
    let _e13 = linearFromSrgb(_e11.y);
    let _e14 = encoded_3;
    let _e16 = linearFromSrgb(_e14.z);
    return vec3<f32>(_e10, _e13, _e16);
}

fn tonemapInput(radiance: vec3<f32>) -> vec3<f32> {
    var radiance_1: vec3<f32>;

    radiance_1 = radiance;
    let _e9 = radiance_1;
    return clamp(_e9, vec3(0f), vec3(65504f));
}

fn tonemapMaxOf(c_16: vec3<f32>) -> f32 {
    var c_17: vec3<f32>;

    c_17 = c_16;
    let _e9 = c_17;
    let _e11 = c_17;
    let _e13 = c_17;
    return max(_e9.x, max(_e11.y, _e13.z));
}

fn tonemapNeutral(radiance_2: vec3<f32>) -> vec3<f32> {
    var radiance_3: vec3<f32>;
    var start: f32 = 0.76f;
    var desaturation: f32 = 0.15f;
    var c_18: vec3<f32>;
    var darkest: f32;
    var local_43: f32;
    var peak: f32;
    var room: f32;
    var compressed: f32;
    var keep: f32;

    radiance_3 = radiance_2;
    let _e15 = radiance_3;
    let _e16 = tonemapInput(_e15);
    c_18 = _e16;
    let _e18 = c_18;
    let _e20 = c_18;
    let _e22 = c_18;
    darkest = min(_e18.x, min(_e20.y, _e22.z));
    let _e27 = c_18;
    let _e28 = darkest;
    if (_e28 < 0.08f) {
        let _e31 = darkest;
        let _e33 = darkest;
        let _e35 = darkest;
        local_43 = (_e31 - ((6.25f * _e33) * _e35));
    } else {
        local_43 = 0.04f;
    }
    let _e40 = local_43;
    c_18 = (_e27 - vec3(_e40));
    let _e43 = c_18;
    let _e44 = tonemapMaxOf(_e43);
    peak = _e44;
    let _e46 = peak;
    let _e47 = start;
    if (_e46 < _e47) {
        let _e49 = c_18;
        return _e49;
    }
    let _e51 = start;
    room = (1f - _e51);
    let _e55 = room;
    let _e56 = room;
    let _e58 = peak;
    let _e59 = start;
    let _e61 = room;
    compressed = (1f - ((_e55 * _e56) / ((_e58 - _e59) + _e61)));
    let _e67 = desaturation;
    let _e68 = peak;
    let _e69 = compressed;
    keep = (1f / ((_e67 * (_e68 - _e69)) + 1f));
    let _e76 = compressed;
    let _e78 = c_18;
    let _e79 = compressed;
    let _e80 = peak;
    let _e83 = keep;
    return clamp(mix(vec3(_e76), (_e78 * (_e79 / _e80)), vec3(_e83)), vec3(0f), vec3(1f));
}

fn tonemapRows(r_12: vec3<f32>, g_7: vec3<f32>, b_15: vec3<f32>, c_19: vec3<f32>) -> vec3<f32> {
    var r_13: vec3<f32>;
    var g_8: vec3<f32>;
    var b_16: vec3<f32>;
    var c_20: vec3<f32>;

    r_13 = r_12;
    g_8 = g_7;
    b_16 = b_15;
    c_20 = c_19;
    let _e15 = r_13;
    let _e16 = c_20;
    let _e18 = g_8;
    let _e19 = c_20;
    let _e21 = b_16;
    let _e22 = c_20;
    return vec3<f32>(dot(_e15, _e16), dot(_e18, _e19), dot(_e21, _e22));
}

fn tonemapAces(radiance_4: vec3<f32>) -> vec3<f32> {
    var radiance_5: vec3<f32>;
    var c_21: vec3<f32>;

    radiance_5 = radiance_4;
    let _e21 = radiance_5;
    let _e22 = tonemapInput(_e21);
    let _e23 = tonemapRows(vec3<f32>(0.59719f, 0.35458f, 0.04823f), vec3<f32>(0.076f, 0.90834f, 0.01566f), vec3<f32>(0.0284f, 0.13383f, 0.83777f), _e22);
    c_21 = _e23;
    let _e25 = c_21;
    let _e26 = c_21;
    let _e34 = c_21;
    let _e36 = c_21;
    c_21 = (((_e25 * (_e26 + vec3(0.0245786f))) - vec3(0.000090537f)) / ((_e34 * ((0.983729f * _e36) + vec3(0.432951f))) + vec3(0.238081f)));
    let _e64 = c_21;
    let _e65 = tonemapRows(vec3<f32>(1.60475f, -0.53108f, -0.07367f), vec3<f32>(-0.10208f, 1.10813f, -0.00605f), vec3<f32>(-0.00327f, -0.07276f, 1.07602f), _e64);
    c_21 = _e65;
    let _e66 = c_21;
    return clamp(_e66, vec3(0f), vec3(1f));
}

fn tonemapAgxCurve(x_7: f32) -> f32 {
    var x_8: f32;
    var pivot: f32 = 0.6060606f;
    var local_44: f32;
    var power_1: f32;
    var local_45: f32;
    var width_2: f32;
    var scale_2: f32;

    x_8 = x_7;
    let _e13 = x_8;
    let _e14 = pivot;
    if (_e13 < _e14) {
        local_44 = 3f;
    } else {
        local_44 = 3.25f;
    }
    let _e19 = local_44;
    power_1 = _e19;
    let _e21 = x_8;
    let _e22 = pivot;
    if (_e21 < _e22) {
        let _e24 = pivot;
        local_45 = _e24;
    } else {
        let _e26 = pivot;
        local_45 = (1f - _e26);
    }
    let _e29 = local_45;
    width_2 = _e29;
    let _e32 = power_1;
    let _e34 = width_2;
    let _e35 = power_1;
    scale_2 = (pow(4f, _e32) - pow(_e34, -(_e35)));
    let _e42 = x_8;
    let _e43 = pivot;
    let _e47 = scale_2;
    let _e48 = x_8;
    let _e49 = pivot;
    let _e52 = power_1;
    let _e58 = power_1;
    return (0.5f + ((2f * (_e42 - _e43)) * pow((1f + (_e47 * pow(abs((_e48 - _e49)), _e52))), (-1f / _e58))));
}

fn tonemapAgx(radiance_6: vec3<f32>) -> vec3<f32> {
    var radiance_7: vec3<f32>;
    var blackStop: f32 = -12.473931f;
    var c_22: vec3<f32>;
    var stops: vec3<f32>;

    radiance_7 = radiance_6;
    let _e24 = radiance_7;
    let _e25 = tonemapInput(_e24);
    let _e26 = tonemapRows(vec3<f32>(0.84247905f, 0.0784336f, 0.079223745f), vec3<f32>(0.042328242f, 0.87846863f, 0.07916613f), vec3<f32>(0.042375654f, 0.0784336f, 0.879143f), _e25);
    c_22 = _e26;
    let _e28 = c_22;
    let _e29 = blackStop;
    let _e34 = blackStop;
    stops = ((log2(max(_e28, vec3(exp2(_e29)))) - vec3(_e34)) / vec3(16.5f));
    let _e41 = stops;
    stops = clamp(_e41, vec3(0f), vec3(1f));
    let _e47 = stops;
    let _e49 = tonemapAgxCurve(_e47.x);
    let _e50 = stops;
    let _e52 = tonemapAgxCurve(_e50.y);
    let _e53 = stops;
    let _e55 = tonemapAgxCurve(_e53.z);
    c_22 = vec3<f32>(_e49, _e52, _e55);
    let _e75 = c_22;
    let _e76 = tonemapRows(vec3<f32>(1.196879f, -0.09802088f, -0.09902974f), vec3<f32>(-0.052896854f, 1.1519032f, -0.098961174f), vec3<f32>(-0.052971635f, -0.09804345f, 1.1510737f), _e75);
    c_22 = _e76;
    let _e77 = c_22;
    return pow(clamp(_e77, vec3(0f), vec3(1f)), vec3(2.2f));
}

fn cubeDirection(face: i32, s_3: f32, t_19: f32) -> vec3<f32> {
    var face_1: i32;
    var s_4: f32;
    var t_20: f32;

    face_1 = face;
    s_4 = s_3;
    t_20 = t_19;
    let _e13 = face_1;
    if (_e13 == 0i) {
        let _e17 = t_20;
        let _e19 = s_4;
        return vec3<f32>(1f, -(_e17), -(_e19));
    }
    let _e22 = face_1;
    if (_e22 == 1i) {
        let _e27 = t_20;
        let _e29 = s_4;
        return vec3<f32>(-1f, -(_e27), _e29);
    }
    let _e31 = face_1;
    if (_e31 == 2i) {
        let _e34 = s_4;
        let _e36 = t_20;
        return vec3<f32>(_e34, 1f, _e36);
    }
    let _e38 = face_1;
    if (_e38 == 3i) {
        let _e41 = s_4;
        let _e44 = t_20;
        return vec3<f32>(_e41, -1f, -(_e44));
    }
    let _e47 = face_1;
    if (_e47 == 4i) {
        let _e50 = s_4;
        let _e51 = t_20;
        return vec3<f32>(_e50, -(_e51), 1f);
    }
    let _e55 = s_4;
    let _e57 = t_20;
    return vec3<f32>(-(_e55), -(_e57), -1f);
}

fn cubeCoordinate(index: i32, size: i32) -> f32 {
    var index_1: i32;
    var size_1: i32;

    index_1 = index;
    size_1 = size;
    let _e12 = index_1;
    let _e17 = size_1;
    return ((((2f * f32(_e12)) + 1f) / f32(_e17)) - 1f);
}

fn cubeTexelDirection(face_2: i32, x_9: i32, y_3: i32, size_2: i32) -> vec3<f32> {
    var face_3: i32;
    var x_10: i32;
    var y_4: i32;
    var size_3: i32;

    face_3 = face_2;
    x_10 = x_9;
    y_4 = y_3;
    size_3 = size_2;
    let _e15 = face_3;
    let _e16 = x_10;
    let _e17 = size_3;
    let _e18 = cubeCoordinate(_e16, _e17);
    let _e19 = y_4;
    let _e20 = size_3;
    let _e21 = cubeCoordinate(_e19, _e20);
    let _e22 = cubeDirection(_e15, _e18, _e21);
    return normalize(_e22);
}

fn cubeLocal(face_4: i32, d_12: vec3<f32>) -> vec3<f32> {
    var face_5: i32;
    var d_13: vec3<f32>;

    face_5 = face_4;
    d_13 = d_12;
    let _e11 = face_5;
    if (_e11 == 0i) {
        let _e14 = d_13;
        let _e17 = d_13;
        let _e20 = d_13;
        return vec3<f32>(-(_e14.z), -(_e17.y), _e20.x);
    }
    let _e23 = face_5;
    if (_e23 == 1i) {
        let _e26 = d_13;
        let _e28 = d_13;
        let _e31 = d_13;
        return vec3<f32>(_e26.z, -(_e28.y), -(_e31.x));
    }
    let _e35 = face_5;
    if (_e35 == 2i) {
        let _e38 = d_13;
        let _e40 = d_13;
        let _e42 = d_13;
        return vec3<f32>(_e38.x, _e40.z, _e42.y);
    }
    let _e45 = face_5;
    if (_e45 == 3i) {
        let _e48 = d_13;
        let _e50 = d_13;
        let _e53 = d_13;
        return vec3<f32>(_e48.x, -(_e50.z), -(_e53.y));
    }
    let _e57 = face_5;
    if (_e57 == 4i) {
        let _e60 = d_13;
        let _e62 = d_13;
        let _e65 = d_13;
        return vec3<f32>(_e60.x, -(_e62.y), _e65.z);
    }
    let _e68 = d_13;
    let _e71 = d_13;
    let _e74 = d_13;
    return vec3<f32>(-(_e68.x), -(_e71.y), -(_e74.z));
}

fn cubeTexel(x_11: i32, y_5: i32, size_4: i32) -> CubeTexel {
    var x_12: i32;
    var y_6: i32;
    var size_5: i32;
    var texel: CubeTexel;
    var z2_1: f32;
    var h2_: f32;

    x_12 = x_11;
    y_6 = y_5;
    size_5 = size_4;
    let _e15 = x_12;
    let _e16 = size_5;
    let _e17 = cubeCoordinate(_e15, _e16);
    let _e18 = y_6;
    let _e19 = size_5;
    let _e20 = cubeCoordinate(_e18, _e19);
    texel.local = normalize(vec3<f32>(_e17, _e20, 1f));
    let _e24 = texel;
    let _e27 = texel;
    z2_1 = (_e24.local.z * _e27.local.z);
    let _e33 = size_5;
    let _e34 = size_5;
    h2_ = (4f / f32((_e33 * _e34)));
    let _e40 = h2_;
    let _e41 = texel;
    let _e45 = z2_1;
    let _e48 = h2_;
    let _e53 = z2_1;
    let _e57 = z2_1;
    texel.solidAngle = (((_e40 * _e41.local.z) * _e45) * (1f + (((_e48 / 24f) * (9f - (15f * _e53))) * _e57)));
    let _e61 = texel;
    return _e61;
}

fn cubeTexelSolidAngle(x_13: i32, y_7: i32, size_6: i32) -> f32 {
    var x_14: i32;
    var y_8: i32;
    var size_7: i32;

    x_14 = x_13;
    y_8 = y_7;
    size_7 = size_6;
    let _e13 = x_14;
    let _e14 = y_8;
    let _e15 = size_7;
    let _e16 = cubeTexel(_e13, _e14, _e15);
    return _e16.solidAngle;
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
    var first: i32;
    var last: i32;

    along_4 = along_3;
    outward_2 = outward_1;
    sinRadius_1 = sinRadius;
    size_9 = size_8;
    let _e20 = along_4;
    let _e21 = along_4;
    let _e23 = outward_2;
    let _e24 = outward_2;
    let _e27 = sinRadius_1;
    let _e28 = sinRadius_1;
    beside2_ = (((_e20 * _e21) + (_e23 * _e24)) - (_e27 * _e28));
    let _e32 = beside2_;
    if (_e32 > 0f) {
        {
            let _e35 = beside2_;
            beside = sqrt(_e35);
            let _e38 = outward_2;
            let _e39 = beside;
            let _e41 = along_4;
            let _e42 = sinRadius_1;
            lowOut = ((_e38 * _e39) + (_e41 * _e42));
            let _e46 = outward_2;
            let _e47 = beside;
            let _e49 = along_4;
            let _e50 = sinRadius_1;
            highOut = ((_e46 * _e47) - (_e49 * _e50));
            let _e54 = lowOut;
            if (_e54 > 0f) {
                let _e57 = low_5;
                let _e58 = along_4;
                let _e59 = beside;
                let _e61 = outward_2;
                let _e62 = sinRadius_1;
                let _e65 = lowOut;
                low_5 = max(_e57, (((_e58 * _e59) - (_e61 * _e62)) / _e65));
            } else {
                let _e68 = along_4;
                if (_e68 >= 0f) {
                    low_5 = 2f;
                }
            }
            let _e72 = highOut;
            if (_e72 > 0f) {
                let _e75 = high;
                let _e76 = along_4;
                let _e77 = beside;
                let _e79 = outward_2;
                let _e80 = sinRadius_1;
                let _e83 = highOut;
                high = min(_e75, (((_e76 * _e77) + (_e79 * _e80)) / _e83));
            } else {
                let _e86 = along_4;
                if (_e86 <= 0f) {
                    high = -2f;
                }
            }
        }
    }
    let _e91 = low_5;
    let _e92 = high;
    if (_e91 > _e92) {
        return vec2<i32>(1i, 0i);
    }
    let _e98 = size_9;
    scale_3 = (0.5f * f32(_e98));
    let _e102 = scale_3;
    let _e103 = low_5;
    first = i32(ceil(((_e102 * (_e103 + 1f)) - 0.5f)));
    let _e112 = scale_3;
    let _e113 = high;
    last = i32(floor(((_e112 * (_e113 + 1f)) - 0.5f)));
    let _e122 = first;
    let _e125 = last;
    let _e126 = size_9;
    return vec2<i32>(max(_e122, 0i), min(_e125, (_e126 - 1i)));
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
    let _e24 = l_1;
    let _e27 = cosRadius_1;
    let _e30 = sinRadius_3;
    if (_e24.z < ((0.57735f * _e27) - (0.8165f * _e30))) {
        let _e34 = range;
        return _e34;
    }
    let _e35 = l_1;
    let _e37 = l_1;
    let _e39 = sinRadius_3;
    let _e40 = size_11;
    let _e41 = cubeCapInterval(_e35.x, _e37.z, _e39, _e40);
    rangeX = _e41;
    let _e43 = l_1;
    let _e45 = l_1;
    let _e47 = sinRadius_3;
    let _e48 = size_11;
    let _e49 = cubeCapInterval(_e43.y, _e45.z, _e47, _e48);
    rangeY = _e49;
    let _e52 = rangeX;
    range.firstX = _e52.x;
    let _e55 = rangeX;
    range.lastX = _e55.y;
    let _e58 = rangeY;
    range.firstY = _e58.x;
    let _e61 = rangeY;
    range.lastY = _e61.y;
    let _e63 = range;
    return _e63;
}

fn cubeCapRow(l_2: vec3<f32>, cosRadius_2: f32, t_21: f32, size_12: i32) -> vec2<i32> {
    var l_3: vec3<f32>;
    var cosRadius_3: f32;
    var t_22: f32;
    var size_13: i32;
    var k_11: f32;
    var a_24: f32;
    var inside: f32;
    var middle: f32;
    var spread_2: f32;
    var scale_4: f32;
    var first_1: i32;
    var last_1: i32;

    l_3 = l_2;
    cosRadius_3 = cosRadius_2;
    t_22 = t_21;
    size_13 = size_12;
    let _e15 = l_3;
    let _e17 = t_22;
    let _e19 = l_3;
    k_11 = ((_e15.y * _e17) + _e19.z);
    let _e23 = cosRadius_3;
    let _e24 = cosRadius_3;
    let _e26 = l_3;
    let _e28 = l_3;
    a_24 = ((_e23 * _e24) - (_e26.x * _e28.x));
    let _e33 = k_11;
    let _e34 = k_11;
    let _e36 = a_24;
    let _e38 = t_22;
    let _e39 = t_22;
    inside = (((_e33 * _e34) - (_e36 * (1f + (_e38 * _e39)))) + 0.0000004f);
    let _e47 = a_24;
    if (_e47 <= 0f) {
        let _e51 = size_13;
        return vec2<i32>(0i, (_e51 - 1i));
    }
    let _e55 = inside;
    if (_e55 < 0f) {
        return vec2<i32>(1i, 0i);
    }
    let _e61 = l_3;
    let _e63 = k_11;
    middle = (_e61.x * _e63);
    let _e66 = cosRadius_3;
    let _e67 = inside;
    spread_2 = (_e66 * sqrt(_e67));
    let _e72 = size_13;
    scale_4 = (0.5f * f32(_e72));
    let _e76 = scale_4;
    let _e77 = middle;
    let _e78 = spread_2;
    let _e80 = a_24;
    first_1 = i32(ceil(((_e76 * (((_e77 - _e78) / _e80) + 1f)) - 0.5f)));
    let _e90 = scale_4;
    let _e91 = middle;
    let _e92 = spread_2;
    let _e94 = a_24;
    last_1 = i32(floor(((_e90 * (((_e91 + _e92) / _e94) + 1f)) - 0.5f)));
    let _e104 = first_1;
    let _e107 = last_1;
    let _e108 = size_13;
    return vec2<i32>(max(_e104, 0i), min(_e107, (_e108 - 1i)));
}

fn gaussianStackLevels(stack: vec4<f32>, sigma: f32) -> StackLevels {
    var stack_1: vec4<f32>;
    var sigma_1: f32;
    var variance: f32;
    var first_2: f32;
    var sharp: f32;
    var levels: StackLevels;
    var height: f32;
    var below_2: f32;
    var share: f32;
    var pair: f32;
    var belowIsEven: bool;
    var local_46: f32;
    var local_47: f32;

    stack_1 = stack;
    sigma_1 = sigma;
    let _e11 = sigma_1;
    let _e12 = sigma_1;
    variance = (_e11 * _e12);
    let _e15 = stack_1;
    let _e17 = stack_1;
    first_2 = (_e15.y * _e17.y);
    let _e21 = stack_1;
    let _e23 = stack_1;
    sharp = (_e21.x * _e23.x);
    let _e28 = variance;
    let _e29 = first_2;
    if (_e28 < _e29) {
        {
            let _e32 = variance;
            let _e33 = sharp;
            let _e35 = first_2;
            let _e36 = sharp;
            levels.even = clamp(((_e32 - _e33) / (_e35 - _e36)), 0f, 1f);
            levels.odd = 0f;
            levels.oddShare = 0f;
            let _e46 = levels;
            return _e46;
        }
    }
    let _e47 = variance;
    let _e48 = first_2;
    let _e51 = stack_1;
    height = min(log2((_e47 / _e48)), _e51.z);
    let _e55 = height;
    let _e57 = stack_1;
    below_2 = min(floor(_e55), (_e57.z - 1f));
    let _e63 = height;
    let _e64 = below_2;
    share = (exp2((_e63 - _e64)) - 1f);
    let _e71 = below_2;
    pair = floor(((0.5f * _e71) + 0.25f));
    let _e77 = below_2;
    let _e79 = pair;
    belowIsEven = ((_e77 - (2f * _e79)) < 0.5f);
    let _e86 = belowIsEven;
    if _e86 {
        let _e87 = pair;
        local_46 = (_e87 + 1f);
    } else {
        let _e90 = pair;
        local_46 = (_e90 + 2f);
    }
    let _e94 = local_46;
    levels.even = _e94;
    let _e96 = pair;
    levels.odd = _e96;
    let _e98 = belowIsEven;
    if _e98 {
        let _e99 = share;
        local_47 = _e99;
    } else {
        let _e101 = share;
        local_47 = (1f - _e101);
    }
    let _e104 = local_47;
    levels.oddShare = _e104;
    let _e105 = levels;
    return _e105;
}

fn environmentRotate(d_14: vec3<f32>, cosAngle: f32, sinAngle: f32) -> vec3<f32> {
    var d_15: vec3<f32>;
    var cosAngle_1: f32;
    var sinAngle_1: f32;

    d_15 = d_14;
    cosAngle_1 = cosAngle;
    sinAngle_1 = sinAngle;
    let _e13 = cosAngle_1;
    let _e14 = d_15;
    let _e17 = sinAngle_1;
    let _e18 = d_15;
    let _e22 = d_15;
    let _e24 = sinAngle_1;
    let _e25 = d_15;
    let _e28 = cosAngle_1;
    let _e29 = d_15;
    return vec3<f32>(((_e13 * _e14.x) - (_e17 * _e18.z)), _e22.y, ((_e24 * _e25.x) + (_e28 * _e29.z)));
}

fn heatKernel(chord2_: f32, inverseTwiceVariance: f32) -> f32 {
    var chord2_1: f32;
    var inverseTwiceVariance_1: f32;
    var theta2_: f32;

    chord2_1 = chord2_;
    inverseTwiceVariance_1 = inverseTwiceVariance;
    let _e13 = chord2_1;
    let _e15 = chord2_1;
    let _e19 = chord2_1;
    theta2_ = (_e13 * (1f + (_e15 * (0.083333336f + (_e19 * 0.011111111f)))));
    let _e29 = theta2_;
    let _e33 = inverseTwiceVariance_1;
    return exp((_e29 * (0.083333336f - _e33)));
}

fn blockCoordinate(x_15: f32, size_14: i32, block: i32, blocks: i32) -> f32 {
    var x_16: f32;
    var size_15: i32;
    var block_1: i32;
    var blocks_1: i32;
    var texel_1: f32;

    x_16 = x_15;
    size_15 = size_14;
    block_1 = block;
    blocks_1 = blocks;
    let _e17 = block_1;
    let _e18 = size_15;
    let _e21 = x_16;
    let _e25 = size_15;
    texel_1 = ((f32((_e17 * _e18)) + (clamp(_e21, 0f, 1f) * f32((_e25 - 1i)))) + 0.5f);
    let _e34 = texel_1;
    let _e35 = size_15;
    let _e36 = blocks_1;
    return (_e34 / f32((_e35 * _e36)));
}

fn tableCoordinate(x_17: f32, size_16: i32) -> f32 {
    var x_18: f32;
    var size_17: i32;

    x_18 = x_17;
    size_17 = size_16;
    let _e13 = x_18;
    let _e14 = size_17;
    let _e17 = blockCoordinate(_e13, _e14, 0i, 1i);
    return _e17;
}

fn energyCoordinate(cosTheta_18: f32, alpha_72: f32) -> vec2<f32> {
    var cosTheta_19: f32;
    var alpha_73: f32;

    cosTheta_19 = cosTheta_18;
    alpha_73 = alpha_72;
    let _e16 = cosTheta_19;
    let _e20 = tableCoordinate(sqrt(max(_e16, 0f)), ENERGY_TABLE_SIZE);
    let _e21 = alpha_73;
    let _e25 = tableCoordinate(sqrt(max(_e21, 0f)), ENERGY_TABLE_SIZE);
    return vec2<f32>(_e20, _e25);
}

fn lobeCoordinateOf(tap: i32, taps: i32, cosTheta_20: f32, alpha_74: f32, edge: f32) -> vec3<f32> {
    var tap_1: i32;
    var taps_1: i32;
    var cosTheta_21: f32;
    var alpha_75: f32;
    var edge_1: f32;

    tap_1 = tap;
    taps_1 = taps;
    cosTheta_21 = cosTheta_20;
    alpha_75 = alpha_74;
    edge_1 = edge;
    let _e22 = cosTheta_21;
    let _e26 = tableCoordinate(sqrt(max(_e22, 0f)), LOBE_TABLE_SIZE);
    let _e27 = alpha_75;
    let _e31 = tap_1;
    let _e32 = taps_1;
    let _e33 = blockCoordinate(sqrt(max(_e27, 0f)), LOBE_TABLE_SIZE, _e31, _e32);
    let _e34 = edge_1;
    let _e35 = tableCoordinate(_e34, LOBE_TABLE_SLICES);
    return vec3<f32>(_e26, _e33, _e35);
}

fn lobeCoordinate(cosTheta_22: f32, alpha_76: f32, edge_2: f32) -> vec3<f32> {
    var cosTheta_23: f32;
    var alpha_77: f32;
    var edge_3: f32;

    cosTheta_23 = cosTheta_22;
    alpha_77 = alpha_76;
    edge_3 = edge_2;
    let _e20 = cosTheta_23;
    let _e21 = alpha_77;
    let _e22 = edge_3;
    let _e23 = lobeCoordinateOf(0i, 1i, _e20, _e21, _e22);
    return _e23;
}

fn lobeEnergy(texel_2: vec4<f32>) -> LobeEnergy {
    var texel_3: vec4<f32>;
    var e_1: LobeEnergy;

    texel_3 = texel_2;
    let _e16 = texel_3;
    e_1.albedo = _e16.x;
    let _e19 = texel_3;
    e_1.cos1_ = _e19.y;
    let _e22 = texel_3;
    e_1.cos2_ = _e22.z;
    let _e25 = texel_3;
    e_1.share1_ = _e25.w;
    let _e27 = e_1;
    return _e27;
}

fn lobeMean(e_2: LobeEnergy, fAtCos1_: f32, fAtCos2_: f32) -> f32 {
    var e_3: LobeEnergy;
    var fAtCos1_1: f32;
    var fAtCos2_1: f32;

    e_3 = e_2;
    fAtCos1_1 = fAtCos1_;
    fAtCos2_1 = fAtCos2_;
    let _e18 = fAtCos2_1;
    let _e19 = fAtCos1_1;
    let _e20 = e_3;
    return mix(_e18, _e19, _e20.share1_);
}

fn lobeMeanRgb(e_4: LobeEnergy, fAtCos1_2: vec3<f32>, fAtCos2_2: vec3<f32>) -> vec3<f32> {
    var e_5: LobeEnergy;
    var fAtCos1_3: vec3<f32>;
    var fAtCos2_3: vec3<f32>;

    e_5 = e_4;
    fAtCos1_3 = fAtCos1_2;
    fAtCos2_3 = fAtCos2_2;
    let _e18 = fAtCos2_3;
    let _e19 = fAtCos1_3;
    let _e20 = e_5;
    return mix(_e18, _e19, vec3(_e20.share1_));
}

fn edgeShare(f0_4: f32, mean: f32) -> f32 {
    var f0_5: f32;
    var mean_1: f32;
    var local_48: f32;

    f0_5 = f0_4;
    mean_1 = mean;
    let _e16 = mean_1;
    if (_e16 > 0f) {
        let _e20 = f0_5;
        let _e21 = mean_1;
        local_48 = clamp((1f - (_e20 / _e21)), 0f, 1f);
    } else {
        local_48 = 0f;
    }
    let _e29 = local_48;
    return _e29;
}

fn lobeDirection(r_14: vec3<f32>, n_28: vec3<f32>, lean: f32) -> vec3<f32> {
    var r_15: vec3<f32>;
    var n_29: vec3<f32>;
    var lean_1: f32;

    r_15 = r_14;
    n_29 = n_28;
    lean_1 = lean;
    let _e18 = r_15;
    let _e19 = n_29;
    let _e20 = lean_1;
    return normalize(mix(_e18, _e19, vec3(_e20)));
}

fn diffuseAngles(cosTheta_24: f32) -> vec3<f32> {
    var cosTheta_25: f32;
    var c_23: f32;

    cosTheta_25 = cosTheta_24;
    let _e14 = cosTheta_25;
    c_23 = clamp(_e14, 0f, 1f);
    let _e20 = c_23;
    let _e25 = c_23;
    let _e31 = c_23;
    return vec3<f32>(((0.2791f * _e20) + 0.266f), ((0.1798f * _e25) + 0.6974f), (0.1224f * (1f - _e31)));
}

fn wideningGgx(taps_2: i32) -> Widening {
    var taps_3: i32;
    var k_12: Widening;
    var local_49: f32;
    var local_50: f32;
    var local_51: f32;

    taps_3 = taps_2;
    let _e16 = taps_3;
    if (_e16 > 1i) {
        local_49 = 0.7f;
    } else {
        local_49 = 0.6f;
    }
    let _e22 = local_49;
    k_12.shape = _e22;
    let _e24 = taps_3;
    if (_e24 > 1i) {
        local_50 = 0.91f;
    } else {
        local_50 = 0.6f;
    }
    let _e30 = local_50;
    k_12.shapeRays = _e30;
    let _e32 = taps_3;
    if (_e32 > 1i) {
        local_51 = 1.05f;
    } else {
        local_51 = 0.95f;
    }
    let _e38 = local_51;
    k_12.energyCore = _e38;
    k_12.energyTail = 0.85f;
    let _e41 = k_12;
    return _e41;
}

fn wideningBeckmann(taps_4: i32) -> Widening {
    var taps_5: i32;
    var k_13: Widening;
    var local_52: f32;
    var local_53: f32;
    var local_54: f32;

    taps_5 = taps_4;
    let _e16 = taps_5;
    if (_e16 > 1i) {
        local_52 = 1f;
    } else {
        local_52 = 1.2f;
    }
    let _e22 = local_52;
    k_13.shape = _e22;
    let _e24 = taps_5;
    if (_e24 > 1i) {
        local_53 = 1.3f;
    } else {
        local_53 = 1.2f;
    }
    let _e30 = local_53;
    k_13.shapeRays = _e30;
    let _e32 = taps_5;
    if (_e32 > 1i) {
        local_54 = 1.3f;
    } else {
        local_54 = 1.5f;
    }
    let _e38 = local_54;
    k_13.energyCore = _e38;
    k_13.energyTail = 1.6f;
    let _e41 = k_13;
    return _e41;
}

fn exitTurn(cosTheta_26: f32, pathLength: f32, curvature: vec2<f32>) -> vec2<f32> {
    var cosTheta_27: f32;
    var pathLength_1: f32;
    var curvature_1: vec2<f32>;
    var turn: vec2<f32>;

    cosTheta_27 = cosTheta_26;
    pathLength_1 = pathLength;
    curvature_1 = curvature;
    let _e18 = pathLength_1;
    let _e19 = curvature_1;
    let _e22 = cosTheta_27;
    let _e26 = pathLength_1;
    let _e27 = curvature_1;
    turn = vec2<f32>(((_e18 * _e19.x) / max(_e22, 0.000001f)), (_e26 * _e27.y));
    let _e32 = turn;
    return clamp(_e32, vec2(-8f), vec2(8f));
}

fn sphereTurn(cosTheta_28: f32) -> vec2<f32> {
    var cosTheta_29: f32;

    cosTheta_29 = cosTheta_28;
    let _e16 = cosTheta_29;
    return vec2<f32>(2f, (2f * _e16));
}

fn seeExit(inner: InnerTap, core: bool, s_5: ExitSurface, k_14: Widening) -> ExitView {
    var inner_1: InnerTap;
    var core_1: bool;
    var s_6: ExitSurface;
    var k_15: Widening;
    var v_24: ExitView;
    var local_55: f32;
    var alpha2_: f32;
    var spread_3: f32;
    var spread2_: f32;
    var rays2_: f32;
    var local_56: f32;
    var rays: f32;
    var shape_1: f32;
    var shape2_: f32;
    var local_57: f32;
    var energy: f32;
    var local_58: f32;

    inner_1 = inner;
    core_1 = core;
    s_6 = s_5;
    k_15 = k_14;
    let _e23 = inner_1;
    let _e25 = s_6;
    v_24.cosTheta = min(dot(_e23.direction, _e25.n), 1f);
    let _e32 = s_6;
    v_24.swing = (1f - _e32.turn.x);
    let _e37 = v_24;
    if (_e37.swing < 0f) {
        let _e41 = v_24;
        local_55 = min(_e41.swing, -0.05f);
    } else {
        let _e46 = v_24;
        local_55 = max(_e46.swing, LEAST_SWING);
    }
    let _e50 = local_55;
    v_24.swing = _e50;
    let _e51 = s_6;
    let _e53 = s_6;
    alpha2_ = (_e51.alpha * _e53.alpha);
    let _e57 = inner_1;
    let _e59 = v_24;
    spread_3 = (_e57.sigma * _e59.swing);
    let _e63 = spread_3;
    let _e64 = spread_3;
    spread2_ = (_e63 * _e64);
    let _e67 = k_15;
    let _e69 = k_15;
    let _e72 = spread2_;
    rays2_ = ((_e67.shape * _e69.shape) * _e72);
    let _e75 = rays2_;
    if (_e75 > 0f) {
        let _e78 = rays2_;
        let _e79 = alpha2_;
        let _e80 = rays2_;
        local_56 = (_e78 / (_e79 + _e80));
    } else {
        local_56 = 0f;
    }
    let _e85 = local_56;
    rays = _e85;
    let _e87 = k_15;
    let _e89 = k_15;
    let _e91 = rays;
    shape_1 = mix(_e87.shape, _e89.shapeRays, _e91);
    let _e94 = alpha2_;
    let _e95 = shape_1;
    let _e96 = shape_1;
    let _e98 = spread2_;
    shape2_ = (_e94 + ((_e95 * _e96) * _e98));
    let _e102 = core_1;
    if _e102 {
        let _e103 = k_15;
        local_57 = _e103.energyCore;
    } else {
        let _e105 = k_15;
        local_57 = _e105.energyTail;
    }
    let _e108 = local_57;
    energy = _e108;
    let _e111 = shape2_;
    v_24.alphaShape = min(sqrt(_e111), 1f);
    let _e116 = alpha2_;
    let _e117 = energy;
    let _e118 = energy;
    let _e120 = spread2_;
    v_24.alphaEnergy = min(sqrt((_e116 + ((_e117 * _e118) * _e120))), 1f);
    let _e127 = shape2_;
    if (_e127 > 0f) {
        let _e130 = alpha2_;
        let _e131 = shape2_;
        local_58 = (_e130 / _e131);
    } else {
        local_58 = 1f;
    }
    let _e135 = local_58;
    v_24.own = _e135;
    let _e136 = v_24;
    return _e136;
}

fn leavingNextAlpha(innerSigma: f32, alpha_78: f32, nextAlpha: f32) -> f32 {
    var innerSigma_1: f32;
    var alpha_79: f32;
    var nextAlpha_1: f32;
    var spread_4: f32;

    innerSigma_1 = innerSigma;
    alpha_79 = alpha_78;
    nextAlpha_1 = nextAlpha;
    let _e21 = innerSigma_1;
    spread_4 = (1.3f * _e21);
    let _e24 = nextAlpha_1;
    let _e25 = nextAlpha_1;
    let _e28 = alpha_79;
    let _e30 = alpha_79;
    let _e33 = spread_4;
    let _e34 = spread_4;
    return min(sqrt((((_e24 * _e25) + ((3f * _e28) * _e30)) + (_e33 * _e34))), 1f);
}

fn convexExit(n_30: vec3<f32>, direction: vec3<f32>, body: ConvexBody) -> ConvexExit {
    var n_31: vec3<f32>;
    var direction_1: vec3<f32>;
    var body_1: ConvexBody;
    var q: f32;
    var c_24: f32;
    var a_25: f32;
    var root_1: f32;
    var local_59: f32;
    var scaled: f32;
    var e_6: ConvexExit;
    var local_60: f32;
    var curvature_2: f32;

    n_31 = n_30;
    direction_1 = direction;
    body_1 = body;
    let _e20 = body_1;
    let _e22 = body_1;
    q = clamp((_e20.thickness * _e22.curvature), 0f, 2f);
    let _e29 = n_31;
    let _e30 = direction_1;
    c_24 = max(-(dot(_e29, _e30)), 0.05f);
    let _e37 = q;
    let _e39 = c_24;
    a_25 = ((1f - _e37) * _e39);
    let _e42 = a_25;
    let _e43 = a_25;
    let _e45 = q;
    let _e47 = q;
    root_1 = sqrt(((_e42 * _e43) + (_e45 * (2f - _e47))));
    let _e53 = q;
    if (_e53 < 1f) {
        let _e57 = q;
        let _e59 = a_25;
        let _e60 = root_1;
        local_59 = ((2f - _e57) / (_e59 + _e60));
    } else {
        let _e63 = root_1;
        let _e64 = a_25;
        let _e66 = q;
        local_59 = ((_e63 - _e64) / _e66);
    }
    let _e69 = local_59;
    scaled = _e69;
    let _e73 = scaled;
    let _e74 = body_1;
    e_6.path = (_e73 * _e74.thickness);
    let _e79 = q;
    let _e82 = n_31;
    let _e84 = q;
    let _e85 = scaled;
    let _e87 = direction_1;
    e_6.surface.n = normalize((((_e79 - 1f) * _e82) + ((_e84 * _e85) * _e87)));
    let _e93 = body_1;
    e_6.surface.alpha = _e93.backAlpha;
    let _e98 = body_1;
    e_6.surface.eta = (1f / _e98.ior);
    let _e101 = body_1;
    if (_e101.thickness > 0f) {
        let _e105 = q;
        let _e106 = body_1;
        local_60 = (_e105 / _e106.thickness);
    } else {
        local_60 = 0f;
    }
    let _e111 = local_60;
    curvature_2 = _e111;
    let _e115 = direction_1;
    let _e116 = e_6;
    let _e120 = e_6;
    let _e122 = curvature_2;
    let _e124 = exitTurn(dot(_e115, _e116.surface.n), _e120.path, vec2(_e122));
    e_6.surface.turn = _e124;
    let _e125 = e_6;
    return _e125;
}

fn signNotZero(x_19: f32) -> f32 {
    var x_20: f32;
    var local_61: f32;

    x_20 = x_19;
    let _e16 = x_20;
    if (_e16 < 0f) {
        local_61 = -1f;
    } else {
        local_61 = 1f;
    }
    let _e23 = local_61;
    return _e23;
}

fn octEncode(n_32: vec3<f32>) -> vec2<f32> {
    var n_33: vec3<f32>;
    var s_7: f32;
    var p_3: vec2<f32>;

    n_33 = n_32;
    let _e17 = n_33;
    let _e20 = n_33;
    let _e24 = n_33;
    s_7 = (1f / ((abs(_e17.x) + abs(_e20.y)) + abs(_e24.z)));
    let _e30 = n_33;
    let _e32 = s_7;
    let _e34 = n_33;
    let _e36 = s_7;
    p_3 = vec2<f32>((_e30.x * _e32), (_e34.y * _e36));
    let _e40 = n_33;
    if (_e40.z >= 0f) {
        let _e44 = p_3;
        return _e44;
    }
    let _e46 = p_3;
    let _e50 = p_3;
    let _e52 = signNotZero(_e50.x);
    let _e55 = p_3;
    let _e59 = p_3;
    let _e61 = signNotZero(_e59.y);
    return vec2<f32>(((1f - abs(_e46.y)) * _e52), ((1f - abs(_e55.x)) * _e61));
}

fn octDecode(p_4: vec2<f32>) -> vec3<f32> {
    var p_5: vec2<f32>;
    var z_8: f32;
    var fold: f32;

    p_5 = p_4;
    let _e17 = p_5;
    let _e21 = p_5;
    z_8 = ((1f - abs(_e17.x)) - abs(_e21.y));
    let _e26 = z_8;
    fold = max(-(_e26), 0f);
    let _e31 = p_5;
    let _e33 = fold;
    let _e34 = p_5;
    let _e36 = signNotZero(_e34.x);
    let _e39 = p_5;
    let _e41 = fold;
    let _e42 = p_5;
    let _e44 = signNotZero(_e42.y);
    let _e47 = z_8;
    return normalize(vec3<f32>((_e31.x - (_e33 * _e36)), (_e39.y - (_e41 * _e44)), _e47));
}

fn interiorView(clipFromWorld: mat4x4<f32>, worldFromClip: mat4x4<f32>, size_18: vec2<f32>) -> InteriorView {
    var clipFromWorld_1: mat4x4<f32>;
    var worldFromClip_1: mat4x4<f32>;
    var size_19: vec2<f32>;
    var view: InteriorView;
    var right: vec3<f32>;
    var depth: vec3<f32>;
    var w_22: vec3<f32>;
    var perspective: bool;
    var local_62: vec3<f32>;
    var v_25: vec3<f32>;

    clipFromWorld_1 = clipFromWorld;
    worldFromClip_1 = worldFromClip;
    size_19 = size_18;
    let _e22 = clipFromWorld_1;
    view.clipFromWorld = _e22;
    let _e24 = worldFromClip_1;
    view.worldFromClip = _e24;
    let _e26 = size_19;
    view.size = _e26;
    let _e31 = clipFromWorld_1[0][0];
    let _e36 = clipFromWorld_1[1][0];
    let _e41 = clipFromWorld_1[2][0];
    right = vec3<f32>(_e31, _e36, _e41);
    let _e48 = clipFromWorld_1[0][2];
    let _e53 = clipFromWorld_1[1][2];
    let _e58 = clipFromWorld_1[2][2];
    depth = vec3<f32>(_e48, _e53, _e58);
    let _e65 = clipFromWorld_1[0][3];
    let _e70 = clipFromWorld_1[1][3];
    let _e75 = clipFromWorld_1[2][3];
    w_22 = vec3<f32>(_e65, _e70, _e75);
    let _e80 = size_19;
    let _e82 = right;
    view.texelWidth = (2f / (_e80.x * length(_e82)));
    let _e86 = w_22;
    let _e87 = w_22;
    perspective = (dot(_e86, _e87) > 0f);
    let _e92 = perspective;
    if _e92 {
        let _e93 = w_22;
        local_62 = normalize(_e93);
    } else {
        let _e95 = depth;
        local_62 = -(normalize(_e95));
    }
    let _e99 = local_62;
    v_25 = _e99;
    let _e102 = view;
    let _e104 = depth;
    let _e105 = v_25;
    let _e108 = w_22;
    let _e109 = v_25;
    view.texelDepth = (_e102.texelWidth * vec2<f32>(-(dot(_e104, _e105)), dot(_e108, _e109)));
    let _e113 = view;
    return _e113;
}

fn interiorTexelDepth(view_1: InteriorView, depth_1: f32) -> f32 {
    var view_2: InteriorView;
    var depth_2: f32;

    view_2 = view_1;
    depth_2 = depth_1;
    let _e18 = view_2;
    let _e21 = view_2;
    let _e24 = depth_2;
    return (_e18.texelDepth.x + (_e21.texelDepth.y * _e24));
}

fn interiorTexelWidth(view_3: InteriorView, w_23: f32) -> f32 {
    var view_4: InteriorView;
    var w_24: f32;

    view_4 = view_3;
    w_24 = w_23;
    let _e18 = view_4;
    let _e20 = w_24;
    return (_e18.texelWidth * _e20);
}

fn interiorWorld(view_5: InteriorView, at: vec2<f32>, depth_3: f32) -> vec3<f32> {
    var view_6: InteriorView;
    var at_1: vec2<f32>;
    var depth_4: f32;
    var clip: vec2<f32>;
    var p_6: vec4<f32>;

    view_6 = view_5;
    at_1 = at;
    depth_4 = depth_3;
    let _e21 = at_1;
    let _e24 = view_6;
    let _e32 = at_1;
    let _e35 = view_6;
    clip = vec2<f32>((((2f * _e21.x) / _e24.size.x) - 1f), (1f - ((2f * _e32.y) / _e35.size.y)));
    let _e42 = view_6;
    let _e44 = clip;
    let _e46 = clip;
    let _e48 = depth_4;
    p_6 = (_e42.worldFromClip * vec4<f32>(_e44.x, _e46.y, _e48, 1f));
    let _e53 = p_6;
    let _e55 = p_6;
    let _e57 = p_6;
    let _e60 = p_6;
    return (vec3<f32>(_e53.x, _e55.y, _e57.z) / vec3(_e60.w));
}

fn exitRay(view_7: InteriorView, origin: vec3<f32>, direction_2: vec3<f32>) -> ExitRay {
    var view_8: InteriorView;
    var origin_1: vec3<f32>;
    var direction_3: vec3<f32>;
    var o_2: vec4<f32>;
    var d_16: vec4<f32>;
    var h_14: vec2<f32>;
    var ray: ExitRay;

    view_8 = view_7;
    origin_1 = origin;
    direction_3 = direction_2;
    let _e23 = view_8;
    let _e25 = origin_1;
    o_2 = (_e23.clipFromWorld * vec4<f32>(_e25.x, _e25.y, _e25.z, 1f));
    let _e33 = view_8;
    let _e35 = direction_3;
    d_16 = (_e33.clipFromWorld * vec4<f32>(_e35.x, _e35.y, _e35.z, 0f));
    let _e44 = view_8;
    h_14 = (0.5f * _e44.size);
    let _e50 = h_14;
    let _e52 = o_2;
    let _e54 = o_2;
    let _e58 = h_14;
    let _e60 = o_2;
    let _e62 = o_2;
    let _e66 = o_2;
    let _e68 = o_2;
    ray.origin = vec4<f32>((_e50.x * (_e52.w + _e54.x)), (_e58.y * (_e60.w - _e62.y)), _e66.z, _e68.w);
    let _e72 = h_14;
    let _e74 = d_16;
    let _e76 = d_16;
    let _e80 = h_14;
    let _e82 = d_16;
    let _e84 = d_16;
    let _e88 = d_16;
    let _e90 = d_16;
    ray.direction = vec4<f32>((_e72.x * (_e74.w + _e76.x)), (_e80.y * (_e82.w - _e84.y)), _e88.z, _e90.w);
    let _e93 = ray;
    return _e93;
}

fn exitAt(ray_1: ExitRay, t_23: f32) -> vec4<f32> {
    var ray_2: ExitRay;
    var t_24: f32;
    var p_7: vec4<f32>;
    var s_8: f32;

    ray_2 = ray_1;
    t_24 = t_23;
    let _e21 = ray_2;
    let _e23 = t_24;
    let _e24 = ray_2;
    p_7 = (_e21.origin + (_e23 * _e24.direction));
    let _e30 = p_7;
    s_8 = (1f / _e30.w);
    let _e34 = p_7;
    let _e36 = s_8;
    let _e38 = p_7;
    let _e40 = s_8;
    let _e42 = p_7;
    let _e44 = s_8;
    let _e46 = p_7;
    return vec4<f32>((_e34.x * _e36), (_e38.y * _e40), (_e42.z * _e44), _e46.w);
}

fn exitOnPicture(view_9: InteriorView, at_2: vec4<f32>) -> bool {
    var view_10: InteriorView;
    var at_3: vec4<f32>;

    view_10 = view_9;
    at_3 = at_2;
    let _e21 = at_3;
    let _e25 = at_3;
    let _e30 = at_3;
    let _e35 = at_3;
    let _e37 = view_10;
    let _e42 = at_3;
    let _e44 = view_10;
    return (((((_e21.w > 0f) && (_e25.x >= 0f)) && (_e30.y >= 0f)) && (_e35.x < _e37.size.x)) && (_e42.y < _e44.size.y));
}

fn exitStretches(depths: vec4<f32>) -> vec4<f32> {
    var depths_1: vec4<f32>;

    depths_1 = depths;
    let _e19 = depths_1;
    let _e21 = depths_1;
    if (_e19.x < _e21.y) {
        let _e25 = depths_1;
        let _e27 = depths_1;
        let _e29 = depths_1;
        return vec4<f32>(2f, _e25.y, _e27.x, _e29.w);
    }
    let _e32 = depths_1;
    let _e34 = depths_1;
    let _e37 = depths_1;
    if ((_e32.z > _e34.y) && (_e37.w > 0f)) {
        let _e42 = depths_1;
        let _e44 = depths_1;
        return vec4<f32>(_e42.x, _e44.w, 0f, 0f);
    }
    let _e49 = depths_1;
    return _e49;
}

fn exitInside(stretches: vec4<f32>, depth_5: f32) -> vec2<f32> {
    var stretches_1: vec4<f32>;
    var depth_6: f32;
    var inside_1: vec2<f32> = vec2(-2f);

    stretches_1 = stretches;
    depth_6 = depth_5;
    let _e24 = stretches_1;
    if (_e24.y > 0f) {
        let _e29 = stretches_1;
        let _e31 = depth_6;
        let _e33 = depth_6;
        let _e34 = stretches_1;
        inside_1.x = min((_e29.x - _e31), (_e33 - _e34.y));
    }
    let _e38 = stretches_1;
    if (_e38.w > 0f) {
        let _e43 = stretches_1;
        let _e45 = depth_6;
        let _e47 = depth_6;
        let _e48 = stretches_1;
        inside_1.y = min((_e43.z - _e45), (_e47 - _e48.w));
    }
    let _e52 = inside_1;
    return _e52;
}

fn exitLearn(way: ExitWay, t_25: f32, w_25: f32, here: f32, margin: f32) -> ExitWay {
    var way_1: ExitWay;
    var t_26: f32;
    var w_26: f32;
    var here_1: f32;
    var margin_1: f32;
    var local_63: f32;

    way_1 = way;
    t_26 = t_25;
    w_26 = w_25;
    here_1 = here;
    margin_1 = margin;
    let _e27 = here_1;
    let _e28 = margin_1;
    if (_e27 > _e28) {
        {
            let _e31 = t_26;
            way_1.tInside = _e31;
            let _e33 = here_1;
            let _e34 = w_26;
            way_1.inside = (_e33 * _e34);
        }
    } else {
        let _e36 = here_1;
        let _e37 = margin_1;
        if (_e36 < -(_e37)) {
            {
                let _e41 = t_26;
                way_1.tOutside = _e41;
                let _e43 = here_1;
                if (_e43 > EXIT_NOWHERE) {
                    let _e45 = here_1;
                    let _e46 = w_26;
                    local_63 = (_e45 * _e46);
                } else {
                    local_63 = EXIT_NOWHERE;
                }
                let _e49 = local_63;
                way_1.outside = _e49;
            }
        }
    }
    let _e50 = way_1;
    return _e50;
}

fn exitSecant(way_2: ExitWay) -> f32 {
    var way_3: ExitWay;
    var local_64: f32;
    var share_1: f32;

    way_3 = way_2;
    let _e19 = way_3;
    if (_e19.outside > EXIT_NOWHERE) {
        let _e22 = way_3;
        let _e24 = way_3;
        let _e26 = way_3;
        local_64 = clamp((_e22.inside / (_e24.inside - _e26.outside)), 0.05f, 0.95f);
    } else {
        local_64 = 0.5f;
    }
    let _e35 = local_64;
    share_1 = _e35;
    let _e37 = way_3;
    let _e39 = way_3;
    let _e41 = share_1;
    return mix(_e37.tInside, _e39.tOutside, _e41);
}

fn exitSpacing(k_16: i32) -> f32 {
    var k_17: i32;
    var x_21: f32;
    var x3_: f32;

    k_17 = k_16;
    let _e20 = k_17;
    x_21 = (0.25f * f32(_e20));
    let _e24 = x_21;
    let _e25 = x_21;
    let _e27 = x_21;
    x3_ = ((_e24 * _e25) * _e27);
    let _e30 = x_21;
    let _e31 = x3_;
    let _e35 = x3_;
    let _e36 = x3_;
    return ((_e30 + (_e31 / 3f)) + ((_e35 * _e36) / 20f));
}

fn exitPlane(origin_2: vec3<f32>, direction_4: vec3<f32>, point: vec3<f32>, n_34: vec3<f32>) -> f32 {
    var origin_3: vec3<f32>;
    var direction_5: vec3<f32>;
    var point_1: vec3<f32>;
    var n_35: vec3<f32>;

    origin_3 = origin_2;
    direction_5 = direction_4;
    point_1 = point;
    n_35 = n_34;
    let _e25 = point_1;
    let _e26 = origin_3;
    let _e28 = n_35;
    let _e30 = direction_5;
    let _e31 = n_35;
    return (dot((_e25 - _e26), _e28) / dot(_e30, _e31));
}

fn exitSame(point_2: vec3<f32>, n_36: vec3<f32>, otherPoint: vec3<f32>, otherN: vec3<f32>) -> bool {
    var point_3: vec3<f32>;
    var n_37: vec3<f32>;
    var otherPoint_1: vec3<f32>;
    var otherN_1: vec3<f32>;
    var chord: vec3<f32>;

    point_3 = point_2;
    n_37 = n_36;
    otherPoint_1 = otherPoint;
    otherN_1 = otherN;
    let _e25 = otherPoint_1;
    let _e26 = point_3;
    chord = (_e25 - _e26);
    let _e29 = n_37;
    let _e30 = otherN_1;
    let _e34 = chord;
    let _e35 = n_37;
    let _e39 = chord;
    return ((dot(_e29, _e30) > 0.7f) && (abs(dot(_e34, _e35)) <= (0.39f * length(_e39))));
}

fn exitCurvature(n_38: vec3<f32>, direction_6: vec3<f32>, stepX: vec3<f32>, turnX: vec3<f32>, stepY: vec3<f32>, turnY: vec3<f32>) -> vec2<f32> {
    var n_39: vec3<f32>;
    var direction_7: vec3<f32>;
    var stepX_1: vec3<f32>;
    var turnX_1: vec3<f32>;
    var stepY_1: vec3<f32>;
    var turnY_1: vec3<f32>;
    var area_1: f32;
    var turn_1: f32;
    var along_5: vec3<f32>;
    var t1_2: vec3<f32>;
    var t2_: vec3<f32>;
    var turn1_: vec3<f32>;
    var turn2_: vec3<f32>;
    var twist: f32;
    var curvature_3: vec2<f32>;
    var local_65: vec2<f32>;

    n_39 = n_38;
    direction_7 = direction_6;
    stepX_1 = stepX;
    turnX_1 = turnX;
    stepY_1 = stepY;
    turnY_1 = turnY;
    let _e29 = stepX_1;
    let _e30 = stepY_1;
    let _e32 = n_39;
    area_1 = dot(cross(_e29, _e30), _e32);
    let _e35 = turnX_1;
    let _e36 = turnX_1;
    let _e38 = turnY_1;
    let _e39 = turnY_1;
    turn_1 = max(dot(_e35, _e36), dot(_e38, _e39));
    let _e43 = area_1;
    let _e46 = turn_1;
    if ((_e43 == 0f) || (_e46 > 0.0625f)) {
        return vec2(0f);
    }
    let _e52 = direction_7;
    let _e53 = direction_7;
    let _e54 = n_39;
    let _e56 = n_39;
    along_5 = (_e52 - (dot(_e53, _e54) * _e56));
    let _e60 = along_5;
    let _e61 = along_5;
    if (dot(_e60, _e61) < 0.000000000001f) {
        let _e65 = stepX_1;
        let _e66 = stepX_1;
        let _e67 = n_39;
        let _e69 = n_39;
        along_5 = (_e65 - (dot(_e66, _e67) * _e69));
    }
    let _e72 = along_5;
    t1_2 = normalize(_e72);
    let _e75 = n_39;
    let _e76 = t1_2;
    t2_ = cross(_e75, _e76);
    let _e79 = stepY_1;
    let _e80 = t2_;
    let _e82 = turnX_1;
    let _e84 = stepX_1;
    let _e85 = t2_;
    let _e87 = turnY_1;
    let _e90 = area_1;
    turn1_ = (((dot(_e79, _e80) * _e82) - (dot(_e84, _e85) * _e87)) / vec3(_e90));
    let _e94 = stepX_1;
    let _e95 = t1_2;
    let _e97 = turnY_1;
    let _e99 = stepY_1;
    let _e100 = t1_2;
    let _e102 = turnX_1;
    let _e105 = area_1;
    turn2_ = (((dot(_e94, _e95) * _e97) - (dot(_e99, _e100) * _e102)) / vec3(_e105));
    let _e109 = turn1_;
    let _e110 = t2_;
    let _e112 = turn2_;
    let _e113 = t1_2;
    twist = abs((dot(_e109, _e110) - dot(_e112, _e113)));
    let _e118 = turn1_;
    let _e119 = t1_2;
    let _e121 = turn2_;
    let _e122 = t2_;
    curvature_3 = vec2<f32>(dot(_e118, _e119), dot(_e121, _e122));
    let _e126 = twist;
    let _e127 = curvature_3;
    let _e130 = curvature_3;
    if (_e126 > (abs(_e127.x) + abs(_e130.y))) {
        local_65 = vec2(0f);
    } else {
        let _e137 = curvature_3;
        local_65 = _e137;
    }
    let _e139 = local_65;
    return _e139;
}

fn engineInterfaceEnergy(at_4: vec3<f32>) -> vec4<f32> {
    var at_5: vec3<f32>;

    at_5 = at_4;
    return vec4(0f);
}

fn engineInterfaceLobe(at_6: vec3<f32>) -> vec4<f32> {
    var at_7: vec3<f32>;

    at_7 = at_6;
    return vec4(0f);
}

fn engineReflectionLobe(at_8: vec3<f32>) -> vec4<f32> {
    var at_9: vec3<f32>;

    at_9 = at_8;
    return vec4(0f);
}

fn engineSceneColor(at_10: vec2<f32>, variance_1: f32) -> vec4<f32> {
    var at_11: vec2<f32>;
    var variance_2: f32;

    at_11 = at_10;
    variance_2 = variance_1;
    return vec4(0f);
}

fn engineSceneDepth(at_12: vec2<f32>) -> f32 {
    var at_13: vec2<f32>;

    at_13 = at_12;
    return 0f;
}

fn engineEnvironment(direction_8: vec3<f32>, sigma_2: f32) -> vec3<f32> {
    var direction_9: vec3<f32>;
    var sigma_3: f32;

    direction_9 = direction_8;
    sigma_3 = sigma_2;
    return vec3(0f);
}

fn scenePixel(clip_1: vec4<f32>, size_20: vec2<f32>) -> vec2<f32> {
    var clip_2: vec4<f32>;
    var size_21: vec2<f32>;

    clip_2 = clip_1;
    size_21 = size_20;
    let _e26 = clip_2;
    let _e29 = clip_2;
    let _e33 = size_21;
    let _e38 = clip_2;
    let _e41 = clip_2;
    let _e45 = size_21;
    return vec2<f32>(((0.5f + ((0.5f * _e26.x) / _e29.w)) * _e33.x), ((0.5f - ((0.5f * _e38.y) / _e41.w)) * _e45.y));
}

fn sceneGuess(origin_4: vec4<f32>, along_6: vec4<f32>, view_11: SceneView) -> SceneMeeting {
    var origin_5: vec4<f32>;
    var along_7: vec4<f32>;
    var view_12: SceneView;
    var met: SceneMeeting;
    var at_14: vec2<f32>;
    var k_18: i32 = 0i;
    var depth_7: f32;
    var sky: bool;
    var local_66: f32;
    var local_67: vec4<f32>;
    var there: vec4<f32>;
    var next: vec2<f32>;

    origin_5 = origin_4;
    along_7 = along_6;
    view_12 = view_11;
    met.seen = false;
    met.metres = -1f;
    let _e32 = origin_5;
    let _e33 = view_12;
    let _e35 = scenePixel(_e32, _e33.size);
    at_14 = _e35;
    loop {
        let _e39 = k_18;
        let _e41 = met;
        if !(((_e39 < SCENE_GUESSES) && !(_e41.seen))) {
            break;
        }
        {
            let _e49 = at_14;
            let _e50 = engineSceneDepth(_e49);
            depth_7 = _e50;
            let _e52 = depth_7;
            sky = (_e52 > 100000000000000000000000000000f);
            let _e57 = sky;
            if _e57 {
                local_66 = -1f;
            } else {
                let _e60 = depth_7;
                let _e61 = origin_5;
                let _e64 = along_7;
                local_66 = ((_e60 - _e61.w) / _e64.w);
            }
            let _e68 = local_66;
            met.metres = _e68;
            let _e69 = along_7;
            let _e74 = sky;
            let _e76 = met;
            if (!((_e69.w > 0f)) || (!(_e74) && (_e76.metres < 0f))) {
                break;
            }
            let _e82 = sky;
            if _e82 {
                let _e83 = along_7;
                local_67 = _e83;
            } else {
                let _e84 = origin_5;
                let _e85 = met;
                let _e87 = along_7;
                local_67 = (_e84 + (_e85.metres * _e87));
            }
            let _e91 = local_67;
            there = _e91;
            let _e93 = there;
            let _e94 = view_12;
            let _e96 = scenePixel(_e93, _e94.size);
            next = _e96;
            let _e99 = k_18;
            let _e102 = next;
            let _e104 = at_14;
            let _e111 = next;
            let _e113 = at_14;
            met.seen = (((_e99 > 0i) && (abs((_e102.x - _e104.x)) < 1f)) && (abs((_e111.y - _e113.y)) < 1f));
            let _e120 = next;
            at_14 = _e120;
        }
        continuing {
            let _e46 = k_18;
            k_18 = (_e46 + 1i);
        }
    }
    let _e121 = met;
    return _e121;
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
    let _e24 = origin_7;
    let _e26 = origin_7;
    let _e29 = origin_7;
    let _e31 = origin_7;
    let _e34 = origin_7;
    let _e36 = origin_7;
    let _e39 = origin_7;
    let _e41 = origin_7;
    room_1 = max(vec4<f32>((_e24.w - _e26.x), (_e29.w + _e31.x), (_e34.w - _e36.y), (_e39.w + _e41.y)), vec4(0f));
    let _e49 = way_5;
    let _e51 = way_5;
    let _e54 = way_5;
    let _e57 = way_5;
    let _e60 = way_5;
    let _e62 = way_5;
    let _e65 = way_5;
    let _e68 = way_5;
    loss = vec4<f32>((_e49.x - _e51.w), (-(_e54.x) - _e57.w), (_e60.y - _e62.w), (-(_e65.y) - _e68.w));
    let _e73 = room_1;
    let _e74 = loss;
    let _e75 = room_1;
    cut = min((_e73 / max(max(_e74, _e75), vec4(0.000000000000000000000000000001f))), vec4(1f));
    let _e85 = cut;
    let _e87 = cut;
    let _e90 = cut;
    let _e92 = cut;
    end = min(min(_e85.x, _e87.y), min(_e90.z, _e92.w));
    let _e97 = end;
    let _e99 = origin_7;
    let _e102 = way_5;
    let _e106 = origin_7;
    return min(_e97, ((0.99f * _e99.w) / max(-(_e102.w), (0.99f * _e106.w))));
}

fn sceneMarch(origin_8: vec4<f32>, along_8: vec4<f32>, view_13: SceneView) -> SceneMeeting {
    var origin_9: vec4<f32>;
    var along_9: vec4<f32>;
    var view_14: SceneView;
    var way_6: vec4<f32>;
    var end_1: f32;
    var to: vec4<f32>;
    var a_26: vec3<f32>;
    var b_17: vec3<f32>;
    var met_1: SceneMeeting;
    var low_6: f32 = 0f;
    var heightLow: f32 = 0f;
    var high_1: f32 = 1f;
    var heightHigh: f32 = 0f;
    var crossed: bool = false;
    var depth_8: f32 = 0f;
    var k_19: i32 = 1i;
    var p_8: vec3<f32>;
    var beyond: f32;
    var bordered: bool;
    var local_68: f32;
    var gap: f32;
    var k_20: i32 = 0i;
    var local_69: f32;
    var share_2: f32;
    var u_11: f32;
    var p_9: vec3<f32>;
    var height_1: f32;
    var front: bool;
    var local_70: f32;
    var local_71: f32;
    var local_72: f32;
    var local_73: f32;
    var u_12: f32;
    var near: f32;
    var far: f32;

    origin_9 = origin_8;
    along_9 = along_8;
    view_14 = view_13;
    let _e26 = view_14;
    let _e28 = along_9;
    way_6 = (_e26.reach * _e28);
    let _e31 = origin_9;
    let _e32 = way_6;
    let _e33 = sceneShown(_e31, _e32);
    end_1 = _e33;
    let _e35 = origin_9;
    let _e36 = end_1;
    let _e37 = way_6;
    to = (_e35 + (_e36 * _e37));
    let _e41 = origin_9;
    let _e43 = origin_9;
    let _e47 = origin_9;
    a_26 = (vec3<f32>(_e41.x, _e43.y, 1f) / vec3(_e47.w));
    let _e52 = to;
    let _e54 = to;
    let _e58 = to;
    b_17 = (vec3<f32>(_e52.x, _e54.y, 1f) / vec3(_e58.w));
    met_1.seen = false;
    met_1.metres = -1f;
    loop {
        let _e83 = k_19;
        let _e85 = crossed;
        if !(((_e83 <= SCENE_STEPS) && !(_e85))) {
            break;
        }
        {
            let _e92 = k_19;
            high_1 = (f32(_e92) / 12f);
            let _e97 = a_26;
            let _e98 = b_17;
            let _e99 = high_1;
            p_8 = mix(_e97, _e98, vec3(_e99));
            let _e105 = p_8;
            let _e109 = view_14;
            let _e115 = p_8;
            let _e119 = view_14;
            let _e124 = engineSceneDepth(vec2<f32>(((0.5f + (0.5f * _e105.x)) * _e109.size.x), ((0.5f - (0.5f * _e115.y)) * _e119.size.y)));
            depth_8 = _e124;
            let _e125 = p_8;
            let _e128 = depth_8;
            heightHigh = (_e125.z - (1f / _e128));
            let _e131 = heightHigh;
            let _e134 = k_19;
            let _e137 = heightLow;
            crossed = ((_e131 < 0f) && ((_e134 == 1i) || (_e137 >= 0f)));
            let _e142 = crossed;
            if !(_e142) {
                {
                    let _e144 = high_1;
                    low_6 = _e144;
                    let _e145 = heightHigh;
                    heightLow = _e145;
                }
            }
        }
        continuing {
            let _e89 = k_19;
            k_19 = (_e89 + 1i);
        }
    }
    let _e146 = crossed;
    if !(_e146) {
        {
            let _e148 = depth_8;
            let _e149 = origin_9;
            let _e152 = along_9;
            beyond = ((_e148 - _e149.w) / _e152.w);
            let _e156 = end_1;
            let _e159 = depth_8;
            let _e163 = heightHigh;
            let _e167 = beyond;
            bordered = ((((_e156 < 1f) && (_e159 < 100000000000000000000000000000f)) && (_e163 >= 0f)) && (_e167 > 0f));
            let _e173 = bordered;
            if _e173 {
                let _e174 = beyond;
                local_68 = _e174;
            } else {
                local_68 = -1f;
            }
            let _e178 = local_68;
            met_1.metres = _e178;
            let _e180 = bordered;
            let _e181 = heightHigh;
            let _e184 = depth_8;
            let _e188 = along_9;
            met_1.seen = (_e180 || (((_e181 >= 0f) && (_e184 > 100000000000000000000000000000f)) && (_e188.w > 0f)));
            let _e194 = met_1;
            return _e194;
        }
    }
    let _e195 = heightLow;
    let _e196 = heightHigh;
    gap = max((_e195 - _e196), 0.000000000000000000000000000001f);
    loop {
        let _e203 = k_20;
        if !((_e203 < SCENE_SECANTS)) {
            break;
        }
        {
            let _e209 = k_20;
            if ((_e209 % 2i) == 0i) {
                local_69 = 0.5f;
            } else {
                let _e215 = heightLow;
                let _e216 = heightLow;
                let _e217 = heightHigh;
                local_69 = (_e215 / max((_e216 - _e217), 0.000000000000000000000000000001f));
            }
            let _e223 = local_69;
            share_2 = _e223;
            let _e225 = low_6;
            let _e226 = high_1;
            let _e227 = share_2;
            u_11 = mix(_e225, _e226, clamp(_e227, 0f, 1f));
            let _e233 = a_26;
            let _e234 = b_17;
            let _e235 = u_11;
            p_9 = mix(_e233, _e234, vec3(_e235));
            let _e241 = p_9;
            let _e245 = view_14;
            let _e251 = p_9;
            let _e255 = view_14;
            let _e260 = engineSceneDepth(vec2<f32>(((0.5f + (0.5f * _e241.x)) * _e245.size.x), ((0.5f - (0.5f * _e251.y)) * _e255.size.y)));
            depth_8 = _e260;
            let _e261 = p_9;
            let _e264 = depth_8;
            height_1 = (_e261.z - (1f / _e264));
            let _e268 = height_1;
            front = (_e268 >= 0f);
            let _e272 = front;
            if _e272 {
                let _e273 = u_11;
                local_70 = _e273;
            } else {
                let _e274 = low_6;
                local_70 = _e274;
            }
            let _e276 = local_70;
            low_6 = _e276;
            let _e277 = front;
            if _e277 {
                let _e278 = height_1;
                local_71 = _e278;
            } else {
                let _e279 = heightLow;
                local_71 = _e279;
            }
            let _e281 = local_71;
            heightLow = _e281;
            let _e282 = front;
            if _e282 {
                let _e283 = high_1;
                local_72 = _e283;
            } else {
                let _e284 = u_11;
                local_72 = _e284;
            }
            let _e286 = local_72;
            high_1 = _e286;
            let _e287 = front;
            if _e287 {
                let _e288 = heightHigh;
                local_73 = _e288;
            } else {
                let _e289 = height_1;
                local_73 = _e289;
            }
            let _e291 = local_73;
            heightHigh = _e291;
        }
        continuing {
            let _e206 = k_20;
            k_20 = (_e206 + 1i);
        }
    }
    let _e292 = low_6;
    let _e293 = high_1;
    let _e294 = heightLow;
    let _e295 = heightLow;
    let _e296 = heightHigh;
    u_12 = mix(_e292, _e293, (_e294 / max((_e295 - _e296), 0.000000000000000000000000000001f)));
    let _e304 = u_12;
    let _e306 = origin_9;
    near = ((1f - _e304) / _e306.w);
    let _e310 = u_12;
    let _e311 = to;
    far = (_e310 / _e311.w);
    let _e316 = view_14;
    let _e318 = end_1;
    let _e320 = far;
    let _e322 = near;
    let _e323 = far;
    met_1.metres = (((_e316.reach * _e318) * _e320) / (_e322 + _e323));
    let _e327 = heightLow;
    let _e328 = heightHigh;
    let _e331 = gap;
    let _e334 = gap;
    met_1.seen = (((_e327 - _e328) < (0.5f * _e331)) || (_e334 < 0.000001f));
    let _e338 = met_1;
    return _e338;
}

fn sceneMeeting(origin_10: vec3<f32>, direction_10: vec3<f32>, view_15: SceneView) -> SceneMeeting {
    var origin_11: vec3<f32>;
    var direction_11: vec3<f32>;
    var view_16: SceneView;
    var from_: vec4<f32>;
    var along_10: vec4<f32>;
    var met_2: SceneMeeting;

    origin_11 = origin_10;
    direction_11 = direction_10;
    view_16 = view_15;
    let _e26 = view_16;
    let _e28 = origin_11;
    from_ = (_e26.clipFromWorld * vec4<f32>(_e28.x, _e28.y, _e28.z, 1f));
    let _e36 = view_16;
    let _e38 = direction_11;
    along_10 = (_e36.clipFromWorld * vec4<f32>(_e38.x, _e38.y, _e38.z, 0f));
    let _e46 = from_;
    let _e47 = along_10;
    let _e48 = view_16;
    let _e49 = sceneGuess(_e46, _e47, _e48);
    met_2 = _e49;
    let _e51 = met_2;
    if !(_e51.seen) {
        let _e54 = from_;
        let _e55 = along_10;
        let _e56 = view_16;
        let _e57 = sceneMarch(_e54, _e55, _e56);
        met_2 = _e57;
    }
    let _e58 = met_2;
    return _e58;
}

fn engineBackFace(at_15: vec2<f32>) -> vec4<f32> {
    var at_16: vec2<f32>;

    at_16 = at_15;
    return vec4(0f);
}

fn pixelStep(view_17: SceneView, axis: i32) -> vec3<f32> {
    var view_18: SceneView;
    var axis_1: i32;
    var forward: vec3<f32>;
    var local_74: vec3<f32>;
    var row: vec3<f32>;
    var across_7: vec3<f32>;
    var local_75: f32;

    view_18 = view_17;
    axis_1 = axis;
    let _e30 = view_18.clipFromWorld[0][3];
    let _e36 = view_18.clipFromWorld[1][3];
    let _e42 = view_18.clipFromWorld[2][3];
    forward = vec3<f32>(_e30, _e36, _e42);
    let _e45 = axis_1;
    if (_e45 == 0i) {
        let _e53 = view_18.clipFromWorld[0][0];
        let _e59 = view_18.clipFromWorld[1][0];
        let _e65 = view_18.clipFromWorld[2][0];
        local_74 = vec3<f32>(_e53, _e59, _e65);
    } else {
        let _e72 = view_18.clipFromWorld[0][1];
        let _e78 = view_18.clipFromWorld[1][1];
        let _e84 = view_18.clipFromWorld[2][1];
        local_74 = vec3<f32>(_e72, _e78, _e84);
    }
    let _e87 = local_74;
    row = _e87;
    let _e89 = row;
    let _e90 = row;
    let _e91 = forward;
    let _e93 = forward;
    across_7 = (_e89 - (dot(_e90, _e91) * _e93));
    let _e97 = axis_1;
    if (_e97 == 0i) {
        let _e101 = view_18;
        local_75 = (2f / _e101.size.x);
    } else {
        let _e107 = view_18;
        local_75 = (-2f / _e107.size.y);
    }
    let _e112 = local_75;
    let _e113 = across_7;
    let _e114 = across_7;
    let _e117 = across_7;
    return ((_e112 / dot(_e113, _e114)) * _e117);
}

fn backFaceAt(at_17: vec2<f32>, p_10: vec3<f32>, w_27: f32, number: f32, view_19: SceneView) -> BackFace {
    var at_18: vec2<f32>;
    var p_11: vec3<f32>;
    var w_28: f32;
    var number_1: f32;
    var view_20: SceneView;
    var texel_4: vec4<f32>;
    var off: vec2<f32>;
    var face_6: BackFace;

    at_18 = at_17;
    p_11 = p_10;
    w_28 = w_27;
    number_1 = number;
    view_20 = view_19;
    let _e31 = at_18;
    let _e32 = engineBackFace(_e31);
    texel_4 = _e32;
    let _e34 = at_18;
    let _e39 = at_18;
    off = ((floor(_e34) + vec2(0.5f)) - _e39);
    let _e44 = view_20;
    let _e46 = p_11;
    let _e47 = view_20;
    let _e50 = texel_4;
    let _e52 = w_28;
    let _e56 = texel_4;
    let _e58 = off;
    let _e60 = view_20;
    let _e62 = pixelStep(_e60, 0i);
    let _e64 = off;
    let _e66 = view_20;
    let _e68 = pixelStep(_e66, 1i);
    face_6.point = ((_e44.eye + ((_e46 - _e47.eye) * (_e50.z / _e52))) + (_e56.z * ((_e58.x * _e62) + (_e64.y * _e68))));
    let _e74 = texel_4;
    let _e76 = texel_4;
    let _e79 = octDecode(vec2<f32>(_e74.x, _e76.y));
    face_6.n = _e79;
    let _e82 = texel_4;
    face_6.alpha = (2f * fract(_e82.w));
    let _e87 = texel_4;
    let _e90 = number_1;
    face_6.exists = (floor(_e87.w) == _e90);
    let _e92 = face_6;
    return _e92;
}

fn backFaceBeside(own: BackFace, at_19: vec2<f32>, p_12: vec3<f32>, w_29: f32, number_2: f32, view_21: SceneView) -> BackFace {
    var own_1: BackFace;
    var at_20: vec2<f32>;
    var p_13: vec3<f32>;
    var w_30: f32;
    var number_3: f32;
    var view_22: SceneView;
    var beside_1: BackFace;

    own_1 = own;
    at_20 = at_19;
    p_13 = p_12;
    w_30 = w_29;
    number_3 = number_2;
    view_22 = view_21;
    let _e33 = at_20;
    let _e34 = p_13;
    let _e35 = w_30;
    let _e36 = number_3;
    let _e37 = view_22;
    let _e38 = backFaceAt(_e33, _e34, _e35, _e36, _e37);
    beside_1 = _e38;
    let _e40 = beside_1;
    let _e42 = own_1;
    let _e44 = own_1;
    let _e46 = beside_1;
    let _e48 = beside_1;
    let _e50 = exitSame(_e42.point, _e44.n, _e46.point, _e48.n);
    if (_e40.exists && _e50) {
        let _e52 = beside_1;
        return _e52;
    }
    let _e53 = own_1;
    return _e53;
}

fn backFaceBetween(face_7: BackFace, at_21: vec2<f32>, hit: vec2<f32>, p_14: vec3<f32>, w_31: f32, number_4: f32, origin_12: vec3<f32>, direction_12: vec3<f32>, view_23: SceneView) -> BackFaceExit {
    var face_8: BackFace;
    var at_22: vec2<f32>;
    var hit_1: vec2<f32>;
    var p_15: vec3<f32>;
    var w_32: f32;
    var number_5: f32;
    var origin_13: vec3<f32>;
    var direction_13: vec3<f32>;
    var view_24: SceneView;
    var stepX_2: vec3<f32>;
    var stepY_2: vec3<f32>;
    var right_1: BackFace;
    var below_3: BackFace;
    var off_1: vec2<f32>;
    var found: BackFaceExit;
    var cosTheta_30: f32;
    var curvature_4: vec2<f32>;

    face_8 = face_7;
    at_22 = at_21;
    hit_1 = hit;
    p_15 = p_14;
    w_32 = w_31;
    number_5 = number_4;
    origin_13 = origin_12;
    direction_13 = direction_12;
    view_24 = view_23;
    let _e39 = view_24;
    let _e41 = pixelStep(_e39, 0i);
    stepX_2 = _e41;
    let _e43 = view_24;
    let _e45 = pixelStep(_e43, 1i);
    stepY_2 = _e45;
    let _e47 = face_8;
    let _e48 = at_22;
    let _e53 = p_15;
    let _e54 = w_32;
    let _e55 = stepX_2;
    let _e58 = w_32;
    let _e59 = number_5;
    let _e60 = view_24;
    let _e61 = backFaceBeside(_e47, (_e48 + vec2<f32>(1f, 0f)), (_e53 + (_e54 * _e55)), _e58, _e59, _e60);
    right_1 = _e61;
    let _e63 = face_8;
    let _e64 = at_22;
    let _e69 = p_15;
    let _e70 = w_32;
    let _e71 = stepY_2;
    let _e74 = w_32;
    let _e75 = number_5;
    let _e76 = view_24;
    let _e77 = backFaceBeside(_e63, (_e64 + vec2<f32>(0f, 1f)), (_e69 + (_e70 * _e71)), _e74, _e75, _e76);
    below_3 = _e77;
    let _e79 = hit_1;
    let _e80 = at_22;
    off_1 = ((_e79 - floor(_e80)) - vec2(0.5f));
    let _e91 = face_8;
    let _e93 = off_1;
    let _e95 = right_1;
    let _e97 = face_8;
    let _e102 = off_1;
    let _e104 = below_3;
    let _e106 = face_8;
    found.exit.surface.n = normalize(((_e91.n + (_e93.x * (_e95.n - _e97.n))) + (_e102.y * (_e104.n - _e106.n))));
    let _e115 = face_8;
    found.exit.surface.alpha = _e115.alpha;
    let _e119 = origin_13;
    let _e120 = direction_13;
    let _e121 = face_8;
    let _e123 = face_8;
    let _e125 = exitPlane(_e119, _e120, _e121.point, _e123.n);
    found.exit.path = _e125;
    let _e126 = direction_13;
    let _e127 = found;
    cosTheta_30 = dot(_e126, _e127.exit.surface.n);
    let _e133 = face_8;
    let _e135 = direction_13;
    let _e136 = right_1;
    let _e138 = face_8;
    let _e141 = right_1;
    let _e143 = face_8;
    let _e146 = below_3;
    let _e148 = face_8;
    let _e151 = below_3;
    let _e153 = face_8;
    let _e156 = exitCurvature(_e133.n, _e135, (_e136.point - _e138.point), (_e141.n - _e143.n), (_e146.point - _e148.point), (_e151.n - _e153.n));
    curvature_4 = _e156;
    let _e161 = cosTheta_30;
    let _e162 = found;
    let _e165 = curvature_4;
    let _e166 = exitTurn(_e161, _e162.exit.path, _e165);
    found.exit.surface.turn = _e166;
    let _e168 = cosTheta_30;
    found.found = (_e168 > 0f);
    let _e171 = found;
    return _e171;
}

fn backFaceExit(origin_14: vec3<f32>, direction_14: vec3<f32>, first_3: f32, eta_44: f32, number_6: f32, view_25: SceneView) -> BackFaceExit {
    var origin_15: vec3<f32>;
    var direction_15: vec3<f32>;
    var first_4: f32;
    var eta_45: f32;
    var number_7: f32;
    var view_26: SceneView;
    var none: BackFaceExit;
    var inside_2: f32 = 0f;
    var t_27: f32;
    var k_21: i32 = 0i;
    var p_16: vec3<f32>;
    var clip_3: vec4<f32>;
    var at_23: vec2<f32>;
    var face_9: BackFace;
    var met_3: f32;
    var meets: bool;
    var there_1: vec4<f32>;
    var hit_2: vec2<f32>;
    var moved: vec2<f32>;
    var found_1: BackFaceExit;

    origin_15 = origin_14;
    direction_15 = direction_14;
    first_4 = first_3;
    eta_45 = eta_44;
    number_7 = number_6;
    view_26 = view_25;
    let _e37 = direction_15;
    none.exit.surface.n = _e37;
    none.exit.surface.alpha = 0f;
    none.exit.surface.turn = vec2(0f);
    none.exit.path = 0f;
    let _e53 = eta_45;
    none.exit.surface.eta = _e53;
    none.found = false;
    let _e58 = first_4;
    t_27 = _e58;
    loop {
        let _e62 = k_21;
        if !((_e62 < BACK_FACE_STEPS)) {
            break;
        }
        {
            let _e68 = origin_15;
            let _e69 = t_27;
            let _e70 = direction_15;
            p_16 = (_e68 + (_e69 * _e70));
            let _e74 = view_26;
            let _e76 = p_16;
            clip_3 = (_e74.clipFromWorld * vec4<f32>(_e76.x, _e76.y, _e76.z, 1f));
            let _e84 = clip_3;
            if !((_e84.w > 0f)) {
                let _e89 = none;
                return _e89;
            }
            let _e90 = clip_3;
            let _e91 = view_26;
            let _e93 = scenePixel(_e90, _e91.size);
            at_23 = _e93;
            let _e95 = at_23;
            let _e96 = p_16;
            let _e97 = clip_3;
            let _e99 = number_7;
            let _e100 = view_26;
            let _e101 = backFaceAt(_e95, _e96, _e97.w, _e99, _e100);
            face_9 = _e101;
            let _e103 = origin_15;
            let _e104 = direction_15;
            let _e105 = face_9;
            let _e107 = face_9;
            let _e109 = exitPlane(_e103, _e104, _e105.point, _e107.n);
            met_3 = _e109;
            let _e111 = face_9;
            let _e113 = direction_15;
            let _e114 = face_9;
            let _e120 = met_3;
            meets = ((_e111.exists && (dot(_e113, _e114.n) > 0f)) && (_e120 > 0f));
            let _e125 = k_21;
            let _e128 = meets;
            let _e131 = face_9;
            if (((_e125 == 0i) && !(_e128)) && _e131.exists) {
                {
                    let _e134 = face_9;
                    let _e136 = p_16;
                    t_27 = length((_e134.point - _e136));
                    continue;
                }
            }
            let _e139 = k_21;
            let _e142 = meets;
            if ((_e139 == 0i) && !(_e142)) {
                let _e145 = none;
                return _e145;
            }
            let _e146 = meets;
            if !(_e146) {
                {
                    let _e149 = inside_2;
                    let _e150 = t_27;
                    t_27 = (0.5f * (_e149 + _e150));
                    continue;
                }
            }
            let _e153 = view_26;
            let _e155 = origin_15;
            let _e156 = met_3;
            let _e157 = direction_15;
            let _e159 = (_e155 + (_e156 * _e157));
            there_1 = (_e153.clipFromWorld * vec4<f32>(_e159.x, _e159.y, _e159.z, 1f));
            let _e167 = there_1;
            let _e168 = view_26;
            let _e170 = scenePixel(_e167, _e168.size);
            hit_2 = _e170;
            let _e172 = hit_2;
            let _e173 = at_23;
            moved = (_e172 - _e173);
            let _e176 = there_1;
            let _e180 = moved;
            let _e181 = moved;
            if ((_e176.w > 0f) && (dot(_e180, _e181) < 0.5f)) {
                {
                    let _e186 = face_9;
                    let _e187 = at_23;
                    let _e188 = hit_2;
                    let _e189 = p_16;
                    let _e190 = clip_3;
                    let _e192 = number_7;
                    let _e193 = origin_15;
                    let _e194 = direction_15;
                    let _e195 = view_26;
                    let _e196 = backFaceBetween(_e186, _e187, _e188, _e189, _e190.w, _e192, _e193, _e194, _e195);
                    found_1 = _e196;
                    let _e201 = eta_45;
                    found_1.exit.surface.eta = _e201;
                    let _e202 = found_1;
                    return _e202;
                }
            }
            let _e203 = t_27;
            inside_2 = _e203;
            let _e204 = met_3;
            t_27 = _e204;
        }
        continuing {
            let _e65 = k_21;
            k_21 = (_e65 + 1i);
        }
    }
    let _e205 = none;
    return _e205;
}

fn beamSide(direction_16: vec3<f32>) -> vec3<f32> {
    var direction_17: vec3<f32>;
    var level: vec3<f32>;
    var s_9: f32;
    var local_76: vec3<f32>;

    direction_17 = direction_16;
    let _e23 = direction_17;
    let _e26 = direction_17;
    level = vec3<f32>(_e23.z, 0f, -(_e26.x));
    let _e31 = level;
    let _e32 = level;
    s_9 = dot(_e31, _e32);
    let _e35 = s_9;
    if (_e35 > 0f) {
        let _e38 = level;
        let _e39 = s_9;
        local_76 = (_e38 * inverseSqrt(_e39));
    } else {
        local_76 = vec3<f32>(1f, 0f, 0f);
    }
    let _e47 = local_76;
    return _e47;
}

fn beamPart(direction_18: vec3<f32>, sigma_4: f32, inner_2: f32, carried: f32, part: vec3<f32>) -> BeamPart {
    var direction_19: vec3<f32>;
    var sigma_5: f32;
    var inner_3: f32;
    var carried_1: f32;
    var part_1: vec3<f32>;
    var side_3: vec3<f32>;
    var off_2: vec3<f32>;
    var turn_2: f32;
    var p_17: BeamPart;
    var local_77: f32;
    var local_78: f32;
    var together: f32;
    var rest_5: f32;
    var local_79: f32;

    direction_19 = direction_18;
    sigma_5 = sigma_4;
    inner_3 = inner_2;
    carried_1 = carried;
    part_1 = part;
    let _e31 = direction_19;
    let _e32 = beamSide(_e31);
    side_3 = _e32;
    let _e34 = part_1;
    let _e36 = side_3;
    let _e38 = part_1;
    let _e40 = direction_19;
    let _e41 = side_3;
    off_2 = ((_e34.x * _e36) + (_e38.y * cross(_e40, _e41)));
    let _e46 = sigma_5;
    let _e47 = off_2;
    turn_2 = (_e46 * length(_e47));
    let _e53 = turn_2;
    let _e55 = direction_19;
    let _e57 = turn_2;
    if (_e57 > 0f) {
        let _e60 = turn_2;
        let _e62 = turn_2;
        local_77 = (sin(_e60) / _e62);
    } else {
        local_77 = 1f;
    }
    let _e66 = local_77;
    let _e67 = sigma_5;
    let _e69 = off_2;
    p_17.direction = ((cos(_e53) * _e55) + ((_e66 * _e67) * _e69));
    let _e73 = part_1;
    let _e75 = sigma_5;
    p_17.sigma = (_e73.z * _e75);
    let _e77 = sigma_5;
    if (_e77 > 0f) {
        let _e80 = carried_1;
        let _e81 = sigma_5;
        local_78 = clamp((_e80 / _e81), -1f, 1f);
    } else {
        local_78 = 0f;
    }
    let _e89 = local_78;
    together = _e89;
    let _e92 = together;
    let _e93 = inner_3;
    let _e95 = off_2;
    p_17.aside = ((_e92 * _e93) * _e95);
    let _e98 = together;
    let _e99 = together;
    let _e102 = part_1;
    let _e104 = part_1;
    rest_5 = sqrt(max((1f - ((_e98 * _e99) * (1f - (_e102.z * _e104.z)))), 0f));
    let _e115 = rest_5;
    let _e116 = inner_3;
    p_17.inner = (_e115 * _e116);
    let _e119 = rest_5;
    if (_e119 > 0f) {
        let _e122 = together;
        let _e123 = sigma_5;
        let _e125 = part_1;
        let _e128 = part_1;
        let _e131 = rest_5;
        local_79 = ((((_e122 * _e123) * _e125.z) * _e128.z) / _e131);
    } else {
        local_79 = 0f;
    }
    let _e135 = local_79;
    p_17.carried = _e135;
    let _e136 = p_17;
    return _e136;
}

fn composeTap(inner_4: InnerTap, view_27: ExitView, s_10: ExitSurface, angle: f32, sigma_6: f32, weight: f32, energy_1: f32) -> ComposedTap {
    var inner_5: InnerTap;
    var view_28: ExitView;
    var s_11: ExitSurface;
    var angle_1: f32;
    var sigma_7: f32;
    var weight_1: f32;
    var energy_2: f32;
    var tap_2: ComposedTap;
    var ratio: f32;
    var along_11: vec3<f32>;
    var sinTheta: f32;
    var t_28: vec3<f32>;
    var d_17: vec2<f32>;
    var l_4: vec2<f32>;
    var local_80: f32;
    var h_15: vec2<f32>;
    var bend: f32;
    var ci: f32;
    var co: f32;
    var rays_1: f32;
    var turned: f32;
    var kept: f32;
    var seen_1: f32;
    var across_8: f32;
    var sigma2_: f32;
    var inPlane: f32;
    var outOfPlane: f32;
    var local_81: f32;
    var carriedInPlane: f32;

    inner_5 = inner_4;
    view_28 = view_27;
    s_11 = s_10;
    angle_1 = angle;
    sigma_7 = sigma_6;
    weight_1 = weight;
    energy_2 = energy_1;
    let _e41 = inner_5;
    tap_2.direction = _e41.direction;
    let _e44 = inner_5;
    tap_2.sigma = _e44.sigma;
    let _e47 = inner_5;
    tap_2.inner = _e47.sigma;
    let _e50 = inner_5;
    tap_2.carried = _e50.sigma;
    let _e53 = inner_5;
    let _e55 = weight_1;
    let _e57 = energy_2;
    tap_2.weight = ((_e53.weight * _e55) * _e57);
    let _e59 = view_28;
    if !((_e59.cosTheta > 0f)) {
        tap_2.weight = 0f;
    }
    let _e67 = s_11;
    ratio = (1f / _e67.eta);
    let _e71 = view_28;
    let _e76 = ratio;
    if (!((_e71.cosTheta > 0f)) || (abs((_e76 - 1f)) < INDEX_MATCHED)) {
        let _e82 = tap_2;
        return _e82;
    }
    let _e83 = inner_5;
    let _e85 = view_28;
    let _e87 = s_11;
    along_11 = (_e83.direction - (_e85.cosTheta * _e87.n));
    let _e92 = along_11;
    sinTheta = length(_e92);
    let _e95 = along_11;
    let _e96 = sinTheta;
    t_28 = (_e95 / vec3(max(_e96, 0.000000000001f)));
    let _e102 = sinTheta;
    let _e103 = view_28;
    d_17 = vec2<f32>(_e102, _e103.cosTheta);
    let _e107 = angle_1;
    let _e109 = angle_1;
    l_4 = vec2<f32>(sin(_e107), cos(_e109));
    let _e113 = ratio;
    let _e114 = d_17;
    let _e116 = l_4;
    let _e118 = ratio;
    if (_e118 < 1f) {
        local_80 = -1f;
    } else {
        local_80 = 1f;
    }
    let _e125 = local_80;
    h_15 = (((_e113 * _e114) - _e116) * _e125);
    let _e128 = h_15;
    bend = max(length(_e128), 0.00005f);
    let _e135 = d_17;
    let _e136 = h_15;
    let _e138 = bend;
    ci = (dot(_e135, _e136) / _e138);
    let _e141 = l_4;
    let _e142 = h_15;
    let _e144 = bend;
    co = max((dot(_e141, _e142) / _e144), FACET_LEAST_COS);
    let _e149 = view_28;
    rays_1 = (1f - _e149.own);
    let _e153 = angle_1;
    let _e154 = rays_1;
    let _e156 = view_28;
    let _e159 = h_15;
    let _e161 = h_15;
    turned = clamp((_e153 - (((GIVEN_BACK * _e154) / _e156.swing) * atan2(_e159.x, abs(_e161.y)))), -1.5707964f, 1.5707964f);
    let _e177 = turned;
    let _e179 = t_28;
    let _e181 = turned;
    let _e183 = s_11;
    tap_2.direction = normalize(((sin(_e177) * _e179) + (cos(_e181) * _e183.n)));
    let _e188 = view_28;
    let _e190 = rays_1;
    let _e192 = view_28;
    let _e196 = view_28;
    kept = (_e188.own - ((_e190 * (1f - _e192.swing)) / _e196.swing));
    let _e201 = sigma_7;
    let _e202 = co;
    let _e205 = ratio;
    let _e206 = ci;
    let _e208 = kept;
    let _e209 = co;
    let _e213 = bend;
    seen_1 = (((_e201 * inverseSqrt(_e202)) * ((_e205 * _e206) - (_e208 * _e209))) / _e213);
    let _e216 = ratio;
    let _e217 = co;
    let _e218 = ratio;
    let _e219 = ci;
    let _e222 = s_11;
    across_8 = (_e216 + ((_e217 - (_e218 * _e219)) * _e222.turn.y));
    let _e228 = inner_5;
    let _e230 = inner_5;
    sigma2_ = (_e228.sigma * _e230.sigma);
    let _e234 = seen_1;
    let _e235 = seen_1;
    let _e237 = view_28;
    let _e239 = sigma2_;
    inPlane = min(((_e234 * _e235) + (_e237.own * _e239)), 0.09f);
    let _e247 = view_28;
    let _e249 = sigma_7;
    let _e251 = sigma_7;
    let _e253 = co;
    let _e255 = across_8;
    let _e256 = across_8;
    let _e258 = sigma2_;
    outOfPlane = ((((_e247.own * _e249) * _e251) * _e253) + ((_e255 * _e256) * _e258));
    let _e263 = inPlane;
    let _e264 = outOfPlane;
    tap_2.sigma = sqrt(sqrt((_e263 * _e264)));
    let _e268 = view_28;
    if (_e268.swing < 0f) {
        let _e272 = rays_1;
        local_81 = -(sqrt(_e272));
    } else {
        let _e275 = rays_1;
        local_81 = sqrt(_e275);
    }
    let _e278 = local_81;
    let _e279 = seen_1;
    let _e281 = view_28;
    let _e283 = inner_5;
    carriedInPlane = ((_e278 * _e279) + (_e281.own * _e283.sigma));
    let _e290 = carriedInPlane;
    let _e291 = across_8;
    let _e292 = inner_5;
    let _e297 = tap_2;
    let _e300 = tap_2;
    tap_2.carried = clamp((0.5f * (_e290 + (_e291 * _e292.sigma))), -(_e297.sigma), _e300.sigma);
    let _e303 = tap_2;
    return _e303;
}

fn mergeTaps(a_27: ComposedTap, b_18: ComposedTap) -> ComposedTap {
    var a_28: ComposedTap;
    var b_19: ComposedTap;
    var weight_2: f32;
    var local_82: f32;
    var share_3: f32;
    var apart: vec3<f32>;
    var mean_2: vec3<f32>;
    var inner2_: f32;
    var both: f32;
    var tap_3: ComposedTap;
    var local_83: vec3<f32>;
    var local_84: f32;

    a_28 = a_27;
    b_19 = b_18;
    let _e29 = a_28;
    let _e31 = b_19;
    weight_2 = (_e29.weight + _e31.weight);
    let _e35 = weight_2;
    if (_e35 > 0f) {
        let _e38 = b_19;
        let _e40 = weight_2;
        local_82 = (_e38.weight / _e40);
    } else {
        local_82 = 0f;
    }
    let _e44 = local_82;
    share_3 = _e44;
    let _e46 = b_19;
    let _e48 = a_28;
    apart = (_e46.direction - _e48.direction);
    let _e52 = a_28;
    let _e54 = share_3;
    let _e55 = apart;
    mean_2 = (_e52.direction + (_e54 * _e55));
    let _e59 = a_28;
    let _e61 = a_28;
    let _e64 = b_19;
    let _e66 = b_19;
    let _e69 = share_3;
    inner2_ = mix((_e59.inner * _e61.inner), (_e64.inner * _e66.inner), _e69);
    let _e72 = a_28;
    let _e74 = a_28;
    let _e77 = b_19;
    let _e79 = b_19;
    let _e82 = share_3;
    both = mix((_e72.inner * _e74.carried), (_e77.inner * _e79.carried), _e82);
    let _e87 = weight_2;
    tap_3.weight = _e87;
    let _e89 = mean_2;
    let _e90 = mean_2;
    if (dot(_e89, _e90) > 0.000001f) {
        let _e94 = mean_2;
        local_83 = normalize(_e94);
    } else {
        let _e96 = a_28;
        local_83 = _e96.direction;
    }
    let _e99 = local_83;
    tap_3.direction = _e99;
    let _e101 = a_28;
    let _e103 = a_28;
    let _e106 = b_19;
    let _e108 = b_19;
    let _e111 = share_3;
    let _e114 = share_3;
    let _e117 = share_3;
    let _e120 = apart;
    let _e121 = apart;
    tap_3.sigma = sqrt((mix((_e101.sigma * _e103.sigma), (_e106.sigma * _e108.sigma), _e111) + (((0.5f * _e114) * (1f - _e117)) * dot(_e120, _e121))));
    let _e127 = inner2_;
    tap_3.inner = sqrt(_e127);
    let _e130 = tap_3;
    if (_e130.inner > 0f) {
        let _e134 = both;
        let _e135 = tap_3;
        local_84 = (_e134 / _e135.inner);
    } else {
        local_84 = 0f;
    }
    let _e140 = local_84;
    tap_3.carried = _e140;
    let _e141 = tap_3;
    return _e141;
}

fn composedPair(core_2: ComposedTap, tail_1: ComposedTap, view_29: ExitView) -> ComposedPair {
    var core_3: ComposedTap;
    var tail_2: ComposedTap;
    var view_30: ExitView;
    var moved_1: f32;
    var pair_1: ComposedPair;

    core_3 = core_2;
    tail_2 = tail_1;
    view_30 = view_29;
    let _e32 = view_30;
    let _e35 = tail_2;
    moved_1 = ((1f - _e32.own) * _e35.weight);
    let _e41 = core_3;
    pair_1.core = _e41;
    let _e43 = tail_2;
    pair_1.rest = _e43;
    let _e46 = core_3;
    let _e48 = moved_1;
    pair_1.core.weight = (_e46.weight + _e48);
    let _e52 = tail_2;
    let _e54 = moved_1;
    pair_1.rest.weight = (_e52.weight - _e54);
    let _e56 = pair_1;
    return _e56;
}

fn mergePairs(core_4: ComposedPair, tail_3: ComposedPair) -> ComposedPair {
    var core_5: ComposedPair;
    var tail_4: ComposedPair;
    var pair_2: ComposedPair;

    core_5 = core_4;
    tail_4 = tail_3;
    let _e31 = core_5;
    pair_2.core = _e31.core;
    let _e34 = core_5;
    let _e36 = tail_4;
    let _e38 = mergeTaps(_e34.rest, _e36.core);
    let _e39 = tail_4;
    let _e41 = mergeTaps(_e38, _e39.rest);
    pair_2.rest = _e41;
    let _e42 = pair_2;
    return _e42;
}

fn interfaceCosineAxis(cosTheta_31: f32, eta_46: f32) -> f32 {
    var cosTheta_32: f32;
    var eta_47: f32;
    var c_25: f32;
    var critical: f32;
    var past: bool;
    var local_85: f32;
    var along_12: f32;
    var grazing: bool;
    var local_86: f32;
    var local_87: f32;
    var x_22: f32;
    var local_88: f32;
    var local_89: f32;

    cosTheta_32 = cosTheta_31;
    eta_47 = eta_46;
    let _e35 = cosTheta_32;
    c_25 = clamp(_e35, 0f, 1f);
    let _e40 = eta_47;
    if (_e40 >= 1f) {
        let _e43 = c_25;
        return sqrt(_e43);
    }
    let _e46 = eta_47;
    let _e49 = eta_47;
    critical = sqrt(((1f - _e46) * (1f + _e49)));
    let _e54 = c_25;
    let _e55 = critical;
    past = (_e54 < _e55);
    let _e58 = past;
    if _e58 {
        let _e59 = c_25;
        let _e60 = critical;
        local_85 = (_e59 / _e60);
    } else {
        let _e62 = c_25;
        let _e63 = critical;
        let _e66 = critical;
        local_85 = ((_e62 - _e63) / (1f - _e66));
    }
    let _e70 = local_85;
    along_12 = _e70;
    let _e72 = past;
    let _e73 = along_12;
    grazing = (_e72 && (_e73 < 0.5f));
    let _e78 = past;
    if _e78 {
        let _e80 = grazing;
        if _e80 {
            let _e81 = along_12;
            local_86 = _e81;
        } else {
            let _e83 = along_12;
            local_86 = (1f - _e83);
        }
        let _e86 = local_86;
        local_87 = (0.125f * _e86);
    } else {
        let _e89 = along_12;
        local_87 = (0.25f * _e89);
    }
    let _e92 = local_87;
    x_22 = sqrt(_e92);
    let _e95 = grazing;
    if _e95 {
        let _e96 = x_22;
        local_89 = _e96;
    } else {
        let _e97 = past;
        if _e97 {
            let _e99 = x_22;
            local_88 = (0.5f - _e99);
        } else {
            let _e102 = x_22;
            local_88 = (0.5f + _e102);
        }
        let _e105 = local_88;
        local_89 = _e105;
    }
    let _e107 = local_89;
    return _e107;
}

fn interfaceCosineAt(x_23: f32, eta_48: f32) -> f32 {
    var x_24: f32;
    var eta_49: f32;
    var critical_1: f32;
    var away: f32;
    var local_90: f32;

    x_24 = x_23;
    eta_49 = eta_48;
    let _e35 = eta_49;
    if (_e35 >= 1f) {
        let _e38 = x_24;
        let _e39 = x_24;
        return (_e38 * _e39);
    }
    let _e42 = eta_49;
    let _e45 = eta_49;
    critical_1 = sqrt(((1f - _e42) * (1f + _e45)));
    let _e50 = x_24;
    away = (_e50 - 0.5f);
    let _e54 = away;
    if (_e54 >= 0f) {
        let _e57 = critical_1;
        let _e59 = away;
        let _e61 = away;
        let _e64 = critical_1;
        return (_e57 + (((4f * _e59) * _e61) * (1f - _e64)));
    }
    let _e68 = critical_1;
    let _e69 = x_24;
    if (_e69 < 0.25f) {
        let _e73 = x_24;
        let _e75 = x_24;
        local_90 = ((8f * _e73) * _e75);
    } else {
        let _e79 = away;
        let _e81 = away;
        local_90 = (1f - ((8f * _e79) * _e81));
    }
    let _e85 = local_90;
    return (_e68 * _e85);
}

fn interfaceEtaAxis(eta_50: f32) -> f32 {
    var eta_51: f32;
    var local_91: f32;
    var n_40: f32;

    eta_51 = eta_50;
    let _e33 = eta_51;
    if (_e33 < 1f) {
        let _e37 = eta_51;
        local_91 = (1f / max(_e37, 0.01f));
    } else {
        let _e41 = eta_51;
        local_91 = _e41;
    }
    let _e43 = local_91;
    n_40 = clamp(_e43, 1f, INTERFACE_GREATEST_ETA);
    let _e47 = n_40;
    let _e50 = n_40;
    return (((_e47 - 1f) / (_e50 + 1f)) * 1.6666666f);
}

fn interfaceEnergyCoordinate(cosTheta_33: f32, alpha_80: f32, eta_52: f32) -> vec3<f32> {
    var cosTheta_34: f32;
    var alpha_81: f32;
    var eta_53: f32;
    var local_92: i32;

    cosTheta_34 = cosTheta_33;
    alpha_81 = alpha_80;
    eta_53 = eta_52;
    let _e37 = cosTheta_34;
    let _e38 = eta_53;
    let _e39 = interfaceCosineAxis(_e37, _e38);
    let _e42 = blockCoordinate(_e39, INTERFACE_ENERGY_COSINES, 0i, 1i);
    let _e43 = alpha_81;
    let _e49 = blockCoordinate(sqrt(max(_e43, 0f)), INTERFACE_ENERGY_ALPHAS, 0i, 1i);
    let _e50 = eta_53;
    let _e51 = interfaceEtaAxis(_e50);
    let _e52 = eta_53;
    if (_e52 < 1f) {
        local_92 = 1i;
    } else {
        local_92 = 0i;
    }
    let _e58 = local_92;
    let _e60 = blockCoordinate(_e51, INTERFACE_SLICES, _e58, 2i);
    return vec3<f32>(_e42, _e49, _e60);
}

fn interfaceLobeCoordinate(tap_4: i32, taps_6: i32, cosTheta_35: f32, alpha_82: f32, eta_54: f32) -> vec3<f32> {
    var tap_5: i32;
    var taps_7: i32;
    var cosTheta_36: f32;
    var alpha_83: f32;
    var eta_55: f32;
    var local_93: i32;

    tap_5 = tap_4;
    taps_7 = taps_6;
    cosTheta_36 = cosTheta_35;
    alpha_83 = alpha_82;
    eta_55 = eta_54;
    let _e41 = cosTheta_36;
    let _e42 = eta_55;
    let _e43 = interfaceCosineAxis(_e41, _e42);
    let _e46 = blockCoordinate(_e43, INTERFACE_LOBE_COSINES, 0i, 1i);
    let _e47 = alpha_83;
    let _e51 = tap_5;
    let _e52 = taps_7;
    let _e53 = blockCoordinate(sqrt(max(_e47, 0f)), INTERFACE_LOBE_ALPHAS, _e51, _e52);
    let _e54 = eta_55;
    let _e55 = interfaceEtaAxis(_e54);
    let _e56 = eta_55;
    if (_e56 < 1f) {
        local_93 = 1i;
    } else {
        local_93 = 0i;
    }
    let _e62 = local_93;
    let _e64 = blockCoordinate(_e55, INTERFACE_SLICES, _e62, 2i);
    return vec3<f32>(_e46, _e53, _e64);
}

fn interfaceSnell(cosTheta_37: f32, eta_56: f32) -> f32 {
    var cosTheta_38: f32;
    var eta_57: f32;
    var c_26: f32;

    cosTheta_38 = cosTheta_37;
    eta_57 = eta_56;
    let _e35 = cosTheta_38;
    c_26 = clamp(_e35, 0f, 1f);
    let _e41 = c_26;
    let _e44 = c_26;
    let _e48 = c_26;
    let _e49 = eta_57;
    let _e50 = fresnelG(_e48, _e49);
    return atan2(sqrt(((1f - _e41) * (1f + _e44))), _e50);
}

fn interfaceWidth(cosTheta_39: f32, alpha_84: f32, eta_58: f32) -> f32 {
    var cosTheta_40: f32;
    var alpha_85: f32;
    var eta_59: f32;
    var g_9: f32;
    var critical_2: f32;
    var across_9: f32;
    var cosT: f32;
    var lean_2: f32;
    var width_3: f32;

    cosTheta_40 = cosTheta_39;
    alpha_85 = alpha_84;
    eta_59 = eta_58;
    let _e37 = cosTheta_40;
    let _e41 = eta_59;
    let _e42 = fresnelG(clamp(_e37, 0f, 1f), _e41);
    g_9 = _e42;
    let _e45 = eta_59;
    let _e48 = eta_59;
    critical_2 = sqrt(max(((1f - _e45) * (1f + _e48)), 0f));
    let _e55 = eta_59;
    let _e58 = eta_59;
    let _e63 = eta_59;
    let _e64 = g_9;
    let _e65 = cosTheta_40;
    let _e66 = critical_2;
    across_9 = (abs(((_e55 - 1f) * (_e58 + 1f))) / max((_e63 * (_e64 + max(_e65, _e66))), 0.000000000000000000000000000001f));
    let _e74 = g_9;
    let _e75 = eta_59;
    cosT = (_e74 / _e75);
    let _e78 = alpha_85;
    let _e79 = critical_2;
    let _e80 = cosTheta_40;
    lean_2 = (_e78 + max((_e79 - _e80), 0f));
    let _e86 = lean_2;
    let _e87 = across_9;
    let _e89 = cosT;
    let _e90 = cosT;
    let _e92 = lean_2;
    width_3 = ((_e86 * _e87) * inverseSqrt(sqrt(((_e89 * _e90) + max(_e92, 0.000000000001f)))));
    let _e100 = width_3;
    let _e103 = width_3;
    return (_e100 / (1f + (2f * _e103)));
}

fn interfaceEnergy(texel_5: vec4<f32>) -> InterfaceEnergy {
    var texel_6: vec4<f32>;
    var e_7: InterfaceEnergy;

    texel_6 = texel_5;
    let _e35 = texel_6;
    e_7.transmitted = _e35.x;
    let _e38 = texel_6;
    e_7.reflected = _e38.y;
    let _e40 = e_7;
    return _e40;
}

fn interfaceTap(texel_7: vec4<f32>, cosTheta_41: f32, alpha_86: f32, eta_60: f32) -> InterfaceTap {
    var texel_8: vec4<f32>;
    var cosTheta_42: f32;
    var alpha_87: f32;
    var eta_61: f32;
    var width_4: f32;
    var tap_6: InterfaceTap;

    texel_8 = texel_7;
    cosTheta_42 = cosTheta_41;
    alpha_87 = alpha_86;
    eta_61 = eta_60;
    let _e39 = cosTheta_42;
    let _e40 = alpha_87;
    let _e44 = eta_61;
    let _e45 = interfaceWidth(_e39, clamp(_e40, 0f, 1f), _e44);
    width_4 = _e45;
    let _e49 = cosTheta_42;
    let _e50 = eta_61;
    let _e51 = interfaceSnell(_e49, _e50);
    let _e52 = texel_8;
    let _e54 = width_4;
    tap_6.angle = (_e51 + (_e52.x * _e54));
    let _e58 = texel_8;
    let _e60 = width_4;
    tap_6.sigma = (_e58.y * _e60);
    let _e63 = texel_8;
    tap_6.weight = _e63.z;
    let _e65 = tap_6;
    return _e65;
}

fn interfaceTapDirection(wo_50: vec3<f32>, n_41: vec3<f32>, angle_2: f32) -> vec3<f32> {
    var wo_51: vec3<f32>;
    var n_42: vec3<f32>;
    var angle_3: f32;
    var across_10: vec3<f32>;
    var local_94: vec3<f32>;

    wo_51 = wo_50;
    n_42 = n_41;
    angle_3 = angle_2;
    let _e37 = wo_51;
    let _e38 = n_42;
    let _e40 = n_42;
    let _e42 = wo_51;
    across_10 = ((dot(_e37, _e38) * _e40) - _e42);
    let _e45 = across_10;
    let _e46 = across_10;
    if !((dot(_e45, _e46) > 0.000000000001f)) {
        let _e51 = n_42;
        let _e52 = n_42;
        if (abs(_e52.x) < 0.7f) {
            local_94 = vec3<f32>(1f, 0f, 0f);
        } else {
            local_94 = vec3<f32>(0f, 1f, 0f);
        }
        let _e66 = local_94;
        across_10 = cross(_e51, _e66);
    }
    let _e68 = angle_3;
    let _e70 = across_10;
    let _e73 = angle_3;
    let _e75 = n_42;
    return ((sin(_e68) * normalize(_e70)) - (cos(_e73) * _e75));
}

fn pyramidVariance(level_1: f32) -> f32 {
    var level_2: f32;
    var scale_5: f32;

    level_2 = level_1;
    let _e34 = level_2;
    scale_5 = exp2((2f * _e34));
    let _e39 = scale_5;
    let _e43 = scale_5;
    return ((0.25f * (_e39 - 1f)) + (_e43 / 6f));
}

fn pyramidLevel(variance_3: f32, lastLevel: f32) -> f32 {
    var variance_4: f32;
    var lastLevel_1: f32;
    var scale_6: f32;
    var exact: f32;
    var below_4: f32;
    var low_7: f32;
    var high_2: f32;

    variance_4 = variance_3;
    lastLevel_1 = lastLevel;
    let _e35 = variance_4;
    scale_6 = ((_e35 + 0.25f) / 0.4166667f);
    let _e46 = scale_6;
    exact = (0.5f * log2(max(_e46, 1f)));
    let _e52 = exact;
    let _e54 = lastLevel_1;
    below_4 = min(floor(_e52), _e54);
    let _e57 = below_4;
    let _e58 = pyramidVariance(_e57);
    low_7 = _e58;
    let _e60 = below_4;
    let _e63 = pyramidVariance((_e60 + 1f));
    high_2 = _e63;
    let _e65 = below_4;
    let _e66 = variance_4;
    let _e67 = low_7;
    let _e69 = high_2;
    let _e70 = low_7;
    let _e77 = lastLevel_1;
    return min((_e65 + clamp(((_e66 - _e67) / (_e69 - _e70)), 0f, 1f)), _e77);
}

fn normalIntegral(x_25: f32) -> f32 {
    var x_26: f32;

    x_26 = x_25;
    let _e37 = x_26;
    return (1f / (1f + exp((-1.702f * _e37))));
}

fn pyramidCoverage(at_24: vec2<f32>, size_22: vec2<f32>, sigma_8: f32) -> f32 {
    var at_25: vec2<f32>;
    var size_23: vec2<f32>;
    var sigma_9: f32;
    var inverse: f32;
    var x_27: f32;
    var y_9: f32;

    at_25 = at_24;
    size_23 = size_22;
    sigma_9 = sigma_8;
    let _e38 = sigma_9;
    inverse = (1f / max(_e38, 0.25f));
    let _e43 = size_23;
    let _e45 = at_25;
    let _e48 = inverse;
    let _e50 = normalIntegral(((_e43.x - _e45.x) * _e48));
    let _e51 = at_25;
    let _e54 = inverse;
    let _e56 = normalIntegral((-(_e51.x) * _e54));
    x_27 = (_e50 - _e56);
    let _e59 = size_23;
    let _e61 = at_25;
    let _e64 = inverse;
    let _e66 = normalIntegral(((_e59.y - _e61.y) * _e64));
    let _e67 = at_25;
    let _e70 = inverse;
    let _e72 = normalIntegral((-(_e67.y) * _e70));
    y_9 = (_e66 - _e72);
    let _e75 = x_27;
    let _e76 = y_9;
    return clamp((_e75 * _e76), 0f, 1f);
}

fn beamVariance(sigma_10: f32, carried_2: f32, inner_6: f32, inside_3: f32, outside: f32) -> f32 {
    var sigma_11: f32;
    var carried_3: f32;
    var inner_7: f32;
    var inside_4: f32;
    var outside_1: f32;
    var offset: f32;
    var angle_4: f32;

    sigma_11 = sigma_10;
    carried_3 = carried_2;
    inner_7 = inner_6;
    inside_4 = inside_3;
    outside_1 = outside;
    let _e41 = inside_4;
    let _e42 = inner_7;
    offset = (_e41 * _e42);
    let _e45 = outside_1;
    let _e46 = sigma_11;
    angle_4 = (_e45 * _e46);
    let _e49 = angle_4;
    let _e50 = angle_4;
    let _e53 = offset;
    let _e55 = outside_1;
    let _e57 = carried_3;
    let _e58 = sigma_11;
    let _e62 = offset;
    let _e63 = offset;
    return (((_e49 * _e50) + (((2f * _e53) * _e55) * min(_e57, _e58))) + (_e62 * _e63));
}

fn pixelsPerRadian(focal: f32, cosine: f32) -> f32 {
    var focal_1: f32;
    var cosine_1: f32;

    focal_1 = focal;
    cosine_1 = cosine;
    let _e35 = focal_1;
    let _e36 = cosine_1;
    let _e37 = cosine_1;
    return (_e35 / (_e36 * sqrt(_e37)));
}

fn lobeRadiance(tap_7: ComposedTap, origin_16: vec3<f32>, inside_5: f32, met_4: SceneMeeting, view_31: SceneView) -> vec3<f32> {
    var tap_8: ComposedTap;
    var origin_17: vec3<f32>;
    var inside_6: f32;
    var met_5: SceneMeeting;
    var view_32: SceneView;
    var ends: bool;
    var local_95: vec3<f32>;
    var place: vec3<f32>;
    var local_96: f32;
    var clip_4: vec4<f32>;
    var share_4: f32 = 0f;
    var near_1: vec3<f32> = vec3(0f);
    var local_97: vec3<f32>;
    var fromEye: vec3<f32>;
    var range_1: f32;
    var metres: f32;
    var local_98: f32;
    var pixels: f32;
    var at_26: vec2<f32>;
    var outside_2: vec2<f32>;
    var far_1: f32;
    var local_99: f32;
    var shown: vec4<f32>;
    var local_100: vec3<f32>;
    var local_101: vec3<f32>;

    tap_8 = tap_7;
    origin_17 = origin_16;
    inside_6 = inside_5;
    met_5 = met_4;
    view_32 = view_31;
    let _e41 = met_5;
    ends = (_e41.metres >= 0f);
    let _e46 = ends;
    if _e46 {
        let _e47 = origin_17;
        let _e48 = met_5;
        let _e50 = tap_8;
        local_95 = (_e47 + (_e48.metres * _e50.direction));
    } else {
        let _e54 = tap_8;
        local_95 = _e54.direction;
    }
    let _e57 = local_95;
    place = _e57;
    let _e59 = view_32;
    let _e61 = place;
    let _e62 = ends;
    if _e62 {
        local_96 = 1f;
    } else {
        local_96 = 0f;
    }
    let _e66 = local_96;
    clip_4 = (_e59.clipFromWorld * vec4<f32>(_e61.x, _e61.y, _e61.z, _e66));
    let _e78 = met_5;
    let _e80 = clip_4;
    if (_e78.seen && (_e80.w > 0f)) {
        {
            let _e85 = ends;
            if _e85 {
                let _e86 = place;
                let _e87 = view_32;
                local_97 = (_e86 - _e87.eye);
            } else {
                let _e90 = tap_8;
                local_97 = _e90.direction;
            }
            let _e93 = local_97;
            fromEye = _e93;
            let _e95 = fromEye;
            range_1 = length(_e95);
            let _e98 = tap_8;
            let _e100 = tap_8;
            let _e102 = tap_8;
            let _e104 = inside_6;
            let _e105 = met_5;
            let _e107 = beamVariance(_e98.sigma, _e100.carried, _e102.inner, _e104, _e105.metres);
            metres = sqrt(_e107);
            let _e110 = ends;
            if _e110 {
                let _e111 = metres;
                let _e112 = range_1;
                local_98 = (_e111 / _e112);
            } else {
                let _e114 = tap_8;
                local_98 = _e114.sigma;
            }
            let _e117 = local_98;
            let _e118 = view_32;
            let _e120 = clip_4;
            let _e122 = range_1;
            let _e126 = pixelsPerRadian(_e118.focal, min((_e120.w / _e122), 1f));
            pixels = (_e117 * _e126);
            let _e129 = clip_4;
            let _e130 = view_32;
            let _e132 = scenePixel(_e129, _e130.size);
            at_26 = _e132;
            let _e134 = at_26;
            let _e136 = at_26;
            let _e137 = view_32;
            outside_2 = max(max(-(_e134), (_e136 - _e137.size)), vec2(0f));
            let _e145 = outside_2;
            let _e146 = outside_2;
            far_1 = dot(_e145, _e146);
            let _e149 = ends;
            if _e149 {
                let _e152 = far_1;
                let _e154 = view_32;
                let _e157 = view_32;
                local_99 = exp(((-0.5f * _e152) / (_e154.size.y * _e157.size.y)));
            } else {
                let _e163 = at_26;
                let _e164 = view_32;
                let _e166 = pixels;
                let _e167 = pyramidCoverage(_e163, _e164.size, _e166);
                local_99 = _e167;
            }
            let _e169 = local_99;
            share_4 = _e169;
            let _e170 = share_4;
            if (_e170 > 0f) {
                {
                    let _e173 = at_26;
                    let _e174 = pixels;
                    let _e175 = pixels;
                    let _e177 = far_1;
                    let _e179 = engineSceneColor(_e173, ((_e174 * _e175) + _e177));
                    shown = _e179;
                    let _e181 = share_4;
                    let _e183 = shown;
                    share_4 = (_e181 * min((2f * _e183.w), 1f));
                    let _e189 = shown;
                    if (_e189.w > 0f) {
                        let _e193 = shown;
                        let _e195 = shown;
                        let _e197 = shown;
                        let _e200 = shown;
                        local_100 = (vec3<f32>(_e193.x, _e195.y, _e197.z) / vec3(_e200.w));
                    } else {
                        local_100 = vec3(0f);
                    }
                    let _e207 = local_100;
                    near_1 = _e207;
                }
            }
        }
    }
    let _e208 = share_4;
    if (_e208 >= 0.999f) {
        let _e211 = near_1;
        local_101 = _e211;
    } else {
        let _e212 = tap_8;
        let _e214 = tap_8;
        let _e216 = engineEnvironment(_e212.direction, _e214.sigma);
        let _e217 = near_1;
        let _e218 = share_4;
        local_101 = mix(_e216, _e217, vec3(_e218));
    }
    let _e222 = local_101;
    return _e222;
}

fn engineFaceEnergy(cosTheta_43: f32, alpha_88: f32, eta_62: f32) -> InterfaceEnergy {
    var cosTheta_44: f32;
    var alpha_89: f32;
    var eta_63: f32;

    cosTheta_44 = cosTheta_43;
    alpha_89 = alpha_88;
    eta_63 = eta_62;
    let _e37 = cosTheta_44;
    let _e38 = alpha_89;
    let _e39 = eta_63;
    let _e40 = interfaceEnergyCoordinate(_e37, _e38, _e39);
    let _e41 = engineInterfaceEnergy(_e40);
    let _e42 = interfaceEnergy(_e41);
    return _e42;
}

fn reflectGlass(face_10: GlassFace, ior: f32, view_33: SceneView) -> vec3<f32> {
    var face_11: GlassFace;
    var ior_1: f32;
    var view_34: SceneView;
    var cosTheta_45: f32;
    var energy_3: f32;
    var texel_9: vec4<f32>;
    var tap_9: ComposedTap;
    var met_6: SceneMeeting;

    face_11 = face_10;
    ior_1 = ior;
    view_34 = view_33;
    let _e37 = face_11;
    let _e39 = face_11;
    cosTheta_45 = dot(_e37.wo, _e39.n);
    let _e43 = cosTheta_45;
    let _e44 = face_11;
    let _e46 = ior_1;
    let _e47 = engineFaceEnergy(_e43, _e44.alpha, _e46);
    energy_3 = _e47.reflected;
    let _e50 = cosTheta_45;
    let _e51 = face_11;
    let _e53 = ior_1;
    let _e54 = fresnelNormalIncidence(_e53);
    let _e55 = energy_3;
    let _e56 = edgeShare(_e54, _e55);
    let _e57 = lobeCoordinate(_e50, _e51.alpha, _e56);
    let _e58 = engineReflectionLobe(_e57);
    texel_9 = _e58;
    let _e63 = cosTheta_45;
    let _e65 = face_11;
    let _e68 = face_11;
    let _e71 = face_11;
    let _e73 = texel_9;
    let _e75 = lobeDirection((((2f * _e63) * _e65.n) - _e68.wo), _e71.n, _e73.x);
    tap_9.direction = _e75;
    let _e77 = texel_9;
    let _e79 = texel_9;
    let _e82 = face_11;
    let _e85 = face_11;
    let _e89 = face_11;
    tap_9.sigma = sqrt(((((_e77.y * _e79.y) * _e82.alpha) * _e85.alpha) + (4f * _e89.turn)));
    let _e95 = energy_3;
    tap_9.weight = _e95;
    tap_9.inner = 0f;
    tap_9.carried = 0f;
    let _e100 = face_11;
    let _e102 = tap_9;
    let _e104 = view_34;
    let _e105 = sceneMeeting(_e100.position, _e102.direction, _e104);
    met_6 = _e105;
    let _e107 = energy_3;
    let _e108 = tap_9;
    let _e109 = face_11;
    let _e112 = met_6;
    let _e113 = view_34;
    let _e114 = lobeRadiance(_e108, _e109.position, 0f, _e112, _e113);
    return (_e107 * _e114);
}

fn wanderingLossGgx() -> WanderingLoss {
    var k_22: WanderingLoss;

    k_22.linear = 0.635f;
    k_22.constant = 0.254f;
    k_22.thin = 1.078f;
    k_22.passes = 0.3f;
    let _e40 = k_22;
    return _e40;
}

fn wanderingLossBeckmann() -> WanderingLoss {
    var k_23: WanderingLoss;

    k_23.linear = 0.201f;
    k_23.constant = 1.555f;
    k_23.thin = 0.565f;
    k_23.passes = 0f;
    let _e40 = k_23;
    return _e40;
}

fn wanderingPasses(ior_2: f32) -> f32 {
    var ior_3: f32;
    var eta_64: f32;
    var passes: f32;
    var local_102: f32;

    ior_3 = ior_2;
    let _e33 = ior_3;
    let _e35 = ior_3;
    eta_64 = max(_e33, (1f / _e35));
    let _e41 = eta_64;
    let _e42 = fresnelTransmittedAt(0.355051f, _e41);
    let _e46 = eta_64;
    let _e47 = fresnelTransmittedAt(0.844949f, _e46);
    passes = ((0.363917f * _e42) + (0.636083f * _e47));
    let _e51 = ior_3;
    if (_e51 > 1f) {
        let _e54 = passes;
        let _e55 = ior_3;
        let _e56 = ior_3;
        local_102 = (_e54 / (_e55 * _e56));
    } else {
        let _e59 = passes;
        local_102 = _e59;
    }
    let _e61 = local_102;
    return _e61;
}

fn wanderingAt(alpha_90: f32, ior_4: f32, k_24: WanderingLoss) -> Wandering {
    var alpha_91: f32;
    var ior_5: f32;
    var k_25: WanderingLoss;
    var smoothly: f32;
    var alpha2_1: f32;
    var lost_2: f32;
    var w_33: Wandering;

    alpha_91 = alpha_90;
    ior_5 = ior_4;
    k_25 = k_24;
    let _e37 = ior_5;
    let _e38 = wanderingPasses(_e37);
    smoothly = _e38;
    let _e40 = alpha_91;
    let _e41 = alpha_91;
    alpha2_1 = (_e40 * _e41);
    let _e44 = alpha2_1;
    let _e45 = alpha2_1;
    let _e46 = k_25;
    let _e48 = alpha_91;
    let _e51 = k_25;
    let _e56 = k_25;
    let _e58 = alpha_91;
    let _e60 = smoothly;
    lost_2 = ((_e44 / ((_e45 + (_e46.linear * _e48)) + _e51.constant)) * max((1f - ((_e56.thin * _e58) * max((_e60 - 0.4f), 0f))), 0f));
    let _e73 = smoothly;
    let _e75 = k_25;
    let _e77 = alpha2_1;
    w_33.passes = (_e73 * (1f - (_e75.passes * _e77)));
    let _e83 = w_33;
    let _e86 = lost_2;
    w_33.back = max(((1f - _e83.passes) - _e86), 0f);
    let _e90 = w_33;
    return _e90;
}

fn wanderingConcave(w_34: Wandering, again: f32) -> Wandering {
    var w_35: Wandering;
    var again_1: f32;
    var concave: Wandering;

    w_35 = w_34;
    again_1 = again;
    let _e38 = again_1;
    let _e40 = w_35;
    concave.passes = ((1f - _e38) * _e40.passes);
    let _e44 = w_35;
    let _e46 = again_1;
    let _e47 = w_35;
    concave.back = (_e44.back + (_e46 * _e47.passes));
    let _e51 = concave;
    return _e51;
}

fn wanderingEscapes(w_36: Wandering, way_7: vec3<f32>) -> vec3<f32> {
    var w_37: Wandering;
    var way_8: vec3<f32>;

    w_37 = w_36;
    way_8 = way_7;
    let _e35 = w_37;
    let _e37 = way_8;
    let _e41 = w_37;
    let _e43 = way_8;
    let _e46 = w_37;
    return ((_e35.passes * _e37) / max((vec3(1f) - (_e41.back * _e43)), vec3(_e46.passes)));
}

fn engineFaceTap(tap_10: i32, cosTheta_46: f32, alpha_92: f32, eta_65: f32) -> InterfaceTap {
    var tap_11: i32;
    var cosTheta_47: f32;
    var alpha_93: f32;
    var eta_66: f32;

    tap_11 = tap_10;
    cosTheta_47 = cosTheta_46;
    alpha_93 = alpha_92;
    eta_66 = eta_65;
    let _e39 = tap_11;
    let _e41 = cosTheta_47;
    let _e42 = alpha_93;
    let _e43 = eta_66;
    let _e44 = interfaceLobeCoordinate(_e39, 2i, _e41, _e42, _e43);
    let _e45 = engineInterfaceLobe(_e44);
    let _e46 = cosTheta_47;
    let _e47 = alpha_93;
    let _e48 = eta_66;
    let _e49 = interfaceTap(_e45, _e46, _e47, _e48);
    return _e49;
}

fn engineEnteringTap(tap_12: i32, face_12: GlassFace, ior_6: f32, energy_4: f32) -> InnerTap {
    var tap_13: i32;
    var face_13: GlassFace;
    var ior_7: f32;
    var energy_5: f32;
    var read_: InterfaceTap;
    var inner_8: InnerTap;
    var matched: bool;
    var local_103: vec3<f32>;
    var local_104: f32;
    var local_105: f32;

    tap_13 = tap_12;
    face_13 = face_12;
    ior_7 = ior_6;
    energy_5 = energy_4;
    let _e39 = tap_13;
    let _e40 = face_13;
    let _e42 = face_13;
    let _e45 = face_13;
    let _e47 = ior_7;
    let _e48 = engineFaceTap(_e39, dot(_e40.wo, _e42.n), _e45.alpha, _e47);
    read_ = _e48;
    let _e51 = ior_7;
    matched = (abs((_e51 - 1f)) < INDEX_MATCHED);
    let _e58 = matched;
    if _e58 {
        let _e59 = face_13;
        local_103 = -(_e59.wo);
    } else {
        let _e62 = face_13;
        let _e64 = face_13;
        let _e66 = read_;
        let _e68 = interfaceTapDirection(_e62.wo, _e64.n, _e66.angle);
        local_103 = _e68;
    }
    let _e70 = local_103;
    inner_8.direction = _e70;
    let _e72 = matched;
    if _e72 {
        local_104 = 0f;
    } else {
        let _e74 = read_;
        local_104 = _e74.sigma;
    }
    let _e77 = local_104;
    inner_8.sigma = _e77;
    let _e79 = read_;
    let _e81 = matched;
    if _e81 {
        local_105 = 1f;
    } else {
        let _e83 = energy_5;
        local_105 = _e83;
    }
    let _e85 = local_105;
    inner_8.weight = (_e79.weight * _e85);
    let _e87 = inner_8;
    return _e87;
}

fn engineLeavingPair(inner_9: InnerTap, core_6: bool, s_12: ExitSurface, k_26: Widening) -> ComposedPair {
    var inner_10: InnerTap;
    var core_7: bool;
    var s_13: ExitSurface;
    var k_27: Widening;
    var view_35: ExitView;
    var cosTheta_48: f32;
    var local_106: f32;
    var energy_6: f32;
    var first_5: InterfaceTap;
    var second: InterfaceTap;

    inner_10 = inner_9;
    core_7 = core_6;
    s_13 = s_12;
    k_27 = k_26;
    let _e39 = inner_10;
    let _e40 = core_7;
    let _e41 = s_13;
    let _e42 = k_27;
    let _e43 = seeExit(_e39, _e40, _e41, _e42);
    view_35 = _e43;
    let _e45 = view_35;
    cosTheta_48 = max(_e45.cosTheta, 0f);
    let _e50 = s_13;
    if (abs((_e50.eta - 1f)) < INDEX_MATCHED) {
        local_106 = 1f;
    } else {
        let _e57 = cosTheta_48;
        let _e58 = view_35;
        let _e60 = s_13;
        let _e62 = engineFaceEnergy(_e57, _e58.alphaEnergy, _e60.eta);
        local_106 = _e62.transmitted;
    }
    let _e65 = local_106;
    energy_6 = _e65;
    let _e68 = cosTheta_48;
    let _e69 = view_35;
    let _e71 = s_13;
    let _e73 = engineFaceTap(0i, _e68, _e69.alphaShape, _e71.eta);
    first_5 = _e73;
    let _e76 = cosTheta_48;
    let _e77 = view_35;
    let _e79 = s_13;
    let _e81 = engineFaceTap(1i, _e76, _e77.alphaShape, _e79.eta);
    second = _e81;
    let _e83 = inner_10;
    let _e84 = view_35;
    let _e85 = s_13;
    let _e86 = first_5;
    let _e88 = first_5;
    let _e90 = first_5;
    let _e92 = energy_6;
    let _e93 = composeTap(_e83, _e84, _e85, _e86.angle, _e88.sigma, _e90.weight, _e92);
    let _e94 = inner_10;
    let _e95 = view_35;
    let _e96 = s_13;
    let _e97 = second;
    let _e99 = second;
    let _e101 = second;
    let _e103 = energy_6;
    let _e104 = composeTap(_e94, _e95, _e96, _e97.angle, _e99.sigma, _e101.weight, _e103);
    let _e105 = view_35;
    let _e106 = composedPair(_e93, _e104, _e105);
    return _e106;
}

fn internallyReflected(face_14: GlassFace, body_2: ConvexBody, inner_11: InnerTap, entered: f32, e_8: ConvexExit, passed: f32) -> vec3<f32> {
    var face_15: GlassFace;
    var body_3: ConvexBody;
    var inner_12: InnerTap;
    var entered_1: f32;
    var e_9: ConvexExit;
    var passed_1: f32;
    var cosTheta_49: f32;
    var own_2: InterfaceEnergy;
    var w_38: Wandering;
    var reflected: vec3<f32>;
    var q_1: f32;
    var near_2: vec3<f32>;
    var outward_3: vec3<f32>;
    var spread_5: f32;
    var way_9: vec3<f32>;
    var local_107: vec3<f32>;
    var direction_20: vec3<f32>;

    face_15 = face_14;
    body_3 = body_2;
    inner_12 = inner_11;
    entered_1 = entered;
    e_9 = e_8;
    passed_1 = passed;
    let _e43 = inner_12;
    let _e45 = e_9;
    cosTheta_49 = max(dot(_e43.direction, _e45.surface.n), 0f);
    let _e52 = cosTheta_49;
    let _e53 = body_3;
    let _e55 = e_9;
    let _e58 = engineFaceEnergy(_e52, _e53.backAlpha, _e55.surface.eta);
    own_2 = _e58;
    let _e62 = passed_1;
    w_38.passes = _e62;
    let _e64 = own_2;
    let _e66 = own_2;
    let _e69 = passed_1;
    w_38.back = clamp(((_e64.transmitted + _e66.reflected) - _e69), 0f, 0.99f);
    let _e74 = inner_12;
    let _e77 = cosTheta_49;
    let _e79 = e_9;
    reflected = (_e74.direction - ((2f * _e77) * _e79.surface.n));
    let _e85 = body_3;
    let _e87 = body_3;
    q_1 = clamp((_e85.thickness * _e87.curvature), 0f, 2f);
    let _e94 = face_15;
    let _e96 = e_9;
    let _e100 = cosTheta_49;
    let _e102 = reflected;
    let _e106 = q_1;
    near_2 = normalize(mix(_e94.n, (_e96.surface.n + ((2f * _e100) * _e102)), vec3((0.5f * _e106))));
    let _e112 = reflected;
    let _e114 = near_2;
    let _e116 = e_9;
    let _e119 = refractAbout(-(_e112), -(_e114), _e116.surface.eta);
    outward_3 = _e119;
    let _e121 = inner_12;
    let _e123 = inner_12;
    let _e127 = body_3;
    let _e130 = body_3;
    let _e135 = body_3;
    spread_5 = (sqrt(((_e121.sigma * _e123.sigma) + ((4f * _e127.backAlpha) * _e130.backAlpha))) * _e135.ior);
    let _e139 = e_9;
    let _e142 = body_3;
    way_9 = exp((-(_e139.path) * _e142.attenuation));
    let _e147 = outward_3;
    let _e148 = outward_3;
    if (dot(_e147, _e148) > 0f) {
        let _e152 = outward_3;
        local_107 = _e152;
    } else {
        let _e153 = near_2;
        local_107 = _e153;
    }
    let _e155 = local_107;
    direction_20 = _e155;
    let _e157 = entered_1;
    let _e158 = w_38;
    let _e161 = way_9;
    let _e163 = w_38;
    let _e164 = way_9;
    let _e165 = wanderingEscapes(_e163, _e164);
    let _e167 = direction_20;
    let _e168 = spread_5;
    let _e171 = engineEnvironment(_e167, min(_e168, 0.606f));
    return ((((_e157 * _e158.back) * _e161) * _e165) * _e171);
}

fn enterGlass(face_16: GlassFace, ior_8: f32) -> Entering {
    var face_17: GlassFace;
    var ior_9: f32;
    var e_10: Entering;

    face_17 = face_16;
    ior_9 = ior_8;
    let _e37 = face_17;
    let _e39 = face_17;
    let _e42 = face_17;
    let _e44 = ior_9;
    let _e45 = engineFaceEnergy(dot(_e37.wo, _e39.n), _e42.alpha, _e44);
    e_10.energy = _e45.transmitted;
    let _e49 = face_17;
    let _e50 = ior_9;
    let _e51 = e_10;
    let _e53 = engineEnteringTap(0i, _e49, _e50, _e51.energy);
    e_10.core = _e53;
    let _e56 = face_17;
    let _e57 = ior_9;
    let _e58 = e_10;
    let _e60 = engineEnteringTap(1i, _e56, _e57, _e58.energy);
    e_10.tail = _e60;
    let _e61 = e_10;
    return _e61;
}

fn refractThrough(face_18: GlassFace, body_4: ConvexBody, e_11: Entering, origin_18: vec3<f32>, coreExit: ConvexExit, tailExit: ConvexExit, view_36: SceneView, k_28: Widening) -> vec3<f32> {
    var face_19: GlassFace;
    var body_5: ConvexBody;
    var e_12: Entering;
    var origin_19: vec3<f32>;
    var coreExit_1: ConvexExit;
    var tailExit_1: ConvexExit;
    var view_37: SceneView;
    var k_29: Widening;
    var first_6: ComposedPair;
    var pair_3: ComposedPair;
    var bent: f32;
    var met_7: SceneMeeting;
    var sum_12: vec3<f32>;
    var local_108: f32;
    var passed_2: f32;

    face_19 = face_18;
    body_5 = body_4;
    e_12 = e_11;
    origin_19 = origin_18;
    coreExit_1 = coreExit;
    tailExit_1 = tailExit;
    view_37 = view_36;
    k_29 = k_28;
    let _e47 = e_12;
    let _e50 = coreExit_1;
    let _e52 = k_29;
    let _e53 = engineLeavingPair(_e47.core, true, _e50.surface, _e52);
    first_6 = _e53;
    let _e55 = first_6;
    let _e56 = e_12;
    let _e59 = tailExit_1;
    let _e61 = k_29;
    let _e62 = engineLeavingPair(_e56.tail, false, _e59.surface, _e61);
    let _e63 = mergePairs(_e55, _e62);
    pair_3 = _e63;
    let _e68 = body_5;
    bent = (2f * (1f - (1f / _e68.ior)));
    let _e76 = pair_3;
    let _e79 = pair_3;
    let _e83 = bent;
    let _e84 = bent;
    let _e86 = face_19;
    pair_3.core.sigma = sqrt(((_e76.core.sigma * _e79.core.sigma) + ((_e83 * _e84) * _e86.turn)));
    let _e91 = origin_19;
    let _e92 = pair_3;
    let _e95 = view_37;
    let _e96 = sceneMeeting(_e91, _e92.core.direction, _e95);
    met_7 = _e96;
    let _e98 = pair_3;
    let _e101 = pair_3;
    let _e103 = origin_19;
    let _e104 = coreExit_1;
    let _e106 = met_7;
    let _e107 = view_37;
    let _e108 = lobeRadiance(_e101.core, _e103, _e104.path, _e106, _e107);
    sum_12 = (_e98.core.weight * _e108);
    let _e111 = pair_3;
    if (_e111.rest.weight > 0f) {
        let _e116 = sum_12;
        let _e117 = pair_3;
        let _e120 = pair_3;
        let _e122 = origin_19;
        let _e123 = coreExit_1;
        let _e125 = met_7;
        let _e126 = view_37;
        let _e127 = lobeRadiance(_e120.rest, _e122, _e123.path, _e125, _e126);
        sum_12 = (_e116 + (_e117.rest.weight * _e127));
    }
    let _e130 = e_12;
    if (_e130.core.weight > 0f) {
        let _e135 = first_6;
        let _e138 = first_6;
        let _e142 = e_12;
        local_108 = ((_e135.core.weight + _e138.rest.weight) / _e142.core.weight);
    } else {
        local_108 = 0f;
    }
    let _e148 = local_108;
    passed_2 = _e148;
    let _e150 = sum_12;
    let _e151 = coreExit_1;
    let _e154 = body_5;
    let _e159 = face_19;
    let _e160 = body_5;
    let _e161 = e_12;
    let _e163 = e_12;
    let _e165 = coreExit_1;
    let _e166 = passed_2;
    let _e167 = internallyReflected(_e159, _e160, _e161.core, _e163.energy, _e165, _e166);
    return ((_e150 * exp((-(_e151.path) * _e154.attenuation))) + _e167);
}

fn refractConvex(face_20: GlassFace, body_6: ConvexBody, view_38: SceneView, k_30: Widening) -> vec3<f32> {
    var face_21: GlassFace;
    var body_7: ConvexBody;
    var view_39: SceneView;
    var k_31: Widening;
    var e_13: Entering;
    var core_8: ConvexExit;
    var origin_20: vec3<f32>;

    face_21 = face_20;
    body_7 = body_6;
    view_39 = view_38;
    k_31 = k_30;
    let _e39 = face_21;
    let _e40 = body_7;
    let _e42 = enterGlass(_e39, _e40.ior);
    e_13 = _e42;
    let _e44 = face_21;
    let _e46 = e_13;
    let _e49 = body_7;
    let _e50 = convexExit(_e44.n, _e46.core.direction, _e49);
    core_8 = _e50;
    let _e52 = face_21;
    let _e54 = core_8;
    let _e56 = e_13;
    origin_20 = (_e52.position + (_e54.path * _e56.core.direction));
    let _e62 = face_21;
    let _e63 = body_7;
    let _e64 = e_13;
    let _e65 = origin_20;
    let _e66 = core_8;
    let _e67 = face_21;
    let _e69 = e_13;
    let _e72 = body_7;
    let _e73 = convexExit(_e67.n, _e69.tail.direction, _e72);
    let _e74 = view_39;
    let _e75 = k_31;
    let _e76 = refractThrough(_e62, _e63, _e64, _e65, _e66, _e73, _e74, _e75);
    return _e76;
}

fn wayOut(face_22: GlassFace, tap_14: InnerTap, eta_67: f32, number_8: f32, view_40: SceneView) -> WayOut {
    var face_23: GlassFace;
    var tap_15: InnerTap;
    var eta_68: f32;
    var number_9: f32;
    var view_41: SceneView;
    var seen_2: BackFaceExit;
    var way_10: WayOut;
    var cosTheta_50: f32;
    var onward: vec3<f32>;
    var next_1: BackFaceExit;
    var alpha_94: f32;

    face_23 = face_22;
    tap_15 = tap_14;
    eta_68 = eta_67;
    number_9 = number_8;
    view_41 = view_40;
    let _e41 = face_23;
    let _e43 = tap_15;
    let _e46 = eta_68;
    let _e47 = number_9;
    let _e48 = view_41;
    let _e49 = backFaceExit(_e41.position, _e43.direction, 0f, _e46, _e47, _e48);
    seen_2 = _e49;
    let _e53 = tap_15;
    way_10.tap = _e53;
    let _e55 = seen_2;
    way_10.exit = _e55.exit;
    let _e58 = face_23;
    let _e60 = seen_2;
    let _e63 = tap_15;
    way_10.point = (_e58.position + (_e60.exit.path * _e63.direction));
    let _e68 = seen_2;
    way_10.found = _e68.found;
    let _e70 = tap_15;
    let _e72 = seen_2;
    cosTheta_50 = dot(_e70.direction, _e72.exit.surface.n);
    let _e78 = seen_2;
    let _e82 = cosTheta_50;
    let _e85 = cosTheta_50;
    let _e88 = eta_68;
    let _e89 = eta_68;
    if (!(_e78.found) || (((1f - _e82) * (1f + _e85)) < (_e88 * _e89))) {
        let _e93 = way_10;
        return _e93;
    }
    let _e94 = tap_15;
    let _e97 = cosTheta_50;
    let _e99 = seen_2;
    onward = (_e94.direction - ((2f * _e97) * _e99.exit.surface.n));
    let _e106 = way_10;
    let _e108 = onward;
    let _e110 = seen_2;
    let _e114 = eta_68;
    let _e115 = number_9;
    let _e116 = view_41;
    let _e117 = backFaceExit(_e106.point, _e108, (0.5f * _e110.exit.path), _e114, _e115, _e116);
    next_1 = _e117;
    let _e119 = next_1;
    if !(_e119.found) {
        let _e122 = way_10;
        return _e122;
    }
    let _e123 = seen_2;
    alpha_94 = _e123.exit.surface.alpha;
    let _e130 = onward;
    way_10.tap.direction = _e130;
    let _e133 = tap_15;
    let _e135 = tap_15;
    let _e139 = alpha_94;
    let _e141 = alpha_94;
    way_10.tap.sigma = sqrt(((_e133.sigma * _e135.sigma) + ((4f * _e139) * _e141)));
    let _e147 = tap_15;
    let _e149 = cosTheta_50;
    let _e150 = alpha_94;
    let _e151 = eta_68;
    let _e152 = engineFaceEnergy(_e149, _e150, _e151);
    way_10.tap.weight = (_e147.weight * _e152.reflected);
    let _e156 = next_1;
    way_10.exit = _e156.exit;
    let _e160 = seen_2;
    let _e163 = next_1;
    way_10.exit.path = (_e160.exit.path + _e163.exit.path);
    let _e168 = way_10;
    let _e170 = next_1;
    let _e173 = onward;
    way_10.point = (_e168.point + (_e170.exit.path * _e173));
    let _e176 = way_10;
    return _e176;
}

fn refractFrontBack(face_24: GlassFace, body_8: ConvexBody, number_10: f32, view_42: SceneView, k_32: Widening) -> vec3<f32> {
    var face_25: GlassFace;
    var body_9: ConvexBody;
    var number_11: f32;
    var view_43: SceneView;
    var k_33: Widening;
    var entered_2: Entering;
    var core_9: WayOut;
    var tail_5: WayOut;

    face_25 = face_24;
    body_9 = body_8;
    number_11 = number_10;
    view_43 = view_42;
    k_33 = k_32;
    let _e41 = face_25;
    let _e42 = body_9;
    let _e44 = enterGlass(_e41, _e42.ior);
    entered_2 = _e44;
    let _e46 = face_25;
    let _e47 = entered_2;
    let _e50 = body_9;
    let _e53 = number_11;
    let _e54 = view_43;
    let _e55 = wayOut(_e46, _e47.core, (1f / _e50.ior), _e53, _e54);
    core_9 = _e55;
    let _e57 = core_9;
    if !(_e57.found) {
        let _e60 = face_25;
        let _e61 = body_9;
        let _e62 = view_43;
        let _e63 = k_33;
        let _e64 = refractConvex(_e60, _e61, _e62, _e63);
        return _e64;
    }
    let _e65 = face_25;
    let _e66 = entered_2;
    let _e69 = body_9;
    let _e72 = number_11;
    let _e73 = view_43;
    let _e74 = wayOut(_e65, _e66.tail, (1f / _e69.ior), _e72, _e73);
    tail_5 = _e74;
    let _e77 = core_9;
    entered_2.core = _e77.tap;
    let _e79 = tail_5;
    if _e79.found {
        let _e82 = tail_5;
        entered_2.tail = _e82.tap;
    }
    let _e84 = tail_5;
    if !(_e84.found) {
        let _e88 = core_9;
        tail_5.exit = _e88.exit;
    }
    let _e90 = face_25;
    let _e91 = body_9;
    let _e92 = entered_2;
    let _e93 = core_9;
    let _e95 = core_9;
    let _e97 = tail_5;
    let _e99 = view_43;
    let _e100 = k_33;
    let _e101 = refractThrough(_e90, _e91, _e92, _e93.point, _e95.exit, _e97.exit, _e99, _e100);
    return _e101;
}

fn thinWallCoordinate(tap_16: i32, taps_8: i32, cosTheta_51: f32, alpha_95: f32, eta_69: f32) -> vec3<f32> {
    var tap_17: i32;
    var taps_9: i32;
    var cosTheta_52: f32;
    var alpha_96: f32;
    var eta_70: f32;

    tap_17 = tap_16;
    taps_9 = taps_8;
    cosTheta_52 = cosTheta_51;
    alpha_96 = alpha_95;
    eta_70 = eta_69;
    let _e44 = cosTheta_52;
    let _e48 = tableCoordinate(sqrt(max(_e44, 0f)), THIN_WALL_COSINES);
    let _e49 = alpha_96;
    let _e53 = tap_17;
    let _e54 = taps_9;
    let _e55 = blockCoordinate(sqrt(max(_e49, 0f)), THIN_WALL_ALPHAS, _e53, _e54);
    let _e56 = eta_70;
    let _e57 = interfaceEtaAxis(_e56);
    let _e58 = tableCoordinate(_e57, THIN_WALL_SLICES);
    return vec3<f32>(_e48, _e55, _e58);
}

fn thinWallWidth(cosTheta_53: f32, alpha_97: f32, eta_71: f32) -> f32 {
    var cosTheta_54: f32;
    var alpha_98: f32;
    var eta_72: f32;
    var c_27: f32;
    var local_109: f32;
    var n_43: f32;
    var across_11: f32;
    var width_5: f32;

    cosTheta_54 = cosTheta_53;
    alpha_98 = alpha_97;
    eta_72 = eta_71;
    let _e40 = cosTheta_54;
    c_27 = clamp(_e40, 0f, 1f);
    let _e45 = eta_72;
    if (_e45 < 1f) {
        let _e49 = eta_72;
        local_109 = (1f / max(_e49, 0.01f));
    } else {
        let _e53 = eta_72;
        local_109 = _e53;
    }
    let _e55 = local_109;
    n_43 = _e55;
    let _e57 = n_43;
    let _e60 = n_43;
    let _e64 = c_27;
    let _e65 = n_43;
    let _e66 = fresnelG(_e64, _e65);
    let _e67 = c_27;
    across_11 = (((_e57 - 1f) * (_e60 + 1f)) / max((_e66 + _e67), 0.000000000000000000000000000001f));
    let _e74 = alpha_98;
    let _e76 = across_11;
    let _e78 = c_27;
    let _e79 = c_27;
    let _e81 = alpha_98;
    width_5 = (((1.4142135f * _e74) * _e76) * inverseSqrt(sqrt(((_e78 * _e79) + max(_e81, 0.000000000001f)))));
    let _e89 = width_5;
    let _e92 = width_5;
    return (_e89 / (1f + (2f * _e92)));
}

fn thinWallEnergy(texel_10: vec4<f32>) -> ThinWallEnergy {
    var texel_11: vec4<f32>;
    var e_14: ThinWallEnergy;

    texel_11 = texel_10;
    let _e38 = texel_11;
    e_14.transmitted = _e38.x;
    let _e41 = texel_11;
    e_14.reflectedFirst = _e41.y;
    let _e44 = texel_11;
    e_14.reflectedLater = _e44.z;
    let _e46 = e_14;
    return _e46;
}

fn thinWallLaterSpread(eta_73: f32) -> f32 {
    var eta_74: f32;
    var local_110: f32;
    var n_44: f32;

    eta_74 = eta_73;
    let _e36 = eta_74;
    if (_e36 < 1f) {
        let _e40 = eta_74;
        local_110 = (1f / max(_e40, 0.01f));
    } else {
        let _e44 = eta_74;
        local_110 = _e44;
    }
    let _e46 = local_110;
    n_44 = _e46;
    let _e48 = n_44;
    let _e49 = n_44;
    let _e52 = n_44;
    let _e56 = n_44;
    return sqrt(((_e48 * _e49) + ((0.5f * (_e52 - 1f)) * (_e56 - 1f))));
}

fn thinWallTap(texel_12: vec4<f32>, cosTheta_55: f32, alpha_99: f32, eta_75: f32) -> InterfaceTap {
    var texel_13: vec4<f32>;
    var cosTheta_56: f32;
    var alpha_100: f32;
    var eta_76: f32;
    var c_28: f32;
    var width_6: f32;
    var tap_18: InterfaceTap;

    texel_13 = texel_12;
    cosTheta_56 = cosTheta_55;
    alpha_100 = alpha_99;
    eta_76 = eta_75;
    let _e42 = cosTheta_56;
    c_28 = clamp(_e42, 0f, 1f);
    let _e47 = c_28;
    let _e48 = alpha_100;
    let _e52 = eta_76;
    let _e53 = thinWallWidth(_e47, clamp(_e48, 0f, 1f), _e52);
    width_6 = _e53;
    let _e58 = c_28;
    let _e61 = c_28;
    let _e65 = c_28;
    let _e67 = texel_13;
    let _e69 = width_6;
    tap_18.angle = (atan2(sqrt(((1f - _e58) * (1f + _e61))), _e65) + (_e67.x * _e69));
    let _e73 = texel_13;
    let _e75 = width_6;
    tap_18.sigma = (_e73.y * _e75);
    let _e78 = texel_13;
    tap_18.weight = _e78.z;
    let _e80 = tap_18;
    return _e80;
}
