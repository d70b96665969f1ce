// Elements of the page by name, new ones, icons, short messages.

export function get<E extends HTMLElement = HTMLElement>(id: string): E {
  return document.getElementById(id) as E;
}

export function make<K extends keyof HTMLElementTagNameMap>(tag: K, text = "", className = ""): HTMLElementTagNameMap[K] {
  const element = document.createElement(tag);
  element.textContent = text;
  element.className = className;
  return element;
}

const strokes: Record<string, string> = {
  play: '<path class="full" d="M7 4l13 8-13 8z"/>',
  pause: '<path class="full" d="M6 4h4v16H6zM14 4h4v16h-4z"/>',
  step: '<path class="full" d="M5 4l10 8-10 8z"/><path d="M19 4v16"/>',
  reset: '<path class="full" d="M19 4L9 12l10 8z"/><path d="M5 4v16"/>',
  panel: '<path d="M4 6h16M4 12h16M4 18h16"/>',
  follow: '<circle cx="12" cy="12" r="4"/><path d="M12 2v5M12 17v5M2 12h5M17 12h5"/>',
  above: '<rect x="3" y="6" width="18" height="12"/><path d="M12 6v12"/><circle cx="12" cy="12" r="2.5"/>',
  names: '<path d="M3 8l9-5 9 5v11H3z"/><path d="M8 14h8"/>',
  contacts: '<path d="M12 20V6M7 10l5-6 5 6M4 20h16"/>',
  ghost: '<path d="M5 20V10a7 7 0 0 1 14 0v10l-3-2-2 2-2-2-2 2-2-2zM9 11v.5M15 11v.5"/>',
  push: '<path d="M3 12h11M10 7l5 5-5 5M20 4v16"/>',
  left: '<path d="M19 12H5M11 6l-6 6 6 6"/>',
  right: '<path d="M5 12h14M13 6l6 6-6 6"/>',
  up: '<path d="M12 19V5M6 11l6-6 6 6"/>',
  down: '<path d="M12 5v14M6 13l6 6 6-6"/>',
};

export function setIcon(button: HTMLElement, name: string): void {
  if (button.dataset["icon"] === name) return;
  button.dataset["icon"] = name;
  button.innerHTML = `<svg viewBox="0 0 24 24" aria-hidden="true">${strokes[name] ?? ""}</svg>`;
}

export function say(text: string, bad = false): void {
  const line = make("div", text, bad ? "bad" : "");
  const all = get("messages");
  all.append(line);
  while (all.children.length > 3) all.firstElementChild!.remove();
  window.setTimeout(() => line.remove(), bad ? 6000 : 2500);
}

export function toggle(button: HTMLElement, on: boolean): void {
  button.setAttribute("aria-pressed", String(on));
}
