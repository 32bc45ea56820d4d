// The plan: shows what the server says of each element, zooms, tells what was clicked.
import {Slips} from "./slips.js";

const NS = "http://www.w3.org/2000/svg";
const by = id => document.getElementById(id.replaceAll(" ", "\u00a0")); // no id has a space in it
const make = (tag, attributes, into) => {
  const e = document.createElementNS(NS, tag);
  for (const [k, v] of Object.entries(attributes)) e.setAttribute(k, v);
  into?.append(e);
  return e;
};
const toggle = (e, name, on) => e?.classList.toggle(name, Boolean(on));
export const GROUP = {s: "section", g: "signal", b: "boundary", x: "buffer", m: "device"};
export const EXIT = {signal: "g", boundary: "b", buffer: "x", section: "s"};

export class Plan {
  constructor(holder, chosen) {
    Object.assign(this, {holder, chosen, state: {}, fingers: new Map(), drag: null});
    for (const end of ["pointerup", "pointercancel"]) window.addEventListener(end, e => { this.fingers.delete(e.pointerId); this.drag = null; });
  }

  draw(still) {
    this.still = still;
    this.holder.innerHTML = still.plan;
    const svg = this.svg = this.holder.querySelector("svg");
    svg.removeAttribute("width"); svg.removeAttribute("height");
    this.edge = {};
    for (const id of Object.keys(still.edges)) {
      const path = by(`edge-${id}`);
      if (path) this.edge[id] = {path, metres: still.edges[id][0], forward: still.edges[id][1], length: path.getTotalLength()};
      if (path) path.after(make("path", {class: "block", d: path.getAttribute("d")})); // over whatever else the track shows
    }
    for (const path of svg.querySelectorAll("path.track")) path.after(make("path", {class: "core", d: path.getAttribute("d")}));
    this.slips = new Slips(svg, this.edge, by);
    this.keys = new Map();
    for (const s of Object.keys(still.sections)) this.key(`s:${s}`, by(`section-${s}`), `section ${s}`);
    for (const [m, one] of Object.entries(still.machines)) {
      if (one.device) this.device(m, one, by(`device-${m}`));
      for (const p of one.points) this.key(`m:${m}`, by(`point-${p.id}`), one.called, 11);
    }
    this.lies = {}; // after what is clicked: of a slip the legs chosen between lie beside the blades
    for (const [m, one] of Object.entries(still.machines)) this.lies[m] = one.points.map(p => this.point(p)).filter(Boolean);
    for (const g of Object.keys(still.signals)) this.signs(by(`signal-${g}`));
    for (const g of Object.keys(still.signals)) this.key(`g:${g}`, by(`signal-${g}`), `signal ${g}`, 9);
    for (const [b, one] of Object.entries(still.boundaries)) this.key(`b:${b}`, by(`boundary-${b}`), `boundary ${one.label}`, 12);
    for (const e of svg.querySelectorAll("g.buffer")) {
      const name = e.id.slice(7).replaceAll("\u00a0", " ");
      this.key(`x:${name}`, e, `end of track ${name}`, 10);
    }
    for (const t of svg.querySelectorAll("text[data-of]")) {
      const kind = {section: "s", signal: "g", point: "m", "of-device": "m"}[[...t.classList].find(c => ["section", "signal", "point", "of-device"].includes(c))];
      if (!kind) continue;
      const name = kind === "m" ? this.machine(t.dataset.of) : t.dataset.of;
      t.dataset.key = `${kind}:${name}`;
      t.classList.add("named");
    }
    const b = [...svg.querySelectorAll("g[id], text:not(.title)")].map(e => e.getBBox());
    const x = Math.min(...b.map(r => r.x)) - 20, y = Math.min(...b.map(r => r.y)) - 30;
    this.whole = [x, y, Math.max(...b.map(r => r.x + r.width)) + 20 - x, Math.max(...b.map(r => r.y + r.height)) + 30 - y];
    this.fit();
    this.layer = make("g", {class: "trains"}, svg);
    this.berths = make("g", {class: "berths"}, svg);
    this.notes = make("g", {class: "notes"}, svg);
    this.names = [...svg.querySelectorAll("text:not(.title), .lamp")].map(e => e.getBBox()).filter(r => r.width); // nothing is written over these
    this.heads = [];
    for (const [g, one] of Object.entries(still.signals)) if (one.calls) this.caller(by(`signal-${g}`));
    svg.addEventListener("click", e => this.clicked(e));
    svg.addEventListener("keydown", e => { if (e.key === "Enter" || e.key === " ") { e.preventDefault(); if (!e.repeat) this.clicked(e); } });
    svg.addEventListener("wheel", e => { e.preventDefault(); this.zoom(e.deltaY < 0 ? 0.8 : 1.25, this.at(e)); }, {passive: false});
    this.fingers = new Map();
    svg.addEventListener("pointerdown", e => {
      if (e.isPrimary) { this.fingers.clear(); this.moved = false; } // it may have been let go outside the window
      this.fingers.set(e.pointerId, [e.clientX, e.clientY]);
      this.drag = [e.clientX, e.clientY, ...this.box];
    });
    svg.addEventListener("pointermove", e => this.pan(e));
  }

