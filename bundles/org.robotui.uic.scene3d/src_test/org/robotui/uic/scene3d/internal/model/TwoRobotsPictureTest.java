package org.robotui.uic.scene3d.internal.model;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIf;
import org.robotui.api.command.CommandOutcome;
import org.robotui.api.port.Input;
import org.robotui.api.port.SourceId;
import org.robotui.data.Data;
import org.robotui.data.FrameId;
import org.robotui.data.array.Floats;
import org.robotui.data.joint.RobotDescription;
import org.robotui.data.sensor.LaserScan;
import org.robotui.entity.grid.internal.display.GridType;
import org.robotui.entity.laserscan.internal.display.LaserScanType;
import org.robotui.entity.robotmodel.internal.ModelShelf;
import org.robotui.entity.robotmodel.internal.RobotModelType;
import org.robotui.geometry.Quaternion;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.gl.display.DisplayContext;
import org.robotui.gl.display.DisplayType;
import org.robotui.gl.render.RenderRequest;
import org.robotui.gl.shape.Part;
import org.robotui.testkit.Displays;
import org.robotui.testkit.FakeAuthority;
import org.robotui.testkit.FakeFrames;
import org.robotui.testkit.FakeInput;
import org.robotui.testkit.FakeUicContext;
import org.robotui.testkit.ScenePictures;
import org.robotui.ui.scene.Commander;
import org.robotui.uic.scene3d.internal.SceneOptions;
import org.robotui.uic.scene3d.internal.ScenePorts;
import org.robotui.uic.scene3d.internal.waypoint.Tour;
import org.robotui.uic.scene3d.internal.waypoint.Waypoints;

/** Two robots behind interfaces of two frameworks, whose maps only the configuration joins, in one scene. */
@EnabledIf(value = Displays.AVAILABLE, disabledReason = Displays.REASON)
class TwoRobotsPictureTest {
  private static final String ROUND = """
      <robot name="round"><link name="base_link">
        <visual><origin xyz="0 0 0.2"/><geometry><cylinder radius="0.4" length="0.4"/></geometry></visual>
        <visual><origin xyz="0.3 0 0.5"/><geometry><sphere radius="0.12"/></geometry></visual></link></robot>
      """;
  private static final String SQUARE = """
      <robot name="square"><link name="base_link">
        <visual><origin xyz="0 0 0.2"/><geometry><box size="1 0.6 0.4"/></geometry></visual>
        <visual><origin xyz="0.3 0 0.5"/><geometry><box size="0.2 0.2 0.2"/></geometry></visual></link></robot>
      """;
  private static final int BEAMS = 41;

  private final FakeUicContext context = new FakeUicContext("scene", SceneOptions.schema());
  private final FakeFrames frames = new FakeFrames();
  private final FakeInput<Data> input = context.input(ScenePorts.DATA);
  private final List<DisplayType> kinds =
      List.of(new GridType(), new RobotModelType(new ModelShelf()), new LaserScanType());
  private final SceneModel model = made();

  private SceneModel made() {
    context.frames(frames);
    Map<String, FakeAuthority> team = new LinkedHashMap<>();
    team.put("ros", new FakeAuthority("Natalie"));
    team.put("player", new FakeAuthority("Keira"));
    context.ruic().team(team);
    DisplayContext displays = new DisplayContext() {
      @Override
      public Executor background() {
        return Runnable::run;
      }

      @Override
      public void wake() {
        // Each tick is made by hand.
      }

      @Override
      public CommandOutcome send(Data command) {
        throw new AssertionError("nothing is sent");
      }
    };
    Tour tour = new Tour(new Commander(context, ScenePorts.GOAL, ScenePorts.INITIAL_POSE),
        context.output(ScenePorts.GOAL), context.principal(), told -> {});
    return new SceneModel(context, () -> kinds, displays, new Waypoints(context.settings(), tour));
  }

