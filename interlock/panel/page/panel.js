// The panel: puts socket, plan and buttons together.
import {Talk} from "./talk.js";
import {Plan, EXIT} from "./plan.js";
import {acts, routesFrom, steps, train} from "./acts.js";

const $ = id => document.getElementById(id);
const hash = new URLSearchParams(location.hash.slice(1));
const look = new URLSearchParams(location.search).has("look");
const kept = {get: k => { try { return localStorage.getItem(k) ?? ""; } catch { return ""; } }, set: (k, v) => { try { localStorage.setItem(k, v); } catch { /* a browser may forbid it */ } }};
const plan = new Plan($("plan"), key => choose(key));
const state = plan.state, rest = {sys: null, alarms: [], reminders: {}, trains: []};
let still = null, chosen = "", operates = false, metres = 40, called = "";
$("name").value = kept.get("interlock.name");

const talk = new Talk(() => ({name: $("name").value, token: hash.get("token") ?? "", look}), heard);

function element(tag, text, ...inside) {
  const e = document.createElement(tag);
  e.textContent = text;
  e.append(...inside);
  return e;
}

function heard(m) {
  if (m.refused) { $("grey").textContent = m.refused; return; }
  if (m.still) first(m);
  plan.show(m.c);
  for (const part of Object.keys(rest)) if (part in m) rest[part] = m[part];
  if ("alarms" in m) alarms();
  if ("reminders" in m) plan.reminders(rest.reminders);
  if ("trains" in m) { plan.trains(rest.trains); trains(); }
  if ("sys" in m || "trains" in m) plan.numbers(rest.sys?.numbers ?? [], rest.trains);
  if ("sys" in m || m.still) system();
  for (const e of m.events ?? []) log(e, Boolean(m.still));
  if (chosen && (chosen in m.c || "sys" in m || "reminders" in m || "trains" in m)) offer();
  if ("sys" in m || Object.keys(m.c).some(k => k[0] === "s")) restart();
  if ("sys" in m || Object.keys(m.c).some(k => "cza".includes(k[0]))) others();
  document.body.dataset.heard = m.t;
}

function first(m) {
  operates = m.hello.operates;
  const same = still && still.plan === m.still.plan;
  still = m.still;
  $("log").replaceChildren();
  for (const k of Object.keys(state)) delete state[k];
  if (!same) plan.draw(still);
  $("title").textContent = $("title").title = still.title;
  document.title = still.name;
  document.body.classList.toggle("looks", !operates);
  $("names").replaceChildren(...[...plan.keys.keys()].map(k => new Option(k.slice(2))));
  $("speed").hidden = $("power-key").hidden = $("traffic").hidden = !still.simulated;
}

// A click is one where the mouse is let go on what it was pressed on: while a button is held down nothing is exchanged
// in its box, what has changed there is drawn afterwards.
let pressed = null;
const due = new Set();
function held(box, draw) {
  if (pressed && box.contains(pressed)) due.add(draw);
  return due.has(draw);
}
document.addEventListener("pointerdown", e => { pressed = e.target; }, true);
for (const end of ["pointerup", "pointercancel", "blur"]) window.addEventListener(end, () => setTimeout(() => {
  const waiting = [...due];
  pressed = null;
  due.clear();
  for (const draw of waiting) draw();
}));

// --- what is chosen ---
function choose(key) {
  $("said").replaceChildren();
  plan.mark("shown", []);
  if (chosen[0] === "g" && key && key !== chosen) {
    const found = routesFrom(still, chosen.slice(2)).filter(r => EXIT[r.exit[0]] === at(key)[0] && r.exit[1] === key.slice(2));
    if (found.length) return pick(found);
  }
  if (key[0] === "x") key = "";
  chosen = key === chosen ? "" : key;
  offer();
}
const at = key => key[0];

function pick(found) {
  const main = found.filter(r => r.kind === "main"), best = main.length ? main : found;
  if (best.length === 1) { ask({do: "set", route: best[0].id}); chosen = ""; offer(); return; }
  $("said").replaceChildren(element("p", "Several routes lead there: "), ...best.map(r => button(`${r.names[0] ?? r.id} over ${r.sections.join(", ")}`, () => {
    $("said").replaceChildren(); ask({do: "set", route: r.id}); chosen = ""; offer();
  })));
}

