package org.robotui.rfic.player.internal;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.locks.LockSupport;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import org.robotui.player.interfaces.Server;
import org.robotui.player.layout.Layouts;
import org.robotui.player.wire.DeviceAddress;
import org.robotui.player.wire.DeviceId;
import org.robotui.player.wire.Framing;
import org.robotui.player.wire.MessageType;
import org.robotui.player.wire.PlayerException;
import org.robotui.player.wire.PlayerMessage;
import org.robotui.testkit.recorded.SharedData;

/**
 * A server that says what a real one was recorded to say: its answers to the same questions, in their order and then
 * again from the first, and the data of devices that are open, again and again. What was never asked of the real one is
 * refused.
 */
final class RecordedRobot implements AutoCloseable {
  static final List<String> NAMES =
      List.of("position2d", "errors", "rangers", "two_devices_pull", "simulation_map_properties", "log",
          "bumper", "everything_robot0", "everything_robot1", "dummy_devices", "dummy_camera");
  private static final long PAUSE_NANOS = 1_000_000;
  private static final int OPEN = 1;

  private record Question(DeviceId device, int subtype) {}

  private final Layouts layouts;
  private final List<PlayerMessage> said;
  private final List<DeviceAddress> devices;
  private final Map<Question, List<PlayerMessage>> answers = new HashMap<>();
  private final Set<DeviceId> open = ConcurrentHashMap.newKeySet();
  private final UnaryOperator<byte[]> network;
  private final ServerSocket listening = new ServerSocket(0, 5, InetAddress.getLoopbackAddress());
  private volatile boolean closed;

  /** What the network makes of each message. */
  RecordedRobot(String name, Layouts layouts, UnaryOperator<byte[]> network) throws IOException {
    this.layouts = layouts;
    this.network = network;
    this.said = messages(name + ".s2c.bin", PlayerMessage.BANNER_BYTES);
    said.stream().filter(m -> m.type() == MessageType.ACK || m.type() == MessageType.NACK)
        .forEach(
            m -> answers.computeIfAbsent(new Question(m.device().id(), m.subtype()), q -> new ArrayList<>()).add(m));
    this.devices = Stream.concat(said.stream(), messages(name + ".c2s.bin", 0).stream()).map(PlayerMessage::device)
        .filter(d -> d.interfaceCode() != DeviceAddress.SERVER).distinct().toList();
    PlayerRficCase.DAEMONS.newThread(this::serve).start();
  }

  static boolean available() {
    return SharedData.available() && Files.isReadable(SharedData.capture("player/position2d.s2c.bin"));
  }

  private static List<PlayerMessage> messages(String file, int banner) {
    try {
      ByteArrayInputStream in = new ByteArrayInputStream(Files.readAllBytes(SharedData.capture("player/" + file)));
      in.skip(banner);
      List<PlayerMessage> messages = new ArrayList<>();
      while (in.available() > 0) {
        messages.add(Framing.read(in));
      }
      return messages;
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    } catch (PlayerException e) {
      throw new AssertionError(e);
    }
  }

  int port() {
    return listening.getLocalPort();
  }

  /** The kinds of data that it has, as device and number. */
  Map<String, List<Integer>> data() {
    Map<String, List<Integer>> kinds = new HashMap<>();
    said.stream().filter(m -> m.type() == MessageType.DATA).forEach(m -> {
      List<Integer> numbers = kinds.computeIfAbsent(layouts.nameOf(m.device()), d -> new ArrayList<>());
      if (!numbers.contains(m.subtype())) {
        numbers.add(m.subtype());
      }
    });
    return kinds;
  }

  private void serve() {
    while (!closed) {
      try (Socket client = listening.accept()) {
        open.clear();
        write(client, Framing.banner("3.1.1-dev"));
        PlayerRficCase.DAEMONS.newThread(() -> play(client)).start();
        while (true) {
          hear(client, Framing.read(client.getInputStream()));
        }
      } catch (IOException | PlayerException e) {
        // the client has gone, or will come again
      }
    }
  }

