package org.robotui.message.topic.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.robotui.api.port.RawMessage;
import org.robotui.api.port.RawOrigin;
import org.robotui.data.array.Bytes;

import org.robotui.message.ros.geometry_msgs.Quaternion;
import org.robotui.message.ros.geometry_msgs.Transform;
import org.robotui.message.ros.geometry_msgs.TransformStamped;
import org.robotui.message.ros.geometry_msgs.Vector3;
import org.robotui.message.ros.std_msgs.Header;
import org.robotui.message.ros.tf2_msgs.TFMessage;

class HeldTransformsTest {
  private final HeldTransforms held = new HeldTransforms();

  private RawMessage says(String sender, String... children) {
    RawMessage raw = new RawMessage("tf2_msgs/TFMessage", "cdr", Bytes.of((byte) children.length),
        RawMessage.Reader.NONE, new RawOrigin("/tf_static", sender, true, Optional::empty));
    held.note(new TFMessage(List.of(children).stream().map(HeldTransformsTest::transform).toList()), raw);
    return raw;
  }

  private static TransformStamped transform(String child) {
    return new TransformStamped(new Header(0, 0, "base"), child,
        new Transform(new Vector3(0, 0, 0), new Quaternion(0, 0, 0, 1)));
  }

  @Test
  void theNewestOfEachSenderHolds() {
    says("/a", "laser");
    RawMessage second = says("/a", "laser", "camera");
    RawMessage other = says("/b", "arm");

    assertEquals(List.of(second, other), held.messages(child -> true));
    assertEquals(List.of(other), held.messages("arm"::equals));
    held.clear();
    assertEquals(List.of(), held.messages(child -> true));
  }
}