function exits() {
  if (chosen[0] !== "g") return [];
  return routesFrom(still, chosen.slice(2)).map(r => `${EXIT[r.exit[0]]}:${r.exit[1]}`);
}

let offered = "";
function offer() {
  if (held($("acts"), offer)) return;
  plan.mark("chosen", chosen ? [chosen] : []);
  plan.mark("exit", exits());
  $("hint").textContent = chosen[0] === "g" && exits().length ? "choose where to: the possible ends are lit" : "";
  const box = $("acts");
  if (!chosen) { offered = ""; $("of").textContent = "Nothing chosen"; box.replaceChildren(element("p", "Choose a signal, then where the route leads; or a section, points, a boundary.")); return; }
  const found = acts(still, state, rest, chosen);
  const now = JSON.stringify([chosen, found, rest.reminders[chosen], operates]);
  if (now === offered) return;
  offered = now;
  const typing = document.activeElement, where = box.contains(typing) ? typing.dataset.mark : null;
  const note = box.querySelector("[data-mark=note]")?.value;
  $("of").textContent = plan.keys.get(chosen)?.[0].getAttribute("aria-label").split(":")[0] ?? chosen.slice(2);
  const parts = found.lines.map(l => element("p", l));
  if (found.acts.some(a => a.train)) parts.push(input("train", called, "name", v => { called = v; }), input("metres", metres, "m long", v => { metres = Number(v) || 40; }));
  for (const a of found.acts) {
    const b = button(a.label, () => a.why ? why(a.command) : perform(a));
    b.dataset.mark = a.label;
    b.disabled = !operates && !a.why;
    b.classList.toggle("fault", Boolean(a.fault));
    parts.push(b);
  }
  if (found.remind) {
    const text = input("note", note && typing?.dataset.mark === "note" ? note : rest.reminders[chosen]?.[0] ?? "", "reminder", () => {});
    const key = chosen, field = text.querySelector("input");
    field.addEventListener("keydown", e => { if (e.key === "Enter") ask({do: "remind", at: key, text: field.value}); });
    parts.push(text);
    if (rest.reminders[chosen]) parts.push(element("p", `by ${rest.reminders[chosen][1]}, ${clock(rest.reminders[chosen][2])}`));
  }
  box.replaceChildren(...parts);
  if (where) box.querySelector(`[data-mark="${CSS.escape(where)}"]`)?.focus();
}

async function perform(a) {
  if (!a.train) return ask(a.command);
  const name = called;
  called = "";
  return ask({...a.command, metres, train: name});
}

function input(mark, value, label, changed) {
  const field = document.createElement("input");
  field.value = value; field.dataset.mark = mark; field.size = mark === "note" ? 26 : 7; field.maxLength = mark === "note" ? 80 : 12; field.disabled = !operates;
  field.addEventListener("input", () => changed(field.value));
  const l = element("label", `${label} `, field);
  return l;
}

function button(label, done) {
  const b = element("button", label);
  b.type = "button";
  b.addEventListener("click", done);
  return b;
}

// --- asking, and what is said of it ---
async function ask(command) {
  const answer = await talk.ask(command);
  if (!answer.ok) say("Refused", answer.why);
  return answer;
}

async function why(command) {
  const answer = await talk.ask(command);
  say("It waits for", answer.why.length ? answer.why : [["nothing: it opens with the next scan", []]]);
}

function say(title, reasons) {
  $("said").replaceChildren(element("strong", `${title}: `), ...reasons.map(([text]) => element("span", text)));
  plan.mark("shown", reasons.flatMap(([, keys]) => keys));
}

const clock = time => time.slice(11, 19);

function log(e, old) {
  const line = element("li", `${clock(e.time)} ${e.who ? `${e.who}: ` : ""}${e.text}`);
  line.className = e.kind;
  e.reasons.forEach(([text], i) => {
    const part = element("span", text), rule = e.rules?.[i];
    if (rule) part.title = `${rule}: interlock explain ${rule}`;
    line.append(part);
  });
  $("log").prepend(line);
  while ($("log").children.length > 200) $("log").lastChild.remove();
  if (!old && e.kind === "refusal" && e.who === ($("name").value.trim() || "operator") && e.reasons.length) say(e.text, e.reasons);
}

