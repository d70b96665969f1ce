// Names of robots on the screen: above their heads, no larger than it takes, and neither over each other nor over robots.
import { Vector3, type PerspectiveCamera, type Sprite } from "three";

export interface Named {
  label: Sprite;
  base: Vector3; // [m] world
  top: number; // [m] height of the head
  first: boolean; // the selected one keeps its name whatever is behind
}

// Pixels from the upper left corner.
export interface Rect {
  left: number;
  right: number;
  top: number;
  bottom: number;
}

interface Placed {
  named: Named;
  depth: number; // [m] from the eye
  name: Rect;
  robot: Rect;
}

const [smallest, largest] = [9, 16]; // [px] height of a name
const share = 0.3; // of a robot's height on the screen
const half = 0.13; // [m] of a robot's width

export function overlap(a: Rect, b: Rect): number {
  const x = Math.min(a.right, b.right) - Math.max(a.left, b.left), y = Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top);
  return x > 0 && y > 0 ? x * y : 0;
}

function area(rect: Rect): number {
  return (rect.right - rect.left) * (rect.bottom - rect.top);
}

function placed(named: Named, camera: PerspectiveCamera, width: number, height: number): Placed {
  const depth = -named.base.clone().applyMatrix4(camera.matrixWorldInverse).z;
  const perMeter = (camera.projectionMatrix.elements[5]! * height) / 2 / Math.max(depth, 1e-3);
  const onScreen = (z: number) => {
    const place = new Vector3(named.base.x, named.base.y, z).project(camera);
    return { x: ((place.x + 1) / 2) * width, y: ((1 - place.y) / 2) * height };
  };
  const foot = onScreen(0), head = onScreen(named.top);
  const robot = {
    left: foot.x - half * perMeter, right: foot.x + half * perMeter,
    top: Math.min(head.y, foot.y - 2 * half * perMeter), bottom: foot.y,
  };
  const tall = Math.min(largest, Math.max(smallest, share * (robot.bottom - robot.top)));
  const wide = (tall * named.label.scale.x) / named.label.scale.y;
  named.label.scale.set((2 * wide) / (camera.projectionMatrix.elements[5]! * height),
    (2 * tall) / (camera.projectionMatrix.elements[5]! * height), 1);
  const above = onScreen(named.label.position.z); // the sprite's lower border is a quarter of its height above that
  return {
    named, depth, robot,
    name: { left: above.x - wide / 2, right: above.x + wide / 2, top: above.y - 1.25 * tall, bottom: above.y - 0.25 * tall },
  };
}

// Sizes the names, and shows those that hide nothing; the nearest ones first. Returns where the shown ones are.
export function arrange(all: Named[], camera: PerspectiveCamera, width: number, height: number): Rect[] {
  const robots = all.map((named) => placed(named, camera, width, height));
  robots.sort((a, b) => Number(b.named.first) - Number(a.named.first) || a.depth - b.depth);
  const shown: Rect[] = [];
  for (const one of robots) {
    const hides = shown.some((other) => overlap(one.name, other) > 0) ||
      robots.some((other) => other !== one && overlap(one.name, other.robot) > 0.2 * area(other.robot));
    one.named.label.visible = one.depth > 0 && (one.named.first || !hides);
    if (one.named.label.visible) shown.push(one.name);
  }
  return shown;
}
