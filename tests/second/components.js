'use strict';
// Components and what is counted of them (CPLX-COMPONENT-1 to CPLX-COMPONENT-3).

const { BORDER, curveFrom, faceOf } = require('./corners.js');

/** The component of each face, numbered by lowest faces. */
function componentOfFaces(surface) {
  const component = new Int32Array(surface.faces).fill(-1);
  let components = 0;
  for (let lowest = 0; lowest < surface.faces; lowest += 1) {
    if (component[lowest] >= 0) continue;
    const waiting = [lowest];
    component[lowest] = components;
    while (waiting.length > 0) {
      const face = waiting.pop();
      for (let corner = 3 * face; corner < 3 * face + 3; corner += 1) {
        const across = surface.opposite[corner];
        if (across === BORDER || component[faceOf(across)] >= 0) continue;
        component[faceOf(across)] = components;
        waiting.push(faceOf(across));
      }
    }
    components += 1;
  }
  return { component, components };
}

function classify(surface) {
  const { component, components } = componentOfFaces(surface);
  const counts = Array.from({ length: components }, () => (
    { faces: 0, vertices: 0, edges: 0, boundary_edges: 0, curves: 0, genus: 0, euler: 0 }));
  for (const number of component) counts[number].faces += 1;
  const home = new Int32Array(surface.vertices);
  surface.vertex.forEach((vertex, corner) => { home[vertex] = component[faceOf(corner)]; });
  for (const number of home) counts[number].vertices += 1;

  const borderFrom = surface.borderFrom();
  const seen = new Uint8Array(surface.vertices);
  borderFrom.forEach((corner, vertex) => {
    if (corner === BORDER) return;
    counts[home[vertex]].boundary_edges += 1;
    if (seen[vertex]) return;
    counts[home[vertex]].curves += 1;
    for (const onCurve of curveFrom(surface, borderFrom, vertex)) seen[onCurve] = 1;
  });
  for (const of of counts) {
    of.edges = (3 * of.faces + of.boundary_edges) / 2; // CPLX-COMPONENT-2
    of.euler = of.vertices - of.edges + of.faces;
    of.genus = (2 - of.curves - of.euler) / 2; // CPLX-COMPONENT-3
  }
  return counts;
}

module.exports = { classify };
