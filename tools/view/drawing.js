// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// What is drawn: the triangles or points of a shape, each moved away with its part.

import {
  BufferAttribute, BufferGeometry, Color, DoubleSide, Mesh, NoBlending, Points, Scene, ShaderMaterial,
  WebGLRenderTarget,
} from 'three';

const vertexShader = `
  attribute vec3 away;
  attribute vec3 tint;
  attribute float part;
  uniform float apart;
  uniform float pixels;
  uniform float spacing;
  varying vec3 vTint;
  varying vec3 vNormal;
  varying float vPart;
  void main() {
    vTint = tint;
    vPart = part;
    vNormal = normalMatrix * normal;
    vec4 at = modelViewMatrix * vec4(position + apart * away, 1.);
    gl_Position = projectionMatrix * at;
    gl_PointSize = clamp(spacing * pixels / -at.z, 2., 24.);
  }`;

// A lamp at the eye and one from above, on both sides of the surface: normals need not point out.
const fragmentShader = `
  uniform float chosen;
  uniform bool isLit;
  uniform bool isRound;
  varying vec3 vTint;
  varying vec3 vNormal;
  varying float vPart;
  void main() {
    if (isRound && length(gl_PointCoord - .5) > .5) discard;
    float light = 1.;
    if (isLit) {
      vec3 n = normalize(vNormal);
      if (n.z < 0.) n = -n;
      light = .42 + .42 * n.z + .24 * max(0., dot(n, normalize(vec3(-.4, .8, .4))));
    }
    vec3 color = vTint * min(light, 1.08);
    if (chosen >= 0.) color = abs(vPart - chosen) < .5 ? mix(color, vec3(1.), .18) : mix(color, vec3(.9), .62);
    gl_FragColor = vec4(color, 1.);
  }`;

// The number of the part, from 1, as a color: to find out what is under the pointer.
const partShader = `
  uniform bool isRound;
  varying float vPart;
  void main() {
    if (isRound && length(gl_PointCoord - .5) > .5) discard;
    float n = floor(vPart + 1.5);
    gl_FragColor = vec4(mod(n, 256.), mod(floor(n / 256.), 256.), floor(n / 65536.), 255.) / 255.;
  }`;

// Unit normals of the triangles; zero for those without area.
function faceNormals(p, triangles) {
  const normals = new Float32Array(triangles.length);
  for (let t = 0; t < triangles.length; t += 3) {
    const [a, b, c] = [3 * triangles[t], 3 * triangles[t + 1], 3 * triangles[t + 2]];
    const u = [p[b] - p[a], p[b + 1] - p[a + 1], p[b + 2] - p[a + 2]];
    const v = [p[c] - p[a], p[c + 1] - p[a + 1], p[c + 2] - p[a + 2]];
    const n = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
    const length = Math.hypot(...n) || 1;
    for (let i = 0; i < 3; ++i) normals[t + i] = n[i] / length;
  }
  return normals;
}

// The normals of the corners: the mean over those triangles at a point that are about as steep, so
// that edges stay sharp and what is round looks round.
function cornerNormals(positions, triangles) {
  const ofFaces = faceNormals(positions, triangles);
  const first = new Uint32Array(positions.length / 3 + 2);
  for (const point of triangles) ++first[point + 2];
  for (let i = 2; i < first.length; ++i) first[i] += first[i - 1];
  const around = new Uint32Array(triangles.length);
  for (let k = 0; k < triangles.length; ++k) around[first[triangles[k] + 1]++] = k - (k % 3);
  const result = new Float32Array(3 * triangles.length);
  for (let k = 0; k < triangles.length; ++k) {
    const own = k - (k % 3);
    for (let j = first[triangles[k]]; j < first[triangles[k] + 1]; ++j) {
      const other = around[j];
      let cosine = 0;
      for (let i = 0; i < 3; ++i) cosine += ofFaces[own + i] * ofFaces[other + i];
      if (cosine > 0.75 || other === own)
        for (let i = 0; i < 3; ++i) result[3 * k + i] += ofFaces[other + i];
    }
  }
  return result;
}

function meshGeometry(shape) {
  const geometry = new BufferGeometry();
  const positions = new Float32Array(3 * shape.triangles.length);
  shape.triangles.forEach((point, k) => {
    for (let i = 0; i < 3; ++i) positions[3 * k + i] = shape.positions[3 * point + i];
  });
  geometry.setAttribute('position', new BufferAttribute(positions, 3));
  geometry.setAttribute('normal', new BufferAttribute(cornerNormals(shape.positions, shape.triangles), 3));
  const element = (vertex) => {
    const triangle = Math.floor(vertex / 3);
    return shape.elements ? shape.elements[triangle] : triangle;
  };
  return {geometry, element};
}

