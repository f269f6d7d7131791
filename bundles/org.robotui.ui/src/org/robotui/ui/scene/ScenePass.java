package org.robotui.ui.scene;

import java.util.List;

/** One painting of the visible layers of a scene, lowest first, which may be interrupted between them. Display thread. */
final class ScenePass {
  private final Scene scene;
  private final List<Layer> layers;
  private final Painter painter;
  private int next;

  /** Of the layers that are there now. */
  ScenePass(Scene scene, Painter painter) {
    this.scene = scene;
    this.painter = painter;
    layers = scene.layers();
  }

  Painter painter() {
    return painter;
  }

  /** Paints on until a moment of the monotonic clock has passed, one layer at least; returns whether all are painted. */
  boolean paintUntil(long nanos) {
    while (next < layers.size()) {
      scene.paint(layers.get(next++), painter);
      if (System.nanoTime() - nanos >= 0) {
        break;
      }
    }
    return next == layers.size();
  }
}
