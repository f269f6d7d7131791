package org.robotui.uic.scene3d.internal;

import java.io.IOException;
import java.lang.reflect.Constructor;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.ImageData;
import org.eclipse.swt.graphics.ImageLoader;
import org.eclipse.swt.widgets.Display;
import org.robotui.api.port.Input;
import org.robotui.api.port.SourceId;
import org.robotui.data.Data;
import org.robotui.data.DataType;
import org.robotui.gl.display.DisplayType;
import org.robotui.gl.render.Gl;
import org.robotui.gl.render.OpenGl;
import org.robotui.ui.Theme;
import org.robotui.ui.Themes;

/**
 * Paints the scene in its states into files, for people to look at: {@code SceneGallery FOLDER POINTS DISPLAYTYPE...},
 * class names.
 */
final class SceneGallery {
  private final Display display;
  private final Theme theme;
  private final Path folder;
  private final List<DisplayType> kinds;
  private final int points;

  private SceneGallery(Display display, Theme theme, Path folder, List<DisplayType> kinds, int points) {
    this.display = display;
    this.theme = theme;
    this.folder = folder;
    this.kinds = kinds;
    this.points = points;
  }

  public static void main(String[] arguments) throws IOException, ReflectiveOperationException {
    Display display = new Display();
    Path folder = Files.createDirectories(Path.of(arguments[0]));
    List<DisplayType> kinds = new ArrayList<>();
    for (String name : List.of(arguments).subList(2, arguments.length)) {
      Constructor<?> maker = Class.forName(name).getDeclaredConstructor();
      maker.setAccessible(true);
      kinds.add((DisplayType) maker.newInstance());
    }
    try (OpenGl gl = new OpenGl()) {
      for (String id : Themes.ids()) {
        Theme theme = Themes.of(display, id);
        new SceneGallery(display, theme, folder, kinds, Integer.parseInt(arguments[1])).paintAll(gl);
        theme.dispose();
      }
    }
    display.dispose();
  }

  private void paintAll(Gl gl) throws IOException {
    SceneWindow window = new SceneWindow(display, theme, 1000, 640, kinds, () -> Optional.of(gl));
    save(window, "loading");
    GalleryData.frames(window.frames);
    settle(window, 40);
    save(window, "nothing");
    Map<SourceId, Data> data = GalleryData.all(points);
    window.context.input(ScenePorts.DATA).candidates(
        data.entrySet().stream().map(e -> new Input.Candidate(e.getKey(), DataType.of(e.getValue().getClass()).name()))
            .toList());
    settle(window, 5);
    data.forEach((source, value) -> window.context.input(ScenePorts.DATA).put(source, value, System.nanoTime(),
        Optional.empty()));
    settle(window, 150);
    save(window, "live");
    window.choose(0);
    settle(window, 10);
    window.hands().mouse(SWT.MouseDown, 1, 330, 400);
    window.hands().mouse(SWT.MouseUp, 1, 330, 400);
    settle(window, 60);
    save(window, "selected");
    window.hands().key('m');
    click(window, 200, 250);
    click(window, 500, 380);
    settle(window, 30);
    save(window, "measured");
    window.hands().key((char) SWT.ESC);
    window.hands().key('3');
    settle(window, 60);
    save(window, "top");
    figures(window);
    window.close();
    SceneWindow none = new SceneWindow(display, theme, 700, 400, kinds, Optional::empty);
    settle(none, 10);
    save(none, "unavailable");
    none.close();
  }

  private static void click(SceneWindow window, int x, int y) {
    window.hands().mouse(SWT.MouseDown, 1, x, y);
    window.hands().mouse(SWT.MouseUp, 1, x, y);
    settle(window, 20);
  }

  /** How long paints take, and pictures a second while the camera is dragged. */
  private void figures(SceneWindow window) throws IOException {
    window.hands().key('1');
    window.hands().mouse(SWT.MouseDown, 1, 300, 300);
    List<Long> paints = new ArrayList<>();
    for (int i = 0; i < 120; i++) {
      window.hands().mouse(SWT.MouseMove, 0, 300 + i % 60 * 3, 300);
      settle(window, 1);
      paints.add(window.canvas().paintNanos());
    }
    String words = window.note() + "; half of all paints take at most "
        + paints.stream().sorted().toList().get(paints.size() / 2) * 1e-6 + " ms\n";
    save(window, "dragged");
    window.hands().mouse(SWT.MouseUp, 1, 300, 300);
    Files.writeString(folder.resolve("figures-" + theme.id() + ".txt"), words);
  }

  private static void settle(SceneWindow window, int ticks) {
    for (int i = 0; i < ticks; i++) {
      boolean[] over = new boolean[1];
      window.shell.getDisplay().timerExec(20, () -> over[0] = true);
      while (!over[0]) {
        if (!window.shell.getDisplay().readAndDispatch()) {
          window.shell.getDisplay().sleep();
        }
      }
      window.tick();
    }
  }

  private void save(SceneWindow window, String name) {
    ImageLoader loader = new ImageLoader();
    loader.data = new ImageData[]{window.picture()};
    int zoom = display.getPrimaryMonitor().getZoom();
    loader.save(folder.resolve(name + "-" + theme.id() + "-" + zoom + ".png").toString(), SWT.IMAGE_PNG);
  }
}
