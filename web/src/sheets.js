// Draws the three-dimensional views of a report: a measured sheet and its predicted one side by side,
// with one camera and one slider of frames (JSON: id -> data, see src/pliant/report/sheet_view.h).
import {
  ArrowHelper,
  BufferAttribute,
  BufferGeometry,
  Color,
  DirectionalLight,
  DoubleSide,
  Group,
  HemisphereLight,
  LineBasicMaterial,
  LineSegments,
  Mesh,
  MeshBasicMaterial,
  MeshLambertMaterial,
  OrthographicCamera,
  Scene,
  Vector3,
  WebGLRenderer,
} from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';

const FORCE_COLOUR = '#00538a';
const RESIDUAL_COLOUR = '#7a2c05';
/** The longest force as a part of the sheet's extent. */
const LONGEST_FORCE = 0.3;
/** Room around what is seen. */
const MARGIN = 1.08;

function bytesOf(text) {
  return Uint8Array.from(atob(text), (c) => c.charCodeAt(0)).buffer;
}

/** Positions of all frames from steps (m). */
function positionsOf(text, data) {
  const steps = new Uint16Array(bytesOf(text));
  return Float32Array.from(steps, (step, i) => data.low[i % 3] + data.step * step);
}

/** Base64 as arrays, and what follows from them for all frames. */
function decode(data) {
  const positions = {
    measured: positionsOf(data.measured, data),
    predicted: positionsOf(data.predicted, data),
  };
  let force = 0;
  for (const frame of data.frames) {
    for (const [, pull] of [...frame.measured, ...frame.predicted]) {
      force = Math.max(force, Math.hypot(...pull));
    }
  }
  const extent = 65535 * data.step;
  return {
    ...data,
    positions,
    extent,
    indices: new Uint32Array(bytesOf(data.triangles)),
    metresPerNewton: force > 0 ? (LONGEST_FORCE * extent) / force : 0,
  };
}

/** The colour of a residual between the two that it lies between. */
function colourScale(colours, largest) {
  const stops = colours.map((text) => new Color(text));
  return (residual, colour) => {
    const place = (Math.min(residual / (largest || 1), 1) * (stops.length - 1)) || 0;
    const below = Math.min(Math.floor(place), stops.length - 2);
    return colour.copy(stops[below]).lerp(stops[below + 1], place - below);
  };
}

/** One of the two sheets: its surface, the forces of its clips, the residuals of its nodes. */
class Sheet {
  constructor(view, side) {
    this.view = view;
    this.side = side;
    this.scene = new Scene();
    const { nodes, indices } = view.data;
    this.surface = new BufferGeometry();
    this.surface.setIndex(new BufferAttribute(indices, 1));
    this.surface.setAttribute('position', new BufferAttribute(new Float32Array(3 * nodes), 3));
    this.surface.setAttribute('color', new BufferAttribute(new Float32Array(3 * nodes), 3));
    const cloth = new MeshLambertMaterial({
      vertexColors: true,
      side: DoubleSide,
      polygonOffset: true,
      polygonOffsetFactor: 1,
    });
    const threads = new MeshBasicMaterial({
      color: '#27313c',
      wireframe: true,
      transparent: true,
      opacity: 0.14,
    });
    this.forces = new Group();
    this.residuals = new LineSegments(
      new BufferGeometry(),
      new LineBasicMaterial({ color: RESIDUAL_COLOUR }),
    );
    this.residuals.geometry.setAttribute(
      'position',
      new BufferAttribute(new Float32Array(6 * nodes), 3),
    );
    this.residuals.frustumCulled = false;
    const meshes = [new Mesh(this.surface, cloth), new Mesh(this.surface, threads)];
    for (const mesh of meshes) mesh.frustumCulled = false;
    this.scene.add(...meshes, this.forces, this.residuals, new HemisphereLight('#fff', '#b8c0c8', 2.2));
    const sun = new DirectionalLight('#fff', 1.2);
    sun.position.set(...view.data.from).addScaledVector(new Vector3(...view.data.up), 2);
    this.scene.add(sun);
  }

