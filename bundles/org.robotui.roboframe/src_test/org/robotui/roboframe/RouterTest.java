package org.robotui.roboframe;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
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
import org.robotui.roboframe.board.Posted;
import org.robotui.roboframe.board.KeyUse;
import org.robotui.roboframe.board.Router;

/** Applications that share keys. */
class RouterTest {
  private static final ChannelKey<VelocityStreamable> VELOCITY = ChannelKey.of("velocity", VelocityStreamable.class);
  private static final ChannelKey<BatteryStreamable> BATTERY = ChannelKey.of("battery", BatteryStreamable.class);
  private static final BatteryStreamable FULL = new BatteryStreamable(1, 12, -1, 1, false);

  private final List<Router> routers = new ArrayList<>();
  private final Blackboard robot = new Blackboard();
  private final Blackboard gui = new Blackboard();

  @AfterEach
  void close() {
    routers.forEach(Router::close);
  }

  private Router router(Blackboard board, String name, String... connectors) throws IOException {
    Router made = new Router(board, name, List.of(connectors).stream().map(Connector::parse).toList(),
        BrokerWaiting.THREADS);
    routers.add(made);
    return made;
  }

  /** Said again until it has come, as nobody may be there yet. */
  private static <T> void arrives(KeyOutput<T> output, T value, Queue<Posted<T>> heard) throws InterruptedException {
    heard.clear();
    BrokerWaiting.until("the value", () -> {
      output.push(value);
      return !heard.isEmpty();
    });
    assertEquals(value, heard.element().value());
  }

  @Test
  void values_go_where_they_are_read_in_both_directions() throws Exception {
    Queue<Posted<BatteryStreamable>> seen = new ConcurrentLinkedQueue<>();
    Queue<Posted<VelocityStreamable>> driven = new ConcurrentLinkedQueue<>();
    try (KeyOutput<BatteryStreamable> battery = robot.advertise(BATTERY, "energy");
        KeyUse drive = robot.request(VELOCITY, "drive", driven::add);
        KeyUse shown = gui.request(BATTERY, "view", seen::add);
        KeyOutput<VelocityStreamable> stick = gui.advertise(VELOCITY, "stick")) {
      Router first = router(robot, "robot", "listen:0");
      router(gui, "gui", "connect:localhost:" + first.ports().getFirst());
      arrives(battery, FULL, seen);
      assertEquals("robot", seen.element().from());
      arrives(stick, new VelocityStreamable(0.5, 0, 0.1), driven);
      assertEquals("gui", driven.element().from());
      assertEquals(List.of("gui"), first.applications());
    }
  }

  @Test
  void what_stands_on_the_blackboard_comes_to_who_asks_later() throws Exception {
    try (KeyOutput<BatteryStreamable> battery = robot.advertise(BATTERY, "energy")) {
      battery.push(FULL);
      Router first = router(robot, "robot", "listen:0");
      router(gui, "gui", "connect:localhost:" + first.ports().getFirst());
      BrokerWaiting.until("the link", () -> first.applications().equals(List.of("gui")));
      Queue<Posted<BatteryStreamable>> seen = new ConcurrentLinkedQueue<>();
      try (KeyUse shown = gui.request(BATTERY, "view", seen::add)) {
        BrokerWaiting.until("the value", () -> !seen.isEmpty());
        assertEquals(FULL, seen.element().value());
      }
    }
  }

  @Test
  void links_are_made_again_in_every_order() throws Exception {
    Queue<Posted<BatteryStreamable>> seen = new ConcurrentLinkedQueue<>();
    try (KeyOutput<BatteryStreamable> battery = robot.advertise(BATTERY, "energy");
        KeyUse shown = gui.request(BATTERY, "view", seen::add)) {
      Router first = router(robot, "robot", "listen:0");
      int port = first.ports().getFirst();
      first.close();
      Router connecting = router(gui, "gui", "connect:localhost:" + port); // before anybody listens
      Router second = router(robot, "robot", "listen:" + port);
      arrives(battery, FULL, seen);
      second.close();
      BrokerWaiting.until("its end", () -> connecting.applications().isEmpty());
      router(robot, "robot", "listen:" + port);
      arrives(battery, FULL, seen);
      connecting.close();
      router(gui, "gui", "connect:localhost:" + port);
      arrives(battery, FULL, seen);
    }
  }

  @Test
  void keys_of_other_types_are_not_mixed_up() throws Exception {
    Queue<Posted<ScanStreamable>> seen = new ConcurrentLinkedQueue<>();
    ChannelKey<ScanStreamable> other = ChannelKey.of(BATTERY.name(), ScanStreamable.class);
    Queue<Posted<VelocityStreamable>> driven = new ConcurrentLinkedQueue<>();
    try (KeyOutput<BatteryStreamable> battery = robot.advertise(BATTERY, "energy");
        KeyOutput<VelocityStreamable> velocity = robot.advertise(VELOCITY, "energy");
        KeyUse shown = gui.request(other, "view", seen::add);
        KeyUse too = gui.request(VELOCITY, "view", driven::add)) {
      Router first = router(robot, "robot", "listen:0");
      Router second = router(gui, "gui", "connect:localhost:" + first.ports().getFirst());
      battery.push(FULL);
      arrives(velocity, new VelocityStreamable(1, 0, 0), driven);
      assertTrue(seen.isEmpty());
      assertEquals(0, second.unreadable());
    }
  }

  @Test
  void types_of_an_application_need_no_class() throws Exception {
    MessageSchema ball = schema("soccer/Ball", "float32 x\nfloat32 y\nstring seen_by\n");
    ChannelKey<DynamicMessage> key = ChannelKey.of("ball", ball);
    Queue<Posted<DynamicMessage>> seen = new ConcurrentLinkedQueue<>();
    try (KeyOutput<DynamicMessage> balls = robot.advertise(key, "vision");
        KeyUse shown = gui.request(key, "view", seen::add)) {
      Router first = router(robot, "robot", "listen:0");
      router(gui, "gui", "connect:localhost:" + first.ports().getFirst());
      BrokerWaiting.until("the value", () -> {
        balls.push(built(ball));
        return !seen.isEmpty();
      });
      assertEquals(1.5, seen.element().value().number("x").orElseThrow());
    }
  }

  private static DynamicMessage built(MessageSchema ball) {
    try {
      return new DynamicCodec(ball)
          .build(Map.of("x", 1.5, "y", 2, "seen_by", "striker"));
    } catch (MessageException e) {
      throw new IllegalStateException(e);
    }
  }

  private static MessageSchema schema(String type, String text) throws DefinitionException {
    return MessageSchema.parse(type, text);
  }

  @Test
  void connectors_are_read_as_they_are_configured() {
    assertEquals("localhost:7420", connect("connect:localhost"));
    assertEquals("robot:7421", connect("connect:robot:7421"));
    for (String wrong : List.of("", "listen", "listen:x", "listen:70000", "udp:1:2", "connect:robot:x")) {
      IllegalArgumentException e =
          assertThrows(IllegalArgumentException.class, () -> Connector.parse(wrong), wrong);
      assertTrue(e.getMessage().contains("connect:HOST:7420"), e.getMessage());
    }
  }

  private static String connect(String written) {
    return ((Connector.Connect) Connector.parse(written)).address().toString();
  }
}
