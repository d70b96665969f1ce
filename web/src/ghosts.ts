// Where robots take themselves to be: what they look like, translucent, beside the truth.
import { Group, Matrix4, Mesh, MeshLambertMaterial, Object3D, Quaternion, Vector3 } from "three";

export type Belief = [number, number, number] | null; // [m, m, rad] x, y, heading of the base

const material = new MeshLambertMaterial({
  vertexColors: true, emissive: 0x3a6ea8, transparent: true, opacity: 0.4, depthWrite: false,
});
const upright = new Vector3(0, 0, 1);

interface Ghost {
  body: Object3D; // the truth
  twin: Object3D;
}

// A pose on the ground: no height, no tilt.
function standing(x: number, y: number, heading: number): Matrix4 {
  return new Matrix4().makeRotationFromQuaternion(new Quaternion().setFromAxisAngle(upright, heading)).setPosition(x, y, 0);
}

// The turn of the local x axis about the vertical.
function headingOf(base: Object3D): number {
  const ahead = new Vector3(1, 0, 0).applyQuaternion(base.quaternion);
  return Math.atan2(ahead.y, ahead.x);
}

export class Ghosts {
  readonly world = new Group(); // of the scene
  private shown = true;
  private beliefs: Belief[] = [];
  private readonly ghosts = new Map<number, { group: Group; bodies: Ghost[] }>(); // by entity

  get on(): boolean {
    return this.shown;
  }

  // There is somebody who has an opinion.
  get any(): boolean {
    return this.beliefs.some((belief) => belief !== null);
  }

  switch(on: boolean): void {
    this.shown = on;
  }

  // The bodies are others from now on.
  forget(): void {
    this.world.clear();
    this.ghosts.clear();
  }

  believe(beliefs: Belief[]): void {
    this.beliefs = beliefs;
  }

  // Puts ghosts beside the truth, limbs as they are; `bodies` tells those of an entity that is there, its base first.
  place(bodies: (entity: number) => Object3D[] | undefined): void {
    for (const [, { group }] of this.ghosts) group.visible = false;
    this.beliefs.forEach((belief, entity) => {
      const real = this.shown && belief ? bodies(entity) : undefined;
      const base = real?.[0];
      if (!belief || !real || !base) return;
      const { group, bodies: twins } = this.ghostOf(entity, real);
      const truth = standing(base.position.x, base.position.y, headingOf(base));
      group.matrix.copy(standing(...belief)).multiply(truth.invert());
      for (const { body, twin } of twins) {
        twin.position.copy(body.position);
        twin.quaternion.copy(body.quaternion);
      }
      group.visible = true;
    });
  }

  private ghostOf(entity: number, real: Object3D[]): { group: Group; bodies: Ghost[] } {
    const known = this.ghosts.get(entity);
    if (known) return known;
    const group = new Group();
    group.matrixAutoUpdate = false;
    const bodies = real.flatMap((body) => {
      if (!(body instanceof Mesh)) return [];
      const twin = new Mesh(body.geometry as Mesh["geometry"], material);
      group.add(twin);
      return [{ body, twin }];
    });
    const made = { group, bodies };
    this.ghosts.set(entity, made);
    this.world.add(group);
    return made;
  }
}
