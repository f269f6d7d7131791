package org.robotui.message.data;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.ByteBuffer;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.robotui.data.ClockKind;
import org.robotui.data.Data;
import org.robotui.data.FrameId;
import org.robotui.data.Stamp;
import org.robotui.data.geometry.PoseArray;
import org.robotui.data.geometry.Wrench;
import org.robotui.data.joint.DisplayedTrajectory;
import org.robotui.data.joint.JointTrajectory;
import org.robotui.data.marker.InteractiveMarker.Mode;
import org.robotui.data.marker.MarkerSet;
import org.robotui.geometry.Vector3;
import org.robotui.message.DynamicCodec;
import org.robotui.message.DynamicMessage;
import org.robotui.message.MessageCodec;
import org.robotui.message.MessageException;
import org.robotui.message.MessageReader;
import org.robotui.message.MessageSchema;
import org.robotui.message.MessageWriter;
import org.robotui.message.RecordCodec;
import org.robotui.message.ros.geometry_msgs.WrenchStamped;
import org.robotui.message.ros.std_msgs.Header;
import org.robotui.message.ros.trajectory_msgs.JointTrajectoryPoint;
import org.robotui.message.ros.visualization_msgs.InteractiveMarker;
import org.robotui.message.ros.visualization_msgs.InteractiveMarkerInit;
import org.robotui.message.ros.visualization_msgs.Marker;
import org.robotui.message.ros.visualization_msgs.MarkerArray;

class MarkerAdaptersTest {
  private static final FrameNames NAMES = new FrameNames("robby", ClockKind.ROBOT);
  private static final double[] SIX = new double[18];
  private final Adapters adapters = new Adapters();

  @SuppressWarnings("unchecked") // the message is of the type that is named
  private <M> Data convert(String type, M message) {
    Adapter<M, ?> adapter = (Adapter<M, ?>) adapters.of(type);
    return adapter.convert().apply(message, NAMES).orElseThrow();
  }

  private static Marker marker(int id, int type, int action, double[] points, float[] colors) {
    return SampleMarkers.marker("things", id, type, action, points, colors);
  }

  @Test
  void aMarkerKeepsWhatItSays() {
    MarkerSet set = (MarkerSet) convert("visualization_msgs/Marker",
        marker(7, Marker.ARROW, Marker.ADD, new double[]{1, 2, 3, 4, 5, 6}, new float[0]));
    org.robotui.data.marker.Marker marker = set.entries().getFirst().marker().orElseThrow();
    assertEquals("things/7", marker.key().toString());
    assertEquals(new FrameId("robby", "map"), marker.frame());
    assertEquals(Optional.of(new Stamp(5_000_000_000L, ClockKind.ROBOT)), marker.stamp());
    assertEquals(org.robotui.data.marker.Marker.Type.ARROW, marker.type());
    assertEquals(new Vector3(1, 2, 3), marker.pose().translation());
    assertEquals(new Vector3(0.1, 0.2, 0.3), marker.scale());
    assertEquals(2_000_000_000L, marker.lifetimeNanos());
    assertEquals(6f, marker.points().get(5));
    assertTrue(marker.locked() && marker.embeddedMaterials() && marker.colors().size() == 0);
  }

  @Test
  void anArrayThatTakesAllAwayKeepsOnlyWhatFollows() {
    MarkerSet set = (MarkerSet) convert("visualization_msgs/MarkerArray", new MarkerArray(List.of(
        marker(1, 1, Marker.ADD, new double[0], new float[0]),
        marker(0, 0, Marker.DELETEALL, new double[0], new float[0]),
        marker(2, 1, Marker.ADD, new double[0], new float[0]),
        marker(3, 1, Marker.DELETE, new double[0], new float[0]))));
    assertTrue(set.all());
    assertEquals(List.of(true, false), set.entries().stream().map(e -> e.marker().isPresent()).toList());
  }