function alarms() {
  $("alarms").replaceChildren(...rest.alarms.slice().reverse().map(([key, text, where, since, active, who]) => {
    const line = element("li", `${clock(since)} ${text}${active ? "" : " (over)"}`);
    line.className = `${active ? "active" : ""} ${who ? "" : "new"}`;
    if (who) line.append(element("span", `seen by ${who}`));
    else { const b = button("Acknowledge", () => ask({do: "acknowledge", alarm: key})); b.disabled = !operates; line.append(b); }
    if (where.length) line.addEventListener("click", () => plan.mark("shown", where));
    return line;
  }));
  $("ack").disabled = !operates || !rest.alarms.some(a => !a[5]);
}

// --- the rest of the page ---
function system() {
  const s = rest.sys;
  $("inputs").textContent = s.valid ? "inputs valid" : "INPUTS NOT VALID";
  $("inputs").className = `pill ${s.valid ? "good" : "bad"}`;
  $("power").textContent = s.power ? "power" : "NO POWER";
  $("power").className = `pill ${s.power ? "good" : "bad"}`;
  $("power-key").textContent = s.power ? "Cut the power" : "Give power";
  $("power-key").disabled = !operates;
  $("releases").textContent = `releases ${s.releases}`;
  const select = $("speed").querySelector("select");
  if (!select.children.length) {
    select.append(...[1, 2, 5, 10, 60].map(n => new Option(`${n} times`, n)));
    select.addEventListener("change", () => ask({do: "speed", times: Number(select.value)}));
  }
  if (document.activeElement !== select) select.value = s.speed;
  select.disabled = !operates;
}

let stepped = "";
function restart() {
  if (held($("restart"), restart)) return;
  const found = rest.sys && steps(still, state, rest.sys), now = JSON.stringify(found);
  if (now === stepped) return;
  stepped = now;
  $("restart").hidden = !found;
  if (!found) return;
  const open = found.findIndex(([done]) => !done);
  $("restart").replaceChildren(element("h2", "After a restart, or a loss of inputs"), element("ol", "", ...found.map(([done, text, key], k) => {
    const line = element("li", text);
    line.className = done ? "done" : k === open ? "now" : "";
    if (key) { const b = button(key.label, () => ask(key.command)); b.disabled = !operates; line.append(b); }
    return line;
  })));
}

let running = "";
function trains() {
  if (held($("trains"), trains)) return;
  const now = JSON.stringify(rest.trains.map(([n, , v, l, u, h]) => [n, v, l, u, h]));
  if (now === running) return;
  running = now;
  const names = rest.trains.map(t => t[0]).join(), list = $("trains");
  if (list.dataset.names !== names) {
    list.dataset.names = names;
    list.replaceChildren(...rest.trains.map(() => element("li", "", element("span", ""), element("div", ""))));
  }
  rest.trains.forEach((t, k) => {
    const [name, , speed, long, under, held] = t, line = list.children[k];
    line.firstChild.textContent = `${name}: ${speed} km/h, ${long} m, ${under.join(", ") || "on the line"}`;
    if (line.dataset.held === String(held)) return;
    line.dataset.held = held;
    line.lastChild.replaceChildren(...train(t).map(a => {
      const b = button(a.label.replace(`${name}: `, ""), () => ask(a.command));
      b.disabled = !operates; b.setAttribute("aria-label", a.label);
      return b;
    }));
  });
}

function others() {
  if (held($("rest"), others)) return;
  const lines = [], s = rest.sys;
  const add = (text, label, command) => {
    const line = element("p", `${text} `);
    if (command) { const b = button(label, () => ask(command)); b.disabled = !operates; line.append(b); }
    lines.push(line);
  };
  const failed = (k, n) => s.failed.some(f => f[0] === k && f[1] === n);
  for (const [c, [text, input]] of Object.entries(still.conditions)) {
    const holds = state[`c:${c}`]?.[0];
    add(`${c}: ${holds ? "holds" : "does not hold"}${text ? ` (${text})` : ""}`, holds ? "Fail" : "Put right", still.simulated && {do: "fail", kind: "condition", name: input, on: Boolean(holds)});
  }
  for (const z of still.zones) add(`zone ${z}: ${state[`z:${z}`]?.[0] ? "full" : "has room"}`);
  for (const v of still.voyages) add(`voyage ${v}`, "Begin", {do: "voyage", name: v});
  for (const [name, reason] of s.voyages) add(`${name} is under way${reason ? `: ${reason}` : ""}`, "End", {do: "voyage", name, end: true});
  for (const [number, under] of s.numbers) add(`train ${number} is in ${under.join(", ")}`);
  if (still.simulated) for (const n of still.stations) {
    const on = !failed("station", n);
    add(`substation ${n}: ${on ? "reports" : "cable cut"}`, on ? "Cut its cable" : "Mend its cable", {do: "fail", kind: "station", name: n, on});
  }
  $("rest").replaceChildren(...lines);
  $("more").hidden = !lines.length;
}

