/* Three dimensions: an arm with its frames, and a cloud of errors in the box of an accuracy. */

import {
  AmbientLight, BoxGeometry, BufferAttribute, BufferGeometry, CylinderGeometry, DirectionalLight, EdgesGeometry, Group,
  LineBasicMaterial, LineSegments, Mesh, MeshStandardMaterial, PerspectiveCamera, Points, PointsMaterial, Quaternion,
  Scene, SphereGeometry, Vector3, WebGLRenderer,
} from 'three';

const axes = [[0xd03030, 0], [0x2f8f2f, 1], [0x3060e0, 2]];

/** A view that is turned by mouse, finger and arrow keys, and drawn only when something has changed. */
export class View {
  /** @param {HTMLCanvasElement} canvas @param {number} distance of the eye */
  constructor(canvas, distance) {
    this.canvas = canvas;
    this.renderer = new WebGLRenderer({ canvas, antialias: true, alpha: true });
    this.scene = new Scene();
    this.camera = new PerspectiveCamera(40, 1, 0.001, 1000);
    this.camera.up.set(0, 0, 1);
    this.scene.add(new AmbientLight(0xffffff, 1.6));
    const light = new DirectionalLight(0xffffff, 2);
    light.position.set(2, -3, 5);
    this.scene.add(light);
    this.content = new Group();
    this.scene.add(this.content);
    this.turn = -0.9;
    this.tilt = 0.45;
    this.distance = distance;
    this.listen();
    new ResizeObserver(() => this.draw()).observe(canvas);
  }

  listen() {
    const { canvas } = this;
    canvas.addEventListener('pointerdown', (event) => canvas.setPointerCapture(event.pointerId));
    canvas.addEventListener('pointermove', (event) => {
      if (event.buttons) this.rotate(-event.movementX / 150, event.movementY / 150);
    });
    canvas.addEventListener('wheel', (event) => {
      event.preventDefault();
      this.zoom(Math.exp(event.deltaY / 1000));
    }, { passive: false });
    const keys = {
      ArrowLeft: () => this.rotate(0.1, 0), ArrowRight: () => this.rotate(-0.1, 0), ArrowUp: () => this.rotate(0, 0.1),
      ArrowDown: () => this.rotate(0, -0.1), '+': () => this.zoom(0.9), '-': () => this.zoom(1.1),
    };
    canvas.addEventListener('keydown', (event) => {
      if (!keys[event.key]) return;
      event.preventDefault();
      keys[event.key]();
    });
  }

  rotate(turn, tilt) {
    this.turn += turn;
    this.tilt = Math.max(-1.5, Math.min(1.5, this.tilt + tilt));
    this.draw();
  }

  zoom(factor) {
    this.distance = Math.max(0.5, Math.min(40, this.distance * factor));
    this.draw();
  }

  clear() {
    this.content.traverse((node) => {
      node.geometry?.dispose();
      node.material?.dispose();
    });
    this.content.clear();
  }

  draw() {
    const { canvas, camera } = this;
    if (!canvas.clientWidth) return;
    this.renderer.setPixelRatio(Math.min(2, devicePixelRatio));
    this.renderer.setSize(canvas.clientWidth, canvas.clientHeight, false);
    camera.aspect = canvas.clientWidth / canvas.clientHeight;
    camera.position.set(Math.cos(this.tilt) * Math.cos(this.turn), Math.cos(this.tilt) * Math.sin(this.turn),
      Math.sin(this.tilt)).multiplyScalar(this.distance);
    camera.lookAt(0, 0, 0);
    camera.updateProjectionMatrix();
    this.renderer.render(this.scene, camera);
  }
}

function rod(from, to, radius, color) {
  const along = to.clone().sub(from);
  const mesh = new Mesh(new CylinderGeometry(radius, radius, along.length(), 16), new MeshStandardMaterial({ color }));
  mesh.position.copy(from).addScaledVector(along, 0.5);
  mesh.quaternion.copy(new Quaternion().setFromUnitVectors(new Vector3(0, 1, 0), along.normalize()));
  return mesh;
}

function lines(points, color) {
  const geometry = new BufferGeometry().setFromPoints(points);
  return new LineSegments(geometry, new LineBasicMaterial({ color }));
}

/** @param {View} view @param {number[][]} frames rows of the transforms, base first; scaled to fit the view */
export function drawArm(view, frames) {
  view.clear();
  const places = frames.map((m) => new Vector3(m[3], m[7], m[11]));
  const middle = places.reduce((sum, place) => sum.add(place), new Vector3()).divideScalar(places.length);
  const size = Math.max(1e-9, ...places.map((place) => place.distanceTo(middle)));
  const fitted = places.map((place) => place.clone().sub(middle).divideScalar(size));
  fitted.slice(1).forEach((place, i) => {
    if (place.distanceTo(fitted[i]) > 1e-6) view.content.add(rod(fitted[i], place, 0.035, 0x8899aa));
  });
  fitted.forEach((place, i) => {
    const last = i === fitted.length - 1;
    const joint = new Mesh(new SphereGeometry(last ? 0.06 : 0.05, 20, 12),
      new MeshStandardMaterial({ color: last ? 0xe07b00 : 0x556677 }));
    joint.position.copy(place);
    view.content.add(joint);
    for (const [color, column] of axes) {
      const direction = new Vector3(frames[i][column], frames[i][4 + column], frames[i][8 + column]);
      view.content.add(lines([place, place.clone().addScaledVector(direction, 0.25)], color));
    }
  });
  view.draw();
}

/* Points inside are small and round about the middle; those outside are larger, so that colour is not needed. */
function cloudOf(errors, accuracy, inside, size, color) {
  const chosen = errors.filter((error) => error.every((value, i) => Math.abs(value) <= accuracy[i]) === inside);
  const scaled = chosen.flatMap((error) => error.slice(0, 3).map((value, i) => value / accuracy[i]));
  const positions = Float32Array.from(scaled);
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(positions, 3));
  return new Points(geometry, new PointsMaterial({ size, color }));
}

/** The errors of the tool point, in units of the accuracy along each axis; the box of the accuracy is a cube. */
export function drawCloud(view, errors, accuracy) {
  view.clear();
  const box = new EdgesGeometry(new BoxGeometry(2, 2, 2));
  view.content.add(new LineSegments(box, new LineBasicMaterial({ color: 0x888888 })));
  view.content.add(cloudOf(errors, accuracy, false, 0.14, 0xd04a00));
  view.content.add(cloudOf(errors, accuracy, true, 0.07, 0x0072b2));
  view.draw();
}
