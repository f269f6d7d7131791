package org.robotui.yarp;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.Optional;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.robotui.net.socket.HostPort;
import org.robotui.net.thread.Workers;
import org.robotui.testkit.ByteMutator;
import org.robotui.testkit.Effort;
import org.robotui.yarp.bottle.Bottle;
import org.robotui.yarp.bottle.YarpFormatException;
import org.robotui.yarp.bottle.YarpValue;
import org.robotui.yarp.port.MjpegStream;
import org.robotui.yarp.port.PortArrival;
import org.robotui.yarp.port.PortOptions;
import org.robotui.yarp.port.PortReader;
import org.robotui.yarp.wire.MjpegFraming;
import org.robotui.yarp.wire.YarpStamp;

/** Pictures as the carrier mjpeg says them. */
@Timeout(60)
class MjpegTest {
  private static final PortOptions OPTIONS = PortOptions.of(Thread.ofPlatform().daemon().factory());
  private static final int ROUNDS = 1_000;
  private static final Duration LONG = Duration.ofSeconds(20);

  private final BlockingQueue<PortArrival> heard = new LinkedBlockingQueue<>();
  private final BlockingQueue<String> ended = new LinkedBlockingQueue<>();

  /** The beginning of a file, with an envelope as YARP writes it. */
  private static byte[] picture(String envelope) {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    out.writeBytes(new byte[]{-1, (byte) 0xd8, -1, (byte) 0xe0, 0, 4, 1, 2});
    byte[] text = (envelope + "\0").getBytes(StandardCharsets.US_ASCII);
    out.writeBytes(new byte[]{-1, (byte) 0xfe, 0, (byte) (text.length + 2)});
    out.writeBytes(text);
    out.writeBytes(new byte[]{-1, (byte) 0xda, '-', '-', '\n', -1, (byte) 0xd9});
    return out.toByteArray();
  }

  private final class Heard implements PortReader {
    @Override
    public Optional<Bottle> received(PortArrival arrival) {
      heard.add(arrival);
      return Optional.empty();
    }

    @Override
    public void ended(String from, String reason) {
      ended.add(from + ": " + reason);
    }
  }

  private static void serve(Socket socket, byte[]... said) throws IOException {
    byte[] request = MjpegFraming.request("127.0.0.1");
    assertArrayEquals(request, socket.getInputStream().readNBytes(request.length));
    socket.getOutputStream().write(MjpegFraming.answer());
    for (byte[] each : said) {
      socket.getOutputStream().write(each);
    }
  }

  @Test
  void pictures_come_with_their_envelopes_until_the_port_ends() throws Exception {
    try (ServerSocket server = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
      HostPort where = new HostPort("127.0.0.1", server.getLocalPort());
      Workers workers = new Workers(OPTIONS.threads());
      try (MjpegStream stream = new MjpegStream("/cam", where, new Heard(), OPTIONS, workers);
          Socket socket = server.accept()) {
        serve(socket, MjpegFraming.part(picture("7 1.5")), MjpegFraming.part(picture("none")));
        PortArrival first = heard.poll(30, TimeUnit.SECONDS);
        assertEquals(Optional.of(new YarpStamp(7, 1.5)), first.stamp());
        assertArrayEquals(picture("7 1.5"), ((YarpValue.Blob) first.bottle().get(0)).bytes());
        assertEquals(Optional.empty(), heard.poll(30, TimeUnit.SECONDS).stamp());
        socket.close();
        assertTrue(ended.poll(30, TimeUnit.SECONDS).startsWith("/cam: "));
        assertTrue(stream.over());
      }
    }
  }

  @Test
  void what_is_no_picture_ends_the_connection_with_a_reason() throws Exception {
    try (ServerSocket server = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
      HostPort where = new HostPort("127.0.0.1", server.getLocalPort());
      Workers workers = new Workers(OPTIONS.threads());
      try (MjpegStream stream = new MjpegStream("/cam", where, new Heard(), OPTIONS, workers);
          Socket socket = server.accept()) {
        serve(socket,
            "Content-Type: image/jpeg\r\nContent-Length: 99999999\r\n\r\n".getBytes(StandardCharsets.US_ASCII));
        assertTrue(ended.poll(30, TimeUnit.SECONDS).contains("a picture of '99999999' bytes"));
      }
    }
  }

  @Test
  void a_port_without_pictures_is_told() {
    byte[] said = "HTTP/1.0 404 no\r\n\r\n".getBytes(StandardCharsets.US_ASCII);
    IOException thrown =
        assertThrows(YarpFormatException.class, () -> MjpegFraming.readAnswer(new ByteArrayInputStream(said)));
    assertTrue(thrown.getMessage().contains("404"), thrown.getMessage());
  }

  @Test
  void damaged_parts_are_refused_or_read() {
    ByteMutator mutator = new ByteMutator(2028 + Effort.seed());
    byte[] part = MjpegFraming.part(picture("7 1.5"));
    int refused = 0;
    for (Effort effort = Effort.of(ROUNDS, LONG); effort.goesOn();) {
      ByteArrayInputStream in = new ByteArrayInputStream(mutator.mutate(part));
      try {
        MjpegFraming.stamp(MjpegFraming.readPart(MjpegFraming.awaitPart(in), in));
      } catch (IOException e) {
        refused++;
      }
      MjpegFraming.stamp(mutator.mutate(picture("7 1.5")));
    }
    assertTrue(refused > 0, "some damages matter");
  }
}
