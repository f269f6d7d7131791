package org.robotui.roboframe;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.InetAddress;
import java.net.Socket;
import java.net.SocketException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.HexFormat;
import java.util.List;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.robotui.message.roboframe.PictureStreamable;
import org.robotui.message.roboframe.VelocityStreamable;
import org.robotui.net.socket.HostPort;
import org.robotui.roboframe.board.Blackboard;
import org.robotui.roboframe.board.ChannelKey;
import org.robotui.roboframe.board.Connector;
import org.robotui.roboframe.board.KeyOutput;
import org.robotui.roboframe.board.Posted;
import org.robotui.roboframe.board.KeyUse;
import org.robotui.roboframe.board.Router;
import org.robotui.roboframe.link.BrokerLink;
import org.robotui.roboframe.link.BrokerListener;
import org.robotui.roboframe.link.BrokerOptions;
import org.robotui.roboframe.wire.BoardKey;
import org.robotui.roboframe.wire.BrokerFraming;
import org.robotui.roboframe.wire.BrokerMessage;
import org.robotui.testkit.ByteMutator;
import org.robotui.testkit.Effort;

/** Peers that lie, flood or do not read hurt themselves only. */
class HostileBrokersTest {
  private static final ChannelKey<VelocityStreamable> VELOCITY = ChannelKey.of("velocity", VelocityStreamable.class);
  private static final ChannelKey<PictureStreamable> PICTURE = ChannelKey.of("picture", PictureStreamable.class);
  private static final BrokerFraming FRAMES = new BrokerFraming();
  private static final byte[] HELLO = FRAMES.bytes(new BrokerMessage.Hello(BrokerFraming.VERSION, "evil"));

  private final Blackboard robot = new Blackboard();
  private final Queue<Posted<VelocityStreamable>> driven = new ConcurrentLinkedQueue<>();
  private Router router;
  private KeyUse drive;

  @BeforeEach
  void open() throws IOException {
    router = new Router(robot, "robot", List.of(Connector.parse("listen:0")), BrokerWaiting.THREADS);
    drive = robot.request(VELOCITY, "drive", driven::add);
  }

  @AfterEach
  void close() {
    drive.close();
    router.close();
  }

  private Socket evil(byte[]... said) throws IOException {
    Socket socket = new Socket(InetAddress.getLoopbackAddress(), router.ports().getFirst());
    for (byte[] each : said) {
      socket.getOutputStream().write(each);
    }
    return socket;
  }

  /** All that still comes is taken: what ends the link is the other side. */
  private static void ends(Socket socket) throws IOException {
    socket.setSoTimeout(30_000);
    try {
      while (socket.getInputStream().read() >= 0) {
        // its greeting and its board
      }
    } catch (SocketException e) {
      assertTrue(socket.isConnected(), "it was reset");
    }
  }

  /** Somebody who behaves is served as ever. */
  private void others() throws Exception {
    Blackboard gui = new Blackboard();
    try (KeyOutput<VelocityStreamable> stick = gui.advertise(VELOCITY, "stick");
        Router other = new Router(gui, "gui",
            List.of(new Connector.Connect(new HostPort("localhost", router.ports().getFirst()))),
            BrokerWaiting.THREADS)) {
      driven.clear();
      BrokerWaiting.until("a value of who behaves", () -> {
        stick.push(new VelocityStreamable(1, 0, 0));
        return driven.stream().anyMatch(each -> each.from().equals("gui"));
      });
    }
  }

  private static byte[] frame(int length, int... bytes) {
    ByteBuffer out = ByteBuffer.allocate(Integer.BYTES + bytes.length).order(ByteOrder.LITTLE_ENDIAN).putInt(length);
    for (int each : bytes) {
      out.put((byte) each);
    }
    return out.array();
  }

  @Test
  void lies_about_lengths_end_the_link() throws Exception {
    for (byte[] lie : List.of(frame(-1), frame(Integer.MAX_VALUE), frame(0), frame(1, 99),
        frame(5, 1, 255, 255, 255, 127),
        frame(9, 1, 1, 0, 0, 0, 255, 255, 255, 127), frame(5, 2, 200, 0, 0, 0), frame(3, 3, 0, 0))) {
      try (Socket socket = evil(HELLO, lie)) {
        ends(socket);
      }
    }
    others();
  }

  @ParameterizedTest
  @ValueSource(strings = {"GET / HTTP/1.1\r\n\r\n", "\0\0\0\0\0\0\0\0"})
  void who_speaks_something_else_is_not_listened_to(String said) throws Exception {
    try (Socket socket = evil(said.getBytes(StandardCharsets.ISO_8859_1))) {
      ends(socket);
    }
    others();
  }

  @Test
  void who_does_not_say_who_it_is_is_given_up() throws Exception {
    try (Socket silent = evil(); Socket first = evil(FRAMES.bytes(new BrokerMessage.Ping(1)))) {
      ends(first);
      ends(silent);
    }
    others();
  }

