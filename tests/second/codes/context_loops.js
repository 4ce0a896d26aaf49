'use strict';
// The loops as the code `context` sees them (CODE-CONTEXT-2, CODE-CONTEXT-3): each edge with its count.

const { Loops } = require('../loops.js');

const GONE = -1;
const RIGHT = 1;
const LEFT = 2;

/** Undoes a word from its end. The symbol undone as number n has the edges 3n (gate), 3n + 1 right, 3n + 2 left. */
class CountedLoops {
  constructor(symbols, closings) {
    this.loops = new Loops(3 * symbols);
    this.count = new Int32Array(3 * symbols).fill(GONE); // of an edge in a loop: triangles undone around its start
    this.undone = 0;
    this.stack = [];
    this.closings = closings;
    this.closed = 0; // the closings used so far
    this.passed = 0; // the S without record since the last with one
    this.edges = { right: [], left: [] }; // of R and E, of L and E, the last undone at the end
    this.valences = [0, 0]; // of the vertices that left last
  }

  get gate() {
    return this.stack.length === 0 ? GONE : this.stack[this.stack.length - 1];
  }

  /** Whether the next S has a record. */
  get recorded() {
    return this.closed < this.closings.length && this.closings[this.closed].passed <= this.passed;
  }

  /** The edge that the next S closes, or none. */
  get partner() {
    if (!this.recorded) return this.stack.length < 2 ? GONE : this.stack[this.stack.length - 2];
    const { side, between } = this.closings[this.closed];
    const edges = this.edges[side];
    return edges[edges.length - 1 - Number(between)] ?? GONE;
  }

  /** CODE-CONTEXT-3. */
  canSplit() {
    const { gate, partner, loops } = this;
    if (partner === GONE || this.count[partner] === GONE || partner === gate) return false;
    return loops.after[gate] !== partner && loops.after[partner] !== gate && loops.after[partner] !== partner;
  }

  undo(symbol) {
    const gate = 3 * this.undone;
    this.undone += 1;
    const entered = this.gate;
    switch (symbol) {
      case 'E': this.undoE(gate); break;
      case 'R': this.undoR(gate, entered); break;
      case 'L': this.undoL(gate, entered); break;
      case 'C': this.undoC(gate, entered); break;
      default: this.undoS(gate, entered);
    }
    if (symbol === 'R' || symbol === 'E') this.edges.right.push(gate + RIGHT);
    if (symbol === 'L' || symbol === 'E') this.edges.left.push(gate + LEFT);
  }

  replaceTop(gate) {
    this.stack[this.stack.length - 1] = gate;
  }

  undoE(gate) {
    const { loops, count } = this;
    loops.join(gate, gate + RIGHT);
    loops.join(gate + RIGHT, gate + LEFT);
    loops.join(gate + LEFT, gate);
    count.fill(1, gate, gate + 3);
    this.stack.push(gate);
  }

  undoR(gate, entered) {
    const { loops, count } = this;
    const [before, after] = [loops.before[entered], loops.after[entered]];
    count[gate] = count[entered] + 1;
    count[gate + RIGHT] = 1;
    count[after] += 1;
    count[entered] = GONE;
    loops.join(before, gate);
    loops.join(gate, gate + RIGHT);
    loops.join(gate + RIGHT, after);
    this.replaceTop(gate);
  }

  undoL(gate, entered) {
    const { loops, count } = this;
    const [before, after] = [loops.before[entered], loops.after[entered]];
    count[gate + LEFT] = count[entered] + 1;
    count[gate] = 1;
    count[after] += 1;
    count[entered] = GONE;
    loops.join(before, gate + LEFT);
    loops.join(gate + LEFT, gate);
    loops.join(gate, after);
    this.replaceTop(gate);
  }

  undoC(gate, entered) {
    const { loops, count } = this;
    const last = loops.before[entered];
    const [before, after] = [loops.before[last], loops.after[entered]];
    this.valences = [count[entered] + 1, this.valences[0]];
    count[gate] = count[last] + 1;
    count[after] += 1;
    count[entered] = GONE;
    count[last] = GONE;
    loops.join(before, gate);
    loops.join(gate, after);
    this.replaceTop(gate);
  }

  undoS(gate, entered) {
    const { loops, count, partner } = this;
    const afterPartner = loops.after[partner];
    const afterEntered = loops.after[entered];
    const [beforeEntered, beforePartner] = [loops.before[entered], loops.before[partner]];
    count[gate] = count[partner] + 1;
    count[afterEntered] += 1;
    count[afterPartner] += count[entered] + 1;
    count[entered] = GONE;
    count[partner] = GONE;
    loops.join(beforeEntered, afterPartner);
    loops.join(beforePartner, gate);
    loops.join(gate, afterEntered);
    if (this.recorded) {
      this.closed += 1;
      this.passed = 0;
    } else {
      this.passed += 1;
      this.stack.pop();
    }
    this.replaceTop(gate);
  }
}

module.exports = { CountedLoops, GONE };
