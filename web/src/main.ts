// The page: puts view, panel and controls together, and both to a running simulation or to the recording in the page.
import { get, say, setIcon, toggle } from "./elements";
import { Link } from "./link";
import { Panel } from "./panel";
import { Player } from "./player";
import type { SceneDocument } from "./scene";
import type { Game, Listener, Source, State } from "./source";
import { View } from "./view";

const speeds = [0.05, 0.1, 0.2, 0.3, 0.5, 0.7, 1, 1.5, 2, 3, 5, 10, null];

let scene: SceneDocument | undefined;
let state: State | undefined;
let selected = -1;
let seeking = false; // the time line is held
const view = new View(get<HTMLCanvasElement>("view"));
const time = get<HTMLInputElement>("time"), speed = get<HTMLInputElement>("speed");

const listener: Listener = {
  scene(next) {
    scene = next;
    document.title = `${next.text.name} - MuRoSimF`;
    get("name").textContent = next.text.name;
    view.show(next);
    panel.show(next);
    document.body.dataset["ready"] = "scene";
    for (const warning of next.text.warnings) say(warning, true);
  },
  poses(poses) {
    view.place(poses);
    document.body.dataset["ready"] = "poses";
    if (!seeking) showTime(poses.time);
  },
  state(next) {
    if (next.diagnostic && !state?.diagnostic) say(next.diagnostic, true);
    state = next;
    showState(next);
    panel.update(next);
    view.showBeliefs(next.beliefs ?? []);
    get("ghosts").hidden = !view.ghosts.any;
  },
  lines: (lines) => panel.setLines(lines),
  values: (at, values) => panel.values(at, values),
  picture: (picture) => panel.show_picture(picture),
  cameraNote: (note) => panel.noteCamera(note),
  drawings(drawn) {
    view.showDrawings(drawn);
    panel.setGroups(view.drawings.names, (name) => view.drawings.isShown(name));
  },
  connected(yes, why) {
    get("state").classList.toggle("bad", !yes);
    if (!yes) get("state").textContent = why || "not connected; trying again";
    else if (why) say(why, true);
  },
};

const recording = document.getElementById("recording");
document.body.classList.toggle("replay", recording !== null);
const source: Source = recording ? new Player(listener, recording.textContent ?? "") : new Link(listener);
const panel = new Panel(source);

function showTime(now: number): void {
  const end = Math.max(state?.end ?? 0, now);
  time.min = String(state?.begin ?? 0);
  time.max = String(end);
  time.value = String(now);
  get("clock").textContent = `${now.toFixed(2)} / ${end.toFixed(0)} s`;
}

function gameText(game: Game): string {
  const left = Math.max(0, Math.round(game.remaining));
  return `${game.state}, half ${game.half}, ${Math.floor(left / 60)}:${String(left % 60).padStart(2, "0")}`;
}

function showScore(game: Game | null): void {
  const box = get("score");
  box.hidden = game === null;
  if (!game || !scene) return;
  const parts = game.teams.map((team) => `${team.name} ${team.score}`);
  box.textContent = `${parts.join(" : ")}  (${gameText(game)})`;
}

function showState(now: State): void {
  setIcon(get("play"), now.paused ? "play" : "pause");
  get("play").setAttribute("aria-label", now.paused ? "Run" : "Pause");
  if (now.paused && !seeking) showTime(now.time);
  const atEnd = now.paused && now.time >= now.end - 1e-9;
  const branch = now.branch > 0 ? `, branch ${now.branch}` : "";
  get("state").textContent = (atEnd ? "at the end" : now.paused ? "paused" : `${now.factor.toFixed(2)} x real time`) + branch;
  const index = speeds.findIndex((one) => one === now.speed);
  if (document.activeElement !== speed && index >= 0) speed.value = String(index);
  get("speed_text").textContent = now.speed === null ? "max" : `${now.speed} x`;
  showScore(now.game);
}

function select(entity: number): void {
  selected = entity;
  view.select(entity);
  panel.select(entity);
}

function push(body: number, entity: number, force: { x: number; y: number }): void {
  const chosen = scene?.text.entities[entity];
  if (!chosen) {
    say("select somebody first");
    return;
  }
  const object = chosen.bodies?.[body] ?? "";
  const round = (value: number) => value.toFixed(2);
  const text = `${chosen.name}.${object}.push = [${round(force.x)}, ${round(force.y)}, 0, ${panel.pushTime}]`;
  source.change(text).then(() => say(text), (error: unknown) => say((error as Error).message, true));
}

