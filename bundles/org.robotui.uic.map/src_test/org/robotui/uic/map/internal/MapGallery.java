package org.robotui.uic.map.internal;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.ImageData;
import org.eclipse.swt.graphics.ImageLoader;
import org.eclipse.swt.widgets.Display;
import org.robotui.api.port.InputState;
import org.robotui.data.array.Doubles;
import org.robotui.data.navigation.GridMap;
import org.robotui.data.navigation.Odometry;
import org.robotui.data.navigation.PoseEstimate;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.testkit.FakeAuthority;
import org.robotui.testkit.FakeFrames;
import org.robotui.ui.Theme;
import org.robotui.ui.Themes;

/** Paints the map in all its states into files, for people to look at: {@code MapGallery FOLDER SHARED}. */
final class MapGallery {
  private final Display display;
  private final Theme theme;
  private final Path folder;
  private final Path shared;

  private MapGallery(Display display, Theme theme, Path folder, Path shared) {
    this.display = display;
    this.theme = theme;
    this.folder = folder;
    this.shared = shared;
  }

  public static void main(String[] arguments) throws IOException {
    Display display = new Display();
    Files.createDirectories(Path.of(arguments[0]));
    for (String id : Themes.ids()) {
      Theme theme = Themes.of(display, id);
      new MapGallery(display, theme, Path.of(arguments[0]), Path.of(arguments[1])).paintAll();
      theme.dispose();
    }
    display.dispose();
  }

  private void paintAll() throws IOException {
    live();
    colored();
    stale();
    states();
    tools();
    drive();
    real("sena_loop", 0.1, RigidTransform.planar(-35.223296, -43.536954, 0));
    real("depot", 0.05, RigidTransform.planar(-7.14, -7.83, 0.4));
  }

  private MapStage stage(int width, int height) {
    return new MapStage(display, theme, width, height);
  }

  private MapStage room() {
    MapStage stage = stage(880, 560);
    DemoRoom.fill(stage.context, System.nanoTime());
    stage.replace();
    stage.open();
    for (Odometry o : DemoRoom.drive()) {
      stage.context.input(MapPorts.ODOM).put(DemoRoom.source("odom"), o, System.nanoTime(), Optional.empty());
      stage.uic.tick(System.nanoTime());
    }
    stage.tick();
    return stage;
  }

  private void live() throws IOException {
    MapStage stage = room();
    stage.mouse(SWT.MouseMove, 0, 300, 400);
    save(stage, "live");
    long worst = 0;
    for (int i = 0; i < 40; i++) {
      stage.tick();
      worst = Math.max(worst, stage.canvas().paintNanos());
    }
    Files.writeString(folder.resolve("timing-" + theme.id() + ".txt"), worst * 1e-6 + " ms worst of 40 paints\n");
    stage.close();
  }

  /** The trail coloured by how fast the robot turned, and one whose value is not there. */
  private void colored() throws IOException {
    for (String field : List.of("base.odom:angular.z", "base.odom:angular.w")) {
      MapStage stage = stage(880, 560);
      stage.context.settings().set("layers", List.of(Map.of("type", "trail", "source", "base/odom", "settings",
          Map.of("color_by", field))));
      DemoRoom.fill(stage.context, System.nanoTime());
      stage.replace();
      stage.open();
      int i = 0;
      for (Odometry o : DemoRoom.drive()) {
        Odometry turning = new Odometry(o.frame(), o.childFrame(), o.pose(), o.poseCovariance(), o.linear(),
            new Vector3(0, 0, Math.sin(i++ * 0.06)), o.twistCovariance());
        stage.context.input(MapPorts.ODOM).put(DemoRoom.source("odom"), turning, System.nanoTime(), Optional.empty());
        stage.uic.tick(System.nanoTime());
      }
      stage.tick();
      save(stage, field.endsWith("z") ? "colored" : "colored-without");
      stage.close();
    }
  }

  private void stale() throws IOException {
    MapStage stage = room();
    stage.context.input(MapPorts.SCAN).state(DemoRoom.source("scan"), new InputState.Stale(2.1, "no data"));
    stage.context.input(MapPorts.ODOM).state(DemoRoom.source("odom"), new InputState.Stale(3.4, "no data"));
    stage.tick();
    save(stage, "stale");
    stage.close();
  }

