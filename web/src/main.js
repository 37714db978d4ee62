// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
import { startComparison } from './comparison.js';
import { startRun } from './run.js';

const data = JSON.parse(document.getElementById('data').textContent);
const start = data.kind === 'run' ? startRun : startComparison;
start(data).finally(() => { document.documentElement.dataset.ready = 'yes'; });
