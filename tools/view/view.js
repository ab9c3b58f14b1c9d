// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The page of segment_shape --view: a shape to turn, its parts at each stage, pulled apart at will.
// What write_view.h puts into the page are elements with the ids `shape` (JSON) and `data-...` (base64).

import {PerspectiveCamera, Scene, Vector3, WebGLRenderer} from 'three';
import {OrbitControls} from 'three/addons/controls/OrbitControls.js';

import {makeDrawing} from './drawing.js';

const byId = (id) => document.getElementById(id);

function bytesOf(id) {
  const element = byId('data-' + id);
  if (!element) return null;
  const text = atob(element.textContent);
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
  element.remove(); // it was there twice
  return bytes.buffer;
}

const array = (Type, id) => {
  const buffer = bytesOf(id);
  return buffer && new Type(buffer);
};

function readShape() {
  const shape = JSON.parse(byId('shape').textContent);
  shape.positions = array(Float32Array, 'positions');
  shape.normals = array(Float32Array, 'normals');
  shape.triangles = array(Uint32Array, 'triangles');
  shape.elements = array(Uint32Array, 'elements'); // of each triangle; null: the triangles are they
  for (const stage of shape.stages) stage.labels = array(Int32Array, stage.name);
  return shape;
}

function countParts(stage) {
  stage.sizes = new Array(stage.colors.length).fill(0);
  for (const label of stage.labels) if (label >= 0) ++stage.sizes[label];
  stage.total = stage.sizes.reduce((sum, size) => sum + size, 0);
}

const percent = (stage, part) => ((100 * stage.sizes[part]) / stage.total).toFixed(1) + ' %';

// `stage.parts` has the further numbers, where there are any.
function describe(shape, stage, part) {
  const lines = [
    `${stage.singular} ${part}`,
    `${stage.sizes[part]} ${shape.kind === 'mesh' ? 'faces' : 'points'}, ${percent(stage, part)} of the shape`,
  ];
  const known = stage.parts && stage.parts[part];
  if (known) {
    lines.push(`convexity rank ${known.convexity_rank.toFixed(3)}`);
    if (known.diameter > 0) lines.push(`diameter ${known.diameter.toPrecision(3)}`);
    lines.push(`beside ${known.neighbors.join(', ') || 'none'}`);
  }
  return lines.join('\n');
}

class Page {
  constructor(shape) {
    this.shape = shape;
    this.renderer = new WebGLRenderer({antialias: true, preserveDrawingBuffer: true});
    this.renderer.setPixelRatio(window.devicePixelRatio);
    this.renderer.setClearColor(0xf4f5f7);
    document.body.prepend(this.renderer.domElement);
    this.drawing = makeDrawing(shape);
    this.scene = new Scene();
    this.scene.add(this.drawing.object);
    this.camera = new PerspectiveCamera(35, 1, 0.01, 100);
    this.controls = new OrbitControls(this.camera, this.renderer.domElement);
    this.part = -1;
    this.up = 2;
    this.reset();
  }

  draw() {
    if (this.isAsked) return;
    this.isAsked = true;
    requestAnimationFrame(() => {
      this.isAsked = false;
      this.renderer.render(this.scene, this.camera);
    });
  }

  resize() {
    this.renderer.setSize(window.innerWidth, window.innerHeight);
    this.camera.aspect = window.innerWidth / window.innerHeight;
    // The panel covers the left; the shape is drawn in the middle of what is left.
    const covered = window.innerWidth > 700 ? 250 : 0;
    this.camera.setViewOffset(window.innerWidth, window.innerHeight, -covered / 2, 0, window.innerWidth,
                              window.innerHeight);
    this.draw();
  }

  reset() {
    const at = this.up === 2 ? new Vector3(1.5, -2.2, 1.1) : new Vector3(1.5, 1.1, 2.2);
    this.camera.up.set(0, this.up === 1 ? 1 : 0, this.up === 2 ? 1 : 0);
    this.controls.dispose(); // its axis is read once
    this.controls = new OrbitControls(this.camera, this.renderer.domElement);
    this.controls.addEventListener('change', () => this.draw());
    this.controls.target.set(0, 0, 0);
    this.camera.position.copy(at);
    this.controls.update();
    this.draw();
  }

  setStage(name) {
    this.stage = this.shape.stages.find((stage) => stage.name === name) || this.stage;
    this.drawing.setStage(this.stage);
    for (const button of byId('stages').children)
      button.setAttribute('aria-pressed', String(button.dataset.stage === this.stage.name));
    this.listParts();
    this.setPart(-1);
  }

