// What can be done with an element: words, and the command that a button sends.  An element has the same buttons in the
// same places all the time: what cannot be done now is `off`.  Only what belongs to trains comes and goes, below all others.
export const act = (label, command, extra = {}) => ({label, command, ...extra});

export function routesFrom(still, signal) { return still.routes.filter(r => r.entry === signal && r.kind !== "identifier"); }

// a failed thing is put right by the button that made it fail
const fault = (sys, kind, name, label) => {
  const on = !sys.failed.some(([k, n]) => k === kind && n === name);
  return act(`${on ? "Fail" : "Put right"}: ${label}`, {do: "fail", kind, name, on}, {fault: true});
};

// what rests on somebody's word is asked for twice: what it rests on and leads to, and the button that does it
export function promise(still, c, blockedBy, me) {
  const section = `section ${c.section}`, by = blockedBy === me ? "" : blockedBy || "somebody";
  if (c.do === "release") return [`Has somebody made sure that ${section} is clear, and that no train comes to it?  Released, its points can move and other routes can lead over it.`, "It is clear: release it"];
  if (c.do === "release all") return ["Does everything stand that ran, and nothing where the track reads clear?  All that reads clear is released: its points can move and routes can lead over it.", "It is so: release all that is clear"];
  if (c.do === "looked") return [`Has somebody looked at ${still.machines[c.machine].called}, and are they whole and lie well?  Trains run over them then.`, "They lie well"];
  if (c.do === "direction" && c.on) return [`Has the neighbour at ${still.boundaries[c.boundary].label} agreed by telephone that no train is on the line, and that he sends none?  The direction is ours then, and trains can leave.`, "It is agreed: change it"];
  if (c.do === "block" && !c.on && by) return [`${section[0].toUpperCase()}${section.slice(1)} was blocked by ${by}: does he know, and has everybody left the track?  Freed, routes can lead over it.`, "All have left: free it"];
  return null;
}

export function acts(still, state, rest, key) {
  const kind = key[0], name = key.slice(2), sys = rest.sys, now = state[key];
  const make = {s: section, m: machine, g: signal, b: boundary}[kind];
  const found = make ? make(still, state, rest, name, now, sys) : {lines: [], acts: []};
  const stand = kind === "s" && still.simulated ? rest.trains.filter(t => t[4].includes(name)).flatMap(train) : [];
  return {...found, trains: stand, remind: key in state};
}

function section(still, state, rest, name, [occupied, ways, restart, blocked, stale, left, releasing, sick, over = []] = [], sys) {
  const one = still.sections[name], lines = [], out = [];
  lines.push([one.detected === false ? "without detection: it always counts as occupied" : occupied ? "occupied" : "clear", ways?.length ? "locked" : over.length ? `locked as overlap of ${over.join(", ")}` : "not locked", restart ? "not released since the restart" : "",
    blocked ? "blocked" : "", ["", "inputs were lost while it was locked: cancel the route, or release it by hand", "a train is called on over it: release it by hand when it has gone"][stale ?? 0], sick ? "detector out of order" : ""].filter(Boolean).join(", "));
  if (!one.approach) {
    out.push(act("Release by hand", {do: "release", section: name}, {off: releasing || one.detected === false || !(restart || ways?.length)}));
    out.push(blocked ? act("Free it again", {do: "block", section: name, on: false}) : act("Block", {do: "block", section: name, on: true}));
  }
  if (still.simulated) {
    for (const t of still.stands[name] ?? []) out.push(act(`Put a train here, towards ${t}`, {do: "put", section: name, towards: t}, {train: true}));
    if (one.detected) out.push(fault(sys, "section", name, "detector reads occupied"));
  }
  return {lines, acts: out};
}

export function train([name, , speed, metres, , held]) {
  const off = held === null; // it waits beyond the boundary
  return [
    held ? act(`${name}: go`, {do: "drive", train: name, go: true}) : act(`${name}: stop`, {do: "drive", train: name, go: false}, {off}),
    act(`${name}: change ends`, {do: "turn train", train: name}, {off}), act(`${name}: divide`, {do: "divide", train: name}, {off}),
    act(`${name}: take away`, {do: "take away", train: name}),
  ];
}

function machine(still, state, rest, name, [lies, wanted, locked, late, trailed, why = ""] = [], sys) {
  const one = still.machines[name], words = one.lies, out = [];
  const not = one.device ? "not proved open or closed" : "not detected";
  const lines = [[words[lies] ?? (late ? `${not} in time` : not), wanted && wanted !== lies ? `commanded ${words[wanted]}` : "", locked ? why || "locked" : "", trailed ? one.trailed : ""].filter(Boolean).join(", ")];
  if (one.hand) for (const to of ["N", "R"]) out.push(act(one.move[to], {do: "turn", machine: name, to}, {off: to === lies}));
  if (!one.device) out.push(act("It was looked at, and lies well", {do: "looked", machine: name}, {off: !trailed}));
  if (still.simulated) out.push(fault(sys, "machine", name, "detection lost"));
  return {lines, acts: out};
}

