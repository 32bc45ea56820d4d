// The panel: puts socket, plan and buttons together.
import {Talk} from "./talk.js";
import {Plan, EXIT} from "./plan.js";
import {act, acts, promise, routesFrom, steps, train} from "./acts.js";
import {Rows, say as label, settleAll, settling} from "./rows.js";

const $ = id => document.getElementById(id);
const hash = new URLSearchParams(location.hash.slice(1));
const look = new URLSearchParams(location.search).has("look");
const kept = {get: k => { try { return localStorage.getItem(k) ?? ""; } catch { return ""; } }, set: (k, v) => { try { localStorage.setItem(k, v); } catch { /* a browser may forbid it */ } }};
const plan = new Plan($("plan"), key => { if (!$("plan").matches(".settling")) choose(key); });
const state = plan.state, rest = {sys: null, alarms: [], reminders: {}, trains: []};
let ends = new Map(); // what a machine works by other names than its own, and its key
let still = null, chosen = "", operates = false, metres = 40, called = "";
$("name").value = kept.get("interlock.name");
$("name").placeholder = nameless();
const me = () => $("name").value.trim() || $("name").placeholder; // its answers are told by it
const talk = new Talk(() => ({name: me(), token: hash.get("token") ?? "", look}), heard);

// whoever gives no name has one of his own, as long as this window is open
function nameless() {
  const made = `operator ${(crypto.getRandomValues(new Uint16Array(1))[0] % 1296).toString(36).padStart(2, "0")}`;
  try {
    if (!sessionStorage.getItem("interlock.nameless")) sessionStorage.setItem("interlock.nameless", made);
    return sessionStorage.getItem("interlock.nameless");
  } catch { return made; /* a browser may forbid it */ }
}

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
  if (m.still) settleAll();
  document.body.dataset.heard = m.t;
}

function first(m) {
  operates = m.hello.operates;
  const same = still && JSON.stringify(still) === JSON.stringify(m.still); // then what is chosen, and typed, stays
  still = m.still;
  $("log").replaceChildren();
  for (const k of Object.keys(state)) delete state[k];
  if (!same) {
    for (const rows of [choice, wrong, running, more]) rows.clear();
    plan.draw(still);
    if (!plan.keys.has(chosen)) chosen = "";
  }
  $("title").textContent = $("title").title = still.title;
  document.body.dataset.profile = still.profile;
  document.body.classList.toggle("looks", !operates);
  $("stop").disabled = !operates;
  ends = new Map(Object.entries(still.machines).flatMap(([m, one]) => one.ends.filter(e => !plan.keys.has(`m:${e}`)).map(e => [e, `m:${m}`])));
  $("names").replaceChildren(...[...plan.keys.keys()].map(k => new Option(k.slice(2))), ...[...ends].map(([e, k]) => new Option(still.machines[k.slice(2)].called, e)));
  $("speed").hidden = $("power-key").hidden = $("traffic").hidden = !still.simulated;
  if (!chosen) offer();
}

// --- what is chosen ---
function choose(key) {
  quiet();
  if (armed && key && key !== chosen) {
    const found = routesFrom(still, chosen.slice(2)).filter(r => EXIT[r.exit[0]] === at(key)[0] && r.exit[1] === key.slice(2));
    if (found.length) return pick(found);
  }
  if (key[0] === "x") key = "";
  chosen = key === chosen && (armed || chosen[0] !== "g") ? "" : key;
  armed = chosen[0] === "g" && routesFrom(still, chosen.slice(2)).length > 0;
  armedAt = performance.now();
  offer();
}

// the next click chooses where a route leads, for a while
const ARMED_MS = 20000;
let armed = false, armedAt = 0;
function disarm() { armed = false; offer(); }
function letGo() { chosen = ""; disarm(); }
const at = key => key[0];

const KINDS = {main: "train route", shunt: "shunting route", "call-on": "call-on route"};
function pick(found) {
  const set = r => { quiet(); ask({do: "set", route: r.id}); letGo(); settling($("plan")); }; // a second click by reflex chooses nothing
  if (found.length === 1) { set(found[0]); return; }
  quiet();
  tell(element("p", "Several routes lead there: "), ...found.map(r => button(`${KINDS[r.kind] ?? r.kind} ${r.names[0] ?? r.id} over ${r.sections.join(", ")}${r.overlap ? `, ${r.overlap}` : ""}`, () => set(r))));
  told = {keys: [], at: armedAt, then: stands([]), lasts: ARMED_MS};
}

