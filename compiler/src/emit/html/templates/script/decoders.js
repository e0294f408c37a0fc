/* ---- decoders ---- */

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

/// Marks the states in the picture.
function markStates(names) {
  document.querySelectorAll(".machine .state").forEach((state) => {
    state.classList.toggle("shown", names.includes(state.querySelector("text").textContent));
  });
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
  const says = { statusword: [states, "no state that is described"], controlword: [asked, "nothing that is described"] }[word.id];
  const found = says === undefined ? [] : says[0](Number(value));
  const first = hex(value, Math.ceil(word.bits / 4)) + (says === undefined ? "" : `: ${found.join(", ") || says[1]}`);
  if (word.id === "statusword") markStates(found);
  show("word-out", element("p", first), table(["Bit", "Name", "Is", "Meaning"], rows));
}

const LISTS = [["errors", "Error code"], ["vendor_codes", "The vendor's code"], ["al_status_codes", "AL status code"], ["abort_codes", "SDO abort code"]];

/// The codes of a kind; those of transfers are the same for all.
function codeList(kind) {
  return kind === "abort_codes" ? data.abort_codes : member[kind] ?? [];
}

function decodeCode() {
  const text = byId("code-value").value;
  const code = number(text);
  const list = codeList(byId("code-kind").value);
  if (text.trim() === "") return show("code-out");
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
  const pdo = member.pdos.find((one) => one.index === byId("pdo").value);
  if (pdo === undefined || text === "") return show("pdo-out");
  if (!/^([0-9a-f]{2})+$/i.test(text)) return show("pdo-out", element("p", "bytes are pairs of hexadecimal digits"));
  const bytes = text.match(/../g).map((pair) => parseInt(pair, 16));
  const rows = pdo.fields.map((field) => {
    const value = raw(field, bytes);
    const digits = value === null ? "" : hex(value & mask(field.bits), Math.ceil(field.bits / 4));
    if (value === null) return [field.address, field.name, "–", "", "", ""];
    const shown = real(field, value) ?? value;
    return [field.address, field.name, shown, digits, physical(value, unitOn(field.unit, pdo.axis ?? 0)), meaning(field, value)];
  });
  const wanted = Math.ceil(pdo.bits / 8);
  const length = bytes.length === wanted ? [] : [element("p", `the PDO has ${wanted} bytes, these are ${bytes.length}`)];
  show("pdo-out", ...length, table(["Object", "Name", "Value", "Hexadecimal", "Physical", "Meaning"], rows));
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
