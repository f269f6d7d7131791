package org.robotui.ui.scene;

import java.util.Optional;
import java.util.function.LongSupplier;
import org.robotui.ui.PaintedCanvas;
import org.robotui.ui.Theme;

/**
 * What a canvas shows of a scene. A scene that is painted quickly is painted as it is. One that takes long, as that of
 * many robots, is painted layer by layer into a sheet, in turns of a few milliseconds between which the display serves
 * others, and shown when it is complete; it then takes no more than half of the display's time. A camera that moves is
 * followed at once, whatever that takes. Display thread.
 */
public final class ScenePicture {
  private static final long MILLI = 1_000_000;
  /** A scene that takes longer is painted in turns, nanoseconds. */
  private static final long LONG = 6 * MILLI;
  /** If it does so more than once: a single one was held up by something else. */
  private static final int TIMES = 3;
  /** And as it is again where its turns together take less than this. */
  private static final long SHORT = 3 * MILLI;
  /**
   * Between two pictures it does nothing for as long as one takes, and for this at least: more of them a second are not
   * told apart on a map.
   */
  private static final long REST = 25 * MILLI;
  /** While a camera moves no sheet is worth its time. */
  private static final long STILL = 120 * MILLI;

  private final Scene scene;
  private final PaintedCanvas canvas;
  private final Theme theme;
  private final LongSupplier nanos;
  private Optional<SceneSheet> shown = Optional.empty();
  private Optional<SceneSheet> spare = Optional.empty();
  private Optional<SheetWork> work = Optional.empty();
  private Viewport viewport = new Viewport(0, 0, 1, 1, 1);
  private int slow;
  private boolean inTurns;
  private boolean changed;
  private boolean waiting;
  private long restUntil;

  /**
   * Of a scene.
   *
   * @param scene what is painted
   * @param canvas where; is asked to paint when there is something new
   * @param theme colours and fonts
   * @param nanos a monotonic clock, by which it is judged how long paintings take
   */
  public ScenePicture(Scene scene, PaintedCanvas canvas, Theme theme, LongSupplier nanos) {
    this.scene = scene;
    this.canvas = canvas;
    this.theme = theme;
    this.nanos = nanos;
    restUntil = nanos.getAsLong();
    canvas.atEnd(this::dispose);
  }

  /** Something of the scene has changed: asks the canvas to paint, at once or when the picture of it is complete. */
  public void refresh() {
    if (inTurns) {
      changed = true;
      pump();
    } else {
      canvas.requestPaint();
    }
  }

  /**
   * Paints the scene, or what was made of it for this viewport.
   *
   * @param painter of the canvas
   */
  public void paint(Painter painter) {
    if (!painter.viewport().equals(viewport)) {
      viewport = painter.viewport();
      restUntil = nanos.getAsLong() + STILL;
    }
    shown.filter(this::fits).ifPresentOrElse(sheet -> sheet.paint(painter.gc()), () -> paintNow(painter));
  }

  /**
   * Whether the next painting shows all that was said to have changed.
   *
   * @return false while a picture of it is still being made
   */
  public boolean upToDate() {
    return !changed && work.isEmpty();
  }

  private boolean fits(SceneSheet sheet) {
    return sheet.shows(viewport, canvas.zoom());
  }

  private void paintNow(Painter painter) {
    long start = nanos.getAsLong();
    scene.paint(painter);
    slow = nanos.getAsLong() - start > LONG ? slow + 1 : 0;
    inTurns |= slow >= TIMES;
    if (inTurns) {
      refresh();
    }
  }

  private void pump() {
    if (!changed || waiting || work.isPresent() || canvas.isDisposed()) {
      return;
    }
    long rest = restUntil - nanos.getAsLong();
    if (rest > 0) {
      waiting = true;
      canvas.getDisplay().timerExec((int) Math.ceilDiv(rest, MILLI), this::rested);
    } else {
      begin();
    }
  }

  private void rested() {
    waiting = false;
    pump();
  }

  private void begin() {
    changed = false;
    scene.release();
    SceneSheet sheet =
        spare.filter(this::fits).orElseGet(() -> new SceneSheet(canvas.getDisplay(), viewport, canvas.zoom()));
    spare.filter(s -> s != sheet).ifPresent(SceneSheet::dispose);
    spare = Optional.empty();
    SheetWork begun = new SheetWork(scene, sheet, canvas, theme, nanos);
    work = Optional.of(begun);
    canvas.getDisplay().asyncExec(() -> turn(begun));
  }

  private void turn(SheetWork begun) {
    if (work.filter(w -> w == begun).isEmpty()) {
      return;
    }
    if (!fits(begun.sheet())) {
      giveUp(begun);
      refresh();
    } else if (begun.turn()) {
      finish(begun);
    } else {
      canvas.getDisplay().asyncExec(() -> turn(begun));
    }
  }

  private void finish(SheetWork done) {
    done.end();
    work = Optional.empty();
    spare = shown;
    shown = Optional.of(done.sheet());
    changed |= done.wantsAgain();
    restUntil = nanos.getAsLong() + Math.max(done.nanos(), REST);
    canvas.requestPaint();
    if (done.nanos() < SHORT) {
      inTurns = false;
      changed = false;
      slow = 0;
      forget();
    }
    pump();
  }

  private void giveUp(SheetWork begun) {
    begun.end();
    begun.sheet().dispose();
    work = Optional.empty();
  }

  private void forget() {
    shown.ifPresent(SceneSheet::dispose);
    spare.ifPresent(SceneSheet::dispose);
    shown = Optional.empty();
    spare = Optional.empty();
  }

  private void dispose() {
    work.ifPresent(this::giveUp);
    forget();
  }
}
