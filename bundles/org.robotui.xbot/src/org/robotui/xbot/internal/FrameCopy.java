package org.robotui.xbot.internal;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Arrays;
import java.util.List;
import java.util.function.IntFunction;
import org.robotui.xbot.StateFrame;

/**
 * Room for a frame as it lies in memory, which is used again for the next one. It keeps the frame before, too: what did
 * not change since then is not made anew. For one thread at a time.
 */
final class FrameCopy {
  private ByteBuffer now;
  private ByteBuffer before;
  private List<StateFrame.Joint> joints = List.of();

  FrameCopy(int size) {
    this.now = ByteBuffer.allocate(size).order(ByteOrder.LITTLE_ENDIAN);
    this.before = ByteBuffer.allocate(size).order(ByteOrder.LITTLE_ENDIAN);
  }

  /** False where the frame could not be copied: then the one before is kept. */
  boolean take(Memory memory, int sequence, int offset) {
    if (!memory.consistent(sequence, offset, before.array())) {
      return false;
    }
    ByteBuffer newer = before;
    before = now;
    now = newer;
    return true;
  }

  ByteBuffer bytes() {
    return now;
  }

  /** The joints of the frame that was taken last, to be asked for once for each. */
  List<StateFrame.Joint> joints(Layout.Field field, int count, IntFunction<StateFrame.Joint> make) {
    StateFrame.Joint[] all = new StateFrame.Joint[count];
    boolean isNew = count != joints.size();
    for (int i = 0; i < count; i++) {
      int at = field.offset() + i * field.size();
      boolean isKnown = i < joints.size() && isSame(at, at + field.size());
      all[i] = isKnown ? joints.get(i) : make.apply(at);
      isNew |= !isKnown;
    }
    joints = isNew ? List.of(all) : joints;
    return joints;
  }

  private boolean isSame(int from, int to) {
    return Arrays.equals(now.array(), from, to, before.array(), from, to);
  }
}
