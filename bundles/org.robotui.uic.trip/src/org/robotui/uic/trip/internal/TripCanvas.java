package org.robotui.uic.trip.internal;

import java.util.function.Supplier;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Rectangle;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.robotui.ui.Face;
import org.robotui.ui.Figures;
import org.robotui.ui.PaintedCanvas;
import org.robotui.ui.Role;
import org.robotui.ui.StateView;
import org.robotui.ui.TextFit;
import org.robotui.ui.Theme;
import org.robotui.ui.ViewSurface;

/** Paints one line for each trip, and what the state of the port is where there is none. Display thread. */
final class TripCanvas implements ViewSurface {

  private static final int LINE = 28;

  private final Theme theme;
  private final StateView states;
  private final Supplier<TripViewState> state;
  private final PaintedCanvas canvas;

  TripCanvas(Composite parent, Theme theme, Supplier<TripViewState> state) {
    this.theme = theme;
    this.states = new StateView(theme);
    this.state = state;
    this.canvas = new PaintedCanvas(parent, theme, this::paint);
  }

  @Override
  public Control control() {
    return canvas;
  }

  void refresh() {
    canvas.requestPaint();
  }

  private void paint(GC gc, Rectangle area) {
    TripViewState now = state.get();
    if (StateView.showsContent(now.input())) {
      gc.setAlpha(StateView.contentAlpha(now.input()));
      int top = area.y + 2 * LINE;
      for (TripMeter.Trip trip : now.trips()) {
        paint(gc, new Rectangle(area.x + Theme.EDGE, top, area.width - 2 * Theme.EDGE, LINE), trip, now.role(trip));
        top += LINE;
      }
      gc.setAlpha(255);
    }
    states.paint(gc, area, now.input());
  }

  private void paint(GC gc, Rectangle row, TripMeter.Trip trip, Role role) {
    String figure = Figures.of(trip.metres(), 1, "m");
    gc.setFont(theme.font(Face.BODY_STRONG));
    int width = gc.textExtent(figure).x;
    gc.setForeground(theme.color(role));
    gc.drawText(figure, row.x + row.width - width, row.y, true);
    gc.setFont(theme.font(Face.BODY));
    gc.setForeground(theme.color(Role.DIM));
    gc.drawText(TextFit.shorten(gc, trip.source().toString(), row.width - width - Theme.STEP), row.x, row.y, true);
  }
}
