package org.robotui.rfic.ros.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.time.Duration;
import java.util.Deque;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.ThreadFactory;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import java.util.function.BooleanSupplier;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.robotui.api.config.Settings;
import org.robotui.api.port.CommandSink.Sent;
import org.robotui.api.port.CommandSink;
import org.robotui.data.FrameId;
import org.robotui.data.marker.InteractiveMarker;
import org.robotui.data.marker.InteractiveMarkerSet;
import org.robotui.data.marker.MarkerFeedback;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.guard.Guards;
import org.robotui.message.RecordCodec;
import org.robotui.message.ros.geometry_msgs.Point;
import org.robotui.message.ros.geometry_msgs.Pose;
import org.robotui.message.ros.geometry_msgs.Quaternion;
import org.robotui.message.ros.std_msgs.Header;
import org.robotui.message.ros.visualization_msgs.InteractiveMarkerFeedback;
import org.robotui.message.ros.visualization_msgs.InteractiveMarkerInit;
import org.robotui.message.ros.visualization_msgs.InteractiveMarkerUpdate;
import org.robotui.message.ros.visualization_msgs.MenuEntry;
import org.robotui.rfic.ros.internal.graph.SharedMasters;
import org.robotui.ros.GraphName;
import org.robotui.ros.NodeOptions;
import org.robotui.ros.Publisher;
import org.robotui.ros.PublisherOptions;
import org.robotui.ros.RosEnvironment;
import org.robotui.ros.RosNode;
import org.robotui.ros.SubscriberOptions;
import org.robotui.ros.master.MasterOptions;
import org.robotui.ros.master.RosMaster;
import org.robotui.testkit.FakeRficContext;

/** Interactive markers over loopback: what a server says arrives, and what a user does reaches the server. */
class InteractiveMarkersTest {
  private static final ThreadFactory DAEMONS = Thread.ofPlatform().daemon().factory();
  private static final Duration PATIENCE = Duration.ofSeconds(20);

  private final FakeRficContext context = new FakeRficContext();
  private final BlockingQueue<InteractiveMarkerFeedback> heard = new LinkedBlockingQueue<>();
  private RosMaster master;
  private RosNode server;
  private RosRfic rfic;
  private Publisher<InteractiveMarkerUpdate> updates;

  @BeforeEach
  void open() throws IOException {
    master = RosMaster.open(MasterOptions.standard(DAEMONS));
    server = RosNode.open(RosEnvironment.of(master.uri()), GraphName.of("server"), NodeOptions.standard(DAEMONS));
    rfic = new RosRfic(context, settings(), new SharedMasters(), new Guards());
    updates =
        server.publisher("/goals/update", RecordCodec.of(InteractiveMarkerUpdate.class), PublisherOptions.standard());
    server.publisher("/goals/update_full", RecordCodec.of(InteractiveMarkerInit.class), PublisherOptions.latched())
        .publish(new InteractiveMarkerInit("s", 4, List.of(handle())));
    server.subscriber("/goals/feedback", RecordCodec.of(InteractiveMarkerFeedback.class), SubscriberOptions.standard(),
        (m, from) -> heard.add(m));
  }

  @AfterEach
  void close() {
    rfic.close();
    server.close();
    master.close();
  }

  private RosSettings settings() {
    Map<String, Object> values = new HashMap<>();
    RosSettings.SCHEMA.settings().forEach(s -> s.fallback().ifPresent(f -> values.put(s.name(), f)));
    values.put("master", master.uri().toString());
    return RosSettings.of(new Settings(RosSettings.SCHEMA, values), Map.of());
  }

  private InteractiveMarker look() {
    rfic.start();
    await(() -> context.streams.containsKey("goals/update"));
    context.demand("goals/update", true);
    await(() -> updates.numSubscribers() == 1);
    Deque<FakeRficContext.Published> got = context.published.get("goals/update");
    await(() -> {
      updates.publish(
          new InteractiveMarkerUpdate("s", 4, InteractiveMarkerUpdate.KEEP_ALIVE, List.of(), List.of(), List.of()));
      return !got.isEmpty();
    });
    InteractiveMarkerSet set = (InteractiveMarkerSet) got.getFirst().value();
    assertTrue(set.all(), "the first that is said is all there is");
    return set.entries().getFirst().marker().orElseThrow();
  }

  @SuppressWarnings("unchecked") // the port carries feedback
  private Sent send(MarkerFeedback feedback) {
    return ((CommandSink<MarkerFeedback>) context.sinks.get("marker_feedback")).send(feedback);
  }

  private static MarkerFeedback moved(String topic) {
    return new MarkerFeedback(topic, "scene", "goal", "along", MarkerFeedback.Event.POSE_UPDATE,
        new FrameId("robby", "map"),
        Optional.empty(), RigidTransform.planar(3, 1, 0), 0, Optional.of(new Vector3(3, 1, 0.5)));
  }

  @Test
  void theServersMarkersArriveAndItHearsWhatIsDoneWithThem() throws InterruptedException {
    InteractiveMarker goal = look();
    assertEquals("/goals/feedback", goal.feedback());
    await(() -> send(moved(goal.feedback())) instanceof Sent.Out);
    InteractiveMarkerFeedback done = heard.poll(PATIENCE.toSeconds(), TimeUnit.SECONDS);
    assertEquals(List.of("goal", "along", "map"),
        List.of(done.markerName(), done.controlName(), done.header().frameId()));
    assertEquals(InteractiveMarkerFeedback.POSE_UPDATE, done.eventType());
    assertEquals(3, done.pose().position().x());
    assertTrue(done.mousePointValid() && done.clientId().endsWith("/scene"), done.clientId());
  }

  @Test
  void whereNobodyLooksNothingIsSent() {
    look();
    String reason = assertInstanceOf(Sent.Refused.class, send(moved("/elsewhere/feedback"))).toString();
    assertTrue(reason.contains("/elsewhere/feedback"), reason);
    context.demand("goals/update", false);
    await(() -> updates.numSubscribers() == 0);
    await(() -> send(moved("/goals/feedback")) instanceof Sent.Refused);
  }

  private static void await(BooleanSupplier condition) {
    long end = System.nanoTime() + PATIENCE.toNanos();
    while (!condition.getAsBoolean()) {
      assertTrue(System.nanoTime() < end, "waited in vain");
      LockSupport.parkNanos(5_000_000);
    }
  }

  private static org.robotui.message.ros.visualization_msgs.InteractiveMarker handle() {
    Pose pose = new Pose(new Point(2, 0, 0), new Quaternion(0, 0, 0, 1));
    return new org.robotui.message.ros.visualization_msgs.InteractiveMarker(new Header(0, 0, "map"), pose, "goal",
        "the goal", 1, List.of(new MenuEntry(1, 0, "Go", "", 0)), List.of());
  }
}
