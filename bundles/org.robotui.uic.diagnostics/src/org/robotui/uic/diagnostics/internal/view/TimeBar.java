package org.robotui.uic.diagnostics.internal.view;

import java.util.Optional;
import java.util.function.Consumer;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.graphics.Rectangle;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Event;
import org.robotui.ui.Face;
import org.robotui.ui.Figures;
import org.robotui.ui.PaintedCanvas;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.uic.diagnostics.internal.model.Shown;
import org.robotui.uic.diagnostics.internal.model.Strip;

/** How the whole was, with its times; a click or a drag looks at a moment, the arrow keys step. Display thread. */
final class TimeBar {
  static final int HEIGHT = 40;

  private static final int STRIP_TOP = 4;
  private static final int STRIP_HEIGHT = 16;
  private static final int ROOM_FOR_MIDDLE = 200;
  private static final int SECONDS_PER_MINUTE = 60;

  private final PaintedCanvas canvas;
  private final Theme theme;
  private final StripPainter strips;
  private final Consumer<Optional<Long>> looked;
  private Optional<Shown> shown = Optional.empty();

  TimeBar(Composite parent, Theme theme, Consumer<Optional<Long>> looked) {
    this.theme = theme;
    this.looked = looked;
    this.strips = new StripPainter(theme);
    canvas = new PaintedCanvas(parent, theme, this::paint);
    canvas.setToolTipText("The worst of all parts; a click shows that moment");
    canvas.addListener(SWT.MouseDown, this::pressed);
    canvas.addListener(SWT.MouseMove, e -> {
      if ((e.stateMask & SWT.BUTTON1) != 0) {
        look(e.x);
      }
    });
    canvas.addListener(SWT.KeyDown, this::key);
    canvas.addListener(SWT.FocusIn, e -> canvas.redraw());
    canvas.addListener(SWT.FocusOut, e -> canvas.redraw());
    canvas.addListener(SWT.Traverse,
        e -> e.doit = e.detail == SWT.TRAVERSE_TAB_NEXT || e.detail == SWT.TRAVERSE_TAB_PREVIOUS);
  }

  Control control() {
    return canvas;
  }

  void show(Shown next) {
    shown = Optional.of(next);
    canvas.redraw();
  }

  private void paint(GC gc, Rectangle area) {
    shown.ifPresent(s -> {
      Rectangle at = strip(area);
      strips.paint(gc, at, s.overall(), s.ask().slot());
      scale(gc, at, s);
      if (canvas.isFocusControl()) {
        gc.setForeground(theme.color(Role.ACCENT));
        gc.drawRectangle(at.x - 2, at.y - 2, at.width + 3, at.height + 3);
      }
    });
  }

  private void scale(GC gc, Rectangle at, Shown s) {
    gc.setFont(theme.font(Face.SMALL));
    gc.setForeground(theme.color(Role.DIM));
    double seconds = s.slotSeconds() * s.overall().size();
    int top = at.y + at.height + 2;
    gc.drawText(Figures.of(-seconds / SECONDS_PER_MINUTE, 0, "min"), at.x, top, true);
    if (at.width >= ROOM_FOR_MIDDLE) {
      text(gc, at, at.x + at.width / 2, top,
          Figures.of(-seconds / 2 / SECONDS_PER_MINUTE, seconds / 2 < SECONDS_PER_MINUTE ? 1 : 0, "min"));
    }
    text(gc, at, at.x + at.width, top, "now");
  }

  private static void text(GC gc, Rectangle at, int x, int y, String words) {
    Point size = gc.textExtent(words);
    gc.drawText(words, Math.min(x - size.x / 2, at.x + at.width - size.x), y, true);
  }

  private static Rectangle strip(Rectangle area) {
    return new Rectangle(area.x + Theme.EDGE, area.y + STRIP_TOP, Math.max(1, area.width - 2 * Theme.EDGE),
        STRIP_HEIGHT);
  }

  private void pressed(Event event) {
    canvas.setFocus();
    if (event.button == 1) {
      look(event.x);
    }
  }

  private void look(int x) {
    Rectangle at = strip(canvas.getClientArea());
    shown.ifPresent(s -> looked.accept(Optional.of(StripPainter.slot(s.overall(), x - at.x, at.width))));
  }

  private void key(Event event) {
    switch (event.keyCode) {
      case SWT.ARROW_LEFT -> step(-1);
      case SWT.ARROW_RIGHT -> step(1);
      case SWT.ESC, SWT.END -> looked.accept(Optional.empty());
      default -> {}
    }
  }

  private void step(int by) {
    shown.ifPresent(s -> {
      Strip all = s.overall();
      long last = all.slot(all.size() - 1);
      long next = s.ask().slot().orElse(last) + by;
      looked.accept(next > last ? Optional.empty() : Optional.of(Math.max(all.slot(0), next)));
    });
  }
}
