// The scene in three dimensions: bodies, field, names, contact forces; who is selected; where the eye is.
import {
  ArrowHelper, BoxGeometry, BufferAttribute, BufferGeometry, Color, ConeGeometry, CylinderGeometry, DirectionalLight, Group, type Material, Matrix4,
  Mesh, MeshBasicMaterial, Object3D, PCFSoftShadowMap, PerspectiveCamera, Plane, Quaternion, Raycaster, RingGeometry, Scene, SphereGeometry, Sprite, SRGBColorSpace, Vector2,
  Vector3, WebGLRenderer,
} from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import { Drawings } from "./drawings";
import { Ghosts, type Belief } from "./ghosts";
import { label } from "./label";
import { Look } from "./look";
import { arrange, type Named, type Rect } from "./names";
import type { Part, SceneDocument } from "./scene";
import type { Poses } from "./poses";
import type { Drawn } from "./source";

const meters_per_newton = 1 / 100;

function colorOf(numbers: number[]): Color {
  return new Color().setRGB(numbers[0] ?? 0.6, numbers[1] ?? 0.6, numbers[2] ?? 0.6, SRGBColorSpace);
}

function formOf(part: Part, scene: SceneDocument): BufferGeometry {
  const upright = new Matrix4().makeRotationX(Math.PI / 2); // three's cylinders stand along y
  switch (part.form) {
    case "sphere": return new SphereGeometry(1, 24, 16);
    case "half_sphere": return new SphereGeometry(1, 24, 8, 0, 2 * Math.PI, 0, Math.PI / 2).applyMatrix4(upright);
    case "tube": return new CylinderGeometry(1, 1, 2, 24, 1, true).applyMatrix4(upright);
    case "cylinder": return new CylinderGeometry(1, 1, 2, 28).applyMatrix4(upright);
    case "box": return new BoxGeometry(2, 2, 2);
    case "mesh": {
      const mesh = scene.meshes[part.mesh!]!;
      const geometry = new BufferGeometry();
      geometry.setAttribute("position", new BufferAttribute(mesh.corners.slice(), 3));
      geometry.setIndex(new BufferAttribute(mesh.triangles, 1));
      geometry.computeVertexNormals();
      return geometry;
    }
  }
}

// All parts of a body as one geometry, each corner with its color.
function merged(parts: Part[], scene: SceneDocument): BufferGeometry {
  const positions: number[] = [], normals: number[] = [], colors: number[] = [], indices: number[] = [];
  for (const part of parts) {
    const geometry = formOf(part, scene);
    const [x, y, z, qx, qy, qz, qw] = part.place;
    geometry.applyMatrix4(new Matrix4().compose(new Vector3(x, y, z), new Quaternion(qx, qy, qz, qw),
      new Vector3(...part.scale)));
    const first = positions.length / 3;
    const color = colorOf(part.color);
    const places = geometry.getAttribute("position"), directions = geometry.getAttribute("normal");
    for (let i = 0; i < places.count; ++i) {
      positions.push(places.getX(i), places.getY(i), places.getZ(i));
      normals.push(directions.getX(i), directions.getY(i), directions.getZ(i));
      colors.push(color.r, color.g, color.b, part.color[3] ?? 1);
    }
    for (const index of geometry.getIndex()!.array) indices.push(first + index);
    geometry.dispose();
  }
  const all = new BufferGeometry();
  all.setAttribute("position", new BufferAttribute(new Float32Array(positions), 3));
  all.setAttribute("normal", new BufferAttribute(new Float32Array(normals), 3));
  all.setAttribute("color", new BufferAttribute(new Float32Array(colors), 4));
  all.setIndex(indices);
  return all;
}

const arrowMaterial = new MeshBasicMaterial({ color: 0xff5a1f });
const shaft = new CylinderGeometry(0.007, 0.007, 0.75, 8).translate(0, 0.375, 0);
const tip = new ConeGeometry(0.02, 0.25, 12).translate(0, 0.875, 0);

// From the origin to (0, 1, 0).
function thickArrow(): Group {
  return new Group().add(new Mesh(shaft, arrowMaterial), new Mesh(tip, arrowMaterial));
}

interface Shown {
  entity: number; // index in the document
  group: Group;
  bodies: Object3D[]; // by body
  label: Sprite | undefined;
  top: number; // [m] height of the head
}

