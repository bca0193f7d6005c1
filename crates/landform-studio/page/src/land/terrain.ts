// The land on the graphics card: textures, surface, walls, and the pass that finds light and shadow.
import {
  ClampToEdgeWrapping, DataTexture, FloatType, GLSL3, LinearFilter, Mesh, OrthographicCamera, RawShaderMaterial, RGBAFormat, RGFormat,
  Scene, UnsignedByteType, Vector2, Vector3, WebGLRenderTarget, Matrix4, DoubleSide, type BufferGeometry, type WebGLRenderer,
} from "three";
import { extent } from "../model/raster.ts";
import { fullPicture, surfaceGrid, wallStrip } from "./mesh.ts";
import { SHADE_FRAGMENT, SHADE_VERTEX, TERRAIN_FRAGMENT, TERRAIN_VERTEX } from "./shaders.ts";
import { colourTexels, groundTexels, materialTexels, type LandState, type Look } from "./state.ts";

export interface Light {
  /** Compass direction from which the sun shines, and its height, radians. */
  azimuth: number;
  height: number;
}

export interface Drawn {
  look: Look;
  tall: number;
  light: Light;
  snow: number;
  contour: number;
  haze: number;
  detail: boolean;
  brush: [number, number, number];
}

/** 0: while something moves and the processor draws; 1: at rest; 2: with a graphics card. */
export type Effort = 0 | 1 | 2;
/** Directions in which the sky is looked for, and steps towards the sun. */
const EFFORTS: { [effort in Effort]: [number, number] } = { 0: [6, 18], 1: [14, 48], 2: [20, 80] };
/** Squares along a side of the surface while things move. */
const ROUGH_SQUARES = 112;
const LOOKS: { [look in Look]: number } = { natural: 0, field: 1, clay: 2, sand: 3 };

export class Terrain {
  readonly scene = new Scene();
  private state: LandState | null = null;
  private ground: DataTexture | null = null;
  private colours: DataTexture | null = null;
  private materials: DataTexture | null = null;
  private readonly shade = new WebGLRenderTarget(1, 1, { minFilter: LinearFilter, magFilter: LinearFilter, depthBuffer: false });
  /** Light and shadow in fewer nodes, while things move. */
  private readonly roughShade = new WebGLRenderTarget(1, 1, { minFilter: LinearFilter, magFilter: LinearFilter, depthBuffer: false });
  private grids: { fine: BufferGeometry; rough: BufferGeometry } = { fine: surfaceGrid(1, 1), rough: surfaceGrid(1, 1) };
  private shadedFor = "";
  private version = 0;
  private readonly passScene = new Scene();
  private readonly passCamera = new OrthographicCamera();
  private readonly uniforms = {
    tGround: { value: null as DataTexture | null },
    tColour: { value: null as DataTexture | null },
    tMaterial: { value: null as DataTexture | null },
    uMaterial: { value: 0 },
    tShade: { value: this.shade.texture },
    uSize: { value: new Vector2(1, 1) },
    uNodes: { value: new Vector2(2, 2) },
    uTall: { value: 1 },
    uSun: { value: new Vector3(0, 0, 1) },
    uEye: { value: new Vector3() },
    uRelief: { value: 1 },
    uSeaHeight: { value: -1e6 },
    uSnow: { value: 2 },
    uLook: { value: 0 },
    uContour: { value: 0 },
    uHaze: { value: 0 },
    uDetail: { value: 0 },
    uBrush: { value: new Vector3() },
    uFoot: { value: 0 },
    uViewProjection: { value: new Matrix4() },
    uQuick: { value: 0 },
    uDirections: { value: 16 },
    uRays: { value: 64 },
  };
  private readonly surface: Mesh;
  private readonly walls: Mesh;

  constructor(private readonly mostSquares: number) {
    const material = (wall: number) => new RawShaderMaterial({
      glslVersion: GLSL3, vertexShader: TERRAIN_VERTEX, fragmentShader: TERRAIN_FRAGMENT,
      uniforms: { ...this.uniforms, uWall: { value: wall } }, side: DoubleSide,
    });
    this.surface = new Mesh(this.grids.fine, material(0));
    this.walls = new Mesh(wallStrip(1, 1), material(1));
    for (const mesh of [this.surface, this.walls]) {
      mesh.frustumCulled = false;
      this.scene.add(mesh);
    }
    const pass = new RawShaderMaterial({
      glslVersion: GLSL3, vertexShader: SHADE_VERTEX, fragmentShader: SHADE_FRAGMENT, uniforms: this.uniforms, depthTest: false, depthWrite: false,
    });
    const picture = new Mesh(fullPicture(), pass);
    picture.frustumCulled = false;
    this.passScene.add(picture);
  }

