import assert from "node:assert/strict";
import { test } from "node:test";
import { Newest } from "../src/protocol/newest.ts";

test("one is on its way, the newest of each key waits, none of another key is lost", async () => {
  const sent: string[] = [];
  let release: () => void = () => {};
  const newest = new Newest<string>((value) => {
    sent.push(value);
    return new Promise<void>((done) => (release = done));
  });
  const turn = () => new Promise((done) => setImmediate(done));
  newest.push("rate", "rate 1");
  newest.push("rate", "rate 2");
  newest.push("angle", "angle 1");
  newest.push("rate", "rate 3");
  assert.deepEqual(sent, ["rate 1"]);
  for (let i = 0; i < 4; i++) {
    release();
    await turn();
  }
  assert.deepEqual(sent, ["rate 1", "rate 3", "angle 1"]);
  newest.push("rate", "rate 4");
  await turn();
  assert.equal(sent.at(-1), "rate 4");
});
