// Light, materials and surroundings: the patterns, numbers and surfaces of the scene document, as in every other picture.
import {
  BufferAttribute, BufferGeometry, Color, DataTexture, DirectionalLight, DoubleSide, FrontSide, HemisphereLight,
  LinearFilter, LinearMipmapLinearFilter, type Material, Mesh, MeshPhongMaterial, Object3D, PlaneGeometry, RedFormat,
  RepeatWrapping, ShaderMaterial, SRGBColorSpace, type IUniform,
} from "three";
import type { LookText, SceneDocument, Surface } from "./scene";

const floorReach = 200; // [m]

function linear(numbers: number[]): Color {
  return new Color().setRGB(numbers[0]!, numbers[1]!, numbers[2]!);
}

function shown(numbers: number[]): Color {
  return new Color().setRGB(numbers[0]!, numbers[1]!, numbers[2]!, SRGBColorSpace);
}

function geometryOf(surface: Surface): BufferGeometry {
  const geometry = new BufferGeometry();
  const places: number[] = [], ats: number[] = [];
  for (let i = 0; i < surface.corners.length; i += 5) {
    places.push(...surface.corners.subarray(i, i + 3));
    ats.push(...surface.corners.subarray(i + 3, i + 5));
  }
  geometry.setAttribute("position", new BufferAttribute(new Float32Array(places), 3));
  geometry.setAttribute("at", new BufferAttribute(new Float32Array(ats), 2));
  geometry.setIndex(new BufferAttribute(surface.triangles, 1));
  return geometry;
}

const surfaceVertex = `
attribute vec2 at;
varying vec2 vAt;
void main() { vAt = at; gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0); }`;

const skyVertex = `
varying vec3 vWay;
void main() {
  vec4 far = inverse(projectionMatrix) * vec4(position.xy, 1.0, 1.0);
  vWay = mat3(inverse(viewMatrix)) * (far.xyz / far.w);
  gl_Position = vec4(position.xy, 1.0, 1.0);
}`;

export class Look {
  readonly background: Color;
  readonly sun = new DirectionalLight();
  private readonly text: LookText;
  private readonly uniforms: Record<string, IUniform> = {};

  constructor(private readonly scene: SceneDocument) {
    this.text = scene.text.look;
    this.background = shown(this.text.background);
    for (const [name, values] of Object.entries(this.text.numbers)) {
      this.uniforms[name] = { value: values.length === 1 ? values[0] : values };
    }
    const { side } = this.text.pile;
    const pile = new DataTexture(scene.pile, side, side, RedFormat);
    pile.wrapS = pile.wrapT = RepeatWrapping;
    pile.minFilter = LinearMipmapLinearFilter;
    pile.magFilter = LinearFilter;
    pile.generateMipmaps = true;
    pile.needsUpdate = true;
    this.uniforms.pile = { value: pile };
  }

  // Lamps; `far` [m]: how far the first one is away, whose shadows are drawn.
  lights(far: number): Object3D[] {
    const [first, ...others] = this.text.lamps;
    const place = (light: DirectionalLight, lamp: { toward: number[]; color: number[] }) => {
      light.color = linear(lamp.color);
      light.intensity = Math.PI; // of a white surface that is lit upright, light of the lamp comes back
      light.position.set(lamp.toward[0]!, lamp.toward[1]!, lamp.toward[2]!).setLength(1.5 * far);
      return light;
    };
    const sky = new HemisphereLight(linear(this.text.sky), linear(this.text.earth), Math.PI);
    sky.position.set(0, 0, 1);
    return [sky, place(this.sun, first!), this.sun.target, ...others.map((lamp) => place(new DirectionalLight(), lamp))];
  }

  // Bodies, each corner in its color.
  body(more: { transparent?: boolean; depthWrite?: boolean; panels?: boolean } = {}): Material {
    const { panels, ...rest } = more;
    const gloss = this.text.gloss / 4.25; // three's mirror of shininess 32 is so much brighter
    const material = new MeshPhongMaterial({ vertexColors: true, shininess: 32, specular: new Color(gloss, gloss, gloss), ...rest });
    return this.patterned(material, panels ? "diffuseColor.rgb = ball_look(diffuseColor.rgb, vOwn);" : "",
      "gl_FragColor.rgb *= pool_tone(vWorld.xy);");
  }

