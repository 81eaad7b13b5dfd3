// What leaves the page: a picture, and the command for the chosen rows.

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

  // As large as what is on the page.
  get size() {
    const { clientWidth, clientHeight } = this.viewer.canvas;
    return [clientWidth, clientHeight].map(x => Math.round(x * (window.devicePixelRatio || 1)));
  }

  proposeSize() {
    ['width', 'height'].forEach((id, i) => { element(id).value ||= this.size[i]; });
  }

  save() {
    const { viewer, page } = this, { renderer, camera } = viewer;
    if (!viewer.isReady)
      return page.say('There is no picture to save.', true);
    const [width, height] = ['width', 'height'].map((id, i) =>
      clamped(Math.round(Number(element(id).value)) || this.size[i], 16, renderer.largestSide));
    const { aspect } = camera, drawn = made('canvas', { width, height });
    const background = element('clear-background').checked ? [0, 0, 0, 0] : [...viewer.background, 1];
    camera.aspect = width / height;
    drawn.getContext('2d').putImageData(renderer.image(viewer, width, height, background), 0, 0);
    camera.aspect = aspect;
    viewer.draw();
    drawn.toBlob(blob => this.download(blob));
    return page.closeMenus();
  }

  download(blob) {
    if (!blob)
      return this.page.say('This browser cannot make a picture of that size.', true);
    const link = made('a', { href: URL.createObjectURL(blob), download: `${scene.name}.png` });
    link.click();
    return setTimeout(() => URL.revokeObjectURL(link.href), 1000);
  }

  copy() {
    element('choice').select();
    if (navigator.clipboard && window.isSecureContext)
      navigator.clipboard.writeText(element('choice').value).catch(() => document.execCommand('copy'));
    else
      document.execCommand('copy');
  }
}