export class View {
  readonly camera = new PerspectiveCamera(42, 1, 0.02, 200);
  readonly controls: OrbitControls;
  onSelect: (entity: number) => void = () => undefined;
  onPush: (entity: number, body: number, force: Vector3) => void = () => undefined;
  pushMode = false;
  following = false;
  frames = 0; // drawn so far
  names: Rect[] = []; // [px] where names of robots are
  readonly drawings = new Drawings();
  readonly ghosts = new Ghosts();

  private readonly renderer: WebGLRenderer;
  private readonly stage = new Scene();
  private content = new Group();
  private readonly forces = new Group();
  private readonly ring: Mesh;
  private readonly arrow = new ArrowHelper(new Vector3(1, 0, 0), new Vector3(), 1, 0xff5a36, 0.12, 0.07);
  private shown: Shown[] = [];
  private document: SceneDocument | undefined;
  private selected = -1;
  private named = true;
  private dirty = true;
  private poses: Poses | undefined;
  private drag: { shown: Shown; body: number; start: Vector3; plane: Plane } | undefined;
  private pressed: { x: number; y: number } | undefined;
  private followed = new Vector3();
  private covered = { right: 0, bottom: 0 }; // [px] at the borders

  constructor(private readonly canvas: HTMLCanvasElement) {
    this.renderer = new WebGLRenderer({ canvas, antialias: true });
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio, 2));
    this.renderer.shadowMap.enabled = !window.matchMedia("(pointer: coarse)").matches; // phones do without
    this.renderer.shadowMap.type = PCFSoftShadowMap;
    this.stage.background = new Color(0xb2bcc6);
    this.stage.add(this.content, this.forces, this.arrow, this.drawings.world, this.ghosts.world);
    this.arrow.visible = false;
    this.ring = new Mesh(new RingGeometry(0.2, 0.24, 48),
      new MeshBasicMaterial({ color: 0xffe14d, transparent: true, opacity: 0.9, depthWrite: false }));
    this.ring.visible = false;
    this.stage.add(this.ring);
    this.camera.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.maxPolarAngle = 0.495 * Math.PI;
    this.controls.zoomToCursor = true;
    this.controls.minDistance = 0.2;
    this.controls.maxDistance = 60;
    this.controls.addEventListener("change", () => (this.dirty = true));
    new ResizeObserver(() => this.fit()).observe(canvas);
    canvas.addEventListener("pointerdown", (event) => this.press(event), { capture: true });
    canvas.addEventListener("pointermove", (event) => this.move(event), { capture: true });
    canvas.addEventListener("pointerup", (event) => this.lift(event), { capture: true });
    canvas.addEventListener("pointercancel", () => this.letGo(), { capture: true });
    this.fit();
    this.renderer.setAnimationLoop(() => this.draw());
  }

  // Replaces all that is shown; the eye stays where it is, but for the first time.
  show(scene: SceneDocument): void {
    const first = this.document === undefined;
    this.clear();
    this.document = scene;
    const look = new Look(scene);
    this.stage.background = look.background;
    this.addGround(scene, look);
    const byEntity = new Map<number, Part[]>();
    for (const part of scene.text.parts) {
      if (!byEntity.has(part.entity)) byEntity.set(part.entity, []);
      byEntity.get(part.entity)!.push(part);
    }
    const material = look.body(), ball = look.body({ panels: true });
    const clear = look.body({ transparent: true, depthWrite: false });
    const isClear = (part: Part) => part.color[3] !== undefined;
    scene.text.entities.forEach((entity, index) => {
      const group = new Group();
      const parts = byEntity.get(index) ?? [];
      const bodies = (entity.bodies ?? ["world"]).map((_, body) => {
        const own = parts.filter((part) => (part.body ?? 0) === body);
        const solid = own.filter((part) => !isClear(part));
        const object = solid.length > 0 ? new Mesh(merged(solid, scene), solid[0]!.panels ? ball : material) : new Object3D();
        object.castShadow = object.receiveShadow = true;
        for (const part of own.filter(isClear)) {
          const seen = new Mesh(merged([part], scene), clear);
          seen.userData = { entity: index, body };
          object.add(seen);
        }
        object.userData = { entity: index, body };
        group.add(object);
        return object;
      });
      this.content.add(group);
      if (!entity.moves) return;
      const color = `#${colorOf(entity.color).getHexString(SRGBColorSpace)}`;
      const name = entity.kind === "robot" ? label(entity.name, color) : undefined;
      if (name) {
        name.visible = this.named;
        this.content.add(name);
      }
      this.shown.push({ entity: index, group, bodies, label: name, top: 0 });
    });
    if (first) this.home();
    if (this.poses) this.place(this.poses);
    this.dirty = true;
  }

  place(poses: Poses): void {
    this.poses = poses;
    this.shown.forEach((shown, i) => {
      const pose = poses.entities[i];
      if (!pose) return;
      shown.group.visible = pose.present;
      let top = -Infinity;
      shown.bodies.forEach((body, k) => {
        const at = 7 * k, n = pose.bodies;
        body.position.set(n[at]!, n[at + 1]!, n[at + 2]!);
        body.quaternion.set(n[at + 3]!, n[at + 4]!, n[at + 5]!, n[at + 6]!);
        top = Math.max(top, n[at + 2]!);
      });
      shown.top = top;
      shown.label?.position.set(pose.bodies[0]!, pose.bodies[1]!, top + 0.08);
    });
    this.placeForces(poses);
    this.placeDrawings();
    this.placeGhosts();
    this.placeRing();
    if (this.following) this.follow();
    this.dirty = true;
  }

  showDrawings(drawn: Drawn[]): void {
    this.drawings.show(drawn);
    this.placeDrawings();
  }

  switchGroup(name: string, on: boolean): void {
    this.drawings.switchGroup(name, on);
    this.placeDrawings();
  }

  showBeliefs(beliefs: Belief[]): void {
    if (beliefs.length === 0 && !this.ghosts.any) return;
    this.ghosts.believe(beliefs);
    this.placeGhosts();
  }

  setGhosts(on: boolean): void {
    this.ghosts.switch(on);
    this.placeGhosts();
  }

  private placeGhosts(): void {
    this.ghosts.place((entity) => {
      const shown = this.shown.find((one) => one.entity === entity);
      return shown?.group.visible ? shown.bodies : undefined;
    });
    this.dirty = true;
  }

  private placeDrawings(): void {
    this.drawings.place((entity) => {
      const shown = this.shown.find((one) => one.entity === entity);
      return shown?.group.visible ? shown.bodies[0] : undefined;
    });
    this.dirty = true;
  }

  select(entity: number): void {
    this.selected = entity;
    this.placeRing();
    const target = this.basePlace(entity);
    if (target) this.followed.copy(target);
    this.dirty = true;
  }

  setNames(on: boolean): void {
    this.named = on;
    this.dirty = true;
  }

  setFollowing(on: boolean): void {
    this.following = on;
    const target = this.basePlace(this.selected);
    if (!on || !target) return;
    const shift = target.clone().sub(this.controls.target);
    this.controls.target.add(shift);
    this.camera.position.add(shift);
    const away = this.camera.position.clone().sub(target);
    if (away.length() > 3) this.camera.position.copy(target).add(away.setLength(2.2));
    this.followed.copy(target);
    this.controls.update();
    this.dirty = true;
  }

  // All of the field, from aside or from above, as large as it fits.
  home(above = false): void {
    const points = (this.document?.text.ground?.lines ?? []).flatMap((line) => line.points);
    const reach = (k: number, least: number) => points.reduce((most, point) => Math.max(most, Math.abs(point[k]!)), least) + 0.2;
    const [length, width] = [reach(0, 1.2), reach(1, 1)];
    const upright = this.camera.aspect < 1; // a phone that stands: seen from above the field stands, too
    const direction = new Vector3();
    if (above) direction.set(upright ? -0.001 : 0, upright ? 0 : -0.001, 1);
    else direction.set(0, -Math.cos(0.55), Math.sin(0.55));
    this.controls.target.set(0, 0, 0.1);
    const corners = [-1, 1].flatMap((x) => [-1, 1].map((y) => new Vector3(x * length, y * width, 0)));
    for (let distance = 1; distance < 60; distance *= 1.04) {
      this.camera.position.copy(this.controls.target).addScaledVector(direction.normalize(), distance);
      this.camera.lookAt(this.controls.target);
      this.camera.updateMatrixWorld();
      if (corners.every((corner) => this.isInside(corner))) break;
    }
    this.controls.update();
    this.dirty = true;
  }

  // Leaves pixels at the right and lower borders to something that lies over the view.
  setCovered(right: number, bottom: number): void {
    this.covered = { right, bottom };
    this.fit();
  }

  // Where `x` right and `y` away from the eye point in the plane.
  horizontal(x: number, y: number): Vector3 {
    const away = this.controls.target.clone().sub(this.camera.position).setZ(0).normalize();
    const right = new Vector3(away.y, -away.x, 0);
    return right.multiplyScalar(x).addScaledVector(away, y).normalize();
  }

  // Between the bars at top and bottom, and beside what covers the view.
  private isInside(point: Vector3): boolean {
    const { clientWidth: width, clientHeight: height } = this.canvas;
    const place = point.clone().project(this.camera);
    const x = (place.x + 1) / 2 * width, y = (1 - place.y) / 2 * height;
    return place.z < 1 && x > 8 && x < width - this.covered.right - 8 && y > 48 && y < height - Math.max(70, this.covered.bottom);
  }

  redraw(): void {
    this.dirty = true;
  }

  private clear(): void {
    this.content.traverse((object) => {
      if (object instanceof DirectionalLight) object.dispose();
      if (object instanceof Mesh) (object.geometry as BufferGeometry).dispose();
      if (object instanceof Sprite) object.material.map?.dispose();
    });
    this.ghosts.forget();
    this.stage.remove(this.content);
    this.content = new Group();
    this.stage.add(this.content);
    this.shown = [];
  }

  private addGround(scene: SceneDocument, look: Look): void {
    const ground = scene.text.ground;
    this.content.add(...look.ground(ground?.half_length, ground?.half_width), ...look.scenery());
    for (const line of ground?.lines ?? []) this.content.add(paint(line.points, line.width, look.paint(line.color)));
    const far = 1.15 * Math.max(ground?.half_length ?? 12, ground?.half_width ?? 12);
    this.content.add(...look.lights(far));
    look.sun.castShadow = true;
    look.sun.shadow.mapSize.set(2048, 2048);
    look.sun.shadow.bias = -0.0006;
    look.sun.shadow.normalBias = 0.01;
    look.sun.shadow.radius = 3;
    const box = look.sun.shadow.camera;
    [box.left, box.right, box.top, box.bottom, box.near, box.far] = [-far, far, far, -far, 0.1, 4 * far];
    box.updateProjectionMatrix();
  }

  private placeForces(poses: Poses): void {
    let used = 0;
    for (const contact of poses.contacts) {
      const force = new Vector3(...contact.force);
      const length = force.length() * meters_per_newton;
      if (!(length > 0.004)) continue;
      if (used === this.forces.children.length) this.forces.add(thickArrow());
      const arrow = this.forces.children[used++]!;
      arrow.visible = true;
      arrow.position.set(...contact.point);
      arrow.quaternion.setFromUnitVectors(new Vector3(0, 1, 0), force.normalize());
      arrow.scale.set(1, length, 1);
    }
    for (const arrow of this.forces.children.slice(used)) arrow.visible = false;
  }

  private basePlace(entity: number): Vector3 | undefined {
    const i = this.shown.findIndex((shown) => shown.entity === entity);
    const bodies = this.poses?.entities[i]?.bodies;
    return bodies ? new Vector3(bodies[0], bodies[1], bodies[2]) : undefined;
  }

  private placeRing(): void {
    const place = this.basePlace(this.selected);
    this.ring.visible = place !== undefined;
    if (place) this.ring.position.set(place.x, place.y, 0.006);
  }

  private follow(): void {
    const target = this.basePlace(this.selected);
    if (!target) return;
    const shift = target.clone().sub(this.followed);
    this.controls.target.add(shift);
    this.camera.position.add(shift);
    this.followed.copy(target);
    this.controls.update();
  }

  private fit(): void {
    const { clientWidth: width, clientHeight: height } = this.canvas;
    if (width === 0 || height === 0) return;
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.camera.setViewOffset(width, height, this.covered.right / 2, this.covered.bottom / 2, width, height);
    this.dirty = true;
  }

  private ray(event: PointerEvent): Raycaster {
    const box = this.canvas.getBoundingClientRect();
    const point = new Vector2(((event.clientX - box.left) / box.width) * 2 - 1, 1 - ((event.clientY - box.top) / box.height) * 2);
    const ray = new Raycaster();
    ray.setFromCamera(point, this.camera);
    return ray;
  }

  private hit(event: PointerEvent): { shown: Shown; body: number; point: Vector3 } | undefined {
    const objects = this.shown.filter((shown) => shown.group.visible).flatMap((shown) => shown.bodies);
    const found = this.ray(event).intersectObjects(objects, false)[0];
    if (!found) return undefined;
    const { entity, body } = found.object.userData as { entity: number; body: number };
    return { shown: this.shown.find((shown) => shown.entity === entity)!, body, point: found.point };
  }

  private press(event: PointerEvent): void {
    this.pressed = { x: event.clientX, y: event.clientY };
    if (!this.pushMode) return;
    const hit = this.hit(event);
    if (!hit) return;
    this.controls.enabled = false;
    this.canvas.setPointerCapture(event.pointerId);
    this.drag = { shown: hit.shown, body: hit.body, start: hit.point, plane: new Plane(new Vector3(0, 0, 1), -hit.point.z) };
    this.onSelect(hit.shown.entity);
  }

  private pull(event: PointerEvent): Vector3 | undefined {
    const end = this.drag && this.ray(event).ray.intersectPlane(this.drag.plane, new Vector3());
    return this.drag && end ? end.sub(this.drag.start) : undefined;
  }

  private move(event: PointerEvent): void {
    const pull = this.pull(event);
    if (!pull || !this.drag) return;
    const length = Math.min(pull.length(), 3);
    this.arrow.visible = length > 0.02;
    if (this.arrow.visible) {
      this.arrow.position.copy(this.drag.start);
      this.arrow.setDirection(pull.normalize());
      this.arrow.setLength(length, Math.min(0.12, 0.4 * length), 0.07);
    }
    this.dirty = true;
  }

  private lift(event: PointerEvent): void {
    const pull = this.pull(event);
    const drag = this.drag;
    this.letGo();
    if (drag) {
      if (pull && pull.length() > 0.02) this.onPush(drag.shown.entity, drag.body, pull);
      return;
    }
    const start = this.pressed;
    if (!start || Math.hypot(event.clientX - start.x, event.clientY - start.y) > 6) return;
    this.onSelect(this.hit(event)?.shown.entity ?? -1);
  }

  private letGo(): void {
    this.drag = undefined;
    this.arrow.visible = false;
    this.controls.enabled = true;
    this.dirty = true;
  }

  // Only if something has changed: a page that stands still costs nothing.
  private arrangeNames(): void {
    const all: Named[] = [];
    for (const { entity, group, label: name, top } of this.shown) {
      if (!name) continue;
      name.visible = false;
      const base = this.named && group.visible && this.poses ? this.basePlace(entity) : undefined;
      if (base) all.push({ label: name, base, top, first: entity === this.selected });
    }
    const { clientWidth: width, clientHeight: height } = this.canvas;
    this.camera.updateMatrixWorld();
    this.names = arrange(all, this.camera, width, height);
  }

  private draw(): void {
    this.controls.update();
    if (!this.dirty) return;
    this.dirty = false;
    ++this.frames;
    this.arrangeNames();
    this.renderer.render(this.stage, this.camera);
  }
}

// A painted line, as a strip on the ground.
function paint(points: number[][], width: number, material: Material): Mesh {
  const corners: number[] = [], indices: number[] = [];
  for (let i = 0; i + 1 < points.length; ++i) {
    const a = new Vector3(...(points[i] as [number, number, number]));
    const b = new Vector3(...(points[i + 1] as [number, number, number]));
    const along = b.clone().sub(a);
    if (along.length() === 0) continue;
    along.setLength(width / 2);
    const side = new Vector3(-along.y, along.x, 0);
    const first = corners.length / 3;
    for (const [end, sign] of [[a.sub(along), 1], [b.add(along), 1]] as const) {
      for (const turn of [sign, -sign]) corners.push(end.x + turn * side.x, end.y + turn * side.y, 0.003);
    }
    indices.push(first, first + 1, first + 2, first + 2, first + 1, first + 3);
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(new Float32Array(corners), 3));
  geometry.setIndex(indices);
  geometry.computeVertexNormals();
  const mesh = new Mesh(geometry, material);
  mesh.receiveShadow = true;
  return mesh;
}
