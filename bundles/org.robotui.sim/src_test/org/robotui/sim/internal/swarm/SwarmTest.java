package org.robotui.sim.internal.swarm;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.net.URI;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.BooleanSupplier;
import org.junit.jupiter.api.Test;
import org.robotui.message.RecordCodec;
import org.robotui.message.ros.actionlib_msgs.GoalStatusArray;
import org.robotui.message.ros.geometry_msgs.Point;
import org.robotui.message.ros.geometry_msgs.Pose;
import org.robotui.message.ros.geometry_msgs.PoseStamped;
import org.robotui.message.ros.geometry_msgs.Quaternion;
import org.robotui.message.ros.nav_msgs.OccupancyGrid;
import org.robotui.message.ros.nav_msgs.Odometry;
import org.robotui.message.ros.std_msgs.Header;
import org.robotui.ros.GraphName;
import org.robotui.ros.NodeOptions;
import org.robotui.ros.Publisher;
import org.robotui.ros.PublisherOptions;
import org.robotui.ros.RosNode;
import org.robotui.ros.SubscriberOptions;
import org.robotui.ros.master.MasterOptions;
import org.robotui.ros.master.RosMaster;
import org.robotui.sim.internal.ros.RosOptions;

class SwarmTest {
  private static RosNode node(Swarm swarm, String namespace, String name) throws Exception {
    return RosNode.open(swarm.master().environment(List.of("__ns:=" + namespace)), GraphName.of(name),
        NodeOptions.standard(SwarmTest::thread));
  }

  private static Thread thread(Runnable task) {
    return Thread.ofPlatform().daemon().unstarted(task);
  }

  private static RosOptions at(Optional<URI> realMaster) {
    return new RosOptions(0, "", "robot", realMaster, false, List.of());
  }

  private static void await(BooleanSupplier condition, String what) throws InterruptedException {
    long end = System.nanoTime() + Duration.ofSeconds(20).toNanos();
    while (!condition.getAsBoolean()) {
      assertTrue(System.nanoTime() < end, what);
      Thread.sleep(20);
    }
  }

  @Test
  void eachRobotIsANodeThatTakesGoalsAndCanGoAlone() throws Exception {
    AtomicReference<String> task = new AtomicReference<>("");
    AtomicLong first = new AtomicLong();
    AtomicLong second = new AtomicLong();
    AtomicReference<OccupancyGrid> map = new AtomicReference<>();
    try (Swarm swarm = Swarm.start(3, at(Optional.empty()), 1); RosNode client = node(swarm, "/", "client")) {
      client.subscriber("/r2/move_base/status", RecordCodec.of(GoalStatusArray.class), SubscriberOptions.standard(),
          (m, r) -> task.set(m.statusList().getFirst().text()));
      client.subscriber("/r1/odom", RecordCodec.of(Odometry.class), SubscriberOptions.standard(),
          (m, r) -> first.incrementAndGet());
      client.subscriber("/r2/odom", RecordCodec.of(Odometry.class), SubscriberOptions.standard(),
          (m, r) -> second.incrementAndGet());
      client.subscriber("/map", RecordCodec.of(OccupancyGrid.class), SubscriberOptions.standard(),
          (m, r) -> map.set(m));
      await(() -> "patrolling".equals(task.get()) && first.get() > 3 && map.get() != null, "nothing comes");
      assertEquals(246, map.get().info().width());
      Publisher<PoseStamped> goal =
          client.publisher("/r2/move_base_simple/goal", RecordCodec.of(PoseStamped.class), PublisherOptions.standard());
      await(() -> goal.numSubscribers() == 1, "nobody takes goals");
      goal.publish(new PoseStamped(new Header(0, 0, "map"), new Pose(new Point(4, 12, 0), new Quaternion(0, 0, 0, 1))));
      await(() -> "going to 4.0 12.0".equals(task.get()), task.get());
      RosNode twin = node(swarm, "/r1", "robot"); // whose name another takes, that one ends
      twin.awaitRegistered(Duration.ofSeconds(30));
      long before = first.get();
      long others = second.get();
      await(() -> second.get() > others + 20, "the others stopped, too");
      assertTrue(first.get() < before + 15, "it goes on");
      twin.close();
    }
  }

  @Test
  void whereThereIsARealMasterItHasTheSwarmForAsLongAsThatRuns() throws Exception {
    try (RosMaster master = RosMaster.open(MasterOptions.standard(SwarmTest::thread))) {
      try (Swarm swarm = Swarm.start(2, at(Optional.of(master.uri())), 1);
          RosNode client = node(swarm, "/", "client")) {
        assertTrue(client.master().systemState().toOptional().orElseThrow().nodes()
            .containsAll(List.of("/map_server", "/r1/robot", "/r2/robot")));
      }
      try (Swarm another = Swarm.start(1, at(Optional.of(master.uri())), 1);
          RosNode client = node(another, "/", "client")) {
        assertFalse(client.master().systemState().toOptional().orElseThrow().nodes().contains("/r2/robot"));
      }
    }
  }
}
