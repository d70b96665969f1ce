// Where the page gets what it shows, and whom it tells what to do: a running simulation (link.ts) or a recording in the page (player.ts).
import type { Poses } from "./poses";
import type { SceneDocument } from "./scene";

export interface EntityState {
  level: string;
  contact: string;
  controller: string;
  present: boolean;
  frozen: boolean;
}

export interface Game {
  state: string;
  half: number;
  remaining: number; // [s]
  teams: { name: string; score: number }[];
}

export interface State {
  time: number; // [s] simulated
  begin: number; // [s] from where on one can go back
  end: number; // [s] of the run
  paused: boolean;
  speed: number | null; // simulated seconds per second; null: as fast as possible
  factor: number; // the same, measured
  branch: number;
  diagnostic?: string; // since the last jump: what will not go on as it was there before
  entities: EntityState[]; // as those of the scene document
  beliefs?: ([number, number, number] | null)[]; // [m, m, rad] where robots take themselves to be
  game: Game | null;
}

export interface Line {
  time: number; // [s]
  text: string;
  warning: boolean;
}

export interface Picture {
  width: number;
  height: number;
  pixels: Uint8Array; // red, green, blue
}

// Of the camera that is looked through.
export interface CameraNote {
  camera: string;
  own: boolean; // it draws for itself; else it is drawn for who looks
  trouble: string; // why there is no picture; empty: all is well
}

export interface DrawnShape {
  kind: "circle" | "line" | "dots" | "sphere" | "polygon" | "text";
  points: number[][]; // [m]
  size: number; // [m] radius, width, height of letters; 0: as small as can be seen
  color: number[];
  opacity: number;
  words: string;
  triangles?: number[][]; // of a polygon: numbers of points
}

// Groups of one who draws for people.
export interface Drawn {
  entity: number; // of the scene document; -1: no robot in particular
  by: string;
  groups: { name: string; of_robot: boolean; shapes: DrawnShape[] }[];
}

export interface Listener {
  scene(scene: SceneDocument): void;
  poses(poses: Poses): void;
  state(state: State): void;
  lines(lines: Line[]): void;
  values(time: number, values: Record<string, number | null>): void;
  picture(picture: Picture): void;
  cameraNote(note: CameraNote): void;
  drawings(drawn: Drawn[]): void;
  connected(yes: boolean, why: string): void;
}

export interface Source {
  readonly live: boolean;
  play(): void;
  pause(): void;
  step(steps: number): void;
  setSpeed(speed: number | null): void;
  seek(time: number): void;
  reset(): void;
  setContacts(on: boolean): void;
  look(camera: string | null): void;
  // Resolve with what the simulation answers; reject with the line that says what is wrong.
  change(text: string): Promise<unknown>;
  watch(paths: string[]): Promise<unknown>;
  namesOf(entity: string): Promise<string[]>;
}
