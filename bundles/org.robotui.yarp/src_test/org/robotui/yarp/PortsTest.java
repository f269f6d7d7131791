package org.robotui.yarp;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.InetAddress;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.BooleanSupplier;
import javax.net.SocketFactory;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.robotui.net.call.Outcome;
import org.robotui.net.socket.HostPort;
import org.robotui.net.thread.Workers;
import org.robotui.yarp.bottle.Bottle;
import org.robotui.yarp.name.NameClient;
import org.robotui.yarp.name.NameServer;
import org.robotui.yarp.port.PortAdmin;
import org.robotui.yarp.port.PortArrival;
import org.robotui.yarp.port.PortCall;
import org.robotui.yarp.port.PortOptions;
import org.robotui.yarp.port.PortReader;
import org.robotui.yarp.port.PortStream;
import org.robotui.yarp.port.YarpPort;
import org.robotui.yarp.bottle.BottleCodec;
import org.robotui.yarp.wire.YarpCarrier;
import org.robotui.yarp.wire.YarpMessage;
import org.robotui.yarp.wire.YarpStamp;

/** Ports and a name server of ours, with each other. */
@Timeout(60)
class PortsTest {
  private static final InetAddress LOCAL = InetAddress.getLoopbackAddress();
  private static final PortOptions OPTIONS = PortOptions.of(Thread.ofPlatform().daemon().factory());
  private static final Duration PATIENCE = Duration.ofSeconds(10);

  private final List<PortArrival> heard = new CopyOnWriteArrayList<>();
  private final List<String> said = new CopyOnWriteArrayList<>();
  private final NameServer server = new NameServer(LOCAL, 0, OPTIONS.threads());
  private final HostPort at = new HostPort("127.0.0.1", server.port());
  private final NameClient names = new NameClient(at, SocketFactory.getDefault(), PATIENCE);
  private final YarpPort ours = open("/ui/in", new PortReader() {
    @Override
    public Optional<Bottle> received(PortArrival arrival) {
      heard.add(arrival);
      return Optional.empty();
    }

    @Override
    public void unreadable(String from, String reason) {
      said.add(from + ": " + reason);
    }

    @Override
    public void ended(String from, String reason) {
      said.add(from + " ended: " + reason);
    }
  });
  private final YarpPort robot = open("/robot/rpc", arrival -> Optional.of(arrival.bottle().get(0).text().equals("add")
      ? Bottle.of(arrival.bottle().get(1).number() + arrival.bottle().get(2).number())
      : Bottle.of(Bottle.vocabs("nak"))));

  PortsTest() throws IOException {}

  private YarpPort open(String name, PortReader reader) throws IOException {
    YarpPort port = new YarpPort(name, LOCAL, 0, Optional.of(names), reader, OPTIONS);
    names.register(name, new HostPort("127.0.0.1", port.port()), YarpPort.ACCEPTS);
    return port;
  }

  private static HostPort of(YarpPort port) {
    return new HostPort("127.0.0.1", port.port());
  }

  @AfterEach
  void end() {
    ours.close();
    robot.close();
    server.close();
  }

  private static void await(String what, BooleanSupplier condition) {
    long end = System.nanoTime() + Duration.ofSeconds(30).toNanos();
    while (!condition.getAsBoolean()) {
      assertTrue(System.nanoTime() < end, what);
      try {
        Thread.sleep(5);
      } catch (InterruptedException e) {
        throw new AssertionError(e);
      }
    }
  }

  @Test
  void ports_are_registered_and_forgotten() throws IOException {
    assertEquals(List.of("/robot/rpc", "/root", "/ui/in"), names.list().stream().map(a -> a.name()).toList());
    assertEquals(of(ours), names.query("/ui/in").orElseThrow().where());
    assertEquals(YarpPort.ACCEPTS, Set.copyOf(names.get("/ui/in", "accepts")));
    names.unregister("/ui/in");
    assertEquals(Optional.empty(), names.query("/ui/in"));
    names.unregister("/ui/in");
  }

  @Test
  void a_name_server_is_asked_by_tcp_as_well() throws IOException {
    try (PortCall call = PortCall.connect(at, "/ui/probe", OPTIONS)) {
      Bottle found = call.ask(Bottle.of("bot", "query", "/ui/in"), PATIENCE).toOptional().orElseThrow();
      assertEquals(ours.port(), found.get(3).items().get(1).number());
      assertEquals(4, call.ask(Bottle.of("bot", "list"), PATIENCE).toOptional().orElseThrow().size());
    }
  }

