package org.robotui.uic.teleop.internal;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Optional;

/**
 * What a gamepad says: eight bytes of the joystick interface of Linux ({@code struct js_event} in linux/joystick.h).
 *
 * @param initial whether it tells how things stand as the device was opened, not that something was done
 * @param button true for a button, false for an axis
 * @param number of the button or axis, from 0
 * @param value 1 for a button that is down; -32767 to 32767 for an axis, positive to the right and downwards
 */
record PadEvent(boolean initial, boolean button, int number, int value) {
  static final int BYTES = 8;

  private static final int BUTTON = 0x01;
  private static final int AXIS = 0x02;
  private static final int INITIAL = 0x80;

  /** Reads one; none where it is of a kind that we do not know. Advances the bytes by {@link #BYTES}. */
  static Optional<PadEvent> read(ByteBuffer bytes) {
    ByteBuffer native8 = bytes.order(ByteOrder.nativeOrder());
    native8.getInt(); // the time, in milliseconds of the kernel
    int value = native8.getShort();
    int type = native8.get() & 0xff;
    int number = native8.get() & 0xff;
    int kind = type & ~INITIAL;
    return kind == BUTTON || kind == AXIS
        ? Optional.of(new PadEvent((type & INITIAL) != 0, kind == BUTTON, number, value))
        : Optional.empty();
  }
}
