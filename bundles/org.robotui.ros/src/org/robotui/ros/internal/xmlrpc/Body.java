package org.robotui.ros.internal.xmlrpc;

import java.io.IOException;
import java.io.InputStream;
import java.util.Arrays;

/** Reads the body of an HTTP message: memory grows with what arrives, not with what was announced. */
final class Body {

  private static final int FIRST_CHUNK = BodyBudget.FREE;

  /** Is asked before more memory is taken. */
  interface Growth {

    void grow(int bytes) throws IOException;
  }

  private Body() {}

  /** Reads exactly so many bytes. */
  static byte[] read(InputStream in, int length, Growth growth) throws IOException {
    byte[] out = new byte[Math.min(length, FIRST_CHUNK)];
    int have = 0;
    while (have < length) {
      if (have == out.length) {
        int larger = (int) Math.min(length, out.length * 2L);
        growth.grow(larger);
        out = Arrays.copyOf(out, larger);
      }
      int count = in.read(out, have, out.length - have);
      if (count < 0) {
        throw new XmlRpcException("HTTP body cut off");
      }
      have += count;
    }
    return out;
  }
}
