// GLSL of the land. Heights are metres above the land's lowest node; x is east, y is north, z is up.

const SHARED = /* glsl */ `
  precision highp float;
  precision highp sampler2D;
  uniform sampler2D tGround;   // r: height, g: depth of water (negative on land)
  uniform vec2 uSize;          // metres, east and north
  uniform vec2 uNodes;         // columns, rows
  uniform float uTall;         // vertical exaggeration

  // Where a node of the raster lies in the texture: the first and last nodes are centres of texels.
  vec2 texel(vec2 part) { return (part * (uNodes - 1.0) + 0.5) / uNodes; }
  vec2 ground(vec2 part) { return texture(tGround, texel(part)).rg; }
  float surface(vec2 g) { return g.r + max(g.g, 0.0); }
`;

export const TERRAIN_VERTEX = /* glsl */ `${SHARED}
  uniform mat4 uViewProjection;
  in vec2 part;                // 0 to 1 from the west, 0 to 1 from the north
  in float deep;               // 1 at the foot of a wall
  uniform float uFoot;         // height of the foot, exaggerated metres
  out vec2 vPart;
  out vec3 vPlace;
  void main() {
    vec2 g = ground(part);
    float top = surface(vec2(max(g.r, 0.0), g.g)) * uTall;
    vPart = part;
    vPlace = vec2(part.x - 0.5, 0.5 - part.y).xyx * vec3(uSize, 0.0);
    vPlace.z = mix(top, uFoot, deep);
    gl_Position = uViewProjection * vec4(vPlace, 1.0);
  }
`;

/** Normals, openness to the sky and shadow of the sun, once a frame and node. */
export const SHADE_FRAGMENT = /* glsl */ `${SHARED}
  uniform vec3 uSun;
  uniform float uRelief;       // metres, not exaggerated
  uniform int uDirections;
  uniform int uRays;
  in vec2 vPart;
  out vec4 shade;

  float height(vec2 part) { return surface(ground(part)) * uTall; }

  void main() {
    vec2 step1 = 1.0 / max(uNodes - 1.0, vec2(1.0));
    vec2 cell = uSize * step1;
    float here = height(vPart);
    float dx = (height(vPart + vec2(step1.x, 0.0)) - height(vPart - vec2(step1.x, 0.0))) / (2.0 * cell.x);
    float dy = (height(vPart - vec2(0.0, step1.y)) - height(vPart + vec2(0.0, step1.y))) / (2.0 * cell.y);
    vec3 normal = normalize(vec3(-dx, -dy, 1.0));

    float open = 0.0;
    float reach = min(cell.x, cell.y);
    for (int k = 0; k < 24; k++) {
      if (k >= uDirections) break;
      float angle = 6.2831853 * (float(k) + 0.5) / float(uDirections);
      vec2 way = vec2(cos(angle), sin(angle));
      float steepest = 0.0;
      float far = 1.0;
      for (int i = 0; i < 6; i++) {
        vec2 part = vPart + way * reach * far / uSize * vec2(1.0, -1.0);
        if (part.x < 0.0 || part.y < 0.0 || part.x > 1.0 || part.y > 1.0) break;
        steepest = max(steepest, (height(part) - here) / (reach * far));
        far *= 1.9;
      }
      open += 1.0 / (1.0 + steepest * steepest);
    }
    open /= float(uDirections);

    float flat_ = length(uSun.xy);
    float rise = uSun.z / max(flat_, 1e-4);
    vec2 toSun = uSun.xy / max(flat_, 1e-4);
    float longest = min(uRelief * uTall / max(rise, 0.02), length(uSize));
    float horizon = -1.0;
    float rays = float(uRays);
    for (int i = 1; i <= 96; i++) {
      if (i > uRays) break;
      float t = float(i) / rays;
      float far = mix(reach * float(i), longest, t * t);
      vec2 part = vPart + toSun * far / uSize * vec2(1.0, -1.0);
      if (part.x < 0.0 || part.y < 0.0 || part.x > 1.0 || part.y > 1.0) break;
      horizon = max(horizon, (height(part) - here) / far);
    }
    float soft = 0.035 + 0.06 * rise;
    float lit = smoothstep(-soft, soft, rise - horizon);
    shade = vec4(normal.xy * 0.5 + 0.5, open, lit);
  }
`;

export const SHADE_VERTEX = /* glsl */ `
  in vec2 part;
  uniform vec2 uNodes;
  out vec2 vPart;
  void main() {
    // Centres of the target's texels fall on nodes.
    vPart = (part * uNodes - 0.5) / max(uNodes - 1.0, vec2(1.0));
    gl_Position = vec4(part * 2.0 - 1.0, 0.0, 1.0);
  }
`;

