package org.robotui.recording.internal.codec;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;

/**
 * Frames of LZ4 in which blocks stand alone (those of ROS) or refer to what came before them (those of MCAP's library
 * for Python, which LZ4 for Java refuses).
 */
final class Lz4Frames {

  private static final int MAGIC = 0x184D2204;
  private static final int SKIPPABLE = 0x184D2A50;
  private static final int UNCOMPRESSED = 0x8000_0000;

  private static final int INDEPENDENT = 0x20;
  private static final int BLOCK_SUM = 0x10;
  private static final int SIZE = 0x08;
  private static final int CONTENT_SUM = 0x04;
  private static final int DICTIONARY = 0x01;

  private final Lz4Library library = Lz4Library.load();

  void decode(byte[] bytes, int from, int to, GrowingBytes out) throws IOException {
    ByteBuffer in = ByteBuffer.wrap(bytes, from, to - from).order(ByteOrder.LITTLE_ENDIAN);
    while (in.hasRemaining()) {
      int magic = need(in, Integer.BYTES).getInt();
      if ((magic & ~0xf) == SKIPPABLE) {
        skip(in, need(in, Integer.BYTES).getInt());
      } else if (magic == MAGIC) {
        frame(in, out);
      } else {
        throw new IOException("a frame begins with 0x" + Integer.toHexString(magic));
      }
    }
  }

  private void frame(ByteBuffer in, GrowingBytes out) throws IOException {
    int start = in.position();
    int flags = need(in, 2).get();
    int blockSize = largestBlock(in.get());
    if ((flags & 0xc0) != 0x40) {
      throw new IOException("the frame has version " + ((flags & 0xc0) >> 6));
    }
    if ((flags & DICTIONARY) != 0) {
      throw new IOException("the frame needs a dictionary");
    }
    skip(in, (flags & SIZE) == 0 ? 0 : Long.BYTES);
    int sum = sum(in.array(), start, in.position() - start) >>> 8 & 0xff;
    if ((need(in, 1).get() & 0xff) != sum) {
      throw new IOException("the checksum of the frame's header is wrong");
    }
    int begin = out.length();
    while (block(in, flags, blockSize, begin, out)) {
      // each one is written behind the last
    }
    if ((flags & CONTENT_SUM) != 0) {
      check(in, sum(out.array(), begin, out.length() - begin), "the frame");
    }
  }

  private static int largestBlock(byte descriptor) throws IOException {
    int code = descriptor >> 4 & 7;
    if (code < 4) {
      throw new IOException("the frame has blocks of the unknown size " + code);
    }
    return 1 << 2 * code + 8;
  }

  /** Returns false after the last block. */
  private boolean block(ByteBuffer in, int flags, int blockSize, int begin, GrowingBytes out) throws IOException {
    int word = need(in, Integer.BYTES).getInt();
    if (word == 0) {
      return false;
    }
    int size = word & ~UNCOMPRESSED;
    if (size > in.remaining()) {
      throw new IOException("a block has " + size + " bytes where " + in.remaining() + " are left");
    }
    int from = in.position();
    in.position(from + size);
    int written = (word & UNCOMPRESSED) != 0 ? copy(in.array(), from, size, out)
        : decompress(in.array(), from, size, flags, blockSize, begin, out);
    out.written(written);
    if ((flags & BLOCK_SUM) != 0) {
      check(in, sum(in.array(), from, size), "a block");
    }
    return true;
  }

  private static int copy(byte[] in, int from, int size, GrowingBytes out) throws IOException {
    if (out.room(size) < size) {
      throw new IOException("more comes out than should");
    }
    System.arraycopy(in, from, out.array(), out.length(), size);
    return size;
  }

  private int decompress(byte[] in, int from, int size, int flags, int blockSize, int begin, GrowingBytes out)
      throws IOException {
    // a byte of LZ4 never gives more than 255
    int room = out.room((int) Math.min(blockSize, 255L * size));
    return (flags & INDEPENDENT) != 0
        ? library.decompressor().decompress(in, from, size, out.array(), out.length(), room)
        : Lz4Blocks.decompress(in, from, from + size, out.array(), begin, out.length(), out.length() + room)
            - out.length();
  }

  private int sum(byte[] bytes, int from, int length) {
    return library.sums().hash(bytes, from, length, 0);
  }

  private static void check(ByteBuffer in, int sum, String what) throws IOException {
    if (need(in, Integer.BYTES).getInt() != sum) {
      throw new IOException("the checksum of " + what + " is wrong");
    }
  }

  private static void skip(ByteBuffer in, int length) throws IOException {
    need(in, length).position(in.position() + length);
  }

  private static ByteBuffer need(ByteBuffer in, int length) throws IOException {
    if (length < 0 || length > in.remaining()) {
      throw new IOException("it ends early");
    }
    return in;
  }
}
