// Rough glass for three.js: GroundglassMaterial in place of MeshPhysicalMaterial, Groundglass.render() in place of renderer.render().
// README.md beside this file says how, what it costs and how wrong it is.
import * as THREE from 'three';
import { refraction } from './shaders.js';

// Bodies of glass are told apart by where their meshes' origins stand.
const bodyNumber = /* glsl */`float ggNumber() { return 1.0 + floor(4096.0 * fract(abs(dot(modelMatrix[3].xyz, vec3(12.9898, 78.233, 37.719))))); }`;
const glassLayer = 31;

let drawing = false; // while a frame is drawn three must not see our materials as its own transmissive ones

const tables = {
  ggEnergy: { value: null }, ggLobes: { value: null }, ggReflection: { value: null }, ggPyramid: { value: null }, ggDepth: { value: null }, ggLayers: { value: [] },
  ggEnvironmentEven: { value: null }, ggEnvironmentOdd: { value: null }, ggTiles: { value: [] }, ggAtlas: { value: new THREE.Vector4() },
  ggSampleArea: { value: 1 }, ggClipFromWorld: { value: new THREE.Matrix4() }, ggPicture: { value: new THREE.Vector4() }, ggRange: { value: new THREE.Vector4() },
};

const zeros = new THREE.DataTexture(new Float32Array(4), 1, 1, THREE.RGBAFormat, THREE.FloatType);
zeros.needsUpdate = true;
const before = { value: zeros }; // of the layer of faces that is drawn, the one that it lies behind

const fragmentDeclarations = /* glsl */`
uniform highp sampler3D ggEnergy, ggLobes, ggReflection;
uniform sampler2D ggPyramid, ggDepth, ggEnvironmentEven, ggEnvironmentOdd, ggLayers[LAYERS];
uniform vec3 ggTiles[LEVELS]; // texels along an edge, first row, sigma
uniform vec4 ggAtlas; // width, heights of both, intensity
uniform vec4 ggPicture; // width, height, pixels per unit of tangent, last level
uniform vec4 ggRange; // near, far, reach, 1: back faces are drawn
uniform mat4 ggClipFromWorld;
uniform float ggSampleArea; // share of a pixel's area that the frame's sample stands for
uniform float ggTransmission, ggThickness, ggCurvature, ggIor, ggBackAlpha, ggBeckmann;
uniform vec3 ggAttenuation;
uniform sampler2D ggThicknessMap, ggTransmissionMap;
varying vec3 ggPosition;
varying vec3 ggScale;
${refraction}
vec4 gg_engineInterfaceEnergy(vec3 at) { return textureLod(ggEnergy, at, 0.0); }
vec4 gg_engineInterfaceLobe(vec3 at) { return textureLod(ggLobes, at, 0.0); }
vec4 gg_engineReflectionLobe(vec3 at) { return textureLod(ggReflection, at, 0.0); }
vec4 gg_engineSceneColor(vec2 at, float variance) {
  vec2 uv = vec2(at.x, ggPicture.y - at.y) / ggPicture.xy;
  return vec4(textureLod(ggPyramid, uv, gg_pyramidLevel(variance, ggPicture.w)).rgb, 1.0);
}
float gg_engineSceneDepth(vec2 at) {
  vec2 uv = vec2(at.x, ggPicture.y - at.y) / ggPicture.xy;
  float z = textureLod(ggDepth, clamp(uv, 0.5 / ggPicture.xy, 1.0 - 0.5 / ggPicture.xy), 0.0).x;
  return z >= 1.0 ? 1e30 : ggRange.x * ggRange.y / (ggRange.y - z * (ggRange.y - ggRange.x));
}
vec4 gg_engineFace(int layer, vec2 at) {
  vec2 uv = vec2(at.x, ggPicture.y - at.y) / ggPicture.xy;
  #ifdef GG_TWO_PAIRS
    if (layer == gg_SECOND_FRONTS) return textureLod(ggLayers[1], uv, 0.0);
    if (layer == gg_SECOND_BACKS) return textureLod(ggLayers[2], uv, 0.0);
  #endif
  return textureLod(ggLayers[0], uv, 0.0);
}
// Octahedral tiles, each with a border of one texel.
vec3 ggTile(sampler2D atlas, float height, vec3 tile, vec2 p) {
  vec2 texel = vec2(1.0, tile.y + 1.0) + (0.5 + 0.5 * p) * tile.x;
  return textureLod(atlas, texel / vec2(ggAtlas.x, height), 0.0).rgb;
}
vec3 gg_engineEnvironment(vec3 direction, float sigma) {
  if (ggAtlas.w == 0.0) return vec3(0.0);
  vec3 d = direction / (abs(direction.x) + abs(direction.y) + abs(direction.z));
  vec2 p = d.y >= 0.0 ? d.xz : (1.0 - abs(d.zx)) * vec2(d.x < 0.0 ? -1.0 : 1.0, d.z < 0.0 ? -1.0 : 1.0);
  // Levels are sqrt(2) apart in sigma from the first blurred one on; between two the mix keeps the variance. One of two neighbours is even,
  // the other odd: one read of each atlas, and of one alone where it is sharp.
  int below = clamp(int(floor(1.0 + 2.0 * log2(max(sigma, 1e-6) / ggTiles[1].z))), 0, LEVELS - 2);
  float low = ggTiles[below].z * ggTiles[below].z, high = ggTiles[below + 1].z * ggTiles[below + 1].z;
  float share = clamp((sigma * sigma - low) / (high - low), 0.0, 1.0);
  int even = below + below % 2, odd = below + 1 - below % 2;
  float oddShare = even == below ? share : 1.0 - share;
  vec3 seen = vec3(0.0);
  if (oddShare < 1.0) seen += (1.0 - oddShare) * ggTile(ggEnvironmentEven, ggAtlas.y, ggTiles[even], p);
  if (oddShare > 0.0) seen += oddShare * ggTile(ggEnvironmentOdd, ggAtlas.z, ggTiles[odd], p);
  return ggAtlas.w * seen;
}
`;