  show(index) {
    const { data, scale } = this.view;
    const { nodes, positions } = data;
    const frame = (side) => positions[side].subarray(3 * nodes * index, 3 * nodes * (index + 1));
    const own = frame(this.side);
    const measured = frame('measured');
    const predicted = frame('predicted');
    const at = this.surface.attributes.position;
    const colours = this.surface.attributes.color;
    const lines = this.residuals.geometry.attributes.position;
    const colour = new Color();
    at.array.set(own);
    for (let i = 0; i < nodes; i += 1) {
      const residual = [0, 1, 2].map((k) => predicted[3 * i + k] - measured[3 * i + k]);
      scale(1e3 * Math.hypot(...residual), colour).toArray(colours.array, 3 * i);
      residual.forEach((value, k) => {
        lines.array[6 * i + k] = own[3 * i + k];
        lines.array[6 * i + 3 + k] = own[3 * i + k] + data.magnification * value;
      });
    }
    for (const attribute of [at, colours, lines]) attribute.needsUpdate = true;
    this.surface.computeVertexNormals();
    this.showForces(data.frames[index][this.side]);
    this.residuals.visible = this.side === 'predicted' && this.view.magnified.checked;
  }

  showForces(clips) {
    const { extent, metresPerNewton } = this.view.data;
    for (const arrow of this.forces.children) arrow.dispose();
    this.forces.clear();
    for (const [place, pull] of clips) {
      const force = new Vector3(...pull);
      const length = metresPerNewton * force.length();
      if (length < 0.01 * extent) continue;
      const head = Math.min(0.06 * extent, length);
      this.forces.add(
        new ArrowHelper(force.normalize(), new Vector3(...place), length, FORCE_COLOUR, head, head / 2),
      );
    }
  }
}

function element(tag, properties, ...children) {
  const made = Object.assign(document.createElement(tag), properties);
  made.append(...children);
  return made;
}

/** A session: two sheets in one canvas, and what changes them. */
class View {
  /** One renderer draws all views: browsers allow a page few of them. */
  constructor(place, data, renderer) {
    this.place = place;
    this.renderer = renderer;
    this.data = decode(data);
    this.scale = colourScale(data.colours, data.largest_mm);
    this.canvas = element('canvas', {});
    this.makeControls();
    this.sheets = ['measured', 'predicted'].map((side) => new Sheet(this, side));
    this.aim();
    new ResizeObserver(() => this.resize()).observe(this.canvas);
    this.show();
    place.dataset.drawn = 'true';
  }

  makeControls() {
    const { data } = this;
    this.slider = element('input', {
      type: 'range',
      min: 0,
      max: data.frames.length - 1,
      value: data.first,
      ariaLabel: 'Frame',
    });
    this.text = element('span', { className: 'sheet-frame' });
    this.magnified = element('input', { type: 'checkbox' });
    this.slider.addEventListener('input', () => this.show());
    this.magnified.addEventListener('change', () => this.show());
    const bar = element('span', { className: 'sheet-bar' });
    bar.style.background = `linear-gradient(to right, ${data.colours.join(', ')})`;
    const largest = `${Number(data.largest_mm.toPrecision(2))} mm`;
    const label = element('label', {}, this.magnified, ` residuals, ${data.magnification} times`);
    this.place.append(
      element(
        'div',
        { className: 'sheet-scene' },
        this.canvas,
        element('span', { className: 'sheet-title' }, 'measured'),
        element('span', { className: 'sheet-title sheet-title-right' }, 'predicted'),
      ),
      element('div', { className: 'sheet-controls' }, this.slider, this.text),
      element(
        'div',
        { className: 'sheet-controls' },
        element('span', {}, 'position residual 0 '),
        bar,
        element('span', {}, largest),
        label,
      ),
    );
  }

