package org.robotui.xbot.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.lang.invoke.MethodHandles;
import java.lang.invoke.VarHandle;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.locks.LockSupport;
import org.junit.jupiter.api.Test;

class MemoryTest {
  private static final VarHandle LONGS = MethodHandles.byteBufferViewVarHandle(long[].class, ByteOrder.LITTLE_ENDIAN);
  private static final int WORDS = 64;
  private static final int READS = 20_000;
  private static final int PAUSE_EVERY = 64;

  private final ByteBuffer bytes = ByteBuffer.allocateDirect((WORDS + 1) * Long.BYTES).order(ByteOrder.LITTLE_ENDIAN);

  private void write(long sequence, long value) {
    LONGS.setVolatile(bytes, 0, sequence + 1);
    for (int i = 1; i <= WORDS; i++) {
      LONGS.setOpaque(bytes, i * Long.BYTES, value);
    }
    LONGS.setRelease(bytes, 0, sequence + 2);
  }

  @Test
  void noCopyIsOfTwoWritings() throws InterruptedException {
    AtomicBoolean over = new AtomicBoolean();
    Thread writer = Thread.ofPlatform().daemon().start(() -> {
      for (long i = 0; !over.get(); i++) {
        write(2 * i, i);
        if (i % PAUSE_EVERY == 0) {
          LockSupport.parkNanos(1); // a writer that never pauses lets nobody read
        }
      }
    });
    Memory memory = new Memory(bytes);
    int whole = 0;
    for (int read = 0; read < READS; read++) {
      Optional<ByteBuffer> copy = memory.consistent(0, Long.BYTES, WORDS * Long.BYTES);
      if (copy.isPresent()) {
        whole++;
        for (int i = 1; i < WORDS; i++) {
          assertEquals(copy.get().getLong(0), copy.get().getLong(i * Long.BYTES));
        }
      }
    }
    over.set(true);
    writer.join();
    assertTrue(whole > 0);
  }

  @Test
  void textEndsWithItsRoom() {
    byte[] text = {'r', 'o', (byte) 0xc3, (byte) 0xbc};
    assertEquals("roü", Memory.text(ByteBuffer.wrap(text), 0, text.length));
  }
}
