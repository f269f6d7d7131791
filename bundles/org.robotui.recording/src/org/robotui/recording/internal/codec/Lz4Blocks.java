package org.robotui.recording.internal.codec;

import java.io.IOException;

/** Decompresses a block of LZ4 that refers to what came before it, which LZ4 for Java has no call for. */
final class Lz4Blocks {

  private static final int SHORTEST_MATCH = 4;
  private static final int LONG = 15;

  private final byte[] in;
  private final int to;
  private final byte[] out;
  private final int begin;
  private final int limit;
  private int read;
  private int write;

  private Lz4Blocks(byte[] in, int from, int to, byte[] out, int begin, int at, int limit) {
    this.in = in;
    this.to = to;
    this.out = out;
    this.begin = begin;
    this.limit = limit;
    read = from;
    write = at;
  }

  /**
   * Decompresses a block behind what is there already.
   *
   * @param begin from where on the output may be referred to
   * @param at where the block's output begins
   * @param limit where it must end at the latest
   * @return where it ends
   */
  static int decompress(byte[] in, int from, int to, byte[] out, int begin, int at, int limit) throws IOException {
    return new Lz4Blocks(in, from, to, out, begin, at, limit).run();
  }

  /** The last sequence of a block has literals alone. */
  private int run() throws IOException {
    int token = next();
    literals(length(token >>> 4 & LONG));
    while (read < to) {
      match(next() | next() << 8, length(token & LONG) + SHORTEST_MATCH);
      token = next();
      literals(length(token >>> 4 & LONG));
    }
    return write;
  }

  /** A length that does not fit into its four bits goes on in the next bytes. */
  private int length(int bits) throws IOException {
    int length = bits;
    if (bits == LONG) {
      int more = next();
      while (more == 255 && length < limit) {
        length += more;
        more = next();
      }
      length += more;
    }
    return length;
  }

  private void literals(int length) throws IOException {
    if (length > to - read || length > limit - write) {
      throw new IOException("a block has literals beyond its end");
    }
    System.arraycopy(in, read, out, write, length);
    read += length;
    write += length;
  }

  /** What is nearer than it is long repeats itself: each copy makes more that can be copied next. */
  private void match(int distance, int length) throws IOException {
    if (distance == 0 || distance > write - begin || length > limit - write) {
      throw new IOException("a block refers to what is not there");
    }
    int source = write - distance;
    int end = write + length;
    while (write < end) {
      int part = Math.min(write - source, end - write);
      System.arraycopy(out, source, out, write, part);
      write += part;
    }
  }

  private int next() throws IOException {
    if (read >= to) {
      throw new IOException("a block ends early");
    }
    return in[read++] & 0xff;
  }
}
