// Draws the figures of a report. Text and tables are plain HTML already; this script only turns the
// figure data (JSON: id -> {data, layout}) into plots, and lays them out anew for paper.
import Plotly from 'plotly.js-basic-dist-min';

import { nameMissingCharacters } from './missing_characters.js';
import './report.css';

const CONFIG = {
  responsive: true,
  displaylogo: false,
  displayModeBar: false,
  // Plain dragging must scroll the page on a phone; zooming stays on the toolbar and the mouse.
  scrollZoom: false,
};

/** The figures' data, {} where the report has none. */
function readFigures() {
  const element = document.getElementById('figures');
  return element ? JSON.parse(element.textContent) : {};
}

/** Draws one figure into its element, in place of the note that stands there without a script. */
async function draw(element, figure) {
  element.replaceChildren();
  await Plotly.newPlot(element, figure.data, { ...figure.layout, autosize: true }, CONFIG);
  element.dataset.drawn = 'true';
}

function drawnFigures() {
  return document.querySelectorAll('.figure[data-drawn="true"]');
}

/** Fixed sizes (CSS pixels) that fit the printed page; the report states them for each figure. */
function layOutForPrint() {
  for (const element of drawnFigures()) {
    Plotly.relayout(element, {
      autosize: false,
      width: Number(element.dataset.printWidth),
      height: Number(element.dataset.printHeight),
    });
  }
}

function layOutForScreen() {
  for (const element of drawnFigures()) {
    Plotly.relayout(element, { autosize: true, width: null, height: null });
  }
}

/** A legend entry shows and hides the traces of its group in the figures of its block. */
function connectLegends(figures) {
  for (const entry of document.querySelectorAll('button.legend-entry')) {
    entry.addEventListener('click', () => {
      const shown = entry.getAttribute('aria-pressed') !== 'true';
      entry.setAttribute('aria-pressed', String(shown));
      for (const element of entry.closest('.figure-block').querySelectorAll('.figure')) {
        const traces = figures[element.id].data;
        const members = traces.flatMap((t, i) => (t.legendgroup === entry.dataset.group ? [i] : []));
        if (members.length > 0) Plotly.restyle(element, { visible: shown }, members);
      }
    });
  }
}

async function drawAll() {
  nameMissingCharacters();
  const figures = readFigures();
  let failed = 0;
  for (const element of document.querySelectorAll('.figure')) {
    try {
      await draw(element, figures[element.id]);
    } catch (error) {
      // The other figures are still worth drawing; this one says what went wrong.
      failed += 1;
      element.textContent = `This figure could not be drawn: ${error.message}`;
    }
  }
  connectLegends(figures);
  document.documentElement.dataset.ready = failed === 0 ? 'true' : 'failed';
}

document.addEventListener('securitypolicyviolation', (event) => {
  document.documentElement.dataset.violation = `${event.violatedDirective} ${event.blockedURI}`;
});
window.addEventListener('error', (event) => {
  document.documentElement.dataset.scriptError = event.message;
});
window.addEventListener('unhandledrejection', (event) => {
  document.documentElement.dataset.scriptError = String(event.reason);
});
window.addEventListener('beforeprint', layOutForPrint);
window.addEventListener('afterprint', layOutForScreen);

if (document.readyState === 'loading') {
  document.addEventListener('DOMContentLoaded', drawAll);
} else {
  drawAll();
}