function exits() {
  if (!armed) return [];
  return routesFrom(still, chosen.slice(2)).map(r => `${EXIT[r.exit[0]]}:${r.exit[1]}`);
}

function offer() {
  plan.mark("chosen", chosen ? [chosen] : []);
  plan.mark("exit", exits());
  $("hint").textContent = $("hint").title = armed ? "choose where to: the ends are lit" : chosen[0] === "g" && routesFrom(still, chosen.slice(2)).length ? "for a route click the signal again" : "";
  if (chosen !== offered) { offered = chosen; choice.clear(); }
  $("of").textContent = chosen ? plan.keys.get(chosen)?.[0].getAttribute("aria-label").split(":")[0] ?? chosen.slice(2) : "Nothing chosen";
  if (!chosen) { choice.show([["none", {lines: ["Choose a signal, then where the route leads; or a section, points, a boundary."]}]]); return; }
  const found = acts(still, state, rest, chosen), rows = [["lines", {lines: found.lines}]];
  const one = (a, mark) => rows.push([mark, {...a, off: a.off || (!operates && !a.why)}]);
  if (found.remind) rows.push(["note", {input: "note", label: "reminder", note: rest.reminders[chosen] ?? null}]);
  if (found.acts.some(a => a.train)) rows.push(["train", {input: "train", label: "name"}], ["metres", {input: "metres", label: "m long"}]);
  found.acts.forEach((a, k) => one(a, `act ${k}`));
  for (const a of found.trains) one(a, a.label.replace(/(go|stop)$/, "run"));
  choice.show(rows);
}
let offered = "";
const choice = new Rows($("acts"), v => {
  if (v.lines) return element("div", "");
  if (v.input) return input(v.input, v.label);
  const b = button("", () => b.does());
  b.classList.toggle("wide", v.fault || v.label.length > 20);
  return b;
}, (row, v) => {
  if (v.lines) { row.className = "lines"; row.title = v.lines.join("\n"); row.replaceChildren(...v.lines.map(l => element("p", l))); return; }
  if (v.input) { if (v.input === "note") noted(row, v.note); return; }
  row.does = () => v.why ? why(v.command) : perform(v);
  label(row, v.label);
  row.disabled = v.off;
  row.classList.toggle("fault", Boolean(v.fault));
});

// a reminder as it is now, unless somebody has typed another that is not saved: that stays, and is marked
const drafts = new Map();
function noted(row, note) {
  const field = row.querySelector("input"), by = row.querySelector("small") ?? row.appendChild(element("small", ""));
  const {key} = field.dataset, text = note?.[0] ?? "", told = note ? `by ${note[1]}, ${clock(note[2])}` : "";
  if (drafts.get(key) === text) drafts.delete(key);
  const draft = drafts.get(key) ?? null;
  if (field.value !== (draft ?? text)) field.value = draft ?? text;
  row.classList.toggle("unsaved", draft !== null);
  by.textContent = by.title = draft === null ? told : `NOT SAVED: Enter saves it, Esc takes it back${note ? `; saved: ${text}, ${told}` : ""}`;
}

async function remind(row, key, text) {
  const answer = await ask({do: "remind", at: key, text});
  if (answer.ok && drafts.get(key) === text) drafts.delete(key);
  noted(row, rest.reminders[key]);
}

function typing(field, key) {
  field.dataset.key = key;
  field.addEventListener("input", () => { drafts.set(key, field.value); noted(field.parentElement, rest.reminders[key]); });
  field.addEventListener("keydown", e => {
    if (e.isComposing) return;
    if (e.key === "Enter") remind(field.parentElement, key, field.value);
    if (e.key !== "Escape" || !drafts.delete(key)) return;
    e.stopPropagation();
    noted(field.parentElement, rest.reminders[key]);
  });
}

async function perform(a) {
  const asks = promise(still, a.command, blockers.get(a.command.section), me());
  if (asks) { sure(a.command, ...asks); return null; }
  if (!a.train) return ask(a.command);
  const name = called, field = $("acts").querySelector("[data-mark=train]");
  called = "";
  if (field) field.value = "";
  return ask({...a.command, metres, train: name});
}

