package org.robotui.uic.map.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.Color;
import org.eclipse.swt.graphics.ImageData;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.graphics.RGB;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIf;
import org.robotui.api.port.SourceId;
import org.robotui.data.FrameId;
import org.robotui.data.array.Doubles;
import org.robotui.data.array.Floats;
import org.robotui.data.navigation.Odometry;
import org.robotui.data.navigation.Path;
import org.robotui.data.sensor.LaserScan;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.testkit.Displays;
import org.robotui.testkit.FakeAuthority;
import org.robotui.testkit.FakeFrames;
import org.robotui.testkit.TestDisplay;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.Themes;

/** Two robots of different frameworks on one map, as a user compares and commands them. */
@EnabledIf(value = Displays.AVAILABLE, disabledReason = Displays.REASON)
class TeamMapSwtTest {
  private static final List<String> ROBOTS = List.of("Natalie", "Keira");
  private static final List<String> INTERFACES = List.of("ros", "player");

  private final Map<String, FakeAuthority> authorities = new LinkedHashMap<>();
  private Theme theme;
  private MapStage stage;

  @BeforeEach
  void open() {
    theme = Themes.dark(TestDisplay.get());
    stage = new MapStage(TestDisplay.get(), theme, 700, 500);
    FakeFrames frames = new FakeFrames();
    frames.fix(frame(0, "map"), frame(1, "map"), RigidTransform.planar(0, 6, 0));
    for (int i = 0; i < 2; i++) {
      authorities.put(INTERFACES.get(i), new FakeAuthority(ROBOTS.get(i)));
      frames.fix(frame(i, "map"), frame(i, "odom"), RigidTransform.IDENTITY);
      frames.fix(frame(i, "odom"), frame(i, "base_link"), RigidTransform.planar(3, 0, 0));
    }
    stage.context.frames(frames);
    stage.context.ruic().team(authorities);
    stage.context.output(MapPorts.GOALS).targets(INTERFACES.stream().map(c -> new SourceId(c, "goal")).toList());
    stage.replace();
    stage.open();
    give();
  }

  @AfterEach
  void close() {
    stage.close();
    theme.dispose();
  }

  private static FrameId frame(int robot, String name) {
    return new FrameId(ROBOTS.get(robot), name);
  }

  private void give() {
    for (int step = 0; step <= 30; step++) {
      for (int i = 0; i < 2; i++) {
        Odometry odometry = new Odometry(frame(i, "odom"), frame(i, "base_link"),
            RigidTransform.planar(step / 10.0, 0, 0), Doubles.EMPTY,
            new Vector3(0.3, 0, 0), Vector3.ZERO, Doubles.EMPTY);
        stage.context.input(MapPorts.ODOM).put(new SourceId(INTERFACES.get(i), "odom"), odometry, System.nanoTime(),
            Optional.empty());
      }
      stage.uic.tick(System.nanoTime());
    }
    for (int i = 0; i < 2; i++) {
      LaserScan scan = new LaserScan(frame(i, "base_link"), -1, 0.1, 0.05, 10, 0.1,
          Floats.wrap(new float[]{1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1}), Floats.EMPTY);
      stage.context.input(MapPorts.SCAN).put(new SourceId(INTERFACES.get(i), "scan"), scan, System.nanoTime(),
          Optional.empty());
      stage.context.input(MapPorts.PATH).put(new SourceId(INTERFACES.get(i), "plan"),
          new Path(frame(i, "map"), List.of(RigidTransform.planar(3, 0, 0), RigidTransform.planar(5, 2, 0))),
          System.nanoTime(), Optional.empty());
    }
    stage.tick();
    stage.act("fit");
    stage.tick();
  }

  private int count(ImageData picture, Color color) {
    return places(picture, color.getRGB()).size();
  }

  private static List<Point> places(ImageData picture, RGB wanted) {
    List<Point> places = new ArrayList<>();
    for (int y = 0; y < picture.height; y++) {
      for (int x = 0; x < picture.width; x++) {
        if (picture.palette.getRGB(picture.getPixel(x, y)).equals(wanted)) {
          places.add(new Point(x, y));
        }
      }
    }
    return places;
  }

  /** Where a robot is seen: the white of its arrow, of which there are two, above each other. */
  private Point robot(int number) {
    ImageData picture = stage.picture();
    List<Point> white = places(picture, new RGB(255, 255, 255));
    int middle = (white.getFirst().y + white.getLast().y) / 2;
    List<Point> own = white.stream().filter(p -> number == 0 ? p.y > middle : p.y < middle).toList();
    return own.get(own.size() / 2);
  }

  private void click(Point at) {
    stage.mouse(SWT.MouseDown, 1, at.x, at.y);
    stage.mouse(SWT.MouseUp, 1, at.x, at.y);
    stage.tick();
  }

  @Test
  void whatBothMeasureIsOverlaidInTheColourOfEach() {
    ImageData picture = stage.picture();
    for (int i = 0; i < 2; i++) {
      assertTrue(count(picture, theme.traces().get(i)) > 150, "plan, scan and legend of " + ROBOTS.get(i));
    }
    assertEquals(0, count(picture, theme.traces().get(2)));
    assertEquals(0, count(picture, theme.color(Role.LASER)), "with several robots a colour says who, not what");
    assertTrue(places(picture, theme.traces().get(0).getRGB()).stream().anyMatch(p -> p.x > 600 && p.y < 60),
        "the legend");
  }

  @Test
  void aClickSelectsARobotForAllViewsAndTheFloorNone() {
    click(robot(1));
    assertEquals(Set.of("Keira"), stage.context.ruic().selection().robots());
    assertTrue(count(stage.picture(), theme.color(Role.ACCENT)) > 20, "it is marked");
    click(new Point(30, 250));
    assertEquals(Set.of(), stage.context.ruic().selection().robots());
  }

  @Test
  void aGoalGoesToWhoIsSelectedInAFrameOfItsOwn() {
    stage.act("goal");
    stage.mouse(SWT.MouseDown, 1, 350, 250);
    stage.mouse(SWT.MouseUp, 1, 350, 250);
    assertEquals(0, stage.context.output(MapPorts.GOALS).sent().size(), "nobody is meant");
    stage.context.ruic().selection().set(Set.of("Keira"));
    stage.act("goal");
    stage.mouse(SWT.MouseDown, 1, 350, 250);
    stage.mouse(SWT.MouseUp, 1, 350, 250);
    var sent = stage.context.output(MapPorts.GOALS).sent();
    assertEquals(1, sent.size());
    assertEquals(List.of(new SourceId("player", "goal")), sent.getFirst().targets());
    assertEquals(frame(1, "map"), sent.getFirst().command().frame());
    assertEquals(Optional.empty(), authorities.get("ros").holder());
  }
}