  private void play(Socket client) {
    try {
      while (!client.isClosed() && !closed) {
        for (PlayerMessage message : said) {
          if (message.type() == MessageType.DATA && open.contains(message.device().id())) {
            write(client, Framing.bytes(message));
            LockSupport.parkNanos(PAUSE_NANOS);
          }
        }
        LockSupport.parkNanos(PAUSE_NANOS);
      }
    } catch (IOException e) {
      // the client has gone
    }
  }

  private void hear(Socket client, PlayerMessage message) throws IOException, PlayerException {
    if (message.type() != MessageType.REQUEST) {
      return;
    }
    boolean server = message.device().interfaceCode() == DeviceAddress.SERVER;
    if (server && message.subtype() == layouts.message(Server.DEVICES).subtype()) {
      List<Server.Device> listed = devices.stream().map(d -> new Server.Device(Integer.toUnsignedLong(d.host()),
          Integer.toUnsignedLong(d.robot()), d.interfaceCode(), d.index())).toList();
      answer(client, message, MessageType.ACK, layouts.answer(Server.DEVICES).encode(new Server.DeviceList(listed)));
    } else if (server && message.subtype() == layouts.message(Server.ACCESS).subtype()) {
      access(client, message);
    } else {
      List<PlayerMessage> known =
          answers.getOrDefault(new Question(message.device().id(), message.subtype()), new ArrayList<>());
      Optional<PlayerMessage> next = known.isEmpty() ? Optional.empty() : Optional.of(known.removeFirst());
      next.ifPresent(known::add);
      MessageType type = next.map(PlayerMessage::type).orElse(MessageType.NACK);
      answer(client, message, type, next.map(PlayerMessage::payload).orElseGet(() -> ByteBuffer.allocate(0)));
    }
  }

  private void access(Socket client, PlayerMessage message) throws IOException, PlayerException {
    Server.Access asked = layouts.question(Server.ACCESS).decode(message.payload());
    DeviceId id = new DeviceId(asked.device().interfaceCode(), asked.device().index());
    boolean refused = said.stream().filter(m -> m.type() == MessageType.NACK && m.device().id().equals(DeviceId.SERVER)
        && m.subtype() == message.subtype()).anyMatch(m -> isOf(m, id));
    Server.Access granted =
        new Server.Access(asked.device(), refused ? OPEN + 2 : asked.mode(), refused ? "" : "recorded");
    answer(client, message, refused ? MessageType.NACK : MessageType.ACK,
        layouts.answer(Server.ACCESS).encode(granted));
    if (asked.mode() == OPEN && !refused) {
      open.add(id);
    } else {
      open.remove(id);
    }
  }

  private boolean isOf(PlayerMessage access, DeviceId id) {
    try {
      Server.Device device = layouts.answer(Server.ACCESS).decode(access.payload()).device();
      return device.interfaceCode() == id.interfaceCode() && device.index() == id.index();
    } catch (PlayerException e) {
      throw new AssertionError(e);
    }
  }

  private void answer(Socket client, PlayerMessage asked, MessageType type, ByteBuffer payload) throws IOException {
    boolean server = asked.device().interfaceCode() == DeviceAddress.SERVER;
    PlayerMessage answer = PlayerMessage.of(asked.device(), type, asked.subtype(), payload);
    write(client, Framing.bytes(server ? answer.withSequence(asked.sequence()) : answer));
  }

  private void write(Socket client, ByteBuffer frame) throws IOException {
    byte[] bytes = new byte[frame.remaining()];
    frame.get(bytes);
    byte[] sent = network.apply(bytes);
    synchronized (this) {
      client.getOutputStream().write(sent);
    }
  }

  @Override
  public void close() throws IOException {
    closed = true;
    listening.close();
  }
}
