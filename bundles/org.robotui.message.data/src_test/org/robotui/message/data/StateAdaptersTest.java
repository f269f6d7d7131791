package org.robotui.message.data;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.robotui.data.ClockKind;
import org.robotui.message.ros.geometry_msgs.Quaternion;
import org.robotui.message.ros.geometry_msgs.Transform;
import org.robotui.message.ros.geometry_msgs.TransformStamped;
import org.robotui.message.ros.geometry_msgs.Vector3;
import org.robotui.message.ros.std_msgs.Header;
import org.robotui.message.ros.tf2_msgs.TFMessage;

class StateAdaptersTest {
  private static final FrameNames NAMES = new FrameNames("robby", ClockKind.ROBOT);

  @Test
  void aTransformThatIsNoneIsLeftOutAndNamedByItsFramesAndItsField() {
    TFMessage message =
        new TFMessage(List.of(transform("base", 1), transform("arm", Double.NaN), transform("hand", Double.NaN)));

    assertEquals(1, StateAdapters.transforms(message, NAMES, false).orElseThrow().transforms().size());
    String said = StateAdapters.refusal(message, NAMES).orElseThrow();
    assertEquals("'map' -> 'arm': translation: must be finite", said.substring(0, said.indexOf(", is ")));
  }

  @Test
  void nothingIsSaidOfTransforms() {
    assertEquals(Optional.empty(), StateAdapters.refusal(new TFMessage(List.of(transform("base", 1))), NAMES));
  }

  private static TransformStamped transform(String child, double x) {
    return new TransformStamped(new Header(0, 1, "map"), child,
        new Transform(new Vector3(x, 0, 0), new Quaternion(0, 0, 0, 1)));
  }
}
