package org.robotui.smartsoft;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.InetAddress;
import java.net.Socket;
import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.ThreadFactory;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
import javax.net.SocketFactory;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.robotui.message.MessageException;
import org.robotui.message.RosValue;
import org.robotui.net.socket.HostPort;
import org.robotui.smartsoft.client.EventClient;
import org.robotui.smartsoft.client.EventMode;
import org.robotui.smartsoft.client.ParameterMaster;
import org.robotui.smartsoft.client.PushClient;
import org.robotui.smartsoft.client.QueryClient;
import org.robotui.smartsoft.client.SendClient;
import org.robotui.smartsoft.client.StateMaster;
import org.robotui.smartsoft.client.WiringMaster;
import org.robotui.smartsoft.naming.NamedService;
import org.robotui.smartsoft.naming.NamingClient;
import org.robotui.smartsoft.naming.NamingService;
import org.robotui.smartsoft.naming.ServiceAddress;
import org.robotui.smartsoft.naming.ServiceName;
import org.robotui.smartsoft.naming.SmartPattern;
import org.robotui.smartsoft.object.CommType;
import org.robotui.smartsoft.object.CommTypes;
import org.robotui.smartsoft.server.EventServer;
import org.robotui.smartsoft.server.ParameterSlave;
import org.robotui.smartsoft.server.PushServer;
import org.robotui.smartsoft.server.QueryServer;
import org.robotui.smartsoft.server.SendServer;
import org.robotui.smartsoft.server.SmartServerOptions;
import org.robotui.smartsoft.server.SmartComponent;
import org.robotui.smartsoft.server.StateSlave;
import org.robotui.smartsoft.server.WiringSlave;
import org.robotui.smartsoft.wire.LinkOptions;

/** Clients and servers of all patterns, on loopback. */
@Timeout(60)
class SmartPatternsTest {

  private static final ThreadFactory THREADS = Thread.ofPlatform().daemon().factory();
  private static final LinkOptions LINKS = LinkOptions.of(THREADS);
  private static final Duration PATIENCE = Duration.ofSeconds(20);
  private static final String TIME = "SmartACE::exampleTime";

  private final CommTypes types = CommTypes.shipped();
  private final SmartServerOptions options = SmartServerOptions.loopback(THREADS);
  private NamingService naming;
  private SmartComponent component;

  @BeforeEach
  void open() throws IOException {
    naming = new NamingService(THREADS, InetAddress.getLoopbackAddress(), 0);
    component = new SmartComponent("base", call());
  }

  @AfterEach
  void close() {
    component.close();
    naming.close();
  }

  private NamingClient call() throws IOException {
    return NamingClient.connect(new HostPort("127.0.0.1", naming.port()), SocketFactory.getDefault(), PATIENCE);
  }

  private static void await(String what, BooleanSupplier condition) throws InterruptedException {
    long end = System.nanoTime() + PATIENCE.toNanos();
    while (!condition.getAsBoolean()) {
      assertTrue(System.nanoTime() < end, what);
      Thread.sleep(5);
    }
  }

  private ByteBuffer time(long seconds) throws MessageException {
    return types.get(TIME).bytes(Map.of("seconds", seconds));
  }

  private double seconds(ByteBuffer object) throws MessageException {
    return types.get(TIME).read(object).number("seconds").orElseThrow();
  }

  @Test
  void services_are_listed_resolved_and_removed() throws Exception {
    PushServer server = component.offer(SmartPattern.PUSH, "time", List.of(TIME),
        new PushServer(options, Duration.ZERO));
    try (NamingClient client = call()) {
      List<NamedService> listed = client.list();
      assertEquals(List.of("base/time"), listed.stream().map(each -> each.name().path()).toList());
      assertEquals(server.address(), listed.getFirst().address());
      assertEquals(Optional.of(server.address()), client.resolve(listed.getFirst().name()));
      assertEquals(Optional.empty(), client.resolve(new ServiceName("base", "Push", "other", List.of(TIME))));
      component.close();
      assertEquals(List.of(), client.list());
    }
  }

