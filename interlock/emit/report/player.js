"use strict";
const data = JSON.parse(document.getElementById("data").textContent);
const slider = document.getElementById("slider"), list = [...document.querySelectorAll("#steps li")];
const said = document.getElementById("said"), changes = document.getElementById("changes");
let at = 0, timer = null;

// a way over a slip rail is shown on the rail, and on its legs as far as the blades: no train runs through the middle of the diamond
for (const those of Object.values(data.views)) for (const { id, dataset: { from, to, past } } of document.querySelectorAll("#plan .rail[data-from]")) {
  const way = new Map(those.filter(([kind]) => kind === "edge").map((v) => [v[1], v]));
  if (!way.has(from) || !way.has(to)) continue;
  for (const e of [from, to, past]) if (way.has(e)) those.splice(those.indexOf(way.get(e)), 1);
  const what = way.get(from)[2];
  those.push(["rail", id.replace("rail-", ""), what], ["arm", from, what], ["arm", to, what]);
}

function views(k) {
  const out = new Map();
  for (const name of data.states[data.shown[k]]) for (const v of data.views[name] || []) out.set(v.slice(0, 3).join("\n"), v);
  for (const v of undetected(k)) out.set(v.join("\n"), v);
  return out;
}

// the variables that tell how a point or device lies; where those of both positions are known and none is true, it is not detected
const lies = new Map();
for (const [name, those] of Object.entries(data.views)) for (const [kind, id, what] of those) if (what === "N" || what === "R") {
  const key = kind + "\n" + id;
  if (!lies.has(key)) lies.set(key, { kind, id, names: new Map() });
  lies.get(key).names.set(what, name);
}

// what the controller is not told is a thing of its own: no picture of a position would be true
function undetected(k) {
  const on = new Set(data.states[data.shown[k]]);
  return [...lies.values()].filter(({ names }) => names.size === 2 && ![...names.values()].some((n) => on.has(n))).map(({ kind, id }) => [kind, id, "undetected"]);
}

const words = { occupied: "occupied", locked: "locked", overlap: "held as overlap", restart: "restart lock", proceed: "proceed", identifier: "identifier light", N: "normal", R: "reverse", undetected: "not detected" };
const told = (v) => v[1] + " " + (v[3] || words[v[2]]);

function show(k) {
  at = Math.max(0, Math.min(data.texts.length - 1, k));
  slider.value = at;
  const now = views(at), before = at ? views(at - 1) : new Map();
  for (const e of document.querySelectorAll("#plan [data-now]")) { e.removeAttribute("data-now"); e.classList.remove("changed", "used"); }
  for (const e of document.querySelectorAll("#plan .train, #plan .lost")) e.remove();
  const marks = new Map();
  for (const [key, [kind, id, what]] of now) {
    const e = document.getElementById((kind + "-" + id).replaceAll(" ", "\u00a0")); // no id has a space in it
    if (!e) continue;
    marks.set(e, (marks.get(e) || "") + " " + what);
    if (kind === "arm") e.classList.add("used");
    if (!before.has(key) && at) e.classList.add("changed");
    if (what === "occupied" && data.trains) train(e, id);
    if (what === "undetected") lost(e);
  }
  for (const [e, what] of marks) e.setAttribute("data-now", what.trim());
  const news = [];
  for (const [key, v] of now) if (!before.has(key) && at) news.push(told(v));
  for (const [key, v] of before) if (!now.has(key) && v[2] !== "undetected") news.push(v[1] + " no longer " + (v[3] || words[v[2]]));
  changes.textContent = news.join("; ");
  said.textContent = (at + 1) + " of " + data.texts.length + ": " + data.texts[at];
  list.forEach((li, i) => { li.classList.toggle("now", i === at); if (i === at) li.setAttribute("aria-current", "step"); else li.removeAttribute("aria-current"); });
  if (list[at]) list[at].scrollIntoView({ block: "nearest" });
}

function train(group, id) {
  const path = [...group.querySelectorAll("path.track")].sort((a, b) => b.getTotalLength() - a.getTotalLength())[0];
  if (!path) return;
  const n = path.getTotalLength(), p = path.getPointAtLength(n / 2), q = path.getPointAtLength(n / 2 + 1);
  const box = document.createElementNS("http://www.w3.org/2000/svg", "rect");
  const long = Math.min(30, n * 0.7);
  for (const [k, v] of Object.entries({ class: "train", x: p.x - long / 2, y: p.y - 6, width: long, height: 12, rx: 4,
    transform: "rotate(" + Math.atan2(q.y - p.y, q.x - p.x) * 180 / Math.PI + " " + p.x + " " + p.y + ")" })) box.setAttribute(k, v);
  const title = document.createElementNS("http://www.w3.org/2000/svg", "title");
  title.textContent = "a train in " + id;
  box.append(title);
  group.append(box);
}

function lost(group) { // a frame round each machine, road or door of it
  for (const mark of group.querySelectorAll(".mark:not(.barrier, .across, .leaf)")) {
    const at = mark.getBBox(), box = document.createElementNS("http://www.w3.org/2000/svg", "rect");
    for (const [k, v] of Object.entries({ class: "lost", x: at.x - 5, y: at.y - 5, width: at.width + 10, height: at.height + 10, rx: 4 })) box.setAttribute(k, v);
    group.append(box);
  }
}

function play() {
  const button = document.getElementById("play");
  if (timer) { clearInterval(timer); timer = null; button.textContent = "Play"; return; }
  if (at === data.texts.length - 1) show(0);
  button.textContent = "Pause";
  timer = setInterval(() => { if (at >= data.texts.length - 1) play(); else show(at + 1); }, 1400);
}

slider.addEventListener("input", () => show(+slider.value));
document.getElementById("back").addEventListener("click", () => show(at - 1));
document.getElementById("on").addEventListener("click", () => show(at + 1));
document.getElementById("play").addEventListener("click", play);
list.forEach((li, i) => li.addEventListener("click", () => show(i)));
document.addEventListener("keydown", (e) => {
  if (e.target === slider) return;
  if (e.key === "ArrowRight") show(at + 1);
  if (e.key === "ArrowLeft") show(at - 1);
  if (e.key === "Home") show(0);
  if (e.key === "End") show(data.texts.length - 1);
});
const frame = document.getElementById("plan"), drawing = frame.querySelector("svg"), start = drawing.dataset.start;
const wide = drawing.clientWidth / frame.clientWidth;
if (wide > 1 && wide < 1.6) { drawing.style.width = "100%"; drawing.style.height = "auto"; } // it is legible still
if (start) { const [x, y] = start.split(" "); frame.scrollTo(x - 80, y - frame.clientHeight / 2); } // a large plan opens where its lines come in
document.getElementById("devices").hidden = !drawing.querySelector(".device");
show(0);