  @Test
  void coloursBelongToPointsOrToTrianglesOrCountAsNone() {
    float[] two = {1, 0, 0, 1, 0, Float.NaN, 2, 0.5f};
    MarkerSet faces = (MarkerSet) convert("visualization_msgs/Marker", marker(1, Marker.TRIANGLE_LIST, 0, SIX, two));
    org.robotui.data.array.Bytes colors = faces.entries().getFirst().marker().orElseThrow().colors();
    assertEquals(24, colors.size());
    assertEquals(List.of(255, 0, 0, 255, 255, 0, 0, 255),
        List.of(0, 1, 2, 3, 8, 9, 10, 11).stream().map(colors::unsigned).toList());
    assertEquals(List.of(0, 0, 255, 128), List.of(12, 13, 14, 15).stream().map(colors::unsigned).toList());
    MarkerSet none = (MarkerSet) convert("visualization_msgs/Marker", marker(1, Marker.POINTS, 0, SIX, two));
    assertEquals(0, none.entries().getFirst().marker().orElseThrow().colors().size());
  }

  @Test
  void whatIsNotKnownIsSaidOrShownAsUnknown() {
    MarkerSet odd =
        (MarkerSet) convert("visualization_msgs/Marker", marker(1, 99, Marker.ADD, new double[0], new float[0]));
    assertEquals(org.robotui.data.marker.Marker.Type.UNKNOWN, odd.entries().getFirst().marker().orElseThrow().type());
    Marker action = marker(1, 0, 17, new double[0], new float[0]);
    assertThrows(IllegalArgumentException.class, () -> convert("visualization_msgs/Marker", action));
  }

  @Test
  void aMarkerThatIsMovedKeepsItsControlsAndItsMenu() {
    org.robotui.data.marker.InteractiveMarker marker =
        InteractiveMarkers.marker(SampleMarkers.interactive("goal", 4), "/nav/feedback", NAMES);
    assertEquals("goal", marker.name());
    assertEquals(Mode.MOVE_AXIS, marker.controls().getFirst().mode());
    assertEquals("Go", marker.menu().getFirst().title());
    assertEquals(4, marker.pose().translation().x());
    assertEquals(Optional.empty(), marker.stamp());
  }

  @Test
  void posesForcesAndTrajectoriesAreKept() {
    PoseArray poses =
        (PoseArray) convert("geometry_msgs/PoseArray", new org.robotui.message.ros.geometry_msgs.PoseArray(
            new Header(0, 0, "map"), List.of(SampleMarkers.pose(1, 2, 3), SampleMarkers.pose(4, 5, 6))));
    assertEquals(new Vector3(4, 5, 6), poses.poses().get(1).translation());
    org.robotui.message.ros.geometry_msgs.Vector3 v = new org.robotui.message.ros.geometry_msgs.Vector3(1, 2, 3);
    Wrench wrench = (Wrench) convert("geometry_msgs/WrenchStamped",
        new WrenchStamped(new Header(0, 0, "wrist"), new org.robotui.message.ros.geometry_msgs.Wrench(v, v)));
    assertEquals(new Vector3(1, 2, 3), wrench.torque());
    double[] none = new double[0];
    JointTrajectoryPoint point = new JointTrajectoryPoint(new double[]{0.5}, none, none, none, 1_500_000_000L);
    JointTrajectory trajectory = (JointTrajectory) convert("trajectory_msgs/JointTrajectory",
        new org.robotui.message.ros.trajectory_msgs.JointTrajectory(new Header(0, 0, ""), List.of("elbow"),
            List.of(point)));
    assertEquals(1.5, trajectory.points().getFirst().seconds());
    assertThrows(IllegalArgumentException.class, () -> convert("trajectory_msgs/JointTrajectory",
        new org.robotui.message.ros.trajectory_msgs.JointTrajectory(new Header(0, 0, ""), List.of("elbow", "wrist"),
            List.of(point))));
  }