  @Test
  void what_is_entered_for_any_address_is_where_it_was_entered_from() throws Exception {
    ServiceName name = new ServiceName("base", "Send", "print", List.of("SmartACE::examplePrint"));
    try (NamingClient client = call()) {
      client.bind(name, new ServiceAddress(new HostPort("0.0.0.0", 4711), "some-identifier"));
      assertEquals("127.0.0.1:4711#some-identifier", client.resolve(name).orElseThrow().toString());
      client.unbind(name);
      assertThrows(IOException.class, () -> client.unbind(name));
    }
  }

  @Test
  void updates_come_as_often_as_they_are_wanted() throws Exception {
    PushServer server = component.offer(SmartPattern.PUSH, "time", List.of(TIME),
        new PushServer(options, Duration.ofMillis(100)));
    BlockingQueue<ByteBuffer> updates = new LinkedBlockingQueue<>();
    try (PushClient client = PushClient.connect(server.address(), LINKS, updates::add)) {
      assertEquals(Duration.ofMillis(100), client.info(PATIENCE).period());
      server.put(time(1));
      assertTrue(client.subscribe(2));
      await("it is subscribed", () -> server.subscribers() == 1);
      for (int i = 2; i < 6; i += 2) {
        server.put(time(i));
        assertEquals(i, seconds(updates.poll(20, TimeUnit.SECONDS))); // what waits would be replaced by what is newer
        server.put(time(i + 1));
      }
      client.unsubscribe();
      await("nobody is subscribed", () -> server.subscribers() == 0);
    }
  }

  @Test
  void a_service_that_ends_tells_its_clients() throws Exception {
    PushServer server = new PushServer(options, Duration.ZERO);
    try (PushClient client = PushClient.connect(server.address(), LINKS, object -> {})) {
      assertEquals(Optional.empty(), client.over());
      server.close();
      await("it is told", () -> client.over().orElse("").contains("was ended"));
      assertFalse(client.subscribe(1));
    }
  }

  @Test
  void a_server_with_another_identifier_does_not_take_us() throws Exception {
    try (PushServer server = new PushServer(options, Duration.ZERO)) {
      ServiceAddress stale = new ServiceAddress(server.address().at(), "of-another-life");
      IOException refused =
          assertThrows(IOException.class, () -> PushClient.connect(stale, LINKS, object -> {}));
      assertTrue(refused.getMessage().contains("service unavailable"), refused.getMessage());
    }
  }

  @Test
  void what_is_sent_arrives_in_order() throws Exception {
    BlockingQueue<Double> sent = new LinkedBlockingQueue<>();
    try (SendServer server = new SendServer(options, object -> sent.add(seconds(object)));
        SendClient client = SendClient.connect(server.address(), LINKS)) {
      for (int i = 0; i < 50; i++) {
        assertTrue(client.send(time(i)));
      }
      for (int i = 0; i < 50; i++) {
        assertEquals(i, sent.poll(20, TimeUnit.SECONDS));
      }
    }
  }

  @Test
  void queries_are_answered() throws Exception {
    CommType values = types.get("SmartACE::exampleValues");
    CommType result = types.get("SmartACE::exampleResult");
    try (QueryServer server = new QueryServer(options, request -> {
      double sum = 0;
      for (double each : ((RosValue.Numbers) values.read(request).field("values").orElseThrow())
          .values().toDoubles()) {
        sum += each;
      }
      return result.bytes(Map.of("value", (int) sum));
    }); QueryClient client = QueryClient.connect(server.address(), LINKS)) {
      ByteBuffer answer = client.query(values.bytes(Map.of("values", List.of(10, 11, 12))), PATIENCE);
      assertEquals(33, result.read(answer).number("value").orElseThrow());
    }
  }