// one name, or two: names may have spaces, so that every way to divide the words is tried
function readings(words) {
  const named = text => [text, [...plan.keys.keys()].filter(k => k.slice(2) === text)];
  const all = words.map((_, i) => [words.slice(0, i + 1).join(" "), words.slice(i + 1).join(" ")].filter(Boolean).map(named));
  const known = all.filter(parts => parts.every(([, keys]) => keys.length));
  return known.length ? known : [all.find(([first]) => first[1].length) ?? all[words.length - 1]];
}

// --- keys and buttons ---
$("ack").addEventListener("click", () => ask({do: "acknowledge", alarm: ""}));
$("in").addEventListener("click", () => plan.zoom(0.8));
$("out").addEventListener("click", () => plan.zoom(1.25));
$("fit").addEventListener("click", () => plan.fit());
$("power-key").addEventListener("click", () => ask({do: "power", on: !rest.sys.power}));
$("name").addEventListener("change", () => { kept.set("interlock.name", $("name").value); talk.again(); });
$("test").addEventListener("click", async () => {
  $("test").disabled = true;
  if (operates) ask({do: "lamp test"});
  const count = await plan.test(text => say(text, []));
  say(`lamp test: over, ${count} displays`, []);
  $("test").disabled = false;
});
$("line").addEventListener("submit", e => {
  e.preventDefault();
  const order = $("typed").value.trim();
  if (/^[^:>]+:[^:>]+(>[^:>]+)+$/.test(order)) { $("typed").value = ""; ask({do: "voyage", name: order}); return; }
  const stands = /^([^@\s]+)@(.+)$/.exec(order);
  if (stands) { $("typed").value = ""; ask({do: "train", name: stands[1], section: stands[2].trim()}); return; }
  const [keys, ...others] = readings(order.split(/\s+/));
  if (others.length) { say("Not clear", [[`${order} can be read in ${others.length + 1} ways: choose on the plan`, []]]); return; }
  const lost = keys.find(([, known]) => !known.length);
  if (lost) { say("Unknown", [[`nothing on the plan is called ${lost[0]}`, []]]); return; }
  $("typed").value = "";
  if (chosen) choose(chosen);
  const from = keys[0][1], to = keys[1]?.[1];
  choose(from.find(k => k[0] === "g") ?? from[0]);
  if (to) choose(to.find(k => exits().includes(k)) ?? to[0]);
});
document.addEventListener("keydown", e => {
  if (e.key === "Escape") { $("typed").blur(); if (chosen) choose(chosen); else { $("said").replaceChildren(); plan.mark("shown", []); } return; }
  if (e.target.matches("input, select") || e.ctrlKey || e.metaKey || e.altKey || !still) return;
  const move = {ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, -0.1], ArrowDown: [0, 0.1]}[e.key];
  if (move) plan.move(...move);
  else if (e.key === "+") plan.zoom(0.8);
  else if (e.key === "-") plan.zoom(1.25);
  else if (e.key === "0") plan.fit();
  else if (e.key === "a") ask({do: "acknowledge", alarm: ""});
  else if (e.key === "/") $("typed").focus();
  else return;
  e.preventDefault();
});
setInterval(() => {
  const old = talk.old;
  document.body.classList.toggle("stale", old);
  $("link").textContent = old ? "NO NEWS" : operates ? "operating" : "looking";
  $("link").className = `pill ${old ? "bad" : "good"}`;
  if (!talk.refused) $("grey").textContent = old && still ? "What you see is older than a second." : "";
}, 100);
