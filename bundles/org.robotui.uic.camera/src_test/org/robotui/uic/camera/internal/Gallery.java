package org.robotui.uic.camera.internal;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Consumer;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.ImageData;
import org.eclipse.swt.graphics.ImageLoader;
import org.eclipse.swt.widgets.Display;
import org.robotui.api.host.Match;
import org.robotui.api.host.MatchState;
import org.robotui.api.host.RuicSnapshot;
import org.robotui.api.port.Arity;
import org.robotui.api.port.InputState;
import org.robotui.api.port.PortKind;
import org.robotui.api.port.SourceId;
import org.robotui.data.FrameId;
import org.robotui.data.array.Bytes;
import org.robotui.data.image.CompressedImage;
import org.robotui.data.image.Image;
import org.robotui.data.image.PixelEncoding;
import org.robotui.testkit.FakeUicContext;
import org.robotui.testkit.Pictures;
import org.robotui.ui.Theme;
import org.robotui.ui.Themes;

/** Paints the view in all its states into files, for people to look at: {@code Gallery FOLDER [FILE.jpg]}. */
final class Gallery {
  private final Display display;
  private final Theme theme;
  private final Path folder;

  private Gallery(Display display, Theme theme, Path folder) {
    this.display = display;
    this.theme = theme;
    this.folder = folder;
  }

  public static void main(String[] arguments) throws IOException {
    Display display = new Display();
    Files.createDirectories(Path.of(arguments[0]));
    for (String id : Themes.ids()) {
      Theme theme = Themes.of(display, id);
      Gallery gallery = new Gallery(display, theme, Path.of(arguments[0]));
      gallery.states();
      gallery.depth();
      if (arguments.length > 1) {
        gallery.real(Files.readAllBytes(Path.of(arguments[1])));
      }
      theme.dispose();
    }
    display.dispose();
  }

  private void states() throws IOException {
    picture("live", 528, 328, c -> put(c, Pictures.room(320, 240)), s -> {});
    picture("stale", 528, 328, c -> {
      put(c, Pictures.room(320, 240));
      c.input(CameraType.IMAGE).state(new InputState.Stale(2.1, "the link is lost"));
    }, s -> s.mouse(SWT.MouseMove, 300, 150));
    picture("ambiguous", 528, 328, Gallery::ambiguous, s -> {});
    picture("empty", 528, 328, c -> {}, s -> {});
    picture("waiting", 528, 328, c -> c.input(CameraType.IMAGE).state(
        new InputState.Waiting("/camera/image_raw has a publisher, no picture came yet")), s -> {});
    picture("broken", 528, 328,
        c -> put(c, new CompressedImage(new FrameId("Keira", "camera"), "jpeg", Bytes.of(new byte[3]))), s -> {});
    picture("near", 528, 328, c -> put(c, Pictures.room(64, 48)), s -> {
      for (int i = 0; i < 6; i++) {
        s.wheel(3, 330, 90);
      }
      s.mouse(SWT.MouseMove, 330, 90);
    });
    picture("narrow", 260, 200, c -> put(c, Scenes.depth(PixelEncoding.U16C1, 320, 240)),
        s -> s.mouse(SWT.MouseMove, 130, 150));
  }

  private void depth() throws IOException {
    picture("depth", 700, 440, c -> put(c, Scenes.depth(PixelEncoding.U16C1, 640, 400)),
        s -> s.mouse(SWT.MouseMove, 410, 270));
    picture("viridis", 700, 440, c -> {
      put(c, Scenes.depth(PixelEncoding.F32C1, 640, 400));
      c.settings().set(CameraOptions.DETAILS, true);
    }, s -> {
      s.key('c');
      s.key('r');
      s.mouse(SWT.MouseMove, 640, 27);
    });
    picture("grey", 700, 440, c -> {
      put(c, Scenes.depth(PixelEncoding.F32C1, 640, 400));
      c.settings().set(CameraOptions.COLOR_MAP, "grey");
      c.settings().set(CameraOptions.ZOOM, "actual");
    }, s -> {});
    CameraStage speed = new CameraStage(display, theme, 700, 440);
    speed.open();
    StringBuilder times = new StringBuilder();
    for (int i = 0; i < 60; i++) {
      put(speed.context, Scenes.depth(PixelEncoding.U16C1, 1280, 720));
      long start = System.nanoTime();
      speed.uic.tick(start);
      double ticked = (System.nanoTime() - start) * 1e-6;
      speed.show();
      times.append(
          String.format(Locale.ROOT, "tick %.1f ms, paint %.1f ms%n", ticked, speed.canvas().paintNanos() * 1e-6));
    }
    Files.writeString(folder.resolve("timing-" + theme.id() + ".txt"), times);
    speed.close();
  }

  private void real(byte[] file) throws IOException {
    picture("jpeg", 800, 600,
        c -> put(c, new CompressedImage(new FrameId("Keira", "left_optical"), "jpeg", Bytes.of(file))),
        s -> s.mouse(SWT.MouseMove, 400, 300));
    picture("bayer", 800, 600, c -> put(c, Scenes.bayer(file)), s -> s.mouse(SWT.MouseMove, 400, 300));
    picture("bayer-near", 800, 600, c -> put(c, Scenes.bayer(file)), s -> {
      for (int i = 0; i < 11; i++) {
        s.wheel(3, 400, 300);
      }
      s.mouse(SWT.MouseMove, 400, 300);
    });
  }

  private static void put(FakeUicContext context, Image image) {
    context.input(CameraType.IMAGE).put(image);
  }

  private static void ambiguous(FakeUicContext context) {
    RuicSnapshot now = context.ruic().snapshot();
    Match match =
        new Match(new SourceId("camera", "image"), PortKind.STREAM, "Image", Arity.ONE, MatchState.AMBIGUOUS, List.of(),
            List.of(new SourceId("ros", "/camera/left/image_raw"),
                new SourceId("ros", "/camera/right/image_raw/compressed"),
                new SourceId("player", "camera")),
            "camera needs one Image, three are offered");
    context.ruic().snapshot(
        new RuicSnapshot(now.name(), now.state(), now.reason(), now.link(), now.components(), now.ports(),
            List.of(match)));
    context.input(CameraType.IMAGE).state(new InputState.Unconnected("camera needs one Image, three are offered"));
  }

  private void picture(String name, int width, int height, Consumer<FakeUicContext> prepare, Consumer<CameraStage> act)
      throws IOException {
    CameraStage stage = new CameraStage(display, theme, width, height);
    prepare.accept(stage.context);
    stage.open();
    act.accept(stage);
    stage.show();
    stage.show();
    Optional<ImageData> data = Optional.of(stage.picture());
    ImageLoader loader = new ImageLoader();
    loader.data = new ImageData[]{data.get()};
    loader.save(folder.resolve(name + "-" + theme.id() + ".png").toString(), SWT.IMAGE_PNG);
    stage.close();
  }
}
