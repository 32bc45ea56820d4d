// The socket to the server: says hello, comes back by itself, knows how old its news are.  What is asked says when that
// was, by the server's clock: `heard`, the time of the newest message that was known then, and `after`, the milliseconds
// since; what the page has sent it cannot take back, but who takes it late can see that it is late.
export const OLD_MS = 1000;

export class Talk {
  constructor(who, heard) {
    this.who = who; this.heard = heard; this.waiting = new Map(); this.mark = 0;
    this.last = -Infinity; this.late = null; this.newest = null; this.refused = "";
    this.open();
  }

  open() {
    const scheme = location.protocol === "https:" ? "wss" : "ws";
    const ws = this.ws = new WebSocket(`${scheme}://${location.host}/talk`);
    this.late = null;
    ws.onopen = () => ws.send(JSON.stringify(this.who()));
    ws.onmessage = e => this.message(JSON.parse(e.data));
    ws.onclose = () => {
      for (const {done} of this.waiting.values()) done({ok: false, title: "No answer", why: [["the connection was lost: not known whether it was done: look at the plan", []]]});
      this.waiting.clear();
      if (!this.refused) setTimeout(() => this.open(), 400);
    };
  }

  message(m) {
    if (m.refused) { this.refused = m.refused; this.heard(m); return; }
    if ("re" in m) { this.waiting.get(m.re)?.done(m); this.waiting.delete(m.re); return; }
    // news that were long on their way are old when they come: the clocks differ by what the quickest message shows
    const way = Date.now() - 1000 * m.t;
    this.late = this.late === null ? way : Math.min(this.late, way);
    this.last = performance.now() - (way - this.late);
    this.newest = m.t;
    this.heard(m);
  }

  // milliseconds for which what was asked longest ago waits for its answer
  get waits() { return Math.max(0, ...[...this.waiting.values()].map(({since}) => performance.now() - since)); }

  get old() { return performance.now() - this.last > OLD_MS; }

  ask(command) {
    if (this.old || this.ws.readyState !== WebSocket.OPEN) return Promise.resolve({ok: false, title: "Not sent", why: [["no news from the server: nothing was sent", []]]});
    const re = ++this.mark, since = performance.now();
    return new Promise(done => {
      this.waiting.set(re, {done, since});
      this.ws.send(JSON.stringify({...command, re, heard: this.newest, after: Math.round(since - this.last)}));
    });
  }

  again() { this.ws.close(); }
}
