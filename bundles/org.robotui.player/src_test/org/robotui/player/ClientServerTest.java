package org.robotui.player;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicReference;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.robotui.net.call.Outcome;
import org.robotui.player.client.DeviceState;
import org.robotui.player.client.LinkState;
import org.robotui.player.client.PlayerClient;
import org.robotui.player.client.PlayerDevice;
import org.robotui.player.client.Subscription;
import org.robotui.player.interfaces.AnyDevice;
import org.robotui.player.interfaces.Gains;
import org.robotui.player.interfaces.Gripper;
import org.robotui.player.interfaces.Pose2d;
import org.robotui.player.interfaces.Position2d;
import org.robotui.player.layout.Empty;
import org.robotui.player.layout.InterfaceLayout;
import org.robotui.player.layout.Layouts;
import org.robotui.player.layout.MessageLayout;
import org.robotui.player.layout.PlayerRecord;
import org.robotui.player.layout.StructLayout;
import org.robotui.player.server.Answer;
import org.robotui.player.server.DeviceHandler;
import org.robotui.player.server.PlayerServer;
import org.robotui.player.server.ServedDevice;
import org.robotui.player.server.ServerOptions;
import org.robotui.player.server.TypedHandler;
import org.robotui.player.wire.PlayerMessage;

/** Our client against our server. */
@Timeout(300)
class ClientServerTest {

  private static final Pose2d ZERO = new Pose2d(0, 0, 0);

  private final World world = new World();
  private final AtomicInteger clients = new AtomicInteger();

  @AfterEach
  void close() throws Exception {
    world.close();
  }

  static List<String> interfaces() {
    return Layouts.standard().all().stream().map(InterfaceLayout::name)
        .filter(name -> !List.of("any", "player").contains(name)).sorted()
        .toList();
  }

  /** Answers every request of its interface with zeros, and keeps what was commanded. */
  private static final class Zeros implements DeviceHandler {

    private final Layouts layouts;
    private final BlockingQueue<PlayerMessage> commands = new LinkedBlockingQueue<>();

    Zeros(Layouts layouts) {
      this.layouts = layouts;
    }

    @Override
    public void onCommand(PlayerMessage command) {
      commands.add(command);
    }

    @Override
    public Answer onRequest(PlayerMessage request) {
      return new Answer.Ack(layouts.of(request).orElseThrow().answer().map(struct -> zeros(layouts, struct))
          .orElse(ByteBuffer.allocate(0)));
    }
  }

  private static ByteBuffer zeros(Layouts layouts, StructLayout struct) {
    return layouts.encode(PlayerRecord.of(struct, Map.of()));
  }

  @ParameterizedTest
  @MethodSource("interfaces")
  void everyMessageOfEveryInterfaceTravels(String name) throws Exception {
    Zeros handler = new Zeros(world.layouts);
    PlayerServer server = world.server(0);
    ServedDevice served = server.add(name, 1, "zeros", handler);
    PlayerDevice device = world.connected(server.port()).device(name, 1);
    BlockingQueue<PlayerMessage> data = new LinkedBlockingQueue<>();
    device.subscribe((message, nanos) -> data.add(message));
    Eventually.await("it is open", () -> device.state().equals(new DeviceState.Open("zeros")));

    for (MessageLayout message : world.layouts.byName(name).orElseThrow().messages()) {
      PlayerRecord body = message.payload().map(struct -> PlayerRecord.of(struct, Map.of()))
          .orElseGet(
              () -> PlayerRecord.of(world.layouts.byName("any").orElseThrow().structs().get("switch"), Map.of()));
      switch (message.type()) {
        case DATA -> {
          served.publish(message, body, World.STAMP);
          assertEquals(body, world.layouts.decode(data.poll(60, TimeUnit.SECONDS)));
        }
        case COMMAND -> {
          assertTrue(device.command(message, body));
          assertEquals(message.subtype(), handler.commands.poll(60, TimeUnit.SECONDS).subtype());
        }
        default -> assertEquals(message.answer().map(StructLayout::name).orElse("empty"),
            World.value(device.request(message, body)).layout().name());
      }
    }
  }