// Of three's own lookups of the environment nothing is seen where all is transmitted.
const fragmentLights = /* glsl */`
  bool ggLit = ggTransmission < 1.0;
  #if defined(GG_TRANSMISSION_MAP) || defined(USE_CLEARCOAT) || defined(USE_SHEEN)
    ggLit = true;
  #endif
  if (ggLit) {
    #include <lights_fragment_maps>
  }
`;

const fragmentBody = /* glsl */`
  if (ggTransmission > 0.0) {
    gg_GlassFace ggFace;
    ggFace.position = ggPosition;
    ggFace.wo = normalize(cameraPosition - ggPosition);
    ggFace.n = normalize((vec4(normal, 0.0) * viewMatrix).xyz);
    ggFace.alpha = roughnessFactor * roughnessFactor; // material.roughness has what the normals of a pixel differ by, which is turn here
    // Interpolated normals may lean away from the viewer: no further than along the surface.
    ggFace.n = normalize(ggFace.n + max(1e-3 - dot(ggFace.n, ggFace.wo), 0.0) * ggFace.wo);
    vec3 ggAlongX = dFdx(ggPosition), ggAlongY = dFdy(ggPosition);
    vec3 ggShape = normalize((vec4(normalize(vNormal), 0.0) * viewMatrix).xyz);
    vec3 ggTurnX = dFdx(ggShape), ggTurnY = dFdy(ggShape);
    // The mean of the normal curvatures along two directions of the surface.
    float ggBend = 0.5 * (dot(ggTurnX, ggAlongX) / max(dot(ggAlongX, ggAlongX), 1e-20) + dot(ggTurnY, ggAlongY) / max(dot(ggAlongY, ggAlongY), 1e-20));
    vec3 ggLocal = abs((vec4(ggFace.n, 0.0) * modelMatrix).xyz) / (ggScale * ggScale);
    ggFace.turn = ggSampleArea * (dot(ggTurnX, ggTurnX) + dot(ggTurnY, ggTurnY)) / 24.0; // evenly over a pixel: a twelfth of its width²
    gg_ConvexBody ggBody;
    ggBody.ior = ggIor;
    ggBody.backAlpha = ggBackAlpha < 0.0 ? ggFace.alpha : ggBackAlpha;
    // The thickness is in the mesh's own units, along the normal.
    ggBody.thickness = ggThickness / max(length(ggLocal), 1e-20);
    #ifdef GG_THICKNESS_MAP
      ggBody.thickness *= texture2D(ggThicknessMap, vUv).g;
    #endif
    ggBody.curvature = ggCurvature < 0.0 ? max(ggBend, 0.0) : ggCurvature;
    ggBody.attenuation = ggAttenuation;
    gg_SceneView ggView;
    ggView.clipFromWorld = ggClipFromWorld;
    ggView.eye = cameraPosition;
    ggView.size = ggPicture.xy;
    ggView.focal = ggPicture.z;
    ggView.reach = ggRange.z;
    gg_Widening ggWiden;
    if (ggBeckmann > 0.5) ggWiden = gg_wideningBeckmann(2); else ggWiden = gg_wideningGgx(2);
    #ifdef GG_TWO_PAIRS
      vec3 ggThrough = material.diffuseContribution * gg_refractTwoPairs(ggFace, ggBody, ggRange.w * ggNumber(), ggView, ggWiden);
    #else
      vec3 ggThrough = material.diffuseContribution * gg_refractFrontBack(ggFace, ggBody, ggRange.w * ggNumber(), ggView, ggWiden);
    #endif
    float ggAmount = ggTransmission;
    #ifdef GG_TRANSMISSION_MAP
      ggAmount *= texture2D(ggTransmissionMap, vUv).r;
    #endif
    totalDiffuse = mix(totalDiffuse, ggThrough, ggAmount);
    // In place of three's reflection of its own environment, which knows nothing of the scene.
    totalSpecular += ggAmount * (material.specularF90 * gg_reflectGlass(ggFace, ggIor, ggView) - reflectedLight.indirectSpecular);
  }
`;

