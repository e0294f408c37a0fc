"use strict";

// The facts of the page. They reach it as text only, through `textContent`.
const data = JSON.parse(document.getElementById("data").textContent);
const byId = (id) => document.getElementById(id);
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

/// The raw value of a field of process data, from bytes as they travel; none if they end before it.
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

/* ---- the page ---- */

function element(name, text) {
  const made = document.createElement(name);
  if (text !== undefined) made.textContent = text;
  return made;
}

/// A table of texts.
function table(titles, rows) {
  const made = element("table");
  const row = (cells, name) => {
    const line = element("tr");
    line.append(...cells.map((cell) => element(name, String(cell))));
    return line;
  };
  const head = element("thead");
  head.append(row(titles, "th"));
  const body = element("tbody");
  body.append(...rows.map((cells) => row(cells, "td")));
  made.append(head, body);
  return made;
}

function options(select, items) {
  select.replaceChildren(...items.map(([value, text]) => Object.assign(element("option", text), { value })));
}

function show(id, ...what) {
  byId(id).replaceChildren(...what);
}

function decodeWord() {
  const text = byId("word-value").value;
  const value = number(text);
  const word = member.words[byId("word").selectedIndex];
  if (word === undefined || text.trim() === "") return show("word-out");
  if (value === null || value < 0n || value > mask(word.bits)) {
    return show("word-out", element("p", `${text} is no word of ${word.bits} bits`));
  }
  const mode = member.modes[byId("mode").selectedIndex - 1];
  const rows = fields(word, mode).filter((field) => !field.reserved || part(field, value)[0] !== 0).map((field) => {
    const bits = field.low === field.high ? field.low : `${field.low}–${field.high}`;
    return [bits, field.name, ...part(field, value)];
  });
  const shown = word.id === "statusword" ? states(Number(value)) : [];
  const state = word.id !== "statusword" ? "" : `: ${shown.length === 0 ? "no state that is described" : shown.join(", ")}`;
  show("word-out", element("p", hex(value, word.bits / 4) + state), table(["Bit", "Name", "Is", "Meaning"], rows));
}

const LISTS = [["errors", "Error code"], ["vendor_codes", "The vendor's code"], ["al_status_codes", "AL status code"]];

function decodeCode() {
  const text = byId("code-value").value;
  const code = number(text);
  const list = member[byId("code-kind").value];
  if (list === undefined || text.trim() === "") return show("code-out");
  const found = code === null ? [] : codes(list, code);
  if (found.length === 0) return show("code-out", element("p", `${text} is not described`));
  show("code-out", ...found.map((one) => {
    const line = element("p");
    line.append(element("strong", one.name), [one.about, one.remedy].filter(Boolean).map((more) => ` ${more}`).join(""));
    return line;
  }));
}

function decodePdo() {
  const text = byId("pdo-value").value.replace(/0x|[\s,;_]/gi, "");
  const pdo = member.pdos[byId("pdo").selectedIndex];
  if (pdo === undefined || text === "") return show("pdo-out");
  if (!/^([0-9a-f]{2})+$/i.test(text)) return show("pdo-out", element("p", "bytes are pairs of hexadecimal digits"));
  const bytes = text.match(/../g).map((pair) => parseInt(pair, 16));
  const rows = pdo.fields.map((field) => {
    const value = raw(field, bytes);
    const digits = value === null ? "" : hex(value & mask(field.bits), Math.ceil(field.bits / 4));
    return [field.address, field.name, value ?? "–", digits, value === null ? "" : physical(value, unitOn(field.unit, field.axis))];
  });
  const wanted = Math.ceil(pdo.bits / 8);
  const length = bytes.length === wanted ? [] : [element("p", `the PDO has ${wanted} bytes, these are ${bytes.length}`)];
  show("pdo-out", ...length, table(["Object", "Name", "Value", "Hexadecimal", "Physical"], rows));
}

/// The quantities that have a scale, for each axis on which it is another.
function scaled() {
  return member.units.flatMap((unit) => unit.axes
    .map((on, axis) => ({ unit, on, axis }))
    .filter(({ on }, place, all) => on.raw !== null && all.findIndex((other) => JSON.stringify(other.on) === JSON.stringify(on)) === place));
}

function convert(fromRaw) {
  const choice = scaled()[byId("unit").selectedIndex];
  const given = byId(fromRaw ? "raw" : "physical").value;
  if (choice === undefined || given.trim() === "") return show("unit-out");
  const value = fromRaw ? number(given) : steps(given, choice.on);
  if (value === null) return show("unit-out", element("p", `${given} is no number`));
  if (fromRaw) byId("physical").value = physical(value, choice.on).replace(/ .*$/, "");
  else byId("raw").value = String(value);
  show("unit-out", element("p", `${value} raw = ${physical(value, choice.on)}`));
}

/* ---- search ---- */

