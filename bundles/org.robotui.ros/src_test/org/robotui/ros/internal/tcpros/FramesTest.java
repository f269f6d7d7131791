package org.robotui.ros.internal.tcpros;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.concurrent.atomic.LongAdder;
import org.junit.jupiter.api.Test;
import org.robotui.message.MessageWriter;

class FramesTest {

  /** Gives bytes in pieces of random sizes, as a network does. */
  private static InputStream inPieces(byte[] bytes, Random random) {
    return new ByteArrayInputStream(bytes) {
      @Override
      public synchronized int read(byte[] into, int offset, int length) {
        return super.read(into, offset, length == 0 ? 0 : 1 + random.nextInt(length));
      }
    };
  }

  @Test
  void framesOfAllSizesComeThroughInPieces() throws Exception {
    Random random = new Random(4);
    List<byte[]> sent = new ArrayList<>();
    ByteArrayOutputStream wire = new ByteArrayOutputStream();
    FrameWriter out = new FrameWriter(wire);
    for (int size : new int[]{0, 1, 3, 4, 5, 100, 4095, 4096, 16_380, 16_384, 70_000, 3_000_000, 0, 7, 2_000_000, 9}) {
      byte[] frame = new byte[size];
      random.nextBytes(frame);
      sent.add(frame);
      out.write(new MessageWriter(size + 4).i32(size).bytes(frame, 0, size).view());
    }
    out.flush();
    FrameReader in = new FrameReader(inPieces(wire.toByteArray(), random), 4096);
    for (byte[] frame : sent) {
      assertArrayEquals(frame, in.next(5_000_000, "frame"));
    }
    assertEquals("closed by the peer", assertThrows(EOFException.class, () -> in.next(10, "frame")).getMessage());
  }

  @Test
  void aLyingLengthAllocatesLittle() {
    byte[] start = new MessageWriter().i32(1 << 30).toByteArray();
    long before = allocated();
    FrameReader in = new FrameReader(new ByteArrayInputStream(start), 4096);
    assertThrows(IOException.class, () -> in.next(1L << 30, "frame"));
    assertTrue(allocated() - before < 4 << 20, "allocated " + (allocated() - before));
  }

  private static long allocated() {
    com.sun.management.ThreadMXBean bean =
        (com.sun.management.ThreadMXBean) java.lang.management.ManagementFactory.getThreadMXBean();
    return bean.getThreadAllocatedBytes(Thread.currentThread().threadId());
  }

  @Test
  void aFullQueueDropsTheOldestAndCounts() throws Exception {
    LongAdder dropped = new LongAdder();
    OutQueue queue = new OutQueue(3, 1000, dropped);
    for (int i = 0; i < 5; i++) {
      queue.offer(ByteBuffer.wrap(new byte[]{(byte) i}));
    }
    List<ByteBuffer> batch = new ArrayList<>();
    assertTrue(queue.take(batch));
    assertEquals(List.of((byte) 2, (byte) 3, (byte) 4), batch.stream().map(buffer -> buffer.get(0)).toList());
    assertEquals(2, dropped.sum());
  }

  @Test
  void aQueueIsBoundedByBytesButHoldsOneLargeMessage() throws Exception {
    LongAdder dropped = new LongAdder();
    OutQueue queue = new OutQueue(100, 1000, dropped);
    queue.offer(ByteBuffer.allocate(600));
    queue.offer(ByteBuffer.allocate(600));
    queue.offer(ByteBuffer.allocate(5000));
    List<ByteBuffer> batch = new ArrayList<>();
    queue.take(batch);
    assertEquals(List.of(5000), batch.stream().map(ByteBuffer::remaining).toList());
    assertEquals(2, dropped.sum());
  }
}
