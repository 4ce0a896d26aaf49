"use strict";
// The search. It needs nothing but the entries of search-index.js, and works from files as well.

/** An entry is [kind, title, page, address, text]; see clers/site/entries.py. */
const KIND = 0, TITLE = 1, PAGE = 2, HREF = 3, TEXT = 4;
const KINDS = ["clause", "law", "section"];

/** Lower case, accents apart: what is compared is never what is shown. */
const plain = (text) => text.normalize("NFKD").replace(/\p{M}/gu, "").toLowerCase();

/** The words of a text; signs divide them. */
const words = (text) => plain(text).split(/[^\p{L}\p{N}]+/u).filter((word) => word !== "");

/** Where a word with this beginning stands in a plain text; -1 if nowhere. */
function beginning(text, prefix) {
  for (let at = text.indexOf(prefix); at >= 0; at = text.indexOf(prefix, at + 1))
    if (at === 0 || !/[\p{L}\p{N}]/u.test(text[at - 1])) return at;
  return -1;
}

/** How well an entry answers, least best; Infinity if it does not. Clause: TOOL-SITE-7. */
function rank(entry, question, asked) {
  const title = plain(entry[TITLE]);
  if (title === question) return 0;
  if (entry[KIND] === "clause" && title.startsWith(question)) return 1;
  if (asked.every((word) => beginning(title, word) >= 0)) return 2;
  const text = `${title} ${plain(entry[TEXT])}`;
  return asked.every((word) => beginning(text, word) >= 0) ? 3 : Infinity;
}

/** The entries that answer a question, best first. Clause: TOOL-SITE-7. */
function find(entries, question) {
  const asked = words(question);
  if (asked.length === 0) return [];
  const exact = plain(question.trim());
  return entries
    .map((entry, place) => ({ entry, place, rank: rank(entry, exact, asked) }))
    .filter((found) => found.rank < Infinity)
    .sort((a, b) =>
      Math.max(a.rank, 1.5) - Math.max(b.rank, 1.5) && (a.rank < 2 || b.rank < 2)
        ? a.rank - b.rank
        : KINDS.indexOf(a.entry[KIND]) - KINDS.indexOf(b.entry[KIND]) ||
          a.rank - b.rank || a.place - b.place)
    .map((found) => found.entry);
}

/** Some of an entry's text around the first word asked for: [before, the word, after]. */
function excerpt(entry, question) {
  const text = entry[TEXT], low = text.toLowerCase();
  const at = words(question).map((word) => [beginning(low, word), word.length])
    .filter(([place]) => place >= 0).sort((a, b) => a[0] - b[0])[0];
  if (!at) return [text.slice(0, 160), "", text.length > 160 ? "…" : ""];
  const from = Math.max(0, at[0] - 60);
  const to = Math.min(text.length, from + 180);
  return [
    (from > 0 ? "…" : "") + text.slice(from, at[0]),
    text.slice(at[0], at[0] + at[1]),
    text.slice(at[0] + at[1], to) + (to < text.length ? "…" : ""),
  ];
}

if (typeof module !== "undefined") module.exports = { find, excerpt };

if (typeof document !== "undefined") {
  const top = document.currentScript.dataset.top;
  const SHOWN = 100;
  let loading = null;

  /** The entries, loaded when they are first asked for. */
  const entries = () => (loading ??= new Promise((done, failed) => {
    const script = document.createElement("script");
    script.src = `${top}search-index.js`;
    script.onload = () => done(globalThis.clersEntries);
    script.onerror = failed;
    document.head.append(script);
  }));

  const element = (name, ...children) => {
    const made = document.createElement(name);
    made.append(...children);
    return made;
  };

  function line(entry, question) {
    const link = element("a", element("b", entry[TITLE]), element("i", entry[PAGE]));
    const [before, word, after] = excerpt(entry, question);
    link.append(element("span", before, element("mark", word), after));
    link.href = top + entry[HREF];
    return element("li", link);
  }

  async function show(question) {
    const place = document.getElementById("site-results");
    if (words(question).length === 0) { place.hidden = true; return; }
    const found = find(await entries(), question);
    if (question !== document.getElementById("site-search").value) return;
    const said = found.length > SHOWN ? `${found.length} found, the first ${SHOWN} shown` : `${found.length} found`;
    const status = element("p", said);
    status.setAttribute("role", "status");
    place.replaceChildren(status, element("ol", ...found.slice(0, SHOWN).map((entry) => line(entry, question))));
    place.hidden = false;
  }

  addEventListener("DOMContentLoaded", () => {
    const box = document.getElementById("site-search");
    const place = document.getElementById("site-results");
    const links = () => [...place.querySelectorAll("li a")];
    box.addEventListener("focus", () => entries(), { once: true });
    box.addEventListener("input", () => show(box.value));
    box.form.addEventListener("submit", (event) => {
      event.preventDefault();
      if (!place.hidden && links().length) links()[0].click();
    });
    place.addEventListener("click", (event) => { if (event.target.closest("a")) place.hidden = true; });
    addEventListener("keydown", (event) => {
      const typing = /^(input|textarea)$/i.test(document.activeElement.tagName);
      if (event.key === "/" && !typing && !event.ctrlKey && !event.metaKey && !event.altKey) {
        event.preventDefault();
        box.focus();
        box.select();
      } else if (event.key === "Escape" && !place.hidden) {
        place.hidden = true;
        box.focus();
      } else if ((event.key === "ArrowDown" || event.key === "ArrowUp") && !place.hidden) {
        const stops = [box, ...links()];
        const at = stops.indexOf(document.activeElement);
        if (at < 0) return;
        event.preventDefault();
        stops[Math.min(Math.max(at + (event.key === "ArrowDown" ? 1 : -1), 0), stops.length - 1)].focus();
      }
    });
    const asked = new URLSearchParams(location.search).get("q");
    if (asked) { box.value = asked; show(asked); }
    document.querySelector("#site-chapters [aria-current]")?.scrollIntoView({ block: "nearest" });
  });
}