  // Field and floor, without lines.
  ground(halfLength: number | undefined, halfWidth: number | undefined): Mesh[] {
    const floor = new Mesh(new PlaneGeometry(2 * floorReach, 2 * floorReach),
      this.patterned(new MeshPhongMaterial({ color: shown(this.text.floor), specular: 0 }), "",
        "gl_FragColor.rgb = floor_look(gl_FragColor.rgb * pool_tone(vWorld.xy), vWorld.xy, fwidth(vWorld.xy), length(vViewPosition));"));
    floor.position.z = -0.012;
    if (halfLength === undefined || halfWidth === undefined) floor.position.z = 0;
    floor.receiveShadow = true;
    if (halfLength === undefined || halfWidth === undefined) return [floor];
    const lawn = new Mesh(new PlaneGeometry(2 * halfLength, 2 * halfWidth),
      this.patterned(new MeshPhongMaterial({ color: shown(this.text.grass), specular: 0 }), "",
        "gl_FragColor.rgb *= lawn_tone(vWorld.xy, fwidth(vWorld.xy)) * pool_tone(vWorld.xy);"));
    lawn.receiveShadow = true;
    return [floor, lawn];
  }

  paint(color: number[]): Material {
    const material = new MeshPhongMaterial({
      color: shown(color), specular: 0, side: DoubleSide, transparent: true, polygonOffset: true, polygonOffsetFactor: -1,
    });
    return this.patterned(material, "diffuseColor.a *= worn(1.0, vWorld.xy);", "gl_FragColor.rgb *= pool_tone(vWorld.xy);");
  }

  // Walls and ceiling or sky, and nets.
  scenery(): Mesh[] {
    const surface = (of: Surface, code: string, more: object = {}) => new Mesh(geometryOf(of), new ShaderMaterial({
      uniforms: { ...this.uniforms, net: { value: this.text.net } }, vertexShader: surfaceVertex, side: FrontSide,
      fragmentShader: `${this.text.patterns} uniform vec3 net; varying vec2 vAt; void main() { gl_FragColor = ${code}; }`, ...more,
    }));
    const nets = surface(this.scene.nets, "vec4(net, 0.85 * net_cover(vAt))",
      { transparent: true, depthWrite: false, side: DoubleSide });
    nets.renderOrder = 1;
    if (this.text.surroundings === "hall") {
      return [nets, surface(this.scene.walls, "vec4(wall_look(vAt, fwidth(vAt)), 1.0)"),
        surface(this.scene.ceiling, "vec4(ceiling_look(vAt, fwidth(vAt)), 1.0)")];
    }
    return this.text.surroundings === "outdoors" ? [nets, this.sky()] : [nets];
  }

  private sky(): Mesh {
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(new Float32Array([-1, -1, 0, 3, -1, 0, -1, 3, 0]), 3));
    const sky = new Mesh(geometry, new ShaderMaterial({
      uniforms: this.uniforms, vertexShader: skyVertex, depthTest: false, depthWrite: false, side: DoubleSide,
      fragmentShader: `${this.text.patterns} varying vec3 vWay; void main() { gl_FragColor = vec4(sky_look(vWay), 1.0); }`,
    }));
    sky.frustumCulled = false;
    sky.renderOrder = -1; // behind everything
    return sky;
  }

  // Adds code to a material: where the color of the surface is known, and where it is as it is shown.
  private patterned(material: Material, color: string, end: string): Material {
    material.onBeforeCompile = (shader) => {
      Object.assign(shader.uniforms, this.uniforms);
      const varying = "varying vec3 vOwn;\nvarying vec3 vWorld;\n";
      shader.vertexShader = varying + shader.vertexShader.replace("#include <begin_vertex>",
        "#include <begin_vertex>\nvOwn = position;\nvWorld = (modelMatrix * vec4(position, 1.0)).xyz;");
      shader.fragmentShader = varying + this.text.patterns + shader.fragmentShader
        .replace("#include <color_fragment>", `#include <color_fragment>\n${color}`)
        .replace("#include <colorspace_fragment>", `#include <colorspace_fragment>\n${end}`);
    };
    material.customProgramCacheKey = () => color + end;
    return material;
  }
}
