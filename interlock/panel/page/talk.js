// The socket to the server: says hello, comes back by itself, knows how old its news are.
export const OLD_MS = 1000;

export class Talk {
  constructor(who, heard) {
    this.who = who; this.heard = heard; this.waiting = new Map(); this.mark = 0;
    this.last = -Infinity; this.late = null; this.refused = "";
    this.open();
  }

  open() {
    const scheme = location.protocol === "https:" ? "wss" : "ws";
    const ws = this.ws = new WebSocket(`${scheme}://${location.host}/talk`);
    this.late = null;
    ws.onopen = () => ws.send(JSON.stringify(this.who()));
    ws.onmessage = e => this.message(JSON.parse(e.data));
    ws.onclose = () => {
      for (const done of this.waiting.values()) done({ok: false, why: [["the server is gone: nothing was done", []]]});
      this.waiting.clear();
      if (!this.refused) setTimeout(() => this.open(), 400);
    };
  }

  message(m) {
    if (m.refused) { this.refused = m.refused; this.heard(m); return; }
    if ("re" in m) { this.waiting.get(m.re)?.(m); this.waiting.delete(m.re); return; }
    // news that were long on their way are old when they come: the clocks differ by what the quickest message shows
    const way = Date.now() - 1000 * m.t;
    this.late = this.late === null ? way : Math.min(this.late, way);
    this.last = performance.now() - (way - this.late);
    this.heard(m);
  }

  get old() { return performance.now() - this.last > OLD_MS; }

  ask(command) {
    if (this.old) return Promise.resolve({ok: false, why: [["no news from the server: nothing was sent", []]]});
    const re = ++this.mark;
    return new Promise(done => {
      this.waiting.set(re, done);
      this.ws.send(JSON.stringify({...command, re}));
    });
  }

  again() { this.ws.close(); }
}