function input(mark, text) {
  const field = document.createElement("input"), key = chosen;
  field.value = {train: called, metres}[mark] ?? ""; field.dataset.mark = mark; field.size = mark === "note" ? 26 : 7; field.maxLength = mark === "note" ? 80 : 12; field.disabled = !operates;
  field.addEventListener("input", () => { if (mark === "train") called = field.value; if (mark === "metres") metres = Number(field.value) || 40; });
  if (mark === "note") typing(field, key);
  return element("label", `${text} `, field);
}

function button(text, done) {
  const b = element("button", text);
  b.type = "button";
  b.addEventListener("click", done);
  return b;
}

// the button that does it stands elsewhere, for a while, and no key that is pressed again reaches it
const SURE_MS = 10000, blockers = new Map();
function sure(command, question, yes) {
  quiet();
  const from = document.activeElement, back = () => { quiet(); from?.focus(); };
  const does = button(yes, () => { back(); ask(command); }), words = element("strong", question);
  words.tabIndex = -1;
  settling(does);
  tell(words, does, button("No", back));
  told = {keys: about(command), at: performance.now(), then: stands(about(command)), lasts: SURE_MS};
  words.focus({preventScroll: true});
}

// --- asking, and what is said of it ---
async function ask(command) {
  const answer = await talk.ask(command);
  if (answer.unsent) unsent(answer);
  else if (answer.ok) sent();
  else say(answer.title ?? "Refused", answer.why, about(command));
  return answer;
}

// what was not sent stays told until somebody puts it away, or until something else is done
let notSent = null;
function unsent({title, why}) {
  notSent = element("p", "", element("strong", `${title}: `), ...why.map(([text]) => element("span", text)), button("Put away", sent));
  notSent.className = "unsent";
  tell();
}
function sent() { if (notSent) { notSent = null; tell(); } }
let told = null, words = [];
function tell(...now) {
  if (now.length) words = now;
  $("said").replaceChildren(...(notSent ? [notSent] : []), ...words);
}

// the elements that a command is about
function about(c) {
  const route = still.routes.find(r => r.id === c.route);
  return [route && `g:${route.entry}`, c.signal && `g:${c.signal}`, c.section && `s:${c.section}`, c.machine && `m:${c.machine}`, c.boundary && `b:${c.boundary}`].filter(Boolean);
}

async function why(command) {
  const answer = await talk.ask(command);
  if (answer.unsent) unsent(answer);
  else if (!answer.ok) say(answer.title ?? "Refused", answer.why, about(command));
  else say("It waits for", answer.why.length ? answer.why : [["nothing: it opens with the next scan", []]], about(command));
}

// what is said below the plan is past when an element that it is about changes, when power or inputs come or go, and after
// a while: then it is dim
const PAST_MS = 20000, COUNTS = {g: 2, s: 5, b: 4}; // where a value counts down
const stands = keys => JSON.stringify([rest.sys?.power, rest.sys?.valid, ...keys.map(k => state[k]?.filter((_, i) => i !== COUNTS[k[0]]))]);
function past() {
  if (told?.lasts) { if (performance.now() - told.at > told.lasts || stands(told.keys) !== told.then) quiet(); return; }
  if (!told || (performance.now() - told.at < PAST_MS && stands(told.keys) === told.then)) return;
  told = null;
  $("said").classList.add("past");
  plan.mark("shown", []);
}

function quiet() {
  told = null;
  words = [];
  tell();
  $("said").classList.remove("past");
  plan.mark("shown", []);
}

function say(title, reasons, of = []) {
  const keys = [...of, ...reasons.flatMap(([, at]) => at)];
  told = {keys, at: performance.now(), then: stands(keys)};
  $("said").classList.remove("past");
  tell(element("strong", `${title}: `), ...reasons.map(([text]) => element("span", text)));
  plan.mark("shown", reasons.flatMap(([, keys]) => keys));
}

const clock = time => `${!rest.sys?.day || time.startsWith(rest.sys.day) ? "" : `${time.slice(0, 10)} `}${time.slice(11, 19)}`;

// at midnight all times of before get their date
let day = "";
function dates() {
  if (day === rest.sys.day) return;
  day = rest.sys.day;
  for (const e of $("log").querySelectorAll("time")) e.textContent = clock(e.dateTime);
  for (const rows of [wrong, choice]) for (const row of rows.rows.values()) row.told = "";
  alarms();
  offer();
}

