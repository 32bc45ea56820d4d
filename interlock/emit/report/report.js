"use strict";
const data = JSON.parse(document.getElementById("data").textContent);
const rows = [...document.querySelectorAll("#routes tr")];
const why = document.getElementById("why");
const ofRow = rows.map(() => []); // the routes of a row: one, or one for each of its overlaps
data.routes.forEach((r, i) => ofRow[r.row].push(i));
const byId = new Map(data.routes.map((r, i) => [r.id, i]));
const groups = data.groups.map(([how, ...told]) => [how, told.flatMap((k, at) => // 4, -9 is 4 to 9
  k >= 0 ? [k] : Array.from({length: -k - told[at - 1]}, (_, n) => told[at - 1] + 1 + n))]);
// a way over a slip rail lights the rail, and its legs as far as the blades: no train runs through the middle of the diamond
function trodden(edges) {
  const those = new Set(edges), more = [];
  for (const { id, dataset: { from, to, past } } of document.querySelectorAll("#plan .rail[data-from]")) if (those.has(from) && those.has(to)) {
    for (const e of [from, to, past]) those.delete(e);
    more.push(id, "arm-" + from, "arm-" + to);
  }
  return [...[...those].map((e) => "edge-" + e), ...more];
}

for (const r of data.routes) { // what is said once of each way, put together for the route
  const ways = (which) => which.map((k) => data.ways[k]);
  r.sections = ways(r.path).map((w) => w[0]);
  r.edges = ways(r.path).flatMap((w) => w.slice(1, w.indexOf("|")));
  r.points = ways([...r.path, ...r.overlap]).flatMap((w) => w.slice(w.indexOf("|") + 1));
  r.over = ways(r.overlap).flatMap((w) => w.slice(1, w.indexOf("|")));
  r.shown = ways(r.path).flatMap((w) => trodden(w.slice(1, w.indexOf("|"))));
  r.shown_over = ways(r.overlap).flatMap((w) => trodden(w.slice(1, w.indexOf("|"))));
  r.needs = r.beside.map((k) => data.beside[k]);
  r.words = `${r.kind} route from ${r.entry} to ${r.exit} over ${r.sections.join(", ")}`;
  r.against = r.hostile.flatMap((k) => groups[k][1].map((i) => [i, groups[k][0]])).sort((a, b) => a[0] - b[0]);
}
let chosen = -1;

function drawn(id) { return document.getElementById(id.replaceAll(" ", "\u00a0")); } // no id has a space in it

function lit(kind, ids, prefix) {
  for (const id of ids) {
    const e = drawn(prefix + id);
    if (!e) continue;
    e.classList.add(kind);
    if (e.classList.contains("arm")) e.classList.add("used");
  }
}

function lies(id, word) { // how a point beside the way must lie, after its name
  const name = [...document.querySelectorAll("#plan text.point")].find((e) => e.dataset.of === id);
  if (!name) return;
  const said = document.createElementNS("http://www.w3.org/2000/svg", "tspan");
  said.setAttribute("class", "lies");
  said.textContent = "\u00a0" + word;
  name.append(said);
}

function dark() {
  for (const kind of ["lit-path", "lit-overlap", "lit-flank", "lit-device", "closed", "open", "shut", "lit-foul", "lit-point", "lit-entry"])
    for (const e of document.querySelectorAll("#plan ." + kind)) e.classList.remove(kind);
  for (const e of document.querySelectorAll("#plan .lies")) e.remove();
  for (const e of document.querySelectorAll("#plan .arm.used")) e.classList.remove("used");
  for (const r of rows) { r.classList.remove("chosen", "hostile"); r.removeAttribute("aria-selected"); }
  for (const b of document.querySelectorAll("#routes button.of[aria-pressed]")) b.removeAttribute("aria-pressed");
}

function choose(i, scroll) {
  dark();
  chosen = i;
  document.getElementById("route").value = i < 0 ? "" : data.routes[i].id;
  tell(null);
  link(i < 0 ? "" : "#route=" + encodeURIComponent(data.routes[i].id));
  if (i < 0) { say("Choose a route: its path, overlap and flank protection light up, and its hostile routes are marked."); return; }
  const r = data.routes[i];
  lit("lit-path", r.shown, "");
  lit("lit-overlap", r.shown_over, "");
  lit("lit-point", r.points, "point-");
  lit("lit-entry", [r.entry], "signal-");
  for (const [kind, id, use, word] of r.needs) {
    lit("lit-" + use, [id], kind + "-");
    if (kind === "point") lies(id, word);
    if (kind === "device") lit(word, [id], "device-"); // closed, open or shut
  }
  const row = rows[r.row];
  row.classList.add("chosen");
  row.setAttribute("aria-selected", "true");
  for (const b of row.querySelectorAll(`button.of[data-route="${i}"]`)) b.setAttribute("aria-pressed", "true");
  for (const [k] of r.against) if (data.routes[k].row !== r.row) rows[data.routes[k].row].classList.add("hostile");
  if (scroll) {
    const box = row.closest(".scroll");
    box.scrollTop = row.offsetTop - box.querySelector("thead").offsetHeight;
  }
  approach(r.edges);
  show(r.edges);
  const secured = r.needs.filter(([, , use]) => use === "device").map(([, id, , word]) => id + " " + word);
  say(r.id + ": " + r.words + (secured.length ? "; with " + secured.join(", ") : "") + "; " + r.against.length + " hostile routes.");
}

