// The panel at the side: who is there, the selected one, events, plots, pictures of cameras.
import { get, make, say, setIcon } from "./elements";
import { Plot } from "./plot";
import type { Entity, SceneDocument } from "./scene";
import type { CameraNote, Line, Picture, Source, State } from "./source";

const tabs = ["Scene", "Events", "Plots", "Camera"] as const;
type Tab = (typeof tabs)[number];

export class Panel {
  onSelect: (entity: number) => void = () => undefined;
  onPush: (right: number, away: number) => void = () => undefined;
  onGroup: (name: string, on: boolean) => void = () => undefined;
  force = 40; // [N]
  pushTime = 0.1; // [s]
  private readonly pages = new Map<Tab, HTMLElement>();
  private readonly rows: HTMLElement[] = [];
  private readonly who = make("div", "", "tab");
  private readonly details = make("div");
  private readonly list = make("div", "", "list");
  private readonly groups = make("div", "", "details");
  private grouped = "";
  private readonly plots: Plot[] = [];
  private readonly plotList = make("div");
  private readonly picture = make("canvas");
  private readonly camera = make("select");
  private readonly cameraHint = make("p", "", "hint");
  private readonly path = make("input");
  private readonly names = make("datalist");
  private readonly events = make("div");
  private scene: SceneDocument | undefined;
  private selected = -1;
  private state: State | undefined;
  private levels: HTMLSelectElement | undefined;
  private contacts: HTMLSelectElement | undefined;
  private named = "";

  constructor(private readonly source: Source) {
    const bar = make("div");
    bar.id = "tabs";
    bar.setAttribute("role", "tablist");
    for (const tab of tabs) {
      const button = make("button", tab);
      button.setAttribute("role", "tab");
      if (tab === "Plots" || tab === "Camera") button.classList.add("live");
      button.onclick = () => this.open(tab);
      bar.append(button);
    }
    get("panel").append(bar);
    this.who.append(this.list, this.details, this.groups);
    this.pages.set("Scene", this.who);
    this.pages.set("Events", this.events);
    this.pages.set("Plots", this.makePlots());
    this.pages.set("Camera", this.makeCamera());
    for (const page of this.pages.values()) {
      page.classList.add("tab");
      get("panel").append(page);
    }
    this.events.append(make("p", "Nothing has happened yet.", "hint"));
    this.open("Scene");
  }

  show(scene: SceneDocument): void {
    this.scene = scene;
    this.rows.length = 0;
    this.list.replaceChildren();
    scene.text.entities.forEach((entity, i) => {
      const row = make("button");
      const dot = make("span", "", "dot");
      dot.style.background = `rgb(${entity.color.map((part) => Math.round(255 * part)).join(" ")})`;
      row.append(dot, make("span", entity.name), make("span", entity.kind, "more"));
      row.onclick = () => this.onSelect(i);
      row.hidden = !entity.moves;
      this.rows.push(row);
      this.list.append(row);
    });
    const cameras = scene.text.entities.flatMap((entity) => (entity.cameras ?? []).map((name) => `${entity.name}.${name}`));
    const before = this.camera.value;
    this.camera.replaceChildren(new Option(cameras.length > 0 ? "choose a camera" : "nobody has a camera", ""),
      ...cameras.map((name) => new Option(name, name)));
    this.camera.value = cameras.includes(before) ? before : "";
    this.select(this.selected);
  }

  select(entity: number): void {
    this.selected = entity;
    this.rows.forEach((row, i) => row.classList.toggle("chosen", i === entity));
    this.details.replaceChildren();
    this.levels = this.contacts = undefined;
    const chosen = this.scene?.text.entities[entity];
    if (!chosen) {
      this.details.append(make("p", "Click or tap on a robot, the ball or a body to select it.", "hint"));
      return;
    }
    this.describe(chosen);
    if (this.state) this.update(this.state);
    this.details.scrollIntoView({ block: "nearest" });
  }

