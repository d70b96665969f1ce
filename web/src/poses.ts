// Messages of poses (docs/web.md): each one stands alone.

export interface EntityPose {
  present: boolean;
  frozen: boolean;
  bodies: Float64Array; // of each body: x y z in the world [m], then x y z w of its orientation
}

export interface Contact {
  point: [number, number, number]; // [m]
  force: [number, number, number]; // [N]
}

export interface Poses {
  time: number; // [s]
  jumps: number;
  entities: EntityPose[]; // as SceneDocument.moving
  contacts: Contact[];
}

const numbersOfBody = 7;

function readEntity(view: DataView, start: number): [EntityPose, number] {
  let at = start;
  const flags = view.getUint16(at, true);
  const count = view.getUint16(at + 2, true);
  const base = [view.getFloat32(at + 4, true), view.getFloat32(at + 8, true), view.getFloat32(at + 12, true)];
  const step = view.getFloat32(at + 16, true);
  at += 20;
  const bodies = new Float64Array(numbersOfBody * count);
  for (let i = 0; i < count; ++i, at += 2 * numbersOfBody) {
    const to = numbersOfBody * i;
    for (let k = 0; k < 3; ++k) bodies[to + k] = base[k]! + step * view.getInt16(at + 2 * k, true);
    let square = 0;
    for (let k = 3; k < numbersOfBody; ++k) {
      const number = view.getInt16(at + 2 * k, true);
      bodies[to + k] = number;
      square += number * number;
    }
    const scale = square > 0 ? 1 / Math.sqrt(square) : 0;
    for (let k = 3; k < numbersOfBody; ++k) bodies[to + k]! *= scale;
  }
  return [{ present: (flags & 1) !== 0, frozen: (flags & 2) !== 0, bodies }, at];
}

export function readPoses(bytes: ArrayBuffer, offset = 0): Poses {
  const view = new DataView(bytes, offset);
  const withContacts = (view.getUint8(1) & 1) !== 0;
  const count = view.getUint16(2, true);
  const poses: Poses = { time: view.getFloat64(8, true), jumps: view.getUint32(4, true), entities: [], contacts: [] };
  let at = 16;
  for (let i = 0; i < count; ++i) {
    const [entity, next] = readEntity(view, at);
    poses.entities.push(entity);
    at = next;
  }
  if (!withContacts) return poses;
  const contacts = view.getUint32(at, true);
  const number = (i: number) => view.getFloat32(at + 4 + 4 * i, true);
  for (let i = 0; i < 6 * contacts; i += 6) {
    poses.contacts.push({
      point: [number(i), number(i + 1), number(i + 2)],
      force: [number(i + 3), number(i + 4), number(i + 5)],
    });
  }
  return poses;
}

// Between two instants: `share` 0 is a, 1 is b.
export function blend(a: Poses, b: Poses, share: number): Poses {
  const entities = a.entities.map((from, i) => {
    const to = b.entities[i];
    if (!to?.present || !from.present || to.bodies.length !== from.bodies.length) return from;
    const bodies = new Float64Array(from.bodies.length);
    for (let k = 0; k < bodies.length; k += numbersOfBody) {
      let dot = 0;
      for (let j = 3; j < numbersOfBody; ++j) dot += from.bodies[k + j]! * to.bodies[k + j]!;
      const sign = dot < 0 ? -1 : 1;
      for (let j = 0; j < numbersOfBody; ++j) {
        const end = (j < 3 ? 1 : sign) * to.bodies[k + j]!;
        bodies[k + j] = (1 - share) * from.bodies[k + j]! + share * end;
      }
    }
    return { ...from, bodies };
  });
  return { ...a, time: (1 - share) * a.time + share * b.time, entities };
}
