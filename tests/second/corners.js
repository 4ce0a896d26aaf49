'use strict';
// The corner table (CPLX-CORNER-1, CPLX-CORNER-2).

const BORDER = -1;

const next = (corner) => (corner % 3 === 2 ? corner - 2 : corner + 1);
const previous = (corner) => (corner % 3 === 0 ? corner + 2 : corner - 1);
const faceOf = (corner) => Math.floor(corner / 3);

/**
 * All corners at the vertex of a corner, by swinging both ways (CPLX-CORNER-4): `opposite` is enough for it.
 */
function forEachCornerAround(opposite, start, visit) {
  let corner = start;
  do {
    visit(corner);
    const across = opposite[next(corner)];
    corner = across < 0 ? BORDER : next(across);
  } while (corner !== BORDER && corner !== start);
  if (corner === start) return;
  for (corner = start; ; ) {
    const across = opposite[previous(corner)];
    if (across < 0) return;
    corner = previous(across);
    visit(corner);
  }
}

class Surface {
  constructor(vertex, opposite, vertices) {
    this.vertex = vertex;
    this.opposite = opposite;
    this.vertices = vertices;
    this.faces = vertex.length / 3;
  }

  /** CPLX-CORNER-1: the ends of the edge of a corner, as its face runs it. */
  tail(corner) {
    return this.vertex[next(corner)];
  }

  head(corner) {
    return this.vertex[previous(corner)];
  }

  triangle(corner) {
    return [this.vertex[corner], this.vertex[next(corner)], this.vertex[previous(corner)]];
  }

  triangles() {
    return Array.from({ length: this.faces }, (_, face) => this.triangle(3 * face));
  }

  /** For each vertex on a boundary curve, the corner of the border edge that begins there; else BORDER. */
  borderFrom() {
    const from = new Int32Array(this.vertices).fill(BORDER);
    for (let corner = 0; corner < this.vertex.length; corner += 1) {
      if (this.opposite[corner] === BORDER) from[this.tail(corner)] = corner;
    }
    return from;
  }
}

/** CPLX-CURVE-1, EB-ORDER-2: the vertices of the curve of a vertex, from there on, as the faces run its edges. */
function curveFrom(surface, borderFrom, vertex) {
  const curve = [];
  let here = vertex;
  do {
    curve.push(here);
    here = surface.head(borderFrom[here]);
  } while (here !== vertex);
  return curve;
}

module.exports = { BORDER, next, previous, faceOf, forEachCornerAround, Surface, curveFrom };
