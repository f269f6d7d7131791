package org.robotui.player;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.robotui.net.call.Outcome;
import org.robotui.player.client.DeviceState;
import org.robotui.player.client.PlayerClient;
import org.robotui.player.client.PlayerDevice;
import org.robotui.player.client.Subscription;
import org.robotui.player.interfaces.Server;
import org.robotui.player.layout.MessageLayout;
import org.robotui.player.layout.PlayerRecord;
import org.robotui.player.wire.DeviceAddress;
import org.robotui.player.wire.DeviceId;
import org.robotui.player.wire.MessageType;
import org.robotui.player.wire.PlayerException;
import org.robotui.player.wire.PlayerMessage;

/** Our client does what a recorded client did, and a recorded server finds no difference and is understood. */
@Timeout(300)
class ReplayTest {

  private static final int OPEN = 1;

  private final World world = new World();
  private final Map<DeviceId, Subscription> open = new HashMap<>();
  private final AtomicInteger data = new AtomicInteger();

  @AfterEach
  void close() throws Exception {
    world.close();
  }

  static List<String> connections() {
    return Captures.NAMES;
  }

  @ParameterizedTest
  @MethodSource("connections")
  void theRecordedServerIsAskedAsItExpects(String connection) throws Exception {
    Recording recording = Recording.of(connection);
    ReplayServer server = world.closing(new ReplayServer(recording, world.layouts, world.threads));
    PlayerClient client = world.connected(server.port());

    int turn = 0;
    long expected = 0;
    for (Recording.Turn each : recording.turns()) {
      say(client, each);
      turn++;
      int over = turn;
      Eventually.await("turn " + turn + " of " + connection + " is over, " + server.differences(),
          () -> server.played() >= over
              || !server.differences().isEmpty());
      assertEquals(List.of(), server.differences());
      expected += each.followed().stream()
          .filter(message -> message.type() == MessageType.DATA && open.containsKey(message.device().id()))
          .count();
      long all = expected;
      Eventually.await("all data of turn " + turn + " of " + connection + " came", () -> data.get() >= all);
    }
    assertEquals(expected, data.get());
  }

  private void say(PlayerClient client, Recording.Turn turn) throws PlayerException {
    PlayerMessage said = turn.said();
    boolean toServer = said.device().interfaceCode() == DeviceAddress.SERVER;
    if (toServer && said.subtype() == 1) {
      return;
    }
    if (toServer && said.subtype() == world.layouts.message(Server.ACCESS).subtype()) {
      access(client, turn, world.layouts.question(Server.ACCESS).decode(said.payload()));
    } else if (said.type() == MessageType.COMMAND) {
      assertTrue(
          client.device(said.device().id()).command(world.layouts.of(said).orElseThrow(), world.layouts.decode(said)),
          said.toString());
    } else {
      answered(turn, ask(client.device(said.device().id()), said));
    }
  }

  private CompletableFuture<? extends Outcome<?>> ask(PlayerDevice device, PlayerMessage said) throws PlayerException {
    Optional<MessageLayout> known = world.layouts.of(said);
    PlayerRecord question = world.layouts.decode(said);
    return known.isPresent() ? device.request(known.get(), question) : device.request(said.subtype(), said.payload());
  }

  private void access(PlayerClient client, Recording.Turn turn, Server.Access asked) throws PlayerException {
    DeviceId id = new DeviceId(asked.device().interfaceCode(), asked.device().index());
    PlayerDevice device = client.device(id);
    if (asked.mode() == OPEN) {
      open.put(id, device.subscribe((message, nanos) -> data.incrementAndGet()));
      boolean refused = answer(turn).orElseThrow().type() == MessageType.NACK;
      Class<? extends DeviceState> expected = refused ? DeviceState.Refused.class : DeviceState.Open.class;
      Eventually.await(device.name() + " is " + expected.getSimpleName(), () -> expected.isInstance(device.state()));
    } else if (open.containsKey(id)) {
      open.remove(id).close();
    } else {
      answered(turn, ask(client.server(), turn.said()));
    }
  }

  private static Optional<PlayerMessage> answer(Recording.Turn turn) {
    PlayerMessage said = turn.said();
    return turn.followed().stream().filter(each -> each.type() == MessageType.ACK || each.type() == MessageType.NACK)
        .filter(each -> each.device().id().equals(said.device().id()) && each.subtype() == said.subtype()).findFirst();
  }

  /** What the real server did not answer is not waited for. */
  private static <T extends Outcome<?>> void answered(Recording.Turn turn, CompletableFuture<T> future) {
    answer(turn).ifPresent(answer -> {
      Eventually.await(turn.said() + " is answered", future::isDone);
      assertEquals(answer.type() == MessageType.ACK, future.join() instanceof Outcome.Done<?>,
          () -> turn.said() + ": " + future.join());
    });
  }
}
