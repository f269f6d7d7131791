package org.robotui.guard.internal.process;

import java.io.DataInputStream;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import org.robotui.guard.internal.wire.Wire;

/**
 * Reads what the guarded process says. What is no order is treated as its end: a process that talks nonsense is not
 * trusted with connections.
 */
final class Orders {

  /** Who obeys; called on the thread that reads. */
  interface Taker {
    void beat();

    void keep(int id, InetSocketAddress to, byte[] words);

    void withdraw(int id);

    /** Nothing more comes. */
    void end(boolean goodbye);
  }

  private final DataInputStream in;

  Orders(DataInputStream in) {
    this.in = in;
  }

  void follow(Taker taker) {
    boolean goodbye = false;
    try {
      while (!goodbye) {
        int order = in.readUnsignedByte();
        switch (order) {
          case Wire.BEAT -> taker.beat();
          case Wire.KEEP -> taker.keep(in.readInt(), address(in), words());
          case Wire.WITHDRAW -> taker.withdraw(in.readInt());
          case Wire.GOODBYE -> goodbye = true;
          default -> throw new IOException("order " + order);
        }
      }
    } catch (IOException e) {
      goodbye = false; // it was killed, or talks nonsense
    } finally {
      taker.end(goodbye);
    }
  }

  private byte[] words() throws IOException {
    int length = in.readInt();
    if (length < 0 || length > Wire.MOST_WORDS) {
      throw new IOException(length + " bytes of words");
    }
    byte[] words = new byte[length];
    in.readFully(words);
    return words;
  }

  private static InetSocketAddress address(DataInputStream in) throws IOException {
    byte[] address = new byte[length(in.readUnsignedByte())];
    in.readFully(address);
    return new InetSocketAddress(InetAddress.getByAddress(address), in.readUnsignedShort());
  }

  /** The length of an address of the internet, of the old kind or the new one. */
  static int length(int written) throws IOException {
    if (written != 4 && written != 16) {
      throw new IOException("an address of " + written + " bytes");
    }
    return written;
  }
}
