package org.robotui.rfic.roboframe.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.util.Deque;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentLinkedDeque;
import java.util.function.BooleanSupplier;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.robotui.api.Rfic;
import org.robotui.api.config.Settings;
import org.robotui.api.port.Browser;
import org.robotui.api.port.CallException;
import org.robotui.api.port.CommandSink;
import org.robotui.api.port.CommandSink.Sent;
import org.robotui.data.ClockKind;
import org.robotui.data.Data;
import org.robotui.data.FrameId;
import org.robotui.data.Stamp;
import org.robotui.data.array.Floats;
import org.robotui.data.command.RelayMessage;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.record.FieldValue;
import org.robotui.data.record.MapRecord;
import org.robotui.data.sensor.LaserScan;
import org.robotui.message.DefinitionException;
import org.robotui.message.DynamicCodec;
import org.robotui.message.DynamicMessage;
import org.robotui.message.MessageException;
import org.robotui.message.MessageSchema;
import org.robotui.message.roboframe.BatteryStreamable;
import org.robotui.message.roboframe.ScanStreamable;
import org.robotui.message.roboframe.VelocityStreamable;
import org.robotui.roboframe.board.Blackboard;
import org.robotui.roboframe.board.ChannelKey;
import org.robotui.roboframe.board.Connector;
import org.robotui.roboframe.board.KeyOutput;
import org.robotui.roboframe.board.Router;
import org.robotui.testkit.FakeRficContext;
import org.robotui.testkit.rfic.Peer;

/** What an application offers, and what is said to it. */
class RoboframeRficTest {
  private static final long STAMP = 1_700_000_000_000_000_000L;

  private final Blackboard board = new Blackboard();
  private final FakeRficContext context = new FakeRficContext();
  private Router router;
  private Rfic rfic;

  @BeforeEach
  void begin() throws IOException {
    router = new Router(board, "robot", List.of(Connector.parse("listen:0")), Peer.THREADS);
    rfic = new RoboframeRficType().create(context, RoboframePeer.settings(router.ports().getFirst()));
    rfic.start();
  }

  @AfterEach
  void end() {
    rfic.close();
    router.close();
  }

  private static void await(BooleanSupplier condition) throws InterruptedException {
    long end = System.nanoTime() + 30_000_000_000L;
    while (!condition.getAsBoolean()) {
      assertTrue(System.nanoTime() < end, "waited in vain");
      Thread.sleep(10);
    }
  }

  private Data comes(String port, Runnable saying) throws InterruptedException {
    await(() -> context.streams.containsKey(port));
    context.demand(port, true);
    await(() -> {
      saying.run();
      return context.published.containsKey(port) && !context.published.get(port).isEmpty();
    });
    return context.published.get(port).getLast().value();
  }

  @Test
  void a_type_of_the_application_is_a_record_with_names() throws Exception {
    MessageSchema ball = schema("soccer/Ball", "float32 x_mm\nsoccer/Seen seen\n" + "=".repeat(80)
        + "\nMSG: soccer/Seen\nstring by\ntime at\n");
    try (KeyOutput<DynamicMessage> balls = board.advertise(ChannelKey.of("soccer/ball", ball), "vision")) {
      Data came = comes("soccer/ball",
          () -> balls.push(built(ball, Map.of("x_mm", 250, "seen", Map.of("by", "striker")))));
      DynamicRecord record = assertInstanceOf(DynamicRecord.class, came);
      assertEquals("soccer/Ball", record.schema());
      assertEquals(List.of("x_mm", "seen"), record.fields());
      assertEquals(250, ((FieldValue.Num) record.field("x_mm").orElseThrow()).value());
      assertEquals("ros1", context.published.get("soccer/ball").getLast().raw().orElseThrow().encoding());
    }
  }

  private static MessageSchema schema(String type, String text) throws DefinitionException {
    return MessageSchema.parse(type, text);
  }

  private static DynamicMessage built(MessageSchema schema, Map<String, ?> values) {
    try {
      return new DynamicCodec(schema).build(values);
    } catch (MessageException e) {
      throw new IllegalStateException(e);
    }
  }

  @Test
  void what_stands_on_the_blackboard_comes_though_nothing_new_is_written() throws Exception {
    try (KeyOutput<BatteryStreamable> battery =
        board.advertise(ChannelKey.of("battery", BatteryStreamable.class), "energy")) {
      battery.push(new BatteryStreamable(STAMP, 12, -1, 0.5, false));
      comes("battery", () -> {});
      assertEquals(Optional.of(Stamp.of(1_700_000_000L, 0, ClockKind.ROBOT)),
          context.published.get("battery").getLast().stamp());
    }
  }

