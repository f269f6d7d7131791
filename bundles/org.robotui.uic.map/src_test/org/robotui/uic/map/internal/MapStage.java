package org.robotui.uic.map.internal;

import java.util.Optional;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.ImageData;
import org.eclipse.swt.layout.FillLayout;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Display;
import org.eclipse.swt.widgets.Shell;
import org.robotui.testkit.CanvasHands;
import org.robotui.testkit.FakeFrames;
import org.robotui.testkit.FakeUicContext;
import org.robotui.ui.PaintedCanvas;
import org.robotui.ui.Theme;
import org.robotui.ui.UiContext;

/** A window with a map and fakes behind it. */
final class MapStage {
  final FakeUicContext context = new FakeUicContext("map", new MapType(LayerKinds.ALL).schema());
  final Shell shell;
  MapUic uic;
  private final Display display;
  private final Theme theme;
  private String note = "";
  private Optional<Control> control = Optional.empty();

  MapStage(Display display, Theme theme, int width, int height) {
    this.display = display;
    this.theme = theme;
    shell = new Shell(display, SWT.NO_TRIM);
    shell.setLayout(new FillLayout());
    shell.setSize(width, height);
    context.frames(new FakeFrames());
    replace();
  }

  /** Makes the view anew, as it keeps the frames that it was made with. */
  void replace() {
    uic = (MapUic) new MapType(LayerKinds.ALL).create(context, context.settings().current());
  }

  /** Lets the pointer rest until the view has spoken. */
  void rest() {
    boolean[] over = {false};
    display.timerExec(500, () -> over[0] = true);
    while (!over[0]) {
      if (!display.readAndDispatch()) {
        display.sleep();
      }
    }
    settle();
  }

  void open() {
    control = Optional.of(uic.createControl(shell, new TimelessWindow()));
    shell.open();
    settle();
  }

  String note() {
    return note;
  }

  PaintedCanvas canvas() {
    return canvas(control.orElseThrow());
  }

  boolean tick() {
    boolean changed = uic.tick(System.nanoTime());
    uic.refresh();
    settle();
    return changed;
  }

  void act(String id) {
    uic.actions().stream().filter(a -> a.id().equals(id)).findFirst().orElseThrow().run().run();
    settle();
  }

  void mouse(int type, int button, int x, int y) {
    hands().mouse(type, button, x, y);
  }

  void wheel(int count, int x, int y) {
    hands().wheel(count, x, y);
  }

  boolean checked(String id) {
    return uic.actions().stream()
        .filter(a -> a.id().equals(id))
        .anyMatch(a -> a.checked().orElseThrow().getAsBoolean());
  }

  void key(char character) {
    hands().key(character);
  }

  void settle() {
    if (control.isPresent() && !control.get().isDisposed() && shell.isVisible()) {
      hands().settle();
    }
  }

  ImageData picture() {
    settle();
    return CanvasHands.picture(canvas());
  }

  private CanvasHands hands() {
    return new CanvasHands(canvas(), canvas()::paints, canvas()::requestPaint);
  }

  void close() {
    shell.dispose();
    uic.close();
  }

  /**
   * A window whose clock stands still: however slow the machine is, no map is so late that it would be painted in
   * turns.
   */
  private final class TimelessWindow implements UiContext {
    @Override
    public Theme theme() {
      return theme;
    }

    @Override
    public void note(String text) {
      note = text;
    }

    @Override
    public long nanos() {
      return 0;
    }
  }

  /** The map itself, beside the list of layers. */
  private static PaintedCanvas canvas(Control control) {
    for (Control child : ((Composite) control).getChildren()) {
      if (child instanceof PaintedCanvas map) {
        return map;
      }
    }
    throw new IllegalStateException("no map in " + control);
  }
}
