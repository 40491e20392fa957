// SPDX-License-Identifier: GPL-3.0-or-later
// A 3D view: camera, light, and drawing only when something has changed.

import {
  AmbientLight, Box3, BufferAttribute, BufferGeometry, Color, ColorManagement, DirectionalLight, DoubleSide, Group,
  LinearSRGBColorSpace, Matrix4, Mesh, MeshBasicMaterial, MeshLambertMaterial, OrthographicCamera, Raycaster, Scene,
  Vector2, Vector3, WebGLRenderer,
} from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import { Axes } from "./axes.js";
import { element } from "./elements.js";

// Colours are those of the screen throughout.
ColorManagement.enabled = false;

export function hasWebGL() {
  try {
    return Boolean(document.createElement("canvas").getContext("webgl2"));
  } catch {
    return false;
  }
}

// Room for axis cross and scale bar, pixels: below the content, or on both sides of it.
const roomBelow = 96;
const roomBeside = 132;
const margin = 1.05; // of the stage over what it shows
const unitExtent = { low: new Vector2(-1, -1), high: new Vector2(1, 1) };

// Whether the browser draws by software, for which smooth lines take six times as long.
function isSoftware() {
  const context = document.createElement("canvas").getContext("webgl2");
  const names = context?.getExtension("WEBGL_debug_renderer_info");
  return /swiftshader|llvmpipe|software/i.test(names ? context.getParameter(names.UNMASKED_RENDERER_WEBGL) : "");
}

export class View3d {
  // description: the text alternative of the view. hasScale: whether lengths are mm, for a scale bar.
  constructor(description, { hasScale = false } = {}) {
    this.node = element("div", { class: "stage" });
    // The picture is kept for print.
    this.renderer = new WebGLRenderer({ antialias: !isSoftware(), preserveDrawingBuffer: true });
    this.renderer.outputColorSpace = LinearSRGBColorSpace;
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio, 2));
    const canvas = this.renderer.domElement;
    canvas.tabIndex = 0;
    canvas.setAttribute("role", "img");
    canvas.setAttribute("aria-label", description);
    this.axes = new Axes({ hasScale });
    this.printed = element("canvas", { class: "printed", "aria-hidden": "true" });
    this.node.append(canvas, this.printed, this.axes.node);
    this.scene = new Scene();
    this.content = new Group();
    this.scene.add(this.content, new AmbientLight(0xffffff, 1.6));
    this.camera = new OrthographicCamera(-1, 1, 1, -1, -1000, 1000);
    this.camera.up.set(0, 0, 1);
    const light = new DirectionalLight(0xffffff, 1.8);
    light.position.set(-0.4, 0.5, 1);
    this.camera.add(light);
    this.scene.add(this.camera);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.listenToKeyEvents(canvas);
    this.controls.addEventListener("change", () => this.draw());
    this.seen = unitExtent;
    this.frames = 0;
    this.isWanted = false;
    new ResizeObserver(() => this.resize()).observe(this.node);
    this.takeColours();
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => this.takeColours());
  }

  takeColours() {
    this.takeGround();
    this.draw();
  }

  takeGround() {
    const panel = getComputedStyle(document.documentElement).getPropertyValue("--panel").trim();
    this.scene.background = new Color(panel);
  }

  resize() {
    this.fitCamera();
    this.draw();
  }

  // Draws at once, with the size and colours of now.
  redraw() {
    this.takeGround();
    this.fitCamera();
    this.drawNow();
  }

  // Copies what is drawn to a picture for print: browsers may print a canvas of WebGL empty.
  keepPicture() {
    const { domElement: drawn } = this.renderer;
    Object.assign(this.printed, { width: drawn.width, height: drawn.height });
    this.printed.getContext("2d").drawImage(drawn, 0, 0);
  }

  fitCamera() {
    const { clientWidth: width, clientHeight: height } = this.node;
    if (width === 0 || height === 0) return;
    this.renderer.setSize(width, height, false);
    const { low, high } = this.seen;
    const [wide, tall] = [margin * (high.x - low.x), margin * (high.y - low.y)];
    const scaleFor = (pixelsWide, pixelsHigh) => Math.max(wide / pixelsWide, tall / pixelsHigh, 1e-12);
    const besides = scaleFor(Math.max(width - 2 * roomBeside, 1), height);
    const above = scaleFor(width, Math.max(height - roomBelow, 1));
    const perPixel = Math.min(besides, above); // mm
    const [x, y] = [(low.x + high.x) / 2, (low.y + high.y) / 2 - (above < besides ? (perPixel * roomBelow) / 2 : 0)];
    Object.assign(this.camera, {
      left: x - (perPixel * width) / 2, right: x + (perPixel * width) / 2,
      top: y + (perPixel * height) / 2, bottom: y - (perPixel * height) / 2,
    });
    this.camera.updateProjectionMatrix();
  }

  // Looks at the whole content from above the front. others: further points that are to be seen.
  fit(others = []) {
    const box = new Box3().setFromObject(this.content);
    for (const point of others) box.expandByPoint(point);
    if (box.isEmpty()) box.set(new Vector3(-1, -1, -1), new Vector3(1, 1, 1));
    const centre = box.getCenter(new Vector3());
    const radius = Math.max(box.getSize(new Vector3()).length() / 2, 1e-9);
    this.camera.near = -20 * radius;
    this.camera.far = 20 * radius;
    this.camera.zoom = 1;
    this.controls.target.copy(centre);
    this.camera.position.copy(centre).add(new Vector3(-0.55, -1, 0.8).normalize().multiplyScalar(3 * radius));
    this.controls.update();
    this.camera.updateMatrixWorld();
    this.seen = this.extentSeen(others);
    this.resize();
  }

  // The extent of the content and of other points as the camera sees them.
  extentSeen(others) {
    const [low, high] = [new Vector2(Infinity, Infinity), new Vector2(-Infinity, -Infinity)];
    const at = new Vector3();
    const add = (point, matrix) => {
      at.copy(point).applyMatrix4(matrix);
      low.min(at);
      high.max(at);
    };
    const toCamera = this.camera.matrixWorldInverse;
    for (const point of others) add(point, toCamera);
    this.content.updateMatrixWorld(true);
    const [point, matrix] = [new Vector3(), new Matrix4()];
    this.content.traverse((object) => {
      const points = object.geometry?.getAttribute("position");
      matrix.multiplyMatrices(toCamera, object.matrixWorld);
      for (let k = 0; k < (points?.count ?? 0); ++k) add(point.fromBufferAttribute(points, k), matrix);
    });
    return low.x <= high.x ? { low, high } : unitExtent;
  }

  draw() {
    if (this.isWanted) return;
    this.isWanted = true;
    requestAnimationFrame(() => {
      this.isWanted = false;
      this.drawNow();
    });
  }

  drawNow() {
    const { clientWidth: width, clientHeight: height } = this.node;
    if (width === 0) return;
    this.renderer.render(this.scene, this.camera);
    this.axes.draw(this.camera, width, height);
    ++this.frames;
  }

  // The first triangle of `object` at a place of the canvas, given by an event; or null.
  triangleAt(event, object) {
    const { left, top, width, height } = this.renderer.domElement.getBoundingClientRect();
    const ray = new Raycaster();
    ray.setFromCamera(
      new Vector2(((event.clientX - left) / width) * 2 - 1, 1 - ((event.clientY - top) / height) * 2), this.camera);
    const [hit] = ray.intersectObject(object);
    return hit ? hit.faceIndex : null;
  }

  // Calls `then` for a click that turns nothing.
  onClick(then) {
    const canvas = this.renderer.domElement;
    let from = null;
    canvas.addEventListener("pointerdown", (event) => (from = [event.clientX, event.clientY]));
    canvas.addEventListener("pointerup", (event) => {
      if (from && Math.hypot(event.clientX - from[0], event.clientY - from[1]) < 4) then(event);
      from = null;
    });
  }
}