function log(e, old) {
  const line = element("li", ""), time = element("time", clock(e.time));
  time.dateTime = e.time;
  line.append(time, ` ${e.who ? `${e.who}: ` : ""}${e.text}`);
  line.className = e.kind;
  e.reasons.forEach(([text], i) => {
    const part = element("span", text), rule = e.rules?.[i];
    if (rule) part.title = `${rule}: interlock explain ${rule}`;
    line.append(part);
  });
  const block = e.kind === "operation" && /^(block|free) section (.+)$/.exec(e.text);
  if (block) blockers.set(block[2], block[1] === "block" ? e.who : "");
  $("log").prepend(line);
  while ($("log").children.length > 200) $("log").lastChild.remove();
  if (!old && ["refusal", "operation"].includes(e.kind) && e.who === me() && e.reasons.length) say(e.text, e.reasons, e.at);
}

const wrong = new Rows($("alarms"), () => {
  const b = button("Acknowledge", e => b.does(e)), row = element("li", "", b, element("b", ""), element("span", ""));
  views.observe(row);
  return row;
}, (row, [key, text, where, since, active, who]) => {
  const [b, head, words] = row.children;
  head.textContent = head.title = `${[clock(since), active ? "" : "over", who ? `seen by ${who}` : ""].filter(Boolean).join(", ")}:`;
  words.textContent = text;
  row.className = `${active ? "active" : ""} ${who ? "" : "new"}`;
  row.onclick = () => { if (where.length) plan.mark("shown", where); };
  b.does = e => { if (!e.detail) next(row); seen([[key, since]]); };
  b.disabled = !operates;
  b.classList.toggle("seen", Boolean(who));
});

// an alarm that stood whole on the screen for half a second is one that somebody can have seen
const SEEN_MS = 500, PARTS = Array.from({length: 21}, (_, k) => k / 20);
const couldSee = row => Boolean(row?.seen || (row?.whole && performance.now() - row.whole >= SEEN_MS));
const views = new IntersectionObserver(all => {
  for (const {target: row, intersectionRect: r, boundingClientRect: b} of all) {
    row.seen = couldSee(row);
    const whole = r.height > 0 && r.height >= Math.min(b.height, $("alarms").clientHeight) - 1;
    row.whole = whole ? row.whole || performance.now() : 0;
  }
  count();
}, {threshold: PARTS});

const unseen = () => rest.alarms.filter(a => !a[5]);
const rowOf = ([key, , , since]) => wrong.rows.get(`${key} ${since}`);
function seen(those) { if (those.length) ask({do: "acknowledge", alarms: those}); }
const all = () => seen(unseen().filter(a => couldSee(rowOf(a))).map(([key, , , since]) => [key, since]));

// who acknowledges by key goes on with the next alarm, and not at once
function next(row) {
  const left = [...$("alarms").children], k = left.indexOf(row);
  const b = [...left.slice(k + 1), ...left.slice(0, k).reverse()].map(e => e.querySelector("button:not(.seen)")).find(Boolean);
  if (b) settling(b);
  (b ?? $("unseen")).focus();
}

const spoken = new Set();
function speak() {
  for (const [key, text, , since] of unseen().filter(a => !spoken.has(`${a[0]} ${a[3]}`))) {
    spoken.add(`${key} ${since}`);
    $("news").append(element("p", `Alarm: ${text}`));
  }
  while ($("news").children.length > 5) $("news").firstChild.remove();
}

function alarms() {
  speak();
  wrong.show(rest.alarms.slice().reverse().map(a => [`${a[0]} ${a[3]}`, a]));
  count();
}

function count() {
  const fresh = unseen(), hidden = fresh.map(rowOf).filter(row => row?.whole === 0);
  const above = hidden.filter(row => row.offsetTop < $("alarms").scrollTop).length, below = hidden.length - above;
  const told = [rest.alarms.length, `${fresh.length} new`, above ? `${above} above` : "", below ? `${below} below` : ""].filter(Boolean);
  $("unseen").textContent = $("unseen").title = rest.alarms.length ? `Alarms: ${told.join(", ")}` : "Alarms";
  $("unseen").classList.toggle("new", fresh.length);
  $("fresh").textContent = fresh.length ? `${fresh.length} alarm${fresh.length > 1 ? "s" : ""}` : "";
  $("ack").disabled = !operates || !fresh.length;
}