export const TERRAIN_FRAGMENT = /* glsl */ `${SHARED}
  uniform sampler2D tShade;
  uniform sampler2D tColour;   // colours of a field; alpha: how much water runs here
  uniform sampler2D tMaterial; // colours of materials; alpha: 0 what grows there, 0.5 rock on slopes, 1 all
  uniform int uMaterial;
  uniform vec3 uSun;
  uniform vec3 uEye;
  uniform float uRelief;
  uniform float uSeaHeight;    // sea level above the lowest node; far below where there is no sea
  uniform float uSnow;         // part of the relief above which snow lies; above 1: none
  uniform int uLook;           // 0 natural, 1 field, 2 clay, 3 sand
  uniform float uWall;         // 1 for the cut sides
  uniform float uContour;      // metres between contour lines; 0: none
  uniform float uHaze;         // a metre
  uniform float uQuick;        // 1: without grain, while things move and the processor draws
  uniform float uDetail;       // 1: fine grain near the eye
  uniform vec3 uBrush;         // east, north, radius; radius 0: none
  in vec2 vPart;
  in vec3 vPlace;
  out vec4 colour;

  // Light and shadow between nodes by cubic B-splines: four linear samples, no diamonds near the eye.
  vec4 smoothShade(vec2 at) {
    vec2 p = at * uNodes - 0.5, f = fract(p), base = floor(p);
    vec2 f2 = f * f, f3 = f2 * f;
    vec2 w0 = (1.0 - 3.0 * f + 3.0 * f2 - f3) / 6.0, w1 = (4.0 - 6.0 * f2 + 3.0 * f3) / 6.0, w3 = f3 / 6.0;
    vec2 w2 = 1.0 - w0 - w1 - w3, a = w0 + w1, b = w2 + w3;
    vec2 low = (base - 0.5 + w1 / a) / uNodes, high = (base + 1.5 + w3 / b) / uNodes;
    return (texture(tShade, low) * a.x + texture(tShade, vec2(high.x, low.y)) * b.x) * a.y
      + (texture(tShade, vec2(low.x, high.y)) * a.x + texture(tShade, high) * b.x) * b.y;
  }

  float hash(vec2 p) {
    vec3 q = fract(vec3(p.xyx) * 0.1031);
    q += dot(q, q.yzx + 33.33);
    return fract((q.x + q.y) * q.z);
  }
  float noise(vec2 p) {
    vec2 i = floor(p), f = fract(p);
    f = f * f * (3.0 - 2.0 * f);
    return mix(mix(hash(i), hash(i + vec2(1, 0)), f.x), mix(hash(i + vec2(0, 1)), hash(i + vec2(1, 1)), f.x), f.y);
  }
  float grain(vec2 p) { return 0.55 * noise(p) + 0.3 * noise(p * 2.7 + 9.1) + 0.15 * noise(p * 7.3 + 4.7); }

  vec3 film(vec3 c) {
    c *= 0.92;
    c = (c * (2.51 * c + 0.03)) / (c * (2.43 * c + 0.59) + 0.14);
    return pow(clamp(c, 0.0, 1.0), vec3(1.0 / 2.2));
  }

  vec3 natural(float height, float slope, float open, float spread, vec4 material) {
    float base = max(uSeaHeight, 0.0), relief = max(uRelief - base, 1e-3);
    float share = (height - base) / relief;
    float part = share * smoothstep(10.0, 700.0, relief);   // low land is green all over
    float mottle = spread - 0.5;
    vec3 rock = mix(vec3(0.165, 0.145, 0.125), vec3(0.285, 0.255, 0.220), spread);
    vec3 scree = vec3(0.300, 0.262, 0.212) * (0.9 + 0.25 * mottle);
    vec3 wood = mix(vec3(0.058, 0.076, 0.030), vec3(0.080, 0.094, 0.038), spread);
    vec3 grass = mix(vec3(0.098, 0.108, 0.045), vec3(0.150, 0.146, 0.072), spread);
    vec3 heath = vec3(0.225, 0.195, 0.115);
    float wide = noise(vPlace.xy / (uSize.x / 7.0));
    wide = 0.65 * wide + 0.35 * (uQuick > 0.5 ? 0.5 : noise(vPlace.yx / (uSize.x / 19.0) + 3.7));
    grass = mix(grass, heath, 0.5 * smoothstep(0.50, 0.82, wide));
    wood = mix(wood, grass, 0.6 * smoothstep(0.35, 0.65, wide));
    vec3 low = mix(wood, grass, smoothstep(-0.20, 0.30, part + 0.32 * mottle - 0.3 * (1.0 - open) + 0.06));
    low = mix(low, heath, smoothstep(0.26, 0.60, part + 0.30 * mottle));
    float bare = smoothstep(0.48, 0.82, slope + 0.25 * mottle + 0.30 * smoothstep(0.5, 0.95, part));
    vec3 c = mix(low, scree, smoothstep(0.34, 0.58, slope + 0.18 * mottle + 0.12 * part) * 0.8);
    c = mix(c, rock, bare);
    float shows = max(smoothstep(0.55, 0.95, material.a), smoothstep(0.05, 0.45, material.a) * (0.30 + 0.70 * smoothstep(0.10, 0.42, slope + 0.10 * mottle)));
    c = mix(c, material.rgb * (0.72 + 0.30 * spread), shows);
    float beach = 1.0 - smoothstep(0.006, 0.018, (height - uSeaHeight) / max(relief, 30.0) + 0.008 * mottle) * step(material.a, 0.7);
    c = mix(c, vec3(0.46, 0.40, 0.28), beach * (1.0 - smoothstep(0.2, 0.5, slope)));
    float line = share + 0.13 * mottle + 0.10 * (open - 0.85) - 0.20 * smoothstep(0.75, 1.6, slope);
    float snow = smoothstep(uSnow - 0.03, uSnow + 0.07, line) * (1.0 - 0.85 * smoothstep(0.95, 1.7, slope));
    return mix(c, vec3(0.80, 0.83, 0.88), snow);
  }

  void main() {
    vec2 g = ground(vPart);
    if (g.r < -0.5) discard;
    float depth = g.g;
    vec3 toEye = uEye - vPlace;
    float far = length(toEye);
    vec3 view = toEye / far;
    vec3 lit;
    if (uWall > 0.5) {
      float height = vPlace.z / uTall;
      vec2 face = normalize(abs(vPart - 0.5).x > abs(vPart - 0.5).y ? vec2(sign(vPart.x - 0.5), 0.0) : vec2(0.0, sign(0.5 - vPart.y)));
      float sun = max(dot(face, uSun.xy), 0.0);
      float beds = 0.5 + 0.5 * sin(height / max(uRelief, 1.0) * 46.0 + 3.0 * noise(vPart * 9.0));
      float under = (g.r - height) / max(uRelief, 1.0);
      vec3 earth = mix(vec3(0.115, 0.100, 0.088), vec3(0.085, 0.077, 0.072), smoothstep(0.2, 0.8, beds) * 0.6);
      earth = mix(vec3(0.17, 0.14, 0.11), earth, smoothstep(0.0, 0.035, under));
      lit = earth * (0.35 + 1.1 * sun) * mix(1.0, 0.35, smoothstep(0.0, 1.2, under));
      if (under < 0.0) lit = mix(vec3(0.020, 0.075, 0.105), vec3(0.05, 0.17, 0.20), exp(under * 6.0) * 0.6) * (0.6 + 0.6 * sun);
    } else {
      vec4 s = uDetail > 0.5 ? smoothShade(texel(vPart)) : texture(tShade, texel(vPart));
      vec2 flat_ = s.rg * 2.0 - 1.0;
      vec3 normal = vec3(flat_, sqrt(max(1.0 - dot(flat_, flat_), 0.02)));
      float slope = length(flat_) / normal.z / uTall;
      float open = s.b, shadow = s.a;
      vec4 field = texture(tColour, texel(vPart));
      vec4 material = uMaterial == 1 ? texture(tMaterial, texel(vPart)) : vec4(0.0);
      material.rgb = pow(material.rgb, vec3(2.2)) * 0.72;
      float metre = uSize.x / 260.0;
      float spread = uQuick > 0.5 ? 0.5 : grain(vPlace.xy / metre);
      if (uDetail > 0.5) {
        float fine = max(uSize.x / uNodes.x, 1e-3) * 0.8;
        float near = exp(-far / (fine * 260.0));
        if (near > 0.02) {
          float a = grain(vPlace.xy / fine), b = grain((vPlace.xy + vec2(fine * 0.35, 0.0)) / fine), d = grain((vPlace.xy + vec2(0.0, fine * 0.35)) / fine);
          normal = normalize(normal + vec3(a - b, a - d, 0.0) * near * (0.35 + slope));
          spread = mix(spread, a, near * 0.6);
        }
      }
      vec3 albedo = uLook == 1 ? pow(field.rgb, vec3(2.2)) * 0.62
        : uLook == 2 ? vec3(0.36, 0.335, 0.30)
        : uLook == 3 ? mix(vec3(0.46, 0.30, 0.145), vec3(0.54, 0.37, 0.195), spread) * (0.9 + 0.1 * normal.z) * (uMaterial == 1 ? mix(vec3(0.52, 0.50, 0.50), vec3(1.0), smoothstep(0.2, 0.9, material.a)) : vec3(1.0))
        : natural(g.r, slope, open, spread, material);
      if (uLook == 0) albedo = mix(albedo, vec3(0.070, 0.125, 0.150), field.a * 0.85);
      float sun = max(dot(normal, uSun), 0.0) * shadow;
      vec3 warm = mix(vec3(1.0, 0.70, 0.46), vec3(1.0, 0.955, 0.88), smoothstep(0.05, 0.6, uSun.z));
      float shut = mix(0.30, 1.0, smoothstep(0.35, 1.0, open)) * (0.55 + 0.45 * open);
      vec3 sky = vec3(0.43, 0.52, 0.66) * (0.55 + 0.45 * normal.z) * shut;
      vec3 bounce = vec3(0.24, 0.19, 0.14) * (1.0 - open) * (0.4 + sun);
      lit = albedo * (warm * sun * 2.7 + sky * 0.62 + bounce);
      if (depth > 0.0 && uLook != 1) {
        float scale = clamp(uRelief * 0.02, 1e-2, 9.0);
        float path = depth / scale;
        vec3 through = exp(-path * vec3(1.15, 0.50, 0.38));
        vec3 bed = vec3(0.42, 0.38, 0.29) * (warm * shadow * 1.6 + 0.35);
        vec3 body = mix(vec3(0.012, 0.075, 0.115), vec3(0.006, 0.032, 0.066), 1.0 - exp(-path * 0.12)) * (1.0 + 1.6 * shadow * uSun.z);
        vec3 ripple = normalize(vec3((grain(vPlace.xy / metre * 5.0) - 0.5) * 0.035, (grain(vPlace.yx / metre * 5.0 + 7.0) - 0.5) * 0.035, 1.0));
        float graze = pow(1.0 - max(dot(view, ripple), 0.0), 5.0);
        vec3 glint = warm * pow(max(dot(reflect(-uSun, ripple), view), 0.0), 220.0) * 2.2 * shadow;
        vec3 water = bed * through + body * (1.0 - through);
        water = mix(water, vec3(0.26, 0.36, 0.46), (0.03 + 0.75 * graze)) + glint;
        float shore = smoothstep(0.0, scale * 0.05, depth);
        lit = mix(lit, water, shore);
      }
      if (uContour > 0.0 && depth <= 0.0) {
        float level = g.r / uContour, wide = fwidth(level);
        float line = 1.0 - smoothstep(0.6 * wide, 1.5 * wide, abs(fract(level - 0.5) - 0.5));
        lit *= 1.0 - 0.55 * line * (1.0 - smoothstep(0.35, 0.9, wide));
      }
      if (uBrush.z > 0.0) {
        float off = abs(length(vPlace.xy - uBrush.xy) - uBrush.z);
        float wide = max(fwidth(length(vPlace.xy - uBrush.xy)) * 1.6, 1e-3);
        lit = mix(lit, vec3(1.6, 1.25, 0.5), 1.0 - smoothstep(wide * 0.5, wide, off));
        lit += vec3(0.07, 0.05, 0.01) * (1.0 - smoothstep(0.0, uBrush.z, length(vPlace.xy - uBrush.xy)));
      }
    }
    vec3 air = mix(vec3(0.135, 0.165, 0.205), vec3(0.34, 0.30, 0.25), pow(max(dot(-view, uSun), 0.0), 6.0));
    lit = mix(lit, air, 1.0 - exp(-far * uHaze));
    colour = vec4(film(lit), 1.0);
  }
`;

