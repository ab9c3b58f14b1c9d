// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Opens pages of segment_shape --view in a headless Chromium: they load without an error and without
// the network, they draw, and stepping, pulling apart and hovering change what is seen.
//
//   node test_view.mjs BIN_DIR VIEW_DIR      exit code 77: skipped, with a note why

import assert from 'node:assert/strict';
import {execFileSync, spawnSync} from 'node:child_process';
import {existsSync, mkdirSync, mkdtempSync, readdirSync, rmSync, writeFileSync} from 'node:fs';
import {createRequire} from 'node:module';
import {tmpdir} from 'node:os';
import {delimiter, join, resolve} from 'node:path';
import {pathToFileURL} from 'node:url';

const [binDir, viewDir] = process.argv.slice(2).map((path) => resolve(path));
const environment = {...process.env, WCS_VIEW_DIR: viewDir};

function skip(why) {
  console.log(`Skipped: ${why}`);
  process.exit(77);
}

const findChromium = () => (process.env.PATH || '').split(delimiter)
  .flatMap((folder) => ['chromium', 'chromium-browser', 'google-chrome'].map((name) => join(folder, name)))
  .find(existsSync);

const chromium = findChromium();
if (!existsSync(join(viewDir, 'page.html')))
  skip('the page was not made; scripts/setup.sh view, then cmake --build BUILD --target view');
if (!chromium) skip('there is no Chromium; scripts/setup.sh view installs it');

const require = createRequire(join(viewDir, 'package.json'));
const puppeteer = require('puppeteer-core');
const scratch = mkdtempSync(join(tmpdir(), 'wcs-view-'));
const run = (program, ...args) => execFileSync(join(binDir, program), args,
                                               {cwd: scratch, env: environment, stdio: 'pipe'});
const frame = (page) => page.evaluate(() => new Promise(
  (done) => requestAnimationFrame(() => requestAnimationFrame(done))));

// How many colors, other than the background's, the picture has on a coarse grid, and a fingerprint.
async function look(page) {
  await frame(page);
  return page.evaluate(() => {
    const canvas = document.querySelector('canvas');
    const small = document.createElement('canvas');
    [small.width, small.height] = [160, 120];
    const context = small.getContext('2d');
    context.imageSmoothingEnabled = false;
    context.drawImage(canvas, 0, 0, 160, 120);
    const data = context.getImageData(0, 0, 160, 120).data;
    const pixels = [];
    for (let i = 0; i < data.length; i += 4) pixels.push((data[i] << 16) | (data[i + 1] << 8) | data[i + 2]);
    const drawn = pixels.filter((pixel) => pixel !== pixels[0]);
    return {pixels, colors: new Set(drawn).size, share: drawn.length / pixels.length};
  });
}

const difference = (a, b) => a.pixels.filter((pixel, i) => pixel !== b.pixels[i]).length / a.pixels.length;

async function open(browser, file, hash = '') {
  const page = await browser.newPage();
  const problems = [];
  page.on('console', (message) => {
    if (['error', 'warn', 'warning'].includes(message.type()) && !/GPU stall|swiftshader/i.test(message.text()))
      problems.push(message.text());
  });
  page.on('pageerror', (error) => problems.push(String(error)));
  page.on('request', (request) => {
    if (!/^(file|data|blob):/.test(request.url())) problems.push('network: ' + request.url());
  });
  page.on('dialog', (dialog) => { problems.push('a script of a name ran'); dialog.dismiss(); });
  await page.setViewport({width: 1000, height: 700});
  await page.goto(pathToFileURL(file) + hash);
  await page.waitForSelector('body[data-ready=true]', {timeout: 60000}).catch(() => {
    throw new Error('the page did not get ready: ' + problems.join('; '));
  });
  return {page, problems};
}

async function checkSteps(page) {
  const segments = await look(page);
  assert.ok(segments.share > 0.03, `something is drawn: ${segments.share}`);
  assert.ok(segments.colors > 10, `with colors: ${segments.colors}`);
  const count = (stage) => page.$eval(`button[data-stage=${stage}]`, (button) => parseInt(button.textContent));
  const seen = new Map([[await count('segments'), segments]]); // as many parts as before may be the same parts
  for (const stage of ['components', 'patches']) {
    await page.click(`button[data-stage=${stage}]`);
    const picture = await look(page);
    const parts = await count(stage);
    for (const [otherParts, other] of seen)
      if (otherParts !== parts)
        assert.ok(difference(picture, other) > 0.001, `${stage} look different from what was before`);
    seen.set(parts, picture);
  }
  assert.ok(seen.size > 1, 'there is something to step through');
  await page.click('button[data-stage=segments]');
  await page.mouse.move(5, 690);
  assert.ok(difference(await look(page), segments) < 0.001, 'stepping back gives the first picture');
}