// --- the rest of the page ---
function system() {
  const s = rest.sys;
  dates();
  document.body.classList.toggle("unsure", !s.valid);
  $("inputs").textContent = s.valid ? "inputs valid" : "INPUTS NOT VALID";
  $("inputs").className = `pill ${s.valid ? "good" : "bad"}`;
  $("power").textContent = s.power ? "power" : "NO POWER";
  $("power").className = `pill ${s.power ? "good" : "bad"}`;
  label($("power-key"), s.power ? "Cut the power" : "Give power");
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
  const found = rest.sys && steps(still, state, rest.sys), told = JSON.stringify([found, operates]);
  if (told === stepped) return;
  stepped = told;
  $("restart").hidden = !found;
  if (!found) return;
  const open = found.findIndex(([done]) => !done), key = found.map(([, , k]) => k).find(Boolean);
  $("release").textContent = "Release all clear sections";
  $("release").disabled = !operates || !key;
  $("steps").replaceChildren(...found.map(([done, text], k) => {
    const line = element("li", text);
    line.className = done ? "done" : k === open ? "now" : "";
    return line;
  }));
  requestAnimationFrame(() => { // the step that is due is in view, its box stays where it is
    const now = $("steps").querySelector(".now"), least = now ? now.offsetTop + now.offsetHeight - $("steps").clientHeight : 0;
    const first = [...$("steps").children].find(line => line.offsetTop >= least || line === now); // and the first in view is whole
    if (now) $("steps").scrollTop = least <= 0 ? 0 : first.offsetTop;
  });
}

const running = new Rows($("trains"), () => element("li", "", element("span", ""), element("div", "")), (row, t) => {
  const [name, speed, long, under] = t, [line, keys] = row.children;
  line.textContent = line.title = `${name}: ${speed} km/h, ${long} m, ${under.join(", ") || "on the line"}`;
  train([name, , speed, long, under, t[4]]).forEach((a, k) => {
    const b = keys.children[k] ?? keys.appendChild(button("", () => b.does()));
    b.does = () => ask(a.command);
    label(b, a.label.replace(`${name}: `, ""));
    b.disabled = !operates || Boolean(a.off); b.setAttribute("aria-label", a.label);
  });
});
function trains() { running.show(rest.trains.map(([n, , v, l, u, h]) => [n, [n, v, l, u, h]])); }

const more = new Rows($("rest"), v => {
  const b = button("", () => b.does());
  return element("li", "", element("span", ""), ...(v.label ? [b] : []), ...(v.of ? [element("small", v.of)] : []));
}, (row, v) => {
  row.firstChild.textContent = row.firstChild.title = v.text;
  row.classList.toggle("long", Boolean(v.long));
  const b = row.querySelector("button");
  if (!b) return;
  b.does = () => ask(v.command);
  label(b, v.label);
  b.disabled = !operates;
});

// what is always there first, then what comes and goes
function others() {
  const rows = [], s = rest.sys;
  const add = (key, text, label = "", command = null, long = false, of = "") => rows.push([key, {text, label: command ? label : "", command, long, of}]);
  const failed = (k, n) => s.failed.some(f => f[0] === k && f[1] === n);
  for (const [c, [text, input]] of Object.entries(still.conditions)) {
    const holds = state[`c:${c}`]?.[0];
    const unknown = s.power ? "not known: inputs are lost" : "not known without power", on = !failed("condition", input);
    add(`c ${c}`, holds === null ? unknown : holds ? "holds" : "does not hold", on ? "Fail" : "Put right", still.simulated && {do: "fail", kind: "condition", name: input, on},
      false, text ? `${c}: ${text}` : c); // what it is stands above, however long
  }
  for (const z of still.zones) {
    const full = state[`z:${z}`]?.[0];
    add(`z ${z}`, `zone ${z}: ${full === null ? "not known without power" : full ? "full" : "has room"}`);
  }
  if (still.simulated) for (const n of still.stations) {
    const on = !failed("station", n);
    add(`s ${n}`, `substation ${n}: ${on ? "reports" : "cable cut"}`, on ? "Cut its cable" : "Mend its cable", {do: "fail", kind: "station", name: n, on});
  }
  for (const v of still.voyages) add(`v ${v}`, `voyage ${v}`, "Begin", {do: "voyage", name: v});
  for (const z of still.zones) {
    const uncounted = state[`z:${z}`]?.[1] ?? [];
    if (uncounted.length) add(`y ${z}`, `zone ${z} does not count who stands in ${uncounted.join(", ")}: nothing is locked there`, "", null, true);
  }
  for (const [name, reason] of s.voyages) add(`u ${name}`, `${name} is under way${reason ? `: ${reason}` : ""}`, "End", {do: "voyage", name, end: true}, true);
  for (const [number, under] of s.numbers) add(`n ${number}`, `train ${number} is in ${under.join(", ")}`);
  more.show(rows);
}

