package org.robotui.uic.scene3d.internal;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import java.util.function.Supplier;
import org.eclipse.swt.SWT;
import org.eclipse.swt.custom.SashForm;
import org.eclipse.swt.graphics.ImageData;
import org.eclipse.swt.layout.FillLayout;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Display;
import org.eclipse.swt.widgets.Event;
import org.eclipse.swt.widgets.Shell;
import org.robotui.gl.display.DisplayType;
import org.robotui.gl.render.Gl;
import org.robotui.testkit.CanvasHands;
import org.robotui.testkit.FakeFrames;
import org.robotui.testkit.FakeUicContext;
import org.robotui.ui.PaintedCanvas;
import org.robotui.ui.Theme;
import org.robotui.ui.UiContext;

/** A scene in a window, ticked by hand. */
final class SceneWindow {
  private static final long PATIENCE_NANOS = 60_000_000_000L;

  final FakeUicContext context = new FakeUicContext("scene", SceneOptions.schema());
  final FakeFrames frames = new FakeFrames();
  final Shell shell;
  final Scene3dUic uic;
  private final Display display;
  private final Control control;
  private String note = "";

  SceneWindow(Display display, Theme theme, int width, int height, List<DisplayType> kinds, Supplier<Optional<Gl>> gl) {
    this.display = display;
    shell = new Shell(display, SWT.NO_TRIM);
    shell.setLayout(new FillLayout());
    shell.setSize(width, height);
    context.frames(frames);
    uic = new Scene3dUic(context, () -> kinds, gl);
    control = uic.createControl(shell, UiContext.of(theme, text -> note = text));
    shell.open();
  }

  String note() {
    return note;
  }

  /** The picture's canvas: the last child. */
  PaintedCanvas canvas() {
    Control[] children = ((Composite) control).getChildren();
    return (PaintedCanvas) children[children.length - 1];
  }

  private Composite tree() {
    return (Composite) ((Composite) control).getChildren()[0];
  }

  private SashForm split() {
    return (SashForm) tree().getChildren()[1];
  }

  private PaintedCanvas list() {
    return (PaintedCanvas) split().getChildren()[0];
  }

  /** Chooses a display of the list. */
  void choose(int row) {
    new CanvasHands(list(), list()::paints, list()::requestPaint).mouse(SWT.MouseDown, 1, 100, row * 40 + 20);
  }

  /** Presses the box of a display of the list. */
  void flip(int row) {
    new CanvasHands(list(), list()::paints, list()::requestPaint).mouse(SWT.MouseDown, 1, 20, row * 40 + 12);
  }

  /** Switches the display that is chosen in the list by its key. */
  void flipChosen() {
    new CanvasHands(list(), list()::paints, list()::requestPaint).key(' ');
  }

  /** Whether the settings of a display are seen below the list. */
  boolean settingsSeen() {
    return split().getMaximizedControl() == null;
  }

  /** Presses a button above the list, by its hint. */
  void press(String hint) {
    Control button = Arrays.stream(((Composite) tree().getChildren()[0]).getChildren())
        .filter(c -> hint.equals(c.getToolTipText())).findFirst().orElseThrow();
    button.notifyListeners(SWT.MouseUp, new Event());
  }

  void tick() {
    uic.tick(System.nanoTime());
    uic.refresh();
    turn();
  }

  /** Ticks until something is so. */
  boolean until(BooleanSupplier done) {
    long deadline = System.nanoTime() + PATIENCE_NANOS;
    while (!done.getAsBoolean() && System.nanoTime() < deadline) {
      tick();
    }
    return done.getAsBoolean();
  }

  void turn() {
    while (display.readAndDispatch()) {
      Thread.onSpinWait();
    }
  }

  CanvasHands hands() {
    return new CanvasHands(canvas(), canvas()::paints, canvas()::requestPaint);
  }

  void act(String id) {
    uic.actions().stream().filter(a -> a.id().equals(id)).findFirst().orElseThrow().run().run();
    turn();
  }

  ImageData picture() {
    hands().settle();
    return CanvasHands.picture(control);
  }

  void close() {
    shell.dispose();
    uic.close();
  }
}
