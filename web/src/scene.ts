// The scene document: what everything looks like and is called (docs/web.md).

export type Numbers = number[];

export interface Entity {
  name: string;
  kind: "robot" | "ball" | "body" | "field";
  team: string;
  color: Numbers;
  moves: boolean;
  bodies?: string[];
  cameras?: string[];
}

export interface Part {
  entity: number;
  body?: number; // of its entity; none: it stands in the world
  form: "sphere" | "half_sphere" | "tube" | "cylinder" | "box" | "mesh";
  mesh?: number;
  place: Numbers; // x y z, then x y z w of the rotation
  scale: Numbers;
  color: Numbers;
  panels?: boolean; // a ball
}

interface SurfaceText {
  at: number;
  corners: number;
  triangles: number;
}

export interface LookText {
  patterns: string; // functions in GLSL, and the uniforms that they need
  numbers: Record<string, Numbers>; // these
  surroundings: "nothing" | "hall" | "outdoors";
  lamps: { toward: Numbers; color: Numbers }[]; // the first one casts shadows
  sky: Numbers;
  earth: Numbers;
  gloss: number;
  background: Numbers;
  floor: Numbers;
  grass: Numbers;
  net: Numbers;
  walls: SurfaceText;
  ceiling: SurfaceText;
  nets: SurfaceText;
  pile: { at: number; side: number };
}

export interface SceneText {
  schema: string;
  name: string;
  entities: Entity[];
  parts: Part[];
  meshes: SurfaceText[];
  look: LookText;
  ground?: { half_length: number; half_width: number; lines?: { points: Numbers[]; width: number; color: Numbers }[] };
  levels?: string[];
  contacts?: string[];
  warnings: string[];
}

export interface Mesh {
  corners: Float32Array;
  triangles: Uint32Array;
}

export interface Surface {
  corners: Float32Array; // five numbers each: place, and where on the surface
  triangles: Uint32Array;
}

export class SceneDocument {
  readonly text: SceneText;
  readonly meshes: Mesh[];
  readonly walls: Surface;
  readonly ceiling: Surface;
  readonly nets: Surface;
  readonly pile: Uint8Array<ArrayBuffer>;
  readonly moving: number[]; // indices of the entities that messages of poses have, in their order

  constructor(bytes: Uint8Array) {
    const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
    const length = view.getUint32(0, true);
    this.text = JSON.parse(new TextDecoder().decode(bytes.subarray(4, 4 + length))) as SceneText;
    const data = bytes.slice(4 + length).buffer;
    this.meshes = this.text.meshes.map(({ at, corners, triangles }) => ({
      corners: new Float32Array(data, at, 3 * corners),
      triangles: new Uint32Array(data, at + 12 * corners, 3 * triangles),
    }));
    const surface = ({ at, corners, triangles }: SurfaceText) => ({
      corners: new Float32Array(data, at, 5 * corners),
      triangles: new Uint32Array(data, at + 20 * corners, 3 * triangles),
    });
    const { walls, ceiling, nets, pile } = this.text.look;
    [this.walls, this.ceiling, this.nets] = [surface(walls), surface(ceiling), surface(nets)];
    this.pile = new Uint8Array(data, pile.at, pile.side * pile.side);
    this.moving = this.text.entities.flatMap((entity, i) => (entity.moves ? [i] : []));
  }

  entity(name: string): Entity | undefined {
    return this.text.entities.find((entity) => entity.name === name);
  }
}