async function checkApart(page) {
  const together = await look(page);
  await page.focus('#apart');
  await page.keyboard.press('End');
  const apart = await look(page);
  assert.ok(difference(together, apart) > 0.02, 'the slider changes the picture');
  await page.keyboard.press('Home');
}

// Goes over the picture until a part is hit.
async function checkHover(page) {
  for (let y = 120; y < 700; y += 30)
    for (let x = 300; x < 1000; x += 30) {
      await page.mouse.move(x, y);
      const tip = await page.$eval('#tip', (tip) => (tip.style.display === 'block' ? tip.textContent : ''));
      if (!tip) continue;
      assert.match(tip, /^segment \d+\n\d+ (faces|points), [\d.]+ % of the shape\nconvexity rank [01]\.\d+/);
      return;
    }
  assert.fail('no part was hit');
}

async function checkShape(browser, input, name) {
  const file = join(scratch, `page of ${name}.html`);
  run('segment_shape', input, '--view', file, '--quiet');
  const {page, problems} = await open(browser, file);
  const title = await page.$eval('h1', (h1) => h1.textContent);
  assert.equal(title, input, 'the name is shown as it is');
  await checkSteps(page);
  await checkApart(page);
  await checkHover(page);
  assert.deepEqual(problems, [], `no problem with ${name}`);
  await page.close();
  console.log(`The page of ${name} is right.`);
}

function checkErrors() {
  const empty = {...environment, WCS_VIEW_DIR: join(scratch, 'nowhere')};
  const result = spawnSync(join(binDir, 'segment_shape'), ['--view', join(scratch, 'none.html')],
                           {env: empty, encoding: 'utf8'});
  assert.equal(result.status, 1);
  assert.match(result.stderr, /^segment_shape: [^\n]*scripts\/setup\.sh view[^\n]*\n$/);
  assert.ok(!existsSync(join(scratch, 'none.html')), 'there is no page without the page');
}

async function test() {
  checkErrors();
  run('make_shapes', 'chair', '--faces', '3000', '-o', scratch);
  run('make_shapes', 'octopus', '--cloud', '--points', '4000', '-o', scratch);
  const shapes = readdirSync(scratch);
  const mesh = shapes.find((name) => /^chair.*\.(off|ply|obj)$/.test(name));
  const cloud = shapes.find((name) => /^octopus.*\.(xyz|ply|off|pwn)$/.test(name));
  // With a folder in it, the path of a file can hold the end of a script.
  const folder = join(scratch, 'стул <');
  mkdirSync(folder);
  const hostile = join(folder, 'script><script>alert(1)<!-- "é.off');
  const quads = ['OFF 16 12 0'];
  for (const [x, s] of [[0, 1], [1.5, 0.4]])
    for (const [i, j, k] of [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]])
      quads.push(`${x + s * i} ${s * j} ${s * k}`);
  for (const b of [0, 8])
    for (const q of [[3, 2, 1, 0], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]])
      quads.push('4 ' + q.map((corner) => b + corner).join(' '));
  writeFileSync(hostile, quads.join('\n') + '\n');

  const browser = await puppeteer.launch({
    executablePath: chromium,
    headless: true,
    args: ['--no-sandbox', '--disable-dev-shm-usage', '--use-gl=angle', '--use-angle=swiftshader',
           '--enable-unsafe-swiftshader', '--disable-background-networking', '--no-first-run'],
  });
  try {
    await checkShape(browser, join(scratch, mesh), 'a mesh');
    await checkShape(browser, join(scratch, cloud), 'a cloud');
    const file = join(scratch, 'hostile.html');
    run('segment_shape', hostile, '--view', file, '--quiet');
    const {page, problems} = await open(browser, file, '#stage=patches&apart=0.5');
    assert.equal(await page.$eval('h1', (h1) => h1.textContent), hostile);
    assert.equal(await page.$eval('#apart', (slider) => slider.value), '0.5');
    assert.ok((await look(page)).share > 0.02);
    assert.deepEqual(problems, []);
    console.log('The page of quadrangles with a hostile name is right.');
  } finally {
    await browser.close();
  }
}

try {
  await test();
} finally {
  rmSync(scratch, {recursive: true, force: true});
}