  @Test
  void events_happen_once_or_again_and_again() throws Exception {
    CommType parameter = types.get("SmartACE::exampleEvent1Parameter");
    CommType result = types.get("SmartACE::exampleEvent1Result");
    EventServer<Integer> server = new EventServer<>(options,
        (asked, state) -> state > parameter.read(asked).number("value").orElseThrow()
            ? Optional.of(new EventServer.Happening(result.bytes(Map.of("text", "more: " + state)), asked))
            : Optional.empty());
    BlockingQueue<Integer> fired = new LinkedBlockingQueue<>();
    try (server;
        EventClient client = EventClient.connect(server.address(), LINKS, (number, event) -> fired.add(number))) {
      int again = client.activate(EventMode.CONTINUOUS, parameter.bytes(Map.of("value", 20))).orElseThrow();
      int once = client.activate(EventMode.SINGLE, parameter.bytes(Map.of("value", 30))).orElseThrow();
      await("both are active", () -> server.activations() == 2);
      server.put(25);
      assertEquals(again, fired.poll(20, TimeUnit.SECONDS));
      server.put(35);
      server.put(35);
      List<Integer> more = List.of(fired.poll(20, TimeUnit.SECONDS), fired.poll(20, TimeUnit.SECONDS),
          fired.poll(20, TimeUnit.SECONDS));
      assertEquals(1, more.stream().filter(number -> number == once).count());
      client.deactivate(again);
      await("none is active", () -> server.activations() == 0);
    }
  }

  @Test
  void states_parameters_and_wirings_are_asked_for() throws Exception {
    StateSlave states = new StateSlave(types, List.of("Neutral", "Active"), state -> {});
    ParameterSlave parameters = new ParameterSlave(types, (name, values) -> name.equals("SPEED") && values.size() == 2
        ? ParameterMaster.Response.OK
        : ParameterMaster.Response.INVALID);
    WiringSlave wiring = new WiringSlave(types, Map.of("laserIn", new WiringSlave.Port() {
      @Override
      public boolean connect(String server, String service) {
        return service.equals("laser");
      }

      @Override
      public void disconnect() {
        // nothing is connected here
      }
    }));
    try (QueryServer state = new QueryServer(options, states);
        QueryServer param = new QueryServer(options, parameters);
        QueryServer wire = new QueryServer(options, wiring);
        QueryClient stateClient = QueryClient.connect(state.address(), LINKS);
        QueryClient paramClient = QueryClient.connect(param.address(), LINKS);
        QueryClient wireClient = QueryClient.connect(wire.address(), LINKS)) {
      StateMaster master = new StateMaster(stateClient, types, PATIENCE);
      assertEquals("Neutral", master.current());
      assertEquals(List.of("Neutral", "Active"), master.all());
      master.change("Active");
      assertEquals("Active", master.current());
      assertTrue(assertThrows(IOException.class, () -> master.change("Asleep")).getMessage().contains("not allowed"));
      ParameterMaster sender = new ParameterMaster(paramClient, types, PATIENCE);
      assertEquals(ParameterMaster.Response.OK, sender.send("SPEED", List.of("100", "500")));
      assertEquals(ParameterMaster.Response.INVALID, sender.send("COLOUR", List.of("red")));
      WiringMaster wires = new WiringMaster(wireClient, types, PATIENCE);
      wires.connect("laserIn", "base", "laser");
      wires.disconnect("laserIn");
      assertThrows(IOException.class, () -> wires.connect("laserIn", "base", "sonar"));
      assertThrows(IOException.class, () -> wires.connect("mapIn", "base", "laser"));
    }
  }

  /** The nonsense of one client ends its own link. */
  @Test
  void one_client_that_says_nonsense_is_left_out() throws Exception {
    try (PushServer server = new PushServer(options, Duration.ZERO)) {
      BlockingQueue<ByteBuffer> updates = new LinkedBlockingQueue<>();
      try (PushClient good = PushClient.connect(server.address(), LINKS, updates::add);
          Socket bad = new Socket("127.0.0.1", server.address().at().port())) {
        byte[] nonsense = new byte[64];
        Arrays.fill(nonsense, (byte) 0xff);
        bad.getOutputStream().write(nonsense);
        assertEquals(-1, bad.getInputStream().read());
        good.subscribe(1);
        await("it is subscribed", () -> server.subscribers() == 1);
        server.put(time(7));
        assertEquals(7, seconds(updates.poll(20, TimeUnit.SECONDS)));
      }
    }
  }
}
