// Reads the data in the page and shows them: first the table, then the surface, then the shading of its cavities.

// The browser can lose the graphics card, and get it back.
function watchContext(viewer, page) {
  viewer.canvas.addEventListener('webglcontextlost', event => {
    event.preventDefault();
    page.say('The browser lost the graphics card. The table still works; the surface reappears when the card ' +
             'is back.', true);
    viewer.draw();
  });
  viewer.canvas.addEventListener('webglcontextrestored', () => {
    viewer.setRenderer(new Renderer(viewer.canvas));
    page.say('');
    page.refresh();
  });
}

function makeRenderer(viewer, page) {
  try {
    viewer.setRenderer(new Renderer(viewer.canvas));
    watchContext(viewer, page);
  } catch (error) {
    page.say(`The surface cannot be drawn here: ${error.message}. The table works without it.`, true);
  }
}

// A sample of the points, to fit the view to the surface.
function someOf(points, placing) {
  const count = points.length / 4, step = Math.max(1, Math.floor(count / 5000));
  return Array.from({ length: Math.ceil(count / step) }, (_, i) => placing.at(points, i * step));
}

async function loadSurfaces(viewer, page) {
  const surfaces = [];
  for (const [i, surface] of scene.surfaces.entries()) {
    page.say(`Unpacking ${surface.faces.toLocaleString('en')} triangles\u2026`);
    await soon();
    surfaces.push(await loadSurface(surface, `surface${i}`, viewer.size));
  }
  if (!viewer.renderer.gl.isContextLost())
    page.say('');
  surfaces.forEach(surface => viewer.addSurface(surface));
  viewer.camera.home.points = surfaces.flatMap(({ points }) => someOf(points, viewer.placing));
  viewer.isAtHome = true;
}

// Computed while the user does not turn the surface.
async function addLight(viewer) {
  for (const [i, surface] of viewer.surfaces.entries()) {
    const isDone = await addOpenness(surface, viewer.size, async () => {
      do
        await new Promise(resolve => setTimeout(resolve, viewer.isBusy ? 100 : 0));
      while (viewer.isBusy);
      return false;
    });
    if (isDone && viewer.isReady)
      viewer.renderer.setNormals(i, surface.normals);
    viewer.draw();
  }
}

async function start() {
  const began = performance.now(), viewer = new Viewer(element('canvas'), scene);
  const canUnpack = 'DecompressionStream' in window;
  if (canUnpack)
    viewer.setLines(await loadLines(scene));
  else
    scene.lines = [];
  const page = new Page(viewer);
  window.htloops = { page, viewer, scene };
  if (canUnpack)
    makeRenderer(viewer, page);
  else
    page.say('This browser is too old to unpack the surface. The table still works.', true);
  if (viewer.renderer)
    await loadSurfaces(viewer, page);
  page.refresh();
  viewer.isMoving = true; // so that large surfaces appear at once, with fewer triangles
  viewer.costs.triangle = 1e-3;
  viewer.drawNow();
  window.htloops.loadMilliseconds = performance.now() - began;
  viewer.isMoving = false;
  viewer.isLightDue = Boolean(viewer.renderer);
  viewer.draw();
  document.body.classList.add('ready');
  if (viewer.renderer)
    await addLight(viewer);
  viewer.isLightDue = false;
}

start().catch(error => {
  element('message').textContent = `The page cannot read its data: ${error.message}`;
  element('message').classList.add('bad');
  throw error;
});
