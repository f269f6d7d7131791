package org.robotui.uic.body.internal;

import java.util.Optional;
import java.util.function.Consumer;
import org.eclipse.swt.SWT;
import org.eclipse.swt.widgets.Canvas;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Display;
import org.eclipse.swt.widgets.Event;
import org.robotui.api.port.InputState;
import org.robotui.api.port.SourceId;
import org.robotui.testkit.FakeUicContext;
import org.robotui.testkit.GalleryWindow;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.Themes;
import org.robotui.ui.UiContext;
import org.robotui.uic.body.internal.model.Bodies;

/** Shows the view in all its states side by side, for a person to look at: {@code Gallery dark|light}. */
record Gallery(GalleryWindow window, Theme theme) {
  private static final SourceId BOAT = new SourceId("boat", "body");
  private static final long SECOND = 1_000_000_000L;
  private static final int SAID = 100;

  public static void main(String[] arguments) {
    GalleryWindow.show(display -> Themes.of(display, arguments[0]), theme -> theme.color(Role.LINE),
        (window, theme) -> new Gallery(window, theme).fill());
  }

  private void fill() {
    cell(0, 0, 980, 480, true, c -> {});
    press(0, 120, 36, SWT.MouseDoubleClick);
    Display.getCurrent().timerExec(1500, () -> press(0, 120, 62, SWT.MouseDown)); // when it is open
    cell(986, 0, 614, 240, false, c -> c.input(BodyType.BODY).state(
        new InputState.Unconnected("body needs BodyState; base offers none.")));
    cell(986, 246, 614, 234, false, c -> c.input(BodyType.BODY).state(
        new InputState.Waiting("boat/body is there, nothing came yet")));
    cell(0, 486, 620, 514, true, c -> c.input(BodyType.BODY).state(new InputState.Stale(12.3, "the link is lost")));
    press(3, 120, 88, SWT.MouseDown);
    cell(626, 486, 480, 250, true, c -> {});
    cell(1112, 486, 220, 514, true, c -> {});
  }

  private void press(int part, int x, int y, int type) {
    Control list = tree(window.made(part)).orElseThrow();
    Event down = new Event();
    down.button = 1;
    down.x = x;
    down.y = y;
    list.notifyListeners(SWT.MouseDown, down);
    if (type != SWT.MouseDown) {
      list.notifyListeners(type, down);
    }
  }

  /** The tree is the first that has a scroll bar. */
  private static Optional<Control> tree(Control control) {
    if (control instanceof Canvas && (control.getStyle() & SWT.V_SCROLL) != 0) {
      return Optional.of(control);
    }
    if (control instanceof Composite composite) {
      for (Control child : composite.getChildren()) {
        Optional<Control> found = tree(child);
        if (found.isPresent()) {
          return found;
        }
      }
    }
    return Optional.empty();
  }

  private void cell(int x, int y, int width, int height, boolean live, Consumer<FakeUicContext> last) {
    FakeUicContext context = new FakeUicContext("body", new BodyType().schema());
    Composite part = window.cell(x, y, width, height);
    BodyUic uic = new BodyUic(context);
    long now = System.nanoTime();
    for (int ago = SAID; live && ago > 0; ago--) {
      context.input(BodyType.BODY).put(BOAT, Bodies.boat(180 + 40 * Math.sin(ago / 9.0), ago < 30),
          now - ago * SECOND / 5,
          Optional.empty());
      uic.tick(now - ago * SECOND / 5);
    }
    last.accept(context);
    uic.tick(now);
    uic.createControl(part, UiContext.of(theme, part::setData));
    part.layout(true, true);
    uic.refresh();
    later(uic, x, now);
  }

  private static void later(BodyUic uic, int x, long now) {
    for (int after : new int[]{600, 2500}) {
      Display.getCurrent().timerExec(after + x, () -> {
        uic.tick(now);
        uic.refresh();
      });
    }
  }
}