  private TypedHandler base(AtomicReference<Position2d.Velocity> driven) {
    return new TypedHandler(world.layouts, clients::set)
        .on(Position2d.VELOCITY, driven::set)
        .on(Position2d.SET_ODOMETRY, pose -> Optional.of(new Empty()))
        .on(AnyDevice.GET_INT_PROPERTY, asked -> Optional.of(new AnyDevice.IntProperty(asked.key(), 42)));
  }

  @Test
  void aBaseIsDrivenAndAsked() throws Exception {
    AtomicReference<Position2d.Velocity> driven = new AtomicReference<>();
    PlayerServer server = world.server(0);
    ServedDevice served = server.add("position2d", 0, "sim", base(driven));
    PlayerClient client = world.connected(server.port());
    PlayerDevice device = client.device("position2d", 0);
    BlockingQueue<Position2d.State> states = new LinkedBlockingQueue<>();
    Position2d.Velocity forward = new Position2d.Velocity(new Pose2d(0.2, 0, 0.1), true);

    assertFalse(device.command(Position2d.VELOCITY, forward), "it is not open");
    Subscription subscription = device.subscribe(Position2d.STATE, (state, stamp, nanos) -> states.add(state));
    Eventually.await("it is open", () -> device.state() instanceof DeviceState.Open);
    Position2d.State there = new Position2d.State(new Pose2d(1, 2, 3), ZERO, true);
    served.publish(Position2d.STATE, there, World.STAMP);

    assertEquals(there, states.poll(60, TimeUnit.SECONDS));
    assertTrue(device.command(Position2d.VELOCITY, forward));
    Eventually.await("it drives", () -> forward.equals(driven.get()));
    assertEquals(new Empty(), World.value(device.request(Position2d.SET_ODOMETRY, new Position2d.Odometry(ZERO))));
    assertEquals(new AnyDevice.IntProperty("mass", 42),
        World.value(device.request(AnyDevice.GET_INT_PROPERTY, new AnyDevice.IntProperty("mass", 0))));
    assertInstanceOf(Outcome.Refused.class, World.outcome(device.request(Position2d.VELOCITY_PID, new Gains(1, 2, 3))));
    assertEquals("sim", World.value(client.driver(client.devices().getFirst())));
    assertEquals(1, clients.get());
    subscription.close();
    Eventually.await("it is closed", () -> clients.get() == 0);
    assertEquals(new DeviceState.Unused(), device.state());
  }

  @Test
  void whatIsNotThereIsRefusedOrSilent() throws Exception {
    PlayerServer server = world.server(0);
    server.add("position2d", 0, "sim", base(new AtomicReference<>()));
    PlayerClient client = world.client(server.port(),
        options -> options.withTimes(World.LONG, World.LONG, Duration.ofMillis(300), World.LONG));
    World.awaitLink(client);
    PlayerDevice gripper = client.device("gripper", 0);

    gripper.subscribe((message, nanos) -> {});
    Eventually.await("it is refused", () -> gripper.state() instanceof DeviceState.Refused);
    Outcome<?> silent = World.outcome(gripper.request(Gripper.GET_GEOMETRY, new Empty()));
    assertInstanceOf(Outcome.TimedOut.class, silent);
    assertTrue(silent.reason().contains("gripper:0") && silent.reason().contains(":" + server.port()), silent.reason());
    Outcome<?> closed = World.outcome(client.device("position2d", 0).request(Position2d.RESET_ODOMETRY, new Empty()));
    assertInstanceOf(Outcome.Refused.class, closed);
  }

  @Test
  void theKeyOpensTheServer() throws Exception {
    byte[] key = "secret".getBytes(StandardCharsets.US_ASCII);
    PlayerServer server = world.server(ServerOptions.loopback(world.threads, 0, () -> 0).withKey(key));

    PlayerClient stranger = world.client(server.port());
    Eventually.await("the stranger is refused",
        () -> stranger.state() instanceof LinkState.Failed failed && failed.reason().contains("key"));
    PlayerClient wrong = world.client(server.port(), options -> options.withKey(new byte[]{1}));
    Eventually.await("the wrong key is refused",
        () -> wrong.state() instanceof LinkState.Failed failed && failed.reason().contains("key"));
    World.awaitLink(world.client(server.port(), options -> options.withKey(key)));
  }

