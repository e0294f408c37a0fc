/* ---- search ---- */

/// The words of a line, those of a row cell by cell.
function words(line) {
  const steps = (cell) => Array.from(cell.querySelectorAll("li"), (step) => step.textContent).join("; ");
  const cells = line.cells === undefined ? [line.textContent] : Array.from(line.cells, (cell) => steps(cell) || cell.textContent);
  return cells.map((cell) => cell.trim().replace(/\s+/g, " ")).filter(Boolean).join(" · ");
}

/// Lines that can be found.
const lines = Array.from(document.querySelectorAll("main :is(h1, h2, h3, h4, li, p, tbody tr)"))
  .filter((line) => !line.closest("#decoders, #filters") && !line.matches("td li"))
  .map((line) => ({ line, text: words(line).toLowerCase(), weight: line.matches("h1, h2, h3, h4") ? 0 : 1 }));

/// What is found, headings first; each with all of the words, and shown as things are chosen.
function search(text) {
  const asked = text.toLowerCase().split(/\s+/).filter(Boolean);
  if (asked.length === 0) return [];
  const found = lines.filter((one) => asked.every((word) => one.text.includes(word)) && !one.line.closest("[hidden], .out"));
  return found.sort((one, other) => one.weight - other.weight);
}

const MOST = 60;

function listHits() {
  const none = byId("search").value.trim() === "";
  const found = search(byId("search").value);
  const hits = found.slice(0, MOST).map(({ line }) => {
    const item = element("li");
    const link = element("a", words(line).slice(0, 160));
    link.href = "#";
    link.addEventListener("click", (event) => { event.preventDefault(); go(line); });
    item.append(link);
    return item;
  });
  byId("found").hidden = none;
  byId("count").textContent = found.length > MOST ? `${found.length} found, the first ${MOST}:` : `${found.length} found`;
  show("hits", ...hits);
}

function go(line) {
  byId("found").hidden = true;
  document.querySelectorAll(".found").forEach((old) => old.classList.remove("found"));
  line.classList.add("found");
  line.scrollIntoView({ block: "center" });
  share(line.id || line.querySelector("[id]")?.id || placeAround(line));
}

/// The place of the section that a line stands in.
function placeAround(line) {
  const section = line.closest("section");
  return section === null ? undefined : section.querySelector("[id]")?.id ?? placeAround(section.parentElement);
}

/// Up and down among what was found.
function moveAmongHits(event) {
  const links = Array.from(byId("hits").querySelectorAll("a"));
  const at = links.indexOf(document.activeElement);
  const next = event.key === "ArrowDown" ? at + 1 : at - 1;
  event.preventDefault();
  (links[next] ?? byId("search")).focus();
}
