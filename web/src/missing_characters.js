// A report carries no fonts of its own. Where the machine that shows it has none for a character of the
// text, a box stands in its place, and the page says which.

const SIZE = 24;
const UNASSIGNED = '\u{10FFFE}'; // a noncharacter: every font draws its box for it

function painter(fonts) {
  const canvas = document.createElement('canvas');
  canvas.width = canvas.height = 2 * SIZE;
  const context = canvas.getContext('2d', { willReadFrequently: true });
  context.font = `${SIZE}px ${fonts}`;
  context.textBaseline = 'middle';
  return (character) => {
    context.clearRect(0, 0, canvas.width, canvas.height);
    context.fillText(character, 0, SIZE);
    return context.getImageData(0, 0, canvas.width, canvas.height).data.join();
  };
}

/** Characters beyond ASCII that the text of the page has, each once. */
function charactersOf(element) {
  const text = element.innerText ?? element.textContent;
  // Blanks, controls and what joins to its neighbours have no picture of their own.
  return [...new Set(text)].filter((c) => c > '~' && !/[\p{Z}\p{Cc}\p{Cf}\p{M}]/u.test(c));
}

/** Boxes of unassigned characters may show their number; those of two such characters then differ. */
function isBox(paint, character) {
  const picture = paint(character);
  return picture === paint(UNASSIGNED) || picture === paint('\u{10FFFF}');
}

/** Puts a sentence under the title that names the characters without a font. */
export function nameMissingCharacters() {
  const main = document.querySelector('main');
  const header = document.querySelector('header');
  if (!main || !header) return;
  const paint = painter(getComputedStyle(document.body).fontFamily);
  const missing = charactersOf(main).filter((character) => isBox(paint, character));
  if (missing.length === 0) return;
  const note = document.createElement('p');
  note.className = 'small missing-characters';
  const codes = missing.slice(0, 8).map((c) => `U+${c.codePointAt(0).toString(16).toUpperCase().padStart(4, '0')}`);
  const more = missing.length > 8 ? ` and ${missing.length - 8} more` : '';
  note.textContent =
    `This machine has no font for some characters of this report, and shows boxes for them: ${codes.join(', ')}${more}. ` +
    'The file holds them: open or print it where such a font is installed.';
  header.after(note);
}
