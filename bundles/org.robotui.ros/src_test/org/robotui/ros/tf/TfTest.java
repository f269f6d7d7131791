package org.robotui.ros.tf;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;

import org.junit.jupiter.api.Test;
import org.robotui.message.tf.FrameTransform;
import org.robotui.geometry.Quaternion;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.TransformBuffer;
import org.robotui.geometry.Vector3;

class TfTest {

  private final RecordingNode network = new RecordingNode();
  private final TransformBuffer<String> buffer = new TransformBuffer<>();
  private final List<TfRefusal> refusals = new ArrayList<>();

  private TfListener listen() {
    return new TfListener(network.node(), TfTopics.STANDARD, buffer, refusals::add);
  }

  private static FrameTransform ahead(String parent, String child, long stamp) {
    return new FrameTransform(parent, child, stamp, RigidTransform.planar(1, 0, 0));
  }

  @Test
  void movingAndStaticTransformsOfSeveralNodesMakeOneTree() {
    listen();
    network.receive("/tf", "/driver", ahead("/odom", "/base", 5), ahead("odom", "base", 7));
    network.receive("/tf_static", "/model", ahead("base", "laser", 3));
    network.receive("/tf_static", "/camera_driver", ahead("base", "camera", 3));
    assertEquals(Set.of("odom", "base", "laser", "camera"), buffer.frames());
    assertEquals(2, buffer.lookup("odom", "laser", 6).transform().orElseThrow().translation().x());
    assertEquals("/model", buffer.edges().stream().filter(e -> e.child().equals("laser")).findFirst()
        .orElseThrow().authority());
  }

  @Test
  void transformsThatMakeNoSenseAreReportedWithTheirSender() {
    try (TfListener listener = listen()) {
      network.receive("/tf", "/bad", new FrameTransform("a", "b", 1,
          new RigidTransform(Vector3.ZERO, new Quaternion(0, 0, 0, 0))), ahead("", "b", 1));
      network.receive("/tf_static", "/bad", ahead("c", "c", 1));
      assertEquals(3, listener.refused());
    }
    assertEquals(List.of("/tf", "/tf", "/tf_static"), refusals.stream().map(TfRefusal::topic).toList());
    assertTrue(refusals.getFirst().reason().contains("'a' -> 'b' has a rotation of length 0.0"));
    assertEquals("/bad", refusals.getFirst().callerId());
    assertTrue(refusals.get(1).reason().contains("without a name"));
    assertEquals(Set.of(), buffer.frames());
  }

  @Test
  void aJumpBackOfTheClockForgetsMovingTransforms() {
    listen();
    network.receive("/tf", "/driver", ahead("odom", "base", 100_000_000_000L));
    network.receive("/tf_static", "/model", ahead("base", "laser", 0));
    network.jumpBack();
    assertEquals(Optional.empty(), buffer.parentOf("base"));
    assertEquals(Optional.of("base"), buffer.parentOf("laser"));
  }

  @Test
  void nothingIsLeftAfterClosing() {
    listen().close();
    assertFalse(network.listensTo("/tf"));
    assertFalse(network.listensTo("/tf_static"));
    assertEquals(0, network.jumpListeners());
  }

  @Test
  void staticTransformsAreLatchedAllTogether() {
    try (StaticTfBroadcaster broadcaster = new StaticTfBroadcaster(network.node(), TfTopics.STANDARD)) {
      broadcaster.send(List.of(ahead("base", "laser", 1), ahead("base", "camera", 1)));
      broadcaster.send(List.of(ahead("mast", "camera", 2)));
    }
    assertTrue(network.options("/tf_static").latch());
    List<String> last = network.sent().getLast().transforms().stream()
        .map(t -> t.header().frameId() + " " + t.childFrameId()).toList();
    assertEquals(List.of("base laser", "mast camera"), last);
  }

  @Test
  void movingTransformsAreSentAsTheyAre() {
    FrameTransform sent = new FrameTransform("odom", "base", 1_500_000_000L, RigidTransform.planar(1, 2, 3));
    try (TfBroadcaster broadcaster = new TfBroadcaster(network.node(), TfTopics.STANDARD)) {
      broadcaster.send(List.of(sent));
    }
    assertFalse(network.options("/tf").latch());
    assertEquals(sent, FrameTransform.of(network.sent().getFirst().transforms().getFirst()));
  }
}