  /** The camera looks at the middle of all frames and their forces, and sees all of them. */
  aim() {
    const { from, up, extent } = this.data;
    const towards = new Vector3(...from);
    const right = new Vector3(...up).cross(towards).normalize();
    const upwards = towards.clone().cross(right);
    const box = [right, upwards, towards].map((axis) => this.range(axis));
    const middle = new Vector3();
    [right, upwards, towards].forEach((axis, i) => {
      middle.addScaledVector(axis, (box[i].low + box[i].high) / 2);
    });
    this.room = { width: box[0].high - box[0].low, height: box[1].high - box[1].low };
    this.camera = new OrthographicCamera(-1, 1, 1, -1, 0, 10 * extent);
    this.camera.up.set(...up);
    this.camera.position.copy(middle).addScaledVector(towards, 5 * extent);
    this.controls = new OrbitControls(this.camera, this.canvas);
    this.controls.target.copy(middle);
    // The wheel and a finger that moves up or down scroll the page.
    this.controls.enableZoom = false;
    this.canvas.style.touchAction = 'pan-y';
    this.canvas.addEventListener('wheel', (event) => this.zoom(event), { passive: false });
    this.controls.update();
    this.controls.addEventListener('change', () => this.render());
  }

  /** How far nodes and forces reach along an axis. */
  range(axis) {
    const { frames, positions, metresPerNewton } = this.data;
    let low = Infinity;
    let high = -Infinity;
    const take = (x, y, z) => {
      const along = axis.x * x + axis.y * y + axis.z * z;
      low = Math.min(low, along);
      high = Math.max(high, along);
    };
    for (const all of Object.values(positions)) {
      for (let i = 0; i < all.length; i += 3) take(all[i], all[i + 1], all[i + 2]);
    }
    for (const frame of frames) {
      for (const [place, pull] of [...frame.measured, ...frame.predicted]) {
        take(...place.map((value, k) => value + metresPerNewton * pull[k]));
      }
    }
    return { low, high };
  }

  zoom(event) {
    if (!event.ctrlKey) return;
    event.preventDefault();
    this.camera.zoom *= event.deltaY < 0 ? 1.1 : 1 / 1.1;
    this.camera.updateProjectionMatrix();
    this.render();
  }

  resize() {
    const { clientWidth: width, clientHeight: height } = this.canvas;
    if (width === 0 || height === 0) return;
    this.canvas.width = width * window.devicePixelRatio;
    this.canvas.height = height * window.devicePixelRatio;
    const shape = width / 2 / height;
    const half = (MARGIN / 2) * Math.max(this.room.height, this.room.width / shape);
    Object.assign(this.camera, {
      left: -half * shape,
      right: half * shape,
      top: half,
      bottom: -half,
    });
    this.camera.updateProjectionMatrix();
    this.render();
  }

  show() {
    const index = Number(this.slider.value);
    const frame = this.data.frames[index];
    this.text.textContent = `frame ${frame.number + 1} of ${this.data.frame_count}: ${frame.text}`;
    for (const sheet of this.sheets) sheet.show(index);
    this.render();
  }

  render() {
    const { width, height } = this.canvas;
    if (width === 0 || height === 0) return;
    this.renderer.setSize(width, height, false);
    this.sheets.forEach((sheet, i) => {
      const box = [(i * width) / 2, 0, width / 2, height];
      this.renderer.setViewport(...box);
      this.renderer.setScissor(...box);
      this.renderer.render(sheet.scene, this.camera);
    });
    this.canvas.getContext('2d').drawImage(this.renderer.domElement, 0, 0);
  }
}

/** Throws where the browser has no WebGL. */
function makeRenderer() {
  const renderer = new WebGLRenderer({ antialias: true });
  renderer.setClearColor('#fff');
  renderer.setScissorTest(true);
  return renderer;
}

function drawViews() {
  let renderer;
  const views = JSON.parse(document.getElementById('sheet-views').textContent);
  for (const [id, data] of Object.entries(views)) {
    const place = document.getElementById(id);
    try {
      renderer ??= makeRenderer();
      new View(place, data, renderer);
    } catch (error) {
      // The picture stays.
      place.dataset.drawn = 'picture';
      console.warn(`${id}: ${error.message}`);
    }
  }
}

if (document.readyState === 'loading') {
  document.addEventListener('DOMContentLoaded', drawViews);
} else {
  drawViews();
}
