package org.robotui.uic.camera.internal;

import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.ImageData;
import org.eclipse.swt.layout.FillLayout;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Display;
import org.eclipse.swt.widgets.Shell;
import org.robotui.testkit.CanvasHands;
import org.robotui.testkit.FakeUicContext;
import org.robotui.ui.PaintedCanvas;
import org.robotui.ui.Theme;
import org.robotui.ui.UiContext;

/** A window with a camera view and fakes behind it. */
final class CameraStage {
  final FakeUicContext context = new FakeUicContext("camera", new CameraType().schema());
  final CameraUic uic = new CameraUic(context);
  final Shell shell;
  private final Display display;
  private final Theme theme;
  private Composite root;
  private String note = "";

  CameraStage(Display display, Theme theme, int width, int height) {
    this.display = display;
    this.theme = theme;
    shell = new Shell(display, SWT.NO_TRIM);
    shell.setLayout(new FillLayout());
    shell.setSize(width, height);
  }

  void open() {
    uic.tick(System.nanoTime());
    root = (Composite) uic.createControl(shell, UiContext.of(theme, text -> note = text));
    shell.open();
    show();
  }

  String note() {
    return note;
  }

  PaintedCanvas canvas() {
    return (PaintedCanvas) root.getChildren()[0];
  }

  /** Ticks, and waits until that was painted. */
  void show() {
    uic.tick(System.nanoTime());
    uic.refresh();
    hands().settle();
    while (display.readAndDispatch()) {
      // Until nothing is left to do.
    }
  }

  void mouse(int type, int x, int y) {
    hands().mouse(type, 1, x, y);
    show();
  }

  void wheel(int count, int x, int y) {
    hands().wheel(count, x, y);
    show();
  }

  void key(char character) {
    hands().key(character);
    show();
  }

  ImageData picture() {
    return CanvasHands.picture(shell);
  }

  private CanvasHands hands() {
    return new CanvasHands(canvas(), canvas()::paints, canvas()::requestPaint);
  }

  void close() {
    shell.dispose();
    uic.close();
  }
}
