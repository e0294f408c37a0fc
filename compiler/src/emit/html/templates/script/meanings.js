"use strict";

// The facts of the page. They reach it as text only, through `textContent`.
const data = JSON.parse(document.getElementById("data").textContent);
const byId = (id) => document.getElementById(id);
/// The member that decoders are for.
let member = data.members[0];

/* ---- numbers ---- */

/// The number that a text stands for: decimal, 0x, 0b, with spaces and underscores; none if it is no number.
function number(text) {
  const plain = text.replace(/[\s_\u00a0\u202f]/g, "").toLowerCase();
  const sign = plain.startsWith("-") ? -1n : 1n;
  const digits = plain.replace(/^[-+]/, "");
  return /^(0x[0-9a-f]+|0b[01]+|\d+)$/.test(digits) ? sign * BigInt(digits) : null;
}

function hex(value, digits) {
  return "0x" + value.toString(16).toUpperCase().padStart(digits, "0");
}

function mask(bits) {
  return (1n << BigInt(bits)) - 1n;
}

/* ---- what things mean ---- */

/// The names of the states that a word shows.
function states(word) {
  return member.states.filter((state) => (word & state.mask) === state.value).map((state) => state.name);
}

/// What a controlword asks for, with the bits that have to change for it.
function asked(word) {
  const bits = (mask) => [...Array(16).keys()].filter((bit) => mask >> bit & 1).join(", ");
  const edge = (mask, how) => (mask === 0 ? "" : ` if bit ${bits(mask)} ${how}`);
  return member.asked.filter((one) => (word & one.mask) === one.value)
    .map((one) => `${one.name} (${one.transitions.join(", ")})` + edge(one.rising, "rises") + edge(one.falling, "falls"));
}

/// The fields of a word in a mode: what the mode says of a bit stands before what the word says.
function fields(word, mode) {
  const own = mode === undefined ? [] : word.id === "controlword" ? mode.control : word.id === "statusword" ? mode.status : [];
  const hidden = (field) => own.some((other) => other.low <= field.high && field.low <= other.high);
  return word.fields.filter((field) => !hidden(field)).concat(own).sort((one, other) => one.low - other.low);
}

/// The value of a field, and what it is called.
function part(field, value) {
  const bits = Number((value >> BigInt(field.low)) & mask(field.high - field.low + 1));
  const known = field.values.find(([number]) => number === bits);
  return [bits, known === undefined ? "" : known[1]];
}

/// The codes of a list that a number is one of.
function codes(list, code) {
  return list.filter((one) => BigInt(one.first) <= code && code <= BigInt(one.last));
}

/// The value of a field of process data, from bytes as they travel; none if they end before it.
function raw(field, bytes) {
  if (field.offset + field.bits > bytes.length * 8) return null;
  let value = 0n;
  for (let bit = field.bits - 1; bit >= 0; bit--) {
    const at = field.offset + bit;
    value = (value << 1n) | BigInt((bytes[at >> 3] >> (at & 7)) & 1);
  }
  const signed = (field.data_type ?? "").startsWith("INT");
  return signed && field.bits > 0 && value >> BigInt(field.bits - 1) ? value - (1n << BigInt(field.bits)) : value;
}

/// What bits are as a number with a fraction, where they are one.
function real(field, bits) {
  const view = new DataView(new ArrayBuffer(8));
  view.setBigUint64(0, BigInt.asUintN(64, bits));
  if (field.data_type === "REAL32") return view.getFloat32(4);
  return field.data_type === "REAL64" ? view.getFloat64(0) : null;
}

/// What a value of process data means: the state that a statusword shows, what a controlword asks for, a value with a name.
function meaning(field, value) {
  if (field.word === "statusword") return states(Number(value)).join(", ");
  if (field.word === "controlword") return asked(Number(value)).join(", ");
  return field.values.find(([known]) => BigInt(known) === value)?.[1] ?? "";
}

/// A raw value in its unit, as text; empty if nothing says what a step is.
function physical(value, unit) {
  return unit === undefined || unit.raw === null ? "" : decimal(value * BigInt(unit.units), BigInt(unit.raw)) + " " + unit.symbol;
}

/// A fraction as a decimal number with at most nine places.
function decimal(numerator, denominator) {
  const sign = numerator < 0n ? "-" : "";
  const size = numerator < 0n ? -numerator : numerator;
  const places = 10n ** 9n;
  const scaled = (size * places * 2n + denominator) / (denominator * 2n);
  const rest = (scaled % places).toString().padStart(9, "0").replace(/0+$/, "");
  return sign + scaled / places + (rest === "" ? "" : "." + rest);
}

/// The raw value that comes nearest to a physical one; none if that is no decimal number.
function steps(text, unit) {
  const match = /^([-+]?)(\d*)(?:[.,](\d*))?$/.exec(text.replace(/[\s_\u00a0\u202f]/g, ""));
  if (match === null || unit.raw === null || (match[2] + (match[3] ?? "")) === "") return null;
  const places = match[3] ?? "";
  const scaled = BigInt(match[2] + places) * BigInt(unit.raw);
  const divisor = 10n ** BigInt(places.length) * BigInt(unit.units);
  const value = (scaled * 2n + divisor) / (divisor * 2n);
  return match[1] === "-" ? -value : value;
}

function unitOn(id, axis) {
  const unit = member.units.find((one) => one.id === id);
  return unit === undefined ? undefined : unit.axes[axis] ?? unit.axes[0];
}
