// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Makes the page that segment_shape --view fills with a shape: view.html with view.js and three.js in it.
// Run in the folder that has the packages of package.json: node make_page.mjs SOURCE_DIR PAGE.html

import {readFileSync, renameSync, writeFileSync} from 'node:fs';
import {createRequire} from 'node:module';
import {join} from 'node:path';

const [sourceDir, page] = process.argv.slice(2);
const require = createRequire(join(process.cwd(), 'package.json'));
const esbuild = require('esbuild');

const built = await esbuild.build({
  entryPoints: [join(sourceDir, 'view.js')],
  nodePaths: [join(process.cwd(), 'node_modules')],
  bundle: true,
  minify: true,
  write: false,
  format: 'iife',
  target: 'es2020',
  charset: 'ascii',
  legalComments: 'inline', // the licence of three.js goes along
});
// Within a page, nothing in a script may look like its end.
const script = built.outputFiles[0].text.replace(/<\/(script)/gi, '<\\/$1').replace(/<!--/g, '<\\!--');
const html = readFileSync(join(sourceDir, 'view.html'), 'utf8');
const mark = '/* SCRIPT */';
if (html.split(mark).length !== 2) throw new Error(`view.html needs one ${mark}`);
writeFileSync(page + '.tmp', html.replace(mark, () => script));
renameSync(page + '.tmp', page);