// Points without coordinates, the gaps of a depth camera, are left out.
function cloudGeometry(shape) {
  const points = [];
  for (let i = 0; i < shape.positions.length / 3; ++i)
    if (!Number.isNaN(shape.positions[3 * i])) points.push(i);
  const select = (values) => {
    const result = new Float32Array(3 * points.length);
    points.forEach((point, k) => result.set(values.subarray(3 * point, 3 * point + 3), 3 * k));
    return new BufferAttribute(result, 3);
  };
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', select(shape.positions));
  geometry.setAttribute('normal', select(shape.normals || shape.positions));
  return {geometry, element: (vertex) => points[vertex]};
}

// The middle of each part: the mean of its vertices.
function middles(positions, parts, count) {
  const sums = new Float64Array(4 * count);
  parts.forEach((part, vertex) => {
    if (part < 0) return;
    for (let i = 0; i < 3; ++i) sums[4 * part + i] += positions[3 * vertex + i];
    ++sums[4 * part + 3];
  });
  return sums;
}

class Drawing {
  constructor(shape) {
    const isMesh = shape.kind === 'mesh';
    Object.assign(this, isMesh ? meshGeometry(shape) : cloudGeometry(shape));
    const count = this.geometry.getAttribute('position').count;
    this.uniforms = {
      apart: {value: 0},
      chosen: {value: -1},
      isLit: {value: isMesh || Boolean(shape.normals)},
      isRound: {value: !isMesh},
      pixels: {value: window.innerHeight * window.devicePixelRatio},
      spacing: {value: 4 / Math.sqrt(Math.max(count, 1))},
    };
    for (const [name, size] of [['away', 3], ['tint', 3], ['part', 1]])
      this.geometry.setAttribute(name, new BufferAttribute(new Float32Array(size * count), size));
    const material = (shader) => new ShaderMaterial({
      uniforms: this.uniforms, vertexShader, fragmentShader: shader, side: DoubleSide,
    });
    const Kind = isMesh ? Mesh : Points;
    this.object = new Kind(this.geometry, material(fragmentShader));
    this.object.frustumCulled = false;
    this.partObject = new Kind(this.geometry, material(partShader));
    this.partObject.material.blending = NoBlending;
    this.partObject.frustumCulled = false;
    this.partScene = new Scene();
    this.partScene.add(this.partObject);
    this.pixel = new WebGLRenderTarget(1, 1);
  }

  setStage(stage) {
    const {position, away, tint, part} = this.geometry.attributes;
    const colors = stage.colors.map((text) => new Color().setStyle(text, ''));
    const grey = new Color(0.55, 0.55, 0.55);
    for (let k = 0; k < position.count; ++k) {
      part.array[k] = stage.labels[this.element(k)];
      (colors[part.array[k]] || grey).toArray(tint.array, 3 * k);
    }
    const sums = middles(position.array, part.array, colors.length);
    for (let k = 0; k < position.count; ++k)
      for (let i = 0; i < 3; ++i) {
        const p = part.array[k];
        away.array[3 * k + i] = p < 0 ? 0 : sums[4 * p + i] / sums[4 * p + 3];
      }
    for (const attribute of [away, tint, part]) attribute.needsUpdate = true;
  }

  // The part under a place of the window, or -1: one pixel is drawn and read.
  partAt(renderer, camera, x, y) {
    const whole = {...camera.view};
    camera.setViewOffset(whole.fullWidth, whole.fullHeight, whole.offsetX + x, whole.offsetY + y, 1, 1);
    const background = renderer.getClearColor(new Color());
    renderer.setRenderTarget(this.pixel);
    renderer.setClearColor(0x000000, 0);
    renderer.clear();
    renderer.render(this.partScene, camera);
    const rgba = new Uint8Array(4);
    renderer.readRenderTargetPixels(this.pixel, 0, 0, 1, 1, rgba);
    renderer.setRenderTarget(null);
    renderer.setClearColor(background, 1);
    camera.setViewOffset(whole.fullWidth, whole.fullHeight, whole.offsetX, whole.offsetY, whole.width,
                         whole.height);
    return rgba[0] + 256 * rgba[1] + 65536 * rgba[2] - 1;
  }
}

export function makeDrawing(shape) {
  return new Drawing(shape);
}