/**
 * MeshPhysicalMaterial with two rough faces. Its `transmission`, `roughness`, `ior`, `thickness`, `attenuationColor` and
 * `attenuationDistance` mean what they mean there; `dispersion` is not drawn. More:
 * backRoughness  of the far face; null: that of the near one.
 * curvature      of the body, 1/m: 0 a plate, 2 / thickness a sphere; null: from the mesh's normals.
 * distribution   'ggx' or 'beckmann': given to Groundglass.load, for all materials: their tables.
 */
export class GroundglassMaterial extends THREE.MeshPhysicalMaterial {
  constructor(parameters = {}) {
    super();
    this.isGroundglassMaterial = true;
    this.backRoughness = null;
    this.curvature = null;
    this.glass = {};
    for (const name of ['Transmission', 'Thickness', 'Curvature', 'Ior', 'BackAlpha', 'Beckmann']) this.glass['gg' + name] = { value: 0 };
    this.glass.ggAttenuation = { value: new THREE.Vector3() };
    this.glass.ggThicknessMap = { value: null };
    this.glass.ggTransmissionMap = { value: null };
    // Its faces, layer by layer: octahedral outward normal, metres along the camera's axis, the body's number plus half of alpha.
    this.faces = new THREE.ShaderMaterial({
      toneMapped: false, blending: THREE.NoBlending, uniforms: { roughness: { value: 0 }, map: { value: null }, mapped: { value: false }, before },
      vertexShader: `out vec3 outward; out float metres; out vec2 place;
        void main() {
          place = uv;
          vec4 world = vec4(position, 1.0);
          vec3 turned = normal;
          #ifdef USE_INSTANCING
            world = instanceMatrix * world;
            turned = mat3(instanceMatrix) * (normal / vec3(dot(instanceMatrix[0], instanceMatrix[0]), dot(instanceMatrix[1], instanceMatrix[1]), dot(instanceMatrix[2], instanceMatrix[2])));
          #endif
          outward = mat3(modelMatrix) * (turned / vec3(dot(modelMatrix[0], modelMatrix[0]), dot(modelMatrix[1], modelMatrix[1]), dot(modelMatrix[2], modelMatrix[2])));
          world = viewMatrix * modelMatrix * world;
          metres = -world.z;
          gl_Position = projectionMatrix * world;
        }`,
      fragmentShader: `precision highp float; in vec3 outward; in float metres; in vec2 place; out vec4 pixel;
        uniform mat4 modelMatrix; uniform float roughness; uniform sampler2D map; uniform bool mapped; uniform sampler2D before; ${bodyNumber}
        void main() {
          // Behind the layer before; two surfaces that touch differ by rounding alone: a millionth.
          if (metres <= 1.000001 * texelFetch(before, min(ivec2(gl_FragCoord.xy), textureSize(before, 0) - 1), 0).z) discard;
          vec3 n = outward / (abs(outward.x) + abs(outward.y) + abs(outward.z));
          vec2 p = n.z >= 0.0 ? n.xy : (1.0 - abs(n.yx)) * vec2(n.x < 0.0 ? -1.0 : 1.0, n.y < 0.0 ? -1.0 : 1.0);
          float rough = mapped ? roughness * texture(map, place).g : roughness;
          pixel = vec4(p, metres, ggNumber() + 0.5 * rough * rough);
        }`,
      glslVersion: THREE.GLSL3,
    });
    this.setValues(parameters);
  }