  /** The type is not shipped: it is read by the definition that its publisher sends. */
  @Test
  void aPlanIsReadByTheDefinitionThatCameWithIt() throws Exception {
    String text = """
        string model_id
        moveit_msgs/RobotTrajectory[] trajectory
        moveit_msgs/RobotState trajectory_start
        ===
        MSG: moveit_msgs/RobotTrajectory
        trajectory_msgs/JointTrajectory joint_trajectory
        ===
        MSG: moveit_msgs/RobotState
        J joint_state
        ===
        MSG: moveit_msgs/J
        string[] name
        float64[] position
        ===
        MSG: trajectory_msgs/JointTrajectory
        string[] joint_names
        P[] points
        ===
        MSG: trajectory_msgs/P
        float64[] positions
        float64[] velocities
        float64[] accelerations
        float64[] effort
        duration time_from_start
        """;
    MessageSchema schema = MessageSchema.parse("moveit_msgs/DisplayTrajectory", text);
    java.util.Map<String, Object> point =
        java.util.Map.of("positions", List.of(1.0, 2.0), "time_from_start", 250_000_000L);
    ByteBuffer bytes = new DynamicCodec(schema).build(java.util.Map.of("model_id", "arm",
        "trajectory",
        List.of(java.util.Map.of("joint_trajectory",
            java.util.Map.of("joint_names", List.of("a", "b"), "points", List.of(point)))),
        "trajectory_start",
        java.util.Map.of("joint_state", java.util.Map.of("name", List.of("a"), "position", List.of(0.5))))).bytes();
    DisplayedTrajectory plan = (DisplayedTrajectory) convert("moveit_msgs/DisplayTrajectory",
        DynamicMessage.read(schema, new MessageReader(bytes)));
    assertEquals("arm", plan.model());
    assertEquals(0.5, plan.start().getFirst().position());
    assertEquals(List.of("a", "b"), plan.parts().getFirst().joints());
    assertEquals(0.25, plan.parts().getFirst().points().getFirst().seconds());
    assertEquals(2.0, plan.parts().getFirst().points().getFirst().positions().get(1));
  }

  /** Bytes from a network: whatever comes is converted or refused, by an error that the stream reports. */
  @Test
  void damagedMessagesAreConvertedOrRefused() {
    Random random = new Random(5);
    byte[] array = encoded(RecordCodec.of(MarkerArray.class),
        new MarkerArray(List.of(marker(1, Marker.POINTS, 0, SIX, new float[24]), marker(2, 0, 0, SIX, new float[0]))));
    byte[] init = encoded(RecordCodec.of(InteractiveMarkerInit.class),
        new InteractiveMarkerInit("server", 1, List.of(SampleMarkers.interactive("goal", 1))));
    int converted = 0;
    for (int round = 0; round < 4_000; round++) {
      converted += accepts(() -> convert("visualization_msgs/MarkerArray",
          RecordCodec.of(MarkerArray.class).decode(damaged(array, random)))) ? 1 : 0;
      converted += accepts(() -> {
        for (InteractiveMarker m : RecordCodec.of(InteractiveMarkerInit.class).decode(damaged(init, random))
            .markers()) {
          InteractiveMarkers.marker(m, "/feedback", NAMES);
        }
      }) ? 1 : 0;
    }
    assertTrue(converted > 500 && converted < 7_500, converted + " were converted");
  }

  /** May throw what a decoder throws. */
  private interface Attempt {
    void run() throws MessageException;
  }

  private static boolean accepts(Attempt attempt) {
    try {
      attempt.run();
      return true;
    } catch (MessageException | IllegalArgumentException | ArithmeticException e) {
      return false;
    }
  }

  private static <T> byte[] encoded(MessageCodec<T> codec, T message) {
    MessageWriter out = new MessageWriter();
    codec.encode(message, out);
    return out.toByteArray();
  }

  private static ByteBuffer damaged(byte[] good, Random random) {
    byte[] bytes = good.clone();
    for (int i = 0; i < 1 + random.nextInt(3); i++) {
      bytes[random.nextInt(bytes.length)] = (byte) random.nextInt();
    }
    return ByteBuffer.wrap(bytes);
  }
}
