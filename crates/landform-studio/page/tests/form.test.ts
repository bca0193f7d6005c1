import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { bytesText, numberIn, numberText, parseQuantity, quantityValue, timeText, unitSize } from "../src/form/quantity.ts";
import { Forms, type Field, type Schema } from "../src/form/schema.ts";
import { numberAt, positionOf, widened } from "../src/form/slider.ts";
import { parseToml, tomlText, TomlError } from "../src/form/toml.ts";

test("quantities: number and unit of the text", () => {
  assert.deepEqual(parseQuantity("5 mm/yr"), { number: 5, unit: "mm/yr" });
  assert.deepEqual(parseQuantity("5.6e-7 1/yr"), { number: 5.6e-7, unit: "1/yr" });
  assert.deepEqual(parseQuantity("2.5km"), { number: 2.5, unit: "km" });
  assert.deepEqual(parseQuantity("20_000 m"), { number: 20000, unit: "m" });
  assert.deepEqual(parseQuantity("-100 m"), { number: -100, unit: "m" });
  assert.deepEqual(parseQuantity(0.5), { number: 0.5, unit: "" });
  for (const wrong of ["", "fast", "1e999 m", null, {}, NaN, [1]]) assert.equal(parseQuantity(wrong), null);
});

test("units are turned into each other, and lengths never into times", () => {
  const inUnit = (text: string, unit: string) => numberIn(parseQuantity(text)!, unit);
  assert.ok(Math.abs(inUnit("1 m/kyr", "mm/yr")! - 1) < 1e-12);
  assert.ok(Math.abs(inUnit("1 m2/s", "m2/yr")! - 31_557_600) < 1e-3);
  assert.ok(Math.abs(inUnit("0.01 m²/yr", "m^2/yr")! - 0.01) < 1e-12);
  assert.equal(inUnit("250 kyr", "Myr"), 0.25);
  assert.equal(inUnit("5 m", "yr"), null);
  assert.equal(inUnit("5 furlong", "m"), null);
  assert.equal(unitSize("m/yr/yr")?.time, -2);
});

test("numbers are written as a person would", () => {
  assert.equal(quantityValue(0.30000000000000004, "mm/yr"), "0.3 mm/yr");
  assert.equal(quantityValue(5.6e-7, "1/yr"), "5.6e-7 1/yr");
  assert.equal(quantityValue(0.45, ""), 0.45);
  assert.equal(numberText(123456), "123500");
  assert.equal(timeText(0), "0 yr");
  assert.equal(timeText(250_000), "250 kyr");
  assert.equal(timeText(3_100_000), "3.1 Myr");
  assert.equal(bytesText(3 * 2 ** 20), "3 MiB");
});

test("a slider's number and position belong together, on both scales", () => {
  for (const scale of [{ low: 0, high: 5, log: false }, { low: 1e-4, high: 10, log: true }, { low: -50, high: 50, log: false }]) {
    for (let i = 0; i <= 20; i++) {
      const number = numberAt(i / 20, scale);
      assert.ok(Math.abs(positionOf(number, scale) - i / 20) < 0.003, `${JSON.stringify(scale)} ${i}`);
    }
    assert.equal(numberAt(0, scale), scale.low);
    assert.equal(numberAt(1, scale), scale.high);
  }
  assert.deepEqual(widened({ low: 1, high: 10, log: true }, 100), { low: 1, high: 100, log: true });
  assert.deepEqual(widened({ low: 1, high: 10, log: true }, 0), { low: 1, high: 10, log: true });
  assert.equal(positionOf(1e9, { low: 0, high: 5, log: false }), 1);
  assert.equal(numberAt(0.5, { low: 0, high: 5, log: false }, true), 3);
});

const schema = JSON.parse(readFileSync("tests/schema.json", "utf8")) as Schema;

const choicesOf = (f?: Field) => (f?.kind.is === "choice" ? f.kind.choices.map((c) => c.value) : null);

test("forms follow the schema", () => {
  const forms = new Forms(schema);
  const power = new Map(forms.stage("stream_power", true).map((f) => [f.key, f]));
  assert.equal(power.get("erodibility")?.kind.is, "quantity");
  assert.equal(power.get("erodibility")?.varying, true);
  assert.equal(power.get("erodibility")?.optional, true);
  assert.deepEqual(power.get("erodibility")?.slider, { low: 1e-8, high: 1e-3, log: true });
  assert.deepEqual(power.get("area_exponent")?.kind, { is: "number", whole: false });
  assert.equal(power.get("specific_area")?.kind.is, "switch");
  assert.deepEqual(choicesOf(power.get("descent")), ["steepest", "lowest"]);
  assert.equal(power.get("outlets")?.kind.is, "any");
  assert.equal(power.has("use") || power.has("clock"), false);
  const graph = new Map(forms.stage("stream_graph").map((f) => [f.key, f]));
  assert.deepEqual(graph.get("size")?.kind, { is: "list", count: 2, unit: "m", bare: true });
  assert.equal(graph.get("open")?.kind.is, "choices");
  const noise = new Map(forms.stage("spectral_fbm").map((f) => [f.key, f]));
  assert.equal(noise.get("grid")?.kind.is, "group");
  assert.equal(noise.get("deviation")?.slider?.log, true);
  assert.deepEqual(forms.clock("evolve").slice(0, 2).map((f) => f.key), ["dt", "duration"]);
  assert.ok(forms.environment().some((f) => f.key === "sea_level"));
  assert.equal(forms.isProcess("uplift"), true);
  assert.equal(forms.isProcess("crop"), false);
  assert.deepEqual(forms.stage("no_such_stage"), []);
});

test("inline values of TOML are read as they are written", () => {
  const value = { formula: "0.4*(1 - r)", unit: "mm/yr", at: [1, 2.5, -3e-7], deep: { on: true, "a b": 'say "x"' } };
  assert.deepEqual(parseToml(tomlText(value)), value);
  assert.deepEqual(parseToml("[ 'a', \"b\", ]"), ["a", "b"]);
  assert.equal(parseToml(" 20_000 "), 20000);
  for (const wrong of ["", "[1", "{a 1}", "{a = }", "fast", '"open', "1 2", "{ = 1}", "[".repeat(100)]) assert.throws(() => parseToml(wrong), TomlError, wrong);
});
