/* ---- begin ---- */

/// What decoders and filters offer for the member and the axis that are chosen.
function offer() {
  member = data.members[choice.member ?? 0];
  options(byId("axis"), [["", "all axes"]].concat(axes().map((name) => [name, name])));
  byId("axis").selectedIndex = choice.axis === null ? 0 : choice.axis + 1;
  byId("axis").parentElement.hidden = axes().length < 2;
  const pdos = member.pdos.filter((pdo) => choice.axis === null || pdo.axis === null || pdo.axis === choice.axis);
  options(byId("word"), member.words.map((word) => [word.id, word.name]));
  options(byId("mode"), [["", "any"]].concat(member.modes.map((mode) => [mode.code, `${mode.code} ${mode.name}`])));
  options(byId("code-kind"), LISTS.filter(([list]) => codeList(list).length > 0));
  options(byId("pdo"), pdos.map((pdo) => [pdo.index, `${pdo.index} ${pdo.name}`]));
  options(byId("unit"), scaled().map(({ unit, on, axis }, place) => {
    const name = unit.axes.length > 1 ? ` (${member.axes[axis]})` : "";
    return [place, `${unit.quantity}${name}, ${on.symbol}`];
  }));
  byId("word-form").hidden = member.words.length === 0;
  byId("pdo-form").hidden = pdos.length === 0;
  byId("unit-form").hidden = scaled().length === 0;
  const status = member.words.findIndex((word) => word.id === "statusword");
  byId("word").selectedIndex = Math.max(status, 0);
  byId("decoded").textContent = data.members.length > 1 ? `For ${member.name}.` : "";
  decodeWord(); decodeCode(); decodePdo();
}

function choose(number) {
  choice.member = number;
  if (choice.axis >= axes().length) choice.axis = null;
  byId("member").selectedIndex = number === null ? 0 : number + 1;
  showChoice();
  offer();
}

function chooseAxis(number) {
  choice.axis = number;
  showChoice();
  offer();
}

/// A place or a decoded value by a link: `#member=s400&axis=Y&at=obj-6040`, `#word=statusword&value=0x0637`, and likewise
/// `code` and `pdo`.
function fromLink() {
  const query = new URLSearchParams(location.hash.slice(1));
  const wanted = data.members.findIndex((one) => one.id === query.get("member"));
  if (wanted >= 0) choose(wanted);
  const axis = axes().indexOf(query.get("axis"));
  if (axis >= 0) chooseAxis(axis);
  const decoders = { word: ["word", "word-value", decodeWord], code: ["code-kind", "code-value", decodeCode], pdo: ["pdo", "pdo-value", decodePdo] };
  for (const [key, [select, input, decode]] of Object.entries(decoders)) {
    if (!query.has(key)) continue;
    byId(select).value = query.get(key);
    byId(input).value = query.get("value") ?? "";
    decode();
    byId("decoders").scrollIntoView();
  }
  const place = byId(query.get("at") ?? location.hash.slice(1));
  if (place) (place.closest("[hidden], .out")?.parentElement ?? place).scrollIntoView();
}

/// Makes the page light or dark; the system decides until then.
function turn(scheme) {
  document.documentElement.classList.remove("light", "dark");
  document.documentElement.classList.add(scheme);
}

function isDark() {
  const { classList } = document.documentElement;
  return classList.contains("dark") || (!classList.contains("light") && matchMedia("(prefers-color-scheme: dark)").matches);
}

function key(event) {
  const isTyping = event.target.matches("input, select");
  if (event.key === "/" && !isTyping) { event.preventDefault(); byId("search").focus(); byId("search").select(); }
  if (event.key === "Escape") { byId("found").hidden = true; byId("search").blur(); }
  if (event.key === "Enter" && event.target === byId("search")) byId("hits").querySelector("a")?.click();
  if (/^Arrow(Up|Down)$/.test(event.key) && event.target.closest("#hits, #search") && !byId("found").hidden) moveAmongHits(event);
}

document.querySelectorAll(".script").forEach((part) => { part.hidden = false; });
options(byId("member"), [["", "all members"]].concat(data.members.map((one) => [one.id, one.name])));
options(byId("area"), [["", "all"]].concat(Array.from(document.querySelectorAll("h3[id^='area-']"), (title) => [title.id, title.textContent.trim()])));
byId("member").parentElement.hidden = data.members.length < 2;
byId("filters").hidden = objects.length === 0;
byId("objects")?.after(byId("filters"));
const chosenIn = (select) => (select.selectedIndex === 0 ? null : select.selectedIndex - 1);
byId("member").addEventListener("change", (event) => { choose(chosenIn(event.target)); share(); });
byId("axis").addEventListener("change", (event) => { chooseAxis(chosenIn(event.target)); share(); });
byId("filters").addEventListener("input", (event) => { choice[event.target.name] = event.target.value; showObjects(); });
byId("search").addEventListener("input", listHits);
byId("search").addEventListener("focus", listHits);
byId("word-form").addEventListener("input", decodeWord);
byId("code-form").addEventListener("input", decodeCode);
byId("pdo-form").addEventListener("input", decodePdo);
byId("unit-form").addEventListener("input", (event) => convert(event.target.id !== "physical"));
document.querySelectorAll("form").forEach((form) => form.addEventListener("submit", (event) => event.preventDefault()));
document.querySelector("main").addEventListener("click", (event) => {
  const link = event.target.closest("a.here");
  if (link && chosen().length > 0) { event.preventDefault(); share(link.hash.slice(1)); }
});
byId("scheme").addEventListener("click", () => turn(isDark() ? "light" : "dark"));
document.addEventListener("keydown", key);
addEventListener("hashchange", fromLink);
choose(null);
fromLink();
