// The picture in three dimensions: draws when something has changed, coarser while it moves where the machine is slow.
import { GLSL3, LinearFilter, Matrix4, Mesh, OrthographicCamera, PerspectiveCamera, RawShaderMaterial, Scene, WebGLRenderer, WebGLRenderTarget } from "three";
import { extent } from "../model/raster.ts";
import { eye, FIELD_OF_VIEW, homeView, type Orbit } from "./camera.ts";
import { drawsInSoftware, whenDone } from "./gpu.ts";
import { fullPicture } from "./mesh.ts";
import { COPY_FRAGMENT, SKY_FRAGMENT, SKY_VERTEX } from "./shaders.ts";
import type { LandState } from "./state.ts";
import { Terrain, type Drawn } from "./terrain.ts";

/** A second state to the right of `split` (0 to 1 of the width), or in place of the first. */
export interface Beside {
  state: LandState;
  split: number;
}

export class LandView {
  private readonly renderer: WebGLRenderer;
  private readonly camera = new PerspectiveCamera((FIELD_OF_VIEW * 180) / Math.PI, 1, 1, 10);
  private readonly first: Terrain;
  private second: Terrain | null = null;
  private readonly sky = new Scene();
  /** Pictures in fewer pixels, while things move and the processor draws; and the picture that enlarges them. */
  private readonly rough = new WebGLRenderTarget(1, 1, { minFilter: LinearFilter, magFilter: LinearFilter });
  private readonly enlarge = new Scene();
  private held = false;
  private lastTook = 0;
  private readonly flat = new OrthographicCamera();
  private readonly horizon = { value: 0.6 };
  /** Whether pictures are made by the processor: then fewer pixels while moving. */
  readonly software: boolean;
  private quick = false;
  /** The picture that is on its way; 0: none. */
  private drawing = 0;
  /** Whether another is wanted after it. */
  private asked = false;
  private settle: number | undefined;
  private size: [number, number] = [1, 1];
  state: LandState | null = null;
  beside: Beside | null = null;
  orbit: Orbit | null = null;
  drawn: Drawn | null = null;
  /** Called when a picture of the newest state is begun. */
  onBegin: () => void = () => {};
  /** Called after each picture, with the milliseconds that it took. */
  onDrawn: (milliseconds: number) => void = () => {};

  constructor(readonly canvas: HTMLCanvasElement) {
    this.software = drawsInSoftware();
    const context = canvas.getContext("webgl2", { alpha: false, stencil: false, antialias: !this.software, powerPreference: "high-performance", preserveDrawingBuffer: false });
    if (!context) throw new Error("This browser has no WebGL 2. The map still works.");
    this.renderer = new WebGLRenderer({ canvas, context });
    this.renderer.autoClear = false;
    this.first = new Terrain(this.squares());
    this.camera.up.set(0, 0, 1);
    canvas.addEventListener("webglcontextrestored", () => {
      this.first.forget();
      this.second?.forget();
      this.redraw();
    });
    const sky = new Mesh(fullPicture(), new RawShaderMaterial({
      glslVersion: GLSL3, vertexShader: SKY_VERTEX, fragmentShader: SKY_FRAGMENT, uniforms: { uHorizon: this.horizon }, depthTest: false, depthWrite: false,
    }));
    const enlarge = new Mesh(fullPicture(), new RawShaderMaterial({
      glslVersion: GLSL3, vertexShader: SKY_VERTEX, fragmentShader: COPY_FRAGMENT, uniforms: { tPicture: { value: this.rough.texture } }, depthTest: false, depthWrite: false,
    }));
    sky.frustumCulled = enlarge.frustumCulled = false;
    this.sky.add(sky);
    this.enlarge.add(enlarge);
    window.addEventListener("pointerdown", this.hold, true);
    window.addEventListener("pointerup", this.letGo, true);
    window.addEventListener("pointercancel", this.letGo, true);
  }

  private readonly hold = (): void => void (this.held = true);
  private readonly letGo = (): void => void (this.held = false);

  private squares(): number {
    return this.software ? 192 : 1024;
  }

  resize(width: number, height: number): void {
    this.size = [Math.max(1, width), Math.max(1, height)];
    this.redraw();
  }

  /** The view in which the whole land is seen. */
  home(): Orbit | null {
    if (!this.state || !this.drawn) return null;
    const [w, h] = extent(this.state.ground);
    return homeView(w, h, (this.state.ground.max - this.state.ground.min) * this.drawn.tall, this.size[0] / this.size[1]);
  }

  /** Asks for a picture; many calls before the next one make one picture. `quick`: something moves. */
  redraw(quick = false): void {
    window.clearTimeout(this.settle);
    if (quick) this.settleLater();
    this.quick = this.asked ? this.quick && quick : quick;
    this.asked = true;
    if (!this.drawing) this.begin();
  }

  /** Draws well when nothing has moved for a while and no button is held down. */
  private settleLater(): void {
    const rest = this.software ? Math.max(600, 3 * this.lastTook) : 180;
    this.settle = window.setTimeout(() => (this.held ? this.settleLater() : this.redraw()), rest);
  }