function say(text) { why.textContent = text; }

// a route has its own link; it replaces the address, so that "back" still leads back
function link(hash) {
  if (hash !== location.hash && (hash || location.hash.startsWith("#route="))) history.replaceState(null, "", hash || location.pathname + location.search);
}

function linked() {
  const m = /^#route=(.*)$/.exec(location.hash);
  if (!m) return -1;
  let id = m[1];
  try { id = decodeURIComponent(id); } catch { /* not encoded: taken as it stands */ }
  return byId.has(id) ? byId.get(id) : -1;
}

// the plan fits its frame at first; larger, it is moved to the chosen route
const frame = document.getElementById("plan"), plan = frame.querySelector("svg");
const natural = plan.viewBox.baseVal.width;
let zoom = 0; // 0: as wide as the frame, but never wider than drawn

function fit() { return Math.min(1, frame.clientWidth / natural); }

function resize(to) {
  zoom = to && to > fit() ? Math.min(4, to) : 0;
  plan.style.width = natural * (zoom || fit()) + "px";
  plan.style.height = "auto";
  if (chosen >= 0) show(data.routes[chosen].edges);
}

function boxesOf(edges) {
  return edges.map((e) => drawn("edge-" + e)).filter(Boolean).map((e) => e.getBoundingClientRect());
}

// on a plan that fits only when it is small, a chosen route fills the frame
function approach(edges) {
  if (zoom || fit() >= 0.5) return;
  const boxes = boxesOf(edges);
  if (!boxes.length) return;
  const wide = Math.max(...boxes.map((b) => b.right)) - Math.min(...boxes.map((b) => b.left));
  resize(Math.min(1, 0.9 * fit() * frame.clientWidth / Math.max(1, wide)));
}

function show(edges) {
  const boxes = boxesOf(edges);
  if (!boxes.length) return;
  const at = frame.getBoundingClientRect();
  const left = Math.min(...boxes.map((b) => b.left)), right = Math.max(...boxes.map((b) => b.right));
  const top = Math.min(...boxes.map((b) => b.top)), bottom = Math.max(...boxes.map((b) => b.bottom));
  frame.scrollLeft += (left + right) / 2 - (at.left + frame.clientWidth / 2);
  frame.scrollTop += (top + bottom) / 2 - (at.top + frame.clientHeight / 2);
}

// the reason of a cell stands below the cell itself, or above it where there is no room
const tip = document.getElementById("tip");
let told = null;
function tell(button, text) {
  told = button;
  tip.hidden = !button;
  if (!button) return;
  tip.textContent = text;
  place(button);
}

function place(button) {
  const b = button.getBoundingClientRect(), wide = document.documentElement.clientWidth;
  tip.style.left = Math.max(8, Math.min(b.left, wide - tip.offsetWidth - 8)) + scrollX + "px";
  const below = b.bottom + 4 + tip.offsetHeight <= innerHeight || b.top < tip.offsetHeight + 4;
  tip.style.top = (below ? b.bottom + 4 : b.top - 4 - tip.offsetHeight) + scrollY + "px";
}

function filter() {
  const text = document.getElementById("text").value.trim().toLowerCase();
  const kind = document.getElementById("kind").value;
  const over = document.getElementById("over").value;
  let shown = 0;
  rows.forEach((row, k) => {
    const fits = ofRow[k].map((i) => data.routes[i]).some((r) => (!text || (r.id + " " + r.words).toLowerCase().includes(text))
      && (!kind || r.kind === kind) && (!over || r.sections.includes(over) || r.entry === over));
    row.hidden = !fits;
    shown += fits;
  });
  document.getElementById("shown").textContent = shown + " of " + rows.length + " routes";
}