  get transmission() { return drawing ? 0 : this._transmission; }
  set transmission(value) { this._transmission = value; }

  /** A material of ours in place of a MeshPhysicalMaterial that transmits. */
  static from(material) {
    const made = new GroundglassMaterial();
    THREE.MeshPhysicalMaterial.prototype.copy.call(made, material);
    made.uuid = THREE.MathUtils.generateUUID();
    return made;
  }

  copy(source) {
    super.copy(source);
    this.backRoughness = source.backRoughness ?? null;
    this.curvature = source.curvature ?? null;
    return this;
  }

  customProgramCacheKey() { return 'groundglass'; }

  onBeforeCompile(shader) {
    Object.assign(shader.uniforms, tables, this.glass);
    shader.vertexShader = shader.vertexShader
      .replace('#include <common>', '#include <common>\nvarying vec3 ggPosition;\nvarying vec3 ggScale;')
      .replace('#include <project_vertex>', `#include <project_vertex>
        vec4 ggWorld = vec4(transformed, 1.0);
        #ifdef USE_INSTANCING
          ggWorld = instanceMatrix * ggWorld;
        #endif
        ggPosition = (modelMatrix * ggWorld).xyz;
        ggScale = vec3(length(modelMatrix[0].xyz), length(modelMatrix[1].xyz), length(modelMatrix[2].xyz));`);
    shader.fragmentShader = shader.fragmentShader
      .replace('#include <common>', '#include <common>\nuniform mat4 modelMatrix;\n' + bodyNumber
        + fragmentDeclarations.replaceAll('LEVELS', String(environmentLevels.length)).replace('LAYERS', 'GG_TWO_PAIRS' in this.defines ? '3' : '1'))
      .replace('#include <lights_fragment_maps>', fragmentLights)
      .replace('#include <transmission_fragment>', fragmentBody);
  }

  update(pairs) {
    if (pairs !== ('GG_TWO_PAIRS' in this.defines)) {
      if (pairs) this.defines.GG_TWO_PAIRS = '';
      else delete this.defines.GG_TWO_PAIRS;
      this.needsUpdate = true;
    }
    const glass = this.glass;
    glass.ggTransmission.value = this._transmission;
    glass.ggThickness.value = this.thickness;
    glass.ggCurvature.value = this.curvature ?? -1;
    glass.ggIor.value = this.ior;
    glass.ggBackAlpha.value = this.backRoughness === null ? -1 : this.backRoughness ** 2;
    const back = this.faces.uniforms;
    back.roughness.value = this.backRoughness ?? this.roughness;
    back.map.value = this.roughnessMap;
    back.mapped.value = this.backRoughness === null && this.roughnessMap !== null;
    for (const [map, define] of [['thicknessMap', 'GG_THICKNESS_MAP'], ['transmissionMap', 'GG_TRANSMISSION_MAP']]) {
      glass[map === 'thicknessMap' ? 'ggThicknessMap' : 'ggTransmissionMap'].value = this[map];
      if (!this[map] !== (define in this.defines)) continue;
      if (this[map]) Object.assign(this.defines, { [define]: '', USE_UV: '' });
      else delete this.defines[define];
      this.needsUpdate = true;
    }
    // Beer's law: attenuationColor is what is left after attenuationDistance.
    const per = (c) => (Number.isFinite(this.attenuationDistance) && this.attenuationDistance > 0 ? -Math.log(Math.max(c, 1e-6)) / this.attenuationDistance : 0);
    glass.ggAttenuation.value.set(per(this.attenuationColor.r), per(this.attenuationColor.g), per(this.attenuationColor.b));
  }
}