  update(state: State): void {
    this.state = state;
    state.entities.forEach((entity, i) => {
      const row = this.rows[i], known = this.scene?.text.entities[i];
      const more = row?.querySelector(".more");
      if (!more || !known) return;
      const text = !entity.present ? "not there" : entity.frozen ? "frozen" : entity.level || known.kind;
      if (more.textContent !== text) more.textContent = text;
    });
    const now = state.entities[this.selected];
    if (now && this.levels && document.activeElement !== this.levels) this.levels.value = now.level;
    if (now && this.contacts && document.activeElement !== this.contacts) this.contacts.value = now.contact;
  }

  setLines(lines: Line[]): void {
    this.events.replaceChildren();
    if (lines.length === 0) this.events.append(make("p", "Nothing has happened yet.", "hint"));
    for (const line of [...lines].reverse()) {
      const row = make("div", "", line.warning ? "line warning" : "line");
      row.append(make("time", `${line.time.toFixed(2)} s`), make("span", line.text));
      row.title = "Go to this time";
      row.onclick = () => this.source.seek(line.time);
      this.events.append(row);
    }
  }

  // Groups of drawings by name, to be switched.
  setGroups(names: string[], isShown: (name: string) => boolean): void {
    const now = names.join("\n");
    if (this.grouped === now) return;
    this.grouped = now;
    this.groups.replaceChildren();
    if (names.length > 0) this.groups.append(make("strong", "drawings"));
    for (const name of names) {
      const row = make("label", "", "row group");
      const box = make("input");
      box.type = "checkbox";
      box.checked = isShown(name);
      box.onchange = () => this.onGroup(name, box.checked);
      row.append(make("span", name), box);
      this.groups.append(row);
    }
  }

  values(time: number, values: Record<string, number | null>): void {
    for (const plot of this.plots) if (plot.path in values) plot.add(time, values[plot.path]!);
  }

  show_picture(picture: Picture): void {
    const { width, height, pixels } = picture;
    this.picture.width = width;
    this.picture.height = height;
    const image = new ImageData(width, height);
    for (let i = 0, k = 0; i < width * height; ++i, k += 3) {
      image.data.set([pixels[k]!, pixels[k + 1]!, pixels[k + 2]!, 255], 4 * i);
    }
    this.picture.getContext("2d")!.putImageData(image, 0, 0);
  }

  noteCamera(note: CameraNote): void {
    if (note.camera !== this.camera.value) return;
    this.cameraHint.classList.toggle("bad", note.trouble !== "");
    this.cameraHint.textContent = note.trouble || (note.own ? "As the robot gets it."
      : "Drawn for who looks, of this moment: without exposure time, rolling shutter and delay.");
  }

  // Pictures of another one come, or none.
  private look(): void {
    this.picture.getContext("2d")!.clearRect(0, 0, this.picture.width, this.picture.height);
    this.cameraHint.textContent = "";
    this.source.look(this.camera.value || null);
  }

  private open(tab: Tab): void {
    for (const [name, page] of this.pages) page.hidden = name !== tab;
    for (const button of get("tabs").children) button.setAttribute("aria-selected", String(button.textContent === tab));
    this.source.look(tab === "Camera" && this.camera.value ? this.camera.value : null);
    if (tab === "Plots") void this.offerNames();
  }

  private change(text: string): void {
    this.source.change(text).then(() => say(text), (error: unknown) => {
      say((error as Error).message, true);
      if (this.state) this.update(this.state);
    });
  }

  private choice(title: string, names: string[], key: string, entity: Entity): HTMLSelectElement {
    const row = make("label", "", "row live");
    const select = make("select");
    select.setAttribute("aria-label", title);
    select.append(...names.map((name) => new Option(name, name)));
    select.onchange = () => {
      this.change(`${entity.name}.${key} = ${select.value}`);
      select.blur();
    };
    row.append(make("span", title), select);
    this.details.append(row);
    return select;
  }

  private describe(entity: Entity): void {
    this.details.className = "details";
    this.details.append(make("strong", entity.name));
    if (!this.source.live) return;
    if (entity.kind === "robot") this.levels = this.choice("level", this.scene?.text.levels ?? [], "level", entity);
    if (entity.kind !== "field") this.contacts = this.choice("contact", this.scene?.text.contacts ?? [], "contact", entity);
    this.details.append(this.number("force [N]", this.force, (value) => (this.force = value)),
      this.number("for [s]", this.pushTime, (value) => (this.pushTime = value)), this.pad());
    this.details.append(make("p", "Arrows push as you look. Or switch on “push by dragging” at the left, and pull at a body.", "hint"));
    this.details.append(this.free());
  }