  machine(point) {
    return Object.entries(this.still.machines).find(([, m]) => m.points.some(p => p.id === point))?.[0] ?? point;
  }

  key(key, group, label, reach) {
    if (!group) return;
    group.dataset.key = key;
    group.setAttribute("tabindex", "0");
    group.setAttribute("role", "button");
    group.setAttribute("aria-label", label);
    const all = this.keys.get(key) ?? [];
    all.push(group);
    this.keys.set(key, all);
    if (!reach) return;
    const b = group.getBBox();
    const x = Math.min(b.x, b.x + b.width / 2 - reach), y = Math.min(b.y, b.y + b.height / 2 - reach);
    const w = Math.max(b.width, 2 * reach), h = Math.max(b.height, 2 * reach);
    if (key[0] !== "m" || group.dataset.n) make("rect", {class: "reach", x, y, width: w, height: h, rx: 4}, group);
    else make("circle", {class: "reach", cx: b.x + b.width / 2, cy: b.y + b.height / 2, r: reach}, group);
  }

  // what tells the lights of a signal from each other without their colours, drawn over its first lamp
  signs(group) {
    const lamp = group?.querySelector(".lamp"), mast = /L(\S+) (\S+)/.exec(group?.querySelector(".mast")?.getAttribute("d"));
    if (!lamp && !group?.matches(".distant")) return;
    const [x, y, r] = (lamp ? ["cx", "cy", "r"].map(k => lamp.getAttribute(k)) : [mast[1], mast[2], 5]).map(Number), s = 0.7 * r;
    make("path", {class: "sign bar", d: `M${x - r} ${y} L${x + r} ${y}`}, group);
    make("path", {class: "sign slash", d: `M${x - s} ${y + s} L${x + s} ${y - s}`}, group);
    make("path", {class: "sign cross", d: `M${x - r} ${y - r} L${x + r} ${y + r} M${x - r} ${y + r} L${x + r} ${y - r}`}, group);
  }

  // a signal that calls on shows a white lamp beside the red one, where nothing is written
  caller(group) {
    if (!group?.querySelector(".lamp")) return;
    const {x, y, way, off} = this.head(group);
    const places = [[way * 9, 0], [0, off * 10], [way * 9, off * 7], [way * 18, 0]].map(([dx, dy]) => ({x: x + dx, y: y + dy, width: 9, height: 9}));
    const free = places.find(b => !this.names.some(t => Math.abs(t.x + t.width / 2 - b.x) < (t.width + 9) / 2 && Math.abs(t.y + t.height / 2 - b.y) < (t.height + 9) / 2)) ?? places[0];
    make("circle", {class: "caller", r: 4.2, cx: free.x, cy: free.y}, group);
    this.names.push({x: free.x - 4.5, y: free.y - 4.5, width: 9, height: 9});
  }

  // the last lamp of a signal, or its mast; which way its lamps go, and on which side of the track they are
  head(group) {
    const lamps = [...group?.querySelectorAll(".lamp") ?? []].map(e => e.getBBox()), b = lamps.at(-1) ?? group?.getBBox();
    if (!b) return null;
    const x = b.x + b.width / 2, y = b.y + b.height / 2, mast = group.querySelector(".mast").getBBox();
    return {x, y, way: lamps.length && b.x < mast.x ? -1 : 1, off: y < mast.y + mast.height / 2 ? -1 : 1};
  }