// The environment as octahedral tiles: the first sharp, then Gaussians of sigma 0.01 radians and up, sqrt(2) apart. A texel is at most
// as wide as its level's sigma.
const environmentLevels = [{ size: 512, sigma: 0.0035 }];
for (let k = 0; k < 13; ++k) {
  const sigma = 0.01 * Math.SQRT2 ** k;
  environmentLevels.push({ size: Math.max(16, 2 ** Math.ceil(Math.log2(3.5 / sigma) - 0.01)), sigma });
}

function fullscreen(fragmentShader, uniforms) {
  return new THREE.ShaderMaterial({
    uniforms, depthTest: false, depthWrite: false, toneMapped: false, glslVersion: THREE.GLSL3,
    vertexShader: 'out vec2 uv01; void main() { uv01 = position.xy * 0.5 + 0.5; gl_Position = vec4(position.xy, 0.0, 1.0); }',
    fragmentShader: `precision highp float;\nin vec2 uv01;\nout vec4 pixel;\n${fragmentShader}`,
  });
}

const triangle = new THREE.BufferGeometry().setAttribute('position', new THREE.Float32BufferAttribute([-1, -1, 0, 3, -1, 0, -1, 3, 0], 3));

export class Groundglass {
  /** Loads the tables of one distribution, 'ggx' or 'beckmann'. */
  static async load(renderer, { distribution = 'ggx', base = new URL('./', import.meta.url) } = {}) {
    const description = await (await fetch(new URL('tables.json', base))).json();
    const texture = async (name) => {
      const { file, size } = description.textures[`${name}-${distribution}`];
      const data = new Uint16Array(await (await fetch(new URL(file, base))).arrayBuffer());
      const made = new THREE.Data3DTexture(data, ...size);
      made.type = THREE.HalfFloatType;
      made.minFilter = made.magFilter = THREE.LinearFilter;
      made.needsUpdate = true;
      return made;
    };
    const glass = new Groundglass(renderer);
    [tables.ggEnergy.value, tables.ggLobes.value, tables.ggReflection.value]
      = await Promise.all(['interface-energy', 'interface-lobes2', 'reflection-lobes1'].map(texture));
    glass.beckmann = distribution === 'beckmann' ? 1 : 0;
    return glass;
  }

  constructor(renderer) {
    this.renderer = renderer;
    this.camera = new THREE.OrthographicCamera(-1, 1, 1, -1, 0, 1);
    this.mesh = new THREE.Mesh(triangle);
    this.mesh.frustumCulled = false;
    this.stage = new THREE.Scene().add(this.mesh);
    // [1 3 3 1] / 8 along both axes in four reads between texels: 3/4 of a texel² of variance.
    this.halve = fullscreen(`uniform sampler2D source; uniform vec2 texel;
      void main() {
        vec2 d = 0.75 * texel;
        pixel = 0.25 * (textureLod(source, uv01 + d, 0.0) + textureLod(source, uv01 - d, 0.0)
          + textureLod(source, uv01 + vec2(d.x, -d.y), 0.0) + textureLod(source, uv01 + vec2(-d.x, d.y), 0.0));
      }`, { source: { value: null }, texel: { value: new THREE.Vector2() } });
    // As three's own materials: tone mapping and colour space are the renderer's.
    this.copy = new THREE.ShaderMaterial({
      uniforms: { color: { value: null }, depth: { value: null } }, depthFunc: THREE.AlwaysDepth,
      vertexShader: 'void main() { gl_Position = vec4(position.xy, 0.0, 1.0); }',
      fragmentShader: `uniform sampler2D color; uniform highp sampler2D depth;
        void main() {
          gl_FragColor = texelFetch(color, ivec2(gl_FragCoord.xy), 0);
          gl_FragDepth = texelFetch(depth, ivec2(gl_FragCoord.xy), 0).x;
          #include <tonemapping_fragment>
          #include <colorspace_fragment>
        }`,
    });
    this.beckmann = 0;
    // 'convex': every body is taken for a lens of its thickness; 'faces': with a pass for back faces; 'pairs': two passes more, for the far wall
    // of a hollow body and for glass behind glass.
    this.tier = 'faces';
    this.samples = 1; // frames, each at another place of the pixel, that you average to one picture: lobes blur over so much less of it
    this.layers = [];
    this.environment = null;
  }