/** Dusk behind the land: a little lighter at the horizon, so that ridges stand out. */
export const SKY_FRAGMENT = /* glsl */ `
  precision highp float;
  uniform float uHorizon;      // height of the horizon in the picture, 0 to 1 from below
  in vec2 vPart;
  out vec4 colour;
  void main() {
    float up = vPart.y - uHorizon;
    vec3 low = vec3(0.052, 0.059, 0.068), mid = vec3(0.105, 0.125, 0.150), high = vec3(0.045, 0.055, 0.072);
    vec3 c = up > 0.0 ? mix(mid, high, smoothstep(0.0, 0.75, up)) : mix(mid, low, smoothstep(0.0, 0.35, -up));
    c += vec3(0.016, 0.019, 0.024) * (1.0 - smoothstep(0.0, 0.75, length((vPart - 0.5) * vec2(1.0, 1.2))));
    float grainy = fract(sin(dot(gl_FragCoord.xy, vec2(12.9898, 78.233))) * 43758.5453);
    colour = vec4(c + (grainy - 0.5) / 255.0, 1.0);
  }
`;

export const SKY_VERTEX = /* glsl */ `
  in vec2 part;
  out vec2 vPart;
  void main() {
    vPart = part;
    gl_Position = vec4(part * 2.0 - 1.0, 1.0, 1.0);
  }
`;

/** A picture in fewer pixels, enlarged. */
export const COPY_FRAGMENT = /* glsl */ `
  precision highp float;
  uniform sampler2D tPicture;
  in vec2 vPart;
  out vec4 colour;
  void main() { colour = texture(tPicture, vPart); }
`;