  @Test
  void a_port_that_is_no_name_server_is_said_to_be_none() {
    NameClient wrong = new NameClient(of(ours), SocketFactory.getDefault(), PATIENCE);
    IOException thrown = assertThrows(IOException.class, wrong::list);
    assertTrue(thrown.getMessage().contains("is no name server"), thrown.getMessage());
  }

  @ParameterizedTest
  @EnumSource
  void an_output_is_told_to_connect_and_to_let_go(YarpCarrier carrier) throws IOException {
    PortAdmin admin = new PortAdmin(OPTIONS);
    Outcome<String> added = admin.connect(of(robot), carrier, "/ui/in");
    assertTrue(added.toOptional().orElseThrow().startsWith("Added connection"), added::toString);
    assertEquals(List.of("/ui/in"), admin.targets(of(robot)).toOptional().orElseThrow());
    robot.say(Bottle.reals(1, 2, 3), Optional.of(new YarpStamp(7, 1.5)));
    await("it is heard", () -> {
      if (carrier == YarpCarrier.MCAST) {
        robot.say(Bottle.reals(1, 2, 3), Optional.of(new YarpStamp(7, 1.5))); // nobody answers that he listens
      }
      return !heard.isEmpty();
    });
    assertEquals("/robot/rpc", heard.getFirst().from());
    assertEquals(new YarpStamp(7, 1.5), heard.getFirst().stamp().orElseThrow());
    assertEquals(Bottle.reals(1, 2, 3), heard.getFirst().bottle());
    assertEquals(carrier == YarpCarrier.MCAST, names.list().stream().anyMatch(a -> a.carrier().equals("mcast")));
    assertTrue(admin.disconnect(of(robot), "/ui/in").toOptional().orElseThrow().startsWith("Removed"));
    await("it is gone", () -> ours.sources().isEmpty());
    assertInstanceOf(Outcome.Refused.class, admin.disconnect(of(robot), "/ui/in"));
    assertInstanceOf(Outcome.Refused.class, admin.connect(of(robot), carrier, "/nobody"));
    assertTrue(admin.ping(of(robot)).toOptional().orElseThrow().startsWith("This is /robot/rpc"));
  }

  @Test
  void questions_are_answered() throws IOException {
    try (PortCall call = PortCall.connect(of(robot), "/ui/ask", OPTIONS)) {
      assertEquals(Bottle.of(3.5), call.ask(Bottle.of("add", 1, 2.5), PATIENCE).toOptional().orElseThrow());
      assertEquals("nak", call.ask(Bottle.of("what"), PATIENCE).toOptional().orElseThrow().get(0).text());
    }
    try (PortCall call = PortCall.connect(of(ours), "/ui/ask", OPTIONS)) {
      assertEquals(Bottle.of(), call.ask(Bottle.of("what"), PATIENCE).toOptional().orElseThrow());
    }
  }

  @Test
  void questions_are_answered_by_text() throws IOException {
    try (Socket socket = new Socket(LOCAL, robot.port())) {
      socket.getOutputStream().write("CONNECT me\nd\nadd 1 2.5\n*\nq\n".getBytes(StandardCharsets.UTF_8));
      String all = new String(socket.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
      assertTrue(all.startsWith("Welcome me\r\n3.5\r\nThis is /robot/rpc"), all);
    }
  }

  @Test
  void what_waits_too_long_is_not_told() throws Exception {
    Workers workers = new Workers(OPTIONS.threads());
    try (PortStream stream = new PortStream(of(ours), YarpCarrier.TCP, "/ui/tell", OPTIONS, workers)) {
      stream.post("old", YarpMessage.of(BottleCodec.bytes(Bottle.of("old"))), Duration.ofNanos(1));
      stream.post("new", YarpMessage.of(BottleCodec.bytes(Bottle.of("new"))), Duration.ZERO);
      await("it is heard", () -> !heard.isEmpty());
    }
    assertEquals(List.of("new"), heard.stream().map(a -> a.bottle().get(0).text()).toList());
    await("the end is told", () -> said.contains("/ui/tell ended: it was closed"));
  }

  @Test
  void what_cannot_be_read_is_told_and_the_rest_goes_on() throws Exception {
    Workers workers = new Workers(OPTIONS.threads());
    try (PortStream stream = new PortStream(of(ours), YarpCarrier.TCP, "/ui/tell", OPTIONS, workers)) {
      stream.post("bad", YarpMessage.of(new byte[]{1, 2, 3, 4, 5}), Duration.ZERO);
      stream.post("good", YarpMessage.of(BottleCodec.bytes(Bottle.of(1))), Duration.ZERO);
      await("it is heard", () -> !heard.isEmpty());
    }
    assertTrue(said.getFirst().startsWith("/ui/tell: a bottle begins with"), said::toString);
  }
}
