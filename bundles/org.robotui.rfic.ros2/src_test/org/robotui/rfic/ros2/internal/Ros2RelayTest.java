package org.robotui.rfic.ros2.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Deque;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentLinkedDeque;
import org.junit.jupiter.api.Test;
import org.robotui.api.port.CommandSink.Sent;
import org.robotui.data.ClockKind;
import org.robotui.data.Data;
import org.robotui.data.FrameId;
import org.robotui.data.Stamp;
import org.robotui.data.array.Floats;
import org.robotui.data.command.RelayMessage;
import org.robotui.data.record.FieldValue;
import org.robotui.data.record.MapRecord;
import org.robotui.data.sensor.LaserScan;
import org.robotui.message.ros.std_msgs.StdString;
import org.robotui.ros2.QosProfiles;
import org.robotui.ros2.Ros2Codec;
import org.robotui.ros2.Ros2SubscriberOptions;

/** What other robots say becomes topics of this one. */
class Ros2RelayTest extends Ros2Case {
  private static final LaserScan SCAN =
      new LaserScan(new FrameId("robot", "far/laser"), -1, 0.5, 0.1, 10, 0, Floats.of(1, 2, 3), Floats.EMPTY);
  private static final MapRecord TEXT = new MapRecord("std_msgs/String", Map.of("data", new FieldValue.Text("hello")));

  private Sent relay(String topic, Data value, boolean kept) {
    await(() -> context.sinks.containsKey("relay"));
    return send("relay", new RelayMessage(topic, "", value, Optional.of(new Stamp(7_000_000_009L, ClockKind.ROBOT)),
        RelayMessage.Original.NONE, kept, false, RelayMessage.Answer.NOBODY));
  }

  @Test
  void aScanIsHeardAsTheMessageThatUsuallyCarriesIt() {
    Deque<org.robotui.message.ros.sensor_msgs.LaserScan> heard = new ConcurrentLinkedDeque<>();
    rfic.start();
    robot.subscriber("far/scan", Ros2Codec.of(org.robotui.message.ros.sensor_msgs.LaserScan.class),
        Ros2SubscriberOptions.of(QosProfiles.DEFAULT), (scan, reception) -> heard.add(scan));
    await(() -> relay("far/scan", SCAN, false) instanceof Sent.Out && !heard.isEmpty());

    assertEquals("far/laser", heard.getFirst().header().frameId());
    assertEquals(7_000_000_009L, heard.getFirst().header().stamp());
    assertEquals(3, heard.getFirst().ranges().length);
  }

  @Test
  void whatIsKeptIsGivenToThoseWhoComeLater() {
    Deque<StdString> heard = new ConcurrentLinkedDeque<>();
    rfic.start();
    await(() -> relay("text", TEXT, true) instanceof Sent.Out);
    robot.subscriber("text", Ros2Codec.of(StdString.class), Ros2SubscriberOptions.of(QosProfiles.LATCHED),
        (text, reception) -> heard.add(text));
    await(() -> !heard.isEmpty());
    assertEquals("hello", heard.getFirst().data());
  }

  @Test
  void whatWeSayIsNoNewsOfTheRobot() {
    rfic.start();
    var others = robot.publisher("text", Ros2Codec.of(StdString.class), QosProfiles.DEFAULT);
    await(() -> context.streams.containsKey("text"));
    context.demand("text", true);
    await(() -> {
      relay("text", TEXT, false);
      others.publish(new StdString("of the robot"));
      return context.published.containsKey("text") && context.published.get("text").size() > 2;
    });
    assertTrue(context.published.get("text").stream().allMatch(p -> p.raw().orElseThrow().record().orElseThrow()
        .field("data").orElseThrow().equals(new FieldValue.Text("of the robot"))));
  }
}