  // what is clicked of a device is all of each place at which it lies over a track; there is a mark beside that it is locked
  device(m, one, group) {
    this.key(`m:${m}`, group, one.called);
    const [dx, dy] = {"level crossing": [-2.5, -11], door: [5, -11]}[group?.dataset.kind] ?? [-2.5, -8];
    for (const spot of group?.dataset.at.split(" ") ?? []) {
      const [x, y] = spot.split(",").map(Number);
      make("rect", {class: "reach", x: x - 11, y: y - 16, width: 22, height: 32, rx: 4}, group);
      make("rect", {class: "lock", x: x + dx, y: y + dy, width: 5, height: 5}, group);
    }
  }

  // how a point lies: a short bright piece of the leg to which it leads, with a dark rim around it
  point(p) {
    const toe = this.edge[p.toe]?.path, group = by(`point-${p.id}`);
    if (!toe || !group) return null;
    const ends = q => [q.getPointAtLength(0), q.getPointAtLength(q.getTotalLength())];
    const near = (a, b) => Math.hypot(a.x - b.x, a.y - b.y);
    const out = {group};
    for (const leg of ["N", "R"]) {
      const d = group.dataset[leg.toLowerCase()] ?? this.leg(this.edge[p[leg]], ends(toe), ends, near); // of a double slip: at its blades, which lie across
      if (!d) continue;
      out[leg] = make("g", {class: `lie ${leg}`});
      for (const part of ["rim", "piece"]) make("path", {class: part, d}, out[leg]);
      group.prepend(out[leg]);
    }
    group.prepend(...group.querySelectorAll(".gap")); // under the piece of a leg that is set
    return out;
  }

  leg(edge, toe, ends, near) {
    if (!edge) return null;
    const [a, b] = ends(edge.path), from = Math.min(...toe.map(t => near(t, a))) <= Math.min(...toe.map(t => near(t, b)));
    const far = Math.min(17, edge.length), to = edge.path.getPointAtLength(from ? far : edge.length - far), at = from ? a : b;
    return `M${at.x} ${at.y} L${to.x} ${to.y}`;
  }

  show(changes) {
    Object.assign(this.state, changes);
    const sections = new Set(), automatic = new Set();
    for (const [key, value] of Object.entries(changes)) {
      const kind = key[0], name = key.slice(2);
      if (kind === "s") sections.add(name);
      else if (kind === "m") this.showMachine(name, value);
      else if (kind === "g") this.showSignal(name, value);
      else if (kind === "b") this.note(key, "left", value[3] ? `manual change: ${value[4] === null ? "waits" : `${value[4]} s`}` : "");
      else if (kind === "a") automatic.add(this.still.routes.find(r => r.id === name)?.entry);
      else if (kind === "o") for (const path of this.slips.paths(this.still.overlaps[name] ?? [])) toggle(path, "overlap", value[0]);
    }
    for (const s of sections) this.showSection(s, this.state[`s:${s}`]);
    for (const g of automatic) this.showAutomatic(g);
    if (this.slips.all.length) this.slips.used();
  }

  showSection(name, [occupied, ways, restart, blocked, stale, left, releasing, sick, over = []]) {
    const one = this.still.sections[name], group = by(`section-${name}`);
    if (!group) return;
    const locked = new Set(ways.flatMap(k => this.slips.paths(one.ways[k] ?? [])));
    const drawn = one.edges.length ? [...one.edges.map(e => this.edge[e]?.path), ...this.slips.beside(one.edges)] : [group.querySelector("path.track")];
    for (const path of drawn) {
      toggle(path, "locked", locked.has(path));
      toggle(path, "occupied", occupied && (!locked.size || locked.has(path)));
      toggle(path, "maybe", occupied && locked.size && !locked.has(path)); // the detector does not tell the legs apart
      toggle(path, "restart", restart);
      toggle(path, "blocked", blocked);
      toggle(path, "unsure", stale && locked.has(path));
    }
    toggle(group, "sick", sick);
    const words = [occupied ? "occupied" : "clear", locked.size ? "locked" : over.length ? `locked as overlap of ${over.join(", ")}` : "", restart ? "not released" : "", blocked ? "blocked" : ""];
    group.setAttribute("aria-label", `section ${name}: ${words.filter(Boolean).join(", ")}`);
    this.note(`s:${name}`, "left", releasing ? (left === null ? "release: waits" : `release: ${left} s`) : "");
  }

