// Rows that lie still under the mouse: while it is in their box none moves or goes.  What is new comes after them, what
// is over leaves its place empty; both are put right when the mouse has left.  What has moved, or says something else
// than it said, takes no click for a moment, by mouse or by key.
export const SETTLES_MS = 400;

const every = new Set();
const KEYS = ["Enter", " "];
let pressed = null, said = ""; // a click does what stood there when mouse or key was pressed: until it is let go nothing else is written there
const press = e => { pressed = e.target; said = pressed.closest("button")?.textContent; };
document.addEventListener("pointerdown", press, true);
document.addEventListener("keydown", e => {
  if (!KEYS.includes(e.key) || !e.target.closest("button")) return;
  if (!e.repeat) press(e);
  else if (e.key === "Enter") e.preventDefault(); // held down it is pressed once
}, true);
for (const end of ["pointerup", "pointercancel", "keyup", "blur"]) window.addEventListener(end, e => {
  if (!e.key || KEYS.includes(e.key)) setTimeout(() => {
    pressed = null;
    for (const rows of every) rows.lay();
  });
});
document.addEventListener("click", e => {
  const b = e.target.closest("button");
  if (!b?.closest(".settling") && (!b?.contains(pressed) || said === b.textContent)) return;
  e.preventDefault();
  e.stopImmediatePropagation();
}, true);

export function settling(e, ms = SETTLES_MS) {
  const mark = String(performance.now());
  e.classList.add("settling");
  e.dataset.moved = mark;
  setTimeout(() => { if (e.dataset.moved === mark) e.classList.remove("settling"); }, ms);
}

// what has come again takes no click for longer: whoever has had no answer clicks again, at what says something else now
const AGAIN_MS = 1000;
export function settleAll() { for (const rows of every) for (const row of rows.rows.values()) settling(row, AGAIN_MS); }

// what a button says and does; one that was there already and says something else settles first
export function say(b, label) {
  if (b.textContent === label) return;
  if (b.textContent && b.isConnected) settling(b);
  b.textContent = b.title = label;
}

export class Rows {
  // make(value): a new row; fill(row, value): what is told and done there now
  constructor(box, make, fill) {
    Object.assign(this, {box, make, fill, now: new Map(), rows: new Map(), inside: false});
    box.addEventListener("pointerenter", () => { this.inside = true; });
    box.addEventListener("pointerleave", () => { this.inside = false; this.lay(); });
    every.add(this);
  }

  // pairs of a key and a value, in their order
  show(pairs) { this.now = new Map(pairs); this.lay(); }

  // something else altogether: nothing is kept
  clear() { this.rows.clear(); this.box.replaceChildren(); }

  lay() {
    const keys = [...this.now.keys()], known = [...this.rows.keys()];
    const order = this.inside ? [...known, ...keys.filter(k => !this.rows.has(k))] : keys;
    const same = order.length === known.length && order.every((k, i) => k === known[i]);
    const places = same ? [] : [...this.rows.values()].map(row => [row, row.offsetTop]);
    for (const k of known) if (!order.includes(k)) this.rows.get(k).remove();
    const rows = new Map();
    for (const [i, k] of order.entries()) {
      const row = this.rows.get(k) ?? this.make(this.now.get(k));
      rows.set(k, row);
      row.classList.toggle("over", !this.now.has(k));
      const told = JSON.stringify(this.now.get(k));
      if (this.now.has(k) && row.told !== told && !row.contains(pressed)) { this.fill(row, this.now.get(k)); row.told = told; }
      if (this.box.children[i] !== row) this.box.insertBefore(row, this.box.children[i] ?? null);
    }
    this.rows = rows;
    const was = new Map(places);
    if (was.size) for (const row of rows.values()) if (row.offsetTop !== was.get(row)) settling(row);
  }
}
