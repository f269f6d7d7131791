package org.robotui.rfic.ros2.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Deque;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.ConcurrentLinkedDeque;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.robotui.api.port.CommandSink.Sent;
import org.robotui.data.FrameId;
import org.robotui.data.marker.InteractiveMarker;
import org.robotui.data.marker.InteractiveMarkerSet;
import org.robotui.data.marker.MarkerFeedback;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.message.ros.geometry_msgs.Point;
import org.robotui.message.ros.geometry_msgs.Pose;
import org.robotui.message.ros.geometry_msgs.Quaternion;
import org.robotui.message.ros.std_msgs.Header;
import org.robotui.message.ros.visualization_msgs.GetInteractiveMarkersRequest;
import org.robotui.message.ros.visualization_msgs.GetInteractiveMarkersResponse;
import org.robotui.message.ros.visualization_msgs.InteractiveMarkerFeedback;
import org.robotui.message.ros.visualization_msgs.InteractiveMarkerPose;
import org.robotui.message.ros.visualization_msgs.InteractiveMarkerUpdate;
import org.robotui.ros2.QosProfiles;
import org.robotui.ros2.Ros2Codec;
import org.robotui.ros2.Ros2Publisher;
import org.robotui.ros2.Ros2ServiceCodec;
import org.robotui.ros2.Ros2SubscriberOptions;
import org.robotui.testkit.FakeRficContext;

/** Interactive markers, which servers of ROS 2 are asked for. */
class Ros2MarkersTest extends Ros2Case {
  private final AtomicInteger asked = new AtomicInteger();
  private final Deque<InteractiveMarkerFeedback> heard = new ConcurrentLinkedDeque<>();
  private volatile long number = 4;
  private Ros2Publisher<InteractiveMarkerUpdate> updates;

  @BeforeEach
  void serve() {
    updates = robot.publisher("goals/update", Ros2Codec.of(InteractiveMarkerUpdate.class), QosProfiles.DEFAULT);
    robot.subscriber("goals/feedback", Ros2Codec.of(InteractiveMarkerFeedback.class),
        Ros2SubscriberOptions.of(QosProfiles.DEFAULT), (message, from) -> heard.add(message));
    robot.serviceServer("goals/get_interactive_markers",
        Ros2ServiceCodec.of("visualization_msgs/srv/GetInteractiveMarkers", GetInteractiveMarkersRequest.class,
            GetInteractiveMarkersResponse.class),
        (request, caller) -> {
          asked.incrementAndGet();
          return new GetInteractiveMarkersResponse(number, List.of(handle(number)));
        });
  }

  private static Pose pose(double x) {
    return new Pose(new Point(x, 0, 0), new Quaternion(0, 0, 0, 1));
  }

  private static org.robotui.message.ros.visualization_msgs.InteractiveMarker handle(double x) {
    return new org.robotui.message.ros.visualization_msgs.InteractiveMarker(new Header(0, 0, "map"), pose(x), "goal",
        "the goal", 1, List.of(), List.of());
  }

  private void move(long to) {
    InteractiveMarkerPose moved = new InteractiveMarkerPose(new Header(0, 0, "map"), pose(to), "goal");
    updates.publish(new InteractiveMarkerUpdate("server", to, InteractiveMarkerUpdate.UPDATE, List.of(),
        List.of(moved), List.of()));
  }

  private Deque<FakeRficContext.Published> look() {
    rfic.start();
    await(() -> context.streams.containsKey("goals/update"));
    context.demand("goals/update", true);
    first("goals/update");
    return context.published.get("goals/update");
  }

  private static InteractiveMarkerSet set(FakeRficContext.Published published) {
    return (InteractiveMarkerSet) published.value();
  }

  private static InteractiveMarker marker(FakeRficContext.Published published) {
    return set(published).entries().getFirst().marker().orElseThrow();
  }

  @Test
  void allComeByAskingAndThenByUpdates() {
    Deque<FakeRficContext.Published> got = look();
    assertTrue(set(got.getFirst()).all(), "the first that is said is all there is");
    assertEquals(4, marker(got.getFirst()).pose().translation().x());
    await(() -> updates.numSubscribers() == 1);
    move(5);
    await(() -> got.size() > 1);
    assertEquals(5, marker(got.getLast()).pose().translation().x());
    assertEquals(1, asked.get());
  }

  @Test
  void aMissingUpdateIsMadeGoodByAskingAgain() {
    Deque<FakeRficContext.Published> got = look();
    await(() -> updates.numSubscribers() == 1);
    number = 7;
    move(7);
    await(() -> got.size() > 1);
    assertEquals(7, marker(got.getLast()).pose().translation().x());
    assertEquals(2, asked.get());
  }

  @Test
  void theServerHearsWhatIsDone() {
    InteractiveMarker goal = marker(look().getFirst());
    MarkerFeedback moved = new MarkerFeedback(goal.feedback(), "scene", "goal", "along",
        MarkerFeedback.Event.POSE_UPDATE, new FrameId("robby", "map"), Optional.empty(),
        RigidTransform.planar(3, 1, 0), 0, Optional.of(new Vector3(3, 1, 0.5)));
    await(() -> context.sinks.containsKey("marker_feedback"));
    await(() -> send("marker_feedback", moved) instanceof Sent.Out);
    await(() -> !heard.isEmpty());
    assertEquals(3, heard.getFirst().pose().position().x());
  }
}
