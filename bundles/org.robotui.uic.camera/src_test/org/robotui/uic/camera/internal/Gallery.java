package org.robotui.uic.camera.internal;

import java.util.List;
import java.util.function.Consumer;
import org.eclipse.swt.SWT;
import org.eclipse.swt.layout.FillLayout;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Display;
import org.eclipse.swt.widgets.Event;
import org.eclipse.swt.widgets.Shell;
import org.robotui.api.host.Match;
import org.robotui.api.host.MatchState;
import org.robotui.api.host.RuicSnapshot;
import org.robotui.api.port.Arity;
import org.robotui.api.port.InputState;
import org.robotui.api.port.PortKind;
import org.robotui.api.port.SourceId;
import org.robotui.data.Bytes;
import org.robotui.data.CompressedImage;
import org.robotui.data.FrameId;
import org.robotui.testkit.FakeUicContext;
import org.robotui.testkit.Pictures;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.Themes;
import org.robotui.ui.UiContext;

/** Shows the view in all its states side by side, for a person to look at: {@code Gallery dark|light}. */
final class Gallery {
  private final Shell shell;
  private final Theme theme;

  private Gallery(Shell shell, Theme theme) {
    this.shell = shell;
    this.theme = theme;
  }

  public static void main(String[] arguments) {
    Display display = new Display();
    Theme theme = Themes.of(display, arguments[0]);
    Shell shell = new Shell(display, SWT.NO_TRIM);
    shell.setBounds(0, 0, 1600, 1000);
    shell.setBackground(theme.color(Role.LINE));
    new Gallery(shell, theme).fill();
    shell.open();
    while (!shell.isDisposed()) {
      if (!display.readAndDispatch()) {
        display.sleep();
      }
    }
  }

  private void fill() {
    cell(0, 0, c -> c.input(CameraType.IMAGE).put(Pictures.room(320, 240)));
    cell(534, 0, c -> {
      c.input(CameraType.IMAGE).put(Pictures.room(320, 240));
      c.input(CameraType.IMAGE).state(new InputState.Stale(2.1, "the link is lost"));
    });
    cell(1068, 0, Gallery::ambiguous);
    cell(0, 334, c -> { });
    cell(534, 334, c -> c.input(CameraType.IMAGE).state(new InputState.Waiting("/camera/image_raw has a publisher, no picture came yet")));
    cell(1068, 334, c -> c.input(CameraType.IMAGE).put(
        new CompressedImage(new FrameId("Keira", "camera"), "jpeg", Bytes.of(new byte[3]))));
    Composite near = cell(0, 668, c -> c.input(CameraType.IMAGE).put(Pictures.room(64, 48)));
    for (int i = 0; i < 5; i++) {
      send(near, SWT.MouseVerticalWheel, 3);
    }
    send(near, SWT.MouseMove, 0);
  }

  private static void send(Composite part, int type, int count) {
    Event event = new Event();
    event.x = 330;
    event.y = 90;
    event.count = count;
    ((Composite) part.getChildren()[0]).getChildren()[0].notifyListeners(type, event);
  }

  private static void ambiguous(FakeUicContext context) {
    RuicSnapshot now = context.ruic().snapshot();
    Match match = new Match(new SourceId("camera", "image"), PortKind.STREAM, "Image", Arity.ONE, MatchState.AMBIGUOUS, List.of(),
        List.of(new SourceId("ros", "/camera/left/image_raw"), new SourceId("ros", "/camera/right/image_raw/compressed"),
            new SourceId("player", "camera")), "camera needs one Image, three are offered");
    context.ruic().snapshot(
        new RuicSnapshot(now.name(), now.state(), now.reason(), now.link(), now.components(), now.ports(), List.of(match)));
    context.input(CameraType.IMAGE).state(new InputState.Unconnected("camera needs one Image, three are offered"));
  }

  private Composite cell(int x, int y, Consumer<FakeUicContext> prepare) {
    FakeUicContext context = new FakeUicContext("camera", new CameraType().schema());
    prepare.accept(context);
    Composite part = new Composite(shell, SWT.NONE);
    part.setBounds(x, y, 528, 328);
    part.setLayout(new FillLayout());
    CameraUic uic = new CameraUic(context);
    uic.tick(System.nanoTime());
    uic.createControl(part, new UiContext() {
      @Override
      public Theme theme() {
        return theme;
      }

      @Override
      public void note(String text) {
        part.setData(text);
      }
    });
    part.layout(true, true);
    return part;
  }
}
