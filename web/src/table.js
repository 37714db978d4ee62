// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause

// What a cell sorts by: its number, else its text; empty numbers sort last either way.
function sortKey(row, column) {
  const cell = row.cells[column];
  if (!cell.classList.contains('number')) return cell.textContent;
  return cell.dataset.value === undefined ? NaN : +cell.dataset.value;
}

function compare(a, b, sign) {
  if (typeof a === 'string') return sign * a.localeCompare(b, undefined, { numeric: true });
  if (Number.isNaN(a) || Number.isNaN(b)) return Number.isNaN(a) - Number.isNaN(b);
  return sign * (a - b);
}

// A click on a heading sorts by its column, a second one the other way. Equal rows keep their order.
export function makeSortable(table) {
  const headings = [...table.tHead.rows[0].cells];
  headings.forEach((heading, column) => {
    if (column === 0) return;
    const button = document.createElement('button');
    button.type = 'button';
    button.textContent = heading.textContent;
    heading.replaceChildren(button);
    button.addEventListener('click', () => {
      const sign = heading.ariaSort === 'ascending' ? -1 : 1;
      for (const other of headings) other.ariaSort = null;
      heading.ariaSort = sign > 0 ? 'ascending' : 'descending';
      const body = table.tBodies[0];
      const keyed = [...body.rows].map((row) => [sortKey(row, column), row]);
      body.append(...keyed.sort(([a], [b]) => compare(a, b, sign)).map(([, row]) => row));
    });
  });
}

function fillChoices(select, all, values) {
  select.replaceChildren(...[all, ...new Set(values)].map((text, i) => new Option(text, i === 0 ? '' : text)));
  select.hidden = select.options.length < 3;
}

// Shows the rows that have all the words, the data set and the features chosen.
export function makeFilterable(table) {
  const [words, dataset, features, count] = ['filter', 'filter-dataset', 'filter-features', 'count'].map((id) => document.getElementById(id));
  const rows = [...table.tBodies[0].rows];
  fillChoices(dataset, 'all data sets', rows.map((row) => row.dataset.dataset));
  fillChoices(features, 'all features', rows.map((row) => row.dataset.features));
  const apply = () => {
    const wanted = words.value.toLowerCase().split(/\s+/).filter(Boolean);
    for (const row of rows) {
      const text = row.textContent.toLowerCase();
      row.hidden = !wanted.every((word) => text.includes(word)) || (dataset.value && row.dataset.dataset !== dataset.value) || (features.value && row.dataset.features !== features.value);
    }
    count.textContent = `${rows.filter((row) => !row.hidden).length} of ${rows.length} rows`;
  };
  for (const control of [words, dataset, features]) control.addEventListener('input', apply);
  apply();
}