  draw(material, target) {
    this.mesh.material = material;
    this.renderer.setRenderTarget(target);
    this.renderer.render(this.stage, this.camera);
  }

  /** An equirectangular texture (null: black), linear radiance. render() calls it when scene.environment or its background changes. */
  setEnvironment(texture) {
    this.environment = texture;
    if (!texture) return;
    this.even?.dispose();
    this.odd?.dispose();
    const width = environmentLevels[0].size + 2, heights = [0, 0];
    tables.ggTiles.value = environmentLevels.map(({ size, sigma }, k) => {
      const row = heights[k % 2];
      heights[k % 2] += size + 2;
      return new THREE.Vector3(size, row, sigma);
    });
    const options = { type: THREE.HalfFloatType, depthBuffer: false, generateMipmaps: false };
    [this.even, this.odd] = heights.map((height) => new THREE.WebGLRenderTarget(width, height, options));
    const octahedron = `uniform float size; vec2 mirrored(vec2 p) {
        if (abs(p.x) > 1.0) p = vec2(sign(p.x) * 2.0 - p.x, -p.y);
        if (abs(p.y) > 1.0) p = vec2(-p.x, sign(p.y) * 2.0 - p.y);
        return p;
      }
      vec3 decoded(vec2 p) {
        float y = 1.0 - abs(p.x) - abs(p.y);
        vec2 fold = max(-y, 0.0) * vec2(p.x < 0.0 ? -1.0 : 1.0, p.y < 0.0 ? -1.0 : 1.0);
        return normalize(vec3(p.x - fold.x, y, p.y - fold.y));
      }
      vec3 here(vec2 at) { return decoded(mirrored(2.0 * (at * (size + 2.0) - 1.0) / size - 1.0)); }`;
    // 65504 is the largest half float: a brighter sun would be infinite.
    const sharp = fullscreen(`uniform sampler2D map; ${octahedron}
      void main() {
        vec3 sum = vec3(0.0);
        for (int k = 0; k < 4; ++k) {
          vec3 d = here(uv01 + (vec2(k & 1, k >> 1) - 0.5) * 0.5 / (size + 2.0));
          sum += textureLod(map, vec2(atan(d.z, d.x) * 0.15915494 + 0.5, asin(clamp(d.y, -1.0, 1.0)) * 0.31830989 + 0.5), 0.0).rgb;
        }
        pixel = vec4(min(0.25 * sum, 65504.0), 1.0);
      }`, { map: { value: texture }, size: { value: 0 } });
    const blur = fullscreen(`uniform sampler2D source; uniform vec3 from; uniform vec2 atlas; uniform float spread; ${octahedron}
      vec3 read(vec3 d) {
        d /= abs(d.x) + abs(d.y) + abs(d.z);
        vec2 p = d.y >= 0.0 ? d.xz : (1.0 - abs(d.zx)) * vec2(d.x < 0.0 ? -1.0 : 1.0, d.z < 0.0 ? -1.0 : 1.0);
        return textureLod(source, (vec2(1.0, from.y + 1.0) + (0.5 + 0.5 * p) * from.x) / atlas, 0.0).rgb;
      }
      void main() { // points of a Gaussian disc: radii at its quantiles, angles by the golden ratio
        vec3 n = here(uv01), t = normalize(cross(n, abs(n.y) < 0.7 ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0))), b = cross(n, t), sum = vec3(0.0);
        for (int k = 0; k < 48; ++k) {
          float angle = 2.39996323 * float(k), r = spread * sqrt(-2.0 * log(1.0 - (float(k) + 0.5) / 48.0));
          sum += read(cos(r) * n + sin(r) * (cos(angle) * t + sin(angle) * b));
        }
        pixel = vec4(sum / 48.0, 1.0);
      }`, { source: { value: null }, from: { value: null }, atlas: { value: new THREE.Vector2() }, spread: { value: 0 }, size: { value: 0 } });
    environmentLevels.forEach(({ size, sigma }, k) => {
      const target = k % 2 ? this.odd : this.even, source = k % 2 ? this.even : this.odd, material = k ? blur : sharp;
      material.uniforms.size.value = size;
      if (k) {
        blur.uniforms.source.value = source.texture;
        blur.uniforms.from.value = tables.ggTiles.value[k - 1];
        blur.uniforms.atlas.value.set(width, heights[1 - k % 2]);
        blur.uniforms.spread.value = Math.sqrt(sigma ** 2 - environmentLevels[k - 1].sigma ** 2);
      }
      target.viewport.set(0, tables.ggTiles.value[k].y, size + 2, size + 2);
      this.keepingState(() => this.draw(material, target));
    });
    tables.ggEnvironmentEven.value = this.even.texture;
    tables.ggEnvironmentOdd.value = this.odd.texture;
    tables.ggAtlas.value.set(width, ...heights, 1);
  }