// A mesh with flat facets. colours: three numbers for each triangle, or none. isLit: whether a triangle is shaded.
export function facetMesh({ points, triangles }, colour, colours = null, isLit = null) {
  const corners = new Float32Array(3 * triangles.length);
  triangles.forEach((corner, k) => corners.set(points.subarray(3 * corner, 3 * corner + 3), 3 * k));
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(corners, 3));
  geometry.computeVertexNormals();
  if (colours) geometry.setAttribute("color", new BufferAttribute(new Float32Array(corners.length), 3));
  // Drawn a little behind: the mesh is reduced, and points and lines on the part must not sink into it.
  const look = {
    side: DoubleSide, vertexColors: Boolean(colours), color: colours ? 0xffffff : colour,
    polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 512,
  };
  const materials = [new MeshLambertMaterial(look), new MeshBasicMaterial(look)];
  const count = triangles.length / 3;
  if (isLit)
    for (let first = 0, next = 0; first < count; first = next) {
      while (next < count && isLit(next) === isLit(first)) ++next;
      geometry.addGroup(3 * first, 3 * (next - first), isLit(first) ? 0 : 1);
    }
  const mesh = new Mesh(geometry, isLit ? materials : materials[0]);
  if (colours) colourFacets(mesh, colours);
  return mesh;
}

export function colourFacets(mesh, colours) {
  const attribute = mesh.geometry.getAttribute("color");
  for (let k = 0; k < attribute.count; ++k) attribute.setXYZ(k, ...colours(Math.floor(k / 3)));
  attribute.needsUpdate = true;
}