  @Test
  void values_that_cannot_be_read_are_counted() throws Exception {
    try (Socket socket = evil(HELLO, value("velocity", new byte[7]), value("nobody", new byte[7]))) {
      BrokerWaiting.until("a count", () -> router.unreadable() == 1);
      socket.getOutputStream().write(value("velocity", new byte[24]));
      BrokerWaiting.until("what can be read", () -> driven.size() == 1);
    }
  }

  private static byte[] value(String key, byte[] bytes) {
    return FRAMES.bytes(new BrokerMessage.Value(key, 1, 1, ByteBuffer.wrap(bytes)));
  }

  @Test
  void a_flood_does_not_keep_others_from_being_heard() throws Exception {
    try (Socket socket = evil(HELLO)) {
      Thread flood = BrokerWaiting.THREADS.newThread(() -> {
        byte[] one = value("velocity", new byte[24]);
        try {
          while (true) {
            socket.getOutputStream().write(one);
          }
        } catch (IOException e) {
          return; // the test is over
        }
      });
      flood.start();
      BrokerWaiting.until("the flood", () -> driven.size() > 1000);
      others();
      socket.close();
      flood.join(30_000);
    }
  }

  /** Of each key one picture waits at most, beside what the kernel holds. */
  @Test
  void who_does_not_read_costs_one_value_of_each_key() throws Exception {
    BoardKey wanted = new BoardKey("picture", PICTURE.codec().info().type(), PICTURE.codec().info().md5(), "",
        List.of(), List.of("evil"));
    AtomicLong taken = new AtomicLong();
    try (Socket socket = evil(HELLO, FRAMES.bytes(new BrokerMessage.Board(List.of(wanted))));
        KeyOutput<PictureStreamable> pictures = robot.advertise(PICTURE, "camera");
        BrokerLink reading = BrokerLink.connect(new HostPort("localhost", router.ports().getFirst()),
            new BrokerOptions("gui", BrokerWaiting.THREADS, Duration.ofSeconds(30), false), counting(taken))) {
      reading.say(List.of(wanted));
      ByteBuffer big = ByteBuffer.allocate(2 << 20);
      for (int i = 0; i < 50; i++) { // 100 MB, were they kept
        pictures.push(new PictureStreamable(i, "camera", "jpeg", big));
        saysThatItIsThere(socket);
      }
      BrokerWaiting.until("a picture at who reads", () -> {
        saysThatItIsThere(socket);
        return taken.get() == 49;
      });
      assertEquals(2, router.applications().size(), "who does not read is still linked: " + socket);
    }
  }

  /** Who says nothing for ten seconds is given up, which a busy machine needs for a hundred megabytes. */
  private static void saysThatItIsThere(Socket socket) {
    try {
      socket.getOutputStream().write(FRAMES.bytes(new BrokerMessage.Ping(1)));
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private static BrokerListener counting(AtomicLong taken) {
    return new BrokerListener() {
      @Override
      public void board(BrokerLink link, List<BoardKey> keys) {}

      @Override
      public void value(BrokerLink link, BrokerMessage.Value value) {
        taken.set(value.count());
      }

      @Override
      public void ended(BrokerLink link, String reason) {}
    };
  }

  @Test
  void the_wire_is_as_it_is_described() throws IOException {
    byte[] hello = FRAMES.bytes(new BrokerMessage.Hello(1, "gui"));
    assertEquals("0e000000" + "00" + "52424652" + "0100" + "03000000677569", HexFormat.of().formatHex(hello));
    byte[] value = FRAMES.bytes(new BrokerMessage.Value("k", 2, 3, ByteBuffer.wrap(new byte[]{9})));
    assertEquals("17000000" + "02" + "010000006b" + "0200000000000000" + "0300000000000000" + "09",
        HexFormat.of().formatHex(value));
    BoardKey key = new BoardKey("k", "t", "s", "d", List.of("w"), List.of());
    byte[] board = FRAMES.bytes(new BrokerMessage.Board(List.of(key)));
    assertEquals("26000000" + "01" + "01000000" + "010000006b" + "0100000074" + "0100000073" + "0100000064"
        + "01000000" + "0100000077" + "00000000", HexFormat.of().formatHex(board));
    for (byte[] each : List.of(hello, value, board)) {
      assertArrayEquals(each, FRAMES.bytes(FRAMES.read(new ByteArrayInputStream(each))));
    }
    byte[] newer = hello.clone();
    newer[9] = 2;
    IOException e = assertThrows(IOException.class, () -> FRAMES.read(new ByteArrayInputStream(newer)));
    assertEquals("the application speaks version 2 of the wire, here it is 1", e.getMessage());
  }

  @Test
  void damaged_frames_are_refused_or_read() {
    byte[] board = FRAMES.bytes(new BrokerMessage.Board(List.of(new BoardKey("picture", "roboframe/Picture", "sum",
        "time stamp\n", List.of("camera"), List.of("view", "log")))));
    ByteMutator mutator = new ByteMutator(2026 + Effort.seed());
    int refused = 0;
    for (Effort effort = Effort.of(2000, Duration.ofSeconds(20)); effort.goesOn();) {
      try {
        FRAMES.read(new ByteArrayInputStream(mutator.mutate(board)));
      } catch (IOException e) {
        refused++;
      }
    }
    assertTrue(refused > 0, "some damages matter");
  }
}