  keepingState(run) {
    const { renderer } = this, target = renderer.getRenderTarget(), clears = renderer.autoClear, tone = renderer.toneMapping;
    renderer.autoClear = false;
    renderer.toneMapping = THREE.NoToneMapping;
    run();
    renderer.autoClear = clears;
    renderer.toneMapping = tone;
    renderer.setRenderTarget(target);
  }

  resize(width, height) {
    const count = { convex: 0, faces: 1, pairs: 3 }[this.tier];
    if (this.scene?.width === width && this.scene.height === height && this.layers.length === count) return;
    for (const one of [this.scene, this.pyramid, ...this.layers, ...(this.steps ?? [])]) one?.dispose();
    const half = { type: THREE.HalfFloatType, depthBuffer: false, generateMipmaps: false };
    const depthTexture = new THREE.DepthTexture(width, height, THREE.FloatType);
    this.scene = new THREE.WebGLRenderTarget(width, height, { type: THREE.HalfFloatType, depthTexture });
    // Levels down to four texels along the shorter side: wider lobes see no more than that of the picture.
    const levels = Math.max(1, Math.floor(Math.log2(Math.min(width, height))) - 1);
    this.steps = [];
    for (let k = 1; k < levels; ++k) this.steps.push(new THREE.WebGLRenderTarget(width >> k, height >> k, half));
    this.pyramid = new THREE.WebGLRenderTarget(width, height, { ...half, minFilter: THREE.LinearMipmapLinearFilter });
    this.pyramid.texture.mipmaps = Array.from({ length: levels }, () => ({}));
    this.renderer.initRenderTarget(this.pyramid);
    const nearest = { type: THREE.FloatType, minFilter: THREE.NearestFilter, magFilter: THREE.NearestFilter, generateMipmaps: false };
    this.layers = Array.from({ length: count }, () => new THREE.WebGLRenderTarget(width, height, nearest));
    tables.ggPyramid.value = this.pyramid.texture;
    tables.ggLayers.value = count > 0 ? this.layers.map((layer) => layer.texture) : [zeros];
    tables.ggDepth.value = depthTexture;
  }

  /** Draws the scene into the renderer's current target: what is not glass, its Gaussian pyramid, then all. */
  render(scene, camera) {
    const { renderer } = this, target = renderer.getRenderTarget();
    const size = target ? new THREE.Vector2(target.width, target.height) : renderer.getDrawingBufferSize(new THREE.Vector2());
    const glass = [];
    scene.traverseVisible((object) => { if (object.material?.isGroundglassMaterial && object.layers.test(camera.layers)) glass.push(object); });
    if (scene.environment !== this.environment) this.setEnvironment(scene.environment);
    tables.ggSampleArea.value = 1 / this.samples;
    tables.ggAtlas.value.w = scene.environment ? scene.environmentIntensity : 0;
    drawing = true;
    try {
      if (glass.length > 0) {
        this.resize(size.x, size.y);
        this.describe(scene, camera, size, glass);
        for (const one of glass) one.visible = false;
        const tone = renderer.toneMapping;
        renderer.toneMapping = THREE.NoToneMapping;
        renderer.setRenderTarget(this.scene);
        renderer.render(scene, camera);
        renderer.toneMapping = tone;
        for (const one of glass) one.visible = true;
        this.keepingState(() => this.blur());
        if (this.layers.length > 0) this.drawFaces(scene, camera, glass);
      }
      renderer.setRenderTarget(target);
      if (glass.length > 0 && this.once(scene, target)) this.drawGlass(scene, camera, glass);
      else renderer.render(scene, camera);
    } finally {
      drawing = false;
    }
  }

