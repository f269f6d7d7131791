package org.robotui.ui;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicBoolean;
import org.eclipse.swt.SWT;
import org.eclipse.swt.events.PaintEvent;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Rectangle;
import org.eclipse.swt.widgets.Canvas;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Display;
import org.eclipse.swt.widgets.Listener;
import org.eclipse.swt.widgets.Shell;

/**
 * A double-buffered canvas in the colours of a theme. All coordinates are points, which SWT scales to the pixels of the
 * screen. Any number of {@link #requestPaint()} before the next paint make one paint.
 */
public final class PaintedCanvas extends Canvas {
  /** Paints the content. */
  @FunctionalInterface
  public interface Content {
    /**
     * Paints. Display thread.
     *
     * @param gc where; antialiased, with font, colours and background of the theme set
     * @param area the client area
     */
    void paint(GC gc, Rectangle area);
  }

  private final Theme theme;
  private final Content content;
  private final Role ground;
  private final Display display;
  private final Thread displayThread;
  private final AtomicBoolean requested = new AtomicBoolean();
  private final List<Runnable> atEnd = new ArrayList<>();
  private boolean painting; // display thread; GTK may lose a request that comes meanwhile
  private long paintNanos;
  private long paints;
  private int zoom; // 0 for not known

  /**
   * A canvas on the ground of views.
   *
   * @param parent the parent
   * @param theme colours and fonts
   * @param content paints it
   */
  public PaintedCanvas(Composite parent, Theme theme, Content content) {
    this(parent, SWT.NONE, theme, Role.PANEL, content);
  }

  /**
   * A canvas.
   *
   * @param parent the parent
   * @param style of SWT, in addition to double buffering
   * @param theme colours and fonts
   * @param ground what it is painted with before the content
   * @param content paints it
   */
  public PaintedCanvas(Composite parent, int style, Theme theme, Role ground, Content content) {
    super(parent, style | SWT.DOUBLE_BUFFERED | SWT.NO_BACKGROUND);
    this.theme = theme;
    this.content = content;
    this.ground = ground;
    this.display = getDisplay();
    this.displayThread = display.getThread();
    setBackground(theme.color(ground));
    // Each paint sets its own foreground: one of the control would be read back from a style sheet, as text, before
    // every paint.
    setFont(theme.font(Face.BODY));
    addPaintListener(this::paint);
    addDisposeListener(e -> atEnd.forEach(Runnable::run));
    watchZoom(getShell());
  }

  private void watchZoom(Shell window) {
    Listener moved = e -> zoom = 0;
    addListener(SWT.Resize, moved);
    addListener(SWT.ZoomChanged, moved);
    window.addListener(SWT.Move, moved);
    atEnd(() -> {
      if (!window.isDisposed()) {
        window.removeListener(SWT.Move, moved);
      }
    });
  }

  /** Has it painted soon, once for any number of calls. Any thread; after disposal it does nothing. */
  public void requestPaint() {
    if (Thread.currentThread() == displayThread && !painting) {
      repaint(); // SWT makes one paint of many itself
    } else if (requested.compareAndSet(false, true) && !display.isDisposed()) {
      display.asyncExec(this::repaint);
    }
  }

  /**
   * Has something run when the canvas is disposed, for example the disposal of an image that it paints. Display thread.
   *
   * @param action what to run
   */
  public void atEnd(Runnable action) {
    atEnd.add(action);
  }

  /**
   * How many pixels of the screen there are to a hundred points. Asking the display for its monitors takes as long as a
   * painting, so it is asked only when the canvas or its window has moved. Display thread.
   *
   * @return percent
   */
  public int zoom() {
    if (zoom == 0) {
      zoom = getMonitor().getZoom();
    }
    return zoom;
  }

  /**
   * How long the last paint took.
   *
   * @return nanoseconds, 0 before the first
   */
  public long paintNanos() {
    return paintNanos;
  }

  /**
   * How often it was painted.
   *
   * @return the count
   */
  public long paints() {
    return paints;
  }

  /**
   * Begins a painting as this canvas begins its own, also into something else, as an image. Display thread.
   *
   * @param gc is antialiased afterwards, with font, colours and background of the theme set
   * @param area is painted with the ground
   */
  public void ground(GC gc, Rectangle area) {
    gc.setBackground(theme.color(ground));
    gc.fillRectangle(area);
    gc.setAntialias(SWT.ON);
    gc.setTextAntialias(SWT.ON);
    gc.setFont(theme.font(Face.BODY));
    gc.setForeground(theme.color(Role.TEXT));
  }

  private void repaint() {
    requested.set(false);
    if (!isDisposed()) {
      redraw();
    }
  }

  private void paint(PaintEvent event) {
    long start = System.nanoTime();
    GC gc = event.gc;
    Rectangle area = getClientArea();
    painting = true;
    try {
      ground(gc, area);
      content.paint(gc, area);
    } finally {
      painting = false;
    }
    paints++;
    paintNanos = System.nanoTime() - start;
  }
}