rows.forEach((row, i) => {
  const turn = () => choose(ofRow[i].includes(chosen) ? -1 : ofRow[i][0], false);
  row.addEventListener("click", (e) => {
    const of = e.target.closest("button.of");
    if (of) choose(+of.dataset.route, false);
    else if (!e.target.closest("button")) turn();
  });
  row.addEventListener("keydown", (e) => {
    if (e.target !== row) return;
    const step = { ArrowDown: 1, ArrowUp: -1 }[e.key];
    if (e.key === "Enter" || e.key === " ") { e.preventDefault(); turn(); }
    if (step) {
      e.preventDefault();
      let k = i + step;
      while (rows[k] && rows[k].hidden) k += step;
      if (rows[k]) rows[k].focus();
    }
  });
});
// items with reasons become buttons, in a large table when their row comes into view: there are a hundred thousand
function reasoned(row) {
  for (const e of row.querySelectorAll("[data-why]:not(button)")) {
    const places = e.dataset.why.split(" "), texts = places.length > 1 ? e.textContent.split(", ") : [e.textContent];
    e.removeAttribute("data-why");
    e.replaceChildren(...texts.flatMap((text, i) => {
      const b = document.createElement("button");
      b.type = "button";
      b.dataset.why = places[i];
      b.textContent = i + 1 < texts.length ? text + "," : text; // inside, or a line could begin with the comma
      return i ? [" ", b] : [b];
    }));
  }
}
const near = new IntersectionObserver((seen) => {
  for (const x of seen) if (x.isIntersecting) { near.unobserve(x.target); reasoned(x.target); }
});
for (const row of rows) if (rows.length > 200) near.observe(row); else reasoned(row);
document.addEventListener("keydown", (e) => { if (e.key === "Escape") choose(-1, false); });
document.addEventListener("click", (e) => { if (!e.target.closest("button[data-why], button[data-hostile], #tip")) tell(null); });
document.addEventListener("scroll", () => { if (told) place(told); }, true);
document.getElementById("larger").addEventListener("click", () => resize((zoom || fit()) * 1.5));
document.getElementById("smaller").addEventListener("click", () => resize((zoom || fit()) / 1.5));
document.getElementById("fit").addEventListener("click", () => resize(0));
addEventListener("resize", () => resize(zoom));
addEventListener("hashchange", () => { if (linked() >= 0) choose(linked(), true); });
// those that are hostile in one way stand together: `A-B, A-C (same entry: both begin at A)`
function hostilities(i) {
  const groups = new Map();
  for (const [k, how] of data.routes[i].against) {
    const key = how + (i < k ? "<" : ">");
    if (!groups.has(key)) groups.set(key, [how, i < k, []]);
    groups.get(key)[2].push(data.routes[k].id);
  }
  return [...groups.values()].map(([how, first, ids]) => {
    const own = data.routes[i].id, others = ids.length > 1 ? "each of them" : ids[0];
    const told = { "{one}": first ? own : others, "{other}": first ? others : own, "{{": "{", "}}": "}" };
    const [kind, witness] = data.hows[how];
    return ids.join(", ") + " (" + kind + ": " + witness.replace(/{one}|{other}|{{|}}/g, (x) => told[x]) + ")";
  }).join("; ");
}
document.getElementById("routes").addEventListener("click", (e) => {
  const b = e.target.closest("button[data-why], button[data-hostile]");
  if (!b) return;
  if (b.dataset.hostile !== undefined) {
    const i = +b.dataset.hostile;
    say("Hostile to " + data.routes[i].id + ": " + hostilities(i));
  } else say(data.reasons[+b.dataset.why]);
  tell(b, why.textContent);
});
document.getElementById("routes").addEventListener("mouseover", (e) => {
  const b = e.target.closest("button[data-why]");
  if (b) b.title = data.reasons[+b.dataset.why];
});
for (const id of ["text", "kind", "over"]) document.getElementById(id).addEventListener("input", filter);
document.getElementById("route").addEventListener("change", (e) => choose(byId.has(e.target.value) ? byId.get(e.target.value) : -1, true));
document.getElementById("plan").addEventListener("click", (e) => {
  const g = e.target.closest(".section, .signal");
  if (!g || !g.id) return;
  const name = g.id.replace(/^(section|signal)-/, "");
  const over = document.getElementById("over");
  over.value = over.value === name ? "" : name;
  filter();
  say(over.value ? "Routes over or from " + name : "All routes");
});
for (const c of document.querySelectorAll("canvas.heat")) {
  const n = data.routes.length, ctx = c.getContext("2d");
  const sets = data.routes.map((r) => new Set(r.sections));
  let most = 1;
  const value = (a, b) => { let k = 0; for (const s of sets[a]) if (sets[b].has(s)) k++; return k; };
  for (let a = 0; a < n; a++) most = Math.max(most, sets[a].size);
  for (let a = 0; a < n; a++) for (let b = 0; b < n; b++) {
    const v = value(a, b);
    if (v) { ctx.fillStyle = "rgba(0,114,178," + (0.15 + 0.85 * v / most) + ")"; ctx.fillRect(b, a, 1, 1); }
  }
  c.addEventListener("click", (e) => {
    const box = c.getBoundingClientRect();
    const b = Math.floor((e.clientX - box.left) / box.width * n), a = Math.floor((e.clientY - box.top) / box.height * n);
    say(data.routes[a].id + " and " + data.routes[b].id + " share " + value(a, b) + " sections");
  });
}
resize(0);
choose(linked(), linked() >= 0);
filter();
