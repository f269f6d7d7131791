package org.robotui.recorder.internal.file;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.ByteBuffer;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.robotui.recorder.internal.capture.Captured;
import org.robotui.recorder.internal.capture.StreamHead;
import org.robotui.recording.RecordedSchema;

class ByteQueueTest {
  private final StreamHead head = new StreamHead("", "/scan", "cdr", RecordedSchema.NONE, Map.of());
  private final ByteQueue queue = new ByteQueue(10_000);

  private Captured message(int bytes) {
    return new Captured(head, 0, 0, 0, ByteBuffer.allocate(bytes), Optional.empty());
  }

  @Test
  void whatIsTooMuchIsRefusedUntilThereIsRoom() throws Exception {
    assertTrue(queue.offer(message(6000)));
    assertFalse(queue.offer(message(6000)));
    assertTrue(queue.offer(message(1000)));

    queue.poll(1000);

    assertTrue(queue.offer(message(6000)));
  }

  @Test
  void aLargeMessageHasRoomAlone() {
    assertTrue(queue.offer(message(1 << 20)));
    assertFalse(queue.offer(message(1)));
  }

  @Test
  void whatWaitsAtTheEndIsStillGiven() throws Exception {
    queue.offer(message(1));
    queue.end();

    assertFalse(queue.isOver());
    assertFalse(queue.offer(message(1)));
    assertTrue(queue.poll(1000).isPresent());
    assertEquals(Optional.empty(), queue.poll(1000));
    assertTrue(queue.isOver());
  }
}
