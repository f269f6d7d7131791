package org.robotui.net.socket;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.net.SocketTimeoutException;
import java.time.Duration;
import java.util.concurrent.locks.LockSupport;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

@Timeout(60)
class DeadlineInputTest {

  private static final Duration SHORT = Duration.ofMillis(200);
  private static final Duration LONG = Duration.ofSeconds(50);

  private Socket peer;
  private Socket socket;

  @BeforeEach
  void connect() throws IOException {
    try (ServerSocket server = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
      peer = new Socket(server.getInetAddress(), server.getLocalPort());
      socket = server.accept();
    }
  }

  @AfterEach
  void close() throws IOException {
    peer.close();
    socket.close();
  }

  private void send(int... bytes) throws IOException {
    for (int each : bytes) {
      peer.getOutputStream().write(each);
    }
  }

  @ParameterizedTest
  @ValueSource(ints = {0, 3, 1 << 16})
  void bytesComeInOrderWhateverTheBuffer(int buffer) throws IOException {
    DeadlineInput in = new DeadlineInput(socket, buffer);
    send(1, 2, 3, 4, 5, 0xff, 7);
    in.within(LONG);
    assertEquals(1, in.read());
    assertArrayEquals(new byte[]{2, 3, 4, 5}, in.readNBytes(4));
    assertEquals(0xff, in.read());
    peer.shutdownOutput();
    assertArrayEquals(new byte[]{7}, in.readAllBytes());
    assertEquals(-1, in.read());
  }

  @ParameterizedTest
  @ValueSource(ints = {0, 16})
  void whoAsksForSoManyBytesWaitsForNoMore(int buffer) throws IOException {
    DeadlineInput in = new DeadlineInput(socket, buffer);
    send(1, 2);
    in.within(LONG);
    assertArrayEquals(new byte[]{1, 2}, in.readNBytes(2));
    assertEquals(0, in.read(new byte[0], 0, 0));
  }

  @Test
  void bytesThatDripDoNotProlongTheTime() throws IOException {
    DeadlineInput in = new DeadlineInput(socket, 0);
    Thread.ofPlatform().daemon().start(this::drip);
    in.within(SHORT);
    String reason = assertThrows(SocketTimeoutException.class, () -> in.readNBytes(1_000)).getMessage();
    assertTrue(reason.contains("in time"), reason);
  }

  private void drip() {
    try {
      for (int i = 0; i < 1_000; i++) {
        send(i);
        LockSupport.parkNanos(SHORT.toNanos() / 4);
      }
    } catch (IOException e) {
      // the test is over
    }
  }

  @ParameterizedTest
  @ValueSource(ints = {0, 1 << 16})
  void theRestOfAMessageHasToComeThoughItsBeginningMayTakeAnyTime(int buffer) throws IOException {
    DeadlineInput in = new DeadlineInput(socket, buffer);
    in.within(Duration.ZERO);
    in.nextMessage(SHORT);
    Thread.ofPlatform().daemon().start(() -> {
      LockSupport.parkNanos(2 * SHORT.toNanos());
      try {
        send(1);
      } catch (IOException e) {
        // the test is over
      }
    });
    assertEquals(1, in.read());
    assertThrows(SocketTimeoutException.class, in::read);
  }

  /** The beginning of the next message was taken from the socket together with the end of the one before. */
  @Test
  void aMessageThatBeganInTheBufferHasToBeCompletedAsWell() throws IOException {
    DeadlineInput in = new DeadlineInput(socket, 16);
    peer.getOutputStream().write(new byte[]{1, 2, 3});
    in.nextMessage(LONG);
    assertArrayEquals(new byte[]{1, 2}, in.readNBytes(2));
    in.nextMessage(SHORT);
    assertEquals(3, in.read());
    assertThrows(SocketTimeoutException.class, in::read);
  }

  @Test
  void theBeginningOfAMessageMayHaveItsOwnTime() throws IOException {
    DeadlineInput in = new DeadlineInput(socket, 16);
    in.nextMessage(SHORT, LONG);
    assertThrows(SocketTimeoutException.class, in::read);
  }
}
