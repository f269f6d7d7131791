package org.robotui.sim;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.net.Socket;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.Test;
import org.robotui.player.layout.Layouts;
import org.robotui.player.wire.DeviceAddress;
import org.robotui.player.wire.Framing;
import org.robotui.player.wire.MessageType;
import org.robotui.player.wire.PlayerException;
import org.robotui.player.wire.PlayerMessage;

/**
 * What stock clients said to a real server, said to ours: answers must be of the same kinds, and so must be the data.
 * What they said to devices that our robots do not have, or to a driver that refuses everything, is left out.
 */
class RecordedPlayerClientsTest {
  private static final long PATIENCE_SECONDS = 20;
  private static final int ACCESS = 3;
  private static final int DRIVER = 2;
  private static final int OPEN = 1;
  private static final int ADDRESS_INTERFACE = 8;
  private static final int ADDRESS_INDEX = 12;
  private static final int ADDRESS_ACCESS = 16;

  private final Layouts layouts = Layouts.standard();
  private final List<AutoCloseable> open = new ArrayList<>();
  private final BlockingQueue<PlayerMessage> received = new LinkedBlockingQueue<>();
  private final Set<String> data = new TreeSet<>();

  @AfterEach
  void end() throws Exception {
    for (AutoCloseable each : open.reversed()) {
      each.close();
    }
  }

  @Test
  void theBaseAnswersAndDrivesAsRecorded() throws Exception {
    assertEquals(Set.of("position2d:0 1"), replay("natalie", "position2d", Set.of()));
  }

  @Test
  void mistakesAreRefusedAsRecorded() throws Exception {
    replay("natalie", "errors", Set.of());
  }

  /** Stage gives intensities as well. */
  @Test
  void rangersAndLaserAnswerAsRecorded() throws Exception {
    assertEquals(Set.of("laser:0 1", "ranger:0 1", "ranger:1 1"), replay("natalie", "rangers", Set.of()));
  }

  @Test
  void dataAreFetchedAsRecorded() throws Exception {
    assertEquals(Set.of("laser:0 1", "position2d:0 1"), replay("natalie", "two_devices_pull", Set.of()));
  }

  @Test
  void bumpersTellAsRecorded() throws Exception {
    assertEquals(Set.of("bumper:0 1", "position2d:0 1"), replay("keira", "bumper", Set.of()));
  }

  /** The map is the only one of these devices that answered. */
  @Test
  void theMapAnswersAsRecorded() throws Exception {
    Set<String> sent = replay("natalie", "dummy_devices", Set.of("ptz"));
    assertTrue(sent.containsAll(Set.of("imu:0 1", "laser:0 1", "position2d:0 1", "power:0 1", "ptz:0 1")),
        sent.toString());
  }

  @Test
  void theCameraSendsAsRecorded() throws Exception {
    assertEquals(Set.of("camera:0 1"), replay("keira", "dummy_camera", Set.of("camera")));
  }

  /**
   * Says it all again.
   *
   * @param differs interfaces of which requests are left out
   * @return the kinds of data that came
   */
  private Set<String> replay(String robot, String session, Set<String> differs) throws Exception {
    List<PlayerMessage> said = messages(session + ".c2s.bin", 0);
    Map<String, Deque<MessageType>> answers = answers(messages(session + ".s2c.bin", PlayerMessage.BANNER_BYTES));
    Demo demo = Demo.start(Options.parse(List.of("--robot", robot, "--speak", "player", "--speed-factor", "10")));
    open.add(demo);
    Socket socket = new Socket("127.0.0.1", Integer.parseInt(demo.addresses().get("PLAYER_PORT")));
    open.add(socket);
    Framing.readBanner(socket.getInputStream());
    Thread.ofPlatform().daemon().start(() -> receive(socket));
    Set<String> ours = devices(socket);
    for (PlayerMessage message : said) {
      Optional<MessageType> recorded = Optional.ofNullable(answers.get(key(message))).map(Deque::poll);
      if (message.type() == MessageType.REQUEST && isComparable(message, recorded, ours, differs)) {
        send(socket, message);
        assertEquals(recorded, answer(message, recorded.isPresent()),
            () -> session + ": the answer to " + what(message));
        awaitData(message, recorded);
      } else if (message.type() == MessageType.COMMAND) {
        send(socket, message);
      }
    }
    return data;
  }

  /** What was refused because it was not there must be refused here, too; what was there may be missing here. */
  private boolean isComparable(PlayerMessage message, Optional<MessageType> recorded, Set<String> ours,
      Set<String> differs) {
    String device = subject(message);
    boolean direct = message.device().interfaceCode() != DeviceAddress.SERVER;
    boolean has = ours.contains(device) || device.startsWith("player");
    boolean wasAbsent = recorded.isEmpty() || recorded.get() == MessageType.NACK && !direct;
    return (has || wasAbsent) && !(direct && differs.contains(device.replaceAll(":.*", "")));
  }

