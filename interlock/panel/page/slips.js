// Double slips with two machines: the way that a train takes over a slip rail, beside the middle of the diamond.
const NEAR = 1; // pixels

export class Slips {
  constructor(svg, edge, drawn) {
    this.edge = edge;
    this.all = [...svg.querySelectorAll(".rail")].map(path => {
      const {from, to, past} = path.dataset;
      return {path, from, to, past, arms: {[from]: drawn(`arm-${from}`), [to]: drawn(`arm-${to}`)}, length: path.getTotalLength()};
    });
  }

  over(edges) { return this.all.filter(r => edges.has(r.from) && edges.has(r.to)); }

  // what is drawn of a way: of the legs that a slip rail joins no more than their arms, and the rail
  paths(edges) {
    const left = new Set(edges), found = [];
    for (const r of this.over(left)) {
      for (const e of [r.from, r.to, r.past]) left.delete(e);
      found.push(r.path, ...Object.values(r.arms));
    }
    return [...found, ...[...left].map(e => this.edge[e]?.path).filter(Boolean)];
  }

  // rails and arms beside the edges of a section
  beside(edges) { return this.all.filter(r => edges.includes(r.from)).flatMap(r => [r.path, ...Object.values(r.arms)]); }

  // the arms of a way over a rail are seen only while they show something
  used() {
    for (const r of this.all) for (const arm of Object.values(r.arms)) arm.classList.toggle("used", arm.matches(".locked, .overlap"));
  }

  // the rail under a train that stands on some edges, where it stands on both legs, or on one with the blades set for it
  under(edges, set) {
    return this.all.filter(r => [r.from, r.to].every(e => edges.has(e)) || ([r.from, r.to].some(e => edges.has(e)) && [r.from, r.to].every(set)));
  }

  // a spot of an edge, so far along its line, or beside it on the rail
  spot(name, far, rails) {
    const e = this.edge[name], r = rails.find(r => [r.from, r.to, r.past].includes(name));
    if (!r) return e.path.getPointAtLength(far);
    if (name === r.past) return r.path.getPointAtLength(r.length / 2);
    const arm = r.arms[name], length = arm.getTotalLength(), end = arm.getPointAtLength(length), first = e.path.getPointAtLength(0);
    const from = Math.hypot(first.x - end.x, first.y - end.y) < NEAR ? far : e.length - far; // from the far end of the leg
    if (from <= length || e.length - length < NEAR) return e.path.getPointAtLength(far);
    const half = r.length / 2 * (from - length) / (e.length - length);
    return r.path.getPointAtLength(name === r.from ? half : r.length - half);
  }
}
