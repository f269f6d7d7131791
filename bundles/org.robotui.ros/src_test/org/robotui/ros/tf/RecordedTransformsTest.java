package org.robotui.ros.tf;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIf;
import org.robotui.message.tf.FrameTransform;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.TransformBuffer;
import org.robotui.geometry.TransformLimits;
import org.robotui.geometry.TransformLookup;
import org.robotui.geometry.TransformPut;
import org.robotui.message.MessageException;
import org.robotui.message.RecordCodec;
import org.robotui.message.ros.geometry_msgs.TransformStamped;
import org.robotui.message.ros.nav_msgs.Odometry;
import org.robotui.message.ros.tf2_msgs.TFMessage;
import org.robotui.testkit.recorded.BagReader;
import org.robotui.testkit.recorded.SharedData;

/** The transforms of recordings give the poses that the same recordings hold, or that were composed by hand. */
@EnabledIf(value = SharedData.AVAILABLE, disabledReason = SharedData.REASON)
class RecordedTransformsTest {

  private static final TransformLimits LONG = new TransformLimits(100_000_000_000L, 100, 10_000);

  private final TransformBuffer<String> buffer = new TransformBuffer<>(LONG);

  private void fill(List<BagReader.Recorded> messages) throws MessageException {
    for (BagReader.Recorded each : messages) {
      if (each.topic().startsWith("/tf")) {
        for (TransformStamped t : RecordCodec.of(TFMessage.class).decode(each.bytes().duplicate()).transforms()) {
          assertInstanceOf(TransformPut.Accepted.class, put(each.topic(), FrameTransform.of(t)));
        }
      }
    }
  }

  private TransformPut<String> put(String topic, FrameTransform t) {
    return topic.equals("/tf_static")
        ? buffer.putStatic(t.parent(), t.child(), t.parentFromChild(), "bag")
        : buffer.put(t.parent(), t.child(), t.stampNanos(), t.parentFromChild(), "bag");
  }

  @Test
  void odometryAndTransformsOfTheMobileRobotAgree() throws Exception {
    List<BagReader.Recorded> messages = BagReader.read(SharedData.file("bags/sena_loop.bag"));
    fill(messages);
    int compared = 0;
    for (BagReader.Recorded each : messages) {
      if (each.topic().equals("/odom")) {
        Odometry odometry = RecordCodec.of(Odometry.class).decode(each.bytes());
        RigidTransform base = found(buffer.lookup("odom", "base_link", odometry.header().stamp()));
        assertEquals(odometry.pose().pose().position().x(), base.translation().x(), 1e-9);
        assertEquals(odometry.pose().pose().position().y(), base.translation().y(), 1e-9);
        RigidTransform laser = found(buffer.lookup("base_link", "laser", odometry.header().stamp()));
        assertEquals(0.78, laser.translation().x(), 1e-9);
        compared++;
      }
    }
    assertEquals(224, compared);
  }

  @Test
  void theDriftOfTheOdometryIsSeenAtTheEnd() throws Exception {
    fill(BagReader.read(SharedData.file("bags/sena_loop.bag")));
    TransformLookup<String> last = buffer.lookupLatest("map", "odom");
    assertEquals(1.890971, found(last).translation().x(), 1e-6);
    assertEquals(3.086036, found(last).translation().y(), 1e-6);
    TransformLookup.Found<String> laser = (TransformLookup.Found<String>) buffer.lookupLatest("map", "laser");
    RigidTransform byHand = found(buffer.lookup("map", "odom", laser.stampNanos()))
        .times(found(buffer.lookup("odom", "base_link", laser.stampNanos())))
        .times(found(buffer.lookup("base_link", "laser", laser.stampNanos())));
    assertEquals(byHand.translation().x(), laser.targetFromSource().translation().x(), 1e-9);
    assertEquals(byHand.rotation().yaw(), laser.targetFromSource().rotation().yaw(), 1e-9);
  }

  @Test
  void theOldTypeWithLeadingSlashesIsTheSame() throws Exception {
    fill(BagReader.read(SharedData.file("bags/turtlesim.bag")));
    assertTrue(buffer.frames().containsAll(List.of("world", "turtle1", "turtle2")), buffer.frames().toString());
    assertTrue(found(buffer.lookupLatest("turtle1", "turtle2")).translation().isFinite());
  }

  private static RigidTransform found(TransformLookup<String> lookup) {
    return lookup.transform().orElseThrow(() -> new AssertionError(lookup.explanation()));
  }
}
