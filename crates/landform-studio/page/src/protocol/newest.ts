/** Sends the newest value of each key, in the order of the keys, with one on its way at a time. */
export class Newest<T> {
  private busy = false;
  private readonly waiting = new Map<string, T>();
  constructor(private readonly send: (value: T) => Promise<unknown>) {}

  push(key: string, value: T): void {
    this.waiting.set(key, value);
    if (!this.busy) void this.run();
  }

  private async run(): Promise<void> {
    this.busy = true;
    for (;;) {
      const next = this.waiting.entries().next();
      if (next.done) break;
      const [key, value] = next.value;
      this.waiting.delete(key);
      await this.send(value);
    }
    this.busy = false;
  }
}