  showMachine(name, [lies, wanted, locked, late, trailed, why = ""]) {
    const one = this.still.machines[name];
    const sure = lies.length === 1, failed = late || trailed;
    for (const g of this.keys.get(`m:${name}`) ?? []) {
      toggle(g, "held", locked); toggle(g, "late", failed); toggle(g, "moving", !sure && wanted); toggle(g, "lost", !sure);
      g.setAttribute("aria-label", `${one.called}: ${one.lies[lies] ?? (one.device ? "not proved open or closed" : "not detected")}${[!sure && wanted ? `commanded ${one.lies[wanted]}` : "", late ? "not in time" : "", trailed ? one.trailed : "", locked ? why || "locked" : ""].filter(Boolean).map(x => `, ${x}`).join("")}`);
      toggle(g, "secured", one.device && lies === "R"); toggle(g, "released", one.device && lies === "N");
    }
    for (const p of this.lies[name] ?? []) for (const leg of ["N", "R"]) {
      toggle(p[leg], "lies", lies === leg);
      toggle(p[leg], "wanted", lies !== leg && wanted === leg);
      toggle(p[leg], "lost", lies !== leg && (failed || (!sure && !wanted))); // while they move in time, no leg is
    }
  }

  showSignal(name, [aspect, cancelling, left, active, out, kmh = null, marks = ""]) {
    const group = by(`signal-${name}`);
    if (!group) return;
    for (const a of ["stop", "clear", "caution", "call", "identifier", "shunt", "dark"]) toggle(group, a, a === aspect);
    toggle(group, "yellows", marks.includes("UU")); toggle(group, "branching", marks.includes("B")); toggle(group, "limited", kmh !== null);
    toggle(group, "set", active); toggle(group, "cancelling", cancelling); toggle(group, "out", out);
    this.showSpeed(name, [marks, kmh].filter(x => x).join(" ") || null);
    const shown = `${marks.includes("UU") ? "two yellows" : aspect}${marks.includes("B") ? " with the route indicator" : ""}${kmh ? ` at ${kmh} km/h` : ""}`;
    const more = [active ? `route ${active[0]}` : "", cancelling ? "cancelling" : "", out ? "stop lamp out" : ""].filter(Boolean);
    group.setAttribute("aria-label", [`signal ${name}: ${shown}`, ...more].join(", "));
    this.note(`g:${name}`, "left", cancelling ? (left === null ? "cancel: waits" : `cancel: ${left} s`) : left === null ? "" : `waits: ${left} s`);
  }

  // an A in a circle beyond the lamps of a signal, or near by
  showAutomatic(name) {
    const id = `automatic-g:${name}`, on = this.still.routes.some(r => r.entry === name && this.state[`a:${r.id}`]?.[0]);
    by(id)?.remove();
    const head = on && this.head(by(`signal-${name}`));
    if (!head) return;
    const mark = make("g", {id, class: "automatic"}, this.notes), text = make("text", {}, mark);
    text.textContent = "A";
    this.place(text, this.beyond(head, 12), this.written(text));
    make("circle", {cx: text.getAttribute("x"), cy: Number(text.getAttribute("y")) - 3, r: 5.2}, mark);
  }

  // the km/h that a signal shows, with UU for two yellows and B for the route indicator, beyond its lamps or near by
  showSpeed(name, kmh) {
    const id = `speed-g:${name}`, before = by(id);
    if (before?.textContent === String(kmh ?? "")) return;
    before?.remove();
    const head = kmh === null ? null : this.head(by(`signal-${name}`));
    if (!head) return;
    const text = make("text", {id, class: "speed"}, this.notes);
    text.textContent = kmh;
    this.place(text, this.beyond(head, 16), this.written(text));
  }

  // places beyond the lamps of a signal, then further from the track, then beyond the track
  beyond({x, y, way, off}, least) {
    const ahead = [0, 2, 5, 8, 14].map(more => [way * (least + more), 0]), aside = [14, 17, 28, -30, -44].flatMap(far => [0, 8, -8, 18, -18].map(dx => [way * dx, off * far]));
    return [...ahead, ...aside].map(([dx, dy]) => ({x: x + dx, y: y + 3 + dy}));
  }

  // a small text beside an element
  note(key, kind, text) {
    const id = `note-${kind}-${key}`;
    let t = by(id);
    if (!text) { t?.remove(); return; }
    const at = this.middle(key);
    if (!at) return;
    t ??= make("text", {id, class: `note ${kind}`}, this.notes);
    t.textContent = text;
    if (text.length <= Number(t.dataset.room ?? 0)) return; // it stays where it is
    t.dataset.room = text.length;
    const first = kind === "left" ? [30, -30, 44, -44] : [-30, 30, -44, 44], places = [...first, 58, -58, 72, -72];
    this.place(t, places.flatMap(y => [0, -30, 30, -60, 60].map(x => ({x: at.x + x, y: at.y + y}))), this.written(t));
  }

