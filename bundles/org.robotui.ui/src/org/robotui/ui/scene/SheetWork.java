package org.robotui.ui.scene;

import java.util.List;
import java.util.function.LongSupplier;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Rectangle;
import org.robotui.ui.PaintedCanvas;
import org.robotui.ui.Theme;

/** A scene that is being painted into a sheet: its visible layers, lowest first, in turns. Display thread. */
final class SheetWork {
  /** How long one takes, nanoseconds, where no single layer takes longer. */
  private static final long TURN = 3_000_000;

  private final Scene scene;
  private final List<Layer> layers;
  private final SceneSheet sheet;
  private final GC gc;
  private final Painter painter;
  private final LongSupplier clock;
  private int next;
  private long nanos;

  /** Takes the layers that are there now. */
  SheetWork(Scene scene, SceneSheet sheet, PaintedCanvas canvas, Theme theme, LongSupplier clock) {
    this.scene = scene;
    this.clock = clock;
    layers = scene.layers();
    this.sheet = sheet;
    gc = sheet.open();
    canvas.ground(gc, new Rectangle(0, 0, sheet.viewport().width(), sheet.viewport().height()));
    painter = new Painter(gc, sheet.viewport(), theme);
  }

  SceneSheet sheet() {
    return sheet;
  }

  /** Paints for a while, one layer at least where one is left; returns whether it is complete. */
  boolean turn() {
    long start = clock.getAsLong();
    long took = 0;
    while (next < layers.size() && took < TURN) {
      scene.paint(layers.get(next++), painter);
      took = clock.getAsLong() - start;
    }
    nanos += took;
    return next == layers.size();
  }

  /** What all turns together took. */
  long nanos() {
    return nanos;
  }

  /** Whether another painting was asked for, as not all could be drawn within this one. */
  boolean wantsAgain() {
    return painter.wantsAgain();
  }

  /** Ends it; the sheet stays. */
  void end() {
    gc.dispose();
  }
}