  // Whether what is not glass need not be drawn again: all of it is in the pictures of the first pass. Not what glass may stand behind without its
  // knowing, nor edges that the target has more samples of.
  once(scene, target) {
    if (target ? target.samples > 0 : this.renderer.getContextAttributes().antialias) return false;
    let opaque = true;
    scene.traverseVisible(({ material }) => {
      for (const one of [material].flat()) if (one && !one.isGroundglassMaterial && (one.transparent || one.transmission > 0)) opaque = false;
    });
    return opaque;
  }

  // The first pass' pictures, then glass.
  drawGlass(scene, camera, glass) {
    const { renderer } = this, { background } = scene, layers = camera.layers.mask, clears = renderer.autoClear;
    const drawn = [...glass];
    scene.traverseVisible((object) => { if (object.isLight && object.layers.test(camera.layers)) drawn.push(object); });
    for (const one of drawn) one.layers.enable(glassLayer);
    this.copy.uniforms.color.value = this.scene.texture;
    this.copy.uniforms.depth.value = this.scene.depthTexture;
    if (clears) renderer.clear();
    renderer.autoClear = false;
    this.mesh.material = this.copy;
    renderer.render(this.stage, this.camera);
    camera.layers.set(glassLayer);
    scene.background = null;
    renderer.render(scene, camera);
    scene.background = background;
    camera.layers.mask = layers;
    renderer.autoClear = clears;
    for (const one of drawn) one.layers.disable(glassLayer);
  }

  // The second and third tier, where rays leave the glass: the nearest back faces, the front faces behind those, the back faces behind these.
  drawFaces(scene, camera, glass) {
    const { renderer } = this, { background } = scene, layers = camera.layers.mask, color = renderer.getClearColor(new THREE.Color()), alpha = renderer.getClearAlpha();
    const materials = glass.map(({ material }) => material);
    for (const one of glass) {
      one.layers.enable(glassLayer);
      one.material = one.material.faces;
    }
    camera.layers.set(glassLayer);
    scene.background = null;
    renderer.setClearColor(0, 0);
    this.layers.forEach((layer, k) => {
      for (const one of glass) one.material.side = k === 1 ? THREE.FrontSide : THREE.BackSide;
      before.value = k > 0 ? this.layers[k - 1].texture : zeros;
      renderer.setRenderTarget(layer);
      renderer.clear();
      renderer.render(scene, camera);
    });
    renderer.setClearColor(color, alpha);
    scene.background = background;
    camera.layers.mask = layers;
    glass.forEach((one, k) => {
      one.layers.disable(glassLayer);
      one.material = materials[k];
    });
  }

  blur() {
    const { renderer } = this;
    renderer.setRenderTarget(this.scene);
    renderer.copyFramebufferToTexture(this.pyramid.texture, null, 0);
    let source = this.scene;
    this.steps.forEach((step, k) => {
      this.halve.uniforms.source.value = source.texture;
      this.halve.uniforms.texel.value.set(1 / source.width, 1 / source.height);
      this.draw(this.halve, step);
      renderer.copyFramebufferToTexture(this.pyramid.texture, null, k + 1);
      source = step;
    });
  }

  describe(scene, camera, size, glass) {
    camera.updateMatrixWorld();
    scene.updateMatrixWorld();
    const bounds = new THREE.Sphere(), box = new THREE.Box3().setFromObject(scene);
    box.getBoundingSphere(bounds);
    tables.ggClipFromWorld.value.multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse);
    tables.ggPicture.value.set(size.x, size.y, 0.5 * size.y * camera.projectionMatrix.elements[5], this.steps.length);
    tables.ggRange.value.set(camera.near, camera.far, Math.max(2.04 * bounds.radius, camera.near), this.tier === 'convex' ? 0 : 1);
    for (const { material } of glass) {
      material.update(this.tier === 'pairs');
      material.glass.ggBeckmann.value = this.beckmann;
    }
  }
}

/** Every MeshPhysicalMaterial below `object` that transmits becomes a GroundglassMaterial. */
export function replaceGlass(object) {
  const made = new Map();
  object.traverse((one) => {
    const material = one.material;
    if (!material?.isMeshPhysicalMaterial || !(material.transmission > 0) || material.isGroundglassMaterial) return;
    if (!made.has(material)) made.set(material, GroundglassMaterial.from(material));
    one.material = made.get(material);
  });
}
