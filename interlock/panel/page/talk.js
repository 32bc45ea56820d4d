// The socket to the server: says hello, comes back by itself, knows how old its news are.  What is asked says when that
// was, by the server's clock: `heard`, the time of the newest message that was known then, and `after`, the milliseconds
// since; what the page has sent it cannot take back, but who takes it late can see that it is late.
export const OLD_MS = 1000;
const ASKS_MS = 2000; // the server is asked for its clock
const DRIFT_MS = 1; // between two such questions, and where a clock is read in whole milliseconds

// what does no harm however late it comes is sent however old the news are
const neverLate = c => c.do === "stop" || c.do === "cancel" || (c.do === "block" && c.on);
const unsent = why => ({ok: false, title: "Not sent", unsent: true, why: [[why, []]]});

export class Talk {
  constructor(who, heard) {
    this.who = who; this.heard = heard; this.waiting = new Map(); this.mark = 0;
    this.last = this.came = -Infinity; this.newest = null; this.refused = "";
    this.kept = null; // all signals to stop, which is sent as soon as that can be
    this.open();
    setInterval(() => this.clock(), ASKS_MS);
  }

  open() {
    const scheme = location.protocol === "https:" ? "wss" : "ws";
    const ws = this.ws = new WebSocket(`${scheme}://${location.host}/talk`);
    this.least = -Infinity; this.most = Infinity;
    ws.onopen = () => { this.opened = performance.now(); ws.send(JSON.stringify(this.who())); };
    ws.onmessage = e => this.message(JSON.parse(e.data));
    ws.onclose = () => {
      for (const {command, since, done} of this.waiting.values()) {
        if (command.do === "stop") this.keep({command, since, done});
        else done({ok: false, title: "No answer", why: [["the connection was lost: not known whether it was done: look at the plan", []]]});
      }
      this.waiting.clear();
      if (!this.refused) setTimeout(() => this.open(), 400);
    };
  }

  message(m) {
    if (m.refused) { this.refused = m.refused; this.heard(m); return; }
    if ("clock" in m) { this.measured(m.re, m.clock); return; }
    if ("re" in m) { this.waiting.get(m.re)?.done(m); this.waiting.delete(m.re); return; }
    const now = this.came = performance.now();
    if (m.still) this.measured(this.opened, m.t); // it answers the hello
    const age = now - 1000 * m.t - this.least;
    if (age >= -DRIFT_MS) this.last = now - age;
    else this.clock(); // news of times to come: a clock was set, and nothing is known of their age
    this.newest = m.t;
    this.heard(m);
    if (m.still) { this.clock(); this.sendsKept(m.hello.operates); }
  }

  clock() {
    if (this.ws.readyState === WebSocket.OPEN && this.least > -Infinity) this.ws.send(JSON.stringify({do: "clock", re: Math.floor(performance.now())}));
  }

  // by how much our clock is ahead of the server's, between two bounds: his was read after we asked, and before we heard.
  // An age is reckoned with the lower bound, and is never less than it is
  measured(asked, t) {
    const least = asked - 1000 * t, most = performance.now() - 1000 * t;
    const both = [Math.max(least, this.least - DRIFT_MS), Math.min(most, this.most + DRIFT_MS)];
    [this.least, this.most] = both[0] <= both[1] ? both : [least, most]; // a clock was set: what was known before is over
  }

  // milliseconds for which what was asked longest ago waits for its answer
  get waits() { return Math.max(0, ...[...this.waiting.values()].map(({since}) => performance.now() - since)); }

  // milliseconds for which all signals to stop waits to be sent
  get keeps() { return this.kept ? performance.now() - this.kept.since : null; }

  get old() { return performance.now() - this.last > OLD_MS; }

  // whether messages come, however old they are
  get comes() { return performance.now() - this.came < OLD_MS; }

  ask(command) {
    const closed = this.ws.readyState !== WebSocket.OPEN || this.least === -Infinity, since = performance.now();
    if (closed && command.do === "stop" && !this.refused) return new Promise(done => this.keep({command, since, done}));
    if (closed) return Promise.resolve(unsent("there is no connection to the server: nothing was sent"));
    if (this.old && !neverLate(command)) return Promise.resolve(unsent("no news from the server: nothing was sent"));
    return new Promise(done => this.send({command, since, done}));
  }

  send(asked) {
    const re = ++this.mark;
    this.waiting.set(re, asked);
    this.ws.send(JSON.stringify({...asked.command, re, heard: this.newest, after: Math.round(asked.since - this.last)}));
  }

  keep(asked) {
    const before = this.kept;
    this.kept = before ? {...before, done: answer => { before.done(answer); asked.done(answer); }} : asked;
  }

  sendsKept(operates) {
    const {kept} = this;
    this.kept = null;
    if (kept && operates) this.send(kept);
    else kept?.done(unsent("this browser may only look"));
  }

  again() { this.ws.close(); }
}
