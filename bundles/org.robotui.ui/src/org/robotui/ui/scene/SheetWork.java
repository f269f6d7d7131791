package org.robotui.ui.scene;

import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Rectangle;
import org.robotui.ui.PaintedCanvas;
import org.robotui.ui.Theme;

/** A scene that is being painted into a sheet, in turns. Display thread. */
final class SheetWork {
  /** How long one takes, nanoseconds, where no single layer takes longer. */
  private static final long TURN = 3_000_000;

  private final SceneSheet sheet;
  private final GC gc;
  private final ScenePass pass;
  private long nanos;

  /** Takes the layers that are there now. */
  SheetWork(Scene scene, SceneSheet sheet, PaintedCanvas canvas, Theme theme) {
    this.sheet = sheet;
    gc = sheet.open();
    canvas.ground(gc, new Rectangle(0, 0, sheet.viewport().width(), sheet.viewport().height()));
    pass = new ScenePass(scene, new Painter(gc, sheet.viewport(), theme));
  }

  SceneSheet sheet() {
    return sheet;
  }

  /** Paints for a while; returns whether it is complete. */
  boolean turn() {
    long start = System.nanoTime();
    boolean complete = pass.paintUntil(start + TURN);
    nanos += System.nanoTime() - start;
    return complete;
  }

  /** What all turns together took. */
  long nanos() {
    return nanos;
  }

  /** Whether another painting was asked for, as not all could be drawn within this one. */
  boolean wantsAgain() {
    return pass.painter().wantsAgain();
  }

  /** Ends it; the sheet stays. */
  void end() {
    gc.dispose();
  }
}
