package org.robotui.rfic.ros.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.robotui.api.link.LinkState;
import org.robotui.guard.Guards;
import org.robotui.message.RecordCodec;
import org.robotui.message.ros.geometry_msgs.Quaternion;
import org.robotui.message.ros.geometry_msgs.Transform;
import org.robotui.message.ros.geometry_msgs.TransformStamped;
import org.robotui.message.ros.geometry_msgs.Vector3;
import org.robotui.message.ros.std_msgs.Header;
import org.robotui.message.ros.std_msgs.StdFloat64;
import org.robotui.message.ros.tf2_msgs.TFMessage;
import org.robotui.rfic.ros.internal.graph.SharedMasters;
import org.robotui.ros.Publisher;
import org.robotui.ros.PublisherOptions;
import org.robotui.testkit.FakeRficContext;

/** Two interfaces to two robots at one master. */
class SharedMasterTest extends RosRficCase {
  private final SharedMasters masters = new SharedMasters();
  private final FakeRficContext second = new FakeRficContext();
  private RosRfic other;
  private Publisher<TFMessage> moving;
  private Publisher<TFMessage> fixed;

  @BeforeEach
  void openBoth() {
    rfic = new RosRfic(context, in("r1"), masters, new Guards());
    other = new RosRfic(second, in("r2"), masters, new Guards());
    moving = robot.publisher("/tf", RecordCodec.of(TFMessage.class), PublisherOptions.standard());
    fixed = robot.publisher("/tf_static", RecordCodec.of(TFMessage.class), PublisherOptions.latched());
    robot.publisher("/r1/value", RecordCodec.of(StdFloat64.class), PublisherOptions.standard());
    robot.publisher("/r3/value", RecordCodec.of(StdFloat64.class), PublisherOptions.standard());
    fixed.publish(message("r1/base_link", "r1/laser", "base_link", "laser"));
  }

  @AfterEach
  void closeOther() {
    other.close();
  }

  private RosSettings in(String namespace) {
    return settings(Map.of("master", master.uri().toString(), "namespace", namespace));
  }

  private static TFMessage message(String... parentsAndChildren) {
    List<TransformStamped> all = new java.util.ArrayList<>();
    for (int i = 0; i < parentsAndChildren.length; i += 2) {
      all.add(new TransformStamped(new Header(0, 1_000_000_000L, parentsAndChildren[i]), parentsAndChildren[i + 1],
          new Transform(new Vector3(1, 0, 0), new Quaternion(0, 0, 0, 1))));
    }
    return new TFMessage(all);
  }

  private static Set<String> children(FakeRficContext of) {
    return of.transforms.stream().map(t -> t.child().name()).collect(Collectors.toCollection(TreeSet::new));
  }

  @Test
  void oneListensForBothAndEachIsGivenWhatConcernsItsRobot() {
    rfic.start();
    await(() -> moving.numSubscribers() == 1 && context.streams.containsKey("value"));
    other.start();
    await(() -> !children(second).isEmpty());
    assertEquals(Set.of("laser"), children(second), "what is said once it hears, too, but not of the other robot");
    await(() -> {
      moving.publish(
          message("map", "r1/odom", "map", "r2/odom", "map", "r3/odom", "odom", "base_link", "map", "arena/door"));
      return children(second).size() == 4 && children(context).size() == 5;
    });
    assertEquals(Set.of("laser", "r2/odom", "base_link", "arena/door"), children(second));
    assertEquals(Set.of("laser", "r1/laser", "r1/odom", "base_link", "arena/door"), children(context));
    assertEquals(1, moving.numSubscribers(), "of two interfaces one listens");
  }

  @Test
  void whenTheOneThatListensEndsTheNextOneDoes() {
    rfic.start();
    await(() -> moving.numSubscribers() == 1);
    other.start();
    await(() -> !second.links.isEmpty() && second.links.getLast() instanceof LinkState.Connected);
    rfic.close();
    await(() -> {
      moving.publish(message("map", "r2/odom"));
      return children(second).contains("r2/odom");
    });
    await(() -> moving.numSubscribers() == 1);
  }

  @Test
  void eachSeesItsOwnTopicsAsTheyComeAndGo() throws IOException {
    rfic.start();
    other.start();
    await(() -> context.streams.containsKey("value"));
    assertTrue(!second.streams.containsKey("value"));
    Publisher<StdFloat64> late =
        robot.publisher("/r2/value", RecordCodec.of(StdFloat64.class), PublisherOptions.standard());
    await(() -> second.streams.containsKey("value"));
    late.close();
    await(() -> !second.streams.containsKey("value"));
    assertTrue(context.streams.containsKey("value"));
  }
}