// one name, or two: names may have spaces, so that every way to divide the words is tried
function readings(words) {
  const named = text => [text, [...[...plan.keys.keys()].filter(k => k.slice(2) === text), ...(ends.has(text) ? [ends.get(text)] : [])]];
  const all = words.map((_, i) => [words.slice(0, i + 1).join(" "), words.slice(i + 1).join(" ")].filter(Boolean).map(named));
  const known = all.filter(parts => parts.every(([, keys]) => keys.length));
  return known.length ? known : [all.find(([first]) => first[1].length) ?? all[words.length - 1]];
}

// --- keys and buttons ---
$("ack").addEventListener("click", all);
$("release").addEventListener("click", () => perform(act("", {do: "release all"})));
$("in").addEventListener("click", () => plan.zoom(0.8));
$("out").addEventListener("click", () => plan.zoom(1.25));
$("fit").addEventListener("click", () => plan.fit());
$("power-key").addEventListener("click", () => ask({do: "power", on: !rest.sys.power}));
$("stop").addEventListener("click", () => ask({do: "stop"}));
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
  if (!order) return;
  if (/^[^:>]+:[^:>]+(>[^:>]+)+$/.test(order)) { $("typed").value = ""; ask({do: "voyage", name: order}); return; }
  if (still.voyages.includes(order)) { $("typed").value = ""; ask({do: "voyage", name: order}); return; }
  const stands = /^([^@\s]+)@(.+)$/.exec(order);
  if (stands) { $("typed").value = ""; ask({do: "train", name: stands[1], section: stands[2].trim()}); return; }
  if (/[:>@]/.test(order)) { say("Not clear", [["write 12:W>E for the way of a train, 12@q4 for where it stands", []]]); return; }
  const [keys, ...others] = readings(order.split(/\s+/));
  if (others.length) { say("Not clear", [[`${order} can be read in ${others.length + 1} ways: choose on the plan`, []]]); return; }
  const lost = keys.find(([, known]) => !known.length);
  if (lost) { say("Unknown", [[`nothing on the plan is called ${lost[0]}`, []]]); return; }
  $("typed").value = "";
  letGo();
  const from = keys[0][1], to = keys[1]?.[1];
  choose(from.find(k => k[0] === "g") ?? from[0]);
  if (!to) return;
  const end = to.find(k => exits().includes(k));
  if (end) { choose(end); return; }
  disarm();
  say("No route", [[`none leads from ${keys[0][0]} to ${keys[1][0]}`, []]]);
});
document.addEventListener("keydown", e => {
  if (e.key === "Escape") { $("typed").blur(); sent(); if (told?.lasts && !armed) quiet(); else { quiet(); letGo(); } return; }
  if (e.isComposing || e.target.matches("input, select") || e.ctrlKey || e.metaKey || e.altKey || !still) return;
  const move = {ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, -0.1], ArrowDown: [0, 0.1]}[e.key];
  if (move) plan.move(...move);
  else if (e.key === "+") plan.zoom(0.8);
  else if (e.key === "-") plan.zoom(1.25);
  else if (e.key === "0") plan.fit();
  else if (e.key === "a" && e.target.closest("#wrong")) all(); // elsewhere somebody means to type it
  else if (e.key === "/") $("typed").focus();
  else return;
  e.preventDefault();
});
setInterval(() => {
  const old = talk.old;
  document.body.classList.toggle("stale", old);
  $("link").textContent = old ? (talk.comes ? "OLD NEWS" : "NO NEWS") : operates ? "operating" : "looking";
  $("link").className = `pill ${old ? "bad" : "good"}`;
  const title = still ? [unseen().length ? `(${unseen().length})` : "", old ? $("link").textContent : "", still.name].filter(Boolean).join(" ") : document.title;
  if (document.title !== title) document.title = title;
  if (still) past();
  if (armed && performance.now() - armedAt > ARMED_MS) disarm();
  const waits = Math.floor(talk.waits / 1000);
  if (!talk.refused) $("grey").textContent = [old && still ? `What you see is older than a second${talk.comes ? ": news come late, or a clock was set" : ""}.` : "",
    talk.kept ? `All signals to stop: not sent for ${Math.floor(talk.keeps / 1000)} s, goes when the connection is back.` : "", waits ? `Sent ${waits} s ago, no answer yet.` : ""].filter(Boolean).join("  ");
}, 100);