/// Lines that can be found, with the place in front of each.
const lines = Array.from(document.querySelectorAll("main :is(h1, h2, h3, h4, li, p, tbody tr)"))
  .filter((line) => !line.closest("#decoders"))
  .map((line) => ({ line, text: line.textContent.toLowerCase(), weight: line.matches("h1, h2, h3, h4") ? 0 : 1 }));

function search(text) {
  const words = text.toLowerCase().split(/\s+/).filter(Boolean);
  if (words.length === 0) return [];
  const found = lines.filter((one) => words.every((word) => one.text.includes(word)));
  return found.sort((one, other) => one.weight - other.weight).slice(0, 60);
}

function listHits() {
  const hits = search(byId("search").value).map(({ line }) => {
    const item = element("li");
    const link = element("a", line.textContent.trim().replace(/\s+/g, " ").slice(0, 160));
    link.href = "#";
    link.addEventListener("click", (event) => { event.preventDefault(); go(line); });
    item.append(link);
    return item;
  });
  const none = byId("search").value.trim() === "";
  byId("hits").hidden = none;
  show("hits", ...(hits.length > 0 || none ? hits : [element("li", "nothing found")]));
}

function go(line) {
  byId("hits").hidden = true;
  document.querySelectorAll(".found").forEach((old) => old.classList.remove("found"));
  line.classList.add("found");
  line.scrollIntoView({ block: "center" });
  const anchor = line.id || line.querySelector("[id]")?.id;
  if (anchor) history.replaceState(null, "", "#" + anchor);
}

/* ---- begin ---- */

function choose(number) {
  member = data.members[number];
  options(byId("word"), member.words.map((word) => [word.id, word.name]));
  options(byId("mode"), [["", "any"]].concat(member.modes.map((mode) => [mode.code, `${mode.code} ${mode.name}`])));
  options(byId("code-kind"), LISTS.filter(([list]) => member[list].length > 0));
  options(byId("pdo"), member.pdos.map((pdo) => [pdo.index, `${pdo.index} ${pdo.name}`]));
  options(byId("unit"), scaled().map(({ unit, on, axis }) => {
    const name = unit.axes.length > 1 ? ` (${member.axes[axis]})` : "";
    return [unit.id, `${unit.quantity}${name}, ${on.symbol}`];
  }));
  byId("word-form").hidden = member.words.length === 0;
  byId("code-form").hidden = LISTS.every(([list]) => member[list].length === 0);
  byId("pdo-form").hidden = member.pdos.length === 0;
  byId("unit-form").hidden = scaled().length === 0;
  const status = member.words.findIndex((word) => word.id === "statusword");
  byId("word").selectedIndex = Math.max(status, 0);
  decodeWord(); decodeCode(); decodePdo();
}

/// A decoded value as a link: `#word=statusword&value=0x0637`, and likewise `code`, `pdo`, `member`.
function fromLink() {
  const query = new URLSearchParams(location.hash.slice(1));
  const chosen = data.members.findIndex((one) => one.id === query.get("member"));
  if (chosen >= 0) { byId("member").selectedIndex = chosen; choose(chosen); }
  const decoders = { word: ["word", "word-value", decodeWord], code: ["code-kind", "code-value", decodeCode], pdo: ["pdo", "pdo-value", decodePdo] };
  for (const [key, [select, input, decode]] of Object.entries(decoders)) {
    if (!query.has(key)) continue;
    byId(select).value = query.get(key);
    byId(input).value = query.get("value") ?? "";
    decode();
    byId("decoders").scrollIntoView();
  }
}

document.querySelectorAll(".script").forEach((part) => { part.hidden = false; });
options(byId("member"), data.members.map((one) => [one.id, one.name]));
byId("member").parentElement.hidden = data.members.length < 2;
byId("member").addEventListener("change", (event) => choose(event.target.selectedIndex));
byId("search").addEventListener("input", listHits);
byId("word-form").addEventListener("input", decodeWord);
byId("code-form").addEventListener("input", decodeCode);
byId("pdo-form").addEventListener("input", decodePdo);
byId("unit-form").addEventListener("input", (event) => convert(event.target.id !== "physical"));
document.querySelectorAll("form").forEach((form) => form.addEventListener("submit", (event) => event.preventDefault()));
byId("scheme").addEventListener("click", () => {
  const root = document.documentElement;
  const dark = root.classList.contains("dark") || (!root.classList.contains("light") && matchMedia("(prefers-color-scheme: dark)").matches);
  root.classList.toggle("dark", !dark);
  root.classList.toggle("light", dark);
});
document.addEventListener("keydown", (event) => {
  const typing = event.target.matches("input, select");
  if (event.key === "/" && !typing) { event.preventDefault(); byId("search").focus(); }
  if (event.key === "Escape") byId("hits").hidden = true;
  if (event.key === "Enter" && event.target === byId("search")) byId("hits").querySelector("a")?.click();
});
addEventListener("hashchange", fromLink);
choose(0);
fromLink();