  /** One picture is on its way at a time: else slow machines would queue up pictures that nobody waits for. */
  private begin(): void {
    this.drawing = requestAnimationFrame(() => {
      const start = performance.now();
      this.asked = false;
      this.onBegin();
      this.draw(this.quick);
      whenDone(this.renderer.getContext() as WebGL2RenderingContext, () => {
        this.drawing = 0;
        this.lastTook = performance.now() - start;
        this.onDrawn(this.lastTook);
        if (this.asked) this.begin();
      });
    });
  }

  private draw(quick: boolean): void {
    const { renderer, camera, state, drawn } = this;
    const [width, height] = this.size;
    const ratio = this.software ? 1 : Math.min(window.devicePixelRatio || 1, 2);
    this.setSize(Math.round(width * ratio), Math.round(height * ratio));
    const rough = quick && this.software;
    const target = rough ? this.rough : null;
    if (rough) this.rough.setSize(Math.ceil(this.canvas.width / 2), Math.ceil(this.canvas.height / 2));
    this.orbit ??= this.home();
    const orbit = this.orbit;
    if (!state || !drawn || !orbit) {
      renderer.setScissorTest(false);
      renderer.clear();
      renderer.render(this.sky, this.flat);
      return;
    }
    const at = eye(orbit);
    const [w, h] = extent(state.ground);
    const tall = (state.ground.max - state.ground.min) * drawn.tall;
    const reach = Math.hypot(w, h) + tall;
    camera.aspect = width / height;
    camera.near = Math.max(orbit.distance * 0.02, reach * 0.0005);
    camera.far = orbit.distance + reach * 2;
    camera.position.set(...at);
    camera.lookAt(...orbit.target);
    camera.updateProjectionMatrix();
    camera.updateMatrixWorld();
    this.horizon.value = 0.5 + Math.tan(orbit.pitch) / (2 * Math.tan(FIELD_OF_VIEW / 2));
    const viewProjection = new Matrix4().multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse);

    const effort = rough ? 0 : this.software ? 1 : 2;
    this.first.show(state);
    this.first.prepare(renderer, drawn, at, viewProjection, effort);
    if (this.beside) {
      this.second ??= new Terrain(this.squares());
      this.second.show(this.beside.state);
      this.second.prepare(renderer, drawn, at, viewProjection, effort);
    }
    renderer.setRenderTarget(target);
    this.drawScenes(target ? target.width : this.canvas.width, target ? target.height : this.canvas.height);
    renderer.setRenderTarget(null);
    if (target) renderer.render(this.enlarge, this.flat);
  }

  /** The sky, and the land or two lands side by side. */
  private drawScenes(wide: number, high: number): void {
    const { renderer, camera } = this;
    const cut = (left: number, right: number) => {
      if (renderer.getRenderTarget()) {
        this.rough.scissorTest = true;
        this.rough.scissor.set(left, 0, right - left, high);
        renderer.setRenderTarget(this.rough);
      } else {
        renderer.setScissorTest(true);
        renderer.setScissor(left, 0, right - left, high);
      }
    };
    this.rough.scissorTest = false;
    renderer.setScissorTest(false);
    renderer.clear();
    renderer.render(this.sky, this.flat);
    if (!this.beside || !this.second) return void renderer.render(this.first.scene, camera);
    const middle = Math.round(wide * this.beside.split);
    if (middle > 0) {
      cut(0, middle);
      renderer.render(this.first.scene, camera);
    }
    if (middle < wide) {
      cut(middle, wide);
      renderer.render(this.second.scene, camera);
    }
    this.rough.scissorTest = false;
    renderer.setScissorTest(false);
  }

  /** Only when it changes: setting a canvas's size makes its memory anew. */
  private setSize(width: number, height: number): void {
    if (this.canvas.width === width && this.canvas.height === height) return;
    this.renderer.setPixelRatio(1);
    this.renderer.setSize(width, height, false);
  }

  /** The ray under a place of the picture (parts of its width and height from the top left). */
  ray(x: number, y: number): { from: [number, number, number]; way: [number, number, number] } | null {
    if (!this.orbit) return null;
    const inverse = new Matrix4().multiplyMatrices(this.camera.projectionMatrix, this.camera.matrixWorldInverse).invert();
    const at = (depth: number) => project(inverse, x * 2 - 1, 1 - y * 2, depth);
    const from = at(-1), to = at(1);
    const length = Math.hypot(to[0] - from[0], to[1] - from[1], to[2] - from[2]);
    return { from, way: [(to[0] - from[0]) / length, (to[1] - from[1]) / length, (to[2] - from[2]) / length] };
  }

  dispose(): void {
    window.removeEventListener("pointerdown", this.hold, true);
    window.removeEventListener("pointerup", this.letGo, true);
    window.removeEventListener("pointercancel", this.letGo, true);
    this.asked = false;
    this.rough.dispose();
    cancelAnimationFrame(this.drawing);
    window.clearTimeout(this.settle);
    this.first.dispose();
    this.second?.dispose();
    this.renderer.dispose();
  }
}

function project(m: Matrix4, x: number, y: number, z: number): [number, number, number] {
  const e = m.elements;
  const w = e[3]! * x + e[7]! * y + e[11]! * z + e[15]!;
  return [
    (e[0]! * x + e[4]! * y + e[8]! * z + e[12]!) / w,
    (e[1]! * x + e[5]! * y + e[9]! * z + e[13]!) / w,
    (e[2]! * x + e[6]! * y + e[10]! * z + e[14]!) / w,
  ];
}
