package org.robotui.lcm.internal.tcpq;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.EOFException;
import java.io.IOException;
import java.nio.ByteBuffer;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.robotui.lcm.Mutator;

/**
 * Streams of frames that nobody means: each ends, by its end or by an error that says why, and costs no more than it
 * has bytes.
 */
class HostileFramesTest {

  private static final int ROUNDS = 5000;
  private static final int MOST = 1 << 16;

  private static byte[] stream() throws IOException {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    for (int i = 0; i < 5; i++) {
      out.write(Frames.message("POSE".getBytes(), ByteBuffer.allocate(30)).array());
      out.write(Frames.request(Frames.SUBSCRIBE, "POSE|LASER_.*").array());
      out.write(Frames.request(Frames.UNSUBSCRIBE, "POSE").array());
    }
    return out.toByteArray();
  }

  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3})
  void eachStreamEndsWithAReason(long seed) throws IOException {
    Mutator mutator = new Mutator(seed);
    byte[] good = stream();
    int frames = 0;
    int refused = 0;
    for (int i = 0; i < ROUNDS; i++) {
      DataInputStream in = new DataInputStream(new ByteArrayInputStream(mutator.mutate(good)));
      try {
        while (true) {
          Frames.read(in, MOST);
          frames++;
        }
      } catch (EOFException e) {
        continue;
      } catch (IOException e) {
        assertTrue(e.getMessage() != null && !e.getMessage().isBlank());
        refused++;
      }
    }
    assertTrue(frames > ROUNDS && refused > ROUNDS / 10, frames + " frames, " + refused + " refused");
  }
}
