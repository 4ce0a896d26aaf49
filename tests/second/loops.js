'use strict';
// The loops of the region as rings of edges (EB-REVERSI-1).

class Loops {
  constructor(edges) {
    this.after = new Int32Array(edges);
    this.before = new Int32Array(edges);
  }

  join(one, other) {
    this.after[one] = other;
    this.before[other] = one;
  }

  /** Whether the loop of an edge has fewer edges than so many. */
  shorter(edge, length) {
    let here = edge;
    for (let step = 1; step < length; step += 1) {
      here = this.after[here];
      if (here === edge) return true;
    }
    return false;
  }
}

module.exports = { Loops };