  setApart(value) {
    byId('apart').value = value;
    this.drawing.uniforms.apart.value = Number(byId('apart').value);
    this.draw();
  }

  setPart(part, isScrolled = false) {
    this.part = part;
    this.drawing.uniforms.chosen.value = part;
    for (const item of byId('parts').children) {
      const isOn = Number(item.dataset.part) === part;
      item.classList.toggle('on', isOn);
      if (isOn && isScrolled) item.scrollIntoView({block: 'nearest'});
    }
    this.draw();
  }

  listParts() {
    const order = this.stage.sizes.map((_, part) => part).filter((part) => this.stage.sizes[part] > 0);
    order.sort((a, b) => this.stage.sizes[b] - this.stage.sizes[a] || a - b);
    this.order = order;
    byId('parts').replaceChildren(...order.map((part) => {
      const item = document.createElement('li');
      item.dataset.part = part;
      item.title = describe(this.shape, this.stage, part);
      const color = document.createElement('span');
      color.style.background = this.stage.colors[part];
      const share = document.createElement('em');
      share.textContent = percent(this.stage, part);
      item.append(color, `${this.stage.singular} ${part}`, share);
      item.addEventListener('pointerenter', () => this.setPart(part));
      item.addEventListener('pointerleave', () => this.setPart(-1));
      return item;
    }));
  }

  hover(event) {
    if (event.buttons) return this.showTip(-1);
    const part = this.drawing.partAt(this.renderer, this.camera, event.clientX, event.clientY);
    if (part !== this.part) this.setPart(part, true);
    this.showTip(part, event.clientX, event.clientY);
  }

  showTip(part, x = 0, y = 0) {
    const tip = byId('tip');
    tip.style.display = part < 0 ? 'none' : 'block';
    if (part < 0) return;
    tip.textContent = describe(this.shape, this.stage, part);
    tip.style.left = Math.min(x + 14, window.innerWidth - tip.offsetWidth - 8) + 'px';
    tip.style.top = Math.min(y + 14, window.innerHeight - tip.offsetHeight - 8) + 'px';
  }

  key(event) {
    const stage = this.shape.stages[Number(event.key) - 1];
    if (stage) return this.setStage(stage.name);
    if (event.target === byId('apart')) return; // its arrows move the slider
    const step = {ArrowRight: 1, ArrowLeft: -1}[event.key];
    if (step) {
      const at = this.order.indexOf(this.part);
      const n = this.order.length;
      this.setPart(this.order[at < 0 ? (step > 0 ? 0 : n - 1) : (at + step + n) % n], true);
    }
    if (event.key === 'u' || event.key === 'U') this.up = 3 - this.up;
    if ('uUrR'.includes(event.key)) this.reset();
    if (event.key === 'r' || event.key === 'R') this.setApart(0);
  }

  // The part of an address after #, such as #stage=patches&apart=0.5&up=y, sets the page up.
  readAddress() {
    const wishes = new URLSearchParams(window.location.hash.slice(1));
    if (wishes.get('up') === 'y') {
      this.up = 1;
      this.reset();
    }
    this.setStage(wishes.get('stage') || this.shape.start);
    this.setApart(wishes.get('apart') || 0);
  }

  listen() {
    for (const stage of this.shape.stages) {
      const button = document.createElement('button');
      button.dataset.stage = stage.name;
      button.textContent = `${stage.sizes.filter((size) => size > 0).length} ${stage.name}`;
      button.addEventListener('click', () => this.setStage(stage.name));
      byId('stages').append(button);
    }
    byId('apart').addEventListener('input', (event) => this.setApart(event.target.value));
    const canvas = this.renderer.domElement;
    canvas.addEventListener('pointermove', (event) => this.hover(event));
    canvas.addEventListener('pointerleave', () => { this.showTip(-1); this.setPart(-1); });
    window.addEventListener('resize', () => this.resize());
    window.addEventListener('keydown', (event) => this.key(event));
    window.addEventListener('hashchange', () => this.readAddress());
  }
}

function start() {
  const shape = readShape();
  shape.stages.forEach(countParts);
  document.title = shape.name + ' in parts';
  byId('name').textContent = shape.name;
  const count = shape.kind === 'mesh' ? shape.number_of_faces + ' faces' : shape.number_of_points + ' points';
  byId('summary').textContent = `${count}, preset ${shape.preset}`;
  const page = new Page(shape);
  page.listen();
  page.resize();
  page.readAddress();
  document.body.dataset.ready = 'true';
}

try {
  start();
} catch (error) {
  byId('failure').textContent = 'The shape cannot be drawn: ' + error.message + '. The page needs WebGL 2.';
  byId('failure').style.display = 'grid';
  console.error(error);
}
