package org.robotui.rfic.ros.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
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
import org.robotui.data.array.Bytes;
import org.robotui.data.array.Floats;
import org.robotui.data.command.RelayMessage;
import org.robotui.data.command.RelayMessage.Wire;
import org.robotui.data.command.VelocityCommand;
import org.robotui.data.record.FieldValue;
import org.robotui.data.record.MapRecord;
import org.robotui.data.sensor.LaserScan;
import org.robotui.message.RecordCodec;
import org.robotui.message.ros.geometry_msgs.Twist;
import org.robotui.message.ros.std_msgs.StdString;
import org.robotui.ros.PublisherOptions;
import org.robotui.ros.SubscriberOptions;

/** What other robots say becomes topics of this one. */
class RosRelayTest extends RosRficCase {
  private static final long STAMP = 12_000_000_345L;
  private static final LaserScan SCAN =
      new LaserScan(new FrameId("robot", "far/laser"), -1, 0.5, 0.1, 10, 0, Floats.of(1, 2, 3), Floats.EMPTY);
  private static final MapRecord TEXT = new MapRecord("std_msgs/String", Map.of("data", new FieldValue.Text("hello")));

  private final Deque<Optional<String>> told = new ConcurrentLinkedDeque<>();

  private RelayMessage message(String topic, String type, Data value, boolean kept, boolean guarded) {
    return new RelayMessage(topic, type, value, Optional.of(new Stamp(STAMP, ClockKind.ROBOT)),
        RelayMessage.Original.NONE, kept, guarded, told::add);
  }

  private Sent relay(RelayMessage message) {
    await(() -> context.sinks.containsKey("relay"));
    return send("relay", message);
  }

  private String refusal(RelayMessage message) {
    relay(message);
    await(() -> !told.isEmpty());
    return told.removeLast().orElseThrow();
  }

  @Test
  void aScanIsHeardAsTheMessageThatUsuallyCarriesIt() {
    Deque<org.robotui.message.ros.sensor_msgs.LaserScan> heard = new ConcurrentLinkedDeque<>();
    rfic.start();
    relay(message("far/scan", "", SCAN, false, false));
    robot.subscriber("/far/scan", RecordCodec.of(org.robotui.message.ros.sensor_msgs.LaserScan.class),
        SubscriberOptions.standard(), (scan, reception) -> heard.add(scan));
    await(() -> relay(message("far/scan", "", SCAN, false, false)) instanceof Sent.Out && !heard.isEmpty());

    assertEquals("far/laser", heard.getFirst().header().frameId());
    assertEquals(STAMP, heard.getFirst().header().stamp());
    assertEquals(3, heard.getFirst().ranges().length);
    assertEquals(Optional.empty(), told.peekLast());
  }

  /** Its definition is known here, but to no node of ROS. */
  @Test
  void aScanOfRoboFrameBecomesOneOfRos() {
    RelayMessage.Original original = new RelayMessage.Original("roboframe/Scan", Optional::empty);
    RelayMessage said = new RelayMessage("far/scan", "", SCAN, Optional.of(new Stamp(STAMP, ClockKind.ROBOT)), original,
        false, false, told::add);
    Deque<org.robotui.message.ros.sensor_msgs.LaserScan> heard = new ConcurrentLinkedDeque<>();
    rfic.start();
    robot.subscriber("/far/scan", RecordCodec.of(org.robotui.message.ros.sensor_msgs.LaserScan.class),
        SubscriberOptions.standard(), (scan, reception) -> heard.add(scan));
    await(() -> relay(said) instanceof Sent.Out && !heard.isEmpty());
    assertEquals("far/laser", heard.getFirst().header().frameId());
  }

  private RelayMessage asItCame(String topic, String definition) {
    byte[] bytes = {2, 0, 0, 0, 'a', 's'};
    Wire wire = new Wire("ros1", () -> Optional.of(definition), Bytes.of(bytes));
    RelayMessage.Original original =
        new RelayMessage.Original("std_msgs/String", () -> Optional.of(TEXT), Optional.of(wire));
    return new RelayMessage(topic, "", TEXT, Optional.empty(), original, false, false, told::add);
  }

  @Test
  void bytesPassAsTheyAreWhereTheDefinitionIsTheSame() {
    Deque<String> same = new ConcurrentLinkedDeque<>();
    Deque<String> other = new ConcurrentLinkedDeque<>();
    robot.subscriber("/same", RecordCodec.of(StdString.class), SubscriberOptions.standard(),
        (t, r) -> same.add(t.data()));
    robot.subscriber("/other", RecordCodec.of(StdString.class), SubscriberOptions.standard(),
        (t, r) -> other.add(t.data()));
    rfic.start();
    await(() -> {
      relay(asItCame("same", "# with a comment\nstring data\n"));
      relay(asItCame("other", "string text\n"));
      return same.contains("as") && other.size() > 1;
    });
    assertFalse(other.contains("as"), "a definition with other names is another type");
  }

  @Test
  void whatIsKeptIsGivenToThoseWhoComeLater() {
    Deque<StdString> heard = new ConcurrentLinkedDeque<>();
    rfic.start();
    await(() -> relay(message("text", "", TEXT, true, false)) instanceof Sent.Out);
    robot.subscriber("/text", RecordCodec.of(StdString.class), SubscriberOptions.standard(), (t, r) -> heard.add(t));
    await(() -> !heard.isEmpty());
    assertEquals("hello", heard.getFirst().data());
  }

  @Test
  void whatWeSayIsNoNewsOfTheRobot() {
    rfic.start();
    try (var others = robot.publisher("/text", RecordCodec.of(StdString.class), PublisherOptions.standard())) {
      await(() -> context.streams.containsKey("text"));
      context.demand("text", true);
      await(() -> {
        relay(message("text", "", TEXT, false, false));
        others.publish(new StdString("of the robot"));
        return context.published.containsKey("text") && context.published.get("text").size() > 2;
      });
    }
    assertTrue(context.published.get("text").stream().allMatch(p -> p.raw().orElseThrow().record().orElseThrow()
        .field("data").orElseThrow().equals(new FieldValue.Text("of the robot"))));
  }

  @Test
  void whatWouldCommandIsRefused() {
    Deque<Twist> heard = new ConcurrentLinkedDeque<>();
    robot.subscriber("/cmd_vel", RecordCodec.of(Twist.class), SubscriberOptions.standard(), (t, r) -> heard.add(t));
    rfic.start();
    await(() -> context.sinks.containsKey("cmd_vel"));

    assertTrue(refusal(message("cmd_vel", "", VelocityCommand.ZERO, false, true)).contains("moves the robot"));
    assertTrue(
        refusal(message("cmd_vel", "std_msgs/String", TEXT, false, true)).contains("carries geometry_msgs/Twist"));
    assertTrue(refusal(message("goal", "geometry_msgs/PoseStamped", TEXT, false, false)).contains("'lease: true'"));
    assertTrue(heard.isEmpty());
  }

  @Test
  void whatHasNoMessageIsRefusedWithWhatWouldHelp() {
    rfic.start();
    MapRecord unknown = new MapRecord("demo/Note", Map.of("text", new FieldValue.Text("a")));
    assertTrue(
        refusal(message("note", "", unknown, false, false)).contains("with 'type', and its fields with 'fields'"));
    assertTrue(refusal(message("note", "demo/Note", unknown, false, false)).contains("definition of demo/Note"));
    assertTrue(refusal(message("note", "std_msgs/String", SCAN, false, false)).contains("does not carry LaserScan"));
  }
}
