package org.robotui.lcm.internal.udpm;

import java.nio.ByteBuffer;

/**
 * The header of a fragment.
 *
 * @param sequence the number of the message
 * @param size the bytes of the whole message, without its channel
 * @param offset where this fragment's bytes belong
 * @param number from 0
 * @param count how many there are
 */
record Fragment(int sequence, int size, int offset, int number, int count) {

  /** Reads the header and leaves the datagram after it. */
  static Fragment read(ByteBuffer datagram) throws DatagramException {
    if (datagram.remaining() < Wire.FRAGMENT_HEADER) {
      throw new DatagramException("a fragment of " + datagram.remaining() + " bytes");
    }
    datagram.getInt();
    Fragment fragment = new Fragment(datagram.getInt(), datagram.getInt(), datagram.getInt(),
        Short.toUnsignedInt(datagram.getShort()), Short.toUnsignedInt(datagram.getShort()));
    if (fragment.size < 0 || fragment.offset < 0 || fragment.offset > fragment.size
        || fragment.number >= fragment.count) {
      throw new DatagramException("fragment " + fragment.number + " of " + fragment.count + " at byte "
          + Integer.toUnsignedString(fragment.offset) + " of " + Integer.toUnsignedString(fragment.size));
    }
    return fragment;
  }
}
