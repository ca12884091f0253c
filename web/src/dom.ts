// The one place where text becomes part of the page. Text is only ever text here: nothing reads it as HTML, so a title,
// a formula or a column's name cannot bring in an element or a script.

type Child = Node | string | null;

/** An element with attributes and children. Strings become text. */
export function element<Name extends keyof HTMLElementTagNameMap>(
  name: Name,
  attributes: Readonly<Record<string, string>> = {},
  ...children: readonly Child[]
): HTMLElementTagNameMap[Name] {
  const out = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) out.setAttribute(key, value);
  for (const child of children) if (child !== null) out.append(child);
  return out;
}

/** The element of the page with this id. The template has it, or the program is wrong. */
export function byId<Kind extends Element = HTMLElement>(id: string): Kind {
  const found = document.getElementById(id);
  if (!found) throw new Error(`the page has no element ${id}`);
  return found as unknown as Kind;
}

/** Fills a select with options, and chooses one. */
export function fill(select: HTMLSelectElement, options: readonly { id: string; label: string }[], chosen: string): void {
  select.replaceChildren(...options.map((each) => element('option', { value: each.id }, each.label)));
  select.value = chosen;
}

/** A colour or a size of the style sheet, as it is now (it differs in the dark). */
export function styleValue(name: string): string {
  return getComputedStyle(document.documentElement).getPropertyValue(name).trim();
}

/** Sets a canvas to the pixels of its place on the page, and returns its size there. */
export function fitCanvas(canvas: HTMLCanvasElement): { width: number; height: number; ratio: number } {
  const ratio = window.devicePixelRatio || 1;
  const width = Math.max(1, canvas.clientWidth);
  const height = Math.max(1, canvas.clientHeight);
  const [w, h] = [Math.round(width * ratio), Math.round(height * ratio)];
  if (canvas.width !== w || canvas.height !== h) {
    canvas.width = w;
    canvas.height = h;
  }
  return { width, height, ratio };
}
