// The connection: requests and their answers, frames and their acknowledgements. It comes back by itself.
import { decodeFrame, FrameError, type Frame } from "./frame.ts";
import type { Asked, Told } from "./messages.ts";

export type Answer = { ok: true; text?: string } | { ok: false; what: string; hint: string | null };

export interface Listener {
  told(message: Told): void;
  frame(frame: Frame): void;
  connected(open: boolean): void;
  trouble(text: string): void;
}

export class Session {
  private socket: WebSocket | null = null;
  private next = 1;
  private readonly waiting = new Map<number, (answer: Answer) => void>();
  private tries = 0;
  /** Frames are decoded one after the other, so that they arrive in order. */
  private queue: Promise<void> = Promise.resolve();

  constructor(private readonly address: string, private readonly listener: Listener) {}

  open(): void {
    const socket = new WebSocket(this.address);
    socket.binaryType = "arraybuffer";
    this.socket = socket;
    socket.onopen = () => {
      this.tries = 0;
      this.listener.connected(true);
      void this.ask({ do: "hello", protocol: 1 });
    };
    socket.onmessage = ({ data }) => {
      if (typeof data === "string") this.hear(data);
      else this.queue = this.queue.then(() => this.take(data as ArrayBuffer));
    };
    socket.onclose = () => {
      this.listener.connected(false);
      for (const answer of this.waiting.values()) answer({ ok: false, what: "the connection was lost", hint: null });
      this.waiting.clear();
      window.setTimeout(() => this.open(), Math.min(5000, 250 * 2 ** this.tries++));
    };
  }

  /** Asks for something; the answer never fails, it tells. */
  ask(message: Asked): Promise<Answer> {
    const socket = this.socket;
    if (!socket || socket.readyState !== WebSocket.OPEN) return Promise.resolve({ ok: false, what: "the studio is not connected", hint: null });
    const request = this.next++;
    socket.send(JSON.stringify({ ...message, request }));
    return new Promise((resolve) => this.waiting.set(request, resolve));
  }

  private hear(text: string): void {
    let told: Told;
    try {
      told = JSON.parse(text) as Told;
    } catch {
      return this.listener.trouble("the server said something that is not JSON");
    }
    if (told.tell === "done" || told.tell === "refused") {
      const answer = this.waiting.get(told.request);
      this.waiting.delete(told.request);
      answer?.(told.tell === "done" ? { ok: true, text: told.text } : { ok: false, what: told.what, hint: told.hint ?? null });
      return;
    }
    this.listener.told(told);
  }

  private async take(data: ArrayBuffer): Promise<void> {
    try {
      this.listener.frame(await decodeFrame(data));
    } catch (error) {
      this.listener.trouble(error instanceof FrameError ? error.message : `a frame could not be read: ${String(error)}`);
    }
  }
}
