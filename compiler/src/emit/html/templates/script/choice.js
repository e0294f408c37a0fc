/* ---- what the reader looks at ---- */

/// A member and an axis by number, none for all of them; and what rows of the dictionary must be.
const choice = { member: null, axis: null, area: "", access: "", pdo: "", said: "" };

/// The numbers or words of an attribute; none if it is not there.
function tokens(part, name) {
  const text = part.dataset[name];
  return text === undefined ? null : text.split(" ");
}

/// What holds for some members or axes only.
const scoped = Array.from(document.querySelectorAll("[data-members], [data-axes]"))
  .map((part) => ({ part, members: tokens(part, "members"), axes: tokens(part, "axes") }));

function holds(numbers, chosen) {
  return numbers === null || chosen === null || numbers.includes(String(chosen));
}

/// Rows of the dictionary: a head for each object, the lines of its entries under it, and the place of its details.
const objects = [];
for (const row of document.querySelectorAll("tr[data-kinds]")) {
  const line = { row, kinds: tokens(row, "kinds"), entries: [], details: [] };
  if (row.cells[0].textContent.startsWith("\u2003")) { objects.at(-1)?.entries.push(line); continue; }
  const anchor = row.querySelector("[id^='obj-']")?.id ?? row.querySelector("a[href^='#obj-']")?.hash.slice(1);
  line.area = row.closest("section");
  line.anchor = anchor;
  const place = anchor && byId(anchor)?.closest("li, section, tr");
  if (place && place !== row) line.details.push(place);
  objects.push(line);
}
for (const row of document.querySelectorAll("#objects ~ section tr:not([data-kinds])")) {
  const anchor = row.querySelector("td:first-child > a[href^='#obj-']")?.hash.slice(1);
  const of = objects.find((line) => line.anchor !== undefined && line.anchor === anchor);
  if (of) of.details.push(row);
}

/// Whether a row is of the kinds that are asked for; what is mapped both ways is mapped either way.
function isAsked(kinds) {
  return (choice.access === "" || kinds.includes(choice.access))
    && (choice.pdo === "" || kinds.includes(choice.pdo) || (choice.pdo !== "unmapped" && kinds.includes("rxtx")))
    && (choice.said === "" || kinds.includes(choice.said));
}

function showObjects() {
  let shown = 0;
  for (const line of objects) {
    const isArea = choice.area === "" || line.area.querySelector("h3")?.id === choice.area;
    const entries = line.entries.filter((entry) => {
      const asked = isArea && isAsked(entry.kinds);
      entry.row.classList.toggle("out", !asked);
      return asked;
    });
    const asked = isArea && (line.entries.length > 0 ? entries.length > 0 : isAsked(line.kinds));
    [line.row, ...line.details].forEach((part) => part.classList.toggle("out", !asked));
    if (asked && line.row.closest("[hidden]") === null) shown += 1;
  }
  document.querySelectorAll("h3[id^='area-']").forEach((title) => {
    title.parentElement.classList.toggle("out", choice.area !== "" && title.id !== choice.area);
  });
  byId("shown").textContent = shown === 1 ? "1 object" : `${shown} objects`;
}

/* ---- indices on an axis ---- */

/// The indices on each axis, by that on the first.
const repeats = Object.assign({}, ...data.members.toReversed().map((one) => one.repeats));

/// Labels that stand for all axes: the first axis's index, in a line that does not name those of the others.
const labels = Array.from(document.querySelectorAll("main code")).flatMap((code) => {
  const [, index, rest] = /^0x([0-9A-F]{4})(:[0-9A-F]{2}|[0-9A-F]{4})?$/.exec(code.textContent) ?? [];
  if (repeats[index] === undefined || code.closest("[data-axes]")) return [];
  const link = code.closest("a[href]");
  const line = code.closest("td, li, p");
  const named = link && line && Array.from(line.querySelectorAll(`a[href="${link.getAttribute("href")}"]`));
  const isMapping = rest?.length === 4 && line?.matches("td:last-child");
  const isPlace = code.parentElement.matches("[id^='obj-'], [id^='pdo-']") || code.previousElementSibling?.matches("[id^='obj-']");
  const leads = isPlace || isMapping || link?.matches("[href^='#obj-'], [href^='#pdo-']");
  if (!leads || (named?.length ?? 0) > 1) return [];
  return [{ code, index, rest: rest ?? "" }];
});

function showAxis() {
  for (const { code, index, rest } of labels) {
    code.textContent = "0x" + (repeats[index][choice.axis ?? 0] ?? index) + rest;
  }
}

/// Shows what holds for the member and the axis that are chosen.
function showChoice() {
  document.body.classList.toggle("one", choice.member !== null);
  for (const { part, members, axes } of scoped) {
    part.hidden = !(holds(members, choice.member) && holds(axes, choice.axis));
  }
  showAxis();
  showObjects();
}

/// The choice as the beginning of a link.
function chosen() {
  const parts = [];
  if (choice.member !== null) parts.push(`member=${data.members[choice.member].id}`);
  if (choice.axis !== null) parts.push(`axis=${encodeURIComponent(axes()[choice.axis])}`);
  return parts;
}

/// Puts a place, with the choice, into the address, so that it can be shared.
function share(anchor) {
  const parts = chosen();
  const link = parts.length === 0 ? anchor ?? "" : parts.concat(anchor ? [`at=${anchor}`] : []).join("&");
  history.replaceState(null, "", link === "" ? location.pathname + location.search : "#" + link);
}

/// The axes of the member that is chosen, or else of that which has most.
function axes() {
  return choice.member !== null ? data.members[choice.member].axes : data.members.map((one) => one.axes).reduce((most, one) => (one.length > most.length ? one : most));
}