  @Test
  void dataAreFetchedAndOnlyTheNewestCome() throws Exception {
    PlayerServer server = world.server(0);
    ServedDevice served = server.add("position2d", 0, "sim", base(new AtomicReference<>()));
    PlayerClient client = world.client(server.port(), options -> options.withPull(Duration.ofMillis(500)));
    BlockingQueue<Double> seen = new LinkedBlockingQueue<>();
    client.device("position2d", 0).subscribe(Position2d.STATE, (state, stamp, nanos) -> seen.add(state.position().x()));
    Eventually.await("it is open", () -> clients.get() == 1);

    int sent = 0;
    // many are published between two fetches, one for each at most arrives
    while (seen.size() < 3) {
      sent++;
      served.publish(Position2d.STATE, new Position2d.State(new Pose2d(sent, 0, 0), ZERO, false), sent);
      Thread.onSpinWait();
    }

    assertTrue(seen.size() < sent, seen.size() + " of " + sent);
    assertEquals(seen.stream().sorted().toList(), List.copyOf(seen));
  }

  @Test
  void theLinkIsMadeAnewWhenTheServerReturns() throws Exception {
    PlayerServer first = world.server(0);
    first.add("position2d", 0, "first", base(new AtomicReference<>()));
    int port = first.port();
    PlayerClient client = world.client(port);
    PlayerDevice device = client.device("position2d", 0);
    device.subscribe((message, nanos) -> {});
    Eventually.await("it is open", () -> device.state().equals(new DeviceState.Open("first")));

    first.close();
    Eventually.await("the link is lost", () -> client.state() instanceof LinkState.Failed);
    LinkState.Failed lost =
        (LinkState.Failed) world.links.stream().filter(LinkState.Failed.class::isInstance).findFirst().orElseThrow();
    assertTrue(lost.reason().startsWith("127.0.0.1:" + port), lost.reason());
    assertEquals(new DeviceState.Waiting(), device.state());
    assertInstanceOf(Outcome.Failed.class, World.outcome(device.request(Position2d.RESET_ODOMETRY, new Empty())));
    assertFalse(device.command(Position2d.VELOCITY, new Position2d.Velocity(ZERO, true)));

    world.server(port).add("position2d", 0, "second", base(new AtomicReference<>()));
    Eventually.await("it is open again", () -> device.state().equals(new DeviceState.Open("second")));
  }

  @Test
  void ofCommandsThatWaitTheNewestGoes() throws Exception {
    CountDownLatch stuck = new CountDownLatch(1);
    AtomicReference<Position2d.Velocity> driven = new AtomicReference<>();
    PlayerServer server = world.server(0);
    server.add("position2d", 0, "slow",
        new TypedHandler(world.layouts, clients::set).on(Position2d.VELOCITY, velocity -> {
          await(stuck);
          driven.set(velocity);
        }));
    PlayerClient client = world.connected(server.port());
    PlayerDevice device = client.device("position2d", 0);
    device.subscribe((message, nanos) -> {});
    Eventually.await("it is open", () -> device.state() instanceof DeviceState.Open);

    int sent = 0;
    while (client.replacedCommands() < 100) {
      sent++;
      assertTrue(device.command(Position2d.VELOCITY, new Position2d.Velocity(new Pose2d(sent, 0, 0), true)));
    }
    Position2d.Velocity stop = new Position2d.Velocity(ZERO, true);
    assertTrue(device.command(Position2d.VELOCITY, stop));
    stuck.countDown();
    Eventually.await("the stop arrives last", () -> stop.equals(driven.get()));
  }

  private static void await(CountDownLatch latch) {
    try {
      latch.await();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  @Test
  void whatWasCommandedLastIsSentWhenTheClientCloses() throws Exception {
    AtomicReference<Position2d.Velocity> driven = new AtomicReference<>();
    PlayerServer server = world.server(0);
    server.add("position2d", 0, "sim", base(driven));
    PlayerClient client = world.connected(server.port());
    PlayerDevice device = client.device("position2d", 0);
    device.subscribe((message, nanos) -> {});
    Eventually.await("it is open", () -> device.state() instanceof DeviceState.Open);

    Position2d.Velocity stop = new Position2d.Velocity(ZERO, false);
    assertTrue(device.command(Position2d.VELOCITY, stop));
    client.close();

    Eventually.await("it stops", () -> stop.equals(driven.get()));
    Eventually.await("the device is closed", () -> clients.get() == 0);
    assertEquals(new LinkState.Closed(), client.state());
  }
}