  private number(title: string, value: number, set: (value: number) => void): HTMLElement {
    const row = make("label", "", "row");
    const input = make("input");
    input.type = "number";
    input.step = "any";
    input.min = "0";
    input.value = String(value);
    input.oninput = () => {
      if (input.valueAsNumber > 0) set(input.valueAsNumber);
    };
    row.append(make("span", title), input);
    return row;
  }

  private pad(): HTMLElement {
    const row = make("div", "", "row");
    const pad = make("div", "", "pad");
    const places: [string, number, number][] = [["", 0, 0], ["up", 0, 1], ["", 0, 0], ["left", -1, 0], ["", 0, 0], ["right", 1, 0],
      ["", 0, 0], ["down", 0, -1]];
    for (const [icon, right, away] of places) {
      if (!icon) {
        pad.append(make("span"));
        continue;
      }
      const button = make("button");
      setIcon(button, icon);
      button.setAttribute("aria-label", `Push ${icon}`);
      button.onclick = () => this.onPush(right, away);
      pad.append(button);
    }
    row.append(make("span", "push"), pad);
    return row;
  }

  // Any change, as the scene's events have it.
  private free(): HTMLElement {
    const row = make("form", "", "row");
    const input = make("input");
    input.type = "text";
    input.placeholder = "blue1.command = [0.1, 0, 0.3]";
    input.setAttribute("aria-label", "Any change: PATH = VALUE");
    input.autocapitalize = "off";
    input.spellcheck = false;
    row.onsubmit = (event) => {
      event.preventDefault();
      if (input.value.trim()) this.change(input.value.trim());
    };
    row.append(make("span", "change"), input);
    return row;
  }

  private makePlots(): HTMLElement {
    const page = make("div");
    const row = make("form", "", "row");
    this.path.type = "text";
    this.path.placeholder = "blue1.imu.gyroscope.x";
    this.path.setAttribute("aria-label", "Number to plot");
    this.path.autocapitalize = "off";
    this.path.spellcheck = false;
    this.names.id = "all_names";
    this.path.setAttribute("list", this.names.id);
    this.path.oninput = () => void this.offerNames();
    const button = make("button", "Plot");
    row.onsubmit = (event) => {
      event.preventDefault();
      this.addPlot(this.path.value.trim());
    };
    row.append(this.path, button, this.names);
    this.plotList.className = "list";
    page.append(row, make("p", "Numbers of sensors and properties, as for --log.", "hint"), this.plotList);
    return page;
  }

  // Of the entity that is being typed, or else the selected one.
  private async offerNames(): Promise<void> {
    const typed = this.path.value.split(".")[0] ?? "";
    const entity = this.scene?.entity(typed) ?? this.scene?.text.entities[this.selected];
    if (!entity || entity.name === this.named) return;
    this.named = entity.name;
    try {
      const names = await this.source.namesOf(entity.name);
      this.names.replaceChildren(...names.map((name) => new Option(name)));
    } catch {
      this.named = "";
    }
  }

  private addPlot(path: string): void {
    if (!path || this.plots.some((plot) => plot.path === path)) return;
    const plot: Plot = new Plot(path, () => this.removePlot(plot));
    this.plots.push(plot);
    this.plotList.prepend(plot.element);
    this.source.watch(this.plots.map((one) => one.path)).then(() => (this.path.value = ""), (error: unknown) => {
      say((error as Error).message, true);
      this.removePlot(plot);
    });
  }

  private removePlot(plot: Plot): void {
    const index = this.plots.indexOf(plot);
    if (index < 0) return;
    this.plots.splice(index, 1);
    plot.element.remove();
    this.source.watch(this.plots.map((one) => one.path)).catch(() => undefined); // a lost connection says so itself
  }

  private makeCamera(): HTMLElement {
    const page = make("div");
    this.camera.setAttribute("aria-label", "Camera");
    this.camera.onchange = () => this.look();
    this.picture.id = "picture";
    page.append(this.camera, this.picture, this.cameraHint);
    return page;
  }
}
