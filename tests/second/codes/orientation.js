'use strict';
// Half-edges of a rooted sphere and the orientation of its inner edges (CODE-TREE-1 to CODE-TREE-3).

const { next, previous } = require('../corners.js');

/** CODE-TREE-1. A corner names the half-edge from its vertex to the vertex of the next corner; the root is corner 0. */
class HalfEdges {
  constructor({ vertex, opposite, vertices }) {
    Object.assign(this, { vertex, opposite, vertices });
  }

  from(half) {
    return this.vertex[half];
  }

  to(half) {
    return this.vertex[next(half)];
  }

  /** About its vertex, the half-edge after one. */
  after(half) {
    return next(this.opposite[next(half)]);
  }

  reverse(half) {
    return next(this.opposite[previous(half)]);
  }
}

/** CODE-TREE-3: for each half-edge whether the edge is directed as it runs. */
function orientation(half) {
  const [v0, v1, v2] = half.vertex;
  const goesOut = new Uint8Array(half.vertex.length);
  // The path as a linked list from v2 to v1, and for each vertex on it the half-edge to its neighbour towards v2.
  const towards1 = new Int32Array(half.vertices).fill(-1);
  const towards2 = new Int32Array(half.vertices).fill(-1);
  const edgeTowards2 = new Int32Array(half.vertices).fill(-1);
  const onPath = new Uint8Array(half.vertices);
  const chords = new Int32Array(half.vertices); // edges to vertices of the path that are not beside it

  const link = (one, other, edge) => { // `edge` runs from `other` to `one`
    towards1[one] = other;
    towards2[other] = one;
    edgeTowards2[other] = edge;
  };
  link(v2, v0, half.after(0));
  link(v0, v1, half.reverse(0));
  for (const corner of [v0, v1, v2]) onPath[corner] = 1;
  chords[v1] = 1; // v1 and v2 are joined from the beginning
  chords[v2] = 1;

  let taken = v0; // the vertex nearest to v1 that may be taken
  while (towards1[v2] !== v1) {
    while (chords[taken] > 0) taken = towards2[taken];
    const [before, behind] = [towards2[taken], towards1[taken]];
    const outwards = edgeTowards2[taken];
    if (taken !== v0) goesOut[outwards] = 1;
    let last = before;
    const fresh = [];
    let edge = half.after(outwards);
    for (; half.to(edge) !== behind; edge = half.after(edge)) {
      goesOut[half.reverse(edge)] = 1;
      const vertex = half.to(edge);
      link(last, vertex, half.reverse(faceEdge(half, edge))); // in the face (taken, last, vertex)
      onPath[vertex] = 1;
      fresh.push(vertex);
      last = vertex;
    }
    if (taken !== v0) goesOut[edge] = 1;
    link(last, behind, half.reverse(faceEdge(half, edge)));
    onPath[taken] = 0;
    if (fresh.length === 0) {
      chords[before] -= 1;
      chords[behind] -= 1;
    }
    countChords(half, fresh, { onPath, chords, towards1, towards2 });
    taken = behind === v1 ? towards2[v1] : behind;
  }
  return goesOut;
}

/** For the half-edge from x to z: in the face (x, y, z), the half-edge from y to z. */
function faceEdge(half, edge) {
  // across (z, x) lies the corner of z in the face (x, y, z): its half-edge runs to x, and the one before it from y
  return previous(half.reverse(edge));
}

function countChords(half, fresh, { onPath, chords, towards1, towards2 }) {
  const isFresh = new Set(fresh);
  for (const vertex of fresh) {
    const first = half.leaving[vertex];
    let edge = first;
    do {
      const other = half.to(edge);
      if (onPath[other] && other !== towards1[vertex] && other !== towards2[vertex]) {
        chords[vertex] += 1;
        if (!isFresh.has(other)) chords[other] += 1; // another fresh one counts it for itself
      }
      edge = half.after(edge);
    } while (edge !== first);
  }
}

/** A surface's half-edges, with one that leaves each vertex. */
function halfEdgesOf(surface) {
  const half = new HalfEdges(surface);
  half.leaving = new Int32Array(surface.vertices);
  for (let corner = 0; corner < surface.vertex.length; corner += 1) half.leaving[surface.vertex[corner]] = corner;
  return half;
}

module.exports = { halfEdgesOf, orientation };
