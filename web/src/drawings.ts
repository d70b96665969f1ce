// What control software and other programs draw for who watches, as things in the scene.
import {
  BufferAttribute, BufferGeometry, Color, CylinderGeometry, DoubleSide, Group, Line, LineBasicMaterial, Material, Mesh,
  MeshBasicMaterial, Object3D, Quaternion, RingGeometry, SphereGeometry, Sprite, SRGBColorSpace, Vector3,
} from "three";
import { label } from "./label";
import type { Drawn, DrawnShape } from "./source";

const lifted = 0.006; // [m] above what is painted on the ground
const least = { line: 0.004, dot: 0.012, ring: 0.02, text: 0.08 }; // [m]

function places(shape: DrawnShape): Vector3[] {
  return shape.points.map((point) => new Vector3(point[0], point[1], point[2]));
}

function rod(a: Vector3, b: Vector3, width: number, material: Material): Mesh {
  const along = b.clone().sub(a), length = along.length();
  const mesh = new Mesh(new CylinderGeometry(width / 2, width / 2, length, 8), material);
  mesh.position.copy(a).addScaledVector(along, 0.5);
  mesh.quaternion.copy(new Quaternion().setFromUnitVectors(new Vector3(0, 1, 0), along.normalize()));
  return mesh;
}

function polygon(corners: Vector3[], triangles: number[][], material: Material): Mesh {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(new Float32Array(corners.flatMap((p) => p.toArray())), 3));
  geometry.setIndex(triangles.flat());
  return new Mesh(geometry, material);
}

function made(shape: DrawnShape): Object3D[] {
  const [red, green, blue] = shape.color;
  const color = new Color().setRGB(red ?? 1, green ?? 1, blue ?? 1, SRGBColorSpace);
  const looks = { color, transparent: shape.opacity < 1, opacity: shape.opacity };
  const material = new MeshBasicMaterial({ ...looks, side: DoubleSide, depthWrite: shape.opacity >= 1 });
  const points = places(shape), first = points[0];
  if (!first) return [];
  switch (shape.kind) {
    case "circle": {
      const half = Math.min(least.ring / 2, shape.size / 2);
      const ring = new Mesh(new RingGeometry(shape.size - half, shape.size + half, 64), material);
      ring.position.copy(first);
      return [ring];
    }
    case "line": {
      if (shape.size <= 0) return [new Line(new BufferGeometry().setFromPoints(points), new LineBasicMaterial(looks))];
      const width = Math.max(shape.size, least.line);
      return points.slice(1).flatMap((b, i) => (b.equals(points[i]!) ? [] : [rod(points[i]!, b, width, material)]));
    }
    case "dots":
    case "sphere": {
      const radius = shape.kind === "sphere" ? shape.size : Math.max(shape.size, least.dot) / 2;
      const geometry = new SphereGeometry(radius, 16, 12);
      return (shape.kind === "sphere" ? [first] : points).map((place) => {
        const ball = new Mesh(geometry, material);
        ball.position.copy(place);
        return ball;
      });
    }
    case "polygon": return [polygon(points, shape.triangles ?? [], material)];
    case "text": {
      if (shape.words === "") return [];
      const sprite = label(shape.words, `#${color.getHexString(SRGBColorSpace)}`, Math.max(shape.size, least.text));
      sprite.position.copy(first);
      return [sprite];
    }
  }
}

function dispose(object: Object3D): void {
  object.traverse((one) => {
    if (one instanceof Mesh || one instanceof Line) {
      (one.geometry as BufferGeometry).dispose();
      (one.material as Material).dispose();
    }
    if (one instanceof Sprite) {
      one.material.map?.dispose();
      one.material.dispose();
    }
  });
}

export class Drawings {
  readonly world = new Group(); // of the scene
  private drawn: Drawn[] = [];
  private readonly hidden = new Set<string>();
  private readonly ofRobots: { entity: number; group: Group }[] = [];

  // "blue1/ball": who draws, and the name of the group.
  get names(): string[] {
    return [...new Set(this.drawn.flatMap((one) => one.groups.map((group) => `${one.by}/${group.name}`)))];
  }

  isShown(name: string): boolean {
    return !this.hidden.has(name);
  }

  switchGroup(name: string, on: boolean): void {
    if (on) this.hidden.delete(name);
    else this.hidden.add(name);
    this.show(this.drawn);
  }

  show(drawn: Drawn[]): void {
    this.drawn = drawn;
    dispose(this.world);
    this.world.clear();
    this.ofRobots.length = 0;
    for (const one of drawn) {
      for (const group of one.groups) {
        if (!this.isShown(`${one.by}/${group.name}`)) continue;
        const things = new Group();
        things.position.z = lifted;
        const shapes = group.shapes.flatMap((shape) => made(shape));
        if (shapes.length > 0) things.add(...shapes);
        this.world.add(things);
        if (group.of_robot) this.ofRobots.push({ entity: one.entity, group: things });
      }
    }
  }

  // Moves what belongs to robots; `base` tells where one is.
  place(base: (entity: number) => Object3D | undefined): void {
    for (const { entity, group } of this.ofRobots) {
      const at = base(entity);
      group.visible = at !== undefined;
      if (!at) continue;
      group.position.copy(at.position);
      group.quaternion.copy(at.quaternion);
    }
  }
}