  // what is written on the plan, but for one text
  written(but) {
    const moving = [this.layer, this.berths, this.notes].flatMap(g => [...g.querySelectorAll("text")]);
    return [...this.names, ...moving.filter(e => e !== but).map(e => e.getBBox())];
  }

  middle(key) {
    const g = this.keys.get(key)?.[0];
    if (!g) return null;
    const b = g.getBBox();
    return {x: b.x + b.width / 2, y: b.y + b.height / 2};
  }

  reminders(all) {
    for (const t of [...this.notes.querySelectorAll(".note.reminder")]) t.remove();
    for (const [key, [text]] of Object.entries(all)) this.note(key, "reminder", `\u2691 ${key.slice(2)}: ${text.length > 28 ? `${text.slice(0, 27)}\u2026` : text}`);
  }

  trains(all) {
    this.layer.replaceChildren();
    this.heads = [];
    const set = e => Object.entries(this.still.machines).some(([m, one]) => one.points.some(p => p[this.state[`m:${m}`]?.[0]] === e));
    for (const [name, spans, , , under, held, way] of all) {
      const rails = this.slips.under(new Set(spans.map(([e]) => e)), set);
      let head = spans.length ? null : this.middle(`s:${under[0]}`);
      for (const [edge, lo, hi] of spans) {
        const e = this.edge[edge];
        if (!e) continue;
        const f = m => e.length * (e.forward ? m : e.metres - m) / e.metres;
        const [a, b] = [f(lo), f(hi)].sort((x, y) => x - y), steps = Math.max(1, Math.ceil((b - a) / 6));
        const points = Array.from({length: steps + 1}, (_, k) => this.slips.spot(edge, a + (b - a) * k / steps, rails));
        make("polyline", {class: held ? "train held" : "train", points: points.map(p => `${p.x},${p.y}`).join(" ")}, this.layer);
        head = this.slips.spot(edge, f(way > 0 ? hi : lo), rails);
      }
      if (!head) continue;
      const text = make("text", {class: "berth"}, this.layer);
      text.textContent = name;
      const places = [17, -9, 30, -22, 43, -35].flatMap(y => [0, -14, 14, -28, 28].map(x => ({x: head.x + x, y: head.y + y})));
      this.heads.push(this.place(text, places, [...this.names, ...this.heads, ...[...this.notes.children].map(e => e.getBBox())]));
    }
  }

  // numbers of trains, each at the section in which its head is, clear of all that is written there
  numbers(all, trains) {
    const drawn = ([number, under]) => trains.some(t => t[0] === number && t[4].includes(under.at(-1)));
    const before = new Map([...this.berths.children].map(e => [`${e.textContent} ${e.dataset.of}`, {x: Number(e.getAttribute("x")), y: Number(e.getAttribute("y"))}]));
    this.berths.replaceChildren();
    const taken = [...this.names, ...this.heads, ...[...this.notes.children].map(e => e.getBBox())];
    for (const [number, under] of all.filter(x => !drawn(x))) {
      const name = under.at(-1), text = make("text", {class: "number"}, this.berths), was = before.get(`${number} ${name}`);
      text.textContent = number;
      text.dataset.of = name;
      taken.push(this.place(text, [...(was ? [was] : []), ...this.beside(name)], taken));
    }
  }

  // put a text in the first of some places where it covers nothing that is written; what it covers then
  place(text, places, taken) {
    let b = null;
    for (const at of places) {
      text.setAttribute("x", at.x); text.setAttribute("y", at.y);
      const {x, y, width, height} = text.getBBox();
      b = {x: x - 2, y: y - 1, width: width + 4, height: height + 2}; // with the border around it
      if (!taken.some(t => b.x < t.x + t.width && t.x < b.x + b.width && b.y < t.y + t.height && t.y < b.y + b.height)) return b;
    }
    if (!b) text.remove();
    return b ?? {x: 0, y: 0, width: 0, height: 0};
  }

