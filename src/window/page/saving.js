// Saves a picture, and copies the command for the chosen rows.

const MOST_PIXELS = 4e7; // of a picture: 320 MB for the graphics card

class Saving {
  constructor(page) {
    this.page = page;
    this.viewer = page.viewer;
    element('save').closest('.menu').addEventListener('toggle', () => this.proposeSize());
    element('save').onclick = () => this.save();
    element('copy').onclick = () => this.copy();
    element('clear').onclick = () => {
      for (const row of page.table.rows)
        row.chosen = row.box.checked = false;
      page.refreshChoice();
    };
  }

  // The size of the view on the page.
  get size() {
    const { clientWidth, clientHeight } = this.viewer.canvas;
    return [clientWidth, clientHeight].map(x => Math.round(x * (window.devicePixelRatio || 1)));
  }

  proposeSize() {
    ['width', 'height'].forEach((id, i) => { element(id).value = this.size[i]; });
  }

  // The size in the menu, or null if it is not possible.
  get wantedSize() {
    const size = ['width', 'height'].map((id, i) => Math.round(Number(element(id).value)) || this.size[i]);
    const { largestSide } = this.viewer.renderer, [width, height] = size;
    return Math.min(...size) >= 16 && Math.max(...size) <= largestSide && width * height <= MOST_PIXELS ? size : null;
  }

  save() {
    const { viewer, page } = this;
    if (!viewer.isReady)
      return page.say('There is no picture to save.', true);
    const size = this.wantedSize;
    if (!size)
      return page.note(`A picture can have 16 to ${viewer.renderer.largestSide} pixels on a side, and at most ` +
                       `${MOST_PIXELS / 1e6} million in total.`);
    try {
      this.draw(...size).toBlob(blob => this.download(blob));
    } catch (error) {
      page.note(`The picture could not be drawn: ${error.message}`);
    }
    return page.closeMenus();
  }

  draw(width, height) {
    const { viewer } = this, { camera, renderer } = viewer, { aspect } = camera;
    const background = element('clear-background').checked ? [0, 0, 0, 0] : [...viewer.background, 1];
    const drawn = made('canvas', { width, height });
    viewer.stopRefining();
    try {
      camera.aspect = width / height;
      drawn.getContext('2d').putImageData(renderer.image(viewer, width, height, background), 0, 0);
    } finally {
      camera.aspect = aspect;
      viewer.draw();
    }
    return drawn;
  }

  download(blob) {
    if (!blob)
      return this.page.note('This browser cannot save a picture of that size.');
    const link = made('a', { href: URL.createObjectURL(blob), download: `${scene.name}.png` });
    link.click();
    return setTimeout(() => URL.revokeObjectURL(link.href), 1000);
  }

  async copy() {
    element('choice').select();
    try {
      await navigator.clipboard.writeText(element('choice').value);
      this.page.note('Copied.');
    } catch {
      const isCopied = document.execCommand('copy');
      this.page.note(isCopied ? 'Copied.' : 'This browser does not allow the page to copy. The text is selected.');
    }
  }
}
