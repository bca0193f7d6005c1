// What is asked of the graphics card apart from pictures.

/** Longest wait for the graphics card, ms. */
const LONGEST_DRAW = 5000;

/** Calls once the graphics card has drawn all that it was given. */
export function whenDone(gl: WebGL2RenderingContext, done: () => void): void {
  const fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
  gl.flush();
  const until = performance.now() + LONGEST_DRAW;
  const look = () => {
    const state = fence && !gl.isContextLost() && performance.now() < until ? gl.clientWaitSync(fence, 0, 0) : gl.ALREADY_SIGNALED;
    if (state === gl.TIMEOUT_EXPIRED) return void window.setTimeout(look, 2);
    if (fence) gl.deleteSync(fence);
    done();
  };
  look();
}

let software: boolean | null = null;

/** Whether the browser draws by the processor; asked once, of a canvas that is thrown away. */
export function drawsInSoftware(): boolean {
  if (software !== null) return software;
  const context = document.createElement("canvas").getContext("webgl2");
  const info = context?.getExtension("WEBGL_debug_renderer_info");
  const name = String(context && info ? context.getParameter(info.UNMASKED_RENDERER_WEBGL) : "");
  context?.getExtension("WEBGL_lose_context")?.loseContext();
  software = /swiftshader|llvmpipe|software|basic render/i.test(name);
  return software;
}