  /** A robot with a scan of a wall ahead of it, all in frames of the same names as those of the other. */
  private void robot(String robot, String component, String urdf, RigidTransform mapFromBase) {
    FrameId base = new FrameId(robot, "base_link");
    frames.fix(new FrameId(robot, "map"), base, mapFromBase);
    frames.fix(base, new FrameId(robot, "laser"), new RigidTransform(new Vector3(0.3, 0, 0.3), Quaternion.IDENTITY));
    input.put(new SourceId(component, "/robot_description"),
        new RobotDescription(robot, "robot_description", urdf, "", List.of()), System.nanoTime(), Optional.empty());
    double step = Math.toRadians(2);
    float[] ranges = new float[BEAMS];
    IntStream.range(0, BEAMS).forEach(i -> ranges[i] = (float) (1.5 / Math.cos((i - BEAMS / 2) * step)));
    input.put(new SourceId(component, "/scan"),
        new LaserScan(new FrameId(robot, "laser"), -BEAMS / 2 * step, step, 0.1, 10, 0.1, Floats.of(ranges),
            Floats.EMPTY),
        System.nanoTime(), Optional.empty());
  }

  private static Map<String, Object> display(String type, String source, Map<String, Object> settings) {
    return Map.of("type", type, "source", source, "settings", settings);
  }

  @Test
  void eachHasItsColourAndItsNameAndStandsWhereTheConfigurationSays() {
    context.settings().set(SceneOptions.FIXED_FRAME, "Natalie/map");
    context.settings().set(SceneOptions.COLORS, Map.of("Keira", "#40c060"));
    context.settings().set(SceneOptions.FRAMES,
        List.of(Map.of("parent", "Natalie/map", "child", "Keira/map", "y", 2.0, "yaw", Math.PI / 2)));
    context.settings().set(SceneOptions.DISPLAYS, List.of(Map.of("type", "grid", "settings", Map.of("cells", 6L)),
        display("robotmodel", "ros/robot_description", Map.of("color", "robot")),
        display("robotmodel", "player/robot_description", Map.of("color", "robot")),
        display("laserscan", "ros/scan", Map.of()), display("laserscan", "player/scan", Map.of("color", "#ffd75e"))));
    input.candidates(List.of("ros", "player").stream().flatMap(component -> List.of(
        new Input.Candidate(new SourceId(component, "/robot_description"), "RobotDescription"),
        new Input.Candidate(new SourceId(component, "/scan"), "LaserScan")).stream()).toList());
    model.tick(System.nanoTime());
    robot("Natalie", "ros", ROUND, RigidTransform.planar(0, -0.8, 0));
    robot("Keira", "player", SQUARE, RigidTransform.planar(-0.6, 0, 0));
    model.tick(System.nanoTime());
    model.tick(System.nanoTime());
    Stage stage = model.stage();
    assertEquals(List.of("Keira", "Natalie"), stage.robots().stream().map(Stage.Robot::name).sorted().toList());
    Vector3 keira = stage.robots().stream().filter(r -> r.name().equals("Keira")).findFirst()
        .flatMap(Stage.Robot::fixedFromBase).orElseThrow().translation();
    assertEquals(0, keira.minus(new Vector3(0, 1.4, 0)).norm(), 1e-9, keira.toString());
    Map<Object, List<Part>> parts = new LinkedHashMap<>(stage.parts());
    parts.put("axes", ScenePictures.withAxes(List.of(), 0.5));
    try (ScenePictures pictures = new ScenePictures()) {
      pictures.assertLike(TwoRobotsPictureTest.class, "two-robots", new RenderRequest(parts,
          ScenePictures.eye(new Vector3(-3, 0.6, 2.6), new Vector3(0.4, 0.6, 0.2)), ScenePictures.WIDTH,
          ScenePictures.HEIGHT, 1, ScenePictures.DARK,
          Integer.MAX_VALUE, List.of()));
    }
  }
}