  private void states() throws IOException {
    MapStage empty = stage(600, 300);
    empty.open();
    empty.tick();
    save(empty, "empty");
    empty.context.input(MapPorts.SCAN)
        .state(new InputState.Waiting("Connected to base.scan; nothing came yet. Is the laser on?"));
    empty.tick();
    save(empty, "waiting");
    empty.context.input(MapPorts.SCAN)
        .state(new InputState.Failed("/scan: the publisher closed the connection (md5 differs)"));
    empty.tick();
    save(empty, "failed");
    empty.close();
    MapStage unplaced = stage(600, 300);
    FakeFrames frames = new FakeFrames();
    frames.fix(DemoRoom.ODOM, DemoRoom.BASE, RigidTransform.IDENTITY);
    unplaced.context.frames(frames);
    unplaced.replace();
    unplaced.context.input(MapPorts.SCAN)
        .put(DemoRoom.source("scan"), DemoRoom.scan(), System.nanoTime(), Optional.empty());
    unplaced.open();
    unplaced.tick();
    save(unplaced, "unplaced");
    unplaced.close();
  }

  private void tools() throws IOException {
    MapStage stage = room();
    stage.act("measure");
    stage.mouse(SWT.MouseDown, 1, 200, 180);
    stage.mouse(SWT.MouseMove, 0, 420, 300);
    stage.mouse(SWT.MouseUp, 1, 420, 300);
    save(stage, "measure");
    stage.act("goal");
    stage.mouse(SWT.MouseDown, 1, 300, 400);
    stage.mouse(SWT.MouseMove, 0, 360, 350);
    save(stage, "goal");
    stage.context.authority().take(FakeAuthority.ANNA, true);
    stage.mouse(SWT.MouseUp, 1, 360, 350);
    save(stage, "refused");
    double[] c = new double[36];
    c[0] = 0.09;
    c[7] = 0.04;
    c[1] = 0.02;
    c[35] = 0.01;
    stage.context.input(MapPorts.POSE).put(DemoRoom.source("amcl_pose"), new PoseEstimate(DemoRoom.MAP,
        DemoRoom.ROBOT_AT.times(RigidTransform.planar(0.2, 0.1, 0.05)), Doubles.wrap(c)), System.nanoTime(),
        Optional.empty());
    stage.key((char) 27);
    stage.context.settings().set(MapOptions.FOLLOW, true);
    stage.context.settings().set(MapOptions.SHOW_UNCERTAINTY, true);
    stage.tick();
    stage.key('+');
    stage.key('+');
    stage.key('+');
    stage.mouse(SWT.MouseMove, 0, 440, 282);
    stage.rest();
    save(stage, "close");
    stage.close();
  }

  private void real(String name, double resolution, RigidTransform origin) throws IOException {
    Path file = shared.resolve("data/maps/" + name + ".pgm");
    MapStage stage = stage(880, 560);
    GridMap map = MapFiles.pgm(file, resolution, origin, DemoRoom.MAP);
    stage.context.input(MapPorts.MAP).put(DemoRoom.source("map"), map, System.nanoTime(), Optional.empty());
    stage.open();
    for (int i = 0; i < 5; i++) {
      stage.tick();
    }
    save(stage, name);
    stage.close();
  }

  private void drive() throws IOException {
    MapStage stage = stage(880, 560);
    Path maps = shared.resolve("data/maps/sena_loop.pgm");
    GridMap map = MapFiles.pgm(maps, 0.1, RigidTransform.planar(-35.223296, -43.536954, 0), DemoRoom.MAP);
    FakeFrames frames = new FakeFrames();
    frames.fix(DemoRoom.MAP, DemoRoom.ODOM, RigidTransform.IDENTITY);
    frames.fix(DemoRoom.BASE, DemoRoom.LASER, RigidTransform.planar(0.78, 0, 0));
    stage.context.frames(frames);
    stage.replace();
    stage.context.input(MapPorts.MAP).put(DemoRoom.source("map"), map, System.nanoTime(), Optional.empty());
    stage.open();
    for (SenaDrive.Entry entry : SenaDrive.read(shared.resolve("data/bags/sena_loop.bag")).subList(0, 120)) {
      frames.fix(DemoRoom.ODOM, DemoRoom.BASE, entry.odomFromBase());
      stage.context.input(MapPorts.ODOM)
          .put(DemoRoom.source("odom"), DemoRoom.odometry(entry.odomFromBase()), System.nanoTime(), Optional.empty());
      stage.context.input(MapPorts.SCAN)
          .put(DemoRoom.source("scan"), entry.scan(), System.nanoTime(), Optional.empty());
      stage.uic.tick(System.nanoTime());
    }
    stage.context.settings().set("trail_length", 200.0);
    stage.tick();
    stage.tick();
    save(stage, "drive");
    stage.close();
  }

  private void save(MapStage stage, String name) throws IOException {
    ImageData data = stage.picture();
    ImageLoader loader = new ImageLoader();
    loader.data = List.of(data).toArray(ImageData[]::new);
    loader.save(folder.resolve(name + "-" + theme.id() + ".png").toString(), SWT.IMAGE_PNG);
  }
}