function signal(still, state, rest, name, [aspect, cancelling, left, active, lamp, kmh = null] = [], sys) {
  const out = [], lines = [[`${aspect}${kmh ? ` at ${kmh} km/h` : ""}`, active ? `route ${active[0]} is set` : "", cancelling ? "cancelling" : "", lamp === null ? "inputs are lost: not known whether its stop lamp is lit" : lamp ? "stop lamp out" : ""].filter(Boolean).join(", ")];
  const routes = routesFrom(still, name);
  if (routes.length) {
    const stop = active && aspect === "stop";
    const byItself = routes.some(r => r.automatic && state[`a:${r.id}`]?.[0]);
    out.push(act(active ? `Cancel ${active[0]}` : "Cancel", {do: "cancel", signal: name}, {off: !active && !byItself}));
    out.push(act("Open it again", {do: "set", route: active?.[0]}, {off: !stop}));
    out.push(act("Why is it at stop?", {do: "why", route: active?.[0]}, {why: true, off: !stop}));
  }
  if (still.swings.includes(name)) out.push(act("Swing its overlap", {do: "swing", signal: name}));
  for (const r of routes) out.push(act(`Set ${r.names[0] ? `${r.names[0]}: ` : ""}${r.id}${r.kind === "main" ? "" : ` (${r.kind})`}${r.overlap ? `, ${r.overlap}` : ""}`, {do: "set", route: r.id}, {route: r}));
  for (const r of routes.filter(r => r.automatic)) {
    const on = state[`a:${r.id}`]?.[0];
    out.push(act(`${r.id}: ${on ? "no longer automatic" : "automatic"}`, {do: "automatic", route: r.id, on: !on}));
  }
  for (const [what, input] of Object.entries(still.lamps[name] ?? {})) out.push(fault(sys, "lamp", input, `${what} ${what === "speed" ? "indicator" : "lamp"} out`));
  return {lines, acts: out, entry: routes.length > 0};
}

function boundary(still, state, rest, name, token) {
  const one = still.boundaries[name], out = [], lines = [];
  if (token) {
    const known = token[0] !== null;
    lines.push(known ? `direction: ${token[0] ? "ours" : token[1] ? "being given" : "not ours"}; line ${token[2] === null ? "not known: inputs are lost" : token[2] ? "clear" : "not clear"}` : "direction: not known without power");
    if (known && !token[0] && !token[1]) lines.push("After a restart it may be nobody's: agree by telephone, then change it by hand.");
    if (token[3]) lines.push(`Special manual change of direction: on${token[4] === null ? "" : `, complete in ${token[4]} s`}.`);
    out.push(act("Special manual change: on", {do: "direction", boundary: name, on: true}, {off: Boolean(token[3] || token[0])}), act("Special manual change: off", {do: "direction", boundary: name, on: false}, {off: !token[3]}));
  }
  if (still.simulated && one.comes) out.push(act("A train comes in here", {do: "bring", boundary: name}, {train: true}));
  return {lines, acts: out};
}

// steps after power has come, or inputs were lost; null when there is nothing to do
export function steps(still, state, sys) {
  const lost = s => state[`s:${s}`][4] === 1; // and not because a train is called on over it
  const seen = s => still.sections[s]?.detected !== false; // what has no detection is never released, and nothing asks for it
  const restart = sys.restart.filter(seen), clear = s => !state[`s:${s}`][0];
  const stale = Object.entries(state).filter(([k, v]) => k[0] === "s" && v[4]).map(([k]) => k.slice(2)).filter(seen);
  if (sys.power && sys.valid && !restart.length && !stale.some(lost)) return null;
  const waiting = sys.delay !== null && sys.delay > 0;
  const occupied = [...restart, ...stale.filter(lost)].filter(s => !clear(s)), ready = [...restart, ...stale].filter(clear);
  return [
    [sys.power, sys.power ? "The controller has power." : "The controller has no power."],
    [sys.power && sys.valid, sys.valid ? "All substations report." : `Substations that do not report: ${sys.lost.map(l => l.split(":")[0]).filter(l => still.stations.includes(l)).join(", ") || "waiting for heartbeats"}.`],
    [sys.power && sys.valid && !waiting, waiting ? `The restart delay runs: ${sys.delay} s.  Trains that still ran come to a stand.${still.simulated ? "  To wait less, let time run faster (above)." : ""}` : "The restart delay is over."],
    [sys.valid && !occupied.length, occupied.length ? `Occupied: released when clear: ${occupied.join(", ")}.  Ask who stands there; a false report is a fault to mend.` : "No section that waits for its release is reported occupied."],
    [sys.valid && !ready.length, ready.length ? `Release what is clear: ${ready.join(", ")}.` : "Nothing that is clear is left to be released.",
      sys.valid && !waiting && !sys.releasing && Boolean(ready.length)],
    [false, "Trains that stand inside are called on by their signals, or moved under local rules; then release what they leave."],
  ];
}
