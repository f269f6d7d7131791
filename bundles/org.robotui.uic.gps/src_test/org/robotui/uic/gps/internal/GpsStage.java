package org.robotui.uic.gps.internal;

import java.util.Optional;
import java.util.stream.Stream;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.ImageData;
import org.eclipse.swt.layout.FillLayout;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Display;
import org.eclipse.swt.widgets.Shell;
import org.robotui.api.port.SourceId;
import org.robotui.data.FrameId;
import org.robotui.data.sensor.GpsFix;
import org.robotui.testkit.CanvasHands;
import org.robotui.testkit.FakeUicContext;
import org.robotui.ui.PaintedCanvas;
import org.robotui.ui.Theme;
import org.robotui.ui.UiContext;

/** A window with a GPS view and fakes behind it. */
final class GpsStage {
  final FakeUicContext context = new FakeUicContext("gps", new GpsType(LayerKinds.ALL).schema());
  final GpsUic uic = new GpsUic(context, () -> LayerKinds.ALL);
  final Shell shell;
  private final Theme theme;
  private Optional<PaintedCanvas> canvas = Optional.empty();
  private String note = "";

  GpsStage(Display display, Theme theme, int width, int height) {
    this.theme = theme;
    shell = new Shell(display, SWT.NO_TRIM);
    shell.setLayout(new FillLayout());
    shell.setSize(width, height);
  }

  static GpsFix fix(String robot, GpsFix.Quality quality, double latitude, double longitude, double accuracy) {
    return new GpsFix(new FrameId(robot, "gps"), quality, Math.toRadians(latitude), Math.toRadians(longitude), 7.3,
        accuracy);
  }

  void put(String component, GpsFix fix) {
    context.input(GpsType.FIX).put(new SourceId(component, "fix"), fix, System.nanoTime(), Optional.empty());
    uic.tick(System.nanoTime());
  }

  void open() {
    canvas = Stream.of(((Composite) uic.createControl(shell, UiContext.of(theme, text -> note = text))).getChildren())
        .filter(PaintedCanvas.class::isInstance).map(PaintedCanvas.class::cast).findFirst();
    shell.open();
    tick();
  }

  String note() {
    return note;
  }

  PaintedCanvas canvas() {
    return canvas.orElseThrow();
  }

  void tick() {
    uic.tick(System.nanoTime());
    uic.refresh();
    settle();
  }

  void act(String id) {
    uic.actions().stream().filter(a -> a.id().equals(id)).findFirst().orElseThrow().run().run();
    settle();
  }

  void mouse(int type, int button, int x, int y) {
    hands().mouse(type, button, x, y);
  }

  void key(char character) {
    hands().key(character);
  }

  ImageData picture() {
    settle();
    return CanvasHands.picture(canvas());
  }

  void close() {
    shell.dispose();
    uic.close();
  }

  private void settle() {
    hands().settle();
  }

  private CanvasHands hands() {
    return new CanvasHands(canvas(), canvas()::paints, canvas()::requestPaint);
  }
}