// The bulkiest part: pushes act there.
function trunkOf(entity: number): number {
  const bodies = scene?.text.entities[entity]?.bodies ?? [];
  const found = bodies.findIndex((name) => /trunk|torso|chest|body/i.test(name));
  return Math.max(0, found);
}

view.onSelect = (entity) => select(entity);
view.onPush = (entity, body, pull) => {
  const strength = panel.force * pull.length();
  push(body, entity, pull.clone().setLength(strength));
};
panel.onSelect = (entity) => select(entity);
panel.onGroup = (name, on) => view.switchGroup(name, on);
panel.onPush = (right, away) => push(trunkOf(selected), selected, view.horizontal(right, away).multiplyScalar(panel.force));

function showPanel(on: boolean): void {
  get("panel").hidden = !on;
  document.body.classList.toggle("panel", on);
  toggle(get("toggle_panel"), on);
  const box = get("panel").getBoundingClientRect();
  if (!on) view.setCovered(0, 0);
  else if (window.matchMedia("(min-width: 641px)").matches) view.setCovered(window.innerWidth - box.left, 0);
  else view.setCovered(0, window.innerHeight - box.top);
}

const actions: Record<string, () => void> = {
  play: () => (state?.paused ? source.play() : source.pause()),
  step: () => source.step(1),
  reset: () => source.reset(),
  toggle_panel: () => showPanel(get("panel").hidden),
  follow() {
    if (selected < 0 && !view.following) {
      say("select somebody to follow");
      return;
    }
    view.setFollowing(!view.following);
    toggle(get("follow"), view.following);
  },
  above() {
    const on = get("above").getAttribute("aria-pressed") !== "true";
    view.home(on);
    toggle(get("above"), on);
  },
  names() {
    const on = get("names").getAttribute("aria-pressed") !== "true";
    view.setNames(on);
    toggle(get("names"), on);
  },
  ghosts() {
    view.setGhosts(!view.ghosts.on);
    toggle(get("ghosts"), view.ghosts.on);
  },
  contacts() {
    const on = get("contacts").getAttribute("aria-pressed") !== "true";
    source.setContacts(on);
    toggle(get("contacts"), on);
  },
  push_mode() {
    view.pushMode = !view.pushMode;
    toggle(get("push_mode"), view.pushMode);
    if (view.pushMode) say("pull at a body; the longer, the stronger");
  },
};
for (const [id, action] of Object.entries(actions)) get(id).onclick = action;
for (const id of ["contacts", "push_mode"]) get(id).classList.add("live");

const icons = { toggle_panel: "panel", follow: "follow", above: "above", names: "names", contacts: "contacts", ghosts: "ghost", push_mode: "push",
  reset: "reset", play: "play", step: "step" };
for (const [id, icon] of Object.entries(icons)) setIcon(get(id), icon);
toggle(get("names"), true);
toggle(get("ghosts"), true);

const keys: Record<string, string> = { " ": "play", ArrowRight: "step", Backspace: "reset", p: "toggle_panel", f: "follow", a: "above",
  n: "names", c: "contacts", g: "ghosts", x: "push_mode" };
window.addEventListener("keydown", (event) => {
  const target = event.target as HTMLElement;
  if (target.closest("input, select, textarea") || event.ctrlKey || event.metaKey || event.altKey) return;
  const action = actions[keys[event.key] ?? ""];
  const robots = (scene?.text.entities ?? []).flatMap((entity, i) => (entity.kind === "robot" ? [i] : []));
  if (action) action();
  else if (/^[1-9]$/.test(event.key)) select(robots[Number(event.key) - 1] ?? -1);
  else if (event.key === "Escape") select(-1);
  else return;
  event.preventDefault();
});

time.oninput = () => {
  seeking = true;
  get("clock").textContent = `${Number(time.value).toFixed(2)} / ${Number(time.max).toFixed(0)} s`;
  if (!source.live) source.seek(Number(time.value));
};
time.onchange = () => {
  seeking = false;
  source.seek(Number(time.value));
  time.blur();
};
speed.oninput = () => source.setSpeed(speeds[Number(speed.value)] ?? null);
speed.onchange = () => speed.blur();
if (window.matchMedia("(min-width: 900px)").matches) showPanel(true);

// For tests and for who embeds the page.
Object.assign(window, { murosimf: { view, state: () => state, scene: () => scene, select } });