  /** The device that a message is about. */
  private String subject(PlayerMessage message) {
    if (message.device().interfaceCode() != DeviceAddress.SERVER
        || message.subtype() != ACCESS && message.subtype() != DRIVER) {
      return layouts.nameOf(message.device());
    }
    ByteBuffer address = message.payload();
    return layouts.nameOf(new DeviceAddress(0, 0, address.getInt(ADDRESS_INTERFACE), address.getInt(ADDRESS_INDEX)));
  }

  private String what(PlayerMessage message) {
    return message + " about " + subject(message);
  }

  private static String key(PlayerMessage message) {
    return message.device().interfaceCode() + ":" + message.device().index() + " " + message.subtype();
  }

  private static Map<String, Deque<MessageType>> answers(List<PlayerMessage> messages) {
    Map<String, Deque<MessageType>> answers = new HashMap<>();
    for (PlayerMessage message : messages) {
      if (message.type() == MessageType.ACK || message.type() == MessageType.NACK) {
        answers.computeIfAbsent(key(message), none -> new ArrayDeque<>()).add(message.type());
      }
    }
    return answers;
  }

  private Set<String> devices(Socket socket) throws Exception {
    PlayerMessage list = PlayerMessage.empty(new DeviceAddress(0, 0, DeviceAddress.SERVER, 0), MessageType.REQUEST, 1);
    send(socket, list);
    ByteBuffer answer = await(list).payload();
    Set<String> names = new TreeSet<>();
    for (answer.position(2 * Integer.BYTES); answer.hasRemaining();) {
      names.add(layouts.nameOf(new DeviceAddress(answer.getInt(), answer.getInt(), answer.getInt(), answer.getInt())));
    }
    return names;
  }

  private static void send(Socket socket, PlayerMessage message) throws IOException {
    ByteBuffer bytes = Framing.bytes(message);
    byte[] all = new byte[bytes.remaining()];
    bytes.get(all);
    socket.getOutputStream().write(all);
  }

  private void receive(Socket socket) {
    try (InputStream in = socket.getInputStream()) {
      while (true) {
        received.add(Framing.read(in));
      }
    } catch (IOException | PlayerException e) {
      // the test ends
    }
  }

  private Optional<MessageType> answer(PlayerMessage question, boolean expected) throws InterruptedException {
    return expected ? Optional.of(await(question).type()) : poll(question, 200);
  }

  private PlayerMessage await(PlayerMessage question) throws InterruptedException {
    while (true) {
      PlayerMessage next = received.poll(PATIENCE_SECONDS, TimeUnit.SECONDS);
      assertTrue(next != null, () -> "no answer to " + what(question));
      note(next);
      if ((next.type() == MessageType.ACK || next.type() == MessageType.NACK) && key(next).equals(key(question))) {
        return next;
      }
    }
  }

  /** That nothing is said needs a while. */
  private Optional<MessageType> poll(PlayerMessage question, long millis) throws InterruptedException {
    long end = System.nanoTime() + TimeUnit.MILLISECONDS.toNanos(millis);
    for (PlayerMessage next = until(end); next != null; next = until(end)) {
      note(next);
      if (next.type() != MessageType.DATA && key(next).equals(key(question))) {
        return Optional.of(next.type());
      }
    }
    return Optional.empty();
  }

  private PlayerMessage until(long end) throws InterruptedException {
    return received.poll(Math.max(0, end - System.nanoTime()), TimeUnit.NANOSECONDS);
  }

  private void note(PlayerMessage message) {
    if (message.type() == MessageType.DATA) {
      data.add(layouts.nameOf(message.device()) + " " + message.subtype());
    }
  }

  /** A device that was opened sends something, unless it is one that is only asked. */
  private void awaitData(PlayerMessage message, Optional<MessageType> answer) throws InterruptedException {
    boolean opened = message.subtype() == ACCESS && message.device().interfaceCode() == DeviceAddress.SERVER
        && answer.equals(Optional.of(MessageType.ACK)) && message.payload().getInt(ADDRESS_ACCESS) == OPEN;
    String device = subject(message);
    while (opened && !device.startsWith("map") && data.stream().noneMatch(kind -> kind.startsWith(device))) {
      PlayerMessage next = received.poll(PATIENCE_SECONDS, TimeUnit.SECONDS);
      assertTrue(next != null, () -> "no data of " + device);
      note(next);
    }
  }

  private static List<PlayerMessage> messages(String name, int skip) throws IOException, PlayerException {
    Path file = recordings().resolve(name);
    ByteArrayInputStream in = new ByteArrayInputStream(Files.readAllBytes(file));
    in.skip(skip);
    List<PlayerMessage> all = new ArrayList<>();
    while (in.available() > 0) {
      all.add(Framing.read(in));
    }
    return all;
  }

  private static Path recordings() {
    Path root = Path.of(Optional.ofNullable(System.getenv("ROBOTUI_SHARED")).orElse("../../../shared"));
    Path folder = root.resolve("captures/player");
    Assumptions.assumeTrue(Files.isDirectory(folder),
        folder + " is not there: set ROBOTUI_SHARED to the folder of recordings");
    return folder;
  }
}