  // places beside a section, those near its name first
  beside(name) {
    const paths = (this.still.sections[name]?.edges ?? []).map(e => this.edge[e]?.path).filter(Boolean);
    const group = by(`section-${name}`), label = this.svg.querySelector(`text.section[data-of="${CSS.escape(name)}"]`)?.getBBox();
    if (!paths.length && group) paths.push(...group.querySelectorAll("path.track"));
    paths.sort((a, b) => b.getTotalLength() - a.getTotalLength());
    const found = [];
    for (const off of [17, -9, 30, -22, 43, -35]) for (const part of [0.5, 0.3, 0.7, 0.1, 0.9]) for (const p of paths) {
      const at = p.getPointAtLength(p.getTotalLength() * part);
      found.push({x: at.x, y: at.y + off});
    }
    const far = p => Math.hypot(p.x - label.x - label.width / 2, p.y - label.y - label.height / 2);
    return label?.width ? found.sort((p, q) => far(p) - far(q)) : found;
  }

  mark(name, keys) {
    for (const e of [...this.svg.querySelectorAll(`.${name}`)]) e.classList.remove(name);
    for (const k of keys) for (const g of this.keys.get(k) ?? []) g.classList.add(name);
  }

  clicked(e) {
    if (this.moved) return;
    const group = e.target.closest("[data-key]");
    this.chosen(group ? group.dataset.key : "");
  }

  // --- looking closer ---
  at(e) {
    const r = this.svg.getBoundingClientRect();
    const k = Math.max(this.box[2] / r.width, this.box[3] / r.height);
    return [this.box[0] + this.box[2] / 2 + (e.clientX - r.x - r.width / 2) * k, this.box[1] + this.box[3] / 2 + (e.clientY - r.y - r.height / 2) * k];
  }

  zoom(by, [x, y] = [this.box[0] + this.box[2] / 2, this.box[1] + this.box[3] / 2]) {
    const [bx, b_y, w, h] = this.box, k = Math.min(Math.max(by, 60 / w), 1.5 * this.whole[2] / w);
    this.look([x - (x - bx) * k, y - (y - b_y) * k, w * k, h * k]);
  }

  fit() { this.look([...this.whole]); }

  move(dx, dy) { const [x, y, w, h] = this.box; this.look([x + dx * w, y + dy * h, w, h]); }

  pan(e) {
    const before = this.fingers.get(e.pointerId);
    if (before && this.fingers.size === 2) { // two fingers look closer
      const other = [...this.fingers].find(([id]) => id !== e.pointerId)[1], far = ([x, y]) => Math.hypot(x - other[0], y - other[1]);
      const was = far(before), is = far([e.clientX, e.clientY]);
      this.fingers.set(e.pointerId, [e.clientX, e.clientY]);
      this.moved = true;
      if (was && is) this.zoom(was / is, this.at({clientX: (e.clientX + other[0]) / 2, clientY: (e.clientY + other[1]) / 2}));
      this.drag = null;
      return;
    }
    if (!this.drag || !e.buttons) return;
    const [x, y, bx, b_y, w, h] = this.drag, r = this.svg.getBoundingClientRect();
    if (Math.hypot(e.clientX - x, e.clientY - y) > 4) this.moved = true;
    const k = Math.max(w / r.width, h / r.height);
    if (this.moved) this.look([bx - (e.clientX - x) * k, b_y - (e.clientY - y) * k, w, h]);
  }

  look(box) { this.box = box; this.svg.setAttribute("viewBox", box.join(" ")); }

  // every display in turn (document B: lamps are tested in sequence when work begins); returns how many there are
  async test(say) {
    const kinds = [["free", ".track:not(.arm)"], ["locked", ".track:not(.arm)"], ["occupied", ".track:not(.arm)"], ["stop", ".signal"], ["caution", ".signal"],
      ["clear", ".signal"], ["shunt", ".signal"], ["normal", ".point"], ["reverse", ".point"]];
    if (this.svg.querySelector(".caller")) kinds.push(["call", ".caller"]);
    for (const kind of ["identifier", "second", "indicator", "speed"]) if (this.svg.querySelector(`.lamp.${kind}`)) kinds.push([kind, `.lamp.${kind}`]);
    let count = 0;
    for (const [kind, what] of kinds) {
      const those = this.svg.querySelectorAll(what).length;
      count += those;
      say(`lamp test: ${kind} (${those})`);
      this.svg.classList.add(`test-${kind}`);
      await new Promise(done => setTimeout(done, 450));
      this.svg.classList.remove(`test-${kind}`);
    }
    return count;
  }
}
