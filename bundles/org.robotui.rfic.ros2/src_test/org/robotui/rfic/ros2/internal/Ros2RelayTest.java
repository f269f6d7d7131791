package org.robotui.rfic.ros2.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Deque;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentLinkedDeque;
import org.junit.jupiter.api.Test;
import org.robotui.api.port.CommandSink.Sent;
import org.robotui.api.port.RawMessage;
import org.robotui.data.ClockKind;
import org.robotui.data.Data;
import org.robotui.data.FrameId;
import org.robotui.data.Stamp;
import org.robotui.data.array.Bytes;
import org.robotui.data.array.Floats;
import org.robotui.data.command.RelayMessage;
import org.robotui.data.record.FieldValue;
import org.robotui.data.record.MapRecord;
import org.robotui.data.sensor.LaserScan;
import org.robotui.message.description.TypeName;
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

  /** With a byte at the end that no writer of ours would write. */
  @Test
  void bytesArriveAsTheyWereSentWhereTheDefinitionIsTheSame() {
    Bytes sent = Bytes.of(new byte[]{0, 1, 0, 1, 3, 0, 0, 0, 'a', 's', 0, 7});
    Deque<Bytes> same = new ConcurrentLinkedDeque<>();
    Deque<Bytes> other = new ConcurrentLinkedDeque<>();
    Ros2Codec<ByteBuffer> raw = Ros2Codec.raw(TypeName.parse("std_msgs/msg/String").orElseThrow(), Optional.empty());
    rfic.start();
    var source = robot.publisher("in", raw, QosProfiles.DEFAULT);
    robot.subscriber("same", raw, Ros2SubscriberOptions.of(QosProfiles.DEFAULT), (b, r) -> same.add(bytes(b)));
    robot.subscriber("other", raw, Ros2SubscriberOptions.of(QosProfiles.DEFAULT), (b, r) -> other.add(bytes(b)));
    await(() -> context.streams.containsKey("in"));
    context.demand("in", true);
    await(() -> {
      source.publish(sent.buffer(ByteOrder.LITTLE_ENDIAN));
      return context.published.containsKey("in") && !context.published.get("in").isEmpty();
    });
    RawMessage came = context.published.get("in").getFirst().raw().orElseThrow();
    String definition = StandardCharsets.UTF_8.decode(
        came.origin().definition().get().orElseThrow().content().buffer(ByteOrder.LITTLE_ENDIAN)).toString();
    await(() -> {
      relay("same", asItCame(came, definition));
      relay("other", asItCame(came, "string text\n"));
      return !same.isEmpty() && same.peekLast().equals(sent) && other.size() > 1;
    });
    assertFalse(other.contains(sent), "a definition with other names is another type");
  }

  private void relay(String topic, RelayMessage.Original original) {
    await(() -> context.sinks.containsKey("relay"));
    send("relay", new RelayMessage(topic, "", TEXT, Optional.empty(), original, false, false,
        RelayMessage.Answer.NOBODY));
  }

  private static RelayMessage.Original asItCame(RawMessage came, String definition) {
    return new RelayMessage.Original(came.schema(), came::record,
        Optional.of(new RelayMessage.Wire(came.encoding(), () -> Optional.of(definition), came.bytes())));
  }

  private static Bytes bytes(ByteBuffer buffer) {
    byte[] all = new byte[buffer.remaining()];
    buffer.duplicate().get(all);
    return Bytes.of(all);
  }
}
