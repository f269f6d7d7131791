package org.robotui.xbot.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.function.LongConsumer;
import org.junit.jupiter.api.Test;
import org.robotui.xbot.StateFrame;

/** What reading the states of a robot of 40 joints costs of the heap, and what of the frame before is used again. */
class StateReaderTest {
  private static final int JOINTS = 40;
  private static final int READINGS = 2000;
  /** A record of the frame, the optional around it, an array of what the joints are: measured are 363. */
  private static final long MOST_AT_REST = 1000;
  /** For each joint a record of 112 bytes, one of its reference of 56, and its place in a list: measured are 7280. */
  private static final long MOST_MOVING = 1000 + JOINTS * (112 + 56 + 32);

  private final Layout layout = Layout.shipped();
  private final StateReader reader = new StateReader(layout);
  private final FrameCopy copy = reader.newCopy();
  private final Layout.Field frames = layout.struct("StateSegment").fields().get("frames");
  private final Layout.Field joints = layout.struct("FrameData").fields().get("joints");
  private final int data = layout.offset("StateFrame", "data");
  private final ByteBuffer segment = ByteBuffer.allocateDirect(layout.size("StateSegment"))
      .order(ByteOrder.LITTLE_ENDIAN)
      .putInt(layout.offset("StateSegment", "joints"), JOINTS);
  private final Memory memory = new Memory(segment);

  private void write(long cycle) {
    segment.putLong(at(cycle) + layout.offset("FrameData", "cycle"), cycle);
    segment.putLong(layout.offset("StateSegment", "newest"), cycle);
  }

  private int at(long cycle) {
    return frames.offset() + (int) (cycle % frames.count()) * frames.size() + data;
  }

  private void move(long cycle, int joint) {
    segment.putDouble(
        at(cycle) + joints.offset() + joint * joints.size() + layout.offset("JointState", "link_position"), cycle);
  }

  private StateFrame read() {
    return reader.read(memory, copy).orElseThrow();
  }

  /** Bytes for each reading, and what must have been read with them. */
  private long allocated(LongConsumer before) {
    ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
    long sum = 0;
    for (long cycle = 1; cycle <= READINGS; cycle++) {
      before.accept(cycle);
      write(cycle);
      long start = threads.getThreadAllocatedBytes(Thread.currentThread().threadId());
      assertEquals(cycle, read().cycle());
      sum += threads.getThreadAllocatedBytes(Thread.currentThread().threadId()) - start;
    }
    return sum / READINGS;
  }

  @Test
  void aRobotAtRestCostsNothingForItsJoints() {
    long bytes = allocated(cycle -> {});
    assertTrue(bytes <= MOST_AT_REST, bytes + " bytes for each reading");
  }

  @Test
  void aRobotThatMovesCostsItsRecordsAlone() {
    long bytes = allocated(cycle -> {
      for (int joint = 0; joint < JOINTS; joint++) {
        move(cycle, joint);
      }
    });
    assertTrue(bytes <= MOST_MOVING, bytes + " bytes for each reading");
  }

  @Test
  void whatChangedIsMadeAnewAndNothingElse() {
    write(1);
    StateFrame first = read();
    move(2, 7);
    write(2);
    StateFrame second = read();
    assertEquals(2, second.joints().get(7).linkPosition());
    assertNotSame(first.joints().get(7), second.joints().get(7));
    assertSame(first.joints().get(8), second.joints().get(8));
    assertEquals(0, first.joints().get(7).linkPosition());
    assertTrue(reader.read(memory, 1, copy).isPresent());
    assertTrue(reader.read(memory, 3, copy).isEmpty());
    assertEquals(second, read());
  }
}