  show(state: LandState): void {
    if (state === this.state) return;
    const { rows, cols, min, max, sea } = state.ground;
    const old = this.state?.ground;
    const fits = old && old.rows === rows && old.cols === cols;
    if (!fits) this.resize(rows, cols);
    if (!old || state.ground !== old || state.depth !== this.state!.depth) {
      (this.ground!.image.data as unknown as Float32Array).set(groundTexels(state));
      this.ground!.needsUpdate = true;
      this.version++;
    }
    (this.colours!.image.data as unknown as Uint8Array).set(colourTexels(state));
    this.colours!.needsUpdate = true;
    const materials = materialTexels(state);
    this.uniforms.uMaterial.value = materials ? 1 : 0;
    if (materials) {
      (this.materials!.image.data as unknown as Uint8Array).set(materials);
      this.materials!.needsUpdate = true;
    }
    this.uniforms.uSize.value.set(...extent(state.ground));
    this.uniforms.uNodes.value.set(cols, rows);
    this.uniforms.uRelief.value = Math.max(max - min, 1e-3);
    this.uniforms.uSeaHeight.value = sea === null ? -1e6 : sea - min;
    this.state = state;
  }

  private resize(rows: number, cols: number): void {
    this.ground?.dispose();
    this.colours?.dispose();
    this.materials?.dispose();
    this.ground = new DataTexture(new Float32Array(rows * cols * 2), cols, rows, RGFormat, FloatType);
    this.colours = new DataTexture(new Uint8Array(rows * cols * 4), cols, rows, RGBAFormat, UnsignedByteType);
    this.materials = new DataTexture(new Uint8Array(rows * cols * 4), cols, rows, RGBAFormat, UnsignedByteType);
    for (const texture of [this.ground, this.colours, this.materials]) {
      texture.minFilter = texture.magFilter = LinearFilter;
      texture.wrapS = texture.wrapT = ClampToEdgeWrapping;
      texture.generateMipmaps = false;
    }
    this.uniforms.tGround.value = this.ground;
    this.uniforms.tColour.value = this.colours;
    this.uniforms.tMaterial.value = this.materials;
    this.shade.setSize(cols, rows);
    this.roughShade.setSize(Math.ceil(cols / 2), Math.ceil(rows / 2));
    const squares = (n: number, most: number) => Math.max(1, Math.min(n - 1, most));
    const [across, down] = [squares(cols, this.mostSquares), squares(rows, this.mostSquares)];
    this.disposeMeshes();
    this.grids = { fine: surfaceGrid(across, down), rough: surfaceGrid(squares(cols, ROUGH_SQUARES), squares(rows, ROUGH_SQUARES)) };
    this.walls.geometry = wallStrip(across, down);
  }

  /** Sets all that a picture needs and draws light and shadow, if they have changed. */
  prepare(renderer: WebGLRenderer, drawn: Drawn, eye: [number, number, number], viewProjection: Matrix4, effort: Effort): void {
    const u = this.uniforms;
    const { azimuth, height } = drawn.light;
    u.uSun.value.set(Math.sin(azimuth) * Math.cos(height), Math.cos(azimuth) * Math.cos(height), Math.sin(height));
    u.uTall.value = drawn.tall;
    u.uEye.value.set(...eye);
    u.uViewProjection.value.copy(viewProjection);
    u.uSnow.value = drawn.snow;
    u.uLook.value = LOOKS[drawn.look];
    u.uContour.value = drawn.contour;
    u.uHaze.value = drawn.haze;
    u.uDetail.value = drawn.detail ? 1 : 0;
    u.uBrush.value.set(...drawn.brush);
    u.uFoot.value = -0.05 * Math.max(u.uSize.value.x, u.uSize.value.y);
    [u.uDirections.value, u.uRays.value] = EFFORTS[effort]!;
    const key = `${this.version} ${azimuth} ${height} ${drawn.tall}`;
    this.surface.geometry = effort === 0 ? this.grids.rough : this.grids.fine;
    const target = effort === 0 ? this.roughShade : this.shade;
    u.tShade.value = target.texture;
    u.uQuick.value = effort === 0 ? 1 : 0;
    // Better light than asked for stays.
    if (this.shadedFor.startsWith(`${key} `) && Number(this.shadedFor.split(" ").at(-1)) >= effort) {
      if (effort === 0 && !this.shadedFor.endsWith(" 0")) u.tShade.value = this.shade.texture;
      return;
    }
    this.shadedFor = `${key} ${effort}`;
    renderer.setRenderTarget(target);
    renderer.render(this.passScene, this.passCamera);
    renderer.setRenderTarget(null);
  }

  /** Makes all anew at the next picture: the graphics card has lost what it had. */
  forget(): void {
    this.shadedFor = "";
    this.state = null;
    this.ground?.dispose();
    this.ground = null;
  }

  dispose(): void {
    this.ground?.dispose();
    this.colours?.dispose();
    this.materials?.dispose();
    this.shade.dispose();
    this.roughShade.dispose();
    this.disposeMeshes();
  }

  private disposeMeshes(): void {
    this.grids.fine.dispose();
    this.grids.rough.dispose();
    this.walls.geometry.dispose();
  }
}