  @Test
  void modules_and_keys_can_be_browsed() throws Exception {
    try (KeyOutput<BatteryStreamable> battery =
        board.advertise(ChannelKey.of("battery", BatteryStreamable.class), "energy");
        var drive = board.request(ChannelKey.of("velocity", VelocityStreamable.class), "drive", posted -> {})) {
      await(() -> context.commands.containsKey("velocity") && context.streams.containsKey("battery"));
      Browser browser = context.browsers.get("graph");
      assertEquals(List.of("/battery", "/velocity"),
          browser.list(Browser.Kind.TOPIC).stream().map(Browser.Item::name).toList());
      assertEquals(List.of("drive", "energy"),
          browser.list(Browser.Kind.NODE).stream().map(Browser.Item::name).toList());
      Browser.Description described = browser.describe(browser.list(Browser.Kind.TOPIC).getFirst());
      assertEquals("energy", described.facts().get("publishers"));
      assertTrue(described.definition().orElseThrow().contains("float64 voltage"));
      assertTrue(browser.links().contains(new Browser.Link("drive", "/velocity", false)));
    } catch (CallException e) {
      throw new IllegalStateException(e);
    }
  }

  private Sent relay(RelayMessage message) {
    @SuppressWarnings("unchecked")
    CommandSink<RelayMessage> sink = (CommandSink<RelayMessage>) context.sinks.get("relay");
    return sink == null ? new Sent.Refused("not there") : sink.send(message);
  }

  private final Deque<Optional<String>> told = new ConcurrentLinkedDeque<>();

  private RelayMessage message(String key, Data value) {
    return new RelayMessage(key, "", value, Optional.of(new Stamp(STAMP, ClockKind.ROBOT)),
        RelayMessage.Original.NONE, false, false, told::add);
  }

  @Test
  void what_another_robot_says_becomes_what_a_module_reads() throws Exception {
    Deque<ScanStreamable> scans = new ConcurrentLinkedDeque<>();
    LaserScan scan =
        new LaserScan(new FrameId("other", "laser"), -1, 0.5, 0.25, 10, 0, Floats.of(1, 2, 3), Floats.EMPTY);
    try (var reading = board.request(ChannelKey.of("mate/scan", ScanStreamable.class), "team",
        posted -> scans.add(posted.value()))) {
      await(() -> {
        relay(message("mate/scan", scan));
        return !scans.isEmpty();
      });
      ScanStreamable came = scans.getLast();
      assertEquals(STAMP, came.stamp());
      assertEquals("laser", came.frame());
      assertEquals(-1, came.start());
      assertEquals(3, came.ranges().length);
    }
  }

  @Test
  void fields_that_are_written_for_a_type_of_the_application_reach_it() throws Exception {
    MessageSchema ball = schema("soccer/Ball", "float32 x_mm\nstring by\n");
    Deque<DynamicMessage> balls = new ConcurrentLinkedDeque<>();
    MapRecord record = new MapRecord("fields", Map.of("x_mm", new FieldValue.Num(250, "250")));
    try (var reading = board.request(ChannelKey.of("soccer/ball", ball), "team", posted -> balls.add(posted.value()))) {
      await(() -> {
        relay(message("soccer/ball", record));
        return !balls.isEmpty();
      });
      assertEquals(250, balls.getLast().number("x_mm").orElseThrow());
      relay(message("soccer/ball", new MapRecord("fields", Map.of("metres", new FieldValue.Num(1, "1")))));
      await(() -> told.stream().anyMatch(answer -> answer.orElse("").contains("no field in common")));
    }
  }

  @Test
  void velocities_are_not_relayed_past_the_arbiter() throws Exception {
    try (var drive = board.request(ChannelKey.of("velocity", VelocityStreamable.class), "drive", posted -> {})) {
      await(() -> context.commands.containsKey("velocity"));
      relay(message("velocity", new MapRecord("fields", Map.of("forward", new FieldValue.Num(1, "1")))));
      await(() -> !told.isEmpty());
      assertTrue(told.getLast().orElseThrow().contains("moves the robot"), told.getLast().orElseThrow());
    }
  }

  @Test
  void settings_take_the_address_of_the_variable() {
    RoboframeSettings read = RoboframeSettings.of(
        new Settings(RoboframeSettings.SCHEMA, Map.of("namespace", "/", "topics", "*",
            "velocity", List.of(), "goal", List.of(), "initial_pose", List.of(), "path", List.of(), "poses", List.of(),
            "tf", true)),
        Map.of("ROBOFRAME_ADDR", "robot:7000"));
    assertEquals("robot:7000", read.application().toString());
  }
}
